//! A name for a score, where the player has none yet, or where saving takes a second try.

use crate::scores::{Name, unsaved_points};
use crate::screens::screen::{Destination, Effect, Fresh, Gain, Request, Screen};
use crate::session::Session;
use crate::ui::prompt::{NameEntry, NameField};
use crate::ui::{Spectator, Ui};
use std::path::Path;

/// The field for the name.
#[derive(Debug)]
pub struct SaveScore {
    gain: Gain,
    field: NameField,
    /// Whether it could not be saved.
    failed: bool,
}

impl SaveScore {
    /// The field for that score, with the player's name and why the score could not be saved under it.
    pub fn open(gain: Gain, problem: Option<String>, session: &Session) -> Self {
        let name = session.journal.current();
        let field = NameField::new(if name.is_guest() { "" } else { name.as_str() });
        let mut screen = Self { gain, field, failed: false };
        if let Some(problem) = problem {
            screen.refuse(problem);
        }
        screen
    }
}

impl Screen for SaveScore {
    fn show(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        ui.page("Save score", ui.frame().size.y * 0.2);
        let score = unsaved_points(self.gain.points, &self.gain.subject);
        Some(match self.field.show(ui, (&score, if self.failed { "Try again" } else { "Save" }))? {
            NameEntry::Name(name) => Request::Do(Effect::SaveScore(self.gain.clone(), Some(name))),
            NameEntry::Back => Request::Pop,
        })
    }

    fn tune(&self) -> Option<&str> {
        None
    }

    fn unsaved(&self) -> Option<String> {
        Some(unsaved_points(self.gain.points, &self.gain.subject))
    }

    fn takes(&self, _: &Path) -> bool {
        false
    }

    fn carry_out(&mut self, effect: Effect, session: &mut Session, _: &mut dyn Spectator) -> Option<Request> {
        let Effect::SaveScore(gain, Some(name)) = effect else { return None };
        save(gain, name, session).map_err(|(_, problem)| self.refuse(problem)).ok()
    }

    fn refuse(&mut self, reason: String) {
        self.field.refuse(reason);
        self.failed = true;
    }
}

/// Saves a score under the player's name: the leaderboard then, or the field for the name.
pub fn save_as_player(effect: Effect, session: &mut Session) -> Option<Request> {
    let Effect::SaveScore(gain, None) = effect else { return None };
    let name = session.journal.current().clone();
    let ask = |(gain, problem)| Request::Push(Destination::SaveScore(gain, problem));
    Some(if name.is_guest() {
        ask((gain, None))
    } else {
        save(gain, name, session).unwrap_or_else(|(gain, problem)| ask((gain, Some(problem))))
    })
}

fn save(gain: Gain, name: Name, session: &mut Session) -> Result<Request, (Gain, String)> {
    match session.save_score(&gain.board, gain.points, gain.flown.as_deref(), &name) {
        Ok(remark) => Ok(Request::Reset(Destination::Saved(gain, Fresh { name, remark }))),
        Err(problem) => Err((gain, problem)),
    }
}
