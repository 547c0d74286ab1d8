//! The best of one level.

pub mod flights;

use crate::draw::layout::{Area, DETAILS, HEADING, TEXT, Vec2};
use crate::scores::{Board, LoadedBoard, Name, damage_text, subject};
use crate::screens::screen::{Classic, Destination, Purpose, Request, Screen};
use crate::session::recordings::{self, BoardRival, Visit};
use crate::ui::{Turning, Ui, scroll::bar_beside};
use crate::{classics::jumper::LEADERBOARD, number::clock, screens::classics::jumper, session::Session, settings::Key, words::tr};
use crate::{draw::Canvas, draw::Style, game::Medal, game::Prize, view::theme, view::widgets};
use std::ops::Range;

const PAGE: usize = 10;
const ROW: f32 = 40.0;
const WIDTH: f32 = 1000.0;
/// From the panel's top to the first row: the columns' names.
const HEAD: f32 = 48.0;
const TOP: f32 = 120.0;
const FOOT: f32 = 44.0;
/// Where the columns stand, from the panel's left edge: rank (its right end), name, what is said of a rival, time and score (their right ends).
const COLUMNS: [f32; 5] = [80.0, 128.0, 356.0, 664.0, 880.0];
/// Where the mark of a kept flight stands, and the half of its height.
const MARK: f32 = 106.0;
const MARK_SIZE: f32 = 8.0;
/// The most digits of a score that stand in their column at the usual size.
const DIGITS: usize = 11;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum BoardLine {
    Row(usize),
    Rival(usize),
}

#[derive(Debug)]
pub struct Leaderboard {
    subject: String,
    pub board: Board,
    /// The level's own flights, the best first.
    rivals: Vec<BoardRival>,
    /// The rows, and the rivals where their scores are.
    lines: Vec<BoardLine>,
    shown: Range<usize>,
    /// The level that it is of; `None` for the jumper.
    level: Option<String>,
    /// Whose row is picked out: that of who plays.
    player: Name,
    damage: Option<String>,
    /// Where its buttons lead; the last one is Back.
    onward: Vec<(&'static str, Request)>,
}

impl Leaderboard {
    fn in_view(&self) -> &[BoardLine] {
        self.lines.get(self.shown.clone()).unwrap_or_default()
    }

    fn own(&self) -> Option<usize> {
        self.board.rank(&self.player).map(|rank| rank - 1)
    }

    fn show_lines(&mut self, ui: &mut Ui<'_>, panel: Area) {
        let rows = panel.min.y + HEAD;
        let own = self.own().and_then(|row| self.lines.iter().position(|line| *line == BoardLine::Row(row)));
        if let (true, Some(line)) = (ui.opens(), own) {
            ui.reveal("board", line);
        }
        // Where Enter and Esc are all that the buttons need, all arrows turn pages.
        let turn = if self.onward.len() <= 2 { Turning::AllPages } else { Turning::Pages };
        let bar = bar_beside(panel, rows, rows + PAGE as f32 * ROW);
        self.shown = ui.scroll("board", (self.lines.len(), PAGE), bar, turn);
        if self.lines.is_empty() {
            return show_empty(ui, panel);
        }
        let quiet = Style::new(TEXT, theme::quiet()).middle();
        let time = if self.level.is_some() { tr("Time") } else { "" };
        let heads =
            [(tr("Rank"), 0, quiet.right()), (tr("Name"), 1, quiet), (time, 3, quiet.right()), (tr("Score"), 4, quiet.right())];
        for (head, column, style) in heads {
            ui.text(head, panel.min + Vec2::new(COLUMNS[column], HEAD / 2.0 + 2.0), style);
        }
        for (at, line) in self.in_view().iter().enumerate() {
            let top = Vec2::new(panel.min.x, rows + at as f32 * ROW);
            match *line {
                BoardLine::Row(index) => self.show_row(ui.canvas(), index, Area { min: top, size: Vec2::new(WIDTH, ROW) }),
                BoardLine::Rival(number) => {
                    let (rival, number) = (&self.rivals[number], quiet.mono().right());
                    let column = |i: usize| top + Vec2::new(COLUMNS[i], ROW / 2.0);
                    ui.text(tr(rival.name), column(1), quiet);
                    ui.text(tr("level's own"), column(2), quiet);
                    ui.text(&rival.time.map_or("–".to_owned(), clock), column(3), number);
                    ui.text(&rival.score.to_string(), column(4), number);
                }
            }
        }
        if self.lines.len() > PAGE {
            let text =
                tr!("{first}–{last} of {count}", first = self.shown.start + 1, last = self.shown.end, count = self.lines.len());
            ui.text(&text, panel.max() + Vec2::new(-16.0, 24.0), quiet.right());
        }
    }

    fn show_row(&self, canvas: &Canvas, index: usize, area: Area) {
        let row = &self.board.rows()[index];
        if self.own() == Some(index) {
            widgets::picked_row(canvas, Area::new(area.min.x + 24.0, area.min.y + 2.0, area.size.x - 48.0, ROW - 4.0));
        }
        let colour = if index == 0 { theme::player_objective() } else { theme::text() };
        let (style, quiet) = (Style::new(TEXT, colour).mono().middle(), Style::new(TEXT, theme::quiet()).middle());
        let column = |i: usize| Vec2::new(area.min.x + COLUMNS[i], area.centre().y);
        canvas.text(&(index + 1).to_string(), column(0), style.right());
        canvas.text(row.name.as_str(), column(1), style);
        let score = row.score.to_string();
        let size = if score.len() > DIGITS { DETAILS } else { TEXT };
        canvas.text(&score, column(4), Style { size, ..style }.right());
        if self.board.flight(index).is_some() {
            let corner = |x: f32, y: f32| Vec2::new(area.min.x + MARK, area.centre().y) + Vec2::new(x, y) * MARK_SIZE;
            canvas.triangle([corner(-0.7, -1.0), corner(-0.7, 1.0), corner(1.0, 0.0)], theme::accent());
        }
        match self.board.time(index) {
            _ if self.level.is_none() => {}
            Some(time) => canvas.text(&clock(time), column(3), style.right()),
            None => canvas.text("–", column(3), quiet.right()),
        }
    }

    /// A click on a row whose flight is kept leads to the flights of the level, where it can be watched and raced.
    fn clicked(&self, ui: &Ui<'_>, panel: Area) -> Option<Request> {
        let pointer = ui.input().pointer;
        let within = ui.input().click && pointer.x > panel.min.x && pointer.x < panel.min.x + COLUMNS[4];
        let line = (pointer.y - panel.min.y - HEAD) / ROW;
        let line = (within && line >= 0.0).then(|| self.in_view().get(line as usize))?;
        let BoardLine::Row(row) = *line? else { return None };
        let (level, chosen) = (self.level.clone()?, self.board.flight(row)?.to_owned());
        Some(Request::Push(Destination::Flights(Visit { level, flown: None, chosen: Some(chosen) })))
    }
}

/// The board of a level, with what was just flown there, or of the jumper.
/// Errors: what it is of, and why it cannot be read.
pub fn open(visit: Visit, session: &mut Session) -> Result<Leaderboard, (String, String)> {
    let (name, of_level) = (visit.level.clone(), visit.level != LEADERBOARD);
    let level = of_level.then(|| session.library.load(&name).ok()).flatten();
    let title = level.as_ref().map_or(&name, |level| &level.title);
    let subject = if of_level { subject(&name, title) } else { tr(jumper::SUBJECT).to_owned() };
    let LoadedBoard { board, damage } = match session.scores.load(&name) {
        Ok(loaded) => loaded,
        Err(error) => return Err((subject, error.to_string())),
    };
    let damage = (!damage.is_empty()).then(|| damage_text(&damage));
    let play = || ("Play", Request::Reset(Destination::Play(name.clone())));
    let play = (board.rows().is_empty() && level.is_some() && visit.flown.is_none()).then(play);
    let flights = level.iter().map(|_| ("Flights", Request::Push(Destination::Flights(visit.clone()))));
    let onward = play.into_iter().chain(flights).chain([("Back", Request::Pop)]).collect();
    let mut rivals = level.map(|level| recordings::rivals(&session.library.folder(&name), &level)).unwrap_or_default();
    rivals.sort_by_key(|rival| std::cmp::Reverse(rival.score));
    let mut lines: Vec<BoardLine> = (0..board.rows().len()).map(BoardLine::Row).collect();
    // Each rival behind the rows that are worth as much.
    for (number, rival) in rivals.iter().enumerate().rev() {
        lines.insert(board.rows().partition_point(|row| row.score >= rival.score), BoardLine::Rival(number));
    }
    if of_level {
        session.last_level = Some(name.clone());
    }
    let (player, level) = (session.journal.current().clone(), of_level.then_some(name));
    Ok(Leaderboard { subject, board, rivals, lines, shown: 0..PAGE, level, player, damage, onward })
}

impl Screen for Leaderboard {
    fn show(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        let size = ui.frame().size;
        let corner = Vec2::new((size.x - WIDTH) / 2.0, TOP + (size.y - 720.0) / 2.0);
        let panel = Area { min: corner, size: Vec2::new(WIDTH, HEAD + PAGE as f32 * ROW + 16.0) };
        ui.page(&tr!("Leaderboard of {subject}", subject = self.subject), panel.min.y - 64.0);
        ui.panel(panel);
        let message = Vec2::new(size.x / 2.0, panel.min.y - 24.0);
        ui.fitted(self.damage.as_deref().unwrap_or_default(), message, &[TEXT], theme::bad());
        self.show_lines(ui, panel);
        let labels: Vec<&str> = self.onward.iter().map(|(label, _)| *label).collect();
        let pressed = ui.row(panel.max().y + FOOT, &labels);
        if let Some(flights) = self.clicked(ui, panel) {
            return Some(flights);
        }
        if ui.key(Key::Escape) {
            return self.onward.last().map(|(_, to)| to.clone());
        }
        self.onward.iter().find(|(label, _)| Some(*label) == pressed).map(|(_, to)| to.clone())
    }

    fn lies_over(&self) -> bool {
        true
    }

    fn parent(&self) -> Destination {
        if self.level.is_some() { Destination::Levels(Purpose::Leaderboard) } else { Destination::Classic(Classic::Jumper) }
    }

    fn tune(&self) -> Option<&str> {
        None
    }
}

/// What stands on a board without rows: what can be won, and how.
fn show_empty(ui: &Ui<'_>, panel: Area) {
    const STEP: Vec2 = Vec2::new(88.0, 22.0);
    const LARGE: f32 = 34.0;
    let middle = panel.centre();
    let podium = [(Medal::Silver, -1.0, 1.0), (Medal::Gold, 0.0, 0.0), (Medal::Bronze, 1.0, 1.6)];
    for (medal, aside, down) in podium {
        let at = middle + Vec2::new(aside, down) * STEP - Vec2::new(0.0, 96.0);
        widgets::draw(ui.canvas(), Prize::Medal(medal), true, at, LARGE);
    }
    ui.fitted(tr("No scores yet"), middle + Vec2::new(0.0, 32.0), &[HEADING], theme::text());
    let how = tr("Fly it and save your score: the first row is yours.");
    ui.fitted(how, middle + Vec2::new(0.0, 84.0), &[TEXT], theme::quiet());
}
