//! The buttons at the foot of the list, and what an author does there with a level: share it, put it away, take it back, see its folder.

use super::places::{FOOT, FOOT_BUTTON, SIDE, from_left, from_right};
use super::{Asked, LevelSelect, PickFor};
use crate::draw::Style;
use crate::draw::layout::{Frame, GAP, ROW_BUTTON, TEXT, Vec2};
use crate::files;
use crate::level::{self, scaffold};
use crate::pack;
use crate::screens::screen::{OnLevel, Purpose, Request};
use crate::session::Session;
use crate::session::library::NewFile;
use crate::settings::Key;
use crate::ui::Ui;
use crate::view::{theme, widgets};
use crate::words::tr;
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
    /// The frame above the author's second row of buttons.
    pub(super) fn frame(&self, whole: &Frame) -> Frame {
        let row = if self.purpose == Purpose::Edit { ROW_BUTTON.y + GAP / 2.0 } else { 0.0 };
        Frame { size: whole.size - Vec2::new(0.0, row), ..*whole }
    }

    pub(super) fn show_foot(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        let frame = ui.frame();
        let above = self.frame(&frame);
        let mut pressed = None;
        let row = |labels: &[&str], frame: &Frame| (0..labels.len()).map(|i| from_left(i as f32, frame)).collect();
        let labels: &[&str] = match self.purpose {
            Purpose::Edit => {
                pressed = ui.buttons(row(ON_LEVELS, &above), ON_LEVELS);
                &["Back", "New", "Copy", "Rename"]
            }
            Purpose::Play | Purpose::Leaderboard => &["Back"],
        };
        pressed = pressed.or(ui.buttons(row(labels, &frame), labels));
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
            Some("Copy") => self.pick = Some(PickFor::Copy),
            Some("Rename") => self.pick = Some(PickFor::Rename),
            Some("Share") => self.pick = Some(PickFor::Share),
            Some("Delete") => self.pick = Some(PickFor::Bin),
            Some("Open folder") => self.pick = Some(PickFor::Folder),
            Some("Import") => self.ask_for_file(),
            _ => {}
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

    /// Whether the level that went to the bin last is wanted back.
    pub(super) fn takes_back(&self, ui: &Ui<'_>) -> bool {
        !self.binned.is_empty() && ui.key(Key::Z) && ui.input().held(Key::Control)
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
        self.renew(session.library.names(), |name| session.library.landscape(name));
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

/// Writes a level as one file; the answer is where.
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

/// Moves a level's folder into the bin; the answer is where.
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
