//! A game as it appears in a window.

use resultant::draw::layout::{Area, Frame, Vec2};
use resultant::game::{Game, SHIP};
use resultant::physics::{Aabb, DVec2};
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

pub fn centres(game: &Game) -> Vec<DVec2> {
    game.world().bodies().iter().map(|body| body.position).collect()
}

/// One number, or two with a comma between them, as a box shows them: x, y (or 0), and the decimals.
pub fn numbers_in(text: &str) -> (f64, f64, i32) {
    let numbers: Vec<&str> = text.split(',').map(str::trim).collect();
    let decimals = numbers.iter().filter_map(|number| Some(number.len() - number.find('.')? - 1)).max().unwrap_or(0);
    let value = |i: usize| numbers.get(i).map_or(0.0, |number| number.parse().expect("a number"));
    (value(0), value(1), decimals as i32)
}

/// The factor that a unit's prefix stands for.
pub fn power_of(prefix: &str) -> f64 {
    let known = [("G", 1e9), ("M", 1e6), ("k", 1e3), ("", 1.0), ("m", 1e-3), ("µ", 1e-6)];
    known.into_iter().find(|(name, _)| *name == prefix).unwrap_or_else(|| panic!("the prefix {prefix}")).1
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
