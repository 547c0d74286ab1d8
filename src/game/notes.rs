//! The comments of a record, `# name: value`: their place and their values.

use crate::files::found_instead;
use crate::words::tr;

/// An hour. The end of a longer flight has its own hash; more hashes would outgrow the file's inputs.
pub const MOST_SECONDS: usize = 3600;

/// The most comments that are read of a file: a record has one a second, and people add some.
const MOST_NOTES: usize = 2 * MOST_SECONDS;

pub(super) struct ReplayNotes<'a> {
    file: &'a str,
    /// Number, name and value of each line `# name: value`.
    lines: Vec<(usize, (&'a str, &'a str))>,
    pub problems: Vec<String>,
}

impl<'a> ReplayNotes<'a> {
    pub fn of(file: &'a str, text: &'a str) -> Self {
        let note = |line: &'a str| {
            let line = as_written(line.trim().trim_start_matches('\u{feff}'));
            let (key, value) = line.strip_prefix('#')?.split_once(':')?;
            Some((key.trim(), value.trim()))
        };
        let lines = (1..).zip(text.lines()).filter_map(|(number, line)| Some((number, note(line)?)));
        Self { file, lines: lines.take(MOST_NOTES).collect(), problems: Vec::new() }
    }

    /// The hashes of the seconds, from the first on without a gap.
    pub fn seconds(&mut self) -> Vec<u64> {
        let mut hashes = Vec::new();
        for &(line, (key, value)) in &self.lines {
            let Some(second) = key.strip_prefix("hash ") else { continue };
            let next = hashes.len() + 1;
            if second.trim() != next.to_string() || next > MOST_SECONDS {
                let expected = if next > MOST_SECONDS { tr("no more of them").to_owned() } else { format!("\"hash {next}\"") };
                let found = format!("{key:?}");
                self.problems.push(found_instead(&format!("{}:{line}", self.file), found, expected));
                break;
            }
            let Some(hash) = hex(value) else {
                let found = format!("{value:?}");
                self.problems.push(found_instead(&format!("{}:{line}: {key:?}", self.file), found, tr("16 hex digits")));
                break;
            };
            hashes.push(hash);
        }
        hashes
    }

    /// The value of a required line.
    pub fn find<T>(&mut self, name: &str, expected: &str, read: impl FnOnce(&str) -> Option<T>) -> Option<T> {
        if !self.lines.iter().any(|(_, (key, _))| *key == name) {
            let found = tr!("no line {line}", line = format_args!("\"# {name}: …\""));
            self.problems.push(found_instead(&format!("{}:1: {name:?}", self.file), found, expected));
        }
        self.find_any(name, expected, read)
    }

    /// The value of an optional line.
    pub fn find_any<T>(&mut self, name: &str, expected: &str, read: impl FnOnce(&str) -> Option<T>) -> Option<T> {
        let &(line, (_, value)) = self.lines.iter().find(|(_, (key, _))| *key == name)?;
        let found = read(value);
        if found.is_none() {
            let place = format!("{}:{line}: {name:?}", self.file);
            self.problems.push(found_instead(&place, format_args!("{value:?}"), expected));
        }
        found
    }
}

/// A spreadsheet fills a note's row with empty cells.
fn as_written(line: &str) -> &str {
    line.trim_end_matches([',', ';', '\t'])
}

/// A name as it is, or in quotes where it would not come back whole.
pub(super) fn written(name: &str) -> String {
    let plain = as_written(name.trim()) == name
        && !name.starts_with('"')
        && !name.chars().any(|c| c.is_control() || LINE_ENDS.contains(&c));
    if plain { name.to_owned() } else { format!("{name:?}") }
}

/// Besides control characters, these end a line for some programs.
const LINE_ENDS: [char; 2] = ['\u{2028}', '\u{2029}'];

/// A name in the form of [`written`].
pub(super) fn plain(text: &str) -> Option<String> {
    match text.strip_prefix('"') {
        None => Some(text.to_owned()).filter(|name| !name.is_empty()),
        Some(rest) => unquoted(rest.strip_suffix('"')?),
    }
}

/// The inverse of a text's debug form, without the quotes; `None` for any other text.
fn unquoted(text: &str) -> Option<String> {
    let (mut name, mut rest) = (String::new(), text.chars());
    while let Some(c) = rest.next() {
        name.push(match (c, c == '\\') {
            (_, true) => match rest.next()? {
                'n' => '\n',
                'r' => '\r',
                't' => '\t',
                '0' => '\0',
                'u' => {
                    let (digits, after) = rest.as_str().strip_prefix('{')?.split_once('}')?;
                    rest = after.chars();
                    char::from_u32(u32::from_str_radix(digits, 16).ok()?)?
                }
                plain @ ('\\' | '"' | '\'') => plain,
                _ => return None,
            },
            ('"', false) => return None,
            (plain, false) => plain,
        });
    }
    Some(name)
}

/// 16 digits.
pub(super) fn hex(text: &str) -> Option<u64> {
    let digits = text.len() == 16 && text.bytes().all(|byte| byte.is_ascii_hexdigit());
    digits.then(|| u64::from_str_radix(text, 16).ok()).flatten()
}
