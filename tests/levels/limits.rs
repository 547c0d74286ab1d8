//! The limits that docs/levels.md states: each limit is accepted, a number beyond it is refused by file, line and column; and pictures and
//! tables that are too large.

use crate::check_and_new::project;
use crate::lines;
use crate::support::Memory;
use resultant::level;

/// A column, the least and the most that it may hold, and two numbers beyond them.
type Limit = (&'static str, [f64; 2], [f64; 2]);

/// A level of 3000 × 3000 px; each `column=usual` is a number that may be changed.
const FILES: [(&str, &str); 7] = [
    (
        "constants.csv",
        "name,value\nwidth,3000\nheight,3000\ngravity,gravity=15\nair_density,air_density=1.2041\noptimal_time,optimal_time=60\n\
         rest_speed,rest_speed=0\nmetre,metre=30\n",
    ),
    ("player.csv", "x,y,mass,fuel,thrust,vx,vy,angle\n1500,1500,mass=100,fuel=500,thrust=3000,vx=0,0,angle=0\n"),
    ("world.csv", "x,y,width,height\nx=600,2000,side=30,30\n"),
    ("objects.csv", "x,y,image,mass,drag,circular,restitution\n600,600,box:30x30,100,drag=1,FALSE,restitution=0.5\n"),
    ("objectives.csv", "PLAYER,10,10,20,20\n"),
    ("hazards.csv", "x,y,width,height,stream_width,stream_height,force_x,force_y\n900,900,30,30,0,-90,0,force_y=-900\n"),
    ("fluids.csv", "x,y,width,height,density,viscosity\n0,2500,3000,500,density=1000,viscosity=0.001\n"),
];

fn with(column: &str, value: f64) -> Memory {
    let cell = |cell: &str| match cell.split_once('=') {
        Some((name, rest)) if name == column => format!("{value}{}", rest.trim_start_matches(|c: char| !",\n".contains(c))),
        Some((_, usual)) => usual.to_owned(),
        None => cell.to_owned(),
    };
    let fill = |text: &str| text.split_inclusive([',', '\n']).map(cell).collect::<String>();
    let mut files = FILES.map(|(file, text)| (file, fill(text)));
    if AWARDS.contains(&column) {
        files[0].1 += &format!("{column},{value}\n");
    }
    Memory(files.into())
}

const AWARDS: [&str; 7] = ["silver", "gold", "mark_hits", "mark_fuel", "mark_pushes", "mark_speed", "mark_burns"];

const LIMITS: [Limit; 25] = [
    ("silver", [1e-3, 1e9], [0.0009, 1.01e9]),
    ("gold", [1e-3, 1e9], [0.0009, 1.01e9]),
    ("mark_hits", [0.0, 1e6], [-1.0, 1_000_001.0]),
    ("mark_fuel", [0.0, 100.0], [-0.1, 100.1]),
    ("mark_pushes", [0.0, 1e6], [-1.0, 1_000_001.0]),
    ("mark_speed", [1e-3, 1e4], [0.0009, 10_001.0]),
    ("mark_burns", [0.0, 1e6], [-1.0, 1_000_001.0]),
    ("gravity", [-1e3, 1e3], [-1001.0, 1001.0]),
    ("air_density", [0.0, 100.0], [-0.1, 100.1]),
    ("optimal_time", [1e-3, 1e9], [0.0009, 1.01e9]),
    ("rest_speed", [0.0, 1e4], [-0.1, 10_001.0]),
    ("metre", [1.0, 100.0], [0.0009, 1_000_001.0]),
    ("mass", [1e-3, 1e5], [0.0009, 100_001.0]),
    ("fuel", [0.0, 1e12], [-1.0, 1.1e12]),
    ("thrust", [0.0, 1e6], [-1.0, 1_000_001.0]),
    ("vx", [-1e4, 1e4], [-10_001.0, 10_001.0]),
    ("angle", [-1e6, 1e6], [-1_000_001.0, 1_000_001.0]),
    ("x", [-3e7, 3e7], [-3.1e7, 3.1e7]),
    ("side", [0.03, 3e7], [0.029, 3.1e7]),
    ("drag", [0.0, 1e3], [-0.1, 1001.0]),
    ("restitution", [0.0, 1.0], [-0.01, 1.01]),
    ("force_y", [-1e6, 1e6], [-1_000_001.0, 1_000_001.0]),
    ("density", [0.0, 2e4], [-0.1, 20_001.0]),
    ("viscosity", [0.0, 1e3], [-0.1, 1001.0]),
    ("mass", [1e-3, 1e5], [1e-300, 1e300]),
];

#[test]
fn numbers_up_to_their_limits_are_accepted_and_those_beyond_are_named() {
    for (column, accepted, refused) in LIMITS {
        // A thrust of 3000 N is too much for a gram, and a metre of a pixel leaves the ship too little room: that is not the limit meant.
        let named = |value: f64| match level::read("l", &with(column, value)) {
            Ok(_) => String::new(),
            Err(problems) => lines(&problems),
        };
        let (name, by) = match column {
            name if AWARDS.contains(&name) => ("value", format!(" for {column}, expected ")),
            "gravity" | "air_density" | "optimal_time" | "rest_speed" | "metre" => ("value", format!(" for {column}, expected ")),
            "side" => ("width", ", expected ".to_owned()),
            _ => (column, ", expected ".to_owned()),
        };
        let judged =
            |told: &str| told.lines().any(|line| line.contains(&format!("column \"{name}\": found \"")) && line.contains(&by));
        for value in accepted {
            assert!(!judged(&named(value)), "{column} = {value}: {}", named(value));
        }
        for value in refused {
            assert!(judged(&named(value)), "{column} = {value}: {:?}", named(value));
        }
    }
}

/// A PNG of a pixel that says that it has that size.
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
    let project = project(&["l"]);
    let folder = project.path().join("levels/l");
    let object = |bytes: &[u8]| {
        std::fs::write(project.path().join("a.png"), bytes).unwrap();
        std::fs::write(folder.join("objects.csv"), "600,300,a.png,50,1,FALSE,0\n").unwrap();
        level::load(&folder, project.path()).map(|_| ()).map_err(|problems| lines(&problems))
    };
    assert_eq!(object(&png_of(20, 20)), Ok(()));
    for (width, height) in [(30_000, 20_000), (16_385, 1), (4096, 4097), (u32::MAX >> 1, u32::MAX >> 1)] {
        let refused = object(&png_of(width, height)).unwrap_err();
        let found = format!("found \"a.png\" of {width} × {height} pixels, expected a PNG image of at most 8388608 pixels");
        assert!(refused.contains(&found), "{refused}");
    }
    let bomb = png_of(23_170, 23_170);
    std::fs::write(folder.join("background.png"), &bomb).unwrap();
    assert!(object(&png_of(20, 20)).unwrap_err().starts_with("background.png: found \"background.png\" of 23170"));
    assert!(level::read_picture(&folder.join("background.png")).is_err(), "nor is it unpacked to be drawn");
    std::fs::remove_file(folder.join("background.png")).unwrap();
    let each = png_of(16_384, 512);
    let rows = (0..2).map(|i| {
        std::fs::write(project.path().join(format!("{i}.png")), &each).unwrap();
        format!("600,300,{i}.png,50,1,FALSE,0\n")
    });
    std::fs::write(folder.join("objects.csv"), rows.collect::<String>()).unwrap();
    std::fs::write(folder.join("constants.csv"), "width,30000\nheight,30000\n").unwrap();
    let refused = lines(&level::load(&folder, project.path()).unwrap_err());
    let told = "objects.csv:2: column \"image\": found \"1.png\", with which the level's pictures have 16777216 pixels";
    assert!(refused.contains(told), "{refused}");
    std::fs::write(folder.join("background.png"), png_of(16_384, 512)).unwrap();
    std::fs::write(folder.join("constants.csv"), "").unwrap();
    let refused = lines(&level::load(&folder, project.path()).unwrap_err());
    let told = "objects.csv:1: column \"image\": found \"0.png\", with which the level's pictures have 16777216";
    assert!(refused.contains(told), "{refused}");
}

#[test]
fn a_table_or_a_picture_that_is_too_large_is_not_read() {
    let project = project(&["l"]);
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
