//! Velocities along gravity.
//!
//! Bodies are numbered bottom-up, so one linear pass answers all that stands on the ground, at any mass ratio: a body's bound is
//! the smallest over its *anchored* supports of their velocity + gap/dt; one that would fall faster takes the bound and is
//! anchored itself, for pressing harder on what the ground holds does not move it. What is left are collisions in the air and
//! what is lifted from below: those are merged ([`super::clusters`]) until nothing closes too fast. The way that belongs to a
//! velocity is told by a mean velocity: of what the ground carries its velocity, of what merged that of a common fall.

use super::bodies::Bodies;
use super::bounce::{Axis, Impacts};
use super::clusters::{Clusters, Node};
use super::contacts::Contacts;

/// An approach this much faster than allowed is still allowed, m/s. Smaller: endless merging over rounding.
pub(super) const SLACK: f64 = 1e-12;
/// The most rounds of merging in a step; each settles at least one contact, all but the rarest scenes need two or three.
const ROUNDS: usize = 24;

/// The velocity of something with momentum P and mass M on ground whose friction can take `held` while it stands and takes
/// `dragged` while it slides. Friction never reverses motion.
pub(super) fn slide(momentum: f64, mass: f64, held: f64, dragged: f64) -> f64 {
    if momentum.abs() <= held { 0.0 } else { (momentum.abs() - dragged.min(momentum.abs())).copysign(momentum) / mass }
}

/// Solves the velocities along gravity.
pub(super) fn solve(
    bodies: &mut Bodies,
    contacts: &Contacts,
    anchored: &mut [bool],
    clusters: &mut Clusters,
    impacts: &mut Impacts,
) {
    let n = bodies.len();
    let mut loose = !contacts.ceilings.is_empty();
    for i in 0..n {
        let mut velocity = bodies.free_vy[i];
        let mut bound = f64::INFINITY;
        let mut over = f64::INFINITY;
        let mut support = 0;
        for stack in &contacts.stacks[contacts.under(i)] {
            if !stack.live {
                continue;
            }
            let j = stack.below as usize;
            let limit = bodies.uy[j] + stack.bound;
            if anchored[j] {
                if limit < bound {
                    bound = limit;
                    support = j;
                }
            } else {
                over = over.min(limit);
            }
        }
        anchored[i] = velocity >= bound;
        if anchored[i] {
            impacts.note(i, support, Axis::Gravity, velocity - bound);
            velocity = bound;
            bodies.mean_vy[i] = bound;
        }
        loose |= velocity > over + SLACK;
        bodies.uy[i] = velocity;
    }
    if loose {
        merge(bodies, contacts, anchored, clusters, impacts);
    }
}

/// Merges what closes too fast among bodies of which at least one is not anchored.
fn merge(bodies: &mut Bodies, contacts: &Contacts, anchored: &mut [bool], clusters: &mut Clusters, impacts: &mut Impacts) {
    let n = bodies.len();
    clusters.clear();
    let node =
        |bodies: &Bodies, i: usize| Node { momentum: bodies.mass[i] * bodies.free_vy[i], mass: bodies.mass[i], ..Node::default() };
    for _ in 0..ROUNDS {
        let mut merged = false;
        for i in 0..n {
            for stack in &contacts.stacks[contacts.under(i)] {
                let j = stack.below as usize;
                let (upper, lower) = (clusters.velocity(i, bodies.uy[i]), clusters.velocity(j, bodies.uy[j]));
                if !stack.live || upper <= lower + stack.bound + SLACK {
                    continue;
                }
                let held = j >= n || (if clusters.is_joined(j) { clusters.is_fixed(j) } else { anchored[j] });
                if anchored[i] && !held && !clusters.is_joined(i) {
                    anchored[i] = false; // pushed off its supports from below
                }
                let fixed_j = (j >= n || anchored[j]).then_some(bodies.uy[j]);
                clusters.join(j, fixed_j, if j < n { node(bodies, j) } else { Node::default() });
                clusters.join(i, anchored[i].then_some(bodies.uy[i]), node(bodies, i));
                impacts.note(i, j, Axis::Gravity, upper - lower - stack.bound);
                merged |= clusters.merge(i, j, stack.bound);
            }
        }
        for ceiling in &contacts.ceilings {
            let (j, i) = (ceiling.first as usize, ceiling.second as usize);
            let velocity = clusters.velocity(i, bodies.uy[i]);
            if ceiling.live && velocity < -ceiling.bound - SLACK {
                clusters.join(j, Some(0.0), Node::default());
                clusters.join(i, anchored[i].then_some(bodies.uy[i]), node(bodies, i));
                impacts.note(i, j, Axis::Gravity, -velocity - ceiling.bound);
                merged |= clusters.merge(i, j, -ceiling.bound);
            }
        }
        if !merged {
            break;
        }
        clusters.calm();
    }
    for &i in &clusters.joined {
        let i = i as usize;
        if i < n {
            bodies.uy[i] = clusters.velocity(i, 0.0);
            bodies.mean_vy[i] = bodies.uy[i];
            anchored[i] |= clusters.is_fixed(i);
        }
    }
    impacts.bind(clusters, Axis::Gravity);
    // What meets in the air meets at the start of the step, and then falls on as one.
    for root in clusters.free_roots() {
        let of = |i: usize| (bodies.mass[i], 0.5 * bodies.mass[i] * (bodies.free_vy[i] - bodies.vy[i]));
        let (mass, gained) = clusters.of(root).map(of).fold((0.0, 0.0), |sum, of| (sum.0 + of.0, sum.1 + of.1));
        clusters.of(root).for_each(|i| bodies.mean_vy[i] -= gained / mass);
    }
}

#[cfg(test)]
mod tests {
    use super::slide;

    #[test]
    fn friction_holds_drags_and_never_reverses() {
        assert_eq!(slide(0.99, 2.0, 1.0, 0.5), 0.0);
        assert_eq!(slide(2.5, 2.0, 1.0, 0.5), 1.0);
        assert_eq!(slide(-2.5, 2.0, 1.0, 0.5), -1.0);
        assert_eq!(slide(0.3, 2.0, 0.2, 0.5), 0.0);
    }
}
