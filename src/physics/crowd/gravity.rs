//! Velocities along gravity.
//!
//! One linear pass bottom-up (`docs/physics.md`, The crowd step, 2): a body's bound is the smallest over its *anchored* supports of their way and
//! the gap. Bodies that close without an anchor are merged ([`crate::physics::crowd::clusters`]).

use crate::physics::crowd::clusters::{ClusterMotion, Clusters, Node, Pool};
use crate::physics::crowd::contacts::{Bounces, Contacts, CrowdContact};
use crate::physics::crowd::{ALONG, Edge, bodies::Bodies};
use crate::physics::data::lists::{NONE, refill};

/// Relative velocities below this are rounding, and count as none when loads are found, m/s. Larger: slow touches rub.
pub(crate) const SLACK: f64 = 1e-12;

#[derive(Clone, Debug, Default)]
pub(crate) struct Anchors {
    pub held: Vec<bool>,
    /// Held from the start, without an impact.
    pub rests: Vec<bool>,
    pub lands: Vec<u32>,
    /// Of a body that a wall may hold by friction, the velocity of the wall, m/s.
    pub hung: Vec<Option<f64>>,
    pub any_hung: bool,
    pub bounce: Vec<f64>,
    pub any_bounces: bool,
    pub bounces: Bounces,
    /// The bodies that were merged in the air, and the pairs.
    pub loose: Vec<bool>,
    pub edges: Vec<Edge>,
    /// Plastic impacts, and how fast one must close, m/s.
    pub hits: Vec<(u32, u32)>,
    pub impact: f64,
}

impl Anchors {
    pub fn begin(&mut self, n: usize, all: usize) {
        for held in [&mut self.held, &mut self.rests] {
            refill(held, n, false);
            held.resize(all, true);
        }
        self.lands.resize(n, NONE);
        self.bounce.resize(n, 0.0);
        self.loose.resize(n, false);
        refill(&mut self.hung, n, None);
        self.any_hung = false;
    }
}

pub(crate) struct Along<'a> {
    pub contacts: &'a Contacts,
    pub anchors: &'a mut Anchors,
    pub clusters: &'a mut Clusters,
    pub dt: f64,
}

impl Along<'_> {
    pub fn solve(&mut self, bodies: &mut Bodies) {
        let (contacts, anchors, dt) = (self.contacts, &mut *self.anchors, self.dt);
        let mut loose = !contacts.ceilings.is_empty();
        anchors.edges.clear();
        anchors.hits.clear();
        anchors.any_bounces = false;
        let (per_second, slack) = (1.0 / dt, contacts.tolerances.hair / dt);
        for i in 0..bodies.len() {
            let mut velocity = bodies[i].free.y;
            let mut mean = (bodies[i].to.y - bodies[i].from.y) * per_second;
            let hung = if anchors.any_hung { anchors.hung[i] } else { None };
            if let Some(wall) = hung {
                (velocity, mean) = (wall, wall);
            }
            let (mut bound, mut over, mut support, mut gap) = (f64::INFINITY, f64::INFINITY, i, 0.0);
            for stack in contacts.stacks[contacts.under(i)].iter().filter(|stack| stack.live) {
                let j = stack.second as usize;
                let limit = bodies[j].mean.y + stack.bound;
                if anchors.held[j] {
                    if limit < bound || (limit == bound && bodies[j].end.y < bodies[support].end.y) {
                        (bound, support, gap) = (limit, j, stack.bound);
                    }
                } else {
                    over = over.min(limit);
                }
            }
            (anchors.held[i], anchors.rests[i], anchors.loose[i]) = (hung.is_some(), hung.is_some(), false);
            (anchors.lands[i], anchors.bounce[i]) = (NONE, 0.0);
            // On a surface that speeds up or slows down a body stays while it presses, though its velocity is one step late.
            let presses = contacts.carried && gap == 0.0 && bound < f64::INFINITY && velocity >= bodies[support].end.y;
            if mean >= bound || (presses && bodies.rides(i, support, ALONG, 0.0)) {
                mean = bound;
                if velocity >= bodies[support].end.y {
                    if velocity - bodies[support].end.y > anchors.impact {
                        anchors.hits.push((i as u32, support as u32));
                    }
                    velocity = bodies[support].end.y;
                    anchors.held[i] = true;
                    anchors.lands[i] = if gap > 0.0 { support as u32 } else { NONE };
                    anchors.rests[i] = bodies.rides(i, support, ALONG, 0.0) && mean == bodies[support].mean.y;
                    if bodies.bounces
                        && !anchors.rests[i]
                        && let Some(restitution) = restitution(bodies, contacts, anchors, i, (bound, mean * dt, velocity))
                    {
                        (anchors.bounce[i], anchors.any_bounces) = (restitution, true);
                    }
                }
            }
            loose |= mean > over + slack;
            (bodies[i].end.y, bodies[i].mean.y) = (velocity, mean);
        }
        if loose {
            merge(bodies, contacts, anchors, self.clusters, dt);
        }
    }
}

/// The restitution of a body that its supports stop at the mean velocity `bound`, if it bounces: its `way` (m) ends with the velocity `end`.
fn restitution(bodies: &Bodies, contacts: &Contacts, anchors: &Anchors, i: usize, of: (f64, f64, f64)) -> Option<f64> {
    let (bound, way, end) = of;
    let bears = |stack: &&CrowdContact| {
        let j = stack.second as usize;
        stack.live && anchors.held[j] && bodies[j].mean.y + stack.bound == bound
    };
    let all = contacts.stacks[contacts.under(i)].iter().filter(bears);
    let least = all.map(|stack| bodies.coefficients(i, stack.second as usize).restitution).fold(1.0, f64::min);
    (least > 0.0 && anchors.bounces.rebound(&bodies[i], way, end, least) != end).then_some(least)
}

fn merge(bodies: &mut Bodies, contacts: &Contacts, anchors: &mut Anchors, clusters: &mut Clusters, dt: f64) {
    let n = bodies.len();
    let slack = contacts.tolerances.hair / dt;
    let node = |i: usize| {
        let mean = |i: usize| (bodies[i].to.y - bodies[i].from.y) / dt;
        if i < n { Node::free(bodies[i].mass, bodies[i].before.y, bodies[i].free.y, mean(i)) } else { Node::default() }
    };
    let fixed = |held: bool, i: usize| held.then(|| ClusterMotion { velocity: bodies[i].end.y, mean: bodies[i].mean.y });
    let pool = Pool { before: |i| bodies[i].mean.y, slack, places: false };
    let lists = [&contacts.stacks[..], &contacts.ceilings];
    clusters.pool(pool, lists, |clusters, contact| {
        let (i, j) = (contact.first as usize, contact.second as usize);
        let ground = if clusters.is_joined(j) { clusters.is_fixed(j) } else { anchors.held[j] };
        if i < n && anchors.held[i] && !ground && !clusters.is_joined(i) {
            // Pushed off its supports from below.
            (anchors.held[i], anchors.rests[i]) = (false, false);
        }
        if bodies[i].free.y - bodies[j].free.y > anchors.impact {
            anchors.hits.push(if i < n { (i as u32, j as u32) } else { (j as u32, i as u32) });
        }
        clusters.join(j, fixed(anchors.held[j], j), node(j));
        clusters.join(i, fixed(anchors.held[i], i), node(i));
        true
    });
    if bodies.bounces {
        clusters.hit(lists, |contact| anchors.bounces.of(bodies, contact, ALONG));
    }
    for i in clusters.joined.iter().map(|i| *i as usize).filter(|i| *i < n) {
        anchors.lands[i] = if clusters.came_fixed(i) { anchors.lands[i] } else { NONE };
        let (own, mean) = (bodies[i].mean.y.min(0.0), clusters.mean(i, 0.0));
        // Nothing that stands lifts a body that something else has stopped on its way up.
        let lifted = !contacts.carried && clusters.is_fixed(i) && mean < own - slack;
        bodies[i].mean.y = if lifted { own } else { mean };
        bodies[i].end.y = clusters.velocity(i);
        anchors.held[i] |= clusters.is_fixed(i);
        anchors.loose[i] = !clusters.came_fixed(i);
        if anchors.loose[i] {
            anchors.bounce[i] = if clusters.is_fixed(i) { clusters.restitution(i) } else { 0.0 };
        }
    }
    let alone = |edge: Edge| if clusters.is_fixed(edge.a as usize) { Edge { restitution: 0.0, ..edge } } else { edge };
    anchors.edges.extend(clusters.bouncing().map(alone));
}

/// Loads along gravity: which supports bear a body, and the share of its load on each.
impl Contacts {
    pub fn closes(bodies: &Bodies, contact: &CrowdContact, slack: f64) -> bool {
        contact.live && Self::gap(bodies, contact) <= slack
    }

    /// How far from touch its ends are on average over the step, m/s.
    fn gap(bodies: &Bodies, contact: &CrowdContact) -> f64 {
        let (first, second) = (contact.first as usize, contact.second as usize);
        (bodies[first].mean.y - bodies[second].mean.y - contact.bound).abs()
    }

    /// Adds up loads top-down, N·s: each body that does not hang hands its own on, in equal shares, to the held supports that it presses, and to
    /// `give`.
    pub fn hand_down(&self, bodies: &Bodies, anchors: &Anchors, loads: &mut [f64], mut give: impl FnMut(u32, u32, f64)) {
        let slack = self.tolerances.hair / anchors.bounces.dt;
        for i in (0..bodies.len()).rev() {
            let load = loads[i];
            if load <= 0.0 || (anchors.any_hung && anchors.hung[i].is_some()) {
                continue;
            }
            let held = || self.stacks[self.under(i)].iter().filter(|stack| stack.live && anchors.held[stack.second as usize]);
            // Where none is that close, the closest has stopped it.
            let slack = held().map(|stack| Self::gap(bodies, stack)).fold(f64::INFINITY, f64::min).max(slack);
            let under = || held().filter(|stack| Self::gap(bodies, stack) <= slack);
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
