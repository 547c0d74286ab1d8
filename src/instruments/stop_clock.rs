//! A stop clock in the game's time: it stops, slows down and goes back with the game.

use crate::number::fixed;

/// A further lap replaces the oldest.
pub const MOST_LAPS: usize = 4;

/// Every moment is a tick of the flight.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct StopClock {
    /// Ticks up to its last stop.
    counted: i64,
    since: Option<u64>,
    /// Laps before the kept ones.
    forgotten: usize,
    /// For each lap its end and the reading then, ticks.
    laps: Vec<(u64, i64)>,
}

impl StopClock {
    pub fn start_or_stop(&mut self, now: u64) {
        self.counted = self.ticks(now);
        self.since = if self.since.is_none() { Some(now) } else { None };
    }

    pub const fn runs(&self) -> bool {
        self.since.is_some()
    }

    pub fn lap(&mut self, now: u64) {
        self.laps.push((now, self.ticks(now)));
        if self.laps.len() > MOST_LAPS {
            self.laps.remove(0);
            self.forgotten += 1;
        }
    }

    /// A clock that runs goes on from 0.
    pub fn reset(&mut self, now: u64) {
        *self = Self { since: self.since.map(|_| now), ..Self::default() };
    }

    /// The reading, ticks: below 0 before its start.
    pub fn ticks(&self, now: u64) -> i64 {
        self.counted + self.since.map_or(0, |since| now.cast_signed() - since.cast_signed())
    }

    /// For each kept lap its number, from 1 on, and the reading, ticks.
    pub fn laps(&self) -> impl Iterator<Item = (usize, i64)> {
        (self.forgotten + 1..).zip(self.laps.iter().map(|(_, read)| *read))
    }

    /// The flight was left at that tick: later laps are void.
    pub fn back_to(&mut self, tick: u64) {
        self.laps.retain(|(at, _)| *at <= tick);
    }
}

/// Ticks in seconds, to the millisecond: "1.350".
pub fn seconds(ticks: i64, rate: f64) -> String {
    fixed(ticks as f64 / rate, 3)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_counts_the_ticks_between_its_buttons_and_goes_back_with_them() {
        let mut clock = StopClock::default();
        assert_eq!(clock.ticks(500), 0);
        clock.start_or_stop(120);
        assert_eq!((clock.ticks(120), clock.ticks(162), clock.ticks(119)), (0, 42, -1));
        clock.start_or_stop(180);
        assert_eq!((clock.ticks(180), clock.ticks(9000), clock.runs()), (60, 60, false));
        clock.start_or_stop(1000);
        assert_eq!(clock.ticks(1006), 66, "it goes on from where it stood");
        clock.reset(1010);
        assert_eq!((clock.ticks(1010), clock.ticks(1020), clock.runs()), (0, 10, true));
        assert_eq!(seconds(42, 120.0), "0.350");
        assert_eq!(seconds(-1, 120.0), "−0.008");
        assert_eq!(seconds(0, 120.0), "0.000");
    }

    #[test]
    fn laps_are_kept_in_their_order_and_only_while_they_have_been() {
        let mut clock = StopClock::default();
        clock.start_or_stop(0);
        (1..=6).for_each(|lap| clock.lap(lap * 10));
        assert_eq!(clock.laps().collect::<Vec<_>>(), [(3, 30), (4, 40), (5, 50), (6, 60)]);
        clock.back_to(45);
        assert_eq!(clock.laps().collect::<Vec<_>>(), [(3, 30), (4, 40)]);
    }
}
