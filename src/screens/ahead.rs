//! How many ticks are flown in a frame beside what is shown: as many as frames stay short with.

/// At least, at first and at most.
const TICKS: [u64; 3] = [30, 240, 4000];
/// A frame that takes longer than this is no short one, s.
const SHORT_FRAME: f64 = 1.0 / 40.0;

/// The number.
#[derive(Clone, Copy, Debug)]
pub struct Ahead(u64);

impl Default for Ahead {
    fn default() -> Self {
        Self(TICKS[1])
    }
}

impl Ahead {
    /// How many it is to be after a frame that took so long, s; as before where no time has passed.
    pub fn ticks(&mut self, frame_time: f64) -> u64 {
        if frame_time > 0.0 {
            let [least, _, most] = TICKS;
            self.0 = if frame_time > SHORT_FRAME { self.0 / 2 } else { self.0 * 5 / 4 }.clamp(least, most);
        }
        self.0
    }
}
