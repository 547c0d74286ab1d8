//! Velocities across gravity: what stands side by side.
//!
//! Friction of the stacks first ([`super::friction`]); then bodies that close too fast sideways are merged with what rides on
//! them and with the friction of the ground under them ([`super::clusters`]), which moves a pushed row at (F − friction)/Σm and
//! holds it below its common limit. What the merging did is handed to the friction pass as a push, until nothing closes any more;
//! the few contacts left after [`ROUNDS`], and steps in which all that together drives instead of dissipating, are merged without
//! friction.
//! Faces that stand upright have no friction of their own.

use super::bodies::Bodies;
use super::bounce::{Axis, Impacts};
use super::clusters::{Clusters, Node};
use super::contacts::Contacts;
use super::friction::{Friction, Grip};
use super::gravity::SLACK;

/// Rounds of friction and merging. Fewer: riders of pushed bodies follow a step late.
const ROUNDS: usize = 3;
/// A pushed body that is faster by this part than it was and than its cluster was pushed against friction that did not come: then
/// the pushes are dropped. Smaller: rounding drops pushes; larger: bodies are flung.
const FLUNG: f64 = 1e-9;
/// Kinetic energy gained that is no more than rounding, as a part of all.
const ROUNDING: f64 = 1e-12;
/// Passes over the side contacts in one merging; each merges whole rows.
const PASSES: usize = 16;

/// What one body after the other is given in a step.
#[derive(Clone, Debug)]
pub(super) struct Pushes {
    /// Momenta before friction, pushes included, N·s.
    given: Vec<f64>,
    /// Velocities before any push, m/s.
    before: Vec<f64>,
    /// Who is pushed.
    pushed: Vec<bool>,
}

impl Pushes {
    pub fn new(count: usize) -> Self {
        Self { given: vec![0.0; count], before: vec![0.0; count], pushed: vec![false; count] }
    }
}

/// Solves the velocities across gravity.
pub(super) fn solve(
    bodies: &mut Bodies,
    contacts: &Contacts,
    friction: &mut Friction,
    clusters: &mut Clusters,
    impacts: &mut Impacts,
    pushes: &mut Pushes,
) {
    let n = bodies.len();
    bodies.ux.copy_from_slice(&bodies.free_vx);
    for ((given, mass), velocity) in pushes.given.iter_mut().zip(&bodies.mass).zip(&bodies.free_vx) {
        *given = mass * velocity;
    }
    if pushes.given.iter().fold(true, |still, p| still & (*p == 0.0)) {
        friction.rest();
        return;
    }
    let settled = rub_and_push(bodies, contacts, friction, clusters, impacts, pushes);
    let gained = gains(bodies);
    if settled && !gained {
        return;
    }
    if gained {
        bodies.ux[..n].copy_from_slice(&pushes.before);
    }
    let plain =
        |bodies: &Bodies, i: usize| Some(Node { momentum: bodies.mass[i] * bodies.ux[i], mass: bodies.mass[i], ..Node::default() });
    if merge(bodies, contacts, clusters, impacts, plain) {
        impacts.bind(clusters, Axis::Across);
        for &i in &clusters.joined {
            let i = i as usize;
            if i < n {
                bodies.ux[i] = clusters.velocity(i, 0.0);
            }
        }
    }
}

/// Whether there is more kinetic energy than before: friction and pushes that answer each other round by round may drive.
fn gains(bodies: &Bodies) -> bool {
    let (mut before, mut after) = (0.0, 0.0);
    for ((mass, free), velocity) in bodies.mass.iter().zip(&bodies.free_vx).zip(&bodies.ux) {
        before += mass * free * free;
        after += mass * velocity * velocity;
    }
    after > before * (1.0 + ROUNDING)
}

/// Friction, and merging with friction, in turns. Returns whether nothing closes too fast any more.
fn rub_and_push(
    bodies: &mut Bodies,
    contacts: &Contacts,
    friction: &mut Friction,
    clusters: &mut Clusters,
    impacts: &mut Impacts,
    pushes: &mut Pushes,
) -> bool {
    let Pushes { given, before, pushed } = pushes;
    let n = bodies.len();
    pushed.fill(false);
    friction.wake(bodies, contacts, given, pushed);
    friction.load(bodies, contacts);
    friction.solve(bodies, given);
    before.copy_from_slice(&bodies.ux[..n]);
    for _ in 0..ROUNDS {
        if rouse(bodies, contacts, friction, pushed) {
            friction.wake(bodies, contacts, given, pushed);
            friction.load(bodies, contacts);
            friction.solve(bodies, given);
        }
        if !merge(bodies, contacts, clusters, impacts, |bodies, i| node(bodies, friction, i)) {
            return true;
        }
        impacts.bind(clusters, Axis::Across);
        if hand_over(bodies, friction, clusters, given) {
            friction.solve(bodies, given);
        }
        let flung = |i: usize| bodies.ux[i].abs() > before[i].abs().max(clusters.velocity(i, 0.0).abs()) * (1.0 + FLUNG) + SLACK;
        if clusters.joined.iter().any(|i| (*i as usize) < n && flung(*i as usize)) {
            bodies.ux[..n].copy_from_slice(before);
            return false;
        }
    }
    false
}

/// Gives merged bodies their clusters' velocities, as pushes to those at which something rubs. Returns whether there are any.
fn hand_over(bodies: &mut Bodies, friction: &mut Friction, clusters: &Clusters, given: &mut [f64]) -> bool {
    let mut rubs = false;
    for &i in &clusters.joined {
        let i = i as usize;
        let Some(node) = (i < bodies.len()).then(|| node(bodies, friction, i)).flatten() else { continue };
        given[i] += push(clusters, i, &node);
        let velocity = clusters.velocity(i, 0.0);
        if !friction.is_gripped(i) {
            bodies.ux[i] = velocity;
            continue;
        }
        rubs = true;
        if velocity != 0.0 {
            friction.drag(i);
        }
    }
    rubs
}

/// Wakes what stands and is about to be hit from the side, and what touches it in a row. Returns whether there was any.
fn rouse(bodies: &Bodies, contacts: &Contacts, friction: &Friction, pushed: &mut [bool]) -> bool {
    let n = bodies.len();
    let sleeps = |pushed: &[bool], i: usize| i < n && !pushed[i] && !friction.is_awake(i);
    let mut any = false;
    for side in &contacts.sides {
        let (a, b) = (side.first as usize, side.second as usize);
        if side.live && bodies.ux[a] > bodies.ux[b] + side.bound + SLACK {
            for i in [a, b] {
                if sleeps(pushed, i) {
                    pushed[i] = true;
                    any = true;
                }
            }
        }
    }
    let mut grows = any;
    while grows {
        grows = false;
        for side in &contacts.sides {
            let (a, b) = (side.first as usize, side.second as usize);
            if side.live && side.bound == 0.0 && a < n && b < n && pushed[a] != pushed[b] {
                for i in [a, b] {
                    if sleeps(pushed, i) {
                        pushed[i] = true;
                        grows = true;
                    }
                }
            }
        }
    }
    any
}

/// What a body brings: itself and its riders, and the friction of supports that stand still.
/// Nothing of a body that does not take part yet.
fn node(bodies: &Bodies, friction: &Friction, i: usize) -> Option<Node> {
    if !friction.is_awake(i) {
        return None;
    }
    if !friction.is_gripped(i) {
        return Some(Node { momentum: bodies.mass[i] * bodies.ux[i], mass: bodies.mass[i], ..Node::default() });
    }
    let mut node = friction.riders[i];
    let tight = &friction.tight[friction.under(i)];
    if tight.is_empty() || tight.iter().any(|t| bodies.ux[t.below as usize] != 0.0) {
        return Some(Node { momentum: node.mass * bodies.ux[i], ..node });
    }
    for t in tight {
        if t.grip != Grip::Stick {
            node.momentum -= t.impulse;
        }
        node.static_limit += t.held;
        node.kinetic_limit += t.dragged;
    }
    Some(node)
}

/// The impulse with which its neighbours bring a merged body to the velocity of its cluster.
fn push(clusters: &Clusters, i: usize, node: &Node) -> f64 {
    let velocity = clusters.velocity(i, 0.0);
    if velocity != 0.0 {
        return node.mass * velocity + node.kinetic_limit.copysign(velocity) - node.momentum;
    }
    if clusters.is_fixed(i) {
        return node.momentum.clamp(-node.static_limit, node.static_limit) - node.momentum;
    }
    let (impulse, limit) = clusters.held(i);
    let part = if limit > 0.0 { node.static_limit / limit } else { 0.0 };
    impulse * part - node.momentum
}

/// Merges what closes too fast, of those that `node` knows. Returns whether anything did.
fn merge(
    bodies: &Bodies,
    contacts: &Contacts,
    clusters: &mut Clusters,
    impacts: &mut Impacts,
    node: impl Fn(&Bodies, usize) -> Option<Node>,
) -> bool {
    let n = bodies.len();
    clusters.clear();
    let mut any = false;
    for _ in 0..PASSES {
        let mut merged = false;
        for side in &contacts.sides {
            let (a, b) = (side.first as usize, side.second as usize);
            let (left, right) = (clusters.velocity(a, bodies.ux[a]), clusters.velocity(b, bodies.ux[b]));
            if left <= right + side.bound + SLACK || !side.live {
                continue;
            }
            any = true;
            let brings = |i: usize| if i < n { node(bodies, i) } else { Some(Node::default()) };
            let (Some(of_a), Some(of_b)) = (brings(a), brings(b)) else { continue };
            clusters.join(a, (a >= n).then_some(0.0), of_a);
            clusters.join(b, (b >= n).then_some(0.0), of_b);
            impacts.note(a, b, Axis::Across, left - right - side.bound);
            merged |= clusters.merge(a, b, side.bound);
        }
        if !merged {
            break;
        }
        clusters.calm();
    }
    any
}
