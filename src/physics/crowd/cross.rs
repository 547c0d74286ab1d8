//! Velocities across gravity: what stands side by side.
//!
//! Friction of the stacks first ([`crate::physics::crowd::friction`]); then bodies that close too far sideways are merged with what rides on
//! them and with the friction of the ground under them ([`crate::physics::crowd::clusters`]), which moves a pushed row at (F − friction)/Σm and
//! holds it below its common limit. What the merging did is handed to the friction pass as a push, until nothing closes any more;
//! the few contacts left after [`ROUNDS`], and islands in which all that together drives instead of dissipating, are merged without
//! friction.

use crate::physics::crowd::clusters::{Clusters, Motion, Node, Pool};
use crate::physics::crowd::contacts::Contacts;
use crate::physics::crowd::drag::Resistance;
use crate::physics::crowd::friction::{Friction, Grip};
use crate::physics::crowd::gravity::Anchors;
use crate::physics::crowd::impulses::Edge;
use crate::physics::crowd::report::Report;
use crate::physics::crowd::restitution::Bounces;
use crate::physics::data::axis::Axis;
use crate::physics::guards::Guards;
use crate::physics::store::bodies::Bodies;

/// Rounds of friction and merging. Fewer: riders of pushed bodies follow a step late.
const ROUNDS: usize = 3;
/// The same among many bodies of which some bounce: there is always some contact that does not settle.
const ROUNDS_OF_MANY: usize = 1;
/// A pushed body that is faster by this part than it was and than its cluster was pushed against friction that did not come: then
/// the pushes are dropped. Smaller: rounding drops pushes; larger: bodies are driven by friction. Among many that bounce there is always one, and
/// only the energy of all counts.
const DRIVEN: f64 = 1e-9;
/// Speeds below this are rounding, m/s.
pub(crate) const STILL: f64 = 1e-12;
/// Kinetic energy gained that is no more than rounding, as a part of all.
const ROUNDING: f64 = 1e-12;

/// What one body after the other is given in a step.
#[derive(Clone, Debug)]
pub(crate) struct Pushes {
    /// Momenta before friction, pushes included, N·s.
    given: Vec<f64>,
    /// Velocities before any push, m/s.
    before: Vec<f64>,
    /// Who is pushed, and whose way a cluster has told.
    pushed: Vec<bool>,
    told: Vec<bool>,
    pub hits: Hits,
    pub resistance: Resistance,
    /// Pairs side by side, and the impulses that parted them in the end.
    pub parting: Vec<Edge>,
}

/// Plastic impacts, and how fast one must close, m/s.
#[derive(Clone, Debug, Default)]
pub(crate) struct Hits {
    pub all: Vec<(u32, u32)>,
    pub impact: f64,
}

impl Pushes {
    pub fn new(count: usize) -> Self {
        Self {
            given: vec![0.0; count],
            before: vec![0.0; count],
            pushed: vec![false; count],
            told: vec![false; count],
            hits: Hits::default(),
            resistance: Resistance::default(),
            parting: Vec::with_capacity(count),
        }
    }
}

/// What the solution across works with.
pub(crate) struct Cross<'a> {
    pub members: &'a [u32],
    pub contacts: &'a Contacts,
    pub friction: &'a mut Friction,
    pub clusters: &'a mut Clusters,
    pub pushes: &'a mut Pushes,
    pub anchors: &'a Anchors,
    /// What upright faces hold up, N·s.
    pub held_up: &'a [f64],
    pub report: &'a mut Report,
    pub dt: f64,
    /// Whether they are many, of which some bounce.
    pub many: bool,
}

impl Cross<'_> {
    /// Solves the velocities across gravity; counts where that was cut short.
    pub fn solve(&mut self, bodies: &mut Bodies, guards: &mut Guards) {
        self.pushes.hits.all.clear();
        self.pushes.resistance.restore(bodies);
        if !self.begin(bodies) && !self.contacts.carried {
            self.friction.rest(self.members);
            return;
        }
        let settled = self.rub_and_push(bodies);
        let gained = self.gains(bodies);
        if settled && !gained {
            guards.friction_unsettled += u64::from(!self.polish(bodies));
            return;
        }
        guards.friction_unsettled += 1;
        if gained {
            self.reset(bodies);
        }
        let plain = |bodies: &Bodies, i: usize| Some(Node::free(bodies.mass[i], bodies.vx[i], bodies.ux[i], bodies.mean_vx[i]));
        if merge(bodies, self.contacts, self.clusters, self.anchors.bounces, &mut self.pushes.hits, plain) {
            let (clusters, n) = (&*self.clusters, bodies.len());
            let lack = |i: usize| if i < n { bodies.mass[i] * (bodies.ux[i] - clusters.velocity(i)) } else { 0.0 };
            self.report.drain_sides(clusters, lack, n);
            for &i in &self.clusters.joined {
                let i = i as usize;
                if i < bodies.len() {
                    bodies.ux[i] = self.clusters.velocity(i);
                    bodies.mean_vx[i] = self.clusters.mean(i, 0.0);
                }
            }
        }
    }

    /// Whether there is more kinetic energy than before: friction and pushes that answer each other round by round may drive. Moving
    /// surfaces may, and what slides back.
    fn gains(&self, bodies: &Bodies) -> bool {
        let (mut before, mut after) = (0.0, 0.0);
        for &i in self.members {
            let i = i as usize;
            before += bodies.mass[i] * bodies.free_vx[i] * bodies.free_vx[i];
            after += bodies.mass[i] * bodies.ux[i] * bodies.ux[i];
        }
        after > before * (1.0 + ROUNDING) && !self.contacts.carried && !self.friction.turned
    }

    /// Back to friction alone.
    fn reset(&mut self, bodies: &mut Bodies) {
        self.begin(bodies);
        self.rub(bodies);
    }

    /// Free flight, and nobody pushed. Returns whether anything moves.
    fn begin(&mut self, bodies: &mut Bodies) -> bool {
        let per_second = 1.0 / self.dt;
        let mut moves = false;
        self.report.sides.clear();
        for &i in self.members {
            let i = i as usize;
            bodies.ux[i] = bodies.free_vx[i];
            bodies.mean_vx[i] = (bodies.px[i] - bodies.x[i]) * per_second;
            self.pushes.given[i] = bodies.mass[i] * bodies.free_vx[i];
            (self.pushes.pushed[i], self.pushes.told[i]) = (false, false);
            moves |= (bodies.free_vx[i] != 0.0) | (bodies.px[i] != bodies.x[i]);
        }
        moves
    }

    /// Friction, and merging with friction, in turns. Returns whether nothing closes too far any more.
    fn rub_and_push(&mut self, bodies: &mut Bodies) -> bool {
        self.rub(bodies);
        self.resist(bodies);
        for &i in self.members {
            let i = i as usize;
            self.pushes.before[i] = bodies.ux[i];
        }
        for _ in 0..if self.many { ROUNDS_OF_MANY } else { ROUNDS } {
            if self.stir(bodies) {
                self.rub(bodies);
            }
            let (friction, contacts, dt) = (&*self.friction, self.contacts, self.dt);
            let Pushes { told, hits, .. } = &mut *self.pushes;
            if !merge(bodies, contacts, self.clusters, self.anchors.bounces, hits, |bodies, i| {
                node(bodies, friction, i, (told[i], dt))
            }) {
                return true;
            }
            if self.hand_over(bodies) {
                self.friction.solve(bodies, &self.pushes.given);
                self.friction.spread_ways(bodies, &self.pushes.told, self.dt);
            }
            if !self.many && self.drives(bodies) {
                self.reset(bodies);
                return false;
            }
        }
        false
    }

    /// Tells drag anew with the velocities that friction leaves, and friction with that.
    fn resist(&mut self, bodies: &mut Bodies) {
        if !bodies.airy {
            return;
        }
        let Pushes { given, resistance, .. } = &mut *self.pushes;
        if resistance.across(bodies, self.friction.gripped(), given, self.dt) {
            self.friction.solve(bodies, &self.pushes.given);
            self.friction.spread_ways(bodies, &self.pushes.told, self.dt);
        }
    }

    fn rub(&mut self, bodies: &mut Bodies) {
        let Pushes { given, pushed, told, resistance, .. } = &mut *self.pushes;
        self.friction.wake(bodies, self.members, self.contacts, given, pushed);
        self.friction.touch(bodies, self.contacts, self.dt);
        if bodies.airy {
            resistance.along(bodies, self.friction.gripped(), self.dt);
        }
        self.friction.load(bodies, self.held_up, self.anchors);
        self.friction.solve(bodies, given);
        self.friction.spread_ways(bodies, told, self.dt);
    }

    /// Whether a merged body is faster than it was and than its cluster.
    fn drives(&self, bodies: &Bodies) -> bool {
        self.clusters.joined.iter().map(|i| *i as usize).filter(|i| *i < bodies.len()).any(|i| {
            let before = self.pushes.before[i].abs();
            bodies.ux[i].abs() > before.max(self.clusters.velocity(i).abs()) * (1.0 + DRIVEN) + STILL
        })
    }

    /// Gives merged bodies their clusters' velocities, as pushes to those at which something rubs. Returns whether there are any.
    fn hand_over(&mut self, bodies: &mut Bodies) -> bool {
        let mut rubs = false;
        let (clusters, friction, pushes, dt, n) = (&*self.clusters, &*self.friction, &*self.pushes, self.dt, bodies.len());
        let lack = |i: usize| {
            let node = (i < n).then(|| node(bodies, friction, i, (pushes.told[i], dt))).flatten();
            node.map_or(0.0, |node| -push(clusters, i, &node))
        };
        self.report.drain_sides(clusters, lack, n);
        for &i in &self.clusters.joined {
            let i = i as usize;
            let Some(node) = (i < bodies.len()).then(|| node(bodies, self.friction, i, (self.pushes.told[i], self.dt))).flatten()
            else {
                continue;
            };
            self.pushes.given[i] += push(self.clusters, i, &node);
            self.pushes.told[i] = true;
            let velocity = self.clusters.velocity(i);
            bodies.mean_vx[i] = self.clusters.mean(i, 0.0);
            if !self.friction.is_gripped(i) {
                bodies.ux[i] = velocity;
                continue;
            }
            rubs = true;
            self.friction.tell(i);
            if velocity != 0.0 {
                self.friction.drag(i);
            }
        }
        rubs
    }

    /// Wakes what stands and is about to be hit from the side, and what touches it in a row. Returns whether there was any.
    fn stir(&mut self, bodies: &Bodies) -> bool {
        let (n, pushed, friction) = (bodies.len(), &mut self.pushes.pushed, &*self.friction);
        let slack = self.contacts.tolerances.hair / self.dt;
        let sleeps = |pushed: &[bool], i: usize| i < n && !pushed[i] && !friction.is_awake(i);
        let mut any = false;
        for side in &self.contacts.sides {
            let (a, b) = (side.first as usize, side.second as usize);
            if side.live && bodies.mean_vx[a] > bodies.mean_vx[b] + side.bound + slack {
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
            for side in &self.contacts.sides {
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
}

/// What a body brings: itself and its riders, and the friction of supports that stand still.
/// Nothing of a body that does not take part yet.
fn node(bodies: &Bodies, friction: &Friction, i: usize, (told, dt): (bool, f64)) -> Option<Node> {
    if !friction.is_awake(i) {
        return None;
    }
    let (velocity, mean) = (bodies.ux[i], bodies.mean_vx[i]);
    if !friction.is_gripped(i) {
        return Some(Node::free(bodies.mass[i], bodies.vx[i], velocity, mean));
    }
    let riders = friction.riders[i];
    let tight = &friction.tight[friction.under(i)];
    let moves = |t: &crate::physics::crowd::friction::Tight| bodies.ux[t.below as usize] != 0.0 || t.skin != 0.0;
    if tight.is_empty() || tight.iter().any(moves) {
        return Some(Node::free(riders.mass, bodies.vx[i], velocity, mean));
    }
    let mut node = Node { began: riders.mass * bodies.vx[i], ..riders };
    for t in tight {
        if t.grip != Grip::Stick {
            node.momentum -= t.impulse;
        }
        node.static_limit += t.held;
        node.kinetic_limit += t.dragged;
    }
    // Its way without friction: as in flight, with what was given besides; or such that friction takes it where a cluster has.
    let (free, of) = if told { (mean, velocity) } else { ((bodies.px[i] - bodies.x[i]) / dt, bodies.free_vx[i]) };
    node.way = node.mass * free + 0.5 * (node.momentum - node.mass * of);
    Some(node)
}

/// The impulse with which its neighbours bring a merged body to the velocity of its cluster.
fn push(clusters: &Clusters, i: usize, node: &Node) -> f64 {
    let velocity = clusters.velocity(i);
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

/// Merges what closes too far, of those that `node` knows. Returns whether anything did.
pub(crate) fn merge(
    bodies: &Bodies,
    contacts: &Contacts,
    clusters: &mut Clusters,
    bounces: Bounces,
    hits: &mut Hits,
    node: impl Fn(&Bodies, usize) -> Option<Node>,
) -> bool {
    let n = bodies.len();
    let pool = Pool { before: &bodies.mean_vx, slack: contacts.tolerances.hair / bounces.dt, places: false };
    let live = || contacts.sides.iter().filter(|side| side.live);
    let pooled = clusters.pool(pool, live, |clusters, side| {
        let (a, b) = (side.first as usize, side.second as usize);
        let brings = |i: usize| if i < n { node(bodies, i) } else { Some(Node::default()) };
        let (Some(of_a), Some(of_b)) = (brings(a), brings(b)) else { return false };
        let fixed = |i: usize| (i >= n).then(|| Motion { velocity: bodies.ux[i], mean: bodies.mean_vx[i] });
        if bodies.ux[a] - bodies.ux[b] > hits.impact && !(clusters.is_joined(a) && clusters.is_joined(b)) {
            hits.all.push(if a < n { (a as u32, b as u32) } else { (b as u32, a as u32) });
        }
        clusters.join(a, fixed(a), of_a);
        clusters.join(b, fixed(b), of_b);
        true
    });
    if bodies.lively && pooled.any {
        // What carries others does not bounce: friction alone would have to take them along.
        let alone = |i: u32| node(bodies, i as usize).is_none_or(|node| node.mass == bodies.mass[i as usize]);
        clusters.hit(live(), |contact| {
            let both = [contact.first, contact.second].into_iter().all(|i| i as usize >= n || alone(i));
            bounces.of(bodies, contact, Axis::Across).map(|restitution| if both { restitution } else { 0.0 })
        });
    }
    pooled.any
}
