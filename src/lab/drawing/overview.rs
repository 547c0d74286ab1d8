//! The Lab's first page: small pictures of its charts, without legends; curves are named where there is room.

use super::looks::{look_of, name_of, shade};
use super::{places::Axes, places::points_along, plane::Plane};
use crate::draw::chart::{CurveOrigin, Marker, TOLERANCE_DASH, dashed, marker, stroke};
use crate::draw::layout::{Area, DETAILS, TEXT, Vec2};
use crate::draw::{Canvas, Colour, Style};
use crate::lab::stability::{self, Region, SHIPPED, SHIPPED_LIMITS, limit};
use crate::number::{fixed, power, short};
use crate::{lab::curve::Measured, lab::curve::MethodCurve, lab::savings::Saving, view::theme, view::widgets, words::tr};

/// The most of a small picture's width that the plane takes.
const MOST: f32 = 0.6;
/// Left of and below a small diagram: the powers of ten at its ends, and the names of its axes.
const LEFT: f32 = 44.0;
const ABOVE: f32 = 18.0;
const BELOW: f32 = 34.0;
/// Methods that are named in small pictures.
const NAMED: [&str; 6] = [SHIPPED, "explicit Euler", "RK4", "velocity Verlet", "implicit Euler", "Strang"];
/// Height of a row of bars, and the most of the width that its name and its numbers take; a longer name has a line of its own.
const ROW: f32 = 24.0;
const NAMES: f32 = 0.45;
const NUMBERS: f32 = 0.3;
/// From one point of a curve that names do not cover to the next.
const CLEAR: f32 = 4.0;

/// Its name, or of a peer that of the engine; `None` for curves that bear none here.
fn short_name(curve: &MethodCurve) -> Option<String> {
    match curve.origin {
        CurveOrigin::Peer => curve.name.split(' ').next().map(str::to_owned),
        _ => (NAMED.contains(&curve.name.as_str()) || curve.origin == CurveOrigin::Shipped)
            .then(|| name_of(&curve.name, curve.origin)),
    }
}

/// Words, without a remark in brackets at their end where they are too wide with it.
fn in_brief<'w>(canvas: &Canvas, words: &'w str, widest: f32, style: Style) -> &'w str {
    match words.split_once(" (") {
        Some((brief, _)) if canvas.width(words, style) > widest => brief,
        _ => words,
    }
}

/// A work–precision diagram: the ends of its axes, its curves, and some of their names.
pub fn diagram(canvas: &Canvas, area: Area, measured: &Measured) {
    let text = canvas.frame().text_height(DETAILS);
    let (left, above, below) = (LEFT.max(3.2 * text), ABOVE.max(1.1 * text), BELOW.max(2.2 * text));
    let plot = Area::new(area.min.x + left, area.min.y + above, area.size.x - left - 8.0, area.size.y - above - below);
    let (end, axes) = (plot.max(), Axes::of(measured));
    let quiet = Style::new(DETAILS, theme::quiet()).middle();
    canvas.rounded(plot, 0.0, theme::ground());
    canvas.rounded_edge(plot, 0.0, 1.0, theme::solid());
    canvas.text(&power(axes.work.from), Vec2::new(plot.min.x, end.y + 0.3 * below), quiet);
    canvas.text(&power(axes.work.to), Vec2::new(end.x, end.y + 0.3 * below), quiet.right());
    for exponent in axes.error.named((plot.size.y / (1.3 * text)).clamp(1.0, 4.0) as i32) {
        let y = plot.part((0.0, axes.error.part(10f64.powi(exponent)))).y;
        canvas.hairline(Vec2::new(plot.min.x, y), Vec2::new(end.x, y), theme::panel_edge());
        canvas.text(&power(exponent), Vec2::new(plot.min.x - 6.0, y), quiet.right());
    }
    let name = |words: &str, at: Vec2| canvas.text(&widgets::cut(canvas, tr(words), plot.size.x, quiet), at, quiet);
    name(&measured.error, Vec2::new(plot.min.x, area.min.y + 0.45 * above));
    let under = Vec2::new(area.centre().x, end.y + 0.76 * below);
    let work = in_brief(canvas, tr(&measured.work), area.size.x, quiet);
    widgets::fitted(canvas, work, under, area.size.x, &[DETAILS], theme::quiet());
    let level = axes.error.part(measured.tolerance);
    dashed(canvas, &[plot.part((0.0, level)), plot.part((1.0, level))], TOLERANCE_DASH, 2.0, theme::good());
    let mut named_curves = Vec::new();
    for (index, curve) in measured.curves.iter().enumerate().rev() {
        let look = look_of(&curve.name, curve.origin, index);
        let named = short_name(curve);
        let colour = shade(Colour::hex(look.colour), named.is_some());
        let places: Vec<Vec2> = curve.points.iter().map(|point| plot.part(axes.place(point))).collect();
        let drawn: Vec<Vec2> = curve.points.iter().zip(&places).filter(|(point, _)| !point.blew_up()).map(|(_, at)| *at).collect();
        stroke(canvas, &drawn, &look, colour);
        for (point, at) in curve.points.iter().zip(&places) {
            marker(canvas, *at, if point.blew_up() { Marker::Cross } else { look.marker }, colour);
        }
        named_curves.extend(named.map(|words| (words, drawn, colour)));
    }
    let mut names = Names::new(canvas, plot, named_curves.iter().flat_map(|(_, drawn, _)| points_along(drawn)).collect());
    for (words, drawn, colour) in &named_curves {
        names.place_along(words, drawn, *colour);
    }
    for point in measured.shipped().into_iter().flat_map(|(_, points)| points) {
        canvas.ring(plot.part(axes.place(&point)), 9.0, 2.0, theme::accent());
    }
}

/// Names beside their curves, each once, where none lies on another or, if that can be, on a curve that has a name.
struct Names<'c> {
    canvas: &'c Canvas,
    within: Area,
    /// Points along those curves.
    drawn: Vec<Vec2>,
    known: Vec<String>,
    taken: Vec<Area>,
}

impl<'c> Names<'c> {
    fn new(canvas: &'c Canvas, within: Area, drawn: Vec<Vec2>) -> Self {
        Self { canvas, within, drawn, known: Vec::new(), taken: Vec::new() }
    }

    /// Right or left of one of the points, or above or below it: where it covers the least, from the last point on.
    fn place_along(&mut self, words: &str, points: &[Vec2], colour: Colour) {
        if self.known.iter().any(|known| known == words) {
            return;
        }
        let style = Style::new(DETAILS, colour).middle();
        let size = Vec2::new(self.canvas.width(words, style), self.canvas.frame().text_height(DETAILS));
        let beside = |at: &Vec2| {
            let (middle, near) = (-size / 2.0, size / 2.0 + 10.0);
            let sides = [Vec2::new(near.x, 0.0), Vec2::new(-near.x, 0.0), Vec2::new(0.0, near.y), Vec2::new(0.0, -near.y)];
            let corners = [Vec2::ONE, Vec2::new(1.0, -1.0), Vec2::new(-1.0, 1.0), Vec2::new(-1.0, -1.0)].map(|to| to * near);
            let further = [1.0, -1.0].map(|side| Vec2::new(0.0, side * (near.y + size.y)));
            sides
                .into_iter()
                .chain(corners)
                .chain(further)
                .map(|offset| Area { min: *at + offset + middle, size })
                .collect::<Vec<_>>()
        };
        let free = |area: &Area| {
            let inside = area.min.cmpge(self.within.min).all() && area.max().cmple(self.within.max()).all();
            inside && area.inset(-2.0).covers_none(&self.taken)
        };
        let covered = |area: &Area| self.drawn.iter().filter(|at| area.inset(-CLEAR).contains(**at)).count();
        let places = points.iter().rev().flat_map(beside).filter(free);
        let Some(area) = places.min_by_key(covered) else { return };
        self.canvas.rounded(area.inset(-1.0), 3.0, theme::ground().faded(0.8));
        self.canvas.text(words, Vec2::new(area.min.x, area.centre().y), style);
        self.taken.push(area);
        self.known.push(words.to_owned());
    }
}

/// The plane of z with the edges of all regions, and how far some methods go on the ray of a swing.
pub fn plane(canvas: &Canvas, area: Area, regions: &[Region]) {
    let text = canvas.frame().text_height(DETAILS);
    let (left, below) = (2.2 * text, 1.2 * text);
    let shown = || regions.iter().enumerate().filter(|(_, region)| NAMED.contains(&region.name));
    let quiet = Style::new(DETAILS, theme::quiet()).middle();
    let named = shown().map(|(_, region)| (tr(region.name), region.swing)).chain([(tr(SHIPPED), SHIPPED_LIMITS[1])]);
    let columns = named.map(|(name, swing)| [canvas.width(name, quiet), canvas.width(&limit(swing), quiet)]);
    let [names, limits] = columns.fold([0.0_f32; 2], |[a, b], [c, d]| [a.max(c), b.max(d)]);
    // The names beside it are whole.
    let most = (MOST * area.size.x).min(area.size.x - left - names - limits - 40.0).max(1.0);
    let plane = Plane::within(Area::new(area.min.x + left, area.min.y + 4.0, most, area.size.y - below - 4.0));
    canvas.rounded(plane.area, 0.0, theme::ground());
    canvas.rounded_edge(plane.area, 0.0, 1.0, theme::solid());
    let [left, origin, right, top] =
        [(stability::REAL.0, 0.0), (0.0, 0.0), (stability::REAL.1, 0.0), (0.0, stability::IMAGINARY.1)].map(|z| plane.at(z));
    canvas.hairline(left, right, theme::solid_top());
    canvas.hairline(origin, top, theme::solid_top());
    for (index, region) in regions.iter().enumerate() {
        let look = look_of(region.name, CurveOrigin::Lab, index);
        let colour = shade(Colour::hex(look.colour), NAMED.contains(&region.name));
        for line in &region.edge {
            stroke(canvas, &line.iter().map(|z| plane.at(*z)).collect::<Vec<_>>(), &look, colour);
        }
    }
    canvas.text("z = h·λ", plane.area.min + Vec2::new(8.0, 0.6 * text), quiet);
    for re in [-4, -2, 0] {
        canvas.text(&fixed(f64::from(re), 0), plane.at((f64::from(re), 0.0)) + Vec2::new(0.0, 0.6 * below), quiet.centred());
    }
    for im in [1, 3] {
        canvas.text(&format!("{im}i"), plane.at((stability::REAL.0, f64::from(im))) - Vec2::new(8.0, 0.0), quiet.right());
    }
    let room = Area::new(plane.area.max().x + 16.0, area.min.y, area.max().x - plane.area.max().x - 24.0, area.size.y);
    // Its head, the methods, and the engine.
    let line = canvas.line_height(DETAILS).min(room.size.y / (NAMED.len() + 1) as f32).max(text);
    let row = |row: f32, name: &str, value: &str, colour: Colour| {
        let y = room.min.y + (row + 0.5) * line;
        if y + 0.5 * line > room.max().y + 1.0 {
            return;
        }
        let style = Style::new(DETAILS, colour).middle();
        let widest = room.size.x - canvas.width(value, style) - 8.0;
        canvas.text(&widgets::cut(canvas, name, widest, style), Vec2::new(room.min.x, y), style);
        canvas.text(value, Vec2::new(room.max().x, y), style.right());
    };
    row(0.0, tr("stable up to"), "ω·h", theme::quiet());
    row(1.0, tr(SHIPPED), &limit(SHIPPED_LIMITS[1]), theme::accent());
    for ((index, region), at) in shown().zip(2_u8..) {
        let colour = Colour::hex(look_of(region.name, CurveOrigin::Lab, index).colour);
        row(f32::from(at), tr(region.name), &limit(region.swing), colour);
    }
}

/// Bars of the time with every part, and within them as it runs; the largest saving first, as many rows as there is room for.
pub fn savings(canvas: &Canvas, area: Area, savings: &[Saving], title: impl Fn(&Saving) -> String) {
    let text = canvas.frame().text_height(DETAILS);
    let (style, row_height) = (Style::new(DETAILS, theme::text()).middle(), ROW.max(1.1 * text));
    let mut shown: Vec<&Saving> = savings.iter().collect();
    shown.sort_by(|a, b| b.times().total_cmp(&a.times()));
    shown.truncate(((area.size.y / row_height) as usize).saturating_sub(1));
    let titles: Vec<String> = shown.iter().map(|row| title(row)).collect();
    let widest = |words: &mut dyn Iterator<Item = f32>| words.fold(0.0, f32::max) + 12.0;
    let names = widest(&mut titles.iter().map(|title| canvas.width(title, style)));
    let beside = names <= NAMES * area.size.x;
    let factor = |row: &Saving| format!("× {}", short(row.times()));
    let times = |row: &Saving| format!("{} → {} ns", short(row.everything.0), short(row.planned.0));
    let width_of = |words: String| canvas.width(&words, style.mono());
    let factors = widest(&mut shown.iter().map(|row| width_of(factor(row))));
    let whole = factors + widest(&mut shown.iter().map(|row| width_of(times(row))));
    let is_whole = whole <= NUMBERS * area.size.x;
    let (names, lines) = if beside { (names, 1.0) } else { (0.0, 2.0) };
    let numbers = if is_whole { whole } else { factors };
    let bars = Area::new(area.min.x + names, area.min.y, area.size.x - names - numbers, area.size.y - row_height);
    let rows = (bars.size.y / (lines * row_height)) as usize;
    let longest = shown.iter().take(rows).map(|row| row.everything.0).fold(0.0, f64::max);
    for (i, (row, title)) in shown.into_iter().zip(&titles).take(rows).enumerate() {
        let top = bars.min.y + i as f32 * lines * row_height;
        let y = top + (lines - 0.5) * row_height;
        let bar = |ns: f64, colour| {
            canvas.rounded(Area::new(bars.min.x, y - 7.0, bars.size.x * (ns / longest) as f32, 14.0), 2.0, colour)
        };
        bar(row.everything.0, theme::solid());
        bar(row.planned.0, if row.same_bits { theme::accent() } else { theme::bad() });
        canvas.text(&widgets::cut(canvas, title, area.size.x, style), Vec2::new(area.min.x, top + 0.5 * row_height), style);
        canvas.text(&factor(row), Vec2::new(area.max().x, y), style.mono().right());
        if is_whole {
            canvas.text(&times(row), Vec2::new(area.max().x - factors, y), style.mono().right());
        }
    }
    let foot = Vec2::new(area.centre().x, area.max().y - row_height / 2.0);
    let words = tr("ns a tick: in colour as it runs, grey with everything");
    widgets::fitted(canvas, words, foot, area.size.x, &[TEXT, DETAILS], theme::quiet());
}
