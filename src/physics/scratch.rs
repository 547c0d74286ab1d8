//! Buffers of a tick. Nothing in them outlives it.

use super::Aabb;
use super::contact::Contact;
use super::events::Events;
use super::impulse::Impulse;
use super::islands::Islands;
use glam::DVec2;

/// The leader of no island.
const NOBODY: u32 = u32::MAX;

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
    /// Which surfaces the islands have stopped because they would have squeezed something.
    pub stops: Vec<Stop>,
    /// Which moving surfaces each island has met, and when these stopped for it.
    pub met: Vec<Stop>,
    /// Of each body and each surface behind them: its number in the present island.
    pub local: Vec<u32>,
}

/// A surface that stops within a tick.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stop {
    /// The smallest body of the island.
    pub leader: u32,
    pub surface: u32,
    /// s from the tick's start; infinite where it goes on.
    pub at: f64,
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
        self.met.clear();
    }

    /// Whether an island has been advanced as it is.
    pub fn is_done(&self, island: &[(u32, u32)]) -> bool {
        island.iter().all(|member| self.after[member.1 as usize].members == island.len() as u32)
    }

    /// When a surface stops, s from the tick's start; infinite where it goes on.
    pub fn stop_of(&self, surface: u32) -> f64 {
        self.stops.iter().filter(|stop| stop.surface == surface).map(|stop| stop.at).fold(f64::INFINITY, f64::min)
    }

    /// Whether all islands found that the surfaces they met stop when they do; forgets what came of those that did not. `at_once`: from now
    /// on whatever was stopped stands still for the whole tick.
    pub fn agree_on_stops(&mut self, at_once: bool) -> bool {
        if at_once {
            self.stops.iter_mut().for_each(|stop| (stop.leader, stop.at) = (NOBODY, 0.0));
        }
        let members = std::mem::take(&mut self.islands.members);
        let mut agreed = true;
        for island in members.chunk_by(|a, b| a.0 == b.0) {
            if self.met.iter().any(|met| met.leader == island[0].0 && met.at != self.stop_of(met.surface)) {
                agreed = false;
                self.discard(island);
            }
        }
        self.islands.members = members;
        agreed
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
            self.met.retain(|met| !of_it(met.leader));
            self.stops.retain(|stop| !of_it(stop.leader));
        }
    }
}
