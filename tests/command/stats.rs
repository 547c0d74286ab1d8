//! `resultant stats`, through the program.

use crate::support::program::Data;
use std::fs;

const ATTEMPTS: &str = "level,player,result,time,fuel,hits,cause,assisted\r\n";
const ANSWERS: &str =
    "\u{feff}player,experiment,time,prediction,predicted,prediction_right,quantity,reading,unit,tick,reading_right,answer\r\n";

/// The files of two pupils, a folder each as a class hands them in.
fn class() -> Data {
    let data = Data::new();
    let ann = "2,ann,completed,9.000,0.5,0,,false\r\n2,ann,completed,5.000,0.5,0,,false\r\n2,ann,completed,1.000,0.5,0,,true\r\n\
               10,ann,failed,3.000,0.5,1,obstacle 2,false\r\n10,ann,failed,3.000,0.5,1,sea 1,false\r\n\
               10,ann,failed,3.000,0.5,1,obstacle 2,false\r\n";
    data.write("ann/scores/attempts.csv", &format!("{ATTEMPTS}{ann}"));
    data.write("ann/scores/2.csv", "name,score\nann,5\n");
    let hooke = "ann,hooke,2026-11-24 15:58:21,40,2026-11-24 15:50:00,no,force,50,N/m,7,yes,F = k·s\r\n\
                 ann,hooke,2026-11-24 15:58:21,,,,stretch,0.6,m,9,no,F = k·s\r\n";
    let lift = "ann,lift,2026-11-24 15:58:22,heavier,2026-11-24 15:58:00,,,,,,,N = m·(g + a)\r\n";
    data.write("ann/results/ann.csv", &format!("{ANSWERS}{hooke}{lift}"));
    data.write("bob/attempts.csv", &format!("{ATTEMPTS}2,bob,completed,8.000,0.5,0,,FALSE\n"));
    let bobs = "bob,hooke,2026-11-24 16:00:00,'=50,2026-11-24 15:59:00,yes,force,80,N/m,3,no,F = k·s\r\n";
    data.write("bob/bob.csv", &format!("{ANSWERS}{hooke}{bobs}"));
    data
}

const LEVELS: &str = "\
level  players  tries  successes   rate  median time  lost to
2            2      4          4  100 %       8.00 s
10           1      3          0    0 %            –  obstacle 2 (2), sea 1 (1)
";
const EXPERIMENTS: &str = "\
experiment  players  answers  predictions right  wrong  readings right  wrong
hooke             2        2                  1      1               1      2
lift              1        1                  0      0               0      0
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
        kind,name,players,tries,successes,median_time,lost_to,predictions_right,predictions_wrong,readings_right,readings_wrong\n\
        level,2,2,4,4,8.000,,,,,\n\
        level,10,1,3,0,,\"obstacle 2 (2), sea 1 (1)\",,,,\n\
        experiment,hooke,2,2,,,,1,1,1,2\n\
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
    let answers =
        data.write("dan.csv", &format!("{ANSWERS}dan,hooke,now,50,now,maybe,,,,,,F\r\ndan,hooke,now,50,now,yes,,,,,,F\r\n"));
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
        (7, "dan.csv:2: column \"prediction_right\": found \"maybe\", expected yes or no"),
    ] {
        assert!(said[line].contains(words), "{said:#?}");
    }
    assert_eq!(said.len(), 8, "{said:#?}");
    assert!(sums.out.contains("\n2            1      1          0   0 %"), "{}", sums.out);
    assert!(sums.out.contains("\nhooke             1        1 "), "{}", sums.out);
    let other = data.resultant(&["stats", &data.arg("ann/scores/2.csv"), &data.arg("bob")]);
    assert!(other.status == 1 && other.err.contains("2.csv:1: found another table"), "{other:?}");
    assert!(other.out.contains("hooke"), "{other:?}");
    let missing = data.resultant(&["stats", &data.arg("eve")]);
    assert!(missing.status == 2 && missing.err.contains("eve: "), "{missing:?}");
}

/// Nine folders and more within each other, in one of which a link leads back to the first.
#[test]
fn lists_count_at_any_depth_and_each_once() {
    let data = class();
    let deep = format!("class/{}ann.csv", "deeper/".repeat(40));
    data.write(&deep, &fs::read_to_string(data.path("ann/scores/attempts.csv")).unwrap());
    data.write("class/B\u{f6}b 7/Answers.CSV", &fs::read_to_string(data.path("ann/results/ann.csv")).unwrap());
    data.write("class/.hidden/ann.csv", "not a list");
    data.write("class/list.csv", "name,class\nann,7b\n");
    data.write("class/notes.txt", "Ann has answered yes.\n");
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink(data.path("class"), data.path("class/deeper/again")).unwrap();
        std::os::unix::fs::symlink(data.path("bob"), data.path("class/bob")).unwrap();
    }
    let sums = data.resultant(&["stats", &data.arg("class"), &data.arg("bob"), &data.arg("class")]);
    assert_eq!((sums.status, sums.out.as_str(), sums.err.as_str()), (0, format!("{LEVELS}\n{EXPERIMENTS}").as_str(), ""));
}

#[test]
fn a_list_that_cannot_be_read_is_named_and_no_sums_pass_for_whole() {
    let data = class();
    let rows = "lift,2026-03-04T10:11:00Z,heavier,2026-03-04T10:10:00Z,no,,,,,,because";
    let wide = |text: &str| text.encode_utf16().flat_map(u16::to_le_bytes).collect::<Vec<u8>>();
    let unread: [(&str, Vec<u8>); 6] = [
        ("binary.csv", vec![0; 64]),
        ("damaged.csv", [ANSWERS.as_bytes(), b"\xff\xfe,\xff\n\"open"].concat()),
        ("headless.csv", format!("eve,{rows}\n").into_bytes()),
        ("renamed.txt", format!("Spieler;Versuch;Zeit\neve;{}\n", rows.replace(',', ";")).into_bytes()),
        ("wide.csv", [vec![0xFF, 0xFE], wide(&format!("eve\t{}", rows.replace(',', "\t")))].concat()),
        ("table.xlsx", b"PK\x03\x04".to_vec()),
    ];
    for (name, bytes) in &unread {
        fs::create_dir_all(data.path("class")).unwrap();
        fs::write(data.path("class").join(name), bytes).unwrap();
    }
    fs::rename(data.path("ann"), data.path("class/ann")).unwrap();
    let out = data.write("sums.csv", "the sums of last week\n");
    let sums = data.resultant(&["stats", &data.arg("class"), "--csv", &out]);
    assert_eq!(sums.status, 1, "{sums:?}");
    assert!(sums.out.contains("hooke             1        1 "), "{sums:?}");
    let said = sums.err.lines().find(|line| line.contains("these sums are not whole")).unwrap();
    for (name, _) in &unread {
        let named = |line: &str| line.contains(name) && !line.contains("not whole");
        assert!(sums.err.lines().any(named) && said.contains(name), "{name}: {sums:?}");
    }
}

#[cfg(unix)]
#[test]
fn what_leads_nowhere_or_is_no_file_is_named() {
    use std::os::unix::fs::symlink;
    let data = class();
    fs::create_dir(data.path("class")).unwrap();
    fs::rename(data.path("bob"), data.path("class/bob")).unwrap();
    symlink("nowhere", data.path("class/Dan")).unwrap();
    symlink("round.csv", data.path("class/round.csv")).unwrap();
    symlink("/dev/zero", data.path("class/zero.csv")).unwrap();
    assert!(std::process::Command::new("mkfifo").arg(data.path("class/pipe.csv")).status().unwrap().success());
    let sums = data.resultant(&["stats", &data.arg("class")]);
    assert!(sums.status == 1 && sums.out.contains("hooke             2        2 "), "{sums:?}");
    let named: Vec<bool> = ["Dan: ", "round.csv: ", "zero.csv: ", "pipe.csv: "].map(|name| sums.err.contains(name)).to_vec();
    assert_eq!((named, sums.err.lines().count()), (vec![true; 4], 4), "{sums:?}");
}

#[cfg(all(target_os = "linux", target_arch = "x86_64"))]
#[test]
fn a_folder_that_cannot_be_listed_is_named() {
    use crate::run::traced::{Fault, run};
    let data = class();
    let stats = || {
        let mut command = data.command(&["stats", &data.arg("ann")]);
        command.stdout(std::process::Stdio::null()).stderr(fs::File::create(data.path("said")).unwrap());
        command
    };
    let (calls, whole) = run(&mut stats(), None);
    assert_eq!(whole.code(), Some(0));
    let listings: Vec<usize> = (0..calls.len()).filter(|call| calls[*call] == libc::SYS_getdents64).collect();
    let faults: Vec<usize> = listings
        .into_iter()
        .filter(|call| {
            let (_, status) = run(&mut stats(), Some((*call, Fault::Error(libc::EIO))));
            let said = fs::read_to_string(data.path("said")).unwrap();
            assert!(status.code() == Some(0) || said.contains("ann") && said.contains("error"), "{status}, {said}");
            status.code() == Some(1)
        })
        .collect();
    assert_eq!(faults.len(), 6, "{faults:?}");
}

/// A command's own outputs never end while it reads them.
#[cfg(unix)]
#[test]
fn no_command_reads_its_own_outputs() {
    let data = class();
    data.level("a", "", &[("player.csv", "1500,1500,100,500,1500\n")]);
    let paths = ["/dev/stdout", "/dev/stderr", "/dev/fd/1", "/dev/fd/2", "/dev/tty", "/dev/zero"];
    let of_linux = ["/proc/self/fd/1", "/proc/self/fd/2"];
    for path in paths.into_iter().chain(of_linux.into_iter().filter(|_| cfg!(target_os = "linux"))) {
        for line in [
            vec!["stats", path],
            vec!["verify", path],
            vec!["code", path],
            vec!["unpack", path],
            vec!["run", "a", "--inputs", path],
            vec!["jumper", "--inputs", path],
            vec!["tiles", path, path],
        ] {
            let ran = data.resultant(&line);
            assert!(ran.status > 0 && !ran.err.is_empty() && ran.out.lines().count() < 2, "{line:?}: {ran:?}");
        }
    }
    let list = data.arg("bob/bob.csv");
    for path in ["/dev/stdin", "/dev/fd/0"] {
        let mut command = data.command(&["stats", path]);
        let ran = crate::support::program::Ran::new(command.stdin(fs::File::open(&list).unwrap()));
        assert!(ran.status == 0 && ran.out.contains("hooke"), "{path}: {ran:?}");
    }
    let program = env!("CARGO_BIN_EXE_resultant");
    let piped = format!("'{program}' --data '{}' stats <(cat '{list}')", data.arg("."));
    let ran = crate::support::program::Ran::new(std::process::Command::new("bash").args(["-c", &piped]));
    assert!(ran.status == 0 && ran.out.contains("hooke"), "{ran:?}");
}
