//! A level as one file that can be handed on: a `.zip` with its folder, its pictures and its flights. [`gather`] and [`write()`] make one;
//! [`read()`] takes one that came from anywhere, and believes nothing of it: what is accepted stays in its folder on every system, is of a
//! level's kinds of files, small enough, and loads. [`install`] then writes it, as a whole or not at all, and over nothing that is there.
//! [`crate::level`] says what a level's files mean.

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
