//! A small painter of pictures in memory: shapes with smooth edges and textures from a function of the place.
//! The materials as square patterns that tile, and the two movable plain shapes: all slate, each with a texture of its own.

use crate::draw::Painting;

/// Samples a pixel and axis that measure how much of it a shape covers.
const SAMPLES: usize = 2;

impl Painting {
    /// A transparent picture. Its hidden colour matters where filtering mixes an edge with what lies beside it.
    pub fn new(width: usize, height: usize, hidden: [u8; 3]) -> Self {
        let [r, g, b] = hidden;
        Self { width, bytes: [r, g, b, 0].repeat(width * height) }
    }

    /// `colour` maps a pixel's column and row to its colour, in straight (not premultiplied) RGBA.
    pub fn of(width: usize, height: usize, colour: impl Fn(usize, usize) -> [u8; 4]) -> Self {
        Self { width, bytes: (0..width * height).flat_map(|i| colour(i % width, i / width)).collect() }
    }

    pub fn at(&self, x: usize, y: usize) -> [u8; 4] {
        let i = (y * self.width + x) * 4;
        [self.bytes[i], self.bytes[i + 1], self.bytes[i + 2], self.bytes[i + 3]]
    }

    fn put(&mut self, x: usize, y: usize, colour: [u8; 4]) {
        let i = (y * self.width + x) * 4;
        self.bytes[i..i + 4].copy_from_slice(&colour);
    }

    /// Paints each place in `inside`, −1 to 1 across and down the picture, with its `colour`.
    pub fn fill(&mut self, inside: impl Fn(f32, f32) -> bool, colour: impl Fn(f32, f32) -> [u8; 3]) {
        let place = |pixel: usize, sample: f32, size: usize| (pixel as f32 + sample) / size as f32 * 2.0 - 1.0;
        let height = self.height();
        for y in 0..height {
            for x in 0..self.width {
                let covered = (0..SAMPLES * SAMPLES)
                    .filter(|i| {
                        let sample = |i: usize| (i as f32 + 0.5) / SAMPLES as f32;
                        inside(place(x, sample(i % SAMPLES), self.width), place(y, sample(i / SAMPLES), height))
                    })
                    .count();
                if covered > 0 {
                    let cover = covered as f32 / (SAMPLES * SAMPLES) as f32;
                    self.put(x, y, over(self.at(x, y), colour(place(x, 0.5, self.width), place(y, 0.5, height)), cover));
                }
            }
        }
    }

    /// The same picture at half the size, each pixel the mean of four weighted by opacity.
    pub fn halved(&self) -> Self {
        Self::of(self.width / 2, self.height() / 2, |x, y| {
            let four = [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(dx, dy)| self.at(2 * x + dx, 2 * y + dy).map(f32::from));
            let cover: f32 = four.iter().map(|p| p[3]).sum();
            let mean = |c: usize| if cover > 0.0 { four.iter().map(|p| p[c] * p[3]).sum::<f32>() / cover } else { four[0][c] };
            [mean(0), mean(1), mean(2), cover / 4.0].map(|c| c.round() as u8)
        })
    }

    /// Copies another picture into this one, its top left corner at (x, y), with its outermost pixels repeated (or, for a pattern
    /// that tiles, continued) `gutter` pixels further out, so that filtering at its edge finds the right neighbours.
    pub fn place(&mut self, other: &Self, (x, y): (usize, usize), gutter: usize, tiles: bool) {
        let pick = |i: usize, size: usize| {
            let i = i as isize - gutter as isize;
            if tiles { i.rem_euclid(size as isize) as usize } else { i.clamp(0, size as isize - 1) as usize }
        };
        let height = other.height();
        for row in 0..height + 2 * gutter {
            for column in 0..other.width + 2 * gutter {
                self.put(x + column - gutter, y + row - gutter, other.at(pick(column, other.width), pick(row, height)));
            }
        }
    }
}

/// `colour` painted over a pixel with that cover (0 … 1).
fn over(under: [u8; 4], colour: [u8; 3], cover: f32) -> [u8; 4] {
    let below = f32::from(under[3]) / 255.0 * (1.0 - cover);
    let alpha = cover + below;
    let mix = |a: u8, b: u8| ((f32::from(a) * cover + f32::from(b) * below) / alpha).round() as u8;
    [mix(colour[0], under[0]), mix(colour[1], under[1]), mix(colour[2], under[2]), (alpha * 255.0).round() as u8]
}

/// A hash of the place, 0 to 1: the same on every run.
pub fn noise(x: usize, y: usize, seed: u32) -> f32 {
    let mut h = (x as u32).wrapping_mul(0x9E37_79B1) ^ (y as u32).wrapping_mul(0x85EB_CA77) ^ seed.wrapping_mul(0xC2B2_AE3D);
    h = (h ^ (h >> 15)).wrapping_mul(0x2C1B_3C6D);
    h = (h ^ (h >> 12)).wrapping_mul(0x297A_2D39);
    (h ^ (h >> 15)) as f32 / u32::MAX as f32
}

/// Metres that a pattern covers before it repeats.
pub const TILE_METRES: f64 = 4.0;
/// Width and height of a pattern, pixels: 48 a metre.
pub const SIZE: usize = 192;

type Rgb = [f32; 3];

/// The pattern of a material's name; asphalt for a name without a pattern.
pub fn pattern(material: &str) -> Painting {
    match material {
        "Steel" => steel(),
        "Ice" => ice(),
        "Rubber" => rubber(),
        "Wood" => wood(),
        "Glass" => glass(),
        "Trampoline" => trampoline(),
        _ => asphalt(),
    }
}

fn painted(colour: impl Fn(usize, usize) -> Rgb) -> Painting {
    Painting::of(SIZE, SIZE, |x, y| {
        let [r, g, b] = colour(x, y).map(|c| c.round().clamp(0.0, 255.0) as u8);
        [r, g, b, 255]
    })
}

fn light(colour: Rgb, by: f32) -> Rgb {
    colour.map(|c| c + by)
}

fn asphalt() -> Painting {
    painted(|x, y| {
        let speckle = |cell: usize, seed: u32, share: f32, by: f32| {
            let (cx, cy) = (x / cell, y / cell);
            let n = noise(cx, cy, seed);
            let (dx, dy) = ((x % cell) as f32 + 0.5 - cell as f32 * 0.5, (y % cell) as f32 + 0.5 - cell as f32 * 0.5);
            if n < share && dx * dx + dy * dy < (cell * cell) as f32 * 0.12 { by * (0.5 + noise(cx, cy, seed + 7)) } else { 0.0 }
        };
        let grain = (noise(x / 2, y / 2, 1) - 0.5) * 5.0;
        light([58.0, 68.0, 86.0], grain + speckle(8, 2, 0.20, 18.0) + speckle(6, 3, 0.18, -16.0) + speckle(12, 4, 0.10, 13.0))
    })
}

fn steel() -> Painting {
    painted(|x, y| {
        let plate = SIZE / 2;
        let (px, py) = (x % plate, y % plate);
        let brush = (noise(x / 24, y, 11) - 0.5) * 9.0 + (noise(x / 7, y, 12) - 0.5) * 5.0;
        let seam = match px.min(py) {
            0 => -26.0,
            1 => 14.0,
            _ => 0.0,
        };
        let near = |p: usize| p.min(plate - p) as f32 - 11.0;
        let (dx, dy) = (near(px), near(py));
        let rivet = match dx.hypot(dy) {
            d if d < 4.2 => 30.0 - 6.0 * (d - 1.0).max(0.0) - if (px > plate / 2) ^ (dx < 0.0) { 6.0 } else { 0.0 },
            d if d < 5.6 => -20.0,
            _ => 0.0,
        };
        light([72.0, 86.0, 106.0], brush + seam + rivet)
    })
}

fn ice() -> Painting {
    painted(|x, y| {
        let slant = (x + SIZE - y) % SIZE;
        let glint = match slant % 64 {
            0..=3 => 30.0,
            9..=10 => 22.0,
            _ => 0.0,
        } * if noise(slant / 64, (x + y) % SIZE / 48, 21) > 0.45 { 1.0 } else { 0.0 };
        light([128.0, 163.0, 188.0], (noise(x / 16, y / 16, 22) - 0.5) * 6.0 + glint)
    })
}

fn rubber() -> Painting {
    painted(|x, y| {
        let chevron = if (y + 48 - (x % 48).abs_diff(24)) % 24 < 8 { 15.0 } else { 0.0 };
        light([34.0, 38.0, 47.0], chevron + (noise(x, y, 31) - 0.5) * 3.0)
    })
}

fn trampoline() -> Painting {
    painted(|x, y| {
        let spring = if (y + 32 - (x % 32).abs_diff(16)) % 32 < 5 { 46.0 } else { 0.0 };
        light([92.0, 58.0, 84.0], spring + (noise(x / 2, y / 2, 51) - 0.5) * 5.0)
    })
}

fn wood() -> Painting {
    painted(|x, y| {
        let plank = y / 24;
        let (py, joint) = (y % 24, (x + (noise(plank, 0, 41) * SIZE as f32) as usize) % SIZE);
        let bow = (std::f32::consts::TAU * (x as f32 / SIZE as f32 + noise(plank, 1, 42))).sin() * 2.2;
        let grain = (noise(plank, ((py as f32 + bow) * 0.45).max(0.0) as usize, 43) - 0.5) * 17.0;
        let seam = if py == 0 || joint < 2 { -24.0 } else { (noise(plank, 2, 44) - 0.5) * 9.0 };
        light([101.0, 81.0, 66.0], grain + seam)
    })
}

/// Thin and bright: mostly clear, with streaks of light; the bright edge is drawn by the world.
fn glass() -> Painting {
    Painting::of(SIZE, SIZE, |x, y| match (x + y) % 96 {
        0..=11 => [220, 240, 255, 92],
        18..=21 => [220, 240, 255, 72],
        _ => [150, 200, 226, 46],
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::Material;

    #[test]
    fn a_shape_covers_its_inside_and_leaves_a_smooth_edge() {
        let mut picture = Painting::new(16, 16, [0; 3]);
        picture.fill(|x, y| x * x + y * y < 0.64, |_, _| [255, 128, 0]);
        assert_eq!(picture.at(8, 8), [255, 128, 0, 255]);
        assert_eq!(picture.at(0, 0)[3], 0);
        assert!((0..16).any(|x| !matches!(picture.at(x, 8)[3], 0 | 255)), "no pixel is covered in part");
    }

    #[test]
    fn half_the_size_weighs_colours_by_what_they_cover() {
        let picture = Painting::of(2, 2, |x, _| if x == 0 { [200, 0, 0, 255] } else { [0, 90, 0, 0] });
        assert_eq!(picture.halved().at(0, 0), [200, 0, 0, 128]);
    }

    #[test]
    fn a_tiling_gutter_continues_the_pattern() {
        let tile = Painting::of(4, 4, |x, _| [x as u8, 0, 0, 255]);
        let mut sheet = Painting::new(10, 10, [0; 3]);
        sheet.place(&tile, (2, 2), 1, true);
        assert_eq!((sheet.at(1, 3)[0], sheet.at(2, 3)[0], sheet.at(5, 3)[0], sheet.at(6, 3)[0]), (3, 0, 3, 0));
        sheet.place(&tile, (2, 2), 1, false);
        assert_eq!((sheet.at(1, 3)[0], sheet.at(6, 3)[0]), (0, 3));
    }

    /// Mean brightness and its spread: a material has to differ from every other one clearly in at least one of the two, or in hue.
    #[test]
    fn no_two_materials_look_the_same() {
        let facts = |name: &str| {
            let picture = pattern(name);
            let pixels: Vec<[f32; 4]> = (0..SIZE * SIZE).map(|i| picture.at(i % SIZE, i / SIZE).map(f32::from)).collect();
            let mean = |c: usize| pixels.iter().map(|p| p[c]).sum::<f32>() / pixels.len() as f32;
            [mean(0), mean(1), mean(2), mean(3)]
        };
        let all: Vec<_> = Material::ALL.iter().map(|m| (m.name, facts(m.name))).collect();
        for (i, (a, fa)) in all.iter().enumerate() {
            for (b, fb) in &all[i + 1..] {
                let apart: f32 = fa.iter().zip(fb).map(|(x, y)| (x - y).abs()).sum();
                assert!(apart > 25.0, "{a} and {b} are only {apart} apart");
            }
        }
    }

    #[test]
    fn patterns_tile_without_a_step() {
        for material in Material::ALL.iter().filter(|m| m.name == "Glass" || m.name == "Rubber") {
            let picture = pattern(material.name);
            // Both repeat with a period that divides the tile: column 0 continues the last one as column 96 continues 95.
            let step =
                |a: usize, b: usize| (0..SIZE).map(|y| u32::from(picture.at(a, y)[0].abs_diff(picture.at(b, y)[0]))).sum::<u32>();
            assert!(step(SIZE - 1, 0) <= step(95, 96) + 400, "{}", material.name);
        }
    }
}
