//! User names and leaderboards, and their files.
//!
//! Here live the rules of a [`Name`], the order of a [`Board`], the text of a scores file ([`table`]), and [`Scores`], the folder
//! that holds those files: the one place that reads, locks and replaces them. How a score comes about is [`crate::game`]'s, how a
//! board looks is the screens'. Nothing here knows a particular level.

mod board;
mod error;
mod folder;
mod name;
pub mod table;

pub use board::{Board, Placement, Row};
pub use error::{Damage, ScoresError};
pub use folder::{Loaded, PATIENCE, Rescue, Saved, Scores};
pub use name::{NAME_MAX, NAME_TYPING_MAX, Name, NameError};
