//! Bytes to rows of cells, each with its line as an editor counts it. The `csv` crate does not serve: its line numbers are off after CRLF,
//! blank lines and comments, it swallows the rest of a file after a quote that is never closed, and it misses a quoted cell behind a space.

use crate::words::tr;
use std::borrow::Cow;
use std::ops::Range;

/// Some editors put it in front of UTF-8.
const MARK: &[u8] = b"\xEF\xBB\xBF";

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CellFault {
    /// The file ends within its quotes. The cell ends with its line.
    Unclosed,
    AfterQuote,
    NotUtf8,
    Utf16,
    /// The whole file is in a spreadsheet's own format.
    Workbook,
}

impl CellFault {
    /// The found and the expected, in words.
    pub fn words(self) -> (&'static str, &'static str) {
        match self {
            Self::Unclosed => (tr("a quote that is never closed"), tr("a closing quote")),
            Self::AfterQuote => (tr("text after a closing quote"), tr("a comma after it (a quote within quotes is written twice)")),
            Self::NotUtf8 => (tr("letters that are not UTF-8"), tr("a file saved as UTF-8")),
            Self::Utf16 => (tr("a file saved as UTF-16"), tr("a file saved as UTF-8")),
            Self::Workbook => (tr("a spreadsheet's own file (xlsx, ods)"), tr("a file that the spreadsheet saved as CSV")),
        }
    }
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cell {
    /// Without its quotes; a plain cell with the spaces around it.
    pub text: String,
    /// Its first line.
    pub line: usize,
    /// Its bytes in a UTF-8 file, with its quotes but without the spaces around it.
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
    /// Its bytes in a UTF-8 file, with its line end.
    pub span: Range<usize>,
}

/// All rows but blank lines and rows of empty cells, and, with `comments`, but lines that start with `#`. Lines end with LF, CRLF or CR;
/// a UTF-8 byte-order mark is passed over.
pub fn rows(bytes: &[u8], comments: bool) -> CsvRows<'_> {
    let at = if bytes.starts_with(MARK) { MARK.len() } else { 0 };
    CsvRows { fault: fault_of_file(bytes), text: String::from_utf8_lossy(bytes), at, line: 1, comments, unclosed: false }
}

fn fault_of_file(bytes: &[u8]) -> Option<CellFault> {
    /// The first bytes of a zipped file, such as a spreadsheet's.
    const ZIP: [u8; 4] = [b'P', b'K', 3, 4];
    let marked = bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]);
    // Every other byte of plain letters in UTF-16 is 0; a table in UTF-8 has none.
    let zeros = bytes.iter().filter(|byte| **byte == 0).count();
    match () {
        () if bytes.starts_with(&ZIP) => Some(CellFault::Workbook),
        () if marked || zeros * 3 > bytes.len() => Some(CellFault::Utf16),
        () => None,
    }
}

/// Row by row: all rows of a long flight at once would fill the memory.
pub struct CsvRows<'a> {
    /// Of the whole file.
    fault: Option<CellFault>,
    /// Owned where some bytes are not UTF-8.
    text: Cow<'a, str>,
    /// Bytes before the next character.
    at: usize,
    line: usize,
    comments: bool,
    /// A quote of an earlier row is never closed. From there on no cell spans lines, and reading takes linear time.
    unclosed: bool,
}

impl Iterator for CsvRows<'_> {
    type Item = SpannedRow;

    fn next(&mut self) -> Option<SpannedRow> {
        if let Some(fault) = self.fault.take() {
            let span = self.at..self.text.len();
            self.at = self.text.len();
            let cell = Cell { text: String::new(), line: 1, span: span.clone(), fault: Some(fault) };
            return Some(SpannedRow { line: 1, cells: vec![cell], span });
        }
        loop {
            let mut row = self.row()?;
            if matches!(self.text, Cow::Owned(_)) {
                for cell in row.cells.iter_mut().filter(|cell| cell.text.contains(char::REPLACEMENT_CHARACTER)) {
                    cell.fault = cell.fault.or(Some(CellFault::NotUtf8));
                }
            }
            // A spreadsheet puts a comment with a comma in quotes.
            let comment = self.comments && row.cells[0].fault.is_none() && row.cells[0].text.trim_start().starts_with('#');
            if !comment && row.cells.iter().any(|cell| !cell.is_empty()) {
                return Some(row);
            }
        }
    }
}

impl CsvRows<'_> {
    /// The next row, possibly blank; `None` at the end of the text.
    fn row(&mut self) -> Option<SpannedRow> {
        let mut begin = self.at;
        self.skip_spaces();
        while self.comments && self.peek() == Some('#') {
            while !matches!(self.take(), Some('\n') | None) {}
            begin = self.at;
            self.skip_spaces();
        }
        self.peek()?;
        let line = self.line;
        let mut cells = self.cells();
        if !self.unclosed && cells.last().is_some_and(|cell| cell.fault == Some(CellFault::Unclosed)) {
            (self.at, self.line, self.unclosed) = (begin, line, true);
            cells = self.cells();
        }
        Some(SpannedRow { line, cells, span: begin..self.at })
    }

    fn cells(&mut self) -> Vec<Cell> {
        let mut cells = vec![self.cell()];
        while self.take() == Some(',') {
            cells.push(self.cell());
        }
        cells
    }

    fn cell(&mut self) -> Cell {
        let from = self.at;
        self.skip_spaces();
        let (line, begin) = (self.line, self.at);
        if self.peek() != Some('"') {
            let end = begin + self.plain().trim_end().len();
            return Cell { text: self.text[from..self.at].to_owned(), line, span: begin..end, fault: None };
        }
        self.at += 1;
        let mut text = String::new();
        loop {
            match self.peek() {
                Some('"') if self.text[self.at..].starts_with("\"\"") => self.at += 1,
                Some('"') => break,
                Some('\n' | '\r') if !self.unclosed => {}
                None | Some('\n' | '\r') => return Cell { text, line, span: begin..self.at, fault: Some(CellFault::Unclosed) },
                Some(_) => {}
            }
            let from = self.at;
            self.take();
            text += &self.text[from..self.at];
        }
        self.at += 1;
        let closed = self.at;
        let rest = self.plain().trim_end();
        let fault = (!rest.trim().is_empty()).then_some(CellFault::AfterQuote);
        Cell { text: text + rest, line, span: begin..closed + rest.len(), fault }
    }

    /// Up to a comma or a line end.
    fn plain(&mut self) -> &str {
        let from = self.at;
        let rest = &self.text[from..];
        self.at += rest.find([',', '\n', '\r']).unwrap_or(rest.len());
        &self.text[from..self.at]
    }

    fn skip_spaces(&mut self) {
        let rest = &self.text[self.at..];
        self.at += rest.len() - rest.trim_start_matches(|c: char| c.is_whitespace() && !matches!(c, '\n' | '\r')).len();
    }

    fn peek(&self) -> Option<char> {
        self.text[self.at..].chars().next()
    }

    /// The next character; every kind of line end is one `\n`.
    fn take(&mut self) -> Option<char> {
        let next = self.peek()?;
        self.at += if self.text[self.at..].starts_with("\r\n") { 2 } else { next.len_utf8() };
        self.line += usize::from(matches!(next, '\n' | '\r'));
        Some(if next == '\r' { '\n' } else { next })
    }
}

/// A text as a cell: in quotes where `quoted` says so, or where they are needed.
pub fn encoded(text: &str, quoted: bool) -> String {
    if quoted || text.contains([',', '"', '\n', '\r']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text.to_owned() }
}

/// A row with its line end, as the `csv` crate quotes it.
pub fn csv_line(cells: impl IntoIterator<Item: AsRef<[u8]>>) -> String {
    let mut writer = csv::WriterBuilder::new().has_headers(false).from_writer(Vec::new());
    // Memory takes all writes, and the cells are text.
    drop(writer.write_record(cells));
    writer.into_inner().ok().and_then(|bytes| String::from_utf8(bytes).ok()).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows(bytes: &[u8], comments: bool) -> Vec<SpannedRow> {
        super::rows(bytes, comments).collect()
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
        assert_eq!(rows(&[0xff, 0xfe, b'x', 0], true)[0].cells[0].fault, Some(CellFault::Utf16));
    }

    #[test]
    fn spans_are_the_bytes_of_rows_and_cells() {
        let text = "\u{feff}# é\r\n x , \"y\"\"é\" ,\r\n\n1,2\r3".as_bytes();
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
