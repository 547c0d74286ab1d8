//! Jumper: one or two players climb an endless tower of platforms, and the view, which only rises, leaves slow players behind.
//!
//! The world has three axes: x across, y depth, z up; the scene plays in x–z. Lengths are in metres, velocities in m/s.
//!
//! - [`engine`]: cuboids that fall, land, stop at walls and bounce off each other; knows no player and no tower.
//! - [`tower`]: the platforms, the same for the same seed.
//! - [`scene`]: players, keys, jumps, the rising view, the score.
//! - [`inputs`]: keys in a file.

pub mod engine;
pub mod inputs;
pub mod scene;
pub mod tower;
