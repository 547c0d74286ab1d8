//! Bodies that a step looks at: those that are awake, and sleepers that these may reach. Of these it finds where free flight leads them, what
//! they sweep, and which are near each other.

use crate::physics::data::body::Body;
use crate::physics::space::Space;
use crate::physics::store::edges::overlap;

impl Space {
    /// Finds where all fly that a step looks at, and which of them may meet.
    pub(crate) fn fly(&mut self, bodies: &[Body], dt: f64) {
        let Self { motions, broad_phase, sleep, moving, .. } = self;
        // What sleeps has its free flight of the step before, which holds for steps of the same length.
        if dt == self.last_dt && sleep.sleepers() > 0 {
            sleep.set_aside();
        } else if !sleep.looks_at_all() {
            sleep.rouse_all();
        }
        motions.fly(bodies, sleep.looked_at(), dt);
        broad_phase.update(bodies, motions, sleep.looked_at(), dt);
        // Sleepers near what moves are looked at, whether or not they were set aside: no bit may depend on that.
        let n = bodies.len();
        for surface in moving.iter().map(|surface| *surface as usize) {
            for i in 0..if motions.surfaces[surface].carries() && !sleep.looks_at_all() { n } else { 0 } {
                if overlap(&motions.swept[i], &motions.swept[n + surface]) && sleep.rouse(i) {
                    motions.fall_freely(i);
                }
            }
        }
        self.rouse_reached();
    }

    /// Looks also at those, set aside, whose boxes overlap the boxes of others that are looked at, and at all that these reach.
    pub(crate) fn rouse_reached(&mut self) {
        let Self { sleep, motions, broad_phase, islands, .. } = self;
        let n = motions.len();
        let mut next = 0;
        while next < sleep.looked_at().len() && !sleep.looks_at_all() {
            let i = sleep.looked_at()[next] as usize;
            next += 1;
            for j in broad_phase.near(i).iter().map(|j| *j as usize).filter(|j| *j < n) {
                if overlap(&motions.swept[i], &motions.swept[j]) && sleep.rouse(j) {
                    motions.fall_freely(j);
                }
            }
        }
        islands.look_at(sleep.looked_at());
    }
}
