//! One setting as a list shows it, the file names it and a key changes it.

use super::{Palette, Settings};

/// One setting that is not a key.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Item {
    /// The volume of everything.
    Master,
    /// The volume of what happens.
    Effects,
    /// The volume of the music.
    Music,
    /// Whether the window fills the screen.
    Fullscreen,
    /// The size of words and panels.
    Scale,
    /// How far a hit shakes the screen.
    Shake,
    /// Whether hits and deaths flash.
    Flash,
    /// How many of the particles are drawn.
    Particles,
    /// Which colours carry the meanings.
    Colours,
    /// Whether the time is shown.
    Timer,
    /// Whether the ship carries an arrow of its velocity.
    Velocity,
    /// How fast the game runs.
    Speed,
    /// Whether the engine burns no fuel.
    LastingFuel,
}

/// What a setting can be.
enum Range {
    /// Whole percents, in steps.
    Percent { least: u8, most: u8, step: u8 },
    /// One of these words.
    Words(&'static [&'static str]),
}

/// Off, and on.
const SWITCH: Range = Range::Words(&["off", "on"]);
const VOLUME: Range = Range::Percent { least: 0, most: 100, step: 10 };
const COLOURS: Range = Range::Words(&["standard", "safe", "contrast"]);

impl Item {
    /// All of them, in the order in which they are shown.
    pub const ALL: [Self; 13] = [
        Self::Master,
        Self::Effects,
        Self::Music,
        Self::Fullscreen,
        Self::Scale,
        Self::Colours,
        Self::Shake,
        Self::Flash,
        Self::Particles,
        Self::Timer,
        Self::Velocity,
        Self::Speed,
        Self::LastingFuel,
    ];

    /// Its row in the settings' file.
    pub const fn setting(self) -> &'static str {
        match self {
            Self::Master => "volume",
            Self::Effects => "volume_effects",
            Self::Music => "volume_music",
            Self::Fullscreen => "fullscreen",
            Self::Scale => "interface_scale",
            Self::Colours => "colours",
            Self::Shake => "shake",
            Self::Flash => "flash",
            Self::Particles => "particles",
            Self::Timer => "show_timer",
            Self::Velocity => "show_velocity",
            Self::Speed => "assist_speed",
            Self::LastingFuel => "assist_fuel",
        }
    }

    /// Its name as it is shown.
    pub const fn label(self) -> &'static str {
        match self {
            Self::Master => "Volume",
            Self::Effects => "Effects",
            Self::Music => "Music",
            Self::Fullscreen => "Fullscreen (F11)",
            Self::Scale => "Interface scale",
            Self::Colours => "Colours",
            Self::Shake => "Screen shake",
            Self::Flash => "Flashes",
            Self::Particles => "Particles",
            Self::Timer => "Show timer",
            Self::Velocity => "Velocity arrow",
            Self::Speed => "Assist: game speed",
            Self::LastingFuel => "Assist: lasting fuel",
        }
    }

    /// Whether it belongs to the player rather than to the machine: how he plays, not what the room has for screen and speakers.
    pub const fn is_of_play(self) -> bool {
        matches!(self, Self::Timer | Self::Velocity | Self::Speed | Self::LastingFuel)
    }

    /// Its value as it is shown.
    pub fn value(self, settings: &Settings) -> String {
        match self.range() {
            Range::Percent { .. } => format!("{} %", self.get(settings)),
            Range::Words(words) => words.get(usize::from(self.get(settings))).copied().unwrap_or_default().to_owned(),
        }
    }

    /// Its value as the file holds it.
    pub fn written(self, settings: &Settings) -> String {
        self.value(settings).trim_end_matches(" %").to_owned()
    }

    /// Takes a value as the file holds it.
    ///
    /// # Errors
    /// What is expected there.
    pub fn read(self, text: &str, settings: &mut Settings) -> Result<(), String> {
        let value = match self.range() {
            Range::Percent { least, most, .. } => {
                let digits = text.trim_end_matches('%').trim_end();
                let number = digits.parse().ok().filter(|number| (least..=most).contains(number));
                number.ok_or_else(|| format!("a whole number of percents from {least} to {most}"))?
            }
            Range::Words(words) => {
                let place = words.iter().position(|word| word.eq_ignore_ascii_case(text));
                place.ok_or_else(|| format!("one of {}", words.join(", ")))? as u8
            }
        };
        self.set(value, settings);
        Ok(())
    }

    /// A step up or down; words go round, percents stop at their ends.
    pub fn change(self, up: bool, settings: &mut Settings) {
        let now = self.get(settings);
        let next = match self.range() {
            Range::Percent { least, most, step } => {
                if up {
                    (now + step).min(most)
                } else {
                    now.saturating_sub(step).max(least)
                }
            }
            Range::Words(words) => {
                let count = words.len() as u8;
                (now + if up { 1 } else { count - 1 }) % count
            }
        };
        self.set(next, settings);
    }

    /// How far between its least and its most it stands, 0 … 1; `None` for words.
    pub fn share(self, settings: &Settings) -> Option<f32> {
        match self.range() {
            Range::Percent { least, most, .. } => Some(f32::from(self.get(settings) - least) / f32::from(most - least)),
            Range::Words(_) => None,
        }
    }

    const fn range(self) -> Range {
        match self {
            Self::Master | Self::Effects | Self::Music => VOLUME,
            Self::Scale => Range::Percent { least: 80, most: 150, step: 10 },
            Self::Shake | Self::Particles => Range::Percent { least: 0, most: 100, step: 50 },
            Self::Speed => Range::Percent { least: 50, most: 100, step: 10 },
            Self::Colours => COLOURS,
            Self::Fullscreen | Self::Flash | Self::Timer | Self::Velocity | Self::LastingFuel => SWITCH,
        }
    }

    fn get(self, settings: &Settings) -> u8 {
        match self {
            Self::Master => settings.master,
            Self::Effects => settings.effects,
            Self::Music => settings.music,
            Self::Fullscreen => settings.fullscreen.into(),
            Self::Scale => settings.scale,
            Self::Shake => settings.shake,
            Self::Flash => settings.flash.into(),
            Self::Particles => settings.particles,
            Self::Colours => settings.palette as u8,
            Self::Timer => settings.timer.into(),
            Self::Velocity => settings.velocity.into(),
            Self::Speed => settings.assists.speed,
            Self::LastingFuel => settings.assists.lasting_fuel.into(),
        }
    }

    fn set(self, value: u8, settings: &mut Settings) {
        let on = value != 0;
        match self {
            Self::Master => settings.master = value,
            Self::Effects => settings.effects = value,
            Self::Music => settings.music = value,
            Self::Fullscreen => settings.fullscreen = on,
            Self::Scale => settings.scale = value,
            Self::Shake => settings.shake = value,
            Self::Flash => settings.flash = on,
            Self::Particles => settings.particles = value,
            Self::Colours => {
                settings.palette = [Palette::Standard, Palette::Safe, Palette::HighContrast][usize::from(value.min(2))];
            }
            Self::Timer => settings.timer = on,
            Self::Velocity => settings.velocity = on,
            Self::Speed => settings.assists.speed = value,
            Self::LastingFuel => settings.assists.lasting_fuel = on,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_setting_goes_up_and_down_and_through_its_text() {
        for item in Item::ALL {
            let mut settings = Settings::default();
            for _ in 0..20 {
                item.change(false, &mut settings);
                let mut copy = Settings::default();
                item.read(&item.written(&settings), &mut copy).unwrap();
                assert_eq!(item.value(&copy), item.value(&settings), "{item:?}");
            }
            if let Some(share) = item.share(&settings) {
                assert_eq!(share, 0.0, "{item:?} is at its least");
                (0..20).for_each(|_| item.change(true, &mut settings));
                assert_eq!(item.share(&settings), Some(1.0), "{item:?} is at its most");
            }
        }
    }

    #[test]
    fn what_is_no_value_is_refused_with_what_is_one() {
        let mut settings = Settings::default();
        for (item, text, expected) in [
            (Item::Music, "101", "a whole number of percents from 0 to 100"),
            (Item::Scale, "79", "a whole number of percents from 80 to 150"),
            (Item::Speed, "NaN", "a whole number of percents from 50 to 100"),
            (Item::Flash, "yes", "one of off, on"),
            (Item::Colours, "", "one of standard, safe, contrast"),
        ] {
            assert_eq!(item.read(text, &mut settings), Err(expected.into()));
        }
        assert_eq!(settings, Settings::default());
    }
}
