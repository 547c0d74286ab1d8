//! The editor: a level's files as a picture. Each act becomes an operation on the [`Document`]; the problems are the loader's own list, from memory.

mod arrange;
mod ask;
mod commands;
mod hand;
mod handles;
mod layout;
mod nature;
mod overlay;
mod panel;
mod picture;
mod problem_list;
mod test_flight;
mod tools;
mod view;

use crate::draw::layout::{Area, Frame, Vec2};
use crate::level::document::{Document, LevelFolder, Opened, Place, RowId, SetCell};
use crate::screens::screen::{Destination, Purpose, Request, Screen};
use crate::session::{Session, folder_watch::FolderWatch, worker::Brought};
use crate::ui::{Spectator, Ui, pace::Motion, scroll::Scroll};
use crate::{draw::Canvas, draw::Style, level::Level, level::Problem, settings::Settings, ui::input::Input, ui::input::Repeat};
use crate::{physics::DVec2, view::widgets};
use arrange::Arranged;
use ask::Ask;
use hand::PointerDrag;
use layout::{PROBLEM_LINES, Panes};
use panel::CellPanel;
use std::{cell::RefCell, path::Path, sync::Arc};
use test_flight::TestFlight;
use tools::EditorTool;
use view::EditorView;

/// From an edit to its check, s: short enough to be live, long enough not to check each letter.
const CHECK_AFTER: f64 = 0.15;
/// How long a remark is shown, and how much longer for each letter, s.
const REMARK: f64 = 4.0;
const LETTER: f64 = 0.05;
/// From one time that unsaved edits are kept to the next during a drag, s.
const KEEP_EVERY: f64 = 1.0;

#[derive(Debug)]
pub struct Editor {
    document: Document,
    folder: LevelFolder,
    name: String,
    view: EditorView,
    panes: Panes,
    tool: EditorTool,
    selection: Vec<RowId>,
    arranged: Arranged,
    drag: Option<PointerDrag>,
    panel: CellPanel,
    snapping: bool,
    /// Counts gestures: the operations of one are undone together.
    gesture: u64,
    /// Whether the level is refused for a problem, beside it.
    problems: Vec<(Problem, bool)>,
    /// The row of each problem.
    about: Vec<Option<RowId>>,
    scroll: Scroll,
    level: Option<Arc<Level>>,
    /// The version of the document that was checked, and the time until the next check, s.
    checked: (Option<u64>, f64),
    /// The version that was to be kept beside the files, and its age, s.
    kept: (u64, f64),
    /// Whether that could be done.
    keeps: bool,
    watch: FolderWatch,
    ask: Option<Ask>,
    /// The last remark, and how long it stays, s.
    remark: Option<(String, f64)>,
    repeat: Repeat,
    /// Time since the arrow keys moved something, s.
    nudged: f64,
    /// The gesture of that.
    nudging: u64,
    /// The view that shows all of the level, and the canvas in which it does, until another one is chosen.
    fitted: Option<(EditorView, Frame)>,
    /// Emptied when a file may have changed.
    sheets: RefCell<picture::Sheets>,
    /// The pictures in the level's folder and the game's, as cells name them.
    offered: Vec<String>,
    /// Canvas units.
    pointer: Vec2,
    figures: bool,
    flown: Option<TestFlight>,
}

struct EditorPass {
    pointer: Vec2,
    /// The picture is drawn: a level has thousands of rows, and the pass that acts is not seen.
    draws: bool,
    /// The input is still to be answered: the first pane that answers it closes the pass.
    open: bool,
    request: Option<Request>,
    /// Words to be shown in whole: the pointer is on a place that had no room for them.
    tip: Option<String>,
}

impl EditorPass {
    fn close(&mut self, request: Option<Request>) {
        (self.open, self.request) = (false, request);
    }

    /// A line of text cut to `room`; where the pointer is in the area, the whole line becomes the tip.
    fn cut(&mut self, canvas: &Canvas, text: &str, (area, room): (Area, f32), style: Style) -> String {
        let shown = widgets::cut(canvas, text, room, style);
        if shown != text && area.contains(self.pointer) {
            self.tip = Some(text.to_owned());
        }
        shown
    }
}

impl Screen for Editor {
    fn show(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        let (canvas, input) = (ui.canvas(), ui.input());
        self.lay_out(input);
        self.pass_time(input.frame_time);
        let open = ui.is_live() && self.ask.is_none();
        let mut pass = EditorPass { pointer: input.pointer, draws: input.frame_time == 0.0, open, request: None, tip: None };
        if pass.open {
            self.update_keys(input, &mut pass);
        }
        if pass.draws {
            self.draw_picture(canvas);
            self.draw_flown(canvas);
            canvas.end_layer();
            self.draw_selection(canvas);
            canvas.end_layer();
        }
        self.show_commands(ui, &mut pass);
        self.show_strip(ui, &mut pass);
        self.show_tools(ui, &mut pass);
        self.show_problems(ui, &mut pass);
        self.show_map(ui, &mut pass);
        self.show_panel(ui, &mut pass);
        match pass.open.then(|| self.launch(input)).flatten() {
            None if pass.open => self.update_hand(input),
            launched => pass.request = launched.or(pass.request),
        }
        if self.drag.is_some() {
            ui.capture();
        }
        if let Some(words) = &pass.tip {
            self.draw_banner(canvas, words);
        }
        pass.request.or(self.show_ask(ui))
    }

    fn parent(&self) -> Destination {
        Destination::Levels(Purpose::Edit)
    }

    fn refuse(&mut self, reason: String) {
        self.say(reason);
    }

    fn come_back(&mut self, above: &dyn Screen, _: &mut Session, _: &mut dyn Spectator) {
        if let Some(flight) = above.get() {
            self.take_flight(flight);
        }
    }

    fn write_down(&mut self, _: &mut Session) -> Result<(), String> {
        self.keep()
    }

    fn is_at_risk(&self) -> bool {
        self.is_unsaved() && !(self.keeps && self.kept.0 == self.document.version())
    }

    fn motion(&self, input: &Input) -> Motion {
        if input.holding || input.dragging { Motion::Full } else { Motion::Still }
    }

    fn takes(&self, _: &Path) -> bool {
        !self.is_unsaved()
    }

    /// A large window is left to the picture.
    fn with_words(&self, frame: Frame, settings: &Settings) -> Frame {
        let scale = (f32::from(settings.scale) / 100.0).max(1.0);
        frame.with_legible(layout::text_scale(frame.pixel) * scale)
    }
}

impl Editor {
    /// By the level's name. Errors: a file that cannot be read, in words.
    pub fn take_up(name: &str, session: &mut Session) -> Result<Self, String> {
        session.last_level = Some(name.to_owned());
        match session.brought.take() {
            Some(Brought::Editor(opened)) => opened.map(|opened| Self::new(*opened)),
            _ => Self::open(&session.library.folder(name), session.library.root()),
        }
    }

    /// Images are looked up in that folder, then under `root`. Errors: a file that cannot be read, in words.
    pub fn open(folder: &Path, root: &Path) -> Result<Self, String> {
        LevelFolder::open_to_edit(folder, root).map(Self::new)
    }

    /// The editor of a level whose files are open.
    pub fn new(Opened { document, folder, kept }: Opened) -> Self {
        Self {
            name: folder.name(),
            watch: FolderWatch::new(folder.path().to_path_buf(), Vec::new()),
            kept: (document.version(), 0.0),
            keeps: true,
            ask: kept.map(Ask::Restore),
            remark: None,
            offered: folder.pictures(),
            document,
            folder,
            view: EditorView::default(),
            panes: Panes::default(),
            tool: EditorTool::Select,
            selection: Vec::new(),
            arranged: Arranged::default(),
            drag: None,
            panel: CellPanel::default(),
            snapping: true,
            gesture: 0,
            problems: Vec::new(),
            about: Vec::new(),
            scroll: Scroll::default(),
            level: None,
            checked: (None, 0.0),
            repeat: Repeat::default(),
            nudged: f64::INFINITY,
            nudging: 0,
            fitted: None,
            sheets: RefCell::default(),
            pointer: Vec2::ZERO,
            figures: false,
            flown: None,
        }
    }

    fn lay_out(&mut self, input: &Input) {
        if self.checked.0.is_none() && self.fitted.is_none() {
            // The room for problems is known before the level is fitted.
            self.check();
        }
        self.panes = Panes::new(&input.frame, self.problems.len().min(PROBLEM_LINES));
        self.view.area = self.panes.middle;
        self.pointer = input.pointer;
        let area = self.view.area;
        let untouched = |(view, frame): &(EditorView, Frame)| self.view == EditorView { area, ..*view } && *frame != input.frame;
        if self.fitted.as_ref().is_none_or(untouched) {
            self.show_all();
            self.fitted = Some((self.view, input.frame));
        }
        self.selection.retain(|row| self.document.kind(*row).is_some());
        self.panel.read(&self.document, &self.selection);
    }

    fn pass_time(&mut self, frame_time: f64) {
        // A remark under the pointer is being read.
        if let Some((_, left)) = self.remark.as_mut().filter(|_| !self.panes.bottom.contains(self.pointer)) {
            *left -= frame_time;
            self.remark = self.remark.take().filter(|(_, left)| *left > 0.0);
        }
        self.nudged += frame_time;
        if self.watch.update(frame_time) {
            self.renumber(Self::take_over);
        }
        self.kept.1 += frame_time;
        if self.kept.0 != self.document.version()
            && (self.drag.is_none() || self.kept.1 > KEEP_EVERY)
            && let Err(problem) = self.keep()
        {
            self.say(problem);
        }
        if self.checked.0 != Some(self.document.version()) && self.drag.is_none() {
            self.checked.1 -= frame_time;
            if self.checked.1 <= 0.0 {
                self.check();
            }
        }
    }

    fn shift_selection(&mut self, by: DVec2) {
        if by == DVec2::ZERO {
            return;
        }
        let moved = self.document.with_ends(&self.selection);
        let cells: Vec<SetCell> = moved.iter().flat_map(|row| self.document.shifted(*row, by)).collect();
        self.set(&cells);
    }

    fn set(&mut self, cells: &[SetCell]) {
        self.set_as(cells, self.gesture);
    }

    fn set_as(&mut self, cells: &[SetCell], gesture: u64) {
        let done = self.document.set(cells, Some(gesture));
        self.say_if_refused(done);
    }

    fn say_if_refused(&mut self, done: Result<(), String>) {
        if let Err(refusal) = done {
            self.say(refusal);
        }
    }

    fn say(&mut self, words: impl Into<String>) {
        let words = words.into();
        let time = REMARK + LETTER * words.chars().count() as f64;
        self.remark = Some((words, time));
    }

    /// Brings all of the level, and the things outside of it, into view.
    fn show_all(&mut self) {
        let level = Place { min: DVec2::ZERO, size: self.document.size() };
        let all = self.document.things().fold(level, |all, (_, place)| {
            // A thing kilometres away is a mistake: it shall not make a speck of the level.
            let near = Place { min: level.min - level.size, size: level.size * 3.0 };
            if near.meets(&place) { Place::between(all.min.min(place.min), all.max().max(place.max())) } else { all }
        });
        self.view.fit(&all);
    }

    pub fn document(&self) -> &Document {
        &self.document
    }

    pub fn selection(&self) -> &[RowId] {
        &self.selection
    }

    pub fn name(&self) -> &str {
        &self.name
    }

    /// The loader's problems, and whether the level is refused for each.
    pub fn problems(&self) -> &[(Problem, bool)] {
        &self.problems
    }

    pub fn is_unsaved(&self) -> bool {
        self.folder.is_unsaved(&self.document)
    }

    /// The place on the canvas of a point of the picture, pixels.
    pub fn point(&self, pixels: DVec2) -> Vec2 {
        self.view.point(pixels)
    }
}
