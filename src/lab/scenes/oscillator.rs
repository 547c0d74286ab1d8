//! A floating box without drag: K = ρ·g·A, ω = √(K/m), y = y₀·cos ωt. Symplectic methods' energy swings about the right one; others' grows or fades.

use super::flight::{FlyingBody, over_tolerances};
use crate::lab::curve::{CoursePoint, sampled, worst};
use crate::lab::methods::motion::{ADAPTIVE, MotionLaw, MotionStep, PointState};
use crate::lab::{LabScene, SceneMethod, contract};
use crate::{lab::contract::By, lab::contract::Model, lab::methods::INTEGRATORS, physics::BodyDef, physics::DVec2};

/// N/kg.
pub const G: f64 = 9.81;
/// kg. Of a box of 1 m, half of which is under water then.
const MASS: f64 = 500.0;
/// kg/m³.
pub const DENSITY: f64 = 1000.0;
/// m. Where the box starts, measured from its place at rest. It neither leaves the water nor goes under.
const SWING: f64 = 0.25;
/// s.
const SECONDS: f64 = 10.0;
/// Periods that the energy has to last for.
const PERIODS: f64 = 1000.0;
/// s. Coarser than elsewhere, for a thousand periods.
const STEPS: [f64; 4] = [1.0 / 30.0, 1.0 / 60.0, 1.0 / 120.0, 1.0 / 240.0];
/// Relative: an energy this far off is a swing that is half a percent too high.
const SEEN: f64 = 0.01;

/// ω² = ρ·g·A/m with A = 1 m², 1/s².
fn stiffness() -> f64 {
    DENSITY * G / MASS
}

/// 1/s.
pub fn omega() -> f64 {
    stiffness().sqrt()
}

/// s.
fn period() -> f64 {
    std::f64::consts::TAU / omega()
}

/// m.
fn place_at(t: f64) -> f64 {
    SWING * libm::cos(omega() * t)
}

/// Energy over its value at the start, `swing` m away at rest, with ω² = `stiffness` 1/s²: the sum of motion and lift.
pub fn energy(point: &PointState, stiffness: f64, swing: f64) -> f64 {
    (point.v.length_squared() / stiffness + point.x.length_squared()) / (swing * swing)
}

fn energy_of(point: &PointState) -> f64 {
    energy(point, stiffness(), SWING)
}

/// A box of such a mass (kg) that starts `swing` m below its place at rest, from which y counts. By hand ω² is `stiffness` 1/s².
pub fn afloat(stiffness: f64, mass: f64, swing: f64) -> FlyingBody {
    let (law, start) = (MotionLaw { spring: stiffness, ..MotionLaw::default() }, DVec2::new(0.0, swing));
    let rest = DVec2::new(0.0, -0.5 + mass / DENSITY);
    let body = BodyDef { position: rest + start, mass, drag: 0.0, ..BodyDef::default() };
    FlyingBody::in_world(law, PointState { x: start, v: DVec2::ZERO }, contract::on_water(G, DENSITY, body), rest)
}

fn swinging() -> FlyingBody {
    afloat(stiffness(), MASS, SWING)
}

fn worst_energy(by: By<MotionStep>, seconds: f64, h: f64) -> f64 {
    worst(swinging().running(by, h).each(seconds, |_, point| (energy_of(point) - 1.0).abs()))
}

fn moments(by: By<MotionStep>, seconds: f64, h: f64) -> Vec<CoursePoint> {
    sampled(swinging().running(by, h).each(seconds, |time, point| {
        let energy = Some(energy_of(point));
        CoursePoint { time, error: (point.x.y - place_at(time)).abs(), energy }
    }))
}

pub fn swing() -> LabScene {
    let title = "A floating box swings without drag (ω = √(ρgA/m)), 10 s";
    let error = |by, h: f64| {
        let end = swinging().end(by, SECONDS, h);
        end.map_or(f64::NAN, |point| (point.x.y - place_at((SECONDS / h).round() * h)).abs())
    };
    let methods = SceneMethod::all(INTEGRATORS.iter().copied(), error);
    let methods = over_tolerances(methods, &swinging(), SECONDS, DVec2::new(0.0, place_at(SECONDS)));
    LabScene { methods, world: swinging().world(), ..LabScene::new("oscillator", title, SECONDS, 1) }
}

pub fn energy_kept() -> LabScene {
    let seconds = PERIODS * period();
    let error = move |by, h| worst_energy(by, seconds, h);
    let course = move |by, h| moments(by, seconds, h);
    let fixed = INTEGRATORS.iter().copied().filter(|(name, _)| *name != ADAPTIVE);
    LabScene {
        error: "worst error of the energy at any time, parts of 1",
        tolerance: SEEN,
        steps: STEPS.to_vec(),
        world: swinging().world(),
        methods: SceneMethod::all_showing(fixed, error, course),
        ..LabScene::new("oscillator-energy", "The energy of a floating box in 1000 swings without drag", seconds, 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lab::methods::motion::{explicit_euler, rk4, velocity_verlet, yoshida};

    /// Verlet's energy on a spring stays within (ωh)²/4 of the right one for ever (Hairer, Lubich, Wanner, I.5); RK4's fades by (ωh)⁶/72 a step.
    #[test]
    fn symplectic_methods_keep_the_energy_that_others_lose() {
        let (h, seconds) = (1.0 / 60.0, PERIODS * period());
        let part = stiffness() * h * h;
        let verlet = worst_energy(By::Hand(velocity_verlet), seconds, h);
        assert!(verlet < part / 3.9 && verlet > part / 4.1, "{verlet:e}, {:e}", part / 4.0);
        let faded = 1.0 - (-(part * part * part) / 72.0 * seconds / h).exp();
        let kutta = worst_energy(By::Hand(rk4), seconds, h);
        assert!((kutta / faded - 1.0).abs() < 0.05, "{kutta:e}, {faded:e}");
        assert!(worst_energy(By::Hand(explicit_euler), 60.0, h) > 10.0);
        // Of fourth order, and no more after a thousand swings than after ten.
        let fourth = |by_seconds: f64, h: f64| worst_energy(By::Hand(yoshida), by_seconds, h);
        assert!(fourth(seconds, h) < 1.01 * fourth(10.0 * period(), h) && fourth(seconds, h) < verlet / 10.0);
        let order = (fourth(10.0, h) / fourth(10.0, 0.5 * h)).log2();
        assert!((order - 4.0).abs() < 0.2, "{order}");
    }
}
