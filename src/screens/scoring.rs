//! What an attempt came to, part by part.

pub mod save_score;

use crate::draw::layout::{Area, BUTTON_TEXT, DETAILS, HEADING, ROW_BUTTON, TEXT, Vec2};
use crate::draw::{Colour, Style};
use crate::game::{Outcome, RunResult, goals};
use crate::number::{clock, whole_hundredths};
use crate::scores::{subject, unsaved_points};
use crate::screens::screen::{Destination, Effect, Finished, Gain, Noise, Onward, Request, Screen};
use crate::session::Session;
use crate::session::attempt::{Attempt, Flown};
use crate::session::recordings::Visit;
use crate::settings::{Action, Key};
use crate::ui::input::Input;
use crate::ui::{Spectator, Ui};
use crate::view::{theme, widgets};
use crate::words::tr;
use std::rc::Rc;

/// For how long the keys of menus do nothing on a page that has just opened, s: a key that was meant for the flight goes down about so late.
const GUARD: f64 = 0.4;
/// What steers the ship.
const STEERING: [Action; 4] = [Action::Thrust, Action::Reverse, Action::Left, Action::Right];
/// The keys of menus that may steer, too.
const MENU_KEYS: [Key; 5] = [Key::Left, Key::Right, Key::Up, Key::Down, Key::Enter];
/// The words on the buttons.
const AGAIN: &str = "Try Again";
const NEXT: &str = "Next Level";
const SAVE: &str = "Save Score";
const FLIGHTS: &str = "Flights";
const MENU: &str = "Main Menu";

/// The panel of the parts and where its columns stand, from its left edge; from row to row.
const PANEL: Vec2 = Vec2::new(880.0, 248.0);
const COLUMNS: [f32; 3] = [24.0, 320.0, 344.0];
const ROW: f32 = 44.0;
/// From one panel to the next.
const BETWEEN: f32 = 10.0;
/// The panels of the medals and of the figures, and from row to row of the latter.
const MEDALS: f32 = 68.0;
const FIGURES: f32 = 96.0;
const FIGURE: f32 = 40.0;
/// A medal's radius.
const RADIUS: f32 = 18.0;
/// Points count up within this time, s; earned medals are stamped from the first time on, one after the other, each within the last one, and
/// begin that much larger.
const COUNT: f64 = 0.45;
const STAMPS: [f64; 3] = [0.3, 0.16, 0.14];
const LARGER: f64 = 1.6;

/// The scoring screen.
#[derive(Debug)]
pub struct Scoring {
    attempt: Attempt,
    result: RunResult,
    /// The name of the level after this one.
    next: Option<String>,
    /// What it brought the player, or why it brought nothing; in words.
    remark: String,
    /// For how long the page has been there, s, and whether no key that steers has been held at a moment since.
    shown: f64,
    /// Whether a medal was stamped in the last frame.
    stamped: bool,
    released: bool,
    /// The player's best time in the level, this flight included, s.
    best: Option<f64>,
    /// The flight, where it was flown by hand.
    flown: Option<Rc<Flown>>,
}

impl Scoring {
    pub fn open(Finished { attempt, result, flown, remark }: Finished, session: &Session) -> Self {
        let next = session.library.after(&result.level);
        let best = session.journal.best(&result.level);
        Self { attempt, result, next, remark, shown: 0.0, stamped: false, released: false, best, flown }
    }

    /// What the attempt came to.
    pub fn result(&self) -> &RunResult {
        &self.result
    }

    /// Only a flight by hand and without help can be saved.
    fn saves(&self) -> bool {
        self.result.score.total > 0 && self.attempt.inputs.is_none() && !self.result.assisted
    }

    fn labels(&self) -> Vec<&'static str> {
        let all = [(AGAIN, true), (NEXT, self.next.is_some()), (SAVE, self.saves()), (FLIGHTS, true), (MENU, true)];
        all.into_iter().filter(|(_, there)| *there).map(|(label, _)| label).collect()
    }

    /// The keys of the flight do not move the focus: those of menus count once the page has stood for a moment and none that steers has been
    /// held since the flight.
    fn guard(&mut self, ui: &mut Ui<'_>) {
        let input: &Input = ui.input();
        if input.frame_time > 0.0 {
            let before = self.stamps();
            self.shown += input.frame_time;
            self.stamped = self.stamps() > before;
        }
        self.released |= !STEERING.into_iter().any(|action| input.keeps(action));
        if self.shown < GUARD || !self.released {
            ui.claim(MENU_KEYS);
        }
    }

    /// The age of the stamp of the medal with this place among the earned ones, s; negative before it.
    fn stamp(&self, place: usize) -> f64 {
        self.shown - STAMPS[0] - place as f64 * STAMPS[1]
    }

    /// The number of stamps so far.
    fn stamps(&self) -> usize {
        let earned = goals(&self.attempt.level.awards, &self.result).iter().filter(|goal| goal.missing.is_none()).count();
        (0..earned).filter(|place| self.stamp(*place) >= STAMPS[2]).count()
    }

    /// Points as they are shown: they count up.
    fn counted(&self, points: i64) -> i64 {
        let part = (self.shown / COUNT).min(1.0);
        (points as f64 * (1.0 - (1.0 - part).powi(3))).round() as i64
    }

    fn flights(&self) -> Request {
        Request::Push(Destination::Flights(Visit { level: self.result.level.clone(), flown: self.flown.clone(), chosen: None }))
    }

    fn again(&self) -> Request {
        Request::Reset(Destination::Fly(self.attempt.clone()))
    }

    /// The score, and where the leaderboard leads on once it is saved.
    fn gain(&self) -> Gain {
        let next = self.next.clone().map(|next| Onward { label: NEXT, to: Request::Reset(Destination::Play(next)) });
        // What is saved can be watched and raced from its row.
        let more = [(AGAIN, self.again()), (FLIGHTS, self.flights()), (MENU, Request::Reset(Destination::Menu))];
        Gain {
            board: self.result.level.clone(),
            subject: subject(&self.result.level, &self.attempt.level.title),
            points: self.result.score.total,
            flown: self.flown.clone(),
            onward: next.into_iter().chain(more.map(|(label, to)| Onward { label, to })).collect(),
        }
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

    fn show_parts(&self, ui: &Ui<'_>, panel: Area) {
        ui.panel(panel);
        let quiet = Style::new(TEXT, theme::quiet()).middle();
        let [label, value, beside] = COLUMNS.map(|column| panel.min.x + column);
        let right = panel.max().x - 24.0;
        let mut y = panel.min.y + 34.0;
        for (i, (words, reached, measure, points)) in self.parts().into_iter().enumerate() {
            let lost = i == 0 && self.result.outcome != Outcome::Completed;
            let style = Style::new(TEXT, if lost { theme::bad() } else { effect(points) }).middle();
            ui.text(words, Vec2::new(label, y), style);
            ui.text(&reached, Vec2::new(value, y), style.mono().right());
            ui.text(&measure, Vec2::new(beside, y), quiet);
            ui.text(&signed(self.counted(points)), Vec2::new(right, y), style.mono().right());
            y += ROW;
        }
        ui.canvas().line(Vec2::new(label, y - 20.0), Vec2::new(right, y - 20.0), 1.0, theme::panel_edge());
        let total = Style::new(BUTTON_TEXT, theme::text()).middle();
        ui.text(tr("Score"), Vec2::new(label, y + 8.0), total);
        ui.text(&self.counted(self.result.score.total).to_string(), Vec2::new(right, y + 8.0), total.mono().right());
    }

    /// What the level offers, side by side: what each goal asks for, and whether it is earned or what is missing.
    fn show_goals(&self, ui: &Ui<'_>, panel: Area) {
        ui.panel(panel);
        let goals = goals(&self.attempt.level.awards, &self.result);
        let wide = panel.size.x / goals.len().max(1) as f32;
        let mut earned = 0;
        for (i, goal) in goals.iter().enumerate() {
            let at = Vec2::new(panel.min.x + i as f32 * wide + 16.0, panel.centre().y);
            let middle = at + Vec2::new(RADIUS, 0.0);
            let stamp = if goal.missing.is_none() { self.stamp(earned) / STAMPS[2] } else { -1.0 };
            earned += usize::from(goal.missing.is_none());
            if stamp < 1.0 {
                widgets::draw(ui.canvas(), goal.prize, false, middle, RADIUS);
            }
            if stamp >= 0.0 {
                let size = 1.0 + LARGER * (1.0 - stamp.min(1.0)).powi(2);
                widgets::draw(ui.canvas(), goal.prize, true, middle, RADIUS * size as f32);
            }
            let room = wide - 2.0 * RADIUS - 32.0;
            let line = |text: &str, below: f32, colour| {
                let style = Style::new(TEXT, colour).middle();
                let size = if ui.canvas().width(text, style) > room { DETAILS } else { TEXT };
                ui.text(text, at + Vec2::new(2.0 * RADIUS + 12.0, below), Style { size, ..style });
            };
            line(&goal.asks, -13.0, theme::text());
            match &goal.missing {
                None => line(tr("earned"), 13.0, theme::good()),
                Some(missing) => line(missing, 13.0, theme::quiet()),
            }
        }
    }

    /// How efficient the solution was.
    fn show_figures(&self, ui: &Ui<'_>, panel: Area) {
        ui.panel(panel);
        let result = &self.result;
        let figures = [
            (tr("Fuel used"), result.fuel_used, tr("units")),
            (tr("Distance flown"), result.distance, "m"),
            (tr("Top speed"), result.top_speed, "m/s"),
            (tr("Peak resultant force"), result.peak_resultant, "N"),
        ];
        let quiet = Style::new(TEXT, theme::quiet()).middle();
        for (i, (label, value, unit)) in figures.into_iter().enumerate() {
            let left = panel.min.x + 24.0 + (i % 2) as f32 * PANEL.x / 2.0;
            let y = panel.min.y + 28.0 + (i / 2) as f32 * FIGURE;
            ui.text(label, Vec2::new(left, y), quiet);
            let number = Style::new(TEXT, theme::text()).mono().middle().right();
            ui.text(&format!("{value:.1}"), Vec2::new(left + 312.0, y), number);
            ui.text(unit, Vec2::new(left + 324.0, y), quiet);
        }
    }
}

impl Screen for Scoring {
    fn show(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        self.guard(ui);
        let size = ui.frame().size;
        let middle = size.x / 2.0;
        let completed = self.result.outcome == Outcome::Completed;
        widgets::graph_paper(ui.canvas());
        let (heading, colour) = if completed { (tr("Level complete"), theme::good()) } else { (tr("Attempt lost"), theme::bad()) };
        ui.fitted(heading, Vec2::new(middle, 44.0), &[HEADING], colour);
        let level = &self.attempt.level;
        let title = if level.title == level.name { tr!("Level {level}", level = level.name) } else { tr(&level.title).to_owned() };
        ui.fitted(&title, Vec2::new(middle, 88.0), &[TEXT], theme::quiet());
        let top = ((size.y - 720.0) / 2.0).max(0.0) + 116.0;
        let parts = Area::new(middle - PANEL.x / 2.0, top, PANEL.x, PANEL.y);
        let below = |area: Area, height| Area::new(area.min.x, area.max().y + BETWEEN, PANEL.x, height);
        let offers = below(parts, MEDALS);
        let figures = below(offers, FIGURES);
        self.show_parts(ui, parts);
        self.show_goals(ui, offers);
        self.show_figures(ui, figures);
        ui.fitted(&self.remark, Vec2::new(middle, figures.max().y + 30.0), &[TEXT], theme::quiet());
        let labels = self.labels();
        // Where most go on: to the next level after a success, to another try after a failure.
        ui.start_at(if completed { labels[1] } else { AGAIN });
        let top = size.y - ROW_BUTTON.y - 40.0;
        let pressed = ui.row(top, &labels);
        if let Some(again) = ui.frame().row(labels.len(), top).first() {
            // As in flight: this key flies again.
            let at = Vec2::new(again.min.x + 16.0, again.centre().y);
            ui.text(
                &ui.input().settings.keys.label(Action::Restart),
                at,
                Style::new(TEXT, theme::accent()).mono().middle().centred(),
            );
        }
        if ui.key(Key::Escape) {
            return Some(Request::Reset(Destination::Menu));
        }
        if ui.acts(Action::Restart) {
            return Some(self.again());
        }
        Some(match pressed? {
            AGAIN => self.again(),
            NEXT => Request::Reset(Destination::Play(self.next.clone()?)),
            SAVE => Request::Do(Effect::SaveScore(self.gain(), None)),
            FLIGHTS => self.flights(),
            _ => Request::Reset(Destination::Menu),
        })
    }

    fn unsaved(&self) -> Option<String> {
        let subject = || subject(&self.result.level, &self.attempt.level.title);
        self.saves().then(|| unsaved_points(self.result.score.total, &subject()))
    }

    fn carry_out(&mut self, effect: Effect, session: &mut Session, _: &mut dyn Spectator) -> Option<Request> {
        save_score::save_as_player(effect, session)
    }

    fn noises(&self) -> Vec<Noise> {
        self.stamped.then_some(Noise::Landing(0.8)).into_iter().collect()
    }

    fn tune(&self) -> Option<&str> {
        None
    }
}

/// The colour of a part that brought those points.
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
