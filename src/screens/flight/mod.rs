//! The game screen: one attempt at a level, its keys and its pause panel.

mod drawing;
mod what_if;
mod what_if_drawing;

use super::granting::is_of_level;
use super::instruments::{Instruments, Stage};
use super::observer::Observer;
use super::race::{Race, Rival};
use super::{Buttons, Input, Key, Motion, Purpose, Request, Screen, SettingsPanel};
use crate::game::{Clock, Controls, Game, GameError, History, Inputs, Latch, Outcome, Playback, Replay, RunResult, level_hash};
use crate::level::Level;
use crate::physics::{BodyId, DVec2};
use crate::settings::{Action, Settings};
use crate::ui::{Spectator, Ui};
use crate::view::focus::Focus;
use std::path::{Path, PathBuf};
use std::rc::Rc;
use std::sync::Arc;
use what_if::WhatIf;

/// From the end of an attempt to its score, s: long enough to see what happened.
const END_PAUSE: f64 = 1.2;
/// From the loss of the ship to the next attempt, s: long enough to see it burst, and short enough that the level flies within half a second.
const LOSS_PAUSE: f64 = 0.35;
/// The words on the pause panel's buttons, from top to bottom; in an experiment the fourth leads elsewhere.
pub const PAUSE_LABELS: [&str; 6] = ["Resume", "Restart", "Settings", "Level Select", "Main Menu", "Edit Level"];
const BACK_TO_EXPERIMENTS: &str = "Back to experiments";

/// From the middle of the window up to the first of them.
const PAUSE_TOP: f32 = 152.0;

/// What is flown: a level, and the inputs that replace the keys, if any.
#[derive(Clone, Debug)]
pub struct Attempt {
    /// The level.
    pub level: Arc<Level>,
    /// Recorded inputs, played from the first tick on.
    pub inputs: Option<Arc<Inputs>>,
    /// Recorded flights that fly along as ghosts.
    pub rivals: Vec<Rival>,
}

impl Attempt {
    /// A flight by hand, alone.
    pub const fn by_hand(level: Arc<Level>) -> Self {
        Self { level, inputs: None, rivals: Vec::new() }
    }
}

/// A flight by hand that is over, and the way back through it.
#[derive(Clone, Debug)]
pub struct Flown {
    /// The level.
    pub level: Arc<Level>,
    /// Its record.
    pub replay: Replay,
    /// How it went.
    pub history: History,
}

/// One attempt at a level.
#[derive(Debug)]
pub struct Flight {
    attempt: Attempt,
    game: Game,
    clock: Clock,
    latch: Latch,
    /// What was flown, a tick after the other.
    history: History,
    /// Those who fly along.
    race: Option<Race>,
    /// What is left of the recorded inputs.
    playback: Option<Playback>,
    /// The pause panel, while it is open.
    pause: Option<Buttons>,
    /// The settings, while they are open above it.
    settings: Option<Box<SettingsPanel>>,
    /// What is wrong with their file.
    settings_problems: Vec<String>,
    /// Whether the player has had help.
    assisted: bool,
    /// Since the attempt has ended, s.
    ended: f64,
    details: bool,
    hitboxes: bool,
    observer: Observer,
    instruments: Instruments,
    /// The level as it is varied, while it is: nothing comes of that either.
    what_if: Option<Box<WhatIf>>,
    /// How many ticks are flown again in a frame.
    ahead: u64,
    /// Whether it is flown to try out what is edited: nothing comes of it.
    test: bool,
    /// What became of the level's files since they were read, while that is shown.
    news: Option<News>,
    /// The attempt before this one, while it is shown that it was lost.
    lost: Option<Box<Lost>>,
}

/// An attempt that was lost, and went over into the next one without a page between.
#[derive(Debug)]
struct Lost {
    result: RunResult,
    flown: Option<Rc<Flown>>,
    /// For how long that has been shown, s.
    since: f64,
}

/// How long a notice stays, that a level was read again or that the attempt before was lost, s.
const TOLD: f64 = 5.0;

/// What became of a level's files while it is flown.
#[derive(Clone, Debug, PartialEq)]
pub enum News {
    /// They were read anew, so long ago, s; whether the flight goes on where it was, or began again.
    Changed(f64, bool),
    /// They do not load; a line a problem.
    Broken(Vec<String>),
    /// They are edited, and flown as far as they go; a line a problem.
    Unfinished(Vec<String>),
}

impl Screen for Flight {
    fn show(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        if self.settings.is_none() {
            let rest = if self.pause.is_none() { self.measure(ui) } else { ui.input().clone() };
            let request = self.update(&rest, ui.spectator);
            if self.settings.is_none() || request.is_some() {
                return request;
            }
        }
        match self.settings.as_mut()?.show(ui)? {
            Request::Menu => {
                self.settings = None;
                None
            }
            request => Some(request),
        }
    }

    fn motion(&self, _: &Input) -> Motion {
        let moves = self.pause.is_none() && (!self.observer.frozen() || self.is_flown_again());
        if moves { Motion::Full } else { Motion::Still }
    }

    fn tune(&self) -> Option<&str> {
        Some(&self.game.level().name)
    }

    fn takes(&self, path: &Path) -> bool {
        self.pause.is_some() || is_of_level(path)
    }

    fn text_scale(&self, settings: &Settings, _: f32) -> f32 {
        if self.pause.is_none() { f32::from(settings.scale) / 100.0 } else { 1.0 }
    }

    fn tell_of_settings(&mut self, settings: &Settings, problems: &[String]) {
        self.settings_problems = problems.to_vec();
        if let Some(panel) = &mut self.settings {
            panel.tell_of_settings(settings, problems);
        }
    }

    fn report_export(&mut self, told: Result<PathBuf, String>) {
        self.instruments.report_export(told);
    }

    #[cfg(feature = "window")]
    fn draw(
        &self,
        theatre: &mut crate::screens::theatre::Theatre,
        moment: crate::screens::theatre::PictureTime,
        canvas: &mut crate::draw::Canvas,
    ) {
        theatre.set_panels(self.panels(canvas.frame()));
        let whole = canvas.use_frame(self.instruments.room(canvas.frame()));
        theatre.draw_flown(self, moment.settings, moment.frame_time, canvas);
        canvas.use_frame(whole);
        self.draw_over(canvas);
    }
}

impl Flight {
    /// The level at its start.
    ///
    /// # Errors
    /// The level makes no world.
    pub fn new(attempt: Attempt, spectator: &mut dyn Spectator) -> Result<Self, GameError> {
        let game = Game::new(attempt.level.clone())?;
        spectator.begins(&game);
        let mut observer = Observer::default();
        let experiment = !game.level().ship_plays();
        if experiment {
            observer.look_at(Focus::fitted_on(first_mover(&game)));
        }
        Ok(Self {
            history: History::new(&game),
            race: Race::new(&attempt.level, &attempt.rivals)?,
            clock: Clock::new(game.tick_rate()),
            latch: Latch::default(),
            playback: attempt.inputs.as_deref().map(|inputs| inputs.clone().into_iter()),
            pause: None,
            settings: None,
            settings_problems: Vec::new(),
            assisted: false,
            ended: 0.0,
            details: experiment,
            hitboxes: false,
            observer,
            instruments: Instruments::default(),
            what_if: None,
            ahead: what_if::AT_FIRST,
            test: false,
            news: None,
            lost: None,
            attempt,
            game,
        })
    }

    /// The same, to try out what is edited: Esc and F5 lead back, and so does its end.
    ///
    /// # Errors
    /// As [`Flight::new`].
    pub(super) fn test(level: Arc<Level>, left: Vec<String>, spectator: &mut dyn Spectator) -> Result<Self, GameError> {
        let news = (!left.is_empty()).then_some(News::Unfinished(left));
        Ok(Self { test: true, news, ..Self::new(Attempt::by_hand(level), spectator)? })
    }

    /// Whether it is flown to try out what is edited.
    pub fn is_test(&self) -> bool {
        self.test
    }

    /// One frame.
    pub fn update(&mut self, input: &Input, spectator: &mut dyn Spectator) -> Option<Request> {
        let request = self.go_on(input, spectator);
        // What is read is that of the moment that is drawn.
        let mut instruments = std::mem::take(&mut self.instruments);
        instruments.read(&self.stage());
        self.instruments = instruments;
        request
    }

    fn go_on(&mut self, input: &Input, spectator: &mut dyn Spectator) -> Option<Request> {
        if self.test && (input.pressed(Key::F5) || input.pressed(Key::Escape) || input.acts(Action::Pause)) {
            return Some(Request::BackToEditor(self.told()));
        }
        if let Some(News::Changed(since, _)) = &mut self.news {
            *since += input.frame_time;
            if *since > TOLD {
                self.news = None;
            }
        }
        if self.pause.is_some() {
            return self.update_pause(input);
        }
        let wish = self.instruments.vary_mut().take_wish();
        if let Some(lost) = self.lost.as_mut().filter(|_| self.game.outcome() == Outcome::Running) {
            lost.since += input.frame_time;
            if (input.pressed.has(Key::Enter) || input.pressed.has(Key::PadSelect)) && !steers(input) {
                return Some(Request::Score(self.attempt.clone(), lost.result.clone(), lost.flown.clone()));
            }
            if lost.since > TOLD {
                self.lost = None;
            }
        }
        if let Some(request) = wish.and_then(|wish| self.grant(wish, spectator)) {
            return Some(request);
        }
        if let Some(tick) = self.instruments.take_seek() {
            self.seek(tick, input, spectator);
        }
        if let Some(file) = self.instruments.take_export() {
            return Some(Request::Export(file));
        }
        if input.acts(Action::Restart) {
            return Some(Request::Restart);
        }
        self.details ^= input.acts(Action::Details);
        self.hitboxes ^= input.acts(Action::Hitboxes);
        if self.update_what_if(input.worked(), spectator) {
            return None;
        }
        let looked_at = self.details || self.instruments.is_open();
        match self.observer.update(input, &self.game, looked_at) {
            0 => {}
            ticks => self.step(ticks, input, spectator),
        }
        if self.game.outcome() != Outcome::Running && !self.observer.frozen() {
            return if self.what_if.is_some() { self.end_what_if(input) } else { self.wait_for_score(input) };
        }
        if input.acts(Action::Pause) {
            self.latch.clear();
            self.pause = Some(Buttons::default());
            return None;
        }
        self.latch.frame(controls(|action| input.keeps(action)), controls(|action| input.acts(action)));
        let assists = input.settings.assists;
        self.assisted |= (assists.any() || self.observer.pace() != 1.0) && self.playback.is_none();
        if self.observer.frozen() {
            return None;
        }
        self.leave_what_came_after();
        self.game.set_lasting_fuel(assists.lasting_fuel && self.playback.is_none());
        self.clock.add(input.frame_time * f64::from(assists.speed) / 100.0 * self.observer.speed());
        while self.game.outcome() == Outcome::Running && self.clock.tick() {
            self.tick(spectator);
        }
        if let Some(race) = &mut self.race {
            race.update(&self.game, input.worked());
        }
        None
    }

    /// What the instruments see.
    fn stage(&self) -> Stage<'_> {
        Stage {
            game: &self.game,
            history: &self.history,
            focus: self.observer.focus(),
            varied: Some(self.varied()),
            seekable: self.observer.frozen() || self.game.outcome() != Outcome::Running,
            before: self.before(),
        }
    }

    /// Shows the instruments; returns the input that remains for the flight.
    fn measure(&mut self, ui: &mut Ui<'_>) -> Input {
        let mut instruments = std::mem::take(&mut self.instruments);
        let rest = instruments.show(ui, ui.frame(), &self.stage());
        self.instruments = instruments;
        rest
    }

    /// A tick by the keys, or by the recording.
    fn tick(&mut self, spectator: &mut dyn Spectator) {
        let controls = match &mut self.playback {
            Some(playback) => playback.next().unwrap_or_default(),
            None => self.latch.take(),
        };
        spectator.before_tick();
        self.game.step(controls);
        self.history.note(&self.game, controls);
        self.after_tick_of_what_if(controls);
        if let Some(race) = &mut self.race {
            race.after_tick(&self.game);
        }
        spectator.after_tick(&self.game);
    }

    /// So many ticks on or back in a world that stands still: through what was flown as it was, and beyond its end by the keys. Whoever
    /// does so has had help.
    fn step(&mut self, ticks: i64, input: &Input, spectator: &mut dyn Spectator) {
        self.assisted |= self.is_by_hand();
        let wanted = self.game.ticks().saturating_add_signed(ticks);
        if wanted <= self.history.ticks() {
            self.history.seek(&mut self.game, wanted);
            self.show_before(false);
            spectator.jumped(&self.game);
        } else if self.game.outcome() == Outcome::Running {
            self.latch.frame(controls(|action| input.keeps(action)), Controls::default());
            self.tick(spectator);
        }
    }

    /// To another moment of what was flown, where the world stands still from now on.
    fn seek(&mut self, tick: u64, input: &Input, spectator: &mut dyn Spectator) {
        self.observer.freeze();
        let now = self.game.ticks();
        self.step(tick.min(self.history.ticks()) as i64 - now as i64, input, spectator);
    }

    /// Whoever went back and goes on from there flies anew: what came after it has not been.
    fn leave_what_came_after(&mut self) {
        let now = self.game.ticks();
        if now < self.history.ticks() {
            self.history = self.history.until(now);
            self.show_before(true);
            self.instruments.back_to(&self.history, now);
            self.ended = 0.0;
            self.play_on_from(now);
        }
    }

    /// The recording, if there is one, goes on from there.
    fn play_on_from(&mut self, tick: u64) {
        let mut again = self.attempt.inputs.as_deref().map(|inputs| inputs.clone().into_iter());
        again.iter_mut().for_each(|playback| playback.take(tick as usize).for_each(drop));
        self.playback = again;
    }

    /// Whoever looks on: whether the world stands still, how fast it goes, and whom the details tell of.
    pub const fn observer(&self) -> &Observer {
        &self.observer
    }

    /// What it is measured with.
    pub const fn instruments(&self) -> &Instruments {
        &self.instruments
    }

    /// Whether the keys fly, and not a recording.
    pub fn is_by_hand(&self) -> bool {
        self.playback.is_none()
    }

    /// Those who fly along, if any do: they were flown in the level as it is.
    pub fn race(&self) -> Option<&Race> {
        self.race.as_ref().filter(|_| self.what_if.is_none())
    }

    /// The flight so far.
    pub const fn history(&self) -> &History {
        &self.history
    }

    /// Whether the player has had help.
    pub fn is_assisted(&self) -> bool {
        self.assisted
    }

    /// The game as it stands.
    pub fn game(&self) -> &Game {
        &self.game
    }

    /// Where between the last two ticks to draw, 0 … 1.
    pub fn alpha(&self) -> f64 {
        if self.observer.frozen() { 1.0 } else { self.clock.alpha() }
    }

    /// The pause panel's buttons, while it is open, from Resume on.
    pub fn pause(&self) -> Option<&Buttons> {
        self.pause.as_ref()
    }

    /// What stands on them.
    pub fn pause_labels(&self) -> [&'static str; 6] {
        let mut labels = PAUSE_LABELS;
        if self.attempt.level.experiment {
            labels[3] = BACK_TO_EXPERIMENTS;
        }
        labels
    }

    /// Shows the details of a body, of all where that is `None`, or hides them.
    pub(super) fn show_as(&mut self, body: Option<BodyId>, details: Option<bool>) {
        self.details = details.unwrap_or(self.details || body.is_some());
        if let Some(body) = body {
            self.observer.look_at(Focus::fitted_on(body));
        }
    }

    /// Whether forces are shown.
    pub fn details(&self) -> bool {
        self.details
    }

    /// Whether hitboxes and costs are shown.
    pub fn hitboxes(&self) -> bool {
        self.hitboxes
    }

    fn update_pause(&mut self, input: &Input) -> Option<Request> {
        let pause = self.pause.as_mut()?;
        pause.place(input.frame.column(PAUSE_LABELS.len(), input.frame.size.y / 2.0 - PAUSE_TOP));
        // What the overlays show stays right while paused, so they can be switched.
        self.details ^= input.acts(Action::Details);
        self.hitboxes ^= input.acts(Action::Hitboxes);
        if input.acts(Action::Pause) || input.pressed(Key::Escape) {
            self.pause = None;
            return None;
        }
        match pause.update(input)? {
            0 => self.pause = None,
            1 => return Some(Request::Restart),
            2 => self.settings = Some(Box::new(SettingsPanel::new(input.settings, self.settings_problems.clone()))),
            3 if self.attempt.level.experiment => return Some(Request::Experiments(self.attempt.level.name.clone())),
            3 => return Some(Request::LevelSelect(Purpose::Play)),
            4 => return Some(Request::Menu),
            _ => return Some(Request::Edit(self.attempt.level.name.clone())),
        }
        None
    }

    /// The attempt has ended: its score comes after a while, or at once on Esc or Enter. One that was lost goes over into the next.
    fn wait_for_score(&mut self, input: &Input) -> Option<Request> {
        self.ended += input.frame_time;
        // A flight that is plotted stays.
        let passed = |pause: f64| self.ended >= pause && !self.instruments.stays();
        // A button that steers is still held by the flight that has just ended.
        let leads_on = (input.pressed(Key::Escape) || input.pressed(Key::Enter)) && (self.ended >= END_PAUSE || !steers(input));
        if self.flies_on() && passed(LOSS_PAUSE) && !leads_on {
            return Some(Request::Restart);
        }
        let over = passed(END_PAUSE) || leads_on;
        if self.test {
            return over.then(|| Request::BackToEditor(self.told()));
        }
        over.then(|| {
            let result = RunResult { assisted: self.assisted, ..self.game.result() };
            Request::Score(self.attempt.clone(), result, self.flown(self.history.clone()))
        })
    }

    /// Whether a fresh attempt follows by itself: this one was flown by hand, for its own sake, and lost.
    fn flies_on(&self) -> bool {
        self.game.outcome() == Outcome::Failed && self.is_by_hand() && !self.test && self.what_if.is_none()
    }

    /// What the attempt before this one was lost to, in words, while that is shown.
    pub fn lost(&self) -> Option<&str> {
        self.lost.as_ref()?.result.death.as_deref()
    }

    /// The flight with that history, where it was flown by hand and without help: with help it would not be flown again as it was.
    fn flown(&self, history: History) -> Option<Rc<Flown>> {
        let kept = || Rc::new(Flown { level: self.attempt.level.clone(), replay: history.record(&self.game), history });
        (self.is_by_hand() && !self.assisted).then(kept)
    }

    /// Begins anew, with the overlays as they are.
    ///
    /// # Errors
    /// The level makes no world; the flight goes on then.
    pub(super) fn restart(&mut self, level: Arc<Level>, spectator: &mut dyn Spectator) -> Result<(), GameError> {
        let flies_on = self.flies_on();
        let (same, varied) = (level_hash(&level) == level_hash(&self.attempt.level), self.what_if.take());
        let mut fresh = Self::new(Attempt { level, ..self.attempt.clone() }, spectator)?;
        let lost = flies_on.then(|| {
            let result = RunResult { assisted: self.assisted, ..self.game.result() };
            let history = std::mem::replace(&mut self.history, History::new(&self.game));
            Box::new(Lost { result, flown: self.flown(history), since: 0.0 })
        });
        if same {
            // What is known of the others' ways stays known.
            fresh.race = self.race.take().map(Race::again);
        }
        *self = Self {
            details: self.details,
            hitboxes: self.hitboxes,
            observer: self.observer,
            instruments: std::mem::take(&mut self.instruments).of_another_flight(),
            test: self.test,
            lost,
            settings_problems: std::mem::take(&mut self.settings_problems),
            ..fresh
        };
        if let Some(Err(words)) = varied.map(|varied| self.begin_varied(varied, same)) {
            self.instruments.vary_mut().tell(words, true);
        }
        Ok(())
    }

    /// What is flown.
    pub(super) fn attempt(&self) -> &Attempt {
        &self.attempt
    }

    /// Goes on in a level that has been edited: where it is, as far as there is room, else from its start. What is flown in two levels counts as
    /// flown with help.
    pub(super) fn take_over(&mut self, level: Arc<Level>, spectator: &mut dyn Spectator) {
        if self.game.outcome() != Outcome::Running {
            return;
        }
        // A level that is varied is varied anew, from its start.
        let carried =
            if self.is_by_hand() && self.what_if.is_none() { self.game.carried_into(&self.attempt.level, &level) } else { None };
        let goes_on = carried.is_some();
        if let Some(game) = carried {
            self.history = History::new(&game);
            self.instruments = std::mem::take(&mut self.instruments).of_another_flight();
            (self.game, self.attempt.level, self.assisted) = (game, level, true);
            spectator.goes_on(&self.game);
        } else {
            let (pause, settings) = (self.pause.take(), self.settings.take());
            if let Err(error) = self.restart(level, spectator) {
                return self.tell_of_problems(vec![error.to_string()]);
            }
            (self.pause, self.settings) = (pause, settings);
        }
        self.news = Some(News::Changed(0.0, goes_on));
    }

    /// Shows why the level's files do not load any more; the flight goes on.
    pub(super) fn tell_of_problems(&mut self, problems: Vec<String>) {
        self.news = Some(News::Broken(problems));
    }

    /// The level's files are what is flown again.
    pub(super) fn tell_of_mending(&mut self) {
        self.news = None;
    }

    /// What became of the level's files, while that is shown.
    pub fn news(&self) -> Option<&News> {
        self.news.as_ref()
    }
}

/// Whether a key went down that steers.
fn steers(input: &Input) -> bool {
    controls(|action| input.acts(action)) != Controls::default()
}

/// The first object that moves or is about to; else the first one.
fn first_mover(game: &Game) -> BodyId {
    let world = game.world();
    let moves = |id: &BodyId| world.body(*id).velocity != DVec2::ZERO || world.forces(*id).resultant() != DVec2::ZERO;
    (game.lead().0..world.bodies().len() as u32).map(BodyId).find(moves).unwrap_or(game.lead())
}

fn controls(is: impl Fn(Action) -> bool) -> Controls {
    Controls { thrust: is(Action::Thrust), reverse: is(Action::Reverse), left: is(Action::Left), right: is(Action::Right) }
}
