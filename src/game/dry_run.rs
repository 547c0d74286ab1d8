//! What becomes of a level in which nobody presses a key.

use super::attempt::Game;
use super::clock::TICK_RATE;
use super::controls::Controls;
use super::event::{GameError, Outcome};
use super::ship::SHIP;
use crate::level::Level;
use std::sync::Arc;

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
