//! One CSV file, byte for byte as its author wrote it, and what an edit replaces in it: the bytes of the cells and rows that it is about,
//! and none besides. Rows, cells and columns are the loader's own.

use super::kinds::Table;
use crate::level::cells::{self, Fault, Row};
use crate::level::rows;
use crate::level::table::{self, Column, Plan};

/// Bytes in place of others.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Splice {
    pub at: usize,
    pub old: Vec<u8>,
    pub new: Vec<u8>,
}

/// A cell that is to hold another text.
#[derive(Clone, Debug)]
pub(super) struct CellEdit<'a> {
    /// The row, from 0, headers not counted.
    pub row: usize,
    pub column: &'static str,
    pub text: &'a str,
}

/// Why a file or a row cannot be written into, in words.
pub(super) type Refusal = String;

/// A file of a level.
#[derive(Clone, Debug)]
pub(super) struct Sheet {
    pub table: Table,
    /// Whether there is such a file at all.
    pub exists: bool,
    pub bytes: Vec<u8>,
    /// All rows that hold something, headers first.
    rows: Vec<Row>,
    /// `None`: the file cannot be understood, and is kept as it is.
    plan: Option<Plan>,
}

impl Sheet {
    pub fn new(table: Table, bytes: Option<Vec<u8>>) -> Self {
        let mut sheet = Self { table, exists: bytes.is_some(), bytes: bytes.unwrap_or_default(), rows: Vec::new(), plan: None };
        sheet.parse();
        sheet
    }

    fn parse(&mut self) {
        self.rows = cells::rows(&self.bytes);
        let whole = std::str::from_utf8(&self.bytes).is_ok()
            && !self.rows.iter().flat_map(|row| &row.cells).any(|cell| matches!(cell.fault, Some(Fault::Utf16 | Fault::Workbook)));
        self.plan = if !whole {
            None
        } else if self.table == Table::Objectives {
            Some(Plan { columns: Vec::new(), headers: table::headers_by_kind(&self.rows) })
        } else {
            table::plan(self.table.layout(), &self.rows)
        };
    }

    /// The rows below the headers; none in a file that cannot be understood.
    pub fn rows(&self) -> &[Row] {
        self.plan.as_ref().map_or(&[], |plan| &self.rows[plan.headers.min(self.rows.len())..])
    }

    /// The columns of a row's cells.
    pub fn columns(&self, row: usize) -> Vec<Option<Column>> {
        if self.table != Table::Objectives {
            return self.plan.as_ref().map_or_else(Vec::new, |plan| plan.columns.clone());
        }
        let kind = self.rows().get(row).map_or("", |row| row.cells[0].text.trim());
        rows::objective_layout(kind).map_or_else(Vec::new, |layout| layout.columns().map(Some).collect())
    }

    /// What stands in a cell, without the spaces around it; `None` where the row has no such cell.
    pub fn cell(&self, row: usize, column: &str) -> Option<&str> {
        let cells = &self.rows().get(row)?.cells;
        let index = match (&self.plan, self.table) {
            (Some(plan), table) if table != Table::Objectives => position(&plan.columns, column),
            _ => position(&self.columns(row), column),
        }?;
        cells.get(index).map(|cell| cell.text.trim())
    }

    /// The line of a row, from 1, and the line after its last.
    pub fn lines(&self, row: usize) -> Option<(usize, usize)> {
        let row = self.rows().get(row)?;
        let text = &self.bytes[row.span.clone()];
        let ends =
            text.iter().enumerate().filter(|(i, byte)| **byte == b'\n' || (**byte == b'\r' && text.get(i + 1) != Some(&b'\n')));
        Some((row.line, row.line + ends.count().max(1)))
    }

    /// What has to be replaced so that these cells hold those texts.
    pub fn edit(&self, edits: &[CellEdit]) -> Result<Vec<Splice>, Refusal> {
        let Some(plan) = &self.plan else { return Err(self.closed()) };
        let mut splices = Vec::new();
        let mut shared = plan.columns.clone();
        if self.table != Table::Objectives {
            splices.extend(self.widen(&mut shared, edits)?);
        }
        let mut edits: Vec<&CellEdit> = edits.iter().collect();
        edits.sort_by_key(|edit| edit.row);
        for of_row in edits.chunk_by(|a, b| a.row == b.row) {
            let row = self.row(of_row[0].row)?;
            let columns = if self.table == Table::Objectives { self.columns(of_row[0].row) } else { shared.clone() };
            let mut added: Vec<Option<&str>> = Vec::new();
            for edit in of_row {
                let Some(index) = position(&columns, edit.column) else {
                    return Err(format!("{} has no column {:?} in this row", self.table.file(), edit.column));
                };
                let Some(cell) = row.cells.get(index) else {
                    let beyond = index - row.cells.len();
                    added.resize(added.len().max(beyond + 1), None);
                    added[beyond] = Some(edit.text.trim());
                    continue;
                };
                if cell.text.trim() == edit.text.trim() {
                    continue;
                }
                let old = self.bytes[cell.span.clone()].to_vec();
                let new = encoded(edit.text.trim(), old.first() == Some(&b'"'), index == 0);
                splices.push(Splice { at: cell.span.start, old, new: new.into_bytes() });
            }
            while added.last().is_some_and(|text| text.is_none_or(str::is_empty)) {
                added.pop();
            }
            if let (false, Some(last)) = (added.is_empty(), row.cells.last()) {
                let new: String = added.iter().map(|text| ",".to_owned() + &encoded(text.unwrap_or(""), false, false)).collect();
                splices.push(Splice { at: last.span.end, old: Vec::new(), new: new.into_bytes() });
            }
        }
        Ok(splices)
    }

    /// Gives the header the columns that it lacks.
    fn widen(&self, columns: &mut Vec<Option<Column>>, edits: &[CellEdit]) -> Result<Option<Splice>, Refusal> {
        let headers = self.plan.as_ref().map_or(0, |plan| plan.headers);
        let header = self.rows.first().filter(|_| headers > 0);
        let Some(last) = columns.len().checked_sub(1).and_then(|last| header?.cells.get(last)) else { return Ok(None) };
        let known = columns.len();
        let mut new = String::new();
        for edit in edits.iter().filter(|edit| !edit.text.trim().is_empty()) {
            let column = self.table.layout().columns().find(|column| column.name == edit.column);
            if let (Some(column), None) = (column, position(columns, edit.column)) {
                columns.push(Some(column));
                new = new + "," + column.name;
            }
        }
        if new.is_empty() {
            return Ok(None);
        }
        // A cell without a column, which is a mistake, would get one.
        if let Some(row) = self.rows().iter().find(|row| row.cells.iter().skip(known).any(|cell| !cell.is_empty())) {
            return Err(format!("{}:{} has more cells than the header: it is to be mended first", self.table.file(), row.line));
        }
        Ok(Some(Splice { at: last.span.end, old: Vec::new(), new: new.into_bytes() }))
    }

    /// What has to be replaced so that there are these rows below all others. Each is the columns of its kind, and the texts of some.
    pub fn append(&self, added: &[Added]) -> Result<Vec<Splice>, Refusal> {
        let Some(plan) = &self.plan else { return Err(self.closed()) };
        if self.rows.iter().flat_map(|row| &row.cells).any(|cell| cell.fault == Some(Fault::Unclosed)) {
            return Err(format!("{} ends within quotes that are never closed", self.table.file()));
        }
        let Some((first, _)) = added.first() else { return Ok(Vec::new()) };
        let (ending, by_kind) = (self.line_end(), self.table == Table::Objectives);
        let fresh = self.rows.is_empty() && !by_kind;
        let mut splices = Vec::new();
        let mut shared = if fresh { first.iter().copied().map(Some).collect() } else { plan.columns.clone() };
        if !fresh && !by_kind {
            let cells = added.iter().flat_map(|(_, cells)| cells);
            let cells: Vec<CellEdit> = cells.map(|(column, text)| CellEdit { row: 0, column, text }).collect();
            splices.extend(self.widen(&mut shared, &cells)?);
        }
        let mut new = String::new();
        if !self.bytes.is_empty() && !self.bytes.ends_with(b"\n") && !self.bytes.ends_with(b"\r") {
            new += ending;
        }
        if fresh {
            new = new + &first.iter().map(|column| column.name).collect::<Vec<_>>().join(",") + ending;
        }
        for (columns, cells) in added {
            let own: Vec<Option<Column>> = if by_kind { columns.iter().copied().map(Some).collect() } else { shared.clone() };
            new = new + &line(&own, cells) + ending;
        }
        splices.push(Splice { at: self.bytes.len(), old: Vec::new(), new: new.into_bytes() });
        Ok(splices)
    }

    /// What has to be taken out so that these rows are gone, with their lines.
    pub fn remove(&self, rows: &[usize]) -> Result<Vec<Splice>, Refusal> {
        if self.plan.is_none() {
            return Err(self.closed());
        }
        let taken = rows.iter().filter_map(|row| self.rows().get(*row));
        Ok(taken.map(|row| Splice { at: row.span.start, old: self.bytes[row.span.clone()].to_vec(), new: Vec::new() }).collect())
    }

    /// Replaces bytes, from the end of the file to its beginning: each place is that before any of them.
    pub fn apply(&mut self, splices: &[Splice]) {
        for splice in splices {
            self.bytes.splice(splice.at..splice.at + splice.old.len(), splice.new.iter().copied());
        }
        self.parse();
    }

    /// Puts back what [`Sheet::apply`] has replaced.
    pub fn take_back(&mut self, splices: &[Splice]) {
        put_back(&mut self.bytes, splices);
        self.parse();
    }

    fn row(&self, row: usize) -> Result<&Row, Refusal> {
        let row = self.rows().get(row).ok_or("there is no such row any more")?;
        match row.cells.iter().any(|cell| cell.fault.is_some()) {
            true => Err(format!("{}:{} cannot be read: it is to be mended in a text editor", self.table.file(), row.line)),
            false => Ok(row),
        }
    }

    fn closed(&self) -> Refusal {
        format!("{} cannot be read as a table: it is to be mended in a text editor", self.table.file())
    }

    /// How the file ends its lines.
    fn line_end(&self) -> &'static str {
        match self.bytes.iter().position(|byte| matches!(byte, b'\n' | b'\r')) {
            Some(at) if self.bytes[at] == b'\n' => "\n",
            Some(at) if self.bytes.get(at + 1) == Some(&b'\n') => "\r\n",
            Some(_) => "\r",
            None => "\n",
        }
    }
}

/// A row to be added: the columns of its kind, and the texts of some of them.
pub(super) type Added = (Vec<Column>, Vec<(&'static str, String)>);

/// A row's text: as long as it has to be.
fn line(columns: &[Option<Column>], cells: &[(&'static str, String)]) -> String {
    let text = |column: &Option<Column>| {
        let given = cells.iter().find(|(name, _)| column.is_some_and(|column| column.name == *name));
        given.map_or("", |(_, text)| text.trim())
    };
    let mut texts: Vec<&str> = columns.iter().map(text).collect();
    let least = columns.iter().rposition(|column| column.is_some_and(|column| column.required)).map_or(1, |last| last + 1);
    while texts.len() > least && texts.last().is_some_and(|text| text.is_empty()) {
        texts.pop();
    }
    texts.iter().enumerate().map(|(i, text)| encoded(text, false, i == 0)).collect::<Vec<_>>().join(",")
}

/// Puts back what splices have replaced, the last one first.
pub(super) fn put_back(bytes: &mut Vec<u8>, splices: &[Splice]) {
    for splice in splices.iter().rev() {
        bytes.splice(splice.at..splice.at + splice.new.len(), splice.old.iter().copied());
    }
}

/// The one place where two texts differ; `None` where they do not.
pub(super) fn difference(old: &[u8], new: &[u8]) -> Option<Splice> {
    if old == new {
        return None;
    }
    let begin = old.iter().zip(new).take_while(|(a, b)| a == b).count();
    let (old, new) = (&old[begin..], &new[begin..]);
    let end = old.iter().rev().zip(new.iter().rev()).take_while(|(a, b)| a == b).count();
    Some(Splice { at: begin, old: old[..old.len() - end].to_vec(), new: new[..new.len() - end].to_vec() })
}

fn position(columns: &[Option<Column>], name: &str) -> Option<usize> {
    columns.iter().position(|column| column.is_some_and(|column| column.name == name))
}

/// A text as a cell: in quotes where they are needed, or were there before.
fn encoded(text: &str, quoted: bool, first: bool) -> String {
    // What begins with a quote would be one, and so would a comment.
    let needed = text.contains([',', '"', '\n', '\r']) || (first && text.starts_with('#'));
    if quoted || needed { format!("\"{}\"", text.replace('"', "\"\"")) } else { text.to_owned() }
}
