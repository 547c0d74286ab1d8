//! Plays a [`Recipe`], sample by sample. Nothing is allocated: a fixed number of voices is used again and again.

use super::cue::{PARTS, Recipe, SoundPart};
use super::filter::{BandPass, WhiteNoise};
use std::f32::consts::TAU;

/// Samples between two updates of the pitches.
const STEP: u32 = 32;
/// In time constants (e⁻⁸ is −70 dB): a part ends after this, and its last `END` seconds ramp down to 0.
const FADES: f32 = 8.0;
const END: f32 = 0.006;
/// The highest pitch as a share of the rate: above half of it a pitch would alias.
const HIGHEST: f32 = 0.45;

pub struct Voice {
    rate: f32,
    parts: [Option<PlayedPart>; PARTS],
    age: u32,
    length: u32,
    gains: [f32; 2],
}

#[derive(Clone, Copy, Debug)]
struct PlayedPart {
    part: SoundPart,
    envelope: Envelope,
    source: PartSource,
}

#[derive(Clone, Copy, Debug)]
enum PartSource {
    /// A unit vector, whose y is the sine, and how it turns.
    Sine([f32; 2], [f32; 2]),
    /// With its narrowness.
    Hiss(BandPass, f32),
}

/// Rises linearly from 0 to 1 and decays at the same time.
#[derive(Clone, Copy, Debug)]
struct Envelope {
    begins: u32,
    swollen: f32,
    swells: f32,
    level: f32,
    keeps: f32,
}

impl Envelope {
    fn new(rate: f32, SoundPart { at, swell, fade, .. }: SoundPart) -> Self {
        let swells = 1.0 / (swell * rate).max(1.0);
        Self { begins: (at * rate) as u32, swollen: 0.0, swells, level: 1.0, keeps: (-1.0 / (fade * rate)).exp() }
    }

    fn next(&mut self) -> f32 {
        self.swollen = (self.swollen + self.swells).min(1.0);
        self.level *= self.keeps;
        self.swollen * self.level
    }
}

impl PartSource {
    fn next(&mut self, noise: &mut WhiteNoise) -> f32 {
        match self {
            Self::Sine(at, [c, s]) => {
                *at = [at[0] * *c - at[1] * *s, at[0] * *s + at[1] * *c];
                at[1]
            }
            Self::Hiss(filter, _) => filter.next(noise.next()),
        }
    }
}

impl Voice {
    /// The recipe from its beginning, at `rate` samples a second; one gain for the left and one for the right.
    pub fn new(recipe: &Recipe, rate: f32, gains: [f32; 2]) -> Self {
        let ends = recipe.0.iter().flatten().map(|part| part.at + part.swell + FADES * part.fade);
        let length = (ends.fold(0.0, f32::max) * rate) as u32;
        let played = |part: SoundPart| {
            let hiss = part.narrowness.map(|narrowness| PartSource::Hiss(BandPass::default(), narrowness));
            PlayedPart {
                part,
                envelope: Envelope::new(rate, part),
                source: hiss.unwrap_or(PartSource::Sine([1.0, 0.0], [1.0, 0.0])),
            }
        };
        Self { rate, parts: recipe.0.map(|part| part.map(played)), age: 0, length, gains }
    }

    pub const fn left(&self) -> u32 {
        self.length - self.age
    }

    /// Left and right; `None` at the end.
    pub fn next(&mut self, noise: &mut WhiteNoise) -> Option<[f32; 2]> {
        if self.age >= self.length {
            return None;
        }
        if self.age.is_multiple_of(STEP) {
            self.tune();
        }
        let mut sum = 0.0;
        for PlayedPart { part, envelope, source } in self.parts.iter_mut().flatten() {
            if self.age >= envelope.begins {
                sum += part.peak * envelope.next() * source.next(noise);
            }
        }
        let end = (self.left() as f32 / (END * self.rate)).min(1.0);
        self.age += 1;
        Some(self.gains.map(|gain| gain * end * sum))
    }

    fn tune(&mut self) {
        let (age, rate) = (self.age, self.rate);
        for PlayedPart { part, envelope, source } in self.parts.iter_mut().flatten() {
            let t = age.saturating_sub(envelope.begins) as f32 / rate;
            let pitch = (part.pitch * (part.glide * t).exp2()).min(HIGHEST * rate);
            match source {
                PartSource::Sine(at, turn) => {
                    let (s, c) = (TAU * pitch / rate).sin_cos();
                    *turn = [c, s];
                    // Rounding changes the vector's length over time.
                    let length = at[0].hypot(at[1]);
                    *at = at.map(|side| side / length);
                }
                PartSource::Hiss(filter, narrowness) => filter.set(rate, pitch, *narrowness),
            }
        }
    }
}

/// A fixed number of voices. A new one replaces the one nearest its end when all are taken.
pub struct Choir<const N: usize>([Option<Voice>; N]);

impl<const N: usize> Choir<N> {
    pub const fn new() -> Self {
        Self([const { None }; N])
    }

    pub fn sing(&mut self, voice: Voice) {
        let left = |voice: &Option<Voice>| voice.as_ref().map_or(0, Voice::left);
        if let Some(place) = self.0.iter_mut().min_by_key(|place| left(place)) {
            *place = Some(voice);
        }
    }

    /// The sum of all, left and right.
    pub fn next(&mut self, noise: &mut WhiteNoise) -> [f32; 2] {
        let mut sum = [0.0; 2];
        for place in &mut self.0 {
            let Some(voice) = place else { continue };
            match voice.next(noise) {
                Some([left, right]) => sum = [sum[0] + left, sum[1] + right],
                None => *place = None,
            }
        }
        sum
    }

    pub fn hush(&mut self) {
        self.0.fill_with(|| None);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sound::Cue;

    #[test]
    fn a_full_choir_gives_up_the_voice_nearest_its_end() {
        let mut choir = Choir::<2>::new();
        let voice = |cue| Voice::new(&Recipe::of(cue, 1.0), 48_000.0, [1.0, 1.0]);
        choir.sing(voice(Cue::Success));
        choir.sing(voice(Cue::Move));
        choir.sing(voice(Cue::Death));
        let left: Vec<u32> = choir.0.iter().flatten().map(Voice::left).collect();
        assert_eq!(left, [voice(Cue::Success).left(), voice(Cue::Death).left()]);
    }

    #[test]
    fn a_gliding_tone_keeps_its_amplitude() {
        let tone = SoundPart { at: 0.0, pitch: 100.0, glide: 1.0, narrowness: None, swell: 0.0, fade: 1e6, peak: 0.5 };
        let recipe = Recipe::new([tone]);
        let mut voice = Voice::new(&recipe, 48_000.0, [1.0, 0.5]);
        let mut noise = WhiteNoise::new(0);
        let mut peaks = [0.0_f32; 2];
        for i in 0..192_000 {
            let [left, right] = voice.next(&mut noise).expect("it does not fade");
            if i > 180_000 {
                peaks = [peaks[0].max(left), peaks[1].max(right)];
            }
        }
        assert!((peaks[0] - 0.5).abs() < 0.01 && (peaks[1] - 0.25).abs() < 0.005, "{peaks:?}");
    }
}
