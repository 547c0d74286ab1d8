//! Mechanisms, drafted like the world but distinct from it. Blocks that move have a dashed track with a tick at each way point;
//! doors are barred; belts run with chevrons; one-way blocks have one thick side; fragile blocks are cracked.

use super::art::{self, Tile};
use super::particles::{Particle, ParticleLook, Particles};
use super::{camera::Viewport, terrain::material_edge, theme};
use crate::draw::layout::{Area, Vec2};
use crate::draw::{Canvas, Colour};
use crate::game::{Game, Outcome};
use crate::level::{Level, Mover, Route, Solid, StarTouch, SurfaceOf, Worked};
use crate::physics::{Aabb, DVec2, ForceKind, Material, Sides};

/// The body of movers and doors: bluer and lighter than any rock.
const WORKS: Colour = Colour::hex(0x3D5878);
const WORKS_EDGE: Colour = Colour::hex(0x9CC3EE);
/// A dash and the gap after it, canvas units.
const DASH: [f32; 2] = [7.0, 5.0];
/// Between two chevrons of a belt, m, and their height.
const CHEVRON_STEP: f64 = 0.5;
const CHEVRON: f64 = 0.22;
/// Between two arrows of a gravity zone, m.
const ARROW_STEP: f64 = 2.0;

/// The gravity zones: faint, with arrows along the gravity in them.
pub fn draw_fields(level: &Level, view: &Viewport, canvas: &Canvas, time: f64) {
    let (visible, colour) = (view.visible(), theme::force(ForceKind::Weight));
    for field in level.fields.iter().filter(|field| field.zone.touches(&visible, 0.0)) {
        let area = view.rect(&field.zone);
        canvas.rectangle(area, colour.faded(0.07));
        dashed_outline(canvas, area, colour.faded(0.6));
        let way = (field.strength + DVec2::new(level.gravity_x, level.gravity)).normalize_or_zero();
        let drift = way * ((time * 0.8).rem_euclid(1.0) * ARROW_STEP * 0.25);
        let shown = Aabb::new(field.zone.min.max(visible.min), field.zone.max.min(visible.max));
        for x in marks(shown.min.x, shown.max.x) {
            for y in marks(shown.min.y, shown.max.y) {
                let at = DVec2::new(x, y) + drift;
                if way == DVec2::ZERO {
                    canvas.ring(view.point(DVec2::new(x, y)), 4.0, 1.5, colour.faded(0.5));
                } else if field.zone.contains(&Aabb::around(at, DVec2::splat(0.3)), 0.0) {
                    arrow(canvas, view, at, way * 0.5, colour.faded(0.5));
                }
            }
        }
    }
}

/// The present boxes of the movers, m, in the level's order.
pub fn movers(game: &Game) -> impl Iterator<Item = Aabb> {
    let bounds = |index: usize| game.world().surfaces()[game.level().surface_index(SurfaceOf::Mover(index))].bounds;
    (0..game.level().movers.len()).map(bounds)
}

/// The places of the things that a switch works, m.
pub fn worked_by(game: &Game, switch: usize) -> impl Iterator<Item = DVec2> {
    let (level, surfaces) = (game.level(), game.world().surfaces());
    let of = move |surface: SurfaceOf| surfaces[level.surface_index(surface)].bounds;
    let wires = level.wires().into_iter().filter(move |wire| wire.by.iter().flatten().any(|(by, _)| *by == switch));
    let places = wires.map(move |wire| match wire.worked {
        Worked::Mover(index) => of(SurfaceOf::Mover(index)),
        Worked::Door(index) => of(SurfaceOf::Door(index)),
        Worked::Belt(index) => level.world[index].bounds,
        Worked::Stream(index) => level.streams[index].source,
        Worked::Link(index) => {
            let [from, to] = game.world().link_ends(&game.world().links()[index]);
            Aabb::new(from.min(to), from.max(to))
        }
    });
    places.map(|bounds| bounds.centre())
}

/// The middles of a grid's cells between two coordinates, m.
fn marks(from: f64, to: f64) -> impl Iterator<Item = f64> {
    ((from / ARROW_STEP).floor() as i64..=(to / ARROW_STEP).ceil() as i64).map(|i| (i as f64 + 0.5) * ARROW_STEP)
}

/// Whether the lamp of a switch is lit: all of them are in a solved level.
fn is_lit(game: &Game, switch: usize) -> bool {
    game.mechanisms().on()[switch] || game.outcome() == Outcome::Completed
}

/// The areas of switches, and pods: a touch is enough.
pub fn draw_areas(game: &Game, view: &Viewport, canvas: &Canvas, time: f64) {
    let (level, visible) = (game.level(), view.visible());
    for (index, switch) in level.switches.iter().enumerate() {
        if switch.weight.is_some() || !switch.bounds.touches(&visible, 1.0) {
            continue;
        }
        let (area, on, colour) = (view.rect(&switch.bounds), is_lit(game, index), lamp_colour(game, index));
        canvas.rectangle(area, colour.faded(if on { 0.22 } else { 0.08 }));
        if game.mechanisms().is_pressed(index) {
            canvas.rectangle_edge(area, 2.0, colour);
        } else {
            dashed_outline(canvas, area, colour);
        }
        lamp(canvas, area.centre(), colour, on);
    }
    for (index, pod) in level.pods.iter().enumerate() {
        if !game.mechanisms().is_taken(index) && pod.bounds.touches(&visible, 1.0) {
            draw_pod(view.rect(&pod.bounds), canvas, time);
        }
    }
}

/// The stars: dim until they are touched, then filled. A diamond in its middle says that a key has to touch it, a square any object.
pub fn draw_stars(game: &Game, view: &Viewport, canvas: &Canvas) {
    for (star, touched) in game.level().stars.iter().zip(game.stars()) {
        if star.bounds.touches(&view.visible(), 1.0) {
            draw_star(view.rect(&star.bounds), star.by, *touched, canvas);
        }
    }
}

fn draw_star(area: Area, by: StarTouch, touched: bool, canvas: &Canvas) {
    let reach = area.size.min_element() * 0.5;
    let tip = |part: usize| {
        let far = if part.is_multiple_of(2) { reach } else { reach * 0.42 };
        area.centre() + Vec2::from_angle(part as f32 * std::f32::consts::PI / 5.0 - std::f32::consts::FRAC_PI_2) * far
    };
    let colour = theme::accent().faded(if touched { 0.9 } else { 0.45 });
    for part in 0..10 {
        let (from, to) = (tip(part), tip((part + 1) % 10));
        if touched {
            canvas.convex(&[area.centre(), from, to], colour);
        } else {
            canvas.line(from, to, 2.0, colour);
        }
    }
    if touched {
        return;
    }
    dashed_outline(canvas, area, colour.faded(0.3));
    let (middle, size) = (area.centre(), reach * 0.26);
    match by {
        StarTouch::Ship => {}
        StarTouch::Key => canvas.convex(&[Vec2::Y, Vec2::X, Vec2::NEG_Y, Vec2::NEG_X].map(|to| middle + to * size), colour),
        StarTouch::Object => canvas.rectangle(Area::around(middle, Vec2::splat(size * 1.6)), colour),
    }
}

fn draw_pod(area: Area, canvas: &Canvas, time: f64) {
    let pulse = 0.5 + 0.5 * (time * 3.1).sin() as f32;
    let round = (area.size.x.min(area.size.y) * 0.3).min(10.0);
    canvas.rounded(area, round, theme::accent().faded(0.25 + 0.15 * pulse));
    canvas.rounded_edge(area, round, 2.5, theme::accent());
    let (middle, size) = (area.centre(), area.size.x.min(area.size.y) * 0.24);
    canvas.disc(middle + Vec2::new(0.0, size * 0.35), size * 0.8, theme::accent());
    canvas.convex(&[(0.0, -1.3), (0.72, 0.0), (-0.72, 0.0)].map(|(x, y)| middle + size * Vec2::new(x, y)), theme::accent());
}

/// The solids that are no rock. `alpha` is the frame's place in the last tick. With a solved level's `answer` (0 … 1) doors open and belts run.
pub fn draw(game: &Game, alpha: f64, (view, canvas): (&Viewport, &Canvas), (time, answer): (f64, f32)) {
    let level = game.level();
    for mover in &level.movers {
        draw_track(mover, view, canvas);
    }
    for (index, solid) in level.world.iter().enumerate() {
        if game.mechanisms().is_broken(index) || !solid.bounds.touches(&view.visible(), 1.0) {
            continue;
        }
        let area = view.rect(&solid.bounds);
        if solid.sides != Sides::ALL {
            draw_one_way(solid, area, canvas);
        } else if solid.breaks.is_some() {
            art::fill(canvas, Tile::Material(solid.material.name), &solid.bounds, view, theme::text().faded(0.8));
            draw_cracks(solid, area, canvas);
        }
        draw_skin(solid, &solid.bounds, answer > 0.0 || game.mechanisms().is_on(Worked::Belt(index)), (view, canvas), time);
    }
    for (index, mover) in level.movers.iter().enumerate() {
        let surface = &game.world().surfaces()[level.surface_index(SurfaceOf::Mover(index))];
        let back = -surface.velocity * ((1.0 - alpha) / game.tick_rate());
        draw_mover(mover, &Aabb::new(surface.bounds.min + back, surface.bounds.max + back), (view, canvas), time);
    }
    for (index, door) in level.doors.iter().enumerate() {
        let surface = &game.world().surfaces()[level.surface_index(SurfaceOf::Door(index))];
        draw_door(door, if surface.present { answer } else { 1.0 }, view, canvas);
    }
    for (index, switch) in level.switches.iter().enumerate().filter(|(_, switch)| switch.weight.is_some()) {
        let (on, pressed) = (is_lit(game, index), game.mechanisms().is_pressed(index));
        draw_plate(view.rect(&switch.bounds), lamp_colour(game, index), (on, pressed), canvas);
    }
}

fn draw_track(mover: &Mover, view: &Viewport, canvas: &Canvas) {
    let colour = WORKS_EDGE.faded(0.55);
    let closes = (mover.manner.route == Route::Round).then(|| mover.stops[0]);
    let stops: Vec<DVec2> = mover.stops.iter().copied().chain(closes).collect();
    for pair in stops.windows(2) {
        let [from, to] = [pair[0], pair[1]].map(|stop| view.point(stop));
        canvas.dashed(&[from, to], &DASH, 2.0, colour);
        let across = (to - from).normalize_or_zero().perp() * 7.0;
        for end in [from, to] {
            canvas.line(end - across, end + across, 2.0, colour);
        }
    }
}

fn draw_mover(mover: &Mover, bounds: &Aabb, (view, canvas): (&Viewport, &Canvas), time: f64) {
    if !bounds.touches(&view.visible(), 1.0) {
        return;
    }
    let area = view.exact(bounds);
    if mover.solid.sides == Sides::ALL {
        canvas.rectangle(area, WORKS);
        canvas.rectangle_edge(area, 2.5, edge_of(mover.solid.material));
        // Two corner marks, as on a sliding carriage.
        let reach = (area.size.x.min(area.size.y) * 0.22).min(9.0);
        for (corner, side) in [(area.min, 1.0), (area.max(), -1.0)] {
            let at = corner + Vec2::splat(6.0) * side;
            canvas.convex(&[at, at + Vec2::new(reach * side, 0.0), at + Vec2::new(0.0, reach * side)], WORKS_EDGE.faded(0.8));
        }
    } else {
        draw_one_way(&mover.solid, area, canvas);
    }
    draw_skin(&mover.solid, bounds, true, (view, canvas), time);
}

/// Two barred leaves, which leave their frame as the door opens (0 … 1).
fn draw_door(door: &Solid, open: f32, view: &Viewport, canvas: &Canvas) {
    if !door.bounds.touches(&view.visible(), 1.0) {
        return;
    }
    let area = view.rect(&door.bounds);
    let upright = area.size.y >= area.size.x;
    let (long, thin) = if upright { (area.size.y, area.size.x) } else { (area.size.x, area.size.y) };
    let piece = |from: f32, length: f32| match upright {
        true => Area::new(area.min.x, area.min.y + from, area.size.x, length),
        false => Area::new(area.min.x + from, area.min.y, length, area.size.y),
    };
    if open > 0.0 {
        dashed_outline(canvas, area, WORKS_EDGE.faded(0.55));
        let length = long * 0.5 + (thin.min(long * 0.1) - long * 0.5) * open;
        for leaf in [piece(0.0, length), piece(long - length, length)] {
            canvas.rectangle(leaf, WORKS);
            canvas.rectangle_edge(leaf, 1.5, WORKS_EDGE);
        }
        return;
    }
    canvas.rectangle(area, WORKS);
    let bars = (long / 14.0).floor().max(1.0);
    for bar in 0..bars as usize {
        canvas.rectangle(piece(long / bars * (bar as f32 + 0.3), long / bars * 0.4), Colour::hex(0x22334A));
    }
    canvas.rectangle_edge(area, 2.0, edge_of(door.material));
    canvas.rectangle(piece(long * 0.5 - 1.5, 3.0), theme::ground());
}

/// The cap stands out above the plate until it is pressed.
fn draw_plate(area: Area, colour: Colour, (on, pressed): (bool, bool), canvas: &Canvas) {
    canvas.rectangle(area, Colour::hex(0x2A3344));
    canvas.rectangle_edge(area, 1.5, WORKS_EDGE);
    let cap = if pressed { 3.0 } else { (area.size.y * 0.45).clamp(4.0, 9.0) };
    canvas.rectangle(Area::new(area.min.x + 3.0, area.min.y, area.size.x - 6.0, cap), colour);
    lamp(canvas, Vec2::new(area.centre().x, area.min.y + area.size.y * 0.68), colour, on);
}

fn lamp_colour(game: &Game, switch: usize) -> Colour {
    if is_lit(game, switch) { theme::good() } else { WORKS_EDGE }
}

fn lamp(canvas: &Canvas, at: Vec2, colour: Colour, on: bool) {
    canvas.ring(at, 6.0, 2.0, colour);
    if on {
        canvas.disc(at, 3.5, colour);
    }
}

fn draw_one_way(solid: &Solid, area: Area, canvas: &Canvas) {
    let (a, b) = (area.min, area.max());
    let colour = edge_of(solid.material);
    canvas.rectangle(area, WORKS.faded(0.30));
    let Sides { left, right, top, .. } = solid.sides;
    let (from, to, through) = match (left, right, top) {
        (true, ..) => (a, Vec2::new(a.x, b.y), Vec2::new(-1.0, 0.0)),
        (_, true, _) => (Vec2::new(b.x, a.y), b, Vec2::new(1.0, 0.0)),
        (_, _, true) => (a, Vec2::new(b.x, a.y), Vec2::new(0.0, -1.0)),
        _ => (Vec2::new(a.x, b.y), b, Vec2::new(0.0, 1.0)),
    };
    let (along, inset) = ((to - from).normalize_or_zero(), -through * 2.5);
    canvas.line(from + inset, to + inset, 5.0, colour);
    let teeth = ((to - from).length() / 22.0).floor().max(1.0);
    for tooth in 0..teeth as usize {
        let at = from.lerp(to, (tooth as f32 + 0.5) / teeth) - through * 12.0;
        for side in [-1.0, 1.0] {
            canvas.line(at + through * 4.0, at + along * (4.0 * side), 1.5, colour.faded(0.7));
        }
    }
}

fn draw_skin(solid: &Solid, bounds: &Aabb, runs: bool, (view, canvas): (&Viewport, &Canvas), time: f64) {
    if solid.belt != 0.0 {
        let drift = if runs { (time * solid.belt).rem_euclid(CHEVRON_STEP) } else { 0.0 };
        let colour = if runs { theme::text() } else { theme::quiet() };
        draw_chevrons(bounds, (bounds.min.y + CHEVRON * 0.75, drift, solid.belt.signum()), (view, canvas), colour.faded(0.75));
        if bounds.size().y > 4.0 * CHEVRON {
            let place = (bounds.max.y - CHEVRON * 0.75, (CHEVRON_STEP - drift).rem_euclid(CHEVRON_STEP), -solid.belt.signum());
            draw_chevrons(bounds, place, (view, canvas), colour.faded(0.75));
        }
        let area = view.exact(bounds);
        for y in [area.min.y + 1.0, area.max().y - 1.0] {
            canvas.line(Vec2::new(area.min.x, y), Vec2::new(area.max().x, y), 2.0, edge_of(solid.material));
        }
    }
    if solid.material.restitution > 0.0 {
        let (low, high) = (bounds.min.y + 0.16, bounds.min.y + 0.04);
        let points = (bounds.size().x / 0.2).floor().max(2.0);
        let at = |i: f64, y: f64| view.point(DVec2::new(bounds.min.x + bounds.size().x * i / points, y));
        for i in 0..points as usize {
            let (a, b) = if i % 2 == 0 { (low, high) } else { (high, low) };
            canvas.line(at(i as f64, a), at(i as f64 + 1.0, b), 2.5, edge_of(solid.material));
        }
    }
}

/// Chevrons along a height (m) that point to a side, each shifted by `drift` (m) from its rest.
fn draw_chevrons(bounds: &Aabb, (y, drift, side): (f64, f64, f64), (view, canvas): (&Viewport, &Canvas), colour: Colour) {
    let visible = view.visible();
    let strip = Aabb::new(DVec2::new(bounds.min.x, y - CHEVRON * 0.7), DVec2::new(bounds.max.x, y + CHEVRON * 0.7));
    if !strip.touches(&visible, 0.0) {
        return;
    }
    canvas.rectangle(view.rect(&strip), Colour::hex(0x10151E));
    let mut x = bounds.min.x + drift;
    while x < bounds.max.x {
        let tip = DVec2::new(x + side * CHEVRON * 0.3, y);
        let inside = |x: f64| x > bounds.min.x + 0.05 && x < bounds.max.x - 0.05;
        let tail = x - side * CHEVRON * 0.3;
        if inside(tip.x) && inside(tail) && x > visible.min.x - 1.0 && x < visible.max.x + 1.0 {
            for up in [-1.0, 1.0] {
                canvas.line(view.point(tip), view.point(DVec2::new(tail, y + up * CHEVRON * 0.5)), 2.0, colour);
            }
        }
        x += CHEVRON_STEP;
    }
}

fn draw_cracks(solid: &Solid, area: Area, canvas: &Canvas) {
    const CRACKS: [[f32; 2]; 5] = [[0.05, 0.0], [0.95, 0.12], [1.0, 0.85], [0.3, 1.0], [0.0, 0.6]];
    let colour = Colour::hex(0x0A0D12);
    let at = |[x, y]: [f32; 2]| area.min + area.size * Vec2::new(x, y);
    let middle = [0.47, 0.52];
    for (i, end) in CRACKS.into_iter().enumerate() {
        let bend = if i % 2 == 0 { 0.09 } else { -0.07 };
        let knee = [(middle[0] + end[0]) * 0.5 + bend, (middle[1] + end[1]) * 0.5 - bend];
        canvas.line(at(middle), at(knee), 2.5, colour);
        canvas.line(at(knee), at(end), 1.5, colour);
    }
    dashed_outline(canvas, area, edge_of(solid.material));
}

pub fn debris(particles: &mut Particles, block: &Aabb) {
    for _ in 0..(block.size().x * block.size().y * 14.0).clamp(12.0, 60.0) as usize {
        let part = DVec2::new(particles.between(0.0, 1.0), particles.between(0.0, 1.0));
        let velocity = DVec2::new(particles.between(-3.0, 3.0), particles.between(-3.0, 1.0));
        let life = particles.between(0.4, 1.0);
        particles.add(Particle::new(ParticleLook::Dust, theme::quiet(), (block.min + part * block.size(), velocity), life));
    }
}

fn edge_of(material: Material) -> Colour {
    material_edge(material.name).unwrap_or(WORKS_EDGE)
}

fn arrow(canvas: &Canvas, view: &Viewport, at: DVec2, way: DVec2, colour: Colour) {
    let [tail, tip] = [at - way * 0.5, at + way * 0.5].map(|end| view.point(end));
    let back = (tail - tip) * 0.4;
    canvas.line(tail, tip, 1.5, colour);
    for side in [-1.0, 1.0] {
        canvas.line(tip, tip + back + back.perp() * (0.7 * side), 1.5, colour);
    }
}

fn dashed_outline(canvas: &Canvas, area: Area, colour: Colour) {
    let corners = area.corners();
    for i in 0..4 {
        canvas.dashed(&[corners[i], corners[(i + 1) % 4]], &DASH, 2.0, colour);
    }
}
