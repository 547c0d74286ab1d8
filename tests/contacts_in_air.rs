//! Contacts while air acts: what broke where impacts, slides and drag meet within one tick.

use resultant::physics::{Aabb, BodyDef, BodyId, DVec2, ForceKind, Material, SurfaceDef, World, WorldDef};

fn floor(material: Material) -> SurfaceDef {
    SurfaceDef { bounds: Aabb::new(DVec2::new(-100.0, 0.0), DVec2::new(100.0, 1.0)), material }
}

fn named_forces(world: &World, body: BodyId) -> DVec2 {
    ForceKind::ALL.iter().map(|&kind| world.forces(body).total(kind)).sum()
}

/// A bounce turned a plank from falling to flying across, but until the end of the tick the air went on to meet its broad side: the drag
/// was several times too large, and the forces shown did not add up to the resultant.
#[test]
fn a_bounce_turns_the_side_that_meets_the_air() {
    let end = |ticks: u32| {
        let plank = BodyDef {
            position: DVec2::new(0.0, -1.2),
            velocity: DVec2::new(6.0, 8.0),
            half: DVec2::new(1.0, 0.2),
            mass: 2.0,
            drag: 1.15,
            restitution: 0.5,
            ..BodyDef::default()
        };
        let mut world = World::new(WorldDef {
            surfaces: vec![floor(Material::ICE)],
            bodies: vec![plank],
            rest_speed: 0.0,
            ..WorldDef::default()
        })
        .unwrap();
        for tick in 0..ticks {
            world.step(0.5 / f64::from(ticks));
            let (sum, resultant) = (named_forces(&world, BodyId(0)), world.forces(BodyId(0)).resultant());
            assert!((sum - resultant).length() <= 1e-12 * resultant.length(), "tick {tick} of {ticks}: {sum} N, not {resultant} N");
        }
        world.body(BodyId(0)).position
    };
    let fine = end(4000);
    for ticks in [15, 30, 60, 120] {
        assert!(end(ticks).distance(fine) < 1e-6, "{ticks} ticks: {} m off", end(ticks).distance(fine));
    }
}

/// Two blocks that moved as one but for the last bit of their speeds were taken to slide on each other. The slide ended after 1e-18 s, the
/// next plastic solve brought the last bit back, and one tick of a pile in air took a minute.
#[test]
fn speeds_that_differ_by_a_rounding_do_not_slide() {
    let speed = 0.193_602_083_850_716_34_f64;
    for above in [speed.next_down(), speed, speed.next_up()] {
        let block = |y: f64, speed: f64| BodyDef {
            position: DVec2::new(0.0, y),
            velocity: DVec2::new(speed, 0.0),
            half: DVec2::splat(0.5),
            mass: 5.0,
            ..BodyDef::default()
        };
        let bodies = vec![block(-0.5, speed), block(-1.5, above)];
        let world = World::new(WorldDef { air_density: 0.0, surfaces: vec![floor(Material::ICE)], bodies, ..WorldDef::default() });
        for body in world.unwrap().bodies() {
            assert!((body.acceleration.x + 0.03 * 15.0).abs() < 1e-12, "{} m/s², not −0.45", body.acceleration.x);
        }
    }
}
