//! A build with sound. What is due in a frame is gathered and played at its end, each cue once and as loud as its loudest: many
//! collisions a frame are one click. Where there is no sound device nothing is heard.

use super::{Cue, waves};
use macroquad::audio::{PlaySoundParams, Sound, load_sound_from_bytes, play_sound, set_sound_volume, stop_sound};

/// The loudest that anything is played.
const VOLUME: f32 = 0.5;
/// The engine burns for long, so it is kept low.
const ENGINE_VOLUME: f32 = 0.16;

/// Where sounds come from.
pub struct Speaker {
    /// By the cues' numbers.
    cues: Vec<Option<Sound>>,
    engine: Option<Sound>,
    /// How loud each cue is due in this frame, 0: not at all.
    due: [f32; Cue::ALL.len()],
    /// How loud the engine is due, and is.
    engine_due: f32,
    engine_is: f32,
}

impl Speaker {
    /// Computes all sounds: about 3 s of them.
    pub async fn new() -> Self {
        let mut cues = Vec::with_capacity(Cue::ALL.len());
        for cue in Cue::ALL {
            cues.push(load(&waves::cue(cue)).await);
        }
        Self { cues, engine: load(&waves::engine()).await, due: Default::default(), engine_due: 0.0, engine_is: 0.0 }
    }

    /// A sound is due, `loudness` 0 … 1.
    pub fn cue(&mut self, cue: Cue, loudness: f32) {
        let due = &mut self.due[cue as usize];
        *due = due.max(loudness);
    }

    /// How hard the engine burns in this frame, 0 … 1. A frame that does not say so has it silent.
    pub fn engine(&mut self, strength: f32) {
        self.engine_due = strength;
    }

    /// Plays what became due.
    pub fn end_frame(&mut self) {
        for (sound, due) in self.cues.iter().zip(&mut self.due) {
            let loudness = std::mem::take(due);
            if let (Some(sound), true) = (sound, loudness > 0.0) {
                play_sound(sound, PlaySoundParams { looped: false, volume: VOLUME * loudness });
            }
        }
        let due = std::mem::take(&mut self.engine_due);
        let before = std::mem::replace(&mut self.engine_is, due);
        let Some(engine) = &self.engine else { return };
        let volume = ENGINE_VOLUME * due;
        match (before > 0.0, due > 0.0) {
            (false, true) => play_sound(engine, PlaySoundParams { looped: true, volume }),
            (true, true) if before != due => set_sound_volume(engine, volume),
            (true, false) => stop_sound(engine),
            _ => {}
        }
    }
}

async fn load(samples: &[f32]) -> Option<Sound> {
    load_sound_from_bytes(&waves::wav(samples)).await.ok()
}
