//! The names of mechanisms beside them, while the details are open.

use super::camera::Viewport;
use super::mechanisms::movers;
use super::theme;
use crate::draw::layout::{Area, DETAILS, MONO_ADVANCE, Vec2};
use crate::draw::{Canvas, Style};
use crate::game::{Game, plain_name};
use crate::level::SurfaceOf;
use crate::physics::{Aabb, DVec2, Source};
use crate::words::tr;

/// Around a name, canvas units.
const AROUND: Vec2 = Vec2::new(5.0, 2.0);

/// The names of all mechanisms in view with their areas, in the words of the details and of the switches.
pub fn told(game: &Game, view: &Viewport) -> Vec<(String, Area)> {
    let level = game.level();
    let mut told: Vec<(String, Area)> = Vec::new();
    let mut write_name = |words: &str, bounds: &Aabb| {
        if bounds.touches(&view.visible(), 0.0) {
            told.push((words.to_owned(), view.rect(bounds)));
        }
    };
    let called = |of: SurfaceOf, name: Option<&str>| {
        let plain = plain_name(level, Source::Surface(level.surface_index(of) as u32));
        name.map_or(plain.clone(), |name| format!("{plain}: {name}"))
    };
    for (index, solid) in level.world.iter().enumerate() {
        let special = !solid.is_rock() || solid.belt != 0.0 || solid.material.restitution > 0.0;
        if special && !game.mechanisms().is_broken(index) {
            let name = match solid.breaks {
                Some(impulse) => Some(tr!("breaks above {impulse} N·s", impulse = format_args!("{impulse:.0}"))),
                None => solid.name.clone(),
            };
            write_name(&called(SurfaceOf::World(index), name.as_deref()), &solid.bounds);
        }
    }
    for (index, (mover, bounds)) in level.movers.iter().zip(movers(game)).enumerate() {
        write_name(&called(SurfaceOf::Mover(index), mover.solid.name.as_deref()), &bounds);
    }
    for (index, door) in level.doors.iter().enumerate() {
        write_name(&called(SurfaceOf::Door(index), door.name.as_deref()), &door.bounds);
    }
    for (index, switch) in level.switches.iter().enumerate() {
        let works: Vec<&str> = switch.works.iter().map(|work| work.name.as_str()).collect();
        let words = tr!("switch {number}: {works}", number = index + 1, works = works.join(", "));
        write_name(&words, &switch.bounds);
    }
    for (index, field) in level.fields.iter().enumerate() {
        let DVec2 { x, y } = field.strength;
        write_name(
            &tr!("gravity {index}: ({x}, {y}) N/kg", index = index + 1, x = format_args!("{x:.1}"), y = format_args!("{y:.1}")),
            &field.zone,
        );
    }
    for (index, pod) in level.pods.iter().enumerate().filter(|(index, _)| !game.mechanisms().is_taken(*index)) {
        write_name(&tr!("pod {number}: {fuel} fuel", number = index + 1, fuel = format_args!("{:.0}", pod.fuel)), &pod.bounds);
    }
    told
}

/// Gives each name a free place beside its mechanism, if there is one, and adds it to `taken`. `text` is the height of letters.
pub fn place(told: Vec<(String, Area)>, text: f32, window: Area, taken: &mut Vec<Area>) -> Vec<(String, Area)> {
    let mut placed = Vec::new();
    for (name, of) in told {
        let size = Vec2::new(name.chars().count() as f32 * MONO_ADVANCE, 1.0) * text + 2.0 * AROUND;
        let (middle, out) = (of.centre(), (of.size + size) * 0.5 + 4.0);
        let ways = [-Vec2::Y, Vec2::Y, Vec2::X, -Vec2::X, Vec2::ZERO];
        let low = window.min + size * 0.5 + 4.0;
        let areas = ways.map(|way| Area::around((middle + way * out).clamp(low, (window.max() - size * 0.5 - 4.0).max(low)), size));
        if let Some(area) = areas.into_iter().find(|area| area.covers_none(taken)) {
            taken.push(area);
            placed.push((name, area));
        }
    }
    placed
}

pub fn draw(name: &str, area: Area, canvas: &Canvas) {
    canvas.rectangle(area, theme::ground().faded(0.8));
    canvas.text(name, area.centre(), Style::new(DETAILS, theme::text()).mono().centred().middle());
}
