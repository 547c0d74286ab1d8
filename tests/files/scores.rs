//! Scores on disk: the folder after a save, also when files are damaged, writes fail, or many processes save at once.

use super::fixture::{Fixture, Worker, confirmed, in_a_worker, make_read_only, name, until_its_turn};
use resultant::files::{self, SaveError};
use resultant::scores::{Placement, ScoresError};
use std::collections::BTreeSet;
use std::fs::{self, File};
use std::time::Duration;
#[cfg(unix)]
use std::{path::Path, process::Command};

fn with(text: &str) -> Fixture {
    Fixture::with("1.csv", text)
}

#[test]
fn the_first_save_makes_the_folder_and_the_file() {
    let fixture = Fixture::new();
    assert!(fixture.scores().load("1").unwrap().board.rows().is_empty(), "a missing file is an empty board");
    assert!(!fixture.folder().exists(), "looking changes nothing");
    let saved = fixture.scores().save("1", &name("ann"), 10_000).unwrap();
    assert_eq!(saved.placement, Placement::New { rank: 1 });
    assert_eq!(fixture.text("1.csv"), "name,score\nann,10000\n");
    assert_eq!(fixture.names(), [".1.csv.lock", "1.csv"]);
    assert_eq!(fixture.scores().load("1").unwrap().board, saved.board);
}

#[test]
fn each_level_has_a_file_of_its_own() {
    let fixture = Fixture::new();
    for level in ["1", "10", "jumper", "Über den Wolken", "a.csv", "..."] {
        fixture.scores().save(level, &name("ann"), 5).unwrap();
        assert!(fixture.file(&format!("{level}.csv")).is_file());
    }
}

#[test]
fn a_level_name_never_leaves_the_folder() {
    let fixture = Fixture::new();
    for level in ["", ".", "..", "../1", "a/b", "/1", "..\\1", "C:1", "a\0b", "a\nb"] {
        assert!(matches!(fixture.scores().save(level, &name("ann"), 5), Err(ScoresError::LevelName(_))), "{level:?}");
        assert!(matches!(fixture.scores().load(level), Err(ScoresError::LevelName(_))), "{level:?}");
    }
    assert_eq!(fs::read_dir(fixture.root.path()).unwrap().count(), 0);
}

#[test]
fn a_damaged_file_is_reported_and_stays_until_it_is_mended() {
    let damaged = "name,score\nann,30\n=HYPERLINK(1),99999\nbob,2O\ncid,10\n";
    let fixture = with(damaged);
    let path = fixture.file("1.csv");
    let reports: Vec<String> = fixture.scores().load("1").unwrap().damage.iter().map(ToString::to_string).collect();
    assert_eq!(reports.iter().map(|told| told.contains("1.csv:3: ")).collect::<Vec<_>>(), [true, false], "{reports:?}");
    assert_eq!((fixture.text("1.csv").as_str(), fixture.names()), (damaged, vec!["1.csv".to_owned()]), "looking changes nothing");
    let error = fixture.scores().save("1", &name("dan"), 20).unwrap_err();
    let words = format!("Nothing was saved; mend the file and try again: {} (and 1 more).", reports[0]);
    assert_eq!(error.to_string(), words);
    assert_eq!(fixture.text("1.csv"), damaged, "neither does a save");
    fs::write(&path, damaged.replace("=HYPERLINK(1)", "dan").replace("2O", "20")).unwrap();
    fixture.scores().save("1", &name("eve"), 5).unwrap();
    assert_eq!(fixture.text("1.csv"), "name,score\ndan,99999\nann,30\nbob,20\ncid,10\neve,5\n");
    let bytes = b"ann,30\nb\xFF\xFEb,20\n\0\0\0";
    fs::write(&path, bytes).unwrap();
    assert!(matches!(fixture.scores().save("1", &name("dan"), 40), Err(ScoresError::Damaged(_))));
    assert_eq!(fs::read(&path).unwrap(), bytes);
}

#[test]
fn a_read_only_file_is_left_alone() {
    let text = "name,score\nann,30\n";
    let fixture = with(text);
    let path = fixture.file("1.csv");
    make_read_only(&path);
    let error = fixture.scores().save("1", &name("bob"), 40).unwrap_err();
    assert_eq!(error.to_string(), format!("{}: the file is read-only, expected one that may be replaced", path.display()));
    assert_eq!(fixture.text("1.csv"), text);
    assert_eq!(fixture.names(), [".1.csv.lock", "1.csv"]);
}

#[test]
fn whatever_the_system_refuses_is_an_error_with_its_place_and_leaves_the_old_file_whole() {
    let text = "name,score\nann,30\n";
    let fixture = with(text);
    fs::create_dir(fixture.file(".1.csv.lock")).unwrap();
    let error = fixture.scores().save("1", &name("bob"), 40).unwrap_err();
    let place = format!("{}: cannot lock the file: found a folder", fixture.file(".1.csv.lock").display());
    assert!(error.to_string().starts_with(&place), "{error}");
    assert_eq!(fixture.text("1.csv"), text);
    let fixture = Fixture::new();
    fs::create_dir_all(fixture.file("1.csv")).unwrap();
    let error = fixture.scores().save("1", &name("bob"), 40).unwrap_err();
    assert!(error.to_string().contains("1.csv: cannot read the file: "), "{error}");
    let fixture = Fixture::new();
    fs::write(fixture.folder(), "a file where the folder should be").unwrap();
    let error = fixture.scores().save("1", &name("bob"), 40).unwrap_err();
    assert!(error.to_string().contains("scores: cannot create the folder: "), "{error}");
}

/// Under a limit of no bytes at all a write fails as on a full disk, and the signal that comes with it is ignored.
#[cfg(unix)]
#[test]
fn a_full_disk_loses_nothing_and_leaves_no_litter() {
    let text = "name,score\nann,30\n";
    let fixture = with(text);
    let saved = Worker::through("trap '' XFSZ; ulimit -f 0; exec \"$@\"", WORKER, &fixture.folder()).output();
    let said = String::from_utf8_lossy(&[saved.stdout, saved.stderr].concat()).into_owned();
    assert!(!saved.status.success() && said.contains("write the file"), "{said}");
    assert_eq!(fixture.text("1.csv"), text);
    assert_eq!(fixture.names(), [".1.csv.lock", "1.csv"]);
    fixture.scores().save("1", &name("bob"), 40).unwrap();
    assert_eq!(fixture.text("1.csv"), "name,score\nbob,40\nann,30\n");
}

/// Names of staged content, and the lock's.
#[cfg(unix)]
#[test]
fn no_link_that_somebody_laid_is_written_through() {
    let fixture = with("name,score\nann,30\n");
    let mine = fixture.root.path().join("mine");
    fs::write(&mine, "mine").unwrap();
    std::os::unix::fs::symlink(&mine, fixture.file(".resultant-aB3dE6gH.new")).unwrap();
    fixture.scores().save("1", &name("bob"), 40).unwrap();
    fixture.scores().record(&[resultant::scores::Deed::Chosen(name("bob"))]).unwrap();
    std::os::unix::fs::symlink(&mine, fixture.file(".2.csv.lock")).unwrap();
    let error = fixture.scores().save("2", &name("bob"), 40).unwrap_err();
    assert!(error.to_string().ends_with(".2.csv.lock: cannot lock the file: found a link, expected a regular file"), "{error}");
    assert_eq!(fs::read_to_string(mine).unwrap(), "mine");
    assert_eq!(fixture.text("1.csv"), "name,score\nbob,40\nann,30\n");
}

/// With any umask of the first user. Modes stand for a second user, who cannot be had here.
#[cfg(unix)]
#[test]
fn a_folder_that_is_shared_has_locks_that_are_shared() {
    use std::os::unix::fs::PermissionsExt;
    let mode = |path: &Path| fs::metadata(path).unwrap().permissions().mode() & 0o777;
    for (folder, lock) in [(0o777, 0o666), (0o775, 0o660), (0o770, 0o660), (0o755, 0o600)] {
        let fixture = with("name,score\nann,30\n");
        fs::set_permissions(fixture.folder(), fs::Permissions::from_mode(folder)).unwrap();
        fixture.scores().save("1", &name("bob"), 40).unwrap();
        assert_eq!(mode(&fixture.file(".1.csv.lock")), lock, "in a folder of mode {folder:o}");
    }
    // The first board by a user who shares nothing by default, in a shared folder.
    let fixture = with("");
    fs::remove_file(fixture.file("1.csv")).unwrap();
    fs::set_permissions(fixture.folder(), fs::Permissions::from_mode(0o775)).unwrap();
    assert!(Worker::through("umask 077; exec \"$@\"", WORKER, &fixture.folder()).output().status.success());
    assert_eq!((mode(&fixture.file("1.csv")), mode(&fixture.file(".1.csv.lock"))), (0o660, 0o660));
}

#[cfg(unix)]
#[test]
fn a_lock_file_that_may_only_be_read_locks_as_well() {
    use std::os::unix::fs::PermissionsExt;
    let fixture = with("name,score\nann,30\n");
    fs::write(fixture.file(".1.csv.lock"), "").unwrap();
    fs::set_permissions(fixture.file(".1.csv.lock"), fs::Permissions::from_mode(0o444)).unwrap();
    fixture.scores().save("1", &name("bob"), 40).unwrap();
    assert_eq!(fixture.text("1.csv"), "name,score\nbob,40\nann,30\n");
}

#[test]
fn a_lock_that_is_held_is_waited_for_and_then_told() {
    let fixture = with("name,score\nann,30\n");
    let held = File::create(fixture.file(".1.csv.lock")).unwrap();
    held.lock().unwrap();
    let error = fixture.scores().save("1", &name("bob"), 40).unwrap_err();
    assert!(matches!(error, ScoresError::Save(SaveError::Busy(_))));
    let place = fixture.file(".1.csv.lock");
    let told = "another program is saving there and does not come to an end; nothing was saved, try again";
    assert_eq!(error.to_string(), format!("{}: {told}", place.display()));
    assert_eq!(fixture.text("1.csv"), "name,score\nann,30\n");
    let released = std::thread::spawn(move || {
        std::thread::sleep(Duration::from_millis(200));
        drop(held);
    });
    until_its_turn(|| fixture.scores().save("1", &name("bob"), 40).map(drop));
    released.join().unwrap();
    assert_eq!(fixture.text("1.csv"), "name,score\nbob,40\nann,30\n");
}

#[cfg(unix)]
#[test]
fn a_board_that_is_a_link_is_followed_and_stays_one() {
    let fixture = with("name,score\nann,30\n");
    let elsewhere = fixture.root.path().join("elsewhere");
    fs::create_dir(&elsewhere).unwrap();
    fs::rename(fixture.file("1.csv"), elsewhere.join("shared.csv")).unwrap();
    std::os::unix::fs::symlink("../elsewhere/shared.csv", fixture.file("1.csv")).unwrap();
    fixture.scores().save("1", &name("bob"), 40).unwrap();
    assert!(fs::symlink_metadata(fixture.file("1.csv")).unwrap().is_symlink());
    assert_eq!(fs::read_to_string(elsewhere.join("shared.csv")).unwrap(), "name,score\nbob,40\nann,30\n");
    assert_eq!(fixture.names(), ["1.csv"], "the lock is beside the file");
    assert!(elsewhere.join(".shared.csv.lock").is_file());
    std::os::unix::fs::symlink("nowhere.csv", fixture.file("2.csv")).unwrap();
    let error = fixture.scores().save("2", &name("bob"), 40).unwrap_err();
    assert!(error.to_string().contains("2.csv: cannot follow the link: "), "{error}");
}

#[cfg(unix)]
#[test]
fn what_is_no_file_is_refused_at_once() {
    let fixture = with("");
    for (level, pipe) in [("2", "2.csv"), ("3", ".3.csv.lock")] {
        assert!(Command::new("mkfifo").arg(fixture.file(pipe)).status().unwrap().success());
        let error = fixture.scores().save(level, &name("bob"), 40).unwrap_err();
        assert!(error.to_string().contains("expected a regular file"), "{error}");
    }
    assert!(fixture.scores().load("2").unwrap_err().to_string().contains("2.csv: cannot read the file: found a pipe"));
    std::os::unix::fs::symlink("/dev/zero", fixture.file("4.csv")).unwrap();
    assert!(fixture.scores().load("4").unwrap_err().to_string().contains("expected a regular file"));
}

#[test]
fn a_board_that_is_too_large_is_neither_read_nor_written() {
    let row = |i: usize| format!("user{i},{}\n", 1_000_000_000 - i);
    let rows: String = (0..30_000)
        .map(row)
        .take_while({
            let mut bytes = "name,score\n".len();
            move |row| {
                bytes += row.len();
                bytes <= files::SCORES as usize
            }
        })
        .collect();
    let full = format!("name,score\n{rows}");
    let fixture = with(&full);
    assert!(full.len() > files::SCORES as usize - 30);
    assert!(fixture.scores().load("1").is_ok());
    let error = fixture.scores().save("1", &name("one-row-too-man"), 1_000_000_000_000).unwrap_err();
    assert!(matches!(error, ScoresError::Save(SaveError::Full(..))), "{error}");
    assert_eq!(fixture.text("1.csv"), full);
    fs::write(fixture.file("2.csv"), full + &" ".repeat(100)).unwrap();
    let error = fixture.scores().load("2").unwrap_err();
    assert!(error.to_string().ends_with("bytes, expected at most 524288 bytes"), "{error}");
}

#[cfg(unix)]
#[test]
fn a_file_shared_with_a_group_stays_shared() {
    use std::os::unix::fs::PermissionsExt;
    let fixture = with("name,score\nann,30\n");
    fs::set_permissions(fixture.file("1.csv"), fs::Permissions::from_mode(0o664)).unwrap();
    // Only the administrator may give a file to a group that is not the own one.
    let given = std::os::unix::fs::chown(fixture.file("1.csv"), None, Some(12_345)).is_ok();
    fixture.scores().save("1", &name("bob"), 40).unwrap();
    let found = fs::metadata(fixture.file("1.csv")).unwrap();
    assert_eq!(found.permissions().mode() & 0o777, 0o664);
    assert!(!given || std::os::unix::fs::MetadataExt::gid(&found) == 12_345);
}

const WORKER: &str = "scores::processes_that_save_at_once_lose_nothing";

#[test]
fn processes_that_save_at_once_lose_nothing() {
    in_a_worker(|scores, prefix, number| {
        let user = name(&format!("{prefix}-{number}"));
        until_its_turn(|| scores.save("1", &user, i64::from(number)).map(drop));
    });
    const PROCESSES: u32 = 6;
    const SAVES: u32 = 25;
    let fixture = Fixture::new();
    let start = |process| Worker::start(WORKER, &fixture.folder(), &format!("p{process}"), SAVES);
    let mut workers: Vec<_> = (0..PROCESSES).map(start).collect();
    let confirmed: u32 = workers.iter_mut().map(|worker| confirmed(worker).count() as u32).sum();
    assert!(workers.iter_mut().all(|worker| worker.wait().unwrap().success()));
    assert_eq!(confirmed, PROCESSES * SAVES);
    let loaded = fixture.scores().load("1").unwrap();
    assert_eq!(loaded.damage, [""; 0]);
    let there: BTreeSet<_> = loaded.board.rows().iter().map(|row| (row.name.to_string(), row.score)).collect();
    let expected =
        (0..PROCESSES).flat_map(|process| (1..=SAVES).map(move |number| (format!("p{process}-{number}"), i64::from(number))));
    assert_eq!(there, expected.collect());
    assert_eq!(fixture.names(), [".1.csv.lock", "1.csv"]);
}
