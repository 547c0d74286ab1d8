//! Warnings of engines, tanks and medals that ask the impossible. With e the energy of all bodies a kilogram of the ship, thrust T, mass m
//! and burning time b, √(2e) grows by at most b·T/m: the engine's power is T·v, and v ≤ √(2e). A climb by h from a place D above the lowest
//! takes √(2g(D + h)). √(2E) of all bodies together grows by at most t·√(Σ F²/m), with F the sum of all forces that can act on a body.

use super::draft::Draft;
use super::placed::FromRow;
use super::problem::Problem;
use super::reach::{FreeSpace, Grid};
use super::schema::settings::{CONSTANTS, LevelSettings};
use super::types::{BURN_RATE, Mark, Object, Objective, ObjectiveKind, SHIP_HALF, ShipStart, TICK_RATE};
use super::winnable::fitting;
use crate::physics::{Aabb, DVec2, Material};
use crate::words::tr;
use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::rc::Rc;

/// How often a body may bounce off movers within the time of a medal, each time by twice their speed.
const BOUNCES: f64 = 10.0;
/// The most ticks of burning: 97 days.
const MOST_TICKS: f64 = 1e9;
/// The most comparisons of bodies, blocks and objectives; a larger level gets no warning.
const MOST_LOOKS: usize = 20_000_000;
/// m. A body that is nearer than this touches.
const NEAR: f64 = 1e-6;

pub(super) fn warn(draft: &Draft, player: &FromRow<ShipStart>, space: &FreeSpace) -> Vec<Problem> {
    let bodies = draft.objects.len() + 1;
    if bodies * (draft.world.len() + draft.objectives.len()) * (draft.objectives.len() + 1) > MOST_LOOKS {
        return Vec::new();
    }
    let settings = &draft.settings;
    let power = Power { draft, ship: &player.item, settings };
    let mut warnings = Vec::new();
    let weight = player.item.mass * settings.gravity;
    let climbs = if power.is_lifted() { None } else { Climbs::new(player.item.position, space) };
    let up = |climbs: &Climbs| power.pads().any(|pad| climbs.to(&pad.item.bounds).is_some_and(|climb| climb > NEAR));
    if player.item.thrust < weight && !power.may_rise() && climbs.as_ref().is_some_and(up) {
        let found = tr!("{thrust} N, less than the ship's weight of {weight} N", thrust = player.item.thrust, weight);
        warnings.push(player.problem("thrust", found, tr("more than that, as nothing in the level lifts the ship")));
    }
    let needed = climbs.and_then(|climbs| power.fuel_needed(&climbs, space));
    let pods: f64 = draft.pods.iter().map(|pod| pod.item.fuel).sum();
    if let Some((needed, line)) = needed.filter(|(needed, _)| player.item.fuel + pods < *needed) {
        let found = format!("{} {}", player.item.fuel, tr("fuel units"));
        let expected = tr!(
            "at least {least}, less than which no flight to line {line} of objectives.csv takes",
            least = format_args!("{needed:.3}"),
            line
        );
        warnings.push(player.problem("fuel", found, expected));
    }
    warnings.extend(power.medals(needed.map_or(0.0, |(needed, _)| needed)));
    warnings
}

struct Power<'a> {
    draft: &'a Draft,
    ship: &'a ShipStart,
    settings: &'a LevelSettings,
}

impl Power<'_> {
    /// Whether something in the level may lift the ship or throw it up.
    fn is_lifted(&self) -> bool {
        let draft = self.draft;
        let winds = draft.streams.iter().map(|stream| stream.item.force.y);
        let up = winds.chain(draft.fields.iter().map(|field| field.item.strength.y)).any(|y| y < 0.0);
        let springy = draft.world.iter().any(|solid| solid.item.material.restitution > 0.0);
        up || springy || !draft.fluids.is_empty() || draft.is_driven()
    }

    /// Whether some body may rise although no engine bears its weight: without bounces none rises faster than one did before.
    fn may_rise(&self) -> bool {
        let draft = self.draft;
        let bounces = |restitution: f64, material: Material| restitution.max(material.restitution) > 0.0;
        let rises = |object: &Object| object.velocity.y < 0.0 || bounces(object.restitution, object.material);
        let bodies = draft.objects.iter().any(|object| rises(&object.item));
        let ship = self.ship.velocity.y < 0.0 || bounces(self.ship.restitution, self.ship.material);
        // A door that closes puts a body out of itself.
        self.is_lifted() || bodies || ship || !draft.doors.is_empty()
    }

    /// Whether something in the level may drive the ship to any side.
    fn is_helped(&self) -> bool {
        self.is_lifted() || !self.draft.streams.is_empty() || !self.draft.fields.is_empty()
    }

    /// The fastest belt, m/s.
    fn belt(&self) -> f64 {
        let belts = self.draft.world.iter().map(|solid| &solid.item).chain(self.draft.movers.iter().map(|mover| &mover.item.solid));
        belts.map(|solid| solid.belt.abs()).fold(0.0, f64::max)
    }

    /// The fuel units that the costliest objective takes at least, and its line; `None` where no bound is known.
    fn fuel_needed(&self, climbs: &Climbs, space: &FreeSpace) -> Option<(f64, usize)> {
        if self.is_helped() || self.settings.gravity <= 0.0 || self.settings.gravity_x != 0.0 || self.ship.thrust == 0.0 {
            return None;
        }
        let others: f64 = self.draft.objects.iter().map(|object| self.energy_of(&object.item, space)).sum();
        let begun = 0.5 * self.ship.velocity.length_squared() + others / self.ship.mass;
        let depth = climbs.depth;
        let speed = |height: f64| (2.0 * self.settings.gravity * (depth + height).max(0.0)).sqrt();
        let first = (2.0 * (begun + self.settings.gravity * depth)).sqrt();
        // Where no body bounces, one that the ship does not push moves only downwards.
        let plain = others == 0.0 && self.ship.restitution.max(self.ship.material.restitution) == 0.0;
        let along = |gap: f64| if plain { self.seconds_along(gap, first) } else { 0.0 };
        let ship = Aabb::around(self.ship.position, SHIP_HALF);
        let aside = |bounds: &Aabb| bounds.gap(&ship).x;
        let mut needed = Vec::new();
        for pad in self.pads() {
            let missing = speed(climbs.to(&pad.item.bounds)?) - first;
            // The last tick with fuel burns to its end.
            let seconds = (missing * self.ship.mass / self.ship.thrust - 1.0 / TICK_RATE).max(0.0);
            needed.push((seconds.max(along(aside(&pad.item.bounds))), pad.line));
        }
        // A key that has to be moved is moved by the ship, or by an object that the ship has moved.
        let bodies = self.draft.objects.iter().map(|object| Aabb::around(object.item.position, object.item.size * 0.5));
        if let Some(nearest) = bodies.map(|body| aside(&body)).reduce(f64::min).filter(|_| self.falls().is_some()) {
            needed.extend(self.keys_to_move().map(|placed| (along(nearest), placed.line)));
        }
        let most = needed.into_iter().reduce(|most, next| if most.0 < next.0 { next } else { most });
        most.map(|(seconds, line)| (seconds * BURN_RATE, line))
    }

    fn pads(&self) -> impl Iterator<Item = &FromRow<Objective>> {
        self.draft.objectives.iter().filter(|placed| placed.item.kind == ObjectiveKind::Player)
    }

    /// The energy that an object can pass on, J: its own, and, where it bounces, that of its fall.
    fn energy_of(&self, object: &Object, space: &FreeSpace) -> f64 {
        let bounces = object.restitution.max(object.material.restitution).max(self.ship.restitution) > 0.0;
        let fall = if bounces { (space.level.max.y - object.position.y - object.size.y * 0.5).max(0.0) } else { 0.0 };
        object.mass * (0.5 * object.velocity.length_squared() + self.settings.gravity * fall)
    }

    /// The least seconds of burning that carry the ship `gap` m aside: at the start, and after each tick of burning, it flies as far as its
    /// energy carries it, and slides out. `first` is √(2e) at the start, m/s.
    fn seconds_along(&self, gap: f64, first: f64) -> f64 {
        let floors = self.draft.world.iter().map(|solid| solid.item.material);
        let floors = floors.chain(self.draft.doors.iter().map(|door| door.item.material));
        let floors = floors.chain(self.draft.objects.iter().map(|object| object.item.material));
        let floors = floors.chain([self.ship.material]);
        let friction = floors.map(|material| material.kinetic_friction).fold(Material::ASPHALT.kinetic_friction, f64::min);
        let friction = friction * self.settings.friction;
        if gap <= 0.0 || friction <= 0.0 {
            return 0.0;
        }
        let pull = self.ship.thrust / self.ship.mass;
        let steps = self.draft.world.len() + self.draft.doors.len() + self.draft.objects.len() + 1;
        // In n falls from step to step it is in the air √n times as long as in one.
        let falls = 2.0 + (steps as f64).sqrt();
        let far = |ticks: f64| {
            let (seconds, speed) = (ticks / TICK_RATE, first + pull * ticks / TICK_RATE);
            speed * seconds + (ticks + 1.0) * speed * speed / self.settings.gravity * (falls + 0.5 / friction)
        };
        let mut most = 1.0;
        while far(most) < gap && most < MOST_TICKS {
            most *= 2.0;
        }
        let mut least = 0.0;
        while most - least > 1.0 {
            let middle = (0.5 * (least + most)).floor();
            if far(middle) < gap { least = middle } else { most = middle }
        }
        // The last tick may end the flight as soon as it begins.
        least / TICK_RATE
    }

    /// Medals that no flight earns.
    fn medals(&self, burnt: f64) -> Vec<Problem> {
        let awards = &self.settings.awards;
        let mut warnings = Vec::new();
        let mut warn = |name: &str, found: String, expected: String| {
            let line = self.settings.given.line_of(name);
            warnings.push(Problem::new(CONSTANTS.name, line, "value", found, expected));
        };
        let least = self.least_time();
        for (name, time) in [("silver", awards.silver), ("gold", awards.gold)] {
            if let (Some(time), Some((least, line))) = (time, least)
                && time < least - 1.0 / TICK_RATE
            {
                let expected = tr!(
                    "at least {least}, less than which no flight to line {line} of objectives.csv takes",
                    least = format_args!("{least:.3} s"),
                    line
                );
                warn(name, tr!("{found} for {column}", found = format_args!("{time} s"), column = name), expected);
            }
        }
        let still = self
            .falls()
            .filter(|_| self.draft.objectives.iter().any(|placed| self.gap(&placed.item).is_some_and(|gap| gap.0 > NEAR)));
        match awards.mark {
            Some(Mark::Fuel(percent)) if self.draft.pods.is_empty() && self.ship.fuel > 0.0 && still.is_some() => {
                let burnt = burnt.max(BURN_RATE / TICK_RATE);
                let most = (100.0 * (1.0 - burnt / self.ship.fuel)).max(0.0);
                if percent > most {
                    let expected =
                        tr!("at most {most} %: any flight to the end burns more than the rest", most = format_args!("{most:.3}"));
                    warn("mark_fuel", format!("{percent} {}", tr("% of the fuel left")), expected);
                }
            }
            Some(Mark::Speed(speed)) if self.ship.velocity.length() > speed => {
                let found = tr!(
                    "{speed} m/s, with a start at {start} m/s",
                    speed,
                    start = format_args!("{:.3}", self.ship.velocity.length())
                );
                warn("mark_speed", found, tr("at least the speed at the start").to_owned());
            }
            Some(Mark::Pushes(0)) if still.is_some() && !self.is_helped() && self.keys_to_move().next().is_some() => {
                let expected = tr("at least 1: a key has to be moved, and nothing but the ship moves it");
                warn("mark_pushes", tr("0 pushes").to_owned(), expected.to_owned());
            }
            _ => {}
        }
        warnings
    }

    /// The objectives that no key gets to by falling.
    fn keys_to_move(&self) -> impl Iterator<Item = &FromRow<Objective>> {
        let physics = self.draft.objectives.iter().filter(|placed| placed.item.kind == ObjectiveKind::Physics);
        physics.filter(|placed| self.gap(&placed.item).is_some_and(|(gap, _)| gap > NEAR))
    }

    /// The shortest time to the end, s, and the line of the objective that takes it; `None` where no bound is known. The clock begins with the
    /// first input; until then all bodies fall.
    fn least_time(&self) -> Option<(f64, usize)> {
        let falls = self.falls()?;
        let settings = self.settings;
        let pull = self.settings.gravity.abs() + settings.gravity_x.abs();
        let pull = pull + self.draft.fields.iter().map(|field| field.item.strength.length()).sum::<f64>();
        let wind: f64 = self.draft.streams.iter().map(|stream| stream.item.force.length()).sum();
        let dense: f64 = self.draft.fluids.iter().map(|fluid| fluid.item.density).sum();
        let bodies = std::iter::once((self.ship.mass, SHIP_HALF * 2.0, self.ship.thrust));
        let bodies = bodies.chain(self.draft.objects.iter().map(|object| (object.item.mass, object.item.size, 0.0)));
        let (mut energy, mut power) = (0.0, 0.0);
        for ((mass, size, thrust), fall) in bodies.zip(falls) {
            let force = mass * pull + wind + thrust + dense * pull * size.x * size.y;
            energy += mass * self.settings.gravity * fall;
            power += force * force / mass;
        }
        let (begun, grows) = ((2.0 * energy).sqrt(), power.sqrt());
        let movers = self
            .draft
            .movers
            .iter()
            .flat_map(|mover| &mover.item.path.legs)
            .map(|leg| leg.velocity.length() + leg.acceleration.length() * leg.duration);
        let driven = 2.0 * BOUNCES * movers.fold(0.0, f64::max) + self.belt();
        let mut longest: Option<(f64, usize)> = None;
        for placed in &self.draft.objectives {
            let (gap, mass) = self.gap(&placed.item)?;
            let (speed, pull) = (begun / mass.sqrt() + driven, grows / mass.sqrt());
            let time =
                placed.item.hold + if gap > NEAR { 2.0 * gap / (speed + (speed * speed + 2.0 * pull * gap).sqrt()) } else { 0.0 };
            if longest.is_none_or(|(known, _)| known < time) {
                longest = Some((time, placed.line));
            }
        }
        longest
    }

    /// The least distance, m, and the least mass, kg, of the bodies that fit an objective, wherever each has fallen to before the first input.
    fn gap(&self, objective: &Objective) -> Option<(f64, f64)> {
        let ship = (self.ship.position, SHIP_HALF);
        let gaps = fitting(self.draft, objective, ship)
            .map(|(centre, half)| self.column(centre, half).gap(&objective.bounds).max(DVec2::ZERO).length());
        let gap = gaps.reduce(f64::min)?;
        let keys = self.draft.objects.iter().filter(|object| object.item.key.is_some_and(|key| objective.fits(key)));
        let lightest = keys.map(|key| key.item.mass).fold(f64::INFINITY, f64::min);
        Some((gap, if objective.kind == ObjectiveKind::Player { self.ship.mass } else { lightest }))
    }

    /// The box that a body passes while it falls straight down to the first block.
    fn column(&self, centre: DVec2, half: DVec2) -> Aabb {
        let body = Aabb::around(centre, half);
        Aabb { min: body.min, max: DVec2::new(body.max.x, body.max.y + self.fall(&body)) }
    }

    fn fall(&self, body: &Aabb) -> f64 {
        let below = self.draft.world.iter().filter(|solid| solid.item.is_rock()).map(|solid| solid.item.bounds);
        let below = below.filter(|solid| solid.min.x < body.max.x - NEAR && solid.max.x > body.min.x + NEAR);
        let floor = self.draft.size.map_or(f64::INFINITY, |size| size.y / self.draft.scale.metre);
        let first = below.map(|solid| solid.min.y).filter(|top| *top >= body.max.y - NEAR).fold(floor, f64::min);
        (first - body.max.y).max(0.0)
    }

    /// How far each body falls before the first input, m, the ship first; `None` where a body may then move sideways.
    fn falls(&self) -> Option<Vec<f64>> {
        let draft = self.draft;
        let thrown = self.ship.velocity != DVec2::ZERO || draft.objects.iter().any(|object| object.item.velocity != DVec2::ZERO);
        if thrown || !draft.links.is_empty() || self.settings.gravity < 0.0 || self.settings.gravity_x != 0.0 {
            return None;
        }
        let zones = draft.streams.iter().map(|stream| stream.item.zone).chain(draft.fields.iter().map(|field| field.item.zone));
        let zones = zones.chain(draft.fluids.iter().map(|fluid| fluid.item.zone));
        let belts = draft.world.iter().filter(|solid| solid.item.belt != 0.0).map(|solid| solid.item.bounds);
        let swept = draft.movers.iter().map(|mover| {
            let half = mover.item.solid.bounds.size() * 0.5;
            mover.item.stops.iter().map(|stop| Aabb::around(*stop, half)).fold(mover.item.solid.bounds, |all, at| all.union(&at))
        });
        let drives: Vec<Aabb> = zones.chain(belts).chain(swept).collect();
        let bodies = std::iter::once((self.ship.position, SHIP_HALF));
        let bodies = bodies.chain(draft.objects.iter().map(|object| (object.item.position, object.item.size * 0.5)));
        let columns: Vec<(Aabb, f64)> =
            bodies.map(|(centre, half)| (self.column(centre, half), self.fall(&Aabb::around(centre, half)))).collect();
        let driven = columns.iter().any(|(column, _)| drives.iter().any(|drive| drive.touches(column, NEAR)));
        (!driven).then(|| columns.into_iter().map(|(_, fall)| fall).collect())
    }
}

/// How far the ship has to climb above its start, at least.
struct Climbs {
    grid: Rc<Grid>,
    /// Of each cell, m; infinite where the ship does not get.
    climb: Vec<f64>,
    /// From its start down to the lowest place that it gets to, m.
    depth: f64,
    start: f64,
}

impl Climbs {
    /// `None` where the level is too large to say, or where the ship starts in a solid.
    fn new(start: DVec2, space: &FreeSpace) -> Option<Self> {
        let grid = space.grid(SHIP_HALF)?;
        // A heap costs some steps a cell.
        if grid.is_blocked(grid.at(start)) || !space.work.spend(4 * grid.parts.len()) {
            return None;
        }
        let mut climbs = Self { climb: vec![f64::INFINITY; grid.parts.len()], grid, depth: 0.0, start: start.y };
        let first = climbs.grid.at(start);
        climbs.climb[first] = 0.0;
        // The bits of numbers from 0 on are in their order.
        let mut open = BinaryHeap::from([Reverse((0.0_f64.to_bits(), first))]);
        while let Some(Reverse((bits, cell))) = open.pop() {
            let climb = f64::from_bits(bits);
            if climb > climbs.climb[cell] {
                continue;
            }
            let lowest = climbs.grid.area(cell).max.y - climbs.grid.slack;
            climbs.depth = climbs.depth.max(lowest - start.y);
            for next in climbs.grid.beside(cell) {
                if climbs.grid.is_blocked(next) {
                    continue;
                }
                let through = climb.max(start.y - climbs.grid.area(next).max.y);
                if through < climbs.climb[next] {
                    climbs.climb[next] = through;
                    open.push(Reverse((through.to_bits(), next)));
                }
            }
        }
        Some(climbs)
    }

    /// To a place from which it touches a box; `None` where it gets to none.
    fn to(&self, target: &Aabb) -> Option<f64> {
        let reach = SHIP_HALF + self.grid.slack;
        let near = Aabb { min: target.min - reach, max: target.max + reach };
        let climbs = (0..self.grid.parts.len()).filter(|cell| self.climb[*cell].is_finite()).filter_map(|cell| {
            let area = self.grid.area(cell);
            area.touches(&near, 0.0).then(|| self.climb[cell].max(self.start - area.max.y.min(near.max.y)))
        });
        climbs.reduce(f64::min)
    }
}
