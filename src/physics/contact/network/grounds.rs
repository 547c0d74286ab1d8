//! Ground that moves: alike, or a block is held against one of its grounds and its links to the others are set aside.

use crate::physics::contact::network::{Block, Carries, GROUND, Network, NetworkNode, Side};

impl Network {
    /// The acceleration of all ground, if it moves alike; else 0.
    pub(super) fn common_frame(&mut self) -> f64 {
        let mut grounds = self.links.iter().filter(|link| link.lo == GROUND || link.hi == GROUND).map(|link| link.ground);
        let first = grounds.next().unwrap_or(0.0);
        self.grounds_move_alike = grounds.all(|ground| ground == first);
        if self.grounds_move_alike { first } else { 0.0 }
    }

    /// A node without links stays outside: its small force could be lost to rounding in that frame.
    pub(super) fn enter_frame(&mut self, frame: f64) {
        if frame != 0.0 {
            self.linked_nodes().for_each(|node| node.force -= node.mass * frame);
            self.links.iter_mut().for_each(|link| link.ground = 0.0);
        }
    }

    /// The way back: a tie that slips on the ground is asked for its direction, so the ground moves again, too.
    pub(super) fn leave_frame(&mut self, frame: f64) {
        if frame != 0.0 {
            self.linked_nodes().for_each(|node| node.acceleration += frame);
            self.links.iter_mut().for_each(|link| link.ground = frame);
        }
    }

    fn linked_nodes(&mut self) -> impl Iterator<Item = &mut NetworkNode> {
        let incident = &self.incident;
        self.nodes.iter_mut().enumerate().filter(|(i, _)| !incident.of(*i).is_empty()).map(|(_, node)| node)
    }

    /// Sets the links aside (`cut`) that lead to other ground than `ground`. Returns whether there are any.
    pub(super) fn part_with_other_grounds(&mut self, block: Block, ground: f64) -> bool {
        let mut any = false;
        for &i in &self.order[block.begin..block.end] {
            for &index in self.incident.of(i as usize) {
                let link = &mut self.links[index as usize];
                if !link.cut && link.other(i) == GROUND && link.ground != ground {
                    (link.cut, any) = (true, true);
                    self.aside.push(index);
                }
            }
        }
        any
    }

    /// Adds the action of the grounds set aside at the acceleration `held`: ties drag with their limit, pushes are larger than all else together.
    pub(super) fn pull_by_other_grounds(&mut self, block: Block, held: f64) {
        let (mut all, mut mass) = (0.0, 0.0);
        for &i in &self.order[block.begin..block.end] {
            all += self.notes[i as usize].excess.abs();
            mass += self.nodes[i as usize].mass;
            for link in self.links_of(i) {
                if let Carries::UpTo(limit) = link.carries {
                    all += if limit.is_finite() { limit } else { 0.0 };
                }
            }
        }
        for k in 0..self.aside.len() {
            let link = &mut self.links[self.aside[k] as usize];
            let node = link.other(GROUND);
            let ahead = (link.ground - held).signum();
            let side = if link.lo == GROUND { 1.0 } else { -1.0 };
            let drag = match link.carries {
                Carries::UpTo(limit) if limit.is_finite() => limit,
                Carries::Push if ahead != side => 0.0,
                // Four times all that can hold; where nothing else acts, all is what the block's own inertia asks for.
                Carries::Push | Carries::UpTo(_) => 4.0 * (all + mass * (link.ground - held).abs()),
            };
            link.flow = side * ahead * drag;
            self.notes[node as usize].excess += ahead * drag;
        }
    }

    /// Lets a link that has been cut pass on a force that stays.
    pub(super) fn pass_on(&mut self, index: usize, flow: f64) {
        let link = &mut self.links[index];
        link.flow = flow;
        for (end, sign) in [(link.lo, -1.0), (link.hi, 1.0)] {
            if end != GROUND {
                self.nodes[end as usize].force += sign * flow;
            }
        }
    }

    /// Grounds set aside on whose side a node ended up may hold it; the others drag or have let go. Returns the side of a node squeezed between two.
    pub(super) fn settle_other_grounds(&mut self, held: f64) -> Option<Side> {
        let mut squeezed = None;
        for k in 0..self.aside.len() {
            let index = self.aside[k] as usize;
            let link = self.links[index];
            let node = link.other(GROUND);
            let (mine, its) = (self.notes[node as usize].side, side_of(link.ground, held));
            if mine == its {
                (self.links[index].cut, self.links[index].flow) = (false, 0.0);
                continue;
            }
            match link.carries {
                Carries::UpTo(limit) if limit.is_finite() => self.pass_on(index, link.flow),
                Carries::Push | Carries::UpTo(_) => {
                    if link.flow != 0.0 {
                        squeezed = Some(mine);
                    }
                    self.links[index].flow = 0.0;
                }
            }
        }
        self.aside.clear();
        squeezed
    }
}

/// On which side of a block that is held at `held` a ground moves.
pub(super) fn side_of(ground: f64, held: f64) -> Side {
    if ground > held {
        Side::Faster
    } else if ground < held {
        Side::Slower
    } else {
        Side::Same
    }
}
