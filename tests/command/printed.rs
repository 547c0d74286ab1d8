//! Every command that the documents, the sheets and the help print is one that works, wherever it is typed.

use crate::support::program::{Ran, resultant};
use crate::support::shipped::project;
use resultant::files::EXPERIMENTS;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

const DOCUMENTS: [&str; 4] = ["README.md", "CONTRIBUTING.md", "docs", "levels"];

fn texts(path: &Path, found: &mut Vec<String>) {
    if path.is_dir() {
        let mut below: Vec<PathBuf> = fs::read_dir(path).unwrap().map(|entry| entry.unwrap().path()).collect();
        below.sort();
        below.iter().for_each(|path| texts(path, found));
    } else if path.extension().is_some_and(|ending| ending == "md") {
        found.push(fs::read_to_string(path).unwrap());
    }
}

/// The lines of code that begin with the program's name: in a block, between backticks, or as code of a page.
fn commands() -> BTreeSet<String> {
    let mut all = Vec::new();
    DOCUMENTS.iter().for_each(|path| texts(&project().join(path), &mut all));
    all.extend(sheets::pages(project(), true).unwrap().into_iter().map(|(_, page)| page));
    let mut found = BTreeSet::new();
    for text in &all {
        let spans =
            text.split('`').flat_map(str::lines).chain(text.split("<code>").skip(1).filter_map(|rest| rest.split('<').next()));
        let lines = spans.map(|line| line.trim().trim_start_matches("$ "));
        found.extend(lines.filter(|line| line.starts_with("resultant ")).map(str::to_owned));
    }
    found
}

/// Whether it names what a reader puts in: `LEVEL`, `[--inputs FILE]`, `N`; or a level and a folder that a reader has; or an option alone.
fn has_places(command: &str) -> bool {
    let place = |word: &str| {
        let letters = word.trim_matches(|c: char| !c.is_alphanumeric());
        word.contains(['[', '…', '<']) || !letters.is_empty() && letters.chars().all(|c| c.is_ascii_uppercase() || c == '.')
    };
    let option = command.split(' ').skip(2).last().is_some_and(|word| word.starts_with("--"));
    option || command.split(' ').skip(1).any(|word| place(word) || ["my-level", "class", "."].contains(&word))
}

/// Where nothing of the game lies, with a home of its own.
fn elsewhere(folder: &Path) -> Command {
    let mut command = resultant();
    command.current_dir(folder).env("HOME", folder).env("XDG_DATA_HOME", folder.join("data")).env("XDG_CONFIG_HOME", folder);
    command
}

#[test]
fn every_printed_command_works_in_any_folder() {
    let (folder, own) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    let commands = commands();
    let plays = commands.iter().filter(|command| command.starts_with("resultant play experiments/")).count();
    assert_eq!(plays, fs::read_dir(project().join(EXPERIMENTS)).unwrap().count() - 1, "{commands:#?}");
    let mut ran = 0;
    for command in commands.iter().filter(|command| !has_places(command)) {
        let mut words: Vec<&str> = command.split(' ').skip(1).collect();
        // No window opens here: its level is looked at alone.
        if ["play", "edit"].contains(&words[0]) {
            words[0] = "check";
        }
        // Some by themselves are names alone, and the charts take minutes.
        if words.len() == 1 {
            words.push("--help");
        }
        let data = ["--data", own.path().to_str().unwrap()];
        let levels = words.iter().any(|word| word.parse::<u32>().is_ok() || word.starts_with("levels/"));
        for more in [&[][..], &data] {
            if levels && !more.is_empty() {
                continue;
            }
            let ended = Ran::new(elsewhere(folder.path()).args(&words).args(more));
            assert_eq!(ended.status, 0, "{command}, {more:?}: {ended:?}");
            ran += 1;
        }
    }
    assert!(ran >= 2 * plays + 2, "{ran}");
}

/// The subcommands that a document or the help names are there.
#[test]
fn every_printed_subcommand_is_one() {
    let help = Ran::new(resultant().arg("--help")).out;
    let known: BTreeSet<&str> = help
        .lines()
        .skip_while(|line| *line != "Commands:")
        .skip(1)
        .take_while(|line| !line.is_empty())
        .filter_map(|line| line.strip_prefix("  ")?.split(' ').next().filter(|word| !word.is_empty()))
        .collect();
    assert!(known.contains("play") && known.contains("stats"), "{help}");
    for command in commands() {
        let word = command.split([' ', '`']).nth(1).unwrap();
        let is_command = known.contains(word) || word.starts_with("--");
        assert!(is_command || !command.contains(['-', '/', '[']), "{command}");
    }
}

/// Any command takes an experiment by its printed name, without a checkout, also beside a data folder with a level or a list of its own.
#[test]
fn experiments_are_there_for_every_command() {
    let (folder, data) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    let run = |words: &[&str]| Ran::new(elsewhere(folder.path()).args(words));
    fs::create_dir_all(data.path().join(EXPERIMENTS).join("mine")).unwrap();
    fs::write(data.path().join(EXPERIMENTS).join("experiments.csv"), "folder,question,vary,answer\n").unwrap();
    let own = data.path().to_str().unwrap().to_owned();
    for more in [vec![], vec!["--data", own.as_str()]] {
        let with = |words: &[&str]| run(&[words, more.as_slice()].concat());
        let ended = with(&["run", "experiments/free-fall", "--seconds", "1"]);
        assert!(ended.status == 0 && ended.value("ticks") == "120", "{ended:?}");
        assert_eq!(with(&["check", "experiments/hooke"]).status, 0);
        let name = format!("lift-{}.zip", more.len());
        let packed = with(&["pack", "experiments/lift", "--out", &name]);
        assert!(packed.status == 0 && folder.path().join(&name).is_file(), "{packed:?}");
        let none = with(&["check", "experiments/none"]);
        assert!(none.status == 2 && none.err.contains("no level"), "{none:?}");
    }
    // A folder of the user's hides the built-in one of its name, whole.
    fs::create_dir_all(data.path().join(EXPERIMENTS).join("hooke")).unwrap();
    let hidden = run(&["check", "experiments/hooke", "--data", &own]);
    assert_eq!(hidden.status, 1, "{hidden:?}");
    let levels = run(&["check", "1", "--data", &own]);
    assert!(levels.status == 2 && levels.err.contains("no level \"1\""), "{levels:?}");
}
