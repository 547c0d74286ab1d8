//! What an attempt came to, part by part.

use super::leaderboard::{Way, subject};
use super::{Attempt, Buttons, Flown, Gain, Input, Key, Keys, Request, Visit};
use crate::game::{Goal, Outcome, RunResult, goals};
use crate::number::{clock, whole_hundredths};
use crate::settings::Action;
use crate::view::layout::ROW_BUTTON;
use std::rc::Rc;

/// What a part did to the score.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effect {
    /// It helped.
    Helped,
    /// It cost.
    Cost,
    /// It changed nothing.
    Nothing,
}

impl Effect {
    fn of(points: i64) -> Self {
        match points {
            1.. => Self::Helped,
            0 => Self::Nothing,
            _ => Self::Cost,
        }
    }
}

/// A line of the score.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part {
    /// What it is.
    pub label: &'static str,
    /// What was reached.
    pub value: String,
    /// What it is measured against, if anything.
    pub beside: String,
    /// Points, with their sign.
    pub points: String,
    /// What it did.
    pub effect: Effect,
}

/// A button of this screen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Press {
    /// The level again.
    Replay,
    /// The level after it.
    NextLevel,
    /// A name for the score.
    SaveScore,
    /// What was flown: to watch it, keep it, race it.
    Flights,
    /// The main menu.
    MainMenu,
}

impl Press {
    /// The words on it.
    pub const fn label(self) -> &'static str {
        match self {
            Self::Replay => "Try Again",
            Self::NextLevel => "Next Level",
            Self::SaveScore => "Save Score",
            Self::Flights => "Flights",
            Self::MainMenu => "Main Menu",
        }
    }
}

/// For how long the keys of menus do nothing on a page that has just opened, s: a key that was meant for the flight goes down about so late.
const GUARD: f64 = 0.4;
/// What steers the ship.
const STEERING: [Action; 4] = [Action::Thrust, Action::Reverse, Action::Left, Action::Right];
/// The keys of menus that may steer, too.
const MENU_KEYS: [Key; 5] = [Key::Left, Key::Right, Key::Up, Key::Down, Key::Enter];

/// They, and the buttons of gamepads that do the same.
fn menu_keys() -> Keys {
    MENU_KEYS.into_iter().chain(MENU_KEYS.into_iter().filter_map(Key::on_pad)).collect()
}

/// The scoring screen.
#[derive(Debug)]
pub struct Scoring {
    attempt: Attempt,
    result: RunResult,
    /// The name of the level after this one.
    next: Option<String>,
    presses: Vec<Press>,
    buttons: Buttons,
    /// What it brought whoever flew, or why it brought nothing; in words.
    remark: String,
    /// For how long the page has been there, s, and whether no key that steers has been held at a moment since.
    shown: f64,
    released: bool,
    /// The player's best time in the level, this flight included, s.
    best: Option<f64>,
    /// The flight, where it was flown by hand.
    flown: Option<Rc<Flown>>,
}

impl Scoring {
    /// The screen for that result; `next` is the level after this one, and `remark` says what it brought. The keyboard is where most go on:
    /// on the next level after a success, on another try after a failure. Only what was flown by hand and without help can be saved.
    pub fn new(attempt: Attempt, result: RunResult, flown: Option<Rc<Flown>>, next: Option<String>, remark: String) -> Self {
        let mut presses = vec![Press::Replay];
        if next.is_some() {
            presses.push(Press::NextLevel);
        }
        if result.score.total > 0 && attempt.inputs.is_none() && !result.assisted {
            presses.push(Press::SaveScore);
        }
        presses.extend([Press::Flights, Press::MainMenu]);
        let onward = if result.outcome == Outcome::Completed { presses[1] } else { Press::Replay };
        let focus = presses.iter().position(|press| *press == onward).unwrap_or(0);
        Self {
            attempt,
            result,
            next,
            presses,
            buttons: Buttons::focused_on(focus),
            remark,
            shown: 0.0,
            released: false,
            best: None,
            flown,
        }
    }

    /// One frame. The keys of the flight do not move the keyboard: those of menus count once the page has stood for a moment and none that
    /// steers is held since the flight.
    pub fn update(&mut self, input: &Input) -> Option<Request> {
        self.shown += input.frame_time;
        self.released |= !STEERING.into_iter().any(|action| input.keeps(action));
        let fresh = self.shown < GUARD || !self.released;
        let input = &if fresh { Input { pressed: input.pressed.less(menu_keys()), ..input.clone() } } else { input.clone() };
        self.buttons.place(input.frame.row(self.presses.len(), input.frame.size.y - ROW_BUTTON.y - 40.0));
        if input.pressed(Key::Escape) {
            return Some(Request::Menu);
        }
        // As in flight: one key, and the ship flies again.
        if input.acts(Action::Restart) {
            return Some(Request::Attempt(self.attempt.clone()));
        }
        Some(match self.presses[self.buttons.update(input)?] {
            Press::Replay => Request::Attempt(self.attempt.clone()),
            Press::NextLevel => Request::Play(self.next.clone()?),
            Press::SaveScore => Request::SaveScore(self.gain()),
            Press::Flights => Request::Flights(Visit {
                level: self.result.level.clone(),
                flown: self.flown.clone(),
                back: Box::new(self.again()),
            }),
            Press::MainMenu => Request::Menu,
        })
    }

    /// This screen once more.
    fn again(&self) -> Request {
        Request::Score(self.attempt.clone(), self.result.clone(), self.flown.clone())
    }

    /// The score, and where the leaderboard leads on once it is saved.
    fn gain(&self) -> Gain {
        let next = self.next.clone().map(|next| Way { label: Press::NextLevel.label(), to: Request::Play(next) });
        let again = Way { label: Press::Replay.label(), to: Request::Attempt(self.attempt.clone()) };
        let menu = Way { label: Press::MainMenu.label(), to: Request::Menu };
        // What is saved can be watched and raced from its row.
        let board = Box::new(Request::Leaderboard(self.result.level.clone()));
        let visit = Visit { level: self.result.level.clone(), flown: self.flown.clone(), back: board };
        let flights = Way { label: Press::Flights.label(), to: Request::Flights(visit) };
        Gain {
            board: self.result.level.clone(),
            subject: subject(&self.result.level, &self.attempt.level.title),
            points: self.result.score.total,
            flown: self.flown.clone(),
            back: Box::new(self.again()),
            ways: next.into_iter().chain([again, flights, menu]).collect(),
        }
    }

    /// What it brought whoever flew, or why it brought nothing.
    pub fn remark(&self) -> &str {
        &self.remark
    }

    /// What the attempt came to.
    pub fn result(&self) -> &RunResult {
        &self.result
    }

    /// The buttons that there are, in order.
    pub fn presses(&self) -> &[Press] {
        &self.presses
    }

    /// Where they are.
    pub fn buttons(&self) -> &Buttons {
        &self.buttons
    }

    /// With the player's best time in the level, s.
    #[must_use]
    pub fn with_best(self, best: Option<f64>) -> Self {
        Self { best, ..self }
    }

    /// The times that the flight's own is measured against; a level without medals for time has its optimal time.
    fn measures(&self) -> String {
        let (awards, optimal) = (&self.attempt.level.awards, Some(self.result.optimal_time));
        let limit = |limit: f64| whole_hundredths(limit) as f64 / 100.0;
        let medals = [("gold", awards.gold.map(limit)), ("silver", awards.silver.map(limit))];
        let none = medals.iter().all(|(_, time)| time.is_none());
        let times = medals.into_iter().chain([("optimal", optimal.filter(|_| none)), ("best", self.best)]);
        let words: Vec<String> = times.filter_map(|(name, time)| Some(format!("{name} {}", clock(time?)))).collect();
        words.join(" · ")
    }

    /// The parts of the score, a line each.
    pub fn parts(&self) -> Vec<Part> {
        let (result, score) = (&self.result, &self.result.score);
        let all_met = result.outcome == Outcome::Completed;
        let part = |label, value, beside, points, effect| Part { label, value, beside, points: signed(points), effect };
        vec![
            part(
                "Objectives met",
                format!("{}/{}", result.objectives_met, result.objectives_all),
                String::new(),
                score.base,
                if all_met { Effect::of(score.base) } else { Effect::Cost },
            ),
            part("Time", clock(result.time), self.measures(), score.time, Effect::of(score.time)),
            part(
                "Damaging collisions",
                result.collisions.to_string(),
                "−500 each".into(),
                score.collisions,
                Effect::of(score.collisions),
            ),
            part(
                "Fuel left",
                format!("{:.0} %", result.fuel * 100.0),
                "full bonus from 50 %".into(),
                score.fuel,
                Effect::of(score.fuel),
            ),
        ]
    }

    /// What the level offers, and how the flight stands to each.
    pub fn goals(&self) -> Vec<Goal> {
        goals(&self.attempt.level.awards, &self.result)
    }

    /// How efficient the solution was: label, value and unit.
    pub fn efficiency(&self) -> [(&'static str, String, &'static str); 4] {
        let result = &self.result;
        [
            ("Fuel used", format!("{:.1}", result.fuel_used), "units"),
            ("Distance flown", format!("{:.1}", result.distance), "m"),
            ("Top speed", format!("{:.1}", result.top_speed), "m/s"),
            ("Peak resultant force", format!("{:.1}", result.peak_resultant), "N"),
        ]
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

mod drawing {
    use super::{Effect, Scoring};
    use crate::draw::{Canvas, Style};
    use crate::game::Outcome;
    use crate::view::layout::{Area, BUTTON_TEXT, DETAILS, HEADING, TEXT, Vec2};
    use crate::view::{medals, theme, widgets};

    /// The panel and where its columns stand, from its left edge.
    const PANEL: Vec2 = Vec2::new(880.0, 248.0);
    const COLUMNS: [f32; 3] = [24.0, 320.0, 344.0];
    const ROW: f32 = 44.0;
    /// From one panel to the next.
    const BETWEEN: f32 = 10.0;
    /// The panels of the medals and of the figures, and from row to row of the latter.
    const MEDALS: f32 = 68.0;
    const FIGURES: f32 = 96.0;
    const FIGURE: f32 = 40.0;
    /// A medal, and from its edge to its words.
    const RADIUS: f32 = 18.0;

    impl Scoring {
        /// Draws the score and its parts.
        pub fn draw(&self, canvas: &Canvas) {
            widgets::graph_paper(canvas);
            let size = canvas.size();
            let completed = self.result.outcome == Outcome::Completed;
            let (heading, colour) = if completed { ("Level complete", theme::good()) } else { ("Attempt lost", theme::bad()) };
            let middle = size.x / 2.0;
            canvas.text(heading, Vec2::new(middle, 44.0), Style::new(HEADING, colour).centred().middle());
            let quiet = Style::new(TEXT, theme::quiet()).middle();
            let level = &self.attempt.level;
            let title = if level.title == level.name { format!("Level {}", level.name) } else { level.title.clone() };
            canvas.text(&title, Vec2::new(middle, 88.0), quiet.centred());

            let top = ((size.y - 720.0) / 2.0).max(0.0) + 116.0;
            let panel = Area::new((size.x - PANEL.x) / 2.0, top, PANEL.x, PANEL.y);
            widgets::panel(canvas, panel);
            let column = |i: usize| panel.min.x + COLUMNS[i];
            let right = panel.max().x - 24.0;
            for (i, part) in self.parts().iter().enumerate() {
                let y = panel.min.y + 34.0 + i as f32 * ROW;
                let colour = match part.effect {
                    Effect::Helped => theme::good(),
                    Effect::Cost => theme::bad(),
                    Effect::Nothing => theme::text(),
                };
                let words = Style::new(TEXT, colour).middle();
                canvas.text(part.label, Vec2::new(column(0), y), words);
                canvas.text(&part.value, Vec2::new(column(1), y), words.mono().right());
                canvas.text(&part.beside, Vec2::new(column(2), y), quiet);
                canvas.text(&part.points, Vec2::new(right, y), words.mono().right());
            }
            let y = panel.min.y + 34.0 + 4.0 * ROW + 8.0;
            canvas.line(Vec2::new(column(0), y - 28.0), Vec2::new(right, y - 28.0), 1.0, theme::panel_edge());
            let total = Style::new(BUTTON_TEXT, theme::text()).middle();
            canvas.text("Score", Vec2::new(column(0), y), total);
            canvas.text(&self.result.score.total.to_string(), Vec2::new(right, y), total.mono().right());

            let offers = Area::new(panel.min.x, panel.max().y + BETWEEN, PANEL.x, MEDALS);
            widgets::panel(canvas, offers);
            self.draw_goals(canvas, offers);

            let second = Area::new(panel.min.x, offers.max().y + BETWEEN, PANEL.x, FIGURES);
            widgets::panel(canvas, second);
            for (i, (label, value, unit)) in self.efficiency().iter().enumerate() {
                let left = second.min.x + if i % 2 == 0 { 24.0 } else { PANEL.x / 2.0 + 24.0 };
                let y = second.min.y + 28.0 + (i / 2) as f32 * FIGURE;
                canvas.text(label, Vec2::new(left, y), quiet);
                let number = Style::new(TEXT, theme::text()).mono().middle();
                canvas.text(value, Vec2::new(left + 312.0, y), number.right());
                canvas.text(unit, Vec2::new(left + 324.0, y), quiet);
            }
            let at = Vec2::new(middle, second.max().y + 30.0);
            widgets::fitted(canvas, &self.remark, at, size.x - 64.0, &[TEXT], theme::quiet());
            for (i, press) in self.presses.iter().enumerate() {
                let (hover, focus) = (self.buttons.hover() == Some(i), self.buttons.focus() == i);
                if let Some(area) = self.buttons.areas().get(i) {
                    widgets::button(canvas, *area, press.label(), hover, focus);
                }
            }
        }

        /// Draws what the level offers beside each other: what each asks for, and whether it is earned or what is missing.
        fn draw_goals(&self, canvas: &Canvas, panel: Area) {
            let goals = self.goals();
            let wide = panel.size.x / goals.len().max(1) as f32;
            for (i, goal) in goals.iter().enumerate() {
                let left = panel.min.x + i as f32 * wide + 16.0;
                let y = panel.centre().y;
                medals::draw(canvas, goal.prize, goal.missing.is_none(), Vec2::new(left + RADIUS, y), RADIUS);
                let words = Vec2::new(left + 2.0 * RADIUS + 12.0, wide - 2.0 * RADIUS - 32.0);
                let line = |text: &str, y: f32, colour| {
                    let style = Style::new(TEXT, colour).middle();
                    let size = if canvas.width(text, style) > words.y { DETAILS } else { TEXT };
                    canvas.text(text, Vec2::new(words.x, y), Style::new(size, colour).middle());
                };
                line(&goal.asks, y - 13.0, theme::text());
                match &goal.missing {
                    None => line("earned", y + 13.0, theme::good()),
                    Some(missing) => line(missing, y + 13.0, theme::quiet()),
                }
            }
        }
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
