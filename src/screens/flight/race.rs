//! Those who fly along: recorded flights as ghosts, and how the ship stands to them at each objective.

use crate::game::{Game, GameError, GameEvent, GhostPose, GhostTrack, Outcome, SHIP};
use crate::view::hud::{self, Aside};
use crate::{draw::Canvas, level::Level, session::library::Rival, words::tr};
use crate::{number::fixed, number::hundredths, view::GhostShip, view::theme};
use std::sync::Arc;

/// The most ghosts at a time: more would hide the level, and each is flown once.
pub const MOST_RIVALS: usize = 5;
/// How far ghosts are flown ahead in a frame, ticks of all together: some ms.
const TICKS_A_FRAME: u64 = 240;
/// Where a frame takes longer than this, s, they are flown ahead by a fourth of that only.
const SLOW_FRAME: f64 = 1.0 / 40.0;

/// A ghost's path farther from the ship than this tells nothing about its lead, m.
const NEAR: f64 = 8.0;

#[derive(Clone, Debug)]
pub struct Ghost {
    pub name: String,
    track: GhostTrack,
    /// The tick of its flight that is nearest to where the ship is.
    beside: u64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Split {
    pub objective: usize,
    /// Ticks on the clock when it was met for the first time.
    pub tick: u64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Gap {
    /// The ship's delay, s; negative where the ship was earlier.
    Seconds(f64),
    Never,
    /// The ghost's flight is not known so far yet.
    Unknown,
}

/// All ghosts of a flight, and what the ship has met.
#[derive(Clone, Debug)]
pub struct Race {
    ghosts: Vec<Ghost>,
    splits: Vec<Split>,
    tick_rate: f64,
}

impl Race {
    /// The race against those, if there are any: against the first [`MOST_RIVALS`].
    /// Errors: as [`Game::new`].
    pub fn new(level: &Arc<Level>, rivals: &[Rival]) -> Result<Option<Self>, GameError> {
        let ghost = |rival: &Rival| {
            let track = GhostTrack::new(level.clone(), &rival.inputs)?;
            Ok(Ghost { name: rival.name.clone(), track, beside: 0 })
        };
        let ghosts = rivals.iter().take(MOST_RIVALS).map(ghost).collect::<Result<Vec<_>, GameError>>()?;
        Ok((!ghosts.is_empty()).then_some(Self { ghosts, splits: Vec::new(), tick_rate: crate::game::TICK_RATE }))
    }

    /// The same race from its start.
    pub fn again(self) -> Self {
        let ghosts = self.ghosts.into_iter().map(|ghost| Ghost { beside: 0, ..ghost }).collect();
        Self { splits: Vec::new(), ghosts, ..self }
    }

    /// Takes up what the ship has met in the tick just made.
    pub fn after_tick(&mut self, game: &Game) {
        for event in game.events() {
            if let GameEvent::ObjectiveMet(objective) = *event
                && self.splits.iter().all(|split| split.objective != objective)
            {
                self.splits.push(Split { objective, tick: game.ticks_on_clock() });
            }
        }
    }

    /// The game has been taken back to an earlier moment.
    pub fn back_to(&mut self, game: &Game) {
        self.splits.retain(|split| split.tick <= game.ticks_on_clock());
        self.ghosts.iter_mut().for_each(|ghost| ghost.beside = ghost.track.beside(game));
    }

    /// Flies the ghosts ahead: at least to where they are beside that game, and further as long as a frame has room for it.
    pub fn update(&mut self, game: &Game, frame_time: f64) {
        let ahead = if frame_time > SLOW_FRAME { TICKS_A_FRAME / 4 } else { TICKS_A_FRAME } / self.ghosts.len() as u64;
        for ghost in &mut self.ghosts {
            let behind = ghost.track.beside(game).saturating_sub(ghost.track.ticks());
            ghost.track.fly(behind + if frame_time > 0.0 { ahead } else { 0 }, |_| ());
            if frame_time > 0.0 {
                ghost.beside =
                    ghost.track.nearest((game.world().previous_position(SHIP), game.world().body(SHIP).position), ghost.beside);
            }
        }
    }

    /// The ghosts, each with where it is drawn beside that game, if its flight is not over yet or has reached its goal.
    pub fn ghosts(&self, game: &Game, alpha: f64) -> impl Iterator<Item = (&Ghost, GhostPose)> {
        self.ghosts.iter().filter_map(move |ghost| {
            let (track, tick) = (&ghost.track, ghost.track.beside(game));
            // One that waits for the game's clock does not move.
            let alpha = if tick < game.ticks() && game.is_idle() { 1.0 } else { alpha };
            let shown = track.ticks() >= tick || track.outcome() != Outcome::Failed;
            shown.then(|| (ghost, track.pose(tick, alpha)))
        })
    }

    pub fn all(&self) -> &[Ghost] {
        &self.ghosts
    }

    pub fn splits(&self) -> &[Split] {
        &self.splits
    }

    /// How the ship stands to a ghost where it is now; `None` where the ghost never came by near enough.
    pub fn lead(&self, ghost: &Ghost, game: &Game) -> Option<Gap> {
        let apart = ghost.track.pose(ghost.beside, 1.0).centre.distance(game.world().body(SHIP).position);
        let behind = (ghost.track.beside(game) as f64 - ghost.beside as f64) / self.tick_rate;
        (apart <= NEAR && !game.is_idle()).then_some(Gap::Seconds(behind))
    }

    /// How the ship stood to a ghost at an objective.
    pub fn gap(&self, ghost: &Ghost, split: Split) -> Gap {
        match ghost.track.met(split.objective) {
            Some(met) => {
                // In the hundredths in which both times are shown.
                let shown = |ticks: u64| hundredths(ticks as f64 / self.tick_rate) as f64;
                Gap::Seconds((shown(split.tick) - shown(met)) / 100.0)
            }
            None if ghost.track.is_whole() => Gap::Never,
            None => Gap::Unknown,
        }
    }

    /// Where the ghosts are drawn.
    pub fn poses(&self, game: &Game, alpha: f64) -> Vec<GhostShip> {
        self.ghosts(game, alpha)
            .map(|(ghost, pose)| GhostShip { name: ghost.name.clone(), pose: Some(pose), objects: Vec::new() })
            .collect()
    }

    /// Draws how the ship stands to each ghost, where it is now or else at the objective that it met last: columns of the strip beside the timer.
    pub fn draw(&self, game: &Game, aside: &Aside, canvas: &Canvas) {
        for (i, ghost) in self.all().iter().enumerate() {
            let Some(column) = aside.column(i, self.all().len()) else { continue };
            let gap = self.lead(ghost, game).or_else(|| self.splits().last().map(|split| self.gap(ghost, *split)));
            let colour = match gap {
                Some(Gap::Seconds(seconds)) if seconds > 0.0 => theme::bad(),
                Some(Gap::Seconds(_) | Gap::Never) => theme::good(),
                Some(Gap::Unknown) | None => theme::quiet(),
            };
            let gap_words = gap.map_or_else(|| "–".to_owned(), Gap::words);
            hud::draw_column(column, (&ghost.name, &gap_words), colour, aside, canvas);
        }
    }
}

impl Gap {
    /// In seconds with a sign; what is earlier than the ghost has a true minus.
    pub fn words(self) -> String {
        match self {
            Self::Seconds(seconds) => {
                let sign = if seconds < 0.0 { "" } else { "+" };
                format!("{sign}{} s", fixed(seconds, 2))
            }
            Self::Never => tr("not met").to_owned(),
            Self::Unknown => "…".to_owned(),
        }
    }
}
