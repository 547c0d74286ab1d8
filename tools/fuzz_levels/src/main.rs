//! `cargo run --release -- 100000 [first seed]`: so many random levels, each loaded from its texts, played for 300 ticks with random
//! keys, and held against [`World::validate`] after every tick. It prints what failed, by kind, each with a seed.
//! `cargo run --release -- show SEED`: the texts of one, and what becomes of it.
//! `cargo run --release -- worst [part of a name]`: the mean and the longest tick of scenes made to be slow.

#[path = "../../../tests/support/levels.rs"]
mod levels;
mod play;
#[path = "../../../tests/support/random.rs"]
mod random;
mod worst;

use play::{End, play};
use random::Random;
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

/// The level that is being played, for the one that never ends.
static PRESENT: AtomicU64 = AtomicU64::new(u64::MAX);
/// A level takes some milliseconds; one that takes this long is told at once.
const PATIENCE: Duration = Duration::from_secs(20);

fn main() {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let number = |at: usize| args.get(at).and_then(|text| text.parse().ok());
    match args.first().map(String::as_str) {
        Some("worst") => worst::table(args.get(1).map_or("", String::as_str)),
        Some("show") => show(number(1).expect("a seed")),
        _ => fuzz(number(1).unwrap_or(0), number(0).expect("how many levels, or `worst`, or `show SEED`")),
    }
}

fn show(seed: u64) {
    for (file, text) in levels::level_texts(seed).0 {
        println!("== {file}\n{text}");
    }
    println!("{:#?}", play(seed));
}

/// What came of all levels of one kind of end.
#[derive(Default)]
struct Row {
    count: u64,
    seed: u64,
    example: String,
}

fn fuzz(first: u64, count: u64) {
    std::thread::spawn(watch);
    std::panic::set_hook(Box::new(|_| {}));
    let mut rows: BTreeMap<String, Row> = BTreeMap::new();
    let (mut played, mut busy, mut slowest) = (0, 0, (0.0, 0));
    for seed in first..first + count {
        PRESENT.store(seed, Ordering::Relaxed);
        let played_level = play(seed);
        played += u64::from(!matches!(played_level.end, End::Refused));
        busy += u64::from(played_level.budgets_used_up > 0);
        if played_level.slowest > slowest.0 {
            slowest = (played_level.slowest, seed);
        }
        for (kind, example) in played_level.faults {
            let row = rows.entry(kind).or_default();
            row.count += 1;
            if row.count == 1 {
                (row.seed, row.example) = (seed, example);
            }
        }
    }
    println!("{count} levels, {played} of them accepted and played, {busy} of those with a budget used up");
    println!("slowest tick: {:.3} ms, seed {}", slowest.0 * 1e3, slowest.1);
    println!("| kind | levels | first seed | what |\n|---|---|---|---|");
    for (kind, Row { count, seed, example }) in &rows {
        println!("| {kind} | {count} | {seed} | {example:.300} |");
    }
    std::process::exit(i32::from(!rows.is_empty()));
}

/// Tells which level does not end.
fn watch() {
    let mut last = u64::MAX;
    loop {
        std::thread::sleep(PATIENCE);
        let now = PRESENT.load(Ordering::Relaxed);
        if now == last {
            eprintln!("seed {now} takes longer than {PATIENCE:?}");
        }
        last = now;
    }
}
