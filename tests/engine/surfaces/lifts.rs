//! Lifts: a column rides them, and they let go, catch and bounce as they must.

use super::*;

/// The lift carries m(g + a).
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

#[test]
fn a_lift_that_starts_and_stops_at_once() {
    let speed = 3.0;
    for rate in RATES {
        let path = once(&[leg(0.51, v(0.0, 0.0), v(0.0, 0.0)), leg(1.0, v(0.0, -speed), v(0.0, 0.0))]);
        let mut world = world(vec![platform(path)], vec![block(0.0, 0.0, 2.0)]);
        let (mut hits, mut highest, mut landed) = (vec![], 0.0f64, 0.0);
        run(&mut world, 3.0, rate, |world, t| {
            for impulse in world.impulses().iter().filter(|hit| hit.impact && hit.vector.length() > 1e-9) {
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

/// The lift comes level with the floor slower than the speed that counts as resting. The rounding that keeps resting bodies in place once
/// held a body to the floor, and crushed it.
#[test]
fn a_lift_that_creeps_past_a_floor_lifts_what_stands_on_both() {
    for speed in [1e-9, 1e-7, 1e-6] {
        for ahead in [0.0, 0.004 * speed] {
            let floor = SurfaceDef::fixed(area(-9.0, 0.0, 0.0, 1.0), Material::ASPHALT);
            let lift = mover(area(0.0, ahead, 9.0, ahead + 0.5), once(&[leg(1.0, v(0.0, -speed), v(0.0, 0.0))]));
            let mut world = world(vec![floor, lift], vec![block(0.1, 0.0, 100.0)]);
            run(&mut world, 0.5, 120.0, |world, t| {
                assert_eq!(crushed(world), [], "{speed} m/s, {ahead} m ahead, after {t} s");
                let off = (position(world, 0).y + 0.5 + (speed * t - ahead).max(0.0)).abs();
                assert!(off <= 2e-9, "{speed} m/s, {ahead} m ahead: {off} m off after {t} s");
            });
            assert_eq!(world.guards().surfaces_stopped, 0);
        }
    }
}
