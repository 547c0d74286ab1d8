//! The ground of the level, its words, the names of its mechanisms and links; [`super::terrain`] draws the solids. Pictures lie behind bodies or in
//! front of them; one behind lies on rock as well as on air: below goals and hazards in the air, above the rock.

use super::terrain::{Terrain, parts};
use super::{art::Pictures, camera::Viewport, mechanisms::movers, sky, theme, things::ellipse};
use crate::draw::layout::{Area, DETAILS, MONO_ADVANCE, Vec2, text_room};
use crate::draw::{Canvas, Colour, Style};
use crate::game::{Game, plain_name};
use crate::level::{Level, Look, Solid, SurfaceOf, Text};
use crate::physics::{Aabb, BodyId, DVec2, Link, LinkEnd, LinkLaw, Source};
use crate::words::tr;

/// Opacity of the graph paper over an author's picture.
const PAPER_OVER_PICTURE: f32 = 0.45;
/// Fine graph paper is left out below this width of a metre, canvas units: it would be a grey haze.
const FINEST_PAPER: f64 = 8.0;

/// The most that the nearest size of type may exceed the author's.
const SNAPPED: f64 = 1.25;

/// The background (the author's picture, or the sky of the level's world) and the graph paper: a fine line each metre, a heavy one each ten.
pub fn draw_ground(level: &Level, terrain: &Terrain, pictures: &Pictures, (view, canvas): (&Viewport, &Canvas), time: f64) {
    let tint = terrain.tint;
    let all = view.rect(&Aabb::new(DVec2::ZERO, level.size));
    let picture = level.background.as_ref().and_then(|path| pictures.get(path));
    if let Some(image) = picture {
        canvas.image(image, all, Colour::WHITE);
    } else if let Some(landscape) = level.landscape {
        sky::draw((landscape, level.storeys), (&terrain.air(view), terrain.floor(level)), (view, canvas), time);
    }
    let strength = if picture.is_some() { PAPER_OVER_PICTURE } else { 1.0 };
    let fine = view.scale >= FINEST_PAPER;
    for heavy in [false, true] {
        if heavy || fine {
            paper_lines(view, canvas, heavy, (if heavy { tint.heavy } else { tint.fine }).faded(strength));
        }
    }
}

fn paper_lines(view: &Viewport, canvas: &Canvas, heavy: bool, colour: Colour) {
    let (visible, level) = (view.visible(), view.level());
    let (from, to) = (visible.min.max(level.min), visible.max.min(level.max));
    let shown = view.rect(&Aabb::new(from, to));
    let width = canvas.frame().pixel * if heavy { 2.0 } else { 1.0 };
    let lines = |from: f64, to: f64| (from.ceil() as i64..=to.floor() as i64).filter(move |i| (i % 10 == 0) == heavy);
    for x in lines(from.x, to.x) {
        let at = view.rect(&Aabb::around(DVec2::new(x as f64, 0.0), DVec2::ZERO)).min.x;
        canvas.rectangle(Area::new(at - (width * 0.5).floor(), shown.min.y, width, shown.size.y), colour);
    }
    for y in lines(from.y, to.y) {
        let at = view.rect(&Aabb::around(DVec2::new(0.0, y as f64), DVec2::ZERO)).min.y;
        canvas.rectangle(Area::new(shown.min.x, at - (width * 0.5).floor(), shown.size.x, width), colour);
    }
}

/// The areas of the words, m: at least the room that they need.
pub fn text_areas(level: &Level) -> Vec<Aabb> {
    let area = |it: &Text| Aabb::new(it.position, it.position + text_room(tr(&it.text), it.size as f32).as_dvec2() * SNAPPED);
    level.texts.iter().map(area).collect()
}

pub fn draw_decoration(level: &Level, in_front: bool, pictures: &Pictures, (view, canvas): (&Viewport, &Canvas)) {
    for shown in level.decoration.iter().filter(|shown| shown.in_front == in_front && shown.bounds.touches(&view.visible(), 0.0)) {
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
    for picture in level.decoration.iter().filter(|picture| !picture.in_front && picture.bounds.touches(&view.visible(), 0.0)) {
        // A plain shape is a mark on the air: rock hides it.
        let Look::Image(path) = &picture.look else { continue };
        let Some(image) = pictures.get(path) else { continue };
        for part in parts(&terrain.mass, &picture.bounds) {
            // The ends are whole pixels of the window, so that the parts adjoin as the rock's do.
            let (area, all) = (view.rect(&part), view.rect(&picture.bounds));
            let shown = Area { min: (area.min - all.min) / all.size, size: area.size / all.size };
            canvas.picture(image, shown, area, (0.0, Colour::WHITE));
        }
    }
}

/// Around a name, canvas units.
const AROUND: Vec2 = Vec2::new(5.0, 2.0);

/// The names of all mechanisms in view with their areas, in the words of the details and of the switches.
pub fn in_view(game: &Game, view: &Viewport) -> Vec<(String, Area)> {
    let level = game.level();
    let called = |of: SurfaceOf, name: Option<&str>| {
        let plain = plain_name(level, Source::Surface(level.surface_index(of) as u32));
        name.map_or(plain.clone(), |name| format!("{plain}: {name}"))
    };
    let special = |solid: &Solid| !solid.is_rock() || solid.belt != 0.0 || solid.material.restitution > 0.0;
    let solids = level.world.iter().enumerate().filter(|(index, solid)| special(solid) && !game.mechanisms().is_broken(*index));
    let solids = solids.map(|(index, solid)| {
        let breaks = solid.breaks.map(|impulse| tr!("breaks above {impulse} N·s", impulse = format_args!("{impulse:.0}")));
        (called(SurfaceOf::World(index), breaks.as_deref().or(solid.name.as_deref())), solid.bounds)
    });
    let movers = level.movers.iter().zip(movers(game)).enumerate();
    let movers = movers.map(|(index, (mover, bounds))| (called(SurfaceOf::Mover(index), mover.solid.name.as_deref()), bounds));
    let doors = level.doors.iter().enumerate();
    let doors = doors.map(|(index, door)| (called(SurfaceOf::Door(index), door.name.as_deref()), door.bounds));
    let switches = level.switches.iter().enumerate().map(|(index, switch)| {
        let works: Vec<&str> = switch.works.iter().map(|work| work.name.as_str()).collect();
        (tr!("switch {number}: {works}", number = index + 1, works = works.join(", ")), switch.bounds)
    });
    let fields = level.fields.iter().enumerate().map(|(index, field)| {
        let [x, y] = field.strength.to_array().map(|part| format!("{part:.1}"));
        (tr!("gravity {index}: ({x}, {y}) N/kg", index = index + 1, x, y), field.zone)
    });
    let pods = level.pods.iter().enumerate().filter(|(index, _)| !game.mechanisms().is_taken(*index));
    let pods = pods.map(|(index, pod)| {
        (tr!("pod {number}: {fuel} fuel", number = index + 1, fuel = format_args!("{:.0}", pod.fuel)), pod.bounds)
    });
    let named = solids.chain(movers).chain(doors).chain(switches).chain(fields).chain(pods);
    named.filter(|(_, bounds)| bounds.touches(&view.visible(), 0.0)).map(|(name, bounds)| (name, view.rect(&bounds))).collect()
}

/// Gives each name a free place beside its mechanism, if there is one, and adds it to `taken`. `text` is the height of letters.
pub fn place(named: Vec<(String, Area)>, text: f32, window: Area, taken: &mut Vec<Area>) -> Vec<(String, Area)> {
    let mut placed = Vec::new();
    for (name, of) in named {
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

pub fn draw_name(name: &str, area: Area, canvas: &Canvas) {
    canvas.rectangle(area, theme::ground().faded(0.8));
    canvas.text(name, area.centre(), Style::new(DETAILS, theme::text()).mono().centred().middle());
}

/// Length of rope for a turn of a coil, m, and its least and most turns.
const TURN: f64 = 0.35;
const TURNS: (f64, f64) = (5.0, 24.0);
/// Width of a coil to either side, m.
const COIL: f64 = 0.22;
/// Straight parts of a curve.
const PARTS: usize = 24;
/// The force at which a link is drawn with its full width, N.
const FULL: f64 = 3000.0;
/// Field lines bend to the side by these parts of the distance.
const FIELD: [f64; 4] = [-0.28, -0.1, 0.1, 0.28];
/// Dashes of a field line that run along it in a second.
const RUN: f64 = 1.5;

/// Draws all links that act, and the open ends of those that wait for a touch. `centre` is where a body is drawn, m.
pub fn draw_links(game: &Game, centre: impl Fn(BodyId) -> DVec2, (view, canvas): (&Viewport, &Canvas), time: f64) {
    for link in game.world().links().iter().filter(|link| !link.is_broken()) {
        let place = |end: LinkEnd| match end {
            LinkEnd::Body(body) => centre(body),
            LinkEnd::Place(place) => place,
        };
        let [from, to] = [LinkEnd::Body(link.def().body), link.def().to].map(place);
        let colour = theme::force(link.law().kind());
        if link.acts() {
            draw_link(link, [from, to], (view, canvas), time);
        } else if link.def().hook {
            [from, to].into_iter().for_each(|end| canvas.ring(view.point(end), view.length(0.2), 1.5, colour.faded(0.6)));
        }
        if matches!(link.def().to, LinkEnd::Place(_)) {
            canvas.disc(view.point(to), view.length(0.14), colour.faded(if link.acts() { 1.0 } else { 0.4 }));
            canvas.ring(view.point(to), view.length(0.24), 1.5, theme::text().faded(0.7));
        }
    }
}

fn draw_link(link: &Link, [from, to]: [DVec2; 2], (view, canvas): (&Viewport, &Canvas), time: f64) {
    let (colour, across, distance) = (theme::force(link.law().kind()), (to - from).perp().normalize_or_zero(), from.distance(to));
    let line = |width: f64, points: &dyn Fn(f64) -> DVec2| {
        let corners: Vec<Vec2> = (0..=PARTS).map(|i| view.point(points(i as f64 / PARTS as f64))).collect();
        corners.windows(2).for_each(|pair| canvas.line(pair[0], pair[1], width as f32, colour));
    };
    match link.law() {
        LinkLaw::Spring(spring) => {
            let turns = (spring.length / TURN).clamp(TURNS.0, TURNS.1).round() as usize;
            let corner = |i: usize| {
                let side = match i {
                    _ if i == 0 || i == 2 * turns => 0.0,
                    _ if i.is_multiple_of(2) => COIL,
                    _ => -COIL,
                };
                view.point(from.lerp(to, i as f64 / (2 * turns) as f64) + across * side)
            };
            (0..2 * turns).for_each(|i| canvas.line(corner(i), corner(i + 1), 2.0, colour));
        }
        LinkLaw::Rope(rope) => {
            // Half the depth of the triangle that a rope makes which hangs from its middle, and a bit less.
            let sag = 0.43 * (rope.length * rope.length - distance * distance).max(0.0).sqrt();
            let width =
                if sag > 0.0 { 1.5 } else { 2.0 + 2.0 * (rope.stiffness * (distance - rope.length) / FULL).clamp(0.0, 1.0) };
            line(width, &|part| from.lerp(to, part) + DVec2::new(0.0, 4.0 * sag * part * (1.0 - part)));
        }
        LinkLaw::Magnet(magnet) => {
            let pull = (magnet.strength.abs() / (distance * distance).max(magnet.nearest * magnet.nearest) / FULL).sqrt();
            let shown = colour.faded(pull.clamp(0.25, 0.9) as f32);
            for bend in FIELD {
                let along = |part: f64| from.lerp(to, part) + across * (4.0 * bend * distance * part * (1.0 - part));
                let shift = (time * RUN * magnet.strength.signum()).rem_euclid(1.0);
                for i in 0..PARTS / 2 {
                    let part = (i as f64 + shift) / (PARTS / 2) as f64;
                    let end = (part + 0.5 / (PARTS / 2) as f64).min(1.0);
                    canvas.line(view.point(along(part.min(1.0))), view.point(along(end)), 1.5, shown);
                }
            }
        }
    }
}
