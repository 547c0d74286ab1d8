//! What is open over a flight: its panels and notices, and the level's files. The viewer's part of a watched flight.

use super::Flight;
use super::ahead::Ahead;
use super::signs::{Hints, News};
use super::trail::FlownTrail;
use crate::game::{Game, GameError, History, Unflown};
use crate::level::Level;
use crate::screens::{screen::Screen, settings::SettingsPanel};
use crate::session::{Session, folder_watch::FolderWatch, journal::Worksheet, library::Attempt, worker::Ticket};
use crate::ui::Spectator;
use std::sync::Arc;

#[derive(Debug, Default)]
pub(super) struct Open {
    /// The label of the pause panel's last button, while the panel is open.
    pub pause: Option<&'static str>,
    pub settings: Option<Box<SettingsPanel>>,
    /// The problems of their file.
    pub settings_problems: Vec<String>,
    /// The state of the level's files, while it is shown.
    pub news: Option<News>,
    pub hints: Hints,
    /// Age of the introduction, while it is shown, s.
    pub introduced: Option<f64>,
    /// Whether the player has completed the level before.
    pub done: bool,
    /// Of an experiment that is listed.
    pub sheet: Option<Box<Worksheet>>,
    /// Whether the flight tries out an edited level: it does not count.
    pub test: bool,
    /// Of a test.
    pub trail: FlownTrail,
    /// Whether that level is in memory only.
    pub in_memory: bool,
    pub watch: Option<FolderWatch>,
    /// The level, while it is read again.
    pub reading: Option<Ticket>,
}

impl Flight {
    /// An attempt at its start, whose level's files are watched.
    /// Errors: the level makes no world; so of all that follow.
    pub fn open(attempt: Attempt, session: &mut Session, spectator: &mut dyn Spectator) -> Result<Self, GameError> {
        let comes = session.last_flown.replace(attempt.level.name.clone()).as_ref() != Some(&attempt.level.name);
        let introduced =
            (comes && attempt.level.ship_plays() && attempt.inputs.is_none() && attempt.rivals.is_empty()).then_some(0.0);
        session.last_level = Some(attempt.level.name.clone());
        let watch = Some(session.library.watch(&attempt.level));
        let mut flight = Self::new(attempt, spectator)?;
        (flight.open.watch, flight.open.introduced) = (watch, introduced);
        flight.tell_of_settings(&session.settings, &session.settings_problems);
        flight.take_sheet(session);
        Ok(flight)
    }

    /// An attempt that tries out an edited level, in memory only or as its files are, from its start or from where a flight was stopped: Esc
    /// and F5 lead back to the editor, and so does its end.
    pub(in crate::screens) fn test(
        (level, in_memory): (Arc<Level>, bool),
        (left, on): (Vec<String>, Option<Box<Game>>),
        session: &Session,
        spectator: &mut dyn Spectator,
    ) -> Result<Self, GameError> {
        let news = (!left.is_empty()).then_some(News::Unfinished(left));
        let mut flight = Self::new(Attempt::by_hand(level), spectator)?;
        flight.open = Open { test: true, in_memory, news, ..flight.open };
        if let Some(game) = on {
            flight.run.history = History::new(&game);
            (flight.run.game, flight.run.assisted) = (*game, true);
            spectator.goes_on(&flight.run.game);
        }
        flight.tell_of_settings(&session.settings, &[]);
        Ok(flight)
    }
}

#[derive(Debug)]
pub(super) struct Viewer {
    pub title: String,
    /// The inputs that the history lacks.
    pub unflown: Option<Unflown>,
    /// Ticks to fly of them in a frame.
    pub ahead: Ahead,
    /// Whether the pointer holds the time line.
    pub dragged: bool,
}
