//! `facts`: the types of tables; `typed`: columns, cells of a row; `values`: cells beside numbers and words; `settings`, `bodies`, `blocks`, `zones`:
//! the tables, their rows, and the things of these; `kinds` lists them; `written`: the rows of a new level and the tables of the documentation.

pub(super) mod blocks;
pub(super) mod bodies;
mod facts;
mod kinds;
pub(super) mod settings;
pub(super) mod typed;
pub(super) mod values;
mod written;
pub(super) mod zones;

pub(super) use facts::Holds;
pub use facts::{Column, Count, FileSchema, RowSchema};
pub use kinds::{FILES, Kind, Table};
pub use settings::SETTINGS;
pub(super) use typed::Word;
pub use written::{documentation, sample};
