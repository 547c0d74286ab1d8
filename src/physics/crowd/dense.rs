//! The dense method: one step of one island, however many contacts it has.
//!
//! 1. `contacts`: which pairs touch in this step, and along which axis;
//! 2. `gravity`: ways and velocities along gravity, one pass bottom-up;
//! 3. `impacts`: those that bounce, in the order of their times; where there were any, contacts and the pass along gravity again;
//! 4. `walls`: friction on upright faces, which may hold bodies against gravity;
//! 5. `cross`: ways and velocities across gravity, with the `friction` of the stacks;
//! 6. `place`: positions that cannot overlap, by construction.
//!
//! It reads positions, velocities and free predictions of the members and writes their positions and velocities at the end of the step,
//! and of nothing else, so that islands do not know of each other.

use crate::physics::crowd::clusters::Clusters;
use crate::physics::crowd::contacts::Contacts;
use crate::physics::crowd::cross::{Cross, Pushes};
use crate::physics::crowd::friction::Friction;
use crate::physics::crowd::gravity::{self, Anchors};
use crate::physics::crowd::impacts::{Around, Axis, Impacts};
use crate::physics::crowd::place;
use crate::physics::crowd::report::Report;
use crate::physics::crowd::walls::{Along, Walls};
use crate::physics::guards::Guards;
use crate::physics::store::bodies::Bodies;
use crate::physics::store::islands::Island;
use crate::physics::store::neighbours::Neighbours;
use crate::physics::store::reach::Reach;

/// How often a pair that was expected to pass and did not makes the step be solved again. More: slower; fewer: more is put back.
const LOOKS: usize = 3;
/// Where some of more bodies than this bounce, fewer rounds across do: there is always something that does not settle. Larger: slower, and one
/// contact leaves the friction of more out; smaller: more friction of what is pushed comes a step late.
const MANY: usize = 256;
/// Energy gained that is no more than rounding, as a part of the kinetic energy. Smaller: rounding slows what it should not.
const ROUNDING: f64 = 1e-12;

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
    /// Whether it begins later than the others, and elsewhere than contacts were looked for.
    pub later: bool,
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
    pub impacts: Impacts,
    pub anchors: Anchors,
    pushes: Pushes,
    put_back: Vec<[bool; 2]>,
    pub guards: Guards,
    /// Whose swept boxes were widened; the driver clears it.
    pub grown: Vec<u32>,
    /// Body, moving surface and closing speed (m/s) where surfaces left no room; the driver clears it.
    pub squeezed: Vec<(u32, u32, f64)>,
    pub report: Report,
    pub reach: Reach,
    pub walls: Walls,
    /// Length of the step, s.
    pub dt: f64,
    /// Whether impacts were followed.
    followed: bool,
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
            impacts: Impacts::new(n, all),
            anchors: Anchors::new(n, all),
            pushes: Pushes::new(n),
            put_back: vec![[false; 2]; n],
            guards: Guards::default(),
            grown: Vec::with_capacity(n),
            squeezed: Vec::new(),
            report: Report::new(all),
            reach: Reach::default(),
            walls: Walls::new(n),
            dt: 0.0,
            followed: false,
            place: vec![0; n],
        }
    }

    /// One step of an island.
    pub fn step(&mut self, bodies: &mut Bodies, neighbours: &mut Neighbours, island: Island<'_>, size: StepSize) -> Outcome {
        self.dt = size.dt;
        self.anchors.impact = (IMPACT * size.gravity * size.dt).max(SMALLEST);
        self.pushes.hits.impact = self.anchors.impact;
        self.reach.clear();
        self.report.sides.clear();
        (self.walls.any, self.impacts.any) = (false, false);
        if size.later {
            self.reach_out(bodies, neighbours, island, size.last);
        }
        if !neighbours.carried().is_empty() {
            self.reach_up(bodies, neighbours, island, size.last);
        }
        if !self.reach.strangers.is_empty() {
            return self.grow(bodies, island);
        }
        self.contacts.begin_step();
        self.contacts.find(bodies, island, &self.reach.added, size.dt, false);
        self.anchors.any_hung = false;
        let Self { contacts, anchors, clusters, .. } = self;
        // What bounces in the air is not merged before it has.
        anchors.only_anchors = bodies.lively;
        gravity::solve(bodies, island.members, contacts, anchors, clusters, size.dt);
        anchors.only_anchors = false;
        if let Some(outcome) = self.bounce(bodies, neighbours, island, size) {
            return outcome;
        }
        let mut inside = true;
        for look in 0.. {
            self.solve_along(bodies, island, size.dt, look == 0 && !self.impacts.any && !self.anchors.unmerged);
            self.solve_across(bodies, island, size.dt);
            inside = place::advance(bodies, island.members, &self.anchors.lands, size.dt, self.impacts.any || size.later);
            if !inside {
                // After the last look nobody gets further than was looked for.
                if look < LOOKS {
                    let more = self.reach_out(bodies, neighbours, island, size.last);
                    if !self.reach.strangers.is_empty() {
                        return self.grow(bodies, island);
                    }
                    if more {
                        self.predict(bodies, island);
                        self.contacts.find(bodies, island, &self.reach.added, size.dt, self.followed);
                        continue;
                    }
                    inside = island.members.iter().all(|i| bodies.is_swept(*i as usize));
                }
                self.guards.kept_within_reach += u64::from(!inside);
            }
            if look == LOOKS {
                break;
            }
            let missed = self.contacts.miss(bodies) as u64;
            if missed > 0 {
                self.guards.corners_met += missed;
                self.predict(bodies, island);
                self.contacts.find(bodies, island, &self.reach.added, size.dt, self.followed);
            } else if !self.catch_passing(bodies, island) {
                break;
            }
        }
        self.list_plastic(bodies);
        let Self { contacts, clusters, put_back, .. } = self;
        let (doubt, back) = place::part(bodies, island.members, contacts, clusters, put_back, (size.dt, inside));
        self.guards.put_back += back;
        self.restrain(bodies, island, doubt);
        if self.contacts.carried {
            self.find_squeezed(bodies, island);
        }
        Outcome::Done
    }

    /// The place of a slot among the members; surfaces come first.
    pub fn place_of(&self, i: u32) -> u32 {
        self.place.get(i as usize).copied().unwrap_or(0)
    }

    /// The pairs that were added to the island of the last step, because something was thrown further than contacts were looked for.
    pub fn reached(&self) -> &[(u32, u32)] {
        &self.reach.added
    }

    /// How often each guard acted since this was asked last.
    pub fn take_guards(&mut self) -> Guards {
        self.guards.friction_relaxed += std::mem::take(&mut self.friction.relaxed);
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
        self.impacts.restore_free(bodies, island.members);
    }

    /// Follows the impacts. Returns why the step is not solved any further: they throw a body further than contacts were looked for.
    fn bounce(&mut self, bodies: &mut Bodies, neighbours: &mut Neighbours, island: Island<'_>, size: StepSize) -> Option<Outcome> {
        let Self { contacts, anchors, impacts, reach, .. } = self;
        let mut around = Around { island, neighbours, reach, last: size.last };
        let any = impacts.follow(bodies, (contacts, anchors), &mut around, size);
        self.followed = any;
        self.guards.bounces_put_off += std::mem::take(&mut self.impacts.waiting);
        if !any {
            return None;
        }
        if !self.reach.strangers.is_empty() {
            return Some(self.grow(bodies, island));
        }
        self.contacts.find(bodies, island, &self.reach.added, size.dt, true);
        None
    }

    fn solve_along(&mut self, bodies: &mut Bodies, island: Island<'_>, dt: f64, solved: bool) {
        let Self { contacts, anchors, clusters, impacts, walls, report, .. } = self;
        walls.undo(bodies, anchors, &mut impacts.struck);
        let struck = &mut impacts.struck;
        let mut along = Along { members: island.members, contacts, anchors, clusters, struck, dt };
        walls.solve(bodies, &mut along, report, solved);
    }

    fn solve_across(&mut self, bodies: &mut Bodies, island: Island<'_>, dt: f64) {
        // Where some of many bounce, fewer rounds across do.
        let many = self.impacts.any && island.members.len() > MANY;
        let Self { contacts, friction, clusters, pushes, impacts, report, guards, .. } = self;
        let mut cross = Cross { members: island.members, contacts, friction, clusters, pushes, impacts, report, dt, many };
        cross.solve(bodies, guards);
    }

    /// Adds the plastic impacts to those that bounced, with the closing speed when touching.
    fn list_plastic(&mut self, bodies: &Bodies) {
        let Self { anchors, pushes, impacts, dt, .. } = self;
        impacts.plastic.clear();
        for &(a, b) in &anchors.hits {
            let speed = closing_speed((a, b), [&bodies.y, &bodies.hy, &bodies.vy, &bodies.free_vy], anchors.rests[b as usize], *dt);
            impacts.plastic.extend((speed > anchors.impact).then_some((a, b, Axis::Gravity, speed)));
        }
        for &(a, b) in &pushes.hits.all {
            let speed = closing_speed((a, b), [&bodies.x, &bodies.hx, &bodies.vx, &bodies.free_vx], false, *dt);
            impacts.plastic.extend((speed > anchors.impact).then_some((a, b, Axis::Across, speed)));
        }
    }

    /// Tells whom a moving surface has entered: it had no way out.
    fn find_squeezed(&mut self, bodies: &Bodies, island: Island<'_>) {
        let (n, hair) = (bodies.len(), self.contacts.tolerances.touch);
        for &i in island.members {
            let i = i as usize;
            let added = self.reach.added.iter().filter(|pair| pair.0 as usize == i).map(|pair| &pair.1);
            for &j in island.near(i as u32).iter().chain(added).filter(|j| **j as usize >= n) {
                let j = j as usize;
                let moves = bodies.vx[j] != 0.0 || bodies.vy[j] != 0.0;
                if moves && self.contacts.has(i, j) && place::meets(bodies, (i, j), hair, true) {
                    self.squeezed.push((i as u32, j as u32, bodies.vx[j].hypot(bodies.vy[j])));
                    self.guards.squeezed += 1;
                }
            }
        }
    }

    /// Widens what was swept by those who left it.
    pub fn grow(&mut self, bodies: &mut Bodies, island: Island<'_>) -> Outcome {
        self.guards.steps_grown += 1;
        self.grown.append(&mut self.reach.strangers);
        // At once, and not when the next island is solved: in between its bodies may begin elsewhere.
        self.undo(bodies, island);
        Outcome::Grown
    }

    /// As if nothing had been solved.
    fn undo(&mut self, bodies: &mut Bodies, island: Island<'_>) {
        self.pushes.resistance.restore(bodies);
        self.walls.undo(bodies, &mut self.anchors, &mut self.impacts.struck);
        self.impacts.undo(bodies, island.members);
    }

    /// Whether a pair that was expected to pass did not: then it is a contact.
    fn catch_passing(&mut self, bodies: &mut Bodies, island: Island<'_>) -> bool {
        if !self.contacts.passing {
            return false;
        }
        let Self { contacts, impacts, .. } = self;
        let hair = contacts.tolerances.hair;
        // Where the solution changed the way, impacts were not followed on it.
        let strays = |i: usize| i < bodies.len() && impacts.predicted(bodies, i) != (bodies.px[i], bodies.py[i]);
        let meets = |a: u32, b: u32, followed: &mut bool| {
            let (a, b) = (a as usize, b as usize);
            *followed &= !strays(a) && !strays(b);
            place::meets(bodies, (a, b), hair, *followed)
        };
        let mut caught = 0;
        for contact in contacts.all_mut() {
            if !contact.live && meets(contact.first, contact.second, &mut contact.followed) {
                contact.live = true;
                caught += 1;
            }
        }
        if caught > 0 {
            // From the same predictions: free flight, and what impacts made of it.
            self.predict(bodies, island);
        }
        self.guards.corners_met += caught;
        caught > 0
    }

    /// Back to where members are predicted.
    fn predict(&self, bodies: &mut Bodies, island: Island<'_>) {
        for &i in island.members {
            let i = i as usize;
            (bodies.px[i], bodies.py[i]) = self.impacts.predicted(bodies, i);
        }
    }

    /// Widens what is swept by those who leave it. Returns whether pairs were added.
    fn reach_out(&mut self, bodies: &mut Bodies, neighbours: &mut Neighbours, island: Island<'_>, last: bool) -> bool {
        let known = self.reach.added.len();
        for &i in island.members {
            if !bodies.is_swept(i as usize) {
                self.reach.widen(bodies, neighbours, island, i as usize, last);
            }
        }
        self.reach.added.len() > known
    }

    /// What lands on something that a surface lifts goes up with it, further than its own flight says: widens what it sweeps by as much.
    fn reach_up(&mut self, bodies: &mut Bodies, neighbours: &mut Neighbours, island: Island<'_>, last: bool) {
        let near = island.members.iter().flat_map(|i| island.near(*i)).filter(|j| **j as usize >= bodies.len());
        let rise = near.map(|j| bodies.y[*j as usize] - bodies.py[*j as usize]).fold(0.0, f64::max);
        for &i in island.members.iter().filter(|_| rise > 0.0) {
            let i = i as usize;
            let predicted = bodies.py[i];
            bodies.py[i] = predicted.min(bodies.y[i] - rise);
            if !bodies.is_swept(i) {
                self.reach.widen(bodies, neighbours, island, i, last);
            }
            bodies.py[i] = predicted;
        }
    }

    /// The last word on energy: an island that is merged and parted in a wild way may end higher than its velocities allow for; then what
    /// was touched is slowed down by one factor. That does not conserve momentum; it is counted.
    pub fn restrain(&mut self, bodies: &mut Bodies, island: Island<'_>, doubt: bool) {
        let risky = self.impacts.any || self.walls.any || doubt || !self.anchors.edges.is_empty();
        if self.contacts.carried || !risky {
            return;
        }
        let (mut gained, mut brought, mut left) = (0.0, 0.0, 0.0);
        let stirred = self.impacts.any || self.walls.any;
        let touched = |bodies: &Bodies, i: usize| stirred || bodies.uy[i] != bodies.free_vy[i] || bodies.ux[i] != bodies.free_vx[i];
        for &i in island.members {
            let i = i as usize;
            if !touched(bodies, i) {
                continue;
            }
            let mass = bodies.mass[i];
            let square = |[x, y]: [f64; 2]| x * x + y * y;
            let (before, after) = (square([bodies.vx[i], bodies.vy[i]]), square([bodies.ux[i], bodies.uy[i]]));
            let work = bodies.ax[i] * (bodies.px[i] - bodies.x[i]) + bodies.ay[i] * (bodies.py[i] - bodies.y[i]);
            let mut gain = 0.5 * (after - before) - work;
            if bodies.is_guided[bodies.id[i] as usize] {
                // What liquids and streams give it is known of its flight alone.
                gain = gain.min(0.5 * (after - square(self.impacts.free_before(bodies, i))));
            }
            brought += mass * before;
            gained += mass * gain;
            left += 0.5 * mass * after;
        }
        if gained <= ROUNDING * (brought + left) {
            return;
        }
        self.guards.energy_taken_out += 1;
        let part = if left > gained { (1.0 - gained / left).sqrt() } else { 0.0 };
        for &i in island.members {
            let i = i as usize;
            if touched(bodies, i) {
                bodies.uy[i] *= part;
                bodies.ux[i] *= part;
            }
        }
    }
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
