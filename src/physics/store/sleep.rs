//! Sleep: islands that a step left unchanged, until something changes or comes near.
//!
//! A body that has slept through a whole step is set aside until something wakes it, or a swept box reaches its own (`rouse`). Its box and free
//! flight of the step before still hold, so no bit depends on that.

use crate::physics::data::{Aabb, body::Body};
use crate::physics::store::{grid::CellGrid, islands::Island, motions::Motions};
use glam::DVec2;

/// No body is set aside while more than this part of them has to be looked at: their neighbours are looked up one by one.
const MOST_LOOKED_AT: f64 = 0.25;

#[derive(Clone, Debug)]
pub(crate) struct Sleep {
    pub asleep: Vec<bool>,
    pub sleepers: usize,
    /// The bodies that a step looks at; the others are `aside`.
    pub looked_at: Vec<u32>,
    aside: Vec<bool>,
    /// What the bodies set aside sweep.
    boxes: CellGrid,
    reached: Vec<u32>,
    /// The last step has left its island asleep.
    undisturbed: Vec<bool>,
}

impl Sleep {
    pub fn new(count: usize, cells_per_metre: f64) -> Self {
        let no = || vec![false; count];
        Self {
            asleep: no(),
            sleepers: 0,
            looked_at: (0..count as u32).collect(),
            aside: no(),
            boxes: CellGrid::new(count, cells_per_metre),
            reached: Vec::with_capacity(count),
            undisturbed: no(),
        }
    }

    pub fn wake(&mut self, body: usize) {
        if std::mem::replace(&mut self.asleep[body], false) {
            self.sleepers -= 1;
        }
        self.rouse(body);
    }

    pub fn wake_all(&mut self) {
        self.asleep.fill(false);
        self.sleepers = 0;
        self.rouse_all();
    }

    /// Makes a step look at a body, asleep or not. Returns whether that is new.
    pub(crate) fn rouse(&mut self, body: usize) -> bool {
        self.undisturbed[body] = false;
        let aside = std::mem::replace(&mut self.aside[body], false);
        if aside {
            self.boxes.leave(body);
            self.looked_at.push(body as u32);
        }
        aside
    }

    /// Makes a step look at the bodies set aside whose boxes meet these bounds, and calls `each` for them.
    pub(crate) fn reach(&mut self, bounds: &Aabb, mut each: impl FnMut(usize)) {
        let mut reached = std::mem::take(&mut self.reached);
        self.boxes.find(bounds, &mut reached);
        for body in reached.drain(..) {
            self.rouse(body as usize);
            each(body as usize);
        }
        self.reached = reached;
    }

    /// Whether these bounds meet the box of a body that is set aside.
    pub(crate) fn is_reached(&mut self, bounds: &Aabb) -> bool {
        self.boxes.find(bounds, &mut self.reached);
        let any = !self.reached.is_empty();
        self.reached.clear();
        any
    }

    pub(crate) fn rouse_all(&mut self) {
        self.undisturbed.fill(false);
        if self.looked_at.len() < self.aside.len() {
            self.aside.fill(false);
            self.boxes.clear();
            self.looked_at.clear();
            self.looked_at.extend(0..self.aside.len() as u32);
        }
    }

    pub fn looks_at_all(&self) -> bool {
        self.looked_at.len() == self.aside.len()
    }

    /// Sets the bodies aside that slept through the step before, if few enough are left.
    pub(crate) fn set_aside(&mut self, swept: &[Aabb]) {
        let Self { looked_at, undisturbed, aside, asleep, boxes, .. } = self;
        let sleeps = |body: u32| asleep[body as usize] && undisturbed[body as usize];
        let left = looked_at.iter().filter(|body| !sleeps(**body)).count();
        if left as f64 > MOST_LOOKED_AT * aside.len() as f64 {
            return self.rouse_all();
        }
        looked_at.retain(|&body| {
            if sleeps(body) {
                aside[body as usize] = true;
                boxes.enter(body as usize, swept[body as usize]);
            }
            !aside[body as usize]
        });
    }

    pub fn all_asleep(&self) -> bool {
        self.sleepers == self.asleep.len()
    }

    /// An island that is all asleep and touches nothing that moves stays as it is.
    pub(crate) fn stays_asleep(&mut self, bodies: &[Body], motions: &mut Motions, island: Island<'_>) -> bool {
        let carries = |surface: u32| motions.surfaces[surface as usize].carries();
        let sleeps = self.sleepers > 0 && island.members.iter().all(|i| self.asleep[*i as usize]);
        if !sleeps || island.surfaces(motions.len()).any(carries) {
            return false;
        }
        for i in island.members.iter().map(|i| *i as usize) {
            motions.bodies[i].end = (bodies[i].position, DVec2::ZERO);
            self.undisturbed[i] = true;
        }
        true
    }

    /// A step that moved nothing and left nothing moving is followed by the same for ever. Returns whether the island sleeps.
    pub(crate) fn finish(&mut self, bodies: &[Body], motions: &Motions, (island, may_sleep): (Island<'_>, bool)) -> bool {
        let still = |i: &u32| {
            let (body, end) = (&bodies[*i as usize], motions.bodies[*i as usize].end);
            body.velocity == DVec2::ZERO && end == (body.position, DVec2::ZERO)
        };
        let sleeps = may_sleep && island.members.iter().rev().all(still);
        self.note(island, sleeps);
        sleeps
    }

    pub(crate) fn note(&mut self, island: Island<'_>, sleeps: bool) {
        for &i in island.members {
            if sleeps {
                self.undisturbed[i as usize] = false;
                self.sleepers += usize::from(!std::mem::replace(&mut self.asleep[i as usize], true));
            } else if self.sleepers > 0 {
                self.wake(i as usize);
            }
        }
    }
}
