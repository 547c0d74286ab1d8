//! Which cell belongs to which column: headers, header-less files, rows of several shapes; and typed access to cells.
//!
//! Everything here reports and goes on, so that an author sees all problems at once. A getter returns `None` where a problem has
//! been reported, by itself or before.

use super::cells::{self, Cell, Fault, Row};
use super::nearest::meant;
use super::problem::{Problem, quoted};
use super::quantity::Quantity;
use csv::StringRecord;
use serde::Deserialize;
use serde::de::DeserializeOwned;

/// The columns of a file, or of one kind of row, in the documented order; `[name]` may be left out or left empty.
#[derive(Clone, Copy, Debug)]
pub(super) struct Layout {
    /// The file's name.
    pub file: &'static str,
    /// Their names, separated by commas.
    pub columns: &'static str,
}

impl Layout {
    /// All columns in the documented order.
    pub fn columns(&self) -> impl Iterator<Item = Column> + use<> {
        self.columns.split(',').map(|name| match name.strip_prefix('[') {
            Some(name) => Column { name: name.trim_end_matches(']'), required: false },
            None => Column { name, required: true },
        })
    }

    fn find(&self, name: &str) -> Option<Column> {
        self.columns().find(|column| column.name.eq_ignore_ascii_case(name.trim()))
    }

    /// The first column, which stands for the whole row or file in a message.
    fn first(&self) -> &'static str {
        self.columns().next().map_or("", |column| column.name)
    }

    /// A problem that concerns the whole file.
    pub fn problem(&self, line: usize, found: impl Into<String>, expected: impl Into<String>) -> Problem {
        Problem::new(self.file, line, self.first(), found, expected)
    }
}

/// A column of a file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Column {
    pub name: &'static str,
    pub required: bool,
}

/// A row whose cells have found their columns.
#[derive(Clone, Debug)]
pub(super) struct Record {
    pub file: &'static str,
    pub line: usize,
    cells: Vec<(&'static str, Cell)>,
}

/// The most cells that a header may have. No file has a tenth as many columns; with as many as a file can hold, every message about a
/// row would name all of them.
const MOST_COLUMNS: usize = 200;

/// How many problems of a level are told: whoever has so many looks at the first.
pub(super) const MOST_PROBLEMS: usize = 1000;

/// What stands in place of all further problems.
pub(super) fn too_many(file: &str, line: usize) -> Problem {
    Problem::new(file, line, "all", "more problems from here on", format!("at most {MOST_PROBLEMS} in a level"))
}

/// What a file holds.
#[derive(Debug, Default)]
pub(super) struct Table {
    /// The rows that could be read.
    pub records: Vec<Record>,
    /// The lines of all rows but the header, also of those that could not be read.
    pub lines: Vec<usize>,
}

/// Reads a file whose rows all have the same columns.
pub(super) fn read(layout: Layout, bytes: &[u8], problems: &mut Vec<Problem>) -> Table {
    let rows = cells::rows(bytes);
    let mut columns: Vec<Option<Column>> = layout.columns().map(Some).collect();
    let mut rows = rows.as_slice();
    if let Some(problem) = rows.first().and_then(|first| separator_said(layout, first)) {
        problems.push(problem);
        return Table { records: Vec::new(), lines: rows.iter().map(|row| row.line).collect() };
    }
    if let Some((first, rest)) = rows.split_first()
        && is_foreign_header(layout, first)
    {
        let names: Vec<&str> = first.cells.iter().map(|cell| cell.text.trim()).filter(|name| !name.is_empty()).collect();
        let found = format!("a header of unknown names, {}", quoted(&names.join(",")));
        problems.push(layout.problem(first.line, found, format!("the columns {}", layout.columns)));
        return Table { records: Vec::new(), lines: rest.iter().map(|row| row.line).collect() };
    }
    if let Some((first, rest)) = rows.split_first()
        && is_header(layout, first)
    {
        let used = first.cells.iter().rposition(|cell| !cell.is_empty()).map_or(0, |last| last + 1);
        if used > MOST_COLUMNS {
            let found = format!("{used} cells in the header");
            problems.push(layout.problem(first.line, found, format!("the columns {}", layout.columns)));
            return Table { records: Vec::new(), lines: rest.iter().map(|row| row.line).collect() };
        }
        columns = header(layout, first, problems);
        rows = rest;
    }
    let mut table = Table::default();
    let enough = problems.len() + MOST_PROBLEMS;
    for row in rows {
        table.lines.push(row.line);
        if problems.len() >= enough {
            problems.push(too_many(layout.file, row.line));
            break;
        }
        if let Some(problem) = wrong_separator(layout, row) {
            problems.push(problem);
            break; // The rest of the file is like this row.
        }
        table.records.extend(record(layout, &columns, row, problems));
    }
    table
}

/// How a file's rows are to be understood, for whoever writes into it.
#[derive(Clone, Debug)]
pub(super) struct Plan {
    /// The column of each cell; `None` for one that is not known.
    pub columns: Vec<Option<Column>>,
    /// How many rows at the beginning name columns.
    pub headers: usize,
}

/// How the rows of a file are understood by [`read`]; `None` where they are not.
pub(super) fn plan(layout: Layout, rows: &[Row]) -> Option<Plan> {
    let plain = || layout.columns().map(Some).collect();
    let Some(first) = rows.first() else { return Some(Plan { columns: plain(), headers: 0 }) };
    if separator_said(layout, first).is_some() || is_foreign_header(layout, first) {
        return None;
    }
    if !is_header(layout, first) {
        return Some(Plan { columns: plain(), headers: 0 });
    }
    let readable = first.cells.len() <= MOST_COLUMNS;
    readable.then(|| Plan { columns: header(layout, first, &mut Vec::new()), headers: 1 })
}

/// How many rows at the beginning of objectives.csv name columns.
pub(super) fn headers_by_kind(rows: &[Row]) -> usize {
    rows.iter().take_while(|row| names_place(row)).count()
}

/// Whether a row of objectives.csv names columns.
fn names_place(row: &Row) -> bool {
    let is_cell = |i: usize, name: &str| row.cells.get(i).is_some_and(|cell| cell.text.trim().eq_ignore_ascii_case(name));
    is_cell(1, "x") && is_cell(2, "y")
}

/// Reads a file whose rows have the layout that `of_kind` gives for their first cell. Leading rows that name columns (`x` and `y`
/// in the second and third cell) are passed over.
pub(super) fn read_by_kind(
    kinds: Layout,
    of_kind: impl Fn(&str) -> Option<Layout>,
    bytes: &[u8],
    problems: &mut Vec<Problem>,
) -> Table {
    let rows = cells::rows(bytes);
    let mut table = Table::default();
    let enough = problems.len() + MOST_PROBLEMS;
    for row in rows.iter().skip(headers_by_kind(&rows)) {
        table.lines.push(row.line);
        if problems.len() >= enough {
            problems.push(too_many(kinds.file, row.line));
            break;
        }
        if let Some(problem) = wrong_separator(kinds, row) {
            problems.push(problem);
            break;
        }
        let kind = &row.cells[0];
        match of_kind(kind.text.trim()) {
            Some(layout) => {
                let columns: Vec<_> = layout.columns().map(Some).collect();
                table.records.extend(record(layout, &columns, row, problems));
            }
            None if kind.fault.is_some() => report_faults(kinds, &[], row, problems),
            None if kind.text.trim().eq_ignore_ascii_case(kinds.first()) => {
                let found = "a header with its columns in another order";
                let expected = format!("{}: the columns of these rows never change places", kinds.columns);
                problems.push(Problem::new(kinds.file, kind.line, kinds.first(), found, expected));
            }
            None => {
                let expected = format!("PLAYER, PHYS or OBJECT{}", meant(&kind.text, ["PLAYER", "PHYS", "OBJECT"]));
                problems.push(Problem::new(kinds.file, kind.line, kinds.first(), found(kind), expected));
            }
        }
    }
    table
}

/// Whether a first row names columns: its first cell does, or at least two others do (then the first is a misspelt name).
fn is_header(layout: Layout, row: &Row) -> bool {
    let named = |cell: &Cell| layout.find(&cell.text).is_some();
    row.cells.first().is_some_and(named) || row.cells.iter().filter(|cell| named(cell)).count() >= 2
}

/// Whether a first row is a header none of whose names is known: where numbers belong there are only words.
fn is_foreign_header(layout: Layout, row: &Row) -> bool {
    let word = |cell: &Cell| cell.fault.is_none() && cell.text.trim().chars().all(|c| c.is_alphabetic() || c == '_' || c == ' ');
    let numbers = layout.columns.starts_with("x,y,");
    let [x, y, ..] = &row.cells[..] else { return false };
    numbers && !is_header(layout, row) && [x, y].into_iter().all(|cell| word(cell) && !cell.is_empty() && !is_numberlike(cell))
}

/// Words that some programs write for numbers.
fn is_numberlike(cell: &Cell) -> bool {
    cell.text.trim().parse::<f64>().is_ok()
}

/// The problem of a first row `sep=;`, by which some spreadsheets say how cells are separated.
fn separator_said(layout: Layout, row: &Row) -> Option<Problem> {
    let said = row.cells[0].text.trim().to_lowercase();
    let separator = said.strip_prefix("sep=")?;
    let found = format!("{}, cells separated by something else than commas", quoted(&format!("sep={separator}")));
    Some(layout.problem(row.line, found, "a file saved with commas between the cells, numbers with a decimal point"))
}

/// The columns in the order of the header; `None` for one that is not known.
fn header(layout: Layout, row: &Row, problems: &mut Vec<Problem>) -> Vec<Option<Column>> {
    let mut columns: Vec<Option<Column>> = Vec::new();
    let used = row.cells.iter().rposition(|cell| !cell.is_empty()).map_or(0, |last| last + 1);
    for cell in &row.cells[..used] {
        let known = layout.find(&cell.text);
        let mut report = |found: String, expected: String| {
            problems.push(Problem::new(layout.file, cell.line, cell.text.trim(), found, expected));
        };
        match known {
            None => {
                let known = layout.columns().map(|column| column.name);
                report("an unknown column".into(), format!("the columns {}{}", layout.columns, meant(&cell.text, known)));
            }
            Some(column) if columns.contains(&Some(column)) => report("the same column twice".into(), "each column once".into()),
            Some(_) => {}
        }
        columns.push(known.filter(|column| !columns.contains(&Some(*column))));
    }
    for missing in layout.columns().filter(|column| column.required && !columns.contains(&Some(*column))) {
        let expected = format!("the columns {}", layout.columns);
        problems.push(Problem::new(layout.file, row.line, missing.name, "no such column in the header", expected));
    }
    columns
}

/// A problem where a row looks as if its cells were separated by semicolons or tabs, as some spreadsheets write them.
fn wrong_separator(layout: Layout, row: &Row) -> Option<Problem> {
    let required = layout.columns().filter(|column| column.required).count();
    let count = |separator| row.cells.iter().map(|cell| cell.text.matches(separator).count()).sum::<usize>();
    if row.cells.len() >= required {
        return None;
    }
    let separator = [(';', "semicolons"), ('\t', "tabs")].into_iter().find(|(c, _)| count(*c) + 1 >= required)?.1;
    Some(layout.problem(
        row.line,
        format!("cells separated by {separator}"),
        "cells separated by commas, numbers with a decimal point",
    ))
}

/// The row's cells by column, or `None` where the row as such is broken.
fn record(layout: Layout, columns: &[Option<Column>], row: &Row, problems: &mut Vec<Problem>) -> Option<Record> {
    if row.cells.iter().any(|cell| cell.fault.is_some()) {
        report_faults(layout, columns, row, problems);
        return None;
    }
    if let Some(extra) = row.cells.iter().skip(columns.len()).rposition(|cell| !cell.is_empty()) {
        let (first, found) = (&row.cells[columns.len()], cell_count(columns.len() + extra + 1));
        let name = (columns.len() + 1).to_string();
        let expected = cells_wanted(columns) + " (a cell that holds a comma stands in quotes, decimals are written with a point)";
        problems.push(Problem::new(layout.file, first.line, name, found, expected));
    }
    if let Some(column) = columns.iter().skip(row.cells.len()).flatten().find(|column| column.required) {
        let found = cell_count(row.cells.len());
        problems.push(Problem::new(layout.file, row.line, column.name, found, cells_wanted(columns)));
    }
    let named = columns.iter().zip(&row.cells).filter_map(|(column, cell)| Some(((*column)?.name, cell.clone())));
    Some(Record { file: layout.file, line: row.line, cells: named.collect() })
}

fn cell_count(n: usize) -> String {
    format!("{n} {} in the row", if n == 1 { "cell" } else { "cells" })
}

/// How many cells a row should have, and which.
fn cells_wanted(columns: &[Option<Column>]) -> String {
    let most = columns.len();
    let least = columns.iter().rposition(|column| column.is_some_and(|column| column.required)).map_or(0, |last| last + 1);
    let count = if least == most { most.to_string() } else { format!("{least} to {most}") };
    let name = |column: &Option<Column>| match column {
        Some(Column { name, required: true }) => (*name).to_owned(),
        Some(Column { name, required: false }) => format!("[{name}]"),
        None => "?".to_owned(),
    };
    format!("{count}: {}", columns.iter().map(name).collect::<Vec<_>>().join(","))
}

fn report_faults(layout: Layout, columns: &[Option<Column>], row: &Row, problems: &mut Vec<Problem>) {
    for (i, cell) in row.cells.iter().enumerate() {
        let name = match columns.get(i) {
            Some(Some(column)) => column.name.to_owned(),
            _ if i == 0 => layout.first().to_owned(),
            _ => (i + 1).to_string(),
        };
        let (found, expected) = match cell.fault {
            None => continue,
            Some(Fault::Unclosed) => ("a quote that is never closed", "a closing quote"),
            Some(Fault::AfterQuote) => ("text after a closing quote", "a comma after it (a quote within quotes is written twice)"),
            Some(Fault::NotUtf8) => ("letters that are not UTF-8", "a file saved as UTF-8"),
            Some(Fault::Utf16) => ("a file saved as UTF-16", "a file saved as UTF-8"),
            Some(Fault::Workbook) => ("a spreadsheet's own file (xlsx, ods)", "a file that the spreadsheet saved as CSV"),
        };
        problems.push(Problem::new(layout.file, cell.line, name, found, expected));
    }
}

/// What a cell holds, in words.
fn found(cell: &Cell) -> String {
    if cell.is_empty() { "nothing".into() } else { quoted(cell.text.trim()) }
}

/// What stands in a cell, without the spaces around it: nothing of it is judged yet. A row may have no such cell: one that may be left out,
/// or one whose lack has been reported.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(from = "String")]
pub(super) struct CellText(Option<String>);

impl From<String> for CellText {
    fn from(text: String) -> Self {
        Self(Some(text))
    }
}

impl CellText {
    /// The text; `None` where the row has no such cell.
    pub fn as_str(&self) -> Option<&str> {
        self.0.as_deref()
    }

    /// Whether there is anything in it.
    pub fn is_given(&self) -> bool {
        self.as_str().is_some_and(|text| !text.is_empty())
    }
}

/// A cell of a row: its column's name and what stands there.
pub(super) type Given<'a> = (&'static str, &'a CellText);

/// A field of a row with its name, which is its column's: `cell!(row.mass)`.
macro_rules! cell {
    ($row:ident.$column:ident) => {
        (stringify!($column), &$row.$column)
    };
}
pub(super) use cell;

impl Record {
    /// The record's cells as a row of that type, whose fields are named like the columns. All its fields are [`CellText`] and may be missing,
    /// so that there is such a row whatever the author wrote, and all that is wrong with it can be told.
    pub fn row<T: DeserializeOwned + Default>(&self) -> T {
        let cells = self.cells.iter().map(|(name, cell)| (*name, cell.text.trim()));
        let (names, texts): (StringRecord, StringRecord) = cells.unzip();
        texts.deserialize(Some(&names)).unwrap_or_default()
    }

    /// A problem in one of the record's cells.
    pub fn problem(&self, column: &str, found: impl Into<String>, expected: impl Into<String>) -> Problem {
        let cell = self.cells.iter().find(|(name, _)| *name == column);
        Problem::new(self.file, cell.map_or(self.line, |(_, cell)| cell.line), column, found, expected)
    }

    /// The text of a required cell as `parse` understands it; `parse` answers with what is expected instead.
    pub fn parse<T>(
        &self,
        (column, text): Given,
        problems: &mut Vec<Problem>,
        parse: impl FnOnce(&str) -> Result<T, String>,
    ) -> Option<T> {
        let text = text.as_str()?;
        let found = || if text.is_empty() { "nothing".into() } else { quoted(text) };
        parse(text).map_err(|expected| problems.push(self.problem(column, found(), expected))).ok()
    }

    /// A number in its range.
    pub fn number(&self, cell: Given, quantity: Quantity, problems: &mut Vec<Problem>) -> Option<f64> {
        self.parse(cell, problems, |text| quantity.parse(text))
    }

    /// A number that may be left out.
    pub fn number_or(&self, cell: Given, default: f64, quantity: Quantity, problems: &mut Vec<Problem>) -> Option<f64> {
        if cell.1.is_given() { self.number(cell, quantity, problems) } else { Some(default) }
    }

    /// A whole number, both ends included.
    pub fn whole(&self, cell: Given, (low, high): (u32, u32), problems: &mut Vec<Problem>) -> Option<u32> {
        self.parse(cell, problems, |text| {
            let number = text.parse().ok().filter(|number| (low..=high).contains(number));
            number.ok_or_else(|| format!("a whole number from {low} to {high}"))
        })
    }

    /// TRUE or FALSE in any case.
    pub fn boolean(&self, cell: Given, problems: &mut Vec<Problem>) -> Option<bool> {
        self.parse(cell, problems, |text| match text.to_ascii_lowercase().as_str() {
            "true" => Ok(true),
            "false" => Ok(false),
            _ => Err("TRUE or FALSE".into()),
        })
    }

    /// Words: anything but nothing.
    pub fn words(&self, cell: Given, problems: &mut Vec<Problem>) -> Option<String> {
        self.parse(cell, problems, |text| if text.is_empty() { Err("text".into()) } else { Ok(text.to_owned()) })
    }
}
