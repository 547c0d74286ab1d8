//! The files of a level as they are read, one after the other.

use super::image::Images;
use super::numbers::PixelScale;
use super::placed::FromRow;
use super::problem::Problem;
use super::schema::Table;
use super::schema::record::{RowCells, RowReader};
use super::source::Files;
use super::table::{self, TableRows};
use std::io;

pub(super) struct LevelReader<'a> {
    pub files: &'a dyn Files,
    pub rows: RowReader<'a>,
    pub warnings: Vec<Problem>,
}

impl<'a> LevelReader<'a> {
    /// Of these files; in a level that is not finished a box stands in for a picture that is missing.
    pub fn new(files: &'a dyn Files, unfinished: bool) -> Self {
        let rows = RowReader { scale: PixelScale::USUAL, images: Images::new(files, unfinished), problems: Vec::new() };
        Self { files, rows, warnings: Vec::new() }
    }

    /// A file's bytes; `None` where there is none or where it cannot be read, which is reported.
    fn bytes(&mut self, table: Table) -> Option<Vec<u8>> {
        match self.files.level_file(table.file()) {
            Ok(bytes) => Some(bytes),
            Err(error) if error.kind() == io::ErrorKind::NotFound => None,
            Err(error) => {
                let found = format!("a file that cannot be read ({error})");
                self.rows.problems.push(table.rows()[0].problem(1, found, "a readable file"));
                None
            }
        }
    }

    /// The rows of a file that has to be there; `expected` says with which rows.
    pub fn required(&mut self, table: Table, expected: &str) -> Option<TableRows> {
        let before = self.rows.problems.len();
        let bytes = self.bytes(table);
        if bytes.is_none() && self.rows.problems.len() == before {
            self.rows.problems.push(table.rows()[0].problem(1, "no file", expected));
        }
        Some(table::read(table.rows(), &bytes?, &mut self.rows.problems))
    }

    /// The rows of a file that may be missing.
    pub fn table(&mut self, table: Table) -> TableRows {
        let Some(bytes) = self.bytes(table) else { return TableRows::default() };
        let rows = table::read(table.rows(), &bytes, &mut self.rows.problems);
        if rows.lines.is_empty() {
            self.warnings.push(table.rows()[0].problem(1, "no row in the file", "at least one row, or no file"));
        }
        rows
    }

    /// The things of a file that may be missing.
    pub fn things<T>(&mut self, table: Table, read: fn(&RowCells, &mut RowReader) -> Option<T>) -> Vec<FromRow<T>> {
        let records = self.table(table).records;
        records.iter().filter_map(|record| Some(FromRow::new(record, read(record, &mut self.rows)?))).collect()
    }
}
