//! The source of a flight's controls, its moment that is shown, its rewinding, modifiers that type, and how many ticks a frame flies ahead.

use super::{Flight, what_if::AGAIN};
use crate::game::{Clock, Controls, Inputs, Latch, Outcome, Playback, Unflown};
use crate::settings::{Action, Bindings, Key, Keys};
use crate::ui::input::{Input, Stale};
use crate::{session::library::Attempt, ui::Spectator, words::tr};
use std::sync::Arc;

/// A frame that takes longer than this is no short one, s.
const SHORT_FRAME: f64 = 1.0 / 40.0;

#[derive(Clone, Copy, Debug)]
pub struct Ahead {
    ticks: u64,
    least: u64,
    most: u64,
}

impl Default for Ahead {
    fn default() -> Self {
        Self::within([30, 240, 4000])
    }
}

impl Ahead {
    /// At least, at first and at most that number of ticks.
    pub const fn within([least, ticks, most]: [u64; 3]) -> Self {
        Self { ticks, least, most }
    }

    /// How many it is to be after a frame that took so long, s; as before where no time has passed.
    pub fn ticks(&mut self, frame_time: f64) -> u64 {
        if frame_time > 0.0 {
            let wanted = if frame_time > SHORT_FRAME { self.ticks / 2 } else { self.ticks * 5 / 4 };
            self.ticks = wanted.clamp(self.least, self.most);
        }
        self.ticks
    }
}

/// Where the controls of a flight come from, and how its time goes on.
#[derive(Debug)]
pub(super) struct Pilot {
    pub source: Controller,
    pub clock: Clock,
    /// The keys that a panel or the attempt before was given.
    pub stale: Stale,
    pub modifiers: Modifiers,
    pub rewind: Rewind,
    /// Ticks to fly again in a frame.
    pub ahead: Ahead,
}

impl Pilot {
    pub fn new(source: Controller, tick_rate: f64) -> Self {
        Self {
            source,
            clock: Clock::new(tick_rate),
            stale: Stale::default(),
            modifiers: Modifiers::default(),
            rewind: Rewind::default(),
            ahead: Ahead::within(AGAIN),
        }
    }
}

#[derive(Debug)]
pub(super) struct Viewer {
    pub title: String,
    /// The inputs that the history lacks.
    pub unflown: Option<Unflown>,
    /// Ticks to fly of them in a frame.
    pub ahead: Ahead,
    pub dragged: bool,
}

#[derive(Debug)]
pub(super) enum Controller {
    Hands(Latch),
    Inputs(Playback),
    /// A recorded flight: the history holds its ticks.
    Reel(Box<Viewer>),
}

impl Controller {
    pub fn of(attempt: &Attempt) -> Self {
        match &attempt.inputs {
            Some(inputs) => Self::Inputs(Inputs::clone(inputs).into_iter()),
            None => Self::Hands(Latch::default()),
        }
    }

    pub fn follow(&mut self, held: Controls, pressed: Controls) {
        if let Self::Hands(latch) = self {
            latch.frame(held, pressed);
        }
    }

    fn let_go(&mut self) {
        if let Self::Hands(latch) = self {
            latch.clear();
        }
    }

    fn take(&mut self) -> Controls {
        match self {
            Self::Hands(latch) => latch.take(),
            Self::Inputs(playback) => playback.next().unwrap_or_default(),
            Self::Reel(_) => Controls::default(),
        }
    }
}

pub(super) fn pressed(input: &Input) -> Controls {
    controls(|action| input.acts(action))
}

pub(super) fn held(input: &Input) -> Controls {
    controls(|action| input.keeps(action))
}

fn controls(is: impl Fn(Action) -> bool) -> Controls {
    Controls { thrust: is(Action::Thrust), reverse: is(Action::Reverse), left: is(Action::Left), right: is(Action::Right) }
}

pub(super) fn steers(input: &Input) -> bool {
    pressed(input) != Controls::default()
}

impl Flight {
    pub(super) fn fly(&mut self, input: &Input, spectator: &mut dyn Spectator) {
        let soon = (SOON * self.run.game.tick_rate()) as u64;
        let (input, mistaken) = &self.pilot.modifiers.flying(input, self.run.game.ticks(), soon);
        if let Some(mistaken) = mistaken {
            self.take_back(mistaken, input, spectator);
        }
        self.pilot.source.follow(held(input), pressed(input));
        let (assists, by_hand) = (input.settings.assists, self.is_by_hand());
        self.run.assisted |= by_hand && (assists.any() || self.seen.observer.pace() != 1.0);
        if self.seen.observer.frozen() {
            return;
        }
        self.leave_what_came_after();
        self.run.game.set_lasting_fuel(assists.lasting_fuel && by_hand);
        self.pilot.clock.add(input.frame_time * f64::from(assists.speed) / 100.0 * self.seen.observer.speed() * self.slowness());
        while self.run.game.outcome() == Outcome::Running && self.pilot.clock.tick() {
            self.tick(spectator);
        }
        if let Some(race) = &mut self.run.race {
            race.update(&self.run.game, input.worked());
        }
    }

    /// Flies some ticks again without what modifiers have steered that were there to type a sign.
    fn take_back(&mut self, mistaken: &Mistaken, input: &Input, spectator: &mut dyn Spectator) {
        let [typing, flying] = [Input { held: mistaken.keys, ..input.clone() }, input.clone()].map(|input| held(&input));
        let steered = |flown: bool, typing: bool, flying: bool| flown && (!typing || flying);
        let meant = |flown: Controls| Controls {
            thrust: steered(flown.thrust, typing.thrust, flying.thrust),
            reverse: steered(flown.reverse, typing.reverse, flying.reverse),
            left: steered(flown.left, typing.left, flying.left),
            right: steered(flown.right, typing.right, flying.right),
        };
        let begins = self.run.history.start().ticks();
        let flown: Vec<Controls> = self.run.history.inputs().after(mistaken.since.saturating_sub(begins)).collect();
        let by_hand = self.is_by_hand() && !self.seen.observer.frozen() && self.run.game.ticks() == self.run.history.ticks();
        if !by_hand || flown.iter().all(|controls| meant(*controls) == *controls) {
            return;
        }
        self.show_moment(mistaken.since, spectator);
        self.leave_what_came_after();
        if let Some(race) = &mut self.run.race {
            race.back_to(&self.run.game);
        }
        for controls in flown {
            if self.run.game.outcome() == Outcome::Running {
                self.fly_tick(meant(controls), spectator);
            }
        }
    }

    fn tick(&mut self, spectator: &mut dyn Spectator) {
        let controls = self.pilot.source.take();
        self.fly_tick(controls, spectator);
    }

    fn fly_tick(&mut self, controls: Controls, spectator: &mut dyn Spectator) {
        spectator.before_tick();
        self.run.game.step(controls);
        self.run.history.note(&self.run.game, controls);
        if self.open.test {
            self.open.trail.note(&self.run.game);
        }
        self.slow_down_for_goals();
        self.after_tick_of_what_if(controls);
        if let Some(race) = &mut self.run.race {
            race.after_tick(&self.run.game);
        }
        spectator.after_tick(&self.run.game);
    }

    /// Takes a frozen world some ticks on, or back where `ticks` is negative: through its history, and beyond the end of that by the keys.
    pub(super) fn step(&mut self, ticks: i64, input: &Input, spectator: &mut dyn Spectator) {
        self.run.assisted |= self.is_by_hand();
        let wanted = self.run.game.ticks().saturating_add_signed(ticks);
        if wanted <= self.run.history.ticks() {
            self.show_moment(wanted, spectator);
        } else if self.run.game.outcome() == Outcome::Running {
            self.pilot.source.follow(held(input), Controls::default());
            self.tick(spectator);
        }
    }

    pub(super) fn seek(&mut self, tick: u64, spectator: &mut dyn Spectator) {
        self.seen.observer.freeze();
        self.run.assisted |= self.is_by_hand();
        self.show_moment(tick, spectator);
    }

    /// Shows the game after `tick` ticks, or the nearest moment of its history.
    pub(super) fn show_moment(&mut self, tick: u64, spectator: &mut dyn Spectator) {
        let before = self.run.game.ticks();
        spectator.before_tick();
        self.run.history.seek(&mut self.run.game, tick);
        self.show_before(false);
        if self.run.game.ticks() == before + 1 {
            spectator.after_tick(&self.run.game);
        } else if self.run.game.ticks() != before {
            spectator.jumped(&self.run.game);
        }
    }

    /// Drops the history after the moment on the screen: the flight goes on otherwise from there.
    pub(super) fn leave_what_came_after(&mut self) {
        let now = self.run.game.ticks();
        if now < self.run.history.ticks() {
            self.run.history = self.run.history.until(now);
            self.show_before(true);
            self.seen.instruments.back_to(&self.run.history, now);
            (self.run.ended, self.run.slow_until) = (0.0, 0);
            self.play_on_from(now);
        }
    }

    /// Recorded inputs, if there are any, go on from that tick.
    pub(super) fn play_on_from(&mut self, tick: u64) {
        if let (Controller::Inputs(playback), Some(inputs)) = (&mut self.pilot.source, &self.run.attempt.inputs) {
            *playback = Inputs::clone(inputs).into_iter();
            playback.by_ref().take(tick as usize).for_each(drop);
        }
    }

    pub(super) fn let_go(&mut self) {
        self.pilot.source.let_go();
        self.pilot.modifiers = Modifiers::default();
    }

    pub fn is_by_hand(&self) -> bool {
        matches!(self.pilot.source, Controller::Hands(_))
    }

    pub const fn is_watched(&self) -> bool {
        matches!(self.pilot.source, Controller::Reel(_))
    }

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
        let Some(flown) = self.run.lost.take_if(|_| self.run.game.is_idle()).and_then(|lost| lost.flown) else { return };
        if Arc::ptr_eq(&flown.level, &self.run.attempt.level) {
            self.run.history = flown.history.clone();
            self.run.game = self.run.history.at(u64::MAX);
        }
    }

    /// The words about it, while the flight is rewound and after that.
    pub(super) fn rewind_words(&self, keys: &Bindings) -> Option<String> {
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

const MODIFIERS: [Key; 3] = [Key::Shift, Key::Control, Key::Alt];
/// The time in which a sign follows the modifier that it is typed with, s.
const SOON: f64 = 0.5;

#[derive(Clone, Copy, Debug, Default)]
enum ModifierState {
    #[default]
    Up,
    Flies(u64),
    Types,
}

/// Modifiers that have flown since a tick, and typed.
pub(super) struct Mistaken {
    pub since: u64,
    pub keys: Keys,
}

/// Shift, Ctrl and Alt fly, and they type signs: on a US keyboard `+` is Shift and `=`. A modifier flies at once. Where a sign is typed
/// with it soon after it went down, it has typed: what it has flown is taken back, and it flies no more until it goes down again.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Modifiers([ModifierState; MODIFIERS.len()]);

impl Modifiers {
    /// The input by which a frame is flown after `now` ticks, and what was flown by mistake, of which `soon` ticks at most are taken back.
    pub fn flying(&mut self, input: &Input, now: u64, soon: u64) -> (Input, Option<Mistaken>) {
        let mut flying = input.clone();
        let mut mistaken: Option<Mistaken> = None;
        let typed = types(input);
        for (key, state) in MODIFIERS.into_iter().zip(&mut self.0) {
            if key == Key::Shift && !input.settings.keys.needs_shift() {
                continue;
            }
            let (pressed, held) = (input.pressed.has(key), input.held.has(key));
            *state = match *state {
                _ if pressed && typed => ModifierState::Types,
                ModifierState::Flies(since) if held && typed && now.saturating_sub(since) <= soon => {
                    let before = mistaken.take().unwrap_or(Mistaken { since, keys: Keys::default() });
                    let keys = before.keys | [key].into_iter().collect();
                    mistaken = Some(Mistaken { since: before.since.min(since), keys });
                    ModifierState::Types
                }
                ModifierState::Types if held && !pressed => ModifierState::Types,
                ModifierState::Flies(since) if held && !pressed => ModifierState::Flies(since),
                _ if pressed || held => ModifierState::Flies(now),
                _ => ModifierState::Up,
            };
            if matches!(state, ModifierState::Types) {
                flying.held = flying.held.without(key);
                flying.pressed = flying.pressed.without(key);
            }
        }
        (flying, mistaken)
    }
}

/// Whether a key went down that types a sign, and does not fly.
fn types(input: &Input) -> bool {
    let flies = |key: Key| {
        Action::ALL.into_iter().any(|action| action.is_by_place() && input.settings.keys.of(action).contains(&Some(key)))
    };
    input.pressed.signs().any(|key| !flies(key))
}

/// The pace backwards at first and at most, and its growth in a second; 1 is the pace of the flight.
const PACES: [f64; 2] = [1.0, 4.0];
const GROWTH: f64 = 1.5;

/// While its key is held the flight runs backwards, up to its start. From there it goes on as practice: not ranked, not proven.
/// Whether the flight has been rewound, and for how long the key has been held, s.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Rewind {
    pub practice: bool,
    pub held: Option<f64>,
}
