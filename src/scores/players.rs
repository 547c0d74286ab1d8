//! What each player has done, and the text of the file that keeps it.
//!
//! ```text
//! player,level,time
//! ann,,
//! ann,1,5.483
//! ann,2,
//! bob,,
//! ```
//!
//! A row without a level says that there is such a player; a row with one says that they have completed it, and how fast at best, if ever
//! without help. Who was chosen last comes first. What cannot be a row becomes a [`Damage`] and spoils none of the others.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::io;
use std::path::Path;

use csv::StringRecord;
use serde::{Deserialize, Serialize};

use super::error::Report;
use super::{Damage, Name, records};

/// The columns of the file, which are its first row.
const HEADER: [&str; 3] = ["player", "level", "time"];
/// Thousandths of a second: more than any two ticks of the game need to be told apart.
const STEPS: f64 = 1000.0;

/// What a level has brought a player.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Medal {
    /// It is done.
    Bronze,
}

/// One player.
#[derive(Clone, Debug, PartialEq)]
pub struct Player {
    name: Name,
    /// The levels that are done, each with the best time without help, s.
    done: BTreeMap<String, Option<f64>>,
}

impl Player {
    /// A player who has done nothing yet.
    pub fn new(name: Name) -> Self {
        Self { name, done: BTreeMap::new() }
    }

    /// Who.
    pub fn name(&self) -> &Name {
        &self.name
    }

    /// The best time in a level without help, s; `None` where there is none.
    pub fn best(&self, level: &str) -> Option<f64> {
        self.done.get(level).copied().flatten()
    }

    /// What a level has brought; `None` until it is done.
    pub fn medal(&self, level: &str) -> Option<Medal> {
        self.done.contains_key(level).then_some(Medal::Bronze)
    }

    /// How many levels are done.
    pub fn done(&self) -> usize {
        self.done.len()
    }

    fn complete(&mut self, level: &str, time: Option<f64>) {
        let best = self.done.entry(level.to_owned()).or_insert(time);
        *best = match (*best, time) {
            (Some(best), Some(time)) => Some(best.min(time)),
            (best, time) => best.or(time),
        };
    }
}

/// What a player did.
#[derive(Clone, Debug, PartialEq)]
pub enum Deed {
    /// Was chosen, or made.
    Chosen(Name),
    /// Completed a level.
    Done {
        /// Who.
        player: Name,
        /// The level's folder name.
        level: String,
        /// s, 0 or more and finite; `None` for a flight with help, whose time does not count.
        time: Option<f64>,
    },
}

/// All players, whoever was chosen last first.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Players {
    players: Vec<Player>,
}

impl Players {
    /// All of them.
    pub fn all(&self) -> &[Player] {
        &self.players
    }

    /// One of them.
    pub fn get(&self, name: &Name) -> Option<&Player> {
        self.players.iter().find(|player| player.name == *name)
    }

    /// Takes note of a deed; whoever did it is known from then on.
    pub fn apply(&mut self, deed: &Deed) {
        match deed {
            Deed::Chosen(name) => {
                let index = self.index(name);
                self.players[..=index].rotate_right(1);
            }
            Deed::Done { player, level, time } => {
                if time.is_none_or(|time| time.is_finite() && time >= 0.0) {
                    self.player(player).complete(level, time.map(|time| (time * STEPS).round() / STEPS));
                }
            }
        }
    }

    fn player(&mut self, name: &Name) -> &mut Player {
        let index = self.index(name);
        &mut self.players[index]
    }

    /// Where a player is; one who is new is the last.
    fn index(&mut self, name: &Name) -> usize {
        self.players.iter().position(|player| player.name == *name).unwrap_or_else(|| {
            self.players.push(Player::new(name.clone()));
            self.players.len() - 1
        })
    }
}

/// A row of the file, as it stands there.
#[derive(Serialize, Deserialize)]
struct Cells<'a> {
    player: &'a str,
    #[serde(borrow)]
    level: Cow<'a, str>,
    #[serde(borrow)]
    time: Cow<'a, str>,
}

/// The players that stand in `bytes`, and every place that could not be read. `path` is only named in those.
pub(super) fn read(path: &Path, bytes: &[u8]) -> (Players, Vec<Damage>) {
    let mut players = Players::default();
    let mut damage = Report::of(path);
    for (index, (line, record)) in records::read(bytes).into_iter().enumerate() {
        match record {
            Ok(record) if index == 0 && record.iter().map(str::trim).eq(HEADER) => {}
            Ok(record) => row(&mut players, line, record, &mut damage),
            Err(fault) => damage.fault(line, fault),
        }
    }
    (players, damage.into_all())
}

/// Takes in one row. Spreadsheets leave empty cells at its end or cut them off.
fn row(players: &mut Players, line: usize, mut record: StringRecord, damage: &mut Report) {
    let used = record.iter().zip(1..).filter(|(cell, _)| !cell.trim().is_empty()).last().map_or(0, |(_, number)| number);
    if used > HEADER.len() {
        return damage.add(line, None, format!("{used} cells"), format!("expected at most {}: {}", HEADER.len(), HEADER.join(",")));
    }
    record.truncate(used);
    (used..HEADER.len()).for_each(|_| record.push_field(""));
    let Ok(Cells { player, level, time }) = record.deserialize(None) else { return };
    let Some(name) = damage.name(line, HEADER[0], player.trim()) else { return };
    let (level, time) = (unharmed(level.trim()), time.trim());
    let seconds = seconds(time);
    if level.is_empty() {
        if !time.is_empty() {
            damage.add(line, Some("level"), "nothing beside a time", "expected a level's name");
        } else {
            players.player(&name);
        }
        return;
    }
    if seconds.is_none() && !time.is_empty() {
        return damage.add(line, Some("time"), format!("{time:?}"), "expected seconds such as 12.5, 0 or more, or nothing");
    }
    if players.get(&name).is_some_and(|player| player.medal(level).is_some()) {
        let found = format!("\"{name}\" in level {level:?} again");
        damage.add(line, Some("level"), found, "expected one row a player and level: the shorter time counts");
    }
    players.player(&name).complete(level, seconds);
}

/// A time cell: a plain number of seconds; `None` for anything else.
fn seconds(cell: &str) -> Option<f64> {
    let plain = cell.bytes().all(|byte| byte.is_ascii_digit() || byte == b'.');
    cell.parse().ok().filter(|seconds: &f64| plain && seconds.is_finite())
}

/// The file's bytes: always with a header, a player's own row before those of their levels, lines ending in LF.
///
/// # Errors
/// Those of the CSV writer, none of which writing to memory is known to cause.
pub(super) fn write(players: &Players) -> io::Result<Vec<u8>> {
    let mut writer = csv::WriterBuilder::new().has_headers(false).from_writer(Vec::new());
    writer.write_record(HEADER)?;
    for Player { name, done } in &players.players {
        let player = name.as_str();
        writer.serialize(Cells { player, level: "".into(), time: "".into() })?;
        for (level, time) in done {
            let time = time.map(|time| format!("{time:.3}")).unwrap_or_default();
            writer.serialize(Cells { player, level: harmless(level), time: time.into() })?;
        }
    }
    writer.into_inner().map_err(|error| error.into_error())
}

/// What a spreadsheet would take for a formula, behind an apostrophe that makes it text; anything else as it is.
pub(super) fn harmless(text: &str) -> Cow<'_, str> {
    if text.starts_with(['=', '+', '-', '@', '\t', '\r', '\'']) { format!("'{text}").into() } else { text.into() }
}

/// What [`harmless`] was made of.
fn unharmed(cell: &str) -> &str {
    cell.strip_prefix('\'').unwrap_or(cell)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn name(text: &str) -> Name {
        Name::new(text).unwrap()
    }

    fn done(player: &str, level: &str, time: f64) -> Deed {
        Deed::Done { player: name(player), level: level.to_owned(), time: Some(time) }
    }

    fn reading(text: &str) -> (String, Vec<String>) {
        let (players, damage) = read(Path::new("players.csv"), text.as_bytes());
        let written = String::from_utf8(write(&players).unwrap()).unwrap();
        (written, damage.iter().map(ToString::to_string).collect())
    }

    #[test]
    fn what_is_written_reads_back() {
        let mut players = Players::default();
        for deed in [
            Deed::Chosen(name("ann")),
            done("ann", "1", 5.483_333),
            done("ann", "=cmd", 2.0),
            done("ann", "'quoted'", 2.0),
            done("ann", "a, \"b\"", 2.5),
            Deed::Done { player: name("ann"), level: "helped".into(), time: None },
            Deed::Chosen(name("bob")),
        ] {
            players.apply(&deed);
        }
        let text = String::from_utf8(write(&players).unwrap()).unwrap();
        assert_eq!(
            text,
            "player,level,time\nbob,,\nann,,\nann,''quoted',2.000\nann,1,5.483\nann,'=cmd,2.000\nann,\"a, \"\"b\"\"\",2.500\nann,helped,\n"
        );
        assert_eq!(read(Path::new("players.csv"), text.as_bytes()), (players, vec![]));
    }

    #[test]
    fn the_shorter_time_counts_and_a_deed_is_its_doers_alone() {
        let mut players = Players::default();
        for deed in [done("ann", "1", 9.0), done("ann", "1", 7.0), done("ann", "1", 8.0), done("bob", "2", f64::NAN)] {
            players.apply(&deed);
        }
        let ann = players.get(&name("ann")).unwrap();
        assert_eq!((ann.best("1"), ann.medal("1"), ann.medal("2"), ann.done()), (Some(7.0), Some(Medal::Bronze), None, 1));
        assert!(players.get(&name("bob")).is_none(), "nothing that is no time is written down");
    }

    #[test]
    fn who_was_chosen_last_comes_first() {
        let mut players = Players::default();
        for chosen in ["ann", "bob", "cid", "ann"] {
            players.apply(&Deed::Chosen(name(chosen)));
        }
        assert_eq!(players.all().iter().map(|player| player.name().as_str()).collect::<Vec<_>>(), ["ann", "cid", "bob"]);
    }

    #[test]
    fn what_editors_do_to_a_file_is_no_damage() {
        let (written, damage) = reading("\u{feff}player,level,time\r\n\r\n ann , 1 , 7 \r\nbob\r\n");
        assert_eq!((written.as_str(), damage.len()), ("player,level,time\nann,,\nann,1,7.000\nbob,,\n", 0));
    }

    #[test]
    fn a_damaged_row_is_reported_with_its_place_and_spoils_no_other() {
        for (line, report) in [
            (
                "1bob,1,5",
                "players.csv:3: column \"player\": \"1bob\", expected a user name: The name must start with a letter (a–z, A–Z), not with “1”.",
            ),
            ("bob,1,fast", "players.csv:3: column \"time\": \"fast\", expected seconds such as 12.5, 0 or more, or nothing"),
            ("bob,1,-5", "players.csv:3: column \"time\": \"-5\", expected seconds such as 12.5, 0 or more, or nothing"),
            ("bob,1,inf", "players.csv:3: column \"time\": \"inf\", expected seconds such as 12.5, 0 or more, or nothing"),
            ("bob,,5", "players.csv:3: column \"level\": nothing beside a time, expected a level's name"),
            ("bob,1,5,x", "players.csv:3: 4 cells, expected at most 3: player,level,time"),
            (
                "ann,1,9",
                "players.csv:3: column \"level\": \"ann\" in level \"1\" again, expected one row a player and level: the shorter time counts",
            ),
            ("\"bob,1,5", "players.csv:3: a quotation mark that is never closed, expected a second one at the end of its cell"),
        ] {
            let (written, damage) = reading(&format!("player,level,time\nann,1,7\n{line}\ncid,2,8\n"));
            assert_eq!(damage, [report], "{line}");
            assert!(written.contains("ann,1,7.000\n") && written.contains("cid,2,8.000\n"), "{written}");
        }
    }
}
