//! Text to rows of cells through the `csv` crate, each with its place and its line as an editor counts it: the crate's own line numbers are off
//! after CRLF, blank lines and comments, its byte positions are exact. Its readers are kept for the next file: a new one takes some 15 µs.

use super::dialect::{Dialect, Encoding, said};
use crate::words::tr;
use csv::{Position, Reader, ReaderBuilder, StringRecord};
use std::io::{Cursor, SeekFrom};
use std::{borrow::Cow, cell::RefCell, ops::Range};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CellFault {
    /// The file ends within its quotes. The cell ends with its line.
    Unclosed,
    AfterQuote,
    NotUtf8,
    /// UTF-16 without the mark that tells it, or UTF-32.
    Utf16,
    /// The whole file is in a spreadsheet's own format.
    Workbook,
    /// Its first line says another separator than those that are read.
    Separator,
}

impl CellFault {
    /// The found and the expected, in words.
    pub fn words(self) -> (&'static str, &'static str) {
        let utf8 = tr("a file saved as UTF-8 (Excel: Save As, CSV UTF-8; LibreOffice: Save As, Text CSV, character set UTF-8)");
        match self {
            Self::Unclosed => (tr("a quote that is never closed"), tr("a closing quote")),
            Self::AfterQuote => (tr("text after a closing quote"), tr("a comma after it (a quote within quotes is written twice)")),
            Self::NotUtf8 => (tr("letters that are not UTF-8"), utf8),
            Self::Utf16 => (tr("a file saved as UTF-16 without a byte-order mark"), utf8),
            Self::Workbook => (
                tr("a spreadsheet's own file (xlsx, xls, ods, numbers)"),
                tr("a file that the spreadsheet saved as CSV (Excel: Save As, CSV UTF-8; LibreOffice: Save As, Text CSV)"),
            ),
            Self::Separator => (
                tr("another separator in the line sep="),
                tr("cells separated by commas, semicolons or tabs (Excel: Save As, CSV UTF-8; LibreOffice: Save As, Text CSV)"),
            ),
        }
    }
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cell {
    /// Without its quotes; a plain cell with the spaces around it.
    pub text: String,
    pub line: usize,
    /// Its bytes in the text, with its quotes but without the spaces around it.
    pub span: Range<usize>,
    pub fault: Option<CellFault>,
}

impl Cell {
    pub fn is_empty(&self) -> bool {
        self.fault.is_none() && self.text.trim().is_empty()
    }
}

/// A row with at least one cell that is not empty.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SpannedRow {
    pub line: usize,
    pub cells: Vec<Cell>,
    /// Its bytes in the text, with its line end.
    pub span: Range<usize>,
}

/// Row by row: all rows of a long flight at once would fill the memory. Left out are blank lines, rows of empty cells and, with `comments`,
/// rows whose first cell begins with `#`. Lines end with LF, CRLF or CR.
pub struct CsvRows {
    pub dialect: Dialect,
    /// Behind the byte-order mark.
    pub text: String,
    fault: Option<CellFault>,
    /// Some bytes were no text.
    broken: bool,
    comments: bool,
    reader: PooledReader,
    /// Bytes of the text before those of the reader.
    base: usize,
    record: StringRecord,
    /// Bytes before the next row, and the line there.
    at: usize,
    line: usize,
    /// A quote of an earlier row is never closed. From there on no cell spans lines, and reading takes linear time.
    by_line: bool,
}

/// How well the first rows of a file suit it, as they are separated in a dialect.
pub type Suits<'a> = &'a dyn Fn(Dialect, &[SpannedRow]) -> i64;

/// The rows that show how a file is separated, and their bytes, at most.
const SAMPLE_ROWS: usize = 8;
const SAMPLE: usize = 1 << 16;

/// The separator is the one that the file says, else the one that suits best. Where there is but one of `columns`, a cell may hold any sign.
pub fn rows(bytes: &[u8], comments: bool, columns: usize, suits: Suits<'_>) -> CsvRows {
    let (text, encoding, broken) = Encoding::decode(bytes);
    let mut fault = fault_of_file(bytes, &text);
    let (mut delimiter, mut at) = (Dialect::PLAIN.delimiter, 0);
    if let Some((sign, length)) = said(&text) {
        match Dialect::DELIMITERS.into_iter().find(|known| char::from(*known) == sign) {
            Some(known) => (delimiter, at) = (known, length),
            None => fault = fault.or(Some(CellFault::Separator)),
        }
    } else if fault.is_none() && (columns == 1 || text.contains([';', '\t'])) {
        delimiter = best_delimiter(&text, encoding, comments, suits);
    }
    CsvRows { fault, broken, ..CsvRows::new(text, Dialect { delimiter, encoding }, comments, at) }
}

fn best_delimiter(text: &str, encoding: Encoding, comments: bool, suits: Suits<'_>) -> u8 {
    let end = (0..=SAMPLE.min(text.len())).rev().find(|end| text.is_char_boundary(*end)).unwrap_or(0);
    let mut sample = &text[..end];
    if sample.len() < text.len() {
        // A row that is cut shows nothing.
        sample = &sample[..sample.rfind(['\n', '\r']).map_or(sample.len(), |end| end + 1)];
    }
    let suits = |delimiter: &u8| {
        let dialect = Dialect { delimiter: *delimiter, encoding };
        let rows: Vec<SpannedRow> = CsvRows::new(sample.to_owned(), dialect, comments, 0).take(SAMPLE_ROWS).collect();
        std::cmp::Reverse(suits(dialect, &rows))
    };
    Dialect::DELIMITERS.into_iter().min_by_key(suits).unwrap_or(Dialect::PLAIN.delimiter)
}

fn fault_of_file(bytes: &[u8], text: &str) -> Option<CellFault> {
    /// The first bytes of a zipped file, such as a newer spreadsheet's, and of an older one's.
    const WORKBOOKS: [&[u8]; 2] = [b"PK\x03\x04", b"\xD0\xCF\x11\xE0"];
    // Every other byte of plain letters in UTF-16 is 0; a table has none.
    let zeros = text.bytes().filter(|byte| *byte == 0).count();
    if WORKBOOKS.iter().any(|begin| bytes.starts_with(begin)) {
        Some(CellFault::Workbook)
    } else {
        (zeros * 3 > text.len()).then_some(CellFault::Utf16)
    }
}

impl Iterator for CsvRows {
    type Item = SpannedRow;

    fn next(&mut self) -> Option<SpannedRow> {
        if let Some(fault) = self.fault.take() {
            self.at = self.text.len();
            let cell = Cell { text: String::new(), line: 1, span: 0..self.at, fault: Some(fault) };
            return Some(SpannedRow { line: 1, cells: vec![cell], span: 0..self.at });
        }
        loop {
            let row = self.row()?;
            // A spreadsheet puts a comment with a separator in quotes.
            let comment = self.comments && row.cells[0].fault.is_none() && row.cells[0].text.trim_start().starts_with('#');
            if !comment && row.cells.iter().any(|cell| !cell.is_empty()) {
                return Some(row);
            }
        }
    }
}

impl CsvRows {
    fn new(text: String, dialect: Dialect, comments: bool, at: usize) -> Self {
        let (reader, record) = (PooledReader::new(dialect.delimiter, text.as_bytes()), StringRecord::new());
        Self { dialect, text, fault: None, broken: false, comments, reader, base: 0, record, at, line: 1, by_line: false }
    }

    /// The next row, possibly one of empty cells; `None` at the end of the text.
    fn row(&mut self) -> Option<SpannedRow> {
        let begin = self.passed_over();
        self.line += line_ends(&self.text, self.at..begin);
        self.at = begin;
        let rest = &self.text[begin..];
        let whole = (!self.by_line).then(|| bounds(rest, self.dialect.sign())).filter(|row| !row.open);
        self.by_line = whole.is_none();
        let limit = if self.by_line { rest.find(['\n', '\r']).unwrap_or(rest.len()) } else { rest.len() };
        let RowBounds { cells: bounds, end, odd, .. } = whole.unwrap_or_else(|| bounds(&rest[..limit], self.dialect.sign()));
        self.go_to(begin, limit);
        if !self.reader.read(&mut self.record) {
            return None;
        }
        let (rest, line) = (&self.text[begin..], self.line);
        if odd {
            self.record = bounds.iter().map(|cell| cell.text(rest)).collect();
        }
        let end = end + line_end(&rest[end..]);
        let several = rest[..end].trim_end().contains(['\n', '\r']);
        let cell = |(text, CellBounds { span, fault, .. }): (&str, CellBounds)| {
            let span = begin + span.start..begin + span.end;
            let line = if several { line + line_ends(&self.text, begin..span.start) } else { line };
            let spoilt = self.broken && text.contains(char::REPLACEMENT_CHARACTER);
            Cell { text: text.to_owned(), line, span, fault: fault.or(spoilt.then_some(CellFault::NotUtf8)) }
        };
        let cells = self.record.iter().zip(bounds).map(cell).collect();
        let span = begin..begin + end;
        self.line += line_ends(&self.text, span.clone());
        self.at = span.end;
        Some(SpannedRow { line, cells, span })
    }

    /// Leads the reader to a row, which has that many bytes at most.
    fn go_to(&mut self, begin: usize, limit: usize) {
        let at = self.base + self.reader.byte();
        if self.by_line {
            // The reader would take a quote to the end of the text.
            self.reader = PooledReader::new(self.dialect.delimiter, &self.text.as_bytes()[begin..begin + limit]);
            self.base = begin;
        } else if !self.text.get(at..begin).is_some_and(|between| between.bytes().all(|byte| matches!(byte, b'\n' | b'\r'))) {
            self.reader.seek(begin - self.base);
        }
    }

    /// Where the next row begins: behind blank lines and comments.
    fn passed_over(&self) -> usize {
        let mut begin = self.at;
        loop {
            let line = &self.text[begin..];
            let inner = line.trim_start_matches(|c: char| is_space(c, self.dialect.sign()));
            if self.comments && inner.starts_with('#') {
                begin = self.text.len() - inner.len() + inner.find(['\n', '\r']).unwrap_or(inner.len());
            } else if line_end(inner) == 0 {
                return if inner.is_empty() { self.text.len() } else { begin };
            } else {
                begin = self.text.len() - inner.len();
            }
            begin += line_end(&self.text[begin..]);
        }
    }
}

struct RowBounds {
    cells: Vec<CellBounds>,
    /// Bytes up to the row's line end.
    end: usize,
    /// The last cell ends within quotes.
    open: bool,
    /// The crate finds other cells: quotes stand behind spaces, or text behind quotes.
    odd: bool,
}

/// A cell without spaces around it; of its quotes the opening and the closing one.
struct CellBounds {
    span: Range<usize>,
    quotes: Option<(usize, usize)>,
    fault: Option<CellFault>,
}

impl CellBounds {
    fn text<'a>(&self, row: &'a str) -> Cow<'a, str> {
        let Some((open, close)) = self.quotes else { return row[self.span.clone()].into() };
        let behind = row.get(close + 1..self.span.end).unwrap_or_default();
        (row[open + 1..close].replace("\"\"", "\"") + behind).into()
    }
}

fn bounds(row: &str, delimiter: char) -> RowBounds {
    let (mut cells, mut at, mut odd) = (Vec::new(), 0, false);
    loop {
        let from = at;
        let begin = row.len() - row[from..].trim_start_matches(|c: char| is_space(c, delimiter)).len();
        let quotes = row[begin..].starts_with('"').then(|| (begin, closing_quote(row, begin + 1)));
        let open = quotes.is_some_and(|(_, close)| close == row.len());
        let plain = quotes.map_or(begin, |(_, close)| row.len().min(close + 1));
        at = plain + row[plain..].find([delimiter, '\n', '\r']).unwrap_or(row.len() - plain);
        let behind = row[plain..at].trim_end().len();
        odd |= quotes.is_some() && (begin > from || at > plain);
        let fault = match quotes {
            Some(_) if open => Some(CellFault::Unclosed),
            Some(_) if !row[plain..plain + behind].trim().is_empty() => Some(CellFault::AfterQuote),
            _ => None,
        };
        cells.push(CellBounds { span: begin..plain + behind, quotes, fault });
        if !row[at..].starts_with(delimiter) {
            return RowBounds { cells, end: at, open, odd };
        }
        at += delimiter.len_utf8();
    }
}

/// The end of the row where there is none.
fn closing_quote(row: &str, from: usize) -> usize {
    let mut at = from;
    while let Some(found) = row[at..].find('"') {
        at += found;
        if !row[at + 1..].starts_with('"') {
            return at;
        }
        at += 2;
    }
    row.len()
}

fn is_space(c: char, delimiter: char) -> bool {
    c.is_whitespace() && !matches!(c, '\n' | '\r') && c != delimiter
}

fn line_ends(text: &str, range: Range<usize>) -> usize {
    let bytes = text.as_bytes();
    range.filter(|i| bytes[*i] == b'\n' || bytes[*i] == b'\r' && bytes.get(i + 1) != Some(&b'\n')).count()
}

/// The bytes of the line end with which a text begins.
fn line_end(text: &str) -> usize {
    if text.starts_with("\r\n") { 2 } else { usize::from(text.starts_with(['\n', '\r'])) }
}

/// A row with its line end, as the `csv` crate quotes it.
pub fn csv_line(cells: impl IntoIterator<Item: AsRef<[u8]>>) -> String {
    let mut writer = csv::WriterBuilder::new().has_headers(false).from_writer(Vec::new());
    // Memory takes all writes, and the cells are text.
    drop(writer.write_record(cells));
    writer.into_inner().ok().and_then(|bytes| String::from_utf8(bytes).ok()).unwrap_or_default()
}

type MemoryReader = Reader<Cursor<Vec<u8>>>;

thread_local! {
    /// By their delimiters.
    static KEPT: RefCell<Vec<(u8, MemoryReader)>> = const { RefCell::new(Vec::new()) };
}

struct PooledReader {
    delimiter: u8,
    /// `None` only once it is dropped.
    reader: Option<MemoryReader>,
}

impl PooledReader {
    pub fn new(delimiter: u8, text: &[u8]) -> Self {
        let kept = KEPT.with_borrow_mut(|kept| {
            let index = kept.iter().position(|(of, _)| *of == delimiter)?;
            Some(kept.swap_remove(index).1)
        });
        let fresh = || ReaderBuilder::new().has_headers(false).flexible(true).delimiter(delimiter).from_reader(Cursor::default());
        let mut reader = kept.unwrap_or_else(fresh);
        *reader.get_mut() = Cursor::new(text.to_vec());
        let mut pooled = Self { delimiter, reader: Some(reader) };
        pooled.seek(0);
        pooled
    }

    // The text is in memory: its length is a usize, and every place can be sought.
    pub fn byte(&self) -> usize {
        self.reader.as_ref().map_or(0, |reader| reader.position().byte() as usize)
    }

    pub fn seek(&mut self, byte: usize) {
        let mut position = Position::new();
        position.set_byte(byte as u64);
        drop(self.reader.as_mut().map(|reader| reader.seek_raw(SeekFrom::Start(byte as u64), position)));
    }

    pub fn read(&mut self, record: &mut StringRecord) -> bool {
        self.reader.as_mut().is_some_and(|reader| reader.read_record(record).unwrap_or(false))
    }
}

impl Drop for PooledReader {
    fn drop(&mut self) {
        let Some(mut reader) = self.reader.take() else { return };
        *reader.get_mut() = Cursor::default();
        // While a thread ends there is no pool any more.
        let _ = KEPT.try_with(|kept| kept.borrow_mut().push((self.delimiter, reader)));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows(bytes: &[u8], comments: bool) -> Vec<SpannedRow> {
        super::rows(bytes, comments, 2, &|_, rows| rows.iter().map(|row| row.cells.len() as i64).sum()).collect()
    }

    fn texts(bytes: &[u8]) -> Vec<(usize, Vec<String>)> {
        let text = |cell: Cell| cell.text.trim().to_owned();
        rows(bytes, true).into_iter().map(|row| (row.line, row.cells.into_iter().map(text).collect())).collect()
    }

    fn row(line: usize, cells: &[&str]) -> (usize, Vec<String>) {
        (line, cells.iter().map(|cell| (*cell).to_owned()).collect())
    }

    #[test]
    fn lines_are_counted_as_an_editor_does() {
        let text = b"\xef\xbb\xbf# note\r\n\r\nx, y\r\n \r\n  # note\r\n1 ,\t2\r\n,,\r\n3,4";
        assert_eq!(texts(text), [row(3, &["x", "y"]), row(6, &["1", "2"]), row(8, &["3", "4"])]);
        assert_eq!(texts(b"1\r2\r\r3"), [row(1, &["1"]), row(2, &["2"]), row(4, &["3"])]);
    }

    #[test]
    fn quoted_cells_keep_commas_quotes_and_lines() {
        let found = rows(b"a, \"b, \"\"c\"\"\r\n# d\" ,e\nf", true);
        assert_eq!(found[0].cells[1].text, "b, \"c\"\r\n# d");
        assert_eq!((found[0].cells[1].line, found[0].cells[2].line, found[1].line), (1, 2, 3));
        assert!(found.iter().flat_map(|row| &row.cells).all(|cell| cell.fault.is_none()));
        assert_eq!(texts(b"5\" nail,x"), [row(1, &["5\" nail", "x"])]);
    }

    #[test]
    fn faults_are_found_where_they_are() {
        let unclosed = Cell { text: "3".into(), line: 2, span: 4..6, fault: Some(CellFault::Unclosed) };
        let found = rows(b"1\n2,\"3\n4", true);
        assert_eq!((&found[1].cells[1], found[2].cells[0].text.as_str()), (&unclosed, "4"));
        assert_eq!(rows(b"\"1\" 2,3", true)[0].cells[0].fault, Some(CellFault::AfterQuote));
        let latin = rows(b"# \xe9\n1,caf\xe9", true);
        assert_eq!((latin[0].cells[0].fault, latin[0].cells[1].fault), (None, Some(CellFault::NotUtf8)));
        assert_eq!(rows("caf\u{fffd}".as_bytes(), true)[0].cells[0].fault, None);
        assert_eq!(rows(b"x\0,\x001\0\n\0", true)[0].cells[0].fault, Some(CellFault::Utf16));
        assert_eq!(rows(b"sep=|\n1|2", true)[0].cells[0].fault, Some(CellFault::Separator));
    }

    #[test]
    fn spans_are_the_bytes_of_rows_and_cells() {
        let text = "# é\r\n x , \"y\"\"é\" ,\r\n\n1,2\r3".as_bytes();
        let found = rows(text, true);
        let cut = |span: &Range<usize>| std::str::from_utf8(&text[span.clone()]).unwrap();
        let cells: Vec<Vec<&str>> = found.iter().map(|row| row.cells.iter().map(|cell| cut(&cell.span)).collect()).collect();
        assert_eq!(cells, [vec!["x", "\"y\"\"é\"", ""], vec!["1", "2"], vec!["3"]]);
        assert_eq!(found.iter().map(|row| cut(&row.span)).collect::<Vec<_>>(), [" x , \"y\"\"é\" ,\r\n", "1,2\r", "3"]);
    }

    #[test]
    fn rows_of_empty_cells_are_blank() {
        assert_eq!(texts(b"1,,2, \n"), [row(1, &["1", "", "2", ""])]);
        assert!(rows(b"", true).is_empty() && rows(b"\n,, ,\n\"\"\n#", true).is_empty());
    }
}
