//! The sum of all sounds: stereo samples from the desk's state; the engine, the wind and the liquid are noise, filtered by the strength of each.
//! A limiter sees loud samples in advance, by a short delay, and turns down in time; samples below its ceiling pass unchanged.

use super::filter::{BandPass, Glide, LowPass, WhiteNoise};
use super::music::{Arrangement, Music};
use super::voice::{Choir, Voice};
use super::{Ambience, Cue, Feed, Volumes, cue::Recipe};
use std::f32::consts::TAU;

/// Samples between two looks at the desk, and between two updates of filters: 1.3 ms at 48 kHz.
const STEP: u32 = 64;
/// Time constant of the volumes, s.
const VOLUME_TIME: f32 = 0.02;
/// Without a frame for this time, s, the game is held up: the continuous sounds stop until it goes on.
const HELD_UP: f32 = 0.4;
/// Corner frequency under water, Hz; in air all passes.
const UNDER_WATER: f32 = 420.0;
const IN_AIR: f32 = 18_000.0;
/// At the default volumes flights average about −19 dBFS, as other games do; the limiter takes what is louder, as a crash beside the engine.
const EFFECTS: f32 = 2.84;
/// At full volume music is nearly as loud as the engine; by default, far below it.
const MUSIC: f32 = 5.68;

/// Computes the samples. It allocates nothing after construction, and never waits.
pub struct Mixer {
    feed: Feed,
    rate: f32,
    noise: WhiteNoise,
    choir: Choir<32>,
    bed: Bed,
    music: Music,
    /// Two in a row for each side.
    water: [[LowPass; 2]; 2],
    volumes: Volumes,
    ambience: Ambience,
    tune: Option<u32>,
    how: Arrangement,
    frames: u32,
    held_up: u32,
    effects_gain: Glide,
    music_gain: Glide,
    limiter: Limiter,
    age: u32,
}

impl Mixer {
    /// `rate` is samples a second.
    pub fn new(rate: u32, feed: Feed) -> Self {
        let frames = feed.frames();
        let rate = rate.max(8000) as f32;
        let gain = Glide::new(rate, VOLUME_TIME);
        feed.forget();
        Self {
            feed,
            rate,
            noise: WhiteNoise::new(0x736f_756e_6473),
            choir: Choir::new(),
            bed: Bed::new(rate),
            music: Music::new(rate),
            water: Default::default(),
            volumes: Volumes { master: 0.0, effects: 0.0, music: 0.0 },
            ambience: Ambience::default(),
            tune: None,
            how: Arrangement::default(),
            frames,
            held_up: 0,
            effects_gain: gain,
            music_gain: gain,
            limiter: Limiter::new(rate),
            age: 0,
        }
    }

    /// Fills `samples`, left and right by turns, each within −1.4 dBFS. An odd one at the end is silent.
    pub fn render(&mut self, samples: &mut [f32]) {
        let (pairs, rest) = samples.as_chunks_mut();
        for pair in pairs {
            *pair = self.sample();
        }
        rest.fill(0.0);
    }

    /// Left and right.
    pub fn sample(&mut self) -> [f32; 2] {
        if self.age.is_multiple_of(STEP) {
            self.look_at_the_desk();
        }
        self.age = self.age.wrapping_add(1);
        // The ear hears ratios: at half of the setting the amplitude is a quarter.
        let Volumes { master, effects, music } = self.volumes;
        let effects = self.effects_gain.towards(EFFECTS * (master * effects).powi(2));
        let music = self.music_gain.towards(MUSIC * (master * music).powi(2));
        if let Some(bubble) = self.bed.bubble(&mut self.noise) {
            self.choir.sing(bubble);
        }
        let (once, always) = (self.choir.next(&mut self.noise), self.bed.next(&self.ambience, &mut self.noise));
        let tune =
            if music > 1e-5 || !self.music.is_silent() { self.music.next(self.tune, &self.how, &mut self.noise) } else { [0.0; 2] };
        let sum = std::array::from_fn(|side| {
            let [first, second] = &mut self.water[side];
            effects * second.next(first.next(once[side] + always[side])) + music * tune[side]
        });
        self.limiter.next(sum)
    }

    fn look_at_the_desk(&mut self) {
        self.volumes = self.feed.volumes();
        let frames = self.feed.frames();
        self.held_up = if frames == self.frames { self.held_up.saturating_add(STEP) } else { 0 };
        self.frames = frames;
        let moves = (self.held_up as f32) < HELD_UP * self.rate;
        self.ambience = if moves { self.feed.ambience() } else { Ambience::default() };
        // Music at volume 0 is not computed.
        self.tune = self.feed.tune().filter(|_| self.volumes.master * self.volumes.music > 0.0);
        let how = self.feed.arrangement();
        self.how = if moves { how } else { Arrangement { world: how.world, ..Arrangement::default() } };
        while let Some(sound) = self.feed.next() {
            // The power of both sides together is the same at every place.
            let angle = (sound.place + 1.0) * std::f32::consts::FRAC_PI_4;
            let gains = [angle.cos(), angle.sin()].map(|side| side * sound.loudness);
            self.choir.sing(Voice::new(&Recipe::of(sound.cue, sound.loudness), self.rate, gains));
        }
        let corner = IN_AIR * (UNDER_WATER / IN_AIR).powf(self.bed.liquid.value);
        for filter in self.water.as_flattened_mut() {
            filter.set(self.rate, corner.min(0.4 * self.rate));
        }
    }
}

/// The largest sample: −1.4 dBFS, so that the curve between samples stays below −1 dBFS.
const CEILING: f32 = 0.85;
/// Its look-ahead, s: the time in which it turns down. A jump would be heard as a crack; 2 ms are shorter than the ear can tell from one.
const AHEAD: f32 = 0.002;
/// Time constant of its release, s. Shorter: the deepest tone, 46 Hz, is distorted; longer than a crash's decay: the engine is heard to swell after it.
const RELEASE: f32 = 0.12;
/// A gain from here on counts as 1.
const NEARLY: f32 = 0.9995;

/// Both sides have the same gain, so that no sound moves from side to side.
struct Limiter {
    /// Rings of the delayed samples, of the gain that each needs, and of the target gain at its arrival.
    samples: Vec<[f32; 2]>,
    needed: Vec<f32>,
    aims: Vec<f32>,
    at: usize,
    /// The target gain, and the samples for which it is held.
    aim: f32,
    held: usize,
    open: usize,
    /// Of the targets in the ring; `f64` keeps its rounding inaudible.
    sum: f64,
    /// The part of the difference to 1 that is left after a sample.
    keeps: f32,
}

impl Limiter {
    /// `rate` is samples a second.
    pub fn new(rate: f32) -> Self {
        let ahead = (AHEAD * rate).ceil().max(1.0) as usize;
        Self {
            samples: vec![[0.0; 2]; ahead],
            needed: vec![1.0; ahead],
            aims: vec![1.0; ahead],
            at: 0,
            aim: 1.0,
            held: 0,
            open: ahead,
            sum: ahead as f64,
            keeps: (-1.0 / (RELEASE * rate)).exp(),
        }
    }

    /// The delayed sample, left and right. Its gain is the mean of the targets since its arrival, none above its need: it ends below the ceiling.
    pub fn next(&mut self, sample: [f32; 2]) -> [f32; 2] {
        let ahead = self.samples.len();
        let peak = sample[0].abs().max(sample[1].abs());
        let needs = if peak > CEILING { CEILING / peak } else { 1.0 };
        let heard = std::mem::replace(&mut self.samples[self.at], sample);
        self.needed[self.at] = needs;
        let gain = if self.open >= ahead { 1.0 } else { (self.sum / ahead as f64) as f32 };
        self.take_aim(needs);
        self.sum += f64::from(self.aim) - f64::from(std::mem::replace(&mut self.aims[self.at], self.aim));
        self.open = if self.aim == 1.0 { self.open + 1 } else { 0 };
        if self.open >= ahead {
            self.sum = ahead as f64;
        }
        self.at = (self.at + 1) % ahead;
        heard.map(|side| gain * side)
    }

    fn take_aim(&mut self, needs: f32) {
        if needs <= self.aim && needs < 1.0 {
            (self.aim, self.held) = (needs, self.samples.len());
        } else if self.held > 0 {
            self.held -= 1;
        } else if self.aim < 1.0 {
            let released = 1.0 - (1.0 - self.aim) * self.keeps;
            let released = if released > NEARLY { 1.0 } else { released };
            self.aim = self.needed.iter().fold(released, |least, needed| least.min(*needed));
        }
    }
}

/// Time constant of the engine's response to thrust, s: immediate, but without a crack.
const ENGINE_TIME: f32 = 0.025;
/// Time constant of wind and liquid, s.
const SLOW: f32 = 0.12;
/// The loudness of each at its strongest.
const ENGINE: f32 = 0.42;
const RUMBLE: f32 = 0.11;
const WIND: f32 = 0.85;
const LIQUID: f32 = 0.35;
/// Pitch of the rumble below the engine, Hz.
const RUMBLE_PITCH: f32 = 46.0;
/// The most bubbles a second.
const BUBBLES: f32 = 16.0;

pub struct Bed {
    rate: f32,
    engine: Glide,
    wind: Glide,
    liquid: Glide,
    motion: Glide,
    /// The engine's roar: one for both sides, and one for each.
    roar: [[LowPass; 2]; 3],
    howl: [BandPass; 2],
    flow: LowPass,
    /// Phase of the rumble in turns, and the time of the slow wander, s.
    turn: f32,
    time: f32,
    age: u32,
}

impl Bed {
    pub fn new(rate: f32) -> Self {
        let (quick, slow) = (Glide::new(rate, ENGINE_TIME), Glide::new(rate, SLOW));
        Self {
            rate,
            engine: quick,
            wind: slow,
            liquid: slow,
            motion: slow,
            roar: Default::default(),
            howl: Default::default(),
            flow: LowPass::default(),
            turn: 0.0,
            time: 0.0,
            age: 0,
        }
    }

    /// A bubble that begins at random.
    pub fn bubble(&mut self, noise: &mut WhiteNoise) -> Option<Voice> {
        let liquid = self.liquid.value;
        let rate = BUBBLES * liquid * (0.2 + 0.8 * self.motion.value);
        if liquid < 1e-3 || noise.between(0.0, 1.0) * self.rate >= rate {
            return None;
        }
        let (size, side) = (noise.between(0.0, 1.0), noise.between(0.35, 0.65));
        let gain = 0.5 * noise.between(0.3, 1.0);
        Some(Voice::new(&Recipe::of(Cue::Bubble, size), self.rate, [gain * (1.0 - side), gain * side]))
    }

    /// Left and right.
    pub fn next(&mut self, target: &Ambience, noise: &mut WhiteNoise) -> [f32; 2] {
        self.engine.towards(target.engine);
        self.wind.towards(target.wind);
        self.liquid.towards(target.liquid);
        self.motion.towards(target.motion);
        if self.age.is_multiple_of(STEP) {
            self.set_filters();
        }
        self.age = self.age.wrapping_add(1);
        let mut sum = [0.0; 2];
        if self.engine.value > 1e-4 {
            self.add_engine(&mut sum, noise);
        }
        if self.wind.value > 1e-4 {
            let gain = WIND * self.wind.value.powf(1.5);
            sum.iter_mut().zip(&mut self.howl).for_each(|(sum, howl)| *sum += gain * howl.next(noise.next()));
        }
        if self.liquid.value > 1e-4 {
            let flow = LIQUID * self.liquid.value * (0.3 + 0.7 * self.motion.value) * self.flow.next(noise.next());
            sum.iter_mut().for_each(|sum| *sum += flow);
        }
        sum
    }

    fn add_engine(&mut self, sum: &mut [f32; 2], noise: &mut WhiteNoise) {
        let strength = self.engine.value;
        let mut roar = [0.0; 3];
        for (out, [first, second]) in roar.iter_mut().zip(&mut self.roar) {
            *out = second.next(first.next(noise.next()));
        }
        self.turn = (self.turn + RUMBLE_PITCH * (0.85 + 0.3 * strength) / self.rate).fract();
        let rumble = RUMBLE * (TAU * self.turn).sin();
        for (sum, own) in sum.iter_mut().zip(&roar[1..]) {
            *sum += strength * (ENGINE * (1.6 * roar[0] + 0.8 * own) + rumble);
        }
    }

    fn set_filters(&mut self) {
        let rate = self.rate;
        self.time += STEP as f32 / rate;
        let (engine, wind, t) = (self.engine.value, self.wind.value, self.time);
        for filter in self.roar.as_flattened_mut() {
            // A wide filter lets more pass: it makes the engine brighter and louder.
            filter.set(rate, 240.0 + 1300.0 * engine);
        }
        let gust = 1.0 + 0.22 * (TAU * 0.31 * t).sin() + 0.13 * (TAU * 0.83 * t).sin();
        for (side, howl) in self.howl.iter_mut().enumerate() {
            howl.set(rate, (170.0 + 1100.0 * wind) * gust * (1.0 + 0.07 * side as f32), 1.3);
        }
        self.flow.set(rate, 160.0 + 240.0 * self.motion.value);
        // Sines of a time that grows for hours lose their precision; the wander repeats after 100 s.
        if self.time >= 100.0 {
            self.time -= 100.0;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RATE: f32 = 48_000.0;

    fn limited(samples: impl IntoIterator<Item = [f32; 2]>) -> Vec<[f32; 2]> {
        let mut limiter = Limiter::new(RATE);
        let ahead = limiter.samples.len();
        let silence = std::iter::repeat_n([0.0; 2], ahead);
        samples.into_iter().chain(silence).map(|sample| limiter.next(sample)).skip(ahead).collect()
    }

    #[test]
    fn what_is_below_the_ceiling_passes_to_the_bit() {
        let mut noise = WhiteNoise::new(3);
        let quiet: Vec<[f32; 2]> = (0..48_000).map(|_| [CEILING * noise.next(), CEILING * noise.next()]).collect();
        assert!(limited(quiet.clone()) == quiet);
    }

    #[test]
    fn nothing_passes_the_ceiling_however_loud_and_however_sudden() {
        let mut noise = WhiteNoise::new(5);
        let mut wild = Vec::new();
        for i in 0..200_000 {
            // Single samples, bursts of every length and strength, on one side or both.
            let strength = noise.between(0.0, 1.0).powi(8) * 30.0;
            let length = noise.between(1.0, 300.0) as usize * usize::from(i % 97 == 0) + usize::from(i % 13 == 0);
            for _ in 0..length.min(300) {
                wild.push([strength * noise.next(), 0.3 * strength * noise.next()]);
            }
            wild.push([0.0; 2]);
        }
        let heard = limited(wild.iter().copied());
        let most = heard.as_flattened().iter().fold(0.0_f32, |most, sample| most.max(sample.abs()));
        assert!(most <= CEILING * 1.000_01, "{most}");
        // The limiter turns down no further than necessary: long quiet passages are unchanged.
        let quiet = limited((0..96_000).map(|i| if i < 4800 { [9.0; 2] } else { [0.1; 2] }));
        assert_eq!(quiet[95_000], [0.1; 2]);
    }

    #[test]
    fn it_turns_down_within_its_sight_and_up_within_a_few_tenths_of_a_second_and_never_jumps() {
        // A tone below the ceiling, a tenth of a second of one four times as loud, the first again; the test reads the gain at
        // every sample.
        let tone = |i: usize| 0.7 * (TAU * 1000.0 * i as f32 / RATE + 0.4).sin();
        let loud = 24_000..28_800;
        let samples: Vec<[f32; 2]> = (0..72_000).map(|i| [if loud.contains(&i) { 4.0 } else { 1.0 } * tone(i); 2]).collect();
        let heard = limited(samples.iter().copied());
        let clear = |i: &usize| samples[*i][0].abs() > 0.05;
        let gains: Vec<(usize, f32)> = (0..72_000).filter(clear).map(|i| (i, heard[i][0] / samples[i][0])).collect();
        let at = |from: usize, to: usize| gains.iter().filter(move |(i, _)| (from..to).contains(i)).map(|(_, gain)| *gain);
        assert!(at(0, 23_900).all(|gain| gain == 1.0), "nothing is turned down before it must be");
        assert!(at(24_100, 28_800).all(|gain| gain < 0.31), "the whole of the loud tone is turned down, and evenly");
        assert!(at(24_100, 28_800).all(|gain| gain > 0.29));
        assert!(at(28_800 + 96, 28_800 + 2400).all(|gain| gain < 0.7), "it does not come back with a jump");
        assert!(at(28_800 + 24_000, 72_000).all(|gain| gain > 0.98), "nor does it stay away");
        let steps = gains.windows(2).map(|pair| (pair[1].1 - pair[0].1).abs() / (pair[1].0 - pair[0].0) as f32);
        assert!(steps.fold(0.0, f32::max) < 0.012, "by less than a tenth of a decibel a sample");
    }
}
