//! Takes the mixer's samples to a device, on a thread that the game never waits for: on Linux through the libraries that the system
//! has, found when the game runs (nothing is needed to build it); on Windows and macOS through `cpal`. Elsewhere there is silence.

#[cfg(any(windows, target_os = "macos"))]
mod cpal;
#[cfg(target_os = "linux")]
mod linux;
#[cfg(any(target_os = "linux", test))]
mod pace;
#[cfg(target_os = "linux")]
mod system;

use super::Feed;
#[cfg(any(target_os = "linux", windows, target_os = "macos"))]
use std::{
    sync::Arc,
    sync::atomic::{AtomicBool, Ordering},
    thread::JoinHandle,
    time::Duration,
};

#[cfg(any(windows, target_os = "macos"))]
use self::cpal::play;
#[cfg(target_os = "linux")]
use linux::play;

/// The time to the first attempt to find a device again, and the longest.
#[cfg(any(target_os = "linux", windows, target_os = "macos"))]
const RETRY: [Duration; 2] = [Duration::from_secs(4), Duration::from_secs(60)];
/// At the end the thread gets so long to let go of the device; then it is left to the system.
#[cfg(any(target_os = "linux", windows, target_os = "macos"))]
const FAREWELL: Duration = Duration::from_millis(200);

/// The thread that plays.
#[cfg(any(target_os = "linux", windows, target_os = "macos"))]
#[derive(Debug)]
pub struct Output {
    ends: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

/// Why playing has ended.
#[cfg(any(target_os = "linux", windows, target_os = "macos"))]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Why {
    /// The game has ended, or there will never be a device.
    Over,
    /// There is no device now.
    NoDevice,
    /// There was one, and it is gone.
    Lost,
}

#[cfg(any(target_os = "linux", windows, target_os = "macos"))]
impl Output {
    /// Begins to play. Where no thread can be had there is silence.
    pub fn start(feed: Feed) -> Self {
        let ends = Arc::new(AtomicBool::new(false));
        let seen = ends.clone();
        // The end of the game wakes it.
        let pause = std::thread::park_timeout;
        let thread =
            std::thread::Builder::new().name("sound".into()).spawn(move || keep_playing(|| play(&feed, &seen), pause)).ok();
        Self { ends, thread }
    }
}

/// Plays until it is over; where there is no device it is looked for again, the seldomer the longer there is none.
#[cfg(any(target_os = "linux", windows, target_os = "macos"))]
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

#[cfg(any(target_os = "linux", windows, target_os = "macos"))]
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

/// No device is known on this system.
#[cfg(not(any(target_os = "linux", windows, target_os = "macos")))]
#[derive(Debug)]
pub struct Output;

#[cfg(not(any(target_os = "linux", windows, target_os = "macos")))]
impl Output {
    /// Silence.
    pub fn start(_feed: Feed) -> Self {
        Self
    }
}

#[cfg(all(test, any(target_os = "linux", windows, target_os = "macos")))]
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
