//! The complex plane of z = h·λ on the canvas with its legend, and the stability regions of methods in it.

use super::looks::{look_of, shade};
use crate::draw::chart::{CurveLook, CurveOrigin, WORDS as WORDS_AT, marker, sample, stroke};
use crate::draw::layout::{Area, DETAILS, Frame, TEXT, Vec2, words_width};
use crate::draw::{Canvas, Colour, Style};
use crate::lab::stability::{CELLS, Complex, FAR, IMAGINARY, PART, REAL, Region, SHIPPED, SHIPPED_LIMITS, examples, limit, place};
use crate::{lab::methods::METHODS, number::fixed, view::theme, view::widgets, words::tr};

/// Margins of the plane in its panel, for values and names of the axes.
const LEFT: f32 = 64.0;
const TOP: f32 = 48.0;
const BOTTOM: f32 = 62.0;
const LEGEND: f32 = 400.0;
/// The most of the panel's width that it takes.
const LARGEST: f32 = 0.46;
/// Above and below the legend.
const MARGIN: f32 = 16.0;
const BETWEEN: f32 = 32.0;
/// Line height of the legend, where there is room, and of the words below it.
const LINE: f32 = 30.0;
const SMALL_LINE: f32 = 20.0;
/// The two limits, and the marks.
const MARKS: [&str; 4] = [
    "h/τ: drag alone, without a spring.",
    "ω·h: a swing without drag.",
    "Marks on the two rays: these limits.",
    "* no single z: growth of the oscillator.",
];

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    pub panel: Area,
    /// Between the axes: equal scales to the right and upwards.
    pub area: Area,
    /// Canvas units a unit of z.
    scale: f32,
    /// Above and below the legend, its line height and its width.
    margin: f32,
    pitch: f32,
    legend: f32,
    /// Width of a column of limits.
    column: f32,
}

impl Plane {
    /// As large as the panel allows without stretching.
    pub fn of(panel: Area, frame: &Frame) -> Self {
        let text = frame.text_height(DETAILS);
        let (letters, names) = (frame.text_height(TEXT), METHODS.iter().map(|(name, _)| *name).chain([PART, SHIPPED]));
        let widest = names.map(|name| words_width(tr(name), letters)).fold(0.0, f32::max) + words_width(" *", letters);
        let limits = [0.0, FAR, 2.0].map(|value| words_width(&limit(value), letters) + 1.5 * BESIDE);
        let column = limits.into_iter().fold(LIMITS, f32::max);
        let legend = LEGEND.max((WORDS_AT + widest + 2.0 * column + 2.0 * BESIDE + MARGIN).min(LARGEST * panel.size.x));
        let room = Vec2::new(panel.size.x - LEFT - BETWEEN - legend, panel.size.y - TOP - BOTTOM);
        let spans = Vec2::new((REAL.1 - REAL.0) as f32, (IMAGINARY.1 - IMAGINARY.0) as f32);
        let scale = (room.x / spans.x).min(room.y / spans.y);
        let size = spans * scale;
        let area = Area::new(panel.min.x + LEFT + (room.x - size.x) / 2.0, panel.min.y + TOP, size.x, size.y);
        let margin = if frame.text > 1.0 { MARGIN / 3.0 } else { MARGIN };
        let inside = panel.size.y - 2.0 * margin;
        let room = inside - MARKS.len() as f32 * SMALL_LINE;
        // Where words are large, the notes give way to the methods.
        let lines = (METHODS.len() + 2) as f32;
        let least = (1.08 * text).min(inside / lines);
        Self { panel, area, scale, margin, pitch: LINE.min(room / lines).max(least), legend, column }
    }

    /// As large as an area allows, at its left, without a legend.
    pub fn within(panel: Area) -> Self {
        let spans = Vec2::new((REAL.1 - REAL.0) as f32, (IMAGINARY.1 - IMAGINARY.0) as f32);
        let scale = (panel.size.x / spans.x).min(panel.size.y / spans.y);
        let area = Area { min: panel.min, size: spans * scale };
        Self { panel, area, scale, margin: MARGIN, pitch: LINE, legend: LEGEND, column: LIMITS }
    }

    /// A number on the canvas.
    pub fn at(&self, (re, im): Complex) -> Vec2 {
        Vec2::new(self.area.min.x + (re - REAL.0) as f32 * self.scale, self.area.max().y - (im - IMAGINARY.0) as f32 * self.scale)
    }

    /// A line of the legend: its head, then the methods, then the shipped engine and the notes.
    pub fn legend(&self, line: usize) -> Area {
        let top = self.panel.min.y + self.margin + line as f32 * self.pitch;
        Area::new(self.panel.max().x - self.legend, top, self.legend - 16.0, self.pitch)
    }
}

/// The words below the plane.
pub const WORDS: [&str; 2] = [
    "A point is a motion taken with a step h: how far it swings in a step stands upwards, how much it fades to the left. Both together are one complex number, z.",
    "Inside its edge a method's errors fade (implicit Euler's: outside). The truth fades in all of the left half, and so does the shipped engine on both rays.",
];

/// The least width of a column of limits.
const LIMITS: f32 = 72.0;
/// From an example's point to its words, and the most lines of these.
const BESIDE: f32 = 8.0;
const LINES: usize = 2;

/// The plane, the edges of all regions, and all of the picked one.
pub fn draw(canvas: &Canvas, plane: &Plane, regions: &[Region], picked: Option<usize>) {
    widgets::panel(canvas, plane.panel);
    canvas.rounded(plane.area, 0.0, theme::ground());
    if let Some(region) = picked.and_then(|picked| regions.get(picked)) {
        fill(canvas, plane, region);
    }
    axes(canvas, plane);
    let engine = look_of(SHIPPED, CurveOrigin::Shipped, 0);
    let rays: [[Complex; 2]; 2] = [[(REAL.0, 0.0), (0.0, 0.0)], [(0.0, 0.0), (0.0, IMAGINARY.1)]];
    for ray in rays {
        stroke(canvas, &ray.map(|z| plane.at(z)), &engine, theme::accent());
    }
    for (index, region) in regions.iter().enumerate() {
        let look = look_of(region.name, CurveOrigin::Lab, index);
        let colour = shade(Colour::hex(look.colour), picked.is_none_or(|picked| picked == index));
        for line in &region.edge {
            stroke(canvas, &line.iter().map(|z| plane.at(*z)).collect::<Vec<_>>(), &look, colour);
        }
        region.marks().for_each(|z| marker(canvas, plane.at(z), look.marker, colour));
    }
    for (name, z) in examples() {
        let (at, style) = (plane.at(z), Style::new(DETAILS, theme::text()).middle());
        canvas.ring(at, 5.0, 2.0, theme::text());
        // Decay stands to the left of its point, oscillation to the right.
        let left = z.0 < 0.0;
        let room = if left { at.x - plane.area.min.x } else { plane.area.max().x - at.x } - 2.0 * BESIDE;
        let whole = widgets::lines(canvas, tr(name), room, style);
        // Large words leave the curves their room: what stands behind the comma is the step of both.
        let brief = || widgets::lines(canvas, tr(name).split(", ").next().unwrap_or_default(), room, style);
        let lines = if whole.len() > LINES { brief() } else { whole };
        let size = Vec2::new(
            lines.iter().map(|words| canvas.width(words, style)).fold(0.0, f32::max),
            lines.len() as f32 * canvas.line_height(DETAILS),
        );
        let min = at + Vec2::new(if left { -BESIDE - size.x } else { BESIDE }, -BESIDE - size.y);
        canvas.rounded(Area { min, size }.inset(-2.0), 4.0, theme::ground().faded(0.9));
        for (line, words) in lines.iter().enumerate() {
            canvas.text(words, min + Vec2::new(0.0, (line as f32 + 0.5) * canvas.line_height(DETAILS)), style);
        }
    }
    legend(canvas, plane, regions, picked);
}

/// All cells in whose middle a method is stable; the outline shows their exact end.
fn fill(canvas: &Canvas, plane: &Plane, region: &Region) {
    let colour = theme::good().faded(0.16);
    for (row, cells) in region.inside.chunks(CELLS.0).enumerate() {
        let mut column = 0;
        for run in cells.chunk_by(|a, b| a == b) {
            let ends = [place(column as f64, row as f64 + 1.0), place((column + run.len()) as f64, row as f64)];
            let [min, max] = ends.map(|z| plane.at(z));
            if run[0] {
                canvas.rounded(Area { min, size: max - min }, 0.0, colour);
            }
            column += run.len();
        }
    }
}

fn axes(canvas: &Canvas, plane: &Plane) {
    let quiet = Style::new(DETAILS, theme::quiet()).middle();
    let (area, end) = (plane.area, plane.area.max());
    let down = (1.05 * canvas.frame().text_height(DETAILS)).max(16.0);
    for re in REAL.0.ceil() as i32..=REAL.1.floor() as i32 {
        let foot = plane.at((f64::from(re), 0.0));
        canvas.hairline(foot, Vec2::new(foot.x, area.min.y), theme::panel_edge());
        canvas.text(&fixed(f64::from(re), 0), foot + Vec2::new(0.0, down), quiet.centred());
    }
    for im in 0..=IMAGINARY.1.floor() as i32 {
        let left = plane.at((REAL.0, f64::from(im)));
        canvas.hairline(left, Vec2::new(end.x, left.y), theme::panel_edge());
        canvas.text(&format!("{im}i"), left - Vec2::new(10.0, 0.0), quiet.right());
    }
    canvas.rounded_edge(area, 0.0, 1.0, theme::solid());
    let words = Style::new(TEXT, theme::text()).middle();
    canvas.text(tr("imaginary part of z: ω·h, what swings"), Vec2::new(area.min.x, area.min.y - 22.0), words);
    canvas.text(tr("real part of z: −h/τ, what fades"), Vec2::new(area.centre().x, end.y + 24.0 + down), words.centred());
}

fn legend(canvas: &Canvas, plane: &Plane, regions: &[Region], picked: Option<usize>) {
    let engine = look_of(SHIPPED, CurveOrigin::Shipped, 0);
    let words = Style::new(TEXT, theme::text()).middle();
    let quiet = Style::new(TEXT, theme::quiet()).middle();
    let column = plane.column;
    let limits = |area: Area, texts: [&str; 2], style: Style| {
        for (text, columns) in texts.into_iter().zip([1.0, 0.0]) {
            canvas.text(text, Vec2::new(area.max().x - BESIDE - columns * column, area.centre().y), style.right());
        }
    };
    let head = plane.legend(0);
    canvas.text(tr("stable up to"), Vec2::new(head.min.x + WORDS_AT, head.centre().y), quiet);
    limits(head, ["h/τ", "ω·h"], quiet);
    let line = |line: usize, look: &CurveLook, (name, [drag, swing]): (String, [f64; 2]), whole: bool| {
        let area = plane.legend(line);
        let (y, colour) = (area.centre().y, shade(Colour::hex(look.colour), whole));
        sample(canvas, area, look, colour);
        let style = if whole { words } else { quiet };
        let room = area.size.x - WORDS_AT - 2.0 * column - BESIDE;
        canvas.text(&widgets::cut(canvas, &name, room, style), Vec2::new(area.min.x + WORDS_AT, y), style);
        limits(area, [&limit(drag), &limit(swing)], style);
    };
    let first = plane.legend(regions.len() + 2).min + Vec2::new(WORDS_AT, SMALL_LINE / 2.0);
    let note_at = |line: usize| first + Vec2::new(0.0, line as f32 * SMALL_LINE.max(1.05 * canvas.frame().text_height(DETAILS)));
    let has_note = |line: usize| note_at(line).y + 0.5 * canvas.line_height(DETAILS) <= plane.panel.max().y;
    // A sign without its note would be a riddle.
    let star = if has_note(MARKS.len() - 1) { " *" } else { "" };
    for (index, region) in regions.iter().enumerate() {
        if picked == Some(index) {
            canvas.rounded(plane.legend(index + 1), 6.0, theme::panel_hover());
        }
        let whole = picked.is_none_or(|picked| picked == index);
        let name = format!("{}{}", tr(region.name), if region.single { "" } else { star });
        line(index + 1, &look_of(region.name, CurveOrigin::Lab, index), (name, [region.drag, region.swing]), whole);
    }
    line(regions.len() + 1, &engine, (tr(SHIPPED).to_owned(), SHIPPED_LIMITS), true);
    for (line, words) in MARKS.into_iter().enumerate().filter(|(line, _)| has_note(*line)) {
        canvas.text(tr(words), note_at(line), Style::new(DETAILS, theme::quiet()).middle());
    }
}
