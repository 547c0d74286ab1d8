//! Scores: saved under a name, and shown on their boards.

use crate::classics::jumper::scene::LEADERBOARD;
use crate::game::RunResult;
use crate::scores::{LoadedBoard, Name, Placement, Saved, Score, ScoresError, damage_text, subject};
use crate::screens::App;
use crate::screens::boards::{Fresh, Leaderboard};
use crate::screens::classics::jumper;
use crate::screens::scoring::Scoring;
use crate::screens::scoring::save_score::SaveScore;
use crate::screens::screen::{Classic, Gain, Onward, Purpose, Request, Screen};
use crate::session::attempt::{Attempt, Flown};
use crate::session::recordings::{self, Visit};
use crate::words::tr;
use std::rc::Rc;

impl App {
    pub(super) fn scoring(&mut self, attempt: Attempt, result: RunResult, flown: Option<Rc<Flown>>) -> Box<dyn Screen> {
        let next = self.library.after(&result.level);
        // Asked for while the next attempt is being flown, it is that of the attempt before.
        let remark = self.ended.get_or_insert_with(|| self.lost.take().unwrap_or_default()).clone();
        let best = self.journal.best(&result.level);
        Box::new(Scoring::new(attempt, result, flown, next, remark).with_best(best))
    }

    /// Saves a score under the player's name, or asks for the name where there is none.
    pub(super) fn save_score(&mut self, gain: Gain) -> Box<dyn Screen> {
        let name = self.journal.current().clone();
        if name.is_guest() {
            return Box::new(SaveScore::new(gain, None));
        }
        self.submit(gain.clone(), name.clone()).unwrap_or_else(|reason| {
            let mut screen = SaveScore::new(gain, Some(&name));
            screen.refuse(reason);
            Box::new(screen)
        })
    }

    /// Says why a score could not be saved, where its name is asked for.
    pub(super) fn refuse(&mut self, reason: String) {
        if let Some(screen) = self.screen.get_mut::<SaveScore>() {
            screen.refuse(reason);
        }
    }

    /// Saves a score under that name; the leaderboard then, or why it cannot be saved.
    pub(super) fn submit(&mut self, gain: Gain, name: Name) -> Result<Box<dyn Screen>, String> {
        let flight = gain.flown.as_ref().map(|flown| &flown.replay);
        let score = Score { name: &name, points: gain.points, flight };
        let Saved { board, placement } = self.scores.save_with_flight(&gain.board, score).map_err(|error| error.to_string())?;
        let remark = match placement {
            Placement::Kept { best, .. } => Some(tr!("Your best of {best} points stays.", best)),
            Placement::New { .. } | Placement::Raised { .. } => None,
        };
        if name != *self.journal.current() {
            self.choose(name.clone(), true);
        }
        self.unsaved_score = None;
        let fresh = Fresh { name, remark };
        Ok(self.with_rivals(&gain.board, Leaderboard::new(gain.subject, board, Some(fresh), None, gain.onward)))
    }

    /// A level's board with the level's own flights, where the level loads.
    fn with_rivals(&self, name: &str, screen: Leaderboard) -> Box<dyn Screen> {
        if name == LEADERBOARD {
            return Box::new(screen);
        }
        let level = self.library.load(name).ok();
        let rivals = level.map(|level| recordings::rivals(&self.library.folder(name), &level)).unwrap_or_default();
        Box::new(screen.of_level(name, rivals))
    }

    pub(super) fn leaderboard(&mut self, name: &str) -> Box<dyn Screen> {
        if name == LEADERBOARD {
            let onward = vec![Onward { label: "Back", to: Request::Classic(Classic::Jumper) }];
            let shown = self.scores.load(name);
            return self.board(tr(jumper::SUBJECT).to_owned(), name, shown, onward);
        }
        self.last_level = Some(name.to_owned());
        let level = self.library.load(name).ok();
        let title = level.as_ref().map_or(name, |level| &level.title);
        let shown = self.scores.load(name);
        let back = Request::Leaderboard(name.to_owned());
        let flights = Onward {
            label: "Flights",
            to: Request::Flights(Visit { level: name.to_owned(), flown: None, chosen: None, back: Box::new(back) }),
        };
        let back = Onward { label: "Back", to: Request::LevelSelect(Purpose::Leaderboard) };
        let is_empty = shown.as_ref().is_ok_and(|loaded| loaded.board.rows().is_empty());
        let play = (is_empty && level.is_some()).then(|| Onward { label: "Play", to: Request::Play(name.to_owned()) });
        let onward = play.into_iter().chain(level.iter().map(|_| flights.clone())).chain([back]).collect();
        self.board(subject(name, title), name, shown, onward)
    }

    /// A board with its buttons; or the list of levels, where it cannot be read.
    fn board(
        &mut self,
        subject: String,
        name: &str,
        shown: Result<LoadedBoard, ScoresError>,
        onward: Vec<Onward>,
    ) -> Box<dyn Screen> {
        match shown {
            Ok(LoadedBoard { board, damage }) => {
                let damage = (!damage.is_empty()).then(|| damage_text(&damage));
                self.with_rivals(name, Leaderboard::new(subject, board, None, damage, onward))
            }
            Err(error) => {
                let mut screen = self.level_select(Purpose::Leaderboard);
                screen.show(tr!("The scores of {subject} cannot be read", subject), vec![error.to_string()]);
                Box::new(screen)
            }
        }
    }
}
