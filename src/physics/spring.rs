//! The damped spring with a constant force, δ″ = a₀ − K·δ − D·(δ′ − v₀) from δ = 0, δ′ = v₀: its exact flow for K, D ≥ 0 and any time
//! (any text on mechanics; here in forms that lose no digits where K or D is small, or the damping nearly critical).

/// Terms of the power series. Its arguments stay below [`NEAR`], so that what is left out is below one rounding; and how many do where D·t and
/// √K·t are below 0.1 and 0.01.
const TERMS: usize = 20;
const FEWER: usize = 12;
const FEW: usize = 9;
/// What each term is divided by, times that of the one before it: a division takes as long as the rest of a term.
const DIVIDED: [[f64; 2]; TERMS] = {
    let mut parts = [[0.0; 2]; TERMS];
    let mut n = 2;
    while n < TERMS {
        parts[n] = [1.0 / (n * (n - 1)) as f64, 1.0 / n as f64];
        n += 1;
    }
    parts
};
/// D·t and K·t² up to which the series is used.
const NEAR: f64 = 0.5;
/// K·t/D below which the spring is a correction of first order to damping alone: its square is left out.
const SLACK: f64 = 1e-6;

/// δ (m) and δ′ (m/s) after `t` seconds.
pub(super) fn spring(v0: f64, a0: f64, damping: f64, stiffness: f64, t: f64) -> (f64, f64) {
    if damping * t < NEAR && stiffness * t * t < NEAR {
        return series(v0, a0, damping, stiffness, t);
    }
    // g answers to an impulse, g″ + D·g′ + K·g = 0, g(0) = 0, g′(0) = 1; G is its integral.
    let half = 0.5 * damping;
    let square = half * half - stiffness;
    let (g, slope) = if square < 0.0 {
        let turn = (-square).sqrt();
        let fading = libm::exp(-half * t);
        let (sine, cosine) = (libm::sin(turn * t) / turn, libm::cos(turn * t));
        (fading * sine, fading * (cosine - half * sine))
    } else {
        let root = square.sqrt();
        let slow = stiffness / (half + root);
        let (lasting, gone) = (libm::exp(-slow * t), -libm::expm1(-2.0 * root * t));
        let g = if root * t > 1e-8 { lasting * gone / (2.0 * root) } else { lasting * t };
        (g, lasting * (1.0 - gone) - slow * g)
    };
    let sum = if stiffness * t > SLACK * damping {
        (1.0 - slope - damping * g) / stiffness
    } else {
        let free = (t - g) / damping;
        free - stiffness * (0.5 * t * t - free) / (damping * damping)
    };
    let force = a0 + damping * v0;
    (v0 * g + force * sum, v0 * slope + force * g)
}

fn series(v0: f64, a0: f64, damping: f64, stiffness: f64, t: f64) -> (f64, f64) {
    // Terms cₙ·tⁿ of δ: each follows from the two before it.
    let (mut before, mut last) = (v0 * t, 0.5 * a0 * t * t);
    let (mut way, mut speed) = (before + last, before + 2.0 * last);
    let (damping, stiffness) = (damping * t, stiffness * t * t);
    let square = stiffness.max(damping * damping);
    let terms = if square < 1e-4 {
        FEW
    } else if square < 1e-2 {
        FEWER
    } else {
        TERMS
    };
    for (n, [both, one]) in DIVIDED[..terms].iter().enumerate().skip(3) {
        let next = -(stiffness * before * both + damping * last * one);
        (before, last) = (last, next);
        way += next;
        speed += n as f64 * next;
    }
    (way, speed / t)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against many short series, over all kinds of damping.
    #[test]
    fn all_its_forms_agree() {
        for damping in [0.0, 1e-9, 0.3, 2.0, 19.999_999, 20.0, 20.000_001, 50.0, 3000.0] {
            for stiffness in [0.0, 1e-9, 1e-4, 0.4, 100.0, 1e4] {
                let (v0, a0, t) = (3.0, -7.0, 0.8);
                let (found, speed) = spring(v0, a0, damping, stiffness, t);
                let (mut x, mut v, parts) = (0.0, v0, 20_000);
                for _ in 0..parts {
                    let a = a0 - stiffness * x - damping * (v - v0);
                    let (dx, u) = series(v, a, damping, stiffness, t / f64::from(parts));
                    (x, v) = (x + dx, u);
                }
                let scale = x.abs().max(1e-3);
                assert!((found - x).abs() < 1e-9 * scale, "D {damping}, K {stiffness}: {found}, not {x}");
                assert!((speed - v).abs() < 1e-8 * v0, "D {damping}, K {stiffness}: {speed}, not {v}");
            }
        }
    }

    #[test]
    fn without_damping_it_keeps_its_energy() {
        let (stiffness, mut x, mut v) = (225.0, 0.0, 1.5f64);
        for _ in 0..100_000 {
            let (dx, u) = spring(v, -stiffness * x, 0.0, stiffness, 1.0 / 17.0);
            (x, v) = (x + dx, u);
        }
        assert!(((v * v + stiffness * x * x) / 2.25 - 1.0).abs() < 1e-10);
    }
}
