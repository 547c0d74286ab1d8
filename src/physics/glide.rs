//! Islands that glide as one: all of them have one velocity and one acceleration along one axis, on surfaces that stand, and nothing of
//! that ends within the tick. What the contacts carry goes on then, and the way of each is its parabola: a pushed row, a crate that
//! slides. Event by event the same bits are found, body by body and pair by pair.

use super::contact::Contact;
use super::flow::parabola;
use super::pile::Store;
use super::scratch::After;
use super::tuning::SLOP;
use super::{Aabb, Body, Sides, islands::Tick};
use glam::DVec2;

/// What all of an island have in common.
#[derive(Clone, Copy)]
struct Glide {
    axis: usize,
    velocity: DVec2,
    acceleration: DVec2,
}

impl Tick<'_> {
    /// Advances the present island, near the present surfaces, if it glides. Returns whether it did.
    pub(super) fn glides(&mut self, store: &mut Store<'_>) -> bool {
        let media = self.scene.media;
        let Some(glide) = self.glide().filter(|_| self.scene.direct && media.is_bare()) else { return false };
        self.scratch.surfaces.sort_unstable();
        self.scratch.surfaces.dedup();
        self.scratch.index(self.state);
        if !self.scratch.members.iter().all(|body| self.goes_on(&glide, *body, &store.swept(*body))) {
            return false;
        }
        let (leader, count) = (self.scratch.members[0], self.scratch.members.len() as u32);
        for k in 0..self.scratch.members.len() {
            let i = self.scratch.members[k];
            let (position, velocity) = self.end(&self.state.bodies[i as usize]);
            store.bring(i, position, velocity);
            let acceleration = glide.acceleration + DVec2::ZERO;
            self.scratch.after[i as usize] = After { acceleration, known: true, members: count, leader, ..After::default() };
            let contacts = self.contacts_of(i);
            self.scratch.contacts.extend(self.state.contacts[contacts].iter().map(|contact| (leader, *contact)));
        }
        true
    }

    /// The motion that all members share, if they share one that does not turn round.
    fn glide(&self) -> Option<Glide> {
        let Self { state, scratch, .. } = self;
        let first = &state.bodies[scratch.members[0] as usize];
        let (velocity, acceleration) = (first.velocity, first.acceleration);
        let axis = usize::from(velocity.x == 0.0);
        let straight = velocity[1 - axis] == 0.0 && acceleration[1 - axis] == 0.0;
        let goes_on = velocity[axis] * (velocity[axis] + acceleration[axis] * self.scene.tick) > 0.0;
        let shares = |body: &u32| {
            let i = *body as usize;
            state.known[i] && state.bodies[i].velocity == velocity && state.bodies[i].acceleration == acceleration
        };
        (straight && goes_on && scratch.members.iter().all(shares)).then_some(Glide { axis, velocity, acceleration })
    }

    /// Where a body is when the tick ends, m, and how fast, m/s.
    fn end(&self, body: &Body) -> (DVec2, DVec2) {
        parabola((body.position, body.velocity), body.acceleration, self.scene.tick)
    }

    fn contacts_of(&self, body: u32) -> std::ops::Range<usize> {
        let starts = &self.scratch.starts;
        starts[body as usize] as usize..starts[body as usize + 1] as usize
    }

    /// Whether a body keeps its contacts and meets no surface within the tick; others were looked for in the box `searched`.
    fn goes_on(&self, glide: &Glide, body: u32, searched: &Aabb) -> bool {
        let Self { state, scratch, .. } = self;
        let of = &state.bodies[body as usize];
        let then = Aabb::around(self.end(of).0, of.half);
        let swept = of.bounds().union(&then);
        let mut rubs = 0;
        for contact in &state.contacts[self.contacts_of(body)] {
            let Some(s) = (contact.ends().1 as usize).checked_sub(state.bodies.len()) else {
                if contact.slides != 0.0 {
                    return false;
                }
                continue;
            };
            if !rubs_on(glide, contact, body) || then.gap(&state.surfaces[s].bounds)[glide.axis] >= -SLOP {
                return false;
            }
            rubs += 1;
        }
        let near = scratch.surfaces.iter().map(|s| &state.surfaces[*s as usize]).filter(|surface| surface.present);
        let mut touched = 0;
        for surface in near.filter(|surface| !surface.def.path.is_still() || swept.touches(&surface.bounds, SLOP)) {
            if !surface.def.path.is_still() || surface.belt != 0.0 || surface.def.sides != Sides::ALL {
                return false;
            }
            touched += 1;
        }
        touched == rubs && searched.contains(&swept, 0.0)
    }
}

/// Whether a contact with a surface presses, and slides as the body glides.
fn rubs_on(glide: &Glide, contact: &Contact, body: u32) -> bool {
    let along = if contact.hi == body { 1.0 } else { -1.0 };
    contact.axis != glide.axis && contact.normal > 0.0 && contact.slides == along * glide.velocity[glide.axis].signum()
}
