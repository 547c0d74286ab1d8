//! The files behind the list of levels: how it opens, what it asks the worker for, and levels that are made, named and installed.

use super::card::LevelEntry;
use super::{Asked, LevelSelect};
use crate::import;
use crate::level::{self, Awards, scaffold};
use crate::pack::Installed;
use crate::screens::screen::{Destination, Effect, Make, Purpose, Request};
use crate::session::Session;
use crate::session::folder_watch::Stamp;
use crate::session::library::Refusal;
use crate::session::worker::{Brought, Card, Errand, Ticket};
use crate::ui::Ui;
use crate::ui::prompt::{Prompt, Reply};
use crate::words::tr;
use std::collections::btree_map::Entry as Slot;
use std::path::Path;

impl LevelSelect {
    pub fn open(purpose: Purpose, session: &mut Session) -> Self {
        session.library.close();
        let mut screen = Self::new(purpose, session.library.names(), |name| session.library.landscape(name));
        if let Some(name) = &session.last_level {
            screen.turn_to_level(name);
        }
        screen
    }

    /// With a panel above it.
    pub fn with_panel(purpose: Purpose, heading: String, lines: Vec<String>, session: &mut Session) -> Self {
        let mut screen = Self::open(purpose, session);
        screen.show_panel(heading, lines);
        screen
    }

    /// With what is wrong with one of the levels.
    pub fn refused(name: &str, refusal: Refusal, session: &mut Session) -> Self {
        let mut screen = Self::open(Purpose::Play, session);
        screen.show_problems(name, refusal);
        screen
    }

    /// With the question for the name of the copy of a level that comes with the game and is to be edited.
    pub fn asking_for_copy(name: &str, session: &mut Session) -> Self {
        let folder = session.library.folder(name);
        session.last_level = Some(name.to_owned());
        let free = scaffold::free_name(session.library.levels(), name, "copy");
        let mut screen = Self::open(Purpose::Edit, session);
        screen.ask_for_copy(name, folder, &free);
        screen
    }

    /// Installs an archive or a map of Tiled, and says what became of it.
    pub fn installed(path: &Path, session: &mut Session) -> Self {
        let installed = match session.brought.take() {
            Some(Brought::Installed(installed)) => installed,
            _ => import::take_in(path, session.library.levels(), session.library.root()),
        };
        let (heading, lines) = match installed {
            Ok((Installed::New(folder), said)) => {
                session.last_level = folder.file_name().map(|name| name.to_string_lossy().into_owned());
                (
                    tr!("Installed: {level}", level = session.last_level.as_deref().unwrap_or_default()),
                    [folder.display().to_string()].into_iter().chain(said).collect(),
                )
            }
            Ok((Installed::Already(folder, more), _)) => {
                session.last_level = folder.file_name().map(|name| name.to_string_lossy().into_owned());
                let beside = more.into_iter().map(|file| tr!("also in its folder: {file}", file));
                (tr("This level is there already").to_owned(), [folder.display().to_string()].into_iter().chain(beside).collect())
            }
            Err(problems) => (tr("This file cannot be opened").to_owned(), problems),
        };
        Self::with_panel(Purpose::Play, heading, lines, session)
    }

    /// Asks for the cards in view that the list does not know yet.
    pub(super) fn ask_for_cards(&mut self, session: &mut Session) {
        self.learn_titles(|name| session.library.title(name));
        let in_view = self.in_view().into_iter().map(|index| &self.entries()[index]);
        let new: Vec<String> = in_view.filter(|entry| entry.level.is_none()).map(|entry| entry.name.clone()).collect();
        new.iter().for_each(|name| self.ask_for_card(name, session));
    }

    /// Looks whether the levels in view have changed on disk, and whether there are others.
    pub(super) fn look_at_files(&mut self, frame_time: f64, session: &mut Session) {
        if !self.looks(frame_time) {
            return;
        }
        let in_view = self.in_view().into_iter().map(|index| &self.entries()[index]);
        let changed = in_view.filter(|entry| entry.stamp != Stamp::of(&session.library.folder(&entry.name), &[]));
        let changed: Vec<String> = changed.map(|entry| entry.name.clone()).collect();
        changed.iter().for_each(|name| self.ask_for_card(name, session));
        if let Slot::Vacant(slot) = self.asked.entry(String::new()) {
            slot.insert(session.worker.ask(Errand::List(session.library.levels().to_path_buf())));
        }
    }

    fn ask_for_card(&mut self, name: &str, session: &mut Session) {
        if let Slot::Vacant(slot) = self.asked.entry(name.to_owned()) {
            let root = session.library.root().to_path_buf();
            slot.insert(session.worker.ask(Errand::Card(session.library.folder(name), root)));
        }
    }

    /// Shows a level's card that the worker has brought.
    pub(super) fn take_card(&mut self, ticket: Ticket, card: Card, session: &Session) {
        self.asked.retain(|_, asked| *asked != ticket);
        let Card { folder, stamp, level, proven } = card;
        let name = folder.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let Some(index) = self.entries().iter().position(|entry| entry.name == name) else { return };
        let best = session.journal.best(&name);
        let awards = level.as_ref().map_or_else(|_| Awards::default(), |(_, awards, _)| *awards);
        let medals = session.journal.medals(&name).with_best(&awards, best);
        let title = level.as_ref().ok().map(|(title, ..)| title.clone());
        let level = Some(level.map(|(title, _, painting)| (title, painting)));
        self.set_entry(index, LevelEntry { level, stamp, title, best, awards, medals, proven, ..LevelEntry::new(name, None) });
    }
}

impl LevelSelect {
    pub(super) fn show_prompt(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        let (prompt, asked) = &mut **self.prompt.as_mut()?;
        match prompt.show(ui)? {
            Reply::Cancel => {
                if matches!(asked, Asked::OwnCopy(_)) {
                    return Some(Request::Pop);
                }
                self.prompt = None;
                None
            }
            Reply::Text(path) if matches!(asked, Asked::Import) => Some(Request::Reset(Destination::Dropped(path.into()))),
            Reply::Text(name) => Some(Request::Do(Effect::Make(match asked.clone() {
                Asked::New | Asked::Import => Make::New(name),
                Asked::Copy(from) => Make::Copy(from, name),
                Asked::OwnCopy(folder) => Make::CopyOf(folder, name),
                Asked::Rename(from) => Make::Rename(from, name),
            }))),
        }
    }

    pub(super) fn ask(&mut self, heading: String, text: &str, asked: Asked) {
        self.prompt = Some(Box::new((Prompt::new(heading, text), asked)));
    }
}

/// Makes or names a level's folder.
///
/// # Errors
/// The reason, in words.
pub(super) fn make(make: &Make, session: &mut Session) -> Result<(), String> {
    let levels = session.library.levels().to_path_buf();
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
    session.last_level = Some(name.clone());
    Ok(())
}
