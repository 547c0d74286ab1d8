//! The length of arrows: a round number of newtons a square, for which the longest arrow of the shown bodies fits. It shrinks at
//! once when an arrow would no longer fit or the view is zoomed, and grows back after a delay: arrows with an unsteady scale could
//! not be compared.

use super::focus::Focus;
use super::quantity::round_up;
use crate::game::{DAMAGING_SPEED, Game, SHIP};
use crate::physics::BodyId;

/// The length of a body's usual force, canvas units: its weight, half of the ship's thrust, or the force that stops a damaging
/// speed.
const USUAL: f64 = 225.0;
/// The least of that length where other bodies feel far more than the ship, canvas units: their arrows are cut then.
const USUAL_LEAST: f64 = 60.0;
/// An arrow with less room in the window, as in its corner, is cut instead of shortening all of them, canvas units.
const LEAST_ROOM: f32 = 120.0;
/// N/kg: gravity of the usual weight where a level has none.
const STANDARD: f64 = 9.81;
/// A zoom by this factor changes the scale at once.
const ZOOMED: f64 = 1.25;
/// Longer arrows must fit for this long before they are drawn longer, s of the game.
const PATIENCE: f64 = 2.0;

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArrowScale {
    /// Newtons a metre of the level, for forces.
    pub newtons: f64,
    /// Newton-seconds a metre of the level, for impacts.
    pub newton_seconds: f64,
}

/// A force or an impulse (N, N·s) and the room of its arrow, canvas units.
pub type Reach = (f64, f32);

#[derive(Clone, Debug, Default)]
pub struct Steady {
    newtons: ScaleStep,
    newton_seconds: ScaleStep,
    /// The focus, and the canvas units a metre, at which the scale began.
    asked: Option<(Focus, f64)>,
}

impl Steady {
    /// The scale of this frame, at `metre` canvas units a metre, for the shown bodies and their forces and impulses.
    pub fn update(
        &mut self,
        game: &Game,
        (focus, shown): (&Focus, &[BodyId]),
        metre: f64,
        [forces, impulses]: [&[Reach]; 2],
    ) -> ArrowScale {
        // A new focus or zoom takes effect at once.
        let as_asked = |(asked, at): (Focus, f64)| asked == *focus && (at / ZOOMED..=at * ZOOMED).contains(&metre);
        if !self.asked.is_some_and(as_asked) {
            *self = Self { asked: Some((*focus, metre)), ..Self::default() };
        }
        let patience = (PATIENCE * game.tick_rate()) as u64;
        let wanted = |usual: f64, reaches: &[Reach]| {
            let needed = reaches.iter().map(|(size, room)| size / f64::from(room.max(LEAST_ROOM))).fold(0.0, f64::max);
            let most = if focus.followed().is_some() { f64::INFINITY } else { usual / USUAL_LEAST };
            (usual / USUAL).max(needed.min(most)) * metre / focus.length()
        };
        let [force, impulse] = usual(game, focus, shown);
        ArrowScale {
            newtons: self.newtons.update(wanted(force, forces), game.ticks(), patience),
            newton_seconds: self.newton_seconds.update(wanted(impulse, impulses), game.ticks(), patience),
        }
    }
}

/// The usual force and impulse, N and N·s: for the followed bodies; where none is, for a ship that plays a part or, out of view,
/// for the heaviest body in view. A weightless body has no usual force: its present one counts.
fn usual(game: &Game, focus: &Focus, shown: &[BodyId]) -> [f64; 2] {
    let level = game.level();
    let gravity = if level.gravity == 0.0 { STANDARD } else { level.gravity.abs() };
    let one = |id: &BodyId| {
        let body = game.world().body(*id);
        let mass = body.mass;
        let largest = || game.world().forces(*id).forces().iter().map(|force| force.vector.length()).fold(0.0, f64::max);
        let force = match *id {
            SHIP => (mass * level.gravity.abs()).max(0.5 * level.player.thrust),
            _ if body.weightless && largest() > 0.0 => largest(),
            _ => mass * gravity,
        };
        [force, mass * DAMAGING_SPEED]
    };
    let picked: Vec<BodyId> = focus.followed().into_iter().chain(focus.compared()).filter(|id| shown.contains(id)).collect();
    let whose = if !picked.is_empty() {
        &picked
    } else if shown.contains(&SHIP) {
        &[SHIP][..]
    } else {
        shown
    };
    let [force, impulse] = whose.iter().map(one).fold([0.0_f64; 2], |most, one| [most[0].max(one[0]), most[1].max(one[1])]);
    // No body is shown: any scale will do.
    if whose.is_empty() { [1.0; 2] } else { [force, impulse] }
}

#[derive(Clone, Debug, Default)]
struct ScaleStep {
    now: Option<f64>,
    /// The tick since which a smaller value would do, and the largest wish since.
    loose: Option<(u64, f64)>,
}

impl ScaleStep {
    fn update(&mut self, wanted: f64, tick: u64, patience: u64) -> f64 {
        let fitting = round_up(wanted);
        let now = match self.now {
            Some(now) if fitting < now => {
                let (since, largest) = self.loose.filter(|(since, _)| *since <= tick).unwrap_or((tick, fitting));
                let largest = largest.max(fitting);
                let over = tick - since >= patience;
                self.loose = (!over).then_some((since, largest));
                if over { largest } else { now }
            }
            _ => {
                self.loose = None;
                fitting
            }
        };
        self.now = Some(now);
        now
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arrows_grow_shorter_at_once_and_longer_after_a_while() {
        let mut step = ScaleStep::default();
        assert_eq!(step.update(90.0, 0, 10), 100.0);
        assert_eq!(step.update(101.0, 1, 10), 200.0, "what no longer fits is drawn shorter at once");
        for tick in 2..12 {
            // The maximum of the wishes counts, not the last one.
            assert_eq!(step.update(if tick == 5 { 45.0 } else { 3.0 }, tick, 10), 200.0, "tick {tick}");
        }
        assert_eq!(step.update(3.0, 12, 10), 50.0);
        assert_eq!(step.update(3.0, 13, 10), 50.0);
        // A jump back in time restarts the delay.
        assert_eq!(step.update(3.0, 4, 10), 50.0);
        assert_eq!(step.update(3.0, 13, 10), 50.0);
        assert_eq!(step.update(3.0, 14, 10), 5.0);
    }
}
