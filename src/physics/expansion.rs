//! The law between kinks ([`super::bath`]) as an expansion: the terms of a motion's power series ([`super::series`]), each from those before it.

use super::air::Drag;
use super::bath::{Forms, Regime, WAVES};
use super::displaced::{Cut, Extent};
use super::flow::Pose;
use super::series::{Series, TERMS, Terms, product, reciprocal, square};
use glam::DVec2;

/// Surfaces that cut what is told by a series. More: it takes longer than the steps that it saves.
const MOST_CUTS: usize = 2;
/// Work of a series.
const WORK: u64 = 400;

impl Regime<'_> {
    /// The series of the motion from here on, if the law is made of what it can be made of.
    pub fn series(&self, constant: DVec2, (x, v): Pose, rate: f64) -> Option<Series> {
        self.media.spend(WORK);
        let start = self.pull(constant, x, v);
        let sign = |axis: usize| if v[axis] != 0.0 { v[axis].signum() } else { start[axis].signum() };
        let signs = DVec2::new(sign(0), sign(1));
        let across = v.x != 0.0 || constant.x != 0.0;
        let cuts = self.cuts().filter(|cuts| cuts.len() <= MOST_CUTS && !(across && cuts.iter().any(Cut::widens)))?;
        if across && self.forms.drag.round > 0.0 {
            return None;
        }
        let Drag { tall, wide, round } = self.forms.drag;
        let drag = signs * DVec2::new(tall, wide + round);
        let apart = self.apart(x);
        let air = if self.forms.shows_air(apart) { self.forms.air } else { 0.0 };
        let mut motion = Motion::of(self);
        (motion.constant, motion.drag, motion.air, motion.across, motion.count) = (constant, drag, air, across, cuts.len());
        motion.waves.iter_mut().zip(cuts).for_each(|(waves, cut)| waves.begin(cut, apart.x));
        ((motion.x[0], motion.y[0]), (motion.u[0], motion.w[0])) = (apart.into(), v.into());
        motion.expand();
        let mut terms = [DVec2::ZERO; TERMS];
        terms.iter_mut().zip(motion.x.iter().zip(&motion.y)).for_each(|(term, (x, y))| *term = DVec2::new(*x, *y));
        terms[0] = x;
        Some(Series::new(terms, signs, rate))
    }
}

/// A motion as series: of the place, by its distance from the centre of what is displaced, of the velocity, and of what they are made of.
struct Motion<'a> {
    regime: &'a Regime<'a>,
    constant: DVec2,
    /// Whether it moves to the side.
    across: bool,
    /// s(u) in a medium of 1 kg/m³ by u_x and u_y, with their signs.
    drag: DVec2,
    /// Density of the air, if some of the body is in it.
    air: f64,
    waves: [Waves; MOST_CUTS],
    count: usize,
    x: Terms,
    y: Terms,
    u: Terms,
    w: Terms,
    /// x·y, the density around the body, s(u), and what slows it across, and up and down, 1/s.
    both: Terms,
    density: Terms,
    rates: Terms,
    slow: Terms,
    slow_down: Terms,
}

impl<'a> Motion<'a> {
    #[inline(always)]
    fn of(regime: &'a Regime<'a>) -> Self {
        let none = [0.0; TERMS];
        let (constant, drag, waves) = (DVec2::ZERO, DVec2::ZERO, [Waves::default(); MOST_CUTS]);
        let (x, y, u, w, both, density, rates, slow, slow_down) = (none, none, none, none, none, none, none, none, none);
        Self { regime, constant, across: false, drag, air: 0.0, waves, count: 0, x, y, u, w, both, density, rates, slow, slow_down }
    }

    /// All terms.
    fn expand(&mut self) {
        self.next::<0>();
        self.next::<1>();
        self.next::<2>();
        self.next::<3>();
        self.next::<4>();
        self.next::<5>();
        self.next::<6>();
        self.next::<7>();
        self.next::<8>();
        self.next::<9>();
        self.next::<10>();
        self.next::<11>();
    }

    /// From the terms up to the `N`-th, the next one of place and velocity.
    #[inline(always)]
    fn next<const N: usize>(&mut self) {
        let Forms { density, fraction, linear, lift, .. } = &self.regime.forms;
        let one = if N == 0 { 1.0 } else { 0.0 };
        let next = 1.0 / (N + 1) as f64;
        self.both[N] = if self.across { product::<N>(&self.x, &self.y) } else { self.x[0] * self.y[N] };
        let place = (one, self.x[N], self.y[N], self.both[N]);
        let wet = density.term(place);
        self.density[N] = wet + self.air * (one - fraction.term(place));
        self.rates[N] = self.drag.x * self.u[N] + self.drag.y * self.w[N];
        self.slow[N] = product::<N>(&self.density, &self.rates) + linear.term(place);
        let waves = self.waves[..self.count].iter_mut().fold(0.0, |sum, waves| sum + waves.term::<N>(&self.y));
        self.slow_down[N] = self.slow[N] + self.regime.body.drag * waves;
        if self.across {
            let pull = one * self.constant.x - product::<N>(&self.slow, &self.u);
            (self.x[N + 1], self.u[N + 1]) = (self.u[N] * next, pull * next);
        }
        let pull = one * self.constant.y - lift * wet - product::<N>(&self.slow_down, &self.w);
        (self.y[N + 1], self.w[N + 1]) = (self.w[N] * next, pull * next);
    }
}

/// The waves of a cut as a power series.
#[derive(Clone, Copy, Debug, Default)]
struct Waves {
    /// 1 + r and the part below the surface, as a + b·y.
    deep: (f64, f64),
    under: (f64, f64),
    /// 1/s.
    strength: f64,
    /// 1 + r, its reciprocal, r/(1 + r); the part below the surface, squared, and again; and how it fades.
    ratio: Terms,
    reciprocal: Terms,
    share: Terms,
    first: Terms,
    second: Terms,
    fourth: Terms,
    fades: Terms,
}

impl Waves {
    /// Of the surface `cut`, while the body is `x` m to the side of the place around which all is.
    fn begin(&mut self, cut: &Cut, x: f64) {
        let width = cut.width(DVec2::new(x, 0.0));
        let wide = cut.density * width;
        let swing = cut.swing.unwrap_or_else(|| (cut.pull * width).sqrt());
        let Extent { length, slope } = cut.extent;
        (self.deep, self.under) = ((1.0 + wide * length.y, wide * slope.y), (cut.under, cut.sinks));
        self.strength = 4.0 * WAVES * swing;
    }

    /// The `N`-th term of the damping per C_d, 1/s, as y goes by these terms.
    #[inline(always)]
    fn term<const N: usize>(&mut self, y: &Terms) -> f64 {
        let one = if N == 0 { 1.0 } else { 0.0 };
        self.ratio[N] = self.deep.0 * one + self.deep.1 * y[N];
        self.reciprocal[N] = reciprocal::<N>(&self.ratio, &self.reciprocal);
        self.share[N] = one - self.reciprocal[N];
        self.first[N] = self.under.0 * one + self.under.1 * y[N];
        self.second[N] = square::<N>(&self.first);
        self.fourth[N] = square::<N>(&self.second);
        self.fades[N] = one - square::<N>(&self.fourth);
        self.strength * product::<N>(&self.share, &self.fades)
    }
}

#[cfg(test)]
mod tests {
    use crate::physics::media::Media;
    use crate::physics::zone_tree::ZoneList;
    use crate::physics::{Aabb, Body, BodyDef, DVec2, FluidDef, bath::Regime, media::Law};

    /// At any time at which the series holds, its acceleration is what the law says there.
    #[test]
    fn the_series_obeys_the_law() {
        let pool = |top: f64, density: f64| FluidDef {
            zone: Aabb::new(DVec2::new(-50.0, top), DVec2::new(50.0, 30.0)),
            density,
            viscosity: 3.0,
        };
        let media = Media::new(15.0, 1.2, (&[], &[]), vec![pool(0.0, 800.0), pool(0.3, 500.0)]);
        for (y, v) in [(0.0, (0.4, 0.5)), (0.2, (0.0, -0.8)), (5.0, (2.0, 1.0)), (-0.3, (1.0, 2.0)), (0.1, (0.0, 0.0))] {
            let (position, velocity) = (DVec2::new(3.0, y), DVec2::from(v));
            let body = Body::new(&BodyDef { position, velocity, mass: 500.0, ..BodyDef::default() });
            let liquids = ZoneList::of(0..2);
            let near = Aabb::around(DVec2::ZERO, DVec2::splat(1e30));
            let constant = DVec2::new(0.0, media.gravity);
            let law = Law { constant, air: media.air(&body), wet: true, liquids, near, ..Law::default() };
            let regime = Regime::new(&media, &body, &law, position);
            let series = regime.series(constant, (position, velocity), 10.0).unwrap();
            let (h, mut looked) = (1e-4, 0);
            for t in (1..80).map(|k| 0.005 * f64::from(k)).take_while(|t| series.holds(*t)) {
                let (x, v) = series.at(t);
                if !regime.holds(x) || !series.goes_as(v) {
                    break;
                }
                let found = (series.at(t + h).1 - series.at(t - h).1) / (2.0 * h);
                let expected = regime.pull(constant, x, v);
                assert!((found - expected).length() < 1e-5, "from {y} m, after {t} s: {found} m/s², not {expected}");
                looked += 1;
            }
            assert!(looked >= 3, "from {y} m: {looked}");
        }
    }
}
