//! Words in the level: in the first view and on the map of every shipped level, in windows of three sizes, none lies on another, on a goal that
//! is not its own, on a plate, a fan or the ship's start.

use crate::support::shipped::{levels, load};
use resultant::draw::layout::{Area, Frame, Vec2};
use resultant::draw::{Canvas, Shape};
use resultant::game::Game;
use resultant::view::hud::HudShown;
use resultant::view::{GameView, Overlays, labels};

const WINDOWS: [Vec2; 3] = [Vec2::new(900.0, 500.0), Vec2::new(1280.0, 720.0), Vec2::new(1920.0, 1080.0)];
/// Letters reach this far above and below the baseline, in heights of the text.
const ABOVE: f32 = 0.72;
const BELOW: f32 = 0.18;

fn words(canvas: &Canvas) -> Vec<(String, Area)> {
    let shapes = canvas.shapes();
    let boxed = |shape: &Shape| {
        let Shape::Text { text, at, style } = shape else { return None };
        if style.colour.a == 0.0 {
            return None;
        }
        let (left, height) = (canvas.baseline(text, *at, *style), canvas.glyph_height(style.size) * canvas.frame().pixel);
        let min = left - Vec2::new(0.0, ABOVE * height);
        Some((text.clone(), Area { min, size: Vec2::new(canvas.width(text, *style), (ABOVE + BELOW) * height) }))
    };
    shapes.iter().filter_map(boxed).filter(|(_, area)| area.gap(&canvas.frame().area()) < 0.0).collect()
}

#[test]
fn no_label_lies_on_another_or_on_what_it_is_not_of() {
    let (mut problems, mut seen) = (Vec::new(), 0);
    for name in levels() {
        let level = load(&name);
        let game = Game::new(level.clone()).unwrap();
        for (size, map) in WINDOWS.into_iter().flat_map(|size| [false, true].map(|map| (size, map))) {
            let frame = Frame::of_window(size);
            let mut view = GameView::new(&game, &|_| None);
            let shown = HudShown { status: true, fuel: true, rivals: 0, medal: true };
            let overlays = Overlays { shown, map, ..Overlays::default() };
            view.update(&game, 1.0, 1.0 / 60.0, overlays, &frame);
            let canvas = Canvas::new(frame);
            view.draw(&game, 1.0, overlays, "", &canvas);
            let words = words(&canvas);
            seen += words.len();
            let display: Vec<Area> = view.hud.aside.homes().collect();
            let things: Vec<Area> = labels::things(&level, &view.viewport(&game, 1.0, &frame)).collect();
            let at = format!("level {name} in {size}{}", if map { ", the map" } else { "" });
            for (i, (text, area)) in words.iter().enumerate() {
                for (other, _) in words[i + 1..].iter().filter(|(_, other)| area.gap(other) < -0.5) {
                    problems.push(format!("{at}: {text:?} on {other:?}"));
                }
                if display.iter().any(|part| part.gap(area) < 0.0) {
                    continue; // It fades where something lies behind it.
                }
                let own = |thing: &Area, i| i < level.objectives.len() && thing.contains(area.min) && thing.contains(area.max());
                let on = things.iter().enumerate().filter(|(index, thing)| thing.gap(area) < -0.5 && !own(thing, *index));
                problems.extend(on.map(|(index, thing)| format!("{at}: {text:?} on the thing {index} at {:?}", thing.min)));
            }
        }
    }
    assert!(problems.is_empty(), "{}: {}", problems.len(), problems.join("\n"));
    assert!(seen > 1500, "{seen} words");
}
