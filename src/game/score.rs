//! The score of an attempt.

use super::event::Outcome;

const BASE: i64 = 10_000;
/// The most for time, and the loss of a flight twice as slow as the level's author.
const TIME: f64 = 10_000.0;
const FUEL: f64 = 1_000.0;
/// The share of the fuel that brings the whole bonus.
const FULL_BONUS: f64 = 0.5;
const COLLISION: i64 = -500;
/// The least of a success.
const LEAST: i64 = 1;
/// A term that lacks less than this to the next point gets it, points: 0.9 s of 1 s would bring 999 points, because a tenth is no
/// binary number. Far below the worth of a tick, far above rounding.
const ROUNDING: f64 = 1e-9;

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ScoreParts {
    /// 10 000 for a completed level.
    pub base: i64,
    /// 10 000·k, from −10 000 to 10 000.
    pub time: i64,
    /// 1000·min(f/0.5, 1).
    pub fuel: i64,
    /// −500·c.
    pub collisions: i64,
    /// The sum: at least 1 for a success, 0 for a failure.
    pub total: i64,
}

impl ScoreParts {
    /// `time` and `optimal_time` in seconds, `fuel` the fraction left (0 … 1), `collisions` the damaging ones. Each term is rounded
    /// down to whole points: a slow player's loss of a third of a point is a point.
    pub fn completed(time: f64, optimal_time: f64, fuel: f64, collisions: u32) -> Self {
        let k = ((optimal_time - time) / optimal_time).clamp(-1.0, 1.0);
        let mut parts = Self {
            base: BASE,
            time: whole(TIME * k),
            fuel: whole(FUEL * (fuel / FULL_BONUS).min(1.0)),
            collisions: COLLISION * i64::from(collisions),
            total: 0,
        };
        parts.total = (parts.base + parts.time + parts.fuel + parts.collisions).max(LEAST);
        parts
    }

    /// The most that a level brings in that time, s: without a hit, with a full tank.
    pub fn most(time: f64, optimal_time: f64) -> i64 {
        Self::completed(time, optimal_time, 1.0, 0).total
    }
}

fn whole(points: f64) -> i64 {
    (points + ROUNDING).floor() as i64
}

#[derive(Clone, Debug, PartialEq)]
pub struct RunResult {
    /// The level's folder name.
    pub level: String,
    pub outcome: Outcome,
    /// s.
    pub time: f64,
    /// s.
    pub optimal_time: f64,
    pub objectives_met: usize,
    pub objectives_all: usize,
    /// Damaging ones.
    pub collisions: u32,
    /// Touches of one object less than half a second apart are one.
    pub pushes: u32,
    /// Fraction of the fuel left, 0 … 1; 0 where the level gives none.
    pub fuel: f64,
    /// Fuel units used.
    pub fuel_used: f64,
    /// Length of the ship's path, m.
    pub distance: f64,
    /// The ship's, m/s.
    pub top_speed: f64,
    /// On the ship, N.
    pub peak_resultant: f64,
    /// A run with help is not for the board.
    pub assisted: bool,
    pub death: Option<&'static str>,
    /// All 0 unless the level was completed.
    pub score: ScoreParts,
}

#[cfg(test)]
mod tests {
    use super::*;

    fn total(time: f64, optimal_time: f64, fuel: f64, collisions: u32) -> i64 {
        ScoreParts::completed(time, optimal_time, fuel, collisions).total
    }

    #[test]
    fn the_examples_of_the_rules() {
        assert_eq!(total(37.0, 30.0, 0.0, 3), 6166);
        assert_eq!(total(11.0, 10.0, 0.0, 0), 9000);
    }

    #[test]
    fn every_term() {
        let parts = ScoreParts::completed(15.0, 60.0, 0.3, 2);
        assert_eq!(parts, ScoreParts { base: 10_000, time: 7_500, fuel: 600, collisions: -1_000, total: 17_100 });
    }

    #[test]
    fn each_term_is_truncated_by_itself() {
        // 10 000/3 and 1000·2/3, whose sum is a whole number.
        let parts = ScoreParts::completed(20.0, 30.0, 1.0 / 3.0, 0);
        assert_eq!((parts.time, parts.fuel, parts.total), (3_333, 666, 13_999));
    }

    #[test]
    fn whole_points_do_not_fall_victim_to_binary_fractions() {
        for tick in 0..=120 {
            let time = ScoreParts::completed(f64::from(tick) / 120.0, 1.0, 0.0, 0).time;
            assert_eq!(time, i64::from((120 - tick) * 10_000 / 120), "tick {tick}");
        }
        for thousandth in 0..=500 {
            let fuel = ScoreParts::completed(1.0, 1.0, f64::from(thousandth) / 1000.0, 0).fuel;
            assert_eq!(fuel, i64::from(2 * thousandth), "{thousandth} thousandths of the fuel");
        }
    }

    #[test]
    fn time_counts_at_most_twice_and_fuel_at_most_half() {
        assert_eq!(ScoreParts::completed(20.0, 10.0, 0.0, 0).time, -10_000);
        assert_eq!(ScoreParts::completed(1e9, 10.0, 0.0, 0).time, -10_000);
        assert_eq!(ScoreParts::completed(0.0, 10.0, 0.0, 0).time, 10_000);
        assert_eq!([0.5, 0.75, 1.0].map(|fuel| ScoreParts::completed(10.0, 10.0, fuel, 0).fuel), [1_000; 3]);
    }

    #[test]
    fn no_flight_is_worth_more_than_the_rules_allow() {
        assert_eq!([0.0, 10.0, 20.0, 1e9].map(|time| ScoreParts::most(time, 10.0)), [21_000, 11_000, 1_000, 1_000]);
    }

    #[test]
    fn a_success_is_worth_a_point_at_least() {
        assert_eq!(total(20.0, 10.0, 0.0, 0), 1);
        assert_eq!(total(10.0, 10.0, 0.0, 20), 1);
        assert_eq!(total(10.0, 10.0, 0.0, u32::MAX), 1);
        assert_eq!(total(20.0, 10.0, 0.001, 0), 2);
    }
}
