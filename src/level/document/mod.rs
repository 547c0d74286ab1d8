//! A level as it is edited: its CSV files, byte for byte, and operations on their rows that can be undone without end. What an operation
//! is not about stays as its author wrote it: comments, blank lines, the order of rows and columns, line ends, the forms of numbers.
//!
//! `sheet` is one file and what an edit replaces in it; `kinds` says what there is to add and what columns mean; `places` turns cells into
//! rectangles and back; `wires` knows which switch works what, `history` undoes; `disk` opens, saves and keeps what is not saved yet. What is
//! wrong with a document is said by the loader alone, which reads it from memory ([`Document::over`]).

mod disk;
mod history;
mod kinds;
mod places;
mod sheet;
mod wires;

pub use disk::{Folder, Kept, Opened, SaveError, Side};
pub use kinds::{Kind, SETTINGS, Table, choices, unit};
pub use places::{Place, number, way_text};
pub use wires::Wiring;

use super::read::Files;
use crate::files;
use crate::physics::DVec2;
use history::{Change, FileChange};
use sheet::{Added, CellEdit, Sheet};
use std::collections::BTreeMap;
use std::io;

/// A row of a level's files.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct RowId {
    /// The file.
    pub table: Table,
    /// From 0; headers and comments do not count.
    pub row: usize,
}

/// A cell that is to hold another text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SetCell {
    /// Where.
    pub row: RowId,
    /// The column's name.
    pub column: &'static str,
    /// What it is to hold.
    pub text: String,
}

/// A row that is to be added: the texts of its columns, those of the others are left out.
#[derive(Clone, Debug)]
pub struct NewRow {
    /// What it is.
    pub kind: Kind,
    /// Column and text.
    pub cells: Vec<(&'static str, String)>,
}

/// A level's files as they are edited.
#[derive(Clone, Debug)]
pub struct Document {
    /// By [`Table`].
    sheets: Vec<Sheet>,
    undo: Vec<Change>,
    redo: Vec<Change>,
    /// Counts everything that has changed the files.
    version: u64,
    /// Where everything lies, by table and row.
    places: Vec<Vec<Option<Place>>>,
    /// The sizes of pictures, pixels, by how cells name them.
    pictures: BTreeMap<String, DVec2>,
    /// The size of background.png, pixels.
    background: Option<DVec2>,
}

impl Document {
    /// A document of these files' bytes; a file that is not asked for, or not there, has no row.
    pub fn new(mut file: impl FnMut(Table) -> Option<Vec<u8>>) -> Self {
        let sheets: Vec<Sheet> = Table::ALL.iter().map(|table| Sheet::new(*table, file(*table))).collect();
        let mut document = Self {
            places: vec![Vec::new(); sheets.len()],
            sheets,
            undo: Vec::new(),
            redo: Vec::new(),
            version: 0,
            pictures: BTreeMap::new(),
            background: None,
        };
        document.measure_all();
        document
    }

    /// Takes over how large the pictures are, which the document itself cannot know.
    pub fn tell_sizes(&mut self, pictures: BTreeMap<String, DVec2>, background: Option<DVec2>) {
        (self.pictures, self.background) = (pictures, background);
        self.measure_all();
    }

    /// The pictures that cells name and whose size is not known yet.
    pub fn unknown_pictures(&self) -> Vec<String> {
        let rows = [Table::Objects, Table::Objectives, Table::Decoration].into_iter().flat_map(|table| self.rows(table));
        let names = rows.filter_map(|row| self.cell(row, "image")).filter(|name| !name.contains(':') && !name.is_empty());
        let mut names: Vec<String> = names.filter(|name| !self.pictures.contains_key(*name)).map(str::to_owned).collect();
        names.sort_unstable();
        names.dedup();
        names
    }

    fn picture_size(&self, image: &str) -> Option<DVec2> {
        places::shape(image).map(|(_, size)| size).or_else(|| self.pictures.get(image).copied())
    }

    fn sheet(&self, table: Table) -> &Sheet {
        &self.sheets[table.index()]
    }

    /// Counts everything that has changed the files, also what was undone.
    pub fn version(&self) -> u64 {
        self.version
    }

    /// A file's bytes; `None` where there is no such file.
    pub fn bytes(&self, table: Table) -> Option<&[u8]> {
        let sheet = self.sheet(table);
        sheet.exists.then_some(&sheet.bytes)
    }

    /// The rows of a file.
    pub fn rows(&self, table: Table) -> impl Iterator<Item = RowId> + use<> {
        (0..self.sheet(table).rows().len()).map(move |row| RowId { table, row })
    }

    /// All rows that have a place, and that place; those of one file after the other.
    pub fn things(&self) -> impl Iterator<Item = (RowId, Place)> + '_ {
        let of = |(table, places): (&Table, &'_ Vec<Option<Place>>)| {
            let table = *table;
            places.iter().enumerate().filter_map(move |(row, place)| Some((RowId { table, row }, (*place)?))).collect::<Vec<_>>()
        };
        Table::ALL.iter().zip(&self.places).flat_map(of)
    }

    /// Where a row's thing lies.
    pub fn place(&self, row: RowId) -> Option<Place> {
        *self.places[row.table.index()].get(row.row)?
    }

    /// What a row is; `None` where there is none or nothing is known of it.
    pub fn kind(&self, row: RowId) -> Option<Kind> {
        let first = self.sheet(row.table).rows().get(row.row)?.cells.first()?;
        Kind::of(row.table, first.text.trim())
    }

    /// What stands in a cell; `None` where the row has no such cell.
    pub fn cell(&self, row: RowId, column: &str) -> Option<&str> {
        self.sheet(row.table).cell(row.row, column)
    }

    /// What the level's settings say; `None` where they say nothing.
    pub fn setting(&self, name: &str) -> Option<&str> {
        self.setting_row(name).and_then(|row| self.cell(row, "value")).filter(|value| !value.is_empty())
    }

    fn setting_row(&self, name: &str) -> Option<RowId> {
        self.rows(Table::Constants).find(|row| self.cell(*row, "name").is_some_and(|known| known.eq_ignore_ascii_case(name)))
    }

    /// The row of a file that has that line, counted from 1 as the loader's problems do.
    pub fn row_at(&self, table: Table, line: usize) -> Option<RowId> {
        let sheet = self.sheet(table);
        let row = sheet.rows().partition_point(|row| row.line <= line).checked_sub(1)?;
        sheet.lines(row).filter(|(_, end)| line < *end).map(|_| RowId { table, row })
    }

    /// The first line of a row.
    pub fn line(&self, row: RowId) -> Option<usize> {
        self.sheet(row.table).lines(row.row).map(|(from, _)| from)
    }

    /// Makes cells hold other texts. Operations of one gesture, whichever number it has, are undone together. Where a name changes that
    /// switches work, they work the new one.
    ///
    /// # Errors
    /// A file or row that cannot be read as a table, in words; nothing has changed then.
    pub fn set(&mut self, cells: &[SetCell], gesture: Option<u64>) -> Result<(), String> {
        let mut files = Vec::new();
        let cells: Vec<SetCell> = cells.iter().cloned().chain(self.renamed(cells, gesture)).collect();
        for sheet in &self.sheets {
            let edits: Vec<CellEdit> = cells
                .iter()
                .filter(|cell| cell.row.table == sheet.table)
                .map(|cell| CellEdit { row: cell.row.row, column: cell.column, text: &cell.text })
                .collect();
            if !edits.is_empty() {
                files.push(FileChange::of(sheet, sheet.edit(&edits)?));
            }
        }
        self.apply(files, gesture);
        Ok(())
    }

    /// Adds rows below all others of their files, and makes a file that is not there; the new rows.
    ///
    /// # Errors
    /// As [`Document::set`].
    pub fn add(&mut self, rows: &[NewRow]) -> Result<Vec<RowId>, String> {
        let (mut files, mut added) = (Vec::new(), Vec::new());
        for sheet in &self.sheets {
            let of_sheet: Vec<&NewRow> = rows.iter().filter(|row| row.kind.table() == sheet.table).collect();
            if of_sheet.is_empty() {
                continue;
            }
            let first = sheet.rows().len();
            let cells: Vec<Added> = of_sheet.iter().map(|row| (row.kind.columns(), row.cells.clone())).collect();
            let splices = sheet.append(&cells)?;
            added.extend((first..first + cells.len()).map(|row| RowId { table: sheet.table, row }));
            files.push(FileChange::of(sheet, splices));
        }
        self.apply(files, None);
        Ok(added)
    }

    /// A new thing at that place.
    ///
    /// # Errors
    /// As [`Document::set`].
    pub fn put(&mut self, kind: Kind, place: Place) -> Result<Option<RowId>, String> {
        let mut cells: Vec<(&'static str, String)> =
            kind.fresh().iter().map(|(column, text)| (*column, (*text).to_owned())).collect();
        let at = if kind.by_centre() { place.centre().round() } else { place.min };
        let mut size = place.size.max(DVec2::ONE);
        cells.extend([("x", number(at.x)), ("y", number(at.y))]);
        match kind {
            Kind::Object | Kind::Key | Kind::Picture => cells.push(("image", places::shape_text(false, size))),
            Kind::Text => cells.push(("size", number(size.y))),
            _ => {
                if kind == Kind::Stream {
                    size.y = size.y.min(kind.usual_size().1);
                    cells.push(("stream_height", number(-(8.0 * size.y).max(100.0))));
                }
                cells.extend([("width", number(size.x)), ("height", number(size.y))]);
            }
        }
        match kind {
            Kind::Mover => cells.push(("way_points", way_text(&[at - DVec2::new(0.0, 6.0 * size.y.max(20.0))]))),
            Kind::Door => cells.push(("name", self.free_name(kind))),
            Kind::Switch => cells.push(("works", self.first_worked())),
            _ => {}
        }
        Ok(self.add(&[NewRow { kind, cells }])?.first().copied())
    }

    /// Rows of the same cells, so many pixels further; the new rows.
    ///
    /// # Errors
    /// As [`Document::set`].
    pub fn duplicate(&mut self, rows: &[RowId], by: DVec2) -> Result<Vec<RowId>, String> {
        let mut new = Vec::new();
        for row in rows {
            let Some(kind) = self.kind(*row).filter(|kind| !matches!(kind, Kind::Ship | Kind::Setting)) else { continue };
            let moved = self.shifted(*row, by);
            let text = |column: &'static str| {
                let shifted = moved.iter().find(|cell| cell.column == column).map(|cell| cell.text.clone());
                shifted.or_else(|| self.cell(*row, column).map(str::to_owned))
            };
            let cells = kind.column_names().into_iter().filter_map(|(column, _)| Some((column, text(column)?))).collect();
            new.push(NewRow { kind, cells });
        }
        self.add(&new)
    }

    /// Takes rows out, with their lines.
    ///
    /// # Errors
    /// As [`Document::set`].
    pub fn remove(&mut self, rows: &[RowId]) -> Result<(), String> {
        let mut files = Vec::new();
        for sheet in &self.sheets {
            let mut own: Vec<usize> = rows.iter().filter(|row| row.table == sheet.table).map(|row| row.row).collect();
            own.sort_unstable();
            own.dedup();
            if !own.is_empty() {
                files.push(FileChange::of(sheet, sheet.remove(&own)?));
            }
        }
        self.apply(files, None);
        Ok(())
    }

    /// Makes a setting hold that text; without one it goes.
    ///
    /// # Errors
    /// As [`Document::set`].
    pub fn set_setting(&mut self, name: &'static str, text: &str, gesture: Option<u64>) -> Result<(), String> {
        match self.setting_row(name) {
            Some(row) => self.set(&[SetCell { row, column: "value", text: text.to_owned() }], gesture),
            None if text.is_empty() => Ok(()),
            None => {
                let cells = vec![("name", name.to_owned()), ("value", text.to_owned())];
                self.add(&[NewRow { kind: Kind::Setting, cells }])?;
                if let Some(change) = self.undo.last_mut() {
                    change.gesture = gesture;
                }
                Ok(())
            }
        }
    }

    fn measure_table(&mut self, table: Table) {
        if table == Table::Constants {
            // The scale may be another: the ship's size hangs on it.
            return self.measure_all();
        }
        self.places[table.index()] = self.rows(table).map(|row| self.measure(row)).collect();
    }

    fn measure_all(&mut self) {
        for table in Table::ALL {
            self.places[table.index()] = self.rows(*table).map(|row| self.measure(row)).collect();
        }
    }

    /// The document's files above others: what the loader reads.
    pub fn over<'a>(&'a self, others: &'a dyn Files) -> impl Files + 'a {
        Over { document: self, others }
    }
}

struct Over<'a> {
    document: &'a Document,
    others: &'a dyn Files,
}

impl Files for Over<'_> {
    fn level_file(&self, name: &str) -> io::Result<Vec<u8>> {
        match Table::of_file(name) {
            Some(table) => match self.document.bytes(table) {
                None => Err(io::ErrorKind::NotFound.into()),
                // What could not be read again once it is saved.
                Some(bytes) if bytes.len() as u64 > files::LEVEL_TABLE => {
                    let found = format!("found {} bytes, expected at most {}", bytes.len(), files::LEVEL_TABLE);
                    Err(io::Error::new(io::ErrorKind::FileTooLarge, found))
                }
                Some(bytes) => Ok(bytes.to_vec()),
            },
            None => self.others.level_file(name),
        }
    }

    fn project_file(&self, path: &str) -> io::Result<Vec<u8>> {
        self.others.project_file(path)
    }

    fn names(&self) -> Vec<String> {
        self.others.names()
    }
}
