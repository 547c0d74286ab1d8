//! Flight: without drag, where x = x₀ + v₀·t + g·t²/2; a fall, a rise, a thick liquid, whose flows are exact; throw and gust without a closed form:
//! by RK4 with a step of 1e-5 s, finer where drag is fast, and, as a check, by a method that shares neither its equation nor its code: with
//! q = exp(∫k|u|dt), Q = ∫q dt the velocity in the air's frame is u = (u₀ + A·Q)/Q′ exactly, and Q″ = k·|u₀ + A·Q| is one scalar equation.

use crate::lab::contract::{self, By, Model};
use crate::lab::methods::motion::{
    ADAPTIVE, MotionLaw, MotionStep, PointState, adaptive_to, in_liquid, rise_and_fall, rk4, tolerance,
};
use crate::physics::{BodyId, DVec2, World, WorldDef};
use crate::{lab::LabScene, lab::SceneMethod, lab::methods::METHODS};

/// N/kg.
const G: f64 = 9.81;
/// s.
const SECONDS: f64 = 10.0;
/// 1/m. Drag of all bodies but the light one: a terminal velocity of 14 m/s.
const DRAG: f64 = 0.05;
const FALLING: [&str; 4] = ["explicit Euler", "semi-implicit Euler", "velocity Verlet", "implicit Euler"];
/// m/s.
pub const LIGHT: f64 = 0.18;
/// s. A gust is over in no time; a fall at terminal velocity follows.
const GUST_SECONDS: f64 = 1.0;

#[derive(Clone, Debug)]
pub struct FlyingBody {
    pub law: MotionLaw,
    pub start: PointState,
    def: WorldDef,
    /// m. The law's origin in the world.
    origin: DVec2,
}

impl FlyingBody {
    pub fn in_air(law: MotionLaw, start: PointState) -> Self {
        Self { law, start, def: contract::in_air(&law, start), origin: DVec2::ZERO }
    }

    pub(in crate::lab) fn in_world(law: MotionLaw, start: PointState, def: WorldDef, origin: DVec2) -> Self {
        Self { law, start, def, origin }
    }

    /// The distance from `exact` after `seconds`, m.
    pub(super) fn error(&self, by: By<MotionStep>, seconds: f64, h: f64, exact: DVec2) -> f64 {
        self.end(by, seconds, h).map_or(f64::NAN, |point| (point.x - exact).length())
    }
}

impl Model for FlyingBody {
    type State = PointState;
    type Method = MotionStep;

    fn start(&self) -> PointState {
        self.start
    }

    fn step(&self, method: MotionStep, point: &mut PointState, h: f64) {
        *point = method(&self.law, *point, h);
    }

    fn world(&self) -> Option<World> {
        World::new(self.def.clone()).ok()
    }

    /// Back to the ground's frame from that of the air. Of two bodies, the way from the second to the first.
    fn read(&self, world: &World, time: f64, point: &mut PointState) {
        let body = world.body(BodyId(0));
        let (place, velocity) =
            world.bodies().get(1).map_or((self.origin, -self.law.wind), |other| (other.position, other.velocity));
        *point = PointState { x: body.position - place + self.law.wind * time, v: body.velocity - velocity };
    }
}

/// The adaptive method's points are those of tolerances, each with the whole scene for its step.
pub(super) fn over_tolerances(mut methods: Vec<SceneMethod>, body: &FlyingBody, seconds: f64, exact: DVec2) -> Vec<SceneMethod> {
    for method in methods.iter_mut().filter(|method| method.name == ADAPTIVE) {
        let (law, start) = (body.law, body.start);
        method.run = Box::new(move |h| (adaptive_to(tolerance(h), &law, start, seconds).x - exact).length());
    }
    methods
}

/// A scene of `seconds` that ends at `exact` (m).
fn scene(name: &'static str, title: &str, seconds: f64, body: FlyingBody, exact: DVec2, flow: Option<MotionStep>) -> LabScene {
    let world = body.world();
    let methods = METHODS.into_iter().chain(flow.map(|flow| ("exact flow", flow)));
    let known = body.clone();
    let methods = SceneMethod::all(methods, move |by, h| known.error(by, seconds, h, exact));
    LabScene { methods: over_tolerances(methods, &body, seconds, exact), world, ..LabScene::new(name, title, seconds, 1) }
}

fn with_flow(name: &'static str, title: &str, body: FlyingBody, flow: MotionStep) -> LabScene {
    let exact = flow(&body.law, body.start, SECONDS).x;
    scene(name, title, SECONDS, body, exact, Some(flow))
}

pub fn fall() -> LabScene {
    let law = MotionLaw { constant: DVec2::new(0.0, G), ..MotionLaw::default() };
    let exact = law.constant * (0.5 * SECONDS * SECONDS);
    let mut fall = scene("fall", "Fall without drag, 10 s", SECONDS, FlyingBody::in_air(law, PointState::default()), exact, None);
    // All others are exact, too, or one of these.
    fall.methods.retain(|method| method.shipped || FALLING.contains(&method.name.as_str()));
    fall
}

pub fn rise() -> LabScene {
    let law = MotionLaw { constant: DVec2::new(0.0, G), drag: DRAG, ..MotionLaw::default() };
    let start = PointState { x: DVec2::ZERO, v: DVec2::new(0.0, -20.0) };
    let title = "Thrown up at 20 m/s with drag, and down again, 10 s";
    let note = "At the apex the second derivative of drag jumps: no order above 3 shows there.";
    LabScene { note, ..with_flow("rise-with-drag", title, FlyingBody::in_air(law, start), rise_and_fall) }
}

/// Sinking through a liquid so thick that its drag is in proportion to the velocity.
pub fn liquid() -> LabScene {
    let (mass, density, viscous) = (1500.0, 1000.0, 0.5);
    let law = MotionLaw { constant: DVec2::new(0.0, G * (1.0 - density / mass)), viscous, ..MotionLaw::default() };
    let start = PointState { x: DVec2::ZERO, v: DVec2::new(2.0, -3.0) };
    let body = FlyingBody::in_world(law, start, contract::in_liquid(viscous, density, mass, G, start), DVec2::ZERO);
    with_flow("liquid", "Sinking through a thick liquid (linear drag, buoyancy), 10 s", body, in_liquid)
}

pub fn thrown() -> FlyingBody {
    let law = MotionLaw { constant: DVec2::new(0.0, G), drag: DRAG, wind: DVec2::new(4.0, 0.0), ..MotionLaw::default() };
    FlyingBody::in_air(law, PointState { x: DVec2::ZERO, v: DVec2::new(20.0, -20.0) })
}

pub fn projectile() -> LabScene {
    by_reference("projectile", "A throw with drag and wind in two dimensions, 10 s", SECONDS, thrown())
}

/// A body that falls at 0.18 m/s, in a wind of 40 m/s.
pub fn gust() -> LabScene {
    let law =
        MotionLaw { constant: DVec2::new(0.0, G), drag: G / (LIGHT * LIGHT), wind: DVec2::new(40.0, 0.0), ..MotionLaw::default() };
    let title = "A gust of 40 m/s on something light (terminal velocity 0.18 m/s), 1 s";
    by_reference("gust", title, GUST_SECONDS, FlyingBody::in_air(law, PointState::default()))
}

fn by_reference(name: &'static str, title: &str, seconds: f64, body: FlyingBody) -> LabScene {
    let exact = drag_in_two_dimensions(&body.law, body.start, seconds).x;
    scene(name, title, seconds, body, exact, None)
}

/// s. The longest step. Finer, and rounding grows.
pub const STEP: f64 = 1e-5;
/// How much of its velocity drag may take in a step. Coarser, and a gust of 40 m/s on the lightest thing costs RK4 5e-9 m.
const LOST: f64 = 0.01;

/// By RK4 in steps of [`STEP`], or of less where drag is fast.
pub fn drag_in_two_dimensions(law: &MotionLaw, start: PointState, seconds: f64) -> PointState {
    // Whole steps that fill the time: a sum of many rounded steps would miss its end.
    let steps = (seconds / STEP).ceil().max(1.0);
    let h = seconds / steps;
    (0..steps as u64).fold(start, |point, _| {
        let rate = law.drag * (point.v - law.wind).length() + law.viscous;
        let parts = (rate * h / LOST).ceil().max(1.0);
        (0..parts as u64).fold(point, |point, _| rk4(law, point, h / parts))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By the scalar equation, started again in each step of `h` s, so that Q′ cannot overflow; Q by RK4 and the distance by Simpson's rule on
    /// the same stages.
    fn by_scalar_equation(law: &MotionLaw, start: PointState, seconds: f64, h: f64) -> PointState {
        let steps = (seconds / h).round() as u64;
        (0..steps).fold(start, |PointState { x, v }, _| {
            let u0 = v - law.wind;
            let curve = |q: f64| law.drag * (u0 + law.constant * q).length();
            let (mut q, mut rate) = (0.0, 1.0);
            let mut middle = (0.0, 1.0);
            // Two half steps of RK4, for Simpson's rule needs the velocity in the middle.
            for half in 0..2 {
                let d = 0.5 * h;
                let k1 = (rate, curve(q));
                let k2 = (rate + 0.5 * d * k1.1, curve(q + 0.5 * d * k1.0));
                let k3 = (rate + 0.5 * d * k2.1, curve(q + 0.5 * d * k2.0));
                let k4 = (rate + d * k3.1, curve(q + d * k3.0));
                q += d / 6.0 * (k1.0 + 2.0 * (k2.0 + k3.0) + k4.0);
                rate += d / 6.0 * (k1.1 + 2.0 * (k2.1 + k3.1) + k4.1);
                if half == 0 {
                    middle = (q, rate);
                }
            }
            let velocity = |(q, rate): (f64, f64)| (u0 + law.constant * q) / rate;
            let end = velocity((q, rate));
            PointState { x: x + law.wind * h + (u0 + velocity(middle) * 4.0 + end) * (h / 6.0), v: end + law.wind }
        })
    }

    #[test]
    fn two_methods_agree() {
        for (drag, v) in
            [(0.05, DVec2::new(20.0, -20.0)), (9.81 / 0.0324, DVec2::new(40.0, 0.0)), (9.81 / 0.0324, DVec2::new(-36.0, 0.0))]
        {
            let law = MotionLaw { constant: DVec2::new(0.0, 9.81), drag, wind: DVec2::new(4.0, 0.0), ..MotionLaw::default() };
            let start = PointState { x: DVec2::ZERO, v };
            let one = drag_in_two_dimensions(&law, start, 0.5);
            let other = by_scalar_equation(&law, start, 0.5, 0.5 * STEP);
            assert!((one.x - other.x).length() < 1e-10, "{one:?} {other:?}");
            assert!((one.v - other.v).length() < 1e-10, "{one:?} {other:?}");
        }
    }

    #[test]
    fn any_time_is_met_exactly() {
        let law = MotionLaw::default();
        let start = PointState { x: DVec2::ZERO, v: DVec2::new(3.0, -4.0) };
        for seconds in [1.0 / 60.0, 1.234_567, 1e-7] {
            let end = drag_in_two_dimensions(&law, start, seconds);
            assert!((end.x - start.v * seconds).length() < 1e-10 * seconds.max(1e-3), "{seconds} s");
        }
    }
}
