//! A work–precision diagram: on the screen with one curve or point picked out, and on the paper of `resultant chart`.

use super::legend::{frame, legend_of_curves, legend_of_marks};
use super::looks::{look_of, name_of, shade};
use super::places::{DiagramPlaces, SLOPE};
use crate::draw::chart::{Decades, FRAME, Marker, RING, TOLERANCE_DASH, dashed, marker, stroke};
use crate::draw::layout::{Area, DETAILS, TEXT, Vec2};
use crate::draw::{Canvas, Colour, Style};
use crate::lab::curve::{GROWTH, Measured};
use crate::words::tr;
use crate::{lab::methods::motion::ADAPTIVE, number::power, number::short, view::theme, view::widgets};

/// The most powers of ten that an axis names.
const NAMED: i32 = 9;

/// The selection of a diagram.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Picked {
    pub curve: Option<usize>,
    /// The point under the pointer: its curve and its place in it.
    pub point: Option<(usize, usize)>,
}

pub fn draw(canvas: &Canvas, plot: &DiagramPlaces, measured: &Measured, picked: Picked) {
    widgets::panel(canvas, plot.panel);
    axes(canvas, plot, measured);
    let tolerance = plot.upwards(plot.axes.error.part(measured.tolerance));
    let ends = [Vec2::new(plot.area.min.x, tolerance), Vec2::new(plot.area.max().x, tolerance)];
    dashed(canvas, &ends, TOLERANCE_DASH, 2.0, theme::good());
    slopes(canvas, plot, measured);
    for (index, curve) in measured.curves.iter().enumerate() {
        let look = look_of(&curve.name, curve.origin, index);
        let colour = shade(Colour::hex(look.colour), picked.curve.is_none_or(|picked| picked == index));
        let line: Vec<Vec2> = curve.points.iter().filter(|point| !point.blew_up()).map(|point| plot.at(point)).collect();
        stroke(canvas, &line, &look, colour);
        for point in &curve.points {
            let shape = if point.blew_up() { Marker::Cross } else { look.marker };
            marker(canvas, plot.at(point), shape, colour);
        }
    }
    for point in measured.shipped().into_iter().flat_map(|(_, points)| points) {
        canvas.ring(plot.at(&point), RING + 1.0, 2.0, theme::accent());
    }
    if let Some((_, point)) = measured.cheapest() {
        frame(canvas, plot.at(&point), FRAME);
    }
    legend_of_curves(canvas, plot, measured, picked.curve);
    legend_of_marks(canvas, plot, measured);
    if let Some(point) = picked.point {
        tip(canvas, plot, measured, point);
    }
}

/// Triangles of the orders that curves show, on one base: ten times the work divides the error by 10 to the order.
fn slopes(canvas: &Canvas, plot: &DiagramPlaces, measured: &Measured) {
    let Some((orders, room)) = plot.slopes(measured, canvas.frame()) else { return };
    let (decade, quiet) = (plot.decade(), theme::quiet());
    let base = SLOPE.min(decade.x);
    let end = room.max();
    let corner = end - Vec2::new(base, 0.0);
    let up = |order: i32| corner - Vec2::new(0.0, order as f32 * decade.y * base / decade.x);
    canvas.line(corner, end, 1.0, quiet);
    orders.last().into_iter().for_each(|highest| canvas.line(corner, up(*highest), 1.0, quiet));
    let mut free = f32::INFINITY;
    for order in orders {
        let at = up(order);
        canvas.line(at, end, 1.0, quiet);
        if at.y <= free {
            canvas.text(&order.to_string(), at - Vec2::new(6.0, 0.0), Style::new(DETAILS, quiet).middle().right());
            free = at.y - canvas.frame().text_height(DETAILS);
        }
    }
}

fn axes(canvas: &Canvas, plot: &DiagramPlaces, measured: &Measured) {
    let (area, end) = (plot.area, plot.area.max());
    let quiet = Style::new(DETAILS, theme::quiet()).middle();
    let upright = |x: f32, colour| canvas.hairline(Vec2::new(x, area.min.y), Vec2::new(x, end.y), colour);
    let level = |y: f32, colour| canvas.hairline(Vec2::new(area.min.x, y), Vec2::new(end.x, y), colour);
    let part = |decades: &Decades, exponent: i32| f64::from(exponent - decades.from) / f64::from(decades.to - decades.from);
    canvas.rounded(area, 0.0, theme::ground());
    let (work, error) = (&plot.axes.work, &plot.axes.error);
    work.named(NAMED).for_each(|exponent| upright(plot.across(part(work, exponent)), theme::panel_edge()));
    error.named(NAMED).for_each(|exponent| level(plot.upwards(part(error, exponent)), theme::panel_edge()));
    for edge in [area.min.x, end.x] {
        upright(edge, theme::solid());
    }
    for edge in [area.min.y, end.y] {
        level(edge, theme::solid());
    }
    let down = (1.05 * canvas.frame().text_height(DETAILS)).max(18.0);
    for exponent in work.named(NAMED) {
        canvas.text(&power(exponent), Vec2::new(plot.across(part(work, exponent)), end.y + down), quiet.centred());
    }
    for exponent in error.named(NAMED) {
        canvas.text(&power(exponent), Vec2::new(area.min.x - 10.0, plot.upwards(part(error, exponent))), quiet.right());
    }
    let words = Style::new(TEXT, theme::text()).middle();
    canvas.text(tr(&measured.error), Vec2::new(area.min.x, area.min.y - 22.0), words);
    canvas.text(tr(&measured.work), Vec2::new(area.centre().x, end.y + 26.0 + down), words.centred());
}

/// The values of a point, beside it and inside the panel, above all else.
fn tip(canvas: &Canvas, plot: &DiagramPlaces, measured: &Measured, (curve, index): (usize, usize)) {
    let Some((curve, point)) = measured.curves.get(curve).and_then(|curve| Some((curve, curve.points.get(index)?))) else { return };
    let error = if point.blew_up() {
        tr("blew up").to_owned()
    } else if measured.name == GROWTH {
        with_unit(point.error, &measured.error)
    } else {
        tr!("error {error}", error = with_unit(point.error, &measured.error))
    };
    let lines = [
        if curve.name == ADAPTIVE {
            tr!("{method}, tolerance {tolerance}", method = name_of(&curve.name, curve.origin), tolerance = curve.setting(*point))
        } else {
            tr!("{method}, step {step}", method = name_of(&curve.name, curve.origin), step = curve.setting(*point))
        },
        format!("{}, {error}", with_unit(point.work, &measured.work)),
    ];
    let style = Style::new(TEXT, theme::text()).middle();
    let line = canvas.line_height(TEXT);
    let width = lines.iter().map(|text| canvas.width(text, style)).fold(0.0, f32::max);
    let size = Vec2::new(width + 32.0, 2.0 * line + 16.0);
    let at = plot.at(point);
    let above = Vec2::new(at.x - size.x / 2.0, at.y - size.y - 20.0);
    let below = Vec2::new(above.x, at.y + 20.0);
    let inside = plot.panel.inset(8.0);
    let corner = if above.y < inside.min.y { below } else { above }.clamp(inside.min, (inside.max() - size).max(inside.min));
    canvas.end_layer();
    widgets::panel_in(canvas, Area { min: corner, size }, theme::panel_hover(), theme::solid_top());
    for (i, text) in lines.iter().enumerate() {
        canvas.text(text, corner + Vec2::new(16.0, 8.0 + (i as f32 + 0.5) * line), style);
    }
}

/// A number with the unit at the end of an axis' name, as in "error of position, m".
pub fn with_unit(value: f64, axis: &str) -> String {
    let unit = axis.rsplit_once(", ").and_then(|(_, unit)| unit.split_whitespace().next()).unwrap_or_default();
    format!("{} {unit}", short(value)).trim_end().to_owned()
}
