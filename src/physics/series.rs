//! The motion of a body through liquids as a power series in time, between kinks and turns of its velocity (Taylor's method: Moore, *Interval
//! Analysis*, 1966; Hairer, Nørsett, Wanner, *Solving Ordinary Differential Equations I*, I.8).
//!
//! There the law is made of sums, products and quotients alone: what is displaced is bilinear in the place, and |u_x|, |u_y| are linear in
//! the velocity. So each coefficient follows from those before it: (f·g)ₙ = Σ fₖ·gₙ₋ₖ, (1/f)ₙ = −Σ_{k≥1} fₖ·(1/f)ₙ₋ₖ / f₀, and with the
//! accelerations aₙ, vₙ₊₁ = aₙ/(n + 1), xₙ₊₁ = vₙ/(n + 1). It holds as long as its last terms are small.

use super::flow::Pose;
use glam::DVec2;

/// Terms of the place. More: each series takes longer, with the square, and holds longer.
pub(super) const TERMS: usize = 13;
/// m. What the last terms may come to.
const TOLERANCE: f64 = 5e-11;
/// Rate × time for which it holds at most, however small the motion is.
const REACH: f64 = 3.0;

/// The terms of one quantity.
pub(super) type Terms = [f64; TERMS];

/// Σ f[k]·g[N − k] for k ≥ `FROM`, as two sums, none of which waits for the other. `N` is known when it is compiled: no loop is left.
#[inline(always)]
fn fold<const FROM: usize, const N: usize>(f: &Terms, g: &Terms) -> f64 {
    let (mut even, mut odd, mut k) = (0.0, 0.0, FROM);
    while k < N {
        even += f[k] * g[N - k];
        odd += f[k + 1] * g[N - k - 1];
        k += 2;
    }
    if k == N {
        even += f[N] * g[0];
    }
    even + odd
}

/// The `N`-th term of a product.
#[inline(always)]
pub(super) fn product<const N: usize>(f: &Terms, g: &Terms) -> f64 {
    fold::<0, N>(f, g)
}

/// The `N`-th term of a square.
#[inline(always)]
pub(super) fn square<const N: usize>(f: &Terms) -> f64 {
    let (mut twice, mut k) = (0.0, 0);
    while 2 * k < N {
        twice += f[k] * f[N - k];
        k += 1;
    }
    if 2 * k == N { 2.0 * twice + f[k] * f[k] } else { 2.0 * twice }
}

/// The `N`-th term of 1/f, g, of which those before are known.
#[inline(always)]
pub(super) fn reciprocal<const N: usize>(f: &Terms, g: &Terms) -> f64 {
    if N == 0 { 1.0 / f[0] } else { -g[0] * fold::<1, N>(f, g) }
}

/// A motion.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Series {
    /// Of the place, m.
    pub terms: [DVec2; TERMS],
    /// How long it holds at most, s.
    pub lasts: f64,
    /// The signs of the velocities.
    pub signs: DVec2,
}

impl Series {
    /// Of places with these terms and velocities of these signs, in a law of that `rate`, 1/s.
    pub fn new(terms: [DVec2; TERMS], signs: DVec2, rate: f64) -> Self {
        Self { terms, lasts: Self::most(rate), signs }
    }

    /// Whether it still holds at a time.
    #[inline]
    pub fn holds(&self, t: f64) -> bool {
        let (square, last) = (t * t, self.terms[TERMS - 2].abs() + self.terms[TERMS - 1].abs() * t);
        let fourth = square * square;
        t <= self.lasts && (last * (fourth * fourth * square * t)).max_element() <= TOLERANCE
    }

    /// How long one holds at most in a law of that rate, s.
    pub fn most(rate: f64) -> f64 {
        REACH / rate
    }

    /// Place and velocity at a time.
    #[inline]
    pub fn at(&self, t: f64) -> Pose {
        let last = TERMS - 1;
        let (mut x, mut v) = (self.terms[last], self.terms[last] * last as f64);
        for k in (1..last).rev() {
            x = self.terms[k] + x * t;
            v = self.terms[k] * k as f64 + v * t;
        }
        (self.terms[0] + x * t, v)
    }

    /// Whether no component of the velocity has changed its sign.
    pub fn goes_as(&self, v: DVec2) -> bool {
        v.x * self.signs.x >= 0.0 && v.y * self.signs.y >= 0.0
    }
}
