//! The quantities to plot: a row a family, x, y and size beside each other; motion on the left, forces on the right. One of the two plotted objects:
//! its track in this flight, and in the flight before. Each curve's value and slope at the world's moment, and the area below it.

use super::{Plot, READINGS};
use crate::instruments::quantity::{Quantity, Unit, VectorPart};
use crate::{game::History, instruments::track::BodyTrack, physics::BodyId, physics::ForceKind};

/// A family's name and its quantities.
pub type ChoiceRow = (&'static str, Vec<Quantity>);
pub const MOST_OF_A_ROW: usize = 3;
pub const NAME: usize = 14;

/// In two blocks; of the forces only those that have acted.
pub fn choices(time: bool, acted: impl Fn(ForceKind) -> bool) -> [Vec<ChoiceRow>; 2] {
    let parts = |of: &dyn Fn(VectorPart) -> Quantity| VectorPart::ALL.map(of).to_vec();
    let row = |quantities: Vec<Quantity>| (quantities[0].family(), quantities);
    let mut motion = Vec::new();
    if time {
        motion.push(row(vec![Quantity::Time]));
    }
    motion.extend([
        row(vec![Quantity::X, Quantity::Y]),
        row(parts(&Quantity::Velocity)),
        row(parts(&Quantity::Acceleration)),
        row(parts(&Quantity::Momentum)),
        row(vec![Quantity::Kinetic, Quantity::Potential, Quantity::Mechanical]),
    ]);
    let kinds = ForceKind::ALL.into_iter().filter(|kind| acted(*kind));
    let forces = kinds.map(|kind| row(parts(&|part| Quantity::Force(kind, part))));
    [motion, std::iter::once(row(parts(&Quantity::Resultant))).chain(forces).collect()]
}

/// The words of a button: forces by their part alone, since their row has the name.
pub fn label(quantity: Quantity) -> String {
    match quantity {
        Quantity::Force(_, VectorPart::X) => "F_x".to_owned(),
        Quantity::Force(_, VectorPart::Y) => "F_y".to_owned(),
        Quantity::Force(_, VectorPart::Size) => "|F|".to_owned(),
        other => other.symbol(),
    }
}

#[derive(Clone, Debug, Default)]
pub(super) struct PlotObject {
    /// The body that stays, whichever body is followed.
    pub kept: Option<BodyId>,
    now: Option<BodyTrack>,
    before: Option<BodyTrack>,
}

/// Reads on, at most `most` ticks; another body's track from its start.
fn read(read: &mut Option<BodyTrack>, body: Option<BodyId>, history: Option<&History>, most: u64) {
    let wanted = body.zip(history);
    if read.as_ref().map(|track| track.body) != wanted.map(|(body, _)| body) {
        // A flight of another level may lack the body.
        let there = |(body, history): &(BodyId, &History)| body.index() < history.at(0).world().bodies().len();
        *read = wanted.filter(there).map(|(body, _)| BodyTrack::new(body));
    }
    if let (Some(track), Some(history)) = (read, history) {
        if !track.is_empty() && track.tick_of(track.len() - 1) > history.ticks() {
            track.back_to(history, history.ticks());
        }
        track.read(history, most);
    }
}

impl PlotObject {
    /// Reads the flight first, and with the remaining ticks the one before.
    pub fn read(&mut self, body: Option<BodyId>, history: &History, before: Option<&History>, most: u64) {
        read(&mut self.now, body, Some(history), most);
        read(&mut self.before, body, before, most);
    }

    /// As far as it is read.
    pub fn track(&self) -> Option<&BodyTrack> {
        self.now.as_ref().filter(|track| !track.is_empty())
    }

    pub fn before(&self) -> Option<&BodyTrack> {
        self.before.as_ref().filter(|track| !track.is_empty())
    }

    /// The flight was left at that tick; the run before may also differ beyond its own end.
    pub fn back_to(&mut self, history: &History, tick: u64) {
        if let Some(track) = &mut self.now {
            track.back_to(history, tick);
        }
        self.before = None;
    }

    pub fn forget(&mut self) {
        (self.now, self.before) = (None, None);
    }
}

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
    pub(super) fn stretch(&self, track: &BodyTrack) -> (usize, usize) {
        match self.span {
            Some((from, to)) => (track.place(from), track.place(to)),
            None => (0, track.place(self.now)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn everything_can_be_chosen_once_and_has_room() {
        let all = choices(true, |_| true);
        let quantities: Vec<Quantity> = all.iter().flatten().flat_map(|(_, row)| row.clone()).collect();
        for (i, quantity) in quantities.iter().enumerate() {
            assert!(!quantities[..i].contains(quantity), "{quantity:?}");
        }
        assert_eq!(quantities.len(), 1 + 2 + 3 * 3 + 3 + 3 + 3 * ForceKind::ALL.len());
        assert!(all.iter().flatten().all(|(name, row)| name.len() <= NAME && row.len() <= MOST_OF_A_ROW));
        assert_eq!(choices(false, |kind| kind == ForceKind::Weight)[1].len(), 2);
        assert!(!choices(false, |_| true).iter().flatten().any(|(_, row)| row.contains(&Quantity::Time)));
    }
}
