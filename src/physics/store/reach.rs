//! Where a hit throws a body further than contacts were looked for.
//!
//! What the body sweeps is widened on the spot. Whom it may meet then, and is of its island, is added to the island's pairs; most
//! often there is nobody, and nothing has to be solved again. Only what may meet another island makes islands be found anew.

use crate::physics::store::bodies::Bodies;
use crate::physics::store::islands::{Island, apart};
use crate::physics::store::neighbours::Neighbours;

/// What was widened while an island was solved.
#[derive(Clone, Debug, Default)]
pub(crate) struct Reach {
    /// Pairs that were added: the upper body, and a member below it or a surface; in the order of the island.
    pub added: Vec<(u32, u32)>,
    /// Those of the body that was widened last.
    pub new: Vec<(u32, u32)>,
    /// Who may meet others than those of its island.
    pub strangers: Vec<u32>,
}

impl Reach {
    /// Begins with an island.
    pub fn clear(&mut self) {
        self.added.clear();
        self.new.clear();
        self.strangers.clear();
    }

    /// Widens what body i sweeps to where it is predicted, and tells in `new` whom it may meet besides. If that is another island,
    /// the body is a stranger, and if islands may not grow any more (`last`), it stays within what it swept.
    pub fn widen(&mut self, bodies: &mut Bodies, neighbours: &mut Neighbours, island: Island<'_>, i: usize, last: bool) {
        let (n, before) = (bodies.len(), bodies.swept[i]);
        self.new.clear();
        bodies.widen(i);
        let mut strange = false;
        for &j in neighbours.reach(bodies, i) {
            if apart(&bodies.swept[i], &bodies.swept[j as usize]) {
                continue;
            }
            if (j as usize) < n && !island.joins(i, j as usize) {
                strange = true;
                continue;
            }
            let (mine, other) = (i as u32, j);
            let turned = (j as usize) < n && island.order_of(other) > island.order_of(mine);
            let (upper, lower) = if turned { (other, mine) } else { (mine, other) };
            if !island.near(upper).contains(&lower) && !self.added.contains(&(upper, lower)) {
                self.new.push((upper, lower));
            }
        }
        if strange && last {
            bodies.swept[i] = before;
            self.new.clear();
            return;
        }
        if strange {
            self.strangers.push(i as u32);
        }
        let order = |pair: &(u32, u32)| (island.order_of(pair.0), island.order_of(pair.1));
        self.new.sort_unstable_by_key(order);
        if !self.new.is_empty() {
            self.added.extend_from_slice(&self.new);
            self.added.sort_unstable_by_key(order);
        }
    }
}
