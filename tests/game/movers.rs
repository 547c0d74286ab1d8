//! Blocks that move, carry, push and crush; belts, one-way platforms and trampolines: from a level's files to their effects.

use crate::support::written::{begun, wait, written};
use resultant::game::{Game, GameEvent, Outcome, SHIP, source_name};
use resultant::physics::{BodyId, DVec2, ForceKind};

const OBJECT: BodyId = BodyId(1);

fn place(game: &Game) -> DVec2 {
    game.world().body(OBJECT).position
}

fn velocity(game: &Game) -> DVec2 {
    game.world().body(OBJECT).velocity
}

/// The names of the sources of a kind of force on the object.
fn by(game: &Game, kind: ForceKind) -> Vec<String> {
    let forces = game.world().forces(OBJECT);
    let of_kind = forces.forces().iter().filter(|force| force.kind == kind);
    of_kind.map(|force| source_name(game.level(), force.source)).collect()
}

#[test]
fn a_lift_carries_what_stands_on_it_and_says_its_name() {
    // Up 10 m at 3 m/s: 0.5 s of waiting, 10/3 + 0.5 s on the way.
    let mut game = begun(&[
        ("movers.csv", "x,y,width,height,way_points,speed,wait,ease\n600,840,120,30,600 540,3,0.5,0.5\n"),
        ("objects.csv", "660,825,box:30x30,20,0,FALSE,0\n"),
    ]);
    wait(&mut game, 0.5);
    assert_eq!(place(&game), DVec2::new(22.0, 27.5), "it waits at its start");
    wait(&mut game, 2.0);
    assert!((velocity(&game).y + 3.0).abs() < 1e-9);
    assert_eq!(by(&game, ForceKind::Reaction), ["mover 1"]);
    wait(&mut game, 2.0);
    assert!(place(&game).distance(DVec2::new(22.0, 17.5)) < 1e-9, "{}", place(&game));
}

#[test]
fn a_block_pushes_what_is_in_its_way_and_goes_round_corners() {
    let mut game =
        begun(&[("movers.csv", "300,810,60,60,600 810;600 600,2,,,,round\n"), ("objects.csv", "450,855,box:30x30,20,0,FALSE,0\n")]);
    wait(&mut game, 3.0);
    // 6 m on: its right side is at 18 m.
    assert!(place(&game).distance(DVec2::new(18.5, 28.5)) < 1e-9, "{}", place(&game));
    assert_eq!(by(&game, ForceKind::Reaction).iter().filter(|name| *name == "mover 1").count(), 1);
    wait(&mut game, 2.0 + 3.5 + 5.0);
    let mover = &game.world().surfaces()[1];
    let around = mover.bounds.min;
    assert!(around.x < 20.0 && around.y > 20.0, "on its way back to the start: {around}");
}

#[test]
fn what_it_crushes_is_named() {
    let mut game = begun(&[("world.csv", "120,780,30,90\n"), ("movers.csv", "0,810,30,60,90 810,1,,,,once\n")]);
    let mut told = false;
    for _ in 0..600 {
        wait(&mut game, 1.0 / 120.0);
        told |= game.events().iter().any(|event| matches!(event, GameEvent::Crushed { .. }));
    }
    assert!(told);
    assert_eq!(game.outcome(), Outcome::Failed);
    let death = game.killed_by().unwrap();
    assert_eq!(death.name(game.level()), "crushed by mover 1");
    assert!(death.words(game.level()).starts_with("Crushed by a moving block"), "{}", death.words(game.level()));
}

#[test]
fn a_one_way_platform_lets_through_from_below() {
    for (one_way, rests) in [("top", 600.0), ("bottom", 870.0)] {
        let mut game =
            begun(&[("world.csv", &format!("600,600,120,15,,{one_way}\n")), ("objects.csv", "660,500,box:30x30,20,0,FALSE,0\n")]);
        wait(&mut game, 6.0);
        assert_eq!(place(&game).y, rests / 30.0 - 0.5, "{one_way}");
    }
    // Thrown from below at 15 m/s it comes to 11.25 m above its start, through the platform, and lands on it.
    let mut game = begun(&[("world.csv", "600,700,120,15,,top\n"), ("objects.csv", "660,855,box:30x30,20,0,FALSE,0,0,-15\n")]);
    wait(&mut game, 6.0);
    assert_eq!(place(&game).y, 700.0 / 30.0 - 0.5);
}

#[test]
fn a_belt_carries_what_lies_on_it() {
    let mut game = begun(&[("world.csv", "300,840,600,30,Rubber,,2.5\n"), ("objects.csv", "360,825,box:30x30,20,0,FALSE,0\n")]);
    wait(&mut game, 2.0);
    assert_eq!(velocity(&game), DVec2::new(2.5, 0.0));
    let on_a_mover = written(&[("movers.csv", "300,600,120,30,600 600,1,,,,,Ice,top,-1,sled\n")]);
    let sled = &on_a_mover.movers[0].solid;
    assert_eq!((sled.material.name, sled.belt, sled.name.as_deref()), ("Ice", -1.0, Some("sled")));
    assert!(sled.sides.top && !sled.sides.bottom);
}

#[test]
fn what_falls_on_a_trampoline_is_thrown_back_with_nine_tenths_of_its_speed() {
    for (restitution, e) in [(0.0, 0.9f64), (1.0, 1.0)] {
        let mut game = begun(&[
            ("world.csv", "600,840,120,30,Trampoline\n"),
            ("objects.csv", &format!("660,525,box:30x30,20,0,FALSE,{restitution}\n")),
        ]);
        // 10 m down take √2 s.
        wait(&mut game, 1.45);
        let mut highest = f64::INFINITY;
        for _ in 0..240 {
            wait(&mut game, 1.0 / 120.0);
            highest = highest.min(place(&game).y);
        }
        let rise = 27.5 - highest;
        assert!((rise - 10.0 * e * e).abs() < 2e-4, "{rise} m at {e}");
    }
}

#[test]
fn a_trampoline_bounces_a_crowd_as_well() {
    // One island of too many bodies for the exact method. From 14 m above they come down with 16.7 m/s, and go up with nine tenths of that.
    let crates: String = (0..75).map(|i| format!("{},414,box:12x12,5,0,FALSE,0\n", 180 + 12 * i)).collect();
    let mut game = begun(&[("world.csv", "150,840,1050,30,Trampoline\n"), ("objects.csv", &crates)]);
    let (mut fastest_up, mut dense) = (0.0f64, 0);
    for _ in 0..260 {
        wait(&mut game, 1.0 / 120.0);
        fastest_up = game.world().bodies().iter().map(|body| -body.velocity.y).fold(fastest_up, f64::max);
        dense += game.world().methods().in_one_step;
    }
    assert!((fastest_up - 0.9 * 280f64.sqrt()).abs() < 0.1, "{fastest_up}");
    assert!(dense > 0, "they are one island");
    assert_eq!(game.world().body(SHIP).position, DVec2::new(2.0, 28.15));
}
