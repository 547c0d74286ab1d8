//! The state of a world, and the records of its last tick.

use crate::physics::data::{Body, BodyId, Contact, Impulse, Obstacle, Surface};
use crate::physics::forces::{ForceManager, Links, Media};
use crate::physics::guards::Guards;
use glam::DVec2;

/// What happened during the last tick, for rules, view and sound.
#[derive(Clone, Debug, PartialEq)]
pub enum Event {
    /// Two things hit each other.
    Impact {
        /// The body that hit.
        a: BodyId,
        /// What it hit.
        b: Obstacle,
        /// The middle of the shared edge, m.
        point: DVec2,
        /// Unit vector from `b` towards `a`.
        normal: DVec2,
        /// Closing speed along the normal just before, m/s, > 0.
        speed: f64,
    },
    /// A surface squeezes a body against something that cannot give way. The surface waits for the rest of the tick.
    Crushed {
        /// The body.
        body: BodyId,
        /// The surface.
        by: u32,
        /// ½mv²/(h/2), N: the mean force that crushes half of its smaller side h at the speed v at which the surfaces close.
        force: f64,
    },
    /// A larger force than it bears has broken a link.
    Snapped {
        /// Its number.
        link: u32,
    },
    /// The ends of a link that waits for it have touched: it acts from now on.
    Hooked {
        /// Its number.
        link: u32,
    },
}

/// How many bodies each method took through the last tick.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Methods {
    /// At rest, and not looked at.
    pub asleep: u32,
    /// By the formula of free flight.
    pub free: u32,
    /// From event to event.
    pub by_events: u32,
    /// In one dense step.
    pub in_one_step: u32,
}

impl Methods {
    /// Every method by its name, in the order in which they stand here.
    pub fn all(&self) -> impl Iterator<Item = (&'static str, u32)> {
        let Self { asleep, free, by_events, in_one_step } = *self;
        [("asleep", asleep), ("free", free), ("by events", by_events), ("in one step", in_one_step)].into_iter()
    }
}

#[derive(Clone, Debug)]
pub(crate) struct State {
    pub bodies: Vec<Body>,
    pub forces: Vec<ForceManager>,
    pub links: Links,
    pub surfaces: Vec<Surface>,
    pub media: Media,
    pub rest_speed: f64,
    /// Contacts at the end of the last tick. Items are bodies, and surfaces from the number of bodies on.
    pub contacts: Vec<Contact>,
    pub known: Vec<bool>,
    pub ticks: u64,
}

#[derive(Clone, Debug, Default)]
pub(crate) struct Records {
    /// Length of the last tick, or of the last part of it, s, and its begin since that of the tick.
    pub dt: f64,
    pub since: f64,
    /// Flows that had ended early before the last tick.
    pub flows_cut_short: u64,
    pub events: Vec<Event>,
    pub impulses: Vec<Impulse>,
    /// Body, time (s) and place (m) of each corner of a path, in the order of the times.
    pub corners: Vec<(u32, f64, DVec2)>,
    pub guards: Guards,
    pub methods: Methods,
    pub followed: u64,
}
