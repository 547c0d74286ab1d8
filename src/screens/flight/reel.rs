//! A recorded flight on the screen: played, paused, slowed down, tick by tick in both directions. It is flown again to the wanted moment.

use super::{Flight, pilot::Controller, pilot::Viewer};
use crate::draw::layout::{Area, Frame, TEXT, Vec2};
use crate::game::{Clock, Outcome, Reel};
use crate::screens::screen::{GameScene, Request, Screen};
use crate::ui::{Spectator, Ui, WidgetKind, input::Input};
use crate::view::{Overlays, hud::HudShown, theme, widgets};
use crate::{draw::Canvas, draw::Style, settings::Action, settings::Key, words::tr};
use crate::{number::clock, screens::flight::observer::Observer, screens::flight::pilot::Ahead, session::library::Attempt};

/// Paces of a reel; 1 is the pace of the flight.
const PACES: [f64; 7] = [0.125, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0];
/// The most of a frame's time that counts, s: after a hitch the flight goes on where it was.
const LONGEST_FRAME: f64 = 1.0 / 15.0;
/// Rest of a flight behind another screen at its end, s.
const REST: f64 = 2.0;
/// A page, s.
const PAGE: f64 = 1.0;
/// Height of the controls at the canvas' foot: the flight is above them.
const FOOT: f32 = 144.0;
/// From the sides of the canvas to the ends of the time line.
const SIDES: f32 = 264.0;
/// The pointer takes the time line within this distance.
const NEAR: f32 = 8.0;

const BACK: &str = "Back";
const PLAY: &str = "Play";
const PAUSE: &str = "Pause";
const STEP_BACK: &str = "Step back";
const STEP_ON: &str = "Step on";
const SLOWER: &str = "Slower";
const FASTER: &str = "Faster";
const FORCES: &str = "Forces";
/// A widget without words of its own.
const TIME_LINE: &str = "Time line";

impl Flight {
    pub(in crate::screens) fn watch(title: String, reel: Reel, spectator: &mut dyn Spectator) -> Self {
        let Reel { history, unflown } = reel;
        let game = history.at(0);
        let attempt = Attempt::by_hand(game.shared_level().clone());
        spectator.begins(&game);
        let viewer = Viewer { title, unflown, ahead: Ahead::default(), dragged: false };
        let mut flight = Self::at_start(attempt, game, Controller::Reel(Box::new(viewer)));
        flight.run.history = history;
        flight.seen.observer = Observer::with_paces(&PACES);
        flight
    }

    /// The part of the canvas above the controls of a reel.
    pub(super) fn above_controls(&self, frame: &Frame) -> Frame {
        let foot = if self.is_watched() { FOOT } else { 0.0 };
        Frame { size: Vec2::new(frame.size.x - self.sheet_width(frame), frame.size.y - foot), ..*frame }
    }

    /// A frame of a reel, with the input that its instruments leave.
    pub(super) fn show_reel(&mut self, ui: &mut Ui<'_>, input: &Input) -> Option<Request> {
        if let Some(request) = self.serve_instruments(ui.spectator) {
            return Some(request);
        }
        self.fly_ahead(input.worked());
        self.follow_keys(ui);
        let size = ui.frame().size;
        let line = Area::new(SIDES, size.y - FOOT + 44.0, size.x - 2.0 * SIDES, 12.0);
        self.seen.observer.zoom(input);
        // Clicks on the controls pick no body.
        if self.is_looked_at() && input.pointer.y < line.min.y {
            self.seen.observer.look(input, &self.run.game);
        }
        self.draw_foot(ui.canvas(), line);
        self.drag(ui, line);
        let request = self.show_tools(ui);
        self.play(input.frame_time, ui.spectator);
        request
    }

    /// Flies the record ahead of the moment on the screen, so that every moment can be shown.
    fn fly_ahead(&mut self, frame_time: f64) {
        let Controller::Reel(viewer) = &mut self.pilot.source else { return };
        if frame_time > 0.0 {
            let ticks = viewer.ahead.ticks(frame_time);
            viewer.unflown.take_if(|unflown| !unflown.fly(&mut self.run.history, ticks));
        }
    }

    fn follow_keys(&mut self, ui: &mut Ui<'_>) {
        let (input, second) = (ui.input(), (PAGE * self.run.game.tick_rate()).round() as i64);
        for key in ui.strokes(&[Key::Left, Key::Right, Key::PageUp, Key::PageDown]) {
            let ticks = match key {
                Key::Left => -1,
                Key::Right => 1,
                Key::PageUp => -second,
                _ => second,
            };
            self.seek(self.run.game.ticks().saturating_add_signed(ticks), ui.spectator);
        }
        if input.pressed(Key::Enter) {
            self.play_or_pause(ui.spectator);
        }
        if input.pressed(Key::Home) || input.acts(Action::Restart) {
            self.show_moment(0, ui.spectator);
        }
        if input.pressed(Key::End) {
            self.seek(u64::MAX, ui.spectator);
        }
        // Tab is the key of a button, whatever else it is set to.
        self.switch_overlays(&Input { pressed: input.pressed.without(Key::Tab), ..input.clone() });
    }

    fn show_tools(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        let play = if self.seen.observer.frozen() { PLAY } else { PAUSE };
        let tools = [
            (BACK, Key::Escape, "Esc"),
            (play, Key::Space, "Space"),
            (STEP_BACK, Key::Left, "←"),
            (STEP_ON, Key::Right, "→"),
            (SLOWER, Key::Down, "↓"),
            (FASTER, Key::Up, "↑"),
            (FORCES, Key::Tab, "Tab"),
        ];
        let now = self.run.game.ticks();
        match ui.tools(&tools)? {
            BACK => return Some(Request::Pop),
            STEP_BACK => self.seek(now.saturating_sub(1), ui.spectator),
            STEP_ON => self.seek(now + 1, ui.spectator),
            SLOWER => self.seen.observer.slow_down(),
            FASTER => self.seen.observer.speed_up(),
            FORCES => self.seen.details ^= true,
            _ => self.play_or_pause(ui.spectator),
        }
        None
    }

    fn play_or_pause(&mut self, spectator: &mut dyn Spectator) {
        self.seen.observer.frozen ^= true;
        self.pilot.clock = Clock::new(self.run.game.tick_rate());
        if !self.seen.observer.frozen() && self.is_at_end() {
            self.show_moment(0, spectator);
        }
    }

    /// A frame of a recorded flight behind another screen: it is flown over and over, and nobody listens.
    pub(in crate::screens) fn play_behind(&mut self, frame_time: f64) {
        self.fly_ahead(frame_time);
        self.play(frame_time, &mut ());
        if self.seen.observer.frozen() {
            self.run.ended += frame_time;
        }
        if self.run.ended > REST {
            self.run.ended = 0.0;
            self.play_or_pause(&mut ());
        }
    }

    pub(in crate::screens) fn scene_behind(&self, frame: &Frame) -> Option<GameScene<'_>> {
        let scene = self.scene(frame)?;
        let overlays = Overlays { shown: HudShown::default(), ..scene.overlays };
        Some(GameScene { room: *frame, overlays, panels: Vec::new(), quiet: true, ..scene })
    }

    fn is_at_end(&self) -> bool {
        let Controller::Reel(viewer) = &self.pilot.source else { return self.run.game.outcome() != Outcome::Running };
        viewer.unflown.is_none() && self.run.game.ticks() >= self.run.history.ticks()
    }

    fn play(&mut self, frame_time: f64, spectator: &mut dyn Spectator) {
        if self.seen.observer.frozen() || matches!(&self.pilot.source, Controller::Reel(viewer) if viewer.dragged) {
            return;
        }
        let tick = 1.0 / self.run.game.tick_rate();
        let mut left = frame_time.min(LONGEST_FRAME) * self.seen.observer.pace();
        // A frame of the fastest pace has more ticks than the clock takes at once.
        while left > 0.0 {
            self.pilot.clock.add(left.min(tick));
            left -= tick;
            if self.pilot.clock.tick() {
                self.show_moment(self.run.game.ticks() + 1, spectator);
            }
        }
        if self.is_at_end() {
            self.seen.observer.freeze();
        }
    }

    fn drag(&mut self, ui: &mut Ui<'_>, line: Area) {
        let (input, touch) = (ui.input(), ui.touch(TIME_LINE, line.inset(-NEAR), WidgetKind::Tool));
        let Controller::Reel(viewer) = &mut self.pilot.source else { return };
        viewer.dragged = touch.pressed || viewer.dragged && input.holding;
        if viewer.dragged {
            let part = ((input.pointer.x - line.min.x) / line.size.x).clamp(0.0, 1.0);
            self.show_moment((f64::from(part) * self.run.history.ticks() as f64).round() as u64, ui.spectator);
        }
    }

    /// The ground of the controls, the time line, and the words on the flight.
    fn draw_foot(&self, canvas: &Canvas, line: Area) {
        let Controller::Reel(viewer) = &self.pilot.source else { return };
        let (size, top) = (canvas.size(), canvas.size().y - FOOT);
        canvas.rounded(Area::new(0.0, top, size.x, FOOT), 0.0, theme::panel());
        canvas.line(Vec2::new(0.0, top), Vec2::new(size.x, top), 2.0, theme::panel_edge());
        let (tick, known) = (self.run.game.ticks(), self.run.history.ticks());
        let part = if known > 0 { tick as f32 / known as f32 } else { 0.0 };
        let y = line.centre().y;
        canvas.rounded(line, 6.0, theme::ground());
        canvas.rounded(Area { size: Vec2::new(line.size.x * part, line.size.y), ..line }, 6.0, theme::accent());
        canvas.disc(Vec2::new(line.min.x + line.size.x * part, y), 10.0, theme::text());
        let number = Style::new(TEXT, theme::text()).mono().middle();
        // The clock of the flight starts with its first key.
        let idle = self.run.history.inputs().idle().unwrap_or(0);
        let time = |tick: u64| clock(tick.saturating_sub(idle) as f64 / self.run.game.tick_rate());
        canvas.text(&format!("{} / {}", time(tick), time(known)), Vec2::new(24.0, y), number);
        let pace = written(self.seen.observer.pace());
        let pace = if self.seen.observer.frozen() { tr!("paused · {pace}", pace) } else { pace };
        canvas.text(&pace, Vec2::new(size.x - 24.0, y), number.right());
        widgets::fitted(canvas, &viewer.title, Vec2::new(size.x / 2.0, top + 20.0), size.x - 64.0, &[TEXT], theme::quiet());
    }
}

/// A pace in words: 1/8×, 4×.
fn written(pace: f64) -> String {
    if pace < 1.0 { format!("1/{}×", 1.0 / pace) } else { format!("{pace}×") }
}
