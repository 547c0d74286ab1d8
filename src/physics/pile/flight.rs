//! Free flight: where every body would go if it touched nothing.
//!
//! Without drag the motion is a parabola, exact at any step: x += v·h + ½a·h², v += a·h.
//!
//! With quadratic drag u′ = A − k·|u|·u, let q = exp(∫k|u|dt) and Q = ∫q dt. Then u = (u₀ + A·Q)/q, and one scalar equation is left,
//! Q″ = k·|u₀ + A·Q| from Q = 0, Q′ = 1, which Nyström's method of fourth order (1925) solves with three roots a step: one less than
//! Runge–Kutta, and half its arithmetic. The position follows from both ends, x = ½h(u₀ + u₁) + h²/12·(a₀ − a₁) (Euler–Maclaurin).
//! Drag alone slows exactly as it should at any speed, a body without drag flies its parabola, and nothing can diverge or turn round.
//! Errors are those of Runge–Kutta or less, 1e-7 m after seconds, while h·k|u| and h·√(k|A|) stay below [`LIGHT`]. What is lighter, or
//! turns another side to the air within the step, is done again alone, by the flow of small worlds. What is guided from outside goes
//! where it is told.

use super::super::flow::{fly_through, time_of_turn};
use super::super::media::moves_across;
use super::bodies::Bodies;
use glam::DVec2;

/// The largest h·k|u| and h·√(k|A|) that one step of all serves. Larger: errors above 1e-6 m after seconds. Smaller: more bodies are
/// done alone, at fifty times the cost.
const LIGHT: f64 = 0.04;

/// How often the side that a body turns to the air can change in one step. Drag along the motion turns nothing, so that the direction
/// only ever turns towards A: by less than half a circle, over two borders at most.
const MOST_TURNS: u32 = 2;

/// Bodies that are computed together. More: their arrays leave the fastest cache; fewer: the loops are too short.
const BLOCK: usize = 128;

/// Fills the free velocities and the predicted positions of a step of `dt` seconds. Returns whether all bodies stay within the
/// boxes in which their neighbours were sought.
pub(super) fn fly(bodies: &mut Bodies, dt: f64, drag: bool) -> bool {
    if drag {
        fly_through_air(bodies, dt);
    } else {
        fly_on_parabolas(bodies, dt);
    }
    for g in 0..bodies.guided.len() {
        let (id, position, velocity) = bodies.guided[g];
        let i = bodies.slot[id as usize] as usize;
        (bodies.px[i], bodies.py[i]) = position.into();
        (bodies.free_vx[i], bodies.free_vy[i]) = velocity.into();
    }
    stays(bodies)
}

/// Whether all predicted positions lie within the boxes in which the bodies' neighbours were sought.
pub(super) fn stays(bodies: &Bodies) -> bool {
    let n = bodies.len();
    let inside_x = within(&bodies.px[..n], bodies.shift.0, &bodies.allowed_left[..n], &bodies.allowed_right[..n]);
    inside_x && within(&bodies.py[..n], bodies.shift.1, &bodies.allowed_top[..n], &bodies.allowed_bottom[..n])
}

/// Whether every value less `shift` lies in its range.
fn within(values: &[f64], shift: f64, low: &[f64], high: &[f64]) -> bool {
    let inside = |value: f64, low: f64, high: f64| (value - shift >= low) & (value - shift <= high);
    values.iter().zip(low).zip(high).fold(true, |all, ((value, low), high)| all & inside(*value, *low, *high))
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
        px[i] = x[i] + v[i] * dt + a[i] * half;
        free[i] = v[i] + a[i] * dt;
    }
}

fn fly_through_air(bodies: &mut Bodies, dt: f64) {
    let mut block = Block::default();
    for from in (0..bodies.len()).step_by(BLOCK) {
        let range = from..bodies.len().min(from + BLOCK);
        let of = range.clone();
        let (u, w, a, b) = (&bodies.vx[of.clone()], &bodies.vy[of.clone()], &bodies.ax[of.clone()], &bodies.ay[of.clone()]);
        let (free_u, free_w) = (&mut bodies.free_vx[of.clone()], &mut bodies.free_vy[of.clone()]);
        block.solve([u, w], [a, b], [&bodies.drag_wide[of.clone()], &bodies.drag_tall[of.clone()]], dt);
        block.fly_along(&bodies.x[of.clone()], u, a, &mut bodies.px[of.clone()], free_u);
        block.fly_along(&bodies.y[of.clone()], w, b, &mut bodies.py[of], free_w);
        if block.set_apart([u, w], [free_u, free_w]) {
            for i in range.filter(|i| block.apart[i - from] != 0) {
                fly_alone(bodies, i, dt);
            }
        }
    }
}

/// Nyström's method for some bodies, in short plain loops over separate arrays: the compiler makes vector code of each, and the roots of
/// one body do not wait for those of the one before.
struct Block {
    /// h²·k/12 with the k of the side that meets the air, s²/m.
    bend: [f64; BLOCK],
    /// |u₀ + A·Q|, m/s: at the start, in the middle and at the end of the step.
    start: [f64; BLOCK],
    middle: [f64; BLOCK],
    end: [f64; BLOCK],
    /// Q at the end, s, and 1/q there.
    reach: [f64; BLOCK],
    slower: [f64; BLOCK],
    /// How far the velocities at the start and at the end carry, s.
    carry_start: [f64; BLOCK],
    carry_end: [f64; BLOCK],
    /// Not 0: has to be done alone.
    apart: [u64; BLOCK],
}

/// In [`Block::apart`]: too light.
const IS_LIGHT: u64 = 1;
/// In [`Block::apart`], while it is not known who turns: meets the air with one side otherwise than with the other.
const IS_UNEVEN: u64 = 2;

impl Default for Block {
    fn default() -> Self {
        let zero = [0.0; BLOCK];
        Self {
            bend: zero,
            start: zero,
            middle: zero,
            end: zero,
            reach: zero,
            slower: zero,
            carry_start: zero,
            carry_end: zero,
            apart: [0; BLOCK],
        }
    }
}

impl Block {
    /// Solves Q″ = k·|u₀ + A·Q| for a step of `h` seconds: velocities `v`, accelerations `acceleration`, and `drag` of the width and of
    /// the height.
    fn solve(&mut self, v: [&[f64]; 2], acceleration: [&[f64]; 2], drag: [&[f64]; 2], h: f64) {
        let n = v[0].len().min(BLOCK);
        let (u, w, a, b) = (&v[0][..n], &v[1][..n], &acceleration[0][..n], &acceleration[1][..n]);
        let (wide, tall, apart) = (&drag[0][..n], &drag[1][..n], &mut self.apart[..n]);
        let (bend, start, middle, end) = (&mut self.bend[..n], &mut self.start[..n], &mut self.middle[..n], &mut self.end[..n]);
        let (half, twelfth, doubled) = (h / 2.0, h * h / 12.0, 2.0 / h);
        let (most_fast, most_eager) = (LIGHT * h / 12.0, LIGHT * LIGHT * LIGHT * LIGHT / 144.0);
        for i in 0..n {
            let (wide, tall) = (wide[i], tall[i]);
            bend[i] = twelfth * if u[i].abs() > w[i].abs() { tall } else { wide };
            start[i] = (u[i] * u[i] + w[i] * w[i]).sqrt();
            let eager = bend[i] * bend[i] * (a[i] * a[i] + b[i] * b[i]) > most_eager;
            let light = eager | (bend[i] * start[i] > most_fast);
            apart[i] = if light { IS_LIGHT } else { 0 } | if wide != tall { IS_UNEVEN } else { 0 };
        }
        for i in 0..n {
            let q = half + 1.5 * bend[i] * start[i];
            let (u, w) = (u[i] + a[i] * q, w[i] + b[i] * q);
            middle[i] = (u * u + w * w).sqrt();
        }
        for i in 0..n {
            let q = h + 6.0 * bend[i] * middle[i];
            let (u, w) = (u[i] + a[i] * q, w[i] + b[i] * q);
            end[i] = (u * u + w * w).sqrt();
        }
        let (reach, slower) = (&mut self.reach[..n], &mut self.slower[..n]);
        let (carry_start, carry_end) = (&mut self.carry_start[..n], &mut self.carry_end[..n]);
        for i in 0..n {
            reach[i] = h + 2.0 * bend[i] * (start[i] + 2.0 * middle[i]);
            slower[i] = 1.0 / (1.0 + doubled * bend[i] * (start[i] + 4.0 * middle[i] + end[i]));
            carry_start[i] = half - bend[i] * start[i];
            carry_end[i] = half + bend[i] * end[i] * slower[i];
        }
    }

    /// One axis of the motion.
    fn fly_along(&self, x: &[f64], v: &[f64], a: &[f64], px: &mut [f64], free: &mut [f64]) {
        let n = x.len().min(BLOCK);
        let (v, a, px, free) = (&v[..n], &a[..n], &mut px[..n], &mut free[..n]);
        let (reach, slower) = (&self.reach[..n], &self.slower[..n]);
        let (carry_start, carry_end) = (&self.carry_start[..n], &self.carry_end[..n]);
        for i in 0..n {
            free[i] = (v[i] + a[i] * reach[i]) * slower[i];
            px[i] = x[i] + (carry_start[i] * v[i] + carry_end[i] * free[i]);
        }
    }

    /// Leaves those set apart that are light or turn; returns whether there are any.
    fn set_apart(&mut self, v: [&[f64]; 2], free: [&[f64]; 2]) -> bool {
        let n = v[0].len().min(BLOCK);
        let (u, w, free_u, free_w) = (&v[0][..n], &v[1][..n], &free[0][..n], &free[1][..n]);
        let mut any = 0;
        for i in 0..n {
            let turns = (u[i].abs() > w[i].abs()) != (free_u[i].abs() > free_w[i].abs());
            let apart = self.apart[i] & if turns { IS_LIGHT | IS_UNEVEN } else { IS_LIGHT };
            self.apart[i] = apart;
            any |= apart;
        }
        any != 0
    }
}

/// A step of one body, in parts within which it turns the same side to the air.
fn fly_alone(bodies: &mut Bodies, i: usize, dt: f64) {
    let a = DVec2::new(bodies.ax[i], bodies.ay[i]);
    let (wide, tall) = (bodies.drag_wide[i], bodies.drag_tall[i]);
    let mut pose = (DVec2::new(bodies.x[i], bodies.y[i]), DVec2::new(bodies.vx[i], bodies.vy[i]));
    let mut left = dt;
    let mut across = moves_across(pose.1, a);
    for part in 0..=MOST_TURNS {
        let k = if across { tall } else { wide };
        let turn =
            if wide == tall || part == MOST_TURNS { None } else { time_of_turn(across, left, |t| fly_through(pose, a, k, t).1) };
        pose = fly_through(pose, a, k, turn.unwrap_or(left));
        let Some(t) = turn else { break };
        left -= t;
        across = !across;
    }
    (bodies.px[i], bodies.py[i]) = pose.0.into();
    (bodies.free_vx[i], bodies.free_vy[i]) = pose.1.into();
}

#[cfg(test)]
mod tests {
    use super::*;

    const H: f64 = 1.0 / 60.0;

    /// One step of a body at the origin: where it is then, and how fast.
    fn step(v: DVec2, a: DVec2, wide: f64, tall: f64) -> (DVec2, DVec2) {
        let mut bodies = Bodies::new(1, 0);
        (bodies.vx[0], bodies.vy[0], bodies.ax[0], bodies.ay[0]) = (v.x, v.y, a.x, a.y);
        (bodies.drag_wide[0], bodies.drag_tall[0]) = (wide, tall);
        fly_through_air(&mut bodies, H);
        (DVec2::new(bodies.px[0], bodies.py[0]), DVec2::new(bodies.free_vx[0], bodies.free_vy[0]))
    }

    #[test]
    fn without_drag_it_is_the_parabola() {
        let (x, v) = step(DVec2::new(3.0, -4.0), DVec2::new(0.5, 9.81), 0.0, 0.0);
        assert_eq!(v, DVec2::new(3.0 + 0.5 * H, -4.0 + 9.81 * H));
        assert!((x - DVec2::new((3.0 + 0.25 * H) * H, (-4.0 + 4.905 * H) * H)).length() < 1e-17);
    }

    /// v = v₀/(1 + k|v₀|t).
    #[test]
    fn drag_alone_slows_exactly() {
        let v0 = DVec2::new(3.0, -20.0);
        let (_, v) = step(v0, DVec2::ZERO, 0.1, 0.1);
        assert!((v - v0 / (1.0 + 0.1 * v0.length() * H)).length() < 1e-14);
    }

    #[test]
    fn together_and_alone_they_fly_the_same_way() {
        let a = DVec2::new(2.0, 9.81);
        for k in [0.0, 1e-3, 0.05, 0.1, 0.12, 0.2, 1.0, 1e3, 1e9] {
            for v in [DVec2::ZERO, DVec2::new(20.0, -5.0), DVec2::new(-1.0, 0.1), DVec2::new(-40.0, 30.0)] {
                let (x, v1) = step(v, a, k, k);
                let (alone_x, alone_v) = fly_through((DVec2::ZERO, v), a, k, H);
                assert!((x - alone_x).length() < 1e-7, "k {k}, v {v}: {x}, {alone_x}");
                assert!((v1 - alone_v).length() < 1e-6, "k {k}, v {v}: {v1}, {alone_v}");
            }
        }
    }

    /// Just before and just after the turn the two laws are those of the sides; in between each acts for its own part of the step.
    #[test]
    fn a_turn_within_the_step_parts_it() {
        let (v, a) = (DVec2::new(1.0, 0.99), DVec2::new(0.0, 9.81));
        let (wide, tall) = (0.3, 0.1);
        let (mut x, mut u) = (DVec2::ZERO, v);
        let parts = 1_000_000;
        for _ in 0..parts {
            let k = if u.x.abs() > u.y.abs() { tall } else { wide };
            (x, u) = fly_through((x, u), a, k, H / f64::from(parts));
        }
        let (at, now) = step(v, a, wide, tall);
        assert!((at - x).length() < 1e-10 && (now - u).length() < 1e-8, "{at} {now}, expected {x} {u}");
    }
}
