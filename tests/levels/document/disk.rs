//! Opening, saving, and the copies that are kept when the program ends.

use super::{all_bytes, folders};
use crate::support::shipped::names;
use resultant::level;
use resultant::level::document::{KeptSide, Kind, LevelFolder, LevelSaveError, Place, SetCell, Table};
use resultant::physics::DVec2;
use std::fs;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

const BLOCK: Place = Place { min: DVec2::new(10.0, 10.0), size: DVec2::new(50.0, 20.0) };

fn level() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("constants.csv"), "# size\r\nwidth,1280\r\nheight,720\r\n").unwrap();
    fs::write(folder.path().join("player.csv"), "100,600,100,500,3000\n").unwrap();
    fs::write(folder.path().join("objectives.csv"), "PLAYER,900,600,80,10\n").unwrap();
    fs::write(folder.path().join("world.csv"), "0,680,1280,40").unwrap();
    folder
}

#[test]
fn what_is_opened_and_saved_is_the_same_to_the_byte() {
    for folder in folders() {
        let copy = tempfile::tempdir().unwrap();
        for entry in fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path()).filter(|path| path.is_file()) {
            fs::copy(&entry, copy.path().join(entry.file_name().unwrap())).unwrap();
        }
        let Ok(mut opened) = LevelFolder::open(copy.path(), Path::new(env!("CARGO_MANIFEST_DIR"))) else { continue };
        assert!(!opened.folder.is_unsaved(&opened.document) && opened.kept.is_none());
        // Something is done and undone, so that there is something to save or not.
        let _ = opened.document.put(Kind::Deadly, BLOCK);
        opened.document.undo();
        opened.folder.save(&opened.document).unwrap();
        assert_eq!(names(copy.path()), names(&folder).into_iter().filter(|name| folder.join(name).is_file()).collect::<Vec<_>>());
        for name in names(copy.path()) {
            assert_eq!(fs::read(copy.path().join(&name)).unwrap(), fs::read(folder.join(&name)).unwrap(), "{name}");
        }
        let problems = |loaded: Result<level::Loaded, Vec<level::Problem>>| {
            loaded.map(|loaded| loaded.level).map_err(|problems| problems.len())
        };
        let name = |mut level: level::Level| {
            level.name.clear();
            level
        };
        let from_disk = problems(level::load(copy.path(), Path::new(env!("CARGO_MANIFEST_DIR")))).map(name);
        assert_eq!(problems(opened.folder.check(&opened.document)).map(name), from_disk);
    }
}

#[test]
fn a_saved_level_is_on_disk_and_loads() {
    let folder = level();
    let mut opened = LevelFolder::open(folder.path(), folder.path()).unwrap();
    opened.document.put(Kind::Solid, BLOCK).unwrap();
    opened.document.put(Kind::Deadly, Place { min: DVec2::new(500.0, 600.0), ..BLOCK }).unwrap();
    assert!(opened.folder.is_unsaved(&opened.document));
    opened.folder.save(&opened.document).unwrap();
    assert!(!opened.folder.is_unsaved(&opened.document));
    assert_eq!(fs::read_to_string(folder.path().join("world.csv")).unwrap(), "0,680,1280,40\n10,10,50,20\n");
    assert_eq!(names(folder.path()), ["constants.csv", "objectives.csv", "obstacles.csv", "player.csv", "world.csv"]);
    let loaded = level::load(folder.path(), folder.path()).unwrap();
    assert_eq!((loaded.level.world.len(), loaded.level.obstacles.len()), (2, 1));
    // A file that was made here and is undone goes.
    opened.document.undo();
    opened.folder.save(&opened.document).unwrap();
    assert!(!folder.path().join("obstacles.csv").exists());
}

#[test]
fn what_another_program_wrote_is_taken_over_or_told_but_never_written_over() {
    let folder = level();
    let path = |name: &str| folder.path().join(name);
    let mut opened = LevelFolder::open(folder.path(), folder.path()).unwrap();
    fs::write(path("player.csv"), "200,600,100,500,3000\n").unwrap();
    assert_eq!(opened.folder.take_over(&mut opened.document), (true, vec![]));
    assert_eq!(opened.document.bytes(Table::Player).unwrap(), b"200,600,100,500,3000\n");
    assert!(!opened.folder.is_unsaved(&opened.document));
    opened.document.put(Kind::Solid, BLOCK).unwrap();
    fs::write(path("world.csv"), "0,600,1280,120\n").unwrap();
    assert_eq!(opened.folder.take_over(&mut opened.document), (false, vec![Table::World]));
    let Err(LevelSaveError::Changed(tables)) = opened.folder.save(&opened.document) else { panic!("saved") };
    assert_eq!((tables, fs::read_to_string(path("world.csv")).unwrap().as_str()), (vec![Table::World], "0,600,1280,120\n"));
    let (mine, theirs) = ("0,680,1280,40\n10,10,50,20\n", "0,600,1280,120\n");
    let mut other = (opened.document.clone(), opened.folder.clone());
    assert_eq!(other.1.settle(&mut other.0, KeptSide::Theirs).unwrap(), ["world.csv.mine-1"]);
    assert_eq!(other.0.bytes(Table::World).unwrap(), theirs.as_bytes());
    assert!(other.0.undo() && other.0.bytes(Table::World).unwrap() == mine.as_bytes());
    assert_eq!(fs::read_to_string(path("world.csv.mine-1")).unwrap(), mine);
    fs::write(path("world.csv.theirs-1"), "not to be touched").unwrap();
    assert_eq!(opened.folder.settle(&mut opened.document, KeptSide::Mine).unwrap(), ["world.csv.theirs-2"]);
    opened.folder.save(&opened.document).unwrap();
    assert_eq!(fs::read_to_string(path("world.csv")).unwrap(), mine);
    assert_eq!(fs::read_to_string(path("world.csv.theirs-2")).unwrap(), theirs);
    assert_eq!(fs::read_to_string(path("world.csv.theirs-1")).unwrap(), "not to be touched");
    assert!(opened.document.undo() && opened.document.bytes(Table::World).unwrap() == theirs.as_bytes());
    assert_eq!(level::load(folder.path(), folder.path()).unwrap().warnings, vec![], "the copies are no files of the level");
}

#[test]
fn a_level_has_one_editor_at_a_time() {
    let folder = level();
    let first = LevelFolder::open_to_edit(folder.path(), folder.path()).unwrap();
    let refused = LevelFolder::open_to_edit(folder.path(), folder.path()).unwrap_err();
    assert!(refused.starts_with("another editor has this level open: "), "{refused}");
    assert!(!cfg!(unix) || refused.contains(&format!("({})", std::process::id())), "{refused}");
    drop(first);
    assert_eq!(names(folder.path()), ["constants.csv", "objectives.csv", "player.csv", "world.csv"], "the lock is gone");
    LevelFolder::open_to_edit(folder.path(), folder.path()).unwrap();
}

#[cfg(unix)]
#[test]
fn what_cannot_even_be_kept_is_said_to_be_so() {
    let folder = level();
    let mut opened = LevelFolder::open(folder.path(), folder.path()).unwrap();
    opened.document.put(Kind::Solid, BLOCK).unwrap();
    fs::create_dir_all(folder.path().join(".autosave/taken")).unwrap();
    let error = opened.folder.save(&opened.document).unwrap_err();
    assert!(matches!(error, LevelSaveError::NotKept(_)), "{error:?}");
    assert!(error.to_string().starts_with("Neither saved nor kept"), "{error}");
}

#[test]
fn what_was_not_saved_is_offered_and_neither_the_loader_nor_a_list_sees_it() {
    let folder = level();
    let mut opened = LevelFolder::open(folder.path(), folder.path()).unwrap();
    opened.document.put(Kind::Solid, BLOCK).unwrap();
    opened.folder.keep(&opened.document).unwrap();
    let wanted = all_bytes(&opened.document);
    let loaded = level::load(folder.path(), folder.path()).unwrap();
    assert_eq!((loaded.level.world.len(), loaded.warnings), (1, vec![]));
    let mut again = LevelFolder::open(folder.path(), folder.path()).unwrap();
    again.document.restore(again.kept.unwrap());
    assert_eq!(all_bytes(&again.document), wanted);
    assert!(again.document.undo() && !again.folder.is_unsaved(&again.document), "to have it back can be undone");
    // A copy that is on disk already is not offered, nor a file that is none.
    again.folder.keep(&again.document).unwrap();
    assert!(!folder.path().join(".autosave").exists());
    for damaged in
        ["", "resultant autosave 1\n", "resultant autosave 1\nworld.csv 100\n1,2\nend\n", "resultant autosave 1\n../x 1\n1end\n"]
    {
        fs::write(folder.path().join(".autosave"), damaged).unwrap();
        assert!(LevelFolder::open(folder.path(), folder.path()).unwrap().kept.is_none(), "{damaged:?}");
    }
}

#[cfg(unix)]
#[test]
fn a_file_keeps_its_mode_and_a_link_stays_one() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let (folder, elsewhere) = (level(), tempfile::tempdir().unwrap());
    let (world, target) = (folder.path().join("world.csv"), elsewhere.path().join("mine.csv"));
    fs::rename(&world, &target).unwrap();
    fs::set_permissions(&target, fs::Permissions::from_mode(0o640)).unwrap();
    symlink(&target, &world).unwrap();
    let mut opened = LevelFolder::open(folder.path(), folder.path()).unwrap();
    opened.document.put(Kind::Solid, BLOCK).unwrap();
    opened.folder.save(&opened.document).unwrap();
    assert!(fs::symlink_metadata(&world).unwrap().is_symlink());
    assert_eq!(fs::metadata(&target).unwrap().permissions().mode() & 0o777, 0o640);
    assert_eq!(fs::read_to_string(&target).unwrap().lines().count(), 2);
    fs::set_permissions(&target, fs::Permissions::from_mode(0o440)).unwrap();
    opened.document.put(Kind::Solid, BLOCK).unwrap();
    assert!(matches!(opened.folder.save(&opened.document), Err(LevelSaveError::File(file, _)) if file == "world.csv"));
    assert!(LevelFolder::open(folder.path(), folder.path()).unwrap().kept.is_some());
}

/// A folder that came from a stranger: nothing outside it is written, and nothing that is no file is opened.
#[cfg(unix)]
#[test]
fn neither_a_link_nor_a_pipe_in_a_strangers_folder_does_harm() {
    let (folder, elsewhere) = (level(), tempfile::tempdir().unwrap());
    let (path, mine) = (|name: &str| folder.path().join(name), elsewhere.path().join("mine"));
    fs::write(&mine, "mine").unwrap();
    for link in [".autosave", ".resultant-aB3dE6gH.new"] {
        std::os::unix::fs::symlink(&mine, path(link)).unwrap();
    }
    let mut opened = LevelFolder::open(folder.path(), folder.path()).unwrap();
    assert!(opened.kept.is_none());
    opened.document.put(Kind::Solid, BLOCK).unwrap();
    opened.folder.keep(&opened.document).unwrap();
    assert!(!path(".autosave").is_symlink() && LevelFolder::open(folder.path(), folder.path()).unwrap().kept.is_some());
    opened.folder.save(&opened.document).unwrap();
    assert_eq!(fs::read_to_string(&mine).unwrap(), "mine");
    assert_eq!(fs::read_to_string(path("world.csv")).unwrap().lines().count(), 2);
    assert!(Command::new("mkfifo").arg(path(".autosave")).status().unwrap().success());
    let mut opened = LevelFolder::open(folder.path(), folder.path()).unwrap();
    assert!(opened.kept.is_none());
    opened.document.put(Kind::Solid, BLOCK).unwrap();
    opened.folder.save(&opened.document).unwrap();
    assert!(!path(".autosave").exists());
    std::os::unix::fs::symlink("/dev/zero", path(".autosave")).unwrap();
    assert!(LevelFolder::open(folder.path(), folder.path()).unwrap().kept.is_none());
}
const KILLED: &str = "document::disk::a_kill_leaves_each_file_old_or_new_and_the_edits_are_offered";
/// The editing process prints this, and the number that is kept.
const EDITED: &str = "edited ";

/// Edits two files so that both hold one number, keeps, and saves, without end.
fn edit_until_killed(folder: &Path) {
    let mut opened = LevelFolder::open(folder, folder).unwrap();
    for number in 0_u64.. {
        let set =
            |table: Table, column| SetCell { row: opened.document.rows(table).next().unwrap(), column, text: number.to_string() };
        let cells = [set(Table::World, "x"), set(Table::Player, "fuel")];
        opened.document.set(&cells, None).unwrap();
        opened.folder.keep(&opened.document).unwrap();
        if number % 2 == 1 {
            opened.folder.save(&opened.document).unwrap();
        }
        println!("{EDITED}{number}");
    }
}

#[test]
fn a_kill_leaves_each_file_old_or_new_and_the_edits_are_offered() {
    if let Some(folder) = std::env::var_os("LEVEL_TO_EDIT") {
        edit_until_killed(Path::new(&folder));
    }
    let folder = level();
    // Long enough that a write of half of it would be seen.
    let floor = "0,680,1280,40\n".to_owned() + &"# a comment that makes the file long\n".repeat(3000);
    fs::write(folder.path().join("world.csv"), &floor).unwrap();
    let mut offered = 0;
    for round in 0..25 {
        let mut editor = Command::new(std::env::current_exe().unwrap())
            .args(["--exact", KILLED, "--nocapture"])
            .env("LEVEL_TO_EDIT", folder.path())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        // At another moment each time, among edits and among saves, however late it begins.
        let said = BufReader::new(editor.stdout.take().unwrap()).lines().map_while(Result::ok);
        assert!(said.filter(|line| line.contains(EDITED)).nth(round % 5).is_some());
        std::thread::sleep(Duration::from_micros(round as u64 * 1_733 % 20_011));
        editor.kill().unwrap();
        editor.wait().unwrap();
        let mut opened = LevelFolder::open(folder.path(), folder.path()).unwrap();
        let numbers = |document: &resultant::level::document::Document| {
            let number = |table: Table, column| document.number(document.rows(table).next().unwrap(), column).unwrap();
            (number(Table::World, "x"), number(Table::Player, "fuel"))
        };
        let text = String::from_utf8(opened.document.bytes(Table::World).unwrap().to_vec()).unwrap();
        assert_eq!(text.split_once(',').unwrap().1, floor.split_once(',').unwrap().1, "the file is whole");
        let on_disk = numbers(&opened.document);
        match opened.kept.take() {
            Some(kept) => {
                offered += 1;
                opened.document.restore(kept);
                let (a, b) = numbers(&opened.document);
                assert!(a == b && a >= on_disk.0.max(if on_disk.1 == 500.0 { 0.0 } else { on_disk.1 }), "{a} {b} {on_disk:?}");
            }
            None => assert!(on_disk.0 == on_disk.1 || on_disk == (0.0, 500.0), "{on_disk:?}"),
        }
        fs::write(folder.path().join("world.csv"), &floor).unwrap();
        fs::write(folder.path().join("player.csv"), "100,600,100,500,3000\n").unwrap();
        fs::remove_file(folder.path().join(".autosave")).ok();
    }
    assert!(offered > 3, "{offered}");
}
