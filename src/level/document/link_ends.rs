//! The ends of a link, by the names of bodies or as places.

use super::model::{Document, RowId, SetCell};
use super::places::{Place, number, parsed};
use crate::level::schema::Table;
use crate::physics::DVec2;

/// A link is taken hold of by a square around its middle, pixels.
const HOLD: f64 = 20.0;

impl Document {
    /// The ends of a row of links.csv, pixels; `None` where one of them is no place and no body.
    pub fn link_ends(&self, row: RowId) -> Option<[DVec2; 2]> {
        let end = |column| {
            let text = self.cell(row, column)?.trim();
            match place(text) {
                Some(place) => Some(place),
                None if text.eq_ignore_ascii_case("ship") => self.place(self.rows(Table::Player).next()?).map(|ship| ship.centre()),
                None => {
                    let mut bodies = self.rows(Table::Objects).chain(self.rows(Table::Objectives));
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
        ["a", "b"].into_iter().filter_map(moved).collect()
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
