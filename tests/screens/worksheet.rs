//! The sheet of an experiment beside its flight, and the file that a pupil hands in.

use crate::languages::{faults_in_windows, whole};
use crate::lesson::{opened, predict};
use crate::sitting::Sitting;
use crate::support::shipped::experiments;
use resultant::scores::Name;
use resultant::screens::{Destination, Effect, Input, Key, Request};
use resultant::words::{Language, speak};
use std::fs;
use std::path::PathBuf;

const HEADER: &str =
    "\u{feff}player,experiment,time,prediction,predicted,prediction_right,quantity,reading,unit,tick,reading_right,answer\r\n";
const FORCE: &str = "soft spring, force for each metre";
const ANSWER: &str = "\"F = k·s, with k = 50 N/m: m·g/k at rest, twice that at the lowest\"";

fn folder(sitting: &Sitting) -> PathBuf {
    sitting.folder.path().join("results")
}

fn file(sitting: &Sitting, name: &str) -> PathBuf {
    folder(sitting).join(name)
}

fn results(sitting: &Sitting) -> String {
    fs::read_to_string(file(sitting, "Guest.csv")).unwrap_or_default()
}

fn rows(sitting: &Sitting) -> Vec<Vec<String>> {
    let text = results(sitting);
    let reader = csv::Reader::from_reader(text.as_bytes());
    reader.into_records().map(|row| row.unwrap().iter().map(str::to_owned).collect()).collect()
}

fn running(name: &str, prediction: &str) -> Sitting {
    let mut sitting = opened(name);
    predict(&mut sitting, prediction);
    sitting.press(Key::B).wait(0.5).press(Key::B);
    assert!(sitting.ticks() > 0);
    sitting
}

fn read(sitting: &mut Sitting, cell: &str, text: &str) {
    sitting.click(cell).write(text).press(Key::Enter);
}

#[test]
fn a_prediction_comes_before_the_run_each_reading_has_its_tick_and_verdict_and_the_answer_is_last() {
    let mut sitting = opened("hooke");
    sitting.app.session.now = 1_800_000_000.0;
    assert!(sitting.shows("Hooke's law") && sitting.shows("How hard does the soft spring pull") && !sitting.shows("F = k·s"));
    sitting.click("Save");
    assert_eq!(sitting.warning().as_deref(), Some("Make a prediction first."));
    for button in ["Answer", FORCE] {
        sitting.click(button);
        assert_eq!(sitting.warning().as_deref(), Some("Let the experiment go first."));
    }
    assert!(!folder(&sitting).exists());
    predict(&mut sitting, "30");
    predict(&mut sitting, "40");
    sitting.press(Key::B).wait(0.5).press(Key::B);
    assert!(sitting.ticks() > 0 && !sitting.labels().contains(&"Your prediction"), "it stays as it was");
    sitting.click("Answer");
    assert_eq!(sitting.warning().as_deref(), Some("Write down a reading first: the answer comes last."));
    sitting.app.session.now += 60.0;
    let tick = sitting.ticks();
    read(&mut sitting, FORCE, "49,5 N/m");
    assert!(sitting.shows("49,5 N/m") && sitting.shows(&tick.to_string()) && !sitting.shows("×"));
    sitting.click("Save");
    let first =
        format!("Guest,hooke,2027-01-15 08:01:00,40,2027-01-15 08:00:00,no,\"{FORCE}\",\"49,5 N/m\",N/m,{tick},yes,{ANSWER}\r\n");
    assert_eq!(results(&sitting), format!("{HEADER}{first}"));
    assert!(sitting.shows("Saved in ") && sitting.warning().is_none());
    sitting.click("Save");
    assert!(sitting.shows("This is saved already.") && rows(&sitting).len() == 1);
    sitting.press(Key::Period);
    read(&mut sitting, "hard spring, force for each metre", "50");
    assert!(sitting.shows("×"));
    sitting.click("Save").click("Answer");
    assert!(sitting.shows("F = k·s") && sitting.shows("40 N/m · not so"));
    let second =
        format!("Guest,hooke,2027-01-15 08:01:00,,,,\"hard spring, force for each metre\",50,N/m,{},no,{ANSWER}\r\n", tick + 1);
    assert_eq!(results(&sitting), format!("{HEADER}{first}{second}"));
    sitting.click(FORCE).write("1");
    assert!(!sitting.shows("49,5 N/m1") && sitting.warning().unwrap().contains("The answer is shown"));
    sitting.press(Key::R).press(Key::B).wait(0.2);
    assert!(sitting.ticks() > 0 && sitting.shows("F = k·s") && sitting.shows("49,5 N/m"));
}

#[test]
fn a_sheet_outlasts_its_flight_and_is_saved_once_when_that_is_left() {
    let mut sitting = running("hooke", "40");
    sitting.press(Key::Escape).click("Back to experiments");
    assert!(matches!(&rows(&sitting)[..], [row] if row[3] == "40" && row[5] == "no" && row[7].is_empty()), "{:?}", rows(&sitting));
    sitting.press(Key::Enter);
    assert!(sitting.at() == "flight" && sitting.shows("40") && sitting.shows("Saved in "));
    sitting.press(Key::Escape).click("Main Menu");
    assert_eq!(rows(&sitting).len(), 1, "nothing has changed");
    let open = |sitting: &mut Sitting| {
        sitting.app.grant(Request::Reset(Destination::Experiment("hooke".into())), &mut ());
        sitting.rest();
    };
    open(&mut sitting);
    assert!(!sitting.labels().contains(&"Your prediction"), "a prediction after the run is none");
    read(&mut sitting, FORCE, "50 N/m");
    sitting.press(Key::Escape).click("Edit Level").press(Key::Escape);
    let written = rows(&sitting);
    assert!(written.len() == 2 && (&*written[1][3], &*written[1][7], &*written[1][10]) == ("", "50 N/m", "yes"), "{written:?}");
    open(&mut sitting);
    read(&mut sitting, FORCE, " or more");
    sitting.reopen();
    assert!(rows(&sitting).len() == 3 && rows(&sitting)[2][7].contains("or more"), "at the end: {:?}", rows(&sitting));
    open(&mut sitting);
    predict(&mut sitting, "4711");
    sitting.app.grant(Request::Do(Effect::Choose(Name::new("ann").unwrap(), false)), &mut ());
    open(&mut sitting);
    assert!(!sitting.shows("4711") && rows(&sitting).len() == 4 && !file(&sitting, "ann.csv").exists());
}

#[test]
fn a_prediction_is_chosen_where_there_are_choices() {
    let mut sitting = opened("spring-swing");
    sitting.click("a wider swing").click("more mass").press(Key::B).wait(0.2).click("Save");
    read(&mut sitting, "first ball, period", "2 s");
    sitting.click("Answer");
    assert!(sitting.shows("more mass · right"));
    assert!(matches!(&rows(&sitting)[..], [row] if row[3] == "more mass" && row[5] == "yes"), "{:?}", rows(&sitting));
}

#[test]
fn letters_go_into_the_open_cell_and_elsewhere_are_keys() {
    let mut sitting = running("hooke", "40");
    let b: Input = Input { pressed: [Key::B].into_iter().collect(), typed: "b".into(), ..Input::default() };
    sitting.click(FORCE).give(b.clone());
    assert!(sitting.shows("b") && sitting.flight().observer().frozen());
    sitting.press(Key::Escape);
    assert!(sitting.at() == "flight", "Esc gives the cell up");
    sitting.give(b);
    assert!(!sitting.flight().observer().frozen());
    sitting.press(Key::L);
    assert!(!sitting.labels().contains(&FORCE));
    sitting.click("Sheet");
    assert!(sitting.labels().contains(&FORCE));
}

#[test]
fn a_key_and_a_button_lead_to_the_free_body_picture_and_back() {
    let mut sitting = running("pushed-row", "100");
    for turn in 0..4 {
        assert_eq!(sitting.scene().overlays.picture, turn % 2 == 1);
        if turn < 2 {
            sitting.press(Key::K)
        } else {
            sitting.click("Free-body picture")
        };
    }
    sitting.press(Key::K).press(Key::N);
    assert_eq!(sitting.flight().observer().focus().followed.map(|body| body.0), Some(2), "N leads to the next body there too");
}

#[test]
fn what_cannot_be_saved_is_told_and_stays_on_the_sheet() {
    let mut sitting = running("hooke", "40");
    fs::write(folder(&sitting), "a file, no folder").unwrap();
    sitting.click("Save");
    assert!(sitting.warning().unwrap().contains("results: cannot create the folder"), "{:?}", sitting.warning());
    fs::remove_file(folder(&sitting)).unwrap();
    sitting.click("Save");
    assert!(rows(&sitting)[0][3] == "40" && sitting.warning().is_none());
    fs::write(file(&sitting, "Guest.csv"), "my own notes\n").unwrap();
    read(&mut sitting, FORCE, "1");
    sitting.click("Save");
    assert!(sitting.warning().unwrap().contains("Guest.csv: this file"), "{:?}", sitting.warning());
    assert_eq!(results(&sitting), "my own notes\n");
    fs::remove_file(file(&sitting, "Guest.csv")).unwrap();
    let held = fs::File::create(file(&sitting, ".Guest.csv.lock")).unwrap();
    held.lock().unwrap();
    sitting.click("Save");
    assert!(sitting.warning().unwrap().contains(".Guest.csv.lock: another") && results(&sitting).is_empty());
    drop(held);
    assert!(sitting.click("Save").shows("Saved in ") && results(&sitting).lines().count() == 2);
}

#[test]
fn the_sheet_is_whole_in_every_window_and_language() {
    let mut found = Vec::new();
    for language in [Language::English, Language::German, Language::French] {
        let whole = whole(language);
        for name in experiments() {
            let mut sitting = running(&name, "a long prediction, as pupils make them");
            speak(language);
            let cell = sitting.labels()[2].to_owned();
            read(&mut sitting, &cell, "12,5");
            for stop in ["read", "answered", "saved"] {
                match stop {
                    "answered" => _ = sitting.click("Answer"),
                    "saved" => _ = sitting.click("Save"),
                    _ => {}
                }
                found.extend(faults_in_windows(&mut sitting, &format!("{name}, {language:?}, {stop}"), &whole));
            }
            speak(Language::English);
        }
    }
    assert!(found.is_empty(), "{} faults:\n{}", found.len(), found.join("\n"));
}

#[test]
fn an_experiment_is_edited_as_a_copy() {
    let mut sitting = opened("free-fall");
    sitting.press(Key::Escape).click("Edit Level");
    assert!(sitting.at() == "levels to edit" && sitting.shows("free-fall"), "{:?}", sitting.texts());
    assert_eq!(sitting.press(Key::Enter).at(), "editor");
    assert!(sitting.folder.path().join("levels/free-fall-copy/objects.csv").exists());
}
