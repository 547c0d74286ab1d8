//! The rows of a CSV file, each with the line on which it begins as an editor counts it.
//!
//! The `csv` crate cuts a row into cells. This file finds where a row begins and ends: the crate's line numbers are off after CRLF and
//! blank lines, and one quotation mark without a second one would swallow all rows behind it.

use csv::StringRecord;
use std::fmt::Display;
use std::str::FromStr;

/// A byte-order mark, which some editors put in front of UTF-8.
const BYTE_ORDER_MARK: &[u8] = b"\xEF\xBB\xBF";

/// A kind of CSV file: the columns that it has, and its name in messages.
#[derive(Clone, Copy, Debug)]
pub struct CsvFile<'a> {
    /// The file's name in messages.
    pub name: &'a str,
    /// The columns' names, from the first on.
    pub columns: &'a [&'a str],
    /// Whether a line that begins with `#` is a comment.
    pub comments: bool,
}

/// Why a row has no cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RowFault {
    /// The file ends inside quotes that begin in the row. Only the row's first line is given up.
    Unclosed,
    /// Its bytes are no UTF-8.
    NotText,
}

/// A row that holds something, the header among them.
#[derive(Clone, Debug)]
pub struct CsvRow<'a> {
    file: CsvFile<'a>,
    /// The line on which it begins, from 1.
    pub line: usize,
    /// All cells as they stand in the file, or why there are none.
    pub cells: Result<StringRecord, RowFault>,
}

impl RowFault {
    /// Words for the row as it was found, and for the expected one.
    pub const fn words(self) -> (&'static str, &'static str) {
        match self {
            Self::Unclosed => ("a quotation mark that is never closed", "a second one at the end of its cell"),
            Self::NotText => ("bytes that are no text", "UTF-8"),
        }
    }
}

impl<'a> CsvFile<'a> {
    /// The rows of a file's content. Lines end with LF, CRLF or CR; a byte-order mark, blank lines and rows of empty cells are passed
    /// over.
    pub fn rows(self, bytes: &[u8]) -> impl Iterator<Item = CsvRow<'a>> + use<'a> {
        let (sound, lines) = cut(bytes, self.comments);
        let reader = csv::ReaderBuilder::new().has_headers(false).flexible(true).from_reader(std::io::Cursor::new(sound));
        let mut records = reader.into_records();
        let rows = lines.into_iter().map(move |(line, fault)| {
            let mut record = || records.next().and_then(Result::ok).ok_or(RowFault::NotText);
            CsvRow { file: self, line, cells: fault.map_or_else(&mut record, Err) }
        });
        rows.filter(|row| row.cells.is_err() || !row.is_empty())
    }

    /// The columns' names as the header that a message expects.
    pub fn header(&self) -> String {
        self.columns.join(",")
    }
}

impl CsvRow<'_> {
    /// The number of cells, without empty ones at the row's end.
    pub fn len(&self) -> usize {
        let full = self.cells.iter().flatten().zip(1..).filter(|(cell, _)| !cell.trim().is_empty());
        full.map(|(_, number)| number).last().unwrap_or(0)
    }

    /// Whether there is no cell but empty ones.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// A cell without the spaces around it; empty where the row is shorter.
    pub fn get(&self, column: &str) -> &str {
        let index = self.file.columns.iter().position(|name| *name == column);
        index.and_then(|index| self.cells.as_ref().ok()?.get(index)).map_or("", str::trim)
    }

    /// Whether the first cells name the first columns, `least` of them or more, in any case.
    pub fn is_header(&self, least: usize) -> bool {
        let Ok(cells) = &self.cells else { return false };
        self.len() >= least && cells.iter().zip(self.file.columns).all(|(cell, name)| cell.trim().eq_ignore_ascii_case(name))
    }

    /// All cells with commas between them, as a message quotes them.
    pub fn joined(&self) -> String {
        let cells: Vec<&str> = self.cells.iter().flatten().map(str::trim).take(self.len()).collect();
        cells.join(",")
    }

    /// A cell as a number or another value that is good.
    ///
    /// # Errors
    /// [`CsvRow::problem`] with what is expected.
    pub fn parse<T: FromStr>(&self, column: &str, expected: &str, good: impl FnOnce(&T) -> bool) -> Result<T, String> {
        self.get(column).parse().ok().filter(good).ok_or_else(|| self.bad_cell(column, expected))
    }

    /// A key or a switch, 0 or 1.
    ///
    /// # Errors
    /// [`CsvRow::problem`].
    pub fn bit(&self, column: &str) -> Result<bool, String> {
        self.parse(column, "0 or 1", |bit: &u8| *bit < 2 && self.get(column).len() == 1).map(|bit| bit == 1)
    }

    /// [`CsvRow::problem`] with the cell that was found.
    pub fn bad_cell(&self, column: &str, expected: impl Display) -> String {
        self.problem(column, format_args!("{:?}", self.get(column)), expected)
    }

    /// The message about one cell: `file:line: column "name": found …, expected …`.
    pub fn problem(&self, column: &str, found: impl Display, expected: impl Display) -> String {
        format!("{}:{}: column {column:?}: found {found}, expected {expected}", self.file.name, self.line)
    }

    /// The message about the whole row: `file:line: found …, expected …`.
    pub fn row_problem(&self, found: impl Display, expected: impl Display) -> String {
        format!("{}:{}: found {found}, expected {expected}", self.file.name, self.line)
    }
}

/// Rows of one length as the text of a CSV file.
pub fn csv_text<R: IntoIterator<Item: AsRef<[u8]>>>(rows: impl IntoIterator<Item = R>) -> String {
    let mut writer = csv::WriterBuilder::new().has_headers(false).from_writer(Vec::new());
    // Memory takes all that is written to it.
    rows.into_iter().for_each(|row| drop(writer.write_record(row)));
    writer.into_inner().ok().and_then(|bytes| String::from_utf8(bytes).ok()).unwrap_or_default()
}

/// The sound rows of a file, each ended by LF, and for every row that is not blank its line and why it has no cells.
fn cut(bytes: &[u8], comments: bool) -> (Vec<u8>, Vec<(usize, Option<RowFault>)>) {
    let mut rest = bytes.strip_prefix(BYTE_ORDER_MARK).unwrap_or(bytes);
    let (mut line, mut unclosed) = (1, false);
    let (mut sound, mut found) = (Vec::with_capacity(rest.len()), Vec::new());
    while !rest.is_empty() {
        let first_line = line_end(rest);
        let comment = comments && rest[..first_line].trim_ascii_start().starts_with(b"#");
        let end = if comment { Some(first_line) } else { row_end(rest, unclosed) };
        unclosed |= end.is_none();
        let row = &rest[..end.unwrap_or(first_line)];
        let text = row.strip_suffix(b"\n").unwrap_or(row);
        let text = text.strip_suffix(b"\r").unwrap_or(text);
        if end.is_none() {
            found.push((line, Some(RowFault::Unclosed)));
        } else if !comment && str::from_utf8(text).is_err() {
            found.push((line, Some(RowFault::NotText)));
        } else if !comment && !text.trim_ascii().is_empty() {
            found.push((line, None));
            sound.extend_from_slice(text);
            sound.push(b'\n');
        }
        line += line_count(row);
        rest = &rest[row.len()..];
    }
    (sound, found)
}

/// Where the first row of `bytes` ends, its line end included; `None` when a quotation mark in it is never closed.
///
/// `unclosed` says that an earlier row was of that kind. That row is within quotes at each line end up to the file's end, and a row that
/// is within quotes at one of them goes on like it. So no row is followed beyond its line, and reading takes time in proportion to the
/// file's length.
fn row_end(bytes: &[u8], unclosed: bool) -> Option<usize> {
    let (mut quoted, mut may_open) = (false, true);
    for (index, byte) in bytes.iter().enumerate() {
        match byte {
            b'"' if quoted => (quoted, may_open) = (false, true), // one right behind it opens again: a doubled mark is one mark
            b'"' if may_open => quoted = true,
            b'\r' | b'\n' if quoted && unclosed => return None,
            b'\r' | b'\n' if !quoted => return Some(index + line_end(&bytes[index..])),
            byte => may_open = *byte == b',',
        }
    }
    (!quoted).then_some(bytes.len())
}

/// The length of the first line of `bytes` with its end: LF, CRLF or a CR alone.
fn line_end(bytes: &[u8]) -> usize {
    match bytes.iter().position(|&byte| byte == b'\r' || byte == b'\n') {
        Some(index) if bytes[index..].starts_with(b"\r\n") => index + 2,
        Some(index) => index + 1,
        None => bytes.len(),
    }
}

/// The number of lines in `bytes`.
fn line_count(mut bytes: &[u8]) -> usize {
    let mut count = 0;
    while !bytes.is_empty() {
        bytes = &bytes[line_end(bytes)..];
        count += 1;
    }
    count
}

#[cfg(test)]
mod tests {
    use super::*;

    const FILE: CsvFile<'_> = CsvFile { name: "a.csv", columns: &["name", "ticks"], comments: true };

    #[test]
    fn a_cell_is_read_by_its_column_and_a_message_names_its_place() {
        let text = "\u{feff}# a note, \"\r\n\r\nName , TICKS,\r\n  # another\n \" ann\na, 5\r,,\r\nbob,\"x";
        let rows: Vec<CsvRow<'_>> = FILE.rows(text.as_bytes()).collect();
        assert_eq!(rows.iter().map(|row| (row.line, row.len())).collect::<Vec<_>>(), [(3, 2), (5, 1), (6, 2), (8, 0)]);
        let [header, cut_in_two, ann, bob] = &rows[..] else { panic!("four rows") };
        assert!(header.is_header(2) && !header.is_header(3) && !ann.is_header(1));
        assert_eq!((cut_in_two.get("name"), cut_in_two.get("ticks")), ("\" ann", ""), "a mark behind a space opens nothing");
        assert_eq!(ann.parse::<u8>("ticks", "a number", |_| true), Ok(5));
        assert_eq!(ann.bit("ticks"), Err("a.csv:6: column \"ticks\": found \"5\", expected 0 or 1".to_owned()));
        assert_eq!((ann.joined(), bob.cells.clone()), ("a,5".to_owned(), Err(RowFault::Unclosed)));
    }

    proptest::proptest! {
        /// The crate sees as many rows as were cut here, and each has the cells that it has alone.
        #[test]
        fn rows_are_those_of_the_csv_crate(text in "([a\", \r\n]|\"\"){0,16}") {
            let rows: Vec<CsvRow<'_>> = CsvFile { comments: false, ..FILE }.rows(text.as_bytes()).collect();
            for row in &rows {
                proptest::prop_assert!(row.cells != Err(RowFault::NotText), "{text:?}");
            }
            if rows.iter().all(|row| row.cells.is_ok()) {
                let mut reader = csv::ReaderBuilder::new().has_headers(false).flexible(true).from_reader(text.as_bytes());
                let full = |record: &StringRecord| record.iter().any(|cell| !cell.trim().is_empty());
                let theirs = reader.records().map(Result::unwrap).filter(full);
                proptest::prop_assert!(rows.into_iter().filter_map(|row| row.cells.ok()).eq(theirs), "{text:?}");
            }
        }
    }
}
