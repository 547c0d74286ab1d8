//! The page's clock.

use super::resultant_now;
use std::ops::Sub;
use std::time::Duration;

/// As [`std::time::Instant`], which a page does not have.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Instant(Duration);

impl Instant {
    pub fn now() -> Self {
        // SAFETY: it takes nothing.
        let milliseconds = unsafe { resultant_now() };
        Self(Duration::try_from_secs_f64(milliseconds / 1000.0).unwrap_or_default())
    }

    pub fn elapsed(&self) -> Duration {
        Self::now().0.saturating_sub(self.0)
    }
}

impl Sub for Instant {
    type Output = Duration;

    fn sub(self, earlier: Self) -> Duration {
        self.0.saturating_sub(earlier.0)
    }
}
