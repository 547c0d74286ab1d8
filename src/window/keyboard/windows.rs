//! The layout of a Windows keyboard. miniquad tells of a key its place, and Windows itself composes characters.
//!
//! Unsafe code: one function of user32, which takes and gives numbers.
#![allow(unsafe_code)]

use crate::settings::{Key, layout};

/// `MAPVK_VSC_TO_VK` and `MAPVK_VK_TO_CHAR`
const CODE_TO_KEY: u32 = 1;
const KEY_TO_CHARACTER: u32 = 2;
/// A dead key has the highest bit as well.
const CHARACTER: u32 = 0xffff;

#[link(name = "user32")]
unsafe extern "system" {
    fn MapVirtualKeyW(code: u32, kind: u32) -> u32;
}

/// What the key at that place types alone.
pub fn plain(place: Key) -> Option<char> {
    let (code, _) = layout::printing().find(|(_, key)| *key == place)?;
    // SAFETY: it takes any numbers.
    let character = unsafe { MapVirtualKeyW(MapVirtualKeyW(u32::from(code), CODE_TO_KEY), KEY_TO_CHARACTER) };
    char::from_u32(character & CHARACTER).filter(|sign| *sign != '\0').and_then(|sign| sign.to_lowercase().next())
}
