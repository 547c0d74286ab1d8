//! `settings.csv`: a row a setting, `setting,value,player`. A row without a player holds for everyone. Reading reports each refused
//! row. Saving changes only the rows that it sets: comments, rows of other players and refused rows stay.

use super::item::{Item, Settings};
use super::{Action, Key};
use crate::files::{self, CsvColumn, CsvFile, CsvRow, CsvStruct, SETTINGS, SaveError, csv_line, found_instead, place};
use crate::words::tr;
use serde::Deserialize;
use std::path::PathBuf;

/// A row may lack the player.
const LEAST_CELLS: usize = 2;
const FILE: CsvFile<'_> = CsvFile { name: "settings.csv", columns: &["setting", "value", "player"], comments: true };

#[derive(Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(try_from = "String")]
enum SettingRow {
    Key(Action),
    Item(Item),
}

impl SettingRow {
    fn all() -> impl Iterator<Item = Self> {
        Action::ALL.into_iter().map(Self::Key).chain(Item::ALL.into_iter().map(Self::Item))
    }

    const fn setting(self) -> &'static str {
        match self {
            Self::Key(action) => action.setting(),
            Self::Item(item) => item.setting(),
        }
    }

    /// Errors: what is expected in place of the name.
    fn named(name: &str) -> Result<Self, String> {
        let expected = || {
            let names: Vec<&str> = Self::all().map(Self::setting).collect();
            tr!("one of {list}", list = names.join(", "))
        };
        Self::all().find(|target| target.setting().eq_ignore_ascii_case(name)).ok_or_else(expected)
    }

    /// The player of a setting's rows; empty for everyone.
    fn owner(self, player: &str) -> &str {
        match self {
            Self::Item(item) if item.is_of_play() => player,
            Self::Item(_) | Self::Key(_) => "",
        }
    }

    fn written(self, settings: &Settings) -> String {
        match self {
            Self::Item(item) => item.written(settings),
            Self::Key(action) => {
                let names: Vec<String> = settings.keys.of(action).into_iter().flatten().map(|key| key.to_string()).collect();
                names.join(" ")
            }
        }
    }

    fn read(self, text: &str, settings: &mut Settings) -> Result<(), String> {
        let action = match self {
            Self::Item(item) => return item.read(text, settings),
            Self::Key(action) => action,
        };
        let mut keys = [None; 2];
        for (i, name) in text.split_whitespace().enumerate() {
            let key = Key::named(name).filter(|key| !key.is_pad());
            let (Some(place), Some(key)) = (keys.get_mut(i), key) else {
                return Err(tr("the names of at most two keys with a space between them, such as Space W").into());
            };
            *place = Some(key);
        }
        settings.keys.set(action, keys);
        Ok(())
    }
}

impl TryFrom<String> for SettingRow {
    type Error = String;

    fn try_from(name: String) -> Result<Self, String> {
        Self::named(&name)
    }
}

#[derive(Deserialize)]
struct SettingCells {
    setting: SettingRow,
    value: String,
    player: String,
}

impl CsvStruct for SettingCells {
    const COLUMNS: &'static [CsvColumn] = &[
        CsvColumn { name: "setting", plain: |_, text| SettingRow::named(text).map(|_| text.into()) },
        CsvColumn { name: "value", plain: |_, text| Ok(text.into()) },
        CsvColumn { name: "player", plain: |_, text| Ok(text.into()) },
    ];
}

/// The settings for a player (`""` for the rows of everyone), and a line for each refused row.
pub fn read(text: &str, player: &str) -> (Settings, Vec<String>) {
    let (mut settings, mut problems) = (Settings::default(), Vec::new());
    // Rows of everyone first, wherever they stand.
    for own in [false, true] {
        for row in FILE.rows_of::<SettingCells>(text.as_bytes()).filter(|row| !row.is_header(LEAST_CELLS)) {
            let owner = row.get("player");
            if owner.is_empty() == own {
                continue;
            }
            match set(&row, &mut Settings::default()) {
                Err(problem) => problems.push((row.line, problem)),
                Ok(()) if !own || owner == player => drop(set(&row, &mut settings)),
                Ok(()) => {}
            }
        }
    }
    problems.sort_by_key(|(line, _)| *line);
    (settings, problems.into_iter().map(|(_, problem)| problem).collect())
}

fn set(row: &CsvRow<'_>, settings: &mut Settings) -> Result<(), String> {
    if let Some(fault) = row.fault() {
        return Err(row.row_problem(fault.words().0, FILE.header()));
    }
    if row.cells.len() < LEAST_CELLS {
        return Err(row.row_problem(format_args!("{:?}", row.joined()), FILE.header()));
    }
    let SettingCells { setting: target, value, .. } = row.read().map_err(|wrong| row.problems(wrong))?;
    let place = place(FILE.name, row.line, "value");
    let place = tr!("{place} of {setting}", place, setting = target.setting());
    target.read(&value, settings).map_err(|expected| found_instead(&place, format_args!("{value:?}"), expected))
}

fn merged(text: &str, player: &str, settings: &Settings) -> String {
    let stale = |row: &CsvRow<'_>| {
        let of_player = |cells: SettingCells| cells.player == cells.setting.owner(player);
        row.read().is_ok_and(of_player) && set(row, &mut Settings::default()).is_ok()
    };
    let text = FILE.with_commas::<SettingCells>(text.strip_prefix('\u{feff}').unwrap_or(text));
    let (mut lines, mut headed) = (String::new(), false);
    // No cell of this file spans lines.
    for line in text.lines() {
        let row = FILE.rows(line.as_bytes()).next();
        headed |= row.as_ref().is_some_and(|row| row.is_header(LEAST_CELLS));
        if !row.as_ref().is_some_and(stale) {
            lines.push_str(line);
            lines.push('\n');
        }
    }
    let header = if headed { String::new() } else { FILE.header() + "\n" };
    let fresh = SettingRow::all().map(|target| csv_line([target.setting(), &target.written(settings), target.owner(player)]));
    header + &lines + &fresh.collect::<String>()
}

/// With the settings that wait for a write, and whose they are.
#[derive(Debug)]
pub struct SettingsFile {
    path: PathBuf,
    unsaved: Vec<(String, Settings)>,
}

impl SettingsFile {
    /// The file need not exist yet.
    pub fn new(path: impl Into<PathBuf>) -> Self {
        Self { path: path.into(), unsaved: Vec::new() }
    }

    /// The settings for a player (`""` for the rows of everyone), and the file's faults, a line each. Without a file they are the defaults.
    pub fn load(&self, player: &str) -> (Settings, Vec<String>) {
        match files::text_if_there(&self.path, SETTINGS) {
            Ok(text) => read(&text.unwrap_or_default(), player),
            Err(error) => (Settings::default(), vec![format!("settings.csv: {error}")]),
        }
    }

    /// Writes the settings. The answer is the file's faults, or why it cannot be written: they wait then for the next call.
    pub fn set(&mut self, player: &str, settings: &Settings) -> Vec<String> {
        self.unsaved.retain(|(of, _)| of != player);
        self.unsaved.push((player.to_owned(), *settings));
        match self.close() {
            Ok(()) => self.load(player).1,
            Err(error) => vec![error.to_string()],
        }
    }

    /// Writes waiting settings, before others take their place or the program ends; after an error they still wait.
    pub fn close(&mut self) -> Result<(), SaveError> {
        while let Some((player, settings)) = self.unsaved.last() {
            self.save(player, settings)?;
            self.unsaved.pop();
        }
        Ok(())
    }

    pub fn waits(&self) -> bool {
        !self.unsaved.is_empty()
    }

    /// Replaces the file, whole; rows of other players that another game has written meanwhile stay.
    pub fn save(&self, player: &str, settings: &Settings) -> Result<(), SaveError> {
        files::update(&self.path, SETTINGS, |old| {
            let text = files::text(old).map_err(SaveError::file("read the file", &self.path))?;
            Ok((merged(&text, player, settings).into_bytes(), ()))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn what_is_saved_is_read_back_and_each_player_has_his_own_help() {
        let folder = tempfile::tempdir().unwrap();
        let file = SettingsFile::new(folder.path().join("settings.csv"));
        assert_eq!(file.load("ann"), (Settings::default(), vec![]));
        let mut settings = Settings { music: 0, shake: 50, ..Settings::default() };
        settings.assists.speed = 70;
        settings.keys.set(Action::Thrust, [None, Some(Key::GraveAccent)]);
        settings.keys.set(Action::Hitboxes, [None, None]);
        file.save("ann", &settings).unwrap();
        let mut read = settings;
        // Keys move up into the first free place.
        read.keys.set(Action::Thrust, [Some(Key::GraveAccent), None]);
        assert_eq!(file.load("ann"), (read, vec![]));
        read.assists.speed = 100;
        assert_eq!(file.load("bob"), (read, vec![]), "volume and keys are the machine's, help is the player's");
        file.save("bob", &Settings::default()).unwrap();
        assert_eq!(file.load("ann").0, Settings { assists: settings.assists, ..Settings::default() });
        let rows = fs::read_to_string(folder.path().join("settings.csv")).unwrap().lines().count();
        file.save("bob", &Settings::default()).unwrap();
        assert_eq!(fs::read_to_string(folder.path().join("settings.csv")).unwrap().lines().count(), rows, "nothing piles up");
    }

    #[test]
    fn what_cannot_be_read_is_told_by_line_and_kept() {
        let text = "setting,value,player\n# quiet please\nvolume,0\nloudness,3\nshake,lots\n\nkey_thrust,A B C,ann\nmusic\r\nflash,off,,\n";
        let (settings, problems) = read(text, "");
        assert_eq!((settings.master, settings.shake, settings.flash), (0, 100, false));
        assert_eq!(problems.len(), 4, "{problems:?}");
        assert!(problems[0].starts_with("settings.csv:4: column \"setting\": found \"loudness\", expected one of key_thrust, "));
        assert_eq!(
            problems[1],
            "settings.csv:5: column \"value\" of shake: found \"lots\", expected a whole number of percents from 0 to 100"
        );
        assert!(problems[2].starts_with("settings.csv:7: column \"value\" of key_thrust: found \"A B C\""));
        assert_eq!(problems[3], "settings.csv:8: found \"music\", expected setting,value,player");
        let merged = merged(text, "", &settings);
        for line in ["# quiet please", "loudness,3", "shake,lots", "key_thrust,A B C,ann", "music"] {
            assert!(merged.lines().any(|kept| kept.trim() == line), "{line} is kept");
        }
        assert_eq!(merged.matches("volume,").count(), 1);
        assert_eq!(read(&merged, "").0.master, 0);
    }

    #[test]
    fn what_cannot_be_saved_says_why_and_waits_for_the_next_try() {
        let folder = tempfile::tempdir().unwrap();
        let mut file = SettingsFile::new(folder.path().join("settings.csv"));
        let held = files::Lock::wait(&folder.path().join(".settings.csv.lock"), std::time::Duration::ZERO).unwrap();
        let problems = file.set("", &Settings { music: 1, ..Settings::default() });
        assert!(problems[0].ends_with("nothing was saved, try again"), "{problems:?}");
        assert!(file.waits());
        drop(held);
        file.close().unwrap();
        assert_eq!((file.load("").0.music, file.waits()), (1, false));
    }

    #[test]
    fn a_file_that_cannot_be_written_is_told_and_stays() {
        let folder = tempfile::tempdir().unwrap();
        let file = SettingsFile::new(folder.path().join("settings.csv"));
        fs::create_dir(folder.path().join("settings.csv")).unwrap();
        assert!(file.save("", &Settings::default()).unwrap_err().to_string().contains("settings.csv"));
        assert_eq!(file.load("").1.len(), 1);
    }

    #[test]
    fn settings_are_the_same_whatever_spreadsheet_saved_them_and_are_saved_as_one_file() {
        let plain = "setting,value,player\nvolume_music,35,\nflash,off,\nkey_thrust,Up W,\nshow_timer,off,ann\n";
        let (settings, _) = read(plain, "ann");
        assert_eq!(settings.music, 35);
        for saved in crate::spreadsheets::saved(plain, |_| false).into_iter().step_by(11) {
            let folder = tempfile::tempdir().unwrap();
            let file = SettingsFile::new(folder.path().join("settings.csv"));
            fs::write(&file.path, &saved.bytes).unwrap();
            assert_eq!(file.load("ann"), (settings, vec![]), "{}", saved.form);
            let mut changed = settings;
            changed.music = 80;
            file.save("bob", &changed).unwrap();
            let bob = file.load("bob");
            assert_eq!((bob.0.music, bob.1), (80, vec![]), "{}", saved.form);
            assert!(!file.load("ann").0.timer, "{}: the row of ann stays", saved.form);
        }
        let commented = "# mine; all\nflash;off;ann\nvolume_music;40;\n";
        let merged = merged(commented, "bob", &Settings::default());
        assert!(merged.contains("# mine; all\nflash,off,ann\n") && !merged.contains("volume_music;"), "{merged}");
    }
}
