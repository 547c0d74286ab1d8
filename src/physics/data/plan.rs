//! The plan: the parts of the model that run. A part that is left out is not called.

use crate::physics::data::{def::WorldDef, material::Material};

/// The parts of the model that a world runs.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Plan {
    /// Drag of the air.
    pub air: bool,
    /// Air streams and fields of gravity.
    pub streams: bool,
    /// Liquids.
    pub liquids: bool,
    /// Springs, ropes and magnets.
    pub links: bool,
    /// Surfaces that have paths.
    pub moving: bool,
    /// Impacts with restitution.
    pub bounces: bool,
    /// Direct answers: what rests or keeps its contacts is not solved again.
    pub direct: bool,
    /// The crowd step takes every island. No definition asks for it; tests compare the two methods.
    pub dense: bool,
}

impl Plan {
    /// Every part of the exact model, without direct answers.
    pub const EVERYTHING: Self =
        Self { air: true, streams: true, liquids: true, links: true, moving: true, bounces: true, direct: false, dense: false };

    /// The parts that a definition needs.
    pub fn of(def: &WorldDef) -> Self {
        let springy = |material: &Material| material.restitution > 0.0;
        Self {
            air: def.air_density > 0.0 && def.bodies.iter().any(|body| body.feels_air && body.drag > 0.0),
            streams: !(def.streams.is_empty() && def.fields.is_empty()),
            liquids: !def.fluids.is_empty(),
            links: !def.links.is_empty(),
            moving: def.surfaces.iter().any(|surface| !surface.path.is_still()),
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

    /// The parts in words, for `check`, the details and the page of savings.
    pub fn parts(&self) -> Vec<&'static str> {
        let drag = self.air || self.liquids;
        let motion = [
            (!drag && !self.links, "motion: exact parabolas"),
            (!drag && self.links, "motion: exact parabolas, fine steps for what links pull"),
            (drag, "motion: one exact step through air, finer ones for light things and in liquids"),
        ];
        let rest = [
            (self.direct, "sleep, and direct answers where nothing changes"),
            (!self.dense, "contacts: islands, event by event within a budget, else in one dense step"),
            (self.dense, "contacts: islands, each in one dense step"),
        ];
        let optional = OPTIONAL.map(|(words, part)| (*part(&mut self.clone()), words));
        let parts = motion.into_iter().chain(optional).chain(rest);
        parts.filter(|(used, _)| *used).map(|(_, part)| part).collect()
    }

    /// The parts that are left out, in words.
    pub fn left_out(&self) -> Vec<&'static str> {
        OPTIONAL.iter().filter(|(_, part)| !*part(&mut self.clone())).map(|(words, _)| *words).collect()
    }
}

/// A part that a plan may leave out: its words, and its switch.
pub type Optional = (&'static str, fn(&mut Plan) -> &mut bool);
pub const OPTIONAL: [Optional; 6] = [
    ("air resistance", |plan| &mut plan.air),
    ("air streams and gravity zones", |plan| &mut plan.streams),
    ("liquids", |plan| &mut plan.liquids),
    ("springs, ropes and magnets", |plan| &mut plan.links),
    ("moving surfaces", |plan| &mut plan.moving),
    ("restitution", |plan| &mut plan.bounces),
];

/// A part of the model, as tests count its calls.
#[derive(Clone, Copy)]
pub(crate) enum Part {
    Air,
    Streams,
    Liquids,
    Links,
    Moving,
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
    pub(crate) static CALLS: [std::cell::Cell<u64>; 8] = const { [const { std::cell::Cell::new(0) }; 8] };
}
