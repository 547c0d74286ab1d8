//! How long a level takes to open, and its ticks along the recorded flights, in time on the processor, which no other program takes part in.

use cpu_time::ThreadTime;
use resultant::game::{Game, Replay};
use resultant::level::{self, Level};
use std::path::Path;
use std::sync::Arc;

/// How often each flight is flown; of each tick the shortest time counts: the processor has other things to do now and then.
const RUNS: usize = 7;
/// The bars, s: of a level's mean tick, its worst one, and opening it.
const BARS: [f64; 3] = [10e-6, 0.5e-3, 0.2];

/// The head of the table.
pub const HEAD: &str =
    "| level | ticks | mean µs | worst µs | in the flight | at tick | opens in ms |\n|---|---|---|---|---|---|---|";

/// Prints a level's row; an error where it misses a bar.
pub fn measure(level: &Arc<Level>, project: &Path) -> Result<(), String> {
    let folder = project.join("levels").join(&level.name);
    let opens = (0..RUNS).map(|_| open(&folder, project)).collect::<Result<Vec<f64>, String>>()?;
    let opens = opens.into_iter().fold(f64::INFINITY, f64::min);
    let (mut sum, mut count, mut worst) = (0.0, 0_u32, (0.0, "", 0));
    for flight in ["careful", "gold", "mark"] {
        let file = folder.join("flights").join(flight).with_extension("replay.csv");
        let text = std::fs::read_to_string(&file).map_err(|error| format!("{}: {error}", file.display()))?;
        let replay = Replay::parse(flight, &text).map_err(|problems| problems.to_string())?;
        let ticks = ticks(level, &replay);
        sum += ticks.iter().sum::<f64>();
        count += ticks.len() as u32;
        for (tick, time) in (1..).zip(ticks) {
            if time > worst.0 {
                worst = (time, flight, tick);
            }
        }
    }
    let mean = sum / f64::from(count.max(1));
    println!(
        "| {} | {count} | {:.2} | {:.0} | {} | {} | {:.1} |",
        level.name,
        mean * 1e6,
        worst.0 * 1e6,
        worst.1,
        worst.2,
        opens * 1e3
    );
    let missed = [mean, worst.0, opens].iter().zip(BARS).any(|(time, bar)| *time > bar);
    if missed { Err("slower than it may be".to_owned()) } else { Ok(()) }
}

/// From the level's files to its first tick, s.
fn open(folder: &Path, project: &Path) -> Result<f64, String> {
    let begun = ThreadTime::now();
    let loaded = level::load(folder, project).map_err(|problems| format!("{problems:?}"))?;
    let game = Game::new(Arc::new(loaded.level)).map_err(|error| error.to_string())?;
    std::hint::black_box(&game);
    Ok(begun.elapsed().as_secs_f64())
}

/// The shortest time of each tick of a flight, s.
fn ticks(level: &Arc<Level>, replay: &Replay) -> Vec<f64> {
    let mut shortest = Vec::new();
    for _ in 0..RUNS {
        let mut game = crate::flight::new_game(level);
        for (index, controls) in replay.inputs.clone().into_iter().enumerate() {
            let begun = ThreadTime::now();
            game.step(controls);
            let time = begun.elapsed().as_secs_f64();
            match shortest.get_mut(index) {
                None => shortest.push(time),
                Some(shortest) => *shortest = time.min(*shortest),
            }
        }
    }
    shortest
}
