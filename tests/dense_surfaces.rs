//! Surfaces that move, run belts, are solid from some sides only or not there; and what contacts are told to have given.

mod support;

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use resultant::physics::pile::{Other, Pile, PileBody, PileDef, PileSurface};
use resultant::physics::{DVec2, Sides};
use support::dense::{G, square, surface};
use support::{Random, TICK as DT};

fn pile(bodies: Vec<PileBody>, surfaces: Vec<PileSurface>, gravity: f64) -> Pile {
    Pile::new(support::dense::scene(bodies, surfaces, gravity)).unwrap()
}

/// A lift carries a stack up and down, at any speed, to the bit of where it is.
#[test]
fn a_lift_carries_what_stands_on_it() {
    for gravity in [G, -G] {
        let down = gravity.signum();
        let mut scene = pile(
            vec![square(0.0, -0.5 * down), square(0.2, -1.5 * down), square(-0.1, -2.5 * down)],
            vec![surface(-2.0, down.min(0.0), 2.0, down.max(0.0))],
            gravity,
        );
        let start = 0.5 * down;
        let mut y = 0.0;
        for step in 0..480 {
            // Slower down than things fall.
            let speed =
                if step < 240 { -2.0 - 0.05 * f64::from(step.min(100)) } else { (0.05 * f64::from(step - 240) - 7.0).min(1.5) };
            y += speed * DT;
            scene.move_surface(0, DVec2::new(0.0, start + y * down));
            scene.step(DT);
            if step > 5 {
                for i in 0..3 {
                    let expected = (y - 0.5 - i as f64) * down;
                    assert!(
                        (scene.position(i).y - expected).abs() < 1e-9,
                        "step {step}, body {i}: {} {expected}",
                        scene.position(i).y
                    );
                    assert!((scene.velocity(i).y - speed * down).abs() < 1e-6, "step {step}, body {i}: {}", scene.velocity(i).y);
                }
            }
        }
    }
}

/// A platform that moves sideways takes along what stands on it, and what stands on that.
#[test]
fn a_platform_takes_its_riders_along() {
    let mut scene = pile(vec![square(0.0, -0.5), square(0.1, -1.5)], vec![surface(-2.0, 0.0, 2.0, 1.0)], G);
    let mut x = 0.0;
    for step in 0..240 {
        x += 3.0 * f64::from(step.min(120)) / 120.0 * DT;
        scene.move_surface(0, DVec2::new(x, 0.5));
        scene.step(DT);
    }
    for (i, offset) in [(0, 0.0), (1, 0.1)] {
        println!("law 7: rider {i} off by {} m, {} m/s", scene.position(i).x - x - offset, scene.velocity(i).x - 3.0);
        assert!(
            (scene.position(i).x - x - offset).abs() < 1e-9 && (scene.velocity(i).x - 3.0).abs() < 1e-9,
            "{}",
            scene.position(i)
        );
    }
}

/// A belt drags with μ_k·g until its speed is reached, then carries.
#[test]
fn a_belt_carries() {
    for belt in [2.0, -3.0] {
        let mut scene = pile(vec![square(0.0, -0.5)], vec![surface(-50.0, 0.0, 50.0, 1.0)], G);
        scene.set_belt(0, belt);
        (0..240).for_each(|_| scene.step(DT));
        let reach: f64 = belt.abs() / (0.65 * G);
        let exact = (belt.abs() * (2.0 - reach) + 0.5 * belt.abs() * reach) * belt.signum();
        println!("law 7: belt {belt}: {} m, exact {exact}", scene.position(0).x);
        assert!((scene.velocity(0).x - belt).abs() < 1e-12 && (scene.position(0).x - exact).abs() < 1e-9, "{}", scene.position(0));
    }
    // The right side runs down, the left side up.
    for (x, press, runs) in [(1.5, -40.0, 2.0), (-1.5, 40.0, -2.0)] {
        let mut scene = pile(vec![square(x, 0.0)], vec![surface(-1.0, -90.0, 1.0, 90.0)], G);
        scene.set_belt(0, 2.0);
        scene.set_force(0, DVec2::new(press, 0.0));
        (0..240).for_each(|_| scene.step(DT));
        assert!((scene.velocity(0).y - runs).abs() < 1e-12, "{}", scene.velocity(0));
    }
}

/// A wall that comes along pushes and throws as a wall does; it passes nothing at any speed.
#[test]
fn a_moving_wall_pushes_and_passes_nothing() {
    for speed in [1.0, 30.0, 300.0, 5000.0] {
        for e in [0.0, 0.5, 1.0] {
            let bodies = (0..4).map(|i| PileBody { restitution: e, ..square(2.0 + 1.7 * f64::from(i), -0.5) }).collect();
            let mut scene = pile(bodies, vec![surface(-1e7, 0.0, 1e7, 1.0), surface(0.0, -3.0, 0.05, 0.0)], G);
            let mut x = 0.025;
            for step in 0..240 {
                x += speed * DT;
                scene.move_surface(1, DVec2::new(x, -1.5));
                scene.step(DT);
                for i in 0..4 {
                    let left = scene.position(i).x - 0.5;
                    assert!(left >= x + 0.025 - 1e-9 * x.max(1.0), "{speed} m/s, e {e}, step {step}, body {i}: {left} behind {x}");
                    assert!(
                        i == 0 || left >= scene.position(i - 1).x + 0.5 - 1e-9 * x.max(1.0),
                        "{speed}, e {e}, step {step}, body {i}"
                    );
                }
            }
            if e == 0.0 {
                assert!((scene.velocity(0).x - speed).abs() < 1e-6 * speed, "{} {speed}", scene.velocity(0));
            }
        }
    }
}

/// A one-way platform lets pass what comes from below, and catches it when it falls.
#[test]
fn a_one_way_platform() {
    let ball = PileBody { velocity: DVec2::new(0.0, -12.0), ..square(0.0, -0.5) };
    let mut scene = pile(vec![ball], vec![surface(-5.0, 0.0, 5.0, 1.0), surface(-5.0, -3.0, 5.0, -2.9)], G);
    scene.set_sides(1, Sides::TOP);
    let mut top = 0.0f64;
    for _ in 0..480 {
        scene.step(DT);
        top = top.min(scene.position(0).y);
    }
    println!("law 7: rose to {top}, exact {}", -0.5 - 72.0 / G);
    assert!((top + 0.5 + 72.0 / G).abs() < 1e-3);
    assert_eq!((scene.position(0).y, scene.velocity(0)), (-3.5, DVec2::ZERO));
    scene.set_present(1, false);
    (0..240).for_each(|_| scene.step(DT));
    assert_eq!(scene.position(0).y, -0.5);
}

/// Between a press and the ground: reported, and the press stopped, without overlap.
#[test]
fn what_is_squeezed_stops_the_press() {
    for stack in [1, 3] {
        let bodies = (0..stack).map(|i| square(0.0, -0.5 - f64::from(i))).collect();
        let mut scene = pile(bodies, vec![surface(-5.0, 0.0, 5.0, 1.0), surface(-5.0, -10.0, 5.0, -9.0)], G);
        let mut y = -9.5;
        let mut squeezed = 0;
        for step in 0..240 {
            let to = y + 5.0 * DT;
            scene.move_surface(1, DVec2::new(0.0, to));
            scene.step(DT);
            if let Some(squeeze) = scene.squeezed().first() {
                squeezed += 1;
                assert!((squeeze.speed - 5.0).abs() < 1e-9 && squeeze.surface == 1, "{squeeze:?}");
            } else {
                y = to;
            }
            let top = scene.bounds(stack as usize - 1).min.y;
            assert!(y + 0.5 <= top + 1e-9, "step {step}: the press is at {} in {top}", y + 0.5);
            assert!(scene.bounds(0).max.y <= 1e-9);
        }
        assert!(squeezed > 20, "{squeezed}");
    }
}

/// A heap that a lift raises under an open sky, while more rains on it: nobody is squeezed, and the lift never waits.
#[test]
fn a_lift_under_the_open_sky_squeezes_nobody() {
    // Now and then something bounces off the rising heap just as the lift begins to slow down, and gets higher than it would have flown.
    for seed in 1..=12 {
        let mut random = Pcg64Mcg::seed_from_u64(seed);
        let bodies = (0..300).map(|i| PileBody {
            half: DVec2::new(random.random_range(0.15..0.3), random.random_range(0.15..0.3)),
            velocity: DVec2::new(random.random_range(-2.0..2.0), 0.0),
            mass: random.random_range(1.0..=1.0),
            restitution: 0.3 * random.random_range(0.0..1.0),
            static_friction: 0.65,
            kinetic_friction: 0.65,
            ..square(0.35 + 0.7 * f64::from(i % 18), -1.0 - 0.8 * f64::from(i / 18))
        });
        let bodies = bodies.collect();
        let wall = |x: f64| surface(x - 0.5, -2000.0, x + 0.5, 0.0);
        let surfaces = [wall(-0.5), wall(13.1), surface(0.001, 0.0, 12.599, 1.0)];
        let surfaces = surfaces.map(|surface| PileSurface { static_friction: 0.65, ..surface });
        let def = PileDef { bodies, surfaces: surfaces.into(), gravity: G, sleep: false, ..PileDef::default() };
        let mut scene = Pile::new(def).unwrap();
        for step in 1..=300 {
            // Up by 2 m in 2 s and down again, speeding up and slowing down by 2 m/s².
            let way = 2.0 * (f64::from(step) / 240.0).fract();
            let part = way.fract();
            let eased = if part < 0.5 { 2.0 * part * part } else { 1.0 - 2.0 * (1.0 - part) * (1.0 - part) };
            let high = 2.0 * if way >= 1.0 { 1.0 - eased } else { eased };
            scene.move_surface(2, DVec2::new(6.3, 0.5 - high));
            scene.step(1.0 / 60.0);
            assert!(scene.squeezed().is_empty(), "seed {seed}, step {step}: {:?}", scene.squeezed());
        }
    }
}

/// For every body m·Δv is what outer forces and contacts gave, to 1e-9; in rain, heaps and closed rows; nearly always where much bounces.
#[test]
fn what_contacts_gave_adds_up() {
    for (seed, restitution, walls) in [(1, 0.0, true), (2, 0.7, true), (3, 0.3, false), (4, 1.0, true)] {
        let mut random = Random(seed);
        let bodies: Vec<PileBody> = (0..80)
            .map(|i| PileBody {
                half: DVec2::new(0.2 + 0.25 * random.unit(), 0.2 + 0.25 * random.unit()),
                velocity: DVec2::new(6.0 * random.unit() - 3.0, 0.0),
                mass: 0.5 + 20.0 * random.unit(),
                restitution: restitution * random.unit(),
                ..square(f64::from(i % 8), -1.0 - f64::from(i / 8))
            })
            .collect();
        let mut surfaces = vec![surface(-20.0, 0.0, 30.0, 1.0)];
        if walls {
            surfaces.extend([surface(-1.5, -100.0, -0.5, 0.0), surface(7.5, -100.0, 8.5, 0.0)]);
        }
        let masses: Vec<f64> = bodies.iter().map(|b| b.mass).collect();
        let mut scene = pile(bodies, surfaces, G);
        let push = DVec2::new(200.0, 0.0);
        scene.set_force(3, push);
        let mut worst = (0.0f64, 0);
        let mut bad = 0;
        for step in 0..400 {
            let before: Vec<DVec2> = (0..80).map(|i| scene.velocity(i)).collect();
            scene.step(DT);
            let mut lack: Vec<DVec2> = (0..80)
                .map(|i| {
                    let outer = DVec2::new(0.0, G * masses[i]) + if i == 3 { push } else { DVec2::ZERO };
                    (scene.velocity(i) - before[i]) * masses[i] - outer * DT
                })
                .collect();
            let mut scale = vec![1e-3; 80];
            let impulses = scene.contact_impulses().to_vec();
            for c in &impulses {
                let given = match c.axis {
                    resultant::physics::pile::Axis::Across => DVec2::new(c.normal, c.friction),
                    resultant::physics::pile::Axis::Gravity => DVec2::new(c.friction, c.normal),
                };
                lack[c.a] -= given;
                scale[c.a] += given.length();
                if let Other::Body(b) = c.b {
                    lack[b] += given;
                    scale[b] += given.length();
                }
            }
            for i in 0..80 {
                let off = lack[i].length() / scale[i];
                bad += u32::from(off > 1e-9);
                if off > worst.0 {
                    worst = (off, step);
                }
            }
        }
        println!(
            "law 8: seed {seed}, e {restitution}: worst {:e} of what a body was given (step {}), {bad} of 32000 above 1e-9; {:?}",
            worst.0,
            worst.1,
            scene.guards()
        );
        // Who waits for the end of a step, or comes upon who does, is stopped and keeps its velocity; where energy is taken out, all are slowed.
        let guards = scene.guards();
        let allowed = 2 * guards.bounces_put_off + guards.put_back + 80 * guards.energy_taken_out;
        assert!(u64::from(bad) <= allowed, "seed {seed}: {bad} off, {allowed} told of, worst {worst:?}");
    }
}
