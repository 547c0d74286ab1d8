//! What the editor has to ask: about edits that were found, that are not saved, or that another program has written over.

use super::Editor;
use crate::level::document::{Kept, Table};
use crate::screens::{Buttons, Input, Key, Request};
use crate::view::layout::{Area, GAP, PADDING, ROW_BUTTON, Vec2};

/// What is asked.
#[derive(Clone, Debug)]
pub enum Question {
    /// Edits were found that were not saved before the program ended.
    Restore(Kept),
    /// The editor is left, and not all is saved.
    Leave,
    /// Another program has changed these files, which were edited here, too.
    Theirs(Vec<Table>),
}

/// A question and its answers.
#[derive(Clone, Debug)]
pub struct Ask {
    pub question: Question,
    pub panel: Area,
    buttons: Buttons,
}

impl Ask {
    pub fn new(question: Question) -> Self {
        Self { question, panel: Area::default(), buttons: Buttons::default() }
    }

    /// What it says, on two lines.
    pub fn words(&self) -> [String; 2] {
        match &self.question {
            Question::Restore(_) => {
                ["There are edits that were not saved.".into(), "The game ended before they were; they can be had back.".into()]
            }
            Question::Leave => ["There are edits that are not saved.".into(), "What is to become of them?".into()],
            Question::Theirs(tables) => {
                let files: Vec<&str> = tables.iter().map(|table| table.file()).collect();
                [format!("Another program has changed {}.", files.join(", ")), "It was edited here, too: which is to stay?".into()]
            }
        }
    }

    /// The answers.
    pub fn answers(&self) -> &'static [&'static str] {
        match self.question {
            Question::Restore(_) => &["Have them back", "Throw away"],
            Question::Leave => &["Save", "Throw away", "Stay here"],
            Question::Theirs(_) => &["Mine", "Theirs"],
        }
    }

    pub fn buttons(&self) -> &Buttons {
        &self.buttons
    }

    fn place(&mut self, size: Vec2) {
        let count = self.answers().len() as f32;
        let row = count * (ROW_BUTTON.x + GAP) - GAP;
        self.panel = Area::around(size / 2.0, Vec2::new((row + 4.0 * PADDING).max(640.0), 208.0));
        let at = Vec2::new(self.panel.centre().x - row / 2.0, self.panel.max().y - 1.5 * PADDING - ROW_BUTTON.y);
        let button = |i: usize| Area { min: at + Vec2::new(i as f32 * (ROW_BUTTON.x + GAP), 0.0), size: ROW_BUTTON };
        self.buttons.place((0..self.answers().len()).map(button).collect());
    }
}

impl Editor {
    /// One frame of the question.
    pub(super) fn update_ask(&mut self, input: &Input) -> Option<Request> {
        let ask = self.ask.as_mut()?;
        ask.place(input.frame.size);
        if input.pressed(Key::Escape) && matches!(ask.question, Question::Leave) {
            self.ask = None;
            return None;
        }
        let answer = ask.buttons.update(input)?;
        match (self.ask.take()?.question, answer) {
            (Question::Restore(kept), 0) => self.document.restore(kept),
            (Question::Restore(_), _) => self.folder.forget(),
            (Question::Leave, 0) => return self.save(false).then(|| self.leave()),
            (Question::Leave, 1) => return Some(self.leave()),
            (Question::Leave, _) => {}
            (Question::Theirs(_), 0) => drop(self.save(true)),
            (Question::Theirs(_), _) => {
                self.folder.take_over(&mut self.document, true);
                self.folder.measure(&mut self.document);
            }
        }
        None
    }
}
