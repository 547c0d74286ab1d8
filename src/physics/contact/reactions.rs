//! Contact forces: each axis a network solved exactly, coupled by Coulomb's law, gravity's first. With velocities it is the perfectly plastic impact.

use crate::physics::contact::axis::{Joined, Parts, Question, ground};
use crate::physics::data::{Contact, FORCE_TOLERANCE, FRICTION_ROUNDS, first, on_axis};
use glam::DVec2;

#[derive(Clone, Debug, Default)]
pub(crate) struct Reactions {
    pub joined: Joined,
    /// The union–find forest of the bodies, and the contacts by group.
    leader: Vec<u32>,
    by_group: Vec<(u32, u32)>,
    group: Vec<Contact>,
    /// The push of each contact one and two rounds ago, N.
    pressed: Vec<f64>,
    pressed_before: Vec<f64>,
    /// Of the last solution along each axis and each contact: its push, and which way it slid.
    solutions: [Vec<(f64, f64)>; 2],
    pub unsettled: u64,
    /// Bodies that rounds have solved so far, each as often as rounds have.
    pub solved: u64,
}

impl Reactions {
    /// Accelerations of bodies in contact, m/s²; the contacts get their forces. No group's answer depends on another's.
    pub fn accelerate(&mut self, contacts: &mut [Contact], parts: &Parts, out: &mut [DVec2]) {
        self.joined.squeezed.clear();
        if contacts.is_empty() {
            return;
        }
        if let [contact] = contacts
            && contact.ends().1 as usize >= parts.masses.len()
        {
            let body = contact.ends().0 as usize;
            let ground = parts.free[contact.other(body as u32) as usize];
            if let Some(a) = press_on_face(contact, parts.masses[body], parts.free[body] - ground, contact.hi as usize == body) {
                out[body] = a + ground;
                return;
            }
        }
        if contacts.len() == 1 || self.find_groups(contacts, parts.masses.len()) == 1 {
            return self.accelerate_group(contacts, parts, out);
        }
        let mut group = std::mem::take(&mut self.group);
        let by_group = std::mem::take(&mut self.by_group);
        for members in by_group.chunk_by(|a, b| a.0 == b.0) {
            group.clear();
            group.extend(members.iter().map(|&(_, index)| contacts[index as usize]));
            self.accelerate_group(&mut group, parts, out);
            members.iter().zip(&group).for_each(|(&(_, index), &contact)| contacts[index as usize] = contact);
        }
        (self.group, self.by_group) = (group, by_group);
    }

    /// Lists each contact with its group in `by_group`, group by group. Returns how many groups there are. Surfaces join nothing.
    fn find_groups(&mut self, contacts: &[Contact], bodies: usize) -> usize {
        let leader = &mut self.leader;
        leader.clear();
        leader.extend(0..bodies as u32);
        for contact in contacts {
            if (contact.lo.max(contact.hi) as usize) < bodies {
                let (a, b) = (first(leader, contact.lo as usize), first(leader, contact.hi as usize));
                leader[a.max(b)] = a.min(b) as u32;
            }
        }
        self.by_group.clear();
        self.by_group.extend(contacts.iter().map(|contact: &Contact| first(leader, contact.ends().0 as usize) as u32).zip(0..));
        if self.by_group.iter().all(|&(group, _)| group == self.by_group[0].0) {
            return 1;
        }
        self.by_group.sort_unstable();
        self.by_group.chunk_by(|a, b| a.0 == b.0).count()
    }

    /// One group. Rounds begin again with the contacts that are known to slide, so that asking again gives the same last bits.
    fn accelerate_group(&mut self, contacts: &mut [Contact], parts: &Parts, out: &mut [DVec2]) {
        self.joined.number(contacts, parts);
        // After eight passes a stack between walls rubs less than it could.
        for _ in 0..8 {
            let rounds = self.couple_axes(contacts, parts, out);
            let again = rounds != Some(1) && contacts.iter().any(|contact| contact.gave_way);
            match rounds {
                _ if again => {}
                Some(_) => return,
                None => break,
            }
        }
        self.yield_friction(contacts, parts, out);
    }

    /// The rounds between the two axes. Returns how many it took; none where they did not settle.
    fn couple_axes(&mut self, contacts: &mut [Contact], parts: &Parts, out: &mut [DVec2]) -> Option<u32> {
        self.joined.body_of.iter().for_each(|body| out[*body as usize] = parts.free[*body as usize]);
        contacts.iter_mut().for_each(|contact| (contact.begun, contact.gave_way) = (contact.normal, false));
        self.pressed.clear();
        self.solutions.iter_mut().for_each(Vec::clear);
        for round in 0..FRICTION_ROUNDS {
            std::mem::swap(&mut self.pressed, &mut self.pressed_before);
            self.pressed.clear();
            self.pressed.extend(contacts.iter().map(|contact| contact.normal));
            self.solve_axes(contacts, parts, out);
            if round + 1 < FRICTION_ROUNDS && hold_back(contacts, parts, out) {
                continue;
            }
            // The pressure on a wall matters only where a body moves along it, or hangs on it by more than that holds.
            let rubs = |contact: &Contact| {
                let moves = || contact.slides != 0.0 || gain(contact, parts, out) != 0.0;
                let hangs = contact.friction.abs() > contact.static_friction * contact.normal;
                hangs || (contact.friction != 0.0 || contact.normal > 0.0) && moves()
            };
            if self.presses_alike(contacts, f64::EPSILON, 0.0, rubs) {
                return Some(round + 1);
            }
            if round % 3 == 2 && round + 1 < FRICTION_ROUNDS {
                self.extrapolate(contacts);
            }
        }
        // A pressure that changes by 1e-10 of itself has settled: more would exceed Coulomb's law, less would be rounding.
        let most = contacts.iter().fold(0.0, |most: f64, contact| most.max(contact.normal));
        self.presses_alike(contacts, 1e-10, FORCE_TOLERANCE * most, |_| true).then_some(FRICTION_ROUNDS)
    }

    /// Whether no pressure across that matters has changed in the last round by more than a part of itself and a force, N.
    fn presses_alike(&self, contacts: &[Contact], part: f64, force: f64, matters: impl Fn(&Contact) -> bool) -> bool {
        let alike = |contact: &Contact, before: f64| (contact.normal - before).abs() <= part * contact.normal + force;
        let settled = |(contact, before): (&Contact, &f64)| contact.axis == 1 || alike(contact, *before) || !matters(contact);
        contacts.iter().zip(&self.pressed).all(settled)
    }

    fn solve_axes(&mut self, contacts: &mut [Contact], parts: &Parts, out: &mut [DVec2]) {
        self.solved += self.joined.body_of.len() as u64;
        for axis in [1, 0] {
            if self.is_idle(axis, contacts, parts) {
                self.joined.body_of.iter().for_each(|body| out[*body as usize][axis] = 0.0);
                contacts.iter_mut().for_each(|contact| *contact.along(axis) = 0.0);
                self.solutions[axis].clear();
                continue;
            }
            if self.is_solved(axis, contacts) {
                continue;
            }
            self.joined.solve_axis(axis, contacts, parts, Question::Forces);
            self.joined.give(axis, out);
            let solution = &mut self.solutions[axis];
            solution.clear();
            solution.extend(contacts.iter().map(|contact| (contact.normal, contact.slides)));
        }
    }

    /// Whether the last solution along an axis holds: it depends on the pushes along the other, and on what slides. The contacts have it then.
    fn is_solved(&self, axis: usize, contacts: &mut [Contact]) -> bool {
        let solution = &self.solutions[axis];
        let alike = |(contact, known): (&Contact, &(f64, f64))| contact.axis == axis || (contact.normal, contact.slides) == *known;
        let holds = solution.len() == contacts.len() && contacts.iter().zip(solution).all(alike);
        if holds {
            contacts.iter_mut().zip(solution).for_each(|(contact, known)| contact.normal = known.0);
        }
        holds
    }

    fn is_idle(&self, axis: usize, contacts: &[Contact], parts: &Parts) -> bool {
        let rests = |contact: &Contact| (contact.axis == axis || contact.slides == 0.0) && ground(contact, parts, axis, 0.0) == 0.0;
        self.joined.body_of.iter().all(|body| parts.free[*body as usize][axis] == 0.0) && contacts.iter().all(rests)
    }

    /// Where rounds do not settle, because a wall can carry its load in several ways: limits of friction on walls follow pressures downwards only,
    /// and are 0 where that does not end either. Friction stays inside its cone; some contacts rub less than they could.
    fn yield_friction(&mut self, contacts: &mut [Contact], parts: &Parts, out: &mut [DVec2]) {
        self.unsettled += 1;
        for round in 0.. {
            self.pressed.clear();
            self.pressed.extend(contacts.iter().map(|contact| contact.normal));
            self.solve_axes(contacts, parts, out);
            let lacks = |contact: &Contact, taken: f64| contact.axis == 0 && contact.normal < taken * (1.0 - FORCE_TOLERANCE);
            if !contacts.iter().zip(&self.pressed).any(|(contact, taken)| lacks(contact, *taken)) {
                return;
            }
            for (contact, &taken) in contacts.iter_mut().zip(&self.pressed) {
                contact.normal = match lacks(contact, taken) {
                    true if round >= FRICTION_ROUNDS => 0.0,
                    true => contact.normal,
                    false => taken,
                };
            }
        }
    }

    /// Aitken's Δ²: rounds between two faces come nearer to their answer by the same factor each time.
    fn extrapolate(&self, contacts: &mut [Contact]) {
        for ((contact, now), before) in contacts.iter_mut().zip(&self.pressed).zip(&self.pressed_before) {
            let (step, last) = (contact.normal - now, now - before);
            let factor = step / last;
            if contact.axis == 0 && factor.abs() < 1.0 {
                contact.normal = (contact.normal + step * factor / (1.0 - factor)).max(0.0);
            }
        }
    }

    /// Velocities after a perfectly plastic collision with friction up to μ_k times the normal impulse; contacts get impulses, N·s.
    pub fn collide(&mut self, contacts: &mut [Contact], parts: &Parts, velocities: &mut [DVec2]) {
        self.joined.squeezed.clear();
        self.joined.number(contacts, parts);
        contacts.iter_mut().for_each(|contact| contact.normal = 0.0);
        for axis in [1, 0, 1] {
            self.joined.solve_axis(axis, contacts, parts, Question::Impulses);
            self.joined.give(axis, velocities);
        }
    }
}

/// Lets contacts stick again that gave way too early and that friction would drive back. Returns whether there are any.
fn hold_back(contacts: &mut [Contact], parts: &Parts, accelerations: &[DVec2]) -> bool {
    let mut any = false;
    for contact in contacts {
        if contact.gave_way && contact.slides * gain(contact, parts, accelerations) < 0.0 {
            (contact.slides, contact.gave_way, any) = (0.0, false, true);
        }
    }
    any
}

/// How fast `hi` gains on `lo` along the contact's face, m/s².
fn gain(contact: &Contact, parts: &Parts, accelerations: &[DVec2]) -> f64 {
    let along = 1 - contact.axis;
    let of = |item: u32| if (item as usize) < parts.masses.len() { accelerations } else { parts.free }[item as usize][along];
    of(contact.hi) - of(contact.lo)
}

/// Sets Reaction and Friction of a contact between a body of `mass` (kg, along each axis) and a face. Returns its acceleration from the `free` one,
/// m/s², both as seen from the face; none, and nothing done, where it does not press or nothing draws it along a wall.
fn press_on_face(contact: &mut Contact, mass: DVec2, free: DVec2, body_is_hi: bool) -> Option<DVec2> {
    let (axis, along) = (contact.axis, 1 - contact.axis);
    let away = if body_is_hi { 1.0 } else { -1.0 };
    let normal = -away * (mass[axis] * free[axis]);
    if normal <= 0.0 || (axis == 0 && free[along] == 0.0) {
        return None;
    }
    contact.normal = normal;
    let force = mass[along] * free[along];
    if contact.slides == 0.0 {
        let limit = contact.static_friction * normal;
        if force.abs() - limit <= force.abs() * FORCE_TOLERANCE {
            contact.friction = -away * force.signum() * force.abs().min(limit) + 0.0;
            return Some(DVec2::ZERO);
        }
        contact.slides = away * force.signum();
    }
    contact.friction = -contact.slides * (contact.kinetic_friction * normal);
    Some(on_axis(axis, 0.0, (force + away * contact.friction) / mass[along]))
}

#[cfg(test)]
mod tests;
