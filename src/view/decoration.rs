//! Pictures and plain shapes that nothing touches: those behind what moves, and those that cover it.

use super::camera::Viewport;
use super::pictures::Pictures;
use super::theme;
use crate::level::{Level, Look};
use macroquad::color::WHITE;
use macroquad::shapes::{draw_ellipse, draw_rectangle};
use macroquad::texture::{DrawTextureParams, draw_texture_ex};

/// Draws one of the two layers.
pub fn draw(level: &Level, in_front: bool, pictures: &Pictures, view: &Viewport) {
    let visible = view.visible();
    for shown in level.decoration.iter().filter(|shown| shown.in_front == in_front && shown.bounds.touches(&visible, 0.0)) {
        let area = view.rect(&shown.bounds);
        // Calm and without an edge: nothing of the level meets it.
        let (middle, plain) = (area.center(), theme::faded(theme::solid(), 0.6));
        match &shown.look {
            Look::Image(path) => {
                if let Some(texture) = pictures.get(path) {
                    let params = DrawTextureParams { dest_size: Some(area.size()), ..DrawTextureParams::default() };
                    draw_texture_ex(texture, area.x, area.y, WHITE, params);
                }
            }
            Look::Box => draw_rectangle(area.x, area.y, area.w, area.h, plain),
            Look::Ball => draw_ellipse(middle.x, middle.y, area.w / 2.0, area.h / 2.0, 0.0, plain),
        }
    }
}
