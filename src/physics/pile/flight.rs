//! Free flight: where every body would go if it touched nothing.
//!
//! Without drag the motion is a parabola, exact at any step: x += v·h + ½a·h², v += a·h. With drag it is [`air::step`] for all bodies, in
//! short plain loops over separate arrays, of which the compiler makes vector code. What is light, or at the apex of its throw, is done
//! again alone by [`air::in_parts`]: the very functions of small worlds, so that a body flies alike, to the bit, in either. What is guided
//! from outside goes where it is told.

use super::super::air;
#[cfg(doc)]
use super::super::air::Step;
use super::bodies::Bodies;
use glam::DVec2;

/// Bodies that are computed together. More: their arrays leave the fastest cache; fewer: the loops are too short.
const BLOCK: usize = 128;

/// Fills the free velocities and the predicted positions of these bodies for a step of `dt` seconds.
pub(super) fn fly(bodies: &mut Bodies, slots: &[u32], dt: f64, drag: bool) {
    if slots.len() < bodies.len() {
        slots.iter().for_each(|i| fly_one(bodies, *i as usize, dt, drag));
    } else if drag {
        fly_through_air(bodies, dt);
    } else {
        fly_on_parabolas(bodies, dt);
    }
    for g in 0..bodies.guided.len() {
        let (id, position, velocity) = bodies.guided[g];
        bodies.is_guided[id as usize] = true;
        let i = bodies.slot[id as usize] as usize;
        (bodies.px[i], bodies.py[i]) = position.into();
        (bodies.free_vx[i], bodies.free_vy[i]) = velocity.into();
    }
}

fn fly_on_parabolas(bodies: &mut Bodies, dt: f64) {
    let n = bodies.len();
    let half = 0.5 * dt * dt;
    axis_of_parabolas(&bodies.x[..n], &bodies.vx[..n], &bodies.ax[..n], &mut bodies.px[..n], &mut bodies.free_vx[..n], dt, half);
    axis_of_parabolas(&bodies.y[..n], &bodies.vy[..n], &bodies.ay[..n], &mut bodies.py[..n], &mut bodies.free_vy[..n], dt, half);
}

fn axis_of_parabolas(x: &[f64], v: &[f64], a: &[f64], px: &mut [f64], free: &mut [f64], dt: f64, half: f64) {
    let n = x.len();
    let (v, a, px, free) = (&v[..n], &a[..n], &mut px[..n], &mut free[..n]);
    for i in 0..n {
        px[i] = x[i] + (v[i] * dt + a[i] * half);
        free[i] = v[i] + a[i] * dt;
    }
}

fn fly_through_air(bodies: &mut Bodies, dt: f64) {
    let mut block = Block::default();
    for from in (0..bodies.len()).step_by(BLOCK) {
        let of = from..bodies.len().min(from + BLOCK);
        let (u, w, a, b) = (&bodies.vx[of.clone()], &bodies.vy[of.clone()], &bodies.ax[of.clone()], &bodies.ay[of.clone()]);
        let (wide, tall, round) = (&bodies.drag_wide[of.clone()], &bodies.drag_tall[of.clone()], &bodies.drag_round[of.clone()]);
        block.solve_boxes([u, w], [a, b], wide, tall, dt);
        if round.iter().any(|&round| round > 0.0) {
            block.solve_round([u, w], [a, b], round, dt);
        }
        block.fly_along(&bodies.x[of.clone()], u, a, &mut bodies.px[of.clone()], &mut bodies.free_vx[of.clone()]);
        block.fly_along(&bodies.y[of.clone()], w, b, &mut bodies.py[of.clone()], &mut bodies.free_vy[of.clone()]);
        if block.apart[..of.len()].iter().fold(0, |any, apart| any | apart) != 0 {
            for i in of.filter(|i| block.apart[i - from] != 0) {
                fly_alone(bodies, i, dt);
            }
        }
    }
}

/// The steps of some bodies, in separate arrays: see [`Step`].
struct Block {
    reach: [f64; BLOCK],
    slower: [f64; BLOCK],
    carry: [f64; BLOCK],
    lift: [f64; BLOCK],
    apart: [u64; BLOCK],
}

impl Default for Block {
    fn default() -> Self {
        let zero = [0.0; BLOCK];
        Self { reach: zero, slower: zero, carry: zero, lift: zero, apart: [0; BLOCK] }
    }
}

impl Block {
    /// Steps of `h` seconds of boxes.
    fn solve_boxes(&mut self, v: [&[f64]; 2], acceleration: [&[f64]; 2], wide: &[f64], tall: &[f64], h: f64) {
        let n = v[0].len().min(BLOCK);
        let (u, w, a, b) = (&v[0][..n], &v[1][..n], &acceleration[0][..n], &acceleration[1][..n]);
        let (wide, tall) = (&wide[..n], &tall[..n]);
        let (reach, slower) = (&mut self.reach[..n], &mut self.slower[..n]);
        let (carry, lift, apart) = (&mut self.carry[..n], &mut self.lift[..n], &mut self.apart[..n]);
        for i in 0..n {
            let step = air::step(h, u[i], w[i], a[i], b[i], tall[i], wide[i]);
            (reach[i], slower[i], carry[i], lift[i], apart[i]) = (step.reach, step.slower, step.carry, step.lift, step.apart);
        }
    }

    /// The same for what is round among them.
    fn solve_round(&mut self, v: [&[f64]; 2], acceleration: [&[f64]; 2], round: &[f64], h: f64) {
        let n = v[0].len().min(BLOCK);
        let mut found = Self::default();
        let (u, w, a, b, round) = (&v[0][..n], &v[1][..n], &acceleration[0][..n], &acceleration[1][..n], &round[..n]);
        let (reach, slower) = (&mut found.reach[..n], &mut found.slower[..n]);
        let (carry, lift, apart) = (&mut found.carry[..n], &mut found.lift[..n], &mut found.apart[..n]);
        for i in 0..n {
            let step = air::round_step(h, u[i], w[i], a[i], b[i], round[i]);
            (reach[i], slower[i], carry[i], lift[i], apart[i]) = (step.reach, step.slower, step.carry, step.lift, step.apart);
        }
        for i in (0..n).filter(|&i| round[i] > 0.0) {
            self.reach[i] = found.reach[i];
            self.slower[i] = found.slower[i];
            self.carry[i] = found.carry[i];
            self.lift[i] = found.lift[i];
            self.apart[i] = found.apart[i];
        }
    }

    /// One axis of the motion.
    fn fly_along(&self, x: &[f64], v: &[f64], a: &[f64], px: &mut [f64], free: &mut [f64]) {
        let n = x.len().min(BLOCK);
        let (v, a, px, free) = (&v[..n], &a[..n], &mut px[..n], &mut free[..n]);
        let (reach, slower) = (&self.reach[..n], &self.slower[..n]);
        let (carry, lift) = (&self.carry[..n], &self.lift[..n]);
        for i in 0..n {
            free[i] = (v[i] + a[i] * reach[i]) * slower[i];
            px[i] = x[i] + (v[i] * carry[i] + a[i] * lift[i]);
        }
    }
}

/// The flight of one body: what [`fly`] comes to for it.
pub(super) fn fly_one(bodies: &mut Bodies, i: usize, dt: f64, drag: bool) {
    if drag {
        return fly_alone(bodies, i, dt);
    }
    let half = 0.5 * dt * dt;
    (bodies.px[i], bodies.free_vx[i]) = (bodies.x[i] + (bodies.vx[i] * dt + bodies.ax[i] * half), bodies.vx[i] + bodies.ax[i] * dt);
    (bodies.py[i], bodies.free_vy[i]) = (bodies.y[i] + (bodies.vy[i] * dt + bodies.ay[i] * half), bodies.vy[i] + bodies.ay[i] * dt);
}

fn fly_alone(bodies: &mut Bodies, i: usize, dt: f64) {
    let a = DVec2::new(bodies.ax[i], bodies.ay[i]);
    let pose = (DVec2::new(bodies.x[i], bodies.y[i]), DVec2::new(bodies.vx[i], bodies.vy[i]));
    let (x, v) = air::fly_through(pose, a, &bodies.drag_of(i), dt);
    (bodies.px[i], bodies.py[i]) = x.into();
    (bodies.free_vx[i], bodies.free_vy[i]) = v.into();
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::air::Drag;

    const H: f64 = 1.0 / 60.0;

    /// One step of a body at the origin: where it is then, and how fast.
    fn step(v: DVec2, a: DVec2, drag: Drag) -> (DVec2, DVec2) {
        let mut bodies = Bodies::new(1, 0);
        (bodies.vx[0], bodies.vy[0], bodies.ax[0], bodies.ay[0]) = (v.x, v.y, a.x, a.y);
        (bodies.drag_wide[0], bodies.drag_tall[0], bodies.drag_round[0]) = (drag.wide, drag.tall, drag.round);
        fly_through_air(&mut bodies, H);
        (DVec2::new(bodies.px[0], bodies.py[0]), DVec2::new(bodies.free_vx[0], bodies.free_vy[0]))
    }

    /// To the bit: heavy and light, boxes and round things, past an apex or not, without drag.
    #[test]
    fn together_and_alone_they_fly_the_same_way() {
        for k in [0.0, 1e-3, 0.05, 0.1, 0.12, 0.2, 1.0, 1e3, 1e9] {
            for drag in [
                Drag { tall: k, wide: k, round: 0.0 },
                Drag { tall: 0.3 * k, wide: 2.0 * k, round: 0.0 },
                Drag { round: k, ..Drag::default() },
            ] {
                for a in [DVec2::new(2.0, 9.81), DVec2::new(0.0, 9.81), DVec2::ZERO] {
                    for v in [(0.0, 0.0), (20.0, -5.0), (-1.0, 0.1), (-40.0, 30.0), (3.0, -0.05), (0.0, -0.01), (-0.01, -0.02)] {
                        let v = DVec2::from(v);
                        assert_eq!(step(v, a, drag), air::fly_through((DVec2::ZERO, v), a, &drag, H), "{drag:?}, {v}, {a}");
                    }
                }
            }
        }
    }
}
