//! The window: macroquad's keys, mouse and clock become an [`Input`] a frame, and the screens are drawn.

use super::host::{self, Instant};
use super::pad::Pads;
use super::theatre::{self, Theatre};
use super::{App, Attempt, Input, Key, Keyed, Keys, Picture, Places, Request, Worker, pace};
use crate::draw::Canvas;
use crate::draw::layout::{DESIGN, Frame, Vec2};
use crate::draw::pen::WindowPen;
use crate::level::Level;
use crate::settings::plain_keys;
use crate::view::sound::Speaker;
use crate::view::{art, theme};
use crate::words::{self, Language};
use macroquad::input::utils::{register_input_subscriber, repeat_all_miniquad_input};
use macroquad::input::{
    KeyCode, MouseButton, get_char_pressed, is_key_down, is_key_pressed, is_mouse_button_down, is_mouse_button_pressed,
    mouse_position, mouse_wheel, utils,
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
use std::time::Duration;

/// How often the window is tried to open, and the time after each: an X server turns programs away for a moment while it resets.
const ATTEMPTS: u32 = 4;
const BETWEEN_ATTEMPTS: Duration = Duration::from_millis(150);
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
            (None, _) => host::pause(BETWEEN_ATTEMPTS),
            (Some(_), Err(panic)) => panic::resume_unwind(panic),
            (Some(end), Ok(())) => return end,
        }
    }
    drop(panic::take_hook());
    Err("the window cannot be opened: there is no display, or it lacks OpenGL".into())
}

/// Opens the game in a browser's page, which knows neither folders nor an end.
#[cfg(browser)]
pub fn open_page() {
    use crate::web::{self, PageWord};
    macroquad::Window::from_config(conf(), async {
        if web::link() == "verify" {
            return web::verify().await;
        }
        web::link_again();
        let [levels, scores, settings] = ["levels", "scores", "settings.csv"].map(PathBuf::from);
        let places = Places { root: PathBuf::new(), levels, scores, settings };
        let ended = run(places, None).await;
        web::say(PageWord::Stopped, &ended.err().unwrap_or_default());
    });
}

fn conf() -> Conf {
    Conf {
        window_title: "Resultant".into(),
        window_width: DESIGN.x as i32,
        window_height: DESIGN.y as i32,
        window_resizable: true,
        high_dpi: true,
        icon: Some(icon()),
        ..Conf::default()
    }
}

async fn run(places: Places, start: Option<Start>) -> Result<(), String> {
    words::note_system(Language::named(&host::language()));
    let mut pen = WindowPen::new(&art::sheet())?;
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
        app.now = macroquad::miniquad::date::now();
        let text = app.screen().text_scale(app.settings(), canvas.frame().pixel);
        pen.begin(&mut canvas, text)?;
        app.dpi = canvas.dpi();
        let mut typed = Typist::default();
        utils::repeat_all_miniquad_input(&mut typed, typist);
        let mut input = Input { away: focus.is_away(), ..read_input(&canvas, pads.read(), typed) };
        // What is pressed meanwhile comes with the next frame, which waits for nothing.
        let worked = begun.elapsed();
        host::pause(Duration::from_secs_f64(app.interval(&input)).saturating_sub(worked));
        let passed = begun.elapsed();
        begun += passed;
        input.frame_time = pace::passed(passed.as_secs_f64());
        input.waited = (passed - worked).as_secs_f64();
        host::begin_frame(&mut app, &mut input, &mut theatre);
        (input.pointed, input.place) = theatre.pointed(app.screen(), &input);
        if !app.update(&input, &mut theatre) {
            return Ok(());
        }
        if app.settings().fullscreen != fullscreen {
            fullscreen = app.settings().fullscreen;
            set_fullscreen(fullscreen);
        }
        theatre.note_frame(input.frame_time);
        if app.picture() != Picture::Again || !pen.show_kept(&canvas) {
            theatre::draw(&app, &mut theatre, input.frame_time, &mut canvas);
            let ground = if theme::is_light() { theme::ground().on_white() } else { theme::ground() };
            if theme::is_light() {
                canvas.put_on_white();
            }
            pen.play(&canvas, ground);
            if app.picture() == Picture::Kept {
                pen.keep(&canvas);
            }
        }
        theatre.set_volumes(app.settings());
        theatre.sound(app.screen(), input.answer.get());
        host::end_frame(app.interval(&input.without_edges()));
        next_frame().await;
    }
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
        dropped: host::dropped(),
        ..Input::default()
    }
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

/// The window's icon, at the three sizes that a desktop asks for.
fn icon() -> Icon {
    fn of<const N: usize>(side: usize) -> [u8; N] {
        let bytes = art::icon(side);
        std::array::from_fn(|i| bytes[i])
    }
    Icon { small: of(16), medium: of(32), big: of(64) }
}
