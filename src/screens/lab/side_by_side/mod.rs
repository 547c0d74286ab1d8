//! Two methods on the same scene at the same time, one in each half of the screen, how far each is from the truth, and how far it was
//! all the while.

mod drawing;

use super::body;
use crate::draw::layout::{Area, Frame, Vec2};
use crate::lab::course::worst;
use crate::lab::side_by_side::{BoxMotion, Exhibit, STEPS, USUAL_STEP, error, exhibits};
use crate::physics::{Aabb, DVec2};
use crate::screens::{Buttons, Input, Key, Keys, Toolbar};
use std::collections::VecDeque;

/// A hitch counts as at most so long, s.
const LONGEST_FRAME: f64 = 0.1;
/// The toolbar's keys: back, restart, pause, a single step, another step, the scene before, the next one.
const KEYS: [Key; 7] = [Key::Escape, Key::R, Key::Space, Key::Period, Key::S, Key::Up, Key::Down];
/// The keys of the choices above the halves: the method before and the next one, of the left half and of the right one.
const CHOICES: [Key; 4] = [Key::A, Key::D, Key::Left, Key::Right];
/// Width and height of the buttons of a choice.
const CHOICE: Vec2 = Vec2::new(64.0, 40.0);
/// From the body's top to the choices: the scene's title.
const TITLE: f32 = 40.0;
/// From the choices' top to the halves.
const HEAD: f32 = 48.0;
/// Height of the errors so far, below the halves, and from these to the time.
const ERRORS: f32 = 84.0;
/// From the errors to the body's foot: the time.
const TIME: f32 = 36.0;
/// From the halves to the body's foot.
const WORDS: f32 = APART + ERRORS + TIME;
/// From the halves to the errors.
const APART: f32 = 12.0;
/// Between the halves.
const BETWEEN: f32 = 24.0;
/// Moments of a trail, at most.
const TRAIL: usize = 240;
/// Moments of the errors so far.
const MOMENTS: usize = 400;

/// What is to be seen of one half.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Half<'a> {
    /// The method that runs in it.
    pub method: &'static str,
    /// Where its boxes are.
    pub boxes: &'a [Aabb],
    /// Where their centres were, the latest last.
    pub trail: &'a VecDeque<Vec<DVec2>>,
    /// How far the worst of them is from where it should be, m.
    pub error: f64,
    /// The worst of that in each part of the scene that has begun: of as many as [`parts`](Half::parts) tells.
    pub errors: &'a [f64],
}

impl Half<'_> {
    /// Parts of equal length into which the whole scene is cut for the errors.
    pub fn parts() -> usize {
        MOMENTS
    }
}

/// A method at work.
struct Runner {
    method: usize,
    motion: BoxMotion,
    boxes: Vec<Aabb>,
    trail: VecDeque<Vec<DVec2>>,
    errors: Vec<f64>,
}

impl std::fmt::Debug for Runner {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Runner").field("method", &self.method).field("boxes", &self.boxes).finish_non_exhaustive()
    }
}

impl Runner {
    fn new(method: usize, motion: BoxMotion, boxes: Vec<Aabb>) -> Self {
        Self { method, motion, boxes, trail: VecDeque::new(), errors: Vec::new() }
    }

    fn of(exhibit: &Exhibit, method: usize, step: f64) -> Self {
        Self::new(method, (exhibit.methods[method].1)(step), exhibit.start.clone())
    }

    fn exact(exhibit: &Exhibit, step: f64) -> Self {
        Self::new(exhibit.methods.len(), (exhibit.exact)(step), exhibit.start.clone())
    }

    /// Makes a step; `part` is the one of the scene that it ends in, and `exact` where everything should be then.
    fn step(&mut self, part: usize, exact: &[Aabb]) {
        if self.trail.len() == TRAIL {
            self.trail.pop_front();
        }
        self.trail.push_back(self.boxes.iter().map(Aabb::centre).collect());
        self.boxes = (self.motion)();
        let found = error(&self.boxes, exact);
        // Steps longer than a part leave some without one of their own.
        self.errors.resize(self.errors.len().max(part + 1), found);
        self.errors[part] = worst([self.errors[part], found]);
    }
}

/// The page.
#[derive(Debug)]
pub struct SideBySide {
    exhibits: Vec<Exhibit>,
    exhibit: usize,
    /// Which of the steps that can be chosen.
    step: usize,
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
        let step = STEPS[USUAL_STEP];
        let halves = first_against_shipped(&exhibits[0], step);
        let exact = Runner::exact(&exhibits[0], step);
        Self {
            exhibits,
            exhibit: 0,
            step: USUAL_STEP,
            halves,
            exact,
            steps: 0,
            left_over: 0.0,
            paused: false,
            choices: Buttons::default(),
            toolbar: Toolbar::default(),
        }
    }
}

fn first_against_shipped(exhibit: &Exhibit, step: f64) -> [Runner; 2] {
    [exhibit.first, exhibit.methods.len() - 1].map(|method| Runner::of(exhibit, method, step))
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
            Some(3) => self.single_step(),
            Some(4) => {
                self.step = (self.step + 1) % STEPS.len();
                self.restart([0, 0]);
            }
            Some(5) => self.turn_to(self.exhibit + self.exhibits.len() - 1),
            Some(6) => self.turn_to(self.exhibit + 1),
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
        while self.left_over >= self.step() && !self.is_over() {
            self.left_over -= self.step();
            self.make_step();
        }
    }

    /// One step, and then it stands still.
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

    /// Starts again, each half so many methods further.
    fn restart(&mut self, further: [isize; 2]) {
        let (exhibit, step) = (&self.exhibits[self.exhibit], self.step());
        let methods = exhibit.methods.len();
        let next = |half: usize| self.halves[half].method.saturating_add_signed(further[half] + methods as isize) % methods;
        self.halves = [next(0), next(1)].map(|method| Runner::of(exhibit, method, step));
        self.exact = Runner::exact(exhibit, step);
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
            let Runner { boxes, trail, errors, .. } = runner;
            Half { method, boxes, trail, errors, error: error(boxes, &self.exact.boxes) }
        })
    }

    /// Where everything should be.
    pub fn exact(&self) -> &[Aabb] {
        &self.exact.boxes
    }

    /// The step of both methods, s.
    pub fn step(&self) -> f64 {
        STEPS[self.step]
    }

    /// Of the scene, since the start, s.
    pub fn time(&self) -> f64 {
        f64::from(self.steps) * self.step()
    }

    /// Whether it stands still for a while.
    pub fn is_paused(&self) -> bool {
        self.paused
    }

    /// Whether the scene has ended.
    pub fn is_over(&self) -> bool {
        self.time() + 0.5 * self.step() >= self.exhibit().seconds
    }

    /// Which method runs where: the one before and the next one, of the left half and of the right one.
    pub fn choices(&self) -> &Buttons {
        &self.choices
    }

    /// Its buttons: Back, Restart, Pause, a single step, another step, the scene before, the next one.
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
