//! Impulses of contacts, for lists alone: for each body they add up to what its momentum lacks beside the forces from outside. Held bodies hand down
//! their loads in equal shares; a cluster passes impulses along the tree of its merges, leaves first; a stack's friction takes the rest.

use crate::physics::crowd::{ContactImpulse, Edge, Record, bodies::Bodies, clusters::Clusters, gravity::Anchors};

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
