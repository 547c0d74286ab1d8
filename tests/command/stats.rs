//! `resultant stats`, through the program.

use crate::support::program::Data;
use std::fs;

const ATTEMPTS: &str = "level,player,result,time,fuel,hits,cause,assisted\r\n";
const ANSWERS: &str = "\u{feff}player,experiment,time,guess,guess_right,readings,readings_right,answer\r\n";

/// The files of two pupils, a folder each as a class hands them in.
fn class() -> Data {
    let data = Data::new();
    let ann = "2,ann,completed,9.000,0.5,0,,false\r\n2,ann,completed,5.000,0.5,0,,false\r\n2,ann,completed,1.000,0.5,0,,true\r\n\
               10,ann,failed,3.000,0.5,1,obstacle 2,false\r\n10,ann,failed,3.000,0.5,1,sea 1,false\r\n\
               10,ann,failed,3.000,0.5,1,obstacle 2,false\r\n";
    data.write("ann/scores/attempts.csv", &format!("{ATTEMPTS}{ann}"));
    data.write("ann/scores/2.csv", "name,score\nann,5\n");
    let hooke = "ann,hooke,2026-11-24 15:58:21,40,no,50,yes,F = k·s\r\n";
    data.write("ann/results/ann.csv", &format!("{ANSWERS}{hooke}ann,lift,2026-11-24 15:58:22,heavier,,,,N = m·(g + a)\r\n"));
    data.write("bob/attempts.csv", &format!("{ATTEMPTS}2,bob,completed,8.000,0.5,0,,FALSE\n"));
    // A copy of ann's answers, and one more.
    data.write("bob/bob.csv", &format!("{ANSWERS}{hooke}bob,hooke,2026-11-24 16:00:00,'=50,yes,80,no,F = k·s\r\n"));
    data
}

const LEVELS: &str = "\
level  players  tries  successes   rate  median time  lost to
2            2      4          4  100 %       8.00 s
10           1      3          0    0 %            –  obstacle 2 (2), sea 1 (1)
";
const EXPERIMENTS: &str = "\
experiment  players  answers  guesses right  wrong  readings right  wrong
hooke             2        2              1      1               1      1
lift              1        1              0      0               0      0
";

#[test]
fn attempts_and_answers_of_a_class_are_summed_up() {
    let data = class();
    let sums = data.resultant(&["stats", &data.arg("ann"), &data.arg("bob")]);
    assert_eq!((sums.status, sums.out.as_str(), sums.err.as_str()), (0, format!("{LEVELS}\n{EXPERIMENTS}").as_str(), ""));
    let one = data.resultant(&["stats", &data.arg("ann/results/ann.csv"), &data.arg("bob/bob.csv")]);
    assert_eq!((one.status, one.out.as_str()), (0, EXPERIMENTS));
    let none = data.resultant(&["stats"]);
    assert_eq!((none.status, none.out.as_str()), (0, "no attempts and no answers\n"));
    fs::rename(data.path("ann/scores"), data.path("scores")).unwrap();
    fs::rename(data.path("ann/results"), data.path("results")).unwrap();
    let own = data.resultant(&["stats"]);
    assert!(own.status == 0 && own.out.starts_with("level  players") && own.out.contains("\nhooke  "), "{own:?}");
}

#[test]
fn the_sums_go_to_a_file_too() {
    let data = class();
    let out = data.arg("sums.csv");
    let sums = data.resultant(&["stats", &data.arg("ann"), &data.arg("bob"), "--csv", &out]);
    assert_eq!((sums.status, sums.err.as_str()), (0, ""));
    let expected = "\
        kind,name,players,tries,successes,median_time,lost_to,guesses_right,guesses_wrong,readings_right,readings_wrong\n\
        level,2,2,4,4,8.000,,,,,\n\
        level,10,1,3,0,,\"obstacle 2 (2), sea 1 (1)\",,,,\n\
        experiment,hooke,2,2,,,,1,1,1,1\n\
        experiment,lift,1,1,,,,0,0,0,0\n";
    assert_eq!(fs::read_to_string(&out).unwrap(), expected);
    // A list that is read is not written over.
    let list = data.arg("bob/bob.csv");
    assert_eq!(data.resultant(&["stats", &list, "--csv", &list]).status, 2);
    assert!(fs::read_to_string(list).unwrap().starts_with(ANSWERS));
}

#[test]
fn rows_that_cannot_be_read_are_named_and_the_others_count() {
    let data = class();
    let bad = "2,ann,won,9.000,0.5,0,,false\r\n2,=ann,failed,9,0.5,0,,false\r\n,ann,failed,9,0.5,0,,false\r\n\
               2,ann,failed,-1,0.5,0,,false\r\n2,ann,failed,9,0.5,0,,perhaps\r\n2,ann,failed,9,0.5,0,,false,more\r\n\
               2,cid,failed,9,0.5,0,,false\r\n2,ann,failed,9,0.5,0,\"open,false\r\n";
    let list = data.write("cid.csv", &format!("{ATTEMPTS}{bad}"));
    let answers = data.write("dan.csv", &format!("{ANSWERS}dan,hooke,now,50,maybe,,,F\r\ndan,hooke,now,50,yes,,,F\r\n"));
    let sums = data.resultant(&["stats", &list, &answers]);
    assert_eq!(sums.status, 1);
    let said: Vec<&str> = sums.err.lines().collect();
    for (line, words) in [
        (0, "cid.csv:2: column \"result\": found \"won\", expected completed or failed"),
        (1, "cid.csv:3: column \"player\": found \"=ann\", expected a user name: "),
        (2, "cid.csv:4: column \"level\": found \"\", expected a name"),
        (3, "cid.csv:5: column \"time\": found \"-1\", expected a number of seconds from 0"),
        (4, "cid.csv:6: column \"assisted\": found \"perhaps\", expected true or false"),
        (5, "cid.csv:7: found 9 cells, expected 8 cells"),
        (6, "cid.csv:9: found a quote that is never closed"),
        (7, "dan.csv:2: column \"guess_right\": found \"maybe\", expected yes or no"),
    ] {
        assert!(said[line].contains(words), "{said:#?}");
    }
    assert_eq!(said.len(), 8, "{said:#?}");
    assert!(sums.out.contains("\n2            1      1          0   0 %"), "{}", sums.out);
    assert!(sums.out.contains("\nhooke             1        1 "), "{}", sums.out);
    // Another table that is named, one that is not there, and a folder in place of a list.
    let other = data.resultant(&["stats", &data.arg("ann/scores/2.csv"), &data.arg("bob")]);
    assert!(other.status == 1 && other.err.contains("2.csv:1: found another table"), "{other:?}");
    assert!(other.out.contains("hooke"), "{other:?}");
    let missing = data.resultant(&["stats", &data.arg("eve")]);
    assert!(missing.status == 2 && missing.err.contains("eve: "), "{missing:?}");
}
