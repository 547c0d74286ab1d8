//! Dead keys: a mark that waits for its letter. X11 hands them over as they are; Windows and browsers compose by themselves.

use unicode_normalization::char::compose;

/// Marks with what they type before a space, as in X11's tables, and twice: `'` stands on the dead key of us-intl.
const MARKS: [(char, char, char); 16] = [
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
pub struct Compose(Option<char>);

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
mod tests {
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
