//! Levels with other numbers: a number is accepted exactly if the loader accepts it, and the written level is the one that was flown.

use crate::package;
use proptest::prelude::*;
use proptest::sample::Index;
use resultant::files::EXPERIMENTS;
use resultant::game::{Controls, Game, History, SHIP};
use resultant::instruments::vary::{SliderTrack, Variation};
use resultant::level::document::{LevelFolder, Opened};
use resultant::level::{self, Level, Parameter};
use resultant::physics::BodyId;
use std::path::PathBuf;
use std::sync::{Arc, LazyLock};

static FOLDERS: LazyLock<Vec<PathBuf>> = LazyLock::new(|| {
    let all = ["levels", EXPERIMENTS].map(|of| package().join(of));
    let folders: Vec<PathBuf> = all.iter().flat_map(|of| level::list(of).into_iter().map(|name| of.join(name))).collect();
    assert!(folders.len() > 12, "{folders:?}");
    folders
});

fn load(folder: &str) -> Level {
    level::load(&package().join(folder), package()).expect("it loads").level
}

fn fly(game: &mut Game, history: &mut History, ticks: u64) {
    for tick in 0..ticks {
        let controls = Controls { thrust: tick % 3 == 0, right: tick % 7 == 0, ..Controls::default() };
        game.step(controls);
        history.note(game, controls);
    }
}

/// Which number of a level, where on its slider, and how far beyond the accepted range.
fn change() -> impl Strategy<Value = (Index, Index, f64, Option<f64>)> {
    (any::<Index>(), any::<Index>(), 0.0_f64..=1.0, proptest::option::weighted(0.2, -1.5_f64..=1.5))
}

fn vary(level: &Level, changes: &[(Index, Index, f64, Option<f64>)]) -> Variation {
    let mut variation = Variation::default();
    for (body, which, part, beyond) in changes {
        let all = Parameter::all(level, body.index(level.objects.len() + 1));
        let parameter = all[which.index(all.len())];
        let usual = parameter.of(level).expect("it is of this level");
        let value = match beyond {
            Some(times) => times * parameter.limits().1,
            None => SliderTrack::of(parameter, usual).value(*part),
        };
        variation.set(parameter, value, level);
    }
    variation
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 192, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn what_is_accepted_is_what_the_loader_reads_back(at in any::<Index>(), changes in proptest::collection::vec(change(), 1..6)) {
        let folder = at.get(&FOLDERS);
        let level = level::load(folder, package()).expect("it ships").level;
        let variation = vary(&level, &changes);
        let Opened { mut document, folder: opened, .. } = LevelFolder::open(folder, package()).expect("it can be opened");
        match variation.apply(&level) {
            Ok(varied) => {
                document.vary(&varied, &variation.parameters(), None).expect("it has these rows");
                let read = opened.check(&document).map_err(|problems| TestCaseError::fail(problems[0].to_string()))?;
                prop_assert_eq!(&read.level, &varied);
                let mut game = Game::new(Arc::new(varied)).expect("the engine takes what the loader takes");
                for _ in 0..60 {
                    game.step(Controls { thrust: true, ..Controls::default() });
                }
                prop_assert!(game.world().bodies().iter().all(|body| body.position.is_finite() && body.velocity.is_finite()));
            }
            Err(problems) => {
                // Written nevertheless, it is refused for as many reasons.
                let told: Vec<String> = problems.iter().map(ToString::to_string).collect();
                prop_assert!(!told.is_empty() && told.iter().all(|line| line.contains("expected ")), "{:?}", told);
                let written = variation.changes().filter(|(parameter, _)| *parameter != Parameter::Wind).collect::<Vec<_>>();
                for (parameter, value) in written {
                    prop_assert_eq!(parameter.parse(&value.to_string()).is_ok(), {
                        let (least, most) = parameter.limits();
                        (least..=most).contains(&value)
                    });
                }
            }
        }
    }
}

#[test]
fn forces_that_are_too_strong_for_a_mass_are_refused_together() {
    let refused_in = |level: &Level, changes: &[(Parameter, f64)]| {
        let mut variation = Variation::default();
        changes.iter().for_each(|(parameter, value)| variation.set(*parameter, *value, level));
        variation.apply(level).err().map(|problems| problems[0].to_string())
    };
    let with_ship = load("tests/fixtures/levels/2");
    assert_eq!(refused_in(&with_ship, &[(Parameter::Thrust, 1e6)]), None);
    let told = refused_in(&with_ship, &[(Parameter::Thrust, 1e6), (Parameter::Mass(0), 1.0)]).unwrap();
    assert_eq!(told, "player.csv: found 1000000 N on a ship of 1 kg, expected at most 10000 N, which is 10000 m/s²");
    let level = load("levels/experiments/friction");
    let refused = |changes: &[(Parameter, f64)]| refused_in(&level, changes);
    assert!(refused(&[(Parameter::Thrust, 5.0)]).is_some() && refused(&[(Parameter::Mass(0), 5.0)]).is_some(), "it has no ship");
    let told = refused(&[(Parameter::Wind, 1000.0), (Parameter::Mass(2), 1e-3)]).unwrap();
    assert_eq!(told, "hazards.csv: found 60000 N on 0.001 kg, expected at most 10 N, which is 10000 m/s²");
    let told = refused(&[(Parameter::Mass(9), 1.0)]).unwrap();
    assert_eq!(told, "objects.csv: found no object 9, expected an object of the level");
    for value in [f64::NAN, f64::INFINITY, -1.0, 1e7] {
        assert!(refused(&[(Parameter::Mass(1), value)]).is_some(), "{value}");
    }
}

#[test]
fn a_tape_flown_in_another_level_is_the_same_controls_under_other_laws() {
    let level = Arc::new(load("levels/experiments/free-fall"));
    let mut game = Game::new(level.clone()).unwrap();
    let mut history = History::new(&game);
    fly(&mut game, &mut history, 120);
    let mut same = history.tape().fly_in(level.clone(), 120).unwrap();
    assert!(!same.fly(50) && (same.progress() - 50.0 / 120.0).abs() < 1e-12 && same.fly(1000));
    assert_eq!(same.done().0.hash(), game.hash());
    let mut variation = Variation::default();
    variation.set(Parameter::Gravity, 1.62, &level);
    let moon = Arc::new(variation.apply(&level).unwrap());
    let mut again = history.tape().fly_in(moon, 120).unwrap();
    assert!(again.fly(1000));
    let (flown, again) = again.done();
    for (i, object) in level.objects.iter().enumerate() {
        let fallen = flown.world().bodies()[i + 1].position.y - object.position.y;
        assert!((fallen - 0.5 * 1.62).abs() < 1e-12, "½·g·t² after a second: {fallen}");
    }
    assert_eq!((again.inputs(), again.ticks()), (history.inputs(), 120));
}

#[test]
fn a_flight_that_goes_on_in_a_varied_level_has_a_history_over_the_change() {
    for name in
        ["tests/fixtures/levels/15", "tests/fixtures/levels/2", "levels/experiments/bounce", "levels/experiments/pushed-row"]
    {
        let level = load(name);
        let mut game = Game::new(Arc::new(level.clone())).unwrap();
        let mut history = History::new(&game);
        let mut hashes = vec![game.hash()];
        let mut leg = |game: &mut Game, history: &mut History, ticks: u64| {
            for _ in 0..ticks {
                fly(game, history, 1);
                hashes.push(game.hash());
            }
        };
        leg(&mut game, &mut history, 130);
        let varied = if level.ship_plays() { SHIP } else { BodyId(1) };
        for (gravity, mass) in [(5.0, 50.0), (2.5, 70.0)] {
            let (place, motion) = (game.world().body(varied).position, game.world().body(varied).velocity);
            let mut variation = Variation::default();
            variation.set(Parameter::Gravity, gravity, &level);
            variation.set(Parameter::Mass(varied.index()), mass, &level);
            history.go_on_in(&mut game, Arc::new(variation.apply(&level).unwrap())).unwrap();
            assert_eq!((game.world().body(varied).position, game.world().body(varied).velocity), (place, motion), "{name}");
            assert_eq!((game.world().body(varied).mass, game.level().gravity), (mass, gravity));
            leg(&mut game, &mut history, 77);
        }
        for tick in [0, 60, 129, 131, 200, 208, 284, 150, 90] {
            assert_eq!(history.at(tick).hash(), hashes[tick as usize], "{name} after {tick} ticks");
        }
        let until = history.until(220);
        assert_eq!((until.ticks(), until.at(220).hash()), (220, hashes[220]), "{name}");
        // A level that differs in more than its numbers is none to go on in.
        let other = Arc::new(load("tests/fixtures/levels/1"));
        let before = game.hash();
        assert!(history.go_on_in(&mut game, other).is_err() && game.hash() == before, "{name}");
    }
}

#[test]
fn to_go_on_by_other_numbers_from_the_start_is_to_begin_with_them() {
    for folder in FOLDERS.iter() {
        let level = level::load(folder, package()).expect("it ships").level;
        let mut variation = Variation::default();
        let body = usize::from(!level.ship_plays());
        for parameter in [Parameter::Gravity, Parameter::Air, Parameter::Friction, Parameter::Mass(body), Parameter::Drag(body)] {
            let usual = parameter.of(&level).unwrap();
            variation.set(parameter, SliderTrack::of(parameter, usual).value(0.7), &level);
        }
        let varied = Arc::new(variation.apply(&level).expect("from sliders"));
        let mut told = Game::new(Arc::new(level)).unwrap();
        told.go_on_in(varied.clone()).unwrap();
        let mut begun = Game::new(varied).unwrap();
        for tick in 0..240 {
            let controls = Controls { thrust: tick > 60, left: tick % 5 == 0, ..Controls::default() };
            told.step(controls);
            begun.step(controls);
            let state = |game: &Game| {
                let bodies = game.world().bodies().iter();
                bodies.map(|body| (body.position, body.velocity, body.acceleration)).collect::<Vec<_>>()
            };
            assert_eq!(state(&told), state(&begun), "{} after {tick} ticks", folder.display());
        }
    }
}
