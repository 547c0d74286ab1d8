//! Files that are written over, and files that are read.

use super::{COLUMNS, HEADER, data, read};
use crate::support::program::{Ran, resultant};
use crate::support::shipped::names;

#[test]
fn a_file_that_is_read_only_or_needed_otherwise_is_not_written_to() {
    let data = data();
    let inputs = data.write("in.csv", &format!("{HEADER}\n3,1,0,0,0\n"));
    let kept = data.write("kept.csv", "kept");
    let mut permissions = std::fs::metadata(&kept).unwrap().permissions();
    permissions.set_readonly(true);
    std::fs::set_permissions(&kept, permissions).unwrap();
    let [out, level] = &["out.csv", "levels/flight/objects.csv"].map(|name| data.arg(name));
    for (args, message) in [
        (["--telemetry", &kept, "--record", out], "kept.csv: the file is read-only"),
        (["--telemetry", out, "--record", out], "--record "),
        (["--forces", &inputs, "--record", out], "in.csv: this file is read by the same command"),
        (["--telemetry", level, "--record", out], "objects.csv: this file is read by the same command"),
    ] {
        let ran = data.resultant(&[&["run", "flight", "--inputs", &inputs], &args[..]].concat());
        assert_eq!((ran.status, ran.out.as_str()), (2, ""), "{args:?}");
        assert!(ran.err.contains(message), "{args:?}: {}", ran.err);
        assert_eq!(names(&data.path(".")), ["in.csv", "kept.csv", "levels"], "{args:?}");
    }
    assert_eq!(read(&data, "kept.csv"), "kept");
}

#[test]
fn telemetry_goes_into_a_levels_folder_again_and_again_but_over_nothing_that_is_read() {
    let data = data();
    for _ in 0..2 {
        let ran = data.resultant(&["run", "goal", "--telemetry", &data.arg("levels/goal/out.txt")]);
        assert_eq!((ran.status, ran.err.as_str()), (0, ""));
        assert!(read(&data, "levels/goal/out.txt").starts_with(COLUMNS));
    }
    for table in ["player.csv", "movers.csv", "background.png"] {
        let ran = data.resultant(&["run", "goal", "--telemetry", &data.arg(&format!("levels/goal/{table}"))]);
        assert_eq!(ran.status, 2);
        assert!(ran.err.ends_with("this file is read by the same command, expected another\n"), "{}", ran.err);
    }
}

/// A path is bytes on Linux; other systems refuse such a one themselves.
#[cfg(target_os = "linux")]
#[test]
fn a_path_need_not_be_text() {
    use std::os::unix::ffi::OsStrExt;
    let data = data();
    let odd = |name: &[u8]| data.path(".").join(std::ffi::OsStr::from_bytes(name));
    std::fs::rename(data.path("levels/goal"), odd(b"g\xf6al")).unwrap();
    std::fs::write(odd(b"\xff.csv"), format!("{HEADER}\n2,0,0,0,0\n")).unwrap();
    let mut run = data.command(&["run"]);
    run.arg(odd(b"g\xf6al")).arg("--inputs").arg(odd(b"\xff.csv")).arg("--telemetry").arg(odd(b"\xfe.csv"));
    let ran = Ran::new(&mut run);
    assert_eq!((ran.status, ran.value("outcome")), (0, "completed"), "{}", ran.err);
    assert!(std::fs::read_to_string(odd(b"\xfe.csv")).unwrap().starts_with(COLUMNS));
    let ran = Ran::new(resultant().arg("check").arg(odd(b"g\xf6al")));
    assert_eq!(ran.status, 0, "{}", ran.err);
}

/// Neither writes over the other.
#[test]
fn telemetry_and_results_can_go_to_the_same_output() {
    let data = data();
    let all = std::fs::File::create(data.path("all.txt")).unwrap();
    let mut child = data.command(&["run", "goal", "--telemetry", "-"]);
    assert!(child.stdout(all).status().unwrap().success());
    let text = read(&data, "all.txt");
    assert!(text.starts_with(COLUMNS), "{text}");
    assert_eq!(text.lines().filter(|line| line.starts_with("outcome=completed")).count(), 1, "{text}");
    assert_eq!(text.lines().count(), 4 + 10, "{text}");
}
