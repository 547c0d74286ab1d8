//! One level: loaded, played, judged.

use crate::levels::{level_texts, wildness};
use crate::memory::most_held;
use crate::random::Random;
use cpu_time::ThreadTime;
use resultant::game::{Controls, Game};
use resultant::level;
use resultant::physics::Body;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

const TICKS: u32 = 300;
/// s of the processor. What has taken so long in all is not played on.
const ENOUGH: f64 = 0.5;
/// s. A tick that takes longer is a fault of its own.
const SLOW: f64 = 0.02;
/// Bytes. A level that takes more at once, its loading included, is one too.
const LARGE: isize = 64 << 20;

/// How a level ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum End {
    /// By the loader, with its reasons.
    Refused,
    /// It was played for all ticks.
    Played,
    /// It was played until it had taken [`ENOUGH`].
    TooLong,
    /// It could not be played on.
    Broken,
}

/// What has to hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Law {
    /// Nothing panics, and the engine takes what the loader accepts.
    Runs,
    /// Every number is finite.
    Finite,
    /// Nothing leaves the level.
    Inside,
    /// Nothing is in anything else.
    Apart,
    /// Nothing passes through anything.
    Solid,
    /// Bodies that meet were looked at together.
    Together,
    /// The forces that are listed sum to m·a.
    Balanced,
    /// What is listed as a contact touches, and carries no more than it can.
    Touching,
    /// No tick takes longer than [`SLOW`].
    Quick,
    /// Nothing takes more memory than [`LARGE`].
    Small,
}

impl Law {
    /// All of them.
    pub const ALL: [Law; 10] = [
        Law::Runs,
        Law::Finite,
        Law::Inside,
        Law::Apart,
        Law::Solid,
        Law::Together,
        Law::Balanced,
        Law::Touching,
        Law::Quick,
        Law::Small,
    ];

    /// Which one it is whose fault [`resultant::physics::World::validate`] words so.
    fn of(fault: &str) -> Self {
        let says = |words: &str| fault.contains(words);
        match () {
            () if says("NaN") || says("inf") => Law::Finite,
            () if says("outside the level") => Law::Inside,
            () if says("passed through") => Law::Solid,
            () if says(" m in ") => Law::Apart,
            () if says("but they were in the islands") => Law::Together,
            () if says("a contact") => Law::Touching,
            () => Law::Balanced,
        }
    }
}

/// What came of a level.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Played {
    pub seed: u64,
    /// How many of its numbers are extreme.
    pub wildness: f64,
    pub end: End,
    pub ticks: u32,
    /// What did not hold, the first of each kind.
    pub faults: BTreeMap<Law, String>,
    /// Of all ticks, and all of them together, s on the processor.
    pub slowest: f64,
    pub took: f64,
    /// The most that was held at once, bytes.
    pub held: isize,
    /// The guards that acted, and how often.
    pub given_up: BTreeMap<String, u64>,
}

impl Played {
    fn note(&mut self, law: Law, what: String) {
        self.faults.entry(law).or_insert(what);
    }
}

/// Plays the level of that seed.
pub fn play(seed: u64) -> Played {
    let mut played = Played {
        seed,
        wildness: wildness(seed),
        end: End::Played,
        ticks: 0,
        faults: BTreeMap::new(),
        slowest: 0.0,
        took: 0.0,
        held: 0,
        given_up: BTreeMap::new(),
    };
    let (held, end) = most_held(|| catch_unwind(AssertUnwindSafe(|| play_on(seed, &mut played))));
    played.held = held;
    let broken = match end {
        Ok(Ok(end)) => {
            played.end = end;
            None
        }
        Ok(Err(fault)) => Some(fault),
        Err(panic) => {
            let text = panic.downcast_ref::<String>().cloned();
            Some(text.or_else(|| panic.downcast_ref::<&str>().map(|&text| text.to_owned())).unwrap_or_default())
        }
    };
    if let Some(fault) = broken {
        played.end = End::Broken;
        played.note(Law::Runs, fault);
    }
    if played.slowest > SLOW {
        let what = format!("a tick of {:.1} ms", played.slowest * 1e3);
        played.note(Law::Quick, what);
    }
    if held > LARGE {
        played.note(Law::Small, format!("{held} bytes at once"));
    }
    played
}

fn play_on(seed: u64, played: &mut Played) -> Result<End, String> {
    let Ok(loaded) = level::read("fuzz", &level_texts(seed)) else { return Ok(End::Refused) };
    let mut game = Game::new(Arc::new(loaded.level)).map_err(|error| format!("accepted, but the engine refuses it: {error}"))?;
    let mut random = Random(!seed);
    let mut controls = Controls::default();
    while played.ticks < TICKS {
        if random.chance(0.08) {
            let mut key = || random.chance(0.4);
            controls = Controls { thrust: key(), reverse: key(), left: key(), right: key() };
        }
        let begun = ThreadTime::now();
        game.step(controls);
        let time = begun.elapsed().as_secs_f64();
        played.ticks += 1;
        played.slowest = played.slowest.max(time);
        played.took += time;
        if let Err(fault) = game.world().validate() {
            played.note(Law::of(&fault), format!("{fault} (tick {})", played.ticks));
        }
        let acted = game.world().guards().all().filter(|(_, count)| *count > 0);
        played.given_up = acted.map(|(name, count)| (name.to_owned(), count)).collect();
        let finite = |body: &Body| body.position.is_finite() && body.velocity.is_finite();
        if !game.world().bodies().iter().all(finite) {
            return Ok(End::Broken);
        }
        if played.took > ENOUGH {
            return Ok(End::TooLong);
        }
    }
    Ok(End::Played)
}
