//! What `check` warns of: a list of checks, each of which says what holds whatever the keys, or that a row can have no use.

use super::reach::grown;
use super::route::MoverPace;
use super::schema::values::LinkRowEnd;
use super::types::{Mover, Object, Objective, ObjectiveKind, Presser, SHIP_HALF, StarTouch, Switch};
use super::winnable::Checked;
use super::{draft::Draft, gates, problem::Problem, schema::typed::FromRow};
use crate::number::{fixed, trimmed};
use crate::physics::{Aabb, DVec2, LinkLaw, Material};
use crate::words::tr;
use std::collections::BTreeSet;

/// m/s. What is this fast crosses a screen in half a second: its author may have thought of pixels.
const LIKE_PIXELS: f64 = 80.0;

pub(super) fn warn(level: &Checked) -> Vec<Problem> {
    const CHECKS: [fn(&Checked) -> Vec<Problem>; 9] =
        [unreached, gates::warn, weak_engine, heavy_plates, like_pixels, long_holds, unused_keys, barred_pods, unbreakable];
    let pads = level.draft.objectives.iter();
    let unmet = pads.filter_map(|pad| too_heavy(level, pad).or_else(|| tied(level, pad)));
    CHECKS.iter().flat_map(|check| check(level)).chain(unmet).collect()
}

/// Objects to which neither the ship gets nor what it pushes: not even a box as small as the smallest of all. A link acts through rock.
fn unreached(level: &Checked) -> Vec<Problem> {
    let Draft { objects, links, .. } = level.draft;
    let half = objects.iter().fold(SHIP_HALF, |half, object| half.min(object.item.size * 0.5));
    let Some(own) = level.space.part((level.ship.item.position, half)) else { return Vec::new() };
    let part = |object: &FromRow<Object>| level.space.part((object.item.position, half)).unwrap_or(own);
    let linked: BTreeSet<&str> = links.iter().flat_map(|link| &link.item.ends).filter_map(LinkRowEnd::object).collect();
    let moved = objects.iter().filter(|object| object.item.name.as_deref().is_some_and(|name| linked.contains(name)));
    let reached: BTreeSet<u32> = moved.map(part).chain([own]).collect();
    let expected = tr("a route for the ship, or for an object that it can push");
    let unreached = objects.iter().filter(|object| !reached.contains(&part(object)));
    unreached.map(|object| object.problem("x", tr("an object that no one can reach"), expected)).collect()
}

/// Thrust below the ship's weight, where an objective lies above the start and nothing else moves any body upwards: winds, fields, liquids,
/// links, belts, movers, bounces, throws, and doors, which put a body out of themselves.
fn weak_engine(level: &Checked) -> Vec<Problem> {
    let (draft, ship) = (level.draft, &level.ship.item);
    let weight = ship.mass * draft.settings.row.gravity;
    let above =
        |pad: &FromRow<Objective>| pad.item.kind == ObjectiveKind::Player && pad.item.bounds.max.y < ship.position.y - SHIP_HALF.y;
    let objects = draft.objects.iter().map(|object| object.item.velocity.y);
    let lifted = draft.is_driven()
        || !draft.fluids.is_empty()
        || !draft.doors.is_empty()
        || level.zones().any(|(_, force, _)| force.y < 0.0)
        || objects.chain([ship.velocity.y]).any(|speed| speed < 0.0)
        || level.bounces();
    if ship.thrust >= weight || lifted || !draft.objectives.iter().any(above) {
        return Vec::new();
    }
    let found = tr!("{thrust} N, less than the ship's weight of {weight} N", thrust = ship.thrust, weight);
    vec![level.ship.problem("thrust", found, tr("more than that, as nothing in the level lifts the ship"))]
}

/// Plates that take more than all masses and the thrust together. A mover, a belt, a link, a wind, a zone or a liquid presses without such a bound.
fn heavy_plates(level: &Checked) -> Vec<Problem> {
    let (draft, ship) = (level.draft, &level.ship.item);
    if !draft.is_calm() {
        return Vec::new();
    }
    let objects = draft.objects.iter().filter(|object| !object.item.weightless).map(|object| object.item.mass);
    let most = ship.thrust + (ship.mass + objects.sum::<f64>()) * draft.settings.row.gravity.max(0.0);
    let heavy = |plate: &FromRow<Switch>| {
        let weight = plate.item.weight.filter(|weight| most <= *weight)?;
        let found =
            tr!("{weight} N, with {most} N of weight and thrust in all to press it", weight, most = format_args!("{most:.0}"));
        Some(plate.problem("weight", found, tr("less than that")))
    };
    draft.switches.iter().filter_map(heavy).collect()
}

/// Speeds in m/s whose numbers are those of pixels.
fn like_pixels(level: &Checked) -> Vec<Problem> {
    let Draft { movers, objects, scale, .. } = level.draft;
    let pace = |mover: &Mover| if let MoverPace::Speed(speed) = mover.manner.pace { speed } else { 0.0 };
    let movers = movers.iter().map(|row| ("speed", row.map(pace)));
    let bodies = objects.iter().map(|row| row.map(|body| body.velocity)).chain([level.ship.map(|ship| ship.velocity)]);
    let thrown = bodies.flat_map(|row| [("vx", row.map(|speed| speed.x)), ("vy", row.map(|speed| speed.y))]);
    let fast = movers.chain(thrown).filter(|(_, row)| row.item.abs() > LIKE_PIXELS);
    fast.map(|(column, row)| {
        let (speed, pixels) = (fixed(row.item, 3), (row.item * scale.metre).round());
        let found = tr!("{speed} m/s, which is {pixels} pixels a second", speed = trimmed(&speed), pixels);
        row.problem(column, found, tr!("m/s, one of which is {metre} pixels a second", metre = scale.metre))
    })
    .collect()
}

fn long_holds(level: &Checked) -> Vec<Problem> {
    let best = level.draft.settings.row.optimal_time;
    let long = level.draft.objectives.iter().filter(|pad| pad.item.hold > best);
    long.map(|pad| {
        let found = tr!("a hold of {hold} s, longer than the optimal time of {best} s", hold = pad.item.hold, best);
        pad.problem("hold", found, tr("a shorter hold, or a longer optimal_time in constants.csv"))
    })
    .collect()
}

fn unused_keys(level: &Checked) -> Vec<Problem> {
    let Draft { objects, objectives, switches, stars, .. } = level.draft;
    let pressed = switches.iter().any(|switch| switch.item.by == Presser::Key);
    let asked = pressed || stars.iter().any(|star| star.item.by == StarTouch::Key);
    let pads = objectives.iter().map(|pad| &pad.item).filter(|pad| pad.kind == ObjectiveKind::Physics);
    let taken = |key| asked || pads.clone().any(|pad| pad.fits(key));
    let unused = objects.iter().filter(|object| object.item.key.is_some_and(|key| !taken(key)));
    let expected = tr("a PHYS row that it fits, or a row of objects.csv for what is no key");
    unused.map(|key| key.problem("kind", tr("a key object that no objective takes"), expected)).collect()
}

fn barred_pods(level: &Checked) -> Vec<Problem> {
    let barred = level.draft.pods.iter().filter(|pod| !level.space.gets_to(level.ship_box(), &pod.item.bounds));
    let expected = tr("a route to it, in the level and out of solids");
    barred.map(|pod| pod.problem("x", tr("a pod that the ship cannot get to"), expected)).collect()
}

/// Fragile blocks that withstand any blow of a ship alone, friction with it.
fn unbreakable(level: &Checked) -> Vec<Problem> {
    let fastest = |axis: DVec2| Some(level.run(axis)?.max(level.run(-axis)?));
    let (Some(x), Some(y)) = (fastest(DVec2::X), fastest(DVec2::Y)) else { return Vec::new() };
    let blow = (2.0 * level.ship.item.mass * (x + y)).sqrt();
    let fragile = level.draft.world.iter().filter_map(|block| Some((block, block.item.breaks.filter(|breaks| *breaks > blow)?)));
    fragile
        .map(|(block, breaks)| {
            let found = tr!("{breaks} N·s, with blows of at most {blow} N·s in this level", breaks, blow = blow.ceil());
            block.problem("breaks", found, tr("less than that"))
        })
        .collect()
}

/// A pad too far from the only object, a key. The ship has no more momentum to give it than its engine's, and friction, at least that on
/// ice, takes it, but for falls.
fn too_heavy(level: &Checked, pad: &FromRow<Objective>) -> Option<Problem> {
    let (draft, ship) = (level.draft, &level.ship.item);
    let [row] = &draft.objects[..] else { return None };
    let key = &row.item;
    let gravity = draft.settings.row.gravity;
    let fits = pad.item.kind == ObjectiveKind::Physics && key.key.is_some_and(|colour| pad.item.fits(colour));
    let grip = draft.settings.row.friction * Material::ICE.kinetic_friction * gravity;
    let moves = key.weightless || key.velocity != DVec2::ZERO || 2.0 * ship.thrust > grip * key.mass;
    let speed = (ship.mass * ship.velocity.length() + ship.thrust * level.burns()) / key.mass;
    let falls = (2.0 * level.size.y / gravity).sqrt() * (draft.world.len() + draft.switches.len() + 1) as f64;
    // As long again, as the engine may lighten the key.
    let far = 2.0 * speed * (speed / grip + speed / gravity + falls);
    let own = Aabb::around(key.position, key.size * 0.5);
    let away = (own.min.x - pad.item.bounds.max.x).max(pad.item.bounds.min.x - own.max.x).max(own.min.y - pad.item.bounds.max.y);
    let found =
        tr!("{mass} kg, which nothing in the level brings to the objective of line {line}", mass = key.mass, line = pad.line);
    (fits && !moves && draft.is_calm() && draft.doors.is_empty() && !level.bounces() && away > far)
        .then(|| row.problem("mass", found, tr("a key that the ship can move so far")))
}

/// A pad out of reach of a ship alone that its only link, a rope to a place, holds back. The engine's work has a bound: d√E/dt ≤ thrust/√(2·mass).
fn tied(level: &Checked, pad: &FromRow<Objective>) -> Option<Problem> {
    let (draft, ship) = (level.draft, &level.ship.item);
    let [row] = &draft.links[..] else { return None };
    let ([LinkRowEnd::Ship, LinkRowEnd::Place(place)] | [LinkRowEnd::Place(place), LinkRowEnd::Ship]) = &row.item.ends else {
        return None;
    };
    let LinkLaw::Rope(tie) = row.item.law else { return None };
    let start = place.distance(ship.position);
    let gravity = draft.settings.row.gravity;
    let length = if row.item.as_found { start } else { tie.length };
    let stretched = |distance: f64| 0.5 * tie.stiffness * (distance - length).max(0.0).powi(2);
    let lasts = row.item.name.is_none() && row.item.breaks.is_none() && !row.item.hook && row.item.rate == 0.0;
    let others = draft.has_moving_surfaces() || draft.has_currents() || !draft.objects.is_empty();
    let begun = 0.5 * ship.mass * ship.velocity.length_squared()
        + ship.mass * gravity * (level.size.y - ship.position.y)
        + stretched(start);
    let energy = (begun.sqrt() + ship.thrust * level.burns() / (2.0 * ship.mass).sqrt()).powi(2);
    let near = grown(&pad.item.bounds, SHIP_HALF);
    let distance = place.clamp(near.min, near.max).distance(*place);
    let found = tr!("a link too short for the objective of line {line}, for which nothing can stretch it", line = pad.line);
    let holds = lasts && gravity >= 0.0 && !others && stretched(distance) > energy;
    (holds && pad.item.kind == ObjectiveKind::Player).then(|| row.problem("length", found, tr("one that lets its body get there")))
}
