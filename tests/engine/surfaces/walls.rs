//! Walls that push and hit, and how nothing gets through them at any speed.

use super::*;

/// Each contact carries the force that accelerates and drags all bodies ahead of it.
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
                    let mut world = in_space(vec![wall], vec![body]);
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

/// The engine looks further than it foresaw.
#[test]
fn a_fast_wall_throws_a_block_at_others() {
    for rate in RATES {
        for speed in [100.0, 1e4, 1e6] {
            let wall = mover(area(-2.0, -2.0, -1.0, 2.0), once(&[leg(1e3, v(speed, 0.0), v(0.0, 0.0))]));
            let far = 0.4 * speed / rate;
            let bodies =
                [0.0, far + 3.0, 1.5 * far + 6.0].map(|x| BodyDef { position: v(x, 0.0), restitution: 1.0, ..BodyDef::default() });
            let mut world = in_space(vec![wall], bodies.to_vec());
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
