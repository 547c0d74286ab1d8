//! The jumper's engine, against checks of each rule and against [`described`], a second implementation of the description.

use crate::support::strategies::cases;
use glam::DVec3;
use proptest::prelude::*;
use resultant::classics::jumper::engine::{Cuboid, CuboidFace, CuboidHit, Dynamic, Static, StaticKind, step};

fn described(bodies: &mut [Dynamic], statics: &[Static], g: f64, dt: f64) -> Vec<CuboidHit> {
    let mut hits = Vec::new();
    let meet = |a: &Cuboid, b: &Cuboid, axis: usize| a.location[axis].max(b.location[axis]) < a.end()[axis].min(b.end()[axis]);
    let overlap = |a: &Cuboid, b: &Cuboid| (0..3).all(|axis| meet(a, b, axis));
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

fn close(a: DVec3, b: DVec3) -> bool {
    (a - b).abs().max_element() < 1e-12
}

fn a_jump_passes_the_platform_and_lands_on_it(engine: Engine) -> bool {
    let mut bodies = [body(v(2.25, 2.25, 0.0), DVec3::splat(0.5), v(0.0, 0.0, 9.0), 1.0)];
    (0..300).for_each(|_| _ = engine(&mut bodies, &[cube(StaticKind::Platform)], 10.0, 0.01));
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

#[test]
fn both_implementations_pass_the_examples() {
    for engine in [&shipped as Engine, &described] {
        assert!(a_jump_passes_the_platform_and_lands_on_it(engine));
        assert!(a_wall_holds_for_ever(engine));
        assert!(the_first_elastic_example(engine));
        assert!(the_second_elastic_example(engine));
    }
}

/// Coordinates on a coarse grid, so that touching, which random numbers would never do, is frequent.
fn coarse(range: std::ops::Range<i32>) -> impl Strategy<Value = DVec3> {
    (range.clone(), range.clone(), range).prop_map(|(x, y, z)| DVec3::new(x.into(), y.into(), z.into()) * 0.25)
}

proptest! {
    #![proptest_config(cases(256))]

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
}
