//! Levels as an author writes them: a room, and what a test adds to it.

use super::Memory;
use resultant::game::{Controls, Game};
use resultant::level::{self, Level};
use std::sync::Arc;

/// 40 m × 30 m, 10 N/kg, no air, a floor of 1 m; the ship (100 kg, 2000 N) stands at the left.
const ROOM: [(&str, &str); 4] = [
    ("constants.csv", "width,1200\nheight,900\ngravity,10\nair_density,0\n"),
    ("player.csv", "60,844.5,100,500,2000\n"),
    ("world.csv", "0,870,1200,30\n"),
    ("objectives.csv", "PLAYER,1190,0,10,10\n"),
];

/// The room with these files; where the room has the file already, the text is added at its end.
pub fn texts(files: &[(&'static str, &str)]) -> Memory {
    let mut all: Vec<(&'static str, String)> = ROOM.iter().map(|(file, text)| (*file, (*text).to_owned())).collect();
    for (file, text) in files {
        match all.iter_mut().find(|(name, _)| name == file) {
            Some((_, whole)) => *whole += text,
            None => all.push((file, (*text).to_owned())),
        }
    }
    Memory(all)
}

/// A level kept as text: the seed of its keys, how many ticks it is played, and its files.
pub type Kept = (u64, u32, Vec<(&'static str, &'static str)>);

/// Levels kept as text, each `=== SEED TICKS`, then `--- FILE` and its rows, file by file.
pub fn kept(text: &'static str) -> Vec<Kept> {
    let level = |level: &'static str| {
        let mut parts = level.split("--- ");
        let (seed, ticks) = parts.next().and_then(|title| title.trim().split_once(' ')).unwrap();
        (seed.parse().unwrap(), ticks.parse().unwrap(), parts.map(|file| file.split_once('\n').unwrap()).collect())
    };
    text.split("=== ").skip(1).map(level).collect()
}

pub fn written(files: &[(&'static str, &str)]) -> Level {
    match level::read("room", &texts(files)) {
        Ok(loaded) => loaded.level,
        Err(problems) => panic!("refused: {}", problems.iter().map(|problem| format!("\n{problem}")).collect::<String>()),
    }
}

pub fn begun(files: &[(&'static str, &str)]) -> Game {
    Game::new(Arc::new(written(files))).expect("the level can be played")
}

/// Lets `seconds` pass with no key pressed.
pub fn wait(game: &mut Game, seconds: f64) {
    (0..(seconds * game.tick_rate()).round() as u32).for_each(|_| game.step(Controls::default()));
}
