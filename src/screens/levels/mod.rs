//! A page of cards, one a level, used three times: to choose what to play, whose leaderboard to see, and what to edit. Only the levels in
//! view are loaded, and again when their files change; typing finds those with such a name or title.

use crate::screens::screen::{Destination, Effect, Make, OnLevel, Purpose, Request, Screen};
use crate::session::worker::{Brought, Errand, Ticket};
use crate::session::{Session, folder_watch::Stamp, library::Library, recordings::Visit};
use crate::ui::{Spectator, Ui, WidgetKind, prompt::Problems, prompt::Prompt};
use crate::{draw::Style, draw::layout::TEXT, draw::layout::Vec2, settings::Action, settings::Key, view::theme, words::tr};
use shelves::{HEAD, SIDE};
use std::collections::{BTreeMap, BTreeSet, btree_map::Entry as Slot};
use std::{ops::Range, path::PathBuf};

mod card;
mod files;
mod shelves;

pub use card::LevelEntry;

/// How many titles are looked for in a frame while something is to be found: a few milliseconds' worth.
const TITLES_A_FRAME: usize = 100;
/// From one look at the files in view to the next, s.
const LOOK_EVERY: f64 = 0.5;
/// The most letters to find something by.
const MOST_LETTERS: usize = 40;

#[derive(Debug, Default)]
pub struct LevelSelect {
    pub purpose: Purpose,
    pub entries: Vec<LevelEntry>,
    /// What is to be found, and which entries that finds.
    find: String,
    found: Vec<usize>,
    pages: Vec<Vec<Range<usize>>>,
    page: usize,
    /// The level that has the focus when the page opens, and the one that has it now.
    start: Option<String>,
    focused: Option<String>,
    problems: Option<Problems>,
    /// The button that says what a level is to be chosen for, besides the list's own purpose.
    pick: Option<&'static str>,
    prompt: Option<Box<(Prompt, Asked)>>,
    /// Until the next look at files, s.
    look: f64,
    /// Levels that went to the bin, by their names, with the folders there, the last one last.
    binned: Vec<(String, PathBuf)>,
    /// What the worker is asked for, by the levels' names; the list has none.
    asked: BTreeMap<String, Ticket>,
}

#[derive(Clone, Debug)]
enum Asked {
    New,
    Copy(String),
    /// The same, of a level that comes with the game and was to be edited itself.
    OwnCopy(PathBuf),
    Rename(String),
    /// The path of a file with a level. A browser asks for that itself.
    #[cfg_attr(all(feature = "window", browser), allow(dead_code))]
    Import,
}

impl LevelSelect {
    pub fn open(purpose: Purpose, session: &mut Session) -> Self {
        session.library.close();
        let mut screen = Self { purpose, look: LOOK_EVERY, ..Self::default() };
        screen.renew(session.library.names(), &session.library);
        if let Some(name) = &session.last_level {
            screen.turn_to_level(name);
        }
        screen
    }

    /// Opens the page of a level, which has the focus then.
    pub fn turn_to_level(&mut self, name: &str) {
        if let Some(index) = self.found.iter().position(|index| self.entries[*index].name == name) {
            self.page = self.pages.iter().position(|page| page.iter().any(|shelf| shelf.contains(&index))).unwrap_or(0);
            self.start = Some(name.to_owned());
        }
    }

    pub fn show_panel(&mut self, heading: String, problems: Vec<String>) {
        self.problems = Some(Problems::new(heading, problems));
    }

    pub fn in_view(&self) -> Vec<usize> {
        let shelves = self.pages.get(self.page).map_or(&[][..], Vec::as_slice);
        shelves.iter().flat_map(|shelf| &self.found[shelf.clone()]).copied().collect()
    }

    /// Shows those levels instead; what is known of a level stays, and so does the focus on its card.
    pub fn renew(&mut self, names: Vec<String>, library: &Library) {
        let (new, old): (BTreeSet<&str>, BTreeSet<&str>) =
            (names.iter().map(String::as_str).collect(), self.entries.iter().map(|entry| entry.name.as_str()).collect());
        if !names.is_empty() && new == old {
            return;
        }
        let mut known: BTreeMap<String, LevelEntry> = self.entries.drain(..).map(|entry| (entry.name.clone(), entry)).collect();
        let new = |name: String| LevelEntry { world: library.landscape(&name), name, ..LevelEntry::default() };
        let entry = |name: String| known.remove(&name).unwrap_or_else(|| new(name));
        self.entries = names.into_iter().map(entry).collect();
        if self.purpose == Purpose::Edit {
            // An author's own levels stand first.
            self.entries.sort_by_key(|entry| entry.world.is_some());
        }
        self.search();
        if let Some(name) = self.focused.clone() {
            self.turn_to_level(&name);
        }
    }

    fn visit(&self, index: usize) -> Option<Request> {
        let LevelEntry { name, level, .. } = &self.entries[index];
        let loads = level.as_ref().is_some_and(Result::is_ok) && self.purpose != Purpose::Edit;
        loads.then(|| Request::Push(Destination::Flights(Visit::of(name))))
    }

    /// Esc: out of what was begun last.
    fn go_back(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        if !self.find.is_empty() {
            self.find.clear();
            self.search_again(ui);
            return None;
        }
        if self.pick.take().is_some() {
            return None;
        }
        Some(Request::Pop)
    }

    fn choose(&mut self, index: usize) -> Option<Request> {
        let name = self.entries[index].name.clone();
        match (self.purpose, self.pick.take()) {
            (_, Some("Copy")) => {
                self.ask(tr!("What is the copy of {name} called?", name), &format!("{name}-copy"), Asked::Copy(name));
                None
            }
            (_, Some("Rename")) => {
                self.ask(tr!("What is {name} called from now on?", name), &name.clone(), Asked::Rename(name));
                None
            }
            (_, Some("Share")) => Some(Request::Do(Effect::OnLevel(OnLevel::Share(name)))),
            (_, Some("Delete")) => Some(Request::Do(Effect::OnLevel(OnLevel::Bin(name)))),
            (_, Some(_)) => Some(Request::Do(Effect::OnLevel(OnLevel::Folder(name)))),
            // Whether it loads is found out afresh: it may have been mended since.
            (Purpose::Play, None) => Some(Request::Reset(Destination::Play(name))),
            (Purpose::Leaderboard, None) => Some(Request::Reset(Destination::Board(Visit::of(&name)))),
            (Purpose::Edit, None) => Some(Request::Reset(Destination::Edit { name, original: false })),
        }
    }

    fn turn_to(&mut self, page: usize, ui: &mut Ui<'_>) {
        if page < self.pages.len() && page != self.page {
            self.page = page;
            self.start = None;
            ui.focus(None);
        }
    }

    fn show_heading(&self, ui: &Ui<'_>) {
        let heading = match (self.purpose, self.pick) {
            (_, Some("Copy")) => tr("Which level is to be copied?"),
            (_, Some("Rename")) => tr("Which level is to be renamed?"),
            (_, Some("Share")) => tr("Which level is to be shared?"),
            (_, Some("Delete")) => tr("Which level is to be deleted?"),
            (_, Some(_)) => tr("Which level's folder?"),
            (Purpose::Play, None) => tr("Choose a level"),
            (Purpose::Leaderboard, None) => tr("Whose leaderboard?"),
            (Purpose::Edit, None) => tr("Edit a level"),
        };
        ui.page(heading, HEAD / 2.0);
        let (found, colour) = match self.find.as_str() {
            "" => (tr("type to find one").to_owned(), theme::quiet()),
            find => (tr!("find: {find}_", find), theme::accent()),
        };
        ui.text(&found, Vec2::new(ui.frame().size.x - SIDE, HEAD / 2.0), Style::new(TEXT, colour).middle().right());
        let nothing = match (self.entries.is_empty(), self.found.is_empty()) {
            (true, _) => tr("There are no levels here yet."),
            (false, true) => tr("No level has such a name or title."),
            (false, false) => "",
        };
        ui.fitted(nothing, ui.frame().size / 2.0, &[TEXT], theme::quiet());
    }

    /// The cards of the page. Enter and a click choose a level; a right click, or the key of details on it, leads to its flights.
    fn show_cards(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        let mut request = None;
        self.focused = None;
        let page = self.pages.get(self.page).map_or(&[][..], Vec::as_slice);
        let has_worlds = self.found.iter().any(|index| self.entries[*index].world.is_some());
        let shown: Vec<&LevelEntry> = page.iter().flat_map(|shelf| &self.found[shelf.clone()]).map(|i| &self.entries[*i]).collect();
        let world = |shelf: &Range<usize>| self.entries[self.found[shelf.start]].world;
        let head = |i: usize| i == 0 || world(&page[i]) != world(&page[i - 1]);
        let heads: Vec<bool> = if has_worlds { (0..page.len()).map(head).collect() } else { Vec::new() };
        let (cards, headings) = shelves::places(page, &heads, &self.frame(&ui.frame()));
        for (levels, area) in shown.chunk_by(|a, b| a.world == b.world).zip(headings) {
            shelves::draw_heading(ui.canvas(), area, levels);
        }
        for (index, area) in self.in_view().into_iter().zip(cards) {
            let entry = &self.entries[index];
            let touch = ui.touch(&entry.name, area, WidgetKind::Button);
            card::draw(ui.canvas(), area, (entry, self.purpose == Purpose::Edit), touch);
            if touch.focus {
                self.focused = Some(entry.name.clone());
            }
            let under = ui.is_live() && ui.input().right_click && area.contains(ui.input().pointer);
            if under || touch.focus && ui.acts(Action::Details) {
                request = request.or_else(|| self.visit(index));
            }
            if touch.pressed {
                return self.choose(index);
            }
        }
        request
    }
}

impl Screen for LevelSelect {
    fn show(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        let typed = self.type_in(ui);
        let mut request = if ui.key(Key::Escape) { self.go_back(ui) } else { None };
        if let Some(name) = &self.start {
            ui.start_at(name);
        }
        self.show_heading(ui);
        request = request.or(self.show_cards(ui).filter(|_| !typed));
        request = request.or(self.show_foot(ui));
        request = request.or(self.show_prompt(ui));
        if !self.binned.is_empty() && ui.key(Key::Z) && ui.input().held(Key::Control) {
            request = request.or(Some(Request::Do(Effect::OnLevel(OnLevel::TakeBack))));
        }
        if self.problems.as_ref().is_some_and(|problems| problems.show(ui)) {
            self.problems = None;
        }
        request
    }

    fn parent(&self) -> Destination {
        match (self.purpose, &self.prompt) {
            (_, Some(asked)) if matches!(asked.1, Asked::OwnCopy(_)) => Destination::Levels(Purpose::Edit),
            _ => Destination::Menu,
        }
    }

    fn carry_out(&mut self, effect: Effect, session: &mut Session, _: &mut dyn Spectator) -> Option<Request> {
        let make = match effect {
            Effect::Make(make) => make,
            Effect::OnLevel(deed) => {
                self.hand_on(&deed, session);
                return None;
            }
            _ => return None,
        };
        match files::make(&make, session) {
            Ok(()) => Some(match make {
                Make::Rename(..) => Request::Reset(Destination::Levels(Purpose::Edit)),
                Make::New(name) | Make::Copy(_, name) | Make::CopyOf(_, name) => {
                    Request::Replace(Destination::Edit { name, original: false })
                }
            }),
            Err(reason) => {
                self.refuse(reason);
                None
            }
        }
    }

    fn refuse(&mut self, reason: String) {
        if let Some(asked) = &mut self.prompt {
            asked.0.refuse(reason);
        }
    }

    /// Looks whether the levels in view have changed on disk, and whether there are others.
    fn look(&mut self, frame_time: f64, session: &mut Session) {
        self.look -= frame_time;
        if self.look > 0.0 {
            return;
        }
        self.look = LOOK_EVERY;
        let in_view = self.in_view().into_iter().map(|index| &self.entries[index]);
        let changed = in_view.filter(|entry| entry.stamp != Stamp::of(&session.library.folder(&entry.name), &[]));
        let changed: Vec<String> = changed.map(|entry| entry.name.clone()).collect();
        changed.iter().for_each(|name| self.ask_for_card(name, session));
        if let Slot::Vacant(slot) = self.asked.entry(String::new()) {
            slot.insert(session.worker.ask(Errand::List(session.library.levels().to_path_buf())));
        }
    }

    /// Titles while something is to be found, and the cards in view that are not known yet.
    fn attend(&mut self, session: &mut Session) {
        let finds = !self.find.is_empty();
        let mut learnt = false;
        for entry in self.entries.iter_mut().filter(|entry| finds && entry.title.is_none()).take(TITLES_A_FRAME) {
            entry.title = Some(session.library.title(&entry.name));
            learnt = true;
        }
        if learnt {
            self.search();
        }
        let in_view = self.in_view().into_iter().map(|index| &self.entries[index]);
        let new: Vec<String> = in_view.filter(|entry| entry.level.is_none()).map(|entry| entry.name.clone()).collect();
        new.iter().for_each(|name| self.ask_for_card(name, session));
    }

    fn receive(&mut self, ticket: Ticket, brought: Brought, session: &mut Session, _: &mut dyn Spectator) {
        match brought {
            Brought::Card(card) => self.take_card(ticket, *card, session),
            Brought::List(names) => {
                self.asked.remove("");
                self.renew(names, &session.library);
            }
            _ => {}
        }
    }

    fn leave(&mut self, session: &mut Session) {
        std::mem::take(&mut self.asked).values().for_each(|ticket| session.worker.forget(*ticket));
    }
}
