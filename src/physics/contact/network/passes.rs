//! One pass of loads along the axis: a pile at rest and a pushed row settle in it; `routing` would come to the same.

use crate::physics::contact::network::{Block, GROUND, Network, NetworkEdge};

impl Network {
    /// Whether nothing is pulled away from all that it presses against, or would have to be pulled along, by its own excess.
    pub(super) fn may_pass(&self, block: Block, upwards: bool) -> bool {
        let tolerance = block.tolerance();
        self.order[block.begin..block.end].iter().all(|&i| {
            let load = if upwards { self.notes[i as usize].excess } else { -self.notes[i as usize].excess };
            let mut links = self.links_of(i).map(|slot| &self.links[self.incident.list[slot] as usize]);
            let bears = |link: &NetworkEdge| link.other(i) != GROUND && link.hands_on(link.other(i), upwards);
            load.abs() <= tolerance || links.any(|link| if load > 0.0 { link.hands_on(i, upwards) } else { bears(link) })
        })
    }

    /// Each body hands its excess on to what it presses against, in equal shares, once it has got all (Kahn's order). Returns whether none has to pull.
    pub(super) fn passes(&mut self, block: Block, upwards: bool) -> bool {
        let tolerance = block.tolerance();
        let sign = if upwards { 1.0 } else { -1.0 };
        let presses = |link: &NetworkEdge, i: u32| link.hands_on(i, upwards);
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
