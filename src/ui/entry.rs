//! A number or a name that a click opens as a line of text: Enter takes it, and so does a click elsewhere; Esc gives it up. Sliders, which the
//! pointer drags, and left and right move where they have the focus. Tooltips: words beside the pointer, above all else.

use super::{Touch, Ui, WidgetKind, text_field::TextField};
use crate::draw::layout::{Area, DETAILS, GRID, Vec2};
use crate::view::{theme, widgets as paint};
use crate::{draw::Colour, draw::Style, settings::Key, words::tr};

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

/// Radius of the knob, in heights of the slider.
const KNOB: f32 = 0.26;
/// Canvas units.
const TRACK: f32 = 3.0;
const MARK: f32 = 2.0;

/// A slider as it stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SliderShown {
    /// The knob's place on the track, 0 … 1.
    pub part: f64,
    /// The place of a mark for comparison, 0 … 1.
    pub mark: f64,
    /// Its colour; `None`: the slider is closed.
    pub knob: Option<Colour>,
}

/// The player's act with a slider.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SliderMove {
    /// To that place, 0 … 1; `goes_on` in all frames of a drag but its first.
    To { part: f64, goes_on: bool },
    /// +1 by the right key, −1 by the left one.
    Step(f64),
}

/// The longest line, canvas units.
const WIDEST: f32 = 360.0;
/// From the pointer to the box: right of and below the arrow.
const BESIDE: Vec2 = Vec2::new(14.0, 22.0);

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

    /// Its ends are inside the area by the knob's radius.
    pub fn slider(&mut self, label: &str, area: Area, shown: &SliderShown) -> Option<SliderMove> {
        let Touch { focus, .. } = self.touch(label, area, WidgetKind::Slider);
        let held = self.is_live() && self.memory.held.as_deref() == Some(label);
        let (knob, y) = (KNOB * area.size.y, area.centre().y);
        let (begins, length) = (area.min.x + knob, area.size.x - 2.0 * knob);
        let place = |part: f64| Vec2::new(begins + length * part.clamp(0.0, 1.0) as f32, y);
        let canvas = self.canvas();
        canvas.line(place(0.0), place(1.0), TRACK, theme::solid());
        let (mark, half) = (place(shown.mark), Vec2::new(0.0, knob));
        canvas.line(mark - half, mark + half, MARK, theme::quiet());
        if focus {
            paint::focus_ring(canvas, area);
        }
        let colour = shown.knob?;
        canvas.disc(place(shown.part), knob, if held { theme::accent() } else { colour });
        if !self.acting {
            return None;
        }
        let keys = [(Key::Right, 1.0), (Key::Left, -1.0)];
        if let Some((_, step)) = keys.into_iter().find(|(key, _)| focus && self.key(*key)) {
            return Some(SliderMove::Step(step));
        }
        let part = f64::from(((self.input.pointer.x - begins) / length).clamp(0.0, 1.0));
        // A click that moves nothing changes nothing: the value need not lie on a whole pixel.
        let moved = held && (part - shown.part).abs() > 0.5 / f64::from(length);
        moved.then_some(SliderMove::To { part, goes_on: !self.input.click })
    }

    /// Notches of the wheel with the pointer in that area, positive upwards.
    pub fn wheel(&self, area: Area) -> f32 {
        let here = self.acting && self.is_live() && area.contains(self.input.pointer);
        if here { self.input.wheel } else { 0.0 }
    }

    /// Shows these words while the pointer is in that area, and no button is down.
    pub fn tip(&mut self, area: Area, words: &str) {
        self.tip_above(area, words, None);
    }

    /// The same with the foot of its box at that height, if any, so that it covers nothing below.
    pub fn tip_above(&mut self, area: Area, words: &str, foot: Option<f32>) {
        if self.is_live() && !self.input.holding && area.contains(self.input.pointer) {
            self.tip = Some((tr(words).to_owned(), foot));
        }
    }

    /// Draws the tooltip of the pass: above its foot, else below the pointer, or above it where there is no room.
    pub(super) fn draw_tip(&self) {
        let Some((words, foot)) = &self.tip else { return };
        let (canvas, pointer) = (self.canvas, self.input.pointer);
        let (style, line) = (Style::new(DETAILS, theme::text()), canvas.line_height(DETAILS));
        let lines = paint::lines(canvas, words, WIDEST, style);
        let widest = lines.iter().map(|words| canvas.width(words, style)).fold(0.0, f32::max);
        let size = Vec2::new(widest, lines.len() as f32 * line) + Vec2::new(2.0, 1.0) * GRID;
        let below = pointer + BESIDE;
        let beside = if below.y + size.y > canvas.size().y { pointer.y - GRID - size.y } else { below.y };
        let y = foot.map_or(beside, |foot| foot - size.y);
        let most = (canvas.size() - size).max(Vec2::ZERO);
        let area = Area { min: Vec2::new(below.x, y).clamp(Vec2::ZERO, most), size };
        canvas.end_layer();
        paint::panel_in(canvas, area, theme::panel_hover(), theme::solid_top());
        for (i, words) in lines.iter().enumerate() {
            canvas.text(words, area.min + Vec2::new(GRID, 0.5 * GRID + i as f32 * line), style);
        }
    }
}
