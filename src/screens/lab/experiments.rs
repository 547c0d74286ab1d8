//! The experiments: question and numbers to vary. Enter flies the level, whose sheet has the answer.

use super::BACK;
use crate::draw::layout::{Area, BUTTON_TEXT, PADDING, TEXT, Vec2};
use crate::draw::{Canvas, Colour, Style};
use crate::ui::{Touch, Ui, WidgetKind};
use crate::{screens::screen::Destination, screens::screen::Request, session::library::Experiment, view::theme, view::widgets};
use crate::{settings::Key, words::tr};

/// Height of a line of the list, at most, and the room below the line.
const LINE: f32 = 44.0;
const APART: f32 = 4.0;
/// The list's part of the width.
const LIST: f32 = 0.42;
/// Between the list and the description.
const BETWEEN: f32 = 24.0;

#[derive(Debug)]
pub struct ExperimentsPage {
    experiments: Vec<Experiment>,
    /// The reason why there are none.
    problem: Option<String>,
    /// The index of the line with the focus.
    chosen: usize,
}

impl ExperimentsPage {
    pub(super) fn new(experiments: Result<Vec<Experiment>, String>, left: Option<&str>) -> Self {
        let (experiments, problem) = match experiments {
            Ok(experiments) => (experiments, None),
            Err(problem) => (Vec::new(), Some(problem)),
        };
        let chosen = experiments.iter().position(|experiment| Some(experiment.folder.as_str()) == left).unwrap_or(0);
        Self { experiments, problem, chosen }
    }

    pub(super) fn title_of(&self, folder: &str) -> Option<&str> {
        self.experiments.iter().find(|experiment| experiment.folder == folder).map(|experiment| experiment.title.as_str())
    }

    pub(super) fn show(&mut self, ui: &mut Ui<'_>, body: Area) -> Option<Request> {
        let flies = self.show_list(ui, body);
        let tool = ui.tools(&[BACK, ("Fly it", Key::Enter, "Enter")]);
        if tool == Some("Back") {
            return Some(Request::Pop);
        }
        let left = body.size.x * LIST + BETWEEN;
        let panel = Area::new(body.min.x + left, body.min.y, body.size.x - left, body.size.y);
        ui.panel(panel);
        let Some(chosen) = self.experiments.get(self.chosen) else {
            let words = self.problem.as_deref().unwrap_or(tr("There are no experiments here."));
            widgets::fitted(ui.canvas(), words, panel.centre(), panel.size.x - 2.0 * PADDING, &[TEXT], theme::quiet());
            return None;
        };
        draw_description(ui.canvas(), panel, chosen);
        (flies || tool == Some("Fly it")).then(|| Request::Reset(Destination::Experiment(chosen.folder.clone())))
    }

    /// Whether the chosen experiment is flown: a click on another line chooses it first.
    fn show_list(&mut self, ui: &mut Ui<'_>, body: Area) -> bool {
        let pitch = LINE.min(body.size.y / self.experiments.len().max(1) as f32);
        let before = self.chosen;
        let mut flies = false;
        for (i, experiment) in self.experiments.iter().enumerate() {
            let area = Area::new(body.min.x, body.min.y + i as f32 * pitch, body.size.x * LIST, pitch - APART);
            let Touch { hover, focus, pressed } = ui.touch(&experiment.title, area, WidgetKind::Button);
            widgets::button_box(ui.canvas(), area, hover, focus);
            let words = format!("{:>2}  {}", i + 1, tr(&experiment.title));
            let style = Style::new(TEXT, theme::text()).middle();
            let words = widgets::cut(ui.canvas(), &words, area.size.x - 2.0 * PADDING, style);
            ui.text(&words, Vec2::new(area.min.x + PADDING, area.centre().y), style);
            flies |= pressed && i == before;
            if focus {
                self.chosen = i;
            }
        }
        if let Some(chosen) = self.experiments.get(self.chosen) {
            ui.start_at(&chosen.title);
        }
        flies
    }
}

fn draw_description(canvas: &Canvas, panel: Area, chosen: &Experiment) {
    let mut pen = Paragraphs { canvas, at: panel.min + 1.5 * PADDING, width: panel.size.x - 3.0 * PADDING };
    pen.write(tr(&chosen.title), BUTTON_TEXT, theme::accent());
    pen.write(tr(&chosen.question), BUTTON_TEXT, theme::text());
    pen.write(tr("Numbers to vary, in the editor or in the files"), TEXT, theme::quiet());
    pen.write(tr(&chosen.vary), TEXT, theme::text());
    pen.write(
        tr("The sheet stands beside the flight: make a prediction, let it go, read, and the answer comes last."),
        TEXT,
        theme::quiet(),
    );
    pen.write(&tr!("A page to print: docs/sheets/{folder}.html", folder = chosen.folder), TEXT, theme::quiet());
}

/// Paragraphs below each other.
pub(in crate::screens) struct Paragraphs<'a> {
    pub canvas: &'a Canvas,
    /// The upper left corner of the next one.
    pub at: Vec2,
    pub width: f32,
}

impl Paragraphs<'_> {
    /// How far a paragraph leads down; one without words not at all.
    pub fn height(&self, words: &str, size: f32) -> f32 {
        let lines = widgets::lines(self.canvas, words, self.width, Style::new(size, theme::text())).len();
        if words.is_empty() { 0.0 } else { (lines as f32 + 0.6) * self.canvas.line_height(size) }
    }

    pub fn write(&mut self, words: &str, size: f32, colour: Colour) {
        if words.is_empty() {
            return;
        }
        let style = Style::new(size, colour);
        for line in widgets::lines(self.canvas, words, self.width, style) {
            self.canvas.text(&line, self.at, style);
            self.at.y += self.canvas.line_height(size);
        }
        self.at.y += 0.6 * self.canvas.line_height(size);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_prediction_is_judged_by_a_choice_or_a_number() {
        let free = Experiment::default();
        let number = Experiment { right: "50".to_owned(), ..free.clone() };
        let choice = Experiment { choices: vec!["one".to_owned(), "both".to_owned()], right: "both".to_owned(), ..free.clone() };
        assert_eq!(["", "50"].map(|text| free.judge_prediction(text)), [None; 2]);
        let judged = ["52,4", "47.5", "47", "-50", "hard"].map(|text| number.judge_prediction(text));
        assert_eq!(judged, [Some(true), Some(true), Some(false), Some(false), None]);
        assert_eq!(["both", "one", "50"].map(|text| choice.judge_prediction(text)), [Some(true), Some(false), None]);
    }
}
