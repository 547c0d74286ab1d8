//! A gas: nothing lies on anything as the step begins, and everything bounces off whatever it meets.
//!
//! Then flights and impacts in their order are the whole truth, and neither contacts nor loads nor friction of what lies have to be solved. If
//! some impact does not bounce after all, because a rebound is slower than the rest speed, or somebody gets where that was not foreseen, the
//! island is solved as any other, from the same start.

use super::bodies::Bodies;
use super::contacts::Tolerances;
use super::dense::{Dense, Outcome, StepSize};
use super::impacts::{Around, SLOWEST};
use super::islands::Island;
use super::neighbours::Neighbours;
use super::place;

impl Dense {
    /// Solves an island that is a gas. None: it is none, and nothing has changed.
    pub(super) fn solve_gas(
        &mut self,
        bodies: &mut Bodies,
        neighbours: &mut Neighbours,
        island: Island<'_>,
        size: StepSize,
    ) -> Option<Outcome> {
        let none_moves = island.states.is_empty() && neighbours.carried().is_empty();
        // Where it was taken for a gas from the start, that has been asked already.
        if !bodies.lively || !none_moves || !(size.gas || is_gas(bodies, island, &self.reach.added)) {
            return None;
        }
        self.contacts.have_none(bodies, island);
        self.anchors.let_go(island.members);
        let Self { contacts, anchors, impacts, reach, .. } = self;
        let mut around = Around { island, neighbours, reach, last: size.last };
        let whole = impacts.follow_alone(bodies, (contacts, anchors), &mut around, size);
        if !self.reach.strangers.is_empty() {
            self.note_put_off();
            return Some(self.grow(bodies, island));
        }
        if !whole || self.overlaps(bodies, island) {
            self.impacts.waiting = 0;
            self.impacts.undo(bodies, island.members);
            return None;
        }
        self.note_put_off();
        for &i in island.members {
            let i = i as usize;
            (bodies.ux[i], bodies.uy[i]) = (bodies.free_vx[i], bodies.free_vy[i]);
        }
        self.impacts.plastic.clear();
        self.restrain(bodies, island, false);
        Some(Outcome::Done)
    }

    /// Whether any pair overlaps where impacts have left it, something is beyond a surface, or somebody has got further than was looked for.
    fn overlaps(&self, bodies: &Bodies, island: Island<'_>) -> bool {
        let hair = self.contacts.tolerances.hair;
        let overlap = |i: u32, j: u32| {
            let pair = (i as usize, j as usize);
            place::meets(bodies, pair, hair, true) || (pair.1 >= bodies.len() && place::passed(bodies, pair))
        };
        island.members.iter().any(|&i| !bodies.is_swept(i as usize) || island.near(i).iter().any(|&j| overlap(i, j)))
            || self.reach.added.iter().any(|&(i, j)| overlap(i, j))
    }
}

/// Whether all members bounce, and none lies on another, or leans on it, as the step begins; besides its own pairs, these are near.
pub(super) fn is_gas(bodies: &Bodies, island: Island<'_>, added: &[(u32, u32)]) -> bool {
    if !island.members.iter().all(|i| bodies.traits[*i as usize].restitution > 0.0) {
        return false;
    }
    let touch = Tolerances::of(bodies, island.all).touch;
    let lies = |i: u32, j: u32| {
        let (i, j) = (i as usize, j as usize);
        bodies.touch(i, j, touch) && presses(bodies, (i, j))
    };
    !island.members.iter().any(|&i| island.near(i).iter().any(|&j| lies(i, j))) && !added.iter().any(|&(i, j)| lies(i, j))
}

/// Whether two that touch do not approach yet, but would in free flight, along the axis of their contact.
fn presses(bodies: &Bodies, (i, j): (usize, usize)) -> bool {
    let axis = |x: &[f64], half: &[f64], v: &[f64], free: &[f64]| {
        let side = if x[j] < x[i] { -1.0 } else { 1.0 };
        let gap = (x[j] - x[i]) * side - half[i] - half[j];
        (gap, (v[i] - v[j]) * side <= SLOWEST && (free[i] - free[j]) * side > 0.0)
    };
    let (gap_x, presses_x) = axis(&bodies.x, &bodies.hx, &bodies.vx, &bodies.free_vx);
    let (gap_y, presses_y) = axis(&bodies.y, &bodies.hy, &bodies.vy, &bodies.free_vy);
    if gap_x > gap_y { presses_x } else { presses_y }
}
