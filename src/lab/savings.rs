//! What modelling less saves: a scene a row, with the time of a tick as it runs and with every part of the model, as CSV.

use super::rows::{above_zero, rows};

pub const SAVINGS: &str = "savings.csv";
const HEAD: [&str; 6] = ["scene", "parts", "left_out", "ns", "ns_everything", "same_bits"];

#[derive(Clone, Debug, PartialEq)]
pub struct Saving {
    pub scene: String,
    /// The parts of the model that run, and those left out.
    pub parts: String,
    pub left_out: String,
    /// A tick, ns, as the scene runs and with everything.
    pub work: f64,
    pub everything: f64,
    /// Whether both gave the same bits.
    pub same_bits: bool,
}

impl Saving {
    /// The largest saving first.
    ///
    /// # Errors
    /// The first row that cannot be read, with its line.
    pub(super) fn read(text: &str) -> Result<Vec<Self>, String> {
        let read = |row: &crate::files::CsvRow<'_>| {
            let word = |column| row.get(column).to_owned();
            Ok(Self {
                scene: word("scene"),
                parts: word("parts"),
                left_out: word("left_out"),
                work: above_zero(row, "ns")?,
                everything: above_zero(row, "ns_everything")?,
                same_bits: row.parse("same_bits", "true or false", |_| true)?,
            })
        };
        let mut found = rows(SAVINGS, text, &HEAD)?.iter().map(read).collect::<Result<Vec<_>, String>>()?;
        found.sort_by(|a, b| b.factor().total_cmp(&a.factor()));
        Ok(found)
    }

    pub fn factor(&self) -> f64 {
        self.everything / self.work
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn savings_are_read_largest_first_and_damage_is_named() {
        let text =
            "scene,parts,left_out,ns,ns_everything,same_bits\n1,flight,\"air, liquids\",100,150,true\n2,flight,air,50,200,true\n";
        let found = Saving::read(text).unwrap();
        assert_eq!(found.iter().map(|row| (row.scene.as_str(), row.factor())).collect::<Vec<_>>(), [("2", 4.0), ("1", 1.5)]);
        let problem = Saving::read(&text.replace("50,200", "0,200")).unwrap_err();
        assert!(problem.starts_with("savings.csv:3: column \"ns\""), "{problem}");
    }
}
