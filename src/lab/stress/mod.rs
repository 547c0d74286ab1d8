//! Stress tests: the largest value that each method survives, the shipped engine among them. Functions of their own let tests try single values.

pub mod motion;
pub mod picture;
pub mod robustness;
pub mod standing;

use crate::lab::curve::{of_amounts, of_flags, of_words};
use crate::{files::CsvColumn, files::CsvStruct, number::short};
use picture::FailurePicture;
use serde::Deserialize;

use super::contract::Entrant;
use std::collections::HashMap;

/// N/kg.
pub const G: f64 = 9.81;

#[derive(Clone, Debug, Deserialize, PartialEq)]
pub struct Survival {
    pub test: String,
    /// With its unit.
    pub parameter: String,
    pub method: String,
    /// The largest value that it survives; 0: none.
    pub largest: f64,
    pub tried: f64,
    pub shipped: bool,
}

impl CsvStruct for Survival {
    const COLUMNS: &'static [CsvColumn] = &[
        of_words("test"),
        of_words("parameter"),
        of_words("method"),
        of_amounts("largest"),
        of_amounts("tried"),
        of_flags("shipped"),
    ];
}

impl Survival {
    /// For people: ≥ where nothing larger was tried.
    pub fn shown(&self) -> String {
        format!("{}{}", if self.largest >= self.tried { "≥ " } else { "" }, short(self.largest))
    }
}

/// Methods, and the number that grows until they fail.
pub struct StressTest {
    pub name: &'static str,
    /// With its unit.
    pub parameter: &'static str,
    range: (f64, f64),
    whole: bool,
    methods: Vec<Trial>,
}

type Trial = Entrant<bool, FailurePicture>;

impl StressTest {
    fn of(name: &'static str, parameter: &'static str, range: (f64, f64), methods: Vec<Trial>) -> Self {
        Self { name, parameter, range, whole: false, methods }
    }

    pub fn rows(&self) -> Vec<Survival> {
        let row = |method: &Trial| {
            let found = largest(self.range, &method.run);
            Survival {
                test: self.name.to_owned(),
                parameter: self.parameter.to_owned(),
                method: method.name.clone(),
                largest: if self.whole { found.floor() } else { found },
                tried: self.range.1,
                shipped: method.shipped,
            }
        };
        self.methods.iter().map(row).collect()
    }

    /// A picture of a method's failure just beyond the largest value that it survives, or of its success at the largest tried.
    pub fn picture(&self, method: &str, largest: f64) -> Option<FailurePicture> {
        let method = self.methods.iter().find(|found| found.name == method)?;
        let value = self.beyond(largest, &method.run);
        let picture = method.shown.as_ref()?(value);
        Some(FailurePicture { value, ..picture })
    }

    /// A value beyond that one at which the method does fail; the largest tried where it survives all.
    fn beyond(&self, largest: f64, survives: impl Fn(f64) -> bool) -> f64 {
        let (least, most) = self.range;
        // The number comes from a file and may be anything.
        let next = |further: f64| {
            let next = if self.whole { largest + further.ceil() } else { largest * (1.0 + further) };
            if next.is_nan() { least } else { next.clamp(least, most) }
        };
        let nearest = next(BEYOND[0]);
        if nearest >= most { nearest } else { BEYOND.map(next).into_iter().find(|value| !survives(*value)).unwrap_or(nearest) }
    }
}

/// Relative: how far beyond a failure is shown. Nearer than the first it would not be seen; some methods survive again a little further on.
const BEYOND: [f64; 5] = [0.25, 0.1, 0.03, 0.01, 0.003];

/// The largest value of the range up to which `survives` holds, doubled until it does not, then halved in between; 0: not for the least.
pub fn largest(range: (f64, f64), survives: impl Fn(f64) -> bool) -> f64 {
    largest_to(RESOLUTION, range, survives)
}

/// The same, to within `part` of itself.
pub fn largest_to(resolution: f64, (least, most): (f64, f64), survives: impl Fn(f64) -> bool) -> f64 {
    if !survives(least) {
        return 0.0;
    }
    let mut good = least;
    let mut bad = loop {
        let next = (2.0 * good).min(most);
        if !survives(next) {
            break next;
        }
        if next == most {
            return most;
        }
        good = next;
    };
    while bad > good * (1.0 + resolution) {
        let middle = 0.5 * (good + bad);
        if survives(middle) { good = middle } else { bad = middle }
    }
    good
}

/// Relative precision of [`largest`].
const RESOLUTION: f64 = 1e-3;

type Tried = fn() -> StressTest;

/// In the order of the report, each with what it tries, for a reader of eleven.
const TRIED: [(Tried, &str); 19] = [
    (motion::terminal_velocity, "A body falls through air: does it end at the right speed?"),
    (motion::swings, "A floating box bobs up and down: are its swings as high after 100 of them?"),
    (motion::spring_swings, "A body swings on a spring: does it have as much energy after 100 swings?"),
    (motion::pendulum, "A pendulum swings: does it have as much energy after 100 swings?"),
    (motion::gust_reversal, "Wind blows at a light body at rest: does the body ever overtake the wind?"),
    (motion::gust_blow_up, "The same wind: does the body's speed against the air ever grow?"),
    (standing::tunnelling, "A fast box flies at a thin wall: does the wall stop it?"),
    (standing::tunnelling_of_bodies, "A fast box flies at a thin, loose plate: does it hit the plate?"),
    (standing::heavy_on_light, "A heavy block lies on a light one: are the forces between them right?"),
    (standing::columns, "Many blocks stand on each other: is each force between them right?"),
    (robustness::resting_jitter, "A box lies on the floor: does it lie still?"),
    (robustness::coulomb_stop, "A box slides until friction stops it: does it stop, and at the right place?"),
    (robustness::zeno, "A ball bounces lower and lower: does it come to rest at the right time?"),
    (robustness::minute_of_bounces, "A ball bounces for a minute without loss: does it still rise as high?"),
    (standing::simultaneous_impacts, "A block hits a row of equal blocks: does the last one alone fly off?"),
    (standing::simultaneous_impacts_in_a_crowd, "The same row of blocks, with 200 other bodies in the world."),
    (robustness::far_from_the_origin, "A body moves far away from the middle of the world: is its place still exact?"),
    (robustness::hitch, "One picture takes far too long: does a body fall through the floor, or the game hang?"),
    (robustness::nonsense, "Impossible numbers are given, such as a negative mass: are they refused?"),
];

/// In the order of the report.
pub const TESTS: [fn() -> StressTest; TRIED.len()] = {
    let (mut tests, mut i) = ([TRIED[0].0; TRIED.len()], 0);
    while i < tests.len() {
        tests[i] = TRIED[i].0;
        i += 1;
    }
    tests
};

/// What each test tries, in a sentence, by the test's name.
pub fn tried() -> HashMap<&'static str, &'static str> {
    TRIED.iter().map(|(test, words)| (test().name, *words)).collect()
}

/// `None` where the row's test or its method is not known here.
pub fn picture(row: &Survival) -> Option<FailurePicture> {
    TESTS.iter().map(|test| test()).find(|test| test.name == row.test)?.picture(&row.method, row.largest)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_largest_value_is_found() {
        assert_eq!(largest((1.0, 100.0), |_| true), 100.0);
        assert_eq!(largest((1.0, 100.0), |_| false), 0.0);
        let found = largest((0.1, 100.0), |value| value < 37.0);
        assert!((found / 37.0 - 1.0).abs() < 2.0 * RESOLUTION, "{found}");
    }

    #[test]
    fn a_failure_is_shown_just_beyond_what_is_survived() {
        let trial = |survives: fn(f64) -> bool| {
            Trial::new("m", survives).showing(|value| FailurePicture { value, ..FailurePicture::default() })
        };
        let test = StressTest::of("a", "b", (1.0, 100.0), vec![trial(|value| value < 9.0)]);
        let at = |largest: f64| test.picture("m", largest).map(|picture| picture.value);
        assert_eq!([0.0, 8.0, 90.0, 100.0, f64::NAN].map(at), [Some(1.0), Some(10.0), Some(100.0), Some(100.0), Some(1.0)]);
        assert_eq!(test.picture("another", 1.0), None);
        let whole = StressTest { whole: true, ..StressTest::of("a", "b", (2.0, 20.0), vec![trial(|_| true)]) };
        assert_eq!(whole.picture("m", 7.0).map(|picture| picture.value), Some(8.0));
    }
}
