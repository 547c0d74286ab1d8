//! Widgets: buttons alone, in rows and columns, on a tool bar; values to choose; lines of text; lists that scroll.

use super::{Ui, input::Input, memory::WidgetKind, text_field::TextField};
use crate::draw::layout::{Area, BUTTON_TEXT, DETAILS, GRID, HEADING, MARGIN, PADDING, ROW_BUTTON, TEXT, Vec2};
use crate::draw::{Align, Canvas, Colour, Style};
use crate::view::{theme, widgets as paint};
use crate::{settings::Key, settings::Keys, words::tr};
use std::ops::Range;

const DUSK: f32 = 0.75;
/// Width of a choice's value, at its right.
const VALUE_WIDTH: f32 = 200.0;

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Touch {
    /// The pointer is on it, and moved last.
    pub hover: bool,
    pub focus: bool,
    pub pressed: bool,
}

/// The player's act with a line of text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FieldEvent {
    Changed,
    Entered,
}

/// The keys that scroll a list, besides wheel and bar.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Turning {
    /// Up and down go line by line, the other keys page by page.
    Lines,
    /// Up and down turn pages, each of which begins at a multiple of its length.
    Pages,
    /// All four arrows turn such pages.
    AllPages,
    /// Page Up, Page Down, Home and End; arrows walk the widgets.
    Leaps,
    Wheel,
}

impl Turning {
    fn keys(self) -> &'static [Key] {
        const ALL: [Key; 8] = [Key::PageUp, Key::PageDown, Key::Home, Key::End, Key::Up, Key::Down, Key::Left, Key::Right];
        match self {
            Self::AllPages => &ALL,
            Self::Lines | Self::Pages => &ALL[..6],
            Self::Leaps => &ALL[..4],
            Self::Wheel => &[],
        }
    }

    fn input(self, input: &Input) -> Input {
        let aside = |key: Key| match key {
            Key::Left => Key::PageUp,
            Key::Right => Key::PageDown,
            other => other,
        };
        let those = |is: &dyn Fn(Key) -> bool| self.keys().iter().filter(|key| is(**key)).map(|key| aside(*key)).collect::<Keys>();
        Input { pressed: those(&|key| input.pressed(key)), held: those(&|key| input.held(key)), ..input.clone() }
    }
}

impl Ui<'_> {
    /// The paper of the notebook, or dusk over the game behind, and a heading with its capitals around `y`.
    pub fn page(&self, heading: &str, y: f32) {
        if self.input().over {
            paint::curtain(self.canvas(), DUSK);
        } else {
            paint::graph_paper(self.canvas());
        }
        self.fitted(tr(heading), Vec2::new(self.frame().size.x / 2.0, y), &[HEADING, BUTTON_TEXT], theme::text());
    }

    pub fn panel(&self, area: Area) {
        paint::panel(self.canvas(), area);
    }

    pub fn text(&self, text: &str, at: Vec2, style: Style) {
        self.canvas().text(text, at, style);
    }

    /// A line of text around its middle, as wide as the canvas at most, in the first of `sizes` that fits.
    pub fn fitted(&self, text: &str, middle: Vec2, sizes: &[f32], colour: Colour) {
        paint::fitted(self.canvas(), text, middle, self.frame().size.x - 64.0, sizes, colour);
    }

    pub fn button(&mut self, label: &str, area: Area) -> bool {
        let touch = self.touch(label, area, WidgetKind::Button);
        paint::button(self.canvas(), area, tr(label), touch.hover, touch.focus);
        touch.pressed
    }

    /// A button with its words in that style: in its middle where they are centred, else at its left end.
    pub fn small_button(&mut self, (label, words): (&str, &str), area: Area, style: Style) -> bool {
        let touch = self.touch(label, area, WidgetKind::Button);
        paint::button_box(self.canvas(), area, touch.hover, touch.focus);
        let at = if style.align == Align::Centre { area.centre() } else { Vec2::new(area.min.x + GRID, area.centre().y) };
        self.text(words, at, style.middle());
        touch.pressed
    }

    /// The width of a button with that label in its smallest letters.
    pub fn least_width(&self, label: &str) -> f32 {
        self.canvas().width(tr(label), Style::new(DETAILS, theme::text())) + 2.0 * GRID + 1.0
    }

    pub fn buttons<'l>(&mut self, areas: Vec<Area>, labels: &[&'l str]) -> Option<&'l str> {
        let all = labels.iter().zip(areas);
        all.fold(None, |pressed, (label, area)| if self.button(label, area) { Some(*label) } else { pressed })
    }

    /// In the middle of the canvas.
    pub fn row<'l>(&mut self, top: f32, labels: &[&'l str]) -> Option<&'l str> {
        let least: Vec<f32> = labels.iter().map(|label| self.least_width(label)).collect();
        self.buttons(self.frame().row_of(&least, top), labels)
    }

    /// In the middle of the canvas.
    pub fn column<'l>(&mut self, top: f32, labels: &[&'l str]) -> Option<&'l str> {
        self.buttons(self.frame().column(labels.len(), top), labels)
    }

    /// Buttons at the foot of a scene whose arrows have other work: each shows its own key, which presses it unless the screen claims it.
    pub fn tools<'l>(&mut self, tools: &[(&'l str, Key, &str)]) -> Option<&'l str> {
        let least: Vec<f32> = tools.iter().map(|(label, ..)| self.least_width(label)).collect();
        let areas = self.frame().row_of(&least, self.frame().size.y - ROW_BUTTON.y - MARGIN);
        let mut pressed = None;
        for ((label, key, named), area) in tools.iter().zip(areas) {
            let touch = self.touch(label, area, WidgetKind::Tool);
            paint::keyed_button(self.canvas(), area, (tr(label), tr(named)), (touch.hover, false));
            if touch.pressed || self.key(*key) && !self.shown.claimed.has(*key) {
                self.input().answer(super::input::ButtonAnswer::Pressed);
                pressed = Some(*label);
            }
        }
        pressed
    }

    /// A value that left, right and a click on either half change, and Enter raises; whether it rises. `share` (0 … 1): its place in its range.
    pub fn choice(&mut self, label: &str, area: Area, value: &str, share: Option<f32>) -> Option<bool> {
        let touch = self.touch(label, area, WidgetKind::Choice);
        let place = Area::new(area.max().x - VALUE_WIDTH, area.min.y, VALUE_WIDTH, area.size.y);
        let canvas = self.canvas();
        paint::button_box(canvas, area, touch.hover, touch.focus);
        let words = Style::new(TEXT, theme::text()).middle();
        canvas.text(tr(label), Vec2::new(area.min.x + PADDING, area.centre().y), words);
        let mark = Style::new(TEXT, theme::accent()).middle().centred();
        canvas.text("‹", Vec2::new(place.min.x + PADDING, place.centre().y), mark);
        canvas.text("›", Vec2::new(place.max().x - PADDING, place.centre().y), mark);
        if let Some(share) = share {
            let track = Area::new(place.min.x + 32.0, place.max().y - 6.0, place.size.x - 64.0, 3.0);
            canvas.rounded(track, 1.5, theme::panel_edge());
            canvas.rounded(Area { size: Vec2::new(track.size.x * share, 3.0), ..track }, 1.5, theme::accent());
        }
        canvas.text(value, place.centre(), words.mono().centred());
        let keys = [(Key::Right, true), (Key::Left, false)];
        let by_key = keys.into_iter().find(|(key, _)| touch.focus && self.key(*key)).map(|(_, up)| up);
        let by_press = || touch.pressed.then(|| !self.input().click || self.input().pointer.x >= place.centre().x);
        by_key.or_else(by_press)
    }

    /// Characters also go to it while a button has the focus; it takes the focus then.
    pub fn field(&mut self, label: &str, area: Area, field: &mut TextField) -> Option<FieldEvent> {
        let touch = self.touch(label, area, WidgetKind::Field);
        let input = self.input;
        field.note_focus(touch.focus);
        let letters = Input { pressed: Keys::default(), held: Keys::default(), ..input.clone() };
        let changed = self.is_live() && field.update(if touch.focus { input } else { &letters });
        if changed && !touch.focus {
            field.come_back();
            self.focus(Some(label));
        }
        paint::panel(self.canvas(), area);
        if touch.focus {
            paint::focus_ring(self.canvas(), area);
        }
        field.draw(self.canvas(), area, (BUTTON_TEXT, PADDING), touch.focus.then_some(self.time()));
        match (touch.pressed, changed) {
            (true, _) => Some(FieldEvent::Entered),
            (false, true) => Some(FieldEvent::Changed),
            (false, false) => None,
        }
    }

    /// The lines of a list in view, at most `page`; the bar is drawn on its track where there are more. `name` identifies the list.
    pub fn scroll(&mut self, name: &str, (lines, page): (usize, usize), track: Area, turn: Turning) -> Range<usize> {
        let mut scroll = self.memory.scrolls.remove(name).unwrap_or_default();
        scroll.pages = matches!(turn, Turning::Pages | Turning::AllPages);
        scroll.place(lines, page, track);
        self.claim(turn.keys().iter().copied());
        if self.is_live() {
            scroll.update(&turn.input(self.input()));
        }
        if let Some(bar) = scroll.bar() {
            paint::scroll_bar(self.canvas(), bar.track, bar.handle, bar.held);
        }
        let range = scroll.range();
        self.memory.scrolls.insert(name.to_owned(), scroll);
        range
    }

    /// Brings a line into view, in its middle where that fits, before the list is shown.
    pub fn reveal(&mut self, name: &str, line: usize) {
        self.memory.scrolls.entry(name.to_owned()).or_default().show(line);
    }

    /// Rows that are pressed like buttons; arrows walk them, and scroll at the ends of the view. Returns the index of the pressed one.
    pub fn list(
        &mut self,
        name: &str,
        rows: &[&str],
        place: &Rows,
        mut draw: impl FnMut(&Canvas, usize, (Area, Touch)),
    ) -> Option<usize> {
        let walked = self.key(Key::Up) || self.key(Key::Down);
        if let (true, Some(line)) = (walked, rows.iter().position(|row| self.has_focus(row))) {
            self.memory.scrolls.entry(name.to_owned()).or_default().bring(line);
        }
        let shown = self.scroll(name, (rows.len(), place.page), place.track, Turning::Leaps);
        let mut pressed = None;
        let beside = shown.start.saturating_sub(1)..shown.end + 1;
        for (line, row) in rows.iter().enumerate().filter(|(line, _)| beside.contains(line)) {
            let down = (line as f32 - shown.start as f32) * place.pitch;
            let area = Area { min: place.first.min + Vec2::new(0.0, down), ..place.first };
            if !shown.contains(&line) {
                self.touch(row, area, WidgetKind::Beyond);
                continue;
            }
            let touch = self.touch(row, area, WidgetKind::Button);
            draw(self.canvas, line, (area, touch));
            pressed = pressed.or(touch.pressed.then_some(line));
        }
        pressed
    }
}

/// The places of a list's rows.
#[derive(Clone, Copy, Debug)]
pub struct Rows {
    pub first: Area,
    pub pitch: f32,
    pub page: usize,
    pub track: Area,
}
