//! What all liquids together do to a body, in closed form around where it is.
//!
//! A kink is a place where a side of the body passes a side of a liquid. Between kinks the width and the height of the body within a liquid
//! are linear in x and y, so that the area that it displaces of each, Σ w·h, and by it all buoyancy and drag, is bilinear, however many
//! liquids there are. Only the waves of those whose surface cuts the body are told one by one. A [`Regime`] holds these forms with the
//! box of places in which they are the law; a little beyond it they go on smoothly, which is what integrators want.

use super::air::Drag;
use super::impact_time::{Cubic, earliest};
use super::media::{Law, Media};
use super::{Body, FluidDef};
use glam::{BVec2, DVec2};

/// Stokes' law: 3π per diameter.
pub(super) const STOKES: f64 = 3.0 * std::f64::consts::PI;
/// Damping ratio of what floats at its waterline, per unit of C_d. Smaller: 300 kg on water are not at rest after a minute; larger: a
/// splash calms down within one bob.
pub(super) const WAVES: f64 = 0.15;
/// Relative: what rounding leaves of a balance of forces. Smaller: what floats never comes to rest; larger: it rests beside its waterline.
const BALANCE: f64 = 4e-14;
/// m, and relative to the coordinates: how far beyond a kink a regime goes on, so that what is led there is beyond it, however that is
/// rounded. Larger: its forces are off by as much of the body's height; smaller: rounding leaves it before the kink.
const SLIVER: f64 = 1e-12;
const SLIVER_OF_A_PLACE: f64 = 16.0 * f64::EPSILON;
/// m. What is so near beyond a kink has just met it: its forces are off by as much of the body's height, for as long as that takes.
const AT_A_KINK: f64 = 1e-9;
/// Surfaces that cut a body and are kept with a regime. More: it takes longer to set up; fewer: all liquids are asked more often.
const MOST_CUTS: usize = 6;

/// Work of a regime, of each liquid of it, and of a bath.
const WORK_OF_A_REGIME: u64 = 25;
const WORK_OF_A_LIQUID: u64 = 8;
const WORK_OF_A_BATH: u64 = 8;

/// How the acceleration by the media answers to small changes of a state: what an implicit step needs.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Stiffness {
    /// −∂a/∂v along either axis, 1/s, ≥ 0.
    pub drag: DVec2,
    /// −∂a_y/∂y by buoyancy, 1/s², ≥ 0.
    pub lift: f64,
}

/// What all media together do to a body at a place, per mass.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Bath {
    /// The fraction of the body that is inside liquids.
    pub fraction: f64,
    pub drag: Drag,
    /// Stokes' drag, 1/s.
    pub linear: f64,
    /// Damping by waves, up and down, 1/s.
    pub waves: f64,
    /// Buoyancy upwards, m/s².
    pub lift: f64,
    /// K/m, 1/s².
    pub stiffness: f64,
}

impl Bath {
    /// Acceleration at velocity `v` if no medium did more than this and `constant` did the rest, m/s².
    #[inline]
    pub fn acceleration(&self, constant: DVec2, v: DVec2) -> DVec2 {
        let drag = self.drag.rate(v) + self.linear;
        DVec2::new(constant.x - v.x * drag, (constant.y - self.lift) - v.y * (drag + self.waves))
    }

    /// Its linearisation at velocity `v`.
    pub fn answer(&self, v: DVec2) -> Stiffness {
        Stiffness { drag: self.drag.stiffness(v) + self.linear + DVec2::new(0.0, self.waves), lift: self.stiffness }
    }

    /// m/s²: what is left of a balance along the vertical at `y` if it is nothing but rounding.
    pub fn rounding(&self, constant: DVec2, body: &Body, y: f64) -> f64 {
        BALANCE * (constant.y.abs() + self.lift.abs() + self.stiffness * (y.abs() + body.half.y))
    }
}

/// How far a body is inside a liquid along both axes, m, and how that changes with its place.
#[derive(Clone, Copy, Debug, Default)]
struct Extent {
    length: DVec2,
    slope: DVec2,
}

/// What the sides of a body and of a liquid say of each other.
struct Sides {
    extent: Extent,
    /// Whether its left and top side, and its right and bottom side, are outside.
    before: BVec2,
    beyond: BVec2,
}

impl Sides {
    #[inline]
    fn of(body: &Body, fluid: &FluidDef, x: DVec2) -> Self {
        let (zone, top_left, bottom_right) = (&fluid.zone, x - body.half, x + body.half);
        let (before, beyond) = (top_left.cmplt(zone.min), bottom_right.cmpgt(zone.max));
        let as_number = |side: BVec2| DVec2::select(side, DVec2::ONE, DVec2::ZERO);
        let length = bottom_right.min(zone.max) - top_left.max(zone.min);
        Self { extent: Extent { length, slope: as_number(before) - as_number(beyond) }, before, beyond }
    }

    fn touch(&self) -> bool {
        self.extent.length.x > 0.0 && self.extent.length.y > 0.0
    }

    /// Whether the surface, the side that buoyancy points to, cuts the body; and whether the other side does.
    fn cut(&self, down: bool) -> (bool, bool) {
        if down { (self.before.y, self.beyond.y) } else { (self.beyond.y, self.before.y) }
    }
}

/// a + b·x + c·y + d·x·y.
#[derive(Clone, Copy, Debug, Default)]
struct Bilinear([f64; 4]);

impl Bilinear {
    /// Adds an area within a liquid, `factor` times.
    #[inline]
    fn add(&mut self, factor: f64, Extent { length, slope }: &Extent) {
        let (wide, wider) = (factor * length.x, factor * slope.x);
        let more = [wide * length.y, wider * length.y, wide * slope.y, wider * slope.y];
        self.0.iter_mut().zip(more).for_each(|(sum, more)| *sum += more);
    }

    /// Beyond a box of places it could say that less than nothing is inside.
    #[inline]
    fn at(&self, apart: DVec2) -> f64 {
        let [a, b, c, d] = self.0;
        ((a + b * apart.x) + (c + d * apart.x) * apart.y).max(0.0)
    }
}

/// A surface that cuts the body.
#[derive(Clone, Copy, Debug, Default)]
struct Cut {
    /// Density of its liquid, per mass of the body.
    density: f64,
    extent: Extent,
    /// How much of the body's height is above it, m, and how that changes with y.
    emerged: f64,
    rises: f64,
    /// Whether the body is nowhere below its liquid.
    sunk: bool,
}

impl Cut {
    #[inline]
    fn of(body: &Body, fluid: &FluidDef, x: DVec2, sides: &Sides, down: bool) -> Option<Self> {
        let (cut, leaves) = sides.cut(down);
        (cut && sides.touch()).then(|| {
            let (top, bottom) = (x.y - body.half.y, x.y + body.half.y);
            let emerged = if down { fluid.zone.min.y - top } else { bottom - fluid.zone.max.y };
            let rises = if down { -1.0 } else { 1.0 };
            Self { density: fluid.density / body.mass, extent: sides.extent, emerged, rises, sunk: !leaves }
        })
    }

    /// The damping of its waves per C_d, 1/s, and K/m, 1/s².
    #[inline]
    fn at(&self, apart: DVec2, gravity: f64, height: f64) -> (f64, f64) {
        let inside = (self.extent.length + self.extent.slope * apart).max(DVec2::ZERO);
        let stiffness = self.density * gravity * inside.x;
        let ratio = self.density * inside.x * inside.y;
        let under = (1.0 - (self.emerged + self.rises * apart.y) / height).clamp(0.0, 1.0);
        let fourth = (under * under) * (under * under);
        let fades = 1.0 - fourth * fourth;
        (2.0 * WAVES * stiffness.sqrt() * (2.0 * ratio / (1.0 + ratio)) * fades, if self.sunk { stiffness } else { 0.0 })
    }
}

/// What media do to a body around a place.
#[derive(Clone, Debug)]
pub(super) struct Regime<'a> {
    media: &'a Media,
    body: &'a Body,
    law: &'a Law,
    centre: DVec2,
    /// Where it holds, m: between kinks.
    low: DVec2,
    high: DVec2,
    /// The areas inside all liquids, m², their masses, kg/m, and the same with viscosities, by the distance from the centre.
    area: Bilinear,
    mass: Bilinear,
    thick: Bilinear,
    cuts: [Cut; MOST_CUTS],
    count: usize,
    /// Whether some of the body is out of a liquid beyond the side opposite to its surface.
    leaves: bool,
    /// Quadratic drag, Stokes' drag and buoyancy of what is displaced, each per kg/m or Pa·s·m².
    drag: Drag,
    stokes: f64,
    lift: f64,
    per_area: f64,
}

impl<'a> Regime<'a> {
    /// Around `x`.
    pub fn new(media: &'a Media, body: &'a Body, law: &'a Law, x: DVec2) -> Self {
        media.spend(WORK_OF_A_REGIME + WORK_OF_A_LIQUID * u64::from(law.liquids.len()));
        let (half, per_mass) = (body.half, 1.0 / body.mass);
        let per_area = 1.0 / (4.0 * half.x * half.y);
        let (low, high) = (DVec2::NEG_INFINITY, DVec2::INFINITY);
        let empty = Bilinear::default();
        let (drag, stokes) = (Drag::of(body, per_area), STOKES * (half.x + half.y) * per_mass * per_area);
        let (cuts, count, lift) = ([Cut::default(); MOST_CUTS], 0, media.gravity * per_mass);
        let (area, mass, thick) = (empty, empty, empty);
        let mut all = Self {
            media,
            body,
            law,
            centre: x,
            low,
            high,
            area,
            mass,
            thick,
            cuts,
            count,
            leaves: false,
            drag,
            stokes,
            lift,
            per_area,
        };
        media.liquids(law).for_each(|(_, fluid)| all.add(fluid));
        all
    }

    #[inline]
    fn add(&mut self, fluid: &FluidDef) {
        let (x, half, zone) = (self.centre, self.body.half, &fluid.zone);
        let sides = Sides::of(self.body, fluid, x);
        // Where it begins to touch, and where it ends.
        let (first, last) = (zone.min - half, zone.max + half);
        if !sides.touch() {
            // It stays apart along the axis along which it is further away.
            let apart = (first - x).max(x - last);
            let axis = usize::from(apart.y > apart.x);
            if x[axis] <= first[axis] {
                self.high[axis] = self.high[axis].min(first[axis]);
            } else {
                self.low[axis] = self.low[axis].max(last[axis]);
            }
            return;
        }
        let (in_front, behind) = (zone.min + half, zone.max - half);
        let low = DVec2::select(sides.before, first, in_front).max(DVec2::select(sides.beyond, behind, first));
        let high = DVec2::select(sides.before, in_front, last).min(DVec2::select(sides.beyond, last, behind));
        (self.low, self.high) = (self.low.max(low), self.high.min(high));
        self.area.add(1.0, &sides.extent);
        self.mass.add(fluid.density, &sides.extent);
        self.thick.add(fluid.viscosity, &sides.extent);
        let down = self.media.gravity >= 0.0;
        self.leaves |= sides.cut(down).1;
        if let Some(cut) = Cut::of(self.body, fluid, x, &sides, down) {
            if self.count < MOST_CUTS {
                self.cuts[self.count] = cut;
            }
            self.count += 1;
        }
    }

    /// What media do at `x`.
    #[inline]
    pub fn bath(&self, x: DVec2) -> Bath {
        self.media.spend(WORK_OF_A_BATH);
        let apart = x - self.centre;
        let (fraction, mass) = (self.area.at(apart) * self.per_area, self.mass.at(apart));
        let mut drag = self.drag.scaled(mass);
        if !self.law.air.is_none() {
            drag = drag.plus(&self.law.air.scaled((1.0 - fraction).max(0.0)));
        }
        let (waves, stiffness) = if self.count > 0 { self.surfaces(apart) } else { (0.0, 0.0) };
        Bath { fraction, drag, linear: self.stokes * self.thick.at(apart), waves, lift: self.lift * mass, stiffness }
    }

    /// The damping by waves and K/m by all surfaces that cut the body.
    fn surfaces(&self, apart: DVec2) -> (f64, f64) {
        let (gravity, height) = (self.media.gravity.abs(), 2.0 * self.body.half.y);
        let add = |sum: (f64, f64), cut: &Cut| {
            let (waves, stiffness) = cut.at(apart, gravity, height);
            (sum.0 + self.body.drag * waves, sum.1 + stiffness)
        };
        if self.count <= MOST_CUTS {
            return self.cuts[..self.count].iter().fold((0.0, 0.0), add);
        }
        self.media.spend(WORK_OF_A_LIQUID * u64::from(self.law.liquids.len()));
        let down = self.media.gravity >= 0.0;
        let cuts = self
            .media
            .liquids(self.law)
            .filter_map(|(_, fluid)| Cut::of(self.body, fluid, self.centre, &Sides::of(self.body, fluid, self.centre), down));
        cuts.fold((0.0, 0.0), |sum, cut| add(sum, &cut))
    }

    /// Acceleration at `x` with velocity `v`, m/s².
    pub fn acceleration(&self, x: DVec2, v: DVec2) -> DVec2 {
        let bath = self.bath(x);
        let mut a = bath.acceleration(self.law.constant, v);
        if v.y == 0.0 && self.balances(&bath, x, a.y) {
            a.y = 0.0;
        }
        a
    }

    /// Whether the vertical forces on what has no vertical velocity, `left_over` by their sum (m/s²), balance but for rounding.
    pub fn balances(&self, bath: &Bath, x: DVec2, left_over: f64) -> bool {
        bath.fraction > 0.0 && left_over.abs() <= bath.rounding(self.law.constant, self.body, x.y)
    }

    /// The one around `x`.
    #[inline]
    pub fn follow(&mut self, x: DVec2) -> &Self {
        if !self.holds(x) {
            *self = Self::new(self.media, self.body, self.law, x);
        }
        self
    }

    /// Whether buoyancy is linear in the depth with K/m, and the same a little to each side.
    pub fn is_spring(&self) -> bool {
        !self.leaves && [self.area, self.mass, self.thick].iter().all(|Bilinear([_, b, _, d])| (*b, *d) == (0.0, 0.0))
    }

    /// And everywhere around.
    pub fn is_same_around(&self) -> bool {
        self.count == 0 && [self.area, self.mass, self.thick].iter().all(|form| form.0[1..] == [0.0; 3])
    }

    fn sliver(&self) -> f64 {
        SLIVER + SLIVER_OF_A_PLACE * (self.centre.abs() + self.body.half).max_element()
    }

    /// Whether it holds at `x`, or within `margin` of where it does.
    fn holds_within(&self, x: DVec2, margin: f64) -> bool {
        x.cmpge(self.low - margin).all() && x.cmple(self.high + margin).all()
    }

    /// Whether it holds at `x`.
    pub fn holds(&self, x: DVec2) -> bool {
        self.holds_within(x, 0.5 * self.sliver())
    }

    /// Whether it holds wherever something gets that starts at `x` and moves by no more than `way` along either axis.
    pub fn holds_around(&self, x: DVec2, way: DVec2) -> bool {
        self.holds_within(x - way, 0.0) && self.holds_within(x + way, 0.0)
    }

    /// Whether it holds at `x`, or ends so near that it does not matter.
    pub fn all_but_holds(&self, x: DVec2) -> bool {
        self.holds_within(x, AT_A_KINK + self.sliver())
    }

    /// When a way leaves it within `h` seconds, if it does.
    pub fn end_of(&self, way: &Cubic, h: f64) -> Option<f64> {
        let sliver = self.sliver();
        let end = |axis: usize| {
            let (path, low, high) = (way.axis(axis), self.low[axis] - sliver, self.high[axis] + sliver);
            let (least, most) = path.bounds(h);
            let falls = if least < low { path.falls_through(low, 0.0, h) } else { None };
            let rises = if most > high { path.rises_through(high, 0.0, h) } else { None };
            earliest(falls, rises)
        };
        earliest(end(0), end(1))
    }
}
