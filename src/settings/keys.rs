//! Keys, and what each of them does in flight.

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
        /// A key of the keyboard, or a button of a gamepad.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[repr(u8)]
        #[allow(missing_docs)] // A key's name says which one it is.
        pub enum Key {
            $($plain,)*
            /// Also on the number pad.
            Enter,
            /// Left or right, as the two below.
            Shift, Control, Alt,
            PadUp, PadDown, PadLeft, PadRight, PadA, PadB, PadX, PadY, PadStart, PadSelect,
            PadL1, PadR1, PadL2, PadR2,
        }

        impl Key {
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
    /// In any case of the letters.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|key| key.to_string().eq_ignore_ascii_case(name))
    }

    /// The sign on the key, or its name in the language of the screens.
    pub fn label(self) -> String {
        tr(&self.sign()).to_owned()
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
            Self::KpAdd => "Num +".into(),
            Self::KpSubtract => "Num -".into(),
            Self::PadL1 => "left shoulder".into(),
            Self::PadR1 => "right shoulder".into(),
            Self::PadL2 => "left trigger".into(),
            Self::PadR2 => "right trigger".into(),
            other => {
                let name = other.to_string();
                let of = |start: &str, words: &str| name.strip_prefix(start).map(|rest| format!("{words}{rest}"));
                of("Key", "").or_else(|| of("Kp", "Num ")).or_else(|| of("Pad", "Pad ")).unwrap_or(name)
            }
        }
    }

    pub fn is_pad(self) -> bool {
        self as u8 >= Self::PadUp as u8
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
        fmt::Debug::fmt(self, f)
    }
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Keys(u128);

impl Keys {
    pub const fn has(self, key: Key) -> bool {
        self.0 & (1 << key as u32) != 0
    }

    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }

    pub const fn add(&mut self, key: Key) {
        self.0 |= 1 << key as u32;
    }

    #[must_use]
    pub const fn less(self, others: Self) -> Self {
        Self(self.0 & !others.0)
    }

    #[must_use]
    pub const fn without(self, key: Key) -> Self {
        Self(self.0 & !(1 << key as u32))
    }
}

impl std::ops::BitOr for Keys {
    type Output = Self;

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

struct About {
    setting: &'static str,
    label: &'static str,
    does: &'static str,
    /// At first, up to two.
    keys: &'static [Key],
    pads: &'static [Key],
}

/// The list of actions: row in the settings' file, label, sentence in docs/playing.md, first keys and gamepad buttons.
macro_rules! actions {
    ($($name:ident $setting:literal $label:literal $does:literal [$($key:ident)*] [$($pad:ident)*];)*) => {
        /// Of a key in flight.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[repr(u8)]
        pub enum Action {
            $(#[doc = $does] $name,)*
        }

        const ACTIONS: usize = [$($setting),*].len();

        impl Action {
            /// In the order of the settings.
            pub const ALL: [Self; ACTIONS] = [$(Self::$name),*];
        }

        static ABOUT: [About; ACTIONS] = [
            $(About { setting: $setting, label: $label, does: $does, keys: &[$(Key::$key),*], pads: &[$(Key::$pad),*] },)*
        ];
    };
}

actions! {
    Thrust "key_thrust" "Thrust" "thrusts along the ship's nose" [Space W] [PadR2 PadA];
    Reverse "key_reverse" "Reverse thrust" "thrusts backwards" [Shift S] [PadL2 PadB];
    Left "key_left" "Turn left" "turns the ship anticlockwise" [Left A] [PadLeft];
    Right "key_right" "Turn right" "turns the ship clockwise" [Right D] [PadRight];
    Restart "key_restart" "Restart level" "restarts the level" [R] [PadY];
    Rewind "key_rewind" "Rewind" "flies backwards while it is held; from there the flight goes on as practice" [Backspace] [PadL1];
    Details "key_details" "Show forces" "opens and closes the details: the forces and impacts on everything" [Tab] [PadX PadSelect];
    Hitboxes "key_hitboxes" "Hitboxes, costs" "shows hitboxes, frames a second and the cost of a tick" [F3] [];
    Pause "key_pause" "Pause" "pauses; in menus Esc and B go back" [Escape P] [PadStart];
    Fit "key_fit" "Fit the view" "fits everything that moves into the view; again: follows the ship" [F] [];
    Map "key_map" "Whole map" "shows the whole level while it is held" [M] [PadR1];
    Closer "key_closer" "Zoom in" "zooms in, as the wheel does; with Ctrl: longer arrows" [Equal KpAdd] [];
    Wider "key_wider" "Zoom out" "zooms out; with Ctrl: shorter arrows" [Minus KpSubtract] [];
    Next "key_next" "Next body" "shows the details of the next body" [N] [];
    Freeze "key_freeze" "Freeze" "freezes the world, or lets it go on" [B] [];
    TickOn "key_tick_on" "One tick on" "takes the frozen world one tick on" [Period] [];
    TickBack "key_tick_back" "One tick back" "takes the frozen world one tick back" [Comma] [];
    Slower "key_slower" "Slower" "slows the world down" [LeftBracket] [];
    Faster "key_faster" "Faster" "speeds the world up" [RightBracket] [];
    Instruments "key_instruments" "Instruments" "opens and closes the instruments" [I] [];
}

/// The actions that fly come first.
const FLYING: usize = Action::Pause as usize + 1;

impl Action {
    /// The name in the settings' file.
    pub const fn setting(self) -> &'static str {
        self.about().setting
    }

    pub const fn label(self) -> &'static str {
        self.about().label
    }

    /// A sentence without its subject, the key.
    pub const fn does(self) -> &'static str {
        self.about().does
    }

    /// Triggers thrust, the stick and the cross turn.
    pub const fn pads(self) -> &'static [Key] {
        self.about().pads
    }

    const fn flies(self) -> bool {
        (self as usize) < FLYING
    }

    const fn about(self) -> &'static About {
        &ABOUT[self as usize]
    }
}

/// Up to two keys an action.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bindings([[Option<Key>; 2]; ACTIONS]);

impl Default for Bindings {
    fn default() -> Self {
        Self(Action::ALL.map(|action| [0, 1].map(|slot| action.about().keys.get(slot).copied())))
    }
}

impl Bindings {
    pub const fn of(&self, action: Action) -> [Option<Key>; 2] {
        self.0[action as usize]
    }

    pub const fn set(&mut self, action: Action, keys: [Option<Key>; 2]) {
        self.0[action as usize] = keys;
    }

    /// Whether one of these keys does it. Esc always pauses too, so that no player is locked in. A key that flies does nothing
    /// else.
    pub fn does(&self, action: Action, keys: Keys) -> bool {
        let escapes = action == Action::Pause && keys.has(Key::Escape);
        let own = self.of(action).into_iter().flatten().filter(|key| action.flies() || !self.flies(*key));
        escapes || own.chain(action.pads().iter().copied()).any(|key| keys.has(key))
    }

    fn flies(&self, key: Key) -> bool {
        self.0[..FLYING].iter().flatten().any(|known| *known == Some(key))
    }

    /// Another action of the same key.
    pub fn conflict(&self, action: Action, key: Key) -> Option<Action> {
        Action::ALL.into_iter().find(|other| *other != action && self.of(*other).contains(&Some(key)))
    }

    /// `Space or W`.
    pub fn label(&self, action: Action) -> String {
        let labels: Vec<String> = self.of(action).into_iter().flatten().map(Key::label).collect();
        if labels.is_empty() { tr("no key").to_owned() } else { labels.join(&format!(" {} ", tr("or"))) }
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
    fn a_key_that_flies_does_not_look_on_as_well() {
        let mut bindings = Bindings::default();
        let f = || [Key::F].into_iter().collect();
        assert!(bindings.does(Action::Fit, f()));
        bindings.set(Action::Thrust, [Some(Key::F), None]);
        assert!(bindings.does(Action::Thrust, f()) && !bindings.does(Action::Fit, f()));
        bindings.set(Action::Fit, [Some(Key::V), None]);
        assert!(bindings.does(Action::Fit, [Key::V].into_iter().collect()));
    }

    /// `UPDATE_DOCS=1 cargo test --lib settings::keys` writes the table.
    #[test]
    fn the_page_about_playing_lists_every_key() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/playing.md");
        let head = "| key | gamepad | does |\n|---|---|---|\n";
        let row = |action: Action| {
            let pads: Vec<String> = action.pads().iter().map(|pad| pad.label()).collect();
            format!("| {} | {} | {} |\n", Bindings::default().label(action), pads.join(", "), action.does())
        };
        let table = head.to_owned() + &Action::ALL.map(row).concat();
        let page = std::fs::read_to_string(path).unwrap().replace("\r\n", "\n");
        if std::env::var_os("UPDATE_DOCS").is_some() {
            let (before, rest) = page.split_once(head).unwrap();
            let (_, after) = rest.split_once("| wheel |").unwrap();
            return std::fs::write(path, format!("{before}{table}| wheel |{after}")).unwrap();
        }
        assert!(page.contains(&table), "docs/playing.md is stale; expected\n{table}");
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
