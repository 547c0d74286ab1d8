//! Levels' files while the app runs: it reads them again when they change, opens files that are dropped on the window, and makes, names and
//! edits levels.

use crate::files;
use crate::game::level_hash;
use crate::instruments::vary::Variation;
use crate::level::document::{LevelFolder, Opened};
use crate::level::{self, Awards, Level, Problem, scaffold};
use crate::screens::App;
use crate::screens::boards::flights::Flights;
use crate::screens::editor::Editor;
use crate::screens::flight::Flight;
use crate::screens::levels::{LevelEntry, LevelSelect};
use crate::screens::screen::{Make, Purpose, Request, Screen};
use crate::session::attempt::Attempt;
use crate::session::folder_watch::Stamp;
use crate::session::library::Refusal;
use crate::session::recordings;
use crate::session::worker::{Card, Errand, Ticket};
use crate::ui::Spectator;
use crate::words::tr;
use std::any::Any;
use std::collections::btree_map::Entry as Slot;
use std::path::Path;
use std::sync::Arc;

impl App {
    /// Begins with a level in any folder.
    pub fn begin(&mut self, folder: &Path, request: Request, spectator: &mut dyn Spectator) {
        self.library.open(folder);
        self.grant(request, spectator);
    }

    /// The screen itself, where it is of that type; an empty one stays in its place.
    fn take_screen<T: Screen>(&mut self) -> Option<Box<T>> {
        if !self.screen.is::<T>() {
            return None;
        }
        let screen: Box<dyn Screen> = std::mem::replace(&mut self.screen, Box::new(()));
        (screen as Box<dyn Any>).downcast().ok()
    }

    /// Grants a request about the making of levels; `None`: the screen stays.
    pub(super) fn begin_editing(&mut self, request: Request, spectator: &mut dyn Spectator) -> Option<Box<dyn Screen>> {
        Some(match request {
            Request::Edit(name) => self.edit_or_copy(&name),
            Request::EditOriginal(name) => self.edit(&name),
            Request::LeaveEditor => self.leave_editor(spectator),
            Request::TestFly(level, left) => self.test_fly(level, left, spectator),
            Request::BackToEditor(how) => self.back_to_editor(how),
            Request::SaveVaried(variation, name) => {
                self.save_varied(&variation, &name);
                return None;
            }
            Request::Make(make) => {
                match self.make(&make) {
                    Ok(()) => self.after_making(&make, spectator),
                    Err(reason) => {
                        if let Some(screen) = self.screen.get_mut::<LevelSelect>() {
                            screen.refuse(reason);
                        }
                    }
                }
                return None;
            }
            _ => return None,
        })
    }

    /// Has the level that is flown read again when its files have changed; a test flight's level is not on disk.
    pub(super) fn look_at_files(&mut self, frame_time: f64) {
        let (Some(flight), Some(watch), None) = (self.screen.get::<Flight>(), &mut self.watch, &self.editing) else { return };
        if flight.is_watched() || !watch.update(frame_time) || !files::is_folder(watch.folder()) {
            return;
        }
        let folder = self.library.folder(&flight.attempt().level.name);
        self.reading = Some(self.worker.ask(Errand::Level(folder, self.library.root().to_path_buf())));
    }

    /// Goes on with the flight in its level as that was read again.
    pub(super) fn take_over(&mut self, folder: &Path, level: Result<Arc<Level>, Refusal>, spectator: &mut dyn Spectator) {
        let (Some(flight), None) = (self.screen.get_mut::<Flight>(), &self.editing) else { return };
        let flown = flight.attempt().level.clone();
        if flight.is_watched() || self.library.folder(&flown.name) != folder {
            return;
        }
        match level {
            Ok(level) => {
                self.watch = Some(self.library.watch(&level));
                if *level == *flown {
                    // A comment or a picture has changed: the flight does not depend on it.
                    flight.tell_of_mending();
                    spectator.goes_on(flight.game());
                } else {
                    flight.take_over(level, spectator);
                }
            }
            Err(problems) => flight.tell_of_problems(problems),
        }
    }

    /// Whether a level is read again before it is flown once more: a test flight's level is in memory.
    pub(super) fn reads_again(&self, name: &str) -> bool {
        self.editing.is_none() && files::is_folder(&self.library.folder(name))
    }

    /// The attempt on the screen from its start, in the level as its files are now; where those do not load, as it was.
    pub(super) fn restart(&mut self, spectator: &mut dyn Spectator) {
        let Some(flight) = self.screen.get::<Flight>() else { return };
        if flight.is_given_up() {
            *self.losses.entry(flight.game().level().name.clone()).or_default() += 1;
        }
        let Attempt { level: flown, .. } = flight.attempt().clone();
        let on_disk = self.reads_again(&flown.name);
        let (level, problems) = match on_disk.then(|| self.library.load(&flown.name)) {
            Some(Ok(level)) => (level, None),
            Some(Err(problems)) => (flown, Some(problems)),
            None => (flown, None),
        };
        if on_disk {
            self.watch = Some(self.library.watch(&level));
        }
        let Some(flight) = self.screen.get_mut::<Flight>() else { return };
        if let Err(error) = flight.restart(level, spectator) {
            return flight.tell_of_problems(vec![error.to_string()]);
        }
        self.lost = self.ended.take();
        if let Some(problems) = problems {
            flight.tell_of_problems(problems);
        }
    }

    /// Flies the level of a folder, or of a file in it, wherever that is; or the list of levels, with why it cannot be flown.
    pub(super) fn open_folder(&mut self, path: &Path, spectator: &mut dyn Spectator) -> Box<dyn Screen> {
        let loaded = match self.library.open(path) {
            Some(name) => self.library.load(&name).map_err(|refusal| (tr!("Level {name} does not load", name), refusal)),
            None => Err((tr("There is no such level").to_owned(), vec![path.display().to_string()])),
        };
        match loaded {
            Ok(level) => self.flight(Attempt::by_hand(level), spectator),
            Err((heading, problems)) => {
                let mut screen = self.level_select(Purpose::Play);
                screen.show(heading, problems);
                Box::new(screen)
            }
        }
    }

    /// Asks for the cards in view that the list does not know yet, and looks up how long one of the listed flights took.
    pub(super) fn fill_in_view(&mut self) {
        if let Some(screen) = self.screen.get_mut::<Flights>() {
            // One file is enough for a frame.
            screen.look_one_up(|visit, source| recordings::read(visit, source, &self.scores).ok());
        }
        let Some(screen) = self.screen.get_mut::<LevelSelect>() else { return };
        screen.learn_titles(|name| self.library.title(name));
        let in_view = screen.in_view().into_iter().map(|index| &screen.entries()[index]);
        let new: Vec<String> = in_view.filter(|entry| entry.level.is_none()).map(|entry| entry.name.clone()).collect();
        new.iter().for_each(|name| self.ask_for_card(name));
    }

    /// Looks whether the levels in view have changed on disk, and whether there are others.
    pub(super) fn refresh_view(&mut self, frame_time: f64) {
        let Some(screen) = self.screen.get_mut::<LevelSelect>() else { return };
        if !screen.looks(frame_time) {
            return;
        }
        let in_view = screen.in_view().into_iter().map(|index| &screen.entries()[index]);
        let changed = in_view.filter(|entry| entry.stamp != Stamp::of(&self.library.folder(&entry.name), &[]));
        let changed: Vec<String> = changed.map(|entry| entry.name.clone()).collect();
        changed.iter().for_each(|name| self.ask_for_card(name));
        if let Slot::Vacant(slot) = self.asked.entry(String::new()) {
            slot.insert(self.worker.ask(Errand::List(self.library.levels().to_path_buf())));
        }
    }

    fn ask_for_card(&mut self, name: &str) {
        if let Slot::Vacant(slot) = self.asked.entry(name.to_owned()) {
            slot.insert(self.worker.ask(Errand::Card(self.library.folder(name), self.library.root().to_path_buf())));
        }
    }

    /// Shows a level's card that the worker has brought.
    pub(super) fn take_card(&mut self, ticket: Ticket, card: Card) {
        self.asked.retain(|_, asked| *asked != ticket);
        let Some(screen) = self.screen.get_mut::<LevelSelect>() else { return };
        let Card { folder, stamp, level } = card;
        let name = folder.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let Some(index) = screen.entries().iter().position(|entry| entry.name == name) else { return };
        let best = self.journal.best(&name);
        let awards = level.as_ref().map_or_else(|_| Awards::default(), |(_, awards, _)| *awards);
        let medals = self.journal.medals(&name).with_best(&awards, best);
        let title = level.as_ref().ok().map(|(title, ..)| title.clone());
        let level = Some(level.map(|(title, _, miniature)| (title, miniature)));
        screen.tell(index, LevelEntry { level, stamp, title, best, awards, medals, ..LevelEntry::new(name, None) });
    }

    /// Shows the names of levels that the worker has brought.
    pub(super) fn take_list(&mut self, names: Vec<String>) {
        self.asked.remove("");
        if let Some(screen) = self.screen.get_mut::<LevelSelect>() {
            screen.renew(names, |name| self.library.landscape(name));
        }
    }

    /// The editor of a level; of one that comes with the game, the list with the question for a copy's name. A flight waits.
    pub(super) fn edit_or_copy(&mut self, name: &str) -> Box<dyn Screen> {
        let folder = self.library.folder(name);
        self.keep_sheet();
        if let Some(flight) = self.take_screen::<Flight>() {
            self.behind = Some((flight, folder.clone()));
        }
        if !level::is_shipped(&folder) {
            return self.edit(name);
        }
        self.last_level = Some(name.to_owned());
        let free = scaffold::free_name(self.library.levels(), name, "copy");
        let mut screen = self.level_select(Purpose::Edit);
        screen.ask_for_copy(name, folder, &free);
        Box::new(screen)
    }

    /// Back to the flight that editing began from, in the level as it is saved now; else to the list.
    pub(super) fn leave_editor(&mut self, spectator: &mut dyn Spectator) -> Box<dyn Screen> {
        let Some((mut flight, folder)) = self.behind.take() else { return Box::new(self.level_select(Purpose::Edit)) };
        self.library.open(&folder);
        self.last_level = Some(flight.game().level().name.clone());
        spectator.begins(flight.game());
        self.give_sheet(&mut flight);
        flight
    }

    /// The editor of a level, or the list with the problem.
    pub(super) fn edit(&mut self, name: &str) -> Box<dyn Screen> {
        self.last_level = Some(name.to_owned());
        let opened = self.opened.take();
        match opened.unwrap_or_else(|| LevelFolder::open_to_edit(&self.library.folder(name), self.library.root()).map(Box::new)) {
            Ok(opened) => Box::new(Editor::new(*opened)),
            Err(problem) => {
                let mut screen = self.level_select(Purpose::Edit);
                screen.show(tr!("Level {name} cannot be edited", name), vec![problem]);
                Box::new(screen)
            }
        }
    }

    /// Makes or names a level's folder.
    ///
    /// # Errors
    /// The reason, in words.
    pub(super) fn make(&mut self, make: &Make) -> Result<(), String> {
        let levels = self.library.levels().to_path_buf();
        let (Make::New(name) | Make::Copy(_, name) | Make::CopyOf(_, name) | Make::Rename(_, name)) = make;
        scaffold::judge(&levels, name)?;
        if let Make::Rename(from, _) = make
            && level::is_shipped(&levels.join(from))
        {
            return Err(tr!("{from} comes with the game and keeps its name: make a copy.", from));
        }
        let made = match make {
            Make::New(_) => scaffold::make(&levels, name, &scaffold::BARE),
            Make::Copy(from, _) => scaffold::copy(&levels.join(from), &levels, name),
            Make::CopyOf(folder, _) => scaffold::copy(folder, &levels, name),
            Make::Rename(from, _) => scaffold::rename(&levels, from, name),
        };
        made.map_err(|error| error.to_string())?;
        self.last_level = Some(name.clone());
        Ok(())
    }

    /// Saves the level that is flown as it is varied, and shows on the panel where, or why not.
    pub(super) fn save_varied(&mut self, variation: &Variation, name: &str) {
        let saved = self.write_varied(variation, name);
        if let Some(flight) = self.screen.get_mut::<Flight>() {
            flight.tell_of_saving(saved);
        }
    }

    /// Writes a folder with the files of the level that is flown and the varied numbers in them; its place, in words.
    fn write_varied(&mut self, variation: &Variation, name: &str) -> Result<String, String> {
        let Some(flight) = self.screen.get::<Flight>() else { return Err(tr("Nothing is flown.").to_owned()) };
        if self.editing.is_some() {
            return Err(tr("An edited level is saved in the editor.").to_owned());
        }
        let level = flight.attempt().level.clone();
        let first = |problems: Vec<Problem>| problems.first().map_or_else(String::new, ToString::to_string);
        let wanted = variation.apply(&level).map_err(first)?;
        let levels = self.library.levels().to_path_buf();
        let name = if name.is_empty() { scaffold::free_name(&levels, &level.name, "what-if") } else { name.to_owned() };
        scaffold::judge(&levels, &name)?;
        let from = self.library.folder(&level.name);
        let Opened { mut document, folder, .. } = LevelFolder::open(&from, self.library.root())?;
        document.vary(&wanted, &variation.parameters(), None)?;
        let loaded = folder.check(&document).map_err(first)?;
        if level_hash(&loaded.level) != level_hash(&wanted) {
            return Err(tr("The level's files have changed since: R reads them.").to_owned());
        }
        document.set_setting("title", &tr!("{title}: what if", title = level.title), None)?;
        scaffold::copy_edited(&from, &levels, &name, &document).map_err(|error| error.to_string())?;
        let saved = tr!("Saved as {path}", path = levels.join(&name).display());
        self.last_level = Some(name);
        Ok(saved)
    }

    /// Flies the level of the editor, which waits, and shows the problems that are left.
    pub(super) fn test_fly(&mut self, level: Arc<Level>, left: Vec<String>, spectator: &mut dyn Spectator) -> Box<dyn Screen> {
        match Flight::test(level, left, spectator) {
            Ok(mut flight) => {
                flight.tell_of_settings(&self.settings, &[]);
                if let Some(editor) = self.take_screen::<Editor>() {
                    self.editing = Some(editor);
                }
                Box::new(flight)
            }
            Err(error) => self.back_to_editor(error.to_string()),
        }
    }

    /// Back from the flight, with how it ended in words.
    pub(super) fn back_to_editor(&mut self, how: String) -> Box<dyn Screen> {
        let Some(mut editor) = self.editing.take().or_else(|| self.take_screen::<Editor>()) else {
            let flown = self.screen.get::<Flight>().map(|flight| flight.game().level().name.clone());
            return match flown {
                Some(name) => self.edit(&name),
                None => Box::new(self.level_select(Purpose::Edit)),
            };
        };
        if !how.is_empty() {
            editor.tell_of_flight(how);
        }
        editor
    }
}
