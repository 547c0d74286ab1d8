//! `resultant check` and `resultant new`.

use crate::support::program::{Ran, resultant};
use crate::support::shipped::copy_fixture;
use crate::{fixtures, good, lines};
use resultant::level;
use resultant::physics::World;
use std::path::Path;
use std::process::Command;

/// Runs the program: exit status, standard output and standard error.
pub fn ran(data: &Path, arguments: &[&str]) -> (i32, String, String) {
    texts(resultant().args(arguments).arg("--data").arg(data))
}

/// A project with these levels, as `new` makes them.
pub fn project(levels: &[&str]) -> tempfile::TempDir {
    let project = tempfile::tempdir().unwrap();
    levels.iter().for_each(|name| assert_eq!(ran(project.path(), &["new", name, "--show"]).0, 0));
    project
}

fn texts(command: &mut Command) -> (i32, String, String) {
    let Ran { status, out, err } = Ran::new(command);
    (status, out, err)
}

#[test]
fn check_prints_what_a_good_level_holds() {
    let (code, out, err) = ran(&fixtures(), &["check", "good_original"]);
    let lines: Vec<&str> = out.lines().collect();
    let won =
        "good_original: warning: player.csv: found a level that is won after 0.63 s without a key, expected something to do\n";
    assert_eq!((code, err.as_str(), lines.len()), (0, won, 3), "{out}");
    assert_eq!(lines[0], "good_original: ok");
    let counts =
        "1 solid, 1 object, 1 key object, 0 player objectives, 1 physics objective, 1 death box, 2 air streams, 0 liquids, 0 texts";
    assert_eq!(lines[1], format!("  contents: {counts}"));
    let plan = World::new(good("good_original").world_def()).unwrap().plan().parts().join("; ");
    assert_eq!(lines[2], format!("  physics: {plan}"));
}

#[test]
fn check_prints_problems_and_warnings_on_standard_error() {
    let (code, out, err) = ran(&fixtures(), &["check", "fuel_thrust_negative", "warn_unknown_constant"]);
    assert_eq!(code, 1);
    assert!(out.starts_with("warn_unknown_constant: ok\n"), "{out}");
    let err: Vec<&str> = err.lines().collect();
    assert_eq!(err[0], "fuel_thrust_negative: refused, 2 problems");
    assert_eq!(err[1], r#"player.csv:2: column "fuel": found "-1", expected a number of 0 or more fuel units"#);
    assert!(err[3].starts_with(r#"warn_unknown_constant: warning: constants.csv:4: column "name": "#), "{err:?}");
    assert_eq!(ran(&fixtures(), &["check", "warn_unknown_constant"]).0, 0);
}

#[test]
fn check_takes_folders_and_all_levels_and_refuses_what_is_not_there() {
    let folder = fixtures().join("levels/good_touching");
    let (code, out, _) = ran(&fixtures(), &["check", folder.to_str().unwrap()]);
    assert_eq!((code, out.lines().next()), (0, Some(format!("{}: ok", folder.display()).as_str())));
    let (code, out, err) = ran(&fixtures(), &["check"]);
    assert_eq!(code, 1);
    assert!(out.contains("good_original: ok\n") && err.contains("player_none: refused, 1 problem\n"));
    let (code, out, err) = ran(&fixtures(), &["check", "good_original", "nowhere"]);
    assert_eq!((code, out.as_str()), (2, ""), "nothing is checked: {err}");
    assert!(err.contains("nowhere"), "{err}");
    assert_eq!(ran(tempfile::tempdir().unwrap().path(), &["check"]).0, 2);
}

#[test]
fn new_makes_a_level_that_loads_and_touches_no_other() {
    let project = tempfile::tempdir().unwrap();
    let folder = |name: &str| project.path().join("levels").join(name);
    for (name, flags) in [("my-level", &[][..]), ("shown", &["--show"])] {
        let (code, out, err) = ran(project.path(), &[&["new", name], flags].concat());
        assert_eq!((code, out, err.as_str()), (0, format!("{}\n", folder(name).display()), ""));
        let loaded = level::load(&folder(name), project.path()).unwrap();
        assert_eq!((loaded.level.title.as_str(), lines(&loaded.warnings)), (name, String::new()));
        assert_eq!(loaded.level.switches.is_empty(), flags.is_empty(), "{name}");
    }
    let folder = folder("my-level");
    std::fs::write(folder.join("player.csv"), "mine").unwrap();
    assert_eq!(ran(project.path(), &["new", "my-level"]).0, 2);
    assert_eq!(std::fs::read_to_string(folder.join("player.csv")).unwrap(), "mine");
    for name in ["../evil", "a/b", "", ".", "jumper", "CON"] {
        let (code, out, err) = ran(project.path(), &["new", name]);
        assert_eq!((code, out.as_str()), (2, ""), "{name:?}: {err}");
    }
    assert_eq!(level::list(&project.path().join("levels")), ["my-level", "shown"]);
}

#[test]
fn new_refuses_a_name_that_differs_by_its_case_alone() {
    let project = project(&["tower"]);
    for name in ["Tower", "TOWER"] {
        let (code, out, err) = ran(project.path(), &["new", name]);
        assert_eq!((code, out.as_str()), (2, ""), "{err}");
        // Where the system has no other case of a name, the folder cannot be made.
        let there = if cfg!(windows) { "there is one of that name already" } else { "\"tower\" is there already" };
        assert!(err.contains(there), "{err}");
    }
    assert_eq!(level::list(&project.path().join("levels")), ["tower"]);
}

#[test]
fn check_of_a_place_is_of_the_folder_that_it_is() {
    let project = project(&["tower"]);
    let within = |place: &str, folder: &str| {
        let at = project.path().join(folder);
        texts(resultant().args(["check", place]).current_dir(at))
    };
    for (place, folder) in
        [(".", "levels/tower"), ("../tower", "levels/tower"), ("tower", "levels/tower"), ("..", "levels/tower/flights")]
    {
        std::fs::create_dir_all(project.path().join("levels/tower/flights")).unwrap();
        let (code, out, err) = within(place, folder);
        assert_eq!((code, err.as_str()), (0, ""), "{place} in {folder}");
        assert!(out.starts_with("tower: ok\n") || place == "../tower", "{place} in {folder}: {out}");
    }
    let (code, out, err) = within(".", "levels");
    assert_eq!((code, out.as_str()), (1, ""), "no level lies there: {err}");
}

/// `check` and `pack` fly the flights in a level's folder, and name a flight that fails with its second.
#[test]
fn flights_that_no_longer_hold_are_warned_about() {
    let project = tempfile::tempdir().unwrap();
    let folder = project.path().join("levels/1");
    copy_fixture("1", project.path());
    let (code, _, err) = ran(project.path(), &["check", "1"]);
    assert_eq!((code, err.as_str()), (0, ""));
    let edit = |file: &str, from: &str, to: &str| {
        let text = std::fs::read_to_string(folder.join(file)).unwrap();
        assert!(text.contains(from), "{text}");
        std::fs::write(folder.join(file), text.replace(from, to)).unwrap();
    };
    edit("constants.csv", "gold,5.5", "gold,4.5");
    let (code, _, err) = ran(project.path(), &["check", "1"]);
    assert_eq!((code, err.lines().count()), (0, 1), "{err}");
    let told = "1: warning: flights/gold.replay.csv: found a flight that does not earn what it is named by (within 4.5 s): ";
    assert!(err.starts_with(told) && err.contains("s too slow"), "{err}");
    edit("constants.csv", "gravity,10", "gravity,10.01");
    let packed = project.path().join("1.zip");
    for arguments in [&["check", "1"][..], &["pack", "1", "--out", packed.to_str().unwrap()]] {
        let (code, _, err) = ran(project.path(), arguments);
        assert_eq!(code, 0, "{err}");
        for flight in ["careful", "gold", "mark"] {
            let told = format!("warning: flights/{flight}.replay.csv: found a flight that no longer holds: departs in second 1: ");
            assert!(err.contains(&told), "{err}");
        }
    }
}

#[test]
fn a_flight_becomes_the_proof_of_a_medal_and_check_says_what_is_proven() {
    let project = tempfile::tempdir().unwrap();
    copy_fixture("1", project.path());
    let folder = project.path().join("levels/1");
    let read = |file: &str| std::fs::read_to_string(folder.join(file)).unwrap();
    let flight = project.path().join("mine.csv");
    std::fs::write(&flight, read("flights/careful.replay.csv").replace("# level: 1", "# level: another")).unwrap();
    std::fs::remove_dir_all(folder.join("flights")).unwrap();
    let proven = |replay: &str, prize: &str| ran(project.path(), &["prove", "1", replay, "--as", prize]);
    assert!(!ran(project.path(), &["check", "1"]).1.contains("proven"));
    let (code, out, err) = proven(flight.to_str().unwrap(), "gold");
    assert!(code == 0 && out.ends_with("gold.replay.csv\n"), "{err}");
    assert!(read("constants.csv").contains("gold,6.85\n") && read("constants.csv").starts_with("# Level 1: up"));
    assert!(read("flights/gold.replay.csv").contains("# level: 1\n"));
    let (_, out, err) = ran(project.path(), &["check", "1"]);
    let (gold, unproven) = ("  proven: gold (within 6.85 s)\n", "a medal (87 % fuel left) that no flight");
    assert!(out.contains(gold) && err.contains(unproven), "{out}{err}");
    let code = ran(project.path(), &["code", flight.to_str().unwrap()]).1;
    assert_eq!(proven(code.trim(), "careful").0, 0);
    assert_eq!(proven(code.trim(), "silver").0, 0);
    let (_, out, _) = ran(project.path(), &["check", "1"]);
    assert!(out.contains("  proven: careful (level complete), gold (within 6.85 s), silver (within 6.85 s)\n"), "{out}");
    let before = (read("constants.csv"), read("flights/gold.replay.csv"));
    let altered = project.path().join("altered.csv");
    std::fs::write(&altered, read("flights/gold.replay.csv").replace("# time: 6.85", "# time: 6.1")).unwrap();
    std::fs::write(folder.join("constants.csv"), before.0.replace("silver,6.85", "silver,6")).unwrap();
    let late = proven(flight.to_str().unwrap(), "gold");
    assert!(late.0 == 2 && late.2.contains("expected no longer than silver, which is 6 s"), "{}", late.2);
    std::fs::write(folder.join("constants.csv"), &before.0).unwrap();
    for (replay, prize, told) in [
        (altered.to_str().unwrap(), "gold", "a flight that no longer holds"),
        (flight.to_str().unwrap(), "mark", "a flight that does not earn what it is named by (87 % fuel left)"),
        (flight.to_str().unwrap(), "bronze", "invalid value 'bronze'"),
    ] {
        let (code, out, err) = proven(replay, prize);
        assert!(code == 2 && out.is_empty() && err.contains(told), "{told}: {err}");
    }
    assert_eq!((read("constants.csv"), read("flights/gold.replay.csv")), before);
    std::fs::write(project.path().join("levels/shipped.csv"), "folder\n1\n").unwrap();
    assert!(proven(flight.to_str().unwrap(), "gold").2.contains("found a level of the game"));
}

/// A level is played for a minute without a key.
#[test]
fn a_level_that_needs_no_pilot_or_leaves_none_a_chance_is_warned_about() {
    let project = project(&["tower"]);
    let folder = project.path().join("levels/tower");
    let checked = |files: &[(&str, &str)]| {
        std::fs::read_dir(&folder).unwrap().for_each(|file| std::fs::remove_file(file.unwrap().path()).unwrap());
        let room = [("constants.csv", "name,value\nwidth,1200\nheight,900\n"), ("world.csv", "x,y,width,height\n0,870,1200,30\n")];
        for (name, text) in room.iter().chain(files) {
            std::fs::write(folder.join(name), text).unwrap();
        }
        let (code, _, err) = ran(project.path(), &["check", "tower"]);
        assert_eq!(code, 0, "{err}");
        err
    };
    let player = ("player.csv", "x,y,mass,fuel,thrust\n100,500,100,500,2000\n");
    let pad = |row: &str| format!("kind,x,y,width,height\n{row}\n");
    let (far, below) = (pad("PLAYER,1100,100,60,10"), pad("PLAYER,70,860,60,10"));
    assert_eq!(checked(&[player, ("objectives.csv", &far)]), "");
    let won = checked(&[player, ("objectives.csv", &below)]);
    assert!(won.starts_with("tower: warning: player.csv: found a level that is won after 1."), "{won}");
    let red = ("obstacles.csv", "x,y,width,height\n70,860,60,10\n");
    let lost = checked(&[player, ("objectives.csv", &far), red]);
    assert!(lost.contains("found a level that is lost after 1.") && lost.contains("without a key: obstacle 1, expected"), "{lost}");
    // A cage of the ship's size, and a key that is its own way to its goal.
    let cage = "x,y,width,height\n0,870,1200,30\n40,464.5,34.5,71\n125.5,464.5,34.5,71\n74.5,440,51,34.5\n74.5,525.5,51,34.5\n";
    let key = "PHYS,1100,860,60,10\nOBJECT,600,850,box:40x40,75,120,220,190,0,0.5\n";
    let stuck = checked(&[player, ("world.csv", cage), ("objectives.csv", key)]);
    assert!(stuck.contains("player.csv: found a ship that no key moves, expected "), "{stuck}");
}

/// Windows makes no folder of a device's name.
#[cfg(not(windows))]
#[test]
fn a_folder_with_the_name_of_another_leaderboard_is_refused_and_a_device_warned_about() {
    let project = project(&["one", "two"]);
    let levels = project.path().join("levels");
    std::fs::rename(levels.join("one"), levels.join("Jumper")).unwrap();
    std::fs::rename(levels.join("two"), levels.join("aux")).unwrap();
    let (code, out, err) = ran(project.path(), &["check"]);
    assert_eq!(code, 1);
    assert!(out.starts_with("aux: ok\n"), "{out}");
    let jumper = "folder:1: column \"name\": found a level folder named \"Jumper\", expected another name, as \
                  scores/jumper.csv is a list of another kind\n";
    assert!(err.contains(&format!("Jumper: refused, 1 problem\n{jumper}")), "{err}");
    let aux = "aux: warning: folder:1: column \"name\": found a level folder named \"aux\", expected another name, as Windows takes \
               that one for a device\n";
    assert!(err.contains(aux), "{err}");
    let (code, out, err) = ran(project.path(), &["run", "Jumper"]);
    assert_eq!((code, out.as_str(), err.as_str()), (2, "", jumper));
}

#[cfg(unix)]
#[test]
fn check_leaves_the_terminal_as_it_is() {
    let project = project(&["good"]);
    let levels = project.path().join("levels");
    std::fs::rename(levels.join("good"), levels.join("\u{1b}[2Jgood\n1: ok\r\u{9b}31m")).unwrap();
    std::fs::create_dir(levels.join("\u{1b}]0;bad\u{7}")).unwrap();
    let (code, out, err) = ran(project.path(), &["check"]);
    assert_eq!(code, 1);
    assert!(out.starts_with("\\u{1b}[2Jgood\\n1: ok\\r\\u{9b}31m: ok\n"), "{out}");
    assert!(err.contains("\\u{1b}]0;bad\\u{7}: refused, "), "{err}");
    let (_, _, lost) = ran(project.path(), &["check", "\u{1b}[2Jlost"]);
    for text in [out, err, lost] {
        assert!(!text.chars().any(|c| c.is_control() && c != '\n'), "{text:?}");
    }
}
