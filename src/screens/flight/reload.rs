//! A level that begins again, or whose files change while it is flown.

use super::Flight;
use super::ending::NOTICE;
use super::news::News;
use crate::files;
use crate::game::{GameError, History, Outcome, level_hash};
use crate::instruments::vary::Variation;
use crate::level::document::{LevelFolder, Opened};
use crate::level::{Level, Problem, scaffold};
use crate::scores::ResultRow;
use crate::screens::flight::race::Race;
use crate::session::Session;
use crate::session::answers::Worksheet;
use crate::session::attempt::Attempt;
use crate::session::library::Refusal;
use crate::ui::Spectator;
use crate::words::tr;
use std::path::Path;
use std::sync::Arc;

impl Flight {
    /// Has the level read again when its files have changed.
    pub(super) fn look_at_files(&mut self, frame_time: f64, session: &mut Session) {
        // A flight that is watched or in memory only has no files.
        let Some(watch) = &mut self.watch else { return };
        if !watch.update(frame_time) || !files::is_folder(watch.folder()) {
            return;
        }
        self.reading = Some(session.worker.ask(session.level_errand(&self.attempt.level.name)));
    }

    /// Goes on in the level as it was read again.
    pub(super) fn take_over_from_disk(
        &mut self,
        folder: &Path,
        level: Result<Arc<Level>, Refusal>,
        session: &Session,
        spectator: &mut dyn Spectator,
    ) {
        if session.library.folder(&self.attempt.level.name) != folder {
            return;
        }
        match level {
            Ok(level) => {
                self.watch = Some(session.library.watch(&level));
                if *level == *self.attempt.level {
                    // A comment or a picture has changed: the flight does not depend on it.
                    self.news = None;
                    spectator.goes_on(&self.game);
                } else {
                    self.take_over(level, spectator);
                }
            }
            Err(problems) => self.tell_of_problems(problems),
        }
    }

    /// Whether the level is read again before it is flown once more.
    pub(super) fn reads_again(&self, session: &Session) -> bool {
        !self.in_memory && files::is_folder(&session.library.folder(&self.attempt.level.name))
    }

    /// The attempt from its start, in the level as its files are now; where those do not load, as it was.
    pub(super) fn restart_as_on_disk(&mut self, session: &mut Session, spectator: &mut dyn Spectator) {
        if self.is_given_up() {
            session.note_loss(&self.game.level().name);
        }
        let flown = self.attempt.level.clone();
        let on_disk = self.reads_again(session);
        let (level, problems) = match on_disk.then(|| session.library.load(&flown.name)) {
            Some(Ok(level)) => (level, None),
            Some(Err(problems)) => (flown, Some(problems)),
            None => (flown, None),
        };
        if on_disk {
            self.watch = Some(session.library.watch(&level));
        }
        let problems = self.restart(level, spectator).err().map(|error| vec![error.to_string()]).or(problems);
        if let Some(problems) = problems {
            self.tell_of_problems(problems);
        }
    }

    /// Takes the sheet of the experiment, where it is one that is listed, as the player has left it.
    pub(super) fn take_sheet(&mut self, session: &mut Session) {
        let level = &self.attempt.level;
        if !level.experiment || self.is_watched() {
            return;
        }
        let listed = || session.library.experiments().ok()?.into_iter().find(|listed| listed.folder == level.name);
        let sheet = session.answers.sheets.remove(&level.name).or_else(|| listed().map(Worksheet::new));
        self.sheet = sheet.map(Box::new);
    }

    /// Saves an answer, and says on the sheet what became of it.
    pub(super) fn hand_in(&mut self, row: ResultRow, session: &mut Session) {
        let told = session.answers.hand_in(row, session.journal.current(), session.now);
        if let Some(sheet) = &mut self.sheet {
            sheet.tell(told);
        }
    }

    /// Writes a folder with the level's files and the varied numbers in them; its place, in words.
    pub(super) fn save_varied(&self, variation: &Variation, name: &str, session: &mut Session) -> Result<String, String> {
        if self.in_memory {
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
    ///
    /// # Errors
    /// The level makes no world; the flight goes on then.
    pub(super) fn restart(&mut self, level: Arc<Level>, spectator: &mut dyn Spectator) -> Result<(), GameError> {
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
            in_memory: self.in_memory,
            watch: self.watch.take(),
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
    pub(super) fn take_over(&mut self, level: Arc<Level>, spectator: &mut dyn Spectator) {
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
    pub(super) fn tell_of_problems(&mut self, problems: Vec<String>) {
        self.news = Some(News::Broken(problems));
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
