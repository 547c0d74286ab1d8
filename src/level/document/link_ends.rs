//! The ends of a link, by the names of bodies or as places.

use super::model::{Document, RowId, SetCell};
use super::places::{Place, number, parsed};
use crate::level::schema::Table;
use crate::physics::DVec2;

/// A link is taken hold of by a square around its middle, pixels.
const HOLD: f64 = 20.0;

/// The columns of the ends, and the tables of the bodies that these name.
const ENDS: [&str; 2] = ["a", "b"];
const BODIES: [Table; 2] = [Table::Objects, Table::Objectives];

impl Document {
    /// The ends of a row of links.csv, pixels; `None` where one of them is no place and no body.
    pub fn link_ends(&self, row: RowId) -> Option<[DVec2; 2]> {
        let end = |column| {
            let text = self.cell(row, column)?.trim();
            match place(text) {
                Some(place) => Some(place),
                None if text.eq_ignore_ascii_case("ship") => self.place(self.rows(Table::Player).next()?).map(|ship| ship.centre()),
                None => {
                    let mut bodies = BODIES.into_iter().flat_map(|table| self.rows(table));
                    self.place(bodies.find(|body| self.cell(*body, "name") == Some(text))?).map(|body| body.centre())
                }
            }
        };
        Some([end("a")?, end("b")?])
    }

    pub(super) fn link_place(&self, row: RowId) -> Option<Place> {
        let [a, b] = self.link_ends(row)?;
        Some(Place { min: (a + b) * 0.5 - HOLD * 0.5, size: DVec2::splat(HOLD) })
    }

    /// The cells of a link whose places have moved by `by` pixels.
    pub(super) fn moved_link(&self, row: RowId, by: DVec2) -> Vec<SetCell> {
        let moved = |column| Some(SetCell { row, column, text: place_text(place(self.cell(row, column)?)? + by) });
        ENDS.into_iter().filter_map(moved).collect()
    }

    /// The ends of links at bodies that get other names, as the links were before the gesture. A link keeps the old name until the new one is a word.
    pub(super) fn renamed_ends(&self, cells: &[SetCell], gesture: Option<u64>) -> Vec<SetCell> {
        let mut new: Vec<(String, &str)> = Vec::new();
        for cell in cells.iter().filter(|cell| cell.column == "name" && BODIES.contains(&cell.row.table)) {
            let (name, word) = (cell.text.trim(), |name: &str| !name.is_empty() && !name.contains(char::is_whitespace));
            let old = self.before(cell.row.table, gesture).cell(cell.row.row, "name").unwrap_or_default().to_owned();
            new.push((old, if word(name) { name } else { "" }));
        }
        if new.is_empty() {
            return Vec::new();
        }
        let before = self.before(Table::Links, gesture);
        let ends = (0..before.rows().len()).flat_map(|row| ENDS.map(|column| (RowId { table: Table::Links, row }, column)));
        let named = ends.filter_map(|(row, column)| {
            let text = before.cell(row.row, column).filter(|text| !text.is_empty())?;
            let name = new.iter().find(|(old, _)| old == text).map(|(_, name)| *name)?;
            let text = if name.is_empty() { text } else { name };
            (self.cell(row, column) != Some(text)).then(|| SetCell { row, column, text: text.to_owned() })
        });
        named.collect()
    }
}

fn place(text: &str) -> Option<DVec2> {
    match text.split_whitespace().collect::<Vec<_>>()[..] {
        [x, y] => Some(DVec2::new(parsed(x)?, parsed(y)?)),
        _ => None,
    }
}

/// `600 300`.
pub(super) fn place_text(place: DVec2) -> String {
    format!("{} {}", number(place.x), number(place.y))
}
