//! The pen of paper: plays a canvas as SVG, its words as text. A quadrangle has the colour of its first corner; images are left
//! out, for no chart has one.

use super::layout::{Area, Vec2};
use super::shape::{Align, Colour, Contour, Shape, Style};
use super::{canvas::Canvas, text::Typeface};
use std::fmt::Write;

/// `ground` fills the sheet.
pub fn svg(canvas: &Canvas, ground: Colour) -> String {
    let Vec2 { x, y } = canvas.size();
    let mut paper = Paper { canvas, text: String::new(), lines: None };
    paper.text = format!("<svg width=\"{x}\" height=\"{y}\" viewBox=\"0 0 {x} {y}\" xmlns=\"http://www.w3.org/2000/svg\">\n");
    paper.area("rect", canvas.frame().area(), &fill(ground));
    for layer in canvas.shapes().split(|shape| matches!(shape, Shape::Layer)) {
        layer.iter().for_each(|shape| paper.draw(shape));
        paper.end_lines();
        for shape in layer {
            if let Shape::Text { text, at, style } = shape {
                paper.write(text, *at, *style);
            }
        }
    }
    paper.text + "</svg>\n"
}

struct Paper<'a> {
    canvas: &'a Canvas,
    text: String,
    /// The path of lines that is being written: width, colour and end.
    lines: Option<(f32, Colour, Vec2)>,
}

impl Paper<'_> {
    fn draw(&mut self, shape: &Shape) {
        match shape {
            Shape::Fill { outline: Contour::Line(from, to, width), colour } => return self.line([*from, *to], *width, *colour),
            Shape::Hairline { from, to, colour } => return self.line([*from, *to], self.canvas.frame().pixel, *colour),
            _ => self.end_lines(),
        }
        match shape {
            Shape::Fill { outline, colour } => self.outline(outline, 0.0, &fill(*colour)),
            Shape::Edge { outline, width, colour } => self.outline(outline, width / 2.0, &stroke(*width, *colour)),
            Shape::Rectangle { area, colour } => self.area("rect", *area, &fill(*colour)),
            Shape::RectangleEdge { area, width, colour } => {
                self.area("rect", area.inset(width / 2.0), &stroke(*width, *colour));
            }
            Shape::Quads(quads) => {
                quads.0.iter().for_each(|quad| self.polygon(&quad.corners, &fill(quad.colours[0])));
            }
            Shape::Hairline { .. } | Shape::Text { .. } | Shape::Picture { .. } | Shape::Textured { .. } | Shape::Layer => {}
        }
    }

    /// `inset` (canvas units) moves a round outline or a box inwards.
    fn outline(&mut self, outline: &Contour, inset: f32, look: &str) {
        match outline {
            Contour::Convex(corners) => self.polygon(corners, look),
            Contour::Rounded(area, radius) if *radius <= inset => self.area("rect", area.inset(inset), look),
            Contour::Rounded(area, radius) => {
                self.area(&format!("rect rx=\"{}\"", number(radius - inset)), area.inset(inset), look);
            }
            Contour::Circle(centre, radius) => {
                let (x, y, radius) = (number(centre.x), number(centre.y), number(radius - inset));
                let _ = writeln!(self.text, "<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\" {look}/>");
            }
            Contour::Line(from, to, _) => self.polygon(&[*from, *to], look),
        }
    }

    fn area(&mut self, tag: &str, area: Area, look: &str) {
        let [x, y, width, height] = [area.min.x, area.min.y, area.size.x.max(0.0), area.size.y.max(0.0)].map(number);
        let _ = writeln!(self.text, "<{tag} x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" {look}/>");
    }

    fn polygon(&mut self, corners: &[Vec2], look: &str) {
        self.text.push_str("<polygon points=\"");
        for corner in corners {
            let _ = write!(self.text, "{},{} ", number(corner.x), number(corner.y));
        }
        let _ = writeln!(self.text, "\" {look}/>");
    }

    /// Lines of one look that follow each other are one path.
    fn line(&mut self, [from, to]: [Vec2; 2], width: f32, colour: Colour) {
        let before = self.lines.filter(|(known, own, _)| (*known, *own) == (width, colour));
        if before.is_none() {
            self.end_lines();
            let _ = write!(self.text, "<path {} d=\"", stroke(width, colour));
        }
        if before.is_none_or(|(_, _, end)| end != from) {
            let _ = write!(self.text, "M{},{}", number(from.x), number(from.y));
        }
        let _ = write!(self.text, "L{},{}", number(to.x), number(to.y));
        self.lines = Some((width, colour, to));
    }

    fn end_lines(&mut self) {
        if self.lines.take().is_some() {
            self.text.push_str("\"/>\n");
        }
    }

    fn write(&mut self, text: &str, at: Vec2, style: Style) {
        let baseline = self.canvas.baseline(text, Vec2::ZERO, Style { align: Align::Left, ..style }).y + at.y;
        let (x, y, size) = (number(at.x), number(baseline), number(self.canvas.frame().text_height(style.size)));
        let anchor = match style.align {
            Align::Left => "start",
            Align::Centre => "middle",
            Align::Right => "end",
        };
        let family = match style.face {
            Typeface::Sans => "Ubuntu, sans-serif",
            Typeface::Mono => "Hack, monospace",
        };
        let look = fill(style.colour);
        let _ = write!(
            self.text,
            "<text x=\"{x}\" y=\"{y}\" font-family=\"{family}\" font-size=\"{size}\" text-anchor=\"{anchor}\" {look}>"
        );
        for sign in text.chars() {
            match sign {
                '&' => self.text.push_str("&amp;"),
                '<' => self.text.push_str("&lt;"),
                '>' => self.text.push_str("&gt;"),
                _ => self.text.push(sign),
            }
        }
        self.text.push_str("</text>\n");
    }
}

fn fill(colour: Colour) -> String {
    format!("fill=\"{}\"{}", hex(colour), cover("fill", colour))
}

fn stroke(width: f32, colour: Colour) -> String {
    format!("fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"{}", hex(colour), number(width), cover("stroke", colour))
}

fn cover(of: &str, colour: Colour) -> String {
    if colour.a < 1.0 { format!(" {of}-opacity=\"{:.2}\"", colour.a) } else { String::new() }
}

fn hex(colour: Colour) -> String {
    let [r, g, b] = [colour.r, colour.g, colour.b].map(|part| (part * 255.0).round() as u8);
    format!("#{r:02x}{g:02x}{b:02x}")
}

fn number(value: f32) -> String {
    let text = format!("{value:.1}");
    text.strip_suffix(".0").map_or(text.clone(), str::to_owned)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::draw::layout::{Frame, TEXT};

    #[test]
    fn lines_are_joined_words_stay_text_and_lie_above_the_shapes_of_their_layer() {
        let canvas = Canvas::new(Frame::default());
        let (red, point) = (Colour::hex(0xFF0000), |x: f32| Vec2::new(x, 2.5));
        canvas.text("a < b & c", point(8.0), Style::new(TEXT, Colour::WHITE).right());
        canvas.line(point(1.0), point(2.0), 2.0, red);
        canvas.line(point(2.0), point(3.0), 2.0, red);
        canvas.line(point(5.0), point(6.0), 2.0, red.faded(0.5));
        canvas.ring(point(4.0), 3.0, 2.0, red);
        let text = svg(&canvas, Colour::default());
        let line = "<path fill=\"none\" stroke=\"#ff0000\" stroke-width=\"2\"";
        for part in [
            format!("{line} d=\"M1,2.5L2,2.5L3,2.5\"/>\n{line} stroke-opacity=\"0.50\" d=\"M5,2.5L6,2.5\"/>"),
            "<circle cx=\"4\" cy=\"2.5\" r=\"2\" fill=\"none\"".to_owned(),
            "text-anchor=\"end\" fill=\"#ffffff\">a &lt; b &amp; c</text>\n</svg>".to_owned(),
        ] {
            assert!(text.contains(&part), "{part} in {text}");
        }
    }
}
