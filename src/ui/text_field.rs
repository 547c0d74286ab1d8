//! One line of text that can be edited.

use super::input::{Input, Repeat, Stroke};
use crate::{draw::Canvas, draw::Style, draw::layout::Area, draw::layout::Vec2, settings::Key, settings::Keys, view::theme};

const KEYS: [Key; 6] = [Key::Left, Key::Right, Key::Home, Key::End, Key::Backspace, Key::Delete];
/// With Ctrl: select all, copy, cut, paste.
const COMMANDS: [Key; 4] = [Key::A, Key::C, Key::X, Key::V];

/// Height of the caret and of the selection, in heights of the text.
const CARET: f32 = 1.35;

/// The text and its caret.
#[derive(Clone, Debug, Default)]
pub struct TextField {
    text: Vec<char>,
    caret: usize,
    /// The other end of the selection; at the caret without a selection.
    anchor: usize,
    limit: usize,
    repeat: Repeat,
    /// Whether the field had the focus in the last frame, and has lost it since.
    had_focus: bool,
    left: bool,
}

impl TextField {
    /// At most `limit` characters.
    pub fn new(text: &str, limit: usize) -> Self {
        let text: Vec<char> = text.chars().take(limit).collect();
        Self { caret: text.len(), anchor: text.len(), text, limit, ..Self::default() }
    }

    /// All of it is selected: the first character takes its place.
    pub fn selected(text: &str, limit: usize) -> Self {
        Self { anchor: 0, ..Self::new(text, limit) }
    }

    pub fn select_all(&mut self) {
        (self.anchor, self.caret) = (0, self.text.len());
    }

    /// Where the focus returns, all is selected.
    pub(super) fn note_focus(&mut self, focus: bool) {
        self.left |= self.had_focus && !focus;
        if focus && std::mem::take(&mut self.left) {
            self.select_all();
        }
        self.had_focus = focus;
    }

    /// The focus returns by a letter: nothing is selected.
    pub(super) fn come_back(&mut self) {
        self.left = false;
    }

    /// Follows characters and keys in order; whether the text has changed.
    pub fn update(&mut self, input: &Input) -> bool {
        let before = self.text.clone();
        let repeated = self.repeat.strokes(input, &KEYS);
        let mut fresh = false;
        for stroke in input.strokes(&[&KEYS[..], &COMMANDS].concat()) {
            match stroke {
                Stroke::Letter(letter) => self.put(&[letter]),
                Stroke::Key(key, held) => {
                    fresh |= KEYS.contains(&key);
                    self.press(key, held, input);
                }
            }
        }
        for key in repeated.into_iter().filter(|_| !fresh) {
            self.press(key, input.held, input);
        }
        self.text != before
    }

    fn press(&mut self, key: Key, held: Keys, input: &Input) {
        let (more, control) = (held.has(Key::Shift), held.has(Key::Control));
        let (from, to) = self.selection();
        match key {
            Key::Left if from < to && !more => self.go(from, false),
            Key::Right if from < to && !more => self.go(to, false),
            Key::Left => self.go(self.caret.saturating_sub(1), more),
            Key::Right => self.go(self.caret + 1, more),
            Key::Home => self.go(0, more),
            Key::End => self.go(self.text.len(), more),
            Key::Backspace | Key::Delete if from < to => self.put(&[]),
            Key::Backspace if self.caret > 0 => {
                self.go(self.caret - 1, true);
                self.put(&[]);
            }
            Key::Delete => {
                self.go(self.caret + 1, true);
                self.put(&[]);
            }
            Key::A if control => self.select_all(),
            Key::C | Key::X if control && from < to => {
                input.clipboard.keep(self.text[from..to].iter().collect());
                if key == Key::X {
                    self.put(&[]);
                }
            }
            Key::V if control => {
                let pasted: Vec<char> = input.clipboard.text().chars().collect();
                // An empty clipboard keeps the selection.
                if !pasted.is_empty() {
                    self.put(&pasted);
                }
            }
            _ => {}
        }
    }

    /// Moves the caret; `more` extends the selection to there.
    pub fn go(&mut self, to: usize, more: bool) {
        self.caret = to.min(self.text.len());
        if !more {
            self.anchor = self.caret;
        }
    }

    /// Replaces the selection by as many characters as fit.
    fn put(&mut self, characters: &[char]) {
        let (from, to) = self.selection();
        let room = self.limit.saturating_sub(self.text.len() - (to - from));
        let fit: Vec<char> = characters.iter().copied().filter(|character| !character.is_control()).take(room).collect();
        if fit.is_empty() && !characters.is_empty() {
            return;
        }
        let end = from + fit.len();
        self.text.splice(from..to, fit);
        self.go(end, false);
    }

    pub fn text(&self) -> String {
        self.text.iter().collect()
    }

    /// First and last character of the selection.
    pub fn selection(&self) -> (usize, usize) {
        (self.anchor.min(self.caret), self.anchor.max(self.caret))
    }

    #[cfg(test)]
    fn before_caret(&self) -> String {
        self.text[..self.caret].iter().collect()
    }

    /// `inside`: the box's padding; `time` (s) makes the caret blink, `None`: no focus. A text wider than the box loses its beginning.
    pub fn draw(&self, canvas: &Canvas, area: Area, (size, inside): (f32, f32), time: Option<f64>) {
        let style = Style::new(size, theme::text()).mono().middle();
        let width = |from: usize, to: usize| canvas.width(&self.text[from..to].iter().collect::<String>(), style);
        let room = area.size.x - 2.0 * inside;
        let first = (0..self.caret).find(|first| width(*first, self.caret) <= room).unwrap_or(self.caret);
        let last = (first..=self.text.len()).take_while(|last| width(first, *last) <= room).last().unwrap_or(first);
        let left = Vec2::new(area.min.x + inside, area.centre().y);
        let height = canvas.frame().text_height(size) * CARET;
        let bar = |from: f32, to: f32| Area::new(left.x + from, left.y - height / 2.0, to - from, height);
        let (from, to) = self.selection();
        let (from, to) = (from.clamp(first, last), to.clamp(first, last));
        if time.is_some() && from < to {
            canvas.rounded(bar(width(first, from), width(first, to)), 2.0, theme::solid());
        }
        canvas.typed(&self.text[first..last].iter().collect::<String>(), left, style);
        if time.is_some_and(|time| time.fract() < 0.5) {
            let x = width(first, self.caret);
            canvas.rounded(bar(x - 0.75, x + 0.75), 0.0, theme::accent());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ui::input::{Clipboard, Keyed};

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

    fn with_control(field: &mut TextField, key: Key, board: &Clipboard) {
        let held = [Key::Control, key].into_iter().collect();
        let pressed = [key].into_iter().collect();
        // The system types the letter, too.
        let typed = key.label().to_lowercase();
        field.update(&Input { pressed, held, typed, clipboard: board.clone(), ..Input::default() });
        field.update(&Input::default());
    }

    #[test]
    fn what_is_selected_is_copied_cut_and_pasted_and_the_next_letter_takes_its_place() {
        let (mut field, mut other) = (TextField::new("gate", 6), TextField::selected("old", 40));
        let board = Clipboard::default();
        with_control(&mut field, Key::A, &board);
        with_control(&mut field, Key::V, &board);
        assert_eq!(field.text(), "gate", "there is nothing to paste yet");
        with_control(&mut field, Key::C, &board);
        with_control(&mut other, Key::V, &board);
        assert_eq!((field.text().as_str(), other.text().as_str()), ("gate", "gate"));
        press(&mut field, &[Key::End]);
        with_control(&mut field, Key::V, &board);
        assert_eq!(field.text(), "gatega", "as far as there is room");
        with_control(&mut field, Key::A, &board);
        with_control(&mut field, Key::X, &board);
        assert_eq!(field.text(), "");
        board.keep("two\nlines\t".to_owned());
        with_control(&mut field, Key::V, &board);
        assert_eq!(field.text(), "twolin");
        // Shift selects; Left goes to the selection's beginning.
        let held: Keys = [Key::Shift].into_iter().collect();
        for _ in 0..2 {
            field.update(&Input { pressed: [Key::Left].into_iter().collect(), held, ..Input::default() });
        }
        assert_eq!(field.selection(), (4, 6));
        assert!(type_in(&mut field, "x"));
        assert_eq!(field.text(), "twolx");
        field.select_all();
        press(&mut field, &[Key::Left]);
        assert_eq!((field.selection(), field.before_caret().as_str()), ((0, 0), ""));
    }

    #[test]
    fn at_few_frames_a_second_letters_and_keys_act_in_the_order_in_which_they_came() {
        let mut field = TextField::new("gates", 40);
        let keyed = |key, after| Keyed { key, after, held: Keys::default() };
        let input = Input {
            typed: "xyz".into(),
            pressed: [Key::Backspace, Key::Home].into_iter().collect(),
            keyed: vec![keyed(Key::Backspace, 0), keyed(Key::Backspace, 1), keyed(Key::Backspace, 1), keyed(Key::Home, 2)],
            ..Input::default()
        };
        field.update(&input);
        assert_eq!((field.text().as_str(), field.before_caret().as_str()), ("zgaty", "z"));
    }
}
