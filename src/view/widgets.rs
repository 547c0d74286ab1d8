//! Drawings shared by the screens: panels, buttons, headings. Medals of arrows: a ring, and in it one, two or three of them that lead up, so that
//! colour is not the only cue; for a level's own mark four that lead out.

use super::theme;
use crate::draw::layout::{self, Area, BUTTON_TEXT, CORNER, DETAILS, EDGE, GRID, HEADING, TEXT, Vec2};
use crate::draw::{Canvas, Colour, Style};
use crate::game::{Medal, Medals, Prize};
use crate::level::Awards;

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
    let whole = area.size.x - 2.0 * GRID;
    let beside = canvas.width(key, key_style) + 1.5 * GRID;
    // The key gives way to its word.
    let room_for_key = canvas.width(label, Style::new(DETAILS, theme::text())) + beside <= whole;
    let (key, beside) = if room_for_key && !key.is_empty() { (key, beside) } else { ("", 0.0) };
    let room = whole - beside;
    let fits = |size: &f32| canvas.width(label, Style::new(*size, theme::text())) <= room;
    let style = Style::new([BUTTON_TEXT, TEXT, DETAILS].into_iter().find(fits).unwrap_or(DETAILS), theme::text()).middle();
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
    kept.truncate((widest / (style.size * 0.2)) as usize + 1);
    loop {
        kept.pop();
        let shortened = kept.iter().collect::<String>() + "…";
        if kept.is_empty() || canvas.width(&shortened, style) <= widest {
            return shortened;
        }
    }
}

pub fn lines(canvas: &Canvas, words: &str, widest: f32, style: Style) -> Vec<String> {
    layout::lines(words, widest, |line| canvas.width(line, style))
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
    canvas.rectangle(canvas.frame().area(), theme::ground().faded(alpha));
}

/// Between neighbours in a row, in radii.
const APART: f32 = 2.4;

fn colour(prize: Prize) -> Colour {
    match prize {
        Prize::Medal(Medal::Bronze) => Colour::hex(0xC98A4B),
        Prize::Medal(Medal::Silver) => Colour::hex(0xBCC7D1),
        Prize::Medal(Medal::Gold) => Colour::hex(0xF4C542),
        Prize::Mark => Colour::hex(0x6FD3C1),
    }
}

/// A medal around a point; one that is not earned yet is a shadow of itself.
pub fn draw(canvas: &Canvas, prize: Prize, earned: bool, centre: Vec2, radius: f32) {
    let colour = if earned { colour(prize) } else { theme::quiet().faded(0.45) };
    if earned {
        canvas.disc(centre, radius, colour.faded(0.25));
    }
    canvas.ring(centre, radius, radius * 0.2, colour);
    let up = Vec2::new(0.0, -1.0);
    let arrow = |from: Vec2, along: Vec2, size: f32| {
        let at = |forward: f32, aside: f32| centre + (from + along * forward * size + along.perp() * aside * size) * radius;
        canvas.line(at(-0.5, 0.0), at(0.1, 0.0), radius * 0.22 * size, colour);
        canvas.convex(&[at(0.6, 0.0), at(0.0, 0.42), at(0.0, -0.42)], colour);
    };
    match prize {
        Prize::Medal(Medal::Bronze) => arrow(Vec2::ZERO, up, 1.0),
        Prize::Medal(Medal::Silver) => [-0.3, 0.3].into_iter().for_each(|x| arrow(Vec2::new(x, 0.0), up, 0.75)),
        Prize::Medal(Medal::Gold) => {
            [(-0.42, 0.2), (0.0, -0.12), (0.42, 0.2)].into_iter().for_each(|(x, y)| arrow(Vec2::new(x, y), up, 0.62));
        }
        Prize::Mark => [up, -up, up.perp(), -up.perp()].into_iter().for_each(|along| arrow(along * 0.36, along, 0.5)),
    }
}

/// The medals that a level shows beside each other: the best so far, and its mark.
pub fn offered(awards: &Awards) -> usize {
    1 + usize::from(awards.mark.is_some())
}

/// The earned medals of a level, from `first` to the right.
pub fn draw_earned(canvas: &Canvas, medals: Medals, awards: &Awards, first: Vec2, radius: f32) {
    if let Some(medal) = medals.medal {
        draw(canvas, Prize::Medal(medal), true, first, radius);
    }
    if medals.mark || awards.mark.is_some() {
        draw(canvas, Prize::Mark, medals.mark, first + Vec2::new(APART * radius, 0.0), radius);
    }
}
