//! Friction on upright faces: along walls, and between bodies side by side (`docs/physics.md`, The crowd step, 4). Bodies side by side that
//! nothing carries rub as a pair. Bodies that the ground carries take no part.

use crate::physics::crowd::{ACROSS, ALONG, Edge, ROUNDING, Record, bodies::Bodies, clusters::Node};
use crate::physics::{crowd::gravity::Along, crowd::gravity::Anchors, data::lists::refill};

/// Sweeps of the search for bodies that hang on hanging ones. Fewer: the end of a long row that is listed in disorder falls.
const SWEEPS: usize = 8;

#[derive(Clone, Copy, Debug)]
struct WallContact {
    body: u32,
    wall: u32,
    /// Velocity of the wall's surface along gravity, m/s.
    surface_velocity: f64,
    /// The largest impulses of friction, N·s.
    static_limit: f64,
    kinetic_limit: f64,
    /// Whether the wall does not give way: it stands or hangs.
    firm: bool,
    /// Whether the body hangs, and whether the wall is a body that does.
    hangs: bool,
    on_hung: bool,
    /// Impulse on the body, N·s.
    impulse: f64,
}

#[derive(Clone, Debug, Default)]
pub(crate) struct Walls {
    pub any: bool,
    grips: Vec<WallContact>,
    edges: Vec<Edge>,
    loads: Vec<f64>,
    /// N·s.
    pub held_up: Vec<f64>,
    /// The load that hanging bodies put on each body, N·s, and the limit of all faces on which a body hangs.
    borne: Vec<f64>,
    holds: Vec<f64>,
    saved: Vec<(u32, f64, f64)>,
    dt: f64,
}

impl Walls {
    pub fn begin(&mut self, n: usize) {
        self.any = false;
        for forces in [&mut self.held_up, &mut self.loads, &mut self.borne, &mut self.holds] {
            refill(forces, n, 0.0);
        }
    }

    pub fn record(&self, into: &mut Vec<Record>) {
        let record = |grip: &WallContact| Record { a: grip.body, b: grip.wall, axis: ACROSS, normal: 0.0, friction: grip.impulse };
        into.extend(self.grips.iter().filter(|_| self.any).map(record));
    }

    pub fn undo(&mut self, bodies: &mut Bodies, anchors: &mut Anchors) {
        if !std::mem::take(&mut self.any) {
            return;
        }
        for &(i, free, predicted) in self.saved.iter().rev() {
            (bodies[i as usize].free.y, bodies[i as usize].to.y) = (free, predicted);
        }
        self.grips.iter().for_each(|grip| self.held_up[grip.body as usize] = 0.0);
        anchors.any_hung = false;
    }

    /// Lets sides rub that press each other, and solves along gravity again. Returns whether any do.
    pub fn solve(&mut self, bodies: &mut Bodies, along: &mut Along<'_>, sides: &[Edge]) -> bool {
        self.press(sides);
        if self.edges.is_empty() {
            return false;
        }
        self.saved.clear();
        self.dt = along.dt;
        self.find(bodies, along);
        self.any = !self.grips.is_empty();
        if !self.any {
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
            let WallContact { body, wall, hangs, impulse, .. } = self.grips[k];
            if hangs {
                self.held_up[body as usize] += impulse;
                bears |= (wall as usize) < bodies.len();
                self.give(bodies, wall, [-impulse, -0.5 * impulse]);
            }
        }
        if bears {
            along.solve(bodies);
        }
        true
    }

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

    /// Finds the bodies that may hang, first on what stands, then on each other, and the pairs that slide.
    fn find(&mut self, bodies: &Bodies, along: &mut Along<'_>) {
        let Self { edges, grips, .. } = self;
        let anchors = &mut *along.anchors;
        anchors.hung.fill(None);
        grips.clear();
        let mut last = false;
        for sweep in 0.. {
            let found = grips.len();
            edges.retain(|edge| {
                let grip = WallContact::of(bodies, anchors, edge);
                let known = grip.hangs || (grip.firm && !grip.on_hung);
                if !known && !last {
                    return true;
                }
                let hangs = |i: u32| anchors.hung.get(i as usize).is_some_and(|hung| hung.is_some());
                let moves =
                    bodies[grip.body as usize].end.y != grip.surface_velocity && !(hangs(grip.body) && hangs(grip.wall) && !known);
                grips.extend(moves.then_some(grip));
                if moves && grip.hangs {
                    anchors.hung[grip.body as usize] = Some(grip.surface_velocity);
                }
                false
            });
            edges.reverse();
            if last {
                break;
            }
            // The last sweep takes every face that is left.
            last = grips.len() == found || sweep == SWEEPS;
        }
    }

    fn hang(&mut self, bodies: &mut Bodies, along: &mut Along<'_>) {
        let anchors = &mut *along.anchors;
        anchors.hung.fill(None);
        anchors.any_hung = false;
        for k in 0..self.grips.len() {
            let grip = &mut self.grips[k];
            let (body, wall) = (grip.body as usize, grip.wall as usize);
            let falls = grip.on_hung && anchors.hung[wall].is_none();
            // Nothing hangs on two that move apart.
            grip.hangs &= !falls && anchors.hung[body].is_none_or(|surface_velocity| surface_velocity == grip.surface_velocity);
            if grip.hangs {
                (anchors.hung[body], anchors.any_hung) = (Some(grip.surface_velocity), true);
            } else if grip.impulse == 0.0 && !falls {
                self.slow(bodies, k);
            }
        }
    }

    fn slow(&mut self, bodies: &mut Bodies, k: usize) {
        let WallContact { body, wall, surface_velocity, static_limit, kinetic_limit, firm, .. } = self.grips[k];
        let (i, j) = (body as usize, wall as usize);
        let mass = if firm { bodies[i].mass } else { 1.0 / (1.0 / bodies[i].mass + 1.0 / bodies[j].mass) };
        let way = (bodies[i].to.y - bodies[i].from.y) / self.dt;
        let [before, after, mean] = match firm {
            true => [bodies[i].before.y - surface_velocity, bodies[i].free.y - surface_velocity, way - surface_velocity],
            false => {
                [bodies[i].before.y - bodies[j].before.y, bodies[i].end.y - bodies[j].end.y, bodies[i].mean.y - bodies[j].mean.y]
            }
        };
        let static_limit = if !firm && before == 0.0 { static_limit } else { 0.0 };
        let left = Node { static_limit, kinetic_limit, ..Node::free(mass, before, after, mean) }.motion();
        let impulse = mass * (left.velocity - after);
        // What stops a pair is spread over the step: other contacts may have changed how fast they are within it.
        let on_average = if firm { mass * (left.mean - mean) } else { 0.5 * impulse };
        self.give(bodies, body, [impulse, on_average]);
        self.give(bodies, wall, [-impulse, -on_average]);
        if firm && left.velocity == 0.0 {
            bodies[i].free.y = surface_velocity;
        }
        self.grips[k].impulse = impulse;
    }

    /// Gives a body an impulse along gravity, at the end of the step and on average over it, N·s.
    fn give(&mut self, bodies: &mut Bodies, i: u32, [impulse, on_average]: [f64; 2]) {
        if (i as usize) < bodies.len() {
            let body = &mut bodies[i as usize];
            self.saved.push((i, body.free.y, body.to.y));
            body.free.y += impulse / body.mass;
            body.to.y += on_average / body.mass * self.dt;
            // What others rub off as well is no more than what is left.
            body.end.y += impulse / body.mass;
            body.mean.y += on_average / body.mass;
        }
    }

    /// Finds the hanging bodies that cannot be held. Returns whether there is any.
    fn slip(&mut self, bodies: &Bodies, along: &Along<'_>) -> bool {
        self.borne.fill(0.0);
        self.holds.fill(0.0);
        self.load(bodies, along);
        let Self { grips, holds, loads, borne, .. } = self;
        let hanging = || grips.iter().filter(|grip| grip.hangs);
        hanging().for_each(|grip| holds[grip.body as usize] += grip.static_limit);
        let mut bears = false;
        // Who hangs on another comes after it.
        for grip in hanging().rev().filter(|grip| (grip.wall as usize) < bodies.len()) {
            let share = grip.share(loads, holds);
            borne[grip.wall as usize] += share;
            loads[grip.wall as usize] += share;
            bears = true;
        }
        if bears {
            self.load(bodies, along);
        }
        let Self { grips, holds, loads, .. } = self;
        let mut slips = false;
        for grip in grips.iter_mut().filter(|grip| grip.hangs) {
            grip.hangs = loads[grip.body as usize].abs() <= holds[grip.body as usize] * (1.0 + ROUNDING);
            grip.impulse = if grip.hangs { -grip.share(loads, holds) } else { 0.0 };
            slips |= !grip.hangs;
        }
        slips
    }

    fn load(&mut self, bodies: &Bodies, along: &Along<'_>) {
        let press = |i: usize| bodies[i].mass * (bodies[i].free.y - bodies[i].end.y);
        (0..bodies.len()).for_each(|i| self.loads[i] = self.borne[i] + press(i));
        along.contacts.hand_down(bodies, along.anchors, &mut self.loads, |_, _, _| ());
    }
}

impl WallContact {
    fn of(bodies: &Bodies, anchors: &Anchors, edge: &Edge) -> Self {
        let (n, a, b) = (bodies.len(), edge.a as usize, edge.b as usize);
        let stands = |i: usize| i >= n || anchors.rests[i];
        let hung = |i: usize| anchors.hung.get(i).copied().flatten();
        // The wall is what stands, or what hangs already.
        let (i, j) = if b >= n || (!stands(a) && (stands(b) || hung(a).is_none())) { (a, b) } else { (b, a) };
        let belt = bodies.belt_velocity(j, ACROSS, i == b);
        let surface_velocity = hung(j).unwrap_or(if j < n { bodies[j].end.y } else { bodies[j].mean.y }) + belt;
        let falls = !stands(i) && bodies[i].end.y > surface_velocity;
        // The ground bears what presses down on it; what is drawn up is light or heavy.
        let on_firm = j >= n || (stands(j) && falls);
        let on_hung = !on_firm && hung(j).is_some() && hung(i).is_none();
        let hangs = (on_firm || (on_hung && falls)) && bodies.rides(i, j, ALONG, belt);
        let of = bodies.coefficients(i, j);
        let (static_limit, kinetic_limit) = (edge.impulse * of.static_friction, edge.impulse * of.kinetic_friction);
        let (body, wall, firm) = (i as u32, j as u32, on_firm || on_hung);
        Self { body, wall, surface_velocity, static_limit, kinetic_limit, firm, hangs, on_hung, impulse: 0.0 }
    }

    /// What this takes of the load of a body that all on which it hangs take together, N·s.
    fn share(&self, loads: &[f64], holds: &[f64]) -> f64 {
        let (load, all) = (loads[self.body as usize], holds[self.body as usize]);
        if all > 0.0 { load * (self.static_limit / all) } else { load }
    }
}
