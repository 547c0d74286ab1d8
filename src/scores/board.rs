//! The order of a leaderboard, without files.

use std::cmp::Reverse;

use super::error::ScoresError;
use super::name::Name;

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

/// Ranks count from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Placement {
    New {
        rank: usize,
    },
    /// A higher score in place of the user's best.
    Raised {
        rank: usize,
        /// The score before.
        from: i64,
    },
    /// The user's best is as high or higher and stays.
    Kept {
        rank: usize,
        best: i64,
    },
}

impl Placement {
    pub fn rank(self) -> usize {
        match self {
            Self::New { rank } | Self::Raised { rank, .. } | Self::Kept { rank, .. } => rank,
        }
    }
}

impl Board {
    /// The rows hold a name once each, the older one of equal scores first. `more_columns` names the columns behind `name` and
    /// `score`.
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

#[cfg(test)]
mod tests {
    use super::*;

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
        assert_eq!(board.place(&name("b"), 1).unwrap().rank(), 2);
    }

    #[test]
    fn further_cells_stay_with_their_user() {
        let mut board = board(&[("a", 20), ("b", 10)]);
        board.rows[1].more = vec!["7b".to_owned()];
        board.place(&name("b"), 30).unwrap();
        assert_eq!(board.rows()[0], BoardRow { name: name("b"), score: 30, more: vec!["7b".to_owned()] });
    }
}
