//! Links in a world. A linked body that touches something takes the mean force of its links over the tick as a constant one: its place is off by a
//! part (ω·dt)²/12 of the force's own way.

use crate::physics::data::domain::DefError;
use crate::physics::data::{Aabb, Pose, SLOP};
use crate::physics::flight::linked::{Linked, LinkedBodies};
use crate::physics::forces::link::{LinkDef, links_on};
use crate::physics::islands::{Members, Tick, Verdict};
use crate::physics::scratch::Scratch;
use crate::physics::state::State;
use crate::physics::store::motions::{Guide, Method};
use crate::physics::world::World;
use glam::DVec2;

impl World {
    /// Adds a link; its number is that in [`World::links`].
    ///
    /// # Errors
    /// A body that there is not, or a number that is out of its range: the links of a body may come to 10⁸ N/m and 10⁴ N·s/m per kg.
    pub fn link(&mut self, def: LinkDef) -> Result<usize, DefError> {
        def.check(&self.state.bodies, &self.state.links.all)?;
        self.state.links.all.push(def);
        self.state.links.gather();
        self.disturb_ends(&def);
        Ok(self.state.links.all.len() - 1)
    }

    /// Removes a link; those behind it move up by one number.
    pub fn unlink(&mut self, number: usize) {
        if number < self.state.links.all.len() {
            let def = self.state.links.all.remove(number);
            self.state.links.gather();
            self.disturb_ends(&def);
            for end in def.ends() {
                self.space.set_force(&self.state, end.index(), self.state.forces[end.index()].push());
            }
        }
    }

    /// All links.
    pub fn links(&self) -> &[LinkDef] {
        &self.state.links.all
    }

    fn disturb_ends(&mut self, def: &LinkDef) {
        def.ends().for_each(|body| self.disturb(body.0));
    }

    /// Flies all linked groups that are awake as if they touched nothing, but for bodies that contacts hold.
    pub(crate) fn fly_linked(&mut self, dt: f64) {
        self.scratch.linked.clear();
        self.scratch.pairs.clear();
        for g in 0..self.state.links.groups.len() {
            let group = &self.state.links.groups[g];
            if group.iter().all(|body| self.space.sleep.asleep[*body as usize]) {
                continue;
            }
            for k in 0..group.len() {
                let body = self.state.links.groups[g][k];
                if self.space.sleep.asleep[body as usize] {
                    self.disturb(body);
                }
            }
            let Self { state, scratch, space, .. } = self;
            let Scratch { linked, pairs, .. } = &mut **scratch;
            let (from, group) = (linked.len(), &state.links.groups[g]);
            pairs.extend(group.windows(2).map(|pair| (pair[0], pair[1])));
            for &id in group {
                let (body, push) = (&state.bodies[id as usize], state.forces[id as usize].push());
                let rests = body.velocity == DVec2::ZERO && body.acceleration == DVec2::ZERO;
                let held = rests && state.contacts.iter().any(|contact| contact.has(id));
                linked.push(Linked::new(body, id, held, state.media.law(body, push, dt)));
            }
            LinkedBodies { media: &state.media, bodies: &state.bodies, links: &state.links.all }.fly(&mut linked[from..], dt);
            for member in &linked[from..] {
                let i = member.id as usize;
                space.set_force(state, i, state.forces[i].push() + member.mean);
                let end = if member.held {
                    let body = &state.bodies[i];
                    let a = state.media.acceleration_under(body, state.forces[i].push() + member.mean);
                    (body.position + a * (0.5 * dt * dt), a * dt)
                } else {
                    member.pose
                };
                space.motions.guided.push((member.id, Guide { end, places: Some(member.places), ..Guide::default() }));
            }
        }
        self.scratch.linked.sort_unstable_by_key(|member| member.id);
        self.space.islands.link(&self.scratch.pairs);
    }
}

impl State {
    pub(crate) fn links_on(&self, body: u32) -> DVec2 {
        links_on(&self.links.all, body, |id| self.pose_of(id))
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
        for &id in &flown {
            let motion = &mut of.motions.bodies[id as usize];
            motion.end = scratch.linked(id).map_or(motion.free, |member| member.pose);
            (motion.method, motion.leader, motion.known) = (Method::Linked, id, true);
        }
        scratch.members.retain(|id| !flown.contains(id));
        scratch.flown = flown;
        scratch.members.is_empty().then_some(Verdict::Taken { rests: false })
    }
}
