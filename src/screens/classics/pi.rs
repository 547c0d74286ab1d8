//! π from collisions in the window.

use crate::classics::pi::{Blocks, MAX_N, mass_ratio};
use crate::draw::layout::{Area, BUTTON_TEXT, MONO_ADVANCE, TEXT, TITLE, Vec2};
use crate::draw::{Canvas, Colour, Style};
use crate::screens::screen::{Classic, Destination, Noise, Request, Screen};
use crate::ui::{Ui, input::Input, pace::Motion};
use crate::{number, settings::Key, view::theme, view::widgets, words::tr};

/// Seconds of the scene a second, from the slowest to the fastest; it begins with the real one.
const SPEEDS: [f64; 6] = [0.01, 0.05, 0.25, 1.0, 2.0, 4.0];
const REAL: usize = 3;
/// A hitch counts as at most so long, s.
const LONGEST_FRAME: f64 = 0.1;
/// The most collisions of a frame: about 5 ms of work. Where there are more, time waits for them.
const MOST_A_FRAME: u64 = 300_000;
/// The first digits of π, as many as there are places at the largest N.
pub const DIGITS: &str = "3141592653";
const FIRST_N: u32 = 2;

/// How long the counter shows that there was a collision, s.
const FLASH: f64 = 0.12;
/// From the canvas' left edge to the wall's face.
const WALL: f32 = 64.0;
/// From the canvas' foot to the floor.
const FLOOR: f32 = 136.0;
/// Canvas units a metre of distance.
const METRE: f32 = 300.0;
/// Canvas units a unit of the blocks' sides, |log₁₀(mass + 10)|: the largest block, 18 of them, leaves room for the counter.
const SIDE: f32 = 19.0;

const TOOLS: [(&str, Key, &str); 6] = [
    ("Back", Key::Escape, "Esc"),
    ("Restart", Key::R, "R"),
    ("N − 1", Key::Left, "←"),
    ("N + 1", Key::Right, "→"),
    ("Slower", Key::Down, "↓"),
    ("Faster", Key::Up, "↑"),
];

#[derive(Debug)]
pub struct Pi {
    pub n: u32,
    pub blocks: Blocks,
    /// s.
    time: f64,
    speed: usize,
    /// Whether the last frame's work did not suffice.
    behind: bool,
    /// Since the last collision, s of the screen.
    quiet_for: f64,
}

impl Default for Pi {
    fn default() -> Self {
        Self { n: FIRST_N, blocks: Blocks::new(FIRST_N), time: 0.0, speed: REAL, behind: false, quiet_for: f64::INFINITY }
    }
}

impl Pi {
    /// Seconds of the scene a second.
    pub fn speed(&self) -> f64 {
        SPEEDS[self.speed]
    }

    /// The counter, with as many places as there will be digits, and how many of them, from the left, are right.
    pub fn counter(&self) -> (String, usize) {
        let counter = format!("{:0places$}", self.blocks.collisions, places = self.n as usize + 1);
        let right = counter.bytes().zip(DIGITS.bytes()).take_while(|(ours, true_one)| ours == true_one).count();
        (counter, right)
    }

    fn restart(&mut self, n: u32) {
        *self = Self { n, blocks: Blocks::new(n), speed: self.speed, ..Self::default() };
    }

    fn advance(&mut self, frame_time: f64) {
        if frame_time <= 0.0 {
            return;
        }
        let until = self.time + frame_time.min(LONGEST_FRAME) * self.speed();
        let made = self.blocks.advance(until, MOST_A_FRAME);
        self.behind = made == MOST_A_FRAME;
        self.time = if self.behind { self.blocks.time } else { until };
        self.quiet_for = if made > 0 { 0.0 } else { self.quiet_for + frame_time };
    }

    fn draw(&self, canvas: &Canvas) {
        widgets::graph_paper(canvas);
        self.draw_blocks(canvas);
        self.draw_counter(canvas);
        let speed = match self.speed() {
            whole if whole >= 1.0 => format!("{whole} ×"),
            slow => format!("1/{} ×", (1.0 / slow).round()),
        };
        let words = tr!(
            "N = {n}    masses 1 : {ratio}    time {time} s    speed {speed}",
            n = self.n,
            ratio = power(2 * self.n),
            time = format_args!("{:6.3}", self.time),
            speed
        );
        let at = Vec2::new(canvas.size().x / 2.0, canvas.size().y - 96.0);
        canvas.text(&words, at, Style::new(TEXT, theme::quiet()).mono().centred().middle());
    }

    fn draw_blocks(&self, canvas: &Canvas) {
        let floor = canvas.size().y - FLOOR;
        let solid = |area: Area| canvas.rounded(area, 0.0, theme::solid());
        solid(Area::new(0.0, 0.0, WALL, floor));
        solid(Area::new(0.0, floor, canvas.size().x, 10.0));
        canvas.rounded(Area::new(WALL, floor, canvas.size().x - WALL, 2.0), 0.0, theme::solid_top());
        canvas.rounded(Area::new(WALL - 2.0, 0.0, 2.0, floor), 0.0, theme::solid_top());

        let (light, heavy) = self.blocks.positions(self.time);
        let light_side = SIDE * side(1.0);
        self.draw_block(canvas, WALL + light as f32 * METRE, 1.0, theme::player_objective());
        self.draw_block(canvas, WALL + light_side + heavy as f32 * METRE, mass_ratio(self.n), theme::accent());
    }

    fn draw_block(&self, canvas: &Canvas, left: f32, mass: f64, colour: Colour) {
        let side = SIDE * side(mass);
        let area = Area::new(left, canvas.size().y - FLOOR - side, side, side);
        canvas.rounded(area, 2.0, theme::panel());
        canvas.rounded_edge(area, 2.0, 3.0, colour);
        let (label, size) = if mass == 1.0 { ("1".to_owned(), TEXT) } else { (power(2 * self.n), BUTTON_TEXT) };
        let style = Style::new(size, colour).mono().centred().middle();
        let above = Vec2::new(area.centre().x, area.min.y - 20.0);
        canvas.text(&label, if canvas.width(&label, style) + 8.0 < side { area.centre() } else { above }, style);
    }

    fn draw_counter(&self, canvas: &Canvas) {
        let (counter, right) = self.counter();
        let middle = (canvas.size().x + WALL) / 2.0;
        let quiet = Style::new(TEXT, theme::quiet()).centred().middle();
        canvas.text(tr("collisions"), Vec2::new(middle, 40.0), quiet);
        let leading = counter.bytes().take_while(|digit| *digit == b'0').count().min(counter.len() - 1);
        let advance = TITLE * MONO_ADVANCE;
        let left = middle - advance * (counter.len() as f32 - 1.0) / 2.0;
        let flash = (1.0 - self.quiet_for / FLASH).max(0.0) as f32;
        for (place, digit) in counter.chars().enumerate() {
            let colour = match place {
                _ if place < right => theme::good(),
                _ if place < leading => theme::panel_edge(),
                _ => theme::text(),
            };
            let at = Vec2::new(left + advance * place as f32, 104.0);
            canvas.text(&digit.to_string(), at, Style::new(TITLE, colour).mono().centred().middle());
        }
        let width = advance * counter.len() as f32;
        let bar = Area::new(middle - width / 2.0, 156.0, width, 4.0);
        canvas.rounded(bar, 2.0, theme::accent().faded(0.15 + 0.85 * flash));
        let digits = &DIGITS[..counter.len()];
        let of_pi = if counter.len() == 1 { tr("digit").to_owned() } else { tr!("{digits} digits", digits = counter.len()) };
        let words = match (self.blocks.next_time(), self.behind) {
            (None, _) => tr!("No more will come: the first {digits} of π", digits = of_pi),
            (Some(_), true) => tr("More than a frame can hold: time waits for them").to_owned(),
            (Some(_), false) => format!("π = {}{}{}…", &digits[..1], if self.n > 0 { "." } else { "" }, &digits[1..]),
        };
        canvas.text(&words, Vec2::new(middle, 184.0), quiet);
    }
}

impl Screen for Pi {
    fn show(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        self.draw(ui.canvas());
        match ui.tools(&TOOLS) {
            Some("Back") => return Some(Request::Pop),
            Some("Restart") => self.restart(self.n),
            Some("N − 1") if self.n > 0 => self.restart(self.n - 1),
            Some("N + 1") if self.n < MAX_N => self.restart(self.n + 1),
            Some("Slower") => self.speed = self.speed.saturating_sub(1),
            Some("Faster") => self.speed = (self.speed + 1).min(SPEEDS.len() - 1),
            Some(_) | None => {}
        }
        self.advance(ui.input().frame_time);
        None
    }

    fn parent(&self) -> Destination {
        Destination::Classics(Some(Classic::Pi))
    }

    fn motion(&self, _: &Input) -> Motion {
        Motion::Full
    }

    fn tune(&self) -> Option<&str> {
        Some("pi")
    }

    fn noises(&self) -> Vec<Noise> {
        if self.quiet_for == 0.0 { vec![Noise::Collision] } else { Vec::new() }
    }
}

/// A block's side for its mass in light ones.
fn side(mass: f64) -> f32 {
    (mass + 10.0).log10().abs() as f32
}

fn power(exponent: u32) -> String {
    match exponent {
        0..=4 => 10_u64.pow(exponent).to_string(),
        _ => number::power(exponent.cast_signed()),
    }
}
