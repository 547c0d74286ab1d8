//! The editor's questions: about edits that were found, that are not saved, or that another program has written over.

use super::Editor;
use crate::draw::Style;
use crate::draw::layout::{Area, GAP, LINE, PADDING, ROW_BUTTON, TEXT, Vec2, wrapped};
use crate::game::Replay;
use crate::level::document::{Kept, KeptSide, Table};
use crate::screens::screen::Request;
use crate::settings::Key;
use crate::ui::Ui;
use crate::view::theme;
use crate::words::tr;

/// Width of the panel, at least, canvas units, and of a letter in it, in heights of text.
const WIDTH: f32 = 640.0;
const LETTER: f32 = 0.5;

#[derive(Clone, Debug)]
pub enum Ask {
    /// Edits were found that were not saved before the program ended.
    Restore(Kept),
    /// The editor is left, and whether something is not saved.
    Leave(bool),
    /// Another program has changed these files, which were edited here, too.
    Theirs(Vec<Table>),
    /// A test flight was completed; its end in words.
    Prove(Box<Replay>, String),
}

impl Ask {
    /// The event and the question, a sentence each.
    fn words(&self) -> [String; 2] {
        match self {
            Self::Restore(_) => [
                tr("There are edits that were not saved.").into(),
                tr("The game ended before they were; they can be had back.").into(),
            ],
            Self::Prove(_, end) => [end.clone(), tr("What is this flight to prove? It is saved beside the level.").into()],
            Self::Leave(false) => [tr("All is saved.").into(), tr("Back to where the editor was opened?").into()],
            Self::Leave(true) => [tr("There are edits that are not saved.").into(), tr("What is to become of them?").into()],
            Self::Theirs(tables) => {
                let files: Vec<&str> = tables.iter().map(|table| table.file()).collect();
                let edited = if files.len() == 1 {
                    "It was edited here, too. Which is to stay? A copy of the other is left beside it, and Undo brings it back."
                } else {
                    "They were edited here, too. Which are to stay? A copy of the others is left beside them, and Undo brings them back."
                };
                [tr!("Another program has changed {files}.", files = files.join(", ")), tr(edited).to_owned()]
            }
        }
    }

    /// The first one harms nothing: Enter presses it.
    fn answers(&self) -> &'static [&'static str] {
        match self {
            Self::Restore(_) => &["Have them back", "Throw away"],
            Self::Leave(false) => &["Leave", "Stay here"],
            Self::Leave(true) => &["Save", "Throw away", "Stay here"],
            Self::Theirs(_) => &["Decide later", "Theirs", "Mine"],
            Self::Prove(..) => &["Nothing", "Gold", "Silver", "Careful", "Mark"],
        }
    }

    /// Shows the panel above all else; the answer.
    fn show(&self, ui: &mut Ui<'_>) -> Option<&'static str> {
        let (answers, height) = (self.answers(), ui.frame().text_height(TEXT));
        let row = answers.len() as f32 * (ROW_BUTTON.x + GAP) - GAP;
        let width = (row + 4.0 * PADDING).max(WIDTH);
        let columns = ((width - 2.0 * PADDING) / (LETTER * height)) as usize;
        let [first, second] = self.words().map(|words| wrapped(&words, columns, 0));
        let lines = first.iter().map(|line| (line, theme::text())).chain(second.iter().map(|line| (line, theme::quiet())));
        let words = (first.len() + second.len()) as f32 * LINE * height;
        let panel = Area::around(ui.frame().size / 2.0, Vec2::new(width, words + ROW_BUTTON.y + 4.5 * PADDING));
        ui.layer(0.6);
        ui.panel(panel);
        let top = Vec2::new(panel.centre().x, panel.min.y + 1.5 * PADDING);
        for (i, (line, colour)) in lines.enumerate() {
            ui.text(line, top + Vec2::new(0.0, i as f32 * LINE * height), Style::new(TEXT, colour).centred());
        }
        ui.buttons(ui.frame().row(answers.len(), panel.max().y - 1.5 * PADDING - ROW_BUTTON.y), answers)
    }
}

impl Editor {
    pub(super) fn show_ask(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        let ask = self.ask.as_ref()?;
        let answer = ask.show(ui);
        if ui.key(Key::Escape) && !matches!(ask, Ask::Restore(_)) {
            self.ask = None;
            return None;
        }
        match (answer.and_then(|_| self.ask.take())?, answer?) {
            (Ask::Restore(kept), "Have them back") => self.document.restore(kept),
            (Ask::Restore(_), _) => self.folder.forget(),
            (Ask::Leave(_), "Save") => return self.save().then(|| self.leave()),
            (Ask::Leave(_), "Leave" | "Throw away") => return Some(self.leave()),
            (Ask::Leave(_), _) => {}
            (Ask::Theirs(_), "Theirs") => self.settle(KeptSide::Theirs),
            (Ask::Theirs(_), "Mine") => self.settle(KeptSide::Mine),
            (Ask::Prove(..), "Nothing") => {}
            (Ask::Prove(replay, _), prize) => self.prove(*replay, prize),
            (Ask::Theirs(_), _) => self.say(tr("Both stay as they are until it is saved.")),
        }
        None
    }
}
