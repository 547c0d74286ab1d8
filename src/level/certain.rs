//! What `check` warns of: a list of checks, each of which says what holds whatever the keys, by bounds of energy and speed, or that a row can
//! have no use.

use super::reach::{CentredBox, grown};
use super::types::{LevelLink, Objective, ObjectiveKind, Presser, SHIP_HALF, Switch};
use super::winnable::{Checked, LIVELY, TouchGoal};
use super::{draft::Draft, gates, problem::Problem, schema::typed::FromRow, types};
use crate::number::{fixed, trimmed};
use crate::physics::{Aabb, DVec2, LinkEnd, LinkLaw};
use crate::words::tr;
use std::collections::BTreeMap;

/// m/s. A mover, belt or winch this fast crosses a screen in a second or so: its author may have thought of pixels.
const LIKE_PIXELS: f64 = 40.0;
/// m/s; the same of the start of a body, which may well be thrown.
const THROWN_LIKE_PIXELS: f64 = 80.0;
/// How far beyond its bound a body has to go before that is certain: the bounds leave out how pushes and hops share out the energy.
const MARGIN: f64 = 4.0;
pub(super) fn warn(level: &Checked) -> Vec<Problem> {
    const CHECKS: [fn(&Checked) -> Vec<Problem>; 11] = [
        same_turns,
        unreached,
        gates::warn,
        weak_engine,
        heavy_plates,
        like_pixels,
        long_holds,
        unused_keys,
        barred_pods,
        unbreakable,
        unmet,
    ];
    CHECKS.iter().flat_map(|check| check(level)).collect()
}

/// Objectives with the same turn: the rules let these be met in any order, which an author seldom wants.
fn same_turns(level: &Checked) -> Vec<Problem> {
    let mut first: BTreeMap<u32, usize> = BTreeMap::new();
    let mut warning = |pad: &FromRow<Objective>| {
        let order = pad.item.order?;
        let line = *first.entry(order).or_insert(pad.line);
        let found = tr!("{order} once more, the turn of line {line}: these two can be met in either order", order, line);
        (line != pad.line).then(|| pad.problem("order", found, tr("a number of its own for each turn")))
    };
    level.draft.objectives.iter().filter_map(&mut warning).collect()
}

/// Objects to which neither the ship gets nor what it pushes. A link acts through rock.
fn unreached(level: &Checked) -> Vec<Problem> {
    let Draft { objects, links, .. } = level.draft;
    let bodies: Vec<CentredBox> = objects.iter().map(|object| (object.item.position, object.item.size * 0.5)).collect();
    let linked = |i: usize| {
        let name = objects[i].item.name.as_deref();
        name.is_some() && links.iter().any(|link| link.item.ends.iter().any(|end| end.object() == name))
    };
    let expected = tr("a route for the ship, or for an object that it can push");
    let warning = |i: usize| objects[i].problem("x", tr("an object that no one can reach"), expected);
    level.space.unreached(level.ship_box(), &bodies, linked).into_iter().map(warning).collect()
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
        || level.restitution() > 0.0;
    if ship.thrust >= weight || lifted || !draft.objectives.iter().any(above) {
        return Vec::new();
    }
    let found = tr!("{thrust} N, less than the ship's weight of {weight} N", thrust = ship.thrust, weight);
    vec![level.ship.problem("thrust", found, tr("more than that, as nothing in the level lifts the ship"))]
}

/// Plates that take more than all masses and the thrust together. A mover, a belt, a link, a wind, a zone or a liquid presses without such a bound.
fn heavy_plates(level: &Checked) -> Vec<Problem> {
    let (draft, ship) = (level.draft, &level.ship.item);
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

/// Speeds in m/s whose numbers are those of pixels.
fn like_pixels(level: &Checked) -> Vec<Problem> {
    let draft = level.draft;
    let metre = draft.scale.metre;
    let fastest = |mover: &types::Mover| mover.path.legs.iter().map(|leg| leg.velocity.length()).fold(0.0, f64::max);
    let movers = draft.movers.iter().flat_map(|row| [("speed", row.map(fastest)), ("belt", row.map(|mover| mover.solid.belt))]);
    let belts = draft.world.iter().map(|row| ("belt", row.map(|block| block.belt)));
    let winches = draft.links.iter().map(|row| ("rate", row.map(|link| link.rate)));
    let bodies = draft.objects.iter().map(|row| row.map(|body| body.velocity)).chain([level.ship.map(|ship| ship.velocity)]);
    let thrown = bodies.flat_map(|row| [("vx", row.map(|speed| speed.x)), ("vy", row.map(|speed| speed.y))]);
    let driven = movers.chain(belts).chain(winches).map(|speed| (speed, LIKE_PIXELS));
    let all = driven.chain(thrown.map(|speed| (speed, THROWN_LIKE_PIXELS)));
    let warning = |((column, row), _): ((&str, FromRow<f64>), f64)| {
        let (speed, pixels) = (fixed(row.item, 3), (row.item * metre).round());
        let found = tr!("{speed} m/s, which is {pixels} pixels a second", speed = trimmed(&speed), pixels);
        row.problem(column, found, tr!("m/s, one of which is {metre} pixels a second", metre))
    };
    all.filter(|((_, row), most)| row.item.abs() > *most).map(warning).collect()
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
    let Draft { objects, objectives, switches, .. } = level.draft;
    let pressing = switches.iter().any(|switch| switch.item.by == Presser::Key);
    let takes = |pad: &FromRow<Objective>, key| pad.item.kind == ObjectiveKind::Physics && pad.item.fits(key);
    let taken = |key| pressing || objectives.iter().any(|pad| takes(pad, key));
    let unused = objects.iter().filter(|object| object.item.key.is_some_and(|key| !taken(key)));
    let expected = tr("a PHYS row that it fits, or a row of objects.csv for what is no key");
    unused.map(|key| key.problem("kind", tr("a key object that no objective takes"), expected)).collect()
}

fn barred_pods(level: &Checked) -> Vec<Problem> {
    let barred = level.draft.pods.iter().filter(|pod| !level.space.gets_to(level.ship_box(), &pod.item.bounds));
    let expected = tr("a route to it, in the level and out of solids");
    barred.map(|pod| pod.problem("x", tr("a pod that the ship cannot get to"), expected)).collect()
}

/// Fragile blocks that withstand any blow of the level.
fn unbreakable(level: &Checked) -> Vec<Problem> {
    let fragile = level.draft.world.iter().filter_map(|block| Some((block, block.item.breaks?)));
    let Some(blow) = level.blow() else { return Vec::new() };
    let warning = |(block, breaks): (&FromRow<_>, f64)| {
        let found = tr!("{breaks} N·s, with blows of at most {blow} N·s in this level", breaks, blow = blow.ceil());
        block.problem("breaks", found, tr("less than that"))
    };
    fragile.filter(|(_, breaks)| *breaks > blow).map(warning).collect()
}

/// Pads to which nothing gets that fits, for its weight or its link.
fn unmet(level: &Checked) -> Vec<Problem> {
    level.draft.objectives.iter().filter_map(|pad| too_heavy(level, pad).or_else(|| tied(level, pad))).collect()
}

/// A pad for keys none of which moves that far, on the slipperiest ground of the level and with all that the other bodies can give.
fn too_heavy(level: &Checked, pad: &FromRow<Objective>) -> Option<Problem> {
    let draft = level.draft;
    if pad.item.kind != ObjectiveKind::Physics || draft.is_driven() || level.restitution() >= LIVELY {
        return None;
    }
    let mut keys = draft.objects.iter().enumerate().filter(|(_, object)| object.item.key.is_some_and(|key| pad.item.fits(key)));
    let (_, first) = keys.clone().next()?;
    let stuck = keys.all(|(index, key)| {
        let (weight, friction) = (key.item.mass * draft.settings.row.gravity, level.friction());
        let others: f64 = level.masses().enumerate().filter(|(body, _)| *body != index + 1).map(|(_, mass)| mass).sum();
        let Some(energy) = level.energy(Some(index)) else { return false };
        if key.item.weightless || key.item.velocity != DVec2::ZERO || 2.0 * level.ship.item.thrust > friction * weight {
            return false;
        }
        // The largest share of its energy that a light body hands to a heavy one in a blow.
        let share = 4.0 * others * key.item.mass / (others + key.item.mass).powi(2);
        let given = if others < key.item.mass { share * energy } else { energy };
        let far = MARGIN * given / weight * (1.0 / friction + 1.0);
        let falls = (2.0 * level.size.y / draft.settings.row.gravity * (draft.world.len() + draft.doors.len() + 1) as f64).sqrt();
        let reach = (far + (2.0 * given / key.item.mass).sqrt() * falls) / (1.0 - level.restitution()).powi(2);
        let own = Aabb::around(key.item.position, key.item.size * 0.5);
        let across = (own.min.x - pad.item.bounds.max.x).max(pad.item.bounds.min.x - own.max.x);
        across > reach || own.min.y - pad.item.bounds.max.y > reach
    });
    let mass = first.item.mass;
    let found = tr!("{mass} kg, which nothing in the level brings to the objective of line {line}", mass, line = pad.line);
    stuck.then(|| first.problem("mass", found, tr("a key that the ship can move so far")))
}

/// A pad whose bodies are all tied to places too far from it.
fn tied(level: &Checked, pad: &FromRow<Objective>) -> Option<Problem> {
    let Draft { links, objects, .. } = level.draft;
    let energy = level.energy(None)?;
    let tether = |(centre, half): CentredBox| {
        let near = grown(&pad.item.bounds, half);
        links.iter().find(|row| {
            let Some(LevelLink { def, .. }) = row.item.bind(objects) else { return false };
            let (LinkEnd::Place(place), LinkLaw::Rope(tie) | LinkLaw::Spring(tie)) = (def.to, def.law) else { return false };
            let length = if def.as_found { place.distance(centre) } else { tie.length };
            let over = place.clamp(near.min, near.max).distance(place) - length;
            let holds = level.centre(def.body) == centre && def.breaks.is_none() && !def.hook;
            holds && over > 0.0 && 0.5 * tie.stiffness * over * over > energy
        })
    };
    let goal = TouchGoal::from(&pad.item);
    let tethers = goal.bodies(level).map(tether).collect::<Option<Vec<_>>>()?;
    let found = tr!("a link too short for the objective of line {line}, for which nothing can stretch it", line = pad.line);
    Some(tethers.first()?.problem("length", found, tr("one that lets its body get there")))
}
