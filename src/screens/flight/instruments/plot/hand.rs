//! The pointer in the plot: it takes the world to another moment, marks a stretch, and with the wheel shows more or less of the flight.

use super::{Plot, PlotPlaces, SHORTEST};
use crate::draw::layout::Vec2;
use crate::instruments::chart::Chart;
use crate::instruments::quantity::Quantity;
use crate::settings::Key;
use crate::ui::input::Input;

/// The part of the stretch of time that a notch of the wheel leaves.
const NOTCH: f64 = 0.8;

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Hand {
    #[default]
    Empty,
    /// The moment on the screen.
    Cursor,
    /// One end of a stretch; the other is at that tick.
    End(u64),
}

impl Hand {
    pub fn holds(self) -> bool {
        self != Self::Empty
    }
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
        if !(self.hand.holds() || over && input.click) {
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
