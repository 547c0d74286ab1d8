//! Each curve's value and slope at the world's moment, and the area below it.

use super::{Plot, READINGS};
use crate::instruments::quantity::Quantity;
use crate::instruments::unit::Unit;

#[derive(Clone, Debug, PartialEq)]
pub struct CurveReading {
    /// Object and quantity: `Ball 2 v_y`.
    pub name: String,
    /// Value, slope and area, as far as they are known, each with its unit.
    pub numbers: [(Option<f64>, Unit); READINGS],
}

impl Plot {
    /// In the curves' order.
    pub fn readings(&self) -> Vec<CurveReading> {
        let (across, reading) =
            (self.across.unit(), |number: Option<f64>, unit| (number.filter(|number| number.is_finite()), unit));
        let line = |line: &super::PlotLine| {
            let track = self.objects[line.whose].track();
            let place = track.map(|track| track.place(self.now)).filter(|place| *place < line.now.len());
            let value = place.and_then(|place| line.now.point(place)).map(|(_, y)| y);
            let slope = track.zip(place).and_then(|(track, place)| line.now.slope(track, place));
            let area = track.filter(|_| line.up.has_area()).map(|track| {
                let (from, to) = self.stretch(track);
                line.now.area(track, from, to)
            });
            let unit = line.up.unit();
            CurveReading {
                name: format!("{} {}", self.name(line.whose), line.up.symbol()),
                numbers: [reading(value, unit), reading(slope, unit.per(across)), reading(area, unit.times(across))],
            }
        };
        self.lines.iter().map(line).collect()
    }

    /// The places of the area: between the two marks, or from the start to the moment on the screen.
    pub(super) fn stretch(&self, track: &crate::instruments::track::BodyTrack) -> (usize, usize) {
        match self.span {
            Some((from, to)) => (track.place(from), track.place(to)),
            None => (0, track.place(self.now)),
        }
    }

    pub const fn across(&self) -> Quantity {
        self.across
    }
}
