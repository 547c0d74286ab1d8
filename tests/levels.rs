//! Level folders: what loads, into what, and what is refused with which words.
//!
//! `tests/fixtures` is a project folder of its own. Each folder in its `levels/` is one case: with a `problems.txt` it is refused
//! with exactly these lines, otherwise it loads, with exactly the lines of `warnings.txt` as its warnings (none without that file).

use proptest::prelude::*;
use proptest::test_runner::FileFailurePersistence;
use resultant::level::{self, Files, Level, Look, ObjectiveKind, Problem};
use resultant::physics::{Aabb, BodyId, DVec2, Material, World};
use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn package() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn fixtures() -> PathBuf {
    package().join("tests/fixtures")
}

fn lines(problems: &[Problem]) -> String {
    problems.iter().map(|problem| format!("{problem}\n")).collect()
}

/// A fixture that must load.
fn good(name: &str) -> Level {
    match level::load(&fixtures().join("levels").join(name), &fixtures()) {
        Ok(loaded) => loaded.level,
        Err(problems) => panic!("{name} is refused:\n{}", lines(&problems)),
    }
}

fn rectangle(x: f64, y: f64, width: f64, height: f64) -> Aabb {
    Aabb::new(DVec2::new(x, y) / 30.0, DVec2::new(x + width, y + height) / 30.0)
}

#[test]
fn every_fixture_is_refused_or_loads_with_exactly_its_words() {
    let mut wrong = String::new();
    let names = level::list(&fixtures().join("levels"));
    for name in &names {
        let folder = fixtures().join("levels").join(name);
        let golden = |file: &str| std::fs::read_to_string(folder.join(file)).ok();
        let (expected, found) = match (golden("problems.txt"), level::load(&folder, &fixtures())) {
            (Some(problems), Err(found)) => (problems, lines(&found)),
            (None, Ok(loaded)) => (golden("warnings.txt").unwrap_or_default(), lines(&loaded.warnings)),
            (Some(problems), Ok(_)) => (problems, "it loads\n".into()),
            (None, Err(found)) => ("it loads\n".into(), lines(&found)),
        };
        if expected != found {
            wrong += &format!("{name}, expected:\n{expected}{name}, found:\n{found}\n");
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
    assert!(names.len() > 60, "the fixtures are missing: {names:?}");
}

#[test]
fn every_shipped_level_loads_without_a_warning_and_builds_a_world() {
    let levels = package().join("levels");
    for name in level::list(&levels) {
        match level::load(&levels.join(&name), package()) {
            Ok(loaded) => {
                assert_eq!(lines(&loaded.warnings), "", "{name}");
                assert!(World::new(loaded.level.world_def()).is_ok(), "{name}");
            }
            Err(problems) => panic!("{name} is refused:\n{}", lines(&problems)),
        }
    }
}

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
fn what_a_spreadsheet_saves_loads() {
    let level = good("good_spreadsheet");
    assert_eq!((level.player.mass, level.player.thrust, level.player.feels_air), (100.0, 3000.0, true));
    assert_eq!(level.objects[0].look, Look::Image(fixtures().join("assets/sprites/ball.png")));
    assert_eq!(level.texts[0].text, "Space, then arrows");
    assert_eq!((level.title.as_str(), level.metre), ("good_spreadsheet", 30.0));
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
    assert_eq!((def.streams[1].zone, def.streams[1].force), (level.streams[1].zone, DVec2::new(-10.0, 0.0)));
    assert_eq!(def.bodies.iter().map(|body| body.round).collect::<Vec<_>>(), [false, true, false]);
    assert_eq!(World::new(def).map(|world| world.bodies().len()), Ok(3));
    let bodies = good("good_any_order").world_def().bodies;
    let materials: Vec<_> = bodies.iter().map(|body| body.material).collect();
    assert_eq!(materials, [Material::RUBBER, Material::WOOD, Material::ASPHALT, Material::STEEL]);
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
    assert!(
        problems.contains("background.png:1: column \"image\": found \"background.png\", which cannot be read ("),
        "{problems}"
    );
    assert!(!problems.contains("exactly one row"), "one cause, one problem:\n{problems}");
}

#[test]
fn levels_are_listed_numbers_first() {
    let levels = tempfile::tempdir().unwrap();
    for name in ["10", "2", "tower", "1", "attic", ".hidden"] {
        std::fs::create_dir(levels.path().join(name)).unwrap();
    }
    std::fs::write(levels.path().join("README.md"), "no level").unwrap();
    assert_eq!(level::list(levels.path()), ["1", "2", "10", "attic", "tower"]);
    assert!(level::list(&levels.path().join("none")).is_empty());
}

// The command line.

fn resultant(data: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_resultant")).args(arguments).arg("--data").arg(data).output().unwrap()
}

fn texts(output: &Output) -> (i32, String, String) {
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).unwrap();
    (output.status.code().unwrap(), text(&output.stdout), text(&output.stderr))
}

#[test]
fn check_prints_what_a_good_level_holds() {
    let (code, out, err) = texts(&resultant(&fixtures(), &["check", "good_original"]));
    let lines: Vec<&str> = out.lines().collect();
    assert_eq!((code, err.as_str(), lines.len()), (0, "", 3), "{out}");
    assert_eq!(lines[0], "good_original: ok");
    let counts =
        "1 solid, 1 object, 1 key object, 0 player objectives, 1 physics objective, 1 death box, 2 air streams, 0 liquids, 0 texts";
    assert_eq!(lines[1], format!("  contents: {counts}"));
    let plan = World::new(good("good_original").world_def()).unwrap().plan().parts().join("; ");
    assert_eq!(lines[2], format!("  physics: {plan}"));
}

#[test]
fn check_prints_problems_and_warnings_on_standard_error() {
    let (code, out, err) = texts(&resultant(&fixtures(), &["check", "fuel_thrust_negative", "warn_unknown_constant"]));
    assert_eq!(code, 1);
    assert!(out.starts_with("warn_unknown_constant: ok\n"), "{out}");
    let err: Vec<&str> = err.lines().collect();
    assert_eq!(err[0], "fuel_thrust_negative: refused, 2 problems");
    assert_eq!(err[1], r#"player.csv:2: column "fuel": found "-1", expected a number of 0 or more fuel units"#);
    assert!(err[3].starts_with(r#"warn_unknown_constant: warning: constants.csv:4: column "name": "#), "{err:?}");
    assert_eq!(texts(&resultant(&fixtures(), &["check", "warn_unknown_constant"])).0, 0);
}

#[test]
fn check_takes_folders_and_all_levels_and_refuses_what_is_not_there() {
    let folder = fixtures().join("levels/good_touching");
    let (code, out, _) = texts(&resultant(&fixtures(), &["check", folder.to_str().unwrap()]));
    assert_eq!((code, out.lines().next()), (0, Some(format!("{}: ok", folder.display()).as_str())));

    let (code, out, err) = texts(&resultant(&fixtures(), &["check"]));
    assert_eq!(code, 1);
    assert!(out.contains("good_original: ok\n") && err.contains("player_none: refused, 1 problem\n"));

    let (code, out, err) = texts(&resultant(&fixtures(), &["check", "good_original", "nowhere"]));
    assert_eq!((code, out.as_str()), (2, ""), "nothing is checked: {err}");
    assert!(err.contains("nowhere"), "{err}");
    assert_eq!(texts(&resultant(tempfile::tempdir().unwrap().path(), &["check"])).0, 2);
}

#[test]
fn new_makes_a_level_that_loads_and_touches_no_other() {
    let project = tempfile::tempdir().unwrap();
    let folder = project.path().join("levels").join("my-level");
    let (code, out, err) = texts(&resultant(project.path(), &["new", "my-level"]));
    assert_eq!((code, out, err.as_str()), (0, format!("{}\n", folder.display()), ""));
    let loaded = level::load(&folder, project.path()).unwrap();
    assert_eq!((loaded.level.title.as_str(), lines(&loaded.warnings)), ("my-level", String::new()));

    std::fs::write(folder.join("player.csv"), "mine").unwrap();
    assert_eq!(texts(&resultant(project.path(), &["new", "my-level"])).0, 2);
    assert_eq!(std::fs::read_to_string(folder.join("player.csv")).unwrap(), "mine");
    for name in ["../evil", "a/b", "", "."] {
        let (code, out, err) = texts(&resultant(project.path(), &["new", name]));
        assert_eq!((code, out.as_str()), (2, ""), "{name:?}: {err}");
    }
    assert_eq!(level::list(&project.path().join("levels")), ["my-level"]);
}

#[test]
fn new_refuses_names_that_are_taken_by_something_else() {
    let project = tempfile::tempdir().unwrap();
    for (names, why) in [
        (&["jumper", "Jumper"][..], "the leaderboard of that name is that of the Jumper"),
        (&["CON", "aux", "NUL", "COM1", "lpt9", "Prn"], "Windows takes that one for a device"),
    ] {
        for name in names {
            let (code, out, err) = texts(&resultant(project.path(), &["new", name]));
            assert_eq!((code, out.as_str()), (2, ""), "{name}");
            assert_eq!(err, format!("a level cannot be named {name:?}: expected another name, as {why}\n"));
        }
    }
    assert!(!project.path().join("levels").exists());
}

#[test]
fn new_makes_a_folder_whole_or_not_at_all() {
    let project = tempfile::tempdir().unwrap();
    let levels = project.path().join("levels");
    std::fs::create_dir(&levels).unwrap();
    // Whatever has the name already stays, an empty folder too.
    std::fs::create_dir(levels.join("empty")).unwrap();
    std::fs::write(levels.join("file"), "kept").unwrap();
    for name in ["empty", "file"] {
        let (code, _, err) = texts(&resultant(project.path(), &["new", name]));
        assert_eq!(code, 2, "{name}");
        assert!(err.contains("cannot make "), "{err}");
    }
    assert_eq!(std::fs::read_dir(levels.join("empty")).unwrap().count(), 0);
    let mut names: Vec<_> = std::fs::read_dir(&levels).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    names.sort();
    assert_eq!(names, ["empty", "file"], "nothing is left of what was begun");
    // What a kill in the middle leaves is hidden and is no level.
    std::fs::create_dir(levels.join(".new-Ab3dE")).unwrap();
    assert_eq!(level::list(&levels), ["empty"]);
    assert_eq!(texts(&resultant(project.path(), &["new", "whole"])).0, 0);
    assert_eq!(std::fs::read_dir(levels.join("whole")).unwrap().count(), 9);
}

/// While `new` makes one folder after the other, none is ever seen that is not whole.
#[test]
fn no_half_folder_is_ever_seen() {
    let project = tempfile::tempdir().unwrap();
    let root = project.path().to_owned();
    let maker = std::thread::spawn(move || (0..20).all(|i| texts(&resultant(&root, &["new", &format!("l{i}")])).0 == 0));
    while !maker.is_finished() {
        for name in level::list(&project.path().join("levels")) {
            let files = std::fs::read_dir(project.path().join("levels").join(&name)).unwrap().count();
            assert_eq!(files, 9, "{name}");
        }
    }
    assert!(maker.join().unwrap());
}

#[test]
fn a_folder_with_the_name_of_another_leaderboard_is_refused_and_a_device_warned_about() {
    let project = tempfile::tempdir().unwrap();
    for name in ["one", "two"] {
        assert_eq!(texts(&resultant(project.path(), &["new", name])).0, 0);
    }
    let levels = project.path().join("levels");
    std::fs::rename(levels.join("one"), levels.join("Jumper")).unwrap();
    std::fs::rename(levels.join("two"), levels.join("aux")).unwrap();
    let (code, out, err) = texts(&resultant(project.path(), &["check"]));
    assert_eq!(code, 1);
    assert!(out.starts_with("aux: ok\n"), "{out}");
    let jumper = "folder:1: column \"name\": found a level folder named \"Jumper\", expected another name, as the leaderboard of that \
                  name is that of the Jumper\n";
    assert!(err.contains(&format!("Jumper: refused, 1 problem\n{jumper}")), "{err}");
    let aux = "aux: warning: folder:1: column \"name\": found a level folder named \"aux\", expected another name, as Windows takes \
               that one for a device\n";
    assert!(err.contains(aux), "{err}");
    let (code, out, err) = texts(&resultant(project.path(), &["run", "Jumper"]));
    assert_eq!((code, out.as_str(), err.as_str()), (2, "", jumper));
}

#[cfg(unix)]
#[test]
fn check_leaves_the_terminal_as_it_is() {
    let project = tempfile::tempdir().unwrap();
    assert_eq!(texts(&resultant(project.path(), &["new", "good"])).0, 0);
    let levels = project.path().join("levels");
    std::fs::rename(levels.join("good"), levels.join("\u{1b}[2Jgood\n1: ok\r\u{9b}31m")).unwrap();
    std::fs::create_dir(levels.join("\u{1b}]0;bad\u{7}")).unwrap();
    let (code, out, err) = texts(&resultant(project.path(), &["check"]));
    assert_eq!(code, 1);
    assert!(out.starts_with("\\u{1b}[2Jgood\\n1: ok\\r\\u{9b}31m: ok\n"), "{out}");
    assert!(err.contains("\\u{1b}]0;bad\\u{7}: refused, "), "{err}");
    let (_, _, lost) = texts(&resultant(project.path(), &["check", "\u{1b}[2Jlost"]));
    for text in [out, err, lost] {
        assert!(!text.chars().any(|c| c.is_control() && c != '\n'), "{text:?}");
    }
}

// Sizes.

/// A PNG of that size by its head, in a few bytes.
fn png_of(width: u32, height: u32) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, 1, 1);
    encoder.set_color(png::ColorType::Grayscale);
    encoder.write_header().unwrap().write_image_data(&[0]).unwrap();
    // Behind the signature: length, "IHDR", width, height, five bytes, checksum.
    bytes[16..20].copy_from_slice(&width.to_be_bytes());
    bytes[20..24].copy_from_slice(&height.to_be_bytes());
    let sum = bytes[12..29]
        .iter()
        .fold(u32::MAX, |sum, byte| (0..8).fold(sum ^ u32::from(*byte), |sum, _| (sum >> 1) ^ (0xedb8_8320 * (sum & 1))));
    bytes[29..33].copy_from_slice(&(!sum).to_be_bytes());
    bytes
}

#[test]
fn a_picture_is_judged_by_what_it_unfolds_to() {
    let project = tempfile::tempdir().unwrap();
    assert_eq!(texts(&resultant(project.path(), &["new", "l"])).0, 0);
    let folder = project.path().join("levels/l");
    let object = |bytes: &[u8]| {
        std::fs::write(project.path().join("a.png"), bytes).unwrap();
        std::fs::write(folder.join("objects.csv"), "600,300,a.png,50,1,FALSE,0\n").unwrap();
        level::load(&folder, project.path()).map(|_| ()).map_err(|problems| lines(&problems))
    };
    assert_eq!(object(&png_of(20, 20)), Ok(()));
    for (width, height) in [(30_000, 20_000), (16_385, 1), (8192, 4097), (u32::MAX >> 1, u32::MAX >> 1)] {
        let refused = object(&png_of(width, height)).unwrap_err();
        let found = format!("found \"a.png\" of {width} × {height} pixels, expected a PNG image of at most 33554432 pixels");
        assert!(refused.contains(&found), "{refused}");
    }
    let bomb = png_of(23_170, 23_170);
    std::fs::write(folder.join("background.png"), &bomb).unwrap();
    assert!(
        object(&png_of(20, 20)).unwrap_err().starts_with("background.png:1: column \"image\": found \"background.png\" of 23170")
    );
    assert!(level::read_picture(&folder.join("background.png")).is_err(), "nor is it unpacked to be drawn");
    std::fs::remove_file(folder.join("background.png")).unwrap();

    // Each is small enough, and all of them are not.
    let each = png_of(16_384, 2048);
    let rows = (0..5).map(|i| {
        std::fs::write(project.path().join(format!("{i}.png")), &each).unwrap();
        format!("600,300,{i}.png,50,1,FALSE,0\n")
    });
    std::fs::write(folder.join("objects.csv"), rows.collect::<String>()).unwrap();
    std::fs::write(folder.join("constants.csv"), "width,30000\nheight,30000\n").unwrap();
    let refused = lines(&level::load(&folder, project.path()).unwrap_err());
    assert!(
        refused.contains("objects.csv:5: column \"image\": found \"4.png\", with which the level's pictures have 167772160 pixels")
    );
}

#[test]
fn a_table_or_a_picture_that_is_too_large_is_not_read() {
    let project = tempfile::tempdir().unwrap();
    assert_eq!(texts(&resultant(project.path(), &["new", "l"])).0, 0);
    let folder = project.path().join("levels/l");
    std::fs::File::create(folder.join("world.csv")).unwrap().set_len(2 << 30).unwrap();
    std::fs::File::create(folder.join("background.png")).unwrap().set_len(2 << 30).unwrap();
    let refused = lines(&level::load(&folder, project.path()).unwrap_err());
    for told in [
        "world.csv:1: column \"x\": found a file that cannot be read (found 2147483648 bytes, expected at most 262144 bytes)",
        "at most 16777216 bytes",
    ] {
        assert!(refused.contains(told), "{refused}");
    }
}

// Whatever is in the files.

/// A level's files in memory; every image is the ball.
struct Memory {
    files: BTreeMap<String, Vec<u8>>,
    ball: Vec<u8>,
}

impl Files for Memory {
    fn level_file(&self, name: &str) -> io::Result<Vec<u8>> {
        self.files.get(name).cloned().ok_or_else(|| io::ErrorKind::NotFound.into())
    }

    fn project_file(&self, _path: &str) -> io::Result<Vec<u8>> {
        Ok(self.ball.clone())
    }
}

const FILES: [&str; 10] = [
    "constants.csv",
    "player.csv",
    "world.csv",
    "objects.csv",
    "objectives.csv",
    "obstacles.csv",
    "hazards.csv",
    "fluids.csv",
    "texts.csv",
    "background.png",
];

/// Good levels to spoil.
const BASES: [&str; 3] = ["good_original", "good_any_order", "good_spreadsheet"];

/// What is written over a cell: numbers at and beyond every limit, words, separators, line ends, broken quotes.
const SPOILS: [&str; 40] = [
    "",
    "0",
    "-0",
    "1",
    "-1",
    "1e-9",
    "1e-320",
    "1e6",
    "-1e6",
    "1e12",
    "3e7",
    "-3e7",
    "1e300",
    "1e999",
    "nan",
    "inf",
    "255",
    "0.5",
    "\"1,5\"",
    "TRUE",
    "false",
    "Ice",
    "x",
    "mass",
    "box:1x1",
    "ball:1e7x0.003",
    "../a",
    "a.png",
    "OBJECT",
    "PHYS",
    "#",
    "\"",
    "\n",
    "\r\n",
    ",",
    ";",
    "\u{feff}",
    "\0",
    "gravity",
    "metre",
];

/// The files of a good level with some cells replaced.
fn spoilt() -> impl Strategy<Value = BTreeMap<String, Vec<u8>>> {
    let change = (0..FILES.len() - 1, any::<prop::sample::Index>(), prop::sample::select(&SPOILS[..]));
    (0..BASES.len(), prop::collection::vec(change, 0..4)).prop_map(|(base, changes)| {
        let folder = fixtures().join("levels").join(BASES[base]);
        let read = |name: &str| Some((name.to_owned(), std::fs::read(folder.join(name)).ok()?));
        let mut files: BTreeMap<_, _> = FILES.into_iter().filter_map(read).collect();
        for (file, cell, spoil) in changes {
            let Some(bytes) = files.get_mut(FILES[file]) else { continue };
            let text = String::from_utf8_lossy(bytes).into_owned();
            let mut cells: Vec<&str> = text.split_inclusive([',', '\n']).collect();
            let i = cell.index(cells.len());
            let end = if cells[i].ends_with('\n') { "\n" } else { "," };
            let new = format!("{spoil}{end}");
            cells[i] = &new;
            *bytes = cells.concat().into_bytes();
        }
        files
    })
}

/// Any bytes in any file.
fn arbitrary() -> impl Strategy<Value = BTreeMap<String, Vec<u8>>> {
    let text = prop::collection::vec(prop::sample::select(&SPOILS[..]), 0..40).prop_map(|cells| cells.join(",").into_bytes());
    let bytes = prop_oneof![prop::collection::vec(any::<u8>(), 0..80), text, any::<String>().prop_map(String::into_bytes)];
    prop::collection::btree_map(prop::sample::select(&FILES[..]).prop_map(str::to_owned), bytes, 0..FILES.len())
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: Some(Box::new(FileFailurePersistence::WithSource("proptest-regressions"))), ..ProptestConfig::with_cases(2000) })]

    /// The loader never panics; what it refuses has at least one problem, each on one line that names its place; and what it
    /// accepts builds a world in which nothing becomes infinite or NaN.
    #[test]
    fn any_text_is_refused_in_words_or_becomes_a_finite_world(files in prop_oneof![3 => spoilt(), 1 => arbitrary()]) {
        let ball = std::fs::read(fixtures().join("assets/sprites/ball.png")).unwrap();
        match level::read("any", &Memory { files, ball }) {
            Err(problems) => {
                prop_assert!(!problems.is_empty());
                for problem in problems {
                    let text = problem.to_string();
                    let place = format!("{}:{}: column \"", problem.file, problem.line);
                    prop_assert!(problem.line > 0 && text.starts_with(&place), "{text}");
                    prop_assert!(!text.contains(['\n', '\r']), "{text}");
                }
            }
            Ok(loaded) => {
                let mut world = World::new(loaded.level.world_def()).unwrap();
                for _ in 0..20 {
                    world.step(1.0 / 120.0);
                }
                for (i, body) in world.bodies().iter().enumerate() {
                    let resultant = world.forces(BodyId(i as u32)).resultant();
                    let finite = [body.position, body.velocity, body.acceleration, resultant].iter().all(|v| v.is_finite());
                    prop_assert!(finite, "{body:?} {resultant:?}");
                }
            }
        }
    }
}
