//! A flight that can go back: its inputs, and copies of the game at equal distances, from which any tick is flown again, bit for bit. Beyond the most
//! copies every second one goes and the distance doubles: memory stays bounded. Also a flight flown again in another level, and one without a key.

use super::clock::{Controls, TICK_RATE};
use super::event::{GameError, Outcome};
use super::inputs::{Inputs, Playback};
use super::replay::{Recorder, Replay};
use super::{attempt::Game, ship::SHIP};
use crate::level::Level;
use std::sync::Arc;

/// The first distance of copies, ticks: half a second.
const EVERY: u64 = 60;
/// With fewer copies a seek takes longer. A flight of ten minutes has a copy at least every 480 ticks.
const MOST_COPIES: usize = 256;
/// For a level of very many bodies.
const FEWEST_COPIES: usize = 16;
/// The most bodies of all copies together, some 100 MiB: levels with more than 128 bodies have fewer copies.
const BODIES_IN_COPIES: usize = 32_768;

#[derive(Clone, Debug)]
pub struct History {
    recorder: Recorder,
    /// Whether the fuel lasts, from a tick on: the player may switch that assist in flight.
    lasting: Vec<(u64, bool)>,
    /// The level, from a tick on: the player may vary it in flight.
    levels: Vec<(u64, Arc<Level>)>,
    /// The game after 0, `every`, 2 `every` … ticks.
    copies: Vec<Game>,
    every: u64,
    most: usize,
}

#[derive(Clone, Debug)]
pub struct Tape {
    pub(super) start: Box<Game>,
    pub(super) inputs: Inputs,
    pub(super) lasting: Vec<(u64, bool)>,
}

impl History {
    pub fn new(start: &Game) -> Self {
        let most = (BODIES_IN_COPIES / start.world().bodies().len().max(1)).clamp(FEWEST_COPIES, MOST_COPIES);
        let lasting = vec![(start.ticks(), start.ship().fuel_lasts)];
        let levels = vec![(start.ticks(), start.shared_level().clone())];
        Self { recorder: Recorder::default(), lasting, levels, copies: vec![start.clone()], every: EVERY, most }
    }

    /// Lets the game, which stands at this history's end, go on in a level that differs in numbers alone.
    /// Errors: as [`Game::go_on_in`]; nothing has changed then.
    pub fn go_on_in(&mut self, game: &mut Game, level: Arc<Level>) -> Result<(), GameError> {
        game.go_on_in(level.clone())?;
        self.levels.retain(|(since, _)| *since < game.ticks());
        self.levels.push((game.ticks(), level));
        Ok(())
    }

    pub fn tape(&self) -> Tape {
        Tape { start: Box::new(self.copies[0].clone()), inputs: self.inputs().clone(), lasting: self.lasting.clone() }
    }

    /// Takes up the tick just made with these controls.
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

    pub fn start(&self) -> &Game {
        &self.copies[0]
    }

    /// The first tick: above 0 where the player edited the level in flight.
    fn begins(&self) -> u64 {
        self.copies[0].ticks()
    }

    pub fn ticks(&self) -> u64 {
        self.begins() + self.recorder.inputs().ticks()
    }

    pub const fn inputs(&self) -> &Inputs {
        self.recorder.inputs()
    }

    /// The number of copies, and their distance in ticks.
    pub fn copies(&self) -> (usize, u64) {
        (self.copies.len(), self.every)
    }

    /// `end` is the game after the last tick.
    pub fn record(&self, end: &Game) -> Replay {
        self.recorder.clone().finish(end)
    }

    /// Brings a game of this flight to its state after `tick` ticks, or after the last tick where there are fewer.
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

    #[must_use]
    pub fn until(&self, tick: u64) -> Self {
        let tick = tick.clamp(self.begins(), self.ticks());
        let (ticks, rate) = (tick - self.begins(), self.start().tick_rate());
        let second = |tick: u64| (tick as f64 / rate) as usize;
        let lasting = self.lasting.iter().enumerate().filter(|(first, (since, _))| *first == 0 || *since < tick);
        Self {
            recorder: self.recorder.until(ticks, second(tick) - second(self.begins())),
            lasting: lasting.map(|(_, lasting)| *lasting).collect(),
            levels: self.levels.iter().filter(|(since, _)| *since <= tick).cloned().collect(),
            copies: self.copies.iter().take((ticks / self.every) as usize + 1).cloned().collect(),
            ..*self
        }
    }

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

    fn enter_level(&self, game: &mut Game) {
        let level = self.levels.iter().rev().find(|(since, _)| *since <= game.ticks()).map(|(_, level)| level);
        if let Some(level) = level.filter(|level| !Arc::ptr_eq(level, game.shared_level())) {
            // The engine has taken this level before.
            let entered = game.go_on_in(level.clone());
            debug_assert!(entered.is_ok(), "{entered:?}");
        }
    }
}

/// Whether the fuel lasts in the tick after `at`.
pub(super) fn lasts(lasting: &[(u64, bool)], at: u64) -> bool {
    lasting.iter().rev().find(|(since, _)| *since <= at).is_some_and(|(_, lasts)| *lasts)
}

/// A flight that can be watched from any tick on: a flown one, or a record, of which as much is known as has been flown again.
#[derive(Clone, Debug)]
pub struct Reel {
    pub history: History,
    pub unflown: Option<Unflown>,
}

/// The inputs of a record that no history has yet.
#[derive(Clone, Debug)]
pub struct Unflown {
    /// After the history's last tick.
    game: Box<Game>,
    rest: Playback,
}

impl Reel {
    /// The recorded inputs in that level, of which no tick is flown yet.
    pub fn new(level: Arc<Level>, inputs: &Inputs, tick_rate: f64) -> Result<Self, GameError> {
        let start = Game::with_tick_rate(level, tick_rate)?;
        let history = History::new(&start);
        Ok(Self { history, unflown: Some(Unflown { game: Box::new(start), rest: inputs.clone().into_iter() }) })
    }

    pub const fn flown(history: History) -> Self {
        Self { history, unflown: None }
    }
}

impl Unflown {
    /// Flies at most `ticks` ticks further, which the history takes up; returns whether inputs may be left.
    pub fn fly(&mut self, history: &mut History, ticks: u64) -> bool {
        for _ in 0..ticks {
            let Some(controls) = self.rest.next().filter(|_| self.game.outcome() == Outcome::Running) else { return false };
            self.game.step(controls);
            history.note(&self.game, controls);
        }
        true
    }
}

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
