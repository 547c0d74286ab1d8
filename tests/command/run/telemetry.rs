//! The telemetry: every object at every tick, each row of one instant.

use super::{COLUMNS, HEADER, data, read};

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
