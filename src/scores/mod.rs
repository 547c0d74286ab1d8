//! User names, leaderboards, players' records, and their files. [`Name`] has the rules of a name, [`Board`] the order of rows,
//! [`judge()`] their proof, [`Players`] the levels done. Files are saved by [`crate::files::update`] alone.

pub mod board;
mod folder;
mod judge;
mod name;
mod players;
mod results;

pub use board::{Board, BoardRow, Placement};
pub use folder::{AttemptRow, LoadedBoard, Saved, Score, Scores};
pub use judge::{Doubt, Standing, judge};
pub use name::{NAME_MAX, NAME_TYPING_MAX, Name, NameError, ScoresError, damage_text};
pub(crate) use players::harmless;
pub use players::{Deed, PlayerRecord, Players};
pub use results::{ExperimentTally, LevelTally, ResultRow, Results, Tally, may_be_list, time_of};

use crate::words::tr;

/// The subject of a level's leaderboard in words: the level's title, where it has one.
pub fn subject(level: &str, title: &str) -> String {
    if level == title { tr!("level {level}", level) } else { tr(title).to_owned() }
}

/// A score that is lost with the window.
pub fn unsaved_points(points: i64, subject: &str) -> String {
    tr!("{points} points in {subject}", points, subject)
}
