//! The forces in the contacts of the last step, for whoever wants to list them.
//!
//! Along gravity a body's load is split equally among the supports that it touches. Across, the impulses of a row follow from what
//! each body's momentum lacks, from the loose ends inwards; a row clamped between two surfaces has no loose end, and what holds it
//! cannot be told apart: it is left out. Nothing here enters the motion.

use super::contacts::{Side, TOUCH};
use super::{Axis, Other, Pile};

/// What a contact exerted on average during the last step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactForce {
    /// The body that feels it (the other one feels the opposite).
    pub a: usize,
    /// What exerts it.
    pub b: Other,
    /// The normal's direction.
    pub axis: Axis,
    /// The component along the normal, N: positive towards larger x or y.
    pub normal: f64,
    /// Friction, along the other direction, N.
    pub friction: f64,
}

/// What the listing works on, kept from call to call.
#[derive(Clone, Debug, Default)]
pub(super) struct Scratch {
    loads: Vec<f64>,
    /// Impulse of friction on each body, N·s.
    dragged: Vec<f64>,
    /// Momentum across that no friction explains, N·s.
    lacking: Vec<f64>,
    degree: Vec<u32>,
    open: Vec<u32>,
}

impl Pile {
    /// Appends the contact forces of the last step, each pair once.
    pub fn contact_forces(&mut self, into: &mut Vec<ContactForce>) {
        if self.last_dt > 0.0 && !self.contacts.start.is_empty() {
            let mut scratch = std::mem::take(&mut self.report);
            self.stack_forces(&mut scratch, into);
            self.side_forces(&mut scratch, into);
            self.report = scratch;
        }
    }

    fn other(&self, i: usize) -> Other {
        let n = self.bodies.len();
        if i < n { Other::Body(self.bodies.id[i] as usize) } else { Other::Surface(i - n) }
    }

    fn stack_forces(&self, scratch: &mut Scratch, into: &mut Vec<ContactForce>) {
        let (b, n, per_second) = (&self.bodies, self.bodies.len(), 1.0 / self.last_dt);
        let Scratch { loads, dragged, .. } = scratch;
        for list in [&mut *loads, &mut *dragged] {
            list.clear();
            list.resize(b.x.len(), 0.0);
        }
        for i in (0..n).rev() {
            let load = loads[i] + b.mass[i] * (b.free_vy[i] - b.vy[i]);
            if load < 0.0 {
                self.ceiling_force(i, -load * per_second, into);
            }
            let touching = |below: u32, reach: f64| (b.y[below as usize] - b.y[i] - reach).abs() <= TOUCH;
            let stacks = self.contacts.stacks.get(self.contacts.under(i)).unwrap_or_default();
            let supports = stacks.iter().filter(|s| s.live && touching(s.below, s.reach));
            let share = load.max(0.0) / supports.clone().count() as f64;
            for stack in supports {
                let below = stack.below as usize;
                loads[below] += share;
                let grip = self.friction.impulse(i, stack.below);
                dragged[i] += grip;
                dragged[below] -= grip;
                let (a, other) = (b.id[i] as usize, self.other(below));
                let normal = -share * per_second * self.down;
                into.push(ContactForce { a, b: other, axis: Axis::Gravity, normal, friction: grip * per_second });
            }
        }
    }

    /// What holds a body back from rising, N, where it touches a ceiling.
    fn ceiling_force(&self, i: usize, held: f64, into: &mut Vec<ContactForce>) {
        let b = &self.bodies;
        let above =
            |ceiling: &&Side| ceiling.second as usize == i && (b.y[i] - b.y[ceiling.first as usize] - ceiling.reach).abs() <= TOUCH;
        if let Some(ceiling) = self.contacts.ceilings.iter().find(above) {
            let (a, other) = (b.id[i] as usize, self.other(ceiling.first as usize));
            into.push(ContactForce { a, b: other, axis: Axis::Gravity, normal: held * self.down, friction: 0.0 });
        }
    }

    fn side_forces(&self, scratch: &mut Scratch, into: &mut Vec<ContactForce>) {
        let (b, n, per_second) = (&self.bodies, self.bodies.len(), 1.0 / self.last_dt);
        let touches = |first: u32, second: u32, reach: f64| (b.x[second as usize] - b.x[first as usize] - reach).abs() <= TOUCH;
        let Scratch { dragged, lacking, degree, open, .. } = scratch;
        let sides = &self.contacts.sides;
        open.clear();
        open.extend((0..sides.len() as u32).filter(|&s| {
            let side = &sides[s as usize];
            side.live && touches(side.first, side.second, side.reach)
        }));
        lacking.clear();
        lacking.extend((0..n).map(|i| b.mass[i] * (b.vx[i] - b.free_vx[i]) - dragged[i]));
        degree.clear();
        degree.resize(b.x.len(), 0);
        for &side in &*open {
            let side = &sides[side as usize];
            degree[side.first as usize] += 1;
            degree[side.second as usize] += 1;
        }
        loop {
            let before = open.len();
            open.retain(|&side| {
                let side = &sides[side as usize];
                let (first, second) = (side.first as usize, side.second as usize);
                // The impulse on the second, by whichever of the two is a loose end.
                let impulse = if second < n && degree[second] == 1 {
                    lacking[second]
                } else if first < n && degree[first] == 1 {
                    -lacking[first]
                } else {
                    return true;
                };
                degree[first] -= 1;
                degree[second] -= 1;
                if second < n {
                    lacking[second] -= impulse;
                }
                if first < n {
                    lacking[first] += impulse;
                }
                if impulse > 0.0 {
                    let (of, by, sign) = if first < n { (first, second, -1.0) } else { (second, first, 1.0) };
                    let (a, normal) = (b.id[of] as usize, sign * impulse * per_second);
                    into.push(ContactForce { a, b: self.other(by), axis: Axis::Across, normal, friction: 0.0 });
                }
                false
            });
            if open.len() == before {
                return;
            }
        }
    }
}
