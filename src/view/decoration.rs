//! Pictures and plain shapes without collision, in two layers: behind bodies and in front of them. A picture behind lies on rock as
//! well as on air: below goals and hazards in the air, above the rock.

use super::camera::Viewport;
use super::pictures::Pictures;
use super::terrain::Terrain;
use super::theme;
use super::things::ellipse;
use crate::draw::layout::Area;
use crate::draw::{Canvas, Colour};
use crate::level::{Level, Look};

pub fn draw(level: &Level, in_front: bool, pictures: &Pictures, (view, canvas): (&Viewport, &Canvas)) {
    let visible = view.visible();
    for shown in level.decoration.iter().filter(|shown| shown.in_front == in_front && shown.bounds.touches(&visible, 0.0)) {
        let area = view.rect(&shown.bounds);
        // Calm and without an edge: the shape has no collision.
        let plain = theme::solid().faded(0.6);
        match &shown.look {
            Look::Image(path) => pictures.get(path).into_iter().for_each(|image| canvas.image(image, area, Colour::WHITE)),
            Look::Box => canvas.rectangle(area, plain),
            Look::Ball => canvas.convex(&ellipse(area), plain),
        }
    }
}

/// Draws the parts of the layer behind that lie on rock.
pub fn draw_on_rock(level: &Level, terrain: &Terrain, pictures: &Pictures, (view, canvas): (&Viewport, &Canvas)) {
    let visible = view.visible();
    for picture in level.decoration.iter().filter(|picture| !picture.in_front && picture.bounds.touches(&visible, 0.0)) {
        // A plain shape is a mark on the air: rock hides it.
        let Look::Image(path) = &picture.look else { continue };
        let Some(image) = pictures.get(path) else { continue };
        for part in terrain.parts(&picture.bounds) {
            // The ends are whole pixels of the window, so that the parts adjoin as the rock's do.
            let (area, all) = (view.rect(&part), view.rect(&picture.bounds));
            let shown = Area { min: (area.min - all.min) / all.size, size: area.size / all.size };
            canvas.picture(image, shown, area, (0.0, Colour::WHITE));
        }
    }
}
