//! The plot: buttons and readings on the left, the lanes with their curves on the right, a line of words at the foot.

use super::{Plot, PlotPlaces, hand::READINGS, hand::SAMPLE};
use crate::draw::chart::{CurveLook, Linear, marker, stroke};
use crate::draw::layout::{Area, DETAILS, GRID, MONO_ADVANCE, Vec2};
use crate::draw::{Canvas, Colour, Quads, Style};
use crate::instruments::{chart, chart::Chart, chart::ChartLane, curve::Curve, fit::Fit, quantity::Quantity, track::BodyTrack};
use crate::{number::scalar, view::theme, view::widgets, words::tr};
use std::ops::Range;

/// The least distance of labels, in heights of the text: to the right and upwards.
const APART: Vec2 = Vec2::new(6.0, 1.7);
/// Points within this many canvas units are drawn as one column.
const COLUMN: f64 = 1.5;
const TANGENT: f32 = 48.0;
/// Characters of a reading's number with its sign and its unit.
const NUMBER: usize = 10;
/// Opacity of the run before, and of the area under a curve.
const PALE: f32 = 0.45;
const SHADE: f32 = 0.22;
const HINT: &str =
    "While the world is frozen (B) a click leads to that moment. Shift and drag: an area. Wheel: zoom. N: the followed object.";

#[derive(Clone, Copy)]
struct Scale {
    area: Area,
    right: Linear,
    up: Linear,
}

impl Scale {
    fn at(&self, (x, y): (f64, f64)) -> Vec2 {
        let Area { min, size } = self.area;
        Vec2::new(min.x + size.x * self.right.part(x) as f32, min.y + size.y * (1.0 - self.up.part(y) as f32))
    }

    /// The numbers that one canvas unit spans.
    fn grain(&self) -> (f64, f64) {
        let span = |axis: Linear, length: f32| (axis.to - axis.from) / f64::from(length);
        (COLUMN * span(self.right, self.area.size.x), 0.5 * span(self.up, self.area.size.y))
    }

    /// The part of a line between the lane's left and right edge.
    fn within(&self, points: Vec<(f64, f64)>) -> Vec<Vec2> {
        let (left, right) = (self.area.min.x, self.area.max().x);
        let all: Vec<Vec2> = points.into_iter().map(|point| self.at(point)).collect();
        let inside = |at: &Vec2| (left..=right).contains(&at.x);
        let mut inside_lane: Vec<Vec2> = Vec::new();
        for (i, at) in all.iter().enumerate() {
            let edge = |other: &Vec2| {
                let x = other.x.clamp(left, right);
                *other + (*at - *other) * if at.x == other.x { 0.0 } else { (x - other.x) / (at.x - other.x) }
            };
            if inside(at) {
                inside_lane.extend(i.checked_sub(1).map(|before| &all[before]).filter(|before| !inside(before)).map(edge));
                inside_lane.push(*at);
            } else if let Some(before) = i.checked_sub(1).map(|before| &all[before]).filter(|before| inside(before)) {
                let x = at.x.clamp(left, right);
                inside_lane.push(*before + (*at - *before) * ((x - before.x) / (at.x - before.x)));
            }
        }
        inside_lane
    }
}

impl Plot {
    /// Draws all of the panel but its buttons.
    pub(super) fn draw_panel(&self, places: &PlotPlaces, chart: &Chart, canvas: &Canvas) {
        let panel = places.panel;
        canvas.end_layer();
        canvas.rounded(panel, 0.0, theme::panel());
        canvas.line(panel.min, Vec2::new(panel.max().x, panel.min.y), 2.0, theme::panel_edge());
        self.draw_lines(places, canvas);
        self.draw_lanes(places, chart, canvas);
        let fit = self.fit().zip(self.lines.get(self.selected)).map(|(fit, line)| fit.words(line.up, self.across));
        let (words, colour) = match (&self.message, &fit) {
            (Some((words, true)), _) => (words.as_str(), theme::bad()),
            (Some((words, false)), _) => (words.as_str(), theme::good()),
            (None, Some(words)) => (words.as_str(), theme::text()),
            (None, None) => (tr(HINT), theme::quiet()),
        };
        let style = Style::new(DETAILS, colour).middle();
        let at = Vec2::new(places.foot.min.x, places.foot.centre().y);
        // Of advice as many sentences as have room.
        let fits = |words: &&str| canvas.width(words, style) <= places.foot.size.x;
        let ends = words.char_indices().rev().filter(|(_, sign)| *sign == '.').map(|(at, _)| &words[..=at]);
        let whole = ends.filter(|_| words == tr(HINT)).find(fits).unwrap_or(words);
        canvas.text(&widgets::cut(canvas, whole, places.foot.size.x, style), at, style);
    }

    /// For each curve a sample, and below the buttons its readings.
    fn draw_lines(&self, places: &PlotPlaces, canvas: &Canvas) {
        let line = canvas.line_height(DETAILS);
        for ((i, reading), area) in self.readings().into_iter().enumerate().zip(&places.lines) {
            if i == self.selected {
                canvas.rounded(area.inset(-1.0), 4.0, theme::panel_hover());
            }
            let look = chart::curve_look(i, self.lines[i].up);
            let colour = Colour::hex(look.colour);
            let middle = Vec2::new(area.min.x, area.min.y + line / 2.0 + 2.0);
            stroke(canvas, &[middle, middle + Vec2::new(SAMPLE, 0.0)], &look, colour);
            marker(canvas, middle + Vec2::new(SAMPLE / 2.0, 0.0), look.marker, colour);
            let y = area.max().y - line / 2.0 - 2.0;
            let style = Style::new(DETAILS, theme::text()).mono().middle();
            let names = ["", tr("slope "), tr("area ")].map(|name| (name, canvas.width(name, style)));
            let number_width = NUMBER as f32 * MONO_ADVANCE * canvas.frame().text_height(DETAILS);
            let spare = area.size.x - GRID - names.map(|(_, width)| width + number_width).iter().sum::<f32>();
            let apart = (spare / (READINGS - 1) as f32).max(0.0);
            // A longer number moves those right of it.
            let (mut column, mut free) = (area.min.x + GRID / 2.0, area.min.x);
            for ((number, unit), (name, width)) in reading.numbers.into_iter().zip(names) {
                let x = column.max(free);
                let words = number.map_or_else(|| "–".to_owned(), |number| scalar(number, &unit.name()));
                canvas.text(name, Vec2::new(x, y), Style { colour: theme::quiet(), ..style });
                canvas.text(words.trim_end(), Vec2::new(x + width, y), style);
                free = x + width + canvas.width(words.trim_end(), style) + GRID;
                column += width + number_width + apart;
            }
        }
    }

    fn draw_lanes(&self, places: &PlotPlaces, chart: &Chart, canvas: &Canvas) {
        let text = canvas.frame().text_height(DETAILS);
        let areas = places.lanes(chart.lanes.len());
        for (lane, area) in chart.lanes.iter().zip(&areas) {
            let scale = Scale { area: *area, right: chart.axis, up: lane.axis };
            canvas.rounded(*area, 0.0, theme::ground());
            self.draw_axes(&scale, lane, text, canvas);
            self.draw_area(&scale, lane, canvas);
            self.draw_impacts(&scale, canvas);
            for number in &lane.curves {
                self.draw_curve(*number, &scale, canvas);
            }
            if lane.curves.contains(&self.selected) {
                self.draw_fit(&scale, canvas);
            }
            self.draw_name(lane, *area, text, canvas);
        }
        self.draw_moment(chart, &areas, canvas);
        let foot = Vec2::new(places.plot.max().x, places.plot.max().y);
        let quiet = Style::new(DETAILS, theme::quiet()).middle();
        let below = foot.y + 0.7 * text;
        let name = self.across.heading();
        let room = foot.x - canvas.width(&name, quiet) - GRID;
        canvas.text(&name, Vec2::new(foot.x, below), quiet.right());
        for (value, words) in chart.axis.named((places.plot.size.x / (APART.x * text)) as usize) {
            let x = places.plot.min.x + places.plot.size.x * chart.axis.part(value) as f32;
            if x + canvas.width(&words, quiet) / 2.0 < room {
                canvas.text(&words, Vec2::new(x, below), quiet.centred());
            }
        }
        if chart.lanes.is_empty() {
            canvas.text(tr("Nothing is plotted: + Curve."), places.plot.centre(), quiet.centred());
        }
    }

    fn draw_axes(&self, scale: &Scale, lane: &ChartLane, text: f32, canvas: &Canvas) {
        let (area, end) = (scale.area, scale.area.max());
        let quiet = Style::new(DETAILS, theme::quiet()).middle();
        for (value, words) in lane.axis.named((area.size.y / (APART.y * text)).max(1.0) as usize) {
            let y = scale.at((scale.right.from, value)).y;
            let colour = if value == 0.0 { theme::solid_top() } else { theme::panel_edge() };
            canvas.hairline(Vec2::new(area.min.x, y), Vec2::new(end.x, y), colour);
            canvas.text(&words, Vec2::new(area.min.x - GRID, y), quiet.right());
        }
        for (value, _) in scale.right.named((area.size.x / (APART.x * text)) as usize) {
            let x = scale.at((value, 0.0)).x;
            canvas.hairline(Vec2::new(x, area.min.y), Vec2::new(x, end.y), theme::panel_edge());
        }
    }

    fn draw_name(&self, lane: &ChartLane, area: Area, text: f32, canvas: &Canvas) {
        let (name, style) = (lane.name(|number| self.lines[number].up.symbol()), Style::new(DETAILS, theme::text()).middle());
        let size = Vec2::new(canvas.width(&name, style) + GRID, 1.4 * text);
        let under = Area { min: area.min + Vec2::new(GRID / 2.0, 1.0), size };
        canvas.rounded(under, 4.0, theme::ground().faded(0.85));
        canvas.text(&name, Vec2::new(under.min.x + GRID / 2.0, under.centre().y), style);
    }

    fn draw_curve(&self, number: usize, scale: &Scale, canvas: &Canvas) {
        let line = &self.lines[number];
        let object = &self.objects[line.whose];
        let look = chart::curve_look(number, line.up);
        let colour = Colour::hex(look.colour);
        let window = self.window();
        if let Some(track) = object.before() {
            let pale = CurveLook { dash: None, width: 1, ..look };
            self.draw_pieces(&line.before, track.places(window), (scale, &pale, colour.faded(PALE)), canvas);
        }
        if let Some(track) = object.track() {
            self.draw_pieces(&line.now, track.places(window), (scale, &look, colour), canvas);
        }
    }

    fn draw_pieces(
        &self,
        curve: &Curve,
        places: Range<usize>,
        (scale, look, colour): (&Scale, &CurveLook, Colour),
        canvas: &Canvas,
    ) {
        for piece in curve.drawn(places, scale.grain()) {
            stroke(canvas, &scale.within(piece), look, colour);
        }
    }

    fn draw_fit(&self, scale: &Scale, canvas: &Canvas) {
        let line = scale.within(self.fit().into_iter().flat_map(Fit::drawn).collect());
        let inside = |at: &Vec2| (scale.area.min.y..=scale.area.max().y).contains(&at.y);
        for pair in line.windows(2).filter(|pair| pair.iter().all(inside)) {
            canvas.line(pair[0], pair[1], 1.5, theme::text());
        }
    }

    /// The ends of its stretch, and what lies between the selected curve and 0.
    fn draw_area(&self, scale: &Scale, lane: &ChartLane, canvas: &Canvas) {
        let Some((number, line, track)) = self.shown().find(|(number, ..)| *number == self.selected) else { return };
        if !lane.curves.contains(&number) {
            return;
        }
        let (from, to) = self.stretch(track);
        if self.span.is_some() && self.across == Quantity::Time {
            for place in [from, to] {
                let x = scale.at((track.time(place), 0.0)).x;
                canvas.hairline(Vec2::new(x, scale.area.min.y), Vec2::new(x, scale.area.max().y), theme::text());
            }
        }
        if !line.up.has_area() {
            return;
        }
        let colour = Colour::hex(chart::curve_look(number, line.up).colour).faded(SHADE);
        let within = track.places(self.window());
        let stretch = from.max(within.start)..(to + 1).min(within.end);
        let zero = scale.at((0.0, 0.0)).y.clamp(scale.area.min.y, scale.area.max().y);
        let foot = |at: Vec2| Vec2::new(at.x, zero);
        let mut quads = Quads::default();
        let mut triangle = |corners: [Vec2; 3]| quads.triangle(corners, colour);
        for piece in line.now.drawn(stretch.start..stretch.end.max(stretch.start), scale.grain()) {
            for pair in scale.within(piece).windows(2) {
                let (a, b) = (pair[0], pair[1]);
                if (a.y - zero) * (b.y - zero) < 0.0 {
                    let crossing = foot(a + (b - a) * ((zero - a.y) / (b.y - a.y)));
                    triangle([foot(a), a, crossing]);
                    triangle([crossing, b, foot(b)]);
                } else {
                    triangle([foot(a), a, b]);
                    triangle([foot(a), b, foot(b)]);
                }
            }
        }
        canvas.quads(quads);
    }

    fn draw_impacts(&self, scale: &Scale, canvas: &Canvas) {
        if self.across != Quantity::Time {
            return;
        }
        let mut drawn = f32::NEG_INFINITY;
        for track in self.objects.iter().filter_map(super::PlotObject::track) {
            for place in &track.impacts {
                let x = scale.at((track.time(*place), 0.0)).x;
                // One of many at one place.
                if !(scale.area.min.x..=scale.area.max().x).contains(&x) || (x - drawn).abs() < 2.0 {
                    continue;
                }
                drawn = x;
                let mut y = scale.area.min.y;
                while y < scale.area.max().y {
                    let end = (y + 2.0).min(scale.area.max().y);
                    canvas.hairline(Vec2::new(x, y), Vec2::new(x, end), theme::IMPACT);
                    y += 6.0;
                }
                let top = Vec2::new(x, scale.area.min.y);
                canvas.convex(&[top + Vec2::new(-4.0, 0.0), top + Vec2::new(4.0, 0.0), top + Vec2::new(0.0, 7.0)], theme::IMPACT);
            }
        }
    }

    /// The moment on the screen: an upright line over time, a marker on each curve, and the tangent of the selected one.
    fn draw_moment(&self, chart: &Chart, areas: &[Area], canvas: &Canvas) {
        let place = |track: &BodyTrack| track.place(self.now);
        if let (Quantity::Time, Some((_, _, track)), Some((first, last))) =
            (self.across, self.shown().next(), areas.first().zip(areas.last()))
        {
            let part = chart.axis.part(track.time(place(track))) as f32;
            if (0.0..=1.0).contains(&part) {
                let x = first.min.x + first.size.x * part;
                canvas.line(Vec2::new(x, first.min.y), Vec2::new(x, last.max().y), 1.5, theme::accent());
            }
        }
        for (number, line, track) in self.shown() {
            let Some(lane) = chart.lane_of(number) else { continue };
            let scale = Scale { area: areas[lane], right: chart.axis, up: chart.lanes[lane].axis };
            let Some(at) = line.now.point(place(track)).map(|point| scale.at(point)) else { continue };
            if !scale.area.inset(-1.0).contains(at) {
                continue;
            }
            let look = chart::curve_look(number, line.up);
            let colour = Colour::hex(look.colour);
            if let (true, Some(slope)) = (number == self.selected, line.now.slope(track, place(track))) {
                let size = scale.area.size;
                let right = f64::from(size.x) / (scale.right.to - scale.right.from);
                let up = slope * f64::from(size.y) / (scale.up.to - scale.up.from);
                let half = Vec2::new(right as f32, -up as f32).normalize_or_zero() * TANGENT;
                let inside = |end: Vec2| end.clamp(scale.area.min, scale.area.max());
                if half.is_finite() {
                    canvas.line(inside(at - half), inside(at + half), 1.0, theme::text());
                }
            }
            marker(canvas, at, look.marker, colour);
        }
    }
}
