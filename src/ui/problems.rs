//! A panel with a level's problems.

use crate::draw::Style;
use crate::draw::layout::{Area, BUTTON_TEXT, DETAILS, LINE, MONO_ADVANCE, PADDING, ROW_BUTTON, Vec2, wrapped};
use crate::settings::Key;
use crate::ui::scroll::{BAR_WIDTH, bar_beside};
use crate::ui::{Turning, Ui};
use crate::view::theme;

/// From the canvas' edges to the panel, canvas units, as all lengths here.
const MARGIN: Vec2 = Vec2::new(80.0, 56.0);
/// From the panel's top to its first line.
const HEAD: f32 = 72.0;
/// From its last line to its bottom: the button.
const FOOT: f32 = 3.0 * PADDING + ROW_BUTTON.y;
/// From its left edge to its lines.
const LEFT: f32 = PADDING + 8.0;
/// The part of its width beside the lines, with the scroll bar.
const ASIDE: f32 = LEFT + 2.0 * PADDING + BAR_WIDTH;

/// How far the further lines of a problem are set in, characters.
const INDENT: usize = 4;

/// The panel; it scrolls where it is long.
#[derive(Debug)]
pub struct Problems {
    heading: String,
    problems: Vec<String>,
}

impl Problems {
    /// A panel with a paragraph a problem.
    pub fn new(heading: String, problems: Vec<String>) -> Self {
        Self { heading, problems }
    }

    /// Shows the panel above all else; whether it is to be closed.
    pub fn show(&self, ui: &mut Ui<'_>) -> bool {
        self.answer(ui, &["Close"]).is_some() || ui.key(Key::Escape)
    }

    /// Shows the panel above all else, with these buttons; the one that is pressed.
    pub fn answer(&self, ui: &mut Ui<'_>, answers: &[&'static str]) -> Option<&'static str> {
        let frame = ui.frame();
        let (height, widest) = (frame.text_height(DETAILS), frame.size - 2.0 * MARGIN);
        let columns = ((widest.x - ASIDE) / (height * MONO_ADVANCE)).floor().max(1.0) as usize;
        // A line, and whether it begins a problem.
        let cut = |problem: &String| wrapped(problem, columns, INDENT).into_iter().enumerate().map(|(i, line)| (line, i == 0));
        let lines: Vec<(String, bool)> = self.problems.iter().flat_map(cut).collect();
        let room = ((widest.y - HEAD - FOOT) / (height * LINE)).floor().max(1.0) as usize;
        let page = lines.len().clamp(1, room);
        let panel = Area::around(frame.size / 2.0, Vec2::new(widest.x, HEAD + page as f32 * height * LINE + FOOT));
        ui.layer(0.7);
        ui.panel(panel);
        let at = panel.min + Vec2::new(LEFT, PADDING + 20.0);
        ui.text(&self.heading, at, Style::new(BUTTON_TEXT, theme::bad()).middle());
        let bar = bar_beside(panel, panel.min.y + HEAD, panel.max().y - FOOT);
        let shown = ui.scroll(&self.heading, (lines.len(), page), bar, Turning::Lines);
        for (row, (words, begins)) in lines[shown].iter().enumerate() {
            let colour = if *begins { theme::text() } else { theme::quiet() };
            let at = panel.min + Vec2::new(LEFT, HEAD + row as f32 * height * LINE);
            ui.text(words, at, Style::new(DETAILS, colour).mono());
        }
        ui.buttons(frame.row(answers.len(), panel.max().y - PADDING - ROW_BUTTON.y), answers)
    }
}
