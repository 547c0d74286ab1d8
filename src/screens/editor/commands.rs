//! The commands: the row of buttons above the picture, and the keys that do the same.

use super::{Editor, EditorPass, view};
use super::{ask::Ask, tools::EditorTool};
use crate::draw::layout::{Area, BUTTON_TEXT, DETAILS, TEXT, Vec2};
use crate::level::document::{Clip, Document, Kind, RowId, Table};
use crate::ui::{Ui, WidgetKind, input::Input};
use crate::words::tr;
use crate::{draw::Canvas, draw::Style, physics::DVec2, screens::screen::Request, settings::Key, view::theme, view::widgets};

const COMMANDS: [(&str, &str); 11] = [
    ("Back", "Esc"),
    ("Save", "Ctrl S"),
    ("Undo", "Ctrl Z"),
    ("Redo", "Ctrl Y"),
    ("Copy", "Ctrl D"),
    ("Delete", "Del"),
    ("Snap", "G"),
    ("All", "F"),
    ("Fly", "F5"),
    ("Fly here", "F6"),
    ("Go on", "F7"),
];
const AT_LEFT: usize = 8;
/// Arrow keys within this time are undone together, s.
const BURST: f64 = 1.0;

impl Editor {
    pub(super) fn show_commands(&mut self, ui: &mut Ui<'_>, pass: &mut EditorPass) {
        let canvas = ui.canvas();
        canvas.rectangle(self.panes.top, theme::panel());
        let (areas, name) = self.panes.commands(AT_LEFT, COMMANDS.len() - AT_LEFT);
        let mut pressed = None;
        for ((label, key), area) in COMMANDS.into_iter().zip(&areas) {
            let touch = ui.touch(label, *area, WidgetKind::Tool);
            self.draw_command(canvas, (label, key), *area, touch.hover);
            pressed = pressed.or(touch.pressed.then_some(label));
        }
        self.draw_name(canvas, name, pass);
        if let Some(label) = pressed.filter(|_| pass.open) {
            pass.close(self.command(label));
        }
    }

    fn draw_command(&self, canvas: &Canvas, (label, key): (&str, &str), area: Area, hover: bool) {
        let on = label == "Snap" && self.snapping || label == "Fly here" && self.tool == EditorTool::Fly;
        let fill = if hover { theme::panel_hover() } else { theme::ground() };
        widgets::panel_in(canvas, area, fill, if on { theme::accent() } else { theme::panel_edge() });
        let can = match label {
            "Undo" => self.document.history().0 > 0,
            "Redo" => self.document.history().1 > 0,
            "Copy" | "Delete" => !self.selection.is_empty(),
            "Save" => self.is_unsaved(),
            "Go on" => self.is_stopped(),
            _ => true,
        };
        let colour = if can { theme::text() } else { theme::quiet() };
        let line = |part: f32| area.centre() + Vec2::new(0.0, part * area.size.y);
        widgets::fitted(canvas, tr(label), line(-0.19), area.size.x - 4.0, &[TEXT, DETAILS], colour);
        canvas.text(tr(key), line(0.27), Style::new(DETAILS, theme::quiet()).centred().middle().mono());
    }

    fn draw_name(&self, canvas: &Canvas, area: Area, pass: &mut EditorPass) {
        let unsaved = self.is_unsaved();
        let name = if unsaved { tr!("{level} · not saved", level = self.name) } else { self.name.clone() };
        let colour = if unsaved { theme::accent() } else { theme::text() };
        let name = pass.cut(canvas, &name, (area, area.size.x), Style::new(DETAILS, colour));
        widgets::fitted(canvas, &name, area.centre(), area.size.x, &[BUTTON_TEXT, TEXT, DETAILS], colour);
    }

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
            () if input.pressed(Key::F6) => "Fly here",
            () if input.pressed(Key::F7) => "Go on",
            () if self.panel.typing.is_some() => return,
            () if self.arrange_by_key(input) => return pass.close(None),
            () if with(Key::C) => return self.copy(input, false),
            () if with(Key::X) => return self.copy(input, true),
            () if with(Key::V) => return self.paste(input),
            () if input.pressed(Key::Delete) => "Delete",
            () if !control && input.pressed(Key::G) => "Snap",
            () if !control && input.pressed(Key::F) || input.pressed(Key::Home) => "All",
            () if input.pressed(Key::Escape) && self.tool == EditorTool::Select && self.selection.is_empty() => {
                self.ask = Some(Ask::Leave(self.is_unsaved()));
                return pass.close(None);
            }
            () => "",
        };
        if !command.is_empty() {
            return pass.close(self.command(command));
        }
        if input.pressed(Key::Escape) {
            if self.tool == EditorTool::Select {
                self.selection.clear();
            }
            self.tool = EditorTool::Select;
        }
        if let Some(tool) = EditorTool::all().find(|tool| !control && input.pressed(tool.key())) {
            self.take_tool(tool);
            return pass.close(None);
        }
        if input.pressed(Key::Tab)
            && let Some(first) =
                self.panel.fields.iter().find(|field| self.is_wrong(field.column.name)).or(self.panel.fields.first())
        {
            let first = first.column.name;
            self.gesture += 1;
            self.panel.focus(first, self.gesture);
            return pass.close(None);
        }
        if with(Key::A) {
            self.selection = self.at_hand().map(|(row, _)| row).collect();
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
        // Presses in quick succession are one act, unless another one came between.
        if self.nudged > BURST || self.nudging != self.gesture {
            self.gesture += 1;
            self.nudging = self.gesture;
        }
        self.nudged = 0.0;
        self.shift_selection(by * if input.held(Key::Shift) { 10.0 } else { 1.0 });
    }

    fn command(&mut self, command: &str) -> Option<Request> {
        self.gesture += 1;
        if matches!(command, "Undo" | "Redo") {
            // The file holds another text than the field then.
            self.panel.typing = None;
        }
        match command {
            "Back" if self.is_unsaved() => self.ask = Some(Ask::Leave(true)),
            "Back" => return Some(self.leave()),
            "Save" => drop(self.save()),
            "Undo" => self.turn_back(Document::undo),
            "Redo" => self.turn_back(Document::redo),
            "Copy" => self.double(DVec2::splat(view::GRID * 2.0), None),
            "Delete" => {
                let rows: Vec<RowId> =
                    self.selection.iter().copied().filter(|row| self.document.kind(*row) != Some(Kind::Ship)).collect();
                if rows.len() < self.selection.len() {
                    self.say(tr("A level has a ship: it stays."));
                }
                self.renumber(|editor| {
                    let done = editor.document.remove(&rows);
                    editor.say_if_refused(done);
                });
                self.selection.clear();
            }
            "Snap" => self.snapping = !self.snapping,
            "All" => self.show_all(),
            "Fly here" => return self.fly_here(),
            "Go on" => return self.go_on(),
            _ => return self.fly(None),
        }
        None
    }

    /// Undoes or does again. Where rows came or went, the selection's numbers mean other rows and it ends.
    fn turn_back(&mut self, step: fn(&mut Document) -> bool) {
        let rows = |document: &Document| Table::ALL.iter().map(|table| document.rows(*table).count()).collect::<Vec<_>>();
        let before = rows(&self.document);
        self.renumber(|editor| {
            step(&mut editor.document);
            if rows(&editor.document) != before {
                editor.selection.clear();
            }
        });
    }

    /// Selects copies of the selection, this far from it.
    pub(super) fn double(&mut self, by: DVec2, gesture: Option<u64>) {
        match self.document.duplicate(&self.selection, by, gesture) {
            Ok(rows) if !rows.is_empty() => self.selection = rows,
            Ok(_) => {}
            Err(refusal) => self.say(refusal),
        }
    }

    fn copy(&mut self, input: &Input, cuts: bool) {
        let (text, count) = self.document.copied(&self.selection);
        if count == 0 {
            return self.say(tr("Nothing is selected that can be copied."));
        }
        input.clipboard.keep(text);
        if cuts {
            self.command("Delete");
        }
        self.say(tr!("{count} copied: Ctrl V puts them where the pointer is, here or in another level.", count));
    }

    /// Adds what is in the clipboard, with its middle where the pointer is.
    fn paste(&mut self, input: &Input) {
        let Some(Clip { rows, middle }) = Clip::parse(&input.clipboard.text()) else {
            return self.say(tr("There is nothing to paste."));
        };
        self.gesture += 1;
        let inside = self.panes.middle.contains(input.pointer);
        let at = if inside { self.view.pixels(input.pointer) } else { self.view.visible().centre() };
        match self.document.insert(rows, (at - middle).round(), Some(self.gesture)) {
            Ok(rows) => self.selection = rows,
            Err(refusal) => self.say(refusal),
        }
    }
}
