//! The sum of all sounds: stereo samples from the desk's state.

use super::bed::Bed;
use super::ensemble::Arrangement;
use super::filter::{Glide, LowPass, WhiteNoise};
use super::limiter::Limiter;
use super::music::Music;
use super::recipe::Recipe;
use super::voice::{Choir, Voice};
use super::{Ambience, Feed, Volumes};

/// Samples between two looks at the desk: 1.3 ms at 48 kHz.
const STEP: u32 = 64;
/// Time constant of the volumes, s.
const VOLUME_TIME: f32 = 0.02;
/// Without a frame for this time, s, the game is held up: the continuous sounds stop until it goes on.
const HELD_UP: f32 = 0.4;
/// Corner frequency under water, Hz; in air all passes.
const UNDER_WATER: f32 = 420.0;
const IN_AIR: f32 = 18_000.0;
/// At the default volumes flights average about −19 dBFS, as other games do; the limiter takes the louder part: a crash beside the
/// engine, or volumes near their ends.
const EFFECTS: f32 = 2.84;
/// At full volume music is nearly as loud as the engine; by default, far below it.
const MUSIC: f32 = 5.68;

/// Computes the samples. It allocates nothing after construction, and never waits.
#[derive(Debug)]
pub struct Mixer {
    feed: Feed,
    rate: f32,
    noise: WhiteNoise,
    choir: Choir<32>,
    bed: Bed,
    music: Music,
    /// Two in a row for each side.
    water: [[LowPass; 2]; 2],
    /// The desk's last state.
    volumes: Volumes,
    ambience: Ambience,
    tune: Option<u32>,
    how: Arrangement,
    frames: u32,
    /// Samples since the last frame.
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
        let corner = IN_AIR * (UNDER_WATER / IN_AIR).powf(self.bed.liquid());
        for filter in self.water.as_flattened_mut() {
            filter.set(self.rate, corner.min(0.4 * self.rate));
        }
    }
}
