//! The languages of the sheets. The English text of a lesson is the key of its translations in `docs/lessons/words/`; words that the
//! screens have too stand in `assets/words/` alone.

use super::read;
use std::cell::{Cell, RefCell};
use std::collections::{BTreeSet, HashMap};
use std::path::Path;

/// Codes of the languages, and their names in themselves. English has no catalogue.
pub const LANGUAGES: [(&str, &str); 3] = [("en", "English"), ("de", "Deutsch"), ("fr", "Français")];

/// The texts of a language.
pub struct SheetWords {
    pub code: &'static str,
    /// Empty for English.
    rows: HashMap<String, String>,
    /// Those of the screens.
    shared: HashMap<String, String>,
    unused: RefCell<BTreeSet<String>>,
    missing: Cell<Option<String>>,
}

impl SheetWords {
    /// Fails on a file that is no catalogue, and on a translation with other numbers than its text.
    pub fn read(root: &Path, code: &'static str) -> Result<Self, String> {
        let catalogue = |folder: &str| match code {
            "en" => Ok(HashMap::new()),
            _ => rows(root, &format!("{folder}/{code}.csv")),
        };
        let rows = catalogue("docs/lessons/words")?;
        if let Some((text, said)) = rows.iter().find(|(text, said)| numbers(text) != numbers(said)) {
            return Err(format!("docs/lessons/words/{code}.csv: other numbers than in {text:?}: {said:?}"));
        }
        let unused = RefCell::new(rows.keys().cloned().collect());
        Ok(Self { code, rows, shared: catalogue("assets/words")?, unused, missing: Cell::new(None) })
    }

    /// The folder of the pages below that of the English ones, as in `de/`; empty for English.
    pub fn folder(&self) -> String {
        if self.code == "en" { String::new() } else { format!("{}/", self.code) }
    }

    /// The text in this language; one that the catalogues lack fails the next [`Self::complete`].
    pub fn say<'a>(&'a self, text: &'a str) -> &'a str {
        self.unused.borrow_mut().remove(text);
        let said = self.rows.get(text).or_else(|| self.shared.get(text));
        if said.is_none() && self.code != "en" {
            self.missing.set(Some(text.to_owned()));
        }
        said.map_or(text, String::as_str)
    }

    /// The name of a quantity: each part between commas is a text of its own, or a value that stays.
    pub fn quantity(&self, text: &str) -> String {
        let part = |part| if is_value(part) { part } else { self.say(part) };
        text.split(", ").map(part).collect::<Vec<_>>().join(", ")
    }

    /// A change of a level: its columns, values and files stay as they are written there.
    pub fn change(&self, text: &str) -> String {
        let change = |change: &str| {
            let Some((setting, place)) = change.rsplit_once(" in ") else { return self.say(change).to_owned() };
            let (setting, note) = setting.split_once(" (").map_or((setting, None), |(setting, note)| (setting, Some(note)));
            let note = note.map_or_else(String::new, |note| format!(" ({})", self.quantity(note.trim_end_matches(')'))));
            let (column, value) = setting.split_once("` ").unwrap_or((setting, ""));
            let setting = format!("{column}` `{value}`{note}");
            let place = match place.split_once(" of ") {
                Some(("every row", file)) => format!("{} {file}", self.say("in every row of")),
                Some((row, file)) => format!("{} {} {} {file}", self.say("in row"), row.trim_start_matches("row "), self.say("of")),
                None => format!("{} {place}", self.say("in")),
            };
            format!("{setting} {place}")
        };
        text.split("; ").map(change).collect::<Vec<_>>().join("; ")
    }

    /// A page's text with the decimal marks of the language; what is code stays.
    pub fn decimals(&self, body: &str) -> String {
        if self.code == "en" {
            return body.to_owned();
        }
        let digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
        let commas = |text: &str| {
            let mark = |(at, c): (usize, char)| {
                let parts = digit(text[..at].chars().next_back()) && digit(text[at + c.len_utf8()..].chars().next());
                if c == '.' && parts { ',' } else { c }
            };
            text.char_indices().map(mark).collect::<String>()
        };
        let mut parts = body.split("<code>");
        let first = parts.next().map(commas).unwrap_or_default();
        parts.fold(first, |page, part| {
            let (code, text) = part.split_once("</code>").unwrap_or((part, ""));
            format!("{page}<code>{code}</code>{}", commas(text))
        })
    }

    /// Fails on a text of `file` that the catalogues lack.
    pub fn complete(&self, file: &str) -> Result<(), String> {
        self.missing
            .take()
            .map_or(Ok(()), |text| Err(format!("docs/lessons/words/{}.csv lacks a text of {file}: {text:?}", self.code)))
    }

    /// Fails on a row that no page has asked for.
    pub fn used(&self) -> Result<(), String> {
        let unused = self.unused.borrow_mut().pop_first();
        unused.map_or(Ok(()), |text| Err(format!("docs/lessons/words/{}.csv: no sheet says {text:?}", self.code)))
    }
}

/// The English texts of a catalogue and their translations.
fn rows(root: &Path, file: &str) -> Result<HashMap<String, String>, String> {
    let text = read(&root.join(file))?;
    csv::Reader::from_reader(text.as_bytes())
        .into_deserialize()
        .collect::<Result<_, _>>()
        .map_err(|error| format!("{file}: {error}"))
}

/// As in `1 kg`, `30°` and `e = 0.5`.
fn is_value(text: &str) -> bool {
    let number = text.trim_start_matches("e = ");
    number.starts_with(|first: char| first.is_ascii_digit()) && number.split(' ').count() <= 2
}

/// The numbers of a text, without their order.
fn numbers(text: &str) -> Vec<&str> {
    let parts = text.split(|c: char| !c.is_ascii_digit() && c != '.').map(|part| part.trim_matches('.'));
    let mut numbers: Vec<&str> = parts.filter(|part| !part.is_empty()).collect();
    numbers.sort_unstable();
    numbers
}
