//! Signs above a flight: its pace, a test, the loss of the attempt before, a varied level, changed files. Hints, one at a time, for a player who
//! has lost a few times or stays for long. The introduction of a level: its name, the whole of its rooms, its goals one after the other.

use super::Flight;
use crate::draw::layout::{
    Area, DETAILS, Frame, GRID, HEADING, LINE, MONO_ADVANCE, PADDING, TEXT, TITLE, Vec2, lines, text_room, words_width, wrapped,
};
use crate::view::{camera::Viewport, emitters::objective_colour, hud::HudLayout, theme, widgets};
use crate::{draw::Canvas, draw::Style, game::Outcome, game::goals, settings::Action, ui::Ui, ui::input::Input, words::tr};

/// How long the introduction stays, s, and how long it takes to come and to go.
const LASTS: f64 = 2.0;
const FADES: f64 = 0.2;
/// From one goal's ring to the next, and how long each spreads, s; by how much, canvas units.
const NEXT: f64 = 0.3;
const SPREADS: f64 = 0.7;
const REACH: f32 = 36.0;
/// The height of the dark at the foot, behind the words, and the strips that it fades in.
const FOOT: f32 = 200.0;
const STRIPS: usize = 20;
const FROM_EDGE: f32 = 64.0;

/// From the canvas' foot to a sign above the fuel bar.
const ABOVE_FUEL: f32 = 52.0;
const TEST: &str = "A test flight: Esc or F5 leads back to the editor";

/// Its words in lines that are no wider than the room, and its size with the space around them.
fn sign(words: &str, frame: &Frame, room: f32) -> (Vec<String>, Vec2) {
    let (height, around) = (frame.text_height(TEXT), Vec2::new(2.0, 1.0) * PADDING);
    let lines = lines(words, room - around.x, |line| words_width(line, height));
    let longest = lines.iter().map(|line| words_width(line, height)).fold(0.0, f32::max);
    let size = Vec2::new(longest, lines.len() as f32 * height * LINE) + around;
    (lines, size)
}

impl Flight {
    /// The sign of a pace other than the usual one, or of an ended flight that stays: words and place at the flight's foot.
    fn time_sign(&self, frame: &Frame) -> Option<(Vec<String>, Area)> {
        let stays = self.run.game.outcome() != Outcome::Running && self.seen.instruments.stays() && !self.seen.observer.frozen();
        let ended = stays.then(|| tr("The flight has ended: Enter leads on").to_owned());
        let words = ended
            .or_else(|| self.start_words())
            .or_else(|| self.seen.observer.words(self.run.game.ticks(), self.run.game.tick_rate()));
        let words = words.or_else(|| self.rewind_words(self.seen.observer.keys()))?;
        let room = self.seen.instruments.room(&self.above_controls(frame)).size;
        let (lines, size) = sign(&words, frame, room.x - 2.0 * GRID);
        let foot = room.y - self.above_foot();
        Some((lines, Area { min: Vec2::new((room.x - size.x) / 2.0, foot - size.y), size }))
    }

    fn start_words(&self) -> Option<String> {
        let waits = self.seen.observer.frozen() && self.run.game.ticks() == 0 && !self.run.game.level().ship_plays();
        let freeze = self.seen.observer.keys().label(Action::Freeze);
        waits.then(|| match self.open.sheet.as_ref().is_some_and(|sheet| sheet.predicts() && sheet.written.prediction.is_empty()) {
            true => tr!("Predict, then [{freeze}] starts the experiment", freeze),
            false => tr!("[{freeze}] starts the experiment", freeze),
        })
    }

    /// From the foot of the flight up to the top of that sign, whether there is one or not.
    pub(super) fn time_room(&self, frame: &Frame) -> f32 {
        let shown = self.time_sign(frame).map(|(_, area)| area.size.y);
        self.above_foot() + shown.unwrap_or_else(|| sign("", frame, frame.size.x).1.y)
    }

    /// From the foot of the flight up to that of the sign.
    fn above_foot(&self) -> f32 {
        match (self.open.test, self.run.game.level().ship_plays()) {
            // The words on a test flight stand there.
            (true, _) => 1.5 * ABOVE_FUEL,
            (false, true) => ABOVE_FUEL,
            (false, false) => GRID,
        }
    }

    fn test_sign(&self, frame: &Frame) -> Option<Area> {
        let at = Vec2::new(frame.size.x / 2.0, self.seen.instruments.room(frame).size.y - ABOVE_FUEL);
        self.open.test.then(|| Area::around(at, text_room(tr(TEST), frame.text_height(TEXT))))
    }

    /// The sign of the loss of the attempt before, below the row of the timer, away from the usual starts of ships.
    fn lost_sign(&self, frame: &Frame) -> Option<(Vec<String>, Area)> {
        let death = self.lost().filter(|_| self.open.news.is_none())?;
        let words = tr!("{death} · Enter: the result", death);
        let (words, size) = sign(&words, frame, frame.size.x - 2.0 * GRID);
        let top = HudLayout::new(frame).status.max().y + PADDING;
        Some((words, Area { min: Vec2::new((frame.size.x - size.x) / 2.0, top), size }))
    }

    /// The places above the level besides the head-up display.
    pub(super) fn panels(&self, frame: &Frame) -> Vec<Area> {
        let instruments = self.seen.instruments.areas(&self.above_controls(frame));
        if self.is_watched() {
            return instruments;
        }
        let signs = self.time_sign(frame).map(|(_, area)| area).into_iter().chain(self.test_sign(frame));
        let news = self.open.news.as_ref().map(|news| news.layout(frame).0);
        let lost = self.lost_sign(frame).map(|(_, area)| area);
        // The sign of a varied level stands beside the status, in as many lines as it needs.
        let (corner, room) = self.what_if_room(frame);
        let status = HudLayout::new(frame).status;
        let varied = self.variation().map(|_| Area::new(corner.x, corner.y, room + 2.0 * PADDING, status.size.y));
        let sheet = self.sheet_areas(frame);
        signs.chain(news).chain(lost).chain(varied).chain(instruments).chain(sheet).collect()
    }

    pub(super) fn draw_signs(&self, canvas: &Canvas) {
        if let Some(area) = self.test_sign(canvas.frame()) {
            canvas.text(tr(TEST), area.centre(), Style::new(TEXT, theme::accent()).centred().middle());
        }
        self.draw_what_if(canvas);
        if let Some(news) = &self.open.news {
            news.draw(canvas);
        }
        if self.open.pause.is_some() {
            return;
        }
        self.draw_offer(canvas);
        let lost = self.lost_sign(canvas.frame()).map(|(words, area)| (words, area, theme::panel().faded(0.9)));
        let time = self.time_sign(canvas.frame()).map(|(words, area)| (words, area, theme::panel()));
        for (lines, area, fill) in lost.into_iter().chain(time) {
            canvas.end_layer();
            widgets::panel_in(canvas, area, fill, theme::panel_edge());
            for (i, words) in lines.iter().enumerate() {
                let down = (i as f32 + 0.5 - 0.5 * lines.len() as f32) * canvas.line_height(TEXT);
                canvas.text(words, area.centre() + Vec2::new(0.0, down), Style::new(TEXT, theme::accent()).middle().centred());
            }
        }
    }

    /// A frame of it: any key ends it, and does what it always does.
    pub(super) fn introduce(&mut self, input: &Input) {
        let Some(age) = &mut self.open.introduced else { return };
        *age += input.frame_time;
        if *age > LASTS || !input.pressed.is_empty() || input.click {
            self.open.introduced = None;
        }
    }

    /// Whether the whole level is in view: it is introduced, or has not begun and asks for that.
    pub(super) fn shows_all(&self) -> bool {
        let begins = self.run.game.is_idle() && self.run.game.outcome() == Outcome::Running;
        let overview = self.run.game.level().overview && begins && !self.is_watched();
        self.open.introduced.is_some() || self.seen.observer.shows_map() || overview
    }

    pub(super) fn draw_goals_in_order(&self, view: &Viewport, canvas: &Canvas) {
        let Some(age) = self.open.introduced else { return };
        let level = self.run.game.level();
        let mut order: Vec<usize> = (0..level.objectives.len()).collect();
        order.sort_by_key(|index| level.objectives[*index].order);
        for (turn, index) in order.into_iter().enumerate() {
            let part = ((age - FADES - turn as f64 * NEXT) / SPREADS) as f32;
            if (0.0..1.0).contains(&part) {
                let (area, colour) = (view.rect(&level.objectives[index].bounds), objective_colour(&self.run.game, index));
                for ring in 0..3 {
                    let spread = area.inset(-REACH * part * (1.0 + 0.3 * ring as f32));
                    canvas.rounded_edge(spread, 8.0, 2.5, colour.faded((1.0 - part) * 0.9f32.powi(ring)));
                }
            }
        }
    }

    pub(super) fn draw_introduction(&self, canvas: &Canvas) {
        let Some(age) = self.open.introduced else { return };
        let (level, size) = (self.run.game.level(), canvas.size());
        let strong = (age / FADES).min((LASTS - age) / FADES).clamp(0.0, 1.0) as f32;
        canvas.end_layer();
        let strip = FOOT / STRIPS as f32;
        for i in 0..STRIPS {
            let area = Area::new(0.0, size.y - FOOT + i as f32 * strip, size.x, strip);
            canvas.rectangle(area, theme::ground().faded(strong * 0.92 * (i as f32 / STRIPS as f32)));
        }
        let name = if level.title == level.name { tr!("Level {level}", level = level.name) } else { tr(&level.title).to_owned() };
        let at = Vec2::new(FROM_EDGE, size.y - FROM_EDGE);
        let title = Style::new(TITLE, theme::text().faded(strong)).middle();
        let large = canvas.width(&name, title) < 0.6 * size.x;
        canvas.text(&name, at, if large { title } else { Style { size: HEADING, ..title } });
        let quiet = Style::new(TEXT, theme::quiet().faded(strong)).middle();
        if let Some(world) = level.landscape {
            canvas.text(tr(world.title()), at - Vec2::new(0.0, canvas.line_height(TITLE) * 0.6), quiet);
        }
        let right = Vec2::new(size.x - FROM_EDGE, at.y);
        canvas.text(tr("any key starts the flight"), right, quiet.right());
        // Who has not been there is not hurried.
        let offers = if self.open.done { goals(&level.awards, &self.run.game.result()) } else { Vec::new() };
        for (i, offer) in offers.iter().rev().enumerate() {
            let above = right - Vec2::new(0.0, (i + 1) as f32 * (canvas.line_height(TEXT) + PADDING / 4.0));
            canvas.text(&offer.asks, above, quiet.right());
        }
    }
}

#[derive(Clone, Debug, PartialEq)]
pub(super) enum News {
    /// They were read again: age of the notice, s, and whether the flight goes on where it was.
    Changed(f64, bool),
    /// They do not load; a line a problem.
    Broken(Vec<String>),
    /// They are edited, and flown as far as they go; a line a problem.
    Unfinished(Vec<String>),
}

const LISTED: usize = 6;
/// Width of the box with time and speed, which stands at the left.
const BESIDE: f32 = 290.0;
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

/// Losses of a level, or time in it, s, before its hints are offered.
const LOSSES: u32 = 3;
const PATIENCE: f64 = 90.0;

/// The losses of the level in this sitting, the time (s) since its flights began, and the number of hints given.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Hints {
    pub losses: u32,
    pub time: f64,
    given: usize,
}

impl Flight {
    /// Whether a restart now counts as a loss: a level without hazards has no other.
    pub(in crate::screens) fn is_given_up(&self) -> bool {
        let counts = self.is_by_hand() && !self.open.test && self.run.what_if.is_none();
        counts && self.run.game.outcome() == Outcome::Running && !self.run.game.is_idle()
    }

    pub(super) fn offers_hint(&self) -> bool {
        let Hints { losses, time, given } = self.open.hints;
        (losses >= LOSSES || time >= PATIENCE) && given < self.run.attempt.level.hints.len()
    }

    pub(super) const fn give_hint(&mut self) {
        self.open.hints.given += 1;
    }

    /// Whether the key of hints has something to show: it gives one that is left, above the pause panel.
    pub(super) fn takes_hint(&mut self) -> bool {
        if self.offers_hint() {
            self.give_hint();
        }
        self.open.hints.given > 0
    }

    fn draw_offer(&self, canvas: &Canvas) {
        if self.offers_hint() && !self.is_watched() {
            let words = tr!("{key}: a hint", key = self.seen.observer.keys().label(Action::Hint));
            let at = self.seen.instruments.room(canvas.frame()).size - PADDING;
            let style = Style::new(TEXT, theme::quiet()).middle().right();
            canvas.text(&words, at - Vec2::new(0.0, canvas.line_height(TEXT) / 2.0), style);
        }
    }

    /// The hints that were given, above the pause panel whose top is at `foot`.
    pub(super) fn show_hints(&self, ui: &Ui<'_>, foot: f32) {
        let given: Vec<&String> = self.run.attempt.level.hints.iter().take(self.open.hints.given).collect();
        if given.is_empty() {
            return;
        }
        let (frame, line) = (ui.frame(), ui.frame().text_height(TEXT) * LINE);
        let (width, style) = ((frame.size.x - 2.0 * PADDING).min(960.0), Style::new(TEXT, theme::accent()).centred().middle());
        let cut = |hint: &String| widgets::lines(ui.canvas(), tr(hint), width - 2.0 * PADDING, style);
        let lines: Vec<String> = given.into_iter().flat_map(cut).collect();
        let size = Vec2::new(width, lines.len() as f32 * line + PADDING);
        let top = (foot - PADDING - size.y).max(PADDING);
        ui.panel(Area { min: Vec2::new((frame.size.x - size.x) / 2.0, top), size });
        for (i, words) in lines.iter().enumerate() {
            ui.text(words, Vec2::new(frame.size.x / 2.0, top + 0.5 * PADDING + (i as f32 + 0.5) * line), style);
        }
    }
}
