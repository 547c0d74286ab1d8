//! Scores that are earned: a row leads to its flight, and what was forged, taken from elsewhere or flown in another version of the level
//! is found.

use resultant::game::{Mismatch, Replay, level_hash};
use resultant::level::{self, Level};
use resultant::scores::{Claim, Doubt, Name, PATIENCE, Placement, Score, Scores};
use std::fs;
use std::path::Path;
use std::sync::Arc;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn level(name: &str) -> Arc<Level> {
    Arc::new(level::load(&root().join("levels").join(name), root()).unwrap().level)
}

fn record(level: &str, flight: &str) -> Replay {
    let file = root().join(format!("levels/{level}/flights/{flight}.replay.csv"));
    Replay::parse("flight", &fs::read_to_string(file).unwrap()).unwrap()
}

fn name(text: &str) -> Name {
    Name::new(text).unwrap()
}

fn save(scores: &Scores, user: &str, flight: &Replay) -> Placement {
    let score = Score { name: &name(user), points: flight.score, flight: Some(flight) };
    scores.save_within(PATIENCE, "1", score).unwrap().placement
}

/// What comes of flying a row again.
fn judge(scores: &Scores, row: usize, level: Arc<Level>) -> Option<Result<(), Doubt>> {
    let board = scores.load("1").unwrap().board;
    let origin = board.origin(row);
    let flight = match scores.flight("1", &origin)? {
        Ok(flight) => flight,
        Err(problem) => return Some(Err(Doubt::Unreadable(problem))),
    };
    let mut claim = match Claim::new(&board.rows()[row], &origin, flight, level) {
        Ok(claim) => claim,
        Err(doubt) => return Some(Err(doubt)),
    };
    loop {
        if let Some(verdict) = claim.step() {
            return Some(verdict);
        }
    }
}

#[test]
fn a_row_leads_to_its_flight_and_is_proven_by_it() {
    let folder = tempfile::tempdir().unwrap();
    let scores = Scores::new(folder.path().join("scores"));
    let (careful, gold) = (record("1", "careful"), record("1", "gold"));
    assert_eq!(save(&scores, "ann", &careful), Placement::New { rank: 1 });
    assert_eq!(judge(&scores, 0, level("1")), Some(Ok(())));
    assert_eq!(scores.flight("1", &scores.load("1").unwrap().board.origin(0)), Some(Ok(careful.clone())));
    // A better one takes its place, a worse one leaves no trace.
    assert!(matches!(save(&scores, "ann", &gold), Placement::Raised { rank: 1, .. }));
    let flights = || fs::read_dir(folder.path().join("scores/flights/1")).unwrap().count();
    let (board, kept) = (scores.load("1").unwrap().board, flights());
    assert!(matches!(save(&scores, "ann", &careful), Placement::Kept { .. }));
    assert_eq!((scores.load("1").unwrap().board, flights()), (board.clone(), kept));
    let origin = board.origin(0);
    assert_eq!(scores.flight("1", &origin), Some(Ok(gold.clone())));
    assert_eq!((origin.version, origin.program), (gold.level_hash, gold.program));
    // A score that is saved without a flight is no longer that of the old one.
    assert!(matches!(scores.save("1", &name("ann"), 99_999), Ok(saved) if saved.board.origin(0).flight.is_none()));
    assert_eq!(judge(&scores, 0, level("1")), None);
}

#[test]
fn older_files_load_and_keep_their_cells() {
    let folder = tempfile::tempdir().unwrap();
    for (old, new) in [
        ("name,score\nbob,9\n", "name,score,flight,version,program\n"),
        ("bob,9\n", "name,score,flight,version,program\n"),
        ("name,score,class\nbob,9,7b\n", "name,score,class,flight,version,program\n"),
        ("bob,9,7b\n", "name,score,,flight,version,program\n"),
    ] {
        fs::create_dir_all(folder.path().join("scores")).unwrap();
        fs::write(folder.path().join("scores/1.csv"), old).unwrap();
        let scores = Scores::new(folder.path().join("scores"));
        assert_eq!(judge(&scores, 0, level("1")), None, "a row without a flight is one");
        save(&scores, "ann", &record("1", "gold"));
        let text = fs::read_to_string(folder.path().join("scores/1.csv")).unwrap();
        assert!(text.starts_with(new), "{text}");
        assert_eq!(text.contains("7b"), old.contains("7b"), "{text}");
        assert_eq!((judge(&scores, 0, level("1")), judge(&scores, 1, level("1"))), (Some(Ok(())), None));
    }
}

#[test]
fn what_is_forged_is_found() {
    let folder = tempfile::tempdir().unwrap();
    let scores = Scores::new(folder.path().join("scores"));
    let gold = record("1", "gold");
    save(&scores, "ann", &gold);
    let file = folder.path().join("scores/1.csv");
    let sound = fs::read_to_string(&file).unwrap();
    let flight = folder.path().join("scores/flights/1").join(scores.load("1").unwrap().board.origin(0).flight.unwrap());
    let flown = fs::read_to_string(&flight).unwrap();
    let verdict = |row: &str, text: &str| {
        fs::write(&file, row).unwrap();
        fs::write(&flight, text).unwrap();
        judge(&scores, 0, level("1")).expect("it has a flight")
    };
    assert_eq!(verdict(&sound, &flown), Ok(()));
    // The row's score alone.
    let raised = sound.replacen(&gold.score.to_string(), "20000", 1);
    assert_eq!(verdict(&raised, &flown), Err(Doubt::Score(20_000, gold.score)));
    // The record's, too.
    let forged = flown.replace(&format!("# score: {}", gold.score), "# score: 20000");
    assert!(matches!(verdict(&raised, &forged), Err(Doubt::Flown(Mismatch::End { .. }, None))));
    // Its inputs.
    let other = flown.replacen("\n60,1,0,0,0", "\n61,1,0,0,0", 1);
    assert_ne!(other, flown);
    assert!(matches!(verdict(&sound, &other), Err(Doubt::Flown(Mismatch::Second(1, ..), None))));
    // The flight of another level, and one that does not say of which it is.
    let elsewhere = Replay { score: gold.score, ..record("2", "gold") }.to_string();
    let hash = level_hash(&level("2"));
    assert_eq!(verdict(&sound, &elsewhere), Err(Doubt::Version(level_hash(&level("1")), hash)));
    let unversioned = sound.replace(&format!("{:016x}", level_hash(&level("1"))), "");
    assert!(matches!(verdict(&unversioned, &elsewhere), Err(Doubt::Flown(Mismatch::Level(found, _), None)) if found == hash));
    let nowhere = Replay { level_hash: None, ..gold.clone() }.to_string();
    assert_eq!(verdict(&sound, &nowhere), Err(Doubt::NoLevel));
    // Slower ticks, in which a person is faster.
    let slow = Replay { tick_rate: 30.0, ..gold.clone() }.to_string();
    assert_eq!(verdict(&sound, &slow), Err(Doubt::Rate(30.0)));
    // A flight that has not come to its end is worth nothing.
    let short: String =
        flown.lines().filter(|line| !line.starts_with("# hash ")).take(12).map(|line| format!("{line}\n")).collect();
    assert!(matches!(verdict(&sound, &short), Err(Doubt::Flown(Mismatch::End { .. }, None))));
    // Another program's flight that departs says whose it was.
    let older = other.replace("# program: resultant", "# program: something");
    assert!(matches!(verdict(&sound, &older), Err(Doubt::Flown(_, Some(program))) if program.starts_with("something")));
    // No flight where the row leads, or a way out of the folder.
    fs::remove_file(&flight).unwrap();
    assert!(matches!(judge(&scores, 0, level("1")), Some(Err(Doubt::Unreadable(_)))));
    for away in ["../../../1.csv", "/etc/passwd", "..", ".hidden.replay.csv", "sub/x.replay.csv", "C:x.replay.csv"] {
        let named = sound.replace(flight.file_name().unwrap().to_str().unwrap(), away);
        fs::write(&file, named).unwrap();
        let verdict = judge(&scores, 0, level("1"));
        assert!(matches!(&verdict, Some(Err(Doubt::Unreadable(words))) if words.contains("expected a file's name")), "{verdict:?}");
    }
}

#[test]
fn a_changed_level_keeps_its_old_board_aside() {
    let folder = tempfile::tempdir().unwrap();
    let scores = Scores::new(folder.path().join("scores"));
    let gold = record("1", "gold");
    let (now, then) = (gold.level_hash.unwrap(), 0x1234);
    let older = |score: i64| Replay { level_hash: Some(then), score, ..gold.clone() };
    fs::create_dir_all(folder.path().join("scores")).unwrap();
    fs::write(folder.path().join("scores/1.csv"), "name,score,class\nold,5,7b\n").unwrap();
    save(&scores, "bob", &older(9000));
    save(&scores, "cid", &older(8000));
    let text = fs::read_to_string(folder.path().join("scores/1.csv")).unwrap();
    fs::write(folder.path().join("scores/1.csv"), text.replace("cid,8000,,", "cid,8000,8a,")).unwrap();
    // Seen from the level as it is now they are not on the board; nothing is written by looking.
    let shown = |version: u64| {
        let (loaded, others) = scores.load_version("1", version).unwrap();
        let rows: Vec<String> = loaded.board.rows().iter().map(|row| format!("{} {}", row.name, row.score)).collect();
        (rows.join(", "), others)
    };
    assert_eq!(shown(now), ("old 5".to_owned(), 1));
    assert_eq!(shown(then), ("bob 9000, cid 8000, old 5".to_owned(), 0));
    assert!(!folder.path().join("scores/aside").exists());
    // A save moves them; a lower score than the one aside is the best of this version.
    assert_eq!(save(&scores, "bob", &Replay { score: 7000, ..gold.clone() }), Placement::New { rank: 1 });
    assert_eq!(shown(now), ("bob 7000, old 5".to_owned(), 1));
    let aside = fs::read_to_string(folder.path().join("scores/aside/1.0000000000001234.csv")).unwrap();
    assert!(aside.contains("bob,9000") && aside.contains("8a") && !aside.contains("old"), "{aside}");
    assert_eq!(shown(then).0, "bob 9000, cid 8000, old 5");
    // The level is changed back: they are on the board again, and the other version's go aside.
    save(&scores, "dan", &older(8500));
    assert_eq!(shown(then), ("bob 9000, dan 8500, cid 8000, old 5".to_owned(), 1));
    assert_eq!(shown(now), ("bob 7000, old 5".to_owned(), 1));
    let board = fs::read_to_string(folder.path().join("scores/1.csv")).unwrap();
    assert!(board.contains("old,5,7b") && board.contains("cid,8000,8a"), "{board}");
}

#[cfg(unix)]
#[test]
fn a_flight_that_cannot_be_kept_saves_no_row() {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir_all(folder.path().join("scores")).unwrap();
    fs::write(folder.path().join("scores/flights"), "in the way").unwrap();
    let scores = Scores::new(folder.path().join("scores"));
    let gold = record("1", "gold");
    let score = Score { name: &name("ann"), points: gold.score, flight: Some(&gold) };
    assert!(scores.save_within(PATIENCE, "1", score).is_err());
    assert!(!folder.path().join("scores/1.csv").exists());
}
