//! Positions: apart by construction.
//!
//! Rounding, branching islands and passed corners are mended here. Bodies keep no speed gained on a way that they did not go, and go back along the
//! contact's axis where nothing else helps: no motion is always allowed.

use crate::physics::crowd::clusters::{ClusterMotion, Clusters, Node, Pool};
use crate::physics::crowd::{ACROSS, ALONG, bodies::Bodies, contacts::Contacts, contacts::CrowdContact, contacts::Tolerances};
use crate::physics::data::lists::NONE;
use glam::DVec2;

/// Moves the bodies that contacts have touched. Returns whether all stay within their swept boxes.
pub(crate) fn advance(bodies: &mut Bodies, lands: &[u32], dt: f64) -> bool {
    let mut inside = true;
    for i in 0..bodies.len() {
        let mut moved = bodies[i].to.x != bodies[i].flown.x || bodies[i].to.y != bodies[i].flown.y;
        if bodies[i].end.y != bodies[i].free.y {
            bodies[i].to.y = match lands[i] {
                NONE => bodies[i].from.y + dt * bodies[i].mean.y,
                j => bodies[j as usize].to.y - (bodies[i].half.y + bodies[j as usize].half.y),
            };
            moved = true;
        }
        if bodies[i].end.x != bodies[i].free.x {
            bodies[i].to.x = bodies[i].from.x + dt * bodies[i].mean.x;
            moved = true;
        }
        let stays = bodies[i].to.x == bodies[i].from.x && bodies[i].to.y == bodies[i].from.y;
        inside &= !moved || stays || bodies.is_swept(i);
    }
    inside
}

/// Moves boxes apart. Returns whether it mended anything, and whether somebody has to look again.
pub(crate) fn part(bodies: &mut Bodies, contacts: &Contacts, clusters: &mut Clusters, dt: f64) -> (bool, bool) {
    let mut mended = hold_down(bodies, contacts, dt);
    let lifted = lift(bodies, contacts, &mut mended, dt);
    let doubt = spread(bodies, contacts, clusters) || lifted;
    (mended || doubt, doubt)
}

/// Along gravity, top-down: what rises stops under what does not make way.
fn hold_down(bodies: &mut Bodies, contacts: &Contacts, dt: f64) -> bool {
    if !(0..bodies.len()).any(|i| bodies[i].to.y < bodies[i].from.y) {
        return false;
    }
    let mut mended = false;
    let (n, hair, touch) = (bodies.len(), contacts.tolerances.hair, contacts.tolerances.touch);
    for i in (0..bodies.len()).rev() {
        for stack in contacts.stacks[contacts.under(i)].iter().filter(|stack| stack.live && (stack.second as usize) < n) {
            let j = stack.second as usize;
            let (rise, top) = (bodies[j].to.y, bodies[i].to.y + stack.reach);
            if rise < top - hair && rise < bodies[j].from.y {
                bodies[j].to.y = top.min(bodies[j].from.y);
                mended = true;
                if bodies[j].to.y - rise > touch && bodies[j].pull.y != 0.0 {
                    bodies[j].end.y = bodies[j].end.y.max((bodies[j].to.y - bodies[j].from.y) / dt);
                }
            }
        }
    }
    mended
}

/// Along gravity, bottom-up: falling bodies stop on their supports. Returns whether to look again: at a passed corner, or a ceiling.
fn lift(bodies: &mut Bodies, contacts: &Contacts, mended: &mut bool, dt: f64) -> bool {
    let (hair, touch) = (contacts.tolerances.hair, contacts.tolerances.touch);
    let mut doubt = false;
    for i in 0..bodies.len() {
        let (predicted, mut y) = (bodies[i].to.y, bodies[i].to.y);
        for stack in &contacts.stacks[contacts.under(i)] {
            let limit = bodies[stack.second as usize].to.y - stack.reach;
            if y > limit + hair {
                if stack.live {
                    y = limit;
                } else {
                    doubt = true;
                }
            }
        }
        if y != predicted {
            bodies[i].to.y = y;
            *mended = true;
            if predicted - y > touch && bodies[i].pull.y != 0.0 {
                bodies[i].end.y = bodies[i].end.y.min((y - bodies[i].from.y).max(0.0) / dt);
            }
            doubt |= !bodies.is_swept(i);
        }
    }
    for ceiling in &contacts.ceilings {
        let (j, i) = (ceiling.first as usize, ceiling.second as usize);
        if bodies[i].to.y - bodies[j].to.y < ceiling.reach - hair {
            if ceiling.live {
                bodies[i].to.y = bodies[j].to.y + ceiling.reach;
            }
            doubt = true;
        }
    }
    doubt
}

/// Across: what overlaps is merged, in proportion to the masses. Returns whether something has to be looked at again.
fn spread(bodies: &mut Bodies, contacts: &Contacts, clusters: &mut Clusters) -> bool {
    let (n, hair) = (bodies.len(), contacts.tolerances.hair);
    let pool = Pool { before: |i| bodies[i].to.x, slack: hair, places: true };
    let (_, mut doubt) = clusters.pool(pool, [&contacts.sides, &[]], |clusters, side| {
        let (a, b) = (side.first as usize, side.second as usize);
        let apart = (bodies[a].to.y - bodies[b].to.y).abs() >= bodies[a].half.y + bodies[b].half.y;
        if !side.live && apart {
            return false;
        }
        for i in [a, b] {
            let mass = if i < n { bodies[i].mass } else { 1.0 };
            let fixed = (i >= n).then(|| ClusterMotion { velocity: 0.0, mean: bodies[i].to.x });
            clusters.join(i, fixed, Node::free(mass, 0.0, 0.0, bodies[i].to.x));
        }
        true
    });
    for i in clusters.joined.iter().map(|i| *i as usize).filter(|i| *i < n) {
        bodies[i].to.x = clusters.mean(i, 0.0);
        doubt |= !bodies.is_swept(i);
    }
    doubt
}

/// Puts bodies in conflict back along the contact's axis until nothing overlaps. `back` is scratch. Returns the number of coordinates.
pub(crate) fn take_back(bodies: &mut Bodies, contacts: &Contacts, back: &mut [[bool; 2]]) -> u64 {
    back.fill([false; 2]);
    for i in 0..bodies.len() {
        if !bodies.is_swept(i) {
            put_back(bodies, back, i, ACROSS);
            put_back(bodies, back, i, ALONG);
        }
    }
    let mut clean = false;
    while !clean {
        clean = true;
        let along = contacts.stacks.iter().chain(&contacts.ceilings).map(|contact| (contact, ALONG));
        for (contact, axis) in along.chain(contacts.sides.iter().map(|contact| (contact, ACROSS))) {
            clean &= !resolve(bodies, back, contact, (axis, contacts.tolerances));
        }
    }
    back.iter().flatten().filter(|b| **b).count() as u64
}

fn resolve(bodies: &mut Bodies, back: &mut [[bool; 2]], contact: &CrowdContact, (axis, tolerances): (usize, Tolerances)) -> bool {
    let (a, b) = (contact.first as usize, contact.second as usize);
    if !hits(bodies, (a, b), tolerances) && !passed(bodies, (a, b)) {
        return false;
    }
    // A pair that may pass a corner keeps an axis along which it was not quite apart: then both axes go back.
    let started_apart = (bodies[a].from - bodies[b].from).abs()[axis] >= (bodies[a].half + bodies[b].half)[axis] - tolerances.hair;
    let mut go_back = |axes: &[usize]| {
        let coordinates = [a, b].into_iter().flat_map(|i| axes.iter().map(move |axis| (i, *axis)));
        coordinates.fold(false, |moved, (i, axis)| put_back(bodies, back, i, axis) || moved)
    };
    (started_apart && go_back(&[axis])) || go_back(&[ACROSS, ALONG])
}

/// Whether two boxes on straight ways enter each other by more than a hair, or than they do already where they touch.
pub(crate) fn hits(bodies: &Bodies, (a, b): (usize, usize), Tolerances { touch, hair }: Tolerances) -> bool {
    let (a, b) = (&bodies[a], &bodies[b]);
    let [across, along] = [ACROSS, ALONG].map(|k| {
        let (from, to, reach) = (a.from[k] - b.from[k], a.to[k] - b.to[k], a.half[k] + b.half[k]);
        [from, to, if from.abs() >= reach - touch { from.abs().min(reach - hair) } else { reach - hair }]
    });
    let beside = |[from, to, reach]: [f64; 3]| from.min(to) >= reach || from.max(to) <= -reach;
    if beside(across) || beside(along) {
        return false;
    }
    let (across, along) = (inside_between(across), inside_between(along));
    across.0.max(along.0) < across.1.min(along.1)
}

/// Whether one of two boxes has come to the far side of the other while they face each other by a quarter, before and after: not round a corner.
fn passed(bodies: &Bodies, (a, b): (usize, usize)) -> bool {
    let (a, b) = (&bodies[a], &bodies[b]);
    let (from, to, reach) = (a.from - b.from, a.to - b.to, a.half + b.half - 0.5 * a.half.min(b.half));
    let (through, beside) = ((from * to).cmplt(DVec2::ZERO), from.abs().cmplt(reach) & to.abs().cmplt(reach));
    (through.x && beside.y && !beside.x) || (through.y && beside.x && !beside.y)
}

pub(crate) fn overlap(bodies: &Bodies, (a, b): (usize, usize), hair: f64) -> bool {
    let deep = bodies[a].half + bodies[b].half - (bodies[a].to - bodies[b].to).abs();
    deep.x > hair && deep.y > hair
}

/// The part of the way between two distances on which it is less than `reach`; an empty range if none.
fn inside_between([from, to, reach]: [f64; 3]) -> (f64, f64) {
    let way = to - from;
    if way == 0.0 {
        return if from.abs() < reach { (0.0, 1.0) } else { (1.0, 0.0) };
    }
    let (one, other) = ((-reach - from) / way, (reach - from) / way);
    (one.min(other).max(0.0), one.max(other).min(1.0))
}

fn put_back(bodies: &mut Bodies, back: &mut [[bool; 2]], i: usize, axis: usize) -> bool {
    if i >= bodies.len() || back[i][axis] {
        return false;
    }
    back[i][axis] = true;
    let body = &mut bodies[i];
    body.to[axis] = body.from[axis];
    if axis == ALONG && body.end.y.abs() > body.before.y.abs() && body.pull.y != 0.0 {
        body.end.y = body.before.y;
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
