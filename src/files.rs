//! How files are read, locked and written; the content of a file is not judged here.
//!
//! **Reading** takes only regular files, and none larger than its kind may be. A pipe or a device may never end, and a file of gigabytes
//! would fill the memory before anyone could say what is wrong with it. Here are the sizes; each leaves room for a hundred times what the
//! kind is known to need. [`Lock`] keeps two programs from changing one file at once. **Writing** makes a file or a folder whole or not
//! at all: [`replace`], [`create`], [`create_folder`], and [`Replacement`] for content that is written piece by piece.

mod lock;
mod read;
mod rows;
mod staged;

pub use lock::{Lock, PATIENCE, pauses, share};
pub use read::{Links, is_passed_on, open, read, read_text, read_with};
pub use rows::{CsvFile, CsvRow, RowFault, csv_text};
pub use staged::{Replacement, around, behind_links, copy, create, create_folder, put, replace, sync_folder, target};

/// One CSV file of a level: some 8000 objects or 20 000 solids. Whether each object is clear of each solid is looked at for all pairs:
/// with files four times as large that would take seconds.
pub const LEVEL_TABLE: u64 = 256 << 10;
/// One picture, packed; how far it may unfold is said where it is unpacked.
pub const PICTURE: u64 = 16 << 20;
/// One leaderboard: some 20 000 users. A larger one would be read and sorted for longer than a frame lasts.
pub const SCORES: u64 = 512 << 10;
/// The settings: some hundred players.
pub const SETTINGS: u64 = 64 << 10;
/// One file of charts, or the other engines' results.
pub const CHART: u64 = 128 << 10;
/// Recorded or written inputs: a flight of 3 hours with other keys at every tick.
pub const INPUTS: u64 = 16 << 20;
/// The map of a tile run.
pub const TILE_MAP: u64 = 1 << 20;
/// The commands of a tile run: some 100 000.
pub const TILE_COMMANDS: u64 = 1 << 20;
