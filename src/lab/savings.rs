//! The parts of the model that each level, experiment and scene of the Lab runs and leaves out, and what it would cost to run them all.

use super::curve::{above_zero, not_negative, rows, shortest, table};
use crate::game::{Controls, Game, TICK_RATE};
use crate::physics::{OPTIONAL, Plan, World};
use crate::{files::CsvRow, number::short};
use std::fmt::Write;

pub const FILE: &str = "savings.csv";
pub const TITLE: &str = "No more than a scene needs: time a tick as it runs, and with every part";
/// The kind of rows that are levels.
pub const LEVEL: &str = "level";
/// As many as [`OPTIONAL`] has parts, and one for direct answers.
const PARTS: usize = OPTIONAL.len() + 1;
const ROW: [&str; 6] = ["of", "scene", "version", "parts", "left_out", "same_bits"];
const TIMES: [&str; 4] = ["work", "spread", "everything", "everything_spread"];
const COSTS: [&str; PARTS] = ["air", "streams", "liquids", "links", "moving", "bounces", "direct"];

fn head() -> Vec<&'static str> {
    [&ROW[..], &TIMES, &COSTS].concat()
}

/// A row; times are ns a tick.
#[derive(Clone, Debug, PartialEq)]
pub struct Saving {
    /// level, experiment or scene.
    pub of: String,
    pub scene: String,
    /// The engine's [`crate::physics::SOURCES`].
    pub version: String,
    pub parts: String,
    pub left_out: String,
    /// Whether all parts together change no bit in any tick.
    pub same_bits: bool,
    /// As it runs, and with every part: the median, and the distance of the quartiles in parts of it.
    pub planned: (f64, f64),
    pub everything: (f64, f64),
    /// What each part costs more that is left out; the last: to solve again what does not change.
    pub costs: [Option<f64>; PARTS],
}

impl Saving {
    pub fn times(&self) -> f64 {
        self.everything.0 / self.planned.0
    }
}

/// What is run: a game under keys, or a world, for a number of ticks.
#[derive(Clone, Debug)]
pub enum TimedRun {
    Game(Box<Game>, Vec<Controls>),
    World(Box<World>, usize),
}

impl TimedRun {
    pub fn world(&self) -> &World {
        match self {
            Self::Game(game, _) => game.world(),
            Self::World(world, _) => world,
        }
    }

    pub fn ticks(&self) -> usize {
        match self {
            Self::Game(_, keys) => keys.len(),
            Self::World(_, ticks) => *ticks,
        }
    }

    pub fn tick(&mut self, tick: usize) {
        match self {
            Self::Game(game, keys) => game.step(keys[tick]),
            Self::World(world, _) => world.step(1.0 / TICK_RATE),
        }
    }

    #[must_use]
    pub fn under(&self, plan: &Plan) -> Self {
        let mut other = self.clone();
        match &mut other {
            Self::Game(game, _) => game.set_plan(plan.clone()),
            Self::World(world, _) => world.set_plan(plan.clone()),
        }
        other
    }

    /// As it runs, with every part, and with each part of [`Saving::costs`] alone that it leaves out.
    pub fn plans(&self) -> Vec<Option<Plan>> {
        let own = self.world().plan();
        let with = |part: &fn(&mut Plan) -> &mut bool, value: bool| {
            let mut plan = own.clone();
            *part(&mut plan) = value;
            Some(plan).filter(|plan| plan != own)
        };
        let direct: fn(&mut Plan) -> &mut bool = |plan| &mut plan.direct;
        let parts = OPTIONAL.iter().map(|(_, part)| with(part, true)).chain([with(&direct, false)]);
        [own.clone(), Plan::EVERYTHING].map(Some).into_iter().chain(parts).collect()
    }

    /// Whether another plan changes no bit in any tick.
    pub fn is_alike(&self, plan: &Plan) -> bool {
        let (mut own, mut other) = (self.clone(), self.under(plan));
        let bits = |trial: &Self, words: &mut Vec<u64>| trial.world().hash_state(&mut |word| words.push(word));
        let (mut a, mut b) = (Vec::new(), Vec::new());
        (0..self.ticks()).all(|tick| {
            own.tick(tick);
            other.tick(tick);
            a.clear();
            b.clear();
            bits(&own, &mut a);
            bits(&other, &mut b);
            a == b
        })
    }
}

pub fn csv(savings: &[Saving]) -> String {
    let row = |row: &Saving| {
        let words = [&row.of, &row.scene, &row.version, &row.parts, &row.left_out].map(String::clone);
        let times = [row.planned.0, row.planned.1, row.everything.0, row.everything.1].map(shortest);
        let costs = row.costs.map(|cost| cost.map_or_else(String::new, shortest));
        words.into_iter().chain([row.same_bits.to_string()]).chain(times).chain(costs).collect()
    };
    table(&head(), savings.iter().map(row))
}

/// Errors: file and line of the first row that cannot be read.
pub fn read(text: &str) -> Result<Vec<Saving>, String> {
    let saving = |row: CsvRow<'_>| {
        let word = |column| row.get(column).to_owned();
        let mut costs = [None; PARTS];
        for (cost, column) in costs.iter_mut().zip(&COSTS).filter(|(_, column)| !row.get(column).is_empty()) {
            *cost = Some(row.parse(column, "a number, or nothing", |cost: &f64| cost.is_finite())?);
        }
        Ok(Saving {
            of: word("of"),
            scene: word("scene"),
            version: word("version"),
            parts: word("parts"),
            left_out: word("left_out"),
            same_bits: row.parse("same_bits", "true or false", |_| true)?,
            planned: (above_zero(&row, "work")?, not_negative(&row, "spread")?),
            everything: (above_zero(&row, "everything")?, not_negative(&row, "everything_spread")?),
            costs,
        })
    };
    rows(FILE, text, &head())?.into_iter().map(saving).collect()
}

/// What each part costs, in a sentence.
pub fn sentence(savings: &[Saving]) -> Option<String> {
    let largest = savings.iter().max_by(|a, b| a.times().total_cmp(&b.times()))?;
    let mut text = "Where nothing needs it, a part that runs all the same costs, in nanoseconds a tick:".to_owned();
    let names = OPTIONAL.iter().map(|(name, _)| *name).chain(["to solve again what does not change"]);
    for (part, name) in names.enumerate() {
        let costs = median(savings.iter().filter_map(|saving| saving.costs[part]));
        let _ = write!(
            text,
            "{} {name} {}",
            if part == 0 { "" } else { "," },
            costs.filter(|cost| *cost >= 1.0).map_or("less than 1".to_owned(), short)
        );
    }
    let times = median(savings.iter().map(Saving::times)).unwrap_or(1.0);
    let alike = savings.iter().filter(|saving| saving.same_bits).count();
    let (rows, most, scene) = (savings.len(), short(largest.times()), &largest.scene);
    let _ = write!(
        text,
        " (medians of the levels, experiments and scenes that leave it out). With every part on, a tick takes {} times as long at the \
         median and {most} times at most (`{scene}`); {alike} of {rows} move alike to the last bit.",
        short(times)
    );
    Some(text)
}

pub(super) fn median(values: impl Iterator<Item = f64>) -> Option<f64> {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied()
}
