//! Shift, Ctrl and Alt fly, and they type signs: on a US keyboard `+` is Shift and `=`. A modifier flies at once. Where a sign is typed with it
//! soon after it went down, it has typed: what it has flown is taken back, and it flies no more until it goes down again.

use crate::settings::{Action, Key, Keys};
use crate::ui::input::Input;

const MODIFIERS: [Key; 3] = [Key::Shift, Key::Control, Key::Alt];
/// The time in which a sign follows the modifier that it is typed with, s.
pub(super) const SOON: f64 = 0.5;

#[derive(Clone, Copy, Debug, Default)]
enum ModifierState {
    #[default]
    Up,
    /// From that tick on.
    Flies(u64),
    Types,
}

/// Modifiers that have flown since a tick, and typed.
pub(super) struct Mistaken {
    pub since: u64,
    pub keys: Keys,
}

#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Modifiers([ModifierState; MODIFIERS.len()]);

impl Modifiers {
    /// The input by which a frame is flown after `now` ticks, and what was flown by mistake, of which `soon` ticks at most are taken back.
    pub fn flying(&mut self, input: &Input, now: u64, soon: u64) -> (Input, Option<Mistaken>) {
        let mut flying = input.clone();
        let mut mistaken: Option<Mistaken> = None;
        let typed = types(input);
        for (key, state) in MODIFIERS.into_iter().zip(&mut self.0) {
            if key == Key::Shift && !input.settings.keys.needs_shift() {
                continue;
            }
            let (pressed, held) = (input.pressed.has(key), input.held.has(key));
            *state = match *state {
                _ if pressed && typed => ModifierState::Types,
                ModifierState::Flies(since) if held && typed && now.saturating_sub(since) <= soon => {
                    let before = mistaken.take().unwrap_or(Mistaken { since, keys: Keys::default() });
                    let keys = before.keys | [key].into_iter().collect();
                    mistaken = Some(Mistaken { since: before.since.min(since), keys });
                    ModifierState::Types
                }
                ModifierState::Types if held && !pressed => ModifierState::Types,
                ModifierState::Flies(since) if held && !pressed => ModifierState::Flies(since),
                _ if pressed || held => ModifierState::Flies(now),
                _ => ModifierState::Up,
            };
            if matches!(state, ModifierState::Types) {
                flying.held = flying.held.without(key);
                flying.pressed = flying.pressed.without(key);
            }
        }
        (flying, mistaken)
    }
}

/// Whether a key went down that types a sign, and does not fly.
fn types(input: &Input) -> bool {
    let flies = |key: Key| {
        Action::ALL.into_iter().any(|action| action.is_by_place() && input.settings.keys.of(action).contains(&Some(key)))
    };
    input.pressed.signs().any(|key| !flies(key))
}
