//! The legend beside a diagram: its curves by name, and what its marks mean.

use super::looks::{look_of, name_of, shade, with_order, without_version};
use super::places::DiagramPlaces;
use crate::draw::chart::{FRAME, LEAST_ERROR, Marker, RING, SAMPLE, TOLERANCE_DASH, WORDS, dashed, marker, sample};
use crate::draw::layout::{Area, DETAILS, TEXT, Vec2};
use crate::draw::{Canvas, Colour, Style};
use crate::lab::curve::{GROWTH, Measured, MethodCurve, WorkPoint};
use crate::{lab::TOLERANCE, number::short, view::theme, view::widgets, words::tr};

/// A line of the legend: its area, the middle of its sample, and the start of its words.
fn line_of(plot: &DiagramPlaces, line: usize) -> (Area, Vec2, Vec2) {
    let area = plot.legend(line);
    let y = area.centre().y;
    (area, Vec2::new(area.min.x + SAMPLE / 2.0, y), Vec2::new(area.min.x + WORDS, y))
}

/// The curves' names in the legend and the size of all its words: whole names where these fit, or else what tells them apart.
fn names_of_curves(canvas: &Canvas, plot: &DiagramPlaces, measured: &Measured) -> (Vec<String>, f32) {
    let names: Vec<String> = measured.curves.iter().map(|curve| with_order(measured, curve)).collect();
    let room = plot.legend(0).size.x - WORDS;
    let low = |size: f32| canvas.frame().text_height(size) <= plot.pitch;
    let fits = |size: f32| low(size) && names.iter().all(|name| canvas.width(name, Style::new(size, theme::text())) <= room);
    match [TEXT, DETAILS].into_iter().find(|size| fits(*size)) {
        Some(size) => (names, size),
        None => {
            let width = |name: &str| canvas.width(name, Style::new(DETAILS, theme::text()));
            let shorter = |(curve, name): (&MethodCurve, &String)| {
                let whole = without_version(name);
                if width(&whole) > room { without_version(&name_of(&curve.name, curve.origin)) } else { whole }
            };
            let fit = names.iter().all(|name| width(name) <= room);
            (if fit { names } else { measured.curves.iter().zip(&names).map(shorter).collect() }, DETAILS)
        }
    }
}

pub(super) fn legend_of_curves(canvas: &Canvas, plot: &DiagramPlaces, measured: &Measured, picked: Option<usize>) {
    let (names, size) = names_of_curves(canvas, plot, measured);
    for (index, (curve, name)) in measured.curves.iter().zip(&names).enumerate() {
        let (area, _, words) = line_of(plot, index);
        if picked == Some(index) {
            canvas.rounded(area, 6.0, theme::panel_hover());
        }
        let whole = picked.is_none_or(|picked| picked == index);
        let look = look_of(&curve.name, curve.origin, index);
        let colour = shade(Colour::hex(look.colour), whole);
        sample(canvas, area, &look, colour);
        let style = Style::new(size, shade(theme::text(), whole)).middle();
        canvas.text(&widgets::cut(canvas, name, area.max().x - words.x, style), words, style);
    }
}

/// Around the cheapest point.
pub(super) fn frame(canvas: &Canvas, at: Vec2, half: f32) {
    canvas.rounded_edge(Area::around(at, Vec2::splat(2.0 * half + 2.0)), 0.0, 2.0, theme::good());
}

/// A note some lines below the curves of a legend, where there is room: its sample is given its area and its middle.
fn note(canvas: &Canvas, plot: &DiagramPlaces, (line, size): (usize, f32), sample: &dyn Fn(Area, Vec2), text: &str) {
    let (area, middle, words) = line_of(plot, line);
    if area.max().y + area.size.y / 2.0 > plot.panel.max().y {
        return;
    }
    // Half a line stands between the curves and the notes.
    let down = Vec2::new(0.0, area.size.y / 2.0);
    sample(Area { min: area.min + down, ..area }, middle + down);
    canvas.text(text, words + down, Style::new(size, theme::quiet()).middle());
}

/// The meaning of the dotted line.
pub(super) fn legend_of_tolerance(canvas: &Canvas, plot: &DiagramPlaces, measured: &Measured, words: &str) {
    let sample = |area: Area, middle: Vec2| {
        let ends = [Vec2::new(area.min.x, middle.y), Vec2::new(area.min.x + SAMPLE, middle.y)];
        dashed(canvas, &ends, TOLERANCE_DASH, 2.0, theme::good());
    };
    note(canvas, plot, (measured.curves.len(), names_of_curves(canvas, plot, measured).1), &sample, words);
}

pub(super) fn legend_of_marks(canvas: &Canvas, plot: &DiagramPlaces, measured: &Measured) {
    let size = names_of_curves(canvas, plot, measured).1;
    let mut line = measured.curves.len();
    let mut note = |sample: &dyn Fn(Area, Vec2), text: &str| {
        line += 1;
        note(canvas, plot, (line, size), sample, text);
    };
    // Neighbours in the legend stay apart.
    let most = plot.pitch / 2.0 - 2.0;
    let grows = measured.name == GROWTH;
    let tolerance = if grows {
        tr("real time: 1/60 s a step").to_owned()
    } else if measured.tolerance == TOLERANCE {
        tr("a tenth of a pixel, 1/300 m").to_owned()
    } else {
        tr!("tolerance {tolerance}", tolerance = short(measured.tolerance))
    };
    legend_of_tolerance(canvas, plot, measured, &tolerance);
    if measured.shipped().is_some() {
        note(&|_, middle| canvas.ring(middle, RING.min(most), 2.0, theme::accent()), tr("as shipped"));
    }
    if measured.cheapest().is_some() {
        note(&|_, middle| frame(canvas, middle, FRAME.min(most)), tr("cheapest within the tolerance"));
    }
    let points = || measured.curves.iter().flat_map(|curve| &curve.points);
    if points().any(WorkPoint::blew_up) {
        note(&|_, middle| marker(canvas, middle, Marker::Cross, theme::quiet()), tr("upper edge: blew up"));
    }
    if points().any(|point| point.error < LEAST_ERROR) {
        let foot = |area: Area, middle: Vec2| {
            canvas.line(Vec2::new(area.min.x, middle.y), Vec2::new(area.min.x + SAMPLE, middle.y), 2.0, theme::solid())
        };
        note(&foot, tr("lower edge: no error"));
    }
    let better = |area: Area, middle: Vec2| {
        let (from, to) = (Vec2::new(area.min.x + 28.0, middle.y - 8.0), Vec2::new(area.min.x + 12.0, middle.y + 8.0));
        canvas.line(from, to, 2.0, theme::quiet());
        canvas.convex(&[to + Vec2::new(-2.0, 2.0), to + Vec2::new(8.0, -1.0), to + Vec2::new(1.0, -8.0)], theme::quiet());
    };
    if !grows {
        note(&better, tr("lower left is better"));
    }
    if measured.curves.iter().any(|curve| curve.name.contains("stiffness")) {
        note(&|_, _| {}, tr("stiffness: of contacts, as a spring"));
    }
    if plot.slopes(measured, canvas.frame()).is_some() {
        note(&|_, _| {}, tr("triangles: slopes of orders"));
    }
    note(&|_, _| {}, tr("Logarithmic: equal steps"));
    note(&|_, _| {}, tr("multiply; 10⁻³ is 0.001"));
}
