//! `resultant run` and `resultant verify`, through the program.

mod program;

use program::{Data, Ran, resultant};
use std::process::{Command, Stdio};

const HEADER: &str = "ticks,thrust,reverse,left,right";
const PLAYER: &str = "1500,1500,100,500,3000\n";
/// Far from the ship.
const OBJECTIVES: &str = "PLAYER,10,10,20,20\nOBJECT,600,100,box:60x30,75,181,49,201,0.5,0.1\n";
/// The telemetry's first row, as documented.
const COLUMNS: &str = "tick,time,object,kind,x,y,vx,vy,ax,ay,angle,fuel,resultant_x,resultant_y,weight_x,weight_y,drive_x,drive_y,\
    reaction_x,reaction_y,friction_x,friction_y,air_resistance_x,air_resistance_y,wind_x,wind_y,buoyancy_x,buoyancy_y,viscous_drag_x,\
    viscous_drag_y,push_x,push_y,impulse_x,impulse_y";

/// A data folder with the levels `flight` (free), `goal` (the ship starts beside its objective) and `death`.
fn data() -> Data {
    let data = Data::new();
    data.level(
        "flight",
        "air_density,0\n",
        &[("player.csv", PLAYER), ("objectives.csv", OBJECTIVES), ("objects.csv", "900,100,box:30x30,5,1,FALSE,0\n")],
    );
    // The ship's left edge is at 1474.5 px; 30 px/s carry it to 1474 px within 1/60 s.
    let drifting = "x,y,mass,fuel,thrust,vx\n1500,1500,100,500,3000,-1\n";
    let still = "gravity,0\nair_density,0\noptimal_time,10\n";
    data.level("goal", still, &[("player.csv", drifting), ("objectives.csv", "PLAYER,1400,1450,74,100\n")]);
    data.level(
        "death",
        still,
        &[("player.csv", drifting), ("objectives.csv", "PLAYER,10,10,20,20\n"), ("obstacles.csv", "1400,1450,74,100\n")],
    );
    data
}

fn read(data: &Data, name: &str) -> String {
    std::fs::read_to_string(data.path(name)).unwrap()
}

/// The rows of the telemetry, by column.
fn rows(text: &str) -> Vec<Vec<(&str, &str)>> {
    let mut lines = text.lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    lines
        .map(|line| {
            let cells: Vec<&str> = line.split(',').collect();
            assert_eq!(cells.len(), names.len(), "{line}");
            names.iter().copied().zip(cells).collect()
        })
        .collect()
}

fn number(row: &[(&str, &str)], column: &str) -> f64 {
    row.iter().find(|(name, _)| *name == column).unwrap().1.parse().unwrap()
}

#[test]
fn prints_what_the_run_came_to() {
    let ran = data().resultant(&["run", "goal"]);
    assert_eq!((ran.status, ran.err.as_str()), (0, ""));
    let keys: Vec<&str> = ran.out.lines().map(|line| line.split_once('=').unwrap().0).collect();
    assert_eq!(keys, ["outcome", "time", "score", "objectives", "collisions", "fuel", "ticks", "hash", "x", "y"]);
    assert_eq!(ran.value("outcome"), "completed");
    assert_eq!((ran.value("ticks"), ran.value("time")), ("2", "0.016666666666666666"));
    assert_eq!((ran.value("objectives"), ran.value("collisions"), ran.value("fuel")), ("1/1", "0", "1"));
    // 10 000 + ⌊10 000·(10 − 1/60)/10⌋ + 1000.
    assert_eq!(ran.value("score"), "20983");
    let hash = ran.value("hash");
    assert!(hash.len() == 16 && hash.bytes().all(|byte| matches!(byte, b'0'..=b'9' | b'a'..=b'f')), "{hash}");
}

#[test]
fn a_failed_run_is_done_with_nothing() {
    let ran = data().resultant(&["run", "death"]);
    assert_eq!((ran.status, ran.value("outcome"), ran.value("score"), ran.value("objectives")), (0, "failed", "0", "0/1"));
    assert_eq!(ran.value("ticks"), "2");
}

#[test]
fn tells_where_the_ship_ended_and_what_killed_it() {
    let data = data();
    let ran = data.resultant(&["run", "flight", "--seconds", "1"]);
    // 7.5 m of free fall in the first second.
    assert_eq!(ran.value("x"), "50");
    assert!((ran.value("y").parse::<f64>().unwrap() - 57.5).abs() < 1e-12, "{}", ran.out);
    assert!(!ran.out.contains("killed_by"), "{}", ran.out);
    assert!(!data.resultant(&["run", "goal"]).out.contains("killed_by"));

    let ran = data.resultant(&["run", "death"]);
    assert_eq!((ran.value("outcome"), ran.value("killed_by")), ("failed", "obstacle 1"));
    assert_eq!(ran.out.lines().last(), Some("killed_by=obstacle 1"), "behind all other keys");
    // The first row is far away, the second and the third are touched in the same tick.
    data.write("levels/death/obstacles.csv", "x,y,width,height\n10,10,20,20\n1400,1450,74,100\n1390,1450,84,100\n");
    assert_eq!(data.resultant(&["run", "death"]).value("killed_by"), "obstacle 2");
}

#[test]
fn ends_after_the_inputs_or_the_seconds_or_ten_seconds() {
    let data = data();
    let inputs = data.write("in.csv", &format!("{HEADER}\n3,1,0,0,0\n4,0,0,0,1\n"));
    let ticks = |args: &[&str]| data.resultant(&[&["run", "flight"], args].concat()).value("ticks").to_owned();
    assert_eq!(ticks(&["--inputs", &inputs]), "7");
    assert_eq!(ticks(&["--inputs", &inputs, "--seconds", "0.1"]), "12", "after the last row nothing is pressed");
    assert_eq!(ticks(&["--inputs", &inputs, "--seconds", "0.05"]), "6");
    assert_eq!(ticks(&[]), "1200");
    assert_eq!(ticks(&["--tick", "30"]), "300");
    assert_eq!(ticks(&["--seconds", "0"]), "0");
    assert_eq!(ticks(&["--seconds", "0.3", "--tick", "10"]), "3", "0.3 is no binary number");
    assert_eq!(ticks(&["--seconds", "0.31", "--tick", "10"]), "4");
}

#[test]
fn telemetry_tells_every_object_at_every_tick() {
    let data = data();
    let inputs = data.write("in.csv", &format!("{HEADER}\n1,0,0,0,0\n2,0,1,0,1\n"));
    let out = data.path("out.csv");
    let ran = data.resultant(&[
        "run",
        "flight",
        "--inputs",
        &inputs,
        "--seconds",
        "0.5",
        "--tick",
        "64",
        "--telemetry",
        out.to_str().unwrap(),
    ]);
    assert_eq!((ran.status, ran.value("ticks")), (0, "32"));
    let text = read(&data, "out.csv");
    assert_eq!(text.lines().next(), Some(COLUMNS));
    let rows = rows(&text);
    assert_eq!(rows.len(), 33 * 3);
    for (index, row) in rows.iter().enumerate() {
        let (tick, object) = ((index / 3) as f64, index % 3);
        assert_eq!((number(row, "tick"), number(row, "object")), (tick, object as f64));
        assert_eq!(number(row, "time"), tick / 64.0);
        assert_eq!(row[3], ("kind", ["ship", "object", "key"][object]));
    }
    // At the start: centres in metres.
    assert_eq!((number(&rows[0], "x"), number(&rows[0], "y")), (50.0, 50.0));
    assert_eq!((number(&rows[1], "x"), number(&rows[2], "x")), (30.0, 20.0));
    // The ship turns and burns in the second and third tick.
    let ship = |tick: usize, column| number(&rows[3 * tick], column);
    assert_eq!([0, 1, 2, 3, 4].map(|tick| ship(tick, "angle")), [0.0, 0.0, 180.0 / 64.0, 360.0 / 64.0, 360.0 / 64.0]);
    assert_eq!([1, 2, 3, 4].map(|tick| ship(tick, "fuel")), [500.0, 499.6875, 499.375, 499.375]);
    assert!((ship(2, "ay") - (15.0 + 30.0 * f64::to_radians(180.0 / 64.0).cos())).abs() < 1e-12);
    // Free fall.
    assert_eq!([0, 32].map(|tick| number(&rows[3 * tick + 1], "vy")), [0.0, 7.5]);
    assert!((number(&rows[97], "y") - number(&rows[1], "y") - 0.5 * 15.0 * 0.25).abs() < 1e-12);
}

#[test]
fn the_same_run_gives_the_same_bits() {
    let data = data();
    let inputs = data.write("in.csv", &format!("{HEADER}\n60,1,0,0,1\n60,0,1,1,0\n"));
    let run = |out: &str| {
        let out = data.path(out);
        data.resultant(&["run", "flight", "--inputs", &inputs, "--telemetry", out.to_str().unwrap()]).out
    };
    assert_eq!(run("one.csv"), run("two.csv"));
    assert_eq!(read(&data, "one.csv"), read(&data, "two.csv"));
}

#[test]
fn what_is_refused_runs_nothing_and_writes_nothing() {
    let data = data();
    data.level("broken", "", &[("player.csv", "1500,1500,heavy,500,3000\n"), ("objectives.csv", OBJECTIVES)]);
    let good = data.write("in.csv", &format!("{HEADER}\n3,1,0,0,0\n"));
    let bad = data.write("bad.csv", &format!("# mine\n{HEADER}\n3,1,0,0\n0,1,0,0,0\n"));
    let (out, none, folder) = (data.path("out.csv"), data.path("none/out.csv"), data.path("levels"));
    let [out, none, folder] = [&out, &none, &folder].map(|path| path.to_str().unwrap());
    for (args, message) in [
        (&["nowhere"][..], "no level \"nowhere\""),
        (&["broken"], "player.csv:1: column \"mass\""),
        (&["flight", "--inputs", "nowhere.csv"], "nowhere.csv: "),
        (&["flight", "--inputs", &bad], "bad.csv:3: column \"right\": found 4 cells in the row"),
        (&["flight", "--inputs", &bad], "bad.csv:4: column \"ticks\": found \"0\""),
        (&["flight", "--seconds", "-1"], "expected seconds"),
        (&["flight", "--seconds", "nan"], "expected seconds"),
        (&["flight", "--seconds", "inf"], "expected seconds"),
        (&["flight", "--seconds", "ten"], "expected seconds"),
        (&["flight", "--seconds", "1e300"], "expected at most 1000000000 ticks"),
        (&["flight", "--tick", "0"], "ticks a second"),
        (&["flight", "--tick", "-60"], "ticks a second"),
        (&["flight", "--tick", "NaN"], "ticks a second"),
        (&["flight", "--tick", "1e9"], "ticks a second"),
        (&["flight", "--inputs", &good, "--telemetry", none], "none/out.csv: "),
        (&["flight", "--inputs", &good, "--telemetry", folder], "levels: "),
        (&["flight", "--record", none], "none/out.csv: "),
        (&["flight", "extra"], "extra"),
        (&[], "LEVEL"),
    ] {
        let telemetry = if args.contains(&"--telemetry") || args.is_empty() { &[][..] } else { &["--telemetry", out] };
        let ran = data.resultant(&[&["run"], args, telemetry].concat());
        assert_eq!((ran.status, ran.out.as_str()), (2, ""), "{args:?}: {}", ran.err);
        assert!(ran.err.contains(message), "{args:?}: {}", ran.err);
        assert!(!data.path("out.csv").exists(), "{args:?}");
    }
    let left: Vec<_> = std::fs::read_dir(data.path(".")).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    assert_eq!(left.len(), 3, "levels, in.csv, bad.csv: {left:?}");
}

// Files that are written

/// The names in the data folder.
fn names(data: &Data) -> Vec<String> {
    let mut names: Vec<String> =
        std::fs::read_dir(data.path(".")).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn a_file_that_is_read_only_or_needed_otherwise_is_not_written_to() {
    let data = data();
    let inputs = data.write("in.csv", &format!("{HEADER}\n3,1,0,0,0\n"));
    let kept = data.write("kept.csv", "kept");
    let mut permissions = std::fs::metadata(&kept).unwrap().permissions();
    permissions.set_readonly(true);
    std::fs::set_permissions(&kept, permissions).unwrap();
    let (out, level) = (data.path("out.csv"), data.path("levels/flight/objects.csv"));
    let [out, level] = [&out, &level].map(|path| path.to_str().unwrap());
    for (args, message) in [
        (["--telemetry", &kept, "--record", out], "kept.csv: the file is read-only"),
        (["--record", out, "--telemetry", &kept], "kept.csv: the file is read-only"),
        (["--telemetry", out, "--record", out], "--record "),
        (["--telemetry", out, "--forces", out], "--forces "),
        (["--forces", &inputs, "--record", out], "in.csv: this file is read by the same command"),
        (["--telemetry", out, "--record", &inputs], "in.csv: this file is read by the same command"),
        (["--telemetry", level, "--record", out], "objects.csv: this file is read by the same command"),
    ] {
        let ran = data.resultant(&[&["run", "flight", "--inputs", &inputs], &args[..]].concat());
        assert_eq!((ran.status, ran.out.as_str()), (2, ""), "{args:?}");
        assert!(ran.err.contains(message), "{args:?}: {}", ran.err);
        assert_eq!(names(&data), ["in.csv", "kept.csv", "levels"], "{args:?}");
    }
    assert_eq!(read(&data, "kept.csv"), "kept");
    assert_eq!(read(&data, "in.csv"), format!("{HEADER}\n3,1,0,0,0\n"));
    assert!(read(&data, "levels/flight/objects.csv").starts_with("900,100,"));
}

#[cfg(unix)]
#[test]
fn a_file_that_is_written_over_keeps_its_mode_and_its_links() {
    use std::os::unix::fs::PermissionsExt;
    let data = data();
    let secret = data.write("secret.csv", "old");
    std::fs::set_permissions(&secret, std::fs::Permissions::from_mode(0o600)).unwrap();
    std::fs::hard_link(&secret, data.path("same.csv")).unwrap();
    std::os::unix::fs::symlink("secret.csv", data.path("link.csv")).unwrap();
    let link = data.path("link.csv");
    assert_eq!(data.resultant(&["run", "goal", "--telemetry", link.to_str().unwrap()]).status, 0);
    assert_eq!(std::fs::metadata(&secret).unwrap().permissions().mode() & 0o777, 0o600);
    assert!(std::fs::symlink_metadata(link).unwrap().is_symlink());
    assert!(read(&data, "secret.csv").starts_with(COLUMNS));
    assert_eq!(read(&data, "same.csv"), read(&data, "secret.csv"));
}

#[cfg(unix)]
#[test]
fn a_signal_leaves_nothing_behind() {
    let data = data();
    let old = data.write("old.csv", "old");
    let new = data.path("new.csv");
    for signal in ["-TERM", "-INT", "-KILL"] {
        let mut child = resultant();
        child.arg("--data").arg(data.path(".")).args(["run", "flight", "--seconds", "100000", "--telemetry", &old, "--record"]);
        let mut child = child.arg(&new).stdout(Stdio::null()).spawn().unwrap();
        std::thread::sleep(std::time::Duration::from_millis(300));
        assert!(child.try_wait().unwrap().is_none(), "it is over already");
        assert!(Command::new("kill").args([signal, &child.id().to_string()]).status().unwrap().success());
        child.wait().unwrap();
        assert_eq!((names(&data), read(&data, "old.csv").as_str()), (vec!["levels".into(), "old.csv".into()], "old"), "{signal}");
    }
}

/// Standard output as a file, and the telemetry in the same: neither writes over the other.
#[cfg(unix)]
#[test]
fn telemetry_and_results_can_go_to_the_same_output() {
    let data = data();
    let all = std::fs::File::create(data.path("all.txt")).unwrap();
    let mut child = resultant();
    child.arg("--data").arg(data.path(".")).args(["run", "goal", "--telemetry", "/dev/stdout"]).stdout(all);
    assert!(child.status().unwrap().success());
    let text = read(&data, "all.txt");
    assert!(text.starts_with(COLUMNS), "{text}");
    assert_eq!(text.lines().filter(|line| line.starts_with("outcome=completed")).count(), 1, "{text}");
    assert_eq!(text.lines().count(), 4 + 10, "{text}");
}

// Files that are read

#[cfg(unix)]
#[test]
fn what_never_ends_or_is_too_large_is_refused_at_once() {
    let data = data();
    let pipe = data.path("pipe");
    assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let sparse = data.path("sparse.csv");
    std::fs::File::create(&sparse).unwrap().set_len(2 << 30).unwrap();
    let [pipe, sparse] = [&pipe, &sparse].map(|path| path.to_str().unwrap());
    for (file, message) in [
        (pipe, "found a pipe or a device, expected a regular file"),
        ("/dev/zero", "found a pipe or a device, expected a regular file"),
        (sparse, "found 2147483648 bytes, expected at most 16777216 bytes"),
    ] {
        for args in [&["run", "flight", "--inputs", file][..], &["verify", file], &["jumper", "--inputs", file]] {
            let ran = data.resultant(args);
            assert_eq!((ran.status, ran.out.as_str()), (2, ""), "{args:?}");
            assert!(ran.err.contains(message), "{args:?}: {}", ran.err);
        }
        let ran = data.resultant(&["tiles", file, file]);
        assert_eq!((ran.status, ran.out.as_str()), (2, ""), "{file}: {}", ran.err);
    }
    // What is passed on open may be a pipe.
    let mut child = resultant();
    child.arg("--data").arg(data.path(".")).args(["run", "flight", "--inputs", "/dev/stdin"]);
    let mut child = child.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    std::io::Write::write_all(&mut child.stdin.take().unwrap(), format!("{HEADER}\n7,0,0,0,0\n").as_bytes()).unwrap();
    let output = child.wait_with_output().unwrap();
    assert!(String::from_utf8(output.stdout).unwrap().contains("ticks=7\n"));
}

#[test]
fn a_level_can_be_any_folder() {
    let data = data();
    let folder = data.path("levels/goal");
    let ran = Ran::new(resultant().args(["run", folder.to_str().unwrap()]));
    assert_eq!((ran.status, ran.value("outcome")), (0, "completed"));
}

// Replays

#[test]
fn a_recorded_run_is_verified() {
    let data = data();
    let inputs = data.write("in.csv", &format!("{HEADER}\n60,1,0,0,1\n60,0,1,1,0\n"));
    let (one, two) = (data.path("one.csv"), data.path("two.csv"));
    let [one, two] = [&one, &two].map(|path| path.to_str().unwrap());
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
fn a_run_that_was_tampered_with_is_found_out() {
    let data = data();
    let path = data.path("run.csv");
    let path = path.to_str().unwrap();
    data.resultant(&["run", "goal", "--record", path]);
    let good = read(&data, "run.csv");
    assert_eq!(data.resultant(&["verify", path]).status, 0);
    for (from, to) in [("score: 20983", "score: 20984"), ("2,0,0,0,0", "1,1,0,0,0"), ("tick_rate: 120", "tick_rate: 60")] {
        data.write("run.csv", &good.replace(from, to));
        let ran = data.resultant(&["verify", path]);
        assert_eq!((ran.status, ran.out.as_str()), (1, ""), "{to}");
        assert!(ran.err.contains("run.csv: recorded score 2098"), "{to}: {}", ran.err);
    }
}

#[test]
fn a_record_tells_what_recorded_it_and_in_which_level() {
    let data = data();
    let path = data.path("run.csv");
    let path = path.to_str().unwrap();
    data.resultant(&["run", "goal", "--record", path]);
    let good = read(&data, "run.csv");
    assert!(
        good.starts_with(concat!("# program: resultant ", env!("CARGO_PKG_VERSION"), "\n# level: goal\n# level_hash: ")),
        "{good}"
    );

    // How the level's files are written, its words and its looks do not matter.
    let constants = read(&data, "levels/goal/constants.csv");
    data.write("levels/goal/constants.csv", &(constants.replace('\n', "\r\n") + "title,A goal\r\n"));
    data.write("levels/goal/texts.csv", "10,10,20,Fly!\n");
    assert_eq!(data.resultant(&["verify", path]).status, 0);
    data.write("levels/goal/constants.csv", &constants);

    // Another level of that name: nothing in it is near the ship, so that the flight itself is the same.
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

    // What another version has recorded is flown all the same, and named where it leads elsewhere.
    let hash = good.lines().find(|line| line.starts_with("# level_hash: ")).unwrap();
    let older = good.replace(concat!("resultant ", env!("CARGO_PKG_VERSION")), "resultant 0.0.1");
    data.write("run.csv", &older);
    assert_eq!(data.resultant(&["verify", path]).status, 0);
    data.write("run.csv", &older.replace("score: 20983", "score: 1"));
    assert!(data.resultant(&["verify", path]).err.contains("; recorded by resultant 0.0.1, this is resultant "));

    // A record from before there were hashes.
    data.write("run.csv", &good.replace(&format!("{hash}\n"), ""));
    let ran = data.resultant(&["verify", path]);
    assert_eq!((ran.status, ran.err.as_str()), (0, ""));
    assert!(ran.out.ends_with("; the record does not say which level of that name\n"), "{}", ran.out);
}

#[cfg(unix)]
#[test]
fn a_name_with_a_line_break_writes_no_header_of_its_own() {
    let data = data();
    let name = "goal\n# score: 99999\n# hash: 0123456789abcdef";
    std::fs::rename(data.path("levels/goal"), data.path("levels").join(name)).unwrap();
    let path = data.path("run.csv");
    let path = path.to_str().unwrap();
    assert_eq!(data.resultant(&["run", name, "--record", path]).status, 0);
    let ran = data.resultant(&["verify", path]);
    assert_eq!((ran.status, ran.err.as_str()), (0, ""));
    assert!(ran.out.contains("ok, score 20983, "), "{}", ran.out);
}

/// A pipe whose reader has gone: of what is told nothing arrives, but how it ended does.
#[test]
fn a_mismatch_is_one_whoever_listens() {
    let data = data();
    let path = data.path("run.csv");
    let path = path.to_str().unwrap();
    data.resultant(&["run", "goal", "--record", path]);
    data.write("wrong.csv", &read(&data, "run.csv").replace("score: 20983", "score: 20984"));
    data.write("levels/broken/player.csv", "1,2,3\n");
    let wrong = data.path("wrong.csv");
    let wrong = wrong.to_str().unwrap();
    for (args, status) in [
        (&["verify", path, wrong][..], 1),
        (&["verify", wrong, path], 1),
        (&["check"], 1),
        (&["check", "broken", "goal"], 1),
        (&["check", "goal"], 0),
        (&["verify", path, path], 0),
    ] {
        for (out_gone, err_gone) in [(true, false), (false, true), (true, true)] {
            let stdio = |gone: bool| if gone { Stdio::from(gone_pipe()) } else { Stdio::null() };
            let mut child = resultant();
            child.arg("--data").arg(data.path(".")).args(args).stdout(stdio(out_gone)).stderr(stdio(err_gone));
            assert_eq!(child.status().unwrap().code(), Some(status), "{args:?}, gone: {out_gone} {err_gone}");
        }
    }
}

/// The writing end of a pipe that nobody reads any more.
fn gone_pipe() -> std::io::PipeWriter {
    std::io::pipe().unwrap().1
}

#[test]
fn a_long_record_tells_how_far_it_has_come() {
    let data = data();
    let path = data.path("run.csv");
    let path = path.to_str().unwrap();
    data.resultant(&["run", "goal", "--record", path]);
    // Three months, of which the first seconds are watched.
    let text = read(&data, "run.csv").replace("goal", "flight").replace("2,0,0,0,0", "1000000000,0,0,0,0");
    let text: String = text.lines().filter(|line| !line.contains("level_hash")).map(|line| format!("{line}\n")).collect();
    data.write("run.csv", &text);
    let mut child = resultant();
    child.arg("--data").arg(data.path(".")).args(["verify", path]).stdout(Stdio::null()).stderr(Stdio::piped());
    let mut child = child.spawn().unwrap();
    let mut line = String::new();
    std::io::BufRead::read_line(&mut std::io::BufReader::new(child.stderr.take().unwrap()), &mut line).unwrap();
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(line.contains("run.csv: ") && line.ends_with(" of 1000000000 ticks flown\n"), "{line}");
}

#[test]
fn a_replay_that_cannot_be_flown_is_refused_before_any_is() {
    let data = data();
    let path = data.path("run.csv");
    let path = path.to_str().unwrap();
    data.resultant(&["run", "goal", "--record", path]);
    let good = read(&data, "run.csv");
    let inputs = data.write("in.csv", &format!("{HEADER}\n3,1,0,0,0\n"));
    let lost = data.write("lost.csv", &good.replace("level: goal", "level: nowhere"));
    for (bad, message) in
        [(&inputs, "in.csv:1: \"hash\": found no line"), (&lost, "no level \"nowhere\""), (&"no.csv".into(), "no.csv: ")]
    {
        let ran = data.resultant(&["verify", path, bad]);
        assert_eq!((ran.status, ran.out.as_str()), (2, ""), "{message}");
        assert!(ran.err.contains(message), "{}", ran.err);
    }
    assert_eq!(data.resultant(&["verify"]).status, 2);
}

#[test]
fn a_reader_that_goes_away_is_no_error() {
    let data = data();
    let mut child: Command = resultant();
    child.arg("--data").arg(data.path(".")).args(["run", "flight"]).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = child.spawn().unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!((output.status.code(), output.stderr.as_slice()), (Some(0), &b""[..]));
}

#[test]
fn the_forces_of_a_row_are_those_of_its_own_instant() {
    let data = Data::new();
    let objects = "1500,2970,box:60x60,75,1,FALSE,0\n";
    let goal = "PLAYER,10,10,20,20\n";
    data.level("air", "", &[("player.csv", "1500,1000,100,500,3000\n"), ("objectives.csv", goal), ("objects.csv", objects)]);
    let inputs = data.write("in.csv", &format!("{HEADER}\n30,0,0,0,1\n60,1,0,0,0\n"));
    let out = data.path("out.csv");
    let ran = data.resultant(&["run", "air", "--inputs", &inputs, "--seconds", "2", "--telemetry", out.to_str().unwrap()]);
    assert_eq!(ran.status, 0, "{}", ran.err);
    let text = read(&data, "out.csv");
    let names = ["weight", "drive", "reaction", "friction", "air_resistance", "wind", "buoyancy", "viscous_drag", "push"];
    for row in rows(&text) {
        let mass = if row[2].1 == "0" { 100.0 } else { 75.0 };
        for axis in ["x", "y"] {
            let sum: f64 = names.iter().map(|name| number(&row, &format!("{name}_{axis}"))).sum();
            let resultant = number(&row, &format!("resultant_{axis}"));
            assert!((sum - resultant).abs() < 1e-9, "{row:?}");
            assert!((number(&row, &format!("a{axis}")) * mass - resultant).abs() < 1e-9, "{row:?}");
        }
        assert_eq!(number(&row, "weight_y"), 15.0 * mass);
        let tick = number(&row, "tick");
        let burning = mass == 100.0 && (31.0..=90.0).contains(&tick);
        let drive = number(&row, "drive_x").hypot(number(&row, "drive_y"));
        assert!((drive - if burning { 3000.0 } else { 0.0 }).abs() < 1e-9, "tick {tick}: {drive} N");
        if mass == 75.0 {
            assert_eq!((number(&row, "reaction_y"), number(&row, "resultant_y"), number(&row, "y")), (-1125.0, 0.0, 99.0));
        }
    }
}
