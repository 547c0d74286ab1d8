//! The Lab's first page: small pictures of its charts, without legends; curves are named where there is room.

use super::diagram::{Axes, shade};
use super::{look_of, plane::Plane};
use crate::draw::chart::{CurveOrigin, Marker, TOLERANCE_DASH, dashed, marker, stroke};
use crate::draw::layout::{Area, DETAILS, TEXT, Vec2};
use crate::draw::{Canvas, Colour, Style};
use crate::lab::curve::{Measured, MethodCurve};
use crate::lab::stability::{self, Region, SHIPPED, SHIPPED_LIMITS, limit};
use crate::number::{power, short};
use crate::view::{theme, widgets};
use crate::{lab::savings::Saving, words::tr};

/// Left of and below a small diagram: the powers of ten at its ends, and the names of its axes.
const LEFT: f32 = 44.0;
const ABOVE: f32 = 18.0;
const BELOW: f32 = 34.0;
/// Methods that are named in small pictures.
const NAMED: [&str; 6] = [SHIPPED, "explicit Euler", "RK4", "velocity Verlet", "implicit Euler", "Strang"];
/// A row of bars: its height, the room of its name and of its factor.
const ROW: f32 = 24.0;
const NAMES: f32 = 176.0;
const FACTORS: f32 = 64.0;

/// Its name, or of a peer that of the engine; `None` for curves that bear none here.
fn short_name(curve: &MethodCurve) -> Option<String> {
    match curve.origin {
        CurveOrigin::Peer => curve.name.split(' ').next().map(str::to_owned),
        _ => (NAMED.contains(&curve.name.as_str()) || curve.origin == CurveOrigin::Shipped).then(|| tr(&curve.name).to_owned()),
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
    // As many as there is room for.
    for exponent in axes.error.named((plot.size.y / (1.3 * text)).clamp(1.0, 4.0) as i32) {
        let y = plot.part((0.0, axes.error.part(10f64.powi(exponent)))).y;
        canvas.hairline(Vec2::new(plot.min.x, y), Vec2::new(end.x, y), theme::panel_edge());
        canvas.text(&power(exponent), Vec2::new(plot.min.x - 6.0, y), quiet.right());
    }
    let name = |words: &str, at: Vec2| canvas.text(&widgets::cut(canvas, tr(words), plot.size.x, quiet), at, quiet);
    name(&measured.error, Vec2::new(plot.min.x, area.min.y + 0.45 * above));
    let under = Vec2::new(area.centre().x, end.y + 0.76 * below);
    widgets::fitted(canvas, tr(&measured.work), under, area.size.x, &[DETAILS], theme::quiet());
    let level = axes.error.part(measured.tolerance);
    dashed(canvas, &[plot.part((0.0, level)), plot.part((1.0, level))], TOLERANCE_DASH, 2.0, theme::good());
    let mut names = Names::new(canvas, plot);
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
        if let Some(words) = named {
            drawn.iter().rev().chain(&drawn).any(|at| names.place(&words, *at, colour));
        }
    }
    for point in measured.shipped().into_iter().flat_map(|(_, points)| points) {
        canvas.ring(plot.part(axes.place(&point)), 9.0, 2.0, theme::accent());
    }
}

/// Names beside their curves, each once, where none lies on another.
struct Names<'c> {
    canvas: &'c Canvas,
    within: Area,
    known: Vec<String>,
    taken: Vec<Area>,
}

impl<'c> Names<'c> {
    fn new(canvas: &'c Canvas, within: Area) -> Self {
        Self { canvas, within, known: Vec::new(), taken: Vec::new() }
    }

    /// Right or left of a point, or above or below it; whether it stands there, or has stood before.
    fn place(&mut self, words: &str, at: Vec2, colour: Colour) -> bool {
        if self.known.iter().any(|known| known == words) {
            return true;
        }
        let style = Style::new(DETAILS, colour).middle();
        let size = Vec2::new(self.canvas.width(words, style), self.canvas.frame().text_height(DETAILS));
        let offsets = [
            Vec2::new(10.0, -size.y / 2.0),
            Vec2::new(-10.0 - size.x, -size.y / 2.0),
            Vec2::new(4.0, 8.0),
            Vec2::new(4.0, -8.0 - size.y),
        ];
        let free = offsets.into_iter().map(|offset| Area { min: at + offset, size }).find(|area| {
            let inside = area.min.cmpge(self.within.min).all() && area.max().cmple(self.within.max()).all();
            inside && area.inset(-2.0).covers_none(&self.taken)
        });
        let Some(area) = free else { return false };
        self.canvas.rounded(area.inset(-1.0), 3.0, theme::ground().faded(0.8));
        self.canvas.text(words, Vec2::new(area.min.x, area.centre().y), style);
        self.taken.push(area);
        self.known.push(words.to_owned());
        true
    }
}

/// The plane of z with the edges of all regions, and how far some methods go on the ray of a swing.
pub fn plane(canvas: &Canvas, area: Area, regions: &[Region]) {
    let plane = Plane::within(area.inset(4.0));
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
    let quiet = Style::new(DETAILS, theme::quiet()).middle();
    canvas.text("z = h·λ", plane.area.min + Vec2::new(8.0, 12.0), quiet);
    let room = Area::new(plane.area.max().x + 16.0, plane.area.min.y, area.max().x - plane.area.max().x - 24.0, plane.area.size.y);
    let line = canvas.line_height(DETAILS);
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
    let shown = regions.iter().enumerate().filter(|(_, region)| NAMED.contains(&region.name));
    let mut at = 1.0;
    for (index, region) in shown {
        row(at, tr(region.name), &limit(region.swing), Colour::hex(look_of(region.name, CurveOrigin::Lab, index).colour));
        at += 1.0;
    }
    row(at, tr(SHIPPED), &limit(SHIPPED_LIMITS[1]), theme::accent());
}

/// Bars of the time with every part, and within them as it runs; the largest saving first, as many rows as there is room for.
pub fn savings(canvas: &Canvas, area: Area, savings: &[Saving], title: impl Fn(&Saving) -> String) {
    let text = canvas.frame().text_height(DETAILS);
    let (row_height, names, factors) = (ROW.max(1.1 * text), NAMES.max(8.5 * text), FACTORS.max(4.5 * text));
    let bars = Area::new(area.min.x + names, area.min.y, (area.size.x - names - factors).max(1.0), area.size.y - row_height);
    let mut shown: Vec<&Saving> = savings.iter().collect();
    shown.sort_by(|a, b| b.times().total_cmp(&a.times()));
    shown.truncate((bars.size.y / row_height) as usize);
    let longest = shown.iter().map(|row| row.everything.0).fold(0.0, f64::max);
    for (i, row) in shown.into_iter().enumerate() {
        let y = bars.min.y + (i as f32 + 0.5) * row_height;
        let bar = |ns: f64, colour| {
            canvas.rounded(Area::new(bars.min.x, y - 7.0, bars.size.x * (ns / longest) as f32, 14.0), 2.0, colour)
        };
        bar(row.everything.0, theme::solid());
        bar(row.planned.0, if row.same_bits { theme::accent() } else { theme::bad() });
        let style = Style::new(DETAILS, theme::text()).middle();
        canvas.text(&widgets::cut(canvas, &title(row), names - 12.0, style), Vec2::new(area.min.x, y), style);
        canvas.text(&format!("× {}", short(row.times())), Vec2::new(area.max().x, y), style.mono().right());
    }
    let foot = Vec2::new(area.centre().x, area.max().y - row_height / 2.0);
    let words = tr("ns a tick: bright as it runs, dim with everything");
    widgets::fitted(canvas, words, foot, area.size.x, &[TEXT, DETAILS], theme::quiet());
}
