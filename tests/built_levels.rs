//! Random levels of all that there is to build with: whatever moves, opens, breaks, bounces and pulls, nothing becomes non-finite, leaves the
//! level, or depends on anything but the inputs. (What has to hold of the engine is asked after each tick of a test besides.)

mod support;

use resultant::game::{Controls, Game};
use resultant::level;
use std::fmt::Write;
use std::sync::Arc;
use support::Random;
use support::written::texts;

const LEVELS: u64 = 150;
const TICKS: u32 = 360;
/// Levels in which a law was broken once: what lay on a body that was put out of a surface was left in it, a little deeper each time; and friction
/// on walls went on where nothing pressed any more.
const FOUND: [u64; 7] = [276, 585, 1135, 2178, 2558, 3384, 3941];

const MATERIALS: [&str; 5] = ["", "Ice", "Trampoline", "Rubber", "Glass"];

/// The rows that are added to the room.
fn rows(random: &mut Random) -> Vec<(&'static str, String)> {
    let mut files: Vec<(&'static str, String)> = [
        "world.csv",
        "movers.csv",
        "doors.csv",
        "switches.csv",
        "gravity.csv",
        "objects.csv",
        "hazards.csv",
        "pods.csv",
        "constants.csv",
    ]
    .into_iter()
    .map(|file| (file, String::new()))
    .collect();
    let mut add = |file: &str, row: String| {
        let text = files.iter_mut().find(|(name, _)| *name == file).map(|(_, text)| text).expect("a file of the list");
        writeln!(text, "{row}").unwrap();
    };
    let mut number = |low: f64, high: f64| random.between(low, high).round();
    // Columns of 150 pixels: blocks in one, crates above them, so that nothing starts in anything.
    for column in 1..8 {
        let left = 150.0 * f64::from(column);
        let (width, top) = (number(60.0, 140.0), number(450.0, 780.0));
        let (kind, material) = (number(0.0, 7.0), MATERIALS[number(0.0, 4.0) as usize]);
        let belt = number(1.0, 3.0);
        match kind as u32 {
            0 => add(
                "movers.csv",
                format!("{left},{top},{width},30,{left} {},{},,0.25,0.5,,{material}", top - 150.0, number(1.0, 6.0)),
            ),
            1 => add(
                "movers.csv",
                format!(
                    "{left},{top},60,60,{} {top};{left} {},,{},,,round,{material},,{belt},lift",
                    left + 60.0,
                    top - 90.0,
                    number(2.0, 6.0)
                ),
            ),
            2 => add("doors.csv", format!("{left},{top},{width},20,gate,{material}")),
            3 => add("world.csv", format!("{left},{top},{width},20,{material},top,{belt}")),
            4 => add("world.csv", format!("{left},{top},{width},20,{material},,{belt},,mill")),
            5 => add("world.csv", format!("{left},{top},{width},20,{material},,,{}", number(5.0, 200.0))),
            6 => add("switches.csv", format!("{left},{top},{width},20,NAMES,{}", number(50.0, 800.0))),
            _ => add("gravity.csv", format!("{left},{},{width},400,{},{}", top - 350.0, number(-20.0, 20.0), number(-25.0, 5.0))),
        }
        for crate_ in 0..number(0.0, 4.0) as u32 {
            let (size, weightless) = (number(12.0, 40.0), if number(0.0, 5.0) == 0.0 { "TRUE" } else { "" });
            let (x, y) = (left + 25.0 + number(0.0, 30.0), top - 22.0 - 45.0 * f64::from(crate_));
            add(
                "objects.csv",
                format!("{x},{y},box:{size}x{size},{},1,FALSE,{},,,,{weightless}", number(2.0, 80.0), number(0.0, 2.0) / 2.0),
            );
        }
    }
    add("hazards.csv", format!("1140,840,30,30,-{},0,{},0,,fan", number(100.0, 900.0), number(-900.0, 100.0)));
    add("pods.csv", "40,700,60,30,50".into());
    if number(0.0, 3.0) == 0.0 {
        add("constants.csv", format!("gravity_x,{}", number(-15.0, 15.0)));
    }
    let named = |files: &[(&str, String)], name: &str| {
        files.iter().any(|(_, text)| text.lines().any(|row| row.ends_with(name) || row.contains(&format!(",{name},"))))
    };
    let works: Vec<&str> = ["gate", "lift", "mill", "fan"].into_iter().filter(|name| named(&files, name)).collect();
    for (file, text) in &mut files {
        if *file == "switches.csv" {
            *text = text.replace("NAMES", &works.join(" "));
            writeln!(text, "0,600,120,90,!{},,ship,toggled", works.join(" ")).unwrap();
        }
    }
    files.retain(|(_, text)| !text.is_empty());
    files
}

#[test]
fn whatever_is_built_stays_finite_inside_and_the_same() {
    let (mut played, mut switched, mut broken) = (0, 0, 0);
    for seed in (0..LEVELS).chain(FOUND) {
        let files = rows(&mut Random(seed));
        let files: Vec<(&'static str, &str)> = files.iter().map(|(file, text)| (*file, text.as_str())).collect();
        let level = match level::read("built", &texts(&files)) {
            Ok(loaded) => Arc::new(loaded.level),
            Err(problems) => {
                assert!(problems.iter().all(|problem| problem.found.contains("inside")), "seed {seed}: {problems:?}");
                continue;
            }
        };
        played += 1;
        let mut games = [Game::new(Arc::clone(&level)).unwrap(), Game::new(level).unwrap()];
        let mut random = Random(!seed);
        for tick in 0..TICKS {
            let mut key = |chance: f64| random.chance(chance);
            let controls = Controls { thrust: key(0.6), reverse: key(0.1), left: key(0.2), right: key(0.25) };
            games.iter_mut().for_each(|game| game.step(controls));
            let bounds = games[0].level().bounds();
            for (i, body) in games[0].world().bodies().iter().enumerate() {
                assert!(body.position.is_finite() && body.velocity.is_finite(), "seed {seed}, tick {tick}: {body:?}");
                assert!(bounds.contains(&body.bounds(), 1e-6), "seed {seed}, tick {tick}: body {i} is at {}", body.position);
            }
        }
        assert_eq!(games[0].hash(), games[1].hash(), "seed {seed}");
        switched += u32::from(games[0].mechanisms().on().contains(&true));
        broken += (0..games[0].level().world.len()).filter(|&block| games[0].mechanisms().is_broken(block)).count();
    }
    assert!(played > LEVELS as u32 / 2 && switched > 10 && broken > 5, "{played} played, {switched} switched, {broken} broken");
}
