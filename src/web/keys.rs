//! The page's keyboard: a key's place is its code, and the browser composes what it types.

use super::handed_over;
use crate::number::hash;
use crate::settings::{Key, Keys, layout};
use crate::ui::keyboard::{KeyDown, Keyboard, place_of_code};
use std::cell::RefCell;

thread_local! {
    static QUEUE: RefCell<Vec<KeyMessage>> = const { RefCell::new(Vec::new()) };
}

enum KeyMessage {
    /// What it types, and the modifiers: bits of Shift, Control, Alt or AltGr, then of a repetition and of Caps Lock.
    Down(String, Option<char>, u32),
    Up(String),
    Types(char),
    Sign(String, char),
    Leave,
}

pub fn drain(keyboard: &mut Keyboard) {
    for message in QUEUE.take() {
        match message {
            KeyMessage::Down(code, typed, bits) => {
                let place = place_of_code(&code);
                let held: Keys = [Key::Shift, Key::Control, Key::Alt]
                    .into_iter()
                    .enumerate()
                    .filter(|(i, _)| bits >> i & 1 != 0)
                    .map(|(_, key)| key)
                    .collect();
                let plain = if bits & 0b1_0111 == 0 { typed } else { place.and_then(layout::sign_at) };
                keyboard.down(KeyDown { id: hash(&code), place, typed, silent: true, plain, repeat: bits & 8 != 0, held });
            }
            KeyMessage::Up(code) => keyboard.up(hash(&code)),
            KeyMessage::Types(sign) => keyboard.typed(sign, Keys::default()),
            KeyMessage::Sign(code, sign) => place_of_code(&code).into_iter().for_each(|place| layout::note(place, sign)),
            KeyMessage::Leave => keyboard.leave(),
        }
    }
}

fn queue(message: KeyMessage) {
    QUEUE.with_borrow_mut(|all| all.push(message));
}

fn text(at: *mut u8, length: usize) -> String {
    // SAFETY: the script hands over what it has just filled.
    String::from_utf8_lossy(&unsafe { handed_over(at, length) }).into_owned()
}

fn character(sign: u32) -> Option<char> {
    char::from_u32(sign).filter(|sign| *sign != '\0')
}

#[unsafe(no_mangle)]
extern "C" fn resultant_key_down(code: *mut u8, length: usize, sign: u32, bits: u32) {
    queue(KeyMessage::Down(text(code, length), character(sign), bits));
}

#[unsafe(no_mangle)]
extern "C" fn resultant_key_up(code: *mut u8, length: usize) {
    queue(KeyMessage::Up(text(code, length)));
}

#[unsafe(no_mangle)]
extern "C" fn resultant_key_types(sign: u32) {
    character(sign).into_iter().for_each(|sign| queue(KeyMessage::Types(sign)));
}

/// What a key types alone.
#[unsafe(no_mangle)]
extern "C" fn resultant_key_sign(code: *mut u8, length: usize, sign: u32) {
    let code = text(code, length);
    character(sign).into_iter().for_each(|sign| queue(KeyMessage::Sign(code.clone(), sign)));
}

#[unsafe(no_mangle)]
extern "C" fn resultant_keys_leave() {
    queue(KeyMessage::Leave);
}
