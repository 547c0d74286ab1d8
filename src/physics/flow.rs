//! The motion of one body through media, without contacts: as exact as it can be had at each cost.
//!
//! Nothing that depends on velocity or place: the parabola, exact at any step. Air alone: [`super::air`]. Near a liquid: [`super::liquid`].

use super::Body;
use super::air::fly_through;
use super::liquid::swim;
use super::media::{Law, Media};
use glam::DVec2;

/// Place and velocity.
pub(super) type Pose = (DVec2, DVec2);

/// Uniformly accelerated motion for `t` seconds.
pub(super) fn parabola((x, v): Pose, a: DVec2, t: f64) -> Pose {
    (x + (v * t + a * (0.5 * t * t)), v + a * t)
}

/// Where `body` is after `t` seconds under `law`.
pub(super) fn flow(media: &Media, body: &Body, law: &Law, t: f64) -> Pose {
    let pose = (body.position, body.velocity);
    if law.is_near_liquid() { swim(media, body, law, t) } else { fly_through(pose, law.constant, &law.air, t) }
}
