//! A grid of levels, used twice: to choose what to play and to choose whose leaderboard to see.

use super::library::Refusal;
use super::{Buttons, Input, Key, Problems, Request};
use crate::view::layout::{Area, Frame, GAP, ROW_BUTTON, Vec2};

/// Buttons across and down a page.
const GRID: (usize, usize) = (5, 3);
/// Levels a page.
pub const PAGE: usize = GRID.0 * GRID.1;
/// Slices of the canvas' width and height; a button sits at slices 1, 3, 5, …
const SLICES: Vec2 = Vec2::new(11.0, 7.0);
/// From the canvas' bottom to the buttons below the grid.
const FOOT: f32 = 14.0;

/// What a level is chosen for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// To play it.
    Play,
    /// To see its leaderboard.
    Leaderboard,
}

/// A level in the list.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Its folder's name.
    pub name: String,
    /// Its title, or why it does not load.
    pub title: Result<String, Refusal>,
    /// Whether it has been completed.
    pub completed: bool,
}

/// The grid of levels.
#[derive(Debug)]
pub struct LevelSelect {
    purpose: Purpose,
    entries: Vec<Entry>,
    page: usize,
    buttons: Buttons,
    problems: Option<Problems>,
}

/// What a button of the screen is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Press {
    Level(usize),
    Back,
    Previous,
    Next,
}

impl LevelSelect {
    /// The list for that purpose.
    pub fn new(purpose: Purpose, entries: Vec<Entry>) -> Self {
        Self { purpose, entries, page: 0, buttons: Buttons::default(), problems: None }
    }

    /// Opens the page of a level and puts the keyboard on it.
    pub fn turn_to_level(&mut self, name: &str) {
        if let Some(index) = self.entries.iter().position(|entry| entry.name == name) {
            self.page = index / PAGE;
            self.buttons = Buttons::focused_on(index % PAGE);
        }
    }

    /// Shows why a level does not load.
    pub fn show_problems(&mut self, name: &str, refusal: Refusal) {
        self.turn_to_level(name);
        self.show(format!("Level {name} does not load"), refusal);
    }

    /// Shows a panel above the list.
    pub fn show(&mut self, heading: String, problems: Vec<String>) {
        self.problems = Some(Problems::new(heading, problems));
    }

    /// One frame.
    pub fn update(&mut self, input: &Input) -> Option<Request> {
        let presses = self.presses();
        self.buttons.place(presses.iter().map(|press| place(*press, &input.frame)).collect());
        if let Some(problems) = &mut self.problems {
            if problems.update(input) {
                self.problems = None;
            }
            return None;
        }
        if input.pressed(Key::Escape) {
            return Some(Request::Menu);
        }
        if input.pressed(Key::PageDown) {
            self.turn_to(self.page + 1);
        } else if input.pressed(Key::PageUp) {
            self.turn_to(self.page.saturating_sub(1));
        } else if let Some(pressed) = self.buttons.update(input) {
            return self.press(presses[pressed]);
        }
        None
    }

    /// What it is used for.
    pub fn purpose(&self) -> Purpose {
        self.purpose
    }

    /// All levels, in order.
    pub fn entries(&self) -> &[Entry] {
        &self.entries
    }

    /// The page in view, from 0.
    pub fn page(&self) -> usize {
        self.page
    }

    /// Its buttons: the levels of the page, Back, and where there are more pages Previous and Next.
    pub fn buttons(&self) -> &Buttons {
        &self.buttons
    }

    /// Why a level does not load, while that is shown.
    pub fn problems(&self) -> Option<&Problems> {
        self.problems.as_ref()
    }

    fn press(&mut self, press: Press) -> Option<Request> {
        match press {
            Press::Back => return Some(Request::Menu),
            Press::Previous => self.turn_to(self.page.saturating_sub(1)),
            Press::Next => self.turn_to(self.page + 1),
            Press::Level(index) => {
                let Entry { name, title, .. } = self.entries[index].clone();
                match (title, self.purpose) {
                    (Err(refusal), _) => self.show_problems(&name, refusal),
                    (Ok(_), Purpose::Play) => return Some(Request::Play(name)),
                    (Ok(_), Purpose::Leaderboard) => return Some(Request::Leaderboard(name)),
                }
            }
        }
        None
    }

    fn turn_to(&mut self, page: usize) {
        if page < self.pages() && page != self.page {
            self.page = page;
            self.buttons = Buttons::default();
        }
    }

    fn pages(&self) -> usize {
        self.entries.len().div_ceil(PAGE).max(1)
    }

    fn presses(&self) -> Vec<Press> {
        let first = self.page * PAGE;
        let levels = (first..self.entries.len().min(first + PAGE)).map(Press::Level);
        let turns: &[Press] = if self.pages() > 1 { &[Press::Previous, Press::Next] } else { &[] };
        levels.chain([Press::Back]).chain(turns.iter().copied()).collect()
    }
}

/// Where a button is: a level at its slices, the others in the lowest gap.
fn place(press: Press, frame: &Frame) -> Area {
    let slice = frame.size / SLICES;
    let below = |left: f32| Area { min: Vec2::new(left, frame.size.y - FOOT - ROW_BUTTON.y), size: ROW_BUTTON };
    match press {
        Press::Level(index) => {
            let (column, row) = (index % PAGE % GRID.0, index % PAGE / GRID.0);
            Area { min: slice * Vec2::new(1.0 + 2.0 * column as f32, 1.0 + 2.0 * row as f32), size: slice }
        }
        Press::Back => below(slice.x),
        Press::Previous => below(frame.size.x - slice.x - 2.0 * ROW_BUTTON.x - GAP),
        Press::Next => below(frame.size.x - slice.x - ROW_BUTTON.x),
    }
}

#[cfg(feature = "window")]
mod drawing {
    use super::{Entry, FOOT, LevelSelect, Press, Purpose};
    use crate::view::canvas::{Canvas, Style};
    use crate::view::layout::{Area, BUTTON_TEXT, DETAILS, HEADING, ROW_BUTTON, TEXT, Vec2};
    use crate::view::{theme, widgets};

    /// From a level's button down to the middle of its title.
    const TITLE_BELOW: f32 = 20.0;

    impl LevelSelect {
        /// Draws the grid, and the problems above it.
        pub fn draw(&self, canvas: &Canvas) {
            let frame = canvas.frame();
            widgets::graph_paper(canvas);
            let slice = frame.size / super::SLICES;
            let heading = match self.purpose {
                Purpose::Play => "Choose a level",
                Purpose::Leaderboard => "Whose leaderboard?",
            };
            widgets::heading(canvas, heading, slice.y / 2.0);
            for (i, (press, area)) in self.presses().iter().zip(self.buttons.areas()).enumerate() {
                let (hover, focus) = (self.buttons.hover() == Some(i), self.buttons.focus() == i);
                match press {
                    Press::Level(index) => level(canvas, *area, &self.entries[*index], slice.x * 1.8, hover, focus),
                    Press::Back => widgets::button(canvas, *area, "Back", hover, focus),
                    Press::Previous => widgets::button(canvas, *area, "Previous", hover && self.page > 0, focus),
                    Press::Next => widgets::button(canvas, *area, "Next", hover && self.page + 1 < self.pages(), focus),
                }
            }
            let quiet = Style::new(TEXT, theme::QUIET).centred().middle();
            if self.pages() > 1 {
                let page = format!("Page {} of {}", self.page + 1, self.pages());
                canvas.text(&page, Vec2::new(frame.size.x / 2.0 - slice.x, frame.size.y - FOOT - ROW_BUTTON.y / 2.0), quiet);
            }
            if self.entries.is_empty() {
                canvas.text("There are no levels here yet.", frame.size / 2.0, quiet);
            }
            if let Some(problems) = &self.problems {
                widgets::curtain(canvas, 0.7);
                problems.draw(canvas);
            }
        }
    }

    fn level(canvas: &Canvas, area: Area, entry: &Entry, widest: f32, hover: bool, focus: bool) {
        widgets::button_box(canvas, area, hover, focus);
        let broken = entry.title.is_err();
        let colour = if broken { theme::QUIET } else { theme::TEXT };
        let centre = area.centre();
        widgets::fitted(canvas, &entry.name, centre, area.size.x - 16.0, &[HEADING, BUTTON_TEXT, TEXT, DETAILS], colour);
        let corner = Vec2::new(area.max().x - 18.0, area.min.y + 18.0);
        if broken {
            canvas.rounded(Area::around(corner, Vec2::new(4.0, 12.0)), 2.0, theme::BAD);
            canvas.disc(corner + Vec2::new(0.0, 11.0), 2.5, theme::BAD);
        } else if entry.completed {
            canvas.line(corner + Vec2::new(-7.0, 0.0), corner + Vec2::new(-2.0, 5.0), 3.0, theme::GOOD);
            canvas.line(corner + Vec2::new(-2.5, 5.0), corner + Vec2::new(7.0, -5.0), 3.0, theme::GOOD);
        }
        let (below, colour) = match &entry.title {
            Ok(title) if *title == entry.name => return,
            Ok(title) => (title.as_str(), theme::QUIET),
            Err(_) => ("does not load", theme::BAD),
        };
        let at = Vec2::new(centre.x, area.max().y + TITLE_BELOW);
        widgets::fitted(canvas, below, at, widest, &[TEXT], colour);
    }
}
