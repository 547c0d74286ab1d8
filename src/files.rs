//! Reading, locking and writing files, whatever their content. **Reading** takes only regular files up to their kind's size, a
//! hundred times its known need: a pipe may never end, and gigabytes would fill the memory. [`Lock`] keeps two programs from
//! changing one file at once. **Writing** makes a file or folder whole or not at all.

mod lock;
mod read;
mod rows;
mod staged;

pub use lock::{Lock, PATIENCE, pauses, share};
pub use read::{Symlinks, is_passed_on, open, read, read_text, read_with};
pub use rows::{CsvFile, CsvRow, RowFault, csv_text};
pub use staged::{Replacement, around, behind_links, copy, create, create_folder, put, replace, sync_folder, target};

/// Some 8000 objects or 20 000 solids. Each object is compared with each solid: files four times as large would take seconds.
pub const LEVEL_TABLE: u64 = 256 << 10;
/// Packed. The unpacked size has a limit of its own.
pub const PICTURE: u64 = 16 << 20;
/// Some 20 000 users. Reading and sorting more takes longer than a frame.
pub const SCORES: u64 = 512 << 10;
/// Some hundred players.
pub const SETTINGS: u64 = 64 << 10;
/// Also of the peers' results.
pub const CHART: u64 = 128 << 10;
/// A flight of 3 hours with other keys at every tick.
pub const INPUTS: u64 = 16 << 20;
pub const TILE_MAP: u64 = 1 << 20;
/// Some 100 000.
pub const TILE_COMMANDS: u64 = 1 << 20;
