//! The crowd step of one island, however many contacts it has.
//!
//! 1. `contacts`: which pairs touch in this step, and along which axis;
//! 2. `gravity`: ways and velocities along gravity, one pass bottom-up;
//! 3. `walls`: friction on upright faces, which may hold bodies against gravity;
//! 4. `cross`: ways and velocities across gravity, with the `friction` of the stacks;
//! 5. `place`: positions that cannot overlap, by construction;
//! 6. `bounce`: what impacts return.
//!
//! The island's bodies and surfaces are gathered into [`Bodies`], where the step leaves their positions and velocities.

use crate::physics::crowd::Other;
use crate::physics::crowd::bodies::{Bodies, Group, Source};
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
use crate::physics::store::islands::Island;
use glam::DVec2;

/// How often a pair that was expected to pass and did not makes the step be solved again. More: slower; fewer: more is put back.
const LOOKS: usize = 3;
/// Where some of more bodies than this bounce, fewer rounds across do: there is always something that does not settle. Larger: slower, and one
/// contact leaves the friction of more out; smaller: more friction of what is pushed comes a step late.
const MANY: usize = 256;

/// A plastic impact is reported if it stops more than this many steps of gravity, and m/s. Smaller: what rests is reported.
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
    /// Some swept boxes were widened: islands have to be found again, and those of these bodies solved again from the same start.
    Grown,
}

/// The crowd step, and the island that it works on.
#[derive(Clone, Debug)]
pub(crate) struct Crowd {
    pub bodies: Bodies,
    pub dense: Dense,
    members: Vec<u32>,
    local: Vec<u32>,
}

impl Crowd {
    /// Room for `n` bodies; `all` with surfaces.
    pub fn new(n: usize, all: usize) -> Self {
        let (bodies, dense) = (Bodies::new(n, all), Dense::new(n, all));
        Self { bodies, dense, members: (0..n as u32).collect(), local: vec![0; all] }
    }

    /// One step of an island.
    pub fn step(&mut self, from: Source<'_>, island: Island<'_>, size: StepSize) -> Outcome {
        let Self { bodies, dense, members, local } = self;
        bodies.gather(from, island);
        let (n, count) = (bodies.len(), from.motions.len());
        (0..).zip(&bodies.ids).for_each(|(k, i)| local[*i as usize] = k);
        (n as u32..).zip(&bodies.surfaces).for_each(|(k, s)| local[count + *s as usize] = k);
        dense.begin(n, n + bodies.surfaces.len());
        dense.step(bodies, Group { members: &members[..n], island, local }, size)
    }

    /// Lists what the contacts of the step gave, in the numbers of the world.
    pub fn finish(&mut self, down: f64, solved: impl Fn(usize) -> u32) {
        let Self { bodies, dense, members, .. } = self;
        let known = dense.report.list.len();
        if dense.report.on {
            dense.record(bodies, &members[..bodies.len()], down);
        }
        for contact in &mut dense.report.list[known..] {
            contact.a = bodies.ids[contact.a] as usize;
            contact.b = match contact.b {
                Other::Body(b) => Other::Body(bodies.ids[b] as usize),
                Other::Surface(s) => Other::Surface(bodies.surfaces[s] as usize),
            };
            contact.solved = solved(contact.a);
        }
    }

    /// A body or surface of the island by its number in the world.
    pub fn other(&self, i: u32) -> Other {
        let n = self.bodies.len() as u32;
        match i.checked_sub(n) {
            None => Other::Body(self.bodies.ids[i as usize] as usize),
            Some(surface) => Other::Surface(self.bodies.surfaces[surface as usize] as usize),
        }
    }
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
    /// Velocities before anything bounced, m/s, by body.
    pub plastic: Vec<DVec2>,
    pub guards: Guards,
    /// Bodies whose swept boxes were widened.
    pub grown: Vec<u32>,
    /// Body, moving surface and closing speed (m/s) where surfaces left no room.
    pub squeezed: Vec<(u32, u32, f64)>,
    pub report: Report,
    pub walls: Walls,
    /// Length of the step, s.
    pub dt: f64,
    /// Whether anything bounced.
    pub bounced: bool,
}

impl Dense {
    fn new(n: usize, all: usize) -> Self {
        Self {
            contacts: Contacts::new(n),
            friction: Friction::new(all),
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
        }
    }

    /// Begins an island of `n` bodies; `all` with surfaces.
    fn begin(&mut self, n: usize, all: usize) {
        self.anchors.begin(n, all);
        self.friction.begin(all);
        self.walls.begin(n);
        self.pushes.resistance.begin();
        self.grown.clear();
        self.squeezed.clear();
    }

    /// One step of an island.
    fn step(&mut self, bodies: &mut Bodies, group: Group<'_>, size: StepSize) -> Outcome {
        self.dt = size.dt;
        self.anchors.bounces = Bounces { dt: size.dt, rest_speed: size.rest_speed };
        self.anchors.impact = (IMPACT * size.gravity * size.dt).max(SMALLEST);
        self.report.sides.clear();
        self.contacts.begin_step();
        self.contacts.find(bodies, group, size.dt);
        let mut inside = true;
        for look in 0..=LOOKS {
            self.solve_along(bodies, group.members, size.dt);
            self.solve_across(bodies, group.members, size.dt);
            self.rub(bodies, group.members, size.dt);
            inside = place::advance(bodies, group.members, &self.anchors.lands, size.dt);
            if !inside && !size.last {
                return self.grow(bodies, group.members);
            }
            self.guards.put_back += u64::from(!inside);
            if look == LOOKS {
                break;
            }
            let missed = self.contacts.miss(bodies) as u64;
            if missed > 0 {
                self.guards.put_back += missed;
                predict(bodies, group.members);
                self.contacts.find(bodies, group, size.dt);
            } else if !self.catch_passing(bodies, group.members) {
                break;
            }
        }
        self.list_hits(bodies);
        let Self { contacts, clusters, put_back, .. } = self;
        let mended = place::part(bodies, group.members, contacts, clusters, size.dt);
        if mended.doubt && !size.last && !group.members.iter().all(|i| bodies.is_swept(*i as usize)) {
            return self.grow(bodies, group.members);
        }
        if mended.doubt || !inside {
            self.guards.put_back += place::take_back(bodies, group.members, contacts, put_back);
        }
        self.bounce(bodies, group.members);
        self.restrain(bodies, group.members, mended.any || !inside);
        if self.contacts.carried {
            self.find_squeezed(bodies);
        }
        Outcome::Done
    }

    /// How often each guard acted since this was asked last.
    pub fn take_guards(&mut self) -> Guards {
        self.guards.friction_unsettled += std::mem::take(&mut self.friction.relaxed);
        std::mem::take(&mut self.guards)
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
        for &(a, b) in &pushes.hits {
            let speed = closing_speed((a, b), [&bodies.x, &bodies.hx, &bodies.vx, &bodies.free_vx], false, *dt);
            hits.extend((speed > anchors.impact).then_some((a, b, Axis::Across, speed)));
        }
    }

    /// Finds the bodies that a moving surface has entered: they had no way out.
    fn find_squeezed(&mut self, bodies: &Bodies) {
        let (n, touch) = (bodies.len(), self.contacts.tolerances.touch);
        for contact in self.contacts.all() {
            let (body, surface) = (contact.first.min(contact.second), contact.first.max(contact.second));
            let (i, j) = (body as usize, surface as usize);
            if j >= n && bodies.moves(j) && place::overlap(bodies, (i, j), touch) {
                let speed = (bodies.vx[j] * bodies.vx[j] + bodies.vy[j] * bodies.vy[j]).sqrt();
                self.squeezed.push((body, surface, speed));
                self.guards.surfaces_stopped += 1;
            }
        }
    }

    /// Widens what was swept by those who left it.
    fn grow(&mut self, bodies: &mut Bodies, members: &[u32]) -> Outcome {
        self.guards.islands_grown += 1;
        self.grown.extend(members.iter().filter(|i| !bodies.is_swept(**i as usize)));
        self.grown.iter().for_each(|i| bodies.widen(*i as usize));
        Outcome::Grown
    }

    /// Whether a pair that was expected to pass did not: then it is a contact.
    fn catch_passing(&mut self, bodies: &mut Bodies, members: &[u32]) -> bool {
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
            predict(bodies, members);
        }
        self.guards.put_back += caught;
        caught > 0
    }
}

/// Back to where free flight leads.
fn predict(bodies: &mut Bodies, members: &[u32]) {
    members.iter().for_each(|i| bodies.fall_freely(*i as usize));
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
