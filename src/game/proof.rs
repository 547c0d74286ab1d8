//! A record that is flown again, a tick at a time, to compare its end with the written one.

use super::attempt::Game;
use super::event::{GameError, Outcome};
use super::fingerprint::level_hash;
use super::inputs::Playback;
use super::replay::{Mismatch, Replay, ended_second, thousandths};
use crate::level::Level;
use std::sync::Arc;

#[derive(Clone, Debug)]
pub struct Proof {
    replay: Arc<Replay>,
    game: Game,
    rest: Playback,
}

impl Proof {
    /// The record at its start in that level.
    /// Errors: as [`Game::with_tick_rate`]; within, the level's hash differs from the record's, or the record's keys go on beyond
    /// its own time.
    pub fn new(replay: Arc<Replay>, level: Arc<Level>) -> Result<Result<Self, Mismatch>, GameError> {
        let here = level_hash(&level);
        if replay.level_hash != here {
            return Ok(Err(Mismatch::Level(replay.level_hash, here)));
        }
        if let Some(mismatch) = replay.runs_on() {
            return Ok(Err(mismatch));
        }
        let game = Game::with_tick_rate(level, replay.tick_rate)?;
        Ok(Ok(Self { rest: replay.inputs.clone().into_iter(), game, replay }))
    }

    /// Flies one tick. `Some` once the comparison is decided.
    pub fn step(&mut self) -> Option<Result<(), Mismatch>> {
        let Some(controls) = self.rest.next() else { return Some(self.compare()) };
        if self.game.outcome() != Outcome::Running {
            return Some(Err(Mismatch::RunsOn(self.game.ticks(), self.replay.inputs.ticks())));
        }
        self.game.step(controls);
        let second = ended_second(&self.game)?;
        let &recorded = self.replay.seconds.get(second - 1)?;
        let flown = self.game.hash();
        (recorded != flown).then_some(Err(Mismatch::Second(second, recorded, flown)))
    }

    pub const fn game(&self) -> &Game {
        &self.game
    }

    fn compare(&self) -> Result<(), Mismatch> {
        let (recorded, result, hash) = (&self.replay, self.game.result(), self.game.hash());
        let (score, outcome) = (result.score.total, result.outcome);
        if (score, hash) != (recorded.score, recorded.hash) {
            return Err(Mismatch::End { score: (recorded.score, score), hash: (recorded.hash, hash) });
        }
        let times = (thousandths(recorded.time), thousandths(result.time));
        if recorded.outcome != outcome || times.0 != times.1 {
            return Err(Mismatch::Result { outcome: (recorded.outcome, outcome), time: times });
        }
        Ok(())
    }
}

impl Replay {
    /// Flies all inputs again and compares. `watch` is called after every tick.
    pub fn verify(&self, level: Arc<Level>, mut watch: impl FnMut(&Game)) -> Result<Result<(), Mismatch>, GameError> {
        let mut proof = match Proof::new(Arc::new(self.clone()), level)? {
            Ok(proof) => proof,
            Err(mismatch) => return Ok(Err(mismatch)),
        };
        loop {
            let verdict = proof.step();
            watch(proof.game());
            if let Some(verdict) = verdict {
                return Ok(verdict);
            }
        }
    }
}
