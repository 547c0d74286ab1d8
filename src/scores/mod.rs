//! User names, leaderboards, the records of the players, and their files.
//!
//! [`Name`] has the rules of a name, [`Board`] the order of its rows, [`RowOrigin`] the flight of a row and [`Judge`] its proof. [`Players`]
//! are the levels that each player has done. [`table`], `players` and `attempts` are the texts of the files, and [`Scores`] is their folder;
//! only `disk` reads, locks and replaces files. [`crate::game`] makes scores, and the screens draw boards.

mod attempts;
mod board;
mod disk;
mod earned;
mod error;
mod folder;
mod judge;
mod name;
mod origin;
mod players;
pub mod table;

pub use crate::files::PATIENCE;
pub use attempts::AttemptRow;
pub use board::{Board, BoardRow, Placement};
pub use disk::Rescue;
pub use earned::{Doubt, Standing};
pub use error::ScoresError;
pub use folder::{LoadedBoard, Saved, Score, Scores};
pub use judge::{IN_TURN, Judge, TURN};
pub use name::{NAME_MAX, NAME_TYPING_MAX, Name, NameError};
pub use origin::RowOrigin;
pub use players::{Deed, Player, Players};
