//! Draws what a flight tells above the game: how its time goes, what became of the level's files, the pause panel.

use super::{Flight, News, PAUSE_LABELS, PAUSE_TOP};
use crate::game::Outcome;
use crate::view::canvas::{Canvas, Style};
use crate::view::layout::{Area, DETAILS, Frame, HEADING, HudLayout, LINE, PADDING, TEXT, Vec2, WIDE_BUTTON, text_room};
use crate::view::{theme, widgets};

/// From the canvas' foot to what is told above the fuel bar.
const ABOVE_FUEL: f32 = 52.0;
/// What a test flight says.
const TEST: &str = "A test flight: Esc or F5 leads back to the editor";

impl Flight {
    /// How the time goes, where it does not go as it does, and what leads on where it has ended and stays: above the fuel bar.
    fn draw_time(&self, canvas: &Canvas) {
        let Some((words, area)) = self.time_sign(canvas.frame()) else { return };
        widgets::panel(canvas, area);
        canvas.text(&words, area.centre(), Style::new(TEXT, theme::accent()).middle().centred());
    }

    /// Its words and its place.
    fn time_sign(&self, frame: &Frame) -> Option<(String, Area)> {
        let kept = self.game.outcome() != Outcome::Running && self.instruments.stays() && !self.observer.frozen();
        let ended = kept.then(|| "The flight has ended: Enter leads on".to_owned());
        let words = ended.or_else(|| self.observer.words())?;
        let size = text_room(&words, frame.text_height(TEXT)) + Vec2::new(2.0, 1.0) * PADDING;
        // A test flight has its words there.
        let above = if self.test { 1.5 * ABOVE_FUEL } else { ABOVE_FUEL };
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
        let news = self.news.as_ref().map(|news| news_area(news, frame));
        // What is varied is told beside the status, in as many lines as it takes.
        let status = HudLayout::new(frame).status;
        let width = frame.size.x - status.max().x;
        let varied = self.variation().map(|_| Area::new(status.max().x, status.min.y, width, status.size.y));
        signs.chain(news).chain(varied).chain(self.instruments.areas(frame)).collect()
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
        if let Some(settings) = &self.settings {
            widgets::curtain(canvas, 1.0);
            return settings.draw(canvas);
        }
        let Some(pause) = &self.pause else { return self.draw_time(canvas) };
        widgets::curtain(canvas, 0.45);
        let middle = canvas.size() / 2.0;
        let top = middle.y - PAUSE_TOP - HEADING - 2.5 * PADDING;
        let bottom = pause.areas().last().map_or(middle.y, |last| last.max().y) + 1.5 * PADDING;
        let width = WIDE_BUTTON.x + 4.0 * PADDING;
        let panel = Area::new(middle.x - width / 2.0, top, width, bottom - top);
        widgets::panel(canvas, panel);
        widgets::heading(canvas, "Paused", panel.min.y + PADDING + HEADING * 0.65);
        for (i, area) in pause.areas().iter().enumerate() {
            widgets::button(canvas, *area, PAUSE_LABELS[i], pause.hover() == Some(i), pause.focus() == i);
        }
    }
}

/// The most problems that are listed above a flight.
const LISTED: usize = 6;

/// How far the box with time and speed reaches.
const BESIDE: f32 = 290.0;

/// The panel with what became of the level's files.
fn news_area(news: &News, frame: &Frame) -> Area {
    let problems = if let News::Broken(problems) = news { problems.len() } else { 0 };
    let lines = problems.min(LISTED) + usize::from(problems > LISTED);
    // Beside the box with time and speed, which grows with the words.
    let left = 16.0 + BESIDE * frame.text.max(1.0);
    let room = frame.size.x - left - PADDING;
    let width = if problems == 0 { room.min(560.0) } else { room };
    let [text, line] = [TEXT, DETAILS].map(|size| frame.text_height(size) * LINE);
    Area::new(left, PADDING, width, text + 1.5 * PADDING + lines as f32 * line)
}

/// What became of the level's files, at the window's top.
fn draw_news(news: &News, canvas: &Canvas) {
    let (words, colour, problems): (&str, _, &[String]) = match news {
        News::Changed(_, true) => ("Read anew: you fly on in it, with help. R restarts it.", theme::good(), &[]),
        News::Changed(_, false) => ("Read anew, from its start.", theme::good(), &[]),
        News::Broken(problems) => ("The files do not load now: you fly on in what was there.", theme::bad(), problems),
    };
    let line = canvas.line_height(DETAILS);
    let more = problems.len().saturating_sub(LISTED);
    let panel = news_area(news, canvas.frame());
    widgets::curtain(canvas, 0.0);
    widgets::panel_in(canvas, panel, theme::faded(theme::panel(), 0.95), colour);
    let top = panel.min + Vec2::new(PADDING, 0.75 * PADDING);
    canvas.text(words, top, Style::new(TEXT, colour));
    for (i, problem) in problems.iter().take(LISTED).enumerate() {
        let at = top + Vec2::new(0.0, canvas.line_height(TEXT) + i as f32 * line);
        canvas.text(
            &widgets::cut(canvas, problem, panel.size.x - 2.0 * PADDING, Style::new(DETAILS, theme::text()).mono()),
            at,
            Style::new(DETAILS, theme::text()).mono(),
        );
    }
    if more > 0 {
        let at = top + Vec2::new(0.0, canvas.line_height(TEXT) + LISTED as f32 * line);
        canvas.text(&format!("and {more} more"), at, Style::new(DETAILS, theme::quiet()).mono());
    }
}
