//! Rows as plain structs that serde fills from the `csv` crate's records, the facts of a column beside its field; a row whose cells have found their
//! columns, the state that all readers of rows share, and a thing of a level with its row.

use super::facts::{Column, Holds, RowSchema};
use crate::files::{Cell, Dialect};
use crate::level::numbers::{self, NumberRange, PixelScale};
use crate::level::problem::{Problem, quoted};
use crate::physics::{Material, Sides};
use crate::{level::image::Images, words::tr};
use csv::StringRecord;
use serde::Deserialize;
use serde::de::{DeserializeOwned, Deserializer, Error};

/// A struct with a field for each column, in their order.
pub(in crate::level) trait Row: DeserializeOwned {
    const COLUMNS: &'static [Column];
}

/// Plain structs, and their columns with the fields' names; `rectangle` stands for x, y, width and height.
macro_rules! rows {
    ($($(#[$about:meta])* $row:ident { $($fields:tt)* })*) => {
        $($crate::level::schema::typed::rows! { @fields ($(#[$about])* $row) [] $($fields)* })*
    };
    (@fields $row:tt [$($done:tt)*] rectangle, $($more:tt)*) => {
        $crate::level::schema::typed::rows! {
            @fields $row
            [
                $($done)*
                x: f64 = $crate::level::schema::typed::X,
                y: f64 = $crate::level::schema::typed::Y,
                width: f64 = $crate::level::schema::typed::WIDTH,
                height: f64 = $crate::level::schema::typed::HEIGHT,
            ]
            $($more)*
        }
    };
    (@fields $row:tt [$($done:tt)*] $field:ident: $type:ty = $column:expr, $($more:tt)*) => {
        $crate::level::schema::typed::rows! { @fields $row [$($done)* $field: $type = $column,] $($more)* }
    };
    (@fields ($(#[$about:meta])* $row:ident) [$($field:ident: $type:ty = $column:expr,)*]) => {
        $(#[$about])*
        #[allow(dead_code)] // Some columns are read for their problems alone.
        #[derive(Clone, Debug, serde::Deserialize)]
        pub(in crate::level) struct $row { $(pub $field: $type,)* }

        impl $crate::level::schema::typed::Row for $row {
            const COLUMNS: &'static [$crate::level::schema::facts::Column] = &[$($column.named(stringify!($field))),*];
        }
    };
}
pub(super) use rows;

pub(super) const fn number(range: NumberRange, help: &'static str) -> Column {
    Column::new(Holds::Number(range), help)
}

pub(super) const fn whole(low: u32, high: u32, help: &'static str) -> Column {
    Column::new(Holds::Whole(low, high), help)
}

pub(super) const fn channel(help: &'static str) -> Column {
    whole(0, 255, help)
}

pub(super) const fn boolean(help: &'static str) -> Column {
    Column::new(Holds::Flag, help)
}

pub(super) const fn one_of<T: Word>(help: &'static str) -> Column {
    Column::new(Holds::OneOf(names::<T>), help)
}

/// Any text that is not empty.
pub(super) const fn words(holds: &'static str, help: &'static str) -> Column {
    Column::new(Holds::Text(holds), help)
}

/// A value that a file names by one of a few words.
pub trait Word: Sized + PartialEq {
    fn words() -> Vec<(&'static str, Self)>;
}

fn names<T: Word>() -> Vec<&'static str> {
    T::words().into_iter().map(|(word, _)| word).collect()
}

/// Reads values that have words by serde.
macro_rules! by_word {
    ($($type:ty),*) => {
        $(
            impl<'de> serde::Deserialize<'de> for $type {
                fn deserialize<D: serde::Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
                    $crate::level::schema::typed::worded(from)
                }
            }
        )*
    };
}
pub(super) use by_word;

pub(super) fn worded<'de, D: Deserializer<'de>, T: Word>(from: D) -> Result<T, D::Error> {
    let text = <&str>::deserialize(from)?;
    let found = T::words().into_iter().find(|(word, _)| *word == text);
    found.map(|(_, value)| value).ok_or_else(|| D::Error::unknown_variant(text, &[]))
}

by_word!(Material, Sides);

impl Word for Material {
    fn words() -> Vec<(&'static str, Self)> {
        Self::ALL.map(|material| (material.name, material)).to_vec()
    }
}

impl Word for Sides {
    fn words() -> Vec<(&'static str, Self)> {
        let none = Self { top: false, ..Self::TOP };
        vec![
            ("", Self::ALL),
            ("top", Self::TOP),
            ("bottom", Self { bottom: true, ..none }),
            ("left", Self { left: true, ..none }),
            ("right", Self { right: true, ..none }),
        ]
    }
}

pub(super) const X: Column = Column::new(Holds::Position, "left edge");
pub(super) const Y: Column = Column::new(Holds::Position, "upper edge");
pub(super) const WIDTH: Column = Column::new(Holds::Size, "from the left edge to the right one");
pub(super) const HEIGHT: Column = Column::new(Holds::Size, "from the upper edge to the lower one");
pub(super) const CENTRE_X: Column = Column::new(Holds::Position, "centre, from the left edge of the level");
pub(super) const CENTRE_Y: Column = Column::new(Holds::Position, "centre, from the upper edge of the level");
pub(super) const VX: Column = number(numbers::VELOCITY, "velocity at the start, to the right").or("0");
pub(super) const VY: Column = number(numbers::VELOCITY, "velocity at the start, downwards").or("0");
pub(super) const MATERIAL: Column = one_of::<Material>("static and kinetic friction, and restitution").or("Asphalt");

/// A row's cells by column; or the settings of constants.csv, each a cell by its name.
#[derive(Clone, Debug)]
pub(in crate::level) struct RowCells {
    pub schema: &'static RowSchema,
    pub dialect: Dialect,
    pub line: usize,
    pub cells: Vec<(&'static str, Cell)>,
    /// The cells are the values of settings.
    pub is_settings: bool,
}

impl RowCells {
    /// Without the spaces around it; `None` where the row has no such cell: it may be left out, or its lack is reported.
    pub fn text(&self, column: &str) -> Option<&str> {
        self.cell(column).map(|cell| cell.text.trim())
    }

    fn cell(&self, column: &str) -> Option<&Cell> {
        self.cells.iter().find(|(name, _)| *name == column).map(|(_, cell)| cell)
    }

    /// The line of a cell; of the row where it has no such cell.
    pub fn line_of(&self, column: &str) -> usize {
        self.cell(column).map_or(self.line, |cell| cell.line)
    }

    pub fn problem(&self, column: &str, found: impl Into<String>, expected: impl Into<String>) -> Problem {
        let (file, line) = (self.schema.file.name, self.line_of(column));
        if self.is_settings {
            return Problem::new(file, line, "value", tr!("{found} for {column}", found = found.into(), column), expected);
        }
        Problem::new(file, line, column, found, expected)
    }

    /// `None` where a cell is refused, which is reported, as are all others of the row.
    pub fn read<T: Row>(&self, reader: &mut RowReader) -> Option<T> {
        let (row, whole) = self.read_cells(reader);
        row.filter(|_| whole)
    }

    /// The row, with a column's usual text for a refused cell, and whether it has all its cells from its author.
    pub fn read_cells<T: Row>(&self, reader: &mut RowReader) -> (Option<T>, bool) {
        let mut whole = true;
        let cells: Vec<Option<String>> = T::COLUMNS.iter().map(|column| self.plain(column, reader, &mut whole)).collect();
        let Some(record) = cells.into_iter().collect::<Option<StringRecord>>() else { return (None, false) };
        // Of good cells serde refuses none; whatever it does refuse has a line.
        let refused = |error: csv::Error| reader.problems.push(self.problem(T::COLUMNS[0].name, error.to_string(), tr("text")));
        (record.deserialize(None).map_err(refused).ok(), whole)
    }

    /// A cell as serde reads it; `None` where it lacks or is refused, which is reported, and nothing stands in for it.
    fn plain(&self, column: &'static Column, reader: &mut RowReader, whole: &mut bool) -> Option<String> {
        let usual = || column.holds.plain(column.usual).into_owned();
        let text = match self.text(column.name) {
            None if column.required => return None,
            None => return Some(usual()),
            Some("") if column.may_be_empty => return Some(usual()),
            Some(text) => text,
        };
        let plain = column.holds.in_plain_dialect(self.dialect, text);
        let found = || if text.is_empty() { tr("nothing").into() } else { quoted(text) };
        let judged = match column.holds {
            Holds::Picture { .. } => reader.images.look(text, reader.scale).map(drop),
            holds => holds.judge(&plain, reader.scale).map_err(|expected| (found(), expected)),
        };
        let Err((found, expected)) = judged else { return Some(column.holds.plain(&plain).into_owned()) };
        reader.problems.push(self.problem(column.name, found, expected));
        if let (Holds::Picture { of_body: true }, Some(stand_in)) = (column.holds, reader.images.stand_in) {
            return Some(stand_in.to_owned());
        }
        *whole = false;
        Some(usual()).filter(|_| !column.required)
    }
}

pub(in crate::level) struct RowReader<'a> {
    pub scale: PixelScale,
    pub images: Images<'a>,
    pub problems: Vec<Problem>,
}

#[derive(Clone, Debug)]
pub(in crate::level) struct FromRow<T> {
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
