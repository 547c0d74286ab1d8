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

/// Water.
#[derive(Clone, Debug)]
pub struct Liquid {
    /// Centre and half size, m.
    pub zone: (V, V),
    /// kg/m³: the scene is 1 m deep.
    pub density: f64,
    /// Of engines that know no liquid: how fast it stops what is wholly inside, 1/s.
    pub damping: f64,
}

impl Liquid {
    /// What acts on a body in it besides its weight, N, for engines that know no liquid: Archimedes' force, and a linear drag by the part
    /// that is inside.
    pub fn force_on(&self, body: &Box, (_, y): V, (u, w): V, gravity: f64) -> V {
        let ((_, middle), (_, half)) = self.zone;
        let (top, bottom) = ((y - body.half.1).max(middle - half), (y + body.half.1).min(middle + half));
        let inside = (bottom - top).max(0.0);
        let drag = self.damping * body.mass * inside / (2.0 * body.half.1);
        (-drag * u, -drag * w - self.density * gravity * inside * 2.0 * body.half.0)
    }
}

/// A platform that goes up and down for ever, speeding up and slowing down at the same rate.
#[derive(Clone, Debug)]
pub struct Lift {
    /// Centre at its lowest, and half size, m.
    pub place: (V, V),
    /// m.
    pub rise: f64,
    /// There and back, s.
    pub period: f64,
}

impl Lift {
    /// Its centre after `t` seconds, m.
    pub fn at(&self, t: f64) -> V {
        let way = 2.0 * (t / self.period).fract();
        let (part, back) = (way.fract(), way >= 1.0);
        let eased = if part < 0.5 { 2.0 * part * part } else { 1.0 - 2.0 * (1.0 - part) * (1.0 - part) };
        let (x, y) = self.place.0;
        (x, y - self.rise * if back { 1.0 - eased } else { eased })
    }
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
    /// Whether engines that iterate shall do so [`STIFFER`] times as often, with contacts as many times as stiff, and without a limit of
    /// speeds.
    pub stiff: bool,
    /// What moves.
    pub bodies: Vec<Box>,
    /// What does not: centre and half size, m.
    pub statics: Vec<(V, V)>,
    /// Water, if there is any.
    pub liquid: Option<Liquid>,
    /// A platform that moves, if there is one.
    pub lift: Option<Lift>,
}

/// See [`Spec::stiff`].
pub const STIFFER: u32 = 8;
/// m/s. Faster than anything in a stiff scene.
pub const NO_LIMIT: f64 = 1e6;

/// The settings of an engine: solver substeps, and the frequency of its contacts, Hz.
pub fn settings(parts: u32, of: &str, hertz: f64, stiff: bool) -> String {
    let times = if stiff { STIFFER } else { 1 };
    format!("{} {of}, {} Hz", parts * times, hertz * f64::from(times))
}

/// The version of a crate that was built in.
pub fn version(of: &str) -> String {
    let lock = include_str!("../../../Cargo.lock");
    let named = lock.split_once(&format!("name = \"{of}\"\nversion = \""));
    let version = named.and_then(|(_, rest)| rest.split_once('"'));
    version.map_or_else(|| "?".to_owned(), |(version, _)| version.to_owned())
}

/// An engine with a scene in it.
pub trait Engine: Sized {
    /// For the table.
    const NAME: &'static str;
    /// Of what was built in.
    fn version() -> String;
    /// How hard it tries, in words; nothing where that cannot be chosen.
    fn settings(stiff: bool) -> String;
    /// Whether its drag grows with the square of the speed.
    const QUADRATIC: bool;
    /// Builds the scene; `None` if the engine refuses it.
    fn new(spec: &Spec) -> Option<Self>;
    /// One step, s.
    fn step(&mut self, dt: f64);
    /// A body's centre, m.
    fn position(&mut self, body: usize) -> V;
    /// Its velocity, m/s.
    fn velocity(&mut self, body: usize) -> V;
}
