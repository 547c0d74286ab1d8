//! Contact forces: from what else acts on the bodies to their accelerations, with Reaction, Push and Friction on the way.
//!
//! Each axis is a [`Network`] solved exactly. The axes are coupled by Coulomb's law only: how much friction a contact can carry along
//! one axis depends on how hard it presses along the other. So the axis of gravity goes first, then the other with the friction that
//! follows, and round again only where something slides along a wall that it is pressed against. Static friction is a tie that carries
//! up to μ_s·N; where that is not enough the contact slides, with μ_k·N against the motion from then on.

use super::network::{Carries, GROUND, Network, Node};
use super::tuning::{FRICTION_ROUNDS, SPEED_TOLERANCE};
use super::{Body, World, contacts::Contact, face};
use glam::DVec2;

/// What the solver works on, apart from the world so that it can be reused for forces, impulses and speeds.
#[derive(Clone, Debug, Default)]
pub(super) struct Reactions {
    network: Network,
    /// Node of each body, or `GROUND` for bodies without contacts and for surfaces.
    node_of: Vec<u32>,
    body_of: Vec<u32>,
    /// For each link the contact whose push (along its own axis) or friction (along the other) it carries.
    contact_of: Vec<u32>,
    /// For each body the group that it belongs to (a union-find forest), and the contacts by group.
    leader: Vec<u32>,
    by_group: Vec<(u32, u32)>,
    group: Vec<Contact>,
}

/// What friction does in a solve.
#[derive(Clone, Copy, PartialEq)]
enum Friction {
    /// Forces: static or kinetic by Coulomb's law.
    Coulomb,
    /// Impulses: up to μ_k times the normal impulse.
    Impulse,
}

impl Reactions {
    /// Numbers the bodies that the contacts join.
    fn number(&mut self, contacts: &[Contact], bodies: usize, items: usize) {
        self.node_of.clear();
        self.node_of.resize(items, GROUND);
        self.body_of.clear();
        for contact in contacts {
            for item in [contact.lo, contact.hi] {
                if (item as usize) < bodies && self.node_of[item as usize] == GROUND {
                    self.node_of[item as usize] = self.body_of.len() as u32;
                    self.body_of.push(item);
                }
            }
        }
    }

    /// Builds and solves one axis; `applied` gives each body's force (or momentum). Updates the contacts' flows along this axis.
    fn solve_axis(&mut self, axis: usize, contacts: &mut [Contact], bodies: &[Body], friction: Friction, applied: &[DVec2]) {
        loop {
            self.network.clear();
            self.contact_of.clear();
            for &body in &self.body_of {
                let mass = bodies[body as usize].mass;
                let force = mass * applied[body as usize][axis];
                self.network.nodes.push(Node { mass, force, acceleration: 0.0 });
            }
            for (index, contact) in contacts.iter_mut().enumerate() {
                let (lo, hi) = (self.node_of[contact.lo as usize], self.node_of[contact.hi as usize]);
                if contact.axis == axis {
                    let both_ways = friction == Friction::Impulse && contact.clings;
                    self.network.link(lo, hi, if both_ways { Carries::UpTo(f64::INFINITY) } else { Carries::Push });
                    self.contact_of.push(index as u32);
                    continue;
                }
                contact.friction = 0.0;
                if contact.normal <= 0.0 {
                    continue;
                }
                let kinetic = contact.kinetic_friction * contact.normal;
                if friction == Friction::Coulomb && contact.slides != 0.0 {
                    contact.friction = -contact.slides * kinetic;
                    for (end, sign) in [(lo, -1.0), (hi, 1.0)] {
                        if end != GROUND {
                            self.network.nodes[end as usize].force += sign * contact.friction;
                        }
                    }
                } else {
                    let limit = if friction == Friction::Coulomb { contact.static_friction * contact.normal } else { kinetic };
                    self.network.link(lo, hi, Carries::UpTo(limit));
                    self.contact_of.push(index as u32);
                }
            }
            self.network.solve();
            if !self.read(axis, contacts, friction) {
                return;
            }
        }
    }

    /// Takes the flows over into the contacts; true if static friction gave way somewhere, so that the axis has to be solved again.
    fn read(&self, axis: usize, contacts: &mut [Contact], friction: Friction) -> bool {
        let mut gave_way = false;
        for (link, &index) in self.network.links.iter().zip(&self.contact_of) {
            let contact = &mut contacts[index as usize];
            if contact.axis == axis {
                contact.normal = link.flow.max(0.0);
                continue;
            }
            contact.friction = link.flow;
            let slip = self.rate(link.hi) - self.rate(link.lo);
            if friction == Friction::Coulomb && link.cut && slip != 0.0 {
                contact.slides = slip.signum();
                gave_way = true;
            }
        }
        gave_way
    }

    fn rate(&self, node: u32) -> f64 {
        self.network.nodes.get(node as usize).map_or(0.0, |node| node.acceleration)
    }

    /// Accelerations of bodies in contact (m/s²), from those they would have without (`free`), for the bodies of the contacts. What no
    /// contact joins is solved apart: no group's answer depends on another's.
    pub fn accelerate(&mut self, contacts: &mut [Contact], bodies: &[Body], items: usize, free: &[DVec2], out: &mut [DVec2]) {
        if let [contact] = contacts
            && let Contact { pair, lo, .. } = *contact
            && pair.b as usize >= bodies.len()
            && let Some(a) = face::press(contact, bodies[pair.a as usize].mass, free[pair.a as usize], pair.a != lo)
        {
            out[pair.a as usize] = a;
            return;
        }
        if self.find_groups(contacts, bodies.len()) <= 1 {
            return self.accelerate_group(contacts, bodies, items, free, out);
        }
        let mut group = std::mem::take(&mut self.group);
        let by_group = std::mem::take(&mut self.by_group);
        for members in by_group.chunk_by(|a, b| a.0 == b.0) {
            group.clear();
            group.extend(members.iter().map(|&(_, index)| contacts[index as usize]));
            self.accelerate_group(&mut group, bodies, items, free, out);
            for (&(_, index), &contact) in members.iter().zip(&group) {
                contacts[index as usize] = contact;
            }
        }
        (self.group, self.by_group) = (group, by_group);
    }

    /// Which contacts belong together: `by_group` lists each with its group, group by group. Returns how many groups there are. Surfaces
    /// join nothing: they move for nobody.
    fn find_groups(&mut self, contacts: &[Contact], bodies: usize) -> usize {
        if contacts.len() <= 1 {
            return contacts.len();
        }
        let leader = &mut self.leader;
        leader.clear();
        leader.extend(0..bodies as u32);
        for Contact { pair, .. } in contacts {
            if (pair.b as usize) < bodies {
                let (a, b) = (lead(leader, pair.a), lead(leader, pair.b));
                leader[a.max(b) as usize] = a.min(b);
            }
        }
        self.by_group.clear();
        self.by_group.extend(contacts.iter().zip(0..).map(|(contact, index)| (lead(leader, contact.pair.a), index)));
        if self.by_group.iter().all(|&(group, _)| group == self.by_group[0].0) {
            return 1;
        }
        self.by_group.sort_unstable();
        self.by_group.chunk_by(|a, b| a.0 == b.0).count()
    }

    /// One group of [`Self::accelerate`].
    fn accelerate_group(&mut self, contacts: &mut [Contact], bodies: &[Body], items: usize, free: &[DVec2], out: &mut [DVec2]) {
        self.number(contacts, bodies.len(), items);
        for &body in &self.body_of {
            out[body as usize] = free[body as usize];
        }
        for contact in contacts.iter_mut() {
            contact.normal = 0.0;
        }
        for round in 0..FRICTION_ROUNDS {
            // Of what presses on walls the first round's gravity axis has known nothing yet.
            let mut settled = round > 0;
            for axis in [1, 0] {
                self.solve_axis(axis, contacts, bodies, Friction::Coulomb, free);
                for (node, &body) in self.network.nodes.iter().zip(&self.body_of) {
                    let a = &mut out[body as usize][axis];
                    if axis == 1 && (*a - node.acceleration).abs() > f64::EPSILON * a.abs() {
                        settled = false;
                    }
                    *a = node.acceleration;
                }
            }
            // That matters only where something would slide on one.
            let rubs = |contact: &Contact| {
                let along = contact.slides != 0.0 || slip(contact, out) != 0.0;
                contact.axis == 0 && contact.normal > 0.0 && along
            };
            if settled || !contacts.iter().any(rubs) {
                break;
            }
        }
    }

    /// Speeds after a collision in which everything that touches stops approaching at once (perfectly plastic), with friction up to
    /// μ_k times the normal impulse. Afterwards the contacts hold the impulses (N·s).
    pub fn collide(&mut self, contacts: &mut [Contact], bodies: &mut [Body], items: usize, speeds: &mut Vec<DVec2>) {
        self.number(contacts, bodies.len(), items);
        speeds.clear();
        speeds.extend(bodies.iter().map(|body| body.velocity));
        for contact in contacts.iter_mut() {
            contact.normal = 0.0;
        }
        for axis in [1, 0, 1] {
            self.solve_axis(axis, contacts, bodies, Friction::Impulse, speeds);
            for (node, &body) in self.network.nodes.iter().zip(&self.body_of) {
                bodies[body as usize].velocity[axis] = node.acceleration;
            }
        }
    }

    /// Ends a slide: gives both sides of the contact that stopped, and everything that moves with them but for the rounding of that
    /// instant, exactly one speed along its face.
    pub fn merge_speeds(&mut self, stopped: &Contact, contacts: &[Contact], bodies: &mut [Body], items: usize) {
        let axis = 1 - stopped.axis;
        self.number(contacts, bodies.len(), items);
        self.network.clear();
        for &body in &self.body_of {
            let Body { mass, velocity, .. } = bodies[body as usize];
            self.network.nodes.push(Node { mass, force: mass * velocity[axis], acceleration: 0.0 });
        }
        let speed = |item: u32| bodies.get(item as usize).map_or(0.0, |body| body.velocity[axis]);
        for contact in contacts {
            let alike = (speed(contact.hi) - speed(contact.lo)).abs() <= SPEED_TOLERANCE;
            if alike || contact.pair == stopped.pair {
                let ends = (self.node_of[contact.lo as usize], self.node_of[contact.hi as usize]);
                self.network.link(ends.0, ends.1, Carries::UpTo(f64::INFINITY));
            }
        }
        self.network.solve();
        for (node, &body) in self.network.nodes.iter().zip(&self.body_of) {
            bodies[body as usize].velocity[axis] = node.acceleration;
        }
    }
}

/// The smallest body of a group.
fn lead(leader: &mut [u32], mut body: u32) -> u32 {
    while leader[body as usize] != body {
        leader[body as usize] = leader[leader[body as usize] as usize];
        body = leader[body as usize];
    }
    body
}

/// How fast `hi` gains on `lo` along the contact's face, m/s².
fn slip(contact: &Contact, accelerations: &[DVec2]) -> f64 {
    let of = |item: u32| accelerations.get(item as usize).map_or(0.0, |a| a[1 - contact.axis]);
    of(contact.hi) - of(contact.lo)
}

impl World {
    /// Accelerations of all bodies now, with contact forces where there are contacts. The same question has the same answer: while the
    /// contacts found are those of the last solve and pass on the same accelerations, nothing is solved.
    pub(super) fn solve_accelerations(&mut self) {
        for &body in &self.awake {
            let i = body as usize;
            let body = &self.bodies[i];
            self.free[i] = self.media.acceleration(body, &self.laws[i], body.position, body.velocity);
        }
        if !(self.plan.direct && self.is_solved()) {
            std::mem::swap(&mut self.asked, &mut self.found);
            self.asked_free.copy_from_slice(&self.free);
            self.contacts.clone_from(&self.asked);
            let items = self.bodies.len() + self.blocks.len();
            self.reactions.accelerate(&mut self.contacts, &self.bodies, items, &self.free, &mut self.solved);
            for &body in &self.awake {
                self.in_contact[body as usize] = false;
            }
            for contact in &self.contacts {
                for item in [contact.lo, contact.hi] {
                    if let Some(flag) = self.in_contact.get_mut(item as usize) {
                        *flag = true;
                    }
                }
            }
            self.forces_hold = false;
            self.answer_holds = true;
        }
        for &body in &self.awake {
            let i = body as usize;
            if !self.in_contact[i] {
                self.solved[i] = self.free[i];
            } else if !self.laws[i].air.is_none() {
                self.forces_hold = false;
            }
        }
    }

    /// Whether the last answer is that of the contacts just found.
    fn is_solved(&self) -> bool {
        let bits = |v: DVec2| v.to_array().map(f64::to_bits);
        self.answer_holds
            && self.found.len() == self.asked.len()
            && self.found.iter().zip(&self.asked).all(|(found, asked)| {
                found.pair == asked.pair && found.axis == asked.axis && found.lo == asked.lo && found.slides == asked.slides
            })
            && self.awake.iter().all(|&body| {
                let i = body as usize;
                !self.in_contact[i] || bits(self.free[i]) == bits(self.asked_free[i])
            })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::{BodyDef, candidates::Pair};

    /// What `face` answers is what the network answers, to the bit.
    #[test]
    fn a_body_on_one_face_has_the_same_answer_directly_and_by_the_network() {
        let mut seed = 3u64;
        let mut random = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / (1u64 << 53) as f64
        };
        let mut moved = 0;
        for _ in 0..5000 {
            let bodies = [Body::new(&BodyDef { mass: 0.1 + 10.0 * random(), ..BodyDef::default() })];
            let free = [DVec2::new(20.0 * random() - 10.0, if random() < 0.1 { 0.0 } else { 30.0 * random() - 15.0 })];
            let (lo, hi) = if random() < 0.5 { (0, 1) } else { (1, 0) };
            let mut direct = [Contact {
                pair: Pair { a: 0, b: 1 },
                axis: usize::from(random() < 0.7),
                lo,
                hi,
                static_friction: random(),
                kinetic_friction: 0.0,
                closed: true,
                clings: false,
                lossy_hits: 0,
                slides: (3.0 * random()).floor() - 1.0,
                normal: 0.0,
                friction: 0.0,
            }];
            direct[0].kinetic_friction = direct[0].static_friction * random();
            let mut network = direct;
            let (mut by_face, mut by_network) = ([DVec2::NAN], [DVec2::NAN]);
            let mut reactions = Reactions::default();
            reactions.accelerate(&mut direct, &bodies, 2, &free, &mut by_face);
            reactions.accelerate_group(&mut network, &bodies, 2, &free, &mut by_network);
            assert_eq!(by_face, by_network, "{direct:?} {network:?}");
            let found = |[contact]: [Contact; 1]| [contact.normal, contact.friction, contact.slides];
            assert_eq!(found(direct), found(network));
            moved += u32::from(by_face[0] != DVec2::ZERO);
        }
        assert!((1000..4900).contains(&moved), "{moved}");
    }
}
