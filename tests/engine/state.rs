//! The next tick follows from the state alone: a flush contact begins and ends at an instant, whatever tick rate, history, order of rows or side
//! a scene comes with, and carries its share of the load from then on.

use crate::support::turned::{mirrored, reversed};
use crate::support::{Ask, G, area, v};
use resultant::physics::{BodyDef, BodyId, DVec2, ForceKind, Material, Path, Source, StreamDef, SurfaceDef, World, WorldDef};

/// m and m/s.
const EXACT: f64 = 1e-9;

fn tile(left: f64, right: f64, material: Material) -> SurfaceDef {
    SurfaceDef::fixed(area(left, 0.0, right, 1.0), material)
}

/// 1 m × 1 m, on a surface at y = 0.
fn crate_at(x: f64, speed: f64) -> BodyDef {
    BodyDef { position: v(x, -0.5), velocity: v(speed, 0.0), mass: 20.0, ..BodyDef::default() }
}

fn moving(surface: SurfaceDef, velocity: DVec2) -> SurfaceDef {
    SurfaceDef { path: Path::steady(velocity), ..surface }
}

fn scene(surfaces: Vec<SurfaceDef>, bodies: Vec<BodyDef>) -> WorldDef {
    WorldDef { gravity: G, air_density: 0.0, surfaces, bodies, ..WorldDef::default() }
}

/// Bodies that slide on to another surface, or are slid under: a name, a definition, and the drive of the first body.
fn scenes() -> Vec<(&'static str, WorldDef, DVec2)> {
    let (asphalt, ice, wood) = (Material::ASPHALT, Material::ICE, Material::WOOD);
    let belt = |speed: f64| SurfaceDef { belt: speed, ..tile(0.0, 30.0, asphalt) };
    let lift = |left: f64, right: f64| moving(tile(left, right, wood), v(0.0, -2.0));
    let on_lift = |x: f64, speed: f64| BodyDef { velocity: v(speed, -2.0), ..crate_at(x, 0.0) };
    let floor = |from: f64| tile(-30.0, from, asphalt);
    let none = DVec2::ZERO;
    let slid = moving(tile(2.0, 6.0, wood), v(-1.7, 0.0));
    let seams = (-9..9).map(|x| tile(f64::from(x), f64::from(x + 1), wood)).collect();
    let row = [-4.2, -3.2, -2.2].map(|x| crate_at(x, 0.0)).to_vec();
    let stacked = vec![BodyDef { position: v(-0.47, -1.5), ..crate_at(0.0, 3.0) }, crate_at(0.0, 0.0), crate_at(1.0, 0.0)];
    vec![
        ("a seam", scene(vec![floor(0.0), tile(0.0, 30.0, ice)], vec![crate_at(-3.13, 9.0)]), none),
        ("a belt that runs on", scene(vec![floor(0.0), belt(3.0)], vec![crate_at(-2.13, 7.0)]), none),
        ("a belt that runs back", scene(vec![floor(0.0), belt(-2.0)], vec![crate_at(-2.13, 7.0)]), none),
        ("a mover that slides under a crate", scene(vec![floor(0.0), slid], vec![crate_at(0.3, 0.0)]), none),
        ("from lift to lift", scene(vec![lift(-8.0, 0.0), lift(0.0, 8.0)], vec![on_lift(-2.37, 6.0)]), none),
        ("pushed over seams", scene(seams, vec![crate_at(-7.3, 0.0)]), v(260.0, 0.0)),
        ("a pushed row", scene(vec![floor(0.0), tile(0.0, 30.0, ice)], row), v(900.0, 0.0)),
        ("a crate on crates", scene(vec![tile(-30.0, 30.0, asphalt)], stacked), none),
    ]
}

fn begun(def: &WorldDef, drive: DVec2) -> World {
    let mut world = World::new(def.clone()).unwrap();
    world.set_drive(BodyId(0), drive);
    world
}

fn run(world: &mut World, seconds: f64, rate: f64) {
    world.steps((seconds * rate).round() as u32, 1.0 / rate);
}

fn assert_alike(name: &str, a: &World, b: &World) {
    for (mine, other) in a.bodies().iter().zip(b.bodies()) {
        let off = (mine.position - other.position).length() + (mine.velocity - other.velocity).length();
        assert!(off <= EXACT, "{name}: {} {} and {} {}", mine.position, mine.velocity, other.position, other.velocity);
    }
}

/// A world that takes up places and velocities half-way goes on as the one that got there by itself.
#[test]
fn history_decides_nothing() {
    for (name, def, drive) in scenes() {
        let mut world = begun(&def, drive);
        for tick in 0..240 {
            if tick % 7 == 3 {
                let (mut with, mut without) = (world.clone(), world.clone());
                without.go_on_by(def.clone()).unwrap();
                run(&mut with, 0.75, 120.0);
                run(&mut without, 0.75, 120.0);
                assert_alike(&format!("{name}, from tick {tick} on"), &with, &without);
            }
            world.step(1.0 / 120.0);
        }
    }
}

#[test]
fn the_tick_rate_decides_nothing() {
    for (name, def, drive) in scenes() {
        let mut worlds = [60.0, 120.0, 240.0].map(|rate| (begun(&def, drive), rate));
        for _ in 0..10 {
            worlds.iter_mut().for_each(|(world, rate)| run(world, 0.2, *rate));
            assert_alike(name, &worlds[0].0, &worlds[1].0);
            assert_alike(name, &worlds[2].0, &worlds[1].0);
        }
    }
}

#[test]
fn neither_the_order_of_rows_nor_the_side_decides_anything() {
    let turn = |x: DVec2| v(-x.x, x.y);
    for (name, def, drive) in scenes() {
        let (mut here, mut mirror, mut other) =
            (begun(&def, drive), begun(&mirrored(&def), turn(drive)), begun(&reversed(&def), v(0.0, 0.0)));
        other.set_drive(BodyId(def.bodies.len() as u32 - 1), drive);
        [&mut here, &mut mirror, &mut other].into_iter().for_each(|world| run(world, 2.0, 120.0));
        let rows = mirror.bodies().iter().zip(other.bodies().iter().rev());
        for (mine, (mirrored, moved)) in here.bodies().iter().zip(rows) {
            for seen in [turn(mirrored.position), moved.position] {
                assert!(mine.position.distance(seen) <= EXACT, "{name}: {} and {seen}", mine.position);
            }
        }
    }
}

#[test]
fn what_a_crate_stands_on_shares_its_load_at_once() {
    let surfaces = vec![tile(-9.0, 0.0, Material::ASPHALT), tile(0.0, 0.25, Material::ICE), tile(0.25, 9.0, Material::WOOD)];
    let mut world = World::new(scene(surfaces, vec![crate_at(-3.0, 9.0)])).unwrap();
    let mut counts = [0; 4];
    for _ in 0..80 {
        world.step(1.0 / 120.0);
        let (body, forces) = (world.body(BodyId(0)), world.forces(BodyId(0)));
        let (left, right) = (body.position.x - 0.5, body.position.x + 0.5);
        let stands: Vec<usize> = (0..3)
            .filter(|s| {
                let bounds = &world.surfaces()[*s].bounds;
                right.min(bounds.max.x) - left.max(bounds.min.x) > 1e-6
            })
            .collect();
        counts[stands.len()] += 1;
        for s in 0..3 {
            let of = |kind: ForceKind| {
                let from = forces.forces().iter().filter(|force| force.source == Source::Surface(s as u32) && force.kind == kind);
                from.fold(DVec2::ZERO, |sum, force| sum + force.vector)
            };
            let share = if stands.contains(&s) { 300.0 / stands.len() as f64 } else { 0.0 };
            assert!((of(ForceKind::Reaction) - v(0.0, -share)).length() < 1e-9, "{s} of {stands:?}: {}", of(ForceKind::Reaction));
            let rubs = if body.velocity.x > 0.0 { share * world.surfaces()[s].material.kinetic_friction } else { 0.0 };
            assert!((of(ForceKind::Friction) - v(-rubs, 0.0)).length() < 1e-9, "{s} of {stands:?}: {}", of(ForceKind::Friction));
        }
    }
    assert!(counts[1] > 0 && counts[2] > 0 && counts[3] > 0, "{counts:?}");
}

/// 9 m/s on asphalt, half on each while the seam is below, then on ice: by v² = v₀² − 2∫μg dx.
#[test]
fn friction_changes_where_the_seam_is() {
    let (asphalt, ice) = (Material::ASPHALT, Material::ICE);
    let floor = vec![tile(-9.0, 0.0, asphalt), tile(0.0, 30.0, ice)];
    for rate in [60.0, 120.0, 240.0] {
        let mut world = World::new(scene(floor.clone(), vec![crate_at(-3.0, 9.0)])).unwrap();
        while world.at(0).x < 1.5 {
            world.step(1.0 / rate);
        }
        let body = world.body(BodyId(0));
        let path = asphalt.kinetic_friction * 3.0 + ice.kinetic_friction * body.position.x;
        let speed = (81.0 - 2.0 * G * path).sqrt();
        // Either edge of the overlap counts from a few nanometres on.
        assert!((body.velocity.x - speed).abs() < 1e-8, "{rate} Hz: {} and {speed} m/s", body.velocity.x);
    }
}

/// A ship a little heavier than the balls of a cradle follows them with the rest of its speed: nothing is given up, and the answer is as near
/// to that of equal masses as the masses are.
#[test]
fn a_cradle_struck_by_almost_its_own_mass_answers_almost_alike() {
    let end = |mass: f64| {
        let ball = |x: f64, speed: f64, mass: f64| BodyDef { restitution: 1.0, mass, ..crate_at(x, speed) };
        let mut bodies = vec![ball(-4.0, 8.0, mass)];
        bodies.extend((0..5).map(|x| ball(f64::from(x), 0.0, 20.0)));
        let floor = vec![tile(-20.0, -0.5, Material::ICE), tile(-0.5, 40.0, Material::STEEL)];
        let mut world = World::new(scene(floor, bodies)).unwrap();
        run(&mut world, 2.0, 120.0);
        assert_eq!((world.guards().budgets_used_up, world.guards().dense_ticks), (0, 0), "{mass} kg");
        world.bodies().iter().map(|body| body.position.x).collect::<Vec<_>>()
    };
    let equal = end(20.0);
    for mass in [19.9998, 20.0002] {
        assert!(end(mass).iter().zip(&equal).all(|(x, other)| (x - other).abs() < 1e-3), "{mass} kg");
    }
}

/// The instant at which a flush contact begins is found once, though the place at that instant is beside it by a rounding.
#[test]
fn a_crate_that_slides_along_seams_uses_up_no_budget() {
    let wall = |k: i32, left: f64| {
        let (top, material) = (f64::from(k) * 1.5, if k % 2 == 0 { Material::WOOD } else { Material::ICE });
        SurfaceDef::fixed(area(left, top, left + 1.0, top + 1.5), material)
    };
    for (speed, wind, shaft) in
        [(-9.0, 0.0, false), (-9.0, 0.0, true), (9.0, 300.0, true), (-13.3, 300.0, true), (1.7, 300.0, false)]
    {
        let mut surfaces: Vec<SurfaceDef> = (-20..20).map(|k| wall(k, -1.5)).collect();
        surfaces.extend((-20..20).filter(|_| shaft).map(|k| wall(k, 0.5)));
        let body = BodyDef { velocity: v(0.0, speed), ..crate_at(0.0, 0.0) };
        let mut def = scene(surfaces, vec![body]);
        def.streams.push(StreamDef { zone: area(-30.0, -6.2, 30.0, 30.0), force: v(-10.0, -wind) });
        let mut world = World::new(def).unwrap();
        (0..240).for_each(|_| world.step(1.0 / 120.0));
        assert_eq!(world.guards().budgets_used_up, 0, "{speed} m/s, {wind} N");
    }
}
