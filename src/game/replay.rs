//! A recorded run: the inputs, and what they came to. Its file is an inputs file whose comments say the rest, so that it can be
//! flown wherever inputs can.
//!
//! ```text
//! # program: resultant 0.1.0
//! # level: 1
//! # level_hash: 0123456789abcdef
//! # tick_rate: 120
//! # score: 17342
//! # hash: 0123456789abcdef
//! ticks,thrust,reverse,left,right
//! 60,1,0,0,0
//! ```
//!
//! The first and the third line are not in records of before there were any; such a record is flown in whatever level has its name.

use super::{BadFile, Game, GameError, Inputs, Outcome, TICK_RATES, level_hash};
use crate::level::Level;
use std::fmt;
use std::str::FromStr;
use std::sync::Arc;

/// This program, as records name it.
pub const PROGRAM: &str = concat!("resultant ", env!("CARGO_PKG_VERSION"));

/// A recorded run.
#[derive(Clone, Debug, PartialEq)]
pub struct Replay {
    /// What recorded it, where that is written down.
    pub program: Option<String>,
    /// The level's folder name.
    pub level: String,
    /// The level's hash, as [`level_hash`] has it, where that is written down.
    pub level_hash: Option<u64>,
    /// Ticks a second.
    pub tick_rate: f64,
    /// The score it came to.
    pub score: i64,
    /// The hash of the last state.
    pub hash: u64,
    /// The controls from the first tick on.
    pub inputs: Inputs,
}

/// How a run flown again differs from the recorded one; of each pair the first was recorded.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Mismatch {
    /// The level is another one, by its hash; it was not flown.
    Level(u64, u64),
    /// It leads elsewhere.
    End {
        /// Points.
        score: (i64, i64),
        /// The hash of the last state.
        hash: (u64, u64),
    },
}

impl fmt::Display for Mismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Level(recorded, here) => {
                write!(f, "recorded in a level with the hash {recorded:016x}, the level of that name here has the hash {here:016x}")
            }
            Self::End { score, hash } => {
                write!(f, "recorded score {} and hash {:016x}, flown score {} and hash {:016x}", score.0, hash.0, score.1, hash.1)
            }
        }
    }
}

impl Replay {
    /// The record of a game that was played with these inputs.
    pub fn of(game: &Game, inputs: Inputs) -> Self {
        Self {
            program: Some(PROGRAM.to_owned()),
            level: game.level().name.clone(),
            level_hash: Some(level_hash(game.level())),
            tick_rate: game.tick_rate(),
            score: game.result().score.total,
            hash: game.hash(),
            inputs,
        }
    }

    /// Reads the text of a replay file; `file` is its name in messages.
    ///
    /// # Errors
    /// As [`Inputs::parse`]; a `# name: value` line that is missing or unreadable.
    pub fn parse(file: &str, text: &str) -> Result<Self, BadFile> {
        let mut problems = Vec::new();
        let notes = Notes::of(file, text);
        let program = notes.find_any("program", "a program's name and version", &mut problems);
        let level = notes.find("level", "a level's name", &mut problems);
        let level_hash = notes.find_any("level_hash", "16 hex digits", &mut problems);
        let tick_rate = notes.find("tick_rate", "1 to 1000000 ticks a second", &mut problems);
        let score = notes.find("score", "points", &mut problems);
        let hash = notes.find("hash", "16 hex digits", &mut problems);
        let inputs = Inputs::parse(file, text).map_err(|BadFile(found)| problems.extend(found)).ok();
        match (level, tick_rate, score, hash, inputs) {
            (Some(LevelName(level)), Some(TickRate(tick_rate)), Some(score), Some(Hex(hash)), Some(inputs))
                if problems.is_empty() =>
            {
                let level_hash = level_hash.map(|Hex(hash)| hash);
                Ok(Self { program, level, level_hash, tick_rate, score, hash, inputs })
            }
            _ => Err(BadFile(problems)),
        }
    }

    /// Flies the inputs again and compares where they lead. `watch` is told of every tick when it is over.
    ///
    /// # Errors
    /// As [`Game::with_tick_rate`].
    pub fn verify(&self, level: Arc<Level>, mut watch: impl FnMut(&Game)) -> Result<Result<(), Mismatch>, GameError> {
        let here = level_hash(&level);
        if let Some(recorded) = self.level_hash.filter(|&recorded| recorded != here) {
            return Ok(Err(Mismatch::Level(recorded, here)));
        }
        let mut game = Game::with_tick_rate(level, self.tick_rate)?;
        let mut playback = self.inputs.clone().into_iter();
        // Once it has ended nothing changes any more.
        while game.outcome() == Outcome::Running
            && let Some(controls) = playback.next()
        {
            game.step(controls);
            watch(&game);
        }
        let (score, hash) = (game.result().score.total, game.hash());
        let same = (score, hash) == (self.score, self.hash);
        Ok(if same { Ok(()) } else { Err(Mismatch::End { score: (self.score, score), hash: (self.hash, hash) }) })
    }
}

impl fmt::Display for Replay {
    /// The text of the file, which [`Replay::parse`] reads.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { program, level, level_hash, tick_rate, score, hash, inputs } = self;
        if let Some(program) = program {
            writeln!(f, "# program: {program}")?;
        }
        writeln!(f, "# level: {}", written(level))?;
        if let Some(level_hash) = level_hash {
            writeln!(f, "# level_hash: {level_hash:016x}")?;
        }
        write!(f, "# tick_rate: {tick_rate}\n# score: {score}\n# hash: {hash:016x}\n{inputs}")
    }
}

/// The comments of a replay file.
struct Notes<'a> {
    file: &'a str,
    /// Number, name and value of each line `# name: value`.
    lines: Vec<(usize, (&'a str, &'a str))>,
}

impl<'a> Notes<'a> {
    fn of(file: &'a str, text: &'a str) -> Self {
        let note = |line: &'a str| {
            let (key, value) = line.trim().trim_start_matches('\u{feff}').strip_prefix('#')?.split_once(':')?;
            Some((key.trim(), value.trim()))
        };
        let lines = (1..).zip(text.lines()).filter_map(|(number, line)| Some((number, note(line)?)));
        Self { file, lines: lines.collect() }
    }

    /// The first line `# name: value`, and its number.
    fn line(&self, name: &str) -> Option<(usize, &str)> {
        self.lines.iter().find(|(_, (key, _))| *key == name).map(|&(number, (_, value))| (number, value))
    }

    /// The value of a line that has to be there.
    fn find<T: FromStr>(&self, name: &str, expected: &str, problems: &mut Vec<String>) -> Option<T> {
        if self.line(name).is_none() {
            problems.push(format!("{}:1: {name:?}: found no line \"# {name}: …\", expected {expected}", self.file));
        }
        self.find_any(name, expected, problems)
    }

    /// The value of a line that may be missing.
    fn find_any<T: FromStr>(&self, name: &str, expected: &str, problems: &mut Vec<String>) -> Option<T> {
        let (line, value) = self.line(name)?;
        let bad = |_| problems.push(format!("{}:{line}: {name:?}: found {value:?}, expected {expected}", self.file));
        value.parse().map_err(bad).ok()
    }
}

/// A level's name on its line: as it is, or in quotes where it would not come back whole.
fn written(level: &str) -> String {
    let plain =
        level.trim() == level && !level.starts_with('"') && !level.chars().any(|c| c.is_control() || LINE_ENDS.contains(&c));
    if plain { level.to_owned() } else { format!("{level:?}") }
}

/// What some programs take for the end of a line, besides control characters.
const LINE_ENDS: [char; 2] = ['\u{2028}', '\u{2029}'];

/// What [`written`] has written.
struct LevelName(String);

impl FromStr for LevelName {
    type Err = ();

    fn from_str(text: &str) -> Result<Self, ()> {
        match text.strip_prefix('"') {
            None if text.is_empty() => Err(()),
            None => Ok(Self(text.to_owned())),
            Some(rest) => unquoted(rest.strip_suffix('"').ok_or(())?).map(Self).ok_or(()),
        }
    }
}

/// The text between the quotes of its debug form; `None` where it is none.
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

/// A tick rate that a game can be given.
struct TickRate(f64);

impl FromStr for TickRate {
    type Err = ();

    fn from_str(text: &str) -> Result<Self, ()> {
        text.parse().ok().filter(|rate| TICK_RATES.contains(rate)).map(Self).ok_or(())
    }
}

/// 64 bits as 16 hex digits.
struct Hex(u64);

impl FromStr for Hex {
    type Err = ();

    fn from_str(text: &str) -> Result<Self, ()> {
        let digits = text.len() == 16 && text.bytes().all(|byte| byte.is_ascii_hexdigit());
        digits.then(|| u64::from_str_radix(text, 16).ok()).flatten().map(Self).ok_or(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::game::Controls;

    fn replay() -> Replay {
        let mut inputs = Inputs::default();
        inputs.record(Controls { thrust: true, ..Controls::default() });
        Replay {
            program: Some(PROGRAM.into()),
            level: "up: and away".into(),
            level_hash: Some(0x1f),
            tick_rate: 59.94,
            score: 17_342,
            hash: 0xabc,
            inputs,
        }
    }

    #[test]
    fn a_record_from_before_levels_had_hashes_is_read() {
        let old = Replay { program: None, level_hash: None, ..replay() };
        let text = old.to_string();
        assert!(text.starts_with("# level: up: and away\n# tick_rate: 59.94\n# score: 17342\n"), "{text}");
        assert_eq!(Replay::parse("run.csv", &text), Ok(old));
        let bad = Replay::parse("run.csv", &text.replace("# score", "# level_hash: 12\n# score")).unwrap_err();
        assert_eq!(bad.0, [r#"run.csv:3: "level_hash": found "12", expected 16 hex digits"#]);
    }

    #[test]
    fn no_name_of_a_level_writes_lines_of_its_own() {
        for name in [
            "a\n# score: 99999",
            "a\r\n# hash: 0",
            " a",
            "a ",
            "\"a\"",
            "\"",
            "\u{1b}[2J\0\u{85}\u{2028}x",
            "a\\n",
            "C:\\x",
            "\ta'\"\\\n",
            "é\u{301}\n",
        ] {
            let named = Replay { level: name.into(), ..replay() };
            let text = named.to_string();
            assert_eq!(text.lines().count(), 8, "{text}");
            assert_eq!(Replay::parse("run.csv", &text), Ok(named), "{text}");
        }
        for line in ["", "\"", "\"a", "\"a\"b\"", "\"\\q\"", "\"\\u{}\"", "\"\\u{d800}\"", "\"\\"] {
            let text = replay().to_string().replace("up: and away", line);
            assert!(Replay::parse("run.csv", &text).is_err(), "{line}");
        }
    }

    #[test]
    fn what_is_written_reads_back_also_as_inputs() {
        let text = replay().to_string();
        assert_eq!(Replay::parse("run.csv", &text), Ok(replay()));
        assert_eq!(Replay::parse("run.csv", &format!("\u{feff}{}", text.replace('\n', "\r\n"))), Ok(replay()));
        assert_eq!(Inputs::parse("run.csv", &text), Ok(replay().inputs));
    }

    #[test]
    fn every_problem_is_told_with_its_place() {
        let text = "# score: lots\n# tick_rate: 0\n# hash: abc\nticks,thrust,reverse,left,right\n0,0,0,0,0\n";
        assert_eq!(
            Replay::parse("run.csv", text).unwrap_err().0,
            [
                r##"run.csv:1: "level": found no line "# level: …", expected a level's name"##,
                r#"run.csv:2: "tick_rate": found "0", expected 1 to 1000000 ticks a second"#,
                r#"run.csv:1: "score": found "lots", expected points"#,
                r#"run.csv:3: "hash": found "abc", expected 16 hex digits"#,
                r#"run.csv:5: column "ticks": found "0", expected a whole number from 1 to 1000000000"#,
            ]
        );
    }
}
