//! The one place where screens change: every [`Request`] is granted here, and what can fail in granting it lands on a screen that
//! says why.

use crate::pack::{self, Installed};
use crate::screens::App;
use crate::screens::classics::Classics;
use crate::screens::classics::jumper::Jumper;
use crate::screens::classics::pi::Pi;
use crate::screens::classics::tile_run::TileRun;
use crate::screens::flight::Flight;
use crate::screens::lab::Lab;
use crate::screens::levels::LevelSelect;
use crate::screens::menu::credits::Credits;
use crate::screens::players::PlayerList;
use crate::screens::screen::{Classic, Purpose, Request, Screen};
use crate::screens::settings::SettingsPanel;
use crate::session::attempt::Attempt;
use crate::session::library::{Refusal, is_of_level};
use crate::ui::Spectator;
use crate::words::tr;
use std::path::Path;

impl App {
    /// Goes to the screen that is asked for, or to one that says why it cannot be had, with what the worker has brought for it.
    pub(super) fn enter(&mut self, request: Request, spectator: &mut dyn Spectator) {
        if let Some(next) = self.opened_by(request, spectator) {
            self.show(next);
        }
    }

    /// The screen that a request opens; `None`: the present one stays.
    fn opened_by(&mut self, request: Request, spectator: &mut dyn Spectator) -> Option<Box<dyn Screen>> {
        Some(match request {
            Request::Menu => self.menu(),
            Request::LevelSelect(purpose) => Box::new(self.level_select(purpose)),
            Request::Play(name) => {
                self.library.close();
                match self.library.load(&name) {
                    Ok(level) => self.flight(Attempt::by_hand(level), spectator),
                    Err(refusal) => self.refused(Purpose::Play, &name, refusal),
                }
            }
            Request::Restart => {
                self.restart(spectator);
                return None;
            }
            Request::Attempt(attempt) => self.flight(attempt, spectator),
            Request::Score(attempt, result, flown) => self.scoring(attempt, result, flown),
            Request::Export(_) | Request::HandIn(_) | Request::Set(_) => {
                self.write_down(request);
                return None;
            }
            Request::SaveScore(gain) => self.save_score(gain),
            Request::Submit(gain, name) => return self.submit(gain, name).map_err(|reason| self.refuse(reason)).ok(),
            Request::Players => self.players(),
            Request::Choose(name, named) => {
                self.choose(name, named);
                self.menu()
            }
            Request::Credits => Box::new(Credits::default()),
            Request::Leaderboard(level) => self.leaderboard(&level),
            Request::Classics(left) => Box::new(Classics::new(left, None)),
            Request::Lab => self.lab(None),
            Request::Experiments(left) => self.lab(Some(&left)),
            Request::Experiment(name) => {
                let folder = self.library.experiment(&name);
                self.open_folder(&folder, spectator)
            }
            Request::Classic(classic) => self.classic(classic),
            Request::Climbed(scene) => Box::new(Jumper::ended(*scene)),
            Request::Settings => Box::new(SettingsPanel::new(self.settings, self.settings_problems.clone())),
            Request::Open(path) => self.open(&path, spectator),
            #[cfg(all(feature = "window", browser))]
            Request::PageData => Box::new(super::page_data::PageData::default()),
            Request::Stay => {
                self.stay();
                return None;
            }
            Request::Quit | Request::QuitAnyway => return None,
            Request::Flights(_)
            | Request::Watch(..)
            | Request::Race(..)
            | Request::Keep(..)
            | Request::CopyCode(..)
            | Request::PasteCode(..) => {
                return self.visit(request, spectator);
            }
            request => return self.begin_editing(request, spectator),
        })
    }

    /// Grants what is written to a file while the screen stays.
    fn write_down(&mut self, request: Request) {
        match request {
            Request::Export(file) => {
                let told = file.write(&self.places.root.join("exports"));
                self.screen.report_export(told);
            }
            Request::HandIn(row) => self.hand_in(row),
            Request::Set(settings) => self.set(settings),
            _ => {}
        }
    }

    fn players(&mut self) -> Box<dyn Screen> {
        self.journal.read();
        let trouble = self.journal.trouble().map(str::to_owned);
        Box::new(PlayerList::new(self.journal.players(), self.journal.current(), trouble))
    }

    pub(super) fn level_select(&mut self, purpose: Purpose) -> LevelSelect {
        self.library.close();
        let mut screen = LevelSelect::new(purpose, self.library.names(), |name| self.library.landscape(name));
        if let Some(name) = &self.last_level {
            screen.turn_to_level(name);
        }
        screen
    }

    pub(super) fn flight(&mut self, attempt: Attempt, spectator: &mut dyn Spectator) -> Box<dyn Screen> {
        let name = attempt.level.name.clone();
        self.last_level = Some(name.clone());
        (self.ended, self.behind) = (None, None);
        self.watch = Some(self.library.watch(&attempt.level));
        match Flight::new(attempt, spectator) {
            Ok(mut flight) => {
                flight.tell_of_settings(&self.settings, &self.settings_problems);
                self.give_sheet(&mut flight);
                Box::new(flight)
            }
            Err(error) => self.refused(Purpose::Play, &name, vec![error.to_string()]),
        }
    }

    /// The list of levels with what is wrong with one of them.
    pub(super) fn refused(&mut self, purpose: Purpose, name: &str, refusal: Refusal) -> Box<dyn Screen> {
        let mut screen = self.level_select(purpose);
        screen.show_problems(name, refusal);
        Box::new(screen)
    }

    /// The lab, on the page with an experiment that was left.
    fn lab(&mut self, left: Option<&str>) -> Box<dyn Screen> {
        Box::new(Lab::new(self.library.charts(), self.library.experiments(), left))
    }

    /// Opens what was dropped: an archive is installed, and the list of levels says what became of it; a level's folder, or a file of one,
    /// is flown where it is.
    fn open(&mut self, path: &Path, spectator: &mut dyn Spectator) -> Box<dyn Screen> {
        if is_of_level(path) {
            return self.open_folder(path, spectator);
        }
        let installed = self.installed.take();
        let (heading, lines) = match installed
            .unwrap_or_else(|| pack::install_file(path, self.library.levels(), self.library.root()))
        {
            Ok(Installed::New(folder)) => {
                self.last_level = folder.file_name().map(|name| name.to_string_lossy().into_owned());
                (
                    tr!("Installed: {level}", level = self.last_level.as_deref().unwrap_or_default()),
                    vec![folder.display().to_string()],
                )
            }
            Ok(Installed::Already(folder, more)) => {
                self.last_level = folder.file_name().map(|name| name.to_string_lossy().into_owned());
                let beside = more.into_iter().map(|file| tr!("also in its folder: {file}", file));
                (tr("This level is there already").to_owned(), [folder.display().to_string()].into_iter().chain(beside).collect())
            }
            Err(problems) => (tr("This file cannot be opened").to_owned(), problems),
        };
        let mut screen = self.level_select(Purpose::Play);
        screen.show(heading, lines);
        Box::new(screen)
    }

    /// A classic at its beginning, or the list of them with what is wrong.
    fn classic(&self, classic: Classic) -> Box<dyn Screen> {
        match classic {
            Classic::TileRun => match self.library.tile_run() {
                Ok((map, commands)) => Box::new(TileRun::new(map, commands)),
                Err(problem) => Box::new(Classics::new(Some(classic), Some(problem))),
            },
            Classic::Jumper => Box::new(Jumper::default()),
            Classic::Pi => Box::new(Pi::default()),
        }
    }
}
