//! The sheet of an experiment in the pause panel, and the file that a pupil hands in.

use crate::lesson::experiment;
use crate::sitting::Sitting;
use resultant::draw::layout::{Frame, Vec2};
use resultant::scores::Name;
use resultant::screens::{Destination, Effect, Input, Key, Request};
use std::fs;
use std::path::PathBuf;

const HEADER: &str = "\u{feff}player,experiment,time,guess,guess_right,readings,readings_right,answer\r\n";

/// In the pause panel of an experiment, where the focus is on Resume.
fn paused(name: &str) -> Sitting {
    let mut sitting = experiment(name);
    sitting.press(Key::Escape);
    assert_eq!((sitting.at(), sitting.focused()), ("pause", "Resume"));
    sitting
}

fn folder(sitting: &Sitting) -> PathBuf {
    sitting.folder.path().join("results")
}

fn file(sitting: &Sitting, name: &str) -> PathBuf {
    folder(sitting).join(name)
}

fn results(sitting: &Sitting) -> String {
    fs::read_to_string(file(sitting, "Guest.csv")).unwrap_or_default()
}

/// With a guess at Hooke's law.
fn guessed() -> Sitting {
    let mut sitting = paused("hooke");
    sitting.click("Your guess").write("40");
    sitting
}

#[test]
fn the_answer_follows_a_guess_and_goes_with_it_to_the_pupils_file() {
    let mut sitting = paused("hooke");
    assert!(sitting.shows("Hooke's law") && sitting.shows("How hard does the soft spring pull") && !sitting.shows("F = k·s"));
    for button in ["Answer", "Save"] {
        sitting.click(button);
        assert_eq!(sitting.warning().as_deref(), Some("Make a guess first."));
    }
    assert!(!folder(&sitting).exists());
    sitting.click("Your guess").write("40");
    assert_eq!(sitting.warning(), None);
    sitting.press(Key::Enter);
    assert_eq!(sitting.focused(), "Your readings");
    sitting.write("49,5 N/m").click("Answer");
    assert!(sitting.shows("F = k·s") && sitting.shows("40 · not so"));
    assert!(!sitting.labels().contains(&"Your guess"), "it stays as it was");
    sitting.app.session.now = 1_800_000_000.0;
    sitting.click("Save");
    let row = "Guest,hooke,2027-01-15 08:00:00,40,no,\"49,5 N/m\",yes,\
               \"F = k·s, with k = 50 N/m: m·g/k at rest, twice that at the lowest\"\r\n";
    assert_eq!(results(&sitting), format!("{HEADER}{row}"));
    assert!(sitting.shows("Saved in ") && sitting.warning().is_none());
    sitting.click("Save");
    assert!(sitting.shows("This is saved already.") && results(&sitting) == format!("{HEADER}{row}"));
    // The sheet outlasts a restart.
    sitting.click("Restart").press(Key::Escape);
    assert!(sitting.shows("F = k·s") && sitting.shows("49,5 N/m"));
    sitting.click("Your readings").write(" and 100").click("Save");
    assert_eq!(results(&sitting).lines().count(), 3);
}

#[test]
fn a_sheet_outlasts_its_flight_and_is_saved_once_when_that_is_left() {
    let mut sitting = guessed();
    let rows = |sitting: &Sitting| results(sitting).lines().skip(1).map(str::to_owned).collect::<Vec<_>>();
    sitting.click("Back to experiments");
    assert!(
        matches!(&rows(&sitting)[..], [row] if row.contains("Guest,hooke,") && row.contains(",40,no,,,")),
        "{:?}",
        rows(&sitting)
    );
    sitting.press(Key::Enter).press(Key::Escape);
    assert!(sitting.at() == "pause" && sitting.shows("40") && sitting.shows("Saved in "));
    sitting.click("Answer").click("Main Menu");
    assert_eq!(rows(&sitting).len(), 1, "nothing has changed");
    sitting.app.grant(Request::Reset(Destination::Experiment("hooke".into())), &mut ());
    sitting.rest().press(Key::Escape);
    assert!(sitting.shows("F = k·s") && !sitting.labels().contains(&"Your guess"), "the answer and its guess are there");
    sitting.click("Your readings").write("50 N/m").click("Edit Level").press(Key::Escape);
    assert!(matches!(&rows(&sitting)[..], [_, row] if row.contains(",40,no,50 N/m,yes,")), "{:?}", rows(&sitting));
    sitting.app.grant(Request::Reset(Destination::Experiment("hooke".into())), &mut ());
    sitting.rest().press(Key::Escape).click("Your readings").write("50 or more").reopen();
    assert!(rows(&sitting).len() == 3 && rows(&sitting)[2].contains(",50 or more,yes,"), "at the end: {:?}", rows(&sitting));
    // The next pupil has a sheet of their own.
    sitting.app.grant(Request::Reset(Destination::Experiment("hooke".into())), &mut ());
    sitting.rest().press(Key::Escape).click("Your guess").write("4711");
    sitting.app.grant(Request::Do(Effect::Choose(Name::new("ann").unwrap(), false)), &mut ());
    sitting.app.grant(Request::Reset(Destination::Experiment("hooke".into())), &mut ());
    sitting.rest().press(Key::Escape);
    assert!(!sitting.shows("4711") && rows(&sitting).len() == 4 && !file(&sitting, "ann.csv").exists());
}

#[test]
fn a_guess_is_chosen_where_there_are_choices() {
    let mut sitting = paused("spring-swing");
    sitting.click("a wider swing").click("more mass").click("Save").click("Answer");
    assert!(sitting.shows("more mass · right"));
    assert!(results(&sitting).contains(",more mass,yes,,,"), "{}", results(&sitting));
    let mut sitting = paused("free-fall");
    sitting.choose("100 kg").press_all(&[Key::Tab, Key::Tab, Key::Right]);
    assert_eq!(sitting.focused(), "Save");
    sitting.press(Key::Enter);
    assert!(results(&sitting).contains("Guest,free-fall,1970-01-01 00:00:00,100 kg,no,,,"), "{}", results(&sitting));
}

/// Each number is held against the quantities that the sheet names, in the player's words for numbers.
#[test]
fn readings_are_judged_quantity_by_quantity() {
    let saved = |name: &str, guess: &str, readings: &str| {
        let mut sitting = paused(name);
        if sitting.labels().contains(&"Your guess") {
            sitting.click("Your guess").write(guess);
        } else {
            sitting.click(guess);
        }
        sitting.click("Your readings").write(readings).click("Save");
        let rows = results(&sitting);
        let mut row = csv::ReaderBuilder::new().has_headers(false).from_reader(rows.lines().nth(1).unwrap().as_bytes());
        row.records().next().unwrap().unwrap()[6].to_owned()
    };
    for (name, guess, readings, right) in [
        ("bounce", "5", "8.1 4.9 2.5", "yes"),
        ("bounce", "5", "e = 0.5: 2.5", "yes"),
        ("bounce", "5", "8,10; 4,90; 2,45", "yes"),
        ("bounce", "5", "8.6 5.4 3.0", "no"),
        ("hooke", "40", "0,39 m", "yes"),
        ("hooke", "40", "0.5 m", "no"),
        ("terminal-velocity", "2", "t=1.2s v=11,8m/s", "yes"),
        ("friction", "wood", "-19.6 N, 39.2 N, 60 N", "yes"),
        ("friction", "wood", "2 m", "no"),
        ("lift", "400", "", ""),
    ] {
        assert_eq!(saved(name, guess, readings), right, "{name}: {readings}");
    }
    let sitting = paused("bounce");
    assert!(sitting.shows("height of the first bounce (m), energy that is left (%)"), "{:?}", sitting.texts());
}

#[test]
fn letters_go_into_the_field_with_the_focus_and_elsewhere_are_keys() {
    let mut sitting = guessed();
    let p: Input = Input { pressed: [Key::P].into_iter().collect(), typed: "p".into(), ..Input::default() };
    sitting.give(p.clone());
    assert!(sitting.at() == "pause" && sitting.shows("40p"));
    sitting.press(Key::Tab).give(p.clone());
    assert!(sitting.focused() == "Your readings" && sitting.shows("40p") && !sitting.shows("40pp"));
    sitting.press(Key::Escape);
    assert_eq!(sitting.at(), "flight");
    sitting.press(Key::Escape);
    assert!(sitting.shows("40p"), "it is still there");
    sitting.press(Key::Tab).press(Key::Tab).press(Key::Tab).press(Key::Tab);
    assert_eq!(sitting.focused(), "Resume");
    sitting.give(p);
    assert!(sitting.at() == "flight");
}

#[test]
fn what_cannot_be_saved_is_told_and_stays_on_the_sheet() {
    let mut sitting = guessed();
    fs::write(folder(&sitting), "a file, no folder").unwrap();
    sitting.click("Save");
    assert!(sitting.warning().unwrap().contains("results: cannot create the folder"), "{:?}", sitting.warning());
    fs::remove_file(folder(&sitting)).unwrap();
    sitting.click("Save");
    assert!(results(&sitting).contains(",40,no,") && sitting.warning().is_none());
    // A file of another kind is left alone.
    fs::write(file(&sitting, "Guest.csv"), "my own notes\n").unwrap();
    sitting.click("Your guess").write("1").click("Save");
    assert!(sitting.warning().unwrap().contains("Guest.csv: this file"), "{:?}", sitting.warning());
    assert_eq!(results(&sitting), "my own notes\n");
    // Nor does one that another program holds take the answer; another press saves it.
    fs::remove_file(file(&sitting, "Guest.csv")).unwrap();
    let held = fs::File::create(file(&sitting, ".Guest.csv.lock")).unwrap();
    held.lock().unwrap();
    sitting.click("Save");
    assert!(sitting.warning().unwrap().contains(".Guest.csv.lock: another") && results(&sitting).is_empty());
    drop(held);
    assert!(sitting.click("Save").shows("Saved in ") && results(&sitting).lines().count() == 2);
}

#[test]
fn the_sheet_is_whole_in_every_window() {
    for name in ["hooke", "free-fall", "pushed-row"] {
        for (width, height) in [(900.0, 500.0), (1280.0, 720.0), (600.0, 1000.0), (3000.0, 500.0)] {
            let mut sitting = paused(name);
            sitting.frame = Frame::of_window(Vec2::new(width, height));
            sitting.rest();
            if sitting.labels().contains(&"Your guess") {
                sitting.click("Your guess").write("a long guess, as pupils have them");
            } else {
                sitting.click("all at once");
            }
            sitting.click("Answer").click("Save");
            sitting.assert_whole();
            let foot = sitting.texts().iter().filter(|(text, _)| !text.is_empty()).map(|(_, at)| at.y).fold(0.0, f32::max);
            assert!(foot < sitting.frame.size.y - 8.0, "{name}, {width}: {foot}");
        }
    }
}

/// What comes with the game stays as it is.
#[test]
fn an_experiment_is_edited_as_a_copy() {
    let mut sitting = paused("free-fall");
    sitting.click("Edit Level");
    assert!(sitting.at() == "levels to edit" && sitting.shows("free-fall"), "{:?}", sitting.texts());
    sitting.press(Key::Enter);
    assert_eq!(sitting.at(), "editor");
    assert!(sitting.folder.path().join("levels/free-fall-copy/objects.csv").exists());
}
