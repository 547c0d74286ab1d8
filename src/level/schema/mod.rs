//! One schema of a level. `facts` are the types of the tables, `typed` the columns with the types of their values and the cells of a row, `values`
//! what a cell may hold beside numbers and words. `settings`, `bodies`, `blocks` and `zones` hold the tables, their rows and the things that the
//! rows become; `kinds` lists them. `written` makes the rows of a new level and the tables of the documentation.

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
