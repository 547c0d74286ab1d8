//! The list of levels on the screen.

use super::places::{FOOT, FOOT_BUTTON, HEAD, SIDE};
use super::{Entry, LevelSelect, Pick, Press, Purpose};
use crate::draw::{Canvas, Style};
use crate::number::clock;
use crate::view::layout::{Area, BUTTON_TEXT, DETAILS, HEADING, ROW_BUTTON, TEXT, Vec2};
use crate::view::terrain::Tint;
use crate::view::{medals, theme, widgets};

/// From a card's edge to what is on it.
const INSIDE: f32 = 12.0;
/// Height of the words below a card's picture, in lines of text.
const WORDS: f32 = 2.4;

impl LevelSelect {
    /// Draws the cards, and the problems above them.
    pub fn draw(&self, canvas: &Canvas, time: f64) {
        let frame = canvas.frame();
        widgets::graph_paper(canvas);
        let heading = match (self.purpose, self.pick) {
            (_, Some(Pick::Copy)) => "Which level is to be copied?",
            (_, Some(Pick::Rename)) => "Which level is to be renamed?",
            (Purpose::Play, None) => "Choose a level",
            (Purpose::Leaderboard, None) => "Whose leaderboard?",
            (Purpose::Edit, None) => "Edit a level",
        };
        widgets::heading(canvas, heading, HEAD / 2.0);
        let found = if self.find.is_empty() { "type to find one".to_owned() } else { format!("find: {}_", self.find) };
        let colour = if self.find.is_empty() { theme::quiet() } else { theme::accent() };
        canvas.text(&found, Vec2::new(frame.size.x - SIDE, HEAD / 2.0), Style::new(TEXT, colour).middle().right());
        for (i, (press, area)) in self.presses().iter().zip(self.buttons.areas()).enumerate() {
            let (hover, focus) = (self.buttons.hover() == Some(i), self.buttons.focus() == i);
            match press {
                Press::Level(index) => card(canvas, *area, &self.entries[*index], hover, focus),
                Press::Back => widgets::button(canvas, *area, "Back", hover, focus),
                Press::Previous => widgets::button(canvas, *area, "Previous", hover && self.page > 0, focus),
                Press::Next => widgets::button(canvas, *area, "Next", hover && self.page + 1 < self.pages(), focus),
                Press::Edit => widgets::button(canvas, *area, "Edit", hover, focus),
                Press::New => widgets::button(canvas, *area, "New", hover, focus),
                Press::Copy => widgets::button(canvas, *area, "Copy", hover, focus),
                Press::Rename => widgets::button(canvas, *area, "Rename", hover, focus),
            }
        }
        let quiet = Style::new(TEXT, theme::quiet()).centred().middle();
        if self.pages() > 1 {
            let page = format!("Page {} of {}", self.page + 1, self.pages());
            canvas.text(
                &page,
                Vec2::new(frame.size.x - SIDE - 2.0 * FOOT_BUTTON.x - 100.0, frame.size.y - FOOT - ROW_BUTTON.y / 2.0),
                quiet,
            );
        }
        if self.entries.is_empty() {
            canvas.text("There are no levels here yet.", frame.size / 2.0, quiet);
        }
        if self.found.is_empty() && !self.entries.is_empty() {
            canvas.text("No level has such a name or title.", frame.size / 2.0, quiet);
        }
        if let Some(asked) = &self.prompt {
            asked.0.draw(canvas, time);
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
        None => {
            widgets::fitted(
                canvas,
                &entry.name,
                picture.centre(),
                picture.size.x,
                &[HEADING, BUTTON_TEXT, TEXT, DETAILS],
                theme::quiet(),
            );
            fitted("loading …", 0.9, &[TEXT, DETAILS], theme::quiet());
        }
        Some(Ok((title, miniature))) => {
            miniature.draw(&Tint::of(&entry.name), canvas, picture);
            let named = if *title == entry.name { title.clone() } else { format!("{} · {title}", entry.name) };
            let sizes: &[f32] = if area.size.x > 400.0 { &[BUTTON_TEXT, TEXT, DETAILS] } else { &[TEXT, DETAILS] };
            fitted(&named, 0.9, sizes, theme::text());
            match entry.medals.medal {
                Some(_) => {
                    let (style, at) = (Style::new(TEXT, theme::text()).mono().middle(), middle(1.95));
                    let time = entry.best.map_or("with help".to_owned(), clock);
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
        Some(Err(_)) => {
            let sign = picture.centre();
            widgets::fitted(canvas, &entry.name, sign, picture.size.x, &[HEADING, BUTTON_TEXT, TEXT, DETAILS], theme::quiet());
            fitted("does not load", 0.9, &[TEXT, DETAILS], theme::bad());
            let corner = Vec2::new(area.max().x - 18.0, area.min.y + 22.0);
            canvas.rounded(Area::around(corner, Vec2::new(4.0, 12.0)), 2.0, theme::bad());
            canvas.disc(corner + Vec2::new(0.0, 11.0), 2.5, theme::bad());
        }
    }
}
