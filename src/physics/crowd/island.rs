//! A crowd step of an island: solved with the members that are looked at, and again with more until nobody else is concerned.

use crate::physics::crowd::bodies::{Bodies, Frame, Group, Origin};
use crate::physics::crowd::dense::{CrowdEnd, Dense, IMPACT, StepSize};
use crate::physics::crowd::{contacts::Tolerances, settled::Settled};
use crate::physics::{data::Sides, store::islands::Island};
use glam::DVec2;

#[derive(Clone, Debug)]
pub(crate) struct Crowd {
    pub bodies: Bodies,
    pub dense: Dense,
    pub settled: Settled,
    local: Vec<u32>,
}

impl Crowd {
    pub fn new(n: usize, all: usize) -> Self {
        let mut dense = Dense::default();
        dense.begin(n, all);
        Self { bodies: Bodies::new(all), dense, settled: Settled::new(n), local: vec![0; all] }
    }

    pub fn step(
        &mut self,
        from: Origin<'_>,
        island: Island<'_>,
        size: StepSize,
        mut meets_more: impl FnMut(&Bodies, usize) -> bool,
    ) -> CrowdEnd {
        let Self { bodies, dense, settled, local } = self;
        settled.begin(from, island, dense.report.on);
        loop {
            let part = settled.part_of(island);
            if part.members.is_empty() {
                bodies.clear();
                dense.clear();
                break;
            }
            bodies.gather(from, part, (island.members.len(), settled.largest()), |item| settled.is_settled(item));
            if !dense.report.on && !settled.off && slides_alone(bodies, size) {
                dense.clear();
                break;
            }
            (0..).zip(&bodies.ids).for_each(|(k, id)| local[*id as usize] = k);
            dense.begin(bodies.len(), bodies.things.len());
            if dense.step(bodies, Group { island: part, local }, size, &mut meets_more) == CrowdEnd::Grown {
                // With all members it might not have grown.
                if settled.give_up() {
                    continue;
                }
                return CrowdEnd::Grown;
            }
            if !settled.wake(from, island, bodies, dense) {
                break;
            }
        }
        settled.note(from.motions, island, bodies, dense);
        CrowdEnd::Done
    }

    pub fn finish(&mut self, frame: Frame, solved: impl Fn(u32) -> u32) {
        let Self { bodies, dense, .. } = self;
        let known = dense.report.list.len();
        if dense.report.on {
            dense.record(bodies, frame);
        }
        for contact in &mut dense.report.list[known..] {
            (contact.a, contact.b) = (bodies.ids[contact.a as usize], bodies.ids[contact.b as usize]);
            contact.solved = solved(contact.a);
        }
    }
}

/// Whether the island is one body that slides on one face all step long: then this is its step, in closed form, to the bits of [`Dense::step`].
fn slides_alone(bodies: &mut Bodies, StepSize { dt, gravity, .. }: StepSize) -> bool {
    let [body, face] = bodies.things[..] else { return false };
    let touch = Tolerances::of(bodies).touch;
    let gap = (face.from - body.from).abs() - (body.half + face.half);
    let lies = face.from.y > body.from.y && gap.x < -touch && (0.0..=touch).contains(&gap.y);
    let stands = !face.settled && !bodies.carries(1) && face.sides == Sides::ALL;
    let is_pressed = body.before.y == 0.0 && body.free.y > 0.0 && body.free.y <= IMPACT * gravity * dt;
    if !(lies && stands && is_pressed) || body.guided.is_some() || bodies.meets_air(0) {
        return false;
    }
    let friction = bodies.coefficients(0, 1).kinetic_friction * (body.mass * body.free.y);
    let end = (body.mass * body.free.x - friction.copysign(body.before.x)) / body.mass;
    if body.mass * body.before.x.abs() <= friction || end * body.before.x <= 0.0 {
        return false;
    }
    let mean = (body.to.x - body.from.x) / dt + 0.5 * (end - body.free.x);
    let x = if end == body.free.x { body.to.x } else { body.from.x + dt * mean };
    bodies[0].to = DVec2::new(x, body.from.y);
    bodies[0].end = DVec2::new(end, face.end.y);
    let inside = bodies.is_swept(0);
    if !inside {
        bodies.fall_freely();
    }
    inside
}
