//! How many ticks are flown in a frame beside what is shown: as many as frames stay short with.

/// A frame that takes longer than this is no short one, s.
const SHORT_FRAME: f64 = 1.0 / 40.0;

#[derive(Clone, Copy, Debug)]
pub struct Ahead {
    ticks: u64,
    least: u64,
    most: u64,
}

impl Default for Ahead {
    fn default() -> Self {
        Self::within([30, 240, 4000])
    }
}

impl Ahead {
    /// At least, at first and at most that number of ticks.
    pub const fn within([least, ticks, most]: [u64; 3]) -> Self {
        Self { ticks, least, most }
    }

    /// How many it is to be after a frame that took so long, s; as before where no time has passed.
    pub fn ticks(&mut self, frame_time: f64) -> u64 {
        if frame_time > 0.0 {
            let wanted = if frame_time > SHORT_FRAME { self.ticks / 2 } else { self.ticks * 5 / 4 };
            self.ticks = wanted.clamp(self.least, self.most);
        }
        self.ticks
    }
}
