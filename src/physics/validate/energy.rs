//! Energy: kinetic and potential energy of an island rise in no tick by more than the work of drive, streams, fields and buoyancy.
//!
//! Springs and ropes give what they held, and what winches do. Islands that links join have one ledger. Not asked: islands in
//! which links alone lead a body, magnets, near surfaces that move, where a body crosses the border of a stream, and liquids where gravity points up.

use crate::physics::checks::{Ledger, Thing, join, rounding};
use crate::physics::data::{Aabb, BodyId, LinkLaw, MICRO_SPEED, SLOP, refill};
use crate::physics::forces::{Link, zones::feels, zones::stays};
use crate::physics::{state::Event, world::World};
use glam::DVec2;

/// m. How far from where a stream ends a body may still feel it.
const BORDER: f64 = 4.0 * SLOP;

/// m. How far a stiff link may be off after the steps of a tick.
const OFF: f64 = 1e-10;

/// The part of its energies and works that an island may gain. Flights and impacts: rounding. Smaller: `FLIGHT_TOLERANCE` in liquids shows.
const EXACT: f64 = 1e-9;
/// Contacts in liquids: the error of an implicit step whose length has a floor.
const WET: f64 = 1e-6;
/// Crowd steps in liquids, in streams and under engines: random scenes have measured 0.4.
const CROWD: f64 = 1.0;

impl World {
    pub(super) fn validate_energy(&self, bodies: &[Thing], ledgers: &mut Vec<Ledger>, moving: &mut Vec<u32>) -> Result<(), String> {
        moving.clear();
        let moves = |s: &u32| {
            let surface = &self.state.surfaces[*s as usize];
            surface.present && (surface.belt != 0.0 || !surface.def.path.is_still())
        };
        moving.extend((0..self.state.surfaces.len() as u32).filter(moves));
        // A flow whose last part was one implicit step ends slower or faster than it would.
        let ended_early = self.records.guards.flows_cut_short > self.records.flows_cut_short;
        refill(ledgers, bodies.len(), Ledger::default());
        for thing in bodies {
            let island = self.space.motions.island_of(thing.id);
            let ledger = &mut ledgers[island.unwrap_or(thing.id) as usize];
            // Within a metre.
            let beside = |s: &u32| self.state.surfaces[*s as usize].bounds.touches(&thing.swept, 1.0);
            ledger.open |= moving.iter().any(beside);
            ledger.open |= ended_early || island.is_none() && !self.flew(thing);
            let near = self.reach(thing);
            self.account(thing, &near, ledger);
            let wet = island.is_some() && self.state.media.wets(&near);
            let pushed = self.state.forces[thing.id as usize].push() != DVec2::ZERO;
            ledger.slack = ledger.slack.max(if thing.dense && (pushed || wet) {
                CROWD
            } else if wet {
                WET
            } else {
                EXACT
            });
        }
        self.account_links(ledgers);
        let more = |of: &Ledger| of.gained - of.given - of.rounding - of.slack * (of.scale + of.push);
        let found = (0..).zip(&*ledgers).find(|(_, of)| !of.open && more(of) > 0.0);
        let Some((leader, Ledger { gained, given, scale, slack, .. })) = found else { return Ok(()) };
        let allowed = format!("{given} J at most, of {scale} J in all, where a part {slack} may be");
        Err(format!("the island of body {leader} gained {gained} J, and was given {allowed}"))
    }

    /// Whether a body in no island moved as one that touches nothing: one that flew back into an island that it had left is in none.
    fn flew(&self, thing: &Thing) -> bool {
        let (before, dt) = (self.space.previous(thing.id as usize).1, self.records.dt);
        let way = thing.now.centre() - thing.before.centre();
        let (mean, change) = ((before + thing.velocity) * (0.5 * dt), (thing.velocity - before).length() * dt);
        (way - mean).length() <= 0.1 * change + rounding(&thing.swept)
    }

    /// All places that a body may have covered within the tick: a stream or a liquid may have thrown it back. Half of the tick leads it out, at no
    /// more than the speeds at both ends and the speed that its pushes, and the streams and liquids on its way, give.
    fn reach(&self, thing: &Thing) -> Aabb {
        let (i, dt, media) = (thing.id as usize, self.records.dt, &self.state.media);
        let (body, speeds) = (&self.state.bodies[i], self.space.previous(i).1.abs() + thing.velocity.abs());
        let own = self.state.forces[i].push_of_no_zone().abs() + body.mass * media.gravity_on(body).abs();
        let mut near = thing.swept;
        loop {
            let blown = |index: u32| media.streams[index as usize].on(body).abs();
            let pushed = media.streams_at(&near, BORDER).iter().fold(own, |force, index| force + blown(index));
            let wets = media.fluids.iter().filter(|fluid| fluid.zone.touches(&near, BORDER));
            let lifted: f64 = wets.map(|fluid| fluid.density * (media.gravity * thing.now.size().element_product()).abs()).sum();
            let force = pushed + DVec2::new(0.0, lifted);
            let beyond = (speeds + force * (dt / body.mass)) * (0.5 * dt);
            let wider = Aabb::new(thing.swept.min - beyond, thing.swept.max + beyond);
            // It grows until it meets no further stream or liquid.
            if near.contains(&wider, 0.0) {
                return near;
            }
            near = wider;
        }
    }

    /// Adds to the ledger of its island the energies of a body that has stayed within `near`.
    fn account(&self, thing: &Thing, near: &Aabb, ledger: &mut Ledger) {
        let (i, media) = (thing.id as usize, &self.state.media);
        let (body, before) = (&self.state.bodies[i], self.space.previous(i).1);
        let way = body.position - self.space.previous(i).0;
        if body.velocity == DVec2::ZERO && before == DVec2::ZERO && way == DVec2::ZERO {
            return;
        }
        let linked = self.scratch.linked(thing.id);
        ledger.open |= linked.is_some_and(|member| member.pose == (body.position, body.velocity));
        let mut force = self.state.forces[i].push_of_no_zone() + DVec2::new(0.0, body.mass * media.gravity_on(body));
        let mut size = force.length();
        for index in media.streams_at(near, BORDER).iter() {
            let stream = &media.streams[index as usize];
            let inside = feels(&stream.zone, body, (body.position, body.velocity));
            if inside {
                force += stream.on(body);
            }
            size += stream.on(body).length();
            // A border is crossed within the slop of where it is.
            ledger.rounding += BORDER * stream.on(body).length();
            ledger.open |= stream.blows && !stays(near, body.half, &stream.zone, inside);
        }
        let given = force.dot(way);
        let (lift, bears) = self.lift(thing, near, (before, way));
        ledger.open |= lift != 0.0 && media.gravity < 0.0;
        let speeds = before.length_squared() + body.velocity.length_squared();
        ledger.gained += 0.5 * body.mass * (body.velocity - before).dot(body.velocity + before);
        ledger.given += given + lift;
        ledger.scale += 0.5 * body.mass * speeds + size * way.length() + lift.abs();
        let most = size + bears;
        ledger.push += 0.5 * most * most * self.records.dt * self.records.dt / body.mass;
        ledger.rounding += most * rounding(&thing.swept) + body.mass * MICRO_SPEED * MICRO_SPEED;
    }

    fn account_links(&self, ledgers: &mut [Ledger]) {
        let dt = self.records.dt;
        for (number, link) in (0..).zip(&self.state.links.all) {
            let snapped = self.records.events.contains(&Event::Snapped { link: number });
            if !link.acts() && !snapped {
                continue;
            }
            let leader = |body: BodyId| self.space.motions.island_of(body.0).unwrap_or(body.0);
            let first = leader(link.def.body);
            let whole = join(ledgers, first, link.def.other().map_or(first, leader));
            let ledger = &mut ledgers[whole as usize];
            ledger.open |= matches!(link.law, LinkLaw::Magnet(_));
            let before = link.sooner(dt, dt);
            let [from, to] = [self.length_of(link, true), self.length_of(link, false)];
            let held = before.law.energy(from);
            let holds = if snapped { 0.0 } else { link.law.energy(to) };
            // What a winch does is its way times no more than the greater one of its forces.
            let force = |length: f64| link.law.rates()[0] * (length - link.law.length().unwrap_or(length)).abs();
            let wound =
                link.growth(dt).abs() * dt * (force(from).max(force(to)) + link.law.rates()[0] * link.growth(dt).abs() * dt);
            ledger.given += held - holds + wound;
            ledger.scale += held + holds + wound;
            ledger.rounding += force(from).max(force(to)) * OFF;
        }
    }

    /// The distance of the ends of a link, as the tick began or now, m.
    fn length_of(&self, link: &Link, before: bool) -> f64 {
        let pose = |id: u32| if before { self.space.previous(id as usize) } else { self.state.pose_of(id) };
        link.def.apart(pose).0.length()
    }

    /// The most that buoyancy can have given a body on its way, J, and its largest force, N.
    fn lift(&self, thing: &Thing, within: &Aabb, (before, way): (DVec2, DVec2)) -> (f64, f64) {
        let media = &self.state.media;
        let (up, down) = ((-way.y).max(0.0), way.y.max(0.0));
        let beyond = (before.y.abs() + thing.velocity.y.abs()) * self.records.dt;
        let near = media.fluids.iter().filter(|fluid| fluid.zone.touches(within, 0.0));
        near.map(|fluid| {
            let shared = |of: &Aabb| (of.max.min(fluid.zone.max) - of.min.max(fluid.zone.min)).max(DVec2::ZERO);
            let area = |of: &Aabb| shared(of).x * shared(of).y;
            let widest = shared(within).min(thing.now.size());
            let (least, most) = (area(&thing.before).min(area(&thing.now)), widest.x * widest.y);
            let heavy = fluid.density * media.gravity;
            (heavy * (most * up - least * down + (most - least) * beyond), (heavy * most).abs())
        })
        .fold((0.0, 0.0), |(work, force), (w, f)| (work + w, force + f))
    }
}
