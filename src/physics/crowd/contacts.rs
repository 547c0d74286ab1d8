//! Which pairs are contacts in this step, and along which axis: the narrow phase.
//!
//! A pair keeps the axis along which it is apart at the start of the step; if it is apart along both, the one that it enters
//! later. Along that axis it must still be apart, on the same side, at the end: so nothing passes through anything at any speed,
//! and no motion always satisfies every pair whose surface stands still. Speculative contact: the way may not exceed the gap.
//! What is level with another's face at the start and does not move into it belongs to the axis of that face: what slides over flush
//! tiles, or falls along a flush wall, meets no seams.

use crate::physics::crowd::bodies::{Bodies, Group};
use crate::physics::crowd::{ACROSS, ALONG};
use crate::physics::data::surface::Sides;
use glam::DVec2;

/// Gaps within this many metres of zero are touching. Larger: visible gaps; smaller: rounding turns contacts into overlaps.
const TOUCH: f64 = 1e-9;
/// The same in roundings of the largest coordinate: far from the origin they are more.
const TOUCH_ROUNDINGS: f64 = 16.0;
/// Overlaps below this are left alone, m, so that what rests is not moved by rounding; and in roundings of the largest coordinate.
const HAIR: f64 = 1e-12;
const HAIR_ROUNDINGS: f64 = 4.0;
/// How far a pair must enter across the contact's axis before a corner counts as hit, as a part of the way that it closes in the step:
/// the ways of a step are taken as straight. Larger: what lands on a corner slips off; smaller: what passes one catches.
const CATCH: f64 = 1e-6;

/// The tolerances of one island, m.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Tolerances {
    /// Gaps up to this are touching.
    pub touch: f64,
    /// Overlaps up to this are rounding.
    pub hair: f64,
}

impl Tolerances {
    /// By the largest coordinate among the bodies.
    pub fn of(bodies: &Bodies) -> Self {
        // Edge by edge, so that no comparison waits for another.
        let greater = |a: f64, b: f64| if a > b { a } else { b };
        let most = bodies.all().iter().fold([0.0; 4], |most: [f64; 4], body| {
            let [left, right, top, bottom] = body.swept;
            [greater(-left, most[0]), greater(right, most[1]), greater(-top, most[2]), greater(bottom, most[3])]
        });
        let largest = most.into_iter().fold(0.0, greater);
        let rounding = largest * f64::EPSILON;
        Self { touch: TOUCH + TOUCH_ROUNDINGS * rounding, hair: HAIR + HAIR_ROUNDINGS * rounding }
    }
}

/// Two boxes that may touch along one axis: the first has the smaller coordinate.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Contact {
    pub first: u32,
    pub second: u32,
    /// Whether it may act on velocities; if not, the two are expected to pass each other.
    pub live: bool,
    /// Whether the two are level with a face and are expected to come over each other.
    pub level: bool,
    /// The fastest mean approach, m/s: gap/dt.
    pub bound: f64,
    /// Distance of the centres when touching, m.
    pub reach: f64,
}

#[derive(Clone, Debug, Default)]
pub(crate) struct Contacts {
    /// Where the supports of a body begin and end among the stacks, by body.
    ranges: Vec<[u32; 2]>,
    /// Bodies over bodies or surfaces, by the upper one.
    pub stacks: Vec<Contact>,
    /// Pairs apart along x.
    pub sides: Vec<Contact>,
    /// Surfaces over bodies.
    pub ceilings: Vec<Contact>,
    /// Pairs that are level with a face and do not get there in this step: it is not theirs.
    missed: Vec<(u32, u32)>,
    pub tolerances: Tolerances,
    /// Whether some pair is expected to pass.
    pub passing: bool,
    /// Whether something may touch a surface that moves or runs a belt.
    pub carried: bool,
}

/// Along which axis a pair is a contact (0: across, 1: along gravity), and its flags.
struct Kind {
    axis: usize,
    live: bool,
    level: bool,
}

impl Kind {
    const fn of(axis: usize, live: bool, level: bool) -> Self {
        Self { axis, live, level }
    }
}

impl Contacts {
    /// The supports of a body, by their numbers among the stacks.
    #[inline(always)]
    pub fn under(&self, i: usize) -> std::ops::Range<usize> {
        self.ranges[i][0] as usize..self.ranges[i][1] as usize
    }

    pub fn all(&self) -> impl Iterator<Item = &Contact> {
        self.stacks.iter().chain(&self.sides).chain(&self.ceilings)
    }

    pub fn all_mut(&mut self) -> impl Iterator<Item = &mut Contact> {
        self.stacks.iter_mut().chain(&mut self.sides).chain(&mut self.ceilings)
    }

    fn clear(&mut self, bodies: &Bodies) {
        self.stacks.clear();
        self.sides.clear();
        self.ceilings.clear();
        self.passing = false;
        self.carried = false;
        self.tolerances = Tolerances::of(bodies);
        self.ranges.resize(bodies.len(), [0; 2]);
    }

    pub fn find(&mut self, bodies: &Bodies, group: Group<'_>, dt: f64) {
        self.clear(bodies);
        let per_second = 1.0 / dt;
        for i in 0..bodies.len() {
            let begin = self.stacks.len() as u32;
            for j in group.near(i) {
                self.meet(bodies, i, j, [dt, per_second]);
            }
            self.ranges[i] = [begin, self.stacks.len() as u32];
        }
    }

    /// Begins a step: nobody has missed anything.
    pub fn begin_step(&mut self) {
        self.missed.clear();
    }

    /// How many pairs are level with faces that they were expected to come over, and do not on the ways that were solved, where that holds a body
    /// along both axes: in the air, beside the one face and over the other. Found again, their contacts will be those of any corner.
    pub fn miss(&mut self, bodies: &Bodies) -> usize {
        let (known, touch, n) = (self.missed.len(), self.tolerances.touch, bodies.len());
        let misses = |contact: &&Contact, axis: usize| {
            let (a, b) = (&bodies[contact.first as usize], &bodies[contact.second as usize]);
            contact.level && contact.live && (a.to[axis] - b.to[axis]).abs() - a.half[axis] - b.half[axis] > touch
        };
        let along = || self.stacks.iter().chain(&self.ceilings).filter(|c| misses(c, ACROSS));
        let across = || self.sides.iter().filter(|c| misses(c, ALONG));
        let holds = |c: &Contact, i: u32| (i as usize) < n && (c.first == i || c.second == i);
        let both = |a: &Contact, b: &Contact| holds(b, a.first) || holds(b, a.second);
        let mut missed = std::mem::take(&mut self.missed);
        missed.extend(along().filter(|a| across().any(|b| both(a, b))).map(|c| (c.first, c.second)));
        missed.extend(across().filter(|a| along().any(|b| both(a, b))).map(|c| (c.first, c.second)));
        self.missed = missed;
        self.missed.len() - known
    }

    /// Adds what body i and body or surface j are to each other; a body j comes before i in the island's order. `per_second` is 1/dt.
    #[inline(always)]
    fn meet(&mut self, bodies: &Bodies, i: usize, j: usize, [dt, per_second]: [f64; 2]) {
        let touch = self.tolerances.touch;
        let (dx, dy) = (bodies[j].from.x - bodies[i].from.x, bodies[j].from.y - bodies[i].from.y);
        let (reach_x, reach_y) = (bodies[i].half.x + bodies[j].half.x, bodies[i].half.y + bodies[j].half.y);
        let (gap_x, gap_y) = (dx.abs() - reach_x, dy.abs() - reach_y);
        let surface = j >= bodies.len();
        self.carried |= surface && bodies.carries(j);
        let is_of = |pair: &(u32, u32)| *pair == (i as u32, j as u32) || *pair == (j as u32, i as u32);
        let misses = !self.missed.is_empty() && self.missed.iter().any(is_of);
        let Kind { axis, live, level } = kind(bodies, (i, j), [dx, dy], [gap_x, gap_y], (dt, touch, misses));
        let (distance, gap, reach) = if axis == 0 { (dx, gap_x, reach_x) } else { (dy, gap_y, reach_y) };
        let upper = distance >= 0.0;
        self.passing |= !live;
        if surface && is_open(bodies, j, axis, !upper, gap, touch) {
            return;
        }
        let (first, second) = if upper { (i as u32, j as u32) } else { (j as u32, i as u32) };
        let list = match (axis, upper) {
            (0, _) => &mut self.sides,
            (_, true) => &mut self.stacks,
            (_, false) => &mut self.ceilings,
        };
        let bound = if gap > touch { gap * per_second } else { 0.0 };
        list.push(Contact { first, second, live, level, bound, reach });
    }
}

/// Whether a surface lets pass what is beside its face along `axis` towards smaller or `larger` coordinates.
fn is_open(bodies: &Bodies, surface: usize, axis: usize, larger: bool, gap: f64, touch: f64) -> bool {
    let sides = bodies[surface].sides;
    sides != Sides::ALL && (!sides.face(axis, larger) || gap < -touch)
}

#[inline(always)]
fn kind(
    bodies: &Bodies,
    (i, j): (usize, usize),
    [dx, dy]: [f64; 2],
    [gap_x, gap_y]: [f64; 2],
    (dt, touch, misses): (f64, f64, bool),
) -> Kind {
    // Most pairs rest on each other or stand side by side.
    if gap_x < -touch && gap_y <= touch {
        return Kind::of(usize::from(gap_y >= -touch || gap_x <= gap_y), true, false);
    }
    if gap_y < -touch && gap_x <= touch {
        return Kind::of(0, true, false);
    }
    // How far they close along each axis within the step.
    let side = DVec2::new(if dx < 0.0 { -1.0 } else { 1.0 }, if dy < 0.0 { -1.0 } else { 1.0 });
    let (a, b) = (&bodies[i], &bodies[j]);
    let DVec2 { x: close_x, y: close_y } = ((a.to - a.from) - (b.to - b.from)) * side;
    if gap_x < -touch {
        // Over each other and apart: passes only if it has left sideways before it arrives.
        let leaves = gap_y < close_y && gap_x - close_x * (gap_y / close_y) > 0.0;
        return Kind::of(1, !leaves, false);
    }
    if gap_y < -touch {
        let leaves = gap_x < close_x && gap_y - close_y * (gap_x / close_x) > 0.0;
        return Kind::of(0, !leaves, false);
    }
    if !misses {
        let start = (a.before - b.before) * dt * side;
        if let Some(kind) = level([gap_x, gap_y], [close_x, close_y], start.to_array(), touch) {
            return kind;
        }
    }
    corner([gap_x, gap_y], [close_x, close_y])
}

/// A pair that is apart along both axes: what is level with a face and does not move into it (`start`: how far the velocities at the start
/// would close) belongs to that face, whatever pulls at it.
fn level([gap_x, gap_y]: [f64; 2], [close_x, close_y]: [f64; 2], start: [f64; 2], touch: f64) -> Option<Kind> {
    let level_x = gap_x <= touch && start[0] <= touch;
    let level_y = gap_y <= touch && start[1] <= touch;
    if level_y && !(level_x && close_x <= touch) {
        return Some(Kind::of(1, close_x > gap_x, true));
    }
    level_x.then_some(Kind::of(0, close_y > gap_y, true))
}

/// The same where none is level: the later entry decides.
fn corner([gap_x, gap_y]: [f64; 2], [close_x, close_y]: [f64; 2]) -> Kind {
    let enters = |gap: f64, close: f64| if close > 0.0 { (gap + CATCH * close) / close } else { f64::INFINITY };
    let (enter_x, enter_y) = (enters(gap_x, close_x), enters(gap_y, close_y));
    let by_x = if enter_x.is_infinite() && enter_y.is_infinite() { gap_x >= gap_y } else { enter_x >= enter_y };
    let live = enter_x <= 1.0 && enter_y <= 1.0;
    Kind::of(usize::from(!by_x), live, false)
}
