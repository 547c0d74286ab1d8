//! The work of a tick, counted and not by the clock, in scenes made to be slow; and a tick that gives up exactness loses no time. How long
//! they take, `tools/fuzz_levels worst` shows.

use crate::support::slow::{Scene, scenes};
use crate::support::{Ask, area, worst_overlap};
use resultant::physics::{Aabb, BodyDef, BodyId, DVec2, Impulse, Material, Obstacle, SurfaceDef, World, WorldDef};

/// Events that each body may add to those of its island, however the bodies share islands. The last events, and islands that grow and are
/// advanced again, may exceed it.
const EVENTS_OF_A_BODY: u64 = 2180;
const EXCEEDED: u64 = 3;

fn scene(name: &str) -> Scene {
    scenes().into_iter().find(|scene| scene.name == name).unwrap()
}

fn play(scene: &Scene, mut look: impl FnMut(&World, usize)) -> World {
    let mut world = World::new(scene.def.clone()).unwrap();
    for tick in 0..scene.ticks.min(120) {
        world.set_drive(BodyId(0), scene.drive);
        world.step(scene.tick);
        look(&world, tick);
    }
    world
}

#[test]
fn the_events_of_a_tick_are_bounded() {
    for scene in scenes() {
        let most = EXCEEDED * EVENTS_OF_A_BODY * scene.def.bodies.len() as u64;
        play(&scene, |world, tick| {
            assert!(world.followed() <= most, "{}, tick {tick}: {} events, more than {most}", scene.name, world.followed());
        });
    }
}

/// A body that nothing hits goes on in its direction, also where too many events fall into a tick of its island.
#[test]
fn no_time_is_lost_where_too_much_happens() {
    let (mut busy, mut looks) = (0, 0);
    for scene in [
        "16 liquids upon each other, 64 bodies",
        "16 liquids side by side, 64 bodies",
        "gas of 1e-3 … 1e3 kg at 10 m/s, air 1.2041",
    ]
    .map(scene)
    {
        let room = scene.def.bounds.unwrap();
        let mut before: Vec<(DVec2, DVec2)> = scene.def.bodies.iter().map(|body| (body.position, body.velocity)).collect();
        let world = play(&scene, |world, tick| {
            let near: Vec<Aabb> =
                before.iter().zip(&scene.def.bodies).map(|((place, _), body)| Aabb::around(*place, body.half + 0.2)).collect();
            let far = |i: usize| room.contains(&near[i], 0.0) && (0..near.len()).all(|j| j == i || !near[i].touches(&near[j], 0.0));
            for (i, (place, velocity)) in before.iter_mut().enumerate() {
                let body = world.body(BodyId(i as u32));
                let id = BodyId(i as u32);
                let struck = |impulse: &Impulse| impulse.a == id || impulse.b == Obstacle::Body(id);
                let hit = !far(i)
                    || world.impulses().iter().any(struck)
                    || velocity.length().max(body.velocity.length()) * scene.tick > 0.2;
                looks += u32::from(!hit);
                for axis in 0..2 {
                    let slowest = velocity[axis].abs().min(body.velocity[axis].abs());
                    if !hit && slowest > 0.1 && velocity[axis] * body.velocity[axis] > 0.0 {
                        let way = (body.position[axis] - place[axis]) * velocity[axis].signum();
                        assert!(way > 0.25 * slowest * scene.tick, "{}, tick {tick}: body {i} went {way} m", scene.name);
                    }
                }
                (*place, *velocity) = (body.position, body.velocity);
            }
        });
        busy += world.guards().budgets_used_up;
    }
    assert!(busy > 0 && looks > 1000, "{busy} busy islands, {looks} looks");
}

#[test]
fn what_falls_far_from_a_busy_island_does_not_notice() {
    let Scene { def: gas, ticks, tick, drive, name } = scene("gas of 1e-3 … 1e3 kg at 100 m/s, air 0");
    let body = BodyDef { position: DVec2::new(500.0, 0.0), velocity: DVec2::new(0.3, -2.0), ..BodyDef::default() };
    let walls =
        [area(-1.0, -1.0, 12.0, 0.0), area(-1.0, 11.0, 12.0, 12.0), area(-1.0, 0.0, 0.0, 11.0), area(11.0, 0.0, 12.0, 11.0)]
            .map(|bounds| SurfaceDef::fixed(bounds, Material::ASPHALT));
    let open = WorldDef { bounds: None, surfaces: walls.into(), ..gas };
    let of = |bodies: Vec<BodyDef>| Scene { def: WorldDef { bodies, ..open.clone() }, name: name.clone(), ticks, tick, drive };
    let mut lonely = Vec::new();
    play(&of(vec![body.clone()]), |world, _| lonely.push(world.at(0)));
    let mut bodies = open.bodies.clone();
    let far = BodyId(bodies.len() as u32);
    bodies.push(body);
    let world = play(&of(bodies), |world, tick| assert_eq!(world.body(far).position, lonely[tick], "tick {tick}"));
    assert!(world.guards().budgets_used_up > 0, "the gas is not busy: {:?}", world.guards());
}

/// Where an island is left before anything of it has happened, others follow their bodies' paths.
#[test]
fn what_liquids_leave_to_the_dense_method_does_not_overlap() {
    let world = play(&scene("16 liquids side by side, 64 bodies"), |world, tick| {
        let overlap = worst_overlap(world);
        assert!(overlap <= 1e-6, "tick {tick}: {overlap} m");
    });
    assert!(world.guards().budgets_used_up > 0, "{:?}", world.guards());
}
