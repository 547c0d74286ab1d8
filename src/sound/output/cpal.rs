//! Output on Windows and macOS: the system asks for samples on its own thread.

use super::why::Why;
use crate::sound::{Feed, Mixer};
use cpal::traits::{DeviceTrait, HostTrait, StreamTrait};
use cpal::{ErrorKind, SampleFormat, StreamConfig};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

/// How often the thread looks for the end of the game or of the device.
const LOOK: Duration = Duration::from_millis(100);

/// Plays until the game has ended or the device is gone.
pub fn play(feed: &Feed, ends: &AtomicBool) -> Why {
    if ends.load(Ordering::Acquire) {
        return Why::Over;
    }
    let lost = Arc::new(AtomicBool::new(false));
    let Some(stream) = open(feed, &lost) else { return Why::NoDevice };
    if stream.play().is_err() {
        return Why::NoDevice;
    }
    while !ends.load(Ordering::Acquire) {
        if lost.load(Ordering::Acquire) {
            return Why::Lost;
        }
        std::thread::park_timeout(LOOK);
    }
    Why::Over
}

fn open(feed: &Feed, lost: &Arc<AtomicBool>) -> Option<cpal::Stream> {
    let device = cpal::default_host().default_output_device()?;
    let config = device.default_output_config().ok()?;
    // Both systems mix programs in this format.
    if config.sample_format() != SampleFormat::F32 {
        return None;
    }
    let config: StreamConfig = config.into();
    let channels = usize::from(config.channels).max(1);
    let mut mixer = Mixer::new(config.sample_rate, feed.clone());
    let fill = move |samples: &mut [f32], _: &cpal::OutputCallbackInfo| {
        for frame in samples.chunks_mut(channels) {
            let [left, right] = mixer.sample();
            match frame {
                [both] => *both = 0.5 * (left + right),
                [first, second, rest @ ..] => {
                    (*first, *second) = (left, right);
                    rest.fill(0.0);
                }
                [] => {}
            }
        }
    };
    let gone = lost.clone();
    let trouble = move |error: cpal::Error| match error.kind() {
        // The device goes on.
        ErrorKind::Xrun | ErrorKind::RealtimeDenied | ErrorKind::DeviceChanged => {}
        _ => gone.store(true, Ordering::Release),
    };
    device.build_output_stream(config, fill, trouble, None).ok()
}
