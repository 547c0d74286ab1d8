//! Recorded keys of a climb: what was held for how many ticks, as a CSV file that people can write.
//!
//! ```text
//! ticks,left1,right1,jump1,left2,right2,jump2
//! 60,0,1,0,1,0,0
//! 30,0,1,1,0,0,0
//! ```
//!
//! Each row holds its keys (0 or 1) for that many ticks; the last three columns are the second player's and may be left out. Blank
//! lines are skipped.

use super::scene::Keys;
use crate::game::{TICK_RATE, records};
use csv::StringRecord;
use serde::Deserialize;

/// The columns of the file, which are its first row.
const HEADER: [&str; 7] = ["ticks", "left1", "right1", "jump1", "left2", "right2", "jump2"];
/// The most ticks that a file can hold: a day. More is a slip of the pen, and would be climbed for minutes without a word.
const MOST_TICKS: u64 = 24 * 3600 * TICK_RATE as u64;

/// What both players hold for a number of ticks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row {
    /// How long.
    pub ticks: u64,
    /// What.
    pub keys: [Keys; 2],
}

/// A row as it stands in the file; nothing of it is judged yet.
#[derive(Deserialize)]
struct Cells<'a> {
    ticks: &'a str,
    /// Three of each player.
    keys: Vec<&'a str>,
}

/// Reads the text of a file of keys.
///
/// # Errors
/// The first problem as `LINE: MESSAGE`, to be put behind `FILE:`: another header, a wrong number of cells, ticks that are no whole
/// number from 1 or more than a day's in all, a key that is neither 0 nor 1.
pub fn parse(text: &str) -> Result<Vec<Row>, String> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    // The lines keep the numbers that an editor gives them; those of the csv crate are off behind blank lines.
    let (numbers, rows): (Vec<usize>, Vec<&str>) = (1..).zip(text.lines()).filter(|(_, line)| !line.trim().is_empty()).unzip();
    let mut lines = numbers.into_iter().zip(records(&rows.join("\n")));
    let expected = HEADER.join(",");
    let (number, header) = lines.next().unwrap_or((1, StringRecord::new()));
    if header != HEADER[..] && header != HEADER[..4] {
        let found = header.iter().collect::<Vec<_>>().join(",");
        return Err(format!("{number}: found {found:?}, expected the header {expected}"));
    }
    let mut total = 0;
    let read = lines.map(|(number, cells)| {
        let row = row(&cells, header.len()).map_err(|problem| format!("{number}: {problem}"))?;
        total += row.ticks;
        if total > MOST_TICKS {
            return Err(format!("{number}: found {total} ticks up to here, expected at most {MOST_TICKS} in all"));
        }
        Ok(row)
    });
    read.collect()
}

fn row(record: &StringRecord, columns: usize) -> Result<Row, String> {
    let Some(Cells { ticks, keys }) = record.deserialize(None).ok().filter(|_| record.len() == columns) else {
        return Err(format!("found {} cells, expected {columns}", record.len()));
    };
    let number = ticks.parse().ok().filter(|ticks| (1..=MOST_TICKS).contains(ticks));
    let number =
        number.ok_or_else(|| format!("column \"ticks\": found {ticks:?}, expected a whole number from 1 to {MOST_TICKS}"))?;
    let key = |index: usize| match keys.get(index) {
        None | Some(&"0") => Ok(false),
        Some(&"1") => Ok(true),
        Some(other) => Err(format!("column {:?}: found {other:?}, expected 0 or 1", HEADER[index + 1])),
    };
    let player = |from: usize| Ok::<_, String>(Keys { left: key(from)?, right: key(from + 1)?, jump: key(from + 2)? });
    Ok(Row { ticks: number, keys: [player(0)?, player(3)?] })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_of_one_or_both_players_are_read() {
        let none = Keys::default();
        let one = Row { ticks: 5, keys: [Keys { right: true, ..none }, none] };
        assert_eq!(parse("\u{feff}ticks,left1,right1,jump1\r\n\r\n 5, 0,1,0\r\n"), Ok(vec![one]));
        let both = Row { ticks: 1, keys: [Keys { left: true, ..none }, Keys { jump: true, ..none }] };
        assert_eq!(parse("ticks,left1,right1,jump1,left2,right2,jump2\n1,1,0,0,0,0,1"), Ok(vec![both]));
    }

    #[test]
    fn bad_files_are_refused_with_their_line() {
        const GOOD: &str = "ticks,left1,right1,jump1";
        for (rows, problem) in [
            ("", "1: found \"\", expected the header ticks,left1,right1,jump1,left2,right2,jump2"),
            ("5,0,1,0", "1: found \"5,0,1,0\", expected the header ticks,left1,right1,jump1,left2,right2,jump2"),
            ("+0,0,0,0", "2: column \"ticks\": found \"0\", expected a whole number from 1 to 10368000"),
            ("+5,0,0", "2: found 3 cells, expected 4"),
            ("+10368000,0,0,0\n1,0,0,0", "3: found 10368001 ticks up to here, expected at most 10368000 in all"),
            ("+\n5,0,0,2", "3: column \"jump1\": found \"2\", expected 0 or 1"),
        ] {
            let text = rows.strip_prefix('+').map_or(rows.to_owned(), |rows| format!("{GOOD}\n{rows}"));
            assert_eq!(parse(&text), Err(problem.to_owned()), "{rows:?}");
        }
    }
}
