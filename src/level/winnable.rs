//! Whether a level can be won at all, and is neither won nor lost at its start. A doubtful route counts as possible: doors are open, no body
//! is too heavy, and movers are anywhere.

use super::draft::Draft;
use super::placement::BoxTree;
use super::problem::{Problem, quoted};
use super::reach::{CentredBox, FreeSpace, grown, shared};
use super::schema::typed::FromRow;
use super::types::{Objective, ObjectiveKind, Presser, SHIP_HALF, ShipStart, Switch};
use super::world_def::{ship_body, sweep_touches};
use crate::physics::{Aabb, DVec2};
use crate::words::tr;

/// A gap of less than this, m, is touched: as in the rules.
const TOUCH: f64 = 1e-9;

pub(super) fn check(draft: &Draft, player: &ShipStart, space: &FreeSpace) -> Vec<Problem> {
    let ship = (player.position, SHIP_HALF);
    let mut problems = starts(draft, ship, player.angle);
    problems.extend(draft.objectives.iter().filter_map(|pad| unreachable(draft, pad, ship, space)));
    if problems.is_empty() {
        problems.extend(apart(draft));
        problems.extend(too_few_keys(draft, space));
    }
    problems
}

/// What the ship or some objects have to touch.
pub(super) struct Goal {
    bounds: Aabb,
    by: Presser,
    /// Of the only keys that fit.
    colour: Option<[u8; 3]>,
}

impl From<&Objective> for Goal {
    fn from(pad: &Objective) -> Self {
        let by = if pad.kind == ObjectiveKind::Player { Presser::Ship } else { Presser::Key };
        Self { bounds: pad.bounds, by, colour: pad.colour }
    }
}

impl From<&Switch> for Goal {
    fn from(switch: &Switch) -> Self {
        Self { bounds: switch.bounds, by: switch.by, colour: None }
    }
}

impl Goal {
    /// The ship, where it counts, and the objects that do.
    pub fn bodies<'a>(&'a self, draft: &'a Draft, ship: CentredBox) -> impl Iterator<Item = CentredBox> + 'a {
        matches!(self.by, Presser::Any | Presser::Ship).then_some(ship).into_iter().chain(self.objects(draft))
    }

    fn objects<'a>(&'a self, draft: &'a Draft) -> impl Iterator<Item = CentredBox> + 'a {
        let counts = |key: Option<[u8; 3]>| match self.by {
            Presser::Any | Presser::Object => true,
            Presser::Key => key.is_some_and(|key| self.colour.is_none_or(|colour| colour == key)),
            Presser::Ship => false,
        };
        let objects = draft.objects.iter().map(|object| &object.item).filter(move |object| counts(object.key));
        objects.map(|object| (object.position, object.size * 0.5))
    }

    /// Whether the ship gets there, in one space; and whether an object does, in another.
    pub fn gets(&self, draft: &Draft, ship: CentredBox, [ships, others]: [&FreeSpace; 2]) -> [bool; 2] {
        let by_ship = matches!(self.by, Presser::Any | Presser::Ship) && ships.gets_to(ship, &self.bounds);
        [by_ship, self.objects(draft).any(|body| others.gets_to(body, &self.bounds))]
    }
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
        objective.hold == 0.0 && Goal::from(objective).bodies(draft, ship).any(touches)
    };
    if let Some(first) = draft.objectives.first()
        && draft.objectives.iter().all(|objective| met(&objective.item))
    {
        problems.push(first.problem("x", tr("objectives that are all met at the start"), tr("something to do")));
    }
    problems
}

/// An objective to which no body gets that fits.
fn unreachable(draft: &Draft, pad: &FromRow<Objective>, ship: CentredBox, space: &FreeSpace) -> Option<Problem> {
    let goal = Goal::from(&pad.item);
    if goal.bodies(draft, ship).next().is_none() {
        // `draft` reports a level without any key.
        let colour = quoted(&pad.item.colour?.map(|channel| channel.to_string()).join(","));
        let found = tr!("{colour}, the colour of no key object", colour);
        return Some(pad.problem("r", found, tr("the r, g and b of an OBJECT row")));
    }
    let found = tr(match pad.item.kind {
        ObjectiveKind::Player => "an objective that the ship cannot get to",
        ObjectiveKind::Physics => "an objective that a key object that fits cannot get to",
    });
    let barred = goal.gets(draft, ship, [space; 2]) == [false; 2];
    barred.then(|| pad.problem("x", found, tr("a route to it, in the level and out of solids")))
}

/// Objectives for the ship that lie too far apart to be touched at once.
fn apart(draft: &Draft) -> Option<Problem> {
    let at_once = |objective: &&FromRow<Objective>| objective.item.kind == ObjectiveKind::Player && objective.item.order.is_none();
    let mut pads = draft.objectives.iter().filter(at_once);
    let mut room = grown(&pads.next()?.item.bounds, SHIP_HALF);
    for pad in pads {
        room = shared(&room, &grown(&pad.item.bounds, SHIP_HALF));
        if (room.max - room.min).min_element() < -TOUCH {
            let found = tr("a second objective for the ship, too far from the others to touch all at once");
            return Some(pad.problem("x", found, tr("objectives side by side, or a number in the column order for each")));
        }
    }
    None
}

/// More objectives for keys than keys, none of which can touch two at once.
fn too_few_keys(draft: &Draft, space: &FreeSpace) -> Option<Problem> {
    let at_once = |objective: &&FromRow<Objective>| objective.item.kind == ObjectiveKind::Physics && objective.item.order.is_none();
    let wanted: Vec<&FromRow<Objective>> = draft.objectives.iter().filter(at_once).collect();
    let keys: Vec<DVec2> = draft.objects.iter().filter(|object| object.item.key.is_some()).map(|key| key.item.size * 0.5).collect();
    let mut halves = keys.clone();
    halves.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    halves.dedup();
    let two_at_once = |half: &DVec2| {
        let rooms: Vec<Aabb> = wanted.iter().map(|objective| grown(&objective.item.bounds, *half)).collect();
        let tree = BoxTree::of(rooms.iter().copied());
        let alone = |(i, room): (usize, &Aabb)| tree.search(room, TOUCH, |other| other as usize == i);
        // A search that would take too long counts as possible.
        !space.work.spend(rooms.len()) || !rooms.iter().enumerate().all(alone)
    };
    if wanted.len() <= keys.len() || halves.iter().any(two_at_once) {
        return None;
    }
    let found = tr!("objective {number} for key objects, with {count} of these", number = keys.len() + 1, count = keys.len());
    Some(wanted[keys.len()].problem("kind", found, tr("a key object for each, or a number in the column order")))
}
