//! Two methods on the same scene at the same time, one in each half of the screen, and how far each is from the truth.

use super::body;
use crate::lab::side_by_side::{Exhibit, Motion, STEP, error, exhibits};
use crate::physics::Aabb;
use crate::screens::{Buttons, Input, Key, Keys, Toolbar};
use crate::view::layout::{Area, Frame, Vec2};

/// A hitch counts as at most so long, s.
const LONGEST_FRAME: f64 = 0.1;
/// The toolbar's keys: back, restart, pause, the scene before, the next one.
const KEYS: [Key; 5] = [Key::Escape, Key::R, Key::Space, Key::Up, Key::Down];
/// The keys of the choices above the halves: the method before and the next one, of the left half and of the right one.
const CHOICES: [Key; 4] = [Key::A, Key::D, Key::Left, Key::Right];
/// Width and height of the buttons of a choice.
const CHOICE: Vec2 = Vec2::new(64.0, 40.0);
/// From the body's top to the choices: the scene's title.
const TITLE: f32 = 40.0;
/// From the choices' top to the halves.
const HEAD: f32 = 48.0;
/// From the halves to the body's foot: the time.
const WORDS: f32 = 40.0;
/// Between the halves.
const BETWEEN: f32 = 24.0;

/// What is to be seen of one half.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Half<'a> {
    /// The method that runs in it.
    pub method: &'static str,
    /// Where its boxes are.
    pub boxes: &'a [Aabb],
    /// How far the worst of them is from where it should be, m.
    pub error: f64,
}

/// A method at work.
struct Runner {
    method: usize,
    motion: Motion,
    boxes: Vec<Aabb>,
}

impl std::fmt::Debug for Runner {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Runner").field("method", &self.method).field("boxes", &self.boxes).finish_non_exhaustive()
    }
}

impl Runner {
    fn of(exhibit: &Exhibit, method: usize) -> Self {
        Self { method, motion: (exhibit.methods[method].1)(), boxes: exhibit.start.clone() }
    }

    fn exact(exhibit: &Exhibit) -> Self {
        Self { method: exhibit.methods.len(), motion: (exhibit.exact)(), boxes: exhibit.start.clone() }
    }
}

/// The page.
#[derive(Debug)]
pub struct SideBySide {
    exhibits: Vec<Exhibit>,
    exhibit: usize,
    halves: [Runner; 2],
    exact: Runner,
    steps: u32,
    /// Of the scene's time, what is left for the next step, s.
    left_over: f64,
    paused: bool,
    choices: Buttons,
    toolbar: Toolbar,
}

impl Default for SideBySide {
    fn default() -> Self {
        let exhibits = exhibits();
        let halves = first_against_shipped(&exhibits[0]);
        let exact = Runner::exact(&exhibits[0]);
        let (choices, toolbar) = (Buttons::default(), Toolbar::default());
        Self { exhibits, exhibit: 0, halves, exact, steps: 0, left_over: 0.0, paused: false, choices, toolbar }
    }
}

fn first_against_shipped(exhibit: &Exhibit) -> [Runner; 2] {
    [Runner::of(exhibit, exhibit.first), Runner::of(exhibit, exhibit.methods.len() - 1)]
}

impl SideBySide {
    /// One frame; whether the lab is left.
    pub(super) fn update(&mut self, input: &Input) -> bool {
        self.choices.place(places(&input.frame));
        let pointer_only = Input { pressed: Keys::default(), ..input.clone() };
        let chosen = self.choices.update(&pointer_only).or_else(|| CHOICES.iter().position(|key| input.pressed(*key)));
        match self.toolbar.update(input, &KEYS) {
            Some(0) => return true,
            Some(1) => self.restart([0, 0]),
            Some(2) => self.paused = !self.paused,
            Some(3) => self.turn_to(self.exhibit + self.exhibits.len() - 1),
            Some(4) => self.turn_to(self.exhibit + 1),
            Some(_) | None => {}
        }
        match chosen {
            Some(0) => self.restart([-1, 0]),
            Some(1) => self.restart([1, 0]),
            Some(2) => self.restart([0, -1]),
            Some(3) => self.restart([0, 1]),
            Some(_) | None => {}
        }
        if !self.paused {
            self.advance(input.frame_time);
        }
        false
    }

    fn advance(&mut self, frame_time: f64) {
        self.left_over += frame_time.clamp(0.0, LONGEST_FRAME) * self.exhibit().speed;
        while self.left_over >= STEP && !self.is_over() {
            self.left_over -= STEP;
            self.steps += 1;
            for runner in self.halves.iter_mut().chain([&mut self.exact]) {
                runner.boxes = (runner.motion)();
            }
        }
    }

    fn turn_to(&mut self, exhibit: usize) {
        self.exhibit = exhibit % self.exhibits.len();
        self.halves = first_against_shipped(&self.exhibits[self.exhibit]);
        self.restart([0, 0]);
    }

    /// Starts again, each half so many methods further.
    fn restart(&mut self, further: [isize; 2]) {
        let exhibit = &self.exhibits[self.exhibit];
        let methods = exhibit.methods.len();
        let next = |half: usize| self.halves[half].method.saturating_add_signed(further[half] + methods as isize) % methods;
        self.halves = [next(0), next(1)].map(|method| Runner::of(exhibit, method));
        self.exact = Runner::exact(exhibit);
        (self.steps, self.left_over, self.paused) = (0, 0.0, false);
    }

    /// What is shown.
    pub fn exhibit(&self) -> &Exhibit {
        &self.exhibits[self.exhibit]
    }

    /// The left and the right half.
    pub fn halves(&self) -> [Half<'_>; 2] {
        self.halves.each_ref().map(|runner| {
            let method = self.exhibit().methods[runner.method].0;
            Half { method, boxes: &runner.boxes, error: error(&runner.boxes, &self.exact.boxes) }
        })
    }

    /// Where everything should be.
    pub fn exact(&self) -> &[Aabb] {
        &self.exact.boxes
    }

    /// Of the scene, since the start, s.
    pub fn time(&self) -> f64 {
        f64::from(self.steps) * STEP
    }

    /// Whether it stands still for a while.
    pub fn is_paused(&self) -> bool {
        self.paused
    }

    /// Whether the scene has ended.
    pub fn is_over(&self) -> bool {
        self.time() + 0.5 * STEP >= self.exhibit().seconds
    }

    /// Which method runs where: the one before and the next one, of the left half and of the right one.
    pub fn choices(&self) -> &Buttons {
        &self.choices
    }

    /// Its buttons: Back, Restart, Pause, the scene before, the next one.
    pub fn toolbar(&self) -> &Toolbar {
        &self.toolbar
    }
}

/// The two halves.
fn panels(frame: &Frame) -> [Area; 2] {
    let body = body(frame);
    let size = Vec2::new((body.size.x - BETWEEN) / 2.0, body.size.y - TITLE - HEAD - WORDS);
    let top = body.min.y + TITLE + HEAD;
    [0.0, size.x + BETWEEN].map(|right| Area { min: Vec2::new(body.min.x + right, top), size })
}

/// The buttons of the choices, above the corners of the halves.
fn places(frame: &Frame) -> Vec<Area> {
    let button = |x: f32, panel: Area| Area { min: Vec2::new(x, panel.min.y - HEAD), size: CHOICE };
    panels(frame).into_iter().flat_map(|panel| [panel.min.x, panel.max().x - CHOICE.x].map(|x| button(x, panel))).collect()
}

#[cfg(feature = "window")]
mod drawing {
    use super::{Half, SideBySide, panels};
    use crate::lab::axes::number;
    use crate::physics::{Aabb, DVec2};
    use crate::view::canvas::{Canvas, Style};
    use crate::view::layout::{Area, BUTTON_TEXT, TEXT, Vec2};
    use crate::view::{theme, widgets};
    use macroquad::color::Color;

    /// Height of the line at a half's foot: its error.
    const FOOT: f32 = 40.0;
    /// Errors from here on are written with as many decimals, so that they do not jitter.
    const PLAIN: f64 = 1e-3;
    /// What the buttons of the choices say: left half, right half.
    const CHOICES: [(&str, &str); 4] = [("‹", "A"), ("›", "D"), ("‹", "←"), ("›", "→")];
    /// The colours of the two halves' boxes.
    fn colour_of(half: usize) -> Color {
        if half == 0 { theme::player_objective() } else { theme::accent() }
    }

    impl SideBySide {
        /// Draws both halves and the buttons.
        pub(in crate::screens::lab) fn draw(&self, canvas: &Canvas) {
            let middle = canvas.size().x / 2.0;
            let halves = panels(canvas.frame());
            let title = Vec2::new(middle, super::body(canvas.frame()).min.y + 20.0);
            canvas.text(self.exhibit().title, title, Style::new(BUTTON_TEXT, theme::text()).centred().middle());
            for (i, (half, panel)) in self.halves().iter().zip(halves).enumerate() {
                self.draw_half(canvas, half, panel, colour_of(i));
            }
            for (i, (area, (arrow, key))) in self.choices.areas().iter().zip(CHOICES).enumerate() {
                widgets::button_box(canvas, *area, self.choices.hover() == Some(i), false);
                let (inner, outer) = (area.centre() - Vec2::new(12.0, 0.0), area.centre() + Vec2::new(12.0, 0.0));
                let (arrow_at, key_at) = if i % 2 == 0 { (inner, outer) } else { (outer, inner) };
                canvas.text(arrow, arrow_at, Style::new(BUTTON_TEXT, theme::text()).centred().middle());
                canvas.text(key, key_at, Style::new(TEXT, theme::accent()).mono().centred().middle());
            }
            let (left, right) = (halves[0], halves[1]);
            let row = Area::new(left.min.x, left.max().y, right.max().x - left.min.x, super::WORDS);
            self.draw_words(canvas, row);
            let pause = if self.is_paused() { "Go on" } else { "Pause" };
            self.toolbar
                .draw(canvas, &[("Back", "Esc"), ("Restart", "R"), (pause, "Space"), ("Scene before", "↑"), ("Next scene", "↓")]);
        }

        /// Below the halves: what the outline means at the left, the time at the right.
        fn draw_words(&self, canvas: &Canvas, row: Area) {
            let quiet = Style::new(TEXT, theme::quiet()).middle();
            let ghost = Area::around(Vec2::new(row.min.x + 8.0, row.centre().y), Vec2::splat(16.0));
            canvas.rounded_edge(ghost, 0.0, 2.0, theme::good());
            canvas.text("the exact answer", Vec2::new(ghost.max().x + 10.0, row.centre().y), quiet);
            let speed = self.exhibit().speed;
            let pace = if speed < 1.0 { format!("   {} times slower than real", number(1.0 / speed)) } else { String::new() };
            let end = if self.is_over() { "   the end" } else { "" };
            let words = format!("time {:6.3} s   60 steps a second{pace}{end}", self.time());
            canvas.text(&words, Vec2::new(row.max().x, row.centre().y), quiet.mono().right());
        }

        fn draw_half(&self, canvas: &Canvas, half: &Half<'_>, panel: Area, colour: Color) {
            widgets::panel(canvas, panel);
            let name = Vec2::new(panel.centre().x, panel.min.y - super::HEAD + super::CHOICE.y / 2.0);
            widgets::fitted(canvas, half.method, name, panel.size.x - 2.0 * super::CHOICE.x - 32.0, &[BUTTON_TEXT, TEXT], colour);
            let stage = Area { min: panel.min, size: panel.size - Vec2::new(0.0, FOOT) };
            let place = Placing::new(&self.exhibit().view, stage.inset(8.0));
            for solid in &self.exhibit().solid {
                place.fill(canvas, solid, theme::solid());
            }
            for body in self.exact() {
                place.edge(canvas, body, theme::good());
            }
            for body in half.boxes {
                place.fill(canvas, body, theme::faded(colour, 0.35));
                place.edge(canvas, body, colour);
            }
            canvas.hairline(
                Vec2::new(panel.min.x + 16.0, stage.max().y),
                Vec2::new(panel.max().x - 16.0, stage.max().y),
                theme::panel_edge(),
            );
            let y = stage.max().y + FOOT / 2.0;
            canvas.text("error", Vec2::new(panel.centre().x - 96.0, y), Style::new(TEXT, theme::quiet()).middle());
            let seen = if half.error <= crate::lab::TOLERANCE { theme::good() } else { theme::bad() };
            let number = Vec2::new(panel.centre().x + 96.0, y);
            canvas.text(&metres(half.error), number, Style::new(TEXT, seen).mono().middle().right());
        }
    }

    fn metres(error: f64) -> String {
        match error {
            0.0 => "0 m".to_owned(),
            _ if !error.is_finite() => "∞ m".to_owned(),
            _ if error >= PLAIN => format!("{error:.3} m"),
            _ => format!("{error:.1e} m").replace('-', "−"),
        }
    }

    /// From metres to a panel, which it fills without stretching.
    struct Placing {
        view: Aabb,
        panel: Area,
        scale: f32,
    }

    impl Placing {
        fn new(view: &Aabb, panel: Area) -> Self {
            let size = view.size();
            let scale = (panel.size.x / size.x as f32).min(panel.size.y / size.y as f32);
            Self { view: *view, panel, scale }
        }

        fn at(&self, point: DVec2) -> Vec2 {
            let from_middle = point - self.view.centre();
            self.panel.centre() + Vec2::new(from_middle.x as f32, from_middle.y as f32) * self.scale
        }

        /// The part of a box that is inside the panel, if any.
        fn seen(&self, body: &Aabb) -> Option<Area> {
            let inside = |point: Vec2| point.clamp(self.panel.min, self.panel.max());
            let (min, max) = (inside(self.at(body.min)), inside(self.at(body.max)));
            (max.x > min.x && max.y > min.y).then_some(Area { min, size: max - min })
        }

        fn fill(&self, canvas: &Canvas, body: &Aabb, colour: Color) {
            if let Some(area) = self.seen(body) {
                canvas.rounded(area, 0.0, colour);
            }
        }

        fn edge(&self, canvas: &Canvas, body: &Aabb, colour: Color) {
            if let Some(area) = self.seen(body) {
                canvas.rounded_edge(area, 0.0, 2.0, colour);
            }
        }
    }
}
