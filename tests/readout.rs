//! What `run` writes down is enough to check the physics with: its own files are held against the laws, force by force and row by row.

mod program;

use program::{Data, Ran, resultant};
use resultant::level::{self, Level};
use resultant::physics::{Aabb, BodyDef, DVec2, ForceKind};
use std::path::Path;

const INPUTS: &str = "ticks,thrust,reverse,left,right\n";
const FAR: (&str, &str) = ("objectives.csv", "PLAYER,10,10,20,20\n");

/// A row of the telemetry.
struct Row {
    position: DVec2,
    velocity: DVec2,
    acceleration: DVec2,
    resultant: DVec2,
    /// In the order of [`ForceKind::ALL`].
    totals: Vec<DVec2>,
    impulse: DVec2,
}

impl Row {
    fn total(&self, kind: ForceKind) -> DVec2 {
        self.totals[ForceKind::ALL.iter().position(|other| *other == kind).unwrap()]
    }
}

/// A row of the file of forces.
#[derive(Clone, Debug, PartialEq)]
struct Acting {
    kind: String,
    by: String,
    vector: DVec2,
    point: DVec2,
}

/// A run and its files, by tick and object.
struct Flown {
    level: Level,
    bodies: Vec<BodyDef>,
    dt: f64,
    ran: Ran,
    rows: Vec<Vec<Row>>,
    acting: Vec<Vec<Vec<Acting>>>,
}

impl Flown {
    /// An object as it began.
    fn body(&self, object: usize) -> &BodyDef {
        &self.bodies[object]
    }

    fn objects(&self) -> usize {
        self.level.objects.len() + 1
    }

    /// Every tick and object.
    fn all(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        (0..self.rows.len()).flat_map(|tick| (0..self.objects()).map(move |object| (tick, object)))
    }

    fn forces(&self, tick: usize, object: usize) -> impl Iterator<Item = &Acting> {
        self.acting[tick][object].iter().filter(|acting| acting.kind != "impact")
    }

    fn impacts(&self, tick: usize, object: usize) -> impl Iterator<Item = &Acting> {
        self.acting[tick][object].iter().filter(|acting| acting.kind == "impact")
    }
}

/// Flies a level of a data folder and reads what was written.
fn fly(root: &Path, name: &str, args: &[&str]) -> Flown {
    let level = level::load(&root.join("levels").join(name), root).expect("the level loads").level;
    let out = tempfile::tempdir().unwrap();
    let (telemetry, forces) = (out.path().join("telemetry.csv"), out.path().join("forces.csv"));
    let mut command = resultant();
    command.arg("--data").arg(root).args(["run", name, "--diagnostics"]).args(args);
    let ran = Ran::new(command.arg("--telemetry").arg(&telemetry).arg("--forces").arg(&forces));
    assert_eq!(ran.status, 0, "{}", ran.err);
    let (telemetry, forces) = (std::fs::read_to_string(telemetry).unwrap(), std::fs::read_to_string(forces).unwrap());
    let vector = |cells: &[&str], at: usize| DVec2::new(cells[at].parse().unwrap(), cells[at + 1].parse().unwrap());
    let cut = |line: &'static str| line.split(',').collect::<Vec<_>>();
    let telemetry: &'static str = Box::leak(telemetry.into_boxed_str());
    let forces: &'static str = Box::leak(forces.into_boxed_str());

    let header = cut(telemetry.lines().next().unwrap());
    assert_eq!(header[header.len() - 2..], ["impulse_x", "impulse_y"]);
    let (mut rows, mut dt): (Vec<Vec<Row>>, f64) = (Vec::new(), 0.0);
    for cells in telemetry.lines().skip(1).map(cut) {
        let tick: usize = cells[0].parse().unwrap();
        rows.resize_with(rows.len().max(tick + 1), Vec::new);
        if tick == 1 {
            dt = cells[1].parse().unwrap();
        }
        rows[tick].push(Row {
            position: vector(&cells, 4),
            velocity: vector(&cells, 6),
            acceleration: vector(&cells, 8),
            resultant: vector(&cells, 12),
            totals: (0..ForceKind::ALL.len()).map(|i| vector(&cells, 14 + 2 * i)).collect(),
            impulse: vector(&cells, header.len() - 2),
        });
    }

    assert_eq!(forces.lines().next(), Some("tick,time,object,kind,by,x,y,point_x,point_y"));
    let mut acting = vec![vec![Vec::new(); level.objects.len() + 1]; rows.len()];
    for cells in forces.lines().skip(1).map(cut) {
        let (tick, object): (usize, usize) = (cells[0].parse().unwrap(), cells[2].parse().unwrap());
        acting[tick][object].push(Acting {
            kind: cells[3].into(),
            by: cells[4].into(),
            vector: vector(&cells, 5),
            point: vector(&cells, 7),
        });
    }
    Flown { bodies: level.world_def().bodies, level, dt, ran, rows, acting }
}

/// The shipped levels, flown by their recorded inputs.
fn shipped(name: &str) -> Flown {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let inputs = root.join(format!("tests/inputs/{name}.csv"));
    fly(root, name, &["--inputs", inputs.to_str().unwrap()])
}

/// Flies one level of a few files.
fn scene(constants: &str, files: &[(&str, &str)], inputs: &str, seconds: &str) -> Flown {
    scene_at("120", constants, files, inputs, seconds)
}

/// The same at so many ticks a second.
fn scene_at(rate: &str, constants: &str, files: &[(&str, &str)], inputs: &str, seconds: &str) -> Flown {
    let data = Data::new();
    data.level("scene", constants, &[&[FAR], files].concat());
    let inputs = data.write("in.csv", &format!("{INPUTS}{inputs}"));
    fly(&data.path("."), "scene", &["--inputs", &inputs, "--seconds", seconds, "--tick", rate])
}

/// On the floor, the ship, on its side, presses against three crates in a row and burns.
fn pushed_row() -> Flown {
    let crates = "540.5,2985,box:30x30,20,1,FALSE,0\n570.5,2985,box:30x30,40,1,FALSE,0\n600.5,2985,box:30x30,10,1,FALSE,0\n";
    let player = "x,y,mass,fuel,thrust,angle\n500,2974.5,100,500,5000,90\n";
    scene("air_density,0\n", &[("player.csv", player), ("objects.csv", crates)], "20,0,0,0,0\n200,1,0,0,0\n", "3")
}

/// Three crates on each other, and on them the ship, whose engine presses it to the right: friction holds them all.
fn stack() -> Flown {
    let crates = "1500,2985,box:30x30,30,1,FALSE,0\n1495,2955,box:30x30,20,1,FALSE,0\n1503,2925,box:30x30,500,1,FALSE,0\n";
    let player = "x,y,mass,fuel,thrust,angle\n1500,2884.5,100,500,200,90\n";
    scene("air_density,0\n", &[("player.csv", player), ("objects.csv", crates)], "20,0,0,0,0\n100,1,0,0,0\n", "2")
}

/// Crates meet without gravity: head-on, elastically and not, and glancing.
fn collisions() -> Flown {
    let crates = "900,900,box:30x30,75,1,FALSE,1,25.7,0\n1500,900,box:30x30,150,1,FALSE,1,-11.3,0\n\
        900,1200,box:30x30,7,1,FALSE,0.3,9,0\n1000,1210,box:40x60,3,1,FALSE,0.6,-4,1\n1400,1205,box:30x30,30,1,FALSE,0,-8,0.5\n";
    let files = [("player.csv", "1500,1500,100,500,3000\n"), ("objects.csv", crates)];
    scene("air_density,0\ngravity,0\n", &files, "10,0,0,0,0\n", "3")
}

/// Crates bounce on the floor and on a block, and lose speed across by friction.
fn bounces() -> Flown {
    let crates = "300,2700,box:30x30,5,1,FALSE,1,3,0\n900,2600,box:30x30,50,1,FALSE,0.5,0,0\n1500,2500,box:60x30,20,1,FALSE,0.8,-2,0\n\
        2100,2550,ball:30x30,1,1,TRUE,0.9,-4,2\n";
    let files = [("player.csv", "2700,1000,100,500,3000\n"), ("objects.csv", crates), ("world.csv", "1400,2900,400,50,Ice\n")];
    scene("air_density,0\n", &files, "10,0,0,0,0\n", "6")
}

/// Crates that float, sink and hang on the surface, and the ship, thrown into a pool.
fn splash(rate: &str) -> Flown {
    let crates = "1100,1900,box:30x30,300,1,FALSE,0,2,6\n1300,1800,box:60x30,3000,1,FALSE,0,0,3\n1500,1984,box:30x30,450,0.8,FALSE,0\n\
        1700,1500,ball:30x30,20,0.5,TRUE,0.5,-3,0\n";
    let files = [
        ("player.csv", "1900,1600,100,500,3000\n"),
        ("objects.csv", crates),
        ("fluids.csv", "600,2000,1600,600,900,40\n600,2600,1600,400,1300,5\n"),
    ];
    scene_at(rate, "", &files, "60,0,0,0,0\n60,1,0,0,1\n200,0,0,0,0\n", "4")
}

fn assert_close(found: DVec2, expected: DVec2, relative: f64, what: impl Fn() -> String) {
    let scale = found.length().max(expected.length());
    assert!((found - expected).length() <= relative * scale, "{}: {found}, not {expected}", what());
}

// What is written adds up

#[test]
fn the_rows_of_forces_are_the_columns_of_the_telemetry_and_their_sum_is_the_resultant() {
    for flown in [pushed_row(), stack(), collisions(), bounces(), splash("120"), shipped("1"), shipped("2"), shipped("3")] {
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
        (shipped("2"), &[]),
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

// Momentum

/// The forces at the start of a tick and at its end, if they are the same but for the engine, which is switched at the start, and for
/// those that vary within a tick.
fn same_laws<'a>(flown: &'a Flown, tick: usize, object: usize, alike: impl Fn(&Acting, &Acting) -> bool + 'a) -> bool {
    let all = |tick: usize| flown.forces(tick, object).filter(|acting| acting.kind != "drive");
    all(tick - 1).count() == all(tick).count() && all(tick - 1).zip(all(tick)).all(|(a, b)| alike(a, b))
}

/// m·Δv = F·Δt + impulses in every tick whose forces are the same at both ends: in free flight also where impacts fall into it.
#[test]
fn constant_forces_and_impacts_change_the_momentum_by_just_what_they_say() {
    for (name, flown, least) in
        [("row", pushed_row(), 0.9), ("stack", stack(), 0.95), ("collisions", collisions(), 0.99), ("bounces", bounces(), 0.9)]
    {
        let (mut held, mut with_impacts, mut all, mut worst) = (0, 0, 0, 0.0_f64);
        for (tick, object) in flown.all().filter(|(tick, _)| *tick > 0) {
            all += 1;
            let (before, after) = (&flown.rows[tick - 1][object], &flown.rows[tick][object]);
            let close = |a: &Acting, b: &Acting| {
                a.kind == b.kind && a.by == b.by && (a.vector - b.vector).length() <= 1e-12 * a.vector.length()
            };
            let in_contact = flown.forces(tick, object).any(|acting| matches!(&*acting.kind, "reaction" | "push"));
            let hit = flown.impacts(tick, object).next().is_some();
            if !same_laws(&flown, tick, object, close) || (hit && in_contact) {
                continue;
            }
            held += 1;
            with_impacts += usize::from(hit);
            let mass = flown.body(object).mass;
            let gained = (after.velocity - before.velocity) * mass;
            let given = after.resultant * flown.dt + after.impulse;
            let size = mass * before.velocity.length().max(after.velocity.length())
                + flown.forces(tick, object).map(|acting| acting.vector.length()).sum::<f64>() * flown.dt;
            let error = (gained - given).length() / size.max(f64::MIN_POSITIVE);
            worst = worst.max(error);
            assert!(error <= 1e-9, "{name}, tick {tick}, object {object}: m·Δv = {gained}, F·Δt + J = {given}");
        }
        println!("{name}: {held} of {all} ticks, {with_impacts} with impacts, at worst {worst:e}");
        assert!(held as f64 >= least * all as f64, "{name}: only {held} of {all} ticks");
        assert!(with_impacts > 0 || !matches!(name, "collisions" | "bounces"));
    }
}

/// For each liquid, whether the object is out of it, in part or all inside: where that changes its forces have a corner, as they have where
/// a velocity changes its sign.
fn wet(flown: &Flown, object: usize, row: &Row) -> Vec<(bool, bool)> {
    let (half, position) = (flown.body(object).half, row.position);
    let gap = |zone: &Aabb| (position - zone.centre()).abs() - zone.size() * 0.5;
    let wet = |zone: &Aabb| ((gap(zone) - half).max_element() < 0.0, (gap(zone) + half).max_element() < 0.0);
    flown.level.fluids.iter().map(|fluid| wet(&fluid.zone)).collect()
}

/// m·Δv = ∫F dt + impulses over pairs of ticks whose forces are of the same kinds: Simpson's rule is closer to it than the trapezium, whose
/// distance from Simpson's is the bound; and over all that the error of Simpson's rule is small.
#[test]
fn drag_and_buoyancy_change_the_momentum_by_their_integral() {
    for (name, flown, bound) in [
        ("splash", splash("1200"), 1e-4),
        ("level 1", shipped("1"), 1e-6),
        ("level 2", shipped("2"), 1e-6),
        ("level 3", shipped("3"), 1e-3),
    ] {
        let (mut held, mut all, mut worst) = (0, 0, 0.0_f64);
        for (tick, object) in flown.all().filter(|(tick, _)| *tick > 1) {
            all += 1;
            let [first, middle, last] = [2, 1, 0].map(|back| &flown.rows[tick - back][object]);
            let contact = |acting: &Acting| matches!(&*acting.kind, "reaction" | "friction" | "push" | "impact");
            let named = |a: &Acting, b: &Acting| a.kind == b.kind && a.by == b.by;
            let touched = [2, 1, 0].iter().any(|back| flown.acting[tick - back][object].iter().any(contact));
            let drive = ForceKind::Drive;
            if touched
                || (first.velocity * last.velocity).min_element() < 0.0
                || wet(&flown, object, first) != wet(&flown, object, middle)
                || wet(&flown, object, middle) != wet(&flown, object, last)
                || !same_laws(&flown, tick - 1, object, named)
                || !same_laws(&flown, tick, object, named)
                || middle.total(drive) != last.total(drive)
            {
                continue;
            }
            held += 1;
            let mass = flown.body(object).mass;
            // The engine was switched at the first row: what counts is how it burns from there on.
            let start = first.resultant - first.total(drive) + middle.total(drive);
            let (dt, gained) = (flown.dt, (last.velocity - first.velocity) * mass);
            let simpson = (start + middle.resultant * 4.0 + last.resultant) * (dt / 3.0);
            let trapezium = (start + middle.resultant * 2.0 + last.resultant) * (dt / 2.0);
            let size = mass * last.velocity.length() + flown.forces(tick, object).map(|a| a.vector.length()).sum::<f64>() * dt;
            let error = (gained - simpson).length();
            worst = worst.max(error / size);
            assert!(
                error <= (simpson - trapezium).length() + 1e-9 * size,
                "{name}, tick {tick}, object {object}: m·Δv = {gained}, Simpson {simpson}, trapezium {trapezium}"
            );
        }
        println!("{name}: {held} of {all} ticks, at worst {worst:e}");
        assert!(held > 400 && worst <= bound, "{name}: {held} of {all} ticks, at worst {worst:e}");
    }
}

// Laws

/// The area that a body shows to a medium, times its speed u: w·|u_y| + h·|u_x| for boxes, d·|u| for round things.
fn area_times_speed(body: &BodyDef, u: DVec2) -> f64 {
    let (w, h) = (2.0 * body.half.x, 2.0 * body.half.y);
    if body.round { 0.5 * (w + h) * u.length() } else { w * u.y.abs() + h * u.x.abs() }
}

/// What the liquids do to an object by README's laws: the part of it that is dry, buoyancy and viscous drag.
fn baths(flown: &Flown, object: usize, row: &Row) -> (f64, DVec2, DVec2) {
    let (body, gravity, u) = (flown.body(object), flown.level.gravity, row.velocity);
    let (mass, half, drag) = (body.mass, body.half, body.drag);
    let (mut dry, mut buoyancy, mut viscous) = (1.0, DVec2::ZERO, DVec2::ZERO);
    for fluid in &flown.level.fluids {
        let (top_left, bottom_right) = (row.position - half, row.position + half);
        let inside = (bottom_right.min(fluid.zone.max) - top_left.max(fluid.zone.min)).max(DVec2::ZERO);
        let (volume, fraction) = (inside.x * inside.y, inside.x * inside.y / (4.0 * half.x * half.y));
        if volume == 0.0 {
            continue;
        }
        dry -= fraction;
        buoyancy.y -= fluid.density * gravity * volume;
        let quadratic = 0.5 * fluid.density * drag * area_times_speed(body, u) * fraction;
        let stokes = 3.0 * std::f64::consts::PI * fluid.viscosity * (half.x + half.y) * fraction;
        let out = (fluid.zone.min.y - top_left.y) / (2.0 * half.y);
        let waves = if out > 0.0 {
            let displaced = fluid.density * volume / mass;
            let fades = 1.0 - (1.0 - out).powi(8);
            0.3 * drag * (fluid.density * gravity * inside.x * mass).sqrt() * (2.0 * displaced / (1.0 + displaced)) * fades
        } else {
            0.0
        };
        viscous -= u * (quadratic + stokes) + DVec2::new(0.0, u.y * waves);
    }
    (dry, buoyancy, viscous)
}

/// Each force of the media, of every row, by its law at the row's own place and velocity.
#[test]
fn every_row_obeys_the_laws_at_its_own_place_and_velocity() {
    let mut seen = std::collections::BTreeMap::new();
    for flown in [splash("120"), bounces(), shipped("1"), shipped("2"), shipped("3")] {
        let (level, air) = (&flown.level, flown.level.air_density);
        for (tick, object) in flown.all() {
            let (row, body) = (&flown.rows[tick][object], flown.body(object));
            let (mass, half, drag) = (body.mass, body.half, body.drag);
            let what = |kind: ForceKind| format!("{}, tick {tick}, object {object}, {}", level.name, kind.name());
            let u = row.velocity;
            let (dry, buoyancy, viscous) = baths(&flown, object, row);
            let feels_air = object > 0 || level.player.feels_air;
            let shown = area_times_speed(body, u);
            let resistance = if feels_air { -u * (0.5 * air * drag * shown * f64::max(dry, 0.0)) } else { DVec2::ZERO };
            for (kind, law) in [
                (ForceKind::Weight, DVec2::new(0.0, mass * level.gravity)),
                (ForceKind::AirResistance, resistance),
                (ForceKind::Buoyancy, buoyancy),
                (ForceKind::ViscousDrag, viscous),
            ] {
                assert_close(row.total(kind), law, 1e-11, || what(kind));
                *seen.entry(kind.name()).or_insert(0) += usize::from(law != DVec2::ZERO);
            }
            // In a stream for certain, or outside for certain; at its very edge it depends on whether the object is leaving.
            for (index, stream) in level.streams.iter().enumerate() {
                let by = format!("stream {}", index + 1);
                let felt: Vec<&Acting> = flown.forces(tick, object).filter(|acting| acting.by == by).collect();
                let gap = (row.position - stream.zone.centre()).abs() - half - stream.zone.size() * 0.5;
                match gap.max_element() {
                    gap if gap < -1e-6 => assert_eq!(felt.len(), 1, "{}", what(ForceKind::Wind)),
                    gap if gap > 1e-6 => assert_eq!(felt.len(), 0, "{}", what(ForceKind::Wind)),
                    _ => {}
                }
                assert!(felt.iter().all(|acting| acting.vector == stream.force && acting.kind == "wind"));
                *seen.entry("Wind").or_insert(0) += felt.len();
            }
        }
    }
    println!("{seen:?}");
    assert!(seen.len() == 5 && seen.values().all(|rows| *rows > 500), "{seen:?}");
}

// Names

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
    // Contacts are told at the middle of the edge that they share, other forces at the centre.
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
