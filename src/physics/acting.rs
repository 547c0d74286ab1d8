//! What acts on each body as a tick begins: a constant force, or, near liquids and borders of streams, its flight if it touches nothing.

use crate::physics::data::{Aabb, Pose, SLOP, refill};
use crate::physics::flight::{liquid::flow, liquid::flow_side_by_side, steps::Course};
use crate::physics::{exact::Scene, forces::Law, scratch::Scratch, state::State, store::motions::Guide, world::World};
use glam::DVec2;

impl World {
    /// Sets the force on each body besides its weight and the air, and its flight where no constant force describes that.
    pub(crate) fn say_what_acts(&mut self, dt: f64) {
        if !self.plan.media() {
            // Each change of a constant push reaches the store as it happens.
            return;
        }
        let Self { state, plan, scratch, space, .. } = self;
        let mut awake = std::mem::take(&mut scratch.awake);
        awake.clear();
        awake.extend(space.sleep.looked_at.iter().filter(|body| !space.sleep.asleep[**body as usize]));
        if plan.liquids || plan.streams {
            scratch.laws.resize(state.bodies.len(), Law::default());
        }
        scratch.swimming.clear();
        let touches = &mut scratch.touches;
        refill(touches, state.bodies.len() + state.surfaces.len(), false);
        for contact in &state.contacts {
            (touches[contact.lo as usize], touches[contact.hi as usize]) = (true, true);
        }
        for i in awake.iter().map(|i| *i as usize) {
            if scratch.linked(i as u32).is_some() {
                continue;
            }
            let at_a_border = plan.streams && streams_on(state, i, dt);
            let (body, force) = (&state.bodies[i], state.forces[i].push());
            if plan.streams {
                space.set_force(state, i, force);
            }
            let stands = body.velocity == DVec2::ZERO && body.acceleration == DVec2::ZERO;
            let begins = stands.then(|| state.media.acceleration_under(body, force));
            if let Some(a) = begins.filter(|a| scratch.touches[i] || *a == DVec2::ZERO) {
                // A body that stands meets no drag: its contacts bear all that pulls at it.
                let floats = a == DVec2::ZERO && (plan.liquids || plan.streams);
                let end = (body.position + a * (0.5 * dt * dt), a * dt);
                space.motions.guided.push((i as u32, Guide { end, floats, ..Guide::default() }));
            } else if plan.liquids || at_a_border {
                let law = &mut scratch.laws[i];
                state.media.renew(law, body, force, dt);
                if !at_a_border && law.is_near_liquid() {
                    // An island finds the end of a body that touches something.
                    law.rough = scratch.touches[i];
                    scratch.swimming.push(i as u32);
                } else if at_a_border {
                    law.rough = false;
                    let mut end = flow(&state.media, body, law, dt);
                    if state.media.crosses_border(body, end, dt) {
                        end = fly(state, scratch, &Scene::of(state, plan, dt), i);
                    }
                    space.motions.guided.push((i as u32, Guide { end, ..Guide::default() }));
                }
            }
        }
        let Scratch { swimming, laws, .. } = &**scratch;
        flow_side_by_side(&state.media, swimming, (&state.bodies, laws), dt, |i, Course { end, pull, .. }| {
            let roughly = laws[i as usize].rough;
            space.motions.guided.push((i, Guide { end, pull, roughly, ..Guide::default() }));
        });
        scratch.awake = awake;
    }

    /// Lets streams and fields enter and leave the force managers of all bodies.
    pub(crate) fn feel_zones(&mut self) {
        let State { bodies, forces, media, .. } = &mut self.state;
        if self.plan.streams {
            bodies.iter().zip(forces).for_each(|(body, forces)| media.feel(body, forces));
        }
    }
}

/// Lets a body feel the streams. Returns whether it may cross the border of one within the tick.
fn streams_on(state: &mut State, i: usize, dt: f64) -> bool {
    let near = reach(state, i, dt);
    state.media.feel(&state.bodies[i], &mut state.forces[i]);
    let borders = |zone: &Aabb| zone.touches(&near, SLOP) && !zone.contains(&near, 0.0);
    state.media.streams.iter().any(|stream| borders(&stream.zone))
}

fn reach(state: &State, i: usize, dt: f64) -> Aabb {
    let body = &state.bodies[i];
    let pull = body.acceleration.abs() + state.forces[i].push_of_no_zone().abs() / body.mass + state.media.gravity.abs();
    Aabb::around(body.position, body.half * 1.5 + (body.velocity.abs() + pull * dt) * dt)
}

fn fly(state: &State, scratch: &mut Scratch, scene: &Scene, i: usize) -> Pose {
    let near = reach(state, i, scene.tick);
    scratch.members.clear();
    scratch.surfaces.clear();
    scratch.members.push(i as u32);
    scratch.gather(state, scene, |_| near);
    scratch.events.fly(scene)
}
