//! Linked bodies fly together: the embedded Runge–Kutta pair of [`crate::physics::flight::steps`] over all of a group.

use crate::physics::data::{Aabb, Body, LINKED_TOLERANCE, Pose, parabola};
use crate::physics::flight::steps::{ERROR, STAGES, step_factor};
use crate::physics::forces::{Law, LinkDef, Media};
use glam::DVec2;

#[derive(Clone, Debug)]
pub(crate) struct Linked {
    pub id: u32,
    /// Contacts hold it: it stays, and the others fly around it.
    pub held: bool,
    pub law: Law,
    pub pose: Pose,
    /// The mean force of its links over the tick, N.
    pub mean: DVec2,
    pub places: Aabb,
    /// Of each stage: velocity, acceleration, and the force of its links.
    stages: [[DVec2; 3]; 7],
    at: Pose,
}

impl Linked {
    pub fn new(body: &Body, id: u32, held: bool, law: Law) -> Self {
        let (pose, places) = ((body.position, body.velocity), Aabb::around(body.position, DVec2::ZERO));
        Self { id, held, law, pose, mean: DVec2::ZERO, places, stages: [[DVec2::ZERO; 3]; 7], at: pose }
    }

    fn sum(&self, part: usize, weights: &[f64]) -> DVec2 {
        self.stages.iter().zip(weights).fold(DVec2::ZERO, |sum, (stage, weight)| sum + stage[part] * *weight)
    }

    fn error(&self, h: f64) -> f64 {
        let error = (self.sum(0, &ERROR) * h).abs().max((self.sum(1, &ERROR) * (h * h)).abs()).max_element();
        error / (LINKED_TOLERANCE + 8.0 * f64::EPSILON * self.pose.0.abs().max_element())
    }
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct LinkedBodies<'a> {
    pub media: &'a Media,
    pub bodies: &'a [Body],
    pub links: &'a [LinkDef],
}

impl LinkedBodies<'_> {
    pub fn fly(&self, members: &mut [Linked], t: f64) {
        self.pull(members, 0);
        let (mut left, mut h) = (t, t);
        // A group that needs more steps flies on without its links.
        for _ in 0..4096 {
            if left <= 0.0 {
                break;
            }
            h = h.min(left);
            let error = self.step(members, h);
            if error > 1.0 && h > t * f64::EPSILON || !error.is_finite() {
                h *= step_factor(error.sqrt().sqrt()).min(0.5);
                continue;
            }
            for member in members.iter_mut() {
                member.mean += member.sum(2, STAGES[5]) * (h / t);
                (member.pose, member.stages[0]) = (member.at, member.stages[6]);
                member.places = member.places.union(&Aabb::around(member.pose.0, DVec2::ZERO));
            }
            left -= h;
            h *= step_factor(error.sqrt().sqrt());
        }
        if left > 0.0 {
            self.media.end_early();
            for member in members.iter_mut().filter(|member| !member.held) {
                member.pose = parabola(member.pose, member.law.constant, left);
                member.places = member.places.union(&Aabb::around(member.pose.0, DVec2::ZERO));
            }
        }
    }

    /// One step of `h` seconds. Returns its error as a part of the error allowed.
    fn step(&self, members: &mut [Linked], h: f64) -> f64 {
        for (stage, weights) in (1..).zip(STAGES) {
            for member in members.iter_mut().filter(|member| !member.held) {
                let (x, v) = member.pose;
                member.at = (x + member.sum(0, weights) * h, v + member.sum(1, weights) * h);
            }
            self.pull(members, stage);
        }
        members.iter().filter(|member| !member.held).map(|member| member.error(h)).fold(0.0, f64::max)
    }

    /// The velocities, accelerations and forces of a stage, where the members are.
    fn pull(&self, members: &mut [Linked], stage: usize) {
        members.iter_mut().for_each(|member| member.stages[stage] = [member.at.1, DVec2::ZERO, DVec2::ZERO]);
        for link in self.links {
            let find = |id: u32| members.binary_search_by_key(&id, |member| member.id);
            let Ok(first) = find(link.body.0) else { continue };
            let force = link.on(link.body.0, |id| find(id).map_or((DVec2::ZERO, DVec2::ZERO), |at| members[at].at));
            let other = link.other().and_then(|other| find(other.0).ok());
            members[first].stages[stage][2] += force;
            if let Some(other) = other {
                members[other].stages[stage][2] -= force;
            }
        }
        for member in members.iter_mut().filter(|member| !member.held) {
            let body = &self.bodies[member.id as usize];
            let pull = self.media.acceleration(body, &member.law, member.at.0, member.at.1);
            member.stages[stage][1] = pull + member.stages[stage][2] / body.mass;
        }
    }
}
