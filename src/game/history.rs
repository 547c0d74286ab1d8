//! A flight with the way back: its inputs, and copies of the game along the way, from which any tick of it is flown again, bit for bit. It
//! serves a recorded flight, which is flown ahead of its viewer, as well as one that is still being flown.
//!
//! Copies are taken at equal distances. Where there are too many of them every second one goes, and the distance doubles: a flight of any
//! length keeps to the same memory, and the way from a copy to the tick asked for grows with its length only.

use super::attempt::Game;
use super::controls::Controls;
use super::event::{GameError, Outcome};
use super::inputs::{Inputs, Playback};
use super::replay::{Recorder, Replay};
use crate::level::Level;
use std::sync::Arc;

/// From copy to copy at first, ticks: half a second.
const EVERY: u64 = 60;
/// The most copies. With fewer, a tick of a long flight is further from the one before it: a flight of ten minutes has a copy at least every
/// 480 ticks.
const MOST_COPIES: usize = 256;
/// The fewest that a level of very many bodies has.
const FEWEST_COPIES: usize = 16;
/// How many bodies all copies have together, some 100 MiB: levels with more than 128 have fewer copies.
const BODIES_IN_COPIES: usize = 32_768;

/// A flight up to now.
#[derive(Clone, Debug)]
pub struct History {
    recorder: Recorder,
    /// Whether the fuel lasted, from a tick on: an assist that is switched while a flight lasts.
    lasting: Vec<(u64, bool)>,
    /// The level that it is flown in, from a tick on: one that is varied on the way.
    levels: Vec<(u64, Arc<Level>)>,
    /// The game after 0, `every`, 2 `every` … ticks.
    copies: Vec<Game>,
    every: u64,
    most: usize,
}

/// The controls of a flight from its start on.
#[derive(Clone, Debug)]
pub struct Tape {
    pub(super) start: Box<Game>,
    pub(super) inputs: Inputs,
    pub(super) lasting: Vec<(u64, bool)>,
}

impl History {
    /// The history of a game from where it is.
    pub fn new(start: &Game) -> Self {
        let most = (BODIES_IN_COPIES / start.world().bodies().len().max(1)).clamp(FEWEST_COPIES, MOST_COPIES);
        let lasting = vec![(start.ticks(), start.ship().fuel_lasts)];
        let levels = vec![(start.ticks(), start.shared_level().clone())];
        Self { recorder: Recorder::default(), lasting, levels, copies: vec![start.clone()], every: EVERY, most }
    }

    /// Lets the game, which is where this history ends, go on in a level that differs from its own in numbers alone.
    ///
    /// # Errors
    /// As [`Game::go_on_in`]; nothing has changed then.
    pub fn go_on_in(&mut self, game: &mut Game, level: Arc<Level>) -> Result<(), GameError> {
        game.go_on_in(level.clone())?;
        self.levels.retain(|(since, _)| *since < game.ticks());
        self.levels.push((game.ticks(), level));
        Ok(())
    }

    /// The controls from the start on, to be flown in another level.
    pub fn tape(&self) -> Tape {
        Tape { start: Box::new(self.copies[0].clone()), inputs: self.inputs().clone(), lasting: self.lasting.clone() }
    }

    /// Takes up the tick that was just made with these controls.
    pub fn note(&mut self, game: &Game, controls: Controls) {
        let lasts = game.ship().fuel_lasts;
        if self.lasting.last().is_none_or(|&(_, lasted)| lasted != lasts) {
            self.lasting.push((game.ticks().saturating_sub(1), lasts));
        }
        self.recorder.note(game, controls);
        if game.ticks() == self.begins() + self.copies.len() as u64 * self.every {
            self.copies.push(game.clone());
            if self.copies.len() > self.most {
                let mut stays = false;
                self.copies.retain(|_| {
                    stays = !stays;
                    stays
                });
                self.every *= 2;
            }
        }
    }

    /// The game as it began.
    pub fn start(&self) -> &Game {
        &self.copies[0]
    }

    /// After how many ticks it begins: not at once where a level was edited while it was flown.
    fn begins(&self) -> u64 {
        self.copies[0].ticks()
    }

    /// Up to which tick it goes.
    pub fn ticks(&self) -> u64 {
        self.begins() + self.recorder.inputs().ticks()
    }

    /// The controls of all ticks.
    pub const fn inputs(&self) -> &Inputs {
        self.recorder.inputs()
    }

    /// How many copies are kept, and how far they are from each other, ticks.
    pub fn copies(&self) -> (usize, u64) {
        (self.copies.len(), self.every)
    }

    /// The record of the flight, whose last tick left that game.
    pub fn record(&self, end: &Game) -> Replay {
        self.recorder.clone().finish(end)
    }

    /// Brings a game of this flight to where it was after `tick` ticks, or to the last tick where there are fewer.
    pub fn seek(&self, game: &mut Game, tick: u64) {
        let tick = tick.clamp(self.begins(), self.ticks());
        let copy = &self.copies[(((tick - self.begins()) / self.every) as usize).min(self.copies.len() - 1)];
        if game.ticks() > tick || game.ticks() < copy.ticks() {
            game.clone_from(copy);
        }
        let from = game.ticks();
        for (at, controls) in (from..tick).zip(self.inputs().after(from - self.begins())) {
            self.step(game, at, controls);
        }
        self.enter_level(game);
    }

    /// The history up to that tick, or all of it where there are fewer: what was flown after it is gone.
    #[must_use]
    pub fn until(&self, tick: u64) -> Self {
        let mut game = self.copies[0].clone();
        let mut history = Self::new(&game);
        history.levels = self.levels.iter().filter(|(since, _)| *since <= tick).cloned().collect();
        for (at, controls) in (self.begins()..tick.min(self.ticks())).zip(self.inputs().after(0)) {
            self.step(&mut game, at, controls);
            history.note(&game, controls);
        }
        history
    }

    /// The game after `tick` ticks, as [`History::seek`].
    pub fn at(&self, tick: u64) -> Game {
        let mut game = self.copies[0].clone();
        self.seek(&mut game, tick);
        game
    }

    fn step(&self, game: &mut Game, at: u64, controls: Controls) {
        self.enter_level(game);
        game.set_lasting_fuel(lasts(&self.lasting, at));
        game.step(controls);
    }

    /// Brings a game into the level that it goes on in from its tick on.
    fn enter_level(&self, game: &mut Game) {
        let level = self.levels.iter().rev().find(|(since, _)| *since <= game.ticks()).map(|(_, level)| level);
        if let Some(level) = level.filter(|level| !Arc::ptr_eq(level, game.shared_level())) {
            // The engine takes again a level that it took once.
            let entered = game.go_on_in(level.clone());
            debug_assert!(entered.is_ok(), "{entered:?}");
        }
    }
}

/// Whether the fuel lasts in the tick after `at`.
pub(super) fn lasts(lasting: &[(u64, bool)], at: u64) -> bool {
    lasting.iter().rev().find(|(since, _)| *since <= at).is_some_and(|(_, lasts)| *lasts)
}

/// A flight that can be watched from any tick on: one that was flown, or a record that is flown again as far as it is known.
#[derive(Clone, Debug)]
pub struct Reel {
    history: History,
    /// The part that is not flown yet.
    ahead: Option<(Box<Game>, Playback)>,
}

impl Reel {
    /// The recorded inputs in that level; nothing of it is flown yet.
    ///
    /// # Errors
    /// As [`Game::with_tick_rate`].
    pub fn new(level: Arc<Level>, inputs: &Inputs, tick_rate: f64) -> Result<Self, GameError> {
        let start = Game::with_tick_rate(level, tick_rate)?;
        Ok(Self { history: History::new(&start), ahead: Some((Box::new(start), inputs.clone().into_iter())) })
    }

    /// A flight that is over.
    pub const fn flown(history: History) -> Self {
        Self { history, ahead: None }
    }

    /// Flies `ticks` ticks further, as far as there are any.
    pub fn fly(&mut self, ticks: u64) {
        for _ in 0..ticks {
            let Some((game, rest)) = &mut self.ahead else { return };
            match rest.next().filter(|_| game.outcome() == Outcome::Running) {
                Some(controls) => {
                    game.step(controls);
                    self.history.note(game, controls);
                }
                None => self.ahead = None,
            }
        }
    }

    /// Whether all of it is known.
    pub const fn is_whole(&self) -> bool {
        self.ahead.is_none()
    }

    /// How many ticks are known.
    pub fn ticks(&self) -> u64 {
        self.history.ticks()
    }

    /// How it went, as far as that is known.
    pub const fn history(&self) -> &History {
        &self.history
    }
}
