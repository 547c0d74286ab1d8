//! The main menu: who plays, where the ship hovers over the buttons, and a little game: a right click drops a ball.

use super::balls::Balls;
use super::level_select::Purpose;
use super::{Buttons, Input, Key, Request, pace};
use crate::scores::Name;
use crate::view::layout::{Area, Frame, GRID, PADDING, ROW_BUTTON, TEXT, TITLE, Vec2, words_box, words_width};

/// The words on the buttons of the column, from top to bottom.
pub const LABELS: [&str; 7] = ["Play", "Level Select", "Leaderboards", "Classics", "Lab", "Settings", "Quit"];
/// From the canvas' top to the middle of the title's capitals, of the canvas' height.
const TITLE_AT: f32 = 0.115;
/// What the title says, and the height of its letters, which reach below no line, in heights of its text.
pub const NAME: &str = "Resultant";
const TITLE_HEIGHT: f32 = 0.74;
/// What the foot says where nothing is wrong, the middle of its line from the canvas' foot, and its room beside the buttons there.
pub const HINT: &str = "Right click to drop a ball";
const FOOT: f32 = 32.0;
const BESIDE_FOOT: f32 = 640.0;
/// From the canvas' top to the first button, of the canvas' height.
const BUTTONS_AT: f32 = 0.3;
/// From the canvas' edges to the buttons in its lower corners.
const CORNER: f32 = 24.0;
/// The button that says who plays.
const PLAYER_BUTTON: Vec2 = Vec2::new(288.0, 48.0);

/// What the menu says.
#[derive(Clone, Debug)]
pub struct Facts {
    /// The level that Play opens, by name and title: the first one that the player has not done; `None` until it is found.
    pub next: Option<(String, String)>,
    /// Who plays.
    pub player: Name,
    /// What is wrong with the players' files.
    pub trouble: Option<String>,
}

/// The main menu.
#[derive(Debug)]
pub struct Menu {
    facts: Facts,
    buttons: Buttons,
    /// What is written beside the buttons.
    lines: Vec<(Line, Area)>,
    balls: Balls,
}

/// A line of words that is no button's.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Line {
    /// Of the level that Play opens.
    Next,
    /// The hint, or what is wrong.
    Foot,
    /// The game's name.
    Title,
}

impl Menu {
    /// The menu. How balls fly follows from `seed` and from when they are dropped.
    pub fn new(facts: Facts, seed: u64) -> Self {
        Self { facts, buttons: Buttons::default(), lines: Vec::new(), balls: Balls::new(seed) }
    }

    /// One frame.
    pub fn update(&mut self, input: &Input) -> Option<Request> {
        self.buttons.place(places(&input.frame));
        self.lines = self.lines_in(&input.frame);
        let frame_time = if self.rests(input) { 0.0 } else { input.frame_time };
        self.balls.update(&Input { frame_time, ..input.clone() }, &self.drawn());
        if input.pressed(Key::Escape) {
            return None; // Quit is a button, so that no one leaves by one key too many.
        }
        Some(match self.buttons.update(input)? {
            0 => match &self.facts.next {
                Some((name, _)) => Request::Play(name.clone()),
                None => Request::LevelSelect(Purpose::Play),
            },
            1 => Request::LevelSelect(Purpose::Play),
            2 => Request::LevelSelect(Purpose::Leaderboard),
            3 => Request::Classics(None),
            4 => Request::Lab,
            5 => Request::Settings,
            6 => Request::Quit,
            7 => Request::Players,
            _ => Request::Credits,
        })
    }

    /// Takes over which level Play opens.
    pub fn tell_next(&mut self, next: Option<(String, String)>) {
        self.facts.next = next;
    }

    /// Its buttons: Play, Level Select, Leaderboards, Classics, Lab, Settings, Quit; who plays; Credits.
    pub fn buttons(&self) -> &Buttons {
        &self.buttons
    }

    /// Whether ship and balls hold still: nobody has touched anything for long, or the player is elsewhere.
    pub fn rests(&self, input: &Input) -> bool {
        input.away || input.idle >= pace::REST
    }

    /// The lines of words that are drawn beside the buttons, each with its box; the title is the last one.
    pub fn lines(&self) -> &[(Line, Area)] {
        &self.lines
    }

    /// The boxes of all that is drawn: what balls bounce off and the ship flies around.
    fn drawn(&self) -> Vec<Area> {
        self.buttons.areas().iter().copied().chain(self.lines.iter().map(|(_, area)| *area)).collect()
    }

    fn lines_in(&self, frame: &Frame) -> Vec<(Line, Area)> {
        let height = frame.text_height(TEXT);
        let mut lines = Vec::new();
        if let (Some(play), Some((_, title))) = (self.buttons.areas().first(), &self.facts.next) {
            let from = Vec2::new(play.max().x + 2.0 * PADDING, play.centre().y);
            lines.push((Line::Next, words_box(title, height, from)));
        }
        let foot = self.facts.trouble.as_deref().unwrap_or(HINT);
        let mut area = words_box(foot, height, Vec2::new(0.0, frame.size.y - FOOT));
        area.size.x = area.size.x.min(frame.size.x - BESIDE_FOOT);
        area.min.x = (frame.size.x - area.size.x) / 2.0;
        lines.push((Line::Foot, area));
        lines.push((Line::Title, title_area(frame)));
        lines
    }

    /// What it says.
    pub fn facts(&self) -> &Facts {
        &self.facts
    }

    /// The boxes of the balls, as they are drawn.
    pub fn balls(&self) -> Vec<Area> {
        self.balls.areas().collect()
    }

    /// The ship's centre (canvas units), its angle (degrees) and how its engine burns (0 … 1), as they are drawn.
    pub fn ship(&self) -> Option<(Vec2, f64, f64)> {
        let (centre, angle, burning) = self.balls.ship()?;
        Some(((centre * f64::from(super::balls::METRE)).as_vec2(), angle, burning))
    }
}

/// The box of the title's letters.
fn title_area(frame: &Frame) -> Area {
    let size = Vec2::new(words_width(NAME, TITLE), TITLE_HEIGHT * TITLE);
    Area::around(Vec2::new(frame.size.x / 2.0, (frame.size.y * TITLE_AT).round()), size)
}

/// The column, and a button in each lower corner.
fn places(frame: &Frame) -> Vec<Area> {
    let top = (frame.size.y * BUTTONS_AT / GRID).round() * GRID;
    let foot = frame.size.y - CORNER;
    let player = Area { min: Vec2::new(CORNER, foot - PLAYER_BUTTON.y), size: PLAYER_BUTTON };
    let credits = Area { min: Vec2::new(frame.size.x - CORNER - ROW_BUTTON.x, foot - ROW_BUTTON.y), size: ROW_BUTTON };
    frame.column(LABELS.len(), top).into_iter().chain([player, credits]).collect()
}

mod drawing {
    use super::{BESIDE_FOOT, FOOT, HINT, LABELS, Line, Menu, NAME};
    use crate::draw::{Canvas, Colour, Style};
    use crate::physics::{DVec2, ForceKind};
    use crate::screens::balls::METRE;
    use crate::view::camera::{Viewport, Window};
    use crate::view::layout::{Area, BUTTON_TEXT, PADDING, TEXT, TITLE, Vec2};
    use crate::view::{arrows, theme, things, widgets};

    /// The arrows around the title, whose sum is the one beneath it: what each is, and how far it leads on, of the title's width and of its
    /// height (upwards).
    const ADDENDS: [(ForceKind, Vec2); 5] = [
        (ForceKind::Drive, Vec2::new(-0.1, 1.1)),
        (ForceKind::Wind, Vec2::new(0.34, 0.5)),
        (ForceKind::Reaction, Vec2::new(0.32, 0.1)),
        (ForceKind::AirResistance, Vec2::new(0.38, -0.45)),
        (ForceKind::Weight, Vec2::new(0.06, -1.25)),
    ];

    impl Menu {
        /// Draws the menu.
        pub fn draw(&self, canvas: &Canvas) {
            widgets::graph_paper(canvas);
            for (i, area) in self.buttons.areas().iter().enumerate() {
                let (hover, focus) = (self.buttons.hover() == Some(i), self.buttons.focus() == i);
                match LABELS.get(i) {
                    Some(label) => widgets::button(canvas, *area, label, hover, focus),
                    None if i == LABELS.len() => self.draw_player(canvas, *area, (hover, focus)),
                    None => widgets::button(canvas, *area, "Credits", hover, focus),
                }
            }
            for (line, area) in &self.lines {
                match line {
                    Line::Title => self.draw_title(canvas, *area),
                    Line::Next => self.draw_next(canvas, *area),
                    Line::Foot => self.draw_foot(canvas, *area),
                }
            }
            self.balls.draw(canvas);
            self.draw_ship(canvas);
        }

        /// The name, and the arrows that add up to the one beneath it.
        fn draw_title(&self, canvas: &Canvas, area: Area) {
            let size = area.size + Vec2::new(2.0 * PADDING, 0.0);
            let start = Vec2::new(area.min.x - PADDING, area.max().y + 6.0);
            let end = start + Vec2::new(size.x, 0.0);
            let mut tail = start;
            for (kind, step) in ADDENDS {
                let tip = tail + Vec2::new(step.x, -step.y) * size;
                arrows::draw_one(canvas, (tail, tip), arrows::Shown::Force(kind), 0.9);
                tail = tip;
            }
            canvas.end_layer();
            arrows::draw_one(canvas, (start, end), arrows::Shown::Resultant, 1.0);
            canvas.text(NAME, area.centre(), Style::new(TITLE, theme::accent()).centred().middle());
            canvas.end_layer();
        }

        fn draw_next(&self, canvas: &Canvas, area: Area) {
            let Some((play, (_, title))) = self.buttons.areas().first().zip(self.facts.next.as_ref()) else { return };
            let from = Vec2::new(area.min.x, play.centre().y);
            canvas.text(title, from, Style::new(TEXT, theme::quiet()).middle());
        }

        fn draw_foot(&self, canvas: &Canvas, area: Area) {
            let (middle, widest) = (Vec2::new(area.centre().x, canvas.size().y - FOOT), canvas.size().x - BESIDE_FOOT);
            let (words, colour) = match &self.facts.trouble {
                Some(trouble) => (trouble.as_str(), theme::bad()),
                None => (HINT, theme::quiet()),
            };
            widgets::fitted(canvas, words, middle, widest, &[TEXT], colour);
        }

        fn draw_player(&self, canvas: &Canvas, area: Area, (hover, focus): (bool, bool)) {
            widgets::button_box(canvas, area, hover, focus);
            let y = area.centre().y;
            canvas.text("Player", Vec2::new(area.min.x + PADDING, y), Style::new(TEXT, theme::quiet()).middle());
            let name = Style::new(BUTTON_TEXT, theme::text()).mono().middle();
            canvas.text(self.facts.player.as_str(), Vec2::new(area.max().x - PADDING, y), name.right());
        }

        fn draw_ship(&self, canvas: &Canvas) {
            let Some((centre, angle, burning)) = self.balls.ship() else { return };
            let frame = canvas.frame();
            let window = Window { size: frame.size.as_dvec2(), pixel: f64::from(frame.pixel) };
            let metre = f64::from(METRE);
            let view = Viewport::new(DVec2::ZERO, DVec2::ZERO, window.size / metre, metre, window);
            things::draw_ship(
                &things::ShipPose { centre, angle, squash: 0.0, light: Colour::WHITE, room: f64::INFINITY },
                (burning, 1.0),
                0.5,
                &view,
                canvas,
            );
        }
    }
}
