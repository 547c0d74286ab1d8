//! A part that a plan leaves out is not called.

use crate::physics::data::def::{FieldDef, FluidDef, StreamDef, WorldDef};
use crate::physics::data::link::{LinkDef, LinkEnd, LinkLaw, Spring};
use crate::physics::data::plan::{CALLS, OPTIONAL, Part, Plan};
use crate::physics::data::{aabb::Aabb, body::BodyDef, body::BodyId, material::Material, surface::Path, surface::SurfaceDef};
use crate::physics::world::World;
use glam::DVec2;

/// Bodies that fall, float, bounce and are blown about in a room, `count` of them.
fn scene(count: u32) -> WorldDef {
    let zone = |x: f64, y: f64, w: f64, h: f64| Aabb::new(DVec2::new(x, y), DVec2::new(x + w, y + h));
    let spring = Spring { length: 1.0, stiffness: 200.0, damping: 0.0 };
    let body = |i: u32| BodyDef {
        position: DVec2::new(2.0 + 1.3 * f64::from(i % 9), 8.5 - 1.1 * f64::from(i / 9)),
        mass: 300.0 + 100.0 * f64::from(i % 7),
        restitution: 0.4,
        ..BodyDef::default()
    };
    WorldDef {
        bounds: Some(zone(0.0, -20.0, 16.0, 29.0)),
        surfaces: vec![SurfaceDef {
            path: Path::shuttle(DVec2::new(1.0, 0.0), 1.0, 0.5, 0.0),
            ..SurfaceDef::fixed(zone(3.0, -8.0, 4.0, 0.5), Material::STEEL)
        }],
        links: vec![LinkDef::new(BodyId(1), LinkEnd::Place(DVec2::new(3.0, 5.0)), LinkLaw::Spring(spring))],
        streams: vec![StreamDef { zone: zone(1.0, 3.0, 5.0, 3.0), force: DVec2::new(300.0, -200.0) }],
        fields: vec![FieldDef { zone: zone(9.0, 3.0, 5.0, 3.0), strength: DVec2::new(3.0, -2.0) }],
        fluids: vec![FluidDef { zone: zone(0.0, 7.0, 16.0, 2.0), density: 900.0, viscosity: 0.5 }],
        bodies: (0..count).map(body).collect(),
        ..WorldDef::default()
    }
}

/// The calls of each part in two seconds, with what is shown besides.
fn calls(plan: Plan, count: u32) -> [u64; 8] {
    CALLS.with(|calls| calls.iter().for_each(|calls| calls.set(0)));
    let mut world = World::with_plan(scene(count), plan).unwrap();
    for tick in 0..240 {
        world.set_drive(BodyId(0), DVec2::new(0.0, if tick < 100 { -900.0 } else { 0.0 }));
        world.step(1.0 / 120.0);
        (0..count).for_each(|i| drop(world.forces(BodyId(i))));
    }
    CALLS.with(|calls| std::array::from_fn(|part| calls[part].get()))
}

/// Few bodies, event by event, and many, in one step.
#[test]
fn a_part_that_is_left_out_is_never_called() {
    for count in [6, 90] {
        let whole = Plan::of(&scene(count));
        let all = calls(whole.clone(), count);
        assert!(all.iter().all(|calls| *calls > 0), "{count} bodies: {all:?}");
        let without: [(Part, Plan); 8] = [
            (Part::Air, Plan { air: false, ..whole.clone() }),
            (Part::Streams, Plan { streams: false, ..whole.clone() }),
            (Part::Liquids, Plan { liquids: false, ..whole.clone() }),
            (Part::Links, Plan { links: false, ..whole.clone() }),
            (Part::Moving, Plan { moving: false, ..whole.clone() }),
            (Part::Bounces, Plan { bounces: false, ..whole.clone() }),
            (Part::Direct, Plan { direct: false, ..whole.clone() }),
            (Part::Exact, Plan { dense: true, ..whole }),
        ];
        for (part, plan) in without {
            assert_eq!(calls(plan.clone(), count)[part as usize], 0, "{count} bodies: {plan:?}");
        }
    }
}

#[test]
fn each_flag_has_its_words() {
    let bare = Plan { dense: true, ..Plan::default() };
    let parts = |plan: &Plan| plan.parts().len();
    for (_, part) in OPTIONAL.iter().chain(&[("", (|plan| &mut plan.direct) as fn(&mut Plan) -> &mut bool)]) {
        let mut plan = bare.clone();
        *part(&mut plan) = true;
        assert_eq!(parts(&plan), parts(&bare) + 1, "{plan:?}");
    }
    assert!(!Plan { links: true, ..bare.clone() }.parts().contains(&"motion: exact parabolas"));
    assert!(bare.left_out().len() == OPTIONAL.len() && Plan::EVERYTHING.left_out().is_empty());
    assert_eq!(parts(&Plan { dense: false, ..bare.clone() }), parts(&bare));
}
