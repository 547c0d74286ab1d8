//! Doors, bodies that wait and wake beside surfaces, and refused paths.

use super::*;

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
        world.set_drive(BodyId(0), v(-30.0, 0.0));
        run(&mut world, 4.0, rate, |_, _| ());
        assert_eq!((position(&world, 0), velocity(&world, 0)), (v(0.75, -0.5), DVec2::ZERO));
        world.set_present(1, false);
        world.step(1.0 / rate);
        assert!(position(&world, 0).x < 0.75);
    }
}

#[test]
fn a_door_closes_beside_what_touches_its_place() {
    let door = SurfaceDef { present: false, ..mover(area(-0.3, -3.0, 0.1, 0.0), Path::default()) };
    let mut world = world(vec![floor(), door], vec![block(0.1 + 0.5, 0.0, 1.0), block(-0.3 - 0.5, 0.0, 1.0)]);
    world.set_present(1, true);
    world.step(1.0 / 60.0);
    assert!(world.surfaces()[1].present);
}

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

/// A rider goes with it at once, also in the middle of a tick.
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
        let off = |world: &World| (position(world, 1) - centre(world, 0) - v(0.0, -1.75)).length();
        run(&mut world, 40.0, rate, |world, _| drift = drift.max(off(world)));
        within("lift that was stopped: drift afterwards, m", drift, EXACT);
    }
}

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

#[test]
fn an_impact_names_the_surface() {
    let path = once(&[leg(0.01, DVec2::ZERO, DVec2::ZERO), leg(1.0, v(0.0, -2.0), DVec2::ZERO)]);
    let mut world = world(vec![floor(), platform(path)], vec![block(0.0, 0.0, 1.0)]);
    world.step(1.0 / 60.0);
    let hit = |event: &Event| matches!(event, Event::Impact { b: Obstacle::Surface(1), speed, .. } if (speed - 2.0).abs() < EXACT);
    assert!(world.events().iter().any(hit), "{:?}", world.events());
}
