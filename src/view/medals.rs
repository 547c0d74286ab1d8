//! Medals, made of arrows: a ring, and in it the arrow that leads up.

use super::canvas::Canvas;
use super::layout::Vec2;
use super::theme;
use crate::scores::Medal;
use macroquad::color::Color;

/// The colour of a medal.
const fn colour(medal: Medal) -> Color {
    match medal {
        Medal::Bronze => theme::rgb(0xC98A4B),
    }
}

/// Draws a medal around a point.
pub fn draw(canvas: &Canvas, medal: Medal, centre: Vec2, radius: f32) {
    let colour = colour(medal);
    canvas.disc(centre, radius, theme::faded(colour, 0.25));
    canvas.ring(centre, radius, radius * 0.2, colour);
    let at = |x: f32, y: f32| centre + Vec2::new(x, y) * radius;
    canvas.line(at(0.0, 0.5), at(0.0, -0.1), radius * 0.22, colour);
    canvas.convex(&[at(0.0, -0.6), at(0.42, 0.0), at(-0.42, 0.0)], colour);
}
