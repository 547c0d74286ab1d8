//! Warnings of what no flight can do, by bounds of energy and speed that hold whatever the keys: blows that break nothing, keys too heavy to
//! move, bodies tied down; and of rows that can have no use.

use super::draft::Draft;
use super::problem::Problem;
use super::reach::FreeSpace;
use super::schema::typed::FromRow;
use super::types::{BURN_RATE, LevelLink, Objective, ObjectiveKind, Presser, SHIP_HALF, ShipStart};
use super::winnable::fitting;
use crate::number::{fixed, trimmed};
use crate::physics::{Aabb, BodyId, DVec2, LinkEnd, LinkLaw, Material, Spring};
use crate::words::tr;

/// m/s. A mover, belt or winch this fast crosses a screen in a second or so: its author may have thought of pixels.
const LIKE_PIXELS: f64 = 40.0;
/// m/s; the same of the start of a body, which may well be thrown.
const THROWN_LIKE_PIXELS: f64 = 80.0;
/// How far beyond its bound a body has to go before that is certain: the bounds leave out how pushes and hops share out the energy.
const MARGIN: f64 = 4.0;
/// From this restitution on a bounce lasts too long for a bound.
const LIVELY: f64 = 0.9;

pub(super) fn warn(draft: &Draft, ship: &FromRow<ShipStart>, space: &FreeSpace, size: DVec2) -> Vec<Problem> {
    let bounds = Bounds { draft, ship: &ship.item, size };
    let mut warnings = like_pixels(draft, ship);
    warnings.extend(without_use(draft, &ship.item, space));
    warnings.extend(unbreakable(&bounds));
    warnings.extend(draft.objectives.iter().filter_map(|pad| too_heavy(&bounds, pad).or_else(|| tied(&bounds, pad))));
    warnings
}

/// Speeds in m/s whose numbers are those of pixels.
fn like_pixels(draft: &Draft, ship: &FromRow<ShipStart>) -> Vec<Problem> {
    let mut warnings = Vec::new();
    let mut judge = |problem: &dyn Fn(&str, String, String) -> Problem, column: &str, speed: f64, most: f64| {
        if speed.abs() > most {
            let pixels = (speed * draft.scale.metre).round();
            let found = tr!("{speed} m/s, which is {pixels} pixels a second", speed = trimmed(&fixed(speed, 3)), pixels);
            warnings.push(problem(column, found, tr!("m/s, one of which is {metre} pixels a second", metre = draft.scale.metre)));
        }
    };
    for mover in &draft.movers {
        let fastest = mover.item.path.legs.iter().map(|leg| leg.velocity.length()).fold(0.0, f64::max);
        judge(&|column, found, expected| mover.problem(column, found, expected), "speed", fastest, LIKE_PIXELS);
        judge(&|column, found, expected| mover.problem(column, found, expected), "belt", mover.item.solid.belt, LIKE_PIXELS);
    }
    for block in &draft.world {
        judge(&|column, found, expected| block.problem(column, found, expected), "belt", block.item.belt, LIKE_PIXELS);
    }
    for link in &draft.links {
        judge(&|column, found, expected| link.problem(column, found, expected), "rate", link.item.rate, LIKE_PIXELS);
    }
    let thrown = draft.objects.iter().map(|body| body.map(|body| body.velocity)).chain([ship.map(|ship| ship.velocity)]);
    for body in thrown {
        for (column, speed) in [("vx", body.item.x), ("vy", body.item.y)] {
            judge(&|column, found, expected| body.problem(column, found, expected), column, speed, THROWN_LIKE_PIXELS);
        }
    }
    warnings
}

/// Holds beyond the optimal time, keys that no pad takes, pods out of reach.
fn without_use(draft: &Draft, ship: &ShipStart, space: &FreeSpace) -> Vec<Problem> {
    let best = draft.settings.row.optimal_time;
    let long = draft.objectives.iter().filter(|pad| pad.item.hold > best).map(|pad| {
        let found = tr!("a hold of {hold} s, longer than the optimal time of {best} s", hold = pad.item.hold, best);
        pad.problem("hold", found, tr("a shorter hold, or a longer optimal_time in constants.csv"))
    });
    let pressing = draft.switches.iter().any(|switch| switch.item.by == Presser::Key);
    let takes = |pad: &FromRow<Objective>, key| pad.item.kind == ObjectiveKind::Physics && pad.item.fits(key);
    let taken = |key| pressing || draft.objectives.iter().any(|pad| takes(pad, key));
    let keys = draft.objects.iter().filter(|object| object.item.key.is_some_and(|key| !taken(key))).map(|key| {
        let expected = tr("a PHYS row that it fits, or a row of objects.csv for what is no key");
        key.problem("kind", tr("a key object that no objective takes"), expected)
    });
    let start = (ship.position, SHIP_HALF);
    let pods =
        draft.pods.iter().filter(|pod| !space.gets_to(start, &pod.item.bounds)).map(|pod| {
            pod.problem("x", tr("a pod that the ship cannot get to"), tr("a route to it, in the level and out of solids"))
        });
    long.chain(keys).chain(pods).collect()
}

/// Fragile blocks that withstand any blow of the level.
fn unbreakable(bounds: &Bounds) -> Vec<Problem> {
    let fragile = bounds.draft.world.iter().filter_map(|block| Some((block, block.item.breaks?)));
    let Some(blow) = fragile.clone().next().and_then(|_| bounds.blow()) else { return Vec::new() };
    let warning = |(block, breaks): (&FromRow<_>, f64)| {
        let found = tr!("{breaks} N·s, with blows of at most {blow} N·s in this level", breaks, blow = blow.ceil());
        block.problem("breaks", found, tr("less than that"))
    };
    fragile.filter(|(_, breaks)| *breaks > blow).map(warning).collect()
}

/// A pad for keys none of which moves that far, on the slipperiest ground of the level and with all that the other bodies can give.
fn too_heavy(bounds: &Bounds, pad: &FromRow<Objective>) -> Option<Problem> {
    let draft = bounds.draft;
    if pad.item.kind != ObjectiveKind::Physics || draft.is_driven() || bounds.restitution() >= LIVELY {
        return None;
    }
    let mut keys = draft.objects.iter().enumerate().filter(|(_, object)| object.item.key.is_some_and(|key| pad.item.fits(key)));
    let (_, first) = keys.clone().next()?;
    let stuck = keys.all(|(index, key)| {
        let (weight, friction) = (key.item.mass * draft.settings.row.gravity, bounds.friction());
        let others: f64 = bounds.masses().enumerate().filter(|(body, _)| *body != index + 1).map(|(_, mass)| mass).sum();
        let Some(energy) = bounds.energy(Some(index)) else { return false };
        if key.item.weightless || key.item.velocity != DVec2::ZERO || 2.0 * bounds.ship.thrust > friction * weight {
            return false;
        }
        // The largest share of its energy that a light body hands to a heavy one in a blow.
        let share = 4.0 * others * key.item.mass / (others + key.item.mass).powi(2);
        let given = if others < key.item.mass { share * energy } else { energy };
        let far = MARGIN * given / weight * (1.0 / friction + 1.0);
        let falls = (2.0 * bounds.size.y / draft.settings.row.gravity * (draft.world.len() + draft.doors.len() + 1) as f64).sqrt();
        let reach = (far + (2.0 * given / key.item.mass).sqrt() * falls) / (1.0 - bounds.restitution()).powi(2);
        let own = Aabb::around(key.item.position, key.item.size * 0.5);
        let across = (own.min.x - pad.item.bounds.max.x).max(pad.item.bounds.min.x - own.max.x);
        across > reach || own.min.y - pad.item.bounds.max.y > reach
    });
    let mass = first.item.mass;
    let found = tr!("{mass} kg, which nothing in the level brings to the objective of line {line}", mass, line = pad.line);
    stuck.then(|| first.problem("mass", found, tr("a key that the ship can move so far")))
}

/// A pad whose bodies are all tied to places too far from it.
fn tied(bounds: &Bounds, pad: &FromRow<Objective>) -> Option<Problem> {
    let draft = bounds.draft;
    let bound: Vec<(&FromRow<_>, LevelLink)> =
        draft.links.iter().filter_map(|link| Some((link, link.item.bind(&draft.objects)?))).collect();
    let mut fits = fitting(draft, &pad.item, (bounds.ship.position, SHIP_HALF)).peekable();
    fits.peek()?;
    let energy = bounds.energy(None)?;
    let mut first = None;
    let all = fits.all(|(centre, half)| {
        let near = Aabb::new(pad.item.bounds.min - half, pad.item.bounds.max + half);
        let tether = bound.iter().find(|(_, link)| {
            let (LinkEnd::Place(place), LinkLaw::Rope(tie) | LinkLaw::Spring(tie)) = (link.def.to, link.def.law) else {
                return false;
            };
            let own = bounds.centre(link.def.body) == centre && link.def.breaks.is_none() && !link.def.hook;
            let length = if link.def.as_found { place.distance(centre) } else { tie.length };
            let over = place.clamp(near.min, near.max).distance(place) - length;
            own && over > 0.0 && 0.5 * tie.stiffness * over * over > energy
        });
        first = first.or(tether.map(|(row, _)| *row));
        tether.is_some()
    });
    let row = first.filter(|_| all)?;
    let found = tr!("a link too short for the objective of line {line}, for which nothing can stretch it", line = pad.line);
    Some(row.problem("length", found, tr("one that lets its body get there")))
}

/// What the bodies of a level can come to.
pub(super) struct Bounds<'a> {
    pub draft: &'a Draft,
    pub ship: &'a ShipStart,
    /// Of the level, m.
    pub size: DVec2,
}

impl Bounds<'_> {
    fn masses(&self) -> impl Iterator<Item = f64> {
        std::iter::once(self.ship.mass).chain(self.draft.objects.iter().map(|object| object.item.mass))
    }

    fn centre(&self, body: BodyId) -> DVec2 {
        body.index().checked_sub(1).map_or(self.ship.position, |object| self.draft.objects[object].item.position)
    }

    fn materials(&self) -> impl Iterator<Item = &Material> {
        let solids = self.draft.world.iter().chain(&self.draft.doors).map(|solid| &solid.item.material);
        let bodies = self.draft.objects.iter().map(|object| &object.item.material);
        solids.chain(bodies).chain([&self.ship.material, &Material::ASPHALT])
    }

    /// The largest of the level.
    fn restitution(&self) -> f64 {
        let own = self.draft.objects.iter().map(|object| object.item.restitution).chain([self.ship.restitution]);
        own.chain(self.materials().map(|material| material.restitution)).fold(0.0, f64::max)
    }

    /// The smallest coefficient of kinetic friction of the level.
    fn friction(&self) -> f64 {
        self.draft.settings.row.friction * self.materials().map(|material| material.kinetic_friction).fold(f64::INFINITY, f64::min)
    }

    /// The energy, J, that all bodies have at most at any time, but for an object that stays where it is: theirs at the start, and the work
    /// of the engine. With d√E/dt ≤ thrust/√(2·mass) that work has a bound in vacuum; in air, F·v − k·v³ has a maximum.
    /// `None` where something else does work.
    fn energy(&self, but: Option<usize>) -> Option<f64> {
        let Self { draft, ship, size } = self;
        let gravity = draft.settings.row.gravity;
        let moved = draft.movers.is_empty() && draft.world.iter().all(|block| block.item.belt == 0.0);
        let own = moved && !draft.has_currents() && draft.settings.row.gravity_x == 0.0 && gravity > 0.0;
        let tied = draft.links.iter().map(|link| link.item.bind(&draft.objects));
        let stored = tied.map(|link| self.stored(&link?)).sum::<Option<f64>>()?;
        let of = |mass: f64, at: DVec2, v: DVec2| mass * (0.5 * v.length_squared() + gravity * (size.y - at.y).max(0.0));
        let objects = draft.objects.iter().enumerate().filter(|(index, _)| Some(*index) != but);
        let start = stored
            + of(ship.mass, ship.position, ship.velocity)
            + objects.map(|(_, body)| of(body.item.mass, body.item.position, body.item.velocity)).sum::<f64>();
        let burns = (ship.fuel + draft.pods.iter().map(|pod| pod.item.fuel).sum::<f64>()) / BURN_RATE;
        let vacuum = (start.sqrt() + ship.thrust * burns / (2.0 * ship.mass).sqrt()).powi(2);
        let drag = self.drag();
        let power = 2.0 / 3.0 * ship.thrust * (ship.thrust / (3.0 * drag)).sqrt();
        own.then_some(if drag > 0.0 { vacuum.min(start + power * burns) } else { vacuum })
    }

    /// The least drag of the ship at 1 m/s, N.
    fn drag(&self) -> f64 {
        let air = if self.ship.feels_air { self.draft.settings.row.air_density } else { 0.0 };
        0.5 * air * self.ship.drag * 2.0 * SHIP_HALF.min_element()
    }

    /// The energy of a link at the start, J; `None` where it may do more work than that.
    fn stored(&self, link: &LevelLink) -> Option<f64> {
        let worked = |name: &str| self.draft.switches.iter().any(|switch| switch.item.works.iter().any(|work| work.name == name));
        let (LinkLaw::Spring(Spring { length, stiffness, .. }) | LinkLaw::Rope(Spring { length, stiffness, .. })) = link.def.law
        else {
            return None;
        };
        if link.def.rate != 0.0 || link.def.hook || link.name.as_deref().is_some_and(|name| name.split('&').any(worked)) {
            return None;
        }
        let to = match link.def.to {
            LinkEnd::Place(place) => place,
            LinkEnd::Body(body) => self.centre(body),
        };
        let over = if link.def.as_found { 0.0 } else { self.centre(link.def.body).distance(to) - length };
        Some(0.5 * stiffness * over * over)
    }

    /// N·s, friction with it. Of a ship alone by its speeds, of several bodies by all their energy: Σ m·v ≤ √(2·E·Σm).
    fn blow(&self) -> Option<f64> {
        let restitution = self.restitution();
        let bounced = (restitution < LIVELY).then_some((1.0 + restitution) / (1.0 - restitution))?;
        let fastest = |side: DVec2| Some(self.run(side, None)?.max(self.run(-side, None)?));
        let alone = || Some((2.0 * self.ship.mass * (fastest(DVec2::X)? + fastest(DVec2::Y)?)).sqrt());
        let energy = || Some((2.0 * self.energy(None)? * self.masses().sum::<f64>()).sqrt());
        alone().into_iter().chain(energy()).min_by(f64::total_cmp).map(|least| bounced * least)
    }

    /// The kinetic energy, J, that a ship alone has at most along one axis to one side: such a run begins at rest or at the start, and is as
    /// long as the level. `but` is the index of a stream or of a field, whose force is left out.
    /// `None` where it may be thrown.
    pub fn run(&self, side: DVec2, but: Option<Zone>) -> Option<f64> {
        let Self { draft, ship, size } = self;
        let alone = draft.objects.is_empty() && !draft.is_driven() && draft.fluids.is_empty() && self.restitution() == 0.0;
        let settings = &draft.settings.row;
        let all = draft.streams.iter().enumerate().map(|(index, stream)| (Zone::Stream(index), stream.item.force));
        let all =
            all.chain(draft.fields.iter().enumerate().map(|(index, field)| (Zone::Field(index), field.item.strength * ship.mass)));
        let zones: f64 = all.filter(|(zone, _)| Some(*zone) != but).map(|(_, force)| force.dot(side).max(0.0)).sum();
        let weight = ship.mass * DVec2::new(settings.gravity_x, settings.gravity).dot(side).max(0.0);
        let start = 0.5 * ship.mass * ship.velocity.dot(side).max(0.0).powi(2);
        alone.then(|| start + (ship.thrust + zones + weight) * size.dot(side.abs()))
    }
}

/// The index of a stream or of a gravity zone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Zone {
    Stream(usize),
    Field(usize),
}
