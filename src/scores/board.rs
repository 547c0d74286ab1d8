//! The order of a leaderboard, without files.

use std::cmp::Reverse;
use std::collections::BTreeMap;

use super::error::ScoresError;
use super::name::Name;
use super::origin::RowOrigin;
use crate::game::LevelHash;

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

    pub fn origin(&self, row: usize) -> RowOrigin {
        let cell = |column: &str| Some(self.rows.get(row)?.more.get(self.column(column)?)?.trim()).filter(|cell| !cell.is_empty());
        RowOrigin::of(cell)
    }

    /// The index among the columns behind `name` and `score`.
    fn column(&self, name: &str) -> Option<usize> {
        self.more_columns.iter().position(|column| column.trim().eq_ignore_ascii_case(name))
    }

    /// Writes the origin of a user's row into columns of its own, behind all others.
    pub(super) fn set_origin(&mut self, name: &Name, origin: &RowOrigin) {
        self.set_cells(name, &origin.cells().map(|(column, cell)| (column.to_owned(), cell)));
    }

    fn set_cells(&mut self, name: &Name, cells: &[(String, String)]) {
        let Some(index) = self.rows.iter().position(|row| row.name == *name) else { return };
        for (column, cell) in cells {
            if cell.is_empty() && self.column(column).is_none() {
                continue;
            }
            let at = self.column(column).unwrap_or_else(|| {
                // Cells behind the last named column belong to the author of the file.
                let widest = self.rows.iter().map(|row| row.more.len()).max().unwrap_or(0);
                self.more_columns.resize(self.more_columns.len().max(widest), String::new());
                self.more_columns.push(column.clone());
                self.more_columns.len() - 1
            });
            let more = &mut self.rows[index].more;
            more.resize(more.len().max(at + 1), String::new());
            more[at].clone_from(cell);
        }
    }

    /// The further cells of a row by their columns' names; a cell without a name gets a number.
    fn named_cells(&self, row: usize) -> Vec<(String, String)> {
        let named = |(index, cell): (usize, &String)| {
            let name = self.more_columns.get(index).filter(|name| !name.trim().is_empty());
            (name.map_or_else(|| format!("column {}", index + 3), Clone::clone), cell.clone())
        };
        self.rows[row].more.iter().enumerate().map(named).collect()
    }

    /// Takes out the rows of other versions of the level. A row without a version stays.
    pub(super) fn take_other_versions(&mut self, version: LevelHash) -> BTreeMap<LevelHash, Self> {
        let other = |row| self.origin(row).version.filter(|&other| version != other);
        let others: Vec<Option<LevelHash>> = (0..self.rows.len()).map(other).collect();
        let mut taken: BTreeMap<LevelHash, Self> = BTreeMap::new();
        for (row, other) in std::mem::take(&mut self.rows).into_iter().zip(others) {
            let empty = || Self::new(self.more_columns.clone(), Vec::new());
            other.map_or(&mut self.rows, |other| &mut taken.entry(other).or_insert_with(empty).rows).push(row);
        }
        taken
    }

    /// Adds the rows of another board that are their users' best.
    pub(super) fn merge(&mut self, other: &Self) {
        for (index, BoardRow { name, score, .. }) in other.rows.iter().enumerate() {
            if let Ok(Placement::New { .. } | Placement::Raised { .. }) = self.place(name, *score) {
                self.set_origin(name, &RowOrigin::default());
                self.set_cells(name, &other.named_cells(index));
            }
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
