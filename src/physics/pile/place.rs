//! Positions: moved by the solved velocities, and apart by construction.
//!
//! A body that nothing touched is where free flight puts it. Along gravity, one that the ground carries goes as far as its
//! velocity says, so that it lands exactly when its gap is closed; those that merged in the air met at the start of the step and fall
//! on together. Both lose energy, never gain it; moving by the mean of the velocities before and after would lift what hops by
//! less than a step. Across, one whose velocity changed smoothly (by no more than forces do in a step) moves by the mean of its two
//! velocities, exact for constant accelerations; one that hit something by the new velocity, which the bounds of the contacts were
//! made for.
//!
//! What rounding and simplification leave is mended here: along gravity what rises stops under what does not make way, top-down,
//! and what falls stops on what carries it, bottom-up, and neither keeps a speed that it gained for a way that it did not go (what
//! nothing pulls gained none, and its momentum stays); across what overlaps is merged as velocities are ([`super::clusters`]), the
//! centre of mass unmoved; and where that is not enough, bodies in conflict are put back to where they were along the contact's axis,
//! for no motion is always allowed.

use super::bodies::Bodies;
use super::clusters::{Clusters, Node};
use super::contacts::{Contacts, TOUCH};

/// Overlaps below this are left alone, m, so that what rests is not moved by rounding.
const HAIR: f64 = 1e-12;
/// A velocity changed by no more than this many times what the forces do in a step changed smoothly.
const SMOOTH: f64 = 2.0;
/// Passes of merging across before bodies are put back.
const PASSES: usize = 16;

/// Moves what something touched along gravity, by the way that [`super::gravity`] gave it. Returns whether all stay within what was swept; as that holds the
/// ways of free flight, only those need asking that something touched.
pub(super) fn move_along(bodies: &mut Bodies, contacts: &Contacts, dt: f64) -> bool {
    let mut inside = true;
    for i in 0..bodies.len() {
        if bodies.uy[i] != bodies.free_vy[i] {
            bodies.py[i] = bodies.y[i] + dt * bodies.mean_vy[i];
            inside &= bodies.py[i] == bodies.y[i] || contacts.covers(bodies, i);
        }
    }
    inside
}

/// The same across, by their solved velocities.
pub(super) fn move_across(bodies: &mut Bodies, contacts: &Contacts, gravity: f64, dt: f64) -> bool {
    let mut inside = true;
    for i in 0..bodies.len() {
        if bodies.ux[i] != bodies.free_vx[i] {
            let pull = SMOOTH * dt * (gravity.abs() + bodies.ax[i].abs() + bodies.ay[i].abs());
            bodies.px[i] = bodies.x[i] + dt * travel(bodies.vx[i], bodies.ux[i], pull);
            inside &= bodies.px[i] == bodies.x[i] || contacts.covers(bodies, i);
        }
    }
    inside
}

fn travel(before: f64, after: f64, pull: f64) -> f64 {
    if (after - before).abs() <= pull { 0.5 * (before + after) } else { after }
}

/// Mends the predicted positions until nothing overlaps. `back` is scratch.
pub(super) fn part(
    bodies: &mut Bodies,
    contacts: &Contacts,
    clusters: &mut Clusters,
    back: &mut [[bool; 2]],
    dt: f64,
    inside: bool,
) {
    hold_down(bodies, contacts, dt);
    let mut doubt = lift(bodies, contacts, dt) || !inside;
    doubt |= spread(bodies, contacts, clusters);
    if doubt {
        take_back(bodies, contacts, back);
    }
}

/// Along gravity, top-down: what rises stops under what does not make way.
fn hold_down(bodies: &mut Bodies, contacts: &Contacts, dt: f64) {
    let n = bodies.len();
    let rises = bodies.py[..n].iter().zip(&bodies.y[..n]).fold(false, |any, (py, y)| any | (py < y));
    if !rises {
        return;
    }
    for i in (0..n).rev() {
        for stack in contacts.stacks[contacts.under(i)].iter().filter(|stack| stack.live) {
            let j = stack.below as usize;
            let (rise, top) = (bodies.py[j], bodies.py[i] + stack.reach);
            if rise < top - HAIR && rise < bodies.y[j] {
                bodies.py[j] = top.min(bodies.y[j]);
                if bodies.py[j] - rise > TOUCH && bodies.ay[j] != 0.0 {
                    bodies.uy[j] = bodies.uy[j].max((bodies.py[j] - bodies.y[j]) / dt);
                }
            }
        }
    }
}

/// Along gravity, bottom-up: what falls stops on what carries it. Returns whether something has to be looked at again: a body
/// passed a corner, or hit a ceiling.
fn lift(bodies: &mut Bodies, contacts: &Contacts, dt: f64) -> bool {
    let mut doubt = false;
    for i in 0..bodies.len() {
        let (predicted, mut y) = (bodies.py[i], bodies.py[i]);
        for stack in &contacts.stacks[contacts.under(i)] {
            let limit = bodies.py[stack.below as usize] - stack.reach;
            if y > limit + HAIR {
                if stack.live {
                    y = limit;
                } else {
                    doubt = true;
                }
            }
        }
        if y != predicted {
            bodies.py[i] = y;
            if predicted - y > TOUCH && bodies.ay[i] != 0.0 {
                bodies.uy[i] = bodies.uy[i].min((y - bodies.y[i]).max(0.0) / dt);
            }
            doubt |= !contacts.covers(bodies, i);
        }
    }
    for ceiling in &contacts.ceilings {
        let (j, i) = (ceiling.first as usize, ceiling.second as usize);
        if bodies.py[i] - bodies.py[j] < ceiling.reach - HAIR {
            bodies.py[i] = bodies.py[j] + ceiling.reach;
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
    let n = bodies.len();
    clusters.clear();
    let mut doubt = false;
    for pass in 0..PASSES {
        let mut merged = false;
        for side in &contacts.sides {
            let (a, b) = (side.first as usize, side.second as usize);
            let depth = side.reach - (clusters.velocity(b, bodies.px[b]) - clusters.velocity(a, bodies.px[a]));
            if depth <= HAIR {
                continue;
            }
            if !side.live && !overlap_along(bodies, a, b) {
                doubt = true;
                continue;
            }
            for i in [a, b] {
                let mass = if i < n { bodies.mass[i] } else { 1.0 };
                clusters.join(i, (i >= n).then_some(bodies.px[i]), Node { momentum: mass * bodies.px[i], mass, ..Node::default() });
            }
            let done = clusters.merge(a, b, -side.reach);
            merged |= done;
            doubt |= !done;
        }
        if !merged {
            break;
        }
        doubt |= pass + 1 == PASSES;
    }
    for &i in &clusters.joined {
        let i = i as usize;
        if i < n {
            bodies.px[i] = clusters.velocity(i, 0.0);
            doubt |= !contacts.covers(bodies, i);
        }
    }
    doubt
}

/// Puts bodies in conflict back to where they were along the contact's axis, and what they are then in the way of too, until
/// nothing overlaps.
fn take_back(bodies: &mut Bodies, contacts: &Contacts, back: &mut [[bool; 2]]) {
    let n = bodies.len();
    back.fill([false; 2]);
    for i in 0..n {
        if !contacts.covers(bodies, i) {
            put_back(bodies, back, i, ACROSS);
            put_back(bodies, back, i, ALONG);
        }
    }
    let mut clean = false;
    while !clean {
        clean = true;
        for i in 0..n {
            for stack in &contacts.stacks[contacts.under(i)] {
                let crossed = stack.live && bodies.py[i] > bodies.py[stack.below as usize];
                clean &= !resolve(bodies, back, i, stack.below as usize, ALONG, crossed);
            }
        }
        for side in &contacts.sides {
            let crossed = side.live && bodies.px[side.first as usize] > bodies.px[side.second as usize];
            clean &= !resolve(bodies, back, side.first as usize, side.second as usize, ACROSS, crossed);
        }
        for ceiling in &contacts.ceilings {
            let crossed = ceiling.live && bodies.py[ceiling.first as usize] > bodies.py[ceiling.second as usize];
            clean &= !resolve(bodies, back, ceiling.first as usize, ceiling.second as usize, ALONG, crossed);
        }
    }
}

const ACROSS: usize = 0;
const ALONG: usize = 1;

/// Puts both of a pair back if it overlaps or passed through each other. Returns whether anything was moved.
fn resolve(bodies: &mut Bodies, back: &mut [[bool; 2]], a: usize, b: usize, axis: usize, crossed: bool) -> bool {
    let deep_x = bodies.hx[a] + bodies.hx[b] - (bodies.px[a] - bodies.px[b]).abs();
    let deep_y = bodies.hy[a] + bodies.hy[b] - (bodies.py[a] - bodies.py[b]).abs();
    if !crossed && (deep_x <= HAIR || deep_y <= HAIR) {
        return false;
    }
    // A pair that may pass a corner keeps an axis along which it was not quite apart: then both axes go back.
    let started_apart = match axis {
        ACROSS => (bodies.x[a] - bodies.x[b]).abs() >= bodies.hx[a] + bodies.hx[b] - HAIR,
        _ => (bodies.y[a] - bodies.y[b]).abs() >= bodies.hy[a] + bodies.hy[b] - HAIR,
    };
    let mut moved = false;
    for i in [a, b] {
        for which in [ACROSS, ALONG] {
            if which == axis || !started_apart {
                moved |= put_back(bodies, back, i, which);
            }
        }
    }
    moved
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
    use super::travel;

    #[test]
    fn smooth_changes_move_by_the_mean_and_hits_by_the_new_velocity() {
        assert_eq!(travel(1.0, 1.2, 0.3), 1.1);
        assert_eq!(travel(5.0, 0.5, 0.3), 0.5);
    }
}
