//! What has to hold after every tick, whatever the world holds: asked by tests and by the fuzz of levels, never by the game.

use super::tuning::SLOP;
use super::world::{World, edges};
use super::{Aabb, BodyId, Sides};
use glam::DVec2;

/// Up to so many bodies every pair is asked whether it was looked at together, and every body about its forces.
const FEW: usize = 200;
/// m. How deep things may be in each other: contacts keep a gap of [`SLOP`], either way.
const OVERLAP: f64 = 2.0 * SLOP;
/// Roundings of a coordinate that its place may be off by.
const ROUNDINGS: f64 = 16.0;
/// Relative to the sum of the magnitudes of all forces: what their sum may be off by.
const FORCES: f64 = 1e-9;
/// Of the smaller of two sides: overlapping by that part along one axis before and after a tick, two things cannot have passed each other
/// along the other.
const FACES: f64 = 0.25;

/// Beyond all numbers of bodies.
const ALONE: u32 = 1 << 31;

/// A body or surface between two ticks.
struct Thing {
    name: String,
    /// The box that it fills, the one that it filled a tick ago, and the one around all of its way, m.
    now: Aabb,
    before: Aabb,
    swept: Aabb,
    /// m/s.
    velocity: DVec2,
    /// Whether its way has no corner, and it is known where it was.
    straight: bool,
}

impl World {
    /// Checks all that has to hold between two ticks, before anything is changed from outside:
    ///
    /// - every number is finite, and nothing is outside the level's edges;
    /// - nothing is in anything else, or deeper in it than a tick ago (what begins in each other may stay so), and nothing has passed
    ///   through anything;
    /// - bodies whose ways crossed were advanced together;
    /// - the forces on each body sum to the resultant, and that is m·a;
    /// - what is listed as a contact touches, and carries no more than it can.
    ///
    /// # Errors
    /// A sentence that names what does not hold, and where.
    pub fn validate(&self) -> Result<(), String> {
        self.validate_numbers()?;
        let mut things = self.things();
        let surfaces = things.split_off(self.state.bodies.len());
        self.validate_bounds(&things)?;
        self.validate_places(&things, &surfaces)?;
        self.validate_islands(&things)?;
        self.validate_forces()?;
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

    /// The bodies, then the surfaces.
    fn things(&self) -> Vec<Thing> {
        let bodies = self.state.bodies.iter().zip(&self.records.previous).enumerate().map(|(i, (body, &previous))| {
            let (now, before) = (body.bounds(), Aabb::around(previous, body.half));
            Thing { name: format!("body {i}"), now, before, swept: now.union(&before), velocity: body.velocity, straight: true }
        });
        let surfaces = self.state.surfaces.iter().enumerate().map(|(s, surface)| {
            let (now, velocity) = (surface.bounds, surface.velocity);
            Thing { name: format!("surface {s}"), now, before: now, swept: now, velocity, straight: surface.def.path.is_still() }
        });
        let mut things: Vec<Thing> = bodies.chain(surfaces).collect();
        for &(body, _, corner) in &self.records.corners {
            let half = self.state.bodies[body as usize].half;
            let thing = &mut things[body as usize];
            (thing.swept, thing.straight) = (thing.swept.union(&Aabb::around(corner, half)), false);
        }
        things
    }

    /// Nothing is further outside the edges, where there are any, than it was.
    fn validate_bounds(&self, bodies: &[Thing]) -> Result<(), String> {
        let [.., left, right, top, bottom] = self.state.surfaces.as_slice() else { return Ok(()) };
        let min = DVec2::new(left.bounds.max.x, top.bounds.max.y);
        let level = Aabb::new(min, DVec2::new(right.bounds.min.x, bottom.bounds.min.y));
        if edges(&level).iter().zip([left, right, top, bottom]).any(|(edge, of)| edge.bounds != of.bounds) {
            return Ok(());
        }
        let outside = |of: &Aabb| (level.min - of.min).max(of.max - level.max).max_element();
        for body in bodies {
            let (now, before) = (outside(&body.now), outside(&body.before));
            if now > OVERLAP + rounding(&body.now) && now > before + rounding(&body.now) {
                return Err(format!("{} is {now} m outside the level, at {}", body.name, body.now.centre()));
            }
        }
        Ok(())
    }

    fn validate_places(&self, bodies: &[Thing], surfaces: &[Thing]) -> Result<(), String> {
        let mut by_left_edge: Vec<&Thing> = bodies.iter().collect();
        by_left_edge.sort_by(|a, b| a.swept.min.x.total_cmp(&b.swept.min.x));
        for (i, a) in by_left_edge.iter().enumerate() {
            let near = by_left_edge[i + 1..].iter().take_while(|b| b.swept.min.x < a.swept.max.x);
            near.copied().try_for_each(|b| validate_pair(a, b))?;
        }
        // What comes from a side that is not solid may be anywhere in a surface.
        let solid = self.state.surfaces.iter().zip(surfaces).filter(|(of, _)| of.present && of.def.sides == Sides::ALL);
        for (_, surface) in solid {
            bodies.iter().try_for_each(|body| validate_pair(body, surface))?;
        }
        Ok(())
    }

    /// Bodies that were not looked at together have not come near each other.
    fn validate_islands(&self, bodies: &[Thing]) -> Result<(), String> {
        let after = &self.scratch.after;
        if bodies.len() > FEW || after.len() != bodies.len() {
            return Ok(());
        }
        // What flew or rested by itself is an island of its own.
        let island: Vec<u32> =
            (0..).zip(after).map(|(body, after)| if after.members > 0 { after.leader } else { ALONE + body }).collect();
        for (i, a) in bodies.iter().enumerate() {
            for (j, b) in bodies.iter().enumerate().skip(i + 1).filter(|(j, _)| island[*j] != island[i]) {
                if a.swept.overlaps(&b.swept, OVERLAP + rounding(&a.swept)) {
                    let [of_a, of_b] = [island[i], island[j]].map(|of| if of >= ALONE { "none".into() } else { of.to_string() });
                    return Err(format!("the ways of bodies {i} and {j} crossed, but they were in the islands {of_a} and {of_b}"));
                }
            }
        }
        Ok(())
    }

    /// Of a crowd only some are asked.
    fn validate_forces(&self) -> Result<(), String> {
        let n = self.state.bodies.len();
        for i in (0..n).step_by(n.div_ceil(FEW).max(1)) {
            let (forces, body) = (self.forces(BodyId(i as u32)), &self.state.bodies[i]);
            let sum: DVec2 = forces.forces().iter().map(|force| force.vector).sum();
            let scale: f64 = forces.forces().iter().map(|force| force.vector.length()).sum();
            let (resultant, needed) = (forces.resultant(), body.mass * body.acceleration);
            if (sum - resultant).length() > FORCES * scale {
                return Err(format!(
                    "the forces on body {i} sum to {sum} N, their resultant is {resultant} N: {:?}",
                    forces.forces()
                ));
            }
            if (resultant - needed).length() > FORCES * scale {
                return Err(format!("the resultant on body {i} is {resultant} N, m·a is {needed} N: {:?}", forces.forces()));
            }
        }
        Ok(())
    }

    fn validate_contacts(&self) -> Result<(), String> {
        for contact in &self.state.contacts {
            let (lo, hi) = (self.bounds_of(contact.lo), self.bounds_of(contact.hi));
            let (axis, rounding) = (contact.axis, rounding(&lo).min(rounding(&hi)));
            let gap = lo.gap(&hi);
            if gap[axis] > OVERLAP + rounding || gap[1 - axis] > rounding {
                return Err(format!("a contact whose ends are {gap} m apart: {contact:?}"));
            }
            let most = contact.static_friction.max(contact.kinetic_friction) * contact.normal;
            if !(contact.normal >= 0.0 && contact.friction.abs() <= most * (1.0 + FORCES)) {
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
    let before = if b.name.starts_with("surface") && !b.straight { 0.0 } else { depth(&a.before, &b.before) };
    if now > OVERLAP + rounding && now > before + rounding {
        return Err(format!("{} at {} is {now} m in {} at {:?}", a.name, a.now.centre(), b.name, b.now));
    }
    for axis in 0..2 {
        let across = 1 - axis;
        let shared = |a: &Aabb, b: &Aabb| a.max[across].min(b.max[across]) - a.min[across].max(b.min[across]);
        let least = FACES * a.now.size()[across].min(b.now.size()[across]);
        let (velocity, way) =
            (a.velocity - b.velocity, (a.now.centre() - b.now.centre()) - (a.before.centre() - b.before.centre()));
        // A way that turned round might have led past.
        let monotone = velocity[across] * way[across] >= 0.0;
        let passed = |a: &Thing, b: &Thing| a.before.max[axis] <= b.before.min[axis] && a.now.min[axis] >= b.now.max[axis];
        let faced = shared(&a.before, &b.before) > least && shared(&a.now, &b.now) > least;
        if a.straight && b.straight && monotone && faced && (passed(a, b) || passed(b, a)) {
            let (from, to) = (a.before.centre(), a.now.centre());
            return Err(format!("{} passed through {} at {:?} on its way from {from} to {to}", a.name, b.name, b.now));
        }
    }
    Ok(())
}

/// What the place of a box may be off by, m.
fn rounding(bounds: &Aabb) -> f64 {
    ROUNDINGS * f64::EPSILON * bounds.min.abs().max(bounds.max.abs()).max_element()
}
