//! Plays a [`Tune`]: chords, a plucked melody and an echo from side to side; with speed a bass and a brush come in, with goals broken chords. Its
//! notes come from a number: a scale, a pace, and motifs that return changed. Each world has an ensemble with scales, a pace and sounds of its own.

use super::cue::{Recipe, SoundPart, burst, struck};
use super::filter::{Glide, LowPass, WhiteNoise};
use super::voice::{Choir, Voice};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg32;

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
            self.gain.value = 0.0;
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
            self.sing(&ensemble.pluck(2.0 * self.chord[self.eighth as usize % self.chord.len()], 0.8, BROKEN * how.goals));
        }
    }

    /// Notes go from side to side.
    fn sing(&mut self, recipe: &Recipe) {
        let side = if self.eighth.is_multiple_of(2) { 0.58 } else { 0.42 };
        self.choir.sing(Voice::new(recipe, self.rate, [1.0 - side, side]));
    }

    /// A chord over `length` s. Each note is two tones that beat slowly.
    fn swell(&mut self, chord: [f32; 3], length: f32) {
        let recipe = Recipe::new((0..2 * chord.len()).map(|i| {
            let (pitch, share) = (chord[i / 2] * [0.9988, 1.0012][i % 2], [1.0, 0.7, 0.5][i / 2]);
            SoundPart { swell: 0.3 * length, ..struck(pitch, 0.4 * length, CHORD * share) }
        }));
        self.choir.sing(Voice::new(&recipe, self.rate, [1.0, 1.0]));
    }
}

/// An echo from the other side, duller each time.
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
        let [left, right] = self.past[(self.at + self.past.len() - self.delay) % self.past.len()];
        let wet = [self.dull[0].next(right) * ECHO, self.dull[1].next(left) * ECHO];
        self.past[self.at] = [dry[0] + wet[0], dry[1] + wet[1]];
        self.at = (self.at + 1) % self.past.len();
        wet
    }

    fn clear(&mut self) {
        self.past.fill([0.0; 2]);
    }
}

/// Eighths a bar and bars a section.
pub const BAR: u32 = 8;
const SECTION: u32 = 8;
/// The roots, Hz: from G₂ to E₃.
const ROOTS: [f32; 6] = [98.0, 110.0, 123.47, 130.81, 146.83, 164.81];
/// The lowest and highest degree of the melody.
const LOWEST: i32 = 5;
const HIGHEST: i32 = 16;

/// An endless piece of music: the same from the same number and ensemble.
pub struct Tune {
    number: u32,
    scale: [i32; 5],
    root: f32,
    /// s.
    pub eighth: f32,
    /// The present section, with its motif and the degrees of its bars.
    section: u32,
    motif: [Option<i32>; BAR as usize],
    grounds: [i32; 4],
}

/// The notes that begin with an eighth.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Notes {
    /// The melody: Hz, and the strength of the strike, 0 … 1.
    pub melody: Option<(f32, f32)>,
    /// The chord of a bar: its root, fifth and octave or tenth, Hz.
    pub chord: Option<[f32; 3]>,
}

impl Tune {
    pub fn new(number: u32, ensemble: &Ensemble) -> Self {
        let mut chance = Pcg32::seed_from_u64(u64::from(number));
        let scale = ensemble.scales[chance.random_range(0..ensemble.scales.len())];
        let root = ROOTS[chance.random_range(0..ROOTS.len())];
        let [slowest, fastest] = ensemble.quarters;
        let eighth = 30.0 / chance.random_range(slowest..fastest);
        let mut tune = Self { number, scale, root, eighth, section: 0, motif: [None; BAR as usize], grounds: [0; 4] };
        tune.begin_section(0);
        tune
    }

    pub fn notes(&mut self, eighth: u32) -> Notes {
        let (bar, beat) = (eighth / BAR, eighth % BAR);
        let (section, bar) = (bar / SECTION, bar % SECTION);
        if section != self.section {
            self.begin_section(section);
        }
        let ground = self.grounds[(bar / 2) as usize % self.grounds.len()];
        let chord = (beat == 0 && bar.is_multiple_of(2))
            .then(|| [ground, ground + 3, ground + if ground == 0 { 5 } else { 6 }].map(|degree| self.pitch(degree)));
        Notes { melody: self.melody(section, bar, beat), chord }
    }

    /// The first four bars play the motif, answer it higher and backwards, repeat it and pause; the last four do so thinned out.
    fn melody(&self, section: u32, bar: u32, beat: u32) -> Option<(f32, f32)> {
        let last = self.motif.len() - 1;
        let degree = match bar % 4 {
            0 | 2 => self.motif[beat as usize]?,
            1 => self.motif[last - beat as usize]? + 2,
            _ if beat < 3 => self.motif[beat as usize]?,
            _ => return None,
        };
        let mut chance = self.chance(u64::from(section) << 32 | u64::from(bar * BAR + beat) << 8 | 1);
        chance.random_bool(if bar < 4 { 0.85 } else { 0.6 }).then(|| {
            let strength = if beat == 0 { 1.0 } else { chance.random_range(0.45..0.85_f32) };
            (self.pitch(degree.clamp(LOWEST, HIGHEST)), strength)
        })
    }

    /// A walk by small steps over the scale, with rests; and the degrees of its bars.
    fn begin_section(&mut self, section: u32) {
        self.section = section;
        let mut chance = self.chance(u64::from(section) << 32);
        let mut degree = chance.random_range(8..13);
        for (beat, note) in self.motif.iter_mut().enumerate() {
            degree = (degree + [-2, -1, -1, 1, 1, 2][chance.random_range(0..6)]).clamp(LOWEST, HIGHEST);
            *note = (beat == 0 || chance.random_bool(0.55)).then_some(degree);
        }
        self.grounds = [0, chance.random_range(1..5), chance.random_range(2..4), 0];
    }

    /// The pitch of a degree of the scale, Hz; five to the octave.
    fn pitch(&self, degree: i32) -> f32 {
        self.root * ((12 * degree.div_euclid(5) + self.scale[degree.rem_euclid(5) as usize]) as f32 / 12.0).exp2()
    }

    fn chance(&self, place: u64) -> Pcg32 {
        Pcg32::seed_from_u64(u64::from(self.number).wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ place)
    }
}

pub const WORLDS: usize = 5;

#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Arrangement {
    /// Of [`WORLDS`]; further ones begin again.
    pub world: usize,
    /// 0 … 1: a bass and a brush come in with the ship's speed.
    pub pace: f32,
    /// 0 … 1: broken chords come in with the goals that are met.
    pub goals: f32,
}

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
        Recipe::new(self.partials.into_iter().enumerate().map(|(i, (ratio, fade, share))| {
            // A harder strike is brighter.
            let bright = if i == 1 { strength } else { 1.0 };
            SoundPart { swell: self.attack, ..struck(pitch * ratio, fade, peak * strength * share * bright) }
        }))
    }

    pub fn bass(&self, pitch: f32, peak: f32) -> Recipe {
        let tone = |pitch, fade, peak| SoundPart { swell: 0.006 + 0.3 * self.attack, ..struck(pitch, fade, peak) };
        Recipe::new([tone(pitch, 0.22, peak), tone(2.0 * pitch, 0.1, 0.3 * peak)])
    }

    pub fn brush(&self, peak: f32) -> Recipe {
        Recipe::new([SoundPart { swell: 0.004, ..burst(self.brush.0, 0.9, self.brush.1, peak) }])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By turns of each world.
    fn tune(number: u32) -> Tune {
        Tune::new(number, Ensemble::of(number as usize % WORLDS))
    }

    fn first_minutes(number: u32) -> Vec<Notes> {
        let mut tune = tune(number);
        (0..4 * SECTION * BAR).map(|eighth| tune.notes(eighth)).collect()
    }

    #[test]
    fn a_tune_is_the_same_every_time_and_others_are_others() {
        assert_eq!(first_minutes(3), first_minutes(3));
        for other in [0, 1, 2, 4, 5] {
            assert_ne!(first_minutes(3), first_minutes(other), "{other}");
        }
    }

    #[test]
    fn every_note_is_one_of_five_and_none_is_shrill() {
        for number in 0..20 {
            let tune = tune(number);
            for notes in first_minutes(number) {
                let pitches = notes.melody.into_iter().map(|(pitch, _)| pitch).chain(notes.chord.into_iter().flatten());
                for pitch in pitches {
                    assert!((90.0..2000.0).contains(&pitch), "tune {number}: {pitch} Hz");
                    let semitone = (12.0 * (pitch / tune.root).log2()).round() as i32;
                    assert!(tune.scale.contains(&semitone.rem_euclid(12)), "tune {number}: {semitone}");
                }
            }
        }
    }

    #[test]
    fn it_sings_and_rests_and_does_not_repeat_itself() {
        for number in 0..20 {
            let notes = first_minutes(number);
            let sung = notes.iter().filter(|notes| notes.melody.is_some()).count();
            assert!((notes.len() / 8..notes.len() * 3 / 4).contains(&sung), "tune {number}: {sung} of {}", notes.len());
            let section = (SECTION * BAR) as usize;
            assert_ne!(notes[..section], notes[section..2 * section], "tune {number}");
        }
    }
}
