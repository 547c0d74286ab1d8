//! A sitting: the app without a window, and fingers on keys and mouse.

use resultant::draw::layout::{Area, Frame, Vec2};
use resultant::draw::{Colour, Contour, Shape};
use resultant::game::Game;
use resultant::screens::{
    Classics, Closing, Credits, Editor, Flight, Flights, GameScene, Input, Jumper, Key, Keys, Lab, Leaderboard, LevelSelect, Menu,
    Pi, Places, PlayerList, Purpose, Scoring, Screen, SettingsPanel, Spectator, Stack, TileRun, Worker,
};
use resultant::ui::WidgetKind;
use resultant::view::theme;
use std::fs;
use std::path::Path;

/// A sitting with levels of its own: `1` is completed by its first tick, `2` lasts, `3` is lost by its first tick, `10` lasts too,
/// `broken` does not load.
pub struct Sitting {
    pub app: Stack,
    pub frame: Frame,
    pub folder: tempfile::TempDir,
    pub open: bool,
}

pub const PLAYER: &str = "x,y,mass,fuel,thrust\n400,300,100,500,3000\n";
pub const HERE: &str = "PLAYER,380,280,40,40,0.001\n";
pub const FAR_AWAY: &str = "PLAYER,10,10,20,20\n";

/// Whether words such as "0.123 kJ" say that number of that unit, within half of their last digit.
pub fn says(words: &str, value: f64, unit: &str) -> bool {
    let (number, with_prefix) = words.split_once(' ').unwrap();
    let one = match with_prefix.strip_suffix(unit) {
        Some("k") => 1e3,
        Some("") => 1.0,
        Some("m") => 1e-3,
        other => panic!("{words}: {other:?}"),
    };
    let decimals = number.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let read: f64 = number.replace('−', "-").parse().unwrap();
    (read * one - value).abs() <= 0.501 * one * 0.1f64.powi(decimals as i32)
}

macro_rules! screens {
    ($($name:ident: $screen:ty),*) => {
        $(pub fn $name(&self) -> &$screen {
            self.screen()
        })*
    };
}

impl Sitting {
    pub fn new() -> Self {
        Self::with(|_| {})
    }

    pub fn with(prepare: impl FnOnce(&Path)) -> Self {
        let folder = tempfile::tempdir().unwrap();
        level(folder.path(), "1", HERE, "");
        level(folder.path(), "2", FAR_AWAY, "");
        level(folder.path(), "3", FAR_AWAY, "380,324.356,40,40\n");
        level(folder.path(), "10", FAR_AWAY, "");
        level(folder.path(), "broken", FAR_AWAY, "380,280,wide,40\n");
        prepare(folder.path());
        let mut sitting = Self { app: Stack::new(places(&folder)), frame: Frame::default(), folder, open: true };
        sitting.rest();
        sitting
    }

    /// One in which levels are read when the test says so.
    pub fn by_hand(mut self) -> Self {
        self.app = Stack::with_worker(places(&self.folder), Worker::by_hand());
        self.rest();
        self
    }

    /// Lets the worker do up to `errands` errands, a frame each; returns how many it did.
    pub fn work(&mut self, errands: usize) -> usize {
        (0..errands).take_while(|_| self.app.session.worker.step().then(|| self.rest()).is_some()).count()
    }

    pub fn reopen(&mut self) -> &mut Self {
        self.app = Stack::new(places(&self.folder));
        self.rest()
    }

    pub fn scores_file(&self, name: &str) -> String {
        fs::read_to_string(self.folder.path().join("scores").join(name)).unwrap_or_default()
    }

    pub fn give(&mut self, input: Input) -> &mut Self {
        self.give_to(input, &mut ())
    }

    pub fn give_to(&mut self, input: Input, spectator: &mut dyn Spectator) -> &mut Self {
        assert!(self.open, "the window is closed");
        let frame_time = if input.frame_time > 0.0 { input.frame_time } else { 1.0 / 60.0 };
        self.open = self.app.update(&Input { frame: self.frame, frame_time, ..input }, spectator);
        self
    }

    pub fn rest(&mut self) -> &mut Self {
        self.give(Input::default())
    }

    pub fn wait(&mut self, seconds: f64) -> &mut Self {
        self.hold(&[], (seconds * 60.0).ceil() as usize)
    }

    pub fn press(&mut self, key: Key) -> &mut Self {
        self.press_keys(&[key], &[key])
    }

    pub fn press_all(&mut self, keys: &[Key]) -> &mut Self {
        keys.iter().for_each(|key| _ = self.press(*key));
        self
    }

    /// A frame in which keys go down, and these are down.
    pub fn press_keys(&mut self, pressed: &[Key], held: &[Key]) -> &mut Self {
        self.give(Input { pressed: keys(pressed), held: keys(held), ..Input::default() })
    }

    pub fn hold(&mut self, held: &[Key], frames: usize) -> &mut Self {
        (0..frames).for_each(|_| _ = self.press_keys(&[], held));
        self
    }

    /// Frames with these keys down until something is so, which it must be soon.
    #[track_caller]
    pub fn hold_until(&mut self, held: &[Key], done: impl Fn(&Self) -> bool) -> &mut Self {
        assert!((0..600).any(|_| done(self.hold(held, 1))), "it does not come to that");
        self
    }

    pub fn write(&mut self, text: &str) -> &mut Self {
        self.give(Input { typed: text.into(), ..Input::default() })
    }

    pub fn point_at(&mut self, pointer: Vec2) -> &mut Self {
        self.give(Input { pointer, ..Input::default() })
    }

    pub fn click_at(&mut self, pointer: Vec2) -> &mut Self {
        self.point_at(pointer).give(Input { pointer, click: true, holding: true, ..Input::default() }).point_at(pointer)
    }

    fn turn_to(&mut self, label: &str) {
        if self.at() == "menu" && !self.labels().contains(&label) {
            let other = if self.labels().contains(&"More") { "More" } else { "Back" };
            let at = self.area(other).centre();
            self.click_at(at);
        }
    }

    pub fn click(&mut self, label: &str) -> &mut Self {
        self.turn_to(label);
        let at = self.area(label).centre();
        self.click_at(at)
    }

    /// Presses a button by arrows and Enter.
    pub fn choose(&mut self, label: &str) -> &mut Self {
        self.turn_to(label);
        for _ in 0..20 {
            let (area, focus) = (self.area(label), self.area(self.focused()));
            if focus == area {
                return self.press(Key::Enter);
            }
            let path = area.centre() - focus.centre();
            let key = match (path.x.abs() > path.y.abs(), path.x > 0.0, path.y > 0.0) {
                (true, true, _) => Key::Right,
                (true, false, _) => Key::Left,
                (false, _, true) => Key::Down,
                (false, _, false) => Key::Up,
            };
            self.press(key);
        }
        panic!("the arrows do not lead to {label:?} of {:?}", self.labels());
    }

    pub fn area(&self, label: &str) -> Area {
        let widget = self.app.memory.widgets().iter().find(|widget| widget.label == label);
        widget.unwrap_or_else(|| panic!("{label} is none of {:?} at {}", self.labels(), self.at())).area
    }

    pub fn areas(&self) -> Vec<Area> {
        self.app.memory.widgets().iter().map(|widget| widget.area).collect()
    }

    /// All buttons are in the window, and apart.
    #[track_caller]
    pub fn assert_whole(&mut self) {
        let (areas, frame) = (self.rest().areas(), self.frame);
        for (i, area) in areas.iter().enumerate() {
            let at = format!("{} in {}: {area:?}", self.at(), frame.size);
            assert!(area.min.min_element() >= 0.0 && area.max().cmple(frame.size).all(), "{at} leaves it");
            for other in &areas[i + 1..] {
                let apart = area.max().cmple(other.min + 0.01).any() || other.max().cmple(area.min + 0.01).any();
                assert!(apart, "{at} and {other:?} overlap");
            }
        }
    }

    pub fn labels(&self) -> Vec<&str> {
        self.app.memory.widgets().iter().map(|widget| widget.label.as_str()).collect()
    }

    pub fn focused(&self) -> &str {
        self.app.memory.focused().unwrap_or_default()
    }

    /// All lines of text on the screen, in order, with their places.
    pub fn texts(&self) -> Vec<(String, Vec2)> {
        let shapes = self.app.canvas().shapes();
        shapes
            .iter()
            .filter_map(|shape| if let Shape::Text { text, at, .. } = shape { Some((text.clone(), *at)) } else { None })
            .collect()
    }

    pub fn shows(&self, words: &str) -> bool {
        self.texts().iter().any(|(text, _)| text.contains(words))
    }

    /// The line of text that holds these words.
    pub fn line(&self, words: &str) -> String {
        let texts = self.texts();
        let line = texts.iter().find(|(text, _)| text.contains(words));
        line.unwrap_or_else(|| panic!("{words:?} is not among {texts:?}")).0.clone()
    }

    /// The lines of text beside the one with these words, from left to right.
    pub fn row(&self, words: &str) -> Vec<String> {
        let texts = self.texts();
        let at = texts.iter().find(|(text, _)| text == words).unwrap_or_else(|| panic!("{words:?} is not among {texts:?}")).1;
        let mut row: Vec<_> = texts.into_iter().filter(|(_, other)| (other.y - at.y).abs() < 1.0).collect();
        row.sort_by(|a, b| a.1.x.total_cmp(&b.1.x));
        row.into_iter().map(|(text, _)| text).collect()
    }

    pub fn place(&self, words: &str) -> Vec2 {
        self.texts().iter().find(|(text, _)| text == words).unwrap_or_else(|| panic!("{words:?} is not shown")).1
    }

    pub fn colour(&self, words: &str) -> Colour {
        let shapes = self.app.canvas().shapes();
        let of = |shape: &Shape| {
            if let Shape::Text { text, style, .. } = shape { (text == words).then_some(style.colour) } else { None }
        };
        shapes.iter().find_map(of).unwrap_or_else(|| panic!("{words:?} is not shown"))
    }

    /// The line of text in the colour of problems.
    pub fn warning(&self) -> Option<String> {
        let texts = self.texts();
        texts.into_iter().map(|(text, _)| text).find(|text| self.colour(text) == theme::bad())
    }

    /// Whether the edge of a button says that it is chosen.
    pub fn is_chosen(&self, label: &str) -> bool {
        let of = self.area(label);
        self.app.canvas().shapes().iter().any(|shape| match shape {
            Shape::Edge { outline: Contour::Rounded(area, _), colour, .. } => *area == of && *colour == theme::accent(),
            _ => false,
        })
    }

    /// The middle of the row that is picked out, from the canvas' top.
    pub fn picked(&self) -> Option<f32> {
        self.app.canvas().shapes().iter().find_map(|shape| match shape {
            Shape::Fill { outline: Contour::Rounded(area, _), colour } if *colour == theme::panel_hover() => Some(area.centre().y),
            _ => None,
        })
    }

    /// The text of the line that is typed into.
    pub fn field(&self) -> String {
        let field = self.app.memory.widgets().iter().find(|widget| widget.kind == WidgetKind::Field).expect("there is a field");
        let texts = self.texts();
        texts.into_iter().rfind(|(_, at)| field.area.contains(*at)).map(|(text, _)| text).unwrap_or_default()
    }

    pub fn at(&self) -> &'static str {
        let screen = self.app.screen();
        let has = |label: &str| self.labels().contains(&label);
        if let Some(select) = screen.get::<LevelSelect>() {
            return match select.purpose {
                _ if has("Close") => "problems",
                Purpose::Play => "level select",
                Purpose::Leaderboard => "leaderboards",
                Purpose::Edit => "levels to edit",
            };
        }
        if let Some(flight) = screen.get::<Flight>() {
            return match () {
                () if flight.is_watched() => "watch",
                () if flight.is_test() => "test flight",
                () if has("Defaults") => "settings in flight",
                () if has("Resume") => "pause",
                () => "flight",
            };
        }
        if screen.is::<PlayerList>() {
            return if has("Done") { "new player" } else { "players" };
        }
        let known = [
            (screen.is::<Menu>(), "menu"),
            (screen.is::<Closing>(), "closing"),
            (screen.is::<SettingsPanel>(), "settings"),
            (screen.is::<Editor>(), "editor"),
            (screen.is::<Flights>(), "flights"),
            (screen.is::<Scoring>(), "scoring"),
            (screen.is::<Leaderboard>(), "leaderboard"),
            (screen.is::<Credits>(), "credits"),
            (screen.is::<Classics>(), "classics"),
            (screen.is::<Lab>(), "lab"),
            (screen.is::<TileRun>(), "tile run"),
            (screen.is::<Jumper>(), "jumper"),
            (screen.is::<Pi>(), "pi"),
        ];
        known.into_iter().find(|(is, _)| *is).map_or("elsewhere", |(_, name)| name)
    }

    pub fn screen<T: Screen>(&self) -> &T {
        self.app.screen().get().unwrap_or_else(|| panic!("at {}", self.at()))
    }

    screens! {
        level_select: LevelSelect, editor: Editor, flight: Flight, scoring: Scoring, flights: Flights, leaderboard: Leaderboard, menu: Menu
    }

    pub fn game(&self) -> &Game {
        self.flight().game()
    }

    pub fn ticks(&self) -> u64 {
        self.game().ticks()
    }

    pub fn scene(&self) -> GameScene<'_> {
        self.app.screen().scene(&self.frame).unwrap_or_else(|| panic!("no game at {}", self.at()))
    }

    pub fn level_names(&self) -> Vec<&str> {
        self.level_select().entries.iter().map(|entry| entry.name.as_str()).collect()
    }

    pub fn flown(&self) -> &str {
        &self.game().level().name
    }

    /// From the menu to the field for a new player, and back to the menu as that player.
    pub fn become_new(&mut self, name: &str) -> &mut Self {
        self.click("Players");
        if self.at() == "players" {
            self.choose("New Player");
        }
        self.write(name).press(Key::Enter);
        assert_eq!(self.at(), "menu");
        self
    }

    pub fn home(&mut self) -> &mut Self {
        (0..5).for_each(|_| _ = self.press(Key::Escape));
        assert_eq!(self.at(), "menu");
        self
    }

    pub fn fly(&mut self, level: &str) -> &mut Self {
        self.choose("Levels").choose(level)
    }

    /// From the menu to the score of level 3, which is lost.
    pub fn lose(&mut self) -> &mut Self {
        self.fly("3").wait(0.1).press(Key::Enter).wait(0.5);
        assert_eq!(self.at(), "scoring");
        self
    }

    /// From the menu to the score of level 1, once its keys count.
    pub fn complete(&mut self) -> &mut Self {
        self.fly("1").wait(2.0);
        assert_eq!(self.at(), "scoring");
        self
    }

    /// From the menu to the board of level 1, with a score that has just been saved for that player.
    pub fn save_as(&mut self, name: &str) -> &mut Self {
        self.complete().choose("Save Score").write(name).press(Key::Enter).wait(0.6).choose("Board")
    }
}

fn places(folder: &tempfile::TempDir) -> Places {
    let root = folder.path().to_path_buf();
    Places { levels: root.join("levels"), scores: root.join("scores"), settings: root.join("settings.csv"), root }
}

pub fn level(root: &Path, name: &str, objectives: &str, obstacles: &str) {
    let folder = root.join("levels").join(name);
    fs::create_dir_all(&folder).unwrap();
    fs::write(folder.join("constants.csv"), "width,800\nheight,600\noptimal_time,10\n").unwrap();
    fs::write(folder.join("player.csv"), PLAYER).unwrap();
    fs::write(folder.join("objectives.csv"), objectives).unwrap();
    fs::write(folder.join("obstacles.csv"), obstacles).unwrap();
}

pub fn with_scores(name: &str, text: &str) -> Sitting {
    Sitting::with(|root| {
        fs::create_dir(root.join("scores")).unwrap();
        fs::write(root.join("scores").join(name), text).unwrap();
    })
}

/// The lock of a file of scores, as another program holds it.
pub fn hold(sitting: &Sitting, file: &str) -> fs::File {
    let held = fs::File::create(sitting.folder.path().join(format!("scores/.{file}.lock"))).unwrap();
    held.lock().unwrap();
    held
}

pub fn board(rows: usize) -> String {
    let rows: String = (0..rows).map(|i| format!("user{i},{}\n", 20_000 - 100 * i)).collect();
    format!("name,score\n{rows}")
}

pub fn keys(keys: &[Key]) -> Keys {
    keys.iter().copied().collect()
}

pub fn enter() -> Input {
    Input { pressed: keys(&[Key::Enter]), held: keys(&[Key::Enter]), ..Input::default() }
}
