//! A second look: the contacts of what a hit threw further than was looked for.
//!
//! Contacts are sought on the ways that the bodies would go if they touched nothing. A body that a hit throws elsewhere may meet
//! others there: what it sweeps is widened, and its contacts with whatever it did not come near before are added to the rest,
//! which stay as they are. After that the step is solved again, from the same start. One pass over the neighbours, of which only
//! those of the thrown are looked at.

use super::bodies::Bodies;
use super::contacts::{Contacts, Meeting, Stack, apart, meeting};
use super::neighbours::Neighbours;

/// Who was not found where it was expected, and the contacts that follow from it.
#[derive(Clone, Debug, Default)]
pub(super) struct SecondLook {
    /// Whom, and what they swept before.
    thrown: Vec<(u32, [f64; 4])>,
    /// For each body: which of `thrown` it is, and one; 0 if none.
    which: Vec<u32>,
    /// Upper body and contact, bodies in ascending order.
    stacks: Vec<(u32, Stack)>,
}

impl SecondLook {
    pub fn new(all: usize) -> Self {
        Self { thrown: Vec::with_capacity(all), which: vec![0; all], stacks: Vec::with_capacity(all) }
    }

    /// Collects whom the contacts do not cover where it is predicted.
    pub fn collect(&mut self, bodies: &Bodies, contacts: &Contacts) {
        self.thrown.clear();
        for i in 0..bodies.len() {
            if !contacts.covers(bodies, i) {
                self.thrown.push((i as u32, contacts.swept[i]));
            }
        }
    }

    /// Adds the contacts of the thrown bodies on their new ways; `known` is how many neighbours had been added when contacts were
    /// sought before. Returns false if bodies must be renumbered first.
    pub fn add(&mut self, bodies: &Bodies, neighbours: &Neighbours, known: usize, contacts: &mut Contacts, dt: f64) -> bool {
        for (k, (i, _)) in self.thrown.iter().enumerate() {
            contacts.widen(bodies, *i as usize);
            self.which[*i as usize] = k as u32 + 1;
        }
        let in_order = self.meet(bodies, neighbours, known, contacts, dt);
        for (i, _) in &self.thrown {
            self.which[*i as usize] = 0;
        }
        if in_order {
            self.insert(contacts);
        }
        in_order
    }

    fn meet(&mut self, bodies: &Bodies, neighbours: &Neighbours, known: usize, contacts: &mut Contacts, dt: f64) -> bool {
        let Self { thrown, which, stacks } = self;
        stacks.clear();
        let before = |contacts: &Contacts, i: usize| match which[i] {
            0 => contacts.swept[i],
            k => thrown[k as usize - 1].1,
        };
        for i in 0..bodies.len() {
            for j in neighbours.of(i) {
                if which[i] == 0 && which[j] == 0 || apart(&contacts.swept[i], &contacts.swept[j]) {
                    continue;
                }
                // What was swept may have met before the two were neighbours.
                if !apart(&before(contacts, i), &before(contacts, j)) && !neighbours.is_new(i, j, known) {
                    continue;
                }
                match meeting(bodies, i, j, dt, 1.0 / dt) {
                    Meeting::Stack(stack) => stacks.push((i as u32, stack)),
                    Meeting::Side(side) => contacts.sides.push(side),
                    Meeting::Ceiling(ceiling) => contacts.ceilings.push(ceiling),
                    Meeting::Inverted => return false,
                }
            }
        }
        true
    }

    /// Puts the found stacks behind those that their upper bodies have.
    fn insert(&self, contacts: &mut Contacts) {
        let Contacts { start, stacks, .. } = contacts;
        let Some(&(_, filler)) = self.stacks.first() else { return };
        let mut end = stacks.len();
        stacks.resize(end + self.stacks.len(), filler);
        let mut above = start.len();
        for (k, (upper, stack)) in self.stacks.iter().enumerate().rev() {
            let next = *upper as usize + 1;
            let at = if next < above { start[next] as usize } else { end };
            stacks.copy_within(at..end, at + k + 1);
            stacks[at + k] = *stack;
            end = at;
            start[next.min(above)..above].iter_mut().for_each(|start| *start += k as u32 + 1);
            above = above.min(next);
        }
    }
}
