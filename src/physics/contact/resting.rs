//! A group of bodies at rest on which other forces act than before: whether its contacts can take up the change, beginning with the forces that
//! they had. What is left over goes along shortest paths of contacts that have room for it to something that stands (Edmonds and Karp 1972), so
//! that no network is solved again where nothing moves.

use crate::physics::data::{Contact, FORCE_TOLERANCE, Incidence, NONE, on_axis, refill};
use glam::DVec2;

/// Where a search began.
const START: u32 = u32::MAX - 1;

#[derive(Clone, Debug, Default)]
pub(crate) struct RestingGroup {
    /// The contacts, between members by their places; what stands has the number of members, or more.
    pub contacts: Vec<Contact>,
    /// The force on each member without contacts, and what is left of it, N.
    pub forces: Vec<DVec2>,
    left: Vec<DVec2>,
    incident: Incidence,
    /// By member: the contact by which a search came there.
    came_by: Vec<u32>,
    queue: Vec<u32>,
}

impl RestingGroup {
    pub fn clear(&mut self) {
        self.contacts.clear();
        self.forces.clear();
    }

    /// Whether all can rest. Their contacts have the forces that hold them then.
    pub fn holds(&mut self) -> bool {
        let n = self.forces.len();
        self.left.clone_from(&self.forces);
        for contact in &self.contacts {
            let force = on_axis(contact.axis, contact.normal, contact.friction);
            for (item, sign) in [(contact.lo, -1.0), (contact.hi, 1.0)] {
                if let Some(left) = self.left.get_mut(item as usize) {
                    *left += sign * force;
                }
            }
        }
        let ends = |contact: &Contact| [contact.lo.min(n as u32), contact.hi.min(n as u32)];
        self.incident.index(n + 1, self.contacts.iter().map(ends));
        // What presses down is shared out by a full solution: plates weigh it.
        let most = self.forces.iter().fold(DVec2::ZERO, |most, force| most.max(force.abs()));
        if self.left.iter().any(|left| left.y.abs() > FORCE_TOLERANCE * most.y) {
            return false;
        }
        for i in 0..n {
            while self.left[i].x.abs() > FORCE_TOLERANCE * most.x {
                if !self.pass_on(i) {
                    return false;
                }
            }
        }
        // A push that has become weaker may hold less friction.
        let grips = |contact: &Contact| contact.friction.abs() <= contact.static_friction * contact.normal;
        self.contacts.iter().all(grips)
    }

    /// How much a contact can pass on from a member in the direction of `sign`, N.
    fn room(&self, contact: &Contact, from: u32, sign: f64) -> f64 {
        // Forces of contacts are those of `lo` on `hi`.
        let onwards = (contact.lo == from) == (sign > 0.0);
        if contact.axis == 0 {
            return if onwards { f64::INFINITY } else { contact.normal };
        }
        let limit = contact.static_friction * contact.normal;
        (if onwards { limit - contact.friction } else { limit + contact.friction }).max(0.0)
    }

    /// Hands what is left at a member on along the nearest way to something that stands, as far as that has room. Returns whether there is one.
    fn pass_on(&mut self, from: usize) -> bool {
        let n = self.forces.len();
        let sign = self.left[from].x.signum();
        refill(&mut self.came_by, n, NONE);
        self.came_by[from] = START;
        self.queue.clear();
        self.queue.push(from as u32);
        let mut next = 0;
        let reached = 'search: loop {
            let Some(&i) = self.queue.get(next) else { return false };
            next += 1;
            for &index in self.incident.of(i as usize) {
                let contact = &self.contacts[index as usize];
                let other = contact.other(i);
                if self.room(contact, i, sign) <= 0.0 {
                    continue;
                }
                match self.came_by.get_mut(other as usize) {
                    None => break 'search (i, index),
                    Some(came_by) if *came_by == NONE => {
                        *came_by = index;
                        self.queue.push(other);
                    }
                    Some(_) => {}
                }
            }
        };
        let mut amount = self.left[from].x.abs();
        let (mut at, mut index) = reached;
        loop {
            amount = amount.min(self.room(&self.contacts[index as usize], at, sign));
            index = self.came_by[at as usize];
            if index == START {
                break;
            }
            at = self.contacts[index as usize].other(at);
        }
        let (mut at, mut index) = reached;
        loop {
            let contact = &mut self.contacts[index as usize];
            *contact.along(0) += if contact.lo == at { sign * amount } else { -sign * amount };
            index = self.came_by[at as usize];
            if index == START {
                break;
            }
            at = self.contacts[index as usize].other(at);
        }
        self.left[from].x -= sign * amount;
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Three crates of 10 N on each other; the lowest stands on ground.
    fn column(friction: f64) -> RestingGroup {
        let contact = |k: u32| Contact {
            static_friction: friction,
            normal: 30.0 - 10.0 * f64::from(k),
            ..Contact::between(k, [3, 0, 1][k as usize], 1)
        };
        RestingGroup { contacts: (0..3).map(contact).collect(), forces: vec![DVec2::new(0.0, 10.0); 3], ..RestingGroup::default() }
    }

    #[test]
    fn friction_takes_a_push_at_the_top_down_to_the_ground() {
        let mut resting = column(0.5);
        resting.forces[2].x = 4.0;
        assert!(resting.holds());
        assert!(resting.contacts.iter().all(|contact| contact.friction == 4.0));
        resting.forces[2].x = 6.0;
        assert!(!resting.holds());
    }

    #[test]
    fn another_weight_is_left_to_a_full_solution() {
        for weight in [15.0, -1.0] {
            let mut resting = column(0.5);
            resting.forces[2].y = weight;
            assert!(!resting.holds());
        }
    }
}
