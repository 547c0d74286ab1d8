//! The attempt that is flown: its game, its history, and what has become of it.

use super::ending::Lost;
use super::race::Race;
use super::what_if::WhatIf;
use crate::game::{Game, History};
use crate::session::library::Attempt;

#[derive(Debug)]
pub(super) struct Run {
    pub attempt: Attempt,
    /// At the moment on the screen.
    pub game: Game,
    /// All flown ticks, which may go beyond the moment on the screen.
    pub history: History,
    pub race: Option<Race>,
    /// The varied level; its flight does not count.
    pub what_if: Option<Box<WhatIf>>,
    /// Whether the player has had help.
    pub assisted: bool,
    /// Time since the end of the attempt, s.
    pub ended: f64,
    /// What the attempt, which has ended, brought the player, in words.
    pub remark: Option<String>,
    /// The attempt before, while the loss of it is shown.
    pub lost: Option<Box<Lost>>,
    /// Up to this tick the flight is shown in slow motion: a goal has been met.
    pub slow_until: u64,
}

impl Run {
    pub fn new(attempt: Attempt, game: Game) -> Self {
        Self {
            attempt,
            history: History::new(&game),
            game,
            race: None,
            what_if: None,
            assisted: false,
            ended: 0.0,
            remark: None,
            lost: None,
            slow_until: 0,
        }
    }
}
