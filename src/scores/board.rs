//! A leaderboard, and its text: `name,score` and any columns behind, as people and spreadsheets write it: without header, in any order, with blank
//! lines, CRLF, a byte-order mark or spaces. Any other row becomes a line of damage and spoils no other.

use super::name::{DamageReport, Name, ScoresError};
use crate::files::{CsvColumn, CsvFile, CsvRow, CsvStruct, csv_line, whole};
use crate::words::tr;
use serde::Deserialize;
use std::{cmp::Reverse, collections::HashMap, collections::hash_map::Entry, path::Path};

/// Columns, in the order in which a save adds them: of the flight, its time (s) and its file.
const TIME: &str = "time";
const FLIGHT: &str = "flight";

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BoardRow {
    pub name: Name,
    /// At least 1.
    pub score: i64,
    /// The cells behind name and score, as the file has them: they belong to the user and stay when the score rises.
    pub more: Vec<String>,
}

/// A row a user, from the highest score to the lowest; of equal scores the older goes first.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Board {
    more_columns: Vec<String>,
    rows: Vec<BoardRow>,
}

/// Ranks count from 1. A higher score takes the place of the user's best, `from`; a best that is as high or higher stays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Placement {
    New { rank: usize },
    Raised { rank: usize, from: i64 },
    Kept { rank: usize, best: i64 },
}

impl Board {
    /// The rows hold a name once each, the older one of equal scores first. `more_columns` names the columns behind `name` and `score`.
    pub(super) fn new(more_columns: Vec<String>, mut rows: Vec<BoardRow>) -> Self {
        rows.sort_by_key(|row| Reverse(row.score)); // stable: equal scores keep their order
        Self { more_columns, rows }
    }

    pub fn rows(&self) -> &[BoardRow] {
        &self.rows
    }

    /// The columns behind `name` and `score`, as far as the file names them.
    pub fn more_columns(&self) -> &[String] {
        &self.more_columns
    }

    /// The time of the row's flight as the row says it, s.
    pub fn time(&self, row: usize) -> Option<f64> {
        let time = self.cell(row, TIME)?.replace(',', ".").parse().ok()?;
        Some(time).filter(|time: &f64| time.is_finite() && *time >= 0.0)
    }

    /// The file of the row's flight, in the level's folder of flights.
    pub fn flight(&self, row: usize) -> Option<&str> {
        self.cell(row, FLIGHT)
    }

    fn cell(&self, row: usize, column: &str) -> Option<&str> {
        Some(self.rows.get(row)?.more.get(self.column(column)?)?.trim()).filter(|cell| !cell.is_empty())
    }

    /// The index among the columns behind `name` and `score`.
    fn column(&self, name: &str) -> Option<usize> {
        self.more_columns.iter().position(|column| column.trim().eq_ignore_ascii_case(name))
    }

    /// Writes the time (s) and the file of a user's flight into columns of their own, behind all others; empty cells for a row without one.
    pub(super) fn set_flight(&mut self, name: &Name, flight: Option<(f64, String)>) {
        let Some(index) = self.rows.iter().position(|row| row.name == *name) else { return };
        let (time, file) = flight.map(|(time, file)| (format!("{time:.3}"), file)).unwrap_or_default();
        for (column, cell) in [(TIME, time), (FLIGHT, file)] {
            if cell.is_empty() && self.column(column).is_none() {
                continue;
            }
            let at = self.column(column).unwrap_or_else(|| {
                // Cells behind the last named column belong to the author of the file.
                let widest = self.rows.iter().map(|row| row.more.len()).max().unwrap_or(0);
                self.more_columns.resize(self.more_columns.len().max(widest), String::new());
                self.more_columns.push(column.to_owned());
                self.more_columns.len() - 1
            });
            let more = &mut self.rows[index].more;
            more.resize(more.len().max(at + 1), String::new());
            more[at] = cell;
        }
    }

    /// From 1.
    pub fn rank(&self, name: &Name) -> Option<usize> {
        self.rows.iter().position(|row| row.name == *name).map(|index| index + 1)
    }

    /// Adds a row, or raises the user's own where the score is higher. The row comes behind all rows with as many points.
    /// Errors: [`ScoresError::NoScore`] for a score below 1; the board stays as it is.
    pub fn place(&mut self, name: &Name, score: i64) -> Result<Placement, ScoresError> {
        if score < 1 {
            return Err(ScoresError::NoScore);
        }
        let old = self.rows.iter().position(|row| row.name == *name);
        if let Some(index) = old.filter(|&index| self.rows[index].score >= score) {
            return Ok(Placement::Kept { rank: index + 1, best: self.rows[index].score });
        }
        let old = old.map(|index| self.rows.remove(index));
        let from = old.as_ref().map(|row| row.score);
        let more = old.map(|row| row.more).unwrap_or_default();
        let index = self.rows.partition_point(|row| row.score >= score);
        self.rows.insert(index, BoardRow { name: name.clone(), score, more });
        let rank = index + 1;
        Ok(from.map_or(Placement::New { rank }, |from| Placement::Raised { rank, from }))
    }
}

const FILE: CsvFile<'_> = CsvFile { name: "", columns: &["name", "score"], comments: false };

#[derive(Deserialize)]
struct ScoreRow {
    name: Name,
    score: i64,
}

impl CsvStruct for ScoreRow {
    const COLUMNS: &'static [CsvColumn] = &[
        CsvColumn { name: "name", plain: |_, text| Name::cell(text) },
        CsvColumn {
            name: "score",
            plain: |dialect, text| {
                let number = dialect.number(text);
                let digits = whole(&number);
                let good = digits.bytes().all(|byte| byte.is_ascii_digit()) && digits.parse().is_ok_and(|score: i64| score >= 1);
                if good { Ok(digits.to_owned().into()) } else { Err(tr("a whole number of 1 or more, digits only").into()) }
            },
        },
    ];
}

/// The board, and a message for each unreadable place, which names `path`.
pub fn read(path: &Path, bytes: &[u8]) -> (Board, Vec<String>) {
    let mut reading =
        BoardReading { more_columns: Vec::new(), rows: Vec::new(), lines: HashMap::new(), damage: DamageReport::of(path) };
    for (index, row) in FILE.rows_of::<ScoreRow>(bytes).enumerate() {
        reading.take(&row, index == 0);
    }
    (Board::new(reading.more_columns, reading.rows), reading.damage.into_all())
}

/// With a header, sorted, LF.
pub fn write(board: &Board) -> String {
    let line = |first: [&str; 2], more: &[String]| csv_line(first.into_iter().chain(more.iter().map(String::as_str)));
    let rows = board.rows().iter().map(|row| line([row.name.as_str(), &row.score.to_string()], &row.more));
    line(["name", "score"], board.more_columns()) + &rows.collect::<String>()
}

struct BoardReading<'a> {
    more_columns: Vec<String>,
    rows: Vec<BoardRow>,
    /// By name, the index in `rows` and the line.
    lines: HashMap<Name, (usize, usize)>,
    damage: DamageReport<'a>,
}

impl BoardReading<'_> {
    /// The `first` row may be the header.
    fn take(&mut self, row: &CsvRow<'_>, first: bool) {
        let line = row.line;
        if let Some(fault) = row.fault() {
            return self.damage.fault(line, fault);
        }
        if row.cells.len() < FILE.columns.len() {
            return self.damage.add(
                line,
                None,
                tr("1 cell"),
                tr!("at least {least}: {header}", least = FILE.columns.len(), header = FILE.header()),
            );
        }
        let more: Vec<String> = row.cells.iter().skip(FILE.columns.len()).map(|cell| cell.text.clone()).collect();
        // Both names count: a user may be called "name".
        if first && row.is_header(FILE.columns.len()) {
            self.more_columns = more;
            return;
        }
        match row.read() {
            Ok(ScoreRow { name, score }) => self.row(line, BoardRow { name, score, more }),
            Err(wrong) => self.damage.cells(line, wrong),
        }
    }

    fn row(&mut self, line: usize, row: BoardRow) {
        match self.lines.entry(row.name.clone()) {
            Entry::Vacant(place) => {
                place.insert((self.rows.len(), line));
                self.rows.push(row);
            }
            Entry::Occupied(place) => {
                let (index, earlier) = *place.get();
                let found = tr!("{name} again, after line {earlier}", name = format_args!("\"{}\"", row.name), earlier);
                if row.score > self.rows[index].score {
                    self.rows[index] = row;
                }
                self.damage.add(line, Some("name"), found, tr("one row a user: the higher score counts"));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scores::name::MOST_DAMAGE;
    use crate::spreadsheets::saved;

    fn name(text: &str) -> Name {
        Name::new(text).unwrap()
    }

    fn board(rows: &[(&str, i64)]) -> Board {
        Board::new(vec![], rows.iter().map(|&(text, score)| BoardRow { name: name(text), score, more: vec![] }).collect::<Vec<_>>())
    }

    fn shown(board: &Board) -> Vec<(&str, i64)> {
        board.rows().iter().map(|row| (row.name.as_str(), row.score)).collect()
    }

    #[test]
    fn robert_and_jim_find_their_places() {
        let mut board = board(&[("NewPlayer", 13087), ("James", 12933), ("Robert", 12754)]);
        assert_eq!(board.place(&name("Robert"), 12954).unwrap(), Placement::Raised { rank: 2, from: 12754 });
        assert_eq!(board.place(&name("Jim"), 13052).unwrap(), Placement::New { rank: 2 });
        assert_eq!(shown(&board), [("NewPlayer", 13087), ("Jim", 13052), ("Robert", 12954), ("James", 12933)]);
        assert_eq!(board.rank(&name("Robert")), Some(3));
        assert_eq!(board.rank(&name("Nobody")), None);
    }

    #[test]
    fn a_score_that_is_not_higher_changes_nothing() {
        let mut board = board(&[("a", 20), ("b", 10)]);
        let before = board.clone();
        assert_eq!(board.place(&name("b"), 9).unwrap(), Placement::Kept { rank: 2, best: 10 });
        assert_eq!(board.place(&name("b"), 10).unwrap(), Placement::Kept { rank: 2, best: 10 });
        assert_eq!(board, before);
    }

    #[test]
    fn equal_scores_keep_the_older_first() {
        let mut board = board(&[("a", 20), ("b", 20), ("c", 10)]);
        assert_eq!(board.place(&name("d"), 20).unwrap(), Placement::New { rank: 3 });
        assert_eq!(board.place(&name("c"), 20).unwrap(), Placement::Raised { rank: 4, from: 10 }, "risen to what others had first");
        assert_eq!(shown(&board), [("a", 20), ("b", 20), ("d", 20), ("c", 20)]);
    }

    #[test]
    fn names_in_another_case_are_other_users() {
        let mut board = board(&[("bob", 20)]);
        assert_eq!(board.place(&name("Bob"), 10).unwrap(), Placement::New { rank: 2 });
    }

    #[test]
    fn nothing_below_one_point_is_placed() {
        let mut board = board(&[("a", 20)]);
        for score in [0, -1, i64::MIN] {
            assert!(matches!(board.place(&name("b"), score), Err(ScoresError::NoScore)));
        }
        assert_eq!(shown(&board), [("a", 20)]);
        assert_eq!(board.place(&name("b"), 1).unwrap(), Placement::New { rank: 2 });
    }

    #[test]
    fn further_cells_stay_with_their_user() {
        let mut board = board(&[("a", 20), ("b", 10)]);
        board.rows[1].more = vec!["7b".to_owned()];
        board.place(&name("b"), 30).unwrap();
        assert_eq!(board.rows()[0], BoardRow { name: name("b"), score: 30, more: vec!["7b".to_owned()] });
    }

    fn reading(bytes: impl AsRef<[u8]>) -> (Vec<String>, Vec<String>) {
        let (board, damage) = read(Path::new("1.csv"), bytes.as_ref());
        let rows = board.rows().iter().map(|row| {
            let more: String = row.more.iter().map(|cell| format!(",{cell}")).collect();
            format!("{},{}{more}", row.name, row.score)
        });
        (rows.collect(), damage)
    }

    fn sound(bytes: impl AsRef<[u8]>) -> Vec<String> {
        let (rows, damage) = reading(bytes);
        assert_eq!(damage, [""; 0]);
        rows
    }

    #[test]
    fn a_header_is_read_and_may_be_missing() {
        assert_eq!(sound("name,score\nann,30\nbob,20\n"), ["ann,30", "bob,20"]);
        assert_eq!(sound("Name, Score\nann,30\n"), ["ann,30"]);
        assert_eq!(sound("ann,30\nbob,20\n"), ["ann,30", "bob,20"]);
        assert_eq!(sound("name,30\nbob,20\n"), ["name,30", "bob,20"], "a user may be called name");
        assert_eq!(sound(""), [""; 0]);
        assert_eq!(sound("name,score\n"), [""; 0]);
    }

    #[test]
    fn what_editors_do_to_a_file_is_no_damage() {
        assert_eq!(sound("\u{feff}name,score\r\nann,30\r\n\r\nbob,20"), ["ann,30", "bob,20"]);
        assert_eq!(sound("\n  \n ann , 30 \n\"bob\",\"20\"\n\n"), ["ann,30", "bob,20"]);
        assert_eq!(sound("ann,30\rbob,20\r"), ["ann,30", "bob,20"]);
        assert_eq!(sound("bob,20\nann,30\ncid,20\n"), ["ann,30", "bob,20", "cid,20"], "sorted, equal ones as they stand");
    }

    #[test]
    fn further_columns_come_back_byte_for_byte() {
        let text = "name,score,class,note\nann,30,7b,\"said \"\"hi\"\",\nthen left\"\nbob,20\ncid,10, 7a ,,5\" tall\n";
        let (board, damage) = read(Path::new("1.csv"), text.as_bytes());
        assert!(damage.is_empty());
        assert_eq!(board.more_columns(), ["class", "note"]);
        assert_eq!(board.rows()[0].more, ["7b", "said \"hi\",\nthen left"]);
        assert_eq!(board.rows()[2].more, [" 7a ", "", "5\" tall"]);
        let written = write(&board);
        assert_eq!(read(Path::new("1.csv"), written.as_bytes()).0, board);
        assert_eq!(
            written,
            "name,score,class,note\nann,30,7b,\"said \"\"hi\"\",\nthen left\"\nbob,20\ncid,10, 7a ,,\"5\"\" tall\"\n"
        );
    }

    #[test]
    fn a_damaged_row_is_reported_with_its_place_and_spoils_no_other() {
        for (line, report) in [
            ("bob", "1.csv:3: 1 cell, expected at least 2: name,score"),
            ("bob,", "1.csv:3: column \"score\": \"\", expected a whole number of 1 or more, digits only"),
            ("bob,0", "1.csv:3: column \"score\": \"0\", expected a whole number of 1 or more, digits only"),
            ("bob,-5", "1.csv:3: column \"score\": \"-5\", expected a whole number of 1 or more, digits only"),
            ("bob,+5", "1.csv:3: column \"score\": \"+5\", expected a whole number of 1 or more, digits only"),
            ("bob,12.5", "1.csv:3: column \"score\": \"12.5\", expected a whole number of 1 or more, digits only"),
            ("bob,nan", "1.csv:3: column \"score\": \"nan\", expected a whole number of 1 or more, digits only"),
            (
                "bob,9223372036854775808",
                "1.csv:3: column \"score\": \"9223372036854775808\", expected a whole number of 1 or more, digits only",
            ),
            (
                "1bob,5",
                "1.csv:3: column \"name\": \"1bob\", expected a user name: The name must start with a letter (a–z, A–Z), not with “1”.",
            ),
            (",5", "1.csv:3: column \"name\": \"\", expected a user name: The name is empty: type 1 to 15 characters."),
            ("ann,5", "1.csv:3: column \"name\": \"ann\" again, after line 2, expected one row a user: the higher score counts"),
            ("\"bob,5", "1.csv:3: a quote that is never closed, expected a closing quote"),
            ("bob,5,\"x", "1.csv:3: a quote that is never closed, expected a closing quote"),
        ] {
            let (rows, damage) = reading(format!("name,score\nann,30\n{line}\ncid,20\n"));
            assert_eq!(damage, [report], "{line}");
            assert_eq!(rows, ["ann,30", "cid,20"], "{line}");
        }
    }

    #[test]
    fn cells_that_a_spreadsheet_would_run_are_no_names() {
        for cell in ["=1+1", "+bob", "-bob", "@bob"] {
            let (rows, damage) = reading(format!("{cell},10\nann,5\n"));
            assert_eq!((rows.len(), damage.len()), (1, 1), "{cell}");
        }
    }

    #[test]
    fn both_cells_of_a_row_can_be_damaged() {
        let (rows, damage) = reading("# hello, world\n");
        assert_eq!((rows.len(), damage.len()), (0, 2));
    }

    #[test]
    fn the_better_one_of_two_rows_with_one_name_counts() {
        let (rows, damage) = reading("ann,10\nbob,20\nann,30\n");
        assert_eq!(rows, ["ann,30", "bob,20"]);
        assert_eq!(damage.len(), 1);
    }

    #[test]
    fn bytes_that_are_no_text_spoil_their_own_line_only() {
        let (rows, damage) = reading(b"ann,30\nb\xFFb,20\ncid,10\n\0\0\0\0");
        assert_eq!(rows, ["ann,30", "cid,10"]);
        assert_eq!(
            damage,
            [
                "1.csv:2: letters that are not UTF-8, expected a file saved as UTF-8 (Excel: Save As, CSV UTF-8; LibreOffice: Save As, Text CSV, character set UTF-8)",
                "1.csv:4: 1 cell, expected at least 2: name,score"
            ]
        );
    }

    #[test]
    fn a_record_behind_an_unclosed_quotation_mark_may_not_span_lines_either() {
        // Each of these lines ends within quotes, wherever it begins.
        let (rows, damage) = reading("\"\"x\",\"\n\"\"x\",\"\nann,30\nbob,20\n");
        assert_eq!(rows, ["ann,30", "bob,20"]);
        assert_eq!(damage.len(), 2, "{damage:?}");
        assert!(damage.iter().all(|damage| damage.contains("never closed")), "{damage:?}");
    }

    #[test]
    fn no_more_damage_is_told_than_anyone_reads() {
        let (rows, damage) = reading("ann\n".repeat(2 * MOST_DAMAGE) + "bob,20\n");
        assert_eq!((rows, damage.len()), (vec!["bob,20".to_owned()], MOST_DAMAGE + 1));
        assert_eq!(
            damage[MOST_DAMAGE],
            "1.csv:1001: one more place that cannot be read, expected at most 1000 in a file; from here on they are not listed"
        );
    }

    #[test]
    fn lines_are_counted_as_an_editor_counts_them() {
        let (_, damage) = reading("\u{feff}name,score\r\n\r\nann,30,\"two\r\nlines\"\r\n\r\nbad\r\n");
        assert_eq!(damage, ["1.csv:6: 1 cell, expected at least 2: name,score"]);
    }

    #[test]
    fn a_board_is_the_same_whatever_spreadsheet_saved_it() {
        let plain = "name,score,class\nann,13087,\"7b, left\"\nbob,20,\"8; a\"\n";
        let (board, _) = read(Path::new("1.csv"), plain.as_bytes());
        for text in [plain, plain.split_once('\n').unwrap().1] {
            for saved in saved(text, |_| false) {
                let (found, damage) = read(Path::new("1.csv"), &saved.bytes);
                assert_eq!((found.rows().len(), damage), (2, Vec::new()), "{}", saved.form);
                let filled = |rows: &[BoardRow]| {
                    rows.iter().map(|row| (row.name.clone(), row.score, row.more[0].trim().to_owned())).collect::<Vec<_>>()
                };
                assert_eq!(filled(found.rows()), filled(board.rows()), "{}", saved.form);
            }
        }
        assert_eq!(sound("name;score\r\nann;13087,0\r\nbob;20.0\r\n"), ["ann,13087", "bob,20"]);
    }
}
