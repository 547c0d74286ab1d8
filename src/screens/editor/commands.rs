//! The commands: the row of buttons above the picture, the tools beside it, and the keys that do the same.

use super::ask::Ask;
use super::layout::INSIDE;
use super::picture::{colour, edge};
use super::{Editor, EditorPass, EditorTool, view};
use crate::draw::layout::{Area, BUTTON_TEXT, DETAILS, TEXT, Vec2};
use crate::draw::{Canvas, Style};
use crate::level::Level;
use crate::level::document::{Document, Kind, LevelSaveError, RowId, Table};
use crate::physics::DVec2;
use crate::screens::screen::{Destination, Request};
use crate::settings::Key;
use crate::ui::input::Input;
use crate::ui::{Ui, WidgetKind};
use crate::view::{theme, widgets};
use crate::words::tr;
use std::sync::Arc;

const COMMANDS: [(&str, &str); 9] = [
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
const AT_LEFT: usize = 8;

impl Editor {
    pub(super) fn show_commands(&mut self, ui: &mut Ui<'_>, pass: &mut EditorPass) {
        let canvas = ui.canvas();
        canvas.rectangle(self.panes.top, theme::panel());
        let areas = self.panes.commands(AT_LEFT, COMMANDS.len() - AT_LEFT);
        let mut pressed = None;
        for ((label, key), area) in COMMANDS.into_iter().zip(&areas) {
            let touch = ui.touch(label, *area, WidgetKind::Tool);
            self.draw_command(canvas, (label, key), *area, touch.hover);
            pressed = pressed.or(touch.pressed.then_some(label));
        }
        self.draw_name(canvas, (areas[AT_LEFT - 1].max().x, areas[AT_LEFT].min.x), pass);
        if let Some(label) = pressed.filter(|_| pass.open) {
            pass.close(self.command(label));
        }
    }

    fn draw_command(&self, canvas: &Canvas, (label, key): (&str, &str), area: Area, hover: bool) {
        let on = label == "Snap" && self.snapping;
        let fill = if hover { theme::panel_hover() } else { theme::ground() };
        widgets::panel_in(canvas, area, fill, if on { theme::accent() } else { theme::panel_edge() });
        let can = match label {
            "Undo" => self.document.history().0 > 0,
            "Redo" => self.document.history().1 > 0,
            "Copy" | "Delete" => !self.selection.is_empty(),
            "Save" => self.is_unsaved(),
            _ => true,
        };
        let colour = if can { theme::text() } else { theme::quiet() };
        let line = |part: f32| area.centre() + Vec2::new(0.0, part * area.size.y);
        widgets::fitted(canvas, tr(label), line(-0.19), area.size.x - 4.0, &[TEXT, DETAILS], colour);
        canvas.text(tr(key), line(0.27), Style::new(DETAILS, theme::quiet()).centred().middle().mono());
    }

    fn draw_name(&self, canvas: &Canvas, (from, to): (f32, f32), pass: &mut EditorPass) {
        let unsaved = self.is_unsaved();
        let name = if unsaved { tr!("{level} · not saved", level = self.name) } else { self.name.clone() };
        let colour = if unsaved { theme::accent() } else { theme::text() };
        let middle = Vec2::new((from + to) / 2.0, self.panes.top.centre().y);
        let room = to - from - 2.0 * INSIDE;
        let area = Area::around(middle, Vec2::new(room, self.panes.top.size.y));
        let name = pass.cut(canvas, &name, (area, room), Style::new(DETAILS, colour));
        widgets::fitted(canvas, &name, middle, room, &[BUTTON_TEXT, TEXT, DETAILS], colour);
    }

    pub(super) fn show_tools(&mut self, ui: &mut Ui<'_>, pass: &EditorPass) {
        let canvas = ui.canvas();
        canvas.rectangle(self.panes.left, theme::panel());
        let tools = [EditorTool::Select].into_iter().chain(Kind::ADDED.map(EditorTool::Add));
        for (tool, area) in tools.zip(self.panes.tools(Kind::ADDED.len() + 1)) {
            let (label, colour) = match tool {
                EditorTool::Select => ("Select", theme::text()),
                EditorTool::Add(kind) => (kind.name(), colour(kind)),
            };
            let touch = ui.touch(label, area, WidgetKind::Tool);
            if touch.pressed && pass.open {
                self.tool = tool;
            }
            let ground = if touch.hover { theme::panel_hover() } else { theme::ground() };
            widgets::panel_in(canvas, area, ground, if tool == self.tool { theme::accent() } else { theme::panel_edge() });
            let mark = Area::around(Vec2::new(area.min.x + 16.0, area.centre().y), Vec2::new(14.0, 10.0));
            if tool == EditorTool::Select {
                edge(canvas, mark, 0.75, colour);
            } else {
                canvas.rectangle(mark, colour);
            }
            let at = Vec2::new(mark.max().x + INSIDE, area.centre().y);
            canvas.text(tr(label), at, Style::new(DETAILS, theme::text()).middle());
        }
    }

    /// Keys, where the keyboard is in no field.
    pub(super) fn update_keys(&mut self, input: &Input, pass: &mut EditorPass) {
        self.figures ^= input.pressed(Key::F3);
        let control = input.held(Key::Control);
        let with = |key: Key| control && input.pressed(key);
        let command = match () {
            () if with(Key::S) => "Save",
            () if with(Key::Z) && input.held(Key::Shift) => "Redo",
            () if with(Key::Z) => "Undo",
            () if with(Key::Y) => "Redo",
            () if with(Key::D) => "Copy",
            () if input.pressed(Key::F5) => "Fly",
            () if self.panel.typing.is_some() => return,
            () if input.pressed(Key::Delete) => "Delete",
            () if input.pressed(Key::G) => "Snap",
            () if input.pressed(Key::F) || input.pressed(Key::Home) => "All",
            () if input.pressed(Key::Escape) && self.tool == EditorTool::Select && self.selection.is_empty() => "Back",
            () => "",
        };
        if !command.is_empty() {
            return pass.close(self.command(command));
        }
        if input.pressed(Key::Escape) {
            self.tool = EditorTool::Select;
            self.selection.clear();
        }
        if input.pressed(Key::Tab)
            && let Some(first) =
                self.panel.fields.iter().find(|field| self.is_wrong(field.column.name)).or(self.panel.fields.first())
        {
            let first = first.column.name;
            self.next_gesture();
            self.panel.focus(first, self.gesture);
            return pass.close(None);
        }
        if with(Key::A) {
            self.selection = self.document.things().map(|(row, _)| row).collect();
        }
        self.nudge(input);
    }

    /// The arrow keys move the selection by a pixel, with Shift by ten; or the view, where it is empty.
    fn nudge(&mut self, input: &Input) {
        let arrows = [(Key::Left, DVec2::NEG_X), (Key::Right, DVec2::X), (Key::Up, DVec2::NEG_Y), (Key::Down, DVec2::Y)];
        let strokes = self.repeat.strokes(input, &arrows.map(|(key, _)| key));
        let by: DVec2 = strokes.iter().filter_map(|key| arrows.iter().find(|(arrow, _)| arrow == key)).map(|(_, by)| *by).sum();
        if by == DVec2::ZERO {
            return;
        }
        if self.selection.is_empty() {
            return self.view.pan((by * -60.0).as_vec2());
        }
        if arrows.iter().any(|(key, _)| input.pressed(*key)) {
            self.next_gesture();
        }
        self.shift_selection(by * if input.held(Key::Shift) { 10.0 } else { 1.0 });
    }

    fn command(&mut self, command: &str) -> Option<Request> {
        self.next_gesture();
        if matches!(command, "Undo" | "Redo") {
            // The file holds another text than the field then.
            self.panel.typing = None;
        }
        match command {
            "Back" if self.folder.is_unsaved(&self.document) => self.ask = Some(Ask::Leave),
            "Back" => return Some(self.leave()),
            "Save" => drop(self.save()),
            "Undo" => self.turn_back(Document::undo),
            "Redo" => self.turn_back(Document::redo),
            "Copy" => {
                let by = DVec2::splat(view::GRID * 2.0);
                match self.document.duplicate(&self.selection, by) {
                    Ok(rows) if !rows.is_empty() => self.selection = rows,
                    Ok(_) => {}
                    Err(refusal) => self.say(refusal),
                }
            }
            "Delete" => {
                let rows: Vec<RowId> =
                    self.selection.iter().copied().filter(|row| self.document.kind(*row) != Some(Kind::Ship)).collect();
                if rows.len() < self.selection.len() {
                    self.say(tr("A level has a ship: it stays."));
                }
                let done = self.document.remove(&rows);
                self.say_if_refused(done);
                self.selection.clear();
            }
            "Snap" => self.snapping = !self.snapping,
            "All" => self.show_all(),
            _ => return self.fly(),
        }
        None
    }

    /// Undoes or does again. Where rows came or went, the selection's numbers mean other rows and it ends.
    fn turn_back(&mut self, step: fn(&mut Document) -> bool) {
        let rows = |document: &Document| Table::ALL.iter().map(|table| document.rows(*table).count()).collect::<Vec<_>>();
        let before = rows(&self.document);
        step(&mut self.document);
        if rows(&self.document) != before {
            self.selection.clear();
        }
    }

    /// Flies the level as it is in memory, or as much of it as loads.
    fn fly(&mut self) -> Option<Request> {
        if self.checked.0 != Some(self.document.version()) {
            self.check();
        }
        if let Some(level) = &self.level {
            return Some(try_out(level.clone(), Vec::new()));
        }
        match self.folder.unfinished(&self.document) {
            Ok(loaded) => {
                let refused = self.problems.iter().filter(|(_, refused)| *refused);
                let left = refused.map(|(problem, _)| problem.to_string()).collect();
                return Some(try_out(Arc::new(loaded.level), left));
            }
            Err(problems) => {
                let first = problems.first().map(ToString::to_string).unwrap_or_default();
                self.say(tr!("It cannot be flown until this is mended: {first}", first));
            }
        }
        None
    }

    pub(super) fn leave(&self) -> Request {
        self.folder.forget();
        Request::Pop
    }

    /// Writes the files; whether that could be done.
    pub(super) fn save(&mut self) -> bool {
        match self.folder.save(&self.document) {
            Ok(()) => {
                self.watch.take();
                self.kept.0 = self.document.version();
                self.say(tr("Saved."));
                true
            }
            Err(LevelSaveError::Changed(tables)) => {
                self.ask = Some(Ask::Theirs(tables));
                false
            }
            Err(error) => {
                self.say(error.to_string());
                false
            }
        }
    }
}

fn try_out(level: Arc<Level>, problems: Vec<String>) -> Request {
    Request::Push(Destination::TryOut { level, problems, in_memory: true })
}
