//! Shared by the test programs: random numbers, builders of scenes and levels, and measures. Random levels, slow scenes and the adversary
//! are those of the tools.
#![allow(dead_code, unused_imports)] // Each test takes what it needs.

#[path = "../../tools/autopilot/src/adversary/mod.rs"]
pub mod adversary;
mod ask;
mod build;
pub mod dense;
pub mod hashes;
pub mod lanes;
#[path = "../../tools/fuzz_levels/src/levels.rs"]
mod levels;
mod measure;
pub mod memory;
pub mod motion;
pub mod program;
mod random;
pub mod rooms;
pub mod scenes;
pub mod shipped;
#[path = "../../tools/fuzz_levels/src/slow.rs"]
pub mod slow;
pub mod strategies;
pub mod tiled;
pub mod turned;
pub mod written;

pub use ask::Ask;
pub use build::{BODY, G, TICK, area, block, crate_at, crowd, elastic, floor, pool, room, v, world};
pub use levels::{Memory, level_texts};
pub use measure::{
    assert_all_at_rest, bits, bits_of_body, crushed, deepest, energy, from_below, momentum, momentum_scale, named_forces, run,
    worst_overlap,
};
pub use random::Random;
