//! Common to all subcommands: help, version, the data folder, exit statuses.

use crate::support::program::{Data, Ran, resultant};

const COMMANDS: [&str; 9] = ["play", "check", "run", "chart", "tiles", "pi", "jumper", "new", "verify"];

#[test]
fn help_is_everywhere_and_a_success() {
    let all = Ran::new(resultant().arg("--help"));
    assert_eq!((all.status, all.err.as_str()), (0, ""));
    for command in COMMANDS {
        assert!(all.out.contains(&format!("\n  {command} ")), "{command} in {}", all.out);
        let ran = Ran::new(resultant().args([command, "--help"]));
        assert_eq!(ran.status, 0, "{command}");
        assert!(ran.out.contains("Usage: resultant") && ran.out.contains("--data"), "{command}: {}", ran.out);
    }
}

fn data() -> Data {
    let data = Data::new();
    data.level("way", "gravity,0\n", &[("player.csv", "1500,1500,100,500,3000\n"), ("objectives.csv", "PLAYER,10,10,20,20\n")]);
    data
}

#[test]
fn the_version_is_told() {
    let ran = Ran::new(resultant().arg("--version"));
    assert_eq!((ran.status, ran.out), (0, format!("resultant {}\n", env!("CARGO_PKG_VERSION"))));
}

#[test]
fn what_is_not_understood_is_refused() {
    for args in [&["fly"][..], &["--fast"], &["run"], &["run", "1", "--warp", "9"], &["verify"], &["--data"]] {
        let ran = Ran::new(resultant().args(args));
        assert_eq!((ran.status, ran.out.as_str()), (2, ""), "{args:?}");
        assert!(ran.err.contains("--help"), "{args:?}: {}", ran.err);
    }
}

#[test]
fn the_data_folder_must_be_there_and_the_working_directory_is_looked_in() {
    let data = data();
    assert_eq!(data.resultant(&["run", "way", "--seconds", "1"]).value("ticks"), "120");
    let ran = Ran::new(resultant().args(["--data", "/nowhere/at/all", "run", "way"]));
    assert_eq!((ran.status, ran.err.as_str()), (2, "--data /nowhere/at/all: there is no such folder\n"));
    let ran = Ran::new(resultant().args(["run", "way", "--seconds", "0"]).current_dir(data.path(".")));
    assert_eq!((ran.status, ran.value("ticks")), (0, "0"));
}

/// The program alone in a folder. The system's folders for a user's files are known by the environment on Linux alone.
#[cfg(target_os = "linux")]
struct Alone {
    folder: tempfile::TempDir,
}

#[cfg(target_os = "linux")]
impl Alone {
    fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        let (program, here) = (env!("CARGO_BIN_EXE_resultant"), folder.path().join("resultant"));
        // A link: a copy is still open for writing in what another test starts meanwhile, and then does not run ("Text file busy").
        std::fs::hard_link(program, &here).or_else(|_| std::fs::copy(program, &here).map(drop)).unwrap();
        Self { folder }
    }

    fn run(&self, home: Option<&std::path::Path>, args: &[&str]) -> Ran {
        let mut command = std::process::Command::new(self.folder.path().join("resultant"));
        for unset in ["HOME", "XDG_DATA_HOME", "XDG_CONFIG_HOME", "DISPLAY", "WAYLAND_DISPLAY"] {
            command.env_remove(unset);
        }
        Ran::new(command.args(args).current_dir(self.folder.path()).envs(home.map(|home| ("HOME", home))))
    }
}

#[cfg(target_os = "linux")]
#[test]
fn the_program_alone_has_its_levels_and_keeps_own_files_in_the_users_folder() {
    let (alone, home) = (Alone::new(), tempfile::tempdir().unwrap());
    let run = |args: &[&str]| alone.run(Some(home.path()), args);
    let flown = run(&["run", "1", "--seconds", "0"]);
    assert_eq!((flown.status, flown.value("ticks")), (0, "0"), "{}", flown.err);
    // A folder of another program is no game's.
    std::fs::create_dir(alone.folder.path().join("levels")).unwrap();
    assert_eq!(run(&["run", "1", "--seconds", "0"]).status, 0);
    let own = home.path().join(".local/share/resultant/levels");
    assert_eq!(run(&["new", "tower"]).out.trim(), own.join("tower").to_str().unwrap());
    assert_eq!(run(&["check", "tower", "1"]).status, 0, "own levels stand beside the shipped ones");
    assert_eq!(run(&["new", "1"]).status, 2, "a shipped level stays");
    std::fs::write(alone.folder.path().join("portable"), "").unwrap();
    let made = run(&["new", "mill"]);
    assert_eq!((made.status, made.out.trim()), (0, alone.folder.path().join("levels/mill").to_str().unwrap()), "{}", made.err);
    assert_eq!(run(&["check", "mill", "1"]).status, 0, "the shipped ones lie beneath own levels");
}

#[cfg(target_os = "linux")]
#[test]
fn without_a_home_the_levels_are_there_and_each_user_has_own_files() {
    let (alone, homes) = (Alone::new(), tempfile::tempdir().unwrap());
    // The system's list of users names a home then, where nothing is written.
    assert_eq!(alone.run(None, &["check", "1"]).status, 0);
    let [ann, bob] = ["ann", "bob"].map(|user| homes.path().join(user));
    assert_eq!(alone.run(Some(&ann), &["new", "tower"]).status, 0);
    assert_eq!(alone.run(Some(&bob), &["check", "tower"]).status, 2, "it is another user's");
    assert_eq!(alone.run(Some(&bob), &["new", "tower"]).status, 0);
    let nowhere = std::path::Path::new("/proc/nowhere");
    assert_eq!(alone.run(Some(nowhere), &["check", "1"]).status, 0);
    let made = alone.run(Some(nowhere), &["new", "tower"]);
    assert!(made.status == 2 && made.err.contains("cannot make /proc/nowhere/"), "{made:?}");
    if cfg!(feature = "window") {
        let said = alone.run(Some(nowhere), &[]).err;
        assert!(said.contains("nothing is kept until that folder can be made") && said.contains("no display"), "{said}");
    }
}

#[cfg(not(feature = "window"))]
#[test]
fn without_a_window_playing_says_so() {
    for args in [&[][..], &["play", "1"]] {
        let ran = Ran::new(resultant().args(args));
        assert_eq!(ran.status, 2, "{args:?}");
        assert!(ran.err.contains("no window"), "{args:?}: {}", ran.err);
    }
}

#[cfg(all(target_os = "linux", feature = "window"))]
#[test]
fn the_editor_asks_for_no_folder_that_it_does_not_need() {
    let data = data();
    for args in [&["edit", "way"][..], &["edit", "way", "--original"]] {
        let ran = data.resultant(args);
        assert!(ran.status == 2 && ran.err.contains("there is no display"), "{args:?}: {ran:?}");
    }
    assert!(data.resultant(&["edit", "none"]).err.contains("no level \"none\""));
    let names: Vec<_> = std::fs::read_dir(data.path("levels/way")).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    assert_eq!(names.len(), 3, "nothing is left behind: {names:?}");
}
