//! A row whose cells have found their columns, and the state that all readers of rows share.

use super::facts::{Holds, RowSchema};
use crate::files::Cell;
use crate::level::image::Images;
use crate::level::numbers::PixelScale;
use crate::level::problem::{Problem, quoted};
use crate::words::tr;

/// A row's cells by column; or the settings of constants.csv, each a cell by its name.
#[derive(Clone, Debug)]
pub(in crate::level) struct RowCells {
    pub schema: &'static RowSchema,
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
}

pub(in crate::level) struct RowReader<'a> {
    pub scale: PixelScale,
    pub images: Images<'a>,
    pub problems: Vec<Problem>,
}

pub(in crate::level) struct AskedCell<'a> {
    pub record: &'a RowCells,
    pub column: &'static str,
    pub text: &'a str,
    pub holds: Holds,
}

impl AskedCell<'_> {
    /// The value; an error is reported as the expected text.
    pub fn or_refuse<T>(&self, reader: &mut RowReader, value: Result<T, String>) -> Option<T> {
        let found = || if self.text.is_empty() { tr("nothing").into() } else { quoted(self.text) };
        value.map_err(|expected| reader.problems.push(self.record.problem(self.column, found(), expected))).ok()
    }
}
