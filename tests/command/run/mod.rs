//! `resultant run` and `resultant verify`, through the program.

#[cfg(all(target_os = "linux", target_arch = "x86_64"))]
mod faults;
mod files;
mod records;
mod scores;
#[cfg(all(target_os = "linux", target_arch = "x86_64"))]
pub mod traced;

use crate::support::program::Data;

const HEADER: &str = "ticks,thrust,reverse,left,right";
const PLAYER: &str = "1500,1500,100,500,3000\n";
const OBJECTIVES: &str = "PLAYER,10,10,20,20\nOBJECT,600,100,box:60x30,75,181,49,201,0.5,0.1\n";
/// The telemetry's first row as documented, up to the forces.
const COLUMNS: &str = "tick,time,object,kind,x,y,vx,vy,ax,ay,angle,fuel,resultant_x,resultant_y,weight_x,weight_y,drive_x,drive_y,";

/// A data folder with the levels `flight` (free), `goal` (the ship starts beside its objective) and `death`.
fn data() -> Data {
    let data = Data::new();
    let away = ("objects.csv", "900,100,box:30x30,5,1,FALSE,0\n");
    data.level("flight", "air_density,0\n", &[("player.csv", PLAYER), ("objectives.csv", OBJECTIVES), away]);
    // The ship's left edge is at 1474.5 px; 30 px/s carry it to 1474 px within 1/60 s.
    let drifting = "x,y,mass,fuel,thrust,vx\n1500,1500,100,500,3000,-1\n";
    let still = "gravity,0\nair_density,0\noptimal_time,10\n";
    data.level("goal", still, &[("player.csv", drifting), ("objectives.csv", "PLAYER,1400,1450,74,100\n")]);
    let red = [("objectives.csv", "PLAYER,10,10,20,20\n"), ("obstacles.csv", "1400,1450,74,100\n")];
    data.level("death", still, &[("player.csv", drifting), red[0], red[1]]);
    data
}

fn read(data: &Data, name: &str) -> String {
    std::fs::read_to_string(data.path(name)).unwrap()
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
fn time_counts_from_the_first_input_and_the_telemetrys_from_the_start() {
    let data = data();
    let inputs = data.write("in.csv", &format!("{HEADER}\n60,0,0,0,0\n30,1,0,0,0\n30,0,0,0,0\n"));
    let (telemetry, record) = (data.arg("t.csv"), data.arg("r.csv"));
    let ran = data.resultant(&["run", "flight", "--inputs", &inputs, "--telemetry", &telemetry, "--record", &record]);
    assert_eq!((ran.value("ticks"), ran.value("time")), ("120", "0.5"));
    assert!(read(&data, "r.csv").contains("# time: 0.5\n"));
    assert!(read(&data, "t.csv").lines().last().unwrap().starts_with("120,1,"));
    assert_eq!(data.resultant(&["verify", &record]).status, 0, "{}", ran.err);
    assert_eq!(data.resultant(&["run", "flight", "--seconds", "0.5"]).value("time"), "0.5", "without inputs");
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
    assert_eq!((ran.status, ran.value("score"), ran.value("objectives")), (0, "0", "0/1"), "done with nothing");
    // The tip of the ship's fin is at 1477.3 px; 30 px/s carry it to 1474 px within 14 ticks.
    assert_eq!(ran.value("ticks"), "14");
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
    assert_eq!(ticks(&["--seconds", "0.3", "--tick", "30"]), "9", "0.3 is no binary number");
    assert_eq!(ticks(&["--seconds", "0.31", "--tick", "30"]), "10");
}

#[test]
fn what_is_refused_runs_nothing_and_writes_nothing() {
    let data = data();
    data.level("broken", "", &[("player.csv", "1500,1500,heavy,500,3000\n"), ("objectives.csv", OBJECTIVES)]);
    let good = data.write("in.csv", &format!("{HEADER}\n3,1,0,0,0\n"));
    let bad = data.write("bad.csv", &format!("# mine\n{HEADER}\n3,1,0,0\n0,1,0,0,0\n"));
    let [out, none, folder] = &["out.csv", "none/out.csv", "levels"].map(|name| data.arg(name));
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
        (&["flight", "--tick", "29.9"], "expected 30 to 480 ticks a second"),
        (&["flight", "--tick", "480.1"], "expected 30 to 480 ticks a second"),
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
fn telemetry_tells_every_object_at_every_tick() {
    let data = data();
    let inputs = data.write("in.csv", &format!("{HEADER}\n1,0,0,0,0\n2,0,1,0,1\n"));
    let (run, files) = (["run", "flight", "--inputs", &inputs], ["--telemetry", &data.arg("out.csv")]);
    let ran = data.resultant(&[&run[..], &["--seconds", "0.5", "--tick", "64"], &files].concat());
    assert_eq!((ran.status, ran.value("ticks")), (0, "32"));
    let text = read(&data, "out.csv");
    let first = text.lines().next().unwrap();
    assert!(first.starts_with(COLUMNS) && first.ends_with(",impulse_x,impulse_y"), "{first}");
    let rows = rows(&text);
    assert_eq!(rows.len(), 33 * 3);
    for (index, row) in rows.iter().enumerate() {
        let (tick, object) = ((index / 3) as f64, index % 3);
        assert_eq!((number(row, "tick"), number(row, "object")), (tick, object as f64));
        assert_eq!(number(row, "time"), tick / 64.0);
        assert_eq!(row[3], ("kind", ["ship", "object", "key"][object]));
    }
    assert_eq!((number(&rows[0], "x"), number(&rows[0], "y")), (50.0, 50.0));
    assert_eq!((number(&rows[1], "x"), number(&rows[2], "x")), (30.0, 20.0));
    let ship = |tick: usize, column| number(&rows[3 * tick], column);
    assert_eq!([0, 1, 2, 3, 4].map(|tick| ship(tick, "angle")), [0.0, 0.0, 180.0 / 64.0, 360.0 / 64.0, 360.0 / 64.0]);
    assert_eq!([1, 2, 3, 4].map(|tick| ship(tick, "fuel")), [500.0, 499.6875, 499.375, 499.375]);
    assert!((ship(2, "ay") - (15.0 + 30.0 * f64::to_radians(180.0 / 64.0).cos())).abs() < 1e-12);
    assert_eq!([0, 32].map(|tick| number(&rows[3 * tick + 1], "vy")), [0.0, 7.5]);
    assert!((number(&rows[97], "y") - number(&rows[1], "y") - 0.5 * 15.0 * 0.25).abs() < 1e-12);
}
