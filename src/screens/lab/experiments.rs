//! The experiments: question, numbers to vary and, on request, the exact answer. Enter flies the level.

use super::body;
use crate::draw::layout::{Area, Frame};
use crate::screens::{Buttons, Input, Key, Toolbar};

#[derive(Clone, Debug, Default, PartialEq, Eq, serde::Deserialize)]
pub struct Experiment {
    pub folder: String,
    pub question: String,
    pub vary: String,
    pub answer: String,
    #[serde(skip)]
    pub title: String,
}

/// Height of a line of the list, at most, and the room below the list.
const LINE: f32 = 44.0;
const APART: f32 = 4.0;
/// The list's part of the width.
const LIST: f32 = 0.42;
const KEYS: [Key; 3] = [Key::Escape, Key::Enter, Key::Space];

#[derive(Debug)]
pub struct ExperimentsPage {
    experiments: Vec<Experiment>,
    /// The reason why there are none.
    problem: Option<String>,
    list: Buttons,
    /// The answer of the chosen experiment is shown.
    answered: bool,
    toolbar: Toolbar,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum ExperimentWish {
    Leave,
    Fly(String),
}

impl ExperimentsPage {
    pub(super) fn new(experiments: Result<Vec<Experiment>, String>, left: Option<&str>) -> Self {
        let (experiments, problem) = match experiments {
            Ok(experiments) => (experiments, None),
            Err(problem) => (Vec::new(), Some(problem)),
        };
        let chosen = experiments.iter().position(|experiment| Some(experiment.folder.as_str()) == left).unwrap_or(0);
        Self { experiments, problem, list: Buttons::focused_on(chosen), answered: false, toolbar: Toolbar::default() }
    }

    pub(super) fn update(&mut self, input: &Input) -> Option<ExperimentWish> {
        self.list.place(places(&input.frame, self.experiments.len()));
        let before = self.list.focus();
        let clicked = self.list.update(&Input { pressed: input.pressed.without(Key::Enter), ..input.clone() });
        let pressed = self.toolbar.update(input, &KEYS);
        if let Some(clicked) = clicked {
            // The first click chooses, the second one flies.
            if clicked == before {
                return self.fly();
            }
            self.list.focus_on(clicked);
        }
        self.answered &= self.list.focus() == before;
        match pressed {
            Some(0) => Some(ExperimentWish::Leave),
            Some(1) => self.fly(),
            Some(2) => {
                self.answered = !self.answered;
                None
            }
            Some(_) | None => None,
        }
    }

    fn fly(&self) -> Option<ExperimentWish> {
        self.chosen().map(|experiment| ExperimentWish::Fly(experiment.folder.clone()))
    }

    pub fn experiments(&self) -> &[Experiment] {
        &self.experiments
    }

    pub fn chosen(&self) -> Option<&Experiment> {
        self.experiments.get(self.list.focus())
    }

    /// Hidden at first: a student makes a guess before.
    pub const fn answered(&self) -> bool {
        self.answered
    }

    pub fn problem(&self) -> Option<&str> {
        self.problem.as_deref()
    }

    pub const fn list(&self) -> &Buttons {
        &self.list
    }

    pub const fn toolbar(&self) -> &Toolbar {
        &self.toolbar
    }
}

fn places(frame: &Frame, count: usize) -> Vec<Area> {
    let body = body(frame);
    let pitch = LINE.min(body.size.y / count.max(1) as f32);
    let line = |i: usize| Area::new(body.min.x, body.min.y + i as f32 * pitch, body.size.x * LIST, pitch - APART);
    (0..count).map(line).collect()
}

mod drawing {
    use super::{ExperimentsPage, LIST, body};
    use crate::draw::layout::{Area, BUTTON_TEXT, Frame, PADDING, TEXT, Vec2};
    use crate::draw::{Canvas, Colour, Style};
    use crate::view::{theme, widgets};

    const BETWEEN: f32 = 24.0;

    fn description(frame: &Frame) -> Area {
        let body = body(frame);
        let left = body.size.x * LIST + BETWEEN;
        Area::new(body.min.x + left, body.min.y, body.size.x - left, body.size.y)
    }

    impl ExperimentsPage {
        pub(in crate::screens::lab) fn draw(&self, canvas: &Canvas) {
            for (i, (area, experiment)) in self.list.areas().iter().zip(&self.experiments).enumerate() {
                widgets::button_box(canvas, *area, self.list.hover() == Some(i), self.list.focus() == i);
                let words = format!("{:>2}  {}", i + 1, experiment.title);
                let style = Style::new(TEXT, theme::text()).middle();
                let words = widgets::cut(canvas, &words, area.size.x - 2.0 * PADDING, style);
                canvas.text(&words, Vec2::new(area.min.x + PADDING, area.centre().y), style);
            }
            let panel = description(canvas.frame());
            widgets::panel(canvas, panel);
            let answer = if self.answered { "Hide it" } else { "Answer" };
            self.toolbar.draw(canvas, &[("Back", "Esc"), ("Fly it", "Enter"), (answer, "Space")]);
            let Some(chosen) = self.chosen() else {
                let words = self.problem().unwrap_or("There are no experiments here.");
                return widgets::fitted(canvas, words, panel.centre(), panel.size.x - 2.0 * PADDING, &[TEXT], theme::quiet());
            };
            let mut pen = Pen { canvas, at: panel.min + 1.5 * PADDING, width: panel.size.x - 3.0 * PADDING };
            pen.write(&chosen.title, BUTTON_TEXT, theme::accent());
            pen.write(&chosen.question, BUTTON_TEXT, theme::text());
            pen.write("What to vary, in the editor or in the files", TEXT, theme::quiet());
            pen.write(&chosen.vary, TEXT, theme::text());
            pen.write("Exactly", TEXT, theme::quiet());
            let (words, colour) =
                if self.answered { (chosen.answer.as_str(), theme::good()) } else { ("Make a guess first.", theme::quiet()) };
            pen.write(words, BUTTON_TEXT, colour);
            pen.write(&format!("A page for lessons: docs/lessons/{}.md", chosen.folder), TEXT, theme::quiet());
        }
    }

    struct Pen<'a> {
        canvas: &'a Canvas,
        at: Vec2,
        width: f32,
    }

    impl Pen<'_> {
        fn write(&mut self, words: &str, size: f32, colour: Colour) {
            let style = Style::new(size, colour);
            let mut line = String::new();
            for word in words.split(' ') {
                let longer = if line.is_empty() { word.to_owned() } else { format!("{line} {word}") };
                if self.canvas.width(&longer, style) > self.width && !line.is_empty() {
                    self.end(&line, style, size);
                    line = word.to_owned();
                } else {
                    line = longer;
                }
            }
            self.end(&line, style, size);
            self.at.y += 0.6 * self.canvas.line_height(size);
        }

        fn end(&mut self, line: &str, style: Style, size: f32) {
            self.canvas.text(line, self.at, style);
            self.at.y += self.canvas.line_height(size);
        }
    }
}
