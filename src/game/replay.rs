//! A recorded run: inputs and their result. Its file is an inputs file whose comments hold the rest, so that it flies wherever inputs do.
//!
//! ```text
//! # program: resultant 1.0.0
//! # player: ann
//! # level: 1
//! # level_hash: 0123456789abcdef0123456789abcdef0123456789abcdef0123456789abcdef
//! # tick_rate: 120
//! # outcome: completed
//! # time: 5.25
//! # score: 17342
//! # hash: 0123456789abcdef
//! # hash 1: 123456789abcdef0
//! ticks,thrust,reverse,left,right
//! 60,1,0,0,0
//! ```
//!
//! `hash` is of the last state, `hash 1` of the state after the first second, and so on: they show in which second a flight
//! departs. A record of a saved score has `player`.

use super::clock::{Controls, TICK_RATES};
use super::fingerprint::{LevelHash, hex, level_hash};
use super::inputs::{BadFile, Inputs};
use super::{attempt::Game, event::Outcome};
use crate::{files::found_instead, words::tr};
use std::fmt;

pub const PROGRAM: &str = concat!("resultant ", env!("CARGO_PKG_VERSION"));

#[derive(Clone, Debug, PartialEq)]
pub struct Replay {
    pub program: String,
    /// The name under which the score was saved, if it was.
    pub player: Option<String>,
    /// The level's folder name.
    pub level: String,
    pub level_hash: LevelHash,
    /// Ticks a second.
    pub tick_rate: f64,
    pub outcome: Outcome,
    /// s.
    pub time: f64,
    pub score: i64,
    /// The hash of the last state.
    pub hash: u64,
    /// After each whole second.
    pub seconds: Vec<u64>,
    pub inputs: Inputs,
}

/// How a run flown again differs from its record; of each pair the recorded value goes first.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Mismatch {
    /// Another level, by its hash; the record was not flown.
    Level(LevelHash, LevelHash),
    /// The keys go on beyond the end: its tick, and the number of ticks of keys.
    RunsOn(u64, u64),
    /// The first second that departs, from 1, with the hashes after it. The rest was not flown.
    Second(usize, u64, u64),
    /// The same state, but another end than the written one; the time in thousandths of a second.
    Result { outcome: (Outcome, Outcome), time: (u64, u64) },
    /// The hash is of the last state.
    End { score: (i64, i64), hash: (u64, u64) },
}

impl fmt::Display for Mismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&match self {
            Self::Level(recorded, here) => tr!(
                "recorded in a level with the hash {recorded}…, the level of that name here has the hash {here}…",
                recorded = recorded.short(),
                here = here.short()
            ),
            Self::RunsOn(ended, ticks) => tr!("it ends after {ended} ticks, but its keys go on for {ticks}", ended, ticks),
            Self::Second(second, recorded, flown) => {
                let (recorded, flown) = (format_args!("{recorded:016x}"), format_args!("{flown:016x}"));
                tr!("departs in second {second}: recorded hash {recorded} after it, flown {flown}", second, recorded, flown)
            }
            Self::Result { outcome, time } => {
                let seconds = |thousandths: u64| thousandths as f64 / 1000.0;
                tr!(
                    "recorded {recorded} at {then} s, flown {flown} at {time} s",
                    recorded = outcome.0.shown(),
                    then = seconds(time.0),
                    flown = outcome.1.shown(),
                    time = seconds(time.1)
                )
            }
            Self::End { score, hash } => tr!(
                "recorded score {old} and hash {old_hash}, flown score {new} and hash {new_hash}",
                old = score.0,
                old_hash = format_args!("{:016x}", hash.0),
                new = score.1,
                new_hash = format_args!("{:016x}", hash.1)
            ),
        })
    }
}

#[derive(Clone, Debug, Default)]
pub struct Recorder {
    inputs: Inputs,
    seconds: Vec<u64>,
}

impl Recorder {
    pub fn note(&mut self, game: &Game, controls: Controls) {
        self.inputs.record(controls);
        if self.seconds.len() < MOST_SECONDS && ended_second(game).is_some() {
            self.seconds.push(game.hash());
        }
    }

    /// What was noted of the first `ticks` ticks, which end that many whole seconds.
    pub(super) fn until(&self, ticks: u64, seconds: usize) -> Self {
        let mut inputs = Inputs::default();
        self.inputs.after(0).take(ticks as usize).for_each(|controls| inputs.record(controls));
        Self { inputs, seconds: self.seconds.iter().take(seconds).copied().collect() }
    }

    pub const fn inputs(&self) -> &Inputs {
        &self.inputs
    }

    pub fn finish(self, game: &Game) -> Replay {
        let result = game.result();
        Replay {
            program: PROGRAM.to_owned(),
            player: None,
            level: game.level().name.clone(),
            level_hash: level_hash(game.level()),
            tick_rate: game.tick_rate(),
            outcome: result.outcome,
            time: result.time,
            score: result.score.total,
            hash: game.hash(),
            seconds: self.seconds,
            inputs: self.inputs,
        }
    }
}

/// The whole second that the last tick ends, from 1 on.
pub(super) fn ended_second(game: &Game) -> Option<usize> {
    let second = |ticks: u64| (ticks as f64 / game.tick_rate()) as usize;
    let now = second(game.ticks());
    (now > second(game.ticks().saturating_sub(1))).then_some(now)
}

/// Whole thousandths, which differ between any two ticks of the game and do not depend on the form of a number.
pub(super) fn thousandths(seconds: f64) -> u64 {
    (seconds * 1000.0).round() as u64
}

impl Replay {
    /// `file` is the file's name in messages. Errors: as [`Inputs::parse`]; a `# name: value` line that is missing or unreadable.
    pub fn parse(file: &str, text: &str) -> Result<Self, BadFile> {
        let mut notes = ReplayNotes::of(file, text);
        let program = notes.find("program", tr("a program's name and version"), |text| Some(text.to_owned()));
        let player = notes.find_any("player", tr("a player's name"), plain);
        let level = notes.find("level", tr("a level's name"), plain);
        let level_hash = notes.find("level_hash", tr(LevelHash::EXPECTED), |text| text.parse().ok());
        let within = |rate: &f64| TICK_RATES.contains(rate);
        let tick_rate = notes.find("tick_rate", tr("1 to 1000000 ticks a second"), |text| text.parse().ok().filter(within));
        let outcome = notes.find("outcome", tr("completed, failed or running"), Outcome::named);
        let passed = |time: &f64| time.is_finite() && *time >= 0.0;
        let time = notes.find("time", tr("seconds, 0 or more"), |text| text.parse().ok().filter(passed));
        let score = notes.find("score", tr("points"), |text| text.parse().ok());
        let hash = notes.find("hash", tr("16 hex digits"), hex);
        let seconds = notes.seconds();
        let mut problems = notes.problems;
        let inputs = Inputs::parse(file, text).map_err(|BadFile(found)| problems.extend(found)).ok();
        let read = || Some(((program?, level?, level_hash?, tick_rate?), (outcome?, time?, score?, hash?, inputs?)));
        let Some(((program, level, level_hash, tick_rate), (outcome, time, score, hash, inputs))) =
            read().filter(|_| problems.is_empty())
        else {
            return Err(BadFile(problems));
        };
        Ok(Self { program, player, level, level_hash, tick_rate, outcome, time, score, hash, seconds, inputs })
    }

    /// The mismatch of keys that go on beyond the record's own time, which needs no flight. That time begins with the first key.
    pub fn runs_on(&self) -> Option<Mismatch> {
        let (ended, ticks) = (self.time * self.tick_rate, self.inputs.ticks());
        let ended = ended.round() as u64;
        (ticks - self.inputs.idle().unwrap_or(0) > ended).then_some(Mismatch::RunsOn(ended, ticks))
    }
}

impl fmt::Display for Replay {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { program, player, level, level_hash, tick_rate, outcome, time, score, hash, seconds, inputs } = self;
        writeln!(f, "# program: {program}")?;
        if let Some(player) = player {
            writeln!(f, "# player: {}", written(player))?;
        }
        writeln!(f, "# level: {}\n# level_hash: {level_hash}\n# tick_rate: {tick_rate}", written(level))?;
        writeln!(f, "# outcome: {}\n# time: {time}\n# score: {score}\n# hash: {hash:016x}", outcome.name())?;
        for (second, hash) in (1..).zip(seconds) {
            writeln!(f, "# hash {second}: {hash:016x}")?;
        }
        inputs.fmt(f)
    }
}

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

    pub fn find<T>(&mut self, name: &str, expected: &str, read: impl FnOnce(&str) -> Option<T>) -> Option<T> {
        if !self.lines.iter().any(|(_, (key, _))| *key == name) {
            let found = tr!("no line {line}", line = format_args!("\"# {name}: …\""));
            self.problems.push(found_instead(&format!("{}:1: {name:?}", self.file), found, expected));
        }
        self.find_any(name, expected, read)
    }

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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::game::Controls;

    fn replay() -> Replay {
        let mut inputs = Inputs::default();
        inputs.record(Controls { thrust: true, ..Controls::default() });
        Replay {
            program: PROGRAM.into(),
            player: Some("ann".into()),
            level: "up: and away".into(),
            level_hash: LevelHash([0x1f; 32]),
            tick_rate: 59.94,
            outcome: Outcome::Completed,
            time: 5.25,
            score: 17_342,
            hash: 0xabc,
            seconds: vec![1, 2],
            inputs,
        }
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
            assert_eq!(text.lines().count(), 13, "{text}");
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
    fn no_second_is_left_out() {
        let problems = |text: String| Replay::parse("run.csv", &text).unwrap_err().0;
        let text = replay().to_string();
        assert_eq!(problems(text.replace("# hash 1:", "# hash 3:")), [r#"run.csv:10: found "hash 3", expected "hash 1""#]);
        assert_eq!(
            problems(text.replace("# hash 2: 000", "# hash 2: ")),
            [r#"run.csv:11: "hash 2": found "0000000000002", expected 16 hex digits"#]
        );
        assert_eq!(
            problems(text.replace("completed", "won").replace("5.25", "-5")),
            [
                r#"run.csv:6: "outcome": found "won", expected completed, failed or running"#,
                r#"run.csv:7: "time": found "-5", expected seconds, 0 or more"#,
            ]
        );
    }

    #[test]
    fn every_problem_is_told_with_its_place() {
        let text = "# score: lots\n# tick_rate: 0\n# level_hash: 12\n# hash: abc\nticks,thrust,reverse,left,right\n0,0,0,0,0\n";
        assert_eq!(
            Replay::parse("run.csv", text).unwrap_err().0,
            [
                r##"run.csv:1: "program": found no line "# program: …", expected a program's name and version"##,
                r##"run.csv:1: "level": found no line "# level: …", expected a level's name"##,
                r#"run.csv:3: "level_hash": found "12", expected 64 hex digits"#,
                r#"run.csv:2: "tick_rate": found "0", expected 1 to 1000000 ticks a second"#,
                r##"run.csv:1: "outcome": found no line "# outcome: …", expected completed, failed or running"##,
                r##"run.csv:1: "time": found no line "# time: …", expected seconds, 0 or more"##,
                r#"run.csv:1: "score": found "lots", expected points"#,
                r#"run.csv:4: "hash": found "abc", expected 16 hex digits"#,
                r#"run.csv:6: column "ticks": found "0", expected a whole number from 1 to 1000000000"#,
            ]
        );
    }
}
