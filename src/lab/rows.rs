//! Rows of numbers and words under a head, as CSV and back. Numbers are in the shortest form that reads back as the same f64. What
//! cannot be read is told by file, line and column.

use super::curve::NUMBERS;
use csv::{ReaderBuilder, StringRecord, WriterBuilder};

/// The most rows of a file below its head. With more points a diagram takes longer to draw than a frame lasts.
const MOST_ROWS: usize = 2000;

/// The shortest text that reads back as the same number.
pub(super) fn shortest(value: f64) -> String {
    format!("{value:e}")
}

/// Rows under a head as CSV.
pub(super) fn table(head: &[&str], rows: impl IntoIterator<Item = Vec<String>>) -> String {
    let mut writer = WriterBuilder::new().from_writer(Vec::new());
    // Memory takes all that is written to it, and every row has the head's length.
    let _ = writer.write_record(head);
    for row in rows {
        let _ = writer.write_record(row);
    }
    writer.into_inner().ok().and_then(|bytes| String::from_utf8(bytes).ok()).unwrap_or_default()
}

/// A row with where it stands.
pub(super) struct Row<'a> {
    file: &'a str,
    /// From 1.
    pub line: usize,
    head: &'a [&'a str],
    cells: StringRecord,
}

impl Row<'_> {
    /// What a cell says.
    pub fn word(&self, column: usize) -> String {
        self.cells[column].to_owned()
    }

    /// A number that is good, or else the problem with what was wanted.
    pub fn number(&self, column: usize, wanted: &str, good: impl Fn(f64) -> bool) -> Result<f64, String> {
        let number = self.cells[column].parse::<f64>().ok().filter(|value| good(*value));
        number.ok_or_else(|| self.problem(column, wanted))
    }

    /// A number within [`NUMBERS`].
    pub fn above_zero(&self, column: usize) -> Result<f64, String> {
        let (least, most) = (NUMBERS.start(), NUMBERS.end());
        let wanted = format!("a number above 0, from {least:e} to {most:e}");
        self.number(column, &wanted, |value| NUMBERS.contains(&value))
    }

    /// An error: 0 or more, infinite, or not a number where a run blew up.
    pub fn error(&self, column: usize) -> Result<f64, String> {
        self.number(column, "an error of 0 or more, inf or NaN", |error| error.is_nan() || error >= 0.0)
    }

    /// `true` or `false`.
    pub fn flag(&self, column: usize) -> Result<bool, String> {
        self.cells[column].parse().map_err(|_| self.problem(column, "true or false"))
    }

    /// What is wrong with a cell, and where.
    pub fn problem(&self, column: usize, wanted: &str) -> String {
        let (file, line, name, found) = (self.file, self.line, self.head[column], &self.cells[column]);
        format!("{file}:{line}: column \"{name}\": found \"{found}\", expected {wanted}")
    }
}

/// The rows of a file below its head, each as long as that.
///
/// # Errors
/// The first problem, with its line.
pub(super) fn rows<'a>(file: &'a str, text: &str, head: &'a [&'a str]) -> Result<Vec<Row<'a>>, String> {
    let mut rows = Vec::new();
    let mut reader = ReaderBuilder::new().has_headers(false).flexible(true).from_reader(text.as_bytes());
    // Where the last record began, and on which line.
    let (mut at, mut line) = (0, 1);
    for (index, cells) in reader.records().enumerate() {
        let cells = cells.map_err(|error| format!("{file}: {error}"))?;
        let begins = begin_of(text, cells.position().map_or(0, |position| position.byte() as usize));
        line += text.as_bytes()[at..begins.max(at)].iter().filter(|&&byte| byte == b'\n').count();
        at = begins.max(at);
        if index > MOST_ROWS {
            return Err(format!("{file}:{line}: found a row more, expected at most {MOST_ROWS} below the head"));
        }
        if index == 0 {
            if !cells.iter().eq(head.iter().copied()) {
                let found = cells.iter().collect::<Vec<_>>().join(",");
                return Err(format!("{file}:{line}: found \"{found}\", expected the head {}", head.join(",")));
            }
            continue;
        }
        if cells.len() != head.len() {
            return Err(format!("{file}:{line}: found {} cells, expected {}: {}", cells.len(), head.len(), head.join(",")));
        }
        rows.push(Row { file, line, head, cells });
    }
    if text.trim().is_empty() { Err(format!("{file}: found nothing, expected the head {}", head.join(","))) } else { Ok(rows) }
}

/// The first byte of a record that begins at that byte, blank lines before it left out.
fn begin_of(text: &str, byte: usize) -> usize {
    let rest = text.get(byte..).unwrap_or_default();
    text.len() - rest.trim_start_matches(['\r', '\n']).len()
}
