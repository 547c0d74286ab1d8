//! Free flight without drag. Exact: x = x₀ + v₀·t + g·t²/2.

use crate::lab::methods::motion::{Law, METHODS, Point, follow};
use crate::lab::{Scene, shipped};
use crate::physics::DVec2;

/// s.
const SECONDS: f64 = 10.0;
/// N/kg.
const G: f64 = 9.81;

/// From rest.
pub fn fall() -> Scene {
    scene("fall", "Fall without drag, 10 s", DVec2::ZERO)
}

/// Thrown.
pub fn parabola() -> Scene {
    scene("parabola", "A throw without drag, 10 s", DVec2::new(20.0, -30.0))
}

fn scene(name: &'static str, title: &str, v: DVec2) -> Scene {
    let law = Law { constant: DVec2::new(0.0, G), ..Law::default() };
    let start = Point { x: DVec2::ZERO, v };
    let exact = v * SECONDS + law.constant * (0.5 * SECONDS * SECONDS);
    let mut scene = Scene::new(name, title, SECONDS, 1);
    for (name, step) in METHODS {
        scene = scene.method(name, move |h| (follow(step, &law, start, SECONDS, h).x - exact).length());
    }
    scene.shipped(move |h| (shipped::flight(&law, start, SECONDS, h).x - exact).length())
}
