//! What is wrong with the links of a level, beyond the form of their rows; and forces too strong for the masses on which they act.

use super::problem::{MOST_PROBLEMS, Problem, at_most, meant, quoted};
use super::types::{LevelLink, SHIP_HALF, ShipStart};
use super::{draft::Draft, schema::blocks::MOST_LINKS, schema::typed::FromRow, schema::values::LinkRowEnd};
use crate::physics::domain::{MOST_ACCELERATION, MOST_DAMPING, MOST_STIFFNESS};
use crate::physics::{BodyId, DVec2, LinkDef, LinkEnd, LinkLaw};
use crate::words::tr;

/// Ends that are no body, names that two bodies share, links without a body, and links too stiff or too strong for one.
pub(super) fn check(draft: &Draft) -> Vec<Problem> {
    let mut problems = Vec::new();
    let beyond = draft.links.iter().skip(MOST_LINKS).take(MOST_PROBLEMS);
    let found = tr!("{count} links", count = draft.links.len());
    problems.extend(beyond.map(|link| link.problem("a", found.clone(), at_most(MOST_LINKS))));
    let names: Vec<&str> = draft.objects.iter().filter_map(|object| object.item.name.as_deref()).collect();
    let mut loads = vec![(0.0, 0.0); draft.objects.len() + 1];
    let ship = |ship: &FromRow<ShipStart>| (ship.item.mass, SHIP_HALF);
    let body = |body: BodyId| match body.index().checked_sub(1) {
        None => draft.player.as_ref().map(ship),
        Some(object) => draft.objects.get(object).map(|object| (object.item.mass, object.item.size * 0.5)),
    };
    for link in draft.links.iter().take(MOST_LINKS) {
        let before = problems.len();
        for (column, end) in ["a", "b"].into_iter().zip(&link.item.ends) {
            if *end == LinkRowEnd::Ship && draft.settings.is_experiment() {
                problems.push(link.problem(column, quoted("ship"), tr("an object or a place: an experiment has no ship")));
            }
            let LinkRowEnd::Object(name) = end else { continue };
            let expected = match names.iter().filter(|known| *known == name).count() {
                0 => {
                    let meant = meant(name, names.iter().copied().chain(["ship"]));
                    tr("ship, the name of an object, or a place x y").to_owned() + &meant
                }
                1 => continue,
                many => tr!("the name of one object; {count} have that one", count = many),
            };
            problems.push(link.problem(column, quoted(name), expected));
        }
        let bound = link.item.bind(&draft.objects);
        match &bound {
            None if problems.len() == before => {
                problems.push(link.problem("b", tr("a second place"), tr("a body at one end at least")))
            }
            Some(LevelLink { def, .. }) if def.to == LinkEnd::Body(def.body) => {
                problems.push(link.problem("b", tr("the same body as at the other end"), tr("another body, or a place")));
            }
            Some(LevelLink { def, .. }) => {
                let too_much = load(def, &mut loads, body);
                problems.extend(too_much.map(|TooMuch { column, found, expected, .. }| link.problem(column, found, expected)));
            }
            None => {}
        }
    }
    problems.truncate(MOST_PROBLEMS);
    problems
}

/// A number of a link that is too large for a body.
pub(super) struct TooMuch {
    pub body: BodyId,
    pub column: &'static str,
    pub found: String,
    pub expected: String,
}

/// The first of a link; `body` gives masses (kg) and halves (m), and `loads` sums stiffness and damping by body.
pub(super) fn load(def: &LinkDef, loads: &mut [(f64, f64)], body: impl Fn(BodyId) -> Option<(f64, DVec2)>) -> Option<TooMuch> {
    let other = if let LinkEnd::Body(body) = def.to { Some(body) } else { None };
    let ends: Vec<BodyId> = other.into_iter().chain([def.body]).collect();
    let nearest: f64 = ends.iter().filter_map(|end| body(*end)).map(|(_, half)| half.element_sum() * 0.5).sum();
    for end in ends {
        let (Some((mass, _)), (stiffness, damping)) = (body(end), &mut loads[end.index()]) else { continue };
        match def.law {
            LinkLaw::Spring(spring) | LinkLaw::Rope(spring) => {
                *stiffness += spring.stiffness;
                *damping += spring.damping;
                for (column, sum, most, unit) in
                    [("stiffness", *stiffness, MOST_STIFFNESS * mass, "N/m"), ("damping", *damping, MOST_DAMPING * mass, "N·s/m")]
                {
                    if sum > most {
                        let found = tr!("{sum} {unit} on {mass} kg, all links up to this one", sum, unit, mass);
                        return Some(TooMuch { body: end, column, found, expected: tr!("at most {most} {unit}", most, unit) });
                    }
                }
            }
            LinkLaw::Magnet(magnet) => {
                let force = magnet.strength / (nearest * nearest);
                if let Some(expected) = judge(force, mass) {
                    let found = tr!("{force} N on {mass} kg at {nearest} m, the nearest", force, mass, nearest);
                    return Some(TooMuch { body: end, column: "strength", found, expected });
                }
            }
        }
    }
    None
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
    problems.extend(draft.player.iter().filter_map(|ship| {
        let ShipStart { thrust, mass, .. } = ship.item;
        Some(ship.problem("thrust", tr!("{thrust} N on a ship of {mass} kg", thrust, mass), judge(thrust, mass)?))
    }));
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
