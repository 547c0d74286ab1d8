//! What the details box of a body says: read off the world's own state, nothing computed anew. How it is written is not here.

use crate::game::{Game, SHIP, body_title, obstacle_name};
use crate::physics::{BodyId, DVec2, ForceKind, ForceManager, Impulse, Obstacle};

/// Below this length (N) a force's direction is no more than rounding: it is kept by itself.
const SMALLEST_FORCE: f64 = 1e-9;
/// Two forces of a name with directions closer than this (sine of the angle) are one arrow and one line.
const SAME_DIRECTION: f64 = 1e-6;

/// An impact that passed on less (N·s) is not told: it would read 0.0.
const SMALLEST_IMPACT: f64 = 0.05;
const IMPULSE_UNIT: &str = "N·s";
/// How many impacts have lines and an arrow of their own; those that were smaller are told together.
const IMPACTS: usize = 3;

/// What a line or an arrow stands for, if it has a colour of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shown {
    /// The resultant force.
    Resultant,
    /// A force of that kind.
    Force(ForceKind),
    /// An impact.
    Impact,
}

impl Shown {
    /// The name shown to the player.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Resultant => "Resultant",
            Self::Force(kind) => kind.name(),
            Self::Impact => Impulse::NAME,
        }
    }
}

/// A quantity as it is shown.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A number.
    Scalar(f64),
    /// Its x and y components.
    Vector(DVec2),
    /// No number: what exerted the impact above.
    Words(String),
}

/// One line of a box.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// What it is.
    pub name: &'static str,
    /// How much.
    pub value: Value,
    /// In what.
    pub unit: &'static str,
    /// What it tells of, if that has a colour.
    pub shown: Option<Shown>,
}

/// A box's heading and lines.
#[derive(Clone, Debug, PartialEq)]
pub struct Facts {
    /// The name of the body.
    pub title: String,
    /// Its lines, from the top.
    pub rows: Vec<Row>,
}

/// All there is to say about a body.
pub fn facts(game: &Game, id: BodyId) -> Facts {
    let (world, ship) = (game.world(), id == SHIP);
    let (body, forces) = (world.body(id), world.forces(id));
    let row = |name, value, unit| Row { name, value, unit, shown: None };
    let mut rows = Vec::with_capacity(16);
    if ship {
        // Along the nose positive, against it negative.
        let drive = forces.total(ForceKind::Drive).length() * if game.ship().burning < 0 { -1.0 } else { 1.0 };
        rows.push(row("Engine drive", Value::Scalar(drive), "N"));
    }
    rows.push(row("Mass", Value::Scalar(body.mass), "kg"));
    rows.push(row("Velocity", Value::Vector(body.velocity), "m/s"));
    rows.push(row("Acceleration", Value::Vector(body.acceleration), "m/s²"));
    let line = |shown: Shown, vector, unit| Row { name: shown.name(), value: Value::Vector(vector), unit, shown: Some(shown) };
    rows.push(line(Shown::Resultant, forces.resultant(), "N"));
    rows.extend(by_name(&forces).into_iter().map(|(kind, vector)| line(Shown::Force(kind), vector, "N")));
    let impacts = impacts(game, id);
    for (impulse, by) in &impacts.each {
        rows.push(line(Shown::Impact, *impulse, IMPULSE_UNIT));
        rows.push(row("", Value::Words(format!("by {}", by_whom(game, *by))), ""));
    }
    if impacts.others.0 > 0 {
        rows.push(line(Shown::Impact, impacts.others.1, IMPULSE_UNIT));
        let ones = if impacts.others.0 == 1 { "a smaller one".to_owned() } else { format!("{} smaller ones", impacts.others.0) };
        rows.push(row("", Value::Words(ones), ""));
    }
    Facts { title: body_title(game.level(), id), rows }
}

/// The impacts on a body that are told: the largest ones, each with what exerted it, and how many more there were, with their sum (N·s).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ImpactsTold {
    /// The largest first.
    pub each: Vec<(DVec2, Obstacle)>,
    /// All others.
    pub others: (usize, DVec2),
}

/// What is told of the impacts that can still be read.
pub fn impacts(game: &Game, id: BodyId) -> ImpactsTold {
    let mut told = ImpactsTold::default();
    for felt in game.impacts(id).into_iter().filter(|felt| felt.impulse.length() >= SMALLEST_IMPACT) {
        if told.each.len() < IMPACTS {
            told.each.push((felt.impulse, felt.by));
        } else {
            told.others.0 += 1;
            told.others.1 += felt.impulse;
        }
    }
    told
}

/// What exerted an impact: bodies by the titles of their boxes, all else as the level's files count it.
fn by_whom(game: &Game, by: Obstacle) -> String {
    match by {
        Obstacle::Body(body) => body_title(game.level(), body),
        Obstacle::Surface(_) => obstacle_name(game.level(), by),
    }
}

impl Facts {
    /// The short form, for when there is no room: heading and resultant.
    pub fn short(&self) -> Self {
        let rows = self.rows.iter().filter(|row| row.shown == Some(Shown::Resultant));
        Self { title: self.title.clone(), rows: rows.cloned().collect() }
    }
}

/// The forces by name, in the usual order. Forces of one name that point the same way (the reactions of two floor tiles) are one;
/// those of one name that oppose each other stay apart, for together they would hide what presses.
pub fn by_name(forces: &ForceManager) -> Vec<(ForceKind, DVec2)> {
    let mut named: Vec<(ForceKind, DVec2)> = Vec::new();
    for kind in ForceKind::ALL {
        let first = named.len();
        for force in forces.forces().iter().filter(|force| force.kind == kind) {
            match named[first..].iter_mut().find(|(_, sum)| same_way(*sum, force.vector)) {
                Some((_, sum)) => *sum += force.vector,
                None => named.push((kind, force.vector)),
            }
        }
    }
    named
}

fn same_way(a: DVec2, b: DVec2) -> bool {
    let lengths = a.length() * b.length();
    a.length().min(b.length()) < SMALLEST_FORCE || a.dot(b) > 0.0 && a.perp_dot(b).abs() <= SAME_DIRECTION * lengths
}

/// A figure for authors, to one decimal place with a true minus sign; what rounds to zero has no sign.
pub fn number(value: f64) -> String {
    let plain = format!("{value:.1}");
    match plain.strip_prefix('-') {
        Some("0.0") => "0.0".to_owned(),
        Some(size) => format!("−{size}"),
        None => plain,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_one_decimal_and_a_true_minus_sign() {
        assert_eq!(number(1500.0), "1500.0");
        assert_eq!(number(-731.25), "−731.2");
        assert_eq!(number(-0.04), "0.0");
        assert_eq!(number(-0.0), "0.0");
        assert_eq!(number(-0.06), "−0.1");
    }

    #[test]
    fn only_forces_that_point_the_same_way_are_one() {
        assert!(same_way(DVec2::new(0.0, -3.0), DVec2::new(0.0, -5.0)));
        assert!(!same_way(DVec2::new(0.0, -3.0), DVec2::new(0.0, 5.0)));
        assert!(!same_way(DVec2::new(0.0, -3.0), DVec2::new(2.0, 0.0)));
    }
}
