//! The rows of a CSV file with their lines as an editor counts them. The `csv` crate only cuts a row into cells: its line numbers
//! are off after CRLF and blank lines, and one unclosed quotation mark would swallow all rows behind it.

use csv::StringRecord;
use std::fmt::Display;
use std::str::FromStr;

/// Some editors put it in front of UTF-8.
const BYTE_ORDER_MARK: &[u8] = b"\xEF\xBB\xBF";

#[derive(Clone, Copy, Debug)]
pub struct CsvFile<'a> {
    /// In messages.
    pub name: &'a str,
    pub columns: &'a [&'a str],
    /// Whether a line that begins with `#` is a comment.
    pub comments: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RowFault {
    /// The file ends inside quotes of the row. Only the row's first line is lost.
    Unclosed,
    /// No UTF-8.
    NotText,
}

/// A row that is not blank, the header among them.
#[derive(Clone, Debug)]
pub struct CsvRow<'a> {
    file: CsvFile<'a>,
    /// The first line, from 1.
    pub line: usize,
    pub cells: Result<StringRecord, RowFault>,
}

impl RowFault {
    /// The found row and the expected one, in words.
    pub const fn words(self) -> (&'static str, &'static str) {
        match self {
            Self::Unclosed => ("a quotation mark that is never closed", "a second one at the end of its cell"),
            Self::NotText => ("bytes that are no text", "UTF-8"),
        }
    }
}

impl<'a> CsvFile<'a> {
    /// Lines end with LF, CRLF or CR; a byte-order mark, blank lines and rows of empty cells are skipped.
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

    /// The expected header in a message.
    pub fn header(&self) -> String {
        self.columns.join(",")
    }
}

impl CsvRow<'_> {
    /// Without empty cells at the row's end.
    pub fn len(&self) -> usize {
        let full = self.cells.iter().flatten().zip(1..).filter(|(cell, _)| !cell.trim().is_empty());
        full.map(|(_, number)| number).last().unwrap_or(0)
    }

    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Without spaces around it; empty where the row is shorter.
    pub fn get(&self, column: &str) -> &str {
        let index = self.file.columns.iter().position(|name| *name == column);
        index.and_then(|index| self.cells.as_ref().ok()?.get(index)).map_or("", str::trim)
    }

    /// Whether the first cells name the first columns, at least `least` of them, in any case of the letters.
    pub fn is_header(&self, least: usize) -> bool {
        let Ok(cells) = &self.cells else { return false };
        self.len() >= least && cells.iter().zip(self.file.columns).all(|(cell, name)| cell.trim().eq_ignore_ascii_case(name))
    }

    /// With commas between, as in a message.
    pub fn joined(&self) -> String {
        let cells: Vec<&str> = self.cells.iter().flatten().map(str::trim).take(self.len()).collect();
        cells.join(",")
    }

    /// The error is [`CsvRow::problem`].
    pub fn parse<T: FromStr>(&self, column: &str, expected: &str, good: impl FnOnce(&T) -> bool) -> Result<T, String> {
        self.get(column).parse().ok().filter(good).ok_or_else(|| self.bad_cell(column, expected))
    }

    /// 0 or 1; the error is [`CsvRow::problem`].
    pub fn bit(&self, column: &str) -> Result<bool, String> {
        self.parse(column, "0 or 1", |bit: &u8| *bit < 2 && self.get(column).len() == 1).map(|bit| bit == 1)
    }

    pub fn bad_cell(&self, column: &str, expected: impl Display) -> String {
        self.problem(column, format_args!("{:?}", self.get(column)), expected)
    }

    /// `file:line: column "name": found …, expected …`.
    pub fn problem(&self, column: &str, found: impl Display, expected: impl Display) -> String {
        format!("{}:{}: column {column:?}: found {found}, expected {expected}", self.file.name, self.line)
    }

    /// `file:line: found …, expected …`.
    pub fn row_problem(&self, found: impl Display, expected: impl Display) -> String {
        format!("{}:{}: found {found}, expected {expected}", self.file.name, self.line)
    }
}

/// The rows have one length.
pub fn csv_text<R: IntoIterator<Item: AsRef<[u8]>>>(rows: impl IntoIterator<Item = R>) -> String {
    let mut writer = csv::WriterBuilder::new().has_headers(false).from_writer(Vec::new());
    // Memory takes all writes.
    rows.into_iter().for_each(|row| drop(writer.write_record(row)));
    writer.into_inner().ok().and_then(|bytes| String::from_utf8(bytes).ok()).unwrap_or_default()
}

/// The sound rows, each ended by LF, and for each row that is not blank its line and its fault.
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

/// The end of the first row of `bytes`, line end included; `None` where a quotation mark in it is never closed. `unclosed` says
/// that an earlier row was of that kind: it is within quotes at each line end up to the file's end, and so is a later row that is
/// within quotes at one of them. No row is followed beyond its line, and reading takes linear time.
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

/// With its end: LF, CRLF or a CR alone.
fn line_end(bytes: &[u8]) -> usize {
    match bytes.iter().position(|&byte| byte == b'\r' || byte == b'\n') {
        Some(index) if bytes[index..].starts_with(b"\r\n") => index + 2,
        Some(index) => index + 1,
        None => bytes.len(),
    }
}

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
        /// The crate sees as many rows as were cut here, each with the same cells as alone.
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
