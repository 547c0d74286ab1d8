//! The other half of a force: by Newton's third law, whoever exerts it feels the same one the other way. In words, and where it can be
//! seen; also where who feels it is no part of the level, as the Earth.

use super::facts::{ArrowKind, BodyFacts, FactRow, Value, by_whom};
use super::quantity::quantity;
use crate::game::Game;
use crate::physics::{Aabb, BodyId, Source};

/// What a force or an impact on a body has for its partner.
#[derive(Clone, Debug, PartialEq)]
pub struct Partner {
    /// Who does what to whom, and how much of it.
    pub words: Vec<String>,
    /// The bodies that feel it.
    pub bodies: Vec<BodyId>,
    /// What else does, m.
    pub places: Vec<Aabb>,
}

/// The partner of what a line tells of; none where that is no force and no impact, or a sum of several.
pub fn partner(game: &Game, facts: &BodyFacts, row: &FactRow) -> Option<Partner> {
    let (shown, vector) = row.exerted()?;
    let back = FactRow::plain("", Value::Vector(-vector), row.unit);
    let words = [
        format!("Third law: {} {} {}", facts.title, does(shown), by_whom(game, &row.causes)),
        format!("with {}", quantity(&back, &[], 0)),
    ];
    let bodies = row.causes.iter().filter_map(|cause| match cause {
        Source::Body(body) => Some(*body),
        _ => None,
    });
    let places = row.causes.iter().filter_map(|cause| place(game, *cause));
    Some(Partner { words: words.into(), bodies: bodies.collect(), places: places.collect() })
}

/// Which line of another body's box tells of the partner of what `shown` is for that body.
pub fn answer(other: &BodyFacts, shown: ArrowKind, body: BodyId) -> Option<usize> {
    other.rows.iter().position(|row| row.shown == Some(shown) && row.causes.contains(&Source::Body(body)))
}

/// What a body does to whoever exerts that on it.
const fn does(shown: ArrowKind) -> &'static str {
    match shown {
        ArrowKind::Resultant => "acts on",
        ArrowKind::Impact => "knocks",
        ArrowKind::Force(kind) => kind.does(),
    }
}

/// Where what exerts a force is, if it has a place and is no body.
fn place(game: &Game, cause: Source) -> Option<Aabb> {
    let level = game.level();
    match cause {
        Source::Surface(index) => game.world().surfaces().get(index as usize).map(|surface| surface.bounds),
        Source::Stream(index) => level.streams.get(index as usize).map(|stream| stream.source),
        Source::Fluid(index) => level.fluids.get(index as usize).map(|fluid| fluid.zone),
        Source::Field(index) => level.fields.get(index as usize).map(|field| field.zone),
        Source::Gravity | Source::Engine | Source::Air | Source::Body(_) | Source::Link(_) => None,
    }
}
