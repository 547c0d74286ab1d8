//! Stress tests: for each way in which methods fail, the largest value that each method survives, the shipped engine among them.
//! What "survives" means is a function of its own for each test, so that tests can ask it for single values.

pub mod bouncing;
pub mod contacts;
pub mod motion;
pub mod robustness;

use super::axes::number;

/// s. The tick of the figures that physics engines are usually compared at.
pub const TICK: f64 = 1.0 / 60.0;
/// N/kg.
pub const G: f64 = 9.81;

/// What a method survives.
#[derive(Clone, Debug, PartialEq)]
pub struct Survival {
    /// The test.
    pub test: String,
    /// What is made larger, with its unit.
    pub parameter: String,
    /// The method.
    pub method: String,
    /// The largest value that it survives; 0: none of those tried.
    pub largest: f64,
    /// The largest value that was tried.
    pub tried: f64,
    /// Whether it is the shipped engine.
    pub shipped: bool,
}

impl Survival {
    /// The largest value as people read it: ≥ where nothing larger was tried.
    pub fn shown(&self) -> String {
        format!("{}{}", if self.largest >= self.tried { "≥ " } else { "" }, number(self.largest))
    }
}

/// A test's rows.
#[derive(Debug)]
pub struct Rows {
    test: &'static str,
    parameter: &'static str,
    rows: Vec<Survival>,
}

impl Rows {
    fn of(test: &'static str, parameter: &'static str) -> Self {
        Self { test, parameter, rows: Vec::new() }
    }

    /// Tries values of `range` on a method.
    fn method(mut self, name: impl Into<String>, range: (f64, f64), survives: impl Fn(f64) -> bool) -> Self {
        let largest = largest(range, survives);
        let method = name.into();
        let (test, parameter, tried) = (self.test.to_owned(), self.parameter.to_owned(), range.1);
        self.rows.push(Survival { test, parameter, method, largest, tried, shipped: false });
        self
    }

    /// Tries them on the shipped engine.
    fn shipped(mut self, range: (f64, f64), survives: impl Fn(f64) -> bool) -> Vec<Survival> {
        self = self.method("shipped engine", range, survives);
        if let Some(row) = self.rows.last_mut() {
            row.shipped = true;
        }
        self.rows
    }
}

/// The largest value from `least` to `most` up to which `survives` holds: doubled until it does not, then halved in between.
/// 0 if it does not hold for `least`.
pub fn largest((least, most): (f64, f64), survives: impl Fn(f64) -> bool) -> f64 {
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
    while bad > good * (1.0 + RESOLUTION) {
        let middle = 0.5 * (good + bad);
        if survives(middle) { good = middle } else { bad = middle }
    }
    good
}

/// How finely [`largest`] looks, relative.
const RESOLUTION: f64 = 1e-3;

/// A test: all its rows.
type Test = fn() -> Vec<Survival>;

/// All tests, in the order of the report.
pub const TESTS: [Test; 17] = [
    motion::terminal_velocity,
    motion::swings,
    motion::gust_reversal,
    motion::gust_blow_up,
    contacts::tunnelling,
    contacts::tunnelling_of_bodies,
    contacts::heavy_on_light,
    contacts::columns,
    bouncing::resting_jitter,
    bouncing::coulomb_stop,
    bouncing::zeno,
    bouncing::minute_of_bounces,
    contacts::simultaneous_impacts,
    contacts::simultaneous_impacts_in_a_crowd,
    robustness::far_from_the_origin,
    robustness::hitch,
    robustness::nonsense,
];

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
}
