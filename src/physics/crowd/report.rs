//! What the contacts of the last step exerted, for whoever wants to list it.
//!
//! For every body the impulses of all its contacts add up to what its momentum lacks beside the forces from outside: impacts are known
//! as they happened; along gravity what is held hands down its load in equal shares to the supports that it presses; a cluster passes on
//! impulses along the tree of its merges, from the leaves inwards; friction in a stack takes what then is left. Nothing here enters
//! the motion. It is recorded island by island while the steps are solved; for the first one that is asked for, the step is solved again.

use crate::physics::crowd::clusters::Clusters;
use crate::physics::crowd::dense::Dense;
use crate::physics::crowd::gravity::Anchors;
use crate::physics::crowd::{Axis, Other};
use crate::physics::store::bodies::Bodies;
use crate::physics::store::islands::Island;
use glam::DVec2;

/// What a contact gave during the last step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ContactImpulse {
    /// The body that feels it (the other one feels the opposite).
    pub a: usize,
    /// What exerts it.
    pub b: Other,
    /// The normal's direction.
    pub axis: Axis,
    /// The component along the normal, N·s: positive towards larger x or y.
    pub normal: f64,
    /// Friction, along the other direction, N·s.
    pub friction: f64,
    /// The middle of the contact, m.
    pub point: DVec2,
    /// Whether the two came together in this step; if not, what a lasting contact exerted.
    pub impact: bool,
    /// How often the island had been solved.
    pub solved: u32,
}

/// One contact, by slots; impulses on `a`, N·s, `normal` along the axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Record {
    pub a: u32,
    pub b: u32,
    pub axis: Axis,
    pub normal: f64,
    pub friction: f64,
}

/// A contact through which a cluster was merged, by slots, and the impulse that went through it.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Edge {
    pub a: u32,
    pub b: u32,
    /// On `b`, N·s.
    pub impulse: f64,
    /// Which part of it the contact returns when the step ends.
    pub restitution: f64,
}

/// What is recorded, and what it takes.
#[derive(Clone, Debug, Default)]
pub(crate) struct Report {
    /// Whether anybody wants to know.
    pub on: bool,
    pub list: Vec<ContactImpulse>,
    records: Vec<Record>,
    /// Side contacts of this island, with what they gave.
    pub sides: Vec<Edge>,
    /// By slot: impulses that a body lacks along and across, and in how many edges it is.
    along: Vec<f64>,
    across: Vec<f64>,
    degree: Vec<u32>,
}

impl Report {
    pub fn new(all: usize) -> Self {
        Self { along: vec![0.0; all], across: vec![0.0; all], degree: vec![0; all], ..Self::default() }
    }

    /// Notes what side contacts gave in one merging, by what each joined body lacks.
    pub fn drain_sides(&mut self, clusters: &Clusters, lack: impl Fn(usize) -> f64, n: usize) {
        let mut sides = std::mem::take(&mut self.sides);
        self.drain_into(&mut sides, clusters, lack, n);
        self.sides = sides;
    }

    /// Appends edges, with what goes through them.
    pub fn drain_into(&mut self, into: &mut Vec<Edge>, clusters: &Clusters, lack: impl Fn(usize) -> f64, n: usize) {
        let mut lacks = std::mem::take(&mut self.along);
        let from = into.len();
        into.extend(clusters.bouncing());
        clusters.joined.iter().for_each(|i| lacks[*i as usize] = lack(*i as usize));
        self.drain(&mut into[from..], &mut lacks, |i| i >= n);
        self.along = lacks;
    }

    /// Tells what went through the edges along gravity.
    pub fn drain_along(&mut self, bodies: &Bodies, anchors: &mut Anchors) {
        let Anchors { edges, loose, .. } = anchors;
        if edges.is_empty() {
            return;
        }
        let mut lacks = std::mem::take(&mut self.along);
        for i in edges.iter().flat_map(|edge| [edge.a as usize, edge.b as usize]).filter(|i| *i < loose.len()) {
            lacks[i] = bodies.mass[i] * (bodies.free_vy[i] - bodies.uy[i]);
        }
        self.drain(edges, &mut lacks, |i| i >= loose.len() || !loose[i]);
        self.along = lacks;
    }

    /// Distributes over the edges of trees what their bodies lack (`lack`, N·s: momentum that has to leave). What is `fixed` takes up
    /// anything.
    pub fn drain(&mut self, edges: &mut [Edge], lack: &mut [f64], fixed: impl Fn(usize) -> bool) {
        for edge in &*edges {
            self.degree[edge.a as usize] += 1;
            self.degree[edge.b as usize] += 1;
        }
        let mut left = edges.len();
        while left > 0 {
            let before = left;
            // Open edges are kept in front.
            let mut k = 0;
            while k < left {
                let (a, b) = (edges[k].a as usize, edges[k].b as usize);
                let (leaf, other) = if self.degree[a] == 1 && !fixed(a) {
                    (a, b)
                } else if self.degree[b] == 1 && !fixed(b) {
                    (b, a)
                } else {
                    k += 1;
                    continue;
                };
                edges[k].impulse = if leaf == a { lack[leaf] } else { -lack[leaf] };
                lack[other] += lack[leaf];
                lack[leaf] = 0.0;
                self.degree[a] -= 1;
                self.degree[b] -= 1;
                left -= 1;
                edges.swap(k, left);
            }
            if left == before {
                break;
            }
        }
        for edge in &*edges {
            (self.degree[edge.a as usize], self.degree[edge.b as usize]) = (0, 0);
        }
    }
}

impl Dense {
    /// Records the contacts of an island that has just been solved.
    pub fn record(&mut self, bodies: &Bodies, island: Island<'_>, down: f64) {
        let mut report = std::mem::take(&mut self.report);
        report.records.clear();
        self.record_along(bodies, island, &mut report);
        self.record_across(bodies, island, &mut report);
        let touch = self.contacts.tolerances.touch;
        for record in &report.records {
            if record.normal != 0.0 || record.friction != 0.0 {
                report.list.push(listed(bodies, record, touch, down));
            }
        }
        self.report = report;
    }

    fn record_along(&mut self, bodies: &Bodies, island: Island<'_>, report: &mut Report) {
        let n = bodies.len();
        let mut lack = std::mem::take(&mut report.along);
        for &i in island.members {
            let i = i as usize;
            lack[i] = bodies.mass[i] * (bodies.free_vy[i] - bodies.uy[i]) + self.walls.held_up[i];
        }
        let mut edges = std::mem::take(&mut self.anchors.edges);
        let loose = &self.anchors.loose;
        report.drain(&mut edges, &mut lack, |i| i >= n || !loose[i]);
        for edge in &edges {
            report.records.push(Record { a: edge.a, b: edge.b, axis: Axis::Gravity, normal: -edge.impulse, friction: 0.0 });
        }
        self.anchors.edges = edges;
        let slack = self.contacts.tolerances.hair;
        for &i in island.members.iter().rev() {
            let i = i as usize;
            if lack[i] <= 0.0 || self.anchors.loose[i] {
                continue;
            }
            let presses = |stack: &&crate::physics::crowd::contacts::Contact| {
                let j = stack.second as usize;
                stack.live
                    && self.anchors.held[j]
                    && ((bodies.mean_vy[i] - bodies.mean_vy[j] - stack.bound) * self.dt).abs() <= slack
            };
            let under = &self.contacts.stacks[self.contacts.under(i)];
            let count = under.iter().filter(presses).count();
            let share = lack[i] / count as f64;
            for stack in under.iter().filter(presses) {
                if (stack.second as usize) < n {
                    lack[stack.second as usize] += share;
                }
                report.records.push(Record { a: i as u32, b: stack.second, axis: Axis::Gravity, normal: -share, friction: 0.0 });
            }
        }
        report.along = lack;
    }

    fn record_across(&mut self, bodies: &Bodies, island: Island<'_>, report: &mut Report) {
        let n = bodies.len();
        // What each body still needs: its change, less what its sides gave.
        for &i in island.members {
            let i = i as usize;
            report.across[i] = bodies.mass[i] * (bodies.ux[i] - bodies.free_vx[i]);
        }
        for side in &report.sides {
            for (i, impulse) in [(side.a as usize, side.impulse), (side.b as usize, -side.impulse)] {
                if i < n {
                    report.across[i] += impulse;
                }
            }
        }
        // Stacks come bottom-up within merges and top-down within loads: by the upper body, the last first.
        // Slots are numbered when all is sought anew, for whatever reason: the order is that of the island.
        let (upper, lower) = (|record: &Record| self.place_of(record.a), |record: &Record| (self.place_of(record.b), record.b));
        report.records.sort_unstable_by(|a, b| upper(b).cmp(&upper(a)).then(lower(a).cmp(&lower(b))));
        let bears = |record: &Record| record.normal < 0.0 || (record.b as usize >= n && record.normal != 0.0);
        let mut k = 0;
        while k < report.records.len() {
            let upper = report.records[k].a;
            let end = k + report.records[k..].iter().take_while(|record| record.a == upper).count();
            let mut needs = report.across[upper as usize];
            let group = &mut report.records[k..end];
            let count = group.iter().filter(|record| bears(record)).count();
            let last = group.iter().rposition(bears);
            for (g, record) in group.iter_mut().enumerate().filter(|(_, record)| bears(record)) {
                let known = if self.friction.is_awake(upper as usize) {
                    self.friction.impulse(upper as usize, record.b)
                } else {
                    needs / count as f64
                };
                record.friction = if Some(g) == last { needs } else { known };
                needs -= record.friction;
                if (record.b as usize) < n {
                    report.across[record.b as usize] += record.friction;
                }
            }
            k = end;
        }
        for side in &report.sides {
            if side.impulse != 0.0 {
                report.records.push(Record { a: side.a, b: side.b, axis: Axis::Across, normal: -side.impulse, friction: 0.0 });
            }
        }
        self.walls.record(&mut report.records);
    }
}

/// A record for the outside.
fn listed(bodies: &Bodies, record: &Record, touch: f64, down: f64) -> ContactImpulse {
    let n = bodies.len();
    let Record { mut a, mut b, axis, mut normal, mut friction } = *record;
    if a as usize >= n {
        (a, b, normal, friction) = (b, a, -normal, -friction);
    }
    let (i, j) = (a as usize, b as usize);
    let gap = |x: &[f64], h: &[f64]| (x[i] - x[j]).abs() - h[i] - h[j];
    let side = |x: &[f64]| if x[j] < x[i] { -1.0 } else { 1.0 };
    let middle = |x: &[f64], h: &[f64]| 0.5 * ((x[i] - h[i]).max(x[j] - h[j]) + (x[i] + h[i]).min(x[j] + h[j]));
    let (point, impact) = match axis {
        Axis::Gravity => {
            let closes = (bodies.vy[i] - bodies.vy[j]) * side(&bodies.y) > touch && !bodies.rides_along(i, j, 0.0);
            let point = DVec2::new(middle(&bodies.px, &bodies.hx), bodies.py[i] + side(&bodies.y) * bodies.hy[i]);
            (point, closes || gap(&bodies.y, &bodies.hy) > touch)
        }
        Axis::Across => {
            let closes = (bodies.vx[i] - bodies.vx[j]) * side(&bodies.x) > touch && !bodies.rides_across(i, j, 0.0);
            let point = DVec2::new(bodies.px[i] + side(&bodies.x) * bodies.hx[i], middle(&bodies.py, &bodies.hy));
            (point, closes || gap(&bodies.x, &bodies.hx) > touch)
        }
    };
    let (along, other) = if axis == Axis::Gravity { (down, 1.0) } else { (1.0, down) };
    let b = if j < n { Other::Body(j) } else { Other::Surface(j - n) };
    let a = i;
    ContactImpulse {
        a,
        b,
        axis,
        normal: normal * along,
        friction: friction * other,
        point: point * DVec2::new(1.0, down),
        impact,
        solved: 0,
    }
}
