//! A thing of a level with its row.

use super::problem::Problem;
use super::schema::record::RowCells;

#[derive(Clone, Debug)]
pub(super) struct FromRow<T> {
    pub file: &'static str,
    pub line: usize,
    pub item: T,
}

impl<T> FromRow<T> {
    pub fn new(record: &RowCells, item: T) -> Self {
        Self { file: record.schema.file.name, line: record.line, item }
    }

    pub fn map<U>(&self, make: impl FnOnce(&T) -> U) -> FromRow<U> {
        FromRow { file: self.file, line: self.line, item: make(&self.item) }
    }

    pub fn problem(&self, column: &str, found: impl Into<String>, expected: impl Into<String>) -> Problem {
        Problem::new(self.file, self.line, column, found, expected)
    }
}
