//! Islands that rest and that the same pulls at as before: the last solution of their contacts holds, and is taken over to the bit.
//!
//! [`State::held`] notes with what acceleration besides its contacts a body was at rest when these were solved. Nothing of an island of such
//! bodies has moved since, and what changes about a surface makes all that touches it be forgotten (`World::disturb`); so they touch what
//! they touched, and where the same pulls at all of them a solve would find what is known already.

#[cfg(doc)]
use super::world::State;
use super::{islands::Tick, zones};
use glam::DVec2;

impl Tick<'_> {
    /// Whether the present island, near the present surfaces, is held by what its contacts carried last.
    pub(super) fn is_held_as_before(&self) -> bool {
        let stands = |surface: &u32| {
            let surface = &self.state.surfaces[*surface as usize];
            surface.def.path.is_still() && surface.def.belt == 0.0
        };
        self.scene.direct
            && self.scratch.members.iter().all(|body| self.holds(*body as usize))
            && self.scratch.surfaces.iter().all(stands)
    }

    /// Whether a body rests, and the same pulls at it as when its contacts were solved for that.
    fn holds(&self, i: usize) -> bool {
        let (body, media) = (&self.state.bodies[i], self.scene.media);
        let Some(held) = self.state.held[i].filter(|_| body.velocity == DVec2::ZERO && body.acceleration == DVec2::ZERO) else {
            return false;
        };
        let law = media.law(body, zones::force_on(media, body, self.state.drives[i]), self.scene.tick);
        let pulled = media.acceleration(body, &law, body.position, body.velocity);
        (pulled.x.to_bits(), pulled.y.to_bits()) == (held.x.to_bits(), held.y.to_bits())
    }
}
