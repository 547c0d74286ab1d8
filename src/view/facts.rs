//! The facts in a body's details box, read from the world's own state without computing them again. Their wording is elsewhere.

use crate::game::{Game, SHIP, body_title, plain_name};
use crate::physics::{BodyId, DVec2, ForceKind, ForceManager, Impulse, LinkEnd, Obstacle, Source};
use crate::words::tr;

/// Below this length (N) a force's direction is no more than rounding: the force stays by itself.
const SMALLEST_FORCE: f64 = 1e-9;
/// Two forces of a name with directions closer than this (sine of the angle) are one arrow and one line.
const SAME_DIRECTION: f64 = 1e-6;
/// A resultant below this part of the strongest force reads as none: a body that nears its terminal velocity.
const BALANCED: f64 = 1e-7;

/// Impacts that together change a body's velocity by less (m/s) are left out: a body at rest has many of them.
const SMALLEST_IMPACT: f64 = 1e-3;
const IMPULSE_UNIT: &str = "N·s";
/// The most impacts with lines and arrows of their own; the smaller ones share one line.
const IMPACTS: usize = 3;

/// The source of the colour of a line or an arrow.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ArrowKind {
    Resultant,
    Force(ForceKind),
    Impact,
}

impl ArrowKind {
    pub const fn is_impact(self) -> bool {
        matches!(self, Self::Impact)
    }

    /// Shown to the player.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Resultant => "Resultant",
            Self::Force(kind) => kind.shown(),
            Self::Impact => Impulse::NAME,
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    Scalar(f64),
    /// x and y.
    Vector(DVec2),
}

/// A line of a box.
#[derive(Clone, Debug, PartialEq)]
pub struct FactRow {
    /// The quantity.
    pub name: &'static str,
    /// The exerting body in words; empty where there is none, or for a sum.
    pub by: String,
    pub value: Value,
    /// Unit.
    pub unit: &'static str,
    /// The force or impact, where the line has a colour.
    pub shown: Option<ArrowKind>,
    /// The sources of the force.
    pub causes: Vec<Source>,
}

impl FactRow {
    /// A line without a source.
    pub const fn plain(name: &'static str, value: Value, unit: &'static str) -> Self {
        Self { name, by: String::new(), value, unit, shown: None, causes: Vec::new() }
    }

    /// As in "Normal force by floor".
    pub fn label(&self) -> String {
        let name = tr(self.name);
        if self.by.is_empty() { name.to_owned() } else { tr!("{name} by {body}", name, body = self.by) }
    }

    /// The line's force or impulse, where it has a source.
    pub fn exerted(&self) -> Option<(ArrowKind, DVec2)> {
        match (self.shown, self.value) {
            (Some(shown), Value::Vector(vector)) if !self.causes.is_empty() => Some((shown, vector)),
            _ => None,
        }
    }
}

#[derive(Clone, Debug, PartialEq)]
pub struct BodyFacts {
    pub body: BodyId,
    pub title: String,
    pub rows: Vec<FactRow>,
}

/// All facts about a body.
pub fn facts(game: &Game, id: BodyId) -> BodyFacts {
    let (world, ship) = (game.world(), id == SHIP);
    let (body, forces) = (world.body(id), world.forces(id));
    let mut rows = Vec::with_capacity(16);
    if ship {
        rows.push(FactRow::plain("Engine", Value::Scalar(game.level().player.thrust), "N"));
        // Along the nose positive, against it negative.
        let drive = forces.total(ForceKind::Drive).length() * if game.ship().burning < 0 { -1.0 } else { 1.0 };
        rows.push(FactRow::plain("Burning", Value::Scalar(drive), "N"));
    }
    rows.push(FactRow::plain("Mass", Value::Scalar(body.mass), "kg"));
    rows.push(FactRow::plain("Velocity", Value::Vector(body.velocity), "m/s"));
    let strongest = forces.forces().iter().map(|force| force.vector.length()).fold(0.0, f64::max);
    let told = |vector: DVec2, strongest: f64| if vector.length() < BALANCED * strongest { DVec2::ZERO } else { vector };
    rows.push(FactRow::plain("Acceleration", Value::Vector(told(body.acceleration, strongest / body.mass)), "m/s²"));
    let line = |shown: ArrowKind, vector, unit| FactRow {
        shown: Some(shown),
        ..FactRow::plain(shown.name(), Value::Vector(vector), unit)
    };
    rows.push(line(ArrowKind::Resultant, told(forces.resultant(), strongest), "N"));
    let exerted = |row: FactRow, causes: Vec<Source>| FactRow { by: by_whom(game, id, &causes), causes, ..row };
    let told = by_name(&forces).into_iter();
    rows.extend(told.map(|told| exerted(line(ArrowKind::Force(told.kind), told.vector, "N"), told.by)));
    let impacts = impacts(game, id);
    rows.extend(impacts.each.iter().map(|(impulse, by)| exerted(line(ArrowKind::Impact, *impulse, IMPULSE_UNIT), vec![*by])));
    if impacts.others.0 > 0 {
        let by = if impacts.others.0 == 1 {
            tr("a lesser one").to_owned()
        } else {
            tr!("{count} lesser ones", count = impacts.others.0)
        };
        rows.push(FactRow { by, ..line(ArrowKind::Impact, impacts.others.1, IMPULSE_UNIT) });
    }
    BodyFacts { body: id, title: body_title(game.level(), id), rows }
}

/// The impacts on a body: the largest ones, each with its source, and the number of the others with their sum (N·s).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ImpactsTold {
    /// The largest first.
    pub each: Vec<(DVec2, Source)>,
    /// Number and sum of all others.
    pub others: (usize, DVec2),
}

/// The impacts that can still be read.
pub fn impacts(game: &Game, id: BodyId) -> ImpactsTold {
    let mut told = ImpactsTold::default();
    let least = SMALLEST_IMPACT * game.world().body(id).mass;
    for felt in game.impacts(id) {
        if told.each.len() < IMPACTS && felt.impulse.length() >= least {
            told.each.push((felt.impulse, source(felt.by)));
        } else {
            told.others.0 += 1;
            told.others.1 += felt.impulse;
        }
    }
    if told.others.1.length() < least {
        told.others.0 = 0;
    }
    told
}

const fn source(obstacle: Obstacle) -> Source {
    match obstacle {
        Obstacle::Surface(index) => Source::Surface(index),
        Obstacle::Body(body) => Source::Body(body),
    }
}

/// The body at the other end of a link; `None` where that is a place.
pub fn linked_to(game: &Game, body: BodyId, link: u32) -> Option<BodyId> {
    let def = game.world().links().get(link as usize)?.def();
    match def.to {
        LinkEnd::Body(other) => Some(if def.body == body { other } else { def.body }),
        LinkEnd::Place(_) => None,
    }
}

/// The source of a force or an impact on a body in words: bodies by the titles of their boxes, also those at the other end of a link. Several
/// are counted.
pub fn by_whom(game: &Game, on: BodyId, causes: &[Source]) -> String {
    let all = |sort: fn(&Source) -> bool| causes.iter().all(sort);
    match causes {
        [] => String::new(),
        [Source::Body(body)] => body_title(game.level(), *body),
        [Source::Link(link)] => {
            let other = linked_to(game, on, *link).map(|other| body_title(game.level(), other));
            other.unwrap_or_else(|| tr!("anchor {number}", number = link + 1))
        }
        [one] => plain_name(game.level(), *one),
        many if all(|cause| matches!(cause, Source::Body(_))) => tr!("{count} objects", count = many.len()),
        many if all(|cause| matches!(cause, Source::Surface(_))) => tr!("{count} blocks", count = many.len()),
        many if all(|cause| matches!(cause, Source::Stream(_))) => tr!("{count} winds", count = many.len()),
        many if all(|cause| matches!(cause, Source::Fluid(_))) => tr!("{count} liquids", count = many.len()),
        many => tr!("{count} things", count = many.len()),
    }
}

#[derive(Clone, Debug, PartialEq)]
pub struct Told {
    pub kind: ForceKind,
    /// Sum, N.
    pub vector: DVec2,
    /// Each of their sources once.
    pub by: Vec<Source>,
}

/// The forces by name, in the usual order. Forces of one name that point the same way (the reactions of two floor tiles) are one;
/// those of one name that oppose each other stay apart, for their sum would hide the pressure.
pub fn by_name(forces: &ForceManager) -> Vec<Told> {
    let mut named: Vec<Told> = Vec::new();
    for kind in ForceKind::ALL {
        let first = named.len();
        for force in forces.forces().iter().filter(|force| force.kind == kind) {
            match named[first..].iter_mut().find(|told| same_way(told.vector, force.vector)) {
                Some(told) => {
                    told.vector += force.vector;
                    if !told.by.contains(&force.source) {
                        told.by.push(force.source);
                    }
                }
                None => named.push(Told { kind, vector: force.vector, by: vec![force.source] }),
            }
        }
    }
    named
}

fn same_way(a: DVec2, b: DVec2) -> bool {
    let lengths = a.length() * b.length();
    a.length().min(b.length()) < SMALLEST_FORCE || a.dot(b) > 0.0 && a.perp_dot(b).abs() <= SAME_DIRECTION * lengths
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_forces_that_point_the_same_way_are_one() {
        assert!(same_way(DVec2::new(0.0, -3.0), DVec2::new(0.0, -5.0)));
        assert!(!same_way(DVec2::new(0.0, -3.0), DVec2::new(0.0, 5.0)));
        assert!(!same_way(DVec2::new(0.0, -3.0), DVec2::new(2.0, 0.0)));
    }
}
