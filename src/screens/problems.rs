//! A panel with the lines that say what is wrong with a level.

use super::scroll::{BAR_WIDTH, Scroll, bar_beside};
use super::{Buttons, Input, Key};
use crate::view::layout::{Area, DETAILS, Frame, LINE, MONO_ADVANCE, PADDING, ROW_BUTTON, Vec2, wrapped};

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

/// How far the further lines of a problem are set in, characters.
const INDENT: usize = 4;

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
        let lines = |problem: &String| wrapped(problem, columns, INDENT).into_iter().enumerate().map(|(i, line)| (line, i == 0));
        self.lines = self.problems.iter().flat_map(lines).collect();
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

mod drawing {
    use super::{HEAD, LEFT, Problems};
    use crate::draw::{Canvas, Style};
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
