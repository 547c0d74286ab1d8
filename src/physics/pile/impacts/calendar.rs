//! Who comes next: a tournament of what each body has found (Knuth, *The Art of Computer Programming* 3, 5.4.1). Each has one entry, which it
//! replaces when it looks ahead again; the earliest is at the root, and a replaced entry is played up to there anew.

use super::NONE;
use super::due::Due;

/// No pair, at no time.
const NOTHING: Due = Due { time: f64::INFINITY, speed: 0.0, pair: NONE, ways: 0, axis: 0 };

/// What the bodies of one island have found, each at most one impact.
#[derive(Clone, Debug, Default)]
pub(super) struct Calendar {
    /// What each body has found, by slot; an infinite time if that is nothing.
    dues: Vec<Due>,
    /// By slot: where a body stands among those that have found something so far; and these, in that order.
    leaf: Vec<u32>,
    finders: Vec<u32>,
    /// The body that comes first of those below, by slot, and when, s: node k is above 2·k and 2·k + 1, and from `leaves` on there is nobody below.
    nodes: Vec<(f64, u32)>,
    leaves: usize,
}

impl Calendar {
    /// Room for `count` bodies.
    pub fn new(count: usize) -> Self {
        Self {
            dues: vec![NOTHING; count],
            leaf: vec![NONE; count],
            finders: Vec::with_capacity(count),
            nodes: Vec::with_capacity(2 * count.next_power_of_two()),
            leaves: 0,
        }
    }

    /// Begins with nobody in it.
    pub fn clear(&mut self) {
        self.finders.clear();
    }

    /// Adds a body that has found nothing yet.
    pub fn enter(&mut self, body: usize) {
        self.leaf[body] = NONE;
        self.dues[body] = NOTHING;
    }

    /// What a body has found; its time is infinite if that is nothing.
    pub fn due(&self, body: usize) -> &Due {
        &self.dues[body]
    }

    /// The bodies that have found something so far, by slot.
    pub fn finders(&self) -> &[u32] {
        &self.finders
    }

    /// Before [`Calendar::open`], a body has found something: it keeps what comes first.
    pub fn offer(&mut self, body: usize, due: Due) {
        if self.leaf[body] == NONE {
            self.find(body);
        }
        self.dues[body] = self.dues[body].max(due);
    }

    /// All know what they have found first.
    pub fn open(&mut self) {
        self.leaves = self.finders.len().next_power_of_two();
        self.play_all();
    }

    /// What comes first of all, and who has found it.
    pub fn first(&self) -> Option<(usize, Due)> {
        let (time, body) = self.nodes[1];
        time.is_finite().then(|| (body as usize, self.dues[body as usize]))
    }

    /// A body has looked ahead anew.
    pub fn replace(&mut self, body: usize, due: Option<Due>) {
        let time = due.map_or(f64::INFINITY, |due| due.time);
        debug_assert!(!time.is_nan(), "an impact at no time: {due:?}");
        self.dues[body] = due.unwrap_or(NOTHING);
        if self.leaf[body] == NONE {
            if due.is_none() {
                return;
            }
            self.find(body);
            if self.finders.len() > self.leaves {
                self.leaves *= 2;
                return self.play_all();
            }
        }
        let mut node = self.leaves + self.leaf[body] as usize;
        self.nodes[node] = (time, body as u32);
        while node > 1 {
            node /= 2;
            self.nodes[node] = self.earlier(node);
        }
    }

    /// A body finds something for the first time.
    fn find(&mut self, body: usize) {
        self.leaf[body] = self.finders.len() as u32;
        self.finders.push(body as u32);
    }

    fn play_all(&mut self) {
        let Self { nodes, leaves, finders, dues, .. } = self;
        nodes.clear();
        nodes.resize(2 * *leaves, (f64::INFINITY, NONE));
        for (node, &body) in nodes[*leaves..].iter_mut().zip(&*finders) {
            *node = (dues[body as usize].time, body);
        }
        for node in (1..self.leaves).rev() {
            self.nodes[node] = self.earlier(node);
        }
    }

    /// The winner below a node.
    #[inline(always)]
    fn earlier(&self, node: usize) -> (f64, u32) {
        let (a, b) = (self.nodes[2 * node], self.nodes[2 * node + 1]);
        let first = if a.0 == b.0 && a.0.is_finite() { self.dues[a.1 as usize] >= self.dues[b.1 as usize] } else { a.0 <= b.0 };
        if first { a } else { b }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    /// Against a search through all, with times that are often the same.
    #[test]
    fn the_first_is_the_earliest_of_all() {
        let mut random = Random(7);
        for count in [1, 2, 5, 64, 100] {
            let mut calendar = Calendar::new(count);
            calendar.clear();
            (0..count).for_each(|body| calendar.enter(body));
            let due = |random: &mut Random, pair: usize| Due {
                time: (random.unit() * 8.0).floor(),
                speed: (random.unit() * 2.0).floor(),
                pair: pair as u32,
                ..NOTHING
            };
            let mut known: Vec<Option<Due>> = (0..count).map(|body| (body % 3 != 0).then(|| due(&mut random, body))).collect();
            for (body, due) in known.iter().enumerate() {
                due.iter().for_each(|due| calendar.offer(body, *due));
            }
            calendar.open();
            for turn in 0..1000 {
                let first = known.iter().flatten().max();
                assert_eq!(calendar.first().map(|(_, due)| due), first.copied(), "{count} bodies, turn {turn}");
                let body = (random.unit() * count as f64) as usize;
                known[body] = (random.unit() < 0.7).then(|| due(&mut random, turn));
                calendar.replace(body, known[body]);
            }
        }
    }
}
