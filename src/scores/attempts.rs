//! The list of attempts: a line for each finished one, for spreadsheets and people. The game only adds to it, and reads none of its rows. RFC 4180, CRLF,
//! UTF-8.

use serde::{Serialize, Serializer};

use super::error::ScoresError;
use super::name::Name;
use super::players::harmless;
use crate::files;
use std::path::Path;

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

/// The most bytes of a list. A page has some 5 MB in all, and the oldest lines go there.
const MOST: usize = if cfg!(browser) { 128 << 10 } else { files::INPUTS as usize };

/// Adds lines to a list that begins with that header, or makes one. A last line without an end gets one.
pub(super) fn append(path: &Path, header: &str, lines: &str) -> Result<(), ScoresError> {
    if lines.is_empty() {
        return Ok(());
    }
    files::update(path, MOST as u64, |old| {
        let plain = |text: &'_ [u8]| text.strip_prefix("\u{feff}".as_bytes()).unwrap_or(text).to_vec();
        if !old.is_empty() && !plain(old).starts_with(plain(header.as_bytes()).trim_ascii_end()) {
            return Err(ScoresError::Foreign(path.to_owned()));
        }
        let before = if old.is_empty() { header.as_bytes() } else { old };
        let end: &[u8] = if before.ends_with(b"\n") { b"" } else { b"\r\n" };
        let new = [before, end, lines.as_bytes()].concat();
        Ok((if cfg!(browser) { newest(new) } else { new }, ()))
    })
}

/// The header and the newest lines, as many as there is room for.
fn newest(mut list: Vec<u8>) -> Vec<u8> {
    if list.len() > MOST {
        let first = list.iter().position(|byte| *byte == b'\n').map_or(0, |end| end + 1);
        let surplus = list.len() - MOST + first;
        let whole = list[surplus..].iter().position(|byte| *byte == b'\n').map_or(list.len(), |end| surplus + end + 1);
        list.drain(first..whole);
    }
    list
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
