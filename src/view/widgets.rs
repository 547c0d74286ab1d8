//! Drawings shared by the screens: panels, buttons, headings.

use super::theme;
use crate::draw::layout::{Area, BUTTON_TEXT, CORNER, DETAILS, EDGE, GRID, HEADING, TEXT, Vec2};
use crate::draw::{Canvas, Colour, Style};

/// From a button's edge out to its focus ring.
const RING_GAP: f32 = 4.0;

/// With its edge.
pub fn panel(canvas: &Canvas, area: Area) {
    panel_in(canvas, area, theme::panel(), theme::panel_edge());
}

pub fn panel_in(canvas: &Canvas, area: Area, fill: Colour, edge: Colour) {
    canvas.rounded(area, CORNER, fill);
    canvas.rounded_edge(area, CORNER, EDGE, edge);
}

/// Hover lightens the box, keyboard focus rings it.
pub fn button_box(canvas: &Canvas, area: Area, hover: bool, focus: bool) {
    panel_in(canvas, area, if hover { theme::panel_hover() } else { theme::button() }, theme::panel_edge());
    if focus {
        focus_ring(canvas, area);
    }
}

/// The words stand in the middle.
pub fn button(canvas: &Canvas, area: Area, label: &str, hover: bool, focus: bool) {
    keyed_button(canvas, area, (label, ""), (hover, focus));
}

/// The words stand in the middle with the key's name beside them.
pub fn keyed_button(canvas: &Canvas, area: Area, (label, key): (&str, &str), (hover, focus): (bool, bool)) {
    button_box(canvas, area, hover, focus);
    let key_style = Style::new(TEXT, theme::accent()).mono().middle();
    let beside = if key.is_empty() { 0.0 } else { canvas.width(key, key_style) + 1.5 * GRID };
    let room = area.size.x - 2.0 * GRID - beside;
    let fits = |size: &f32| canvas.width(label, Style::new(*size, theme::text())) <= room;
    let size = [BUTTON_TEXT, TEXT, DETAILS].into_iter().find(fits).unwrap_or(DETAILS);
    let style = Style::new(size, theme::text()).middle();
    let words = cut(canvas, label, room, style);
    let (width, middle) = (canvas.width(&words, style), area.centre());
    let left = middle.x - (width + beside) / 2.0;
    canvas.text(&words, Vec2::new(left, middle.y), style);
    canvas.text(key, Vec2::new(left + width + beside, middle.y), key_style.right());
}

/// The mark of the keyboard's focus.
pub fn focus_ring(canvas: &Canvas, area: Area) {
    canvas.rounded_edge(area.inset(-RING_GAP), CORNER + RING_GAP, EDGE, theme::accent());
}

/// The selected row of a list.
pub fn picked_row(canvas: &Canvas, area: Area) {
    canvas.rounded(area, 6.0, theme::panel_hover());
    canvas.rounded_edge(area, 6.0, EDGE, theme::accent());
}

/// In the middle of the canvas, its capitals around `y`.
pub fn heading(canvas: &Canvas, text: &str, y: f32) {
    canvas.text(text, Vec2::new(canvas.size().x / 2.0, y), Style::new(HEADING, theme::text()).centred().middle());
}

/// A line of text around its middle, at most `widest` wide: in the first of `sizes` that fits, else cut off with an ellipsis.
pub fn fitted(canvas: &Canvas, text: &str, middle: Vec2, widest: f32, sizes: &[f32], colour: Colour) {
    let style = |size: f32| Style::new(size, colour).centred().middle();
    if let Some(size) = sizes.iter().find(|size| canvas.width(text, style(**size)) <= widest) {
        return canvas.text(text, middle, style(*size));
    }
    let style = style(sizes.last().copied().unwrap_or(BUTTON_TEXT));
    canvas.text(&cut(canvas, text, widest, style), middle, style);
}

/// A line of text, cut off with an ellipsis where it is wider than `widest`.
pub fn cut(canvas: &Canvas, text: &str, widest: f32, style: Style) -> String {
    if canvas.width(text, style) <= widest {
        return text.to_owned();
    }
    let mut kept: Vec<char> = text.chars().collect();
    // Not letter by letter: a line may have thousands of them.
    let narrowest = style.size * 0.2;
    kept.truncate((widest / narrowest) as usize + 1);
    loop {
        kept.pop();
        let shortened = kept.iter().collect::<String>() + "…";
        if kept.is_empty() || canvas.width(&shortened, style) <= widest {
            return shortened;
        }
    }
}

/// Words in lines that are at most `widest` wide.
pub fn lines(canvas: &Canvas, words: &str, widest: f32, style: Style) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in words.split(' ') {
        match lines.last_mut() {
            Some(line) if canvas.width(&format!("{line} {word}"), style) <= widest => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// As large as a letter of twice that height.
pub fn tick(canvas: &Canvas, middle: Vec2, size: f32, colour: Colour) {
    let at = |x: f32, y: f32| middle + Vec2::new(x, y) * size;
    canvas.line(at(-0.9, 0.0), at(-0.25, 0.7), 3.0, colour);
    canvas.line(at(-0.25, 0.7), at(0.95, -0.7), 3.0, colour);
}

pub fn scroll_bar(canvas: &Canvas, track: Area, handle: Area, held: bool) {
    canvas.rounded(track, track.size.x / 2.0, theme::ground());
    canvas.rounded(handle, handle.size.x / 2.0, if held { theme::accent() } else { theme::solid_top() });
}

/// The paper of the notebook: small squares, heavy lines every ten.
pub fn graph_paper(canvas: &Canvas) {
    const SQUARE: f32 = 4.0 * GRID;
    let size = canvas.size();
    let across = (size.x / SQUARE).ceil() as usize;
    let down = (size.y / SQUARE).ceil() as usize;
    for heavy in [false, true] {
        let colour = if heavy { theme::grid_heavy() } else { theme::grid_fine() };
        let lines = |count: usize| (0..=count).filter(move |i| (i % 10 == 0) == heavy).map(|i| i as f32 * SQUARE);
        for x in lines(across) {
            canvas.hairline(Vec2::new(x, 0.0), Vec2::new(x, size.y), colour);
        }
        for y in lines(down) {
            canvas.hairline(Vec2::new(0.0, y), Vec2::new(size.x, y), colour);
        }
    }
}

/// Darkens everything so far and starts a layer above it.
pub fn curtain(canvas: &Canvas, alpha: f32) {
    canvas.end_layer();
    canvas.rectangle(Area::new(0.0, 0.0, canvas.size().x, canvas.size().y), theme::ground().faded(alpha));
}
