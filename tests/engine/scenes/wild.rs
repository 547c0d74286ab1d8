//! Random scenes of extreme masses, sizes and speeds together, from a few bodies to a crowd: finite, no energy from nothing, no overlap,
//! the same bits twice. Each of these laws was once broken in some scene of this kind.

use crate::support::strategies::{blocks, cases, materials};
use crate::support::{G, TICK, bits, energy, momentum, momentum_scale, worst_overlap};
use proptest::prelude::*;
use resultant::physics::{Aabb, BodyDef, BodyId, DVec2, SurfaceDef, World, WorldDef};

/// m. The bar for every pair at every tick.
const OVERLAP: f64 = 1e-6;
/// The room, m.
const ROOM: Aabb = Aabb::new(DVec2::ZERO, DVec2::new(24.0, 20.0));
/// Bodies of a row at the start.
const COLUMNS: usize = 15;

/// Few enough for the exact method, or so many that they are a crowd. One body a cell of a grid, so that none begins inside another.
/// Most are slow and weigh about the same; some are light as a feather, some heavy as a car, some as fast as a shot.
fn bodies() -> impl Strategy<Value = Vec<BodyDef>> {
    let size = (0.03..0.7f64, 0.03..0.6f64);
    let mass = prop_oneof![3 => 0.5..50.0f64, 1 => (-2.0..3.0f64).prop_map(|log| 10f64.powf(log))];
    let velocity = prop_oneof![9 => (-5.0..5.0f64, -5.0..5.0f64), 1 => (-300.0..300.0f64, -300.0..300.0f64)];
    let restitution = prop_oneof![2 => Just(0.0), 2 => 0.0..1.0f64, 1 => Just(1.0)];
    let body = (size, mass, velocity, restitution, materials());
    let number = prop_oneof![3..60_usize, 65..130_usize];
    number.prop_flat_map(move |number| prop::collection::vec(body.clone(), number)).prop_map(|list| {
        let place = |i: usize| DVec2::new(1.0 + 1.5 * (i % COLUMNS) as f64, 1.0 + 1.3 * (i / COLUMNS) as f64);
        let body = |(i, ((w, h), mass, (vx, vy), restitution, material))| BodyDef {
            position: place(i),
            velocity: DVec2::new(vx, vy),
            half: DVec2::new(w, h),
            mass,
            restitution,
            material,
            ..BodyDef::default()
        };
        list.into_iter().enumerate().map(body).collect()
    })
}

fn surfaces() -> impl Strategy<Value = Vec<SurfaceDef>> {
    blocks(0.0..20.0, 13.0..19.0, 0.1..6.0, 0.1..3.0)
}

fn keeps_every_law(bodies: Vec<BodyDef>, surfaces: Vec<SurfaceDef>, air: bool, weightless: bool) -> Result<(), TestCaseError> {
    let gravity = if weightless { 0.0 } else { G };
    let air_density = if air { 1.2041 } else { 0.0 };
    let def = WorldDef { gravity, air_density, bounds: Some(ROOM), bodies, surfaces, ..WorldDef::default() };
    let mut world = World::new(def.clone()).unwrap();
    let mut twin = World::new(def).unwrap();
    let mut before = energy(&world, gravity, ROOM.max.y);
    for tick in 0..480 {
        world.step(TICK);
        twin.step(TICK);
        let now = energy(&world, gravity, ROOM.max.y);
        prop_assert!(now.is_finite());
        prop_assert!(now <= before * (1.0 + 1e-9), "tick {}: energy rose from {} to {}", tick, before, now);
        let overlap = worst_overlap(&world);
        prop_assert!(overlap <= OVERLAP, "tick {}: overlap {} m", tick, overlap);
        prop_assert!(world.bodies().iter().all(|b| ROOM.contains(&b.bounds(), OVERLAP)), "tick {}: out of the room", tick);
        before = now;
    }
    prop_assert_eq!(bits(&world), bits(&twin));
    Ok(())
}

fn stays_finite_apart_and_within(bodies: Vec<BodyDef>, surfaces: Vec<SurfaceDef>, force: (f64, f64)) -> Result<(), TestCaseError> {
    // No more than a level may hold: 1e4 m/s² of the lightest body.
    let most = 1e4 * bodies.iter().map(|body| body.mass).fold(f64::INFINITY, f64::min);
    let force = DVec2::from(force).clamp(DVec2::splat(-most), DVec2::splat(most));
    let mut world = World::new(WorldDef { bounds: Some(ROOM), bodies, surfaces, ..WorldDef::default() }).unwrap();
    for tick in 0..360 {
        let push = if tick / 60 % 2 == 0 { 1.0 } else { -0.5 };
        world.set_drive(BodyId(0), force * push);
        world.step(TICK);
        prop_assert!(world.bodies().iter().all(|b| b.position.is_finite() && b.velocity.is_finite() && b.acceleration.is_finite()));
        let overlap = worst_overlap(&world);
        prop_assert!(overlap <= OVERLAP, "tick {}: overlap {} m", tick, overlap);
        prop_assert!(world.bodies().iter().all(|b| ROOM.contains(&b.bounds(), OVERLAP)));
    }
    Ok(())
}

/// Scenes that proptest once found.
#[test]
fn scenes_that_once_broke_a_law_keep_it() {
    let scenes = [
        include!("../../fixtures/found/wild_scenes_1.rs"),
        include!("../../fixtures/found/wild_scenes_3.rs"),
        include!("../../fixtures/found/wild_scenes_4.rs"),
        include!("../../fixtures/found/wild_scenes_5.rs"),
        include!("../../fixtures/found/wild_scenes_6.rs"),
    ];
    for (i, (bodies, surfaces, air, weightless)) in scenes.into_iter().enumerate() {
        keeps_every_law(bodies, surfaces, air, weightless).unwrap_or_else(|fault| panic!("scene {i}: {fault}"));
    }
    let (bodies, surfaces, force) = include!("../../fixtures/found/wild_scenes_2.rs");
    stays_finite_apart_and_within(bodies, surfaces, force).unwrap();
}

proptest! {
    #![proptest_config(cases(32))]

    #[test]
    fn every_law_is_kept(bodies in bodies(), surfaces in surfaces(), air in any::<bool>(), weightless in any::<bool>()) {
        keeps_every_law(bodies, surfaces, air, weightless)?;
    }

    #[test]
    fn momentum_is_conserved_in_space(bodies in bodies()) {
        let mut world = World::new(WorldDef { gravity: 0.0, air_density: 0.0, bodies, ..WorldDef::default() }).unwrap();
        let (before, scale) = (momentum(&world), momentum_scale(&world));
        for _ in 0..480 {
            world.step(TICK);
        }
        prop_assert!((momentum(&world) - before).length() <= 1e-11 * scale, "{} {}", momentum(&world), before);
    }

    #[test]
    fn what_is_driven_stays_finite_apart_and_within(
        bodies in bodies(),
        surfaces in surfaces(),
        force in (-30000.0..30000.0f64, -30000.0..30000.0f64),
    ) {
        stays_finite_apart_and_within(bodies, surfaces, force)?;
    }
}
