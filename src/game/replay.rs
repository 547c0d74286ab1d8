//! A recorded run: the inputs, and what they came to. Its file is an inputs file whose comments say the rest, so that it can be
//! flown wherever inputs can.
//!
//! ```text
//! # level: 1
//! # tick_rate: 120
//! # score: 17342
//! # hash: 0123456789abcdef
//! ticks,thrust,reverse,left,right
//! 60,1,0,0,0
//! ```

use super::{BadFile, Game, GameError, Inputs, TICK_RATES};
use crate::level::Level;
use std::fmt;
use std::str::FromStr;
use std::sync::Arc;

/// A recorded run.
#[derive(Clone, Debug, PartialEq)]
pub struct Replay {
    /// The level's folder name.
    pub level: String,
    /// Ticks a second.
    pub tick_rate: f64,
    /// The score it came to.
    pub score: i64,
    /// The hash of the last state.
    pub hash: u64,
    /// The controls from the first tick on.
    pub inputs: Inputs,
}

/// How a run flown again differs from the recorded one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mismatch {
    /// Recorded and flown.
    pub score: (i64, i64),
    /// Recorded and flown.
    pub hash: (u64, u64),
}

impl fmt::Display for Mismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { score, hash } = self;
        write!(f, "recorded score {} and hash {:016x}, flown score {} and hash {:016x}", score.0, hash.0, score.1, hash.1)
    }
}

impl Replay {
    /// The record of a game that was played with these inputs.
    pub fn of(game: &Game, inputs: Inputs) -> Self {
        Self {
            level: game.level().name.clone(),
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
        let notes = Notes { file, text };
        let level = notes.find("level", "a level's name", &mut problems);
        let tick_rate = notes.find("tick_rate", "1 to 1000000 ticks a second", &mut problems);
        let score = notes.find("score", "points", &mut problems);
        let hash = notes.find("hash", "16 hex digits", &mut problems);
        let inputs = Inputs::parse(file, text).map_err(|BadFile(found)| problems.extend(found)).ok();
        match (level, tick_rate, score, hash, inputs) {
            (Some(level), Some(TickRate(tick_rate)), Some(score), Some(Hex(hash)), Some(inputs)) => {
                Ok(Self { level, tick_rate, score, hash, inputs })
            }
            _ => Err(BadFile(problems)),
        }
    }

    /// Flies the inputs again and compares where they lead.
    ///
    /// # Errors
    /// As [`Game::with_tick_rate`].
    pub fn verify(&self, level: Arc<Level>) -> Result<Result<(), Mismatch>, GameError> {
        let mut game = Game::with_tick_rate(level, self.tick_rate)?;
        self.inputs.clone().into_iter().for_each(|controls| game.step(controls));
        let (score, hash) = (game.result().score.total, game.hash());
        let same = (score, hash) == (self.score, self.hash);
        Ok(if same { Ok(()) } else { Err(Mismatch { score: (self.score, score), hash: (self.hash, hash) }) })
    }
}

impl fmt::Display for Replay {
    /// The text of the file, which [`Replay::parse`] reads.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { level, tick_rate, score, hash, inputs } = self;
        write!(f, "# level: {level}\n# tick_rate: {tick_rate}\n# score: {score}\n# hash: {hash:016x}\n{inputs}")
    }
}

/// The comments of a replay file.
struct Notes<'a> {
    file: &'a str,
    text: &'a str,
}

impl Notes<'_> {
    /// The value of the first line `# name: value`.
    fn find<T: FromStr>(&self, name: &str, expected: &str, problems: &mut Vec<String>) -> Option<T> {
        let note = |line: &str| {
            let (key, value) = line.trim_start_matches('\u{feff}').trim().strip_prefix('#')?.split_once(':')?;
            (key.trim() == name).then(|| value.trim().to_owned())
        };
        let found = (1..).zip(self.text.lines()).find_map(|(number, line)| Some((number, note(line)?)));
        let (line, found) = match found {
            None => (1, format!("no line \"# {name}: …\"")),
            Some((line, value)) => match value.parse() {
                Ok(value) => return Some(value),
                Err(_) => (line, format!("{value:?}")),
            },
        };
        problems.push(format!("{}:{line}: {name:?}: found {found}, expected {expected}", self.file));
        None
    }
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
        Replay { level: "up: and away".into(), tick_rate: 59.94, score: 17_342, hash: 0xabc, inputs }
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
