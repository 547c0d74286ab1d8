//! The editor: a level's files as a drawing. What the player does becomes operations on the [`Document`]; what is wrong with it is the
//! loader's own list, read from memory. `view` is the part of the picture on the screen, `hand` what the pointer does there, `snap` where that
//! ends up, `panel` the columns of what is selected, `layout` where everything is, `ask` the questions; `drawing` draws all of it.

mod ask;
mod commands;
mod drawing;
mod hand;
mod layout;
mod panel;
mod snap;
mod view;

use super::folder_watch::FolderWatch;
use super::input::Repeat;
use super::scroll::Scroll;
use super::{Buttons, Input, Keys, Motion, Request, Screen};
use crate::draw::layout::{Area, Frame, Vec2};
use crate::level::document::{Document, Kind, LevelFolder, Opened, Place, RowId, SetCell, Table};
use crate::level::{Level, Problem};
use crate::physics::DVec2;
use crate::settings::Settings;
use crate::ui::Ui;
use ask::{Ask, Question};
use hand::Drag;
use layout::{OFFERS, PROBLEM_LINES, Parts};
use panel::{Panel, Write};
use std::cell::RefCell;
use std::path::Path;
use std::sync::Arc;
use view::View;

/// From an edit to the look at what is wrong, s: short enough to be live, long enough not to be done for each letter.
const CHECK_AFTER: f64 = 0.15;
/// How long a remark is shown, and how much longer for each letter, s.
const TOLD: f64 = 4.0;
const READ: f64 = 0.05;
/// From one time that unsaved edits are kept to the next while something is dragged, s.
const KEEP_EVERY: f64 = 1.0;

/// What a click in the picture does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tool {
    /// It selects and moves.
    Select,
    /// It adds one of these.
    Add(Kind),
}

/// What the row of commands offers, with the key that does the same.
pub const COMMANDS: [(&str, &str); 9] = [
    ("Back", "Esc"),
    ("Save", "Ctrl S"),
    ("Undo", "Ctrl Z"),
    ("Redo", "Ctrl Y"),
    ("Copy", "Ctrl D"),
    ("Delete", "Del"),
    ("Snap", "G"),
    ("All", "F"),
    ("Fly", "F5"),
];
/// How many of them stand at the left.
const AT_LEFT: usize = 8;

/// A level that is edited.
#[derive(Debug)]
pub struct Editor {
    document: Document,
    folder: LevelFolder,
    name: String,
    view: View,
    parts: Parts,
    tool: Tool,
    selection: Vec<RowId>,
    drag: Option<Drag>,
    panel: Panel,
    commands: Buttons,
    tools: Buttons,
    snapping: bool,
    /// Counts gestures: what belongs to one is undone together.
    gesture: u64,
    problems: Vec<(Problem, bool)>,
    /// The row that each of them is about.
    about: Vec<Option<RowId>>,
    scroll: Scroll,
    /// The level as the loader understood it last, where it did.
    level: Option<Arc<Level>>,
    /// Which version of the document that was, and until the next look, s.
    checked: (Option<u64>, f64),
    /// Which version is kept beside the files, and how long ago that was done, s.
    kept: (u64, f64),
    watch: FolderWatch,
    ask: Option<Ask>,
    remark: Option<(String, f64)>,
    repeat: Repeat,
    /// The view that shows all of the level, and the canvas in which it does, until another one is chosen.
    fitted: Option<(View, Frame)>,
    /// The pictures that were drawn, until one may have changed.
    sheets: RefCell<drawing::Sheets>,
    /// The pictures that are there, as cells name them.
    offered: Vec<String>,
    /// Where the pointer is, canvas units.
    pointer: Vec2,
    /// Whether frames a second are shown.
    figures: bool,
}

impl Screen for Editor {
    fn show(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        self.update(ui.input())
    }

    fn motion(&self, input: &Input) -> Motion {
        if input.holding || input.dragging { Motion::Full } else { Motion::Still }
    }

    fn takes(&self, _: &Path) -> bool {
        !self.is_unsaved()
    }

    /// A large window is left to the picture.
    fn text_scale(&self, _: &Settings, pixel: f32) -> f32 {
        layout::text_scale(pixel)
    }

    #[cfg(feature = "window")]
    fn draw(
        &self,
        theatre: &mut crate::screens::theatre::Theatre,
        moment: crate::screens::theatre::PictureTime,
        canvas: &mut crate::draw::Canvas,
    ) {
        self.draw_all(canvas, moment.shown_for, theatre.frames());
    }
}

impl Editor {
    /// Opens the level in that folder; images are looked up there, then under `root`.
    ///
    /// # Errors
    /// A file that cannot be read, in words.
    pub fn open(folder: &Path, root: &Path) -> Result<Self, String> {
        let Opened { document, folder, kept } = LevelFolder::open_to_edit(folder, root)?;
        let mut editor = Self {
            name: folder.name(),
            watch: FolderWatch::new(folder.path().to_path_buf(), Vec::new()),
            kept: (document.version(), 0.0),
            ask: kept.map(|kept| Ask::new(Question::Restore(kept))),
            remark: None,
            offered: folder.pictures(),
            document,
            folder,
            view: View::default(),
            parts: Parts::default(),
            tool: Tool::Select,
            selection: Vec::new(),
            drag: None,
            panel: Panel::default(),
            commands: Buttons::default(),
            tools: Buttons::default(),
            snapping: true,
            gesture: 0,
            problems: Vec::new(),
            about: Vec::new(),
            scroll: Scroll::default(),
            level: None,
            checked: (None, 0.0),
            repeat: Repeat::default(),
            fitted: None,
            sheets: RefCell::default(),
            pointer: Vec2::ZERO,
            figures: false,
        };
        if editor.folder.is_shared() {
            editor.say("Another editor has this level open: what it saves is taken over here.");
        }
        Ok(editor)
    }

    /// One frame.
    pub fn update(&mut self, input: &Input) -> Option<Request> {
        if self.checked.0.is_none() && self.fitted.is_none() {
            // So that the room for what is wrong is known before the level is shown.
            self.check();
        }
        let lines = self.problems.len().min(PROBLEM_LINES);
        self.parts = Parts::new(&input.frame, lines);
        self.view.area = self.parts.middle;
        self.pointer = input.pointer;
        self.commands.place(self.parts.commands(AT_LEFT, COMMANDS.len() - AT_LEFT));
        self.tools.place(self.parts.tools(Kind::ADDED.len() + 1));
        let room = Area::new(self.parts.bottom.max().x - 14.0, self.parts.problem(0).min.y, 12.0, lines as f32 * self.parts.line);
        self.scroll.place(self.problems.len(), lines.max(1), room);
        let untouched = |(view, frame): &(View, Frame)| self.view.shows_as(view) && *frame != input.frame;
        if self.fitted.as_ref().is_none_or(untouched) {
            self.show_all();
            self.fitted = Some((self.view, input.frame));
        }
        self.pass_time(input.frame_time);
        let request = if self.ask.is_some() { self.update_ask(input) } else { self.work(input) };
        self.selection.retain(|row| self.document.kind(*row).is_some());
        self.panel.show(&self.document, &self.selection);
        request
    }

    /// What happens by itself: files are looked at, edits kept and checked.
    fn pass_time(&mut self, frame_time: f64) {
        // What is pointed at is being read.
        if let Some((_, left)) = self.remark.as_mut().filter(|_| !self.parts.bottom.contains(self.pointer)) {
            *left -= frame_time;
            self.remark = self.remark.take().filter(|(_, left)| *left > 0.0);
        }
        if self.watch.update(frame_time) {
            self.meet_changes();
        }
        self.kept.1 += frame_time;
        let asked = matches!(self.ask.as_ref().map(|ask| &ask.question), Some(Question::Restore(_)));
        if self.kept.0 != self.document.version() && !asked && (self.drag.is_none() || self.kept.1 > KEEP_EVERY) {
            self.kept = (self.document.version(), 0.0);
            if let Err(error) = self.folder.keep(&self.document) {
                self.say(format!("The edits cannot be kept beside the files: {error}"));
            }
        }
        if self.checked.0 != Some(self.document.version()) && self.drag.is_none() {
            self.checked.1 -= frame_time;
            if self.checked.1 <= 0.0 {
                self.check();
            }
        }
    }

    /// Another program has written into the folder.
    fn meet_changes(&mut self) {
        let (taken, both) = self.folder.take_over(&mut self.document);
        self.folder.measure(&mut self.document);
        self.offered = self.folder.pictures();
        self.checked.0 = None;
        self.sheets.take();
        if !both.is_empty() {
            self.ask = Some(Ask::new(Question::Theirs(both)));
        } else if taken {
            self.say("Another program has changed the files: they were read again.");
        }
    }

    /// Asks the loader.
    fn check(&mut self) {
        if !self.document.unknown_pictures().is_empty() {
            self.folder.measure(&mut self.document);
        }
        (self.level, self.problems) = match self.folder.check(&self.document) {
            Ok(loaded) => (Some(Arc::new(loaded.level)), loaded.warnings.into_iter().map(|warning| (warning, false)).collect()),
            Err(problems) => (None, problems.into_iter().map(|problem| (problem, true)).collect()),
        };
        let row = |problem: &Problem| self.document.row_at(Table::of_file(&problem.file)?, problem.line);
        self.about = self.problems.iter().map(|(problem, _)| row(problem)).collect();
        self.checked = (Some(self.document.version()), CHECK_AFTER);
    }

    fn work(&mut self, input: &Input) -> Option<Request> {
        if let Some(request) = self.update_keys(input) {
            return request.0;
        }
        if self.drag.is_none() {
            if let Some(pressed) = self.commands.update(&mouse_only(input)) {
                return self.command(COMMANDS[pressed].0);
            }
            if let Some(pressed) = self.tools.update(&mouse_only(input)) {
                self.tool = if pressed == 0 { Tool::Select } else { Tool::Add(Kind::ADDED[pressed - 1]) };
            }
            if self.parts.bottom.contains(input.pointer) {
                self.update_problems(input);
                if input.click {
                    return None;
                }
            }
            if self.map_is_shown() && self.parts.map.contains(input.pointer) && input.holding {
                self.view.centre(self.on_map(input.pointer));
                return None;
            }
            if let (Some(picture), true) = (self.offer_at(input.pointer), input.click) {
                self.take_picture(&picture);
                return None;
            }
        }
        let gesture = self.gesture + 1;
        match self.panel.update(input, &self.parts, gesture) {
            Some(Write::Cells(cells, gesture)) => self.set_as(&cells, gesture),
            Some(Write::Setting(name, text, gesture)) => {
                let done = self.document.set_setting(name, &text, Some(gesture));
                self.tell(done);
            }
            None => {}
        }
        if input.click || input.right_click {
            self.next_gesture();
        }
        self.update_hand(input);
        None
    }

    fn update_problems(&mut self, input: &Input) {
        self.scroll.update(&mouse_only(input));
        let under = (0..self.problems.len().min(PROBLEM_LINES)).find(|line| self.parts.problem(*line).contains(input.pointer));
        let index = under.map(|line| line + self.scroll.range().start);
        if let (true, Some((problem, _))) = (input.click, index.and_then(|index| self.problems.get(index))) {
            self.go_to(&problem.clone());
        }
    }

    /// Selects what a problem is about and brings it into view, where it is not; another time it puts the keyboard into its column.
    fn go_to(&mut self, problem: &Problem) {
        let row = Table::of_file(&problem.file).and_then(|table| self.document.row_at(table, problem.line));
        match row.map(|row| (row, self.document.kind(row))) {
            Some((row, Some(Kind::Setting))) => {
                let name = self.document.cell(row, "name").unwrap_or_default().to_owned();
                self.select(Vec::new());
                self.next_gesture();
                self.panel.show(&self.document, &[]);
                self.panel.focus(&name, self.gesture);
            }
            Some((row, _)) => {
                let again = self.selection == [row];
                self.select(vec![row]);
                self.next_gesture();
                self.panel.show(&self.document, &self.selection);
                self.panel.typing = None;
                if again {
                    self.panel.focus(&problem.column, self.gesture);
                }
                if let Some(place) = self.document.place(row).filter(|place| !self.view.visible().meets(place)) {
                    self.view.centre(place.centre());
                }
            }
            None => {
                self.select(Vec::new());
                self.say(format!("{} has no such row.", problem.file));
            }
        }
    }

    /// The pictures that are offered for what is selected: none where it shows none.
    fn offers(&self) -> &[String] {
        let shows = self.panel.fields.iter().any(|field| field.name == "image");
        &self.offered[..if shows { self.offered.len().min(OFFERS) } else { 0 }]
    }

    /// The picture whose line is there.
    fn offer_at(&self, point: Vec2) -> Option<String> {
        let fields = self.panel.fields.len();
        let index = (0..self.offers().len()).find(|index| self.parts.offer(fields, *index).contains(point))?;
        self.offers().get(index).cloned()
    }

    /// What is selected shows that picture.
    fn take_picture(&mut self, picture: &str) {
        self.next_gesture();
        self.panel.typing = None;
        let cell = |row: &RowId| SetCell { row: *row, column: "image", text: picture.to_owned() };
        self.set(&self.selection.iter().map(cell).collect::<Vec<_>>());
        self.folder.measure(&mut self.document);
    }

    /// Whether a problem is about what is selected, or about the level's settings where nothing is.
    fn is_about(&self, problem: &Problem, row: Option<RowId>) -> bool {
        if self.selection.is_empty() {
            problem.file == "constants.csv"
        } else {
            row.is_some_and(|row| self.selection.contains(&row))
        }
    }

    /// Whether something is wrong with a column of what is selected.
    fn is_wrong(&self, column: &str) -> bool {
        let named = |problem: &Problem, row: Option<RowId>| match (self.selection.is_empty(), row) {
            (true, Some(row)) => self.document.cell(row, "name").is_some_and(|name| name.eq_ignore_ascii_case(column)),
            _ => problem.column == column,
        };
        let mut all = self.problems.iter().zip(&self.about);
        all.any(|((problem, _), row)| named(problem, *row) && self.is_about(problem, *row))
    }

    fn put(&mut self, kind: Kind, place: Place) {
        match self.document.put(kind, place) {
            Ok(row) => {
                self.select(row.into_iter().collect());
                self.tool = Tool::Select;
            }
            Err(refusal) => self.say(refusal),
        }
    }

    fn shift_selection(&mut self, by: DVec2) {
        if by == DVec2::ZERO {
            return;
        }
        let cells: Vec<SetCell> = self.selection.iter().flat_map(|row| self.document.shifted(*row, by)).collect();
        self.set(&cells);
    }

    fn set(&mut self, cells: &[SetCell]) {
        self.set_as(cells, self.gesture);
    }

    fn set_as(&mut self, cells: &[SetCell], gesture: u64) {
        let done = self.document.set(cells, Some(gesture));
        self.tell(done);
    }

    fn tell(&mut self, done: Result<(), String>) {
        if let Err(refusal) = done {
            self.say(refusal);
        }
    }

    fn say(&mut self, words: impl Into<String>) {
        let words = words.into();
        let told = TOLD + READ * words.chars().count() as f64;
        self.remark = Some((words, told));
    }

    fn next_gesture(&mut self) {
        self.gesture += 1;
    }

    fn select(&mut self, rows: Vec<RowId>) {
        self.selection = rows;
    }

    /// Brings all of the level, and what lies outside of it, into view.
    fn show_all(&mut self) {
        let level = Place { min: DVec2::ZERO, size: self.document.size() };
        let all = self.document.things().fold(level, |all, (_, place)| {
            // What lies kilometres away is a mistake: it shall not make a speck of the level.
            let near = Place { min: level.min - level.size, size: level.size * 3.0 };
            if near.meets(&place) { Place::between(all.min.min(place.min), all.max().max(place.max())) } else { all }
        });
        self.view.fit(&all);
    }

    /// Whether the small map is shown: where not all of the level is in view.
    fn map_is_shown(&self) -> bool {
        let visible = self.view.visible();
        !(visible.contains(DVec2::ZERO) && visible.contains(self.document.size()))
    }

    /// The level on the small map: canvas units a pixel, and where its corner is.
    fn map(&self) -> (f32, Vec2) {
        let (area, size) = (self.parts.map, self.document.size().as_vec2());
        let scale = (area.size / size).min_element();
        (scale, area.centre() - size * scale / 2.0)
    }

    /// The point of the picture at a point of the small map.
    fn on_map(&self, point: Vec2) -> DVec2 {
        let (scale, corner) = self.map();
        ((point - corner) / scale).as_dvec2()
    }

    /// The level's files.
    pub fn document(&self) -> &Document {
        &self.document
    }

    /// What is selected.
    pub fn selection(&self) -> &[RowId] {
        &self.selection
    }

    /// The level's name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// What is wrong or odd, with whether the level is refused for it.
    pub fn problems(&self) -> &[(Problem, bool)] {
        &self.problems
    }

    /// What a click does.
    pub fn tool(&self) -> Tool {
        self.tool
    }

    /// What was said last, while it is shown.
    pub fn remark(&self) -> Option<&str> {
        self.remark.as_ref().map(|(words, _)| words.as_str())
    }

    /// Whether there is something that is not on disk.
    pub fn is_unsaved(&self) -> bool {
        self.folder.is_unsaved(&self.document)
    }

    /// The buttons: those of the question, while one is asked; else the commands.
    pub fn buttons(&self) -> &Buttons {
        self.ask.as_ref().map_or(&self.commands, Ask::buttons)
    }

    /// What is asked, on two lines, while something is.
    pub fn asked(&self) -> Option<[String; 2]> {
        self.ask.as_ref().map(Ask::words)
    }

    /// The tools: Select, then those of [`Kind::ADDED`].
    pub fn tools(&self) -> &Buttons {
        &self.tools
    }

    /// The point of the picture that the pointer is at, pixels.
    pub fn pointed(&self) -> DVec2 {
        self.view.pixels(self.pointer)
    }

    /// Where a point of the picture is on the canvas.
    pub fn point(&self, pixels: DVec2) -> Vec2 {
        self.view.point(pixels)
    }

    /// Where the field of a column is on the canvas, if it is shown.
    pub fn field(&self, name: &str) -> Option<Area> {
        let index = self.panel.fields.iter().position(|field| field.name == name)?;
        Some(self.parts.field(index))
    }

    /// Where the line of a picture is that is offered for what is selected, if it is.
    pub fn offer(&self, picture: &str) -> Option<Area> {
        let index = self.offers().iter().position(|offered| offered == picture)?;
        Some(self.parts.offer(self.panel.fields.len(), index))
    }

    /// The field that has the keyboard, and its text.
    pub fn typing(&self) -> Option<(&'static str, String)> {
        self.panel.typing.as_ref().map(|typing| (typing.name, typing.field.text()))
    }

    /// Where the line of a problem is on the canvas, counted from the first in view.
    pub fn problem_line(&self, index: usize) -> Area {
        self.parts.problem(index)
    }
}

/// What the mouse did: the keys are for others.
fn mouse_only(input: &Input) -> Input {
    Input { pressed: Keys::default(), ..input.clone() }
}
