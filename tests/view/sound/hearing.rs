//! A listener: plays for a while and measures.

use resultant::sound::{Ambience, Cue, Mixer, Sound, SoundDesk, Volumes, desk};
use std::f64::consts::TAU;

pub const RATE: u32 = 48_000;
/// As loud as it gets.
pub const FULL: Volumes = Volumes { master: 1.0, effects: 1.0, music: 1.0 };
/// So loud that the limiter leaves each sound alone as it is: 0.8 times the amplitudes of the recipes.
pub const ALONE: Volumes = Volumes { master: 0.531, ..FULL };
/// Frames a second, and samples a frame.
const FRAMES: u32 = 60;
const FRAME: usize = (RATE / FRAMES) as usize;

/// A game's end and a mixer's.
pub struct Listener {
    pub desk: SoundDesk,
    pub mixer: Mixer,
}

impl Listener {
    /// At a volume at which each sound is left alone as it is; the glide of the volumes before the first sound is over.
    pub fn new() -> Self {
        let (desk, feed) = desk();
        desk.set_volumes(ALONE);
        let mut listener = Self { desk, mixer: Mixer::new(RATE, feed) };
        listener.hear(0.5, Ambience::default());
        listener
    }

    /// The samples of `seconds` of frames with these surroundings.
    pub fn hear(&mut self, seconds: f64, ambience: Ambience) -> Heard {
        let mut samples = Vec::new();
        for _ in 0..(seconds * f64::from(FRAMES)).round() as usize {
            self.desk.set_ambience(ambience);
            let mut frame = [0.0; 2 * FRAME];
            self.mixer.render(&mut frame);
            samples.extend_from_slice(frame.as_chunks().0);
        }
        Heard(samples)
    }

    /// One sound and all of its fading.
    pub fn hear_cue(&mut self, cue: Cue, loudness: f32) -> Heard {
        self.desk.play(Sound::new(cue, loudness));
        self.hear(5.0, Ambience::default())
    }
}

#[derive(PartialEq)]
pub struct Heard(pub Vec<[f32; 2]>);

impl Heard {
    /// Both sides together.
    pub fn mono(&self) -> impl DoubleEndedIterator<Item = f64> + ExactSizeIterator + '_ {
        self.0.iter().map(|[left, right]| 0.5 * (f64::from(*left) + f64::from(*right)))
    }

    pub fn peak(&self) -> f64 {
        f64::from(self.0.as_flattened().iter().fold(0.0_f32, |peak, sample| peak.max(sample.abs())))
    }

    /// The root of the mean square of both sides, over all of it.
    pub fn rms(&self) -> f64 {
        let samples = self.0.as_flattened();
        (samples.iter().map(|sample| f64::from(*sample).powi(2)).sum::<f64>() / samples.len() as f64).sqrt()
    }

    /// That of the loudest 20 ms: how loud a short sound is heard.
    pub fn loudest(&self) -> f64 {
        let rms = |part: &[[f32; 2]]| Self(part.to_vec()).rms();
        self.0.chunks_exact(RATE as usize / 50).map(rms).fold(0.0, f64::max)
    }

    /// s until the last sample above −50 dB of the peak.
    pub fn length(&self) -> f64 {
        let least = self.peak() * 10_f64.powf(-50.0 / 20.0);
        let last = self.mono().rposition(|sample| sample.abs() > least);
        last.map_or(0.0, |last| (last + 1) as f64 / f64::from(RATE))
    }

    pub fn step(&self) -> f64 {
        self.0.windows(2).map(|pair| f64::from((pair[1][0] - pair[0][0]).abs())).fold(0.0, f64::max)
    }

    /// The amplitude at a frequency (Hz), by Goertzel's sum over a Hann window.
    pub fn at(&self, hertz: f64) -> f64 {
        let n = self.0.len() as f64;
        let (mut re, mut im) = (0.0, 0.0);
        for (i, sample) in self.mono().enumerate() {
            let hann = 0.5 - 0.5 * (TAU * i as f64 / n).cos();
            let (sin, cos) = (TAU * hertz * i as f64 / f64::from(RATE)).sin_cos();
            (re, im) = (re + hann * sample * cos, im + hann * sample * sin);
        }
        4.0 * f64::hypot(re, im) / n
    }

    /// The frequency at which it is strongest between two, Hz, in steps of a semitone's eighth.
    pub fn pitch(&self, from: f64, to: f64) -> f64 {
        let count = (96.0 * (to / from).log2()) as i32;
        let pitches = (0..=count).map(|i| from * (f64::from(i) / 96.0).exp2());
        pitches.map(|hertz| (self.at(hertz), hertz)).fold((0.0, 0.0), |best, next| if next.0 > best.0 { next } else { best }).1
    }

    /// How bright: the frequency (Hz) that the mean square of the slope has beside that of the samples.
    pub fn brightness(&self) -> f64 {
        let slope: f64 = self.0.windows(2).map(|pair| f64::from(pair[1][0] - pair[0][0]).powi(2)).sum();
        let power: f64 = self.0.iter().map(|[left, _]| f64::from(*left).powi(2)).sum();
        (slope / power).sqrt() * f64::from(RATE) / TAU
    }

    pub fn part(&self, from: f64, to: f64) -> Self {
        let at = |seconds: f64| (seconds * f64::from(RATE)) as usize;
        Self(self.0[at(from)..at(to)].to_vec())
    }
}
