//! The ground of the level, and its words. [`super::terrain`] draws the solids.

use super::camera::Viewport;
use super::pictures::Pictures;
use super::sky;
use super::terrain::Tint;
use super::theme;
use crate::draw::layout::{Area, nearest_size, text_room};
use crate::draw::{Canvas, Colour, Style};
use crate::level::{Level, Text};
use crate::physics::{Aabb, DVec2};
use crate::words::tr;

/// Opacity of the graph paper over an author's picture.
const PAPER_OVER_PICTURE: f32 = 0.45;
/// Fine graph paper is left out below this width of a metre, canvas units: it would be a grey haze.
const FINEST_PAPER: f64 = 8.0;

/// The most that the nearest size of type may exceed the author's.
const SNAPPED: f64 = 1.25;

/// The background (the author's picture, or the sky of the level's world) and the graph paper: a fine line each metre, a heavy one each ten.
pub fn draw_ground(level: &Level, tint: &Tint, pictures: &Pictures, (view, canvas): (&Viewport, &Canvas), time: f64) {
    let all = view.rect(&Aabb::new(DVec2::ZERO, level.size));
    let picture = level.background.as_ref().and_then(|path| pictures.get(path));
    if let Some(image) = picture {
        canvas.image(image, all, Colour::WHITE);
    } else if let Some(landscape) = level.landscape {
        sky::draw(landscape, view, canvas, time);
    }
    let strength = if picture.is_some() { PAPER_OVER_PICTURE } else { 1.0 };
    let fine = view.scale() >= FINEST_PAPER;
    for heavy in [false, true] {
        if heavy || fine {
            let colour = (if heavy { tint.heavy } else { tint.fine }).faded(strength);
            paper_lines(view, canvas, heavy, colour);
        }
    }
}

fn paper_lines(view: &Viewport, canvas: &Canvas, heavy: bool, colour: Colour) {
    let (visible, level) = (view.visible(), view.level());
    let (from, to) = (visible.min.max(level.min), visible.max.min(level.max));
    let shown = view.rect(&Aabb::new(from, to));
    let width = canvas.frame().pixel * if heavy { 2.0 } else { 1.0 };
    let lines = |from: f64, to: f64| (from.ceil() as i64..=to.floor() as i64).filter(move |i| (i % 10 == 0) == heavy);
    for x in lines(from.x, to.x) {
        let at = view.rect(&Aabb::around(DVec2::new(x as f64, 0.0), DVec2::ZERO)).min.x;
        canvas.rectangle(Area::new(at - (width * 0.5).floor(), shown.min.y, width, shown.size.y), colour);
    }
    for y in lines(from.y, to.y) {
        let at = view.rect(&Aabb::around(DVec2::new(0.0, y as f64), DVec2::ZERO)).min.y;
        canvas.rectangle(Area::new(shown.min.x, at - (width * 0.5).floor(), shown.size.x, width), colour);
    }
}

/// The level's words, each in the size of type nearest to the author's.
pub fn draw_texts(level: &Level, view: &Viewport, canvas: &Canvas) {
    for text in &level.texts {
        let size = nearest_size(view.length(text.size));
        let colour = text.colour.map_or_else(theme::text, Colour::of);
        canvas.text(tr(&text.text), view.point(text.position), Style::new(size, colour));
    }
}

/// The areas of the words, m: at least the room that they need.
pub fn text_areas(level: &Level) -> Vec<Aabb> {
    let area =
        |text: &Text| Aabb::new(text.position, text.position + text_room(tr(&text.text), text.size as f32).as_dvec2() * SNAPPED);
    level.texts.iter().map(area).collect()
}
