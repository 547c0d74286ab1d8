//! The ghost of a race, whose world is flown ahead of the race and touches nothing; and a record flown again, to compare with its written end.

use super::event::{GameError, GameEvent, Outcome};
use super::inputs::{Inputs, Playback};
use super::replay::{Mismatch, Replay, ended_second, thousandths};
use super::{attempt::Game, fingerprint::level_hash, ship::SHIP};
use crate::{level::Level, physics::DVec2};
use std::sync::Arc;

/// The nearest moment is looked for within these ticks: where a path crosses itself, farther ones are of another leg.
const AROUND: u64 = 180;
/// A difference of velocity counts as the distance of this many ticks of it.
const VELOCITY: f64 = 36.0;

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GhostPose {
    /// m.
    pub centre: DVec2,
    /// Clockwise, degrees.
    pub angle: f64,
}

/// Known as far as it has been flown.
#[derive(Clone, Debug)]
pub struct GhostTrack {
    poses: Vec<GhostPose>,
    /// By objective, ticks on the clock until it is met for the first time.
    met: Vec<Option<u64>>,
    /// Ticks before the clock starts.
    idle: u64,
    outcome: Outcome,
    ahead: Option<(Box<Game>, Playback)>,
}

impl GhostTrack {
    pub fn new(level: Arc<Level>, inputs: &Inputs) -> Result<Self, GameError> {
        let game = Game::new(level)?;
        let met = vec![None; game.met().len()];
        let ahead = Some((Box::new(game.clone()), inputs.clone().into_iter()));
        Ok(Self { poses: vec![pose(&game)], met, idle: inputs.idle().unwrap_or(0), outcome: Outcome::Running, ahead })
    }

    /// Flies at most `ticks` ticks further. `watch` is called after every tick.
    pub fn fly(&mut self, ticks: u64, mut watch: impl FnMut(&Game)) {
        for _ in 0..ticks {
            let Some((game, rest)) = &mut self.ahead else { return };
            let Some(controls) = rest.next().filter(|_| game.outcome() == Outcome::Running) else {
                self.ahead = None;
                return;
            };
            game.step(controls);
            watch(game);
            self.poses.push(pose(game));
            self.outcome = game.outcome();
            for event in game.events() {
                if let GameEvent::ObjectiveMet(index) = event {
                    self.met[*index].get_or_insert(game.ticks_on_clock());
                }
            }
        }
    }

    pub const fn is_whole(&self) -> bool {
        self.ahead.is_none()
    }

    pub fn ticks(&self) -> u64 {
        self.poses.len() as u64 - 1
    }

    pub const fn outcome(&self) -> Outcome {
        self.outcome
    }

    /// The pose between the tick before `tick` (`alpha` 0) and that tick (1); once the flight is over, its last pose.
    pub fn pose(&self, tick: u64, alpha: f64) -> GhostPose {
        let at = |tick: u64| self.poses[(tick as usize).min(self.poses.len() - 1)];
        let (from, to) = (at(tick.saturating_sub(1)), at(tick));
        let turn = (to.angle - from.angle + 180.0).rem_euclid(360.0) - 180.0;
        GhostPose { centre: from.centre.lerp(to.centre, alpha), angle: from.angle + turn * alpha }
    }

    /// The known tick near `about` at which the ghost was nearest to where a ship moves from one place (m) to another in a tick: by place and
    /// by velocity, for a path may cross itself.
    pub fn nearest(&self, (from, to): (DVec2, DVec2), about: u64) -> u64 {
        let near = about.saturating_sub(AROUND).max(1)..=(about + AROUND).min(self.ticks());
        let at = |tick: u64| self.poses[tick as usize].centre;
        let apart = |tick: &u64| {
            let turned = (at(*tick) - at(*tick - 1) - (to - from)) * VELOCITY;
            at(*tick).distance_squared(to) + turned.length_squared()
        };
        near.min_by(|a, b| apart(a).total_cmp(&apart(b))).unwrap_or(self.ticks())
    }

    /// The tick of this flight with the same time on the clock as the game; before the game's clock starts, the tick from which it would go on.
    pub fn beside(&self, game: &Game) -> u64 {
        if game.is_idle() { game.ticks().min(self.idle) } else { self.idle + game.ticks_on_clock() }
    }

    /// Ticks on the clock until an objective is met for the first time; `None` where it is not, as far as is known.
    pub fn met(&self, objective: usize) -> Option<u64> {
        self.met.get(objective).copied().flatten()
    }
}

fn pose(game: &Game) -> GhostPose {
    GhostPose { centre: game.world().body(SHIP).position, angle: game.ship().angle }
}

impl Replay {
    /// Flies all inputs again and compares. `watch` is called after every tick. The first second that departs ends the flight.
    /// Errors: as [`Game::with_tick_rate`].
    pub fn verify(&self, level: Arc<Level>, mut watch: impl FnMut(&Game)) -> Result<Result<(), Mismatch>, GameError> {
        let here = level_hash(&level);
        if self.level_hash != here {
            return Ok(Err(Mismatch::Level(self.level_hash, here)));
        }
        if let Some(mismatch) = self.runs_on() {
            return Ok(Err(mismatch));
        }
        let mut game = Game::with_tick_rate(level, self.tick_rate)?;
        for controls in self.inputs.after(0) {
            if game.outcome() != Outcome::Running {
                return Ok(Err(Mismatch::RunsOn(game.ticks(), self.inputs.ticks())));
            }
            game.step(controls);
            watch(&game);
            let second = ended_second(&game);
            if let Some((second, &recorded)) = second.and_then(|second| Some((second, self.seconds.get(second - 1)?)))
                && recorded != game.hash()
            {
                return Ok(Err(Mismatch::Second(second, recorded, game.hash())));
            }
        }
        Ok(self.compare(&game))
    }

    fn compare(&self, game: &Game) -> Result<(), Mismatch> {
        let (result, hash) = (game.result(), game.hash());
        let (score, outcome, time) = (result.score.total, result.outcome, thousandths(result.time));
        if (self.score, self.hash) != (score, hash) {
            return Err(Mismatch::End { score: (self.score, score), hash: (self.hash, hash) });
        }
        if (self.outcome, thousandths(self.time)) != (outcome, time) {
            return Err(Mismatch::Result { outcome: (self.outcome, outcome), time: (thousandths(self.time), time) });
        }
        Ok(())
    }
}
