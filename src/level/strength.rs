//! Forces that are too strong for the masses on which they act: limits of two cells together.

use super::draft::Draft;
use super::problem::Problem;
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
