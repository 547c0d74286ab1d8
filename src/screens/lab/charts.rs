//! A work–precision diagram a scene. The player picks out a method or reads a point.

use super::{Shown, body};
use crate::draw::layout::{Area, Frame};
use crate::lab::axes::{number, step};
use crate::lab::charts::Charts;
use crate::lab::course::OverTime;
use crate::lab::measured::Measured;
use crate::screens::{Input, Key, Toolbar};
use crate::view::plot::DiagramPlaces;

/// Back, the scene before, the next one, another method, and the scene over time where it has that.
const KEYS: [Key; 5] = [Key::Escape, Key::Left, Key::Right, Key::Down, Key::Space];
const TITLE: f32 = 40.0;
const WORDS: f32 = 56.0;

#[derive(Debug)]
pub struct ChartsPage {
    shown: Shown,
    scene: usize,
    picked: Option<usize>,
    pointed: Option<usize>,
    /// Its curve and its index.
    point: Option<(usize, usize)>,
    /// The wish for error and energy over time, for the scenes that have them.
    over_time: bool,
    toolbar: Toolbar,
}

impl ChartsPage {
    pub(super) fn new(shown: Shown) -> Self {
        Self { shown, scene: 0, picked: None, pointed: None, point: None, over_time: false, toolbar: Toolbar::default() }
    }

    /// True where the player leaves the lab.
    pub(super) fn update(&mut self, input: &Input) -> bool {
        let followed = self.measured().is_some_and(|measured| measured.over_time.is_some());
        let pressed = self.toolbar.update(input, &KEYS[..if followed { 5 } else { 4 }]);
        let scenes = self.shown.charts.diagrams.len();
        match pressed {
            Some(0) => return true,
            Some(1) => self.turn_to(self.scene + scenes.saturating_sub(1)),
            Some(2) => self.turn_to(self.scene + 1),
            Some(3) => self.pick(1),
            Some(4) => self.over_time = !self.over_time,
            Some(_) | None => {}
        }
        for (key, scene) in [(Key::Home, 0), (Key::End, scenes.saturating_sub(1))] {
            if input.pressed(key) {
                self.turn_to(scene);
            }
        }
        if input.pressed(Key::Up) {
            self.pick(-1);
        }
        (self.pointed, self.point) = (None, None);
        if let Some((measured, plot)) = self.measured().zip(self.plot(&input.frame)) {
            let pointed = (0..measured.curves.len()).find(|line| plot.legend(*line).contains(input.pointer));
            let point = if self.over_time().is_some() { None } else { plot.point_near(measured, input.pointer) };
            (self.pointed, self.point) = (pointed, point);
        }
        if input.click && self.pointed.is_some() {
            self.picked = if self.picked == self.pointed { None } else { self.pointed };
        }
        false
    }

    pub fn charts(&self) -> &Charts {
        &self.shown.charts
    }

    /// The reason why these are not the player's own charts, or why there are none.
    pub fn problem(&self) -> Option<&str> {
        self.shown.problem.as_deref()
    }

    pub fn measured(&self) -> Option<&Measured> {
        self.shown.charts.diagrams.get(self.scene)
    }

    /// Where they are shown instead.
    pub fn over_time(&self) -> Option<&OverTime> {
        self.measured()?.over_time.as_ref().filter(|_| self.over_time)
    }

    pub fn scene(&self) -> usize {
        self.scene
    }

    /// The curve of the legend's line under the pointer, or else the chosen one.
    pub fn picked(&self) -> Option<usize> {
        self.pointed.or(self.picked)
    }

    /// Its curve and its index.
    pub fn point(&self) -> Option<(usize, usize)> {
        self.point
    }

    pub fn plot(&self, frame: &Frame) -> Option<DiagramPlaces> {
        Some(DiagramPlaces::of(panel(frame), self.measured()?))
    }

    pub fn verdict(&self) -> Option<String> {
        let measured = self.measured()?;
        if self.over_time().is_some() {
            return Some(
                "Each point is the worst since the one before. A method that ends near the truth may have been far from it.".into(),
            );
        }
        let shipped = measured.shipped_point()?;
        let mut words = format!("As shipped: error {}, {} ns.", number(shipped.error), number(shipped.work));
        if let Some((curve, point)) = measured.cheapest() {
            let costs = shipped.work / point.work;
            let cheapest = format!("{} at {}, {} ns", curve.name, step(point.step), number(point.work));
            words += &format!("  Cheapest within the tolerance: {cheapest}; the shipped point costs {} times that.", number(costs));
        }
        Some(words)
    }

    pub fn source(&self) -> String {
        let setting = &self.shown.charts.setting;
        let commit = setting.commit.as_ref().map_or(String::new(), |commit| format!(", commit {commit}"));
        let runs = if setting.quick { "few runs a point" } else { "medians" };
        let whose = if self.shown.kept {
            "Came with the game: run “resultant chart” to measure here."
        } else {
            "From the last run of “resultant chart” here."
        };
        format!("Measured on {}{commit}, {} build, {runs}. {whose}", setting.machine, setting.profile)
    }

    pub fn toolbar(&self) -> &Toolbar {
        &self.toolbar
    }

    fn turn_to(&mut self, scene: usize) {
        self.scene = scene.checked_rem(self.shown.charts.diagrams.len()).unwrap_or(0);
        self.picked = None;
    }

    /// Cycles through the curves and through none of them.
    fn pick(&mut self, by: isize) {
        let curves = self.measured().map_or(0, |measured| measured.curves.len());
        // No curve stands before the first and after the last.
        let places = curves as isize + 1;
        let place = self.picked.map_or(0, |curve| curve as isize + 1);
        self.picked = usize::try_from((place + by).rem_euclid(places) - 1).ok();
    }
}

fn panel(frame: &Frame) -> Area {
    let body = body(frame);
    Area::new(body.min.x, body.min.y + TITLE, body.size.x, body.size.y - TITLE - WORDS)
}

mod drawing {
    use super::{ChartsPage, panel};
    use crate::draw::layout::{BUTTON_TEXT, DETAILS, TEXT, Vec2};
    use crate::draw::{Canvas, Style};
    use crate::view::diagram::{self, Picked};
    use crate::view::timeline;
    use crate::view::{theme, widgets};

    impl ChartsPage {
        pub(in crate::screens::lab) fn draw(&self, canvas: &Canvas) {
            let panel = panel(canvas.frame());
            let (middle, widest) = (panel.centre().x, panel.size.x);
            let scenes = self.charts().diagrams.len();
            let other = if self.over_time().is_some() { "At the end" } else { "Over time" };
            let labels = [("Back", "Esc"), ("Previous", "←"), ("Next", "→"), ("Method", "↓"), (other, "Space")];
            self.toolbar.draw(canvas, &labels);
            let foot = panel.max().y;
            if let Some(problem) = self.problem() {
                widgets::fitted(canvas, problem, Vec2::new(middle, foot + 42.0), widest, &[TEXT, DETAILS], theme::bad());
            }
            let (Some(measured), Some(plot)) = (self.measured(), self.plot(canvas.frame())) else {
                widgets::panel(canvas, panel);
                canvas.text("There are no charts to show.", panel.centre(), Style::new(TEXT, theme::quiet()).centred().middle());
                return;
            };
            let title = Vec2::new(middle, panel.min.y - 20.0);
            widgets::fitted(canvas, &measured.title, title, widest - 240.0, &[BUTTON_TEXT, TEXT], theme::text());
            let count = format!("{} of {scenes}", self.scene + 1);
            let style = Style::new(TEXT, theme::quiet()).mono().middle();
            canvas.text(&count, Vec2::new(panel.max().x, title.y), style.right());
            if let Some(verdict) = self.verdict() {
                widgets::fitted(canvas, &verdict, Vec2::new(middle, foot + 18.0), widest, &[TEXT, DETAILS], theme::text());
            }
            if self.problem().is_none() {
                widgets::fitted(canvas, &self.source(), Vec2::new(middle, foot + 42.0), widest, &[DETAILS], theme::quiet());
            }
            let picked = Picked { curve: self.picked(), point: self.point() };
            match self.over_time() {
                Some(over_time) => timeline::draw(canvas, &plot, (measured, over_time), picked.curve),
                None => diagram::draw(canvas, &plot, measured, picked),
            }
        }
    }
}
