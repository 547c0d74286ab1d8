//! Rows as plain structs that serde fills from the `csv` crate's records; the facts of a column stand beside its field.

use super::facts::{Column, Holds};
use crate::level::numbers::{self, NumberRange};
use crate::physics::{Material, Sides};
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
