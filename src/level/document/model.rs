//! The files of a level, with kind, place and cells of each row; a thing without a readable place is not drawn, and the loader lists its problem.
//! The file of unsaved edits: name and length of each table, then its bytes. An operation's changes: in each file the bytes from the first to the
//! last that differ.

use super::places::{Place, parsed, shape};
use super::sheet::EditedFile;
use crate::level::schema::{Column, Kind, Table};
use crate::{files, level::image::Files, level::numbers::PixelScale, level::types::SHIP_HEIGHT, physics::DVec2, words::tr};
use std::{collections::BTreeMap, io};

/// Width of a letter in heights of it, about.
const LETTER: f64 = 0.5;

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct RowId {
    pub table: Table,
    /// From 0; headers and comments do not count.
    pub row: usize,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SetCell {
    pub row: RowId,
    pub column: &'static str,
    pub text: String,
}

/// Columns without a text are left out.
#[derive(Clone, Debug)]
pub struct NewRow {
    pub kind: Kind,
    pub cells: Vec<(&'static str, String)>,
}

#[derive(Clone, Debug)]
pub struct Document {
    /// By [`Table`].
    pub(super) sheets: Vec<EditedFile>,
    pub(super) undo: Vec<EditChange>,
    pub(super) redo: Vec<EditChange>,
    pub(super) version: u64,
    /// By table and row.
    places: Vec<Vec<Option<Place>>>,
    /// The sizes of pictures, pixels, by their names in cells.
    pictures: BTreeMap<String, DVec2>,
    /// The size of background.png, pixels.
    background: Option<DVec2>,
}

impl Document {
    /// `file` returns a file's bytes; `None` for a missing file, which has no row.
    pub fn new(mut file: impl FnMut(Table) -> Option<Vec<u8>>) -> Self {
        let sheets: Vec<EditedFile> = Table::ALL.iter().map(|table| EditedFile::new(*table, file(*table))).collect();
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

    /// Sizes in pixels.
    pub fn tell_sizes(&mut self, pictures: BTreeMap<String, DVec2>, background: Option<DVec2>) {
        (self.pictures, self.background) = (pictures, background);
        self.measure_all();
    }

    pub fn unknown_pictures(&self) -> Vec<String> {
        let rows = Table::ALL.iter().filter(|table| table.has(Column::is_picture)).flat_map(|table| self.rows(*table));
        let names = rows.filter_map(|row| self.cell(row, "image")).filter(|name| !name.contains(':') && !name.is_empty());
        let mut names: Vec<String> = names.filter(|name| !self.pictures.contains_key(*name)).map(str::to_owned).collect();
        names.sort_unstable();
        names.dedup();
        names
    }

    pub(super) fn sheet(&self, table: Table) -> &EditedFile {
        &self.sheets[table.index()]
    }

    /// Counts all changes of the files, also each undo.
    pub fn version(&self) -> u64 {
        self.version
    }

    /// A file's bytes; `None` where there is no such file.
    pub fn bytes(&self, table: Table) -> Option<&[u8]> {
        let sheet = self.sheet(table);
        sheet.exists.then_some(&sheet.bytes)
    }

    pub fn rows(&self, table: Table) -> impl Iterator<Item = RowId> + use<> {
        (0..self.sheet(table).rows().len()).map(move |row| RowId { table, row })
    }

    /// All rows with a place, file by file.
    pub fn things(&self) -> impl Iterator<Item = (RowId, Place)> + '_ {
        let of = |(table, places): (&Table, &'_ Vec<Option<Place>>)| {
            let table = *table;
            places.iter().enumerate().filter_map(move |(row, place)| Some((RowId { table, row }, (*place)?))).collect::<Vec<_>>()
        };
        Table::ALL.iter().zip(&self.places).flat_map(of)
    }

    pub fn place(&self, row: RowId) -> Option<Place> {
        *self.places[row.table.index()].get(row.row)?
    }

    /// `None` where there is no such row, or where its kind is unknown.
    pub fn kind(&self, row: RowId) -> Option<Kind> {
        let first = self.sheet(row.table).rows().get(row.row)?.cells.first()?;
        Kind::of(row.table, first.text.trim())
    }

    /// `None` where the row has no such cell.
    pub fn cell(&self, row: RowId, column: &str) -> Option<&str> {
        self.sheet(row.table).cell(row.row, column)
    }

    /// `None` where it is not given.
    pub fn setting(&self, name: &str) -> Option<&str> {
        self.setting_row(name).and_then(|row| self.cell(row, "value")).filter(|value| !value.is_empty())
    }

    pub(super) fn setting_row(&self, name: &str) -> Option<RowId> {
        self.rows(Table::Constants).find(|row| self.cell(*row, "name").is_some_and(|known| known.eq_ignore_ascii_case(name)))
    }

    /// Lines count from 1, as in the loader's problems.
    pub fn row_at(&self, table: Table, line: usize) -> Option<RowId> {
        let sheet = self.sheet(table);
        let row = sheet.rows().partition_point(|row| row.line <= line).checked_sub(1)?;
        sheet.lines(row).filter(|(_, end)| line < *end).map(|_| RowId { table, row })
    }

    pub fn line(&self, row: RowId) -> Option<usize> {
        self.sheet(row.table).lines(row.row).map(|(from, _)| from)
    }

    /// Pixels a metre.
    pub fn metre(&self) -> f64 {
        let metre = self.setting("metre").and_then(parsed).filter(|metre| *metre > 1e-3);
        metre.unwrap_or(PixelScale::USUAL.metre)
    }

    /// In pixels, from the background, else from the settings.
    pub fn size(&self) -> DVec2 {
        let given = |name: &str, usual: f64| self.setting(name).and_then(parsed).filter(|side| *side >= 1.0).unwrap_or(usual);
        self.background.unwrap_or_else(|| DVec2::new(given("width", 1280.0), given("height", 720.0)))
    }

    pub fn number(&self, row: RowId, column: &str) -> Option<f64> {
        self.cell(row, column).and_then(parsed)
    }

    fn measure(&self, row: RowId) -> Option<Place> {
        let kind = self.kind(row)?;
        if kind == Kind::Link {
            return self.link_place(row);
        }
        let at = DVec2::new(self.number(row, "x")?, self.number(row, "y")?);
        let size = match kind {
            Kind::Setting | Kind::Hint => return None,
            Kind::Ship => DVec2::splat(SHIP_HEIGHT * self.metre()),
            Kind::Object | Kind::Key | Kind::Picture => {
                let image = self.cell(row, "image")?;
                let size = shape(image).map(|(_, size)| size).or_else(|| self.pictures.get(image).copied());
                size.unwrap_or(DVec2::splat(20.0))
            }
            Kind::Text => {
                let height = self.number(row, "size")?.abs();
                DVec2::new(LETTER * height * self.cell(row, "text").map_or(0, |text| text.chars().count()) as f64, height)
            }
            _ => DVec2::new(self.number(row, "width")?, self.number(row, "height")?),
        };
        let min = if kind.by_centre() { at - size * 0.5 } else { at };
        Some(Place { min, size }).filter(|_| !size.cmple(DVec2::ZERO).any())
    }

    pub(super) fn measure_table(&mut self, table: Table) {
        if table == Table::Constants {
            // The ship's size follows the scale.
            return self.measure_all();
        }
        self.places[table.index()] = self.rows(table).map(|row| self.measure(row)).collect();
        if matches!(table, Table::Player | Table::Objects | Table::Objectives) {
            self.measure_table(Table::Links);
        }
    }

    fn measure_all(&mut self) {
        for table in Table::ALL {
            self.places[table.index()] = self.rows(*table).map(|row| self.measure(row)).collect();
        }
    }

    /// The document's files above others, for the loader.
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
                // A saved file of this size cannot be read.
                Some(bytes) if bytes.len() as u64 > files::LEVEL_TABLE => {
                    let (found, most) = (tr!("{count} bytes", count = bytes.len()), files::LEVEL_TABLE);
                    let problem = tr!("found {found}, expected at most {most} bytes", found, most);
                    Err(io::Error::new(io::ErrorKind::FileTooLarge, problem))
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

const MARK: &str = "resultant autosave 1\n";
/// Its last line: a file without it was cut short.
const END: &str = "end\n";
/// The largest such file that is read, bytes: all tables at their limits, and room for their names.
pub(super) const MOST: u64 = (files::LEVEL_TABLE + 100) * Table::ALL.len() as u64;

/// Unsaved bytes of all files, by [`Table`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Kept(pub(super) Vec<Option<Vec<u8>>>);

impl Document {
    /// One operation, which can be undone.
    pub fn restore(&mut self, kept: Kept) {
        self.replace_all(kept.0);
    }
}

pub(super) fn encoded(document: &Document) -> Vec<u8> {
    let mut all = MARK.as_bytes().to_vec();
    for table in Table::ALL {
        if let Some(bytes) = document.bytes(*table) {
            all.extend_from_slice(format!("{} {}\n", table.file(), bytes.len()).as_bytes());
            all.extend_from_slice(bytes);
        }
    }
    all.extend_from_slice(END.as_bytes());
    all
}

/// `None` where the bytes are no such file, or not whole.
pub(super) fn parse(bytes: &[u8]) -> Option<Kept> {
    let mut rest = bytes.strip_prefix(MARK.as_bytes())?;
    let mut kept = vec![None; Table::ALL.len()];
    while rest != END.as_bytes() {
        let end = rest.iter().position(|byte| *byte == b'\n')?;
        let (file, length) = std::str::from_utf8(&rest[..end]).ok()?.split_once(' ')?;
        let bytes = rest.get(end + 1..)?.get(..length.parse().ok()?)?;
        kept[Table::of_file(file)?.index()] = Some(bytes.to_vec());
        rest = &rest[end + 1 + bytes.len()..];
    }
    Some(Kept(kept))
}

/// The change of one operation in a file: of each pair the first is before it, the second after it.
#[derive(Clone, Debug)]
pub(super) struct ByteChange {
    pub table: Table,
    exists: [bool; 2],
    at: usize,
    bytes: [Vec<u8>; 2],
}

#[derive(Clone, Debug)]
pub(super) struct EditChange {
    pub files: Vec<ByteChange>,
    /// Operations of one gesture, such as a drag, are undone together.
    pub gesture: Option<u64>,
}

impl ByteChange {
    /// `None` where no byte differs.
    pub fn between(table: Table, old: Option<&[u8]>, new: Option<&[u8]>) -> Option<Self> {
        let exists = [old.is_some(), new.is_some()];
        if old == new {
            return None;
        }
        let (old, new) = (old.unwrap_or_default(), new.unwrap_or_default());
        let at = old.iter().zip(new).take_while(|(a, b)| a == b).count();
        let (old, new) = (&old[at..], &new[at..]);
        let alike = old.iter().rev().zip(new.iter().rev()).take_while(|(a, b)| a == b).count();
        let bytes = [old, new].map(|bytes| bytes[..bytes.len() - alike].to_vec());
        Some(Self { table, exists, at, bytes })
    }

    /// The bytes before the change (0) or after it (1), of those at its other side.
    pub fn turned(&self, now: Option<&[u8]>, to: usize) -> Option<Vec<u8>> {
        let mut bytes = now.unwrap_or_default().to_vec();
        bytes.splice(self.at..self.at + self.bytes[1 - to].len(), self.bytes[to].iter().copied());
        self.exists[to].then_some(bytes)
    }
}
