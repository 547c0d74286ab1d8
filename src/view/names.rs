//! The names of mechanisms, written beside them while the details are open.

use super::camera::Viewport;
use super::canvas::{Canvas, Style};
use super::layout::{DETAILS, Vec2};
use super::theme::{self, faded};
use crate::game::{Game, obstacle_name};
use crate::level::SurfaceOf;
use crate::physics::{Aabb, DVec2, Obstacle};
use macroquad::shapes::draw_rectangle;

/// Writes the names of all mechanisms in view, as the command line and the details call them, and by what switches call them.
pub fn draw(game: &Game, view: &Viewport, canvas: &Canvas) {
    let level = game.level();
    let label = |of: SurfaceOf, name: Option<&str>, bounds: &Aabb| {
        let plain = obstacle_name(level, Obstacle::Surface(level.surface_index(of) as u32));
        write_name(&name.map_or(plain.clone(), |name| format!("{plain}: {name}")), bounds, view, canvas);
    };
    for (index, solid) in level.world.iter().enumerate() {
        let special = !solid.is_rock() || solid.belt != 0.0 || solid.material.restitution > 0.0;
        if special && !game.mechanisms().is_broken(index) {
            let name = match solid.breaks {
                Some(impulse) => Some(format!("breaks above {impulse:.0} N·s")),
                None => solid.name.clone(),
            };
            label(SurfaceOf::World(index), name.as_deref(), &solid.bounds);
        }
    }
    for (index, mover) in level.movers.iter().enumerate() {
        let bounds = game.world().surfaces()[level.surface_index(SurfaceOf::Mover(index))].bounds;
        label(SurfaceOf::Mover(index), mover.solid.name.as_deref(), &bounds);
    }
    for (index, door) in level.doors.iter().enumerate() {
        label(SurfaceOf::Door(index), door.name.as_deref(), &door.bounds);
    }
    for (index, switch) in level.switches.iter().enumerate() {
        let works: Vec<&str> = switch.works.iter().map(|work| work.name.as_str()).collect();
        let words = format!("switch {}: {}", index + 1, works.join(", "));
        write_name(&words, &switch.bounds, view, canvas);
    }
    for (index, field) in level.fields.iter().enumerate() {
        let DVec2 { x, y } = field.strength;
        write_name(&format!("gravity {}: ({x:.1}, {y:.1}) N/kg", index + 1), &field.zone, view, canvas);
    }
    for (index, pod) in level.pods.iter().enumerate().filter(|(index, _)| !game.mechanisms().is_taken(*index)) {
        write_name(&format!("pod {}: {:.0} fuel", index + 1, pod.fuel), &pod.bounds, view, canvas);
    }
}

/// A name above a box.
fn write_name(words: &str, bounds: &Aabb, view: &Viewport, canvas: &Canvas) {
    if bounds.touches(&view.visible(), 0.0) {
        let area = view.rect(bounds);
        let style = Style::new(DETAILS, theme::text()).mono().centred().middle();
        let (width, at) = (canvas.width(words, style) + 10.0, Vec2::new(area.center().x, (area.y - 12.0).max(10.0)));
        draw_rectangle(at.x - width / 2.0, at.y - 9.0, width, 18.0, faded(theme::ground(), 0.8));
        canvas.text(words, at, style);
    }
}
