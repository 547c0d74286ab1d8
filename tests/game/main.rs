//! One run of a level: the rules, what is built into levels, and the flights that are recorded.

mod built_levels;
mod determinism;
mod hazards;
mod history;
mod level_fuzz;
mod movers;
mod records;
mod rules;
mod shipped_levels;
#[path = "../support/mod.rs"]
mod support;
mod switches;
mod tricks;
mod work;
