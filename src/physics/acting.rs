//! What acts on each body as a tick begins, as the store is told: a constant force, or, near liquids and the borders of streams, where the
//! body gets by the end of the tick if it touches nothing. What comes near nothing else has then ended its tick.

use super::events::{BUDGET_OF_A_FLIGHT, Scene};
use super::flow::{Pose, flow};
use super::media::Media;
use super::pile::Pile;
use super::scratch::Scratch;
use super::tuning::SLOP;
use super::world::{State, World};
use super::zones::Around;
use super::{Aabb, Body};
use glam::DVec2;

impl World {
    /// Tells the store what acts on each body besides its weight and the air, and where it gets where no constant force says that.
    pub(super) fn say_what_acts(&mut self, dt: f64) {
        let Self { state, plan, scratch, pile, .. } = self;
        let scene = Scene::of(state, plan, dt);
        let mut awake = std::mem::take(&mut scratch.awake);
        awake.clear();
        awake.extend(pile.looked_at().iter().filter(|body| !pile.is_sleeping(**body as usize)));
        for &i in &awake {
            let i = i as usize;
            let body = &state.bodies[i];
            let mut force = state.drives[i];
            let mut at_a_border = false;
            if plan.streams {
                (force, at_a_border) = streams_on(state, scratch, i, dt);
            }
            pile.set_force(i, force);
            if body.velocity == DVec2::ZERO && body.acceleration == DVec2::ZERO {
                if plan.media() {
                    let free = hold(&state.media, pile, i, (body, force), dt);
                    scratch.floats[i] = free && (plan.liquids || plan.streams);
                }
            } else if plan.liquids || at_a_border {
                let law = state.media.law(body, force, dt);
                if law.is_near_liquid() || at_a_border {
                    state.media.allow(BUDGET_OF_A_FLIGHT);
                    let mut end = flow(&state.media, body, &law, dt);
                    if at_a_border && scratch.around[i].crosses(&state.media, body, end, dt) {
                        end = fly(state, scratch, &scene, i);
                    }
                    pile.guide(i, end.0, end.1);
                }
            }
        }
        scratch.awake = awake;
    }
}

/// Notes the streams around a body in `scratch`. Returns the force on it (N), and whether it may cross the border of one within the tick.
fn streams_on(state: &State, scratch: &mut Scratch, i: usize, dt: f64) -> (DVec2, bool) {
    let (body, media, near) = (&state.bodies[i], &state.media, reach(state, i, dt));
    let around = Around::of(media, near);
    let borders = |zone: &Aabb| zone.touches(&near, SLOP) && !zone.contains(&near, 0.0);
    let at_a_border = around.streams(media).any(|stream| borders(&stream.zone));
    let force = around.force_on(media, body, state.drives[i]);
    scratch.note_around(i, around);
    (force, at_a_border)
}

/// Where a body may get within the tick.
fn reach(state: &State, i: usize, dt: f64) -> Aabb {
    let body = &state.bodies[i];
    let pull = body.acceleration.abs() + state.drives[i].abs() / body.mass + state.media.gravity.abs();
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

/// What is held meets no drag on a way that it does not go: its contacts have to bear all that pulls at it. Returns whether nothing does.
fn hold(media: &Media, pile: &mut Pile, i: usize, (body, force): (&Body, DVec2), dt: f64) -> bool {
    // It stands still.
    let a = media.acceleration_under(body, force);
    pile.guide(i, body.position + a * (0.5 * dt * dt), a * dt);
    a == DVec2::ZERO
}
