//! What it costs to go to any tick of a flight of ten minutes, to keep the copies that make it possible, and to take a step back.

use criterion::{BatchSize, Criterion, criterion_group, criterion_main};
use resultant::game::{Controls, Game, History, TICK_RATE};
use resultant::level::{self, Level};
use std::hint::black_box;
use std::path::Path;
use std::sync::Arc;

/// Ten minutes.
const TICKS: u64 = 600 * TICK_RATE as u64;

fn level(name: &str) -> Arc<Level> {
    let root = &Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures");
    Arc::new(level::load(&root.join("levels").join(name), root).unwrap().level)
}

/// A flight that hops and turns, and is lost sooner or later; then it waits on in a level from which nothing was taken away.
fn flown(level: Arc<Level>) -> History {
    let mut game = Game::new(level).unwrap();
    let mut history = History::new(&game);
    for tick in 0..TICKS {
        let controls = Controls { left: tick % 400 < 20, right: (200..220).contains(&(tick % 400)), ..Controls::default() };
        game.step(controls);
        history.note(&game, controls);
    }
    history
}

fn seeking(c: &mut Criterion) {
    for name in ["1", "15"] {
        let level = level(name);
        let history = flown(level.clone());
        let start = history.at(0);
        let mut group = c.benchmark_group(format!("level {name}"));
        group.sample_size(10);
        // The tick before a copy is the furthest from the one before it.
        let worst = history.copies().1 - 1 + history.copies().1 * (history.copies().0 as u64 - 2);
        group.bench_function("any tick, at worst", |b| {
            b.iter_batched_ref(|| start.clone(), |game| history.seek(game, black_box(worst)), BatchSize::LargeInput);
        });
        group.bench_function("a copy", |b| b.iter(|| black_box(&start).clone()));
        group.bench_function("120 ticks with their history", |b| {
            b.iter_batched_ref(
                || (start.clone(), History::new(&start)),
                |(game, history)| {
                    for _ in 0..120 {
                        game.step(Controls::default());
                        history.note(game, Controls::default());
                    }
                },
                BatchSize::LargeInput,
            );
        });
        group.finish();
    }
}

criterion_group!(benches, seeking);
criterion_main!(benches);
