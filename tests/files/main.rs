//! Files that players share: leaderboards, players, levels in one file, and how much work a file may cause.

mod fixture;
mod judged_boards;
mod limits;
mod pack;
mod players;
mod scores;
#[path = "../support/mod.rs"]
mod support;
