//! Signs above a flight: the pace of its time, a test flight, the loss of the attempt before, a varied level, changed files.

use super::Flight;
use crate::draw::layout::{Area, Frame, GRID, PADDING, TEXT, Vec2, text_room};
use crate::draw::{Canvas, Style};
use crate::game::Outcome;
use crate::settings::Action;
use crate::view::hud::HudLayout;
use crate::view::{theme, widgets};
use crate::words::tr;

/// From the canvas' foot to a sign above the fuel bar.
const ABOVE_FUEL: f32 = 52.0;
const TEST: &str = "A test flight: Esc or F5 leads back to the editor";

/// Its size with the space around the words.
fn sign_size(words: &str, frame: &Frame) -> Vec2 {
    text_room(words, frame.text_height(TEXT)) + Vec2::new(2.0, 1.0) * PADDING
}

impl Flight {
    /// The sign of a pace other than the usual one, or of an ended flight that stays: words and place at the flight's foot.
    fn time_sign(&self, frame: &Frame) -> Option<(String, Area)> {
        let stays = self.run.game.outcome() != Outcome::Running && self.seen.instruments.stays() && !self.seen.observer.frozen();
        let ended = stays.then(|| tr("The flight has ended: Enter leads on").to_owned());
        let words = ended
            .or_else(|| self.start_words())
            .or_else(|| self.seen.observer.words(self.run.game.ticks(), self.run.game.tick_rate()));
        let words = words.or_else(|| self.rewind_words(self.seen.observer.keys()))?;
        let size = sign_size(&words, frame);
        let top = self.seen.instruments.room(frame).size.y - self.time_room(frame);
        Some((words, Area { min: Vec2::new((frame.size.x - size.x) / 2.0, top), size }))
    }

    /// Of an experiment that stands at its start.
    fn start_words(&self) -> Option<String> {
        let waits = self.seen.observer.frozen() && self.run.game.ticks() == 0 && !self.run.game.level().ship_plays();
        let [freeze, pause] = [Action::Freeze, Action::Pause].map(|action| self.seen.observer.keys().label(action));
        let sheet = || if self.open.sheet.is_some() { tr!(" · [{pause}] your sheet", pause) } else { String::new() };
        waits.then(|| tr!("[{freeze}] starts the experiment", freeze) + &sheet())
    }

    /// From the foot of the flight up to the top of that sign, whether there is one or not.
    pub(super) fn time_room(&self, frame: &Frame) -> f32 {
        let above = match (self.open.test, self.run.game.level().ship_plays()) {
            // The words on a test flight stand there.
            (true, _) => 1.5 * ABOVE_FUEL,
            (false, true) => ABOVE_FUEL,
            (false, false) => GRID,
        };
        above + sign_size("", frame).y
    }

    /// The place of the words on a test flight.
    fn test_sign(&self, frame: &Frame) -> Option<Area> {
        let at = Vec2::new(frame.size.x / 2.0, self.seen.instruments.room(frame).size.y - ABOVE_FUEL);
        self.open.test.then(|| Area::around(at, text_room(tr(TEST), frame.text_height(TEXT))))
    }

    /// The sign of the loss of the attempt before, below the row of the timer, away from the usual starts of ships.
    fn lost_sign(&self, frame: &Frame) -> Option<(String, Area)> {
        let death = self.lost().filter(|_| self.open.news.is_none())?;
        let hint = if self.offers_hint() { tr(" · Esc: hint") } else { "" };
        let words = tr!("{death} · Enter: the result{hint}", death, hint);
        let size = sign_size(&words, frame);
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
        let status = HudLayout::new(frame).status;
        let width = frame.size.x - status.max().x;
        let varied = self.variation().map(|_| Area::new(status.max().x, status.min.y, width, status.size.y));
        signs.chain(news).chain(lost).chain(varied).chain(instruments).collect()
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
        let lost = self.lost_sign(canvas.frame()).map(|(words, area)| (words, area, theme::panel().faded(0.9)));
        let time = self.time_sign(canvas.frame()).map(|(words, area)| (words, area, theme::panel()));
        for (words, area, fill) in lost.into_iter().chain(time) {
            canvas.end_layer();
            widgets::panel_in(canvas, area, fill, theme::panel_edge());
            canvas.text(&words, area.centre(), Style::new(TEXT, theme::accent()).middle().centred());
        }
    }
}
