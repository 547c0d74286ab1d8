//! The sounds themselves, as samples −1 … 1 at [`RATE`], made of decaying tones and of noise.

use super::Cue;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg32;
use std::f32::consts::TAU;

/// Samples a second.
pub const RATE: usize = 44_100;
/// Every sound swells and ends within so many samples at least: a jump is heard as a crack.
const EDGE: usize = 64;

/// A cue's samples.
pub fn cue(cue: Cue) -> Vec<f32> {
    match cue {
        Cue::Knock => sum(&[tone(0.12, 0.03, |t| 150.0 - 500.0 * t, 0.8), noise(0.12, 0.01, 0.3, 0.2)]),
        Cue::Crash => sum(&[noise(0.5, 0.1, 0.12, 0.7), tone(0.5, 0.12, |t| 90.0 - 60.0 * t, 0.3)]),
        Cue::Chime => sum(&[tone(0.7, 0.16, |_| 880.0, 0.4), tone(0.7, 0.12, |_| 1318.5, 0.25), tone(0.7, 0.06, |_| 2637.0, 0.1)]),
        Cue::Fanfare => {
            // A major chord, note after note.
            let notes = [523.25, 659.25, 783.99, 1046.5];
            let parts = notes.iter().enumerate().map(|(place, note)| late(0.11 * place as f32, tone(0.6, 0.2, |_| *note, 0.24)));
            sum(&parts.collect::<Vec<_>>())
        }
        Cue::Fall => tone(0.7, 0.3, |t| 330.0 - 340.0 * t, 0.5),
        Cue::Click => sum(&[tone(0.03, 0.004, |_| 2200.0, 0.5), tone(0.03, 0.008, |_| 900.0, 0.3)]),
    }
}

/// A second of a burning engine that joins its own beginning.
pub fn engine() -> Vec<f32> {
    let raw = noise_source(RATE);
    // The filter's second round starts in the state in which it ends.
    let rounds = low_pass(raw.iter().chain(&raw).copied(), 0.03);
    let mut wave = rounds[RATE..].to_vec();
    scale(&mut wave, 0.9);
    wave
}

/// The bytes of a WAV file: one channel of 16 bits.
pub fn wav(samples: &[f32]) -> Vec<u8> {
    let size = 2 * samples.len() as u32;
    let rate = RATE as u32;
    let mut bytes = Vec::with_capacity(44 + samples.len() * 2);
    bytes.extend(b"RIFF");
    bytes.extend((36 + size).to_le_bytes());
    bytes.extend(b"WAVEfmt ");
    bytes.extend(16_u32.to_le_bytes());
    // PCM, one channel.
    bytes.extend([1_u16, 1].map(u16::to_le_bytes).as_flattened());
    bytes.extend([rate, 2 * rate].map(u32::to_le_bytes).as_flattened());
    // Bytes and bits a sample.
    bytes.extend([2_u16, 16].map(u16::to_le_bytes).as_flattened());
    bytes.extend(b"data");
    bytes.extend(size.to_le_bytes());
    for sample in samples {
        bytes.extend(((sample.clamp(-1.0, 1.0) * f32::from(i16::MAX)) as i16).to_le_bytes());
    }
    bytes
}

/// A sine of `length` s that decays within `fading` s by a factor of e; `pitch` is its frequency (Hz) after t s.
fn tone(length: f32, fading: f32, pitch: impl Fn(f32) -> f32, peak: f32) -> Vec<f32> {
    let mut phase = 0.0_f32;
    let wave = (0..samples(length)).map(|i| {
        let t = i as f32 / RATE as f32;
        phase = (phase + pitch(t) / RATE as f32).fract();
        peak * (-t / fading).exp() * (TAU * phase).sin()
    });
    soft_edges(wave.collect())
}

/// Noise of `length` s that decays like a [`tone`]; the smaller `brightness` (0 … 1), the duller.
fn noise(length: f32, fading: f32, brightness: f32, peak: f32) -> Vec<f32> {
    let mut wave = low_pass(noise_source(samples(length)).into_iter(), brightness);
    scale(&mut wave, peak);
    for (i, sample) in wave.iter_mut().enumerate() {
        *sample *= (-(i as f32) / RATE as f32 / fading).exp();
    }
    soft_edges(wave)
}

fn noise_source(count: usize) -> Vec<f32> {
    let mut random = Pcg32::seed_from_u64(0x736f_756e_6473);
    (0..count).map(|_| random.random_range(-1.0..1.0)).collect()
}

fn low_pass(wave: impl Iterator<Item = f32>, brightness: f32) -> Vec<f32> {
    let mut level = 0.0;
    wave.map(|sample| {
        level += brightness * (sample - level);
        level
    })
    .collect()
}

/// Scales to a peak.
fn scale(wave: &mut [f32], peak: f32) {
    let highest = wave.iter().fold(f32::MIN_POSITIVE, |highest, sample| highest.max(sample.abs()));
    for sample in wave {
        *sample *= peak / highest;
    }
}

fn soft_edges(mut wave: Vec<f32>) -> Vec<f32> {
    let count = wave.len();
    for i in 0..EDGE.min(count) {
        let part = i as f32 / EDGE as f32;
        wave[i] *= part;
        wave[count - 1 - i] *= part;
    }
    wave
}

/// After `delay` s of silence.
fn late(delay: f32, wave: Vec<f32>) -> Vec<f32> {
    let mut delayed = vec![0.0; samples(delay)];
    delayed.extend(wave);
    delayed
}

fn sum(parts: &[Vec<f32>]) -> Vec<f32> {
    let mut total = vec![0.0; parts.iter().map(Vec::len).max().unwrap_or(0)];
    for part in parts {
        for (sum, sample) in total.iter_mut().zip(part) {
            *sum += sample;
        }
    }
    total
}

fn samples(seconds: f32) -> usize {
    (seconds * RATE as f32) as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_sound_is_heard_is_never_cut_off_and_starts_and_ends_in_silence() {
        for cue in Cue::ALL {
            let wave = self::cue(cue);
            let peak = wave.iter().fold(0.0_f32, |peak, sample| peak.max(sample.abs()));
            assert!((0.2..=1.0).contains(&peak), "{cue:?} {peak}");
            assert_eq!((wave[0], wave[wave.len() - 1]), (0.0, 0.0), "{cue:?}");
        }
    }

    #[test]
    fn the_engine_joins_its_own_beginning() {
        let wave = engine();
        let step = |a: f32, b: f32| (a - b).abs();
        let widest = wave.windows(2).fold(0.0_f32, |widest, pair| widest.max(step(pair[0], pair[1])));
        assert!(step(wave[0], wave[wave.len() - 1]) <= widest);
    }

    #[test]
    fn a_file_says_how_long_it_is() {
        let file = wav(&[0.0, 1.0, -2.0]);
        assert_eq!(file.len(), 44 + 6);
        assert_eq!(file[4..8], 42_u32.to_le_bytes());
        assert_eq!(file[40..44], 6_u32.to_le_bytes());
        assert_eq!(file[46..], [0xff, 0x7f, 0x01, 0x80]);
    }
}
