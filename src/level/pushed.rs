//! Warnings of keys below a step to their objective. A key rises when the ship, or a body that the ship lifts, gets below it, when a zone,
//! a mover or a link lifts it, when the ship carries it by friction, or by a hop from a hit. Where none of the first three is possible, a key slides,
//! falls and hops. A key that falls may bounce back to its old height.

use super::draft::Draft;
use super::problem::Problem;
use super::reach::{CentredBox, Counts, FreeSpace, Grid};
use super::schema::settings::LevelSettings;
use super::types::{Object, ObjectiveKind, SHIP_HALF, ShipStart};
use crate::physics::{Aabb, DVec2};
use crate::words::tr;

/// m/s. The fastest hit that makes a key hop: a faster one costs the ship points.
const HIT: f64 = 10.0;
/// A level with more objects gets no warning.
const MOST_OBJECTS: usize = 500;

/// The objectives for keys to which no key gets that fits.
pub(super) fn warn(draft: &Draft, player: &ShipStart, space: &FreeSpace) -> Vec<Problem> {
    let wanted: Vec<_> = draft.objectives.iter().filter(|placed| placed.item.kind == ObjectiveKind::Physics).collect();
    let settings = &draft.settings;
    let sideways = settings.gravity <= 0.0 || settings.gravity_x != 0.0;
    let own = draft.objects.iter().any(|object| object.item.weightless || object.item.velocity != DVec2::ZERO);
    let large = draft.objects.len() > MOST_OBJECTS;
    if wanted.is_empty() || draft.is_driven() || draft.has_currents() || sideways || own || large {
        return Vec::new();
    }
    let lifted = draft.objects.iter().any(|object| {
        let hop = hop(draft, &object.item, player);
        is_carried(&object.item, player, settings) || is_lifted(&object.item, hop, player, draft, space)
    });
    if lifted {
        return Vec::new();
    }
    let gets_there = |key: &Object, target: &Aabb| {
        let hop = hop(draft, key, player);
        Pushed::new(key, hop, draft, space).is_none_or(|pushed| pushed.gets_to(target))
    };
    let stuck = wanted.into_iter().filter(|placed| {
        let mut keys = draft.objects.iter().filter(|object| object.item.key.is_some_and(|key| placed.item.fits(key)));
        !keys.any(|key| gets_there(&key.item, &placed.item.bounds))
    });
    let expected = tr("a route down to it, or something that lifts the key");
    stuck
        .map(|placed| placed.problem("y", tr("an objective up a step that no key which fits can be pushed over"), expected))
        .collect()
}

/// How far a key hops, m: friction passes on at most μ of a hit's impulse upwards. Low objects that it may climb on the way come on top.
fn hop(draft: &Draft, key: &Object, player: &ShipStart) -> f64 {
    let settings = &draft.settings;
    let material = key.material.kinetic_friction.min(player.material.kinetic_friction) * settings.friction;
    let bounce = [key.restitution, player.restitution, key.material.restitution, player.material.restitution];
    let bounce = bounce.into_iter().fold(0.0, f64::max);
    let speed = material * (1.0 + bounce) * player.mass / (player.mass + key.mass) * HIT;
    let hop = speed * speed / (2.0 * settings.gravity);
    let steps = draft.objects.iter().map(|object| object.item.size.y).filter(|height| *height <= hop);
    hop + steps.sum::<f64>()
}

/// Whether the ship can carry an object before it: the push makes enough friction to bear the object, and the thrust bears both.
fn is_carried(object: &Object, player: &ShipStart, settings: &LevelSettings) -> bool {
    let friction = object.material.static_friction.min(player.material.static_friction) * settings.friction;
    let weight = (player.mass + object.mass) * settings.gravity;
    player.thrust >= weight * (1.0 + 1.0 / (friction * friction)).sqrt()
}

/// Whether the ship gets below an object somewhere.
fn is_lifted(object: &Object, hop: f64, player: &ShipStart, draft: &Draft, space: &FreeSpace) -> bool {
    let (Some(pushed), Some(ship)) = (Pushed::new(object, hop, draft, space), space.grid(SHIP_HALF)) else { return true };
    let part = ship.part_at(player.position);
    if part == 0 || !space.work.spend(ship.parts.len()) {
        return true;
    }
    let ships = Counts::new(&ship, |cell| ship.parts[cell] == part);
    let reach = pushed.grid.half + SHIP_HALF;
    (0..pushed.grid.parts.len()).filter_map(|cell| pushed.area(cell)).any(|area| {
        // Side by side they touch as well, but neither is below the other.
        let aside = reach.x - 2.0 * pushed.grid.slack;
        let below = Aabb {
            min: DVec2::new(area.min.x - aside, area.min.y + reach.y - pushed.grid.slack),
            max: DVec2::new(area.max.x + aside, area.max.y + reach.y + pushed.grid.slack),
        };
        ships.any_in(&below)
    })
}

/// Where an object gets by sliding, falling and hopping.
struct Pushed {
    grid: std::rc::Rc<Grid>,
    /// The highest place of its centre in each cell, y in m; infinite where it does not get.
    highest: Vec<f64>,
}

impl Pushed {
    /// `None` where the level is too large to say, or where the object starts in a solid.
    fn new(object: &Object, hop: f64, draft: &Draft, space: &FreeSpace) -> Option<Self> {
        let (position, half): CentredBox = (object.position, object.size * 0.5);
        let grid = space.grid(half)?;
        let start = grid.at(position);
        if grid.is_blocked(start) {
            return None;
        }
        // Its supports besides rock.
        let doors = draft.doors.iter().map(|door| door.item.bounds);
        let plates = draft.switches.iter().filter(|switch| switch.item.weight.is_some()).map(|plate| plate.item.bounds);
        let others = draft.world.iter().filter(|solid| !solid.item.is_rock()).map(|solid| solid.item.bounds);
        let supports: Vec<Aabb> = doors.chain(plates).chain(others).map(|b| Aabb::new(b.min - half, b.max + half)).collect();
        let mut pushed = Self { highest: vec![f64::INFINITY; grid.parts.len()], grid };
        pushed.highest[start] = position.y - hop;
        let mut open = vec![start];
        while let Some(cell) = open.pop() {
            if !space.work.spend(1 + supports.len()) {
                return None;
            }
            let area = pushed.grid.area(cell);
            let [left, right, above, below] = pushed.grid.beside(cell);
            // Where it stands it can hop.
            let mut highest = pushed.highest[cell];
            if pushed.grid.is_blocked(below) {
                highest = highest.min(area.max.y - hop);
            }
            let stands = |support: &&Aabb| {
                let across = support.min.x < area.max.x.max(area.min.x + f64::EPSILON) && support.max.x >= area.min.x;
                across && (area.min.y..=area.max.y).contains(&support.min.y) && support.min.y >= highest
            };
            highest = supports.iter().filter(stands).fold(highest, |highest, support| highest.min(support.min.y - hop));
            pushed.highest[cell] = highest;
            for next in [left, right, above, below] {
                let gets_in = !pushed.grid.is_blocked(next) && highest <= pushed.grid.area(next).max.y;
                if gets_in && highest < pushed.highest[next] {
                    pushed.highest[next] = highest;
                    open.push(next);
                }
            }
        }
        Some(pushed)
    }

    /// The part of a cell that it gets to.
    fn area(&self, cell: usize) -> Option<Aabb> {
        let highest = Some(self.highest[cell]).filter(|highest| highest.is_finite())?;
        let area = self.grid.area(cell);
        Some(Aabb { min: area.min.max(DVec2::new(area.min.x, highest)), max: area.max })
    }

    fn gets_to(&self, target: &Aabb) -> bool {
        let reach = self.grid.half + self.grid.slack;
        let near = Aabb { min: target.min - reach, max: target.max + reach };
        (0..self.grid.parts.len()).filter_map(|cell| self.area(cell)).any(|area| area.touches(&near, 0.0))
    }
}
