//! The keyboard: from single presses to the keys of a frame, without a window. Dead keys, each a mark that waits for its letter: X11 hands
//! them over as they are; Windows and browsers compose by themselves.

use super::input::{Input, Keyed};
use crate::settings::{Key, Keys, layout};
use unicode_normalization::char::compose;

/// A key that goes down.
#[derive(Clone, Copy, Debug, Default)]
pub struct KeyDown {
    /// Whatever tells it from others until it goes up.
    pub id: u32,
    /// Named after the key of the US layout there.
    pub place: Option<Key>,
    /// What it types; a combining mark for a dead key.
    pub typed: Option<char>,
    /// What it types comes by itself.
    pub silent: bool,
    /// What it types without Shift and the like.
    pub plain: Option<char>,
    /// The keyboard repeats it.
    pub repeat: bool,
    /// Of Shift, Control and Alt, the keys that are down.
    pub held: Keys,
}

#[derive(Debug, Default)]
pub struct Keyboard {
    down: Vec<(u32, Keys)>,
    /// Keys that were down as the window got the focus: they count once they were released.
    stale: Vec<u32>,
    pressed: Keys,
    /// In the last frame.
    held: Keys,
    /// The modifiers of the presses: Ctrl and S count where both were released before the frame.
    modifiers: Keys,
    typed: String,
    keyed: Vec<Keyed>,
    compose: Compose,
}

impl Keyboard {
    pub fn down(&mut self, key: KeyDown) {
        if self.stale.contains(&key.id) {
            return;
        }
        let key = if key.held.has(Key::Alt) { KeyDown { held: key.held.without(Key::Control), ..key } } else { key };
        let known = self.down.iter().any(|(id, _)| *id == key.id);
        if key.repeat && !known {
            return;
        }
        if !known {
            let keys = keys_of(&key);
            self.down.push((key.id, keys));
            self.pressed = self.pressed | keys;
            self.modifiers = self.modifiers | key.held;
            let after = self.typed.chars().count();
            self.keyed.extend(keys.named().map(|one| Keyed { key: one, after, held: key.held }));
        }
        match key.typed {
            Some(sign) if types(key.held) && !key.silent => self.compose(sign),
            None if key.place.is_some_and(|place| !matches!(place, Key::Shift | Key::Control | Key::Alt)) => self.compose.clear(),
            _ => {}
        }
    }

    fn compose(&mut self, sign: char) {
        let typed = self.compose.take(sign);
        self.typed.extend(typed.chars().filter(|sign| !sign.is_control()));
    }

    /// A character comes by itself, after its key went down or before that.
    pub fn typed(&mut self, sign: char, held: Keys) {
        if types(held) {
            self.compose(sign);
        }
    }

    /// What the key that went down last has typed, where the system tells it later.
    pub fn typed_by_last(&mut self, sign: char, held: Keys) {
        // Ctrl and a letter come as a control character.
        let letter = sign as u32;
        let sign = if (1..=26).contains(&letter) { char::from_u32(letter + 0x60).unwrap_or(sign) } else { sign };
        let (Some((_, keys)), Some(key)) = (self.down.last_mut(), Key::typing(sign)) else { return };
        if !keys.has(key) && !keys.named().any(|key| !layout::prints(key)) {
            keys.add_typed(key);
            self.pressed.add_typed(key);
            let after = self.typed.chars().count();
            self.keyed.extend((!matches!(key, Key::Sign(_))).then_some(Keyed { key, after, held }));
        }
    }

    pub fn up(&mut self, id: u32) {
        self.down.retain(|(known, _)| *known != id);
        self.stale.retain(|known| *known != id);
    }

    /// The window has lost the keyboard: whatever happens to the keys now is not told.
    pub fn leave(&mut self) {
        self.down.clear();
        self.stale.clear();
        self.compose.clear();
    }

    /// The window has the keyboard again, while these keys are down.
    pub fn come_back(&mut self, down: impl IntoIterator<Item = u32>) {
        self.leave();
        self.stale.extend(down);
    }

    /// The keys since the last frame.
    pub fn take(&mut self) -> Input {
        let down = self.down.iter().fold(Keys::default(), |all, (_, keys)| all | *keys);
        let known = std::mem::replace(&mut self.held, down) | self.pressed;
        let modifiers = std::mem::take(&mut self.modifiers);
        let held = down | modifiers.less(modifiers.less(known));
        // Windows tells AltGr as both.
        let held = if held.has(Key::Alt) { held.without(Key::Control) } else { held };
        Input {
            pressed: std::mem::take(&mut self.pressed),
            held,
            typed: std::mem::take(&mut self.typed),
            keyed: std::mem::take(&mut self.keyed),
            ..Input::default()
        }
    }
}

/// The place that a browser calls so: `KeyA`, `Digit1`, `BracketLeft`.
pub fn place_of_code(code: &str) -> Option<Key> {
    let named = match code {
        "ArrowUp" | "ArrowDown" | "ArrowLeft" | "ArrowRight" => &code[5..],
        "ShiftLeft" | "ShiftRight" => "Shift",
        "ControlLeft" | "ControlRight" | "MetaLeft" | "MetaRight" => "Control",
        "AltLeft" | "AltRight" => "Alt",
        "BracketLeft" => "LeftBracket",
        "BracketRight" => "RightBracket",
        "Quote" => "Apostrophe",
        "Backquote" => "GraveAccent",
        "NumpadEnter" => "Enter",
        _ => code.strip_prefix("Key").filter(|rest| rest.len() == 1).unwrap_or(code),
    };
    let numbered = |start: &str, name: &str| Some(format!("{name}{}", named.strip_prefix(start)?));
    let name = numbered("Digit", "Key").or_else(|| numbered("Numpad", "Kp")).unwrap_or_else(|| named.to_owned());
    Key::ALL.iter().copied().find(|key| key.to_string() == name)
}

/// Whether characters are typed with these modifiers: Ctrl with Alt is AltGr.
fn types(held: Keys) -> bool {
    !held.has(Key::Control) || held.has(Key::Alt)
}

/// What a key counts as: its place, and what it types with the modifiers that are down and without. A letter key of a layout without
/// Latin letters is that of its place.
fn keys_of(key: &KeyDown) -> Keys {
    let mut keys = Keys::default();
    if let Some(place) = key.place.filter(|place| !layout::prints(*place)) {
        keys.add(place);
        return keys;
    }
    let signs = [key.typed, key.plain].into_iter().flatten().map(alone).filter_map(Key::typing);
    signs.for_each(|sign| keys.add_typed(sign));
    if let Some(place) = key.place {
        keys.add_place(place);
        if let Some(plain) = key.plain {
            layout::note(place, alone(plain));
        }
        let foreign = keys.named().next().is_none() && key.plain.is_none_or(char::is_alphabetic);
        if foreign && place.is_letter() {
            keys.add_typed(place);
        }
    }
    keys
}

/// Marks with what they type before a space, as in X11's tables, and twice: `'` stands on the dead key of us-intl.
pub const MARKS: [(char, char, char); 16] = [
    ('\u{300}', '`', '`'),
    ('\u{301}', '\'', '´'),
    ('\u{302}', '^', '^'),
    ('\u{303}', '~', '~'),
    ('\u{304}', '¯', '¯'),
    ('\u{306}', '˘', '˘'),
    ('\u{307}', '˙', '˙'),
    ('\u{308}', '"', '¨'),
    ('\u{309}', '̉', '̉'),
    ('\u{30a}', '°', '°'),
    ('\u{30b}', '˝', '˝'),
    ('\u{30c}', 'ˇ', 'ˇ'),
    ('\u{323}', '.', '.'),
    ('\u{327}', '¸', '¸'),
    ('\u{328}', '˛', '˛'),
    ('\u{31b}', '̛', '̛'),
];

/// The mark alone, as it stands on a key; other characters stay.
pub fn alone(sign: char) -> char {
    MARKS.iter().find(|(mark, ..)| *mark == sign).map_or(sign, |(.., alone)| *alone)
}

fn is_mark(sign: char) -> bool {
    MARKS.iter().any(|(mark, ..)| *mark == sign)
}

/// The mark that waits.
#[derive(Debug, Default)]
struct Compose(Option<char>);

impl Compose {
    /// What a character, or a combining mark for a dead key, types. What makes no letter together is typed one after the other.
    pub fn take(&mut self, sign: char) -> String {
        let Some(mark) = self.0.take() else {
            self.0 = Some(sign).filter(|sign| is_mark(*sign));
            return if self.0.is_some() { String::new() } else { sign.into() };
        };
        let before_space = MARKS.iter().find(|(known, ..)| *known == mark).map_or(mark, |(_, space, _)| *space);
        match compose(sign, mark) {
            Some(letter) => letter.into(),
            None if sign == ' ' => before_space.into(),
            None if sign == mark => alone(mark).into(),
            None => [alone(mark).to_string(), self.take(sign)].concat(),
        }
    }

    /// Another key came between.
    pub fn clear(&mut self) {
        self.0 = None;
    }
}

#[cfg(test)]
mod dead_keys {
    use super::*;

    #[test]
    fn a_mark_joins_the_letter_that_follows() {
        for (keys, typed) in [
            ("m\u{302}eme", "même"),
            ("\u{301}E\u{308}i\u{303}n\u{327}c\u{30a}a", "Éïñçå"),
            ("\u{301} \u{308} \u{303} ", "'\"~"),
            ("\u{301}\u{301}\u{302}\u{302}", "´^"),
            ("\u{302}x\u{301}5", "^x´5"),
            ("\u{302}\u{301}e", "^é"),
            ("\u{302}\u{301}\u{300}a", "^´à"),
        ] {
            let mut compose = Compose::default();
            assert_eq!(keys.chars().map(|key| compose.take(key)).collect::<String>(), typed, "{keys:?}");
        }
        let mut compose = Compose::default();
        compose.take('\u{302}');
        compose.clear();
        assert_eq!(compose.take('e'), "e");
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A key of a layout: id, place, what it types alone.
    type Plain = (u32, Key, char);

    fn press(keyboard: &mut Keyboard, (id, place, plain): Plain, typed: char, held: &[Key]) {
        let held = held.iter().copied().collect();
        keyboard.down(KeyDown {
            id,
            place: Some(place),
            typed: Some(typed),
            plain: Some(plain),
            silent: false,
            repeat: false,
            held,
        });
    }

    fn tap(keyboard: &mut Keyboard, key: Plain, typed: char, held: &[Key]) -> Input {
        press(keyboard, key, typed, held);
        keyboard.up(key.0);
        keyboard.take()
    }

    #[test]
    fn letters_and_signs_are_those_that_are_typed_and_places_stay() {
        // The layout, place, what it types alone, what it types with a modifier, the key by that.
        for (layout, place, plain, typed, held, key) in [
            ("us", Key::Equal, '=', '+', &[Key::Shift][..], Key::Equal),
            ("us", Key::Period, '.', '.', &[], Key::Period),
            ("us", Key::Period, '.', '>', &[Key::Shift], Key::Period),
            ("de", Key::RightBracket, '+', '+', &[], Key::Equal),
            ("de", Key::Slash, '-', '-', &[], Key::Minus),
            ("de", Key::Key8, '8', '[', &[Key::Alt], Key::LeftBracket),
            ("de", Key::Y, 'z', 'z', &[Key::Control], Key::Z),
            ("de", Key::Semicolon, 'ö', 'Ö', &[Key::Shift], Key::Sign('ö')),
            ("fr", Key::Comma, ';', '.', &[Key::Shift], Key::Period),
            ("fr", Key::M, ',', ',', &[], Key::Comma),
            ("fr", Key::Semicolon, 'm', 'm', &[], Key::M),
            ("fr", Key::Key2, 'é', 'é', &[], Key::Sign('é')),
            ("fr", Key::W, 'z', 'z', &[], Key::Z),
            ("us intl", Key::Apostrophe, '\u{301}', '\u{301}', &[], Key::Sign('´')),
            ("ru", Key::Z, 'я', 'я', &[Key::Control], Key::Z),
        ] {
            let input = tap(&mut Keyboard::default(), (1, place, plain), typed, held);
            assert!(input.pressed.has(key), "{layout}: {place} types {typed}, which is {key}: {:?}", input.pressed);
            assert!(input.pressed.has_place(place), "{layout}: {place}");
            let by_place = key == place || Key::typing(plain) == Some(place) || layout == "ru";
            assert!(by_place || !input.pressed.has(place), "{layout}: {place} is no key of its US name");
            let named = !matches!(key, Key::Sign(_));
            assert!(!named || input.keyed.iter().any(|keyed| keyed.key == key), "{layout}: {key} went down");
            assert_eq!(input.typed.is_empty(), held.contains(&Key::Control) || plain == '\u{301}', "{layout}");
        }
    }

    #[test]
    fn what_was_pressed_names_the_keys() {
        tap(&mut Keyboard::default(), (1, Key::Semicolon, 'ö'), 'Ö', &[Key::Shift]);
        tap(&mut Keyboard::default(), (1, Key::GraveAccent, '\u{302}'), '\u{302}', &[]);
        assert_eq!([Key::Semicolon, Key::GraveAccent, Key::Q].map(Key::label_by_place), ["Ö", "^", "Q"]);
    }

    #[test]
    fn dead_keys_wait_for_their_letter_and_not_for_another_key() {
        let (circumflex, letter) = ((1, Key::LeftBracket, '\u{302}'), (2, Key::E, 'e'));
        let keys = &mut Keyboard::default();
        let [dead, composed] = [(circumflex, '\u{302}'), (letter, 'e')].map(|(key, typed)| tap(keys, key, typed, &[]).typed);
        assert_eq!([dead.as_str(), composed.as_str()], ["", "ê"]);
        tap(keys, circumflex, '\u{302}', &[]);
        keys.down(KeyDown { id: 9, place: Some(Key::Backspace), ..KeyDown::default() });
        assert_eq!(tap(keys, letter, 'e', &[]).typed, "e", "Backspace takes the mark");
        tap(keys, circumflex, '\u{302}', &[]);
        keys.down(KeyDown { id: 10, place: Some(Key::Shift), ..KeyDown::default() });
        assert_eq!(tap(keys, letter, 'E', &[Key::Shift]).typed, "Ê", "Shift does not");
    }

    #[test]
    fn a_key_repeats_what_it_types_and_is_pressed_once() {
        let (keys, a) = (&mut Keyboard::default(), (1, Key::A, 'a'));
        press(keys, a, 'a', &[]);
        press(keys, a, 'a', &[]);
        let first = keys.take();
        assert_eq!((first.typed.as_str(), first.keyed.len()), ("aa", 1));
        press(keys, a, 'a', &[]);
        let second = keys.take();
        assert!(second.pressed.is_empty() && second.held.has(Key::A) && second.typed == "a");
        keys.up(1);
        assert!(keys.take().held.is_empty());
    }

    #[test]
    fn a_key_that_was_down_as_the_focus_came_counts_once_released_and_others_at_once() {
        let keys = &mut Keyboard::default();
        press(keys, (1, Key::W, 'w'), 'w', &[]);
        keys.leave();
        assert!(keys.take().held.is_empty());
        keys.come_back([1]);
        press(keys, (1, Key::W, 'w'), 'w', &[]);
        let input = keys.take();
        assert!(input.pressed.is_empty() && input.held.is_empty() && input.typed.is_empty());
        press(keys, (2, Key::D, 'd'), 'd', &[]);
        assert!(keys.take().pressed.has(Key::D));
        keys.up(1);
        press(keys, (1, Key::W, 'w'), 'w', &[]);
        assert!(keys.take().pressed.has(Key::W));
        // Where the system tells repetitions.
        keys.leave();
        keys.down(KeyDown { id: 3, place: Some(Key::S), repeat: true, ..KeyDown::default() });
        assert!(keys.take().pressed.is_empty());
        keys.down(KeyDown { id: 3, place: Some(Key::S), ..KeyDown::default() });
        assert!(keys.take().pressed.has(Key::S));
    }

    #[test]
    fn a_command_holds_its_modifiers_even_if_they_are_up_again() {
        let keys = &mut Keyboard::default();
        keys.down(KeyDown { id: 1, place: Some(Key::Control), ..KeyDown::default() });
        press(keys, (2, Key::S, 's'), 's', &[Key::Control]);
        keys.up(2);
        keys.up(1);
        let input = keys.take();
        assert!(input.held.has(Key::Control) && input.pressed.has(Key::S) && input.typed.is_empty());
        assert!(keys.take().held.is_empty());
        // AltGr comes as Ctrl and Alt from Windows, and types.
        keys.down(KeyDown { id: 1, place: Some(Key::Control), ..KeyDown::default() });
        keys.down(KeyDown { id: 3, place: Some(Key::Alt), ..KeyDown::default() });
        press(keys, (4, Key::V, 'v'), '“', &[Key::Control, Key::Alt]);
        let input = keys.take();
        assert!(
            input.typed == "“" && !input.held.has(Key::Control) && input.keyed.iter().all(|keyed| !keyed.held.has(Key::Control))
        );
    }

    /// Windows: the key, then its character; that of Ctrl and a letter is a control character.
    #[test]
    fn a_character_belongs_to_the_key_that_went_down_before_it() {
        for (typed, held, key) in
            [('z', &[][..], Key::Z), ('\u{1a}', &[Key::Control], Key::Z), ('[', &[Key::Alt], Key::LeftBracket)]
        {
            let keys = &mut Keyboard::default();
            let held = held.iter().copied().collect();
            keys.down(KeyDown { id: 1, place: Some(Key::Key8), held, ..KeyDown::default() });
            keys.typed_by_last(typed, held);
            keys.typed(typed, held);
            let input = keys.take();
            assert!(
                input.pressed.has(key)
                    && input.held.has(key)
                    && input.keyed.iter().any(|keyed| keyed.key == key && keyed.held == held)
            );
        }
    }

    #[test]
    fn the_places_of_a_browser_are_ours() {
        for (code, key) in [
            ("KeyA", Some(Key::A)),
            ("Digit7", Some(Key::Key7)),
            ("Numpad7", Some(Key::Kp7)),
            ("NumpadAdd", Some(Key::KpAdd)),
            ("NumpadEnter", Some(Key::Enter)),
            ("ArrowLeft", Some(Key::Left)),
            ("ShiftRight", Some(Key::Shift)),
            ("Quote", Some(Key::Apostrophe)),
            ("Slash", Some(Key::Slash)),
            ("BracketRight", Some(Key::RightBracket)),
            ("F11", Some(Key::F11)),
            ("PageUp", Some(Key::PageUp)),
            ("IntlBackslash", None),
            ("", None),
        ] {
            assert_eq!(place_of_code(code), key, "{code}");
        }
    }
}
