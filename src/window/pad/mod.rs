//! Gamepads: whatever is plugged in, now or later, becomes keys of ours. Without a gamepad, or without the system's help to find one,
//! there are none.

#[cfg(browser)]
mod page;
#[cfg(not(browser))]
mod system;

#[cfg(browser)]
pub use page::Pads;
#[cfg(not(browser))]
pub use system::Pads;

/// A stick or a trigger counts as pressed from here on, and as released again below that: between the two it stays what it is, so that
/// a hand that trembles presses once.
const PRESSED: f32 = 0.5;
const RELEASED: f32 = 0.35;

/// Whether something that is pressed that far is down, if it was before or not.
fn is_down(level: f32, before: bool) -> bool {
    level >= if before { RELEASED } else { PRESSED }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_trembling_hand_presses_once() {
        let mut down = false;
        let mut presses = 0;
        for level in [0.0, 0.3, 0.52, 0.47, 0.51, 0.44, 0.6, 0.36, 0.2, 0.4] {
            let now = is_down(level, down);
            presses += u32::from(now && !down);
            down = now;
        }
        assert_eq!((presses, down), (1, false));
    }
}
