//! What a body displaces of all liquids, in closed form around where it is.
//!
//! A kink is a place where a side of the body passes a side of a liquid. Between kinks the width and the height of the body within a liquid
//! are linear in x and y, so that the areas that it displaces, and by them all buoyancy and drag, are bilinear, however many liquids
//! there are. The waves of each surface that cuts the body come besides. [`Displaced`] holds these forms with the box of
//! places in which they are the law; a little beyond it they go on smoothly, which is what integrators want.

use crate::physics::data::aabb::Aabb;
use crate::physics::data::body::Body;
use crate::physics::data::def::FluidDef;
use crate::physics::data::impact_time::{Cubic, earliest};
use crate::physics::forces::bath::WAVES;
use crate::physics::forces::media::Media;
use crate::physics::forces::zone_list::ZoneList;
use glam::{BVec2, DVec2};

/// m, and relative to the coordinates: how far beyond a kink a regime goes on, so that what is led there is beyond it, however that is
/// rounded. Larger: its forces are off by as much of the body's height; smaller: rounding leaves it before the kink.
const SLIVER: f64 = 1e-12;
const SLIVER_OF_A_PLACE: f64 = 16.0 * f64::EPSILON;
/// m. What is so near beyond a kink has just met it: its forces are off by as much of the body's height, for as long as that takes.
const AT_A_KINK: f64 = 1e-11;

/// How far a body is inside a liquid along both axes, m, and how that changes with its place.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Extent {
    pub length: DVec2,
    pub slope: DVec2,
}

/// What the sides of a body and of a liquid say of each other.
struct Sides {
    /// How far the body is inside, m.
    inside: DVec2,
    /// Whether its left and top side, and its right and bottom side, are outside.
    before: BVec2,
    beyond: BVec2,
}

impl Sides {
    #[inline]
    fn of(body: &Body, fluid: &FluidDef, x: DVec2) -> Self {
        let (zone, top_left, bottom_right) = (&fluid.zone, x - body.half, x + body.half);
        let inside = bottom_right.min(zone.max) - top_left.max(zone.min);
        Self { inside, before: top_left.cmplt(zone.min), beyond: bottom_right.cmpgt(zone.max) }
    }

    /// By the place `centre`, if the sides were on the same sides there.
    #[inline]
    fn extent(&self, body: &Body, fluid: &FluidDef, centre: DVec2) -> Extent {
        let as_number = |side: BVec2| DVec2::select(side, DVec2::ONE, DVec2::ZERO);
        let end = DVec2::select(self.beyond, fluid.zone.max, centre + body.half);
        let begin = DVec2::select(self.before, fluid.zone.min, centre - body.half);
        // Far from the centre a side that is not cut keeps its length.
        let length = DVec2::select(self.before | self.beyond, end - begin, body.half * 2.0);
        Extent { length, slope: as_number(self.before) - as_number(self.beyond) }
    }

    /// The centres of bodies with sides on the same sides.
    #[inline]
    fn places(&self, body: &Body, fluid: &FluidDef) -> (DVec2, DVec2) {
        let (zone, half) = (&fluid.zone, body.half);
        let (first, last, in_front, behind) = (zone.min - half, zone.max + half, zone.min + half, zone.max - half);
        let low = DVec2::select(self.before, first, in_front).max(DVec2::select(self.beyond, behind, first));
        let high = DVec2::select(self.before, in_front, last).min(DVec2::select(self.beyond, last, behind));
        (low, high)
    }

    fn touch(&self) -> bool {
        self.inside.x > 0.0 && self.inside.y > 0.0
    }

    /// Whether the surface, the side that buoyancy points to, cuts the body; and whether the other side does.
    fn cut(&self, down: bool) -> (bool, bool) {
        if down { (self.before.y, self.beyond.y) } else { (self.beyond.y, self.before.y) }
    }
}

/// a + b·x + c·y + d·x·y.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Bilinear([f64; 4]);

impl Bilinear {
    /// Adds an area within a liquid, `factor` times.
    #[inline]
    fn add(&mut self, factor: f64, Extent { length, slope }: &Extent) {
        let (wide, wider) = (factor * length.x, factor * slope.x);
        let more = [wide * length.y, wider * length.y, wide * slope.y, wider * slope.y];
        self.0.iter_mut().zip(more).for_each(|(sum, more)| *sum += more);
    }

    /// So many times a form.
    pub fn scaled(&self, factor: f64) -> Self {
        Self(self.0.map(|part| factor * part))
    }

    /// Beyond a box of places it could say that less than nothing is inside.
    #[inline]
    pub fn at(&self, apart: DVec2) -> f64 {
        let [a, b, c, d] = self.0;
        ((a + b * apart.x) + (c + d * apart.x) * apart.y).max(0.0)
    }

    /// How it changes with the place, where it is not cut off at 0.
    #[inline]
    pub fn slope(&self, apart: DVec2) -> DVec2 {
        let [_, b, c, d] = self.0;
        if self.at(apart) > 0.0 { DVec2::new(b + d * apart.y, c + d * apart.x) } else { DVec2::ZERO }
    }
}

/// A surface that cuts the body.
#[derive(Clone, Copy, Debug)]
struct Cut {
    /// Density of its liquid, per mass of the body; and times g.
    density: f64,
    pull: f64,
    extent: Extent,
    /// The part of the body's height that is below it, and how that changes with y, 1/m.
    under: f64,
    sinks: f64,
    /// Whether the body is nowhere below its liquid.
    sunk: bool,
}

impl Cut {
    #[inline]
    fn of(media: &Media, body: &Body, fluid: &FluidDef, centre: DVec2, sides: &Sides) -> Option<Self> {
        let down = media.gravity >= 0.0;
        let (cut, leaves) = sides.cut(down);
        (cut && sides.touch()).then(|| {
            let (top, bottom) = (centre.y - body.half.y, centre.y + body.half.y);
            let emerged = if down { fluid.zone.min.y - top } else { bottom - fluid.zone.max.y };
            let per_height = 0.5 / body.half.y;
            let sinks = if down { per_height } else { -per_height };
            let (density, extent) = (fluid.density / body.mass, sides.extent(body, fluid, centre));
            let pull = density * media.gravity.abs();
            Self { density, pull, extent, under: 1.0 - emerged * per_height, sinks, sunk: !leaves }
        })
    }

    #[inline]
    fn width(&self, apart: DVec2) -> f64 {
        (self.extent.length.x + self.extent.slope.x * apart.x).max(0.0)
    }

    /// The damping of its waves per C_d, 1/s.
    #[inline]
    fn waves(&self, apart: DVec2) -> f64 {
        let width = self.width(apart);
        let deep = (self.extent.length.y + self.extent.slope.y * apart.y).max(0.0);
        let ratio = self.density * width * deep;
        let under = (self.under + self.sinks * apart.y).clamp(0.0, 1.0);
        let fourth = (under * under) * (under * under);
        let swing = (self.pull * width).sqrt();
        (4.0 * WAVES * swing) * (ratio / (1.0 + ratio)) * (1.0 - fourth * fourth)
    }

    /// How the damping of its waves per C_d changes with the place, 1/(m·s).
    fn slope_of_waves(&self, apart: DVec2) -> DVec2 {
        let Extent { length, slope } = self.extent;
        let width = self.width(apart);
        let deep = (length.y + slope.y * apart.y).max(0.0);
        let under = (self.under + self.sinks * apart.y).clamp(0.0, 1.0);
        if width == 0.0 || deep == 0.0 || under == 0.0 || under == 1.0 {
            return DVec2::ZERO;
        }
        let ratio = self.density * width * deep;
        let (fourth, seventh) = (under.powi(4), under.powi(7));
        // Of its three factors, as parts of each.
        let by_ratio = DVec2::new(slope.x / width, slope.y / deep) / (1.0 + ratio);
        let by_swing = 0.5 * slope.x / width;
        let fading = -8.0 * seventh * self.sinks / (1.0 - fourth * fourth);
        self.waves(apart) * (by_ratio + DVec2::new(by_swing, fading))
    }

    /// K/m, 1/s².
    fn stiffness(&self, apart: DVec2) -> f64 {
        if self.sunk { self.pull * self.width(apart) } else { 0.0 }
    }
}

/// The forms, around a place.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Displaced {
    centre: DVec2,
    /// Where they were asked for, m.
    within: DVec2,
    /// Where they hold, m: between kinks.
    low: DVec2,
    high: DVec2,
    sliver: DVec2,
    /// The areas inside all liquids, m², their masses, kg/m, and the same with viscosities, by the distance from the centre.
    area: Bilinear,
    mass: Bilinear,
    thick: Bilinear,
    /// Whether the surface of a liquid cuts the body.
    is_cut: bool,
}

impl Default for Displaced {
    /// Forms that hold nowhere.
    fn default() -> Self {
        let (low, high, none) = (DVec2::INFINITY, DVec2::NEG_INFINITY, Bilinear::default());
        let (area, mass, thick) = (none, none, none);
        Self { centre: DVec2::ZERO, within: DVec2::ZERO, low, high, sliver: DVec2::ZERO, area, mass, thick, is_cut: false }
    }
}

impl Displaced {
    /// Makes them those of `body` at `x`, of these `liquids`: all that touch the box `near`.
    pub fn renew(&mut self, media: &Media, body: &Body, x: DVec2, (liquids, near): (&ZoneList, &Aabb)) {
        self.sliver = SLIVER + SLIVER_OF_A_PLACE * (x.abs() + body.half);
        (self.centre, self.within) = (x, x);
        (self.low, self.high) = (near.min + body.half, near.max - body.half);
        let none = Bilinear::default();
        (self.area, self.mass, self.thick) = (none, none, none);
        self.is_cut = false;
        // Around a corner of all places where they are the same, so that they are the same to the bit wherever in it they are asked for.
        let mut corner = DVec2::NEG_INFINITY;
        for index in liquids.iter() {
            let fluid = &media.fluids[index as usize];
            let sides = Sides::of(body, fluid, x);
            if sides.touch() {
                let (low, high) = sides.places(body, fluid);
                corner = corner.max(low);
                (self.low, self.high) = (self.low.max(low), self.high.min(high));
            } else {
                self.keep_from(body, fluid, x);
            }
        }
        if corner.is_finite() {
            self.centre = corner;
            liquids.iter().for_each(|index| self.add(media, body, &media.fluids[index as usize], x));
        }
    }

    /// They hold where the liquid is not met.
    fn keep_from(&mut self, body: &Body, fluid: &FluidDef, x: DVec2) {
        let (first, last) = (fluid.zone.min - body.half, fluid.zone.max + body.half);
        // It stays apart along the axis along which it is further away.
        let apart = (first - x).max(x - last);
        let axis = usize::from(apart.y > apart.x);
        if x[axis] <= first[axis] {
            self.high[axis] = self.high[axis].min(first[axis]);
        } else {
            self.low[axis] = self.low[axis].max(last[axis]);
        }
    }

    #[inline]
    fn add(&mut self, media: &Media, body: &Body, fluid: &FluidDef, x: DVec2) {
        let sides = Sides::of(body, fluid, x);
        if !sides.touch() {
            return;
        }
        let extent = sides.extent(body, fluid, self.centre);
        self.area.add(1.0, &extent);
        self.mass.add(fluid.density, &extent);
        self.thick.add(fluid.viscosity, &extent);
        self.is_cut |= sides.cut(media.gravity >= 0.0).0;
    }

    /// How far a place is from the one around which they are, m.
    #[inline]
    pub fn apart(&self, x: DVec2) -> DVec2 {
        x - self.centre
    }

    /// The areas inside all liquids, m², their masses, kg/m, and the same with viscosities, by the distance from there.
    pub fn inside(&self) -> (&Bilinear, &Bilinear, &Bilinear) {
        (&self.area, &self.mass, &self.thick)
    }

    /// The damping by waves per C_d, 1/s, of all surfaces that cut the body so far from there.
    #[inline]
    pub fn waves(&self, media: &Media, body: &Body, apart: DVec2, liquids: &ZoneList) -> f64 {
        self.cuts(media, body, liquids).fold(0.0, |sum, cut| sum + cut.waves(apart))
    }

    /// How that changes with the place, 1/(m·s).
    pub fn slope_of_waves(&self, media: &Media, body: &Body, apart: DVec2, liquids: &ZoneList) -> DVec2 {
        self.cuts(media, body, liquids).fold(DVec2::ZERO, |sum, cut| sum + cut.slope_of_waves(apart))
    }

    /// The sum of their K/m, 1/s².
    #[inline]
    pub fn stiffness(&self, media: &Media, body: &Body, apart: DVec2, liquids: &ZoneList) -> f64 {
        self.cuts(media, body, liquids).fold(0.0, |sum, cut| sum + cut.stiffness(apart))
    }

    /// The surfaces that cut the body.
    #[inline]
    fn cuts(&self, media: &Media, body: &Body, liquids: &ZoneList) -> impl Iterator<Item = Cut> {
        let near = if self.is_cut { *liquids } else { ZoneList::default() };
        near.iter().filter_map(move |index| {
            let fluid = &media.fluids[index as usize];
            Cut::of(media, body, fluid, self.centre, &Sides::of(body, fluid, self.within))
        })
    }

    fn forms(&self) -> [Bilinear; 3] {
        [self.area, self.mass, self.thick]
    }

    /// Whether the media are the same all around.
    pub fn is_same_around(&self) -> bool {
        !self.is_cut && self.forms().iter().all(|form| form.0[1..] == [0.0; 3])
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

    /// Whether it holds along a curve that begins where it does and whose Bézier points, the first left out, are these.
    #[inline]
    pub fn holds_along<const N: usize>(&self, points: [DVec2; N]) -> bool {
        points.iter().all(|point| self.holds_within(*point, DVec2::ZERO))
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
