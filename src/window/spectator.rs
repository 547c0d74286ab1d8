//! What a window has besides the screens: the view of the game that is flown, and sound.

use crate::draw::layout::{Area, BUTTON_TEXT, TEXT, Vec2};
use crate::game::{Game, Outcome};
use crate::physics::{BodyId, DVec2};
use crate::screens::{GameScene, Noise, Screen, Stack};
use crate::sound::{Ambience, Arrangement, Cue, Ear, Sound, Speaker, Stuff, Volumes, tune};
use crate::ui::input::{ButtonAnswer, Input};
use crate::ui::{Spectator, pace};
use crate::view::{GameView, Overlays, theme, widgets};
use crate::{draw::Canvas, level, settings::Settings, window::host::Instant, words::tr};

/// Volume of the music during a loss; at 0 the tune would begin again.
const HUSHED: f32 = 0.05;
/// How much one tick's time, and one frame's, counts in the running means that F3 shows.
const COST_WEIGHT: f64 = 0.02;
const FRAME_WEIGHT: f64 = 0.1;

pub fn draw(stack: &Stack, spectator: &mut WindowSpectator, frame_time: f64, canvas: &mut Canvas) {
    if let Some(scene) = stack.scene(canvas.frame()) {
        spectator.draw_scene(scene, *stack.settings(), frame_time, canvas);
        canvas.end_layer();
    } else if stack.screen().tune().is_some() {
        spectator.how = Arrangement::default();
    }
    canvas.add_all(stack.canvas());
    if let Some(what) = stack.loading() {
        draw_loading(what, canvas);
    }
    let veil = stack.veil();
    if veil > 0.0 {
        widgets::curtain(canvas, veil as f32);
    }
}

fn draw_loading(what: &str, canvas: &Canvas) {
    widgets::curtain(canvas, 0.6);
    let (middle, size) = (canvas.size() / 2.0, Vec2::new(560.0, 120.0));
    widgets::panel(canvas, Area::around(middle, size));
    let words = tr!("Loading {what} …", what);
    widgets::fitted(canvas, &words, middle - Vec2::new(0.0, 18.0), size.x - 48.0, &[BUTTON_TEXT, TEXT], theme::text());
    widgets::fitted(canvas, tr("Esc: not now"), middle + Vec2::new(0.0, 26.0), size.x - 48.0, &[TEXT], theme::quiet());
}

/// Watches the attempt that is on the screen: its view, its sounds, and how long its ticks take.
pub struct WindowSpectator {
    speaker: Speaker,
    ear: Ear,
    view: Option<GameView>,
    /// How the music of the screen is played, and whether it pauses for a loss.
    how: Arrangement,
    lost: bool,
    tick_started: Instant,
    /// Running mean of the time that a tick takes, s.
    tick_cost: f64,
    /// The same from frame to frame.
    frame_cost: f64,
}

impl WindowSpectator {
    pub fn new(speaker: Speaker) -> Self {
        Self {
            speaker,
            ear: Ear::default(),
            view: None,
            how: Arrangement::default(),
            lost: false,
            tick_started: Instant::now(),
            tick_cost: 0.0,
            frame_cost: pace::EASY,
        }
    }

    /// The body under the pointer, and the place in the level, m, where a game is shown.
    pub fn pointed(&mut self, screen: &dyn Screen, input: &Input) -> (Option<BodyId>, Option<DVec2>) {
        let Some(view) = &mut self.view else { return (None, None) };
        view.pointer = Some(input.pointer);
        let Some(GameScene { game, alpha, room, .. }) = screen.scene(&input.frame) else { return (None, None) };
        let place = view.viewport(game, alpha, &room).metres(input.pointer);
        (view.body_at(game, alpha, input.pointer, &room), Some(place))
    }

    /// Lets the view move on by the frame just updated, and draws it.
    fn draw_scene(&mut self, scene: GameScene<'_>, settings: Settings, frame_time: f64, canvas: &mut Canvas) {
        let figures = self.figures();
        let Some(view) = &mut self.view else { return };
        let GameScene { game, alpha, above, .. } = scene;
        let overlays = Overlays { settings, ..scene.overlays };
        let whole = canvas.use_frame(scene.room);
        (view.panels, view.ghosts) = (scene.panels, scene.ghosts);
        let passed = frame_time * scene.speed.min(1.0);
        view.update(game, alpha, passed, overlays, canvas.frame());
        view.follow_jumps(game, &overlays, canvas.frame(), if scene.paused { 0.0 } else { frame_time - passed });
        self.lost = !scene.quiet && game.outcome() == Outcome::Failed;
        self.how = if scene.quiet { Arrangement::default() } else { Arrangement::of(game) };
        if scene.speed > 0.0 && !scene.quiet {
            self.speaker.surround(Ambience::of(game, view.burning()));
        }
        view.draw(game, alpha, overlays, &figures, canvas);
        above.draw_in_level(alpha, &view.viewport(game, alpha, canvas.frame()), canvas);
        above.draw_beside_timer(&view.hud.aside, canvas);
        canvas.use_frame(whole);
    }

    /// s.
    pub fn note_frame(&mut self, frame_time: f64) {
        self.frame_cost += (frame_time - self.frame_cost) * FRAME_WEIGHT;
    }

    pub fn set_volumes(&mut self, settings: &Settings) {
        let [master, effects, music] =
            [settings.master, settings.effects, settings.music].map(|percent| f32::from(percent) / 100.0);
        // The burst of a loss, then a beat of silence.
        let music = if self.lost { HUSHED * music } else { music };
        self.speaker.desk.set_volumes(Volumes { master, effects, music });
    }

    /// The line that F3 shows: frames a second, and what a tick costs.
    fn figures(&self) -> String {
        let rate = format_args!("{:>3.0}", 1.0 / self.frame_cost);
        tr!("{rate} fps  tick {cost} µs", rate, cost = format_args!("{:.1}", self.tick_cost * 1e6))
    }

    /// Ends the frame for the ear: buttons, and the tune that belongs to the screen.
    pub fn sound(&mut self, screen: &dyn Screen, answer: Option<ButtonAnswer>) {
        match answer {
            Some(ButtonAnswer::Pressed) => self.speaker.play(Sound::new(Cue::Press, 1.0)),
            Some(ButtonAnswer::Moved) => self.speaker.play(Sound::new(Cue::Move, 1.0)),
            None => {}
        }
        screen.noises().into_iter().for_each(|noise| self.speaker.play(heard_as(noise)));
        if let Some(name) = screen.tune() {
            self.speaker.desk.set_tune(Some(tune(name)));
        } else {
            self.how.pace = 0.0;
        }
        self.speaker.desk.set_arrangement(self.how);
        self.lost = false;
        self.speaker.end_frame();
    }
}

fn heard_as(noise: Noise) -> Sound {
    match noise {
        Noise::Jump => Sound::new(Cue::Jump, 0.5),
        Noise::Landing(hard) => Sound::new(Cue::Knock(Stuff::Wood), 0.1 + 0.5 * hard as f32),
        Noise::Bump => Sound::new(Cue::Knock(Stuff::Rubber), 0.8),
        Noise::Collision => Sound::new(Cue::Click, 1.0),
    }
}

impl Spectator for WindowSpectator {
    fn frames(&self) -> f64 {
        1.0 / self.frame_cost
    }

    fn begins(&mut self, game: &Game) {
        self.ear = Ear::default();
        self.view = Some(GameView::new(game, &|path| level::read_picture(path).ok()));
        self.tick_cost = 0.0;
    }

    fn goes_on(&mut self, game: &Game) {
        let read = |path: &std::path::Path| level::read_picture(path).ok();
        match &self.view {
            Some(view) => self.view = Some(view.goes_on(game, &read)),
            None => self.begins(game),
        }
    }

    fn before_tick(&mut self) {
        self.tick_started = Instant::now();
    }

    fn after_tick(&mut self, game: &Game) {
        let cost = self.tick_started.elapsed().as_secs_f64();
        self.tick_cost += (cost - self.tick_cost) * COST_WEIGHT;
        self.ear.listen(game, |sound| self.speaker.play(sound));
        if let Some(view) = &mut self.view {
            view.after_tick(game);
        }
    }

    fn jumped(&mut self, game: &Game) {
        self.ear = Ear::default();
        if let Some(view) = &mut self.view {
            view.jump(game);
        }
    }
}
