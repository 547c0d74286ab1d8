//! Buffers of a tick. Nothing in them outlives it.

use super::Aabb;
use super::contact::Contact;
use super::events::Events;
use super::impulse::Impulse;
use super::islands::Islands;
use glam::DVec2;

/// The buffers.
#[derive(Clone, Debug, Default)]
pub(super) struct Scratch {
    /// Where each body may get to in this tick, m.
    pub searched: Vec<Aabb>,
    /// Whether it rests, and nothing can reach it that does not.
    pub resting: Vec<bool>,
    pub islands: Islands,
    pub events: Events,
    /// How each body ends the tick.
    pub after: Vec<After>,
    /// What the islands found out, with the smallest body of the island that it came from.
    pub contacts: Vec<(u32, Contact)>,
    pub happened: Vec<Happened>,
    /// Body, surface and force, N.
    pub crushed: Vec<(u32, u32, u32, f64)>,
    /// Surfaces that were stopped, and when.
    pub stopped: Vec<(u32, f64)>,
    /// Of each body and each surface behind them: its number in the present island.
    pub local: Vec<u32>,
}

/// How a body ends a tick.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct After {
    pub position: DVec2,
    pub velocity: DVec2,
    pub acceleration: DVec2,
    /// Whether nothing moved it.
    pub still: bool,
    /// Whether contacts and acceleration are those of the end of the tick.
    pub known: bool,
    /// How many bodies its island had; 0 while it has not been advanced.
    pub members: u32,
}

/// Something for the records, with the smallest body of its island.
#[derive(Clone, Copy, Debug)]
pub(super) struct Happened {
    pub island: u32,
    pub order: u32,
    pub impulse: Impulse,
    pub normal: DVec2,
    /// Closing speed, m/s.
    pub speed: f64,
    /// Where the two were, m.
    pub places: [DVec2; 2],
}

impl Scratch {
    /// For a tick of so many bodies.
    pub fn begin(&mut self, bodies: usize) {
        self.after.clear();
        self.after.resize(bodies, After::default());
        self.contacts.clear();
        self.happened.clear();
        self.crushed.clear();
    }

    /// Whether an island has been advanced as it is.
    pub fn is_done(&self, island: &[(u32, u32)]) -> bool {
        island.iter().all(|member| self.after[member.1 as usize].members == island.len() as u32)
    }

    /// Forgets what was found out about the bodies of an island, when they were in others.
    pub fn discard(&mut self, island: &[(u32, u32)]) {
        let mut any = false;
        for &(_, body) in island {
            any |= self.after[body as usize].members > 0;
            self.after[body as usize].members = 0;
        }
        if any {
            let of_it = |body: u32| island.iter().any(|member| member.1 == body);
            self.contacts.retain(|(leader, _)| !of_it(*leader));
            self.happened.retain(|happened| !of_it(happened.island));
            self.crushed.retain(|(leader, ..)| !of_it(*leader));
        }
    }
}
