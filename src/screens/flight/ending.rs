//! An attempt and its end: its score, or the next attempt.

use super::{Flight, open::FlownTrail, pilot::steers, race::Race, what_if::WhatIf};
use crate::game::{Game, GameEvent, History, Outcome, Replay, RunResult};
use crate::screens::screen::{Destination, Effect, Finished, Request};
use crate::session::{Gain, Session, library::Attempt, library::Flown};
use crate::{number::clock, scores::subject, settings::Key, ui::input::Input, words::tr};
use std::rc::Rc;

/// From the end of an attempt to its score, s: long enough to see the end.
pub(super) const END_PAUSE: f64 = 1.2;
/// From the loss of the ship to the next attempt, s: long enough to see it burst, and short enough that the level flies within half a second.
const LOSS_PAUSE: f64 = 0.35;
/// Time for which a notice stays, s: that a level was read again, or that the attempt before was lost.
pub(super) const NOTICE: f64 = 5.0;

/// At a met goal the picture, not the ticks, slows to this pace; for how long, and the least time to the next, ticks: it may be met again and again.
const SLOW: f64 = 0.4;
const SLOW_TICKS: u64 = 24;
const BETWEEN_SLOW: u64 = 240;

/// An attempt that was lost, and went over into the next one without a page between.
#[derive(Debug)]
pub(super) struct Lost {
    result: RunResult,
    pub flown: Option<Rc<Flown>>,
    /// What it brought the player, in words.
    remark: Option<String>,
    /// Age of its notice, s.
    since: f64,
}

impl Flight {
    /// The attempt has ended: its score comes after a while, or at once on Esc or Enter. A lost one goes over into the next.
    pub(super) fn wait_for_score(&mut self, input: &Input) -> Option<Request> {
        self.run.ended += input.frame_time;
        // A flight that is plotted stays.
        let passed = |pause: f64| self.run.ended >= pause && !self.seen.instruments.stays();
        // A button that steers is still held by the flight that has just ended.
        let leads_on = (input.pressed(Key::Escape) || input.pressed(Key::Enter)) && (self.run.ended >= END_PAUSE || !steers(input));
        if self.flies_on() && passed(LOSS_PAUSE) && !leads_on {
            // A level whose files have changed is read first: meanwhile nothing is asked for again.
            self.run.ended -= END_PAUSE;
            return Some(Request::Do(Effect::Restart));
        }
        let over = passed(END_PAUSE) || leads_on;
        if self.open.test {
            return over.then_some(Request::Pop);
        }
        over.then(|| self.score(self.result(), self.flown(self.run.history.clone()), self.run.remark.clone()))
    }

    pub(super) fn slow_down_for_goals(&mut self) {
        let met = self.run.game.events().iter().any(|event| matches!(event, GameEvent::ObjectiveMet(_)));
        if met && (self.run.slow_until == 0 || self.run.game.ticks() > self.run.slow_until + BETWEEN_SLOW) {
            self.run.slow_until = self.run.game.ticks() + SLOW_TICKS;
        }
    }

    pub(super) fn slowness(&self) -> f64 {
        let ends = self.run.game.outcome() == Outcome::Completed
            && self.run.ended < SLOW_TICKS as f64 / (SLOW * self.run.game.tick_rate());
        let slow = ends || self.run.game.outcome() == Outcome::Running && self.run.game.ticks() < self.run.slow_until;
        if slow && !self.is_watched() { SLOW } else { 1.0 }
    }

    fn score(&self, result: RunResult, flown: Option<Rc<Flown>>, remark: Option<String>) -> Request {
        let (attempt, remark) = (self.run.attempt.clone(), remark.unwrap_or_default());
        // Another attempt may have begun since.
        let end = flown.as_ref().map_or_else(|| self.run.game.clone(), |flown| flown.history.at(flown.history.ticks()));
        Request::Replace(Destination::Score(Box::new(Finished { attempt, result, flown, remark, end: Box::new(end) })))
    }

    /// Gives the player what an attempt has brought, once, when it has ended. Who watches a recording has flown nothing.
    pub(super) fn note_end(&mut self, session: &mut Session) {
        let level = self.run.game.level().name.clone();
        self.open.hints.losses = session.losses.get(&level).copied().unwrap_or_default();
        self.open.done = session.journal.medals(&level).medal.is_some();
        if self.open.test || self.is_watched() {
            return;
        }
        if self.run.what_if.is_some() || self.run.game.outcome() == Outcome::Running {
            self.run.remark = None;
        } else if self.run.remark.is_none() {
            let brought = session.note_end(&self.run.game, self.is_by_hand(), self.run.assisted);
            let saved = self.gain().map_or(Ok(None), |gain| session.save(gain));
            let both = |best: Option<String>| best.map_or(brought.clone(), |best| format!("{brought} {best}"));
            self.run.remark = Some(saved.map_or_else(|problem| problem, both));
        }
    }

    fn result(&self) -> RunResult {
        RunResult { assisted: self.run.assisted, ..self.run.game.result() }
    }

    fn gain(&self) -> Option<Gain> {
        let (level, points) = (self.run.game.level(), self.run.game.result().score.total);
        let saves = self.run.game.outcome() == Outcome::Completed && points > 0;
        let flown = if saves { self.flown(self.run.history.clone()) } else { None };
        let (board, subject) = (level.name.clone(), subject(&level.name, &level.title));
        flown.map(|flown| Gain { board, subject, points, flown: Some(flown) })
    }

    /// Whether a fresh attempt follows by itself: this one was flown by hand, for its own sake, and lost.
    pub(super) fn flies_on(&self) -> bool {
        self.run.game.outcome() == Outcome::Failed && self.is_by_hand() && !self.open.test && self.run.what_if.is_none()
    }

    /// The notice of this attempt, which was lost; its history goes along.
    pub(super) fn take_lost(&mut self) -> Box<Lost> {
        let history = std::mem::replace(&mut self.run.history, History::new(&self.run.game));
        Box::new(Lost { result: self.result(), flown: self.flown(history), remark: self.run.remark.take(), since: 0.0 })
    }

    /// The flight with that history, where it was flown by hand and without help: with help no replay repeats it.
    fn flown(&self, history: History) -> Option<Rc<Flown>> {
        let kept = || Rc::new(Flown { level: self.run.attempt.level.clone(), replay: history.record(&self.run.game), history });
        (self.is_by_hand() && !self.run.assisted).then(kept)
    }

    /// A frame of the notice that the attempt before was lost: Enter leads to its score.
    pub(super) fn follow_lost(&mut self, input: &Input) -> Option<Request> {
        let lost = self.run.lost.as_mut().filter(|_| self.run.game.outcome() == Outcome::Running)?;
        lost.since += input.frame_time;
        if (input.pressed.has(Key::Enter) || input.pressed.has(Key::PadSelect)) && !steers(input) {
            let (result, flown, remark) = (lost.result.clone(), lost.flown.clone(), lost.remark.clone());
            return Some(self.score(result, flown, remark));
        }
        if lost.since > NOTICE {
            self.run.lost = None;
        }
        None
    }

    pub fn lost(&self) -> Option<&str> {
        self.run.lost.as_ref()?.result.death
    }

    pub(in crate::screens) const fn trail(&self) -> &FlownTrail {
        &self.open.trail
    }

    /// The record of a flight that was completed by hand from its start, without help.
    pub(in crate::screens) fn proof(&self) -> Option<Replay> {
        let proves = self.run.game.outcome() == Outcome::Completed && self.run.what_if.is_none();
        (proves && self.is_by_hand() && !self.run.assisted).then(|| self.run.history.record(&self.run.game))
    }

    /// The end of the flight in words; empty while it runs.
    pub(in crate::screens) fn end_words(&self) -> String {
        let game = self.game();
        match game.outcome() {
            Outcome::Running => String::new(),
            Outcome::Completed => tr!(
                "Completed in {time}, {fuel} % of the fuel left.",
                time = clock(game.time()),
                fuel = format_args!("{:.0}", 100.0 * game.fuel())
            ),
            Outcome::Failed => {
                let cause = game.result().death.map_or_else(String::new, |death| format!(": {death}"));
                tr!("Lost after {time}{cause}.", time = clock(game.time()), cause)
            }
        }
    }
}

#[derive(Debug)]
pub(super) struct Run {
    pub attempt: Attempt,
    pub game: Game,
    /// All flown ticks, which may go beyond the moment on the screen.
    pub history: History,
    pub race: Option<Race>,
    /// The varied level; its flight does not count.
    pub what_if: Option<Box<WhatIf>>,
    pub assisted: bool,
    /// Time since the end of the attempt, s.
    pub ended: f64,
    /// What the attempt, which has ended, brought the player, in words.
    pub remark: Option<String>,
    pub lost: Option<Box<Lost>>,
    /// Up to this tick the flight is shown in slow motion: a goal has been met.
    pub slow_until: u64,
}

impl Run {
    pub fn new(attempt: Attempt, game: Game) -> Self {
        Self {
            attempt,
            history: History::new(&game),
            game,
            race: None,
            what_if: None,
            assisted: false,
            ended: 0.0,
            remark: None,
            lost: None,
            slow_until: 0,
        }
    }
}
