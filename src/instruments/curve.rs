//! A curve of one quantity of a body over another, tick by tick: the slope at a point, the area under a stretch, and the points to draw where there
//! are more of them than pixels. Its numbers have the extremes of any stretch in a few steps: a curve of an hour is drawn in a frame.

use super::{quantity::Quantity, track::BodyTrack};
use std::ops::Range;

#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    pub across: Quantity,
    pub up: Quantity,
    xs: NumberSeries,
    ys: NumberSeries,
    breaks: Vec<usize>,
}

impl Curve {
    pub fn new(across: Quantity, up: Quantity) -> Self {
        Self { across, up, xs: NumberSeries::default(), ys: NumberSeries::default(), breaks: Vec::new() }
    }

    /// Reads on along the track; a track that has become shorter is another flight's from there on.
    pub fn follow(&mut self, track: &BodyTrack) {
        self.truncate(track.len());
        let known = self.len();
        for place in known..track.len() {
            let moment = track.moment(place);
            self.xs.push(self.across.of(&moment));
            self.ys.push(self.up.of(&moment));
        }
        if self.up.jumps() || self.across.jumps() {
            self.breaks.extend(track.impacts.iter().copied().filter(|place| *place >= known.max(1)));
        }
    }

    pub fn truncate(&mut self, length: usize) {
        if length < self.len() {
            self.xs.truncate(length);
            self.ys.truncate(length);
            self.breaks.retain(|place| *place < length);
        }
    }

    pub fn columns(&self) -> [(Quantity, &[f64]); 2] {
        [(self.across, self.xs.values()), (self.up, self.ys.values())]
    }

    pub fn len(&self) -> usize {
        self.ys.values().len()
    }

    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    pub fn point(&self, place: usize) -> Option<(f64, f64)> {
        Some((*self.xs.values().get(place)?, *self.ys.values().get(place)?))
    }

    /// To the right and upwards; `None` without places.
    pub fn extremes(&self, places: Range<usize>) -> Option<(Extremes, Extremes)> {
        Some((self.xs.extremes(places.clone())?, self.ys.extremes(places)?))
    }

    /// The slope at a place: exactly, dy/dt over dx/dt, where both follow from the moment ([`Quantity::rate`]); else the central difference
    /// of the neighbours, and at an end or a break that of the one neighbour on this side. Nothing where the curve stands upright.
    pub fn slope(&self, track: &BodyTrack, place: usize) -> Option<f64> {
        if place >= self.len() {
            return None;
        }
        // Before the first tick nothing has acted yet.
        if let (true, Some(up)) = (place > 0, self.up.rate(&track.moment(place))) {
            match self.across.rate(&track.moment(place)) {
                Some(0.0) => return None,
                Some(across) => return Some(up / across),
                None => {}
            }
        }
        let broken = |place: usize| self.breaks.binary_search(&place).is_ok();
        let from = if place > 0 && !broken(place) { place - 1 } else { place };
        let to = if place + 1 < self.len() && !broken(place + 1) { place + 1 } else { place };
        let ((x0, y0), (x1, y1)) = (self.point(from)?, self.point(to)?);
        (x1 != x0).then(|| (y1 - y0) / (x1 - x0))
    }

    /// ∫ y dx from one place of its body's track to another: exactly where a law has it ([`BodyTrack::swept`]), else by the trapezoid rule, which is
    /// exact where the curve is straight from tick to tick; negative where the curve runs to the left, as work against a motion is.
    pub fn area(&self, track: &BodyTrack, from: usize, to: usize) -> f64 {
        if let (Quantity::Time, Some(area)) = (self.across, track.swept(self.up, from, to)) {
            return area;
        }
        let (xs, ys) = (self.xs.values(), self.ys.values());
        (from..to.min(self.len().saturating_sub(1))).map(|i| 0.5 * (ys[i] + ys[i + 1]) * (xs[i + 1] - xs[i])).sum()
    }

    /// The drawn part of some places: unbroken lines through points. Over time, points that share a column of width `grain.0` are drawn by
    /// their first, least and largest one; otherwise one that is nearer than the grain to the one drawn before is left out.
    pub fn drawn(&self, places: Range<usize>, grain: (f64, f64)) -> Vec<Vec<(f64, f64)>> {
        let places = places.start..places.end.min(self.len());
        let ends = self.breaks.iter().copied().filter(|place| places.contains(place)).chain([places.end]);
        let mut from = places.start;
        let mut ways = Vec::new();
        for end in ends {
            if from < end {
                let over_time = self.across == Quantity::Time;
                ways.push(if over_time { self.by_columns(from..end, grain.0) } else { self.apart(from..end, grain) });
            }
            from = end;
        }
        ways
    }

    fn by_columns(&self, stretch: Range<usize>, width: f64) -> Vec<(f64, f64)> {
        let (xs, ys) = (self.xs.values(), self.ys.values());
        let apart = if xs.len() > 1 { xs[1] - xs[0] } else { width };
        let together = (width / apart).ceil().max(1.0) as usize;
        if together <= 4 {
            return stretch.map(|i| (xs[i], ys[i])).collect();
        }
        let mut way = Vec::new();
        let mut from = stretch.start;
        while from < stretch.end {
            // Columns begin at the same points wherever the view does: nothing shimmers.
            let end = ((from / together + 1) * together).min(stretch.end);
            let middle = xs[usize::midpoint(from, end - 1)];
            way.push((xs[from], ys[from]));
            // The line between this point and the next column's stands for the points between.
            let next = if end < stretch.end { ys[end] } else { ys[from] };
            if let Some((least, largest)) = self.ys.extremes(from..end) {
                way.extend((least < ys[from].min(next)).then_some((middle, least)));
                way.extend((largest > ys[from].max(next)).then_some((middle, largest)));
            }
            from = end;
        }
        way.push((xs[stretch.end - 1], ys[stretch.end - 1]));
        way
    }

    fn apart(&self, stretch: Range<usize>, grain: (f64, f64)) -> Vec<(f64, f64)> {
        let (xs, ys) = (self.xs.values(), self.ys.values());
        let mut way: Vec<(f64, f64)> = Vec::new();
        let last = stretch.end - 1;
        for i in stretch {
            let far = way.last().is_none_or(|(x, y)| (xs[i] - x).abs() >= grain.0 || (ys[i] - y).abs() >= grain.1);
            if far || i == last {
                way.push((xs[i], ys[i]));
            }
        }
        way
    }

    /// Distances count in grains.
    pub fn nearest(&self, places: Range<usize>, (x, y): (f64, f64), grain: (f64, f64)) -> Option<(usize, f64)> {
        let (xs, ys) = (self.xs.values(), self.ys.values());
        let places = places.start..places.end.min(self.len());
        let distance = |i: usize| (((xs[i] - x) / grain.0).powi(2) + ((ys[i] - y) / grain.1).powi(2)).sqrt();
        places.map(|i| (i, distance(i))).min_by(|(_, a), (_, b)| a.total_cmp(b))
    }
}

const BLOCK: usize = 64;

pub type Extremes = (f64, f64);

#[derive(Clone, Debug, Default, PartialEq)]
pub struct NumberSeries {
    values: Vec<f64>,
    /// Of each full block.
    blocks: Vec<Extremes>,
}

impl NumberSeries {
    pub fn push(&mut self, value: f64) {
        self.values.push(value);
        if self.values.len().is_multiple_of(BLOCK) {
            self.blocks.extend(extremes(&self.values[self.values.len() - BLOCK..]));
        }
    }

    pub fn truncate(&mut self, length: usize) {
        self.values.truncate(length);
        self.blocks.truncate(length / BLOCK);
    }

    pub fn values(&self) -> &[f64] {
        &self.values
    }

    pub fn extremes(&self, stretch: Range<usize>) -> Option<Extremes> {
        let stretch = stretch.start..stretch.end.min(self.values.len());
        if stretch.is_empty() {
            return None;
        }
        let blocks = stretch.start.div_ceil(BLOCK)..stretch.end / BLOCK;
        if blocks.is_empty() {
            return extremes(&self.values[stretch]);
        }
        let before = extremes(&self.values[stretch.start..blocks.start * BLOCK]);
        let after = extremes(&self.values[blocks.end * BLOCK..stretch.end]);
        before.into_iter().chain(self.blocks[blocks].iter().copied()).chain(after).reduce(around)
    }
}

pub fn around(a: Extremes, b: Extremes) -> Extremes {
    (a.0.min(b.0), a.1.max(b.1))
}

fn extremes(values: &[f64]) -> Option<Extremes> {
    values.iter().map(|value| (*value, *value)).reduce(around)
}

#[cfg(test)]
pub(crate) use tests::fixture;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::game::Controls;
    use crate::instruments::quantity::VectorPart;
    use fixture::{curve, flown};
    use proptest::prelude::*;

    pub(crate) mod fixture {
        use super::*;
        use crate::game::{Controls, Game, SHIP};
        use crate::level;
        use std::sync::Arc;

        /// The ship of the fixture under those controls.
        pub fn flown(ticks: u64, controls: impl Fn(u64) -> Controls) -> BodyTrack {
            let mut game = Game::new(Arc::new(level::fixture())).expect("it loads");
            let mut track = BodyTrack::new(SHIP);
            track.begin(&game);
            for tick in 0..ticks {
                game.step(controls(tick));
                track.tick(&game);
            }
            track
        }

        pub fn curve(track: &BodyTrack, across: Quantity, up: Quantity) -> Curve {
            let mut curve = Curve::new(across, up);
            curve.follow(track);
            curve
        }
    }

    /// The ship of the fixture, which goes up for half a second and falls to the floor.
    fn hop(ticks: u64) -> BodyTrack {
        flown(ticks, |tick| Controls { thrust: tick < 60, ..Controls::default() })
    }

    #[test]
    fn slopes_and_areas_are_those_of_mechanics() {
        let track = hop(400);
        assert!(!track.impacts.is_empty(), "it comes down again");
        let landing = track.impacts[0];
        let (y, v) = (Quantity::Y, Quantity::Velocity(VectorPart::Y));
        let (height, speed) = (curve(&track, Quantity::Time, y), curve(&track, Quantity::Time, v));
        let gained = height.point(landing - 1).unwrap().1 - height.point(0).unwrap().1;
        assert!((speed.area(&track, 0, landing - 1) - gained).abs() < 1e-12, "{} {gained}", speed.area(&track, 0, landing - 1));
        for place in [30, 150, landing - 1] {
            let moment = track.moment(place);
            assert_eq!(speed.slope(&track, place), Some(moment.acceleration.y));
            let differences = (speed.point(place).unwrap().1 - speed.point(place - 1).unwrap().1) * track.rate;
            assert!((differences - moment.acceleration.y).abs() < 0.1, "{place}: {differences} {}", moment.acceleration.y);
        }
        // Work is the area under the force along the path.
        let (force, energy) = (Quantity::Resultant(VectorPart::Y), Quantity::Kinetic);
        let work = curve(&track, y, force).area(&track, 61, landing - 1);
        let kinetic = |place: usize| energy.of(&track.moment(place));
        assert!((work - (kinetic(landing - 1) - kinetic(61))).abs() < 1e-3 * work.abs(), "{work}");
    }

    /// Across the landing, where the curve jumps: the area under v is the distance; the area under F is the change of momentum
    /// without the impulses.
    #[test]
    fn areas_are_exact_across_impacts() {
        let track = hop(400);
        let end = track.len() - 1;
        let area = |up| curve(&track, Quantity::Time, up).area(&track, 0, end);
        let (first, last) = (track.moment(0), track.moment(end));
        let risen = last.position.y - first.position.y;
        assert_eq!(area(Quantity::Velocity(VectorPart::Y)), risen);
        assert_eq!(area(Quantity::Momentum(VectorPart::Y)), first.constants.mass * risen);
        let forces = area(Quantity::Resultant(VectorPart::Y));
        let impulses: f64 = track.impulses.iter().map(|impulse| impulse.y).sum();
        let change = first.constants.mass * (last.velocity.y - first.velocity.y);
        assert!(impulses > 0.0 && (forces + impulses - change).abs() <= 1e-9 * impulses, "{forces} and {impulses} for {change}");
        // Where nothing is hit and nothing switched, the trapezoids come to the same.
        let (force, landing) = (curve(&track, Quantity::Time, Quantity::Resultant(VectorPart::Y)), track.impacts[0]);
        let trapezoids = |i: usize| (force.point(i).unwrap().1 + force.point(i + 1).unwrap().1) / (2.0 * track.rate);
        let in_flight: f64 = (61..landing - 1).map(trapezoids).sum();
        let exact = force.area(&track, 61, landing - 1);
        assert!((exact - in_flight).abs() <= 1e-6 * in_flight.abs(), "{exact} {in_flight}");
        assert!((area(Quantity::Acceleration(VectorPart::Y)) * first.constants.mass - forces).abs() <= 1e-9 * impulses);
    }

    #[test]
    fn an_impact_breaks_what_jumps_and_nothing_else() {
        let track = hop(400);
        let landing = track.impacts[0];
        let ways = |up| curve(&track, Quantity::Time, up).drawn(0..track.len(), (0.0, 0.0));
        assert_eq!(ways(Quantity::Y).len(), 1);
        let speed = ways(Quantity::Velocity(VectorPart::Y));
        assert_eq!(speed.len(), 1 + track.impacts.len());
        assert_eq!((speed[0].len(), speed[1][0].0), (landing, track.time(landing)));
        // Forces have no rate: their slope is a difference, which never reaches over a break.
        let force = curve(&track, Quantity::Time, Quantity::Resultant(VectorPart::Y));
        let slope = force.slope(&track, landing - 1).unwrap();
        let one_sided = (force.point(landing - 1).unwrap().1 - force.point(landing - 2).unwrap().1) * track.rate;
        assert!((slope - one_sided).abs() <= 1e-9 * (1.0 + one_sided.abs()), "{slope} {one_sided}");
    }

    #[test]
    fn a_flight_that_was_left_is_forgotten_and_the_other_one_read() {
        let (mut track, whole) = (hop(300), hop(200));
        let quantity = Quantity::Velocity(VectorPart::Size);
        let mut kept = curve(&track, Quantity::Time, quantity);
        track.forget_after(200);
        kept.follow(&track);
        assert_eq!(kept, curve(&whole, Quantity::Time, quantity));
    }

    proptest! {
        #[test]
        fn what_is_drawn_reaches_as_far_as_the_curve(from in 0..390_usize, length in 2..400_usize, grain in 0.0..0.5_f64) {
            let track = hop(400);
            for (across, up) in [(Quantity::Time, Quantity::Resultant(VectorPart::Size)), (Quantity::Y, Quantity::Velocity(VectorPart::Y))] {
                let curve = curve(&track, across, up);
                let places = from..(from + length).min(curve.len());
                let (_, (least, largest)) = curve.extremes(places.clone()).unwrap();
                let drawn: Vec<f64> = curve.drawn(places, (grain, grain)).into_iter().flatten().map(|(_, y)| y).collect();
                let (low, high) = drawn.iter().fold((f64::MAX, f64::MIN), |(low, high), y| (low.min(*y), high.max(*y)));
                let lost = if across == Quantity::Time { 0.0 } else { grain };
                prop_assert!(low >= least && high <= largest && low - least <= lost && largest - high <= lost);
            }
        }
    }

    proptest! {
        #[test]
        fn extremes_are_those_of_the_numbers(values in proptest::collection::vec(-9.0..9.0_f64, 0..700), ends in (0..700_usize, 0..700_usize), kept in 0..700_usize) {
            let mut series = NumberSeries::default();
            values.iter().for_each(|value| series.push(*value));
            series.truncate(kept);
            values.iter().for_each(|value| series.push(*value));
            let all: Vec<f64> = values[..kept.min(values.len())].iter().chain(&values).copied().collect();
            prop_assert_eq!(series.values(), &all[..]);
            let stretch = ends.0.min(all.len())..ends.1.min(all.len());
            let found = if stretch.is_empty() { None } else { extremes(&all[stretch]) };
            prop_assert_eq!(series.extremes(ends.0..ends.1), found);
        }
    }
}
