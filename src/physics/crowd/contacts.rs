//! The narrow phase: which pairs are contacts in this step, and along which axis (`docs/physics.md`, The crowd step, 1).

use crate::physics::crowd::{ACROSS, ALONG, bodies::Bodies, bodies::Group, bodies::Member};
use crate::physics::data::Sides;
use glam::DVec2;

/// m. Larger: visible gaps; smaller: rounding turns contacts into overlaps.
pub(crate) const TOUCH: f64 = 1e-9;
const TOUCH_ROUNDINGS: f64 = 16.0;
/// Smaller overlaps are left alone, m, so that rest is not moved by rounding; and in roundings of the largest coordinate.
const HAIR: f64 = 1e-12;
const HAIR_ROUNDINGS: f64 = 4.0;
/// How far a pair must enter across the contact's axis before a corner counts as hit, as a part of the way that it closes. Larger: bodies that land
/// on a corner slip off; smaller: those that pass one catch.
const CATCH: f64 = 1e-6;
/// Closing speeds up to this are none, m/s. Smaller: rounding bounces.
const SLOWEST: f64 = 1e-9;

#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Tolerances {
    pub touch: f64,
    pub hair: f64,
}

impl Tolerances {
    pub fn of(bodies: &Bodies) -> Self {
        let largest = bodies.all().iter().map(|body| body.swept.largest()).fold(bodies.settled_largest, f64::max);
        let rounding = largest * f64::EPSILON;
        Self { touch: TOUCH + TOUCH_ROUNDINGS * rounding, hair: HAIR + HAIR_ROUNDINGS * rounding }
    }
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct CrowdContact {
    pub first: u32,
    pub second: u32,
    /// Whether it may act on velocities; if not, the two are expected to pass each other.
    pub live: bool,
    /// Whether the two are level with a face and are expected to come over it.
    pub level: bool,
    /// The fastest mean approach, m/s: gap/dt.
    pub bound: f64,
    /// Distance of the centres when touching, m.
    pub reach: f64,
}

#[derive(Clone, Debug, Default)]
pub(crate) struct Contacts {
    ranges: Vec<[u32; 2]>,
    pub stacks: Vec<CrowdContact>,
    /// Pairs apart along x.
    pub sides: Vec<CrowdContact>,
    pub ceilings: Vec<CrowdContact>,
    /// Pairs that are level with a face and do not get there in this step.
    pub missed: Vec<(u32, u32)>,
    pub tolerances: Tolerances,
    pub passing: bool,
    pub carried: bool,
}

/// 0: across, 1: along gravity.
struct ContactKind {
    axis: usize,
    live: bool,
    level: bool,
}

impl Contacts {
    #[inline(always)]
    pub fn under(&self, i: usize) -> std::ops::Range<usize> {
        self.ranges[i][0] as usize..self.ranges[i][1] as usize
    }

    pub fn all(&self) -> impl Iterator<Item = &CrowdContact> {
        self.stacks.iter().chain(&self.sides).chain(&self.ceilings)
    }

    pub fn all_mut(&mut self) -> impl Iterator<Item = &mut CrowdContact> {
        self.stacks.iter_mut().chain(&mut self.sides).chain(&mut self.ceilings)
    }

    pub fn find(&mut self, bodies: &mut Bodies, group: Group<'_>, dt: f64) {
        [&mut self.stacks, &mut self.sides, &mut self.ceilings].into_iter().for_each(Vec::clear);
        (self.passing, self.carried) = (false, false);
        self.tolerances = Tolerances::of(bodies);
        self.ranges.resize(bodies.len(), [0; 2]);
        let per_second = 1.0 / dt;
        for i in 0..bodies.len() {
            let begin = self.stacks.len() as u32;
            for j in group.near(i) {
                self.meet(bodies, i, j, [dt, per_second]);
            }
            self.ranges[i] = [begin, self.stacks.len() as u32];
        }
        // They are found as if settled bodies fell freely, too; then these stand.
        let n = bodies.len();
        bodies.things[n..].iter_mut().filter(|thing| thing.settled).for_each(|thing| thing.to = thing.from);
    }

    /// The number of level pairs that do not come over their faces as expected, and hold a body along both axes in the air: now corners like any.
    pub fn miss(&mut self, bodies: &Bodies) -> usize {
        let (known, touch) = (self.missed.len(), self.tolerances.touch);
        let misses = |contact: &&CrowdContact, axis: usize| {
            let (a, b) = (&bodies[contact.first as usize], &bodies[contact.second as usize]);
            contact.level && contact.live && (a.to[axis] - b.to[axis]).abs() - a.half[axis] - b.half[axis] > touch
        };
        let along = || self.stacks.iter().chain(&self.ceilings).filter(|c| misses(c, ACROSS));
        let across = || self.sides.iter().filter(|c| misses(c, ALONG));
        let holds = |c: &CrowdContact, i: u32| bodies.is_body(i as usize) && (c.first == i || c.second == i);
        let both = |a: &CrowdContact, b: &CrowdContact| holds(b, a.first) || holds(b, a.second);
        let mut missed = std::mem::take(&mut self.missed);
        missed.extend(along().filter(|a| across().any(|b| both(a, b))).map(|c| (c.first, c.second)));
        missed.extend(across().filter(|a| along().any(|b| both(a, b))).map(|c| (c.first, c.second)));
        self.missed = missed;
        self.missed.len() - known
    }

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
        let ContactKind { axis, live, level } = kind(bodies, (i, j), [dx, dy], [gap_x, gap_y], (dt, touch, misses));
        let (distance, gap, reach) = if axis == 0 { (dx, gap_x, reach_x) } else { (dy, gap_y, reach_y) };
        let upper = distance >= 0.0;
        self.passing |= !live;
        let sides = bodies[j].sides;
        if surface && sides != Sides::ALL && (!sides.face(axis, !upper) || gap < -touch) {
            // Not solid on that side.
            return;
        }
        let (first, second) = if upper { (i as u32, j as u32) } else { (j as u32, i as u32) };
        let list = match (axis, upper) {
            (0, _) => &mut self.sides,
            (_, true) => &mut self.stacks,
            (_, false) => &mut self.ceilings,
        };
        let bound = if gap > touch { gap * per_second } else { 0.0 };
        list.push(CrowdContact { first, second, live, level, bound, reach });
    }
}

#[inline(always)]
fn kind(
    bodies: &Bodies,
    (i, j): (usize, usize),
    [dx, dy]: [f64; 2],
    [gap_x, gap_y]: [f64; 2],
    (dt, touch, misses): (f64, f64, bool),
) -> ContactKind {
    // Most pairs rest on each other or stand side by side.
    if gap_x < -touch && gap_y <= touch {
        return ContactKind { axis: usize::from(gap_y >= -touch || gap_x <= gap_y), live: true, level: false };
    }
    if gap_y < -touch && gap_x <= touch {
        return ContactKind { axis: 0, live: true, level: false };
    }
    // How far they close along each axis within the step.
    let side = DVec2::new(if dx < 0.0 { -1.0 } else { 1.0 }, if dy < 0.0 { -1.0 } else { 1.0 });
    let (a, b) = (&bodies[i], &bodies[j]);
    let DVec2 { x: close_x, y: close_y } = ((a.to - a.from) - (b.to - b.from)) * side;
    if gap_x < -touch {
        // Over each other and apart: passes only if it has left sideways before it arrives.
        let leaves = gap_y < close_y && gap_x - close_x * (gap_y / close_y) > 0.0;
        return ContactKind { axis: 1, live: !leaves, level: false };
    }
    if gap_y < -touch {
        let leaves = gap_x < close_x && gap_y - close_y * (gap_x / close_x) > 0.0;
        return ContactKind { axis: 0, live: !leaves, level: false };
    }
    if !misses {
        let start = (a.before - b.before) * dt * side;
        if let Some(kind) = level([gap_x, gap_y], [close_x, close_y], start.to_array(), touch) {
            return kind;
        }
    }
    corner([gap_x, gap_y], [close_x, close_y])
}

/// A pair that is apart along both axes: if level with a face and not moving into it at the `start`, it belongs to that face.
fn level([gap_x, gap_y]: [f64; 2], [close_x, close_y]: [f64; 2], start: [f64; 2], touch: f64) -> Option<ContactKind> {
    let level_x = gap_x <= touch && start[0] <= touch;
    let level_y = gap_y <= touch && start[1] <= touch;
    if level_y && !(level_x && close_x <= touch) {
        return Some(ContactKind { axis: 1, live: close_x > gap_x, level: true });
    }
    level_x.then_some(ContactKind { axis: 0, live: close_y > gap_y, level: true })
}

fn corner([gap_x, gap_y]: [f64; 2], [close_x, close_y]: [f64; 2]) -> ContactKind {
    let enters = |gap: f64, close: f64| if close > 0.0 { (gap + CATCH * close) / close } else { f64::INFINITY };
    let (enter_x, enter_y) = (enters(gap_x, close_x), enters(gap_y, close_y));
    let by_x = if enter_x.is_infinite() && enter_y.is_infinite() { gap_x >= gap_y } else { enter_x >= enter_y };
    ContactKind { axis: usize::from(!by_x), live: enter_x <= 1.0 && enter_y <= 1.0, level: false }
}

/// Which impacts bounce: those that leave faster than `rest_speed`, m/s, unless they are elastic, and come back after the step of `dt` s.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Bounces {
    pub dt: f64,
    pub rest_speed: f64,
}

impl Bounces {
    /// The speed with which an impact leaves, m/s; `pull` is what pulls it back, m/s².
    fn leaves(self, restitution: f64, speed: f64, pull: f64) -> f64 {
        let leaves = restitution * speed;
        let lasts = leaves > SLOWEST && 2.0 * leaves > pull * self.dt;
        if lasts && (restitution == 1.0 || leaves >= self.rest_speed) { leaves } else { 0.0 }
    }

    pub fn of(self, bodies: &Bodies, contact: &CrowdContact, axis: usize) -> Option<f64> {
        let (i, j) = (contact.first as usize, contact.second as usize);
        let restitution = bodies.coefficients(i.min(j), i.max(j)).restitution;
        let (speed, pull) = self.closing([&bodies[i], &bodies[j]], axis, false);
        (self.leaves(restitution, speed, pull) > 0.0).then_some(restitution)
    }

    /// The speed with which a pair closes as it touches, m/s, and the pull between them, m/s². A second one that `rests` does not fall along.
    pub fn closing(self, [a, b]: [&Member; 2], axis: usize, rests: bool) -> (f64, f64) {
        let side = if b.from[axis] < a.from[axis] { -1.0 } else { 1.0 };
        let gap = ((b.from - a.from).abs() - a.half - b.half)[axis].max(0.0);
        let gained = (a.free - a.before)[axis] - if rests { 0.0 } else { (b.free - b.before)[axis] };
        let (closing, pull) = ((a.before - b.before)[axis] * side, gained * side / self.dt);
        ((closing * closing.abs() + 2.0 * pull * gap).max(0.0).sqrt(), pull)
    }

    /// The velocity along gravity, m/s, with which a body leaves an impact that ends its `way` (m) with the velocity `end`.
    pub fn rebound(self, body: &Member, way: f64, end: f64, restitution: f64) -> f64 {
        let (before, free) = (body.before.y, body.free.y);
        let side = if free < end { -1.0 } else { 1.0 };
        let (closing, pull) = ((before - end) * side, (free - before) / self.dt * side);
        let square = closing * closing.abs() + 2.0 * pull * (way - end * self.dt) * side;
        end - side * self.leaves(restitution, square.max(0.0).sqrt(), pull)
    }
}
