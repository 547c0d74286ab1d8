//! Three small classics, each with just the model that its scene needs; none of them uses the game's engine. Here are their models,
//! headless: text, keys and ticks are handed in. Their screens are in `screens`, their subcommands in [`crate::cli`].
//!
//! - [`tile_run`]: a point runs and jumps through a map of tiles, a command a frame, exact to the last bit.
//! - [`jumper`]: two players climb an endless tower of platforms; its own engine of cuboids.
//! - [`pi`]: two blocks and a wall, whose collisions count out the digits of π.

pub mod jumper;
pub mod pi;
pub mod tile_run;
