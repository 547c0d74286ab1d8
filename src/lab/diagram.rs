//! A work–precision diagram as SVG: work to the right, error upwards, both logarithmic; a curve a method and a point a step. A cross
//! on the upper edge is a run that blew up; a point on the lower edge has no error but rounding, or none.

use super::axes::{Axes, LEAST_ERROR, number, power};
use super::curve::{CurveOrigin, MethodCurve, WorkPoint};
use super::look::{FRAME, GOOD, Look, Marker, RING, SHIPPED, TEXT, TOLERANCE_DASH};
use super::measured::Measured;
use plotters::coord::Shift;
use plotters::prelude::*;
use std::error::Error;

// Sizes of type are given as the plotting library wants them: it writes 1/1.24 of them.

/// Pixels.
pub(super) const SIZE: (u32, u32) = (1144, 600);
/// Pixels. Where the legend begins.
pub(super) const LEGEND: i32 = 740;
/// Pixels between the legend's lines.
pub(super) const LINE: i32 = 26;

/// Lines of the legend below those of the curves, and half a line before them.
const NOTES: i32 = 7;
/// Pixels. What the number of an order takes up.
const ORDER: (i32, i32) = (24, 13);

// The game's notebook at night.
pub(super) const GROUND: u32 = 0x10141B;
pub(super) const GRID: u32 = 0x1A2130;
pub(super) const HEAVY_GRID: u32 = 0x2C3648;
pub(super) const QUIET: u32 = 0x93A0B4;

pub(super) const fn rgb(hex: u32) -> RGBColor {
    RGBColor((hex >> 16) as u8, (hex >> 8) as u8, hex as u8)
}

/// Draws it.
///
/// # Errors
/// What the plotting library reports.
pub fn svg(measured: &Measured) -> Result<String, Box<dyn Error>> {
    let mut text = String::new();
    {
        let root = SVGBackend::with_string(&mut text, SIZE).into_drawing_area();
        root.fill(&rgb(GROUND))?;
        draw(measured, &root).map_err(|error| error.to_string())?;
        root.present()?;
    }
    Ok(text)
}

pub(super) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
pub(super) type Drawn<'a> = Result<(), DrawingAreaErrorKind<<SVGBackend<'a> as DrawingBackend>::ErrorType>>;

fn draw<'a>(measured: &Measured, root: &Area<'a>) -> Drawn<'a> {
    let heading = ("sans-serif", 24).into_font().color(&rgb(TEXT));
    root.draw_text(&measured.title, &heading, (24, 18))?;
    let note = ("sans-serif", 16).into_font().color(&rgb(QUIET));
    root.draw_text(&measured.note, &note, (24, 46))?;
    let (left, _) = root.split_horizontally(LEGEND - 16);
    let axes = Axes::of(measured);
    let (xs, ys) = (axes.work.range(), axes.error.range());
    let top = ys.end;
    let place = |point: &WorkPoint| (point.work, if point.blew_up() { top } else { point.error.clamp(LEAST_ERROR, top) });
    let mut chart = ChartBuilder::on(&left)
        .margin_top(if measured.note.is_empty() { 56 } else { 76 })
        .margin_left(16)
        .margin_right(16)
        .margin_bottom(12)
        .x_label_area_size(56)
        .y_label_area_size(80)
        .build_cartesian_2d(xs.clone().log_scale(), ys.clone().log_scale())?;
    chart
        .configure_mesh()
        .x_desc(&measured.work)
        .y_desc(&measured.error)
        .x_label_formatter(&|value| label(*value))
        .y_label_formatter(&|value| label(*value))
        .x_labels(10)
        .y_labels(12)
        .axis_style(rgb(HEAVY_GRID))
        .bold_line_style(rgb(HEAVY_GRID))
        .light_line_style(rgb(GRID))
        .max_light_lines(4)
        .label_style(("sans-serif", 16).into_font().color(&rgb(QUIET)))
        .axis_desc_style(("sans-serif", 17).into_font().color(&rgb(TEXT)))
        .draw()?;
    let tolerance = [(xs.start, measured.tolerance), (xs.end, measured.tolerance)];
    let (on, off) = TOLERANCE_DASH;
    chart.draw_series(DashedLineSeries::new(tolerance, on, off, rgb(GOOD).stroke_width(2)))?;
    let mut orders: Vec<(i32, i32)> = Vec::new();
    for (index, curve) in measured.curves.iter().enumerate() {
        let look = Look::of(index, curve.origin);
        if let Some((order, point)) = curve.order().zip(curve.finest_fitted()) {
            let at = free_place(chart.backend_coord(&place(&point)), &orders);
            let style = ("sans-serif", 15).into_font().color(&rgb(look.colour));
            root.draw_text(&format!("{order:.1}"), &style, at)?;
            orders.push(at);
        }
        let line: Vec<_> = curve.points.iter().filter(|point| !point.blew_up()).map(place).collect();
        match look.dash {
            _ if line.len() < 2 => {}
            None => drop(chart.draw_series(LineSeries::new(line, stroke(&look)))?),
            Some((on, off)) => drop(chart.draw_series(DashedLineSeries::new(line, on, off, stroke(&look)))?),
        }
        for point in &curve.points {
            let marker = if point.blew_up() { Marker::Cross } else { look.marker };
            for piece in polygons((0, 0), marker, look.colour) {
                chart.draw_series(std::iter::once(EmptyElement::at(place(point)) + piece))?;
            }
        }
    }
    for point in measured.shipped().into_iter().flat_map(|(_, points)| points) {
        chart.draw_series(std::iter::once(EmptyElement::at(place(&point)) + ring((0, 0))))?;
    }
    if let Some((_, point)) = measured.cheapest() {
        chart.draw_series(std::iter::once(EmptyElement::at(place(&point)) + frame((0, 0))))?;
    }
    legend(measured, root)
}

fn legend<'a>(measured: &Measured, root: &Area<'a>) -> Drawn<'a> {
    let style = ("sans-serif", 17).into_font().color(&rgb(TEXT));
    let quiet = ("sans-serif", 16).into_font().color(&rgb(QUIET));
    let mut y = 64;
    // Nearer to each other where there are many, so that all have room.
    let line = LINE.min((SIZE.1 as i32 - y) / (measured.curves.len() as i32 + NOTES));
    for (index, curve) in measured.curves.iter().enumerate() {
        let look = Look::of(index, curve.origin);
        sample(root, &look, y)?;
        for piece in polygons((LEGEND + 18, y), look.marker, look.colour) {
            root.draw(&piece)?;
        }
        root.draw_text(&with_order(curve), &style, (LEGEND + 46, y - 8))?;
        y += line;
    }
    y += line / 2;
    for x in (LEGEND..LEGEND + 36).step_by(6) {
        root.draw(&PathElement::new(vec![(x, y), (x + 2, y)], rgb(GOOD).stroke_width(2)))?;
    }
    let tolerance = if measured.tolerance == super::TOLERANCE {
        "a tenth of a pixel, 1/300 m".to_owned()
    } else {
        format!("tolerance: {}", number(measured.tolerance))
    };
    root.draw_text(&tolerance, &quiet, (LEGEND + 46, y - 8))?;
    y += line;
    if measured.shipped().is_some() {
        root.draw(&ring((LEGEND + 18, y)))?;
        root.draw_text("as shipped", &quiet, (LEGEND + 46, y - 8))?;
        y += line;
    }
    if measured.cheapest().is_some() {
        root.draw(&frame((LEGEND + 18, y)))?;
        root.draw_text("cheapest within the tolerance", &quiet, (LEGEND + 46, y - 8))?;
        y += line;
    }
    let points = || measured.curves.iter().flat_map(|curve| &curve.points);
    if points().any(WorkPoint::blew_up) {
        for piece in polygons((LEGEND + 18, y), Marker::Cross, QUIET) {
            root.draw(&piece)?;
        }
        root.draw_text("on the upper edge: blew up", &quiet, (LEGEND + 46, y - 8))?;
        y += line;
    }
    if points().any(|point| point.error < LEAST_ERROR) {
        root.draw_text("on the lower edge: no error", &quiet, (LEGEND, y))?;
        y += line;
    }
    root.draw_text("lower left is better", &quiet, (LEGEND, y))?;
    Ok(())
}

/// A piece of a curve's line, in the legend.
pub(super) fn sample<'a>(root: &Area<'a>, look: &Look, y: i32) -> Drawn<'a> {
    let (from, to) = (LEGEND, LEGEND + 36);
    let Some((on, off)) = look.dash else { return root.draw(&PathElement::new(vec![(from, y), (to, y)], stroke(look))) };
    let mut x = from;
    while x < to {
        let end = (x + on as i32).min(to);
        root.draw(&PathElement::new(vec![(x, y), (end, y)], stroke(look)))?;
        x = end + off as i32;
    }
    Ok(())
}

/// A curve's name, and its order where one is seen; a peer's name is long enough, and its order stands at the curve.
pub fn with_order(curve: &MethodCurve) -> String {
    let order = if curve.origin == CurveOrigin::Peer { None } else { curve.order() };
    order.map_or_else(|| curve.name.clone(), |order| format!("{}, order {order:.1}", curve.name))
}

/// Where an order is written: right of its point, or below what stands there.
fn free_place((x, y): (i32, i32), taken: &[(i32, i32)]) -> (i32, i32) {
    let mut at = (x + 10, y - 6);
    while taken.iter().any(|other| (other.0 - at.0).abs() < ORDER.0 && (other.1 - at.1).abs() < ORDER.1) {
        at.1 += ORDER.1;
    }
    at
}

pub(super) fn stroke(look: &Look) -> ShapeStyle {
    rgb(look.colour).stroke_width(look.width)
}

/// What a marker is made of, around a pixel.
pub(super) fn polygons((x, y): (i32, i32), marker: Marker, colour: u32) -> impl Iterator<Item = Polygon<(i32, i32)>> {
    marker.pieces().into_iter().map(move |piece| {
        let corners: Vec<(i32, i32)> = piece.into_iter().map(|(dx, dy)| (x + dx.round() as i32, y + dy.round() as i32)).collect();
        Polygon::new(corners, rgb(colour).filled())
    })
}

fn ring(at: (i32, i32)) -> Circle<(i32, i32), i32> {
    Circle::new(at, RING as i32, rgb(SHIPPED).stroke_width(2))
}

fn frame((x, y): (i32, i32)) -> Rectangle<(i32, i32)> {
    let half = FRAME as i32;
    Rectangle::new([(x - half, y - half), (x + half, y + half)], rgb(GOOD).stroke_width(2))
}

/// What an axis says at a value.
fn label(value: f64) -> String {
    let exponent = value.log10();
    if (exponent - exponent.round()).abs() > 1e-6 { number(value) } else { power(exponent.round() as i32) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_diagram_has_its_words_as_text_and_no_bad_numbers() {
        let point = |step, work, error| WorkPoint { step, work, error };
        let curve = |name: &str, origin, points| MethodCurve { name: name.to_owned(), origin, points };
        let measured = Measured::of_curves(vec![
            curve("wild", CurveOrigin::Lab, vec![point(0.1, 10.0, f64::NAN), point(0.01, 100.0, 1e-2)]),
            curve("ours", CurveOrigin::Shipped, vec![point(0.01, 50.0, 0.0)]),
        ]);
        let svg = svg(&measured).unwrap();
        for word in ["A title", "error, m", "work, ns", "wild", "ours", "as shipped", "blew up", "tolerance"] {
            assert!(svg.contains(word), "{word}");
        }
        assert!(!svg.contains("NaN") && !svg.contains("inf"));
    }
}
