//! Whether a level can be won at all, and is neither won nor lost at its start. A doubtful route counts as possible: doors are open, no body
//! is too heavy, and movers are anywhere.

use super::box_tree::BoxTree;
use super::draft::Draft;
use super::placed::FromRow;
use super::problem::{Problem, quoted};
use super::reach::{CentredBox, FreeSpace};
use super::ship_body::{ship_body, sweep_touches};
use super::types::{Objective, ObjectiveKind, SHIP_HALF, ShipStart};
use crate::physics::{Aabb, DVec2};
use crate::words::tr;
use std::collections::BTreeMap;

/// A gap of less than this, m, is touched: as in the rules.
const TOUCH: f64 = 1e-9;

pub(super) fn check(draft: &Draft, player: &ShipStart, space: &FreeSpace) -> Vec<Problem> {
    let ship = (player.position, SHIP_HALF);
    let mut problems = starts(draft, ship, player.angle);
    problems.extend(unreachable(draft, ship, space));
    if problems.is_empty() {
        problems.extend(apart(draft));
        problems.extend(too_few_keys(draft, space));
    }
    problems
}

/// The bodies that fit an objective.
pub(super) fn fitting<'a>(draft: &'a Draft, objective: &'a Objective, ship: CentredBox) -> impl Iterator<Item = CentredBox> + 'a {
    let player = objective.kind == ObjectiveKind::Player;
    let keys = draft.objects.iter().filter(move |object| !player && object.item.key.is_some_and(|key| objective.fits(key)));
    player.then_some(ship).into_iter().chain(keys.map(|key| (key.item.position, key.item.size * 0.5)))
}

/// A start that is the end.
fn starts(draft: &Draft, ship: CentredBox, angle: f64) -> Vec<Problem> {
    let (at, body) = (ship.0, ship_body(angle));
    let deadly = draft.obstacles.iter().filter(|deadly| sweep_touches(&body, at, at, &deadly.item, TOUCH));
    let mut problems: Vec<Problem> = deadly
        .map(|deadly| deadly.problem("x", tr("a death box that touches the ship at its start"), tr("a start off red")))
        .collect();
    let met = |objective: &Objective| {
        let touches = |(centre, half)| Aabb::around(centre, half).touches(&objective.bounds, TOUCH);
        objective.hold == 0.0 && fitting(draft, objective, ship).any(touches)
    };
    if let Some(first) = draft.objectives.first()
        && draft.objectives.iter().all(|objective| met(&objective.item))
    {
        problems.push(first.problem("x", tr("objectives that are all met at the start"), tr("something to do")));
    }
    problems
}

/// Objectives to which no body gets that fits.
fn unreachable(draft: &Draft, ship: CentredBox, space: &FreeSpace) -> Vec<Problem> {
    let mut problems = Vec::new();
    for placed in &draft.objectives {
        let objective = &placed.item;
        let mut bodies = fitting(draft, objective, ship).peekable();
        if bodies.peek().is_none() {
            // `draft` reports a level without any key.
            if let Some(colour) = objective.colour {
                let found = tr!(
                    "{colour}, the colour of no key object",
                    colour = quoted(&colour.map(|channel| channel.to_string()).join(","))
                );
                problems.push(placed.problem("r", found, tr("the r, g and b of an OBJECT row")));
            }
            continue;
        }
        if bodies.any(|body| space.gets_to(body, &objective.bounds)) {
            continue;
        }
        let player = objective.kind == ObjectiveKind::Player;
        let found = tr(if player {
            "an objective that the ship cannot get to"
        } else {
            "an objective that a key object that fits cannot get to"
        });
        problems.push(placed.problem("x", found, tr("a route to it, in the level and out of solids")));
    }
    problems
}

/// Objectives for the ship that lie too far apart to be touched at once.
fn apart(draft: &Draft) -> Option<Problem> {
    let at_once = |objective: &&FromRow<Objective>| objective.item.kind == ObjectiveKind::Player && objective.item.order.is_none();
    let mut pads = draft.objectives.iter().filter(at_once);
    let mut room = grown(&pads.next()?.item.bounds, SHIP_HALF);
    for pad in pads {
        let bounds = grown(&pad.item.bounds, SHIP_HALF);
        room = Aabb { min: room.min.max(bounds.min), max: room.max.min(bounds.max) };
        if (room.max - room.min).min_element() < -TOUCH {
            let found = tr("a second objective for the ship, too far from the others to touch all at once");
            return Some(pad.problem("x", found, tr("objectives side by side, or a number in the column order for each")));
        }
    }
    None
}

/// Objectives with the same turn: the rules let these be met in any order, which an author seldom wants.
pub(super) fn same_turns(draft: &Draft) -> Vec<Problem> {
    let mut first: BTreeMap<u32, usize> = BTreeMap::new();
    let mut warnings = Vec::new();
    for placed in &draft.objectives {
        let Some(order) = placed.item.order else { continue };
        let line = *first.entry(order).or_insert(placed.line);
        if line != placed.line {
            let found = tr!("{order} once more, the turn of line {line}: these two can be met in either order", order, line);
            warnings.push(placed.problem("order", found, tr("a number of its own for each turn")));
        }
    }
    warnings
}

/// More objectives for keys than keys, none of which can touch two at once.
fn too_few_keys(draft: &Draft, space: &FreeSpace) -> Option<Problem> {
    let at_once = |objective: &&FromRow<Objective>| objective.item.kind == ObjectiveKind::Physics && objective.item.order.is_none();
    let wanted: Vec<&FromRow<Objective>> = draft.objectives.iter().filter(at_once).collect();
    let keys: Vec<DVec2> = draft.objects.iter().filter(|object| object.item.key.is_some()).map(|key| key.item.size * 0.5).collect();
    let mut halves = keys.clone();
    halves.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    halves.dedup();
    let shared = |half: &DVec2| {
        let rooms: Vec<Aabb> = wanted.iter().map(|objective| grown(&objective.item.bounds, *half)).collect();
        let tree = BoxTree::of(rooms.iter().copied());
        let alone = |(i, room): (usize, &Aabb)| tree.search(room, TOUCH, |other| other as usize == i);
        // A search that would take too long counts as possible.
        !space.work.spend(rooms.len()) || !rooms.iter().enumerate().all(alone)
    };
    if wanted.len() <= keys.len() || halves.iter().any(shared) {
        return None;
    }
    let found = tr!("objective {number} for key objects, with {count} of these", number = keys.len() + 1, count = keys.len());
    Some(wanted[keys.len()].problem("kind", found, tr("a key object for each, or a number in the column order")))
}

fn grown(bounds: &Aabb, by: DVec2) -> Aabb {
    Aabb::new(bounds.min - by, bounds.max + by)
}
