//! A game as it appears in a window.

use resultant::draw::layout::{Area, Frame, Vec2};
use resultant::game::{Game, SHIP};
use resultant::physics::Aabb;
use resultant::view::camera::{CanvasWindow, Viewport};

/// Pixels.
pub const WINDOWS: [Vec2; 4] =
    [Vec2::new(900.0, 500.0), Vec2::new(1280.0, 720.0), Vec2::new(1920.0, 1080.0), Vec2::new(720.0, 1280.0)];

pub fn window(frame: &Frame) -> CanvasWindow {
    CanvasWindow { size: frame.size.as_dvec2(), pixel: f64::from(frame.pixel) }
}

/// The size of the window of a canvas, for messages.
pub fn pixels(frame: &Frame) -> Vec2 {
    (frame.size / frame.pixel).round()
}

/// Where a box lies on the canvas, corner by corner as the display takes it.
pub fn on_canvas(bounds: &Aabb, view: &Viewport) -> Area {
    let min = view.point(bounds.min);
    Area { min, size: view.point(bounds.max) - min }
}

/// The ship, goals and hazards, by name.
pub fn kept_free(game: &Game, view: &Viewport) -> Vec<(String, Area)> {
    let level = game.level();
    let goals = level.objectives.iter().map(|objective| ("a goal", objective.bounds));
    let hazards = level.obstacles.iter().map(|bounds| ("a death box", *bounds));
    let sources = level.streams.iter().map(|stream| ("the source of a stream", stream.source));
    let all = goals.chain(hazards).chain(sources).chain([("the ship", game.world().body(SHIP).bounds())]);
    all.map(|(name, bounds)| (format!("{name} at {}", bounds.centre()), on_canvas(&bounds, view))).collect()
}
