//! `resultant stats`: sums of attempts by level and of answers by experiment.

use super::files::{CsvOutput, OutputFile, Staged};
use super::{CommandError, Readers, Status, project::Project, shown};
use crate::files::{self, FileKind};
use crate::level;
use crate::scores::{ExperimentTally, LevelTally, Tally, harmless, may_be_list};
use serde::Serialize;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::{collections::HashSet, fmt::Display};

const CSV: &str =
    "kind,name,players,tries,successes,median_time,lost_to,predictions_right,predictions_wrong,readings_right,readings_wrong";

#[derive(clap::Args, Debug)]
pub struct StatsArgs {
    /// Lists of attempts and of answers, or folders with such lists anywhere in them; without any, those of this game
    #[arg(value_name = "PATH")]
    paths: Vec<PathBuf>,
    /// Write the sums as CSV, too
    #[arg(long, value_name = "OUT")]
    csv: Option<PathBuf>,
}

/// A row of the file of sums; tries are attempts or answers.
#[derive(Default, Serialize)]
struct StatsRow<'a> {
    kind: &'a str,
    name: &'a str,
    players: usize,
    tries: usize,
    successes: Option<usize>,
    /// s.
    median_time: Option<String>,
    lost_to: String,
    judged: [Option<usize>; 4],
}

/// Tables go to `out`, unreadable rows and files to standard error. Errors: a path that is not there; a file of sums that cannot be written.
pub fn run(args: &StatsArgs, project: &Project, out: &mut dyn Write) -> Result<Status, CommandError> {
    let own = [project.scores(), project.root().join("results")];
    let paths: Vec<PathBuf> =
        if args.paths.is_empty() { own.into_iter().filter(|path| files::is_folder(path)).collect() } else { args.paths.clone() };
    let mut err = Readers::of(io::stderr().lock());
    let (mut tally, mut lists, mut problems) = (Tally::default(), Lists::default(), Vec::new());
    for path in &paths {
        files::look(path).map_err(|error| CommandError::Refused(format!("{}: {error}", path.display())))?;
        lists.gather(path);
    }
    let named: HashSet<&PathBuf> = paths.iter().collect();
    for list in &lists.found {
        let shown_list = shown(list.display());
        let faults = match files::read(list, files::INPUTS) {
            Ok(bytes) => tally.add(&shown_list, &bytes).unwrap_or_else(|| {
                let other = named.contains(list) || may_be_list(&bytes);
                let words = || format!("{shown_list}:1: found another table, expected a list of attempts or of answers");
                other.then(words).into_iter().collect()
            }),
            Err(error) => vec![format!("{shown_list}: {error}")],
        };
        if !faults.is_empty() {
            lists.lacking.push(shown_list);
            problems.extend(faults);
        }
    }
    for problem in lists.problems.iter().chain(&problems) {
        writeln!(err, "{}", shown(problem))?;
    }
    let [csv] = OutputFile::create_all([("--csv", args.csv.as_deref())], &lists.found)?;
    let status = if lists.lacking.is_empty() { Status::Done } else { Status::Wrong };
    if let (Status::Wrong, Some(path)) = (status, &args.csv) {
        writeln!(err, "{}: these sums are not whole: they lack {}", shown(path.display()), lists.lacking.join(", "))?;
    }
    let (levels, experiments) = (levels(&tally), &tally.experiments);
    print(&levels, experiments, out)?;
    if let Some(file) = csv {
        Staged::place_all([write_csv(&levels, experiments, file)?.stage()?])?;
    }
    Ok(status)
}

/// The lists of a command, each once, however it is reached.
#[derive(Default)]
struct Lists {
    found: Vec<PathBuf>,
    /// Files and folders without links.
    seen: HashSet<PathBuf>,
    /// Of what could not be looked into.
    problems: Vec<String>,
    /// What the sums lack, in whole or in part.
    lacking: Vec<String>,
}

impl Lists {
    /// Takes a list, or all in a folder at any depth. Hidden files and folders, whose names begin with a point, are no pupil's.
    fn gather(&mut self, from: &Path) {
        let mut waiting = vec![from.to_path_buf()];
        while let Some(path) = waiting.pop() {
            // A pipe that is passed on open has no other path.
            let resolved = || files::resolve(&path).or_else(|error| if path == from { Ok(path.clone()) } else { Err(error) });
            let looked = files::look(&path).and_then(|found| Ok((found.kind, resolved()?)));
            let below = match looked {
                Ok((_, ref resolved)) if !self.seen.insert(resolved.clone()) => continue,
                Ok((FileKind::Folder, _)) => files::names(&path),
                Ok(_) => {
                    let name = path.file_name().unwrap_or_default().to_string_lossy().to_lowercase();
                    if SPREADSHEETS.iter().any(|ending| name.ends_with(ending)) && path != from {
                        self.lack(&path, "found a spreadsheet's own file, expected CSV: save it as CSV");
                    } else if path == from || LISTS.iter().any(|ending| name.ends_with(ending)) {
                        self.found.push(path);
                    }
                    continue;
                }
                Err(error) => Err(error),
            };
            match below {
                Ok(mut names) => {
                    names.retain(|name| !name.as_encoded_bytes().starts_with(b"."));
                    names.sort_unstable();
                    waiting.extend(names.iter().rev().map(|name| path.join(name)));
                }
                Err(error) => self.lack(&path, error),
            }
        }
    }

    fn lack(&mut self, path: &Path, why: impl Display) {
        let path = shown(path.display());
        self.problems.push(format!("{path}: {why}"));
        self.lacking.push(path);
    }
}

/// Endings of tables as text. Spreadsheets save as any of them.
const LISTS: [&str; 3] = [".csv", ".tsv", ".txt"];
/// Endings of files that no reader of tables understands.
const SPREADSHEETS: [&str; 4] = [".xlsx", ".xls", ".ods", ".numbers"];

/// In the order of the list of levels.
fn levels(tally: &Tally) -> Vec<(&String, &LevelTally)> {
    let mut levels: Vec<_> = tally.levels.iter().collect();
    levels.sort_by(|a, b| level::by_number_then_name(a.0, b.0));
    levels
}

/// The most frequent cause first.
fn causes(level: &LevelTally) -> String {
    let mut causes: Vec<_> = level.causes.iter().collect();
    causes.sort_by_key(|(_, count)| std::cmp::Reverse(**count));
    causes.iter().map(|(cause, count)| format!("{cause} ({count})")).collect::<Vec<_>>().join(", ")
}

type Experiments = std::collections::BTreeMap<String, ExperimentTally>;

fn print(levels: &[(&String, &LevelTally)], experiments: &Experiments, out: &mut dyn Write) -> io::Result<()> {
    let mut tables = Vec::new();
    if !levels.is_empty() {
        let mut rows =
            vec![["level", "players", "tries", "successes", "rate", "median time", "lost to"].map(str::to_owned).to_vec()];
        rows.extend(levels.iter().map(|(name, level)| {
            let rate = format!("{:.0} %", 100.0 * level.successes as f64 / level.tries as f64);
            let median = level.median().map_or_else(|| "–".to_owned(), |median| format!("{median:.2} s"));
            let counts = [level.players.len(), level.tries, level.successes].map(|count| count.to_string());
            let [players, tries, successes] = counts;
            vec![shown(name), players, tries, successes, rate, median, shown(causes(level))]
        }));
        tables.push(rows);
    }
    if !experiments.is_empty() {
        let heading = ["experiment", "players", "answers", "predictions right", "wrong", "readings right", "wrong"];
        let mut rows = vec![heading.map(str::to_owned).to_vec()];
        rows.extend(experiments.iter().map(|(name, experiment)| {
            let ([right, wrong], [read, misread]) = (experiment.predictions, experiment.readings);
            let counts = [experiment.players.len(), experiment.answers(), right, wrong, read, misread];
            std::iter::once(shown(name)).chain(counts.map(|count| count.to_string())).collect()
        }));
        tables.push(rows);
    }
    if tables.is_empty() {
        writeln!(out, "no attempts and no answers")?;
    }
    for (i, rows) in tables.iter().enumerate() {
        if i > 0 {
            writeln!(out)?;
        }
        print_table(rows, out)?;
    }
    Ok(())
}

/// Words to the left, numbers to the right.
fn print_table(rows: &[Vec<String>], out: &mut dyn Write) -> io::Result<()> {
    let columns = rows.first().map_or(0, Vec::len);
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..columns).map(width).collect();
    for row in rows {
        let cell = |(column, text): (usize, &String)| {
            let (width, words) = (widths[column], column == 0 || rows[0][column] == "lost to");
            if words { format!("{text:<width$}") } else { format!("{text:>width$}") }
        };
        let line: Vec<String> = row.iter().enumerate().map(cell).collect();
        writeln!(out, "{}", line.join("  ").trim_end())?;
    }
    Ok(())
}

fn write_csv(levels: &[(&String, &LevelTally)], experiments: &Experiments, file: OutputFile) -> Result<OutputFile, CommandError> {
    let mut table = CsvOutput::new(file, CSV)?;
    for (name, level) in levels {
        table.row(&StatsRow {
            kind: "level",
            name: &harmless(name),
            players: level.players.len(),
            tries: level.tries,
            successes: Some(level.successes),
            median_time: level.median().map(|median| format!("{median:.3}")),
            lost_to: harmless(&causes(level)).into_owned(),
            judged: [None; 4],
        })?;
    }
    for (name, experiment) in experiments {
        let ([right, wrong], [read, misread]) = (experiment.predictions, experiment.readings);
        table.row(&StatsRow {
            kind: "experiment",
            name: &harmless(name),
            players: experiment.players.len(),
            tries: experiment.answers(),
            judged: [right, wrong, read, misread].map(Some),
            ..StatsRow::default()
        })?;
    }
    Ok(table.into_inner()?)
}
