//! The facts of a file, of a kind of row and of a column, for the loader, the editor, `new`, `check` and the documentation.

use crate::level::nearest::meant;
use crate::level::numbers::{NumberRange, PixelScale, power};
use crate::level::problem::Problem;
use crate::level::types::Level;
use crate::words::tr;

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

#[derive(Clone, Copy, Debug)]
pub(in crate::level) enum Holds {
    /// A coordinate, pixels.
    Position,
    /// A width, a height or another size, pixels.
    Size,
    /// A size, or 0, pixels.
    Length,
    /// A size with a sign, or 0, pixels.
    Reach,
    Number(NumberRange),
    /// A whole number, both ends included.
    Whole(u32, u32),
    /// One of these words, in any case.
    OneOf(fn() -> Vec<&'static str>),
    /// By which switches find a thing.
    Name,
    /// A picture's path or a plain shape.
    Picture,
    /// Pairs of coordinates, pixels.
    Points,
    /// Text, described in a few words.
    Text(&'static str),
}

impl Holds {
    /// `None` where cells hold no number.
    pub fn range(&self, scale: PixelScale) -> Option<NumberRange> {
        match self {
            Self::Position | Self::Reach => Some(scale.coordinate()),
            Self::Size => Some(scale.size()),
            Self::Length => Some(scale.length()),
            Self::Number(range) => Some(*range),
            _ => None,
        }
    }
}

impl Column {
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
        let Holds::OneOf(words) = self.holds else { return Vec::new() };
        let mut words = words();
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
            Holds::OneOf(_) => {
                let words = self.choices().into_iter().filter(|word| !word.is_empty());
                words.map(|word| format!("`{word}`")).collect::<Vec<_>>().join(", ")
            }
            Holds::Name => tr("a word of letters, digits, - and _; with `a&b` a switch of each has to be on").to_owned(),
            Holds::Picture => tr("a PNG's path, `box:40x40` or `ball:40x40`").to_owned(),
            Holds::Points => tr("`x y; x y; …` in pixels").to_owned(),
            Holds::Text(words) => tr(words).to_owned(),
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
        matches!(self.holds, Holds::Picture)
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
    pub(super) const fn new(file: &'static FileSchema, name: &'static str, columns: &'static [Column]) -> Self {
        Self { file, tag: "", name, columns, fresh: &[], usual_size: (51.0, 51.0), by_centre: false, counts: &[] }
    }

    pub(super) const fn tagged(self, tag: &'static str) -> Self {
        Self { tag, ..self }
    }

    pub(super) const fn fresh(self, fresh: &'static [(&'static str, &'static str)]) -> Self {
        Self { fresh, ..self }
    }

    pub(super) const fn size(self, width: f64, height: f64) -> Self {
        Self { usual_size: (width, height), ..self }
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

    /// The names of all columns; those in brackets may be left out.
    pub fn columns_text(&self) -> String {
        self.columns.iter().map(Column::in_brackets).collect::<Vec<_>>().join(",")
    }

    /// The columns as a refusal names them.
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
