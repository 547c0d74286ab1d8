//! The one-shot sounds.

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

/// A one-shot sound.
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
    /// The number of cues.
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
