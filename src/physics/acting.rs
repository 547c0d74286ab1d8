//! The action on each body as a tick begins, for the store: a constant force, or, near liquids and the borders of streams, the pose at the
//! end of the tick if the body touches nothing. A body that comes near no other has then ended its tick.

use crate::physics::data::lists::refill;
use crate::physics::data::tuning::SLOP;
use crate::physics::data::{Aabb, Pose};
use crate::physics::exact::Scene;
use crate::physics::flight::flow::flow_through;
use crate::physics::flight::steps::Course;
use crate::physics::scratch::Scratch;
use crate::physics::state::State;
use crate::physics::world::World;
use glam::DVec2;

impl World {
    /// Tells the store what acts on each body besides its weight and the air, and where it gets where no constant force says that.
    pub(crate) fn say_what_acts(&mut self, dt: f64) {
        if !self.plan.media() {
            // Each change of a constant push is handed to the store as it happens.
            return;
        }
        let Self { state, plan, scratch, space, .. } = self;
        let mut awake = std::mem::take(&mut scratch.awake);
        awake.clear();
        awake.extend(space.sleep.looked_at().iter().filter(|body| !space.sleep.sleeps(**body as usize)));
        if plan.liquids {
            note_touched(state, &mut scratch.touches);
        }
        for &i in &awake {
            let i = i as usize;
            if scratch.linked(i as u32).is_some() {
                continue;
            }
            let at_a_border = plan.streams && streams_on(state, i, dt);
            let (body, force) = (&state.bodies[i], state.forces[i].push());
            if plan.streams {
                space.set_force(state, i, force);
            }
            if body.velocity == DVec2::ZERO && body.acceleration == DVec2::ZERO {
                // What stands meets no drag on a way that it does not go: its contacts have to bear all that pulls at it.
                let a = state.media.acceleration_under(body, force);
                space.guide(i, (body.position + a * (0.5 * dt * dt), a * dt));
                scratch.floats[i] = a == DVec2::ZERO && (plan.liquids || plan.streams);
            } else if plan.liquids || at_a_border {
                let mut law = state.media.law(body, force, dt);
                if !at_a_border && !law.is_near_liquid() {
                    continue;
                }
                // A body that touches something is in an island, which finds out where it gets: here only the bodies that it may meet matter.
                scratch.roughly[i] = !at_a_border && scratch.touches[i];
                law.rough = scratch.roughly[i];
                let Course { mut end, pull, .. } = flow_through(&state.media, body, &law, dt);
                scratch.pulls[i] = pull.filter(|_| !at_a_border);
                if at_a_border && state.media.crosses_border(body, end, dt) {
                    end = fly(state, scratch, &Scene::of(state, plan, dt), i);
                }
                space.guide(i, end);
            }
        }
        scratch.awake = awake;
    }
}

impl World {
    /// Lets streams and fields enter and leave the force managers of all bodies where they are.
    pub(crate) fn feel_zones(&mut self) {
        let State { bodies, forces, media, .. } = &mut self.state;
        if self.plan.streams {
            bodies.iter().zip(forces).for_each(|(body, forces)| media.feel(body, forces));
        }
    }
}

/// Notes who begins the tick in contact with something.
fn note_touched(state: &State, touches: &mut Vec<bool>) {
    refill(touches, state.bodies.len() + state.surfaces.len(), false);
    for contact in &state.contacts {
        (touches[contact.lo as usize], touches[contact.hi as usize]) = (true, true);
    }
}

/// Lets a body feel the streams where it is. Returns whether it may cross the border of one within the tick.
fn streams_on(state: &mut State, i: usize, dt: f64) -> bool {
    let near = reach(state, i, dt);
    state.media.feel(&state.bodies[i], &mut state.forces[i]);
    let borders = |zone: &Aabb| zone.touches(&near, SLOP) && !zone.contains(&near, 0.0);
    state.media.streams.iter().any(|stream| borders(&stream.zone))
}

/// Where a body may get within the tick.
fn reach(state: &State, i: usize, dt: f64) -> Aabb {
    let body = &state.bodies[i];
    let pull = body.acceleration.abs() + state.forces[i].push_of_no_zone().abs() / body.mass + state.media.gravity.abs();
    Aabb::around(body.position, body.half * 1.5 + (body.velocity.abs() + pull * dt) * dt)
}

/// Where a body gets through the streams that it enters and leaves, from one border to the next.
fn fly(state: &State, scratch: &mut Scratch, scene: &Scene, i: usize) -> Pose {
    let near = reach(state, i, scene.tick);
    scratch.members.clear();
    scratch.surfaces.clear();
    scratch.members.push(i as u32);
    scratch.gather(state, scene, |_| near);
    scratch.events.fly(scene)
}
