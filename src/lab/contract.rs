//! The one contract of the lab: a [`Model`] is a motion that is stepped by methods by hand, and by the shipped engine in a world that holds the same.
//! A scene is a question with an exact answer, and the methods that are to answer it.

use super::methods::motion::{MotionLaw, PointState};
use super::{TOLERANCE, curve::CoursePoint, methods::impact::LineBlock};
use crate::physics::{Aabb, BodyDef, DVec2, FluidDef, Material, SurfaceDef, World, WorldDef};

/// The name of the shipped engine in legends and tables.
pub const SHIPPED: &str = "shipped engine";

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum By<S> {
    Hand(S),
    Engine,
}

/// The shipped engine stands behind the methods by hand.
pub fn contenders<S>(by_hand: impl IntoIterator<Item = (&'static str, S)>) -> impl Iterator<Item = (&'static str, By<S>)> {
    let by_hand = by_hand.into_iter().map(|(name, method)| (name, By::Hand(method)));
    by_hand.chain(std::iter::once_with(|| (SHIPPED, By::Engine)))
}

pub struct Entrant<R, P> {
    pub name: String,
    pub shipped: bool,
    pub run: Box<dyn Fn(f64) -> R>,
    /// The result and the course of the run, where the scene is one to be followed.
    pub shown: Option<Box<dyn Fn(f64) -> P>>,
}

impl<R: 'static, P: 'static> Entrant<R, P> {
    pub fn new(name: impl Into<String>, run: impl Fn(f64) -> R + 'static) -> Self {
        Self { name: name.into(), shipped: false, run: Box::new(run), shown: None }
    }

    pub fn shipped(run: impl Fn(f64) -> R + 'static) -> Self {
        Self { shipped: true, ..Self::new(SHIPPED, run) }
    }

    #[must_use]
    pub fn showing(self, show: impl Fn(f64) -> P + 'static) -> Self {
        Self { shown: Some(Box::new(show)), ..self }
    }

    pub fn all<S: Copy + 'static>(
        by_hand: impl IntoIterator<Item = (&'static str, S)>,
        run: impl Fn(By<S>, f64) -> R + Clone + 'static,
    ) -> Vec<Self> {
        let entrant = |(name, by): (&'static str, By<S>)| {
            let run = run.clone();
            Self { shipped: matches!(by, By::Engine), ..Self::new(name, move |value| run(by, value)) }
        };
        contenders(by_hand).map(entrant).collect()
    }

    pub fn all_showing<S: Copy + 'static>(
        by_hand: impl IntoIterator<Item = (&'static str, S)> + Clone,
        run: impl Fn(By<S>, f64) -> R + Clone + 'static,
        show: impl Fn(By<S>, f64) -> P + Clone + 'static,
    ) -> Vec<Self> {
        let shows = contenders(by_hand.clone()).map(|(_, by)| {
            let show = show.clone();
            move |value| show(by, value)
        });
        Self::all(by_hand, run).into_iter().zip(shows).map(|(entrant, show)| entrant.showing(show)).collect()
    }
}

pub trait Model: Clone {
    type State: Clone;
    /// A method by hand: a function, or its settings.
    type Method: Copy;

    /// The state at 0 s.
    fn start(&self) -> Self::State;

    /// A step of `h` s by hand.
    fn step(&self, method: Self::Method, state: &mut Self::State, h: f64);

    /// `None` where the engine refuses the motion.
    fn world(&self) -> Option<World>;

    /// Takes the state over from that world, `time` s after the start.
    fn read(&self, world: &World, time: f64, state: &mut Self::State);

    /// The state after `seconds`, in steps of `h` s.
    fn end(&self, by: By<Self::Method>, seconds: f64, h: f64) -> Option<Self::State> {
        let steps = steps(seconds, h);
        let mut state = self.start();
        match by {
            By::Hand(method) => (0..steps).for_each(|_| self.step(method, &mut state, h)),
            By::Engine => {
                let mut world = self.world()?;
                (0..steps).for_each(|_| world.step(h));
                self.read(&world, seconds, &mut state);
            }
        }
        Some(state)
    }

    fn running(&self, by: By<Self::Method>, h: f64) -> Running<Self> {
        let world = if let By::Engine = by { self.world() } else { None };
        Running { model: self.clone(), state: self.start(), by, world, h, steps: 0 }
    }
}

fn steps(seconds: f64, h: f64) -> u64 {
    (seconds / h).round() as u64
}

pub struct Running<M: Model> {
    model: M,
    state: M::State,
    by: By<M::Method>,
    /// The engine's; none where it refuses the model.
    world: Option<World>,
    h: f64,
    steps: u64,
}

impl<M: Model> Running<M> {
    /// An answer from the time (s) and the state after each step for `seconds`; none where the engine refuses the model.
    pub fn each<T>(mut self, seconds: f64, mut ask: impl FnMut(f64, &M::State) -> T) -> impl Iterator<Item = T> {
        (0..steps(seconds, self.h)).map_while(move |_| self.step().map(|(time, state)| ask(time, state)))
    }

    /// The time after the step, s, and the state. `None` where the engine refuses the model.
    pub fn step(&mut self) -> Option<(f64, &M::State)> {
        self.steps += 1;
        let time = self.steps as f64 * self.h;
        match self.by {
            By::Hand(method) => self.model.step(method, &mut self.state, self.h),
            By::Engine => {
                let world = self.world.as_mut()?;
                world.step(self.h);
                self.model.read(world, time, &mut self.state);
            }
        }
        Some((time, &self.state))
    }
}

/// The ladder of steps, s. The game's tick is among them.
pub(super) const LADDER: [f64; 7] = [1.0 / 15.0, 1.0 / 30.0, 1.0 / 60.0, 1.0 / 120.0, 1.0 / 240.0, 1.0 / 480.0, 1.0 / 960.0];

pub(super) const WORK: &str = "CPU time for a simulated second and body, ns";

pub struct LabScene {
    pub name: &'static str,
    pub title: String,
    /// With its unit, for the axis.
    pub error: &'static str,
    /// In the error's unit: the largest error that no eye sees.
    pub tolerance: f64,
    /// With its unit, for the axis.
    pub work: &'static str,
    /// Work is divided by this: simulated seconds × bodies.
    pub share: f64,
    /// Steps to try, s, from the coarsest.
    pub steps: Vec<f64>,
    /// The step at which the game ships, s.
    pub shipped_step: f64,
    /// Whether all methods answer the same question, so that the cheapest right one can be named.
    pub alike: bool,
    /// A note for the reader of the diagram, or empty.
    pub note: &'static str,
    /// The shipped engine is the last.
    pub methods: Vec<SceneMethod>,
    /// The shipped engine's world at the start, for what its plan saves; none where none runs.
    pub world: Option<World>,
}

/// A method in a scene: a step (s) gives the error of the whole scene, and its course.
pub type SceneMethod = Entrant<f64, Vec<CoursePoint>>;

impl LabScene {
    /// A scene of `seconds` and `bodies` on the usual ladder, whose error is a distance.
    pub(super) fn new(name: &'static str, title: impl Into<String>, seconds: f64, bodies: usize) -> Self {
        Self {
            name,
            title: title.into(),
            error: "error of position at the end, m",
            tolerance: TOLERANCE,
            work: WORK,
            share: seconds * bodies as f64,
            steps: LADDER.to_vec(),
            shipped_step: 1.0 / crate::game::TICK_RATE,
            alike: true,
            note: "",
            methods: Vec::new(),
            world: None,
        }
    }
}

/// A floor whose top is at y = 0.
pub(super) fn floor() -> SurfaceDef {
    SurfaceDef::fixed(Aabb::new(DVec2::new(-1e4, 0.0), DVec2::new(1e4, 1.0)), Material::ASPHALT)
}

/// Bodies above that floor, without air.
pub(super) fn on_floor(gravity: f64, rest_speed: f64, bodies: Vec<BodyDef>) -> WorldDef {
    WorldDef { gravity, rest_speed, air_density: 0.0, bodies, surfaces: vec![floor()], ..WorldDef::default() }
}

/// A box of 1 m whose lower side is at height `y` above the floor.
pub(super) fn crate_at(x: f64, y: f64, mass: f64) -> BodyDef {
    BodyDef { position: DVec2::new(x, -0.5 - y), mass, ..BodyDef::default() }
}

/// One body that obeys `law`, which pulls downwards only; round, since drag has no direction. Uniform wind is another frame, whose air stands still.
pub(super) fn in_air(law: &MotionLaw, start: PointState) -> WorldDef {
    let body = BodyDef { position: start.x, velocity: start.v - law.wind, drag: 2.0 * law.drag, round: true, ..BodyDef::default() };
    WorldDef { gravity: law.constant.y, air_density: 1.0, bodies: vec![body], ..WorldDef::default() }
}

/// One box of 1 m and `mass` kg in a liquid (kg/m³) so thick that it takes `viscous` of its velocity a second: Stokes' 3π·η·d/m with d = 1 m.
pub(super) fn in_liquid(viscous: f64, density: f64, mass: f64, gravity: f64, start: PointState) -> WorldDef {
    let zone = Aabb::around(start.x, DVec2::splat(1e4));
    let fluid = FluidDef { zone, density, viscosity: viscous * mass / (3.0 * std::f64::consts::PI) };
    let body = BodyDef { position: start.x, velocity: start.v, mass, drag: 0.0, ..BodyDef::default() };
    WorldDef { gravity, air_density: 0.0, bodies: vec![body], fluids: vec![fluid], ..WorldDef::default() }
}

/// A world with one body on a wide and deep liquid whose surface is at y = 0.
pub(super) fn on_water(gravity: f64, density: f64, body: BodyDef) -> WorldDef {
    let zone = Aabb::new(DVec2::new(-1e3, 0.0), DVec2::new(1e3, 1e3));
    let fluid = FluidDef { zone, density, viscosity: 0.0 };
    WorldDef { gravity, air_density: 0.0, bodies: vec![body], fluids: vec![fluid], ..WorldDef::default() }
}

/// A line of blocks without gravity and air; a block of infinite mass is a wall.
pub(super) fn line(blocks: &[LineBlock], e: f64) -> WorldDef {
    let movable = blocks.iter().filter(|block| block.mass.is_finite());
    let bodies = movable.map(|block| BodyDef {
        position: DVec2::new(block.x, 0.0),
        velocity: DVec2::new(block.v, 0.0),
        half: DVec2::new(block.half, 0.5),
        mass: block.mass,
        restitution: e,
        ..BodyDef::default()
    });
    let walls = blocks.iter().filter(|block| block.mass.is_infinite());
    let surfaces = walls
        .map(|block| SurfaceDef::fixed(Aabb::around(DVec2::new(block.x, 0.0), DVec2::new(block.half, 100.0)), Material::STEEL));
    WorldDef { gravity: 0.0, air_density: 0.0, bodies: bodies.collect(), surfaces: surfaces.collect(), ..WorldDef::default() }
}
