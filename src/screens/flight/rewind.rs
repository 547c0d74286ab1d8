//! Rewinding: while its key is held the flight runs backwards, up to its start. From there it goes on as practice: not ranked, not proven.

use super::Flight;
use crate::settings::Action;
use crate::ui::Spectator;
use crate::ui::input::Input;
use crate::words::tr;
use std::sync::Arc;

/// The pace backwards at first and at most, and its growth in a second; 1 is the pace of the flight.
const PACES: [f64; 2] = [1.0, 4.0];
const GROWTH: f64 = 1.5;

/// Whether the flight has been rewound, and for how long the key has been held, s.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Rewind {
    pub practice: bool,
    pub held: Option<f64>,
}

impl Flight {
    /// A frame with the key of rewinding; whether it is held. The attempt before, if that was just lost, comes back by it.
    pub(super) fn rewind(&mut self, input: &Input, spectator: &mut dyn Spectator) -> bool {
        let may = self.is_by_hand() && self.run.what_if.is_none() && !self.seen.observer.frozen();
        if !may || !input.keeps(Action::Rewind) {
            self.pilot.rewind.held = None;
            return false;
        }
        self.bring_back_lost();
        let held = self.pilot.rewind.held.unwrap_or(0.0) + input.frame_time;
        self.pilot.rewind = Rewind { practice: true, held: Some(held) };
        self.run.assisted = true;
        self.let_go();
        self.pilot.clock.add(input.frame_time * (PACES[0] + GROWTH * held).min(PACES[1]));
        let back = std::iter::from_fn(|| self.pilot.clock.tick().then_some(())).count() as u64;
        if back > 0 {
            self.show_moment(self.run.game.ticks().saturating_sub(back), spectator);
            if let Some(race) = &mut self.run.race {
                race.back_to(&self.run.game);
            }
        }
        true
    }

    /// Takes the attempt that was lost in place of the one that has not begun yet.
    fn bring_back_lost(&mut self) {
        let Some(flown) = self.run.lost.take_if(|_| self.run.game.is_idle()).and_then(|lost| lost.into_flown()) else { return };
        if Arc::ptr_eq(&flown.level, &self.run.attempt.level) {
            self.run.history = flown.history.clone();
            self.run.game = self.run.history.at(u64::MAX);
        }
    }

    /// The words about it, while the flight is rewound and after that.
    pub(super) fn rewind_words(&self, keys: &crate::settings::Bindings) -> Option<String> {
        let restart = keys.label(Action::Restart);
        match self.pilot.rewind {
            Rewind { held: Some(_), .. } => Some(tr("Rewinding: let go to fly on from here").to_owned()),
            Rewind { practice: true, .. } => {
                Some(tr!("Practice after a rewind, not ranked: {restart} flies for the score", restart))
            }
            Rewind { .. } => None,
        }
    }
}
