//! One pass of loads along the axis: a pile at rest and a pushed row settle in it; `routing` would come to the same.

use crate::physics::contact::network::{Block, Carries, GROUND, Network, NetworkEdge};

impl Network {
    /// Every body hands its excess on to the bodies (or the ground) that it presses against, in equal shares, once it has got all of its own
    /// (Kahn's order). Returns whether that settles the block: no contact would have to pull.
    pub(super) fn passes(&mut self, block: Block, upwards: bool) -> bool {
        self.reset_flows(block);
        let tolerance = block.tolerance();
        let sign = if upwards { 1.0 } else { -1.0 };
        let presses = |link: &NetworkEdge, i: u32| {
            !link.cut && link.carries == Carries::Push && (if upwards { link.lo } else { link.hi }) == i
        };
        self.queue.clear();
        for at in block.begin..block.end {
            let i = self.order[at];
            let bearing = self.links_of(i).filter(|&slot| {
                let link = &self.links[self.incident.list[slot] as usize];
                let from = link.other(i);
                from != GROUND && presses(link, from)
            });
            self.notes[i as usize].waits_for = bearing.count() as u32;
            if self.notes[i as usize].waits_for == 0 {
                self.queue.push(i);
            }
        }
        let mut next = 0;
        while next < self.queue.len() {
            let i = self.queue[next];
            next += 1;
            let load = sign * self.notes[i as usize].excess;
            if load < -tolerance {
                return false;
            }
            let range = self.links_of(i);
            let supports = range.clone().filter(|&slot| presses(&self.links[self.incident.list[slot] as usize], i)).count();
            if supports == 0 {
                if load > tolerance {
                    return false;
                }
                continue;
            }
            let share = load.max(0.0) / supports as f64;
            for slot in range {
                let link = &mut self.links[self.incident.list[slot] as usize];
                if presses(link, i) {
                    link.flow = share;
                    let other = link.other(i);
                    if other != GROUND {
                        self.notes[other as usize].excess += sign * share;
                        self.notes[other as usize].waits_for -= 1;
                        if self.notes[other as usize].waits_for == 0 {
                            self.queue.push(other);
                        }
                    }
                }
            }
        }
        self.queue.len() == block.end - block.begin
    }
}
