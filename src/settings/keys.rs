//! Keys, and what each of them does in flight.

use std::fmt;

/// Every key that has one place on the keyboard, by the name that it has in the settings' file. The window knows them by the same names.
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
        /// A key of the keyboard, or a button of a gamepad.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[repr(u8)]
        #[allow(missing_docs)] // A key's name says which one it is.
        pub enum Key {
            $($plain,)*
            /// Also that of the number pad.
            Enter,
            /// Either of the two, as the two below.
            Shift, Control, Alt,
            PadUp, PadDown, PadLeft, PadRight, PadA, PadB, PadX, PadY, PadStart, PadSelect,
            PadL1, PadR1, PadL2, PadR2,
        }

        impl Key {
            /// All of them.
            pub const ALL: &[Self] = &[
                $(Self::$plain,)*
                Self::Enter, Self::Shift, Self::Control, Self::Alt,
                Self::PadUp, Self::PadDown, Self::PadLeft, Self::PadRight, Self::PadA, Self::PadB, Self::PadX, Self::PadY,
                Self::PadStart, Self::PadSelect, Self::PadL1, Self::PadR1, Self::PadL2, Self::PadR2,
            ];
        }
    };
}
plain_keys!(keys);

impl Key {
    /// The key of that name, whatever its letters' case.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|key| key.to_string().eq_ignore_ascii_case(name))
    }

    /// What stands on it, as it is shown.
    pub fn label(self) -> String {
        match self {
            Self::Up => "↑".into(),
            Self::Down => "↓".into(),
            Self::Left => "←".into(),
            Self::Right => "→".into(),
            Self::Escape => "Esc".into(),
            Self::PageUp => "Page Up".into(),
            Self::PageDown => "Page Down".into(),
            Self::Control => "Ctrl".into(),
            Self::Apostrophe => "'".into(),
            Self::Comma => ",".into(),
            Self::Minus => "-".into(),
            Self::Period => ".".into(),
            Self::Slash => "/".into(),
            Self::Semicolon => ";".into(),
            Self::Equal => "=".into(),
            Self::LeftBracket => "[".into(),
            Self::RightBracket => "]".into(),
            Self::Backslash => "\\".into(),
            Self::GraveAccent => "`".into(),
            other => {
                let name = other.to_string();
                let of = |start: &str, words: &str| name.strip_prefix(start).map(|rest| format!("{words}{rest}"));
                of("Key", "").or_else(|| of("Kp", "Num ")).or_else(|| of("Pad", "Pad ")).unwrap_or(name)
            }
        }
    }

    /// Whether it is on a gamepad.
    pub fn is_pad(self) -> bool {
        self as u8 >= Self::PadUp as u8
    }

    /// The button of a gamepad that does the same in menus.
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

/// The name that it has in the settings' file.
impl fmt::Display for Key {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(self, f)
    }
}

/// A set of keys.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Keys(u128);

impl Keys {
    /// Whether the key is in it.
    pub const fn has(self, key: Key) -> bool {
        self.0 & (1 << key as u32) != 0
    }

    /// Whether there are none.
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// Adds a key.
    pub const fn add(&mut self, key: Key) {
        self.0 |= 1 << key as u32;
    }

    /// Those of them that are not in the others.
    #[must_use]
    pub const fn less(self, others: Self) -> Self {
        Self(self.0 & !others.0)
    }

    /// The same without that key.
    #[must_use]
    pub const fn without(self, key: Key) -> Self {
        Self(self.0 & !(1 << key as u32))
    }
}

impl std::ops::BitOr for Keys {
    type Output = Self;

    /// All keys of both.
    fn bitor(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
}

impl FromIterator<Key> for Keys {
    fn from_iter<T: IntoIterator<Item = Key>>(keys: T) -> Self {
        let mut set = Self::default();
        keys.into_iter().for_each(|key| set.add(key));
        set
    }
}

/// What a key can do in flight.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Action {
    /// Along the nose.
    Thrust,
    /// Against it.
    Reverse,
    /// Anticlockwise.
    Left,
    /// Clockwise.
    Right,
    /// The level from its beginning.
    Restart,
    /// Forces as numbers and arrows.
    Details,
    /// Hitboxes and costs.
    Hitboxes,
    /// The pause panel.
    Pause,
}

/// How many actions there are.
const ACTIONS: usize = 8;

impl Action {
    /// All of them, in the order in which the settings show them.
    pub const ALL: [Self; ACTIONS] =
        [Self::Thrust, Self::Reverse, Self::Left, Self::Right, Self::Restart, Self::Details, Self::Hitboxes, Self::Pause];

    /// Its row in the settings' file.
    pub const fn setting(self) -> &'static str {
        match self {
            Self::Thrust => "key_thrust",
            Self::Reverse => "key_reverse",
            Self::Left => "key_left",
            Self::Right => "key_right",
            Self::Restart => "key_restart",
            Self::Details => "key_details",
            Self::Hitboxes => "key_hitboxes",
            Self::Pause => "key_pause",
        }
    }

    /// Its name as it is shown.
    pub const fn label(self) -> &'static str {
        match self {
            Self::Thrust => "Thrust",
            Self::Reverse => "Reverse thrust",
            Self::Left => "Turn left",
            Self::Right => "Turn right",
            Self::Restart => "Restart level",
            Self::Details => "Show forces",
            Self::Hitboxes => "Hitboxes, costs",
            Self::Pause => "Pause",
        }
    }

    /// What does it on a gamepad: triggers thrust, the stick and the cross turn.
    const fn pads(self) -> [Option<Key>; 2] {
        match self {
            Self::Thrust => [Some(Key::PadR2), Some(Key::PadA)],
            Self::Reverse => [Some(Key::PadL2), Some(Key::PadB)],
            Self::Left => [Some(Key::PadLeft), Some(Key::PadL1)],
            Self::Right => [Some(Key::PadRight), Some(Key::PadR1)],
            Self::Restart => [Some(Key::PadY), None],
            Self::Details => [Some(Key::PadX), Some(Key::PadSelect)],
            Self::Hitboxes => [None, None],
            Self::Pause => [Some(Key::PadStart), None],
        }
    }
}

/// Which keys do what: up to two a control.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bindings([[Option<Key>; 2]; ACTIONS]);

impl Default for Bindings {
    /// The arrows with Space and Shift, and W A S D.
    fn default() -> Self {
        let both = |a, b| [Some(a), Some(b)];
        Self([
            both(Key::Space, Key::W),
            both(Key::Shift, Key::S),
            both(Key::Left, Key::A),
            both(Key::Right, Key::D),
            [Some(Key::R), None],
            [Some(Key::Tab), None],
            [Some(Key::F3), None],
            both(Key::Escape, Key::P),
        ])
    }
}

impl Bindings {
    /// The keys of an action.
    pub const fn of(&self, action: Action) -> [Option<Key>; 2] {
        self.0[action as usize]
    }

    /// Gives an action its keys.
    pub const fn set(&mut self, action: Action, keys: [Option<Key>; 2]) {
        self.0[action as usize] = keys;
    }

    /// Whether one of those keys does it. Esc always pauses too, so that nobody locks himself in.
    pub fn does(&self, action: Action, keys: Keys) -> bool {
        let escapes = action == Action::Pause && keys.has(Key::Escape);
        escapes || self.of(action).into_iter().chain(action.pads()).flatten().any(|key| keys.has(key))
    }

    /// Another action that the key does as well.
    pub fn conflict(&self, action: Action, key: Key) -> Option<Action> {
        Action::ALL.into_iter().find(|other| *other != action && self.of(*other).contains(&Some(key)))
    }

    /// The keys of an action as they are shown: `Space or W`.
    pub fn label(&self, action: Action) -> String {
        let labels: Vec<String> = self.of(action).into_iter().flatten().map(Key::label).collect();
        if labels.is_empty() { "no key".into() } else { labels.join(" or ") }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_key_has_a_bit_and_a_name_of_its_own() {
        assert!(Key::ALL.len() < 128);
        for (i, key) in Key::ALL.iter().enumerate() {
            assert_eq!(*key as usize, i, "{key} stands where its bit is");
            assert_eq!(Key::named(&key.to_string().to_lowercase()), Some(*key));
            assert!(!key.label().is_empty());
        }
    }

    #[test]
    fn both_hands_fly_from_the_start() {
        let bindings = Bindings::default();
        let does = |action, key: Key| bindings.does(action, [key].into_iter().collect());
        for (action, keys) in [
            (Action::Thrust, [Key::Space, Key::W, Key::PadR2]),
            (Action::Reverse, [Key::Shift, Key::S, Key::PadL2]),
            (Action::Left, [Key::Left, Key::A, Key::PadLeft]),
            (Action::Right, [Key::Right, Key::D, Key::PadRight]),
        ] {
            for key in keys {
                assert!(does(action, key), "{action:?} by {key}");
                let others = Action::ALL.into_iter().filter(|other| does(*other, key)).count();
                assert_eq!(others, 1, "{key} does one thing");
            }
        }
    }

    #[test]
    fn esc_always_pauses_and_conflicts_are_told() {
        let mut bindings = Bindings::default();
        bindings.set(Action::Pause, [None, None]);
        assert!(bindings.does(Action::Pause, [Key::Escape].into_iter().collect()));
        bindings.set(Action::Details, [Some(Key::W), None]);
        assert_eq!(bindings.conflict(Action::Details, Key::W), Some(Action::Thrust));
        assert_eq!(bindings.conflict(Action::Thrust, Key::Space), None);
        assert_eq!(bindings.label(Action::Pause), "no key");
    }
}
