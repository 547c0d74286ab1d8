//! A crowd step of an island: solved with the members that are looked at, and again with more until nobody else is concerned.

use crate::physics::crowd::bodies::{Bodies, Frame, Group, Origin};
use crate::physics::crowd::dense::{CrowdEnd, Dense, StepSize};
use crate::physics::crowd::settled::Settled;
use crate::physics::store::islands::Island;

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
