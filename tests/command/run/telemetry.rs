//! The telemetry: every object at every tick, each row of one instant.

use super::{COLUMNS, HEADER, data, read};
use crate::support::program::Data;

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
    assert!(
        text.lines().next().is_some_and(|first| first.starts_with(COLUMNS) && first.ends_with(",impulse_x,impulse_y")),
        "{text}"
    );
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
    let header = text.lines().next().unwrap().split(',');
    let forces = header.skip_while(|name| *name != "weight_x").take_while(|name| *name != "impulse_x");
    let names: Vec<&str> = forces.filter_map(|name| name.strip_suffix("_x")).collect();
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
