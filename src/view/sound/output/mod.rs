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
        let thread = std::thread::Builder::new().name("sound".into()).spawn(move || keep_playing(&feed, &seen)).ok();
        Self { ends, thread }
    }
}

#[cfg(any(target_os = "linux", windows, target_os = "macos"))]
fn keep_playing(feed: &Feed, ends: &AtomicBool) {
    let mut wait = RETRY[0];
    loop {
        match play(feed, ends) {
            Why::Over => return,
            Why::Lost => wait = RETRY[0],
            Why::NoDevice => {}
        }
        std::thread::park_timeout(wait);
        if ends.load(Ordering::Acquire) {
            return;
        }
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
