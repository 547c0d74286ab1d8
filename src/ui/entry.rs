//! A number or a name that a click opens as a line of text. Enter takes it, and so does a click elsewhere; Esc gives it up.

use super::text_field::TextField;
use super::{Touch, Ui, WidgetKind};
use crate::draw::Style;
use crate::draw::layout::{Area, DETAILS, GRID, Vec2};
use crate::settings::Key;
use crate::view::{theme, widgets as paint};

/// From the box's edge to its text.
const INSIDE: f32 = 0.75 * GRID;
/// The most characters of an entry.
const MOST: usize = 40;
/// No other widget answers these keys while an entry is open.
const KEYS: [Key; 6] = [Key::Enter, Key::Tab, Key::Up, Key::Down, Key::Left, Key::Right];

/// The entries of a screen, at most one of which is open.
#[derive(Clone, Debug, Default)]
pub struct EntryField {
    open: Option<OpenEntry>,
}

#[derive(Clone, Debug)]
struct OpenEntry {
    label: String,
    field: TextField,
    /// Canvas units; `None` before it is shown.
    area: Option<Area>,
}

/// The player's act with the open entry.
#[derive(Clone, Debug, PartialEq)]
pub enum EntryEvent {
    Changed,
    /// Its label and its text. The entry stays open: the screen closes it, or refuses the text.
    Taken(String, String),
    GivenUp,
    /// Its label; +1 up, −1 down.
    Stepped(String, f64),
}

impl EntryField {
    /// Opens the entry of that label; all of its text is selected.
    pub fn open(&mut self, label: &str, text: &str) {
        self.open = Some(OpenEntry { label: label.to_owned(), field: TextField::selected(text, MOST), area: None });
    }

    pub fn close(&mut self) {
        self.open = None;
    }

    pub const fn is_open(&self) -> bool {
        self.open.is_some()
    }

    pub fn is_open_at(&self, label: &str) -> bool {
        self.open.as_ref().is_some_and(|open| open.label == label)
    }

    /// The text of the open entry.
    pub fn text(&self) -> Option<String> {
        self.open.as_ref().map(|open| open.field.text())
    }
}

impl Ui<'_> {
    /// The player's act with the open entry. Call it once a pass, before the entries are shown.
    pub fn entry_event(&mut self, entry: &mut EntryField) -> Option<EntryEvent> {
        let open = entry.open.as_mut()?;
        self.claim(KEYS);
        if !self.is_live() || !self.acting {
            return None;
        }
        let input = self.input;
        // Letters of the same frame as Enter belong to the text.
        let changed = open.field.update(input);
        let elsewhere = input.click && open.area.is_some_and(|area| !area.contains(input.pointer));
        let steps = f64::from(u8::from(self.key(Key::Up))) - f64::from(u8::from(self.key(Key::Down)));
        if self.key(Key::Escape) {
            entry.close();
            return Some(EntryEvent::GivenUp);
        }
        if self.key(Key::Enter) || elsewhere {
            return Some(EntryEvent::Taken(open.label.clone(), open.field.text()));
        }
        let stepped = || EntryEvent::Stepped(open.label.clone(), steps);
        (steps != 0.0).then(stepped).or(changed.then_some(EntryEvent::Changed))
    }

    /// A box with `words` at its right end, or the open entry; returns whether the player pressed the box.
    pub fn entry(&mut self, label: &str, area: Area, (words, style): (&str, Style), entry: &mut EntryField) -> bool {
        let open = entry.open.as_mut().filter(|open| open.label == label);
        let kind = if open.is_some() { WidgetKind::Field } else { WidgetKind::Button };
        let Touch { hover, focus, pressed } = self.touch(label, area, kind);
        let canvas = self.canvas();
        if let Some(open) = open {
            open.area = Some(area);
            paint::panel_in(canvas, area, theme::ground(), theme::accent());
            open.field.draw(canvas, area, (DETAILS, INSIDE), Some(self.time()));
            return false;
        }
        paint::panel_in(canvas, area, if hover { theme::panel_hover() } else { theme::ground() }, theme::panel_edge());
        if focus {
            paint::focus_ring(canvas, area);
        }
        let style = style.mono().middle().right();
        let shown = paint::cut(canvas, words, area.size.x - 2.0 * INSIDE, style);
        if shown != words {
            self.tip(area, words);
        }
        canvas.text(&shown, Vec2::new(area.max().x - INSIDE, area.centre().y), style);
        pressed
    }
}
