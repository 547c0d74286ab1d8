//! Friction on upright faces: along walls, and between bodies side by side.
//!
//! How hard the sides press is told by the solution across, which is found again when something hangs or rubs. A body that stands still against a wall, against what
//! the ground carries, or against one that hangs, hangs there while what it would take, its own weight and all that it carries, stays below
//! μ_s·N, by all that it hangs on together; else it slides and loses up to μ_k·N/m. What it hangs on or slides along bears the same. Bodies
//! side by side that nothing carries rub as a pair. Only those are asked that would move along the face: what the ground carries does not.

use crate::physics::crowd::clusters::Clusters;
use crate::physics::crowd::contacts::Contacts;
use crate::physics::crowd::gravity::{self, Anchors};
use crate::physics::crowd::impulses::{Edge, Record};
use crate::physics::data::axis::Axis;
use crate::physics::store::bodies::Bodies;

/// A limit exceeded by this part still holds: sums of many impulses are rounded.
const ROUNDING: f64 = 1e-12;

/// How often those are sought that hang on what hangs, to and fro. Fewer: the end of a long row that is listed in disorder falls.
const SWEEPS: usize = 8;

/// A body pressed against a wall, or against a body that the ground carries or that hangs.
#[derive(Clone, Copy, Debug)]
struct Grip {
    body: u32,
    wall: u32,
    /// Velocity of its skin along gravity, m/s.
    skin: f64,
    /// The largest impulses of friction, N·s.
    held: f64,
    dragged: f64,
    /// Whether it hangs, and whether that on which it does hangs itself.
    hangs: bool,
    on_hung: bool,
    /// Impulse on the body, N·s.
    impulse: f64,
}

/// What upright faces do in one step of one island.
#[derive(Clone, Debug, Default)]
pub(crate) struct Walls {
    pub any: bool,
    grips: Vec<Grip>,
    edges: Vec<Edge>,
    loads: Vec<f64>,
    /// What upright faces hold of each body, N·s, by slot.
    pub held_up: Vec<f64>,
    /// What hangs on each body bears it down by, N·s, and what those can hold together on which a body hangs.
    borne: Vec<f64>,
    holds: Vec<f64>,
    /// With which velocity each of those hangs that press, by slot, m/s.
    skins: Vec<Option<f64>>,
    /// Free velocities and predictions along gravity before friction.
    saved: Vec<(u32, f64, f64)>,
    records: Vec<Record>,
    dt: f64,
}

/// What the solution along gravity works with.
pub(crate) struct Along<'a> {
    pub members: &'a [u32],
    pub contacts: &'a Contacts,
    pub anchors: &'a mut Anchors,
    pub clusters: &'a mut Clusters,
    pub dt: f64,
}

impl Walls {
    pub fn new(count: usize) -> Self {
        let none = || vec![0.0; count];
        Self {
            loads: none(),
            held_up: none(),
            borne: none(),
            holds: none(),
            skins: vec![None; count],
            grips: Vec::with_capacity(2 * count),
            edges: Vec::with_capacity(2 * count),
            saved: Vec::with_capacity(4 * count),
            records: Vec::with_capacity(2 * count),
            ..Self::default()
        }
    }

    /// Begins a step.
    pub fn begin(&mut self, members: &[u32]) {
        self.any = false;
        members.iter().for_each(|i| self.held_up[*i as usize] = 0.0);
    }

    pub fn record(&self, into: &mut Vec<Record>) {
        if self.any {
            into.extend_from_slice(&self.records);
        }
    }

    /// Sets the free velocities to what they were before friction.
    pub fn restore_free(&self, bodies: &mut Bodies) {
        if self.any {
            self.saved.iter().rev().for_each(|(i, free, _)| bodies.free_vy[*i as usize] = *free);
        }
    }

    /// As if nothing had rubbed.
    pub fn undo(&mut self, bodies: &mut Bodies, anchors: &mut Anchors) {
        if !self.any {
            return;
        }
        self.any = false;
        for &(i, free, predicted) in self.saved.iter().rev() {
            (bodies.free_vy[i as usize], bodies.py[i as usize]) = (free, predicted);
        }
        for grip in &self.grips {
            self.held_up[grip.body as usize] = 0.0;
        }
        anchors.any_hung = false;
    }

    /// Lets sides rub that press each other, and solves along gravity again. Returns whether any do.
    pub fn solve(&mut self, bodies: &mut Bodies, along: &mut Along<'_>, sides: &[Edge]) -> bool {
        self.press(sides);
        if self.edges.is_empty() {
            return false;
        }
        self.dt = along.dt;
        self.any = true;
        self.saved.clear();
        self.records.clear();
        self.grips.clear();
        for k in 0..self.edges.len() {
            self.touch(bodies, along.anchors, self.edges[k]);
        }
        if self.grips.iter().any(|grip| grip.hangs) {
            self.hang_on(bodies, along.anchors);
        }
        if self.records.is_empty() && self.grips.is_empty() {
            self.any = false;
            return false;
        }
        // What slips hangs no more: there are no more rounds than grips.
        loop {
            self.hang(bodies, along);
            along.solve(bodies);
            if !self.slip(bodies, along) {
                break;
            }
        }
        let mut bears = false;
        for k in 0..self.grips.len() {
            let Grip { body, wall, hangs, impulse, .. } = self.grips[k];
            if hangs {
                self.held_up[body as usize] += impulse;
                if (wall as usize) < bodies.len() {
                    self.give(bodies, wall as usize, -impulse);
                    bears = true;
                }
            }
            self.records.push(Record { a: body, b: wall, axis: Axis::Across, normal: 0.0, friction: impulse });
        }
        if bears {
            along.solve(bodies);
        }
        true
    }

    /// Adds up how hard the sides press each other.
    fn press(&mut self, sides: &[Edge]) {
        self.edges.clear();
        for side in sides {
            match self.edges.iter_mut().find(|edge| (edge.a, edge.b) == (side.a, side.b)) {
                Some(edge) => edge.impulse += side.impulse,
                None => self.edges.push(*side),
            }
        }
        self.edges.retain(|edge| edge.impulse > 0.0);
    }

    /// Lets a pair that presses rub: bodies that nothing carries at once, others when it is known what has to be held.
    fn touch(&mut self, bodies: &mut Bodies, anchors: &Anchors, edge: Edge) {
        let n = bodies.len();
        let (a, b, press) = (edge.a as usize, edge.b as usize, edge.impulse.max(0.0));
        let (i, j) = if a < n && (b >= n || !anchors.rests[a]) { (a, b) } else { (b, a) };
        let skin = (if j < n { bodies.uy[j] } else { bodies.mean_vy[j] }) + bodies.skin(j, 0, i == b);
        if press == 0.0 || bodies.uy[i] == skin {
            return;
        }
        let (held, dragged) = limits(bodies, (i, j), press);
        // The ground bears what presses down on it; what is drawn up is light or heavy.
        if j >= n || (anchors.rests[j] && !anchors.rests[i] && bodies.uy[i] > skin) {
            let (body, wall) = (i as u32, j as u32);
            let hangs = bodies.rides_along(i, j, bodies.skin(j, 0, i == b));
            self.grips.push(Grip { body, wall, skin, held, dragged, hangs, on_hung: false, impulse: 0.0 });
            return;
        }
        let most = if bodies.vy[i] == bodies.vy[j] { held } else { dragged };
        let mass = 1.0 / (1.0 / bodies.mass[i] + 1.0 / bodies.mass[j]);
        let sliding = bodies.uy[i] - skin;
        let impulse = -most.min(mass * sliding.abs()).copysign(sliding);
        for (i, impulse) in [(i, impulse), (j, -impulse)] {
            self.give(bodies, i, impulse);
            // What others rub off as well is no more than what is left.
            bodies.uy[i] += impulse / bodies.mass[i];
        }
        self.records.push(Record { a: i as u32, b: j as u32, axis: Axis::Across, normal: 0.0, friction: impulse });
    }

    /// Lets those hang that nothing carries, and that stand still against what hangs and press on it: each after that on which it does.
    fn hang_on(&mut self, bodies: &Bodies, anchors: &Anchors) {
        let n = bodies.len();
        let Self { edges, grips, skins, .. } = self;
        for i in edges.iter().flat_map(|edge| [edge.a, edge.b]) {
            skins.get_mut(i as usize).into_iter().for_each(|skin| *skin = None);
        }
        for grip in grips.iter().filter(|grip| grip.hangs) {
            skins[grip.body as usize] = Some(grip.skin);
        }
        for sweep in 0..SWEEPS {
            let known = grips.len();
            for k in 0..edges.len() {
                let edge = &edges[if sweep % 2 == 0 { k } else { edges.len() - 1 - k }];
                let (a, b, press) = (edge.a as usize, edge.b as usize, edge.impulse);
                if a >= n || b >= n || press <= 0.0 || skins[a].is_some() == skins[b].is_some() || bodies.vy[a] != bodies.vy[b] {
                    continue;
                }
                let (i, j) = if skins[a].is_some() { (b, a) } else { (a, b) };
                let Some(skin) = skins[j].filter(|skin| !anchors.rests[i] && bodies.uy[i] > *skin) else { continue };
                let (held, dragged) = limits(bodies, (i, j), press);
                grips.push(Grip { body: i as u32, wall: j as u32, skin, held, dragged, hangs: true, on_hung: true, impulse: 0.0 });
                skins[i] = Some(skin);
            }
            if grips.len() == known {
                return;
            }
        }
    }

    /// Changes where a body goes along gravity by an impulse, spread over the step.
    fn give(&mut self, bodies: &mut Bodies, i: usize, impulse: f64) {
        self.saved.push((i as u32, bodies.free_vy[i], bodies.py[i]));
        let change = impulse / bodies.mass[i];
        bodies.free_vy[i] += change;
        bodies.py[i] += 0.5 * change * self.dt;
    }

    /// Lets those hang that can, and slows those that slide.
    fn hang(&mut self, bodies: &mut Bodies, along: &mut Along<'_>) {
        for &i in along.members {
            along.anchors.hung[i as usize] = None;
        }
        along.anchors.any_hung = false;
        for k in 0..self.grips.len() {
            let grip = &mut self.grips[k];
            let hung = along.anchors.hung[grip.body as usize];
            // Nothing hangs on two that move apart.
            grip.hangs &= hung.is_none_or(|skin| skin == grip.skin);
            let falls = grip.on_hung && along.anchors.hung[grip.wall as usize].is_none();
            grip.hangs &= !falls;
            if grip.hangs {
                along.anchors.hung[grip.body as usize] = Some(grip.skin);
                along.anchors.any_hung = true;
            } else if grip.impulse == 0.0 && !falls {
                self.slow(bodies, k, along.dt);
                let Grip { wall, impulse, .. } = self.grips[k];
                if (wall as usize) < bodies.len() {
                    self.give(bodies, wall as usize, -impulse);
                }
            }
        }
    }

    /// Kinetic friction on one that slides along a wall; it stops where that is enough.
    fn slow(&mut self, bodies: &mut Bodies, k: usize, dt: f64) {
        let grip = self.grips[k];
        let i = grip.body as usize;
        let (before, after) = (bodies.vy[i] - grip.skin, bodies.free_vy[i] - grip.skin);
        let mass = bodies.mass[i];
        let against = if before != 0.0 { before } else { after };
        let left = after - (grip.dragged / mass).copysign(against);
        if left * against <= 0.0 && grip.dragged > 0.0 {
            self.saved.push((i as u32, bodies.free_vy[i], bodies.py[i]));
            let slowed = before - left;
            let until = if slowed == 0.0 { 1.0 } else { (before / slowed).clamp(0.0, 1.0) };
            bodies.py[i] = bodies.y[i] + dt * (grip.skin + 0.5 * until * before);
            bodies.free_vy[i] = grip.skin;
            self.grips[k].impulse = -mass * after;
        } else {
            let impulse = -grip.dragged.copysign(against);
            self.give(bodies, i, impulse);
            self.grips[k].impulse = impulse;
        }
    }

    /// Finds who hangs and cannot be held. Returns whether there is any.
    fn slip(&mut self, bodies: &Bodies, along: &Along<'_>) -> bool {
        let n = bodies.len();
        along.members.iter().for_each(|i| self.borne[*i as usize] = 0.0);
        for grip in &self.grips {
            self.holds[grip.body as usize] = 0.0;
            self.borne.get_mut(grip.wall as usize).into_iter().for_each(|borne| *borne = 0.0);
        }
        self.load(bodies, along);
        for grip in self.grips.iter().filter(|grip| grip.hangs) {
            self.holds[grip.body as usize] += grip.held;
        }
        let mut bears = false;
        // Who hangs on another comes after it.
        for grip in self.grips.iter().rev().filter(|grip| grip.hangs && (grip.wall as usize) < n) {
            let share = grip.share(self.loads[grip.body as usize], &self.holds);
            self.borne[grip.wall as usize] += share;
            if grip.on_hung {
                self.loads[grip.wall as usize] += share;
            }
            bears = true;
        }
        if bears {
            self.load(bodies, along);
        }
        let mut slips = false;
        for grip in self.grips.iter_mut().filter(|grip| grip.hangs) {
            let load = self.loads[grip.body as usize];
            grip.impulse = -grip.share(load, &self.holds);
            if load.abs() > self.holds[grip.body as usize] * (1.0 + ROUNDING) {
                (grip.hangs, grip.impulse) = (false, 0.0);
                slips = true;
            }
        }
        slips
    }

    /// Adds up what each body has to bear, top-down.
    fn load(&mut self, bodies: &Bodies, along: &Along<'_>) {
        for &i in along.members {
            self.loads[i as usize] = self.held_up[i as usize] + self.borne[i as usize];
        }
        for &i in along.members.iter().rev() {
            let i = i as usize;
            let load = self.loads[i] + bodies.mass[i] * (bodies.free_vy[i] - bodies.uy[i]);
            self.loads[i] = load;
            if along.anchors.hung[i].is_some() || load <= 0.0 {
                continue;
            }
            let under = &along.contacts.stacks[along.contacts.under(i)];
            let slack = along.contacts.tolerances.hair / along.dt;
            let presses = |below: u32, bound: f64| {
                let j = below as usize;
                along.anchors.held[j] && (bodies.mean_vy[i] - bodies.mean_vy[j] - bound).abs() <= slack
            };
            let count = under.iter().filter(|s| s.live && presses(s.second, s.bound)).count();
            for stack in under.iter().filter(|s| s.live && presses(s.second, s.bound)) {
                if let Some(load_below) = self.loads.get_mut(stack.second as usize) {
                    *load_below += load / count as f64;
                }
            }
        }
    }
}

impl Grip {
    /// What this takes of the load of a body that all on which it hangs take together, N·s.
    fn share(&self, load: f64, holds: &[f64]) -> f64 {
        let all = holds[self.body as usize];
        if all > 0.0 { load * (self.held / all) } else { load }
    }
}

impl Along<'_> {
    pub fn solve(&mut self, bodies: &mut Bodies) {
        gravity::solve(bodies, self.members, self.contacts, self.anchors, self.clusters, self.dt);
    }
}

/// The largest impulses of static and kinetic friction between a body and what it presses with so much impulse, N·s.
fn limits(bodies: &Bodies, (i, j): (usize, usize), press: f64) -> (f64, f64) {
    let of = bodies.coefficients(i, j);
    (press * of.static_friction, press * of.kinetic_friction)
}
