//! What acts on each body as a tick begins, as the store is told: a constant force, or, near liquids and the borders of streams, where the
//! body gets by the end of the tick if it touches nothing. What comes near nothing else has then ended its tick.

use super::ahead::Ahead;
use super::events::{BUDGET_OF_A_FLIGHT, BUDGET_OF_A_FLOW, Scene};
use super::flow::{Course, Pose, flow_through};
use super::media::Media;
use super::pile::Pile;
use super::scratch::Scratch;
use super::tuning::SLOP;
use super::world::{State, World};
use super::zones::Around;
use super::{Aabb, Body};
use glam::DVec2;

/// How many times as far around a body as it may get within a tick its streams are sought. Farther: more of them are looked at in each tick;
/// less far: they are sought more often.
const WIDER: f64 = 1.5;

impl World {
    /// Tells the store what acts on each body besides its weight and the air, and where it gets where no constant force says that.
    pub(super) fn say_what_acts(&mut self, dt: f64) {
        let Self { state, plan, scratch, pile, .. } = self;
        let mut ahead = std::mem::take(&mut state.ahead);
        if plan.liquids {
            ahead.resize_with(state.bodies.len(), Ahead::default);
        }
        let scene = Scene::of(state, plan, dt);
        let mut awake = std::mem::take(&mut scratch.awake);
        awake.clear();
        awake.extend(pile.looked_at().iter().filter(|body| !pile.is_sleeping(**body as usize)));
        if plan.liquids {
            note_touched(state, &mut scratch.touches);
        }
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
                let course = match ahead.get_mut(i).filter(|_| !at_a_border) {
                    Some(ahead) => {
                        let Found { course, roughly } = swim(&state.media, ahead, (body, force), scratch.touches[i], dt);
                        scratch.roughly[i] = roughly;
                        course
                    }
                    None => {
                        state.media.allow(BUDGET_OF_A_FLIGHT);
                        Some(flow_through(&state.media, body, &state.media.law(body, force, dt), dt))
                    }
                };
                let Some(Course { mut end, pull, .. }) = course else { continue };
                scratch.pulls[i] = pull.filter(|_| !at_a_border);
                if at_a_border && scratch.around[i].crosses(&state.media, body, end, dt) {
                    end = fly(state, scratch, &scene, i);
                }
                pile.guide(i, end.0, end.1);
            }
        }
        scratch.awake = awake;
        state.ahead = ahead;
    }
}

/// Notes who begins the tick in contact with something.
fn note_touched(state: &State, touches: &mut Vec<bool>) {
    touches.clear();
    touches.resize(state.bodies.len() + state.surfaces.len(), false);
    for contact in &state.contacts {
        (touches[contact.lo as usize], touches[contact.hi as usize]) = (true, true);
    }
}

/// Where a body gets near a liquid, if there is one, and whether that is known roughly only.
struct Found {
    course: Option<Course>,
    roughly: bool,
}

/// Where a body under a `force` (N) gets in a tick of `t` seconds near a liquid. What touches something is in an island, which finds out where it
/// gets: all that is asked for is about whom it may meet. So it is with what was in one before; if it is alone now, that is found out then
/// (`islands`).
fn swim(media: &Media, ahead: &mut Ahead, (body, force): (&Body, DVec2), touches: bool, t: f64) -> Found {
    if !touches && let Some(course) = ahead.follow(media, body, force, t) {
        return Found { course: Some(course), roughly: false };
    }
    media.renew(&mut ahead.law, body, force, t);
    if !ahead.law.is_near_liquid() {
        return Found { course: None, roughly: false };
    }
    if touches || !ahead.alone {
        media.allow_roughly(BUDGET_OF_A_FLOW);
        return Found { course: Some(ahead.flow(media, body, t)), roughly: true };
    }
    media.allow(BUDGET_OF_A_FLIGHT);
    let course = ahead.begin(media, body, force, t).unwrap_or_else(|| ahead.flow(media, body, t));
    Found { course: Some(course), roughly: false }
}

/// Notes the streams around a body in `scratch`. Returns the force on it (N), and whether it may cross the border of one within the tick.
fn streams_on(state: &State, scratch: &mut Scratch, i: usize, dt: f64) -> (DVec2, bool) {
    let (body, media, near) = (&state.bodies[i], &state.media, reach(state, i, dt));
    let around = scratch.around(i);
    if !around.knows(&near) {
        *around = Around::of(media, Aabb::around(near.centre(), near.size() * (0.5 * WIDER)));
    }
    let borders = |zone: &Aabb| zone.touches(&near, SLOP) && !zone.contains(&near, 0.0);
    let at_a_border = around.streams(media).any(|stream| borders(&stream.zone));
    (around.force_on(media, body, state.drives[i]), at_a_border)
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
