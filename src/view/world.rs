//! The static world: background, graph paper, solid rectangles by material, the words written in the level.

use super::art::{Art, Tile};
use super::camera::Viewport;
use super::canvas::{Canvas, Style};
use super::edges::{Edge, Side};
use super::layout::TEXT_SIZES;
use super::pictures::Pictures;
use super::theme::{self, faded, rgb};
use crate::level::Level;
use crate::physics::{Aabb, DVec2};
use macroquad::color::{Color, WHITE};
use macroquad::math::Rect;
use macroquad::shapes::draw_rectangle;
use macroquad::texture::{DrawTextureParams, draw_texture_ex};

/// What lies outside of a level that is smaller than the window.
const OUTSIDE: Color = rgb(0x0A0D12);
/// How much of the graph paper shows over an author's picture.
const PAPER_OVER_PICTURE: f32 = 0.45;
/// A metre of the fine graph paper narrower than this is left out, canvas units: it would be a grey haze.
const FINEST_PAPER: f64 = 8.0;

/// The ground and, over it, the author's picture and the graph paper: a fine line each metre, a heavy one each ten.
pub fn draw_ground(level: &Level, pictures: &Pictures, view: &Viewport, canvas: &Canvas) {
    let all = view.rect(&Aabb::new(DVec2::ZERO, level.size));
    let picture = level.background.as_ref().and_then(|path| pictures.get(path));
    if let Some(texture) = picture {
        let params = DrawTextureParams { dest_size: Some(all.size()), ..DrawTextureParams::default() };
        draw_texture_ex(texture, all.x, all.y, WHITE, params);
    }
    let strength = if picture.is_some() { PAPER_OVER_PICTURE } else { 1.0 };
    let fine = view.scale() >= FINEST_PAPER;
    for heavy in [false, true] {
        if heavy || fine {
            paper_lines(level, view, canvas, heavy, strength);
        }
    }
}

fn paper_lines(level: &Level, view: &Viewport, canvas: &Canvas, heavy: bool, strength: f32) {
    let visible = view.visible();
    let (from, to) = (visible.min.max(DVec2::ZERO), visible.max.min(level.size));
    let shown = view.rect(&Aabb::new(from, to));
    let width = canvas.frame().pixel * if heavy { 2.0 } else { 1.0 };
    let colour = faded(if heavy { theme::GRID_HEAVY } else { theme::GRID_FINE }, strength);
    let lines = |from: f64, to: f64| (from.ceil() as i64..=to.floor() as i64).filter(move |i| (i % 10 == 0) == heavy);
    for x in lines(from.x, to.x) {
        let at = view.rect(&Aabb::around(DVec2::new(x as f64, 0.0), DVec2::ZERO)).x;
        draw_rectangle(at - (width * 0.5).floor(), shown.y, width, shown.h, colour);
    }
    for y in lines(from.y, to.y) {
        let at = view.rect(&Aabb::around(DVec2::new(0.0, y as f64), DVec2::ZERO)).y;
        draw_rectangle(shown.x, at - (width * 0.5).floor(), shown.w, width, colour);
    }
}

/// The solid rectangles in view, each in its material, then their open edges.
pub fn draw_solids(level: &Level, edges: &[Edge], art: &Art, view: &Viewport) {
    let visible = view.visible();
    for solid in level.world.iter().filter(|solid| solid.bounds.touches(&visible, 0.0)) {
        art.fill(Tile::Material(solid.material.name), &solid.bounds, view, WHITE);
    }
    for edge in edges {
        let reach = Aabb::new(edge.from, edge.to);
        if reach.touches(&visible, 0.1) {
            draw_edge(edge, &view.rect(&reach), level.world[edge.solid].material.name);
        }
    }
}

/// A line inside the rectangle: bright on top, faint at the sides, dark below; glass is bright all round.
fn draw_edge(edge: &Edge, line: &Rect, material: &str) {
    let bright = match material {
        "Glass" => rgb(0xCDEBFF),
        "Ice" => rgb(0xDDF2FF),
        "Wood" => rgb(0xA88B70),
        "Rubber" => rgb(0x4E586B),
        "Steel" => rgb(0x9AA9BF),
        _ => theme::SOLID_TOP,
    };
    let (colour, width) = match edge.side {
        Side::Top => (bright, 3.0),
        Side::Bottom if material != "Glass" => (faded(rgb(0x000000), 0.35), 2.0),
        Side::Bottom | Side::Left | Side::Right => (faded(bright, if material == "Glass" { 0.9 } else { 0.45 }), 2.0),
    };
    match edge.side {
        Side::Top => draw_rectangle(line.x, line.y, line.w, width, colour),
        Side::Bottom => draw_rectangle(line.x, line.y - width, line.w, width, colour),
        Side::Left => draw_rectangle(line.x, line.y, width, line.h, colour),
        Side::Right => draw_rectangle(line.x - width, line.y, width, line.h, colour),
    }
}

/// The line along the level's edge, which is solid, and beyond it, where the level is smaller than the window, nothing.
pub fn draw_level_edge(level: &Level, view: &Viewport, canvas: &Canvas) {
    let all = view.rect(&Aabb::new(DVec2::ZERO, level.size));
    let (size, width) = (canvas.size(), 2.0);
    draw_rectangle(0.0, 0.0, size.x, all.y, OUTSIDE);
    draw_rectangle(0.0, all.bottom(), size.x, size.y - all.bottom(), OUTSIDE);
    draw_rectangle(0.0, all.y, all.x, all.h, OUTSIDE);
    draw_rectangle(all.right(), all.y, size.x - all.right(), all.h, OUTSIDE);
    draw_rectangle(all.x, all.y, all.w, width, theme::SOLID_TOP);
    draw_rectangle(all.x, all.bottom() - width, all.w, width, theme::SOLID_TOP);
    draw_rectangle(all.x, all.y, width, all.h, theme::SOLID_TOP);
    draw_rectangle(all.right() - width, all.y, width, all.h, theme::SOLID_TOP);
}

/// The words written in the level, each in the size of type next to the author's.
pub fn draw_texts(level: &Level, view: &Viewport, canvas: &Canvas) {
    for text in &level.texts {
        let wanted = view.length(text.size);
        let size = TEXT_SIZES.into_iter().min_by(|a, b| (a - wanted).abs().total_cmp(&(b - wanted).abs())).unwrap_or(wanted);
        canvas.text(&text.text, view.point(text.position), Style::new(size, theme::TEXT));
    }
}
