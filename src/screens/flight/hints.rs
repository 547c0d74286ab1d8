//! Hints of a level: one at a time, on demand, for a player who has lost it a few times.

use super::Flight;
use crate::draw::layout::{Area, DETAILS, LINE, PADDING, TEXT, Vec2};
use crate::game::Outcome;
use crate::ui::Ui;
use crate::view::theme;
use crate::words::tr;

/// Losses of a level before its hints are offered.
const LOSSES: u32 = 3;
/// A restart after this time on the clock, s, is a loss too: a level without hazards has no other.
const GIVEN_UP: f64 = 10.0;

/// The losses of the level in this sitting, and the number of hints given since its flights began.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Hints {
    losses: u32,
    given: usize,
}

impl Hints {
    pub const fn note_losses(&mut self, losses: u32) {
        self.losses = losses;
    }
}

impl Flight {
    /// Whether a restart now counts as a loss.
    pub(in crate::screens) fn is_given_up(&self) -> bool {
        let counts = self.is_by_hand() && !self.open.test && self.run.what_if.is_none();
        counts && self.run.game.outcome() == Outcome::Running && !self.run.game.is_idle() && self.run.game.time() >= GIVEN_UP
    }

    /// Whether a hint is left to be given.
    pub(super) fn offers_hint(&self) -> bool {
        self.open.hints.losses >= LOSSES && self.open.hints.given < self.run.attempt.level.hints.len()
    }

    pub(super) const fn give_hint(&mut self) {
        self.open.hints.given += 1;
    }

    /// The hints that were given, above the pause panel whose top is at `foot`.
    pub(super) fn show_hints(&self, ui: &Ui<'_>, foot: f32) {
        let given: Vec<&String> = self.run.attempt.level.hints.iter().take(self.open.hints.given).collect();
        if given.is_empty() {
            return;
        }
        let (frame, line) = (ui.frame(), ui.frame().text_height(TEXT) * LINE);
        let size = Vec2::new((frame.size.x - 2.0 * PADDING).min(960.0), given.len() as f32 * line + PADDING);
        let top = (foot - PADDING - size.y).max(PADDING);
        ui.panel(Area { min: Vec2::new((frame.size.x - size.x) / 2.0, top), size });
        for (i, hint) in given.into_iter().enumerate() {
            let middle = Vec2::new(frame.size.x / 2.0, top + 0.5 * PADDING + (i as f32 + 0.5) * line);
            ui.fitted(tr(hint), middle, &[TEXT, DETAILS], theme::accent());
        }
    }
}
