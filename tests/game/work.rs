//! The work of each force, against exact answers, and the law of work and energy.

use crate::support::shipped::{experiment, flights, flown, levels, load};
use crate::support::written::{begun, written};
use resultant::game::{Controls, Game, History};
use resultant::instruments::ledger::{Account, EnergyState, WorkLedger};
use resultant::level::Level;
use resultant::physics::{BodyId, DVec2, ForceKind};
use std::sync::Arc;

struct Flown {
    game: Game,
    history: History,
}

impl Flown {
    fn of(mut game: Game, seconds: f64, controls: impl Fn(f64) -> Controls) -> Self {
        let mut history = History::new(&game);
        for _ in 0..(seconds * game.tick_rate()).round() as u32 {
            let now = controls(game.elapsed());
            game.step(now);
            history.note(&game, now);
        }
        Self { game, history }
    }

    fn resting(files: &[(&'static str, &str)], seconds: f64) -> Self {
        Self::of(begun(files), seconds, |_| Controls::default())
    }

    fn ledger(&self) -> WorkLedger {
        let mut ledger = WorkLedger::default();
        assert!(ledger.go(&self.history, self.history.ticks(), u64::MAX));
        ledger
    }

    fn account(&self, body: u32) -> Account {
        self.ledger().accounts[body as usize]
    }

    fn gained(&self, body: u32) -> f64 {
        EnergyState::of(&self.game, BodyId(body)).kinetic - EnergyState::of(self.history.start(), BodyId(body)).kinetic
    }
}

#[track_caller]
fn assert_near(found: f64, expected: f64, size: f64) {
    assert!((found - expected).abs() <= 1e-9 * size.abs(), "{found}, not {expected}");
}

/// The only works there are, J.
#[track_caller]
fn assert_works(account: &Account, expected: &[(ForceKind, f64)], by_impacts: f64) {
    let size = expected.iter().map(|(_, work)| work.abs()).fold(by_impacts.abs(), f64::max);
    for kind in ForceKind::ALL {
        let work = expected.iter().find(|(other, _)| *other == kind).map_or(0.0, |(_, work)| *work);
        assert!((account.by(kind) - work).abs() <= 1e-9 * size, "{}: {}, not {work}", kind.name(), account.by(kind));
    }
    assert_near(account.by_impacts, by_impacts, size);
}

#[test]
fn weight_does_mgh() {
    let flown = Flown::resting(&[("objects.csv", "600,100,box:30x30,2,0,FALSE,0,3,-1\n")], 1.0);
    let (way, mass) = (-1.0 + 0.5 * 10.0, 2.0);
    assert_works(&flown.account(1), &[(ForceKind::Weight, mass * 10.0 * way)], 0.0);
}

#[test]
fn friction_takes_all_that_a_slide_had_also_where_it_stops_within_a_tick() {
    // Asphalt: μ_k = 0.65. The object slides on the floor to the right.
    let objects = "300,855,box:30x30,10,0,FALSE,0,6,0\n";
    for (seconds, way) in [(0.5, 6.0 * 0.5 - 0.5 * 6.5 * 0.25), (3.0, 36.0 / 13.0)] {
        let flown = Flown::resting(&[("objects.csv", objects)], seconds);
        let account = flown.account(1);
        assert_works(&account, &[(ForceKind::Friction, -65.0 * way)], 0.0);
        assert_eq!(account.by(ForceKind::Reaction), 0.0, "the floor does no work");
    }
}

#[test]
fn what_slides_off_an_edge_was_braked_as_far_as_it_slid() {
    // A table from x = 10 m to 20 m, 4 m above the floor; the box has slid once half of it is beyond.
    let files = [("world.csv", "300,750,300,30\n"), ("objects.csv", "570,735,box:30x30,10,0,FALSE,0,6.1,0\n")];
    let flown = Flown::resting(&files, 0.65);
    let fallen = flown.game.world().body(BodyId(1)).position.y - 735.0 / 30.0;
    assert!(fallen > 0.5);
    let slid = 600.0 / 30.0 - 570.0 / 30.0 + 0.5;
    assert_works(&flown.account(1), &[(ForceKind::Friction, -65.0 * slid), (ForceKind::Weight, 100.0 * fallen)], 0.0);
}

#[test]
fn a_bounce_costs_what_restitution_says() {
    // From 10 m above the floor it hits after √2 s with 200 J and leaves with 0.49 of it.
    let flown = Flown::resting(&[("objects.csv", "600,555,box:30x30,2,0,FALSE,0.7,0,0\n")], 2.0);
    let fallen = flown.game.world().body(BodyId(1)).position.y - 18.5;
    assert_works(&flown.account(1), &[(ForceKind::Weight, 20.0 * fallen)], -200.0 * (1.0 - 0.49));
}

#[test]
fn a_landing_aside_is_braked_by_its_impact_and_then_by_friction() {
    let flown = Flown::resting(&[("objects.csv", "300,825,box:30x30,2,0,FALSE,0,5,0\n")], 0.6);
    let (account, end) = (flown.account(1), flown.game.world().body(BodyId(1)));
    // It falls by 1 m, and loses μ times the fall's speed at once.
    let (down, across) = (20f64.sqrt(), 5.0 - 0.65 * 20f64.sqrt());
    let landed = 10.0 + 5.0 * 0.2f64.sqrt();
    let works = [(ForceKind::Weight, 20.0), (ForceKind::Friction, -13.0 * (end.position.x - landed))];
    assert_works(&account, &works, across * across - (25.0 + down * down));
}

#[test]
fn drag_takes_what_a_fall_has_less_and_at_terminal_velocity_all_that_weight_does() {
    let (mass, g) = (1.0, 10.0);
    let k = 0.5 * 1.2 * 1.0 / mass;
    let terminal = f64::sqrt(g / k);
    let objects = "600,100,box:30x30,1,1,FALSE,0\n";
    let level = Arc::new(Level { air_density: 1.2, ..written(&[("objects.csv", objects)]) });
    let fall = |seconds: f64| Flown::of(Game::new(level.clone()).unwrap(), seconds, |_| Controls::default());
    let (early, late) = (fall(0.5), fall(4.5).ledger());
    let (v, x) = (terminal * f64::tanh(g * 0.5 / terminal), terminal * terminal / g * f64::cosh(g * 0.5 / terminal).ln());
    let drag = ForceKind::AirResistance;
    assert_works(&early.account(1), &[(ForceKind::Weight, mass * g * x), (drag, 0.5 * mass * v * v - mass * g * x)], 0.0);
    let mut before = WorkLedger::default();
    let flown = fall(4.5);
    assert!(before.go(&flown.history, 4 * 120, u64::MAX));
    let last = late.accounts[1].since(&before.accounts[1]);
    assert!((last.by(drag) / last.by(ForceKind::Weight) + 1.0).abs() < 1e-7, "{last:?}");
}

#[test]
fn a_lift_gives_what_weight_takes_and_the_energy_of_its_speed() {
    let lift = ("movers.csv", "600,810,150,30,600 210,4,,0,2,once\n");
    let files = [lift, ("objects.csv", "675,795,box:30x30,50,0,FALSE,0\n")];
    for (seconds, way, speed) in [(1.0, 1.0, 2.0), (3.0, 8.0, 4.0), (6.99, 20.0, 0.0), (8.0, 20.0, 0.0)] {
        let flown = Flown::resting(&files, seconds);
        let account = flown.account(1);
        let body = flown.game.world().body(BodyId(1));
        if seconds != 6.99 {
            assert_near(body.velocity.length(), speed, 4.0);
            assert_near(account.by(ForceKind::Weight), -500.0 * way, 1e4);
            assert_near(account.by(ForceKind::Reaction), 500.0 * way + 25.0 * speed * speed, 1e4);
        }
        assert_near(account.sum(), flown.gained(1), 1e4);
    }
}

#[test]
fn buoyancy_does_the_weight_of_what_is_displaced_times_the_way() {
    let water = ("fluids.csv", "0,300,1200,570,1000,0\n");
    let sinks = Flown::resting(&[water, ("objects.csv", "600,400,box:30x30,2000,0,FALSE,0\n")], 1.0);
    assert_works(&sinks.account(1), &[(ForceKind::Weight, 20_000.0 * 2.5), (ForceKind::Buoyancy, -10_000.0 * 2.5)], 0.0);
    // Let go with its lower side on the water, it floats up and down without loss: F = −ρgA·depth.
    let floats = Flown::resting(&[water, ("objects.csv", "600,285,box:30x30,600,0,FALSE,0\n")], 0.4);
    let depth = floats.game.world().body(BodyId(1)).position.y - 9.5;
    assert!(depth > 0.4 && depth < 1.0, "{depth}");
    let expected = [(ForceKind::Weight, 6000.0 * depth), (ForceKind::Buoyancy, -5000.0 * depth * depth)];
    assert_works(&floats.account(1), &expected, 0.0);
}

#[test]
fn collisions_keep_the_momentum_of_all_and_elastic_ones_the_energy() {
    for (restitution, kept) in [(1.0, 1.0), (0.5, 0.25), (0.0, 0.0)] {
        let ice = ("world.csv", "0,600,1050,30,Ice\n");
        let object = |x, mass, vx| format!("{x},585,box:30x30,{mass},0,FALSE,{restitution},{vx},0,Ice,TRUE\n");
        let objects = object(300, 3, 8) + &object(600, 5, -2);
        let flown = Flown::resting(&[ice, ("objects.csv", &objects)], 2.0);
        let [start, end] = [flown.history.start(), &flown.game].map(|game| {
            let ids = (0..game.world().bodies().len() as u32).map(BodyId);
            ids.map(|id| EnergyState::of(game, id)).fold(EnergyState::default(), std::ops::Add::add)
        });
        assert_near(end.momentum.x, 24.0 - 10.0, 14.0);
        assert_eq!(start.momentum, DVec2::new(14.0, 0.0));
        let all = flown.ledger().accounts.iter().fold(Account::default(), |sum, account| sum.plus(account));
        // ½μ·v² of the reduced mass 15/8 kg at 10 m/s is the most that a collision can take.
        assert_works(&all, &[], -0.5 * (15.0 / 8.0) * 100.0 * (1.0 - kept));
    }
}

#[test]
fn within_a_pushed_row_the_pushes_pass_on_what_they_take() {
    // The ship on its side behind two boxes.
    let player = ("player.csv", "");
    let objects = "100.5,855,box:30x30,20,0,FALSE,0\n130.5,855,box:30x30,40,0,FALSE,0\n";
    let mut level = written(&[player, ("objects.csv", objects)]);
    level.player.angle = 90.0;
    let game = Game::new(Arc::new(level)).unwrap();
    let flown = Flown::of(game, 1.0, |_| Controls { thrust: true, ..Controls::default() });
    let (ledger, way) = (flown.ledger(), flown.game.world().body(BodyId(0)).position.x - 2.0);
    assert!(way > 1.0);
    let [ship, first, second] = [0, 1, 2].map(|i| ledger.accounts[i]);
    let push = |account: &Account| account.by(ForceKind::Push);
    assert_near(push(&ship) + push(&first) + push(&second), 0.0, push(&ship));
    assert_near(ship.by(ForceKind::Drive), 2000.0 * way, 2000.0 * way);
    assert_near(second.by(ForceKind::Friction), -0.65 * 400.0 * way, 2000.0 * way);
    assert_near(push(&second) + second.by(ForceKind::Friction), flown.gained(2), 2000.0 * way);
}

fn careful(level: &str) -> Flown {
    let replay = flights(level).remove("careful").expect("a careful flight");
    let (game, history) = flown(load(level), replay.inputs);
    Flown { game, history }
}

/// ΔE_kin = Σ W + W_impacts for every body; after going back the accounts are the same, to the bit.
#[test]
fn the_law_of_work_and_energy_holds_in_every_level() {
    for level in levels() {
        let flown = careful(&level);
        let mut ledger = flown.ledger();
        let last = ledger.accounts.to_vec();
        for (body, account) in (0..).zip(&last) {
            let size = account.by_force.iter().chain([&account.by_impacts]).fold(1.0, |size: f64, work| size.max(work.abs()));
            assert_near(account.sum(), flown.gained(body), size);
        }
        let ticks = flown.history.ticks();
        for tick in [ticks / 2, ticks / 2 - 1, 17, 0, ticks] {
            assert!(ledger.go(&flown.history, tick, u64::MAX));
            let mut fresh = WorkLedger::default();
            fresh.go(&flown.history, tick, u64::MAX);
            assert_eq!(ledger.accounts, fresh.accounts, "level {level}, tick {tick}");
        }
        assert_eq!(ledger.accounts, last);
    }
}

/// The work of each force at 120 ticks a second agrees with that at 3840: no part of the sum is another's.
#[test]
fn no_force_gets_the_work_of_another() {
    for folder in ["buoyancy", "wind-and-friction", "terminal-velocity", "projectile"] {
        let game = |rate: f64| Game::with_tick_rate(experiment(folder), rate).unwrap();
        let [coarse, fine] = [120.0, 3840.0].map(|rate| Flown::of(game(rate), 4.0, |_| Controls::default()).ledger());
        for (coarse, fine) in coarse.accounts.iter().zip(fine.accounts) {
            let size = fine.by_force.iter().fold(1.0, |size: f64, work| size.max(work.abs()));
            for kind in ForceKind::ALL {
                let error = (coarse.by(kind) - fine.by(kind)).abs() / size;
                assert!(error < 2e-4, "{folder}, {}: {} and {}", kind.name(), coarse.by(kind), fine.by(kind));
            }
        }
    }
}

#[test]
fn a_crowd_has_no_accounts() {
    let objects: String = (0..300).map(|i| format!("{},{},box:9x9,1,0,FALSE,0\n", 100 + i % 60 * 15, 300 + i / 60 * 15)).collect();
    let flown = Flown::resting(&[("objects.csv", &objects)], 0.1);
    assert!(!WorkLedger::default().go(&flown.history, 12, u64::MAX));
}
