//! Two methods on the same scene at the same time, one in each half of the screen, with their errors now and so far.

mod drawing;

use super::BACK;
use crate::draw::layout::{Area, BUTTON_TEXT, DETAILS, Frame, TEXT, Vec2};
use crate::lab::side_by_side::{BoxMotion, Exhibit, STEPS, USUAL_STEP, error, exhibits};
use crate::{draw::Style, lab::curve::worst, number, settings::Key, words::tr};
use crate::{physics::Aabb, physics::DVec2, screens::screen::Request, ui::Ui, ui::WidgetKind, view::theme, view::widgets};
use std::collections::VecDeque;

/// s. The most of a hitch that counts.
const LONGEST_FRAME: f64 = 0.1;
struct MethodButton {
    label: &'static str,
    arrow: &'static str,
    key: Key,
    named: &'static str,
    /// The places down the list of methods, of the left half and of the right one.
    further: [isize; 2],
}

const METHOD_BUTTONS: [MethodButton; 4] = [
    MethodButton { label: "Method before, left", arrow: "‹", key: Key::A, named: "A", further: [-1, 0] },
    MethodButton { label: "Next method, left", arrow: "›", key: Key::D, named: "D", further: [1, 0] },
    MethodButton { label: "Method before, right", arrow: "‹", key: Key::Left, named: "←", further: [0, -1] },
    MethodButton { label: "Next method, right", arrow: "›", key: Key::Right, named: "→", further: [0, 1] },
];
const CHOICE: Vec2 = Vec2::new(64.0, 40.0);
const TITLE: f32 = 40.0;
/// The method's name, its rule, and what it uses.
const HEAD: f32 = 92.0;
/// Height of the errors so far, below the halves, and from these to the time.
const ERRORS: f32 = 84.0;
const TIME: f32 = 36.0;
const WORDS: f32 = APART + ERRORS + TIME;
const APART: f32 = 12.0;
const BETWEEN: f32 = 24.0;
const TRAIL: usize = 240;
const MOMENTS: usize = 400;

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Half<'a> {
    pub method: &'static str,
    pub boxes: &'a [Aabb],
    /// The latest last.
    pub trail: &'a VecDeque<Vec<DVec2>>,
    /// The error of its worst box, m.
    pub error: f64,
    /// The largest error in each part of the scene that has begun: [`parts`](Half::parts) of them.
    pub errors: &'a [f64],
}

impl Half<'_> {
    pub fn parts() -> usize {
        MOMENTS
    }
}

struct RunningMethod {
    method: usize,
    motion: BoxMotion,
    boxes: Vec<Aabb>,
    trail: VecDeque<Vec<DVec2>>,
    errors: Vec<f64>,
}

impl std::fmt::Debug for RunningMethod {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("RunningMethod").field("method", &self.method).field("boxes", &self.boxes).finish_non_exhaustive()
    }
}

impl RunningMethod {
    fn new(method: usize, motion: BoxMotion, boxes: Vec<Aabb>) -> Self {
        Self { method, motion, boxes, trail: VecDeque::new(), errors: Vec::new() }
    }

    fn of(exhibit: &Exhibit, method: usize, step: f64) -> Self {
        Self::new(method, (exhibit.methods[method].1)(step), exhibit.start.clone())
    }

    fn exact(exhibit: &Exhibit, step: f64) -> Self {
        Self::new(exhibit.methods.len(), (exhibit.exact)(step), exhibit.start.clone())
    }

    /// Makes a step that ends in `part` of the scene, where `exact` is the exact place of each box.
    fn step(&mut self, part: usize, exact: &[Aabb]) {
        if self.trail.len() == TRAIL {
            self.trail.pop_front();
        }
        self.trail.push_back(self.boxes.iter().map(Aabb::centre).collect());
        self.boxes = (self.motion)();
        let found = error(&self.boxes, exact);
        // A step longer than a part skips parts.
        self.errors.resize(self.errors.len().max(part + 1), found);
        self.errors[part] = worst([self.errors[part], found]);
    }
}

#[derive(Debug)]
pub struct SideBySide {
    exhibits: Vec<Exhibit>,
    exhibit: usize,
    step: usize,
    halves: [RunningMethod; 2],
    exact: RunningMethod,
    steps: u32,
    /// s. The scene's time that remains for the next step.
    left_over: f64,
    paused: bool,
}

impl Default for SideBySide {
    fn default() -> Self {
        let exhibits = exhibits();
        let step = STEPS[USUAL_STEP];
        let halves = first_against_shipped(&exhibits[0], step);
        let exact = RunningMethod::exact(&exhibits[0], step);
        Self { exhibits, exhibit: 0, step: USUAL_STEP, halves, exact, steps: 0, left_over: 0.0, paused: false }
    }
}

fn first_against_shipped(exhibit: &Exhibit, step: f64) -> [RunningMethod; 2] {
    [exhibit.first, exhibit.methods.len() - 1].map(|method| RunningMethod::of(exhibit, method, step))
}

impl SideBySide {
    pub(super) fn show(&mut self, ui: &mut Ui<'_>, body: Area) -> Option<Request> {
        let request = self.show_tools(ui);
        self.show_choices(ui, panels(body, &ui.frame()));
        if !self.paused {
            self.advance(ui.input().frame_time);
        }
        self.draw(ui.canvas(), body);
        request
    }

    fn show_tools(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        let pause = if self.paused { "Go on" } else { "Pause" };
        let step = tr!("Step {step}", step = number::step(self.step()));
        let tools = [
            BACK,
            ("Restart", Key::R, "R"),
            (pause, Key::Space, "Space"),
            ("One step", Key::Period, "."),
            (&step, Key::S, "S"),
            ("Before", Key::Up, "↑"),
            ("Next", Key::Down, "↓"),
        ];
        match ui.tools(&tools)? {
            "Back" => return Some(Request::Pop),
            "Restart" => self.restart([0, 0]),
            "Pause" | "Go on" => self.paused = !self.paused,
            "One step" => self.single_step(),
            "Before" => self.turn_to(self.exhibit + self.exhibits.len() - 1),
            "Next" => self.turn_to(self.exhibit + 1),
            _ => {
                self.step = (self.step + 1) % STEPS.len();
                self.restart([0, 0]);
            }
        }
        None
    }

    fn show_choices(&mut self, ui: &mut Ui<'_>, panels: [Area; 2]) {
        let places = panels.into_iter().flat_map(|panel| [(panel.min.x, panel), (panel.max().x - CHOICE.x, panel)]);
        for ((x, panel), MethodButton { label, arrow, key, named, further }) in places.zip(METHOD_BUTTONS) {
            let area = Area { min: Vec2::new(x, panel.min.y - head(&ui.frame())), size: CHOICE };
            let touch = ui.touch(label, area, WidgetKind::Tool);
            widgets::button_box(ui.canvas(), area, touch.hover, false);
            ui.tip(area, label);
            // The arrow points outwards.
            let outwards = if arrow == "‹" { -12.0 } else { 12.0 };
            let (at, key_at) = (Vec2::new(outwards, 0.0), Vec2::new(-outwards, 0.0));
            ui.text(arrow, area.centre() + at, Style::new(BUTTON_TEXT, theme::text()).centred().middle());
            ui.text(named, area.centre() + key_at, Style::new(TEXT, theme::accent()).mono().centred().middle());
            if touch.pressed || ui.key(key) {
                self.restart(further);
            }
        }
    }

    fn advance(&mut self, frame_time: f64) {
        self.left_over += frame_time.clamp(0.0, LONGEST_FRAME) * self.exhibit().speed;
        while self.left_over >= self.step() && !self.is_over() {
            self.left_over -= self.step();
            self.make_step();
        }
    }

    fn single_step(&mut self) {
        self.paused = true;
        self.left_over = 0.0;
        if !self.is_over() {
            self.make_step();
        }
    }

    fn make_step(&mut self) {
        self.steps += 1;
        let part = (self.time() / self.exhibit().seconds * MOMENTS as f64).ceil() as usize;
        let part = part.clamp(1, MOMENTS) - 1;
        self.exact.boxes = (self.exact.motion)();
        for half in &mut self.halves {
            half.step(part, &self.exact.boxes);
        }
    }

    fn turn_to(&mut self, exhibit: usize) {
        self.exhibit = exhibit % self.exhibits.len();
        self.halves = first_against_shipped(&self.exhibits[self.exhibit], self.step());
        self.restart([0, 0]);
    }

    /// Starts again with other methods, each `further` places down the list.
    fn restart(&mut self, further: [isize; 2]) {
        let (exhibit, step) = (&self.exhibits[self.exhibit], self.step());
        let methods = exhibit.methods.len();
        let next = |half: usize| self.halves[half].method.saturating_add_signed(further[half] + methods as isize) % methods;
        self.halves = [next(0), next(1)].map(|method| RunningMethod::of(exhibit, method, step));
        self.exact = RunningMethod::exact(exhibit, step);
        (self.steps, self.left_over, self.paused) = (0, 0.0, false);
    }

    pub fn exhibit(&self) -> &Exhibit {
        &self.exhibits[self.exhibit]
    }

    pub fn halves(&self) -> [Half<'_>; 2] {
        self.halves.each_ref().map(|runner| {
            let method = self.exhibit().methods[runner.method].0;
            let RunningMethod { boxes, trail, errors, .. } = runner;
            Half { method, boxes, trail, errors, error: error(boxes, &self.exact.boxes) }
        })
    }

    pub fn exact(&self) -> &[Aabb] {
        &self.exact.boxes
    }

    /// s.
    pub fn step(&self) -> f64 {
        STEPS[self.step]
    }

    /// s.
    pub fn time(&self) -> f64 {
        f64::from(self.steps) * self.step()
    }

    pub fn is_paused(&self) -> bool {
        self.paused
    }

    pub fn is_over(&self) -> bool {
        self.time() + 0.5 * self.step() >= self.exhibit().seconds
    }
}

/// Height of a half's head: its rule and what it uses have a line each, or two where they are large.
fn head(frame: &Frame) -> f32 {
    if frame.text > 1.0 { HEAD + 2.3 * frame.text_height(DETAILS) } else { HEAD }
}

fn panels(body: Area, frame: &Frame) -> [Area; 2] {
    let size = Vec2::new((body.size.x - BETWEEN) / 2.0, body.size.y - TITLE - head(frame) - WORDS);
    let top = body.min.y + TITLE + head(frame);
    [0.0, size.x + BETWEEN].map(|right| Area { min: Vec2::new(body.min.x + right, top), size })
}
