//! What the screens are made of: panels, buttons, headings.

use super::canvas::{Canvas, Style};
use super::layout::{Area, BUTTON_TEXT, CORNER, EDGE, HEADING, Vec2};
use super::theme;
use macroquad::color::Color;

/// From a button's edge out to its focus ring.
const RING_GAP: f32 = 4.0;

/// A panel with its edge.
pub fn panel(canvas: &Canvas, area: Area) {
    panel_in(canvas, area, theme::PANEL, theme::PANEL_EDGE);
}

/// A panel of other colours.
pub fn panel_in(canvas: &Canvas, area: Area, fill: Color, edge: Color) {
    canvas.rounded(area, CORNER, fill);
    canvas.rounded_edge(area, CORNER, EDGE, edge);
}

/// A button's box: hover lightens it, keyboard focus rings it.
pub fn button_box(canvas: &Canvas, area: Area, hover: bool, focus: bool) {
    panel_in(canvas, area, if hover { theme::PANEL_HOVER } else { theme::PANEL }, theme::PANEL_EDGE);
    if focus {
        focus_ring(canvas, area);
    }
}

/// A button with its words in the middle.
pub fn button(canvas: &Canvas, area: Area, label: &str, hover: bool, focus: bool) {
    button_box(canvas, area, hover, focus);
    canvas.text(label, area.centre(), Style::new(BUTTON_TEXT, theme::TEXT).centred().middle());
}

/// The ring around what has the keyboard.
pub fn focus_ring(canvas: &Canvas, area: Area) {
    canvas.rounded_edge(area.inset(-RING_GAP), CORNER + RING_GAP, EDGE, theme::ACCENT);
}

/// A screen's heading, in the middle of the canvas with its capitals around `y`.
pub fn heading(canvas: &Canvas, text: &str, y: f32) {
    canvas.text(text, Vec2::new(canvas.size().x / 2.0, y), Style::new(HEADING, theme::TEXT).centred().middle());
}

/// Darkens everything so far and starts a layer above it.
pub fn curtain(canvas: &Canvas, alpha: f32) {
    canvas.end_layer();
    canvas.convex(&corners(canvas.frame().area()), theme::faded(theme::GROUND, alpha));
}

fn corners(area: Area) -> [Vec2; 4] {
    let (a, b) = (area.min, area.max());
    [a, Vec2::new(b.x, a.y), b, Vec2::new(a.x, b.y)]
}
