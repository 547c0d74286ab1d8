//! Zones: objectives, death boxes, air streams and liquids.

use super::art::{self, Tile};
use super::labels::{self, LabelOf, LevelLabel};
use super::theme::{self, HAZARD_EDGE, PLATE_FILL};
use super::{camera::Viewport, emitters::objective_colour};
use crate::draw::layout::{Area, DETAILS, Vec2, nearest_size};
use crate::draw::{Canvas, Colour, Quads, Style};
use crate::game::Game;
use crate::level::{Fluid, Level, ObjectiveKind, Solid};
use crate::physics::{Aabb, DVec2};

/// Radii of the rings of hold times: round an objective's icon, canvas units; and round a held body, m.
const ICON_RING: f32 = 14.0;
const HOLD_RING: f64 = 1.45;
/// Height of the light over a goal, canvas units.
const COLUMN: f32 = 110.0;
/// Width and height of a wave on a liquid's surface, canvas units; the height is that of both waves together.
const WAVE_LENGTH: f32 = 52.0;
const WAVE_HEIGHT: f32 = 5.0;
/// Opacity of a liquid at its surface, half way down and at its bottom, and the share of its colour on bodies in it.
const SHALLOW: f32 = 0.50;
const MIDDLE: f32 = 0.34;
const DEEP: f32 = 0.50;
/// Depth of the light below a liquid's surface, and its opacity; that of the line below the surface, canvas units.
const BAND: f32 = 70.0;
const BAND_LIGHT: f32 = 0.16;
const UNDERLINE: f32 = 6.0;
/// Depth of the net of light below a surface, m, its opacity, and the width of its meshes, canvas units.
const CAUSTICS: f64 = 3.2;
const CAUSTIC_LIGHT: f32 = 0.10;
const MESH: f32 = 46.0;
const STAIN: f32 = 0.5;
/// A box nearer than this to a liquid's surface lies on it, m.
const ON_IT: f64 = 1e-6;
/// Spacing of a stream's chevrons, m, and their speed, m/s.
const CHEVRON_STEP: f64 = 2.0;
const CHEVRON_SPEED: f64 = 2.5;

/// The objective blocks. Their columns of light grow with the `answer` (0 … 1) of a solved level.
pub fn draw_objectives(game: &Game, view: &Viewport, canvas: &Canvas, (time, answer): (f64, f32)) {
    for (index, objective) in game.level().objectives.iter().enumerate() {
        if !objective.bounds.touches(&view.visible(), 2.0) {
            continue;
        }
        let colour = objective_colour(game, index);
        let area = view.rect(&objective.bounds);
        let pulse = 0.5 + 0.5 * (time * 2.6).sin() as f32;
        art::halo(canvas, area, 26.0, colour.faded(0.28 + 0.14 * pulse));
        // No liquid or picture behind it may change its colour.
        let (high, low) = (theme::plate().mixed(colour, PLATE_FILL[0]), theme::plate().mixed(colour, PLATE_FILL[1]));
        let mut quads = column(area, COLUMN * (1.0 + 2.0 * answer), colour.faded(0.16 + 0.08 * pulse + 0.3 * answer));
        quads.quad(area.corners(), [high, high, low, low]);
        canvas.quads(quads);
        canvas.rectangle_edge(area, 2.0, colour);
    }
}

/// A column of light over a box: it fades upwards and to its sides.
fn column(area: Area, height: f32, colour: Colour) -> Quads {
    const STRIPS: u8 = 8;
    let mut quads = Quads::default();
    let at = |strip: u8| {
        let across = f32::from(strip) / f32::from(STRIPS);
        let side = 2.0 * across - 1.0;
        (area.min.x + area.size.x * across, colour.faded((1.0 - side * side).powf(1.5)))
    };
    for strip in 0..STRIPS {
        let ((left, a), (right, b)) = (at(strip), at(strip + 1));
        let (foot, top) = (area.min.y, area.min.y - height);
        quads.quad(Area::new(left, top, right - left, foot - top).corners(), [a.faded(0.0), b.faded(0.0), b, a]);
    }
    quads
}

/// The words in the level: the author's; beside an objective its sign: the ship's outline, a key object's diamond, or a tick where it is met.
pub fn draw_labels(game: &Game, labels: &[LevelLabel], view: &Viewport, canvas: &Canvas) {
    let level = game.level();
    for LevelLabel { of, words, area } in labels {
        let style = Style::new(DETAILS, theme::text()).middle();
        match *of {
            LabelOf::Text(index) => {
                let text = &level.texts[index];
                let colour = text.colour.map_or_else(theme::text, Colour::of);
                canvas.text(words, area.min, Style::new(nearest_size(view.length(text.size)), colour));
            }
            LabelOf::Objective(index) => {
                let icon = labels::sign(&level.objectives[index]);
                draw_sign(game, index, Vec2::new(area.min.x + icon / 2.0, area.centre().y), canvas);
                canvas.text(words, Vec2::new(area.min.x + icon + labels::BESIDE_SIGN, area.centre().y), style);
            }
            LabelOf::Plate(_) => {
                // On a ground of its own: edges and hatching of the rock lie behind it.
                canvas.rounded(*area, 3.0, theme::ground().faded(0.8));
                canvas.text(words, area.centre(), style.mono().centred());
            }
        }
    }
}

fn draw_sign(game: &Game, index: usize, middle: Vec2, canvas: &Canvas) {
    let (objective, colour) = (&game.level().objectives[index], objective_colour(game, index));
    if game.met()[index] {
        canvas.line(middle + Vec2::new(-6.0, 0.0), middle + Vec2::new(-1.0, 5.0), 3.0, colour);
        canvas.line(middle + Vec2::new(-1.5, 5.0), middle + Vec2::new(7.0, -5.0), 3.0, colour);
        return;
    }
    match objective.kind {
        ObjectiveKind::Player => art::draw(canvas, Tile::Ship, Area::around(middle, Vec2::splat(20.0)), 0.0, Colour::WHITE),
        ObjectiveKind::Physics => match objective.colour {
            Some(key) => {
                diamond(canvas, middle, 9.0, colour);
                diamond(canvas, middle, 6.5, Colour::of(key));
            }
            None => diamond(canvas, middle, 7.0, colour),
        },
    }
    if objective.hold > 0.0 {
        ring(canvas, (middle, ICON_RING), 1.0, colour.faded(0.35));
        ring(canvas, (middle, ICON_RING), game.held(index) as f32, theme::good());
    }
}

/// The rings of hold times, round the ship (at `ship`, m) or the block that waits for a key: over all, for a ship on a pad hides its label.
pub fn draw_holds(game: &Game, ship: DVec2, view: &Viewport, canvas: &Canvas) {
    for (index, objective) in game.level().objectives.iter().enumerate() {
        let held = game.held(index) as f32;
        if held > 0.0 && !game.met()[index] {
            let at = match objective.kind {
                ObjectiveKind::Player => ship,
                ObjectiveKind::Physics => objective.bounds.centre(),
            };
            let place = (view.point(at), view.length(HOLD_RING));
            ring(canvas, place, 1.0, objective_colour(game, index).faded(0.3));
            ring(canvas, place, held, theme::good());
        }
    }
}

/// A part (0 … 1) of a ring round a point, clockwise from the top.
pub(super) fn ring(canvas: &Canvas, (centre, radius): (Vec2, f32), part: f32, colour: Colour) {
    const SIDES: usize = 36;
    let at = |side: usize| {
        let angle = std::f32::consts::TAU * (side as f32 / SIDES as f32).min(part) - std::f32::consts::FRAC_PI_2;
        centre + Vec2::from_angle(angle) * radius
    };
    for side in 0..(part * SIDES as f32).ceil() as usize {
        canvas.line(at(side), at(side + 1), 3.0, colour);
    }
}

/// The sign of key objects.
pub fn diamond(canvas: &Canvas, centre: Vec2, reach: f32, colour: Colour) {
    let corners = [Vec2::new(0.0, -reach), Vec2::new(reach, 0.0), Vec2::new(0.0, reach), Vec2::new(-reach, 0.0)];
    canvas.convex(&corners.map(|corner| centre + corner), colour);
}

pub fn draw_obstacles(level: &Level, view: &Viewport, canvas: &Canvas, time: f64) {
    let visible = view.visible();
    let pulse = 0.5 + 0.5 * (time * 4.2).sin() as f32;
    let in_view = || level.obstacles.iter().filter(|bounds| bounds.touches(&visible, 1.0));
    for bounds in in_view() {
        art::halo(canvas, view.rect(bounds), 22.0, theme::bad().faded(0.42 + 0.2 * pulse));
    }
    for bounds in in_view() {
        art::fill(canvas, Tile::Hatching, bounds, view, Colour::WHITE);
    }
    for bounds in in_view() {
        let area = view.rect(bounds);
        canvas.rectangle_edge(area.inset(-2.0), 2.0, theme::plate());
        canvas.rectangle_edge(area, 2.0, HAZARD_EDGE);
        canvas.rectangle_edge(area.inset(2.0), 2.0, theme::plate().faded(0.6));
    }
}

/// The zones of active streams and, over them, the chevrons that drift with the wind.
pub fn draw_streams(game: &Game, view: &Viewport, canvas: &Canvas, time: f64) {
    let visible = view.visible();
    let blowing = game.level().streams.iter().enumerate().filter(|(index, _)| game.world().blows(*index));
    for (_, stream) in blowing.filter(|(_, stream)| stream.zone.touches(&visible, 0.0)) {
        let zone = view.rect(&stream.zone);
        let colour = theme::force(crate::physics::ForceKind::Wind);
        canvas.rectangle(zone, colour.faded(0.055));
        let force = stream.force;
        let way = if force.x.abs() > force.y.abs() { DVec2::X * force.x.signum() } else { DVec2::Y * force.y.signum() };
        let size = stream.zone.size();
        let length = (size * way.abs()).element_sum();
        let across = (size - size * way.abs()).element_sum();
        let start = stream.zone.centre() - way * (length * 0.5);
        let mut along = (time * CHEVRON_SPEED).rem_euclid(CHEVRON_STEP);
        while along < length {
            // Chevrons fade in at the source and out at the end of the zone.
            let strength = (along.min(length - along) / CHEVRON_STEP).min(1.0) as f32;
            let tip = start + way * along;
            let arm = (across * 0.18).min(0.6);
            for side in [-1.0, 1.0] {
                let back = tip - way * arm + way.perp() * (arm * side);
                canvas.line(view.point(tip), view.point(back), 2.5, colour.faded(0.28 * strength));
            }
            along += CHEVRON_STEP;
        }
    }
}

pub fn draw_sources(level: &Level, view: &Viewport, canvas: &Canvas) {
    for stream in level.streams.iter().filter(|stream| stream.source.touches(&view.visible(), 0.0)) {
        let area = view.rect(&stream.source);
        canvas.rectangle(area, Colour::hex(0x55647C));
        canvas.rectangle_edge(area, 2.0, Colour::hex(0x8FA3BF));
        let inner = area.inset(5.0);
        let upright = stream.force.x.abs() > stream.force.y.abs();
        let (along, slat) = if upright { (Vec2::Y, Vec2::new(inner.size.x, 4.0)) } else { (Vec2::X, Vec2::new(4.0, inner.size.y)) };
        for i in 0..(inner.size.dot(along) / 9.0).floor().max(0.0) as usize {
            let min = inner.min + along * (2.0 + 9.0 * i as f32);
            canvas.rectangle(Area { min, size: slat.max(Vec2::ZERO) }, Colour::hex(0x2A3344));
        }
        let way = stream.force.normalize_or_zero().as_vec2();
        let reach = area.size.x.min(area.size.y) * 0.32;
        let centre = area.centre();
        let corners = [centre + way * reach, centre - way * reach + way.perp() * reach, centre - way * reach - way.perp() * reach];
        canvas.convex(&corners, theme::text());
    }
}

/// The liquids. They lie below everything in them, so that they never change the colour of a goal or a hazard; [`in_liquid`] tints bodies.
pub fn draw_fluids(level: &Level, view: &Viewport, canvas: &Canvas, time: f64) {
    let visible = view.visible();
    for (index, fluid) in level.fluids.iter().enumerate().filter(|(_, fluid)| fluid.zone.touches(&visible, 0.5)) {
        let colour = Colour::of(fluid.colour);
        let shown = Aabb::new(fluid.zone.min.max(visible.min - 1.0), fluid.zone.max.min(visible.max + 1.0));
        let all = view.rect(&fluid.zone);
        let area = view.rect(&shown);
        let top = (all.min.y + WAVE_HEIGHT).max(area.min.y);
        let thick = |y: f32| {
            let share = ((y - all.min.y) / all.size.y.max(1.0)).clamp(0.0, 1.0);
            let end = if share < 0.5 { SHALLOW } else { DEEP };
            colour.faded(MIDDLE + (end - MIDDLE) * (2.0 * share - 1.0).abs())
        };
        let (a, b) = (Vec2::new(area.min.x, top), Vec2::new(area.max().x, area.max().y));
        let mut quads = Quads::default();
        let mut layer = |from: f32, to: f32, [high, low]: [Colour; 2]| {
            if from < to {
                quads.quad(Area::new(a.x, from, b.x - a.x, to - from).corners(), [high, high, low, low]);
            }
        };
        let middle = all.centre().y.clamp(a.y, b.y);
        layer(a.y, middle, [thick(a.y), thick(middle)]);
        layer(middle, b.y, [thick(middle), thick(b.y)]);
        let lit = |y: f32| mixed(colour).faded(BAND_LIGHT * (1.0 - (y - all.min.y) / BAND).max(0.0));
        let end = (all.min.y + BAND).clamp(a.y, b.y);
        layer(a.y, end, [lit(a.y), lit(end)]);
        // Under rock or another liquid the surface is flat; elsewhere it has waves.
        let open = open_surface(&level.fluids, &level.world, index);
        let ends = [fluid.zone.min.x].into_iter().chain(open.iter().map(|span| span.1));
        for (from, to) in ends.zip(open.iter().map(|span| span.0).chain([fluid.zone.max.x])).filter(|(from, to)| from < to) {
            let lid = view.rect(&Aabb::new(DVec2::new(from, fluid.zone.min.y), DVec2::new(to, fluid.zone.max.y)));
            let (left, right) = (lid.min.x.max(area.min.x), lid.max().x.min(area.max().x));
            let (a, b) = (Vec2::new(left, all.min.y), Vec2::new(right, all.min.y + WAVE_HEIGHT));
            if a.x < b.x {
                quads.quad([a, Vec2::new(b.x, a.y), b, Vec2::new(a.x, b.y)], [thick(a.y); 4]);
                quads.stroke([a, Vec2::new(b.x, a.y)], 1.5, [mixed(colour).faded(0.5); 2]);
            }
        }
        canvas.quads(quads);
        for (from, to) in open {
            let span = view.rect(&Aabb::new(DVec2::new(from, fluid.zone.min.y), DVec2::new(to, fluid.zone.max.y)));
            let shown = (span.min.x.max(area.min.x), span.max().x.min(area.max().x));
            if shown.0 < shown.1 {
                surface(canvas, shown, all, colour, time);
            }
        }
        canvas.quads(caustics(all, area, view.length(CAUSTICS), (mixed(colour), time)));
    }
}

/// The stretches of a liquid's surface, m from left to right, without another liquid or rock on them.
fn open_surface(fluids: &[Fluid], world: &[Solid], index: usize) -> Vec<(f64, f64)> {
    let zone = &fluids[index].zone;
    let others = fluids.iter().enumerate().filter(|(other, _)| *other != index).map(|(_, fluid)| fluid.zone);
    let rock = world.iter().filter(|solid| solid.is_rock()).map(|solid| solid.bounds);
    let mut lids: Vec<Aabb> = others.chain(rock).filter(|lid| lid.min.y < zone.min.y && lid.touches(zone, ON_IT)).collect();
    lids.sort_by(|a, b| a.min.x.total_cmp(&b.min.x));
    let (mut open, mut from) = (Vec::new(), zone.min.x);
    for lid in lids {
        if lid.min.x.min(zone.max.x) > from {
            open.push((from, lid.min.x.min(zone.max.x)));
        }
        from = from.max(lid.max.x);
    }
    if from < zone.max.x {
        open.push((from, zone.max.x));
    }
    open
}

/// The colour that multiplies a picture: white in the air, a mix with a liquid's colour by the share of the box in it.
pub fn in_liquid(fluids: &[Fluid], bounds: &Aabb) -> Colour {
    let all = bounds.size().x * bounds.size().y;
    fluids.iter().fold(Colour::WHITE, |light, fluid| {
        let shared = (bounds.max.min(fluid.zone.max) - bounds.min.max(fluid.zone.min)).max(DVec2::ZERO);
        let share = STAIN * (shared.x * shared.y / all) as f32;
        let colour = Colour::of(fluid.colour);
        let stained = |light: f32, colour: f32| light * (1.0 - share + share * colour);
        Colour::new(stained(light.r, colour.r), stained(light.g, colour.g), stained(light.b, colour.b), 1.0)
    })
}

/// A net of light below a liquid's surface, fainter with depth. `all` is the liquid, `area` its part in view.
fn caustics(all: Area, area: Area, depth: f32, (colour, time): (Colour, f64)) -> Quads {
    const ROWS: u8 = 5;
    let mut quads = Quads::default();
    // Knots of the net wander about their places.
    let knot = |k: i64, row: u8| {
        let (sway, phase) = ((time * 0.7 + k as f64 * 2.4 + f64::from(row) * 1.7).sin() as f32, (k as f32 * 1.9).sin());
        let share = f32::from(row) / f32::from(ROWS);
        let x = all.min.x + (k as f32 + 0.5 * f32::from(row % 2) + 0.22 * sway + 0.2 * phase) * MESH;
        Vec2::new(x, all.min.y + WAVE_HEIGHT + share * (0.5 + 0.5 * share) * depth + 3.0 * sway)
    };
    let clear = |at: Vec2| colour.faded(CAUSTIC_LIGHT * (1.0 - (at.y - all.min.y) / depth).clamp(0.0, 1.0));
    let first = ((area.min.x - all.min.x) / MESH).floor() as i64 - 1;
    for k in first..=first + (area.size.x / MESH) as i64 + 3 {
        for row in 0..ROWS {
            let from = knot(k, row);
            for next in [0, 1] {
                let to = knot(k + next - i64::from(row % 2 == 0), row + 1);
                if [from, to].into_iter().all(|at| at.cmpge(area.min).all() && at.cmple(area.max()).all()) {
                    quads.stroke([from, to], 2.2, [clear(from), clear(to)]);
                }
            }
        }
    }
    quads
}

/// The top of a liquid: columns under a wave, and the bright line along it.
fn surface(canvas: &Canvas, shown: (f32, f32), all: Area, colour: Colour, time: f64) {
    let level = all.min.y;
    let bottom = level + WAVE_HEIGHT;
    let height = |x: f32| {
        let wave = (f64::from(x / WAVE_LENGTH) * std::f64::consts::TAU + time * 2.2).sin() * 0.7
            + (f64::from(x / WAVE_LENGTH) * 3.9 - time * 1.3).sin() * 0.3;
        level + WAVE_HEIGHT * 0.5 * (1.0 + wave as f32)
    };
    let mut quads = Quads::default();
    for edges in columns(shown, all.min.x) {
        let [a, b] = edges.map(|x| Vec2::new(x, height(x - all.min.x)));
        quads.quad([a, b, Vec2::new(b.x, bottom), Vec2::new(a.x, bottom)], [colour.faded(SHALLOW); 4]);
        let under = mixed(colour).faded(0.22);
        let below = Vec2::Y * UNDERLINE;
        quads.quad([a, b, b + below, a + below], [under, under, under.faded(0.0), under.faded(0.0)]);
        canvas.line(a, b, 2.2, mixed(colour).faded(0.85));
    }
    canvas.quads(quads);
}

/// The edges of columns fixed to a liquid that begins at `min`, canvas units; counted, since at some zooms a sum of steps stands still in rounding.
fn columns((left, right): (f32, f32), min: f32) -> impl Iterator<Item = [f32; 2]> {
    const STEP: f32 = 8.0;
    let column = move |x: f32| ((x - min) / STEP).floor() as i64;
    let edge = move |k: i64| (min + k as f32 * STEP).clamp(left, right);
    (column(left)..=column(right)).map(move |k| [edge(k), edge(k + 1)])
}

/// Half way to white.
fn mixed(colour: Colour) -> Colour {
    Colour::new(0.5 + colour.r * 0.5, 0.5 + colour.g * 0.5, 0.5 + colour.b * 0.5, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::Material;

    #[test]
    fn a_liquid_has_waves_only_where_nothing_lies_on_it() {
        let zone = |left: f64, top: f64, right: f64, bottom: f64| Aabb::new(DVec2::new(left, top), DVec2::new(right, bottom));
        let fluid = |zone| Fluid { zone, density: 1.0, viscosity: 1.0, colour: [0, 0, 255] };
        let mut fluids = [fluid(zone(0.0, 5.0, 10.0, 9.0)), fluid(zone(2.0, 1.0, 4.0, 5.0))];
        assert_eq!(open_surface(&fluids, &[], 0), [(0.0, 2.0), (4.0, 10.0)]);
        assert_eq!(open_surface(&fluids, &[], 1), [(2.0, 4.0)]);
        let solid = |bounds| Solid::new(bounds, Material::ASPHALT);
        let world = [solid(zone(-1.0, 4.0, 3.0, 6.0)), solid(zone(4.0, 8.0, 6.0, 9.0))];
        assert_eq!(open_surface(&fluids, &world, 0), [(4.0, 10.0)], "a stone on the ground covers no surface");
        fluids[1].zone = zone(-5.0, 1.0, 15.0, 5.0);
        assert!(open_surface(&fluids, &[], 0).is_empty());
    }

    #[test]
    fn the_columns_of_a_surface_are_counted_at_any_zoom() {
        for i in 0..200_000_u32 {
            // Golden ratios of a place and of a zoom.
            let part = |ratio: f64| (f64::from(i) * ratio).fract() as f32;
            let (min, left) = (-3000.0 * part(0.618_033_988_75), 40.0 * part(0.754_877_666_25));
            let (mut last, mut count) = (left, 0);
            for [a, b] in columns((left, left + 900.0), min) {
                assert!((a - last).abs() < 1e-3 && b >= a && b - a < 8.01, "from {left} beside {min}: {a} to {b}");
                (last, count) = (b, count + 1);
            }
            assert!((last - left - 900.0).abs() < 1e-3 && count < 116, "from {left} beside {min}: {count} columns to {last}");
        }
    }

    #[test]
    fn what_is_in_a_liquid_takes_on_some_of_its_colour_by_the_share_that_is_in_it() {
        let bounds = |top: f64| Aabb::new(DVec2::new(0.0, top), DVec2::new(2.0, top + 2.0));
        let (density, viscosity) = (1.0, 1.0);
        let fluids = [Fluid { zone: bounds(10.0), density, viscosity, colour: [255, 0, 0] }];
        assert_eq!(in_liquid(&fluids, &bounds(7.0)), Colour::WHITE);
        assert_eq!(in_liquid(&fluids, &bounds(10.0)), Colour::new(1.0, 1.0 - STAIN, 1.0 - STAIN, 1.0));
        let half = in_liquid(&fluids, &bounds(9.0));
        assert!((half.g - (1.0 - STAIN / 2.0)).abs() < 1e-6 && half.r == 1.0);
    }
}
