//! The sounds that are played once.

use crate::physics::Material;

/// What a knock sounds like: the six materials that a level can name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stuff {
    /// A dull thud.
    Asphalt,
    /// It rings.
    Steel,
    /// A hard, high tick.
    Ice,
    /// It hardly sounds.
    Rubber,
    /// A hollow knock.
    Wood,
    /// High and long.
    Glass,
}

impl Stuff {
    /// All of them, in the order of [`Material::ALL`].
    pub const ALL: [Self; 6] = [Self::Asphalt, Self::Steel, Self::Ice, Self::Rubber, Self::Wood, Self::Glass];

    /// What something of that material sounds like: as asphalt where the name is none of ours.
    pub fn of(material: &Material) -> Self {
        let found = Material::ALL.iter().position(|known| known.name == material.name);
        found.map_or(Self::Asphalt, |place| Self::ALL[place])
    }
}

/// A sound that is played once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cue {
    /// Something was hit.
    Knock(Stuff),
    /// The ship hit something so hard that it costs points.
    Crash,
    /// An objective is met.
    Met,
    /// An objective is no longer met.
    Lost,
    /// The level is complete.
    Success,
    /// The ship is lost.
    Death,
    /// The ship dives into a liquid or leaves it.
    Splash,
    /// A bubble rises.
    Bubble,
    /// A button is pressed.
    Press,
    /// The keyboard or the pointer goes to another button.
    Move,
    /// A collision of the blocks that count π.
    Click,
    /// A jump, in the classics.
    Jump,
}

impl Cue {
    /// How many there are.
    pub const COUNT: usize = 17;
    /// All of them; a cue's number is its place here.
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

    /// Its place in [`Cue::ALL`].
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
        for material in Material::ALL {
            assert_eq!(format!("{:?}", Stuff::of(&material)), material.name);
        }
        assert_eq!(Stuff::of(&Material { name: "Moss", ..Material::ICE }), Stuff::Asphalt);
    }
}
