//! Whether the contacts of a group at rest can take up another force across, beginning with those that they had: no network is solved from scratch.

use crate::physics::contact::network::{Carries, GROUND, Network, NetworkNode};
use crate::physics::data::{Contact, FORCE_TOLERANCE};
use glam::DVec2;

#[derive(Clone, Debug, Default)]
pub(crate) struct RestingGroup {
    /// The contacts, between members by their places; what stands has the number of members, or more.
    pub contacts: Vec<Contact>,
    /// The force on each member without contacts, N.
    pub forces: Vec<DVec2>,
    /// What is left of it along gravity, N.
    left: Vec<f64>,
    network: Network,
}

impl RestingGroup {
    pub fn clear(&mut self) {
        self.contacts.clear();
        self.forces.clear();
    }

    /// Whether all can rest. Their contacts have the forces that hold them then.
    pub fn holds(&mut self) -> bool {
        let Self { contacts, forces, left, network } = self;
        network.clear();
        network.nodes.extend(forces.iter().map(|force| NetworkNode { mass: 1.0, force: force.x, acceleration: 0.0 }));
        left.clear();
        left.extend(forces.iter().map(|force| force.y));
        for contact in &mut *contacts {
            let down = *contact.along(1);
            for (item, sign) in [(contact.lo, -1.0), (contact.hi, 1.0)] {
                if let Some(left) = left.get_mut(item as usize) {
                    *left += sign * down;
                }
            }
            let node = |item: u32| if (item as usize) < forces.len() { item } else { GROUND };
            let carries = if contact.axis == 0 { Carries::Push } else { Carries::UpTo(contact.static_friction * contact.normal) };
            network.link(node(contact.lo), node(contact.hi), carries, 0.0);
            if let Some(link) = network.links.last_mut() {
                link.flow = *contact.along(0);
            }
        }
        // What presses down is shared out by a full solution: plates weigh it.
        let most = forces.iter().fold(0.0, |most: f64, force| most.max(force.y.abs()));
        if left.iter().any(|left| left.abs() > FORCE_TOLERANCE * most) || !network.holds() {
            return false;
        }
        contacts.iter_mut().zip(&network.links).for_each(|(contact, link)| *contact.along(0) = link.flow);
        // A push that has become weaker may hold less friction.
        contacts.iter().all(|contact| contact.friction.abs() <= contact.static_friction * contact.normal)
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
