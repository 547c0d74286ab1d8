//! One run of a level: controls, fuel, objectives, hazards, events, score. No key, clock, file or pixel.

use crate::level::Level;
use crate::physics::{BodyId, DVec2, World};

/// Ticks a second.
pub const TICK_RATE: f64 = 120.0;
/// The ship's body in every level's world.
pub const SHIP: BodyId = BodyId(0);

/// What the player holds down during one tick.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Controls {
    /// Thrust along the nose.
    pub thrust: bool,
    /// Thrust against it.
    pub reverse: bool,
    /// Rotate anticlockwise.
    pub left: bool,
    /// Rotate clockwise.
    pub right: bool,
}

/// How an attempt stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// Still flying.
    Running,
    /// All objectives were met at once.
    Completed,
    /// A death box was touched.
    Failed,
}

/// What the ship has besides its body.
#[derive(Clone, Debug, PartialEq)]
pub struct Ship {
    /// Degrees clockwise; 0 is nose up.
    pub angle: f64,
    /// The angle one tick ago (for interpolation).
    pub previous_angle: f64,
    /// Fuel units left.
    pub fuel: f64,
    /// The engine during the last tick: 1 along the nose, −1 against it, 0 off.
    pub burning: i8,
}

/// What happened in the last tick, for view and sound.
#[derive(Clone, Debug, PartialEq)]
pub enum GameEvent {
    /// Two things hit each other at `speed` m/s (at least the dust threshold).
    Impact {
        /// Where, m.
        point: DVec2,
        /// m/s along the normal.
        speed: f64,
        /// Away from what was hit.
        normal: DVec2,
    },
    /// The ship hit something at 10 m/s or more: −500 points.
    DamagingHit {
        /// Where, m.
        point: DVec2,
        /// m/s along the normal.
        speed: f64,
    },
    /// The objective of that index in `Level::objectives` has become met.
    ObjectiveMet(usize),
    /// … is no longer met.
    ObjectiveLost(usize),
    /// All were met.
    Completed,
    /// A death box was touched.
    Died,
}

/// What an attempt came to; the scoring screen is made from it.
#[derive(Clone, Debug, PartialEq)]
pub struct RunResult {
    /// The level's folder name.
    pub level: String,
    /// Completed or Failed.
    pub outcome: Outcome,
    /// s.
    pub time: f64,
    /// s.
    pub optimal_time: f64,
    /// Objectives met at the end.
    pub objectives_met: usize,
    /// Of how many.
    pub objectives_all: usize,
    /// Damaging collisions.
    pub collisions: u32,
    /// Fraction of the fuel left, 0 … 1.
    pub fuel: f64,
    /// Fuel units used.
    pub fuel_used: f64,
    /// m.
    pub distance: f64,
    /// m/s.
    pub top_speed: f64,
    /// N.
    pub peak_resultant: f64,
    /// The total and its parts.
    pub score: ScoreParts,
}

/// The score and its terms.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ScoreParts {
    /// 10 000 for a completed level.
    pub base: i64,
    /// 10 000·k.
    pub time: i64,
    /// 1000·min(f/0.5, 1).
    pub fuel: i64,
    /// −500·c.
    pub collisions: i64,
    /// What counts: at least 1 for a success, 0 for a failure.
    pub total: i64,
}

/// One attempt at a level.
#[derive(Clone, Debug)]
pub struct Game {
    level: std::sync::Arc<Level>,
    world: World,
    ship: Ship,
    outcome: Outcome,
    ticks: u64,
    met: Vec<bool>,
    events: Vec<GameEvent>,
}

impl Game {
    /// The level at its start.
    pub fn level(&self) -> &Level {
        &self.level
    }

    /// The world; object i of the level is body i + 1.
    pub fn world(&self) -> &World {
        &self.world
    }

    /// The ship.
    pub fn ship(&self) -> &Ship {
        &self.ship
    }

    /// How the attempt stands.
    pub fn outcome(&self) -> Outcome {
        self.outcome
    }

    /// Ticks since the start.
    pub fn ticks(&self) -> u64 {
        self.ticks
    }

    /// Whether each objective of the level is met now.
    pub fn met(&self) -> &[bool] {
        &self.met
    }

    /// What happened in the last tick.
    pub fn events(&self) -> &[GameEvent] {
        &self.events
    }
}
