//! Failures far from the origin, after a hitch, on nonsense, and on floors: jitter, stops and bounces that end wrongly or never, energy from nothing.

use super::{G, StressTest, Trial, picture::FailurePicture};
use crate::lab::methods::bounce::{Ball, Bounce, SlideStep, Slider, by_sign, energy, event_loop, impact_times};
use crate::lab::methods::motion::{MotionLaw, MotionStep, PointState, semi_implicit_euler, semi_implicit_euler_f32};
use crate::lab::scenes::bouncing::{
    self, BouncingBall, METHODS, SlidingBox, bounces_until, energy_kept, lossy_apex_at, series_end,
};
use crate::lab::{TICK, TOLERANCE, contract};
use crate::physics::{Aabb, BodyDef, BodyId, DVec2, Material, SurfaceDef, World, WorldDef};
use crate::{game::Clock, game::TICK_RATE, lab::contract::By, lab::contract::Model, lab::scenes::flight::FlyingBody};

/// s.
const DRIFT: f64 = 10.0;

/// A body that drifts at 1 m/s, `distance` m from the origin: the time after each step, and the error of its place, m.
fn drifts(by: By<MotionStep>, distance: f64) -> impl Iterator<Item = (f64, f64)> {
    let start = PointState { x: DVec2::new(distance, 0.0), v: DVec2::new(1.0, 0.0) };
    let body = FlyingBody::in_air(MotionLaw::default(), start);
    body.running(by, TICK).each(DRIFT, move |time, point| (time, point.x.x - distance - time))
}

/// m.
pub fn drift(by: By<MotionStep>, distance: f64) -> f64 {
    drifts(by, distance).last().map_or(f64::NAN, |(_, off)| off.abs())
}

pub fn far_from_the_origin() -> StressTest {
    let methods: [(&str, MotionStep); 2] =
        [("semi-implicit Euler, f32", semi_implicit_euler_f32), ("semi-implicit Euler, f64", semi_implicit_euler)];
    let name = "drift of 10 s at 1 m/s to a tenth of a pixel";
    let picture =
        |by, distance| FailurePicture::of("time, s", "off its place, m").found(drifts(by, distance)).within(0.0, TOLERANCE);
    let methods = Trial::all_showing(methods, |by, distance| drift(by, distance) <= TOLERANCE, picture);
    StressTest::of(name, "distance from the origin, m, at h = 1/60 s", (1.0, 1e11), methods)
}

/// A box falls from 1 m onto a floor of 0.5 m; then one frame takes long.
pub struct Hitch {
    /// m. The box's lower side over the floor after the frame.
    pub height: f64,
    /// Ticks that the frame cost.
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

/// The box falls by hand for one step and is put on the floor if it overlaps it.
fn naive_step((y, v): (f64, f64), h: f64) -> (f64, f64) {
    let v = v - G * h;
    let y = y + v * h;
    let overlaps = y < 0.0 && y > -FLOOR - 1.0;
    if overlaps { (0.0, 0.0) } else { (y, v) }
}

pub fn frame_as_step(frame: f64) -> Hitch {
    Hitch { height: naive_step((DROP, 0.0), frame).0, ticks: 1 }
}

/// Fixed ticks until the frame is over.
pub fn ticks_without_cap(frame: f64) -> Hitch {
    let ticks = (frame * TICK_RATE).floor() as u32;
    let (height, _) = (0..ticks).fold((DROP, 0.0), |ball, _| naive_step(ball, 1.0 / TICK_RATE));
    Hitch { height, ticks }
}

fn box_over_floor() -> WorldDef {
    let mut def = contract::on_floor(G, 1.0, vec![contract::crate_at(0.0, DROP, 1.0)]);
    let bounds = Aabb::new(DVec2::new(-10.0, 0.0), DVec2::new(10.0, FLOOR));
    def.surfaces = vec![SurfaceDef::fixed(bounds, Material::ASPHALT)];
    def
}

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

/// The engine alone, with the whole frame as one step.
pub fn shipped_step(frame: f64) -> Hitch {
    let Ok(mut world) = World::new(box_over_floor()) else { return Hitch { height: f64::NAN, ticks: 0 } };
    world.step(frame);
    Hitch { height: -0.5 - world.body(BodyId(0)).position.y, ticks: 1 }
}

/// The box before the frame and after it, beside how it would have fallen.
fn fallen(frame: f64, hitch: &Hitch) -> FailurePicture {
    let lies = (2.0 * DROP / G).sqrt();
    let exact = (0..=40).map(|i| frame * f64::from(i) / 40.0).map(|t| (t, if t < lies { DROP - 0.5 * G * t * t } else { 0.0 }));
    let picture = FailurePicture::of("time, s", "height, m").found([(0.0, DROP), (frame, hitch.height)]).exact(exact);
    picture.solid(-FLOOR, 0.0)
}

/// The ticks of a frame, beside the ticks that it can afford.
fn asked(frame: f64) -> FailurePicture {
    let asked = [0.0, frame].map(|frame| (frame, f64::from(ticks_without_cap(frame).ticks)));
    let affordable = f64::from(AFFORDABLE);
    FailurePicture::of("length of the frame, s", "ticks to compute").found(asked).exact([(0.0, affordable), (frame, affordable)])
}

pub fn hitch() -> StressTest {
    let methods = vec![
        Trial::new("frame time as step", |frame| frame_as_step(frame).survived())
            .showing(|frame| fallen(frame, &frame_as_step(frame))),
        Trial::new("fixed ticks, no cap", |frame| ticks_without_cap(frame).survived()).showing(asked),
        Trial::new("shipped engine, frame time as step", |frame| shipped_step(frame).survived())
            .showing(|frame| fallen(frame, &shipped_step(frame))),
        Trial::shipped(|frame| shipped_hitch(frame).survived()).showing(|frame| {
            // The clock hands the engine no more than a few ticks of it.
            let hitch = shipped_hitch(frame);
            fallen(f64::from(hitch.ticks) / TICK_RATE, &hitch)
        }),
    ];
    StressTest::of("a hitch: nothing tunnels, nothing stalls", "length of one frame, s", (1.0 / 240.0, 10.0), methods)
}

/// Bodies that make no sense, with the fault of each.
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
/// m. Nonsense falls from this height.
const NONSENSE_HEIGHT: f64 = 20.0;
/// First-order methods may be this much faster than after that fall.
const FASTER: f64 = 1.05;

/// Heights over the floor (m) and speeds (m/s) after each step, for ten seconds, of a nonsense body whose numbers are taken as they are.
fn naively(body: &BodyDef) -> impl Iterator<Item = (f64, f64)> {
    let area = 2.0 * body.half.x;
    let law = MotionLaw {
        constant: DVec2::new(0.0, G * body.mass / body.mass),
        drag: 0.5 * 1.2041 * body.drag * area / body.mass,
        ..MotionLaw::default()
    };
    let (mut point, e) = (PointState { x: body.position, v: body.velocity }, body.restitution);
    (0..(NONSENSE / TICK) as u32).map(move |_| {
        point = semi_implicit_euler(&law, point, TICK);
        if point.x.y > 0.0 && point.v.y > 0.0 {
            point = PointState { x: DVec2::new(point.x.x, 0.0), v: DVec2::new(point.v.x, -e * point.v.y) };
        }
        (if point.x.is_finite() { -point.x.y } else { f64::NAN }, point.v.length())
    })
}

/// Whether a nonsense body does no harm by hand: for ten seconds over a floor its numbers stay finite and it is never faster than after its fall.
pub fn naive_takes(body: &BodyDef) -> bool {
    let fastest = FASTER * (body.velocity.length_squared() + 2.0 * G * NONSENSE_HEIGHT).sqrt();
    naively(body).all(|(height, speed)| height.is_finite() && speed <= fastest)
}

pub fn nonsense() -> StressTest {
    let bodies = nonsense_bodies();
    let all = bodies.len() as f64;
    let harmless = bodies.iter().filter(|(_, body)| naive_takes(body)).count() as f64;
    let refuses = |body: &BodyDef| World::new(contract::on_floor(G, 1.0, vec![body.clone()])).is_err();
    let refused = bodies.iter().filter(|(_, body)| refuses(body)).count() as f64;
    let naive = Trial::new("taken as it is", move |kinds| kinds.floor() <= harmless).showing(move |_| {
        // The last kind, which gives back more than it took.
        let heights = bodies.last().into_iter().flat_map(|(_, body)| naively(body)).enumerate();
        let line = heights.map(|(i, (height, _))| ((i + 1) as f64 * TICK, height));
        FailurePicture::of("time, s", "height at e = 2, m").found(line).exact([(0.0, NONSENSE_HEIGHT), (NONSENSE, NONSENSE_HEIGHT)])
    });
    let methods = vec![naive, Trial::shipped(move |kinds| kinds.floor() <= refused)];
    let test = StressTest::of("nonsense does no harm", "of ten kinds, how many", (1.0, all), methods);
    StressTest { whole: true, ..test }
}

/// s.
const RESTING: f64 = 5.0;
/// Ticks in a picture.
const JITTERS: usize = 30;
/// s.
const MINUTE: f64 = 60.0;
/// Relative tolerance of the end of the bounces and of the energy.
const RIGHT: f64 = 0.01;
pub const SLIDING: SlidingBox = SlidingBox { gravity: G };
/// Impacts after which an event loop counts as endless.
pub const ENDLESS: u32 = 1_000_000;

fn laid(e: f64) -> BouncingBall {
    BouncingBall { height: 0.0, e, rest_speed: 1.0 }
}

/// The speed (m/s) that remains.
pub fn jitter(by: By<Bounce>, e: f64) -> f64 {
    laid(e).end(by, RESTING, TICK).map_or(f64::NAN, |(_, v)| v.abs())
}

/// Rest is exact at every restitution.
pub fn resting_jitter() -> StressTest {
    let picture = |by: By<Bounce>, e: f64| {
        let velocities: Vec<(f64, f64)> = laid(e).running(by, TICK).each(RESTING, |t, ball| (t, ball.1)).collect();
        let last = velocities.len().saturating_sub(JITTERS);
        FailurePicture::of("time, s", "velocity, m/s").found(velocities.into_iter().skip(last)).within(0.0, 0.0)
    };
    let methods = Trial::all_showing(METHODS, |by, e| jitter(by, e) == 0.0, picture);
    StressTest::of("rest without jitter", "restitution e, at h = 1/60 s", (0.01, 1.0), methods)
}

/// The time after each step, place and velocity of a slide of 5 s.
fn slides(by: By<SlideStep>, h: f64) -> impl Iterator<Item = (f64, Slider)> {
    SLIDING.running(by, h).each(RESTING, |t, slider| (t, *slider))
}

/// m and m/s.
pub fn slide(by: By<SlideStep>, h: f64) -> Slider {
    SLIDING.end(by, RESTING, h).unwrap_or((f64::NAN, f64::NAN))
}

fn stopping(by: By<SlideStep>, h: f64) -> FailurePicture {
    let around = (12.0 * h).max(0.1);
    let (from, to) = (SLIDING.stops_after() - around, SLIDING.stops_after() + around);
    let line = slides(by, h).map(|(t, (x, _))| (t, x - SLIDING.stop())).skip_while(|(t, _)| *t < from);
    let picture = FailurePicture::of("time, s", "place beyond the stop, m").found(line.take_while(|(t, _)| *t <= to));
    picture.within(0.0, TOLERANCE)
}

/// The velocities about the stop, in units of friction's change in a step.
fn chattering(h: f64) -> FailurePicture {
    let first = ((SLIDING.stops_after() / h) as usize).saturating_sub(8);
    let line = slides(By::Hand(by_sign), h).enumerate().skip(first).take(24);
    let line = line.map(|(i, (_, (_, v)))| ((i + 1 - first) as f64, v / (SLIDING.brake() * h)));
    FailurePicture::of("steps about the stop", "velocity / friction's in a step").found(line).within(0.0, 0.0)
}

/// Stops dead at v₀²/2μg, within a tenth of a pixel.
pub fn coulomb_stop() -> StressTest {
    let right = |(x, v): Slider| v == 0.0 && (x - SLIDING.stop()).abs() <= TOLERANCE;
    let mut methods = Trial::all_showing(bouncing::SLIDE_METHODS, move |by, h| right(slide(by, h)), stopping);
    methods[0].shown = Some(Box::new(chattering));
    StressTest::of("a slide stops dead, and in the right place", "step h, s", (1e-5, 0.5), methods)
}

/// The balls of a series of bounces from 1 m, a fifth beyond its end, at 60 Hz.
fn series(by: By<Bounce>, e: f64) -> impl Iterator<Item = (f64, Ball)> {
    BouncingBall::of(e).path(by, 1.2 * series_end(e), TICK)
}

/// The end of all its bounces, s.
pub fn end_of_bounces(by: By<Bounce>, e: f64) -> f64 {
    bounces_until(series(by, e))
}

/// The height that remains to a ball at the end of the series of its bounces: the second half of their time, and a fifth more.
fn ending(by: By<Bounce>, e: f64) -> FailurePicture {
    let (end, fall) = (series_end(e), (2.0 * bouncing::HEIGHT / G).sqrt());
    let from = 0.5 * (end + fall);
    let line = series(by, e).map(|(t, ball)| (t, energy(ball, G) / G)).skip_while(|(t, _)| *t < from);
    let exact = (0..=150).map(|i| from + (1.2 * end - from) * f64::from(i) / 150.0).map(|t| (t, lossy_apex_at(e, t)));
    FailurePicture::of("time, s", "height that is left, m").found(line).exact(exact)
}

/// Infinitely many bounces in a finite time, up to e = 0.98.
pub fn zeno() -> StressTest {
    let right = |e: f64, end: f64| (end - series_end(e)).abs() <= RIGHT * series_end(e) + TICK;
    let alone = |e| event_loop((bouncing::HEIGHT, 0.0), G, e, 1.2 * series_end(e), ENDLESS) < ENDLESS;
    let impacts = |e| {
        let times = impact_times((bouncing::HEIGHT, 0.0), G, e).take(60).enumerate();
        let line = times.map(|(i, t)| ((i + 1) as f64, t / series_end(e)));
        FailurePicture::of("impacts", "time / end of the series").found(line).exact([(1.0, 1.0), (60.0, 1.2)])
    };
    let mut methods = vec![Trial::new("event loop alone", alone).showing(impacts)];
    methods.extend(Trial::all_showing(METHODS, move |by, e| right(e, end_of_bounces(by, e)), ending));
    StressTest::of("endless bounces end when the series does", "restitution e, at h = 1/60 s", (0.1, 0.98), methods)
}

/// E/E₀ after a minute of perfect bouncing from 1 m.
pub fn minute(by: By<Bounce>, h: f64) -> f64 {
    energy_kept(by, MINUTE, h)
}

/// Keeps its energy to 1 % for a minute.
pub fn minute_of_bounces() -> StressTest {
    let picture = |by: By<Bounce>, h: f64| {
        let energy = |t: f64, ball: &Ball| (t, energy(*ball, G) / (G * bouncing::HEIGHT));
        let line = BouncingBall::of(1.0).running(by, h).each(MINUTE, energy);
        FailurePicture::of("time, s", "energy / first one").found(line).within(1.0, RIGHT)
    };
    let methods = Trial::all_showing(METHODS, |by, h| (minute(by, h) - 1.0).abs() <= RIGHT, picture);
    StressTest::of("perfect bouncing for 60 s keeps its energy to 1 %", "step h, s", (1e-4, 0.5), methods)
}
