//! The faces of rock, one a world, and the earth: painted once, each from functions of the place.

use super::paint::noise;
use crate::draw::{Image, Painting};
use crate::level::Landscape;
use std::array::from_fn;
use std::sync::{Arc, LazyLock};

/// Metres that a face covers before it repeats, and its width and height, pixels.
pub const FACE_METRES: f64 = 16.0;
const SIDE: usize = 512;

static FACES: [LazyLock<Image>; 5] = [
    LazyLock::new(|| face(panels)),
    LazyLock::new(|| face(strata)),
    LazyLock::new(|| face(ashlar)),
    LazyLock::new(|| face(boulders)),
    LazyLock::new(|| face(craters)),
];
/// Its disc has the radius of half the picture's width over [`AIR`].
pub static EARTH: LazyLock<Image> =
    LazyLock::new(|| Image::Painted(Arc::new(painted(|x, y| earth([x, y].map(|v| (v - 0.5) * 2.0 * AIR))))));

/// Grey, to be multiplied by the light on the rock.
pub fn face_of(landscape: Landscape) -> &'static Image {
    &FACES[landscape as usize]
}

/// `colour` maps a place, 0 … 1 across and down, to straight RGBA of 0 … 1.
fn painted(colour: impl Fn(f32, f32) -> [f32; 4]) -> Painting {
    let at = |i: usize| (i as f32 + 0.5) / SIDE as f32;
    let bytes =
        (0..SIDE * SIDE).flat_map(|i| colour(at(i % SIDE), at(i / SIDE)).map(|c| (c * 255.0).round().clamp(0.0, 255.0) as u8));
    Painting { width: SIDE, bytes: bytes.collect() }
}

fn face(grey: fn(f32, f32) -> f32) -> Image {
    Image::Painted(Arc::new(painted(|x, y| {
        let grey = grey(x, y).clamp(0.35, 1.0);
        [grey, grey, grey, 1.0]
    })))
}

fn smooth(t: f32) -> f32 {
    let t = t.clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// A smooth field of −1 … 1 with that many cells across, which repeats after 1.
fn field(x: f32, y: f32, cells: usize, seed: u32) -> f32 {
    let (x, y) = (x.rem_euclid(1.0) * cells as f32, y.rem_euclid(1.0) * cells as f32);
    let (i, j) = (x as usize, y as usize);
    let (u, v) = (smooth(x.fract()), smooth(y.fract()));
    let at = |di: usize, dj: usize| noise((i + di) % cells, (j + dj) % cells, seed);
    let row = |dj: usize| at(0, dj) + (at(1, dj) - at(0, dj)) * u;
    2.0 * (row(0) + (row(1) - row(0)) * v) - 1.0
}

/// Fields of ever finer cells, each half as strong as the one before.
fn cloudy(x: f32, y: f32, cells: usize, seed: u32) -> f32 {
    (0..4).map(|octave| field(x, y, cells << octave, seed + octave) * 0.5_f32.powi(octave as i32 + 1)).sum()
}

/// A wall of `rows` courses of blocks, each `across` of a course wide: distances (m) to a block's left, top, right and bottom edge; its own number.
fn course(x: f32, y: f32, rows: usize, across: f32) -> ([f32; 4], f32) {
    let row = (y * rows as f32) as usize;
    let along = (x + if row % 2 == 1 { across / 2.0 } else { 0.0 }).rem_euclid(1.0) / across;
    let metres = FACE_METRES as f32;
    let (left, top) = (along.fract() * across * metres, (y * rows as f32).fract() / rows as f32 * metres);
    ([left, top, across * metres - left, metres / rows as f32 - top], noise(along as usize, row, 60 + rows as u32))
}

fn panels(x: f32, y: f32) -> f32 {
    let (edges, own) = course(x, y, 8, 0.25);
    let seam = edges.into_iter().fold(1.0_f32, f32::min);
    let bolt = (edges[0].min(edges[2]) - 0.3).hypot(edges[1].min(edges[3]) - 0.3) < 0.07;
    let streaks = field(x, y / 16.0, 64, 61) * 0.06 + field(x, y / 4.0, 128, 62) * 0.03;
    let worn = cloudy(x, y, 6, 63) * 0.12;
    0.80 + own * 0.08 + streaks + worn - 0.30 * (1.0 - seam / 0.06).max(0.0) + if edges[1] < 0.12 { 0.06 } else { 0.0 }
        - if bolt { 0.22 } else { 0.0 }
}

fn strata(x: f32, y: f32) -> f32 {
    let bent = y + 0.035 * cloudy(x, y, 3, 64) + 0.012 * field(x, y, 8, 65);
    let layer = bent.rem_euclid(1.0) * 16.0;
    let (own, inside) = (noise(layer as usize % 16, 3, 66), layer.fract());
    let line = (1.0 - inside.min(1.0 - inside) / 0.07).max(0.0);
    let fine = (inside * 5.0).fract();
    let (gap, _, _) = stones(x, y, 7, 67);
    let crack = (1.0 - gap / 0.035).max(0.0) * (own - 0.35).max(0.0);
    0.74 + own * 0.16 + cloudy(x, y * 3.0, 8, 68) * 0.20 - 0.30 * line - 0.07 * (1.0 - fine / 0.3).max(0.0) - 0.5 * crack
        + 0.10 * (1.0 - (inside - 0.14).abs() / 0.08).max(0.0)
}

fn ashlar(x: f32, y: f32) -> f32 {
    let (edges, own) = course(x, y, 16, 0.125);
    let near = |edge: f32| (1.0 - edge / 0.13).max(0.0);
    let joint = edges.into_iter().fold(1.0_f32, f32::min);
    0.70 + own * 0.18 + cloudy(x, y, 24, 69) * 0.22 + 0.16 * near(edges[1]).max(near(edges[0]) * 0.7)
        - 0.22 * near(edges[3]).max(near(edges[2]) * 0.7)
        - if joint < 0.035 { 0.25 } else { 0.0 }
}

/// The nearest of stones strewn over cells: half the gap to the next one, in cells, the way from its middle, and a number of its own.
fn stones(x: f32, y: f32, cells: usize, seed: u32) -> (f32, [f32; 2], f32) {
    let (x, y) = (x * cells as f32, y * cells as f32);
    let (mut first, mut second) = ((f32::MAX, [0.0; 2], 0.0), f32::MAX);
    for i in -1..=1_i32 {
        for j in -1..=1_i32 {
            let cell = [(x as i32 + i), (y as i32 + j)];
            let [a, b] = cell.map(|c| c.rem_euclid(cells as i32) as usize);
            let way = [x - cell[0] as f32 - 0.1 - 0.8 * noise(a, b, seed), y - cell[1] as f32 - 0.1 - 0.8 * noise(a, b, seed + 1)];
            let distance = way[0].hypot(way[1]);
            if distance < first.0 {
                second = first.0;
                first = (distance, way, noise(a, b, seed + 2));
            } else {
                second = second.min(distance);
            }
        }
    }
    ((second - first.0) / 2.0, first.1, first.2)
}

fn boulders(x: f32, y: f32) -> f32 {
    let (gap, way, own) = stones(x + 0.01 * cloudy(x, y, 8, 70), y + 0.01 * cloudy(y, x, 8, 71), 11, 72);
    let round = smooth(gap / 0.28);
    let slope = -(way[0] * 0.5 + way[1]) * (1.0 - round);
    0.58 + own * 0.14 + 0.20 * round + 0.34 * slope + cloudy(x, y, 16, 73) * 0.20 - 0.35 * (1.0 - gap / 0.05).max(0.0)
}

fn craters(x: f32, y: f32) -> f32 {
    let dent = |cells: usize, seed: u32, deep: f32| {
        let (_, way, own) = stones(x, y, cells, seed);
        let reach = 0.16 + 0.26 * own;
        let (out, facing) = (way[0].hypot(way[1]) / reach, (way[0] + way[1]) / (way[0].hypot(way[1]) + 1e-3) * 0.7);
        let bowl = smooth(out) * (1.0 - smooth((out - 0.85) * 6.0));
        deep * (facing * bowl * 0.9 - facing * (1.0 - (out - 1.08).abs() / 0.14).max(0.0) * 0.6 - 0.25 * (1.0 - smooth(out * 1.1)))
    };
    0.74 + cloudy(x, y, 5, 74) * 0.26 + cloudy(x, y, 40, 75) * 0.10 + dent(4, 76, 0.30) + dent(9, 79, 0.24) + dent(21, 82, 0.16)
}

/// The reach of the earth's air, in radii of the earth.
pub const AIR: f32 = 1.26;

/// At a place in radii of the earth from its middle. The sun stands on the left, above, and a little in front.
fn earth([x, y]: [f32; 2]) -> [f32; 4] {
    const SUN: [f32; 3] = [-0.78, -0.36, 0.51];
    /// All of it is this dim: it lies behind a flight.
    const DIM: f32 = 0.62;
    let out = x.hypot(y);
    let mix = |a: [f32; 3], b: [f32; 3], t: f32| -> [f32; 3] { from_fn(|i| a[i] + (b[i] - a[i]) * t.clamp(0.0, 1.0)) };
    let air = [0.36, 0.60, 0.86];
    if out >= 1.0 {
        let day = smooth((x * SUN[0] + y * SUN[1]) / out * 0.9 + 0.35);
        return [air[0], air[1], air[2], 0.50 * day * ((AIR - out) / (AIR - 1.0)).max(0.0).powi(4)];
    }
    let z = (1.0 - out * out).sqrt();
    let day = x * SUN[0] + y * SUN[1] + z * SUN[2];
    // Flattened onto a square that turns with the sphere's limb.
    let (u, v) = ((x / (0.35 + z)).atan() / 3.0 + 0.43, (y / (0.35 + z)).atan() / 3.0 + 0.37);
    let land = smooth((cloudy(u, v, 3, 90) + 0.25 * field(u, v, 48, 94) - 0.10) * 16.0);
    let ground = mix([0.16, 0.21, 0.13], [0.33, 0.25, 0.15], cloudy(u, v, 10, 95) + 0.5);
    let surface = mix([0.028, 0.10, 0.20], ground, land);
    let torn = cloudy(u + 0.16 * cloudy(u, v, 4, 99), v * 2.2, 5, 101) + 0.35 * cloudy(u, v * 2.2, 22, 105);
    let cloud = smooth((torn - 0.04) * 3.4) * 0.66;
    let lit = mix(mix(surface, [0.72, 0.76, 0.80], cloud), air, 0.50 * out.powi(8));
    let sunlit = smooth(day * 1.7 + 0.22);
    let lamp = land * (1.0 - cloud) * f32::from(u8::from(noise((u * 1500.0) as usize, (v * 1500.0) as usize, 109) > 0.985));
    let night = [0.010 + 0.50 * lamp, 0.014 + 0.36 * lamp, 0.022 + 0.14 * lamp];
    let [r, g, b] = mix(night, lit, sunlit).map(|part| part * DIM);
    // The rim is covered in part.
    [r, g, b, ((1.0 - out) * SIDE as f32 / 2.0 / AIR + 0.5).clamp(0.0, 1.0)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_face_of_rock_repeats_without_a_step_and_keeps_its_lightness() {
        for (i, grey) in [panels, strata, ashlar, boulders, craters].into_iter().enumerate() {
            let places = || (0..64).flat_map(|a| (0..64).map(move |b| [a, b].map(|v| (v as f32 + 0.5) / 64.0)));
            let mean = places().map(|[x, y]| grey(x, y).clamp(0.35, 1.0)).sum::<f32>() / 4096.0;
            assert!((0.66..0.88).contains(&mean), "face {i} has a mean of {mean}");
            let step = |from: f32, to: f32| {
                (0..256).map(|k| (grey(from, k as f32 / 256.0) - grey(to, k as f32 / 256.0)).abs()).sum::<f32>() / 256.0
            };
            assert!(step(0.9995, 0.0005) < step(0.4995, 0.5005) + 0.05, "face {i}");
        }
    }
}
