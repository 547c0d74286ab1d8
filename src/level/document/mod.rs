//! A level as it is edited: its CSV files, byte for byte, and operations on their rows, all of which can be undone. The bytes outside of an
//! operation's cells stay as their author wrote them: comments, blank lines, the order of rows and columns, line ends, the forms of numbers.
//! The loader alone judges a document: it reads it from memory ([`Document::over`]).

mod disk;
mod edits;
mod links;
mod model;
mod places;
mod sheet;

pub use super::schema::{Column, Kind, SETTINGS, Table};
pub use disk::{KeptSide, LevelFolder, LevelSaveError, Opened};
pub use edits::Clip;
pub use links::{LinkForm, Wiring};
pub use model::{Document, Kept, NewRow, RowId, SetCell};
pub use places::{Place, number, way_text};
