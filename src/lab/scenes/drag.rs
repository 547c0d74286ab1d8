//! Flight with drag: a fall, a rise, drag alone and a thick liquid, whose flows are exact; a throw into the wind, and a gust that
//! catches something light, which have no closed form (see [`crate::lab::reference`]).

use crate::lab::methods::flow::{drag_alone, in_liquid, rise_and_fall};
use crate::lab::methods::motion::{Law, METHODS, Point, Step, exact_fall, follow};
use crate::lab::{Scene, reference, shipped};
use crate::physics::{BodyId, DVec2};

/// N/kg.
const G: f64 = 9.81;
/// s.
const SECONDS: f64 = 10.0;
/// m/s. Terminal velocity of what the gust catches.
pub const LIGHT: f64 = 0.18;
/// s. A gust is over in no time; what follows is a fall at terminal velocity.
const GUST_SECONDS: f64 = 1.0;

fn with_methods(mut scene: Scene, law: Law, start: Point, seconds: f64, exact: DVec2) -> Scene {
    for (name, step) in METHODS {
        scene = scene.method(name, move |h| (follow(step, &law, start, seconds, h).x - exact).length());
    }
    scene
}

/// A scene whose flow is known.
fn with_flow(name: &'static str, title: &str, flow: Step, law: Law, start: Point) -> Scene {
    let exact = flow(&law, start, SECONDS).x;
    with_methods(Scene::new(name, title, SECONDS, 1), law, start, SECONDS, exact)
        .method("exact flow", move |h| (follow(flow, &law, start, SECONDS, h).x - exact).length())
}

/// The same with the engine in air.
fn flown(name: &'static str, title: &str, flow: Step, law: Law, start: Point) -> Scene {
    let exact = flow(&law, start, SECONDS).x;
    with_flow(name, title, flow, law, start).shipped(move |h| (shipped::flight(&law, start, SECONDS, h).x - exact).length())
}

/// From rest, with a terminal velocity of 14 m/s.
pub fn fall() -> Scene {
    let (law, start) = (Law { constant: DVec2::new(0.0, G), drag: 0.05, ..Law::default() }, Point::default());
    let title = "Fall with drag (terminal velocity 14 m/s), 10 s";
    flown("fall-with-drag", title, exact_fall, law, start)
}

/// Thrown up, and falling again.
pub fn rise() -> Scene {
    let law = Law { constant: DVec2::new(0.0, G), drag: 0.05, ..Law::default() };
    let start = Point { x: DVec2::ZERO, v: DVec2::new(0.0, -20.0) };
    let title = "Thrown up at 20 m/s with drag, and down again, 10 s";
    flown("rise-with-drag", title, rise_and_fall, law, start)
        .noting("At the apex the second derivative of drag jumps: no order above 3 shows there.")
}

/// Without weight.
pub fn alone() -> Scene {
    let law = Law { drag: 0.05, ..Law::default() };
    let start = Point { x: DVec2::ZERO, v: DVec2::new(20.0, -15.0) };
    let title = "Drag alone, from 25 m/s, 10 s";
    flown("drag-alone", title, drag_alone, law, start)
}

/// Sinking through a liquid so thick that its drag is in proportion to the velocity.
pub fn liquid() -> Scene {
    let (mass, density, viscous) = (1500.0, 1000.0, 0.5);
    let law = Law { constant: DVec2::new(0.0, G * (1.0 - density / mass)), viscous, ..Law::default() };
    let start = Point { x: DVec2::ZERO, v: DVec2::new(2.0, -3.0) };
    let exact = in_liquid(&law, start, SECONDS).x;
    let title = "Sinking through a thick liquid (linear drag, buoyancy), 10 s";
    with_flow("liquid", title, in_liquid, law, start).shipped(move |h| {
        let world = shipped::run(shipped::in_liquid(viscous, density, mass, G, start), SECONDS, h);
        world.map_or(f64::NAN, |world| (world.body(BodyId(0)).position - exact).length())
    })
}

/// The law and the start of the throw.
pub fn thrown() -> (Law, Point) {
    let law = Law { constant: DVec2::new(0.0, G), drag: 0.05, wind: DVec2::new(4.0, 0.0), ..Law::default() };
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
    let law = Law { constant: DVec2::new(0.0, G), drag: G / (LIGHT * LIGHT), wind: DVec2::new(40.0, 0.0), ..Law::default() };
    let start = Point::default();
    let exact = reference::drag_in_two_dimensions(&law, start, GUST_SECONDS).x;
    let title = "A gust of 40 m/s on something light (terminal velocity 0.18 m/s), 1 s";
    with_methods(Scene::new("gust", title, GUST_SECONDS, 1), law, start, GUST_SECONDS, exact)
        .shipped(move |h| (shipped::flight(&law, start, GUST_SECONDS, h).x - exact).length())
}
