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
    viscous_drag_y,push_x,push_y";

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
    assert_eq!(keys, ["outcome", "time", "score", "objectives", "collisions", "fuel", "ticks", "hash"]);
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
fn the_forces_of_a_row_are_those_that_led_to_it() {
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
