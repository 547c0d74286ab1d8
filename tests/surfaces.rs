//! Surfaces that move, against exact answers: lifts, platforms, belts, walls that push, one-way platforms, presses and doors.

use resultant::physics::{
    Aabb, BodyDef, BodyId, DVec2, Event, ForceKind, Leg, Material, Obstacle, Path, Sides, Source, SurfaceDef, World, WorldDef,
};

const G: f64 = 15.0;
const AIR: f64 = 1.2041;
const RATES: [f64; 4] = [30.0, 60.0, 120.0, 240.0];
/// s. Long enough for a drift to show.
const MINUTE: f64 = 60.0;
/// m, m/s. The bar for what is exact.
const EXACT: f64 = 1e-9;
/// Relative. The bar for forces.
const FORCE: f64 = 1e-12;

fn v(x: f64, y: f64) -> DVec2 {
    DVec2::new(x, y)
}

fn area(left: f64, top: f64, right: f64, bottom: f64) -> Aabb {
    Aabb::new(v(left, top), v(right, bottom))
}

fn leg(duration: f64, velocity: DVec2, acceleration: DVec2) -> Leg {
    Leg { duration, velocity, acceleration }
}

/// Along these legs, once.
fn once(legs: &[Leg]) -> Path {
    Path { legs: legs.to_vec(), repeats: false }
}

fn mover(bounds: Aabb, path: Path) -> SurfaceDef {
    SurfaceDef { path, ..SurfaceDef::fixed(bounds, Material::ASPHALT) }
}

/// 4 m wide, its top at y = 0 and its middle at x = 0.
fn platform(path: Path) -> SurfaceDef {
    mover(area(-2.0, 0.0, 2.0, 0.5), path)
}

/// 1 m × 1 m; its bottom edge at `bottom`.
fn block(x: f64, bottom: f64, mass: f64) -> BodyDef {
    BodyDef { position: v(x, bottom - 0.5), mass, ..BodyDef::default() }
}

fn floor() -> SurfaceDef {
    SurfaceDef::fixed(area(-1e4, 0.0, 1e4, 1.0), Material::ASPHALT)
}

fn world_in(air_density: f64, surfaces: Vec<SurfaceDef>, bodies: Vec<BodyDef>) -> World {
    World::new(WorldDef { gravity: G, air_density, rest_speed: 0.0, surfaces, bodies, ..WorldDef::default() }).unwrap()
}

fn world(surfaces: Vec<SurfaceDef>, bodies: Vec<BodyDef>) -> World {
    world_in(0.0, surfaces, bodies)
}

/// Steps through `seconds`, and tells the time after each tick.
fn run(world: &mut World, seconds: f64, rate: f64, mut after: impl FnMut(&World, f64)) {
    for tick in 1..=(seconds * rate).round() as u32 {
        world.step(1.0 / rate);
        after(world, f64::from(tick) / rate);
    }
}

fn position(world: &World, body: u32) -> DVec2 {
    world.body(BodyId(body)).position
}

fn velocity(world: &World, body: u32) -> DVec2 {
    world.body(BodyId(body)).velocity
}

fn centre(world: &World, surface: usize) -> DVec2 {
    world.surfaces()[surface].bounds.centre()
}

/// Tells a figure, and holds it to its bar.
#[track_caller]
fn within(what: &str, error: f64, bar: f64) {
    println!("{what}: {error:.1e} (bar {bar:.0e})");
    assert!(error <= bar, "{what}: {error:e}, expected at most {bar:e}");
}

/// The deepest overlap of a body with another, or with a surface that is solid all around, m.
fn overlap(world: &World) -> f64 {
    let boxes: Vec<Aabb> = world.bodies().iter().map(|body| body.bounds()).collect();
    let solid: Vec<Aabb> = world.surfaces().iter().filter(|surface| surface.present).map(|surface| surface.bounds).collect();
    let mut worst = 0.0f64;
    for (i, a) in boxes.iter().enumerate() {
        worst = boxes[i + 1..].iter().chain(&solid).map(|b| -a.gap(b).max_element()).fold(worst, f64::max);
    }
    worst
}

fn crushed(world: &World) -> Vec<(u32, u32, f64)> {
    let crush = |event: &Event| match *event {
        Event::Crushed { body, by, force } => Some((body.0, by, force)),
        Event::Impact { .. } => None,
    };
    world.events().iter().filter_map(crush).collect()
}

/// The Reaction of a surface on a body along y, N, upwards.
fn reaction(world: &World, body: u32, surface: u32) -> f64 {
    let forces = world.forces(BodyId(body));
    let of = forces.forces().iter().filter(|force| force.kind == ForceKind::Reaction && force.source == Source::Surface(surface));
    -of.map(|force| force.vector.y).sum::<f64>()
}

/// The Push of body `from` on body `to` along x, N.
fn push(world: &World, from: u32, to: u32) -> f64 {
    let forces = world.forces(BodyId(to));
    let of = forces.forces().iter().filter(|force| force.kind == ForceKind::Push && force.source == Source::Body(BodyId(from)));
    of.map(|force| force.vector.x).sum()
}

// ---- 1. Lifts

/// A column on a lift that eases in and out keeps its place on it, and the lift carries m(g + a).
#[test]
fn a_column_rides_a_lift() {
    let path = Path::shuttle(v(0.0, -6.0), 4.0, 1.0, 0.5);
    let (mut drift, mut error) = (0.0f64, 0.0f64);
    for rate in RATES {
        for riders in [1u32, 3, 10] {
            for air in [0.0, AIR] {
                let bodies: Vec<_> = (0..riders).map(|i| block(0.1, -f64::from(i), 1.0 + 3.0 * f64::from(i))).collect();
                let mass: f64 = bodies.iter().map(|body| body.mass).sum();
                let mut world = world_in(air, vec![platform(path.clone())], bodies);
                run(&mut world, MINUTE, rate, |world, t| {
                    let lift = centre(world, 0);
                    for i in 0..riders {
                        let place = position(world, i) - lift - v(0.1, -0.75 - f64::from(i));
                        drift = drift.max(place.abs().max_element());
                    }
                    let point = path.at(t);
                    let turns = path.at(t - 1e-9).acceleration != path.at(t + 1e-9).acceleration;
                    if air == 0.0 && !turns {
                        let exact = mass * (G - point.acceleration.y);
                        error = error.max((reaction(world, 0, 0) - exact).abs() / exact);
                    }
                });
                assert_eq!(world.guards().budgets_used_up, 0);
            }
        }
    }
    within("lift, 1, 3 and 10 riders, 30 to 240 Hz, with air and without: drift in 60 s, m", drift, EXACT);
    within("lift: Reaction against m(g + a), relative", error, FORCE);
}

/// A lift that starts at once hits its rider; when it stops at once the rider flies on and comes back to it.
#[test]
fn a_lift_that_starts_and_stops_at_once() {
    let speed = 3.0;
    for rate in RATES {
        let path = once(&[leg(0.51, v(0.0, 0.0), v(0.0, 0.0)), leg(1.0, v(0.0, -speed), v(0.0, 0.0))]);
        let mut world = world(vec![platform(path)], vec![block(0.0, 0.0, 2.0)]);
        let (mut hits, mut highest, mut landed) = (vec![], 0.0f64, 0.0);
        run(&mut world, 3.0, rate, |world, t| {
            for impulse in world.impulses().iter().filter(|impulse| impulse.vector.length() > 1e-9) {
                hits.push((impulse.vector.y, t - 1.0 / rate + impulse.at));
            }
            highest = highest.max(-position(world, 0).y);
            landed = t;
        });
        let back = 1.51 + 2.0 * speed / G;
        assert_eq!(hits.len(), 2, "{hits:?}");
        within("lift starts at once: impulse against m·v, N·s", (hits[0].0 + 2.0 * speed).abs(), 1e-12);
        within("lift starts at once: when, s", (hits[0].1 - 0.51).abs(), 1e-12);
        within("lift stops at once: rider lands, s", (hits[1].1 - back).abs(), EXACT);
        within("lift stops at once: with what impulse, N·s", (hits[1].0 + 2.0 * speed).abs(), EXACT);
        within("lift stops at once: place in the end, m", (position(&world, 0).y + 3.5).abs(), EXACT);
        assert!(highest <= 3.5 + speed * speed / (2.0 * G) + EXACT);
    }
}

/// A lift that is pulled away downwards faster than its rider can fall: it parts, and is caught at the right time and speed.
#[test]
fn a_rider_parts_from_a_lift_that_falls_faster_and_is_caught_again() {
    // Down with 25 m/s² for 0.4 s, then steadily with 10 m/s: ½·15·t² = 2 + 10·(t − 0.4).
    let path = once(&[leg(0.4, v(0.0, 0.0), v(0.0, 25.0)), leg(1e6, v(0.0, 10.0), v(0.0, 0.0))]);
    let (caught, closing) = ((10.0 + 40f64.sqrt()) / 15.0, 40f64.sqrt());
    for rate in RATES {
        for e in [0.0, 0.5, 1.0] {
            let mut world = world(vec![platform(path.clone())], vec![BodyDef { restitution: e, ..block(0.0, 0.0, 3.0) }]);
            let mut first = None;
            run(&mut world, 1.2, rate, |world, t| {
                if let Some(Event::Impact { speed, .. }) = world.events().first()
                    && first.is_none()
                {
                    first = Some((*speed, t - 1.0 / rate + world.impulses()[0].at));
                }
            });
            let (speed, at) = first.unwrap();
            within("caught: closing speed, m/s", (speed - closing).abs(), EXACT);
            within("caught: when, s", (at - caught).abs(), EXACT);
            let after = 1.2 - caught;
            let exact = if e == 0.0 { 10.0 } else { 10.0 - e * closing + G * after };
            within("caught: velocity after, m/s", (velocity(&world, 0).y - exact).abs(), EXACT);
        }
    }
}

/// Bounces on a lift that moves steadily are those on the ground, as seen from the lift.
#[test]
fn bounces_on_a_steady_lift_end_as_on_the_ground() {
    for (e, lift) in [(0.5, -4.0), (0.9, 4.0), (0.5, 4.0), (1.0, -4.0)] {
        let seconds = 12.0;
        let path = once(&[leg(1e6, v(0.0, lift), v(0.0, 0.0))]);
        let body = BodyDef { restitution: e, velocity: v(0.0, lift), ..block(0.0, -2.0, 1.0) };
        let still = BodyDef { restitution: e, ..block(0.0, -2.0, 1.0) };
        let mut moving = world(vec![platform(path)], vec![body]);
        let mut standing = world(vec![platform(Path::default())], vec![still]);
        let mut worst = 0.0f64;
        run(&mut moving, seconds, 60.0, |moving, t| {
            standing.step(1.0 / 60.0);
            let seen = position(moving, 0) - v(0.0, lift * t);
            worst = worst.max((seen - position(&standing, 0)).length());
        });
        within(&format!("bounces with e = {e} on a lift at {lift} m/s, against those on the ground, m"), worst, 1e-8);
        assert_eq!(moving.guards().budgets_used_up, 0);
    }
}

// ---- 2. Platforms

/// Static friction carries what stands on a platform, whatever stands on that too.
#[test]
fn riders_of_a_platform_stay_where_they_are() {
    let path = Path::shuttle(v(8.0, 0.0), 4.0, 1.0, 0.3);
    let mut drift = 0.0f64;
    for rate in RATES {
        for air in [0.0, AIR] {
            let bodies = vec![block(-1.0, 0.0, 5.0), block(-0.9, -1.0, 2.0), block(0.8, 0.0, 60.0), block(0.8, -1.0, 0.5)];
            let starts: Vec<DVec2> = bodies.iter().map(|body| body.position).collect();
            let mut world = world_in(air, vec![platform(path.clone())], bodies);
            run(&mut world, MINUTE, rate, |world, _| {
                for (i, start) in (0..).zip(&starts) {
                    let place = position(world, i) - (centre(world, 0) - v(0.0, 0.25)) - *start;
                    drift = drift.max(place.abs().max_element());
                }
            });
        }
    }
    within("platform with riders of riders: drift in 60 s, m", drift, EXACT);
}

/// Beyond μ_s·g a rider slips, with μ_k·g, until it is as fast as the platform.
#[test]
fn a_rider_slips_where_static_friction_gives_way() {
    let (static_friction, kinetic_friction) = (Material::ICE.static_friction, Material::ICE.kinetic_friction);
    let pull = kinetic_friction * G;
    for rate in RATES {
        // Just below the limit it holds.
        let gentle = static_friction * G * (1.0 - 1e-9);
        let path = once(&[leg(2.0, v(0.0, 0.0), v(gentle, 0.0))]);
        let ice = |path| SurfaceDef { material: Material::ICE, bounds: area(-9.0, 0.0, 9.0, 1.0), ..platform(path) };
        let mut held = world(vec![ice(path)], vec![block(0.0, 0.0, 4.0)]);
        run(&mut held, 1.9, rate, |_, _| ());
        let exact = 0.5 * gentle * (1.9 * rate).round() / rate * (1.9 * rate).round() / rate;
        within("held below μ_s·g: place, m", (position(&held, 0).x - exact).abs(), EXACT);
        // Just above it does not.
        let path = once(&[leg(1.0, v(0.0, 0.0), v(2.0, 0.0)), leg(1e6, v(2.0, 0.0), v(0.0, 0.0))]);
        let mut world = world(vec![ice(path)], vec![block(0.0, 0.0, 4.0)]);
        run(&mut world, 6.0, rate, |world, t| {
            let stops = 2.0 / pull;
            let exact = if t < stops { 0.5 * pull * t * t } else { 0.5 * pull * stops * stops + 2.0 * (t - stops) };
            let error = (position(world, 0).x - exact).abs();
            assert!(error < EXACT, "at {t} s: {error} m");
        });
        assert_eq!(velocity(&world, 0), v(2.0, 0.0));
    }
}

/// A platform that reverses at once: what stands on it slides (2u)²/(2μ_k·g) along it, then rides back.
#[test]
fn a_platform_reverses_at_once() {
    let (speed, pull) = (3.0, Material::ASPHALT.kinetic_friction * G);
    for rate in RATES {
        let path = once(&[leg(1.003, v(speed, 0.0), v(0.0, 0.0)), leg(1.0, v(-speed, 0.0), v(0.0, 0.0))]);
        let mut world = world(vec![platform(path)], vec![BodyDef { velocity: v(speed, 0.0), ..block(-1.0, 0.0, 4.0) }]);
        run(&mut world, 1.9, rate, |_, _| ());
        let slid = position(&world, 0).x - centre(&world, 0).x + 1.0;
        within("platform reverses at once: slid, m", (slid - 4.0 * speed * speed / (2.0 * pull)).abs(), EXACT);
    }
}

// ---- 3. Belts

/// A box dropped on a belt.
#[test]
fn a_belt_takes_along_what_is_dropped_on_it() {
    let (speed, pull) = (4.0, Material::ASPHALT.kinetic_friction * G);
    for rate in RATES {
        for belt in [speed, -speed] {
            let mut def = mover(area(-50.0, 0.0, 50.0, 0.5), Path::default());
            def.belt = belt;
            let mut world = world(vec![def], vec![block(0.0, 0.0, 7.0)]);
            let taken = speed / pull;
            run(&mut world, 5.0, rate, |world, t| {
                let exact = if t < taken { 0.5 * pull * t * t } else { speed * t - speed * speed / (2.0 * pull) };
                let error = (position(world, 0).x - exact * belt.signum()).abs();
                assert!(error < EXACT, "at {t} s: {error} m");
            });
            assert_eq!(velocity(&world, 0), v(belt, 0.0));
            let slid = speed * 5.0 - position(&world, 0).x.abs();
            within("belt: slid back, m", (slid - speed * speed / (2.0 * pull)).abs(), EXACT);
        }
    }
}

/// A box that is pressed against a belt from the side, or from below, goes with it.
#[test]
fn a_belt_takes_along_what_is_pressed_against_it() {
    let (mass, press) = (2.0, 100.0);
    let friction = Material::ASPHALT.kinetic_friction * press;
    // Side: the belt's speed, where the box is, which way it is pressed, which way the skin runs there.
    let sides = [
        ("right side, climbing", -3.0, v(1.5, 0.0), v(-press, 0.0), v(0.0, -3.0)),
        ("left side, climbing", 3.0, v(-1.5, 0.0), v(press, 0.0), v(0.0, -3.0)),
        ("bottom", 3.0, v(0.0, 50.5), v(0.0, -press - mass * G), v(-3.0, 0.0)),
    ];
    for rate in RATES {
        for (name, belt, at, drive, skin) in sides {
            let mut def = mover(area(-1.0, -50.0, 1.0, 50.0), Path::default());
            if at.x == 0.0 {
                def.bounds = area(-50.0, -50.0, 50.0, 50.0);
            }
            def.belt = belt;
            let mut world = world(vec![def], vec![BodyDef { position: at, mass, ..BodyDef::default() }]);
            world.set_drive(BodyId(0), drive);
            let along = skin.normalize();
            let weight = along.y * mass * G;
            let taken = 3.0 / ((friction + weight) / mass);
            run(&mut world, 3.0, rate, |world, t| {
                let exact = if t < taken { 0.5 * (3.0 / taken) * t * t } else { 3.0 * (t - 0.5 * taken) };
                let error = (position(world, 0) - at - along * exact).length();
                assert!(error < EXACT, "{name}, {t} s: {error} m");
            });
            assert_eq!(velocity(&world, 0), skin, "{name}");
        }
        // Pressed too gently it slides down the belt: μ_k·N < m·g.
        let mut def = mover(area(-1.0, -50.0, 1.0, 50.0), Path::default());
        def.belt = -3.0;
        let mut world = world(vec![def], vec![BodyDef { position: v(1.5, 0.0), mass, ..BodyDef::default() }]);
        world.set_drive(BodyId(0), v(-40.0, 0.0));
        run(&mut world, 1.0, rate, |_, _| ());
        let exact = 0.5 * (G - Material::ASPHALT.kinetic_friction * 40.0 / mass);
        within("pressed too gently: slides down, m", (position(&world, 0).y - exact).abs(), EXACT);
    }
}

/// From one belt to the next: the first holds the box until it has left it, the second takes it along at its own speed.
#[test]
fn two_belts_end_to_end() {
    let pull = Material::ASPHALT.kinetic_friction * G;
    for rate in RATES {
        let mut slow = mover(area(-20.0, 0.0, 0.0, 0.5), Path::default());
        let mut fast = mover(area(0.0, 0.0, 90.0, 0.5), Path::default());
        (slow.belt, fast.belt) = (1.0, 5.0);
        let mut world = world(vec![slow, fast], vec![BodyDef { velocity: v(1.0, 0.0), ..block(-2.5, 0.0, 3.0) }]);
        run(&mut world, 8.0, rate, |_, _| ());
        // 3 m at 1 m/s until it has left the first belt, then from 1 to 5 m/s.
        let taken = 4.0 / pull;
        let exact = 0.5 + taken + 0.5 * pull * taken * taken + 5.0 * (8.0 - 3.0 - taken);
        within("two belts end to end: place, m", (position(&world, 0).x - exact).abs(), 1e-8);
        assert_eq!(velocity(&world, 0), v(5.0, 0.0));
    }
}

/// A belt on a platform that moves: the sum of both.
#[test]
fn a_belt_on_a_moving_platform() {
    let pull = Material::ASPHALT.kinetic_friction * G;
    for rate in RATES {
        let mut def = mover(area(-50.0, 0.0, 50.0, 0.5), once(&[leg(1e6, v(2.0, -1.0), v(0.0, 0.0))]));
        def.belt = 3.0;
        let mut world = world(vec![def], vec![BodyDef { velocity: v(0.0, -1.0), ..block(0.0, 0.0, 7.0) }]);
        let taken = 5.0 / pull;
        run(&mut world, 4.0, rate, |world, t| {
            let x = if t < taken { 0.5 * pull * t * t } else { 5.0 * (t - 0.5 * taken) };
            let error = (position(world, 0) - v(x, -0.5 - t)).length();
            assert!(error < EXACT, "at {t} s: {error} m");
        });
        assert_eq!(velocity(&world, 0).x, 5.0);
    }
}

// ---- 4. Walls that push

/// A wall that pushes a row: each contact carries what accelerates and drags all that is ahead of it.
#[test]
fn a_wall_pushes_a_row() {
    let rub = Material::ASPHALT.kinetic_friction * G;
    let mut worst = 0.0f64;
    for rate in RATES {
        for count in [1u32, 5, 20] {
            for pull in [0.0, 3.0] {
                let path = once(&[leg(1e3, v(2.0, 0.0), v(pull, 0.0))]);
                let wall = mover(area(-1.0, -5.0, 0.0, -0.001), path);
                let bodies: Vec<_> = (0..count)
                    .map(|i| BodyDef { velocity: v(2.0, 0.0), ..block(0.5 + f64::from(i), 0.0, 1.0 + f64::from(i % 4)) })
                    .collect();
                let masses: Vec<f64> = bodies.iter().map(|body| body.mass).collect();
                let mut world = world(vec![floor(), wall], bodies);
                run(&mut world, 2.0, rate, |world, t| {
                    let exact = 2.0 * t + 0.5 * pull * t * t;
                    for i in 0..count {
                        let error = (position(world, i).x - exact - 0.5 - f64::from(i)).abs();
                        assert!(error < EXACT, "{count} at {t} s: body {i} off by {error} m");
                    }
                    for i in 0..count as usize {
                        let ahead: f64 = masses[i..].iter().sum();
                        let force = if i == 0 {
                            let forces = world.forces(BodyId(0));
                            let of = forces.forces().iter().filter(|force| force.source == Source::Surface(1));
                            of.map(|force| force.vector.x).sum()
                        } else {
                            push(world, i as u32 - 1, i as u32)
                        };
                        worst = worst.max((force / (ahead * (pull + rub)) - 1.0).abs());
                    }
                });
            }
        }
    }
    within("a wall pushes 1, 5 and 20: forces against Σm·(a + μ_k·g), relative", worst, FORCE);
}

/// A wall hits a block that rests: e = 0, it goes with the wall; e = 1, it leaves with twice its speed.
#[test]
fn a_wall_hits_a_block() {
    for rate in RATES {
        for (e, speed) in [(0.0, 3.0), (0.5, 3.0), (1.0, 3.0)] {
            let wall = mover(area(-3.0, -2.0, -2.0, 2.0), once(&[leg(1e6, v(speed, 0.0), v(0.0, 0.0))]));
            let def = WorldDef {
                gravity: 0.0,
                air_density: 0.0,
                rest_speed: 0.0,
                surfaces: vec![wall],
                bodies: vec![BodyDef { restitution: e, ..BodyDef::default() }],
                ..WorldDef::default()
            };
            let mut world = World::new(def).unwrap();
            run(&mut world, 1.5, rate, |_, _| ());
            let exact = (1.0 + e) * speed;
            within("a wall hits a block: its speed, m/s", (velocity(&world, 0).x - exact).abs(), 1e-12);
            within("a wall hits a block: its place, m", (position(&world, 0).x - exact).abs(), EXACT);
        }
    }
}

// ---- 5. At any speed

/// Nothing gets through, however fast either moves.
#[test]
fn nothing_gets_through_at_any_speed() {
    let mut deepest = 0.0f64;
    for rate in RATES {
        for speed in [1.0, 100.0, 1e4, 1e6] {
            for e in [0.0, 1.0] {
                // A thin wall against a block that rests, and one that flies against it.
                for flies in [0.0, -1.0] {
                    let seconds = 30.0 / rate;
                    let start = speed * seconds * 0.37 + 0.1;
                    let wall = mover(area(-start - 0.05, -2.0, -start, 2.0), once(&[leg(1e3, v(speed, 0.0), v(0.0, 0.0))]));
                    let body = BodyDef { restitution: e, velocity: v(flies * speed, 0.0), half: v(0.1, 0.1), ..BodyDef::default() };
                    let def = WorldDef {
                        gravity: 0.0,
                        air_density: 0.0,
                        rest_speed: 0.0,
                        surfaces: vec![wall],
                        bodies: vec![body],
                        ..WorldDef::default()
                    };
                    let mut world = World::new(def).unwrap();
                    run(&mut world, seconds, rate, |world, _| {
                        let ahead = position(world, 0).x - 0.1 - world.surfaces()[0].bounds.max.x;
                        deepest = deepest.max(-ahead / (1.0 + speed / rate));
                    });
                    let exact = speed * (1.0 + e * (1.0 - flies));
                    within("caught: velocity, relative", (velocity(&world, 0).x / exact - 1.0).abs(), 1e-12);
                }
            }
        }
    }
    within("walls at 1 to 1e6 m/s: deepest overlap by 1 + speed·dt", deepest, EXACT);
}

/// A row of blocks that are hit at a great speed: the engine looks further than it foresaw.
#[test]
fn a_fast_wall_throws_a_block_at_others() {
    for rate in RATES {
        for speed in [100.0, 1e4, 1e6] {
            let wall = mover(area(-2.0, -2.0, -1.0, 2.0), once(&[leg(1e3, v(speed, 0.0), v(0.0, 0.0))]));
            let far = 0.4 * speed / rate;
            let bodies =
                [0.0, far + 3.0, 1.5 * far + 6.0].map(|x| BodyDef { position: v(x, 0.0), restitution: 1.0, ..BodyDef::default() });
            let def = WorldDef {
                gravity: 0.0,
                air_density: 0.0,
                rest_speed: 0.0,
                surfaces: vec![wall],
                bodies: bodies.to_vec(),
                ..WorldDef::default()
            };
            let mut world = World::new(def).unwrap();
            run(&mut world, 40.0 / rate, rate, |world, _| {
                let at = |i| position(world, i).x;
                assert!(at(0) + 1.0 <= at(1) + EXACT * (1.0 + speed / rate) && at(1) + 1.0 <= at(2) + EXACT * (1.0 + speed / rate));
                assert!(world.surfaces()[0].bounds.max.x <= at(0) - 0.5 + EXACT * (1.0 + speed / rate));
            });
            // The cradle: each gives its speed on to the next, and is hit by the wall again.
            for i in 0..3 {
                within("thrown: velocity, relative", (velocity(&world, i).x / (2.0 * speed) - 1.0).abs(), 1e-12);
            }
        }
    }
}

// ---- 6. One-way platforms

fn one_way(sides: Sides, path: Path) -> SurfaceDef {
    SurfaceDef { sides, bounds: area(-2.0, 0.0, 2.0, 0.3), ..mover(area(0.0, 0.0, 1.0, 1.0), path) }
}

/// Upwards through it at any speed as if it were not there; from above it carries.
#[test]
fn a_one_way_platform_lets_through_from_below_and_carries_from_above() {
    for rate in RATES {
        for speed in [9.0, 12.0, 40.0, 1e3, 1e5] {
            let body = BodyDef { velocity: v(0.0, -speed), ..block(0.0, 2.0, 1.0) };
            let mut through = world(vec![one_way(Sides::TOP, Path::default())], vec![body.clone()]);
            let mut free = world(vec![], vec![body]);
            let up = ((speed / G).min(0.5) * rate).floor() / rate;
            run(&mut through, up, rate, |through, _| {
                free.step(1.0 / rate);
                let error = position(through, 0).distance(position(&free, 0));
                assert!(error <= 1e-15 * (speed + 1.0), "at {speed} m/s: {error} m");
            });
        }
        // 9 m/s from 2 m below: its bottom gets to 0.7 m above the platform, and lands.
        let mut world =
            world(vec![one_way(Sides::TOP, Path::default())], vec![BodyDef { velocity: v(0.0, -9.0), ..block(0.0, 2.0, 1.0) }]);
        run(&mut world, 3.0, rate, |_, _| ());
        within("one-way: lands, m", (position(&world, 0).y + 0.5).abs(), 1e-15);
        let stands = position(&world, 0);
        run(&mut world, 180.0, rate, |world, _| {
            assert_eq!((position(world, 0), velocity(world, 0)), (stands, DVec2::ZERO));
        });
        assert_eq!(reaction(&world, 0, 0), G);
    }
}

/// What does not get out of it on top falls back; what comes from the side passes.
#[test]
fn a_one_way_platform_catches_nothing_inside_or_from_the_side() {
    for rate in RATES {
        // Its bottom gets to 0.15 m below the platform's top.
        let speed = (2.0 * G * 1.85f64).sqrt();
        let cases = [
            BodyDef { velocity: v(0.0, -speed), ..block(0.0, 2.0, 1.0) },
            BodyDef { velocity: v(30.0, 0.0), position: v(-4.0, -0.45), ..BodyDef::default() },
            BodyDef { velocity: v(-300.0, 0.0), position: v(4.0, 0.1), ..BodyDef::default() },
            block(0.0, 0.2, 1.0),
        ];
        for body in cases {
            let mut through = world(vec![one_way(Sides::TOP, Path::default())], vec![body.clone()]);
            let mut free = world(vec![], vec![body]);
            run(&mut through, 1.0, rate, |through, _| {
                free.step(1.0 / rate);
                assert!(position(through, 0).distance(position(&free, 0)) < 1e-12);
            });
        }
    }
}

/// Solid from one other side only.
#[test]
fn other_sides_of_a_one_way_surface() {
    let none = Sides { left: false, right: false, top: false, bottom: false };
    let cases = [
        (Sides { left: true, ..none }, v(1.0, 0.0)),
        (Sides { right: true, ..none }, v(-1.0, 0.0)),
        (Sides { top: true, ..none }, v(0.0, 1.0)),
        (Sides { bottom: true, ..none }, v(0.0, -1.0)),
    ];
    for (sides, way) in cases {
        for (coming, stops) in [(way, true), (-way, false), (v(way.y, way.x), false), (v(-way.y, -way.x), false)] {
            for speed in [2.0, 2e4] {
                let body = BodyDef { position: coming * -3.0, velocity: coming * speed, ..BodyDef::default() };
                let surface = SurfaceDef { sides, bounds: area(-1.0, -1.0, 1.0, 1.0), ..SurfaceDef::default() };
                let def =
                    WorldDef { gravity: 0.0, air_density: 0.0, surfaces: vec![surface], bodies: vec![body], ..WorldDef::default() };
                let mut world = World::new(def).unwrap();
                run(&mut world, 4.0, 60.0, |_, _| ());
                let exact = if stops { -1.5 } else { 4.0 * speed - 3.0 };
                within("one-way from all sides: place, m", (position(&world, 0).dot(coming) - exact).abs(), EXACT);
            }
        }
    }
}

/// A one-way lift carries up and down, and takes up what it comes to from below.
#[test]
fn a_one_way_lift_carries() {
    for rate in RATES {
        let path = Path::shuttle(v(3.0, -6.0), 3.0, 0.5, 0.2);
        let mut world =
            world(vec![one_way(Sides::TOP, path)], vec![block(0.3, 0.0, 1.0), block(-0.9, 0.0, 8.0), block(0.3, -1.0, 2.0)]);
        let mut drift = 0.0f64;
        run(&mut world, MINUTE, rate, |world, _| {
            for (i, at) in [(0, v(0.3, -0.65)), (1, v(-0.9, -0.65)), (2, v(0.3, -1.65))] {
                drift = drift.max((position(world, i) - centre(world, 0) - at).abs().max_element());
            }
        });
        within("one-way lift: drift in 60 s, m", drift, EXACT);
    }
}

/// A body that rests on the floor when a one-way platform sinks past it, and rises again: it is let through, then taken up.
#[test]
fn a_one_way_lift_passes_what_it_meets_from_its_open_side() {
    for rate in RATES {
        // From 3 m above the floor into it, and back up.
        let path = Path::shuttle(v(0.0, 4.0), 2.0, 0.5, 0.1);
        let mut lift = one_way(Sides::TOP, path);
        lift.bounds = area(-2.0, -3.0, 2.0, -2.7);
        let mut world = world(vec![floor(), lift], vec![block(0.0, 0.0, 1.0)]);
        let (mut lowest, mut crushes) = (f64::NEG_INFINITY, 0);
        run(&mut world, 2.15, rate, |world, _| {
            assert_eq!(position(world, 0), v(0.0, -0.5));
        });
        run(&mut world, 2.0, rate, |world, _| {
            lowest = lowest.max(position(world, 0).y);
            crushes += crushed(world).len();
        });
        assert_eq!(crushes, 0);
        assert!(lowest <= -0.5 + EXACT);
        within(
            "one-way: taken up from the floor, m",
            (position(&world, 0).y - world.surfaces()[1].bounds.min.y + 0.5).abs(),
            EXACT,
        );
    }
}

// ---- 7. Squeezed

/// A lift squeezes its riders against a ceiling: it waits, tells so on every tick, and goes on when they are gone.
#[test]
fn a_lift_waits_for_what_it_would_squeeze() {
    for rate in RATES {
        for (riders, ease) in [(1u32, 0.0), (1, 0.7), (5, 0.0), (5, 0.7)] {
            for e in [0.0, 0.6, 1.0] {
                let path = Path::shuttle(v(0.0, -6.0), 4.0, ease, 0.0);
                let ceiling = SurfaceDef::fixed(area(-5.0, -30.0, 5.0, -2.5 - f64::from(riders)), Material::ASPHALT);
                let bodies = (0..riders)
                    .map(|i| BodyDef { restitution: e, ..block(0.0, -f64::from(i), 2.0) })
                    // Far from all this, something rides a twin of the lift.
                    .chain([block(100.0, 0.0, 2.0)])
                    .collect();
                let mut twin = platform(path.clone());
                twin.bounds = area(98.0, 0.0, 102.0, 0.5);
                let mut world = world(vec![platform(path.clone()), ceiling, twin], bodies);
                let (mut deepest, mut first, mut ticks) = (0.0f64, None, 0u32);
                run(&mut world, 3.8, rate, |world, t| {
                    deepest = deepest.max(overlap(world));
                    let all = crushed(world);
                    assert!(all.iter().all(|crush| crush.1 == 0), "{all:?}");
                    if !all.is_empty() && first.is_none() && position(world, 0).y <= -3.0 + EXACT {
                        first = Some(t);
                    }
                    if let Some(first) = first {
                        ticks += u32::from(!all.is_empty());
                        let expected = ((t - first) * rate).round() as u32 + 1;
                        assert!(e > 0.0 || ticks == expected, "e {e}, {t} s: {ticks} ticks of {expected}");
                    }
                    let away = position(world, riders) - (centre(world, 2) + v(0.0, -0.75));
                    assert!(away.length() < EXACT, "the rider elsewhere is {away} m off");
                    let exact = path.at(t).offset.y;
                    assert!((centre(world, 2).y - 0.25 - exact).abs() < EXACT);
                });
                assert!(first.is_some(), "never squeezed: {riders} riders, ease {ease}, e {e}, {rate} Hz");
                within(
                    &format!("squeezed under a ceiling, {riders} riders, ease {ease}, e {e}, {rate} Hz: deepest overlap, m"),
                    deepest,
                    EXACT,
                );
                within("squeezed: where the lift waits, m", (world.surfaces()[0].bounds.min.y + 2.5).abs(), EXACT);
                // Pulled out of there, they let the lift go on, later by as long as it has waited.
                for i in 0..riders {
                    world.set_drive(BodyId(i), v(200.0, 0.0));
                }
                run(&mut world, 3.0, rate, |_, _| ());
                let top = world.surfaces()[0].bounds.min.y;
                assert!(top < -2.6, "{riders} riders, ease {ease}, e {e}, {rate} Hz: at {top}, {:?}", world.bodies());
            }
        }
    }
}

/// Between two walls that close, one body and a row of five.
#[test]
fn two_walls_wait_for_what_they_would_squeeze() {
    for rate in RATES {
        for (count, speeds) in [(1u32, (1.0, -1.0)), (5, (1.0, -2.0)), (1, (50.0, -3.0)), (5, (1e4, -1e4)), (1, (3.0, 1.0))] {
            let wall =
                |x: f64, speed: f64| mover(area(x - 0.5, -4.0, x + 0.5, -0.001), once(&[leg(1e3, v(speed, 0.0), v(0.0, 0.0))]));
            let bodies = (0..count).map(|i| block(f64::from(i), 0.0, 1.0 + f64::from(i))).collect();
            let mut world = world(vec![floor(), wall(-4.0, speeds.0), wall(f64::from(count) + 4.0, speeds.1)], bodies);
            let (mut deepest, mut crushes) = (0.0f64, 0);
            run(&mut world, 8.0, rate, |world, _| {
                deepest = deepest.max(overlap(world));
                crushes += crushed(world).len();
            });
            within("between two walls: deepest overlap by 1 + speed·dt", deepest / (1.0 + speeds.0 / rate), EXACT);
            assert!(crushes > 0);
            let gap = world.surfaces()[2].bounds.min.x - world.surfaces()[1].bounds.max.x;
            assert!(gap >= f64::from(count) - EXACT * (1.0 + speeds.0 / rate), "{gap}");
        }
    }
}

/// The force told is what would have given the body the speed of the surface within the tick, whatever squeezes.
#[test]
fn the_force_of_a_press() {
    for rate in RATES {
        let press = mover(area(-1.0, -5.0, 1.0, -2.0), once(&[leg(1e3, v(0.0, 0.5), v(0.0, 0.0))]));
        let mut world = world(vec![floor(), press], (0..1).map(|i| block(0.0, -f64::from(i), 4.0)).collect());
        run(&mut world, 2.5, rate, |_, _| ());
        run(&mut world, 2.5, rate, |world, _| {
            let all = crushed(world);
            assert_eq!(all.len(), 1);
            assert!((all[0].2 - 4.0 * 0.5 * rate).abs() < 1e-9, "{all:?}");
            assert_eq!((all[0].0, all[0].1), (0, 1));
        });
    }
    println!("press at 0.5 m/s on 4 kg: m·v/dt");
}

/// A press on which something rides far from what it squeezes: that rests on it while it waits, and rides on.
#[test]
fn what_rides_a_waiting_press_waits_with_it() {
    for rate in RATES {
        for wide in [3.0, 200.0] {
            let press = mover(area(-wide, -2.5, wide, -2.0), once(&[leg(1e3, v(0.0, 0.5), v(0.0, 0.0))]));
            let bodies = vec![block(0.0, 0.0, 4.0), BodyDef { velocity: v(0.0, 0.5), ..block(wide - 0.6, -2.5, 1.0) }];
            let mut world = world(vec![floor(), press], bodies);
            let mut worst = 0.0f64;
            run(&mut world, 5.0, rate, |world, _| {
                worst = worst.max((position(world, 1).y + 0.5 - world.surfaces()[1].bounds.min.y).abs());
                assert!(overlap(world) <= EXACT, "{}", overlap(world));
            });
            // When it stops dead the rider presses on: it never leaves it.
            within("rider of a waiting press: off it, m", worst, EXACT);
            within("waiting press: its place, m", (world.surfaces()[1].bounds.max.y + 1.0).abs(), EXACT);
        }
    }
}

/// What is lifted beside what is squeezed is not squeezed.
#[test]
fn a_lift_beside_a_press_goes_on() {
    for rate in RATES {
        let press = mover(area(-1.0, -4.0, 1.0, -1.0), once(&[leg(1e3, v(0.0, 0.5), v(0.0, 0.0))]));
        let lift = mover(area(1.5, 0.0, 4.0, 0.5), once(&[leg(1e3, v(0.0, -1.0), v(0.0, 0.0))]));
        let bodies = vec![block(0.0, 0.0, 4.0), block(1.6 + 0.5, 0.0, 1.0)];
        let mut world = world(vec![SurfaceDef::fixed(area(-9.0, 0.0, 1.2, 1.0), Material::ASPHALT), press, lift], bodies);
        run(&mut world, 2.0, rate, |world, t| {
            assert!(crushed(world).iter().all(|crush| crush.1 == 1), "{:?}", crushed(world));
            assert!((world.surfaces()[2].bounds.min.y + t).abs() < EXACT, "at {t}: {}", world.surfaces()[2].bounds.min.y);
            assert!((position(world, 1).y + 0.5 + t).abs() < EXACT);
        });
    }
}

// ---- 8. Doors, and surfaces that wait

/// A door closes only when nothing stands in it.
#[test]
fn a_door_waits_until_it_is_free() {
    for rate in RATES {
        let door = SurfaceDef { present: false, ..mover(area(-0.25, -3.0, 0.25, 0.0), Path::default()) };
        let mut world = world(vec![floor(), door], vec![block(0.0, 0.0, 1.0)]);
        run(&mut world, 0.5, rate, |_, _| ());
        world.set_present(1, true);
        run(&mut world, 0.5, rate, |world, _| {
            assert!(!world.surfaces()[1].present);
            assert_eq!(position(world, 0), v(0.0, -0.5));
        });
        world.set_drive(BodyId(0), v(30.0, 0.0));
        let mut free = None;
        run(&mut world, 2.0, rate, |world, _| {
            let clear = position(world, 0).x >= 0.75;
            if world.surfaces()[1].present {
                free = free.or(Some(position(world, 0).x));
            }
            assert!(overlap(world) <= EXACT);
            assert!(free.is_some() || !clear || position(world, 0).x - velocity(world, 0).x / rate < 0.75 + EXACT);
        });
        assert!(free.is_some());
        // It keeps out what comes back.
        world.set_drive(BodyId(0), v(-30.0, 0.0));
        run(&mut world, 4.0, rate, |_, _| ());
        assert_eq!((position(&world, 0), velocity(&world, 0)), (v(0.75, -0.5), DVec2::ZERO));
        world.set_present(1, false);
        world.step(1.0 / rate);
        assert!(position(&world, 0).x < 0.75);
    }
}

/// A door closes flush with a body that touches its place.
#[test]
fn a_door_closes_beside_what_touches_its_place() {
    let door = SurfaceDef { present: false, ..mover(area(-0.3, -3.0, 0.1, 0.0), Path::default()) };
    let mut world = world(vec![floor(), door], vec![block(0.1 + 0.5, 0.0, 1.0), block(-0.3 - 0.5, 0.0, 1.0)]);
    world.set_present(1, true);
    world.step(1.0 / 60.0);
    assert!(world.surfaces()[1].present);
}

/// When a surface disappears, what stood on it falls from that tick on.
#[test]
fn what_stood_on_a_surface_that_disappears_falls() {
    for rate in RATES {
        let trap = mover(area(-2.0, -10.0, 2.0, -9.5), Path::default());
        let mut world = world(vec![floor(), trap], vec![block(0.0, -10.0, 1.0), block(0.0, -11.0, 5.0)]);
        run(&mut world, 1.0, rate, |_, _| ());
        assert_eq!(velocity(&world, 1), DVec2::ZERO);
        world.set_present(1, false);
        run(&mut world, 0.5, rate, |world, t| {
            for i in 0..2 {
                assert!((position(world, i).y + 10.5 + f64::from(i) - 0.5 * G * t * t).abs() < EXACT);
            }
        });
    }
}

/// While a surface waits what rides it rests; when it goes on, also in the middle of a tick, they go with it at once.
#[test]
fn riders_rest_while_a_surface_waits_and_wake_when_it_goes_on() {
    for rate in RATES {
        let path = Path::shuttle(v(0.0, -6.0), 4.0, 1.0, 1.0037);
        let mut world = world(vec![platform(path)], vec![block(0.0, 0.0, 1.0), block(0.0, -1.0, 3.0)]);
        run(&mut world, 2.5, rate, |_, _| ());
        world.set_running(0, false);
        // It stops dead, and they fly on for a moment.
        run(&mut world, 2.0, rate, |_, _| ());
        let (waits, stands) = (centre(&world, 0), position(&world, 1));
        run(&mut world, 3.0, rate, |world, _| {
            assert_eq!((centre(world, 0), position(world, 1), velocity(world, 1)), (waits, stands, DVec2::ZERO));
        });
        world.set_running(0, true);
        let mut drift = 0.0f64;
        run(&mut world, 40.0, rate, |world, _| {
            drift = drift.max((position(world, 1) - centre(world, 0) - v(0.0, -1.75)).length());
        });
        within("lift that was stopped: drift afterwards, m", drift, EXACT);
    }
}

/// A body asleep is woken when something comes to it, and by nothing before.
#[test]
fn a_sleeper_wakes_when_a_wall_reaches_it() {
    for rate in RATES {
        let wall = mover(area(-6.0, -4.0, -5.0, -0.001), once(&[leg(1e3, v(2.0, 0.0), v(0.0, 0.0))]));
        let mut world = world(vec![floor(), wall], vec![block(0.0, 0.0, 1.0), block(1.0, 0.0, 1.0)]);
        run(&mut world, 4.0, rate, |world, t| {
            let exact = (2.0 * t - 4.5).max(0.0);
            assert!((position(world, 0).x - exact).abs() < EXACT, "at {t} s: {}", position(world, 0).x);
            assert!((position(world, 1).x - exact - 1.0).abs() < EXACT);
        });
    }
}

// ---- 10. What is refused

#[test]
fn paths_that_make_no_sense_are_refused() {
    let refuse = |path: Path, word: &str| {
        let def = WorldDef { surfaces: vec![platform(path.clone())], ..WorldDef::default() };
        let error = World::new(def).map(|_| ()).expect_err(&format!("{path:?}"));
        assert!(error.0.contains(word), "{error}");
    };
    let still = leg(1.0, DVec2::ZERO, DVec2::ZERO);
    refuse(once(&[Leg { duration: 0.0, ..still }]), "duration");
    refuse(once(&[Leg { duration: -1.0, ..still }]), "duration");
    refuse(once(&[Leg { duration: f64::NAN, ..still }]), "duration");
    refuse(once(&[Leg { duration: f64::INFINITY, ..still }]), "duration");
    refuse(once(&[Leg { velocity: v(f64::NAN, 0.0), ..still }]), "velocity");
    refuse(once(&[Leg { velocity: v(0.0, 1e13), ..still }]), "velocity");
    refuse(once(&[Leg { acceleration: v(f64::INFINITY, 0.0), ..still }]), "acceleration");
    refuse(Path { legs: vec![Leg { velocity: v(1.0, 0.0), ..still }], repeats: true }, "ends 1 m from its start");
    refuse(Path { legs: vec![], repeats: true }, "no leg");
    refuse(Path::shuttle(v(1.0, 0.0), 1.0, 0.8, 0.0), "duration");
    refuse(Path::shuttle(v(1.0, 0.0), 0.0, 0.0, 0.0), "no leg");
    refuse(Path::shuttle(v(1.0, 0.0), 1.0, 1.0, 0.0), "acceleration");
    refuse(once(&[leg(1e9, v(1e9, 0.0), DVec2::ZERO), still]), "leads");
}

/// What hits what is told with the surface's number.
#[test]
fn an_impact_names_the_surface() {
    let mut world = world(
        vec![floor(), platform(once(&[leg(0.01, DVec2::ZERO, DVec2::ZERO), leg(1.0, v(0.0, -2.0), DVec2::ZERO)]))],
        vec![block(0.0, 0.0, 1.0)],
    );
    world.step(1.0 / 60.0);
    let named =
        |event: &Event| matches!(event, Event::Impact { b: Obstacle::Surface(1), speed, .. } if (speed - 2.0).abs() < EXACT);
    assert!(world.events().iter().any(named), "{:?}", world.events());
}
