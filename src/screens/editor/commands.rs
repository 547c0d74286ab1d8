//! What keys and the row of commands do.

use super::ask::{Ask, Question};
use super::{Editor, Tool, snap};
use crate::level::document::{Document, Kind, RowId, SaveError, Table};
use crate::physics::DVec2;
use crate::screens::{Input, Key, Request};
use std::sync::Arc;

impl Editor {
    /// Keys, where the keyboard is in no field; whether one of them was all that this frame is for, and what it asks for.
    pub(super) fn update_keys(&mut self, input: &Input) -> Option<(Option<Request>,)> {
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
            () if self.panel.is_typing() => return None,
            () if input.pressed(Key::Delete) => "Delete",
            () if input.pressed(Key::G) => "Snap",
            () if input.pressed(Key::F) || input.pressed(Key::Home) => "All",
            () if input.pressed(Key::Escape) && self.tool == Tool::Select && self.selection.is_empty() => "Back",
            () => "",
        };
        if !command.is_empty() {
            return Some((self.command(command),));
        }
        if input.pressed(Key::Escape) {
            self.tool = Tool::Select;
            self.select(Vec::new());
        }
        if input.pressed(Key::Tab)
            && let Some(first) = self.panel.fields.iter().find(|field| self.is_wrong(field.name)).or(self.panel.fields.first())
        {
            let first = first.name;
            self.next_gesture();
            self.panel.focus(first, self.gesture);
            return Some((None,));
        }
        if with(Key::A) {
            self.select(self.document.things().map(|(row, _)| row).collect());
        }
        self.nudge(input);
        None
    }

    /// The arrow keys move what is selected by a pixel, with Shift by ten; or the view, where nothing is.
    fn nudge(&mut self, input: &Input) {
        let arrows = [(Key::Left, DVec2::NEG_X), (Key::Right, DVec2::X), (Key::Up, DVec2::NEG_Y), (Key::Down, DVec2::Y)];
        let strokes = self.repeat.strokes(input, &arrows.map(|(key, _)| key));
        let way: DVec2 = strokes.iter().filter_map(|key| arrows.iter().find(|(arrow, _)| arrow == key)).map(|(_, way)| *way).sum();
        if way == DVec2::ZERO {
            return;
        }
        if self.selection.is_empty() {
            return self.view.pan((way * -60.0).as_vec2());
        }
        if arrows.iter().any(|(key, _)| input.pressed(*key)) {
            self.next_gesture();
        }
        self.shift_selection(way * if input.held(Key::Shift) { 10.0 } else { 1.0 });
    }

    pub(super) fn command(&mut self, command: &str) -> Option<Request> {
        self.next_gesture();
        if matches!(command, "Undo" | "Redo") {
            // What is in the field is not what is in the file any more.
            self.panel.typing = None;
        }
        match command {
            "Back" if self.folder.is_unsaved(&self.document) => self.ask = Some(Ask::new(Question::Leave)),
            "Back" => return Some(self.leave()),
            "Save" => drop(self.save()),
            "Undo" => self.turn_back(Document::undo),
            "Redo" => self.turn_back(Document::redo),
            "Copy" => {
                let by = DVec2::splat(snap::GRID * 2.0);
                match self.document.duplicate(&self.selection, by) {
                    Ok(rows) if !rows.is_empty() => self.select(rows),
                    Ok(_) => {}
                    Err(refusal) => self.say(refusal),
                }
            }
            "Delete" => {
                let rows: Vec<RowId> =
                    self.selection.iter().copied().filter(|row| self.document.kind(*row) != Some(Kind::Ship)).collect();
                if rows.len() < self.selection.len() {
                    self.say("A level has a ship: it stays.");
                }
                let done = self.document.remove(&rows);
                self.tell(done);
                self.select(Vec::new());
            }
            "Snap" => self.snapping = !self.snapping,
            "All" => self.show_all(),
            _ => return self.fly(),
        }
        None
    }

    /// Undoes or does again. Where rows came or went, what is selected would be others.
    fn turn_back(&mut self, way: fn(&mut Document) -> bool) {
        let rows = |document: &Document| Table::ALL.iter().map(|table| document.rows(*table).count()).collect::<Vec<_>>();
        let before = rows(&self.document);
        way(&mut self.document);
        if rows(&self.document) != before {
            self.select(Vec::new());
        }
    }

    /// The level as it is in memory is flown, or as much of it as there is.
    fn fly(&mut self) -> Option<Request> {
        if self.checked.0 != Some(self.document.version()) {
            self.check();
        }
        if let Some(level) = &self.level {
            return Some(Request::TestFly(level.clone(), Vec::new()));
        }
        match self.folder.unfinished(&self.document) {
            Ok(loaded) => {
                let refused = self.problems.iter().filter(|(_, refused)| *refused);
                let left = refused.map(|(problem, _)| problem.to_string()).collect();
                return Some(Request::TestFly(Arc::new(loaded.level), left));
            }
            Err(problems) => {
                let first = problems.first().map(ToString::to_string).unwrap_or_default();
                self.say(format!("It cannot be flown until this is mended: {first}"));
            }
        }
        None
    }

    /// Says how a test flight ended.
    pub fn tell_of_flight(&mut self, how: String) {
        self.say(how);
    }

    pub(super) fn leave(&self) -> Request {
        self.folder.forget();
        Request::LeaveEditor
    }

    /// Writes the files; whether that could be done.
    pub(super) fn save(&mut self) -> bool {
        match self.folder.save(&self.document) {
            Ok(()) => {
                self.watch.take();
                self.kept.0 = self.document.version();
                self.say("Saved.");
                true
            }
            Err(SaveError::Changed(tables)) => {
                self.ask = Some(Ask::new(Question::Theirs(tables)));
                false
            }
            Err(error) => {
                self.say(error.to_string());
                false
            }
        }
    }
}
