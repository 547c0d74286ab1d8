//! Levels that load, and their contents; and levels that are not finished, with the flights that are possible in them.

use crate::support::Memory;
use crate::{fixtures, good, lines, package, rectangle};
use resultant::game::{Controls, Game, Outcome};
use resultant::level::{self, Look, ObjectiveKind, Presser, Route, SurfaceOf, SwitchStay, Work};
use resultant::physics::{Aabb, DVec2, Material, Sides, World};
use std::sync::Arc;

#[test]
fn a_folder_written_for_the_original_loads_unchanged() {
    let level = good("good_original");
    assert_eq!((level.name.as_str(), level.title.as_str()), ("good_original", "good_original"));
    assert_eq!((level.metre, level.size), (30.0, DVec2::new(1000.0, 600.0) / 30.0));
    assert_eq!((level.gravity, level.air_density, level.optimal_time, level.rest_speed), (15.0, 1.2041, 60.0, 0.0));
    assert_eq!(level.background, Some(fixtures().join("levels/good_original/background.png")));
    let ship = &level.player;
    assert_eq!((ship.position, ship.velocity, ship.angle), (DVec2::splat(50.0) / 30.0, DVec2::ZERO, 0.0));
    assert_eq!((ship.mass, ship.fuel, ship.thrust, ship.feels_air), (100.0, 500.0, 3000.0, true));
    let [ball, cube] = &level.objects[..] else { panic!("{:?}", level.objects) };
    assert_eq!((ball.position, ball.size), (DVec2::splat(100.0) / 30.0, DVec2::splat(40.0) / 30.0));
    assert_eq!((ball.mass, ball.drag, ball.circular, ball.restitution), (150.0, 0.5, true, 0.35));
    assert_eq!((&ball.look, ball.key), (&Look::Image(fixtures().join("assets/sprites/ball.png")), None));
    assert_eq!((cube.position, cube.size), (DVec2::new(600.0, 100.0) / 30.0, DVec2::new(30.0, 20.0) / 30.0));
    assert_eq!((cube.mass, cube.restitution, cube.drag, cube.circular), (75.0, 0.5, 0.1, false));
    assert_eq!(cube.key, Some([181, 49, 201]));
    assert_eq!(level.objectives.len(), 1);
    assert_eq!(level.objectives[0].kind, ObjectiveKind::Physics);
    assert_eq!(level.objectives[0].bounds, rectangle(550.0, 200.0, 100.0, 10.0));
    assert_eq!(level.obstacles, [rectangle(300.0, 300.0, 20.0, 20.0)]);
    assert_eq!((level.world[0].bounds, level.world[0].material), (rectangle(0.0, 560.0, 1000.0, 40.0), Material::ASPHALT));
    let [up, left] = &level.streams[..] else { panic!("{:?}", level.streams) };
    assert_eq!((up.source, up.force), (rectangle(700.0, 300.0, 40.0, 80.0), DVec2::new(0.0, -1200.0)));
    assert_eq!(up.zone, rectangle(700.0, 180.0, 40.0, 120.0));
    assert_eq!(left.zone, rectangle(750.0, 300.0, 50.0, 80.0));
}

/// The three sprites that the original's rows name come with the game.
#[test]
fn rows_typed_from_the_original_load_and_their_sprites_go_into_a_pack() {
    let levels = tempfile::tempdir().unwrap();
    let folder = levels.path().join("typed");
    std::fs::create_dir(&folder).unwrap();
    for (file, text) in [
        ("constants.csv", "width,1000\nheight,600\n"),
        ("player.csv", "50,50,100,500,3000,TRUE\n"),
        ("objects.csv", "100,100,assets/sprites/ball.png,150,0.5,TRUE,0.35\n300,100,assets/sprites/cube.png,100,1.05,FALSE,0.2\n"),
        ("objectives.csv", "OBJECT,600,100,assets/sprites/pinkcube.png,75,181,49,201,0.5,0.1\nPHYS,550,200,100,10\n"),
    ] {
        std::fs::write(folder.join(file), text).unwrap();
    }
    let level = level::load(&folder, package()).unwrap_or_else(|problems| panic!("{}", lines(&problems))).level;
    assert_eq!(level.objects.len(), 3);
    for object in &level.objects {
        let Look::Image(path) = &object.look else { panic!("{object:?}") };
        assert!(level::read_picture(path).is_ok() && object.size == DVec2::splat(40.0) / 30.0, "{object:?}");
    }
    let (packed, left) = resultant::pack::gather(&folder, package()).unwrap();
    for sprite in ["ball", "cube", "pinkcube"] {
        assert!(packed.files.contains_key(&format!("assets/sprites/{sprite}.png")), "{sprite}: {:?}", packed.files.keys());
    }
    assert!(left.is_empty(), "{left:?}");
}

#[test]
fn columns_come_in_any_order_and_may_be_left_out_or_empty() {
    let level = good("good_any_order");
    assert_eq!((level.gravity, level.air_density, level.optimal_time, level.rest_speed), (9.81, 0.0, 30.0, 0.0));
    assert_eq!((level.title.as_str(), level.metre, level.size), ("Any, order", 50.0, DVec2::new(20.0, 10.0)));
    assert_eq!(level.background, None);
    let ship = &level.player;
    assert_eq!((ship.position, ship.velocity, ship.angle), (DVec2::new(4.0, 2.0), DVec2::new(1.0, -2.0), 45.0));
    assert_eq!((ship.mass, ship.fuel, ship.thrust, ship.feels_air), (75.0, 0.0, 0.0, false));
    assert_eq!([level.world[0].material, level.world[1].material], [Material::ICE, Material::ASPHALT]);
    let ball = &level.objects[0];
    assert_eq!((&ball.look, ball.velocity, ball.size), (&Look::Ball, DVec2::new(-3.0, 4.0), DVec2::splat(0.8)));
    assert_eq!([ship.material, level.objects[0].material], [Material::RUBBER, Material::WOOD]);
    assert_eq!([level.objects[1].material, level.objects[2].material], [Material::ASPHALT, Material::STEEL]);
    assert_eq!((level.fluids[0].density, level.fluids[0].viscosity, level.fluids[0].colour), (900.0, 0.5, [1, 2, 3]));
    assert_ne!(level.fluids[1].colour, [1, 2, 3]);
    let zone = |i: usize| (level.streams[i].zone, level.streams[i].force);
    let right = Aabb::new(DVec2::new(15.0, 2.0), DVec2::new(17.0, 3.0));
    let down = Aabb::new(DVec2::new(14.0, 5.0), DVec2::new(15.0, 7.0));
    assert_eq!([zone(0), zone(1)], [(right, DVec2::new(5.0, 0.0)), (down, DVec2::new(0.0, 5.0))]);
    assert_eq!((level.texts[0].text.as_str(), level.texts[0].size), ("Up, then \"right\"", 0.4));
}

#[test]
fn the_world_holds_the_ship_then_the_objects_and_the_source_blocks_behind_the_world() {
    let level = good("good_original");
    let def = level.world_def();
    assert_eq!(def.bounds, Some(Aabb::new(DVec2::ZERO, level.size)));
    assert_eq!(def.bodies.len(), 3);
    assert_eq!((def.bodies[0].half, def.bodies[0].drag, def.bodies[0].restitution), (level::SHIP_HALF, 1.15, 0.0));
    assert_eq!((def.bodies[1].mass, def.bodies[2].mass), (150.0, 75.0));
    let surfaces: Vec<Aabb> = def.surfaces.iter().map(|surface| surface.bounds).collect();
    assert_eq!(surfaces, [level.world[0].bounds, level.streams[0].source, level.streams[1].source]);
    assert_eq!(def.surfaces[1].material, Material::STEEL, "air streams blow from steel");
    assert_eq!((def.streams[1].zone, def.streams[1].force), (level.streams[1].zone, DVec2::new(-10.0, 0.0)));
    assert_eq!(def.bodies.iter().map(|body| body.round).collect::<Vec<_>>(), [false, true, false]);
    assert_eq!(World::new(def).map(|world| world.bodies().len()), Ok(3));
    let bodies = good("good_any_order").world_def().bodies;
    let materials: Vec<_> = bodies.iter().map(|body| body.material).collect();
    assert_eq!(materials, [Material::RUBBER, Material::WOOD, Material::ASPHALT, Material::STEEL]);
}

#[test]
fn what_there_is_to_build_with() {
    let level = good("good_blocks");
    let [floor, platform, belt, glass, mat] = &level.world[..] else { panic!("{:?}", level.world) };
    assert_eq!((floor.sides, floor.belt, floor.breaks, &floor.name), (Sides::ALL, 0.0, None, &None));
    assert_eq!((platform.sides, belt.belt, belt.name.as_deref()), (Sides::TOP, 2.5, Some("mill")));
    assert_eq!((glass.breaks, mat.material), (Some(120.5), Material::TRAMPOLINE));
    let mover = &level.movers[0];
    let stops = [(30.0, 415.0), (230.0, 415.0), (230.0, 315.0)].map(|(x, y)| DVec2::new(x, y) / 30.0);
    assert_eq!((&mover.stops[..], mover.manner.route), (&stops[..], Route::Round));
    assert_eq!((level.doors[0].name.as_deref(), level.doors[0].material), (Some("gate"), Material::STEEL));
    let work = |name: &str, inverted| Work { name: name.into(), inverted };
    let [plate, area] = &level.switches[..] else { panic!("{:?}", level.switches) };
    assert_eq!((plate.weight, plate.latch), (Some(250.0), SwitchStay::Latched));
    assert_eq!(plate.works, [work("gate", false), work("mill", true)]);
    assert_eq!((area.weight, area.latch, area.by), (None, SwitchStay::Toggled, Presser::Key));
    // The door does not shade; nothing of the world is in the way.
    assert_eq!((level.streams[0].name.as_deref(), level.streams[0].zone.min.x), (Some("fan"), 940.0 / 30.0));
    assert_eq!((level.fields[0].strength, level.pods[0].fuel), (DVec2::new(0.0, -9.5), 125.0));
    assert!(level.objects[0].weightless);
    let surfaces: Vec<SurfaceOf> = (0..14).map(|index| level.surface(index)).collect();
    let kinds =
        (0..5).map(SurfaceOf::World).chain([SurfaceOf::Source(0), SurfaceOf::Mover(0), SurfaceOf::Door(0), SurfaceOf::Plate(0)]);
    let kinds: Vec<SurfaceOf> = kinds.chain((0..4).map(SurfaceOf::Edge)).chain([SurfaceOf::Edge(3)]).collect();
    assert_eq!(surfaces, kinds);
    assert!(kinds[..13].iter().enumerate().all(|(index, of)| level.surface_index(*of) == index));
    let def = level.world_def();
    assert_eq!(def.surfaces.len(), 9);
    assert_eq!((def.surfaces[2].belt, def.surfaces[6].runs, def.surfaces[7].present), (2.5, false, true));
    assert!(World::new(def).is_ok());
}

#[test]
fn pictures_of_a_level_may_lie_in_its_own_folder() {
    let level = good("good_own_image");
    let own = fixtures().join("levels/good_own_image");
    assert_eq!(level.objects[0].look, Look::Image(own.join("own.png")));
    assert_eq!(level.objects[1].look, Look::Image(fixtures().join("assets/sprites/ball.png")));
    let [behind, front] = &level.decoration[..] else { panic!("{:?}", level.decoration) };
    assert_eq!((&behind.look, behind.in_front, front.in_front), (&Look::Image(own.join("art/cube.png")), false, true));
    assert_eq!(behind.bounds, rectangle(10.0, 10.0, 30.0, 20.0));
}

#[test]
fn comments_may_be_quoted_and_padded() {
    let level = good("good_comments");
    assert_eq!((level.world.len(), level.texts[0].text.as_str()), (2, "# no comment"));
}

#[test]
fn what_cannot_be_read_is_a_problem_too() {
    let project = tempfile::tempdir().unwrap();
    let missing = level::load(&project.path().join("7"), project.path()).unwrap_err();
    assert_eq!(lines(&missing), "player.csv:1: column \"x\": found no folder \"7\", expected a level folder\n");
    let folder = project.path().join("8");
    std::fs::create_dir_all(folder.join("player.csv")).unwrap();
    std::fs::create_dir_all(folder.join("background.png")).unwrap();
    let problems = lines(&level::load(&folder, project.path()).unwrap_err());
    assert!(problems.contains("player.csv:1: column \"x\": found a file that cannot be read ("), "{problems}");
    assert!(problems.contains("background.png: found \"background.png\", which cannot be read ("), "{problems}");
    assert!(!problems.contains("exactly one row"), "one cause, one problem:\n{problems}");
}

const CONSTANTS: (&str, &str) = ("constants.csv", "name,value\nwidth,800\nheight,600\n");
const PLAYER: (&str, &str) = ("player.csv", "x,y,mass,fuel,thrust\n400,300,100,500,3000\n");

fn files(files: &[(&'static str, &str)]) -> Memory {
    Memory(files.iter().map(|(name, text)| (*name, (*text).to_owned())).collect())
}

#[test]
fn a_ship_and_a_size_are_enough_and_no_pad_is_ever_met() {
    let files = files(&[CONSTANTS, PLAYER]);
    let refused = level::read("l", &files).unwrap_err();
    let loaded = level::read_unfinished("l", &files).unwrap();
    assert_eq!(lines(&loaded.warnings), lines(&refused), "the warnings are the problems of a finished level");
    let mut game = Game::new(Arc::new(loaded.level)).unwrap();
    (0..240).for_each(|_| game.step(Controls { thrust: true, ..Controls::default() }));
    assert_eq!((game.outcome(), game.ticks()), (Outcome::Running, 240));
    for only in [CONSTANTS, PLAYER] {
        assert!(level::read_unfinished("l", &self::files(&[only])).is_err(), "{} alone", only.0);
    }
}

#[test]
fn what_cannot_be_read_or_placed_is_left_out_and_a_missing_picture_is_a_box() {
    let files = files(&[
        CONSTANTS,
        PLAYER,
        ("world.csv", "0,580,800,20\n100,wide,10,10\n"),
        ("objects.csv", "100,100,nowhere.png,50,1,FALSE,0\n200,100,box:40x40,50,1,FALSE,0\n300,595,box:40x40,50,1,FALSE,0\n"),
        ("switches.csv", "0,0,10,10,gate\n"),
        ("objectives.csv", "PHYS,10,10,20,20\n"),
    ]);
    let loaded = level::read_unfinished("l", &files).unwrap();
    let told = lines(&loaded.warnings);
    for place in ["world.csv:2", "objects.csv:1", "objects.csv:3", "switches.csv:1", "objectives.csv:1"] {
        assert!(told.contains(place), "{place}: {told}");
    }
    let level = loaded.level;
    assert_eq!((level.world.len(), level.objects.len(), level.switches.len(), level.objectives.len()), (1, 2, 1, 1));
    assert_eq!((&level.objects[0].look, level.objects[0].size.x), (&Look::Box, 40.0 / 30.0));
    assert!(Game::new(Arc::new(level)).is_ok());
}

#[test]
fn a_ship_without_a_place_cannot_be_flown() {
    let inside = files(&[CONSTANTS, PLAYER, ("world.csv", "300,200,200,200\n")]);
    let refused = lines(&level::read_unfinished("l", &inside).unwrap_err());
    assert!(refused.contains("player.csv:2: column") && refused.contains("the ship"), "{refused}");
}
