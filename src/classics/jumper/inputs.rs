//! Recorded keys of a climb: held keys and their number of ticks, as a CSV file that people can write.
//!
//! ```text
//! ticks,left1,right1,jump1,left2,right2,jump2
//! 60,0,1,0,1,0,0
//! 30,0,1,1,0,0,0
//! ```
//!
//! Each row holds its keys (0 or 1) for that many ticks; the last three columns are the second player's and may be left out. Blank
//! lines and lines that start with `#` are skipped.

use super::scene::JumpKeys;
use crate::files::{CsvFile, CsvRow};
use crate::game::TICK_RATE;

/// The columns of the file, which are its first row.
const HEADER: [&str; 7] = ["ticks", "left1", "right1", "jump1", "left2", "right2", "jump2"];
/// The columns of one player, and of both.
const ONE_PLAYER: usize = 4;
const BOTH_PLAYERS: usize = HEADER.len();
/// The most ticks that a file can hold: a day. More is a slip of the pen, and would be climbed for minutes without a word.
const MOST_TICKS: u64 = 24 * 3600 * TICK_RATE as u64;

/// The keys of both players for a number of ticks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Climb {
    pub ticks: u64,
    pub keys: [JumpKeys; 2],
}

/// Reads the text of a file of keys; `file` is its name in messages.
///
/// # Errors
/// The first problem as `FILE:LINE: MESSAGE`: another header, a wrong number of cells, ticks that are no whole number from 1 or more than
/// a day's in all, a key that is neither 0 nor 1.
pub fn parse(file: &str, text: &str) -> Result<Vec<Climb>, String> {
    let columns = CsvFile { name: file, columns: &HEADER, comments: true };
    let mut rows = columns.rows(text.as_bytes());
    let header = rows.next().ok_or_else(|| format!("{file}:1: found \"\", expected the header {}", columns.header()))?;
    if !header.is_header(ONE_PLAYER) || !matches!(header.used(), ONE_PLAYER | BOTH_PLAYERS) {
        return Err(header.row_problem(format_args!("{:?}", header.joined()), format_args!("the header {}", columns.header())));
    }
    let mut total = 0;
    let climbs = rows.map(|row| {
        let climb = climb(&row, header.used())?;
        total += climb.ticks;
        if total > MOST_TICKS {
            return Err(row.row_problem(format_args!("{total} ticks up to here"), format_args!("at most {MOST_TICKS} in all")));
        }
        Ok(climb)
    });
    climbs.collect()
}

fn climb(row: &CsvRow<'_>, columns: usize) -> Result<Climb, String> {
    if row.used() != columns {
        return Err(row.row_problem(format_args!("{} cells", row.used()), columns));
    }
    let expected = format!("a whole number from 1 to {MOST_TICKS}");
    let ticks = row.parse("ticks", &expected, |ticks| (1..=MOST_TICKS).contains(ticks))?;
    let key = |index: usize| if index < columns { row.bit(HEADER[index]) } else { Ok(false) };
    let player = |from: usize| Ok::<_, String>(JumpKeys { left: key(from)?, right: key(from + 1)?, jump: key(from + 2)? });
    Ok(Climb { ticks, keys: [player(1)?, player(4)?] })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_of_one_or_both_players_are_read() {
        let none = JumpKeys::default();
        let one = Climb { ticks: 5, keys: [JumpKeys { right: true, ..none }, none] };
        assert_eq!(parse("keys.csv", "\u{feff}ticks,left1,right1,jump1\r\n\r\n 5, 0,1,0\r\n"), Ok(vec![one]));
        let both = Climb { ticks: 1, keys: [JumpKeys { left: true, ..none }, JumpKeys { jump: true, ..none }] };
        assert_eq!(parse("keys.csv", "ticks,left1,right1,jump1,left2,right2,jump2\n1,1,0,0,0,0,1"), Ok(vec![both]));
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
            assert_eq!(parse("keys.csv", &text), Err(format!("keys.csv:{problem}")), "{rows:?}");
        }
    }
}
