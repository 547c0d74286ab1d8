//! The thread that plays, and looks for a device again where there is none.

use super::Why;
#[cfg(target_os = "linux")]
use super::linux::play;
use crate::sound::Feed;
use std::sync::atomic::{AtomicBool, Ordering};
use std::{sync::Arc, thread::JoinHandle, time::Duration};

/// The time to the first attempt to find a device again, and the longest.
const RETRY: [Duration; 2] = [Duration::from_secs(4), Duration::from_secs(60)];
/// The time in which the thread must release the device at the end; then it is left to the system.
const FAREWELL: Duration = Duration::from_millis(200);

pub struct Output {
    ends: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

impl Output {
    /// Begins to play; silence where no thread can start.
    pub fn start(feed: Feed) -> Self {
        let ends = Arc::new(AtomicBool::new(false));
        let seen = ends.clone();
        // The end of the game unparks it.
        let pause = std::thread::park_timeout;
        let thread =
            std::thread::Builder::new().name("sound".into()).spawn(move || keep_playing(|| play(&feed, &seen), pause)).ok();
        Self { ends, thread }
    }
}

/// Plays until the end; without a device it tries again, at growing intervals.
fn keep_playing(mut play: impl FnMut() -> Why, mut pause: impl FnMut(Duration)) {
    let mut wait = RETRY[0];
    loop {
        match play() {
            Why::Over => return,
            Why::Lost => wait = RETRY[0],
            Why::NoDevice => {}
        }
        pause(wait);
        wait = (2 * wait).min(RETRY[1]);
    }
}

impl Drop for Output {
    fn drop(&mut self) {
        self.ends.store(true, Ordering::Release);
        let Some(thread) = &self.thread else { return };
        thread.thread().unpark();
        let step = Duration::from_millis(5);
        for _ in 0..FAREWELL.div_duration_f64(step) as u32 {
            if thread.is_finished() {
                return;
            }
            std::thread::sleep(step);
        }
    }
}

#[cfg(any(windows, target_os = "macos"))]
use system::play;

/// Windows and macOS: the system asks for samples on its own thread.
#[cfg(any(windows, target_os = "macos"))]
mod system {
    use super::Why;
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
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_device_is_looked_for_seldom_and_sooner_once_there_was_one() {
        let mut found = [Why::NoDevice; 6].into_iter().chain([Why::Lost, Why::NoDevice, Why::Over]);
        let mut waits = Vec::new();
        keep_playing(|| found.next().unwrap_or(Why::Over), |wait| waits.push(wait.as_secs()));
        assert_eq!(waits, [4, 8, 16, 32, 60, 60, 4, 8]);
    }
}
