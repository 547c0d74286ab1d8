//! Links in a world. Linked bodies near nothing fly together, others go from event to event. A tick goes in the parts that stiff links need.

use crate::physics::data::{Aabb, BodyId, Contact, LinkDef, LinkEnd, Obstacle, Part, Pose, SLOP, called};
use crate::physics::data::{domain::DefError, on_axis};
use crate::physics::flight::linked::{Linked, LinkedBodies, little};
use crate::physics::forces::{Force, ForceManager, Source, link::Link};
use crate::physics::islands::{Members, Tick, Verdict};
use crate::physics::{exact::item::Item, exact::item::Travel, scratch::Scratch, state::Event, state::State, store::motions::Guide};
use crate::physics::{store::motions::Method, world::World};
use glam::DVec2;

impl World {
    /// Adds a link; its number is that in [`World::links`].
    ///
    /// # Errors
    /// A body that there is not, or a number that is out of its range: the links of a body may come to 10⁷ N/m and 10⁴ N·s/m per kg.
    pub fn link(&mut self, def: LinkDef) -> Result<usize, DefError> {
        let number = self.state.links.all.len();
        let link = Link::new(def, &self.state.bodies, &self.state.links.all)?;
        self.state.links.all.push(link);
        self.plan.links = true;
        self.relink(number);
        Ok(number)
    }

    /// Removes a link; those behind it move up by one number.
    pub fn unlink(&mut self, number: usize) {
        if number < self.state.links.all.len() {
            self.set_linked(number, false);
            self.state.links.all.remove(number);
        }
    }

    /// Lets a link act, or lets its ends go: one that waits for a touch waits again then.
    pub fn set_linked(&mut self, number: usize, on: bool) {
        let link = &mut self.state.links.all[number];
        if link.on != on {
            (link.on, link.begun) = (on, !link.def.hook);
            self.relink(number);
        }
    }

    /// Lets the length of a link grow by its rate, or stay.
    pub fn set_winding(&mut self, number: usize, winds: bool) {
        self.state.links.all[number].winds = winds;
    }

    /// All links.
    pub fn links(&self) -> &[Link] {
        &self.state.links.all
    }

    /// The present ends of a link, m.
    pub fn link_ends(&self, link: &Link) -> [DVec2; 2] {
        let from = self.body(link.def.body).position;
        [from, from + link.def.apart(|id| self.state.pose_of(id)).0]
    }

    /// Wakes the ends of a link that has changed.
    fn relink(&mut self, number: usize) {
        self.state.links.gather();
        let def = self.state.links.all[number].def;
        for end in def.ends() {
            self.disturb(end.0);
            self.space.set_force(&self.state, end.index(), self.state.forces[end.index()].push());
        }
    }

    /// Flies all linked groups, unless all bodies sleep, as if they touched nothing, but for bodies that contacts hold.
    pub(crate) fn fly_linked(&mut self, dt: f64) {
        called(Part::Links);
        self.scratch.linked.clear();
        self.scratch.pairs.clear();
        // What is awake may reach a group that sleeps, and its links fly from the start of a tick.
        let flies = !self.space.sleep.all_asleep() || self.state.links.all.iter().any(|link| link.growth(dt) != 0.0);
        for g in 0..if flies { self.state.links.groups.len() } else { 0 } {
            let group = self.state.links.groups[g].0..self.state.links.groups[g].1;
            let from = self.scratch.linked.len();
            for k in group.clone() {
                let body = self.state.links.members[k];
                if self.space.sleep.asleep[body as usize] {
                    self.disturb(body);
                }
                let linked = self.state.linked(body, dt);
                self.scratch.linked.push(linked);
            }
            self.scratch.pairs.extend(self.state.links.members[group].windows(2).map(|pair| (pair[0], pair[1])));
            self.fly_group(from, dt);
        }
        self.scratch.linked.sort_unstable_by_key(|member| member.id);
        self.space.islands.link(&self.scratch.pairs);
        for (number, link) in (0..).zip(&mut self.state.links.all) {
            // One that has broken on the way that touches nothing may hold on another.
            let broken = link.broken && !self.scratch.snapped.contains(&number);
            let growth = Link { broken, ..*link }.growth(dt);
            link.law = link.law.length().map_or(link.law, |length| link.law.of_length(length + growth * dt));
        }
    }

    fn fly_group(&mut self, from: usize, dt: f64) {
        let Self { state, scratch, space, .. } = self;
        let Scratch { linked, pulls, snapped, .. } = &mut **scratch;
        let State { media, bodies, links, .. } = &*state;
        LinkedBodies { media, bodies, links: &links.all, members: &mut linked[from..], pulls, tick: dt, now: 0.0 }.fly();
        for pull in pulls.iter().filter(|pull| pull.broken) {
            state.links.all[pull.link as usize].broken = true;
            snapped.push(pull.link);
        }
        for member in &linked[from..] {
            let (i, force) = (member.id as usize, state.forces[member.id as usize].push() + member.mean);
            space.set_force(state, i, force);
            let end = if member.held {
                let body = &state.bodies[i];
                let a = state.media.acceleration_under(body, force);
                (body.position + a * (0.5 * dt * dt), a * dt)
            } else {
                member.pose
            };
            let floats = member.rests && !member.held;
            space.motions.guided.push((member.id, Guide { end, places: Some(member.places), floats, ..Guide::default() }));
        }
    }

    /// After a tick: the ends of broken links are free, and hooks take hold of what they have touched.
    pub(crate) fn tend_links(&mut self) {
        while let Some(link) = self.scratch.snapped.pop() {
            self.records.events.push(Event::Snapped { link });
            self.relink(link as usize);
        }
        for number in 0..self.state.links.all.len() {
            let mut link = self.state.links.all[number];
            if link.on && !link.begun && !link.broken && self.touches(&link.def) {
                link.begin(|id| self.state.pose_of(id));
                self.state.links.all[number] = link;
                self.records.events.push(Event::Hooked { link: number as u32 });
                self.relink(number);
            }
        }
    }

    /// Whether the ends of a link touch, or have hit each other in the last tick.
    fn touches(&self, def: &LinkDef) -> bool {
        let bounds = self.body(def.body).bounds();
        match def.to {
            LinkEnd::Place(place) => bounds.touches(&Aabb::around(place, DVec2::ZERO), SLOP),
            LinkEnd::Body(other) => {
                let hit = |a: BodyId, b: BodyId| self.records.impulses.iter().any(|hit| hit.a == a && hit.b == Obstacle::Body(b));
                bounds.touches(&self.body(other).bounds(), SLOP) || hit(def.body, other) || hit(other, def.body)
            }
        }
    }

    /// Lists the forces of the links of a body. At rest the rounding of its place is no force.
    pub(crate) fn list_links(&self, id: BodyId, forces: &mut ForceManager) {
        let (state, body) = (&self.state, self.body(id));
        let rests = body.velocity == DVec2::ZERO && body.acceleration == DVec2::ZERO;
        for (number, link) in (0..).zip(&state.links.all).filter(|(_, link)| link.acts_on(id.0)) {
            let vector = link.on(id.0, |id| state.pose_of(id));
            if !rests || vector.length() > little(link.law.rates()[0], body.position) {
                forces.list(Force { kind: link.law.kind(), source: Source::Link(number), vector, point: body.position });
            }
        }
    }
}

impl State {
    /// A linked body at the start of a tick. One that touches something without being held flies as under the forces of its contacts.
    fn linked(&self, id: u32, dt: f64) -> Linked {
        let (body, push) = (&self.bodies[id as usize], self.forces[id as usize].push());
        let rests = body.velocity == DVec2::ZERO && body.acceleration == DVec2::ZERO;
        let contacts = || self.contacts.iter().filter(|contact| contact.has(id));
        let held = rests && contacts().next().is_some();
        let borne = |sum, contact: &Contact| {
            let sign = if contact.hi == id { 1.0 } else { -1.0 };
            sum + on_axis(contact.axis, contact.normal, contact.friction) * sign
        };
        let law = self.media.law(body, contacts().fold(push, borne), dt);
        Linked::new(body, id, held, law)
    }

    pub(crate) fn pose_of(&self, id: u32) -> Pose {
        let body = &self.bodies[id as usize];
        (body.position, body.velocity)
    }
}

impl Scratch {
    pub(crate) fn linked(&self, body: u32) -> Option<&Linked> {
        self.linked.binary_search_by_key(&body, |member| member.id).ok().map(|at| &self.linked[at])
    }

    /// Stops the island of the method of events where it hangs on links that balance, and hardly moves.
    pub(crate) fn stop_on_links(&mut self, state: &State) {
        let of_item = |id: u32| self.linked(id).filter(|member| member.rests);
        let items = &self.events.items[..self.events.movable];
        let hang = || items.iter().filter_map(|item| of_item(item.id));
        let least = hang().map(|member| member.least).reduce(|a, b| (a.0.min(b.0), a.1.min(b.1)));
        let Some((force, speed)) = least.filter(|_| !self.events.hits.iter().any(|hit| hit.impulse.impact)) else { return };
        let stands = |item: &Item| {
            let before = state.bodies[item.id as usize].velocity;
            let flies = self.linked(item.id).is_some_and(|member| !member.rests);
            let slow = before.length().max(item.body.velocity.length()) <= speed;
            slow && !flies && (item.solved * item.body.mass).length() <= force
        };
        if items.iter().all(stands) {
            for item in &mut self.events.items[..self.events.movable] {
                (item.body.position, item.body.velocity) = (state.bodies[item.id as usize].position, DVec2::ZERO);
                (item.solved, item.motion) = (DVec2::ZERO, Travel::Still);
            }
        }
    }

    /// Whether all bodies rest that links alone hold.
    pub(crate) fn flown_rest(&self) -> bool {
        self.flown.iter().all(|id| self.linked(*id).is_some_and(|member| member.rests))
    }
}

impl Tick<'_> {
    /// Takes linked bodies that come near nothing out of the island: they fly together. Returns a verdict if no member is left.
    pub(crate) fn leave_linked(&mut self, of: &mut Members<'_>) -> Option<Verdict> {
        if self.scratch.linked.is_empty() {
            return None;
        }
        let mut flown = std::mem::take(&mut self.scratch.flown);
        let Self { scratch, state, scene, .. } = self;
        let near = |swept: &Aabb, s: u32| state.surfaces[s as usize].swept(scene.tick).touches(swept, SLOP);
        let apart = |id: u32| {
            let swept = of.motions.swept[id as usize];
            scratch.linked(id).is_some_and(|member| !member.held)
                && !scratch.surfaces.iter().any(|s| near(&swept, *s))
                && scratch.members.iter().all(|other| *other == id || !of.motions.swept[*other as usize].touches(&swept, SLOP))
        };
        flown.clear();
        flown.extend(scratch.members.iter().filter(|id| apart(**id)));
        // Where one of them comes near something all go from event to event.
        if scratch.members.iter().any(|id| scratch.linked(*id).is_some() && !flown.contains(id)) {
            flown.clear();
        }
        for &id in &flown {
            let motion = &mut of.motions.bodies[id as usize];
            motion.end = scratch.linked(id).map_or(motion.free, |member| member.pose);
            (motion.method, motion.leader, motion.known) = (Method::Linked, id, true);
        }
        scratch.members.retain(|id| !flown.contains(id));
        scratch.flown = flown;
        let rests = scene.plan.direct && scratch.flown_rest();
        scratch.members.is_empty().then_some(Verdict::Taken { rests })
    }
}
