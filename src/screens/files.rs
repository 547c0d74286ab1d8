//! What the app does with levels' files while it runs: it reads them anew when they change, opens what is dropped on the window, and makes,
//! names and edits levels.

use super::level_select::Entry;
use super::{App, Attempt, Editor, Flight, LevelSelect, Make, Miniature, Purpose, Request, Screen, Spectator, Stamp, footage};
use crate::game::{Outcome, level_hash};
use crate::instruments::vary::Variation;
use crate::level::document::{Folder, Opened};
use crate::level::{self, Awards, Level, Problem, scaffold};
use crate::number::clock;
use std::path::Path;
use std::sync::Arc;

impl App {
    /// Begins with a level in any folder.
    pub fn begin(&mut self, folder: &Path, request: Request, spectator: &mut dyn Spectator) {
        self.library.open(folder);
        self.grant(request, spectator);
    }

    /// Reads the level that is flown anew when its files have changed. What is flown from the editor is not on disk.
    pub(super) fn look_at_files(&mut self, frame_time: f64, spectator: &mut dyn Spectator) {
        let (Screen::Flight(flight), Some(watch), None) = (&mut self.screen, &mut self.watch, &self.editing) else { return };
        if !watch.update(frame_time) || !watch.folder().is_dir() {
            return;
        }
        let flown = flight.attempt().level.clone();
        match self.library.load(&flown.name) {
            Ok(level) => {
                self.watch = Some(self.library.watch(&level));
                if *level == *flown {
                    // A comment, a picture: nothing that the flight depends on.
                    flight.tell_of_mending();
                    spectator.goes_on(flight.game());
                } else {
                    flight.take_over(level, spectator);
                }
            }
            Err(problems) => flight.tell_of_problems(problems),
        }
    }

    /// The attempt on the screen from its start, in the level as its files are now; where those do not load, as it was.
    pub(super) fn restart(&mut self, spectator: &mut dyn Spectator) {
        let Screen::Flight(flight) = &mut self.screen else { return };
        let Attempt { level: flown, .. } = flight.attempt().clone();
        let on_disk = self.editing.is_none() && self.library.folder(&flown.name).is_dir();
        let (level, problems) = match on_disk.then(|| self.library.load(&flown.name)) {
            Some(Ok(level)) => (level, None),
            Some(Err(problems)) => (flown, Some(problems)),
            None => (flown, None),
        };
        if on_disk {
            self.watch = Some(self.library.watch(&level));
        }
        if let Err(error) = flight.restart(level, spectator) {
            return flight.tell_of_problems(vec![error.to_string()]);
        }
        self.lost = self.ended.take();
        if let Some(problems) = problems {
            flight.tell_of_problems(problems);
        }
    }

    /// Flies the level of a folder, or of a file in it, wherever that is; or the list of levels, with why it cannot be flown.
    pub(super) fn open_folder(&mut self, path: &Path, spectator: &mut dyn Spectator) -> Screen {
        let loaded = match self.library.open(path) {
            Some(name) => self.library.load(&name).map_err(|refusal| (format!("Level {name} does not load"), refusal)),
            None => Err(("There is no such level".to_owned(), vec![path.display().to_string()])),
        };
        match loaded {
            Ok(level) => self.flight(Attempt::by_hand(level), spectator),
            Err((heading, problems)) => {
                let mut screen = self.level_select(Purpose::Play);
                screen.show(heading, problems);
                Screen::LevelSelect(screen)
            }
        }
    }

    /// Tells the list of levels what is new in view, and the list of flights how long one of them took.
    pub(super) fn fill_in_view(&mut self) {
        if let Screen::Flights(screen) = &mut self.screen {
            // One file is enough for a frame.
            screen.look_one_up(|visit, source| footage::read(visit, source, &self.scores).ok());
        }
        let Screen::LevelSelect(screen) = &mut self.screen else { return };
        screen.learn_titles(|name| self.library.title(name));
        let unknown = |index: &usize| screen.entries()[*index].level.is_none();
        let new: Vec<(usize, String)> =
            screen.in_view().into_iter().filter(unknown).map(|index| (index, screen.entries()[index].name.clone())).collect();
        for (index, name) in new {
            let entry = self.entry(&name);
            self.tell(index, entry);
        }
    }

    /// Looks whether the levels in view have changed on disk.
    pub(super) fn refresh_view(&mut self, frame_time: f64) {
        let Screen::LevelSelect(screen) = &mut self.screen else { return };
        if !screen.looks(frame_time) {
            return;
        }
        let entries = screen.in_view().into_iter().map(|index| (index, screen.entries()[index].clone()));
        let changed = entries.filter(|(_, entry)| entry.stamp != Stamp::of(&self.library.folder(&entry.name), &[]));
        for (index, entry) in changed.collect::<Vec<_>>() {
            let entry = self.entry(&entry.name);
            self.tell(index, entry);
        }
    }

    fn tell(&mut self, index: usize, entry: Entry) {
        if let Screen::LevelSelect(screen) = &mut self.screen {
            screen.tell(index, entry);
        }
    }

    /// What is known of a level now.
    fn entry(&self, name: &str) -> Entry {
        // Looked at before it is read: what is written in between is seen the next time.
        let stamp = Stamp::of(&self.library.folder(name), &[]);
        let (level, best) = (self.library.load(name), self.journal.best(name));
        let awards = level.as_ref().map_or_else(|_| Awards::default(), |level| level.awards);
        let medals = self.journal.medals(name).with_best(&awards, best);
        let title = level.as_ref().ok().map(|level| level.title.clone());
        let level = Some(level.map(|level| (level.title.clone(), Miniature::of(&level))));
        Entry { level, stamp, title, best, awards, medals, name: name.to_owned() }
    }

    /// The editor of a level; of one that comes with the game, the list with the question what a copy of it is to be called. A flight waits.
    pub(super) fn edit_or_copy(&mut self, name: &str) -> Screen {
        let folder = self.library.folder(name);
        let nothing = Screen::LevelSelect(LevelSelect::new(Purpose::Edit, Vec::new()));
        match std::mem::replace(&mut self.screen, nothing) {
            Screen::Flight(flight) => self.behind = Some((flight, folder.clone())),
            other => self.screen = other,
        }
        if !level::is_shipped(&folder) {
            return self.edit(name);
        }
        self.last_level = Some(name.to_owned());
        let free = scaffold::free_name(self.library.levels(), name, "copy");
        let mut screen = self.level_select(Purpose::Edit);
        screen.ask_for_copy(name, folder, &free);
        Screen::LevelSelect(screen)
    }

    /// Back to the flight that editing began from, in the level as it is saved now; else to the list.
    pub(super) fn leave_editor(&mut self, spectator: &mut dyn Spectator) -> Screen {
        let Some((flight, folder)) = self.behind.take() else { return Screen::LevelSelect(self.level_select(Purpose::Edit)) };
        self.library.open(&folder);
        self.last_level = Some(flight.game().level().name.clone());
        spectator.begins(flight.game());
        Screen::Flight(flight)
    }

    /// The editor of a level, or the list with what is wrong.
    pub(super) fn edit(&mut self, name: &str) -> Screen {
        self.last_level = Some(name.to_owned());
        match Editor::open(&self.library.folder(name), self.library.root()) {
            Ok(editor) => Screen::Editor(Box::new(editor)),
            Err(problem) => {
                let mut screen = self.level_select(Purpose::Edit);
                screen.show(format!("Level {name} cannot be edited"), vec![problem]);
                Screen::LevelSelect(screen)
            }
        }
    }

    /// Makes or names a level's folder; the screen to go on with.
    ///
    /// # Errors
    /// Why that cannot be, in words.
    pub(super) fn make(&mut self, make: &Make) -> Result<Screen, String> {
        let levels = self.library.levels().to_path_buf();
        let (Make::New(name) | Make::Copy(_, name) | Make::Rename(_, name)) = make;
        scaffold::judge(&levels, name)?;
        if let Make::Rename(from, _) = make
            && level::is_shipped(&levels.join(from))
        {
            return Err(format!("{from} comes with the game and keeps its name: make a copy."));
        }
        let made = match make {
            Make::New(_) => scaffold::make(&levels, name, &scaffold::BARE),
            Make::Copy(from, _) => scaffold::copy(&levels.join(from), &levels, name),
            Make::Rename(from, _) => scaffold::rename(&levels, from, name),
        };
        made.map_err(|error| error.to_string())?;
        self.last_level = Some(name.clone());
        Ok(match make {
            Make::Rename(..) => Screen::LevelSelect(self.level_select(Purpose::Edit)),
            Make::New(_) | Make::Copy(..) => self.edit(name),
        })
    }

    /// Saves the level that is flown as it is varied, and says on the panel what became of that.
    pub(super) fn save_varied(&mut self, variation: &Variation, name: &str) {
        let saved = self.write_varied(variation, name);
        if let Screen::Flight(flight) = &mut self.screen {
            flight.tell_of_saving(saved);
        }
    }

    /// Writes a folder with the files of the level that is flown, in which other numbers stand; where it is, in words.
    fn write_varied(&mut self, variation: &Variation, name: &str) -> Result<String, String> {
        let Screen::Flight(flight) = &self.screen else { return Err("Nothing is flown.".to_owned()) };
        if self.editing.is_some() {
            return Err("What is edited is saved in the editor.".to_owned());
        }
        let level = flight.attempt().level.clone();
        let first = |problems: Vec<Problem>| problems.first().map_or_else(String::new, ToString::to_string);
        let wanted = variation.apply(&level).map_err(first)?;
        let levels = self.library.levels().to_path_buf();
        let name = if name.is_empty() { scaffold::free_name(&levels, &level.name, "what-if") } else { name.to_owned() };
        scaffold::judge(&levels, &name)?;
        let from = self.library.folder(&level.name);
        let Opened { mut document, folder, .. } = Folder::open(&from, self.library.root())?;
        document.vary(&wanted, &variation.parameters(), None)?;
        let loaded = folder.check(&document).map_err(first)?;
        if level_hash(&loaded.level) != level_hash(&wanted) {
            return Err("The level's files have changed since: R reads them.".to_owned());
        }
        document.set_setting("title", &format!("{}: what if", level.title), None)?;
        scaffold::copy_edited(&from, &levels, &name, &document).map_err(|error| error.to_string())?;
        let saved = format!("Saved as {}", levels.join(&name).display());
        self.last_level = Some(name);
        Ok(saved)
    }

    /// Flies what is edited, and tells of the problems that are left; the editor waits.
    pub(super) fn test_fly(&mut self, level: Arc<Level>, left: Vec<String>, spectator: &mut dyn Spectator) -> Screen {
        match Flight::test(level, left, spectator) {
            Ok(mut flight) => {
                flight.tell_of_settings(self.settings, &[]);
                let before = std::mem::replace(&mut self.screen, Screen::LevelSelect(LevelSelect::new(Purpose::Edit, Vec::new())));
                if let Screen::Editor(editor) = before {
                    self.editing = Some(editor);
                }
                Screen::Flight(Box::new(flight))
            }
            Err(error) => self.back_to_editor(error.to_string()),
        }
    }

    /// Back from the flight, with how it ended in words.
    pub(super) fn back_to_editor(&mut self, how: String) -> Screen {
        let before = std::mem::replace(&mut self.screen, Screen::LevelSelect(LevelSelect::new(Purpose::Edit, Vec::new())));
        let mut editor = match (self.editing.take(), before) {
            (Some(editor), _) | (None, Screen::Editor(editor)) => editor,
            (None, Screen::Flight(flight)) => return self.edit(&flight.game().level().name),
            (None, _) => return Screen::LevelSelect(self.level_select(Purpose::Edit)),
        };
        if !how.is_empty() {
            editor.tell_of_flight(how);
        }
        Screen::Editor(editor)
    }
}

impl Flight {
    /// How a test flight ended, in words; empty where it was broken off.
    pub(super) fn told(&self) -> String {
        let game = self.game();
        match game.outcome() {
            Outcome::Running => String::new(),
            Outcome::Completed => format!("Completed in {}, {:.0} % of the fuel left.", clock(game.time()), 100.0 * game.fuel()),
            Outcome::Failed => {
                let cause = game.result().death.map_or_else(String::new, |death| format!(": {death}"));
                format!("Lost after {}{cause}.", clock(game.time()))
            }
        }
    }
}
