//! Rows that are doubled, and rows as a text of the clipboard, for this level or another one.

use super::links::shifted_end;
use super::model::{Document, NewRow, RowId};
use super::places::{Place, number, parsed, points, way_text};
use crate::files::csv_line;
use crate::level::schema::{Kind, Table};
use crate::physics::DVec2;
use std::collections::BTreeMap;

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
