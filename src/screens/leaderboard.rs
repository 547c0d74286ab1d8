//! The best of one level.

use super::scroll::{Bar, Scroll, bar_beside};
use super::{Buttons, Input, Key, Prover, Request};
use crate::game::Medals;
use crate::scores::{Board, Name, Standing};
use crate::view::layout::{Area, Frame, Vec2};

/// Rows a page.
pub const PAGE: usize = 10;
/// Height of a row.
const ROW: f32 = 40.0;
/// Width of the panel.
const WIDTH: f32 = 880.0;
/// From the panel's top to the first row: the columns' names.
const HEAD: f32 = 48.0;
/// From the canvas' top to the panel.
const TOP: f32 = 120.0;
/// From the panel down to the buttons.
const FOOT: f32 = 44.0;

/// What the leaderboard of a level is of, in words: the level's title, where it has one.
pub fn subject(level: &str, title: &str) -> String {
    if level == title { format!("level {level}") } else { title.to_owned() }
}

/// A button, and where it leads.
#[derive(Clone, Debug)]
pub struct Way {
    /// The words on it.
    pub label: &'static str,
    /// Where it leads.
    pub to: Request,
}

/// A score that was just saved.
#[derive(Debug)]
pub struct Fresh {
    /// Whose.
    pub name: Name,
    /// What became of it, where that is not plain to see.
    pub remark: Option<String>,
}

/// The leaderboard screen.
#[derive(Debug)]
pub struct Leaderboard {
    subject: String,
    board: Board,
    /// What the level has brought each of them, row by row; none where that is not known.
    medals: Vec<Medals>,
    /// What finds out which rows are earned; the jumper has none.
    prover: Option<Prover>,
    /// The row just saved.
    saved: Option<usize>,
    /// What is wrong with the scores file.
    damage: Option<String>,
    /// What became of the score, where it is not plain to see.
    remark: Option<String>,
    scroll: Scroll,
    /// Where its buttons lead; the last one is the way back.
    ways: Vec<Way>,
    buttons: Buttons,
}

impl Leaderboard {
    /// A board of that subject; `fresh` is what was just saved, and `ways` are its buttons, of which there is one at least.
    pub fn new(subject: String, board: Board, fresh: Option<Fresh>, damage: Option<String>, ways: Vec<Way>) -> Self {
        let saved = fresh.as_ref().and_then(|fresh| board.rank(&fresh.name)).map(|rank| rank - 1);
        let remark = fresh.and_then(|fresh| fresh.remark);
        let (scroll, buttons) = (Scroll::of_pages(), Buttons::default());
        let mut screen = Self { subject, board, medals: Vec::new(), prover: None, saved, damage, remark, scroll, ways, buttons };
        screen.place(&Frame::default());
        if let Some(row) = saved {
            screen.scroll.show(row);
        }
        screen
    }

    /// The same with what the level has brought each of them, row by row.
    #[must_use]
    pub fn with_medals(self, medals: Vec<Medals>) -> Self {
        Self { medals, ..self }
    }

    /// The same with word of so many other versions of the level that have boards of their own.
    #[must_use]
    pub fn with_other_versions(mut self, others: usize) -> Self {
        if others > 0 {
            let boards = if others == 1 { "one board is" } else { "boards are" };
            self.remark = Some(format!("Of other versions of this level {boards} kept in scores/aside."));
        }
        self
    }

    /// The same with what finds out which rows are earned.
    #[must_use]
    pub fn with_prover(self, prover: Option<Prover>) -> Self {
        Self { prover, ..self }
    }

    /// How a row stands, as far as that is known.
    pub fn standing(&self, row: usize) -> Option<&Standing> {
        self.prover.as_ref().and_then(|prover| prover.standing(row))
    }

    /// What is wrong with the first row in view that does not hold.
    pub fn doubt(&self) -> Option<String> {
        self.range().find_map(|row| match self.standing(row)? {
            Standing::Doubtful(doubt) => Some(format!("{} does not hold: {doubt}.", self.board.rows()[row].name)),
            Standing::Proven | Standing::NoFlight => None,
        })
    }

    /// What the level has brought whoever is in a row.
    pub fn medals(&self, row: usize) -> Medals {
        self.medals.get(row).copied().unwrap_or_default()
    }

    /// One frame.
    pub fn update(&mut self, input: &Input) -> Option<Request> {
        self.place(&input.frame);
        if let Some(prover) = &mut self.prover {
            prover.update(&self.board, self.scroll.range(), input.frame_time);
        }
        // Where Enter and Esc are all that the buttons need, all arrows turn pages.
        let turns = self.ways.len() <= 2;
        let turn = |key| if turns { aside(key) } else { key };
        let pressed = KEYS.into_iter().filter(|key| input.pressed(*key)).map(turn).collect();
        let held = KEYS.into_iter().filter(|key| input.held(*key)).map(turn).collect();
        self.scroll.update(&Input { pressed, held, ..input.clone() });
        let arrows = KEYS.into_iter().chain([Key::PadLeft, Key::PadRight]).filter(|_| turns).collect();
        let to_buttons = Input { pressed: input.pressed.less(arrows), ..input.clone() };
        let way = if input.pressed(Key::Escape) { self.ways.len() - 1 } else { self.buttons.update(&to_buttons)? };
        self.ways.get(way).map(|way| way.to.clone())
    }

    /// What it is of.
    pub fn subject(&self) -> &str {
        &self.subject
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

    /// The words on its buttons.
    pub fn labels(&self) -> impl Iterator<Item = &'static str> + '_ {
        self.ways.iter().map(|way| way.label)
    }

    /// Its buttons; the last one is the way back.
    pub fn buttons(&self) -> &Buttons {
        &self.buttons
    }

    fn place(&mut self, frame: &Frame) {
        let panel = panel(frame);
        let rows = panel.min.y + HEAD;
        self.scroll.place(self.board.rows().len(), PAGE, bar_beside(panel, rows, rows + PAGE as f32 * ROW));
        self.buttons.place(frame.row(self.ways.len(), panel.max().y + FOOT));
    }
}

/// The keys that turn pages and scroll.
const KEYS: [Key; 8] = [Key::Up, Key::Down, Key::Left, Key::Right, Key::PageUp, Key::PageDown, Key::Home, Key::End];

/// The key that does what an arrow to the side does.
fn aside(key: Key) -> Key {
    match key {
        Key::Left => Key::PageUp,
        Key::Right => Key::PageDown,
        other => other,
    }
}

fn panel(frame: &Frame) -> Area {
    let top = TOP + (frame.size.y - 720.0) / 2.0;
    Area { min: Vec2::new((frame.size.x - WIDTH) / 2.0, top), size: Vec2::new(WIDTH, HEAD + PAGE as f32 * ROW + 16.0) }
}

#[cfg(feature = "window")]
mod drawing {
    use super::{HEAD, Leaderboard, PAGE, ROW, panel};
    use crate::game::{Medal, Prize};
    use crate::level::Awards;
    use crate::scores::{Origin, Standing};
    use crate::view::canvas::{Canvas, Style};
    use crate::view::layout::{Area, BUTTON_TEXT, DETAILS, HEADING, TEXT, Vec2};
    use crate::view::{medals, theme, widgets};

    /// Where the medals stand, from the panel's left edge, and how large they are.
    const MEDALS: f32 = 424.0;
    const RADIUS: f32 = 12.0;
    /// Where the columns stand, from the panel's left edge: rank (its right end), name, score (its right end), with which program and in
    /// which version of the level it was flown, and whether that is proven (its middle).
    const COLUMNS: [f32; 5] = [96.0, 144.0, 600.0, 640.0, 812.0];

    impl Leaderboard {
        /// Draws the board.
        pub fn draw(&self, canvas: &Canvas) {
            widgets::graph_paper(canvas);
            let panel = panel(canvas.frame());
            let heading = Vec2::new(canvas.size().x / 2.0, panel.min.y - 64.0);
            let (words, widest) = (format!("Leaderboard of {}", self.subject), canvas.size().x - 64.0);
            widgets::fitted(canvas, &words, heading, widest, &[HEADING, BUTTON_TEXT], theme::text());
            widgets::panel(canvas, panel);
            let quiet = Style::new(TEXT, theme::quiet()).middle();
            let middle = canvas.size().x / 2.0;
            let message = Vec2::new(middle, panel.min.y - 24.0);
            if let Some(damage) = &self.damage {
                widgets::fitted(canvas, damage, message, canvas.size().x - 64.0, &[TEXT], theme::bad());
            } else if let Some(remark) = &self.remark {
                canvas.text(remark, message, quiet.centred());
            }
            if self.board.rows().is_empty() {
                draw_empty(canvas, panel);
            } else {
                self.draw_rows(canvas, panel, quiet);
            }
            for (i, (area, label)) in self.buttons.areas().iter().zip(self.labels()).enumerate() {
                widgets::button(canvas, *area, label, self.buttons.hover() == Some(i), self.buttons.focus() == i);
            }
        }

        fn draw_rows(&self, canvas: &Canvas, panel: Area, quiet: Style) {
            let column = |i: usize, y: f32| Vec2::new(panel.min.x + COLUMNS[i], y);
            let head = panel.min.y + HEAD / 2.0 + 2.0;
            canvas.text("Rank", column(0, head), quiet.right());
            canvas.text("Name", column(1, head), quiet);
            canvas.text("Score", column(2, head), quiet.right());
            if self.prover.is_some() {
                canvas.text("Version", column(3, head), quiet);
                canvas.text("Proven", column(4, head), quiet.centred());
            }
            for (line, index) in self.scroll.range().enumerate() {
                let row = &self.board.rows()[index];
                let top = panel.min.y + HEAD + line as f32 * ROW;
                let y = top + ROW / 2.0;
                if self.saved == Some(index) {
                    let area = Area::new(panel.min.x + 24.0, top + 2.0, panel.size.x - 48.0, ROW - 4.0);
                    canvas.rounded(area, 6.0, theme::panel_hover());
                    canvas.rounded_edge(area, 6.0, 2.0, theme::accent());
                }
                let colour = if index == 0 { theme::player_objective() } else { theme::text() };
                let style = Style::new(TEXT, colour).mono().middle();
                canvas.text(&(index + 1).to_string(), column(0, y), style.right());
                canvas.text(row.name.as_str(), column(1, y), style);
                let first = Vec2::new(panel.min.x + MEDALS, y);
                medals::draw_earned(canvas, self.medals(index), &Awards::default(), first, RADIUS);
                canvas.text(&row.score.to_string(), column(2, y), style.right());
                canvas.text(&version(&self.board.origin(index)), column(3, y), Style { size: DETAILS, ..quiet }.mono());
                match self.standing(index) {
                    Some(Standing::Proven) => widgets::tick(canvas, column(4, y), 8.0, theme::good()),
                    Some(Standing::Doubtful(_)) => widgets::cross(canvas, column(4, y), 8.0, theme::bad()),
                    Some(Standing::NoFlight) => canvas.text("–", column(4, y), quiet.centred()),
                    None if self.prover.is_some() => canvas.text("…", column(4, y), quiet.centred()),
                    None => {}
                }
            }
            if let Some(doubt) = self.doubt() {
                let at = Vec2::new(panel.centre().x, panel.max().y + 22.0);
                widgets::fitted(canvas, &doubt, at, canvas.size().x - 300.0, &[TEXT, DETAILS], theme::bad());
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

    /// What stands on a board without rows: what can be won, and how.
    fn draw_empty(canvas: &Canvas, panel: Area) {
        const STEP: Vec2 = Vec2::new(88.0, 22.0);
        const LARGE: f32 = 34.0;
        let middle = panel.centre();
        let podium = [(Medal::Silver, -1.0, 1.0), (Medal::Gold, 0.0, 0.0), (Medal::Bronze, 1.0, 1.6)];
        for (medal, aside, down) in podium {
            let at = middle + Vec2::new(aside, down) * STEP - Vec2::new(0.0, 96.0);
            medals::draw(canvas, Prize::Medal(medal), true, at, LARGE);
        }
        let line = |words: &str, below: f32, size: f32, colour| {
            canvas.text(words, middle + Vec2::new(0.0, below), Style::new(size, colour).centred().middle());
        };
        line("No scores yet", 32.0, HEADING, theme::text());
        line("Fly it and save your score: the first row is yours.", 84.0, TEXT, theme::quiet());
    }

    /// With which program a row was flown, and the first digits of the level's version.
    fn version(origin: &Origin) -> String {
        let program = origin.program.as_deref().unwrap_or_default();
        let number = program.rsplit(' ').next().unwrap_or_default();
        let short: String = number.chars().take(8).collect();
        let level = origin.version.map(|version| format!("{:04x}", version >> 48)).unwrap_or_default();
        if level.is_empty() { short } else { format!("{short} · {level}") }
    }
}
