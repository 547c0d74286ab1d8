//! Whether a level can be won at all, and is neither won nor lost at its start. A doubtful route counts as possible: doors are open, no body
//! is too heavy, and movers are anywhere.
//!
//! Forces and the masses on which they act: what is too strong is refused, and what is certainly too weak is warned about.
//!
//! Warnings of unreadable words.

use super::draft::Draft;
use super::placement::BoxTree;
use super::problem::{Problem, quoted};
use super::reach::{CentredBox, FreeSpace};
use super::schema::typed::FromRow;
use super::types::{Objective, ObjectiveKind, SHIP_HALF, ShipStart, Switch};
use super::world_def::{ship_body, sweep_touches};
use crate::physics::domain::MOST_ACCELERATION;
use crate::physics::{Aabb, DVec2, Material};
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

/// The expected force, where one exceeds the limit for a body of that mass.
pub(super) fn judge(force: f64, mass: f64) -> Option<String> {
    (force.abs() > MOST_ACCELERATION * mass).then(|| {
        tr!("at most {most} N, which is {acceleration} m/s²", most = MOST_ACCELERATION * mass, acceleration = MOST_ACCELERATION)
    })
}

/// The ship, where its thrust is too strong for it, and every stream that is too strong for the lightest body.
pub(super) fn check_strength(draft: &Draft) -> Vec<Problem> {
    let mut problems = Vec::new();
    if let Some(ship) = &draft.player {
        let (thrust, mass) = (ship.item.thrust, ship.item.mass);
        if let Some(expected) = judge(thrust, mass) {
            problems.push(ship.problem("thrust", tr!("{thrust} N on a ship of {mass} kg", thrust, mass), expected));
        }
    }
    let ship = draft.player.iter().map(|ship| ship.map(|ship| ship.mass));
    let masses = ship.chain(draft.objects.iter().map(|object| object.map(|object| object.mass)));
    let Some(lightest) = masses.min_by(|a, b| a.item.total_cmp(&b.item)) else { return problems };
    for fluid in draft.fluids.iter().filter(|_| draft.settings.row.gravity_x != 0.0) {
        let expected = tr("no fluids.csv where constants.csv gives a gravity_x: the surface of a liquid is level");
        problems.push(fluid.problem("x", tr("a liquid beside gravity to the side"), expected));
    }
    for stream in &draft.streams {
        let force = stream.item.force;
        for (column, force) in [("force_x", force.x), ("force_y", force.y)] {
            if let Some(expected) = judge(force, lightest.item) {
                let (file, line, mass) = (lightest.file, lightest.line, lightest.item);
                let found = tr!("{force} N, with {mass} kg in {file}:{line}", force, mass, file, line);
                problems.push(stream.problem(column, found, expected + tr(" for what is lightest")));
            }
        }
    }
    problems
}

/// An engine that lifts nothing where it has to, and plates that nothing presses.
pub(super) fn warn_of_strength(draft: &Draft, player: &FromRow<ShipStart>) -> Vec<Problem> {
    weak_engine(draft, player).into_iter().chain(heavy_plates(draft, &player.item)).collect()
}

/// Thrust below the ship's weight, where an objective lies above the start and nothing else moves any body upwards.
fn weak_engine(draft: &Draft, player: &FromRow<ShipStart>) -> Option<Problem> {
    let (ship, settings) = (&player.item, &draft.settings);
    let weight = ship.mass * settings.row.gravity;
    let top = ship.position.y - SHIP_HALF.y;
    let above = |pad: &FromRow<Objective>| pad.item.kind == ObjectiveKind::Player && pad.item.bounds.max.y < top;
    if ship.thrust >= weight || lifts(draft, ship) || !draft.objectives.iter().any(above) {
        return None;
    }
    let found = tr!("{thrust} N, less than the ship's weight of {weight} N", thrust = ship.thrust, weight);
    Some(player.problem("thrust", found, tr("more than that, as nothing in the level lifts the ship")))
}

/// Whether anything but the engine may move a body upwards: winds, fields, liquids, links, belts, movers, bounces, throws, and doors,
/// which put a body out of themselves.
fn lifts(draft: &Draft, ship: &ShipStart) -> bool {
    let winds = draft.streams.iter().map(|stream| stream.item.force.y);
    let up = winds.chain(draft.fields.iter().map(|field| field.item.strength.y)).any(|y| y < 0.0);
    let rises = |velocity: f64, restitution: f64, material: Material| velocity < 0.0 || restitution.max(material.restitution) > 0.0;
    let bodies = draft.objects.iter().map(|object| &object.item);
    up || draft.is_driven()
        || !draft.fluids.is_empty()
        || !draft.doors.is_empty()
        || draft.world.iter().any(|solid| solid.item.material.restitution > 0.0)
        || rises(ship.velocity.y, ship.restitution, ship.material)
        || bodies.into_iter().any(|body| rises(body.velocity.y, body.restitution, body.material))
}

/// Plates that take more than all masses and the thrust together. A mover, a belt, a link, a wind, a zone or a liquid presses without such
/// a bound.
fn heavy_plates(draft: &Draft, ship: &ShipStart) -> Vec<Problem> {
    if draft.is_driven() || draft.has_currents() || draft.settings.row.gravity_x != 0.0 {
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

/// The least width of a letter, in heights of it: only words that run out in any case are reported.
const NARROWEST: f64 = 0.36;

/// Letters that the game's typefaces lack, and texts that run out of a level of `size` metres.
pub(super) fn warn_of_texts(draft: &Draft, size: DVec2) -> Vec<Problem> {
    let mut warnings = Vec::new();
    for text in &draft.texts {
        let words = &text.item.text;
        warnings.extend(lacking(text, words));
        let end = text.item.position + DVec2::new(words.chars().count() as f64 * NARROWEST, 1.0) * text.item.size;
        let out = text.item.position.cmplt(DVec2::ZERO).any() || end.cmpgt(size + text.item.size * 0.5).any();
        if out {
            warnings.push(text.problem(
                "x",
                tr!("{words}, which runs out of the level", words = quoted(words)),
                tr("words that end within it"),
            ));
        }
    }
    warnings.extend(draft.hints.iter().filter_map(|hint| lacking(hint, &hint.item)));
    warnings
}

/// The first letter of words in a row that would be drawn as a box.
fn lacking<T>(row: &FromRow<T>, words: &str) -> Option<Problem> {
    let letter = words.chars().find(|letter| !is_drawn(*letter))?;
    let found = tr!("{letter}, which would be drawn as a box", letter = quoted(&letter.to_string()));
    Some(row.problem("text", found, tr("letters of Latin, Greek or Cyrillic, signs and arrows, on one line")))
}

/// No line break, and no letter of a script that the typefaces lack.
fn is_drawn(letter: char) -> bool {
    let lacking = matches!(u32::from(letter),
        0x0590..=0x109F | 0x1100..=0x11FF | 0x2E80..=0xA4CF | 0xA960..=0xD7FF | 0xF900..=0xFAFF | 0xFB50..=0xFDFF | 0x1F000..);
    !letter.is_control() && !lacking
}

#[cfg(test)]
mod tests {
    use super::is_drawn;

    #[test]
    fn what_the_typefaces_lack_is_known() {
        assert!("Über → 10 m/s², Ωж ≥ ½ ✓".chars().all(is_drawn));
        for letter in ['日', '한', 'ع', 'ש', '😀', '\n', '\u{7}'] {
            assert!(!is_drawn(letter), "{letter:?}");
        }
    }
}
