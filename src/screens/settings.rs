//! The settings: a list of values at the left, the keys of the flight at the right. From the menu, and from the pause panel.

use super::{Buttons, Input, Request};
use crate::settings::{Action, Item, Key, Settings};
use crate::view::layout::{Area, Frame, ROW_BUTTON, Vec2};

/// What the list of values and that of the keys take up, and a row of either.
const VALUES: Vec2 = Vec2::new(560.0, 34.0);
const KEYS: Vec2 = Vec2::new(560.0, 29.0);
/// Between the two lists.
const BETWEEN: f32 = 40.0;
/// From the canvas' top to the first row.
const TOP: f32 = 92.0;
/// How wide a value and a key are.
const VALUE_WIDTH: f32 = 200.0;
const KEY_WIDTH: f32 = 150.0;
/// Keys a control.
const SLOTS: usize = 2;
/// The first of the keys among the buttons, and the first of those below.
const FIRST_KEY: usize = Item::ALL.len();
const FIRST_BELOW: usize = FIRST_KEY + SLOTS * Action::ALL.len();
/// The words on the buttons below.
pub const LABELS: [&str; 2] = ["Defaults", "Back"];

/// The settings' screen. Whatever is changed holds at once and is kept at once.
#[derive(Debug)]
pub struct SettingsPanel {
    settings: Settings,
    buttons: Buttons,
    /// The action and the place for which the next key is taken.
    taking: Option<(Action, usize)>,
    /// What is wrong with the file of settings, a line each.
    problems: Vec<String>,
}

impl SettingsPanel {
    /// The settings as they are, and what was wrong with their file.
    pub fn new(settings: Settings, problems: Vec<String>) -> Self {
        Self { settings, buttons: Buttons::default(), taking: None, problems }
    }

    /// One frame: [`Request::Set`] after a change, [`Request::Menu`] to leave.
    pub fn update(&mut self, input: &Input) -> Option<Request> {
        self.buttons.place(places(&input.frame));
        let before = self.settings;
        if let Some((action, slot)) = self.taking {
            self.take_key(input, action, slot);
        } else {
            if input.pressed(Key::Escape) {
                return Some(Request::Menu);
            }
            if let Some(request) = self.follow(input) {
                return Some(request);
            }
        }
        (self.settings != before).then_some(Request::Set(self.settings))
    }

    /// Its buttons: the values, the keys row by row, Defaults, Back.
    pub fn buttons(&self) -> &Buttons {
        &self.buttons
    }

    /// The settings as they stand.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// What is wrong with the file.
    pub fn problems(&self) -> &[String] {
        &self.problems
    }

    /// For which action, and for which of its places, the next key is taken.
    pub fn taking(&self) -> Option<(Action, usize)> {
        self.taking
    }

    /// Takes over what holds now, and what is wrong with the file.
    pub fn tell(&mut self, settings: Settings, problems: Vec<String>) {
        self.settings = settings;
        self.problems = problems;
    }

    /// Follows pointer and keys while no key is taken.
    fn follow(&mut self, input: &Input) -> Option<Request> {
        let focus = self.buttons.focus();
        let change = input.pressed(Key::Right) || input.pressed(Key::Left);
        if let Some(item) = Item::ALL.get(focus).filter(|_| change) {
            item.change(input.pressed(Key::Right), &mut self.settings);
            return None;
        }
        if let Some((action, slot)) = key_place(focus)
            && (input.pressed(Key::Delete) || input.pressed(Key::Backspace))
        {
            self.put_key(action, slot, None);
            return None;
        }
        if input.pressed(Key::Tab) {
            let other = if focus < FIRST_KEY { FIRST_KEY } else { 0 };
            self.buttons.focus_on(other);
            return None;
        }
        let pressed = self.buttons.update(input)?;
        if let Some(item) = Item::ALL.get(pressed) {
            let area = value_area(self.buttons.areas()[pressed]);
            item.change(!input.click || input.pointer.x >= area.centre().x, &mut self.settings);
        } else if let Some(place) = key_place(pressed) {
            self.taking = Some(place);
        } else if pressed == FIRST_BELOW {
            self.settings = Settings::default();
        } else {
            return Some(Request::Menu);
        }
        None
    }

    /// Takes the next key that goes down; Esc and the mouse take none.
    fn take_key(&mut self, input: &Input, action: Action, slot: usize) {
        if input.pressed(Key::Escape) || input.click {
            self.taking = None;
        } else if let Some(key) = Key::ALL.iter().copied().find(|key| input.pressed.has(*key) && !key.is_pad()) {
            self.put_key(action, slot, Some(key));
            self.taking = None;
        }
    }

    fn put_key(&mut self, action: Action, slot: usize, key: Option<Key>) {
        let mut keys = self.settings.keys.of(action);
        // The same key twice would be one.
        keys.iter_mut().filter(|known| **known == key).for_each(|known| *known = None);
        keys[slot] = key;
        self.settings.keys.set(action, keys);
    }
}

/// The action and the place that a button stands for.
fn key_place(button: usize) -> Option<(Action, usize)> {
    let place = button.checked_sub(FIRST_KEY)?;
    Some((*Action::ALL.get(place / SLOTS)?, place % SLOTS))
}

/// Where a row's value stands.
fn value_area(row: Area) -> Area {
    Area::new(row.max().x - VALUE_WIDTH, row.min.y, VALUE_WIDTH, row.size.y)
}

/// The corners of the two lists.
fn corners(frame: &Frame) -> (Vec2, Vec2) {
    let left = (frame.size.x - VALUES.x - KEYS.x - BETWEEN) / 2.0;
    (Vec2::new(left, TOP), Vec2::new(left + VALUES.x + BETWEEN, TOP))
}

fn places(frame: &Frame) -> Vec<Area> {
    let (values, keys) = corners(frame);
    let rows = (0..Item::ALL.len()).map(|i| Area::new(values.x, values.y + i as f32 * VALUES.y, VALUES.x, VALUES.y - 4.0));
    let key = |i: usize| {
        let (row, slot) = (i / SLOTS, i % SLOTS);
        let x = keys.x + KEYS.x - (SLOTS - slot) as f32 * (KEY_WIDTH + 8.0) + 8.0;
        Area::new(x, keys.y + row as f32 * KEYS.y, KEY_WIDTH, KEYS.y - 4.0)
    };
    let below = frame.row(LABELS.len(), frame.size.y - ROW_BUTTON.y - 32.0);
    rows.chain((0..SLOTS * Action::ALL.len()).map(key)).chain(below).collect()
}

mod drawing {
    use super::{FIRST_BELOW, FIRST_KEY, LABELS, SettingsPanel, corners, key_place, value_area};
    use crate::draw::{Canvas, Style};
    use crate::settings::{Action, Item, Key};
    use crate::view::layout::{Area, DETAILS, TEXT, Vec2};
    use crate::view::{theme, widgets};

    impl SettingsPanel {
        /// Draws the settings.
        pub fn draw(&self, canvas: &Canvas) {
            widgets::graph_paper(canvas);
            widgets::heading(canvas, "Settings", 56.0);
            for (i, area) in self.buttons.areas().iter().enumerate() {
                match (Item::ALL.get(i), key_place(i)) {
                    (Some(item), _) => self.draw_value(canvas, i, *item, *area),
                    (None, Some((action, slot))) => self.draw_key(canvas, i, (action, slot), *area),
                    (None, None) => {
                        let (hover, focus) = (self.buttons.hover() == Some(i), self.buttons.focus() == i);
                        widgets::button(canvas, *area, LABELS[i - FIRST_BELOW], hover, focus);
                    }
                }
            }
            let (values, keys) = corners(canvas.frame());
            let quiet = Style::new(TEXT, theme::quiet()).middle();
            for (row, action) in Action::ALL.iter().enumerate() {
                let y = self.buttons.areas().get(FIRST_KEY + 2 * row).map_or(0.0, |area| area.centre().y);
                canvas.text(action.label(), Vec2::new(keys.x, y), quiet);
            }
            self.draw_hints(canvas, values);
        }

        fn draw_value(&self, canvas: &Canvas, i: usize, item: Item, row: Area) {
            let (hover, focus) = (self.buttons.hover() == Some(i), self.buttons.focus() == i);
            widgets::button_box(canvas, row, hover, focus);
            let words = Style::new(TEXT, theme::text()).middle();
            canvas.text(item.label(), Vec2::new(row.min.x + 16.0, row.centre().y), words);
            let value = value_area(row);
            let mark = Style::new(TEXT, theme::accent()).middle().centred();
            canvas.text("‹", Vec2::new(value.min.x + 16.0, value.centre().y), mark);
            canvas.text("›", Vec2::new(value.max().x - 16.0, value.centre().y), mark);
            if let Some(share) = item.share(&self.settings) {
                let track = Area::new(value.min.x + 32.0, value.max().y - 6.0, value.size.x - 64.0, 3.0);
                canvas.rounded(track, 1.5, theme::panel_edge());
                canvas.rounded(Area { size: Vec2::new(track.size.x * share, 3.0), ..track }, 1.5, theme::accent());
            }
            canvas.text(&item.value(&self.settings), value.centre(), words.mono().centred());
        }

        fn draw_key(&self, canvas: &Canvas, i: usize, (action, slot): (Action, usize), area: Area) {
            let (hover, focus) = (self.buttons.hover() == Some(i), self.buttons.focus() == i);
            widgets::button_box(canvas, area, hover, focus);
            let keys = &self.settings.keys;
            let (text, colour) = match keys.of(action)[slot] {
                _ if self.taking == Some((action, slot)) => ("press a key".to_owned(), theme::accent()),
                Some(key) if keys.conflict(action, key).is_some() => (key.label(), theme::bad()),
                Some(key) => (key.label(), theme::text()),
                None => ("–".to_owned(), theme::quiet()),
            };
            canvas.text(&text, area.centre(), Style::new(TEXT, colour).middle().centred());
        }

        /// What the keys do here, and what is wrong.
        fn draw_hints(&self, canvas: &Canvas, corner: Vec2) {
            let mut y = self.buttons.areas().get(FIRST_KEY - 1).map_or(0.0, |area| area.max().y + 16.0);
            let mut line = |text: &str, colour| {
                canvas.text(text, Vec2::new(corner.x, y), Style::new(DETAILS, colour).middle());
                y += 20.0;
            };
            line("Tab goes to the other list, ← → change a value; Enter sets a key, Del clears it.", theme::quiet());
            line("A gamepad flies too: stick turns, triggers thrust, Y restarts, Start pauses.", theme::quiet());
            if self.settings.assists.any() {
                line("A flight with assists is marked and does not enter the board.", theme::accent());
            }
            for (action, key, other) in self.conflicts() {
                let both = format!("{} does two things: {} and {}.", key.label(), action.label(), other.label());
                line(&both, theme::bad());
            }
            for problem in self.problems.iter().take(3) {
                line(problem, theme::bad());
            }
        }

        /// Each key that does two things, once.
        fn conflicts(&self) -> Vec<(Action, Key, Action)> {
            let keys = &self.settings.keys;
            let of = |action: Action| {
                let pair = move |key| Some((action, key, keys.conflict(action, key)?));
                keys.of(action).into_iter().flatten().filter_map(pair)
            };
            Action::ALL.into_iter().flat_map(of).filter(|(action, _, other)| (*action as u8) < (*other as u8)).collect()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn press(panel: &mut SettingsPanel, key: Key) -> Option<Settings> {
        let input = Input { pressed: [key].into_iter().collect(), pointer: Vec2::splat(-1.0), ..Input::default() };
        match panel.update(&input) {
            Some(Request::Set(settings)) => Some(settings),
            _ => None,
        }
    }

    #[test]
    fn arrows_change_values_and_enter_takes_a_key() {
        let mut panel = SettingsPanel::new(Settings::default(), vec![]);
        assert_eq!(press(&mut panel, Key::Left).map(|settings| settings.master), Some(70));
        assert_eq!(press(&mut panel, Key::Right).map(|settings| settings.master), Some(80));
        assert_eq!(press(&mut panel, Key::Tab), None);
        press(&mut panel, Key::Enter);
        assert_eq!(panel.taking(), Some((Action::Thrust, 0)));
        let keys = |settings: Option<Settings>| settings.map(|settings| settings.keys.of(Action::Thrust));
        assert_eq!(keys(press(&mut panel, Key::Tab)), Some([Some(Key::Tab), Some(Key::W)]), "any key, Tab too");
        assert_eq!(keys(press(&mut panel, Key::Delete)), Some([None, Some(Key::W)]));
        press(&mut panel, Key::Enter);
        assert_eq!(keys(press(&mut panel, Key::W)), Some([Some(Key::W), None]), "a key stands once");
        press(&mut panel, Key::Enter);
        assert_eq!(press(&mut panel, Key::Escape), None);
        assert_eq!(panel.taking(), None);
    }

    #[test]
    fn nothing_overlaps_in_any_window() {
        for window in [(900.0, 500.0), (1280.0, 720.0), (1920.0, 1080.0), (600.0, 1000.0)] {
            let frame = Frame::of_window(window.into());
            let areas = places(&frame);
            for (i, a) in areas.iter().enumerate() {
                assert!(a.min.min_element() >= 0.0 && a.max().cmple(frame.size).all(), "{a:?}");
                let apart = |b: &Area| a.max().cmple(b.min).any() || b.max().cmple(a.min).any();
                assert!(areas[i + 1..].iter().all(apart), "{window:?}: {a:?}");
            }
        }
    }
}
