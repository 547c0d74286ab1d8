//! Several curves in one picture: one axis to the right, and a lane upwards for each unit, so that metres and metres a second never share
//! an axis. The screen and the exported picture draw the same.

use super::curve::Curve;
use super::quantity::Quantity;
use super::series::{Extremes, around};
use super::unit::Unit;
use crate::draw::chart::axes::Linear;
use std::ops::Range;

/// s.
pub type TimeWindow = (f64, f64);

#[derive(Clone, Debug, PartialEq)]
pub struct Chart {
    pub across: Quantity,
    pub axis: Linear,
    /// From the top.
    pub lanes: Vec<ChartLane>,
}

#[derive(Clone, Debug, PartialEq)]
pub struct ChartLane {
    pub unit: Unit,
    pub axis: Linear,
    /// As in [`ChartMember`].
    pub curves: Vec<usize>,
}

/// A curve with its number and its points in the window. Several may share a number: a curve of the run before has its successor's.
pub type ChartMember<'a> = (usize, &'a Curve, Range<usize>);

impl Chart {
    pub fn of(across: Quantity, window: TimeWindow, members: &[ChartMember]) -> Self {
        let mut found: Option<Extremes> = None;
        let mut lanes: Vec<(Unit, Option<Extremes>, Vec<usize>)> = Vec::new();
        for (number, curve, places) in members {
            let unit = curve.up().unit();
            let lane = lanes.iter().position(|(of, ..)| *of == unit).unwrap_or_else(|| {
                lanes.push((unit, None, Vec::new()));
                lanes.len() - 1
            });
            let (_, heights, numbers) = &mut lanes[lane];
            if !numbers.contains(number) {
                numbers.push(*number);
            }
            if let Some((widths, own)) = curve.extremes(places.clone()) {
                found = Some(found.map_or(widths, |found| around(found, widths)));
                *heights = Some(heights.map_or(own, |heights| around(heights, own)));
            }
        }
        let spread =
            |found: Option<Extremes>| found.map_or_else(|| Linear::between(-1.0, 1.0), |(least, most)| Linear::around(least, most));
        let axis = if across == Quantity::Time { Linear::between(window.0, window.1) } else { spread(found) };
        let lane = |(unit, heights, curves)| ChartLane { unit, axis: spread(heights), curves };
        Self { across, axis, lanes: lanes.into_iter().map(lane).collect() }
    }

    pub fn lane_of(&self, number: usize) -> Option<usize> {
        self.lanes.iter().position(|lane| lane.curves.contains(&number))
    }
}

impl ChartLane {
    /// The label of its axis: the symbols of its curves, and the unit.
    pub fn name(&self, symbol: impl Fn(usize) -> String) -> String {
        let mut symbols: Vec<String> = Vec::new();
        for symbol in self.curves.iter().map(|number| symbol(*number)) {
            if !symbols.contains(&symbol) {
                symbols.push(symbol);
            }
        }
        format!("{} ({})", symbols.join(", "), self.unit.name())
    }
}
