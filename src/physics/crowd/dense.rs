//! The stages of a crowd step of one island. The step leaves places and velocities in [`Bodies`].

use crate::physics::crowd::{ACROSS, ALONG, bodies::Bodies, bodies::Group, clusters::Clusters, contacts::Contacts, place};
use crate::physics::crowd::{contacts::Tolerances, cross::Cross, cross::Pushes, gravity::Along, gravity::Anchors, report::Report};
use crate::physics::{crowd::contacts::Bounces, crowd::friction::Friction, crowd::walls::Walls, data::tuning::MANY, state::Guards};
use glam::DVec2;

/// Solutions again for pairs that were expected to pass and did not. More: slower; fewer: more is put back.
const LOOKS: usize = 3;

/// A plastic impact is reported if it stops more than this many steps of gravity, and m/s. Smaller: rest is reported.
pub(crate) const IMPACT: f64 = 2.0;
const SMALLEST: f64 = 1e-6;

#[derive(Clone, Copy, Debug)]
pub(crate) struct StepSize {
    /// s.
    pub dt: f64,
    /// m/s².
    pub gravity: f64,
    /// A rebound of e < 1 that is slower than this is none, m/s.
    pub rest_speed: f64,
    pub last: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum CrowdEnd {
    Done,
    Grown,
}

#[derive(Clone, Debug, Default)]
pub(crate) struct Dense {
    pub contacts: Contacts,
    pub friction: Friction,
    clusters: Clusters,
    pub hits: Vec<(u32, u32, usize, f64)>,
    pub anchors: Anchors,
    pub pushes: Pushes,
    put_back: Vec<[bool; 2]>,
    /// Velocities before anything bounced, m/s.
    pub plastic: Vec<DVec2>,
    pub guards: Guards,
    pub grown: Vec<u32>,
    /// Body, moving surface and closing speed, m/s.
    pub squeezed: Vec<(u32, u32, f64)>,
    pub report: Report,
    pub walls: Walls,
    /// Length of the step, s.
    pub dt: f64,
    pub bounced: bool,
}

impl Dense {
    pub fn begin(&mut self, n: usize, all: usize) {
        self.anchors.begin(n, all);
        self.friction.begin(all);
        self.walls.begin(n);
        self.pushes.begin(n);
        self.clusters.begin(all);
        self.report.begin(all);
        self.put_back.resize(n, [false; 2]);
        self.plastic.resize(n, DVec2::ZERO);
        self.clear();
    }

    pub fn clear(&mut self) {
        self.hits.clear();
        self.grown.clear();
        self.squeezed.clear();
    }

    /// One step; `meets_more` is whether what a body sweeps may meet something that is not listed with it.
    pub fn step(
        &mut self,
        bodies: &mut Bodies,
        group: Group<'_>,
        size: StepSize,
        meets_more: &mut impl FnMut(&Bodies, usize) -> bool,
    ) -> CrowdEnd {
        self.dt = size.dt;
        self.anchors.bounces = Bounces { dt: size.dt, rest_speed: size.rest_speed };
        self.anchors.impact = (IMPACT * size.gravity * size.dt).max(SMALLEST);
        self.report.sides.clear();
        self.contacts.missed.clear();
        self.contacts.find(bodies, group, size.dt);
        let mut inside = true;
        for look in 0..=LOOKS {
            self.solve_along(bodies, size.dt);
            self.solve_across(bodies, size.dt);
            self.solve_walls(bodies, size.dt);
            inside = place::advance(bodies, &self.anchors.lands, size.dt);
            if !inside && !size.last {
                if self.grow(bodies, group, meets_more) {
                    return CrowdEnd::Grown;
                }
                inside = true;
            }
            self.guards.put_back += u64::from(!inside);
            if look == LOOKS {
                break;
            }
            let missed = self.contacts.miss(bodies) as u64;
            if missed > 0 {
                self.guards.put_back += missed;
                bodies.fall_freely();
                self.contacts.find(bodies, group, size.dt);
            } else if !self.catch_passing(bodies) {
                break;
            }
        }
        self.list_hits(bodies);
        let (mended, doubt) = place::part(bodies, &self.contacts, &mut self.clusters, size.dt);
        let leaves = doubt && !size.last && !(0..bodies.len()).all(|i| bodies.is_swept(i));
        if leaves && self.grow(bodies, group, meets_more) {
            return CrowdEnd::Grown;
        }
        if doubt || !inside {
            self.guards.put_back += place::take_back(bodies, &self.contacts, &mut self.put_back);
        }
        self.bounce(bodies);
        self.restrain(bodies, mended || !inside);
        if self.contacts.carried {
            self.find_squeezed(bodies);
        }
        CrowdEnd::Done
    }

    /// Whom the step has pushed across gravity, or moved apart: each end of those pairs.
    pub fn pushed(&self) -> impl Iterator<Item = u32> {
        let pressed = self.report.sides.iter().filter(|edge| edge.impulse > 0.0);
        let ends = pressed.chain(&self.clusters.edges).flat_map(|edge| [edge.a, edge.b]);
        ends.chain(self.pushes.reached.iter().copied())
    }

    pub fn take_guards(&mut self) -> Guards {
        self.guards.friction_unsettled += std::mem::take(&mut self.friction.relaxed);
        std::mem::take(&mut self.guards)
    }

    fn solve_along(&mut self, bodies: &mut Bodies, dt: f64) {
        let Self { contacts, anchors, clusters, walls, report, .. } = self;
        walls.undo(bodies, anchors);
        Along { contacts, anchors, clusters, dt }.solve(bodies);
        report.drain_along(bodies, anchors);
    }

    fn solve_walls(&mut self, bodies: &mut Bodies, dt: f64) {
        let Self { contacts, anchors, clusters, walls, report, .. } = self;
        let mut along = Along { contacts, anchors, clusters, dt };
        if walls.solve(bodies, &mut along, &report.sides) {
            report.drain_along(bodies, anchors);
            (0..bodies.len()).for_each(|i| bodies[i].to.x = bodies[i].flown.x);
            self.solve_across(bodies, dt);
        }
    }

    fn solve_across(&mut self, bodies: &mut Bodies, dt: f64) {
        let many = self.anchors.any_bounces && bodies.whole > MANY;
        let Self { contacts, anchors, walls, friction, clusters, pushes, report, guards, .. } = self;
        let held_up = &walls.held_up;
        Cross { contacts, anchors, friction, clusters, pushes, held_up, report, dt, many }.solve(bodies, guards);
    }

    fn list_hits(&mut self, bodies: &Bodies) {
        let Self { anchors, pushes, hits, .. } = self;
        for (list, axis) in [(&anchors.hits, ALONG), (&pushes.hits, ACROSS)] {
            for &(a, b) in list {
                let rests = axis == ALONG && anchors.rests[b as usize];
                let (speed, _) = anchors.bounces.closing([&bodies[a as usize], &bodies[b as usize]], axis, rests);
                hits.extend((speed > anchors.impact).then_some((a, b, axis, speed)));
            }
        }
    }

    fn find_squeezed(&mut self, bodies: &Bodies) {
        let (n, touch) = (bodies.len(), self.contacts.tolerances.touch);
        for contact in self.contacts.all() {
            let (body, surface) = (contact.first.min(contact.second), contact.first.max(contact.second));
            let (i, j) = (body as usize, surface as usize);
            if j >= n && bodies.moves(j) && place::overlap(bodies, (i, j), touch) {
                self.squeezed.push((body, surface, bodies[j].before.length()));
                self.guards.surfaces_stopped += 1;
            }
        }
    }

    /// Widens what bodies sweep that get further. Returns whether the step has to begin again: one may meet somebody new, or tolerances change.
    fn grow(&mut self, bodies: &mut Bodies, group: Group<'_>, meets_more: &mut impl FnMut(&Bodies, usize) -> bool) -> bool {
        let known = self.grown.len();
        self.grown.extend((0..bodies.len() as u32).filter(|i| !bodies.is_swept(*i as usize)));
        self.grown[known..].iter().for_each(|i| bodies.widen(*i as usize));
        let grown = || self.grown.iter().map(|i| *i as usize);
        let unlisted = |i: usize, j: usize| i != j && !group.near(i).chain(group.near(j)).any(|k| k == i || k == j);
        let meets = |i: usize| grown().any(|j| bodies[i].swept.meets(&bodies[j].swept) && unlisted(i, j));
        let again =
            Tolerances::of(bodies) != self.contacts.tolerances || grown().skip(known).any(|i| meets(i) || meets_more(bodies, i));
        self.guards.islands_grown += u64::from(again);
        again
    }

    fn catch_passing(&mut self, bodies: &mut Bodies) -> bool {
        if !self.contacts.passing {
            return false;
        }
        let tolerances = self.contacts.tolerances;
        let mut caught = 0;
        for contact in self.contacts.all_mut().filter(|contact| !contact.live) {
            if place::hits(bodies, (contact.first as usize, contact.second as usize), tolerances) {
                contact.live = true;
                caught += 1;
            }
        }
        if caught > 0 {
            bodies.fall_freely();
        }
        self.guards.put_back += caught;
        caught > 0
    }
}
