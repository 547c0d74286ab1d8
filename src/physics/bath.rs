//! What media do to a body around a place: the law between two kinks ([`super::displaced`]).

use super::Body;
use super::air::Drag;
use super::displaced::Displaced;
use super::media::{Law, Media};
use glam::DVec2;
use std::borrow::Cow;
use std::ops::Deref;

/// Stokes' law: 3π per diameter.
pub(super) const STOKES: f64 = 3.0 * std::f64::consts::PI;
/// Damping ratio of what floats at its waterline, per unit of C_d. Smaller: 300 kg on water are not at rest after a minute; larger: a
/// splash calms down within one bob.
pub(super) const WAVES: f64 = 0.15;
/// Relative: what rounding leaves of a balance of forces. Smaller: what floats never comes to rest; larger: it rests beside its waterline.
const BALANCE: f64 = 4e-14;
/// Roundings of its coordinates, in its halves, that the fraction of a body inside liquids may be off by; and what is surely more. Smaller: of
/// what is wholly inside, a part of 1e-16 meets an air that is 1e10 times as thick.
const ROUNDED: f64 = 16.0 * f64::EPSILON;
const SURELY: f64 = 1e-6;
/// Work of a bath.
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

/// The fraction of a body at `x` that is in no liquid: none where it is nothing but the rounding of the fraction that is.
#[inline]
pub(super) fn dry(body: &Body, x: DVec2, fraction: f64) -> f64 {
    let dry = 1.0 - fraction;
    let is_rounding = dry < SURELY && dry < ROUNDED * (1.0 + (x.abs() / body.half).max_element());
    if is_rounding { 0.0 } else { dry }
}

/// A body in its media, around a place.
#[derive(Clone, Debug)]
pub(super) struct Regime<'a> {
    media: &'a Media,
    body: &'a Body,
    /// What it holds to be displaced is so around the place.
    law: Cow<'a, Law>,
    /// Quadratic drag, Stokes' drag and buoyancy of what is displaced, each per kg/m or Pa·s·m².
    drag: Drag,
    stokes: f64,
    lift: f64,
    per_area: f64,
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
        let (half, per_mass) = (body.half, 1.0 / body.mass);
        let per_area = 1.0 / (4.0 * half.x * half.y);
        let (drag, stokes) = (Drag::of(body, per_area), STOKES * (half.x + half.y) * per_mass * per_area);
        let lift = media.gravity * per_mass;
        let mut all = Self { media, body, law: Cow::Borrowed(law), drag, stokes, lift, per_area };
        all.follow(x);
        all
    }

    /// The one around `x`.
    #[inline]
    pub fn follow(&mut self, x: DVec2) -> &Self {
        if !self.holds(x) {
            self.media.follow(self.law.to_mut(), self.body, x);
        }
        self
    }

    /// What media do at `x`.
    #[inline]
    pub fn bath(&self, x: DVec2) -> Bath {
        self.media.spend(WORK_OF_A_BATH);
        let (area, mass, thick) = self.at(x);
        let fraction = area * self.per_area;
        let mut drag = self.drag.scaled(mass);
        if !self.law.air.is_none() {
            drag = drag.plus(&self.law.air.scaled(dry(self.body, x, fraction)));
        }
        let (waves, stiffness) = self.surfaces(self.media, self.body, x, &self.law.liquids);
        let waves = self.body.drag * waves;
        Bath { fraction, drag, linear: self.stokes * thick, waves, lift: self.lift * mass, stiffness }
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
}
