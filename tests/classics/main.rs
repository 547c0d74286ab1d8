//! The classics: tile run, jumper, π.

mod jumper;
mod jumper_engine;
mod pi;
mod tile_run;
