//! Carries operations out, undoes them, and joins the operations of one gesture.

use super::change::{ByteChange, EditChange};
use super::model::Document;
use super::sheet::EditedFile;
use crate::level::schema::Table;
use std::collections::BTreeSet;

/// Files and their new bytes; `None` removes a file.
type Contents = Vec<(Table, Option<Vec<u8>>)>;

impl Document {
    /// Takes over a file that another program has written: an operation like any other.
    pub fn replace(&mut self, table: Table, bytes: Option<Vec<u8>>) {
        self.apply(vec![(table, bytes)], None);
    }

    /// By [`Table`].
    pub(super) fn all_bytes(&self) -> Vec<Option<Vec<u8>>> {
        Table::ALL.iter().map(|table| self.bytes(*table).map(<[u8]>::to_vec)).collect()
    }

    /// By [`Table`].
    pub(super) fn replace_all(&mut self, files: Vec<Option<Vec<u8>>>) {
        self.apply(Table::ALL.iter().copied().zip(files).collect(), None);
    }

    /// The last operation, if it is of that gesture.
    fn begun(&self, gesture: Option<u64>) -> Option<&EditChange> {
        self.undo.last().filter(|change| gesture.is_some() && change.gesture == gesture)
    }

    fn bytes_before(&self, table: Table, gesture: Option<u64>) -> Option<Vec<u8>> {
        let (now, begun) = (self.bytes(table), self.begun(gesture));
        let change = begun.and_then(|change| change.files.iter().find(|file| file.table == table));
        change.map_or_else(|| now.map(<[u8]>::to_vec), |change| change.undone(now))
    }

    /// A file as it was before the gesture began.
    pub(super) fn before(&self, table: Table, gesture: Option<u64>) -> EditedFile {
        EditedFile::new(table, self.bytes_before(table, gesture))
    }

    /// Returns whether there was an operation to undo.
    pub fn undo(&mut self) -> bool {
        let Some(change) = self.undo.pop() else { return false };
        self.write(change.files.iter().map(|file| (file.table, file.undone(self.bytes(file.table)))).collect());
        self.redo.push(change);
        true
    }

    /// Returns whether there was an operation to redo.
    pub fn redo(&mut self) -> bool {
        let Some(change) = self.redo.pop() else { return false };
        self.write(change.files.iter().map(|file| (file.table, file.redone(self.bytes(file.table)))).collect());
        self.undo.push(change);
        true
    }

    /// The numbers of operations to undo and to redo.
    pub fn history(&self) -> (usize, usize) {
        (self.undo.len(), self.redo.len())
    }

    /// All changes of one gesture make one operation.
    pub(super) fn apply(&mut self, mut files: Contents, gesture: Option<u64>) {
        files.retain(|(table, bytes)| self.bytes(*table) != bytes.as_deref());
        if files.is_empty() {
            return;
        }
        let begun = self.begun(gesture).into_iter().flat_map(|change| &change.files);
        let tables: BTreeSet<Table> = files.iter().map(|(table, _)| *table).chain(begun.map(|file| file.table)).collect();
        let before: Contents = tables.into_iter().map(|table| (table, self.bytes_before(table, gesture))).collect();
        if self.begun(gesture).is_some() {
            self.undo.pop();
        }
        self.write(files);
        self.redo.clear();
        let changed = before.into_iter().filter_map(|(table, old)| ByteChange::between(table, old.as_deref(), self.bytes(table)));
        let files: Vec<ByteChange> = changed.collect();
        if !files.is_empty() {
            self.undo.push(EditChange { files, gesture });
        }
    }

    fn write(&mut self, files: Contents) {
        for (table, bytes) in files {
            self.sheets[table.index()] = EditedFile::new(table, bytes);
            self.measure_table(table);
        }
        self.version += 1;
    }
}
