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
const WIDTH: f32 = 1000.0;
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

/// A flight of the level's own, which stands among the rows without a rank.
#[derive(Clone, Debug, PartialEq)]
pub struct BoardRival {
    /// Its name.
    pub name: &'static str,
    /// Points.
    pub score: i64,
    /// s, where its record says it.
    pub time: Option<f64>,
}

/// A line of the screen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BoardLine {
    /// A row of the board, by its index.
    Row(usize),
    /// A flight of the level's own, by its index.
    Rival(usize),
}

/// The leaderboard screen.
#[derive(Debug)]
pub struct Leaderboard {
    subject: String,
    board: Board,
    /// The level's own flights, the best first.
    rivals: Vec<BoardRival>,
    /// The rows, and the rivals where their scores are.
    lines: Vec<BoardLine>,
    /// Judges the rows; the jumper's board has no judge.
    prover: Option<Prover>,
    /// Whose row was just saved.
    saved: Option<Name>,
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
        let (saved, remark) = fresh.map(|fresh| (fresh.name, fresh.remark)).unzip();
        let (scroll, buttons) = (Scroll::of_pages(), Buttons::default());
        let remark = remark.flatten();
        let (rivals, lines) = (Vec::new(), Vec::new());
        let mut screen = Self { subject, board, rivals, lines, prover: None, saved, damage, remark, scroll, ways, buttons };
        screen.sort_in();
        screen.show_saved();
        screen
    }

    /// Scrolls to the row just saved.
    fn show_saved(&mut self) {
        self.place(&Frame::default());
        if let Some(line) = self.saved().and_then(|row| self.lines.iter().position(|line| *line == BoardLine::Row(row))) {
            self.scroll.show(line);
        }
    }

    /// The same with the level's own flights.
    #[must_use]
    pub fn with_rivals(mut self, mut rivals: Vec<BoardRival>) -> Self {
        rivals.sort_by_key(|rival| std::cmp::Reverse(rival.score));
        self.rivals = rivals;
        self.sort_in();
        self.show_saved();
        self
    }

    /// Puts each rival behind the rows that may hold and are worth as much.
    fn sort_in(&mut self) {
        let rows = self.board.rows();
        let fails = |row: usize| matches!(self.standing(row), Some(Standing::Doubtful(_)));
        let holds = |row: usize| self.board.origin(row).flight.is_some() && !fails(row);
        let mut lines: Vec<BoardLine> = (0..rows.len()).map(BoardLine::Row).collect();
        for (number, rival) in self.rivals.iter().enumerate().rev() {
            let ahead = (0..rows.len()).take_while(|&row| holds(row) && rows[row].score >= rival.score).count();
            lines.insert(ahead, BoardLine::Rival(number));
        }
        self.lines = lines;
    }

    /// The lines, best first.
    pub fn lines(&self) -> &[BoardLine] {
        &self.lines
    }

    /// The level's own flights, by their lines.
    pub fn rivals(&self) -> &[BoardRival] {
        &self.rivals
    }

    /// The rows in view.
    fn rows_in_view(&self) -> Vec<usize> {
        let rows = self.lines.get(self.scroll.range()).unwrap_or_default().iter();
        rows.filter_map(|line| if let BoardLine::Row(row) = line { Some(*row) } else { None }).collect()
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

    /// The same with a judge of the rows.
    #[must_use]
    pub fn with_prover(mut self, mut prover: Prover) -> Self {
        prover.rank(&mut self.board);
        self.prover = Some(prover);
        self.sort_in();
        self.show_saved();
        self
    }

    fn name(&self, row: usize) -> Option<&Name> {
        self.board.rows().get(row).map(|row| &row.name)
    }

    /// How a row stands, as far as that is known.
    pub fn standing(&self, row: usize) -> Option<&Standing> {
        self.prover.as_ref()?.standing(self.name(row)?)
    }

    /// What is wrong with the first row in view that does not hold.
    pub fn doubt(&self) -> Option<String> {
        self.rows_in_view().into_iter().find_map(|row| match self.standing(row)? {
            Standing::Doubtful(doubt) => Some(format!("{} does not hold: {doubt}.", self.board.rows()[row].name)),
            Standing::Proven | Standing::Unproven => None,
        })
    }

    /// The medals that the flight of a row has earned, once it is proven.
    pub fn medals(&self, row: usize) -> Medals {
        let medals = || Some(self.prover.as_ref()?.medals(self.name(row)?));
        medals().unwrap_or_default()
    }

    /// How long the flight of a row took, s, where that is known.
    pub fn time(&self, row: usize) -> Option<f64> {
        self.prover.as_ref()?.time(self.name(row)?)
    }

    /// One frame.
    pub fn update(&mut self, input: &Input) -> Option<Request> {
        self.place(&input.frame);
        let view = self.rows_in_view();
        if self.prover.as_mut().is_some_and(|prover| prover.update(&mut self.board, view, input.worked())) {
            self.sort_in();
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

    /// The lines in view.
    pub fn range(&self) -> std::ops::Range<usize> {
        self.scroll.range()
    }

    /// The index of the row just saved.
    pub fn saved(&self) -> Option<usize> {
        self.board.rank(self.saved.as_ref()?).map(|rank| rank - 1)
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
        self.scroll.place(self.lines.len(), PAGE, bar_beside(panel, rows, rows + PAGE as f32 * ROW));
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

mod drawing {
    use super::{BoardLine, HEAD, Leaderboard, PAGE, ROW, panel};
    use crate::draw::{Canvas, Style};
    use crate::game::{Medal, Prize};
    use crate::level::Awards;
    use crate::number::clock;
    use crate::scores::{Origin, Standing};
    use crate::view::layout::{Area, BUTTON_TEXT, DETAILS, HEADING, TEXT, Vec2};
    use crate::view::{medals, theme, widgets};

    /// Where the medals stand, from the panel's left edge, and how large they are.
    const MEDALS: f32 = 316.0;
    const RADIUS: f32 = 12.0;
    /// Where the columns stand, from the panel's left edge: rank (its right end), name, time and score (their right ends), with which program
    /// and in which version of the level it was flown, and whether that is proven (its middle).
    const COLUMNS: [f32; 6] = [80.0, 112.0, 484.0, 624.0, 652.0, 912.0];
    /// The most digits of a score that stand in their column at the usual size.
    const DIGITS: usize = 11;

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
            if self.lines.is_empty() {
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
            canvas.text("Score", column(3, head), quiet.right());
            if self.prover.is_some() {
                canvas.text("Time", column(2, head), quiet.right());
                canvas.text("Version", column(4, head), quiet);
                canvas.text("Proven", column(5, head), quiet.centred());
            }
            for (at, line) in self.lines.get(self.scroll.range()).unwrap_or_default().iter().enumerate() {
                let top = panel.min.y + HEAD + at as f32 * ROW;
                let y = top + ROW / 2.0;
                let index = match *line {
                    BoardLine::Row(index) => index,
                    BoardLine::Rival(number) => {
                        let rival = &self.rivals[number];
                        let number = quiet.mono();
                        canvas.text(rival.name, column(1, y), quiet);
                        canvas.text(&rival.time.map_or("–".to_owned(), clock), column(2, y), number.right());
                        canvas.text(&rival.score.to_string(), column(3, y), number.right());
                        canvas.text("level's own", column(5, y), quiet.centred());
                        continue;
                    }
                };
                let row = &self.board.rows()[index];
                if self.saved() == Some(index) {
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
                let score = row.score.to_string();
                let size = if score.len() > DIGITS { DETAILS } else { TEXT };
                canvas.text(&score, column(3, y), Style { size, ..style }.right());
                if self.prover.is_none() {
                    continue;
                }
                match (self.time(index), self.standing(index)) {
                    (Some(time), _) => canvas.text(&clock(time), column(2, y), style.right()),
                    // A score that no flight has may be as wide as both columns.
                    (None, Some(Standing::Doubtful(_))) => {}
                    (None, _) => canvas.text("–", column(2, y), quiet.right()),
                }
                canvas.text(&version(&self.board.origin(index)), column(4, y), Style { size: DETAILS, ..quiet }.mono());
                match self.standing(index) {
                    Some(Standing::Proven) => widgets::tick(canvas, column(5, y), 8.0, theme::good()),
                    Some(Standing::Doubtful(_)) => widgets::cross(canvas, column(5, y), 8.0, theme::bad()),
                    Some(Standing::Unproven) => canvas.text("unproven", column(5, y), quiet.centred()),
                    None => canvas.text("…", column(5, y), quiet.centred()),
                }
            }
            if let Some(doubt) = self.doubt() {
                let at = Vec2::new(panel.centre().x, panel.max().y + 22.0);
                widgets::fitted(canvas, &doubt, at, canvas.size().x - 300.0, &[TEXT, DETAILS], theme::bad());
            }
            if let Some(bar) = self.scroll.bar() {
                widgets::scroll_bar(canvas, bar.track, bar.handle, bar.held);
            }
            let rows = self.lines.len();
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

    /// With which program a row was flown, and the first digits of the level's hash.
    fn version(origin: &Origin) -> String {
        let program = origin.program.as_deref().unwrap_or_default();
        let number = program.rsplit(' ').next().unwrap_or_default();
        let short: String = number.chars().take(8).collect();
        let Some(version) = origin.version else { return short };
        let digits: String = version.to_string().chars().take(4).collect();
        format!("{short} · {digits}{}", if version.is_old() { ", 64-bit" } else { "" })
    }
}
