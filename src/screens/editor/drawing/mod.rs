//! The editor on the screen: the picture and what lies on it, then the panels around it.

mod overlay;
mod panels;
mod picture;

use super::ask::Ask;
use super::hand::{Drag, Handle, stream_zone};
use super::layout::{BETWEEN, INSIDE, PROBLEM_LINES};
use super::{AT_LEFT, COMMANDS, Editor, Tool};
use crate::draw::layout::{Area, BUTTON_TEXT, DETAILS, PADDING, TEXT, Vec2};
use crate::draw::{Canvas, Colour, Image, Style};
use crate::level::document::{Column, Kind, Place, RowId, number};
use crate::physics::DVec2;
use crate::view::{theme, widgets};
use std::collections::BTreeMap;
use std::path::PathBuf;

/// The pictures of the level that is edited, read when they are first drawn; `None` is no picture.
pub type Sheets = BTreeMap<PathBuf, Option<Image>>;

/// The colours of kinds: those of the game, where it has one.
fn colour(kind: Kind) -> Colour {
    let of = |r, g, b| Colour::of([r, g, b]);
    match kind {
        Kind::Setting | Kind::Text => theme::text(),
        Kind::Ship => theme::text(),
        Kind::Solid => theme::solid_top(),
        Kind::Mover => of(120, 150, 190),
        Kind::Door => of(190, 140, 90),
        Kind::Switch => of(110, 200, 220),
        Kind::Object => theme::quiet(),
        Kind::Key => theme::accent(),
        Kind::Pad => theme::player_objective(),
        Kind::KeyPad => theme::physics_objective(),
        Kind::Deadly => theme::bad(),
        Kind::Stream => of(150, 170, 200),
        Kind::Fluid => of(70, 130, 190),
        Kind::Gravity => of(150, 110, 210),
        Kind::Pod => theme::good(),
        Kind::Picture => of(140, 140, 140),
    }
}

/// What a block is made of, as a shade of its fill.
fn material(name: &str) -> Colour {
    let of = |r, g, b| Colour::of([r, g, b]);
    match name.to_ascii_lowercase().as_str() {
        "steel" => of(92, 106, 124),
        "ice" => of(120, 160, 180),
        "rubber" => of(48, 50, 58),
        "wood" => of(112, 84, 60),
        "glass" => of(88, 122, 128),
        "trampoline" => of(96, 60, 92),
        _ => theme::solid(),
    }
}

/// A rectangle's edge, inside it: at least a pixel of the window.
fn edge(canvas: &Canvas, area: Area, width: f32, colour: Colour) {
    canvas.rectangle_edge(area, width.max(canvas.frame().pixel), colour);
}

/// What there was no room for, where it is pointed at: it is shown in whole.
struct Tip {
    pointer: Vec2,
    whole: Option<String>,
}

impl Tip {
    /// A line of text as far as there is room; where it is cut and pointed at, in that area, it is to be shown in whole.
    fn cut(&mut self, canvas: &Canvas, text: &str, area: Area, room: f32, style: Style) -> String {
        let shown = widgets::cut(canvas, text, room, style);
        if shown != text && area.contains(self.pointer) {
            self.whole = Some(text.to_owned());
        }
        shown
    }

    /// The help of a column, where its name is pointed at, in that area.
    fn explain(&mut self, column: &Column, area: Area) {
        if area.contains(self.pointer) {
            self.whole = Some(column.in_words());
        }
    }
}

impl Editor {
    /// Draws all of it; `time` (s) makes the caret blink, and `fps` is how often it is drawn, 1/s.
    pub fn draw_all(&self, canvas: &Canvas, time: f64, fps: f64) {
        self.draw_picture(canvas);
        canvas.end_layer();
        self.draw_selection(canvas);
        canvas.end_layer();
        self.draw_map(canvas);
        let mut tip = Tip { pointer: self.pointer, whole: None };
        self.draw_commands(canvas, &mut tip);
        self.draw_tools(canvas);
        self.draw_panel(canvas, time, &mut tip);
        self.draw_problems(canvas, fps, &mut tip);
        if let Some(words) = &tip.whole {
            self.draw_banner(canvas, words);
        }
        if let Some(ask) = &self.ask {
            panels::draw_ask(ask, canvas);
        }
    }
}

/// A short arrow around a point.
fn arrow(canvas: &Canvas, middle: Vec2, way: Vec2, colour: Colour) {
    let (tip, tail) = (middle + way * 16.0, middle - way * 16.0);
    canvas.line(tail, tip - way * 6.0, 2.0, colour);
    let side = Vec2::new(-way.y, way.x) * 5.0;
    canvas.convex(&[tip, tip - way * 9.0 + side, tip - way * 9.0 - side], colour);
}
