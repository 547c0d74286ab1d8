//! What can be drawn.

use super::colour::Colour;
use super::layout::{Area, Vec2};
use super::quads::Quads;
use super::text::Typeface;
use std::sync::Arc;

/// One thing on the canvas; lengths in canvas units, y down.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// The inside of an outline, its edge soft by one physical pixel.
    Fill { outline: Contour, colour: Colour },
    /// The edge of an outline, inside it.
    Edge { outline: Contour, width: f32, colour: Colour },
    /// A line along an axis, one physical pixel wide and exactly on one.
    Hairline { from: Vec2, to: Vec2, colour: Colour },
    /// A box without soft edges.
    Rectangle { area: Area, colour: Colour },
    /// Its edge, inside it.
    RectangleEdge { area: Area, width: f32, colour: Colour },
    /// Quadrangles without soft edges, whose colours run from corner to corner.
    Quads(Quads),
    /// One line of words. It lies above all other shapes of its layer.
    Text { text: String, at: Vec2, style: Style },
    /// A part of an image (0 … 1 along both axes) stretched over an area, turned around the area's middle (radians, clockwise),
    /// multiplied by a colour.
    Picture { image: Image, part: Area, area: Area, turn: f32, tint: Colour },
    /// What follows lies above all before it.
    Layer,
}

/// Where a soft shape ends.
#[derive(Clone, Debug, PartialEq)]
pub enum Contour {
    /// Convex corners in order, either way round.
    Convex(Vec<Vec2>),
    /// A box with round corners of that radius.
    Rounded(Area, f32),
    /// A circle: its centre and radius.
    Circle(Vec2, f32),
    /// A straight line with blunt ends: where it begins and ends, and its width.
    Line(Vec2, Vec2, f32),
}

/// Pixels to draw from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Image {
    /// The sheet of everything that the game paints by itself.
    Sheet,
    /// The bytes of a PNG file. Two images are the same where the bytes are.
    File(Arc<[u8]>),
}

/// Where a text lies from the point that it is given.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Align {
    /// To the right of it.
    #[default]
    Left,
    /// On both sides.
    Centre,
    /// To the left of it.
    Right,
}

/// How a line of text looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Style {
    /// One of [`super::layout::TEXT_SIZES`].
    pub size: f32,
    /// Its colour.
    pub colour: Colour,
    /// Its face.
    pub face: Typeface,
    /// Where it lies from its point.
    pub align: Align,
    /// Whether its point is at the middle of its capitals' height instead of at the top of its line.
    pub middle: bool,
}

impl Style {
    /// Words that begin at their point.
    pub const fn new(size: f32, colour: Colour) -> Self {
        Self { size, colour, face: Typeface::Sans, align: Align::Left, middle: false }
    }

    /// The same in the monospaced face.
    pub const fn mono(self) -> Self {
        Self { face: Typeface::Mono, ..self }
    }

    /// The same on both sides of its point.
    pub const fn centred(self) -> Self {
        Self { align: Align::Centre, ..self }
    }

    /// The same to the left of its point.
    pub const fn right(self) -> Self {
        Self { align: Align::Right, ..self }
    }

    /// The same with its point at the middle of the capitals' height.
    pub const fn middle(self) -> Self {
        Self { middle: true, ..self }
    }
}
