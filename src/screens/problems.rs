//! A panel with the lines that say what is wrong with a level.

use super::scroll::{BAR_WIDTH, Scroll, bar_beside};
use super::{Buttons, Input, Key};
use crate::view::layout::{Area, DETAILS, Frame, LINE, MONO_ADVANCE, PADDING, ROW_BUTTON, Vec2};

/// From the canvas' edges to the panel.
const MARGIN: Vec2 = Vec2::new(80.0, 56.0);
/// From the panel's top to its first line.
const HEAD: f32 = 72.0;
/// From its last line to its bottom: the button.
const FOOT: f32 = 3.0 * PADDING + ROW_BUTTON.y;
/// From its left edge to its lines.
const LEFT: f32 = PADDING + 8.0;
/// What its width has beside the lines, for the bar.
const ASIDE: f32 = LEFT + 2.0 * PADDING + BAR_WIDTH;

/// The panel; it can be scrolled where it is long.
#[derive(Debug)]
pub struct Problems {
    heading: String,
    problems: Vec<String>,
    /// The problems as they fit the panel: the text of a line and whether it begins a problem.
    lines: Vec<(String, bool)>,
    frame: Frame,
    panel: Area,
    scroll: Scroll,
    close: Buttons,
}

impl Problems {
    /// A panel with a line a problem.
    pub fn new(heading: String, problems: Vec<String>) -> Self {
        let mut panel = Self {
            heading,
            problems,
            lines: Vec::new(),
            frame: Frame::default(),
            panel: Area::default(),
            scroll: Scroll::default(),
            close: Buttons::default(),
        };
        panel.place(Frame::default());
        panel
    }

    /// One frame; whether the panel is to be closed.
    pub fn update(&mut self, input: &Input) -> bool {
        if self.frame != input.frame {
            self.place(input.frame);
        }
        self.scroll.update(input);
        self.close.update(input).is_some() || input.pressed(Key::Escape)
    }

    /// Whose problems they are.
    pub fn heading(&self) -> &str {
        &self.heading
    }

    /// What is wrong, a line a problem.
    pub fn problems(&self) -> &[String] {
        &self.problems
    }

    fn place(&mut self, frame: Frame) {
        self.frame = frame;
        let (height, widest) = (frame.text_height(DETAILS), frame.size - 2.0 * MARGIN);
        let columns = ((widest.x - ASIDE) / (height * MONO_ADVANCE)).floor().max(1.0) as usize;
        self.lines = self.problems.iter().flat_map(|problem| wrapped(problem, columns)).collect();
        let room = ((widest.y - HEAD - FOOT) / (height * LINE)).floor().max(1.0) as usize;
        let page = self.lines.len().clamp(1, room);
        let size = Vec2::new(widest.x, HEAD + page as f32 * height * LINE + FOOT);
        self.panel = Area::around(frame.size / 2.0, size);
        let panel = self.panel;
        self.scroll.place(self.lines.len(), page, bar_beside(panel, panel.min.y + HEAD, panel.max().y - FOOT));
        let close = Vec2::new(panel.centre().x, panel.max().y - PADDING - ROW_BUTTON.y / 2.0);
        self.close.place(vec![Area::around(close, ROW_BUTTON)]);
    }
}

/// A text in lines of at most `columns` characters, cut between words where it can be; lines after the first are set in.
fn wrapped(text: &str, columns: usize) -> Vec<(String, bool)> {
    const INDENT: &str = "    ";
    let mut lines = Vec::new();
    let mut line = String::new();
    let fits = |line: &str, more: usize| line.chars().count() + more <= columns;
    for word in text.split_inclusive(' ') {
        if !line.trim().is_empty() && !fits(&line, word.trim_end().chars().count()) {
            lines.push(std::mem::replace(&mut line, INDENT.into()));
        }
        for character in word.chars() {
            if !fits(&line, 1) && line.len() > INDENT.len() {
                lines.push(std::mem::replace(&mut line, INDENT.into()));
            }
            line.push(character);
        }
    }
    lines.push(line);
    lines.into_iter().enumerate().map(|(i, line)| (line, i == 0)).collect()
}

#[cfg(feature = "window")]
mod drawing {
    use super::{HEAD, LEFT, Problems};
    use crate::view::canvas::{Canvas, Style};
    use crate::view::layout::{BUTTON_TEXT, DETAILS, PADDING, Vec2};
    use crate::view::{theme, widgets};

    impl Problems {
        /// Draws the panel.
        pub fn draw(&self, canvas: &Canvas) {
            let panel = self.panel;
            widgets::panel(canvas, panel);
            let at = panel.min + Vec2::new(LEFT, PADDING + 20.0);
            canvas.text(&self.heading, at, Style::new(BUTTON_TEXT, theme::bad()).middle());
            let step = canvas.line_height(DETAILS);
            for (row, line) in self.scroll.range().enumerate() {
                let (words, begins) = &self.lines[line];
                let colour = if *begins { theme::text() } else { theme::quiet() };
                let at = panel.min + Vec2::new(LEFT, HEAD + row as f32 * step);
                canvas.text(words, at, Style::new(DETAILS, colour).mono());
            }
            if let Some(bar) = self.scroll.bar() {
                widgets::scroll_bar(canvas, bar.track, bar.handle, bar.held);
            }
            widgets::button(canvas, self.close.areas()[0], "Close", self.close.hover().is_some(), true);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_problems_are_cut_between_words_and_lose_nothing() {
        let text = "world.csv:3: column \"width\": found a-word-that-is-longer-than-the-whole-panel, expected > 0";
        for columns in [20, 30, 200] {
            let lines = wrapped(text, columns);
            assert!(lines.iter().all(|(line, _)| line.trim_end().chars().count() <= columns), "{lines:?}");
            let joined: String = lines.iter().flat_map(|(line, _)| line.chars()).filter(|c| *c != ' ').collect();
            assert_eq!(joined, text.replace(' ', ""));
            assert!(lines[0].1 && lines[1..].iter().all(|(_, begins)| !begins));
        }
    }
}
