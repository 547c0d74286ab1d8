//! No more than a scene needs: the plan leaves parts of the model out, and answers directly where nothing changes; that changes no bit of
//! any motion, nor of any force shown.

mod support;

use proptest::prelude::*;
use resultant::physics::{Aabb, BodyDef, BodyId, DVec2, FluidDef, Material, Plan, StreamDef, SurfaceDef, World, WorldDef};
use std::path::Path;

/// The bits of every tick of a flight under a drive that comes and goes: of all motion, and of the forces shown with it.
fn flight(mut world: World, drive: DVec2, ticks: u32) -> Vec<u64> {
    let mut bits = Vec::new();
    for tick in 0..ticks {
        let on = tick / 40 % 3;
        world.set_drive(BodyId(0), drive * f64::from(on));
        world.step(1.0 / 120.0);
        world.hash_state(&mut |word| bits.push(word));
        for (i, body) in world.bodies().iter().enumerate() {
            let id = BodyId(i as u32);
            let forces = world.forces(id);
            let listed = forces.forces().iter().map(|force| {
                bits.push(force.kind as u64);
                force.vector
            });
            let vectors: Vec<DVec2> =
                [forces.resultant(), body.acceleration, world.previous_position(id)].into_iter().chain(listed).collect();
            bits.extend(vectors.iter().flat_map(|v| [v.x.to_bits(), v.y.to_bits()]));
        }
    }
    bits
}

fn assert_alike(def: WorldDef, drive: DVec2) {
    let ticks = 400;
    let planned = flight(World::new(def.clone()).unwrap(), drive, ticks);
    let whole = flight(World::with_plan(def, Plan::EVERYTHING).unwrap(), drive, ticks);
    assert!(planned == whole, "a part that was left out changed a motion");
}

#[test]
fn no_shipped_level_moves_otherwise_with_every_part_switched_on() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    for name in resultant::level::list(&root.join("levels")) {
        let level = resultant::level::load(&root.join("levels").join(name), root).unwrap().level;
        let def = level.world_def();
        let mut bare = def.clone();
        bare.air_density = 0.0;
        assert_ne!(Plan::of(&bare), Plan::EVERYTHING);
        for def in [def, bare] {
            assert_alike(def, DVec2::new(600.0, -1600.0));
        }
    }
}

/// What glides as one is advanced by one formula: over seams and edges, from one material to another, on until it stops, meets a wall or a
/// body that rests, or is pushed otherwise.
#[test]
fn nothing_that_glides_as_one_moves_otherwise_body_by_body() {
    let surface = |left: f64, top: f64, right: f64, material| {
        SurfaceDef::fixed(Aabb::new(DVec2::new(left, top), DVec2::new(right, top + 1.0)), material)
    };
    let floors = vec![
        surface(-20.0, 0.0, 9.3, Material::ASPHALT),
        surface(9.3, 0.0, 12.1, Material::ICE),
        surface(14.0, 3.0, 40.0, Material::ASPHALT),
        surface(30.0, 1.0, 31.0, Material::ASPHALT),
    ];
    for (count, speed, push, sideways) in
        [(1, 8.0, 0.0, false), (1, 3.0, 900.0, false), (4, 2.0, 2600.0, false), (6, 9.0, 0.0, false), (3, -4.0, 0.0, true)]
    {
        let mut bodies: Vec<BodyDef> = (0..count)
            .map(|i| BodyDef {
                position: DVec2::new(f64::from(i), -0.5),
                velocity: DVec2::new(speed, 0.0),
                half: DVec2::splat(0.5),
                mass: 20.0 + 5.0 * f64::from(i),
                feels_air: false,
                ..BodyDef::default()
            })
            .collect();
        // One that rests in the way.
        bodies.push(BodyDef {
            position: DVec2::new(8.0, -0.4),
            half: DVec2::splat(0.4),
            mass: 3.0,
            feels_air: false,
            ..BodyDef::default()
        });
        let mut surfaces = floors.clone();
        if sideways {
            surfaces.push(SurfaceDef::fixed(Aabb::new(DVec2::new(-6.0, -9.0), DVec2::new(-5.0, 0.0)), Material::ASPHALT));
        }
        let def = WorldDef { gravity: 15.0, air_density: 0.0, bodies, surfaces, ..WorldDef::default() };
        assert_alike(def, DVec2::new(push, 0.0));
    }
}

proptest! {
    #![proptest_config(support::strategies::cases(64))]

    /// Each part present or absent, in every combination.
    #[test]
    fn no_random_scene_moves_otherwise(
        count in 1usize..6, air in any::<bool>(), streams in any::<bool>(), liquids in any::<bool>(), bouncy in any::<bool>(),
        surfaces in any::<bool>(), edge in any::<bool>(), stacked in any::<bool>(), fx in -900.0..900.0f64, fy in -2500.0..0.0f64, size in 0.2..0.9f64,
    ) {
        let zone = |x: f64, y: f64, w: f64, h: f64| Aabb::new(DVec2::new(x, y), DVec2::new(x + w, y + h));
        let bodies = (0..count).map(|i| BodyDef {
            position: DVec2::new(2.0 + 2.1 * i as f64, 2.0 + 0.3 * i as f64),
            velocity: DVec2::new(3.0 - i as f64, 0.5 * i as f64),
            half: DVec2::new(size, 0.9 - 0.5 * size),
            mass: 40.0 + 30.0 * i as f64,
            restitution: if bouncy { 0.6 } else { 0.0 },
            ..BodyDef::default()
        }).collect();
        let mut bodies: Vec<BodyDef> = bodies;
        if stacked {
            // Most of them begin at rest on each other and on the floor; the first one comes to disturb them.
            for (i, body) in bodies.iter_mut().enumerate().skip(1) {
                (body.position, body.velocity) = (DVec2::new(6.0, 9.0 - 2.0 * body.half.y * (i as f64 - 0.5)), DVec2::ZERO);
            }
        }
        let def = WorldDef {
            air_density: if air { 1.2041 } else { 0.0 },
            bounds: edge.then(|| zone(0.0, 0.0, 16.0, 9.0)),
            surfaces: surfaces.then(|| SurfaceDef::fixed(zone(3.0, 6.0, 8.0, 0.5), Material::STEEL)).into_iter().collect(),
            streams: streams.then(|| StreamDef { zone: zone(1.0, 3.0, 5.0, 3.0), force: DVec2::new(300.0, -200.0) }).into_iter().collect(),
            fluids: liquids.then(|| FluidDef { zone: zone(0.0, 7.0, 16.0, 2.0), density: 900.0, viscosity: 0.5 }).into_iter().collect(),
            bodies,
            ..WorldDef::default()
        };
        assert_alike(def, DVec2::new(fx, fy));
    }
}
