//! A level as one file: what is packed comes back whole, and nothing that is made to do harm leaves a trace.

use resultant::game::level_hash;
use resultant::level::{self, Level};
use resultant::pack::{self, Installed, Package};
use std::collections::BTreeMap;
use std::fs;
use std::io::{Cursor, Write};
use std::path::{Path, PathBuf};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn load(levels: &Path, name: &str, project: &Path) -> Level {
    level::load(&levels.join(name), project).unwrap().level
}

/// The least that makes a level.
const LEVEL: [(&str, &str); 3] = [
    ("t/player.csv", "x,y,mass,fuel,thrust\n400,300,100,500,3000\n"),
    ("t/objectives.csv", "PLAYER,10,10,20,20\n"),
    ("t/constants.csv", "width,800\nheight,600\n"),
];

/// An archive of these entries.
fn archive(entries: &[(&str, &[u8])]) -> Vec<u8> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, bytes) in entries {
        zip.start_file(*name, SimpleFileOptions::default().compression_method(CompressionMethod::Deflated)).unwrap();
        zip.write_all(bytes).unwrap();
    }
    zip.finish().unwrap().into_inner()
}

/// The least level, and these beside it.
fn with(entries: &[(&str, &[u8])]) -> Vec<u8> {
    let level = LEVEL.iter().map(|(name, text)| (*name, text.as_bytes()));
    archive(&level.chain(entries.iter().copied()).collect::<Vec<_>>())
}

/// The archive with a name in it written over by another of the same length, in both places where it stands.
fn renamed(mut bytes: Vec<u8>, from: &[u8], to: &[u8]) -> Vec<u8> {
    assert_eq!(from.len(), to.len());
    let places: Vec<usize> = (0..bytes.len() - from.len()).filter(|&at| bytes[at..].starts_with(from)).collect();
    assert_eq!(places.len(), 2);
    places.iter().for_each(|&at| bytes[at..at + to.len()].copy_from_slice(to));
    bytes
}

/// Everything below a folder, by path.
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
    for name in level::list(&root().join("levels")) {
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
    let png = fs::read(root().join("levels/15/sails.png")).unwrap();
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
    let expected = [
        "art/own.png",
        "assets/deep/shared.png",
        "constants.csv",
        "decoration.csv",
        "notes.txt",
        "objectives.csv",
        "objects.csv",
        "player.csv",
    ];
    assert_eq!(paths, expected);
    let to = tempfile::tempdir().unwrap();
    let read = pack::read(&pack::write(&package).unwrap(), "").unwrap();
    pack::install(&read, &to.path().join("levels"), to.path(), false).unwrap();
    let level = load(&to.path().join("levels"), "t", to.path());
    let own = to.path().join("levels/t/assets");
    assert!(level.pictures().any(|picture| picture.starts_with(&own)), "{:?}", level.decoration);
}

#[test]
fn what_could_do_harm_is_refused_with_its_name() {
    let refused = |bytes: &[u8]| pack::read(bytes, "t").unwrap_err();
    let says = |bytes: &[u8], words: &str| {
        let told = refused(bytes);
        assert!(told.contains(words), "{told:?} does not say {words:?}");
    };
    for away in
        ["../x.csv", "t/../../x.csv", "/x.csv", "C:/x.csv", "t\\..\\x.csv", "t//x.csv", "t/./x.csv", "t/con.csv", "t/a:b.csv"]
    {
        says(&with(&[(away, b"x")]), "stays in the level's folder");
    }
    // What is no level's: programs, archives, flights of another kind.
    for other in ["t/run.exe", "t/run", "t/a.csv.sh", "t/more.zip", "t/flights/x.csv", "t/flights/x.png"] {
        says(&with(&[(other, b"x")]), "belongs to no level");
    }
    says(&with(&[("u/x.csv", b"x")]), "beside the level's folder");
    says(&with(&[("x.csv", b"x")]), "beside the level's folder");
    says(&with(&[("u/player.csv", b"x")]), "expected one level");
    says(&archive(&[("a/b/player.csv", b"x")]), "at the top");
    says(&archive(&[("t/world.csv", b"x")]), "no player.csv");
    says(&archive(&[]), "no player.csv");
    says(&archive(&[("jumper/player.csv", b"x")]), "another name");
    says(&archive(&[("attempts/player.csv", b"x")]), "another name");
    // One name twice, in the same case or in another; a file that is a folder, too.
    says(&with(&[("t/World.csv", b"x"), ("t/world.csv", b"x")]), "twice");
    says(&with(&[("t/a.png", b"x"), ("t/A.PNG", b"x")]), "twice");
    says(&with(&[("t/a.png", b"x"), ("t/a.png/b.png", b"x")]), "twice");
    says(&with(&[("t/a.png/b.png", b"x"), ("t/a.png", b"x")]), "twice");
    says(&renamed(with(&[("t/aaaa.csv", b"one"), ("t/bbbb.csv", b"two")]), b"t/bbbb.csv", b"t/aaaa.csv"), "one entry a name");
    // Names that are no text.
    says(&renamed(with(&[("t/aaaa.csv", b"x")]), b"t/aaaa.csv", b"t/\xff\xfeaa.csv"), "UTF-8");
    // Links.
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    zip.add_symlink("t/world.csv", "/etc/passwd", SimpleFileOptions::default()).unwrap();
    says(&zip.finish().unwrap().into_inner(), "a link");
    // No archive at all, one that was cut off, one whose bytes were changed.
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
    // Whatever was taken is below the folder of levels.
    assert!(tree(elsewhere.path()).keys().all(|path| path.starts_with(elsewhere.path().join("a"))));
    let around: Vec<_> = fs::read_dir(elsewhere.path().join("a")).unwrap().flatten().map(|entry| entry.file_name()).collect();
    assert_eq!(around, ["levels"]);
}

#[test]
fn bombs_do_not_go_off() {
    let says = |bytes: &[u8], words: &str| {
        let told = pack::read(bytes, "t").unwrap_err();
        assert!(told.contains(words), "{told:?} does not say {words:?}");
    };
    // One file that unfolds to more than it may be.
    let zeros = vec![0; 40 << 20];
    let bomb = with(&[("t/big.png", &zeros)]);
    assert!(bomb.len() < 100_000, "{}", bomb.len());
    says(&bomb, "more than 16777216 bytes");
    says(&with(&[("t/world.csv", &zeros[..1 << 20])]), "more than 262144 bytes");
    // Many that are allowed, each by itself.
    let names: Vec<String> = (0..9).map(|i| format!("t/{i}.png")).collect();
    let many: Vec<(&str, &[u8])> = names.iter().map(|name| (name.as_str(), &zeros[..16 << 20])).collect();
    says(&with(&many), "expected no more");
    let names: Vec<String> = (0..1000).map(|i| format!("t/{i}.txt")).collect();
    let many: Vec<(&str, &[u8])> = names.iter().map(|name| (name.as_str(), &b"x"[..])).collect();
    says(&with(&many), "expected at most 1000");
    // An archive that says that it is smaller than it is: what comes out counts.
    let mut liar = with(&[("t/big.png", &zeros)]);
    let length = (zeros.len() as u32).to_le_bytes();
    let places: Vec<usize> = (0..liar.len() - 4).filter(|&at| liar[at..at + 4] == length).collect();
    assert!(!places.is_empty());
    places.iter().for_each(|&at| liar[at..at + 4].copy_from_slice(&10_u32.to_le_bytes()));
    assert!(pack::read(&liar, "t").is_err());
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
    assert!(tree(folder.path()).keys().all(|path| *path == levels), "{:?}", tree(folder.path()).keys());
    // Installed once; then it is there already; another one of that name is not written over it.
    let (first, second) = (package(&[]), package(&[("t/notes.txt", b"two")]));
    let install = |package: &Package, free| pack::install(package, &levels, folder.path(), free);
    assert_eq!(install(&first, false), Ok(Installed::New(levels.join("t"))));
    let before = tree(folder.path());
    assert_eq!(install(&first, false), Ok(Installed::Already(levels.join("t"))));
    let taken = install(&second, false).unwrap_err();
    assert!(taken[0].contains("another level of that name"), "{taken:?}");
    assert_eq!(tree(folder.path()), before, "nothing was written");
    assert_eq!(install(&second, true), Ok(Installed::New(levels.join("t-2"))));
    assert_eq!(install(&second, true), Ok(Installed::Already(levels.join("t-2"))));
    // A folder that is empty, or a file, is somebody's too.
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
    // What systems leave in archives is passed over.
    let beside: [(&str, &[u8]); 2] = [("__MACOSX/t/._player.csv", b"\0"), ("t/.DS_Store", b"\0")];
    assert_eq!(pack::read(&with(&beside), "").unwrap().files.len(), 3);
}
