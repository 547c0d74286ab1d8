//! The score of an attempt; the prizes of a completed flight, and what marks for tricks ask for: burns, stars, and objectives met together.

use super::event::{GameEvent, Outcome};
use super::impacts::{SHIP_BOX, has_passed};
use super::ship::{SHIP, object_body};
use crate::level::{Awards, Level, Mark, Star, StarTouch};
use crate::number::{hundredths, whole_hundredths};
use crate::physics::{BodyId, DVec2, World};
use crate::words::tr;

const BASE: i64 = 10_000;
/// The most for time, and the loss of a flight twice as slow as the level's author.
const TIME: f64 = 10_000.0;
const FUEL: f64 = 1_000.0;
/// The share of the fuel that brings the whole bonus.
const FULL_BONUS: f64 = 0.5;
const COLLISION: i64 = -500;
const LEAST: i64 = 1;
/// A term that lacks less than this to the next point gets it, points: 0.9 s of 1 s would bring 999 points, because a tenth is no
/// binary number. Far below the worth of a tick, far above rounding. So are a speed, m/s, over its limit, a share of the fuel below it,
/// and a pause between burns that is this much shorter, ticks: few tick rates have whole ticks in [`APART`].
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
    pub burns: u32,
    pub stars_left: usize,
    /// The shortest time within which as many objectives were met as the level's mark asks for, s; 0 where it asks for none.
    pub together: f64,
    /// Fraction of the fuel left, 0 … 1; 0 where the level gives none.
    pub fuel: f64,
    /// Fuel units.
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

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Medal {
    Bronze,
    Silver,
    Gold,
}

impl Medal {
    pub const ALL: [Self; 3] = [Self::Bronze, Self::Silver, Self::Gold];

    pub const fn name(self) -> &'static str {
        match self {
            Self::Bronze => "Bronze",
            Self::Silver => "Silver",
            Self::Gold => "Gold",
        }
    }

    /// The medal for a completed flight of that time, s; bronze without a time, as for a flight with help.
    fn for_time(awards: &Awards, time: Option<f64>) -> Self {
        let within = |limit: Option<f64>| limit.zip(time).is_some_and(|(limit, time)| hundredths(time) <= whole_hundredths(limit));
        match (within(awards.gold), within(awards.silver)) {
            (true, _) => Self::Gold,
            (false, true) => Self::Silver,
            (false, false) => Self::Bronze,
        }
    }
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Medals {
    pub medal: Option<Medal>,
    pub mark: bool,
}

impl Medals {
    pub const fn has_clock(awards: &Awards) -> bool {
        awards.gold.is_some() || awards.silver.is_some()
    }

    /// The best medal that a flight of that time so far can still earn, and its time left, s; bronze has all the time.
    pub fn within_reach(awards: &Awards, time: f64) -> (Medal, Option<f64>) {
        let best = Medal::for_time(awards, Some(time));
        let limit = match best {
            Medal::Gold => awards.gold,
            Medal::Silver => awards.silver,
            Medal::Bronze => None,
        };
        (best, limit.map(|limit| (limit - time).max(0.0)))
    }

    /// A flight with help earns bronze alone.
    pub fn of(awards: &Awards, result: &RunResult) -> Self {
        if result.outcome != Outcome::Completed {
            return Self::default();
        }
        let medal = Medal::for_time(awards, (!result.assisted).then_some(result.time));
        Self { medal: Some(medal), mark: !result.assisted && awards.mark.is_some_and(|mark| lacks(mark, result).is_none()) }
    }

    /// Adds the medal for the best time, by the limits of the level as it stands now: the flight may be older than they are.
    #[must_use]
    pub fn with_best(self, awards: &Awards, time: Option<f64>) -> Self {
        Self { medal: self.medal.map(|medal| medal.max(Medal::for_time(awards, time))), ..self }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Prize {
    Medal(Medal),
    Mark,
}

/// A prize, its condition, and the part that a flight lacks for it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Goal {
    pub prize: Prize,
    pub asks: String,
    /// `None` where the prize is earned.
    pub missing: Option<String>,
}

pub fn goals(awards: &Awards, result: &RunResult) -> Vec<Goal> {
    let completed = result.outcome == Outcome::Completed;
    let unless = |lacks: Option<String>| match (completed, result.assisted) {
        (false, _) => Some(tr("not completed").to_owned()),
        (true, true) => Some(tr("not with help").to_owned()),
        (true, false) => lacks,
    };
    let bronze = (!completed).then(|| tr("not completed").to_owned());
    let timed = |medal, limit: f64| {
        let late = hundredths(result.time).saturating_sub(whole_hundredths(limit));
        let lacks = (late > 0).then(|| tr!("{time} s too slow", time = format_args!("{}.{:02}", late / 100, late % 100)));
        Goal { prize: Prize::Medal(medal), asks: tr!("within {limit} s", limit), missing: unless(lacks) }
    };
    let mark = |mark| Goal { prize: Prize::Mark, asks: words(mark), missing: unless(lacks(mark, result)) };
    [Goal { prize: Prize::Medal(Medal::Bronze), asks: tr("level complete").to_owned(), missing: bronze }]
        .into_iter()
        .chain(awards.silver.map(|limit| timed(Medal::Silver, limit)))
        .chain(awards.gold.map(|limit| timed(Medal::Gold, limit)))
        .chain(awards.mark.map(mark))
        .collect()
}

pub fn words(mark: Mark) -> String {
    match mark {
        Mark::Hits(0) => tr("no damaging hit").to_owned(),
        Mark::Hits(most) => tr!("at most {most}", most = counted_hits(most)),
        Mark::Fuel(least) => tr!("{least} % fuel left", least),
        Mark::Pushes(0) => tr("no object pushed").to_owned(),
        Mark::Pushes(most) => tr!("at most {most}", most = count_pushes(most)),
        Mark::Speed(most) => tr!("never above {most} m/s", most),
        Mark::Burns(0) => tr("without the engine").to_owned(),
        Mark::Burns(most) => tr!("at most {most}", most = counted_burns(most)),
        Mark::Together(count, within) => tr!("{count} goals within {within} s", count, within),
        Mark::Stars => tr("every star touched").to_owned(),
    }
}

fn lacks(mark: Mark, result: &RunResult) -> Option<String> {
    match mark {
        Mark::Hits(most) => (result.collisions > most).then(|| counted_hits(result.collisions)),
        Mark::Fuel(least) => {
            let left = result.fuel * 100.0;
            (left < least - ROUNDING)
                .then(|| tr!("{percent} % left", percent = format_args!("{:.1}", (left * 10.0).floor() / 10.0)))
        }
        Mark::Pushes(most) => (result.pushes > most).then(|| count_pushes(result.pushes)),
        Mark::Speed(most) => {
            (result.top_speed > most + ROUNDING).then(|| format!("{:.1} m/s", (result.top_speed * 10.0).ceil() / 10.0))
        }
        Mark::Burns(most) => (result.burns > most).then(|| counted_burns(result.burns)),
        Mark::Together(_, within) => {
            (result.together > within + ROUNDING).then(|| format!("{:.1} s", (result.together * 10.0).ceil() / 10.0))
        }
        Mark::Stars if result.stars_left == 1 => Some(tr("1 star left").to_owned()),
        Mark::Stars => (result.stars_left > 0).then(|| tr!("{count} stars left", count = result.stars_left)),
    }
}

fn counted_hits(n: u32) -> String {
    if n == 1 { tr("1 damaging hit").to_owned() } else { tr!("{count} damaging hits", count = n) }
}

fn count_pushes(n: u32) -> String {
    if n == 1 { tr("1 push").to_owned() } else { tr!("{count} pushes", count = n) }
}

fn counted_burns(n: u32) -> String {
    if n == 1 { tr("1 burn").to_owned() } else { tr!("{count} burns", count = n) }
}

/// The engine is off for at least this time between two burns, s: shorter, and a key let go by mistake costs a burn; longer, and quick
/// taps pass for one.
const APART: f64 = 0.1;

#[derive(Clone, Debug)]
pub struct Tricks {
    pub burns: u32,
    /// The tick after the last burning one; 0 before the first.
    burnt: u64,
    pub touched: Vec<bool>,
    /// By objective, the tick in which it was met last.
    met: Vec<u64>,
}

impl Tricks {
    pub fn new(level: &Level) -> Self {
        Self { burns: 0, burnt: 0, touched: vec![false; level.stars.len()], met: vec![0; level.objectives.len()] }
    }

    /// The shortest time within which `count` objectives were met, s.
    pub fn together(&self, count: u32, tick_rate: f64) -> f64 {
        let mut met = self.met.clone();
        met.sort_unstable();
        let span = met.windows(count.max(1) as usize).map(|met| met[met.len() - 1] - met[0]).min();
        span.map_or(f64::INFINITY, |ticks| ticks as f64 / tick_rate)
    }

    /// Looks at the end of a tick, of that number, whose other events are there.
    pub fn note(&mut self, level: &Level, world: &World, (tick, rate): (u64, f64), burning: bool, events: &mut Vec<GameEvent>) {
        if burning {
            let off = (tick - self.burnt) as f64;
            self.burns += u32::from(self.burnt == 0 || off >= APART * rate - ROUNDING);
            self.burnt = tick + 1;
        }
        for event in events.iter() {
            if let GameEvent::ObjectiveMet(index) = *event {
                self.met[index] = tick;
            }
        }
        for (index, star) in level.stars.iter().enumerate() {
            if !self.touched[index] && is_touched(star, level, world) {
                self.touched[index] = true;
                events.push(GameEvent::StarTouched(index));
            }
        }
    }
}

/// Whether one of the bodies that count touched a star at any moment of the last tick.
fn is_touched(star: &Star, level: &Level, world: &World) -> bool {
    let passes = |body: BodyId, corners: &[DVec2]| has_passed(world, body, corners, &star.bounds);
    if star.by == StarTouch::Ship {
        return passes(SHIP, &SHIP_BOX);
    }
    level.objects.iter().enumerate().filter(|(_, object)| star.by == StarTouch::Object || object.key.is_some()).any(
        |(index, object)| {
            let half = object.size * 0.5;
            passes(object_body(index), &SHIP_BOX.map(|corner| corner.signum() * half))
        },
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::game::ScoreParts;
    use crate::number::clock;

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

    const AWARDS: Awards = Awards { silver: Some(9.0), gold: Some(7.5), mark: Some(Mark::Fuel(60.0)) };

    fn flight(time: f64, fuel: f64) -> RunResult {
        RunResult {
            level: String::new(),
            outcome: Outcome::Completed,
            time,
            optimal_time: 60.0,
            objectives_met: 1,
            objectives_all: 1,
            collisions: 2,
            pushes: 1,
            burns: 4,
            stars_left: 2,
            together: 8.37,
            fuel,
            fuel_used: 0.0,
            distance: 0.0,
            top_speed: 12.34,
            peak_resultant: 0.0,
            assisted: false,
            death: None,
            score: ScoreParts::default(),
        }
    }

    #[test]
    fn what_a_flight_earns() {
        let of = |result: RunResult| Medals::of(&AWARDS, &result);
        let medals = |medal, mark| Medals { medal: Some(medal), mark };
        assert_eq!(of(flight(7.5, 0.6)), medals(Medal::Gold, true));
        assert_eq!(of(flight(7.6, 0.599)), medals(Medal::Silver, false));
        assert_eq!(of(flight(9.1, 1.0)), medals(Medal::Bronze, true));
        assert_eq!(of(RunResult { assisted: true, ..flight(1.0, 1.0) }), medals(Medal::Bronze, false));
        assert_eq!(of(RunResult { outcome: Outcome::Failed, ..flight(1.0, 1.0) }), Medals::default());
        assert_eq!(Medals::of(&Awards::default(), &flight(1.0, 1.0)), medals(Medal::Bronze, false), "bronze alone");
    }

    #[test]
    fn a_shown_time_and_what_it_lacks_add_up_to_the_limit() {
        // 661 ticks are 5.5083 s, which the screen shows as 00:05.51.
        let awards = Awards { gold: Some(5.5), ..Awards::default() };
        let missing = |ticks: f64| goals(&awards, &flight(ticks / 120.0, 1.0)).remove(1).missing;
        assert_eq!(missing(660.0), None);
        assert_eq!((missing(661.0).as_deref(), clock(661.0 / 120.0)), (Some("0.01 s too slow"), "00:05.51".to_owned()));
        assert_eq!((missing(814.0).as_deref(), clock(814.0 / 120.0)), (Some("1.29 s too slow"), "00:06.79".to_owned()));
        assert_eq!(Medal::for_time(&awards, Some(661.0 / 120.0)), Medal::Bronze);
        // A time shown as 00:05.51 is not within 5.505 s.
        let odd = Awards { gold: Some(5.505), ..Awards::default() };
        assert_eq!([5.5, 5.503].map(|time| Medal::for_time(&odd, Some(time))), [Medal::Gold, Medal::Bronze]);
    }

    #[test]
    fn the_medal_clock_runs_from_gold_to_silver_to_bronze() {
        let at = |time: f64| Medals::within_reach(&AWARDS, time);
        assert_eq!(
            [at(0.0), at(7.5), at(8.0), at(10.0)].map(|(medal, _)| medal),
            [Medal::Gold, Medal::Gold, Medal::Silver, Medal::Bronze]
        );
        assert_eq!([at(0.5).1, at(7.5).1, at(8.0).1, at(10.0).1], [Some(7.0), Some(0.0), Some(1.0), None]);
    }

    #[test]
    fn an_old_best_time_is_worth_what_it_would_be_now() {
        let bronze = Medals { medal: Some(Medal::Bronze), mark: false };
        assert_eq!(bronze.with_best(&AWARDS, Some(8.0)).medal, Some(Medal::Silver));
        assert_eq!(bronze.with_best(&AWARDS, None), bronze);
        assert_eq!(Medals::default().with_best(&AWARDS, None), Medals::default());
    }

    #[test]
    fn each_line_says_what_is_asked_for_and_what_is_missing() {
        let lines = |awards: &Awards, result: &RunResult| {
            goals(awards, result).into_iter().map(|goal| (goal.asks, goal.missing.unwrap_or_default())).collect::<Vec<_>>()
        };
        let line = |asks: &str, missing: &str| (asks.to_owned(), missing.to_owned());
        assert_eq!(
            lines(&AWARDS, &flight(8.0, 0.4567)),
            [
                line("level complete", ""),
                line("within 9 s", ""),
                line("within 7.5 s", "0.50 s too slow"),
                line("60 % fuel left", "45.6 % left")
            ]
        );
        for (mark, asks, missing) in [
            (Mark::Hits(0), "no damaging hit", "2 damaging hits"),
            (Mark::Hits(1), "at most 1 damaging hit", "2 damaging hits"),
            (Mark::Hits(2), "at most 2 damaging hits", ""),
            (Mark::Pushes(0), "no object pushed", "1 push"),
            (Mark::Pushes(2), "at most 2 pushes", ""),
            (Mark::Speed(12.0), "never above 12 m/s", "12.4 m/s"),
            (Mark::Burns(3), "at most 3 burns", "4 burns"),
            (Mark::Burns(4), "at most 4 burns", ""),
            (Mark::Together(3, 8.0), "3 goals within 8 s", "8.4 s"),
            (Mark::Together(3, 8.5), "3 goals within 8.5 s", ""),
            (Mark::Stars, "every star touched", "2 stars left"),
        ] {
            let awards = Awards { mark: Some(mark), ..Awards::default() };
            assert_eq!(lines(&awards, &flight(8.0, 1.0))[1..], [line(asks, missing)]);
            assert_eq!(Medals::of(&awards, &flight(8.0, 1.0)).mark, missing.is_empty());
        }
        let lost = RunResult { outcome: Outcome::Failed, ..flight(8.0, 1.0) };
        assert!(goals(&AWARDS, &lost).iter().all(|goal| goal.missing.as_deref() == Some("not completed")));
    }
}
