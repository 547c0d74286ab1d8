//! The partner of a force: by Newton's third law, the body that exerts it feels the opposite one. In words, and with its place in
//! the level where there is one; the Earth has none.

use super::facts::{ArrowKind, BodyFacts, FactRow, Value, by_whom, linked_to};
use super::quantity::quantity;
use crate::game::Game;
use crate::physics::{Aabb, BodyId, DVec2, LinkEnd, Source};
use crate::words::tr;

/// Half the size of the place that a link leads to, m.
const ANCHOR: f64 = 0.3;

/// The partner of a force or an impact on a body.
#[derive(Clone, Debug, PartialEq)]
pub struct Partner {
    /// Subject, verb and object, with the size of the force or impact.
    pub words: Vec<String>,
    /// The bodies that feel it.
    pub bodies: Vec<BodyId>,
    /// Places of other partners, m.
    pub places: Vec<Aabb>,
}

/// The partner of a line; none for a line that is no force or impact, or a sum of several.
pub fn partner(game: &Game, facts: &BodyFacts, row: &FactRow) -> Option<Partner> {
    let (shown, vector) = row.exerted()?;
    let back = FactRow::plain("", Value::Vector(-vector), row.unit);
    let words = [
        tr!(
            "Third law: {body} {does} {whom}",
            body = facts.title,
            does = tr(does(shown)),
            whom = by_whom(game, facts.body, &row.causes)
        ),
        tr!("with {force}", force = quantity(&back, 0)),
    ];
    let bodies = row.causes.iter().filter_map(|cause| match cause {
        Source::Body(body) => Some(*body),
        Source::Link(link) => linked_to(game, facts.body, *link),
        _ => None,
    });
    let places = row.causes.iter().filter_map(|cause| place(game, *cause));
    Some(Partner { words: words.into(), bodies: bodies.collect(), places: places.collect() })
}

/// The line of another body's box that is the partner of `shown` on `body`, by these `causes`.
pub fn answer(other: &BodyFacts, shown: ArrowKind, body: BodyId, causes: &[Source]) -> Option<usize> {
    let answers = |cause: &Source| match cause {
        Source::Link(_) => causes.contains(cause),
        _ => *cause == Source::Body(body),
    };
    other.rows.iter().position(|row| row.shown == Some(shown) && row.causes.iter().any(answers))
}

/// The verb of the partner: what the body does to the source.
const fn does(shown: ArrowKind) -> &'static str {
    match shown {
        ArrowKind::Resultant => "acts on",
        ArrowKind::Impact => "knocks",
        ArrowKind::Force(kind) => kind.does(),
    }
}

/// The place of a source, if it has one and is no body.
fn place(game: &Game, cause: Source) -> Option<Aabb> {
    let level = game.level();
    match cause {
        Source::Surface(index) => game.world().surfaces().get(index as usize).map(|surface| surface.bounds),
        Source::Stream(index) => level.streams.get(index as usize).map(|stream| stream.source),
        Source::Fluid(index) => level.fluids.get(index as usize).map(|fluid| fluid.zone),
        Source::Field(index) => level.fields.get(index as usize).map(|field| field.zone),
        Source::Link(link) => match game.world().links().get(link as usize)?.def().to {
            LinkEnd::Place(place) => Some(Aabb::around(place, DVec2::splat(ANCHOR))),
            LinkEnd::Body(_) => None,
        },
        Source::Gravity | Source::Engine | Source::Air | Source::Body(_) => None,
    }
}
