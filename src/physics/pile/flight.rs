//! Free flight: where every body would go if it touched nothing.
//!
//! Without drag the motion is a parabola, exact at any step: x += v·h + ½a·h², v += a·h. With quadratic drag
//! a(v) = A − k·|v|·v, the classical Runge–Kutta method of fourth order (Kutta 1901), written so that the compiler makes
//! vector code of it. It is right to about 1e-9 m while h·k|v| and h·√(k|A|) stay below [`LIGHT`]; the few lighter bodies are done
//! again one by one in sub-steps that keep both below it, and, once they are so light that the sub-steps run out, at the
//! equilibrium speed.

use super::bodies::Bodies;

/// The largest h·k|v| and h·√(k|A|) that one Runge–Kutta step serves. Larger: errors above 1e-8 m, and divergence beyond about 2.
const LIGHT: f64 = 0.06;

/// The most sub-steps of one light body in one step; what would need more is at its terminal velocity within a small part of
/// the step. Fewer: feathers reach it too early.
const MOST_SUB_STEPS: f64 = 4096.0;

/// Fills the free velocities and the predicted positions of a step of `dt` seconds. Returns whether all bodies stay within the
/// boxes in which their neighbours were sought.
pub(super) fn fly(bodies: &mut Bodies, dt: f64, drag: bool) -> bool {
    if drag {
        fly_with_drag(bodies, dt);
    } else {
        fly_on_parabolas(bodies, dt);
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

/// The deceleration per speed, 1/s, of drag at velocity (u, w): `tall` is k of the height, `wide` that of the width.
#[inline(always)]
fn rate(u: f64, w: f64, wide: f64, tall: f64) -> f64 {
    let k = if u.abs() > w.abs() { tall } else { wide };
    k * (u * u + w * w).sqrt()
}

/// One Runge–Kutta step from rest at the origin: (displacement x, y, velocity x, y).
#[inline(always)]
fn runge_kutta(u: f64, w: f64, ax: f64, ay: f64, wide: f64, tall: f64, h: f64) -> (f64, f64, f64, f64) {
    let r1 = rate(u, w, wide, tall);
    let (fx1, fy1) = (ax - r1 * u, ay - r1 * w);
    let (u2, w2) = (u + 0.5 * h * fx1, w + 0.5 * h * fy1);
    let r2 = rate(u2, w2, wide, tall);
    let (fx2, fy2) = (ax - r2 * u2, ay - r2 * w2);
    let (u3, w3) = (u + 0.5 * h * fx2, w + 0.5 * h * fy2);
    let r3 = rate(u3, w3, wide, tall);
    let (fx3, fy3) = (ax - r3 * u3, ay - r3 * w3);
    let (u4, w4) = (u + h * fx3, w + h * fy3);
    let r4 = rate(u4, w4, wide, tall);
    let (fx4, fy4) = (ax - r4 * u4, ay - r4 * w4);
    let sixth = h / 6.0;
    (
        h * u + h * sixth * (fx1 + fx2 + fx3),
        h * w + h * sixth * (fy1 + fy2 + fy3),
        u + sixth * (fx1 + 2.0 * (fx2 + fx3) + fx4),
        w + sixth * (fy1 + 2.0 * (fy2 + fy3) + fy4),
    )
}

fn fly_with_drag(bodies: &mut Bodies, dt: f64) {
    let n = bodies.len();
    let (x, y, vx, vy) = (&bodies.x[..n], &bodies.y[..n], &bodies.vx[..n], &bodies.vy[..n]);
    let (ax, ay, wide, tall) = (&bodies.ax[..n], &bodies.ay[..n], &bodies.drag_wide[..n], &bodies.drag_tall[..n]);
    let (px, py) = (&mut bodies.px[..n], &mut bodies.py[..n]);
    let (free_vx, free_vy) = (&mut bodies.free_vx[..n], &mut bodies.free_vy[..n]);
    let mut light = false;
    for i in 0..n {
        let (dx, dy, u, w) = runge_kutta(vx[i], vy[i], ax[i], ay[i], wide[i], tall[i], dt);
        px[i] = x[i] + dx;
        py[i] = y[i] + dy;
        free_vx[i] = u;
        free_vy[i] = w;
        light |= is_light(vx[i], vy[i], ax[i], ay[i], wide[i].max(tall[i]), dt);
    }
    if light {
        for i in 0..n {
            if is_light(vx[i], vy[i], ax[i], ay[i], wide[i].max(tall[i]), dt) {
                let (dx, dy, u, w) = sub_steps(vx[i], vy[i], ax[i], ay[i], wide[i], tall[i], dt);
                px[i] = x[i] + dx;
                py[i] = y[i] + dy;
                free_vx[i] = u;
                free_vy[i] = w;
            }
        }
    }
}

#[inline(always)]
fn is_light(u: f64, w: f64, ax: f64, ay: f64, k: f64, h: f64) -> bool {
    let reach = h * k;
    let too_fast = reach * reach * (u * u + w * w) > LIGHT * LIGHT;
    let too_eager = (reach * h) * (reach * h) * (ax * ax + ay * ay) > LIGHT * LIGHT * LIGHT * LIGHT;
    too_fast | too_eager
}

/// A step of a light body: sub-steps that keep it within [`LIGHT`].
fn sub_steps(mut u: f64, mut w: f64, ax: f64, ay: f64, wide: f64, tall: f64, dt: f64) -> (f64, f64, f64, f64) {
    let (mut left, mut x, mut y) = (dt, 0.0, 0.0);
    let a = (ax * ax + ay * ay).sqrt();
    let smallest = dt / MOST_SUB_STEPS;
    while left > 0.0 {
        let k = wide.max(tall);
        let speed = (u * u + w * w).sqrt();
        let wanted = LIGHT / (k * speed).max((k * a).sqrt());
        let h = wanted.max(smallest).min(left);
        if wanted < smallest {
            // Lighter than the sub-steps serve: drag alone decays exactly, the rest is pulled to its terminal velocity.
            let k = if u.abs() > w.abs() { tall } else { wide };
            let decay = 1.0 / (1.0 + k * speed * h);
            let terminal = if a > 0.0 && k > 0.0 { 1.0 / (k * a).sqrt() } else { 0.0 };
            let blend = (h * (k * a).sqrt()).min(1.0);
            let (next_u, next_w) = (u * decay, w * decay);
            let (next_u, next_w) = (next_u + blend * (ax * terminal - next_u), next_w + blend * (ay * terminal - next_w));
            x += 0.5 * h * (u * decay + next_u);
            y += 0.5 * h * (w * decay + next_w);
            (u, w) = (next_u, next_w);
        } else {
            let (dx, dy, next_u, next_w) = runge_kutta(u, w, ax, ay, wide, tall, h);
            x += dx;
            y += dy;
            (u, w) = (next_u, next_w);
        }
        left -= h;
    }
    (x, y, u, w)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// v = v_t·tanh(t/T) from rest, at all weights.
    #[test]
    fn reaches_terminal_velocity_at_any_weight() {
        for k in [1e-3, 0.1, 10.0, 300.0, 1e5, 1e12] {
            let terminal = (9.81f64 / k).sqrt();
            let (mut u, mut w) = (0.0, 0.0);
            for _ in 0..20_000 {
                let h = 1.0 / 120.0;
                (_, _, u, w) = if is_light(u, w, 0.0, 9.81, k, h) {
                    sub_steps(u, w, 0.0, 9.81, k, k, h)
                } else {
                    runge_kutta(u, w, 0.0, 9.81, k, k, h)
                };
            }
            assert_eq!(u, 0.0);
            assert!((w / terminal - 1.0).abs() < 1e-3, "k {k}: {w} instead of {terminal}");
        }
    }

    /// x = (v_t²/g)·ln cosh(g t/v_t) from rest.
    #[test]
    fn falls_as_the_closed_form_does() {
        let (k, g, h) = (0.1f64, 9.81f64, 1.0 / 120.0);
        let (mut y, mut w) = (0.0, 0.0);
        for _ in 0..720 {
            let (_, dy, _, next) = runge_kutta(0.0, w, 0.0, g, k, k, h);
            y += dy;
            w = next;
        }
        let terminal = (g / k).sqrt();
        let exact = terminal * terminal / g * libm::log(libm::cosh(g * 6.0 / terminal));
        assert!((y - exact).abs() < 1e-8, "{y} instead of {exact}");
    }
}
