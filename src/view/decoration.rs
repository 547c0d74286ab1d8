//! Pictures and plain shapes that nothing touches: those behind what moves, and those that cover it. One behind lies on the rock as well
//! as on the air: below goals and hazards in the air, above the rock where there is some.

use super::camera::Viewport;
use super::pictures::Pictures;
use super::terrain::Terrain;
use super::theme;
use crate::level::{Level, Look};
use macroquad::color::WHITE;
use macroquad::math::Rect;
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

/// Draws the parts of the layer behind that lie on rock.
pub fn draw_on_rock(level: &Level, terrain: &Terrain, pictures: &Pictures, view: &Viewport) {
    let visible = view.visible();
    for picture in level.decoration.iter().filter(|picture| !picture.in_front && picture.bounds.touches(&visible, 0.0)) {
        // A plain shape is a mark on the air: rock hides it.
        let Look::Image(path) = &picture.look else { continue };
        let Some(texture) = pictures.get(path) else { continue };
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
