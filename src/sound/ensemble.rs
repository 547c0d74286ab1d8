//! An ensemble for each world: its scales, its pace, the sound of its plucked notes and of its beat.

use super::recipe::{Burst, Recipe, Tone};

/// The number of worlds.
pub const WORLDS: usize = 5;

/// How a level's music is played.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Arrangement {
    /// Of [`WORLDS`]; further ones begin again.
    pub world: usize,
    /// 0 … 1: a bass and a brush come in with the ship's speed.
    pub pace: f32,
    /// 0 … 1: broken chords come in with the goals that are met.
    pub goals: f32,
}

#[derive(Debug)]
pub struct Ensemble {
    /// Steps of two pentatonic scales above the root, in semitones.
    pub scales: [[i32; 5]; 2],
    /// Quarters a minute, from and below.
    pub quarters: [f32; 2],
    /// Attack of a plucked note, s, and its partials: pitch ratio, decay (s) and share.
    attack: f32,
    partials: [(f32, f32, f32); 3],
    /// Pitch (Hz) and decay (s) of the brush.
    brush: (f32, f32),
}

static ENSEMBLES: [Ensemble; WORLDS] = [
    // Launch site: a celesta.
    Ensemble {
        scales: [[0, 2, 4, 7, 9], [0, 3, 5, 7, 10]],
        quarters: [58.0, 74.0],
        attack: 0.008,
        partials: [(1.0, 0.5, 1.0), (2.0, 0.25, 0.3), (3.01, 0.12, 0.14)],
        brush: (6000.0, 0.02),
    },
    // Quarry: wooden bars, 1 : 2.76 : 5.4.
    Ensemble {
        scales: [[0, 3, 5, 7, 10], [0, 2, 3, 7, 8]],
        quarters: [66.0, 78.0],
        attack: 0.002,
        partials: [(1.0, 0.28, 1.25), (2.756, 0.1, 0.4), (5.404, 0.04, 0.22)],
        brush: (900.0, 0.05),
    },
    // Wind works: a flute's odd partials, softly begun.
    Ensemble {
        scales: [[0, 2, 5, 7, 9], [0, 2, 5, 7, 10]],
        quarters: [72.0, 84.0],
        attack: 0.07,
        partials: [(1.0, 0.7, 1.0), (2.0, 0.4, 0.12), (3.0, 0.3, 0.2)],
        brush: (3200.0, 0.09),
    },
    // Deep water: slow bells.
    Ensemble {
        scales: [[0, 3, 5, 7, 10], [0, 2, 4, 7, 9]],
        quarters: [46.0, 54.0],
        attack: 0.03,
        partials: [(1.0, 1.0, 0.8), (2.002, 0.8, 0.3), (4.2, 0.35, 0.1)],
        brush: (420.0, 0.12),
    },
    // Orbit: glass, with fifths above it.
    Ensemble {
        scales: [[0, 2, 4, 7, 11], [0, 2, 6, 7, 11]],
        quarters: [50.0, 58.0],
        attack: 0.015,
        partials: [(1.0, 1.2, 0.75), (1.5, 0.9, 0.16), (4.0, 0.6, 0.07)],
        brush: (9000.0, 0.05),
    },
];

impl Ensemble {
    pub fn of(world: usize) -> &'static Self {
        &ENSEMBLES[world % WORLDS]
    }

    /// A note that is plucked with this strength (0 … 1) at this amplitude.
    pub fn pluck(&self, pitch: f32, strength: f32, peak: f32) -> Recipe {
        let mut recipe = Recipe::default();
        for (i, (to, (ratio, fade, share))) in recipe.tones.iter_mut().zip(self.partials).enumerate() {
            // A harder strike is brighter.
            let bright = if i == 1 { strength } else { 1.0 };
            let peak = peak * strength * share * bright;
            *to = Some(Tone { at: 0.0, pitch: pitch * ratio, glide: 0.0, swell: self.attack, fade, peak });
        }
        recipe
    }

    /// The bass: one low tone and its octave.
    pub fn bass(&self, pitch: f32, peak: f32) -> Recipe {
        let mut recipe = Recipe::default();
        let tone = |pitch, fade, peak| Some(Tone { at: 0.0, pitch, glide: 0.0, swell: 0.006 + 0.3 * self.attack, fade, peak });
        (recipe.tones[0], recipe.tones[1]) = (tone(pitch, 0.22, peak), tone(2.0 * pitch, 0.1, 0.3 * peak));
        recipe
    }

    pub fn brush(&self, peak: f32) -> Recipe {
        let ((pitch, fade), mut recipe) = (self.brush, Recipe::default());
        recipe.bursts[0] = Some(Burst { at: 0.0, pitch, glide: 0.0, narrowness: 0.9, swell: 0.004, fade, peak });
        recipe
    }
}
