//! The window: macroquad's keys, mouse and clock become an [`Input`] a frame, and the screens are drawn.

#[cfg(not(browser))]
mod desktop;
mod keyboard;
#[cfg(browser)]
mod page;
mod spectator;
#[cfg(all(target_os = "linux", target_pointer_width = "64"))]
mod system_date;

#[cfg(not(browser))]
use desktop as host;
#[cfg(browser)]
use page as host;

use crate::draw::layout::{DESIGN, Frame, Vec2};
use crate::draw::{Canvas, pen::WindowPen};
use crate::screens::{Destination, Places, Stack};
use crate::session::{library::Attempt, worker::Worker};
use crate::ui::pace::{self, Picture};
use crate::view::{art, theme};
use crate::words::{self, Language};
use crate::{level::Level, settings::Keys, sound::Speaker, ui::input::Input, window::keyboard::WindowKeys};
use host::{Instant, Pads};
use macroquad::input::{
    MouseButton, is_mouse_button_down, is_mouse_button_pressed, is_quit_requested, mouse_position, mouse_wheel, prevent_quit,
};
use macroquad::miniquad::conf::{Conf, Icon};
use macroquad::window::{next_frame, set_fullscreen};
use spectator::WindowSpectator;
use std::panic::{self, AssertUnwindSafe};
use std::{cell::RefCell, path::PathBuf, rc::Rc, sync::Arc, time::Duration};

/// How often the window is tried to open, and the time after each: an X server turns programs away for a moment while it resets.
const ATTEMPTS: u32 = 4;
const BETWEEN_ATTEMPTS: Duration = Duration::from_millis(150);
/// A stick or a trigger counts as pressed from here on, and as released again below that: between the two it stays what it is, so that
/// a hand that trembles presses once.
const PRESSED: f32 = 0.5;
const RELEASED: f32 = 0.35;

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
/// Errors: there is no display, or what the window needs cannot be had; in words.
pub fn open(places: Places, start: Option<Start>) -> Result<(), String> {
    #[cfg(all(target_os = "linux", target_pointer_width = "64"))]
    system_date::keep();
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
    let mut pen = WindowPen::new(&art::sheet().bytes)?;
    let mut canvas = Canvas::new(Frame::default());
    let mut spectator = WindowSpectator::new(Speaker::start());
    let mut stack = Stack::with_worker(places, Worker::beside());
    stack.session.clipboard.of_system = true;
    match start {
        Some(Start::Play(folder, attempt)) => stack.begin(&folder, Destination::Fly(attempt), &mut spectator),
        Some(Start::Test(folder, level, problems)) => {
            stack.begin(&folder, Destination::TryOut { level, problems, in_memory: false, on: None }, &mut spectator)
        }
        Some(Start::Edit(folder, name, original)) => stack.begin(&folder, Destination::Edit { name, original }, &mut spectator),
        None => {}
    }
    let mut pads = Pads::new();
    let mut keys = WindowKeys::new();
    let mut begun = Instant::now();
    let mut fullscreen = false;
    prevent_quit();
    loop {
        theme::wear(stack.settings().palette);
        stack.session.now = host::now();
        pen.begin(&mut canvas, |frame| stack.screen().with_words(frame, stack.settings()));
        stack.dpi = canvas.dpi();
        let mut input = read_input(&canvas, pads.read(), keys.read());
        // What is pressed meanwhile comes with the next frame, which waits for nothing.
        let worked = begun.elapsed();
        keys.wait(Duration::from_secs_f64(stack.interval(&input)).saturating_sub(worked));
        let now = Instant::now();
        let passed = now - begun;
        // A clock that was set back goes on from there.
        begun = now;
        input.frame_time = pace::passed(passed.as_secs_f64());
        input.waited = (passed - worked).as_secs_f64();
        if is_quit_requested() && stack.may_close() {
            return Ok(());
        }
        host::begin_frame(&mut stack, &mut input, &mut spectator);
        (input.pointed, input.place) = spectator.pointed(stack.screen(), &input);
        if !stack.update(&input, &mut spectator) {
            return Ok(());
        }
        if stack.settings().fullscreen != fullscreen {
            fullscreen = stack.settings().fullscreen;
            set_fullscreen(fullscreen);
        }
        spectator.note_frame(input.frame_time);
        if stack.picture() != Picture::Again || !pen.show_kept(&canvas) {
            spectator::draw(&stack, &mut spectator, input.frame_time, &mut canvas);
            let ground = if theme::is_light() { theme::ground().on_white() } else { theme::ground() };
            if theme::is_light() {
                canvas.put_on_white();
            }
            pen.play(&canvas, ground);
            if stack.picture() == Picture::Kept {
                pen.keep(&canvas);
            }
        }
        spectator.set_volumes(stack.settings());
        spectator.sound(stack.screen(), input.answer.get());
        host::end_frame(stack.interval(&input.without_edges()), stack.is_at_risk());
        next_frame().await;
    }
}

fn read_input(canvas: &Canvas, (pad_pressed, pad_held): (Keys, Keys), keys: Input) -> Input {
    Input {
        frame: *canvas.frame(),
        pointer: Vec2::from(mouse_position()) * canvas.dpi() * canvas.frame().pixel,
        click: is_mouse_button_pressed(MouseButton::Left),
        holding: is_mouse_button_down(MouseButton::Left),
        right_click: is_mouse_button_pressed(MouseButton::Right),
        dragging: is_mouse_button_down(MouseButton::Right) || is_mouse_button_down(MouseButton::Middle),
        // Systems disagree by a factor of 120 on what a notch is; they agree on its sign.
        wheel: mouse_wheel().1.clamp(-1.0, 1.0),
        pressed: keys.pressed | pad_pressed,
        held: keys.held | pad_held,
        dropped: host::dropped(),
        ..keys
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

/// Whether something that is pressed that far is down, if it was before or not.
fn is_down(level: f32, before: bool) -> bool {
    level >= if before { RELEASED } else { PRESSED }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_trembling_hand_presses_once() {
        let mut down = false;
        let mut presses = 0;
        for level in [0.0, 0.3, 0.52, 0.47, 0.51, 0.44, 0.6, 0.36, 0.2, 0.4] {
            let now = is_down(level, down);
            presses += u32::from(now && !down);
            down = now;
        }
        assert_eq!((presses, down), (1, false));
    }
}
