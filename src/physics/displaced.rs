//! What a body displaces of all liquids, in closed form around where it is.
//!
//! A kink is a place where a side of the body passes a side of a liquid. Between kinks the width and the height of the body within a liquid
//! are linear in x and y, so that the areas that it displaces, and by them all buoyancy and drag, are bilinear, however many liquids
//! there are. Only the waves of those whose surface cuts the body are told one by one. [`Displaced`] holds these forms with the box of
//! places in which they are the law; a little beyond it they go on smoothly, which is what integrators want.

use super::bath::WAVES;
use super::impact_time::{Cubic, earliest};
use super::media::Media;
use super::zone_tree::ZoneList;
use super::{Aabb, Body, FluidDef};
use glam::{BVec2, DVec2};

/// m, and relative to the coordinates: how far beyond a kink a regime goes on, so that what is led there is beyond it, however that is
/// rounded. Larger: its forces are off by as much of the body's height; smaller: rounding leaves it before the kink.
const SLIVER: f64 = 1e-12;
const SLIVER_OF_A_PLACE: f64 = 16.0 * f64::EPSILON;
/// m. What is so near beyond a kink has just met it: its forces are off by as much of the body's height, for as long as that takes.
const AT_A_KINK: f64 = 1e-11;
/// Surfaces that cut a body and are kept with a regime. More: it takes longer to set up; fewer: all liquids are asked more often.
const MOST_CUTS: usize = 6;

/// Work of finding it, of each liquid for that.
const WORK: u64 = 25;
const WORK_OF_A_LIQUID: u64 = 8;

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

/// The forms, around a place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Displaced {
    centre: DVec2,
    /// Where they hold, m: between kinks.
    low: DVec2,
    high: DVec2,
    sliver: DVec2,
    /// The areas inside all liquids, m², their masses, kg/m, and the same with viscosities, by the distance from the centre.
    area: Bilinear,
    mass: Bilinear,
    thick: Bilinear,
    cuts: [Cut; MOST_CUTS],
    count: usize,
    /// Whether some of the body is out of a liquid beyond the side opposite to its surface.
    leaves: bool,
}

impl Default for Displaced {
    /// Forms that hold nowhere.
    fn default() -> Self {
        let (low, high, none) = (DVec2::INFINITY, DVec2::NEG_INFINITY, Bilinear::default());
        let (area, mass, thick) = (none, none, none);
        let (cuts, count, leaves) = ([Cut::default(); MOST_CUTS], 0, false);
        Self { centre: DVec2::ZERO, low, high, sliver: DVec2::ZERO, area, mass, thick, cuts, count, leaves }
    }
}

impl Displaced {
    /// By `body` at `x`, of these `liquids`: all that touch the box `near`.
    pub fn new(media: &Media, body: &Body, x: DVec2, (liquids, near): (&ZoneList, &Aabb)) -> Self {
        media.spend(WORK + WORK_OF_A_LIQUID * u64::from(liquids.len()));
        let sliver = SLIVER + SLIVER_OF_A_PLACE * (x.abs() + body.half);
        let (low, high) = (near.min + body.half, near.max - body.half);
        let mut all = Self { centre: x, low, high, sliver, ..Self::default() };
        let down = media.gravity >= 0.0;
        liquids.iter().for_each(|index| all.add(body, &media.fluids[index as usize], down));
        all
    }

    #[inline]
    fn add(&mut self, body: &Body, fluid: &FluidDef, down: bool) {
        let (x, half, zone) = (self.centre, body.half, &fluid.zone);
        let sides = Sides::of(body, fluid, x);
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
        self.leaves |= sides.cut(down).1;
        if let Some(cut) = Cut::of(body, fluid, x, &sides, down) {
            if self.count < MOST_CUTS {
                self.cuts[self.count] = cut;
            }
            self.count += 1;
        }
    }

    /// The areas inside all liquids at `x`, m², their masses, kg/m, and the same with viscosities.
    #[inline]
    pub fn at(&self, x: DVec2) -> (f64, f64, f64) {
        let apart = x - self.centre;
        (self.area.at(apart), self.mass.at(apart), self.thick.at(apart))
    }

    /// The damping by waves per C_d, 1/s, and K/m, 1/s², of all surfaces that cut the body at `x`.
    #[inline]
    pub fn surfaces(&self, media: &Media, body: &Body, x: DVec2, liquids: &ZoneList) -> (f64, f64) {
        if self.count == 0 {
            return (0.0, 0.0);
        }
        let (gravity, height, apart) = (media.gravity.abs(), 2.0 * body.half.y, x - self.centre);
        let add = |sum: (f64, f64), cut: &Cut| {
            let (waves, stiffness) = cut.at(apart, gravity, height);
            (sum.0 + waves, sum.1 + stiffness)
        };
        if self.count <= MOST_CUTS {
            return self.cuts[..self.count].iter().fold((0.0, 0.0), add);
        }
        media.spend(WORK_OF_A_LIQUID * u64::from(liquids.len()));
        let cuts = liquids.iter().filter_map(|index| {
            let fluid = &media.fluids[index as usize];
            Cut::of(body, fluid, self.centre, &Sides::of(body, fluid, self.centre), media.gravity >= 0.0)
        });
        cuts.fold((0.0, 0.0), |sum, cut| add(sum, &cut))
    }

    fn forms(&self) -> [Bilinear; 3] {
        [self.area, self.mass, self.thick]
    }

    /// Whether buoyancy is linear in the depth with K/m, and the same a little to each side.
    pub fn is_spring(&self) -> bool {
        !self.leaves && self.forms().iter().all(|Bilinear([_, b, _, d])| (*b, *d) == (0.0, 0.0))
    }

    /// And everywhere around.
    pub fn is_same_around(&self) -> bool {
        self.count == 0 && self.forms().iter().all(|form| form.0[1..] == [0.0; 3])
    }

    /// Whether it holds at `x`, or within `margin` of where it does.
    fn holds_within(&self, x: DVec2, margin: DVec2) -> bool {
        x.cmpge(self.low - margin).all() && x.cmple(self.high + margin).all()
    }

    /// Whether it holds at `x`.
    pub fn holds(&self, x: DVec2) -> bool {
        self.holds_within(x, 0.5 * self.sliver)
    }

    /// Whether it holds wherever something gets that starts at `x` and moves by no more than `way` along either axis.
    pub fn holds_around(&self, x: DVec2, way: DVec2) -> bool {
        self.holds_within(x - way, DVec2::ZERO) && self.holds_within(x + way, DVec2::ZERO)
    }

    /// Whether it holds at `x`, or ends so near that it does not matter.
    pub fn all_but_holds(&self, x: DVec2) -> bool {
        self.holds_within(x, AT_A_KINK + self.sliver)
    }

    /// When a way leaves it within `h` seconds, if it does.
    pub fn end_of(&self, way: &Cubic, h: f64) -> Option<f64> {
        let end = |axis: usize| {
            let (path, low, high) =
                (way.axis(axis).until(h), self.low[axis] - self.sliver[axis], self.high[axis] + self.sliver[axis]);
            let (least, most) = path.bounds;
            let falls = if least < low { path.falls_through(low, 0.0) } else { None };
            let rises = if most > high { path.rises_through(high, 0.0) } else { None };
            earliest(falls, rises)
        };
        earliest(end(0), end(1))
    }
}
