//! What an attempt came to, part by part.

use crate::draw::layout::{Area, BUTTON_TEXT, DETAILS, Frame, GRID, HEADING, ROW_BUTTON, TEXT, TITLE, Vec2};
use crate::draw::{Canvas, Colour, Style};
use crate::game::{Game, GhostTrack, Inputs, Outcome, RunResult, goals};
use crate::number::{clock, fixed, hundredths, whole_hundredths};
use crate::scores::Name;
use crate::screens::players::PlayerList;
use crate::screens::screen::{AboveGame, Destination, Finished, GameScene, Noise, Purpose, Request, Screen};
use crate::session::Session;
use crate::session::attempt::{Attempt, Flown};
use crate::session::recordings::{self, FlightCandidate, Visit};
use crate::settings::{Action, Key};
use crate::ui::input::Input;
use crate::ui::pace::Motion;
use crate::ui::{Spectator, Ui, WidgetKind};
use crate::view::camera::Viewport;
use crate::view::hud::Aside;
use crate::view::{Overlays, theme, widgets};
use crate::words::tr;
use std::rc::Rc;

/// For how long the keys of menus do nothing on a page that has just opened, s: a key that was meant for the flight goes down about so late.
const GUARD: f64 = 0.4;
/// What steers the ship.
const STEERING: [Action; 4] = [Action::Thrust, Action::Reverse, Action::Left, Action::Right];
/// The keys of menus that may steer, too.
const MENU_KEYS: [Key; 5] = [Key::Left, Key::Right, Key::Up, Key::Down, Key::Enter];
/// The words on the buttons.
const NEXT: &str = "Next";
const AGAIN: &str = "Again";
const WATCH: &str = "Watch";
const BOARD: &str = "Board";
/// A guest's score waits for a name.
const SAVE: &str = "Save Score";

/// The column of the result at the right: its width, and from it to the canvas' edges and to the scene.
const WIDTH: f32 = 360.0;
const EDGE: f32 = 40.0;
/// The middles of its lines from the canvas' top: the world, the level's title, the time, the first goal, the first part of the score and the
/// remark; and from row to row.
const LINES: [f32; 6] = [40.0, 76.0, 144.0, 212.0, 340.0, 532.0];
const ROW: f32 = 32.0;
/// The buttons: the one where most go on, and those below it.
const MAIN: f32 = 580.0;
const SMALL: f32 = 36.0;
/// A medal's radius.
const RADIUS: f32 = 14.0;
/// Two flights are known this much further in a frame, ticks: a millisecond or two.
const TICKS_A_FRAME: u64 = 120;
/// Width of a path, and a rival's dashes, canvas units; ticks from one corner of a path to the next.
const PATH: f32 = 3.0;
const DASHES: [f32; 2] = [6.0, 5.0];
const CORNER: usize = 6;
/// Points count up within this time, s; earned medals are stamped from the first time on, one after the other, each within the last one, and
/// begin that much larger.
const COUNT: f64 = 0.45;
const STAMPS: [f64; 3] = [0.3, 0.16, 0.14];
const LARGER: f64 = 1.6;
/// By then the view has opened and all medals are there, s.
const OPENS: f64 = 2.0;

/// The scoring screen.
#[derive(Debug)]
pub struct Scoring {
    attempt: Attempt,
    result: RunResult,
    /// The name of the level after this one.
    next: Option<String>,
    /// What it brought the player, or why it brought nothing; in words.
    remark: String,
    /// Whether the score waits for a name, and which one it got.
    nameless: bool,
    saved_for: Option<Name>,
    /// For how long the page has been there, s, and whether no key that steers has been held at a moment since.
    shown: f64,
    /// Whether a medal was stamped in the last frame.
    stamped: bool,
    released: bool,
    /// The player's best time in the level, this flight included, s.
    best: Option<f64>,
    /// The flight, where it was flown by hand.
    flown: Option<Rc<Flown>>,
    /// The level as the flight has left it.
    end: Box<Game>,
    /// The path of the flight, then that of the best rival, with whose it is.
    paths: Vec<(String, GhostTrack)>,
}

impl Scoring {
    pub fn open(Finished { attempt, result, flown, remark, end }: Finished, session: &Session) -> Self {
        let next = session.library.after(&result.level);
        let best = session.journal.best(&result.level);
        let nameless = session.nameless().any(|(board, _)| board == result.level);
        let own = flown.iter().map(|flown| (tr("you").to_owned(), flown.replay.inputs.clone()));
        let raced = attempt.rivals.first().map(|rival| (rival.name.clone(), (*rival.inputs).clone()));
        let gold = || recordings::for_gold(&session.library.folder(&result.level), &attempt.level);
        let rival = raced.or_else(|| Some((tr("Gold").to_owned(), gold()?.inputs)));
        let path = |(whose, inputs): (String, Inputs)| Some((whose, GhostTrack::new(attempt.level.clone(), &inputs).ok()?));
        let paths = own.chain(rival).filter_map(path).collect();
        let (shown, stamped, released) = (0.0, false, false);
        Self { attempt, result, next, remark, nameless, saved_for: None, shown, stamped, released, best, flown, end, paths }
    }

    /// What the attempt came to.
    pub fn result(&self) -> &RunResult {
        &self.result
    }

    /// Where most go on first: to the next level after a success, to another try after a failure.
    fn labels(&self) -> Vec<&'static str> {
        let (next, watch) = (self.next.is_some(), self.flown.is_some());
        let mut all = [(NEXT, next), (AGAIN, true), (WATCH, watch), (BOARD, true), (SAVE, self.nameless)];
        if self.result.outcome != Outcome::Completed {
            all.swap(0, 1);
        }
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

    fn again(&self) -> Request {
        Request::Reset(Destination::Fly(self.attempt.clone()))
    }

    /// Where the level was chosen.
    fn list(&self) -> Destination {
        let level = &self.attempt.level;
        if level.experiment { Destination::Lab(Some(level.name.clone())) } else { Destination::Levels(Purpose::Play) }
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
        let right = left + WIDTH;
        let mut y = LINES[4];
        for (i, (words, reached, measure, points)) in self.parts().into_iter().enumerate() {
            let lost = i == 0 && self.result.outcome != Outcome::Completed;
            let style = Style::new(TEXT, if lost { theme::bad() } else { effect(points) }).middle();
            let number = style.mono().right();
            ui.text(words, Vec2::new(left, y), style);
            ui.text(&signed(self.counted(points)), Vec2::new(right, y), number);
            let reached_at = right - ui.canvas().width("+00000", number) - GRID;
            ui.text(&reached, Vec2::new(reached_at, y), number);
            if !measure.is_empty() {
                y += 0.6 * ROW;
                ui.text(&measure, Vec2::new(left, y), Style::new(DETAILS, theme::quiet()).middle());
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
            ui.text(&goal.asks, middle + Vec2::new(RADIUS + GRID, 0.0), Style::new(TEXT, theme::text()).middle());
            let (words, colour) =
                goal.missing.as_deref().map_or((tr("earned"), theme::good()), |missing| (missing, theme::quiet()));
            ui.text(words, Vec2::new(left + WIDTH, middle.y), Style::new(DETAILS, colour).middle().right());
        }
    }

    /// At the foot of the scene: whose the paths are, and how efficient the solution was.
    fn show_figures(&self, ui: &Ui<'_>) {
        let result = &self.result;
        let figures = [
            (tr("Fuel used"), result.fuel_used, tr("units")),
            (tr("Distance flown"), result.distance, "m"),
            (tr("Top speed"), result.top_speed, "m/s"),
            (tr("Peak resultant force"), result.peak_resultant, "N"),
        ];
        let words = figures.map(|(label, value, unit)| format!("{label} {} {unit}", fixed(value, 1))).join(" · ");
        let mut at = Vec2::new(EDGE, ui.frame().size.y - EDGE);
        ui.text(&words, at, Style::new(DETAILS, theme::quiet()).middle());
        at.y -= ROW;
        for (i, (whose, _)) in self.paths.iter().enumerate() {
            let colour = self.colour(i);
            ui.canvas().dashed(
                &[at, at + Vec2::new(32.0, 0.0)],
                if colour == theme::accent() { &[64.0, 0.0] } else { &DASHES },
                PATH,
                colour,
            );
            let style = Style::new(DETAILS, colour).middle();
            ui.text(whose, at + Vec2::new(40.0, 0.0), style);
            at.x += 64.0 + ui.canvas().width(whose, style);
        }
    }

    /// The colour of a path.
    fn colour(&self, path: usize) -> Colour {
        if path == 0 && self.flown.is_some() { theme::accent() } else { theme::text().faded(0.7) }
    }

    /// What came of the flight, from the top of the column down.
    fn show_column(&self, ui: &mut Ui<'_>, left: f32) {
        let level = &self.attempt.level;
        let completed = self.result.outcome == Outcome::Completed;
        let line = |i: usize| Vec2::new(left, LINES[i]);
        let (words, colour) = if completed { (tr("Level complete"), theme::good()) } else { (tr("Attempt lost"), theme::bad()) };
        ui.text(words, line(0), Style::new(TEXT, colour).middle());
        let title = if level.title == level.name { tr!("Level {level}", level = level.name) } else { tr(&level.title).to_owned() };
        let style = Style::new(HEADING, theme::text()).middle();
        ui.text(&widgets::cut(ui.canvas(), &title, WIDTH, style), line(1), style);
        let hundredths = hundredths(self.result.time);
        let (words, time) =
            (format!("{}.{:02}", hundredths / 100, hundredths % 100), Style::new(TITLE, theme::text()).mono().middle());
        let time = if ui.canvas().width(&words, time) > WIDTH - HEADING { Style { size: HEADING, ..time } } else { time };
        ui.text(&words, line(2), time);
        let behind = Vec2::new(ui.canvas().width(&words, time) + GRID, 0.0);
        ui.text("s", line(2) + behind, Style::new(BUTTON_TEXT, theme::quiet()).middle());
        self.show_goals(ui, left);
        self.show_parts(ui, left);
        let saved = self.saved_for.as_ref().map(|player| tr!("Saved for {player}.", player));
        let remark = saved.unwrap_or_else(|| self.remark.clone());
        let quiet = Style::new(DETAILS, theme::quiet()).middle();
        for (i, words) in widgets::lines(ui.canvas(), &remark, WIDTH, quiet).iter().take(3).enumerate() {
            ui.text(words, line(5) + Vec2::new(0.0, i as f32 * ui.canvas().line_height(DETAILS)), quiet);
        }
    }

    /// The button where most go on, and the others below it; the label of the pressed one.
    fn show_buttons(&self, ui: &mut Ui<'_>, left: f32) -> Option<&'static str> {
        let labels = self.labels();
        let main = Area::new(left, MAIN, WIDTH, ROW_BUTTON.y);
        let touch = ui.touch(labels[0], main, WidgetKind::Button);
        ui.canvas().rounded(main, GRID, if touch.hover { theme::accent() } else { theme::accent().faded(0.9) });
        if touch.focus {
            widgets::focus_ring(ui.canvas(), main.inset(-3.0));
        }
        // As in flight: this key flies again.
        let again = ui.input().settings.keys.label(Action::Restart);
        let named = |label: &str| if label == AGAIN { format!("{again}  {}", tr(label)) } else { tr(label).to_owned() };
        let style = Style::new(BUTTON_TEXT, theme::ground()).middle();
        ui.text(&named(labels[0]), Vec2::new(left + 2.0 * GRID, main.centre().y), style);
        let mut pressed = touch.pressed.then_some(labels[0]);
        let (mut at, third) = (main.min + Vec2::new(0.0, main.size.y + 0.75 * GRID), (WIDTH - 2.0 * GRID) / 3.0);
        for label in &labels[1..] {
            let wide = if *label == SAVE { WIDTH } else { third };
            if at.x + wide > left + WIDTH + 1.0 || *label == SAVE {
                at = Vec2::new(left, at.y + SMALL + GRID / 2.0);
            }
            let area = Area { min: at, size: Vec2::new(wide, SMALL) };
            if ui.small_button((label, &named(label)), area, Style::new(TEXT, theme::text()).centred()) {
                pressed = Some(label);
            }
            at.x += wide + GRID;
        }
        pressed
    }
}

impl AboveGame for Scoring {
    fn draw_in_level(&self, _: f64, view: &Viewport, canvas: &Canvas) {
        for (i, (_, track)) in self.paths.iter().enumerate().rev() {
            let ticks = (0..=track.ticks()).step_by(CORNER).chain([track.ticks()]);
            let corners: Vec<Vec2> = ticks.map(|tick| view.point(track.pose(tick, 1.0).centre)).collect();
            let colour = self.colour(i);
            if colour == theme::accent() {
                corners.windows(2).for_each(|ends| canvas.line(ends[0], ends[1], PATH, colour));
            } else {
                canvas.dashed(&corners, &DASHES, PATH - 1.0, colour);
            }
        }
    }

    fn draw_beside_timer(&self, _: &Aside, _: &Canvas) {}
}

impl Screen for Scoring {
    fn show(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        self.guard(ui);
        let ticks = if ui.input().frame_time > 0.0 { TICKS_A_FRAME } else { 0 };
        self.paths.iter_mut().for_each(|(_, track)| track.fly(ticks));
        let size = ui.frame().size;
        let left = size.x - WIDTH - EDGE;
        ui.canvas().rectangle(Area::new(left - EDGE, 0.0, WIDTH + 2.0 * EDGE, size.y), theme::ground());
        self.show_figures(ui);
        self.show_column(ui, left);
        let pressed = self.show_buttons(ui, left);
        if ui.key(Key::Escape) {
            return Some(Request::Reset(self.list()));
        }
        if ui.acts(Action::Restart) {
            return Some(self.again());
        }
        Some(match pressed? {
            AGAIN => self.again(),
            NEXT => Request::Reset(Destination::Play(self.next.clone()?)),
            SAVE => Request::Push(Destination::Players),
            pressed => {
                let visit = Visit { flown: self.flown.clone(), ..Visit::of(&self.result.level) };
                match &self.flown {
                    Some(flown) if pressed == WATCH => Request::Push(Destination::Watch(visit, FlightCandidate::just_flown(flown))),
                    _ => Request::Push(Destination::Board(visit)),
                }
            }
        })
    }

    fn come_back(&mut self, above: &dyn Screen, session: &mut Session, spectator: &mut dyn Spectator) {
        spectator.begins(&self.end);
        self.nameless = session.nameless().any(|(board, _)| board == self.result.level);
        if above.is::<PlayerList>() && !self.nameless {
            match session.write_scores().into_iter().next() {
                Some(problem) => self.remark = problem,
                None => self.saved_for = Some(session.journal.current().clone()),
            }
        }
    }

    fn scene(&self, frame: &Frame) -> Option<GameScene<'_>> {
        let room = Frame { size: frame.size - Vec2::new(WIDTH + 2.0 * EDGE, 0.0), ..*frame };
        Some(GameScene {
            game: &self.end,
            alpha: 1.0,
            room,
            overlays: Overlays { map: true, watched: true, ..Overlays::default() },
            // What the end has set going comes to its end.
            speed: 1.0,
            paused: false,
            quiet: true,
            ghosts: Vec::new(),
            panels: Vec::new(),
            above: self,
        })
    }

    /// Medals come, paths grow, the view opens.
    fn motion(&self, _: &Input) -> Motion {
        let grows = self.paths.iter().any(|(_, track)| !track.is_whole());
        if self.shown < OPENS || grows { Motion::Full } else { Motion::Still }
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
