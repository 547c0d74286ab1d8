//! A step allocates nothing once its scratch has grown to the scene.

use crate::support::dense::{rain_into, restless};
use crate::support::memory::allocations;
use crate::support::{Ask, Random, area, world};
use resultant::physics::{BodyDef, DVec2, FluidDef, Material, StreamDef, SurfaceDef, World, WorldDef};

#[global_allocator]
static ALLOCATOR: crate::support::memory::Counting = crate::support::memory::Counting;

#[test]
fn a_warm_step_allocates_nothing() {
    for restitution in [0.0, 0.8] {
        let mut pile = restless(rain_into(0.0, 400, 20, (1.0, 1.0), Random(1), restitution));
        pile.steps(120, 1.0 / 60.0);
        let before = allocations();
        pile.steps(300, 1.0 / 60.0);
        assert_eq!(allocations(), before);
    }
}

#[cfg(feature = "window")]
#[test]
fn the_mixer_allocates_nothing() {
    use resultant::sound::{Ambience, Cue, Mixer, Sound, desk};
    let (desk, feed) = desk();
    let mut mixer = Mixer::new(48_000, feed);
    let mut samples = [0.0; 960];
    let before = allocations();
    for frame in 0..1200 {
        desk.set_tune(Some(frame / 400));
        desk.set_ambience(Ambience { engine: 1.0, wind: 0.5, liquid: 0.5, motion: 1.0 });
        desk.play(Sound::new(Cue::ALL[frame as usize % Cue::COUNT], 1.0));
        mixer.render(&mut samples);
    }
    assert_eq!(allocations(), before);
}

/// A level's worth of everything: bounces, slides, air, a stream, a liquid, a drive that is switched; and a crowd.
#[test]
fn a_warm_tick_of_a_world_allocates_nothing() {
    for bodies in [12, 200] {
        let body = |i: i32| BodyDef {
            position: DVec2::new(1.0 + f64::from(i % 14), 1.0 + f64::from(i / 14)),
            velocity: DVec2::new(f64::from(i % 5) - 2.0, 0.0),
            half: DVec2::new(0.4, 0.3),
            mass: 20.0 + f64::from(i),
            restitution: 0.2 * f64::from(i % 4),
            ..BodyDef::default()
        };
        let mut world = world(WorldDef {
            bounds: Some(area(0.0, 0.0, 16.0, 30.0)),
            surfaces: vec![SurfaceDef::fixed(area(2.0, 20.0, 7.0, 21.0), Material::ICE)],
            streams: vec![StreamDef { zone: area(8.0, 10.0, 12.0, 30.0), force: DVec2::new(0.0, -900.0) }],
            fluids: vec![FluidDef { zone: area(0.0, 25.0, 8.0, 30.0), density: 900.0, viscosity: 0.1 }],
            bodies: (0..bodies).map(body).collect(),
            ..WorldDef::default()
        });
        let tick = |world: &mut World, n: u32| {
            for i in 0..n {
                world.drive(0, if i / 60 % 2 == 0 { 2500.0 } else { -2500.0 }, -800.0);
                world.step(1.0 / 120.0);
            }
        };
        tick(&mut world, 2400);
        let before = allocations();
        tick(&mut world, 600);
        assert_eq!(allocations(), before, "{bodies} bodies");
    }
}
