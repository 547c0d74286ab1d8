//! The observer of a flight stops the world, takes it a tick on or back, sets its pace, and picks out the bodies that the details are about.

use super::instruments::Instruments;
use crate::settings::{Action, Bindings, Key};
use crate::view::focus::Focus;
use crate::{game::Game, number::seconds, ui::input::Input, words::tr};

/// Paces of the world; 1 is the usual one.
pub const PACES: [f64; 10] = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 4.0, 8.0];

/// A key brings the view closer by this many notches of the wheel.
const KEY_ZOOM: i8 = 2;

/// 1 for more, −1 for less, 0 for neither.
fn more_or_less(input: &Input) -> i8 {
    i8::from(input.acts(Action::Closer)) - i8::from(input.acts(Action::Wider))
}

/// What is seen of a flight beside its game: the observer, the overlays, the instruments.
#[derive(Debug, Default)]
pub(super) struct Observation {
    pub observer: Observer,
    pub details: bool,
    pub picture: bool,
    pub hitboxes: bool,
    pub instruments: Instruments,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Observer {
    pub(super) frozen: bool,
    paces: &'static [f64],
    pace: usize,
    pub(super) focus: Focus,
    map: bool,
    keys: Bindings,
}

impl Default for Observer {
    fn default() -> Self {
        Self::with_paces(&PACES)
    }
}

impl Observer {
    pub(super) fn with_paces(paces: &'static [f64]) -> Self {
        let pace = paces.iter().position(|pace| *pace == 1.0).unwrap_or(0);
        Self { frozen: false, paces, pace, focus: Focus::default(), map: false, keys: Bindings::default() }
    }

    /// One frame of a game whose details are open or not; returns the ticks that a frozen world goes on, or back where negative.
    pub fn update(&mut self, input: &Input, game: &Game, details: bool) -> i64 {
        self.keys = input.settings.keys;
        self.zoom(input);
        if input.acts(Action::Freeze) {
            self.frozen = !self.frozen;
        }
        if input.acts(Action::Slower) {
            self.slow_down();
        }
        if input.acts(Action::Faster) {
            self.speed_up();
        }
        if details {
            self.look(input, game);
        }
        if self.frozen { i64::from(input.acts(Action::TickOn)) - i64::from(input.acts(Action::TickBack)) } else { 0 }
    }

    /// Brings the view closer or makes it wider by keys or the wheel, and fits it to everything that moves, or follows again.
    pub(super) fn zoom(&mut self, input: &Input) {
        if input.acts(Action::Fit) {
            self.focus.fit();
        }
        self.map = input.keeps(Action::Map);
        let by_keys = if input.held.has(Key::Control) { 0 } else { KEY_ZOOM * more_or_less(input) };
        self.focus.zoom_by(by_keys + input.wheel.round() as i8);
    }

    /// Picks out one body by a key or a click, or two (with Shift or Ctrl: to compare); Ctrl with the keys that zoom lengthens arrows.
    pub(super) fn look(&mut self, input: &Input, game: &Game) {
        if input.acts(Action::Next) {
            self.focus.next(game.lead(), game.world().bodies().len());
        }
        if input.click && (input.pointed.is_some() || self.focus.followed.is_some()) {
            self.focus.pick(input.pointed, input.held.has(Key::Shift) || input.held.has(Key::Control));
        }
        if input.held.has(Key::Control) {
            self.focus.lengthen(more_or_less(input));
        }
    }

    pub(super) const fn slow_down(&mut self) {
        self.pace = self.pace.saturating_sub(1);
    }

    pub(super) fn speed_up(&mut self) {
        self.pace = (self.pace + 1).min(self.paces.len() - 1);
    }

    pub(super) const fn keys(&self) -> &Bindings {
        &self.keys
    }

    pub const fn frozen(&self) -> bool {
        self.frozen
    }

    pub const fn freeze(&mut self) {
        self.frozen = true;
    }

    pub fn pace(&self) -> f64 {
        self.paces[self.pace]
    }

    /// How fast it goes, 0 while it stands still.
    pub fn speed(&self) -> f64 {
        if self.frozen { 0.0 } else { self.pace() }
    }

    pub const fn shows_map(&self) -> bool {
        self.map
    }

    pub const fn focus(&self) -> &Focus {
        &self.focus
    }

    /// The line about the time, where the world does not go at its own pace.
    pub fn words(&self, ticks: u64, rate: f64) -> Option<String> {
        let pace = self.pace();
        let how = if pace < 1.0 { format!("1/{:.0}", 1.0 / pace) } else { tr!("{pace} times", pace) };
        let [freeze, on, back, slower, faster] = [Action::Freeze, Action::TickOn, Action::TickBack, Action::Slower, Action::Faster]
            .map(|action| self.keys.label(action));
        match (self.frozen, pace == 1.0) {
            (true, _) => {
                let at = seconds(ticks, rate);
                Some(tr!("Frozen at {at} s: [{freeze}] goes on, [{on}] a tick on, [{back}] a tick back", at, freeze, on, back))
            }
            (false, false) => Some(tr!("{how} as fast: {slower} slower, {faster} faster", how, slower, faster)),
            (false, true) => None,
        }
    }
}
