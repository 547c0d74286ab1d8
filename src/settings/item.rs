//! One setting: its row in the list and in the file, and its keys.

use super::Bindings;
use crate::files::whole;
use crate::words::{Language, tr};

#[derive(Clone, Copy)]
enum Values {
    Percent { least: u8, most: u8, step: u8 },
    Words(&'static [&'static str]),
    Languages,
}

const VOLUME: Values = Values::Percent { least: 0, most: 100, step: 10 };
const HALVES: Values = Values::Percent { least: 0, most: 100, step: 50 };
const SCALE: Values = Values::Percent { least: 80, most: 190, step: 10 };
const SPEED: Values = Values::Percent { least: 50, most: 100, step: 10 };
const SWITCH: Values = Values::Words(&["off", "on"]);
const COLOURS: Values = Values::Words(&["standard", "safe", "contrast", "projector"]);
/// Empty in the file: the system's.
const LANGUAGES: Values = Values::Languages;
const PALETTES: [Palette; 4] = [Palette::Standard, Palette::Safe, Palette::HighContrast, Palette::Projector];

enum SettingField<'a> {
    Number(&'a mut u8),
    Switch(&'a mut bool),
    Colours(&'a mut Palette),
    Language(&'a mut Option<Language>),
}

/// The list of settings: row in the file, label, sentence, values, whether it is of the manner of play, and field of [`Settings`].
macro_rules! items {
    ($($name:ident $setting:literal $label:literal $about:literal $values:ident $of_play:literal $kind:ident $($field:ident).+;)*) => {
        /// Not a key.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Item {
            $(#[doc = $about] $name,)*
        }

        impl Item {
            /// In the order of the list.
            pub const ALL: [Self; [$($setting),*].len()] = [$(Self::$name),*];

            /// The name in the settings' file.
            pub const fn setting(self) -> &'static str {
                match self { $(Self::$name => $setting,)* }
            }

            pub const fn label(self) -> &'static str {
                match self { $(Self::$name => $label,)* }
            }

            const fn values(self) -> Values {
                match self { $(Self::$name => $values,)* }
            }

            /// Of the manner of play, which belongs to the player; screen and speakers belong to the room.
            pub const fn is_of_play(self) -> bool {
                match self { $(Self::$name => $of_play,)* }
            }

            const fn field(self, settings: &mut Settings) -> SettingField<'_> {
                match self { $(Self::$name => SettingField::$kind(&mut settings.$($field).+),)* }
            }
        }
    };
}

items! {
    Master "volume" "Volume" "The volume of everything." VOLUME false Number master;
    Effects "volume_effects" "Effects" "The volume of engine, knocks, wind, liquid and buttons." VOLUME false Number effects;
    Music "volume_music" "Music" "The volume of the music." VOLUME false Number music;
    Fullscreen "fullscreen" "Fullscreen (F11)" "Whether the window fills the screen." SWITCH false Switch fullscreen;
    Language "language" "Language" "The language of the screens." LANGUAGES false Language language;
    Scale "interface_scale" "Interface scale" "The size of words and panels." SCALE false Number scale;
    Colours "colours" "Colours" "The colours that carry a meaning." COLOURS false Colours palette;
    Shake "shake" "Screen shake" "How far a hit shakes the screen." HALVES false Number shake;
    Flash "flash" "Flashes" "Whether hits and deaths flash." SWITCH false Switch flash;
    Particles "particles" "Particles" "The share of the particles that is drawn." HALVES false Number particles;
    Timer "show_timer" "Show timer" "Whether the time is shown." SWITCH true Switch timer;
    Velocity "show_velocity" "Velocity arrow" "Whether the ship carries an arrow of its velocity." SWITCH true Switch velocity;
    Speed "assist_speed" "Assist: game speed" "The game's share of real time." SPEED true Number assists.speed;
    LastingFuel "assist_fuel" "Assist: lasting fuel" "Whether the engine burns no fuel." SWITCH true Switch assists.lasting_fuel;
}

impl Item {
    pub fn value(self, settings: &Settings) -> String {
        match self.values() {
            Values::Percent { .. } => format!("{} %", self.get(settings)),
            Values::Words(_) => tr(&self.written(settings)).to_owned(),
            Values::Languages => settings.spoken().name().to_owned(),
        }
    }

    pub fn written(self, settings: &Settings) -> String {
        let place = self.get(settings);
        match self.values() {
            Values::Percent { .. } => place.to_string(),
            Values::Words(words) => words.get(usize::from(place)).copied().unwrap_or_default().to_owned(),
            Values::Languages => settings.language.map_or("", Language::code).to_owned(),
        }
    }

    /// Takes a value of the file. The error is the expected values.
    pub fn read(self, text: &str, settings: &mut Settings) -> Result<(), String> {
        let value = match self.values() {
            Values::Percent { least, most, .. } => {
                let digits = text.trim_end_matches('%').trim_end().replace(',', ".");
                let number = whole(&digits).parse().ok().filter(|number| (least..=most).contains(number));
                number.ok_or_else(|| tr!("a whole number of percents from {least} to {most}", least, most))?
            }
            Values::Words(words) => {
                let place = words.iter().position(|word| word.eq_ignore_ascii_case(text));
                place.ok_or_else(|| tr!("one of {list}", list = words.join(", ")))? as u8
            }
            Values::Languages if text.is_empty() => {
                settings.language = None;
                return Ok(());
            }
            Values::Languages => {
                let place = Language::ALL.iter().position(|language| language.code().eq_ignore_ascii_case(text));
                place.ok_or_else(|| tr!("one of {list}, or nothing", list = Language::ALL.map(Language::code).join(", ")))? as u8
            }
        };
        self.set(value, settings);
        Ok(())
    }

    /// A step up or down: words go round, percents stop at their ends.
    pub fn change(self, up: bool, settings: &mut Settings) {
        let now = self.get(settings);
        let next = match self.values() {
            Values::Percent { most, step, .. } if up => (now + step).min(most),
            Values::Percent { least, step, .. } => now.saturating_sub(step).max(least),
            Values::Words(_) | Values::Languages => {
                let count = if let Values::Words(words) = self.values() { words.len() } else { Language::ALL.len() } as u8;
                (now + if up { 1 } else { count - 1 }) % count
            }
        };
        self.set(next, settings);
    }

    /// The place between least and most, 0 … 1; `None` for words.
    pub fn share(self, settings: &Settings) -> Option<f32> {
        match self.values() {
            Values::Percent { least, most, .. } => Some(f32::from(self.get(settings) - least) / f32::from(most - least)),
            Values::Words(_) | Values::Languages => None,
        }
    }

    fn get(self, settings: &Settings) -> u8 {
        match self.field(&mut { *settings }) {
            SettingField::Number(number) => *number,
            SettingField::Switch(on) => u8::from(*on),
            SettingField::Colours(palette) => *palette as u8,
            SettingField::Language(language) => language.unwrap_or_else(Language::of_system) as u8,
        }
    }

    fn set(self, value: u8, settings: &mut Settings) {
        match self.field(settings) {
            SettingField::Number(number) => *number = value,
            SettingField::Switch(on) => *on = value != 0,
            SettingField::Colours(palette) => *palette = PALETTES[usize::from(value).min(PALETTES.len() - 1)],
            SettingField::Language(language) => *language = Language::ALL.get(usize::from(value)).copied(),
        }
    }
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Palette {
    #[default]
    Standard,
    /// Distinct in the three common kinds of colour blindness.
    Safe,
    /// The colours of `Safe`, on black, with white edges.
    HighContrast,
    /// Dark on light, for a projector in a bright room.
    Projector,
}

/// Help in flight. A run with help is marked, and does not enter the board.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Assists {
    /// % of real time: 50 … 100.
    pub speed: u8,
    /// The engine burns, and the fuel stays.
    pub lasting_fuel: bool,
}

impl Default for Assists {
    fn default() -> Self {
        Self { speed: 100, lasting_fuel: false }
    }
}

impl Assists {
    pub fn any(self) -> bool {
        self != Self::default()
    }
}

/// Levels and shares are whole percents.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Settings {
    pub keys: Bindings,
    /// All sound, 0 … 100.
    pub master: u8,
    /// Engine, knocks, wind, liquid, buttons: 0 … 100.
    pub effects: u8,
    /// 0 … 100.
    pub music: u8,
    pub fullscreen: bool,
    /// `None`: the system's.
    pub language: Option<Language>,
    /// Of words and panels: 80 … 190, which makes all text of a flight 24 pixels high or higher at 1280 × 720.
    pub scale: u8,
    /// Of the screen at a hit: 0 … 100.
    pub shake: u8,
    pub flash: bool,
    /// The share that is drawn: 0 … 100.
    pub particles: u8,
    pub palette: Palette,
    pub timer: bool,
    pub velocity: bool,
    pub assists: Assists,
}

impl Settings {
    pub fn spoken(&self) -> Language {
        self.language.unwrap_or_else(Language::of_system)
    }
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            keys: Bindings::default(),
            master: 80,
            effects: 80,
            music: 50,
            fullscreen: false,
            language: None,
            scale: 100,
            shake: 100,
            flash: true,
            particles: 100,
            palette: Palette::default(),
            timer: true,
            velocity: true,
            assists: Assists::default(),
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
            (Item::Scale, "79", "a whole number of percents from 80 to 190"),
            (Item::Speed, "NaN", "a whole number of percents from 50 to 100"),
            (Item::Flash, "yes", "one of off, on"),
            (Item::Colours, "", "one of standard, safe, contrast, projector"),
            (Item::Language, "nl", "one of en, de, fr, or nothing"),
        ] {
            assert_eq!(item.read(text, &mut settings), Err(expected.into()));
        }
        assert_eq!(settings, Settings::default());
    }
}
