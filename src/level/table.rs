//! The column of each cell: headers, files without one, rows of several kinds.

use super::nearest::meant;
use super::problem::{MOST_PROBLEMS, Problem, quoted, too_many};
use super::schema::record::RowCells;
use super::schema::{Column, RowSchema};
use crate::files::{Cell, SpannedRow, csv_rows};
use crate::words::tr;

/// The most cells of a header. A file has less than a tenth of it as columns, and a message about a row names every cell of the header.
const MOST_COLUMNS: usize = 200;

/// The kinds of a file's rows; of several kinds the first cell names one.
type RowKinds = &'static [&'static RowSchema];

/// The columns of a row's cells; `None` for a cell whose column is not known.
pub(super) type Columns = Vec<Option<&'static Column>>;

#[derive(Debug, Default)]
pub(super) struct TableRows {
    /// The readable rows.
    pub records: Vec<RowCells>,
    /// The lines of all rows but the header, readable or not.
    pub lines: Vec<usize>,
}

#[derive(Clone, Debug)]
pub(super) struct HeaderPlan {
    /// The columns of all rows; none where each row has those of its kind.
    pub columns: Columns,
    /// How many rows at the beginning name columns.
    pub headers: usize,
}

pub(super) fn read(kinds: RowKinds, bytes: &[u8], problems: &mut Vec<Problem>) -> TableRows {
    let rows: Vec<SpannedRow> = csv_rows(bytes, true).collect();
    let plan = match plan(kinds, &rows, problems) {
        Ok(plan) => plan,
        Err(headers) => return TableRows { records: Vec::new(), lines: rows.iter().skip(headers).map(|row| row.line).collect() },
    };
    let (mut table, any) = (TableRows::default(), kinds[0]);
    let enough = problems.len() + MOST_PROBLEMS;
    for row in rows.iter().skip(plan.headers) {
        table.lines.push(row.line);
        if problems.len() >= enough {
            problems.push(too_many(any.file.name, row.line));
            break;
        }
        if let Some(problem) = wrong_separator(any, row) {
            problems.push(problem);
            break; // The rest of the file is like this row.
        }
        let first = &row.cells[0];
        match schema_of(kinds, first.text.trim()) {
            Some(schema) if kinds.len() > 1 => table.records.extend(record(schema, &all_columns(schema), row, problems)),
            Some(schema) => table.records.extend(record(schema, &plan.columns, row, problems)),
            None if first.fault.is_some() => report_faults(any, &[], row, problems),
            None => problems.push(unknown_kind(kinds, first)),
        }
    }
    table
}

pub(super) fn schema_of(kinds: RowKinds, first: &str) -> Option<&'static RowSchema> {
    kinds.iter().find(|schema| schema.tag.is_empty() || schema.tag.eq_ignore_ascii_case(first)).copied()
}

fn unknown_kind(kinds: RowKinds, first: &Cell) -> Problem {
    let (any, column) = (kinds[0], kinds[0].columns[0].name);
    let (found, expected) = if first.text.trim().eq_ignore_ascii_case(column) {
        let expected = tr!("{columns}: the columns of these rows never change places", columns = any.columns_text());
        (tr("a header with its columns in another order").to_owned(), expected)
    } else {
        let tags: Vec<&str> = kinds.iter().map(|schema| schema.tag).collect();
        (found(first), tr!("one of {list}", list = tags.join(", ")) + &meant(&first.text, tags))
    };
    Problem::new(any.file.name, first.line, column, found, expected)
}

pub(super) fn all_columns(schema: &'static RowSchema) -> Columns {
    schema.columns.iter().map(Some).collect()
}

/// Errors: the number of header rows of a file that is no table of this kind, which is reported.
pub(super) fn plan(kinds: RowKinds, rows: &[SpannedRow], problems: &mut Vec<Problem>) -> Result<HeaderPlan, usize> {
    if kinds.len() > 1 {
        return Ok(HeaderPlan { columns: Vec::new(), headers: rows.iter().take_while(|row| names_place(row)).count() });
    }
    let schema = kinds[0];
    let plain = Ok(HeaderPlan { columns: all_columns(schema), headers: 0 });
    let Some(first) = rows.first() else { return plain };
    if let Some(problem) = separator_said(schema, first) {
        problems.push(problem);
        return Err(0);
    }
    let used = first.cells.iter().rposition(|cell| !cell.is_empty()).map_or(0, |last| last + 1);
    let found = if is_foreign_header(schema, first) {
        let names: Vec<&str> = first.cells.iter().map(|cell| cell.text.trim()).filter(|name| !name.is_empty()).collect();
        tr!("a header of unknown names, {header}", header = quoted(&names.join(",")))
    } else if !is_header(schema, first) {
        return plain;
    } else if used > MOST_COLUMNS {
        tr!("{count} cells in the header", count = used)
    } else {
        return Ok(HeaderPlan { columns: header(schema, first, &first.cells[..used], problems), headers: 1 });
    };
    problems.push(schema.problem(first.line, found, schema.columns_wanted()));
    Err(1)
}

/// Whether a row of a file of several kinds names columns.
fn names_place(row: &SpannedRow) -> bool {
    let is_cell = |i: usize, name: &str| row.cells.get(i).is_some_and(|cell| cell.text.trim().eq_ignore_ascii_case(name));
    is_cell(1, "x") && is_cell(2, "y")
}

/// Whether a first row names columns: its first cell does, or at least two others do (then the first is a misspelt name).
fn is_header(schema: &RowSchema, row: &SpannedRow) -> bool {
    let named = |cell: &Cell| schema.find(&cell.text).is_some();
    row.cells.first().is_some_and(named) || row.cells.iter().filter(|cell| named(cell)).count() >= 2
}

/// Whether a first row is a header of unknown names: words in place of numbers.
fn is_foreign_header(schema: &RowSchema, row: &SpannedRow) -> bool {
    let letters = |cell: &Cell| cell.text.trim().chars().all(|c| c.is_alphabetic() || c == '_' || c == ' ');
    // Some programs write numbers as words, such as inf.
    let word = |cell: &Cell| cell.fault.is_none() && !cell.is_empty() && letters(cell) && cell.text.trim().parse::<f64>().is_err();
    let placed = schema.columns.first().is_some_and(|column| column.name == "x");
    let [x, y, ..] = &row.cells[..] else { return false };
    placed && !is_header(schema, row) && word(x) && word(y)
}

/// The problem of a first row `sep=;`, by which some spreadsheets say how cells are separated.
fn separator_said(schema: &RowSchema, row: &SpannedRow) -> Option<Problem> {
    let said = row.cells[0].text.trim().to_lowercase();
    let separator = said.strip_prefix("sep=")?;
    Some(schema.problem(row.line, quoted(&format!("sep={separator}")), commas_wanted()))
}

fn commas_wanted() -> &'static str {
    tr("cells separated by commas, numbers with a decimal point")
}

/// The columns in the order of the header; `None` for one that is not known.
fn header(schema: &'static RowSchema, row: &SpannedRow, cells: &[Cell], problems: &mut Vec<Problem>) -> Columns {
    let mut columns = Columns::new();
    let has = |columns: &Columns, column: &Column| columns.iter().flatten().any(|known| known.name == column.name);
    for cell in cells {
        let known = schema.find(&cell.text);
        let mut report = |found: &str, expected: String| {
            problems.push(Problem::new(schema.file.name, cell.line, cell.text.trim(), found, expected));
        };
        match known {
            None => report(tr("an unknown column"), schema.wanted(&cell.text)),
            Some(column) if has(&columns, column) => report(tr("the same column twice"), tr("each column once").into()),
            Some(_) => {}
        }
        columns.push(known.filter(|column| !has(&columns, column)));
    }
    for missing in schema.columns.iter().filter(|column| column.required && !has(&columns, column)) {
        let expected = schema.columns_wanted();
        problems.push(Problem::new(schema.file.name, row.line, missing.name, tr("no such column in the header"), expected));
    }
    columns
}

/// The problem of a row with semicolons or tabs between its cells, as some spreadsheets write them.
fn wrong_separator(schema: &RowSchema, row: &SpannedRow) -> Option<Problem> {
    let required = schema.columns.iter().filter(|column| column.required).count();
    let count = |separator| row.cells.iter().map(|cell| cell.text.matches(separator).count()).sum::<usize>();
    if row.cells.len() >= required {
        return None;
    }
    let separator = [(';', tr("semicolons")), ('\t', tr("tabs"))].into_iter().find(|(c, _)| count(*c) + 1 >= required)?.1;
    let found = tr!("cells separated by {separator}", separator);
    Some(schema.problem(row.line, found, commas_wanted()))
}

/// The row's cells by column; `None` where the row is broken.
fn record(schema: &'static RowSchema, columns: &Columns, row: &SpannedRow, problems: &mut Vec<Problem>) -> Option<RowCells> {
    if row.cells.iter().any(|cell| cell.fault.is_some()) {
        report_faults(schema, columns, row, problems);
        return None;
    }
    let file = schema.file.name;
    if let Some(extra) = row.cells.iter().skip(columns.len()).rposition(|cell| !cell.is_empty()) {
        let (first, found) = (&row.cells[columns.len()], cell_count(columns.len() + extra + 1));
        let name = (columns.len() + 1).to_string();
        let expected =
            cells_wanted(columns) + tr(" (a cell that holds a comma stands in quotes, decimals are written with a point)");
        problems.push(Problem::new(file, first.line, name, found, expected));
    }
    if let Some(column) = columns.iter().skip(row.cells.len()).flatten().find(|column| column.required) {
        problems.push(Problem::new(file, row.line, column.name, cell_count(row.cells.len()), cells_wanted(columns)));
    }
    let named = columns.iter().zip(&row.cells).filter_map(|(column, cell)| Some(((*column)?.name, cell.clone())));
    Some(RowCells { schema, line: row.line, cells: named.collect(), is_settings: false })
}

fn cell_count(n: usize) -> String {
    if n == 1 { tr("1 cell in the row").to_owned() } else { tr!("{count} cells in the row", count = n) }
}

fn cells_wanted(columns: &Columns) -> String {
    let most = columns.len();
    let least = columns.iter().rposition(|column| column.is_some_and(|column| column.required)).map_or(0, |last| last + 1);
    let count = if least == most { most.to_string() } else { tr!("{least} to {most}", least, most) };
    let name = |column: &Option<&Column>| column.map_or_else(|| "?".to_owned(), Column::in_brackets);
    format!("{count}: {}", columns.iter().map(name).collect::<Vec<_>>().join(","))
}

fn report_faults(schema: &RowSchema, columns: &[Option<&Column>], row: &SpannedRow, problems: &mut Vec<Problem>) {
    for (i, cell) in row.cells.iter().enumerate() {
        let name = match columns.get(i) {
            Some(Some(column)) => column.name.to_owned(),
            _ if i == 0 => schema.columns[0].name.to_owned(),
            _ => (i + 1).to_string(),
        };
        let Some(fault) = cell.fault else { continue };
        let (found, expected) = fault.words();
        problems.push(Problem::new(schema.file.name, cell.line, name, found, expected));
    }
}

fn found(cell: &Cell) -> String {
    if cell.is_empty() { tr("nothing").into() } else { quoted(cell.text.trim()) }
}
