//! A level as it is edited: its CSV files, byte for byte, and operations on their rows that can be undone without end. All but what an operation
//! changes stays as its author wrote it: comments, blank lines, the order of rows and columns, line ends, the forms of numbers.
//!
//! `sheet` is one file and its edits, `change` the changes of an operation; `model` is the document, `edits` are the
//! operations, `wires` those on switches and names, `history` undoes; `places` are rectangles and texts. `disk` opens and saves, `kept` is
//! the file of unsaved edits, `desk` tells the editors of one level apart. The loader alone finds what is wrong with a document: it
//! reads it from memory ([`Document::over`]).

mod change;
mod desk;
mod disk;
mod edits;
mod history;
mod kept;
mod model;
mod places;
mod sheet;
mod wires;

pub use super::schema::{Column, Kind, SETTINGS, Table};
pub use disk::{KeptSide, LevelFolder, Opened, SaveError};
pub use kept::Kept;
pub use model::{Document, NewRow, RowId, SetCell};
pub use places::{Place, number, way_text};
pub use wires::Wiring;
