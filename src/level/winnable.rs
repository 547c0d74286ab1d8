//! Whether a level can be won at all, and is neither won nor lost at its start. A doubtful route counts as possible: doors are open, no body
//! is too heavy, and movers are anywhere.

use super::problem::{Problem, quoted};
use super::reach::{CentredBox, FreeSpace, grown, shared};
use super::types::{BURN_RATE, LevelLink, Objective, ObjectiveKind, Presser, SHIP_HALF, ShipStart, Switch};
use super::world_def::{ship_body, sweep_touches};
use super::{draft::Draft, placement::BoxTree, schema::typed::FromRow};
use crate::physics::{Aabb, BodyId, DVec2, LinkEnd, LinkLaw, Material, Spring};
use crate::words::tr;

/// A gap of less than this, m, is touched: as in the rules.
const TOUCH: f64 = 1e-9;

pub(super) fn check(level: &Checked) -> Vec<Problem> {
    let mut problems = starts(level);
    problems.extend(level.draft.objectives.iter().filter_map(|pad| unreachable(level, pad)));
    if problems.is_empty() {
        problems.extend(apart(level.draft));
        problems.extend(too_few_keys(level));
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

impl From<&Objective> for TouchGoal {
    fn from(pad: &Objective) -> Self {
        let by = if pad.kind == ObjectiveKind::Player { Presser::Ship } else { Presser::Key };
        Self { bounds: pad.bounds, by, colour: pad.colour }
    }
}

impl From<&Switch> for TouchGoal {
    fn from(switch: &Switch) -> Self {
        Self { bounds: switch.bounds, by: switch.by, colour: None }
    }
}

impl TouchGoal {
    /// The ship, where it counts, and the objects that do.
    pub fn bodies(&self, level: &Checked) -> impl Iterator<Item = CentredBox> {
        self.takes_ship().then(|| level.ship_box()).into_iter().chain(self.objects(level.draft))
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
    let met = |objective: &Objective| {
        let touches = |(centre, half)| Aabb::around(centre, half).touches(&objective.bounds, TOUCH);
        objective.hold == 0.0 && TouchGoal::from(objective).bodies(level).any(touches)
    };
    if let Some(first) = draft.objectives.first()
        && draft.objectives.iter().all(|objective| met(&objective.item))
    {
        problems.push(first.problem("x", tr("objectives that are all met at the start"), tr("something to do")));
    }
    problems
}

/// An objective to which no body gets that fits.
fn unreachable(level: &Checked, pad: &FromRow<Objective>) -> Option<Problem> {
    let goal = TouchGoal::from(&pad.item);
    if goal.bodies(level).next().is_none() {
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
fn too_few_keys(level: &Checked) -> Option<Problem> {
    let draft = level.draft;
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
        !level.space.work.spend(rooms.len()) || !rooms.iter().enumerate().all(alone)
    };
    if wanted.len() <= keys.len() || halves.iter().any(two_at_once) {
        return None;
    }
    let found = tr!("objective {number} for key objects, with {count} of these", number = keys.len() + 1, count = keys.len());
    Some(wanted[keys.len()].problem("kind", found, tr("a key object for each, or a number in the column order")))
}

/// From this restitution on a bounce lasts too long for a bound.
pub(super) const LIVELY: f64 = 0.9;

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

    pub fn masses(&self) -> impl Iterator<Item = f64> {
        [self.ship.item.mass].into_iter().chain(self.draft.objects.iter().map(|object| object.item.mass))
    }

    pub fn centre(&self, body: BodyId) -> DVec2 {
        body.index().checked_sub(1).map_or(self.ship.item.position, |object| self.draft.objects[object].item.position)
    }

    fn materials(&self) -> impl Iterator<Item = &Material> {
        let solids = self.draft.world.iter().chain(&self.draft.doors).map(|solid| &solid.item.material);
        let bodies = self.draft.objects.iter().map(|object| &object.item.material);
        solids.chain(bodies).chain([&self.ship.item.material, &Material::ASPHALT])
    }

    /// The largest of the level.
    pub fn restitution(&self) -> f64 {
        let own = self.draft.objects.iter().map(|object| object.item.restitution).chain([self.ship.item.restitution]);
        own.chain(self.materials().map(|material| material.restitution)).fold(0.0, f64::max)
    }

    /// The smallest coefficient of kinetic friction of the level.
    pub fn friction(&self) -> f64 {
        self.draft.settings.row.friction * self.materials().map(|material| material.kinetic_friction).fold(f64::INFINITY, f64::min)
    }

    /// The energy, J, that all bodies have at most at any time, but for an object that stays where it is: theirs at the start, and the work
    /// of the engine. With d√E/dt ≤ thrust/√(2·mass) that work has a bound in vacuum; in air, F·v − k·v³ has a maximum.
    /// `None` where something else does work.
    pub fn energy(&self, but: Option<usize>) -> Option<f64> {
        let Self { draft, ship: FromRow { item: ship, .. }, size, .. } = self;
        let settings = &draft.settings.row;
        let moved = !draft.movers.is_empty() || draft.world.iter().any(|block| block.item.belt != 0.0) || draft.has_currents();
        if moved || settings.gravity_x != 0.0 || settings.gravity <= 0.0 {
            return None;
        }
        let stored = draft.links.iter().map(|link| self.stored(&link.item.bind(&draft.objects)?)).sum::<Option<f64>>()?;
        let of = |mass: f64, at: DVec2, v: DVec2| mass * (0.5 * v.length_squared() + settings.gravity * (size.y - at.y).max(0.0));
        let objects = draft.objects.iter().enumerate().filter(|(index, _)| Some(*index) != but);
        let start = stored
            + of(ship.mass, ship.position, ship.velocity)
            + objects.map(|(_, body)| of(body.item.mass, body.item.position, body.item.velocity)).sum::<f64>();
        let burns = (ship.fuel + draft.pods.iter().map(|pod| pod.item.fuel).sum::<f64>()) / BURN_RATE;
        let vacuum = (start.sqrt() + ship.thrust * burns / (2.0 * ship.mass).sqrt()).powi(2);
        // The least drag of the ship at 1 m/s, N.
        let air = if ship.feels_air { settings.air_density } else { 0.0 };
        let drag = 0.5 * air * ship.drag * 2.0 * SHIP_HALF.min_element();
        let power = 2.0 / 3.0 * ship.thrust * (ship.thrust / (3.0 * drag)).sqrt();
        Some(if drag > 0.0 { vacuum.min(start + power * burns) } else { vacuum })
    }

    /// The energy of a link at the start, J; `None` where it may do more work than that.
    fn stored(&self, LevelLink { def, name }: &LevelLink) -> Option<f64> {
        let works = self.draft.switches.iter().flat_map(|switch| &switch.item.works);
        let worked = name.iter().flat_map(|name| name.split('&')).any(|name| works.clone().any(|work| work.name == name));
        let (LinkLaw::Spring(Spring { length, stiffness, .. }) | LinkLaw::Rope(Spring { length, stiffness, .. })) = def.law else {
            return None;
        };
        let to = match def.to {
            LinkEnd::Place(place) => place,
            LinkEnd::Body(body) => self.centre(body),
        };
        let over = if def.as_found { 0.0 } else { self.centre(def.body).distance(to) - length };
        (def.rate == 0.0 && !def.hook && !worked).then_some(0.5 * stiffness * over * over)
    }

    /// N·s, friction with it. Of a ship alone by its speeds, of several bodies by all their energy: Σ m·v ≤ √(2·E·Σm).
    pub fn blow(&self) -> Option<f64> {
        let restitution = self.restitution();
        let fastest = |side: DVec2| Some(self.run(side)?.max(self.run(-side)?));
        let alone = || Some((2.0 * self.ship.item.mass * (fastest(DVec2::X)? + fastest(DVec2::Y)?)).sqrt());
        let energy = || Some((2.0 * self.energy(None)? * self.masses().sum::<f64>()).sqrt());
        let least = alone().into_iter().chain(energy()).min_by(f64::total_cmp)?;
        (restitution < LIVELY).then_some((1.0 + restitution) / (1.0 - restitution) * least)
    }

    /// The kinetic energy, J, that a ship alone has at most along one axis to one side: such a run begins at rest or at the start, and is as
    /// long as the level. `None` where it may be thrown.
    pub fn run(&self, side: DVec2) -> Option<f64> {
        let Self { draft, ship: FromRow { item: ship, .. }, size, .. } = self;
        let alone = draft.objects.is_empty() && !draft.is_driven() && draft.fluids.is_empty() && self.restitution() == 0.0;
        let zones: f64 = self.zones().map(|(_, force, _)| force.dot(side).max(0.0)).sum();
        let weight = ship.mass * DVec2::new(draft.settings.row.gravity_x, draft.settings.row.gravity).dot(side).max(0.0);
        let start = 0.5 * ship.mass * ship.velocity.dot(side).max(0.0).powi(2);
        alone.then(|| start + (ship.thrust + zones + weight) * size.dot(side.abs()))
    }
}
