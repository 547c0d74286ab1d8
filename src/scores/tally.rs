//! Sums over lists of attempts and of answers to experiments, from any number of files.

use super::attempts;
use super::name::Name;
use super::players::unharmed;
use super::results;
use crate::files::{CsvFile, CsvRow};
use crate::words::tr;
use std::collections::{BTreeMap, BTreeSet, HashSet};

#[derive(Clone, Debug, Default)]
pub struct LevelTally {
    pub players: BTreeSet<Name>,
    pub tries: usize,
    pub successes: usize,
    /// Losses by their cause.
    pub causes: BTreeMap<String, usize>,
    /// Of successes without help, s.
    times: Vec<f64>,
}

#[derive(Clone, Debug, Default)]
pub struct ExperimentTally {
    pub players: BTreeSet<Name>,
    pub answers: usize,
    /// Right and wrong ones; others are not judged.
    pub guesses: [usize; 2],
    pub readings: [usize; 2],
}

/// The sums by level and by experiment.
#[derive(Clone, Debug, Default)]
pub struct Tally {
    pub levels: BTreeMap<String, LevelTally>,
    pub experiments: BTreeMap<String, ExperimentTally>,
    /// A copy of a file counts no answer twice: each has its second.
    seen: HashSet<String>,
}

impl LevelTally {
    /// Of the times of successes without help, s; `None` without one.
    pub fn median(&self) -> Option<f64> {
        let mut times = self.times.clone();
        times.sort_unstable_by(f64::total_cmp);
        let (below, above) = (times.get(times.len().checked_sub(1)? / 2)?, times.get(times.len() / 2)?);
        Some((below + above) / 2.0)
    }
}

impl Tally {
    /// Adds a file. The answer is a message for each row that cannot be read; `None`: the file begins as neither list does.
    pub fn add(&mut self, name: &str, bytes: &[u8]) -> Option<Vec<String>> {
        type Reader = fn(&mut Tally, &CsvRow<'_>) -> Result<(), String>;
        let lists: [(&str, Reader); 2] = [(attempts::HEADER, Self::add_attempt), (results::HEADER, Self::add_answer)];
        for (header, read) in lists {
            let columns: Vec<&str> = header.trim_start_matches('\u{feff}').trim_end().split(',').collect();
            let mut rows = CsvFile { name, columns: &columns, comments: false }.rows(bytes);
            if !rows.next()?.is_header(columns.len()) {
                continue;
            }
            let read_row = |row: CsvRow<'_>| match row.fault().map(|fault| fault.words()) {
                Some((found, expected)) => Err(row.row_problem(found, expected)),
                None if row.used() > columns.len() => {
                    Err(row.row_problem(format_args!("{} cells", row.used()), format_args!("{} cells", columns.len())))
                }
                None => read(self, &row),
            };
            return Some(rows.map(read_row).filter_map(Result::err).collect());
        }
        None
    }

    fn add_attempt(&mut self, row: &CsvRow<'_>) -> Result<(), String> {
        let (level, player) = (text(row, "level")?, player(row)?);
        let done = word(row, "result", ["completed", "failed"])? == 0;
        let time: f64 = row.parse("time", "a number of seconds from 0", |time: &f64| time.is_finite() && *time >= 0.0)?;
        let assisted = word(row, "assisted", ["true", "false"])? == 0;
        let tally = self.levels.entry(level).or_default();
        tally.players.insert(player);
        tally.tries += 1;
        tally.successes += usize::from(done);
        if done {
            tally.times.extend((!assisted).then_some(time));
        } else {
            let cause = Some(row.get("cause")).filter(|cause| !cause.is_empty()).unwrap_or("unknown");
            *tally.causes.entry(unharmed(cause).to_owned()).or_default() += 1;
        }
        Ok(())
    }

    fn add_answer(&mut self, row: &CsvRow<'_>) -> Result<(), String> {
        let (experiment, player) = (text(row, "experiment")?, player(row)?);
        let [guess, readings] = [verdict(row, "guess_right")?, verdict(row, "readings_right")?];
        if !self.seen.insert(row.joined()) {
            return Ok(());
        }
        let tally = self.experiments.entry(experiment).or_default();
        tally.players.insert(player);
        tally.answers += 1;
        for (counts, judged) in [(&mut tally.guesses, guess), (&mut tally.readings, readings)] {
            if let Some(count) = judged.and_then(|index| counts.get_mut(index)) {
                *count += 1;
            }
        }
        Ok(())
    }
}

fn text(row: &CsvRow<'_>, column: &str) -> Result<String, String> {
    let cell = unharmed(row.get(column));
    if cell.is_empty() { Err(row.bad_cell(column, "a name")) } else { Ok(cell.to_owned()) }
}

fn player(row: &CsvRow<'_>) -> Result<Name, String> {
    Name::new(row.get("player")).map_err(|error| row.bad_cell("player", tr!("a user name: {error}", error)))
}

/// The index of a word, in any case of its letters: a spreadsheet writes TRUE for true.
fn word(row: &CsvRow<'_>, column: &str, [first, second]: [&str; 2]) -> Result<usize, String> {
    let found = [first, second].iter().position(|word| row.get(column).eq_ignore_ascii_case(word));
    found.ok_or_else(|| row.bad_cell(column, format_args!("{first} or {second}")))
}

/// 0 for a right one, 1 for a wrong one; `None` where nothing is judged.
fn verdict(row: &CsvRow<'_>, column: &str) -> Result<Option<usize>, String> {
    if row.get(column).is_empty() { Ok(None) } else { word(row, column, ["yes", "no"]).map(Some) }
}
