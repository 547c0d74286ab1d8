//! A page of cards, one a level, used twice: to choose what to play and to choose whose leaderboard to see.

use super::library::Refusal;
use super::{Buttons, Input, Key, Miniature, Problems, Request, Visit};
use crate::game::Medals;
use crate::level::Awards;
use crate::settings::Action;
use crate::view::layout::{Area, Frame, GAP, ROW_BUTTON, Vec2};

/// Levels a page.
pub const PAGE: usize = 15;
/// From the canvas' sides to the cards, and from its top: the heading.
const SIDE: f32 = 40.0;
const HEAD: f32 = 88.0;
/// Between two cards.
const BETWEEN: f32 = 24.0;
/// From the canvas' bottom to the buttons below the cards, and from those to the cards.
const FOOT: f32 = 24.0;
const ABOVE_FOOT: f32 = 24.0;
/// How much wider than high a card looks best.
const SHAPE: f32 = 1.3;
/// No card is larger: a single level does not want the whole window.
const LARGEST: Vec2 = Vec2::new(900.0, 600.0);

/// What a level is chosen for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// To play it.
    Play,
    /// To see its leaderboard.
    Leaderboard,
}

/// A level in the list.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// Its folder's name.
    pub name: String,
    /// Its title and what it looks like, or why it does not load.
    pub level: Result<(String, Miniature), Refusal>,
    /// The best time of whoever plays without help, s; `None` where there is none.
    pub best: Option<f64>,
    /// What its medals ask for.
    pub awards: Awards,
    /// What it has brought whoever plays.
    pub medals: Medals,
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
        let cards = cards(self.entries.len().min(PAGE), &input.frame);
        self.buttons.place(presses.iter().map(|press| place(*press, &cards, &input.frame)).collect());
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
        } else if let Some(visit) = self.visit(input, &presses) {
            return Some(Request::Flights(visit));
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

    /// The level whose flights are asked for: that under a right click, or that which has the keyboard.
    fn visit(&self, input: &Input, presses: &[Press]) -> Option<Visit> {
        let under = || self.buttons.areas().iter().position(|area| area.contains(input.pointer));
        let at = if input.acts(Action::Details) { Some(self.buttons.focus()) } else { under().filter(|_| input.right_click) };
        let Press::Level(index) = *presses.get(at?)? else { return None };
        let Entry { name, level, .. } = &self.entries[index];
        let back = Box::new(Request::LevelSelect(self.purpose));
        level.is_ok().then(|| Visit { level: name.clone(), flown: None, back })
    }

    fn press(&mut self, press: Press) -> Option<Request> {
        match press {
            Press::Back => return Some(Request::Menu),
            Press::Previous => self.turn_to(self.page.saturating_sub(1)),
            Press::Next => self.turn_to(self.page + 1),
            Press::Level(index) => {
                let Entry { name, level, .. } = self.entries[index].clone();
                match (level, self.purpose) {
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

/// The places of a page's cards: as many across as make the cards largest, all the window between the heading and the foot.
fn cards(count: usize, frame: &Frame) -> Vec<Area> {
    let room = Area {
        min: Vec2::new(SIDE, HEAD),
        size: Vec2::new(frame.size.x - 2.0 * SIDE, frame.size.y - HEAD - FOOT - ROW_BUTTON.y - ABOVE_FOOT),
    };
    let size = |across: usize| {
        let grid = Vec2::new(across as f32, count.div_ceil(across) as f32);
        (room.size - (grid - 1.0) * BETWEEN) / grid
    };
    // Of a card's size only as much counts as has a good shape.
    let worth = |across: &usize| size(*across).x.min(size(*across).y * SHAPE);
    // Of equal ones the last: the fewest across leave the fewest gaps.
    let across = (1..=count).rev().max_by(|a, b| worth(a).total_cmp(&worth(b))).unwrap_or(1);
    let size = size(across).min(LARGEST);
    let down = count.div_ceil(across);
    let place = |index: usize| {
        let (column, row) = (index % across, index / across);
        // The last row stands in the middle when it is not full, and so do cards that are as large as any.
        let in_row = across.min(count - row * across);
        let all = Vec2::new(in_row as f32, down as f32) * (size + BETWEEN) - BETWEEN;
        let first = room.centre() - all / 2.0;
        Area { min: first + Vec2::new(column as f32, row as f32) * (size + BETWEEN), size }
    };
    (0..count).map(place).collect()
}

/// Where a button is: a level's card, the others in a row below the cards.
fn place(press: Press, cards: &[Area], frame: &Frame) -> Area {
    let below = |left: f32| Area { min: Vec2::new(left, frame.size.y - FOOT - ROW_BUTTON.y), size: ROW_BUTTON };
    match press {
        Press::Level(index) => cards[index % PAGE],
        Press::Back => below(SIDE),
        Press::Previous => below(frame.size.x - SIDE - 2.0 * ROW_BUTTON.x - GAP),
        Press::Next => below(frame.size.x - SIDE - ROW_BUTTON.x),
    }
}

#[cfg(feature = "window")]
mod drawing {
    use super::{Entry, FOOT, HEAD, LevelSelect, Press, Purpose};
    use crate::screens::scoring::precise;
    use crate::view::canvas::{Canvas, Style};
    use crate::view::layout::{Area, BUTTON_TEXT, DETAILS, HEADING, ROW_BUTTON, TEXT, Vec2};
    use crate::view::{medals, theme, widgets};

    /// From a card's edge to what is on it.
    const INSIDE: f32 = 12.0;
    /// Height of the words below a card's picture, in lines of text.
    const WORDS: f32 = 2.4;

    impl LevelSelect {
        /// Draws the cards, and the problems above them.
        pub fn draw(&self, canvas: &Canvas) {
            let frame = canvas.frame();
            widgets::graph_paper(canvas);
            let heading = match self.purpose {
                Purpose::Play => "Choose a level",
                Purpose::Leaderboard => "Whose leaderboard?",
            };
            widgets::heading(canvas, heading, HEAD / 2.0 - 10.0);
            let hint = Style::new(DETAILS, theme::quiet()).centred().middle();
            canvas.text("Tab or a right click: the flights of a level", Vec2::new(frame.size.x / 2.0, HEAD - 16.0), hint);
            for (i, (press, area)) in self.presses().iter().zip(self.buttons.areas()).enumerate() {
                let (hover, focus) = (self.buttons.hover() == Some(i), self.buttons.focus() == i);
                match press {
                    Press::Level(index) => card(canvas, *area, &self.entries[*index], hover, focus),
                    Press::Back => widgets::button(canvas, *area, "Back", hover, focus),
                    Press::Previous => widgets::button(canvas, *area, "Previous", hover && self.page > 0, focus),
                    Press::Next => widgets::button(canvas, *area, "Next", hover && self.page + 1 < self.pages(), focus),
                }
            }
            let quiet = Style::new(TEXT, theme::quiet()).centred().middle();
            if self.pages() > 1 {
                let page = format!("Page {} of {}", self.page + 1, self.pages());
                canvas.text(&page, Vec2::new(frame.size.x / 2.0, frame.size.y - FOOT - ROW_BUTTON.y / 2.0), quiet);
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

    /// A level's picture, its name and title, and below them what whoever plays has reached.
    fn card(canvas: &Canvas, area: Area, entry: &Entry, hover: bool, focus: bool) {
        widgets::button_box(canvas, area, hover, focus);
        let line = canvas.line_height(TEXT);
        let inner = area.inset(INSIDE);
        let picture = Area { min: inner.min, size: Vec2::new(inner.size.x, inner.size.y - WORDS * line) };
        let middle = |lines: f32| Vec2::new(inner.centre().x, picture.max().y + lines * line);
        let fitted = |text: &str, lines: f32, sizes: &[f32], colour| {
            widgets::fitted(canvas, text, middle(lines), inner.size.x, sizes, colour);
        };
        match &entry.level {
            Ok((title, miniature)) => {
                miniature.draw(canvas, picture);
                let named = if *title == entry.name { title.clone() } else { format!("{} · {title}", entry.name) };
                let sizes: &[f32] = if area.size.x > 400.0 { &[BUTTON_TEXT, TEXT, DETAILS] } else { &[TEXT, DETAILS] };
                fitted(&named, 0.9, sizes, theme::text());
                match entry.medals.medal {
                    Some(_) => {
                        let (style, at) = (Style::new(TEXT, theme::text()).mono().middle(), middle(1.95));
                        let time = entry.best.map_or("with help".to_owned(), precise);
                        let width = canvas.width(&time, style);
                        // The medals go before the time, and all of it stands in the middle.
                        let room = 28.0 * medals::offered(&entry.awards) as f32;
                        let left = at.x - (room + width) / 2.0;
                        canvas.text(&time, Vec2::new(left + room + 2.0, at.y), style);
                        medals::draw_earned(canvas, entry.medals, &entry.awards, Vec2::new(left + 11.0, at.y), 11.0);
                    }
                    None => fitted("not done yet", 1.95, &[TEXT, DETAILS], theme::quiet()),
                }
            }
            Err(_) => {
                let sign = picture.centre();
                widgets::fitted(canvas, &entry.name, sign, picture.size.x, &[HEADING, BUTTON_TEXT, TEXT, DETAILS], theme::quiet());
                fitted("does not load", 0.9, &[TEXT, DETAILS], theme::bad());
                let corner = Vec2::new(area.max().x - 18.0, area.min.y + 22.0);
                canvas.rounded(Area::around(corner, Vec2::new(4.0, 12.0)), 2.0, theme::bad());
                canvas.disc(corner + Vec2::new(0.0, 11.0), 2.5, theme::bad());
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cards_fill_the_page_whatever_their_number() {
        for (width, height) in [(1280.0, 720.0), (900.0, 500.0), (1920.0, 1080.0), (600.0, 1000.0), (3000.0, 500.0)] {
            let frame = Frame::of_window(Vec2::new(width, height));
            for count in 1..=PAGE {
                let cards = cards(count, &frame);
                let (first, last) = (cards[0], cards[count - 1]);
                let foot = frame.size.y - FOOT - ROW_BUTTON.y;
                assert!(cards.iter().all(|card| card.min.x >= SIDE - 0.1 && card.max().x <= frame.size.x - SIDE + 0.1));
                assert!(first.min.y >= HEAD - 0.1 && last.max().y <= foot - ABOVE_FOOT + 0.1);
                for (i, card) in cards.iter().enumerate() {
                    assert!(card.size.min_element() > 100.0, "{count} cards in {width} × {height}: {card:?}");
                    assert!(cards[i + 1..].iter().all(|other| card.max().x < other.min.x || card.max().y < other.min.y));
                }
                let filled = cards.iter().map(|card| card.size.element_product()).sum::<f32>();
                let room = (frame.size.x - 2.0 * SIDE) * (foot - ABOVE_FOOT - HEAD);
                assert!(
                    filled > 0.5 * room || first.size == LARGEST || count < 3,
                    "{count} cards in {width} × {height}: {}",
                    filled / room
                );
            }
        }
    }
}
