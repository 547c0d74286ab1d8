//! The curves as files.

use super::Plot;
use super::panel::Format;
use crate::files::INPUTS;
use crate::game::Game;
use crate::instruments::export::{self, Exported};
use crate::session::new_file::NewFile;
use crate::view::paper;
use crate::words::tr;

impl Plot {
    pub(super) fn make_file(&mut self, format: Format, game: &Game) {
        let curves: Vec<Exported> = self
            .shown()
            .map(|(number, line, track)| Exported {
                body: self.name(line.whose),
                curve: &line.now,
                track,
                number,
                fit: self.fit().filter(|_| number == self.selected),
            })
            .collect();
        if curves.is_empty() {
            self.message = Some((tr("There is no curve to be exported.").to_owned(), true));
            return;
        }
        let (text, ending) = match format {
            Format::Csv => (export::csv(&curves), ".csv"),
            Format::Svg => (paper::curves(&game.level().title, &export::sheet(self.window(), &curves)), ".svg"),
        };
        let stem = export::stem(&self.level, &curves);
        self.export = Some(NewFile { stem, ending, text, what: tr("the curves"), same_up_to: INPUTS });
    }
}
