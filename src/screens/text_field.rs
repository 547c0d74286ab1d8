//! One line of text that can be edited.

use super::input::{Input, Repeat};
use crate::settings::Key;

/// What moves and deletes.
const KEYS: [Key; 6] = [Key::Left, Key::Right, Key::Home, Key::End, Key::Backspace, Key::Delete];

/// The text and where the next character goes.
#[derive(Clone, Debug, Default)]
pub struct TextField {
    text: Vec<char>,
    caret: usize,
    limit: usize,
    repeat: Repeat,
}

impl TextField {
    /// A field that takes at most `limit` characters and begins with `text`.
    pub fn new(text: &str, limit: usize) -> Self {
        let text: Vec<char> = text.chars().take(limit).collect();
        Self { caret: text.len(), text, limit, repeat: Repeat::default() }
    }

    /// Follows the keys; whether the text has changed.
    pub fn update(&mut self, input: &Input) -> bool {
        let before = self.text.clone();
        for character in input.typed.chars().filter(|character| !character.is_control()) {
            if self.text.len() < self.limit {
                self.text.insert(self.caret, character);
                self.caret += 1;
            }
        }
        for key in self.repeat.strokes(input, &KEYS) {
            match key {
                Key::Left => self.caret = self.caret.saturating_sub(1),
                Key::Right => self.caret = (self.caret + 1).min(self.text.len()),
                Key::Home => self.caret = 0,
                Key::End => self.caret = self.text.len(),
                Key::Backspace if self.caret > 0 => {
                    self.caret -= 1;
                    self.text.remove(self.caret);
                }
                Key::Delete if self.caret < self.text.len() => drop(self.text.remove(self.caret)),
                _ => {}
            }
        }
        self.text != before
    }

    /// The text.
    pub fn text(&self) -> String {
        self.text.iter().collect()
    }

    /// The text up to the caret.
    #[cfg(any(test, feature = "window"))]
    pub fn before_caret(&self) -> String {
        self.text[..self.caret].iter().collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn press(field: &mut TextField, keys: &[Key]) {
        for key in keys {
            field.update(&Input { pressed: [*key].into_iter().collect(), ..Input::default() });
            field.update(&Input::default());
        }
    }

    fn type_in(field: &mut TextField, text: &str) -> bool {
        field.update(&Input { typed: text.into(), ..Input::default() })
    }

    #[test]
    fn text_is_edited_at_the_caret() {
        let mut field = TextField::new("bo", 40);
        assert!(type_in(&mut field, "b"));
        press(&mut field, &[Key::Home, Key::Delete]);
        assert!(type_in(&mut field, "R"));
        press(&mut field, &[Key::End, Key::Backspace, Key::Left]);
        assert!(type_in(&mut field, "é"));
        assert_eq!((field.text().as_str(), field.before_caret().as_str()), ("Réo", "Ré"));
    }

    #[test]
    fn forty_characters_and_no_control_characters() {
        let mut field = TextField::new("", 40);
        type_in(&mut field, &"x".repeat(50));
        assert_eq!(field.text().len(), 40);
        press(&mut field, &[Key::Backspace]);
        assert!(!type_in(&mut field, "\r\u{8}\u{7f}\t"));
        assert_eq!(field.text().len(), 39);
    }

    #[test]
    fn nothing_happens_beyond_the_ends() {
        let mut field = TextField::new("", 40);
        press(&mut field, &[Key::Backspace, Key::Delete, Key::Left, Key::Right]);
        assert_eq!(field.text(), "");
    }
}
