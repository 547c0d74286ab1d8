//! A flight that is flown again by the same controls in another level: an experiment in which one thing is changed. A long one takes several
//! frames.

use super::attempt::Game;
use super::event::{GameError, Outcome};
use super::history::{History, Tape, lasts};
use super::inputs::Playback;
use crate::level::Level;
use std::sync::Arc;

impl Tape {
    /// Flies them in a level, up to a tick at most. Where the flight's start is not a level's, because it was edited while it was flown, it is
    /// the start that is known, which goes on in that level.
    ///
    /// # Errors
    /// As [`Game::with_tick_rate`] and [`Game::go_on_in`].
    pub fn fly_in(&self, level: Arc<Level>, until: u64) -> Result<Again, GameError> {
        let start = if self.start.ticks() == 0 {
            Game::with_tick_rate(level, self.start.tick_rate())?
        } else {
            let mut start = Game::clone(&self.start);
            start.go_on_in(level)?;
            start
        };
        let (history, begins) = (History::new(&start), start.ticks());
        Ok(Again { game: start, history, controls: self.inputs.clone().into_iter(), lasting: self.lasting.clone(), begins, until })
    }
}

/// The flight, as far as it has been flown again.
#[derive(Clone, Debug)]
pub struct Again {
    game: Game,
    history: History,
    controls: Playback,
    lasting: Vec<(u64, bool)>,
    begins: u64,
    until: u64,
}

impl Again {
    /// Flies at most `ticks` ticks more; whether it has arrived, or has ended before.
    pub fn fly(&mut self, ticks: u64) -> bool {
        for _ in 0..ticks {
            let at = self.game.ticks();
            let more = at < self.until && self.game.outcome() == Outcome::Running;
            let Some(controls) = self.controls.next().filter(|_| more) else { return true };
            self.game.set_lasting_fuel(lasts(&self.lasting, at));
            self.game.step(controls);
            self.history.note(&self.game, controls);
        }
        self.game.ticks() >= self.until || self.game.outcome() != Outcome::Running
    }

    /// How much of it has been flown, 0 … 1.
    pub fn progress(&self) -> f64 {
        let all = self.until.saturating_sub(self.begins).max(1);
        (self.game.ticks() - self.begins) as f64 / all as f64
    }

    /// The game where it is, and how it came there.
    pub fn done(self) -> (Game, History) {
        (self.game, self.history)
    }
}
