//! The pilot of the menu's ship: it keeps the ship over the buttons with the engine alone, and leads it back there from wherever a ball has
//! knocked it.

use crate::game::{ROTATION_RATE, TICK_RATE, nose};
use crate::level::SHIP_HALF;
use crate::physics::{Aabb, Body, BodyDef, DVec2, Material};

/// N/kg, downwards.
pub const GRAVITY: f64 = 2.0;
/// kg.
const MASS: f64 = 100.0;
/// N: three times the ship's weight in the menu.
const THRUST: f64 = 600.0;
/// What the pilot wants for each metre off its place (m/s²/m) and against each m/s: near critical damping.
const PULL: f64 = 1.2;
const DAMPING: f64 = 2.2;
/// The most that the pilot asks for, m/s²: sideways, downwards and upwards. More, and it would overshoot.
const MOST: (f64, f64, f64) = (1.6, 1.2, 2.5);
/// How far it leans over at most, degrees.
const LEAN: f64 = 30.0;
/// How far over the buttons it hovers at most, m: in a high window the title is far above them.
const HEIGHT: f64 = 2.2;
/// How far it wanders to each side, m, and how long there and back takes, s.
const WANDER: (f64, f64) = (4.0, 14.0);
/// From the middle of the ship to the edge of what it flies around, m.
const CLEARANCE: f64 = 1.5;
/// Share of a tick in what is shown of the engine. Its bursts are shorter than a frame.
const SHOWN: f64 = 0.1;

/// The pilot.
#[derive(Debug, Default)]
pub struct Hover {
    /// What the ship flies around: the column of buttons, the title.
    blocks: Vec<Aabb>,
    /// The middle of where it hovers, m.
    home: DVec2,
    ticks: u64,
    /// Degrees clockwise, now and a tick ago.
    angle: (f64, f64),
    /// Parts of a burst that are due.
    due: f64,
    /// How much the engine burns, 0 … 1.
    burning: f64,
}

impl Hover {
    /// The ship in a menu with these blocks, the last one of which is the title: where it is, or at home where the menu is another one.
    pub fn settle(&mut self, blocks: &[Aabb], ship: Option<(DVec2, DVec2)>) -> BodyDef {
        let around = |blocks: &[Aabb]| blocks.iter().copied().reduce(|a, b| a.union(&b));
        let mut known = Vec::new();
        if let Some((title, buttons)) = blocks.split_last() {
            let narrow = buttons.iter().filter(|button| (button.centre().x - title.centre().x).abs() < 1.0).copied();
            known.extend(around(&narrow.collect::<Vec<_>>()));
            known.push(*title);
            let below = known[0].min.y;
            self.home = DVec2::new(title.centre().x, ((title.max.y + below) / 2.0).max(below - HEIGHT));
        }
        let same = self.blocks == known;
        self.blocks = known;
        let (position, velocity) = ship.filter(|_| same).unwrap_or((self.home, DVec2::ZERO));
        BodyDef {
            position,
            velocity,
            half: SHIP_HALF,
            mass: MASS,
            drag: 0.0,
            restitution: 0.5,
            material: Material::STEEL,
            feels_air: false,
            ..BodyDef::default()
        }
    }

    /// The engine's drive in the next tick, N.
    pub fn drive(&mut self, ship: &Body) -> DVec2 {
        self.ticks += 1;
        let wish = (self.goal(ship.position) - ship.position) * PULL - ship.velocity * DAMPING;
        let (aside, down, up) = MOST;
        // What the engine has to give: the wish, and what carries the ship's weight.
        let push = DVec2::new(wish.x.clamp(-aside, aside), wish.y.clamp(-up, down) - GRAVITY) * MASS;
        let lean = push.x.atan2(-push.y).to_degrees().clamp(-LEAN, LEAN);
        let step = ROTATION_RATE / TICK_RATE;
        let turn = if (lean - self.angle.0).abs() > step { step.copysign(lean - self.angle.0) } else { 0.0 };
        self.angle = (self.angle.0 + turn, self.angle.0);
        let nose = nose(self.angle.0);
        self.due += (push.dot(nose) / THRUST).clamp(0.0, 1.0);
        let burst = self.due >= 1.0;
        self.due -= f64::from(u8::from(burst));
        self.burning += (f64::from(u8::from(burst)) - self.burning) * SHOWN;
        if burst { nose * THRUST } else { DVec2::ZERO }
    }

    /// The angle between the last two ticks, degrees.
    pub fn angle(&self, alpha: f64) -> f64 {
        self.angle.1 + (self.angle.0 - self.angle.1) * alpha
    }

    /// How much the engine burns, 0 … 1.
    pub fn burning(&self) -> f64 {
        (self.burning * 2.0).min(1.0)
    }

    /// Where to fly from there: home, or first around what lies between.
    fn goal(&self, from: DVec2) -> DVec2 {
        let (reach, period) = WANDER;
        let phase = self.ticks as f64 / TICK_RATE / period * std::f64::consts::TAU;
        let home = self.home + DVec2::new(reach * phase.sin(), 0.25 * (2.0 * phase).sin());
        let between = |block: &&Aabb| {
            let level = if from.y > self.home.y { block.min.y > self.home.y } else { block.max.y < self.home.y };
            level && (from.y - self.home.y).abs() > CLEARANCE
        };
        let Some(block) = self.blocks.iter().find(between) else { return home };
        let (left, right) = (block.min.x - CLEARANCE, block.max.x + CLEARANCE);
        let lane = if from.x < block.centre().x { left - 1.0 } else { right + 1.0 };
        let beside = from.x < left || from.x > right;
        DVec2::new(lane, if beside { home.y } else { from.y })
    }
}
