//! The player's keyboard: what the key at each place types, as the system tells or as it was typed. A place that is not known is as in the
//! US layout.

use super::Key;
use std::cell::RefCell;

thread_local! {
    static SIGNS: RefCell<Vec<(Key, char)>> = const { RefCell::new(Vec::new()) };
}

/// The keys that type characters, with the codes of their places that PC keyboards send.
pub const PRINTING: [(u8, Key); 47] = {
    use Key::*;
    [
        (0x02, Key1),
        (0x03, Key2),
        (0x04, Key3),
        (0x05, Key4),
        (0x06, Key5),
        (0x07, Key6),
        (0x08, Key7),
        (0x09, Key8),
        (0x0a, Key9),
        (0x0b, Key0),
        (0x0c, Minus),
        (0x0d, Equal),
        (0x10, Q),
        (0x11, W),
        (0x12, E),
        (0x13, R),
        (0x14, T),
        (0x15, Y),
        (0x16, U),
        (0x17, I),
        (0x18, O),
        (0x19, P),
        (0x1a, LeftBracket),
        (0x1b, RightBracket),
        (0x1e, A),
        (0x1f, S),
        (0x20, D),
        (0x21, F),
        (0x22, G),
        (0x23, H),
        (0x24, J),
        (0x25, K),
        (0x26, L),
        (0x27, Semicolon),
        (0x28, Apostrophe),
        (0x29, GraveAccent),
        (0x2b, Backslash),
        (0x2c, Z),
        (0x2d, X),
        (0x2e, C),
        (0x2f, V),
        (0x30, B),
        (0x31, N),
        (0x32, M),
        (0x33, Comma),
        (0x34, Period),
        (0x35, Slash),
    ]
};

/// Whether the key at that place types a character.
pub fn prints(place: Key) -> bool {
    PRINTING.iter().any(|(_, key)| *key == place)
}

/// The key at that place types that character alone.
pub fn note(place: Key, sign: char) {
    if !prints(place) || sign.is_control() || sign.is_whitespace() {
        return;
    }
    SIGNS.with_borrow_mut(|signs| {
        signs.retain(|(known, _)| *known != place);
        signs.push((place, sign));
    });
}

/// What the key at that place types alone, where that is known.
pub fn sign_at(place: Key) -> Option<char> {
    SIGNS.with_borrow(|signs| signs.iter().find(|(known, _)| *known == place).map(|(_, sign)| *sign))
}

/// The key at that place, by what it types.
pub fn key_at(place: Key) -> Key {
    sign_at(place).and_then(Key::typing).unwrap_or(place)
}

/// Whether a key is known to type that alone.
pub fn has(sign: char) -> bool {
    SIGNS.with_borrow(|signs| signs.iter().any(|(_, known)| *known == sign))
}

/// The sign of the key that types `+` alone, or `=`.
pub fn plus() -> char {
    if has('=') && !has('+') { '=' } else { '+' }
}
