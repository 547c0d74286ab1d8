//! Flight: without drag, where x = x₀ + v₀·t + g·t²/2; a fall, a rise, drag alone and a thick liquid, whose flows are exact; a throw into
//! the wind, and a gust on a light body, which have no closed form (see [`crate::lab::reference`]).

use crate::lab::contract::{By, Model};
use crate::lab::methods::METHODS;
use crate::lab::methods::motion::{ADAPTIVE, MotionLaw, MotionStep, PointState, adaptive_to, in_liquid, rise_and_fall, tolerance};
use crate::lab::{LabScene, SceneMethod, contract, reference};
use crate::physics::{BodyId, DVec2, World, WorldDef};

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
    let exact = reference::drag_in_two_dimensions(&body.law, body.start, seconds).x;
    scene(name, title, seconds, body, exact, None)
}
