//! What is selected, column by column, or the level's settings where nothing is: a field each, written into the files as it is typed.

use super::layout::Parts;
use crate::level::document::{Column, Document, Kind, RowId, SETTINGS, SetCell};
use crate::screens::text_field::TextField;
use crate::screens::{Input, Key};

/// The most letters of a cell.
const MOST: usize = 400;

/// A field of the panel.
#[derive(Clone, Debug)]
pub struct Field {
    /// The column, or the setting.
    pub name: &'static str,
    /// The facts of that column.
    pub column: &'static Column,
    /// What stands there; `None` where the selected things differ.
    pub text: Option<String>,
}

/// The field that has the keyboard.
#[derive(Clone, Debug)]
pub struct Typing {
    pub name: &'static str,
    pub field: TextField,
    /// Typing into one field is one operation.
    gesture: u64,
}

/// What the panel writes into the document.
pub enum Write {
    Cells(Vec<SetCell>, u64),
    Setting(&'static str, String, u64),
}

/// The panel.
#[derive(Clone, Debug, Default)]
pub struct Panel {
    pub fields: Vec<Field>,
    rows: Vec<RowId>,
    pub kind: Option<Kind>,
    pub typing: Option<Typing>,
}

impl Panel {
    /// Shows those rows, or the settings where there are none.
    pub fn show(&mut self, document: &Document, rows: &[RowId]) {
        let kinds: Vec<Option<Kind>> = rows.iter().map(|row| document.kind(*row)).collect();
        self.kind = kinds.first().copied().flatten().filter(|first| kinds.iter().all(|kind| *kind == Some(*first)));
        if self.rows != rows {
            self.rows = rows.to_vec();
            self.typing = None;
        }
        self.fields = match self.kind {
            Some(kind) => {
                let columns = kind.columns().iter().filter(|column| column.name != "kind");
                columns.map(|column| self.field(document, column)).collect()
            }
            None if rows.is_empty() => SETTINGS.iter().map(|column| setting(document, column)).collect(),
            None => Vec::new(),
        };
    }

    fn field(&self, document: &Document, column: &'static Column) -> Field {
        let name = column.name;
        let mut texts = self.rows.iter().map(|row| document.cell(*row, name).unwrap_or_default());
        let first = texts.next().unwrap_or_default();
        let text = texts.all(|text| text == first).then(|| first.to_owned());
        Field { name, column, text }
    }

    /// The words that a field may hold, the usual one first; none where it is free.
    fn choices(&self, name: &str) -> Vec<&'static str> {
        self.fields.iter().find(|field| field.name == name).map_or_else(Vec::new, |field| field.column.choices())
    }

    /// Whether the keyboard is in a field.
    pub fn is_typing(&self) -> bool {
        self.typing.is_some()
    }

    /// Puts the keyboard into a field, if there is one of that name: what is typed takes the place of what is there.
    pub fn focus(&mut self, name: &str, gesture: u64) {
        let field = self.fields.iter().find(|field| field.name == name);
        self.typing = field.map(|field| Typing {
            name: field.name,
            field: TextField::selected(field.text.as_deref().unwrap_or_default(), MOST),
            gesture,
        });
    }

    /// One frame; what is to be written. `gesture` is the number of the next operation.
    pub fn update(&mut self, input: &Input, parts: &Parts, gesture: u64) -> Option<Write> {
        if input.click || input.right_click {
            let under = self
                .fields
                .iter()
                .enumerate()
                .find(|(i, _)| parts.field(*i).contains(input.pointer))
                .map(|(_, field)| field.clone());
            let again = under.as_ref().is_some_and(|under| self.typing.as_ref().is_some_and(|typing| typing.name == under.name));
            if let (Some(field), false) = (&under, again && self.choices(under.as_ref().map_or("", |field| field.name)).is_empty())
            {
                let words = field.column.choices();
                self.focus(field.name, gesture);
                if !words.is_empty() {
                    return Some(self.write(field.name, next(&words, field.text.as_deref(), !input.right_click), gesture));
                }
            } else if under.is_none() {
                self.typing = None;
            } else if let Some(typing) = &mut self.typing {
                typing.field.go_to_end();
            }
            return None;
        }
        let (name, turn) = (self.typing.as_ref()?.name, i32::from(input.pressed(Key::Right)) - i32::from(input.pressed(Key::Left)));
        if input.pressed(Key::Tab) || input.pressed(Key::Down) || input.pressed(Key::Up) {
            let count = self.fields.len();
            let at = self.fields.iter().position(|field| field.name == name).unwrap_or(0);
            let back = input.held(Key::Shift) || input.pressed(Key::Up);
            let to = self.fields[(at + if back { count - 1 } else { 1 }) % count].name;
            self.focus(to, gesture);
            return None;
        }
        if input.pressed(Key::Enter) || input.pressed(Key::Escape) {
            self.typing = None;
            return None;
        }
        let words = self.choices(name);
        if turn != 0 && !words.is_empty() {
            let now = self.fields.iter().find(|field| field.name == name).and_then(|field| field.text.clone());
            return Some(self.write(name, next(&words, now.as_deref(), turn > 0), gesture));
        }
        let typing = self.typing.as_mut()?;
        if typing.field.update(input) {
            let (text, gesture) = (typing.field.text(), typing.gesture);
            return Some(self.write(name, text, gesture));
        }
        None
    }

    fn write(&mut self, name: &'static str, text: String, gesture: u64) -> Write {
        if !self.choices(name).is_empty()
            && let Some(typing) = &mut self.typing
            && typing.field.text() != text
        {
            typing.field = TextField::new(&text, MOST);
        }
        if self.rows.is_empty() {
            return Write::Setting(name, text, gesture);
        }
        Write::Cells(self.rows.iter().map(|row| SetCell { row: *row, column: name, text: text.clone() }).collect(), gesture)
    }
}

fn setting(document: &Document, column: &'static Column) -> Field {
    Field { name: column.name, column, text: Some(document.setting(column.name).unwrap_or_default().to_owned()) }
}

/// The word after that one, or the one before it; an empty cell holds the first.
fn next(words: &[&str], now: Option<&str>, forward: bool) -> String {
    let at = words.iter().position(|word| now.is_some_and(|now| word.eq_ignore_ascii_case(now))).unwrap_or(0);
    words[(at + if forward { 1 } else { words.len() - 1 }) % words.len()].to_owned()
}
