//! Paces the samples by the clock. A device takes no more than fits its buffer; a file or null device takes samples as fast as the
//! processor computes them.

use std::time::Duration;

/// The lead over the clock (s) from which the device does not pace itself, and the lead to which a pause reduces it.
const AHEAD: f64 = 0.2;
const BACK: f64 = 0.1;
/// The share of the lead that is forgotten a block: clocks differ a little, and a device's own is the right one.
const FORGETS: f64 = 0.002;

/// The lead of the samples over the clock.
#[derive(Debug, Default)]
pub struct SamplePace {
    lead: f64,
}

/// Writes blocks of a length (s) until `write` refuses one, at the pace of the clock (s) that `now` reads and `pause` lets pass.
pub fn keep_pace(block: f64, mut write: impl FnMut() -> bool, now: impl Fn() -> f64, pause: impl Fn(Duration)) {
    let mut pace = SamplePace::default();
    let mut begun = now();
    while write() {
        let wait = pace.after(block, now() - begun);
        if !wait.is_zero() {
            pause(wait);
        }
        begun = now();
    }
}

impl SamplePace {
    /// The pause after a block of that length that took so long to compute and to write (both s).
    fn after(&mut self, block: f64, taken: f64) -> Duration {
        self.lead = ((self.lead + block - taken.max(0.0)) * (1.0 - FORGETS)).max(0.0);
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
        let mut pace = SamplePace::default();
        let waited: Duration = (0..1000).map(|_| pace.after(BLOCK, 0.0001)).sum();
        assert!((9.0..10.0).contains(&waited.as_secs_f64()), "{waited:?}");
    }

    /// A device that takes a block in a millisecond gets ten seconds of samples in ten seconds, by a clock that only the device and
    /// the pauses move; a twentieth more at most, since the lead fades.
    #[test]
    fn samples_are_computed_at_the_pace_of_the_clock() {
        let (clock, blocks) = (std::cell::Cell::new(0.0), std::cell::Cell::new(0));
        let write = || {
            blocks.set(blocks.get() + 1);
            clock.set(clock.get() + 0.001);
            clock.get() < 10.0
        };
        keep_pace(BLOCK, write, || clock.get(), |wait| clock.set(clock.get() + wait.as_secs_f64()));
        let seconds = f64::from(blocks.get()) * BLOCK;
        assert!((9.9..10.5 + AHEAD).contains(&seconds), "{seconds}");
    }

    #[test]
    fn a_device_whose_clock_is_fast_is_never_held_up() {
        let mut pace = SamplePace::default();
        // Half a per cent fast for three hours; no device is worse than a fiftieth of that.
        let waited: Duration = (0..1_000_000).map(|_| pace.after(BLOCK, BLOCK * 0.995)).sum();
        assert_eq!(waited, Duration::ZERO);
    }
}
