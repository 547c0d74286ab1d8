//! Takes the mixer's samples to a device, on a thread that the game never waits for: on Linux through the libraries of the system,
//! found at run time (the build needs nothing); on Windows and macOS through `cpal`. Other systems are silent.

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
/// The time in which the thread must release the device at the end; then it is left to the system.
#[cfg(any(target_os = "linux", windows, target_os = "macos"))]
const FAREWELL: Duration = Duration::from_millis(200);

#[cfg(any(target_os = "linux", windows, target_os = "macos"))]
#[derive(Debug)]
pub struct Output {
    ends: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

/// The reason for the end of playing.
#[cfg(any(target_os = "linux", windows, target_os = "macos"))]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Why {
    /// The game has ended, or there is no library.
    Over,
    /// There is no device now.
    NoDevice,
    /// The device vanished.
    Lost,
}

#[cfg(any(target_os = "linux", windows, target_os = "macos"))]
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

/// No output is known on this system.
#[cfg(not(any(target_os = "linux", windows, target_os = "macos")))]
#[derive(Debug)]
pub struct Output;

#[cfg(not(any(target_os = "linux", windows, target_os = "macos")))]
impl Output {
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
