//! Whom a step looks at: all that are awake, and what sleeps where these, or surfaces that move, may come. Of these it finds where free
//! flight leads them, what they sweep, and who is near.

use crate::physics::crowd::flight;
use crate::physics::space::Space;
use crate::physics::store::islands::apart;

impl Space {
    /// Chooses whom this step looks at. Where boxes move along with what they were made for, or the step has another length, that is all.
    pub(crate) fn look_at(&mut self, dt: f64) {
        let Self { driver, bodies, neighbours, .. } = self;
        if dt == self.last_dt && driver.sleepers > 0 && neighbours.stand() {
            driver.set_aside();
        } else if !driver.looks_at_all() {
            driver.rouse_all();
        }
        driver.slots.clear();
        if driver.looks_at_all() {
            driver.slots.extend(0..bodies.len() as u32);
        } else {
            driver.slots.extend(driver.looked_at.iter().map(|body| bodies.slot[*body as usize]));
            driver.slots.sort_unstable();
        }
        self.islands.look_at(&driver.slots);
    }

    /// Looks also at those, set aside, whose boxes the boxes of the slots from number `from` on reach, and at whom these reach.
    pub(crate) fn rouse_reached(&mut self, from: usize) {
        let Self { driver, bodies, neighbours, islands, .. } = self;
        let mut next = from;
        while next < driver.slots.len() && !driver.looks_at_all() {
            let i = driver.slots[next] as usize;
            next += 1;
            for &j in neighbours.near_swept(bodies, i) {
                let j = j as usize;
                if j < bodies.len() && !apart(&bodies.swept[i], &bodies.swept[j]) && driver.rouse(bodies.id[j] as usize) {
                    bodies.fall_freely(j);
                    driver.slots.push(j as u32);
                }
            }
        }
        if driver.slots.len() > from {
            islands.look_at(&driver.slots);
        }
    }

    pub(crate) fn fly(&mut self, dt: f64) {
        let Self { bodies, neighbours, islands, driver, .. } = self;
        neighbours.drift(bodies, dt);
        flight::fly(bodies, &driver.slots, dt, self.drag);
        bodies.sweep(&driver.slots);
        if bodies.sweep_surfaces(&driver.moving) {
            islands.forget();
        }
        // The boxes in which neighbours were sought are made for many bodies together; what an island comes to must not depend on them.
        if !neighbours.update(bodies, &driver.slots, dt) {
            if !driver.looks_at_all() {
                driver.rouse_all();
                driver.slots.clear();
                driver.slots.extend(0..bodies.len() as u32);
                flight::fly(bodies, &driver.slots, dt, self.drag);
            }
            neighbours.search(bodies, dt);
            islands.renumbered();
        }
        bodies.keep_free_flight(&driver.slots);
        self.look_at_surfaces();
        self.rouse_reached(0);
    }

    /// Sets what surfaces that move sweep in this step, and finds whom they may meet there.
    pub(crate) fn look_at_surfaces(&mut self) {
        let Self { bodies, driver, .. } = self;
        let n = bodies.len();
        for &(surface, [left, right, top, bottom]) in &driver.ways {
            let s = &mut bodies.swept[n + surface as usize];
            *s = [s[0].min(left), s[1].max(right), s[2].min(top), s[3].max(bottom)];
        }
        self.look_at_moving();
    }

    /// Finds whom surfaces that move may meet.
    pub(crate) fn look_at_moving(&mut self) {
        let Self { bodies, neighbours, driver, .. } = self;
        neighbours.find_moving(bodies, &driver.moving);
        let known = driver.slots.len();
        if !driver.looks_at_all() {
            for &i in neighbours.carried() {
                if driver.rouse(bodies.id[i as usize] as usize) {
                    bodies.fall_freely(i as usize);
                    driver.slots.push(i);
                }
            }
        }
        self.rouse_reached(known);
    }
}
