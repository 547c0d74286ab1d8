//! Links: what an author chooses of them, and their ends by the names of bodies or as places; and the wires from switches to things, by name.

use super::model::{Document, NewRow, RowId, SetCell};
use super::places::{Place, number, point};
use crate::level::schema::{Column, Kind, Table};
use crate::{level::wiring::names_in, physics::DVec2, words::tr};
use std::collections::BTreeMap;

/// A link is taken hold of by a square around its middle, pixels.
const HOLD: f64 = 20.0;

/// The columns of the ends, and the tables of the bodies that these name.
const ENDS: [&str; 2] = ["a", "b"];
const BODIES: [Table; 2] = [Table::Objects, Table::Objectives];

/// A kind of link as authors know them: a winch is a rope with a rate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LinkForm {
    Spring,
    Rope,
    Magnet,
    Winch,
}

/// The numbers of a law: a magnet has the last one, the others may have the first four.
const NUMBERS: [&str; 5] = ["length", "stiffness", "damping", "rate", "strength"];

impl LinkForm {
    pub const ALL: [Self; 4] = [Self::Spring, Self::Rope, Self::Magnet, Self::Winch];

    /// For people.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Spring => "Coil spring",
            Self::Rope => "Rope",
            Self::Magnet => "Magnet",
            Self::Winch => "Winch",
        }
    }

    /// Of the first column of links.csv, whose usual word is rope.
    fn of_kind(kind: &str) -> Self {
        let is = |form: &Self| form.cells().iter().any(|(column, text)| *column == "kind" && text.eq_ignore_ascii_case(kind));
        Self::ALL.into_iter().find(is).unwrap_or(Self::Rope)
    }

    /// Of a new one, besides its ends. A ship of 100 kg hangs 1 m deep on the spring in 15 N/kg, and a magnet 10 m away pulls as hard as 2 m/s² do.
    fn cells(self) -> &'static [(&'static str, &'static str)] {
        match self {
            Self::Spring => &[("kind", "spring"), ("stiffness", "1500"), ("damping", "100")],
            Self::Rope => Kind::Link.schema().fresh,
            Self::Magnet => &[("kind", "magnet"), ("strength", "20000")],
            Self::Winch => &[("kind", "rope"), ("stiffness", "5000"), ("damping", "100"), ("rate", "-1")],
        }
    }
}

impl Document {
    /// Adds a link between the bodies at these places, pixels, or a body and a place. A body without a name gets one.
    /// Errors: two places, or one body; as [`Document::set`].
    pub fn link(&mut self, form: LinkForm, places: [DVec2; 2], gesture: u64) -> Result<Vec<RowId>, String> {
        let (ends, names) = self.ends_at(places);
        self.judge_ends(&ends)?;
        self.set(&names, Some(gesture))?;
        let own = form.cells().iter().map(|(column, text)| (*column, (*text).to_owned()));
        let cells = own.chain(ENDS.into_iter().zip(ends)).collect();
        self.add_in(&[NewRow { kind: Kind::Link, cells }], Some(gesture))
    }

    /// The cells that lead an end of a link, 0 or 1, to the body at a place, pixels, or to that place. Errors: as [`Document::link`].
    pub fn led(&self, row: RowId, end: usize, to: DVec2) -> Result<Vec<SetCell>, String> {
        let ([text], mut cells) = self.ends_at([to]);
        let mut ends = ENDS.map(|column| self.cell(row, column).unwrap_or_default().to_owned());
        ends[end].clone_from(&text);
        self.judge_ends(&ends)?;
        cells.push(SetCell { row, column: ENDS[end], text });
        Ok(cells)
    }

    fn judge_ends(&self, ends: &[String; 2]) -> Result<(), String> {
        if ends[0] == ends[1] || ends.iter().all(|end| point(end).is_some()) {
            return Err(tr("A link joins two bodies, or a body and a place: pull it from the one to the other.").to_owned());
        }
        Ok(())
    }

    /// The cells of the ends at these places, pixels, and the cells that name their bodies.
    fn ends_at<const N: usize>(&self, places: [DVec2; N]) -> ([String; N], Vec<SetCell>) {
        let mut named: Vec<SetCell> = Vec::new();
        let ends = places.map(|at| {
            let Some(row) = self.body_at(at) else { return place_text(at.round()) };
            if row.table == Table::Player {
                return "ship".to_owned();
            }
            let given = named.iter().find(|cell| cell.row == row).map(|cell| cell.text.clone());
            given.or_else(|| self.cell(row, "name").filter(|name| !name.is_empty()).map(str::to_owned)).unwrap_or_else(|| {
                let taken: Vec<&str> = named.iter().map(|cell| cell.text.as_str()).collect();
                let text = self.free_body_name(if self.kind(row) == Some(Kind::Key) { "key" } else { "box" }, &taken);
                named.push(SetCell { row, column: "name", text: text.clone() });
                text
            })
        });
        (ends, named)
    }

    /// A name like that one, which no body has, and none of these.
    pub(super) fn free_body_name(&self, like: &str, taken: &[&str]) -> String {
        let stem = like.trim_end_matches(|letter: char| letter.is_ascii_digit());
        let bodies = || BODIES.into_iter().flat_map(|table| self.rows(table));
        let is_free = |name: &String| {
            !taken.contains(&name.as_str()) && !bodies().any(|row| self.cell(row, "name").is_some_and(|known| known == name))
        };
        let more = (2_u32..).map(|number| format!("{stem}{number}"));
        [like.to_owned()].into_iter().chain(more).find(is_free).unwrap_or_default()
    }

    /// The smallest body at a place, pixels.
    pub fn body_at(&self, at: DVec2) -> Option<RowId> {
        let is_body = |row: &RowId| matches!(self.kind(*row), Some(Kind::Ship | Kind::Object | Kind::Key));
        let bodies = self.things().filter(|(row, place)| place.contains(at) && is_body(row));
        bodies.min_by(|(_, a), (_, b)| a.size.element_product().total_cmp(&b.size.element_product())).map(|(row, _)| row)
    }

    /// These rows, and the bodies at the ends of the links among them: both ends of a link move alike.
    pub fn with_ends(&self, rows: &[RowId]) -> Vec<RowId> {
        let ends = rows.iter().flat_map(|row| ENDS.map(|column| self.end_body(*row, column)));
        let mut all: Vec<RowId> = rows.iter().copied().chain(ends.flatten()).collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    /// These cells, and where the kind of a link is one of them, the numbers that its law wants in the place of those that it has not.
    pub fn with_law(&self, mut cells: Vec<SetCell>) -> Vec<SetCell> {
        let mut more = Vec::new();
        for SetCell { row, text, .. } in cells.iter().filter(|cell| cell.row.table == Table::Links && cell.column == "kind") {
            let form = LinkForm::of_kind(text);
            for column in NUMBERS {
                let (has, wants) = (self.cell(*row, column).is_some_and(|cell| !cell.is_empty()), form.cells());
                let text = wants.iter().find(|(name, _)| *name == column).map_or("", |(_, text)| text);
                let foreign = (form == LinkForm::Magnet) != (column == "strength");
                if if has { foreign } else { !text.is_empty() } {
                    more.push(SetCell { row: *row, column, text: text.to_owned() });
                }
            }
        }
        cells.extend(more);
        cells
    }

    /// What the cells of a link make of it.
    pub fn link_form(&self, row: RowId) -> LinkForm {
        let kind = self.cell(row, "kind").unwrap_or_default();
        match LinkForm::of_kind(kind) {
            LinkForm::Rope if self.number(row, "rate").is_some_and(|rate| rate != 0.0) => LinkForm::Winch,
            form => form,
        }
    }

    fn end_body(&self, row: RowId, column: &str) -> Option<RowId> {
        let text = self.cell(row, column).filter(|_| row.table == Table::Links)?.trim();
        if text.eq_ignore_ascii_case("ship") {
            return self.rows(Table::Player).next();
        }
        let mut bodies = BODIES.into_iter().flat_map(|table| self.rows(table));
        bodies.find(|body| !text.is_empty() && self.cell(*body, "name") == Some(text))
    }

    /// The ends of a row of links.csv, pixels; `None` where one of them is no place and no body.
    pub fn link_ends(&self, row: RowId) -> Option<[DVec2; 2]> {
        let end = |column| match point(self.cell(row, column)?) {
            Some(place) => Some(place),
            None => self.place(self.end_body(row, column)?).map(|body| body.centre()),
        };
        Some([end("a")?, end("b")?])
    }

    pub(super) fn link_place(&self, row: RowId) -> Option<Place> {
        let [a, b] = self.link_ends(row)?;
        Some(Place { min: (a + b) * 0.5 - HOLD * 0.5, size: DVec2::splat(HOLD) })
    }

    /// The cells of a link whose places have moved by `by` pixels.
    pub(super) fn moved_link(&self, row: RowId, by: DVec2) -> Vec<SetCell> {
        let moved = |column| Some(SetCell { row, column, text: shifted_end(self.cell(row, column)?, by)? });
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

/// The text of an end that is a place, moved by `by` pixels.
pub(super) fn shifted_end(text: &str, by: DVec2) -> Option<String> {
    Some(place_text(point(text)? + by))
}

/// `600 300`.
fn place_text(place: DVec2) -> String {
    format!("{} {}", number(place.x), number(place.y))
}

fn worked() -> impl Iterator<Item = Table> {
    Table::ALL.iter().copied().filter(|table| table.has(Column::is_name))
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Wiring {
    pub switch: RowId,
    pub thing: RowId,
    /// The thing is on while the switch is off.
    pub inverted: bool,
}

impl Document {
    pub fn wires(&self) -> Vec<Wiring> {
        let name = |row| Some((row, self.cell(row, "name").filter(|name| !name.is_empty())?));
        let named: Vec<(RowId, &str)> = worked().flat_map(|table| self.rows(table)).filter_map(name).collect();
        let mut wires = Vec::new();
        for switch in self.rows(Table::Switches) {
            for word in self.cell(switch, "works").unwrap_or_default().split_whitespace() {
                let (name, inverted) = (word.trim_start_matches('!'), word.starts_with('!'));
                let things = named.iter().filter(|(_, known)| names_in(known).any(|known| known == name));
                wires.extend(things.map(|(thing, _)| Wiring { switch, thing: *thing, inverted }));
            }
        }
        wires
    }

    pub fn can_be_worked(&self, row: RowId) -> bool {
        row.table.has(Column::is_name)
    }

    /// The cells that add the wire between a switch and a thing, or remove it. A thing without a name gets one.
    pub fn rewired(&self, switch: RowId, thing: RowId) -> Vec<SetCell> {
        let (Some(Kind::Switch), Some(kind), true) = (self.kind(switch), self.kind(thing), self.can_be_worked(thing)) else {
            return Vec::new();
        };
        let mut cells = Vec::new();
        let name = match self.cell(thing, "name").filter(|name| !name.is_empty()) {
            Some(name) => name.to_owned(),
            None => {
                let name = self.free_name(kind);
                cells.push(SetCell { row: thing, column: "name", text: name.clone() });
                name
            }
        };
        let known = self.names();
        let works = self.cell(switch, "works").unwrap_or_default();
        let mut words: Vec<&str> = works.split_whitespace().collect();
        let is_own = |word: &&str| names_in(&name).any(|name| name == word.trim_start_matches('!'));
        if words.iter().any(is_own) {
            words.retain(|word| !is_own(word));
        } else {
            // A new switch works a name that no thing has.
            words.retain(|word| known.iter().any(|known| *known == word.trim_start_matches('!')));
            let works = |row| self.cell(row, "works").unwrap_or_default().split_whitespace();
            let worked = |name: &&str| self.rows(Table::Switches).flat_map(works).any(|word| word.trim_start_matches('!') == *name);
            words.extend(names_in(&name).find(|name| !worked(name)).or_else(|| names_in(&name).next()));
        }
        cells.push(SetCell { row: switch, column: "works", text: words.join(" ") });
        cells
    }

    /// The switches' cells when things get other names, by the wires before the gesture: a name typed letter by letter may pass another thing's.
    pub(super) fn renamed(&self, cells: &[SetCell], gesture: Option<u64>) -> Vec<SetCell> {
        let is_name = |cell: &&SetCell| cell.column == "name" && self.can_be_worked(cell.row);
        let named: BTreeMap<RowId, &str> = cells.iter().filter(is_name).map(|cell| (cell.row, cell.text.trim())).collect();
        if named.is_empty() {
            return Vec::new();
        }
        let mut new: BTreeMap<String, Vec<String>> = BTreeMap::new();
        for table in worked() {
            let before = self.before(table, gesture);
            for row in 0..before.rows().len() {
                let Some(old) = before.cell(row, "name").filter(|name| !name.is_empty()) else { continue };
                // The switches keep the old name until the new one is a word.
                let one_word = |name: &&str| !name.is_empty() && !name.starts_with('!') && !name.contains(char::is_whitespace);
                let name = named.get(&RowId { table, row }).copied().unwrap_or(old);
                for (old, name) in names_in(old).zip(names_in(name).map(Some).chain(std::iter::repeat(None))) {
                    let name = name.filter(one_word).unwrap_or(old);
                    let names = new.entry(old.to_owned()).or_default();
                    if !names.iter().any(|known| known == name) {
                        names.push(name.to_owned());
                    }
                }
            }
        }
        let before = self.before(Table::Switches, gesture);
        let mut rewired = Vec::new();
        for (index, row) in before.rows().iter().enumerate() {
            let good = row.cells.iter().all(|cell| cell.fault.is_none());
            let Some(works) = before.cell(index, "works").filter(|_| good) else { continue };
            let mut words: Vec<String> = Vec::new();
            for word in works.split_whitespace() {
                let (sign, name) = word.split_at(usize::from(word.starts_with('!')));
                let kept = [name.to_owned()];
                for name in new.get(name).map_or(&kept[..], Vec::as_slice) {
                    let word = format!("{sign}{name}");
                    if !words.contains(&word) {
                        words.push(word);
                    }
                }
            }
            let text = if works.split_whitespace().eq(&words) { works.to_owned() } else { words.join(" ") };
            let row = RowId { table: Table::Switches, row: index };
            if self.cell(row, "works") != Some(text.as_str()) {
                rewired.push(SetCell { row, column: "works", text });
            }
        }
        rewired
    }

    pub(super) fn names(&self) -> Vec<&str> {
        let rows = worked().flat_map(|table| self.rows(table));
        rows.flat_map(|row| names_in(self.cell(row, "name").unwrap_or_default()).filter(|name| !name.is_empty())).collect()
    }

    pub(super) fn free_name(&self, kind: Kind) -> String {
        let stem = match kind {
            Kind::Mover => "lift",
            Kind::Door => "gate",
            Kind::Stream => "fan",
            Kind::Link => "link",
            _ => "belt",
        };
        let known = self.names();
        let mut names = (1_u32..).map(|number| if number == 1 { stem.to_owned() } else { format!("{stem}{number}") });
        names.find(|name| !known.contains(&name.as_str())).unwrap_or_default()
    }
}
