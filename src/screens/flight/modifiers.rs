//! Shift, Ctrl and Alt fly, and they type signs: on a US keyboard `+` is Shift and `=`.

use crate::screens::{Input, Key};
use crate::settings::Action;

const MODIFIERS: [Key; 3] = [Key::Shift, Key::Control, Key::Alt];
/// The time in which a sign follows the modifier that it is typed with, s: in flight, and before an attempt has begun, where no time is lost.
const WAIT: f64 = 0.12;
const WAIT_AT_START: f64 = 0.4;

/// What a modifier that flies does: it flies a moment later, as long as it is held, unless a sign is typed with it in that moment.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
enum State {
    #[default]
    Up,
    /// It went down that long ago, s.
    Waits(f64),
    /// It has waited that long, s.
    Flies(f64),
    /// It is up again, and flies on for what it has waited, s.
    Ends(f64),
    Types,
}

#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Modifiers([State; MODIFIERS.len()]);

impl Modifiers {
    /// The input by which a frame is flown; `at_start`: of an attempt that has not begun.
    pub fn flying(&mut self, input: &Input, at_start: bool) -> Input {
        let mut flying = input.clone();
        let typed = types(input);
        for (key, state) in MODIFIERS.into_iter().zip(&mut self.0) {
            if key == Key::Shift && !input.settings.keys.needs_shift() {
                continue;
            }
            let wait = if at_start { WAIT_AT_START } else { WAIT };
            let (pressed, held) = (input.pressed.has(key), input.held.has(key));
            *state = state.after(pressed, held, typed, input.frame_time, wait);
            let flies = matches!(state, State::Flies(_) | State::Ends(_));
            flying.held = if flies { flying.held | [key].into_iter().collect() } else { flying.held.without(key) };
            flying.pressed = flying.pressed.without(key);
        }
        flying
    }
}

impl State {
    fn after(self, pressed: bool, held: bool, typed: bool, passed: f64, wait: f64) -> Self {
        let waits = |since: f64| if since >= wait { Self::Flies(since) } else { Self::Waits(since) };
        match self {
            Self::Up | Self::Ends(_) | Self::Types if pressed && typed => Self::Types,
            Self::Up | Self::Ends(_) | Self::Types if pressed && held => waits(0.0),
            Self::Up | Self::Ends(_) | Self::Types if pressed => Self::Ends(0.0),
            Self::Waits(_) if typed => Self::Types,
            Self::Waits(since) if held => waits(since + passed),
            Self::Waits(since) => Self::Ends(since + passed),
            Self::Flies(_) if held => self,
            Self::Flies(waited) => Self::Ends(waited),
            Self::Ends(left) if left > passed => Self::Ends(left - passed),
            Self::Types if held => Self::Types,
            // Held from before: nobody has seen it go down.
            Self::Up if held => waits(0.0),
            _ => Self::Up,
        }
    }
}

/// Whether a key went down that types a sign, and does not fly.
fn types(input: &Input) -> bool {
    let flies = |key: Key| {
        Action::ALL.into_iter().any(|action| action.is_by_place() && input.settings.keys.of(action).contains(&Some(key)))
    };
    input.pressed.signs().any(|key| !flies(key))
}
