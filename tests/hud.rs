//! At the start of every shipped level, in windows of several sizes and shapes, the head-up display covers no hazard, no goal and no text.
#![cfg(feature = "window")]

use resultant::level::{self, Level};
use resultant::physics::Aabb;
use resultant::view::camera::{Camera, Viewport, Window};
use resultant::view::layout::{Area, Frame, HudLayout, Vec2, nearest_size, text_room};
use std::path::Path;

/// Against how many most race. More need a wider strip, which what lies behind is seen through.
const RIVALS: usize = 2;
/// Pixels.
const WINDOWS: [Vec2; 4] = [Vec2::new(900.0, 500.0), Vec2::new(1280.0, 720.0), Vec2::new(1920.0, 1080.0), Vec2::new(720.0, 1280.0)];

/// The view of a level as it begins.
fn start(level: &Level, frame: &Frame) -> Viewport {
    let window = Window { size: frame.size.as_dvec2(), pixel: f64::from(frame.pixel) };
    let ship = level.player.position;
    Viewport::new(Camera::new(ship).focus(), ship, level.size, level.metre, window)
}

/// What has to be seen, by name, where it lies on the canvas.
fn shown(level: &Level, view: &Viewport, frame: &Frame) -> Vec<(String, Area)> {
    let area = |bounds: &Aabb| {
        let rect = view.rect(bounds);
        Area::new(rect.x, rect.y, rect.w, rect.h)
    };
    let named = |name: &'static str| move |bounds: &Aabb| (format!("{name} at {}", bounds.min * level.metre), area(bounds));
    let texts = level.texts.iter().map(|text| {
        let height = frame.text_height(nearest_size(view.length(text.size)));
        (text.text.clone(), Area { min: view.point(text.position), size: text_room(&text.text, height) })
    });
    let objectives = level.objectives.iter().map(|objective| named("the goal")(&objective.bounds));
    let obstacles = level.obstacles.iter().map(named("the death box"));
    let sources = level.streams.iter().map(|stream| named("the source of a stream")(&stream.source));
    obstacles.chain(objectives).chain(sources).chain(texts).collect()
}

#[test]
fn at_the_start_of_every_level_the_display_covers_no_hazard_no_goal_and_no_text() {
    let project = Path::new(env!("CARGO_MANIFEST_DIR"));
    let names = level::list(&project.join("levels"));
    assert!(names.len() >= 3);
    for name in names {
        let level = level::load(&project.join("levels").join(&name), project).unwrap_or_else(|e| panic!("{name}: {e:?}")).level;
        for window in WINDOWS {
            let frame = Frame::of_window(window);
            let view = start(&level, &frame);
            for (what, area) in shown(&level, &view, &frame) {
                let layout = HudLayout::new(&frame);
                for part in layout.areas().into_iter().chain([layout.race(&frame, RIVALS)]) {
                    let apart = (part.min - area.max()).max(area.min - part.max()).max_element();
                    assert!(apart >= 0.0, "level {name} in {window}: {what} ({area:?}) lies behind {part:?}");
                }
            }
        }
    }
}
