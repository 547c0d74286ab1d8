//! Loads along gravity: which supports bear a body, and the share of its load on each.

use crate::physics::crowd::{bodies::Bodies, contacts::Contacts, contacts::CrowdContact, gravity::Anchors};

impl Contacts {
    pub fn closes(bodies: &Bodies, contact: &CrowdContact, slack: f64) -> bool {
        let (first, second) = (contact.first as usize, contact.second as usize);
        contact.live && (bodies[first].mean.y - bodies[second].mean.y - contact.bound).abs() <= slack
    }

    /// Adds up loads top-down, N·s: each body hands its own on in equal shares to the supports that it presses and that the ground carries, and
    /// each share to `give`. Hanging bodies hand on nothing.
    pub fn hand_down(&self, bodies: &Bodies, anchors: &Anchors, loads: &mut [f64], mut give: impl FnMut(u32, u32, f64)) {
        let slack = self.tolerances.hair / anchors.bounces.dt;
        for i in (0..bodies.len()).rev() {
            let load = loads[i];
            if load <= 0.0 || (anchors.any_hung && anchors.hung[i].is_some()) {
                continue;
            }
            let bears = |stack: &&CrowdContact| anchors.held[stack.second as usize] && Self::closes(bodies, stack, slack);
            let under = || self.stacks[self.under(i)].iter().filter(bears);
            let share = load / under().count() as f64;
            for stack in under() {
                if let Some(below) = loads.get_mut(stack.second as usize) {
                    *below += share;
                }
                give(i as u32, stack.second, share);
            }
        }
    }
}
