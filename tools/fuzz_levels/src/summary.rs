//! What came of all levels together.

use crate::play::{End, Law, Played};
use resultant::physics::Guards;
use std::collections::BTreeMap;

/// Prints it; whether everything held.
pub fn print(levels: &BTreeMap<u64, Played>) -> bool {
    let played = || levels.values().filter(|level| level.end != End::Refused);
    let plain = played().filter(|level| level.wildness == 0.0).count();
    println!("{} levels, {} of them accepted and played, {plain} of those without extremes", levels.len(), played().count());
    let by = |key: fn(&Played) -> f64| played().max_by(|a, b| key(a).total_cmp(&key(b)));
    if let (Some(tick), Some(level)) = (by(|level| level.slowest), by(|level| level.took)) {
        println!("slowest tick: {:.3} ms, seed {}", tick.slowest * 1e3, tick.seed);
        println!("slowest level: {:.3} s on the processor, {} ticks, seed {}", level.took, level.ticks, level.seed);
    }
    if let Some(level) = by(|level| level.held as f64) {
        println!("most memory at once: {:.1} MiB, seed {}", level.held as f64 / f64::from(1 << 20), level.seed);
    }
    let short = played().filter(|level| level.end == End::TooLong).count();
    println!("{short} were not played to their end, as they took too long");

    println!(
        "\n| what did not hold | levels | of those without extremes | where nothing had been given up | seeds | for example |\n|---|---|---|---|---|---|"
    );
    let mut well = true;
    for law in Law::ALL {
        let broken: Vec<&Played> = played().filter(|level| level.faults.contains_key(&law)).collect();
        let plain = broken.iter().filter(|level| level.wildness == 0.0).count();
        let before = broken.iter().filter(|level| level.given_up.is_empty()).count();
        let seeds: Vec<String> = broken.iter().take(8).map(|level| level.seed.to_string()).collect();
        let example = broken.first().map_or("", |level| &level.faults[&law]);
        println!("| {law:?} | {} | {plain} | {before} | {} | {example:.200} |", broken.len(), seeds.join(" "));
        well &= broken.is_empty();
    }

    println!("\n| guard | acted in levels | how often in all |\n|---|---|---|");
    for (name, _) in Guards::default().all() {
        let counts: Vec<u64> = played().filter_map(|level| level.given_up.get(name).copied()).collect();
        let never = if counts.is_empty() { " (never)" } else { "" };
        println!("| {name}{never} | {} | {} |", counts.len(), counts.iter().sum::<u64>());
    }
    well
}
