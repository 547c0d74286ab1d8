//! What every engine is given, and what it has to answer.

/// A vector: x to the right, y down.
pub type V = (f64, f64);

/// A box that moves.
#[derive(Clone, Debug)]
pub struct Box {
    /// Centre, m.
    pub position: V,
    /// m/s.
    pub velocity: V,
    /// Half its size, m.
    pub half: V,
    /// kg.
    pub mass: f64,
    /// A pair bounces with the larger of its two; what does not move has none.
    pub restitution: f64,
    /// A constant force to the right, N.
    pub force: f64,
}

/// What a scene consists of.
#[derive(Clone, Debug)]
pub struct Spec {
    /// N/kg, downwards.
    pub gravity: f64,
    /// Coefficient of friction of everything, static and kinetic.
    pub friction: f64,
    /// The speed, m/s, at which the air carries everything's weight; infinite without air. Resultant's drag is quadratic; the
    /// others only know a linear one, which is set to the same terminal speed.
    pub terminal: f64,
    /// Whether fast bodies are swept where an engine does so only when asked.
    pub swept: bool,
    /// Whether what rests may sleep.
    pub sleep: bool,
    /// What moves.
    pub bodies: Vec<Box>,
    /// What does not: centre and half size, m.
    pub statics: Vec<(V, V)>,
}

/// An engine with a scene in it.
pub trait Engine: Sized {
    /// For the table.
    const NAME: &'static str;
    /// Whether its drag grows with the square of the speed.
    const QUADRATIC: bool;
    /// Builds the scene; `None` if the engine refuses it.
    fn new(spec: &Spec) -> Option<Self>;
    /// One step of so many seconds.
    fn step(&mut self, dt: f64);
    /// A body's centre, m.
    fn position(&mut self, body: usize) -> V;
    /// Its velocity, m/s.
    fn velocity(&mut self, body: usize) -> V;
}
