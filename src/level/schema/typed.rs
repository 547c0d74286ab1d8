//! Columns with the type of their values. Every reader reports a problem and goes on, so that an author sees all at once: its `None` means
//! a reported problem.

use super::facts::{Column, Holds};
use super::record::{AskedCell, RowCells, RowReader};
use crate::level::image::PictureShape;
use crate::level::nearest::meant;
use crate::level::numbers::{self, NumberRange};
use crate::level::wiring::names_in;
use crate::physics::{DVec2, Material, Sides};
use crate::words::tr;

type ReadCell<T> = fn(&AskedCell, &mut RowReader) -> Option<T>;

/// A column whose cells hold a `T`; the row's field names it.
pub(super) struct TypedColumn<T> {
    facts: Column,
    read: ReadCell<T>,
}

/// A column that may be left out, and has no usual value.
pub(super) struct Maybe<T>(TypedColumn<T>);

impl<T> TypedColumn<T> {
    pub const fn new(holds: Holds, help: &'static str, read: ReadCell<T>) -> Self {
        Self { facts: Column { name: "", required: true, may_be_empty: false, usual: "", help, holds }, read }
    }

    /// `usual` holds where the cell is left out or empty.
    pub const fn or(self, usual: &'static str) -> Self {
        Self { facts: Column { required: false, may_be_empty: true, usual, ..self.facts }, ..self }
    }

    /// `usual` holds where the cell is left out; a cell that is there has to be filled.
    pub const fn unless_given(self, usual: &'static str) -> Self {
        Self { facts: Column { required: false, usual, ..self.facts }, ..self }
    }

    pub const fn maybe(self) -> Maybe<T> {
        Maybe(self.or(""))
    }

    pub const fn maybe_filled(self) -> Maybe<T> {
        Maybe(self.unless_given(""))
    }

    pub const fn named(&self, name: &'static str) -> Column {
        Column { name, ..self.facts }
    }

    pub fn read(&self, column: &'static str, record: &RowCells, reader: &mut RowReader) -> Option<T> {
        let text = match record.text(column) {
            None if self.facts.required => return None,
            None => self.facts.usual,
            Some("") if self.facts.may_be_empty => self.facts.usual,
            Some(text) => text,
        };
        (self.read)(&AskedCell { record, column, text, holds: self.facts.holds }, reader)
    }
}

impl<T> Maybe<T> {
    pub const fn named(&self, name: &'static str) -> Column {
        self.0.named(name)
    }

    pub fn read(&self, column: &'static str, record: &RowCells, reader: &mut RowReader) -> Option<Option<T>> {
        match record.text(column) {
            None => Some(None),
            Some("") if self.0.facts.may_be_empty => Some(None),
            Some(_) => self.0.read(column, record, reader).map(Some),
        }
    }
}

/// A struct of a row's cells, its columns, and their reader; `rectangle` stands for x, y, width and height. A field is `None` where its cell
/// is wrong or missing, which is reported.
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
        pub(in crate::level) struct $row { $(pub $field: Option<$type>,)* }

        impl $row {
            pub const COLUMNS: &'static [$crate::level::schema::facts::Column] = &[$($column.named(stringify!($field))),*];

            pub fn read(
                record: &$crate::level::schema::record::RowCells,
                reader: &mut $crate::level::schema::record::RowReader,
            ) -> Self {
                Self { $($field: $column.read(stringify!($field), record, reader),)* }
            }
        }
    };
}
pub(super) use rows;

pub(super) const fn number(range: NumberRange, help: &'static str) -> TypedColumn<f64> {
    TypedColumn::new(Holds::Number(range), help, read_number)
}

pub(super) const fn position(help: &'static str) -> TypedColumn<f64> {
    TypedColumn::new(Holds::Position, help, read_number)
}

pub(super) const fn size(help: &'static str) -> TypedColumn<f64> {
    TypedColumn::new(Holds::Size, help, read_number)
}

pub(super) const fn reach(help: &'static str) -> TypedColumn<f64> {
    TypedColumn::new(Holds::Reach, help, read_number)
}

fn read_number(asked: &AskedCell, reader: &mut RowReader) -> Option<f64> {
    let range = asked.holds.range(reader.scale)?;
    asked.or_refuse(reader, range.parse(asked.text))
}

pub(super) const fn whole(low: u32, high: u32, help: &'static str) -> TypedColumn<u32> {
    TypedColumn::new(Holds::Whole(low, high), help, read_whole)
}

fn read_whole(asked: &AskedCell, reader: &mut RowReader) -> Option<u32> {
    let Holds::Whole(low, high) = asked.holds else { return None };
    let number = asked.text.parse().ok().filter(|number| (low..=high).contains(number));
    asked.or_refuse(reader, number.ok_or_else(|| whole_number(low, high)))
}

pub(super) fn whole_number(least: u32, most: u32) -> String {
    tr!("a whole number from {least} to {most}", least, most)
}

pub(super) const fn channel(help: &'static str) -> TypedColumn<u8> {
    TypedColumn::new(Holds::Whole(0, 255), help, |asked, reader| {
        let number = numbers::COLOUR.parse(asked.text).ok().filter(|number| number.fract() == 0.0);
        // In range and whole: the conversion is exact.
        asked.or_refuse(reader, number.map(|number| number as u8).ok_or_else(|| whole_number(0, 255)))
    })
}

pub(super) const fn boolean(help: &'static str) -> TypedColumn<bool> {
    TypedColumn::new(Holds::OneOf(|| vec!["FALSE", "TRUE"]), help, |asked, reader| {
        let value = match asked.text.to_ascii_lowercase().as_str() {
            "true" => Ok(true),
            "false" => Ok(false),
            _ => Err(tr("TRUE or FALSE").into()),
        };
        asked.or_refuse(reader, value)
    })
}

/// A value that a file names by one of a few words.
pub trait Word: Sized {
    fn words() -> Vec<(&'static str, Self)>;
}

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

/// In any case.
pub(super) const fn one_of<T: Word>(help: &'static str) -> TypedColumn<T> {
    TypedColumn::new(Holds::OneOf(names::<T>), help, |asked, reader| {
        let found = T::words().into_iter().find(|(word, _)| word.eq_ignore_ascii_case(asked.text)).map(|(_, value)| value);
        let expected = || {
            let all: Vec<&str> = names::<T>().into_iter().filter(|word| !word.is_empty()).collect();
            tr!("one of {list}", list = all.join(", ")) + &meant(asked.text, all)
        };
        asked.or_refuse(reader, found.ok_or_else(expected))
    })
}

fn names<T: Word>() -> Vec<&'static str> {
    T::words().into_iter().map(|(word, _)| word).collect()
}

/// Any text that is not empty.
pub(super) const fn words(holds: &'static str, help: &'static str) -> TypedColumn<String> {
    TypedColumn::new(Holds::Text(holds), help, |asked, reader| {
        asked.or_refuse(reader, if asked.text.is_empty() { Err(tr("text").into()) } else { Ok(asked.text.to_owned()) })
    })
}

const MOST_NAMES: usize = 8;

/// Names by which switches find a thing, with & between them.
pub(super) const fn name(help: &'static str) -> TypedColumn<String> {
    TypedColumn::new(Holds::Name, help, |asked, reader| {
        let expected = tr("a name of letters, digits, - and _ that begins with a letter");
        let named = names_in(asked.text).all(is_name) && names_in(asked.text).count() <= MOST_NAMES;
        asked.or_refuse(reader, if named { Ok(asked.text.to_owned()) } else { Err(expected.into()) })
    })
}

pub(super) fn is_name(text: &str) -> bool {
    text.chars().count() <= 40
        && text.chars().next().is_some_and(char::is_alphabetic)
        && text.chars().all(|c| c.is_alphanumeric() || matches!(c, '-' | '_'))
}

/// The size is in pixels.
pub(super) const fn picture(help: &'static str) -> TypedColumn<PictureShape> {
    TypedColumn::new(Holds::Picture, help, |asked, reader| {
        let shape = reader.images.look(asked.text, reader.scale);
        shape.map_err(|(found, expected)| reader.problems.push(asked.record.problem(asked.column, found, expected))).ok()
    })
}

/// As [`picture`]; in an unfinished level a box stands in for a missing one.
pub(super) const fn picture_or_box(help: &'static str) -> TypedColumn<PictureShape> {
    TypedColumn::new(Holds::Picture, help, |asked, reader| {
        (picture("").read)(asked, reader).or_else(|| reader.images.stand_in.clone())
    })
}

const MOST_STOPS: usize = 50;

/// `600 300; 600 100`: top left corners in pixels, here in metres.
pub(super) const fn way_points(help: &'static str) -> TypedColumn<Vec<DVec2>> {
    TypedColumn::new(Holds::Points, help, |asked, reader| {
        let points = parse_points(asked.text, reader);
        asked.or_refuse(reader, points)
    })
}

fn parse_points(text: &str, reader: &RowReader) -> Result<Vec<DVec2>, String> {
    let expected = || tr("way points such as 600 300; 600 100: x and y in pixels, a semicolon between them").to_owned();
    let points: Vec<&str> = text.split(';').map(str::trim).filter(|point| !point.is_empty()).collect();
    if points.is_empty() {
        return Err(expected());
    }
    if points.len() > MOST_STOPS {
        return Err(tr!("at most {most} way points", most = MOST_STOPS));
    }
    let range = reader.scale.coordinate();
    let point = |point: &&str| match point.split_whitespace().collect::<Vec<_>>()[..] {
        [x, y] => Ok(reader.scale.metres(range.parse(x)?, range.parse(y)?)),
        _ => Err(expected()),
    };
    points.iter().map(point).collect()
}

pub(super) const X: TypedColumn<f64> = position("left edge");
pub(super) const Y: TypedColumn<f64> = position("upper edge");
pub(super) const WIDTH: TypedColumn<f64> = size("from the left edge to the right one");
pub(super) const HEIGHT: TypedColumn<f64> = size("from the upper edge to the lower one");
pub(super) const CENTRE_X: TypedColumn<f64> = position("centre, from the left edge of the level");
pub(super) const CENTRE_Y: TypedColumn<f64> = position("centre, from the upper edge of the level");
pub(super) const VX: TypedColumn<f64> = number(numbers::VELOCITY, "velocity at the start, to the right").or("0");
pub(super) const VY: TypedColumn<f64> = number(numbers::VELOCITY, "velocity at the start, downwards").or("0");
pub(super) const MATERIAL: TypedColumn<Material> = one_of("static and kinetic friction, and restitution").or("Asphalt");
