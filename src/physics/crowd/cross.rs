//! Velocities across gravity: what stands side by side.
//!
//! Friction of the stacks first ([`crate::physics::crowd::friction`]); then bodies that close too far sideways are merged with what rides on
//! them and with the friction of the ground under them ([`crate::physics::crowd::clusters`]), which moves a pushed row at (F − friction)/Σm and
//! holds it below its common limit. What the merging did is handed to the friction pass as a push, until nothing closes any more;
//! the few contacts left after [`ROUNDS`], and islands in which all that together drives instead of dissipating, are merged without
//! friction.

use crate::physics::crowd::ACROSS;
use crate::physics::crowd::bodies::Bodies;
use crate::physics::crowd::clusters::{Clusters, Motion, Node, Pool};
use crate::physics::crowd::contacts::Contacts;
use crate::physics::crowd::drag::Resistance;
use crate::physics::crowd::friction::{Friction, Grip};
use crate::physics::crowd::gravity::Anchors;
use crate::physics::crowd::impulses::Edge;
use crate::physics::crowd::report::Report;
use crate::physics::guards::Guards;

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

/// What one body after the other is given in a step.
#[derive(Clone, Debug, Default)]
pub(crate) struct Pushes {
    /// Momenta before friction, pushes included, N·s.
    given: Vec<f64>,
    /// Velocities before any push, m/s.
    before: Vec<f64>,
    /// The bodies that are pushed, and those whose way a cluster has set.
    pushed: Vec<bool>,
    told: Vec<bool>,
    /// Plastic impacts.
    pub hits: Vec<(u32, u32)>,
    pub resistance: Resistance,
    /// Pairs side by side, and the impulses that parted them in the end.
    pub parting: Vec<Edge>,
}

impl Pushes {
    /// Begins an island of `n` bodies.
    pub fn begin(&mut self, n: usize) {
        self.resistance.begin();
        for list in [&mut self.given, &mut self.before] {
            list.resize(n, 0.0);
        }
        for flags in [&mut self.pushed, &mut self.told] {
            flags.resize(n, false);
        }
    }
}

pub(crate) struct Cross<'a> {
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
        self.pushes.hits.clear();
        self.pushes.resistance.restore(bodies);
        if !self.begin(bodies) && !self.contacts.carried {
            self.friction.rest(bodies.len());
            return;
        }
        let settled = self.rub_and_push(bodies);
        // Friction and pushes that answer each other round by round may drive.
        let gained = self.friction.gains(bodies, 0..bodies.len(), |i| bodies[i].free.x);
        if settled && !gained {
            guards.friction_unsettled += u64::from(!self.polish(bodies));
            return;
        }
        guards.friction_unsettled += 1;
        if gained {
            self.reset(bodies);
        }
        if self.merge(bodies, false) {
            self.hand_over(bodies, false);
        }
    }

    /// Free flight, and nobody pushed. Returns whether anything moves.
    fn begin(&mut self, bodies: &mut Bodies) -> bool {
        let per_second = 1.0 / self.dt;
        let mut moves = false;
        self.report.sides.clear();
        for i in 0..bodies.len() {
            bodies[i].end.x = bodies[i].free.x;
            bodies[i].mean.x = (bodies[i].to.x - bodies[i].from.x) * per_second;
            self.pushes.given[i] = bodies[i].mass * bodies[i].free.x;
            (self.pushes.pushed[i], self.pushes.told[i]) = (false, false);
            moves |= (bodies[i].free.x != 0.0) | (bodies[i].to.x != bodies[i].from.x);
        }
        moves
    }

    /// Friction, and merging with friction, in turns. Returns whether nothing closes too far any more.
    fn rub_and_push(&mut self, bodies: &mut Bodies) -> bool {
        self.rub(bodies);
        // Drag again, with the velocities that friction leaves, and friction with that drag.
        let Pushes { given, resistance, .. } = &mut *self.pushes;
        if bodies.airy && resistance.across(bodies, &self.friction.gripped, given, self.dt) {
            self.slide(bodies);
        }
        (0..bodies.len()).for_each(|i| self.pushes.before[i] = bodies[i].end.x);
        for _ in 0..if self.many { ROUNDS_OF_MANY } else { ROUNDS } {
            if self.stir(bodies) {
                self.rub(bodies);
            }
            if !self.merge(bodies, true) {
                return true;
            }
            if self.hand_over(bodies, true) {
                self.slide(bodies);
            }
            if !self.many && self.drives(bodies) {
                self.reset(bodies);
                return false;
            }
        }
        false
    }

    /// Back to friction alone.
    fn reset(&mut self, bodies: &mut Bodies) {
        self.begin(bodies);
        self.rub(bodies);
    }

    /// Whether a merged body is faster than it was and than its cluster: friction that did not come has driven it.
    fn drives(&self, bodies: &Bodies) -> bool {
        let mut joined = self.clusters.joined.iter().map(|i| *i as usize).filter(|i| *i < bodies.len());
        joined.any(|i| {
            let allowed = self.pushes.before[i].abs().max(self.clusters.velocity(i).abs());
            bodies[i].end.x.abs() > allowed * (1.0 + DRIVEN) + STILL
        })
    }

    /// The velocities and ways that friction leaves.
    fn slide(&mut self, bodies: &mut Bodies) {
        self.friction.solve(bodies, &self.pushes.given);
        self.friction.spread_ways(bodies, &self.pushes.told, self.dt);
    }

    fn rub(&mut self, bodies: &mut Bodies) {
        let Pushes { given, pushed, resistance, .. } = &mut *self.pushes;
        self.friction.wake(bodies, self.contacts, given, pushed);
        self.friction.touch(bodies, self.contacts, self.dt);
        if bodies.airy {
            resistance.along(bodies, &self.friction.gripped, self.dt);
        }
        self.friction.load(bodies, self.held_up, self.anchors);
        self.slide(bodies);
    }

    /// Merges what closes too far: with its friction where it `rubs`, else all by themselves. Returns whether anything does.
    fn merge(&mut self, bodies: &Bodies, rubs: bool) -> bool {
        let Self { contacts, friction, clusters, pushes, anchors, dt, .. } = self;
        let (n, Pushes { told, hits, .. }) = (bodies.len(), &mut **pushes);
        let brings = |i: usize| if i < n { node(bodies, friction, i, (told[i], *dt, rubs)) } else { Some(Node::default()) };
        let pool = Pool { before: |i| bodies[i].mean.x, slack: contacts.tolerances.hair / *dt, places: false };
        let live = || contacts.sides.iter().filter(|side| side.live);
        let pooled = clusters.pool(pool, live, |clusters, side| {
            let (a, b) = (side.first as usize, side.second as usize);
            let (Some(of_a), Some(of_b)) = (brings(a), brings(b)) else { return false };
            let fixed = |i: usize| (i >= n).then(|| Motion { velocity: bodies[i].end.x, mean: bodies[i].mean.x });
            if bodies[a].end.x - bodies[b].end.x > anchors.impact && !(clusters.is_joined(a) && clusters.is_joined(b)) {
                hits.push(if a < n { (a as u32, b as u32) } else { (b as u32, a as u32) });
            }
            clusters.join(a, fixed(a), of_a);
            clusters.join(b, fixed(b), of_b);
            true
        });
        if bodies.bounces && pooled.any {
            // What carries others does not bounce: friction alone would have to take them along.
            let alone = |i: usize| i >= n || !friction.carries(bodies, i);
            clusters.hit(live(), |side| {
                let part = if alone(side.first as usize) && alone(side.second as usize) { 1.0 } else { 0.0 };
                anchors.bounces.of(bodies, side, ACROSS).map(|restitution| part * restitution)
            });
        }
        pooled.any
    }

    /// Gives merged bodies their clusters' velocities, as pushes where something `rubs` at them. Returns whether anything does.
    fn hand_over(&mut self, bodies: &mut Bodies, rubs: bool) -> bool {
        let Self { clusters, friction, pushes, report, dt, .. } = self;
        let (n, mut any) = (bodies.len(), false);
        for i in clusters.joined.iter().map(|i| *i as usize) {
            report.along[i] = 0.0;
            let node = if i < n { node(bodies, friction, i, (pushes.told[i], *dt, rubs)) } else { None };
            let Some(node) = node else { continue };
            let push = push(clusters, i, &node);
            report.along[i] = -push;
            pushes.given[i] += push;
            pushes.told[i] = true;
            let velocity = clusters.velocity(i);
            bodies[i].mean.x = clusters.mean(i, 0.0);
            if !rubs || !friction.is_gripped[i] {
                bodies[i].end.x = velocity;
                continue;
            }
            any = true;
            friction.tell(i, velocity != 0.0);
        }
        report.drain_sides(clusters, n);
        any
    }

    /// Wakes what stands and is about to be hit from the side, and what touches it in a row. Returns whether there was any.
    fn stir(&mut self, bodies: &Bodies) -> bool {
        let (n, pushed, friction) = (bodies.len(), &mut self.pushes.pushed, &*self.friction);
        let slack = self.contacts.tolerances.hair / self.dt;
        let mut any = false;
        loop {
            let mut grows = false;
            for side in self.contacts.sides.iter().filter(|side| side.live) {
                let (a, b) = (side.first as usize, side.second as usize);
                let closes = bodies[a].mean.x > bodies[b].mean.x + side.bound + slack;
                if closes || (side.bound == 0.0 && a < n && b < n && pushed[a] != pushed[b]) {
                    for i in [a, b] {
                        let sleeps = i < n && !pushed[i] && !friction.is_awake[i];
                        if sleeps {
                            (pushed[i], grows) = (true, true);
                        }
                    }
                }
            }
            if !grows {
                return any;
            }
            any = true;
        }
    }
}

/// What a body brings: itself and its riders, and the friction of supports that stand still.
/// Nothing of a body that does not take part yet. Where nothing `rubs`, each brings itself.
fn node(bodies: &Bodies, friction: &Friction, i: usize, (told, dt, rubs): (bool, f64, bool)) -> Option<Node> {
    if rubs && !friction.is_awake[i] {
        return None;
    }
    let (velocity, mean) = (bodies[i].end.x, bodies[i].mean.x);
    if !rubs || !friction.is_gripped[i] {
        return Some(Node::free(bodies[i].mass, bodies[i].before.x, velocity, mean));
    }
    let riders = friction.riders[i];
    let tight = &friction.tight[friction.under(i)];
    let moves = |t: &crate::physics::crowd::friction::Tight| bodies[t.below as usize].end.x != 0.0 || t.skin != 0.0;
    if tight.is_empty() || tight.iter().any(moves) {
        return Some(Node::free(riders.mass, bodies[i].before.x, velocity, mean));
    }
    let mut node = Node { momentum: riders.momentum, ..Node::free(riders.mass, bodies[i].before.x, velocity, mean) };
    for t in tight {
        if t.grip != Grip::Stick {
            node.momentum -= t.impulse;
        }
        node.static_limit += t.held;
        node.kinetic_limit += t.dragged;
    }
    // Its way without friction: as in flight, with what was given besides; or such that friction takes it where a cluster has.
    let (free, of) = if told { (mean, velocity) } else { ((bodies[i].to.x - bodies[i].from.x) / dt, bodies[i].free.x) };
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
