//! Flies a level by a plan of way points, closed loop on the real game: `tools/autopilot` proves the shipped levels by it, the daily
//! flight its level. `tools/autopilot/README.md` has the format of a plan.

mod judgement;
mod pilot;
mod plan;
mod sight;

pub use judgement::Judgement;
pub use pilot::Autopilot;
pub use plan::{FlightPlan, PlanStep, StepKind};
pub use sight::Sight;

use crate::game::{Game, GameError, Outcome, Recorder};
use crate::level::Level;
use std::sync::Arc;

/// A flight by a plan with its record. It lasts `longest` seconds at most.
/// Errors: as [`Game::new`].
pub fn fly(level: &Arc<Level>, plan: &FlightPlan, longest: f64) -> Result<(Game, Recorder), GameError> {
    let mut game = Game::new(Arc::clone(level))?;
    let (mut pilot, mut recorder) = (Autopilot::new(plan, &Sight::of(&game)), Recorder::default());
    while game.outcome() == Outcome::Running && game.elapsed() < longest {
        let controls = pilot.keys(&Sight::of(&game));
        game.step(controls);
        recorder.note(&game, controls);
    }
    Ok((game, recorder))
}
