//! The reader of a level's files: their bytes, their rows, the things of the rows.

use super::image::{Files, Images};
use super::numbers::PixelScale;
use super::problem::Problem;
use super::schema::Table;
use super::schema::typed::{FromRow, RowCells, RowReader};
use super::table::{self, TableRows};
use crate::words::tr;
use std::io;

pub(super) struct LevelReader<'a> {
    pub files: &'a dyn Files,
    pub rows: RowReader<'a>,
    pub warnings: Vec<Problem>,
    /// In words, of the files that are no UTF-8 with commas.
    pub dialects: Vec<(&'static str, String)>,
}

impl<'a> LevelReader<'a> {
    /// In an unfinished level a box stands in for a missing picture.
    pub fn new(files: &'a dyn Files, unfinished: bool) -> Self {
        let rows = RowReader { scale: PixelScale::USUAL, images: Images::new(files, unfinished), problems: Vec::new() };
        Self { files, rows, warnings: Vec::new(), dialects: Vec::new() }
    }

    /// `None` where there is no such file, or where it cannot be read, which is reported.
    fn bytes(&mut self, table: Table) -> Option<Vec<u8>> {
        match self.files.level_file(table.file()) {
            Ok(bytes) => Some(bytes),
            Err(error) if error.kind() == io::ErrorKind::NotFound => None,
            Err(error) => {
                let found = tr!("a file that cannot be read ({error})", error);
                self.rows.problems.push(table.rows()[0].problem(1, found, tr("a readable file")));
                None
            }
        }
    }

    /// The rows of a file that a level must have; `expected` names these rows.
    pub fn required(&mut self, table: Table, expected: &str) -> Option<TableRows> {
        let before = self.rows.problems.len();
        let bytes = self.bytes(table);
        if bytes.is_none() && self.rows.problems.len() == before {
            self.rows.problems.push(table.rows()[0].problem(1, tr("no file"), expected));
        }
        Some(self.read(table, &bytes?))
    }

    /// The rows of an optional file.
    pub fn table(&mut self, table: Table) -> TableRows {
        self.bytes(table).map_or_else(TableRows::default, |bytes| self.read(table, &bytes))
    }

    fn read(&mut self, table: Table, bytes: &[u8]) -> TableRows {
        let rows = table::read(table.rows(), bytes, &mut self.rows.problems);
        self.dialects.extend(rows.dialect.and_then(|dialect| Some((table.file(), dialect.words()?))));
        rows
    }

    pub fn things<T>(&mut self, table: Table, read: fn(&RowCells, &mut RowReader) -> Option<T>) -> Vec<FromRow<T>> {
        let records = self.table(table).records;
        records.iter().filter_map(|record| Some(FromRow::new(record, read(record, &mut self.rows)?))).collect()
    }
}
