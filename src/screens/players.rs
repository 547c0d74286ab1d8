//! Who plays: one of those who have played here, or somebody new.

use super::name_field::{Entry, NameField};
use super::scroll::{Bar, Scroll, bar_beside};
use super::{Buttons, Input, Key, Request};
use crate::scores::{Name, Player, Players as Known};
use crate::view::layout::{Area, Frame, GAP, PADDING, ROW_BUTTON, Vec2};

/// Players in view.
pub const PAGE: usize = 7;
/// Width and height of a player's button.
const ROW: Vec2 = Vec2::new(560.0, 48.0);
/// From a row to the next.
const PITCH: f32 = ROW.y + 8.0;
/// Room for the scroll bar, on both sides, so that rows stand in the middle.
const BAR: f32 = 24.0;
/// From the canvas' top to the list, in a window of the design's height.
const TOP: f32 = 144.0;

/// Somebody who may play.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Candidate {
    /// Who.
    pub name: Name,
    /// How many levels are done.
    pub done: usize,
}

/// The list of players, or the field for a new one.
#[derive(Debug)]
pub struct Players {
    candidates: Vec<Candidate>,
    current: Name,
    scroll: Scroll,
    buttons: Buttons,
    /// The field for a new name, while it is open.
    field: Option<NameField>,
    /// What is wrong with the players' file.
    trouble: Option<String>,
}

impl Players {
    /// The players that are known, and who plays now. Without any there is only the field.
    pub fn new(known: &Known, current: &Name, trouble: Option<String>) -> Self {
        let candidate = |player: &Player| Candidate { name: player.name().clone(), done: player.done() };
        let mut candidates: Vec<Candidate> = known.all().iter().map(candidate).collect();
        candidates.sort_by_key(|candidate| candidate.name.as_str().to_lowercase());
        let at = candidates.iter().position(|candidate| candidate.name == *current);
        let field = candidates.is_empty().then(|| NameField::new(""));
        let mut screen =
            Self { candidates, current: current.clone(), scroll: Scroll::default(), buttons: Buttons::default(), field, trouble };
        screen.place(&Frame::default());
        if let Some(at) = at {
            screen.scroll.show(at);
            screen.buttons = Buttons::focused_on(at - screen.scroll.range().start);
        }
        screen
    }

    /// One frame.
    pub fn update(&mut self, input: &Input) -> Option<Request> {
        if let Some(field) = &mut self.field {
            match field.update(input)? {
                Entry::Name(name) => return Some(Request::Choose(name, true)),
                Entry::Back if self.candidates.is_empty() => return Some(Request::Menu),
                Entry::Back => self.field = None,
            }
            return None;
        }
        self.place(&input.frame);
        if input.pressed(Key::Escape) {
            return Some(Request::Menu);
        }
        self.scroll_at_the_ends(input);
        let shown = self.scroll.range();
        match self.buttons.update(input)? {
            row if row < shown.len() => Some(Request::Choose(self.candidates[shown.start + row].name.clone(), false)),
            row if row == shown.len() => {
                self.field = Some(NameField::new(""));
                None
            }
            _ => Some(Request::Menu),
        }
    }

    /// Everyone in the list, by name.
    pub fn candidates(&self) -> &[Candidate] {
        &self.candidates
    }

    /// Who plays now.
    pub fn current(&self) -> &Name {
        &self.current
    }

    /// Those in view.
    pub fn range(&self) -> std::ops::Range<usize> {
        self.scroll.range()
    }

    /// The scroll bar, where not all are in view.
    pub fn bar(&self) -> Option<Bar> {
        self.scroll.bar()
    }

    /// The field for a new name, while it is open.
    pub fn field(&self) -> Option<&NameField> {
        self.field.as_ref()
    }

    /// What is wrong with the players' file.
    pub fn trouble(&self) -> Option<&str> {
        self.trouble.as_deref()
    }

    /// Its buttons: the players in view, New Player, Back; or those of the field.
    pub fn buttons(&self) -> &Buttons {
        self.field.as_ref().map_or(&self.buttons, NameField::buttons)
    }

    /// Arrow keys walk the buttons, and beyond the first and the last player in view they turn the list.
    fn scroll_at_the_ends(&mut self, input: &Input) {
        let (shown, focus) = (self.scroll.range(), self.buttons.focus());
        let turns = (input.pressed(Key::Up) && focus == 0 && shown.start > 0)
            || (input.pressed(Key::Down) && focus + 1 == shown.len() && shown.end < self.candidates.len());
        let others = [Key::PageUp, Key::PageDown, Key::Home, Key::End].into_iter().filter(|key| input.pressed(*key));
        let arrows = [Key::Up, Key::Down].into_iter().filter(|key| turns && input.pressed(*key));
        let pressed = others.chain(arrows).collect();
        self.scroll.update(&Input { pressed, held: pressed, ..input.clone() });
        if turns {
            // The list has moved below the highlight, which would move on otherwise.
            let areas = self.buttons.areas().to_vec();
            let step = if input.pressed(Key::Up) { 1 } else { focus - 1 };
            self.buttons = Buttons::focused_on(step);
            self.buttons.place(areas);
        }
    }

    fn place(&mut self, frame: &Frame) {
        let list = list(frame);
        self.scroll.place(self.candidates.len(), PAGE, bar_beside(list, list.min.y + PADDING, list.max().y - PADDING));
        let rows = (0..self.scroll.range().len())
            .map(|row| Area { min: list.min + Vec2::new(PADDING + BAR, PADDING + row as f32 * PITCH), size: ROW });
        self.buttons.place(rows.chain(frame.row(2, list.max().y + 2.0 * GAP)).collect());
    }
}

/// The panel with the list.
fn list(frame: &Frame) -> Area {
    let size = Vec2::new(ROW.x + 2.0 * (PADDING + BAR), PAGE as f32 * PITCH - 8.0 + 2.0 * PADDING);
    let top = TOP + (frame.size.y - 720.0) / 2.0;
    debug_assert!(top + size.y + 2.0 * GAP + ROW_BUTTON.y <= frame.size.y);
    Area { min: Vec2::new((frame.size.x - size.x) / 2.0, top), size }
}

mod drawing {
    use super::{Candidate, Players, list};
    use crate::draw::{Canvas, Style};
    use crate::view::layout::{Area, BUTTON_TEXT, PADDING, TEXT, Vec2};
    use crate::view::{theme, widgets};

    impl Players {
        /// Draws the list, or the field; `time` (s) makes its caret blink.
        pub fn draw(&self, canvas: &Canvas, time: f64) {
            widgets::graph_paper(canvas);
            if let Some(field) = &self.field {
                widgets::heading(canvas, "New player", canvas.size().y * 0.2);
                return field.draw(canvas, ("What you complete is kept under this name.", "Done"), time);
            }
            let list = list(canvas.frame());
            widgets::heading(canvas, "Who plays?", list.min.y - 64.0);
            widgets::panel(canvas, list);
            let shown = self.scroll.range();
            for (i, area) in self.buttons.areas().iter().enumerate() {
                let (hover, focus) = (self.buttons.hover() == Some(i), self.buttons.focus() == i);
                match self.candidates[shown.clone()].get(i) {
                    Some(candidate) => self.draw_row(canvas, *area, candidate, (hover, focus)),
                    None => {
                        let label = if i == shown.len() { "New Player" } else { "Back" };
                        widgets::button(canvas, *area, label, hover, focus);
                    }
                }
            }
            if let Some(bar) = self.scroll.bar() {
                widgets::scroll_bar(canvas, bar.track, bar.handle, bar.held);
            }
            if let Some(trouble) = &self.trouble {
                let at = Vec2::new(list.centre().x, list.min.y - 24.0);
                widgets::fitted(canvas, trouble, at, canvas.size().x - 64.0, &[TEXT], theme::bad());
            }
        }

        fn draw_row(&self, canvas: &Canvas, area: Area, candidate: &Candidate, (hover, focus): (bool, bool)) {
            widgets::button_box(canvas, area, hover, focus);
            let y = area.centre().y;
            let colour = if candidate.name == self.current { theme::accent() } else { theme::text() };
            let name = Style::new(BUTTON_TEXT, colour).mono().middle();
            canvas.text(candidate.name.as_str(), Vec2::new(area.min.x + PADDING, y), name);
            let done = match candidate.done {
                1 => "1 level done".to_owned(),
                many => format!("{many} levels done"),
            };
            canvas.text(&done, Vec2::new(area.max().x - PADDING, y), Style::new(TEXT, theme::quiet()).right().middle());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scores::Players as Known;

    #[test]
    fn rows_stand_in_the_middle_of_their_panel() {
        let name = Name::new("ann").expect("a name");
        let mut players = Players::new(&Known::default(), &name, None);
        players.candidates = vec![Candidate { name, done: 0 }];
        for window in [(900.0, 500.0), (1280.0, 720.0), (1920.0, 1080.0)] {
            let frame = Frame::of_window(window.into());
            players.place(&frame);
            let row = players.buttons.areas()[0];
            assert!((row.centre().x - list(&frame).centre().x).abs() < 1e-3, "{row:?}");
        }
    }
}
