//! A level that begins again, or whose files change while it is flown.

use super::Flight;
use super::ending::NOTICE;
use super::news::News;
use crate::game::{GameError, History, Outcome, level_hash};
use crate::level::Level;
use crate::screens::flight::race::Race;
use crate::session::attempt::Attempt;
use crate::ui::Spectator;
use std::sync::Arc;

impl Flight {
    /// Begins again, with the overlays as they are.
    ///
    /// # Errors
    /// The level makes no world; the flight goes on then.
    pub(in crate::screens) fn restart(&mut self, level: Arc<Level>, spectator: &mut dyn Spectator) -> Result<(), GameError> {
        let flies_on = self.flies_on();
        let (same, varied) = (level_hash(&level) == level_hash(&self.attempt.level), self.what_if.take());
        let mut fresh = Self::new(Attempt { level, ..self.attempt.clone() }, spectator)?;
        let lost = flies_on.then(|| self.take_lost());
        if same {
            // The known flights of the ghosts stay known.
            fresh.race = self.race.take().map(Race::again);
        }
        *self = Self {
            stale: self.stale.all(),
            details: self.details,
            hitboxes: self.hitboxes,
            observer: self.observer,
            instruments: std::mem::take(&mut self.instruments).of_another_flight(),
            test: self.test,
            hints: self.hints,
            sheet: self.sheet.take(),
            lost,
            settings_problems: std::mem::take(&mut self.settings_problems),
            ..fresh
        };
        self.wait_for_a_guess();
        if let Some(Err(words)) = varied.map(|varied| self.begin_varied(varied, same)) {
            self.instruments.vary_mut().tell(words, true);
        }
        Ok(())
    }

    /// Goes on in a level that has been edited: where the ship is, as far as there is room, else from the start. A flight in two levels is a
    /// flight with help.
    pub(in crate::screens) fn take_over(&mut self, level: Arc<Level>, spectator: &mut dyn Spectator) {
        if self.game.outcome() != Outcome::Running {
            return;
        }
        // A varied level is varied from its start again.
        let carried =
            if self.is_by_hand() && self.what_if.is_none() { self.game.carried_into(&self.attempt.level, &level) } else { None };
        let goes_on = carried.is_some();
        if let Some(game) = carried {
            self.history = History::new(&game);
            self.instruments = std::mem::take(&mut self.instruments).of_another_flight();
            (self.game, self.attempt.level, self.assisted) = (game, level, true);
            spectator.goes_on(&self.game);
        } else {
            let (pause, settings) = (self.pause.take(), self.settings.take());
            if let Err(error) = self.restart(level, spectator) {
                return self.tell_of_problems(vec![error.to_string()]);
            }
            (self.pause, self.settings) = (pause, settings);
        }
        self.news = Some(News::Changed(0.0, goes_on));
    }

    /// Shows why the level's files do not load any more; the flight goes on.
    pub(in crate::screens) fn tell_of_problems(&mut self, problems: Vec<String>) {
        self.news = Some(News::Broken(problems));
    }

    /// The level's files hold the level that is flown again.
    pub(in crate::screens) fn tell_of_mending(&mut self) {
        self.news = None;
    }

    /// A frame of the notice that the level has changed.
    pub(super) fn age_news(&mut self, frame_time: f64) {
        if let Some(News::Changed(since, _)) = &mut self.news {
            *since += frame_time;
            if *since > NOTICE {
                self.news = None;
            }
        }
    }
}
