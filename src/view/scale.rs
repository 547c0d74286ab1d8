//! How long arrows are drawn: a round number of newtons a square that suits whom the details tell of, so that the longest arrow fits. It
//! changes at once when an arrow would no longer fit or the view is zoomed, and back only after a while: arrows that breathe cannot be
//! compared.

use super::focus::Focus;
use super::quantity::round_up;
use crate::game::{DAMAGING_SPEED, Game, SHIP};
use crate::physics::BodyId;

/// How long what a body usually feels is drawn, canvas units: its weight, half of the ship's thrust, what stops it at damaging speed.
const USUAL: f64 = 225.0;
/// The least that this may shrink to where others feel far more than the ship, canvas units: theirs are cut then.
const USUAL_LEAST: f64 = 60.0;
/// An arrow with less room in the window, as in its corner, is cut instead of making all of them shorter, canvas units.
const LEAST_ROOM: f32 = 120.0;
/// N/kg. What the weight of a body is taken for where there is no gravity.
const STANDARD: f64 = 9.81;
/// By what factor the view is zoomed before arrows get another scale at once.
const ZOOMED: f64 = 1.25;
/// For how long longer arrows must have fitted before they are drawn longer, s of the game.
const PATIENCE: f64 = 2.0;

/// How long arrows are drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArrowScale {
    /// Newtons a metre of the level, for forces.
    pub newtons: f64,
    /// Newton-seconds a metre of the level, for impacts.
    pub newton_seconds: f64,
}

/// A force or an impulse (N, N·s) and the room that its arrow has, canvas units.
pub type Reach = (f64, f32);

/// The scale from frame to frame.
#[derive(Clone, Debug, Default)]
pub struct Steady {
    newtons: Step,
    newton_seconds: Step,
    /// For which focus, and for how many canvas units a metre, it was begun.
    asked: Option<(Focus, f64)>,
}

impl Steady {
    /// The scale of this frame, in which a metre is drawn `metre` canvas units long, for those who are shown and their forces and impulses.
    pub fn update(
        &mut self,
        game: &Game,
        (focus, shown): (&Focus, &[BodyId]),
        metre: f64,
        [forces, impulses]: [&[Reach]; 2],
    ) -> ArrowScale {
        // Who asks for other arrows or another view gets them at once.
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

/// The force and the impulse that are usual, N and N·s: for the bodies that are followed; where none is, for a ship that plays a part or,
/// where it is out of view, for the heaviest body in view. A body without weight feels nothing usual: what it feels now counts.
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
    // Nobody is shown: any scale will do.
    if whose.is_empty() { [1.0; 2] } else { [force, impulse] }
}

/// One of the two numbers.
#[derive(Clone, Debug, Default)]
struct Step {
    now: Option<f64>,
    /// Since when a smaller one would do, in ticks, and the largest that was wanted since.
    loose: Option<(u64, f64)>,
}

impl Step {
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
        let mut step = Step::default();
        assert_eq!(step.update(90.0, 0, 10), 100.0);
        assert_eq!(step.update(101.0, 1, 10), 200.0, "what no longer fits is drawn shorter at once");
        for tick in 2..12 {
            // A moment in which more was wanted is remembered.
            assert_eq!(step.update(if tick == 5 { 45.0 } else { 3.0 }, tick, 10), 200.0, "tick {tick}");
        }
        assert_eq!(step.update(3.0, 12, 10), 50.0);
        assert_eq!(step.update(3.0, 13, 10), 50.0);
        // Time that is taken back begins the while anew.
        assert_eq!(step.update(3.0, 4, 10), 50.0);
        assert_eq!(step.update(3.0, 13, 10), 50.0);
        assert_eq!(step.update(3.0, 14, 10), 5.0);
    }
}
