//! The plan: the parts of the model that run. A part that is left out is not called.

use crate::physics::data::def::WorldDef;
use crate::physics::data::material::Material;

/// The parts of the model that a world runs.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Plan {
    /// Drag of the air.
    pub air: bool,
    /// Air streams and fields of gravity.
    pub streams: bool,
    /// Liquids.
    pub liquids: bool,
    /// Impacts with restitution.
    pub bounces: bool,
    /// Direct answers: what rests or keeps its contacts is not solved again.
    pub direct: bool,
    /// The crowd step takes every island. No definition asks for it; tests compare the two methods.
    pub dense: bool,
}

impl Plan {
    /// Every part of the exact model, without direct answers.
    pub const EVERYTHING: Self = Self { air: true, streams: true, liquids: true, bounces: true, direct: false, dense: false };

    /// The parts that a definition needs.
    pub fn of(def: &WorldDef) -> Self {
        let springy = |material: &Material| material.restitution > 0.0;
        Self {
            air: def.air_density > 0.0 && def.bodies.iter().any(|body| body.feels_air && body.drag > 0.0),
            streams: !(def.streams.is_empty() && def.fields.is_empty()),
            liquids: !def.fluids.is_empty(),
            bounces: def.bodies.iter().any(|body| body.restitution > 0.0 || springy(&body.material))
                || def.surfaces.iter().any(|surface| springy(&surface.material))
                || def.bounds.is_some() && springy(&def.edge),
            direct: true,
            dense: false,
        }
    }

    /// Whether a force depends on place or velocity.
    pub fn media(&self) -> bool {
        self.air || self.streams || self.liquids
    }

    /// The parts in words, for `check` and the details.
    pub fn parts(&self) -> Vec<&'static str> {
        let drag = self.air || self.liquids;
        let parts = [
            (!drag, "motion: exact parabolas"),
            (drag, "motion: one exact step through air, finer ones for light things and in liquids"),
            (self.air, "air resistance"),
            (self.streams, "air streams and gravity zones"),
            (self.liquids, "liquids"),
            (self.direct, "sleep, and direct answers where nothing changes"),
            (!self.dense, "contacts: islands, event by event within a budget, else in one dense step"),
            (self.dense, "contacts: islands, each in one dense step"),
            (self.bounces, "restitution"),
        ];
        parts.into_iter().filter(|(used, _)| *used).map(|(_, part)| part).collect()
    }
}

/// A part of the model, as tests count its calls.
#[derive(Clone, Copy)]
pub(crate) enum Part {
    Air,
    Streams,
    Liquids,
    Bounces,
    Direct,
    Exact,
}

/// Counts a call of a part in unit tests; elsewhere it is empty.
#[inline(always)]
pub(crate) fn called(_part: Part) {
    #[cfg(test)]
    CALLS.with(|calls| calls[_part as usize].set(calls[_part as usize].get() + 1));
}

#[cfg(test)]
thread_local! {
    pub(crate) static CALLS: [std::cell::Cell<u64>; 6] = const { [const { std::cell::Cell::new(0) }; 6] };
}
