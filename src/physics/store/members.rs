//! One island in the numbers of the outside, for the methods that advance it.

use crate::physics::data::aabb::Aabb;
use crate::physics::store::bodies::Bodies;
use crate::physics::store::islands::Island;
use glam::DVec2;

/// What has become of an island.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Verdict {
    /// It is where it is at the end of the step; whether all of it rests.
    Taken { rests: bool },
    /// The crowd step shall take it.
    Left,
    /// Bodies may get further than others were looked for; their swept boxes have been widened.
    Grown,
}

/// An island in the numbers of the outside.
#[derive(Debug)]
pub(crate) struct Members<'a> {
    pub(crate) bodies: &'a mut Bodies,
    pub(crate) island: Island<'a>,
    pub(crate) grown: &'a mut Vec<u32>,
    pub(crate) down: f64,
}

impl Members<'_> {
    /// How many bodies it has.
    pub fn len(&self) -> usize {
        self.island.members.len()
    }

    /// Whether it is one body, near nothing.
    pub fn is_alone(&self) -> bool {
        self.island.is_alone()
    }

    /// Whether a body was brought to where others were looked for.
    pub fn is_swept(&self, body: u32) -> bool {
        self.bodies.is_swept(body as usize)
    }

    /// Its bodies, in no order that means anything.
    pub fn members(&self) -> impl Iterator<Item = u32> {
        self.island.members.iter().copied()
    }

    /// Appends the surfaces that they may meet, some more than once.
    pub fn surfaces(&self, into: &mut Vec<u32>) {
        let n = self.bodies.len() as u32;
        for slot in self.island.members {
            into.extend(self.island.near(*slot).iter().filter(|other| **other >= n).map(|other| other - n));
        }
    }

    /// Where others were looked for, m.
    pub fn swept(&self, body: u32) -> Aabb {
        let [left, right, top, bottom] = self.bodies.swept[body as usize];
        let (top, bottom) = if self.down < 0.0 { (-bottom, -top) } else { (top, bottom) };
        Aabb::new(DVec2::new(left, top), DVec2::new(right, bottom))
    }

    /// Brings a body to a place (m) and velocity (m/s) at the end of the step, or where it is left.
    pub fn bring(&mut self, body: u32, position: DVec2, velocity: DVec2) {
        let i = body as usize;
        (self.bodies.px[i], self.bodies.py[i]) = (position.x, position.y * self.down);
        (self.bodies.ux[i], self.bodies.uy[i]) = (velocity.x, velocity.y * self.down);
    }

    /// Widens where others are looked for by `reach` (m) to all sides; the islands are found anew then.
    pub fn widen(&mut self, body: u32, reach: DVec2) {
        let swept = &mut self.bodies.swept[body as usize];
        *swept = [swept[0] - reach.x, swept[1] + reach.x, swept[2] - reach.y, swept[3] + reach.y];
        self.grown.push(body);
    }
}
