use super::*;

/// A key of a layout: id, place, what it types alone.
type Plain = (u32, Key, char);

fn press(keyboard: &mut Keyboard, (id, place, plain): Plain, typed: char, held: &[Key]) {
    let held = held.iter().copied().collect();
    keyboard.down(KeyDown { id, place: Some(place), typed: Some(typed), plain: Some(plain), silent: false, repeat: false, held });
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
    assert!(input.typed == "“" && !input.held.has(Key::Control) && input.keyed.iter().all(|keyed| !keyed.held.has(Key::Control)));
}

/// Windows: the key, then its character; that of Ctrl and a letter is a control character.
#[test]
fn a_character_belongs_to_the_key_that_went_down_before_it() {
    for (typed, held, key) in [('z', &[][..], Key::Z), ('\u{1a}', &[Key::Control], Key::Z), ('[', &[Key::Alt], Key::LeftBracket)] {
        let keys = &mut Keyboard::default();
        let held = held.iter().copied().collect();
        keys.down(KeyDown { id: 1, place: Some(Key::Key8), held, ..KeyDown::default() });
        keys.typed_by_last(typed, held);
        keys.typed(typed, held);
        let input = keys.take();
        assert!(
            input.pressed.has(key) && input.held.has(key) && input.keyed.iter().any(|keyed| keyed.key == key && keyed.held == held)
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
