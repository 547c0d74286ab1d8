//! The level's files: saved, kept beside them, taken over from another program, and a flight that proves them.

use super::Editor;
use super::ask::Ask;
use crate::game::Replay;
use crate::level::document::{KeptSide, LevelSaveError};
use crate::pack;
use crate::screens::screen::Request;
use crate::words::tr;

impl Editor {
    /// Keeps unsaved edits beside the files, for the next time that the level is edited.
    /// Errors: why they would be lost, in words.
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

    /// Whether no edit is lost when the program ends now.
    pub(in crate::screens) fn is_kept(&self) -> bool {
        !self.is_unsaved() || self.keeps && self.kept.0 == self.document.version()
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
