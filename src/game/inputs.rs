//! Recorded inputs: what was held for how many ticks, as a CSV file that people can write.
//!
//! ```text
//! ticks,thrust,reverse,left,right
//! 60,1,0,0,0
//! 15,1,0,0,1
//! ```
//!
//! Each row holds its keys (0 or 1) for that many ticks; after the last row nothing is pressed. Blank lines and lines that start
//! with `#` are skipped; CRLF, a byte-order mark and spaces around a cell are accepted.

use super::clock::Controls;
use crate::files::{BadCell, CsvColumn, CsvFile, CsvRow, CsvStruct, Dialect, found_instead, place, whole};
use crate::words::tr;
use csv::WriterBuilder;
use serde::{Deserialize, Serialize, Serializer};
use std::{borrow::Cow, fmt};

pub const HEADER: &str = "ticks,thrust,reverse,left,right";
/// Three months at the game's rate: more is a slip of the pen.
pub const MOST_TICKS: u64 = 1_000_000_000;

const MOST_PROBLEMS: usize = 1000;

/// A refused file: each problem on a line `file:line: column "name": found …, expected …`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BadFile(pub Vec<String>);

impl fmt::Display for BadFile {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0.join("\n"))
    }
}

impl std::error::Error for BadFile {}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
struct HeldKeys {
    ticks: u64,
    #[serde(serialize_with = "as_keys")]
    controls: Controls,
}

#[derive(Deserialize)]
struct InputRow {
    ticks: u64,
    thrust: bool,
    reverse: bool,
    left: bool,
    right: bool,
}

const fn key(name: &'static str) -> CsvColumn {
    let plain = |dialect: Dialect, text: &str| match whole(&dialect.number(text)) {
        "0" => Ok("false".into()),
        "1" => Ok("true".into()),
        _ => Err(tr("0 or 1").into()),
    };
    CsvColumn { name, plain }
}

impl CsvStruct for InputRow {
    const COLUMNS: &'static [CsvColumn] =
        &[CsvColumn { name: "ticks", plain: ticks }, key("thrust"), key("reverse"), key("left"), key("right")];
}

fn ticks(dialect: Dialect, text: &str) -> Result<Cow<'_, str>, String> {
    let number = dialect.number(text);
    let ticks = whole(&number);
    match ticks.parse() {
        Ok(1..=MOST_TICKS) => Ok(ticks.to_owned().into()),
        _ => Err(tr!("a whole number from {least} to {most}", least = 1, most = MOST_TICKS)),
    }
}

fn as_keys<S: Serializer>(controls: &Controls, to: S) -> Result<S::Ok, S::Error> {
    let &Controls { thrust, reverse, left, right } = controls;
    [thrust, reverse, left, right].map(u8::from).serialize(to)
}

#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Inputs {
    rows: Vec<HeldKeys>,
}

impl Inputs {
    /// `file` is the file's name in messages. Errors: a missing header, a wrong number of cells, ticks that are no whole number from 1, a key that is
    /// neither 0 nor 1, more than [`MOST_TICKS`] in all.
    pub fn parse(file: &str, text: &str) -> Result<Self, BadFile> {
        let columns: Vec<&str> = HEADER.split(',').collect();
        let mut rows = CsvFile { name: file, columns: &columns, comments: true }.rows_of::<InputRow>(text.as_bytes());
        let header_row = || tr!("the header {header}", header = HEADER);
        match rows.next() {
            Some(row) if row.is_header(columns.len()) && row.used() == columns.len() => {}
            Some(row) => return Err(BadFile(vec![row.problem("ticks", format_args!("{:?}", row.joined()), header_row())])),
            None => {
                return Err(BadFile(vec![found_instead(&place(file, 1, "ticks"), tr("nothing"), header_row())]));
            }
        }

        let (mut inputs, mut problems) = (Self::default(), Vec::new());
        let mut total: u64 = 0;
        for row in rows {
            if problems.len() >= MOST_PROBLEMS {
                problems.push(row.problem(
                    "ticks",
                    tr("more problems from here on"),
                    tr!("at most {most} in a file", most = MOST_PROBLEMS),
                ));
                break;
            }
            let Some(held) = held(&row, &columns, &mut problems) else { continue };
            total += held.ticks;
            if total > MOST_TICKS {
                let found = tr!("{total} ticks up to here", total);
                problems.push(row.problem("ticks", found, tr!("at most {most} in all", most = MOST_TICKS)));
                break;
            }
            inputs.rows.push(held);
        }
        if problems.is_empty() { Ok(inputs) } else { Err(BadFile(problems)) }
    }

    pub fn record(&mut self, controls: Controls) {
        self.hold(controls, 1);
    }

    pub fn hold(&mut self, controls: Controls, ticks: u64) {
        match self.rows.last_mut() {
            Some(row) if row.controls == controls => row.ticks += ticks,
            _ => self.rows.push(HeldKeys { ticks, controls }),
        }
    }

    pub fn rows(&self) -> impl Iterator<Item = (Controls, u64)> + '_ {
        self.rows.iter().map(|row| (row.controls, row.ticks))
    }

    pub fn after(&self, ticks: u64) -> impl Iterator<Item = Controls> + '_ {
        let mut before = ticks;
        self.rows.iter().flat_map(move |row| {
            let passed = before.min(row.ticks);
            before -= passed;
            (passed..row.ticks).map(|_| row.controls)
        })
    }

    /// Ticks before the first one with a key; `None` where no tick has one.
    pub fn idle(&self) -> Option<u64> {
        let begins = self.rows.iter().position(|row| row.controls != Controls::default())?;
        Some(self.rows[..begins].iter().map(|row| row.ticks).sum())
    }

    pub fn ticks(&self) -> u64 {
        self.rows.iter().map(|row| row.ticks).sum()
    }
}

impl fmt::Display for Inputs {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut writer = WriterBuilder::new().has_headers(false).from_writer(Vec::new());
        self.rows.iter().try_for_each(|row| writer.serialize(row)).map_err(|_| fmt::Error)?;
        let rows = writer.into_inner().map_err(|_| fmt::Error)?;
        writeln!(f, "{HEADER}")?;
        f.write_str(&String::from_utf8_lossy(&rows))
    }
}

impl IntoIterator for Inputs {
    type Item = Controls;
    type IntoIter = Playback;

    fn into_iter(self) -> Playback {
        Playback { rows: self.rows.into_iter(), row: HeldKeys { ticks: 0, controls: Controls::default() } }
    }
}

#[derive(Clone, Debug)]
pub struct Playback {
    rows: std::vec::IntoIter<HeldKeys>,
    row: HeldKeys,
}

impl Iterator for Playback {
    type Item = Controls;

    fn next(&mut self) -> Option<Controls> {
        if self.row.ticks == 0 {
            self.row = self.rows.next()?;
        }
        self.row.ticks -= 1;
        Some(self.row.controls)
    }
}

fn held(row: &CsvRow<'_>, columns: &[&str], problems: &mut Vec<String>) -> Option<HeldKeys> {
    let last = columns.len() - 1;
    if let Some(fault) = row.fault() {
        let (found, expected) = fault.words();
        problems.push(row.row_problem(found, expected));
        return None;
    }
    if row.used() != columns.len() {
        let expected = tr!("{count} cells for {header}", count = columns.len(), header = HEADER);
        problems.push(row.problem(columns[row.used().min(last)], tr!("{count} cells in the row", count = row.used()), expected));
        return None;
    }
    let InputRow { ticks, thrust, reverse, left, right } = row
        .read()
        .map_err(|wrong| {
            problems.extend(wrong.into_iter().map(|BadCell { column, found, expected }| row.problem(column, found, expected)));
        })
        .ok()?;
    Some(HeldKeys { ticks, controls: Controls { thrust, reverse, left, right } })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use proptest::test_runner::FileFailurePersistence;

    fn problems(text: &str) -> Vec<String> {
        Inputs::parse("in.csv", text).unwrap_err().0
    }

    #[test]
    fn people_write_it() {
        let text = "\u{feff}# how to fly\r\n\r\nticks, thrust,reverse,left,right\r\n  # up\r\n 2 ,1,0, 0,0\r\n\r\n1,0,1,1,1,,\r\n";
        let up = Controls { thrust: true, ..Controls::default() };
        let rest = Controls { thrust: false, reverse: true, left: true, right: true };
        let inputs = Inputs::parse("in.csv", text).unwrap();
        assert_eq!(inputs.ticks(), 3);
        assert_eq!(inputs.into_iter().collect::<Vec<_>>(), [up, up, rest]);
        assert_eq!(Inputs::parse("in.csv", HEADER).unwrap(), Inputs::default());
    }

    #[test]
    fn every_problem_is_told_with_its_place() {
        let text = format!("# a flight\r\n{HEADER}\r\n\r\n0,0,0,0,0\r\n1.5,0,0,0,2\r\n5,1,0,0\r\n5,1,0,0,0,0\r\n-1,,0,0,0\r\n");
        assert_eq!(
            problems(&text),
            [
                r#"in.csv:4: column "ticks": found "0", expected a whole number from 1 to 1000000000"#,
                r#"in.csv:5: column "ticks": found "1.5", expected a whole number from 1 to 1000000000"#,
                r#"in.csv:5: column "right": found "2", expected 0 or 1"#,
                r#"in.csv:6: column "right": found 4 cells in the row, expected 5 cells for ticks,thrust,reverse,left,right"#,
                r#"in.csv:7: column "right": found 6 cells in the row, expected 5 cells for ticks,thrust,reverse,left,right"#,
                r#"in.csv:8: column "ticks": found "-1", expected a whole number from 1 to 1000000000"#,
                r#"in.csv:8: column "thrust": found "", expected 0 or 1"#,
            ]
        );
    }

    #[test]
    fn the_header_is_asked_for() {
        assert_eq!(
            problems("\n# note\n5,1,0,0,0\n"),
            [r#"in.csv:3: column "ticks": found "5,1,0,0,0", expected the header ticks,thrust,reverse,left,right"#]
        );
        assert_eq!(
            problems(""),
            [r#"in.csv:1: column "ticks": found nothing, expected the header ticks,thrust,reverse,left,right"#]
        );
    }

    #[test]
    fn no_more_problems_are_told_than_anyone_reads() {
        let found = problems(&format!("{HEADER}\n{}", "x\n".repeat(2 * MOST_PROBLEMS)));
        assert_eq!(found.len(), MOST_PROBLEMS + 1);
        let last = r#"in.csv:1002: column "ticks": found more problems from here on, expected at most 1000 in a file"#;
        assert_eq!(found[MOST_PROBLEMS], last);
    }

    #[test]
    fn too_many_ticks_are_refused() {
        let found = problems(&format!("{HEADER}\n1000000000,0,0,0,0\n1,0,0,0,0\n"));
        assert_eq!(found, [r#"in.csv:3: column "ticks": found 1000000001 ticks up to here, expected at most 1000000000 in all"#]);
        assert_eq!(problems(&format!("{HEADER}\n99999999999999999999,0,0,0,0\n")).len(), 1);
    }

    proptest! {
        #![proptest_config(ProptestConfig {
            failure_persistence: Some(Box::new(FileFailurePersistence::WithSource("proptest-regressions"))),
            ..ProptestConfig::default()
        })]

        #[test]
        fn what_is_recorded_reads_back(keys in proptest::collection::vec(0_u8..16, 0..100)) {
            let controls = |bits: &u8| Controls {
                thrust: bits & 1 > 0, reverse: bits & 2 > 0, left: bits & 4 > 0, right: bits & 8 > 0,
            };
            let mut recorded = Inputs::default();
            keys.iter().for_each(|bits| recorded.record(controls(bits)));
            let read = Inputs::parse("in.csv", &recorded.to_string()).unwrap();
            prop_assert_eq!(&read, &recorded);
            prop_assert!(read.into_iter().eq(keys.iter().map(controls)));
        }
    }

    #[test]
    fn inputs_are_the_same_whatever_spreadsheet_saved_them() {
        let plain = "# keys,of,ann,,\nticks,thrust,reverse,left,right\n60,1,0,0,0\n15,1,0,0,1\n";
        let inputs = Inputs::parse("i.csv", plain).unwrap();
        for saved in crate::spreadsheets::saved(plain, |_| false) {
            let text = crate::files::Encoding::text(&saved.bytes).unwrap();
            assert_eq!(Inputs::parse("i.csv", &text).as_ref(), Ok(&inputs), "{}", saved.form);
        }
        let german = "ticks;thrust;reverse;left;right\r\n60,0;1;0;0;0\r\n15;1,0;0;0;1.0\r\n";
        assert_eq!(Inputs::parse("i.csv", german), Ok(inputs));
        let refused = Inputs::parse("i.csv", "ticks;thrust;reverse;left;right\n0,5;2;0;0;0\n").unwrap_err().0;
        assert_eq!(
            refused,
            [
                "i.csv:2: column \"ticks\": found \"0,5\", expected a whole number from 1 to 1000000000",
                "i.csv:2: column \"thrust\": found \"2\", expected 0 or 1",
            ]
        );
    }
}
