//! The player's keyboard: what the key at each place types, as the system tells or as it was typed. A place that is not known is as in the US layout.

use super::Key;
use std::cell::RefCell;

thread_local! {
    static SIGNS: RefCell<Vec<(Key, char)>> = const { RefCell::new(Vec::new()) };
}

/// The keys that type characters, row by row, behind the code that PC keyboards send for the first of them. Codes count on.
const ROWS: [(u8, &[Key]); 4] = {
    use Key::*;
    [
        (0x02, &[Key1, Key2, Key3, Key4, Key5, Key6, Key7, Key8, Key9, Key0, Minus, Equal]),
        (0x10, &[Q, W, E, R, T, Y, U, I, O, P, LeftBracket, RightBracket]),
        (0x1e, &[A, S, D, F, G, H, J, K, L, Semicolon, Apostrophe, GraveAccent]),
        (0x2b, &[Backslash, Z, X, C, V, B, N, M, Comma, Period, Slash]),
    ]
};

/// The keys that type characters, with the codes of their places.
pub fn printing() -> impl Iterator<Item = (u8, Key)> {
    ROWS.iter().flat_map(|(first, keys)| (*first..).zip(keys.iter().copied()))
}

pub fn prints(place: Key) -> bool {
    printing().any(|(_, key)| key == place)
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

pub fn key_at(place: Key) -> Key {
    sign_at(place).and_then(Key::typing).unwrap_or(place)
}

pub fn has(sign: char) -> bool {
    SIGNS.with_borrow(|signs| signs.iter().any(|(_, known)| *known == sign))
}

/// The sign of the key that types `+` alone, or `=`.
pub fn plus() -> char {
    if has('=') && !has('+') { '=' } else { '+' }
}
