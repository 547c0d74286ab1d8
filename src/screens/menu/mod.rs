//! The main menu: who plays, where the ship hovers over the buttons, and a little game: a right click drops a ball. The question before the window
//! closes while something is neither saved nor kept: what would be lost, and whether to stay.

use super::flight::Flight;
use super::screen::{Destination, GameScene, Purpose, Request, Screen};
use crate::draw::layout::{Area, Frame, GRID, PADDING, ROW_BUTTON, TEXT, TITLE, Vec2, words_box, words_width};
use crate::draw::{Canvas, Colour, Style};
use crate::physics::{DVec2, ForceKind};
use crate::session::worker::{Brought, Errand, Ticket};
use crate::ui::pace::{self, Motion};
use crate::ui::{Spectator, Ui, input::Input, prompt::Problems};
use crate::view::{camera::CanvasWindow, camera::Viewport, scale, theme, things, widgets};
use crate::{scores::Name, session::Session, settings::Key, words::tr};
use balls::{Balls, METRE};
use std::path::Path;

mod balls;
pub mod credits;

const LABELS: [&str; 6] = ["Play", "Levels", "Boards", PLAYERS, MORE, LAST];
const PLAYERS: &str = "Players";
/// Leads to those of the second column.
const MORE: &str = "More";
const FURTHER: [&str; 6] = ["Lab", "Classics", "Editor", "Settings", "Credits", "Back"];
/// A page has no end of its own.
const LAST: &str = if cfg!(all(feature = "window", browser)) { "Your data" } else { "Quit" };
/// From the canvas' top to the middle of the title's capitals, of the canvas' height.
const TITLE_AT: f32 = 0.115;
/// What the title says, and the height of its letters, which reach below no line, in heights of its text.
const NAME: &str = "Resultant";
const TITLE_HEIGHT: f32 = 0.74;
/// What the foot says where nothing is wrong, the middle of its line from the canvas' foot, and its room beside the buttons there.
const HINT: &str = "Right click to drop a ball";
const FOOT: f32 = 32.0;
const BESIDE_FOOT: f32 = 640.0;
/// From the canvas' top to the first button, of the canvas' height.
const BUTTONS_AT: f32 = 0.3;
/// Opacity of the ground between the flight behind the buttons and all that is above it.
const VEIL: f32 = 0.7;
/// From the canvas' edges to the button in its lower right corner.
const CORNER: f32 = 24.0;
/// The arrows around the title, whose sum is the one beneath it: how far each leads on, of the title's width and of its height (upwards).
const ADDENDS: [(ForceKind, Vec2); 5] = [
    (ForceKind::Drive, Vec2::new(-0.1, 1.1)),
    (ForceKind::Wind, Vec2::new(0.34, 0.5)),
    (ForceKind::Reaction, Vec2::new(0.32, 0.1)),
    (ForceKind::AirResistance, Vec2::new(0.38, -0.45)),
    (ForceKind::Weight, Vec2::new(0.06, -1.25)),
];

#[derive(Debug)]
pub struct Menu {
    /// The level that Play opens, by name and title: the first one that the player has not done; `None` until it is found.
    next: Option<(String, String)>,
    player: Name,
    trouble: Option<String>,
    more: bool,
    chosen: &'static str,
    balls: Balls,
    behind: Option<Box<Flight>>,
    /// The boxes of the lines of words beside the buttons, the title's last.
    pub lines: Vec<Area>,
}

impl Menu {
    /// The menu for the present player; the worker brings the level that Play opens.
    pub fn open(session: &mut Session) -> Self {
        session.menus += 1;
        session.journal.try_again();
        let unsaved = session.write_scores().into_iter().next();
        let names = session.library.names();
        let (open, done): (Vec<&String>, Vec<&String>) =
            names.iter().partition(|name| session.journal.medals(name).medal.is_none());
        // Of a level that is not done a flight for gold would tell too much; but the first one has to begin somehow.
        let shown = done.get(session.menus as usize % done.len().max(1)).or(open.first());
        let shown = shown.map(|name| session.library.folder(name));
        let folders = open.into_iter().chain(done).map(|name| session.library.folder(name)).collect();
        session.worker.ask(Errand::First(folders, session.library.root().to_path_buf(), shown));
        let player = session.journal.current().clone();
        let trouble = session.journal.trouble().map(str::to_owned).or(unsaved);
        // How balls fly follows from the number of the menu and from when they are dropped.
        let balls = Balls::new(session.menus);
        Self { next: None, player, trouble, more: false, chosen: LABELS[0], balls, behind: None, lines: Vec::new() }
    }

    /// Whether ship and balls hold still: nobody has touched anything for long, or the player is elsewhere.
    fn rests(&self, input: &Input) -> bool {
        input.away || input.idle >= pace::REST
    }

    /// The boxes of the balls, as they are drawn.
    pub fn balls(&self) -> Vec<Area> {
        self.balls.areas().collect()
    }

    /// The ship's centre (canvas units), its angle (degrees) and how its engine burns (0 … 1), as they are drawn.
    pub fn ship(&self) -> Option<(Vec2, f64, f64)> {
        let (centre, angle, burning) = self.balls.ship()?;
        Some(((centre * f64::from(METRE)).as_vec2(), angle, burning))
    }

    /// The name, and the arrows that add up to the one beneath it.
    fn show_title(ui: &Ui<'_>) -> Area {
        let (canvas, frame) = (ui.canvas(), ui.frame());
        let size = Vec2::new(words_width(NAME, TITLE), TITLE_HEIGHT * TITLE);
        let area = Area::around(Vec2::new(frame.size.x / 2.0, (frame.size.y * TITLE_AT).round()), size);
        let size = area.size + Vec2::new(2.0 * PADDING, 0.0);
        let start = Vec2::new(area.min.x - PADDING, area.max().y + 6.0);
        let end = start + Vec2::new(size.x, 0.0);
        let mut tail = start;
        for (kind, step) in ADDENDS {
            let tip = tail + Vec2::new(step.x, -step.y) * size;
            scale::draw_one(canvas, (tail, tip), scale::ArrowKind::Force(kind), 0.9);
            tail = tip;
        }
        canvas.end_layer();
        scale::draw_one(canvas, (start, end), scale::ArrowKind::Resultant, 1.0);
        canvas.text(NAME, area.centre(), Style::new(TITLE, theme::accent()).centred().middle());
        canvas.end_layer();
        area
    }

    /// The title of the level that Play opens, and who plays, beside their buttons.
    fn show_beside(&self, ui: &Ui<'_>, column: &[Area]) -> Vec<Area> {
        let words = LABELS.iter().zip(column).filter_map(|(label, button)| match *label {
            _ if self.more => None,
            "Play" => Some((tr(&self.next.as_ref()?.1), button)),
            PLAYERS => Some((self.player.as_str(), button)),
            _ => None,
        });
        let show = |(words, button): (&str, &Area)| {
            let from = Vec2::new(button.max().x + 2.0 * PADDING, button.centre().y);
            ui.text(words, from, Style::new(TEXT, theme::quiet()).middle());
            words_box(words, ui.frame().text_height(TEXT), from)
        };
        words.map(show).collect()
    }

    fn show_foot(&self, ui: &Ui<'_>) -> Area {
        let (size, height) = (ui.frame().size, ui.frame().text_height(TEXT));
        let (words, colour) = self.trouble.as_deref().map_or((tr(HINT), theme::quiet()), |trouble| (trouble, theme::bad()));
        let (middle, widest) = (Vec2::new(size.x / 2.0, size.y - FOOT), size.x - BESIDE_FOOT);
        widgets::fitted(ui.canvas(), words, middle, widest, &[TEXT], colour);
        let mut area = words_box(words, height, middle);
        area.size.x = area.size.x.min(widest);
        area.min.x = middle.x - area.size.x / 2.0;
        area
    }

    fn draw_ship(&self, canvas: &Canvas, frame: &Frame) {
        let Some((centre, angle, burning)) = self.balls.ship() else { return };
        let window = CanvasWindow { size: frame.size.as_dvec2(), pixel: f64::from(frame.pixel) };
        let metre = f64::from(METRE);
        let view = Viewport::new(DVec2::ZERO, DVec2::ZERO, window.size / metre, metre, window);
        let pose = things::ShipPose { centre, angle, squash: 0.0, light: Colour::WHITE, room: f64::INFINITY };
        things::draw_ship(&pose, (burning, 1.0), 0.5, &view, canvas);
    }
}

impl Screen for Menu {
    fn show(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        let frame = ui.frame();
        match &self.behind {
            Some(_) => ui.canvas().rectangle(frame.area(), theme::ground().faded(VEIL)),
            None => widgets::graph_paper(ui.canvas()),
        }
        let labels = if self.more { FURTHER } else { LABELS };
        let column = frame.column(labels.len(), (frame.size.y * BUTTONS_AT / GRID).round() * GRID);
        ui.wrap();
        ui.start_at(self.chosen);
        let pressed = ui.buttons(column.clone(), &labels);
        let again = Area { min: frame.size - CORNER - ROW_BUTTON, size: ROW_BUTTON };
        // The menu that opens then has tried once more to save what waits.
        if self.trouble.is_some() && ui.button("Try again", again) {
            return Some(Request::Reset(Destination::Menu));
        }
        self.lines = self.show_beside(ui, &column);
        self.lines.push(self.show_foot(ui));
        self.lines.push(Self::show_title(ui));
        // Balls bounce off all that is drawn, and the ship flies around it.
        let drawn: Vec<Area> = column.into_iter().chain(self.lines.iter().copied()).collect();
        let frame_time = if self.rests(ui.input()) { 0.0 } else { ui.input().frame_time };
        if let Some(flight) = &mut self.behind {
            flight.play_behind(frame_time);
        }
        self.balls.update(&Input { frame_time, ..ui.input().clone() }, &drawn);
        self.balls.draw(ui.canvas());
        self.draw_ship(ui.canvas(), &frame);
        let pressed = if self.more && ui.key(Key::Escape) { Some("Back") } else { pressed.filter(|_| !ui.key(Key::Escape)) };
        self.chosen = pressed.unwrap_or(self.chosen);
        // Quit is a button, so that no one leaves by one key too many.
        Some(Request::Push(match pressed? {
            MORE | "Back" => {
                (self.more, self.chosen) = (!self.more, if self.more { MORE } else { FURTHER[0] });
                ui.focus(None);
                return None;
            }
            "Play" => match &self.next {
                Some((name, _)) => return Some(Request::Reset(Destination::Play(name.clone()))),
                None => Destination::Levels(Purpose::Play),
            },
            "Levels" => Destination::Levels(Purpose::Play),
            "Boards" => Destination::Levels(Purpose::Leaderboard),
            PLAYERS => Destination::Players,
            "Editor" => return Some(Request::Reset(Destination::Levels(Purpose::Edit))),
            "Credits" => Destination::Credits,
            "Classics" => Destination::Classics(None),
            "Lab" => Destination::Lab(None),
            "Settings" => Destination::Settings,
            #[cfg(all(feature = "window", browser))]
            LAST => Destination::PageData,
            _ => return Some(Request::Quit),
        }))
    }

    fn receive(&mut self, _: Ticket, brought: Brought, _: &mut Session, spectator: &mut dyn Spectator) {
        if let Brought::First(next, gold) = brought {
            self.next = next;
            self.behind = gold.map(|gold| Box::new(Flight::watch(String::new(), *gold, spectator)));
        }
    }

    fn come_back(&mut self, _: &dyn Screen, session: &mut Session, _: &mut dyn Spectator) {
        *self = Self { more: self.more, chosen: self.chosen, ..Self::open(session) };
    }

    fn scene(&self, frame: &Frame) -> Option<GameScene<'_>> {
        self.behind.as_ref()?.scene_behind(frame)
    }

    fn motion(&self, input: &Input) -> Motion {
        if self.rests(input) { Motion::Still } else { Motion::Easy }
    }
}

/// Loses nothing: Enter presses it, and Esc does the same.
const STAY: &str = "Stay here";
const AGAIN: &str = "Try again";
const ANYWAY: &str = "Close anyway";

#[derive(Debug)]
pub struct Closing {
    losses: Problems,
    failed: bool,
}

impl Closing {
    /// What would be lost, a line each, and whether some of that could not be written.
    pub fn new(losses: Vec<String>, failed: bool) -> Self {
        Self { losses: Problems::new(tr("This is not saved, and would be lost").to_owned(), losses), failed }
    }
}

impl Screen for Closing {
    fn show(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        widgets::graph_paper(ui.canvas());
        let answers = if self.failed { &[STAY, AGAIN, ANYWAY][..] } else { &[STAY, ANYWAY] };
        let answer = self.losses.answer(ui, answers);
        if ui.key(Key::Escape) || answer == Some(STAY) {
            return Some(Request::Pop);
        }
        answer.map(|answer| if answer == AGAIN { Request::Quit } else { Request::QuitAnyway })
    }

    fn tune(&self) -> Option<&str> {
        None
    }

    fn takes(&self, _: &Path) -> bool {
        false
    }
}
