//! Shapes with soft edges: one physical pixel fades out around each, so that nothing is jagged without multisampling.

use super::canvas::Canvas;
use super::layout::{Area, Vec2};
use super::theme::faded;
use macroquad::color::Color;
use macroquad::models::{Mesh, Vertex, draw_mesh};
use macroquad::shapes::draw_line;
use std::f32::consts::{FRAC_PI_2, TAU};

/// How far, in physical pixels, a curve may stray from the true one.
const FLATNESS: f32 = 0.2;

impl Canvas {
    /// A filled convex outline (its corners in order, either way round).
    pub fn convex(&self, corners: &[Vec2], colour: Color) {
        if corners.len() < 3 {
            return;
        }
        let mut mesh = Soft::default();
        let normals = normals(corners);
        let half = self.frame().pixel / 2.0;
        mesh.fan(&offset(corners, &normals, -half), colour);
        mesh.band(&offset(corners, &normals, -half), colour, &offset(corners, &normals, half), faded(colour, 0.0));
        mesh.draw();
    }

    /// The outline of convex corners, `width` wide, inside them.
    pub fn convex_edge(&self, corners: &[Vec2], width: f32, colour: Color) {
        if corners.len() < 3 {
            return;
        }
        let normals = normals(corners);
        let half = self.frame().pixel / 2.0;
        let width = width.max(2.0 * half);
        let clear = faded(colour, 0.0);
        let rings = [half, -half, half - width, -half - width].map(|by| offset(corners, &normals, by));
        let mut mesh = Soft::default();
        mesh.band(&rings[1], colour, &rings[0], clear);
        mesh.band(&rings[2], colour, &rings[1], colour);
        mesh.band(&rings[3], clear, &rings[2], colour);
        mesh.draw();
    }

    /// A filled box with round corners.
    pub fn rounded(&self, area: Area, radius: f32, colour: Color) {
        self.convex(&self.rounded_outline(area, radius), colour);
    }

    /// The edge of a box with round corners, inside it.
    pub fn rounded_edge(&self, area: Area, radius: f32, width: f32, colour: Color) {
        self.convex_edge(&self.rounded_outline(area, radius), width, colour);
    }

    /// A filled circle.
    pub fn disc(&self, centre: Vec2, radius: f32, colour: Color) {
        self.convex(&self.circle_outline(centre, radius), colour);
    }

    /// A circle's edge, inside it.
    pub fn ring(&self, centre: Vec2, radius: f32, width: f32, colour: Color) {
        self.convex_edge(&self.circle_outline(centre, radius), width, colour);
    }

    /// A straight line with blunt ends.
    pub fn line(&self, from: Vec2, to: Vec2, width: f32, colour: Color) {
        let across = (to - from).perp().normalize_or_zero() * (width.max(self.frame().pixel) / 2.0);
        self.convex(&[from + across, to + across, to - across, from - across], colour);
    }

    /// A line along an axis, one physical pixel wide and exactly on one.
    pub fn hairline(&self, from: Vec2, to: Vec2, colour: Color) {
        let pixel = self.frame().pixel;
        let snapped = |point: Vec2| ((point / pixel).floor() + 0.5) * pixel;
        let (from, to) = (snapped(from), snapped(to));
        draw_line(from.x, from.y, to.x, to.y, pixel, colour);
    }

    fn circle_outline(&self, centre: Vec2, radius: f32) -> Vec<Vec2> {
        let steps = self.steps(radius, TAU).max(8);
        (0..steps).map(|i| centre + Vec2::from_angle(TAU * i as f32 / steps as f32) * radius).collect()
    }

    fn rounded_outline(&self, area: Area, radius: f32) -> Vec<Vec2> {
        let radius = radius.min(area.size.min_element() / 2.0).max(0.0);
        let inner = area.inset(radius);
        let (a, b) = (inner.min, inner.max());
        if radius < self.frame().pixel / 2.0 {
            return vec![b, Vec2::new(a.x, b.y), a, Vec2::new(b.x, a.y)];
        }
        let steps = self.steps(radius, FRAC_PI_2).max(1);
        [b, Vec2::new(a.x, b.y), a, Vec2::new(b.x, a.y)]
            .into_iter()
            .enumerate()
            .flat_map(|(corner, centre)| {
                (0..=steps).map(move |i| {
                    let angle = FRAC_PI_2 * (corner as f32 + i as f32 / steps as f32);
                    centre + Vec2::from_angle(angle) * radius
                })
            })
            .collect()
    }

    /// Straight pieces for an arc: the sagitta of each, r(1 − cos(θ/2)), stays within the flatness.
    fn steps(&self, radius: f32, angle: f32) -> usize {
        let radius = (radius / self.frame().pixel).max(1.0);
        let piece = 2.0 * (1.0 - FLATNESS / radius).clamp(-1.0, 1.0).acos();
        (angle / piece).ceil() as usize
    }
}

/// Outward unit normals at the corners, longer where the outline turns more, so that an offset keeps its edges parallel.
fn normals(corners: &[Vec2]) -> Vec<Vec2> {
    let n = corners.len();
    let turn: f32 = (0..n).map(|i| corners[i].perp_dot(corners[(i + 1) % n])).sum();
    let out = if turn >= 0.0 { -1.0 } else { 1.0 };
    let edge = |i: usize| (corners[(i + 1) % n] - corners[i % n]).perp().normalize_or_zero() * out;
    (0..n)
        .map(|i| {
            let sum = edge(i) + edge(i + n - 1);
            // A sharp corner's mitre is kept within four widths.
            sum * (2.0 / sum.length_squared().max(0.25))
        })
        .collect()
}

fn offset(corners: &[Vec2], normals: &[Vec2], by: f32) -> Vec<Vec2> {
    corners.iter().zip(normals).map(|(corner, normal)| *corner + *normal * by).collect()
}

/// Triangles that are being put together.
#[derive(Default)]
struct Soft {
    vertices: Vec<Vertex>,
    indices: Vec<u16>,
}

impl Soft {
    fn fan(&mut self, ring: &[Vec2], colour: Color) {
        let first = self.add(ring, colour);
        for i in 1..ring.len() as u16 - 1 {
            self.indices.extend([first, first + i, first + i + 1]);
        }
    }

    fn band(&mut self, inner: &[Vec2], inner_colour: Color, outer: &[Vec2], outer_colour: Color) {
        let (a, b) = (self.add(inner, inner_colour), self.add(outer, outer_colour));
        let n = inner.len() as u16;
        for i in 0..n {
            let j = (i + 1) % n;
            self.indices.extend([a + i, a + j, b + j, a + i, b + j, b + i]);
        }
    }

    fn add(&mut self, ring: &[Vec2], colour: Color) -> u16 {
        let first = self.vertices.len() as u16;
        self.vertices.extend(ring.iter().map(|p| Vertex::new(p.x, p.y, 0.0, 0.0, 0.0, colour)));
        first
    }

    fn draw(self) {
        draw_mesh(&Mesh { vertices: self.vertices, indices: self.indices, texture: None });
    }
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
            let grown = offset(&corners, &normals(&corners), 1.0);
            for (corner, point) in corners.iter().zip(grown) {
                assert_eq!(point, *corner + (*corner - Vec2::ONE));
            }
        }
    }
}
