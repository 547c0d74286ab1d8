//! The wires from switches to things, by the names of the things.

use super::model::{Document, RowId, SetCell};
use crate::level::schema::{Column, Kind, Table};
use crate::level::wiring::names_in;
use std::collections::BTreeMap;

/// The tables whose rows have a name that a switch can work.
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
        let named: Vec<(RowId, &str)> = worked()
            .flat_map(|table| self.rows(table))
            .filter_map(|row| Some((row, self.cell(row, "name").filter(|name| !name.is_empty())?)))
            .collect();
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

    /// The switches' cells when things get other names. A name that is typed letter by letter may pass the name of another thing: so the wires
    /// are looked up as they were before the gesture.
    pub(super) fn renamed(&self, cells: &[SetCell], gesture: Option<u64>) -> Vec<SetCell> {
        let is_name = |cell: &&SetCell| cell.column == "name" && self.can_be_worked(cell.row);
        let named: BTreeMap<RowId, &str> = cells.iter().filter(is_name).map(|cell| (cell.row, cell.text.trim())).collect();
        if named.is_empty() {
            return Vec::new();
        }
        // Each old name with the new ones.
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
            let Some(works) = before.cell(index, "works").filter(|_| row.cells.iter().all(|cell| cell.fault.is_none())) else {
                continue;
            };
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

    fn names(&self) -> Vec<&str> {
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
        let first = (1_u32..).map(|number| if number == 1 { stem.to_owned() } else { format!("{stem}{number}") });
        let mut free = first.filter(|name| !known.contains(&name.as_str()));
        free.next().unwrap_or_default()
    }

    /// The name of the first thing that has one, else a name to be replaced.
    pub(super) fn first_worked(&self) -> String {
        self.names().first().map_or("gate", |name| name).to_owned()
    }
}
