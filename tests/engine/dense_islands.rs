//! Islands: events in one change no bit of another, and each sleeps for itself.

use crate::support::Random;
use crate::support::dense::{dense, empty, surface};
use resultant::physics::{BodyDef, BodyId, DVec2, Material, World, WorldDef};

const DT: f64 = 1.0 / 60.0;

/// Boxes raining into a pit whose left edge is at `left`.
fn pit(def: &mut WorldDef, left: f64, n: usize, seed: u64, restitution: f64) {
    let mut random = Random(seed);
    let columns = (n as f64).sqrt().ceil() as usize;
    let width = columns as f64 * 0.7;
    for i in 0..n {
        def.bodies.push(BodyDef {
            half: DVec2::new(0.15 + 0.15 * random.unit(), 0.15 + 0.15 * random.unit()),
            position: DVec2::new(left + 0.35 + 0.7 * (i % columns) as f64, -1.0 - 0.8 * (i / columns) as f64),
            velocity: DVec2::new(4.0 * random.unit() - 2.0, 0.0),
            mass: 0.5 + 20.0 * random.unit(),
            restitution: restitution * random.unit(),
            ..BodyDef::default()
        });
    }
    def.surfaces.push(surface(left - 5.0, 0.0, left + width + 5.0, 1.0));
    def.surfaces.push(surface(left - 1.0, -900.0, left, 0.0));
    def.surfaces.push(surface(left + width, -900.0, left + width + 1.0, 0.0));
}

fn bits(pile: &World, n: usize) -> Vec<[u64; 4]> {
    (0..n)
        .map(|i| {
            let (x, v) = (pile.bodies()[i].position, pile.bodies()[i].velocity);
            [x.x, x.y, v.x, v.y].map(f64::to_bits)
        })
        .collect()
}

#[test]
fn what_is_added_far_away_changes_no_bit() {
    for restitution in [0.0, 0.8, 1.0] {
        let mut alone = WorldDef { air_density: 1.2, ..empty() };
        pit(&mut alone, 0.0, 80, 5, restitution);
        for more in [1, 10, 1000] {
            for faller in [false, true] {
                let mut both = alone.clone();
                if faller {
                    both.bodies.extend((0..more).map(|i| BodyDef {
                        position: DVec2::new(500.0 + 2.0 * f64::from(i), -80.0),
                        velocity: DVec2::new(0.0, -30.0),
                        material: Material::STEEL,
                        ..BodyDef::default()
                    }));
                } else {
                    pit(&mut both, 900.0, more as usize, 11, 0.7);
                }
                let (mut one, mut other) = (dense(alone.clone()), dense(both));
                for step in 0..240 {
                    one.step(DT);
                    other.step(DT);
                    assert!(bits(&one, 80) == bits(&other, 80), "e {restitution}, {more} more, fallers {faller}: step {step}");
                }
            }
        }
    }
}

#[test]
fn what_is_added_before_changes_no_bit() {
    let mut alone = empty();
    pit(&mut alone, 0.0, 60, 5, 0.6);
    let mut both = empty();
    pit(&mut both, -700.0, 200, 3, 0.6);
    both.bodies.extend(alone.bodies.clone());
    both.surfaces.extend(alone.surfaces.clone());
    let (mut one, mut other) = (dense(alone), dense(both));
    for step in 0..240 {
        one.step(DT);
        other.step(DT);
        for i in 0..60 {
            assert_eq!(
                (one.bodies()[i].position, one.bodies()[i].velocity),
                (other.bodies()[200 + i].position, other.bodies()[200 + i].velocity),
                "step {step}, body {i}"
            );
        }
    }
}

#[test]
fn a_settled_pile_sleeps_beside_one_that_does_not() {
    let mut def = WorldDef { rest_speed: 0.0, ..empty() };
    pit(&mut def, 0.0, 60, 5, 0.0);
    def.surfaces.push(surface(400.0, 0.0, 410.0, 1.0));
    def.bodies.push(BodyDef { position: DVec2::new(405.0, -3.0), restitution: 1.0, ..BodyDef::default() });
    let mut pile = dense(def);
    (0..600).for_each(|_| pile.step(DT));
    assert_eq!(pile.methods().asleep, 60);
    // A sleeping body wakes when something comes to touch it.
    pile.set_drive(BodyId(10), DVec2::new(0.0, -500.0));
    pile.step(DT);
    assert!(pile.methods().asleep < 60);
}
