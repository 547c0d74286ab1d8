//! Sound, computed while the game runs; no file is read and nothing waits for it. `heard` maps events to sounds, the [`Speaker`] writes a frame of
//! them into a `desk` of atomics, which the [`Mixer`] reads; an `output` takes its samples to a device on its own thread, if there is one.

mod cue;
mod desk;
mod filter;
mod heard;
mod mixer;
mod music;
mod output;
mod voice;

pub use cue::{Cue, Stuff};
pub use desk::{Feed, SoundDesk, Speaker, desk};
pub use heard::{Ambience, Ear, Sound, tune};
pub use mixer::Mixer;
pub use music::{Arrangement, WORLDS};

/// Loudness of each part; values clamp to 0 … 1, and NaN is silence.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Volumes {
    pub master: f32,
    /// Engine, wind, liquids, knocks, chimes, buttons.
    pub effects: f32,
    /// At 0 no music is computed.
    pub music: f32,
}

impl Default for Volumes {
    fn default() -> Self {
        Self { master: 0.8, effects: 0.8, music: 0.5 }
    }
}
