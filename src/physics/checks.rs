//! The buffers of a check: bodies and surfaces between two ticks, and the energy of islands.

use crate::physics::{data::aabb::Aabb, forces::manager::ForceManager};
use glam::DVec2;

#[derive(Clone, Copy, Debug)]
pub(crate) struct Thing {
    /// Its number, and which of the two it is.
    pub id: u32,
    pub surface: bool,
    /// The box that it fills, the one that it filled a tick ago, and the one around all of its way, m.
    pub now: Aabb,
    pub before: Aabb,
    pub swept: Aabb,
    /// m/s.
    pub velocity: DVec2,
    /// Whether its way has no corner, and it is known where it was.
    pub straight: bool,
    pub dense: bool,
    /// How deep something may be in it, m.
    pub depth: f64,
}

impl Thing {
    pub fn name(&self) -> String {
        format!("{} {}", if self.surface { "surface" } else { "body" }, self.id)
    }
}

/// What the place of a box may be off by, m: 16 roundings.
pub(crate) fn rounding(bounds: &Aabb) -> f64 {
    16.0 * f64::EPSILON * bounds.min.abs().max(bounds.max.abs()).max_element()
}

/// What a tick did to an island, J.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Ledger {
    pub gained: f64,
    /// The most that the forces from outside gave it.
    pub given: f64,
    pub scale: f64,
    /// What rounding and the smallest speeds add.
    pub rounding: f64,
    /// What the forces from outside would give its bodies in one tick from rest.
    pub push: f64,
    /// Whether it was given more than is known here.
    pub open: bool,
    /// The part of all these energies that its steps may add.
    pub slack: f64,
    /// The leader of the island that a link joins it to, whose ledger has both.
    pub joined: Option<u32>,
}

/// The leader whose ledger has the island of `leader`.
fn joined_to(ledgers: &[Ledger], mut leader: u32) -> u32 {
    while let Some(next) = ledgers[leader as usize].joined {
        leader = next;
    }
    leader
}

/// Makes one ledger of two, and says whose.
pub(crate) fn join(ledgers: &mut [Ledger], a: u32, b: u32) -> u32 {
    let (a, b) = (joined_to(ledgers, a), joined_to(ledgers, b));
    if a != b {
        let gone = std::mem::replace(&mut ledgers[b as usize], Ledger { joined: Some(a), ..Ledger::default() });
        let both = &mut ledgers[a as usize];
        both.gained += gone.gained;
        both.given += gone.given;
        both.scale += gone.scale;
        both.rounding += gone.rounding;
        both.push += gone.push;
        both.open |= gone.open;
        both.slack = both.slack.max(gone.slack);
    }
    a
}

#[derive(Clone, Debug, Default)]
pub(crate) struct Checks {
    pub bodies: Vec<Thing>,
    /// The bodies by the left edges of what they swept.
    pub order: Vec<u32>,
    pub forces: ForceManager,
    pub ledgers: Vec<Ledger>,
    pub moving: Vec<u32>,
}
