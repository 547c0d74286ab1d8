//! Positions: apart by construction.
//!
//! The ways of the step come from the solution along and across; what rounding, branching islands and passed corners leave is mended
//! here: along gravity what rises stops under what does not make way, top-down, and what falls stops on what carries it, bottom-up,
//! and neither keeps a speed that it gained for a way that it did not go (what nothing pulls gained none, and its momentum stays);
//! across what overlaps is merged ([`crate::physics::crowd::clusters`]), the centre of mass unmoved; and where that is not enough, bodies in conflict
//! are put back to where they were along the contact's axis, for no motion is always allowed.

use crate::physics::crowd::bodies::Bodies;
use crate::physics::crowd::clusters::{Clusters, Motion, Node, Pool};
use crate::physics::crowd::contacts::{Contact, Contacts};
use crate::physics::crowd::gravity::NONE;

/// Moves what something touched by the ways that were solved. Returns whether all stay within what was swept; as that holds the ways of
/// free flight, only those need asking that something touched.
pub(crate) fn advance(bodies: &mut Bodies, members: &[u32], lands: &[u32], dt: f64) -> bool {
    let mut inside = true;
    for &i in members {
        let i = i as usize;
        // Drag that was found again has changed the way of what nothing touches across.
        let mut moved = bodies.px[i] != bodies.free_x[i] || bodies.py[i] != bodies.free_y[i];
        if bodies.uy[i] != bodies.free_vy[i] {
            // What lands does so to the bit.
            bodies.py[i] = match lands[i] {
                NONE => bodies.y[i] + dt * bodies.mean_vy[i],
                j => bodies.py[j as usize] - (bodies.hy[i] + bodies.hy[j as usize]),
            };
            moved = true;
        }
        if bodies.ux[i] != bodies.free_vx[i] {
            bodies.px[i] = bodies.x[i] + dt * bodies.mean_vx[i];
            moved = true;
        }
        let stays = bodies.px[i] == bodies.x[i] && bodies.py[i] == bodies.y[i];
        inside &= !moved || stays || bodies.is_swept(i);
    }
    inside
}

/// What has become of predicted positions.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mended {
    /// Whether any was changed.
    pub any: bool,
    /// Whether something may still overlap, or leave what it swept.
    pub doubt: bool,
}

/// Parts what overlaps where it is predicted.
pub(crate) fn part(bodies: &mut Bodies, members: &[u32], contacts: &Contacts, clusters: &mut Clusters, dt: f64) -> Mended {
    let mut any = hold_down(bodies, members, contacts, dt);
    let mut doubt = lift(bodies, members, contacts, &mut any, dt);
    doubt |= spread(bodies, contacts, clusters);
    Mended { any: any || doubt, doubt }
}

/// Along gravity, top-down: what rises stops under what does not make way.
fn hold_down(bodies: &mut Bodies, members: &[u32], contacts: &Contacts, dt: f64) -> bool {
    let rises = members.iter().any(|&i| bodies.py[i as usize] < bodies.y[i as usize]);
    if !rises {
        return false;
    }
    let mut mended = false;
    let (n, hair, touch) = (bodies.len(), contacts.tolerances.hair, contacts.tolerances.touch);
    for &i in members.iter().rev() {
        let i = i as usize;
        for stack in contacts.stacks[contacts.under(i)].iter().filter(|stack| stack.live && (stack.second as usize) < n) {
            let j = stack.second as usize;
            let (rise, top) = (bodies.py[j], bodies.py[i] + stack.reach);
            if rise < top - hair && rise < bodies.y[j] {
                bodies.py[j] = top.min(bodies.y[j]);
                mended = true;
                if bodies.py[j] - rise > touch && bodies.ay[j] != 0.0 {
                    bodies.uy[j] = bodies.uy[j].max((bodies.py[j] - bodies.y[j]) / dt);
                }
            }
        }
    }
    mended
}

/// Along gravity, bottom-up: what falls stops on what carries it. Returns whether something has to be looked at again: a body
/// passed a corner, or hit a ceiling.
fn lift(bodies: &mut Bodies, members: &[u32], contacts: &Contacts, mended: &mut bool, dt: f64) -> bool {
    let (hair, touch) = (contacts.tolerances.hair, contacts.tolerances.touch);
    let mut doubt = false;
    for &i in members {
        let i = i as usize;
        let (predicted, mut y) = (bodies.py[i], bodies.py[i]);
        for stack in &contacts.stacks[contacts.under(i)] {
            let limit = bodies.py[stack.second as usize] - stack.reach;
            if y > limit + hair {
                if stack.live {
                    y = limit;
                } else {
                    doubt = true;
                }
            }
        }
        if y != predicted {
            bodies.py[i] = y;
            *mended = true;
            if predicted - y > touch && bodies.ay[i] != 0.0 {
                bodies.uy[i] = bodies.uy[i].min((y - bodies.y[i]).max(0.0) / dt);
            }
            doubt |= !bodies.is_swept(i);
        }
    }
    for ceiling in &contacts.ceilings {
        let (j, i) = (ceiling.first as usize, ceiling.second as usize);
        if bodies.py[i] - bodies.py[j] < ceiling.reach - hair {
            if ceiling.live {
                bodies.py[i] = bodies.py[j] + ceiling.reach;
            }
            doubt = true;
        }
    }
    doubt
}

fn overlap_along(bodies: &Bodies, i: usize, j: usize) -> bool {
    (bodies.py[i] - bodies.py[j]).abs() < bodies.hy[i] + bodies.hy[j]
}

/// Across: what overlaps is merged, in proportion to the masses. Returns whether something has to be looked at again.
fn spread(bodies: &mut Bodies, contacts: &Contacts, clusters: &mut Clusters) -> bool {
    let (n, hair) = (bodies.len(), contacts.tolerances.hair);
    let pool = Pool { before: &bodies.px, slack: hair, places: true };
    let pooled = clusters.pool(
        pool,
        || contacts.sides.iter(),
        |clusters, side| {
            let (a, b) = (side.first as usize, side.second as usize);
            if !side.live && !overlap_along(bodies, a, b) {
                return false;
            }
            for i in [a, b] {
                let mass = if i < n { bodies.mass[i] } else { 1.0 };
                let fixed = (i >= n).then(|| Motion { velocity: 0.0, mean: bodies.px[i] });
                clusters.join(i, fixed, Node::free(mass, 0.0, 0.0, bodies.px[i]));
            }
            true
        },
    );
    let mut doubt = pooled.stuck;
    for &i in &clusters.joined {
        let i = i as usize;
        if i < n {
            bodies.px[i] = clusters.mean(i, 0.0);
            doubt |= !bodies.is_swept(i);
        }
    }
    doubt
}

/// Puts bodies in conflict back to where they were along the contact's axis, and what they are then in the way of too, until
/// nothing overlaps. `back` is scratch. Returns how many coordinates that are.
pub(crate) fn take_back(bodies: &mut Bodies, members: &[u32], contacts: &Contacts, back: &mut [[bool; 2]]) -> u64 {
    members.iter().for_each(|i| back[*i as usize] = [false; 2]);
    for &i in members {
        if !bodies.is_swept(i as usize) {
            put_back(bodies, back, i as usize, ACROSS);
            put_back(bodies, back, i as usize, ALONG);
        }
    }
    let mut clean = false;
    while !clean {
        clean = true;
        for contact in contacts.stacks.iter().chain(&contacts.ceilings) {
            clean &= !resolve(bodies, back, contact, (ALONG, contacts.tolerances.hair));
        }
        for contact in &contacts.sides {
            clean &= !resolve(bodies, back, contact, (ACROSS, contacts.tolerances.hair));
        }
    }
    members.iter().map(|i| back[*i as usize].iter().filter(|b| **b).count() as u64).sum()
}

const ACROSS: usize = 0;
const ALONG: usize = 1;

/// Puts both of a pair back if it overlaps or passed through each other. Returns whether anything was moved.
fn resolve(bodies: &mut Bodies, back: &mut [[bool; 2]], contact: &Contact, (axis, hair): (usize, f64)) -> bool {
    let (a, b) = (contact.first as usize, contact.second as usize);
    if !hits(bodies, (a, b), hair) && !passed(bodies, (a, b)) {
        return false;
    }
    // A pair that may pass a corner keeps an axis along which it was not quite apart: then both axes go back.
    let started_apart = match axis {
        ACROSS => (bodies.x[a] - bodies.x[b]).abs() >= bodies.hx[a] + bodies.hx[b] - hair,
        _ => (bodies.y[a] - bodies.y[b]).abs() >= bodies.hy[a] + bodies.hy[b] - hair,
    };
    let mut moved = false;
    for i in [a, b] {
        for which in [ACROSS, ALONG] {
            if which == axis || !started_apart {
                moved |= put_back(bodies, back, i, which);
            }
        }
    }
    if !moved {
        for i in [a, b] {
            for which in [ACROSS, ALONG] {
                moved |= put_back(bodies, back, i, which);
            }
        }
    }
    moved
}

/// Whether two boxes that go straight from where they are to where they are predicted enter each other by more than `hair` on the way.
pub(crate) fn hits(bodies: &Bodies, (a, b): (usize, usize), hair: f64) -> bool {
    let axis = |x: &[f64], p: &[f64], h: &[f64]| [x[a] - x[b], p[a] - p[b], h[a] + h[b] - hair];
    let (across, along) = (axis(&bodies.x, &bodies.px, &bodies.hx), axis(&bodies.y, &bodies.py, &bodies.hy));
    // Most stay on one side, which takes no division.
    let beside = |[from, to, reach]: [f64; 3]| from.min(to) >= reach || from.max(to) <= -reach;
    if beside(across) || beside(along) {
        return false;
    }
    let (across, along) = (inside_between(across), inside_between(along));
    across.0.max(along.0) < across.1.min(along.1)
}

/// Whether one of two boxes has come to the far side of the other while they face each other by a quarter, before and after: whatever
/// hit it meanwhile, it did not get there round a corner.
fn passed(bodies: &Bodies, (a, b): (usize, usize)) -> bool {
    let axis = |x: &[f64], p: &[f64], h: &[f64]| {
        let (from, to, reach) = (x[a] - x[b], p[a] - p[b], h[a] + h[b] - 0.5 * h[a].min(h[b]));
        (from * to < 0.0, from.abs() < reach && to.abs() < reach)
    };
    let (through_x, beside_x) = axis(&bodies.x, &bodies.px, &bodies.hx);
    let (through_y, beside_y) = axis(&bodies.y, &bodies.py, &bodies.hy);
    (through_x && beside_y && !beside_x) || (through_y && beside_x && !beside_y)
}

/// Whether two boxes overlap where they are predicted.
pub(crate) fn overlap(bodies: &Bodies, (a, b): (usize, usize), hair: f64) -> bool {
    let deep_x = bodies.hx[a] + bodies.hx[b] - (bodies.px[a] - bodies.px[b]).abs();
    let deep_y = bodies.hy[a] + bodies.hy[b] - (bodies.py[a] - bodies.py[b]).abs();
    deep_x > hair && deep_y > hair
}

/// Between which parts of the way from one distance to another it is less than `reach`; an empty range if never.
fn inside_between([from, to, reach]: [f64; 3]) -> (f64, f64) {
    let way = to - from;
    if way == 0.0 {
        return if from.abs() < reach { (0.0, 1.0) } else { (1.0, 0.0) };
    }
    let (one, other) = ((-reach - from) / way, (reach - from) / way);
    (one.min(other).max(0.0), one.max(other).min(1.0))
}

/// Returns whether it was not yet back. Along gravity it does not keep the speed that it gained on a way that it did not go.
fn put_back(bodies: &mut Bodies, back: &mut [[bool; 2]], i: usize, axis: usize) -> bool {
    if i >= bodies.len() || back[i][axis] {
        return false;
    }
    back[i][axis] = true;
    if axis == ACROSS {
        bodies.px[i] = bodies.x[i];
    } else {
        bodies.py[i] = bodies.y[i];
        if bodies.uy[i].abs() > bodies.vy[i].abs() && bodies.ay[i] != 0.0 {
            bodies.uy[i] = bodies.vy[i];
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use crate::physics::crowd::place::inside_between;

    #[test]
    fn a_way_through_a_wall_is_seen() {
        assert_eq!(inside_between([-3.0, 5.0, 1.0]), (0.25, 0.5));
        assert_eq!(inside_between([2.0, 2.0, 1.0]), (1.0, 0.0));
    }
}
