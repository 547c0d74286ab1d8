//! The window's keyboard. X11 and a browser tell each press with its place and what it types; elsewhere a key is what miniquad takes it for,
//! and its character comes by itself.

#[cfg(target_os = "linux")]
mod x11;

use crate::settings::{Key, Keys, layout, plain_keys};
use crate::ui::keyboard::{KeyDown, Keyboard};
use crate::ui::{input::Input, pace};
use macroquad::input::utils::{register_input_subscriber, repeat_all_miniquad_input};
use macroquad::input::{KeyCode, get_char_pressed};
use macroquad::miniquad::{EventHandler, KeyMods};
use std::time::Duration;
#[cfg(target_os = "linux")]
use std::time::Instant;

macro_rules! codes {
    ($($key:ident)*) => { &[$((KeyCode::$key, Key::$key)),*] };
}
const KEYS: &[(KeyCode, Key)] = plain_keys!(codes);
/// Those of which there are several.
const MORE_KEYS: [(KeyCode, Key); 8] = [
    (KeyCode::Enter, Key::Enter),
    (KeyCode::KpEnter, Key::Enter),
    (KeyCode::LeftShift, Key::Shift),
    (KeyCode::RightShift, Key::Shift),
    (KeyCode::LeftControl, Key::Control),
    (KeyCode::RightControl, Key::Control),
    (KeyCode::LeftAlt, Key::Alt),
    (KeyCode::RightAlt, Key::Alt),
];
/// Whether miniquad tells a character before the key that types it, and marks a press as repeated that was let go elsewhere.
const BEFORE: bool = cfg!(target_os = "linux");

/// How often a wait looks for news: nobody feels so much.
#[cfg(target_os = "linux")]
const SLICE: Duration = Duration::from_millis(8);

/// The keyboard, and whether the window has it, by what miniquad reports: on X11 that another window has it, elsewhere that it is hidden.
pub struct WindowKeys {
    subscriber: usize,
    events: KeyEvents,
    #[cfg(target_os = "linux")]
    x11: Option<x11::System>,
}

#[derive(Default)]
struct KeyEvents {
    keyboard: Keyboard,
    away: bool,
    /// X11 or the page hands in the keys.
    handed_in: bool,
    /// A character whose key follows.
    before: Option<char>,
}

impl WindowKeys {
    /// Once the window is there.
    pub fn new() -> Self {
        #[cfg(target_os = "linux")]
        let x11 = x11::System::new();
        #[cfg(target_os = "linux")]
        let handed_in = x11.is_some();
        #[cfg(not(target_os = "linux"))]
        let handed_in = cfg!(browser);
        #[cfg(windows)]
        for (_, place) in layout::printing() {
            windows::plain(place).into_iter().for_each(|sign| layout::note(place, sign));
        }
        Self {
            subscriber: register_input_subscriber(),
            events: KeyEvents { handed_in, ..KeyEvents::default() },
            #[cfg(target_os = "linux")]
            x11,
        }
    }

    /// Waits that long, or until something comes from the display; where no display tells, at most [`pace::EASY`].
    pub fn wait(&self, time: Duration) {
        #[cfg(target_os = "linux")]
        if let Some(x11) = &self.x11 {
            let until = Instant::now() + time;
            while !x11.has_news() {
                let left = until.saturating_duration_since(Instant::now());
                if left.is_zero() {
                    return;
                }
                super::host::pause(left.min(SLICE));
            }
            return;
        }
        super::host::pause(time.min(Duration::from_secs_f64(pace::EASY)));
    }

    /// The keys since the last frame, and whether another window has them.
    pub fn read(&mut self) -> Input {
        // macroquad's own list of what was typed would grow without end.
        while get_char_pressed().is_some() {}
        repeat_all_miniquad_input(&mut self.events, self.subscriber);
        #[cfg(target_os = "linux")]
        if let Some(x11) = &mut self.x11 {
            x11.drain(&mut self.events.keyboard);
        }
        #[cfg(browser)]
        crate::web::drain_keys(&mut self.events.keyboard);
        Input { away: self.events.away, ..self.events.keyboard.take() }
    }
}

/// The layout of a Windows keyboard. miniquad tells of a key its place, and Windows itself composes characters.
///
/// Unsafe code: one function of user32, which takes and gives numbers.
#[cfg(windows)]
#[allow(unsafe_code)]
mod windows {
    use crate::settings::{Key, layout};

    /// `MAPVK_VSC_TO_VK` and `MAPVK_VK_TO_CHAR`
    const CODE_TO_KEY: u32 = 1;
    const KEY_TO_CHARACTER: u32 = 2;
    /// A dead key has the highest bit as well.
    const CHARACTER: u32 = 0xffff;

    #[link(name = "user32")]
    unsafe extern "system" {
        fn MapVirtualKeyW(code: u32, kind: u32) -> u32;
    }

    /// What the key at that place types alone.
    pub fn plain(place: Key) -> Option<char> {
        let (code, _) = layout::printing().find(|(_, key)| *key == place)?;
        // SAFETY: it takes any numbers.
        let character = unsafe { MapVirtualKeyW(MapVirtualKeyW(u32::from(code), CODE_TO_KEY), KEY_TO_CHARACTER) };
        char::from_u32(character & CHARACTER).filter(|sign| *sign != '\0').and_then(|sign| sign.to_lowercase().next())
    }
}

fn modifiers(mods: KeyMods) -> Keys {
    let modifiers = [(mods.shift, Key::Shift), (mods.ctrl || mods.logo, Key::Control), (mods.alt, Key::Alt)];
    modifiers.into_iter().filter(|(held, _)| *held).map(|(_, key)| key).collect()
}

/// What Windows says that the key at that place types alone; elsewhere what it has typed.
fn plain(place: Key) -> Option<char> {
    #[cfg(windows)]
    let plain = windows::plain(place);
    #[cfg(not(windows))]
    let plain = None;
    plain.or_else(|| layout::sign_at(place))
}

impl EventHandler for KeyEvents {
    fn update(&mut self) {}

    fn draw(&mut self) {}

    fn char_event(&mut self, character: char, held: KeyMods, _repeat: bool) {
        if self.handed_in {
            return;
        }
        if BEFORE {
            self.before = Some(character);
        } else {
            self.keyboard.typed_by_last(character, modifiers(held));
            self.keyboard.typed(character, modifiers(held));
        }
    }

    fn key_down_event(&mut self, code: KeyCode, mods: KeyMods, repeat: bool) {
        if self.handed_in {
            return;
        }
        let place = KEYS.iter().chain(&MORE_KEYS).find(|(known, _)| *known == code).map(|(_, key)| *key);
        let (typed, repeat) = (self.before.take(), repeat && !BEFORE);
        let plain = place.and_then(plain);
        let key = KeyDown { id: code as u32, place, typed, silent: false, plain, repeat, held: modifiers(mods) };
        self.keyboard.down(key);
        if code == KeyCode::Unknown {
            // Which of them goes up is not told.
            self.keyboard.up(key.id);
        }
    }

    fn key_up_event(&mut self, code: KeyCode, _: KeyMods) {
        if !self.handed_in {
            self.keyboard.up(code as u32);
        }
    }

    fn window_minimized_event(&mut self) {
        self.away = true;
        if !self.handed_in {
            self.keyboard.leave();
        }
    }

    fn window_restored_event(&mut self) {
        self.away = false;
    }
}
