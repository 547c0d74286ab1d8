//! The view for authors and developers (F3): the boxes that collide, the zones, the contacts, the path of the last tick, and figures.

use super::{camera::Viewport, theme};
use crate::draw::layout::{Area, DETAILS, Frame, GRID, LINE, MONO_ADVANCE, Vec2};
use crate::draw::{Canvas, Colour, Style};
use crate::game::{Game, SHIP};
use crate::physics::{Aabb, BodyId, DVec2, ForceKind, Source};
use crate::{level::ship_body, number::fixed, view::hud::HudLayout, words::tr};

/// The colours of bodies, solid surfaces and zones.
const BODY: Colour = Colour::hex(0x7CFF6B);
const SURFACE: Colour = Colour::hex(0x56B4E9);
const ZONE: Colour = Colour::hex(0xE6EBF2);
/// The least width of the figures' panel, characters: it keeps its width while they change.
const FIGURES: usize = 46;
/// Boxes this near to each other touch in this drawing, m.
const NEAR: f64 = 1e-3;

/// `figures` (frames a second, cost of a tick) are the caller's measurements.
pub fn draw(game: &Game, figures: &str, view: &Viewport, canvas: &Canvas) {
    let (level, world) = (game.level(), game.world());
    let outline = |bounds: &Aabb, colour: Colour| {
        if bounds.touches(&view.visible(), 0.0) {
            canvas.rectangle_edge(view.rect(bounds), 1.0, colour);
        }
    };
    let surfaces = world.surfaces().iter().map(|surface| (surface.bounds, SURFACE));
    let goals = level.objectives.iter().map(|objective| (objective.bounds, theme::player_objective()));
    let hazards = level.obstacles.iter().map(|bounds| (*bounds, theme::bad()));
    let zones = level.streams.iter().map(|s| s.zone).chain(level.fluids.iter().map(|f| f.zone)).map(|zone| (zone, ZONE));
    surfaces.chain(goals).chain(hazards).chain(zones).for_each(|(bounds, colour)| outline(&bounds, colour));
    // The part of the ship that a death box kills.
    let centre = world.body(SHIP).position;
    canvas.convex_edge(&ship_body(game.ship().angle).map(|corner| view.point(centre + corner)), 2.0, theme::bad());
    for (i, body) in world.bodies().iter().enumerate() {
        let id = BodyId(i as u32);
        outline(&body.bounds(), BODY);
        let corners: Vec<Vec2> = world.path(id).map(|point| view.point(point)).collect();
        corners.windows(2).for_each(|leg| canvas.line(leg[0], leg[1], 2.0, BODY));
        draw_contacts(game, id, view, canvas);
    }
    draw_figures(game, figures, canvas);
}

/// The stretch of a body under a reaction or a push, with a stroke along the contact's normal.
fn draw_contacts(game: &Game, id: BodyId, view: &Viewport, canvas: &Canvas) {
    let world = game.world();
    let own = world.body(id).bounds();
    for force in world.forces(id).forces().iter().filter(|f| matches!(f.kind, ForceKind::Reaction | ForceKind::Push)) {
        let other = match force.source {
            Source::Surface(i) => world.surfaces()[i as usize].bounds,
            Source::Body(other) => world.body(other).bounds(),
            _ => continue,
        };
        if !own.touches(&other, NEAR) {
            continue;
        }
        let (from, to) = (own.min.max(other.min), own.max.min(other.max));
        let normal = force.vector.normalize_or_zero();
        canvas.line(view.point(from), view.point(to), 4.0, theme::force(ForceKind::Reaction));
        let middle = (from + to) * 0.5;
        canvas.line(view.point(middle), view.point(middle + normal * 0.5), 2.0, theme::force(ForceKind::Reaction));
    }
}

/// Below the head-up display's panel.
pub fn figures_area(game: &Game, frame: &Frame) -> Area {
    let (text, counts) = (frame.text_height(DETAILS), counts(game));
    let longest = counts.iter().map(|line| line.chars().count()).fold(FIGURES, usize::max);
    let size = Vec2::new(longest as f32 * MONO_ADVANCE, (2 + counts.len()) as f32 * LINE) * text;
    let status = HudLayout::new(frame).status;
    Area { min: Vec2::new(status.min.x, status.max().y + 2.0 * GRID), size: size + Vec2::new(2.0, 1.0) * GRID }
}

/// The engine's counts, a line each: the paths of the bodies through the last tick, and the interventions of its guards.
fn counts(game: &Game) -> Vec<String> {
    let world = game.world();
    let methods: Vec<String> = world.methods().all().filter(|(_, n)| *n > 0).map(|(name, n)| format!("{n} {}", tr(name))).collect();
    let methods = (!methods.is_empty()).then(|| tr!("bodies: {counts}", counts = methods.join(", ")));
    let guard = |(name, count): (&str, u64)| tr!("guard {name}: {count}", name = tr(&name.replace('_', " ")), count);
    methods.into_iter().chain(world.guards().all().filter(|(_, n)| *n > 0).map(guard)).collect()
}

/// On a ground of its own so that it can be read over anything.
fn draw_figures(game: &Game, figures: &str, canvas: &Canvas) {
    let ship = game.world().body(SHIP);
    let DVec2 { x, y } = ship.position;
    let angle = fixed(game.ship().angle, 1);
    let place = tr!("tick {count}  ship {x}, {y} m  {angle}°", count = game.ticks(), x = fixed(x, 3), y = fixed(y, 3), angle);
    let (line, area) = (canvas.line_height(DETAILS), figures_area(game, canvas.frame()));
    canvas.rounded(area, GRID, theme::ground().faded(0.8));
    for (i, text) in [figures.to_owned(), place].into_iter().chain(counts(game)).enumerate() {
        canvas.text(&text, area.min + Vec2::new(GRID, GRID * 0.5 + i as f32 * line), Style::new(DETAILS, theme::text()).mono());
    }
}
