//! Takes the mixer's samples to a device, on a thread that the game never waits for: on Linux through the libraries of the system, found at run time
//! (the build needs nothing); on Windows and macOS through `cpal`; in a browser by the page's script. Other systems are silent.

#[cfg(target_os = "linux")]
mod linux;
#[cfg(any(target_os = "linux", windows, target_os = "macos"))]
mod player;

#[cfg(any(target_os = "linux", windows, target_os = "macos"))]
pub use player::Output;

#[cfg(browser)]
pub use crate::web::Output;

#[cfg(any(target_os = "linux", windows, target_os = "macos"))]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Why {
    /// The game has ended, or there is no library.
    Over,
    /// There is no device now.
    NoDevice,
    Lost,
}

/// No output is known on this system.
#[cfg(not(any(target_os = "linux", windows, target_os = "macos", browser)))]
#[derive(Debug)]
pub struct Output;

#[cfg(not(any(target_os = "linux", windows, target_os = "macos", browser)))]
impl Output {
    pub fn start(_feed: super::Feed) -> Self {
        Self
    }
}
