//! Sound: what is heard of the game, computed as it is played; no file is read and nothing waits for it.
//!
//! The way of a sound: `heard` says which event is heard as what, and what the ship hears all the time ([`Ambience`]). The
//! [`Speaker`] gathers that for a frame and writes it into a `desk` of atomics. The [`Mixer`] reads the desk and computes stereo samples:
//! one-shot `voice`s after the `recipe`s of the cues, the `bed` of engine, wind and liquid, and the `music`, below the ceiling of a `limiter`. An `output` takes the samples to a
//! device on a thread of its own. Neither side ever waits for the other, and where there is no device the desk is simply not read.

mod bed;
mod cue;
mod desk;
mod filter;
mod heard;
mod limiter;
mod mixer;
mod music;
mod output;
mod recipe;
mod speaker;
mod tune;
mod voice;

pub use cue::{Cue, Stuff};
pub use desk::{Feed, SoundDesk, desk};
pub use heard::{Ambience, Ear, Sound, tune};
pub use mixer::Mixer;
pub use speaker::Speaker;

/// How loud each part is, 0 … 1; what lies outside counts as the nearest end, and what is no number as silence.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Volumes {
    /// Everything.
    pub master: f32,
    /// Engine, wind, liquids, knocks, chimes, buttons.
    pub effects: f32,
    /// Music; at 0 none is computed.
    pub music: f32,
}

impl Default for Volumes {
    fn default() -> Self {
        Self { master: 0.8, effects: 0.8, music: 0.5 }
    }
}
