//! Operations as bytes in place of others: carried out, taken back, and joined where they belong to one gesture.

use super::sheet::{Sheet, Splice, difference, put_back};
use super::{Document, Table};

/// What one operation has changed in a file.
#[derive(Clone, Debug)]
pub(super) struct FileChange {
    table: Table,
    /// Whether there is such a file, before and after.
    exists: [bool; 2],
    splices: Vec<Splice>,
}

/// What one operation has changed.
#[derive(Clone, Debug)]
pub(super) struct Change {
    files: Vec<FileChange>,
    /// Operations of the same gesture are one: dragging a thing, typing into a cell.
    pub gesture: Option<u64>,
}

impl FileChange {
    /// Of a file that is there afterwards.
    pub fn of(sheet: &Sheet, splices: Vec<Splice>) -> Self {
        Self { table: sheet.table, exists: [sheet.exists, sheet.exists || !splices.is_empty()], splices }
    }
}

impl Document {
    /// Takes over a file as another program has left it: an operation like any other.
    pub fn replace(&mut self, table: Table, bytes: Option<Vec<u8>>) {
        let mut all = self.all_bytes();
        all[table.index()] = bytes;
        self.replace_all(all);
    }

    /// What all files hold, by [`Table`].
    pub(super) fn all_bytes(&self) -> Vec<Option<Vec<u8>>> {
        Table::ALL.iter().map(|table| self.bytes(*table).map(<[u8]>::to_vec)).collect()
    }

    /// A file as it was before the gesture of that number began.
    pub(super) fn before(&self, table: Table, gesture: Option<u64>) -> Sheet {
        let sheet = self.sheet(table);
        let same = |change: &&Change| gesture.is_some() && change.gesture == gesture;
        let begun = self.undo.last().filter(same).and_then(|change| change.files.iter().find(|file| file.table == table));
        let Some(FileChange { exists, splices, .. }) = begun else { return sheet.clone() };
        let mut bytes = sheet.bytes.clone();
        put_back(&mut bytes, splices);
        Sheet::new(table, exists[0].then_some(bytes))
    }

    /// Makes all files hold these bytes, by [`Table`].
    pub(super) fn replace_all(&mut self, files: Vec<Option<Vec<u8>>>) {
        let changed = Table::ALL.iter().zip(files).filter_map(|(table, bytes)| {
            let sheet = self.sheet(*table);
            let same = sheet.exists == bytes.is_some();
            let splice = difference(&sheet.bytes, bytes.as_deref().unwrap_or_default());
            let splices: Vec<Splice> = splice.into_iter().collect();
            (!same || !splices.is_empty()).then_some(FileChange { table: *table, exists: [sheet.exists, bytes.is_some()], splices })
        });
        let files = changed.collect();
        self.apply(files, None);
    }

    /// Takes the last operation back; whether there was one.
    pub fn undo(&mut self) -> bool {
        let Some(change) = self.undo.pop() else { return false };
        self.take_back(&change);
        self.redo.push(change);
        true
    }

    /// Does again what was undone last; whether there was something.
    pub fn redo(&mut self) -> bool {
        let Some(change) = self.redo.pop() else { return false };
        self.carry_out(&change);
        self.undo.push(change);
        true
    }

    /// How many operations can be undone, and how many done again.
    pub fn history(&self) -> (usize, usize) {
        (self.undo.len(), self.redo.len())
    }

    pub(super) fn apply(&mut self, mut files: Vec<FileChange>, gesture: Option<u64>) {
        files.retain(|file| !file.splices.is_empty() || file.exists[0] != file.exists[1]);
        if files.is_empty() {
            return;
        }
        for file in &mut files {
            // From the end to the beginning: no splice moves what a later one is about.
            file.splices.sort_by_key(|splice| std::cmp::Reverse(splice.at));
        }
        let change = Change { files, gesture };
        self.carry_out(&change);
        self.redo.clear();
        if gesture.is_some() && self.undo.last().is_some_and(|last| last.gesture == gesture) {
            self.join(change);
        } else {
            self.undo.push(change);
        }
    }

    /// Makes one of the last change and another of the same gesture, which has been carried out: however long a gesture takes, what is kept of
    /// it is where it began and where it is.
    fn join(&mut self, next: Change) {
        let Some(last) = self.undo.pop() else { return };
        let mut files: Vec<FileChange> = Vec::new();
        for FileChange { table, exists, .. } in last.files.iter().chain(&next.files) {
            if files.iter().any(|known| known.table == *table) {
                continue;
            }
            let now = self.sheet(*table);
            let mut before = now.bytes.clone();
            for change in [&next, &last] {
                let own = change.files.iter().filter(|file| file.table == *table);
                own.for_each(|file| put_back(&mut before, &file.splices));
            }
            let splices: Vec<Splice> = difference(&before, &now.bytes).into_iter().collect();
            if !splices.is_empty() || exists[0] != now.exists {
                files.push(FileChange { table: *table, exists: [exists[0], now.exists], splices });
            }
        }
        if !files.is_empty() {
            self.undo.push(Change { files, gesture: last.gesture });
        }
    }

    fn carry_out(&mut self, change: &Change) {
        for FileChange { table, exists, splices } in &change.files {
            let sheet = &mut self.sheets[table.index()];
            sheet.exists = exists[1];
            sheet.apply(splices);
            self.measure_table(*table);
        }
        self.version += 1;
    }

    fn take_back(&mut self, change: &Change) {
        for FileChange { table, exists, splices } in change.files.iter().rev() {
            let sheet = &mut self.sheets[table.index()];
            sheet.exists = exists[0];
            sheet.take_back(splices);
            self.measure_table(*table);
        }
        self.version += 1;
    }
}
