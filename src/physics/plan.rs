//! The plan: which parts of the model a world needs, decided once from what is in it. What it leaves out could not change a bit. (Tests ask
//! for [`Plan::dense`] besides, which changes more than bits.)

use super::WorldDef;

/// The parts of the model that a world uses.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Plan {
    /// Some body feels the air.
    pub air: bool,
    /// There are air streams, or fields of gravity.
    pub streams: bool,
    /// There are liquids.
    pub liquids: bool,
    /// More than one body moves: they can meet.
    pub pairs: bool,
    /// There is something to touch.
    pub contacts: bool,
    /// Some body bounces.
    pub bounces: bool,
    /// Direct answers: flight past nothing is one formula a tick, and what rests or keeps its contacts is not solved again.
    pub direct: bool,
    /// Every island is taken in one dense step, whatever it has in it: for comparing the two methods. No definition asks for it.
    pub dense: bool,
}

impl Plan {
    /// All parts that a world of few bodies can have, and no direct answer: everything is computed in every tick.
    pub const EVERYTHING: Self =
        Self { air: true, streams: true, liquids: true, pairs: true, contacts: true, bounces: true, direct: false, dense: false };

    /// The parts that a definition needs.
    pub fn of(def: &WorldDef) -> Self {
        let pairs = def.bodies.len() > 1;
        Self {
            air: def.air_density > 0.0 && def.bodies.iter().any(|body| body.feels_air && body.drag > 0.0),
            streams: !(def.streams.is_empty() && def.fields.is_empty()),
            liquids: !def.fluids.is_empty(),
            pairs,
            contacts: pairs || !def.surfaces.is_empty() || def.bounds.is_some(),
            bounces: def.bodies.iter().any(|body| body.restitution.max(body.material.restitution) > 0.0)
                || def.surfaces.iter().any(|surface| surface.material.restitution > 0.0),
            direct: true,
            dense: false,
        }
    }

    /// Whether anything acts that depends on place or velocity.
    pub fn media(&self) -> bool {
        self.air || self.streams || self.liquids
    }

    /// The parts in words, for `check` and the details overlay.
    pub fn parts(&self) -> Vec<&'static str> {
        let drag = self.air || self.liquids;
        let parts = [
            (!drag, "motion: exact parabolas"),
            (drag, "motion: one exact step through air, finer ones for light things and in liquids"),
            (self.air, "air resistance"),
            (self.streams, "air streams and gravity zones"),
            (self.liquids, "liquids"),
            (self.direct, "sleep, and direct answers where nothing changes"),
            (self.contacts && !self.dense, "contacts: islands, event by event within a budget, else in one dense step"),
            (self.contacts && self.dense, "contacts: islands, each in one dense step"),
            (self.pairs, "pairs of bodies"),
            (self.bounces, "restitution"),
        ];
        parts.into_iter().filter(|(used, _)| *used).map(|(_, part)| part).collect()
    }
}
