//! Free flight: where every body would go if it touched nothing.
//!
//! Without drag the motion is a parabola, exact at any step: x += v·h + ½a·h², v += a·h. With drag it is [`air::fly_through`], as for a body
//! alone. A guided body goes where the world says.

use crate::physics::data::plan::{Part, called};
use crate::physics::flight::air;
use crate::physics::store::bodies::Bodies;
use glam::DVec2;

/// Fills the free velocities and the predicted positions of these bodies for a step of `dt` seconds.
pub(crate) fn fly(bodies: &mut Bodies, slots: &[u32], dt: f64, drag: bool) {
    slots.iter().for_each(|i| fly_one(bodies, *i as usize, dt, drag));
    for g in 0..bodies.guided.len() {
        let (id, position, velocity) = bodies.guided[g];
        bodies.is_guided[id as usize] = true;
        let i = id as usize;
        (bodies.px[i], bodies.py[i]) = position.into();
        (bodies.free_vx[i], bodies.free_vy[i]) = velocity.into();
    }
}

/// The flight of one body.
#[inline(always)]
pub(crate) fn fly_one(bodies: &mut Bodies, i: usize, dt: f64, drag: bool) {
    if drag {
        called(Part::Air);
        let a = DVec2::new(bodies.ax[i], bodies.ay[i]);
        let pose = (DVec2::new(bodies.x[i], bodies.y[i]), DVec2::new(bodies.vx[i], bodies.vy[i]));
        let (x, v) = air::fly_through(pose, a, &bodies.drag_of(i), dt);
        (bodies.px[i], bodies.py[i]) = x.into();
        (bodies.free_vx[i], bodies.free_vy[i]) = v.into();
        return;
    }
    let half = 0.5 * dt * dt;
    (bodies.px[i], bodies.free_vx[i]) = (bodies.x[i] + (bodies.vx[i] * dt + bodies.ax[i] * half), bodies.vx[i] + bodies.ax[i] * dt);
    (bodies.py[i], bodies.free_vy[i]) = (bodies.y[i] + (bodies.vy[i] * dt + bodies.ay[i] * half), bodies.vy[i] + bodies.ay[i] * dt);
}
