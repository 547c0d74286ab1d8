//! The jumper's engine, against checks of each rule and against [`described`], a second implementation of the description.

use glam::{BVec3, DVec3};
use proptest::prelude::*;
use proptest::test_runner::FileFailurePersistence;
use resultant::classics::jumper::engine::{Cuboid, CuboidFace, CuboidHit, Dynamic, Static, StaticKind, step};

fn described(bodies: &mut [Dynamic], statics: &[Static], g: f64, dt: f64) -> Vec<CuboidHit> {
    let mut hits = Vec::new();
    let overlap =
        |a: &Cuboid, b: &Cuboid| (0..3).all(|axis| a.location[axis].max(b.location[axis]) < a.end()[axis].min(b.end()[axis]));
    for (object, body) in bodies.iter_mut().enumerate() {
        body.velocity.z -= g * dt;
        body.previous = body.cuboid.location;
        body.cuboid.location += body.velocity * dt;
        body.on_ground = body.cuboid.location.z <= 0.0;
        if body.on_ground {
            (body.cuboid.location.z, body.velocity.z) = (0.0, 0.0);
        }
        for (obstacle, other) in statics.iter().enumerate() {
            if overlap(&body.cuboid, &other.cuboid) {
                let face = described_face(Cuboid { location: body.previous, ..body.cuboid }, other.cuboid);
                described_answer(body, other, face);
                hits.push(CuboidHit::Static { object, obstacle, face });
            }
        }
    }
    for second in 1..bodies.len() {
        for first in 0..second {
            let (a, b) = (bodies[first], bodies[second]);
            if !overlap(&a.cuboid, &b.cuboid) {
                continue;
            }
            let n = a.cuboid.centre() - b.cuboid.centre();
            let along = (a.velocity - b.velocity).dot(n);
            if n != DVec3::ZERO {
                bodies[first].velocity -= 2.0 * b.mass / (a.mass + b.mass) * along * n / n.dot(n);
                bodies[second].velocity += 2.0 * a.mass / (a.mass + b.mass) * along * n / n.dot(n);
            }
            hits.push(CuboidHit::Pair(first, second));
        }
    }
    hits
}

fn described_face(before: Cuboid, other: Cuboid) -> CuboidFace {
    let order = [
        (2, CuboidFace::Bottom, CuboidFace::Top),
        (0, CuboidFace::MinX, CuboidFace::MaxX),
        (1, CuboidFace::MinY, CuboidFace::MaxY),
    ];
    let face = order.into_iter().find_map(|(axis, low, high)| {
        if other.location[axis] >= before.end()[axis] {
            Some(low)
        } else {
            (before.location[axis] >= other.end()[axis]).then_some(high)
        }
    });
    face.unwrap_or(CuboidFace::Internal)
}

fn described_answer(body: &mut Dynamic, other: &Static, face: CuboidFace) {
    let (location, end) = (&mut body.cuboid.location, other.cuboid.end());
    match (other.kind, face) {
        (StaticKind::Platform, CuboidFace::Top) => (location.z, body.velocity.z, body.on_ground) = (end.z, 0.0, true),
        (StaticKind::Wall, CuboidFace::MinX | CuboidFace::MaxX) => {
            let against = other.cuboid.location.x - body.cuboid.dimensions.x;
            let rounded_into = against + body.cuboid.dimensions.x > other.cuboid.location.x;
            let against = if rounded_into { against.next_down() } else { against };
            body.velocity.x = 0.0;
            location.x = if face == CuboidFace::MinX { against } else { end.x };
        }
        _ => {}
    }
}

type Engine<'a> = &'a dyn Fn(&mut [Dynamic], &[Static], f64, f64) -> Vec<CuboidHit>;

fn shipped(bodies: &mut [Dynamic], statics: &[Static], g: f64, dt: f64) -> Vec<CuboidHit> {
    let mut hits = vec![CuboidHit::Pair(7, 8)]; // A leftover, which a step has to clear.
    step(bodies, statics, g, dt, &mut hits);
    hits
}

fn v(x: f64, y: f64, z: f64) -> DVec3 {
    DVec3::new(x, y, z)
}

fn body(location: DVec3, dimensions: DVec3, velocity: DVec3, mass: f64) -> Dynamic {
    Dynamic::new(Cuboid { location, dimensions }, velocity, mass)
}

fn cube(kind: StaticKind) -> Static {
    Static { cuboid: Cuboid { location: DVec3::splat(2.0), dimensions: DVec3::ONE }, kind }
}

fn small(location: DVec3, velocity: DVec3) -> Dynamic {
    body(location, DVec3::splat(0.5), velocity, 1.0)
}

/// One step without gravity of 0.1 s, against a cube of each kind: the hits, and the two bodies after it.
fn against_cubes(engine: Engine, before: Dynamic) -> [(Vec<CuboidHit>, Dynamic); 2] {
    [StaticKind::Platform, StaticKind::Wall].map(|kind| {
        let mut bodies = [before];
        let hits = engine(&mut bodies, &[cube(kind)], 0.0, 0.1);
        (hits, bodies[0])
    })
}

fn hit(face: CuboidFace) -> Vec<CuboidHit> {
    vec![CuboidHit::Static { object: 0, obstacle: 0, face }]
}

fn close(a: DVec3, b: DVec3) -> bool {
    (a - b).abs().max_element() < 1e-12
}

/// A check a face: from 0.05 m in front of it, and from touching it, 0.1 m on. Only a platform's top and a wall's two sides act.
fn from_the_side(engine: Engine, face: CuboidFace, axis: usize, direction: f64) -> bool {
    let touching = if direction > 0.0 { 1.5 } else { 3.0 };
    [0.05, 0.0].into_iter().all(|gap| {
        let (mut location, mut velocity) = (DVec3::splat(2.25), DVec3::splat(0.125));
        location[axis] = touching - direction * gap;
        velocity[axis] = direction;
        let [(platform_hits, on_platform), (wall_hits, at_wall)] = against_cubes(engine, small(location, velocity));
        let passes = |after: &Dynamic| {
            after.velocity == velocity && close(after.cuboid.location, location + 0.1 * velocity) && !after.on_ground
        };
        let stops = |after: &Dynamic| {
            let mut left = velocity;
            left[axis] = 0.0;
            after.velocity == left && after.cuboid.location[axis] == touching && after.on_ground == (face == CuboidFace::Top)
        };
        platform_hits == hit(face)
            && wall_hits == hit(face)
            && (if face == CuboidFace::Top { stops(&on_platform) } else { passes(&on_platform) })
            && (if matches!(face, CuboidFace::MinX | CuboidFace::MaxX) { stops(&at_wall) } else { passes(&at_wall) })
    })
}

fn a_jump_passes_the_platform_and_lands_on_it(engine: Engine) -> bool {
    let mut bodies = [small(v(2.25, 2.25, 0.0), v(0.0, 0.0, 9.0))];
    for _ in 0..300 {
        engine(&mut bodies, &[cube(StaticKind::Platform)], 10.0, 0.01);
    }
    bodies[0].cuboid.location == v(2.25, 2.25, 3.0) && bodies[0].on_ground && bodies[0].velocity == DVec3::ZERO
}

fn a_wall_holds_for_ever(engine: Engine) -> bool {
    let wall = Static { cuboid: Cuboid { location: v(15.1, -1.0, 0.0), dimensions: v(0.1, 3.0, 9.0) }, kind: StaticKind::Wall };
    [0.3, 0.1, 1.0 / 3.0, 14.9].into_iter().all(|width| {
        let mut bodies = [body(v(0.0, 0.0, 1.0), v(width, 1.0, 1.0), DVec3::ZERO, 1.0)];
        (0..600).all(|_| {
            bodies[0].velocity.x = 4.0;
            engine(&mut bodies, &[wall], 0.0, 1.0 / 120.0);
            bodies[0].cuboid.end().x <= 15.1
        })
    })
}

fn the_first_elastic_example(engine: Engine) -> bool {
    let cube = DVec3::ONE;
    let mut bodies = [body(v(-0.1, -1.0, 0.0), cube, v(2.0, 1.5, 0.0), 2.0), body(v(0.1, -1.0, 0.0), cube, v(-2.0, 1.0, 0.0), 4.0)];
    let hits = engine(&mut bodies, &[], 0.0, 0.1);
    hits == [CuboidHit::Pair(0, 1)]
        && close(bodies[0].velocity, v(-3.176470588235294, 0.20588235294117496, 0.0))
        && close(bodies[1].velocity, v(0.5882352941176473, 1.6470588235294126, 0.0))
}

fn the_second_elastic_example(engine: Engine) -> bool {
    let mut bodies =
        [body(v(-5.0, 1.0, 0.0), v(4.0, 1.0, 2.0), v(1.5, 0.0, 0.0), 10.0), body(DVec3::ZERO, v(1.0, 2.0, 5.0), DVec3::ZERO, 20.0)];
    let hits = engine(&mut bodies, &[], 0.0, 1.0);
    hits == [CuboidHit::Pair(0, 1)]
        && close(bodies[0].velocity, v(0.26923076923076905, 0.3076923076923077, -0.9230769230769232))
        && close(bodies[1].velocity, v(0.6153846153846154, -0.15384615384615385, 0.4615384615384616))
}

type Check = fn(Engine) -> bool;

const CHECKS: [(&str, Check); 10] = [
    ("bottom", |engine| from_the_side(engine, CuboidFace::Bottom, 2, 1.0)),
    ("top", |engine| from_the_side(engine, CuboidFace::Top, 2, -1.0)),
    ("min x", |engine| from_the_side(engine, CuboidFace::MinX, 0, 1.0)),
    ("max x", |engine| from_the_side(engine, CuboidFace::MaxX, 0, -1.0)),
    ("min y", |engine| from_the_side(engine, CuboidFace::MinY, 1, 1.0)),
    ("max y", |engine| from_the_side(engine, CuboidFace::MaxY, 1, -1.0)),
    ("a jump passes the platform and lands on it", a_jump_passes_the_platform_and_lands_on_it),
    ("a wall holds for ever", a_wall_holds_for_ever),
    ("the first elastic example", the_first_elastic_example),
    ("the second elastic example", the_second_elastic_example),
];

fn failed(engine: Engine) -> Vec<&'static str> {
    CHECKS.iter().filter(|(_, check)| !check(engine)).map(|&(name, _)| name).collect()
}

#[test]
fn the_engine_passes_every_check() {
    assert_eq!(failed(&shipped), [""; 0]);
    assert_eq!(failed(&described), [""; 0]);
}

/// Coordinates on a coarse grid, so that touching, which random numbers would never do, is frequent.
fn coarse(range: std::ops::Range<i32>) -> impl Strategy<Value = DVec3> {
    (range.clone(), range.clone(), range).prop_map(|(x, y, z)| DVec3::new(x.into(), y.into(), z.into()) * 0.25)
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: Some(Box::new(FileFailurePersistence::WithSource("proptest-regressions"))), ..ProptestConfig::default() })]

    #[test]
    fn the_engine_is_the_described_one(
        bodies in prop::collection::vec((coarse(-4..8), coarse(1..5), coarse(-8..8), 1..4_i32), 0..4),
        statics in prop::collection::vec((coarse(-4..8), coarse(1..8), any::<bool>()), 0..5),
        g in 0..3_i32,
    ) {
        let statics: Vec<Static> = statics.into_iter().map(|(location, dimensions, wall)| Static {
            cuboid: Cuboid { location, dimensions },
            kind: if wall { StaticKind::Wall } else { StaticKind::Platform },
        }).collect();
        let mut ours: Vec<Dynamic> = bodies.into_iter().map(|(at, size, velocity, mass)| body(at, size, velocity, f64::from(mass))).collect();
        let mut theirs = ours.clone();
        for _ in 0..8 {
            let hits = shipped(&mut ours, &statics, g.into(), 0.125);
            prop_assert_eq!(&hits, &described(&mut theirs, &statics, g.into(), 0.125));
            for (ours, theirs) in ours.iter().zip(&mut theirs) {
                prop_assert!(close(ours.velocity, theirs.velocity) && ours.on_ground == theirs.on_ground);
                prop_assert!(close(ours.cuboid.location, theirs.cuboid.location) && ours.velocity.is_finite());
                *theirs = *ours; // Rounding differs; it shall not add up to another hit.
            }
        }
    }

    #[test]
    fn overlapping_is_mutual_and_strict(a in coarse(0..6), b in coarse(0..6), size in coarse(1..4)) {
        let (a, b) = (Cuboid { location: a, dimensions: size }, Cuboid { location: b, dimensions: size });
        let apart = (a.location - b.location).abs();
        prop_assert_eq!(a.overlaps(&b), apart.cmplt(size) == BVec3::TRUE);
        prop_assert_eq!(a.overlaps(&b), b.overlaps(&a));
    }
}
