//! A level that begins again, or whose files change while it is flown.

use super::{Flight, ending::NOTICE, ending::Run, open::Open, pilot::Pilot, signs::News};
use crate::game::{GameError, History, Outcome, level_hash};
use crate::level::{Level, Problem, scaffold};
use crate::session::library::{Attempt, Refusal};
use crate::{files, instruments::vary::Variation, screens::flight::race::Race, ui::Spectator, words::tr};
use crate::{level::document::LevelFolder, level::document::Opened, session::Session, session::journal::Worksheet};
use std::{path::Path, sync::Arc};

impl Flight {
    pub(super) fn look_at_files(&mut self, frame_time: f64, session: &mut Session) {
        // A flight that is watched or in memory only has no files.
        let Some(watch) = &mut self.open.watch else { return };
        if !watch.update(frame_time) || !files::is_folder(&watch.folder) {
            return;
        }
        self.open.reading = Some(session.worker.ask(session.level_errand(&self.run.attempt.level.name)));
    }

    pub(super) fn take_over_from_disk(
        &mut self,
        folder: &Path,
        level: Result<Arc<Level>, Refusal>,
        session: &Session,
        spectator: &mut dyn Spectator,
    ) {
        if session.library.folder(&self.run.attempt.level.name) != folder {
            return;
        }
        match level {
            Ok(level) => {
                self.open.watch = Some(session.library.watch(&level));
                if *level == *self.run.attempt.level {
                    // A comment or a picture has changed: the flight does not depend on it.
                    self.open.news = None;
                    spectator.goes_on(&self.run.game);
                } else {
                    self.take_over(level, spectator);
                }
            }
            Err(problems) => self.tell_of_problems(problems),
        }
    }

    pub(super) fn reads_again(&self, session: &Session) -> bool {
        !self.open.in_memory && files::is_folder(&session.library.folder(&self.run.attempt.level.name))
    }

    /// The attempt from its start, in the level as its files are now; where those do not load, as it was.
    pub(super) fn restart_as_on_disk(&mut self, session: &mut Session, spectator: &mut dyn Spectator) {
        if self.is_given_up() {
            session.note_loss(&self.run.game.level().name);
        }
        let flown = self.run.attempt.level.clone();
        let on_disk = self.reads_again(session);
        let (level, problems) = match on_disk.then(|| session.library.load(&flown.name)) {
            Some(Ok(level)) => (level, None),
            Some(Err(problems)) => (flown, Some(problems)),
            None => (flown, None),
        };
        if on_disk {
            self.open.watch = Some(session.library.watch(&level));
        }
        let problems = self.restart(level, spectator).err().map(|error| vec![error.to_string()]).or(problems);
        if let Some(problems) = problems {
            self.tell_of_problems(problems);
        }
    }

    /// Takes the sheet of the experiment, where it is one that is listed, as the player has left it.
    pub(super) fn take_sheet(&mut self, session: &mut Session) {
        let level = &self.run.attempt.level;
        if !level.experiment || self.is_watched() {
            return;
        }
        let listed = || session.library.experiments().ok()?.into_iter().find(|listed| listed.folder == level.name);
        let sheet = session.answers.sheets.remove(&level.name).or_else(|| listed().map(Worksheet::new));
        self.open.sheet = sheet.map(Box::new);
    }

    /// Saves what is written on the sheet, and says there what became of it.
    pub(super) fn hand_in(&mut self, session: &mut Session) {
        if let Some(sheet) = self.open.sheet.as_mut().filter(|sheet| sheet.is_unsaved()) {
            sheet.fix_prediction(session.now);
            let saved = session.answers.hand_in(sheet.take_unsaved(), session.journal.current(), session.now);
            sheet.set_message(saved);
        }
    }

    /// Writes a folder with the level's files and the varied numbers in them; its place, in words.
    pub(super) fn save_varied(&self, variation: &Variation, name: &str, session: &mut Session) -> Result<String, String> {
        if self.open.in_memory {
            return Err(tr("An edited level is saved in the editor.").to_owned());
        }
        let level = self.attempt().level.clone();
        let first = |problems: Vec<Problem>| problems.first().map_or_else(String::new, ToString::to_string);
        let wanted = variation.apply(&level).map_err(first)?;
        let levels = session.library.levels().to_path_buf();
        let name = if name.is_empty() { scaffold::free_name(&levels, &level.name, "what-if") } else { name.to_owned() };
        scaffold::judge(&levels, &name)?;
        let from = session.library.folder(&level.name);
        let Opened { mut document, folder, .. } = LevelFolder::open(&from, session.library.root())?;
        document.vary(&wanted, &variation.parameters(), None)?;
        let loaded = folder.check(&document).map_err(first)?;
        if level_hash(&loaded.level) != level_hash(&wanted) {
            return Err(tr("The level's files have changed since: R reads them.").to_owned());
        }
        document.set_setting("title", &tr!("{title}: what if", title = level.title), None)?;
        scaffold::copy_edited(&from, &levels, &name, &document).map_err(|error| error.to_string())?;
        let saved = tr!("Saved as {path}", path = levels.join(&name).display());
        session.last_level = Some(name);
        Ok(saved)
    }

    /// Begins again, with the overlays as they are.
    /// Errors: the level makes no world; the flight goes on then.
    pub(super) fn restart(&mut self, level: Arc<Level>, spectator: &mut dyn Spectator) -> Result<(), GameError> {
        let flies_on = self.flies_on();
        let (same, varied) = (level_hash(&level) == level_hash(&self.run.attempt.level), self.run.what_if.take());
        let mut fresh = Self::new(Attempt { level, ..self.run.attempt.clone() }, spectator)?;
        let lost = flies_on.then(|| self.take_lost());
        if same {
            // The known flights of the ghosts stay known.
            fresh.run.race = self.run.race.take().map(Race::again);
        }
        // Panels close; what is seen, and the sheet, stay.
        self.seen.instruments = std::mem::take(&mut self.seen.instruments).of_another_flight();
        self.open = Open { pause: None, settings: None, news: None, reading: None, ..std::mem::take(&mut self.open) };
        self.pilot = Pilot { stale: self.pilot.stale.all(), ..fresh.pilot };
        self.run = Run { lost, ..fresh.run };
        self.wait_for_start();
        if let Some(Err(words)) = varied.map(|varied| self.begin_varied(varied, same)) {
            self.seen.instruments.vary.set_message(words, true);
        }
        Ok(())
    }

    /// Goes on in an edited level, where there is room at the ship's place, else from the start. A flight in two levels is one with help.
    pub(super) fn take_over(&mut self, level: Arc<Level>, spectator: &mut dyn Spectator) {
        if self.run.game.outcome() != Outcome::Running {
            return;
        }
        // A varied level is varied from its start again.
        let carried = if self.is_by_hand() && self.run.what_if.is_none() {
            self.run.game.carried_into(&self.run.attempt.level, &level)
        } else {
            None
        };
        let goes_on = carried.is_some();
        if let Some(game) = carried {
            self.run.history = History::new(&game);
            self.seen.instruments = std::mem::take(&mut self.seen.instruments).of_another_flight();
            (self.run.game, self.run.attempt.level, self.run.assisted) = (game, level, true);
            spectator.goes_on(&self.run.game);
        } else {
            let (pause, settings) = (self.open.pause.take(), self.open.settings.take());
            if let Err(error) = self.restart(level, spectator) {
                return self.tell_of_problems(vec![error.to_string()]);
            }
            (self.open.pause, self.open.settings) = (pause, settings);
        }
        self.open.news = Some(News::Changed(0.0, goes_on));
    }

    /// Shows why the level's files do not load any more; the flight goes on.
    fn tell_of_problems(&mut self, problems: Vec<String>) {
        self.open.news = Some(News::Broken(problems));
    }

    pub(super) fn age_news(&mut self, frame_time: f64) {
        if let Some(News::Changed(since, _)) = &mut self.open.news {
            *since += frame_time;
            if *since > NOTICE {
                self.open.news = None;
            }
        }
    }
}
