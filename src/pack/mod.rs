//! A level as one file to hand on, a `.zip`: [`gather`] and [`write()`] make one. [`read()`] takes one from a stranger: its paths stay in the folder
//! on every system, its files are of a level's kinds and small enough. [`install`] writes it whole or not at all, over nothing.

mod archive;
#[cfg(any(browser, test))]
mod everything;
mod install;
mod package;
mod path;

pub use archive::{read, write};
#[cfg(any(browser, test))]
pub use everything::{export, import, is_export};
pub use install::{Installed, install, install_file};
pub use package::{LARGEST, MEMORY, MOST_FILES, PROVE, Package, UNPACKED, check, gather, load, of_hash, prove, prove_in, proven};
