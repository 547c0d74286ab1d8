//! The column of each cell: headers, files without one, rows of several kinds.

use super::problem::{MOST_PROBLEMS, Problem, meant, quoted, too_many};
use super::schema::{Column, Holds, Kind, RowSchema, SETTINGS};
use super::{numbers::PixelScale, schema::settings::SETTING, schema::typed::RowCells};
use crate::files::{Cell, CellFault, CsvRows, Dialect, SpannedRow, csv_rows, separators};
use crate::words::tr;

/// The most cells of a header: a tenth are more than a file's columns, and a message about a row names every cell of the header.
const MOST_COLUMNS: usize = 200;

/// The kinds of a file's rows; of several kinds the first cell names one.
type RowKinds = &'static [&'static RowSchema];

/// The columns of a row's cells; `None` for a cell whose column is not known.
pub(super) type HeaderColumns = Vec<Option<&'static Column>>;

#[derive(Debug, Default)]
pub(super) struct TableRows {
    pub records: Vec<RowCells>,
    /// The lines of all rows but the header, readable or not.
    pub lines: Vec<usize>,
    /// `None` without a file.
    pub dialect: Option<Dialect>,
}

#[derive(Clone, Debug)]
pub(super) struct HeaderPlan {
    /// The columns of all rows; none where each row has those of its kind.
    pub columns: HeaderColumns,
    pub headers: usize,
}

/// The rows of a file, headers among them.
pub(super) fn rows(kinds: RowKinds, bytes: &[u8]) -> CsvRows {
    csv_rows(bytes, true, kinds[0].columns.len(), &|dialect, rows| suits(kinds, dialect, rows))
}

pub(super) fn read(kinds: RowKinds, bytes: &[u8], problems: &mut Vec<Problem>) -> TableRows {
    let reader = rows(kinds, bytes);
    let dialect = reader.dialect;
    let rows: Vec<SpannedRow> = reader.collect();
    let (mut table, any) = (TableRows { dialect: Some(dialect), ..TableRows::default() }, kinds[0]);
    let plan = match plan(kinds, &rows, problems) {
        Ok(plan) => plan,
        Err(headers) => {
            table.lines = rows.iter().skip(headers).map(|row| row.line).collect();
            return table;
        }
    };
    let enough = problems.len() + MOST_PROBLEMS;
    for row in rows.iter().skip(plan.headers) {
        table.lines.push(row.line);
        if problems.len() >= enough {
            problems.push(too_many(any.file.name, row.line));
            break;
        }
        if let Some(problem) = wrong_separator(any, dialect, row) {
            problems.push(problem);
            break; // The rest of the file is like this row.
        }
        let first = &row.cells[0];
        match schema_of(kinds, first.text.trim()) {
            Some(schema) if kinds.len() > 1 => table.records.extend(record(schema, dialect, &all_columns(schema), row, problems)),
            Some(schema) => table.records.extend(record(schema, dialect, &plan.columns, row, problems)),
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
    if first.text.trim().eq_ignore_ascii_case(column) {
        return moved_header(any, first.line);
    }
    let tags: Vec<&str> = kinds.iter().map(|schema| schema.tag).collect();
    let expected = tr!("one of {list}", list = tags.join(", ")) + &meant(&first.text, tags);
    Problem::new(any.file.name, first.line, column, found(first), expected)
}

fn moved_header(schema: &RowSchema, line: usize) -> Problem {
    let expected = tr!("{columns}: the columns of these rows never change places", columns = schema.columns_text());
    schema.problem(line, tr("a header with its columns in another order"), expected)
}

/// The kind whose column a header of rows of several kinds names in a place where no kind has it.
fn moved(kinds: RowKinds, header: &SpannedRow) -> Option<&'static RowSchema> {
    let is = |schema: &RowSchema, i: usize, cell: &Cell| {
        schema.columns.get(i).is_some_and(|column| column.name.eq_ignore_ascii_case(cell.text.trim()))
    };
    let mut strays = header.cells.iter().enumerate().filter(|(i, cell)| !kinds.iter().any(|schema| is(schema, *i, cell)));
    strays.find_map(|(_, cell)| kinds.iter().find(|schema| schema.find(&cell.text).is_some())).copied()
}

pub(super) fn all_columns(schema: &'static RowSchema) -> HeaderColumns {
    schema.columns.iter().map(Some).collect()
}

/// Errors: the number of header rows of a file that is no table of this kind, which is reported.
pub(super) fn plan(kinds: RowKinds, rows: &[SpannedRow], problems: &mut Vec<Problem>) -> Result<HeaderPlan, usize> {
    if kinds.len() > 1 {
        let headers = rows.iter().take_while(|row| names_place(row)).count();
        let moved = rows[..headers].iter().filter_map(|row| Some(moved_header(moved(kinds, row)?, row.line)));
        problems.extend(moved);
        return Ok(HeaderPlan { columns: Vec::new(), headers });
    }
    let schema = kinds[0];
    let plain = Ok(HeaderPlan { columns: all_columns(schema), headers: 0 });
    let Some(first) = rows.first() else { return plain };
    let used = first.cells.iter().rposition(|cell| !cell.is_empty()).map_or(0, |last| last + 1);
    let names = first.cells.iter().map(|cell| cell.text.trim()).filter(|name| !name.is_empty());
    let found = if is_foreign_header(schema, first) {
        tr!("a header of unknown names, {header}", header = quoted(&names.collect::<Vec<_>>().join(",")))
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

/// The columns in the order of the header; `None` for one that is not known.
fn header(schema: &'static RowSchema, row: &SpannedRow, cells: &[Cell], problems: &mut Vec<Problem>) -> HeaderColumns {
    let mut columns = HeaderColumns::new();
    let has = |columns: &HeaderColumns, column: &Column| columns.iter().flatten().any(|known| known.name == column.name);
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

/// How well rows suit a file in a dialect: the cells that name columns or hold good values, less the others.
fn suits(kinds: RowKinds, dialect: Dialect, rows: &[SpannedRow]) -> i64 {
    let Ok(plan) = plan(kinds, rows, &mut Vec::new()) else { return 0 };
    let (headers, rows) = rows.split_at(plan.headers);
    let is_named = |cell: &Cell| kinds.iter().any(|schema| schema.find(&cell.text).is_some());
    let named = headers.iter().flat_map(|row| &row.cells).filter(|cell| !cell.is_empty()).map(is_named);
    let good = rows.iter().flat_map(|row| {
        let columns = match schema_of(kinds, row.cells[0].text.trim()) {
            Some(schema) if kinds.len() > 1 => all_columns(schema),
            Some(_) => plan.columns.clone(),
            None => HeaderColumns::new(),
        };
        let cells = row.cells.iter().enumerate().filter(|(_, cell)| !cell.is_empty());
        cells.map(move |(i, cell)| is_good(columns.get(i).copied().flatten(), dialect, row, cell))
    });
    named.chain(good).map(|good| if good { 1 } else { -1 }).sum()
}

fn is_good(column: Option<&'static Column>, dialect: Dialect, row: &SpannedRow, cell: &Cell) -> bool {
    let Some(held) = column.and_then(|column| held(column, row.cells[0].text.trim())) else { return false };
    let text = cell.text.trim();
    cell.fault.is_none() && held.judge(&held.in_plain_dialect(dialect, text), PixelScale::USUAL).is_ok()
}

/// What a row's cell holds by its column; in constants.csv by the setting that its first cell names, and `None` where that is no setting.
pub(super) fn held(column: &'static Column, first: &str) -> Option<Holds> {
    if !SETTING.columns.iter().any(|own| std::ptr::eq(own, column)) {
        return Some(column.holds);
    }
    let setting = SETTINGS.iter().find(|setting| setting.name.eq_ignore_ascii_case(first))?;
    Some(if column.name == "value" { setting.holds } else { column.holds })
}

/// The problem of a row whose cells are separated otherwise than in the rest of the file, or by what no file is read with.
fn wrong_separator(schema: &RowSchema, dialect: Dialect, row: &SpannedRow) -> Option<Problem> {
    let required = schema.columns.iter().filter(|column| column.required).count();
    if row.cells.len() >= required {
        return None;
    }
    let signs = |sign: u8| row.cells.iter().flat_map(|cell| cell.text.bytes()).filter(|byte| *byte == sign).count();
    let others = Dialect::DELIMITERS.into_iter().filter(|delimiter| *delimiter != dialect.delimiter);
    let separator = others.chain([b'|', b':']).find(|separator| signs(*separator) + row.cells.len() >= required)?;
    let sign = char::from(separator).to_string();
    let found = tr!("cells separated by {separator}", separator = separators(separator).unwrap_or(&sign));
    let expected = match separators(separator) {
        Some(_) => tr!("cells separated by {separator}, as in the rest of the file", separator = separators(dialect.delimiter)?),
        None => CellFault::Separator.words().1.to_owned(),
    };
    Some(schema.problem(row.line, found, expected))
}

/// The row's cells by column; `None` where the row is broken.
fn record(
    schema: &'static RowSchema,
    dialect: Dialect,
    columns: &HeaderColumns,
    row: &SpannedRow,
    problems: &mut Vec<Problem>,
) -> Option<RowCells> {
    if row.cells.iter().any(|cell| cell.fault.is_some()) {
        report_faults(schema, columns, row, problems);
        return None;
    }
    let file = schema.file.name;
    if let Some(extra) = row.cells.iter().skip(columns.len()).rposition(|cell| !cell.is_empty()) {
        let (first, found) = (&row.cells[columns.len()], cell_count(columns.len() + extra + 1));
        let more = tr(" (a cell that holds a comma stands in quotes, decimals are written with a point)");
        problems.push(Problem::new(file, first.line, &(columns.len() + 1).to_string(), found, cells_wanted(columns) + more));
    }
    if let Some(column) = columns.iter().skip(row.cells.len()).flatten().find(|column| column.required) {
        let expected = cells_wanted(columns) + &meant_row(schema, row);
        problems.push(Problem::new(file, row.line, column.name, cell_count(row.cells.len()), expected));
    }
    let named = columns.iter().zip(&row.cells).filter_map(|(column, cell)| Some(((*column)?.name, cell.clone())));
    Some(RowCells { schema, dialect, line: row.line, cells: named.collect(), is_settings: false })
}

/// What a row of too few cells, all of them numbers, is in other games and in the first version of the original; else empty.
fn meant_row(schema: &RowSchema, row: &SpannedRow) -> String {
    let mut cells = row.cells.iter().filter(|cell| !cell.is_empty());
    let numbers = cells.clone().all(|cell| cell.text.trim().parse::<f64>().is_ok());
    match (cells.next(), row.cells.len()) {
        (Some(number), 1) if numbers && std::ptr::eq(schema, &SETTING) => tr!(
            "; a name says what the number is, such as gravity,{number} or air_density,{number} or optimal_time,{number}",
            number = number.text.trim()
        ),
        (Some(_), _) if numbers && std::ptr::eq(schema, Kind::Object.schema()) => {
            tr!("; the ship stands in player.csv: {columns}", columns = Kind::Ship.schema().columns_text())
        }
        _ => String::new(),
    }
}

fn cell_count(n: usize) -> String {
    if n == 1 { tr("1 cell in the row").to_owned() } else { tr!("{count} cells in the row", count = n) }
}

fn cells_wanted(columns: &HeaderColumns) -> String {
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
        problems.push(Problem::new(schema.file.name, cell.line, &name, found, expected));
    }
}

fn found(cell: &Cell) -> String {
    if cell.is_empty() { tr("nothing").into() } else { quoted(cell.text.trim()) }
}
