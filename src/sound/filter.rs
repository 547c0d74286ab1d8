//! Building blocks of sounds: noise, filters, and values that glide instead of jumping.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg32;
use std::f32::consts::{PI, TAU};

/// −1 … 1; the same from the same seed.
pub struct WhiteNoise(Pcg32);

impl WhiteNoise {
    pub fn new(seed: u64) -> Self {
        Self(Pcg32::seed_from_u64(seed))
    }

    pub fn next(&mut self) -> f32 {
        self.0.random_range(-1.0..1.0)
    }

    /// Uniform between the two.
    pub fn between(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * (0.5 + 0.5 * self.next())
    }
}

/// A value that approaches its target exponentially: a step would be heard as a crack.
#[derive(Clone, Copy, Debug)]
pub struct Glide {
    pub value: f32,
    /// The part of the difference that is left after a sample.
    keeps: f32,
}

impl Glide {
    /// Starts at 0; 1/e of the difference is left after `time` s.
    pub fn new(rate: f32, time: f32) -> Self {
        Self { value: 0.0, keeps: (-1.0 / (rate * time)).exp() }
    }

    /// Advances by a sample.
    pub fn towards(&mut self, target: f32) -> f32 {
        self.value = target + (self.value - target) * self.keeps;
        // Denormal numbers cost a hundred times as much.
        if self.value.abs() < 1e-12 {
            self.value = 0.0;
        }
        self.value
    }
}

/// A first-order low-pass: −6 dB an octave above its corner.
#[derive(Clone, Copy, Debug, Default)]
pub struct LowPass {
    level: f32,
    part: f32,
}

impl LowPass {
    /// `corner` in Hz.
    pub fn set(&mut self, rate: f32, corner: f32) {
        self.part = 1.0 - (-TAU * corner / rate).exp();
    }

    /// Advances by a sample.
    pub fn next(&mut self, sample: f32) -> f32 {
        self.level += self.part * (sample - self.level);
        if self.level.abs() < 1e-12 {
            self.level = 0.0;
        }
        self.level
    }
}

/// A band-pass that can be moved while it sounds: the state-variable filter in its trapezoidal form.
#[derive(Clone, Copy, Debug, Default)]
pub struct BandPass {
    first: f32,
    second: f32,
    g: f32,
    k: f32,
}

impl BandPass {
    /// `centre` in Hz; `narrowness` is the centre divided by the bandwidth.
    pub fn set(&mut self, rate: f32, centre: f32, narrowness: f32) {
        // The tangent warps frequencies so that the centre is exact; it has a pole at half the rate.
        self.g = (PI * (centre / rate).min(0.45)).tan();
        self.k = 1.0 / narrowness;
    }

    /// Advances by a sample; the gain at the centre is 1.
    pub fn next(&mut self, sample: f32) -> f32 {
        let a = 1.0 / (1.0 + self.g * (self.g + self.k));
        let band = a * (self.first + self.g * (sample - self.second));
        let low = self.second + self.g * band;
        self.first = 2.0 * band - self.first;
        self.second = 2.0 * low - self.second;
        self.k * band
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RATE: f32 = 48_000.0;

    /// The gain for a sine of that frequency.
    fn gain(hertz: f32, mut filter: impl FnMut(f32) -> f32) -> f32 {
        let mut peak = 0.0_f32;
        for i in 0..48_000 {
            let sample = filter((TAU * hertz * i as f32 / RATE).sin());
            if i > 24_000 {
                peak = peak.max(sample.abs());
            }
        }
        peak
    }

    #[test]
    fn a_low_pass_halves_the_power_at_its_corner() {
        let passes = |hertz| {
            let mut filter = LowPass::default();
            filter.set(RATE, 1000.0);
            gain(hertz, |sample| filter.next(sample))
        };
        assert!(passes(50.0) > 0.99);
        assert!((passes(1000.0) - 0.5_f32.sqrt()).abs() < 0.03);
        assert!(passes(10_000.0) < 0.15);
    }

    #[test]
    fn a_band_pass_passes_its_centre() {
        let passes = |hertz| {
            let mut filter = BandPass::default();
            filter.set(RATE, 800.0, 2.0);
            gain(hertz, |sample| filter.next(sample))
        };
        assert!((passes(800.0) - 1.0).abs() < 0.01);
        assert!(passes(200.0) < 0.2 && passes(3200.0) < 0.2);
    }

    #[test]
    fn a_glide_has_gone_two_thirds_of_the_way_after_its_time() {
        let mut glide = Glide::new(RATE, 0.02);
        for _ in 0..960 {
            glide.towards(1.0);
        }
        assert!((glide.value - 0.632).abs() < 0.01);
    }
}
