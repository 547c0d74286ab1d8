//! The level's files: saved, kept beside them, taken over from another program, proven by a flight; and the questions about that.

use super::Editor;
use crate::draw::layout::{Area, GAP, LINE, PADDING, ROW_BUTTON, TEXT, Vec2, wrapped};
use crate::level::document::{Kept, KeptSide, LevelSaveError, Table};
use crate::view::theme;
use crate::{draw::Style, game::Replay, pack, screens::screen::Request, settings::Key, ui::Ui, words::tr};

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

    /// Keeps unsaved edits beside the files, for the next time that the level is edited. Errors: why they would be lost, in words.
    pub(in crate::screens) fn keep(&mut self) -> Result<(), String> {
        if matches!(self.ask, Some(Ask::Restore(_))) {
            // Those that were found lie there, and nothing is edited yet.
            return Ok(());
        }
        self.kept = (self.document.version(), 0.0);
        let kept = self.folder.keep(&self.document);
        self.keeps = kept.is_ok();
        kept.map_err(|error| tr!("The edits cannot be kept beside the files: {error}", error))
    }

    /// Takes over files that another program has written, or asks where both have changed one.
    pub(super) fn take_over(&mut self) {
        let (taken, both) = self.folder.take_over(&mut self.document);
        self.folder.measure(&mut self.document);
        self.offered = self.folder.pictures();
        self.checked.0 = None;
        self.sheets.take();
        if !both.is_empty() {
            self.ask = Some(Ask::Theirs(both));
        } else if taken {
            self.say(tr("Another program has changed the files: they were read again."));
        }
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

    /// Writes a flight down as a proof of its level, and the level with the time for its medal.
    pub(super) fn prove(&mut self, replay: Replay, prize: &str) {
        match pack::prove_in((&mut self.folder, &mut self.document), &prize.to_lowercase(), replay) {
            Ok(path) => {
                self.watch.take();
                self.kept.0 = self.document.version();
                let file = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
                self.say(tr!("Saved, with the flight as flights/{file}.", file));
            }
            Err(problems) => self.say(problems.join(" ")),
        }
    }

    /// Lets one side's files stay, saves where that is this one, and says where the other side's are.
    pub(super) fn settle(&mut self, side: KeptSide) {
        let settled = self.folder.settle(&mut self.document, side);
        self.folder.measure(&mut self.document);
        match settled {
            Ok(copies) => {
                if side == KeptSide::Theirs || self.save() {
                    let left = if copies.is_empty() {
                        String::new()
                    } else {
                        tr!(" The other is kept in {files}.", files = copies.join(", "))
                    };
                    self.say(format!("{}{left}", if side == KeptSide::Mine { tr("Saved.") } else { tr("Theirs it is.") }));
                }
            }
            Err(problem) => self.say(tr!("Nothing was changed: no copy of the other can be kept: {problem}", problem)),
        }
    }
}
