//! Pictures that nothing touches: those behind what moves, and those that cover it. One behind lies on the rock as well as on the air:
//! below goals and hazards in the air, above the rock where there is some.

use super::camera::Viewport;
use super::pictures::Pictures;
use super::terrain::Terrain;
use crate::level::Level;
use macroquad::color::WHITE;
use macroquad::math::Rect;
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

/// Draws the parts of the layer behind that lie on rock.
pub fn draw_on_rock(level: &Level, terrain: &Terrain, pictures: &Pictures, view: &Viewport) {
    let visible = view.visible();
    for picture in level.decoration.iter().filter(|picture| !picture.in_front && picture.bounds.touches(&visible, 0.0)) {
        let Some(texture) = pictures.get(&picture.image) else { continue };
        for part in terrain.parts(&picture.bounds) {
            // Where whole pixels of the window begin and end, so that the parts meet as the rock's do.
            let (area, all) = (view.rect(&part), view.rect(&picture.bounds));
            let scale = texture.size() / all.size();
            let source = Rect::new((area.x - all.x) * scale.x, (area.y - all.y) * scale.y, area.w * scale.x, area.h * scale.y);
            let params = DrawTextureParams { dest_size: Some(area.size()), source: Some(source), ..DrawTextureParams::default() };
            draw_texture_ex(texture, area.x, area.y, WHITE, params);
        }
    }
}
