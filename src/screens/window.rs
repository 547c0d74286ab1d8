//! The window: macroquad's keys, mouse and clock become an [`Input`] a frame, and the screens are drawn.

use super::Editor;
use super::pad::Pads;
use super::watch::above;
use super::{
    Answer, App, Attempt, Flight, Input, Instruments, Key, Keyed, Keys, Noise, Picture, Places, Request, Screen, Spectator, Watch,
    Worker, pace,
};
use crate::draw::Canvas;
use crate::draw::pen::Pen;
use crate::game::Game;
use crate::level::{self, Level};
use crate::physics::{BodyId, DVec2};
use crate::settings::{Settings, plain_keys};
use crate::view::focus::Focus;
use crate::view::hud::Shown;
use crate::view::layout::{Area, BUTTON_TEXT, DESIGN, Frame, TEXT, Vec2};
use crate::view::sound::{Ambience, Cue, Ear, Sound, Speaker, Stuff, Volumes, tune};
use crate::view::{GameView, Overlays, art, theme, widgets};
use macroquad::input::utils::{register_input_subscriber, repeat_all_miniquad_input};
use macroquad::input::{
    KeyCode, MouseButton, get_char_pressed, get_dropped_files, is_key_down, is_key_pressed, is_mouse_button_down,
    is_mouse_button_pressed, mouse_position, mouse_wheel, utils,
};
use macroquad::miniquad::EventHandler;
use macroquad::miniquad::KeyMods;
use macroquad::miniquad::conf::{Conf, Icon};
use macroquad::window::{next_frame, set_fullscreen};
use std::cell::RefCell;
use std::panic::{self, AssertUnwindSafe};
use std::path::PathBuf;
use std::rc::Rc;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// How often the window is tried to open, and the time after each: an X server turns programs away for a moment while it resets.
const ATTEMPTS: u32 = 4;
const BETWEEN_ATTEMPTS: Duration = Duration::from_millis(150);
/// How much one tick's time, and one frame's, counts in the running means that F3 shows.
const COST_WEIGHT: f64 = 0.02;
const FRAME_WEIGHT: f64 = 0.1;
/// The tune of the menus.
const MENU: &str = "0";
macro_rules! codes {
    ($($key:ident)*) => { &[$((KeyCode::$key, Key::$key)),*] };
}
/// Which key of the keyboard is which of ours.
const KEYS: &[(KeyCode, Key)] = plain_keys!(codes);
/// Those of which there are several.
const MORE_KEYS: [(KeyCode, Key); 8] = [
    (KeyCode::Enter, Key::Enter),
    (KeyCode::KpEnter, Key::Enter),
    (KeyCode::LeftShift, Key::Shift),
    (KeyCode::RightShift, Key::Shift),
    (KeyCode::LeftControl, Key::Control),
    (KeyCode::RightControl, Key::Control),
    (KeyCode::LeftAlt, Key::Alt),
    (KeyCode::RightAlt, Key::Alt),
];

/// What the window opens with.
#[derive(Clone, Debug)]
pub enum Start {
    /// An attempt at the level in that folder.
    Play(PathBuf, Attempt),
    /// The level in that folder, which is not finished, to try it out; a line a problem.
    Test(PathBuf, Arc<Level>, Vec<String>),
    /// The editor of the level in that folder, which has that name; of itself, also where it comes with the game.
    Edit(PathBuf, String, bool),
}

/// Opens the window, in a level where one is given, and returns when it is closed.
///
/// # Errors
/// There is no display, or what the window needs cannot be had; in words.
pub fn open(places: Places, start: Option<Start>) -> Result<(), String> {
    let conf = || Conf {
        window_title: "Resultant".into(),
        window_width: DESIGN.x as i32,
        window_height: DESIGN.y as i32,
        window_resizable: true,
        high_dpi: true,
        icon: Some(icon()),
        ..Conf::default()
    };
    // None until the window is there, then how the sitting ended.
    let ended: Rc<RefCell<Option<Result<(), String>>>> = Rc::default();
    // miniquad panics where it finds no display. Until the window is there that panic is caught and told in words; from then on
    // panics are what they always are.
    panic::set_hook(Box::new(|_| {}));
    for _ in 0..ATTEMPTS {
        let (sitting, opened) = ((places.clone(), start.clone()), ended.clone());
        let outcome = panic::catch_unwind(AssertUnwindSafe(|| {
            macroquad::Window::from_config(conf(), async move {
                drop(panic::take_hook());
                *opened.borrow_mut() = Some(Ok(()));
                let end = run(sitting.0, sitting.1).await;
                *opened.borrow_mut() = Some(end);
            });
        }));
        match (ended.take(), outcome) {
            (None, _) => std::thread::sleep(BETWEEN_ATTEMPTS),
            (Some(_), Err(panic)) => panic::resume_unwind(panic),
            (Some(end), Ok(())) => return end,
        }
    }
    drop(panic::take_hook());
    Err("the window cannot be opened: there is no display, or it lacks OpenGL".into())
}

async fn run(places: Places, start: Option<Start>) -> Result<(), String> {
    let mut pen = Pen::new(&art::sheet())?;
    let mut canvas = Canvas::new(Frame::default());
    let mut theatre = Theatre::new(Speaker::new());
    let mut app = App::with_worker(places, Worker::beside());
    app.clipboard.of_system = true;
    match start {
        Some(Start::Play(folder, attempt)) => app.begin(&folder, Request::Attempt(attempt), &mut theatre),
        Some(Start::Test(folder, level, problems)) => app.begin(&folder, Request::TestFly(level, problems), &mut theatre),
        Some(Start::Edit(folder, name, false)) => app.begin(&folder, Request::Edit(name), &mut theatre),
        Some(Start::Edit(folder, name, true)) => app.begin(&folder, Request::EditOriginal(name), &mut theatre),
        None => {}
    }
    let mut pads = Pads::new();
    let mut focus = WindowFocus::new();
    let mut begun = Instant::now();
    let mut fullscreen = false;
    let typist = utils::register_input_subscriber();
    loop {
        theme::wear(app.settings().palette);
        let text = text_scale(&app, canvas.frame().pixel);
        pen.begin(&mut canvas, text)?;
        let mut typed = Typist::default();
        utils::repeat_all_miniquad_input(&mut typed, typist);
        let mut input = Input { away: focus.is_away(), ..read_input(&canvas, pads.read(), typed) };
        // What is pressed meanwhile comes with the next frame, which waits for nothing.
        let worked = begun.elapsed();
        std::thread::sleep(Duration::from_secs_f64(app.interval(&input)).saturating_sub(worked));
        let passed = begun.elapsed();
        begun += passed;
        input.frame_time = pace::passed(passed.as_secs_f64());
        input.waited = (passed - worked).as_secs_f64();
        (input.pointed, input.place) = theatre.pointed(app.screen(), &input);
        if !app.update(&input, &mut theatre) {
            return Ok(());
        }
        if app.settings().fullscreen != fullscreen {
            fullscreen = app.settings().fullscreen;
            set_fullscreen(fullscreen);
        }
        theatre.frame_cost += (input.frame_time - theatre.frame_cost) * FRAME_WEIGHT;
        if app.picture() != Picture::Again || !pen.show_kept(&canvas) {
            draw(&app, &mut theatre, input.frame_time, &mut canvas);
            pen.play(&canvas, theme::ground());
            if app.picture() == Picture::Kept {
                pen.keep(&canvas);
            }
        }
        theatre.speaker.set_volumes(volumes(app.settings()));
        theatre.sound(app.screen(), input.answer.get());
        next_frame().await;
    }
}

/// How large words are on this screen, with `pixel` canvas units a pixel: those of a flight as the player wants them; the editor leaves a large
/// window to the picture; the others stand in panels made for them.
fn text_scale(app: &App, pixel: f32) -> f32 {
    if let Screen::Editor(_) = app.screen() {
        return Editor::text_scale(pixel);
    }
    let scale = f32::from(app.settings().scale) / 100.0;
    let flown = matches!(app.screen(), Screen::Flight(flight) if flight.pause().is_none());
    if flown || matches!(app.screen(), Screen::Watch(_)) { scale } else { 1.0 }
}

/// What was typed since the last frame, in order.
#[derive(Default)]
struct Typist {
    typed: String,
    keyed: Vec<Keyed>,
}

impl EventHandler for Typist {
    fn update(&mut self) {}

    fn draw(&mut self) {}

    fn char_event(&mut self, character: char, held: KeyMods, _repeat: bool) {
        // Ctrl with Alt types letters on some keyboards.
        if !(held.ctrl && !held.alt || held.logo || character.is_control()) {
            self.typed.push(character);
        }
    }

    fn key_down_event(&mut self, code: KeyCode, mods: KeyMods, repeat: bool) {
        let key = KEYS.iter().chain(&MORE_KEYS).find(|(known, _)| *known == code);
        if let (Some((_, key)), false) = (key, repeat) {
            let modifiers = [(mods.shift, Key::Shift), (mods.ctrl || mods.logo, Key::Control), (mods.alt, Key::Alt)];
            let held = modifiers.into_iter().filter(|(held, _)| *held).map(|(_, key)| key).collect();
            self.keyed.push(Keyed { key: *key, after: self.typed.chars().count(), held });
        }
    }
}

fn read_input(canvas: &Canvas, (pad_pressed, pad_held): (Keys, Keys), Typist { typed, keyed }: Typist) -> Input {
    // What was typed comes from the typist: macroquad's own list of it would grow without end.
    while get_char_pressed().is_some() {}
    let keys = |is: fn(KeyCode) -> bool| {
        KEYS.iter().chain(&MORE_KEYS).filter(|(code, _)| is(*code)).map(|(_, key)| *key).collect::<Keys>()
    };
    // Ctrl and S count where both were released before the frame.
    let modifiers = keyed.iter().fold(Keys::default(), |all, keyed| all | keyed.held);
    Input {
        frame: *canvas.frame(),
        pointer: canvas.to_canvas(Vec2::from(mouse_position())),
        click: is_mouse_button_pressed(MouseButton::Left),
        holding: is_mouse_button_down(MouseButton::Left),
        right_click: is_mouse_button_pressed(MouseButton::Right),
        dragging: is_mouse_button_down(MouseButton::Right) || is_mouse_button_down(MouseButton::Middle),
        // Systems disagree by a factor of 120 on what a notch is; they agree on its sign.
        wheel: mouse_wheel().1.clamp(-1.0, 1.0),
        pressed: keys(is_key_pressed) | pad_pressed,
        held: keys(is_key_down) | modifiers | pad_held,
        typed,
        keyed,
        dropped: get_dropped_files().into_iter().filter_map(|file| file.path).collect(),
        ..Input::default()
    }
}

fn draw(app: &App, theatre: &mut Theatre, frame_time: f64, canvas: &mut Canvas) {
    match app.screen() {
        Screen::Menu(screen) => screen.draw(canvas),
        Screen::LevelSelect(screen) => screen.draw(canvas, app.shown_for()),
        Screen::Editor(screen) => screen.draw(canvas, app.shown_for(), 1.0 / theatre.frame_cost),
        Screen::Flight(screen) => {
            theatre.set_panels(screen.panels(canvas.frame()));
            let whole = canvas.use_frame(screen.instruments().room(canvas.frame()));
            theatre.draw(screen, *app.settings(), frame_time, canvas);
            canvas.use_frame(whole);
            screen.instruments().draw_below(canvas);
            screen.draw_over(canvas);
        }
        Screen::Watch(screen) => {
            let whole = canvas.use_frame(above(canvas.frame()));
            theatre.set_panels(screen.instruments().areas(canvas.frame()));
            let above = canvas.use_frame(screen.instruments().room(canvas.frame()));
            theatre.draw_watched(screen, *app.settings(), frame_time, canvas);
            canvas.use_frame(above);
            screen.instruments().draw_below(canvas);
            canvas.use_frame(whole);
            screen.draw_controls(canvas);
        }
        Screen::Flights(screen) => screen.draw(canvas),
        Screen::Scoring(screen) => screen.draw(canvas),
        Screen::SaveScore(screen) => screen.draw(canvas, app.shown_for()),
        Screen::Leaderboard(screen) => screen.draw(canvas),
        Screen::Players(screen) => screen.draw(canvas, app.shown_for()),
        Screen::Credits(screen) => screen.draw(canvas),
        Screen::Classics(screen) => screen.draw(canvas),
        Screen::Lab(screen) => screen.draw(canvas),
        Screen::TileRun(screen) => screen.draw(canvas),
        Screen::Jumper(screen) => screen.draw(canvas),
        Screen::Settings(screen) => screen.draw(canvas),
        Screen::Pi(screen) => screen.draw(canvas),
    }
    if let Some(what) = app.loading() {
        draw_loading(what, canvas);
    }
    let veil = app.veil();
    if veil > 0.0 {
        widgets::curtain(canvas, veil as f32);
    }
}

/// The window's icon, at the three sizes that a desktop asks for.
fn icon() -> Icon {
    fn of<const N: usize>(side: usize) -> [u8; N] {
        let bytes = art::icon(side);
        std::array::from_fn(|i| bytes[i])
    }
    Icon { small: of(16), medium: of(32), big: of(64) }
}

/// What is loading, above the screen that waits for it.
fn draw_loading(what: &str, canvas: &Canvas) {
    widgets::curtain(canvas, 0.6);
    let (middle, size) = (canvas.size() / 2.0, Vec2::new(560.0, 120.0));
    widgets::panel(canvas, Area::around(middle, size));
    let words = format!("Loading {what} …");
    widgets::fitted(canvas, &words, middle - Vec2::new(0.0, 18.0), size.x - 48.0, &[BUTTON_TEXT, TEXT], theme::text());
    widgets::fitted(canvas, "Esc: not now", middle + Vec2::new(0.0, 26.0), size.x - 48.0, &[TEXT], theme::quiet());
}

/// What watches the attempt that is on the screen: its view, its sounds, and how long its ticks take.
struct Theatre {
    speaker: Speaker,
    ear: Ear,
    view: Option<GameView>,
    tick_started: Instant,
    /// Running mean of the time that a tick takes, s.
    tick_cost: f64,
    /// The same from frame to frame.
    frame_cost: f64,
}

/// Whether the window has the keyboard, by what miniquad reports: on X11 that another window has it, elsewhere that it is hidden.
struct WindowFocus {
    subscriber: usize,
    away: bool,
}

impl WindowFocus {
    fn new() -> Self {
        Self { subscriber: register_input_subscriber(), away: false }
    }

    fn is_away(&mut self) -> bool {
        repeat_all_miniquad_input(self, self.subscriber);
        self.away
    }
}

impl EventHandler for WindowFocus {
    fn update(&mut self) {}

    fn draw(&mut self) {}

    fn window_minimized_event(&mut self) {
        self.away = true;
    }

    fn window_restored_event(&mut self) {
        self.away = false;
    }
}

impl Theatre {
    fn new(speaker: Speaker) -> Self {
        Self { speaker, ear: Ear::default(), view: None, tick_started: Instant::now(), tick_cost: 0.0, frame_cost: pace::EASY }
    }

    /// The body under the pointer, and the place in the level, m, where a game is shown.
    fn pointed(&mut self, screen: &Screen, input: &Input) -> (Option<BodyId>, Option<DVec2>) {
        let Some(view) = &mut self.view else { return (None, None) };
        view.point_at(input.pointer);
        let (game, alpha, frame) = match screen {
            Screen::Flight(flight) => (flight.game(), flight.alpha(), flight.instruments().room(&input.frame)),
            Screen::Watch(watch) => (watch.game(), watch.alpha(), watch.instruments().room(&above(&input.frame))),
            _ => return (None, None),
        };
        let place = view.viewport(game, alpha, &frame).metres(input.pointer);
        (view.body_at(game, alpha, input.pointer, &frame), Some(place))
    }

    fn set_panels(&mut self, panels: Vec<Area>) {
        if let Some(view) = &mut self.view {
            view.set_panels(panels);
        }
    }

    /// Lets the view move on by the frame just updated, and draws it.
    fn draw(&mut self, flight: &Flight, settings: Settings, frame_time: f64, canvas: &Canvas) {
        let figures = self.figures();
        let Some(view) = &mut self.view else { return };
        let (details, hitboxes) = (flight.details(), flight.hitboxes());
        let focus = looked_at(flight.observer().focus(), details || flight.instruments().is_open());
        let plays = flight.game().level().ship_plays();
        let fuel = plays && flight.game().level().player.has_engine();
        let shown = Shown { status: plays, fuel, rivals: flight.race().map_or(0, |race| race.all().len()) };
        let overlays = Overlays { settings, details, shown, focus, hitboxes, watched: false };
        let paused = flight.pause().is_some();
        let passed = if paused { 0.0 } else { frame_time * flight.observer().speed().min(1.0) };
        view.update(flight.game(), flight.alpha(), passed, overlays, canvas.frame());
        view.follow_jumps(flight.game(), &overlays, if paused { 0.0 } else { frame_time - passed });
        if flight.pause().is_none() {
            self.speaker.surround(Ambience::of(flight.game(), view.burning()));
        }
        view.set_ghosts(flight.ghosts());
        view.draw(flight.game(), flight.alpha(), overlays, &figures, canvas);
        draw_instruments(flight.instruments(), view, (flight.game(), flight.alpha()), canvas);
        if let Some(race) = flight.race() {
            race.draw(view.hud().aside(), canvas);
        }
    }

    /// The same for a flight that is watched.
    fn draw_watched(&mut self, watch: &Watch, settings: Settings, frame_time: f64, canvas: &Canvas) {
        let figures = self.figures();
        let Some(view) = &mut self.view else { return };
        let (details, hitboxes) = (watch.details(), watch.hitboxes());
        let focus = looked_at(watch.focus(), details || watch.instruments().is_open());
        let plays = watch.game().level().ship_plays();
        let shown = Shown { status: plays, fuel: plays && watch.game().level().player.has_engine(), rivals: 0 };
        let overlays = Overlays { settings, details, shown, focus, hitboxes, watched: true };
        let passed = if watch.paused() { 0.0 } else { frame_time * watch.pace().min(1.0) };
        view.update(watch.game(), watch.alpha(), passed, overlays, canvas.frame());
        view.follow_jumps(watch.game(), &overlays, frame_time - passed);
        if !watch.paused() {
            self.speaker.surround(Ambience::of(watch.game(), view.burning()));
        }
        view.draw(watch.game(), watch.alpha(), overlays, &figures, canvas);
        draw_instruments(watch.instruments(), view, (watch.game(), watch.alpha()), canvas);
    }
}

/// Who is looked at: nobody in particular while neither details nor instruments are open.
fn looked_at(focus: &Focus, open: bool) -> Focus {
    if open { *focus } else { focus.on_nobody() }
}

/// What it is measured with, above the flight.
fn draw_instruments(instruments: &Instruments, view: &GameView, (game, alpha): (&Game, f64), canvas: &Canvas) {
    if instruments.is_open() {
        let view = view.viewport(game, alpha, canvas.frame());
        instruments.draw_in_level((game, alpha), &view, canvas);
        instruments.draw((game, alpha), &view, canvas);
    }
}

impl Theatre {
    /// The line that F3 shows: frames a second, and what a tick costs.
    fn figures(&self) -> String {
        format!("{:>3.0} fps  tick {:.1} µs", 1.0 / self.frame_cost, self.tick_cost * 1e6)
    }

    /// Ends the frame for the ear: buttons, and the tune that belongs to the screen.
    fn sound(&mut self, screen: &Screen, answer: Option<Answer>) {
        match answer {
            Some(Answer::Pressed) => self.speaker.play(Sound::new(Cue::Press, 1.0)),
            Some(Answer::Moved) => self.speaker.play(Sound::new(Cue::Move, 1.0)),
            None => {}
        }
        screen.noises().into_iter().for_each(|noise| self.speaker.play(heard_as(noise)));
        if let Some(name) = music(screen) {
            self.speaker.set_tune(Some(tune(name)));
        }
        self.speaker.end_frame();
    }
}

/// What something in the classics sounds like.
fn heard_as(noise: Noise) -> Sound {
    match noise {
        Noise::Jump => Sound::new(Cue::Jump, 0.5),
        Noise::Landing(hard) => Sound::new(Cue::Knock(Stuff::Wood), 0.1 + 0.5 * hard as f32),
        Noise::Bump => Sound::new(Cue::Knock(Stuff::Rubber), 0.8),
        Noise::Collision => Sound::new(Cue::Click, 1.0),
    }
}

/// The volumes that the player has set.
fn volumes(settings: &Settings) -> Volumes {
    let [master, effects, music] = [settings.master, settings.effects, settings.music].map(|percent| f32::from(percent) / 100.0);
    Volumes { master, effects, music }
}

/// By what the tune of a screen goes; `None`: as before, so that a level's stays through its scoring.
fn music(screen: &Screen) -> Option<&str> {
    match screen {
        Screen::Flight(flight) => Some(&flight.game().level().name),
        Screen::Watch(watch) => Some(&watch.game().level().name),
        Screen::Flights(_) | Screen::Scoring(_) | Screen::SaveScore(_) | Screen::Leaderboard(_) => None,
        Screen::TileRun(_) => Some("tile run"),
        Screen::Jumper(_) => Some("jumper"),
        Screen::Pi(_) => Some("pi"),
        Screen::Menu(_)
        | Screen::Players(_)
        | Screen::Credits(_)
        | Screen::LevelSelect(_)
        | Screen::Editor(_)
        | Screen::Classics(_)
        | Screen::Lab(_)
        | Screen::Settings(_) => Some(MENU),
    }
}

impl Spectator for Theatre {
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
