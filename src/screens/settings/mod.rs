//! The settings: a list of values at the left, the keys of the flight at the right. From the menu, and from the pause panel.

#[cfg(all(feature = "window", browser))]
pub mod page_data;

use crate::draw::layout::{Area, DETAILS, MARGIN, ROW_BUTTON, TEXT, Vec2};
use crate::screens::screen::{Effect, Request, Screen};
use crate::settings::{Action, FLYING, Item, Key, Keys, Settings};
use crate::{draw::Colour, draw::Style, ui::Ui, ui::WidgetKind, view::theme, view::widgets, words::tr};

/// A row of the values and one of the keys, with the gap below it.
const VALUES: Vec2 = Vec2::new(560.0, 32.0);
const KEYS: Vec2 = Vec2::new(560.0, 24.0);
const BETWEEN: f32 = 40.0;
/// From the canvas' top to the first row.
const TOP: f32 = 92.0;
const KEY_WIDTH: f32 = 150.0;
const PRESS: &str = "press a key";
/// Shows the keys that do not fly, too.
const ALL_KEYS: &str = "All keys";
const SLOTS: usize = 2;

/// The settings' screen. Each change holds at once and is kept at once.
#[derive(Debug)]
pub struct SettingsPanel {
    settings: Settings,
    all: bool,
    /// The action and the place for which the next key is taken.
    taking: Option<(Action, usize)>,
    /// Shift, Ctrl or Alt, which is taken where no other key follows before it goes up.
    modifier: Option<Key>,
    problems: Vec<String>,
}

impl SettingsPanel {
    /// The settings as they are, and what was wrong with their file.
    pub fn new(settings: Settings, problems: Vec<String>) -> Self {
        Self { settings, all: false, taking: None, modifier: None, problems }
    }

    fn show_values(&mut self, ui: &mut Ui<'_>, corner: Vec2) {
        for (i, item) in Item::ALL.into_iter().enumerate() {
            let area = Area::new(corner.x, corner.y + i as f32 * VALUES.y, VALUES.x, VALUES.y - 4.0);
            if let Some(up) = ui.choice(item.label(), area, &item.value(&self.settings), item.share(&self.settings)) {
                item.change(up, &mut self.settings);
            }
        }
    }

    fn show_keys(&mut self, ui: &mut Ui<'_>, corner: Vec2) {
        let mut pressed = None;
        let shown = if self.all { Action::ALL.len() } else { FLYING };
        let pitch = if self.all { KEYS.y } else { KEYS.y.max(1.3 * ui.frame().text_height(TEXT)) };
        let key_width = KEY_WIDTH.max(ui.canvas().width(tr(PRESS), Style::new(TEXT, theme::text())) + 8.0);
        for (row, action) in Action::ALL.into_iter().take(shown).enumerate() {
            // Large words stand closer.
            let apart = (pitch - ui.frame().text_height(TEXT)).clamp(1.0, 4.0);
            let area = Area::new(corner.x, corner.y + row as f32 * pitch, KEYS.x, pitch - apart);
            let label = Vec2::new(area.min.x, area.centre().y);
            ui.text(tr(action.label()), label, Style::new(TEXT, theme::quiet()).middle());
            for slot in 0..SLOTS {
                let x = area.max().x - (SLOTS - slot) as f32 * (key_width + 8.0) + 8.0;
                let area = Area { min: Vec2::new(x, area.min.y), size: Vec2::new(key_width, area.size.y) };
                let touch = ui.touch(&format!("{} {}", action.label(), slot + 1), area, WidgetKind::Button);
                widgets::button_box(ui.canvas(), area, touch.hover, touch.focus);
                let (words, colour) = self.words(action, slot);
                ui.text(&words, area.centre(), Style::new(TEXT, colour).middle().centred());
                let clears = touch.focus && (ui.key(Key::Delete) || ui.key(Key::Backspace));
                if clears && self.taking.is_none() {
                    self.put_key(action, slot, None);
                }
                pressed = pressed.or(touch.pressed.then_some((action, slot)));
            }
        }
        let more = Area::new(corner.x, corner.y + (FLYING as f32 + 0.5) * pitch, KEYS.x, pitch + 4.0);
        let style = Style::new(TEXT, theme::text()).centred();
        if !self.all && ui.small_button((ALL_KEYS, tr(ALL_KEYS)), more, style) {
            self.all = true;
            ui.focus(Some(&format!("{} 1", Action::ALL[FLYING].label())));
        }
        match self.taking {
            Some((action, slot)) => self.take_key(ui, action, slot),
            None => self.taking = pressed,
        }
    }

    fn words(&self, action: Action, slot: usize) -> (String, Colour) {
        let keys = &self.settings.keys;
        match keys.of(action)[slot] {
            _ if self.taking == Some((action, slot)) => (tr(PRESS).to_owned(), theme::accent()),
            Some(key) => {
                let twice = keys.conflict(action, key).is_some();
                (action.label_of(key), if twice { theme::bad() } else { theme::text() })
            }
            None => (String::new(), theme::quiet()),
        }
    }

    /// Takes the next key that goes down; Esc and the mouse take none.
    fn take_key(&mut self, ui: &mut Ui<'_>, action: Action, slot: usize) {
        ui.capture();
        let input = ui.input();
        let modifiers = [Key::Shift, Key::Control, Key::Alt];
        let others = modifiers.into_iter().fold(input.pressed, Keys::without);
        let let_go = self.modifier.filter(|key| !input.held.has(*key));
        // What is typed with a modifier goes before what the key types alone.
        let typed = input.typed.chars().next().and_then(Key::typing).filter(|key| !action.is_by_place() && others.has(*key));
        let key = typed.or_else(|| others.first(action.is_by_place())).or(let_go);
        if input.pressed(Key::Escape) || input.click {
            (self.taking, self.modifier) = (None, None);
        } else if key.is_some() {
            self.put_key(action, slot, key);
            (self.taking, self.modifier) = (None, None);
        } else {
            self.modifier = modifiers.into_iter().find(|key| input.pressed.has(*key)).or(self.modifier);
        }
    }

    fn put_key(&mut self, action: Action, slot: usize, key: Option<Key>) {
        let mut keys = self.settings.keys.of(action);
        // The same key twice would be one.
        keys.iter_mut().filter(|known| **known == key).for_each(|known| *known = None);
        keys[slot] = key;
        self.settings.keys.set(action, keys);
    }

    fn show_hints(&self, ui: &Ui<'_>, mut at: Vec2) {
        let large = ui.frame().text > 1.0;
        let pitch = (1.08 * ui.frame().text_height(DETAILS)).max(18.0);
        // Large words take the room below both lists, where the keys leave it.
        let widest = if large { VALUES.x + BETWEEN + KEYS.x } else { VALUES.x };
        let mut line = |text: &str, colour| {
            let style = Style::new(DETAILS, colour).middle();
            for words in widgets::lines(ui.canvas(), text, widest, style) {
                ui.text(&words, at, style);
                at.y += pitch;
            }
        };
        if !large || !self.all {
            line(tr("Tab goes to the other list, ← → change a value; Enter sets a key, Del clears it."), theme::quiet());
            line(tr("A gamepad flies too: stick turns, triggers thrust, Y restarts, Start pauses."), theme::quiet());
        }
        if self.settings.assists.any() {
            line(tr("A flight with assists is marked and does not enter the board."), theme::accent());
        }
        for (action, key, other) in self.conflicts() {
            let [one, two] = [action, other].map(|action| tr(action.label()));
            line(&tr!("{key} does two things: {one} and {two}.", key = action.label_of(key), one, two), theme::bad());
        }
        for problem in self.problems.iter().take(3) {
            line(problem, theme::bad());
        }
    }

    fn conflicts(&self) -> Vec<(Action, Key, Action)> {
        let keys = &self.settings.keys;
        let of = |action: Action| {
            let pair = move |key| Some((action, key, keys.conflict(action, key)?));
            keys.of(action).into_iter().flatten().filter_map(pair)
        };
        Action::ALL.into_iter().flat_map(of).filter(|(action, _, other)| (*action as u8) < (*other as u8)).collect()
    }
}

impl Screen for SettingsPanel {
    /// [`Effect::Set`] after a change, [`Request::Pop`] to leave.
    fn show(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        let (before, size) = (self.settings, ui.frame().size);
        let values = Vec2::new((size.x - VALUES.x - KEYS.x - BETWEEN) / 2.0, TOP);
        let keys = values + Vec2::new(VALUES.x + BETWEEN, 0.0);
        // Esc takes no key, and then leaves nothing.
        let leaves = self.taking.is_none() && ui.key(Key::Escape);
        ui.page("Settings", 56.0);
        self.show_values(ui, values);
        ui.group();
        self.show_keys(ui, keys);
        self.show_hints(ui, values + Vec2::new(0.0, Item::ALL.len() as f32 * VALUES.y + 12.0));
        // A press of the first one saves once more what could not be saved.
        let labels = if self.problems.is_empty() { &["Defaults", "Back"][..] } else { &["Try again", "Defaults", "Back"] };
        let pressed = ui.row(size.y - ROW_BUTTON.y - MARGIN, labels);
        if leaves || pressed == Some("Back") {
            return Some(Request::Pop);
        }
        if pressed == Some("Defaults") {
            self.settings = Settings::default();
        }
        (self.settings != before || pressed == Some("Try again")).then_some(Request::Do(Effect::Set(self.settings)))
    }

    fn tell_of_settings(&mut self, settings: &Settings, problems: &[String]) {
        self.settings = *settings;
        self.problems = problems.to_vec();
    }
}
