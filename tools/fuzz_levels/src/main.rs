//! Random levels, each loaded from its texts, played for 300 ticks with random keys, and held against
//! [`World::validate`](resultant::physics::World::validate) after every tick.
//!
//! `cargo run --release -- fuzz 100000 --log levels.jsonl`: that number of levels, a line each in the log. Stopped and called again it goes on
//! where it was, and several may write logs of their own.
//! `… -- summary levels.jsonl …`: what those logs hold together. `… -- show SEED`: the texts of one level, and what becomes of it.
//! `… -- worst [part of a name]`: the mean and the longest tick of scenes made to be slow.

mod levels;
mod log;
#[path = "../../../tests/support/memory.rs"]
#[allow(dead_code)] // How often is asked elsewhere.
mod memory;
#[allow(clippy::disallowed_methods)] // it measures
mod play;
#[path = "../../../tests/support/random.rs"]
mod random;
mod slow;
mod summary;
#[allow(clippy::disallowed_methods)] // it measures
mod worst;

use clap::Parser;
use log::Log;
use play::play;
use random::Random;
use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

#[global_allocator]
static ALLOCATOR: memory::Counting = memory::Counting;

/// A level takes some milliseconds; one that takes this long is printed at once.
const PATIENCE: Duration = Duration::from_secs(20);
/// No level is being played.
const NONE: u64 = u64::MAX;

#[derive(Parser)]
#[command(about = "Random levels, loaded, played and held against every law")]
enum Call {
    /// Plays levels
    Fuzz {
        /// How many
        count: u64,
        /// The first of their seeds
        #[arg(long, default_value_t = 0)]
        first: u64,
        /// How many are played at once
        #[arg(long, default_value_t = 2)]
        threads: usize,
        /// Keeps what came of each; those that it holds already are not played again
        #[arg(long, default_value = "target/levels.jsonl")]
        log: PathBuf,
    },
    /// Tells what logs hold
    Summary { logs: Vec<PathBuf> },
    /// Prints a level and what becomes of it
    Show { seed: u64 },
    /// Times scenes made to be slow
    Worst {
        #[arg(default_value = "")]
        part: String,
    },
}

fn main() -> ExitCode {
    let done = match Call::parse() {
        Call::Fuzz { count, first, threads, log } => fuzz(first, count, threads, log),
        Call::Summary { logs } => log::read(&logs).map(|levels| summary::print(&levels)),
        Call::Show { seed } => {
            show(seed);
            Ok(true)
        }
        Call::Worst { part } => {
            worst::table(&part);
            Ok(true)
        }
    };
    match done {
        Ok(well) => ExitCode::from(u8::from(!well)),
        Err(error) => {
            eprintln!("{error}");
            ExitCode::from(2)
        }
    }
}

fn show(seed: u64) {
    for (file, text) in levels::level_texts(seed).0 {
        println!("== {file}\n{text}");
    }
    println!("{:#?}", play(seed));
}

/// Whether everything held in all that the log holds in the end.
fn fuzz(first: u64, count: u64, threads: usize, path: PathBuf) -> Result<bool, String> {
    let log = Log::open(&path)?;
    let left: Vec<u64> = (first..first + count).filter(|seed| !log.holds(*seed)).collect();
    let (next, log) = (AtomicU64::new(0), Mutex::new(log));
    let present: Vec<AtomicU64> = (0..threads.max(1)).map(|_| AtomicU64::new(NONE)).collect();
    std::panic::set_hook(Box::new(|_| {})); // A panic is one of the things that a level can end in.
    let work = |present: &AtomicU64| -> Result<(), String> {
        while let Some(&seed) = left.get(next.fetch_add(1, Ordering::Relaxed) as usize) {
            present.store(seed, Ordering::Relaxed);
            let level = play(seed);
            log.lock().map_err(|_| "the log was left in the middle of a line")?.add(&level)?;
        }
        present.store(NONE, Ordering::Relaxed);
        Ok(())
    };
    let work = &work;
    let played = std::thread::scope(|scope| {
        let workers: Vec<_> = present.iter().map(|present| scope.spawn(move || work(present))).collect();
        watch(&present, || workers.iter().all(|worker| worker.is_finished()));
        workers.into_iter().try_for_each(|worker| worker.join().map_err(|_| "a thread ended early".to_owned())?)
    });
    played.and_then(|()| log::read(&[path])).map(|levels| summary::print(&levels))
}

/// Tells which levels do not end, until all is done.
fn watch(present: &[AtomicU64], done: impl Fn() -> bool) {
    let (mut last, mut waited) = (vec![NONE; present.len()], Duration::ZERO);
    const PAUSE: Duration = Duration::from_millis(100);
    while !done() {
        std::thread::sleep(PAUSE);
        waited += PAUSE;
        if waited < PATIENCE {
            continue;
        }
        waited = Duration::ZERO;
        for (last, now) in last.iter_mut().zip(present) {
            let now = now.load(Ordering::Relaxed);
            if now == *last && now != NONE {
                eprintln!("seed {now} takes longer than {PATIENCE:?}");
            }
            *last = now;
        }
    }
}
