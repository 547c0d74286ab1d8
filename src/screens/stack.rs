//! The screens that are open, the topmost of which is shown: how a frame goes, and the one place where requests are granted.

use super::screen::{Destination, Effect, GameScene, Request, Screen};
use super::{destinations::open, destinations::reading, editor::Editor, menu::Closing, menu::Menu};
use crate::session::{Places, Session, library, worker::Ticket, worker::Worker};
use crate::settings::{Key, Keys, Settings};
use crate::ui::pace::{self, Pace, Picture};
use crate::ui::{Memory, PassInput, Spectator};
use crate::{draw::Canvas, draw::layout::Frame, scores::Name, ui::input::Input, ui::input::Stale};
use std::io::{self, Write};
use std::path::Path;

/// The most passes that show a frame: the focus has found its place before.
const MOST_PASSES: usize = 3;
/// The panel that names the level appears after this time, s: a level that loads sooner opens without it.
const TOLD_AFTER: f64 = 0.25;

#[derive(Debug)]
struct Loading {
    ticket: Ticket,
    request: Request,
    what: String,
    /// s.
    since: f64,
}

#[derive(Debug)]
pub struct Stack {
    pub session: Session,
    top: Box<dyn Screen>,
    /// What [`Request::Pop`] leads back to, the next one last.
    below: Vec<Box<dyn Screen>>,
    pub memory: Memory,
    /// The keys that another screen or another window was given.
    stale: Stale,
    canvas: Canvas,
    /// Physical pixels a logical one.
    pub dpi: f32,
    /// How long the screen has been there, s.
    pub shown_for: f64,
    pace: Pace,
    loading: Option<Loading>,
}

/// The program may end without a question.
impl Drop for Stack {
    fn drop(&mut self) {
        for problem in self.write_all() {
            // The window is gone, and nothing can be done about a standard error that is closed.
            let _ = writeln!(io::stderr(), "{problem}");
        }
    }
}

impl Stack {
    /// The menu, of the last player; levels are read at once, on the screen's thread.
    pub fn new(places: Places) -> Self {
        Self::with_worker(places, Worker::here())
    }

    /// The same, with a worker that reads the levels.
    pub fn with_worker(places: Places, worker: Worker) -> Self {
        let mut session = Session::new(places, worker);
        Self {
            top: Box::new(Menu::open(&mut session)),
            below: Vec::new(),
            session,
            memory: Memory::default(),
            stale: Stale::default(),
            canvas: Canvas::new(Frame::default()),
            dpi: 1.0,
            shown_for: 0.0,
            pace: Pace::default(),
            loading: None,
        }
    }

    /// Begins with a level in any folder.
    pub fn begin(&mut self, folder: &Path, place: Destination, spectator: &mut dyn Spectator) {
        self.session.library.open(folder);
        self.grant(Request::Reset(place), spectator);
    }

    /// One frame; `false` when the player has chosen to quit.
    pub fn update(&mut self, input: &Input, spectator: &mut dyn Spectator) -> bool {
        let input = &self.with_settings(input);
        self.receive(spectator);
        self.top.look(input.frame_time, &mut self.session);
        let waiting = self.wait_for_loading(input);
        let input = waiting.as_ref().unwrap_or(input);
        self.shown_for += input.frame_time;
        let asked = self.act(input, spectator);
        self.top.attend(&mut self.session);
        let dropped = input.dropped.first().filter(|path| self.all().all(|screen| screen.takes(path))).cloned();
        match asked.or_else(|| dropped.map(|path| Request::Reset(Destination::Dropped(path)))) {
            Some(Request::QuitAnyway) => return false,
            Some(Request::Quit) => {
                // The question of what would be lost may have been answered by another try.
                self.stay();
                if self.may_close() {
                    return false;
                }
            }
            Some(request) => self.grant(request, spectator),
            None => {}
        }
        self.top.attend(&mut self.session);
        self.receive(spectator);
        self.show_frame(&input.without_edges(), spectator);
        self.pace.decide(self.screen().motion(input), input.frame_time, self.shown_for);
        true
    }

    /// The input with what the player has set; F11 and Alt+Enter fill the screen, or give it back, and mean nothing else.
    fn with_settings(&mut self, input: &Input) -> Input {
        let alt_enter = input.held.has(Key::Alt) && input.pressed.has(Key::Enter);
        if input.pressed.has(Key::F11) || alt_enter {
            self.set(Settings { fullscreen: !self.session.settings.fullscreen, ..self.session.settings });
        }
        let frame_time = pace::passed(input.frame_time);
        let clipboard = self.session.clipboard.clone();
        let mut input = Input { settings: self.session.settings, clipboard, frame_time, ..input.clone() };
        input.idle = self.pace.note(&input);
        input.held = self.stale.sift(&input, if input.away { Keys::default() } else { input.held });
        input.pressed = input.pressed.without(Key::F11);
        if alt_enter {
            input.pressed = input.pressed.without(Key::Enter);
        }
        input
    }

    fn act(&mut self, input: &Input, spectator: &mut dyn Spectator) -> Option<Request> {
        self.canvas.begin(input.frame, self.dpi, self.top.is::<Editor>());
        let stage = PassInput { input, canvas: &self.canvas, spectator, time: self.shown_for };
        self.memory.act(stage, |ui| self.top.show(ui))
    }

    fn show_frame(&mut self, input: &Input, spectator: &mut dyn Spectator) {
        let input = &Input { over: self.game_below(&input.frame).is_some(), ..input.clone() };
        for _ in 0..MOST_PASSES {
            self.canvas.begin(input.frame, self.dpi, self.top.is::<Editor>());
            let stage = PassInput { input, canvas: &self.canvas, spectator: &mut *spectator, time: self.shown_for };
            let nothing_more = self.memory.show(stage, |ui| self.top.show(ui));
            debug_assert!(nothing_more.is_none(), "nobody has asked for {nothing_more:?}");
            if self.memory.is_settled() {
                break;
            }
        }
    }

    fn all(&self) -> impl Iterator<Item = &dyn Screen> {
        self.below.iter().chain([&self.top]).map(|screen| &**screen)
    }

    /// What is on the screen.
    pub fn screen(&self) -> &dyn Screen {
        &*self.top
    }

    /// The game on it or behind it.
    pub fn scene(&self, frame: &Frame) -> Option<GameScene<'_>> {
        self.top.scene(frame).or_else(|| self.game_below(frame))
    }

    fn game_below(&self, frame: &Frame) -> Option<GameScene<'_>> {
        let below = self.below.last().filter(|_| self.top.lies_over())?;
        below.scene(frame)
    }

    /// What the last frame has shown.
    pub fn canvas(&self) -> &Canvas {
        &self.canvas
    }

    /// Who plays.
    pub fn player(&self) -> &Name {
        self.session.journal.current()
    }

    /// How much of it its curtain still hides, 0 … 1.
    pub fn veil(&self) -> f64 {
        pace::veil(self.shown_for)
    }

    /// The least time from the last frame to the one with that input, s.
    pub fn interval(&self, input: &Input) -> f64 {
        self.pace.interval(self.screen().motion(input), input)
    }

    /// What becomes of the frame that was updated last.
    pub const fn picture(&self) -> Picture {
        self.pace.picture
    }

    /// What the player has set.
    pub fn settings(&self) -> &Settings {
        &self.session.settings
    }

    /// Takes new settings over, saves them, and says where that failed.
    pub fn set(&mut self, settings: Settings) {
        self.session.set(settings);
        for screen in self.below.iter_mut().chain([&mut self.top]) {
            screen.tell_of_settings(&self.session.settings, &self.session.settings_problems);
        }
    }

    /// What is loading, once that takes longer than a moment.
    pub fn loading(&self) -> Option<&str> {
        self.loading.as_ref().filter(|loading| loading.since > TOLD_AFTER).map(|loading| loading.what.as_str())
    }

    /// Whether a request waits for the worker.
    pub const fn is_loading(&self) -> bool {
        self.loading.is_some()
    }

    /// Does what is asked for, as soon as what that needs is read.
    pub fn grant(&mut self, request: Request, spectator: &mut dyn Spectator) {
        self.stop_loading();
        let read = match &request {
            Request::Push(place) | Request::Replace(place) | Request::Reset(place) => reading(place, &mut self.session),
            Request::Do(effect) => {
                let level = self.top.reads(effect, &self.session);
                level.map(|name| (self.session.level_errand(&name), library::named(&name)))
            }
            Request::Pop | Request::Quit | Request::QuitAnyway => None,
        };
        match read {
            None => self.enter(request, spectator),
            Some((errand, what)) => {
                let ticket = self.session.worker.ask(errand);
                self.loading = Some(Loading { ticket, request, what, since: 0.0 });
                self.receive(spectator);
            }
        }
    }

    /// The one place where requests are granted; what the worker was to read for them is there.
    fn enter(&mut self, request: Request, spectator: &mut dyn Spectator) {
        match request {
            Request::Push(place) => {
                self.show(place, true, spectator);
            }
            Request::Replace(place) => {
                self.show(place, false, spectator);
            }
            Request::Reset(place) => {
                // A screen that cannot be had leaves all as it is.
                let below = std::mem::take(&mut self.below);
                if !self.show(place, false, spectator) {
                    self.below = below;
                }
            }
            Request::Pop if self.top.is::<Closing>() => self.stay(),
            Request::Pop => match self.below.pop() {
                Some(screen) => {
                    self.top.leave(&mut self.session);
                    let above = std::mem::replace(&mut self.top, screen);
                    self.top.come_back(&*above, &mut self.session, spectator);
                    self.begin_screen();
                }
                None => self.grant(Request::Reset(self.top.parent()), spectator),
            },
            Request::Do(Effect::Set(settings)) => self.set(settings),
            Request::Do(Effect::Choose(name, named)) => {
                // What is written on a sheet is the player's before.
                self.top.leave(&mut self.session);
                self.session.choose(name, named);
                self.grant(Request::Pop, spectator);
            }
            Request::Do(effect) => {
                if let Some(request) = self.top.carry_out(effect, &mut self.session, spectator) {
                    self.grant(request, spectator);
                }
            }
            Request::Quit | Request::QuitAnyway => {}
        }
    }

    /// Shows the screen of that place; whether it can be had, or else the present one says why not.
    fn show(&mut self, place: Destination, above: bool, spectator: &mut dyn Spectator) -> bool {
        self.top.leave(&mut self.session);
        match open(place, &mut self.session, spectator) {
            Ok(screen) => {
                let before = std::mem::replace(&mut self.top, screen);
                if above {
                    self.below.push(before);
                }
                self.begin_screen();
                true
            }
            Err(reason) => {
                self.top.refuse(reason);
                false
            }
        }
    }

    /// The screen on the top has just come there: its widgets remember nothing.
    fn begin_screen(&mut self) {
        (self.memory, self.stale, self.shown_for) = (Memory::default(), self.stale.all(), 0.0);
    }

    fn receive(&mut self, spectator: &mut dyn Spectator) {
        while let Some((ticket, brought)) = self.session.worker.bring() {
            match self.loading.take_if(|loading| loading.ticket == ticket) {
                Some(Loading { request, .. }) => {
                    self.session.prepare(brought);
                    self.enter(request, spectator);
                    self.session.forget_prepared();
                }
                None => self.top.receive(ticket, brought, &mut self.session, spectator),
            }
        }
    }

    /// One frame in which a request waits: Esc takes it back. What is left of the input for the screen.
    fn wait_for_loading(&mut self, input: &Input) -> Option<Input> {
        let loading = self.loading.as_mut()?;
        loading.since += input.frame_time;
        if input.pressed(Key::Escape) {
            self.stop_loading();
        }
        // The screen below goes on by itself, and takes no key or click.
        Some(Input { frame_time: input.frame_time, ..input.without_edges() })
    }

    fn stop_loading(&mut self) {
        if let Some(loading) = self.loading.take() {
            self.session.worker.forget(loading.ticket);
        }
    }

    /// Whether the window may close at once: everything is saved, or kept for the next time. Else a screen asks.
    pub fn may_close(&mut self) -> bool {
        if self.top.is::<Closing>() {
            return false;
        }
        let mut losses = self.write_all();
        let failed = !losses.is_empty();
        losses.extend(self.session.nameless().map(|(_, points)| points));
        if losses.is_empty() {
            return true;
        }
        let closing = Box::new(Closing::new(losses, failed));
        self.below.push(std::mem::replace(&mut self.top, closing));
        self.begin_screen();
        false
    }

    /// Back to the screen that waits behind the question; a flight is paused.
    fn stay(&mut self) {
        if let Some(behind) = self.below.pop_if(|_| self.top.is::<Closing>()) {
            self.top = behind;
            self.top.halt();
            self.begin_screen();
        }
    }

    /// Writes down what waits, as far as that can be done; the rest in words, a line each.
    fn write_all(&mut self) -> Vec<String> {
        let screens = self.below.iter_mut().chain([&mut self.top]);
        let losses: Vec<String> = screens.filter_map(|screen| screen.write_down(&mut self.session).err()).collect();
        losses.into_iter().chain(self.session.write_all()).collect()
    }

    /// Whether something is not written yet. Nothing is tried.
    pub fn is_at_risk(&self) -> bool {
        self.all().any(|screen| screen.is_at_risk()) || !self.session.is_written()
    }
}
