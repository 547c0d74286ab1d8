//! Pictures and tables that are too large.

use crate::check_and_new::project;
use crate::lines;
use resultant::level;

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
    // Each is small enough, and all of them are not.
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
    // The background is one of them.
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
