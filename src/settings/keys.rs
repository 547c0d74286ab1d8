//! Keys and sets of them.

use super::layout;
use crate::words::tr;
use std::fmt;

/// Every key with one place on the keyboard, by its name in the settings' file and in the window.
macro_rules! plain_keys {
    ($with:ident) => {
        $with! {
            Up Down Left Right Escape Space Tab PageUp PageDown Home End Backspace Delete Insert
            A B C D E F G H I J K L M N O P Q R S T U V W X Y Z
            Key0 Key1 Key2 Key3 Key4 Key5 Key6 Key7 Key8 Key9
            F1 F2 F3 F4 F5 F6 F7 F8 F9 F10 F11 F12
            Apostrophe Comma Minus Period Slash Semicolon Equal LeftBracket Backslash RightBracket GraveAccent
            Kp0 Kp1 Kp2 Kp3 Kp4 Kp5 Kp6 Kp7 Kp8 Kp9 KpDecimal KpDivide KpMultiply KpSubtract KpAdd
        }
    };
}
#[cfg(feature = "window")]
pub(crate) use plain_keys;

macro_rules! keys {
    ($($plain:ident)*) => {
        named_keys! {
            $($plain)* Enter Shift Control Alt
            PadUp PadDown PadLeft PadRight PadA PadB PadX PadY PadStart PadSelect PadL1 PadR1 PadL2 PadR2
        }
    };
}

macro_rules! named_keys {
    ($($name:ident)*) => {
        /// A key of the keyboard, or a button of a gamepad. `Enter` is also that of the number pad, `Shift`, `Control` and `Alt` are left or
        /// right, `Equal` types `+` or `=`: on most keyboards they are one key.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[allow(missing_docs)] // A key's name says which one it is.
        pub enum Key {
            $($name,)*
            /// The key that types a character without a name here, in small letters: `ö`, `<`.
            Sign(char),
        }

        enum Bit {
            $($name,)*
        }

        impl Key {
            pub const ALL: &[Self] = &[$(Self::$name),*];

            /// Its bit in a set; a sign has none.
            const fn bit(self) -> Option<u32> {
                match self {
                    $(Self::$name => Some(Bit::$name as u32),)*
                    Self::Sign(_) => None,
                }
            }
        }
    };
}
plain_keys!(keys);

impl Key {
    /// In any case of the letters, or by the character that it types.
    pub fn named(name: &str) -> Option<Self> {
        let typed = || name.chars().next().filter(|sign| sign.len_utf8() == name.len()).and_then(Self::typing);
        Self::ALL.iter().copied().find(|key| key.to_string().eq_ignore_ascii_case(name)).or_else(typed)
    }

    /// The key that types a character, with or without Shift.
    pub fn typing(sign: char) -> Option<Self> {
        Some(match sign.to_lowercase().next().unwrap_or(sign) {
            letter @ ('a'..='z' | '0'..='9') => {
                let name = if letter.is_ascii_digit() { format!("Key{letter}") } else { letter.to_ascii_uppercase().to_string() };
                return Self::ALL.iter().copied().find(|key| key.to_string() == name);
            }
            '=' | '+' => Self::Equal,
            '-' | '−' => Self::Minus,
            sign if sign.is_control() || sign.is_whitespace() => return None,
            sign => Self::SIGNS.iter().find(|(_, known)| *known == sign).map_or(Self::Sign(sign), |(key, _)| *key),
        })
    }

    /// The signs of the keys that are named after them.
    const SIGNS: [(Self, char); 11] = [
        (Self::Apostrophe, '\''),
        (Self::Comma, ','),
        (Self::Minus, '-'),
        (Self::Period, '.'),
        (Self::Slash, '/'),
        (Self::Semicolon, ';'),
        (Self::Equal, '='),
        (Self::LeftBracket, '['),
        (Self::RightBracket, ']'),
        (Self::Backslash, '\\'),
        (Self::GraveAccent, '`'),
    ];

    /// The sign that it types: no letter, digit or space.
    pub(crate) fn typed(self) -> Option<char> {
        match self {
            Self::Equal => Some('+'),
            Self::Sign(sign) => Some(sign),
            key => Self::SIGNS.iter().find(|(known, _)| *known == key).map(|(_, sign)| *sign),
        }
    }

    pub(crate) fn is_letter(self) -> bool {
        self.to_string().len() == 1 && !matches!(self, Self::Sign(_))
    }

    /// The sign that the key types, or its name in the language of the screens.
    pub fn label(self) -> String {
        match self {
            Self::Equal => layout::plus().to_string(),
            key => tr(&key.sign()).to_owned(),
        }
    }

    /// The sign on the key at that place of the player's keyboard.
    pub fn label_by_place(self) -> String {
        layout::sign_at(self).map_or_else(|| tr(&self.sign()).to_owned(), on_key)
    }

    fn sign(self) -> String {
        match self {
            Self::Up => "↑".into(),
            Self::Down => "↓".into(),
            Self::Left => "←".into(),
            Self::Right => "→".into(),
            Self::Escape => "Esc".into(),
            Self::PageUp => "Page Up".into(),
            Self::PageDown => "Page Down".into(),
            Self::Control => "Ctrl".into(),
            Self::Sign(sign) => on_key(sign),
            Self::KpAdd => "Num +".into(),
            Self::KpSubtract => "Num -".into(),
            Self::PadL1 => "left shoulder".into(),
            Self::PadR1 => "right shoulder".into(),
            Self::PadL2 => "left trigger".into(),
            Self::PadR2 => "right trigger".into(),
            other => {
                if let Some((_, sign)) = Self::SIGNS.iter().find(|(key, _)| *key == other) {
                    return sign.to_string();
                }
                let name = other.to_string();
                let of = |start: &str, words: &str| name.strip_prefix(start).map(|rest| format!("{words}{rest}"));
                of("Key", "").or_else(|| of("Kp", "Num ")).or_else(|| of("Pad", "Pad ")).unwrap_or(name)
            }
        }
    }

    pub fn is_pad(self) -> bool {
        self.bit() >= Self::PadUp.bit()
    }

    /// The gamepad's button with the same effect in menus.
    pub(crate) const fn on_pad(self) -> Option<Self> {
        match self {
            Self::Up => Some(Self::PadUp),
            Self::Down => Some(Self::PadDown),
            Self::Left => Some(Self::PadLeft),
            Self::Right => Some(Self::PadRight),
            Self::Enter => Some(Self::PadA),
            Self::Escape => Some(Self::PadB),
            Self::PageUp => Some(Self::PadL1),
            Self::PageDown => Some(Self::PadR1),
            _ => None,
        }
    }
}

/// The name in the settings' file.
impl fmt::Display for Key {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Sign(sign) => fmt::Display::fmt(sign, f),
            key => fmt::Debug::fmt(key, f),
        }
    }
}

fn on_key(sign: char) -> String {
    let mut capital = sign.to_uppercase();
    match (capital.next(), capital.next()) {
        (Some(one), None) => one.to_string(),
        _ => sign.to_string(),
    }
}

/// The most keys of a set that have no name.
const SIGNS: usize = 4;

/// Keys by what they type in the player's layout, and by their places, named after the keys of the US layout there.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Keys {
    typed: u128,
    places: u128,
    /// Those without a name; `\0` where there is none.
    signs: [char; SIGNS],
}

fn bit(key: Key) -> u128 {
    key.bit().map_or(0, |bit| 1 << bit)
}

impl Keys {
    /// Whether a key is among them by what it types.
    pub fn has(self, key: Key) -> bool {
        match key {
            Key::Sign(sign) => self.signs.contains(&sign),
            key => self.typed & bit(key) != 0,
        }
    }

    pub fn has_place(self, key: Key) -> bool {
        match key {
            Key::Sign(_) => self.has(key),
            key => self.places & bit(key) != 0,
        }
    }

    pub fn is_empty(self) -> bool {
        self == Self::default()
    }

    pub fn add(&mut self, key: Key) {
        self.add_typed(key);
        self.add_place(key);
    }

    pub fn add_typed(&mut self, key: Key) {
        self.typed |= bit(key);
        if let (Key::Sign(sign), false) = (key, self.has(key))
            && let Some(free) = self.signs.iter_mut().find(|known| **known == '\0')
        {
            *free = sign;
        }
    }

    pub fn add_place(&mut self, key: Key) {
        self.places |= bit(key);
    }

    #[must_use]
    pub fn less(self, others: Self) -> Self {
        let mut rest = Self { typed: self.typed & !others.typed, places: self.places & !others.places, ..Self::default() };
        self.signs().filter(|key| key.bit().is_none() && !others.has(*key)).for_each(|key| rest.add_typed(key));
        rest
    }

    #[must_use]
    pub fn without(self, key: Key) -> Self {
        self.less([key].into_iter().collect())
    }

    /// Those that type neither a letter nor a space.
    pub fn signs(self) -> impl Iterator<Item = Key> {
        let named = Key::SIGNS.into_iter().map(|(key, _)| key).filter(move |key| self.has(*key));
        named.chain(self.signs.into_iter().filter(|sign| *sign != '\0').map(Key::Sign))
    }

    /// Those with a name, by what they type.
    pub fn named(self) -> impl Iterator<Item = Key> {
        Key::ALL.iter().copied().filter(move |key| self.has(*key))
    }

    /// One of the keyboard: by its place, or by what it types, with a name if one has it.
    pub fn first(self, by_place: bool) -> Option<Key> {
        let named = Key::ALL.iter().copied().filter(|key| !key.is_pad());
        named.chain(self.signs()).find(|key| if by_place { self.has_place(*key) } else { self.has(*key) })
    }
}

impl std::ops::BitOr for Keys {
    type Output = Self;

    fn bitor(self, other: Self) -> Self {
        let mut both = Self { typed: self.typed | other.typed, places: self.places | other.places, ..self };
        other.signs().for_each(|sign| both.add_typed(sign));
        both
    }
}

impl FromIterator<Key> for Keys {
    fn from_iter<T: IntoIterator<Item = Key>>(keys: T) -> Self {
        let mut set = Self::default();
        keys.into_iter().for_each(|key| set.add(key));
        set
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_key_has_a_bit_and_a_name_of_its_own() {
        assert!(Key::ALL.len() <= 128);
        for (i, key) in Key::ALL.iter().enumerate() {
            assert_eq!(key.bit(), Some(i as u32), "{key} stands where its bit is");
            assert_eq!(Key::named(&key.to_string().to_lowercase()), Some(*key));
            assert!(!key.label().is_empty());
        }
    }

    #[test]
    fn a_key_is_named_by_what_it_types() {
        for (typed, key, label) in [
            ("ö", Key::Sign('ö'), "Ö"),
            ("É", Key::Sign('é'), "É"),
            ("ß", Key::Sign('ß'), "ß"),
            ("+", Key::Equal, "+"),
            (".", Key::Period, "."),
            ("#", Key::Sign('#'), "#"),
        ] {
            assert_eq!(Key::named(typed), Some(key));
            assert_eq!(Key::named(&key.to_string()), Some(key));
            assert_eq!(key.label(), label);
        }
        assert_eq!([" ", "\u{8}", "öö", ""].map(Key::named), [None; 4]);
    }

    #[test]
    fn a_set_holds_signs_as_well() {
        let (mut keys, other) = (Keys::default(), [Key::Sign('ß'), Key::Z].into_iter().collect());
        keys.add_typed(Key::Sign('ö'));
        keys.add_place(Key::Semicolon);
        assert!(keys.has(Key::Sign('ö')) && keys.has_place(Key::Semicolon) && !keys.has(Key::Semicolon));
        let both = keys | other;
        assert!(both.has(Key::Sign('ß')) && both.has(Key::Z) && both.has_place(Key::Z) && both.less(other) == keys);
        assert!(both.without(Key::Sign('ö')).without(Key::Semicolon) == other && keys.less(both).is_empty());
        assert_eq!((keys.first(true), keys.first(false)), (Some(Key::Semicolon), Some(Key::Sign('ö'))));
    }
}
