//! The files behind the list of levels: how it opens, what it asks the worker for, and levels that are made, named and installed. The buttons at the
//! foot of the list, and what an author does there with a level: share it, put it away, take it back, see its folder.

use super::shelves::{FOOT, FOOT_BUTTON, SIDE, from_left, from_right};
use super::{Asked, LevelSelect, card::LevelEntry};
use crate::draw::layout::{Area, Frame, GAP, ROW_BUTTON, TEXT, Vec2};
use crate::level::{self, Awards, scaffold};
use crate::pack::{self, Installed};
use crate::screens::screen::{Destination, Effect, Make, OnLevel, Purpose, Request};
use crate::session::worker::{Brought, Card, Errand, Ticket};
use crate::{draw::Style, files, import, settings::Key, ui::Ui, view::theme, view::widgets, words::tr};
use crate::{session::Session, session::library::NewFile, session::library::Refusal, ui::prompt::Prompt, ui::prompt::Reply};
use std::collections::btree_map::Entry as Slot;
use std::path::{Path, PathBuf};

/// Where shared levels and those that were put away are, from the project's root.
const SHARED: &str = "exports";
const BIN: &str = "bin";

/// Without a folder that a player could open there are only the first three.
const ON_LEVELS: &[&str] = if cfg!(all(feature = "window", browser)) {
    &["Share", "Import", "Delete"]
} else {
    &["Share", "Import", "Delete", "Open folder"]
};

impl LevelSelect {
    pub fn with_panel(purpose: Purpose, heading: String, lines: Vec<String>, session: &mut Session) -> Self {
        let mut screen = Self::open(purpose, session);
        screen.show_panel(heading, lines);
        screen
    }

    /// With what is wrong with one of the levels.
    pub fn refused(name: &str, refusal: Refusal, session: &mut Session) -> Self {
        let mut screen = Self::open(Purpose::Play, session);
        screen.turn_to_level(name);
        screen.show_panel(tr!("Level {name} does not load", name), refusal);
        screen
    }

    pub fn asking_for_copy(name: &str, session: &mut Session) -> Self {
        let folder = session.library.folder(name);
        session.last_level = Some(name.to_owned());
        let free = scaffold::free_name(session.library.levels(), name, "copy");
        let mut screen = Self::open(Purpose::Edit, session);
        let note = tr!("{name} comes with the game and stays as it is.", name);
        let prompt = Prompt::new(tr!("What is your copy of {name} called?", name), &free, Some(note));
        screen.prompt = Some(Box::new((prompt, Asked::OwnCopy(folder))));
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

    pub(super) fn ask_for_card(&mut self, name: &str, session: &mut Session) {
        if let Slot::Vacant(slot) = self.asked.entry(name.to_owned()) {
            let root = session.library.root().to_path_buf();
            slot.insert(session.worker.ask(Errand::Card(session.library.folder(name), root)));
        }
    }

    pub(super) fn take_card(&mut self, ticket: Ticket, card: Card, session: &Session) {
        self.asked.retain(|_, asked| *asked != ticket);
        let Card { folder, stamp, level, proven } = card;
        let name = folder.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let Some(index) = self.entries.iter().position(|entry| entry.name == name) else { return };
        let best = session.journal.best(&name);
        let awards = level.as_ref().map_or_else(|_| Awards::default(), |(_, awards, _)| *awards);
        let medals = session.journal.medals(&name).with_best(&awards, best);
        let title = level.as_ref().ok().map(|(title, ..)| title.clone());
        let level = Some(level.map(|(title, _, painting)| (title, painting)));
        let world = self.entries[index].world;
        self.entries[index] = LevelEntry { name, world, level, stamp, title, best, awards, medals, proven };
    }

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
        self.prompt = Some(Box::new((Prompt::new(heading, text, None), asked)));
    }

    /// The frame above the author's second row of buttons.
    pub(super) fn frame(&self, whole: &Frame) -> Frame {
        let row = if self.purpose == Purpose::Edit { ROW_BUTTON.y + GAP / 2.0 } else { 0.0 };
        Frame { size: whole.size - Vec2::new(0.0, row), ..*whole }
    }

    pub(super) fn show_foot(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        let frame = ui.frame();
        let above = self.frame(&frame);
        let mut pressed = None;
        let row = |ui: &Ui<'_>, labels: &[&str], frame: &Frame| {
            let mut next = from_left(0.0, frame);
            let place = |label: &&str| {
                let area = Area { size: next.size.max(Vec2::new(ui.least_width(label), 0.0)), ..next };
                next.min.x = area.max().x + GAP;
                area
            };
            labels.iter().map(place).collect::<Vec<Area>>()
        };
        let labels: &[&str] = match self.purpose {
            Purpose::Edit => {
                pressed = ui.buttons(row(ui, ON_LEVELS, &above), ON_LEVELS);
                &["Back", "New", "Copy", "Rename"]
            }
            Purpose::Play | Purpose::Leaderboard => &["Back"],
        };
        pressed = pressed.or(ui.buttons(row(ui, labels, &frame), labels));
        let mut turned = None;
        if self.pages.len() > 1 {
            turned = ui.buttons(vec![from_right(1.0, &frame), from_right(0.0, &frame)], &["Previous", "Next"]);
            let at = Vec2::new(frame.size.x - SIDE - 2.0 * FOOT_BUTTON.x - 100.0, frame.size.y - FOOT - ROW_BUTTON.y / 2.0);
            let page = tr!("Page {page} of {pages}", page = self.page + 1, pages = self.pages.len());
            ui.text(&page, at, Style::new(TEXT, theme::quiet()).centred().middle());
        }
        if let Some((level, _)) = self.binned.last() {
            let words = tr!("{level} is in the bin: Ctrl Z brings it back.", level);
            let (style, room) = (Style::new(TEXT, theme::accent()).middle().right(), from_right(2.0, &above));
            let words = widgets::cut(ui.canvas(), &words, frame.size.x - SIDE - room.min.x, style);
            ui.text(&words, Vec2::new(frame.size.x - SIDE, room.centre().y), style);
        }
        if turned == Some("Next") || ui.key(Key::PageDown) {
            self.turn_to(self.page + 1, ui);
        } else if turned == Some("Previous") || ui.key(Key::PageUp) {
            self.turn_to(self.page.saturating_sub(1), ui);
        }
        match pressed {
            Some("Back") => return self.go_back(ui),
            Some("New") => self.ask(tr("What is the new level called?").to_owned(), "", Asked::New),
            Some("Import") => self.ask_for_file(),
            Some(label) => self.pick = Some(label),
            None => {}
        }
        None
    }

    #[cfg(not(all(feature = "window", browser)))]
    fn ask_for_file(&mut self) {
        self.ask(tr("Which file? Its path (.zip, .tmj, .tmx), or drop it here.").to_owned(), "", Asked::Import);
    }

    /// The browser has a list of files of its own.
    #[cfg(all(feature = "window", browser))]
    fn ask_for_file(&mut self) {
        crate::web::choose_file();
    }

    /// Hands a level on, puts it away, takes one back or shows its folder; a panel says what a line cannot.
    pub(super) fn hand_on(&mut self, deed: &OnLevel, session: &mut Session) {
        let done = match deed {
            OnLevel::Share(name) => share(name, session).map(|path| {
                let lines =
                    vec![path.display().to_string(), tr("Import, or a drop on the window, takes it in elsewhere.").to_owned()];
                self.show_panel(tr!("{name} is one file now", name), lines);
            }),
            OnLevel::Folder(name) => {
                let folder = session.library.folder(name);
                open_outside(&folder);
                self.show_panel(tr!("The folder of {name}", name), vec![folder.display().to_string()]);
                Ok(())
            }
            OnLevel::Bin(name) => put_away(name, session).map(|path| self.binned.push((name.clone(), path))),
            OnLevel::TakeBack => self.take_back(session),
        };
        if let Err(problems) = done {
            self.show_panel(tr("That cannot be done").to_owned(), problems);
        }
        self.renew(session.library.names(), &session.library);
    }

    fn take_back(&mut self, session: &mut Session) -> Result<(), Vec<String>> {
        let Some((name, path)) = self.binned.last().cloned() else { return Ok(()) };
        let levels = session.library.levels();
        // Another level may have its name by now.
        let name = free(levels, &name, "back");
        files::rename(&path, &levels.join(&name)).map_err(|error| vec![format!("{}: {error}", path.display())])?;
        self.binned.pop();
        session.last_level = Some(name);
        Ok(())
    }
}

/// Makes or names a level's folder.
/// Errors: the reason, in words.
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

fn share(name: &str, session: &Session) -> Result<PathBuf, Vec<String>> {
    let (package, _) = pack::gather(&session.library.folder(name), session.library.root())?;
    let bytes = pack::write(&package).map_err(|problem| vec![problem])?;
    let file = NewFile { stem: name.to_owned(), ending: ".zip", bytes, what: tr("the level"), same_up_to: pack::LARGEST };
    file.write(&session.places.root.join(SHARED)).map_err(|problem| vec![problem])
}

/// That name, or where it is taken, one with a word behind it.
fn free(folder: &Path, name: &str, word: &str) -> String {
    if scaffold::judge(folder, name).is_ok() { name.to_owned() } else { scaffold::free_name(folder, name, word) }
}

fn put_away(name: &str, session: &Session) -> Result<PathBuf, Vec<String>> {
    let (from, bin) = (session.library.levels().join(name), session.library.root().join(BIN));
    if level::is_shipped(&from) {
        return Err(vec![tr!("{name} comes with the game and stays as it is.", name)]);
    }
    let to = bin.join(free(&bin, name, "deleted"));
    let moved = files::make_folder(&bin).and_then(|()| files::rename(&from, &to));
    moved.map(|()| to).map_err(|error| vec![format!("{}: {error}", from.display())])
}

/// Lets the system show a folder. Where it has nothing for that, the panel says the path.
fn open_outside(folder: &Path) {
    let opener = match () {
        () if cfg!(windows) => "explorer",
        () if cfg!(target_os = "macos") => "open",
        () => "xdg-open",
    };
    let mut command = std::process::Command::new(opener);
    command.arg(folder).stdout(std::process::Stdio::null()).stderr(std::process::Stdio::null());
    let _ = std::thread::Builder::new().spawn(move || command.status().is_ok());
}
