//! The rows of a CSV file by the names of their columns, and messages that name file, line and column.

use super::cells::{self, Cell, CellFault, CsvRows, SpannedRow, csv_line};
use super::dialect::{Dialect, said, whole};
use crate::words::tr;
use csv::StringRecord;
use serde::de::DeserializeOwned;
use std::{borrow::Cow, fmt::Display, str::FromStr};

#[derive(Clone, Copy, Debug)]
pub struct CsvFile<'a> {
    /// In messages.
    pub name: &'a str,
    pub columns: &'a [&'a str],
    /// Whether a line that begins with `#` is a comment.
    pub comments: bool,
}

/// A row that is not blank, the header among them.
#[derive(Clone, Debug)]
pub struct CsvRow<'a> {
    file: CsvFile<'a>,
    dialect: Dialect,
    /// The first line, from 1.
    pub line: usize,
    pub cells: Vec<Cell>,
}

/// A struct with a field for each of the first columns of a file, in their order.
pub trait CsvStruct: DeserializeOwned {
    const COLUMNS: &'static [CsvColumn];
}

pub struct CsvColumn {
    pub name: &'static str,
    /// A cell as serde reads it, or what is expected in its place.
    pub plain: fn(Dialect, &str) -> Result<Cow<'_, str>, String>,
}

#[derive(Debug)]
pub struct BadCell {
    pub column: &'static str,
    pub found: String,
    pub expected: String,
}

impl<'a> CsvFile<'a> {
    pub fn rows<'b>(self, bytes: &'b [u8]) -> impl Iterator<Item = CsvRow<'a>> + use<'a, 'b> {
        self.in_dialect(self.spanned(bytes, |_| false))
    }

    /// As [`CsvFile::rows`], of a file that may lack its header: its separator shows in rows that are structs.
    pub fn rows_of<'b, T: CsvStruct>(self, bytes: &'b [u8]) -> impl Iterator<Item = CsvRow<'a>> + use<'a, 'b, T> {
        self.in_dialect(self.spanned(bytes, |row| row.read::<T>().is_ok()))
    }

    fn in_dialect(self, rows: CsvRows) -> impl Iterator<Item = CsvRow<'a>> {
        let dialect = rows.dialect;
        rows.map(move |row| self.row(dialect, row))
    }

    /// A text with plain commas between its cells; blank lines and comments stay as they are.
    pub fn with_commas<T: CsvStruct>(self, text: &str) -> String {
        let rows = self.spanned(text.as_bytes(), |row| row.read::<T>().is_ok());
        let (mut at, mut plain) = (said(text).map_or(0, |(_, length)| length), String::new());
        if at == 0 && rows.dialect.delimiter == Dialect::PLAIN.delimiter {
            return text.to_owned();
        }
        for SpannedRow { cells, span, .. } in rows {
            plain += &text[at..span.start];
            plain += &csv_line(cells.iter().map(|cell| cell.text.trim()));
            at = span.end;
        }
        plain + &text[at..]
    }

    fn spanned<F: Fn(&CsvRow<'_>) -> bool>(self, bytes: &[u8], is_good: F) -> CsvRows {
        let suits = |dialect, rows: &[SpannedRow]| {
            let row = |row: &SpannedRow| self.row(dialect, row.clone());
            let named = rows.first().map_or(0, |header| row(header).named());
            let good = rows.iter().filter(|of| is_good(&row(of))).count();
            let cells: usize = rows.iter().map(|row| row.cells.len().min(self.columns.len())).sum();
            // Names and good rows count more than any number of cells.
            ((named + good) * (rows.len() + 1) * self.columns.len() + cells) as i64
        };
        cells::rows(bytes, self.comments, self.columns.len(), &suits)
    }

    fn row(self, dialect: Dialect, row: SpannedRow) -> CsvRow<'a> {
        CsvRow { file: self, dialect, line: row.line, cells: row.cells }
    }

    pub fn header(&self) -> String {
        self.columns.join(",")
    }
}

impl CsvRow<'_> {
    /// Text behind a closing quote belongs to its cell.
    pub fn fault(&self) -> Option<CellFault> {
        self.cells.iter().filter_map(|cell| cell.fault).find(|fault| *fault != CellFault::AfterQuote)
    }

    /// Without empty cells at the row's end.
    pub fn used(&self) -> usize {
        self.cells.iter().rposition(|cell| !cell.text.trim().is_empty()).map_or(0, |last| last + 1)
    }

    /// Without spaces around it; empty where the row is shorter.
    pub fn get(&self, column: &str) -> &str {
        let index = self.file.columns.iter().position(|name| *name == column);
        index.and_then(|index| self.cells.get(index)).map_or("", |cell| cell.text.trim())
    }

    /// Whether the first cells name the first columns, at least `least` of them, in any case of the letters.
    pub fn is_header(&self, least: usize) -> bool {
        let mut cells = self.cells.iter().zip(self.file.columns);
        self.used() >= least && cells.all(|(cell, name)| cell.text.trim().eq_ignore_ascii_case(name))
    }

    /// How many cells name the column of their place.
    fn named(&self) -> usize {
        let pairs = self.cells.iter().zip(self.file.columns);
        pairs.filter(|(cell, name)| cell.text.trim().eq_ignore_ascii_case(name)).count()
    }

    /// With commas between, as in a message.
    pub fn joined(&self) -> String {
        self.cells[..self.used()].iter().map(|cell| cell.text.trim()).collect::<Vec<_>>().join(",")
    }

    /// The error is [`CsvRow::problem`].
    pub fn parse<T: FromStr>(&self, column: &str, expected: &str, good: impl FnOnce(&T) -> bool) -> Result<T, String> {
        let number = self.dialect.number(self.get(column));
        let parsed = number.parse().or_else(|_| whole(&number).parse());
        parsed.ok().filter(good).ok_or_else(|| self.bad_cell(column, expected))
    }

    /// Errors: every wrong cell.
    pub fn read<T: CsvStruct>(&self) -> Result<T, Vec<BadCell>> {
        let (mut record, mut wrong) = (StringRecord::new(), Vec::new());
        for (index, column) in T::COLUMNS.iter().enumerate() {
            let text = self.cells.get(index).map_or("", |cell| cell.text.trim());
            match (column.plain)(self.dialect, text) {
                Ok(plain) => record.push_field(&plain),
                Err(expected) => wrong.push(BadCell { column: column.name, found: format!("{text:?}"), expected }),
            }
        }
        if !wrong.is_empty() {
            return Err(wrong);
        }
        // Of good cells serde refuses none; whatever it does refuse has a message.
        let (column, expected) = (T::COLUMNS[0].name, self.file.header());
        record.deserialize(None).map_err(|error| vec![BadCell { column, found: error.to_string(), expected }])
    }

    /// As messages, a line each.
    pub fn problems(&self, wrong: Vec<BadCell>) -> String {
        let problems = wrong.into_iter().map(|BadCell { column, found, expected }| self.problem(column, found, expected));
        problems.collect::<Vec<_>>().join("\n")
    }

    /// 0 or 1; the error is [`CsvRow::problem`].
    pub fn bit(&self, column: &str) -> Result<bool, String> {
        match whole(&self.dialect.number(self.get(column))) {
            "0" => Ok(false),
            "1" => Ok(true),
            _ => Err(self.bad_cell(column, tr("0 or 1"))),
        }
    }

    pub fn bad_cell(&self, column: &str, expected: impl Display) -> String {
        self.problem(column, format_args!("{:?}", self.get(column)), expected)
    }

    /// `file:line: column "name": found …, expected …`.
    pub fn problem(&self, column: &str, found: impl Display, expected: impl Display) -> String {
        found_instead(&place(self.file.name, self.line, column), found, expected)
    }

    /// `file:line: found …, expected …`.
    pub fn row_problem(&self, found: impl Display, expected: impl Display) -> String {
        found_instead(&format!("{}:{}", self.file.name, self.line), found, expected)
    }
}

/// The place of a cell in a message: `file:line: column "name"`.
pub fn place(file: impl Display, line: usize, column: &str) -> String {
    tr!("{file}:{line}: column {column}", file, line, column = format_args!("{column:?}"))
}

pub fn found_instead(place: &str, found: impl Display, expected: impl Display) -> String {
    tr!("{place}: found {found}, expected {expected}", place, found, expected)
}

#[cfg(test)]
mod tests {
    use super::*;

    const FILE: CsvFile<'_> = CsvFile { name: "a.csv", columns: &["name", "ticks"], comments: true };

    #[test]
    fn a_cell_is_read_by_its_column_and_a_message_names_its_place() {
        let text = "\u{feff}# a note, \"\r\n\r\nName , TICKS,\r\n  # another\n \"ann\" , 5\r,,\r\nbob,\"x";
        let rows: Vec<CsvRow<'_>> = FILE.rows(text.as_bytes()).collect();
        assert_eq!(rows.iter().map(|row| (row.line, row.used())).collect::<Vec<_>>(), [(3, 2), (5, 2), (7, 2)]);
        let [header, ann, bob] = &rows[..] else { panic!("three rows") };
        assert!(header.is_header(2) && !header.is_header(3) && !ann.is_header(1));
        assert_eq!(ann.parse::<u8>("ticks", "a number", |_| true), Ok(5));
        assert_eq!(ann.bit("ticks"), Err("a.csv:5: column \"ticks\": found \"5\", expected 0 or 1".to_owned()));
        assert_eq!((ann.joined(), ann.fault(), bob.fault()), ("ann,5".to_owned(), None, Some(CellFault::Unclosed)));
    }

    proptest::proptest! {
        /// Of texts without spaces, the crate misses a quoted cell behind one.
        #[test]
        fn rows_are_those_of_the_csv_crate(text in "([a\",\r\n]|\"\"){0,16}") {
            let rows: Vec<CsvRow<'_>> = CsvFile { comments: false, ..FILE }.rows(text.as_bytes()).collect();
            if rows.iter().any(|row| row.fault().is_some()) {
                return Ok(());
            }
            let mut reader = csv::ReaderBuilder::new().has_headers(false).flexible(true).from_reader(text.as_bytes());
            let full = |record: &csv::StringRecord| record.iter().any(|cell| !cell.trim().is_empty());
            let theirs = reader.records().map(Result::unwrap).filter(full);
            let ours = rows.iter().map(|row| row.cells.iter().map(|cell| cell.text.as_str()).collect::<csv::StringRecord>());
            proptest::prop_assert!(ours.eq(theirs), "{text:?}");
        }
    }
}
