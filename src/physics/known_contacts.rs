//! Contacts from tick to tick: those that a tick has found take the place of those known before, in one order.

use crate::physics::data::contact::Contact;
use crate::physics::store::motions::Method;
use crate::physics::world::World;

impl World {
    /// Puts the contacts that this tick has found in place of those known before of the same bodies. Sleeping bodies keep theirs.
    pub(crate) fn take_contacts(&mut self) {
        let Self { state, scratch, space, .. } = self;
        if state.contacts.is_empty() && scratch.fresh.is_empty() {
            return;
        }
        put_in_order(&mut scratch.fresh);
        scratch.index(state);
        let advanced = |body: u32| space.motions.bodies[body as usize].method != Method::Flight;
        let over = |body: u32| !space.sleep.sleeps(body as usize) || advanced(body);
        let of = |body: u32| scratch.starts[body as usize] as usize..scratch.starts[body as usize + 1] as usize;
        let before: usize = space.sleep.looked_at().iter().filter(|body| over(**body)).map(|body| of(*body).len()).sum();
        // Where the same touch as before, each takes the place of its own.
        let alike = |new: &[Contact]| {
            let old = &state.contacts[of(new[0].ends().0)];
            old.len() == new.len() && old.iter().zip(new).all(|(old, new)| (old.lo, old.hi, old.axis) == (new.lo, new.hi, new.axis))
        };
        let by_body = |a: &Contact, b: &Contact| a.ends().0 == b.ends().0;
        if before == scratch.fresh.len() && scratch.fresh.chunk_by(by_body).all(alike) {
            for new in scratch.fresh.chunk_by(by_body) {
                state.contacts[of(new[0].ends().0)].copy_from_slice(new);
            }
            return;
        }
        state.contacts.retain(|contact| !over(contact.ends().0));
        let sorted = state.contacts.is_empty();
        state.contacts.extend_from_slice(&scratch.fresh);
        if !sorted {
            put_in_order(&mut state.contacts);
        }
        scratch.starts.clear();
    }
}

/// Sorts contacts by their ends, and makes one of those at the same face: the crowd step lists push and friction apart. No order is left
/// to how a sort treats equals, which depends on their number in the world.
fn put_in_order(contacts: &mut Vec<Contact>) {
    contacts.sort_unstable_by(|a, b| {
        let face = (a.ends(), a.axis).cmp(&(b.ends(), b.axis));
        face.then(b.normal.total_cmp(&a.normal)).then(a.friction.total_cmp(&b.friction)).then(a.lo.cmp(&b.lo))
    });
    contacts.dedup_by(|next, kept| {
        let turned = next.lo != kept.lo;
        let joins = next.ends() == kept.ends() && next.axis == kept.axis && (!turned || next.normal == 0.0);
        if joins {
            kept.normal += next.normal;
            kept.friction += if turned { -next.friction } else { next.friction };
        }
        joins
    });
}
