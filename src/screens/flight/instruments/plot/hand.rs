//! The pointer in the plot: it takes the world to another moment, marks a stretch, and with the wheel shows more or less of the flight. The plot's
//! panel is a band at the canvas' foot, with the flight above it, so that it covers nothing of that.

use super::{Plot, SHORTEST};
use crate::draw::layout::{Area, DETAILS, Frame, GRID, LINE, MONO_ADVANCE, Vec2, text_room};
use crate::{instruments::chart::Chart, instruments::quantity::Quantity, settings::Key, ui::input::Input};

/// The part of the stretch of time that a notch of the wheel leaves.
const NOTCH: f64 = 0.8;

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Hand {
    #[default]
    Empty,
    Cursor,
    /// One end of a stretch; the other is at that tick.
    End(u64),
}

impl Plot {
    pub(super) fn follow_pointer(&mut self, input: &Input, (places, chart): (&PlotPlaces, &Chart), seekable: bool) {
        let over = places.plot.contains(input.pointer);
        if over && input.wheel != 0.0 {
            self.zoom(input, places, chart);
        }
        if !(input.holding || input.click) {
            self.hand = Hand::Empty;
        }
        if !(self.hand != Hand::Empty || over && input.click) {
            return;
        }
        let Some(tick) = self.tick_at(input.pointer, places, chart) else { return };
        if over && input.click {
            self.hand = if input.held(Key::Shift) { Hand::End(self.other_end(tick)) } else { Hand::Cursor };
        }
        match self.hand {
            Hand::Cursor if seekable && tick != self.now => self.seek = Some(tick),
            Hand::Cursor | Hand::Empty => {}
            Hand::End(other) => self.span = (tick != other).then(|| (tick.min(other), tick.max(other))),
        }
    }

    /// The end that stays in a drag from `tick`: the far one of a stretch, if there is one.
    fn other_end(&self, tick: u64) -> u64 {
        // Nearer than this part of the window, the player means this end.
        const NEAR: f64 = 0.02;
        let (from, to) = self.window();
        let near = |end: u64| (end.abs_diff(tick) as f64) < NEAR * (to - from) * self.tick_rate;
        match self.span {
            Some((from, to)) if near(from) => to,
            Some((from, to)) if near(to) => from,
            _ => tick,
        }
    }

    fn zoom(&mut self, input: &Input, places: &PlotPlaces, chart: &Chart) {
        if chart.across != Quantity::Time {
            return;
        }
        let (first, last) = self.whole();
        let (from, to) = self.window();
        let part = f64::from((input.pointer.x - places.plot.min.x) / places.plot.size.x);
        let at = from + (to - from) * part;
        let length = ((to - from) * NOTCH.powf(f64::from(input.wheel))).clamp(SHORTEST, last - first);
        let from = (at - length * part).clamp(first, last - length);
        self.window = (length < last - first).then_some((from, from + length));
    }

    /// The tick of the point's time, or else of the nearest point of the curves of its lane.
    fn tick_at(&self, point: Vec2, places: &PlotPlaces, chart: &Chart) -> Option<u64> {
        let across = f64::from((point.x - places.plot.min.x) / places.plot.size.x);
        let (_, _, track) = self.shown().next()?;
        if chart.across == Quantity::Time {
            let time = chart.axis.value(across.clamp(0.0, 1.0));
            let place = track.place((time * self.tick_rate).round().max(0.0) as u64);
            return Some(track.tick_of(place));
        }
        let lanes = places.lanes(chart.lanes.len());
        let lane = lanes.iter().position(|lane| point.y < lane.max().y).unwrap_or(lanes.len().saturating_sub(1));
        let (area, axis) = (lanes.get(lane)?, chart.lanes[lane].axis);
        let up = f64::from((area.max().y - point.y) / area.size.y);
        let grain = ((chart.axis.to - chart.axis.from) / f64::from(area.size.x), (axis.to - axis.from) / f64::from(area.size.y));
        let nearest = |(number, line, track): (usize, &super::PlotLine, &crate::instruments::track::BodyTrack)| {
            let places = track.places(self.window());
            let (place, distance) = line.now.nearest(places, (chart.axis.value(across), axis.value(up)), grain)?;
            chart.lanes[lane].curves.contains(&number).then_some((track.tick_of(place), distance))
        };
        self.shown().filter_map(nearest).min_by(|(_, a), (_, b)| a.total_cmp(b)).map(|(tick, _)| tick)
    }

    /// The place of a curve at a tick; `None` where it is not drawn.
    pub fn at(&self, number: usize, tick: u64) -> Option<Vec2> {
        let (places, chart) = (self.places.as_ref()?, self.chart());
        let lane = chart.lane_of(number)?;
        let area = places.lanes(chart.lanes.len())[lane];
        let (_, line, track) = self.shown().find(|(i, ..)| *i == number)?;
        let (x, y) = line.now.point(track.place(tick))?;
        let (right, up) = (chart.axis.part(x) as f32, chart.lanes[lane].axis.part(y) as f32);
        Some(Vec2::new(area.min.x + area.size.x * right, area.max().y - area.size.y * up))
    }
}

/// Part of the canvas' height.
const LARGE: f32 = 0.6;
/// A curve each.
pub const MOST_LINES: usize = 4;
/// Characters of a reading: its name, a number with three digits, its sign and its unit.
const READING: usize = 18;
/// Value, slope, area.
pub const READINGS: usize = 3;
const GAP: f32 = 4.0;
pub const SAMPLE: f32 = 36.0;
const NUMBER: f32 = 7.0;

#[derive(Clone, Debug, PartialEq)]
pub struct PlotPlaces {
    pub panel: Area,
    /// The curves' lines: each a sample with its buttons, and its readings below.
    pub lines: Vec<Area>,
    pub plot: Area,
    pub foot: Area,
    head: Area,
    text: f32,
}

impl PlotPlaces {
    pub fn new(frame: &Frame, large: bool) -> Self {
        let text = frame.text_height(DETAILS);
        let line = text * LINE;
        let button = line + GAP;
        let curve = button + line + GAP;
        let least = button + MOST_LINES as f32 * curve + line + 3.0 * GRID;
        let height = if large { least.max(LARGE * frame.size.y) } else { least };
        let panel = Area::new(0.0, frame.size.y - height, frame.size.x, height);
        let inside = Area { min: panel.min + GRID, size: panel.size - 2.0 * GRID };
        let head = Area { size: Vec2::new(inside.size.x, button), ..inside };
        let left = ((READINGS * READING) as f32 * MONO_ADVANCE * text).min(0.5 * inside.size.x);
        let first = head.max().y + GRID / 2.0;
        let lines = (0..MOST_LINES).map(|i| Area::new(inside.min.x, first + i as f32 * curve, left, curve)).collect();
        let foot = Area::new(inside.min.x, inside.max().y - line, inside.size.x, line);
        let from = inside.min.x + left + NUMBER * MONO_ADVANCE * text + 2.0 * GRID;
        // The name of a lane stands at its upper edge, the numbers of the time below the lowest one.
        let plot = Area::new(from, first + GRID / 2.0, inside.max().x - GRID - from, foot.min.y - line - first - GRID / 2.0);
        Self { panel, lines, plot, foot, head, text }
    }

    /// Of equal height.
    pub fn lanes(&self, count: usize) -> Vec<Area> {
        let pitch = (self.plot.size.y + GRID) / count.max(1) as f32;
        let lane = |i: usize| Area::new(self.plot.min.x, self.plot.min.y + i as f32 * pitch, self.plot.size.x, pitch - GRID);
        (0..count).map(lane).collect()
    }

    pub fn head(&self, words: &[String]) -> Vec<Area> {
        row(self.head, self.text, words)
    }

    /// Right of its sample.
    pub fn line(&self, line: usize, words: &[String]) -> Vec<Area> {
        let Area { min, size } = self.lines[line];
        let beside = Vec2::new(SAMPLE + GRID, 0.0);
        row(Area { min: min + beside, size: Vec2::new(size.x - beside.x, self.head.size.y) }, self.text, words)
    }

    /// A list above the panel's foot: its panel, and its cells by block, row and column, the first of which has `wide` characters.
    pub fn picker(&self, blocks: &[usize], wide: usize, columns: usize) -> (Area, Vec<Vec<Vec<Area>>>) {
        const SYMBOL: usize = 9;
        let pitch = Vec2::new(text_room(&"m".repeat(SYMBOL), self.text).x, self.head.size.y);
        let name = text_room(&"m".repeat(wide), self.text).x;
        let block = name + columns as f32 * pitch.x + 2.0 * GRID;
        let rows = blocks.iter().copied().max().unwrap_or(0);
        let size = Vec2::new(blocks.len() as f32 * block + GRID, rows as f32 * (pitch.y + GAP) + 2.0 * GRID);
        let corner = Vec2::new((self.panel.max().x - size.x - GRID).min(self.lines[0].max().x), self.foot.min.y - size.y);
        let cell = |b: usize, r: usize, c: usize| {
            let x = b as f32 * block + GRID + if c == 0 { 0.0 } else { name + (c - 1) as f32 * pitch.x };
            let size = Vec2::new(if c == 0 { name } else { pitch.x - GAP }, pitch.y);
            Area { min: corner + Vec2::new(x, GRID + r as f32 * (pitch.y + GAP)), size }
        };
        let places = |(b, rows): (usize, &usize)| (0..*rows).map(|r| (0..=columns).map(|c| cell(b, r, c)).collect()).collect();
        (Area { min: corner, size }, blocks.iter().enumerate().map(places).collect())
    }
}

fn row(room: Area, text: f32, words: &[String]) -> Vec<Area> {
    let mut x = room.min.x;
    let mut button = |words: &String| {
        let width = text_room(words, text).x + GRID;
        let area = Area::new(x, room.min.y, width, room.size.y);
        x += width + GAP;
        area
    };
    words.iter().map(&mut button).collect()
}
