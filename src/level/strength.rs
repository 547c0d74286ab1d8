//! Forces and the masses on which they act: what is too strong is refused, and what is certainly too weak is warned about.

use super::draft::Draft;
use super::placed::FromRow;
use super::problem::Problem;
use super::types::{Objective, ObjectiveKind, SHIP_HALF, ShipStart, Switch};
use crate::physics::Material;
use crate::physics::domain::MOST_ACCELERATION;
use crate::words::tr;

/// The expected force, where one exceeds the limit for a body of that mass.
pub(super) fn judge(force: f64, mass: f64) -> Option<String> {
    (force.abs() > MOST_ACCELERATION * mass).then(|| {
        tr!("at most {most} N, which is {acceleration} m/s²", most = MOST_ACCELERATION * mass, acceleration = MOST_ACCELERATION)
    })
}

/// The ship, where its thrust is too strong for it, and every stream that is too strong for the lightest body.
pub(super) fn check(draft: &Draft) -> Vec<Problem> {
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
    for fluid in draft.fluids.iter().filter(|_| draft.settings.gravity_x != 0.0) {
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
pub(super) fn warn(draft: &Draft, player: &FromRow<ShipStart>) -> Vec<Problem> {
    weak_engine(draft, player).into_iter().chain(heavy_plates(draft, &player.item)).collect()
}

/// Thrust below the ship's weight, where an objective lies above the start and nothing else moves any body upwards.
fn weak_engine(draft: &Draft, player: &FromRow<ShipStart>) -> Option<Problem> {
    let (ship, settings) = (&player.item, &draft.settings);
    let weight = ship.mass * settings.gravity;
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
    if draft.is_driven() || draft.has_currents() || draft.settings.gravity_x != 0.0 {
        return Vec::new();
    }
    let objects = draft.objects.iter().filter(|object| !object.item.weightless).map(|object| object.item.mass);
    let most = ship.thrust + (ship.mass + objects.sum::<f64>()) * draft.settings.gravity.max(0.0);
    let heavy = |plate: &FromRow<Switch>| {
        let weight = plate.item.weight.filter(|weight| most <= *weight)?;
        let found =
            tr!("{weight} N, with {most} N of weight and thrust in all to press it", weight, most = format_args!("{most:.0}"));
        Some(plate.problem("weight", found, tr("less than that")))
    };
    draft.switches.iter().filter_map(heavy).collect()
}
