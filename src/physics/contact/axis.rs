//! One axis of a group of contacts: a [`Network`] with a link for each push along the axis and for each friction that sticks.

use crate::physics::contact::network::{Carries, GROUND, Network, NetworkNode};
use crate::physics::data::{Contact, LIGHT, MICRO_SPEED, SPEED_TOLERANCE, refill};
use glam::DVec2;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Question {
    /// Forces: friction is static or kinetic by Coulomb's law.
    Forces,
    /// Impulses: friction takes up to μ_k times the normal impulse.
    Impulses,
}

/// Bodies have the numbers from 0 on, surfaces follow.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Parts<'a> {
    /// Of each body along each axis, kg: for an implicit step larger than its own.
    pub masses: &'a [DVec2],
    /// Of each item without contacts, m/s² (or m/s where impulses are sought).
    pub free: &'a [DVec2],
}

#[derive(Clone, Debug, Default)]
pub(crate) struct Joined {
    /// Along either axis.
    networks: [Network; 2],
    /// The node of each item; `GROUND` for bodies without contacts and for surfaces.
    node_of: Vec<u32>,
    pub(super) body_of: Vec<u32>,
    contact_of: Vec<u32>,
    /// The bodies that closing surfaces squeeze, with the axis, by the last solve.
    pub squeezed: Vec<(u32, usize)>,
}

impl Joined {
    pub(super) fn number(&mut self, contacts: &[Contact], parts: &Parts) {
        refill(&mut self.node_of, parts.free.len(), GROUND);
        self.body_of.clear();
        for item in contacts.iter().flat_map(Contact::pair) {
            if (item as usize) < parts.masses.len() && self.node_of[item as usize] == GROUND {
                self.node_of[item as usize] = self.body_of.len() as u32;
                self.body_of.push(item);
            }
        }
    }

    /// Ends a slide: both sides, and all that moves with them but for rounding, get one speed along the face. `parts` holds velocities.
    pub fn merge_speeds(&mut self, stopped: &Contact, contacts: &[Contact], parts: &Parts, velocities: &mut [DVec2]) {
        let axis = 1 - stopped.axis;
        self.number(contacts, parts);
        self.set_nodes(axis, parts, 0.0);
        let network = &mut self.networks[axis];
        for contact in contacts {
            let skin = if contact.axis == stopped.axis { contact.skin } else { 0.0 };
            let speed = |item: u32| rate(parts, item, axis, skin);
            // What parts as slowly across its face clings: alone it would be pulled back, and make the slide begin again, less and less without end.
            let rounding = if contact.axis == axis { MICRO_SPEED } else { SPEED_TOLERANCE };
            if (speed(contact.hi) - speed(contact.lo)).abs() <= rounding || contact.is_of(stopped.lo, stopped.hi) {
                let [lo, hi] = contact.pair().map(|item| self.node_of[item as usize]);
                network.link(lo, hi, Carries::UpTo(f64::INFINITY), ground(contact, parts, axis, skin));
            }
        }
        network.solve();
        self.give(axis, velocities);
    }

    pub(super) fn solve_axis(&mut self, axis: usize, contacts: &mut [Contact], parts: &Parts, question: Question) {
        let known = self.squeezed.len();
        let frame = if question == Question::Forces { self.falls_alike(axis, contacts, parts) } else { 0.0 };
        loop {
            self.set_nodes(axis, parts, frame);
            self.contact_of.clear();
            for (index, contact) in contacts.iter_mut().enumerate() {
                if self.link(axis, contact, parts, question) {
                    self.contact_of.push(index as u32);
                }
            }
            let network = &mut self.networks[axis];
            network.solve();
            network.nodes.iter_mut().for_each(|node| node.acceleration += frame);
            network.answered &= frame == 0.0;
            self.squeezed.truncate(known);
            self.squeezed.extend(network.squeezed.iter().map(|&node| (self.body_of[node as usize], axis)));
            if !self.read(axis, contacts, question) {
                return;
            }
        }
    }

    /// Fills the network with the bodies, in a frame that accelerates along the axis, m/s².
    fn set_nodes(&mut self, axis: usize, parts: &Parts, frame: f64) {
        let network = &mut self.networks[axis];
        network.clear();
        network.nodes.extend(self.body_of.iter().map(|&body| {
            let mass = parts.masses[body as usize][axis];
            NetworkNode { mass, force: mass * (parts.free[body as usize][axis] - frame), acceleration: 0.0 }
        }));
    }

    pub(super) fn give(&self, axis: usize, to: &mut [DVec2]) {
        for (node, &body) in self.networks[axis].nodes.iter().zip(&self.body_of) {
            to[body as usize][axis] = node.acceleration;
        }
    }

    /// The free acceleration of the heaviest body along an axis, if no surface holds anything and the others fall almost alike; else 0.
    fn falls_alike(&self, axis: usize, contacts: &[Contact], parts: &Parts) -> f64 {
        let links = |contact: &Contact| contact.axis == axis || contact.normal > 0.0 && contact.slides == 0.0;
        let held = contacts.iter().any(|contact| contact.lo.max(contact.hi) as usize >= parts.masses.len() && links(contact));
        if held || self.body_of.len() < 2 {
            return 0.0;
        }
        let of = |body: &u32| (parts.masses[*body as usize][axis], parts.free[*body as usize][axis]);
        let (mass, frame) = self.body_of.iter().map(of).max_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or_default();
        let otherwise: f64 = self.body_of.iter().map(of).map(|(mass, free)| mass * (free - frame).abs()).sum();
        // A body that less pulls at would lose it to rounding in that frame.
        let falls = self.body_of.iter().map(of).all(|(_, free)| free.abs() >= 1e-6 * frame.abs());
        if falls && otherwise <= LIGHT * mass * frame.abs() { frame } else { 0.0 }
    }

    /// Adds the push of a contact along an axis, or its friction. Returns whether that needs a link.
    fn link(&mut self, axis: usize, contact: &mut Contact, parts: &Parts, question: Question) -> bool {
        let (lo, hi) = (self.node_of[contact.lo as usize], self.node_of[contact.hi as usize]);
        let network = &mut self.networks[axis];
        if contact.axis == axis {
            let both_ways = question == Question::Impulses && contact.clings;
            let carries = if both_ways { Carries::UpTo(f64::INFINITY) } else { Carries::Push };
            network.link(lo, hi, carries, ground(contact, parts, axis, 0.0));
            return true;
        }
        contact.friction = 0.0;
        if contact.normal <= 0.0 {
            return false;
        }
        let kinetic = contact.kinetic_friction * contact.normal;
        if question == Question::Forces && contact.slides != 0.0 {
            contact.friction = -contact.slides * kinetic;
            for (end, sign) in [(lo, -1.0), (hi, 1.0)] {
                if end != GROUND {
                    network.nodes[end as usize].force += sign * contact.friction;
                }
            }
            return false;
        }
        let (limit, skin) = match question {
            Question::Forces => (contact.static_friction * contact.normal, 0.0),
            Question::Impulses => (kinetic, contact.skin),
        };
        network.link(lo, hi, Carries::UpTo(limit), ground(contact, parts, axis, skin));
        true
    }

    /// Takes the flows over into the contacts. Returns whether static friction gave way, so that the axis has to be solved again.
    fn read(&self, axis: usize, contacts: &mut [Contact], question: Question) -> bool {
        let mut gave_way = false;
        for (link, &index) in self.networks[axis].links.iter().zip(&self.contact_of) {
            let contact = &mut contacts[index as usize];
            if contact.axis == axis {
                // Contacts that cling may be held back by next to nothing: an impulse, too.
                contact.normal = if question == Question::Impulses && contact.clings { link.flow } else { link.flow.max(0.0) };
                continue;
            }
            contact.friction = link.flow;
            if question == Question::Forces && link.cut {
                let of = |node: u32| self.networks[axis].nodes.get(node as usize).map_or(link.ground, |node| node.acceleration);
                let slip = of(link.hi) - of(link.lo);
                if slip != 0.0 {
                    (contact.slides, contact.gave_way) = (slip.signum(), true);
                    gave_way = true;
                }
            }
        }
        gave_way
    }
}

/// The free acceleration of an item along an axis; `skin` is the belt speed of a surface along it.
fn rate(parts: &Parts, item: u32, axis: usize, skin: f64) -> f64 {
    let free = parts.free[item as usize][axis];
    if (item as usize) < parts.masses.len() { free } else { free + skin }
}

/// The acceleration of the ground of a contact along an axis; 0 between two bodies.
pub(super) fn ground(contact: &Contact, parts: &Parts, axis: usize, skin: f64) -> f64 {
    let second = contact.lo.max(contact.hi);
    if (second as usize) < parts.masses.len() { 0.0 } else { rate(parts, second, axis, skin) }
}
