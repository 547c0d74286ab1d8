//! A work–precision diagram: on the screen with one curve or point picked out, and on the paper of `resultant chart`.
//! Places of a work–precision diagram on the canvas: plot, legend, points. Plain arithmetic; `diagram` draws it.

use super::look_of;
use crate::draw::chart::{
    CurveOrigin, Decades, FRAME, LEAST_ERROR, Marker, RING, SAMPLE, TOLERANCE_DASH, WORDS, dashed, marker, sample, stroke,
};
use crate::draw::layout::{Area, DETAILS, Frame, TEXT, Vec2};
use crate::draw::{Canvas, Colour, Style};
use crate::lab::curve::{Measured, MethodCurve, WorkPoint};
use crate::number::{power, short};
use crate::view::{theme, widgets};
use crate::{lab::TOLERANCE, lab::methods::motion::ADAPTIVE, words::tr};

/// The most powers of ten that an axis names.
const NAMED: i32 = 9;
/// The opacity of a curve while another is picked out.
const QUIETED: f32 = 0.2;
/// The longest base of the triangles of orders, canvas units.
const SLOPE: f32 = 120.0;

/// The selection of a diagram.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Picked {
    /// Index of a curve.
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
        frame(canvas, plot.at(&point));
    }
    legend_of_curves(canvas, plot, measured, picked.curve);
    legend_of_marks(canvas, plot, measured);
    if let Some(point) = picked.point {
        tip(canvas, plot, measured, point);
    }
}

/// Triangles of the orders that curves show, on one base: ten times the work divides the error by 10 to the order.
fn slopes(canvas: &Canvas, plot: &DiagramPlaces, measured: &Measured) {
    let orders = measured.curves.iter().filter_map(MethodCurve::order).map(|order| order.round() as i32);
    let orders: std::collections::BTreeSet<i32> = orders.collect();
    let (work, error) = (&plot.axes.work, &plot.axes.error);
    let decade = Vec2::new(plot.area.size.x / (work.to - work.from) as f32, plot.area.size.y / (error.to - error.from) as f32);
    let base = SLOPE.min(decade.x);
    let (corner, quiet) = (Vec2::new(plot.area.min.x + 24.0, plot.area.max().y - 12.0), theme::quiet());
    let Some(highest) = orders.last() else { return };
    let up = |order: i32| corner - Vec2::new(0.0, order as f32 * decade.y * base / decade.x);
    let end = corner + Vec2::new(base, 0.0);
    canvas.line(corner, end, 1.0, quiet);
    canvas.line(corner, up(*highest), 1.0, quiet);
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

/// A curve's name, with its order where one is seen; a peer's name is long enough.
fn with_order(curve: &MethodCurve) -> String {
    let order = if curve.origin == CurveOrigin::Peer { None } else { curve.order() };
    order.map_or_else(
        || tr(&curve.name).to_owned(),
        |order| tr!("{method}, order {order}", method = tr(&curve.name), order = format_args!("{order:.1}")),
    )
}

/// The colour, or its faded version on a panel.
pub(super) fn shade(colour: Colour, whole: bool) -> Colour {
    let part = if whole { 1.0 } else { QUIETED };
    let mix = |a: f32, b: f32| a * part + b * (1.0 - part);
    Colour::new(mix(colour.r, theme::panel().r), mix(colour.g, theme::panel().g), mix(colour.b, theme::panel().b), 1.0)
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

fn frame(canvas: &Canvas, at: Vec2) {
    canvas.rounded_edge(Area::around(at, Vec2::splat(2.0 * FRAME + 2.0)), 0.0, 2.0, theme::good());
}

/// A line of the legend: its area, the middle of its sample, and the start of its words.
fn line_of(plot: &DiagramPlaces, line: usize) -> (Area, Vec2, Vec2) {
    let area = plot.legend(line);
    let y = area.centre().y;
    (area, Vec2::new(area.min.x + SAMPLE / 2.0, y), Vec2::new(area.min.x + WORDS, y))
}

/// A name without the version of what it names: the last word before the first comma.
fn without_version(name: &str) -> String {
    let parts = name.split_once(", ").and_then(|(head, rest)| Some((head.rsplit_once(' ')?, rest)));
    match parts {
        Some(((engine, version), rest)) if version.starts_with(|letter: char| letter.is_ascii_digit()) => {
            format!("{engine}, {rest}")
        }
        _ => name.to_owned(),
    }
}

/// The curves' names in the legend and the size of all its words: whole names where these fit, or else what tells them apart.
fn names_of_curves(canvas: &Canvas, plot: &DiagramPlaces, measured: &Measured) -> (Vec<String>, f32) {
    let names: Vec<String> = measured.curves.iter().map(with_order).collect();
    let room = plot.legend(0).size.x - WORDS;
    let low = |size: f32| canvas.frame().text_height(size) <= plot.pitch;
    let fits = |size: f32| low(size) && names.iter().all(|name| canvas.width(name, Style::new(size, theme::text())) <= room);
    match [TEXT, DETAILS].into_iter().find(|size| fits(*size)) {
        Some(size) => (names, size),
        None => {
            let width = |name: &str| canvas.width(name, Style::new(DETAILS, theme::text()));
            let shorter = |(curve, name): (&MethodCurve, &String)| {
                let name = if canvas.frame().text > 1.0 && width(name) > room { tr(&curve.name) } else { name };
                without_version(name)
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

/// The meaning of the marks that are not curves.
fn legend_of_marks(canvas: &Canvas, plot: &DiagramPlaces, measured: &Measured) {
    let quiet = Style::new(names_of_curves(canvas, plot, measured).1, theme::quiet()).middle();
    let mut line = measured.curves.len();
    let mut note = |sample: &dyn Fn(Area, Vec2), text: &str| {
        let (area, middle, words) = line_of(plot, line);
        if area.max().y + area.size.y / 2.0 > plot.panel.max().y {
            return;
        }
        let down = Vec2::new(0.0, area.size.y / 2.0);
        sample(Area { min: area.min + down, ..area }, middle + down);
        canvas.text(text, words + down, quiet);
        line += 1;
    };
    let tolerance = if measured.tolerance == TOLERANCE {
        tr("a tenth of a pixel, 1/300 m").to_owned()
    } else {
        tr!("tolerance {tolerance}", tolerance = short(measured.tolerance))
    };
    let sample = |area: Area, middle: Vec2| {
        let ends = [Vec2::new(area.min.x, middle.y), Vec2::new(area.min.x + SAMPLE, middle.y)];
        dashed(canvas, &ends, TOLERANCE_DASH, 2.0, theme::good());
    };
    note(&sample, &tolerance);
    if measured.shipped().is_some() {
        note(&|_, middle| canvas.ring(middle, RING, 2.0, theme::accent()), tr("as shipped"));
    }
    if measured.cheapest().is_some() {
        note(&|_, middle| frame(canvas, middle), tr("cheapest within the tolerance"));
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
    note(&better, tr("lower left is better"));
    if measured.curves.iter().any(|curve| curve.name.contains("stiffness")) {
        note(&|_, _| {}, tr("stiffness: of contacts, as a spring"));
    }
    if measured.curves.iter().any(|curve| curve.order().is_some()) {
        note(&|_, _| {}, tr("triangles: slopes of orders"));
    }
    note(&|_, _| {}, tr("Logarithmic: equal steps"));
    note(&|_, _| {}, tr("multiply; 10⁻³ is 0.001"));
}

/// The values of a point, beside it and inside the panel, above all else.
fn tip(canvas: &Canvas, plot: &DiagramPlaces, measured: &Measured, (curve, index): (usize, usize)) {
    let Some((curve, point)) = measured.curves.get(curve).and_then(|curve| Some((curve, curve.points.get(index)?))) else { return };
    let error = if point.blew_up() {
        tr("blew up").to_owned()
    } else {
        tr!("error {error}", error = with_unit(point.error, &measured.error))
    };
    let lines = [
        if curve.name == ADAPTIVE {
            tr!("{method}, tolerance {tolerance}", method = tr(&curve.name), tolerance = curve.setting(*point))
        } else {
            tr!("{method}, step {step}", method = tr(&curve.name), step = curve.setting(*point))
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

/// Left of the plot: the error's powers of ten.
const LEFT: f32 = 80.0;
/// Above the plot: the name of the error.
const TOP: f32 = 48.0;
/// Below the plot: the work's powers of ten, and its name.
const BOTTOM: f32 = 64.0;
/// Width of the legend.
const LEGEND: f32 = 392.0;
/// Where words are large: the letters of a note, the width of a letter and of what stands around the words in heights of them, and the
/// most of the panel's width.
const LETTERS: usize = 35;
const LETTER: f32 = 0.44;
const AROUND: f32 = 3.0;
const MOST: f32 = 0.51;
/// Between the plot and the legend.
const BETWEEN: f32 = 32.0;
/// Line height of the legend, where there is room.
const LINE: f32 = 26.0;
/// Lines of the legend below the curves': tolerance, shipped, cheapest, the meaning of the edges, and a word on the axes.
const NOTES: usize = 10;
/// The pointer picks a point up to this far away.
const NEAR: f32 = 12.0;

/// The two logarithmic axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Axes {
    pub work: Decades,
    pub error: Decades,
}

impl Axes {
    pub fn of(measured: &Measured) -> Self {
        let points = || measured.curves.iter().flat_map(|curve| &curve.points);
        let errors = points().filter(|point| !point.blew_up()).map(|point| point.error.max(LEAST_ERROR));
        Self {
            work: Decades::around(points().map(|point| point.work).filter(|work| *work > 0.0)),
            error: Decades::around(errors.chain([measured.tolerance])),
        }
    }

    /// The parts of the axes to the right and upwards. A run that blew up is at the upper edge, one without error at the lower.
    pub fn place(&self, point: &WorkPoint) -> (f64, f64) {
        let up = if point.blew_up() { 1.0 } else { self.error.part(point.error.max(LEAST_ERROR)) };
        (self.work.part(point.work), up)
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DiagramPlaces {
    pub panel: Area,
    /// Between the axes.
    pub area: Area,
    pub axes: Axes,
    /// Line height of the legend, and its width.
    pitch: f32,
    legend: f32,
}

impl DiagramPlaces {
    pub fn of(panel: Area, measured: &Measured, frame: &Frame) -> Self {
        let text = frame.text_height(DETAILS);
        let letters = measured.curves.iter().map(|curve| tr(&curve.name).chars().count()).fold(LETTERS, usize::max);
        let large = ((LETTER * letters as f32 + AROUND) * text).min(MOST * panel.size.x);
        let legend = if frame.text > 1.0 { LEGEND.max(large) } else { LEGEND };
        let width = panel.size.x - LEFT - BETWEEN - legend;
        let area = Area::new(panel.min.x + LEFT, panel.min.y + TOP, width, panel.size.y - TOP - BOTTOM);
        let pitch = |lines: usize| (panel.size.y - 32.0) / lines.max(1) as f32;
        // Where words are large, notes give way to the curves.
        let least = (1.08 * text).min(pitch(measured.curves.len()));
        Self { panel, area, axes: Axes::of(measured), pitch: LINE.min(pitch(measured.curves.len() + NOTES)).max(least), legend }
    }

    pub fn at(&self, point: &WorkPoint) -> Vec2 {
        self.area.part(self.axes.place(point))
    }

    /// A part (0 … 1) of the work's axis.
    pub fn across(&self, part: f64) -> f32 {
        self.area.part((part, 0.0)).x
    }

    /// A part (0 … 1) of the error's axis.
    pub fn upwards(&self, part: f64) -> f32 {
        self.area.part((0.0, part)).y
    }

    /// A line of the legend: first the curves, then the notes.
    pub fn legend(&self, line: usize) -> Area {
        let top = self.panel.min.y + 16.0 + line as f32 * self.pitch;
        Area::new(self.panel.max().x - self.legend, top, self.legend - 16.0, self.pitch)
    }

    /// The point under the pointer: its curve and its place in it.
    pub fn point_near(&self, measured: &Measured, pointer: Vec2) -> Option<(usize, usize)> {
        let points = measured.curves.iter().enumerate().flat_map(|(curve, measured)| {
            measured.points.iter().enumerate().map(move |(index, point)| ((curve, index), self.at(point).distance(pointer)))
        });
        points.filter(|(_, distance)| *distance <= NEAR).min_by(|(_, a), (_, b)| a.total_cmp(b)).map(|(found, _)| found)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::draw::chart::CurveOrigin;
    use crate::lab::curve::MethodCurve;

    #[test]
    fn a_point_is_found_where_it_is_drawn() {
        let point = |work, error| WorkPoint { step: 0.1, work, spread: 0.0, error };
        let curve = MethodCurve {
            name: "a".into(),
            origin: CurveOrigin::Lab,
            version: String::new(),
            points: vec![point(10.0, 1.0), point(1e3, 1e-6), point(1e3, f64::NAN)],
        };
        let measured = Measured::of_curves(vec![curve]);
        let plot = DiagramPlaces::of(Area::new(24.0, 104.0, 1232.0, 488.0), &measured, &Frame::default());
        for (index, point) in measured.curves[0].points.iter().enumerate() {
            let at = plot.at(point);
            assert!(at.cmpge(plot.area.min).all() && at.cmple(plot.area.max()).all());
            assert_eq!(plot.point_near(&measured, at + 5.0), Some((0, index)));
        }
        assert_eq!(plot.point_near(&measured, plot.area.min + 60.0), None);
        assert!(plot.area.max().x < plot.legend(0).min.x && plot.legend(0).max().x <= plot.panel.max().x);
        assert!(plot.legend(NOTES).max().y <= plot.panel.max().y);
    }
}
