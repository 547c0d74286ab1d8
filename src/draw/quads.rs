//! Quadrangles without soft edges, whose colours run from corner to corner: light, liquids, drafted strokes.

use super::colour::Colour;
use super::layout::Vec2;

/// The most quadrangles of one draw call: macroquad keeps room for 5000 indices.
#[cfg(feature = "window")]
pub(super) const MOST_QUADS: usize = 800;

/// The corners stand in order round.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quad {
    /// Canvas units.
    pub corners: [Vec2; 4],
    pub colours: [Colour; 4],
}

#[derive(Clone, Debug, Default, PartialEq)]
pub struct Quads(pub Vec<Quad>);

impl Quads {
    /// The corners stand in order round.
    pub fn quad(&mut self, corners: [Vec2; 4], colours: [Colour; 4]) {
        self.0.push(Quad { corners, colours });
    }

    pub fn triangle(&mut self, [a, b, c]: [Vec2; 3], colour: Colour) {
        self.quad([a, b, c, c], [colour; 4]);
    }

    /// Adds a thin stroke with soft sides that runs from one colour to another and fades out over `reach` to each side.
    pub fn stroke(&mut self, [from, to]: [Vec2; 2], reach: f32, [a, b]: [Colour; 2]) {
        let across = (to - from).perp().normalize_or_zero() * reach;
        let (clear_a, clear_b) = (a.faded(0.0), b.faded(0.0));
        self.quad([from + across, to + across, to, from], [clear_a, clear_b, b, a]);
        self.quad([from, to, to - across, from - across], [a, b, clear_b, clear_a]);
    }
}
