//! Whether a level can be won at all, and is neither won nor lost at its start. A doubtful route counts as possible: doors are open, no body
//! is too heavy, and movers are anywhere.

use super::problem::{Problem, quoted};
use super::reach::{CentredBox, FreeSpace, grown};
use super::types::{BURN_RATE, Objective, ObjectiveKind, Presser, SHIP_HALF, ShipStart, Switch};
use super::world_def::{ship_body, sweep_touches};
use super::{draft::Draft, schema::typed::FromRow};
use crate::physics::{Aabb, DVec2};
use crate::words::tr;

/// A gap of less than this, m, is touched: as in the rules.
const TOUCH: f64 = 1e-9;
/// The most objectives for keys that are compared with each other.
const MOST_PADS: usize = 1000;

pub(super) fn check(level: &Checked) -> Vec<Problem> {
    let mut problems = starts(level);
    problems.extend(level.draft.objectives.iter().filter_map(|pad| unreachable(level, pad)));
    if problems.is_empty() {
        problems.extend(apart(level.draft));
        problems.extend(too_few_keys(level.draft));
    }
    problems
}

/// What the ship or some objects have to touch.
pub(super) struct TouchGoal {
    bounds: Aabb,
    by: Presser,
    /// Of the only keys that fit.
    colour: Option<[u8; 3]>,
}

impl TouchGoal {
    pub fn of_pad(pad: &Objective) -> Self {
        let by = if pad.kind == ObjectiveKind::Player { Presser::Ship } else { Presser::Key };
        Self { bounds: pad.bounds, by, colour: pad.colour }
    }

    pub fn of_switch(switch: &Switch) -> Self {
        Self { bounds: switch.bounds, by: switch.by, colour: None }
    }

    fn takes_ship(&self) -> bool {
        matches!(self.by, Presser::Any | Presser::Ship)
    }

    fn objects(&self, draft: &Draft) -> impl Iterator<Item = CentredBox> {
        let counts = |key: Option<[u8; 3]>| match self.by {
            Presser::Any | Presser::Object => true,
            Presser::Key => key.is_some_and(|key| self.colour.is_none_or(|colour| colour == key)),
            Presser::Ship => false,
        };
        let objects = draft.objects.iter().map(|object| &object.item).filter(move |object| counts(object.key));
        objects.map(|object| (object.position, object.size * 0.5))
    }

    /// Whether the ship gets there, in one space; and whether an object does, in another.
    pub fn gets(&self, level: &Checked, [ships, others]: [&FreeSpace; 2]) -> [bool; 2] {
        let by_ship = self.takes_ship() && ships.gets_to(level.ship_box(), &self.bounds);
        [by_ship, self.objects(level.draft).any(|body| others.gets_to(body, &self.bounds))]
    }
}

/// A start that is the end.
fn starts(level: &Checked) -> Vec<Problem> {
    let draft = level.draft;
    let (at, body) = (level.ship.item.position, ship_body(level.ship.item.angle));
    let deadly = draft.obstacles.iter().filter(|deadly| sweep_touches(&body, at, at, &deadly.item, TOUCH));
    let mut problems: Vec<Problem> = deadly
        .map(|deadly| deadly.problem("x", tr("a death box that touches the ship at its start"), tr("a start off red")))
        .collect();
    let met = |objective: &FromRow<Objective>| {
        let goal = TouchGoal::of_pad(&objective.item);
        let ship = goal.takes_ship().then(|| level.ship_box());
        let mut bodies = ship.into_iter().chain(goal.objects(draft));
        objective.item.hold == 0.0 && bodies.any(|(centre, half)| Aabb::around(centre, half).touches(&goal.bounds, TOUCH))
    };
    let first = draft.objectives.first().filter(|_| draft.objectives.iter().all(met));
    problems.extend(first.map(|first| first.problem("x", tr("objectives that are all met at the start"), tr("something to do"))));
    problems
}

/// An objective to which no body gets that fits.
fn unreachable(level: &Checked, pad: &FromRow<Objective>) -> Option<Problem> {
    let goal = TouchGoal::of_pad(&pad.item);
    if !goal.takes_ship() && goal.objects(level.draft).next().is_none() {
        // `draft` reports a level without any key.
        let colour = quoted(&pad.item.colour?.map(|channel| channel.to_string()).join(","));
        let found = tr!("{colour}, the colour of no key object", colour);
        return Some(pad.problem("r", found, tr("the r, g and b of an OBJECT row")));
    }
    let found = tr(match pad.item.kind {
        ObjectiveKind::Player => "an objective that the ship cannot get to",
        ObjectiveKind::Physics => "an objective that a key object that fits cannot get to",
    });
    let barred = goal.gets(level, [level.space; 2]) == [false; 2];
    barred.then(|| pad.problem("x", found, tr("a route to it, in the level and out of solids")))
}

/// The objectives of a kind that have to be met at once.
fn at_once(draft: &Draft, kind: ObjectiveKind) -> impl Iterator<Item = &FromRow<Objective>> {
    draft.objectives.iter().filter(move |objective| objective.item.kind == kind && objective.item.order.is_none())
}

/// Objectives for the ship that lie too far apart to be touched at once.
fn apart(draft: &Draft) -> Option<Problem> {
    let (mut min, mut max) = (DVec2::NEG_INFINITY, DVec2::INFINITY);
    let far = at_once(draft, ObjectiveKind::Player).find(|pad| {
        let room = grown(&pad.item.bounds, SHIP_HALF);
        (min, max) = (min.max(room.min), max.min(room.max));
        (max - min).min_element() < -TOUCH
    })?;
    let found = tr("a second objective for the ship, too far from the others to touch all at once");
    Some(far.problem("x", found, tr("objectives side by side, or a number in the column order for each")))
}

/// More objectives for keys than keys, none of which can touch two at once.
fn too_few_keys(draft: &Draft) -> Option<Problem> {
    let wanted: Vec<&FromRow<Objective>> = at_once(draft, ObjectiveKind::Physics).collect();
    let keys: Vec<DVec2> = draft.objects.iter().filter(|object| object.item.key.is_some()).map(|key| key.item.size * 0.5).collect();
    let largest = keys.iter().fold(DVec2::ZERO, |half, key| half.max(*key));
    let rooms: Vec<Aabb> = wanted.iter().take(MOST_PADS).map(|pad| grown(&pad.item.bounds, largest)).collect();
    let two_at_once = || rooms.iter().enumerate().any(|(i, room)| rooms[..i].iter().any(|other| room.touches(other, TOUCH)));
    if wanted.len() <= keys.len() || wanted.len() > MOST_PADS || two_at_once() {
        return None;
    }
    let found = tr!("objective {number} for key objects, with {count} of these", number = keys.len() + 1, count = keys.len());
    Some(wanted[keys.len()].problem("kind", found, tr("a key object for each, or a number in the column order")))
}

/// A level of which nothing is refused.
pub(super) struct Checked<'a> {
    pub draft: &'a Draft,
    pub ship: &'a FromRow<ShipStart>,
    /// Of the level, m.
    pub size: DVec2,
    pub space: &'a FreeSpace,
}

/// What the bodies of a level can come to.
impl Checked<'_> {
    pub fn ship_box(&self) -> CentredBox {
        (self.ship.item.position, SHIP_HALF)
    }

    /// Streams and gravity zones: where they are, their force on the ship, N, and whether a switch may stop them.
    pub fn zones(&self) -> impl Iterator<Item = (Aabb, DVec2, bool)> {
        let streams = self.draft.streams.iter().map(|stream| (stream.item.zone, stream.item.force, stream.item.name.is_some()));
        let fields = self.draft.fields.iter().map(|field| (field.item.zone, field.item.strength * self.ship.item.mass, false));
        streams.chain(fields)
    }

    pub fn bounces(&self) -> bool {
        let Draft { world, doors, objects, .. } = self.draft;
        let ship = &self.ship.item;
        let solids = world.iter().chain(doors).map(|solid| solid.item.material.restitution);
        let bodies = objects.iter().flat_map(|object| [object.item.restitution, object.item.material.restitution]);
        solids.chain(bodies).chain([ship.restitution, ship.material.restitution]).any(|restitution| restitution > 0.0)
    }

    /// The longest time that the engine burns, s.
    pub fn burns(&self) -> f64 {
        (self.ship.item.fuel + self.draft.pods.iter().map(|pod| pod.item.fuel).sum::<f64>()) / BURN_RATE
    }

    /// The kinetic energy, J, that a ship alone has at most along one axis to one side: such a run begins at rest or at the start, and is as
    /// long as the level. `None` where it may be thrown.
    pub fn run(&self, side: DVec2) -> Option<f64> {
        let Self { draft, ship: FromRow { item: ship, .. }, size, .. } = self;
        let alone = draft.objects.is_empty() && !draft.is_driven() && draft.fluids.is_empty() && !self.bounces();
        let zones: f64 = self.zones().map(|(_, force, _)| force.dot(side).max(0.0)).sum();
        let weight = ship.mass * DVec2::new(draft.settings.row.gravity_x, draft.settings.row.gravity).dot(side).max(0.0);
        let start = 0.5 * ship.mass * ship.velocity.dot(side).max(0.0).powi(2);
        alone.then(|| start + (ship.thrust + zones + weight) * size.dot(side.abs()))
    }
}
