//! The facts of a file, of a kind of row and of a column, for the loader, the editor, `new`, `check` and the documentation.

use super::values::{LinkRowEnd, Together, WayPoints, Works, is_name};
use crate::files::{Dialect, truth};
use crate::level::numbers::{self, NumberRange, PixelScale, power};
use crate::level::problem::{Problem, meant};
use crate::{level::types::Level, level::wiring::names_in, physics::DVec2, words::tr};
use std::borrow::Cow;

#[derive(Debug)]
pub struct FileSchema {
    pub name: &'static str,
    pub help: &'static str,
    /// The rows of a new level, as text; empty where a new level has no such file.
    pub sample: &'static str,
}

#[derive(Debug)]
pub struct RowSchema {
    pub file: &'static FileSchema,
    /// The first cell of such a row, in a file with rows of several kinds; else empty.
    pub tag: &'static str,
    pub name: &'static str,
    pub columns: &'static [Column],
    /// The cells of a new one besides its place and size.
    pub fresh: &'static [(&'static str, &'static str)],
    /// Width and height of a new one that a click puts down, pixels.
    pub usual_size: (f64, f64),
    /// x and y are its centre, not its top left corner.
    pub by_centre: bool,
    pub counts: &'static [Count],
}

/// The words for one thing and for several, and their number in a level.
#[derive(Clone, Copy, Debug)]
pub struct Count {
    pub one: &'static str,
    pub many: &'static str,
    /// A level with none says so.
    pub at_none: bool,
    pub of: fn(&Level) -> usize,
}

#[derive(Clone, Copy, Debug)]
pub struct Column {
    pub name: &'static str,
    /// Each row has to fill it.
    pub required: bool,
    /// A cell that is there may be empty. A setting with a usual value may be left out, but not named without a value.
    pub may_be_empty: bool,
    /// The text of a cell that is left out; empty where there is none.
    pub usual: &'static str,
    pub help: &'static str,
    pub(in crate::level) holds: Holds,
}

/// What a cell may hold; places and sizes in pixels, words and flags in any case.
#[derive(Clone, Copy, Debug)]
pub(in crate::level) enum Holds {
    Position,
    /// A width, a height or another size, pixels.
    Size,
    /// A size, or 0, pixels.
    Length,
    /// A size with a sign, or 0, pixels.
    Reach,
    Number(NumberRange),
    /// Both ends included.
    Whole(u32, u32),
    OneOf(fn() -> Vec<&'static str>),
    Flag,
    /// By which switches find a thing.
    Name,
    /// By which links find a body.
    BodyName,
    /// Names that a switch works.
    Works,
    /// Of a link.
    End,
    /// A picture's path or a plain shape; in an unfinished level a box may stand in for that of a body.
    Picture {
        of_body: bool,
    },
    Points,
    /// A number of objectives, and seconds.
    Together,
    /// Text, described in a few words.
    Text(&'static str),
    /// Any text, also none.
    Any(&'static str),
}

const MOST_NAMES: usize = 8;

impl Holds {
    pub fn range(&self, scale: PixelScale) -> Option<NumberRange> {
        match self {
            Self::Position | Self::Reach => Some(scale.coordinate()),
            Self::Size => Some(scale.size()),
            Self::Length => Some(scale.length()),
            Self::Number(range) => Some(*range),
            _ => None,
        }
    }

    /// Errors: what is expected in place of a cell. Pictures are judged by their files.
    pub fn judge(&self, text: &str, scale: PixelScale) -> Result<(), String> {
        let wanted = |good: bool, expected: &str| if good { Ok(()) } else { Err(tr(expected).to_owned()) };
        let inside = |places: &[DVec2]| places.iter().flat_map(DVec2::to_array).try_for_each(|side| scale.coordinate().judge(side));
        match self {
            Self::Position | Self::Reach | Self::Size | Self::Length | Self::Number(_) => {
                self.range(scale).map_or(Ok(()), |range| range.parse(text).map(drop))
            }
            Self::Whole(low, high) => {
                let whole = numbers::number(text).ok().filter(|number| number.fract() == 0.0);
                let good = whole.is_some_and(|number| (f64::from(*low)..=f64::from(*high)).contains(&number));
                if good { Ok(()) } else { Err(whole_number(*low, *high)) }
            }
            Self::OneOf(words) if words().iter().any(|word| word.eq_ignore_ascii_case(text)) => Ok(()),
            Self::OneOf(words) => {
                let all: Vec<&str> = words().into_iter().filter(|word| !word.is_empty()).collect();
                Err(tr!("one of {list}", list = all.join(", ")) + &meant(text, all))
            }
            Self::Flag => wanted(truth(text).is_some(), "TRUE or FALSE"),
            Self::Name => {
                let named = names_in(text).all(is_name) && names_in(text).count() <= MOST_NAMES;
                wanted(named, "a name of letters, digits, - and _ that begins with a letter")
            }
            Self::BodyName => {
                let good = is_name(text) && !text.eq_ignore_ascii_case("ship");
                wanted(good, "a name of letters, digits, - and _ that begins with a letter, other than ship")
            }
            Self::Works => Works::try_from(text.to_owned()).map(drop),
            Self::End => match LinkRowEnd::try_from(text.to_owned())? {
                LinkRowEnd::Place(place) => inside(&[place]),
                LinkRowEnd::Ship | LinkRowEnd::Object(_) => Ok(()),
            },
            Self::Together => Together::try_from(text.to_owned()).map(drop),
            Self::Points => inside(&WayPoints::try_from(text.to_owned())?.0),
            Self::Text(_) => wanted(!text.is_empty(), "text"),
            Self::Picture { .. } | Self::Any(_) => Ok(()),
        }
    }

    /// A good cell as serde reads it.
    pub fn plain<'a>(&self, text: &'a str) -> Cow<'a, str> {
        match self {
            _ if text.is_empty() => text.into(),
            Self::OneOf(words) => words().into_iter().find(|word| word.eq_ignore_ascii_case(text)).unwrap_or_default().into(),
            Self::Flag => truth(text).unwrap_or_default().to_string().into(),
            Self::Whole(..) if text.parse::<u32>().is_err() => numbers::number(text).unwrap_or_default().to_string().into(),
            _ => text.into(),
        }
    }

    /// A cell's numbers with decimal points, and its TRUE or FALSE in English; other cells as they are.
    pub fn in_plain_dialect<'a>(&self, dialect: Dialect, text: &'a str) -> Cow<'a, str> {
        match self {
            Self::Flag if ["true", "false"].iter().any(|word| word.eq_ignore_ascii_case(text)) => text.into(),
            Self::Flag => truth(text).map_or(text, |truth| if truth { "TRUE" } else { "FALSE" }).into(),
            Self::Points | Self::End | Self::Together => dialect.numbers(text),
            _ if self.has_numbers() => dialect.number(text),
            _ => text.into(),
        }
    }

    pub const fn has_numbers(&self) -> bool {
        use Holds::{End, Length, Number, Points, Position, Reach, Size, Together, Whole};
        matches!(self, Position | Size | Length | Reach | Number(_) | Whole(..) | Points | End | Together)
    }
}

pub(super) fn whole_number(least: u32, most: u32) -> String {
    tr!("a whole number from {least} to {most}", least, most)
}

impl Column {
    pub(super) const fn new(holds: Holds, help: &'static str) -> Self {
        Self { name: "", required: true, may_be_empty: false, usual: "", help, holds }
    }

    /// `usual` holds where the cell is left out or empty.
    pub(super) const fn or(self, usual: &'static str) -> Self {
        Self { required: false, may_be_empty: true, usual, ..self }
    }

    /// `usual` holds where the cell is left out; a cell that is there has to be filled.
    pub(super) const fn unless_given(self, usual: &'static str) -> Self {
        Self { required: false, usual, ..self }
    }

    /// It may be left out, and has no usual value.
    pub(super) const fn maybe(self) -> Self {
        self.or("")
    }

    pub(super) const fn maybe_filled(self) -> Self {
        self.unless_given("")
    }

    pub(super) const fn named(self, name: &'static str) -> Self {
        Self { name, ..self }
    }

    /// Its name, in brackets where it may be left out.
    pub(in crate::level) fn in_brackets(&self) -> String {
        if self.required { self.name.to_owned() } else { format!("[{}]", self.name) }
    }

    /// As a field shows it beside its text; the limits of a number without a unit.
    pub fn unit(&self) -> String {
        match self.holds {
            Holds::Position | Holds::Size | Holds::Length | Holds::Reach | Holds::Points => "px".to_owned(),
            Holds::Number(range) => range.sign(),
            Holds::Whole(low, high) => format!("{low}–{high}"),
            _ => String::new(),
        }
    }

    /// Its words, the usual one first; none where its text is free.
    pub fn choices(&self) -> Vec<&'static str> {
        let mut words = match self.holds {
            Holds::OneOf(words) => words(),
            Holds::Flag => vec!["FALSE", "TRUE"],
            _ => return Vec::new(),
        };
        words.sort_by_key(|word| *word != self.usual);
        words
    }

    /// The values of its cells, with limits and unit.
    pub fn limits(&self) -> String {
        let (least, most) = PixelScale::LIMITS.map(power).into();
        match self.holds {
            Holds::Position => tr!("pixels, at most {most} m from the corner", most),
            Holds::Size => tr!("pixels, {least} … {most} m", least, most),
            Holds::Length => tr!("pixels, 0 … {most} m", most),
            Holds::Reach => tr!("pixels, 0 or {least} … {most} m to either side", least, most),
            Holds::Number(range) => range.in_words(),
            Holds::Whole(low, high) => tr!("{low} … {high}, whole", low, high),
            Holds::OneOf(_) | Holds::Flag => {
                let words = self.choices().into_iter().filter(|word| !word.is_empty());
                words.map(|word| format!("`{word}`")).collect::<Vec<_>>().join(", ")
            }
            Holds::Name => tr("a word of letters, digits, - and _; with `a&b` a switch of each has to be on").to_owned(),
            Holds::BodyName => tr("a word of letters, digits, - and _").to_owned(),
            Holds::Works => tr("names, such as `gate !fan`").to_owned(),
            Holds::End => tr("`ship`, the `name` of an object or key object, or a place `x y` in pixels").to_owned(),
            Holds::Picture { .. } => tr("a PNG's path, `box:40x40` or `ball:40x40`").to_owned(),
            Holds::Points => tr("`x y; x y; …` in pixels").to_owned(),
            Holds::Together => tr("`n s`, such as `3 8`").to_owned(),
            Holds::Text(words) | Holds::Any(words) => tr(words).to_owned(),
        }
    }

    /// `fuel: fuel in it (0 … 10¹² fuel units)`.
    pub fn in_words(&self) -> String {
        let usual = if self.usual.is_empty() { String::new() } else { tr!("; {usual} where it is left out", usual = self.usual) };
        format!("{}: {} ({}{usual})", self.name, tr(self.help), self.limits().replace('`', ""))
    }

    pub(in crate::level) fn is_name(&self) -> bool {
        matches!(self.holds, Holds::Name)
    }

    pub(in crate::level) fn is_picture(&self) -> bool {
        matches!(self.holds, Holds::Picture { .. })
    }
}

impl Count {
    pub(super) const fn always(one: &'static str, many: &'static str, of: fn(&Level) -> usize) -> Self {
        Self { one, many, at_none: true, of }
    }

    pub(super) const fn if_any(one: &'static str, many: &'static str, of: fn(&Level) -> usize) -> Self {
        Self { one, many, at_none: false, of }
    }
}

impl RowSchema {
    pub(super) const fn new(file: &'static FileSchema, name: &'static str, columns: &'static [Column], size: (f64, f64)) -> Self {
        Self { file, tag: "", name, columns, fresh: &[], usual_size: size, by_centre: false, counts: &[] }
    }

    pub(super) const fn tagged(self, tag: &'static str) -> Self {
        Self { tag, ..self }
    }

    pub(super) const fn fresh(self, fresh: &'static [(&'static str, &'static str)]) -> Self {
        Self { fresh, ..self }
    }

    pub(super) const fn by_centre(self) -> Self {
        Self { by_centre: true, ..self }
    }

    pub(super) const fn counted(self, counts: &'static [Count]) -> Self {
        Self { counts, ..self }
    }

    pub(in crate::level) fn find(&self, name: &str) -> Option<&'static Column> {
        self.columns.iter().find(|column| column.name.eq_ignore_ascii_case(name.trim()))
    }

    pub fn columns_text(&self) -> String {
        self.columns.iter().map(Column::in_brackets).collect::<Vec<_>>().join(",")
    }

    pub(in crate::level) fn columns_wanted(&self) -> String {
        tr!("the columns {columns}", columns = self.columns_text())
    }

    /// [`Self::columns_wanted`], with the nearest one.
    pub(in crate::level) fn wanted(&self, misspelt: &str) -> String {
        self.columns_wanted() + &meant(misspelt, self.columns.iter().map(|column| column.name))
    }

    /// A problem of the whole file or row, for which its first column stands.
    pub(in crate::level) fn problem(&self, line: usize, found: impl Into<String>, expected: impl Into<String>) -> Problem {
        Problem::new(self.file.name, line, self.columns.first().map_or("", |column| column.name), found, expected)
    }
}
