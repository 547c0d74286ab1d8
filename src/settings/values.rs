//! The values of all settings.

use super::keys::Bindings;

/// The colours that carry a meaning.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Palette {
    /// The colours of the art direction.
    #[default]
    Standard,
    /// Colours that stay apart in the three common kinds of colour blindness.
    Safe,
    /// The safe colours, on black, with white edges.
    HighContrast,
}

/// Help in flight. A run with help is marked, and does not enter the board.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Assists {
    /// How fast the game runs, % of real time: 50 … 100.
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
    /// Whether any of them helps.
    pub fn any(self) -> bool {
        self != Self::default()
    }
}

/// All that can be set. Levels and shares are whole percents.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Settings {
    /// The keys of the flight.
    pub keys: Bindings,
    /// All sound, 0 … 100.
    pub master: u8,
    /// Engine, knocks, wind, liquid, buttons: 0 … 100.
    pub effects: u8,
    /// 0 … 100.
    pub music: u8,
    /// Whether the window fills the screen.
    pub fullscreen: bool,
    /// How large words and panels are: 80 … 150.
    pub scale: u8,
    /// How far a hit shakes the screen: 0 … 100.
    pub shake: u8,
    /// Whether hits and deaths flash.
    pub flash: bool,
    /// How many of the particles are drawn: 0 … 100.
    pub particles: u8,
    /// The colours that carry a meaning.
    pub palette: Palette,
    /// Whether the time is shown in flight.
    pub timer: bool,
    /// Whether the ship carries an arrow of its velocity.
    pub velocity: bool,
    /// Help in flight.
    pub assists: Assists,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            keys: Bindings::default(),
            master: 80,
            effects: 80,
            music: 50,
            fullscreen: false,
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
