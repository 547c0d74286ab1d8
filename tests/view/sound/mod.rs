//! The game's sound, computed without a device and measured: audible, never cut off, without cracks, at its pitch, of its length.
#![cfg(feature = "window")]

mod cues;
#[cfg(target_os = "linux")]
mod device;
mod flight;
mod hearing;
mod loudness;
mod surroundings;
