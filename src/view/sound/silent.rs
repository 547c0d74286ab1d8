//! A build without sound.

use super::Cue;

/// Where sounds would come from.
pub struct Speaker;

impl Speaker {
    /// A speaker that stays silent.
    pub async fn new() -> Self {
        Self
    }

    /// A sound is due.
    pub fn cue(&mut self, _cue: Cue, _loudness: f32) {}

    /// How hard the engine burns, 0 … 1.
    pub fn engine(&mut self, _strength: f32) {}

    /// The frame is over.
    pub fn end_frame(&mut self) {}
}
