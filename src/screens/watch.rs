//! A recorded flight that is watched: played, paused, slowed down, gone through tick by tick in both directions. What is shown is the game
//! itself, flown again to the moment that is asked for.

use super::ahead::Ahead;
use super::input::Repeat;
use super::instruments::{Instruments, Stage};
use super::observer;
use super::{Input, Key, Motion, Request, Screen, Spectator, Toolbar, Visit};
use crate::draw::layout::{Area, Frame, Vec2};
use crate::game::{Game, Reel};
use crate::settings::Action;
use crate::settings::Settings;
use crate::ui::Ui;
use crate::view::focus::Focus;
use std::path::PathBuf;

/// How fast it can be played.
pub const PACES: [f64; 7] = [0.125, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0];
/// As it was flown.
const AS_FLOWN: usize = 3;
/// A frame is taken for no longer than this, s: after a hitch the flight goes on where it was.
const LONGEST_FRAME: f64 = 1.0 / 15.0;
/// What a page is, s.
const PAGE: f64 = 1.0;
/// Height of the controls at the canvas' foot: the flight is above them.
pub const FOOT: f32 = 144.0;
/// The keys that have a button; the arrows also repeat.
const KEYS: [Key; 7] = [Key::Escape, Key::Space, Key::Left, Key::Right, Key::Down, Key::Up, Key::Tab];

/// The screen.
#[derive(Debug)]
pub struct Watch {
    visit: Visit,
    title: String,
    reel: Reel,
    game: Game,
    /// Ticks that are due, and the part of one that is left over.
    due: f64,
    pace: usize,
    paused: bool,
    details: bool,
    focus: Focus,
    hitboxes: bool,
    instruments: Instruments,
    /// Whether the pointer holds the line of time.
    dragged: bool,
    /// How many ticks are flown ahead in a frame.
    ahead: Ahead,
    repeat: Repeat,
    toolbar: Toolbar,
    line: Area,
}

impl Screen for Watch {
    fn show(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        let rest = self.measure(ui);
        self.update(&rest, ui.spectator)
    }

    fn motion(&self, _: &Input) -> Motion {
        if self.paused { Motion::Still } else { Motion::Full }
    }

    fn tune(&self) -> Option<&str> {
        Some(&self.game.level().name)
    }

    fn text_scale(&self, settings: &Settings, _: f32) -> f32 {
        f32::from(settings.scale) / 100.0
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
        let whole = canvas.use_frame(above(canvas.frame()));
        theatre.set_panels(self.instruments.areas(canvas.frame()));
        canvas.use_frame(self.instruments.room(canvas.frame()));
        theatre.draw_watched(self, moment.settings, moment.frame_time, canvas);
        canvas.use_frame(whole);
        self.draw_controls(canvas);
    }
}

impl Watch {
    /// That flight from its start; the way back leads to the flights that it was chosen from.
    pub fn new(visit: Visit, title: String, reel: Reel, spectator: &mut dyn Spectator) -> Self {
        let game = reel.history().at(0);
        spectator.begins(&game);
        Self {
            visit,
            title,
            reel,
            game,
            due: 0.0,
            pace: AS_FLOWN,
            paused: false,
            details: false,
            focus: Focus::default(),
            hitboxes: false,
            instruments: Instruments::default(),
            dragged: false,
            ahead: Ahead::default(),
            repeat: Repeat::default(),
            toolbar: Toolbar::default(),
            line: Area::default(),
        }
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
        self.line = line(&input.frame);
        if let Some(tick) = self.instruments.take_seek() {
            self.paused = true;
            self.go(tick, spectator);
        }
        if let Some(file) = self.instruments.take_export() {
            return Some(Request::Export(file));
        }
        self.fly_ahead(input.worked());
        // The arrows to the sides repeat; the rest of the row does not.
        let once = [Key::Left, Key::Right, Key::PadLeft, Key::PadRight].into_iter().collect();
        let row = self.toolbar.update(&Input { pressed: input.pressed.less(once), ..input.clone() }, &KEYS);
        match row {
            Some(0) => return Some(Request::Flights(self.visit.clone())),
            Some(1) => self.play_or_pause(spectator),
            Some(2) => self.step(-1, spectator),
            Some(3) => self.step(1, spectator),
            Some(4) => self.pace = self.pace.saturating_sub(1),
            Some(5) => self.pace = (self.pace + 1).min(PACES.len() - 1),
            Some(_) => self.details = !self.details,
            None => self.follow_keys(input, spectator),
        }
        observer::zoom(&mut self.focus, input);
        // What is below the line of time is its own.
        if (self.details || self.instruments.is_open()) && row.is_none() && input.pointer.y < self.line.min.y {
            observer::look(&mut self.focus, input, &self.game);
        }
        self.drag(input, spectator);
        self.play(input.frame_time, spectator);
        None
    }

    /// What the instruments see.
    fn stage(&self) -> Stage<'_> {
        Stage { game: &self.game, history: self.reel.history(), focus: &self.focus, varied: None, seekable: true, before: None }
    }

    /// Shows the instruments; returns the input that remains for the flight.
    fn measure(&mut self, ui: &mut Ui<'_>) -> Input {
        let mut instruments = std::mem::take(&mut self.instruments);
        let whole = ui.frame();
        let rest = instruments.show(ui, above(&whole), &self.stage());
        self.instruments = instruments;
        Input { frame: whole, ..rest }
    }

    /// Keys that have no button, or repeat.
    fn follow_keys(&mut self, input: &Input, spectator: &mut dyn Spectator) {
        let second = (PAGE * self.game.tick_rate()).round() as i64;
        for key in self.repeat.strokes(input, &[Key::Left, Key::Right, Key::PageUp, Key::PageDown]) {
            match key {
                Key::Left => self.step(-1, spectator),
                Key::Right => self.step(1, spectator),
                Key::PageUp => self.step(-second, spectator),
                _ => self.step(second, spectator),
            }
        }
        if input.pressed(Key::Enter) {
            self.play_or_pause(spectator);
        }
        if input.pressed(Key::Home) || input.acts(Action::Restart) {
            self.go(0, spectator);
        }
        if input.pressed(Key::End) {
            self.paused = true;
            self.go(u64::MAX, spectator);
        }
        // Tab has a button; the gamepad's has not.
        self.details ^= input.acts(Action::Details) && !input.pressed.has(Key::Tab);
        self.hitboxes ^= input.acts(Action::Hitboxes);
    }

    /// What is watched.
    pub fn title(&self) -> &str {
        &self.title
    }

    /// The game at the moment that is shown.
    pub const fn game(&self) -> &Game {
        &self.game
    }

    /// Where between the last two ticks to draw, 0 … 1. What stands still is drawn where it is.
    pub fn alpha(&self) -> f64 {
        if self.paused { 1.0 } else { self.due.clamp(0.0, 1.0) }
    }

    /// The tick that is shown, and how many are known.
    pub fn place(&self) -> (u64, u64) {
        (self.game.ticks(), self.reel.ticks())
    }

    /// Whether all of the flight is known.
    pub const fn is_whole(&self) -> bool {
        self.reel.is_whole()
    }

    /// Whether it stands still.
    pub const fn paused(&self) -> bool {
        self.paused
    }

    /// How fast it is played, 1 as it was flown.
    pub fn pace(&self) -> f64 {
        PACES[self.pace]
    }

    /// Whether forces are shown.
    pub const fn details(&self) -> bool {
        self.details
    }

    /// Of whom the details tell.
    pub const fn focus(&self) -> &Focus {
        &self.focus
    }

    /// Whether hitboxes and costs are shown.
    pub const fn hitboxes(&self) -> bool {
        self.hitboxes
    }

    /// What it is measured with.
    pub const fn instruments(&self) -> &Instruments {
        &self.instruments
    }

    /// Its buttons.
    pub const fn toolbar(&self) -> &Toolbar {
        &self.toolbar
    }

    /// The line of time.
    pub const fn line(&self) -> Area {
        self.line
    }

    /// Flies the record ahead of what is shown, so that any of it can be gone to.
    fn fly_ahead(&mut self, frame_time: f64) {
        if frame_time <= 0.0 || self.reel.is_whole() {
            return;
        }
        self.reel.fly(self.ahead.ticks(frame_time));
    }

    fn play_or_pause(&mut self, spectator: &mut dyn Spectator) {
        self.paused = !self.paused;
        self.due = 0.0;
        if !self.paused && self.is_at_end() {
            self.go(0, spectator);
        }
    }

    fn is_at_end(&self) -> bool {
        self.reel.is_whole() && self.game.ticks() >= self.reel.ticks()
    }

    /// Stops, and goes so many ticks on or back.
    fn step(&mut self, ticks: i64, spectator: &mut dyn Spectator) {
        self.paused = true;
        self.go(self.game.ticks().saturating_add_signed(ticks), spectator);
    }

    /// Shows the moment after so many ticks, or the last that is known.
    fn go(&mut self, tick: u64, spectator: &mut dyn Spectator) {
        let before = self.game.ticks();
        self.reel.history().seek(&mut self.game, tick);
        if self.game.ticks() == before + 1 {
            spectator.after_tick(&self.game);
        } else if self.game.ticks() != before {
            spectator.jumped(&self.game);
        }
    }

    fn play(&mut self, frame_time: f64, spectator: &mut dyn Spectator) {
        if self.paused || self.dragged {
            return;
        }
        self.due += frame_time.clamp(0.0, LONGEST_FRAME) * self.game.tick_rate() * self.pace();
        while self.due >= 1.0 {
            self.due -= 1.0;
            let next = self.game.ticks() + 1;
            self.go(next, spectator);
        }
        if self.is_at_end() {
            self.paused = true;
        }
    }

    /// The pointer on the line of time.
    fn drag(&mut self, input: &Input, spectator: &mut dyn Spectator) {
        if input.click && self.line.inset(-8.0).contains(input.pointer) {
            self.dragged = true;
        }
        self.dragged &= input.holding || input.click;
        if self.dragged {
            let part = ((input.pointer.x - self.line.min.x) / self.line.size.x).clamp(0.0, 1.0);
            self.go((f64::from(part) * self.reel.ticks() as f64).round() as u64, spectator);
        }
    }
}

/// The part of the canvas in which the flight is: above the controls.
pub const fn above(frame: &Frame) -> Frame {
    Frame { size: Vec2::new(frame.size.x, frame.size.y - FOOT), ..*frame }
}

/// Where the line of time is.
fn line(frame: &Frame) -> Area {
    const SIDES: f32 = 264.0;
    Area { min: Vec2::new(SIDES, frame.size.y - FOOT + 44.0), size: Vec2::new(frame.size.x - 2.0 * SIDES, 12.0) }
}

mod drawing {
    use super::{FOOT, Watch};
    use crate::draw::layout::{Area, TEXT, Vec2};
    use crate::draw::{Canvas, Style};
    use crate::number::clock;
    use crate::view::{theme, widgets};

    impl Watch {
        /// Draws the controls below the flight, and whose flight it is.
        pub fn draw_controls(&self, canvas: &Canvas) {
            let size = canvas.size();
            canvas.rounded(Area::new(0.0, size.y - FOOT, size.x, FOOT), 0.0, theme::panel());
            canvas.line(Vec2::new(0.0, size.y - FOOT), Vec2::new(size.x, size.y - FOOT), 2.0, theme::panel_edge());
            let (tick, known) = self.place();
            let (line, rate) = (self.line, self.game.tick_rate());
            let part = if known > 0 { tick as f32 / known as f32 } else { 0.0 };
            canvas.rounded(line, 6.0, theme::ground());
            canvas.rounded(Area { size: Vec2::new(line.size.x * part, line.size.y), ..line }, 6.0, theme::accent());
            canvas.disc(Vec2::new(line.min.x + line.size.x * part, line.centre().y), 10.0, theme::text());
            let y = line.centre().y;
            let number = Style::new(TEXT, theme::text()).mono().middle();
            // On the clock of the flight.
            let idle = self.reel.history().inputs().idle().unwrap_or(0);
            let time = |tick: u64| clock(tick.saturating_sub(idle) as f64 / rate);
            let at = format!("{} / {}", time(tick), time(known));
            canvas.text(&at, Vec2::new(24.0, y), number);
            let pace = if self.paused { format!("paused · {}", pace(self.pace())) } else { pace(self.pace()) };
            canvas.text(&pace, Vec2::new(size.x - 24.0, y), number.right());
            let play = if self.paused { "Play" } else { "Pause" };
            self.toolbar.draw(
                canvas,
                &[
                    ("Back", "Esc"),
                    (play, "Space"),
                    ("Step", "←"),
                    ("Step", "→"),
                    ("Slower", "↓"),
                    ("Faster", "↑"),
                    ("Forces", "Tab"),
                ],
            );
            let title = Vec2::new(size.x / 2.0, size.y - FOOT + 20.0);
            widgets::fitted(canvas, &self.title, title, size.x - 64.0, &[TEXT], theme::quiet());
        }
    }

    /// A pace as one reads it: 1/8×, 4×.
    fn pace(pace: f64) -> String {
        if pace < 1.0 { format!("1/{}×", 1.0 / pace) } else { format!("{pace}×") }
    }
}
