use super::Bindings;
use crate::words::Language;

/// Colours with a meaning.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Palette {
    /// Of the art direction.
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
    /// Of words and panels: 80 … 150.
    pub scale: u8,
    /// Of the screen at a hit: 0 … 100.
    pub shake: u8,
    /// At hits and deaths.
    pub flash: bool,
    /// The share that is drawn: 0 … 100.
    pub particles: u8,
    pub palette: Palette,
    pub timer: bool,
    /// The arrow at the ship.
    pub velocity: bool,
    pub assists: Assists,
}

impl Settings {
    /// The language that the screens speak.
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
