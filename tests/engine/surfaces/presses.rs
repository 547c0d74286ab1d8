//! A squeezed body stops the press, and the event has the force.

use super::*;

/// The lift reports it on every tick.
#[test]
fn a_lift_waits_for_what_it_would_squeeze() {
    for rate in RATES {
        for (riders, ease) in [(1u32, 0.0), (1, 0.7), (5, 0.0), (5, 0.7)] {
            for e in [0.0, 0.6, 1.0] {
                let path = Path::shuttle(v(0.0, -6.0), 4.0, ease, 0.0);
                let ceiling = SurfaceDef::fixed(area(-5.0, -30.0, 5.0, -2.5 - f64::from(riders)), Material::ASPHALT);
                let rider = |i: u32| BodyDef { restitution: e, ..block(0.0, -f64::from(i), 2.0) };
                let bodies = (0..riders).map(rider).chain([block(100.0, 0.0, 2.0)]).collect();
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
                let case = format!("under a ceiling, {riders} riders, ease {ease}, e {e}, {rate} Hz: deepest overlap, m");
                assert!(first.is_some(), "never squeezed {case}");
                within(&case, deepest, EXACT);
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

/// The force that would crush the body by half of its side, at any rate: ½mv²/(h/2).
#[test]
fn the_force_of_a_press() {
    for rate in RATES {
        let press = mover(area(-1.0, -5.0, 1.0, -2.0), once(&[leg(1e3, v(0.0, 0.5), v(0.0, 0.0))]));
        let mut world = world(vec![floor(), press], (0..1).map(|i| block(0.0, -f64::from(i), 4.0)).collect());
        run(&mut world, 2.5, rate, |_, _| ());
        run(&mut world, 2.5, rate, |world, _| {
            let all = crushed(world);
            assert_eq!(all.len(), 1);
            assert!((all[0].2 - 0.5 * 4.0 * 0.25 / 0.5).abs() < 1e-9, "{all:?}");
            assert_eq!((all[0].0, all[0].1), (0, 1));
        });
    }
}

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
