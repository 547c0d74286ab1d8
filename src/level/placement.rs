//! Where things start: inside the level, in free space, within reach.

use super::problem::Problem;
use super::reach;
use super::read::Draft;
use super::rows::Placed;
use super::types::{Player, SHIP_HALF};
use crate::physics::{Aabb, DVec2};

/// How far things may overlap at the start, m: what rounding pixels to metres can make of things that touch. Larger, and the
/// engine would have to push things apart at the first tick.
const OVERLAP: f64 = 1e-6;

/// What a message calls a thing, and where it is.
type Named = (&'static str, Placed<Aabb>);

/// The ship and every object that start outside the level or inside something solid: one problem a body.
pub(super) fn check(draft: &Draft) -> Vec<Problem> {
    let mut solids: Vec<Named> = Vec::new();
    solids.extend(draft.world.iter().map(|solid| ("the solid", solid.map(|solid| solid.bounds))));
    solids.extend(draft.streams.iter().map(|stream| ("the source block", stream.map(|stream| stream.source))));
    let mut bodies: Vec<Named> = Vec::new();
    bodies.extend(draft.player.iter().map(|ship| ("the ship", ship.map(|ship| Aabb::around(ship.position, SHIP_HALF)))));
    bodies.extend(draft.objects.iter().map(|body| ("the object", body.map(|body| Aabb::around(body.position, body.size * 0.5)))));
    let mut problems = Vec::new();
    for (i, (name, body)) in bodies.iter().enumerate() {
        let mut others = solids.iter().chain(&bodies[..i]);
        if let Some(problem) = outside(name, body, draft) {
            problems.push(problem);
        } else if let Some((what, other)) = others.find(|(_, other)| other.item.overlaps(&body.item, OVERLAP)) {
            let found = format!("{name} inside {what} of {}:{}", other.file, other.line);
            problems.push(body.problem("x", found, "a start in free space"));
        }
    }
    problems
}

/// The problem of a body that reaches out of the level, if it does.
fn outside(name: &str, body: &Placed<Aabb>, draft: &Draft) -> Option<Problem> {
    let size = draft.size?;
    let metre = draft.scale.metre;
    let (min, max) = (body.item.min, body.item.max);
    let out = |min: f64, max: f64, size: f64| min < -OVERLAP || max > size / metre + OVERLAP;
    let (column, size) = match (out(min.x, max.x, size.x), out(min.y, max.y, size.y)) {
        (true, _) => ("x", size.x),
        (_, true) => ("y", size.y),
        _ => return None,
    };
    let found = format!("{name} outside the level");
    Some(body.problem(column, found, format!("all of it between 0 and {size} pixels")))
}

/// The objects that nobody can reach from the ship's start in a level of that size in metres.
pub(super) fn warn(draft: &Draft, player: &Player, size: DVec2) -> Vec<Problem> {
    let space = reach::Space {
        level: Aabb::new(DVec2::ZERO, size),
        solids: draft.world.iter().map(|solid| solid.item.bounds).chain(draft.streams.iter().map(|s| s.item.source)).collect(),
        slack: OVERLAP,
    };
    let bodies = draft.objects.iter().map(|object| (object.item.position, object.item.size * 0.5)).collect::<Vec<_>>();
    let unreached = space.unreached((player.position, SHIP_HALF), &bodies);
    let expected = "a way for the ship, or for something that it can push";
    unreached.into_iter().map(|i| draft.objects[i].problem("x", "an object that no one can reach", expected)).collect()
}
