//! Bodies on springs, which are links of the engine's world, and pendulums. Explicit Euler spirals outwards, symplectic methods stay, ours is exact.

use super::flight::{FlyingBody, over_tolerances};
use crate::lab::{LabScene, SceneMethod};
use crate::physics::{BodyDef, BodyId, DVec2, LinkDef, LinkEnd, LinkLaw, Spring, WorldDef};
use crate::{lab::contract::Model, lab::methods::INTEGRATORS, lab::methods::METHODS, lab::scenes::flight};
use crate::{lab::curve::CoursePoint, lab::curve::sampled, lab::methods::motion::MotionLaw, lab::methods::motion::PointState};

/// N/kg.
pub const G: f64 = 9.81;
/// The stiffness of a pendulum's spring, in parts of g/L.
const STIFF: f64 = 40.0;

/// 1 kg without weight on a spring to the origin, slack at 0 m, from `radius` m away, at rest or on a circle at ω·r. `stiffness` is ω², 1/s².
pub fn oscillator(stiffness: f64, radius: f64, circles: bool) -> FlyingBody {
    let law = MotionLaw { spring: stiffness, ..MotionLaw::default() };
    let v = if circles { DVec2::new(0.0, stiffness.sqrt() * radius) } else { DVec2::ZERO };
    on_spring(law, PointState { x: DVec2::new(radius, 0.0), v })
}

/// Such a body with weight on a spring of `length` m, `angle` rad from the vertical, at rest, and as long as its weight makes it.
pub fn pendulum(length: f64, angle: f64) -> FlyingBody {
    let spring = STIFF * G / length;
    let law = MotionLaw { constant: DVec2::new(0.0, G), spring, slack: length, ..MotionLaw::default() };
    let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
    on_spring(law, PointState { x: DVec2::new(sine, cosine) * (length + G / spring), v: DVec2::ZERO })
}

/// 1 and 3 kg on a spring of 2 m, 3 m apart, go round each other; the law is of the way from the second to the first, as of a body of 0.75 kg.
pub fn two_bodies() -> FlyingBody {
    let (masses, stiffness, length) = ([1.0, 3.0], 6.0, 2.0);
    let reduced = masses[0] * masses[1] / (masses[0] + masses[1]);
    let law = MotionLaw { spring: stiffness / reduced, slack: length, ..MotionLaw::default() };
    let start = PointState { x: DVec2::new(3.0, 0.0), v: DVec2::new(0.0, 4.0) };
    let part = [reduced / masses[0], -reduced / masses[1]];
    let bodies = [0, 1].map(|i| BodyDef {
        position: start.x * part[i],
        velocity: start.v * part[i],
        mass: masses[i],
        drag: 0.0,
        ..BodyDef::default()
    });
    let spring = LinkLaw::Spring(Spring { length, stiffness, damping: 0.0 });
    let links = vec![LinkDef::new(BodyId(0), LinkEnd::Body(BodyId(1)), spring)];
    let def = WorldDef { gravity: 0.0, air_density: 0.0, bodies: bodies.to_vec(), links, ..WorldDef::default() };
    FlyingBody::in_world(law, start, def, DVec2::ZERO)
}

fn on_spring(law: MotionLaw, start: PointState) -> FlyingBody {
    let body = BodyDef { position: start.x, velocity: start.v, mass: 1.0, drag: 0.0, ..BodyDef::default() };
    let spring = LinkLaw::Spring(Spring { length: law.slack, stiffness: law.spring, damping: law.viscous });
    let links = vec![LinkDef::new(BodyId(0), LinkEnd::Place(DVec2::ZERO), spring)];
    let def = WorldDef { gravity: law.constant.y, air_density: 0.0, bodies: vec![body], links, ..WorldDef::default() };
    FlyingBody::in_world(law, start, def, DVec2::ZERO)
}

/// s.
const SECONDS: f64 = 10.0;

/// 2 m long, from half a radian.
pub fn pendulum_swing() -> LabScene {
    let body = pendulum(2.0, 0.5);
    let exact = flight::drag_in_two_dimensions(&body.law, body.start, SECONDS).x;
    let known = body.clone();
    let methods = SceneMethod::all(INTEGRATORS.iter().copied(), move |by, h| known.error(by, SECONDS, h, exact));
    let methods = over_tolerances(methods, &body, SECONDS, exact);
    LabScene { methods, world: body.world(), ..LabScene::new("pendulum", "A pendulum on a stiff spring, 10 s", SECONDS, 1) }
}

/// λ² + 1000·λ + 1000 = 0: what is left of 1 m fades within a second, and the velocity within a thousandth of one.
const STIFF_RATE: f64 = 1000.0;

/// A body of 1 kg, 1 m from where its spring of 1000 N/m is slack, with a damper of 1000 N·s/m.
pub fn absorber() -> FlyingBody {
    let law = MotionLaw { spring: STIFF_RATE, viscous: STIFF_RATE, ..MotionLaw::default() };
    on_spring(law, PointState { x: DVec2::X, v: DVec2::ZERO })
}

/// Where that body is after `t` s, m.
pub fn absorbed(t: f64) -> f64 {
    let root = (0.25 * STIFF_RATE * STIFF_RATE - STIFF_RATE).sqrt();
    let (fast, slow) = (-0.5 * STIFF_RATE - root, -STIFF_RATE / (0.5 * STIFF_RATE + root));
    (fast * libm::exp(slow * t) - slow * libm::exp(fast * t)) / (fast - slow)
}

pub fn shock_absorber() -> LabScene {
    let (body, seconds) = (absorber(), 2.0);
    let exact = DVec2::new(absorbed(seconds), 0.0);
    let (known, followed) = (body.clone(), body.clone());
    let error = move |by, h| known.error(by, seconds, h, exact);
    let course = move |by, h| {
        let moments = followed.running(by, h).each(seconds, |time, point: &PointState| {
            let error = (point.x - DVec2::new(absorbed(time), 0.0)).length();
            CoursePoint { time, error, energy: None }
        });
        sampled(moments)
    };
    let methods = over_tolerances(SceneMethod::all_showing(METHODS, error, course), &body, seconds, exact);
    let note = "Stiff: it fades within a second, but the damper within a thousandth of one, which bounds explicit steps.";
    LabScene { methods, world: body.world(), note, ..LabScene::new("shock-absorber", "A stiff, damped spring, 2 s", seconds, 1) }
}

/// Some eight times round, with the energy on the way.
pub fn orbit() -> LabScene {
    let body = two_bodies();
    let (law, start) = (body.law, body.start);
    let exact = flight::drag_in_two_dimensions(&law, start, SECONDS).x;
    let (known, followed) = (body.clone(), body.clone());
    let error = move |by, h| known.error(by, SECONDS, h, exact);
    let course = move |by, h| {
        let mut truth = (0.0, start);
        let moments = followed.running(by, h).each(SECONDS, |time, point: &PointState| {
            truth = (time, flight::drag_in_two_dimensions(&law, truth.1, time - truth.0));
            let energy = Some(energy(&law, point) / energy(&law, &start));
            CoursePoint { time, error: (point.x - truth.1.x).length(), energy }
        });
        sampled(moments)
    };
    let methods = SceneMethod::all_showing(INTEGRATORS.iter().copied(), error, course);
    let methods = over_tolerances(methods, &body, SECONDS, exact);
    LabScene {
        methods,
        world: body.world(),
        ..LabScene::new("orbit", "Two bodies on a spring go round each other, 10 s", SECONDS, 2)
    }
}

/// ½v² + ½s·(|x| − L)² − A·x, J/kg; zero is its least.
pub fn energy(law: &MotionLaw, PointState { x, v }: &PointState) -> f64 {
    let stretch = x.length() - law.slack;
    let at_rest = law.constant.length_squared() * 0.5 / law.spring + law.constant.length() * law.slack;
    0.5 * v.length_squared() + 0.5 * law.spring * stretch * stretch - law.constant.dot(*x) + at_rest
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lab::contract::By;
    use crate::lab::methods::motion::{
        MotionStep, explicit_euler, implicit_euler, implicit_midpoint, rk4, semi_implicit_euler, trapezoid, yoshida,
    };

    /// Of explicit Euler the energy grows by 1 + (ω·h)² a step, exactly.
    #[test]
    fn explicit_euler_spirals_the_symplectic_one_stays_and_the_engine_is_exact() {
        let (h, steps, omega) = (1.0 / 60.0, 600, 3.0_f64);
        let body = oscillator(omega * omega, 2.0, true);
        let energy_at_end =
            |by| energy(&body.law, &body.end(by, f64::from(steps) * h, h).unwrap()) / energy(&body.law, &body.start);
        let grown = (1.0 + (omega * h).powi(2)).powi(steps);
        let found = energy_at_end(By::Hand(explicit_euler));
        assert!((found / grown - 1.0).abs() < 1e-9 && grown > 4.0, "{found} for {grown}");
        // Within ω·h/2 of the right one, for ever.
        assert!((energy_at_end(By::Hand(semi_implicit_euler)) - 1.0).abs() < omega * h);
        assert!((energy_at_end(By::Engine) - 1.0).abs() < 1e-9);
        let turned = DVec2::from_angle(omega * f64::from(steps) * h) * 2.0;
        let ours = body.end(By::Engine, f64::from(steps) * h, h).unwrap().x;
        assert!((ours - turned).length() < 1e-8, "{ours} for {turned}");
    }

    #[test]
    fn the_engine_swings_a_pendulum_as_the_reference_does() {
        let body = pendulum(2.0, 0.5);
        let exact = flight::drag_in_two_dimensions(&body.law, body.start, 10.0).x;
        for h in [1.0 / 30.0, 1.0 / 120.0] {
            let ours = body.end(By::Engine, 10.0, h).unwrap().x;
            assert!((ours - exact).length() < 1e-7, "{ours} for {exact} at {h} s");
        }
        let kept = |by| energy(&body.law, &body.end(by, 10.0, 1.0 / 60.0).unwrap()) / energy(&body.law, &body.start);
        assert!(kept(By::Hand(explicit_euler)) > 10.0 && (kept(By::Hand(semi_implicit_euler)) - 1.0).abs() < 0.5);
        assert!((kept(By::Engine) - 1.0).abs() < 1e-7, "{}", kept(By::Engine));
    }

    /// A stiff damper bounds explicit steps by 2/999 s; implicit ones may be as long as they like.
    #[test]
    fn a_stiff_spring_breaks_explicit_methods_and_not_implicit_ones() {
        let body = absorber();
        assert!((absorbed(0.0) - 1.0).abs() < 1e-12 && (absorbed(2.0) - libm::exp(-2.0)).abs() < 1e-3);
        let error = |by, h| body.error(by, 2.0, h, DVec2::new(absorbed(2.0), 0.0));
        for step in [explicit_euler as MotionStep, semi_implicit_euler, rk4] {
            let found = error(By::Hand(step), 1.0 / 60.0);
            assert!(!found.is_finite() || found > 1e4, "{found}");
        }
        // The whole error of first order in the slow part, x·t·h/2, and of second order, x·t·h²/12.
        let (left, h) = (libm::exp(-2.0), 1.0 / 60.0);
        let first = error(By::Hand(implicit_euler), h) / (left * 2.0 * h / 2.0);
        assert!((first - 1.0).abs() < 0.02, "{first}");
        for step in [implicit_midpoint as MotionStep, trapezoid] {
            let second = error(By::Hand(step), h) / (left * 2.0 * h * h / 12.0);
            assert!((second - 1.0).abs() < 0.02, "{second}");
        }
        assert!(error(By::Engine, h) < 1e-12);
    }

    /// Energy and the sense of rotation stay with symplectic methods; implicit Euler lets the orbit decay.
    #[test]
    fn an_orbit_lasts_by_symplectic_methods_and_decays_by_implicit_euler() {
        let body = two_bodies();
        let kept = |by| energy(&body.law, &body.end(by, 100.0, 1.0 / 60.0).unwrap()) / energy(&body.law, &body.start);
        for (step, off) in [(yoshida as MotionStep, 1e-5), (implicit_midpoint, 2e-3), (trapezoid, 2e-3)] {
            let found = kept(By::Hand(step));
            assert!((found - 1.0).abs() < off, "{found}");
        }
        assert!(kept(By::Hand(implicit_euler)) < 0.5);
        assert!((kept(By::Engine) - 1.0).abs() < 1e-9, "{}", kept(By::Engine));
        let exact = flight::drag_in_two_dimensions(&body.law, body.start, 10.0).x;
        assert!(body.error(By::Engine, 10.0, 1.0 / 60.0, exact) < 1e-8);
    }
}
