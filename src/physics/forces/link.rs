//! Links: a force between two bodies, or a body and a place. A law is a file of its own and a line in [`LinkLaw`].

use crate::physics::data::domain::{DefError, expect, vector};
use crate::physics::data::{Body, BodyId, Pose};
use crate::physics::forces::kind::ForceKind;
use glam::DVec2;

mod spring;

pub use spring::Spring;

/// 1/s² and 1/s: the most stiffness and damping per mass that the links of a body may come to. More: a tick takes thousands of steps.
const MOST_STIFFNESS: f64 = 1e8;
const MOST_DAMPING: f64 = 1e4;

/// The law of a link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LinkLaw {
    /// A linear spring, damped along its length.
    Spring(Spring),
}

impl LinkLaw {
    /// The force on the first end, N; `apart` (m) leads from it to the other end, `parting` (m/s) is the rate of that.
    pub(crate) fn force(&self, apart: DVec2, parting: DVec2) -> DVec2 {
        match self {
            Self::Spring(spring) => spring.force(apart, parting),
        }
    }

    /// The kind under which its force is listed.
    pub const fn kind(&self) -> ForceKind {
        match self {
            Self::Spring(_) => ForceKind::Spring,
        }
    }

    /// Its numbers: they are finite and at least 0.
    pub(crate) fn numbers(&self) -> [f64; 3] {
        match *self {
            Self::Spring(Spring { length, stiffness, damping }) => [length, stiffness, damping],
        }
    }

    /// Its greatest stiffness, N/m, and damping, N·s/m.
    fn rates(&self) -> [f64; 2] {
        match self {
            Self::Spring(spring) => [spring.stiffness, spring.damping],
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

/// A link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinkDef {
    /// Its first end is the centre of this body.
    pub body: BodyId,
    /// Its other end.
    pub to: LinkEnd,
    /// Its law.
    pub law: LinkLaw,
}

impl LinkDef {
    pub(crate) fn other(&self) -> Option<BodyId> {
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

    /// The force on one of its bodies, N.
    pub(crate) fn on(&self, body: u32, pose_of: impl Fn(u32) -> Pose) -> DVec2 {
        let (x, v) = pose_of(self.body.0);
        let (to, w) = match self.to {
            LinkEnd::Body(other) => pose_of(other.0),
            LinkEnd::Place(place) => (place, DVec2::ZERO),
        };
        let force = self.law.force(to - x, w - v);
        if self.body.0 == body { force } else { -force }
    }

    /// # Errors
    /// A number that is not finite or negative; an end that is no body; a body that is linked to itself; links too stiff for a body.
    pub(crate) fn check(&self, bodies: &[Body], links: &[LinkDef]) -> Result<(), DefError> {
        let numbers = self.law.numbers();
        let good = numbers.iter().all(|number| number.is_finite() && *number >= 0.0);
        expect(good, || "a link has a number that is negative or not finite".into())?;
        if let LinkEnd::Place(place) = self.to {
            vector("the place of a link", place)?;
        }
        expect(self.other() != Some(self.body), || "a link leads from a body to itself".into())?;
        for end in self.ends() {
            let body = bodies.get(end.index()).ok_or_else(|| DefError("a link leads to a body that there is not".into()))?;
            let all = || links.iter().filter(|link| link.has(end.0)).chain([self]).map(|link| link.law.rates());
            let (stiffness, damping): (f64, f64) = (all().map(|of| of[0]).sum(), all().map(|of| of[1]).sum());
            let soft = stiffness <= MOST_STIFFNESS * body.mass && damping <= MOST_DAMPING * body.mass;
            expect(soft, || {
                format!(
                    "a link of {stiffness} N/m and {damping} N·s/m on {} kg, all of its links together, expected at most \
                     {MOST_STIFFNESS} N/m and {MOST_DAMPING} N·s/m per kg",
                    body.mass
                )
            })?;
        }
        Ok(())
    }
}

#[derive(Clone, Debug, Default)]
pub(crate) struct Links {
    pub all: Vec<LinkDef>,
    /// Bodies that links join, directly or over others, ascending.
    pub groups: Vec<Vec<u32>>,
}

impl Links {
    pub fn gather(&mut self) {
        self.groups.clear();
        for link in &self.all {
            let mut joined: Vec<u32> = link.ends().map(|body| body.0).collect();
            self.groups.retain(|group| {
                let apart = !group.iter().any(|body| joined.contains(body));
                if !apart {
                    joined.extend(group);
                }
                apart
            });
            joined.sort_unstable();
            joined.dedup();
            self.groups.push(joined);
        }
    }
}

pub(crate) fn links_on(links: &[LinkDef], body: u32, pose_of: impl Fn(u32) -> Pose) -> DVec2 {
    links.iter().filter(|link| link.has(body)).map(|link| link.on(body, &pose_of)).sum()
}
