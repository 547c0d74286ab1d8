//! A scene, and the parts that scenes share.

use crate::engine::{Box, Spec};
use crate::watch::Run;

/// The step at which physics engines are usually run, s.
pub const STEP: f64 = 1.0 / 60.0;
/// N/kg.
pub const G: f64 = 9.81;
/// Coefficient of friction.
pub const FRICTION: f64 = 0.65;
/// A floor's half height, m.
pub const FLOOR: f64 = 0.5;

/// A scene.
#[derive(Clone)]
pub struct Scene {
    /// As in the lab, where it is one of the lab's.
    pub name: &'static str,
    /// What its error is, with its unit.
    pub what: &'static str,
    /// What it consists of.
    pub spec: Spec,
    /// How long it runs before anything counts, s.
    pub settle: f64,
    /// How long it runs then, s.
    pub seconds: f64,
    /// The steps at which it is run, s.
    pub steps: &'static [f64],
    /// Whether it is run by stiff engines, too.
    pub stiffly: bool,
    /// Whether every island of ours takes the crowd step.
    pub pile: bool,
    /// Runs a number of steps of a length, s, and returns the distance from the exact answer.
    pub error: Error,
}

/// See [`Scene::error`].
pub type Error = fn(&mut dyn Run, &Spec, usize, f64) -> f64;

/// A scene at the usual step and with the usual settings.
pub fn scene(name: &'static str, what: &'static str, seconds: f64, spec: Spec, error: Error) -> Scene {
    Scene { name, what, spec, settle: 0.0, seconds, steps: &[STEP], stiffly: false, pile: false, error }
}

/// Bodies over a floor.
pub fn spec(bodies: Vec<Box>) -> Spec {
    Spec {
        gravity: G,
        friction: FRICTION,
        terminal: f64::INFINITY,
        swept: false,
        sleep: false,
        stiff: false,
        bodies,
        statics: vec![((0.0, FLOOR), (1000.0, FLOOR))],
        liquid: None,
        lift: None,
    }
}

/// A box of 1 m and `mass` kg whose lower side is at height `y` over the floor.
pub fn crate_at(x: f64, y: f64, mass: f64) -> Box {
    Box { position: (x, -0.5 - y), velocity: (0.0, 0.0), half: (0.5, 0.5), mass, restitution: 0.0, force: 0.0 }
}

/// Lets it run.
pub fn run(engine: &mut dyn Run, steps: usize, step: f64) {
    (0..steps).for_each(|_| engine.step(step));
}

/// The worst of all bodies: how far each has fallen from rest, against g·t²/2, m.
pub fn fallen(engine: &mut dyn Run, spec: &Spec, steps: usize, step: f64) -> f64 {
    run(engine, steps, step);
    let t = steps as f64 * step;
    let off = |(i, body): (usize, &Box)| (engine.position(i).1 - body.position.1 - 0.5 * G * t * t).abs();
    spec.bodies.iter().enumerate().map(off).fold(0.0, f64::max)
}
