//! No more than a scene needs: a part that a plan leaves out because the scene has nothing of it changes no bit of any motion or force.

use crate::support::shipped::{levels, load};
use proptest::prelude::*;
use resultant::physics::{Aabb, BodyDef, BodyId, DVec2, FluidDef, Material, Plan, StreamDef, SurfaceDef, World, WorldDef};

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
    for name in levels() {
        let def = load(&name).world_def();
        let mut bare = def.clone();
        bare.air_density = 0.0;
        assert_ne!(Plan::of(&bare), Plan::EVERYTHING);
        for def in [def, bare] {
            assert_alike(def, DVec2::new(600.0, -1600.0));
        }
    }
}

/// Bodies that glide as one are advanced by one formula: over seams and edges, from one material to another, on until they stop, meet a
/// wall or a resting body, or are pushed otherwise.
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

/// Bodies with each part present or absent: air, streams, liquids, bounces, a surface, an edge, and bodies that begin on each other.
fn scene(count: usize, parts: [bool; 7], size: f64) -> WorldDef {
    let [air, streams, liquids, bouncy, surfaces, edge, stacked] = parts;
    let zone = |x: f64, y: f64, w: f64, h: f64| Aabb::new(DVec2::new(x, y), DVec2::new(x + w, y + h));
    let bodies = (0..count)
        .map(|i| BodyDef {
            position: DVec2::new(2.0 + 2.1 * i as f64, 2.0 + 0.3 * i as f64),
            velocity: DVec2::new(3.0 - i as f64, 0.5 * i as f64),
            half: DVec2::new(size, 0.9 - 0.5 * size),
            mass: 40.0 + 30.0 * i as f64,
            restitution: if bouncy { 0.6 } else { 0.0 },
            ..BodyDef::default()
        })
        .collect();
    let mut bodies: Vec<BodyDef> = bodies;
    if stacked {
        // Most of them begin at rest on each other and on the floor; the first one comes to disturb them.
        for (i, body) in bodies.iter_mut().enumerate().skip(1) {
            (body.position, body.velocity) = (DVec2::new(6.0, 9.0 - 2.0 * body.half.y * (i as f64 - 0.5)), DVec2::ZERO);
        }
    }
    WorldDef {
        air_density: if air { 1.2041 } else { 0.0 },
        bounds: edge.then(|| zone(0.0, 0.0, 16.0, 9.0)),
        surfaces: surfaces.then(|| SurfaceDef::fixed(zone(3.0, 6.0, 8.0, 0.5), Material::STEEL)).into_iter().collect(),
        streams: streams
            .then(|| StreamDef { zone: zone(1.0, 3.0, 5.0, 3.0), force: DVec2::new(300.0, -200.0) })
            .into_iter()
            .collect(),
        fluids: liquids.then(|| FluidDef { zone: zone(0.0, 7.0, 16.0, 2.0), density: 900.0, viscosity: 0.5 }).into_iter().collect(),
        bodies,
        ..WorldDef::default()
    }
}

/// A scene that proptest once found: how many bodies, the parts, the size, the drive.
type Found = (usize, [bool; 7], f64, (f64, f64));

#[test]
fn no_scene_that_once_moved_otherwise_does() {
    let scenes: [Found; 12] = [
        (2, [false, false, false, false, true, false, false], 0.2, (0.0, 0.0)),
        (3, [true, false, true, false, false, false, true], 0.6571204581323454, (0.0, 0.0)),
        (4, [false, true, false, false, false, false, false], 0.8808486075585757, (-558.7939711854967, -1619.6453955824775)),
        (4, [true, true, true, false, true, false, false], 0.5627140348940178, (0.0, -2203.8207913226556)),
        (5, [false, true, false, false, false, true, false], 0.5923504804172978, (861.2896109572324, 0.0)),
        (3, [false, true, false, false, false, true, false], 0.2, (575.1370478531574, 0.0)),
        (5, [false, false, false, false, false, true, true], 0.33754087645647723, (325.9054972658572, -975.2940460826879)),
        (1, [false, false, true, false, false, true, false], 0.3609074652031587, (-659.7195958010861, -42.01592976884453)),
        (5, [false, true, true, true, false, false, true], 0.2, (-67.28984883419689, -951.4372542945619)),
        // Islands of few bodies in which many events fall into a tick.
        (4, [false, false, true, true, false, false, true], 0.2, (215.87334787478702, -254.36179881306316)),
        (4, [false, false, false, true, true, false, false], 0.5494936621590705, (565.1879914489944, -635.2353359923281)),
        (5, [true, false, true, false, false, false, true], 0.4179520886772193, (464.569865895534, -622.387819802416)),
    ];
    for (count, parts, size, drive) in scenes {
        assert_alike(scene(count, parts, size), drive.into());
    }
}

proptest! {
    #![proptest_config(crate::support::strategies::cases(64))]

    #[test]
    fn no_random_scene_moves_otherwise(
        count in 1usize..6, air in any::<bool>(), streams in any::<bool>(), liquids in any::<bool>(), bouncy in any::<bool>(),
        surfaces in any::<bool>(), edge in any::<bool>(), stacked in any::<bool>(), fx in -900.0..900.0f64, fy in -2500.0..0.0f64, size in 0.2..0.9f64,
    ) {
        let parts = [air, streams, liquids, bouncy, surfaces, edge, stacked];
        assert_alike(scene(count, parts, size), DVec2::new(fx, fy));
    }
}
