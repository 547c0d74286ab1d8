//! The parts of all liquids that a body displaces. Between kinks, where a side of it passes one of a liquid, buoyancy and drag are bilinear in x, y;
//! waves of each surface that cuts it come besides. [`Displaced`] has these forms and the places in which they hold; beyond they go on smoothly.

use crate::physics::data::{Aabb, Body, Cubic, FluidDef, WAVES, earliest};
use crate::physics::forces::{media::Media, zones::ZoneList};
use glam::{BVec2, DVec2, DVec4};
use std::ops::{Add, AddAssign, Div, Mul, Sub};

/// Stokes' law: 3π per diameter.
pub(crate) const STOKES: f64 = 3.0 * std::f64::consts::PI;

#[derive(Clone, Copy, Debug)]
struct Extent {
    length: DVec2,
    slope: DVec2,
}

struct Outer {
    /// Whether its left and top side, and its right and bottom side, are outside.
    before: BVec2,
    beyond: BVec2,
}

impl Outer {
    fn of(body: &Body, fluid: &FluidDef, x: DVec2) -> Option<Self> {
        let (zone, bounds) = (&fluid.zone, Aabb::around(x, body.half));
        let sides = || Self { before: bounds.min.cmplt(zone.min), beyond: bounds.max.cmpgt(zone.max) };
        zone.overlaps(&bounds, 0.0).then(sides)
    }
    fn extent(&self, body: &Body, fluid: &FluidDef, centre: DVec2) -> Extent {
        let as_number = |side: BVec2| DVec2::select(side, DVec2::ONE, DVec2::ZERO);
        let end = DVec2::select(self.beyond, fluid.zone.max, centre + body.half);
        let begin = DVec2::select(self.before, fluid.zone.min, centre - body.half);
        // Far from the centre a side that is not cut keeps its length.
        let length = DVec2::select(self.before | self.beyond, end - begin, body.half * 2.0);
        Extent { length, slope: as_number(self.before) - as_number(self.beyond) }
    }
    fn places(&self, body: &Body, fluid: &FluidDef) -> (DVec2, DVec2) {
        let (zone, half) = (&fluid.zone, body.half);
        let (first, last, in_front, behind) = (zone.min - half, zone.max + half, zone.min + half, zone.max - half);
        let low = DVec2::select(self.before, first, in_front).max(DVec2::select(self.beyond, behind, first));
        let high = DVec2::select(self.before, in_front, last).min(DVec2::select(self.beyond, last, behind));
        (low, high)
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
    fn add(&mut self, factor: f64, Extent { length, slope }: &Extent) {
        let (wide, wider) = (factor * length.x, factor * slope.x);
        let more = [wide * length.y, wider * length.y, wide * slope.y, wider * slope.y];
        self.0.iter_mut().zip(more).for_each(|(sum, more)| *sum += more);
    }

    fn scaled(self, factor: f64) -> Self {
        Self(self.0.map(|part| factor * part))
    }
    pub fn at(&self, apart: DVec2) -> f64 {
        self.along(apart.x).at(apart.y)
    }
    pub fn along(&self, x: f64) -> LinearLaw {
        let [a, b, c, d] = self.0;
        LinearLaw(a + b * x, c + d * x)
    }
    pub fn slope(&self, apart: DVec2) -> DVec2 {
        let [_, b, c, d] = self.0;
        if self.at(apart) > 0.0 { DVec2::new(b + d * apart.y, c + d * apart.x) } else { DVec2::ZERO }
    }
}

/// A number, or one of each of four bodies, for laws that are the same to the bit for both.
pub(crate) trait Lanes:
    Copy + Add<Output = Self> + AddAssign + Sub<Output = Self> + Div<Output = Self> + Mul<Output = Self> + Mul<f64, Output = Self>
{
    fn all(of: f64) -> Self;
    fn with(self, other: Self, of: impl Fn(f64, f64) -> f64) -> Self;

    /// One instruction, as `max` is not: that minds what is no number.
    #[inline(always)]
    fn positive(self) -> Self {
        self.with(Self::all(0.0), |x, zero| if x > zero { x } else { zero })
    }
}

impl Lanes for f64 {
    fn all(of: f64) -> Self {
        of
    }
    #[inline(always)]
    fn with(self, other: Self, of: impl Fn(f64, f64) -> f64) -> Self {
        of(self, other)
    }
}

impl Lanes for DVec4 {
    fn all(of: f64) -> Self {
        Self::splat(of)
    }
    #[inline(always)]
    fn with(self, other: Self, of: impl Fn(f64, f64) -> f64) -> Self {
        Self::new(of(self.x, other.x), of(self.y, other.y), of(self.z, other.z), of(self.w, other.w))
    }
}

/// A [`Bilinear`] along a vertical.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct LinearLaw<T = f64>(pub T, pub T);

impl<T: Lanes> LinearLaw<T> {
    #[inline(always)]
    pub fn at(&self, y: T) -> T {
        (self.0 + self.1 * y).positive()
    }
}

/// The waves of a surface along a vertical.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Waves<T = f64> {
    pub mass: T,
    pub swing: T,
    pub depth: LinearLaw<T>,
    pub under: LinearLaw<T>,
}

impl<T: Lanes> Waves<T> {
    /// Their damping per C_d, 1/s.
    #[inline(always)]
    pub fn at(&self, y: T) -> T {
        let one = T::all(1.0);
        let under = self.under.at(y).with(one, |under, one| if under < one { under } else { one });
        let ratio = self.mass * self.depth.at(y);
        let fourth = (under * under) * (under * under);
        self.swing * (ratio / (one + ratio)) * (one - fourth * fourth)
    }
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Cut {
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
    fn width(&self, apart: DVec2) -> f64 {
        (self.extent.length.x + self.extent.slope.x * apart.x).positive()
    }

    pub fn waves_along(&self, x: f64) -> Waves {
        let width = self.width(DVec2::new(x, 0.0));
        let (mass, swing) = (self.density * width, 4.0 * WAVES * (self.pull * width).sqrt());
        Waves { mass, swing, depth: LinearLaw(self.extent.length.y, self.extent.slope.y), under: LinearLaw(self.under, self.sinks) }
    }
    pub fn waves(&self, apart: DVec2) -> f64 {
        self.waves_along(apart.x).at(apart.y)
    }

    /// How the damping of its waves per C_d changes with the place, 1/(m·s).
    pub fn slope_of_waves(&self, apart: DVec2) -> DVec2 {
        let depth = LinearLaw(self.extent.length.y, self.extent.slope.y);
        let (width, deep, under) = (self.width(apart), depth.at(apart.y), LinearLaw(self.under, self.sinks).at(apart.y).min(1.0));
        if width == 0.0 || deep == 0.0 || under == 0.0 || under == 1.0 {
            return DVec2::ZERO;
        }
        let (slope, ratio) = (self.extent.slope, self.density * width * deep);
        let square = under * under;
        let fourth = square * square;
        let seventh = fourth * square * under;
        let by_ratio = DVec2::new(slope.x / width, slope.y / deep) / (1.0 + ratio);
        let by_swing = 0.5 * slope.x / width;
        let fading = -8.0 * seventh * self.sinks / (1.0 - fourth * fourth);
        self.waves(apart) * (by_ratio + DVec2::new(by_swing, fading))
    }

    /// K/m, 1/s².
    pub fn stiffness(&self, apart: DVec2) -> f64 {
        if self.sunk { self.pull * self.width(apart) } else { 0.0 }
    }
}

#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Displaced {
    pub liquids: ZoneList,
    pub near: Aabb,
    /// The forms go by the distance from `centre`, m; they were asked for at `within`.
    centre: DVec2,
    within: DVec2,
    /// The centres of the body between kinks, where the forms hold, if they hold anywhere.
    places: Option<Aabb>,
    /// The same without the bounds of `near`.
    kinks: Aabb,
    sliver: DVec2,
    /// The fraction inside, the density of liquids around the whole, kg/m³, and Stokes' drag, 1/s.
    pub fraction: Bilinear,
    pub density: Bilinear,
    pub linear: Bilinear,
    /// The first surface that cuts the body, and the liquids of the others.
    cut: Option<Cut>,
    more: ZoneList,
}

impl Displaced {
    /// Looks for liquids in a box around a body at `x`. Forms that hold there stay: they are the same to the bit.
    pub fn look(&mut self, media: &Media, body: &Body, near: Aabb, x: DVec2) {
        let (liquids, known) = (media.liquids_at(&near), self.places.is_some());
        self.near = near;
        if known && self.liquids == liquids && self.kinks.contains(&Aabb::around(x, sliver(body, x)), 0.0) {
            return self.bound(body, x);
        }
        (self.liquids, self.places) = (liquids, None);
        if !liquids.is_empty() {
            self.renew(media, body, x);
        }
    }

    pub fn follow(&mut self, media: &Media, body: &Body, x: DVec2) {
        if !self.near.contains(&Aabb::around(x, body.half), 0.0) {
            self.near = Aabb::around(x, self.near.size() * 0.5);
            self.liquids = media.liquids_at(&self.near);
        }
        self.renew(media, body, x);
    }

    /// Bounds the places at which the forms hold by the box in which the liquids are known.
    fn bound(&mut self, body: &Body, x: DVec2) {
        let (Aabb { min, max }, kinks) = (self.near, self.kinks);
        self.sliver = sliver(body, x);
        self.places = Some(Aabb::new((min + body.half).max(kinks.min), (max - body.half).min(kinks.max)));
    }

    pub fn alone(&self, liquid: u32) -> Self {
        Self { near: self.near, liquids: ZoneList::of(std::iter::once(liquid)), ..Self::default() }
    }

    fn renew(&mut self, media: &Media, body: &Body, x: DVec2) {
        let (near, liquids) = (self.near, self.liquids);
        let half = body.half;
        let mut kinks = Aabb::new(DVec2::NEG_INFINITY, DVec2::INFINITY);
        // Origin a corner of the box of places, so that the forms are the same to the bit from anywhere in it.
        let mut corner = DVec2::NEG_INFINITY;
        for index in liquids.iter() {
            let fluid = &media.fluids[index as usize];
            if let Some(sides) = Outer::of(body, fluid, x) {
                let (low, high) = sides.places(body, fluid);
                corner = corner.max(low);
                kinks = Aabb::new(kinks.min.max(low), kinks.max.min(high));
            } else {
                keep_from(&mut kinks, body, fluid, x);
            }
        }
        let centre = if corner.is_finite() { corner } else { x };
        *self = Self { liquids, near, centre, within: x, kinks, ..Self::default() };
        self.bound(body, x);
        liquids.iter().for_each(|index| self.add(media, body, index));
        let per_area = 1.0 / (4.0 * half.x * half.y);
        let stokes = STOKES * (half.x + half.y) / body.mass * per_area;
        (self.fraction, self.density) = (self.fraction.scaled(per_area), self.density.scaled(per_area));
        self.linear = self.linear.scaled(stokes);
    }

    /// Adds the area inside a liquid, m², and that times density and viscosity.
    fn add(&mut self, media: &Media, body: &Body, index: u32) {
        let fluid = &media.fluids[index as usize];
        let Some(sides) = Outer::of(body, fluid, self.within) else { return };
        let extent = sides.extent(body, fluid, self.centre);
        self.fraction.add(1.0, &extent);
        self.density.add(fluid.density, &extent);
        self.linear.add(fluid.viscosity, &extent);
        match self.surface(media, body, fluid) {
            Some(_) if self.cut.is_some() => self.more = self.more.with(index),
            Some(cut) => self.cut = Some(cut),
            None => {}
        }
    }

    /// m.
    pub fn apart(&self, x: DVec2) -> DVec2 {
        x - self.centre
    }
    /// The sum `of` all surfaces that cut the body.
    pub fn over_cuts<T: Default + AddAssign>(&self, media: &Media, body: &Body, of: impl Fn(&Cut) -> T) -> T {
        let mut sum = T::default();
        let Some(cut) = &self.cut else { return sum };
        sum += of(cut);
        let more = self.more.iter().filter_map(|index| self.surface(media, body, &media.fluids[index as usize]));
        more.for_each(|cut| sum += of(&cut));
        sum
    }
    fn surface(&self, media: &Media, body: &Body, fluid: &FluidDef) -> Option<Cut> {
        let (sides, down) = (Outer::of(body, fluid, self.within)?, media.gravity >= 0.0);
        let (cut, leaves) = sides.cut(down);
        cut.then(|| {
            let (top, bottom) = (self.centre.y - body.half.y, self.centre.y + body.half.y);
            let emerged = if down { fluid.zone.min.y - top } else { bottom - fluid.zone.max.y };
            let per_height = 0.5 / body.half.y;
            let sinks = if down { per_height } else { -per_height };
            let (density, extent) = (fluid.density / body.mass, sides.extent(body, fluid, self.centre));
            let pull = density * media.gravity.abs();
            Cut { density, pull, extent, under: 1.0 - emerged * per_height, sinks, sunk: !leaves }
        })
    }

    pub fn only_cut(&self) -> Option<&Cut> {
        self.cut.as_ref().filter(|_| self.more.is_empty())
    }

    pub fn is_same_around(&self) -> bool {
        self.cut.is_none() && [self.fraction, self.density, self.linear].iter().all(|form| form.0[1..] == [0.0; 3])
    }

    /// Whether the forms hold at `x`, or within `margin` of where they do.
    fn holds_within(&self, x: DVec2, margin: DVec2) -> bool {
        self.places.is_some_and(|of| x.cmpge(of.min - margin).all() && x.cmple(of.max + margin).all())
    }

    pub fn holds(&self, x: DVec2) -> bool {
        self.holds_within(x, 0.5 * self.sliver)
    }

    /// Whether they hold at all of these points: the other Bézier points of a curve that begins where they hold.
    pub fn holds_along<const N: usize>(&self, points: [DVec2; N]) -> bool {
        points.iter().all(|point| self.holds_within(*point, DVec2::ZERO))
    }

    /// Whether they hold at `x`, or end so near that it does not matter: forces are off by 1e-11 m of the body's height.
    pub fn all_but_holds(&self, x: DVec2) -> bool {
        self.holds_within(x, 1e-11 + self.sliver)
    }

    /// When a way leaves the places where they hold within `h` seconds, if it does.
    pub fn end_of(&self, way: &Cubic, h: f64) -> Option<f64> {
        let places = self.places?;
        let (min, max) = (places.min - self.sliver, places.max + self.sliver);
        let end = |axis: usize| {
            let path = way.axis(axis).until(h);
            let (least, most) = path.bounds;
            let falls = if least < min[axis] { path.falls_through(min[axis], 0.0) } else { None };
            let rises = if most > max[axis] { path.rises_through(max[axis], 0.0) } else { None };
            earliest(falls, rises)
        };
        earliest(end(0), end(1))
    }
}

/// How far beyond a kink a place is by its rounding, m: less far, it would lie before the kink.
fn sliver(body: &Body, x: DVec2) -> DVec2 {
    1e-12 + 16.0 * f64::EPSILON * (x.abs() + body.half)
}

fn keep_from(places: &mut Aabb, body: &Body, fluid: &FluidDef, x: DVec2) {
    let (first, last) = (fluid.zone.min - body.half, fluid.zone.max + body.half);
    // It stays apart along the axis along which it is further away.
    let apart = (first - x).max(x - last);
    let axis = usize::from(apart.y > apart.x);
    if x[axis] <= first[axis] {
        places.max[axis] = places.max[axis].min(first[axis]);
    } else {
        places.min[axis] = places.min[axis].max(last[axis]);
    }
}
