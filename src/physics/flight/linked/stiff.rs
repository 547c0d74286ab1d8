//! Stiff links whose ends touch something: one implicit step gives the force that acts on them for a tick.

use crate::physics::flight::linked::LinkedBodies;
use crate::physics::forces::link::LinkLaw;
use glam::DVec2;

/// (Rate · tick)² from which a mean force over a tick is unstable: it is at 9.
const STIFF: f64 = 4.0;
/// Rounds over the links of a group. Fewer: a chain sags while its ends touch something.
const SWEEPS: usize = 32;

impl LinkedBodies<'_> {
    fn inverse_mass(&self, end: Option<usize>) -> f64 {
        let free = end.map(|end| &self.members[end]).filter(|member| !member.held);
        free.map_or(0.0, |member| 1.0 / self.bodies[member.id as usize].mass)
    }

    /// Whether a mean force that acts for all of a tick throws a body beyond where its link would have let it turn.
    pub(super) fn is_stiff(&self) -> bool {
        self.pulls.iter().any(|pull| {
            let mass: f64 = pull.ends.iter().map(|end| self.inverse_mass(*end)).sum();
            self.links[pull.link as usize].law.rates()[0] * mass * self.tick * self.tick > STIFF
        })
    }

    /// Bodies that touch something take in place of the mean force that of one implicit step, which throws none beyond its links: the impulses of
    /// all springs and ropes under which each has its force at the place to which a constant force leads (Gauss and Seidel).
    pub(super) fn steady(&mut self) {
        let dt = self.tick;
        for member in &mut *self.members {
            let body = &self.bodies[member.id as usize];
            let free = self.media.acceleration(body, &member.law, body.position, body.velocity) * dt;
            let v = if member.held { DVec2::ZERO } else { body.velocity + free };
            (member.end, member.mean) = ([body.position, v, DVec2::ZERO], DVec2::ZERO);
        }
        for _ in 0..SWEEPS {
            (0..self.pulls.len()).for_each(|k| self.calm(k, dt));
        }
    }

    /// Corrects the impulse of one link in an implicit step of `dt` seconds.
    fn calm(&mut self, k: usize, dt: f64) {
        let pull = &self.pulls[k];
        let (law, ends) = (self.links[pull.link as usize].law, pull.ends);
        let (apart, parting) = self.apart(pull, |member| (member.end[0], member.end[1]));
        let (along, masses) = (apart.normalize_or_zero(), ends.map(|end| self.inverse_mass(end)));
        let least = if matches!(law, LinkLaw::Rope(_)) { 0.0 } else { f64::NEG_INFINITY };
        let impulse = match law {
            LinkLaw::Magnet(_) => along.dot(law.force(law.border(apart, parting) > 0.0, apart, parting)) * dt,
            LinkLaw::Spring(of) | LinkLaw::Rope(of) => {
                let (soft, mass) = (0.5 * dt * (of.damping + dt * of.stiffness), masses[0] + masses[1]);
                let stretch = apart.length() - of.length - pull.growth * dt;
                let begin = self.apart(pull, |member| (DVec2::ZERO, self.bodies[member.id as usize].velocity)).1;
                let wanted = dt * of.stiffness * stretch + soft * (along.dot(parting + begin) + pull.impulse * mass);
                (wanted / (1.0 + soft * mass)).max(least)
            }
        };
        let change = along * (impulse - pull.impulse);
        self.pulls[k].impulse = impulse;
        for (end, mass, sign) in [(ends[0], masses[0], 1.0), (ends[1], masses[1], -1.0)] {
            if let Some(end) = end {
                self.members[end].end[1] += change * (mass * sign);
                self.members[end].mean += change * (sign / dt);
            }
        }
    }
}
