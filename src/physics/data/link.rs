//! Links as they begin: the numbers of their laws, and what they join. The laws themselves are forces.

use crate::physics::data::domain::{DefError, LARGEST, expect, number, vector};
use crate::physics::data::{Body, BodyId, Pose};
use glam::DVec2;

/// A linear spring; a rope has the same numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spring {
    /// Its length without a force, m.
    pub length: f64,
    /// N/m.
    pub stiffness: f64,
    /// N·s/m.
    pub damping: f64,
}

/// A pull that falls with the square of the distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Magnet {
    /// N·m²; below 0 it pushes.
    pub strength: f64,
    /// The distance of its largest force, m; a world takes half of both sizes, if that is more.
    pub nearest: f64,
}

/// The law of a link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LinkLaw {
    /// A linear spring, damped along its length.
    Spring(Spring),
    /// The same where it is longer than its length and pulls, else nothing.
    Rope(Spring),
    /// A pull or a push that falls with the square of the distance.
    Magnet(Magnet),
}

impl LinkLaw {
    /// The numbers that decide about its force.
    pub const fn numbers(&self) -> [f64; 3] {
        match *self {
            Self::Spring(spring) | Self::Rope(spring) => [spring.length, spring.stiffness, spring.damping],
            Self::Magnet(Magnet { strength, nearest }) => [strength, nearest, 0.0],
        }
    }

    /// Its length without a force, m.
    pub const fn length(&self) -> Option<f64> {
        match self {
            Self::Spring(spring) | Self::Rope(spring) => Some(spring.length),
            Self::Magnet(_) => None,
        }
    }

    pub(crate) const fn of_length(self, length: f64) -> Self {
        match self {
            Self::Spring(spring) => Self::Spring(Spring { length, ..spring }),
            Self::Rope(rope) => Self::Rope(Spring { length, ..rope }),
            Self::Magnet(_) => self,
        }
    }
}

/// The other end of a link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LinkEnd {
    /// The centre of a body.
    Body(BodyId),
    /// A place, m.
    Place(DVec2),
}

/// How a link begins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinkDef {
    /// Its first end is the centre of this body.
    pub body: BodyId,
    /// Its other end.
    pub to: LinkEnd,
    /// Its law.
    pub law: LinkLaw,
    /// Its length is the distance of its ends as it begins.
    pub as_found: bool,
    /// It begins when its ends touch.
    pub hook: bool,
    /// A larger force breaks it, N.
    pub breaks: Option<f64>,
    /// The growth of its length while it winds, m/s.
    pub rate: f64,
}

impl LinkDef {
    /// A link that acts from the start for ever.
    pub const fn new(body: BodyId, to: LinkEnd, law: LinkLaw) -> Self {
        Self { body, to, law, as_found: false, hook: false, breaks: None, rate: 0.0 }
    }

    pub(crate) const fn other(&self) -> Option<BodyId> {
        match self.to {
            LinkEnd::Body(body) => Some(body),
            LinkEnd::Place(_) => None,
        }
    }

    pub(crate) fn ends(&self) -> impl Iterator<Item = BodyId> {
        [Some(self.body), self.other()].into_iter().flatten()
    }

    pub(crate) fn has(&self, body: u32) -> bool {
        self.ends().any(|end| end.0 == body)
    }

    /// The way from the first end to the other one, m, and its rate, m/s.
    pub(crate) fn apart(&self, pose_of: impl Fn(u32) -> Pose) -> Pose {
        let (x, v) = pose_of(self.body.0);
        let (to, w) = match self.to {
            LinkEnd::Body(other) => pose_of(other.0),
            LinkEnd::Place(place) => (place, DVec2::ZERO),
        };
        (to - x, w - v)
    }

    /// Refuses a number that is not finite or negative; an end that is no body; a body that is linked to itself.
    pub(crate) fn check(&self, bodies: &[Body]) -> Result<(), DefError> {
        let least = if matches!(self.law, LinkLaw::Magnet(_)) { -LARGEST } else { 0.0 };
        self.law.numbers().into_iter().try_for_each(|value| number("a number of a link", value, least))?;
        number("the rate of a link", self.rate, -LARGEST)?;
        self.breaks.map_or(Ok(()), |breaks| number("the force that breaks a link", breaks, 0.0))?;
        if let LinkEnd::Place(place) = self.to {
            vector("the place of a link", place)?;
        }
        expect(self.other() != Some(self.body), || "a link leads from a body to itself".into())?;
        let there = self.ends().all(|end| end.index() < bodies.len());
        expect(there, || "a link leads to a body that there is not".into())
    }
}
