//! The dense method: one step of one island, however many contacts it has.
//!
//! 1. `contacts`: which pairs touch in this step, and along which axis;
//! 2. `gravity`: ways and velocities along gravity, one pass bottom-up;
//! 3. `walls`: friction on upright faces, which may hold bodies against gravity;
//! 4. `cross`: ways and velocities across gravity, with the `friction` of the stacks;
//! 5. `place`: positions that cannot overlap, by construction;
//! 6. `bounce`: what impacts return.
//!
//! It reads positions, velocities and free predictions of the members and writes their positions and velocities at the end of the step,
//! and of nothing else, so that islands do not know of each other.

use crate::physics::crowd::clusters::Clusters;
use crate::physics::crowd::contacts::Contacts;
use crate::physics::crowd::cross::{Cross, Pushes};
use crate::physics::crowd::friction::Friction;
use crate::physics::crowd::gravity::Anchors;
use crate::physics::crowd::place;
use crate::physics::crowd::report::Report;
use crate::physics::crowd::restitution::Bounces;
use crate::physics::crowd::walls::{Along, Walls};
use crate::physics::data::axis::Axis;
use crate::physics::guards::Guards;
use crate::physics::store::bodies::Bodies;
use crate::physics::store::islands::Island;
use glam::DVec2;

/// How often a pair that was expected to pass and did not makes the step be solved again. More: slower; fewer: more is put back.
const LOOKS: usize = 3;
/// Where some of more bodies than this bounce, fewer rounds across do: there is always something that does not settle. Larger: slower, and one
/// contact leaves the friction of more out; smaller: more friction of what is pushed comes a step late.
const MANY: usize = 256;

/// A plastic impact is told of when it stops more than this many steps of gravity, and m/s. Smaller: what rests is reported.
const IMPACT: f64 = 2.0;
const SMALLEST: f64 = 1e-6;

/// What is the same for all islands of a step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StepSize {
    /// s.
    pub dt: f64,
    /// m/s².
    pub gravity: f64,
    /// A rebound of e < 1 that is slower than this is none, m/s.
    pub rest_speed: f64,
    /// Whether an island may no longer ask to grow.
    pub last: bool,
}

/// What became of an island's step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Outcome {
    /// Solved.
    Done,
    /// Some swept boxes were widened: islands have to be found anew, and those of these bodies solved again from the same start.
    Grown,
}

/// The solver, and all that it works on.
#[derive(Clone, Debug)]
pub(crate) struct Dense {
    pub contacts: Contacts,
    pub friction: Friction,
    clusters: Clusters,
    /// What hit what: pair, axis, closing speed, m/s.
    pub hits: Vec<(u32, u32, Axis, f64)>,
    pub anchors: Anchors,
    pub pushes: Pushes,
    put_back: Vec<[bool; 2]>,
    /// Velocities before anything bounced, m/s, by slot.
    pub plastic: Vec<DVec2>,
    pub guards: Guards,
    /// Whose swept boxes were widened; the driver clears it.
    pub grown: Vec<u32>,
    /// Body, moving surface and closing speed (m/s) where surfaces left no room; the driver clears it.
    pub squeezed: Vec<(u32, u32, f64)>,
    pub report: Report,
    pub walls: Walls,
    /// Length of the step, s.
    pub dt: f64,
    /// Whether anything bounced.
    pub bounced: bool,
    /// By slot: the place among the members.
    place: Vec<u32>,
}

impl Dense {
    pub fn new(bodies: &Bodies) -> Self {
        let (n, all) = (bodies.len(), bodies.x.len());
        Self {
            contacts: Contacts::new(n),
            friction: Friction::new(bodies),
            clusters: Clusters::new(all),
            hits: Vec::with_capacity(n),
            anchors: Anchors::new(n, all),
            pushes: Pushes::new(n),
            put_back: vec![[false; 2]; n],
            plastic: vec![DVec2::ZERO; n],
            guards: Guards::default(),
            grown: Vec::with_capacity(n),
            squeezed: Vec::new(),
            report: Report::new(all),
            walls: Walls::new(n),
            dt: 0.0,
            bounced: false,
            place: vec![0; n],
        }
    }

    /// One step of an island.
    pub fn step(&mut self, bodies: &mut Bodies, island: Island<'_>, size: StepSize) -> Outcome {
        self.dt = size.dt;
        self.anchors.bounces = Bounces { dt: size.dt, rest_speed: size.rest_speed };
        self.anchors.impact = (IMPACT * size.gravity * size.dt).max(SMALLEST);
        self.pushes.hits.impact = self.anchors.impact;
        self.report.sides.clear();
        self.walls.begin(island.members);
        self.contacts.begin_step();
        self.contacts.find(bodies, island, size.dt);
        self.anchors.any_hung = false;
        let mut inside = true;
        for look in 0..=LOOKS {
            self.solve_along(bodies, island.members, size.dt);
            self.solve_across(bodies, island.members, size.dt);
            self.rub(bodies, island.members, size.dt);
            inside = place::advance(bodies, island.members, &self.anchors.lands, size.dt);
            if !inside && !size.last {
                return self.grow(bodies, island);
            }
            self.guards.put_back += u64::from(!inside);
            if look == LOOKS {
                break;
            }
            let missed = self.contacts.miss(bodies) as u64;
            if missed > 0 {
                self.guards.put_back += missed;
                predict(bodies, island);
                self.contacts.find(bodies, island, size.dt);
            } else if !self.catch_passing(bodies, island) {
                break;
            }
        }
        self.list_hits(bodies);
        let Self { contacts, clusters, put_back, .. } = self;
        let mended = place::part(bodies, island.members, contacts, clusters, size.dt);
        if mended.doubt && !size.last && !island.members.iter().all(|i| bodies.is_swept(*i as usize)) {
            return self.grow(bodies, island);
        }
        if mended.doubt || !inside {
            self.guards.put_back += place::take_back(bodies, island.members, contacts, put_back);
        }
        self.bounce(bodies, island.members);
        self.restrain(bodies, island.members, mended.any || !inside);
        if self.contacts.carried {
            self.find_squeezed(bodies, island);
        }
        Outcome::Done
    }

    /// The place of a slot among the members; surfaces come first.
    pub fn place_of(&self, i: u32) -> u32 {
        self.place.get(i as usize).copied().unwrap_or(0)
    }

    /// How often each guard acted since this was asked last.
    pub fn take_guards(&mut self) -> Guards {
        self.guards.friction_unsettled += std::mem::take(&mut self.friction.relaxed);
        std::mem::take(&mut self.guards)
    }

    /// Records what was solved, and leaves the free velocities as flight made them, for whoever solves the island again.
    pub fn finish(&mut self, bodies: &mut Bodies, island: Island<'_>, down: f64) {
        if self.report.on {
            island.members.iter().enumerate().for_each(|(k, i)| self.place[*i as usize] = k as u32);
            self.record(bodies, island, down);
        }
        self.pushes.resistance.restore(bodies);
        self.walls.restore_free(bodies);
    }

    fn solve_along(&mut self, bodies: &mut Bodies, members: &[u32], dt: f64) {
        let Self { contacts, anchors, clusters, walls, report, .. } = self;
        walls.undo(bodies, anchors);
        Along { members, contacts, anchors, clusters, dt }.solve(bodies);
        report.drain_along(bodies, anchors);
    }

    /// Lets the sides rub that press, and solves along and across again if any do.
    fn rub(&mut self, bodies: &mut Bodies, members: &[u32], dt: f64) {
        let Self { contacts, anchors, clusters, walls, report, .. } = self;
        let mut along = Along { members, contacts, anchors, clusters, dt };
        if walls.solve(bodies, &mut along, &report.sides) {
            report.drain_along(bodies, anchors);
            members.iter().for_each(|i| bodies.px[*i as usize] = bodies.free_x[*i as usize]);
            self.solve_across(bodies, members, dt);
        }
    }

    fn solve_across(&mut self, bodies: &mut Bodies, members: &[u32], dt: f64) {
        // Where some of many bounce, fewer rounds across do.
        let many = self.anchors.any_bounces && members.len() > MANY;
        let Self { contacts, anchors, walls, friction, clusters, pushes, report, guards, .. } = self;
        let held_up = &walls.held_up;
        let mut cross = Cross { members, contacts, anchors, friction, clusters, pushes, held_up, report, dt, many };
        cross.solve(bodies, guards);
    }

    /// Lists what hit what, with the closing speed when touching.
    fn list_hits(&mut self, bodies: &Bodies) {
        let Self { anchors, pushes, hits, dt, .. } = self;
        hits.clear();
        for &(a, b) in &anchors.hits {
            let speed = closing_speed((a, b), [&bodies.y, &bodies.hy, &bodies.vy, &bodies.free_vy], anchors.rests[b as usize], *dt);
            hits.extend((speed > anchors.impact).then_some((a, b, Axis::Gravity, speed)));
        }
        for &(a, b) in &pushes.hits.all {
            let speed = closing_speed((a, b), [&bodies.x, &bodies.hx, &bodies.vx, &bodies.free_vx], false, *dt);
            hits.extend((speed > anchors.impact).then_some((a, b, Axis::Across, speed)));
        }
    }

    /// Tells whom a moving surface has entered: it had no way out.
    fn find_squeezed(&mut self, bodies: &Bodies, island: Island<'_>) {
        let (n, hair) = (bodies.len(), self.contacts.tolerances.touch);
        for &i in island.members {
            let i = i as usize;
            for &j in island.near(i as u32).iter().filter(|j| **j as usize >= n) {
                let j = j as usize;
                let moves = bodies.vx[j] != 0.0 || bodies.vy[j] != 0.0;
                if moves && self.contacts.has(i, j) && place::overlap(bodies, (i, j), hair) {
                    let speed = (bodies.vx[j] * bodies.vx[j] + bodies.vy[j] * bodies.vy[j]).sqrt();
                    self.squeezed.push((i as u32, j as u32, speed));
                    self.guards.surfaces_stopped += 1;
                }
            }
        }
    }

    /// Widens what was swept by those who left it.
    fn grow(&mut self, bodies: &mut Bodies, island: Island<'_>) -> Outcome {
        self.guards.islands_grown += 1;
        let from = self.grown.len();
        self.grown.extend(island.members.iter().filter(|i| !bodies.is_swept(**i as usize)));
        self.grown[from..].iter().for_each(|i| bodies.widen(*i as usize));
        // At once, and not when the next island is solved: in between its bodies may begin elsewhere.
        self.undo(bodies);
        Outcome::Grown
    }

    /// As if nothing had been solved.
    pub fn undo(&mut self, bodies: &mut Bodies) {
        self.pushes.resistance.restore(bodies);
        self.walls.undo(bodies, &mut self.anchors);
    }

    /// Whether a pair that was expected to pass did not: then it is a contact.
    fn catch_passing(&mut self, bodies: &mut Bodies, island: Island<'_>) -> bool {
        if !self.contacts.passing {
            return false;
        }
        let hair = self.contacts.tolerances.hair;
        let mut caught = 0;
        for contact in self.contacts.all_mut().filter(|contact| !contact.live) {
            if place::hits(bodies, (contact.first as usize, contact.second as usize), hair) {
                contact.live = true;
                caught += 1;
            }
        }
        if caught > 0 {
            predict(bodies, island);
        }
        self.guards.put_back += caught;
        caught > 0
    }
}

/// Back to where free flight leads.
fn predict(bodies: &mut Bodies, island: Island<'_>) {
    island.members.iter().for_each(|i| bodies.fall_freely(*i as usize));
}

/// How fast a pair closes when it touches, m/s: positions, half extents, velocities before and free velocities after along the axis. What
/// `rests` does not fall along with what falls on it.
fn closing_speed((a, b): (u32, u32), [x, half, v, free]: [&[f64]; 4], rests: bool, dt: f64) -> f64 {
    let (a, b) = (a as usize, b as usize);
    let side = if x[b] >= x[a] { 1.0 } else { -1.0 };
    let gap = ((x[b] - x[a]).abs() - half[a] - half[b]).max(0.0);
    let gained = (free[a] - v[a]) - if rests { 0.0 } else { free[b] - v[b] };
    let before = side * (v[a] - v[b]);
    (before * before.abs() + 2.0 * side * gained / dt * gap).max(0.0).sqrt()
}
