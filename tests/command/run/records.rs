//! Recorded runs, and `resultant verify`.

use super::{HEADER, data, read};
use crate::support::program::Data;
use std::process::Stdio;

/// The data folder with a run of `goal` recorded in it, and the record's path.
fn recorded() -> (Data, String) {
    let data = data();
    let path = data.arg("run.csv");
    data.resultant(&["run", "goal", "--record", &path]);
    (data, path)
}

#[test]
fn a_recorded_run_is_verified() {
    let data = data();
    let inputs = data.write("in.csv", &format!("{HEADER}\n60,1,0,0,1\n60,0,1,1,0\n"));
    let [one, two] = &["one.csv", "two.csv"].map(|name| data.arg(name));
    let ran = data.resultant(&["run", "flight", "--inputs", &inputs, "--tick", "60", "--record", one]);
    data.resultant(&["run", "goal", "--record", two]);
    let again = data.resultant(&["run", "flight", "--inputs", one, "--tick", "60"]);
    assert_eq!(ran.out, again.out, "a replay is an inputs file");
    let verified = data.resultant(&["verify", one, two]);
    assert_eq!((verified.status, verified.err.as_str()), (0, ""));
    assert_eq!(verified.out.lines().count(), 2);
    assert!(verified.out.contains(&format!("one.csv: ok, score 0, hash {}", ran.value("hash"))), "{}", verified.out);
    assert!(verified.out.contains("two.csv: ok, score 20983, "), "{}", verified.out);
}

#[test]
fn a_run_is_handed_on_as_a_code() {
    let (data, path) = recorded();
    let code = data.resultant(&["code", &path]);
    assert_eq!((code.status, code.err.as_str(), code.out.lines().count()), (0, "", 1));
    let code = code.out.trim();
    let verified = data.resultant(&["verify", code]);
    assert_eq!(verified.status, 0, "{}", verified.err);
    let said = ["…: ok, score 20983, hash ", "; level goal, 2 ticks"];
    assert!(said.iter().all(|said| verified.out.contains(said)), "{}", verified.out);
    let refused = data.resultant(&["verify", &code[..code.len() - 4]]);
    assert!(refused.status == 2 && refused.out.is_empty() && refused.err.contains("cut or altered"), "{refused:?}");
}

#[test]
fn it_is_told_in_which_second_a_flight_departs_and_how_it_should_have_ended() {
    let data = data();
    let inputs = data.write("in.csv", &format!("{HEADER}\n150,1,0,0,0\n150,0,0,0,0\n100,1,0,1,0\n"));
    let path = data.arg("run.csv");
    data.resultant(&["run", "flight", "--inputs", &inputs, "--record", &path]);
    let good = read(&data, "run.csv");
    assert_eq!(good.lines().filter(|line| line.starts_with("# hash ")).count(), 3, "{good}");
    assert!(good.contains("\n# outcome: running\n# time: 3.3333333333333335\n# score: 0\n# hash: "), "{good}");
    for (from, to, why) in [
        ("150,1,0,0,0", "150,0,1,0,0", "run.csv: departs in second 1: recorded hash "),
        ("150,0,0,0,0", "149,0,0,0,0\n1,0,0,1,0", "run.csv: departs in second 3: recorded hash "),
        ("100,1,0,1,0", "99,1,0,1,0", "run.csv: recorded score 0 and hash "),
        ("outcome: running", "outcome: failed", "run.csv: recorded failed at 3.333 s, flown running at 3.333 s"),
        ("time: 3.3", "time: 4.3", "run.csv: recorded running at 4.333 s, flown running at 3.333 s"),
        ("time: 3.3", "time: 2.3", "run.csv: it ends after 280 ticks, but its keys go on for 400"),
    ] {
        data.write("run.csv", &good.replace(from, to));
        let ran = data.resultant(&["verify", &path]);
        assert_eq!((ran.status, ran.out.as_str()), (1, ""), "{to}");
        assert!(ran.err.starts_with(why) || ran.err.contains(&format!("{}{why}", std::path::MAIN_SEPARATOR)), "{to}: {}", ran.err);
    }
}

#[test]
fn a_record_tells_what_recorded_it_and_in_which_level() {
    let (data, path) = recorded();
    let path = path.as_str();
    let good = read(&data, "run.csv");
    let head = concat!("# program: resultant ", env!("CARGO_PKG_VERSION"), "\n# level: goal\n# level_hash: ");
    assert!(good.starts_with(head), "{good}");
    // How the level's files are written, its words and its looks do not matter.
    let constants = read(&data, "levels/goal/constants.csv");
    data.write("levels/goal/constants.csv", &(constants.replace('\n', "\r\n") + "title,A goal\r\n"));
    data.write("levels/goal/texts.csv", "10,10,20,Fly!\n");
    assert_eq!(data.resultant(&["verify", path]).status, 0);
    data.write("levels/goal/constants.csv", &constants);
    for (file, text) in
        [("world.csv", "10,2000,100,10\n"), ("obstacles.csv", "10,2000,100,10\n"), ("fluids.csv", "10,2000,9,9,1,1\n")]
    {
        let file = format!("levels/goal/{file}");
        data.write(&file, text);
        let ran = data.resultant(&["verify", path]);
        assert_eq!((ran.status, ran.out.as_str()), (1, ""), "{file}");
        assert!(ran.err.contains("run.csv: recorded in a level with the hash "), "{}", ran.err);
        std::fs::remove_file(data.path(&file)).unwrap();
    }
    assert_eq!(data.resultant(&["verify", path]).status, 0);
    // A record of another version is flown all the same, and the message names it where the flight leads elsewhere.
    let older = good.replace(concat!("resultant ", env!("CARGO_PKG_VERSION")), "resultant 0.0.1");
    data.write("run.csv", &older);
    assert_eq!(data.resultant(&["verify", path]).status, 0);
    data.write("run.csv", &older.replace("score: 20983", "score: 1"));
    assert!(data.resultant(&["verify", path]).err.contains("; recorded by resultant 0.0.1, this is resultant "));
    data.write("run.csv", &good.replace("# level: goal", "# player: ann\n# level: goal"));
    let ran = data.resultant(&["verify", path]);
    assert!(ran.out.contains("; level goal, 2 ticks; saved by ann"), "it says what was flown: {ran:?}");
}

/// A pipe whose reader has gone: no output arrives, but the exit status does.
#[test]
fn a_mismatch_is_one_whoever_listens() {
    let (data, path) = recorded();
    let path = path.as_str();
    let wrong = &data.write("wrong.csv", &read(&data, "run.csv").replace("score: 20983", "score: 20984"));
    data.write("levels/broken/player.csv", "1,2,3\n");
    for (args, status) in [
        (&["verify", path, wrong][..], 1),
        (&["verify", wrong, path], 1),
        (&["check"], 1),
        (&["check", "broken", "goal"], 1),
        (&["check", "goal"], 0),
        (&["verify", path, path], 0),
    ] {
        for (out_gone, err_gone) in [(true, false), (false, true), (true, true)] {
            let stdio = |gone: bool| if gone { Stdio::from(std::io::pipe().unwrap().1) } else { Stdio::null() };
            let ended = data.command(args).stdout(stdio(out_gone)).stderr(stdio(err_gone)).status().unwrap();
            assert_eq!(ended.code(), Some(status), "{args:?}, gone: {out_gone} {err_gone}");
        }
    }
}

#[test]
fn a_long_record_tells_how_far_it_has_come() {
    let (data, path) = recorded();
    let path = path.as_str();
    data.resultant(&["run", "flight", "--seconds", "0.1", "--record", path]);
    let text = read(&data, "run.csv").replace("12,0,0,0,0", "1000000000,0,0,0,0").replace("# time: 0.1", "# time: 10000000");
    data.write("run.csv", &text);
    let mut child = data.command(&["verify", path]).stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap();
    let mut line = String::new();
    std::io::BufRead::read_line(&mut std::io::BufReader::new(child.stderr.take().unwrap()), &mut line).unwrap();
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(line.contains("run.csv: ") && line.ends_with(" of 1000000000 ticks flown\n"), "{line}");
}

/// The record with a hash that no level has.
fn of_another_level(record: &str) -> String {
    let hash = record.lines().find_map(|line| line.strip_prefix("# level_hash: ")).unwrap();
    record.replace(hash, &"0".repeat(64))
}

/// The recipient of a flight may have its level under another name, and another level under that name.
#[test]
fn a_flight_and_its_code_find_their_level_by_its_hash() {
    let (data, path) = recorded();
    let path = path.as_str();
    std::fs::rename(data.path("levels/goal"), data.path("levels/borrowed")).unwrap();
    data.level("goal", "gravity,3\n", &[("player.csv", "60,845,100,500,2000\n"), ("objectives.csv", "PLAYER,2000,10,10,10\n")]);
    data.write("levels/broken/player.csv", "none\n");
    let code = data.resultant(&["code", path]).out.trim().to_owned();
    for flight in [path, code.as_str()] {
        let ran = data.resultant(&["verify", flight]);
        assert!(ran.status == 0 && ran.out.contains("; level borrowed, "), "{}{}", ran.out, ran.err);
    }
    std::fs::remove_dir_all(data.path("levels/goal")).unwrap();
    assert_eq!(data.resultant(&["verify", path, &code]).status, 0);
    // Where no level has the hash, the name says which one is not the same, or not there.
    let other = data.write("other.csv", &of_another_level(&read(&data, "run.csv")));
    assert!(data.resultant(&["verify", &other]).err.contains("no level \"goal\""));
    std::fs::rename(data.path("levels/borrowed"), data.path("levels/goal")).unwrap();
    assert!(data.resultant(&["verify", &other]).err.contains("recorded in a level with the hash 0000000000000000"));
}

#[test]
fn a_replay_that_cannot_be_flown_is_refused_before_any_is() {
    let (data, path) = recorded();
    let path = path.as_str();
    let good = read(&data, "run.csv");
    let inputs = data.write("in.csv", &format!("{HEADER}\n3,1,0,0,0\n"));
    let lost = data.write("lost.csv", &of_another_level(&good.replace("level: goal", "level: nowhere")));
    let away = data.write("away.csv", &good.replace("level: goal", "level: ../levels/goal"));
    for (bad, message) in [
        (&inputs, "in.csv:1: \"level_hash\": found no line"),
        (&lost, "no level \"nowhere\""),
        (&away, "away.csv: found a record of the level "),
        (&"no.csv".into(), "no.csv: "),
    ] {
        let ran = data.resultant(&["verify", path, bad]);
        assert_eq!((ran.status, ran.out.as_str()), (2, ""), "{message}");
        assert!(ran.err.contains(message), "{}", ran.err);
    }
    assert_eq!(data.resultant(&["verify"]).status, 2);
}

#[test]
fn a_record_is_the_same_whatever_spreadsheet_saved_it() {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("levels/1/flights/gold.replay.csv");
    let text = std::fs::read_to_string(path).unwrap();
    let record = resultant::game::Replay::parse("gold", &text).unwrap();
    for sign in [',', ';', '\t'] {
        let row = |line: &str| match line.strip_prefix('#') {
            Some(note) => format!("#{note}{}\r\n", sign.to_string().repeat(4)),
            None => line.replace(',', &sign.to_string()) + "\r\n",
        };
        let saved: String = text.lines().map(row).collect();
        assert_eq!(resultant::game::Replay::parse("gold", &saved).as_ref(), Ok(&record), "{sign:?}");
    }
}
