//! The comments of a record, `# name: value`: their place and their values.

use super::clock::TICK_RATES;
use super::event::Outcome;
use std::str::FromStr;

/// An hour. The end of a longer flight has its own hash; more hashes would outgrow the file's inputs.
pub const MOST_SECONDS: usize = 3600;

/// The most comments that are read of a file: a record has one a second, and people add some.
const MOST_NOTES: usize = 2 * MOST_SECONDS;

pub(super) struct ReplayNotes<'a> {
    file: &'a str,
    /// Number, name and value of each line `# name: value`.
    lines: Vec<(usize, (&'a str, &'a str))>,
}

impl<'a> ReplayNotes<'a> {
    pub fn of(file: &'a str, text: &'a str) -> Self {
        let note = |line: &'a str| {
            let (key, value) = line.trim().trim_start_matches('\u{feff}').strip_prefix('#')?.split_once(':')?;
            Some((key.trim(), value.trim()))
        };
        let lines = (1..).zip(text.lines()).filter_map(|(number, line)| Some((number, note(line)?)));
        Self { file, lines: lines.take(MOST_NOTES).collect() }
    }

    fn line(&self, name: &str) -> Option<(usize, &str)> {
        self.lines.iter().find(|(_, (key, _))| *key == name).map(|&(number, (_, value))| (number, value))
    }

    /// The hashes of the seconds, from the first on without a gap.
    pub fn seconds(&self, problems: &mut Vec<String>) -> Vec<u64> {
        let mut hashes = Vec::new();
        for &(line, (key, value)) in &self.lines {
            let Some(second) = key.strip_prefix("hash ") else { continue };
            let next = hashes.len() + 1;
            if second.trim() != next.to_string() || next > MOST_SECONDS {
                let expected = if next > MOST_SECONDS { "no more of them".to_owned() } else { format!("\"hash {next}\"") };
                problems.push(format!("{}:{line}: found {key:?}, expected {expected}", self.file));
                break;
            }
            match value.parse() {
                Ok(Hex(hash)) => hashes.push(hash),
                Err(()) => {
                    problems.push(format!("{}:{line}: {key:?}: found {value:?}, expected 16 hex digits", self.file));
                    break;
                }
            }
        }
        hashes
    }

    /// The value of a required line.
    pub fn find<T: FromStr>(&self, name: &str, expected: &str, problems: &mut Vec<String>) -> Option<T> {
        if self.line(name).is_none() {
            problems.push(format!("{}:1: {name:?}: found no line \"# {name}: …\", expected {expected}", self.file));
        }
        self.find_any(name, expected, problems)
    }

    /// The value of an optional line.
    pub fn find_any<T: FromStr>(&self, name: &str, expected: &str, problems: &mut Vec<String>) -> Option<T> {
        let (line, value) = self.line(name)?;
        let bad = |_| problems.push(format!("{}:{line}: {name:?}: found {value:?}, expected {expected}", self.file));
        value.parse().map_err(bad).ok()
    }
}

/// A name as it is, or in quotes where it would not come back whole.
pub(super) fn written(name: &str) -> String {
    let plain = name.trim() == name && !name.starts_with('"') && !name.chars().any(|c| c.is_control() || LINE_ENDS.contains(&c));
    if plain { name.to_owned() } else { format!("{name:?}") }
}

/// Besides control characters, these end a line for some programs.
const LINE_ENDS: [char; 2] = ['\u{2028}', '\u{2029}'];

/// A name in the form of [`written`].
pub(super) struct Plain(pub String);

impl FromStr for Plain {
    type Err = ();

    fn from_str(text: &str) -> Result<Self, ()> {
        match text.strip_prefix('"') {
            None if text.is_empty() => Err(()),
            None => Ok(Self(text.to_owned())),
            Some(rest) => unquoted(rest.strip_suffix('"').ok_or(())?).map(Self).ok_or(()),
        }
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

/// Within [`TICK_RATES`].
pub(super) struct TickRate(pub f64);

impl FromStr for TickRate {
    type Err = ();

    fn from_str(text: &str) -> Result<Self, ()> {
        text.parse().ok().filter(|rate| TICK_RATES.contains(rate)).map(Self).ok_or(())
    }
}

/// By its name.
pub(super) struct Ended(pub Outcome);

impl FromStr for Ended {
    type Err = ();

    fn from_str(text: &str) -> Result<Self, ()> {
        [Outcome::Running, Outcome::Completed, Outcome::Failed]
            .into_iter()
            .find(|outcome| outcome.name() == text)
            .map(Self)
            .ok_or(())
    }
}

/// Finite, from 0 on.
pub(super) struct Seconds(pub f64);

impl FromStr for Seconds {
    type Err = ();

    fn from_str(text: &str) -> Result<Self, ()> {
        text.parse().ok().filter(|time: &f64| time.is_finite() && *time >= 0.0).map(Self).ok_or(())
    }
}

/// 16 digits.
pub(super) struct Hex(pub u64);

impl FromStr for Hex {
    type Err = ();

    fn from_str(text: &str) -> Result<Self, ()> {
        let digits = text.len() == 16 && text.bytes().all(|byte| byte.is_ascii_hexdigit());
        digits.then(|| u64::from_str_radix(text, 16).ok()).flatten().map(Self).ok_or(())
    }
}
