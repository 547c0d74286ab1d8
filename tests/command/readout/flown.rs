//! A run with its files read back, and the scenes that are flown.

use crate::support::program::{Data, Ran, resultant};
use crate::support::shipped::fixtures;
use resultant::level::{self, Level};
use resultant::physics::{BodyDef, DVec2, ForceKind};
use std::path::Path;

const INPUTS: &str = "ticks,thrust,reverse,left,right\n";
pub const FAR: (&str, &str) = ("objectives.csv", "PLAYER,10,10,20,20\n");

pub struct Row {
    pub position: DVec2,
    pub velocity: DVec2,
    pub acceleration: DVec2,
    pub resultant: DVec2,
    /// In the order of [`ForceKind::ALL`].
    pub totals: Vec<DVec2>,
    pub impulse: DVec2,
}

impl Row {
    pub fn total(&self, kind: ForceKind) -> DVec2 {
        self.totals[ForceKind::ALL.iter().position(|other| *other == kind).unwrap()]
    }
}

#[derive(Clone, Debug, PartialEq)]
pub struct Acting {
    pub kind: String,
    pub by: String,
    pub vector: DVec2,
    pub point: DVec2,
}

/// A run and its files, by tick and object.
pub struct Flown {
    pub level: Level,
    pub bodies: Vec<BodyDef>,
    pub dt: f64,
    pub ran: Ran,
    pub rows: Vec<Vec<Row>>,
    pub acting: Vec<Vec<Vec<Acting>>>,
}

impl Flown {
    pub fn body(&self, object: usize) -> &BodyDef {
        &self.bodies[object]
    }

    pub fn objects(&self) -> usize {
        self.level.objects.len() + 1
    }

    pub fn all(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        (0..self.rows.len()).flat_map(|tick| (0..self.objects()).map(move |object| (tick, object)))
    }

    pub fn forces(&self, tick: usize, object: usize) -> impl Iterator<Item = &Acting> {
        self.acting[tick][object].iter().filter(|acting| !is_impulse(acting))
    }

    pub fn impacts(&self, tick: usize, object: usize) -> impl Iterator<Item = &Acting> {
        self.acting[tick][object].iter().filter(|acting| is_impulse(acting))
    }
}

fn is_impulse(acting: &Acting) -> bool {
    matches!(&*acting.kind, "impact" | "ended_contact")
}

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

/// A fixture on its careful flight.
pub fn recorded(name: &str) -> Flown {
    let inputs = fixtures().join(format!("levels/{name}/flights/careful.replay.csv"));
    fly(&fixtures(), name, &["--inputs", inputs.to_str().unwrap()])
}

pub fn scene(constants: &str, files: &[(&str, &str)], inputs: &str, seconds: &str) -> Flown {
    scene_at("120", constants, files, inputs, seconds)
}

pub fn scene_at(rate: &str, constants: &str, files: &[(&str, &str)], inputs: &str, seconds: &str) -> Flown {
    let data = Data::new();
    data.level("scene", constants, &[&[FAR], files].concat());
    let inputs = data.write("in.csv", &format!("{INPUTS}{inputs}"));
    fly(&data.path("."), "scene", &["--inputs", &inputs, "--seconds", seconds, "--tick", rate])
}

/// On the floor, the ship, on its side, presses against three crates in a row and burns.
pub fn pushed_row() -> Flown {
    let crates = "540.5,2985,box:30x30,20,1,FALSE,0\n570.5,2985,box:30x30,40,1,FALSE,0\n600.5,2985,box:30x30,10,1,FALSE,0\n";
    let player = "x,y,mass,fuel,thrust,angle\n500,2974.5,100,500,5000,90\n";
    scene("air_density,0\n", &[("player.csv", player), ("objects.csv", crates)], "20,0,0,0,0\n200,1,0,0,0\n", "3")
}

/// Three crates on each other, and on them the ship, whose engine presses it to the right: friction holds them all.
pub fn stack() -> Flown {
    let crates = "1500,2985,box:30x30,30,1,FALSE,0\n1495,2955,box:30x30,20,1,FALSE,0\n1503,2925,box:30x30,500,1,FALSE,0\n";
    let player = "x,y,mass,fuel,thrust,angle\n1500,2884.5,100,500,200,90\n";
    scene("air_density,0\n", &[("player.csv", player), ("objects.csv", crates)], "20,0,0,0,0\n100,1,0,0,0\n", "2")
}

/// Crates meet without gravity: head-on, elastically and not, and glancing.
pub fn collisions() -> Flown {
    let crates = "900,900,box:30x30,75,1,FALSE,1,25.7,0\n1500,900,box:30x30,150,1,FALSE,1,-11.3,0\n\
        900,1200,box:30x30,7,1,FALSE,0.3,9,0\n1000,1210,box:40x60,3,1,FALSE,0.6,-4,1\n1400,1205,box:30x30,30,1,FALSE,0,-8,0.5\n";
    let files = [("player.csv", "1500,1500,100,500,3000\n"), ("objects.csv", crates)];
    scene("air_density,0\ngravity,0\n", &files, "10,0,0,0,0\n", "3")
}

/// Crates bounce on the floor and on a block, and lose speed across by friction.
pub fn bounces() -> Flown {
    let crates = "300,2700,box:30x30,5,1,FALSE,1,3,0\n900,2600,box:30x30,50,1,FALSE,0.5,0,0\n1500,2500,box:60x30,20,1,FALSE,0.8,-2,0\n\
        2100,2550,ball:30x30,1,1,TRUE,0.9,-4,2\n";
    let files = [("player.csv", "2700,1000,100,500,3000\n"), ("objects.csv", crates), ("world.csv", "1400,2900,400,50,Ice\n")];
    scene("air_density,0\n", &files, "10,0,0,0,0\n", "6")
}

/// Crates that float, sink and hang on the surface, and the ship, thrown into a pool.
pub fn splash(rate: &str) -> Flown {
    let crates = "1100,1900,box:30x30,300,1,FALSE,0,2,6\n1300,1800,box:60x30,3000,1,FALSE,0,0,3\n1500,1984,box:30x30,450,0.8,FALSE,0\n\
        1700,1500,ball:30x30,20,0.5,TRUE,0.5,-3,0\n";
    let files = [
        ("player.csv", "1900,1600,100,500,3000\n"),
        ("objects.csv", crates),
        ("fluids.csv", "600,2000,1600,600,900,40\n600,2600,1600,400,1300,5\n"),
    ];
    scene_at(rate, "", &files, "60,0,0,0,0\n60,1,0,0,1\n200,0,0,0,0\n", "4")
}

pub fn assert_close(found: DVec2, expected: DVec2, relative: f64, what: impl Fn() -> String) {
    let scale = found.length().max(expected.length());
    assert!((found - expected).length() <= relative * scale, "{}: {found}, not {expected}", what());
}
