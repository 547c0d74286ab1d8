//! A sitting: the app without a window, and fingers on keys and mouse.

use resultant::screens::{App, Buttons, Input, Key, LevelSelect, Places, Press, Purpose, Screen, Spectator, Worker};
use resultant::view::layout::{Frame, Vec2};
use std::fs;
use std::path::Path;

/// A sitting with levels of its own: `1` is completed by its first tick, `2` lasts, `3` is lost by its first tick, `10` lasts too,
/// `broken` does not load.
pub struct Sitting {
    pub app: App,
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
        let mut sitting = Self { app: App::new(places(&folder)), frame: Frame::default(), folder, open: true };
        sitting.rest();
        sitting
    }

    /// One in which levels are read when the test says so.
    pub fn by_hand(mut self) -> Self {
        self.app = App::with_worker(places(&self.folder), Worker::by_hand());
        self.rest();
        self
    }

    /// Lets the worker do so many errands, a frame each; how many there were.
    pub fn work(&mut self, errands: usize) -> usize {
        (0..errands).take_while(|_| self.app.worker().step().then(|| self.rest()).is_some()).count()
    }

    /// The game is closed and opened again.
    pub fn reopen(&mut self) -> &mut Self {
        self.app = App::new(places(&self.folder));
        self.rest()
    }

    /// A file of the folder of scores.
    pub fn scores_file(&self, name: &str) -> String {
        fs::read_to_string(self.folder.path().join("scores").join(name)).unwrap_or_default()
    }

    /// One frame.
    pub fn give(&mut self, input: Input) -> &mut Self {
        self.give_to(input, &mut ())
    }

    pub fn give_to(&mut self, input: Input, spectator: &mut dyn Spectator) -> &mut Self {
        assert!(self.open, "the window is closed");
        let frame_time = if input.frame_time > 0.0 { input.frame_time } else { 1.0 / 60.0 };
        self.open = self.app.update(&Input { frame: self.frame, frame_time, ..input }, spectator);
        self
    }

    /// A frame without input.
    pub fn rest(&mut self) -> &mut Self {
        self.give(Input::default())
    }

    pub fn wait(&mut self, seconds: f64) -> &mut Self {
        for _ in 0..(seconds * 60.0).ceil() as u32 {
            self.rest();
        }
        self
    }

    /// A key goes down and up again.
    pub fn press(&mut self, key: Key) -> &mut Self {
        let keys = [key].into_iter().collect();
        self.give(Input { pressed: keys, held: keys, ..Input::default() })
    }

    pub fn press_all(&mut self, keys: &[Key]) -> &mut Self {
        for key in keys {
            self.press(*key);
        }
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

    /// Clicks a button of the screen by its index.
    pub fn click(&mut self, index: usize) -> &mut Self {
        let at = self.buttons().areas()[index].centre();
        self.click_at(at)
    }

    /// Presses a button of the screen by arrows and Enter.
    pub fn choose(&mut self, index: usize) -> &mut Self {
        for _ in 0..20 {
            let (areas, focus) = (self.buttons().areas().to_vec(), self.buttons().focus());
            if focus == index {
                return self.press(Key::Enter);
            }
            let way = areas[index].centre() - areas[focus].centre();
            let key = match (way.x.abs() > way.y.abs(), way.x > 0.0, way.y > 0.0) {
                (true, true, _) => Key::Right,
                (true, false, _) => Key::Left,
                (false, _, true) => Key::Down,
                (false, _, false) => Key::Up,
            };
            self.press(key);
        }
        panic!("the arrows do not lead to button {index}");
    }

    pub fn buttons(&self) -> &Buttons {
        match self.app.screen() {
            Screen::Menu(screen) => screen.buttons(),
            Screen::LevelSelect(screen) => screen.buttons(),
            Screen::Settings(screen) => screen.buttons(),
            Screen::Editor(screen) => screen.buttons(),
            Screen::Flight(screen) => match screen.settings() {
                Some(settings) => settings.buttons(),
                None => screen.pause().expect("the pause panel is open"),
            },
            Screen::Watch(screen) => screen.toolbar().buttons(),
            Screen::Flights(screen) => screen.buttons(),
            Screen::Scoring(screen) => screen.buttons(),
            Screen::SaveScore(screen) => screen.buttons(),
            Screen::Leaderboard(screen) => screen.buttons(),
            Screen::Players(screen) => screen.buttons(),
            Screen::Credits(screen) => screen.buttons(),
            Screen::Classics(screen) => screen.buttons(),
            Screen::Lab(screen) => screen.toolbar().buttons(),
            Screen::TileRun(screen) => screen.toolbar().buttons(),
            Screen::Jumper(screen) => screen.buttons().expect("the panel is open"),
            Screen::Pi(screen) => screen.toolbar().buttons(),
        }
    }

    pub fn at(&self) -> &'static str {
        match self.app.screen() {
            Screen::Menu(_) => "menu",
            Screen::LevelSelect(screen) if screen.problems().is_some() => "problems",
            Screen::LevelSelect(screen) => match screen.purpose() {
                Purpose::Play => "level select",
                Purpose::Leaderboard => "leaderboards",
                Purpose::Edit => "levels to edit",
            },
            Screen::Settings(_) => "settings",
            Screen::Editor(_) => "editor",
            Screen::Flight(screen) if screen.is_test() => "test flight",
            Screen::Flight(screen) if screen.settings().is_some() => "settings in flight",
            Screen::Flight(screen) if screen.pause().is_some() => "pause",
            Screen::Flight(_) => "flight",
            Screen::Watch(_) => "watch",
            Screen::Flights(_) => "flights",
            Screen::Scoring(_) => "scoring",
            Screen::SaveScore(_) => "save score",
            Screen::Leaderboard(_) => "leaderboard",
            Screen::Players(screen) if screen.field().is_some() => "new player",
            Screen::Players(_) => "players",
            Screen::Credits(_) => "credits",
            Screen::Classics(_) => "classics",
            Screen::Lab(_) => "lab",
            Screen::TileRun(_) => "tile run",
            Screen::Jumper(_) => "jumper",
            Screen::Pi(_) => "pi",
        }
    }

    pub fn level_select(&self) -> &LevelSelect {
        let Screen::LevelSelect(screen) = self.app.screen() else { panic!("at {}", self.at()) };
        screen
    }

    pub fn editor(&self) -> &resultant::screens::Editor {
        let Screen::Editor(screen) = self.app.screen() else { panic!("at {}", self.at()) };
        screen
    }

    pub fn flight(&self) -> &resultant::screens::Flight {
        let Screen::Flight(screen) = self.app.screen() else { panic!("at {}", self.at()) };
        screen
    }

    pub fn scoring(&self) -> &resultant::screens::Scoring {
        let Screen::Scoring(screen) = self.app.screen() else { panic!("at {}", self.at()) };
        screen
    }

    pub fn watch(&self) -> &resultant::screens::Watch {
        let Screen::Watch(screen) = self.app.screen() else { panic!("at {}", self.at()) };
        screen
    }

    pub fn flights(&self) -> &resultant::screens::Flights {
        let Screen::Flights(screen) = self.app.screen() else { panic!("at {}", self.at()) };
        screen
    }

    pub fn leaderboard(&self) -> &resultant::screens::Leaderboard {
        let Screen::Leaderboard(screen) = self.app.screen() else { panic!("at {}", self.at()) };
        screen
    }

    pub fn save_score(&self) -> &resultant::screens::SaveScore {
        let Screen::SaveScore(screen) = self.app.screen() else { panic!("at {}", self.at()) };
        screen
    }

    pub fn menu(&self) -> &resultant::screens::Menu {
        let Screen::Menu(screen) = self.app.screen() else { panic!("at {}", self.at()) };
        screen
    }

    pub fn players(&self) -> &resultant::screens::Players {
        let Screen::Players(screen) = self.app.screen() else { panic!("at {}", self.at()) };
        screen
    }

    /// From the menu to the field for a new player, and back to the menu as that one.
    pub fn become_new(&mut self, name: &str) -> &mut Self {
        self.click(7);
        if self.at() == "players" {
            let new = self.players().range().len();
            self.choose(new);
        }
        self.write(name).press(Key::Enter);
        assert_eq!(self.at(), "menu");
        self
    }

    /// From the menu into a level, by its index in the list.
    pub fn fly(&mut self, index: usize) -> &mut Self {
        self.choose(1).choose(index)
    }

    /// From the menu to the score of level 3, which is lost.
    pub fn lose(&mut self) -> &mut Self {
        self.fly(2).wait(0.1).press(Key::Enter).wait(0.5);
        assert_eq!(self.at(), "scoring");
        self
    }

    /// From the menu to the score of level 1, once its keys count.
    pub fn complete(&mut self) -> &mut Self {
        self.fly(0).wait(2.0);
        assert_eq!(self.at(), "scoring");
        self
    }

    /// From the menu to the field for the name.
    pub fn reach_save_score(&mut self) -> &mut Self {
        let save = self.complete().scoring().presses().iter().position(|press| *press == Press::SaveScore).unwrap();
        self.choose(save)
    }
}

fn places(folder: &tempfile::TempDir) -> Places {
    let root = folder.path().to_path_buf();
    Places { levels: root.join("levels"), scores: root.join("scores"), root }
}

pub fn level(root: &Path, name: &str, objectives: &str, obstacles: &str) {
    let folder = root.join("levels").join(name);
    fs::create_dir_all(&folder).unwrap();
    fs::write(folder.join("constants.csv"), "width,800\nheight,600\noptimal_time,10\n").unwrap();
    fs::write(folder.join("player.csv"), PLAYER).unwrap();
    fs::write(folder.join("objectives.csv"), objectives).unwrap();
    fs::write(folder.join("obstacles.csv"), obstacles).unwrap();
}

pub fn board(rows: usize) -> String {
    let rows: String = (0..rows).map(|i| format!("user{i},{}\n", 20_000 - 100 * i)).collect();
    format!("name,score\n{rows}")
}

pub fn enter() -> Input {
    Input { pressed: [Key::Enter].into_iter().collect(), held: [Key::Enter].into_iter().collect(), ..Input::default() }
}
