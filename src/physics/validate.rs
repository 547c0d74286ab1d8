//! Laws that hold after every tick in any world: each step of a build with debug assertions checks them, and the fuzz of levels; no game does.

use crate::physics::checks::{Checks, Thing, rounding};
use crate::physics::data::{Aabb, BodyId, SLOP, Sides};
use crate::physics::{forces::manager::ForceManager, store::motions::Method, world::World, world::edges};
use glam::DVec2;

mod energy;

/// m. How deep things may be in each other: contacts keep a gap of [`SLOP`], either way.
const OVERLAP: f64 = 2.0 * SLOP;
/// m. The same for bodies in or near a liquid, whose cubics follow their flows that closely, and for bodies of a crowd step.
const ROUGH: f64 = 1e-7;
/// The error of a sum of forces, relative to the sum of their magnitudes.
const FORCES: f64 = 1e-9;

impl World {
    /// Checks all that has to hold between two ticks, before anything is changed from outside:
    ///
    /// - every number is finite, and nothing is outside the level's edges;
    /// - no box overlaps another one by more than a tick ago (those that begin in each other may stay so), and none has passed through another one;
    /// - bodies whose paths crossed shared an island;
    /// - no island has gained more energy than its forces gave it;
    /// - the forces on each body sum to m·a;
    /// - the ends of each contact touch, and its friction stays inside the cone.
    ///
    /// Bodies of a crowd step and bodies in or near a liquid may overlap by 1e-7 m. Not checked are the depth of crowds in moving surfaces, and the
    /// faces of contacts with moving surfaces and of crowds: those are means over the tick, and their ends may have parted since. Of many bodies
    /// each tick checks the forces of some, so that all get their turn.
    ///
    /// # Errors
    /// A sentence that names the law, the bodies and the numbers.
    pub fn validate(&self) -> Result<(), String> {
        self.validate_with(&mut Checks::default())
    }

    pub(crate) fn validate_with(&self, checks: &mut Checks) -> Result<(), String> {
        self.validate_numbers()?;
        self.look_at_bodies(checks);
        self.validate_bounds(&checks.bodies)?;
        self.validate_places(checks)?;
        self.validate_energy(&checks.bodies, &mut checks.ledgers, &mut checks.moving)?;
        self.validate_forces(&mut checks.forces)?;
        self.validate_contacts()
    }

    fn validate_numbers(&self) -> Result<(), String> {
        for (i, body) in self.state.bodies.iter().enumerate() {
            let numbers = [("position", body.position), ("velocity", body.velocity), ("acceleration", body.acceleration)];
            if let Some((what, value)) = numbers.into_iter().find(|(_, value)| !value.is_finite()) {
                return Err(format!("the {what} of body {i} is {value}"));
            }
        }
        for (s, surface) in self.state.surfaces.iter().enumerate() {
            if !(surface.bounds.min.is_finite() && surface.bounds.max.is_finite() && surface.velocity.is_finite()) {
                return Err(format!("surface {s} is at {:?} with {} m/s", surface.bounds, surface.velocity));
            }
        }
        let impulse = self.records.impulses.iter().find(|impulse| !(impulse.vector.is_finite() && impulse.point.is_finite()));
        impulse.map_or(Ok(()), |impulse| Err(format!("an impact is {impulse:?}")))
    }

    /// Where the bodies are, were and have been in between, and their order.
    fn look_at_bodies(&self, checks: &mut Checks) {
        let Checks { bodies, order, .. } = checks;
        bodies.clear();
        bodies.extend((0..).zip(&self.state.bodies).map(|(id, body)| {
            let (now, before) = (body.bounds(), Aabb::around(self.space.previous(id as usize).0, body.half));
            let (swept, dense) = (now.union(&before), self.was_dense(id));
            let depth = if dense || self.state.media.wets(&swept) { ROUGH } else { OVERLAP };
            Thing { id, surface: false, now, before, swept, velocity: body.velocity, straight: true, dense, depth }
        }));
        for &(body, _, corner) in self.records.corners.iter().filter(|(_, at, _)| *at >= self.records.since) {
            let half = self.state.bodies[body as usize].half;
            let thing = &mut bodies[body as usize];
            (thing.swept, thing.straight) = (thing.swept.union(&Aabb::around(corner, half)), false);
        }
        order.clear();
        order.extend(0..bodies.len() as u32);
        let left = |i: u32| bodies[i as usize].swept.min.x;
        order.sort_unstable_by(|&a, &b| left(a).total_cmp(&left(b)));
    }

    /// Nothing is further outside the edges, where there are any, than it was.
    fn validate_bounds(&self, bodies: &[Thing]) -> Result<(), String> {
        let [.., left, right, top, bottom] = self.state.surfaces.as_slice() else { return Ok(()) };
        let min = DVec2::new(left.bounds.max.x, top.bounds.max.y);
        let level = Aabb::new(min, DVec2::new(right.bounds.min.x, bottom.bounds.min.y));
        if edges(&level, left.material).iter().zip([left, right, top, bottom]).any(|(edge, of)| edge.bounds != of.bounds) {
            return Ok(());
        }
        let outside = |of: &Aabb| (level.min - of.min).max(of.max - level.max).max_element();
        for body in bodies {
            let (now, before) = (outside(&body.now), outside(&body.before));
            if now > body.depth + rounding(&body.now) && now > before + rounding(&body.now) {
                return Err(format!("{} is {now} m outside the level, at {}", body.name(), body.now.centre()));
            }
        }
        Ok(())
    }

    fn validate_places(&self, checks: &Checks) -> Result<(), String> {
        let Checks { bodies, order, .. } = checks;
        for (k, &i) in order.iter().enumerate() {
            let a = &bodies[i as usize];
            let near = order[k + 1..].iter().map(|&j| &bodies[j as usize]).take_while(|b| b.swept.min.x < a.swept.max.x);
            for b in near.filter(|b| b.swept.min.y < a.swept.max.y && a.swept.min.y < b.swept.max.y) {
                validate_pair(a, b)?;
                self.validate_islands(a, b)?;
            }
        }
        let widest = bodies.iter().map(|body| body.swept.size().x).fold(0.0, f64::max);
        for (id, surface) in (0..).zip(&self.state.surfaces) {
            // A body that comes from a side that is not solid may be anywhere in a surface.
            if !surface.present || surface.def.sides != Sides::ALL {
                continue;
            }
            let (now, velocity, straight) = (surface.bounds, surface.velocity, surface.def.path.is_still());
            let surface =
                Thing { id, surface: true, now, before: now, swept: now, velocity, straight, dense: false, depth: OVERLAP };
            let first = order.partition_point(|&i| bodies[i as usize].swept.min.x < now.min.x - widest);
            let near = order[first..].iter().map(|&i| &bodies[i as usize]).take_while(|body| body.swept.min.x < now.max.x);
            near.filter(|body| body.swept.overlaps(&now, 0.0)).try_for_each(|body| validate_pair(body, &surface))?;
        }
        Ok(())
    }

    /// Bodies that were not looked at together have not come near each other.
    fn validate_islands(&self, a: &Thing, b: &Thing) -> Result<(), String> {
        // A body that flew or rested alone is an island of its own.
        let island = |of: &Thing| self.space.motions.island_of(of.id);
        let moved = a.swept != a.now || b.swept != b.now;
        let apart = moved && (island(a).is_none() || island(a) != island(b));
        if apart && self.space.last_dt > 0.0 && a.swept.overlaps(&b.swept, OVERLAP + rounding(&a.swept)) {
            let [of_a, of_b] = [a, b].map(|of| island(of).map_or("none".into(), |leader| leader.to_string()));
            let [a, b] = [a, b].map(Thing::name);
            return Err(format!("the ways of {a} and {b} crossed, but they were in the islands {of_a} and {of_b}"));
        }
        Ok(())
    }

    fn validate_forces(&self, forces: &mut ForceManager) -> Result<(), String> {
        let (n, contacts) = (self.state.bodies.len(), self.state.contacts.len());
        // Where more than 100 000 contacts would be looked through, some bodies are asked in each tick, all in turn.
        let stride = (n * contacts).div_ceil(100_000).max(1);
        for i in (0..n).skip(self.state.ticks as usize % stride).step_by(stride) {
            let (body, motion) = (&self.state.bodies[i], &self.space.motions.bodies[i]);
            if motion.method == Method::Crowd && !motion.listed {
                continue;
            }
            self.list_forces(BodyId(i as u32), forces);
            let scale: f64 = forces.forces().iter().map(|force| force.vector.length()).sum();
            let (resultant, needed) = (forces.resultant(), body.mass * body.acceleration);
            if (resultant - needed).length() > FORCES * scale {
                return Err(format!("the resultant on body {i} is {resultant} N, m·a is {needed} N: {:?}", forces.forces()));
            }
        }
        Ok(())
    }

    fn was_dense(&self, body: u32) -> bool {
        self.space.motions.bodies[body as usize].method == Method::Crowd
    }

    fn validate_contacts(&self) -> Result<(), String> {
        for contact in &self.state.contacts {
            let (lo, hi) = (self.state.bounds_of(contact.lo), self.state.bounds_of(contact.hi));
            let (axis, rounding) = (contact.axis, rounding(&lo).min(rounding(&hi)));
            let (first, second) = contact.ends();
            let body = &self.state.bodies[first as usize];
            let surface = (second as usize).checked_sub(self.state.bodies.len());
            let on_mover = surface.is_some_and(|s| !self.state.surfaces[s].def.path.is_still());
            // The contacts of the crowd step stay listed while their bodies sleep.
            let is_dense = self.was_dense(first) || self.space.sleep.asleep[first as usize] && !self.state.known[first as usize];
            if on_mover || is_dense {
                // The crowd step lists means over the tick. It lists the impact in a push as an impulse, but not the friction during one.
                if !(contact.normal >= 0.0 && contact.friction.is_finite()) {
                    return Err(format!("a contact pulls: {contact:?}"));
                }
                continue;
            }
            let gap = lo.gap(&hi);
            if gap[axis] > OVERLAP + rounding || gap[1 - axis] > rounding {
                return Err(format!("a contact whose ends are {gap} m apart: {contact:?}"));
            }
            let most = contact.static_friction.max(contact.kinetic_friction) * contact.normal;
            let little = FORCES * body.mass * (self.state.media.gravity.abs() + body.acceleration.length());
            if !(contact.normal >= 0.0 && contact.friction.abs() <= most * (1.0 + FORCES) + little) {
                return Err(format!("a contact carries more than it can: {contact:?}"));
            }
        }
        Ok(())
    }
}

/// Neither is in the other, unless it was so before, and neither has passed through the other.
fn validate_pair(a: &Thing, b: &Thing) -> Result<(), String> {
    let depth = |a: &Aabb, b: &Aabb| -a.gap(b).max_element();
    let (now, rounding) = (depth(&a.now, &b.now), rounding(&a.swept));
    // Where a surface that moves was is not known: nothing was in it.
    let before = if b.surface && !b.straight { 0.0 } else { depth(&a.before, &b.before) };
    // A limit of the crowd step: it takes the way of a surface for straight, and one that it stops for more than this tick.
    if a.dense && b.surface && !b.straight {
        return Ok(());
    }
    // Each may be off by what is beyond the gap. What was deeper than 1e-5 m has begun so: it may get deeper where the shorter way out changes.
    let most = a.depth + b.depth - OVERLAP;
    if now > most + rounding && now > before + rounding && before <= 1e-5 {
        return Err(format!("{} at {} is {now} m in {} at {:?}", a.name(), a.now.centre(), b.name(), b.now));
    }
    for axis in 0..2 {
        let across = 1 - axis;
        let shared = |a: &Aabb, b: &Aabb| a.max[across].min(b.max[across]) - a.min[across].max(b.min[across]);
        // Overlapping by a quarter before and after a tick, two things cannot have passed each other along the other axis.
        let least = 0.25 * a.now.size()[across].min(b.now.size()[across]);
        let (velocity, way) =
            (a.velocity - b.velocity, (a.now.centre() - b.now.centre()) - (a.before.centre() - b.before.centre()));
        // A way that turned round might have led past.
        let monotone = velocity[across] * way[across] >= 0.0;
        let passed = |a: &Thing, b: &Thing| a.before.max[axis] <= b.before.min[axis] && a.now.min[axis] >= b.now.max[axis];
        let faced = shared(&a.before, &b.before) > least && shared(&a.now, &b.now) > least;
        if a.straight && b.straight && monotone && faced && (passed(a, b) || passed(b, a)) {
            let (from, to) = (a.before.centre(), a.now.centre());
            return Err(format!("{} passed through {} at {:?} on its way from {from} to {to}", a.name(), b.name(), b.now));
        }
    }
    Ok(())
}
