//! Switches and the parts that they work, fragile blocks, pods, weightless objects, gravity by level and by zone, winds that solids shade:
//! from a level's files to their effects.

use crate::support::rooms::THRUST;
use crate::support::written::{begun, wait, written};
use resultant::game::{BURN_RATE, Controls, Game, GameEvent, Recorder, SHIP, level_hash, source_name};
use resultant::level::{SurfaceOf, Worked};
use resultant::physics::{BodyId, DVec2, ForceKind};
use std::sync::Arc;

const GATE: (&str, &str) = ("doors.csv", "600,600,30,270,gate\n");

fn body(game: &Game, index: u32) -> &resultant::physics::Body {
    game.world().body(BodyId(index))
}

fn closed(game: &Game) -> bool {
    game.world().surfaces()[game.level().surface_index(SurfaceOf::Door(0))].present
}

fn row_of(height: f64, mass: f64) -> String {
    format!("x,y,image,mass,drag,circular,restitution\n345,{height},box:30x30,{mass},0,FALSE,0\n")
}

#[test]
fn a_plate_is_pressed_by_more_than_its_weight() {
    for (mass, pressed) in [(39.0, false), (40.0, false), (41.0, true)] {
        let plate = ("switches.csv", "x,y,width,height,works,weight\n300,855,90,15,gate,400\n");
        let mut game = begun(&[GATE, plate, ("objects.csv", &row_of(840.0, mass))]);
        assert!(closed(&game));
        wait(&mut game, 0.1);
        let found = [game.mechanisms().is_pressed(0), game.mechanisms().on()[0], !closed(&game)];
        assert_eq!(found, [pressed; 3], "{mass} kg");
        assert_eq!(game.mechanisms().is_on(Worked::Door(0)), pressed);
    }
    let column: String = (0..3).map(|i| format!("345,{},box:30x30,15,0,FALSE,0\n", 840 - 30 * i)).collect();
    let mut game = begun(&[GATE, ("switches.csv", "300,855,90,15,gate,400\n"), ("objects.csv", &column)]);
    wait(&mut game, 0.1);
    assert!(game.mechanisms().on()[0]);
    let forces = game.world().forces(BodyId(1));
    let reaction = forces.forces().iter().find(|force| force.kind == ForceKind::Reaction && force.vector.y < 0.0).unwrap();
    assert_eq!((source_name(game.level(), reaction.source).as_str(), reaction.vector.y), ("switch 1", -450.0));
}

#[test]
fn switches_are_held_latched_or_toggled_by_those_who_may() {
    // A key object flies by twice: through the area, and back from the wall.
    let key = "OBJECT,300,700,box:30x30,10,200,0,200,1,0,10,0,,TRUE\n";
    for (row, states) in [
        ("450,660,60,60,gate,,,held", [true, false, true, false]),
        ("450,660,60,60,gate,,,latched", [true, true, true, true]),
        ("450,660,60,60,gate,,key,toggled", [true, true, false, false]),
        ("450,660,60,60,gate,,object,held", [true, false, true, false]),
        ("450,660,60,60,gate,,ship,held", [false, false, false, false]),
    ] {
        let mut game = begun(&[GATE, ("world.csv", "570,660,30,60\n"), ("objectives.csv", key), ("switches.csv", row)]);
        let mut seen = Vec::new();
        for seconds in [0.6, 0.4 - 0.2, 0.4, 0.4] {
            wait(&mut game, seconds);
            seen.push(game.mechanisms().on()[0]);
        }
        // In the area from 0.45 s to 0.75 s; at the wall at 0.85 s; there again from 0.95 s to 1.25 s.
        assert_eq!(seen, states.map(|on| on), "{row}");
    }
}

#[test]
fn a_switch_works_movers_belts_and_winds_both_ways() {
    let mut game = begun(&[
        ("movers.csv", "x,y,width,height,way_points,speed,name\n600,300,60,30,900 300,2,lift\n"),
        ("world.csv", "600,600,300,30,Rubber,,2,,belt\n"),
        ("hazards.csv", "x,y,width,height,stream_width,stream_height,force_x,force_y,shaded,name\n0,400,30,60,300,0,50,0,,fan\n"),
        ("objects.csv", "750,585,box:30x30,10,0,FALSE,0\n"),
        ("switches.csv", "x,y,width,height,works,by,stays\n30,600,60,60,lift belt !fan,ship,latched\n"),
    ]);
    let lift = game.level().surface_index(SurfaceOf::Mover(0));
    let state = |game: &Game| (game.world().surfaces()[lift].bounds.min.x, body(game, 1).velocity.x, game.world().blows(0));
    wait(&mut game, 0.5);
    assert_eq!(state(&game), (20.0, 0.0, true));
    let mut pressed = 0;
    while !game.mechanisms().on()[0] {
        game.step(THRUST);
        pressed += game.events().iter().filter(|event| **event == GameEvent::Switched(0, true)).count();
    }
    assert_eq!(pressed, 1);
    wait(&mut game, 1.0);
    assert!((state(&game).0 - 22.0).abs() < 1e-9, "{}", state(&game).0);
    assert_eq!((state(&game).1, state(&game).2), (2.0, false));
}

#[test]
fn a_thing_of_two_names_is_on_while_a_switch_of_each_is() {
    // Two boxes fall onto plates, the second one from higher up; a third plate stays free.
    let doors = "600,600,30,270,left&right\n600,300,30,270,left&right&free\n900,300,30,270,left&nobody\n900,600,30,270,left&off\n";
    let files = [
        ("doors.csv", doors),
        ("objects.csv", "345,840,box:30x30,10,0,FALSE,0\n445,600,box:30x30,10,0,FALSE,0\n"),
        ("switches.csv", "300,855,90,15,left !off,50\n400,855,90,15,right,50\n500,855,90,15,free,50\n"),
    ];
    let mut game = begun(&files);
    let open = |game: &Game| [0, 1, 2, 3].map(|door| game.mechanisms().is_on(Worked::Door(door)));
    assert_eq!(open(&game), [false; 4]);
    wait(&mut game, 0.1);
    assert_eq!(open(&game), [false, false, true, false], "a name that no switch works does not count");
    wait(&mut game, 2.0);
    assert_eq!(open(&game), [true, false, true, false]);
}

#[test]
fn a_door_waits_for_what_is_in_its_way() {
    let mut game = begun(&[
        ("doors.csv", "300,840,60,30,gate\n"),
        ("switches.csv", "x,y,width,height,works,by\n0,820,120,50,!gate,ship\n"),
        ("objects.csv", "330,700,box:30x30,10,0,FALSE,0\n"),
    ]);
    assert!(!closed(&game), "open, for nobody has pressed yet");
    wait(&mut game, 0.1);
    assert!(closed(&game));
    let mut game = begun(&[("doors.csv", "60,840,60,30,gate\n"), ("switches.csv", "900,820,120,50,!gate\n")]);
    wait(&mut game, 0.5);
    assert!(!closed(&game), "the ship stands in it and it is open");
}

#[test]
fn switches_are_part_of_the_state_and_of_records() {
    let files = [
        GATE,
        ("switches.csv", "x,y,width,height,works,by,stays\n30,600,60,60,gate,ship,toggled\n"),
        ("pods.csv", "0,700,120,30,100\n"),
    ];
    let level = Arc::new(written(&files));
    let mut recorder = Recorder::default();
    let mut game = Game::new(Arc::clone(&level)).unwrap();
    for tick in 0..400 {
        let controls = if tick < 100 { THRUST } else { Controls::default() };
        game.step(controls);
        recorder.note(&game, controls);
    }
    assert!(game.mechanisms().on()[0] != game.mechanisms().is_pressed(0) || game.mechanisms().is_taken(0));
    let replay = recorder.finish(&game);
    assert_eq!(replay.verify(level, |_| {}), Ok(Ok(())));
    let mut other = begun(&files);
    let before = other.hash();
    wait(&mut other, 1.0);
    assert_ne!(before, other.hash());
    let hashes = |extra: &[(&'static str, &str)]| level_hash(&written(extra));
    let all = [
        hashes(&[]),
        hashes(&[GATE]),
        hashes(&[GATE, files[1]]),
        hashes(&[GATE, ("switches.csv", "30,600,60,60,gate,,ship,latched\n")]),
        hashes(&[GATE, ("switches.csv", "30,600,60,60,!gate,,ship,latched\n")]),
        hashes(&[GATE, ("switches.csv", "30,600,60,60,gate,10,,latched\n")]),
        hashes(&[("pods.csv", "0,700,120,30,100\n")]),
        hashes(&[("gravity.csv", "0,700,120,30,1,2\n")]),
        hashes(&[("constants.csv", "gravity_x,3\n")]),
        hashes(&[("movers.csv", "600,840,120,30,600 540,3\n")]),
        hashes(&[("movers.csv", "600,840,120,30,600 540,3,,,,once\n")]),
        hashes(&[("world.csv", "300,0,30,30\n")]),
        hashes(&[("world.csv", "300,0,30,30,,top\n")]),
        hashes(&[("world.csv", "300,0,30,30,,,3\n")]),
        hashes(&[("world.csv", "300,0,30,30,,,,3\n")]),
        hashes(&[("world.csv", "300,0,30,30,Trampoline\n")]),
    ];
    for (i, hash) in all.iter().enumerate() {
        assert!(!all[..i].contains(hash), "level {i}");
    }
}

#[test]
fn a_fragile_block_breaks_above_its_impulse() {
    // 10 kg from 5 m: 10 m/s, 100 N·s.
    for (breaks, broken) in [(99.0, true), (101.0, false)] {
        let mut game = begun(&[
            ("world.csv", &format!("600,600,90,30,Glass,,,{breaks}\n")),
            ("objects.csv", "645,435,box:30x30,10,0,FALSE,0\n"),
        ]);
        let mut told = 0;
        for _ in 0..125 {
            wait(&mut game, 1.0 / 120.0);
            told += game.events().iter().filter(|event| **event == GameEvent::Broke(1)).count();
        }
        assert_eq!((told, game.mechanisms().is_broken(1)), (usize::from(broken), broken), "{breaks} N·s");
        wait(&mut game, 3.0);
        let rests = if broken { 870.0 } else { 600.0 };
        assert_eq!(body(&game, 1).position.y, rests / 30.0 - 0.5);
    }
}

#[test]
fn a_pod_fills_the_tank_as_far_as_it_goes() {
    let mut game = begun(&[("pods.csv", "x,y,width,height,fuel\n0,840,120,30,40\n")]);
    wait(&mut game, 0.5);
    assert!(!game.mechanisms().is_taken(0), "a full tank leaves it alone");
    game.step(THRUST);
    assert!(game.mechanisms().is_taken(0));
    assert_eq!(game.events().iter().filter(|event| **event == GameEvent::Refuelled(0)).count(), 1);
    assert_eq!(game.ship().fuel, 500.0, "no more than the tank holds");
    (0..119).for_each(|_| game.step(THRUST));
    assert!((game.result().fuel_used - BURN_RATE).abs() < 1e-9);
    assert!((game.ship().fuel - (500.0 - 119.0 * BURN_RATE / 120.0)).abs() < 1e-9);
    let mut game = begun(&[("player.csv", ""), ("pods.csv", "0,600,120,30,40\n")]);
    while !game.mechanisms().is_taken(0) {
        game.step(THRUST);
    }
    let before = game.ship().fuel;
    game.step(THRUST);
    assert!((before - game.ship().fuel - BURN_RATE / 120.0).abs() < 1e-9);
}

#[test]
fn a_weightless_thing_has_no_weight_and_stays() {
    let mut game =
        begun(&[("objects.csv", "x,y,image,mass,drag,circular,restitution,weightless\n300,300,box:30x30,0.7,0,FALSE,0,TRUE\n")]);
    wait(&mut game, 5.0);
    assert_eq!((body(&game, 1).position, body(&game, 1).velocity), (DVec2::splat(10.0), DVec2::ZERO));
    assert!(game.world().forces(BodyId(1)).forces().is_empty());
}

#[test]
fn gravity_by_zone_adds_to_that_of_the_level() {
    for (field, falls) in [("0,-10", DVec2::ZERO), ("0,-25", DVec2::new(0.0, -15.0)), ("4,0", DVec2::new(4.0, 10.0))] {
        let mut game = begun(&[
            ("gravity.csv", &format!("300,0,900,800,{field}\n")),
            ("objects.csv", "x,y,image,mass,drag,circular,restitution\n660,400,box:30x30,0.7,0,FALSE,0\n"),
        ]);
        wait(&mut game, 0.5);
        assert!((body(&game, 1).velocity - falls * 0.5).length() < 1e-12, "{field}: {}", body(&game, 1).velocity);
        assert_eq!(body(&game, 1).velocity == DVec2::ZERO, falls == DVec2::ZERO, "what is held exactly rests exactly");
        let forces = game.world().forces(BodyId(1));
        let weights: Vec<_> = forces.forces().iter().map(|force| (force.kind, source_name(game.level(), force.source))).collect();
        assert_eq!(weights, [(ForceKind::Weight, "gravity".to_owned()), (ForceKind::Weight, "gravity 1".to_owned())]);
    }
}

#[test]
fn gravity_to_the_side_makes_a_floor_of_the_wall() {
    let mut game = begun(&[
        ("constants.csv", "gravity_x,12\n"),
        ("objects.csv", "900,400,box:30x30,3,0,FALSE,0\n900,365,box:30x30,5,0,FALSE,0\n900,300,box:30x30,0.7,0,FALSE,0\n"),
    ]);
    wait(&mut game, 12.0);
    for object in 1..=3 {
        let thing = body(&game, object);
        assert_eq!((thing.velocity, thing.acceleration), (DVec2::ZERO, DVec2::ZERO), "object {object}");
        assert_eq!(thing.position.x, 39.5);
    }
    let forces = game.world().forces(BodyId(1));
    assert!(forces.forces().iter().any(|force| source_name(game.level(), force.source) == "edge right"));
    assert_eq!(forces.resultant(), DVec2::ZERO);
    let weights = forces.forces().iter().filter(|force| force.kind == ForceKind::Weight);
    assert!(weights.clone().all(|force| source_name(game.level(), force.source) == "gravity"));
    assert_eq!(weights.map(|force| force.vector).sum::<DVec2>(), DVec2::new(36.0, 30.0));
}

#[test]
fn a_crowd_rests_on_the_wall_under_gravity_to_the_side() {
    let crates: String =
        (0..80).map(|i| format!("{},{},box:20x20,{},0,FALSE,0\n", 700 + 21 * (i % 8), 300 + 22 * (i / 8), 1 + i % 7)).collect();
    let mut game = begun(&[("constants.csv", "gravity_x,15\n"), ("objects.csv", &crates)]);
    wait(&mut game, 20.0);
    let fastest = game.world().bodies().iter().map(|body| body.velocity.length()).fold(0.0, f64::max);
    assert_eq!(fastest, 0.0);
    assert!(game.world().body(SHIP).position.x > 30.0, "the ship slid there, too");
}

#[test]
fn a_wind_is_shaded_where_it_is_told_to() {
    for (shaded, reach) in [("", 300.0), ("FALSE", 300.0), ("TRUE", 130.0)] {
        let level =
            written(&[("hazards.csv", &format!("300,500,60,30,0,-300,0,-900,{shaded}\n")), ("world.csv", "330,340,90,30\n")]);
        let zone = &level.streams[0].zone;
        assert!((zone.size().y - reach / 30.0).abs() < 1e-9, "{shaded}: {zone:?}");
    }
}

#[test]
fn switches_work_links_by_name() {
    let (held, hung) = ("rope,load,600 150,,50000,2000,,holds", "rope,900 150,lamp,,50000,2000,-1,winch");
    let links = format!("kind,a,b,length,stiffness,damping,rate,name\n{held}\n{hung}\n");
    let objects = "600,300,box:30x30,10,0,FALSE,0,load\n900,300,box:30x30,10,0,FALSE,0,lamp\n";
    let objects = format!("x,y,image,mass,drag,circular,restitution,name\n{objects}");
    let switches = "x,y,width,height,works,by,stays\n30,600,60,60,winch !holds,ship,latched\n";
    let files = [("objects.csv", &objects[..]), ("links.csv", &links), ("switches.csv", switches)];
    let mut game = begun(&files);
    wait(&mut game, 2.0);
    let rests = [body(&game, 1).position, body(&game, 2).position];
    assert!((rests[0].y - 10.0).abs() < 0.01 && (rests[1].y - 10.0).abs() < 0.01, "{rests:?}");
    let forces = game.world().forces(BodyId(1));
    assert!((forces.total(ForceKind::Tension).y + 100.0).abs() < 1.0);
    assert_eq!(source_name(game.level(), forces.all(ForceKind::Tension).next().unwrap().source), "link 1");
    while !game.mechanisms().on()[0] {
        game.step(THRUST);
    }
    wait(&mut game, 1.0);
    assert!((body(&game, 1).position.y - rests[0].y - 5.0).abs() < 0.3, "let go, it falls: {}", body(&game, 1).position.y);
    assert!((rests[1].y - body(&game, 2).position.y - 1.0).abs() < 0.1, "wound up: {}", body(&game, 2).position.y);
    let hash = |links: &str| level_hash(&written(&[files[0], ("links.csv", links)]));
    let all = "|rope,load,lamp,,9|spring,load,lamp,,9|rope,load,lamp,50,9|rope,load,lamp,,9,1|rope,load,9 9,,9";
    let all: Vec<&str> = all.split('|').collect();
    let hashes: Vec<_> = all.into_iter().map(hash).collect();
    assert!((1..hashes.len()).all(|i| !hashes[..i].contains(&hashes[i])));
}
