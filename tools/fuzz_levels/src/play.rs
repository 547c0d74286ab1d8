//! One level: loaded, played, judged.

use crate::levels::level_texts;
use crate::random::Random;
use cpu_time::ThreadTime;
use resultant::game::{Controls, Game};
use resultant::level;
use resultant::physics::Body;
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

const TICKS: u32 = 300;
/// s of the processor. What has taken so long in all is not played on.
const ENOUGH: f64 = 0.25;
/// s. A tick that takes longer is a fault of its own.
const SLOW: f64 = 0.02;

/// How a level ended.
#[derive(Debug)]
pub enum End {
    Refused,
    /// It was played.
    Played,
    /// Something worse than a law that does not hold.
    Broken(String),
}

/// What came of a level.
#[derive(Debug)]
pub struct Played {
    pub end: End,
    /// What did not hold, the first of each kind, by kind.
    pub faults: BTreeMap<String, String>,
    /// Of all ticks, s.
    pub slowest: f64,
    pub budgets_used_up: u64,
}

impl Played {
    /// Notes a fault. Numbers are what one of a kind differs in from the next.
    fn note(&mut self, what: &str) {
        let words: Vec<&str> = what.split([' ', ':', ',']).filter(|word| !word.contains(|c: char| c.is_ascii_digit())).collect();
        let after = if self.budgets_used_up > 0 { " (a budget was used up before)" } else { "" };
        let kind = words[..words.len().min(9)].join(" ") + after;
        self.faults.entry(kind).or_insert_with(|| what.to_owned());
    }
}

/// Plays the level of that seed.
pub fn play(seed: u64) -> Played {
    let mut played = Played { end: End::Played, faults: BTreeMap::new(), slowest: 0.0, budgets_used_up: 0 };
    let end = catch_unwind(AssertUnwindSafe(|| play_on(seed, &mut played)));
    played.end = match end {
        Ok(Ok(end)) => end,
        Ok(Err(fault)) => End::Broken(fault),
        Err(panic) => End::Broken(format!("panic: {}", panic.downcast_ref::<String>().map_or("?", String::as_str))),
    };
    if let End::Broken(what) = &played.end {
        let what = what.clone();
        played.note(&what);
    }
    if played.slowest > SLOW {
        let what = format!("slow: {:.1} ms", played.slowest * 1e3);
        played.note(&what);
    }
    played
}

fn play_on(seed: u64, played: &mut Played) -> Result<End, String> {
    let Ok(loaded) = level::read("fuzz", &level_texts(seed)) else { return Ok(End::Refused) };
    let mut game = Game::new(Arc::new(loaded.level)).map_err(|error| format!("accepted, but the engine refuses it: {error}"))?;
    let mut random = Random(!seed);
    let (mut controls, mut spent) = (Controls::default(), 0.0);
    for tick in 0..TICKS {
        if random.chance(0.08) {
            let mut key = || random.chance(0.4);
            controls = Controls { thrust: key(), reverse: key(), left: key(), right: key() };
        }
        let begun = ThreadTime::now();
        game.step(controls);
        let time = begun.elapsed().as_secs_f64();
        played.slowest = played.slowest.max(time);
        played.budgets_used_up = game.world().guards().budgets_used_up;
        if let Err(fault) = game.world().validate() {
            played.note(&format!("{fault} (tick {tick})"));
        }
        spent += time;
        let finite = |body: &Body| body.position.is_finite() && body.velocity.is_finite();
        if spent > ENOUGH || !game.world().bodies().iter().all(finite) {
            break;
        }
    }
    Ok(End::Played)
}
