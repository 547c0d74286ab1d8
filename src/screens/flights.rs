//! The flights of a level: the one just flown, the level's own, and those of its board. One is watched or kept as a file, one or several
//! are raced.

use super::input::Repeat;
use super::race::MOST_RIVALS;
use super::scroll::{Bar, Scroll, bar_beside};
use super::{Buttons, Flown, Input, Key, Keys, Request};
use crate::game::Replay;
use crate::scores::Origin;
use crate::settings::Action;
use crate::view::layout::{Area, Frame, Vec2};
use std::path::PathBuf;
use std::rc::Rc;

/// Flights in view.
pub const PAGE: usize = 10;
/// Height of a row, and width of the panel.
const ROW: f32 = 40.0;
const WIDTH: f32 = 920.0;
/// From the panel's top to its first row, from the canvas' top to the panel, and from the panel down to the buttons.
const HEAD: f32 = 48.0;
const TOP: f32 = 120.0;
const FOOT: f32 = 44.0;
/// From a row's ends to the panel's sides: room for the scroll bar, on both sides, so that rows stand in the middle.
const ROW_INSET: f32 = 24.0;
/// Width of a row's end where it is chosen for a race.
const BOX: f32 = 120.0;
/// The words on its buttons.
pub const LABELS: [&str; 4] = ["Watch", "Race", "Keep as File", "Back"];

/// Which flights are looked at, and from where.
#[derive(Clone, Debug)]
pub struct Visit {
    /// The level's folder name.
    pub level: String,
    /// What was just flown there.
    pub flown: Option<Rc<Flown>>,
    /// Where the way back leads.
    pub back: Box<Request>,
}

/// Where a flight is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Source {
    /// It was just flown.
    Flown,
    /// In a file of the level.
    Level(PathBuf),
    /// A row of the board leads to it.
    Row(Origin),
}

/// A flight that can be watched.
#[derive(Clone, Debug, PartialEq)]
pub struct Candidate {
    /// Whose it is.
    pub name: String,
    /// What else is to be said of it.
    pub about: String,
    /// What it came to, where that is known.
    pub score: Option<i64>,
    /// How long it took, s, where that is known.
    pub time: Option<f64>,
    /// Where it is.
    pub source: Source,
}

/// The list.
#[derive(Debug)]
pub struct Flights {
    visit: Visit,
    subject: String,
    candidates: Vec<Candidate>,
    /// Whether the record of each has been read.
    read: Vec<bool>,
    /// Those that are to be raced.
    marked: Vec<usize>,
    chosen: usize,
    scroll: Scroll,
    repeat: Repeat,
    buttons: Buttons,
    panel: Area,
    /// What became of something that was asked for, and whether that is bad.
    message: Option<(String, bool)>,
}

impl Flights {
    /// The flights of a level, by its title.
    pub fn new(visit: Visit, subject: String, candidates: Vec<Candidate>) -> Self {
        Self {
            visit,
            subject,
            read: vec![false; candidates.len()],
            candidates,
            marked: Vec::new(),
            chosen: 0,
            scroll: Scroll::default(),
            repeat: Repeat::default(),
            buttons: Buttons::default(),
            panel: Area::default(),
            message: None,
        }
    }

    /// One frame.
    pub fn update(&mut self, input: &Input) -> Option<Request> {
        self.panel = panel(&input.frame);
        let rows = self.panel.min.y + HEAD;
        self.scroll.place(self.candidates.len(), PAGE, bar_beside(self.panel, rows, rows + PAGE as f32 * ROW));
        self.buttons.place(input.frame.row(LABELS.len(), self.panel.max().y + FOOT));
        if input.pressed(Key::Escape) {
            return Some((*self.visit.back).clone());
        }
        self.choose(input);
        let upright = [Key::Up, Key::Down, Key::PadUp, Key::PadDown].into_iter().collect();
        match self.buttons.update(&Input { pressed: input.pressed.less(upright), ..input.clone() })? {
            0 => Some(Request::Watch(self.visit.clone(), self.chosen()?.clone())),
            1 => Some(Request::Race(self.visit.clone(), self.rivals())).filter(|_| !self.candidates.is_empty()),
            2 => Some(Request::Keep(self.visit.clone(), self.chosen()?.clone())),
            _ => Some((*self.visit.back).clone()),
        }
    }

    /// Reads the record of one flight in view that has not been read yet, for its time and score. A record that cannot be read says so
    /// when it is asked for.
    pub fn look_one_up(&mut self, read: impl FnOnce(&Visit, &Source) -> Option<Replay>) {
        let Some(index) = self.scroll.range().find(|&index| self.read.get(index) == Some(&false)) else { return };
        self.read[index] = true;
        let candidate = &mut self.candidates[index];
        if let Some(replay) = read(&self.visit, &candidate.source) {
            (candidate.time, candidate.score) = (replay.time, candidate.score.or(Some(replay.score)));
        }
    }

    /// What the flights are of, in words.
    pub fn subject(&self) -> &str {
        &self.subject
    }

    /// All flights.
    pub fn candidates(&self) -> &[Candidate] {
        &self.candidates
    }

    /// The one that the keyboard is on.
    pub fn chosen(&self) -> Option<&Candidate> {
        self.candidates.get(self.chosen)
    }

    /// Those that would be raced: the marked ones, or the one that the keyboard is on.
    pub fn rivals(&self) -> Vec<Candidate> {
        let one = [self.chosen];
        let all = if self.marked.is_empty() { &one[..] } else { &self.marked };
        all.iter().filter_map(|index| self.candidates.get(*index)).cloned().collect()
    }

    /// What became of something that was asked for, and whether that is bad.
    pub fn message(&self) -> Option<(&str, bool)> {
        self.message.as_ref().map(|(words, bad)| (words.as_str(), *bad))
    }

    /// Says what became of something that was asked for.
    pub fn tell(&mut self, words: String, bad: bool) {
        self.message = Some((words, bad));
    }

    /// Its buttons: Watch, Race, Keep as File, Back.
    pub const fn buttons(&self) -> &Buttons {
        &self.buttons
    }

    /// The scroll bar, where not all are in view.
    pub fn bar(&self) -> Option<Bar> {
        self.scroll.bar()
    }

    /// Where a row in view is, counted from the first in view.
    pub fn row(&self, line: usize) -> Area {
        let top = self.panel.min.y + HEAD + line as f32 * ROW;
        Area::new(self.panel.min.x + ROW_INSET, top + 2.0, WIDTH - 2.0 * ROW_INSET, ROW - 4.0)
    }

    /// Chooses and marks flights by keys and pointer.
    fn choose(&mut self, input: &Input) {
        let last = self.candidates.len().saturating_sub(1);
        for key in self.repeat.strokes(input, &[Key::Up, Key::Down, Key::PageUp, Key::PageDown, Key::Home, Key::End]) {
            self.chosen = match key {
                Key::Up => self.chosen.saturating_sub(1),
                Key::Down => self.chosen + 1,
                Key::PageUp => self.chosen.saturating_sub(PAGE),
                Key::PageDown => self.chosen + PAGE,
                Key::Home => 0,
                _ => last,
            }
            .min(last);
            if !self.scroll.range().contains(&self.chosen) {
                self.scroll.show(self.chosen);
            }
        }
        // Keys move the choice; wheel and bar the list.
        self.scroll.update(&Input { pressed: Keys::default(), held: Keys::default(), ..input.clone() });
        if input.pressed(Key::Space) || input.acts(Action::Details) {
            self.mark(self.chosen);
        }
        let range = self.scroll.range();
        if let Some(line) = (0..range.len()).find(|line| input.click && self.row(*line).contains(input.pointer)) {
            self.chosen = range.start + line;
            if input.pointer.x > self.row(line).max().x - BOX {
                self.mark(self.chosen);
            }
        }
    }

    fn mark(&mut self, index: usize) {
        self.message = None;
        if let Some(at) = self.marked.iter().position(|marked| *marked == index) {
            self.marked.remove(at);
        } else if self.marked.len() == MOST_RIVALS {
            self.tell(format!("At most {MOST_RIVALS} at a time can be raced."), true);
        } else if index < self.candidates.len() {
            self.marked.push(index);
        }
    }
}

fn panel(frame: &Frame) -> Area {
    let top = TOP + (frame.size.y - 720.0) / 2.0;
    Area { min: Vec2::new((frame.size.x - WIDTH) / 2.0, top), size: Vec2::new(WIDTH, HEAD + PAGE as f32 * ROW + 16.0) }
}

mod drawing {
    use super::{Flights, HEAD, LABELS, ROW};
    use crate::draw::{Canvas, Style};
    use crate::number::clock;
    use crate::view::layout::{Area, BUTTON_TEXT, HEADING, TEXT, Vec2};
    use crate::view::{theme, widgets};

    /// Where the columns stand, from the panel's left edge: whose, what it is, time and score (their right ends), the box (its middle).
    const COLUMNS: [f32; 5] = [40.0, 288.0, 656.0, 752.0, 824.0];

    impl Flights {
        /// Draws the list.
        pub fn draw(&self, canvas: &Canvas) {
            widgets::graph_paper(canvas);
            let (panel, middle) = (self.panel, canvas.size().x / 2.0);
            let heading = Vec2::new(middle, panel.min.y - 64.0);
            let widest = canvas.size().x - 64.0;
            widgets::fitted(
                canvas,
                &format!("Flights of {}", self.subject),
                heading,
                widest,
                &[HEADING, BUTTON_TEXT],
                theme::text(),
            );
            let quiet = Style::new(TEXT, theme::quiet()).middle();
            let below = Vec2::new(middle, panel.min.y - 24.0);
            match &self.message {
                Some((words, bad)) => {
                    let colour = if *bad { theme::bad() } else { theme::good() };
                    widgets::fitted(canvas, words, below, widest, &[TEXT], colour);
                }
                None => canvas.text("↑ ↓ choose, Space marks who is raced", below, quiet.centred()),
            }
            widgets::panel(canvas, panel);
            let column = |i: usize, y: f32| Vec2::new(panel.min.x + COLUMNS[i], y);
            let head = panel.min.y + HEAD / 2.0 + 2.0;
            canvas.text("Whose", column(0, head), quiet);
            canvas.text("Time", column(2, head), quiet.right());
            canvas.text("Score", column(3, head), quiet.right());
            canvas.text("Race", column(4, head), quiet.centred());
            if self.candidates.is_empty() {
                canvas.text("No flights yet: fly one and save its score.", panel.centre(), quiet.centred());
            }
            for (line, index) in self.scroll.range().enumerate() {
                let (candidate, area) = (&self.candidates[index], self.row(line));
                if index == self.chosen {
                    canvas.rounded(area, 6.0, theme::panel_hover());
                    canvas.rounded_edge(area, 6.0, 2.0, theme::accent());
                }
                let y = panel.min.y + HEAD + line as f32 * ROW + ROW / 2.0;
                canvas.text(&candidate.name, column(0, y), Style::new(TEXT, theme::text()).middle());
                canvas.text(&candidate.about, column(1, y), quiet);
                let number = Style::new(TEXT, theme::text()).mono().middle().right();
                for (at, words) in [(2, candidate.time.map(clock)), (3, candidate.score.map(|score| score.to_string()))] {
                    canvas.text(words.as_deref().unwrap_or_default(), column(at, y), number);
                }
                let tick = Area::around(column(4, y), Vec2::splat(20.0));
                canvas.rounded(tick, 4.0, theme::ground());
                canvas.rounded_edge(tick, 4.0, 2.0, theme::solid_top());
                if self.marked.contains(&index) {
                    widgets::tick(canvas, tick.centre(), 7.0, theme::accent());
                }
            }
            if let Some(bar) = self.scroll.bar() {
                widgets::scroll_bar(canvas, bar.track, bar.handle, bar.held);
            }
            for (i, area) in self.buttons.areas().iter().enumerate() {
                widgets::button(canvas, *area, LABELS[i], self.buttons.hover() == Some(i), self.buttons.focus() == i);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_stand_in_the_middle_of_their_panel() {
        let visit = Visit { level: "1".to_owned(), flown: None, back: Box::new(Request::Menu) };
        let mut flights = Flights::new(visit, "level 1".to_owned(), Vec::new());
        for window in [(900.0, 500.0), (1280.0, 720.0), (1920.0, 1080.0)] {
            flights.update(&Input { frame: Frame::of_window(window.into()), ..Input::default() });
            assert!((flights.row(0).centre().x - flights.panel.centre().x).abs() < 1e-3, "{:?}", flights.row(0));
        }
    }
}
