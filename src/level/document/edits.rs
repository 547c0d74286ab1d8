//! Operations on rows, which change cells and add, move, double and take out rows: done, undone, and joined where they are of one gesture. Rows as a
//! text of the clipboard, for this level or another one.

use super::links::shifted_end;
use super::model::{ByteChange, Document, EditChange, NewRow, RowId, SetCell};
use super::places::{FINEST, Place, number, parsed, points, shape, shape_text, way_text};
use super::sheet::{Added, CellEdit, EditedFile};
use crate::level::schema::{Kind, Table};
use crate::{files::csv_line, physics::DVec2};
use std::collections::{BTreeMap, BTreeSet};

impl Document {
    /// Operations of one gesture are undone together. Switches follow the change of a name that they work, and the ends of links that of a body.
    /// Errors: a file or row that cannot be read as a table, in words; the document stays.
    pub fn set(&mut self, cells: &[SetCell], gesture: Option<u64>) -> Result<(), String> {
        let mut files = Vec::new();
        let renamed = self.renamed(cells, gesture).into_iter().chain(self.renamed_ends(cells, gesture));
        let cells: Vec<SetCell> = cells.iter().cloned().chain(renamed).collect();
        for sheet in &self.sheets {
            let own = cells.iter().filter(|cell| cell.row.table == sheet.table);
            let edits = own.map(|SetCell { row, column, text }| CellEdit { row: row.row, column, text });
            let edits: Vec<CellEdit> = edits.collect();
            if !edits.is_empty() {
                files.push((sheet.table, Some(sheet.edit(&edits)?)));
            }
        }
        self.apply(files, gesture);
        Ok(())
    }

    /// Adds rows below all others of their files, and makes missing files. Returns the new rows.
    pub fn add(&mut self, rows: &[NewRow]) -> Result<Vec<RowId>, String> {
        self.add_in(rows, None)
    }

    /// As [`Document::add`]; operations of one gesture are undone together.
    pub(super) fn add_in(&mut self, rows: &[NewRow], gesture: Option<u64>) -> Result<Vec<RowId>, String> {
        let (mut files, mut added) = (Vec::new(), Vec::new());
        for sheet in &self.sheets {
            let of_sheet: Vec<&NewRow> = rows.iter().filter(|row| row.kind.table() == sheet.table).collect();
            if of_sheet.is_empty() {
                continue;
            }
            let first = sheet.rows().len();
            let cells: Vec<Added> = of_sheet.iter().map(|row| (row.kind.schema(), row.cells.clone())).collect();
            files.push((sheet.table, Some(sheet.append(&cells)?)));
            added.extend((first..first + cells.len()).map(|row| RowId { table: sheet.table, row }));
        }
        self.apply(files, gesture);
        Ok(added)
    }

    /// Errors: as [`Document::set`].
    pub fn put(&mut self, kind: Kind, place: Place) -> Result<Option<RowId>, String> {
        let fresh = kind.schema().fresh.iter().map(|(column, text)| (*column, (*text).to_owned()));
        let mut cells: Vec<(&'static str, String)> = fresh.collect();
        let at = if kind.by_centre() { place.centre().round() } else { place.min };
        let mut size = place.size.max(DVec2::ONE);
        cells.extend([("x", number(at.x)), ("y", number(at.y))]);
        match kind {
            Kind::Object | Kind::Key | Kind::Picture => cells.push(("image", shape_text(false, size))),
            Kind::Text => cells.push(("size", number(size.y))),
            _ => {
                if kind == Kind::Stream {
                    size.y = size.y.min(kind.schema().usual_size.1);
                    cells.push(("stream_height", number(-(8.0 * size.y).max(100.0))));
                }
                cells.extend([("width", number(size.x)), ("height", number(size.y))]);
            }
        }
        match kind {
            Kind::Mover => cells.push(("way_points", way_text(&[at - DVec2::new(0.0, 6.0 * size.y.max(20.0))]))),
            Kind::Door => cells.push(("name", self.free_name(kind))),
            Kind::Switch => cells.push(("works", self.names().first().map_or("gate", |name| name).to_owned())),
            _ => {}
        }
        Ok(self.add(&[NewRow { kind, cells }])?.first().copied())
    }

    /// Takes rows out, with their lines.
    pub fn remove(&mut self, rows: &[RowId]) -> Result<(), String> {
        let mut files = Vec::new();
        for sheet in &self.sheets {
            let mut own: Vec<usize> = rows.iter().filter(|row| row.table == sheet.table).map(|row| row.row).collect();
            own.sort_unstable();
            own.dedup();
            if !own.is_empty() {
                files.push((sheet.table, Some(sheet.remove(&own)?)));
            }
        }
        self.apply(files, None);
        Ok(())
    }

    /// An empty text clears the setting.
    pub fn set_setting(&mut self, name: &'static str, text: &str, gesture: Option<u64>) -> Result<(), String> {
        match self.setting_row(name) {
            Some(row) => self.set(&[SetCell { row, column: "value", text: text.to_owned() }], gesture),
            None if text.is_empty() => Ok(()),
            None => {
                let cells = vec![("name", name.to_owned()), ("value", text.to_owned())];
                self.add_in(&[NewRow { kind: Kind::Setting, cells }], gesture).map(drop)
            }
        }
    }

    pub fn is_sizable(&self, row: RowId) -> bool {
        match self.kind(row) {
            None | Some(Kind::Ship | Kind::Setting | Kind::Hint | Kind::Link) => false,
            Some(Kind::Object | Kind::Key | Kind::Picture) => self.cell(row, "image").is_some_and(|image| shape(image).is_some()),
            Some(_) => true,
        }
    }

    /// The row's cells with its thing at that place; its size only where it differs.
    pub fn placed(&self, row: RowId, to: Place) -> Vec<SetCell> {
        let (Some(kind), Some(from)) = (self.kind(row), self.place(row)) else { return Vec::new() };
        if kind == Kind::Link {
            return self.moved_link(row, to.min - from.min);
        }
        let mut cells = Vec::new();
        let mut set = |column: &'static str, value: f64| cells.push(SetCell { row, column, text: number(value) });
        let resized = (to.size - from.size).abs().max_element() > 0.5 / FINEST;
        let corner = |place: &Place| if kind.by_centre() { place.centre() } else { place.min };
        let (old, new) = (corner(&from), corner(&to));
        for (column, axis) in [("x", 0), ("y", 1)].into_iter().filter(|(_, axis)| old[*axis] != new[*axis]) {
            set(column, new[axis]);
        }
        if resized && self.is_sizable(row) {
            match kind {
                Kind::Text => set("size", to.size.y.max(1.0)),
                Kind::Object | Kind::Key | Kind::Picture => {
                    let round = self.cell(row, "image").and_then(shape).is_some_and(|(round, _)| round);
                    let text = shape_text(round, to.size);
                    cells.push(SetCell { row, column: "image", text });
                }
                _ => {
                    set("width", to.size.x);
                    set("height", to.size.y);
                }
            }
        }
        cells
    }

    /// The row's cells with its thing, and the route of a mover, moved by `by` pixels.
    pub fn shifted(&self, row: RowId, by: DVec2) -> Vec<SetCell> {
        let Some(place) = self.place(row) else { return Vec::new() };
        let mut cells = self.placed(row, Place { min: place.min + by, ..place });
        if self.kind(row) == Some(Kind::Mover) {
            let way: Vec<DVec2> = self.way_points(row).into_iter().map(|point| point + by).collect();
            if !way.is_empty() {
                cells.push(SetCell { row, column: "way_points", text: way_text(&way) });
            }
        }
        cells
    }

    /// Pixels; none where they cannot be read.
    pub fn way_points(&self, row: RowId) -> Vec<DVec2> {
        points(self.cell(row, "way_points").unwrap_or_default()).unwrap_or_default()
    }
}

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
        change.map_or_else(|| now.map(<[u8]>::to_vec), |change| change.turned(now, 0))
    }

    /// A file as it was before the gesture began.
    pub(super) fn before(&self, table: Table, gesture: Option<u64>) -> EditedFile {
        EditedFile::new(table, self.bytes_before(table, gesture))
    }

    /// Returns whether there was an operation to undo.
    pub fn undo(&mut self) -> bool {
        let Some(change) = self.undo.pop() else { return false };
        self.write(change.files.iter().map(|file| (file.table, file.turned(self.bytes(file.table), 0))).collect());
        self.redo.push(change);
        true
    }

    /// Returns whether there was an operation to redo.
    pub fn redo(&mut self) -> bool {
        let Some(change) = self.redo.pop() else { return false };
        self.write(change.files.iter().map(|file| (file.table, file.turned(self.bytes(file.table), 1))).collect());
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
        let change = |(table, old): (Table, Option<Vec<u8>>)| ByteChange::between(table, old.as_deref(), self.bytes(table));
        let files: Vec<ByteChange> = before.into_iter().filter_map(change).collect();
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

/// The first cell of the text; the middle of the rows follows, pixels.
const MARK: &str = "resultant things";

/// Copied rows.
#[derive(Clone, Debug)]
pub struct Clip {
    pub rows: Vec<NewRow>,
    /// Their middle, pixels.
    pub middle: DVec2,
}

impl Document {
    /// Copies of these rows, without those that a level has once.
    fn copies(&self, rows: &[RowId]) -> Vec<NewRow> {
        let copy = |row: &RowId| {
            let kind = self.kind(*row).filter(|kind| !matches!(kind, Kind::Ship | Kind::Setting))?;
            let cell = |name: &'static str| Some((name, self.cell(*row, name)?.to_owned()));
            Some(NewRow { kind, cells: kind.schema().columns.iter().filter_map(|column| cell(column.name)).collect() })
        };
        rows.iter().filter_map(copy).collect()
    }

    /// Copies rows, moved by `by` pixels. Returns the new rows.
    pub fn duplicate(&mut self, rows: &[RowId], by: DVec2, gesture: Option<u64>) -> Result<Vec<RowId>, String> {
        self.insert(self.copies(rows), by, gesture)
    }

    /// Adds rows, moved by `by` pixels. Their bodies get names that are free, and the ends of links among them follow.
    pub fn insert(&mut self, mut rows: Vec<NewRow>, by: DVec2, gesture: Option<u64>) -> Result<Vec<RowId>, String> {
        let mut names: BTreeMap<String, String> = BTreeMap::new();
        for row in rows.iter_mut().filter(|row| matches!(row.kind, Kind::Object | Kind::Key)) {
            for (_, text) in row.cells.iter_mut().filter(|(column, text)| *column == "name" && !text.is_empty()) {
                let taken: Vec<&str> = names.values().map(String::as_str).collect();
                let free = self.free_body_name(text, &taken);
                names.insert(std::mem::replace(text, free.clone()), free);
            }
        }
        for NewRow { kind, cells } in &mut rows {
            for (column, text) in cells {
                let moved = |by: f64| parsed(text).map(|value| number(value + by));
                let new = match *column {
                    "x" => moved(by.x),
                    "y" => moved(by.y),
                    "way_points" => points(text).map(|way| way_text(&way.into_iter().map(|point| point + by).collect::<Vec<_>>())),
                    "a" | "b" if *kind == Kind::Link => shifted_end(text, by).or_else(|| names.get(text.as_str()).cloned()),
                    _ => None,
                };
                *text = new.unwrap_or_else(|| std::mem::take(text));
            }
        }
        self.add_in(&rows, gesture)
    }

    /// These rows as text, and how many that are.
    pub fn copied(&self, rows: &[RowId]) -> (String, usize) {
        let copies = self.copies(rows);
        let places = rows.iter().filter(|row| row.table != Table::Player).filter_map(|row| self.place(*row));
        let all = places.reduce(|all, place| Place::between(all.min.min(place.min), all.max().max(place.max())));
        let middle = all.unwrap_or_default().centre().round();
        let mut text = csv_line([MARK.to_owned(), number(middle.x), number(middle.y)]);
        for NewRow { kind, cells } in &copies {
            let cells = cells.iter().map(|(column, text)| format!("{column}={text}"));
            text += &csv_line([kind.name().to_owned()].into_iter().chain(cells));
        }
        (text, copies.len())
    }
}

impl Clip {
    /// `None` where the text holds no rows.
    pub fn parse(text: &str) -> Option<Self> {
        let mut records = csv::ReaderBuilder::new().has_headers(false).flexible(true).from_reader(text.as_bytes()).into_records();
        let head = records.next()?.ok().filter(|head| head.get(0) == Some(MARK))?;
        let middle = DVec2::new(parsed(head.get(1)?)?, parsed(head.get(2)?)?);
        let row = |record: csv::StringRecord| {
            let kind = Kind::ALL.iter().copied().find(|kind| Some(kind.name()) == record.get(0))?;
            let cell = |cell: &str| {
                let (column, text) = cell.split_once('=')?;
                Some((kind.schema().find(column)?.name, text.to_owned()))
            };
            Some(NewRow { kind, cells: record.iter().skip(1).filter_map(cell).collect() })
        };
        let rows: Vec<NewRow> = records.map_while(Result::ok).filter_map(row).collect();
        (!rows.is_empty()).then_some(Self { rows, middle })
    }
}
