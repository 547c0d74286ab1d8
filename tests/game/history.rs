//! Flights that can be gone back in: the game at any tick is the one that was flown, to the bit.

use crate::support::Random;
use crate::support::shipped::{fixture as level, flown, record};
use resultant::game::{Controls, Game, GhostTrack, Inputs, Outcome, Reel, SHIP, TICK_RATE};
use resultant::level::Level;
use std::sync::Arc;

/// The hash after every tick of inputs, from the start on.
fn hashes(level: &Arc<Level>, inputs: &Inputs) -> Vec<u64> {
    let mut game = Game::new(level.clone()).unwrap();
    let mut hashes = vec![game.hash()];
    for controls in inputs.clone() {
        game.step(controls);
        hashes.push(game.hash());
    }
    hashes
}

#[test]
fn any_tick_of_a_recorded_flight_is_the_one_that_was_flown() {
    let mut random = Random(11);
    for name in ["3", "15"] {
        let (level, replay) = (level(name), record(name, "careful"));
        let flown = hashes(&level, &replay.inputs);
        let Reel { mut history, unflown } = Reel::new(level, &replay.inputs, TICK_RATE).unwrap();
        assert!(!unflown.unwrap().fly(&mut history, u64::MAX), "all of it is known");
        let last = history.ticks();
        assert_eq!(flown[last as usize], replay.hash, "level {name}");
        let mut game = history.at(0);
        let near = |tick: u64| [tick.saturating_sub(1), tick, tick + 1];
        for tick in (0..120).flat_map(|_| near((random.unit() * last as f64) as u64)).chain([last, 0, last + 500]) {
            history.seek(&mut game, tick);
            let tick = tick.min(last);
            assert_eq!((game.ticks(), game.hash()), (tick, flown[tick as usize]), "level {name}");
        }
        history.seek(&mut game, last / 2);
        replay.inputs.after(last / 2).for_each(|controls| game.step(controls));
        assert_eq!((game.hash(), game.outcome()), (replay.hash, Outcome::Completed));
    }
}

#[test]
fn a_flight_that_is_still_flown_can_be_looked_back_into() {
    let (level, inputs) = (level("2"), record("2", "mark").inputs);
    let hashes = hashes(&level, &inputs);
    let (mut game, mut history) = flown(level, []);
    let mut random = Random(12);
    for controls in inputs.clone() {
        game.step(controls);
        history.note(&game, controls);
        if random.unit() < 0.02 {
            let tick = (random.unit() * game.ticks() as f64) as u64;
            assert_eq!(history.at(tick).hash(), hashes[tick as usize]);
        }
    }
    assert_eq!(history.inputs(), &inputs);
    let end = history.at(u64::MAX);
    assert_eq!(end.hash(), game.hash());
    assert_eq!(history.record(&game), record("2", "mark"), "as the autopilot recorded it");
}

#[test]
fn fuel_that_lasted_for_a_while_lasts_when_it_is_flown_again() {
    let (mut game, mut history) = flown(level("1"), []);
    let mut flown = vec![game.hash()];
    for tick in 0..400_u64 {
        let controls = Controls { thrust: tick % 3 > 0, right: tick % 50 < 9, ..Controls::default() };
        game.set_lasting_fuel((90..230).contains(&tick));
        game.step(controls);
        history.note(&game, controls);
        flown.push(game.hash());
    }
    for tick in [400, 229, 230, 231, 89, 90, 91, 399, 1, 0] {
        assert_eq!(history.at(tick).hash(), flown[tick as usize], "tick {tick}");
    }
}

#[test]
fn copies_stay_few_however_long_a_flight_is() {
    let (mut game, mut history) = flown(level("1"), []);
    for _ in 0..72_000 {
        game.step(Controls::default());
        history.note(&game, Controls::default());
        let (copies, every) = history.copies();
        assert!(copies <= 256 && every <= 480, "{copies} copies, every {every} ticks");
    }
    assert!(history.copies().0 > 128, "{:?}", history.copies());
    assert_eq!(history.at(71_999).ticks(), 71_999);
}

#[test]
fn a_track_is_where_the_ship_was() {
    let (level, replay) = (level("2"), record("2", "gold"));
    let mut game = Game::new(level.clone()).unwrap();
    let mut track = GhostTrack::new(level, &replay.inputs).unwrap();
    let mut first = vec![None; game.met().len()];
    for controls in replay.inputs.clone() {
        track.fly(1, |_| ());
        game.step(controls);
        for index in (0..first.len()).filter(|index| game.met()[*index]) {
            first[index].get_or_insert(game.ticks());
        }
        let pose = track.pose(game.ticks(), 1.0);
        assert_eq!((pose.centre, pose.angle.to_bits()), (game.world().body(SHIP).position, game.ship().angle.to_bits()));
        assert_eq!(track.pose(game.ticks(), 0.0).centre, game.world().previous_position(SHIP));
    }
    assert!(!track.is_whole(), "it does not know yet that nothing follows");
    track.fly(10, |_| ());
    assert!(track.is_whole() && track.ticks() == game.ticks() && track.outcome() == Outcome::Completed);
    assert_eq!((0..first.len()).map(|index| track.met(index)).collect::<Vec<_>>(), first);
    assert!(first.len() > 1 && first.iter().all(Option::is_some), "{first:?}");
    // The place of any moment is found again from some time away.
    for tick in (60..track.ticks()).step_by(97) {
        let moves = [0.0, 1.0].map(|alpha| track.pose(tick, alpha).centre).into();
        let found = track.nearest(moves, tick.saturating_sub(50));
        assert!(track.pose(found, 1.0).centre.distance(track.pose(tick, 1.0).centre) < 1e-9, "tick {tick}: {found}");
    }
    assert_eq!(track.pose(u64::MAX, 0.5).centre, game.world().body(SHIP).position, "it stays where it ended");
}

#[test]
fn a_flight_that_goes_on_from_an_earlier_moment_is_recorded_as_one_that_was_flown_so() {
    let (level, inputs) = (level("2"), record("2", "mark").inputs);
    let fly = |until: u64| flown(level.clone(), inputs.after(0).take(until as usize));
    let (_, whole) = fly(u64::MAX);
    for tick in [0, 1, 59, 60, 61, 119, 120, 121, whole.ticks() - 1, whole.ticks(), u64::MAX] {
        let ((mut game, mut flown), mut cut) = (fly(tick), whole.until(tick));
        assert_eq!((cut.ticks(), cut.at(u64::MAX).hash()), (flown.ticks(), game.hash()), "tick {tick}");
        for _ in flown.ticks()..whole.ticks().min(tick.saturating_add(200)) {
            game.step(Controls::default());
            flown.note(&game, Controls::default());
            cut.note(&game, Controls::default());
        }
        assert_eq!(cut.record(&game), flown.record(&game), "tick {tick}");
        assert_eq!(cut.at(cut.ticks() / 2).hash(), flown.at(cut.ticks() / 2).hash());
    }
}
