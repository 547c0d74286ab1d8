//! Surfaces that are solid from some sides only.

use super::*;

fn one_way(sides: Sides, path: Path) -> SurfaceDef {
    SurfaceDef { sides, bounds: area(-2.0, 0.0, 2.0, 0.3), ..mover(area(0.0, 0.0, 1.0, 1.0), path) }
}

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
        let thrown = BodyDef { velocity: v(0.0, -9.0), ..block(0.0, 2.0, 1.0) };
        let mut world = world(vec![one_way(Sides::TOP, Path::default())], vec![thrown]);
        run(&mut world, 3.0, rate, |_, _| ());
        within("one-way: lands, m", (position(&world, 0).y + 0.5).abs(), 1e-15);
        let stands = position(&world, 0);
        run(&mut world, 180.0, rate, |world, _| assert_eq!((position(world, 0), velocity(world, 0)), (stands, DVec2::ZERO)));
        assert_eq!(reaction(&world, 0, 0), G);
    }
}

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
                let mut world = in_space(vec![surface], vec![body]);
                run(&mut world, 4.0, 60.0, |_, _| ());
                let exact = if stops { -1.5 } else { 4.0 * speed - 3.0 };
                within("one-way from all sides: place, m", (position(&world, 0).dot(coming) - exact).abs(), EXACT);
            }
        }
    }
}

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

#[test]
fn a_one_way_lift_passes_what_it_meets_from_its_open_side() {
    for rate in RATES {
        // From 3 m above the floor into it, and back up.
        let path = Path::shuttle(v(0.0, 4.0), 2.0, 0.5, 0.1);
        let mut lift = one_way(Sides::TOP, path);
        lift.bounds = area(-2.0, -3.0, 2.0, -2.7);
        let mut world = world(vec![floor(), lift], vec![block(0.0, 0.0, 1.0)]);
        let (mut lowest, mut crushes) = (f64::NEG_INFINITY, 0);
        run(&mut world, 2.15, rate, |world, _| assert_eq!(position(world, 0), v(0.0, -0.5)));
        run(&mut world, 2.0, rate, |world, _| {
            lowest = lowest.max(position(world, 0).y);
            crushes += crushed(world).len();
        });
        assert_eq!(crushes, 0);
        assert!(lowest <= -0.5 + EXACT);
        let above = position(&world, 0).y - world.surfaces()[1].bounds.min.y;
        within("one-way: taken up from the floor, m", (above + 0.5).abs(), EXACT);
    }
}
