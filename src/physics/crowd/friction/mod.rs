//! Friction of the stacks.
//!
//! A body's load is split equally among its tight supports; μ times the load is the limit of friction. [`grips`] finds which contacts stick.
//!
//! Only bodies that move, are pushed, or stand on such take part. A standing body holds all that slides on it, as its own limit is at least theirs
//! together, if no surface is more slippery than the bodies and these are alike. A moving surface or belt carries at its belt's velocity.

pub(crate) mod grips;

use crate::physics::crowd::{ACROSS, ALONG, bodies::Bodies, clusters::time_to_stop, contacts::Contacts, contacts::CrowdContact};
use crate::physics::crowd::{gravity::Anchors, gravity::SLACK};
use crate::physics::data::lists::refill;

#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) enum Grip {
    #[default]
    Stick,
    /// The friction on the upper body has this sign.
    Slip(f64),
}

#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct FrictionContact {
    pub below: u32,
    pub grip: Grip,
    /// Impulse along the normal, N·s.
    pub load: f64,
    /// Largest impulses of friction, N·s.
    pub static_limit: f64,
    pub kinetic_limit: f64,
    /// Friction's impulse on the upper body, N·s.
    pub impulse: f64,
    stood: bool,
    /// What holds once a slide has ended, N·s.
    holds: f64,
    /// The part of the largest impulse that acts on a slide: less than 1 where it turned round within the step.
    sense: f64,
    above: bool,
    /// Velocity of the belt besides that of what it belongs to, m/s.
    pub belt_velocity: f64,
}

impl FrictionContact {
    #[inline(always)]
    fn sticks(&self) -> bool {
        self.grip == Grip::Stick && self.static_limit > 0.0
    }

    /// Sets its load, N·s, of which it returns a part: its limits so far are coefficients.
    fn press(&mut self, impulse: f64, restitution: f64) {
        let rubs = impulse.max(0.0) * (1.0 + restitution);
        (self.load, self.static_limit, self.holds, self.kinetic_limit) =
            (impulse, self.static_limit * rubs, self.holds * rubs, self.kinetic_limit * rubs);
    }
}

/// Of a body and all that it carries: momenta across at the end of the step and at its start, N·s, and the mass, kg.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Riders {
    pub momentum: f64,
    pub began: f64,
    pub mass: f64,
}

#[derive(Clone, Debug, Default)]
pub(crate) struct Friction {
    /// Tight contacts of body i: `tight[start[i]..end[i]]`.
    start: Vec<u32>,
    end: Vec<u32>,
    pub tight: Vec<FrictionContact>,
    pub riders: Vec<Riders>,
    loads: Vec<f64>,
    awake: Vec<u32>,
    pub is_awake: Vec<bool>,
    /// Those of them that stand on something or carry something, bottom-up.
    pub gripped: Vec<u32>,
    pub is_gripped: Vec<bool>,
    carried: bool,
    /// Whether a slide turns round within the step: the step does not show what friction did until then.
    pub turned: bool,
    pub relaxed: u64,
    /// The bodies that a round solves, and those of which a grip has changed in it; by body, one of those that contacts join to it (a union–find
    /// forest), and whether a grip has changed among them.
    solved: Vec<u32>,
    changed: Vec<u32>,
    group: Vec<u32>,
    stirred: Vec<bool>,
}

impl Friction {
    pub fn begin(&mut self, all: usize) {
        [&mut self.is_awake, &mut self.is_gripped, &mut self.stirred].into_iter().for_each(|flags| refill(flags, all, false));
        [&mut self.start, &mut self.end, &mut self.group].into_iter().for_each(|places| places.resize(all, 0));
        for bodies in [&mut self.solved, &mut self.changed] {
            bodies.clear();
            bodies.reserve(all);
        }
        self.loads.resize(all, 0.0);
        self.riders.resize(all, Riders::default());
    }

    pub fn under(&self, i: usize) -> std::ops::Range<usize> {
        self.start[i] as usize..self.end[i] as usize
    }

    /// The impulse of friction between a body and one of its supports, N·s, on the upper one.
    pub fn impulse(&self, upper: usize, below: u32) -> f64 {
        let tight = if self.is_awake[upper] { &self.tight[self.under(upper)] } else { &[] };
        tight.iter().find(|t| t.below == below).map_or(0.0, |t| t.impulse)
    }

    pub fn rest(&mut self, n: usize) {
        self.awake.clear();
        self.gripped.clear();
        self.is_awake[..n].fill(false);
    }

    pub fn wake(&mut self, bodies: &Bodies, contacts: &Contacts, given: &[f64], pushed: &[bool]) {
        self.awake.clear();
        let n = bodies.len();
        for i in 0..n {
            let under = &contacts.stacks[contacts.under(i)];
            let stirs = |j: usize| match bodies.is_body(j) {
                true => j < n && self.is_awake[j],
                false => bodies[j].end.x != 0.0 || bodies[j].belt != 0.0 || bodies.is_slippery(j),
            };
            let awake = !bodies.alike
                || given[i] != 0.0
                || pushed[i]
                || under.is_empty()
                || bodies[i].end.y != 0.0
                || under.iter().any(|stack| stirs(stack.second as usize));
            self.is_awake[i] = awake;
            if awake {
                self.awake.push(i as u32);
            }
        }
    }

    pub fn touch(&mut self, bodies: &Bodies, contacts: &Contacts, dt: f64) {
        let slack = contacts.tolerances.hair / dt;
        self.carried = contacts.carried;
        self.tight.clear();
        self.gripped.clear();
        for k in 0..self.awake.len() {
            let i = self.awake[k] as usize;
            self.start[i] = self.tight.len() as u32;
            self.is_gripped[i] = false;
            for stack in &contacts.stacks[contacts.under(i)] {
                self.grip(bodies, i, stack, slack);
            }
            for ceiling in contacts.ceilings.iter().filter(|ceiling| ceiling.second as usize == i) {
                self.grip(bodies, i, ceiling, slack);
            }
            self.end[i] = self.tight.len() as u32;
            for tight in &self.tight[self.start[i] as usize..] {
                (self.is_gripped[i], self.is_gripped[tight.below as usize]) = (true, true);
            }
        }
        self.gripped.extend(self.awake.iter().filter(|i| self.is_gripped[**i as usize]));
    }

    #[inline(always)]
    fn grip(&mut self, bodies: &Bodies, i: usize, contact: &CrowdContact, slack: f64) {
        let gains = bodies[contact.first as usize].end.y - bodies[contact.second as usize].end.y;
        if gains.abs() > SLACK || !Contacts::closes(bodies, contact, slack) {
            return;
        }
        let above = contact.second as usize == i;
        let below = if above { contact.first } else { contact.second };
        let (of, belt_velocity) = (bodies.coefficients(i, below as usize), bodies.belt_velocity(below as usize, ALONG, above));
        let stood = bodies.rides(i, below as usize, ACROSS, belt_velocity);
        let (kinetic_limit, holds) = (of.kinetic_friction, of.static_friction);
        // Kinetic friction stops a slide; static friction holds a body that stands.
        let static_limit = if stood { holds } else { kinetic_limit };
        let limits = FrictionContact { static_limit, kinetic_limit, holds, sense: 1.0, ..FrictionContact::default() };
        self.tight.push(FrictionContact { below, above, stood, belt_velocity, ..limits });
    }

    /// Adds up the loads top-down, N·s. A bounce with restitution e rubs with 1 + e times the impulse that stops it.
    pub fn load(&mut self, bodies: &Bodies, held_up: &[f64], anchors: &Anchors) {
        self.awake.iter().for_each(|i| self.loads[*i as usize] = held_up[*i as usize]);
        self.load_loose(anchors);
        let Self { start, end, tight, loads, gripped, .. } = self;
        for i in gripped.iter().rev().map(|i| *i as usize) {
            let (tight, body) = (&mut tight[start[i] as usize..end[i] as usize], &bodies[i]);
            if anchors.loose[i] {
                tight.iter_mut().filter(|tight| tight.load == 0.0).for_each(|tight| tight.press(0.0, 0.0));
                continue;
            }
            let load = loads[i] + body.mass * (body.free.y - body.end.y);
            let bears = |tight: &FrictionContact| tight.above == (load < 0.0);
            let share = load.abs() / tight.iter().filter(|t| bears(t)).count() as f64;
            for tight in tight {
                let share = if bears(tight) { share } else { 0.0 };
                tight.press(share, anchors.bounce[i]);
                if !tight.above {
                    loads[tight.below as usize] += share;
                }
            }
        }
    }

    fn load_loose(&mut self, anchors: &Anchors) {
        for edge in &anchors.edges {
            let impulse = edge.impulse.max(0.0);
            for (i, other) in [(edge.a, edge.b), (edge.b, edge.a)] {
                if !anchors.loose.get(i as usize).is_some_and(|loose| *loose && self.is_awake[i as usize]) {
                    continue;
                }
                let under = self.under(i as usize);
                if let Some(tight) = self.tight[under].iter_mut().find(|tight| tight.below == other) {
                    tight.press(impulse, edge.restitution);
                }
            }
            if anchors.loose.get(edge.b as usize) == Some(&false) {
                self.loads[edge.b as usize] += impulse;
            }
        }
    }

    /// Mean velocities across: friction acts evenly over the step, or until the slide stops. Those of bodies that are `told` stay.
    pub fn spread_ways(&self, bodies: &mut Bodies, told: &[bool], dt: f64) {
        for i in self.gripped.iter().map(|i| *i as usize).filter(|i| !told[*i]) {
            let (body, under) = (&bodies[i], &self.tight[self.under(i)]);
            let mut mean = (body.to.x - body.from.x) / dt + 0.5 * (body.end.x - body.free.x);
            let strongest = under.iter().reduce(|a, b| if b.static_limit > a.static_limit { b } else { a });
            if let Some(tight) = strongest {
                let (belt, below) = (tight.belt_velocity, &bodies[tight.below as usize]);
                let began = below.was.x;
                if tight.sense != 1.0 && tight.grip != Grip::Stick {
                    let part = 0.5 * (1.0 - tight.sense);
                    let turns = began + part * (below.end.x - began) + belt;
                    mean = 0.5 * (part * (body.before.x + turns) + (1.0 - part) * (turns + body.end.x));
                } else if body.end.x == below.end.x + belt {
                    let carried = below.mean.x + belt;
                    let sliding = body.before.x - began - belt;
                    let gained = body.free.x - body.before.x - (below.end.x - began);
                    let kinetic_limit: f64 = under.iter().map(|t| t.kinetic_limit).sum();
                    let until = time_to_stop(sliding, gained, kinetic_limit / self.riders[i].mass);
                    mean = carried + if tight.stood { 0.0 } else { 0.5 * sliding * until };
                }
            }
            bodies[i].mean.x = mean;
        }
    }

    /// Neighbours have set the velocity of a body: only kinetic friction acts where they push it along.
    pub fn free_pushed(&mut self, i: usize, slides: bool) {
        let under = self.under(i);
        for tight in &mut self.tight[under] {
            tight.stood = true;
            if slides {
                (tight.static_limit, tight.holds) = (tight.kinetic_limit, tight.kinetic_limit);
            }
        }
    }
}
