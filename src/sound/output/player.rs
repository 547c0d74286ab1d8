//! The thread that plays, and looks for a device again where there is none.

#[cfg(any(windows, target_os = "macos"))]
use super::cpal::play;
#[cfg(target_os = "linux")]
use super::linux::play;
use super::why::Why;
use crate::sound::Feed;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::JoinHandle;
use std::time::Duration;

/// The time to the first attempt to find a device again, and the longest.
const RETRY: [Duration; 2] = [Duration::from_secs(4), Duration::from_secs(60)];
/// The time in which the thread must release the device at the end; then it is left to the system.
const FAREWELL: Duration = Duration::from_millis(200);

#[derive(Debug)]
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
