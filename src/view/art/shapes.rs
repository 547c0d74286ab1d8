//! Small pictures that the canvas tints: soft discs and glows, the flame, the hatching of death boxes.

use super::paint::Pixels;

/// A white disc with a soft edge, for particles.
pub fn disc(size: usize) -> Pixels {
    radial(size, |r| (1.0 - r).clamp(0.0, 0.25) * 4.0)
}

/// A white light that falls off smoothly to nothing at the rim.
pub fn glow(size: usize) -> Pixels {
    radial(size, |r| (1.0 - r).max(0.0).powi(2))
}

/// Maps the distance from the middle (1 at the rim) to alpha.
fn radial(size: usize, alpha: impl Fn(f32) -> f32) -> Pixels {
    Pixels::of(size, size, |x, y| {
        let from = |p: usize| (p as f32 + 0.5) / size as f32 * 2.0 - 1.0;
        [255, 255, 255, (alpha(from(x).hypot(from(y))) * 255.0).round() as u8]
    })
}

/// The engine's flame, its root at the top: white hot in the middle, orange at the rim, gone at the end.
pub fn flame(width: usize, height: usize) -> Pixels {
    Pixels::of(width, height, |x, y| {
        let (u, v) = ((x as f32 + 0.5) / width as f32 * 2.0 - 1.0, (y as f32 + 0.5) / height as f32);
        let half = 0.55 * (1.0 - v).powf(0.7) * (0.75 + 1.6 * v * (1.0 - v));
        let inside = 1.0 - u.abs() / half.max(1e-3);
        let alpha = (inside * 2.5).clamp(0.0, 1.0) * (1.0 - v).powf(0.6);
        let hot = (inside * 1.5 - v * 0.9).clamp(0.0, 1.0);
        [255, (150.0 + 100.0 * hot) as u8, (28.0 + 200.0 * hot * hot) as u8, (alpha * 255.0) as u8]
    })
}

/// Slanting red stripes with dark ones between; tiles.
pub fn hatching(size: usize) -> Pixels {
    Pixels::of(size, size, |x, y| {
        let period = size / 8;
        let across = (x + y) % period;
        // The stripe's two edges are blended over a pixel.
        let edge = (across.min(period / 2).min(period - across) as f32).min(1.0);
        let inside = if across < period / 2 { 0.5 + 0.5 * edge } else { 0.5 - 0.5 * edge };
        let mix = |dark: f32, bright: f32| (dark + (bright - dark) * inside) as u8;
        [mix(70.0, 226.0), mix(16.0, 60.0), mix(26.0, 68.0), 255]
    })
}
