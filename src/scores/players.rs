//! The levels that each player has done, and the text of the file that keeps them.
//!
//! ```text
//! player,level,time,medal,mark
//! ann,,,,
//! ann,1,5.483,gold,TRUE
//! ann,2,,bronze,
//! bob,,,,
//! ```
//!
//! A row without a level names a player; a row with one has the best time without help, if there is any, and the prizes. Prizes
//! stay, whatever the level asks for later. The player chosen last comes first. A row that cannot be read becomes a line of damage and spoils no other.

use std::{borrow::Cow, collections::BTreeMap, path::Path};

use super::name::{DamageReport, Name};
use crate::files::{CsvColumn, CsvFile, CsvRow, CsvStruct, csv_line, truth};
use crate::game::{Medal, Medals};
use crate::words::tr;
use serde::Deserialize;

const FILE: CsvFile<'_> = CsvFile { name: "", columns: &["player", "level", "time", "medal", "mark"], comments: false };

#[derive(Deserialize)]
struct DoneRow {
    player: Name,
    level: String,
    /// s.
    time: Option<f64>,
    medal: Option<Medal>,
    mark: bool,
}

impl CsvStruct for DoneRow {
    const COLUMNS: &'static [CsvColumn] = &[
        CsvColumn { name: "player", plain: |_, text| Name::cell(text) },
        CsvColumn { name: "level", plain: |_, text| Ok(unharmed(text).into()) },
        CsvColumn {
            name: "time",
            plain: |dialect, text| {
                let number = dialect.number(text);
                let plain = number.bytes().all(|byte| byte.is_ascii_digit() || byte == b'.');
                let good = number.is_empty() || plain && number.parse().is_ok_and(f64::is_finite);
                if good { Ok(number) } else { Err(tr("seconds such as 12.5, 0 or more, or nothing").into()) }
            },
        },
        CsvColumn {
            name: "medal",
            plain: |_, text| {
                let known = text.is_empty() || Medal::ALL.into_iter().any(|known| known.name().eq_ignore_ascii_case(text));
                if known { Ok(text.to_lowercase().into()) } else { Err(tr("bronze, silver, gold or nothing").into()) }
            },
        },
        CsvColumn {
            name: "mark",
            plain: |_, text| {
                let mark = if text.is_empty() { Some(false) } else { truth(text) };
                mark.map(|mark| mark.to_string().into()).ok_or_else(|| tr("TRUE, FALSE or nothing").into())
            },
        },
    ];
}

/// Thousandths of a second: any two ticks of the game differ in them.
const STEPS: f64 = 1000.0;

#[derive(Clone, Copy, Debug, PartialEq)]
struct Done {
    /// The best without help, s.
    time: Option<f64>,
    medal: Medal,
    mark: bool,
}

#[derive(Clone, Debug, PartialEq)]
pub struct PlayerRecord {
    name: Name,
    done: BTreeMap<String, Done>,
}

impl PlayerRecord {
    pub fn new(name: Name) -> Self {
        Self { name, done: BTreeMap::new() }
    }

    pub fn name(&self) -> &Name {
        &self.name
    }

    /// The best time without help, s.
    pub fn best(&self, level: &str) -> Option<f64> {
        self.done.get(level).and_then(|done| done.time)
    }

    pub fn medals(&self, level: &str) -> Medals {
        self.done.get(level).map_or_else(Medals::default, |done| Medals { medal: Some(done.medal), mark: done.mark })
    }

    pub fn done(&self) -> usize {
        self.done.len()
    }

    fn complete(&mut self, level: &str, new: Done) {
        let done = self.done.entry(level.to_owned()).or_insert(new);
        let time = done.time.into_iter().chain(new.time).reduce(f64::min);
        *done = Done { time, medal: done.medal.max(new.medal), mark: done.mark || new.mark };
    }
}

#[derive(Clone, Debug, PartialEq)]
pub enum Deed {
    Chosen(Name),
    /// Completed a level, in a time in s, from 0, finite, `None` for a flight with help, whose time does not count; with bronze at least.
    Done {
        player: Name,
        level: String,
        time: Option<f64>,
        medals: Medals,
    },
}

/// The player chosen last comes first.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Players {
    players: Vec<PlayerRecord>,
}

impl Players {
    pub fn all(&self) -> &[PlayerRecord] {
        &self.players
    }

    pub fn get(&self, name: &Name) -> Option<&PlayerRecord> {
        self.players.iter().find(|player| player.name == *name)
    }

    /// The player of a deed is known from then on.
    pub fn apply(&mut self, deed: &Deed) {
        match deed {
            Deed::Chosen(name) => {
                let index = self.index(name);
                self.players[..=index].rotate_right(1);
            }
            Deed::Done { player, level, time, medals } => {
                if time.is_none_or(|time| time.is_finite() && time >= 0.0) {
                    let time = time.map(|time| (time * STEPS).round() / STEPS);
                    let medal = medals.medal.unwrap_or(Medal::Bronze);
                    self.player(player).complete(level, Done { time, medal, mark: medals.mark });
                }
            }
        }
    }

    fn player(&mut self, name: &Name) -> &mut PlayerRecord {
        let index = self.index(name);
        &mut self.players[index]
    }

    /// A new player is the last.
    fn index(&mut self, name: &Name) -> usize {
        self.players.iter().position(|player| player.name == *name).unwrap_or_else(|| {
            self.players.push(PlayerRecord::new(name.clone()));
            self.players.len() - 1
        })
    }
}

/// The players, and a message for each unreadable place, which names `path`.
pub(super) fn read(path: &Path, bytes: &[u8]) -> (Players, Vec<String>) {
    let mut players = Players::default();
    let mut damage = DamageReport::of(path);
    for (index, row) in FILE.rows_of::<DoneRow>(bytes).enumerate() {
        match row.fault() {
            Some(fault) => damage.fault(row.line, fault),
            None if index == 0 && row.is_header(FILE.columns.len()) => {}
            None => take(&mut players, &row, &mut damage),
        }
    }
    (players, damage.into_all())
}

/// Spreadsheets leave empty cells at a row's end or cut them off.
fn take(players: &mut Players, row: &CsvRow<'_>, damage: &mut DamageReport<'_>) {
    let (line, used, most) = (row.line, row.used(), FILE.columns.len());
    if used > most {
        return damage.add(
            line,
            None,
            tr!("{count} cells", count = used),
            tr!("at most {most}: {header}", most, header = FILE.header()),
        );
    }
    let read = row.read::<DoneRow>();
    let is_named = !matches!(&read, Err(wrong) if wrong.iter().any(|cell| cell.column == "player"));
    if is_named && unharmed(row.get("level")).is_empty() {
        let beside = ["time", "medal", "mark"].into_iter().find(|column| !row.get(column).is_empty());
        if let Some(column) = beside {
            return damage.add(line, Some("level"), tr!("nothing beside a {column}", column), tr("a level's name"));
        }
    }
    let DoneRow { player: name, level, time, medal, mark } = match read {
        Ok(row) => row,
        // A row of damage is a line of the report.
        Err(wrong) => return damage.cells(line, wrong.into_iter().take(1)),
    };
    if level.is_empty() {
        players.player(&name);
        return;
    }
    if players.get(&name).is_some_and(|player| player.medals(&level).medal.is_some()) {
        let found = tr!("{player} in level {level} again", player = format_args!("\"{name}\""), level = format_args!("{level:?}"));
        damage.add(line, Some("level"), found, tr("one row a player and level: the best of both counts"));
    }
    players.player(&name).complete(&level, Done { time, medal: medal.unwrap_or(Medal::Bronze), mark });
}

/// With a header, LF, and a player's own row before the rows of levels.
pub(super) fn write(players: &Players) -> String {
    let mut text = csv_line(FILE.columns);
    for PlayerRecord { name, done } in &players.players {
        text += &csv_line([name.as_str(), "", "", "", ""]);
        for (level, Done { time, medal, mark }) in done {
            let time = time.map(|time| format!("{time:.3}")).unwrap_or_default();
            let (medal, mark) = (medal.name().to_ascii_lowercase(), if *mark { "TRUE" } else { "" });
            text += &csv_line([name.as_str(), &harmless(level), &time, &medal, mark]);
        }
    }
    text
}

/// Puts an apostrophe before a spreadsheet's formula, which makes it text.
pub(crate) fn harmless(text: &str) -> Cow<'_, str> {
    if text.starts_with(['=', '+', '-', '@', '\t', '\r', '\'']) { format!("'{text}").into() } else { text.into() }
}

pub(super) fn unharmed(cell: &str) -> &str {
    cell.strip_prefix('\'').unwrap_or(cell)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn name(text: &str) -> Name {
        Name::new(text).unwrap()
    }

    fn done(player: &str, level: &str, time: f64) -> Deed {
        Deed::Done { player: name(player), level: level.to_owned(), time: Some(time), medals: Medals::default() }
    }

    fn earned(player: &str, medal: Medal, mark: bool) -> Deed {
        Deed::Done { player: name(player), level: "fast".to_owned(), time: Some(9.0), medals: Medals { medal: Some(medal), mark } }
    }

    fn reading(text: &str) -> (String, Vec<String>) {
        let (players, damage) = read(Path::new("players.csv"), text.as_bytes());
        (write(&players), damage)
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
            Deed::Done { player: name("ann"), level: "helped".into(), time: None, medals: Medals::default() },
            earned("ann", Medal::Silver, true),
            earned("ann", Medal::Gold, false),
            Deed::Chosen(name("bob")),
        ] {
            players.apply(&deed);
        }
        let text = write(&players);
        assert_eq!(
            text,
            concat!(
                "player,level,time,medal,mark\nbob,,,,\nann,,,,\nann,''quoted',2.000,bronze,\nann,1,5.483,bronze,\nann,'=cmd,2.000,bronze,\n",
                "ann,\"a, \"\"b\"\"\",2.500,bronze,\nann,fast,9.000,gold,TRUE\nann,helped,,bronze,\n"
            )
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
        assert_eq!(
            (ann.best("1"), ann.medals("1").medal, ann.medals("2").medal, ann.done()),
            (Some(7.0), Some(Medal::Bronze), None, 1)
        );
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
        let (written, damage) = reading("\u{feff}player,level,time,medal,mark\r\n\r\n ann , 1 , 7 \r\nbob\r\n");
        assert_eq!((written.as_str(), damage.len()), ("player,level,time,medal,mark\nann,,,,\nann,1,7.000,bronze,\nbob,,,,\n", 0));
        let (written, damage) = reading("player,level,time,medal,mark,\r\nann,1,7,Gold,true,\r\nann,2,,,\r\n");
        assert_eq!(written, "player,level,time,medal,mark\nann,,,,\nann,1,7.000,gold,TRUE\nann,2,,bronze,\n");
        assert_eq!(damage.len(), 0, "{damage:?}");
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
            ("bob,,,gold", "players.csv:3: column \"level\": nothing beside a medal, expected a level's name"),
            ("bob,1,5,x", "players.csv:3: column \"medal\": \"x\", expected bronze, silver, gold or nothing"),
            ("bob,1,5,gold,x", "players.csv:3: column \"mark\": \"x\", expected TRUE, FALSE or nothing"),
            ("bob,1,5,gold,TRUE,x", "players.csv:3: 6 cells, expected at most 5: player,level,time,medal,mark"),
            (
                "ann,1,9",
                "players.csv:3: column \"level\": \"ann\" in level \"1\" again, expected one row a player and level: the best of both counts",
            ),
            ("\"bob,1,5", "players.csv:3: a quote that is never closed, expected a closing quote"),
        ] {
            let (written, damage) = reading(&format!("player,level,time,medal,mark\nann,1,7\n{line}\ncid,2,8\n"));
            assert_eq!(damage, [report], "{line}");
            assert!(written.contains("ann,1,7.000,bronze,\n") && written.contains("cid,2,8.000,bronze,\n"), "{written}");
        }
    }

    #[test]
    fn players_are_the_same_whatever_spreadsheet_saved_them() {
        let plain = "player,level,time,medal,mark\nann,,,,\nann,1,5.483,gold,TRUE\nann,2,,bronze,\nbob,\"a; b, c\",0.5,,\n";
        let (players, _) = read(Path::new("players.csv"), plain.as_bytes());
        for saved in crate::spreadsheets::saved(plain, |text| text.contains('.')) {
            assert_eq!(read(Path::new("players.csv"), &saved.bytes), (players.clone(), vec![]), "{}", saved.form);
        }
        let german = "player;level;time;medal;mark\r\nann;1;5,483;Gold;WAHR\r\n";
        let (players, damage) = read(Path::new("players.csv"), german.as_bytes());
        assert_eq!((players.all()[0].best("1"), players.all()[0].medals("1").mark, damage), (Some(5.483), true, vec![]));
    }
}
