//! The two methods against each other: each scene once event by event and once with every island in one dense step a tick.
//!
//! The dense method gives the events of a tick their order but not their times: friction of a landing acts from the tick's beginning on,
//! and an edge carries to the tick's end. The bounds below follow from that.

use crate::support::lanes::Lane;
use crate::support::scenes::{Scene, exact_scenes};
use crate::support::turned::{mirrored, reversed, shifted};
use crate::support::{Ask, G, Random, TICK, area, crowd, momentum, room as walls};
use resultant::physics::{BodyId, DVec2, ForceKind, Plan, World, WorldDef};

fn twins(scene: &Scene) -> [World; 2] {
    [false, true].map(|dense| {
        let plan = Plan { dense, ..Plan::of(&scene.def) };
        let mut world = World::with_plan(scene.def.clone(), plan).unwrap();
        world.set_drive(BodyId(0), scene.drive);
        world
    })
}

#[derive(Clone, Debug, Default)]
struct Difference {
    /// The most in any tick, m.
    place: f64,
    /// In the end, m/s.
    speed: f64,
    /// Ticks in which contact forces of a kind on a body differ by more than a billionth of all forces on it.
    forces: u32,
    /// Ticks of bodies that the dense method took.
    dense: u32,
    /// Difference of the velocities of the centre of mass, the most until the tick of the first impact, m/s.
    centre: f64,
}

fn of_the_centre(world: &World) -> DVec2 {
    momentum(world) / world.bodies().iter().map(|body| body.mass).sum::<f64>()
}

fn compare(scene: &Scene) -> Difference {
    let [mut exact, mut dense] = twins(scene);
    let (mut found, mut since_impact) = (Difference::default(), 0);
    for _ in 0..(scene.seconds / TICK).round() as u32 {
        exact.step(TICK);
        dense.step(TICK);
        since_impact += u32::from(since_impact > 0 || !exact.impulses().is_empty());
        if since_impact <= 1 {
            found.centre = found.centre.max(of_the_centre(&exact).distance(of_the_centre(&dense)));
        }
        found.dense += dense.methods().in_one_step;
        assert_eq!(dense.methods().by_events, 0, "{}", scene.name);
        let mut other = false;
        found.speed = 0.0;
        for (i, (a, b)) in exact.bodies().iter().zip(dense.bodies()).enumerate() {
            found.place = found.place.max(a.position.distance(b.position));
            found.speed = found.speed.max(a.velocity.distance(b.velocity));
            let (of_a, of_b) = (exact.forces(BodyId(i as u32)), dense.forces(BodyId(i as u32)));
            let scale: f64 = of_a.forces().iter().map(|force| force.vector.length()).sum();
            let kinds = [ForceKind::Reaction, ForceKind::Push, ForceKind::Friction];
            other |= kinds.iter().any(|kind| of_a.total(*kind).distance(of_b.total(*kind)) > 1e-9 * scale.max(1.0));
        }
        found.forces += u32::from(other);
    }
    found
}

/// m and m/s. Rounding alone.
const ROUNDING: f64 = 1e-9;

#[test]
fn scenes_with_exact_answers_have_them_by_either_method() {
    for scene in exact_scenes() {
        let found = compare(&scene);
        assert!(found.dense > 0 || scene.name == "thrown", "{}: nothing was dense", scene.name);
        let (place, forces) = match &*scene.name {
            // Drag is taken by Simpson's rule where something rubs; a slide or a fall that ends within a tick lists its mean forces.
            "slide in air" => (1e-3, u32::MAX),
            // A crowd step gives each bounce the rest of its tick.
            "bounces that end" => (0.05, 30),
            // Bounces without end are soon out of step, and a crowd step does not follow the order of impacts, which decides which block of
            // a cradle leaves: `dense_laws` holds apexes, momentum and energy of these.
            name if name == "bounces without end" || name.starts_with("cradle") => continue,
            _ => (ROUNDING, 2),
        };
        assert!(found.place <= place && found.speed <= ROUNDING && found.forces <= forces, "{}: {found:?}", scene.name);
    }
}

const SEEDS: u64 = 40;

/// Each kind of scene, and the most by which the methods may differ in it: m in any tick, m/s in the end.
const LANES: [(Lane, f64, f64); 16] = [
    (Lane::Slide, ROUNDING, ROUNDING),
    (Lane::Lift, ROUNDING, ROUNDING),
    (Lane::Belt, ROUNDING, ROUNDING),
    (Lane::Afloat, ROUNDING, ROUNDING),
    (Lane::PressedToAWall, ROUNDING, ROUNDING),
    // Friction of the tick in which a body lands or hits, and of its slide until then.
    (Lane::Landing, 0.05, ROUNDING),
    // A bounce takes the rest of its tick, and goes on late.
    (Lane::Bounces, 0.1, 1.0),
    // The order of impacts decides which body of a row leaves, and how fast: `CENTRE` bounds the centre of mass.
    (Lane::Row, f64::INFINITY, f64::INFINITY),
    // Edges carry to the end of a tick, and for sliding bodies the borders of streams begin there.
    (Lane::SlideThroughStreams, 5e-3, 1e-3),
    (Lane::FlightThroughStreams, 0.06, 0.1),
    (Lane::SlideUnderWater, 0.06, 0.1),
    (Lane::Table, 0.2, 0.1),
    // A body drawn from under others; a wall, or the beginning of a path, that comes upon a body within a tick.
    (Lane::Stack, 0.8, 0.6),
    (Lane::Platform, 0.15, 1.5),
    (Lane::PushingWall, 0.2, 3.0),
    (Lane::SlideInAir, 2e-3, 1e-3),
];

/// m/s. An impact passes momentum on and makes none: the difference is friction within its tick, to either side, on rubber at most.
const CENTRE: f64 = 2.0 * 1.15 * G * TICK;

#[test]
fn random_scenes_of_one_law_each_agree() {
    for (lane, place, speed) in LANES {
        for seed in 0..SEEDS {
            let scene = lane.scene(seed);
            let found = compare(&scene);
            assert!(found.place <= place && found.speed <= speed, "{}: {found:?}", scene.name);
            assert!(lane != Lane::Row || found.centre <= CENTRE, "{}: {found:?}", scene.name);
        }
    }
}

fn room(seed: u64, count: usize, lively: bool) -> WorldDef {
    let mut bodies = crowd(&mut Random(seed), count, 6);
    for body in &mut bodies {
        body.restitution *= f64::from(u8::from(lively));
    }
    let surfaces = walls(area(0.0, -9.0, 11.0, 12.0), 1.0).into();
    WorldDef { air_density: 0.0, rest_speed: 0.0, bodies, surfaces, ..WorldDef::default() }
}

fn touches(world: &World) -> Vec<(usize, ForceKind, String)> {
    let of = |i: usize| {
        let forces = world.forces(BodyId(i as u32));
        let contacts = forces.forces().iter().filter(|force| matches!(force.kind, ForceKind::Reaction | ForceKind::Push));
        let mut list: Vec<_> = contacts.map(|force| (i, force.kind, format!("{:?}", force.source))).collect();
        list.sort_by(|a, b| a.2.cmp(&b.2));
        list
    };
    (0..world.bodies().len()).flat_map(of).collect()
}

fn tick(def: &WorldDef, dense: bool) -> World {
    let mut world = World::with_plan(def.clone(), Plan { dense, ..Plan::of(def) }).unwrap();
    world.step(TICK);
    world
}

/// The largest difference of velocities, m/s.
fn difference(a: &World, b: &World) -> f64 {
    a.bodies().iter().zip(b.bodies()).map(|(a, b)| a.velocity.distance(b.velocity)).fold(0.0, f64::max)
}

/// Lets `look` see a scene before each of its first `ticks` ticks.
fn along(mut def: WorldDef, dense: bool, ticks: usize, mut look: impl FnMut(&WorldDef)) {
    let mut world = World::with_plan(def.clone(), Plan { dense, ..Plan::of(&def) }).unwrap();
    for _ in 0..ticks {
        look(&def);
        world.step(TICK);
        for (def, body) in def.bodies.iter_mut().zip(world.bodies()) {
            (def.position, def.velocity) = (body.position, body.velocity);
        }
    }
}

/// From the state that the events lead to, one tick by either method: where nothing begins or ends in it, they agree.
#[test]
fn a_tick_in_which_nothing_happens_is_the_same_tick() {
    // Bodies, whether they bounce, which part of the ticks may differ by more than rounding, and by how much, m/s: the solver finds in turns
    // the forces that keep three bodies or more from sliding off each other.
    let rooms = [
        (1, false, 0.0, ROUNDING),
        (1, true, 0.0, ROUNDING),
        (4, false, 0.01, 0.05),
        (12, false, 0.02, 0.1),
        (12, true, 0.01, 0.1),
        (30, false, 0.08, 2.0),
    ];
    for (count, lively, part, most) in rooms {
        let (mut calm, mut off, mut worst) = (0u32, 0u32, 0.0f64);
        for seed in 0..15 {
            along(room(seed, count, lively), false, 240, |def| {
                let (exact, dense) = (tick(def, false), tick(def, true));
                if exact.impulses().is_empty() && dense.impulses().is_empty() && touches(&exact) == touches(&dense) {
                    let found = difference(&exact, &dense);
                    calm += 1;
                    off += u32::from(found > ROUNDING);
                    worst = worst.max(found);
                }
            });
        }
        let held = calm > 1000 && f64::from(off) <= part * f64::from(calm) && worst <= most;
        assert!(held, "{count} bodies, lively {lively}: {off} of {calm} calm ticks differ, the worst by {worst:.1e} m/s");
    }
}

type View = fn(&WorldDef) -> WorldDef;

#[test]
fn a_dense_tick_is_the_same_mirrored_shifted_and_in_another_order() {
    let shift = |def: &WorldDef| shifted(def, DVec2::new(131_072.0, -65_536.0));
    let views: [(&str, View); 3] = [("mirrored", mirrored), ("shifted by 100 km", shift), ("in another order", reversed)];
    for (name, view) in views {
        let (mut ticks, mut off) = (0u32, 0u32);
        for seed in 0..12 {
            along(room(seed, 30, seed % 2 == 1), true, 120, |def| {
                let (here, there) = (tick(def, true), tick(&view(def), true));
                let seen = |i: usize| match name {
                    "mirrored" => there.speed(i) * DVec2::new(-1.0, 1.0),
                    "in another order" => there.speed(29 - i),
                    _ => there.speed(i),
                };
                ticks += 1;
                off += u32::from((0..30).any(|i| here.speed(i).distance(seen(i)) > 1e-6));
            });
        }
        // Where a body is at the very edge of a law, rounding decides.
        assert!(off * 400 <= ticks, "{name}: {off} of {ticks} ticks differ by more than rounding");
    }
}
