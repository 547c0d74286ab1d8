//! Coloured triangles, put together and handed over in as few draw calls as the graphics library takes.

use crate::view::theme::faded;
use macroquad::color::Color;
use macroquad::math::Vec2;
use macroquad::models::{Mesh, Vertex, draw_mesh};

/// The most indices of one call: the library keeps room for 5000.
const MOST: usize = 4900;

/// Triangles waiting to be drawn.
#[derive(Default)]
pub struct Batch {
    vertices: Vec<Vertex>,
    indices: Vec<u16>,
}

impl Batch {
    /// Four corners in order round, each with its colour; in between the colours run into each other.
    pub fn quad(&mut self, corners: [Vec2; 4], colours: [Color; 4]) {
        self.make_room(6);
        let first = self.vertices.len() as u16;
        let vertex = |(at, colour): (Vec2, Color)| Vertex::new(at.x, at.y, 0.0, 0.0, 0.0, colour);
        self.vertices.extend(corners.into_iter().zip(colours).map(vertex));
        self.indices.extend([0, 1, 2, 0, 2, 3].map(|i| first + i));
    }

    /// A thin stroke with soft sides that runs from one colour to another; `reach` is how far it fades out to each side.
    pub fn stroke(&mut self, [from, to]: [Vec2; 2], reach: f32, colours: [Color; 2]) {
        let across = (to - from).perp().normalize_or_zero() * reach;
        let [a, b] = colours;
        let (clear_a, clear_b) = (faded(a, 0.0), faded(b, 0.0));
        self.quad([from + across, to + across, to, from], [clear_a, clear_b, b, a]);
        self.quad([from, to, to - across, from - across], [a, b, clear_b, clear_a]);
    }

    /// A filled triangle.
    pub fn triangle(&mut self, [a, b, c]: [Vec2; 3], colour: Color) {
        self.quad([a, b, c, c], [colour; 4]);
    }

    /// Draws what is left.
    pub fn draw(mut self) {
        self.flush();
    }

    fn make_room(&mut self, indices: usize) {
        if self.indices.len() + indices > MOST {
            self.flush();
        }
    }

    fn flush(&mut self) {
        if !self.indices.is_empty() {
            let mesh =
                Mesh { vertices: std::mem::take(&mut self.vertices), indices: std::mem::take(&mut self.indices), texture: None };
            draw_mesh(&mesh);
        }
    }
}
