//! Files, whatever their content and home: [`Storage`] stands before a disk and a browser's storage; shipped levels lie beneath either. Only regular
//! files up to their kind's size are read, a hundred times the known need: a pipe may never end, gigabytes would fill the memory. A file or folder is
//! written whole or not at all; [`update`] is the one way to change a file that other programs may change, under a [`Lock`].

mod cells;
mod dialect;
mod home;
#[cfg(any(browser, test))]
mod kept;
mod read;
mod rows;
mod save;
mod shipped;
mod staged;
#[allow(clippy::disallowed_methods)] // a lock is waited for
mod storage;

pub use crate::built_in::SHIPPED;
pub use cells::{Cell, CellFault, CsvRows, SpannedRow, csv_line, rows as csv_rows};
pub use dialect::{Dialect, Encoding, separators, truth, whole};
pub use home::{
    copy, create, create_folder, create_numbered, is_file, is_folder, is_link, is_read_only, is_taken, look, make_folder,
    make_shared_folder, names, put, read, read_if_there, read_text, read_with, remove, rename, replace, replace_with, resolve,
    text, text_if_there, text_names,
};
#[cfg(test)]
pub use kept::MemoryStorage;
#[cfg(any(browser, test))]
pub use kept::{Keeper, KeepingFault, PageFiles};
pub use read::Symlinks;
#[cfg(browser)]
pub use read::too_large;
pub use rows::{BadCell, CsvColumn, CsvFile, CsvRow, CsvStruct, found_instead, place};
pub use save::{SaveError, update, write};
pub use shipped::{AboveShipped, EXPERIMENTS, ship_at, ship_lessons_at};
pub use staged::{Replacement, around, behind_links, sync_folder};
pub use storage::{Disk, FileKind, Found, Lock, Manner, PATIENCE, Storage, share};

/// Some 8000 objects or 20 000 solids. Each object is compared with each solid: files four times as large would take seconds.
pub const LEVEL_TABLE: u64 = 256 << 10;
/// Packed. The unpacked size has a limit of its own.
pub const PICTURE: u64 = 16 << 20;
/// Some 20 000 users. Reading and sorting more takes longer than a frame.
pub const SCORES: u64 = 512 << 10;
/// Some hundred players.
pub const SETTINGS: u64 = 64 << 10;
/// Also of the peers' results.
pub const CHART: u64 = 256 << 10;
/// A flight of 3 hours with other keys at every tick.
pub const INPUTS: u64 = 16 << 20;
pub const TILE_MAP: u64 = 1 << 20;
/// Some 100 000.
pub const TILE_COMMANDS: u64 = 1 << 20;
