//! What a level's medals ask for: silver and gold a time, the mark what the level is about. Bronze asks for no more than its end.

use super::problem::{Problem, quoted};
use super::quantity::Quantity;
use super::table::Record;

/// The most hits or pushes that a mark can allow: who needs more has no use for the mark.
const MOST: f64 = 1e6;

/// What a level's medals ask for; a level that says nothing has bronze alone.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Awards {
    /// The longest time for silver, s.
    pub silver: Option<f64>,
    /// The longest time for gold, s; no longer than that for silver.
    pub gold: Option<f64>,
    /// What the level's own mark asks for.
    pub mark: Option<Mark>,
}

/// What a level's own mark asks of a flight that completes it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mark {
    /// At most so many damaging hits.
    Hits(u32),
    /// At least so much of the fuel left, %.
    Fuel(f64),
    /// At most so many pushes of objects by the ship.
    Pushes(u32),
    /// Never faster than this, m/s.
    Speed(f64),
}

/// The settings of constants.csv that say so, and what each may hold.
pub(super) const SETTINGS: [(&str, Quantity); 6] = [
    ("silver", TIME),
    ("gold", TIME),
    ("mark_hits", COUNT),
    ("mark_fuel", Quantity::new(0.0, 100.0, "% of the fuel left")),
    ("mark_pushes", COUNT),
    ("mark_speed", Quantity::new(1e-3, 1e4, "m/s")),
];
const TIME: Quantity = Quantity::new(1e-3, 1e9, "s");
const COUNT: Quantity = Quantity::new(0.0, MOST, "");

impl Awards {
    /// What those settings come to that are given, each accepted by itself.
    pub(super) fn of(given: &[(&'static str, &Record, f64)], problems: &mut Vec<Problem>) -> Self {
        let mut awards = Self::default();
        let mut marked = None;
        for &(name, record, value) in given {
            let mark = match name {
                "silver" => {
                    awards.silver = Some(value);
                    continue;
                }
                "gold" => {
                    awards.gold = Some(value);
                    continue;
                }
                "mark_fuel" => Mark::Fuel(value),
                "mark_speed" => Mark::Speed(value),
                _ if value.fract() != 0.0 => {
                    let found = format!("{} for {name}", quoted(&value.to_string()));
                    problems.push(record.problem("value", found, "a whole number"));
                    continue;
                }
                // Whole and at most `MOST`, so the conversion is exact.
                "mark_hits" => Mark::Hits(value as u32),
                _ => Mark::Pushes(value as u32),
            };
            match marked {
                None => (awards.mark, marked) = (Some(mark), Some(name)),
                Some(first) => problems.push(record.problem("name", format!("{name} beside {first}"), "one mark a level")),
            }
        }
        let gold = given.iter().find(|(name, ..)| *name == "gold");
        if let (Some(silver), Some((_, record, gold))) = (awards.silver, gold)
            && *gold > silver
        {
            let expected = format!("no longer than silver, which is {silver} s");
            problems.push(record.problem("value", format!("{} for gold", quoted(&gold.to_string())), expected));
        }
        awards
    }
}
