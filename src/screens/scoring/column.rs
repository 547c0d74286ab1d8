//! The column of the result: what came of the flight, its medals, the parts of its score.

use super::{MAIN, ROW, Scoring, width};
use crate::draw::layout::{BUTTON_TEXT, DETAILS, GRID, HEADING, TEXT, TITLE, Vec2};
use crate::number::{clock, hundredths, whole_hundredths};
use crate::{draw::Colour, draw::Style, game::Outcome, game::goals, ui::Ui, view::theme, view::widgets, words::tr};

/// The middles of its lines from the canvas' top: the outcome, the level's title, the time, the first goal, the score's first part, the remark.
const LINES: [f32; 6] = [40.0, 76.0, 144.0, 212.0, 340.0, 532.0];
const RADIUS: f32 = 14.0;
/// Points count up within this time, s; earned medals are stamped from the first time on, one after the other, each within the last one, and
/// begin that much larger.
const COUNT: f64 = 0.45;
const STAMPS: [f64; 3] = [0.3, 0.16, 0.14];
const LARGER: f64 = 1.6;

impl Scoring {
    /// The age of the stamp of the medal with this place among the earned ones, s; negative before it.
    fn stamp(&self, place: usize) -> f64 {
        self.shown - STAMPS[0] - place as f64 * STAMPS[1]
    }

    pub(super) fn stamps(&self) -> usize {
        let earned = goals(&self.attempt.level.awards, &self.result).iter().filter(|goal| goal.missing.is_none()).count();
        (0..earned).filter(|place| self.stamp(*place) >= STAMPS[2]).count()
    }

    /// Points as they are shown: they count up.
    fn counted(&self, points: i64) -> i64 {
        let part = (self.shown / COUNT).min(1.0);
        (points as f64 * (1.0 - (1.0 - part).powi(3))).round() as i64
    }

    /// The times that the flight's own is measured against; a level without medals for time has its optimal time.
    fn measures(&self) -> String {
        let (awards, optimal) = (&self.attempt.level.awards, Some(self.result.optimal_time));
        let limit = |limit: f64| whole_hundredths(limit) as f64 / 100.0;
        let medals = [(tr("gold"), awards.gold.map(limit)), (tr("silver"), awards.silver.map(limit))];
        let none = medals.iter().all(|(_, time)| time.is_none());
        let times = medals.into_iter().chain([(tr("optimal"), optimal.filter(|_| none)), (tr("best"), self.best)]);
        let words: Vec<String> = times.filter_map(|(name, time)| Some(format!("{name} {}", clock(time?)))).collect();
        words.join(" · ")
    }

    /// The parts of the score: what each is, what was reached, what that is measured against, and points.
    fn parts(&self) -> [(&'static str, String, String, i64); 4] {
        let (result, score) = (&self.result, &self.result.score);
        let (met, all) = (result.objectives_met, result.objectives_all);
        [
            (tr("Objectives met"), format!("{met}/{all}"), String::new(), score.base),
            (tr("Time"), clock(result.time), self.measures(), score.time),
            (tr("Damaging collisions"), result.collisions.to_string(), tr("−500 each").into(), score.collisions),
            (tr("Fuel left"), format!("{:.0} %", result.fuel * 100.0), tr("full bonus from 50 %").into(), score.fuel),
        ]
    }

    fn show_parts(&self, ui: &Ui<'_>, left: f32) {
        let right = left + width(&ui.frame());
        let text = ui.frame().text_height(DETAILS);
        // Large words begin higher, so that all of them end above the buttons.
        let mut y = LINES[4] - (1.6 * (text - DETAILS)).clamp(0.0, 24.0);
        for (i, (words, reached, measure, points)) in self.parts().into_iter().enumerate() {
            let lost = i == 0 && self.result.outcome != Outcome::Completed;
            let style = Style::new(TEXT, if lost { theme::bad() } else { effect(points) }).middle();
            let number = style.mono().right();
            ui.text(words, Vec2::new(left, y), style);
            ui.text(&signed(self.counted(points)), Vec2::new(right, y), number);
            let reached_at = right - ui.canvas().width("+00000", number) - GRID;
            ui.text(&reached, Vec2::new(reached_at, y), number);
            if !measure.is_empty() {
                y += (0.6 * ROW).max(1.02 * text);
                let quiet = Style::new(DETAILS, theme::quiet()).middle();
                ui.text(&widgets::cut(ui.canvas(), &measure, width(&ui.frame()), quiet), Vec2::new(left, y), quiet);
            }
            y += 0.85 * ROW;
        }
        let total = Style::new(BUTTON_TEXT, theme::text()).middle();
        ui.text(tr("Score"), Vec2::new(left, y), total);
        ui.text(&self.counted(self.result.score.total).to_string(), Vec2::new(right, y), total.mono().right());
    }

    /// What the level offers: what each goal asks for, and whether it is earned or what is missing. Earned medals slam in.
    fn show_goals(&self, ui: &Ui<'_>, left: f32) {
        let mut earned = 0;
        for (i, goal) in goals(&self.attempt.level.awards, &self.result).iter().enumerate() {
            let middle = Vec2::new(left + RADIUS, LINES[3] + i as f32 * ROW);
            let stamp = if goal.missing.is_none() { self.stamp(earned) / STAMPS[2] } else { -1.0 };
            earned += usize::from(goal.missing.is_none());
            if stamp < 1.0 {
                widgets::draw(ui.canvas(), goal.prize, false, middle, RADIUS);
            }
            if stamp >= 0.0 {
                let size = 1.0 + LARGER * (1.0 - stamp.min(1.0)).powi(2);
                widgets::draw(ui.canvas(), goal.prize, true, middle, RADIUS * size as f32);
            }
            let (words, colour) =
                goal.missing.as_deref().map_or((tr("earned"), theme::good()), |missing| (missing, theme::quiet()));
            let missing = Style::new(DETAILS, colour).middle().right();
            ui.text(words, Vec2::new(left + width(&ui.frame()), middle.y), missing);
            let asks = Style::new(TEXT, theme::text()).middle();
            let room = width(&ui.frame()) - 2.0 * RADIUS - 2.0 * GRID - ui.canvas().width(words, missing);
            ui.text(&widgets::cut(ui.canvas(), &goal.asks, room, asks), middle + Vec2::new(RADIUS + GRID, 0.0), asks);
        }
    }

    pub(super) fn show_column(&self, ui: &mut Ui<'_>, left: f32) {
        let level = &self.attempt.level;
        let completed = self.result.outcome == Outcome::Completed;
        let line = |i: usize| Vec2::new(left, LINES[i]);
        let (words, colour) = if completed { (tr("Level complete"), theme::good()) } else { (tr("Attempt lost"), theme::bad()) };
        ui.text(words, line(0), Style::new(TEXT, colour).middle());
        let title = if level.title == level.name { tr!("Level {level}", level = level.name) } else { tr(&level.title).to_owned() };
        let style = Style::new(HEADING, theme::text()).middle();
        ui.text(&widgets::cut(ui.canvas(), &title, width(&ui.frame()), style), line(1), style);
        let hundredths = hundredths(self.result.time);
        let (words, time) =
            (format!("{}.{:02}", hundredths / 100, hundredths % 100), Style::new(TITLE, theme::text()).mono().middle());
        let time =
            if ui.canvas().width(&words, time) > width(&ui.frame()) - HEADING { Style { size: HEADING, ..time } } else { time };
        ui.text(&words, line(2), time);
        let behind = Vec2::new(ui.canvas().width(&words, time) + GRID, 0.0);
        ui.text("s", line(2) + behind, Style::new(BUTTON_TEXT, theme::quiet()).middle());
        self.show_goals(ui, left);
        self.show_parts(ui, left);
        let saved = self.saved_for.as_ref().map(|player| tr!("Saved for {player}.", player));
        let remark = saved.unwrap_or_else(|| self.remark.clone());
        let quiet = Style::new(DETAILS, theme::quiet()).middle();
        let pitch = ui.canvas().line_height(DETAILS).min(26.0);
        let room = ((MAIN - LINES[5]) / pitch).ceil() as usize;
        for (i, words) in widgets::lines(ui.canvas(), &remark, width(&ui.frame()), quiet).iter().take(room).enumerate() {
            ui.text(words, line(5) + Vec2::new(0.0, i as f32 * pitch), quiet);
        }
    }
}

fn effect(points: i64) -> Colour {
    match points {
        1.. => theme::good(),
        0 => theme::text(),
        _ => theme::bad(),
    }
}

/// A number with its sign; the minus is a true one.
fn signed(points: i64) -> String {
    match points {
        1.. => format!("+{points}"),
        0 => "0".into(),
        _ => format!("−{}", points.unsigned_abs()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signs_read_well() {
        assert_eq!([-500, 0, 940].map(signed), ["−500", "0", "+940"]);
    }
}
