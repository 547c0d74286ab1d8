//! Draws what a flight tells above the game: how its time goes, what became of the level's files, the pause panel.

use super::{Flight, News, PAUSE_TOP};
use crate::draw::layout::{
    Area, DETAILS, Frame, GRID, HEADING, LINE, MONO_ADVANCE, PADDING, TEXT, Vec2, WIDE_BUTTON, text_room, wrapped,
};
use crate::draw::{Canvas, Style};
use crate::game::Outcome;
use crate::view::hud::HudLayout;
use crate::view::{theme, widgets};

/// From the canvas' foot to what is told above the fuel bar.
const ABOVE_FUEL: f32 = 52.0;
/// What a test flight says.
const TEST: &str = "A test flight: Esc or F5 leads back to the editor";

impl Flight {
    /// How the time goes, where it does not go as it does, and what leads on where it has ended and stays: at the flight's foot.
    fn draw_time(&self, canvas: &Canvas) {
        let Some((words, area)) = self.time_sign(canvas.frame()) else { return };
        widgets::panel(canvas, area);
        canvas.text(&words, area.centre(), Style::new(TEXT, theme::accent()).middle().centred());
    }

    /// Its words and its place.
    fn time_sign(&self, frame: &Frame) -> Option<(String, Area)> {
        let kept = self.game.outcome() != Outcome::Running && self.instruments.stays() && !self.observer.frozen();
        let ended = kept.then(|| "The flight has ended: Enter leads on".to_owned());
        let words = ended.or_else(|| self.observer.words(self.game.ticks(), self.game.tick_rate()))?;
        let size = text_room(&words, frame.text_height(TEXT)) + Vec2::new(2.0, 1.0) * PADDING;
        let above = match (self.test, self.game.level().ship_plays()) {
            // A test flight has its words there.
            (true, _) => 1.5 * ABOVE_FUEL,
            (false, true) => ABOVE_FUEL,
            (false, false) => GRID,
        };
        let foot = self.instruments.room(frame).size.y;
        Some((words, Area { min: Vec2::new((frame.size.x - size.x) / 2.0, foot - above - size.y), size }))
    }

    /// The place of the words on a test flight.
    fn test_sign(&self, frame: &Frame) -> Option<Area> {
        let at = Vec2::new(frame.size.x / 2.0, self.instruments.room(frame).size.y - ABOVE_FUEL);
        self.test.then(|| Area::around(at, text_room(TEST, frame.text_height(TEXT))))
    }

    /// What stands above the level besides the head-up display.
    pub fn panels(&self, frame: &Frame) -> Vec<Area> {
        let signs = self.time_sign(frame).map(|(_, area)| area).into_iter().chain(self.test_sign(frame));
        let news = self.news.as_ref().map(|news| news_panel(news, frame).0);
        let lost = self.lost_sign(frame).map(|(_, area)| area);
        // The variation stands beside the status, in the lines that it needs.
        let status = HudLayout::new(frame).status;
        let width = frame.size.x - status.max().x;
        let varied = self.variation().map(|_| Area::new(status.max().x, status.min.y, width, status.size.y));
        signs.chain(news).chain(lost).chain(varied).chain(self.instruments.areas(frame)).collect()
    }

    /// What the attempt before was lost to, and the key that shows more of it: below the row of the timer, away from where ships start.
    fn lost_sign(&self, frame: &Frame) -> Option<(String, Area)> {
        let death = self.lost().filter(|_| self.news.is_none())?;
        let words = format!("{death} · Enter: what the attempt came to");
        let size = text_room(&words, frame.text_height(TEXT)) + Vec2::new(2.0, 1.0) * PADDING;
        let top = HudLayout::new(frame).status.max().y + PADDING;
        Some((words, Area { min: Vec2::new((frame.size.x - size.x) / 2.0, top), size }))
    }

    fn draw_lost(&self, canvas: &Canvas) {
        let Some((words, area)) = self.lost_sign(canvas.frame()) else { return };
        canvas.end_layer();
        widgets::panel_in(canvas, area, theme::panel().faded(0.9), theme::panel_edge());
        canvas.text(&words, area.centre(), Style::new(TEXT, theme::accent()).middle().centred());
    }

    /// Draws what is to be told of the level's files, and the pause panel where it is open, above the game.
    pub fn draw_over(&self, canvas: &Canvas) {
        if let Some(area) = self.test_sign(canvas.frame()) {
            canvas.end_layer();
            canvas.text(TEST, area.centre(), Style::new(TEXT, theme::accent()).centred().middle());
        }
        self.draw_what_if(canvas);
        if let (Some(news), None) = (&self.news, &self.settings) {
            draw_news(news, canvas);
        }
        if self.settings.is_some() {
            return widgets::curtain(canvas, 1.0);
        }
        let Some(pause) = &self.pause else {
            self.draw_lost(canvas);
            return self.draw_time(canvas);
        };
        widgets::curtain(canvas, 0.45);
        let middle = canvas.size() / 2.0;
        let top = middle.y - PAUSE_TOP - HEADING - 2.5 * PADDING;
        let bottom = pause.areas().last().map_or(middle.y, |last| last.max().y) + 1.5 * PADDING;
        let width = WIDE_BUTTON.x + 4.0 * PADDING;
        let panel = Area::new(middle.x - width / 2.0, top, width, bottom - top);
        widgets::panel(canvas, panel);
        widgets::heading(canvas, "Paused", panel.min.y + PADDING + HEADING * 0.65);
        let labels = self.pause_labels();
        for (i, area) in pause.areas().iter().enumerate() {
            widgets::button(canvas, *area, labels[i], pause.hover() == Some(i), pause.focus() == i);
        }
    }
}

/// The most problems that are listed above a flight.
const LISTED: usize = 6;

/// How far the box with time and speed reaches.
const BESIDE: f32 = 290.0;

/// The panel with what became of the level's files, and the lines of its problems.
fn news_panel(news: &News, frame: &Frame) -> (Area, Vec<String>) {
    let problems: &[String] = match news {
        News::Changed(..) => &[],
        News::Unfinished(problems) | News::Broken(problems) => problems,
    };
    // Beside the box with time and speed, which grows with the words.
    let left = 16.0 + BESIDE * frame.text.max(1.0);
    let room = frame.size.x - left - PADDING;
    let width = if problems.is_empty() { room.min(560.0) } else { room };
    let columns = ((width - 2.0 * PADDING) / (frame.text_height(DETAILS) * MONO_ADVANCE)) as usize;
    let mut lines: Vec<String> = problems.iter().take(LISTED).flat_map(|problem| wrapped(problem, columns, 4)).collect();
    let more = problems.len().saturating_sub(LISTED);
    if more > 0 {
        lines.push(format!("and {more} more"));
    }
    let [text, line] = [TEXT, DETAILS].map(|size| frame.text_height(size) * LINE);
    (Area::new(left, PADDING, width, text + 1.5 * PADDING + lines.len() as f32 * line), lines)
}

/// What became of the level's files, at the window's top.
fn draw_news(news: &News, canvas: &Canvas) {
    let (words, colour) = match news {
        News::Changed(_, true) => ("Read again: you fly on in it, with help. R restarts it.", theme::good()),
        News::Changed(_, false) => ("Read again, from its start.", theme::good()),
        News::Unfinished(_) => ("Flown as far as it goes. What is left:", theme::accent()),
        News::Broken(_) => ("The files do not load now: you fly on in what was there.", theme::bad()),
    };
    let (panel, lines) = news_panel(news, canvas.frame());
    widgets::curtain(canvas, 0.0);
    widgets::panel_in(canvas, panel, theme::panel().faded(0.95), colour);
    let top = panel.min + Vec2::new(PADDING, 0.75 * PADDING);
    canvas.text(words, top, Style::new(TEXT, colour));
    for (i, words) in lines.iter().enumerate() {
        let at = top + Vec2::new(0.0, canvas.line_height(TEXT) + i as f32 * canvas.line_height(DETAILS));
        canvas.text(words, at, Style::new(DETAILS, theme::text()).mono());
    }
}
