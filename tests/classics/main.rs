//! The classics: tile run, jumper, π.

mod jumper;
mod jumper_engine;
mod pi;
#[path = "../support/mod.rs"]
mod support;
mod tile_run;
