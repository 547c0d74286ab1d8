//! Islands: events in one change no bit of another, and each sleeps for itself.

use crate::support::dense::{dense, empty, rain_into, surface};
use crate::support::{Ask, Random};
use resultant::physics::{BodyDef, DVec2, Material, WorldDef};

const DT: f64 = 1.0 / 60.0;

/// Adds boxes that rain into a pit whose left edge is at `left`.
fn pit(def: &mut WorldDef, left: f64, n: usize, seed: u64, restitution: f64) {
    let columns = (n as f64).sqrt().ceil() as usize;
    let rain = rain_into(left, n, columns, (0.5, 20.5), Random(seed), restitution);
    def.bodies.extend(rain.bodies);
    def.surfaces.extend(rain.surfaces);
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
                    let same = (0..80).all(|i| one.state(i) == other.state(i));
                    assert!(same, "e {restitution}, {more} more, fallers {faller}: step {step}");
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
        (0..60).for_each(|i| assert_eq!(one.state(i), other.state(200 + i), "step {step}, body {i}"));
    }
}

#[test]
fn a_settled_pile_sleeps_beside_one_that_does_not() {
    let mut def = WorldDef { rest_speed: 0.0, ..empty() };
    pit(&mut def, 0.0, 60, 5, 0.0);
    def.surfaces.push(surface(400.0, 0.0, 410.0, 1.0));
    def.bodies.push(BodyDef { position: DVec2::new(405.0, -3.0), restitution: 1.0, ..BodyDef::default() });
    let mut pile = dense(def);
    pile.steps(600, DT);
    assert_eq!(pile.methods().asleep, 60);
    // A sleeping body wakes when something comes to touch it.
    pile.drive(10, 0.0, -500.0);
    pile.step(DT);
    assert!(pile.methods().asleep < 60);
}
