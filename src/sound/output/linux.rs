//! Output on Linux: the thread computes and writes block after block; the device holds it until there is room.

use super::pace::keep_pace;
use super::system::{CHANNELS, Device, LATENCY, Libraries, RATE};
use super::why::Why;
use crate::sound::{Feed, Mixer};
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
    let (begun, mut lost) = (Instant::now(), false);
    let write = || {
        if ends.load(Ordering::Acquire) {
            return false;
        }
        mixer.render(&mut samples);
        lost = !device.write(&samples);
        !lost
    };
    keep_pace(BLOCK as f64 / f64::from(RATE), write, || begun.elapsed().as_secs_f64(), std::thread::sleep);
    if lost {
        return Why::Lost;
    }
    // The last block fades out and is heard before the device closes.
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
