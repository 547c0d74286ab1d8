//! Who of an island need not be looked at, because the step comes to the same for it as the one before.
//!
//! A member *rests* when a step began and ended with it at rest on what rests, and nothing acted on it but what carries it. While its free
//! flight stays what it was, and all that is near and below it rests too, the next step comes to the same for it, bit for bit: it is
//! *settled*. The solver passes it by and takes it for ground, as it takes a surface that stands. Whatever is near something that moves is
//! looked at, and what rests on that. If it turns out all the same that a settled member would have moved, or one on which settled ones
//! rely, these are *woken* and the step is solved again from its start. So a ball that bounces on a heap costs what it touches, and the
//! result is that of looking at all.

use super::bodies::Bodies;
use super::islands::Island;

/// In an island of fewer bodies nobody is left out: finding out who rests takes longer than to look at all.
pub(super) const LARGE: usize = 32;
/// Nor where only such a part of the members rested in the step before.
const FEWEST: f64 = 0.25;
/// Where such a part of them did, only what movers come upon wakes what lies on it. Smaller: more steps are solved again; larger: more are looked
/// at that stay.
const CALM: f64 = 0.9;
/// After so many solutions of a step all are looked at.
const MOST: u32 = 6;

/// What a member is to a step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum State {
    /// It moves, or it is not known whether it does.
    #[default]
    Moves,
    /// It was found to rest, and something may act on it now.
    Woken,
    Rests,
    /// It rests and is left out.
    Settled,
}

/// Who is looked at, and what is known of the last step, by slot.
#[derive(Clone, Debug, Default)]
pub(super) struct Settled {
    /// Members to look at, in the order of the island, and what all of them are.
    active: Vec<u32>,
    states: Vec<State>,
    /// The step in which a body was last found to rest, and its free velocity along gravity then, m/s.
    found: Vec<(u64, f64)>,
    /// The present step, and how often the present island has been solved in it.
    step: u64,
    rounds: u32,
    /// Whether nearly all of the present island rested in the step before.
    calm: bool,
}

impl Settled {
    /// Of `count` bodies.
    pub fn new(count: usize) -> Self {
        let found = vec![(0, 0.0); count];
        Self { active: Vec::with_capacity(count), states: vec![State::Moves; count], found, step: 2, rounds: 0, calm: false }
    }

    /// A step begins.
    pub fn next_step(&mut self) {
        self.step += 1;
    }

    /// What has been found holds no longer: slots were numbered anew, or surfaces are others.
    pub fn forget(&mut self) {
        self.step += 2;
    }

    /// Looks at all of an island.
    fn begin_with_all(&mut self, island: Island<'_>) {
        self.active.clear();
        self.active.extend_from_slice(island.members);
    }

    /// Chooses who is looked at of an island, by what was found of its members in the last step. Boxes touch up to a gap of `touch`, m.
    pub fn begin(&mut self, bodies: &Bodies, island: Island<'_>, touch: f64) {
        self.rounds = 1;
        let Self { states, found, step, .. } = self;
        let known = island.members.iter().filter(|i| found[**i as usize].0 + 1 == *step).count();
        if known as f64 <= FEWEST * island.members.len() as f64 {
            return self.begin_with_all(island);
        }
        self.calm = known as f64 >= CALM * island.members.len() as f64;
        for &i in island.members {
            let at = i as usize;
            let (found_in, fall) = found[at];
            let flight = (bodies.free_vy[at].to_bits() ^ fall.to_bits()) | bodies.free_vx[at].to_bits();
            let rests = found_in + 1 == *step && flight == 0 && bodies.px[at] == bodies.x[at];
            states[at] = if rests { State::Settled } else { State::Moves };
        }
        let n = bodies.len();
        for &i in island.members {
            if self.states[i as usize] == State::Moves {
                for &j in island.near(i).iter().filter(|j| (**j as usize) < n) {
                    let beside = self.beside(bodies, (i as usize, j as usize), touch);
                    let below = &mut self.states[j as usize];
                    *below = beside.min(*below);
                }
            }
        }
        self.choose(bodies, island, touch);
    }

    /// Wakes what touches the woken from above or beside, and what is above a mover, and leaves out who then rests on what rests.
    fn choose(&mut self, bodies: &Bodies, island: Island<'_>, touch: f64) {
        self.active.clear();
        for &i in island.members {
            let at = i as usize;
            let mut state = self.states[at];
            if state >= State::Rests {
                if self.rounds > MOST {
                    state = State::Woken;
                }
                for &j in island.near(i) {
                    let j = j as usize;
                    match self.states.get(j) {
                        Some(State::Settled | State::Rests) => {}
                        Some(State::Moves) => state = state.min(self.beside(bodies, (j, at), touch)),
                        Some(State::Woken) if bodies.touch(at, j, touch) => state = State::Woken,
                        Some(State::Woken) => state = state.min(State::Rests),
                        None if bodies.carries(j) => state = state.min(State::Rests),
                        None => {}
                    }
                }
                self.states[at] = state;
            }
            if state != State::Settled {
                self.active.push(i);
            }
        }
    }

    /// What somebody who rests is because of a mover near it: woken, or, where it is calm, only looked at if that does not come upon it on its
    /// free flight.
    fn beside(&self, bodies: &Bodies, (mover, other): (usize, usize), touch: f64) -> State {
        let meets = |x: &[f64], px: &[f64], half: &[f64]| {
            let (from, to, reach) = (x[mover] - x[other], px[mover] - x[other], half[mover] + half[other] + touch);
            from.min(to) <= reach && from.max(to) >= -reach
        };
        let comes = !self.calm || meets(&bodies.x, &bodies.px, &bodies.hx) && meets(&bodies.y, &bodies.py, &bodies.hy);
        if comes { State::Woken } else { State::Rests }
    }

    /// What is looked at of an island.
    pub fn part_of<'a>(&'a self, island: Island<'a>) -> Island<'a> {
        let states = if self.active.len() < island.members.len() { &self.states[..] } else { &[] };
        island.part(&self.active, states)
    }

    /// Looks also at those of `stirred` that were to rest, and at what touches them from above or beside. Returns whether that is anybody new.
    pub fn wake(&mut self, bodies: &Bodies, island: Island<'_>, stirred: &mut Vec<u32>, touch: f64) -> bool {
        if stirred.is_empty() {
            return false;
        }
        let before = self.active.len();
        self.rounds += 1;
        stirred.drain(..).for_each(|i| self.states[i as usize] = State::Woken);
        self.choose(bodies, island, touch);
        self.active.len() > before
    }

    /// Whether somebody who is looked at was found to rest: others may be left out because of that.
    pub fn is_relied_on(&self, i: u32) -> bool {
        self.states[i as usize] == State::Rests
    }

    /// Notes who rests, for the next step: who is left out, and who `rests` of the others, told whether those below do.
    pub fn end(&mut self, bodies: &Bodies, island: Island<'_>, rests: impl Fn(usize, &dyn Fn(usize) -> bool) -> bool) {
        let Self { states, found, step, active, .. } = self;
        let all = active.len() == island.members.len();
        for &i in island.members {
            let i = i as usize;
            let rests = (!all && states[i] == State::Settled) || rests(i, &|j| found[j].0 == *step);
            found[i] = (if rests { *step } else { 0 }, bodies.free_vy[i]);
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::physics::pile::{Pile, PileBody, PileDef, PileSurface};
    use crate::physics::{Aabb, DVec2};
    use crate::random::Random;

    /// Boxes that rain into a pit; `throws` of them come later, from high above.
    fn rain(count: usize, throws: usize, restitution: f64) -> Pile {
        let mut random = Random(9);
        let mut unit = || random.unit();
        let columns = (count as f64).sqrt().ceil() as usize;
        let width = 0.7 * columns as f64;
        let bodies = (0..count).map(|i| PileBody {
            position: DVec2::new(
                0.35 + 0.7 * (i % columns) as f64,
                if i < throws { -150.0 } else { -1.0 } - 0.8 * (i / columns) as f64,
            ),
            velocity: DVec2::new(4.0 * unit() - 2.0, 0.0),
            half: DVec2::new(0.15 + 0.15 * unit(), 0.15 + 0.15 * unit()),
            mass: 1.0 + 9.0 * unit(),
            restitution: restitution * unit(),
            static_friction: 0.5,
            kinetic_friction: 0.4,
            ..PileBody::default()
        });
        let surface = |left, top, right, bottom| PileSurface {
            bounds: Aabb::new(DVec2::new(left, top), DVec2::new(right, bottom)),
            static_friction: 0.5,
            kinetic_friction: 0.5,
        };
        let surfaces =
            vec![surface(-5.0, 0.0, width + 5.0, 1.0), surface(-1.0, -2000.0, 0.0, 0.0), surface(width, -2000.0, width + 1.0, 0.0)];
        Pile::new(PileDef { bodies: bodies.collect(), surfaces, sleep: false, ..PileDef::default() }).expect("it is a good one")
    }

    /// To the bit; what lists its contacts looks at all.
    #[test]
    fn who_rests_is_left_out_and_nobody_moves_otherwise() {
        for restitution in [0.0, 0.8] {
            let mut some = rain(400, 20, restitution);
            let mut all = some.clone();
            all.dense.report.on = true;
            let mut left_out = 0;
            for step in 0..600 {
                some.step(1.0 / 60.0);
                all.step(1.0 / 60.0);
                left_out += some.dense.settled.states.iter().filter(|state| **state == super::State::Settled).count();
                for i in 0..some.len() {
                    let of = |pile: &Pile| [pile.position(i), pile.velocity(i)].map(|v| [v.x.to_bits(), v.y.to_bits()]);
                    assert_eq!(of(&some), of(&all), "body {i} after step {step}, {left_out} left out");
                }
            }
            assert!(left_out > 20_000, "hardly anybody was left out: {left_out}");
        }
    }
}
