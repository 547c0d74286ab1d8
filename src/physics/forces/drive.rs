//! Drive: the force of a body's own engine, N. It acts until the engine is set again.

use crate::physics::forces::kind::{ForceKind, Source};
use crate::physics::forces::manager::ForceManager;
use glam::DVec2;

impl ForceManager {
    /// Sets it; a force that is not finite is none. Returns whether anything changed.
    pub(crate) fn set_drive(&mut self, force: DVec2) -> bool {
        self.add(Source::Engine, ForceKind::Drive, force)
    }
}
