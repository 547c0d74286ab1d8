//! Wind: an air stream pushes every body that touches it with the same force.

use crate::physics::data::def::StreamDef;
use crate::physics::forces::kind::{ForceKind, Source};
use crate::physics::forces::zones::Stream;

impl Stream {
    pub fn wind((index, def): (u32, &StreamDef)) -> Self {
        let (zone, strength, source) = (def.zone, def.force, Source::Stream(index));
        Self { zone, strength, law: |force, _| force, blows: true, kind: ForceKind::Wind, source }
    }
}
