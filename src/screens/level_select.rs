//! A page of cards, one a level, used three times: to choose what to play, whose leaderboard to see, and what to edit. Only the levels in
//! view are loaded, and again when their files change; typing finds those with such a name or title.

use super::input::{Repeat, Stroke};
use super::library::Refusal;
use super::prompt::{Prompt, Reply};
use super::{Buttons, Input, Key, Make, Problems, Request, Visit};
use crate::settings::Action;
use crate::view::layout::{Area, Frame};
use places::cards;
use std::collections::BTreeMap;
use std::path::PathBuf;

mod drawing;
mod entry;
mod places;

pub use entry::Entry;

/// Levels a page.
pub const PAGE: usize = 15;

/// What a level is chosen for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// To play it.
    Play,
    /// To see its leaderboard.
    Leaderboard,
    /// To edit it.
    Edit,
}

/// What a level is to be chosen for, besides the list's own purpose.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Pick {
    Copy,
    Rename,
}

/// How many titles are looked for in a frame while something is to be found: a few milliseconds' worth.
const TITLES_A_FRAME: usize = 100;
/// From one look at the files in view to the next, s.
const LOOK_EVERY: f64 = 0.5;
/// The most letters to find something by.
const MOST_LETTERS: usize = 40;

/// The grid of levels.
#[derive(Debug)]
pub struct LevelSelect {
    purpose: Purpose,
    entries: Vec<Entry>,
    /// What is to be found, and which entries that finds.
    find: String,
    found: Vec<usize>,
    page: usize,
    buttons: Buttons,
    problems: Option<Problems>,
    pick: Option<Pick>,
    prompt: Option<Box<(Prompt, Asked)>>,
    repeat: Repeat,
    /// Until the next look at files, s.
    look: f64,
}

/// What a name is asked for.
#[derive(Clone, Debug)]
enum Asked {
    New,
    Copy(PathBuf),
    /// The same, of a level that comes with the game and was to be edited itself.
    OwnCopy(PathBuf),
    Rename(String),
}

/// What a button of the screen is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Press {
    Level(usize),
    Back,
    Previous,
    Next,
    Edit,
    New,
    Copy,
    Rename,
}

impl LevelSelect {
    /// The list of those levels for that purpose.
    pub fn new(purpose: Purpose, names: Vec<String>) -> Self {
        let entries: Vec<Entry> = names.into_iter().map(Entry::new).collect();
        Self {
            purpose,
            found: (0..entries.len()).collect(),
            entries,
            find: String::new(),
            page: 0,
            buttons: Buttons::default(),
            problems: None,
            pick: None,
            prompt: None,
            repeat: Repeat::default(),
            look: LOOK_EVERY,
        }
    }

    /// Opens the page of a level and puts the keyboard on it.
    pub fn turn_to_level(&mut self, name: &str) {
        if let Some(index) = self.found.iter().position(|index| self.entries[*index].name == name) {
            self.page = index / PAGE;
            self.buttons = Buttons::focused_on(index % PAGE);
        }
    }

    /// Shows why a level does not load.
    pub fn show_problems(&mut self, name: &str, refusal: Refusal) {
        self.turn_to_level(name);
        self.show(format!("Level {name} does not load"), refusal);
    }

    /// Shows a panel above the list.
    pub fn show(&mut self, heading: String, problems: Vec<String>) {
        self.problems = Some(Problems::new(heading, problems));
    }

    /// Asks what a copy of a level that comes with the game is called.
    pub fn ask_for_copy(&mut self, name: &str, folder: PathBuf, free: &str) {
        let prompt = Prompt::new(format!("What is your copy of {name} called?"), free)
            .with_note(format!("{name} comes with the game and stays as it is."));
        self.prompt = Some(Box::new((prompt, Asked::OwnCopy(folder))));
    }

    /// Says why a name will not do.
    pub fn refuse(&mut self, reason: String) {
        if let Some(asked) = &mut self.prompt {
            asked.0.refuse(reason);
        }
    }

    /// The entries in view.
    pub fn in_view(&self) -> Vec<usize> {
        self.found.iter().skip(self.page * PAGE).take(PAGE).copied().collect()
    }

    /// Whether it is time to look whether files have changed.
    pub fn looks(&mut self, frame_time: f64) -> bool {
        self.look -= frame_time;
        let due = self.look <= 0.0;
        if due {
            self.look = LOOK_EVERY;
        }
        due
    }

    /// Takes over what is known of a level now.
    pub fn tell(&mut self, index: usize, entry: Entry) {
        self.entries[index] = entry;
    }

    /// Shows those levels instead; what is known of a level stays, and so does the keyboard on its card.
    pub fn renew(&mut self, names: Vec<String>) {
        if names.iter().eq(self.entries.iter().map(|entry| &entry.name)) {
            return;
        }
        let focused = self.in_view().get(self.buttons.focus()).map(|index| self.entries[*index].name.clone());
        let mut known: BTreeMap<String, Entry> = self.entries.drain(..).map(|entry| (entry.name.clone(), entry)).collect();
        self.entries = names.into_iter().map(|name| known.remove(&name).unwrap_or_else(|| Entry::new(name))).collect();
        self.search(false);
        if let Some(name) = focused {
            self.turn_to_level(&name);
        }
    }

    /// Looks for some of the titles that are not known yet, while something is to be found.
    pub fn learn_titles(&mut self, title: impl Fn(&str) -> String) {
        if self.find.is_empty() {
            return;
        }
        let unknown = self.entries.iter_mut().filter(|entry| entry.title.is_none()).take(TITLES_A_FRAME);
        let mut learnt = false;
        for entry in unknown {
            entry.title = Some(title(&entry.name));
            learnt = true;
        }
        if learnt {
            self.search(false);
        }
    }

    /// One frame.
    pub fn update(&mut self, input: &Input) -> Option<Request> {
        let presses = self.presses();
        let cards = cards(self.found.len().min(PAGE), &input.frame);
        self.buttons.place(presses.iter().map(|press| self.place(*press, &cards, &input.frame)).collect());
        if let Some(problems) = &mut self.problems {
            if problems.update(input) {
                self.problems = None;
            }
            return None;
        }
        if self.prompt.is_some() {
            return self.update_prompt(input);
        }
        if input.pressed(Key::Escape) {
            return self.go_back();
        }
        if self.type_in(input) {
            return None;
        }
        if input.pressed(Key::PageDown) {
            self.turn_to(self.page + 1);
        } else if input.pressed(Key::PageUp) {
            self.turn_to(self.page.saturating_sub(1));
        } else if let Some(visit) = self.visit(input, &presses) {
            return Some(Request::Flights(visit));
        } else if let Some(pressed) = self.buttons.update(input) {
            return self.press(presses[pressed]);
        }
        None
    }

    /// What it is used for.
    pub fn purpose(&self) -> Purpose {
        self.purpose
    }

    /// All levels, in order.
    pub fn entries(&self) -> &[Entry] {
        &self.entries
    }

    /// The page in view, from 0.
    pub fn page(&self) -> usize {
        self.page
    }

    /// What is to be found.
    pub fn find(&self) -> &str {
        &self.find
    }

    /// Its buttons: the levels of the page, Back, and what else there is.
    pub fn buttons(&self) -> &Buttons {
        self.prompt.as_ref().map_or(&self.buttons, |asked| asked.0.buttons())
    }

    /// The panel that asks for a name, while it is open.
    pub fn prompt(&self) -> Option<&Prompt> {
        self.prompt.as_ref().map(|asked| &asked.0)
    }

    /// Why a level does not load, while that is shown.
    pub fn problems(&self) -> Option<&Problems> {
        self.problems.as_ref()
    }

    /// The level whose flights are asked for: that under a right click, or that which has the keyboard.
    fn visit(&self, input: &Input, presses: &[Press]) -> Option<Visit> {
        let under = || self.buttons.areas().iter().position(|area| area.contains(input.pointer));
        let at = if input.acts(Action::Details) { Some(self.buttons.focus()) } else { under().filter(|_| input.right_click) };
        let Press::Level(index) = *presses.get(at?)? else { return None };
        let Entry { name, level, .. } = &self.entries[index];
        let back = Box::new(Request::LevelSelect(self.purpose));
        let loads = level.as_ref().is_some_and(Result::is_ok) && self.purpose != Purpose::Edit;
        loads.then(|| Visit { level: name.clone(), flown: None, back })
    }

    /// Esc: out of what was begun last.
    fn go_back(&mut self) -> Option<Request> {
        if !self.find.is_empty() {
            self.find.clear();
            self.search(true);
            return None;
        }
        if self.pick.take().is_some() {
            return None;
        }
        match self.purpose {
            Purpose::Edit => Some(Request::LevelSelect(Purpose::Play)),
            Purpose::Play | Purpose::Leaderboard => Some(Request::Menu),
        }
    }

    /// Letters are what is to be found; whether there were any.
    fn type_in(&mut self, input: &Input) -> bool {
        let before = self.find.clone();
        for stroke in input.strokes(&[Key::Backspace]) {
            match stroke {
                Stroke::Letter(letter) if letter.is_control() || self.find.chars().count() >= MOST_LETTERS => {}
                Stroke::Letter(letter) => self.find.push(letter),
                Stroke::Key(..) => drop(self.find.pop()),
            }
        }
        self.find = self.find.trim_start().to_owned();
        if !self.repeat.strokes(input, &[Key::Backspace]).is_empty() && !input.pressed(Key::Backspace) {
            self.find.pop();
        }
        let changed = self.find != before;
        if changed {
            self.search(true);
        }
        changed
    }

    fn search(&mut self, anew: bool) {
        let letters = self.find.trim().to_lowercase();
        self.found = (0..self.entries.len()).filter(|index| self.entries[*index].has(&letters)).collect();
        if anew {
            self.page = 0;
            self.buttons = Buttons::default();
        }
        self.page = self.page.min(self.pages() - 1);
    }

    fn update_prompt(&mut self, input: &Input) -> Option<Request> {
        let (prompt, asked) = &mut **self.prompt.as_mut()?;
        match prompt.update(input)? {
            Reply::Cancel => {
                let leaves = matches!(asked, Asked::OwnCopy(_));
                self.prompt = None;
                leaves.then_some(Request::LeaveEditor)
            }
            Reply::Text(name) => Some(Request::Make(match asked.clone() {
                Asked::New => Make::New(name),
                Asked::Copy(from) | Asked::OwnCopy(from) => Make::Copy(from, name),
                Asked::Rename(from) => Make::Rename(from, name),
            })),
        }
    }

    fn press(&mut self, press: Press) -> Option<Request> {
        match press {
            Press::Back => return self.go_back(),
            Press::Previous => self.turn_to(self.page.saturating_sub(1)),
            Press::Next => self.turn_to(self.page + 1),
            Press::Edit => return Some(Request::LevelSelect(Purpose::Edit)),
            Press::New => self.prompt = Some(Box::new((Prompt::new("What is the new level called?", ""), Asked::New))),
            Press::Copy => self.pick = Some(Pick::Copy),
            Press::Rename => self.pick = Some(Pick::Rename),
            Press::Level(index) => {
                let name = self.entries[index].name.clone();
                return match (self.purpose, self.pick.take()) {
                    (_, Some(Pick::Copy)) => {
                        let heading = format!("What is the copy of {name} called?");
                        self.prompt = Some(Box::new((Prompt::new(heading, &format!("{name}-copy")), Asked::Copy(name.into()))));
                        None
                    }
                    (_, Some(Pick::Rename)) => {
                        let heading = format!("What is {name} called from now on?");
                        self.prompt = Some(Box::new((Prompt::new(heading, &name), Asked::Rename(name))));
                        None
                    }
                    // Whether it loads is found out afresh: it may have been mended since.
                    (Purpose::Play, None) => Some(Request::Play(name)),
                    (Purpose::Leaderboard, None) => Some(Request::Leaderboard(name)),
                    (Purpose::Edit, None) => Some(Request::Edit(name)),
                };
            }
        }
        None
    }

    fn turn_to(&mut self, page: usize) {
        if page < self.pages() && page != self.page {
            self.page = page;
            self.buttons = Buttons::default();
        }
    }

    fn pages(&self) -> usize {
        self.found.len().div_ceil(PAGE).max(1)
    }

    fn presses(&self) -> Vec<Press> {
        let turns: &[Press] = if self.pages() > 1 { &[Press::Previous, Press::Next] } else { &[] };
        let more: &[Press] = match self.purpose {
            Purpose::Play => &[Press::Edit],
            Purpose::Edit => &[Press::New, Press::Copy, Press::Rename],
            Purpose::Leaderboard => &[],
        };
        let levels = self.in_view().into_iter().map(Press::Level);
        levels.chain([Press::Back]).chain(turns.iter().copied()).chain(more.iter().copied()).collect()
    }

    /// Where a button is: a level's card, the others in a row below the cards.
    fn place(&self, press: Press, cards: &[Area], frame: &Frame) -> Area {
        match press {
            Press::Level(index) => {
                let nth = self.found.iter().position(|found| *found == index).unwrap_or(0);
                cards[nth % PAGE]
            }
            Press::Back => places::from_left(0.0, frame),
            Press::Edit | Press::New => places::from_left(1.0, frame),
            Press::Copy => places::from_left(2.0, frame),
            Press::Rename => places::from_left(3.0, frame),
            Press::Previous => places::from_right(1.0, frame),
            Press::Next => places::from_right(0.0, frame),
        }
    }
}
