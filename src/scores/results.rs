//! Sums over lists of attempts and of answers to experiments. Answers: a file a player, a row a reading, the prediction in the first row that is handed
//! in with it. The game only adds rows. RFC 4180, CRLF, UTF-8 behind a byte-order mark, without which Excel takes it for another encoding.

use super::folder::{self, as_text};
use super::name::{Name, ScoresError};
use super::players::{harmless, unharmed};
use crate::files::{CsvColumn, CsvFile, CsvRow, CsvStruct, truth};
use crate::{level, number};
use serde::{Deserialize, Serialize, Serializer};
use std::collections::{BTreeMap, BTreeSet, HashSet};
use std::{borrow::Cow, path::PathBuf};

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
    /// By who handed in, and when: its rows are one.
    answers: BTreeSet<(Name, String)>,
    /// Right and wrong ones; others are not judged.
    pub predictions: [usize; 2],
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

impl ExperimentTally {
    pub fn answers(&self) -> usize {
        self.answers.len()
    }
}

impl Tally {
    /// Adds a file. The answer is a message for each row that cannot be read; `None`: the file begins as neither list does.
    pub fn add(&mut self, name: &str, bytes: &[u8]) -> Option<Vec<String>> {
        type Reader = fn(&mut Tally, &CsvRow<'_>) -> Result<(), String>;
        let lists: [(&str, Reader); 2] = [(folder::HEADER, Self::add_attempt), (HEADER, Self::add_answer)];
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
        let AttemptCells { level, player, completed: done, time, cause, assisted, .. } = cells(row)?;
        let tally = self.levels.entry(level).or_default();
        tally.players.insert(player);
        tally.tries += 1;
        tally.successes += usize::from(done);
        if done {
            tally.times.extend((!assisted).then_some(time));
        } else {
            let cause = if cause.is_empty() { "unknown".to_owned() } else { cause };
            *tally.causes.entry(cause).or_default() += 1;
        }
        Ok(())
    }

    fn add_answer(&mut self, row: &CsvRow<'_>) -> Result<(), String> {
        let AnswerCells { player, experiment, time, prediction_right, reading_right, .. } = cells(row)?;
        if !self.seen.insert(row.joined()) {
            return Ok(());
        }
        let tally = self.experiments.entry(experiment).or_default();
        tally.players.insert(player.clone());
        tally.answers.insert((player, time));
        for (counts, judged) in [(&mut tally.predictions, prediction_right), (&mut tally.readings, reading_right)] {
            if let Some(right) = judged {
                counts[usize::from(!right)] += 1;
            }
        }
        Ok(())
    }
}

/// Whether a file that [`Tally::add`] does not read may be a list of attempts or of answers all the same: it has most names of a header, in
/// any order, or rows as such lists have them, or it is no text.
pub fn may_be_list(bytes: &[u8]) -> bool {
    let wide = [[0xFF, 0xFE], [0xFE, 0xFF]].iter().any(|mark| bytes.starts_with(mark));
    bytes.contains(&0) && !wide || is_like::<AttemptCells>(bytes) || is_like::<AnswerCells>(bytes)
}

fn is_like<T: CsvStruct>(bytes: &[u8]) -> bool {
    let columns: Vec<&str> = T::COLUMNS.iter().map(|column| column.name).collect();
    let named = |row: &CsvRow<'_>, name: &&&str| row.cells.iter().any(|cell| cell.text.trim().eq_ignore_ascii_case(name));
    let mut rows = CsvFile { name: "", columns: &columns, comments: false }.rows_of::<T>(bytes).take(LOOKED_AT);
    rows.any(|row| {
        let is_row = row.cells.len() == columns.len() && row.read::<T>().is_ok();
        is_row || 2 * columns.iter().filter(|name| named(&row, name)).count() > columns.len()
    })
}

/// Rows in which a header and those of a list are looked for.
const LOOKED_AT: usize = 5;

#[derive(Deserialize)]
#[allow(dead_code)] // Some columns are no part of the sums.
struct AttemptCells {
    level: String,
    player: Name,
    completed: bool,
    /// s.
    time: f64,
    fuel: String,
    hits: String,
    cause: String,
    assisted: bool,
}

#[derive(Deserialize)]
#[allow(dead_code)] // Some columns are no part of the sums.
struct AnswerCells {
    player: Name,
    experiment: String,
    time: String,
    prediction: String,
    predicted: String,
    prediction_right: Option<bool>,
    quantity: String,
    reading: String,
    unit: String,
    tick: String,
    reading_right: Option<bool>,
    answer: String,
}

impl CsvStruct for AttemptCells {
    const COLUMNS: &'static [CsvColumn] = &[
        CsvColumn { name: "level", plain: |_, text| named(text) },
        CsvColumn { name: "player", plain: |_, text| Name::cell(text) },
        CsvColumn { name: "result", plain: |_, text| one_of(text, ["completed", "failed"]) },
        CsvColumn {
            name: "time",
            plain: |dialect, text| {
                let number = dialect.number(text);
                let good = number.parse().is_ok_and(|time: f64| time.is_finite() && time >= 0.0);
                if good { Ok(number) } else { Err("a number of seconds from 0".to_owned()) }
            },
        },
        CsvColumn { name: "fuel", plain: |_, text| Ok(text.into()) },
        CsvColumn { name: "hits", plain: |_, text| Ok(text.into()) },
        CsvColumn { name: "cause", plain: |_, text| Ok(unharmed(text).into()) },
        CsvColumn {
            name: "assisted",
            plain: |_, text| truth(text).map(|truth| truth.to_string().into()).ok_or_else(|| "true or false".to_owned()),
        },
    ];
}

impl CsvStruct for AnswerCells {
    const COLUMNS: &'static [CsvColumn] = &[
        CsvColumn { name: "player", plain: |_, text| Name::cell(text) },
        CsvColumn { name: "experiment", plain: |_, text| named(text) },
        CsvColumn { name: "time", plain: |_, text| Ok(text.into()) },
        CsvColumn { name: "prediction", plain: |_, text| Ok(text.into()) },
        CsvColumn { name: "predicted", plain: |_, text| Ok(text.into()) },
        CsvColumn { name: "prediction_right", plain: |_, text| verdict(text) },
        CsvColumn { name: "quantity", plain: |_, text| Ok(text.into()) },
        CsvColumn { name: "reading", plain: |_, text| Ok(text.into()) },
        CsvColumn { name: "unit", plain: |_, text| Ok(text.into()) },
        CsvColumn { name: "tick", plain: |_, text| Ok(text.into()) },
        CsvColumn { name: "reading_right", plain: |_, text| verdict(text) },
        CsvColumn { name: "answer", plain: |_, text| Ok(text.into()) },
    ];
}

/// The error is the first refused cell.
fn cells<T: CsvStruct>(row: &CsvRow<'_>) -> Result<T, String> {
    row.read().map_err(|wrong| row.problems(wrong.into_iter().take(1).collect()))
}

fn named(text: &str) -> Result<Cow<'_, str>, String> {
    let name = unharmed(text);
    if name.is_empty() { Err("a name".to_owned()) } else { Ok(name.into()) }
}

/// Whether it is the first word, in any case of its letters.
fn one_of<'a>(text: &str, [first, second]: [&str; 2]) -> Result<Cow<'a, str>, String> {
    let found = [(first, "true"), (second, "false")].into_iter().find(|(word, _)| word.eq_ignore_ascii_case(text));
    found.map(|(_, plain)| plain.into()).ok_or_else(|| format!("{first} or {second}"))
}

/// Empty where nothing is judged.
fn verdict(text: &str) -> Result<Cow<'_, str>, String> {
    if text.is_empty() { Ok(text.into()) } else { one_of(text, ["yes", "no"]) }
}

pub(super) const HEADER: &str =
    "\u{feff}player,experiment,time,prediction,predicted,prediction_right,quantity,reading,unit,tick,reading_right,answer\r\n";

#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct ResultRow {
    pub player: Name,
    #[serde(serialize_with = "as_text")]
    pub experiment: String,
    /// `2026-11-24 15:58:21`, UTC.
    pub time: String,
    /// Empty where it is in a row before.
    #[serde(serialize_with = "as_number_or_text")]
    pub prediction: String,
    /// When it was made, as `time`.
    pub predicted: String,
    /// `None` where nothing says what is right.
    #[serde(serialize_with = "as_verdict")]
    pub prediction_right: Option<bool>,
    /// What was read, as the experiment's list names it; the unit that its cell asks for.
    #[serde(serialize_with = "as_text")]
    pub quantity: String,
    #[serde(serialize_with = "as_number_or_text")]
    pub reading: String,
    pub unit: String,
    /// The moment of the flight that was shown then.
    pub tick: Option<u64>,
    #[serde(serialize_with = "as_verdict")]
    pub reading_right: Option<bool>,
    /// The exact one, of the experiment.
    #[serde(serialize_with = "as_text")]
    pub answer: String,
}

/// `seconds` since 1970-01-01, 0 UTC, to the second: `2026-11-24 15:58:21`.
pub fn time_of(seconds: f64) -> String {
    let seconds = seconds.max(0.0) as u64;
    let (year, month, day) = civil(seconds / 86_400);
    let of_day = seconds % 86_400;
    format!("{year:04}-{month:02}-{day:02} {:02}:{:02}:{:02}", of_day / 3600, of_day / 60 % 60, of_day % 60)
}

/// Year, month and day of the Gregorian calendar, after Howard Hinnant, "chrono-Compatible Low-Level Date Algorithms".
const fn civil(since_1970: u64) -> (u64, u64, u64) {
    // Years begin in March: the leap day is their last one.
    let days = since_1970 + 719_468;
    let (era, day) = (days / 146_097, days % 146_097);
    let year = (day - day / 1460 + day / 36_524 - day / 146_096) / 365;
    let of_year = day - (365 * year + year / 4 - year / 100);
    let month = (5 * of_year + 2) / 153;
    let of_month = of_year - (153 * month + 2) / 5 + 1;
    let january = (month + 2) % 12 + 1;
    (year + era * 400 + (january <= 2) as u64, january, of_month)
}

/// The folder of these files.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Results {
    folder: PathBuf,
}

impl Results {
    /// The folder need not exist yet.
    pub fn new(folder: impl Into<PathBuf>) -> Self {
        Self { folder: folder.into() }
    }

    /// The file of a player. Windows takes some names for devices.
    pub fn file(&self, player: &Name) -> PathBuf {
        let more = if level::is_device(player.as_str()) { "_" } else { "" };
        self.folder.join(format!("{player}{more}.csv"))
    }

    /// Adds the rows of a player. Errors: a file that is no list of answers; see [`crate::files::SaveError`].
    pub fn append(&self, rows: &[ResultRow]) -> Result<(), ScoresError> {
        let Some(first) = rows.first() else { return Ok(()) };
        let lines: String = rows.iter().map(folder::line).collect();
        folder::append(&self.file(&first.player), HEADER, &lines)
    }
}

/// A number as it is, also with a sign in front and a decimal comma; other text so that no spreadsheet reads it as a formula.
fn as_number_or_text<S: Serializer>(text: &str, to: S) -> Result<S::Ok, S::Error> {
    to.serialize_str(&if number::is_plain(text) { text.into() } else { harmless(text) })
}

fn as_verdict<S: Serializer>(right: &Option<bool>, to: S) -> Result<S::Ok, S::Error> {
    to.serialize_str(right.map_or("", |right| if right { "yes" } else { "no" }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spreadsheets::saved;

    #[test]
    fn lists_count_the_same_whatever_spreadsheet_saved_them() {
        let attempts = "level,player,result,time,fuel,hits,cause,assisted\n1,ann,completed,5.483,0.850,2,,false\n\"a; b\",bob,failed,1.5,1.000,0,obstacle 2,true\n";
        let answers = "player,experiment,time,prediction,predicted,prediction_right,quantity,reading,unit,tick,reading_right,answer\n\
                       ann,hooke,2026-11-24 15:58:21,0.5,2026-11-24 15:50:00,no,stretch,\"3,9 m; 4\",m,12,yes,F = k\n";
        let summed = |bytes: &[u8]| {
            let mut tally = Tally::default();
            let problems = tally.add("a.csv", bytes);
            let levels: Vec<_> =
                tally.levels.iter().map(|(level, sums)| (level.clone(), sums.tries, sums.successes, sums.median())).collect();
            let answers: Vec<_> =
                tally.experiments.iter().map(|(name, sums)| (name.clone(), sums.predictions, sums.readings)).collect();
            (problems, levels, answers)
        };
        for plain in [attempts, answers] {
            let expected = summed(plain.as_bytes());
            assert_eq!(expected.0, Some(vec![]));
            for saved in saved(plain, |text| text.parse::<f64>().is_ok_and(|number| number.fract() != 0.0)) {
                assert_eq!(summed(&saved.bytes), expected, "{}", saved.form);
            }
        }
        let german = "level;player;result;time;fuel;hits;cause;assisted\r\n1;ann;completed;5,483;0,85;2;;FALSCH\r\n";
        assert_eq!(summed(german.as_bytes()).1, [("1".to_owned(), 1, 1, Some(5.483))]);
    }

    #[test]
    fn numbers_stay_numbers_and_no_prediction_is_a_formula() {
        let mut row = ResultRow {
            player: Name::new("ann").unwrap(),
            experiment: "hooke".to_owned(),
            time: "2026-11-24 15:58:21".to_owned(),
            prediction: "-5,25".to_owned(),
            predicted: "2026-11-24 15:50:00".to_owned(),
            prediction_right: Some(false),
            quantity: "soft spring, force".to_owned(),
            reading: "48 N, \"soft\"; 50 N".to_owned(),
            unit: "N/m".to_owned(),
            tick: Some(240),
            reading_right: Some(true),
            answer: "F = k·s".to_owned(),
        };
        let start = "ann,hooke,2026-11-24 15:58:21";
        let expected = format!(
            "{start},\"-5,25\",2026-11-24 15:50:00,no,\"soft spring, force\",\"48 N, \"\"soft\"\"; 50 N\",N/m,240,yes,F = k·s\r\n"
        );
        assert_eq!(folder::line(&row), expected);
        (row.prediction_right, row.reading_right, row.tick) = (None, None, None);
        for (text, cell) in [
            ("=1+1", "'=1+1"),
            ("+5", "+5"),
            ("+5 N", "'+5 N"),
            ("-5", "-5"),
            ("-5-5", "'-5-5"),
            ("-", "'-"),
            ("@SUM(A1)", "'@SUM(A1)"),
            ("-inf", "'-inf"),
            ("", ""),
        ] {
            (row.prediction, row.reading) = (text.to_owned(), text.to_owned());
            let expected = format!("{start},{cell},2026-11-24 15:50:00,,\"soft spring, force\",{cell},N/m,,,F = k·s\r\n");
            assert_eq!(folder::line(&row), expected);
        }
    }

    #[test]
    fn days_are_those_of_the_calendar() {
        for (days, date) in
            [(0, "1970-01-01"), (59, "1970-03-01"), (11_016, "2000-02-29"), (11_017, "2000-03-01"), (20_781, "2026-11-24")]
        {
            assert_eq!(time_of(86_400.0 * f64::from(days) + 86_399.9), format!("{date} 23:59:59"));
        }
    }

    #[test]
    fn the_file_of_a_device_has_another_name() {
        let file = |name| Results::new("results").file(&Name::new(name).unwrap());
        assert_eq!((file("ann"), file("Con")), ("results/ann.csv".into(), "results/Con_.csv".into()));
    }
}
