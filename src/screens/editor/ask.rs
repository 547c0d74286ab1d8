//! What the editor has to ask: about edits that were found, that are not saved, or that another program has written over.

use super::Editor;
use crate::draw::layout::{Area, Frame, GAP, LINE, PADDING, ROW_BUTTON, TEXT, Vec2, wrapped};
use crate::level::document::{Kept, KeptSide, Table};
use crate::screens::{Buttons, Input, Key, Request};

/// Width of the panel, at least, and of a letter in it, in heights of text.
const WIDTH: f32 = 640.0;
const LETTER: f32 = 0.5;

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
    /// What it says, as it fits the panel; whether a line belongs to the first sentence.
    lines: Vec<(String, bool)>,
    buttons: Buttons,
}

impl Ask {
    pub fn new(question: Question) -> Self {
        Self { question, panel: Area::default(), lines: Vec::new(), buttons: Buttons::default() }
    }

    /// What it says: what has happened, and what is asked.
    pub fn words(&self) -> [String; 2] {
        match &self.question {
            Question::Restore(_) => {
                ["There are edits that were not saved.".into(), "The game ended before they were; they can be had back.".into()]
            }
            Question::Leave => ["There are edits that are not saved.".into(), "What is to become of them?".into()],
            Question::Theirs(tables) => {
                let files: Vec<&str> = tables.iter().map(|table| table.file()).collect();
                let copies = "A copy of the other is left beside it, and Undo brings it back.";
                [
                    format!("Another program has changed {}.", files.join(", ")),
                    format!(
                        "{} edited here, too. Which is to stay? {copies}",
                        if files.len() == 1 { "It was" } else { "They were" }
                    ),
                ]
            }
        }
    }

    /// The answers.
    pub fn answers(&self) -> &'static [&'static str] {
        match self.question {
            Question::Restore(_) => &["Have them back", "Throw away"],
            Question::Leave => &["Save", "Throw away", "Stay here"],
            Question::Theirs(_) => &["Decide later", "Theirs", "Mine"],
        }
    }

    pub fn buttons(&self) -> &Buttons {
        &self.buttons
    }

    /// The lines that it says.
    pub fn lines(&self) -> &[(String, bool)] {
        &self.lines
    }

    fn place(&mut self, frame: &Frame) {
        let count = self.answers().len() as f32;
        let row = count * (ROW_BUTTON.x + GAP) - GAP;
        let (width, height) = ((row + 4.0 * PADDING).max(WIDTH), frame.text_height(TEXT));
        let columns = ((width - 2.0 * PADDING) / (LETTER * height)) as usize;
        let [first, second] = self.words().map(|words| wrapped(&words, columns, 0));
        self.lines = first.into_iter().map(|line| (line, true)).chain(second.into_iter().map(|line| (line, false))).collect();
        let words = self.lines.len() as f32 * LINE * height;
        self.panel = Area::around(frame.size / 2.0, Vec2::new(width, words + ROW_BUTTON.y + 4.5 * PADDING));
        let at = Vec2::new(self.panel.centre().x - row / 2.0, self.panel.max().y - 1.5 * PADDING - ROW_BUTTON.y);
        let button = |i: usize| Area { min: at + Vec2::new(i as f32 * (ROW_BUTTON.x + GAP), 0.0), size: ROW_BUTTON };
        self.buttons.place((0..self.answers().len()).map(button).collect());
    }
}

impl Editor {
    /// One frame of the question.
    pub(super) fn update_ask(&mut self, input: &Input) -> Option<Request> {
        let ask = self.ask.as_mut()?;
        ask.place(&input.frame);
        if input.pressed(Key::Escape) && !matches!(ask.question, Question::Restore(_)) {
            self.ask = None;
            return None;
        }
        let answer = ask.buttons.update(input)?;
        match (self.ask.take()?.question, answer) {
            (Question::Restore(kept), 0) => self.document.restore(kept),
            (Question::Restore(_), _) => self.folder.forget(),
            (Question::Leave, 0) => return self.save().then(|| self.leave()),
            (Question::Leave, 1) => return Some(self.leave()),
            (Question::Leave, _) => {}
            (Question::Theirs(_), 0) => self.say("Both stay as they are until it is saved."),
            (Question::Theirs(_), answer) => self.settle(if answer == 1 { KeptSide::Theirs } else { KeptSide::Mine }),
        }
        None
    }

    /// Lets one side's files stay, saves where that is this one, and says where the other side's are.
    fn settle(&mut self, side: KeptSide) {
        let settled = self.folder.settle(&mut self.document, side);
        self.folder.measure(&mut self.document);
        match settled {
            Ok(copies) => {
                if side == KeptSide::Theirs || self.save() {
                    let left =
                        if copies.is_empty() { String::new() } else { format!(" The other is kept in {}.", copies.join(", ")) };
                    self.say(format!("{}{left}", if side == KeptSide::Mine { "Saved." } else { "Theirs it is." }));
                }
            }
            Err(problem) => self.say(format!("Nothing was changed: no copy of the other can be kept: {problem}")),
        }
    }
}
