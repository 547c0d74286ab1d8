//! The shapes of a canvas, its colours, quadrangles whose colours run from corner to corner (light, liquids, drafted strokes), and dashed lines.

use super::layout::{Area, Vec2};
use super::text::Typeface;
use std::{fmt, sync::Arc};

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
    /// The same, whose colours multiply an image; its places (0 … 1 along both axes) at the corners of each.
    Textured { image: Image, quads: Vec<(Quad, [Vec2; 4])> },
    /// It lies above all other shapes of its layer.
    Text { text: String, at: Vec2, style: Style },
    /// A part of an image (0 … 1 along both axes) over an area, turned clockwise around its middle (rad), and multiplied by a colour.
    Picture { image: Image, part: Area, area: Area, turn: f32, tint: Colour },
    /// The following shapes lie above all before it.
    Layer,
}

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

#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Image {
    /// The sheet with the game's own pictures.
    Sheet,
    /// A PNG file. Two images are equal where their bytes are.
    File(Arc<[u8]>),
    Painted(Arc<Painting>),
}

/// A picture that the game has painted.
#[derive(Clone, PartialEq, Eq)]
pub struct Painting {
    /// Pixels.
    pub width: usize,
    /// Straight RGBA, row by row from the top.
    pub bytes: Vec<u8>,
}

impl Painting {
    /// Pixels.
    pub fn height(&self) -> usize {
        self.bytes.len() / 4 / self.width.max(1)
    }
}

impl fmt::Debug for Painting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Painting({} × {})", self.width, self.height())
    }
}

/// The side of its point on which a text lies.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Align {
    #[default]
    Left,
    Centre,
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

/// What the lightness of a colour (CIE L*, 0 … 100) becomes on white: words and lines dark, grounds light, each in its order.
const ON_WHITE: [(f32, f32); 8] =
    [(0.0, 98.0), (12.0, 93.0), (30.0, 70.0), (40.0, 58.0), (60.0, 48.0), (88.0, 28.0), (94.0, 8.0), (100.0, 0.0)];

/// The most lightness of words on white grounds, and that from which words stand on dark areas.
const WORDS_ON_WHITE: f32 = 38.0;
const PALE: f32 = 65.0;

/// A colour in straight (not premultiplied) sRGB, each part 0 … 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Colour {
    pub r: f32,
    pub g: f32,
    pub b: f32,
    pub a: f32,
}

impl Colour {
    /// A picture that is drawn with it keeps its colours.
    pub const WHITE: Self = Self::new(1.0, 1.0, 1.0, 1.0);

    /// Each part 0 … 1.
    pub const fn new(r: f32, g: f32, b: f32, a: f32) -> Self {
        Self { r, g, b, a }
    }

    /// Opaque; each part 0 … 255.
    pub const fn of([r, g, b]: [u8; 3]) -> Self {
        Self::new(r as f32 / 255.0, g as f32 / 255.0, b as f32 / 255.0, 1.0)
    }

    /// Opaque, from 0xRRGGBB.
    pub const fn hex(hex: u32) -> Self {
        Self::of([(hex >> 16) as u8, (hex >> 8) as u8, hex as u8])
    }

    /// `alpha` (0 … 1) multiplies the opacity.
    pub const fn faded(self, alpha: f32) -> Self {
        Self::new(self.r, self.g, self.b, self.a * alpha)
    }

    /// For a projector and for paper: light becomes dark and dark light, and the hue stays.
    pub fn on_white(self) -> Self {
        self.with_lightness(|wanted| wanted)
    }

    /// The same for words, which are darker than areas and lines.
    pub fn words_on_white(self) -> Self {
        self.with_lightness(|wanted| if wanted < PALE { wanted.min(WORDS_ON_WHITE) } else { wanted })
    }

    /// With the lightness for white grounds, which `limit` changes.
    fn with_lightness(self, limit: impl Fn(f32) -> f32) -> Self {
        let linear =
            [self.r, self.g, self.b].map(|part| if part <= 0.04045 { part / 12.92 } else { ((part + 0.055) / 1.055).powf(2.4) });
        let luminance = (0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]).max(1e-6);
        let lightness = if luminance > 216.0 / 24389.0 { 116.0 * luminance.cbrt() - 16.0 } else { luminance * 24389.0 / 27.0 };
        let above = ON_WHITE.iter().position(|(from, _)| lightness <= *from).unwrap_or(ON_WHITE.len() - 1).max(1);
        let [(from, low), (to, high)] = [ON_WHITE[above - 1], ON_WHITE[above]];
        let wanted = limit((low + (high - low) * (lightness - from) / (to - from)).clamp(0.0, 100.0));
        let wanted = if wanted > 8.0 { ((wanted + 16.0) / 116.0).powi(3) } else { wanted * 27.0 / 24389.0 };
        // A ground that becomes much lighter keeps less of its tint.
        let tint = (luminance / wanted).sqrt().min(1.0);
        let [r, g, b] = linear.map(|part| {
            let part = (wanted * (1.0 + tint * (part / luminance - 1.0))).clamp(0.0, 1.0);
            if part <= 0.003_130_8 { 12.92 * part } else { 1.055 * part.powf(1.0 / 2.4) - 0.055 }
        });
        Self { r, g, b, a: self.a }
    }

    /// Opaque, `share` (0 … 1) of the difference to another colour.
    pub fn mixed(self, other: Self, share: f32) -> Self {
        let mix = |from: f32, to: f32| from + (to - from) * share;
        Self::new(mix(self.r, other.r), mix(self.g, other.g), mix(self.b, other.b), 1.0)
    }
}

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

/// The pieces of a path: the lengths of a pattern (canvas units) are drawn and left out in turn, also round corners; without one it is whole.
pub fn dashes(corners: &[Vec2], pattern: &[f32]) -> Vec<(Vec2, Vec2)> {
    let mut pieces = Vec::new();
    let (mut index, mut left) = (0, pattern.first().copied().unwrap_or(f32::INFINITY));
    for pair in corners.windows(2) {
        let (from, to) = (pair[0], pair[1]);
        let (length, mut at) = (from.distance(to), 0.0);
        let along = |way: f32| from + (to - from) * (way / length);
        while at < length {
            // A piece takes a little at least, so that rounding cannot stall the loop.
            let end = (at + left.max(0.01)).min(length);
            if index % 2 == 0 {
                pieces.push((along(at), along(end)));
            }
            left -= end - at;
            if left <= 1e-3 {
                index = (index + 1) % pattern.len();
                left = pattern[index];
            }
            at = end;
        }
    }
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dashes_go_on_round_corners() {
        let corners = [Vec2::ZERO, Vec2::new(5.0, 0.0), Vec2::new(5.0, 7.0)];
        let drawn: f32 = dashes(&corners, &[4.0, 2.0]).iter().map(|(from, to)| from.distance(*to)).sum();
        assert!((drawn - 8.0).abs() < 0.1, "{drawn}");
        assert!(dashes(&[Vec2::ONE, Vec2::ONE], &[4.0, 2.0]).is_empty());
        assert_eq!(dashes(&corners, &[]), [(corners[0], corners[1]), (corners[1], corners[2])]);
    }
}
