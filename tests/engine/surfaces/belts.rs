//! Platforms that move along, and belts: static friction carries, kinetic friction slips.

use super::*;

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
        let gentle = static_friction * G * (1.0 - 1e-9);
        let path = once(&[leg(2.0, v(0.0, 0.0), v(gentle, 0.0))]);
        let ice = |path| SurfaceDef { material: Material::ICE, bounds: area(-9.0, 0.0, 9.0, 1.0), ..platform(path) };
        let mut held = world(vec![ice(path)], vec![block(0.0, 0.0, 4.0)]);
        run(&mut held, 1.9, rate, |_, _| ());
        let exact = 0.5 * gentle * (1.9 * rate).round() / rate * (1.9 * rate).round() / rate;
        within("held below μ_s·g: place, m", (position(&held, 0).x - exact).abs(), EXACT);
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

/// A rider slides (2u)²/(2μ_k·g) along it, then rides back.
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

/// The first holds the box until it has left it, the second takes it along at its own speed.
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
