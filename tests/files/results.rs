//! The files of answers on disk, also when files are damaged, writes fail or several programs write at once.

use super::fixture::{FOLDER, Fixture, Worker, make_read_only, name, until_its_turn, work};
use resultant::files::SaveError;
use resultant::scores::{ResultRow, Results, ScoresError};
use std::fs;
use std::path::PathBuf;

const HEADER: &str = "\u{feff}player,experiment,time,guess,guess_right,readings,readings_right,answer\r\n";
const ROW: &str = "ann,hooke,2026-11-24 15:58:21,40,no,50,yes,F = k·s\r\n";

fn answer(guess: &str) -> ResultRow {
    ResultRow {
        player: name("ann"),
        experiment: "hooke".to_owned(),
        time: "2026-11-24 15:58:21".to_owned(),
        guess: guess.to_owned(),
        guess_right: Some(false),
        readings: "50".to_owned(),
        readings_right: Some(true),
        answer: "F = k·s".to_owned(),
    }
}

/// A folder of a test's own, which is not there yet, and the file of ann in it.
fn results() -> (Fixture, Results, PathBuf) {
    let fixture = Fixture::new();
    let folder = fixture.root.path().join("results");
    let file = folder.join("ann.csv");
    (fixture, Results::new(folder), file)
}

#[test]
fn an_answer_is_a_row_behind_one_header_whatever_an_editor_left() {
    let plain = HEADER.trim_start_matches('\u{feff}');
    for (before, after) in [
        (None, format!("{HEADER}{ROW}")),
        (Some(format!("{HEADER}{ROW}")), format!("{HEADER}{ROW}{ROW}")),
        (Some(format!("{plain}{ROW}")), format!("{plain}{ROW}{ROW}")),
        (Some(format!("{HEADER}torn,li")), format!("{HEADER}torn,li\r\n{ROW}")),
    ] {
        let (_fixture, results, file) = results();
        if let Some(before) = before {
            fs::create_dir(file.parent().unwrap()).unwrap();
            fs::write(&file, before).unwrap();
        }
        results.append(&answer("40")).unwrap();
        assert_eq!(fs::read_to_string(&file).unwrap(), after);
    }
}

#[test]
fn what_cannot_be_written_is_an_error_with_its_place_and_changes_nothing() {
    let (_fixture, results, file) = results();
    fs::write(file.parent().unwrap(), "a file where the folder should be").unwrap();
    let error = results.append(&answer("40")).unwrap_err().to_string();
    assert!(error.contains("results: cannot create the folder: "), "{error}");
    fs::remove_file(file.parent().unwrap()).unwrap();
    fs::create_dir_all(&file).unwrap();
    let error = results.append(&answer("40")).unwrap_err().to_string();
    assert!(error.contains("ann.csv: cannot read the file: found a folder"), "{error}");
    fs::remove_dir(&file).unwrap();
    fs::write(&file, HEADER).unwrap();
    make_read_only(&file);
    assert!(matches!(results.append(&answer("40")), Err(ScoresError::Save(SaveError::ReadOnly(_)))));
    assert_eq!(fs::read_to_string(&file).unwrap(), HEADER);
}

#[cfg(unix)]
#[test]
fn a_link_is_followed_to_a_list_of_answers_and_to_nothing_else() {
    let (fixture, results, file) = results();
    let target = fixture.root.path().join("class.csv");
    fs::create_dir(file.parent().unwrap()).unwrap();
    fs::write(&target, HEADER).unwrap();
    std::os::unix::fs::symlink(&target, &file).unwrap();
    results.append(&answer("40")).unwrap();
    assert_eq!(fs::read_to_string(&target).unwrap(), format!("{HEADER}{ROW}"));
    fs::write(&target, "the teacher's own\n").unwrap();
    let error = results.append(&answer("40")).unwrap_err().to_string();
    assert!(error.contains("ann.csv: this file holds other lines"), "{error}");
    assert_eq!(fs::read_to_string(&target).unwrap(), "the teacher's own\n");
    let mut names = fs::read_dir(fixture.root.path()).unwrap().map(|entry| entry.unwrap().file_name());
    assert!(!names.any(|name| name.to_string_lossy().contains("damaged")), "nothing is renamed");
}

#[test]
fn programs_that_write_at_once_lose_nothing() {
    const ROWS: usize = 15;
    let (_fixture, results, file) = results();
    std::thread::scope(|scope| {
        for _ in 0..4 {
            scope.spawn(|| (0..ROWS).for_each(|_| until_its_turn(|| results.append(&answer("40")))));
        }
    });
    assert_eq!(fs::read_to_string(&file).unwrap(), format!("{HEADER}{}", ROW.repeat(4 * ROWS)));
}

#[test]
#[ignore = "the body of a worker, which another test starts"]
fn writing_process() {
    let results = Results::new(std::env::var(FOLDER).unwrap());
    work(|_, _, _| results.append(&answer("41")).unwrap());
}

/// Under a limit of no bytes at all a write fails as on a full disk.
#[cfg(unix)]
#[test]
fn a_full_disk_loses_nothing() {
    let (_fixture, results, file) = results();
    results.append(&answer("40")).unwrap();
    let script = "trap '' XFSZ; ulimit -f 0; exec \"$@\"";
    let written = Worker::through(script, "results::writing_process", file.parent().unwrap()).output();
    let said = String::from_utf8_lossy(&[written.stdout, written.stderr].concat()).into_owned();
    assert!(!written.status.success() && said.contains("write the file"), "{said}");
    assert_eq!(fs::read_to_string(&file).unwrap(), format!("{HEADER}{ROW}"));
}
