//! Requests that wait for the worker: what a screen needs is read beside it, and it opens when that is there.

use crate::classics::jumper::scene::LEADERBOARD;
use crate::level;
use crate::screens::App;
use crate::screens::flight::Flight;
use crate::screens::menu::Menu;
use crate::screens::screen::{Make, Purpose, Request};
use crate::session::library::is_of_level;
use crate::session::recordings::FlightSource;
use crate::session::worker::{Brought, Errand, Ticket, Worker};
use crate::settings::Key;
use crate::ui::Spectator;
use crate::ui::input::Input;
use crate::words::tr;

/// A level in words.
fn named(name: &str) -> String {
    tr!("level {name}", name)
}

/// The panel that names the level appears after this time, s: a level that loads sooner opens without it.
const TOLD_AFTER: f64 = 0.25;

/// A request that waits for what it needs.
#[derive(Debug)]
pub(super) struct Loading {
    ticket: Ticket,
    request: Request,
    /// What it is, in words.
    what: String,
    /// s.
    since: f64,
}

impl App {
    /// What is to be read before a request is granted, with its name; `None` where that is nothing, or where nothing is there to be read.
    fn errand(&mut self, request: &Request) -> Option<(Errand, String)> {
        let root = self.library.root().to_path_buf();
        let of_level = |app: &Self, name: &str| (Errand::Level(app.library.folder(name), root.clone()), named(name));
        match request {
            Request::Play(name) => {
                self.library.close();
                Some(of_level(self, name))
            }
            Request::Restart => {
                let name = self.screen.get::<Flight>()?.attempt().level.name.clone();
                self.reads_again(&name).then(|| of_level(self, &name))
            }
            // Of a level that comes with the game a copy is made first.
            Request::Edit(name) if level::is_shipped(&self.library.folder(name)) => None,
            Request::Edit(name) | Request::EditOriginal(name) => {
                Some((Errand::Editor(self.library.folder(name), root), named(name)))
            }
            // What was just flown is there.
            Request::Watch(_, candidate) | Request::Keep(_, candidate) if candidate.source == FlightSource::Flown => None,
            Request::CopyCode(_, candidate) if candidate.source == FlightSource::Flown => None,
            Request::Flights(visit)
            | Request::Race(visit, _)
            | Request::Watch(visit, _)
            | Request::Keep(visit, _)
            | Request::CopyCode(visit, _)
            | Request::PasteCode(visit, _) => Some(of_level(self, &visit.level)),
            Request::Leaderboard(name) if name != LEADERBOARD => Some(of_level(self, name)),
            Request::Experiment(name) => {
                let name = self.library.open(&self.library.experiment(name))?;
                Some(of_level(self, &name))
            }
            Request::Open(path) if is_of_level(path) => {
                let name = self.library.open(path)?;
                Some(of_level(self, &name))
            }
            Request::Open(path) => {
                let (archive, levels) = (path.clone(), self.library.levels().to_path_buf());
                let what = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
                Some((Errand::Install { archive, levels, root }, what))
            }
            _ => None,
        }
    }

    /// Goes to the screen that is asked for, or to one that says why it cannot be had: as soon as what it needs is read.
    pub fn grant(&mut self, request: Request, spectator: &mut dyn Spectator) {
        self.stop_loading();
        match self.errand(&request) {
            None => self.enter(request, spectator),
            Some((errand, what)) => {
                let ticket = self.worker.ask(errand);
                self.loading = Some(Loading { ticket, request, what, since: 0.0 });
                self.take_what_is_brought(spectator);
            }
        }
    }

    /// Takes over what the worker has brought.
    pub(super) fn take_what_is_brought(&mut self, spectator: &mut dyn Spectator) {
        while let Some((ticket, brought)) = self.worker.bring() {
            let awaited = self.loading.take_if(|loading| loading.ticket == ticket);
            match (brought, awaited) {
                (Brought::Level(folder, level), None) => {
                    if self.reading.take_if(|reading| *reading == ticket).is_some() {
                        self.take_over(&folder, level, spectator);
                    }
                }
                (Brought::Card(card), _) => self.take_card(ticket, *card),
                (Brought::List(names), _) => self.take_list(names),
                (Brought::First(next, gold), _) => {
                    if let Some(menu) = self.screen.get_mut::<Menu>() {
                        menu.tell_next(next);
                        if let Some(gold) = gold {
                            menu.show_behind(Flight::watch(String::new(), *gold, Request::Menu, spectator));
                        }
                    }
                }
                // Nobody waits for it any more.
                (_, None) => {}
                (brought, Some(loading)) => {
                    match brought {
                        Brought::Level(folder, level) => self.library.prepare(folder, level),
                        Brought::Editor(editor) => self.opened = Some(editor),
                        Brought::Installed(installed) => self.installed = Some(installed),
                        Brought::Card(_) | Brought::List(_) | Brought::First(..) => {}
                    }
                    self.enter(loading.request, spectator);
                    self.library.forget_prepared();
                    (self.opened, self.installed) = (None, None);
                }
            }
        }
    }

    /// One frame in which a request waits: Esc takes it back. What is left of the input for the screen.
    pub(super) fn wait_for_loading(&mut self, input: &Input) -> Option<Input> {
        let loading = self.loading.as_mut()?;
        loading.since += input.frame_time;
        if input.pressed(Key::Escape) {
            self.stop_loading();
        }
        // The screen below goes on by itself, and takes no key or click.
        Some(Input { frame_time: input.frame_time, ..input.without_edges() })
    }

    fn stop_loading(&mut self) {
        if let Some(loading) = self.loading.take() {
            self.worker.forget(loading.ticket);
        }
    }

    /// What is loading, once that takes longer than a moment.
    pub fn loading(&self) -> Option<&str> {
        self.loading.as_ref().filter(|loading| loading.since > TOLD_AFTER).map(|loading| loading.what.as_str())
    }

    /// Whether a request waits for the worker.
    pub const fn is_loading(&self) -> bool {
        self.loading.is_some()
    }

    /// The worker, for a test that goes by hand.
    pub const fn worker(&mut self) -> &mut Worker {
        &mut self.worker
    }

    /// Asks which level Play opens: the first that loads and that the player has not done, else the first that loads.
    pub(super) fn ask_for_next(&mut self) {
        let names = self.library.names();
        let (open, done): (Vec<&String>, Vec<&String>) = names.iter().partition(|name| self.journal.medals(name).medal.is_none());
        // Of a level that is not done a flight for gold would tell too much; but the first one has to begin somehow.
        let shown = done.get(self.menus as usize % done.len().max(1)).or(open.first()).map(|name| self.library.folder(name));
        let folders = open.into_iter().chain(done).map(|name| self.library.folder(name)).collect();
        let errand = Errand::First(folders, self.library.root().to_path_buf(), shown);
        self.worker.ask(errand);
    }

    /// Opens what was made in the list of levels.
    pub(super) fn after_making(&mut self, make: &Make, spectator: &mut dyn Spectator) {
        match make {
            Make::Rename(..) => {
                let screen = self.level_select(Purpose::Edit);
                self.show(Box::new(screen));
            }
            Make::New(name) | Make::Copy(_, name) | Make::CopyOf(_, name) => self.grant(Request::Edit(name.clone()), spectator),
        }
    }
}
