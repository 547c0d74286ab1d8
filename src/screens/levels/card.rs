//! A level's card. A level in the list: what is known of it without opening it.

use crate::draw::layout::{Area, BUTTON_TEXT, DETAILS, HEADING, TEXT, Vec2};
use crate::draw::{Canvas, Colour, Image, Style};
use crate::view::{theme, widgets};
use crate::{game::Medals, number::clock, ui::Touch, words::tr};
use crate::{level::Awards, level::Landscape, session::folder_watch::Stamp, session::library::Refusal};

const INSIDE: f32 = 12.0;
/// Height of the words below a card's picture, in lines of text.
const WORDS: f32 = 2.4;

/// A level's picture, its name and title, and below them what the player has reached. Who edits sees what the level's own flights prove.
pub(super) fn draw(canvas: &Canvas, area: Area, (entry, edits): (&LevelEntry, bool), touch: Touch) {
    widgets::button_box(canvas, area, touch.hover, touch.focus);
    let line = canvas.line_height(TEXT);
    let inner = area.inset(INSIDE);
    let picture = Area { min: inner.min, size: Vec2::new(inner.size.x, inner.size.y - WORDS * line) };
    let middle = |lines: f32| Vec2::new(inner.centre().x, picture.max().y + lines * line);
    let fitted = |text: &str, lines: f32, sizes: &[f32], colour| {
        widgets::fitted(canvas, text, middle(lines), inner.size.x, sizes, colour);
    };
    let show_name = || {
        let sizes = [HEADING, BUTTON_TEXT, TEXT, DETAILS];
        widgets::fitted(canvas, &entry.name, picture.centre(), picture.size.x, &sizes, theme::quiet());
    };
    match &entry.level {
        None => {
            show_name();
            fitted(tr("loading …"), 0.9, &[TEXT, DETAILS], theme::quiet());
        }
        Some(Ok((title, painting))) => {
            if let Some(Image::Painted(painted)) = painting {
                let pixels = Vec2::new(painted.width as f32, painted.height() as f32);
                let shown = Area::around(picture.centre(), pixels * (picture.size / pixels).min_element());
                canvas.image(&Image::Painted(painted.clone()), shown, Colour::WHITE);
                canvas.rectangle_edge(shown, 1.0, theme::panel_edge());
            }
            let named = if *title == entry.name { title.clone() } else { format!("{} · {}", entry.name, tr(title)) };
            let sizes: &[f32] = if area.size.x > 400.0 { &[BUTTON_TEXT, TEXT, DETAILS] } else { &[TEXT, DETAILS] };
            fitted(&named, 0.9, sizes, theme::text());
            match (entry.medals.medal, &entry.proven) {
                (_, Some(proven)) if edits => match proven[..] {
                    [] => fitted(tr("no flight proves it yet"), 1.95, &[TEXT, DETAILS], theme::quiet()),
                    _ => {
                        let names: Vec<&str> = proven.iter().map(|name| tr(name)).collect();
                        fitted(&tr!("proven: {names}", names = names.join(", ")), 1.95, &[TEXT, DETAILS], theme::good());
                    }
                },
                (Some(_), _) => {
                    let (style, at) = (Style::new(TEXT, theme::text()).mono().middle(), middle(1.95));
                    let time = entry.best.map_or(tr("with help").to_owned(), clock);
                    let width = canvas.width(&time, style);
                    // The medals go before the time, and all of it stands in the middle.
                    let room = 28.0 * widgets::offered(&entry.awards) as f32;
                    let left = at.x - (room + width) / 2.0;
                    canvas.text(&time, Vec2::new(left + room + 2.0, at.y), style);
                    widgets::draw_earned(canvas, entry.medals, &entry.awards, Vec2::new(left + 11.0, at.y), 11.0);
                }
                (None, _) => fitted(tr("not done yet"), 1.95, &[TEXT, DETAILS], theme::quiet()),
            }
        }
        Some(Err(_)) => {
            show_name();
            fitted(tr("does not load"), 0.9, &[TEXT, DETAILS], theme::bad());
            let corner = Vec2::new(area.max().x - 18.0, area.min.y + 22.0);
            canvas.rounded(Area::around(corner, Vec2::new(4.0, 12.0)), 2.0, theme::bad());
            canvas.disc(corner + Vec2::new(0.0, 11.0), 2.5, theme::bad());
        }
    }
}

#[derive(Clone, Debug, Default, PartialEq)]
pub struct LevelEntry {
    pub name: String,
    pub world: Option<Landscape>,
    /// Its title and what it looks like, or why it does not load; `None` until it has been in view.
    pub level: Option<Result<(String, Option<Image>), Refusal>>,
    /// What its folder looked like then.
    pub stamp: Stamp,
    /// Its title, as far as it has been looked for.
    pub title: Option<String>,
    /// The player's best time without help, s; `None` where there is none.
    pub best: Option<f64>,
    pub awards: Awards,
    pub medals: Medals,
    /// What its own flights prove, where it is not one of the game's.
    pub proven: Option<Vec<&'static str>>,
}

impl LevelEntry {
    /// Whether its name or title has these letters in it, which are small.
    pub(super) fn has(&self, letters: &str) -> bool {
        let has = |text: &str| text.to_lowercase().contains(letters);
        has(&self.name) || self.title.as_deref().is_some_and(|title| has(title) || has(tr(title)))
    }
}
