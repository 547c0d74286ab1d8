//! Playing on Linux: block after block is computed and written; the device holds the thread until it has room.

use super::pace::Pace;
use super::system::{CHANNELS, Device, LATENCY, Libraries, RATE};
use super::{Feed, Why};
use crate::view::sound::Mixer;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// Samples a block and channel: 10 ms.
const BLOCK: usize = RATE as usize / 100;

/// Plays until the game has ended or the device is gone.
pub fn play(feed: &Feed, ends: &AtomicBool) -> Why {
    if ends.load(Ordering::Acquire) {
        return Why::Over;
    }
    let Some(libraries) = Libraries::load() else { return Why::Over };
    let Some(mut device) = Device::open(libraries) else { return Why::NoDevice };
    let mut mixer = Mixer::new(RATE, feed.clone());
    let mut samples = [0.0; BLOCK * CHANNELS];
    let mut pace = Pace::default();
    let mut begun = Instant::now();
    while !ends.load(Ordering::Acquire) {
        mixer.render(&mut samples);
        if !device.write(&samples) {
            return Why::Lost;
        }
        let wait = pace.after(BLOCK as f64 / f64::from(RATE), begun.elapsed().as_secs_f64());
        if !wait.is_zero() {
            std::thread::sleep(wait);
        }
        begun = Instant::now();
    }
    // The last block goes down to nothing, and is heard before the device is closed.
    mixer.render(&mut samples);
    let length = samples.len() as f32;
    for (i, sample) in samples.iter_mut().enumerate() {
        *sample *= 1.0 - i as f32 / length;
    }
    if device.write(&samples) {
        std::thread::sleep(Duration::from_millis(LATENCY.into()));
    }
    Why::Over
}
