//! Which switch works which thing, and the names by which it does.

use super::{Document, Kind, RowId, SetCell, Table};

/// The tables whose rows have a name that a switch can work.
const WORKED: [Table; 4] = [Table::World, Table::Movers, Table::Doors, Table::Hazards];

/// A wire from a switch to a thing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Wiring {
    /// The switch.
    pub switch: RowId,
    /// What it works.
    pub thing: RowId,
    /// Whether the thing is on while the switch is off.
    pub inverted: bool,
}

impl Document {
    /// All wires.
    pub fn wires(&self) -> Vec<Wiring> {
        let named: Vec<(RowId, &str)> = WORKED
            .into_iter()
            .flat_map(|table| self.rows(table))
            .filter_map(|row| Some((row, self.cell(row, "name").filter(|name| !name.is_empty())?)))
            .collect();
        let mut wires = Vec::new();
        for switch in self.rows(Table::Switches) {
            for word in self.cell(switch, "works").unwrap_or_default().split_whitespace() {
                let (name, inverted) = (word.trim_start_matches('!'), word.starts_with('!'));
                let things = named.iter().filter(|(_, known)| *known == name);
                wires.extend(things.map(|(thing, _)| Wiring { switch, thing: *thing, inverted }));
            }
        }
        wires
    }

    /// Whether a switch can work the thing.
    pub fn can_be_worked(&self, row: RowId) -> bool {
        WORKED.contains(&row.table)
    }

    /// What the cells hold when that switch works that thing, or no longer does where it did. A thing without a name gets one.
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
        if words.iter().any(|word| word.trim_start_matches('!') == name) {
            words.retain(|word| word.trim_start_matches('!') != name);
        } else {
            // A name that nothing has yet stood there for want of one.
            words.retain(|word| known.iter().any(|known| *known == word.trim_start_matches('!')));
            words.push(&name);
        }
        cells.push(SetCell { row: switch, column: "works", text: words.join(" ") });
        cells
    }

    fn names(&self) -> Vec<&str> {
        let rows = WORKED.into_iter().flat_map(|table| self.rows(table));
        rows.filter_map(|row| self.cell(row, "name").filter(|name| !name.is_empty())).collect()
    }

    /// A name that nothing of the level has.
    pub(super) fn free_name(&self, kind: Kind) -> String {
        let stem = match kind {
            Kind::Mover => "lift",
            Kind::Door => "gate",
            Kind::Stream => "fan",
            _ => "belt",
        };
        let known = self.names();
        let first = (1_u32..).map(|number| if number == 1 { stem.to_owned() } else { format!("{stem}{number}") });
        let mut free = first.filter(|name| !known.contains(&name.as_str()));
        free.next().unwrap_or_default()
    }

    /// What a new switch works: the only thing with a name, else a name to be replaced.
    pub(super) fn first_worked(&self) -> String {
        self.names().first().map_or("gate", |name| name).to_owned()
    }
}
