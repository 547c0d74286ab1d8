//! The lab in the window: a scene on which two methods run side by side, so that one sees them part.

use super::{Input, Key, Request, Toolbar};
use crate::lab::side_by_side::{Exhibit, Motion, STEP, exhibits};
use crate::physics::Aabb;

/// A hitch counts as at most so long, s.
const LONGEST_FRAME: f64 = 0.1;
/// The toolbar's keys: back, restart, another method on the left, one on the right, another scene.
const KEYS: [Key; 5] = [Key::Escape, Key::R, Key::Left, Key::Right, Key::Down];

/// One of the two sides.
struct Side {
    method: usize,
    motion: Motion,
    boxes: Vec<Aabb>,
}

impl std::fmt::Debug for Side {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Side").field("method", &self.method).field("boxes", &self.boxes).finish_non_exhaustive()
    }
}

impl Side {
    fn of(exhibit: &Exhibit, method: usize) -> Self {
        let mut motion = (exhibit.methods[method].1)();
        let boxes = motion();
        Self { method, motion, boxes }
    }
}

/// A scene, and two methods on it.
#[derive(Debug)]
pub struct Lab {
    exhibits: Vec<Exhibit>,
    exhibit: usize,
    sides: [Side; 2],
    /// Since the start, s; and what is left of it for the next step.
    time: f64,
    left_over: f64,
    toolbar: Toolbar,
}

impl Default for Lab {
    fn default() -> Self {
        let exhibits = exhibits();
        let sides = begin(&exhibits[0]);
        Self { exhibits, exhibit: 0, sides, time: 0.0, left_over: 0.0, toolbar: Toolbar::default() }
    }
}

/// The first method against the shipped engine.
fn begin(exhibit: &Exhibit) -> [Side; 2] {
    [Side::of(exhibit, 0), Side::of(exhibit, exhibit.methods.len() - 1)]
}

impl Lab {
    /// One frame.
    pub fn update(&mut self, input: &Input) -> Option<Request> {
        match self.toolbar.update(input, &KEYS) {
            Some(0) => return Some(Request::Menu),
            Some(1) => self.restart([0, 0]),
            Some(2) => self.restart([1, 0]),
            Some(3) => self.restart([0, 1]),
            Some(4) => {
                self.exhibit = (self.exhibit + 1) % self.exhibits.len();
                self.sides = begin(&self.exhibits[self.exhibit]);
                (self.time, self.left_over) = (0.0, 0.0);
            }
            Some(_) | None => {}
        }
        self.left_over += input.frame_time.clamp(0.0, LONGEST_FRAME);
        while self.left_over >= STEP {
            self.left_over -= STEP;
            self.time += STEP;
            for side in &mut self.sides {
                side.boxes = (side.motion)();
            }
        }
        None
    }

    /// Starts again, each side so many methods further.
    fn restart(&mut self, further: [usize; 2]) {
        let exhibit = &self.exhibits[self.exhibit];
        let methods = exhibit.methods.len();
        self.sides = std::array::from_fn(|i| Side::of(exhibit, (self.sides[i].method + further[i]) % methods));
        (self.time, self.left_over) = (0.0, 0.0);
    }

    /// What is shown.
    pub fn exhibit(&self) -> &Exhibit {
        &self.exhibits[self.exhibit]
    }

    /// The names of the two methods and where their boxes are.
    pub fn sides(&self) -> [(&'static str, &[Aabb]); 2] {
        std::array::from_fn(|i| (self.exhibit().methods[self.sides[i].method].0, &self.sides[i].boxes[..]))
    }

    /// Since the start, s.
    pub fn time(&self) -> f64 {
        self.time
    }

    /// Its buttons.
    pub fn toolbar(&self) -> &Toolbar {
        &self.toolbar
    }
}

#[cfg(feature = "window")]
mod drawing {
    use super::Lab;
    use crate::physics::{Aabb, DVec2};
    use crate::view::canvas::{Canvas, Style};
    use crate::view::layout::{Area, BUTTON_TEXT, TEXT, Vec2};
    use crate::view::{theme, widgets};
    use macroquad::color::Color;

    /// From the canvas' top to the two panels, and from their foot to the canvas'.
    const TOP: f32 = 96.0;
    const FOOT: f32 = 136.0;
    /// Between panels and canvas.
    const MARGIN: f32 = 24.0;

    impl Lab {
        /// Draws both sides and the buttons.
        pub fn draw(&self, canvas: &Canvas) {
            widgets::graph_paper(canvas);
            let size = canvas.size();
            let heading = Style::new(BUTTON_TEXT, theme::TEXT).centred().middle();
            canvas.text(self.exhibit().title, Vec2::new(size.x / 2.0, 40.0), heading);
            let width = (size.x - 3.0 * MARGIN) / 2.0;
            for (i, (name, boxes)) in self.sides().into_iter().enumerate() {
                let left = MARGIN + i as f32 * (width + MARGIN);
                let panel = Area::new(left, TOP, width, size.y - TOP - FOOT);
                widgets::panel(canvas, panel);
                let place = Placing::new(&self.exhibit().view, panel.inset(12.0));
                for solid in &self.exhibit().solid {
                    place.draw(canvas, solid, theme::SOLID);
                }
                for body in boxes {
                    place.draw(canvas, body, if i == 0 { theme::PLAYER_OBJECTIVE } else { theme::ACCENT });
                }
                canvas.text(name, Vec2::new(panel.centre().x, TOP - 20.0), Style::new(TEXT, theme::QUIET).centred().middle());
            }
            let words = format!("60 steps a second    time {:6.2} s", self.time());
            let at = Vec2::new(size.x / 2.0, size.y - 104.0);
            canvas.text(&words, at, Style::new(TEXT, theme::QUIET).mono().centred().middle());
            let labels = [("Back", "Esc"), ("Restart", "R"), ("Left", "←"), ("Right", "→"), ("Scene", "↓")];
            self.toolbar.draw(canvas, &labels);
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

        /// What sticks out of the panel is cut off.
        fn draw(&self, canvas: &Canvas, body: &Aabb, colour: Color) {
            let inside = |point: Vec2| point.clamp(self.panel.min, self.panel.max());
            let (min, max) = (inside(self.at(body.min)), inside(self.at(body.max)));
            let size = max - min;
            if size.x > 0.0 && size.y > 0.0 {
                let area = Area::new(min.x, min.y, size.x, size.y);
                canvas.rounded(area, 0.0, theme::faded(colour, 0.35));
                canvas.rounded_edge(area, 0.0, 2.0, colour);
            }
        }
    }
}
