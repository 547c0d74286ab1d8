//! Pictures that nothing touches: those behind what moves, and those that cover it.

use super::camera::Viewport;
use super::pictures::Pictures;
use crate::level::Level;
use macroquad::color::WHITE;
use macroquad::texture::{DrawTextureParams, draw_texture_ex};

/// Draws one of the two layers.
pub fn draw(level: &Level, in_front: bool, pictures: &Pictures, view: &Viewport) {
    let visible = view.visible();
    for picture in level.decoration.iter().filter(|picture| picture.in_front == in_front && picture.bounds.touches(&visible, 0.0)) {
        if let Some(texture) = pictures.get(&picture.image) {
            let area = view.rect(&picture.bounds);
            let params = DrawTextureParams { dest_size: Some(area.size()), ..DrawTextureParams::default() };
            draw_texture_ex(texture, area.x, area.y, WHITE, params);
        }
    }
}
