//! The window: macroquad's keys, mouse and clock become an [`Input`] a frame, and the screens are drawn.

use super::{App, Attempt, Input, Key, Keys, Places, Request, Screen, Spectator};
use crate::game::{Game, SHIP};
use crate::physics::Aabb;
use crate::view::canvas::Canvas;
use crate::view::layout::{Area, DESIGN, Vec2};
use crate::view::{theme, widgets};
use macroquad::input::{
    KeyCode, MouseButton, get_char_pressed, is_key_down, is_key_pressed, is_mouse_button_down, is_mouse_button_pressed,
    mouse_position, mouse_wheel,
};
use macroquad::miniquad::conf::Conf;
use macroquad::time::{get_frame_time, get_time};
use macroquad::window::next_frame;

/// A new screen fades in over this, s.
const FADE: f64 = 0.16;
/// Which key of the keyboard is which of ours.
const KEYS: [(KeyCode, Key); 18] = [
    (KeyCode::Up, Key::Up),
    (KeyCode::Down, Key::Down),
    (KeyCode::Left, Key::Left),
    (KeyCode::Right, Key::Right),
    (KeyCode::Enter, Key::Enter),
    (KeyCode::KpEnter, Key::Enter),
    (KeyCode::Escape, Key::Escape),
    (KeyCode::Space, Key::Space),
    (KeyCode::LeftShift, Key::Shift),
    (KeyCode::Tab, Key::Tab),
    (KeyCode::F3, Key::F3),
    (KeyCode::R, Key::R),
    (KeyCode::PageUp, Key::PageUp),
    (KeyCode::PageDown, Key::PageDown),
    (KeyCode::Home, Key::Home),
    (KeyCode::End, Key::End),
    (KeyCode::Backspace, Key::Backspace),
    (KeyCode::Delete, Key::Delete),
];

/// Opens the window, in a level where one is given, and returns when it is closed.
pub fn open(places: Places, start: Option<Attempt>) {
    let conf = Conf {
        window_title: "Resultant".into(),
        window_width: DESIGN.x as i32,
        window_height: DESIGN.y as i32,
        window_resizable: true,
        high_dpi: true,
        ..Conf::default()
    };
    macroquad::Window::from_config(conf, async move {
        if let Err(problem) = run(places, start).await {
            eprintln!("{problem}");
        }
    });
}

async fn run(places: Places, start: Option<Attempt>) -> Result<(), String> {
    let mut canvas = Canvas::new()?;
    let mut theatre = Theatre::default();
    let mut app = App::new(places);
    if let Some(attempt) = start {
        app.grant(Request::Attempt(attempt), &mut theatre);
    }
    loop {
        canvas.begin()?;
        if !app.update(&read_input(&canvas), &mut theatre) {
            return Ok(());
        }
        draw(&app, &canvas);
        next_frame().await;
    }
}

fn read_input(canvas: &Canvas) -> Input {
    let keys = |is: fn(KeyCode) -> bool| KEYS.iter().filter(|(code, _)| is(*code)).map(|(_, key)| *key).collect::<Keys>();
    Input {
        frame: *canvas.frame(),
        frame_time: f64::from(get_frame_time()),
        pointer: canvas.to_canvas(Vec2::from(mouse_position())),
        click: is_mouse_button_pressed(MouseButton::Left),
        holding: is_mouse_button_down(MouseButton::Left),
        right_click: is_mouse_button_pressed(MouseButton::Right),
        // Systems disagree by a factor of 120 on what a notch is; they agree on its sign.
        wheel: mouse_wheel().1.clamp(-1.0, 1.0),
        pressed: keys(is_key_pressed),
        held: keys(is_key_down),
        typed: std::iter::from_fn(get_char_pressed).collect(),
    }
}

fn draw(app: &App, canvas: &Canvas) {
    match app.screen() {
        Screen::Menu(screen) => screen.draw(canvas),
        Screen::LevelSelect(screen) => screen.draw(canvas),
        Screen::Flight(screen) => {
            draw_plainly(screen.game(), canvas);
            screen.draw_pause(canvas);
        }
        Screen::Scoring(screen) => screen.draw(canvas),
        Screen::SaveScore(screen) => screen.draw(canvas, app.shown_for()),
        Screen::Leaderboard(screen) => screen.draw(canvas),
        Screen::Classics(screen) => screen.draw(canvas),
    }
    let veil = 1.0 - (app.shown_for() / FADE).min(1.0);
    if veil > 0.0 {
        widgets::curtain(canvas, veil as f32);
    }
    canvas.end_layer();
}

/// The whole level in the window: rectangles, the ship as a pointer.
fn draw_plainly(game: &Game, canvas: &Canvas) {
    let level = game.level();
    let scale = (canvas.size() / level.size.as_vec2()).min_element();
    let area = |bounds: &Aabb| Area { min: bounds.min.as_vec2() * scale, size: bounds.size().as_vec2() * scale };
    for solid in &level.world {
        canvas.rounded(area(&solid.bounds), 0.0, theme::SOLID);
    }
    for deadly in &level.obstacles {
        canvas.rounded(area(deadly), 0.0, theme::BAD);
    }
    for (objective, met) in level.objectives.iter().zip(game.met()) {
        canvas.rounded(area(&objective.bounds), 0.0, if *met { theme::GOOD } else { theme::PLAYER_OBJECTIVE });
    }
    for body in game.world().bodies().iter().skip(1) {
        canvas.rounded(area(&Aabb::around(body.position, body.half)), 0.0, theme::QUIET);
    }
    let ship = game.world().body(SHIP);
    let turn = Vec2::from_angle((game.ship().angle as f32).to_radians());
    let at = |x: f32, y: f32| (ship.position.as_vec2() + turn.rotate(Vec2::new(x, y))) * scale;
    canvas.convex(&[at(0.0, -0.85), at(0.7, 0.85), at(-0.7, 0.85)], theme::TEXT);
}

/// What watches the attempt that is on the screen.
#[derive(Default)]
struct Theatre {
    tick_started: f64,
}

impl Spectator for Theatre {
    fn begins(&mut self, _game: &Game) {}

    fn before_tick(&mut self) {
        self.tick_started = get_time();
    }

    fn after_tick(&mut self, _game: &Game) {}
}
