//! The tile run: to the last bit, on any map.
//!
//! [`described`] is a second implementation of the description, over text instead of a grid and with integers where the program has
//! `floor`, so that a slip in one of the two shows.

use crate::support::program::{Ran, resultant};
use crate::support::strategies::cases;
use proptest::prelude::*;
use resultant::classics::tile_run::{Command, Map, Runner};
use std::path::{Path, PathBuf};

/// x, y, vx, vy and whether on the ground, after each command.
type Frame = (f64, f64, f64, f64, bool);

fn described(map: &str, commands: &[(&str, f64)]) -> Vec<Frame> {
    let rows: Vec<&str> = map.split('\n').collect();
    let solid = |x: f64, y: f64| {
        let (column, row) = (x.floor() as i64, y.floor() as i64);
        let inside = row >= 0 && row < rows.len() as i64 && column >= 0 && column < rows[row as usize].len() as i64;
        !inside || rows[row as usize].as_bytes()[column as usize] == b'#'
    };
    let row = rows.iter().position(|row| row.contains(['s', 'S'])).unwrap();
    let (mut x, mut y) = (rows[row].find(['s', 'S']).unwrap() as f64, row as f64);
    let (mut vx, mut vy, mut ground) = (0.0_f64, 0.0_f64, false);
    let mut frames = Vec::new();
    for &(name, value) in commands {
        if name == "LEFT" {
            vx -= value;
        } else if name == "RIGHT" {
            vx += value;
        } else if name == "JUMP" && ground {
            vy -= value;
            if vy < -0.6 {
                vy = -0.6;
            }
        }
        vy += 0.06;
        vx *= 0.80;
        vx = vx.clamp(-0.5, 0.5);
        vy = vy.clamp(-0.6, 0.8);
        let new_x = x + vx;
        if !solid(new_x, y) {
            x = new_x;
        } else {
            x = if vx > 0.0 { new_x.floor() - 1e-6 } else { new_x.floor() + 1.0 + 1e-6 };
            vx = 0.0;
        }
        ground = false;
        let new_y = y + vy;
        if !solid(x, new_y) {
            y = new_y;
        } else {
            ground = vy > 0.0;
            y = if vy > 0.0 { new_y.floor() - 1e-6 } else { new_y.floor() + 1.0 + 1e-6 };
            vy = 0.0;
        }
        frames.push((x, y, vx, vy, ground));
    }
    frames
}

fn run(map: &str, commands: &[(&str, f64)]) -> Vec<Frame> {
    let text: String = commands.iter().map(|(name, value)| format!("{name} {value}\n")).collect();
    let map = Map::parse(map).unwrap();
    let mut runner = Runner::new(&map);
    let frames = Command::parse_all(&text).unwrap().into_iter().map(|command| {
        runner.frame(&map, command);
        assert!(!map.is_solid(runner.x, runner.y), "inside a solid tile: {runner:?}");
        (runner.x, runner.y, runner.vx, runner.vy, runner.on_ground)
    });
    frames.collect()
}

fn data(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("assets/tile_run").join(name)
}

fn tiles(map: &Path, commands: &Path, more: &[&str]) -> Ran {
    Ran::new(resultant().arg("tiles").args([map, commands]).args(more))
}

proptest! {
    #![proptest_config(cases(256))]

    #[test]
    fn every_run_on_every_map_is_the_described_one(
        rows in prop::collection::vec("[.#]{0,6}[.]{0,6}", 1..8),
        place in any::<prop::sample::Index>(),
        commands in prop::collection::vec((prop::sample::select(vec!["LEFT", "RIGHT", "JUMP", "WAIT"]), -1.5..1.5), 0..200),
    ) {
        let mut rows: Vec<String> = rows;
        let row = place.index(rows.len());
        let column = place.index(rows[row].len() + 1);
        rows[row].insert(column, 's');
        let map = rows.join("\n");
        prop_assert_eq!(run(&map, &commands), described(&map, &commands));
    }

    #[test]
    fn the_fiercest_commands_leave_all_finite(values in prop::collection::vec(-f64::MAX..f64::MAX, 1..100)) {
        let commands: Vec<_> = values.iter().enumerate().map(|(i, &v)| (["RIGHT", "JUMP", "LEFT"][i % 3], v)).collect();
        for (x, y, vx, vy, _) in run("#####\n#.s.#\n#...#\n#####", &commands) {
            prop_assert!(x.is_finite() && y.is_finite() && vx.abs() <= 0.5 && (-0.6..=0.8).contains(&vy));
        }
    }
}

#[test]
fn a_trace_reads_back_to_the_same_bits() {
    let ran = tiles(&data("map.txt"), &data("commands.txt"), &["--trace"]);
    let text = std::fs::read_to_string(data("commands.txt")).unwrap();
    let commands: Vec<(&str, f64)> =
        text.lines().map(|line| line.split_once(' ').unwrap()).map(|(name, value)| (name, value.trim().parse().unwrap())).collect();
    let expected = described(&std::fs::read_to_string(data("map.txt")).unwrap(), &commands);
    let mut lines = ran.out.lines();
    for (index, frame) in expected.iter().enumerate() {
        let cells: Vec<&str> = lines.next().unwrap().split(',').collect();
        let numbers: Vec<f64> = cells[1..5].iter().map(|cell| cell.parse().unwrap()).collect();
        assert_eq!(cells[0], index.to_string());
        assert_eq!(numbers, [frame.0, frame.1, frame.2, frame.3], "frame {index}");
        assert_eq!(cells[5], if frame.4 { "1" } else { "0" });
    }
    // They jump by 0.66 nine times: without the limit on the jump itself the run ends elsewhere.
    assert_eq!(lines.collect::<Vec<_>>(), ["tile 58 2"]);
    assert_eq!(tiles(&data("map.txt"), &data("commands.txt"), &[]).out, "tile 58 2\n");
}

#[test]
fn a_trace_is_written_in_the_shortest_form() {
    let folder = tempfile::tempdir().unwrap();
    let (map, commands) = (folder.path().join("map"), folder.path().join("commands"));
    std::fs::write(&map, "s..\n.").unwrap();
    std::fs::write(&commands, "RIGHT 0.5\nWAIT 0\nLEFT 0.32").unwrap();
    let frames = [
        "0,0.4,0.06,0.4,0.06,0",
        "1,0.7200000000000001,0.18,0.32000000000000006,0.12,0",
        "2,0.7200000000000001,0.36,4.4408920985006264e-17,0.18,0",
        "tile 0 0\n",
    ];
    assert_eq!(tiles(&map, &commands, &["--trace"]).out, frames.join("\n"));
    std::fs::write(&commands, "").unwrap();
    assert_eq!(tiles(&map, &commands, &["--trace"]).out, "tile 0 0\n");
}

#[test]
fn bad_input_is_refused_with_file_and_line_before_any_frame() {
    let folder = tempfile::tempdir().unwrap();
    let (map, commands) = (folder.path().join("map"), folder.path().join("commands"));
    let good: (&[u8], &[u8]) = (b"#s#\n###", b"LEFT 0.1\n");
    let bad_map = |text: &'static [u8]| (text, good.1);
    let bad_commands = |text: &'static [u8]| (good.0, text);
    for ((map_text, command_text), at) in [
        (bad_map(b""), "map:1: the map is empty"),
        (bad_map(b"s.\n.x"), "map:2: column 2: found 'x'"),
        (bad_map(b"s.\n.\xff"), "map:2: found letters that are not UTF-8"),
        (bad_commands(b"LEFT 0.1\nUP 1"), "commands:2: unknown command \"UP\""),
        (bad_commands(b"WAIT x\n"), "commands:1: WAIT: found \"x\""),
    ] {
        std::fs::write(&map, map_text).unwrap();
        std::fs::write(&commands, command_text).unwrap();
        let ran = tiles(&map, &commands, &["--trace"]);
        let expected = folder.path().join(at).display().to_string();
        assert!(ran.err.starts_with(&expected), "{ran:?} should start with {expected:?}");
        assert_eq!((ran.status, ran.out.as_str()), (2, ""), "{at}");
    }
    let missing = tiles(&folder.path().join("none"), &commands, &[]);
    assert_eq!((missing.status, missing.out.as_str()), (2, ""));
}
