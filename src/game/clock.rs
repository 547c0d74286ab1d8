//! From frame times to whole ticks (Glenn Fiedler, "Fix Your Timestep!"), and from the keys of frames to the controls of ticks.

pub use crate::level::TICK_RATE;
use std::ops::RangeInclusive;

/// Hz. Below, a tick is longer than a player's reaction; above, a tick moves a body by less than rounding.
pub const TICK_RATES: RangeInclusive<f64> = 1.0..=1e6;
/// The most ticks of one frame, a 15th of a second at the game's rate. More, and a slow machine falls into a spiral of ever longer
/// frames; fewer, and the game slows down sooner.
pub const TICKS_A_FRAME: u32 = 8;

/// A time that is this little short of a tick counts as one, ticks: 24 frames of 1/144 s are 20 ticks but for rounding. Without it
/// such a tick comes a frame late and takes the keys of that frame.
const ROUNDING: f64 = 1e-6;

#[derive(Clone, Debug)]
pub struct Clock {
    tick_rate: f64,
    /// Due ticks and a part of the next one.
    pending: f64,
    dropped: f64,
}

impl Clock {
    pub const fn new(tick_rate: f64) -> Self {
        Self { tick_rate, pending: 0.0, dropped: 0.0 }
    }

    /// Adds a frame's time, s. At most [`TICKS_A_FRAME`] ticks stay pending; the whole ticks beyond that are dropped and counted. A
    /// time that is no positive number of ticks adds nothing.
    pub fn add(&mut self, frame_time: f64) {
        let ticks = frame_time * self.tick_rate;
        if !(ticks > 0.0 && ticks.is_finite()) {
            return;
        }
        self.pending += ticks;
        let (whole, most) = ((self.pending + ROUNDING).floor(), f64::from(TICKS_A_FRAME));
        if whole > most {
            self.pending = most + (self.pending - whole);
            self.dropped += whole - most;
        }
    }

    pub fn tick(&mut self) -> bool {
        let due = self.pending >= 1.0 - ROUNDING;
        if due {
            self.pending -= 1.0;
        }
        due
    }

    /// The place of the time between the last tick and the next one, 0 … 1, at which the view draws.
    pub fn alpha(&self) -> f64 {
        self.pending.clamp(0.0, 1.0)
    }

    /// Ticks.
    pub fn dropped(&self) -> f64 {
        self.dropped
    }
}

/// Keeps a press until a tick has taken it: a press shorter than a frame survives a frame without a tick, and counts once in a frame with two.
#[derive(Clone, Copy, Debug, Default)]
pub struct Latch {
    held: Controls,
    pressed: Controls,
}

impl Latch {
    /// Takes the keys that are down in this frame, and the ones that went down since the last frame, even if they are up again.
    pub fn frame(&mut self, held: Controls, pressed: Controls) {
        self.held = held;
        self.pressed = either(self.pressed, pressed);
    }

    pub fn take(&mut self) -> Controls {
        either(self.held, std::mem::take(&mut self.pressed))
    }

    pub fn clear(&mut self) {
        *self = Self::default();
    }
}

fn either(a: Controls, b: Controls) -> Controls {
    Controls { thrust: a.thrust || b.thrust, reverse: a.reverse || b.reverse, left: a.left || b.left, right: a.right || b.right }
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Controls {
    pub thrust: bool,
    /// Thrust against the nose.
    pub reverse: bool,
    /// Anticlockwise.
    pub left: bool,
    /// Clockwise.
    pub right: bool,
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ticks(clock: &mut Clock, frame_time: f64) -> u32 {
        clock.add(frame_time);
        std::iter::from_fn(|| clock.tick().then_some(())).count() as u32
    }

    #[test]
    fn every_frame_rate_gets_its_ticks() {
        for frame_rate in [24.0, 30.0, 60.0, 75.0, 144.0, 1000.0] {
            let mut clock = Clock::new(120.0);
            let total: u32 = (0..frame_rate as u32 * 10).map(|_| ticks(&mut clock, 1.0 / frame_rate)).sum();
            assert!((1199..=1200).contains(&total), "{total} ticks in 10 s at {frame_rate} frames a second");
            assert_eq!(clock.dropped(), 0.0);
        }
    }

    #[test]
    fn frames_that_are_whole_ticks_together_get_them_with_the_last() {
        for (frames, frame_rate) in [(24, 144.0), (4, 24.0), (5, 30.0), (40, 240.0), (160, 960.0)] {
            let mut clock = Clock::new(120.0);
            for slot in 0..1000 {
                let handed_out: u32 = (0..frames).map(|_| ticks(&mut clock, 1.0 / frame_rate)).sum();
                assert_eq!(handed_out, 20, "{frame_rate} frames a second, slot {slot}");
            }
        }
        // Neither does it make a ninth tick of eight and nearly one.
        let mut clock = Clock::new(1.0);
        assert_eq!((ticks(&mut clock, 9.0_f64.next_down()), clock.dropped()), (8, 1.0));
    }

    #[test]
    fn alpha_is_what_is_left_over() {
        let mut clock = Clock::new(100.0);
        assert_eq!(ticks(&mut clock, 0.0125), 1);
        assert!((clock.alpha() - 0.25).abs() < 1e-12);
        assert_eq!(ticks(&mut clock, 0.0050), 0);
        assert!((clock.alpha() - 0.75).abs() < 1e-12);
    }

    #[test]
    fn a_hitch_gives_eight_ticks_and_drops_the_rest_openly() {
        let mut clock = Clock::new(120.0);
        assert_eq!(ticks(&mut clock, 2.0), TICKS_A_FRAME);
        assert_eq!(clock.dropped(), 232.0);
        assert_eq!(ticks(&mut clock, 1.0 / 60.0), 2);
        assert_eq!(ticks(&mut clock, 1e300), TICKS_A_FRAME);
        assert_eq!(ticks(&mut clock, 0.0), 0);
    }

    #[test]
    fn eight_ticks_and_a_bit_lose_nothing() {
        let mut clock = Clock::new(120.0);
        let total: u32 = (0..100).map(|_| ticks(&mut clock, 8.5 / 120.0)).sum();
        assert_eq!((total, clock.dropped()), (800, 50.0));
        assert!(clock.alpha() < 1.0);
    }

    #[test]
    fn nonsense_adds_nothing() {
        let mut clock = Clock::new(120.0);
        clock.add(0.004);
        let before = clock.alpha();
        for nonsense in [f64::NAN, f64::MAX, f64::INFINITY, f64::NEG_INFINITY, -1.0, -0.0] {
            assert_eq!(ticks(&mut clock, nonsense), 0, "{nonsense}");
        }
        assert_eq!((clock.alpha(), clock.dropped()), (before, 0.0));
    }

    const NONE: Controls = Controls { thrust: false, reverse: false, left: false, right: false };
    const THRUST: Controls = Controls { thrust: true, ..NONE };
    const LEFT: Controls = Controls { left: true, ..NONE };

    #[test]
    fn a_short_press_lasts_one_tick() {
        let mut latch = Latch::default();
        latch.frame(NONE, THRUST);
        assert_eq!([latch.take(), latch.take()], [THRUST, NONE]);
    }

    #[test]
    fn a_press_waits_for_a_tick() {
        let mut latch = Latch::default();
        latch.frame(THRUST, THRUST);
        latch.frame(NONE, NONE);
        latch.frame(LEFT, LEFT);
        assert_eq!(latch.take(), Controls { thrust: true, left: true, ..NONE });
        assert_eq!(latch.take(), LEFT);
    }

    #[test]
    fn a_held_key_goes_on_and_a_released_one_ends() {
        let mut latch = Latch::default();
        latch.frame(THRUST, THRUST);
        assert_eq!([latch.take(), latch.take()], [THRUST; 2]);
        latch.frame(NONE, NONE);
        assert_eq!(latch.take(), NONE);
    }

    #[test]
    fn clearing_lets_go() {
        let mut latch = Latch::default();
        latch.frame(THRUST, LEFT);
        latch.clear();
        assert_eq!(latch.take(), NONE);
    }
}
