//! Links: a force between two bodies, or between a body and a place. A law is a file of its own and a line in [`LinkLaw`].

use crate::physics::data::body::{Body, BodyId, Pose};
use crate::physics::data::domain::{DefError, vector};
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
    /// The other body, if there is one.
    pub(crate) fn other(&self) -> Option<BodyId> {
        match self.to {
            LinkEnd::Body(body) => Some(body),
            LinkEnd::Place(_) => None,
        }
    }

    /// The bodies at its ends.
    pub(crate) fn ends(&self) -> impl Iterator<Item = BodyId> {
        [Some(self.body), self.other()].into_iter().flatten()
    }

    /// Whether a body is one of its ends.
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
        let refused = |why: &str| Err(DefError(format!("a link {why}")));
        if !self.law.numbers().iter().all(|number| number.is_finite() && *number >= 0.0) {
            return refused("has a number that is negative or not finite");
        }
        if let LinkEnd::Place(place) = self.to {
            vector("the place of a link", place)?;
        }
        if self.other() == Some(self.body) {
            return refused("leads from a body to itself");
        }
        for end in self.ends() {
            let Some(body) = bodies.get(end.index()) else { return refused("leads to a body that there is not") };
            let all = links.iter().filter(|link| link.has(end.0)).chain([self]);
            let [stiffness, damping] = all.fold([0.0, 0.0], |[k, c], link| {
                let [more_k, more_c] = link.law.rates();
                [k + more_k, c + more_c]
            });
            if stiffness > MOST_STIFFNESS * body.mass || damping > MOST_DAMPING * body.mass {
                return refused(&format!(
                    "of {stiffness} N/m and {damping} N·s/m on {} kg, all of its links together, expected at most {MOST_STIFFNESS} N/m \
                     and {MOST_DAMPING} N·s/m per kg",
                    body.mass
                ));
            }
        }
        Ok(())
    }
}

/// The links of a world, by the order in which they were added.
#[derive(Clone, Debug, Default)]
pub(crate) struct Links {
    pub all: Vec<LinkDef>,
    /// Bodies that links join, directly or over others, ascending.
    pub groups: Vec<Vec<u32>>,
}

impl Links {
    /// Finds the groups.
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

/// The force of all links on a body, N.
pub(crate) fn links_on(links: &[LinkDef], body: u32, pose_of: impl Fn(u32) -> Pose) -> DVec2 {
    links.iter().filter(|link| link.has(body)).map(|link| link.on(body, &pose_of)).sum()
}
