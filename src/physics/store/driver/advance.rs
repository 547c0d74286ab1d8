//! Who else may advance an island, and what it sees of it.

use crate::physics::data::aabb::Aabb;
use crate::physics::store::bodies::Bodies;
use crate::physics::store::driver::Target;
use crate::physics::store::driver::later::Placed;
use crate::physics::store::islands::Island;
use glam::DVec2;

/// Who may advance an island before the dense method does.
pub(crate) trait Advance {
    /// Whether a body that is near nothing has to be advanced all the same: it stands still, and may fall asleep.
    fn minds(&self, body: usize) -> bool;

    /// Whether no body has to be advanced for that.
    fn minds_nobody(&self) -> bool;

    /// Takes an island, or leaves it. `round` is how often it has grown in this step.
    fn advance(&mut self, store: &mut Store<'_>, round: usize) -> Verdict;

    /// Whether the contacts of an island of this many bodies are listed.
    fn lists(&self, members: usize) -> bool;

    /// Whether an island of so many bodies is left to the dense method for good: then it falls asleep as that leaves it.
    fn leaves_for_good(&self, members: usize) -> bool;

    /// What it told of the island of this body holds no longer.
    fn forget(&mut self, body: usize);

    /// A surface stands for the whole step, which is advanced from its start again.
    fn stand(&mut self, surface: usize);

    /// Bodies whose islands have to be advanced again, because others have come to something that concerns them.
    fn disagree(&mut self, bodies: &mut Vec<u32>);
}

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

/// An island, for whoever takes it, in the numbers of the outside.
#[derive(Debug)]
pub(crate) struct Store<'a> {
    pub(crate) bodies: &'a mut Bodies,
    pub(crate) island: Island<'a>,
    pub(crate) grown: &'a mut Vec<u32>,
    pub(crate) placed: &'a mut Vec<Placed>,
    pub(crate) targets: &'a [Target],
    pub(crate) down: f64,
}

impl Store<'_> {
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
        self.bodies.is_swept(self.bodies.slot[body as usize] as usize)
    }

    /// Its bodies, in no order that means anything.
    pub fn members(&self) -> impl Iterator<Item = u32> {
        self.island.members.iter().map(|slot| self.bodies.id[*slot as usize])
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
        let [left, right, top, bottom] = self.bodies.swept[self.bodies.slot[body as usize] as usize];
        let (top, bottom) = if self.down < 0.0 { (-bottom, -top) } else { (top, bottom) };
        Aabb::new(DVec2::new(left, top), DVec2::new(right, bottom))
    }

    /// Brings a body to a place (m) and velocity (m/s) at the end of the step, or where it is left.
    pub fn bring(&mut self, body: u32, position: DVec2, velocity: DVec2) {
        let i = self.bodies.slot[body as usize] as usize;
        (self.bodies.px[i], self.bodies.py[i]) = (position.x, position.y * self.down);
        (self.bodies.ux[i], self.bodies.uy[i]) = (velocity.x, velocity.y * self.down);
    }

    /// Tells where a surface is (m) and how fast it moves (m/s) when the island is left; and where it stops after that, if it does so before the
    /// step ends.
    pub fn place_surface(&mut self, surface: u32, (position, velocity): (DVec2, DVec2), stops: Option<DVec2>) {
        let turned = DVec2::new(1.0, self.down);
        let stops = stops.map(|at| at * turned);
        self.placed.push(Placed { surface, position: position * turned, velocity: velocity * turned, stops });
    }

    /// Appends the surfaces that move in this step and that they may meet, some more than once.
    pub fn moving_surfaces(&self, into: &mut Vec<u32>) {
        let n = self.bodies.len() as u32;
        for slot in self.island.members.iter().filter(|_| !self.targets.is_empty()) {
            let surfaces = self.island.near(*slot).iter().filter(|other| **other >= n).map(|other| other - n);
            into.extend(surfaces.filter(|surface| self.targets.iter().any(|target| target.surface == *surface)));
        }
    }

    /// Widens where others are looked for by `reach` (m) to all sides; the islands are found anew then.
    pub fn widen(&mut self, body: u32, reach: DVec2) {
        let slot = self.bodies.slot[body as usize];
        let swept = &mut self.bodies.swept[slot as usize];
        *swept = [swept[0] - reach.x, swept[1] + reach.x, swept[2] - reach.y, swept[3] + reach.y];
        self.grown.push(slot);
    }
}
