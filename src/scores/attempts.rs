//! The list of attempts: a line for each finished one, for spreadsheets and people. The game only adds to it. RFC 4180, CRLF,
//! UTF-8.

use serde::{Serialize, Serializer};

use super::name::Name;
use super::players::harmless;

pub(super) const HEADER: &str = "level,player,result,time,fuel,hits,cause,assisted\r\n";

#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct AttemptRow {
    #[serde(serialize_with = "as_text")]
    pub level: String,
    pub player: Name,
    /// `completed` or `failed`.
    pub result: &'static str,
    /// s.
    #[serde(serialize_with = "as_thousandths")]
    pub time: f64,
    /// The fraction of the fuel left, 0 … 1.
    #[serde(serialize_with = "as_thousandths")]
    pub fuel: f64,
    /// Damaging ones.
    pub hits: u32,
    /// As `resultant run` names it; empty without a loss.
    #[serde(serialize_with = "as_text")]
    pub cause: String,
    pub assisted: bool,
}

/// A row with its line end.
pub(super) fn line(row: &impl Serialize) -> String {
    let mut writer = csv::WriterBuilder::new().terminator(csv::Terminator::CRLF).has_headers(false).from_writer(Vec::new());
    // Memory takes all writes, and the cells are text.
    drop(writer.serialize(row));
    writer.into_inner().ok().and_then(|bytes| String::from_utf8(bytes).ok()).unwrap_or_default()
}

/// Text that no spreadsheet reads as a formula.
pub(super) fn as_text<S: Serializer>(text: &str, to: S) -> Result<S::Ok, S::Error> {
    to.serialize_str(&harmless(text))
}

/// Three decimals, which differ between any two ticks.
fn as_thousandths<S: Serializer>(value: &f64, to: S) -> Result<S::Ok, S::Error> {
    to.collect_str(&format_args!("{value:.3}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_opens_in_a_spreadsheet() {
        let mut row = AttemptRow {
            level: "Höhle, \"tief\"".to_owned(),
            player: Name::new("ann").unwrap(),
            result: "completed",
            time: 5.483_333,
            fuel: 0.85,
            hits: 2,
            cause: String::new(),
            assisted: false,
        };
        assert_eq!(line(&row), "\"Höhle, \"\"tief\"\"\",ann,completed,5.483,0.850,2,,false\r\n");
        for level in ["=cmd|' /C calc'!A0", "+1", "-1", "@SUM(A1)", "\t=1"] {
            row.level = level.to_owned();
            assert!(line(&row).trim_start_matches('"').starts_with('\''), "{}", line(&row));
        }
    }

    #[test]
    fn the_header_names_the_columns_of_a_line() {
        let row = AttemptRow {
            level: "1".to_owned(),
            player: Name::guest(),
            result: "failed",
            time: 1.0,
            fuel: 1.0,
            hits: 0,
            cause: "obstacle 2".to_owned(),
            assisted: true,
        };
        let mut writer = csv::WriterBuilder::new().terminator(csv::Terminator::CRLF).from_writer(Vec::new());
        writer.serialize(&row).unwrap();
        let text = String::from_utf8(writer.into_inner().unwrap()).unwrap();
        assert_eq!(text, format!("{HEADER}1,Guest,failed,1.000,1.000,0,obstacle 2,true\r\n"));
    }
}
