//! The game screen: an attempt at a level, flown by hand, by recorded inputs, or watched from a reel.

mod ending;
pub mod instruments;
pub mod observer;
pub mod open;
mod pilot;
pub mod race;
mod reel;
mod reload;
mod signs;
mod what_if;
mod worksheet;

use crate::game::{Game, GameError, History, Medals, Outcome};
use crate::screens::flight::{instruments::Instruments, instruments::Stage, observer::Observer, race::Race};
use crate::screens::screen::{AboveGame, Destination, Effect, GameScene, Request, Screen};
use crate::session::{Session, library::Attempt, library::is_of_level, worker::Brought, worker::Ticket};
use crate::settings::{Action, Key, Keys, Settings};
use crate::ui::{Spectator, Ui, input::Input, pace::Motion};
use crate::view::{Overlays, camera::Viewport, focus::Focus, hud::Aside, hud::HudShown};
use crate::{draw::Canvas, draw::layout::Frame, physics::BodyId, physics::DVec2};
use ending::{END_PAUSE, Run};
use observer::Observation;
use open::Open;
use pilot::{Controller, Pilot};
use std::path::Path;

#[derive(Debug)]
pub struct Flight {
    run: Run,
    pilot: Pilot,
    seen: Observation,
    open: Open,
}

impl Screen for Flight {
    fn show(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        self.age_news(ui.input().frame_time);
        self.introduce(ui.input());
        let mut rest = self.show_instruments(ui);
        let asked = self.show_sheet(ui, &mut rest);
        let given = if self.open.pause.is_some() { Keys::default() } else { rest.held };
        rest.held = self.pilot.stale.sift(ui.input(), given);
        let request = match &self.pilot.source {
            Controller::Reel(_) => self.show_reel(ui, &rest),
            _ if self.open.pause.is_some() => None,
            _ => self.go_on(&rest, ui.spectator),
        };
        // The moment on the screen, at the end of its frame.
        let mut instruments = std::mem::take(&mut self.seen.instruments);
        instruments.read(&self.stage(&ui.frame()));
        self.seen.instruments = instruments;
        if !self.is_watched() {
            self.draw_signs(ui.canvas());
            self.draw_introduction(ui.canvas());
        }
        request.or(asked).or_else(|| self.show_pause(ui))
    }

    fn motion(&self, _: &Input) -> Motion {
        let moves = self.open.pause.is_none() && (!self.seen.observer.frozen() || self.is_flown_again());
        if moves { Motion::Full } else { Motion::Still }
    }

    fn tune(&self) -> Option<&str> {
        Some(&self.run.game.level().name)
    }

    fn takes(&self, path: &Path) -> bool {
        self.is_watched() || self.open.pause.is_some() || is_of_level(path)
    }

    fn with_words(&self, frame: Frame, settings: &Settings) -> Frame {
        let scale = f32::from(settings.scale) / 100.0;
        frame.with_legible(if self.open.pause.is_none() { scale } else { scale.max(1.0) })
    }

    fn tell_of_settings(&mut self, settings: &Settings, problems: &[String]) {
        self.open.settings_problems = problems.to_vec();
        if let Some(panel) = &mut self.open.settings {
            panel.tell_of_settings(settings, problems);
        }
    }

    fn parent(&self) -> Destination {
        let name = self.run.attempt.level.name.clone();
        if self.open.test { Destination::Edit { name, original: true } } else { Destination::Menu }
    }

    fn reads(&self, effect: &Effect, session: &Session) -> Option<String> {
        let name = &self.run.attempt.level.name;
        (matches!(effect, Effect::Restart) && self.reads_again(session)).then(|| name.clone())
    }

    fn carry_out(&mut self, effect: Effect, session: &mut Session, spectator: &mut dyn Spectator) -> Option<Request> {
        match effect {
            Effect::Restart => self.restart_as_on_disk(session, spectator),
            Effect::Export(file) => self.seen.instruments.plot.report_export(file.write(&session.places.root.join("exports"))),
            Effect::HandIn => self.hand_in(session),
            Effect::Predict => self.open.sheet.iter_mut().for_each(|sheet| sheet.fix_prediction(session.now)),
            Effect::SaveVaried(variation, name) => {
                let saved = self.save_varied(&variation, &name, session);
                let bad = saved.is_err();
                self.seen.instruments.vary.set_message(saved.unwrap_or_else(|reason| reason), bad);
            }
            _ => {}
        }
        None
    }

    fn look(&mut self, frame_time: f64, session: &mut Session) {
        self.look_at_files(frame_time, session);
    }

    fn attend(&mut self, session: &mut Session) {
        self.note_end(session);
    }

    fn receive(&mut self, ticket: Ticket, brought: Brought, session: &mut Session, spectator: &mut dyn Spectator) {
        if let Brought::Level(folder, level) = brought
            && self.open.reading.take_if(|reading| *reading == ticket).is_some()
        {
            self.take_over_from_disk(&folder, level, session, spectator);
        }
    }

    fn halt(&mut self) {
        if self.run.game.outcome() == Outcome::Running && !self.is_watched() && self.open.pause.is_none() {
            self.let_go();
            self.open.pause = Some(open::RESUME);
        }
    }

    fn leave(&mut self, session: &mut Session) {
        // An answer that cannot be written waits in the session.
        let _ = self.write_down(session);
        if let Some(sheet) = self.open.sheet.take() {
            session.answers.sheets.insert(sheet.experiment.folder.clone(), *sheet);
        }
    }

    fn come_back(&mut self, _: &dyn Screen, session: &mut Session, spectator: &mut dyn Spectator) {
        if let Some(watch) = &self.open.watch {
            session.library.open(&watch.folder);
        }
        session.last_level = Some(self.run.attempt.level.name.clone());
        spectator.begins(&self.run.game);
        self.take_sheet(session);
    }

    fn write_down(&mut self, session: &mut Session) -> Result<(), String> {
        self.hand_in(session);
        Ok(())
    }

    fn is_at_risk(&self) -> bool {
        self.open.sheet.as_ref().is_some_and(|sheet| sheet.is_unsaved())
    }

    fn scene(&self, frame: &Frame) -> Option<GameScene<'_>> {
        let (level, above) = (self.run.game.level(), self.above_controls(frame));
        let race = self.race();
        let status = level.ship_plays() && self.open.introduced.is_none();
        let rivals = race.map_or(0, |race| race.all().len());
        // Those who race have a clock, and who has not been there yet needs none.
        let clock = self.open.done && rivals == 0 && !self.is_watched() && !self.run.assisted;
        let medal = status && clock && Medals::has_clock(&level.awards);
        let shown = HudShown { status, fuel: status && level.player.has_engine(), rivals, medal };
        let focus = *self.seen.observer.focus();
        // Nobody is selected without details and instruments.
        let focus = if self.is_looked_at() { focus } else { focus.on_nobody() };
        let (details, hitboxes, watched, map) = (self.seen.details, self.seen.hitboxes, self.is_watched(), self.shows_all());
        let picture = self.seen.picture;
        let still = self.open.pause.is_some() || self.seen.instruments.vary.holds_view();
        Some(GameScene {
            game: &self.run.game,
            alpha: self.alpha(),
            room: self.seen.instruments.room(&above),
            overlays: Overlays { settings: Settings::default(), details, picture, shown, focus, hitboxes, watched, map },
            speed: if still { 0.0 } else { self.seen.observer.speed() * self.slowness() },
            paused: still,
            quiet: false,
            ghosts: self.ghosts(),
            panels: self.panels(frame),
            above: self,
        })
    }
}

impl AboveGame for Flight {
    fn draw_in_level(&self, alpha: f64, view: &Viewport, canvas: &Canvas) {
        if !self.seen.picture {
            self.draw_goals_in_order(view, canvas);
        }
        if self.seen.instruments.is_open() {
            self.seen.instruments.draw_in_level((&self.run.game, alpha), !self.seen.picture, (view, canvas));
        }
    }

    fn draw_beside_timer(&self, aside: &Aside, canvas: &Canvas) {
        if let Some(race) = self.race() {
            race.draw(&self.run.game, aside, canvas);
        }
    }
}

impl Flight {
    /// Shows the details of a body, of all where that is `None`, or hides them.
    pub(super) fn show_as(&mut self, body: Option<BodyId>, details: Option<bool>) {
        self.seen.details = details.unwrap_or(self.seen.details || body.is_some());
        if let Some(body) = body {
            self.seen.observer.focus = Focus::fitted_on(body);
        }
    }

    /// An attempt at its start.
    /// Errors: the level makes no world.
    pub fn new(attempt: Attempt, spectator: &mut dyn Spectator) -> Result<Self, GameError> {
        let game = Game::new(attempt.level.clone())?;
        let race = Race::new(&attempt.level, &attempt.rivals)?;
        spectator.begins(&game);
        let source = Controller::of(&attempt);
        let mut flight = Self::at_start(attempt, game, source);
        flight.run.race = race;
        if !flight.run.game.level().ship_plays() {
            flight.seen.details = true;
            flight.seen.observer.focus = Focus::fitted_on(first_mover(&flight.run.game));
            flight.wait_for_start();
        }
        Ok(flight)
    }

    /// An experiment that is flown by hand stands still at its start: a pupil looks and predicts before anything moves.
    pub(super) fn wait_for_start(&mut self) {
        if self.is_by_hand() && !self.run.game.level().ship_plays() {
            self.seen.observer.freeze();
        }
    }

    fn at_start(attempt: Attempt, game: Game, source: Controller) -> Self {
        Self {
            pilot: Pilot::new(source, game.tick_rate()),
            run: Run::new(attempt, game),
            seen: Observation::default(),
            open: Open::default(),
        }
    }

    fn go_on(&mut self, input: &Input, spectator: &mut dyn Spectator) -> Option<Request> {
        if self.open.test && (input.pressed(Key::F5) || input.pressed(Key::Escape) || input.acts(Action::Pause)) {
            return Some(Request::Pop);
        }
        if let Some(request) = self.follow_lost(input).or_else(|| self.serve_instruments(spectator)) {
            return Some(request);
        }
        if input.acts(Action::Restart) {
            return Some(Request::Do(Effect::Restart));
        }
        self.switch_overlays(input);
        if self.update_what_if(input.worked(), spectator) || self.rewind(input, spectator) {
            return None;
        }
        let looked_at = self.is_looked_at();
        match self.seen.observer.update(input, &self.run.game, looked_at) {
            ticks if self.waits_for_prediction() && (ticks > 0 || !self.seen.observer.frozen()) => {
                return self.ask_for_prediction();
            }
            0 => {}
            ticks => self.step(ticks, input, spectator),
        }
        if self.run.game.outcome() != Outcome::Running && !self.seen.observer.frozen() {
            return if self.run.what_if.is_some() { self.end_what_if(input) } else { self.wait_for_score(input) };
        }
        self.open.hints.time += input.worked();
        if input.acts(Action::Pause) || input.acts(Action::Hint) && self.takes_hint() {
            self.let_go();
            self.open.pause = Some(open::RESUME);
            return None;
        }
        self.fly(input, spectator);
        None
    }

    pub(super) const fn is_looked_at(&self) -> bool {
        self.seen.details || self.seen.picture || self.seen.instruments.is_open()
    }

    fn stage(&self, frame: &Frame) -> Stage<'_> {
        Stage {
            game: &self.run.game,
            history: &self.run.history,
            focus: self.seen.observer.focus(),
            varied: (!self.is_watched()).then(|| self.varied()),
            seekable: self.is_watched() || self.seen.observer.frozen() || self.run.game.outcome() != Outcome::Running,
            before: self.before(),
            seen: !self.seen.picture,
            sign: if self.is_watched() { 0.0 } else { self.time_room(frame) },
        }
    }

    /// Shows the instruments; returns the input that remains for the flight.
    fn show_instruments(&mut self, ui: &mut Ui<'_>) -> Input {
        let mut instruments = std::mem::take(&mut self.seen.instruments);
        let whole = ui.frame();
        let rest = instruments.show(ui, self.above_controls(&whole), &self.stage(&whole));
        self.seen.instruments = instruments;
        Input { frame: whole, ..rest }
    }

    fn serve_instruments(&mut self, spectator: &mut dyn Spectator) -> Option<Request> {
        let wish = self.seen.instruments.vary.wish.take();
        if let Some(request) = wish.and_then(|wish| self.fulfil(wish, spectator)) {
            return Some(request);
        }
        if let Some(tick) = self.seen.instruments.plot.seek.take() {
            self.seek(tick, spectator);
        }
        self.seen.instruments.plot.export.take().map(|file| Request::Do(Effect::Export(file)))
    }

    pub fn attempt(&self) -> &Attempt {
        &self.run.attempt
    }

    pub fn is_test(&self) -> bool {
        self.open.test
    }

    pub const fn observer(&self) -> &Observer {
        &self.seen.observer
    }

    pub const fn instruments(&self) -> &Instruments {
        &self.seen.instruments
    }

    /// The ghosts, if there are any: they were flown in the level as it is.
    pub fn race(&self) -> Option<&Race> {
        self.run.race.as_ref().filter(|_| self.run.what_if.is_none())
    }

    pub const fn history(&self) -> &History {
        &self.run.history
    }

    pub fn is_assisted(&self) -> bool {
        self.run.assisted
    }

    pub fn game(&self) -> &Game {
        &self.run.game
    }

    /// The place of the picture between the last two ticks, 0 … 1.
    fn alpha(&self) -> f64 {
        if self.seen.observer.frozen() || self.pilot.rewind.held.is_some() { 1.0 } else { self.pilot.clock.alpha() }
    }
}

/// The first object that moves or is about to; else the first one.
fn first_mover(game: &Game) -> BodyId {
    let world = game.world();
    let moves = |id: &BodyId| world.body(*id).velocity != DVec2::ZERO || world.forces(*id).resultant() != DVec2::ZERO;
    (game.lead().0..world.bodies().len() as u32).map(BodyId).find(moves).unwrap_or(game.lead())
}
