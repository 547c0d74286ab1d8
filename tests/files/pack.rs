//! A level as one file: a pack comes back whole, and nothing that is made to do harm leaves a trace.

use crate::support::shipped::{fixtures, levels as shipped_levels, project as root};
use resultant::game::level_hash;
use resultant::level::{self, Level};
use resultant::pack::{self, Installed, Package};
use std::collections::BTreeMap;
use std::fs;
use std::io::{Cursor, Write};
use std::path::{Path, PathBuf};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

fn load(levels: &Path, name: &str, project: &Path) -> Level {
    level::load(&levels.join(name), project).unwrap().level
}

/// The least that makes a level.
const LEVEL: [(&str, &str); 3] = [
    ("t/player.csv", "x,y,mass,fuel,thrust\n400,300,100,500,3000\n"),
    ("t/objectives.csv", "PLAYER,10,10,20,20\n"),
    ("t/constants.csv", "width,800\nheight,600\n"),
];

fn archive(entries: &[(&str, &[u8])]) -> Vec<u8> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, bytes) in entries {
        zip.start_file(*name, SimpleFileOptions::default().compression_method(CompressionMethod::Deflated)).unwrap();
        zip.write_all(bytes).unwrap();
    }
    zip.finish().unwrap().into_inner()
}

fn with(entries: &[(&str, &[u8])]) -> Vec<u8> {
    let level = LEVEL.iter().map(|(name, text)| (*name, text.as_bytes()));
    archive(&level.chain(entries.iter().copied()).collect::<Vec<_>>())
}

#[track_caller]
fn says(bytes: &[u8], words: &str) {
    let told = pack::read(bytes, "t").unwrap_err();
    assert!(told.contains(words), "{told:?} does not say {words:?}");
}

/// The bytes with each place where `old` stands written over by `new`.
fn patched(mut bytes: Vec<u8>, old: &[u8], new: &[u8]) -> Vec<u8> {
    let places: Vec<usize> = (0..bytes.len() - old.len()).filter(|&at| bytes[at..].starts_with(old)).collect();
    assert!(!places.is_empty());
    places.iter().for_each(|&at| bytes[at..at + new.len()].copy_from_slice(new));
    bytes
}

/// The archive with a name in it written over by another of the same length, in both places where it stands.
fn renamed(bytes: Vec<u8>, from: &[u8], to: &[u8]) -> Vec<u8> {
    assert_eq!((from.len(), bytes.windows(from.len()).filter(|name| *name == from).count()), (to.len(), 2));
    patched(bytes, from, to)
}

fn tree(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut found = BTreeMap::new();
    for entry in fs::read_dir(folder).unwrap().flatten() {
        if entry.path().is_dir() {
            found.extend(tree(&entry.path()));
            found.insert(entry.path(), Vec::new());
        } else {
            found.insert(entry.path(), fs::read(entry.path()).unwrap());
        }
    }
    found
}

#[test]
fn every_shipped_level_comes_back_whole_where_nothing_else_is() {
    let elsewhere = tempfile::tempdir().unwrap();
    let levels = elsewhere.path().join("levels");
    for name in shipped_levels() {
        let (package, left) = pack::gather(&root().join("levels").join(&name), root()).unwrap();
        assert_eq!(left, [""; 0], "level {name}");
        let bytes = pack::write(&package).unwrap();
        assert_eq!(pack::write(&package).unwrap(), bytes, "the same level makes the same file");
        let read = pack::read(&bytes, "unnamed").unwrap();
        assert_eq!(read, package);
        let installed = pack::install(&read, &levels, elsewhere.path(), false).unwrap();
        assert_eq!(installed, Installed::New(levels.join(&name)));
        let (here, there) = (load(&root().join("levels"), &name, root()), load(&levels, &name, elsewhere.path()));
        assert_eq!(level_hash(&here), level_hash(&there), "level {name}");
        for flight in ["careful", "gold", "mark"] {
            let flight = format!("{name}/flights/{flight}.replay.csv");
            assert_eq!(fs::read(levels.join(&flight)).unwrap(), fs::read(root().join("levels").join(&flight)).unwrap());
        }
    }
    assert!(fs::read_dir(&levels).unwrap().flatten().all(|entry| !entry.file_name().to_string_lossy().starts_with('.')));
}

#[test]
fn pictures_go_along_from_the_level_and_from_the_project() {
    let from = tempfile::tempdir().unwrap();
    let png = fs::read(fixtures().join("levels/15/sails.png")).unwrap();
    let folder = from.path().join("levels/t");
    fs::create_dir_all(folder.join("art")).unwrap();
    fs::create_dir_all(from.path().join("assets/deep")).unwrap();
    for (name, text) in LEVEL {
        fs::write(from.path().join("levels").join(name), text).unwrap();
    }
    fs::write(folder.join("art/own.png"), &png).unwrap();
    fs::write(from.path().join("assets/deep/shared.png"), &png).unwrap();
    let objects = "x,y,image,mass,drag,circular,restitution\n2000,2000,./art/own.png,5,1,FALSE,0\n";
    fs::write(folder.join("constants.csv"), "width,4000\nheight,4000\n").unwrap();
    fs::write(folder.join("objects.csv"), objects).unwrap();
    fs::write(folder.join("decoration.csv"), "x,y,image\n300,10,assets/deep/shared.png\n").unwrap();
    fs::write(folder.join("notes.txt"), "by hand").unwrap();
    fs::write(folder.join("sketch.svg"), "<svg/>").unwrap();
    let (package, left) = pack::gather(&folder, from.path()).unwrap();
    assert_eq!(left, ["sketch.svg"]);
    let paths: Vec<&str> = package.files.keys().map(String::as_str).collect();
    let pictures = "art/own.png assets/deep/shared.png";
    assert_eq!(paths.join(" "), format!("{pictures} constants.csv decoration.csv notes.txt objectives.csv objects.csv player.csv"));
    let to = tempfile::tempdir().unwrap();
    let read = pack::read(&pack::write(&package).unwrap(), "").unwrap();
    pack::install(&read, &to.path().join("levels"), to.path(), false).unwrap();
    let level = load(&to.path().join("levels"), "t", to.path());
    let own = to.path().join("levels/t/assets");
    assert!(level.pictures().any(|picture| picture.starts_with(&own)), "{:?}", level.decoration);
}

#[test]
fn what_could_do_harm_is_refused_with_its_name() {
    for (words, added) in [
        ("stays in the level's folder", &["../x.csv", "t/../../x.csv", "/x.csv", "C:/x.csv", "t\\..\\x.csv"][..]),
        ("stays in the level's folder", &["t//x.csv", "t/./x.csv", "t/con.csv", "t/a:b.csv"]),
        // Files that belong to no level: programs, archives, flights of another kind.
        ("belongs to no level", &["t/run.exe", "t/run", "t/a.csv.sh", "t/more.zip", "t/flights/x.csv", "t/flights/x.png"]),
        ("beside the level's folder", &["u/x.csv", "x.csv"]),
        ("expected one level", &["u/player.csv"]),
        ("a device", &["t/con .txt", "t/CONIN$.txt", "t/com1 .csv"]),
        ("an invisible character", &["t/vsc.\u{202e}txt", "t/\u{200b}.txt", "t/\u{3164}/x.png", "t/\u{2066}a\u{2069}.csv"]),
        ("a backslash", &["t\\x.csv"]),
    ] {
        added.iter().for_each(|name| says(&with(&[(name, b"x")]), words));
    }
    for (words, whole) in [
        ("at the top", &["a/b/player.csv"][..]),
        ("no player.csv", &["t/world.csv"]),
        ("no player.csv", &[]),
        ("another name", &["jumper/player.csv"]),
        ("another name", &["attempts/player.csv"]),
        ("an invisible character", &["to\u{202e}wer/player.csv"]),
    ] {
        says(&archive(&whole.iter().map(|name| (*name, &b"x"[..])).collect::<Vec<_>>()), words);
    }
    // One name twice: in the same case or in another, as a file and a folder, in two encodings, and in two cases of unlike length.
    for twice in [
        ["t/World.csv", "t/world.csv"],
        ["t/a.png", "t/A.PNG"],
        ["t/a.png", "t/a.png/b.png"],
        ["t/a.png/b.png", "t/a.png"],
        ["t/\u{e9}.png", "t/e\u{301}.png"],
        ["t/straße.png", "t/STRASSE.png"],
    ] {
        says(&with(&twice.map(|name| (name, &b"x"[..]))), "twice");
    }
    says(&renamed(with(&[("t/aaaa.csv", b"one"), ("t/bbbb.csv", b"two")]), b"t/bbbb.csv", b"t/aaaa.csv"), "one entry a name");
    says(&renamed(with(&[("t/aaaa.csv", b"x")]), b"t/aaaa.csv", b"t/\xff\xfeaa.csv"), "UTF-8");
    // A pipe, and a device, by their modes, which stand in the high bytes of each entry's attributes.
    for kind in [0o010_000_u32, 0o020_000, 0o060_000, 0o140_000] {
        let mut made = ZipWriter::new(Cursor::new(Vec::new()));
        made.start_file("t/notes.txt", SimpleFileOptions::default().unix_permissions(0o644)).unwrap();
        let mode = |kind: u32| ((kind | 0o644) << 16).to_le_bytes();
        says(&patched(made.finish().unwrap().into_inner(), &mode(0o100_000), &mode(kind)), "a pipe or a device");
    }
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    zip.add_symlink("t/world.csv", "/etc/passwd", SimpleFileOptions::default()).unwrap();
    says(&zip.finish().unwrap().into_inner(), "a link");
    says(b"", "no ZIP archive");
    says(b"PK\x03\x04 nothing", "no ZIP archive");
    let sound = with(&[]);
    for end in 0..sound.len() {
        assert!(pack::read(&sound[..end], "t").is_err(), "cut off at {end}");
    }
    let at = sound.windows(4).position(|window| window == b"mass").map_or(60, |at| at);
    let mut damaged = sound.clone();
    damaged[at] ^= 0x20;
    let _ = pack::read(&damaged, "t");
}

#[test]
fn no_bit_that_is_turned_and_no_byte_makes_a_panic_or_a_file() {
    let sound = with(&[("t/world.csv", b"x,y,width,height\n0,500,800,20\n")]);
    let elsewhere = tempfile::tempdir().unwrap();
    let levels = elsewhere.path().join("a/levels");
    for at in 0..sound.len() {
        for change in [0x01, 0xff] {
            let mut bytes = sound.clone();
            bytes[at] ^= change;
            if let Ok(package) = pack::read(&bytes, "t") {
                let _ = pack::install(&package, &levels, elsewhere.path(), true);
            }
        }
    }
    assert!(tree(elsewhere.path()).keys().all(|path| path.starts_with(elsewhere.path().join("a"))));
    let around: Vec<_> = fs::read_dir(elsewhere.path().join("a")).unwrap().flatten().map(|entry| entry.file_name()).collect();
    assert_eq!(around, ["levels"]);
}

#[test]
fn bombs_do_not_go_off() {
    let zeros = vec![0; 40 << 20];
    let bomb = with(&[("t/big.png", &zeros)]);
    assert!(bomb.len() < 100_000, "{}", bomb.len());
    says(&bomb, "more than 16777216 bytes");
    says(&with(&[("t/world.csv", &zeros[..1 << 20])]), "more than 262144 bytes");
    let names: Vec<String> = (0..5).map(|i| format!("t/{i}.png")).collect();
    let many: Vec<(&str, &[u8])> = names.iter().map(|name| (name.as_str(), &zeros[..16 << 20])).collect();
    says(&with(&many), "67108864 bytes up to here, expected no more");
    let names: Vec<String> = (0..1000).map(|i| format!("t/{i}.txt")).collect();
    let many: Vec<(&str, &[u8])> = names.iter().map(|name| (name.as_str(), &b"x"[..])).collect();
    says(&with(&many), "expected at most 1000");
    // An archive that understates its size: the bytes that come out count.
    let length = (zeros.len() as u32).to_le_bytes();
    assert!(pack::read(&patched(with(&[("t/big.png", &zeros)]), &length, &10_u32.to_le_bytes()), "t").is_err());
}

/// A PNG of that size by its head, in a few bytes.
fn png_of(width: u32, height: u32) -> Vec<u8> {
    [b"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR", &width.to_be_bytes()[..], &height.to_be_bytes(), b"\x01\0\0\0\0"].concat()
}

#[test]
fn a_level_that_needs_too_much_memory_is_refused_by_its_sizes_alone() {
    // Pictures of a few bytes: 12 bytes a pixel for each, and 8 once more for the largest.
    let picture = png_of(4096, 2048);
    let names: Vec<String> = (0..3).map(|i| format!("t/{i}.png")).collect();
    let pictures = |count: usize| with(&names[..count].iter().map(|name| (name.as_str(), picture.as_slice())).collect::<Vec<_>>());
    assert!(pictures(3).len() < 6000);
    let told = pack::read(&pictures(3), "t").unwrap_err();
    let needs: u64 = told.strip_prefix("found a level that needs ").unwrap().split(' ').next().unwrap().parse().unwrap();
    assert!(needs > 3 * (96 << 20) + (64 << 20) && told.ends_with(" bytes of memory, expected at most 268435456"), "{told}");
    assert!(pack::read(&pictures(1), "t").is_ok());
    // An archive that says that an entry is larger than any memory: nothing of it was unfolded, for it is not there.
    let lies = |length: u32| patched(with(&[("t/notes.txt", &[b'x'; 77_777])]), &77_777_u32.to_le_bytes(), &length.to_le_bytes());
    says(&lies(1 << 30), "bytes of memory");
    // One that says that it is smaller: no more than that is unfolded.
    says(&lies(7), "notes.txt");
}

/// A flight has a limit of its own, far above that of a table.
#[test]
fn a_long_flight_goes_along() {
    let flight = fs::read_to_string(fixtures().join("levels/1/flights/gold.replay.csv")).unwrap();
    let long = flight + &"1,1,0,0,0\n1,0,0,0,0\n".repeat(40_000);
    assert!(long.len() > 3 * (256 << 10));
    let package = pack::read(&with(&[("t/flights/long.replay.csv", long.as_bytes())]), "").unwrap();
    let folder = tempfile::tempdir().unwrap();
    let installed = pack::install(&package, &folder.path().join("levels"), folder.path(), false).unwrap();
    let (packed, left) = pack::gather(installed.folder(), folder.path()).unwrap();
    assert_eq!((&packed, left.len()), (&package, 0));
    // No flight is a table, and a table has its own limit wherever it lies.
    let wide = vec![b'x'; 300 << 10];
    for file in ["t/world.csv", "t/flights/t/world.csv", "world.csv"] {
        says(&with(&[(file, &wide)]), "262144");
    }
}

#[cfg(unix)]
#[test]
fn a_pack_holds_what_lies_in_the_folder_and_follows_no_link() {
    use std::os::unix::fs::symlink;
    let project = tempfile::tempdir().unwrap();
    let secret = project.path().join("secret.txt");
    fs::write(&secret, "nobody's business").unwrap();
    fs::create_dir_all(project.path().join("pictures")).unwrap();
    fs::copy(fixtures().join("levels/15/sails.png"), project.path().join("pictures/a.png")).unwrap();
    let folder = project.path().join("levels/t");
    fs::create_dir_all(&folder).unwrap();
    for (name, text) in LEVEL {
        fs::write(project.path().join("levels").join(name), text).unwrap();
    }
    let link = |to: &Path, from: &str, more: Option<(&str, &str)>| {
        let from = folder.join(from);
        symlink(to, &from).unwrap();
        let table = more.map(|(name, text)| (folder.join(name), text));
        table.iter().for_each(|(path, text)| fs::write(path, text).unwrap());
        let told = pack::gather(&folder, project.path()).unwrap_err().join("\n");
        assert!(told.starts_with(&format!("{}: found a link", from.display())), "{told}");
        fs::remove_file(&from).unwrap();
        table.iter().for_each(|(path, _)| fs::remove_file(path).unwrap());
    };
    link(&secret, "notes.txt", None);
    link(&secret, "own.png", None);
    fs::create_dir(folder.join("flights")).unwrap();
    link(&secret, "flights/x.replay.csv", None);
    fs::remove_dir(folder.join("flights")).unwrap();
    let art = Some(("decoration.csv", "x,y,image\n1,1,art/a.png\n"));
    link(&project.path().join("pictures"), "art", art);
    link(&project.path().join("pictures/a.png"), "b.png", Some(("decoration.csv", "x,y,image\n1,1,levels/t/b.png\n")));
    fs::write(project.path().join("x.replay.csv"), "flight").unwrap();
    link(project.path(), "flights", None);
    assert_eq!(pack::gather(&folder, project.path()).unwrap().0.files.len(), 3);
}

#[test]
fn what_is_there_already_is_told_precisely() {
    let folder = tempfile::tempdir().unwrap();
    let levels = folder.path().join("levels");
    let package = pack::read(&with(&[("t/world.csv", b"x,y,width,height\n0,500,800,20\n")]), "").unwrap();
    let install = || pack::install(&package, &levels, folder.path(), false);
    install().unwrap();
    // A file that the loader does not read makes no other level of it; one that it reads does.
    fs::create_dir(levels.join("t/flights")).unwrap();
    for mine in ["notes.txt", "flights/mine.replay.csv", ".autosave"] {
        fs::write(levels.join("t").join(mine), "mine").unwrap();
    }
    let more = vec!["flights/mine.replay.csv".to_owned(), "notes.txt".to_owned()];
    assert_eq!(install(), Ok(Installed::Already(levels.join("t"), more)));
    fs::write(levels.join("t/objects.csv"), "").unwrap();
    assert!(install().unwrap_err()[0].contains("another level of that name: objects.csv lies there, too"));
    fs::remove_file(levels.join("t/objects.csv")).unwrap();
    fs::write(levels.join("t/world.csv"), "x,y,width,height\n0,500,800,21\n").unwrap();
    assert!(install().unwrap_err()[0].contains("another level of that name: world.csv is another one"));
}

#[test]
fn nothing_is_written_that_does_not_load_and_nothing_over_what_is_there() {
    let folder = tempfile::tempdir().unwrap();
    let levels = folder.path().join("levels");
    let package = |entries: &[(&str, &[u8])]| pack::read(&with(entries), "").unwrap();
    let refused = |package: &Package| pack::install(package, &levels, folder.path(), true).unwrap_err().join("\n");
    let wrong = refused(&package(&[("t/world.csv", b"x,y,width,height\n0,0,wide,1\n")]));
    assert!(wrong.starts_with("world.csv:2: column \"width\": found \"wide\""), "{wrong}");
    assert!(refused(&package(&[("t/flights/a.replay.csv", b"nothing")])).contains("flights/a.replay.csv:1"));
    assert!(refused(&package(&[("t/background.png", b"nothing")])).contains("background.png"));
    let shown = b"x,y,image\n300,10,assets/sails.png\n";
    fs::create_dir(folder.path().join("assets")).unwrap();
    fs::copy(fixtures().join("levels/15/sails.png"), folder.path().join("assets/sails.png")).unwrap();
    for (table, entries) in [
        ("fluids.csv", &[("t/fluids.csv/x.csv", &b"x\n1\n"[..])][..]),
        ("background.png", &[("t/background.png/x.png", b"x")]),
        ("decoration.csv", &[("t/decoration.csv", shown), ("t/assets/sails.png/x.png", b"x")]),
    ] {
        let told = refused(&package(entries));
        assert!(told.starts_with(table) && told.contains("found a folder, expected a file"), "{told}");
    }
    fs::remove_dir_all(folder.path().join("assets")).unwrap();
    assert!(tree(folder.path()).keys().all(|path| *path == levels), "{:?}", tree(folder.path()).keys());
    let (first, second) = (package(&[]), package(&[("t/notes.txt", b"two")]));
    let install = |package: &Package, free| pack::install(package, &levels, folder.path(), free);
    assert_eq!(install(&first, false), Ok(Installed::New(levels.join("t"))));
    let before = tree(folder.path());
    assert_eq!(install(&first, false), Ok(Installed::Already(levels.join("t"), vec![])));
    let taken = install(&second, false).unwrap_err();
    assert!(taken[0].contains("another level of that name: notes.txt is not there"), "{taken:?}");
    assert_eq!(tree(folder.path()), before, "nothing was written");
    assert_eq!(install(&second, true), Ok(Installed::New(levels.join("t-2"))));
    assert_eq!(install(&second, true), Ok(Installed::Already(levels.join("t-2"), vec![])));
    fs::create_dir(levels.join("t-3")).unwrap();
    fs::write(levels.join("t-4"), "").unwrap();
    let third = package(&[("t/notes.txt", b"three")]);
    assert_eq!(install(&third, true), Ok(Installed::New(levels.join("t-5"))));
}

#[test]
fn files_without_a_folder_take_the_archives_name() {
    let flat: Vec<(&str, &[u8])> = LEVEL.iter().map(|(name, text)| (name.strip_prefix("t/").unwrap(), text.as_bytes())).collect();
    let package = pack::read(&archive(&flat), "tower").unwrap();
    assert_eq!((package.name.as_str(), package.files.len()), ("tower", 3));
    assert!(pack::read(&archive(&flat), "..").is_err());
    // Files that systems leave in archives are passed over.
    let beside: [(&str, &[u8]); 2] = [("__MACOSX/t/._player.csv", b"\0"), ("t/.DS_Store", b"\0")];
    assert_eq!(pack::read(&with(&beside), "").unwrap().files.len(), 3);
}
