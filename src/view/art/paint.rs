//! A small painter of pictures in memory: shapes with smooth edges and textures from a function of the place.

/// Samples a pixel and axis that measure how much of it a shape covers.
const SAMPLES: usize = 2;

/// A picture in straight (not premultiplied) RGBA, row by row from the top.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pixels {
    width: usize,
    height: usize,
    bytes: Vec<u8>,
}

impl Pixels {
    /// A transparent picture. Its hidden colour matters where filtering mixes an edge with what lies beside it.
    pub fn new(width: usize, height: usize, hidden: [u8; 3]) -> Self {
        let [r, g, b] = hidden;
        Self { width, height, bytes: [r, g, b, 0].repeat(width * height) }
    }

    /// `colour` maps a pixel's column and row to its colour.
    pub fn of(width: usize, height: usize, colour: impl Fn(usize, usize) -> [u8; 4]) -> Self {
        let bytes = (0..width * height).flat_map(|i| colour(i % width, i / width)).collect();
        Self { width, height, bytes }
    }

    /// Pixels.
    #[cfg(test)]
    pub const fn size(&self) -> (usize, usize) {
        (self.width, self.height)
    }

    /// Four bytes a pixel.
    pub fn into_bytes(self) -> Vec<u8> {
        self.bytes
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
        for y in 0..self.height {
            for x in 0..self.width {
                let covered = (0..SAMPLES * SAMPLES)
                    .filter(|i| {
                        let sample = |i: usize| (i as f32 + 0.5) / SAMPLES as f32;
                        inside(place(x, sample(i % SAMPLES), self.width), place(y, sample(i / SAMPLES), self.height))
                    })
                    .count();
                if covered > 0 {
                    let cover = covered as f32 / (SAMPLES * SAMPLES) as f32;
                    let colour = colour(place(x, 0.5, self.width), place(y, 0.5, self.height));
                    self.put(x, y, over(self.at(x, y), colour, cover));
                }
            }
        }
    }

    /// The same picture at half the size, each pixel the mean of four weighted by opacity.
    pub fn halved(&self) -> Self {
        Self::of(self.width / 2, self.height / 2, |x, y| {
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
        for row in 0..other.height + 2 * gutter {
            for column in 0..other.width + 2 * gutter {
                self.put(x + column - gutter, y + row - gutter, other.at(pick(column, other.width), pick(row, other.height)));
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shape_covers_its_inside_and_leaves_a_smooth_edge() {
        let mut picture = Pixels::new(16, 16, [0; 3]);
        picture.fill(|x, y| x * x + y * y < 0.64, |_, _| [255, 128, 0]);
        assert_eq!(picture.at(8, 8), [255, 128, 0, 255]);
        assert_eq!(picture.at(0, 0)[3], 0);
        assert!((0..16).any(|x| !matches!(picture.at(x, 8)[3], 0 | 255)), "no pixel is covered in part");
    }

    #[test]
    fn half_the_size_weighs_colours_by_what_they_cover() {
        let picture = Pixels::of(2, 2, |x, _| if x == 0 { [200, 0, 0, 255] } else { [0, 90, 0, 0] });
        assert_eq!(picture.halved().at(0, 0), [200, 0, 0, 128]);
    }

    #[test]
    fn a_tiling_gutter_continues_the_pattern() {
        let tile = Pixels::of(4, 4, |x, _| [x as u8, 0, 0, 255]);
        let mut sheet = Pixels::new(10, 10, [0; 3]);
        sheet.place(&tile, (2, 2), 1, true);
        assert_eq!((sheet.at(1, 3)[0], sheet.at(2, 3)[0], sheet.at(5, 3)[0], sheet.at(6, 3)[0]), (3, 0, 3, 0));
        sheet.place(&tile, (2, 2), 1, false);
        assert_eq!((sheet.at(1, 3)[0], sheet.at(6, 3)[0]), (0, 3));
    }
}
