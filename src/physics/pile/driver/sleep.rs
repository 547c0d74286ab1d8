//! Who sleeps: islands that a step left as they were, until something outside changes or something else comes near.

use super::super::bodies::Bodies;
use super::super::islands::Island;
use super::{ContactImpulse, Driver};

impl Driver {
    pub fn wake(&mut self, body: usize) {
        self.sleepers -= usize::from(std::mem::replace(&mut self.asleep[body], false));
    }

    pub fn wake_all(&mut self) {
        self.asleep.fill(false);
        self.sleepers = 0;
    }

    pub fn all_asleep(&self) -> bool {
        self.sleepers == self.asleep.len()
    }

    pub fn sleeps(&self, body: usize) -> bool {
        self.asleep[body]
    }

    pub(super) fn fall_asleep(&mut self, body: usize) {
        if !std::mem::replace(&mut self.asleep[body], true) {
            self.sleepers += 1;
            self.fresh.push(body as u32);
        }
    }

    /// Wakes whom this step has let fall asleep.
    pub(super) fn wake_fresh(&mut self) {
        while let Some(body) = self.fresh.pop() {
            self.wake(body as usize);
        }
    }

    /// What was told of those that slept holds no longer.
    pub(super) fn forget(&self, bodies: &Bodies, island: Island<'_>, report: &mut Vec<ContactImpulse>) {
        let slept = |body: usize| self.asleep[body] && island.members.contains(&bodies.slot[body]);
        if self.sleepers > 0 && !report.is_empty() {
            report.retain(|contact| !slept(contact.a));
        }
    }

    /// An island of which all sleep and that nothing moving touches stays as it is.
    pub(super) fn stays_asleep(&mut self, bodies: &mut Bodies, island: Island<'_>) -> bool {
        if self.sleepers == 0 || !island.members.iter().all(|i| self.asleep[bodies.id[*i as usize] as usize]) {
            return false;
        }
        let n = bodies.len() as u32;
        let carries = |j: u32| j >= n && bodies.carries(j as usize);
        if island.members.iter().any(|i| island.near(*i).iter().any(|j| carries(*j))) {
            return false;
        }
        island.members.iter().for_each(|i| bodies.stay(*i as usize));
        true
    }

    /// A step that moved nothing and left nothing moving would be followed by the same for ever.
    pub(super) fn finish(&mut self, bodies: &Bodies, island: Island<'_>, may_sleep: bool) {
        let still = |i: usize| {
            let rests = bodies.vy[i] == 0.0 && bodies.vx[i] == 0.0 && bodies.uy[i] == 0.0 && bodies.ux[i] == 0.0;
            rests && bodies.x[i] == bodies.px[i] && bodies.y[i] == bodies.py[i]
        };
        let sleeps = may_sleep && island.members.iter().rev().all(|i| still(*i as usize));
        self.note_sleep(bodies, island, sleeps);
    }

    pub(super) fn note_sleep(&mut self, bodies: &Bodies, island: Island<'_>, sleeps: bool) {
        for &i in island.members {
            if sleeps {
                self.fall_asleep(bodies.id[i as usize] as usize);
            } else if self.sleepers > 0 {
                self.wake(bodies.id[i as usize] as usize);
            }
        }
    }
}
