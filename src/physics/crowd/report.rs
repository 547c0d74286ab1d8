//! Impulses of the contacts of the last step, for lists: for each body they add up to what its momentum lacks beside the forces from outside. Held
//! bodies hand down their loads in equal shares; a cluster passes on impulses along the tree of its merges, from the leaves inwards; friction in a
//! stack takes what is left. Nothing here enters the motion. [`Dense::record`] records the contacts of an island that a crowd step has solved.

use crate::physics::crowd::bodies::{Bodies, Frame};
use crate::physics::crowd::clusters::Clusters;
use crate::physics::crowd::dense::Dense;
use crate::physics::crowd::gravity::Anchors;
use crate::physics::crowd::{ACROSS, ALONG};
use crate::physics::data::on_axis;
use glam::DVec2;

#[derive(Clone, Debug, Default)]
pub(crate) struct Report {
    pub on: bool,
    pub list: Vec<ContactImpulse>,
    pub records: Vec<Record>,
    pub sides: Vec<Edge>,
    /// By body: impulses that a body lacks along and across, and in how many edges it is.
    pub along: Vec<f64>,
    pub across: Vec<f64>,
    degree: Vec<u32>,
}

impl Report {
    pub fn begin(&mut self, all: usize) {
        self.along.resize(all, 0.0);
        self.across.resize(all, 0.0);
        self.degree.resize(all, 0);
    }

    pub fn drain_sides(&mut self, clusters: &Clusters, n: usize) {
        let (mut sides, mut lacks) = (std::mem::take(&mut self.sides), std::mem::take(&mut self.along));
        let from = sides.len();
        sides.extend(clusters.bouncing());
        self.drain(&mut sides[from..], &mut lacks, |i| i >= n);
        (self.sides, self.along) = (sides, lacks);
    }

    pub fn drain_along(&mut self, bodies: &Bodies, anchors: &mut Anchors) {
        let Anchors { edges, loose, .. } = anchors;
        if edges.is_empty() {
            return;
        }
        let mut lacks = std::mem::take(&mut self.along);
        for i in edges.iter().flat_map(|edge| [edge.a as usize, edge.b as usize]).filter(|i| *i < loose.len()) {
            lacks[i] = bodies[i].mass * (bodies[i].free.y - bodies[i].end.y);
        }
        self.drain(edges, &mut lacks, |i| i >= loose.len() || !loose[i]);
        self.along = lacks;
    }

    /// Distributes over the edges of trees the momentum that has to leave their bodies (`lack`, N·s). `fixed` bodies take up anything.
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

/// The impulse of a contact in the last step, in the numbers of the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ContactImpulse {
    /// The body that feels it, and the body or surface that exerts it and feels the opposite.
    pub a: u32,
    pub b: u32,
    pub axis: usize,
    /// N·s along the axis, and friction along the other one, on `a`.
    pub normal: f64,
    pub friction: f64,
    /// The middle of the contact, m.
    pub point: DVec2,
    /// Whether the two came together in this step; if not, what a lasting contact exerted.
    pub impact: bool,
    pub solved: u32,
}

/// One contact in the island's numbers; impulses on `a`, N·s, `normal` along the axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Record {
    pub a: u32,
    pub b: u32,
    pub axis: usize,
    pub normal: f64,
    pub friction: f64,
}

/// A contact through which a cluster was merged, in the island's numbers, and the impulse that went through it.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Edge {
    pub a: u32,
    pub b: u32,
    /// On `b`, N·s.
    pub impulse: f64,
    /// Which part of it the contact returns when the step ends.
    pub restitution: f64,
}

impl Dense {
    pub fn record(&mut self, bodies: &Bodies, frame: Frame) {
        let mut report = std::mem::take(&mut self.report);
        report.records.clear();
        self.record_along(bodies, &mut report);
        self.record_across(bodies, &mut report);
        let touch = self.contacts.tolerances.touch;
        for record in &report.records {
            if record.normal != 0.0 || record.friction != 0.0 {
                report.list.push(listed(bodies, record, touch, frame));
            }
        }
        self.report = report;
    }

    fn record_along(&mut self, bodies: &Bodies, report: &mut Report) {
        let n = bodies.len();
        let mut lack = std::mem::take(&mut report.along);
        for i in 0..bodies.len() {
            lack[i] = bodies[i].mass * (bodies[i].free.y - bodies[i].end.y) + self.walls.held_up[i];
        }
        let mut edges = std::mem::take(&mut self.anchors.edges);
        let loose = &self.anchors.loose;
        report.drain(&mut edges, &mut lack, |i| i >= n || !loose[i]);
        for edge in &edges {
            report.records.push(Record { a: edge.a, b: edge.b, axis: ALONG, normal: -edge.impulse, friction: 0.0 });
        }
        self.anchors.edges = edges;
        let passed_on = (0..n).filter(|i| self.anchors.loose[*i]);
        passed_on.for_each(|i| lack[i] = 0.0);
        let records = &mut report.records;
        self.contacts.hand_down(bodies, &self.anchors, &mut lack, |a, b, share| {
            records.push(Record { a, b, axis: ALONG, normal: -share, friction: 0.0 });
        });
        report.along = lack;
    }

    fn record_across(&mut self, bodies: &Bodies, report: &mut Report) {
        let n = bodies.len();
        for i in 0..bodies.len() {
            report.across[i] = bodies[i].mass * (bodies[i].end.x - bodies[i].free.x);
        }
        for side in &report.sides {
            report.across[side.a as usize] += side.impulse;
            report.across[side.b as usize] -= side.impulse;
        }
        // Stacks come bottom-up within merges and top-down within loads: by the upper body, the last first.
        report.records.sort_unstable_by(|a, b| b.a.cmp(&a.a).then(a.b.cmp(&b.b)));
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
                let known = if self.friction.is_awake[upper as usize] {
                    self.friction.impulse(upper as usize, record.b)
                } else {
                    needs / count as f64
                };
                record.friction = if Some(g) == last { needs } else { known };
                needs -= record.friction;
                report.across[record.b as usize] += record.friction;
            }
            k = end;
        }
        let pushes = |side: &Edge| Record { a: side.a, b: side.b, axis: ACROSS, normal: -side.impulse, friction: 0.0 };
        report.records.extend(report.sides.iter().map(pushes));
        self.walls.record(&mut report.records);
    }
}

fn listed(bodies: &Bodies, record: &Record, touch: f64, frame: Frame) -> ContactImpulse {
    let n = bodies.len();
    let Record { mut a, mut b, axis, mut normal, mut friction } = *record;
    if a as usize >= n {
        (a, b, normal, friction) = (b, a, -normal, -friction);
    }
    let (first, second, far) = (&bodies[a as usize], &bodies[b as usize], 1 - axis);
    let side = if second.from[axis] < first.from[axis] { -1.0 } else { 1.0 };
    let gap = (first.from - second.from).abs()[axis] - first.half[axis] - second.half[axis];
    let closes = (first.before - second.before)[axis] * side > touch && !bodies.rides(a as usize, b as usize, axis, 0.0);
    let (from, to) = ((first.to - first.half).max(second.to - second.half), (first.to + first.half).min(second.to + second.half));
    let mut point = DVec2::ZERO;
    (point[axis], point[far]) = (first.to[axis] + side * first.half[axis], 0.5 * (from[far] + to[far]));
    let (vector, axis) = (frame.turn(on_axis(axis, normal, friction)), frame.axis(axis));
    let (normal, friction, point) = (vector[axis], vector[1 - axis], frame.turn(point));
    ContactImpulse { a, b, axis, normal, friction, point, impact: gap > touch || closes, solved: 0 }
}
