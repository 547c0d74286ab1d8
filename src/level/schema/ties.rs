//! Rows of links.csv.

use super::facts::{Column, Count, FileSchema, Holds, RowSchema};
use super::record::{RowCells, RowReader};
use super::typed::{Row as _, Word, by_word, number, one_of, rows};
use super::values::LinkRowEnd;
use crate::level::numbers::{self};
use crate::level::problem::quoted;
use crate::level::unbound::UnboundLink;
use crate::physics::{LinkLaw, Magnet, Spring};
use crate::words::tr;

pub static LINKS: FileSchema = FileSchema {
    name: "links.csv",
    help: "Springs, ropes and magnets between two bodies, or a body and a place, at most 256 a level. With the distance ℓ of the centres, which \
           grows by ℓ′, and the length ℓ₀ a spring pulls with k·(ℓ − ℓ₀) + c·ℓ′; a rope does so where that pulls and ℓ > ℓ₀; a magnet pulls with \
           s/ℓ². A switch that is off lets the ends go; it stops a link that has a rate.",
    sample: "",
};
pub static LINK: RowSchema = RowSchema::new(&LINKS, "Link", LinkRow::COLUMNS)
    .fresh(&[("kind", "rope"), ("a", "ship"), ("stiffness", "5000"), ("damping", "100")])
    .counted(&[Count::if_any("link", "links", |level| level.links.len())]);

#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::level) enum LinkKind {
    Spring,
    Rope,
    Magnet,
}

by_word!(LinkKind, LinkBegin);

impl Word for LinkKind {
    fn words() -> Vec<(&'static str, Self)> {
        vec![("spring", Self::Spring), ("rope", Self::Rope), ("magnet", Self::Magnet)]
    }
}

/// Whether a link begins at once, or when its ends touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::level) enum LinkBegin {
    Start,
    Touch,
}

impl Word for LinkBegin {
    fn words() -> Vec<(&'static str, Self)> {
        vec![("", Self::Start), ("touch", Self::Touch)]
    }
}

rows! {
    LinkRow {
        kind: LinkKind = one_of::<LinkKind>("its law").or("rope"),
        a: LinkRowEnd = Column::new(Holds::End, "its first end"),
        b: LinkRowEnd = Column::new(Holds::End, "its other end; one of the two is a body"),
        length: Option<f64> = Column::new(Holds::Length, "the length ℓ₀ without a force; as the ends stand, where none is given").maybe(),
        stiffness: Option<f64> = number(numbers::STIFFNESS, "force k of a spring or rope for each metre that it is too long").maybe(),
        damping: Option<f64> = number(numbers::DAMPING, "force c of a spring or rope for each m/s at which its ends part").maybe(),
        strength: Option<f64> = number(numbers::STRENGTH, "force s of a magnet at 1 m; below 0 it pushes").maybe(),
        hook: LinkBegin = one_of::<LinkBegin>("begins when its ends first touch").or(""),
        breaks: Option<f64> = number(numbers::LOAD, "a force larger than this breaks it").maybe(),
        rate: f64 = number(numbers::BELT, "a winch: the growth of its length while its switch is on").or("0"),
        name: Option<String> = Column::new(Holds::Name, "the name by which switches work it").maybe(),
    }
}

pub fn link(record: &RowCells, reader: &mut RowReader) -> Option<UnboundLink> {
    let row: LinkRow = record.read(reader)?;
    let (kind, before) = (row.kind, reader.problems.len());
    let mut refuse = |column: &'static str, found: String, expected: &str| {
        reader.problems.push(record.problem(column, found, expected));
    };
    let given = |column: &str| record.text(column).filter(|text| !text.is_empty()).map(quoted);
    let (own, others): (_, &[&str]) = match kind {
        LinkKind::Magnet => ("strength", &["length", "stiffness", "damping", "rate"]),
        LinkKind::Spring | LinkKind::Rope => ("stiffness", &["strength"]),
    };
    for column in others.iter().filter_map(|column| Some((*column, given(column)?))) {
        let magnet = kind == LinkKind::Magnet;
        refuse(column.0, column.1, tr(if magnet { "nothing: a magnet has none" } else { "nothing: only a magnet has one" }));
    }
    if given(own).is_none() {
        let expected = tr(if kind == LinkKind::Magnet { "a strength in N·m²" } else { "a stiffness in N/m" });
        refuse(own, tr("nothing").to_owned(), expected);
    }
    let (length, breaks, damping) = (row.length, row.breaks, row.damping);
    let spring =
        |stiffness: f64| Spring { length: length.unwrap_or(0.0) / reader.scale.metre, stiffness, damping: damping.unwrap_or(0.0) };
    let law = match kind {
        LinkKind::Spring => LinkLaw::Spring(spring(row.stiffness?)),
        LinkKind::Rope => LinkLaw::Rope(spring(row.stiffness?)),
        LinkKind::Magnet => LinkLaw::Magnet(Magnet { strength: row.strength?, nearest: 0.0 }),
    };
    let (hook, rate, name) = (row.hook == LinkBegin::Touch, row.rate, row.name);
    let ends = [row.a, row.b].map(|end| end.in_metres(reader.scale));
    (reader.problems.len() == before).then_some(UnboundLink { ends, law, as_found: length.is_none(), hook, breaks, rate, name })
}
