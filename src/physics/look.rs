//! Bodies that a step processes: those that are awake, and sleepers that these may reach. Of these it finds where free flight leads them, what
//! they sweep, and who is near.

use crate::physics::crowd::flight;
use crate::physics::space::Space;
use crate::physics::store::islands::apart;

impl Space {
    /// Finds where all fly that a step looks at, and whom they may meet.
    pub(crate) fn fly(&mut self, dt: f64) {
        let Self { bodies, broad_phase, islands, sleep, movers, .. } = self;
        // What sleeps has its free flight of the step before, which holds for steps of the same length.
        if dt == self.last_dt && sleep.sleepers() > 0 {
            sleep.set_aside();
        } else if !sleep.looks_at_all() {
            sleep.rouse_all();
        }
        flight::fly(bodies, sleep.looked_at(), dt, self.drag);
        bodies.sweep(sleep.looked_at());
        if bodies.sweep_surfaces(&movers.moving) {
            islands.forget();
        }
        let n = bodies.len();
        for &(surface, [left, right, top, bottom]) in &movers.ways {
            let s = &mut bodies.swept[n + surface as usize];
            *s = [s[0].min(left), s[1].max(right), s[2].min(top), s[3].max(bottom)];
        }
        broad_phase.update(bodies, sleep.looked_at(), dt);
        bodies.keep_free_flight(sleep.looked_at());
        // Sleepers near what moves are looked at, whether or not they were set aside: no bit may depend on that.
        for j in movers.moving.iter().map(|surface| n + *surface as usize) {
            for i in 0..if bodies.carries(j) && !sleep.looks_at_all() { n } else { 0 } {
                if !apart(&bodies.swept[i], &bodies.swept[j]) && sleep.rouse(i) {
                    bodies.fall_freely(i);
                }
            }
        }
        self.rouse_reached();
    }

    /// Looks also at those, set aside, whose boxes the boxes of others reach that are looked at, and at whom these reach.
    pub(crate) fn rouse_reached(&mut self) {
        let Self { sleep, bodies, broad_phase, islands, .. } = self;
        let n = bodies.len();
        let mut next = 0;
        while next < sleep.looked_at().len() && !sleep.looks_at_all() {
            let i = sleep.looked_at()[next] as usize;
            next += 1;
            for j in broad_phase.near(i).iter().map(|j| *j as usize).filter(|j| *j < n) {
                if !apart(&bodies.swept[i], &bodies.swept[j]) && sleep.rouse(j) {
                    bodies.fall_freely(j);
                }
            }
        }
        islands.look_at(sleep.looked_at());
    }
}
