//! Answers to experiments: a file a player, a row a reading, the prediction in the first row that is handed in with it, for teachers and
//! their spreadsheets. The game only adds rows. RFC 4180, CRLF, UTF-8 behind a byte-order mark, without which Excel takes it for another encoding.

use std::path::PathBuf;

use serde::{Serialize, Serializer};

use super::folder::{self, as_text};
use super::name::{Name, ScoresError};
use super::players::harmless;
use crate::{level, number};

pub(super) const HEADER: &str =
    "\u{feff}player,experiment,time,prediction,predicted,prediction_right,quantity,reading,unit,tick,reading_right,answer\r\n";

#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct ResultRow {
    pub player: Name,
    #[serde(serialize_with = "as_text")]
    pub experiment: String,
    /// `2026-11-24 15:58:21`, UTC.
    pub time: String,
    /// Empty where it is in a row before.
    #[serde(serialize_with = "as_number_or_text")]
    pub prediction: String,
    /// When it was made, as `time`.
    pub predicted: String,
    /// `None` where nothing says what is right.
    #[serde(serialize_with = "as_verdict")]
    pub prediction_right: Option<bool>,
    /// What was read, as the experiment's list names it; the unit that its cell asks for.
    #[serde(serialize_with = "as_text")]
    pub quantity: String,
    #[serde(serialize_with = "as_number_or_text")]
    pub reading: String,
    pub unit: String,
    /// The moment of the flight that was shown then.
    pub tick: Option<u64>,
    #[serde(serialize_with = "as_verdict")]
    pub reading_right: Option<bool>,
    /// The exact one, of the experiment.
    #[serde(serialize_with = "as_text")]
    pub answer: String,
}

/// `seconds` since 1970-01-01, 0 UTC, to the second: `2026-11-24 15:58:21`.
pub fn time_of(seconds: f64) -> String {
    let seconds = seconds.max(0.0) as u64;
    let (year, month, day) = civil(seconds / 86_400);
    let of_day = seconds % 86_400;
    format!("{year:04}-{month:02}-{day:02} {:02}:{:02}:{:02}", of_day / 3600, of_day / 60 % 60, of_day % 60)
}

/// Year, month and day of the Gregorian calendar, after Howard Hinnant, "chrono-Compatible Low-Level Date Algorithms".
const fn civil(since_1970: u64) -> (u64, u64, u64) {
    // Years begin in March: the leap day is their last one.
    let days = since_1970 + 719_468;
    let (era, day) = (days / 146_097, days % 146_097);
    let year = (day - day / 1460 + day / 36_524 - day / 146_096) / 365;
    let of_year = day - (365 * year + year / 4 - year / 100);
    let month = (5 * of_year + 2) / 153;
    let of_month = of_year - (153 * month + 2) / 5 + 1;
    let january = (month + 2) % 12 + 1;
    (year + era * 400 + (january <= 2) as u64, january, of_month)
}

/// The folder of these files.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Results {
    folder: PathBuf,
}

impl Results {
    /// The folder need not exist yet.
    pub fn new(folder: impl Into<PathBuf>) -> Self {
        Self { folder: folder.into() }
    }

    /// The file of a player. Windows takes some names for devices.
    pub fn file(&self, player: &Name) -> PathBuf {
        let more = if level::is_device(player.as_str()) { "_" } else { "" };
        self.folder.join(format!("{player}{more}.csv"))
    }

    /// Adds the rows of a player.
    /// Errors: a file that is no list of answers; see [`crate::files::SaveError`].
    pub fn append(&self, rows: &[ResultRow]) -> Result<(), ScoresError> {
        let Some(first) = rows.first() else { return Ok(()) };
        let lines: String = rows.iter().map(folder::line).collect();
        folder::append(&self.file(&first.player), HEADER, &lines)
    }
}

/// A number as it is, also with a sign in front and a decimal comma; other text so that no spreadsheet reads it as a formula.
fn as_number_or_text<S: Serializer>(text: &str, to: S) -> Result<S::Ok, S::Error> {
    to.serialize_str(&if number::is_plain(text) { text.into() } else { harmless(text) })
}

fn as_verdict<S: Serializer>(right: &Option<bool>, to: S) -> Result<S::Ok, S::Error> {
    to.serialize_str(right.map_or("", |right| if right { "yes" } else { "no" }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_stay_numbers_and_no_prediction_is_a_formula() {
        let mut row = ResultRow {
            player: Name::new("ann").unwrap(),
            experiment: "hooke".to_owned(),
            time: "2026-11-24 15:58:21".to_owned(),
            prediction: "-5,25".to_owned(),
            predicted: "2026-11-24 15:50:00".to_owned(),
            prediction_right: Some(false),
            quantity: "soft spring, force".to_owned(),
            reading: "48 N, \"soft\"; 50 N".to_owned(),
            unit: "N/m".to_owned(),
            tick: Some(240),
            reading_right: Some(true),
            answer: "F = k·s".to_owned(),
        };
        let start = "ann,hooke,2026-11-24 15:58:21";
        let expected = format!(
            "{start},\"-5,25\",2026-11-24 15:50:00,no,\"soft spring, force\",\"48 N, \"\"soft\"\"; 50 N\",N/m,240,yes,F = k·s\r\n"
        );
        assert_eq!(folder::line(&row), expected);
        (row.prediction_right, row.reading_right, row.tick) = (None, None, None);
        for (text, cell) in [
            ("=1+1", "'=1+1"),
            ("+5", "+5"),
            ("+5 N", "'+5 N"),
            ("-5", "-5"),
            ("-5-5", "'-5-5"),
            ("-", "'-"),
            ("@SUM(A1)", "'@SUM(A1)"),
            ("-inf", "'-inf"),
            ("", ""),
        ] {
            (row.prediction, row.reading) = (text.to_owned(), text.to_owned());
            let expected = format!("{start},{cell},2026-11-24 15:50:00,,\"soft spring, force\",{cell},N/m,,,F = k·s\r\n");
            assert_eq!(folder::line(&row), expected);
        }
    }

    #[test]
    fn days_are_those_of_the_calendar() {
        for (days, date) in
            [(0, "1970-01-01"), (59, "1970-03-01"), (11_016, "2000-02-29"), (11_017, "2000-03-01"), (20_781, "2026-11-24")]
        {
            assert_eq!(time_of(86_400.0 * f64::from(days) + 86_399.9), format!("{date} 23:59:59"));
        }
    }

    #[test]
    fn the_file_of_a_device_has_another_name() {
        let file = |name| Results::new("results").file(&Name::new(name).unwrap());
        assert_eq!((file("ann"), file("Con")), ("results/ann.csv".into(), "results/Con_.csv".into()));
    }
}
