//! What the keys do in flight.

use super::{Key, Keys, layout};
use crate::words::tr;

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
    Pause "key_pause" "Pause" "pauses; in menus Esc and B go back" [Escape P] [PadStart];
    Hint "key_hint" "Hint" "gives a hint, once one is offered" [H] [];
    Hitboxes "key_hitboxes" "Hitboxes, costs" "shows hitboxes, frames a second and the cost of a tick" [F3] [];
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
    Picture "key_picture" "Free-body picture" "shows the forces on a body alone, as in a textbook, in place of the scene" [K] [];
    Sheet "key_sheet" "Sheet" "opens and closes the sheet of an experiment" [L] [];
}

/// The actions that fly come first.
pub const FLYING: usize = Action::Pause as usize + 1;

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

    /// Whether its keys are meant by their places, as fingers lie on them: W A S D. The others are meant by what they type.
    pub const fn is_by_place(self) -> bool {
        self as usize <= Self::Right as usize
    }

    pub fn label_of(self, key: Key) -> String {
        if self.is_by_place() { key.label_by_place() } else { key.label() }
    }

    const fn about(self) -> &'static About {
        &ABOUT[self as usize]
    }
}

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

    /// Whether one of these keys does it. Esc always pauses too, so that no player is locked in. A key that flies does nothing else.
    pub fn does(&self, action: Action, keys: Keys) -> bool {
        let escapes = action == Action::Pause && keys.has(Key::Escape);
        let mut own = self.of(action).into_iter().flatten().filter(|key| action.flies() || !self.flies(*key));
        let down = |key| if action.is_by_place() { keys.has_place(key) } else { keys.has(key) };
        escapes || own.any(down) || action.pads().iter().any(|pad| keys.has(*pad))
    }

    /// Whether a sign of theirs, as far as is known, is typed with Shift. Where brackets need a modifier, that is AltGr.
    pub fn needs_shift(&self) -> bool {
        let by_sign = Action::ALL.into_iter().filter(|action| !action.is_by_place());
        let mut signs = by_sign.flat_map(|action| self.of(action)).flatten().filter_map(Key::typed);
        signs.any(|sign| !matches!(sign, '[' | ']') && !layout::has(sign))
    }

    fn flies(&self, key: Key) -> bool {
        Action::ALL[..FLYING].iter().any(|action| self.typed(*action).contains(&Some(key)))
    }

    pub fn conflict(&self, action: Action, key: Key) -> Option<Action> {
        let key = if action.is_by_place() { layout::key_at(key) } else { key };
        Action::ALL.into_iter().find(|other| *other != action && self.typed(*other).contains(&Some(key)))
    }

    fn typed(&self, action: Action) -> [Option<Key>; 2] {
        let by_place = |key: Key| if action.is_by_place() { layout::key_at(key) } else { key };
        self.of(action).map(|key| key.map(by_place))
    }

    pub fn label(&self, action: Action) -> String {
        let labels: Vec<String> = self.of(action).into_iter().flatten().map(|key| action.label_of(key)).collect();
        if labels.is_empty() { tr("no key").to_owned() } else { labels.join(&format!(" {} ", tr("or"))) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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

    /// `UPDATE_DOCS=1 cargo test --lib settings::bindings` writes the table.
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

    /// AZERTY: the key at the place of W types z, that of A types q, and the one right of L types m.
    #[test]
    fn flying_keys_are_meant_by_their_places_and_the_others_by_what_they_type() {
        for (place, sign) in [(Key::W, 'z'), (Key::Z, 'w'), (Key::A, 'q'), (Key::Q, 'a'), (Key::M, ','), (Key::Semicolon, 'm')] {
            layout::note(place, sign);
        }
        let mut bindings = Bindings::default();
        assert_eq!([Action::Thrust, Action::Left, Action::Map].map(|action| bindings.label(action)), ["Space or Z", "← or Q", "M"]);
        let mut semicolon = Keys::default();
        semicolon.add_place(Key::Semicolon);
        semicolon.add_typed(Key::M);
        let mut m = Keys::default();
        m.add_place(Key::M);
        m.add_typed(Key::Comma);
        assert!(bindings.does(Action::Map, semicolon) && !bindings.does(Action::Map, m) && bindings.does(Action::TickBack, m));
        bindings.set(Action::Fit, [Some(Key::Z), None]);
        assert_eq!(bindings.conflict(Action::Fit, Key::Z), Some(Action::Thrust), "the key that types z thrusts");
        bindings.set(Action::Fit, [Some(Key::W), None]);
        assert_eq!(bindings.conflict(Action::Thrust, Key::W), None, "the key that types w is another one");
    }

    /// QWERTZ has + on a key of its own; US and AZERTY have it above =, where Shift is not needed.
    #[test]
    fn the_key_that_zooms_in_is_named_as_it_needs_no_shift() {
        let label = || Bindings::default().label(Action::Closer);
        assert_eq!(label(), "+ or Num +");
        layout::note(Key::Equal, '=');
        assert_eq!(label(), "= or Num +");
        layout::note(Key::RightBracket, '+');
        assert_eq!(label(), "+ or Num +");
    }
}
