//! Whom a step looks at: all that are awake, and what sleeps where these, or surfaces that move, may come. Of these it finds where free
//! flight leads them, what they sweep, and who is near.

use crate::physics::crowd::flight;
use crate::physics::space::Space;
use crate::physics::store::islands::apart;

impl Space {
    /// Chooses whom this step looks at. Where boxes move along with what they were made for, or the step has another length, that is all.
    pub(crate) fn look_at(&mut self, dt: f64) {
        let Self { sleep, bodies, neighbours, .. } = self;
        if dt == self.last_dt && sleep.sleepers() > 0 && neighbours.stand() {
            sleep.set_aside();
        } else if !sleep.looks_at_all() {
            sleep.rouse_all();
        }
        sleep.number(bodies);
        self.islands.look_at(&sleep.slots);
    }

    /// Looks also at those, set aside, whose boxes the boxes of the slots from number `from` on reach, and at whom these reach.
    pub(crate) fn rouse_reached(&mut self, from: usize) {
        let Self { sleep, bodies, neighbours, islands, .. } = self;
        let mut next = from;
        while next < sleep.slots.len() && !sleep.looks_at_all() {
            let i = sleep.slots[next] as usize;
            next += 1;
            for &j in neighbours.near_swept(bodies, i) {
                let j = j as usize;
                if j < bodies.len() && !apart(&bodies.swept[i], &bodies.swept[j]) && sleep.rouse(bodies.id[j] as usize) {
                    bodies.fall_freely(j);
                    sleep.slots.push(j as u32);
                }
            }
        }
        if sleep.slots.len() > from {
            islands.look_at(&sleep.slots);
        }
    }

    pub(crate) fn fly(&mut self, dt: f64) {
        let Self { bodies, neighbours, islands, sleep, movers, .. } = self;
        neighbours.drift(bodies, dt);
        flight::fly(bodies, &sleep.slots, dt, self.drag);
        bodies.sweep(&sleep.slots);
        if bodies.sweep_surfaces(&movers.moving) {
            islands.forget();
        }
        // The boxes in which neighbours were sought are made for many bodies together; what an island comes to must not depend on them.
        if !neighbours.update(bodies, &sleep.slots, dt) {
            if !sleep.looks_at_all() {
                sleep.rouse_all();
                sleep.slots.clear();
                sleep.slots.extend(0..bodies.len() as u32);
                flight::fly(bodies, &sleep.slots, dt, self.drag);
            }
            neighbours.search(bodies, dt);
            islands.renumbered();
        }
        bodies.keep_free_flight(&sleep.slots);
        self.look_at_surfaces();
        self.rouse_reached(0);
    }

    /// Sets what surfaces that move sweep in this step, and finds whom they may meet there.
    pub(crate) fn look_at_surfaces(&mut self) {
        let Self { bodies, movers, .. } = self;
        let n = bodies.len();
        for &(surface, [left, right, top, bottom]) in &movers.ways {
            let s = &mut bodies.swept[n + surface as usize];
            *s = [s[0].min(left), s[1].max(right), s[2].min(top), s[3].max(bottom)];
        }
        self.look_at_moving();
    }

    /// Finds whom surfaces that move may meet.
    pub(crate) fn look_at_moving(&mut self) {
        let Self { bodies, neighbours, sleep, movers, .. } = self;
        neighbours.find_moving(bodies, &movers.moving);
        let known = sleep.slots.len();
        if !sleep.looks_at_all() {
            for &i in neighbours.carried() {
                if sleep.rouse(bodies.id[i as usize] as usize) {
                    bodies.fall_freely(i as usize);
                    sleep.slots.push(i);
                }
            }
        }
        self.rouse_reached(known);
    }
}
