//! Fields of gravity: each gives every body that touches it the same acceleration, besides that by the world's gravity.

use crate::physics::data::{Body, FieldDef};
use crate::physics::forces::kind::{ForceKind, Source};
use crate::physics::forces::zones::Stream;
use glam::DVec2;

impl Stream {
    pub fn field((index, def): (u32, &FieldDef)) -> Self {
        let (zone, strength, source) = (def.zone, def.strength, Source::Field(index));
        Self { zone, strength, law: pull, blows: true, kind: ForceKind::Weight, source }
    }
}

fn pull(strength: DVec2, body: &Body) -> DVec2 {
    if body.weightless { DVec2::ZERO } else { strength * body.mass }
}
