//! The head-up display: time, objectives met, speed, fuel; and the arrow of the ship's velocity.

use super::camera::Viewport;
use super::canvas::{Canvas, Style};
use super::layout::{Area, DETAILS, GRID, HudLayout, TEXT, Vec2};
use super::theme::{self, faded, rgb};
use super::widgets::panel_in;
use crate::game::{DAMAGING_SPEED, Game, SHIP};
use crate::number::clock;
use crate::physics::DVec2;
use crate::settings::{Action, Settings};
use macroquad::color::Color;

/// The fuel bar's colour when full; it runs to [`FUEL_EMPTY`].
const FUEL_FULL: Color = rgb(0xFFB01C);
const FUEL_EMPTY: Color = rgb(0xF2302F);
/// The gauge of speed ends here, m/s.
const GAUGE_END: f64 = 2.0 * DAMAGING_SPEED;
/// Length of the arrow of velocity, m of the level a m/s, and where it begins and ends, m from the ship's centre.
const VELOCITY_SCALE: f64 = 0.22;
const VELOCITY_START: f64 = 1.25;
const VELOCITY_END: f64 = 6.0;
/// Length of its head, canvas units.
const VELOCITY_HEAD: f32 = 9.0;
/// Slower than this has no arrow, m/s.
const VELOCITY_LEAST: f64 = 0.5;
/// For how long the keys are told at the start of the first level, s.
const HINT_TIME: f64 = 12.0;

/// Draws all of it; whether the keys of the flight are `told` at the start of the first level.
pub fn draw(game: &Game, settings: &Settings, told: bool, canvas: &Canvas) {
    let layout = HudLayout::new(canvas.frame());
    draw_status(game, settings, layout.status, canvas);
    if game.is_stranded() {
        let hint = format!("Out of fuel – {} flies again", settings.keys.label(Action::Restart));
        let at = Vec2::new(canvas.size().x / 2.0, layout.fuel.min.y - 2.0 * GRID - canvas.line_height(TEXT) / 2.0);
        let style = Style::new(TEXT, theme::text()).centred().middle();
        let size = Vec2::new(canvas.width(&hint, style) + 4.0 * GRID, canvas.line_height(TEXT) + GRID);
        panel_in(canvas, Area::around(at, size), faded(theme::panel(), 0.9), theme::panel_edge());
        canvas.text(&hint, at, style);
    }
    let level = &game.level().player;
    let share = if level.fuel > 0.0 { (game.ship().fuel / level.fuel).clamp(0.0, 1.0) } else { 0.0 };
    let fuel = format!("Fuel {:.0} units", game.ship().fuel);
    let words = hint(game, settings).filter(|_| told).map_or(fuel.clone(), |hint| format!("{fuel}    {hint}"));
    draw_fuel(share as f32, &words, layout.fuel, canvas);
}

/// What the keys do, as the first level tells at its start: in the fuel bar, where it hides nothing.
fn hint(game: &Game, settings: &Settings) -> Option<String> {
    let first = game.level().name == "1" && game.elapsed() < HINT_TIME;
    first.then(|| {
        let label = |action| settings.keys.label(action);
        let [restart, pause, details] = [Action::Restart, Action::Pause, Action::Details].map(label);
        format!("{restart} restarts · {pause} pauses · {details} shows the forces")
    })
}

fn draw_status(game: &Game, settings: &Settings, area: Area, canvas: &Canvas) {
    panel_in(canvas, area, faded(theme::panel(), 0.9), theme::panel_edge());
    let middle = area.min.y + area.size.y * 0.29;
    let number = Style::new(TEXT, theme::text()).mono().middle();
    let left = area.min.x + 2.0 * GRID;
    if settings.timer {
        canvas.text(&clock(if game.is_idle() { 0.0 } else { game.time() }), Vec2::new(left, middle), number);
    }
    draw_speed(game, area, canvas);
    let (met, all) = (game.met().iter().filter(|met| **met).count(), game.met().len());
    let colour = if met == all { theme::good() } else { theme::text() };
    let right = area.max().x - 2.0 * GRID;
    let count = format!("{met}/{all}");
    let style = Style::new(TEXT, colour).mono().middle().right();
    canvas.text(&count, Vec2::new(right, middle), style);
    let words = Vec2::new(right - canvas.width(&count, style) - GRID, middle);
    canvas.text("Objectives", words, Style::new(TEXT, theme::quiet()).middle().right());
}

/// The ship's speed as a number and as a bar with a mark where it damages.
fn draw_speed(game: &Game, area: Area, canvas: &Canvas) {
    use macroquad::shapes::draw_rectangle;
    let speed = game.world().body(SHIP).velocity.length();
    let colour = speed_colour(speed);
    let y = area.min.y + area.size.y * 0.72;
    let left = area.min.x + 2.0 * GRID;
    let words = format!("{speed:>5.1} m/s");
    let style = Style::new(TEXT, colour).mono().middle();
    canvas.text(&words, Vec2::new(left, y), style);
    let start = left + canvas.width(&words, style) + 1.5 * GRID;
    let (length, height) = (area.max().x - 2.0 * GRID - start, GRID);
    let share = (speed / GAUGE_END).min(1.0) as f32;
    draw_rectangle(start, y - height / 2.0, length, height, theme::ground());
    draw_rectangle(start, y - height / 2.0, length * share, height, colour);
    let mark = start + length * (DAMAGING_SPEED / GAUGE_END) as f32;
    draw_rectangle(mark - 1.0, y - height, 2.0, 2.0 * height, theme::bad());
}

/// Red where a hit would damage.
fn speed_colour(speed: f64) -> Color {
    if speed >= DAMAGING_SPEED { theme::bad() } else { theme::text() }
}

/// Where the arrow of the ship's velocity (m/s) begins and ends, beside the ship whose centre is drawn at `centre` (m); none for a slow ship.
fn velocity_arrow(velocity: DVec2, centre: DVec2, view: &Viewport) -> Option<(Vec2, Vec2)> {
    let speed = velocity.length();
    let along = velocity / speed;
    let length = (speed * VELOCITY_SCALE).min(VELOCITY_END);
    let ends = || (view.point(centre + along * VELOCITY_START), view.point(centre + along * (VELOCITY_START + length)));
    (speed >= VELOCITY_LEAST).then(ends)
}

/// The box around its head.
pub fn velocity_tip(velocity: DVec2, centre: DVec2, view: &Viewport) -> Option<Area> {
    let (from, to) = velocity_arrow(velocity, centre, view)?;
    let middle = to - (to - from).normalize_or_zero() * VELOCITY_HEAD * 0.5;
    Some(Area::around(middle, Vec2::splat(VELOCITY_HEAD * 1.2)))
}

/// Draws it.
pub fn draw_velocity(velocity: DVec2, centre: DVec2, view: &Viewport, canvas: &Canvas) {
    let Some((from, to)) = velocity_arrow(velocity, centre, view) else { return };
    let colour = faded(speed_colour(velocity.length()), 0.85);
    let (way, head) = ((to - from).normalize_or_zero(), VELOCITY_HEAD);
    canvas.line(from, to - way * head * 0.6, 3.0, colour);
    canvas.convex(&[to, to - way * head + way.perp() * head * 0.5, to - way * head - way.perp() * head * 0.5], colour);
}

fn draw_fuel(share: f32, words: &str, area: Area, canvas: &Canvas) {
    use macroquad::shapes::{draw_rectangle, draw_rectangle_lines};
    let (at, size) = (area.min, area.size);
    draw_rectangle(at.x, at.y, size.x, size.y, faded(theme::panel(), 0.9));
    draw_rectangle(at.x, at.y, size.x * share, size.y, fuel_colour(share));
    // Quarters, so that the length can be read.
    for quarter in 1..4_u8 {
        let x = at.x + size.x * f32::from(quarter) / 4.0;
        draw_rectangle(x - 1.0, at.y + size.y * 0.65, 2.0, size.y * 0.35, faded(theme::ground(), 0.6));
    }
    draw_rectangle_lines(at.x, at.y, size.x, size.y, 4.0, theme::panel_edge());
    // Dark words on the bright bar; where the bar has gone, light ones.
    let style = Style::new(DETAILS, theme::ground()).mono().middle();
    let covered = size.x * share > canvas.width(words, style) + 2.0 * GRID;
    let colour = if covered { theme::ground() } else { theme::text() };
    let x = if covered { at.x + GRID } else { at.x + size.x * share + GRID };
    canvas.text(words, Vec2::new(x, area.centre().y), Style { colour, ..style });
}

/// From yellow-orange when full to red when empty.
pub fn fuel_colour(share: f32) -> Color {
    let mix = |empty: f32, full: f32| empty + (full - empty) * share.clamp(0.0, 1.0);
    Color::new(mix(FUEL_EMPTY.r, FUEL_FULL.r), mix(FUEL_EMPTY.g, FUEL_FULL.g), mix(FUEL_EMPTY.b, FUEL_FULL.b), 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::layout::Frame;

    #[test]
    fn the_fuel_bar_is_three_quarters_wide_and_three_hundredths_high_at_the_bottom_centre() {
        for pixels in [Vec2::new(900.0, 500.0), Vec2::new(1280.0, 720.0), Vec2::new(1920.0, 1080.0), Vec2::new(700.0, 1000.0)] {
            let frame = Frame::of_window(pixels);
            let bar = HudLayout::new(&frame).fuel;
            assert!((bar.size - frame.size * Vec2::new(0.75, 0.03)).abs().max_element() < 1e-3);
            assert!((bar.centre().x - frame.size.x / 2.0).abs() < 1e-3);
            assert!(bar.max().y < frame.size.y && bar.min.y > frame.size.y * 0.9);
        }
    }

    #[test]
    fn the_fuel_bar_reddens_as_it_empties() {
        let (full, half, empty) = (fuel_colour(1.0), fuel_colour(0.5), fuel_colour(0.0));
        assert_eq!((full, empty), (FUEL_FULL, FUEL_EMPTY));
        assert!(full.g > half.g && half.g > empty.g);
    }
}
