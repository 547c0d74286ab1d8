//! Flights that were flown are watched, kept and raced, from the score, from the board and from the list of levels.

use crate::sitting::{HERE, Sitting, level, says};
use crate::support::shipped::fixtures;
use resultant::draw::layout::Vec2;
use resultant::game::{Game, Outcome, Replay};
use resultant::number::{clock, hundredths};
use resultant::pack;
use resultant::screens::{Gap, Input, Key, MOST_RIVALS, Spectator, Split};
use std::fs;
use std::path::Path;

const OTHER_LEVEL: &str = "# level_hash: 0123456789abcdef0123456789abcdef0123456789abcdef0123456789abcdef";

/// A sitting with a level "up" that is done by thrusting for about a second.
fn sitting() -> Sitting {
    Sitting::with(|root| level(root, "0", "PLAYER,380,60,40,40\n", ""))
}

/// Flies "up" to its end and waits for the score, until its keys count. Two keys that cancel each other start the clock; after the delay, in
/// frames, the ship thrusts.
fn fly_up(sitting: &mut Sitting, delay: usize) {
    sitting.hold(&[Key::Left, Key::Right], delay).hold_until(&[Key::Space], |sitting| sitting.at() != "flight").wait(0.5);
}

fn flown_up(delay: usize) -> Sitting {
    let mut sitting = sitting();
    fly_up(sitting.fly("0"), delay);
    sitting
}

fn stands(sitting: &Sitting) -> bool {
    sitting.labels().contains(&"Play") && sitting.shows("paused · ")
}

fn save_as(sitting: &mut Sitting, name: &str, delay: usize) {
    fly_up(sitting.fly("0"), delay);
    if sitting.labels().contains(&"Save Score") {
        sitting.choose("Save Score").write(name).press(Key::Enter).wait(0.6);
    }
    sitting.choose("Board");
}

#[test]
fn a_flight_is_watched_from_its_score_bit_for_bit() {
    let mut sitting = flown_up(0);
    assert_eq!(sitting.at(), "scoring");
    sitting.choose("Watch");
    assert_eq!((sitting.at(), sitting.ticks()), ("watch", 0));
    sitting.wait(3.0);
    assert!(stands(&sitting) && sitting.game().outcome() == Outcome::Completed);
    let (known, end) = (sitting.flight().history().ticks(), sitting.game().hash());
    assert_eq!(sitting.ticks(), known);
    sitting.press_all(&[Key::Left, Key::Left]);
    assert_eq!(sitting.ticks(), known - 2);
    sitting.press_all(&[Key::Right, Key::Right]);
    assert_eq!((sitting.ticks(), sitting.game().hash()), (known, end));
    sitting.press(Key::Home);
    assert_eq!(sitting.ticks(), 0);
    sitting.press(Key::PageDown);
    assert_eq!(sitting.ticks(), 120.min(known));
    assert_eq!(sitting.press(Key::Escape).at(), "scoring");
}

/// What the instruments tell is of the very moment that is shown, wherever one jumps.
#[test]
fn what_is_watched_is_measured_as_it_was_flown() {
    let mut sitting = flown_up(0);
    sitting.choose("Watch").press(Key::I).click("Trails").click("Energy, work").wait(3.0);
    for key in [Key::Left, Key::Home, Key::Right, Key::End, Key::PageUp, Key::Right] {
        sitting.press(key);
        let (watch, ship) = (sitting.flight(), |game: &Game| game.world().bodies()[0].clone());
        let (tick, measures) = (watch.game().ticks(), watch.instruments().measures());
        let dots: Vec<_> = measures.trail.dots(tick, 120.0).map(|dots| (dots.number, dots.places[0])).collect();
        assert_eq!(dots.len() as u64, tick / 12 + 1, "tick {tick}");
        assert!(tick % 12 != 0 || dots.last().map(|dot| dot.1) == Some(ship(watch.game()).position));
        let joules = 0.5 * 100.0 * ship(watch.game()).velocity.length_squared();
        let told = |name: &str| measures.table().lines.iter().find(|line| line.name == name).unwrap().values.clone();
        for name in ["Kinetic energy", "= kinetic gained"] {
            assert!(told(name).iter().all(|told| says(told, joules, "J")), "tick {tick}: {joules} J, shown {:?}", told(name));
        }
    }
}

#[test]
fn what_is_watched_is_slowed_down_hurried_and_dragged() {
    let mut sitting = flown_up(60);
    sitting.choose("Watch").press_all(&[Key::Down, Key::Down, Key::Down]);
    assert_eq!(sitting.flight().observer().pace(), 0.125);
    let from = sitting.ticks();
    sitting.wait(1.0);
    assert!((14..=16).contains(&(sitting.ticks() - from)), "an eighth of 120 ticks");
    sitting.press_all(&[Key::Up; 9]);
    assert_eq!(sitting.flight().observer().pace(), 8.0);
    sitting.press(Key::Home);
    let from = sitting.ticks();
    sitting.wait(0.1);
    assert!((90..=120).contains(&(sitting.ticks() - from)), "eight times 12 ticks");
    sitting.press(Key::Space);
    assert!(stands(&sitting));
    let (line, known) = (sitting.area("Time line").inset(8.0), sitting.flight().history().ticks());
    for (part, wanted) in [(0.5, known / 2), (1.2, known), (-0.2, 0)] {
        let pointer = Vec2::new(line.min.x + line.size.x * part, line.centre().y);
        let hold = |click| Input { pointer, click, holding: true, ..Input::default() };
        if part == 0.5 {
            sitting.give(hold(true));
        }
        sitting.give(hold(false));
        assert!(sitting.ticks().abs_diff(wanted) <= 1, "{part}: {}", sitting.ticks());
    }
    assert!(stands(&sitting), "letting go changes nothing of that");
    sitting.rest().click("Play");
    assert!(!stands(&sitting));
    assert_eq!(sitting.click("Back").at(), "scoring");
}

#[test]
fn jumps_are_told_and_single_ticks_are_seen() {
    #[derive(Default)]
    struct Told(Vec<(&'static str, u64)>);
    impl Spectator for Told {
        fn after_tick(&mut self, game: &Game) {
            self.0.push(("tick", game.ticks()));
        }
        fn jumped(&mut self, game: &Game) {
            self.0.push(("jump", game.ticks()));
        }
    }
    let mut sitting = flown_up(0);
    sitting.choose("Watch").press(Key::Space).press(Key::Home);
    let mut told = Told::default();
    for key in [Key::Right, Key::Right, Key::Left, Key::PageDown] {
        sitting.give_to(Input { pressed: [key].into_iter().collect(), ..Input::default() }, &mut told);
    }
    assert_eq!(told.0, [("tick", 1), ("tick", 2), ("jump", 1), ("jump", 121.min(sitting.flight().history().ticks()))]);
}

#[test]
fn a_saved_score_has_its_flight_and_its_row_leads_to_it() {
    let mut sitting = sitting();
    save_as(&mut sitting, "ann", 0);
    let text = sitting.scores_file("0.csv");
    let cells: Vec<&str> = text.lines().nth(1).unwrap().split(',').collect();
    assert_eq!(text.lines().next(), Some("name,score,time,flight"));
    let flight = sitting.scores_file(&format!("flights/0/{}", cells[3]));
    let replay = Replay::parse("flight", &flight).unwrap();
    assert_eq!((replay.score.to_string(), replay.outcome), (cells[1].to_owned(), Outcome::Completed));
    assert_eq!((replay.player.as_deref(), replay.level.as_str()), (Some("ann"), "0"));
    assert!(sitting.row("ann").contains(&clock(replay.inputs.ticks() as f64 / 120.0)), "{:?}", sitting.row("ann"));
    fs::write(sitting.folder.path().join("scores/0.csv"), text.clone() + "old,20500\nbob,1,9.5,bob.replay.csv\n").unwrap();
    sitting.home().choose("Boards").choose("0");
    assert_eq!(sitting.leaderboard().board.rows()[0].name.as_str(), "old", "its score alone ranks it");
    assert_eq!((sitting.row("old")[2].as_str(), sitting.row("bob")[2].as_str()), ("–", "00:09.50"));
    let old = sitting.place("old");
    assert_eq!(sitting.click_at(old).at(), "leaderboard");
    let bob = sitting.place("bob");
    assert_eq!(sitting.click_at(bob).at(), "flights");
    assert_eq!(sitting.rest().picked(), Some(sitting.place("bob").y));
}

#[test]
fn the_levels_own_flights_stand_on_its_board_by_their_scores() {
    let mut sitting = sitting();
    save_as(&mut sitting, "ann", 0);
    let file = sitting.scores_file("0.csv").lines().nth(1).unwrap().split(',').nth(3).unwrap().to_owned();
    let ann = sitting.scores_file(&format!("flights/0/{file}"));
    let score = Replay::parse("ann", &ann).unwrap().score;
    let own = sitting.folder.path().join("levels/0/flights");
    fs::create_dir_all(&own).unwrap();
    for (name, points) in [("gold", score + 1), ("mark", score), ("careful", 1)] {
        let text = ann.replace(&format!("# score: {score}"), &format!("# score: {points}"));
        fs::write(own.join(format!("{name}.replay.csv")), text).unwrap();
    }
    let other = ann.lines().map(|line| if line.starts_with("# level_hash") { OTHER_LEVEL } else { line });
    fs::write(own.join("silver.replay.csv"), other.collect::<Vec<_>>().join("\n")).unwrap();
    let board = sitting.scores_file("0.csv");
    fs::write(sitting.folder.path().join("scores/0.csv"), board + "old,20900\nbad,20800,,none.replay.csv\n").unwrap();
    sitting.home().choose("Boards").choose("0").wait(0.5);
    let left = sitting.place("Name").x;
    let shown: Vec<String> = sitting.texts().into_iter().filter(|(_, at)| at.x == left).map(|(text, _)| text).skip(1).collect();
    assert_eq!(shown, ["old", "bad", "Gold", "ann", "Mark", "Careful"]);
    assert_eq!(sitting.row("Gold")[1..3], ["level's own".to_owned(), sitting.row("ann")[2].clone()]);
    sitting.choose("Flights").wait(0.3);
    assert_eq!(sitting.at(), "flights");
    let known = sitting.flights().candidates.iter().map(|flight| (flight.time.is_some(), flight.score.is_some()));
    assert_eq!(known.collect::<Vec<_>>(), [(true, true), (true, true), (true, true), (true, true), (true, true), (false, true)]);
}

#[test]
fn one_or_several_are_raced_and_the_gaps_are_right() {
    let mut sitting = sitting();
    save_as(&mut sitting, "ann", 30);
    sitting.home().choose("Levels").press(Key::Tab);
    assert_eq!(sitting.at(), "flights");
    assert_eq!(sitting.flights().candidates.iter().map(|flight| flight.about.as_str()).collect::<Vec<_>>(), ["your best, rank 1"]);
    sitting.choose("Race");
    assert_eq!(sitting.at(), "flight");
    assert_eq!(sitting.flight().race().unwrap().all().len(), 1);
    let board = sitting.scores_file("0.csv");
    let file = board.lines().nth(1).unwrap().split(',').nth(3).unwrap().to_owned();
    let ann = Replay::parse("ann", &sitting.scores_file(&format!("flights/0/{file}"))).unwrap().time;
    // The start of the race is that of the ghost, which waits there for the clock, however long no key is pressed.
    sitting.wait(1.0);
    let start = sitting.game().level().player.position;
    let ghost = sitting.flight().race().unwrap().ghosts(sitting.game(), 1.0).next().unwrap().1;
    assert_eq!(ghost.centre, start);
    sitting.hold_until(&[Key::Space], |sitting| sitting.game().outcome() == Outcome::Completed);
    let race = sitting.flight().race().unwrap();
    let split = race.splits()[0];
    assert_eq!(split, Split { objective: 0, tick: sitting.game().ticks_on_clock() });
    sitting.rest();
    let race = sitting.flight().race().unwrap();
    let Gap::Seconds(gap) = race.gap(&race.all()[0], split) else { panic!("{:?}", race.gap(&race.all()[0], split)) };
    // In the hundredths in which both times are shown, however long each has waited for its first key.
    let shown = |time: f64| hundredths(time) as f64;
    let apart = (shown(sitting.game().time()) - shown(ann)) / 100.0;
    assert!((gap - apart).abs() < 1e-12, "{gap} s, not {apart} s behind a flight of {ann} s");
    assert!(gap < -0.4 && race.gap(&race.all()[0], split).words().starts_with('−'));
    // On the way to the goal the lead was that of the places: here those of the goal.
    let lead = race.lead(&race.all()[0], sitting.game());
    assert!(matches!(lead, Some(Gap::Seconds(lead)) if (lead - gap).abs() < 0.2), "{lead:?} and {gap} s");
    sitting.wait(2.0);
    assert_eq!(sitting.choose("Again").flight().race().unwrap().all().len(), 1);
    assert_eq!(sitting.wait(0.2).press(Key::R).flight().race().unwrap().splits(), []);
}

#[test]
fn several_are_marked_by_keys_and_by_mouse_up_to_a_limit() {
    let mut sitting = Sitting::new();
    let gold = fs::read_to_string(fixtures().join("levels/1/flights/gold.replay.csv")).unwrap();
    let scores = sitting.folder.path().join("scores");
    fs::create_dir_all(scores.join("flights/1")).unwrap();
    let rows: String = (0..14).map(|i| format!("user{i},{},,x{i}.replay.csv\n", 900 - i)).collect();
    fs::write(scores.join("1.csv"), format!("name,score,time,flight\n{rows}")).unwrap();
    fs::write(scores.join("flights/1/x0.replay.csv"), &gold).unwrap();
    sitting.choose("Levels");
    let card = sitting.area("1").centre();
    sitting.give(Input { pointer: card, right_click: true, ..Input::default() });
    assert_eq!(sitting.at(), "flights");
    assert_eq!(sitting.flights().candidates.len(), 14);
    sitting.rest();
    for line in 0..MOST_RIVALS {
        // The end of its row, below the head of that column.
        let row = Vec2::new(sitting.place("Race").x, sitting.place(&format!("user{line}")).y);
        sitting.click_at(row);
    }
    assert_eq!(sitting.flights().rivals().len(), MOST_RIVALS);
    sitting.press_all(&[Key::Down, Key::Space]);
    assert!(sitting.warning().is_some(), "one too many");
    sitting.press_all(&[Key::Up, Key::Space, Key::Home, Key::Space]);
    assert_eq!(sitting.flights().rivals().len(), MOST_RIVALS - 2);
    sitting.press(Key::End);
    assert_eq!(sitting.picked(), Some(sitting.place("user13").y));
    assert!(!sitting.shows("user0"), "it has scrolled");
    sitting.press(Key::Home).choose("Watch");
    assert_eq!(sitting.at(), "flights");
    assert!(sitting.shows("another version of the level"));
    sitting.press(Key::Down).choose("Watch");
    assert!(sitting.shows("x1.replay.csv"));
    sitting.choose("Race");
    assert_eq!(sitting.at(), "flights", "nor raced");
}

#[test]
fn a_flight_is_kept_as_a_file_and_says_where() {
    let mut sitting = flown_up(0);
    sitting.choose("Board").choose("Flights").choose("Keep as File");
    let path = sitting.flights().message().unwrap().strip_prefix("Kept as ").unwrap().to_owned();
    assert!(sitting.warning().is_none());
    let replay = Replay::parse("kept", &fs::read_to_string(&path).unwrap()).unwrap();
    assert_eq!((replay.level.as_str(), replay.outcome), ("0", Outcome::Completed));
    sitting.press(Key::Enter);
    assert_eq!(sitting.flights().message().unwrap(), format!("Kept as {path}"));
    fs::write(&path, "somebody's").unwrap();
    sitting.press(Key::Enter);
    assert_ne!(sitting.flights().message().unwrap(), format!("Kept as {path}"));
    assert_eq!(fs::read_to_string(&path).unwrap(), "somebody's");
    assert_eq!(fs::read_dir(sitting.folder.path().join("flights")).unwrap().count(), 2);
}

#[test]
fn a_flight_goes_from_one_game_to_another_as_a_code() {
    let mut one = flown_up(0);
    one.choose("Board").choose("Flights").choose("Copy Code");
    assert!(one.flights().message().unwrap().starts_with("Copied: "), "{:?}", one.flights().message());
    let code = one.app.session.clipboard.text();
    let mut other = flown_up(30);
    other.choose("Board").choose("Flights");
    let count = other.flights().candidates.len();
    let mut paste = |text: &str| {
        other.app.session.clipboard.keep(text.to_owned());
        other.choose("Paste Code");
        (other.flights().message().unwrap().to_owned(), other.flights().candidates.len() - count)
    };
    assert_eq!(paste(&format!("{code}\n")), ("Proven: Somebody".to_owned(), 1));
    assert_eq!(paste(&code).1, 1, "once is enough");
    assert!(paste("hello").0.starts_with("No code of a flight"));
    let honest = Replay::from_code(&code).unwrap();
    let (words, more) = paste(&Replay { score: honest.score + 1, ..honest.clone() }.code().unwrap());
    assert!(words.starts_with("This flight does not hold: recorded score") && more == 1, "{words}");
    assert_eq!(paste(&Replay { level: "7".to_owned(), ..honest }.code().unwrap()).0, "Proven: Somebody");
    other.choose("Race");
    assert_eq!(other.flight().race().unwrap().all().len(), 1);
}

#[test]
fn a_flight_with_help_is_not_recorded() {
    let mut sitting = Sitting::with(|root| {
        level(root, "4", HERE, "");
        fs::write(root.join("settings.csv"), "setting,value,player\nassist_fuel,on,\n").unwrap();
    });
    sitting.fly("1").wait(2.0);
    assert!(sitting.choose("Board").choose("Flights").flights().candidates.is_empty());
}

#[test]
fn a_gamepad_reaches_all_of_it() {
    let mut sitting = sitting();
    save_as(&mut sitting, "ann", 0);
    sitting.home().choose("Levels").press(Key::PadX);
    assert_eq!(sitting.at(), "flights");
    sitting.press(Key::PadX);
    assert_eq!(sitting.flights().rivals().len(), 1, "marked");
    sitting.press(Key::PadA);
    assert_eq!(sitting.at(), "watch");
    sitting.press_all(&[Key::PadA, Key::PadRight, Key::PadRight, Key::PadUp, Key::PadX]);
    assert!(stands(&sitting) && sitting.scene().overlays.details && sitting.flight().observer().pace() == 2.0);
    sitting.press_all(&[Key::PadY, Key::PadR1]);
    assert_eq!(sitting.ticks(), 120.min(sitting.flight().history().ticks()));
    assert_eq!(sitting.press(Key::PadB).at(), "flights");
    assert_eq!(sitting.press_all(&[Key::PadRight, Key::PadA]).at(), "flight");
}

#[test]
fn a_level_that_is_dropped_on_the_window_is_installed_and_chosen() {
    let mut sitting = Sitting::new();
    let zip = |name: &str, objectives: &str| {
        let elsewhere = tempfile::tempdir().unwrap();
        level(elsewhere.path(), "tower", objectives, "");
        let (package, _) = pack::gather(&elsewhere.path().join("levels/tower"), elsewhere.path()).unwrap();
        let path = sitting.folder.path().join(name);
        fs::write(&path, pack::write(&package).unwrap()).unwrap();
        path
    };
    let (first, second) = (zip("one.zip", HERE), zip("two.zip", "PLAYER,1,1,9,9\n"));
    let bad = sitting.folder.path().join("bad.zip");
    fs::write(&bad, "nothing").unwrap();
    let drop = |sitting: &mut Sitting, path: &Path| {
        sitting.give(Input { dropped: vec![path.to_owned()], ..Input::default() });
    };
    drop(&mut sitting, &first);
    assert_eq!(sitting.at(), "problems");
    assert_eq!(sitting.line("Installed"), "Installed: tower");
    sitting.press(Key::Enter).press(Key::Enter);
    assert_eq!((sitting.at(), sitting.game().level().name.as_str()), ("flight", "tower"));
    drop(&mut sitting, &second);
    assert_eq!(sitting.at(), "flight", "nobody who flies is interrupted");
    sitting.wait(1.5).press(Key::Escape);
    drop(&mut sitting, &second);
    assert_eq!(sitting.line("Installed"), "Installed: tower-2");
    drop(&mut sitting, &first);
    assert!(sitting.shows("This level is there already"));
    drop(&mut sitting, &bad);
    assert!(sitting.shows("This file cannot be opened"));
    assert_eq!(fs::read_dir(sitting.folder.path().join("levels")).unwrap().count(), 7);
}
