//! Liquids: in one of density ρ and viscosity η a body of which the fraction f is inside feels the buoyancy ρ·g·V·f, V its box, 1 m deep; and a drag
//! of three parts: the air's formula with ρ, times f; Stokes' 3π·η·d·u, times f, with d the mean of width and height; and, up and down, the waves of
//! what the surface cuts (`docs/physics.md`, Liquids). A body without velocity whose forces balance to rounding has a resultant of exactly zero.

use crate::physics::forces::displaced::{Bilinear, Cut, Displaced, Lanes, LinearLaw, Waves};
use crate::physics::{data::body::Body, forces::air::Drag, forces::media::Media};
use glam::{DMat2, DVec2};
use std::borrow::Cow;

/// −∂a/∂v along either axis, 1/s, and −∂a_y/∂y by buoyancy, 1/s², both ≥ 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Stiffness {
    pub drag: DVec2,
    pub lift: f64,
}

/// How the acceleration by the media changes with place, 1/s², and velocity, 1/s.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slopes {
    pub place: DMat2,
    pub speed: DMat2,
}

#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Bath {
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
    /// Acceleration at velocity `v` by these media and `constant`, m/s².
    pub fn acceleration(&self, constant: DVec2, v: DVec2) -> DVec2 {
        let drag = self.drag.rate(v) + self.linear;
        DVec2::new(constant.x - v.x * drag, (constant.y - self.lift) - v.y * (drag + self.waves))
    }

    pub fn answer(&self, v: DVec2) -> Stiffness {
        Stiffness { drag: self.drag.stiffness(v) + self.linear + DVec2::new(0.0, self.waves), lift: self.stiffness }
    }

    /// Of a balance along the vertical at `y`, m/s². Smaller: a floating body never comes to rest; larger: it rests beside its waterline.
    pub fn rounding(&self, constant: DVec2, body: &Body, y: f64) -> f64 {
        4e-14 * (constant.y.abs() + self.lift.abs() + self.stiffness * (y.abs() + body.half.y))
    }
}

/// The least part of a body at `x` that is more than a rounding: 16 of its coordinates, in its halves. Smaller: air meets what is wholly inside.
pub(crate) fn sure(body: &Body, x: DVec2) -> f64 {
    (16.0 * f64::EPSILON * (1.0 + (x.abs() / body.half).max_element())).min(1e-6)
}

/// The fraction that is in no liquid, if it is surely more than nothing.
pub(crate) fn dry(wet: f64, sure: f64) -> f64 {
    let dry = 1.0 - wet;
    if dry < sure { 0.0 } else { dry }
}

#[derive(Clone, Debug)]
pub(crate) struct Regime<'a> {
    pub media: &'a Media,
    pub body: &'a Body,
    pub constant: DVec2,
    pub displaced: Cow<'a, Displaced>,
    /// The density of the air if it is felt, kg/m³.
    air: f64,
    /// Drag in a medium of 1 kg/m³, and buoyancy for that, m/s².
    drag: Drag,
    lift: f64,
    sure: f64,
}

/// The vertical part of [`Regime::pull`] along a vertical: its numbers, in the order in which [`Vertical::pull`] names them.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Vertical<T = f64>(pub [T; 19]);

impl<T: Lanes> Vertical<T> {
    /// At a height with a velocity.
    #[inline(always)]
    pub fn pull(&self, y: T, v: T) -> T {
        let [constant, lift, air, sure, drag, centre, wet, wetter, inside, deeper, linear, slower, ..] = self.0;
        let [.., mass, swing, depth, down, under, sinks, wavy] = self.0;
        let y = y - centre;
        let wet = LinearLaw(wet, wetter).at(y);
        let dry = (T::all(1.0) - LinearLaw(inside, deeper).at(y)).with(sure, |dry, sure| if dry < sure { 0.0 } else { dry });
        let drag = (wet + air * dry) * (drag * v.with(v, |v, _| v.abs())) + LinearLaw(linear, slower).at(y);
        let waves = Waves { mass, swing, depth: LinearLaw(depth, down), under: LinearLaw(under, sinks) };
        (constant - lift * wet) - v * (drag + wavy * waves.at(y))
    }
}

impl<'a> Regime<'a> {
    pub fn new(media: &'a Media, body: &'a Body, constant: DVec2, air: f64, displaced: &'a Displaced) -> Self {
        let displaced = Cow::Borrowed(displaced);
        let lift = media.gravity * (4.0 * body.half.x * body.half.y / body.mass);
        Self { media, body, constant, displaced, air, drag: Drag::of(body, 1.0), lift, sure: sure(body, body.position) }
    }
    pub fn follow(&mut self, x: DVec2) -> &Self {
        if !self.displaced.holds(x) {
            self.displaced.to_mut().follow(self.media, self.body, x);
        }
        self
    }

    /// Densities of the liquids and of the air around the whole of the body, kg/m³.
    fn densities(&self, apart: DVec2) -> (f64, f64) {
        let dry = if self.air == 0.0 { 0.0 } else { dry(self.displaced.fraction.at(apart), self.sure) };
        (self.displaced.density.at(apart), self.air * dry)
    }
    fn damping(&self, apart: DVec2) -> f64 {
        self.body.drag * self.displaced.over_cuts(self.media, self.body, |cut| cut.waves(apart))
    }
    pub fn bath(&self, x: DVec2) -> Bath {
        let apart = self.displaced.apart(x);
        let at = |cut: &Cut| DVec2::new(cut.waves(apart), cut.stiffness(apart));
        self.bath_at(apart, self.displaced.over_cuts(self.media, self.body, at))
    }

    /// The bath, given what waves damp per C_d (1/s) and K/m (1/s²).
    #[inline(always)]
    fn bath_at(&self, apart: DVec2, cuts: DVec2) -> Bath {
        let (wet, dry) = self.densities(apart);
        let (fraction, linear) = (self.displaced.fraction.at(apart), self.displaced.linear.at(apart));
        let waves = self.body.drag * cuts.x;
        Bath { fraction, drag: self.drag.scaled(wet + dry), linear, waves, lift: self.lift * wet, stiffness: cuts.y }
    }

    /// Acceleration at `x` with velocity `v` by media and `constant`, m/s²: [`Bath::acceleration`] for integrators.
    pub fn pull(&self, constant: DVec2, x: DVec2, v: DVec2) -> DVec2 {
        let apart = self.displaced.apart(x);
        let (wet, dry) = self.densities(apart);
        let drag = (wet + dry) * self.drag.rate(v) + self.displaced.linear.at(apart);
        DVec2::new(constant.x - v.x * drag, (constant.y - self.lift * wet) - v.y * (drag + self.damping(apart)))
    }

    /// The law of what does not move across at `x`, in the only surface there, and the bath.
    #[inline(always)]
    pub fn vertical(&self, constant: DVec2, x: DVec2, v: DVec2) -> Option<(Vertical, Bath)> {
        if v.x != 0.0 || constant.x != 0.0 {
            return None;
        }
        let (displaced, apart) = (&*self.displaced, self.displaced.apart(x));
        let cut = displaced.only_cut()?;
        let waves = cut.waves_along(apart.x);
        let bath = self.bath_at(apart, DVec2::new(waves.at(apart.y), cut.stiffness(apart)));
        let Waves { mass, swing, depth, under } = waves;
        let along = |form: &Bilinear| form.along(apart.x);
        let (wet, inside, linear) = (along(&displaced.density), along(&displaced.fraction), along(&displaced.linear));
        let (drag, centre) = (self.drag.wide + self.drag.round, -displaced.apart(DVec2::ZERO).y);
        #[rustfmt::skip]
        let law = [
            constant.y, self.lift, self.air, self.sure, drag, centre, wet.0, wet.1, inside.0, inside.1, linear.0, linear.1,
            mass, swing, depth.0, depth.1, under.0, under.1, self.body.drag,
        ];
        Some((Vertical(law), bath))
    }

    /// How [`Regime::pull`] changes around `x` and `v`.
    pub fn slopes(&self, x: DVec2, v: DVec2) -> Slopes {
        let (displaced, apart) = (&self.displaced, self.displaced.apart(x));
        let (wet, dry) = self.densities(apart);
        let wetter = displaced.density.slope(apart);
        let drier = if dry > 0.0 { -self.air * displaced.fraction.slope(apart) } else { DVec2::ZERO };
        let (rate, by_speed) = (self.drag.rate(v), self.drag.slope(v));
        let drag = (wet + dry) * rate + displaced.linear.at(apart);
        let draggier = (wetter + drier) * rate + displaced.linear.slope(apart);
        let wavier = self.body.drag * displaced.over_cuts(self.media, self.body, |cut| cut.slope_of_waves(apart));
        let down = -self.lift * wetter - v.y * wavier;
        let place = |by: f64, down: f64| -v * by + DVec2::new(0.0, down);
        let speed = |by: f64| -v * ((wet + dry) * by);
        let own = DVec2::new(drag, drag + self.damping(apart));
        Slopes {
            place: DMat2::from_cols(place(draggier.x, down.x), place(draggier.y, down.y)),
            speed: DMat2::from_cols(speed(by_speed.x), speed(by_speed.y)) - DMat2::from_diagonal(own),
        }
    }

    pub fn acceleration(&self, x: DVec2, v: DVec2) -> DVec2 {
        if v.y != 0.0 {
            return self.pull(self.constant, x, v);
        }
        let bath = self.bath(x);
        let mut a = bath.acceleration(self.constant, v);
        if self.balances(&bath, x, a.y) {
            a.y = 0.0;
        }
        a
    }

    /// Whether the vertical forces on a body without vertical velocity balance but for rounding; `left_over` is their sum, m/s².
    pub fn balances(&self, bath: &Bath, x: DVec2, left_over: f64) -> bool {
        bath.fraction > 0.0 && left_over.abs() <= bath.rounding(self.constant, self.body, x.y)
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
                let regime = law.regime(&media, &body, position);
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
