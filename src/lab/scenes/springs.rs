//! A body on a spring, which is a link of the engine's world, and a pendulum on a stiffer one. Explicit Euler spirals outwards, symplectic
//! methods stay, and the engine is exact.

use super::flight::FlyingBody;
use crate::lab::contract::Model;
use crate::lab::methods::motion::{INTEGRATORS, MotionLaw, PointState};
use crate::lab::{LabScene, SceneMethod, reference};
use crate::physics::{BodyDef, BodyId, DVec2, LinkDef, LinkEnd, LinkLaw, Spring, WorldDef};

/// N/kg.
pub const G: f64 = 9.81;
/// The stiffness of a pendulum's spring, in parts of g/L.
const STIFF: f64 = 40.0;

/// A body of 1 kg on a spring to the origin, 0 m long without a force, without weight. It starts `radius` m away: to the side at rest, or
/// on a circle at ω·r. `stiffness` is ω², 1/s².
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

fn on_spring(law: MotionLaw, start: PointState) -> FlyingBody {
    let body = BodyDef { position: start.x, velocity: start.v, mass: 1.0, drag: 0.0, ..BodyDef::default() };
    let spring = LinkLaw::Spring(Spring { length: law.slack, stiffness: law.spring, damping: 0.0 });
    let links = vec![LinkDef::new(BodyId(0), LinkEnd::Place(DVec2::ZERO), spring)];
    let def = WorldDef { gravity: law.constant.y, air_density: 0.0, bodies: vec![body], links, ..WorldDef::default() };
    FlyingBody::in_world(law, start, def, DVec2::ZERO)
}

/// s.
const SECONDS: f64 = 10.0;

fn scene(name: &'static str, title: &str, body: FlyingBody, exact: DVec2) -> LabScene {
    let world = body.world();
    let methods = SceneMethod::all(INTEGRATORS.iter().copied(), move |by, h| body.error(by, SECONDS, h, exact));
    let note = "Order p: half the step divides the error by 2 to the power of p.";
    LabScene { methods, world, note, ..LabScene::new(name, title, SECONDS, 1) }
}

/// From 2 m to the side: x = 2·cos ωt.
pub fn swing() -> LabScene {
    let (omega, radius) = (3.0, 2.0);
    let exact = DVec2::new(radius * libm::cos(omega * SECONDS), 0.0);
    scene("spring", "A body on a spring without drag (ω = √(k/m)), 10 s", oscillator(omega * omega, radius, false), exact)
}

/// 2 m long, from half a radian.
pub fn pendulum_swing() -> LabScene {
    let body = pendulum(2.0, 0.5);
    let exact = reference::drag_in_two_dimensions(&body.law, body.start, SECONDS).x;
    scene("pendulum", "A pendulum on a stiff spring, 10 s", body, exact)
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
    use crate::lab::contract::{By, Model};
    use crate::lab::methods::motion::{explicit_euler, semi_implicit_euler};
    use crate::lab::reference;

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
        let exact = reference::drag_in_two_dimensions(&body.law, body.start, 10.0).x;
        for h in [1.0 / 30.0, 1.0 / 120.0] {
            let ours = body.end(By::Engine, 10.0, h).unwrap().x;
            assert!((ours - exact).length() < 1e-7, "{ours} for {exact} at {h} s");
        }
        let kept = |by| energy(&body.law, &body.end(by, 10.0, 1.0 / 60.0).unwrap()) / energy(&body.law, &body.start);
        assert!(kept(By::Hand(explicit_euler)) > 10.0 && (kept(By::Hand(semi_implicit_euler)) - 1.0).abs() < 0.5);
        assert!((kept(By::Engine) - 1.0).abs() < 1e-7, "{}", kept(By::Engine));
    }
}
