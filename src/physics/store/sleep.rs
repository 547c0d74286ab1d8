//! Sleep: islands that a step left as they were, until something outside changes or something else comes near.
//!
//! What has slept through a whole step is set aside: flight, the search for neighbours and islands leave it out until something wakes it, or
//! until the boxes that others sweep reach its own (`rouse`). A step would find about it what it found before: its box
//! in `Motions::swept` and its free flight stay those of the step before. So it costs nothing, and changes no bit.

use crate::physics::data::body::Body;
use crate::physics::store::islands::Island;
use crate::physics::store::motions::Motions;
use glam::DVec2;

/// Nobody is set aside while more than this part of the bodies has to be looked at: who is near them is looked up one by one then.
const MOST_LOOKED_AT: f64 = 0.25;

/// Who sleeps and who is looked at.
#[derive(Clone, Debug, Default)]
pub(crate) struct Sleep {
    asleep: Vec<bool>,
    sleepers: usize,
    /// Whom a step looks at; the others are `aside`.
    looked_at: Vec<u32>,
    aside: Vec<bool>,
    /// Whose islands the last step has left asleep.
    undisturbed: Vec<bool>,
}

impl Sleep {
    pub fn new(count: usize) -> Self {
        let no = || vec![false; count];
        Self { asleep: no(), aside: no(), undisturbed: no(), looked_at: (0..count as u32).collect(), ..Self::default() }
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

    /// Counts a body to those that a step looks at, asleep or not. Returns whether that is new.
    pub(crate) fn rouse(&mut self, body: usize) -> bool {
        self.undisturbed[body] = false;
        let aside = std::mem::replace(&mut self.aside[body], false);
        if aside {
            self.looked_at.push(body as u32);
        }
        aside
    }

    pub(crate) fn rouse_all(&mut self) {
        self.undisturbed.fill(false);
        if self.looked_at.len() < self.aside.len() {
            self.aside.fill(false);
            self.looked_at.clear();
            self.looked_at.extend(0..self.aside.len() as u32);
        }
    }

    pub fn looked_at(&self) -> &[u32] {
        &self.looked_at
    }

    pub fn looks_at_all(&self) -> bool {
        self.looked_at.len() == self.aside.len()
    }

    /// Sets those aside that slept through the step before, if that leaves few enough to be worth it.
    pub(crate) fn set_aside(&mut self) {
        let Self { looked_at, undisturbed, aside, asleep, .. } = self;
        let sleeps = |body: u32| asleep[body as usize] && undisturbed[body as usize];
        let left = looked_at.iter().filter(|body| !sleeps(**body)).count();
        if left as f64 > MOST_LOOKED_AT * aside.len() as f64 {
            return self.rouse_all();
        }
        looked_at.retain(|&body| {
            aside[body as usize] = sleeps(body);
            !aside[body as usize]
        });
    }

    pub fn all_asleep(&self) -> bool {
        self.sleepers == self.asleep.len()
    }

    pub fn sleepers(&self) -> usize {
        self.sleepers
    }

    pub fn sleeps(&self, body: usize) -> bool {
        self.asleep[body]
    }

    pub(crate) fn fall_asleep(&mut self, body: usize) {
        if !std::mem::replace(&mut self.asleep[body], true) {
            self.undisturbed[body] = false;
            self.sleepers += 1;
        }
    }

    /// An island of which all sleep and that nothing moving touches stays as it is.
    pub(crate) fn stays_asleep(&mut self, bodies: &[Body], motions: &mut Motions, island: Island<'_>) -> bool {
        if self.sleepers == 0 || !island.members.iter().all(|i| self.asleep[*i as usize]) {
            return false;
        }
        if island.surfaces(motions.len()).any(|surface| motions.surfaces[surface as usize].carries()) {
            return false;
        }
        for i in island.members.iter().map(|i| *i as usize) {
            motions.bodies[i].end = (bodies[i].position, DVec2::ZERO);
            self.undisturbed[i] = true;
        }
        true
    }

    /// A step that moved nothing and left nothing moving would be followed by the same for ever. Returns whether the island sleeps.
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
                self.fall_asleep(i as usize);
            } else if self.sleepers > 0 {
                self.wake(i as usize);
            }
        }
    }
}
