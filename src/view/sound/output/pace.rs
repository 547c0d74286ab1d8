//! Keeps the samples at the pace of the clock. A device takes no more than fits its buffer; one that is a file or nothing takes whatever
//! it gets, and would be fed as fast as the processor can.

use std::time::Duration;

/// So far ahead of the clock is a device that does not keep the pace itself, s; and from there it is let back to the other.
const AHEAD: f64 = 0.2;
const BACK: f64 = 0.1;
/// The lead is forgotten by this share a block: clocks differ a little, and a device's own is the right one.
const FORGETS: f64 = 0.002;

/// How far the samples are ahead of the clock.
#[derive(Debug, Default)]
pub struct Pace {
    lead: f64,
}

impl Pace {
    /// A block that lasts so long was computed and taken in so much time (both s): how long to wait.
    pub fn after(&mut self, block: f64, taken: f64) -> Duration {
        self.lead = ((self.lead + block - taken) * (1.0 - FORGETS)).max(0.0);
        if self.lead < AHEAD {
            return Duration::ZERO;
        }
        let wait = self.lead - BACK;
        self.lead = BACK;
        Duration::from_secs_f64(wait)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BLOCK: f64 = 0.01;

    #[test]
    fn what_takes_everything_gets_it_at_the_clocks_pace() {
        let mut pace = Pace::default();
        let waited: Duration = (0..1000).map(|_| pace.after(BLOCK, 0.0001)).sum();
        assert!((9.0..10.0).contains(&waited.as_secs_f64()), "{waited:?}");
    }

    #[test]
    fn a_device_whose_clock_is_fast_is_never_held_up() {
        let mut pace = Pace::default();
        // Half a per cent fast for three hours; no device is worse than a fiftieth of that.
        let waited: Duration = (0..1_000_000).map(|_| pace.after(BLOCK, BLOCK * 0.995)).sum();
        assert_eq!(waited, Duration::ZERO);
    }
}
