//! The one-shot sounds. The parts of each cue: tones that ring and fade, as struck objects do, and bursts of filtered noise.

use crate::physics::Material;

/// The sound of a knock, by the materials that a level can name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stuff {
    /// A dull thud.
    Asphalt,
    Steel,
    /// A hard, high tick.
    Ice,
    Rubber,
    /// A hollow knock.
    Wood,
    /// High and long.
    Glass,
}

impl Stuff {
    /// In the order of [`Material::FIRM`].
    pub const ALL: [Self; 6] = [Self::Asphalt, Self::Steel, Self::Ice, Self::Rubber, Self::Wood, Self::Glass];

    /// A material with another name sounds like rubber where it bounces, else like asphalt.
    pub fn of(material: &Material) -> Self {
        let found = Material::FIRM.iter().position(|known| known.name == material.name);
        let other = if material.restitution > 0.0 { Self::Rubber } else { Self::Asphalt };
        found.map_or(other, |place| Self::ALL[place])
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cue {
    Knock(Stuff),
    /// So hard that it costs points.
    Crash,
    Met,
    Lost,
    Success,
    Death,
    /// The ship dives into a liquid or leaves it.
    Splash,
    Bubble,
    Press,
    /// The keyboard or the pointer goes to another button.
    Move,
    /// A collision of the blocks that count π.
    Click,
    Jump,
}

impl Cue {
    pub const COUNT: usize = 17;
    /// A cue's number is its index here.
    pub const ALL: [Self; Self::COUNT] = [
        Self::Knock(Stuff::Asphalt),
        Self::Knock(Stuff::Steel),
        Self::Knock(Stuff::Ice),
        Self::Knock(Stuff::Rubber),
        Self::Knock(Stuff::Wood),
        Self::Knock(Stuff::Glass),
        Self::Crash,
        Self::Met,
        Self::Lost,
        Self::Success,
        Self::Death,
        Self::Splash,
        Self::Bubble,
        Self::Press,
        Self::Move,
        Self::Click,
        Self::Jump,
    ];

    /// Its index in [`Cue::ALL`].
    pub const fn number(self) -> usize {
        match self {
            Self::Knock(stuff) => stuff as usize,
            Self::Crash => 6,
            Self::Met => 7,
            Self::Lost => 8,
            Self::Success => 9,
            Self::Death => 10,
            Self::Splash => 11,
            Self::Bubble => 12,
            Self::Press => 13,
            Self::Move => 14,
            Self::Click => 15,
            Self::Jump => 16,
        }
    }
}

/// The most parts of one sound.
pub const PARTS: usize = 8;

/// A sine, or noise around a frequency, that swells and fades.
#[derive(Clone, Copy, Debug)]
pub struct SoundPart {
    /// Start, s.
    pub at: f32,
    /// At its beginning, Hz.
    pub pitch: f32,
    /// Octaves a second, negative where it falls.
    pub glide: f32,
    /// Of noise the centre divided by the bandwidth; `None` for a sine.
    pub narrowness: Option<f32>,
    /// Attack, s.
    pub swell: f32,
    /// Time constant of the decay, s.
    pub fade: f32,
    /// Amplitude, of noise that before the filter.
    pub peak: f32,
}

/// The parts of a one-shot sound, present ones first.
#[derive(Clone, Copy, Debug, Default)]
pub struct Recipe(pub [Option<SoundPart>; PARTS]);

impl Recipe {
    /// The recipe of a cue. A harder strike (`loudness` 0 … 1) sounds brighter, besides being louder.
    pub fn of(cue: Cue, loudness: f32) -> Self {
        match cue {
            Cue::Knock(stuff) => knock(stuff, loudness),
            Cue::Crash => {
                let ring =
                    [struck(62.0, 0.22, 0.55), struck(131.0, 0.12, 0.3), struck(417.0, 0.1, 0.12), struck(1149.0, 0.07, 0.08)];
                let crack = [burst(900.0, 0.5, 0.11, 0.75), SoundPart { glide: -3.0, ..burst(3000.0, 0.6, 0.06, 0.5) }];
                Self::new(ring.into_iter().chain(crack))
            }
            // A major chord, strummed upwards, with its octaves; and a fifth that falls.
            Cue::Met => {
                let bell = |at, pitch, peak| SoundPart { at, ..struck(pitch, 0.26, peak) };
                let chord = [(0.0, 587.33, 0.16), (0.035, 739.99, 0.18), (0.07, 880.0, 0.28)];
                let notes = chord.map(|(at, pitch, peak)| [bell(at, pitch, peak), bell(at + 0.01, 2.0 * pitch, 0.3 * peak)]);
                Self::new(notes.into_iter().flatten())
            }
            Cue::Lost => Self::new([(0.0, 659.26), (0.1, 440.0)].into_iter().flat_map(|(at, pitch)| bell(at, pitch, 0.16))),
            // The five notes of the music's scale and the octave.
            Cue::Success => {
                let notes = [523.25, 587.33, 659.26, 783.99, 880.0, 1046.5].into_iter().enumerate();
                let bell = |(place, pitch)| SoundPart { at: 0.085 * place as f32, swell: 0.004, ..struck(pitch, 0.42, 0.22) };
                Self::new(notes.map(bell))
            }
            Cue::Death => Self::new([
                SoundPart { glide: -2.2, swell: 0.01, ..struck(311.1, 0.3, 0.32) },
                SoundPart { glide: -2.2, swell: 0.01, ..struck(220.0, 0.32, 0.32) },
                SoundPart { glide: -0.5, ..struck(55.0, 0.25, 0.5) },
                burst(500.0, 0.4, 0.2, 0.9),
                SoundPart { glide: -2.5, ..burst(2500.0, 0.7, 0.09, 0.5) },
            ]),
            Cue::Splash => Self::new([
                SoundPart { glide: -3.0, swell: 0.015, ..burst(1800.0, 0.7, 0.12, 0.7) },
                SoundPart { at: 0.05, glide: 2.0, swell: 0.03, ..burst(500.0, 1.0, 0.14, 0.5) },
            ]),
            // A bubble rings at the pitch of its size, and rises as it nears the surface.
            Cue::Bubble => Self::new([SoundPart { glide: 7.0, swell: 0.006, ..struck(380.0 + 900.0 * loudness, 0.03, 0.5) }]),
            Cue::Press => Self::new([struck(659.26, 0.05, 0.3), struck(1318.5, 0.03, 0.12), burst(2500.0, 0.8, 0.006, 0.3)]),
            Cue::Move => Self::new([struck(880.0, 0.018, 0.16)]),
            Cue::Jump => Self::new([SoundPart { glide: 5.0, swell: 0.004, ..struck(247.0, 0.08, 0.4) }]),
            Cue::Click => Self::new([struck(900.0, 0.008, 0.3), struck(2200.0, 0.004, 0.5)]),
        }
    }

    pub fn new(parts: impl IntoIterator<Item = SoundPart>) -> Self {
        let mut recipe = Self::default();
        recipe.0.iter_mut().zip(parts).for_each(|(to, part)| *to = Some(part));
        recipe
    }
}

/// Modes of a struck object: each with its pitch (Hz), its decay (s) and its share.
fn knock(stuff: Stuff, loudness: f32) -> Recipe {
    let (modes, noise): (&[(f32, f32, f32)], SoundPart) = match stuff {
        Stuff::Asphalt => (&[(88.0, 0.05, 0.6), (147.0, 0.035, 0.3)], burst(300.0, 0.7, 0.025, 0.6)),
        // A free bar: 1 : 2.756 : 5.404 : 8.933.
        Stuff::Steel => {
            (&[(410.0, 0.3, 0.26), (1130.0, 0.2, 0.2), (2216.0, 0.11, 0.13), (3663.0, 0.06, 0.08)], burst(3500.0, 0.7, 0.008, 0.35))
        }
        Stuff::Ice => (&[(1480.0, 0.04, 0.3), (2630.0, 0.03, 0.22), (4390.0, 0.02, 0.14)], burst(5000.0, 0.8, 0.012, 0.35)),
        Stuff::Rubber => (&[(74.0, 0.07, 0.65)], burst(260.0, 0.7, 0.02, 0.3)),
        Stuff::Wood => (&[(236.0, 0.05, 0.4), (561.0, 0.035, 0.28), (934.0, 0.022, 0.18)], burst(1500.0, 0.7, 0.01, 0.4)),
        Stuff::Glass => (&[(2093.0, 0.4, 0.22), (4866.0, 0.25, 0.16), (7911.0, 0.12, 0.08)], burst(6000.0, 0.8, 0.006, 0.3)),
    };
    let bright = 0.25 + 0.75 * loudness;
    let struck =
        |(i, (pitch, fade, peak)): (usize, &(f32, f32, f32))| struck(*pitch, *fade, if i == 0 { *peak } else { peak * bright });
    Recipe::new(modes.iter().enumerate().map(struck).chain([SoundPart { peak: noise.peak * bright, ..noise }]))
}

fn bell(at: f32, pitch: f32, peak: f32) -> [SoundPart; 3] {
    let mode = |(ratio, fade, share)| SoundPart { at, ..struck(pitch * ratio, fade, peak * share) };
    [(1.0, 0.26, 1.0), (2.0, 0.16, 0.35), (5.4, 0.06, 0.12)].map(mode)
}

pub const fn struck(pitch: f32, fade: f32, peak: f32) -> SoundPart {
    SoundPart { at: 0.0, pitch, glide: 0.0, narrowness: None, swell: 0.0015, fade, peak }
}

pub const fn burst(pitch: f32, narrowness: f32, fade: f32, peak: f32) -> SoundPart {
    SoundPart { narrowness: Some(narrowness), ..struck(pitch, fade, peak) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cue_is_found_at_its_number() {
        for (number, cue) in Cue::ALL.into_iter().enumerate() {
            assert_eq!(cue.number(), number, "{cue:?}");
        }
    }

    #[test]
    fn every_material_has_a_sound_of_its_own_name() {
        for material in Material::FIRM {
            assert_eq!(format!("{:?}", Stuff::of(&material)), material.name);
        }
        assert_eq!(Stuff::of(&Material { name: "Moss", ..Material::ICE }), Stuff::Asphalt);
        assert_eq!(Stuff::of(&Material::TRAMPOLINE), Stuff::Rubber);
    }
}
