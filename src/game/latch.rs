//! From the keys of frames to the controls of ticks.

use super::controls::Controls;

/// Keeps what was pressed until a tick has taken it: a press shorter than a frame is not lost in a frame without a tick, and is not
/// repeated in a frame with two.
#[derive(Clone, Copy, Debug, Default)]
pub struct Latch {
    held: Controls,
    pressed: Controls,
}

impl Latch {
    /// Takes up which keys are down in this frame and which went down since the last one, even if they are up again.
    pub fn frame(&mut self, held: Controls, pressed: Controls) {
        self.held = held;
        self.pressed = either(self.pressed, pressed);
    }

    /// The controls of the next tick.
    pub fn take(&mut self) -> Controls {
        either(self.held, std::mem::take(&mut self.pressed))
    }

    /// Lets go of everything, as when the game is paused or starts again.
    pub fn clear(&mut self) {
        *self = Self::default();
    }
}

fn either(a: Controls, b: Controls) -> Controls {
    Controls { thrust: a.thrust || b.thrust, reverse: a.reverse || b.reverse, left: a.left || b.left, right: a.right || b.right }
}

#[cfg(test)]
mod tests {
    use super::*;

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
