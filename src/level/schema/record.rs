//! A row whose cells have found their columns, and the state that all readers of rows share.

use super::facts::{Column, Holds, RowSchema};
use super::typed::Row;
use crate::files::{Cell, Dialect};
use crate::level::image::Images;
use crate::level::numbers::PixelScale;
use crate::level::problem::{Problem, quoted};
use crate::words::tr;
use csv::StringRecord;

/// A row's cells by column; or the settings of constants.csv, each a cell by its name.
#[derive(Clone, Debug)]
pub(in crate::level) struct RowCells {
    pub schema: &'static RowSchema,
    pub dialect: Dialect,
    pub line: usize,
    pub cells: Vec<(&'static str, Cell)>,
    /// The cells are the values of settings.
    pub is_settings: bool,
}

impl RowCells {
    /// Without the spaces around it; `None` where the row has no such cell: it may be left out, or its lack is reported.
    pub fn text(&self, column: &str) -> Option<&str> {
        self.cell(column).map(|cell| cell.text.trim())
    }

    fn cell(&self, column: &str) -> Option<&Cell> {
        self.cells.iter().find(|(name, _)| *name == column).map(|(_, cell)| cell)
    }

    /// The line of a cell; of the row where it has no such cell.
    pub fn line_of(&self, column: &str) -> usize {
        self.cell(column).map_or(self.line, |cell| cell.line)
    }

    pub fn problem(&self, column: &str, found: impl Into<String>, expected: impl Into<String>) -> Problem {
        let (file, line) = (self.schema.file.name, self.line_of(column));
        if self.is_settings {
            return Problem::new(file, line, "value", tr!("{found} for {column}", found = found.into(), column), expected);
        }
        Problem::new(file, line, column, found, expected)
    }

    /// `None` where a cell is refused, which is reported, as are all others of the row.
    pub fn read<T: Row>(&self, reader: &mut RowReader) -> Option<T> {
        let (row, whole) = self.read_cells(reader);
        row.filter(|_| whole)
    }

    /// As [`RowCells::read`]; a column's usual text stands in for a refused cell.
    pub fn read_or_usual<T: Row>(&self, reader: &mut RowReader) -> Option<T> {
        self.read_cells(reader).0
    }

    /// The row, and whether it has all its cells from its author.
    fn read_cells<T: Row>(&self, reader: &mut RowReader) -> (Option<T>, bool) {
        let mut whole = true;
        let cells: Vec<Option<String>> = T::COLUMNS.iter().map(|column| self.plain(column, reader, &mut whole)).collect();
        let Some(record) = cells.into_iter().collect::<Option<StringRecord>>() else { return (None, false) };
        // Of good cells serde refuses none; whatever it does refuse has a line.
        let refused = |error: csv::Error| reader.problems.push(self.problem(T::COLUMNS[0].name, error.to_string(), tr("text")));
        (record.deserialize(None).map_err(refused).ok(), whole)
    }

    /// A cell as serde reads it; `None` where it lacks or is refused, which is reported, and nothing stands in for it.
    fn plain(&self, column: &'static Column, reader: &mut RowReader, whole: &mut bool) -> Option<String> {
        let usual = || column.holds.plain(column.usual).into_owned();
        let text = match self.text(column.name) {
            None if column.required => return None,
            None => return Some(usual()),
            Some("") if column.may_be_empty => return Some(usual()),
            Some(text) => text,
        };
        let plain = column.holds.in_plain_dialect(self.dialect, text);
        let found = || if text.is_empty() { tr("nothing").into() } else { quoted(text) };
        let judged = match column.holds {
            Holds::Picture { .. } => reader.images.look(text, reader.scale).map(drop),
            holds => holds.judge(&plain, reader.scale).map_err(|expected| (found(), expected)),
        };
        let Err((found, expected)) = judged else { return Some(column.holds.plain(&plain).into_owned()) };
        reader.problems.push(self.problem(column.name, found, expected));
        if let (Holds::Picture { of_body: true }, Some(stand_in)) = (column.holds, reader.images.stand_in) {
            return Some(stand_in.to_owned());
        }
        *whole = false;
        Some(usual()).filter(|_| !column.required)
    }
}

pub(in crate::level) struct RowReader<'a> {
    pub scale: PixelScale,
    pub images: Images<'a>,
    pub problems: Vec<Problem>,
}
