//! Plays a [`Tune`]: soft chords that swell, a plucked melody, and an echo that goes from side to side; with speed a bass and a brush come in,
//! with goals broken chords.

use super::cue::{Recipe, Tone};
use super::filter::{Glide, LowPass, WhiteNoise};
use super::tune::{Arrangement, Ensemble, Tune};
use super::voice::{Choir, Voice};

/// Time constant of a tune's fade when another replaces it, s.
const FADE: f32 = 0.25;
/// A tune below this amplitude has faded.
const GONE: f32 = 0.003;
/// The longest echo, s, and its feedback.
const LONGEST_ECHO: f32 = 0.8;
const ECHO: f32 = 0.34;
/// Amplitude of a note of the melody and of a chord.
const MELODY: f32 = 0.16;
const CHORD: f32 = 0.085;
/// The same of the layers at their strongest, and the pace above which the brush plays.
const BASS: f32 = 0.15;
const BRUSH: f32 = 0.1;
const BROKEN: f32 = 0.07;
const BRISK: f32 = 0.4;

#[derive(Debug)]
pub struct Music {
    rate: f32,
    /// With its number and world.
    tune: Option<((u32, usize), Tune)>,
    /// The present chord, Hz.
    chord: [f32; 3],
    gain: Glide,
    /// Samples to the next eighth, and its number.
    wait: f32,
    eighth: u32,
    choir: Choir<24>,
    echo: Echo,
}

impl Music {
    pub fn new(rate: f32) -> Self {
        let (gain, echo) = (Glide::new(rate, FADE), Echo::new(rate));
        Self { rate, tune: None, chord: [0.0; 3], gain, wait: 0.0, eighth: 0, choir: Choir::new(), echo }
    }

    pub const fn is_silent(&self) -> bool {
        self.tune.is_none()
    }

    /// Left and right; a new tune begins once the one before has faded.
    pub fn next(&mut self, wanted: Option<u32>, how: &Arrangement, noise: &mut WhiteNoise) -> [f32; 2] {
        let wanted = wanted.map(|number| (number, how.world));
        let playing = self.tune.as_ref().map(|(playing, _)| *playing);
        let gain = self.gain.towards(if playing == wanted && playing.is_some() { 1.0 } else { 0.0 });
        if playing != wanted && (playing.is_none() || gain < GONE) {
            self.choir.hush();
            self.echo.clear();
            self.tune = wanted.map(|(number, world)| ((number, world), Tune::new(number, Ensemble::of(world))));
            self.gain.set(0.0);
            (self.wait, self.eighth) = (0.0, 0);
        }
        self.wait -= 1.0;
        if self.wait <= 0.0 {
            self.play_eighth(how);
        }
        if self.tune.is_none() {
            return [0.0; 2];
        }
        let dry = self.choir.next(noise);
        let wet = self.echo.next(dry);
        [gain * (dry[0] + wet[0]), gain * (dry[1] + wet[1])]
    }

    /// Begins the notes of the next eighth.
    fn play_eighth(&mut self, how: &Arrangement) {
        let Some(((_, world), tune)) = &mut self.tune else { return };
        let (ensemble, notes, length) = (Ensemble::of(*world), tune.notes(self.eighth), tune.eighth);
        self.wait += length * self.rate;
        // The echo falls between the eighths.
        self.echo.set(1.5 * length, self.rate);
        self.eighth = self.eighth.wrapping_add(1);
        if let Some((pitch, strength)) = notes.melody {
            self.sing(&ensemble.pluck(pitch, strength, MELODY));
        }
        if let Some(chord) = notes.chord {
            self.chord = chord;
            self.swell(chord, 16.0 * length);
        }
        if how.pace > 0.05 && self.eighth % 2 == 1 {
            self.sing(&ensemble.bass(self.chord[0], BASS * how.pace));
        }
        if how.pace > BRISK {
            self.sing(&ensemble.brush(BRUSH * (how.pace - BRISK) / (1.0 - BRISK)));
        }
        if how.goals > 0.0 {
            let pitch = 2.0 * self.chord[self.eighth as usize % self.chord.len()];
            self.sing(&ensemble.pluck(pitch, 0.8, BROKEN * how.goals));
        }
    }

    /// Notes go from side to side.
    fn sing(&mut self, recipe: &Recipe) {
        let side = if self.eighth.is_multiple_of(2) { 0.58 } else { 0.42 };
        self.choir.sing(Voice::new(recipe, self.rate, [1.0 - side, side]));
    }

    /// A chord over `length` s. Each note is two tones that beat slowly.
    fn swell(&mut self, chord: [f32; 3], length: f32) {
        let mut recipe = Recipe::default();
        for (i, to) in recipe.tones.iter_mut().enumerate() {
            let (pitch, share) = (chord[i / 2] * [0.9988, 1.0012][i % 2], [1.0, 0.7, 0.5][i / 2]);
            let peak = CHORD * share;
            *to = Some(Tone { at: 0.0, pitch, glide: 0.0, swell: 0.3 * length, fade: 0.4 * length, peak });
        }
        self.choir.sing(Voice::new(&recipe, self.rate, [1.0, 1.0]));
    }
}

/// An echo from the other side, duller each time.
#[derive(Debug)]
struct Echo {
    /// A ring of samples, left and right.
    past: Vec<[f32; 2]>,
    at: usize,
    delay: usize,
    dull: [LowPass; 2],
}

impl Echo {
    fn new(rate: f32) -> Self {
        let mut dull = LowPass::default();
        dull.set(rate, 2200.0);
        let longest = (LONGEST_ECHO * rate) as usize + 1;
        Self { past: vec![[0.0; 2]; longest], at: 0, delay: longest - 1, dull: [dull; 2] }
    }

    fn set(&mut self, seconds: f32, rate: f32) {
        self.delay = ((seconds * rate) as usize).clamp(1, self.past.len() - 1);
    }

    fn next(&mut self, dry: [f32; 2]) -> [f32; 2] {
        let from = (self.at + self.past.len() - self.delay) % self.past.len();
        let [left, right] = self.past[from];
        let wet = [self.dull[0].next(right) * ECHO, self.dull[1].next(left) * ECHO];
        self.past[self.at] = [dry[0] + wet[0], dry[1] + wet[1]];
        self.at = (self.at + 1) % self.past.len();
        wet
    }

    fn clear(&mut self) {
        self.past.fill([0.0; 2]);
    }
}
