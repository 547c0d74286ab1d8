//! The rail stands away from the middle, where the ship is. Panels stand below it, and beside it where there is too little room.

use super::Tool;
use crate::draw::layout::{Area, DETAILS, Frame, GRID, LINE, MONO_ADVANCE, Vec2, text_room};
use crate::{view::hud::HudLayout, words::tr};

const RAIL_GAP: f32 = 4.0;

/// A button a tool, from the top, below the head-up display, in as many columns as the frame's height asks for.
pub fn rail(frame: &Frame) -> Vec<Area> {
    let top = HudLayout::new(frame).status.max().y + 2.0 * GRID;
    let text = frame.text_height(DETAILS);
    let widest = Tool::ALL.iter().map(|tool| text_room(tr(tool.name()), text).x).fold(0.0, f32::max);
    let size = Vec2::new(widest + 2.0 * GRID, text * LINE + GRID);
    let (pitch, count) = (size + RAIL_GAP, Tool::ALL.len());
    let rows = (((frame.size.y - GRID - top) / pitch.y) as usize).clamp(1, count);
    let button =
        |i: usize| Area { min: Vec2::new(2.0 * GRID, top) + pitch * Vec2::new((i / rows) as f32, (i % rows) as f32), size };
    (0..count).map(button).collect()
}

/// Where panels end: above the fuel bar and above `sign`, the room that signs need at the frame's foot.
pub fn foot(frame: &Frame, sign: f32) -> f32 {
    HudLayout::new(frame).fuel.min.y.min(frame.size.y - sign) - GRID
}

/// Panels one below the other from the foot of the rail on, in as many columns as it takes; the first has the rail above it.
pub fn dock(foot: f32, rail: &[Area], sizes: &[Vec2]) -> Vec<Area> {
    let Some(first) = rail.first() else { return Vec::new() };
    let end = rail.iter().fold(first.max(), |end, area| end.max(area.max()));
    let mut at = Vec2::new(first.min.x, end.y + GRID);
    let mut widest = end.x - first.min.x;
    let place = |size: &Vec2| {
        if at.y + size.y > foot {
            at = Vec2::new(at.x + widest + GRID, first.min.y.min(foot - size.y).max(GRID));
            widest = 0.0;
        }
        let area = Area { min: at, size: *size };
        at.y += size.y + GRID;
        widest = widest.max(size.x);
        area
    };
    sizes.iter().map(place).collect()
}

pub fn line(frame: &Frame) -> f32 {
    frame.text_height(DETAILS) * LINE
}

/// The width of that many characters of a panel's lines.
pub fn width(frame: &Frame, characters: usize) -> f32 {
    characters as f32 * MONO_ADVANCE * frame.text_height(DETAILS)
}

pub fn row(frame: &Frame, from: Vec2, words: &[&str]) -> Vec<Area> {
    let mut left = from.x;
    let button = |words: &&str| {
        let size = Vec2::new(width(frame, tr(words).chars().count()) + 2.0 * GRID, line(frame) + GRID);
        let area = Area { min: Vec2::new(left, from.y), size };
        left += size.x + 0.5 * GRID;
        area
    };
    words.iter().map(button).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn panels_keep_apart_and_above_the_fuel() {
        for (w, h, text) in [(1280.0, 720.0, 1.0), (900.0, 500.0, 1.0), (900.0, 500.0, 1.5)] {
            let frame = Frame::of_window(Vec2::new(w, h)).with_text(text);
            let rail: Vec<Area> = (0..7).map(|i| Area::new(16.0, 110.0 + 34.0 * i as f32, 150.0, 30.0)).collect();
            let sizes = [Vec2::new(200.0, 50.0), Vec2::new(240.0, 100.0), Vec2::new(360.0, 400.0)];
            let areas = dock(foot(&frame, 0.0), &rail, &sizes);
            let all: Vec<Area> = rail.iter().chain(&areas).copied().collect();
            for (i, a) in all.iter().enumerate() {
                assert!(a.max().y < HudLayout::new(&frame).fuel.min.y);
                let apart = |b: &Area| (b.min - a.max()).max(a.min - b.max()).max_element() > 0.0;
                assert!(all[i + 1..].iter().all(apart), "{w} × {h}: {a:?}");
            }
            assert_eq!(areas[0].min.x, 16.0, "there is room below the rail");
        }
    }
}
