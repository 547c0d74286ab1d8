//! Energy: kinetic and potential energy of an island rise in no tick by more than the work of drive, streams, fields and buoyancy.
//!
//! Not asked: islands with links, near surfaces that move, where a body crosses the border of a stream within the tick, and liquids under a gravity
//! that points up.

use crate::physics::checks::{Ledger, Thing, rounding};
use crate::physics::data::aabb::Aabb;
use crate::physics::data::tuning::{MICRO_SPEED, SLOP};
use crate::physics::forces::zones::{feels, stays};
use crate::physics::world::World;
use glam::DVec2;

/// m. How far from where a stream ends a body may still feel it.
const BORDER: f64 = 4.0 * SLOP;

impl World {
    /// No island has gained more energy than it was given.
    pub(super) fn validate_energy(&self, bodies: &[Thing], ledgers: &mut Vec<Ledger>, moving: &mut Vec<u32>) -> Result<(), String> {
        moving.clear();
        let moves = |s: &u32| {
            let surface = &self.state.surfaces[*s as usize];
            surface.present && (surface.belt != 0.0 || !surface.def.path.is_still())
        };
        moving.extend((0..self.state.surfaces.len() as u32).filter(moves));
        // A flow whose last part was one implicit step ends slower or faster than it would.
        let ended_early = self.records.guards.flows_cut_short > self.records.flows_cut_short;
        ledgers.clear();
        ledgers.resize(bodies.len(), Ledger::default());
        for thing in bodies {
            let island = self.scratch.after.get(thing.id as usize).filter(|after| after.members > 0);
            let ledger = &mut ledgers[island.map_or(thing.id, |after| after.leader) as usize];
            // Within a metre.
            let beside = |s: &u32| self.state.surfaces[*s as usize].bounds.touches(&thing.swept, 1.0);
            ledger.open |= moving.iter().any(beside);
            ledger.rough |= thing.dense;
            ledger.open |= ended_early || island.is_none() && !self.flew(thing);
            self.account(thing, ledger);
            ledger.rough |= island.is_some() && self.state.media.wets(&thing.swept);
        }
        // What rounding and the error of flights through liquids add; and the crowd's step, and implicit steps of what is in contact in a liquid, of
        // which the tests have measured 0.6 at most.
        let slack = |of: &Ledger| if of.rough { of.scale + of.push } else { 1e-9 * of.scale };
        let more = |of: &Ledger| of.gained - of.given - of.rounding - slack(of);
        match (0..).zip(&*ledgers).find(|(_, of)| !of.open && more(of) > 0.0) {
            Some((leader, of)) => Err(format!(
                "the island of body {leader} gained {} J, and was given {} J at most, of {} J in all{}",
                of.gained,
                of.given,
                of.scale,
                if of.rough { ", in rough steps" } else { "" }
            )),
            None => Ok(()),
        }
    }

    /// Whether a body that is in no island moved as one that touches nothing does. (What grew out of its island, and flew back, is in none.)
    fn flew(&self, thing: &Thing) -> bool {
        let (before, dt) = (self.pile.previous_velocity(thing.id as usize), self.records.dt);
        let way = thing.now.centre() - thing.before.centre();
        let (mean, change) = ((before + thing.velocity) * (0.5 * dt), (thing.velocity - before).length() * dt);
        (way - mean).length() <= 0.1 * change + rounding(&thing.swept)
    }

    /// Adds what a tick did to a body.
    fn account(&self, thing: &Thing, ledger: &mut Ledger) {
        let (i, media) = (thing.id as usize, &self.state.media);
        let (body, before) = (&self.state.bodies[i], self.pile.previous_velocity(i));
        let way = body.position - self.pile.previous(i);
        if body.velocity == DVec2::ZERO && before == DVec2::ZERO && way == DVec2::ZERO {
            return;
        }
        ledger.open |= self.state.links.all.iter().any(|link| link.has(thing.id));
        let mut force = self.state.forces[i].push_of_no_zone() + DVec2::new(0.0, body.mass * media.gravity_on(body));
        let mut size = force.length();
        for index in media.streams_at(&thing.swept, BORDER).iter() {
            let stream = &media.streams[index as usize];
            let inside = feels(&stream.zone, body, (body.position, body.velocity));
            if inside {
                force += stream.on(body);
            }
            size += stream.on(body).length();
            // A border is crossed within the slop of where it is.
            ledger.rounding += BORDER * stream.on(body).length();
            ledger.open |= stream.blows && !stays(&thing.swept, body.half, &stream.zone, inside);
        }
        let given = force.dot(way);
        let lift = self.lift(thing, (before, way));
        ledger.open |= lift != 0.0 && media.gravity < 0.0;
        let speeds = before.length_squared() + body.velocity.length_squared();
        ledger.gained += 0.5 * body.mass * (body.velocity - before).dot(body.velocity + before);
        ledger.given += given + lift;
        ledger.scale += 0.5 * body.mass * speeds + size * way.length() + lift.abs();
        let most = (size + lift.abs() / way.length().max(1e-9)) * self.records.dt;
        ledger.push += 0.5 * most * most / body.mass;
        ledger.rounding += size * rounding(&thing.swept) + body.mass * MICRO_SPEED * MICRO_SPEED;
    }

    /// The most that buoyancy can have given a body on its way, J.
    fn lift(&self, thing: &Thing, (before, way): (DVec2, DVec2)) -> f64 {
        let media = &self.state.media;
        let (up, down) = ((-way.y).max(0.0), way.y.max(0.0));
        let beyond = (before.y.abs() + thing.velocity.y.abs()) * self.records.dt;
        let near = media.fluids.iter().filter(|fluid| fluid.zone.touches(&thing.swept, 0.0));
        near.map(|fluid| {
            let shared = |of: &Aabb| (of.max.min(fluid.zone.max) - of.min.max(fluid.zone.min)).max(DVec2::ZERO);
            let area = |of: &Aabb| shared(of).x * shared(of).y;
            let widest = shared(&thing.swept).min(thing.now.size());
            let (least, most) = (area(&thing.before).min(area(&thing.now)), widest.x * widest.y);
            fluid.density * media.gravity * (most * up - least * down + (most - least) * beyond)
        })
        .sum()
    }
}
