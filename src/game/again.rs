//! A flight that the same controls fly again in another level: an experiment that changes one thing. A long one takes several
//! frames.

use super::attempt::Game;
use super::event::{GameError, Outcome};
use super::history::{History, Tape, lasts};
use super::inputs::Playback;
use crate::level::Level;
use std::sync::Arc;

impl Tape {
    /// Flies them in a level, up to a tick at most. A flight that began within an edited level begins again from that state.
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
    /// Flies at most `ticks` ticks more. The answer says whether the flight is over.
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

    /// 0 … 1.
    pub fn progress(&self) -> f64 {
        let all = self.until.saturating_sub(self.begins).max(1);
        (self.game.ticks() - self.begins) as f64 / all as f64
    }

    pub fn done(self) -> (Game, History) {
        (self.game, self.history)
    }
}
