//! Where programs fail: far from the origin, after a hitch, and on nonsense.

use super::{G, Rows, Survival, TICK};
use crate::game::{Clock, TICK_RATE};
use crate::lab::methods::motion::{Law, Point, Step, semi_implicit_euler, semi_implicit_euler_f32};
use crate::lab::{TOLERANCE, shipped};
use crate::physics::{Aabb, BodyDef, BodyId, DVec2, Material, SurfaceDef, World, WorldDef};

/// s.
const DRIFT: f64 = 10.0;

/// The error (m) of something that drifts for 10 s at 1 m/s, so many metres from the origin, by hand.
pub fn drift(step: Step, distance: f64) -> f64 {
    let start = Point { x: DVec2::new(distance, 0.0), v: DVec2::new(1.0, 0.0) };
    let ticks = 0..(DRIFT / TICK) as u32;
    let end = ticks.fold(start, |point, _| step(&Law::default(), point, TICK));
    (end.x.x - distance - DRIFT).abs()
}

/// The same by the shipped engine.
pub fn shipped_drift(distance: f64) -> f64 {
    let start = Point { x: DVec2::new(distance, 0.0), v: DVec2::new(1.0, 0.0) };
    (shipped::flight(&Law::default(), start, DRIFT, TICK).x.x - distance - DRIFT).abs()
}

/// Places keep their tenth of a pixel.
pub fn far_from_the_origin() -> Vec<Survival> {
    let range = (1.0, 1e11);
    Rows::of("drift of 10 s at 1 m/s to a tenth of a pixel", "distance from the origin, m")
        .method("semi-implicit Euler, f32", range, |distance| drift(semi_implicit_euler_f32, distance) <= TOLERANCE)
        .method("semi-implicit Euler, f64", range, |distance| drift(semi_implicit_euler, distance) <= TOLERANCE)
        .shipped(range, |distance| shipped_drift(distance) <= TOLERANCE)
}

/// A box falls from 1 m onto a floor of 0.5 m; then one frame takes long.
pub struct Hitch {
    /// Height of the box's lower side over the floor after it, m.
    pub height: f64,
    /// Ticks that had to be computed for the frame.
    pub ticks: u32,
}

/// m.
const FLOOR: f64 = 0.5;
/// m.
const DROP: f64 = 1.0;
/// Ticks that a frame can afford before the next one is late too.
pub const AFFORDABLE: u32 = 30;

impl Hitch {
    /// Whether the box lies on the floor or is still above it, and the next frame comes in time.
    pub fn survived(&self) -> bool {
        (-TOLERANCE..=DROP + TOLERANCE).contains(&self.height) && self.ticks <= AFFORDABLE
    }
}

/// The box falls by hand for one step: it is put on the floor if it overlaps it then.
fn naive_step((y, v): (f64, f64), h: f64) -> (f64, f64) {
    let v = v - G * h;
    let y = y + v * h;
    let overlaps = y < 0.0 && y > -FLOOR - 1.0;
    if overlaps { (0.0, 0.0) } else { (y, v) }
}

/// The frame's time is the step.
pub fn frame_as_step(frame: f64) -> Hitch {
    Hitch { height: naive_step((DROP, 0.0), frame).0, ticks: 1 }
}

/// Fixed ticks, as many as the frame takes.
pub fn ticks_without_cap(frame: f64) -> Hitch {
    let ticks = (frame * TICK_RATE).floor() as u32;
    let (height, _) = (0..ticks).fold((DROP, 0.0), |ball, _| naive_step(ball, 1.0 / TICK_RATE));
    Hitch { height, ticks }
}

fn box_over_floor() -> WorldDef {
    let mut def = shipped::on_floor(G, 1.0, vec![shipped::crate_at(0.0, DROP, 1.0)]);
    let bounds = Aabb::new(DVec2::new(-10.0, 0.0), DVec2::new(10.0, FLOOR));
    def.surfaces = vec![SurfaceDef::fixed(bounds, Material::ASPHALT)];
    def
}

/// The game's clock and the engine.
pub fn shipped_hitch(frame: f64) -> Hitch {
    let mut clock = Clock::new(TICK_RATE);
    let Ok(mut world) = World::new(box_over_floor()) else { return Hitch { height: f64::NAN, ticks: 0 } };
    clock.add(frame);
    let mut ticks = 0;
    while clock.tick() {
        world.step(1.0 / TICK_RATE);
        ticks += 1;
    }
    Hitch { height: -0.5 - world.body(BodyId(0)).position.y, ticks }
}

/// The engine alone, given the whole frame as one step.
pub fn shipped_step(frame: f64) -> Hitch {
    let world = shipped::run(box_over_floor(), frame, frame);
    Hitch { height: world.map_or(f64::NAN, |world| -0.5 - world.body(BodyId(0)).position.y), ticks: 1 }
}

/// One frame takes long.
pub fn hitch() -> Vec<Survival> {
    let range = (1.0 / 240.0, 10.0);
    Rows::of("a hitch: nothing tunnels, nothing stalls", "length of one frame, s")
        .method("frame time as step", range, |frame| frame_as_step(frame).survived())
        .method("fixed ticks, no cap", range, |frame| ticks_without_cap(frame).survived())
        .method("shipped engine, frame time as step", range, |frame| shipped_step(frame).survived())
        .shipped(range, |frame| shipped_hitch(frame).survived())
}

/// Bodies that make no sense, and what is wrong with them.
pub fn nonsense_bodies() -> Vec<(&'static str, BodyDef)> {
    let body = || BodyDef { position: DVec2::new(0.0, -NONSENSE_HEIGHT), ..BodyDef::default() };
    vec![
        ("a position that is not a number", BodyDef { position: DVec2::NAN, ..body() }),
        ("an infinite velocity", BodyDef { velocity: DVec2::new(f64::INFINITY, 0.0), ..body() }),
        ("a velocity of 1e300 m/s", BodyDef { velocity: DVec2::new(0.0, 1e300), ..body() }),
        ("no mass", BodyDef { mass: 0.0, ..body() }),
        ("a negative mass", BodyDef { mass: -1.0, ..body() }),
        ("no size", BodyDef { half: DVec2::ZERO, ..body() }),
        ("a size of 1e300 m", BodyDef { half: DVec2::splat(1e300), ..body() }),
        ("a drag that is not a number", BodyDef { drag: f64::NAN, ..body() }),
        ("a negative drag", BodyDef { drag: -1.0, ..body() }),
        ("a restitution of 2", BodyDef { restitution: 2.0, drag: 0.0, ..body() }),
    ]
}

/// s.
const NONSENSE: f64 = 10.0;
/// m. From where nonsense falls.
const NONSENSE_HEIGHT: f64 = 20.0;
/// How much faster than after that fall first-order methods may be.
const FASTER: f64 = 1.05;

/// Whether a nonsense body does no harm by hand: its numbers are taken as they are, and for ten seconds over a floor they stay
/// finite and it is never faster than its fall can make it.
pub fn naive_takes(body: &BodyDef) -> bool {
    let area = 2.0 * body.half.x;
    let law = Law {
        constant: DVec2::new(0.0, G * body.mass / body.mass),
        drag: 0.5 * 1.2041 * body.drag * area / body.mass,
        ..Law::default()
    };
    let fastest = FASTER * (body.velocity.length_squared() + 2.0 * G * NONSENSE_HEIGHT).sqrt();
    let mut point = Point { x: body.position, v: body.velocity };
    (0..(NONSENSE / TICK) as u32).all(|_| {
        point = semi_implicit_euler(&law, point, TICK);
        if point.x.y > 0.0 && point.v.y > 0.0 {
            point = Point { x: DVec2::new(point.x.x, 0.0), v: DVec2::new(point.v.x, -body.restitution * point.v.y) };
        }
        point.x.is_finite() && point.v.length() <= fastest
    })
}

/// Whether it does no harm with the shipped engine: it is refused.
pub fn shipped_refuses(body: &BodyDef) -> bool {
    World::new(shipped::on_floor(G, 1.0, vec![body.clone()])).is_err()
}

/// How many kinds of nonsense do no harm.
pub fn nonsense() -> Vec<Survival> {
    let bodies = nonsense_bodies();
    let all = bodies.len() as f64;
    let row = |method: &str, harmless: usize, shipped: bool| Survival {
        test: "nonsense does no harm".to_owned(),
        parameter: "of ten kinds, how many".to_owned(),
        method: method.to_owned(),
        largest: harmless as f64,
        tried: all,
        shipped,
    };
    vec![
        row("taken as it is", bodies.iter().filter(|(_, body)| naive_takes(body)).count(), false),
        row("shipped engine", bodies.iter().filter(|(_, body)| shipped_refuses(body)).count(), true),
    ]
}
