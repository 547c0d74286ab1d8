//! What each method survives: the table of the stress tests.

use super::body;
use crate::lab::stress::Survival;
use crate::screens::scroll::{Bar, Scroll, bar_beside};
use crate::screens::{Input, Key, Toolbar};
use crate::view::layout::{Area, Frame};

/// Height of a line.
const ROW: f32 = 32.0;
/// Widest that the table gets.
const WIDEST: f32 = 1000.0;
/// From the panel's top and foot to the lines.
const PADDING: f32 = 8.0;
/// From the body's top to the panel: what the table says.
const WORDS: f32 = 40.0;

/// A line of the table.
#[derive(Clone, Debug, PartialEq)]
pub enum Line {
    /// A test, and what is made larger in it, with its unit.
    Test(String, String),
    /// What a method survives.
    Method(Survival),
}

/// The page.
#[derive(Debug)]
pub struct SurvivalPage {
    lines: Vec<Line>,
    scroll: Scroll,
    toolbar: Toolbar,
}

impl SurvivalPage {
    pub(super) fn new(stress: &[Survival]) -> Self {
        let tests = stress.chunk_by(|a, b| a.test == b.test);
        let lines = tests.flat_map(|rows| {
            let head = Line::Test(rows[0].test.clone(), rows[0].parameter.clone());
            std::iter::once(head).chain(rows.iter().cloned().map(Line::Method))
        });
        Self { lines: lines.collect(), scroll: Scroll::default(), toolbar: Toolbar::default() }
    }

    /// One frame; whether the lab is left.
    pub(super) fn update(&mut self, input: &Input) -> bool {
        let panel = panel(&input.frame);
        let page = page(panel);
        let rows = panel.min.y + PADDING;
        self.scroll.place(self.lines.len(), page, bar_beside(panel, rows, rows + page as f32 * ROW));
        self.scroll.update(input);
        self.toolbar.update(input, &[Key::Escape]).is_some()
    }

    /// All lines.
    pub fn lines(&self) -> &[Line] {
        &self.lines
    }

    /// Those in view.
    pub fn range(&self) -> std::ops::Range<usize> {
        self.scroll.range()
    }

    /// The scroll bar, where not all lines are in view.
    pub fn bar(&self) -> Option<Bar> {
        self.scroll.bar()
    }

    /// Its button: Back.
    pub fn toolbar(&self) -> &Toolbar {
        &self.toolbar
    }
}

/// What the table lies on: as high as its lines.
fn panel(frame: &Frame) -> Area {
    let body = body(frame);
    let width = body.size.x.min(WIDEST);
    let room = Area::new(body.centre().x - width / 2.0, body.min.y + WORDS, width, body.size.y - WORDS);
    Area::new(room.min.x, room.min.y, width, page(room) as f32 * ROW + 2.0 * PADDING)
}

/// Lines that a panel holds.
fn page(panel: Area) -> usize {
    ((panel.size.y - 2.0 * PADDING) / ROW).floor() as usize
}

#[cfg(feature = "window")]
mod drawing {
    use super::{Line, PADDING, ROW, SurvivalPage, panel};
    use crate::lab::stress::Survival;
    use crate::view::canvas::{Canvas, Style};
    use crate::view::layout::{Area, TEXT, Vec2};
    use crate::view::{theme, widgets};

    /// From the panel's left edge to tests and to methods, and from its right edge to the values.
    const COLUMNS: [f32; 3] = [24.0, 56.0, 48.0];

    impl SurvivalPage {
        /// Draws the table and the button.
        pub(in crate::screens::lab) fn draw(&self, canvas: &Canvas) {
            let panel = panel(canvas.frame());
            let quiet = Style::new(TEXT, theme::quiet()).middle();
            let words = "The largest value that each method survives; ≥: all that was tried, 0: nothing.";
            canvas.text(words, Vec2::new(panel.centre().x, panel.min.y - 20.0), quiet.centred());
            widgets::panel(canvas, panel);
            self.toolbar.draw(canvas, &[("Back", "Esc")]);
            if self.lines.is_empty() {
                canvas.text("There are no stress tests to show.", panel.centre(), quiet.centred());
            }
            for (place, index) in self.scroll.range().enumerate() {
                let top = panel.min.y + PADDING + place as f32 * ROW;
                let at = |x: f32| Vec2::new(x, top + ROW / 2.0);
                let (left, right) = (panel.min.x, panel.max().x - COLUMNS[2]);
                match &self.lines[index] {
                    Line::Test(test, parameter) => {
                        if place > 0 {
                            let (from, to) = (Vec2::new(left + COLUMNS[0], top), Vec2::new(right, top));
                            canvas.hairline(from, to, theme::panel_edge());
                        }
                        canvas.text(test, at(left + COLUMNS[0]), Style::new(TEXT, theme::text()).middle());
                        canvas.text(parameter, at(right), quiet.right());
                    }
                    Line::Method(row) => {
                        if row.shipped {
                            let area = Area::new(left + COLUMNS[0], top + 2.0, right - left - COLUMNS[0] + 8.0, ROW - 4.0);
                            canvas.rounded(area, 6.0, theme::panel_hover());
                        }
                        let name = if row.shipped { theme::accent() } else { theme::quiet() };
                        canvas.text(&row.method, at(left + COLUMNS[1]), Style::new(TEXT, name).middle());
                        canvas.text(&row.shown(), at(right), Style::new(TEXT, colour(row)).middle().right());
                    }
                }
            }
            if let Some(bar) = self.scroll.bar() {
                widgets::scroll_bar(canvas, bar.track, bar.handle, bar.held);
            }
        }
    }

    fn colour(row: &Survival) -> macroquad::color::Color {
        match row.largest {
            largest if largest >= row.tried => theme::good(),
            0.0 => theme::bad(),
            _ => theme::text(),
        }
    }
}
