//! Flight with quadratic drag: a fall, whose flow is exact (tanh), a throw into the wind, and a gust that catches something light,
//! which have no closed form (see [`crate::lab::reference`]).

use crate::lab::methods::motion::{Law, METHODS, Point, exact_fall, follow};
use crate::lab::{Scene, reference, shipped};
use crate::physics::DVec2;

/// N/kg.
const G: f64 = 9.81;
/// s.
const SECONDS: f64 = 10.0;
/// s. A gust is over in no time; what follows is a fall at terminal velocity.
const GUST_SECONDS: f64 = 1.0;

fn with_methods(mut scene: Scene, law: Law, start: Point, seconds: f64, exact: DVec2) -> Scene {
    for (name, step) in METHODS {
        scene = scene.method(name, move |h| (follow(step, &law, start, seconds, h).x - exact).length());
    }
    scene
}

/// From rest, with a terminal velocity of 14 m/s.
pub fn fall() -> Scene {
    let law = Law { constant: DVec2::new(0.0, G), drag: 0.05, wind: DVec2::ZERO };
    let start = Point::default();
    let exact = exact_fall(&law, start, SECONDS).x;
    with_methods(
        Scene::new("fall-with-drag", "Fall with drag (terminal velocity 14 m/s), 10 s", SECONDS, 1),
        law,
        start,
        SECONDS,
        exact,
    )
    .method("exact flow", move |h| (follow(exact_fall, &law, start, SECONDS, h).x - exact).length())
    .shipped(move |h| (shipped::flight(&law, start, SECONDS, h).x - exact).length())
}

/// The law and the start of the throw.
pub fn thrown() -> (Law, Point) {
    let law = Law { constant: DVec2::new(0.0, G), drag: 0.05, wind: DVec2::new(4.0, 0.0) };
    (law, Point { x: DVec2::ZERO, v: DVec2::new(20.0, -20.0) })
}

/// Thrown, with the wind.
pub fn projectile() -> Scene {
    let (law, start) = thrown();
    let exact = reference::drag_in_two_dimensions(&law, start, SECONDS).x;
    with_methods(
        Scene::new("projectile", "A throw with drag and wind in two dimensions, 10 s", SECONDS, 1),
        law,
        start,
        SECONDS,
        exact,
    )
    .shipped(move |h| (shipped::flight(&law, start, SECONDS, h).x - exact).length())
}

/// Something that falls at 0.18 m/s, caught by 40 m/s of wind.
pub fn gust() -> Scene {
    let law = Law { constant: DVec2::new(0.0, G), drag: G / (0.18 * 0.18), wind: DVec2::new(40.0, 0.0) };
    let start = Point::default();
    let exact = reference::drag_in_two_dimensions(&law, start, GUST_SECONDS).x;
    let title = "A gust of 40 m/s on something light (terminal velocity 0.18 m/s), 1 s";
    with_methods(Scene::new("gust", title, GUST_SECONDS, 1), law, start, GUST_SECONDS, exact)
        .shipped(move |h| (shipped::flight(&law, start, GUST_SECONDS, h).x - exact).length())
}
