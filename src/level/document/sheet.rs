//! One CSV file, byte for byte as its author wrote it, and edits, which replace the text of their cells and rows and no other, in the file's
//! dialect and encoding. Rows, cells and columns are the loader's.

use crate::files::{Cell, CellFault, Dialect, SpannedRow};
use crate::level::schema::{Column, RowSchema, Table};
use crate::level::table::{self, HeaderColumns, HeaderPlan, all_columns};
use crate::words::tr;
use std::ops::Range;

/// Bytes of a file, and the text that takes their place.
type Splice = (Range<usize>, String);

/// A new row: its kind, and the texts of some columns.
pub(super) type Added = (&'static RowSchema, Vec<(&'static str, String)>);

/// The row counts from 0, without headers.
#[derive(Clone, Debug)]
pub(super) struct CellEdit<'a> {
    pub row: usize,
    pub column: &'static str,
    pub text: &'a str,
}

#[derive(Clone, Debug)]
pub(super) struct EditedFile {
    pub table: Table,
    pub exists: bool,
    pub bytes: Vec<u8>,
    /// Without a byte-order mark; rows and cells count its bytes.
    text: String,
    dialect: Dialect,
    decimal_commas: bool,
    /// All rows but blank ones, headers first.
    rows: Vec<SpannedRow>,
    /// `None`: the file is no table of its kind, and stays as it is.
    plan: Option<HeaderPlan>,
}

impl EditedFile {
    pub fn new(table: Table, bytes: Option<Vec<u8>>) -> Self {
        let (exists, bytes) = (bytes.is_some(), bytes.unwrap_or_default());
        let mut reader = table::rows(table.rows(), &bytes);
        let rows: Vec<SpannedRow> = reader.by_ref().collect();
        let (dialect, text) = (reader.dialect, std::mem::take(&mut reader.text));
        let is_text = |cell: &Cell| !matches!(cell.fault, Some(CellFault::Utf16 | CellFault::Workbook | CellFault::Separator));
        let whole = dialect.encoding.encode(&text) == bytes && rows.iter().flat_map(|row| &row.cells).all(is_text);
        let plan = if whole { table::plan(table.rows(), &rows, &mut Vec::new()).ok() } else { None };
        let mut file = Self { table, exists, bytes, text, dialect, decimal_commas: false, rows, plan };
        file.in_plain_dialect();
        file
    }

    /// In the document numbers have a decimal point. New ones are written with a comma where the file has one, or parts its cells by
    /// semicolons and has no decimal point.
    fn in_plain_dialect(&mut self) {
        let headers = self.plan.as_ref().map_or(self.rows.len(), |plan| plan.headers);
        let (mut points, mut commas) = (false, false);
        let (mut columns, of_settings) = (self.columns(0), self.table == Table::Constants);
        for row in 0..self.rows().len() {
            if self.is_by_kind() {
                columns = self.columns(row);
            }
            let first = if of_settings { self.rows[headers + row].cells[0].text.trim().to_owned() } else { String::new() };
            for (i, column) in columns.iter().copied().enumerate() {
                let Some(cell) = self.rows[headers + row].cells.get_mut(i) else { break };
                let Some(held) = column.and_then(|column| table::held(column, &first)) else { continue };
                let text = cell.text.trim();
                let plain = held.in_plain_dialect(self.dialect, text);
                commas |= plain != text && text.contains(',');
                points |= held.has_numbers() && text.contains('.');
                if plain != text {
                    cell.text = plain.into_owned();
                }
            }
        }
        self.decimal_commas = commas || self.dialect.delimiter == b';' && !points;
    }

    fn is_by_kind(&self) -> bool {
        self.table.rows().len() > 1
    }

    /// The rows below the headers; none without a plan.
    pub fn rows(&self) -> &[SpannedRow] {
        self.plan.as_ref().map_or(&[], |plan| &self.rows[plan.headers.min(self.rows.len())..])
    }

    fn columns(&self, row: usize) -> HeaderColumns {
        if !self.is_by_kind() {
            return self.plan.as_ref().map_or_else(Vec::new, |plan| plan.columns.clone());
        }
        let first = self.rows().get(row).map_or("", |row| row.cells[0].text.trim());
        table::schema_of(self.table.rows(), first).map_or_else(Vec::new, all_columns)
    }

    /// Without the spaces around it; `None` where the row has no such cell.
    pub fn cell(&self, row: usize, column: &str) -> Option<&str> {
        let cells = &self.rows().get(row)?.cells;
        let index = match &self.plan {
            Some(plan) if !self.is_by_kind() => position(&plan.columns, column),
            _ => position(&self.columns(row), column),
        }?;
        cells.get(index).map(|cell| cell.text.trim())
    }

    /// The line of a row, from 1, and the line after its last.
    pub fn lines(&self, row: usize) -> Option<(usize, usize)> {
        let row = self.rows().get(row)?;
        let text = &self.text.as_bytes()[row.span.clone()];
        let is_end = |(i, byte): &(usize, &u8)| **byte == b'\n' || (**byte == b'\r' && text.get(i + 1) != Some(&b'\n'));
        Some((row.line, row.line + text.iter().enumerate().filter(is_end).count().max(1)))
    }

    pub fn edit(&self, edits: &[CellEdit]) -> Result<Vec<u8>, String> {
        let Some(plan) = &self.plan else { return Err(self.closed()) };
        let mut splices = Vec::new();
        let mut shared = plan.columns.clone();
        if !self.is_by_kind() {
            splices.extend(self.widen(&mut shared, edits)?);
        }
        let mut edits: Vec<&CellEdit> = edits.iter().collect();
        edits.sort_by_key(|edit| edit.row);
        for of_row in edits.chunk_by(|a, b| a.row == b.row) {
            let row = self.row(of_row[0].row)?;
            let columns = if self.is_by_kind() { self.columns(of_row[0].row) } else { shared.clone() };
            let mut added: Vec<Option<&str>> = Vec::new();
            for edit in of_row {
                let Some(index) = position(&columns, edit.column) else {
                    let (file, column) = (self.table.file(), format!("{:?}", edit.column));
                    return Err(tr!("{file} has no column {column} in this row", file, column));
                };
                let Some(cell) = row.cells.get(index) else {
                    let beyond = index - row.cells.len();
                    added.resize(added.len().max(beyond + 1), None);
                    added[beyond] = Some(edit.text.trim());
                    continue;
                };
                let text = edit.text.trim();
                if cell.text.trim() == text {
                    continue;
                }
                let quoted = self.text[cell.span.clone()].starts_with('"');
                let first = row.cells[0].text.trim();
                let new = self.encoded(columns[index], first, text, quoted || is_comment(text, index == 0));
                splices.push((cell.span.clone(), new));
            }
            while added.last().is_some_and(|text| text.is_none_or(str::is_empty)) {
                added.pop();
            }
            if let (false, Some(last)) = (added.is_empty(), row.cells.last()) {
                let cell = |(i, text): (usize, &Option<&str>)| {
                    let column = columns.get(row.cells.len() + i).copied().flatten();
                    self.dialect.sign().to_string() + &self.encoded(column, row.cells[0].text.trim(), text.unwrap_or(""), false)
                };
                let new: String = added.iter().enumerate().map(cell).collect();
                splices.push((last.span.end..last.span.end, new));
            }
        }
        self.spliced(splices)
    }

    fn widen(&self, columns: &mut HeaderColumns, edits: &[CellEdit]) -> Result<Option<Splice>, String> {
        let headers = self.plan.as_ref().map_or(0, |plan| plan.headers);
        let header = self.rows.first().filter(|_| headers > 0);
        let Some(last) = columns.len().checked_sub(1).and_then(|last| header?.cells.get(last)) else { return Ok(None) };
        let known = columns.len();
        let mut new = String::new();
        for edit in edits.iter().filter(|edit| !edit.text.trim().is_empty()) {
            let column = self.table.rows()[0].columns.iter().find(|column| column.name == edit.column);
            if let (Some(column), None) = (column, position(columns, edit.column)) {
                columns.push(Some(column));
                new.push(self.dialect.sign());
                new += column.name;
            }
        }
        if new.is_empty() {
            return Ok(None);
        }
        // A cell beyond the header, which is a mistake, would get a column.
        if let Some(row) = self.rows().iter().find(|row| row.cells.iter().skip(known).any(|cell| !cell.is_empty())) {
            let (file, line) = (self.table.file(), row.line);
            return Err(tr!("{file}:{line} has more cells than the header: it is to be mended first", file, line));
        }
        Ok(Some((last.span.end..last.span.end, new)))
    }

    pub fn append(&self, added: &[Added]) -> Result<Vec<u8>, String> {
        let Some(plan) = &self.plan else { return Err(self.closed()) };
        if self.rows.iter().flat_map(|row| &row.cells).any(|cell| cell.fault == Some(CellFault::Unclosed)) {
            return Err(tr!("{file} ends within quotes that are never closed", file = self.table.file()));
        }
        let Some((first, _)) = added.first() else { return Ok(self.bytes.clone()) };
        let (ending, by_kind) = (self.line_end(), self.is_by_kind());
        let fresh = self.rows.is_empty() && !by_kind;
        let mut splices = Vec::new();
        let mut shared = if fresh { all_columns(first) } else { plan.columns.clone() };
        if !fresh && !by_kind {
            let cells = added.iter().flat_map(|(_, cells)| cells);
            let cells: Vec<CellEdit> = cells.map(|(column, text)| CellEdit { row: 0, column, text }).collect();
            splices.extend(self.widen(&mut shared, &cells)?);
        }
        let mut new = String::new();
        if !self.text.is_empty() && !self.text.ends_with(['\n', '\r']) {
            new += ending;
        }
        if fresh {
            let names: Vec<&str> = first.columns.iter().map(|column| column.name).collect();
            new = new + &names.join(&self.dialect.sign().to_string()) + ending;
        }
        for (schema, cells) in added {
            let own: HeaderColumns = if by_kind { all_columns(schema) } else { shared.clone() };
            new = new + &self.line(&own, cells) + ending;
        }
        splices.push((self.text.len()..self.text.len(), new));
        self.spliced(splices)
    }

    pub fn remove(&self, rows: &[usize]) -> Result<Vec<u8>, String> {
        if self.plan.is_none() {
            return Err(self.closed());
        }
        let taken = rows.iter().filter_map(|row| self.rows().get(*row));
        self.spliced(taken.map(|row| (row.span.clone(), String::new())).collect())
    }

    /// Ranges count the bytes before any splice. Errors: the file would be read as if its cells were separated otherwise.
    fn spliced(&self, mut splices: Vec<Splice>) -> Result<Vec<u8>, String> {
        let mut text = self.text.clone();
        splices.sort_by_key(|(range, _)| range.start);
        splices.into_iter().rev().for_each(|(range, new)| text.replace_range(range, &new));
        let bytes = self.dialect.encoding.encode(&text);
        let mut read = table::rows(self.table.rows(), &bytes);
        if read.dialect != self.dialect && read.next().is_some() {
            let file = self.table.file();
            return Err(tr!("{file} would be read with other separators: it is to be edited in a text editor", file));
        }
        Ok(bytes)
    }

    fn row(&self, row: usize) -> Result<&SpannedRow, String> {
        let row = self.rows().get(row).ok_or(tr("there is no such row any more"))?;
        if row.cells.iter().all(|cell| cell.fault.is_none()) {
            return Ok(row);
        }
        let (file, line) = (self.table.file(), row.line);
        Err(tr!("{file}:{line} cannot be read: it is to be mended in a text editor", file, line))
    }

    /// A row's text, without empty cells behind the last required one.
    fn line(&self, columns: &[Option<&'static Column>], cells: &[(&'static str, String)]) -> String {
        let text = |column: &Option<&Column>| {
            let given = cells.iter().find(|(name, _)| column.is_some_and(|column| column.name == *name));
            given.map_or("", |(_, text)| text.trim())
        };
        let mut texts: Vec<&str> = columns.iter().map(text).collect();
        let least = columns.iter().rposition(|column| column.is_some_and(|column| column.required)).map_or(1, |last| last + 1);
        while texts.len() > least && texts.last().is_some_and(|text| text.is_empty()) {
            texts.pop();
        }
        let first = texts.first().copied().unwrap_or_default();
        let cell = |(i, text): (usize, &&str)| self.encoded(columns[i], first, text, is_comment(text, i == 0));
        texts.iter().enumerate().map(cell).collect::<Vec<_>>().join(&self.dialect.sign().to_string())
    }

    /// A cell's text as this file writes it; `first` is the text of its row's first cell.
    fn encoded(&self, column: Option<&'static Column>, first: &str, text: &str, quoted: bool) -> String {
        let number = column.and_then(|column| table::held(column, first)).is_some_and(|held| held.has_numbers());
        if number && self.decimal_commas {
            return self.dialect.encoded(&text.replace('.', ","), quoted);
        }
        self.dialect.encoded(text, quoted)
    }

    fn closed(&self) -> String {
        tr!("{file} cannot be read as a table: it is to be mended in a text editor", file = self.table.file())
    }

    fn line_end(&self) -> &'static str {
        match self.text.find(['\n', '\r']).map(|at| &self.text[at..]) {
            Some(end) if end.starts_with("\r\n") => "\r\n",
            Some(end) if end.starts_with('\r') => "\r",
            _ => "\n",
        }
    }
}

fn position(columns: &[Option<&Column>], name: &str) -> Option<usize> {
    columns.iter().position(|column| column.is_some_and(|column| column.name == name))
}

/// A leading `#` in a row's first cell would make a comment.
fn is_comment(text: &str, first: bool) -> bool {
    first && text.starts_with('#')
}
