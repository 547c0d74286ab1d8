//! The canvas: every drawing goes through it. It records shapes in canvas units and needs no window.

use super::layout::{Area, Frame, LINE, Vec2};
use super::shape::{Align, Colour, Contour, Image, Quad, Quads, Shape, Style, dashes};
use super::text;
use crate::words::decimals;
use std::cell::{Ref, RefCell};
use std::collections::HashMap;

/// From the top of a line to its baseline, in heights of the text (both faces within 1 %).
const ASCENT: f32 = 0.93;
/// Half the height of a capital, in heights of the text.
const HALF_CAPITAL: f32 = 0.355;

#[derive(Debug)]
pub struct Canvas {
    frame: Frame,
    /// Of the whole window, canvas units.
    window: Vec2,
    /// Physical pixels a logical one: a system reports the mouse, and text is set, in logical pixels.
    dpi: f32,
    /// Whether numbers stay as they are written, as in a file.
    as_written: bool,
    shapes: RefCell<Vec<Shape>>,
}

impl Canvas {
    pub const fn new(frame: Frame) -> Self {
        Self { frame, window: frame.size, dpi: 1.0, as_written: false, shapes: RefCell::new(Vec::new()) }
    }

    /// `dpi` is physical pixels a logical one; decimal marks stay `as_written` in files, for who edits those.
    pub fn begin(&mut self, frame: Frame, dpi: f32, as_written: bool) {
        (self.frame, self.window, self.dpi, self.as_written) = (frame, frame.size, dpi, as_written);
        self.clear();
    }

    pub fn clear(&mut self) {
        self.shapes.get_mut().clear();
    }

    /// Turns the colours of all shapes to those for white; pictures keep theirs.
    pub fn put_on_white(&mut self) {
        let mut known: HashMap<[u32; 4], Colour> = HashMap::new();
        let mut turn = |colour: &mut Colour| {
            let key = [colour.r, colour.g, colour.b, colour.a].map(f32::to_bits);
            *colour = *known.entry(key).or_insert_with(|| colour.on_white());
        };
        for shape in self.shapes.get_mut() {
            match shape {
                Shape::Fill { colour, .. }
                | Shape::Edge { colour, .. }
                | Shape::Hairline { colour, .. }
                | Shape::Rectangle { colour, .. }
                | Shape::RectangleEdge { colour, .. } => turn(colour),
                Shape::Quads(quads) => quads.0.iter_mut().flat_map(|quad| &mut quad.colours).for_each(&mut turn),
                Shape::Text { style, .. } => style.colour = style.colour.words_on_white(),
                Shape::Picture { .. } | Shape::Textured { .. } | Shape::Layer => {}
            }
        }
    }

    pub fn add_all(&mut self, other: &Self) {
        self.shapes.get_mut().extend(other.shapes().iter().cloned());
    }

    pub fn shapes(&self) -> Ref<'_, [Shape]> {
        Ref::map(self.shapes.borrow(), Vec::as_slice)
    }

    /// Lays the following shapes out on another part of the canvas, from its top left corner; returns the frame before.
    pub const fn use_frame(&mut self, frame: Frame) -> Frame {
        std::mem::replace(&mut self.frame, frame)
    }

    pub const fn frame(&self) -> &Frame {
        &self.frame
    }

    /// Canvas units: at least 1280 × 720.
    pub const fn size(&self) -> Vec2 {
        self.frame.size
    }

    /// Canvas units.
    pub const fn window(&self) -> Vec2 {
        self.window
    }

    pub const fn dpi(&self) -> f32 {
        self.dpi
    }

    /// Ends a layer: the next one lies above it and its text.
    pub fn end_layer(&self) {
        self.add(Shape::Layer);
    }

    /// Writes a line with the language's decimal marks; `at` is its top (or the middle of its capitals) at its left, middle or right end.
    pub fn text(&self, text: &str, at: Vec2, style: Style) {
        if self.as_written { self.typed(text, at, style) } else { self.typed(&decimals(text), at, style) }
    }

    /// The same as somebody has typed it.
    pub fn typed(&self, text: &str, at: Vec2, style: Style) {
        if !text.is_empty() {
            self.add(Shape::Text { text: text.to_owned(), at, style });
        }
    }

    pub fn width(&self, text: &str, style: Style) -> f32 {
        text::width(text, style.face, self.glyph_height(style.size)) * self.frame.pixel
    }

    /// Canvas units.
    pub fn baseline(&self, text: &str, at: Vec2, style: Style) -> Vec2 {
        let left = match style.align {
            Align::Left => at.x,
            Align::Centre => at.x - self.width(text, style) / 2.0,
            Align::Right => at.x - self.width(text, style),
        };
        Vec2::new(left, at.y + self.glyph_height(style.size) * self.frame.pixel * if style.middle { HALF_CAPITAL } else { ASCENT })
    }

    /// In whole physical pixels, a whole number of logical ones.
    pub fn glyph_height(&self, size: f32) -> f32 {
        ((self.frame.text_height(size) / self.frame.pixel / self.dpi).ceil() * self.dpi).ceil()
    }

    /// Canvas units.
    pub fn line_height(&self, size: f32) -> f32 {
        self.frame.text_height(size) * LINE
    }

    pub fn convex(&self, corners: &[Vec2], colour: Colour) {
        if corners.len() >= 3 {
            self.add(Shape::Fill { outline: Contour::Convex(corners.to_vec()), colour });
        }
    }

    /// The edge lies inside the corners.
    pub fn convex_edge(&self, corners: &[Vec2], width: f32, colour: Colour) {
        if corners.len() >= 3 {
            self.add(Shape::Edge { outline: Contour::Convex(corners.to_vec()), width, colour });
        }
    }

    pub fn rounded(&self, area: Area, radius: f32, colour: Colour) {
        self.add(Shape::Fill { outline: Contour::Rounded(area, radius), colour });
    }

    /// The edge lies inside the box.
    pub fn rounded_edge(&self, area: Area, radius: f32, width: f32, colour: Colour) {
        self.add(Shape::Edge { outline: Contour::Rounded(area, radius), width, colour });
    }

    pub fn disc(&self, centre: Vec2, radius: f32, colour: Colour) {
        self.add(Shape::Fill { outline: Contour::Circle(centre, radius), colour });
    }

    /// The edge lies inside the circle.
    pub fn ring(&self, centre: Vec2, radius: f32, width: f32, colour: Colour) {
        self.add(Shape::Edge { outline: Contour::Circle(centre, radius), width, colour });
    }

    /// The ends are blunt.
    pub fn line(&self, from: Vec2, to: Vec2, width: f32, colour: Colour) {
        self.add(Shape::Fill { outline: Contour::Line(from, to, width), colour });
    }

    /// A dashed line through corners: the lengths of the pattern are drawn and left out in turn; without a pattern it is whole.
    pub fn dashed(&self, corners: &[Vec2], pattern: &[f32], width: f32, colour: Colour) {
        dashes(corners, pattern).into_iter().for_each(|(from, to)| self.line(from, to, width, colour));
    }

    /// A line along an axis, one physical pixel wide and exactly on one.
    pub fn hairline(&self, from: Vec2, to: Vec2, colour: Colour) {
        self.add(Shape::Hairline { from, to, colour });
    }

    /// A box without soft edges, for boxes that lie on whole pixels or adjoin.
    pub fn rectangle(&self, area: Area, colour: Colour) {
        self.add(Shape::Rectangle { area, colour });
    }

    /// The edge lies inside the box.
    pub fn rectangle_edge(&self, area: Area, width: f32, colour: Colour) {
        self.add(Shape::RectangleEdge { area, width, colour });
    }

    pub fn quads(&self, quads: Quads) {
        if !quads.0.is_empty() {
            self.add(Shape::Quads(quads));
        }
    }

    /// The places (0 … 1 along both axes) in the image stand beside each quadrangle.
    pub fn textured(&self, image: &Image, quads: Vec<(Quad, [Vec2; 4])>) {
        if !quads.is_empty() {
            self.add(Shape::Textured { image: image.clone(), quads });
        }
    }

    pub fn triangle(&self, corners: [Vec2; 3], colour: Colour) {
        let mut quads = Quads::default();
        quads.triangle(corners, colour);
        self.quads(quads);
    }

    pub fn image(&self, image: &Image, area: Area, tint: Colour) {
        self.picture(image, Area::new(0.0, 0.0, 1.0, 1.0), area, (0.0, tint));
    }

    /// A part of an image (0 … 1 along both axes) over an area, turned clockwise around its middle (rad), and multiplied by a colour.
    pub fn picture(&self, image: &Image, part: Area, area: Area, (turn, tint): (f32, Colour)) {
        self.add(Shape::Picture { image: image.clone(), part, area, turn, tint });
    }

    fn add(&self, shape: Shape) {
        self.shapes.borrow_mut().push(shape);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::draw::layout::TEXT;

    #[test]
    fn a_canvas_records_what_is_drawn_and_begins_empty() {
        let mut canvas = Canvas::new(Frame::default());
        let style = Style::new(TEXT, Colour::hex(0xFF_9F1C)).right();
        canvas.text("", Vec2::ZERO, style);
        canvas.convex(&[Vec2::ZERO, Vec2::ONE], style.colour);
        canvas.text("words", Vec2::new(100.0, 20.0), style);
        canvas.end_layer();
        let words = Shape::Text { text: "words".into(), at: Vec2::new(100.0, 20.0), style };
        assert_eq!(*canvas.shapes(), [words, Shape::Layer], "nothing is recorded that shows nothing");
        let from = canvas.baseline("words", Vec2::new(100.0, 20.0), style);
        assert_eq!(from.x + canvas.width("words", style), 100.0);
        canvas.begin(Frame::default(), 2.0, false);
        assert!(canvas.shapes().is_empty());
        assert_eq!(canvas.glyph_height(TEXT), 18.0);
    }
}
