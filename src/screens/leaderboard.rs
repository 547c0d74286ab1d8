//! The best of one level.

use super::scroll::{Bar, Scroll, bar_beside};
use super::{Buttons, Classic, Input, Key, Purpose, Request};
use crate::classics::jumper::scene::LEADERBOARD;
use crate::scores::{Board, Name};
use crate::view::layout::{Area, Frame, ROW_BUTTON, Vec2};

/// Rows a page.
pub const PAGE: usize = 10;
/// Height of a row.
const ROW: f32 = 40.0;
/// Width of the panel.
const WIDTH: f32 = 720.0;
/// From the panel's top to the first row: the columns' names.
const HEAD: f32 = 48.0;
/// From the canvas' top to the panel.
const TOP: f32 = 136.0;

/// What a leaderboard is of, in words.
pub fn subject(board: &str) -> String {
    if board == LEADERBOARD { "the Jumper".to_owned() } else { format!("level {board}") }
}

/// The leaderboard screen.
#[derive(Debug)]
pub struct Leaderboard {
    level: String,
    board: Board,
    /// The row just saved.
    saved: Option<usize>,
    /// What is wrong with the scores file.
    damage: Option<String>,
    /// What became of the score, where it is not plain to see.
    remark: Option<String>,
    scroll: Scroll,
    back: Buttons,
}

impl Leaderboard {
    /// The board of a level; `saved` is whose row was just saved, if one was.
    pub fn new(level: &str, board: Board, saved: Option<&Name>, damage: Option<String>, remark: Option<String>) -> Self {
        let saved = saved.and_then(|name| board.rank(name)).map(|rank| rank - 1);
        let mut screen =
            Self { level: level.to_owned(), board, saved, damage, remark, scroll: Scroll::default(), back: Buttons::default() };
        screen.place(&Frame::default());
        if let Some(row) = saved {
            screen.scroll.show(row);
        }
        screen
    }

    /// One frame.
    pub fn update(&mut self, input: &Input) -> Option<Request> {
        self.place(&input.frame);
        self.scroll.update(input);
        let back = match (self.level == LEADERBOARD, self.saved) {
            (true, _) => Request::Classic(Classic::Jumper),
            // Whoever has just saved has come to the end of the way.
            (false, Some(_)) => Request::Menu,
            (false, None) => Request::LevelSelect(Purpose::Leaderboard),
        };
        (self.back.update(input).is_some() || input.pressed(Key::Escape)).then_some(back)
    }

    /// The level whose board it is.
    pub fn level(&self) -> &str {
        &self.level
    }

    /// All rows.
    pub fn board(&self) -> &Board {
        &self.board
    }

    /// The rows in view.
    pub fn range(&self) -> std::ops::Range<usize> {
        self.scroll.range()
    }

    /// The index of the row just saved.
    pub fn saved(&self) -> Option<usize> {
        self.saved
    }

    /// What is wrong with the scores file.
    pub fn damage(&self) -> Option<&str> {
        self.damage.as_deref()
    }

    /// What became of the score, where it is not plain to see.
    pub fn remark(&self) -> Option<&str> {
        self.remark.as_deref()
    }

    /// The scroll bar, where not all rows are in view.
    pub fn bar(&self) -> Option<Bar> {
        self.scroll.bar()
    }

    /// Its button: Back.
    pub fn buttons(&self) -> &Buttons {
        &self.back
    }

    fn place(&mut self, frame: &Frame) {
        let panel = panel(frame);
        let rows = panel.min.y + HEAD;
        self.scroll.place(self.board.rows().len(), PAGE, bar_beside(panel, rows, rows + PAGE as f32 * ROW));
        self.back.place(frame.row(1, frame.size.y - ROW_BUTTON.y - 32.0));
    }
}

fn panel(frame: &Frame) -> Area {
    let top = TOP + (frame.size.y - 720.0) / 2.0;
    Area { min: Vec2::new((frame.size.x - WIDTH) / 2.0, top), size: Vec2::new(WIDTH, HEAD + PAGE as f32 * ROW + 16.0) }
}

#[cfg(feature = "window")]
mod drawing {
    use super::{HEAD, LEADERBOARD, Leaderboard, PAGE, ROW, panel, subject};
    use crate::view::canvas::{Canvas, Style};
    use crate::view::layout::{Area, TEXT, Vec2};
    use crate::view::{theme, widgets};

    /// Where the columns stand, from the panel's left edge: rank (its right end), name, score (its right end).
    const COLUMNS: [f32; 3] = [96.0, 144.0, 664.0];

    impl Leaderboard {
        /// Draws the board.
        pub fn draw(&self, canvas: &Canvas) {
            widgets::graph_paper(canvas);
            let panel = panel(canvas.frame());
            widgets::heading(canvas, &format!("Leaderboard of {}", subject(&self.level)), panel.min.y - 72.0);
            widgets::panel(canvas, panel);
            let quiet = Style::new(TEXT, theme::QUIET).middle();
            let middle = canvas.size().x / 2.0;
            let message = Vec2::new(middle, panel.min.y - 24.0);
            if let Some(damage) = &self.damage {
                widgets::fitted(canvas, damage, message, canvas.size().x - 64.0, &[TEXT], theme::BAD);
            } else if let Some(remark) = &self.remark {
                canvas.text(remark, message, quiet.centred());
            }
            if self.board.rows().is_empty() {
                canvas.text("No scores yet. Be the first!", panel.centre(), quiet.centred());
            } else {
                self.draw_rows(canvas, panel, quiet);
            }
            if let Some(area) = self.back.areas().first() {
                let label = if self.saved.is_some() && self.level != LEADERBOARD { "Main Menu" } else { "Back" };
                widgets::button(canvas, *area, label, self.back.hover().is_some(), true);
            }
        }

        fn draw_rows(&self, canvas: &Canvas, panel: Area, quiet: Style) {
            let column = |i: usize, y: f32| Vec2::new(panel.min.x + COLUMNS[i], y);
            let head = panel.min.y + HEAD / 2.0 + 2.0;
            canvas.text("Rank", column(0, head), quiet.right());
            canvas.text("Name", column(1, head), quiet);
            canvas.text("Score", column(2, head), quiet.right());
            for (line, index) in self.scroll.range().enumerate() {
                let row = &self.board.rows()[index];
                let top = panel.min.y + HEAD + line as f32 * ROW;
                let y = top + ROW / 2.0;
                if self.saved == Some(index) {
                    let area = Area::new(panel.min.x + 16.0, top + 2.0, 664.0, ROW - 4.0);
                    canvas.rounded(area, 6.0, theme::PANEL_HOVER);
                    canvas.rounded_edge(area, 6.0, 2.0, theme::ACCENT);
                }
                let colour = if index == 0 { theme::PLAYER_OBJECTIVE } else { theme::TEXT };
                let style = Style::new(TEXT, colour).mono().middle();
                canvas.text(&(index + 1).to_string(), column(0, y), style.right());
                canvas.text(row.name.as_str(), column(1, y), style);
                canvas.text(&row.score.to_string(), column(2, y), style.right());
            }
            if let Some(bar) = self.scroll.bar() {
                widgets::scroll_bar(canvas, bar.track, bar.handle, bar.held);
            }
            let rows = self.board.rows().len();
            if rows > PAGE {
                let range = self.scroll.range();
                let text = format!("{}–{} of {rows}", range.start + 1, range.end);
                canvas.text(&text, Vec2::new(panel.max().x - 16.0, panel.max().y + 24.0), quiet.right());
            }
        }
    }
}
