//! A record that is flown again, to compare where it leads with the written end.

use super::attempt::Game;
use super::event::{GameError, Outcome};
use super::fingerprint::level_hash;
use super::replay::{Mismatch, Replay, ended_second, thousandths};
use crate::level::Level;
use std::sync::Arc;

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
