//! A flight that the same controls fly again in another level: an experiment that changes one thing. A long one takes several
//! frames.
//!
//! What becomes of a level in which nobody presses a key.

use super::attempt::Game;
use super::clock::{Controls, TICK_RATE};
use super::event::{GameError, Outcome};
use super::history::{History, Tape, lasts};
use super::inputs::Playback;
use super::ship::SHIP;
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

/// s; less for many bodies, so that a large level takes no longer.
const LONGEST: f64 = 60.0;
/// Ticks of a body.
const MOST_WORK: f64 = 1e6;
/// How long each key is held after that, s.
const HELD: f64 = 5.0;
/// m.
const MOVED: f64 = 1e-3;

#[derive(Clone, Debug, PartialEq)]
pub enum DryRun {
    /// The level waits for its pilot.
    Waits,
    /// After that time, s.
    Won(f64),
    /// After that time, s, and by what.
    Lost(f64, String),
    /// After a minute no key moves the ship.
    Stuck,
}

impl DryRun {
    /// Errors: as [`Game::new`].
    pub fn of(level: &Arc<Level>) -> Result<Self, GameError> {
        let mut game = Game::new(level.clone())?;
        if !level.ship_plays() {
            return Ok(Self::Waits);
        }
        let longest = LONGEST.min(MOST_WORK / (TICK_RATE * game.world().bodies().len() as f64));
        while game.outcome() == Outcome::Running && game.elapsed() < longest {
            game.step(Controls::default());
        }
        Ok(match game.outcome() {
            Outcome::Completed => Self::Won(game.elapsed()),
            Outcome::Failed => Self::Lost(game.elapsed(), game.killed_by().map_or_else(String::new, |death| death.name(level))),
            // What moves on may set the ship free.
            Outcome::Running if longest < LONGEST || !level.movers.is_empty() || obeys(&game) => Self::Waits,
            Outcome::Running => Self::Stuck,
        })
    }
}

/// Whether some keys lead the ship elsewhere than none.
fn obeys(game: &Game) -> bool {
    let with = |thrust, reverse, left, right| Controls { thrust, reverse, left, right };
    let keys = [
        with(true, false, false, false),
        with(false, true, false, false),
        with(true, false, true, false),
        with(true, false, false, true),
        with(false, true, true, false),
        with(false, true, false, true),
    ];
    let place = |game: &Game| game.world().body(SHIP).position;
    keys.into_iter().any(|keys| {
        let (mut flown, mut idle) = (game.clone(), game.clone());
        (0..(HELD * TICK_RATE) as u32).any(|_| {
            flown.step(keys);
            idle.step(Controls::default());
            (place(&flown) - place(&idle)).length() > MOVED
        })
    })
}
