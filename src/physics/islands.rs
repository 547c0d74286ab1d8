//! Islands: bodies that could meet within a tick, sought on the boxes that they may sweep.
//!
//! Boxes are sorted by their left edges and swept; what overlaps is joined. Surfaces join nothing: they move for nobody. What rests does not
//! join what rests; but what comes near one of a resting group finds all of it, since it is joined by contacts.

use super::Aabb;
use super::contact::Contact;

/// The islands of a tick.
#[derive(Clone, Debug, Default)]
pub(super) struct Islands {
    by_left_edge: Vec<u32>,
    leader: Vec<u32>,
    /// Bodies by island: the smallest body of each, and one of its members, in ascending order.
    pub members: Vec<(u32, u32)>,
}

impl Islands {
    /// Finds the islands among bodies that sweep `boxes`, of which some `rest`, joined by `contacts`. Resting bodies that nothing comes near
    /// are in none.
    pub fn find(&mut self, boxes: &[Aabb], rest: &[bool], contacts: &[Contact]) {
        let n = boxes.len();
        self.leader.clear();
        self.leader.extend(0..n as u32);
        if self.by_left_edge.len() != n {
            self.by_left_edge.clear();
            self.by_left_edge.extend(0..n as u32);
        }
        self.by_left_edge.sort_unstable_by(|&i, &j| boxes[i as usize].min.x.total_cmp(&boxes[j as usize].min.x).then(i.cmp(&j)));
        for contact in contacts {
            if (contact.lo.max(contact.hi) as usize) < n {
                self.join(contact.lo, contact.hi);
            }
        }
        for at in 0..n {
            let i = self.by_left_edge[at];
            for next in at + 1..n {
                let j = self.by_left_edge[next];
                let (a, b) = (&boxes[i as usize], &boxes[j as usize]);
                if b.min.x > a.max.x {
                    break;
                }
                if a.touches(b, 0.0) && !(rest[i as usize] && rest[j as usize]) {
                    self.join(i, j);
                }
            }
        }
        self.members.clear();
        for i in 0..n as u32 {
            let leader = self.leader_of(i);
            self.members.push((leader, i));
        }
        self.members.sort_unstable();
        // A group of which all rest is no island.
        let mut kept = 0;
        let mut at = 0;
        while at < self.members.len() {
            let end = at + self.members[at..].iter().take_while(|member| member.0 == self.members[at].0).count();
            if self.members[at..end].iter().any(|member| !rest[member.1 as usize]) {
                self.members.copy_within(at..end, kept);
                kept += end - at;
            }
            at = end;
        }
        self.members.truncate(kept);
    }

    fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.leader_of(a), self.leader_of(b));
        self.leader[a.max(b) as usize] = a.min(b);
    }

    fn leader_of(&mut self, mut body: u32) -> u32 {
        while self.leader[body as usize] != body {
            self.leader[body as usize] = self.leader[self.leader[body as usize] as usize];
            body = self.leader[body as usize];
        }
        body
    }
}
