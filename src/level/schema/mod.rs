//! One schema of a level: the files, the kinds of their rows and the columns of these, each fact once.
//!
//! `facts` are the types of the tables, `typed` the columns with the types of their values, `record` the cells of a row. The tables themselves
//! stand, with the structs of their rows and what these become, in `settings`, `bodies`, `blocks` and `zones`; `kinds` lists them. `written`
//! makes the rows of a new level and the tables of the documentation of them.

pub(super) mod blocks;
pub(super) mod bodies;
mod facts;
mod kinds;
pub(super) mod record;
pub(super) mod settings;
mod typed;
mod written;
pub(super) mod zones;

pub use facts::{Column, Count, FileSchema, RowSchema};
pub use kinds::{FILES, Kind, Table};
pub use settings::SETTINGS;
pub use written::{documentation, sample};
