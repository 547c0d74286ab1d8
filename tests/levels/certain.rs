//! `check` on levels that no flight can win as they are written, and on the same levels with the mistake mended: what is certain draws a
//! warning, and what can be won draws none.

use crate::lines;
use crate::support::Memory;
use resultant::level;

/// 1280 × 720 px with a floor, a ship at the left and the only goal at the right, unless the files say otherwise.
fn warned(files: &[(&'static str, &str)]) -> String {
    let room = [
        ("constants.csv", "width,1280\nheight,720\n"),
        ("player.csv", "150,600,100,500,2500\n"),
        ("world.csv", "0,680,1280,40\n"),
        ("objectives.csv", "PLAYER,1000,670,100,10\n"),
    ];
    let own = room.into_iter().filter(|(file, _)| files.iter().all(|(other, _)| other != file));
    let all = own.chain(files.iter().copied()).map(|(file, text)| (file, text.to_owned()));
    match level::read("room", &Memory(all.collect())) {
        Ok(loaded) => lines(&loaded.warnings),
        Err(problems) => panic!("refused: {}", lines(&problems)),
    }
}

fn told(files: &[(&'static str, &str)], place: &str, found: &str) {
    let warnings = warned(files);
    assert!(warnings.starts_with(&format!("{place}: found {found}")) && warnings.lines().count() == 1, "{files:?}: {warnings}");
}

fn silent(files: &[(&'static str, &str)]) {
    assert_eq!(warned(files), "", "{files:?}");
}

fn key(mass: &str, x: &str) -> String {
    format!("PHYS,1000,670,100,10\nOBJECT,{x},660,box:40x40,{mass},181,49,201,0,1\n")
}

#[test]
fn a_room_without_a_mistake_draws_no_alarm() {
    silent(&[]);
    silent(&[("objectives.csv", &key("50", "460"))]);
}

#[test]
fn a_key_too_heavy_for_all_that_could_push_it() {
    let place = "objectives.csv:2: column \"mass\"";
    let found = "100000 kg, which nothing in the level brings to the objective of line 1";
    told(&[("objectives.csv", &key("100000", "460"))], place, found);
    for mass in ["50", "120", "400"] {
        silent(&[("objectives.csv", &key(mass, "460"))]);
    }
    silent(&[("objectives.csv", &key("100000", "978"))]);
    // On ice, by a mover, by a wind or down a hole it may get there.
    for (file, text) in [
        ("constants.csv", "width,1280\nheight,720\nfriction,0\n"),
        ("movers.csv", "200,560,20,120,900 560,2\n"),
        ("hazards.csv", "0,640,10,40,900,0,90000,0\n"),
    ] {
        silent(&[("objectives.csv", &key("100000", "460")), (file, text)]);
    }
    let light = key("100000", "460") + "OBJECT,600,660,box:40x40,50,181,49,201,0,1\n";
    silent(&[("objectives.csv", &light)]);
}

#[test]
fn a_one_way_block_that_stops_what_comes_from_the_start() {
    let wall = |rest: &str| format!("0,680,1280,40,Asphalt,\n900,{rest}\n");
    let place = "objectives.csv:1: column \"x\"";
    let found = "an objective behind a one-way block or a wind that lets nothing through";
    told(&[("world.csv", &wall("0,20,680,Steel,left"))], place, found);
    for open in ["0,20,680,Steel,right", "0,20,680,Steel,top", "60,20,620,Steel,left", "0,20,680,Steel,left,,500"] {
        silent(&[("world.csv", &wall(open))]);
    }
    // From above into the room behind it, and a key that starts there.
    silent(&[("world.csv", "0,680,1280,40,Asphalt,\n900,100,20,580,Steel,left\n920,100,360,15,Steel,top\n")]);
    let shut = "0,680,1280,40,Asphalt,\n900,100,20,580,Steel,left\n920,100,360,15,Steel,bottom\n900,0,20,100,Steel,left\n";
    told(&[("world.csv", shut)], place, found);
    told(&[("world.csv", &wall("0,20,680,Steel,left")), ("objectives.csv", &key("50", "460"))], place, found);
    silent(&[("world.csv", &wall("0,20,680,Steel,left")), ("objectives.csv", &key("50", "960"))]);
}

#[test]
fn a_wind_or_field_that_outdoes_the_ship() {
    let place = "objectives.csv:1: column \"x\"";
    let found = "an objective behind a one-way block or a wind that lets nothing through";
    told(&[("hazards.csv", "1270,0,10,680,-400,0,-100000,0\n")], place, found);
    told(&[("gravity.csv", "800,0,100,680,-1000,0\n")], place, found);
    for (file, text) in [
        ("hazards.csv", "1270,0,10,680,-400,0,-3000,0\n"),
        ("hazards.csv", "1270,300,10,380,-400,0,-100000,0\n"),
        ("hazards.csv", "1270,0,10,680,-400,0,100000,0\n"),
        ("gravity.csv", "800,0,10,680,-1000,0\n"),
        ("gravity.csv", "800,0,100,680,-20,0\n"),
        ("gravity.csv", "800,0,100,680,1000,0\n"),
        ("gravity.csv", "800,0,100,680,-1000,0\n700,0,200,680,990,0\n"),
    ] {
        silent(&[(file, text)]);
    }
    let wind = ("hazards.csv", "1270,0,10,680,-400,0,-100000,0,FALSE,fan\n");
    silent(&[wind, ("switches.csv", "300,600,60,60,!fan,,ship,latched\n")]);
    silent(&[("hazards.csv", "1270,0,10,680,-400,0,-100000,0\n"), ("movers.csv", "200,300,90,20,1000 300,2\n")]);
}

#[test]
fn a_body_tied_down_too_short() {
    let rope = |length: &str, rest: &str| format!("rope,ship,150 600,{length},100000,500{rest}\n");
    let found = "a link too short for the objective of line 1, for which nothing can stretch it";
    told(&[("links.csv", &rope("200", ""))], "links.csv:1: column \"length\"", found);
    silent(&[("links.csv", &rope("900", ""))]);
    silent(&[("links.csv", &rope("200", ",,,3000"))]);
    silent(&[("links.csv", "rope,ship,150 600,200,50,5\n")]);
    silent(&[("links.csv", &rope("200", ",,,,,tie")), ("switches.csv", "100,500,60,60,!tie,,ship,latched\n")]);
    silent(&[("links.csv", &rope("200", ",,touch"))]);
    let crate_ = ("objects.csv", "300,660,box:40x40,60,1,FALSE,0\n");
    silent(&[("links.csv", &rope("200", "")), crate_]);
}

#[test]
fn a_door_that_closes_before_the_ship_gets_there() {
    let walls = ("world.csv", "0,680,1280,40\n900,0,20,400\n");
    let gate = |name: &'static str| [walls, ("doors.csv", name)];
    let one = gate("900,400,20,280,gate\n");
    let held = |row: &'static str| [&one[..], &[("switches.csv", row)]].concat();
    let place = "objectives.csv:1: column \"x\"";
    told(&held("100,100,100,100,gate,,ship,held\n"), place, "an objective behind a door that closes before the ship gets there");
    told(&held("100,670,100,10,gate,500\n"), place, "an objective behind a door that closes before the ship gets there");
    for row in [
        "100,100,100,100,gate,,ship,latched\n",
        "100,100,100,100,gate,,ship,toggled\n",
        "100,100,100,100,!gate,,ship,held\n",
        "840,420,40,100,gate,,ship,held\n",
    ] {
        silent(&held(row));
    }
    let crate_ = ("objects.csv", "300,660,box:40x40,60,1,FALSE,0\n");
    silent(&[&held("100,670,100,10,gate,500\n")[..], &[crate_]].concat());
    // One that lies on the door, or is pushed against it, may keep it open.
    silent(&[&held("100,100,100,100,gate,,ship,held\n")[..], &[("objects.csv", "880,660,box:10x40,60,1,FALSE,0\n")]].concat());
    let both = gate("900,400,20,280,a&b\n");
    let apart = ("switches.csv", "100,100,100,100,a,,ship,held\n600,100,100,100,b,,ship,held\n");
    told(&[&both[..], &[apart]].concat(), place, "an objective behind a door that closes before the ship gets there");
    silent(&[&both[..], &[("switches.csv", "800,500,60,60,a,,ship,held\n840,500,60,60,b,,ship,held\n")]].concat());
    silent(&[&both[..], &[("switches.csv", "100,100,100,100,a,,ship,latched\n840,500,60,60,b,,ship,held\n")]].concat());
    let hall = [walls, ("doors.csv", "900,400,20,280,gate\n1200,0,20,680,hall\n"), ("objectives.csv", "PLAYER,1240,670,20,10\n")];
    let two = warned(&[&hall[..], &[("switches.csv", "100,100,100,100,gate,,ship\n1000,600,60,60,hall,,ship,latched\n")]].concat());
    assert!(two.starts_with("switches.csv:2: column \"x\": found a switch behind a door that closes before"), "{two}");
    assert_eq!(two.lines().count(), 2, "{two}");
    let key = "PHYS,1000,670,100,10\nOBJECT,860,660,box:40x40,50,181,49,201,0,1\n";
    silent(&[&held("100,100,100,100,gate,,ship,held\n")[..], &[("objectives.csv", key)]].concat());
}

#[test]
fn a_block_that_no_blow_breaks() {
    let wall = |breaks: &str| format!("0,680,1280,40,Asphalt,,\n900,0,20,680,Glass,,,{breaks}\n").replace(",,,", ",,0,");
    let place = "world.csv:2: column \"breaks\"";
    for breaks in ["1000000000", "20000"] {
        told(&[("world.csv", &wall(breaks))], place, &format!("{breaks} N·s, with blows of at most "));
    }
    silent(&[("world.csv", &wall("2000"))]);
    // Objects give blows, too, and a trampoline throws.
    silent(&[("world.csv", &wall("20000")), ("objects.csv", "400,650,box:40x40,900,1,FALSE,0\n")]);
    silent(&[("world.csv", &(wall("20000") + "500,600,40,10,Trampoline\n"))]);
}

#[test]
fn rows_without_use_and_speeds_like_pixels() {
    let pods = "pods.csv:1: column \"x\"";
    told(&[("pods.csv", "500,690,20,20,50\n")], pods, "a pod that the ship cannot get to");
    silent(&[("pods.csv", "500,670,20,20,50\n")]);
    let (place, found) = ("objectives.csv:1: column \"hold\"", "a hold of 61 s, longer than the optimal time of 60 s");
    told(&[("objectives.csv", "PLAYER,1000,670,100,10,61\n")], place, found);
    silent(&[("objectives.csv", "PLAYER,1000,670,100,10,60\n")]);
    let keyed = "PLAYER,1000,670,100,10\nOBJECT,460,660,box:40x40,50,181,49,201,0,1\n";
    told(&[("objectives.csv", keyed)], "objectives.csv:2: column \"kind\"", "a key object that no objective takes");
    let plate = [("doors.csv", "500,0,20,100,gate\n"), ("switches.csv", "600,600,60,80,gate,,key\n")];
    silent(&[&plate[..], &[("objectives.csv", keyed)]].concat());
    silent(&[("objectives.csv", keyed), ("stars.csv", "600,600,20,20,key\n")]);
    let blue = format!("{keyed}PHYS,300,670,100,10,,,1,2,3\nOBJECT,360,660,box:40x40,50,1,2,3,0,1\n");
    told(&[("objectives.csv", &blue)], "objectives.csv:2: column \"kind\"", "a key object that no objective takes");
    let mover = |speed: &str| format!("400,300,100,20,500 300,{speed}\n");
    told(&[("movers.csv", &mover("100"))], "movers.csv:1: column \"speed\"", "100 m/s, which is 3000 pixels a second");
    for slow in ["20", "60", ",0.1"] {
        silent(&[("movers.csv", &mover(slow))]);
    }
    let (place, found) = ("objects.csv:1: column \"vx\"", "150 m/s, which is 4500 pixels");
    told(&[("objects.csv", "400,650,box:40x40,9,1,FALSE,0,150,0\n")], place, found);
    silent(&[("objects.csv", "400,650,box:40x40,9,1,FALSE,0,-60,0\n")]);
}
