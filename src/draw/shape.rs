//! The shapes of a canvas.

use super::colour::Colour;
use super::layout::{Area, Vec2};
use super::quads::Quads;
use super::text::Typeface;
use std::sync::Arc;

/// Lengths in canvas units, y down.
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
    /// The edge lies inside the box.
    RectangleEdge { area: Area, width: f32, colour: Colour },
    /// Quadrangles without soft edges, whose colours run from corner to corner.
    Quads(Quads),
    /// It lies above all other shapes of its layer.
    Text { text: String, at: Vec2, style: Style },
    /// A part of an image (0 … 1 along both axes) stretched over an area, turned around the area's middle (radians, clockwise),
    /// multiplied by a colour.
    Picture { image: Image, part: Area, area: Area, turn: f32, tint: Colour },
    /// The following shapes lie above all before it.
    Layer,
}

/// The outline of a soft shape.
#[derive(Clone, Debug, PartialEq)]
pub enum Contour {
    /// Convex corners in order, either way round.
    Convex(Vec<Vec2>),
    /// The radius of its corners.
    Rounded(Area, f32),
    /// Centre and radius.
    Circle(Vec2, f32),
    /// Its ends, which are blunt, and its width.
    Line(Vec2, Vec2, f32),
}

/// The source of a picture's pixels.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Image {
    /// The sheet with the game's own pictures.
    Sheet,
    /// A PNG file. Two images are equal where their bytes are.
    File(Arc<[u8]>),
}

/// The side of its point on which a text lies.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Align {
    #[default]
    Left,
    /// On both sides.
    Centre,
    /// To the left.
    Right,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Style {
    /// One of [`super::layout::TEXT_SIZES`].
    pub size: f32,
    pub colour: Colour,
    pub face: Typeface,
    pub align: Align,
    /// The point is at the middle of the capitals' height instead of at the top of the line.
    pub middle: bool,
}

impl Style {
    /// The words begin at their point.
    pub const fn new(size: f32, colour: Colour) -> Self {
        Self { size, colour, face: Typeface::Sans, align: Align::Left, middle: false }
    }

    pub const fn mono(self) -> Self {
        Self { face: Typeface::Mono, ..self }
    }

    pub const fn centred(self) -> Self {
        Self { align: Align::Centre, ..self }
    }

    pub const fn right(self) -> Self {
        Self { align: Align::Right, ..self }
    }

    pub const fn middle(self) -> Self {
        Self { middle: true, ..self }
    }
}
