//! What media do to a body around a place: the law between two kinks ([`crate::physics::forces::displaced`]).

use crate::physics::data::body::Body;
use crate::physics::forces::air::Drag;
use crate::physics::forces::displaced::{Bilinear, Displaced};
use crate::physics::forces::media::{Law, Media};
use glam::{DMat2, DVec2};
use std::borrow::Cow;
use std::ops::Deref;

/// Stokes' law: 3π per diameter.
pub(crate) const STOKES: f64 = 3.0 * std::f64::consts::PI;
/// Damping ratio of what floats at its waterline, per unit of C_d. Smaller: 300 kg on water are not at rest after a minute; larger: a
/// splash calms down within one bob.
pub(crate) const WAVES: f64 = 0.15;
/// Relative: what rounding leaves of a balance of forces. Smaller: what floats never comes to rest; larger: it rests beside its waterline.
const BALANCE: f64 = 4e-14;
/// Roundings of its coordinates, in its halves, that the fraction of a body inside liquids may be off by; and what is surely more. Smaller: of
/// what is wholly inside, a part of 1e-16 meets an air that is 1e10 times as thick.
const ROUNDED: f64 = 16.0 * f64::EPSILON;
const SURELY: f64 = 1e-6;

/// How the acceleration by the media answers to small changes of a state: what an implicit step needs.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Stiffness {
    /// −∂a/∂v along either axis, 1/s, ≥ 0.
    pub drag: DVec2,
    /// −∂a_y/∂y by buoyancy, 1/s², ≥ 0.
    pub lift: f64,
}

/// How the acceleration by the media changes with place, 1/s², and velocity, 1/s.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slopes {
    pub place: DMat2,
    pub speed: DMat2,
}

/// What all media together do to a body at a place, per mass.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Bath {
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

/// How large a part of a body at `x` is surely more than the rounding of the fraction that is inside liquids.
#[inline]
fn sure(body: &Body, x: DVec2) -> f64 {
    SURELY.min(ROUNDED * (1.0 + (x.abs() / body.half).max_element()))
}

/// The fraction of a body at `x` that is in no liquid: none where it is nothing but the rounding of the fraction that is.
#[inline]
pub(crate) fn dry(body: &Body, x: DVec2, fraction: f64) -> f64 {
    left(fraction, sure(body, x))
}

/// What is left of 1, if it is surely more than nothing.
#[inline]
fn left(fraction: f64, sure: f64) -> f64 {
    let dry = 1.0 - fraction;
    if dry < sure { 0.0 } else { dry }
}

/// The law between kinks, by the distance from the centre of what is displaced.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Forms {
    /// Drag in a medium of 1 kg/m³, and the density of the air if it is felt, kg/m³.
    pub drag: Drag,
    pub air: f64,
    /// The part of the body that is inside, the density of liquids around the whole, kg/m³, and Stokes' drag, 1/s.
    pub fraction: Bilinear,
    pub density: Bilinear,
    pub linear: Bilinear,
    /// Buoyancy for each of those kg/m³, m/s².
    pub lift: f64,
    /// What is surely more than the rounding of that part.
    pub sure: f64,
}

impl Forms {
    fn of(media: &Media, body: &Body, law: &Law) -> Self {
        let air = if law.air.is_none() { 0.0 } else { media.air_density };
        let lift = media.gravity * (4.0 * body.half.x * body.half.y / body.mass);
        let sure = sure(body, body.position);
        let forms = Self { drag: Drag::of(body, 1.0), air, lift, sure, ..Self::default() };
        forms.around(body, &law.displaced)
    }

    /// The same, of what else is displaced.
    fn around(&self, body: &Body, displaced: &Displaced) -> Self {
        let (area, mass, thick) = displaced.inside();
        let half = body.half;
        let per_area = 1.0 / (4.0 * half.x * half.y);
        let stokes = STOKES * (half.x + half.y) / body.mass * per_area;
        let (fraction, density, linear) = (area.scaled(per_area), mass.scaled(per_area), thick.scaled(stokes));
        Self { fraction, density, linear, ..*self }
    }

    /// Densities of the liquids and of the air around the whole of the body, kg/m³.
    #[inline]
    fn densities(&self, apart: DVec2) -> (f64, f64) {
        let dry = if self.air == 0.0 { 0.0 } else { left(self.fraction.at(apart), self.sure) };
        (self.density.at(apart), self.air * dry)
    }

    /// Acceleration with velocity `v` and so much damping by waves, 1/s, if `constant` did what media do not, m/s².
    #[inline]
    pub fn pull(&self, constant: DVec2, apart: DVec2, v: DVec2, waves: f64) -> DVec2 {
        let (wet, dry) = self.densities(apart);
        let drag = (wet + dry) * self.drag.rate(v) + self.linear.at(apart);
        DVec2::new(constant.x - v.x * drag, (constant.y - self.lift * wet) - v.y * (drag + waves))
    }
}

/// A body in its media, around a place.
#[derive(Clone, Debug)]
pub(crate) struct Regime<'a> {
    pub media: &'a Media,
    pub body: &'a Body,
    /// What it holds to be displaced is so around the place.
    law: Cow<'a, Law>,
    pub forms: Forms,
}

impl Deref for Regime<'_> {
    type Target = Displaced;

    fn deref(&self) -> &Displaced {
        &self.law.displaced
    }
}

impl<'a> Regime<'a> {
    /// Around `x`.
    pub fn new(media: &'a Media, body: &'a Body, law: &'a Law, x: DVec2) -> Self {
        let mut regime = Self { media, body, law: Cow::Borrowed(law), forms: Forms::of(media, body, law) };
        regime.follow(x);
        regime
    }

    /// The one around `x`.
    #[inline]
    pub fn follow(&mut self, x: DVec2) -> &Self {
        if !self.holds(x) {
            self.media.follow(self.law.to_mut(), self.body, x);
            self.forms = self.forms.around(self.body, &self.law.displaced);
        }
        self
    }

    /// Damping by waves, 1/s.
    #[inline]
    fn damping(&self, apart: DVec2) -> f64 {
        self.body.drag * self.waves(self.media, self.body, apart, &self.law.liquids)
    }

    /// What media do at `x`.
    #[inline]
    pub fn bath(&self, x: DVec2) -> Bath {
        let (forms, apart) = (&self.forms, self.apart(x));
        let (wet, dry) = forms.densities(apart);
        Bath {
            fraction: forms.fraction.at(apart),
            drag: forms.drag.scaled(wet + dry),
            linear: forms.linear.at(apart),
            waves: self.damping(apart),
            lift: forms.lift * wet,
            stiffness: self.stiffness(self.media, self.body, apart, &self.law.liquids),
        }
    }

    /// Acceleration at `x` with velocity `v` if `constant` did what media do not, m/s²: [`Bath::acceleration`] for integrators.
    #[inline]
    pub fn pull(&self, constant: DVec2, x: DVec2, v: DVec2) -> DVec2 {
        let apart = self.apart(x);
        self.forms.pull(constant, apart, v, self.damping(apart))
    }

    /// How [`Regime::pull`] changes around `x` and `v`.
    pub fn slopes(&self, x: DVec2, v: DVec2) -> Slopes {
        let (forms, apart) = (&self.forms, self.apart(x));
        let (wet, dry) = forms.densities(apart);
        let wetter = forms.density.slope(apart);
        let drier = if dry > 0.0 { -forms.air * forms.fraction.slope(apart) } else { DVec2::ZERO };
        let (rate, by_speed) = (forms.drag.rate(v), forms.drag.slope(v));
        let drag = (wet + dry) * rate + forms.linear.at(apart);
        let draggier = (wetter + drier) * rate + forms.linear.slope(apart);
        let wavier = self.body.drag * self.slope_of_waves(self.media, self.body, apart, &self.law.liquids);
        let down = -forms.lift * wetter - v.y * wavier;
        let place = |by: f64, down: f64| -v * by + DVec2::new(0.0, down);
        let speed = |by: f64| -v * ((wet + dry) * by);
        let own = DVec2::new(drag, drag + self.damping(apart));
        Slopes {
            place: DMat2::from_cols(place(draggier.x, down.x), place(draggier.y, down.y)),
            speed: DMat2::from_cols(speed(by_speed.x), speed(by_speed.y)) - DMat2::from_diagonal(own),
        }
    }

    /// Acceleration at `x` with velocity `v`, m/s².
    pub fn acceleration(&self, x: DVec2, v: DVec2) -> DVec2 {
        if v.y != 0.0 {
            return self.pull(self.law.constant, x, v);
        }
        let bath = self.bath(x);
        let mut a = bath.acceleration(self.law.constant, v);
        if self.balances(&bath, x, a.y) {
            a.y = 0.0;
        }
        a
    }

    /// Whether the vertical forces on what has no vertical velocity, `left_over` by their sum (m/s²), balance but for rounding.
    pub fn balances(&self, bath: &Bath, x: DVec2, left_over: f64) -> bool {
        bath.fraction > 0.0 && left_over.abs() <= bath.rounding(self.law.constant, self.body, x.y)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::data::aabb::Aabb;
    use crate::physics::data::body::BodyDef;
    use crate::physics::data::def::FluidDef;

    /// In the air, at a surface, across several, at the end of a pool; boxes and round things.
    #[test]
    fn the_slopes_are_those_of_the_acceleration() {
        let pool = |top: f64, density: f64| FluidDef {
            zone: Aabb::new(DVec2::new(-5.0, top), DVec2::new(5.0, 30.0)),
            density,
            viscosity: 3.0,
        };
        let media = Media::new(15.0, 1.2, (&[], &[]), vec![pool(0.0, 800.0), pool(0.3, 500.0)]);
        for round in [false, true] {
            for (x, v) in
                [((1.0, -2.0), (2.0, 3.0)), ((1.0, 0.1), (2.0, -3.0)), ((5.2, 0.2), (-1.0, 4.0)), ((-4.8, 9.0), (0.5, -6.0))]
            {
                let (position, v) = (DVec2::from(x), DVec2::from(v));
                let body = Body::new(&BodyDef { position, mass: 200.0, half: DVec2::new(0.4, 0.7), round, ..BodyDef::default() });
                let law = media.law(&body, DVec2::ZERO, 0.0);
                let regime = Regime::new(&media, &body, &law, position);
                let Slopes { place, speed } = regime.slopes(position, v);
                let pull = |x: DVec2, v: DVec2| regime.pull(law.constant, x, v);
                let step = 1e-6;
                for (axis, by) in [DVec2::X * step, DVec2::Y * step].into_iter().enumerate() {
                    let by_place = (pull(position + by, v) - pull(position - by, v)) / (2.0 * step);
                    let by_speed = (pull(position, v + by) - pull(position, v - by)) / (2.0 * step);
                    assert!((place.col(axis) - by_place).length() < 1e-5, "{x:?}, axis {axis}: {place}, not {by_place}");
                    assert!((speed.col(axis) - by_speed).length() < 1e-5, "{x:?}, axis {axis}: {speed}, not {by_speed}");
                }
            }
        }
    }
}
