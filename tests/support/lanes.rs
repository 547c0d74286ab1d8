//! Random scenes of one law each: one or a few bodies that slide, land, bounce, push, ride, are blown or float, on ground of any material.

use super::build::{G, area};
use super::random::Random;
use super::scenes::Scene;
use resultant::physics::{BodyDef, DVec2, FluidDef, Material, Path, StreamDef, SurfaceDef, WorldDef};

/// A law.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lane {
    Slide,
    Landing,
    Bounces,
    Stack,
    Row,
    Belt,
    Lift,
    Platform,
    PushingWall,
    PressedToAWall,
    SlideThroughStreams,
    FlightThroughStreams,
    SlideInAir,
    SlideUnderWater,
    Afloat,
    Table,
}

impl Lane {
    pub fn scene(self, seed: u64) -> Scene {
        let mut random = Random(seed);
        let ground = SurfaceDef::fixed(area(-1000.0, 0.0, 1000.0, 1.0), random.pick(&Material::FIRM));
        let def = WorldDef { air_density: 0.0, rest_speed: 0.0, surfaces: vec![ground], ..WorldDef::default() };
        let mut scene = Scene { name: format!("{self:?} {seed}"), def, drive: DVec2::ZERO, seconds: 2.0 };
        self.fill(&mut scene, &mut random);
        scene
    }

    fn fill(self, Scene { def, drive, .. }: &mut Scene, random: &mut Random) {
        match self {
            Self::Slide => {
                let first = body(random, 0.0, 0.0);
                *drive = DVec2::new(random.between(-2.0, 2.0) * first.mass * G, 0.0);
                def.bodies.push(BodyDef { velocity: DVec2::new(random.between(-9.0, 9.0), 0.0), ..first });
            }
            Self::Landing | Self::Bounces => {
                let height = random.between(0.1, 3.0);
                let restitution = if self == Self::Bounces { random.between(0.1, 1.0) } else { 0.0 };
                let velocity = DVec2::new(random.between(-9.0, 9.0), 0.0);
                def.bodies.push(BodyDef { velocity, restitution, ..body(random, 0.0, height) });
            }
            Self::Stack => {
                stack(def, random, 3);
                let mass: f64 = def.bodies.iter().map(|body| body.mass).sum();
                *drive = DVec2::new(random.between(-1.5, 1.5) * mass * G, 0.0);
            }
            Self::Row => row(def, random),
            Self::Belt => {
                def.surfaces[0].belt = random.between(-5.0, 5.0);
                def.bodies.push(BodyDef { velocity: DVec2::new(random.between(-5.0, 5.0), 0.0), ..body(random, 0.0, 0.0) });
            }
            Self::Lift => {
                let way = DVec2::new(0.0, -random.between(1.0, 4.0));
                def.surfaces[0].path =
                    Path::shuttle(way, random.between(1.5, 3.0), random.between(0.3, 0.7), random.between(0.01, 0.3));
                stack(def, random, 2);
            }
            Self::Platform => {
                let way = DVec2::new(random.between(-6.0, 6.0), 0.0);
                def.surfaces[0].path =
                    Path::shuttle(way, random.between(1.5, 3.0), random.between(0.1, 0.7), random.between(0.01, 0.3));
                stack(def, random, 2);
            }
            Self::PushingWall => {
                let path = Path::steady(DVec2::new(random.between(1.0, 8.0), 0.0));
                let wall = SurfaceDef::fixed(area(-4.0, -6.0, -3.0, -0.001), random.pick(&Material::FIRM));
                def.surfaces.push(SurfaceDef { path, ..wall });
                let restitution = if random.chance(0.5) { 0.0 } else { random.unit() };
                def.bodies.push(BodyDef { restitution, ..body(random, 0.0, 0.0) });
            }
            Self::PressedToAWall => {
                let first = body(random, 0.0, 2.0);
                let wall = area(first.half.x, -60.0, first.half.x + 1.0, 0.0);
                def.surfaces.push(SurfaceDef::fixed(wall, random.pick(&Material::FIRM)));
                *drive = DVec2::new(random.between(0.5, 3.0) * first.mass * G, 0.0);
                def.bodies.push(first);
            }
            Self::SlideThroughStreams | Self::FlightThroughStreams => {
                let (height, rise) = if self == Self::SlideThroughStreams { (0.0, 0.0) } else { (3.0, -5.0) };
                let first = body(random, 0.0, height);
                for k in 0..3 {
                    let left = 1.0 + 2.0 * f64::from(k) + random.unit();
                    let zone = area(left, -40.0, left + random.between(0.3, 1.0), 0.0);
                    let force = DVec2::new(random.between(-1.0, 1.0), random.between(-0.8, 0.0)) * first.mass * G;
                    def.streams.push(StreamDef { zone, force });
                }
                def.bodies.push(BodyDef { velocity: DVec2::new(random.between(2.0, 9.0), rise), ..first });
            }
            Self::SlideInAir => {
                def.air_density = 1.2041;
                def.bodies.push(BodyDef { velocity: DVec2::new(random.between(-30.0, 30.0), 0.0), ..body(random, 0.0, 0.0) });
            }
            Self::SlideUnderWater | Self::Afloat => {
                let zone = area(-1000.0, -8.0, 1000.0, 0.0);
                def.fluids.push(FluidDef { zone, density: 1000.0, viscosity: random.decades(-3.0, 1.0) });
                let sinks = self == Self::SlideUnderWater;
                let (height, speed) = if sinks { (0.0, 4.0) } else { (4.0, 0.0) };
                let first = body(random, 0.0, height);
                let density = if sinks { random.between(1300.0, 5000.0) } else { random.between(100.0, 900.0) };
                let mass = density * 4.0 * first.half.x * first.half.y;
                def.bodies.push(BodyDef { mass, velocity: DVec2::new(speed, 0.0), ..first });
            }
            Self::Table => {
                def.surfaces.push(SurfaceDef::fixed(area(-5.0, -3.0, 0.5, -2.5), random.pick(&Material::FIRM)));
                def.bodies.push(BodyDef { velocity: DVec2::new(random.between(3.0, 6.0), 0.0), ..body(random, 0.0, 3.0) });
            }
        }
    }
}

/// Any body, its bottom edge so high above y = 0.
fn body(random: &mut Random, x: f64, height: f64) -> BodyDef {
    let half = DVec2::new(random.between(0.2, 0.6), random.between(0.2, 0.6));
    let mass = random.decades(0.0, 1.0);
    BodyDef { position: DVec2::new(x, -half.y - height), half, mass, material: random.pick(&Material::FIRM), ..BodyDef::default() }
}

/// A stack of `count` bodies.
fn stack(def: &mut WorldDef, random: &mut Random, count: usize) {
    let mut height = 0.0;
    for _ in 0..count {
        let next = body(random, 0.0, height);
        height += 2.0 * next.half.y;
        def.bodies.push(next);
    }
}

/// One that comes, and three that touch.
fn row(def: &mut WorldDef, random: &mut Random) {
    let restitution = if random.chance(0.5) { 0.0 } else { random.unit() };
    let mut left = 0.0;
    for i in 0..4 {
        let next = body(random, 0.0, 0.0);
        let position = DVec2::new(left + next.half.x, next.position.y);
        let velocity = DVec2::new(if i == 0 { random.between(2.0, 9.0) } else { 0.0 }, 0.0);
        left += 2.0 * next.half.x + if i == 0 { 0.5 } else { 0.0 };
        def.bodies.push(BodyDef { position, velocity, restitution, ..next });
    }
}
