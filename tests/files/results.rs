//! The files of answers on disk.

use super::fixture::{Fixture, name};
use resultant::scores::{ResultRow, Results};
use std::fs;
use std::path::PathBuf;

const HEADER: &str =
    "\u{feff}player,experiment,time,prediction,predicted,prediction_right,quantity,reading,unit,tick,reading_right,answer\r\n";
const ROW: &str = "ann,hooke,2026-11-24 15:58:21,40,2026-11-24 15:50:00,no,force,50,N/m,7,yes,F = k·s\r\n";

fn answer() -> [ResultRow; 1] {
    [ResultRow {
        player: name("ann"),
        experiment: "hooke".to_owned(),
        time: "2026-11-24 15:58:21".to_owned(),
        prediction: "40".to_owned(),
        predicted: "2026-11-24 15:50:00".to_owned(),
        prediction_right: Some(false),
        quantity: "force".to_owned(),
        reading: "50".to_owned(),
        unit: "N/m".to_owned(),
        tick: Some(7),
        reading_right: Some(true),
        answer: "F = k·s".to_owned(),
    }]
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
        results.append(&answer()).unwrap();
        assert_eq!(fs::read_to_string(&file).unwrap(), after);
    }
}

#[cfg(unix)]
#[test]
fn a_link_is_followed_to_a_list_of_answers_and_to_nothing_else() {
    let (fixture, results, file) = results();
    let target = fixture.root.path().join("class.csv");
    fs::create_dir(file.parent().unwrap()).unwrap();
    fs::write(&target, HEADER).unwrap();
    std::os::unix::fs::symlink(&target, &file).unwrap();
    results.append(&answer()).unwrap();
    assert_eq!(fs::read_to_string(&target).unwrap(), format!("{HEADER}{ROW}"));
    fs::write(&target, "the teacher's own\n").unwrap();
    let error = results.append(&answer()).unwrap_err().to_string();
    assert!(error.contains("ann.csv: this file holds other lines"), "{error}");
    assert_eq!(fs::read_to_string(&target).unwrap(), "the teacher's own\n");
}
