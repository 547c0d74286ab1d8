//! From the keys of frames to the controls of ticks.

use super::controls::Controls;

/// Keeps a press until a tick has taken it: a press shorter than a frame survives a frame without a tick, and counts once in a
/// frame with two.
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
