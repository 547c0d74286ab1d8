//! A level as one file to hand on: a `.zip` with its folder, pictures and flights. [`gather`] and [`write()`] make one. [`read()`]
//! takes one from a stranger: its paths stay in the folder on every system, its files are of a level's kinds and small enough.
//! [`install`] writes it whole or not at all, over nothing.

mod archive;
mod cost;
mod flights;
mod install;
mod package;
mod path;

pub use archive::{read, write};
pub use flights::stale;
pub use install::{Installed, install, install_file};
pub use package::{LARGEST, MEMORY, MOST_FILES, Package, UNPACKED, check, gather};
