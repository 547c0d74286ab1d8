//! The files of `run` suffice to check the physics: they are held against the laws, force by force and row by row.

mod flown;
mod laws;
mod momentum;

use crate::support::program::Data;
use flown::{Acting, FAR, bounces, collisions, pushed_row, recorded, scene, splash, stack};
use resultant::physics::{DVec2, ForceKind};

#[test]
fn the_rows_of_forces_are_the_columns_of_the_telemetry_and_their_sum_is_the_resultant() {
    for flown in [pushed_row(), stack(), collisions(), bounces(), splash("120"), recorded("1"), recorded("2"), recorded("3")] {
        for (tick, object) in flown.all() {
            let (row, mass) = (&flown.rows[tick][object], flown.body(object).mass);
            let what = || format!("{}, tick {tick}, object {object}", flown.level.name);
            for kind in ForceKind::ALL {
                let name = kind.name().to_lowercase().replace(' ', "_");
                let sum: DVec2 = flown.forces(tick, object).filter(|acting| acting.kind == name).map(|acting| acting.vector).sum();
                assert_eq!(sum, row.total(kind), "{}: {name}", what());
            }
            let felt: DVec2 = flown.impacts(tick, object).map(|acting| acting.vector).sum();
            assert_eq!(felt, row.impulse, "{}", what());
            let sum: DVec2 = flown.forces(tick, object).map(|acting| acting.vector).sum();
            let size: f64 = flown.forces(tick, object).map(|acting| acting.vector.length()).sum();
            assert!((sum - row.resultant).length() <= 1e-9 * size, "{}: {sum} N, not {} N", what(), row.resultant);
            assert!((row.acceleration * mass - row.resultant).length() <= 1e-9 * size, "{}: m·a", what());
        }
    }
}

#[test]
fn what_an_object_does_to_another_it_feels_itself_bit_for_bit() {
    for (flown, kinds) in [
        (pushed_row(), &["push"][..]),
        (stack(), &["reaction", "friction"]),
        (collisions(), &["impact"]),
        (splash("120"), &[]),
        (recorded("2"), &[]),
    ] {
        let mut seen = Vec::new();
        for (tick, object) in flown.all() {
            for acting in &flown.acting[tick][object] {
                let Some(other) = acting.by.strip_prefix("object ") else { continue };
                let other: usize = other.parse().unwrap();
                let by = format!("object {object}");
                let opposite = Acting { by, vector: -acting.vector, ..acting.clone() };
                let count = |rows: &[Acting], wanted: &Acting| rows.iter().filter(|row| *row == wanted).count();
                let (own, others) = (&flown.acting[tick][object], &flown.acting[tick][other]);
                assert_eq!(count(others, &opposite), count(own, acting), "tick {tick}, object {object}: {acting:?}");
                seen.push(acting.kind.as_str());
                // Along gravity one carries the other; side by side they push.
                if acting.kind == "reaction" || acting.kind == "push" {
                    assert_eq!(acting.kind == "reaction", acting.vector.x == 0.0, "tick {tick}, object {object}: {acting:?}");
                }
            }
        }
        for kind in kinds {
            let count = seen.iter().filter(|seen| *seen == kind).count();
            assert!(count >= 2, "{count} rows of {kind} between objects");
        }
    }
}

#[test]
fn what_exerts_a_force_is_named_by_its_row() {
    let crates = "1500,2955,box:30x30,5,1,FALSE,0\n500,2985,box:30x30,5,1,FALSE,0\n2000,2885,box:30x30,5,1,FALSE,0\n\
        2600,2985,box:30x30,900,1,FALSE,0\n";
    let flown = scene(
        "",
        &[
            ("player.csv", "x,y,mass,fuel,thrust,angle\n25.5,2974.5,100,500,3000,270\n"),
            ("objects.csv", crates),
            ("world.csv", "# first\n1000,100,30,30,Ice\n1400,2970,200,30,Ice\n"),
            ("hazards.csv", "100,100,30,30,0,300,0,50\n1900,2900,200,60,0,-400,0,-20\n"),
            ("fluids.csv", "2500,2900,200,100,500,1\n"),
        ],
        "30,1,0,0,0\n",
        "0.25",
    );
    let by = |object: usize| {
        let last = flown.rows.len() - 1;
        let mut names: Vec<(&str, &str)> = flown.forces(last, object).map(|acting| (&*acting.kind, &*acting.by)).collect();
        names.sort_unstable();
        names
    };
    assert_eq!(by(0), [("drive", "engine"), ("reaction", "edge bottom"), ("reaction", "edge left"), ("weight", "gravity")]);
    assert_eq!(by(1), [("reaction", "world 2"), ("weight", "gravity")]);
    assert_eq!(by(3), [("reaction", "hazard 2"), ("weight", "gravity"), ("wind", "stream 2")]);
    assert_eq!(by(4), [("buoyancy", "fluid 1"), ("reaction", "edge bottom"), ("weight", "gravity")]);
    // A contact acts at the middle of the shared edge, every other force at the centre.
    let last = flown.rows.len() - 1;
    for acting in flown.forces(last, 1) {
        let below = if acting.kind == "reaction" { 99.0 } else { 98.5 };
        assert_eq!(acting.point, DVec2::new(50.0, below), "{acting:?}");
    }
}

#[test]
fn every_guard_is_counted_behind_the_other_keys() {
    let data = Data::new();
    data.level("scene", "", &[FAR, ("player.csv", "1500,1500,100,500,3000\n")]);
    let keys = |args: &[&str]| -> Vec<String> {
        let ran = data.resultant(&[&["run", "scene", "--seconds", "0.1"], args].concat());
        ran.out.lines().map(|line| line.split_once('=').unwrap().0.to_owned()).collect()
    };
    let (plain, told) = (keys(&[]), keys(&["--diagnostics"]));
    assert_eq!(told[..plain.len()], plain);
    assert!(told.len() > plain.len() && told[plain.len()..].iter().all(|key| key.starts_with("guard_")), "{told:?}");
    let ran = stack().ran;
    assert!(told[plain.len()..].iter().all(|guard| ran.value(guard) == "0"), "a stack at rest: {}", ran.out);
}
