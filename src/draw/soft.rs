//! Soft edges: one physical pixel fades out around each shape, so that nothing is jagged without multisampling. Outlines become
//! triangles here, without a window.

use super::layout::{Area, Vec2};
use super::shape::{Colour, Contour};
use std::f32::consts::{FRAC_PI_2, TAU};

/// How far, in physical pixels, a curve may stray from the true one.
const FLATNESS: f32 = 0.2;

/// The triangles of a frame; their vectors are used again from shape to shape.
#[derive(Debug, Default)]
pub struct Soft {
    /// Canvas units a physical pixel.
    pixel: f32,
    corners: Vec<Vec2>,
    normals: Vec<Vec2>,
    /// The corners with their colours.
    pub vertices: Vec<(Vec2, Colour)>,
    /// Three a triangle.
    pub indices: Vec<u16>,
}

impl Soft {
    /// `pixel` is canvas units a physical pixel.
    pub const fn begin(&mut self, pixel: f32) {
        self.pixel = pixel;
    }

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
                let point = |i| centre + Vec2::from_angle(TAU * i as f32 / steps as f32) * radius;
                self.corners.extend((0..steps).map(point));
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
        let moved = self.corners.iter().zip(&self.normals).map(|(corner, normal)| (*corner + *normal * by, colour));
        self.vertices.extend(moved);
        first
    }
}

/// Straight pieces for an arc of that radius, physical pixels: the sagitta of each, r(1 − cos(θ/2)), stays within the flatness.
fn steps(radius: f32, angle: f32) -> usize {
    let piece = 2.0 * (1.0 - FLATNESS / radius.max(1.0)).clamp(-1.0, 1.0).acos();
    (angle / piece).ceil() as usize
}

/// Outward unit normals at the corners, longer where the outline turns more, so that an offset keeps its edges parallel.
fn normals(corners: &[Vec2], normals: &mut Vec<Vec2>) {
    let n = corners.len();
    let turn: f32 = (0..n).map(|i| corners[i].perp_dot(corners[(i + 1) % n])).sum();
    let out = if turn >= 0.0 { -1.0 } else { 1.0 };
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
            let mut soft = Soft::default();
            soft.begin(2.0);
            soft.fill(&Contour::Convex(corners.to_vec()), Colour::WHITE);
            let outermost = &soft.vertices[soft.vertices.len() - 4..];
            for (corner, (point, colour)) in corners.iter().zip(outermost) {
                assert_eq!((*point, colour.a), (*corner + (*corner - Vec2::ONE), 0.0));
            }
        }
    }
}
