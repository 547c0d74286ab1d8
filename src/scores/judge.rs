//! Judges the rows of a board: at sight where that is enough, else by flights in turn, so that no long one delays the others.

use super::board::Board;
use super::earned::{Claim, Doubt, Standing, at_sight};
use super::folder::Scores;
use super::name::Name;
use crate::game::Medals;
use crate::level::Level;
use std::collections::{HashMap, VecDeque};
use std::sync::Arc;

/// Flights at once.
pub const IN_TURN: usize = 10;
/// Ticks of a flight until the next one's turn.
pub const TURN: u64 = 30;

#[derive(Debug, Default)]
struct Judged {
    /// `None` until it is known.
    standing: Option<Standing>,
    /// The record's, s.
    time: Option<f64>,
    /// None before the proof.
    medals: Medals,
    flies: bool,
}

#[derive(Debug)]
pub struct Judge {
    scores: Scores,
    level: Arc<Level>,
    rows: HashMap<Name, Judged>,
    /// By the hash of a flight's last state.
    ends: HashMap<u64, Name>,
    air: VecDeque<(Name, Box<Claim>)>,
    ticks: u64,
}

impl Judge {
    /// Judges at sight. The flights follow with [`Judge::begin`] and [`Judge::fly`].
    pub fn new(scores: Scores, level: Arc<Level>, board: &Board) -> Self {
        let (mut rows, mut files) = (HashMap::new(), HashMap::new());
        for (index, row) in board.rows().iter().enumerate() {
            let origin = board.origin(index);
            let mut standing = at_sight(row, &origin, &level);
            if let (None, Some(file)) = (&standing, origin.flight) {
                let first = files.entry(file).or_insert_with(|| row.name.clone());
                standing = (*first != row.name).then(|| Standing::Doubtful(Doubt::Twice(first.clone())));
            }
            rows.insert(row.name.clone(), Judged { standing, ..Judged::default() });
        }
        Self { scores, level, rows, ends: HashMap::new(), air: VecDeque::new(), ticks: 0 }
    }

    /// `None` until it is known.
    pub fn standing(&self, name: &Name) -> Option<&Standing> {
        self.rows.get(name)?.standing.as_ref()
    }

    pub fn fails(&self, name: &Name) -> bool {
        matches!(self.standing(name), Some(Standing::Doubtful(_)))
    }

    /// The time in the row's record, s, unless the row fails.
    pub fn time(&self, name: &Name) -> Option<f64> {
        self.rows.get(name)?.time.filter(|_| !self.fails(name))
    }

    /// None before the proof.
    pub fn medals(&self, name: &Name) -> Medals {
        self.rows.get(name).map(|row| row.medals).unwrap_or_default()
    }

    pub const fn ticks(&self) -> u64 {
        self.ticks
    }

    pub fn flies(&self) -> bool {
        !self.air.is_empty()
    }

    /// Reads the flight of the first of these rows that is neither judged nor in flight, if fewer than [`IN_TURN`] are; the answer
    /// is that row.
    pub fn begin(&mut self, board: &Board, rows: impl IntoIterator<Item = usize>) -> Option<usize> {
        if self.air.len() >= IN_TURN {
            return None;
        }
        let open = |name: &Name| self.rows.get(name).is_some_and(|row| row.standing.is_none() && !row.flies);
        let index = rows.into_iter().find(|&row| open(&board.rows()[row].name))?;
        let (row, origin) = (&board.rows()[index], board.origin(index));
        let flight = self.scores.flight(&self.level.name, &origin).unwrap_or(Err(Doubt::Emptied.to_string()));
        let (end, time) = flight.as_ref().map(|flight| (flight.hash, Some(flight.time))).unwrap_or_default();
        let claim = flight.map_err(Doubt::Unreadable).and_then(|flight| Claim::new(row, &origin, flight, self.level.clone()));
        if let Some(judged) = self.rows.get_mut(&row.name) {
            (judged.time, judged.flies) = (time, true);
        }
        match claim.and_then(|claim| self.is_the_only_one(board, &row.name, end).map(|()| claim)) {
            Ok(claim) => self.air.push_back((row.name.clone(), Box::new(claim))),
            Err(doubt) => self.conclude(&row.name, Err(doubt)),
        }
        Some(index)
    }

    /// Flies `ticks` ticks in all, the flights in turn.
    pub fn fly(&mut self, mut ticks: u64) {
        while ticks > 0 {
            let Some((name, mut claim)) = self.air.pop_front() else { return };
            let turn = TURN.min(ticks);
            let verdict = (0..turn).find_map(|_| {
                (ticks, self.ticks) = (ticks - 1, self.ticks + 1);
                claim.step()
            });
            match verdict {
                Some(verdict) => self.conclude(&name, verdict),
                // An older row turned out to have the same flight.
                None if self.fails(&name) => {}
                None => self.air.push_back((name, claim)),
            }
        }
    }

    fn conclude(&mut self, name: &Name, verdict: Result<Medals, Doubt>) {
        let Some(row) = self.rows.get_mut(name).filter(|row| row.standing.is_none()) else { return };
        match verdict {
            Ok(medals) => (row.standing, row.medals) = (Some(Standing::Proven), medals),
            Err(doubt) => row.standing = Some(Standing::Doubtful(doubt)),
        }
    }

    /// Refuses the second of two rows whose flights end alike: the older row, which stands ahead, may keep the flight.
    fn is_the_only_one(&mut self, board: &Board, name: &Name, end: u64) -> Result<(), Doubt> {
        match self.ends.insert(end, name.clone()) {
            Some(other) if self.fails(&other) => Ok(()),
            Some(other) if board.rank(&other) < board.rank(name) => {
                self.ends.insert(end, other.clone());
                Err(Doubt::Twice(other))
            }
            Some(other) => {
                if let Some(row) = self.rows.get_mut(&other) {
                    (row.standing, row.medals) = (Some(Standing::Doubtful(Doubt::Twice(name.clone()))), Medals::default());
                }
                Ok(())
            }
            None => Ok(()),
        }
    }
}
