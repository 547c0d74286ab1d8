//! The notice of a level whose files have changed since they were read.

use crate::draw::layout::{Area, DETAILS, Frame, LINE, MONO_ADVANCE, PADDING, TEXT, Vec2, wrapped};
use crate::draw::{Canvas, Style};
use crate::view::{theme, widgets};
use crate::words::tr;

/// The state of a level's files while the level is flown.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum News {
    /// They were read again: age of the notice, s, and whether the flight goes on where it was.
    Changed(f64, bool),
    /// They do not load; a line a problem.
    Broken(Vec<String>),
    /// They are edited, and flown as far as they go; a line a problem.
    Unfinished(Vec<String>),
}

/// The most problems in the notice.
const LISTED: usize = 6;
/// Width of the box with time and speed, which stands at the left.
const BESIDE: f32 = 290.0;
/// Width of a notice without problems.
const NARROW: f32 = 560.0;

impl News {
    /// The place of the notice at the canvas' top, and the lines of its problems.
    pub fn layout(&self, frame: &Frame) -> (Area, Vec<String>) {
        let problems: &[String] = match self {
            Self::Changed(..) => &[],
            Self::Unfinished(problems) | Self::Broken(problems) => problems,
        };
        // The box grows with the text.
        let left = 16.0 + BESIDE * frame.text.max(1.0);
        let room = frame.size.x - left - PADDING;
        let width = if problems.is_empty() { room.min(NARROW) } else { room };
        let columns = ((width - 2.0 * PADDING) / (frame.text_height(DETAILS) * MONO_ADVANCE)) as usize;
        let mut lines: Vec<String> = problems.iter().take(LISTED).flat_map(|problem| wrapped(problem, columns, 4)).collect();
        let more = problems.len().saturating_sub(LISTED);
        if more > 0 {
            lines.push(tr!("and {more} more", more));
        }
        let [text, line] = [TEXT, DETAILS].map(|size| frame.text_height(size) * LINE);
        (Area::new(left, PADDING, width, text + 1.5 * PADDING + lines.len() as f32 * line), lines)
    }

    pub fn draw(&self, canvas: &Canvas) {
        let (words, colour) = match self {
            Self::Changed(_, true) => (tr("Read again: you fly on in it, with help. R restarts it."), theme::good()),
            Self::Changed(_, false) => (tr("Read again, from its start."), theme::good()),
            Self::Unfinished(_) => (tr("Flown as far as it goes. What is left:"), theme::accent()),
            Self::Broken(_) => (tr("The files do not load now: you fly on in what was there."), theme::bad()),
        };
        let (panel, lines) = self.layout(canvas.frame());
        canvas.end_layer();
        widgets::panel_in(canvas, panel, theme::panel().faded(0.95), colour);
        let top = panel.min + Vec2::new(PADDING, 0.75 * PADDING);
        canvas.text(words, top, Style::new(TEXT, colour));
        for (i, words) in lines.iter().enumerate() {
            let at = top + Vec2::new(0.0, canvas.line_height(TEXT) + i as f32 * canvas.line_height(DETAILS));
            canvas.text(words, at, Style::new(DETAILS, theme::text()).mono());
        }
    }
}
