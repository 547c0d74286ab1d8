//! The scenes whose answers are known exactly. `tests/engine/exact.rs` holds the engine to the answers, `tests/engine/differential.rs` holds its two
//! methods against each other.

use super::build::{G, area};
use resultant::physics::{BodyDef, DVec2, Material, SurfaceDef, WorldDef};

/// A scene, and the drive of its first body, N.
#[derive(Clone, Debug)]
pub struct Scene {
    pub name: String,
    pub def: WorldDef,
    pub drive: DVec2,
    /// How long it is looked at, s.
    pub seconds: f64,
}

fn scene(name: impl Into<String>, def: WorldDef, drive: DVec2, seconds: f64) -> Scene {
    Scene { name: name.into(), def, drive, seconds }
}

/// 1 m × 1 m, standing on y = 0; its mass in kg.
pub fn standing(x: f64, mass: f64) -> BodyDef {
    BodyDef { position: DVec2::new(x, -0.5), mass, ..BodyDef::default() }
}

pub fn on_a_floor(bodies: Vec<BodyDef>, rest_speed: f64) -> WorldDef {
    WorldDef { air_density: 0.0, rest_speed, bodies, surfaces: vec![super::floor(Material::ASPHALT)], ..WorldDef::default() }
}

pub fn thrown() -> WorldDef {
    let body = BodyDef { velocity: DVec2::new(7.0, -20.0), ..BodyDef::default() };
    WorldDef { air_density: 0.0, bodies: vec![body], ..WorldDef::default() }
}

pub fn slide() -> WorldDef {
    on_a_floor(vec![BodyDef { velocity: DVec2::new(9.6, 0.0), ..standing(0.0, 75.0) }], 1.0)
}

/// A body of 5 kg that slides through air with 30 m/s.
pub fn slide_in_air() -> WorldDef {
    let body = BodyDef { velocity: DVec2::new(30.0, 0.0), ..standing(0.0, 5.0) };
    WorldDef { rest_speed: 0.0, bodies: vec![body], surfaces: vec![super::floor(Material::ASPHALT)], ..WorldDef::default() }
}

/// 10 kg on the floor, and a drive of this part of the limit of static friction, N.
pub fn held_by_the_floor(part: f64) -> (WorldDef, DVec2) {
    (on_a_floor(vec![standing(0.0, 10.0)], 1.0), DVec2::new(part * 0.9 * 10.0 * G, 0.0))
}

/// 10 kg against a wall, and the drive at which its weight is this part of the limit of static friction, N.
pub fn held_by_a_wall(part: f64) -> (WorldDef, DVec2) {
    let wall = SurfaceDef::fixed(area(0.0, -100.0, 1.0, 100.0), Material::ASPHALT);
    let body = BodyDef { position: DVec2::new(-0.5, 0.0), mass: 10.0, ..BodyDef::default() };
    let def = WorldDef { air_density: 0.0, bodies: vec![body], surfaces: vec![wall], ..WorldDef::default() };
    (def, DVec2::new(10.0 * G / (part * 0.9), 0.0))
}

/// A body that falls on the floor from a height (m) and bounces.
fn bouncing(restitution: f64, height: f64, rest_speed: f64) -> WorldDef {
    on_a_floor(vec![BodyDef { position: DVec2::new(0.0, -0.5 - height), restitution, ..BodyDef::default() }], rest_speed)
}

/// One elastic block on its way to a row of others, without weight.
fn cradle(count: usize) -> WorldDef {
    let mut bodies: Vec<_> =
        (0..count).map(|i| BodyDef { position: DVec2::new(i as f64, 0.0), restitution: 1.0, ..BodyDef::default() }).collect();
    bodies[0].position.x = -1.0;
    bodies[0].velocity.x = 3.0;
    WorldDef { gravity: 0.0, air_density: 0.0, bodies, ..WorldDef::default() }
}

/// A column of blocks of 1 to 5 kg.
pub fn column(count: usize) -> WorldDef {
    let body =
        |i: usize| BodyDef { position: DVec2::new(0.0, -0.5 - i as f64), mass: 1.0 + (i * 7 % 5) as f64, ..BodyDef::default() };
    on_a_floor((0..count).map(body).collect(), 1.0)
}

/// Ten tonnes that rest on a kilogram, or drop on it.
pub fn ten_tonnes(drop: f64) -> WorldDef {
    let heavy = BodyDef { position: DVec2::new(0.0, -1.5 - drop), mass: 10_000.0, ..BodyDef::default() };
    on_a_floor(vec![standing(0.0, 1.0), heavy], 1.0)
}

/// A block of 100 kg behind a row of others, and the drive with which it pushes them, N.
pub fn pushed_row(count: usize) -> (WorldDef, DVec2) {
    let mut bodies = vec![standing(0.0, 100.0)];
    bodies.extend((1..=count).map(|i| standing(i as f64, 10.0 + i as f64)));
    let total: f64 = bodies.iter().map(|body| body.mass).sum();
    (on_a_floor(bodies, 1.0), DVec2::new(1.5 * 0.9 * total * G, 0.0))
}

/// A dart of 5 cm on its way to a wall of 5 cm.
pub fn dart_and_wall(speed: f64) -> WorldDef {
    let wall = SurfaceDef::fixed(area(10.0, -5.0, 10.05, 5.0), Material::STEEL);
    let dart = BodyDef { velocity: DVec2::new(speed, 0.0), half: DVec2::splat(0.025), ..BodyDef::default() };
    WorldDef { gravity: 0.0, air_density: 0.0, surfaces: vec![wall], bodies: vec![dart], ..WorldDef::default() }
}

/// The same dart on its way to 3 kg of 5 cm.
pub fn dart_and_target(speed: f64) -> WorldDef {
    let mut def = dart_and_wall(speed);
    def.surfaces.clear();
    let half = DVec2::new(0.025, 0.5);
    def.bodies.push(BodyDef { position: DVec2::new(10.0, 0.0), half, mass: 3.0, ..BodyDef::default() });
    def
}

pub fn exact_scenes() -> Vec<Scene> {
    let none = DVec2::ZERO;
    let mut scenes = vec![
        scene("thrown", thrown(), none, 4.0),
        scene("slide", slide(), none, 3.0),
        scene("slide in air", slide_in_air(), none, 6.0),
        scene("bounces that end", bouncing(0.9, 1.0, 0.0), none, 8.0),
        scene("bounces without end", bouncing(1.0, 1.0, 1.0), none, 60.0),
    ];
    for part in [0.99, 1.02] {
        let ((floor, push), (wall, press)) = (held_by_the_floor(part), held_by_a_wall(part));
        scenes.push(scene(format!("{part} of what a floor holds"), floor, push, 10.0));
        scenes.push(scene(format!("{part} of what a wall holds"), wall, press, 2.0));
    }
    scenes.extend([3, 5, 10].map(|n| scene(format!("cradle of {n}"), cradle(n), none, 1.0)));
    scenes.extend([10, 30, 100].map(|n| scene(format!("column of {n}"), column(n), none, 3.0)));
    scenes.extend([0.0, 2.0].map(|drop| scene(format!("ten tonnes from {drop} m"), ten_tonnes(drop), none, 5.0)));
    for count in [1, 5, 20] {
        let (row, push) = pushed_row(count);
        scenes.push(scene(format!("pushed row of {count}"), row, push, 1.0));
    }
    for speed in [10.0, 36.0, 400.0, 8_333.0, 1e6] {
        scenes.push(scene(format!("dart and wall at {speed} m/s"), dart_and_wall(speed), none, 2.0));
        scenes.push(scene(format!("dart and target at {speed} m/s"), dart_and_target(speed), none, 2.0));
    }
    scenes
}
