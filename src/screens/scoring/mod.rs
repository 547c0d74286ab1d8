//! What an attempt came to, part by part.

mod column;
mod forces;

use crate::draw::layout::{Area, BUTTON_TEXT, DETAILS, Frame, GRID, ROW_BUTTON, TEXT, Vec2};
use crate::draw::{Canvas, Colour, Style};
use crate::game::{Game, GhostTrack, Inputs, Outcome, RunResult};
use crate::screens::screen::{AboveGame, Destination, Finished, GameScene, Noise, Purpose, Request, Screen};
use crate::session::recordings::{self, FlightCandidate, Visit};
use crate::ui::{Spectator, Ui, WidgetKind, input::Input, pace::Motion};
use crate::view::{Overlays, camera::Viewport, hud::Aside, theme, widgets};
use crate::{number::fixed, scores::Name, session::Session, words::tr};
use crate::{screens::players::PlayerList, session::library::Attempt, session::library::Flown, settings::Action, settings::Key};
use forces::ShipForces;
use std::rc::Rc;

/// For how long the keys of menus do nothing on a page that has just opened, s: a key that was meant for the flight goes down about so late.
const GUARD: f64 = 0.4;
const STEERING: [Action; 4] = [Action::Thrust, Action::Reverse, Action::Left, Action::Right];
/// The keys of menus that may steer, too.
const MENU_KEYS: [Key; 5] = [Key::Left, Key::Right, Key::Up, Key::Down, Key::Enter];
const NEXT: &str = "Next";
const AGAIN: &str = "Again";
const WATCH: &str = "Watch";
const BOARD: &str = "Board";
/// A guest's score waits for a name.
const SAVE: &str = "Save Score";

/// The column of the result at the right: its width, also in heights of the text, and from it to the canvas' edges and to the scene.
const WIDTH: f32 = 360.0;
const WIDTH_IN_TEXT: f32 = 19.5;
const EDGE: f32 = 40.0;
const ROW: f32 = 32.0;
/// The buttons: the one where most go on, and those below it.
const MAIN: f32 = 580.0;
const SMALL: f32 = 36.0;
/// Two flights are known this much further in a frame, ticks: a millisecond or two.
const TICKS_A_FRAME: u64 = 120;
/// Width of a path, and a rival's dashes, canvas units; ticks from one corner of a path to the next.
const PATH: f32 = 3.0;
const DASHES: [f32; 2] = [6.0, 5.0];
const CORNER: usize = 6;
/// By then the view has opened and all medals are there, s.
const OPENS: f64 = 2.0;

fn width(frame: &Frame) -> f32 {
    WIDTH.max(WIDTH_IN_TEXT * frame.text_height(DETAILS))
}

#[derive(Debug)]
pub struct Scoring {
    attempt: Attempt,
    pub result: RunResult,
    next: Option<String>,
    /// What it brought the player, or why it brought nothing; in words.
    remark: String,
    /// Whether the score waits for a name, and which one it got.
    nameless: bool,
    saved_for: Option<Name>,
    /// For how long the page has been there, s, and whether no key that steers has been held at a moment since.
    shown: f64,
    stamped: bool,
    released: bool,
    /// The player's best time in the level, this flight included, s.
    best: Option<f64>,
    /// The flight, where it was flown by hand.
    flown: Option<Rc<Flown>>,
    end: Box<Game>,
    /// The path of the flight, then that of the best rival, with whose it is.
    paths: Vec<(String, GhostTrack)>,
    /// The moment of the flight that shows most forces, as far as its path is known.
    moment: Option<ShipForces>,
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
        Self {
            attempt,
            result,
            next,
            remark,
            nameless,
            saved_for: None,
            shown,
            stamped,
            released,
            best,
            flown,
            end,
            paths,
            moment: None,
        }
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

    /// Keys of menus count once the page has stood for a moment and none that steers has been held since the flight.
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

    fn again(&self) -> Request {
        Request::Reset(Destination::Fly(self.attempt.clone()))
    }

    fn figures(&self, canvas: &Canvas, room: f32) -> Vec<String> {
        let result = &self.result;
        let figures = [
            (tr("Fuel used"), result.fuel_used, tr("units")),
            (tr("Distance flown"), result.distance, "m"),
            (tr("Top speed"), result.top_speed, "m/s"),
            (tr("Peak resultant force"), result.peak_resultant, "N"),
        ];
        let words = figures.map(|(label, value, unit)| format!("{label} {} {unit}", fixed(value, 1))).join(" · ");
        widgets::lines(canvas, &words, room, Style::new(DETAILS, theme::quiet()).middle())
    }

    /// At the foot of the scene: whose the paths are, and how efficient the solution was.
    fn show_figures(&self, ui: &Ui<'_>) {
        let mut at = Vec2::new(EDGE, ui.frame().size.y - EDGE);
        let style = Style::new(DETAILS, theme::quiet()).middle();
        for line in self.figures(ui.canvas(), ui.frame().size.x - width(&ui.frame()) - 4.0 * EDGE).iter().rev() {
            ui.text(line, at, style);
            at.y -= ROW;
        }
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

    fn colour(&self, path: usize) -> Colour {
        if path == 0 && self.flown.is_some() { theme::accent() } else { theme::text().faded(0.7) }
    }

    /// The button where most go on, and the others below it; the label of the pressed one.
    fn show_buttons(&self, ui: &mut Ui<'_>, left: f32) -> Option<&'static str> {
        let labels = self.labels();
        let width = width(&ui.frame());
        let main = Area::new(left, MAIN, width, ROW_BUTTON.y);
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
        let small = Style::new(TEXT, theme::text()).centred();
        let canvas = ui.canvas();
        let least = |label: &&str| canvas.width(&named(label), small) + 2.0 * GRID;
        let beside = || labels[1..].iter().filter(|label| **label != SAVE);
        // Thirds, where their words fit.
        let third = (width - 2.0 * GRID) / 3.0;
        let spare = (width + GRID - beside().map(|label| least(label) + GRID).sum::<f32>()) / beside().count().max(1) as f32;
        let equal = beside().all(|label| least(label) <= third);
        let mut at = main.min + Vec2::new(0.0, main.size.y + 0.75 * GRID);
        for label in &labels[1..] {
            let wide = match *label {
                SAVE => width,
                _ if equal => third,
                _ => least(label) + spare.max(0.0),
            };
            if at.x + wide > left + width + 1.0 || *label == SAVE {
                at = Vec2::new(left, at.y + SMALL + GRID / 2.0);
            }
            let area = Area { min: at, size: Vec2::new(wide, SMALL) };
            if ui.small_button((label, &named(label)), area, small) {
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
        let size = canvas.size();
        let lines = self.figures(canvas, size.x - 2.0 * EDGE).len() as f32;
        self.draw_forces(size - Vec2::new(EDGE, EDGE + (lines + 1.0) * ROW), view, canvas);
    }

    fn draw_beside_timer(&self, _: &Aside, _: &Canvas) {}
}

impl Screen for Scoring {
    fn show(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        self.guard(ui);
        let ticks = if ui.input().frame_time > 0.0 { TICKS_A_FRAME } else { 0 };
        let (own, moment) = (self.flown.is_some(), &mut self.moment);
        for (i, (_, track)) in self.paths.iter_mut().enumerate() {
            track.fly(ticks, |game| {
                if own && i == 0 {
                    ShipForces::note(moment, game);
                }
            });
        }
        let size = ui.frame().size;
        let left = size.x - width(&ui.frame()) - EDGE;
        ui.canvas().rectangle(Area::new(left - EDGE, 0.0, size.x - left + EDGE, size.y), theme::ground());
        self.show_figures(ui);
        self.show_column(ui, left);
        let pressed = self.show_buttons(ui, left);
        if ui.key(Key::Escape) {
            let lab = self.attempt.level.experiment.then(|| Destination::Lab(Some(self.attempt.level.name.clone())));
            return Some(Request::Reset(lab.unwrap_or(Destination::Levels(Purpose::Play))));
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
        let room = Frame { size: frame.size - Vec2::new(width(frame) + 2.0 * EDGE, 0.0), ..*frame };
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

    fn motion(&self, _: &Input) -> Motion {
        let grows = self.paths.iter().any(|(_, track)| !track.is_whole());
        let forces_stand = self.moment.as_ref().map_or(0.0, ShipForces::whole);
        if self.shown < OPENS.max(forces_stand) || grows { Motion::Full } else { Motion::Still }
    }

    fn noises(&self) -> Vec<Noise> {
        self.stamped.then_some(Noise::Landing(0.8)).into_iter().collect()
    }

    fn tune(&self) -> Option<&str> {
        None
    }
}
