//! The picture of a method's failure: small, beside its line of a table, or large, with its axes.

use crate::draw::layout::{Area, DETAILS, TEXT, Vec2};
use crate::draw::{Canvas, Colour, Style};
use crate::lab::stress::picture::{FailurePicture, Polyline};
use crate::number::short;
use crate::view::{theme, widgets};
use crate::words::tr;

/// Above and below a large picture's plot: the names of its axes and their ends.
const TOP: f32 = 44.0;
const BOTTOM: f32 = 40.0;

/// Without words.
pub fn small(canvas: &Canvas, area: Area, picture: &FailurePicture, colour: Colour) {
    canvas.rounded(area, 3.0, theme::ground());
    lines(canvas, area.inset(2.0), picture, (colour, 1.5));
}

/// With names and ends of the axes.
pub fn large(canvas: &Canvas, area: Area, picture: &FailurePicture, colour: Colour) {
    let plot = Area::new(area.min.x, area.min.y + TOP, area.size.x, area.size.y - TOP - BOTTOM);
    canvas.rounded(plot, 0.0, theme::ground());
    canvas.rounded_edge(plot, 0.0, 1.0, theme::solid());
    lines(canvas, plot, picture, (colour, 2.0));
    let ((from, to), (least, most)) = picture.window();
    let words = Style::new(TEXT, theme::text()).middle();
    let quiet = Style::new(DETAILS, theme::quiet()).middle();
    let up = widgets::cut(canvas, tr(picture.up), plot.size.x, words);
    canvas.text(&up, Vec2::new(plot.min.x, plot.min.y - 32.0), words);
    let span = tr!("from {least} to {most}", least = short(least), most = short(most));
    canvas.text(&span, Vec2::new(plot.min.x, plot.min.y - 10.0), quiet);
    let foot = plot.max().y + 14.0;
    canvas.text(&short(from), Vec2::new(plot.min.x, foot), quiet);
    canvas.text(&short(to), Vec2::new(plot.max().x, foot), quiet.right());
    canvas.text(tr(picture.across), Vec2::new(plot.centre().x, foot + 4.0), words.centred());
}

fn lines(canvas: &Canvas, area: Area, picture: &FailurePicture, (colour, width): (Colour, f32)) {
    let across = |(from, to): (f64, f64), colour: Colour| {
        let ends: Polyline = vec![(f64::NEG_INFINITY, from), (f64::INFINITY, to)];
        if let [low, high] = picture.parts(&[ends])[0].as_slice() {
            let (top, foot) = (area.part((0.0, high.1)).y, area.part((0.0, low.1)).y);
            canvas.rounded(Area::new(area.min.x, top, area.size.x, (foot - top).max(1.0)), 0.0, colour);
        }
    };
    if let Some(solid) = picture.solid {
        across(solid, theme::solid());
    }
    if let Some(right) = picture.right {
        across(right, theme::good().faded(0.25));
    }
    let stroke = |lines: &[Polyline], colour: Colour, width: f32| {
        for line in picture.parts(lines) {
            line.windows(2).for_each(|pair| canvas.line(area.part(pair[0]), area.part(pair[1]), width, colour));
        }
    };
    stroke(&picture.exact, theme::good(), 1.0);
    stroke(&picture.found, colour, width);
}
