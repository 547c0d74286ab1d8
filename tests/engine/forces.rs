//! The force manager: by itself, and as the part that moves a body.

use crate::support::{Ask, BODY, TICK as DT, area, block, crate_at};
use resultant::physics::{BodyDef, BodyId, DVec2, FluidDef, ForceKind, ForceManager, Source, World, WorldDef};

#[test]
fn a_force_is_replaced_by_one_of_its_source_and_kind() {
    let mut forces = ForceManager::default();
    assert!(forces.add(Source::Engine, ForceKind::Drive, DVec2::new(3.0, 0.0)));
    assert!(forces.add(Source::Stream(2), ForceKind::Wind, DVec2::new(0.0, 1.0)));
    assert!(forces.add(Source::Engine, ForceKind::Drive, DVec2::new(5.0, 0.0)));
    assert!(!forces.add(Source::Engine, ForceKind::Drive, DVec2::new(5.0, 0.0)), "nothing changes");
    assert_eq!(forces.get(Source::Engine, ForceKind::Drive), Some(DVec2::new(5.0, 0.0)));
    assert_eq!(forces.get(Source::Stream(1), ForceKind::Wind), None);
    assert_eq!(forces.resultant(), DVec2::new(5.0, 1.0));
}

#[test]
fn zero_and_nonsense_remove_a_force() {
    let mut forces = ForceManager::default();
    for nothing in [DVec2::ZERO, DVec2::new(f64::NAN, 1.0), DVec2::new(0.0, f64::INFINITY)] {
        forces.add(Source::Engine, ForceKind::Drive, DVec2::new(3.0, 0.0));
        assert!(forces.add(Source::Engine, ForceKind::Drive, nothing));
        assert_eq!((forces.forces().len(), forces.resultant()), (0, DVec2::ZERO));
    }
    assert!(!forces.remove(Source::Engine, ForceKind::Drive));
}

#[test]
fn kinds_are_summed_apart_and_resistances_left_out() {
    let mut forces = ForceManager::default();
    let pushes = [
        (Source::Gravity, ForceKind::Weight, (0.0, 1125.0)),
        (Source::Field(0), ForceKind::Weight, (0.0, 75.0)),
        (Source::Surface(1), ForceKind::Reaction, (0.0, -1200.0)),
        (Source::Surface(1), ForceKind::Friction, (-300.0, 0.0)),
        (Source::Air, ForceKind::AirResistance, (-20.0, 0.0)),
        (Source::Engine, ForceKind::Drive, (400.0, 0.0)),
    ];
    pushes.into_iter().for_each(|(source, kind, vector)| _ = forces.add(source, kind, vector.into()));
    assert_eq!(forces.total(ForceKind::Weight), DVec2::new(0.0, 1200.0));
    assert_eq!(forces.all(ForceKind::Weight).count(), 2);
    assert_eq!(forces.total(ForceKind::Buoyancy), DVec2::ZERO);
    assert_eq!(forces.resultant(), DVec2::new(80.0, 0.0));
    assert_eq!(forces.resultant_without_resistance(), DVec2::new(400.0, 0.0));
}

/// A world's list has an order of its own: the sorted search of `add` did not find the drag in it, and listed a second one.
#[test]
fn a_listed_force_is_replaced_as_well() {
    let pool = FluidDef { zone: area(-9.0, 0.0, 9.0, 9.0), density: 800.0, viscosity: 1.0 };
    let swims = BodyDef { velocity: DVec2::new(3.0, 0.0), ..BodyDef::default() };
    let mut world = World::new(WorldDef { bodies: vec![swims], fluids: vec![pool], ..WorldDef::default() }).unwrap();
    world.drive(0, 10.0, 0.0);
    world.step(1.0 / 60.0);
    let mut forces = world.forces(BodyId(0));
    for (source, kind) in forces.forces().iter().map(|force| (force.source, force.kind)).collect::<Vec<_>>() {
        let (count, vector) = (forces.forces().len(), DVec2::new(3.0, 4.0));
        assert!(forces.add(source, kind, vector) && !forces.add(source, kind, vector));
        assert_eq!((forces.forces().len(), forces.get(source, kind)), (count, Some(vector)));
    }
    assert_eq!(forces.forces().len(), 5);
}

/// 0.1 + 0.2 − 0.3 is not 0 in binary numbers.
#[test]
fn balanced_forces_have_no_resultant() {
    let mut forces = ForceManager::default();
    for (index, newtons) in (0..).zip([0.1, 0.2, -0.3]) {
        forces.add(Source::Stream(index), ForceKind::Wind, DVec2::new(newtons, 0.0));
    }
    assert_eq!(forces.resultant(), DVec2::ZERO);
}

#[test]
fn the_order_of_adding_changes_no_bit() {
    let pushes = [(0, 0.1), (1, 1e8), (2, -0.7), (3, 1e-9)];
    let sum = |order: [usize; 4]| {
        let mut forces = ForceManager::default();
        for (index, newtons) in order.map(|at| pushes[at]) {
            forces.add(Source::Stream(index), ForceKind::Wind, DVec2::new(newtons, 0.0));
        }
        forces.resultant().x.to_bits()
    };
    assert_eq!(sum([0, 1, 2, 3]), sum([3, 1, 0, 2]));
    assert_eq!(sum([0, 1, 2, 3]), sum([2, 3, 1, 0]));
}

#[test]
fn an_added_push_moves_the_body() {
    let (bodies, surfaces) = (vec![crate_at(0.0, -0.5, 10.0)], vec![block(-50.0, 0.0, 50.0, 1.0)]);
    let def = WorldDef { gravity: 10.0, air_density: 0.0, bodies, surfaces, ..WorldDef::default() };
    let mut world = World::new(def).unwrap();
    world.steps(240, DT);
    assert_eq!(world.forces(BODY).resultant(), DVec2::ZERO);
    let push = DVec2::new(120.0, 0.0);
    world.add_force(BODY, Source::Body(BodyId(7)), ForceKind::Push, push);
    world.steps(120, DT);
    let forces = world.forces(BODY);
    assert_eq!(forces.get(Source::Body(BodyId(7)), ForceKind::Push), Some(push));
    let a = (push + forces.total(ForceKind::Friction)).x / 10.0;
    assert!((world.speed(0).x - a).abs() < 1e-12, "{} m/s, not {a}", world.speed(0));
    assert!((forces.resultant().x - 10.0 * a).abs() < 1e-12);
    world.remove_force(BODY, Source::Body(BodyId(7)), ForceKind::Push);
    world.steps(1200, DT);
    assert_eq!((world.speed(0), world.forces(BODY).resultant()), (DVec2::ZERO, DVec2::ZERO));
}
