//! Velocities across gravity.
//!
//! Friction of the stacks ([`crate::physics::crowd::friction`]) and merging with riders and ground friction ([`crate::physics::crowd::clusters`])
//! in turns (`docs/physics.md`, The crowd step, 3); contacts left after [`ROUNDS`], and islands in which all that drives, merge without friction.

use crate::physics::crowd::clusters::{ClusterMotion, Clusters, Node, Pool};
use crate::physics::crowd::{ACROSS, ROUNDING, bodies::Bodies, bodies::Member, contacts::Contacts, contacts::CrowdContact};
use crate::physics::crowd::{gravity::Anchors, gravity::SLACK, report::Report};
use crate::physics::{crowd::friction::Friction, crowd::friction::Grip, flight::air::fly_through, state::Guards};
use glam::DVec2;

/// Rounds of friction and merging; in an island of many one, but for what closes in the end. Fewer: riders of pushed bodies follow a step late.
const ROUNDS: usize = 3;
/// A pushed body that is faster by this part than it was and than its cluster: friction that did not come has driven it, and the pushes are
/// dropped. Smaller: rounding drops pushes; larger: friction drives bodies.
const DRIVEN: f64 = 1e-9;

#[derive(Clone, Debug, Default)]
pub(crate) struct Pushes {
    /// Momenta before friction, pushes included, N·s.
    given: Vec<f64>,
    before: Vec<f64>,
    pushed: Vec<bool>,
    told: Vec<bool>,
    /// Settled bodies that the row of a pushed one touches.
    pub reached: Vec<u32>,
    pub hits: Vec<(u32, u32)>,
    pub resistance: Resistance,
    /// Pairs that touch side by side when the step ends.
    parting: Vec<CrowdContact>,
}

impl Pushes {
    pub fn begin(&mut self, n: usize) {
        self.resistance.saved.clear();
        self.reached.clear();
        [&mut self.given, &mut self.before].into_iter().for_each(|list| list.resize(n, 0.0));
        [&mut self.pushed, &mut self.told].into_iter().for_each(|flags| flags.resize(n, false));
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
    pub many: bool,
}

impl Cross<'_> {
    pub fn solve(&mut self, bodies: &mut Bodies, guards: &mut Guards) {
        self.pushes.hits.clear();
        self.pushes.resistance.restore(bodies);
        if !self.begin(bodies) && !self.contacts.carried {
            self.friction.rest(bodies.len());
            return;
        }
        let settled = self.solve_friction_and_pushes(bodies);
        // Friction and pushes that answer each other round by round may drive.
        let gained = self.friction.gains(bodies, 0..bodies.len(), |i| bodies[i].free.x);
        if settled && !gained {
            guards.friction_unsettled += u64::from(!self.part_closing(bodies));
            return;
        }
        guards.friction_unsettled += 1;
        if gained {
            self.reset(bodies);
        }
        if self.merge(bodies, false) {
            self.pass_impulses(bodies, false);
        }
        self.part_closing(bodies);
    }

    fn begin(&mut self, bodies: &mut Bodies) -> bool {
        let per_second = 1.0 / self.dt;
        let mut moves = false;
        self.report.sides.clear();
        for i in 0..bodies.len() {
            let body = &mut bodies[i];
            body.end.x = body.free.x;
            body.mean.x = (body.to.x - body.from.x) * per_second;
            self.pushes.given[i] = body.mass * body.free.x;
            (self.pushes.pushed[i], self.pushes.told[i]) = (false, false);
            moves |= (body.free.x != 0.0) | (body.to.x != body.from.x);
        }
        moves
    }

    fn solve_friction_and_pushes(&mut self, bodies: &mut Bodies) -> bool {
        self.solve_friction(bodies);
        // Drag again, with the velocities that friction leaves, and friction with that drag.
        let Pushes { given, resistance, .. } = &mut *self.pushes;
        if bodies.airy && resistance.across(bodies, &self.friction.gripped, given, self.dt) {
            self.slide(bodies);
        }
        (0..bodies.len()).for_each(|i| self.pushes.before[i] = bodies[i].end.x);
        for _ in 0..if self.many { 1 } else { ROUNDS } {
            if self.wake_pushed(bodies) {
                self.solve_friction(bodies);
            }
            if !self.merge(bodies, true) {
                return true;
            }
            if self.pass_impulses(bodies, true) {
                self.slide(bodies);
            }
            if !self.many && self.drives(bodies) {
                self.reset(bodies);
                return false;
            }
        }
        false
    }

    fn reset(&mut self, bodies: &mut Bodies) {
        self.begin(bodies);
        self.solve_friction(bodies);
    }

    fn drives(&self, bodies: &Bodies) -> bool {
        let mut joined = self.clusters.joined.iter().map(|i| *i as usize).filter(|i| *i < bodies.len());
        joined.any(|i| {
            let allowed = self.pushes.before[i].abs().max(self.clusters.velocity(i).abs());
            bodies[i].end.x.abs() > allowed * (1.0 + DRIVEN) + SLACK
        })
    }

    fn slide(&mut self, bodies: &mut Bodies) {
        self.friction.solve(bodies, &self.pushes.given);
        self.friction.spread_ways(bodies, &self.pushes.told, self.dt);
    }

    fn solve_friction(&mut self, bodies: &mut Bodies) {
        let Pushes { given, pushed, resistance, .. } = &mut *self.pushes;
        self.friction.wake(bodies, self.contacts, given, pushed);
        self.friction.touch(bodies, self.contacts, self.dt);
        if bodies.airy {
            resistance.along(bodies, &self.friction.gripped, self.dt);
        }
        self.friction.load(bodies, self.held_up, self.anchors);
        self.slide(bodies);
    }

    /// Merges pairs that close: with friction where it `rubs`. Returns whether any does.
    fn merge(&mut self, bodies: &Bodies, rubs: bool) -> bool {
        let Self { contacts, friction, clusters, pushes, anchors, dt, .. } = self;
        let (n, Pushes { told, hits, .. }) = (bodies.len(), &mut **pushes);
        let brings = |i: usize| if i < n { node(bodies, friction, i, (told[i], *dt, rubs)) } else { Some(Node::default()) };
        let pool = Pool { before: |i| bodies[i].mean.x, slack: contacts.tolerances.hair / *dt, places: false };
        let lists = [&contacts.sides[..], &[]];
        let (any, _) = clusters.pool(pool, lists, |clusters, side| {
            let (a, b) = (side.first as usize, side.second as usize);
            let (Some(of_a), Some(of_b)) = (brings(a), brings(b)) else { return false };
            let fixed = |i: usize| (i >= n).then(|| ClusterMotion { velocity: bodies[i].end.x, mean: bodies[i].mean.x });
            if bodies[a].end.x - bodies[b].end.x > anchors.impact && !(clusters.is_joined(a) && clusters.is_joined(b)) {
                hits.push(if a < n { (a as u32, b as u32) } else { (b as u32, a as u32) });
            }
            clusters.join(a, fixed(a), of_a);
            clusters.join(b, fixed(b), of_b);
            true
        });
        if bodies.bounces && any {
            // A body that carries others does not bounce: friction alone would have to take them along.
            let alone = |i: usize| i >= n || !friction.carries(bodies, i);
            clusters.hit(lists, |side| {
                let part = if alone(side.first as usize) && alone(side.second as usize) { 1.0 } else { 0.0 };
                anchors.bounces.of(bodies, side, ACROSS).map(|restitution| part * restitution)
            });
        }
        any
    }

    fn pass_impulses(&mut self, bodies: &mut Bodies, rubs: bool) -> bool {
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
            friction.free_pushed(i, velocity != 0.0);
        }
        report.drain_sides(clusters, n);
        any
    }

    /// Wakes standing bodies that are about to be hit from the side, and the row that touches them. Returns whether there are any.
    fn wake_pushed(&mut self, bodies: &Bodies) -> bool {
        let Pushes { pushed, reached, .. } = &mut *self.pushes;
        let (n, friction) = (bodies.len(), &*self.friction);
        let slack = self.contacts.tolerances.hair / self.dt;
        let mut any = false;
        loop {
            let mut grows = false;
            for side in self.contacts.sides.iter().filter(|side| side.live) {
                let (a, b) = (side.first as usize, side.second as usize);
                let closes = bodies[a].mean.x > bodies[b].mean.x + side.bound + slack;
                let is_pushed = |i: usize| pushed.get(i).is_some_and(|pushed| *pushed);
                if closes || (side.bound == 0.0 && is_pushed(a) != is_pushed(b) && bodies.is_body(a) && bodies.is_body(b)) {
                    reached.extend([a, b].into_iter().filter(|i| *i >= n && bodies.is_body(*i)).map(|i| i as u32));
                    for i in [a, b] {
                        if i < n && !pushed[i] && !friction.is_awake[i] {
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

    /// Merges pairs side by side that still close when the step ends, in turns with the friction under them. Returns whether nothing closes any more.
    fn part_closing(&mut self, bodies: &mut Bodies) -> bool {
        let Self { contacts, friction, clusters, pushes, anchors, report, dt, .. } = self;
        let (n, slack, Pushes { parting, .. }) = (bodies.len(), contacts.tolerances.hair / *dt, &mut **pushes);
        // What arrives just as the step ends bounces in the next.
        let arrives =
            |side: &CrowdContact| bodies.bounces && side.bound > slack && anchors.bounces.of(bodies, side, ACROSS).is_some();
        let touches = |side: &&CrowdContact| {
            side.live
                && bodies[side.first as usize].mean.x - bodies[side.second as usize].mean.x - side.bound >= -slack
                && !arrives(side)
        };
        let closes = |side: &CrowdContact| {
            let (u, v) = (bodies[side.first as usize].end.x, bodies[side.second as usize].end.x);
            u - v > ROUNDING * (u.abs() + v.abs()) + SLACK
        };
        if !contacts.sides.iter().any(|side| closes(side) && touches(&side)) {
            return true;
        }
        parting.clear();
        parting.extend(contacts.sides.iter().filter(touches).map(|side| CrowdContact { bound: 0.0, ..*side }));
        for round in 1..=ROUNDS {
            let pool = Pool { before: |i| bodies[i].end.x, slack: SLACK, places: false };
            let (any, _) = clusters.pool(pool, [&parting[..], &[]], |clusters, side| {
                for i in [side.first as usize, side.second as usize] {
                    let Member { mass, before, end, .. } = bodies[i];
                    let fixed = (i >= n).then_some(ClusterMotion { velocity: end.x, mean: end.x });
                    clusters.join(i, fixed, Node::free(mass, before.x, end.x, end.x));
                }
                true
            });
            let mut fastest = 0.0f64;
            for i in clusters.joined.iter().map(|i| *i as usize) {
                let velocity = clusters.velocity(i);
                report.along[i] = 0.0;
                if i < n {
                    report.along[i] = bodies[i].mass * (bodies[i].end.x - velocity);
                    bodies[i].end.x = velocity;
                    fastest = fastest.max(velocity.abs());
                }
            }
            report.drain_sides(clusters, n);
            // Nothing closes when the last round ends.
            if !any || (round < ROUNDS && friction.sweep(bodies) <= ROUNDING * fastest + SLACK) {
                return true;
            }
        }
        false
    }
}

/// The body with its riders and the friction of supports that stand still; none if it does not take part. Where nothing `rubs`, itself.
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
    if tight.is_empty() || tight.iter().any(|t| bodies[t.below as usize].end.x != 0.0 || t.belt_velocity != 0.0) {
        return Some(Node::free(riders.mass, bodies[i].before.x, velocity, mean));
    }
    let mut node = Node { momentum: riders.momentum, ..Node::free(riders.mass, bodies[i].before.x, velocity, mean) };
    for t in tight {
        if t.grip != Grip::Stick {
            node.momentum -= t.impulse;
        }
        node.static_limit += t.static_limit;
        node.kinetic_limit += t.kinetic_limit;
    }
    // Its way without friction: that of flight; or such that friction takes it where a cluster has.
    let (free, of) = if told { (mean, velocity) } else { ((bodies[i].to.x - bodies[i].from.x) / dt, bodies[i].free.x) };
    node.way = node.mass * free + 0.5 * (node.momentum - node.mass * of);
    Some(node)
}

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

/// Drag on bodies in contact. Free flight knows no contacts: a standing body would fall within the step and show its top to the air, and a braked
/// one be faster. So their drag is found again, by a flight under the forces of their contacts as well: stable however light the body is.
#[derive(Clone, Debug, Default)]
pub(crate) struct Resistance {
    pub saved: Vec<(u32, DVec2)>,
}

impl Resistance {
    pub fn restore(&mut self, bodies: &mut Bodies) {
        for (i, free) in self.saved.drain(..).rev() {
            bodies[i as usize].free = free;
        }
    }

    pub fn along(&mut self, bodies: &mut Bodies, of: &[u32], dt: f64) {
        // For the rounds of friction as well.
        self.saved.reserve(4 * of.len());
        for i in of.iter().map(|i| *i as usize) {
            let stands = bodies[i].before.y == 0.0 && bodies[i].end.y == 0.0 && bodies[i].mean.y == 0.0;
            if stands && bodies.meets_air(i) {
                self.saved.push((i as u32, bodies[i].free));
                bodies[i].free.y = bodies[i].pull.y * dt;
            }
        }
    }

    pub fn across(&mut self, bodies: &mut Bodies, of: &[u32], given: &mut [f64], dt: f64) -> bool {
        let mut any = false;
        for i in of.iter().map(|i| *i as usize) {
            if !bodies.meets_air(i) || (bodies[i].before.x == 0.0 && bodies[i].end.x == 0.0) {
                continue;
            }
            let body = &mut bodies[i];
            let pull = body.pull + (body.end - body.free) / dt;
            let (_, after) = fly_through((DVec2::ZERO, body.before), pull, &body.drag, dt);
            let drag = after.x - (body.before.x + pull.x * dt);
            let change = (body.before.x + body.pull.x * dt + drag) - body.free.x;
            self.saved.push((i as u32, body.free));
            body.free.x += change;
            body.to.x += 0.5 * change * dt;
            given[i] += body.mass * change;
            any = true;
        }
        any
    }
}
