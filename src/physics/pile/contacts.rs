//! Which pairs are contacts in this step, along which axis, and how fast they may close: the narrow phase.
//!
//! A pair keeps the axis along which it is apart at the start of the step; if it is apart along both, the one that it enters
//! later. Along that axis it must still be apart, on the same side, at the end: so nothing passes through anything at any speed,
//! and standing still always satisfies every pair. Speculative contact: the approach may not exceed gap/dt.
//! Two boxes on a flush wall touch a third only at its corner: an entry of less than [`CATCH`] is none, so that seams do not
//! catch.

use super::bodies::Bodies;
use super::neighbours::Neighbours;

/// Gaps within this many metres of zero are touching. Larger: visible gaps; smaller: rounding turns contacts into overlaps.
pub(super) const TOUCH: f64 = 1e-9;
/// How far a pair must enter across the contact's axis before a corner counts as hit, m. Smaller: seams of a floor of boxes
/// catch what slides over them; larger: what lands on a corner by less slips off.
const CATCH: f64 = 1e-4;
/// How much further than predicted a body may get before its contacts are sought anew: m, and across that and so many times the
/// mean way across. Larger: more contacts to look at; smaller: more steps in which a hit asks for a second look.
const MARGIN: f64 = 1e-2;
const MEAN_WAYS: f64 = 2.0;

/// Contacts a body of either kind for which there is room from the start. Fewer: a rare step allocates.
const ROOM: usize = 4;

/// The upper body stands over `below`, which has a lower number or is a surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stack {
    pub below: u32,
    /// Whether it may act on velocities; if not, it only keeps the positions apart.
    pub live: bool,
    /// The fastest approach, m/s: gap/dt.
    pub bound: f64,
    /// Distance of the centres when touching, m.
    pub reach: f64,
}

/// Two boxes side by side, or a body under a ceiling: the first has the smaller coordinate (for a ceiling: is the ceiling).
#[derive(Clone, Copy, Debug)]
pub(super) struct Side {
    pub first: u32,
    pub second: u32,
    pub live: bool,
    pub bound: f64,
    pub reach: f64,
}

/// The contacts of one step.
#[derive(Clone, Debug, Default)]
pub(super) struct Contacts {
    /// Supports of body i: `stacks[start[i]..start[i + 1]]`.
    pub start: Vec<u32>,
    pub stacks: Vec<Stack>,
    /// Pairs apart along x.
    pub sides: Vec<Side>,
    /// Surfaces above bodies.
    pub ceilings: Vec<Side>,
    /// What each body sweeps, and surfaces fill: left, right, top, bottom; and the margin across, m.
    pub(super) swept: Vec<[f64; 4]>,
    pad: f64,
}

/// What a pair is to the step, and whether it may act on velocities.
enum Kind {
    Stack(bool),
    Inverted(bool),
    Side(bool),
}

/// A pair that may touch.
pub(super) enum Meeting {
    /// The first stands on the second.
    Stack(Stack),
    Side(Side),
    Ceiling(Side),
    /// The second body stands on the first, which has the lower number.
    Inverted,
}

impl Contacts {
    /// Room for what `count` bodies usually touch.
    pub fn new(count: usize) -> Self {
        let (stacks, sides) = (Vec::with_capacity(ROOM * count), Vec::with_capacity(ROOM * count));
        Self { start: Vec::with_capacity(count + 1), stacks, sides, ..Self::default() }
    }

    /// Finds all contacts among the neighbours. Returns false if two bodies changed their order along gravity, so that they must
    /// be renumbered first.
    pub fn find(&mut self, bodies: &Bodies, neighbours: &Neighbours, dt: f64) -> bool {
        self.clear();
        let per_second = 1.0 / dt;
        for i in 0..bodies.len() {
            self.start.push(self.stacks.len() as u32);
            let mine = self.swept[i];
            for j in neighbours.of(i) {
                if apart(&mine, &self.swept[j]) {
                    continue;
                }
                match meeting(bodies, i, j, dt, per_second) {
                    Meeting::Stack(stack) => self.stacks.push(stack),
                    Meeting::Side(side) => self.sides.push(side),
                    Meeting::Ceiling(ceiling) => self.ceilings.push(ceiling),
                    Meeting::Inverted => return false,
                }
            }
        }
        self.start.push(self.stacks.len() as u32);
        true
    }

    /// Nothing touches anything.
    pub fn clear(&mut self) {
        self.start.clear();
        self.stacks.clear();
        self.sides.clear();
        self.ceilings.clear();
    }

    /// The supports of a body, by their numbers among the stacks; only after contacts were sought.
    pub fn under(&self, i: usize) -> std::ops::Range<usize> {
        self.start[i] as usize..self.start[i + 1] as usize
    }

    /// Sets the boxes that the bodies sweep from where they are to where they are predicted, and a margin.
    pub fn sweep(&mut self, bodies: &Bodies) {
        let all = bodies.x.len();
        self.swept.resize(all, [0.0; 4]);
        let (x, px, hx) = (&bodies.x[..all], &bodies.px[..all], &bodies.hx[..all]);
        let (y, py, hy) = (&bodies.y[..all], &bodies.py[..all], &bodies.hy[..all]);
        let mean = x.iter().zip(px).map(|(x, px)| (x - px).abs()).sum::<f64>() / bodies.len() as f64;
        self.pad = MARGIN + MEAN_WAYS * mean;
        for (i, swept) in self.swept.iter_mut().enumerate() {
            let (left, right) = if x[i] < px[i] { (x[i], px[i]) } else { (px[i], x[i]) };
            let (top, bottom) = if y[i] < py[i] { (y[i], py[i]) } else { (py[i], y[i]) };
            *swept = [left - hx[i] - self.pad, right + hx[i] + self.pad, top - hy[i] - MARGIN, bottom + hy[i] + MARGIN];
        }
    }

    /// Widens what a body sweeps to where it is predicted now.
    pub fn widen(&mut self, bodies: &Bodies, i: usize) {
        let (x, y) = (bodies.px[i], bodies.py[i]);
        let (wide, high) = (bodies.hx[i] + self.pad, bodies.hy[i] + MARGIN);
        let s = &mut self.swept[i];
        *s = [s[0].min(x - wide), s[1].max(x + wide), s[2].min(y - high), s[3].max(y + high)];
    }

    /// Whether the predicted box of a body lies within what was swept when the contacts were sought, and within that in which its
    /// neighbours were: the margin of the sweep grows with the mean way of all, and with a few very fast bodies reaches beyond.
    pub fn covers(&self, bodies: &Bodies, i: usize) -> bool {
        let s = &self.swept[i];
        let (x, y, hx, hy) = (bodies.px[i], bodies.py[i], bodies.hx[i], bodies.hy[i]);
        (x - hx >= s[0]) & (x + hx <= s[1]) & (y - hy >= s[2]) & (y + hy <= s[3]) & bodies.is_allowed(i)
    }
}

/// Whether two boxes do not touch.
pub(super) fn apart(a: &[f64; 4], b: &[f64; 4]) -> bool {
    (a[0] > b[1]) | (b[0] > a[1]) | (a[2] > b[3]) | (b[2] > a[3])
}

/// What body i and body or surface j are to each other; a body j has the lower number. `per_second` is 1/dt.
#[inline(always)]
pub(super) fn meeting(bodies: &Bodies, i: usize, j: usize, dt: f64, per_second: f64) -> Meeting {
    let (dx, dy) = (bodies.x[j] - bodies.x[i], bodies.y[j] - bodies.y[i]);
    let (reach_x, reach_y) = (bodies.hx[i] + bodies.hx[j], bodies.hy[i] + bodies.hy[j]);
    let (gap_x, gap_y) = (dx.abs() - reach_x, dy.abs() - reach_y);
    let bound = |gap: f64| if gap > TOUCH { gap * per_second } else { 0.0 };
    match kind(bodies, i, j, [dx, dy], [gap_x, gap_y], dt) {
        Kind::Stack(live) => Meeting::Stack(Stack { below: j as u32, live, bound: bound(gap_y), reach: reach_y }),
        Kind::Inverted(_) if j < bodies.len() => Meeting::Inverted,
        Kind::Inverted(live) => {
            Meeting::Ceiling(Side { first: j as u32, second: i as u32, live, bound: bound(gap_y), reach: reach_y })
        }
        Kind::Side(live) => {
            let (first, second) = if dx > 0.0 { (i as u32, j as u32) } else { (j as u32, i as u32) };
            Meeting::Side(Side { first, second, live, bound: bound(gap_x), reach: reach_x })
        }
    }
}

#[inline(always)]
fn kind(bodies: &Bodies, i: usize, j: usize, [dx, dy]: [f64; 2], [gap_x, gap_y]: [f64; 2], dt: f64) -> Kind {
    let stack = |live| if dy >= 0.0 { Kind::Stack(live) } else { Kind::Inverted(live) };
    // Most pairs rest on each other or stand side by side.
    if gap_x < -TOUCH && gap_y < TOUCH {
        return if gap_y < -TOUCH && gap_x > gap_y { Kind::Side(true) } else { stack(true) };
    }
    if gap_y < -CATCH && gap_x < TOUCH {
        return Kind::Side(true);
    }
    // How far they close along each axis within the step.
    let close_x = (bodies.free_vx[i] - bodies.free_vx[j]) * dt * dx.signum();
    let close_y = (bodies.free_vy[i] - bodies.free_vy[j]) * dt * dy.signum();
    if gap_x < -CATCH {
        // Over each other and apart: passes only if it has left sideways before it arrives.
        let leaves = gap_y < close_y && gap_x - close_x * (gap_y / close_y) > 0.0;
        return stack(!leaves);
    }
    if gap_y < -CATCH {
        let leaves = gap_x < close_x && gap_y - close_y * (gap_x / close_x) > 0.0;
        return Kind::Side(!leaves);
    }
    // Apart along both, or at a corner: the later entry decides.
    let enters = |gap: f64, close: f64, over: f64| if close > 0.0 { (gap + over) / close } else { f64::INFINITY };
    let (enter_x, enter_y) = (enters(gap_x, close_x, CATCH), enters(gap_y, close_y, CATCH));
    let by_x = if enter_x.is_infinite() && enter_y.is_infinite() { gap_x >= gap_y } else { enter_x >= enter_y };
    if by_x { Kind::Side(enter_x <= 1.0 && enter_y <= 1.0) } else { stack(enter_x <= 1.0 && enter_y <= 1.0) }
}
