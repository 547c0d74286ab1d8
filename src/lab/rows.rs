//! Rows of numbers and words under a head, as CSV and back. Numbers are in the shortest form that reads back as the same f64. A
//! refusal names file, line and column.

use super::curve::{NUMBERS, WorkPoint};
use crate::files::{CsvFile, CsvRow, csv_line};

/// The most rows of a file below its head. With more points a diagram takes longer to draw than a frame lasts.
const MOST_ROWS: usize = 2000;

/// The shortest text that reads back as the same number.
pub(super) fn shortest(value: f64) -> String {
    format!("{value:e}")
}

pub(super) fn table(head: &[&str], rows: impl IntoIterator<Item = Vec<String>>) -> String {
    csv_line(head) + &rows.into_iter().map(csv_line).collect::<String>()
}

/// # Errors
/// The number is not within [`NUMBERS`].
pub(super) fn above_zero(row: &CsvRow<'_>, column: &str) -> Result<f64, String> {
    let expected = format!("a number above 0, from {:e} to {:e}", NUMBERS.start(), NUMBERS.end());
    row.parse(column, &expected, |value| NUMBERS.contains(value))
}

/// An error of a run: 0 or more, infinite, or not a number where the run blew up.
///
/// # Errors
/// Anything else.
pub(super) fn error(row: &CsvRow<'_>) -> Result<f64, String> {
    row.parse("error", "an error of 0 or more, inf or NaN", |error: &f64| error.is_nan() || *error >= 0.0)
}

/// # Errors
/// A number that is none.
pub(super) fn not_negative(row: &CsvRow<'_>, column: &str) -> Result<f64, String> {
    row.parse(column, "a number of 0 or more", |value: &f64| value.is_finite() && *value >= 0.0)
}

/// The columns of a measured point.
///
/// # Errors
/// The first number that cannot be.
pub(super) fn work_point(row: &CsvRow<'_>) -> Result<WorkPoint, String> {
    let (step, work) = (above_zero(row, "step")?, above_zero(row, "work")?);
    Ok(WorkPoint { step, work, spread: not_negative(row, "spread")?, error: error(row)? })
}

/// The rows of a file below its head.
///
/// # Errors
/// The line of the first row that is not as long as the head.
pub(super) fn rows<'a>(file: &'a str, text: &str, head: &'a [&'a str]) -> Result<Vec<CsvRow<'a>>, String> {
    let csv = CsvFile { name: file, columns: head, comments: false };
    let mut rows = csv.rows(text.as_bytes());
    let first = rows.next().ok_or_else(|| format!("{file}: found nothing, expected the head {}", csv.header()))?;
    if !first.is_header(head.len()) {
        return Err(first.row_problem(format_args!("\"{}\"", first.joined()), format_args!("the head {}", csv.header())));
    }
    let checked = (1..).zip(rows).map(|(count, row)| match (row.fault(), row.cells.len()) {
        _ if count > MOST_ROWS => Err(row.row_problem("a row more", format_args!("at most {MOST_ROWS} below the head"))),
        (Some(fault), _) => Err(row.row_problem(fault.words().0, fault.words().1)),
        (None, cells) if cells != head.len() => {
            Err(row.row_problem(format_args!("{cells} cells"), format_args!("{}: {}", head.len(), csv.header())))
        }
        (None, _) => Ok(row),
    });
    checked.collect()
}
