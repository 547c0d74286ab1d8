//! The game screen: an attempt at a level, flown by hand, by recorded inputs, or watched from a reel.

mod ahead;
mod ending;
mod hints;
pub mod instruments;
mod modifiers;
mod news;
pub mod observer;
mod pause;
mod pilot;
pub mod race;
mod reel;
mod reload;
mod rewind;
mod signs;
mod viewer;
mod what_if;
mod what_if_drawing;
mod worksheet;

use crate::draw::Canvas;
use crate::draw::layout::Frame;
use crate::game::{Clock, Game, GameError, History, Medals, Outcome};
use crate::level::Level;
use crate::physics::{BodyId, DVec2};
use crate::screens::flight::ahead::Ahead;
use crate::screens::flight::instruments::{Instruments, Stage};
use crate::screens::flight::observer::Observer;
use crate::screens::flight::race::Race;
use crate::screens::screen::{AboveGame, Destination, Effect, GameScene, Request, Screen};
use crate::screens::settings::SettingsPanel;
use crate::session::Session;
use crate::session::answers::Worksheet;
use crate::session::attempt::Attempt;
use crate::session::folder_watch::FolderWatch;
use crate::session::library::is_of_level;
use crate::session::worker::{Brought, Ticket};
use crate::settings::{Action, Key, Keys, Settings};
use crate::ui::input::{Input, Stale};
use crate::ui::pace::Motion;
use crate::ui::{Spectator, Ui};
use crate::view::Overlays;
use crate::view::camera::Viewport;
use crate::view::focus::Focus;
use crate::view::hud::{Aside, HudShown};
use ending::{END_PAUSE, Lost};
use hints::Hints;
use modifiers::Modifiers;
use news::News;
use pilot::Pilot;
use rewind::Rewind;
use std::path::Path;
use std::sync::Arc;
use what_if::WhatIf;

#[derive(Debug)]
pub struct Flight {
    attempt: Attempt,
    /// At the moment on the screen.
    game: Game,
    clock: Clock,
    pilot: Pilot,
    /// The keys that a panel or the attempt before was given.
    stale: Stale,
    modifiers: Modifiers,
    /// All flown ticks, which may go beyond the moment on the screen.
    history: History,
    /// The ghosts.
    race: Option<Race>,
    /// The label of the pause panel's last button, while the panel is open.
    pause: Option<&'static str>,
    /// The settings, while they are open above it.
    settings: Option<Box<SettingsPanel>>,
    /// The problems of their file.
    settings_problems: Vec<String>,
    /// Whether the player has had help.
    assisted: bool,
    /// Time since the end of the attempt, s.
    ended: f64,
    details: bool,
    hitboxes: bool,
    observer: Observer,
    instruments: Instruments,
    /// The varied level; its flight does not count.
    what_if: Option<Box<WhatIf>>,
    /// Ticks to fly again in a frame.
    ahead: Ahead,
    /// Whether the flight tries out an edited level: it does not count.
    test: bool,
    /// Whether that level is in memory only.
    in_memory: bool,
    /// The level's files.
    watch: Option<FolderWatch>,
    /// The level, while it is read again.
    reading: Option<Ticket>,
    /// What the attempt, which has ended, brought the player, in words.
    remark: Option<String>,
    /// The state of the level's files, while it is shown.
    news: Option<News>,
    /// The attempt before, while the loss of it is shown.
    lost: Option<Box<Lost>>,
    hints: Hints,
    /// Of an experiment that is listed.
    sheet: Option<Box<Worksheet>>,
    rewind: Rewind,
    /// Up to this tick the flight is shown in slow motion: a goal has been met.
    slow_until: u64,
}

impl Screen for Flight {
    fn show(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        self.age_news(ui.input().frame_time);
        let mut rest = self.show_instruments(ui);
        let given = if self.pause.is_some() { Keys::default() } else { rest.held };
        rest.held = self.stale.sift(ui.input(), given);
        let request = match &self.pilot {
            Pilot::Reel(_) => self.show_reel(ui, &rest),
            _ if self.pause.is_some() => None,
            _ => self.go_on(&rest, ui.spectator),
        };
        self.read_instruments(&ui.frame());
        if !self.is_watched() {
            self.draw_signs(ui.canvas());
        }
        request.or_else(|| self.show_pause(ui))
    }

    fn motion(&self, _: &Input) -> Motion {
        let moves = self.pause.is_none() && (!self.observer.frozen() || self.is_flown_again());
        if moves { Motion::Full } else { Motion::Still }
    }

    fn tune(&self) -> Option<&str> {
        Some(&self.game.level().name)
    }

    fn unsaved(&self) -> Option<String> {
        self.unsaved_score()
    }

    fn takes(&self, path: &Path) -> bool {
        self.is_watched() || self.pause.is_some() || is_of_level(path)
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

    fn parent(&self) -> Destination {
        let name = self.attempt.level.name.clone();
        if self.test { Destination::Edit { name, original: true } } else { Destination::Menu }
    }

    fn reads(&self, effect: &Effect, session: &Session) -> Option<String> {
        let name = &self.attempt.level.name;
        (matches!(effect, Effect::Restart) && self.reads_again(session)).then(|| name.clone())
    }

    fn carry_out(&mut self, effect: Effect, session: &mut Session, spectator: &mut dyn Spectator) -> Option<Request> {
        match effect {
            Effect::Restart => self.restart_as_on_disk(session, spectator),
            Effect::Export(file) => self.instruments.report_export(file.write(&session.places.root.join("exports"))),
            Effect::HandIn(row) => self.hand_in(row, session),
            Effect::SaveVaried(variation, name) => {
                let saved = self.save_varied(&variation, &name, session);
                let bad = saved.is_err();
                self.instruments.vary_mut().tell(saved.unwrap_or_else(|reason| reason), bad);
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
            && self.reading.take_if(|reading| *reading == ticket).is_some()
        {
            self.take_over_from_disk(&folder, level, session, spectator);
        }
    }

    /// Pauses a flight that is under way.
    fn halt(&mut self) {
        if self.game.outcome() == Outcome::Running && !self.is_watched() && self.pause.is_none() {
            self.let_go();
            self.pause = Some(pause::RESUME);
        }
    }

    fn leave(&mut self, session: &mut Session) {
        // An answer that cannot be written waits in the session.
        let _ = self.write_down(session);
        if let Some(sheet) = self.sheet.take() {
            session.answers.sheets.insert(sheet.folder().to_owned(), *sheet);
        }
    }

    fn come_back(&mut self, _: &dyn Screen, session: &mut Session, spectator: &mut dyn Spectator) {
        if let Some(watch) = &self.watch {
            session.library.open(watch.folder());
        }
        session.last_level = Some(self.attempt.level.name.clone());
        spectator.begins(&self.game);
        self.take_sheet(session);
    }

    fn write_down(&mut self, session: &mut Session) -> Result<(), String> {
        if let Some(row) = self.sheet.as_mut().and_then(|sheet| sheet.take_unsaved()) {
            self.hand_in(row, session);
        }
        Ok(())
    }

    fn is_at_risk(&self) -> bool {
        self.sheet.as_ref().is_some_and(|sheet| sheet.is_unsaved())
    }

    fn scene(&self, frame: &Frame) -> Option<GameScene<'_>> {
        let (level, above) = (self.game.level(), self.above_controls(frame));
        let race = self.race();
        let status = level.ship_plays();
        let medal = status && !self.is_watched() && !self.assisted && Medals::has_clock(&level.awards);
        let rivals = race.map_or(0, |race| race.all().len());
        let shown = HudShown { status, fuel: status && level.player.has_engine(), rivals, medal };
        let focus = *self.observer.focus();
        // Nobody is selected without details and instruments.
        let focus = if self.details || self.instruments.is_open() { focus } else { focus.on_nobody() };
        let (details, hitboxes, watched, map) = (self.details, self.hitboxes, self.is_watched(), self.observer.shows_map());
        Some(GameScene {
            game: &self.game,
            alpha: self.alpha(),
            room: self.instruments.room(&above),
            overlays: Overlays { settings: Settings::default(), details, shown, focus, hitboxes, watched, map },
            speed: if self.pause.is_some() { 0.0 } else { self.observer.speed() * self.slowness() },
            paused: self.pause.is_some(),
            quiet: false,
            ghosts: self.ghosts(),
            panels: self.panels(frame),
            above: self,
        })
    }
}

impl AboveGame for Flight {
    fn draw_in_level(&self, alpha: f64, view: &Viewport, canvas: &Canvas) {
        if self.instruments.is_open() {
            self.instruments.draw_in_level((&self.game, alpha), view, canvas);
        }
    }

    fn draw_beside_timer(&self, aside: &Aside, canvas: &Canvas) {
        if let Some(race) = self.race() {
            race.draw(&self.game, aside, canvas);
        }
    }
}

impl Flight {
    /// Shows the details of a body, of all where that is `None`, or hides them.
    pub(super) fn show_as(&mut self, body: Option<BodyId>, details: Option<bool>) {
        self.details = details.unwrap_or(self.details || body.is_some());
        if let Some(body) = body {
            self.observer.look_at(Focus::fitted_on(body));
        }
    }

    /// An attempt at its start.
    ///
    /// # Errors
    /// The level makes no world.
    pub fn new(attempt: Attempt, spectator: &mut dyn Spectator) -> Result<Self, GameError> {
        let game = Game::new(attempt.level.clone())?;
        let race = Race::new(&attempt.level, &attempt.rivals)?;
        spectator.begins(&game);
        let pilot = Pilot::of(&attempt);
        let mut flight = Self { race, ..Self::at_start(attempt, game, pilot) };
        if !flight.game.level().ship_plays() {
            flight.details = true;
            flight.observer.look_at(Focus::fitted_on(first_mover(&flight.game)));
            flight.wait_for_a_guess();
        }
        Ok(flight)
    }

    /// An attempt at its start, whose level's files are watched.
    ///
    /// # Errors
    /// The level makes no world; so of all that follow.
    pub fn open(attempt: Attempt, session: &mut Session, spectator: &mut dyn Spectator) -> Result<Self, GameError> {
        session.last_level = Some(attempt.level.name.clone());
        let watch = Some(session.library.watch(&attempt.level));
        let mut flight = Self { watch, ..Self::new(attempt, spectator)? };
        flight.tell_of_settings(&session.settings, &session.settings_problems);
        flight.take_sheet(session);
        Ok(flight)
    }

    /// An attempt that tries out an edited level, in memory only or as its files are: Esc and F5 lead back to the editor, and so does its end.
    pub(super) fn test(
        (level, in_memory): (Arc<Level>, bool),
        left: Vec<String>,
        session: &Session,
        spectator: &mut dyn Spectator,
    ) -> Result<Self, GameError> {
        let news = (!left.is_empty()).then_some(News::Unfinished(left));
        let mut flight = Self { test: true, in_memory, news, ..Self::new(Attempt::by_hand(level), spectator)? };
        flight.tell_of_settings(&session.settings, &[]);
        Ok(flight)
    }

    /// An experiment that is flown by hand stands still at its start: a pupil looks and guesses before anything moves.
    pub(super) fn wait_for_a_guess(&mut self) {
        if self.is_by_hand() && !self.game.level().ship_plays() {
            self.observer.freeze();
        }
    }

    fn at_start(attempt: Attempt, game: Game, pilot: Pilot) -> Self {
        Self {
            attempt,
            clock: Clock::new(game.tick_rate()),
            history: History::new(&game),
            game,
            pilot,
            stale: Stale::default(),
            modifiers: Modifiers::default(),
            race: None,
            pause: None,
            settings: None,
            settings_problems: Vec::new(),
            assisted: false,
            ended: 0.0,
            details: false,
            hitboxes: false,
            observer: Observer::default(),
            instruments: Instruments::default(),
            what_if: None,
            ahead: Ahead::within(what_if::AGAIN),
            test: false,
            in_memory: false,
            watch: None,
            reading: None,
            remark: None,
            news: None,
            lost: None,
            hints: Hints::default(),
            sheet: None,
            rewind: Rewind::default(),
            slow_until: 0,
        }
    }

    /// A frame of an attempt without a pause.
    fn go_on(&mut self, input: &Input, spectator: &mut dyn Spectator) -> Option<Request> {
        if self.test && (input.pressed(Key::F5) || input.pressed(Key::Escape) || input.acts(Action::Pause)) {
            return Some(Request::Pop);
        }
        if let Some(request) = self.follow_lost(input).or_else(|| self.serve_instruments(spectator)) {
            return Some(request);
        }
        if input.acts(Action::Restart) {
            return Some(Request::Do(Effect::Restart));
        }
        self.switch_overlays(input);
        if self.update_what_if(input.worked(), spectator) {
            return None;
        }
        if self.rewind(input, spectator) {
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
            self.let_go();
            self.pause = Some(pause::RESUME);
            return None;
        }
        self.fly(input, spectator);
        None
    }

    /// As the instruments see it in that frame.
    fn stage(&self, frame: &Frame) -> Stage<'_> {
        Stage {
            game: &self.game,
            history: &self.history,
            focus: self.observer.focus(),
            varied: (!self.is_watched()).then(|| self.varied()),
            seekable: self.is_watched() || self.observer.frozen() || self.game.outcome() != Outcome::Running,
            before: self.before(),
            sign: if self.is_watched() { 0.0 } else { self.time_room(frame) },
        }
    }

    /// Shows the instruments; returns the input that remains for the flight.
    fn show_instruments(&mut self, ui: &mut Ui<'_>) -> Input {
        let mut instruments = std::mem::take(&mut self.instruments);
        let whole = ui.frame();
        let rest = instruments.show(ui, self.above_controls(&whole), &self.stage(&whole));
        self.instruments = instruments;
        Input { frame: whole, ..rest }
    }

    /// Reads the moment on the screen, at the end of its frame.
    fn read_instruments(&mut self, frame: &Frame) {
        let mut instruments = std::mem::take(&mut self.instruments);
        instruments.read(&self.stage(frame));
        self.instruments = instruments;
    }

    /// Fulfils the wishes of the instruments.
    fn serve_instruments(&mut self, spectator: &mut dyn Spectator) -> Option<Request> {
        let wish = self.instruments.vary_mut().take_wish();
        if let Some(request) = wish.and_then(|wish| self.fulfil(wish, spectator)) {
            return Some(request);
        }
        if let Some(tick) = self.instruments.take_seek() {
            self.seek(tick, spectator);
        }
        self.instruments.take_export().map(|file| Request::Do(Effect::Export(file)))
    }

    pub(super) fn attempt(&self) -> &Attempt {
        &self.attempt
    }

    /// Whether the flight tries out an edited level.
    pub fn is_test(&self) -> bool {
        self.test
    }

    pub const fn observer(&self) -> &Observer {
        &self.observer
    }

    pub const fn instruments(&self) -> &Instruments {
        &self.instruments
    }

    /// The ghosts, if there are any: they were flown in the level as it is.
    pub fn race(&self) -> Option<&Race> {
        self.race.as_ref().filter(|_| self.what_if.is_none())
    }

    pub const fn history(&self) -> &History {
        &self.history
    }

    /// Whether the player has had help.
    pub fn is_assisted(&self) -> bool {
        self.assisted
    }

    /// At the moment on the screen.
    pub fn game(&self) -> &Game {
        &self.game
    }

    /// The place of the picture between the last two ticks, 0 … 1.
    fn alpha(&self) -> f64 {
        if self.observer.frozen() || self.rewind.held.is_some() { 1.0 } else { self.clock.alpha() }
    }
}

/// The first object that moves or is about to; else the first one.
fn first_mover(game: &Game) -> BodyId {
    let world = game.world();
    let moves = |id: &BodyId| world.body(*id).velocity != DVec2::ZERO || world.forces(*id).resultant() != DVec2::ZERO;
    (game.lead().0..world.bodies().len() as u32).map(BodyId).find(moves).unwrap_or(game.lead())
}
