//! The same inputs by tick give the same bits. `tests/screens/frames.rs`: whatever the frames do.

use crate::support::hashes::{assert_golden, hash_of};
use crate::support::rooms::yard;
use crate::support::{Random, area, block, crowd};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg32;
use resultant::game::{Controls, Game, Inputs, Outcome, TICK_RATE};
use resultant::level::Level;
use resultant::physics::{BodyDef, BodyId, DVec2, Material, Path, Plan, Sides, SurfaceDef, World, WorldDef};
use std::sync::Arc;

/// Ten seconds.
const TICKS: u32 = 1200;

/// The player's keys in each tick: they change every few ticks, the same on every machine.
fn script() -> Vec<Controls> {
    let mut random = Pcg32::seed_from_u64(7);
    let mut controls = Controls::default();
    let mut change = |tick| {
        if tick % 7 == 0 {
            let mut key = |chance| random.random_bool(chance);
            controls = Controls { thrust: key(0.6), reverse: key(0.1), left: key(0.2), right: key(0.2) };
        }
        controls
    };
    (0..TICKS).map(&mut change).collect()
}

fn play() -> Game {
    let mut game = Game::new(Arc::new(yard())).unwrap();
    script().into_iter().for_each(|controls| game.step(controls));
    game
}

#[test]
fn the_golden_hash() {
    let game = play();
    assert_eq!(game.outcome(), Outcome::Running, "the script is meant to fly to its end");
    assert_golden("yard", game.hash());
}

/// A hall in which all kinds of surfaces move, or run belts: they lift, carry, push, press and let through crates.
fn hall() -> WorldDef {
    let mover = |bounds, path| SurfaceDef { path, ..SurfaceDef::fixed(bounds, Material::WOOD) };
    let shuttle = |x: f64, y: f64, travel: f64| Path::shuttle(DVec2::new(x, y), travel, 0.25 * travel, 0.3);
    let surfaces = vec![
        block(-1.0, 12.0, 41.0, 13.0),
        mover(area(2.0, 10.0, 6.0, 10.5), shuttle(0.0, -6.0, 2.0)),
        mover(area(8.0, 8.0, 12.0, 8.5), shuttle(5.0, 0.0, 1.5)),
        mover(area(20.0, 6.0, 22.0, 9.0), shuttle(0.0, 2.5, 1.0)),
        mover(area(30.0, 9.0, 30.5, 12.0), shuttle(6.0, 0.0, 1.2)),
        SurfaceDef { belt: 3.0, ..block(14.0, 11.0, 26.0, 11.5) },
        SurfaceDef { sides: Sides::TOP, ..block(26.0, 8.0, 38.0, 8.2) },
    ];
    let bodies = crowd(&mut Random(5), 40, 20);
    let bodies = bodies.into_iter().map(|body| BodyDef { position: body.position + DVec2::new(3.0, 0.0), ..body }).collect();
    let bounds = Some(area(-1.0, -9.0, 41.0, 13.0));
    WorldDef { rest_speed: 0.0, bounds, bodies, surfaces, ..WorldDef::default() }
}

#[test]
fn the_golden_hashes_of_moving_surfaces() {
    for (name, dense) in [("moving surfaces", false), ("moving surfaces, dense", true)] {
        let plan = Plan { dense, ..Plan::of(&hall()) };
        let mut world = World::with_plan(hall(), plan).unwrap();
        for tick in 0..TICKS {
            world.set_drive(BodyId(0), DVec2::new(if tick % 90 < 40 { 400.0 } else { -300.0 }, 0.0));
            world.set_running(3, tick % 200 < 150);
            world.set_present(6, tick % 300 < 250);
            // Asks the step for contacts, which the hash holds.
            world.forces(BodyId(0));
            world.step(1.0 / TICK_RATE);
        }
        assert!(dense == (world.methods().by_events == 0), "{:?}", world.methods());
        assert_golden(name, hash_of(&world));
    }
}

#[test]
fn recorded_inputs_give_the_same_bits_also_through_a_file() {
    let mut inputs = Inputs::default();
    script().into_iter().for_each(|controls| inputs.record(controls));
    let mut game = Game::new(Arc::new(yard())).unwrap();
    Inputs::parse("script", &inputs.to_string()).unwrap().into_iter().for_each(|controls| game.step(controls));
    assert_eq!(game.hash(), play().hash());
}

#[test]
fn one_bit_more_is_another_hash() {
    let hash = |level: Level| Game::new(Arc::new(level)).unwrap().hash();
    let mut nudged = yard();
    nudged.objects[1].velocity.x = 3.0_f64.next_up();
    assert_eq!(hash(yard()), hash(yard()));
    assert_ne!(hash(yard()), hash(nudged));
}
