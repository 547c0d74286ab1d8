//! Random levels of all building parts: nothing that moves, opens, breaks, bounces or pulls becomes non-finite, leaves the level, or
//! depends on anything but the inputs. (The engine's own laws are checked after each tick of a test besides.)

use crate::support::Random;
use crate::support::written::{kept, texts};
use resultant::game::{Controls, Game};
use resultant::level;
use std::fmt::Write;
use std::sync::Arc;

const LEVELS: u64 = 150;
const TICKS: u32 = 360;
/// Levels in which a law was broken once: a body on another that a surface put out of itself sank into that surface, a little deeper each
/// time; and friction on walls went on where nothing pressed any more.
const ONCE_BROKEN: &str = include_str!("../fixtures/once_built.txt");

const MATERIALS: [&str; 5] = ["", "Ice", "Trampoline", "Rubber", "Glass"];

fn rows(random: &mut Random) -> Vec<(&'static str, String)> {
    let files = "world.csv movers.csv doors.csv switches.csv gravity.csv objects.csv hazards.csv pods.csv constants.csv".split(' ');
    let mut files: Vec<(&'static str, String)> = files.map(|file| (file, String::new())).collect();
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
        let (right, up, above) = (left + 60.0, top - 90.0, top - 150.0);
        match kind as u32 {
            0 => add("movers.csv", format!("{left},{top},{width},30,{left} {above},{},,0.25,0.5,,{material}", number(1.0, 6.0))),
            1 => {
                let way = format!("{right} {top};{left} {up},,{}", number(2.0, 6.0));
                add("movers.csv", format!("{left},{top},60,60,{way},,,round,{material},,{belt},lift"));
            }
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
            let (mass, e) = (number(2.0, 80.0), number(0.0, 2.0) / 2.0);
            add("objects.csv", format!("{x},{y},box:{size}x{size},{mass},1,FALSE,{e},,,,{weightless}"));
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
    let drawn: Vec<_> = (0..LEVELS).map(|seed| (seed, TICKS, rows(&mut Random(seed)))).collect();
    let borrowed = drawn.iter().map(|(seed, ticks, files)| {
        let files: Vec<(&'static str, &str)> = files.iter().map(|(file, text)| (*file, text.as_str())).collect();
        (*seed, *ticks, files)
    });
    for (seed, ticks, files) in borrowed.chain(kept(ONCE_BROKEN)) {
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
        for tick in 0..ticks {
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

/// A random level and a random flight through it; then the level that asks for the flight's own results. No warning calls them impossible.
#[test]
fn what_has_been_done_is_never_called_impossible() {
    let mut asked = [0; 2];
    for seed in 0..2 * LEVELS {
        let mut random = Random(!seed);
        let mut files = rows(&mut Random(seed));
        let plain = seed % 3 != 0;
        if plain {
            // Where only the engine drives anything, the checks know most.
            let driven = ["hazards.csv", "gravity.csv", "movers.csv", "switches.csv", "world.csv", "constants.csv"];
            files.retain(|(file, _)| !driven.contains(file));
        }
        let red = format!("{},{},20,20\n", random.between(100.0, 1150.0).round(), random.between(0.0, 400.0).round());
        files.push(("obstacles.csv", red));
        let (x, y) = (random.between(90.0, 120.0).round(), random.pick(&[100.0, 500.0, 855.0]));
        let key = format!("OBJECT,{x},{y},box:30x30,20,1,2,3,0.2,1\n");
        if is_asked(seed, &files, &key, (2000, false), &mut random) {
            asked[usize::from(plain)] += 1;
        }
    }
    assert!(asked.iter().all(|asked| *asked > 30), "{asked:?} levels");
}

/// Flies a level at random, or with no key pressed, and asks for what came of it: no warning calls that impossible. `false` where the flight
/// did nothing that can be asked for.
fn is_asked(seed: u64, files: &[(&'static str, String)], key: &str, (thrust, idle): (u32, bool), random: &mut Random) -> bool {
    let set = |memory: &mut crate::support::Memory, name: &'static str, text: String| {
        memory.0.retain(|(file, _)| *file != name);
        memory.0.push((name, text));
    };
    let borrowed: Vec<(&'static str, &str)> = files.iter().map(|(file, text)| (*file, text.as_str())).collect();
    let mut memory = texts(&borrowed);
    set(&mut memory, "objectives.csv", format!("PLAYER,1190,0,10,10,1e6\n{key}"));
    set(&mut memory, "player.csv", format!("60,844.5,100,500,{thrust}\n"));
    let Ok(loaded) = level::read("built", &memory) else { return false };
    let (switches, level) = (loaded.level.switches.len(), Arc::new(loaded.level));
    let mut game = Game::new(level.clone()).unwrap();
    let (mut held, mut pressed) = (Controls::default(), vec![false; switches]);
    for tick in 0..120 * (1 + random.below(6)) {
        if tick % 20 == 0 && !idle {
            let mut key = |chance: f64| random.chance(chance);
            held = Controls { thrust: key(0.7), reverse: key(0.1), left: key(0.2), right: key(0.25) };
        }
        game.step(held);
        (0..switches).for_each(|switch| pressed[switch] |= game.mechanisms().is_pressed(switch));
    }
    if game.killed_by().is_some() {
        return false;
    }
    let at = |body: usize| game.world().bodies()[body].position * level.metre;
    let (ship, stone) = (at(0), at(level.objects.len()));
    let goals = format!("PLAYER,{},{},2,2\nPHYS,{},{},2,2\n{key}", ship.x - 1.0, ship.y - 1.0, stone.x - 1.0, stone.y - 1.0);
    set(&mut memory, "objectives.csv", goals);
    let loaded = match level::read("built", &memory) {
        Ok(loaded) => loaded,
        Err(problems) => {
            assert!(problems.iter().all(|problem| problem.found.contains("met at the start")), "seed {seed}: {problems:?}");
            return false;
        }
    };
    for warning in &loaded.warnings {
        let done = match warning.file.as_str() {
            "switches.csv" => pressed[warning.line - 1],
            "player.csv" => warning.column == "thrust",
            "objectives.csv" => !warning.found.contains("no one can reach"),
            _ => false,
        };
        assert!(!done, "seed {seed}: {warning}");
    }
    true
}

/// The room with a key and a crate, and links of all kinds between these, the ship and places; also with an engine below the weight, and with
/// no key pressed.
#[test]
fn what_links_have_done_is_never_called_impossible() {
    let mut asked = 0;
    for seed in 0..LEVELS {
        let mut random = Random(seed);
        let key = format!("OBJECT,{},855,box:30x30,20,1,2,3,0,1,,,,,k\n", random.between(150.0, 500.0).round());
        let mut rows = "kind,a,b,length,stiffness,damping,strength,hook,breaks,rate\n".to_owned();
        for _ in 0..1 + random.below(2) {
            let a = random.pick(&["ship", "k", "crate"]);
            let place = format!("{} {}", random.between(50.0, 1150.0).round(), random.between(50.0, 700.0).round());
            let b = if random.chance(0.7) { place } else { random.pick(&["ship", "k", "crate"]).to_owned() };
            let (stiffness, rate) = (random.between(200.0, 3000.0).round(), random.pick(&["", "-1", "-4"]));
            let link = match random.below(3) {
                0 => format!("magnet,{a},{b},,,,{},,,", random.between(500.0, 9000.0).round()),
                1 => format!("spring,{a},{b},60,{stiffness},{},,,,{rate}", stiffness / 10.0),
                _ => format!("rope,{a},{b},,{stiffness},{},,,,{rate}", stiffness / 10.0),
            };
            writeln!(rows, "{link}").unwrap();
        }
        let crate_ = "700,850,box:40x40,40,1,FALSE,0,,,,,crate\n".to_owned();
        let files = [("objects.csv", crate_), ("world.csv", "800,700,300,20\n".to_owned()), ("links.csv", rows)];
        let flight = (random.pick(&[900, 2000]), seed % 3 == 0);
        asked += u32::from(is_asked(seed, &files, &key, flight, &mut random));
    }
    assert!(asked > 50, "{asked} levels");
}
