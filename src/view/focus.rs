//! The subject of the details: all bodies in view, one that is followed, or two that are compared; the zoom of the view, the length of the arrows.
//! A force's partner by Newton's third law, in words, with its place in the level where there is one; the Earth has none.

use super::facts::{ArrowKind, BodyFacts, FactRow, Value, by_whom, linked_to, quantity};
use crate::physics::{Aabb, BodyId, DVec2, LinkEnd, Source};
use crate::{game::Game, words::tr};

/// The most steps that arrows can be made longer or shorter by: a step is √2.
const MOST: i8 = 24;
/// The most steps that the view can be made closer or wider by: a step is the fourth root of 2.
const CLOSER: i8 = 8;
const WIDER: i8 = 20;

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Focus {
    pub followed: Option<BodyId>,
    pub compared: Option<BodyId>,
    longer: i8,
    closer: i8,
    fitted: bool,
}

impl Focus {
    /// The body, with everything that moves in view.
    pub fn fitted_on(body: BodyId) -> Self {
        Self { followed: Some(body), fitted: true, ..Self::default() }
    }

    #[must_use]
    pub const fn on_nobody(self) -> Self {
        Self { followed: None, compared: None, ..self }
    }

    /// Fits the view to everything that moves; a second time, at the usual zoom, follows again.
    pub const fn fit(&mut self) {
        (self.fitted, self.closer) = (!self.fitted || self.closer != 0, 0);
    }

    pub const fn fits(&self) -> bool {
        self.fitted
    }

    /// Brings the view closer by `by` factors of the fourth root of 2; negative: wider.
    pub fn zoom_by(&mut self, by: i8) {
        self.closer = (self.closer + by).clamp(-WIDER, CLOSER);
    }

    /// Scale of the picture, 1 usual.
    pub fn zoom(&self) -> f64 {
        2f64.powf(0.25 * f64::from(self.closer))
    }

    /// Whether a body has its box and its arrows: all have where none is followed.
    pub fn shows(&self, body: BodyId) -> bool {
        self.followed.is_none() || self.followed == Some(body) || self.compared == Some(body)
    }

    /// Cycles through `bodies` bodies: from all to `first`, through the others, and back to all.
    pub fn next(&mut self, first: BodyId, bodies: usize) {
        let next = self.followed.map_or(first.index(), |body| body.index() + 1);
        *self = Self { followed: u32::try_from(next).ok().filter(|_| next < bodies).map(BodyId), compared: None, ..*self };
    }

    /// Follows a body, or compares it with the followed one; clears the selection for `None` or a body already followed alone.
    pub fn pick(&mut self, body: Option<BodyId>, compare: bool) {
        *self = match (body, self.followed) {
            (Some(other), Some(followed)) if compare && other != followed => Self { compared: Some(other), ..*self },
            (body, followed) if body == followed && self.compared.is_none() => Self { followed: None, ..*self },
            (body, _) => Self { followed: body, compared: None, ..*self },
        };
    }

    /// Draws arrows longer or shorter by `by` factors of √2.
    pub fn lengthen(&mut self, by: i8) {
        self.longer = (self.longer + by).clamp(-MOST, MOST);
    }

    /// Scale of the arrows' length, 1 usual.
    pub fn length(&self) -> f64 {
        2f64.powf(0.5 * f64::from(self.longer))
    }
}

/// Half the size of the place that a link leads to, m.
const ANCHOR: f64 = 0.3;

#[derive(Clone, Debug, PartialEq)]
pub struct Partner {
    /// Subject, verb and object, with the size of the force or impact.
    pub words: Vec<String>,
    pub bodies: Vec<BodyId>,
    /// Places of other partners, m.
    pub places: Vec<Aabb>,
}

/// The partner of a line; none for a line that is no force or impact, or a sum of several.
pub fn partner(game: &Game, facts: &BodyFacts, row: &FactRow) -> Option<Partner> {
    let (shown, vector) = row.exerted()?;
    let back = FactRow::plain("", Value::Vector(-vector), row.unit);
    let (does, whom) = (tr(does(shown)), by_whom(game, facts.body, &row.causes));
    let words =
        [tr!("Third law: {body} {does} {whom}", body = facts.title, does, whom), tr!("with {force}", force = quantity(&back, 0))];
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

const fn does(shown: ArrowKind) -> &'static str {
    match shown {
        ArrowKind::Resultant => "acts on",
        ArrowKind::Impact => "knocks",
        ArrowKind::Force(kind) => kind.does(),
    }
}

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bodies_are_followed_one_after_the_other_and_compared_by_pairs() {
        let mut focus = Focus::default();
        let body = BodyId;
        assert!(focus.shows(body(0)) && focus.shows(body(7)));
        for (first, order) in
            [(0, [Some(body(0)), Some(body(1)), Some(body(2)), None]), (1, [Some(body(1)), Some(body(2)), None, Some(body(1))])]
        {
            focus = focus.on_nobody();
            for followed in order {
                focus.next(body(first), 3);
                assert_eq!(focus.followed, followed);
            }
        }
        focus = focus.on_nobody();
        focus.pick(Some(body(1)), true);
        assert_eq!((focus.followed, focus.compared), (Some(body(1)), None), "with nobody to compare it is followed");
        focus.pick(Some(body(2)), true);
        assert!(focus.shows(body(1)) && focus.shows(body(2)) && !focus.shows(body(0)));
        focus.pick(Some(body(2)), false);
        assert_eq!((focus.followed, focus.compared), (Some(body(2)), None));
        focus.pick(Some(body(2)), false);
        assert_eq!(focus, Focus::default());
    }

    #[test]
    fn the_view_is_zoomed_within_bounds_and_fitting_it_undoes_that() {
        let mut focus = Focus::fitted_on(BodyId(1));
        focus.zoom_by(4);
        assert!((focus.zoom() - 2.0).abs() < 1e-12 && focus.fits());
        (0..100).for_each(|_| focus.zoom_by(-1));
        assert!((focus.zoom() - 1.0 / 32.0).abs() < 1e-12);
        focus.fit();
        assert_eq!((focus.zoom(), focus.fits()), (1.0, true), "a zoomed view is fitted again");
        focus.fit();
        assert_eq!((focus.zoom(), focus.fits(), focus.followed), (1.0, false, Some(BodyId(1))));
    }

    #[test]
    fn arrows_grow_by_halves_of_a_doubling_and_not_for_ever() {
        let mut focus = Focus::default();
        focus.lengthen(2);
        assert!((focus.length() - 2.0).abs() < 1e-12);
        (0..100).for_each(|_| focus.lengthen(-1));
        assert!((focus.length() - 2f64.powi(-12)).abs() < 1e-12);
    }
}
