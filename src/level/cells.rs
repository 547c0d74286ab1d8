//! Bytes to rows of cells, each with its line as an editor counts it. The `csv` crate does not serve: its line numbers are off after CRLF,
//! blank lines and comments, it swallows the rest of a file after a quote that is never closed, and it misses a quoted cell behind a space.

use std::iter::Peekable;
use std::ops::Range;
use std::str::Chars;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum CellFault {
    Unclosed,
    AfterQuote,
    NotUtf8,
    Utf16,
    /// The whole file is in a spreadsheet's own format.
    Workbook,
}

/// A cell without the spaces and the quotes around it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Cell {
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
pub(super) struct SpannedRow {
    pub line: usize,
    pub cells: Vec<Cell>,
    /// Its bytes in a UTF-8 file, with its line end.
    pub span: Range<usize>,
}

/// All rows but blank lines, rows of empty cells and lines that start with `#`. Lines end with LF, CRLF or CR; a UTF-8 byte-order mark is
/// passed over.
pub(super) fn rows(bytes: &[u8]) -> Vec<SpannedRow> {
    if let Some(fault) = fault_of_file(bytes) {
        let all = 0..bytes.len();
        return vec![SpannedRow {
            line: 1,
            cells: vec![Cell { text: String::new(), line: 1, span: all.clone(), fault: Some(fault) }],
            span: all,
        }];
    }
    let text = String::from_utf8_lossy(bytes);
    let damaged = matches!(text, std::borrow::Cow::Owned(_));
    let unmarked = text.strip_prefix('\u{feff}').unwrap_or(&text);
    let mut scanner = Scanner { chars: unmarked.chars().peekable(), line: 1, at: text.len() - unmarked.len() };
    let mut rows = Vec::new();
    while let Some(mut row) = scanner.row() {
        if damaged {
            for cell in row.cells.iter_mut().filter(|cell| cell.text.contains(char::REPLACEMENT_CHARACTER)) {
                cell.fault = cell.fault.or(Some(CellFault::NotUtf8));
            }
        }
        // A spreadsheet puts a comment with a comma in quotes.
        let comment = row.cells[0].fault.is_none() && row.cells[0].text.trim_start().starts_with('#');
        if !comment && row.cells.iter().any(|cell| !cell.is_empty()) {
            rows.push(row);
        }
    }
    rows
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

struct Scanner<'a> {
    chars: Peekable<Chars<'a>>,
    line: usize,
    /// Bytes before the next character.
    at: usize,
}

impl Scanner<'_> {
    /// The next row, possibly blank; `None` at the end of the text.
    fn row(&mut self) -> Option<SpannedRow> {
        let mut begin = self.at;
        self.skip_spaces();
        while self.chars.peek() == Some(&'#') {
            while !matches!(self.next(), Some('\n') | None) {}
            begin = self.at;
            self.skip_spaces();
        }
        self.chars.peek()?;
        let line = self.line;
        let mut cells = vec![self.cell()];
        while self.next() == Some(',') {
            cells.push(self.cell());
        }
        Some(SpannedRow { line, cells, span: begin..self.at })
    }

    fn cell(&mut self) -> Cell {
        self.skip_spaces();
        let (line, begin) = (self.line, self.at);
        if self.take_if(|c| c == '"').is_none() {
            let text = self.plain().trim_end().to_owned();
            return Cell { span: begin..begin + text.len(), text, line, fault: None };
        }
        let mut text = String::new();
        loop {
            match self.next() {
                None => return Cell { text, line, span: begin..self.at, fault: Some(CellFault::Unclosed) },
                Some('"') if self.take_if(|c| c == '"').is_some() => text.push('"'),
                Some('"') => break,
                Some(other) => text.push(other),
            }
        }
        let closed = self.at;
        let rest = self.plain();
        let fault = (!rest.trim().is_empty()).then_some(CellFault::AfterQuote);
        Cell { text: text + rest.trim_end(), line, span: begin..closed + rest.trim_end().len(), fault }
    }

    fn plain(&mut self) -> String {
        let mut text = String::new();
        while let Some(c) = self.take_if(|c| !matches!(c, ',' | '\n' | '\r')) {
            text.push(c);
        }
        text
    }

    fn skip_spaces(&mut self) {
        while self.take_if(|c| c.is_whitespace() && !matches!(c, '\n' | '\r')).is_some() {}
    }

    fn take_if(&mut self, wanted: impl Fn(char) -> bool) -> Option<char> {
        let taken = self.chars.next_if(|c| wanted(*c))?;
        self.at += taken.len_utf8();
        Some(taken)
    }

    /// The next character; every kind of line end is one `\n`.
    fn next(&mut self) -> Option<char> {
        let next = match self.take_if(|_| true)? {
            '\r' => {
                self.take_if(|c| c == '\n');
                '\n'
            }
            other => other,
        };
        self.line += usize::from(next == '\n');
        Some(next)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(bytes: &[u8]) -> Vec<(usize, Vec<String>)> {
        rows(bytes).into_iter().map(|row| (row.line, row.cells.into_iter().map(|cell| cell.text).collect())).collect()
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
        let found = rows(b"a, \"b, \"\"c\"\"\r\n# d\" ,e\nf");
        assert_eq!(found[0].cells[1].text, "b, \"c\"\n# d");
        assert_eq!((found[0].cells[1].line, found[0].cells[2].line, found[1].line), (1, 2, 3));
        assert!(found.iter().flat_map(|row| &row.cells).all(|cell| cell.fault.is_none()));
        assert_eq!(texts(b"5\" nail,x"), [row(1, &["5\" nail", "x"])]);
    }

    #[test]
    fn faults_are_found_where_they_are() {
        let unclosed = Cell { text: "3\n4".into(), line: 2, span: 4..8, fault: Some(CellFault::Unclosed) };
        assert_eq!(rows(b"1\n2,\"3\n4")[1].cells[1], unclosed);
        assert_eq!(rows(b"\"1\" 2,3")[0].cells[0].fault, Some(CellFault::AfterQuote));
        let latin = rows(b"# \xe9\n1,caf\xe9");
        assert_eq!((latin[0].cells[0].fault, latin[0].cells[1].fault), (None, Some(CellFault::NotUtf8)));
        assert_eq!(rows("caf\u{fffd}".as_bytes())[0].cells[0].fault, None);
        assert_eq!(rows(&[0xff, 0xfe, b'x', 0])[0].cells[0].fault, Some(CellFault::Utf16));
    }

    #[test]
    fn spans_are_the_bytes_of_rows_and_cells() {
        let text = "\u{feff}# é\r\n x , \"y\"\"é\" ,\r\n\n1,2\r3".as_bytes();
        let found = rows(text);
        let cut = |span: &Range<usize>| std::str::from_utf8(&text[span.clone()]).unwrap();
        let cells: Vec<Vec<&str>> = found.iter().map(|row| row.cells.iter().map(|cell| cut(&cell.span)).collect()).collect();
        assert_eq!(cells, [vec!["x", "\"y\"\"é\"", ""], vec!["1", "2"], vec!["3"]]);
        assert_eq!(found.iter().map(|row| cut(&row.span)).collect::<Vec<_>>(), [" x , \"y\"\"é\" ,\r\n", "1,2\r", "3"]);
    }

    #[test]
    fn rows_of_empty_cells_are_blank() {
        assert_eq!(texts(b"1,,2, \n"), [row(1, &["1", "", "2", ""])]);
        assert!(rows(b"").is_empty() && rows(b"\n,, ,\n\"\"\n#").is_empty());
    }
}
