//! User names, leaderboards, what each player has done, and their files.
//!
//! Here live the rules of a [`Name`], the order of a [`Board`], where its rows come from ([`RowOrigin`]) and whether they are earned ([`Judge`]),
//! what is known of [`Players`], the texts of their files ([`table`], `players`, `attempts`), and [`Scores`], the folder that holds those files. Only `disk` reads, locks and replaces them. How a score comes
//! about is [`crate::game`]'s, how a board looks is the screens'. Nothing here knows a particular level.

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
