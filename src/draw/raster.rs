//! The pen of memory: plays a canvas into a picture, without a window. Words are left out, and so are the pictures of files.
//! Soft edges: one physical pixel fades out around each shape, so that nothing is jagged without multisampling.

use super::canvas::Canvas;
use super::layout::{Area, Vec2};
use super::shape::{Colour, Contour, Image, Painting, Quads, Shape};
use std::f32::consts::{FRAC_PI_2, TAU};

/// A corner of a triangle: its place in pixels, its place in a texture (0 … 1) and its colour.
type RasterCorner = (Vec2, Vec2, Colour);

/// A canvas as a picture with opaque pixels, `width` of them across. `sheet` is the image of the game's own pictures.
pub fn paint(canvas: &Canvas, width: usize, ground: Colour, sheet: &Painting) -> Painting {
    let size = canvas.size();
    let scale = width as f32 / size.x;
    let height = (size.y * scale).round() as usize;
    let mut raster = Raster { width, height, scale, parts: [ground.r, ground.g, ground.b].repeat(width * height) };
    let mut soft = Soft { pixel: 1.0 / scale, ..Soft::default() };
    for shape in canvas.shapes().iter() {
        raster.draw(shape, sheet, &mut soft, canvas.frame().pixel);
    }
    let opaque = |part: &[f32]| [part[0], part[1], part[2], 1.0].map(|part| (part * 255.0).round() as u8);
    Painting { width, bytes: raster.parts.chunks(3).flat_map(opaque).collect() }
}

struct Raster {
    width: usize,
    height: usize,
    /// Pixels a canvas unit.
    scale: f32,
    /// Red, green and blue of each pixel.
    parts: Vec<f32>,
}

impl Raster {
    fn draw(&mut self, shape: &Shape, sheet: &Painting, soft: &mut Soft, pixel: f32) {
        let unit = Area::new(0.0, 0.0, 1.0, 1.0).corners();
        match shape {
            Shape::Fill { outline, colour } => {
                soft.fill(outline, *colour);
                self.softly(soft);
            }
            Shape::Edge { outline, width, colour } => {
                soft.edge(outline, *width, *colour);
                self.softly(soft);
            }
            Shape::Rectangle { area, colour } => self.quad((area.corners(), unit, [*colour; 4]), None),
            Shape::RectangleEdge { area, width, colour } => {
                let (outer, inner) = (area.corners(), area.inset(*width).corners());
                for (i, j) in [(0, 1), (1, 2), (2, 3), (3, 0)] {
                    self.quad(([outer[i], outer[j], inner[j], inner[i]], unit, [*colour; 4]), None);
                }
            }
            Shape::Hairline { from, to, colour } => {
                let mut line = Quads::default();
                line.stroke([*from, *to], pixel, [*colour; 2]);
                line.0.iter().for_each(|quad| self.quad((quad.corners, unit, quad.colours), None));
            }
            Shape::Quads(quads) => quads.0.iter().for_each(|quad| self.quad((quad.corners, unit, quad.colours), None)),
            Shape::Textured { image, quads } => {
                let texture = texture(image, sheet);
                quads.iter().for_each(|(quad, places)| self.quad((quad.corners, *places, quad.colours), texture));
            }
            Shape::Picture { image, part, area, turn, tint } => {
                if let Some(texture) = texture(image, sheet) {
                    let (middle, way) = (area.centre(), Vec2::from_angle(*turn));
                    let corners = area.corners().map(|corner| middle + way.rotate(corner - middle));
                    self.quad((corners, part.corners(), [*tint; 4]), Some(texture));
                }
            }
            Shape::Text { .. } | Shape::Layer => {}
        }
    }

    fn softly(&mut self, soft: &Soft) {
        for three in soft.indices.chunks(3) {
            let corners = std::array::from_fn(|i| {
                let (at, colour) = soft.vertices[three[i] as usize];
                (at * self.scale, Vec2::ZERO, colour)
            });
            self.triangle(corners, None);
        }
    }

    fn quad(&mut self, (corners, places, colours): ([Vec2; 4], [Vec2; 4], [Colour; 4]), texture: Option<&Painting>) {
        let [a, b, c, d] = std::array::from_fn(|i| (corners[i] * self.scale, places[i], colours[i]));
        self.triangle([a, b, c], texture);
        self.triangle([a, c, d], texture);
    }

    /// A pixel belongs to a triangle that its middle lies in.
    fn triangle(&mut self, corners: [RasterCorner; 3], texture: Option<&Painting>) {
        let [a, b, c] = corners.map(|corner| corner.0);
        let twice = (b - a).perp_dot(c - a);
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        let cut = |value: f32, most: usize| (value - 0.5).ceil().clamp(0.0, most as f32) as usize;
        let (rows, columns) = (cut(low.y, self.height)..cut(high.y, self.height), cut(low.x, self.width)..cut(high.x, self.width));
        if twice == 0.0 || columns.is_empty() {
            return;
        }
        let mix = |of: &dyn Fn(&RasterCorner) -> f32, weights: [f32; 3]| {
            of(&corners[0]) * weights[0] + of(&corners[1]) * weights[1] + of(&corners[2]) * weights[2]
        };
        for y in rows {
            for x in columns.clone() {
                let at = Vec2::new(x as f32 + 0.5, y as f32 + 0.5);
                let (second, third) = ((at - a).perp_dot(c - a) / twice, (b - a).perp_dot(at - a) / twice);
                let weights = [1.0 - second - third, second, third];
                if weights.into_iter().any(|weight| weight < 0.0) {
                    continue;
                }
                let mut colour = [
                    mix(&|corner| corner.2.r, weights),
                    mix(&|corner| corner.2.g, weights),
                    mix(&|corner| corner.2.b, weights),
                    mix(&|corner| corner.2.a, weights),
                ];
                if let Some(texture) = texture {
                    let texel = texel(texture, Vec2::new(mix(&|corner| corner.1.x, weights), mix(&|corner| corner.1.y, weights)));
                    (0..4).for_each(|i| colour[i] *= texel[i]);
                }
                let first = (y * self.width + x) * 3;
                for (part, over) in self.parts[first..first + 3].iter_mut().zip(colour) {
                    *part += (over - *part) * colour[3];
                }
            }
        }
    }
}

fn texture<'a>(image: &'a Image, sheet: &'a Painting) -> Option<&'a Painting> {
    match image {
        Image::Sheet => Some(sheet),
        Image::Painted(painting) => Some(painting),
        Image::File(_) => None,
    }
}

fn texel(texture: &Painting, place: Vec2) -> [f32; 4] {
    let at = |share: f32, size: usize| ((share * size as f32) as usize).min(size.saturating_sub(1));
    let first = (at(place.y, texture.height()) * texture.width + at(place.x, texture.width)) * 4;
    [0, 1, 2, 3].map(|i| f32::from(texture.bytes.get(first + i).copied().unwrap_or_default()) / 255.0)
}

/// How far, in physical pixels, a curve may stray from the true one.
const FLATNESS: f32 = 0.2;

/// The triangles of a frame; their vectors are used again from shape to shape.
#[derive(Debug, Default)]
pub struct Soft {
    /// Canvas units a physical pixel.
    pub pixel: f32,
    corners: Vec<Vec2>,
    normals: Vec<Vec2>,
    /// The corners with their colours.
    pub vertices: Vec<(Vec2, Colour)>,
    /// Three a triangle.
    pub indices: Vec<u16>,
}

impl Soft {
    pub fn fill(&mut self, outline: &Contour, colour: Colour) {
        self.take(outline);
        let half = self.pixel / 2.0;
        let inner = self.ring(-half, colour);
        for i in 1..self.corners.len() as u16 - 1 {
            self.indices.extend([inner, inner + i, inner + i + 1]);
        }
        self.band([(-half, colour), (half, colour.faded(0.0))]);
    }

    /// The edge is `width` wide and lies inside the outline.
    pub fn edge(&mut self, outline: &Contour, width: f32, colour: Colour) {
        self.take(outline);
        let half = self.pixel / 2.0;
        let width = width.max(2.0 * half);
        let clear = colour.faded(0.0);
        self.band([(-half, colour), (half, clear)]);
        self.band([(half - width, colour), (-half, colour)]);
        self.band([(-half - width, clear), (half - width, colour)]);
    }

    fn take(&mut self, outline: &Contour) {
        self.vertices.clear();
        self.indices.clear();
        self.corners.clear();
        match *outline {
            Contour::Convex(ref corners) => self.corners.extend(corners),
            Contour::Rounded(area, radius) => self.rounded(area, radius),
            Contour::Circle(centre, radius) => {
                let steps = steps(radius / self.pixel, TAU).max(8);
                self.corners.extend((0..steps).map(|i| centre + Vec2::from_angle(TAU * i as f32 / steps as f32) * radius));
            }
            Contour::Line(from, to, width) => {
                let across = (to - from).perp().normalize_or_zero() * (width.max(self.pixel) / 2.0);
                self.corners.extend([from + across, to + across, to - across, from - across]);
            }
        }
        normals(&self.corners, &mut self.normals);
    }

    fn rounded(&mut self, area: Area, radius: f32) {
        let radius = radius.min(area.size.min_element() / 2.0).max(0.0);
        let inner = area.inset(radius);
        let (a, b) = (inner.min, inner.max());
        let centres = [b, Vec2::new(a.x, b.y), a, Vec2::new(b.x, a.y)];
        if radius < self.pixel / 2.0 {
            return self.corners.extend(centres);
        }
        let steps = steps(radius / self.pixel, FRAC_PI_2).max(1);
        for (corner, centre) in centres.into_iter().enumerate() {
            let angle = |i: usize| FRAC_PI_2 * (corner as f32 + i as f32 / steps as f32);
            self.corners.extend((0..=steps).map(|i| centre + Vec2::from_angle(angle(i)) * radius));
        }
    }

    /// A ring of triangles between two offsets of the outline, each with its colour.
    fn band(&mut self, [inner, outer]: [(f32, Colour); 2]) {
        let (a, b) = (self.ring(inner.0, inner.1), self.ring(outer.0, outer.1));
        let n = self.corners.len() as u16;
        for i in 0..n {
            let j = (i + 1) % n;
            self.indices.extend([a + i, a + j, b + j, a + i, b + j, b + i]);
        }
    }

    /// Adds the outline offset outwards by `by`; returns the index of its first corner.
    fn ring(&mut self, by: f32, colour: Colour) -> u16 {
        let first = self.vertices.len() as u16;
        self.vertices.extend(self.corners.iter().zip(&self.normals).map(|(corner, normal)| (*corner + *normal * by, colour)));
        first
    }
}

/// Straight pieces for an arc of that radius, physical pixels: the sagitta of each, r(1 − cos(θ/2)), stays within the flatness.
fn steps(radius: f32, angle: f32) -> usize {
    (angle / (2.0 * (1.0 - FLATNESS / radius.max(1.0)).clamp(-1.0, 1.0).acos())).ceil() as usize
}

/// Outward unit normals at the corners, longer where the outline turns more, so that an offset keeps its edges parallel.
fn normals(corners: &[Vec2], normals: &mut Vec<Vec2>) {
    let n = corners.len();
    let out = if (0..n).map(|i| corners[i].perp_dot(corners[(i + 1) % n])).sum::<f32>() >= 0.0 { -1.0 } else { 1.0 };
    let edge = |i: usize| (corners[(i + 1) % n] - corners[i % n]).perp().normalize_or_zero() * out;
    normals.clear();
    normals.extend((0..n).map(|i| {
        let sum = edge(i) + edge(i + n - 1);
        // A sharp corner's mitre is kept within four widths.
        sum * (2.0 / sum.length_squared().max(0.25))
    }));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_outline_grows_the_same_way_whichever_way_round_it_is_given() {
        let square = [Vec2::new(0.0, 0.0), Vec2::new(2.0, 0.0), Vec2::new(2.0, 2.0), Vec2::new(0.0, 2.0)];
        let mut back = square;
        back.reverse();
        for corners in [square, back] {
            let mut soft = Soft { pixel: 2.0, ..Soft::default() };
            soft.fill(&Contour::Convex(corners.to_vec()), Colour::WHITE);
            let outermost = &soft.vertices[soft.vertices.len() - 4..];
            for (corner, (point, colour)) in corners.iter().zip(outermost) {
                assert_eq!((*point, colour.a), (*corner + (*corner - Vec2::ONE), 0.0));
            }
        }
    }
}
