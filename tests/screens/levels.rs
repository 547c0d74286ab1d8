//! The list of levels, also where levels are broken or missing.

use crate::sitting::{FAR_AWAY, Sitting, level};
use resultant::draw::Image;
use resultant::game::{Medal, Medals};
use resultant::screens::Key;
use std::fs;
use std::path::Path;

#[test]
fn levels_are_listed_in_numeric_order_on_cards_that_fill_the_page() {
    let mut sitting = Sitting::new();
    sitting.choose("Levels").rest();
    let names = sitting.level_names();
    assert_eq!(names, ["1", "2", "3", "10", "broken"]);
    let cards = names.iter().map(|name| sitting.area(name)).collect::<Vec<_>>();
    let share = cards.iter().map(|card| card.size.element_product()).sum::<f32>() / (1280.0 * 720.0);
    assert!(share > 0.5, "five cards fill {share} of the window");
    assert!(cards.iter().all(|card| card.size == cards[0].size));
    let marked: Vec<bool> = sitting.level_select().entries.iter().map(|entry| entry.level.as_ref().unwrap().is_err()).collect();
    assert_eq!(marked, [false, false, false, false, true]);
}

#[test]
fn the_list_comes_back_where_it_was_left() {
    let mut sitting = Sitting::new();
    sitting.fly("10").press_all(&[Key::Escape, Key::Down, Key::Down, Key::Down, Key::Enter]);
    assert_eq!((sitting.at(), sitting.focused()), ("level select", "10"));
}

#[test]
fn more_than_fifteen_levels_make_pages() {
    let many = |root: &Path| (20..40).for_each(|i| level(root, &i.to_string(), FAR_AWAY, ""));
    let mut sitting = Sitting::with(many);
    sitting.choose("Levels").rest();
    let shown = |sitting: &Sitting| (sitting.line("Page "), sitting.labels().len());
    let (first, last) = ("Page 1 of 2".to_owned(), "Page 2 of 2".to_owned());
    assert_eq!(shown(&sitting), (first.clone(), 15 + 3), "a page, Back, Previous and Next");
    sitting.press(Key::PageUp);
    assert_eq!(shown(&sitting), (first.clone(), 18), "no page before the first");
    sitting.choose("Next").rest();
    assert_eq!(shown(&sitting), (last.clone(), 10 + 3));
    sitting.click("Next").press(Key::PageDown);
    assert_eq!(shown(&sitting), (last, 13), "no page after the last");
    assert_eq!(sitting.labels()[0], "31", "the sixteenth level of the list");
    assert_eq!(sitting.choose("31").flown(), "31");
    sitting.press(Key::Escape).click("Level Select").press(Key::PageUp).press(Key::PageDown).click("Previous").rest();
    assert_eq!(shown(&sitting).0, first);
}

#[test]
fn a_level_that_does_not_load_shows_its_problems_and_closes_nothing() {
    for by_mouse in [true, false] {
        let mut sitting = Sitting::new();
        sitting.choose("Levels");
        let at = if by_mouse { sitting.click("broken").at() } else { sitting.choose("broken").at() };
        assert_eq!(at, "problems");
        assert!(sitting.shows("obstacles.csv:1: column \"width\": found \"wide\""), "{:?}", sitting.texts());
        sitting.press(Key::Enter);
        assert_eq!(sitting.at(), "level select", "Enter closes the panel and does not open it again");
        sitting.choose("broken").press(Key::Escape);
        assert_eq!(sitting.at(), "level select");
        assert_eq!(sitting.press(Key::Escape).at(), "menu");
    }
}

#[test]
fn a_broken_level_met_on_the_way_lands_on_level_select_with_its_problems() {
    let mut sitting = Sitting::with(|root| {
        fs::remove_dir_all(root.join("levels/2")).unwrap();
        level(root, "2", FAR_AWAY, "nonsense\n");
    });
    sitting.complete().choose("Next");
    assert_eq!(sitting.at(), "problems");
    assert!(sitting.shows("Level 2 does not load"));
    let mut sitting = Sitting::new();
    sitting.choose("Levels");
    fs::remove_dir_all(sitting.folder.path().join("levels/1")).unwrap();
    assert_eq!(sitting.choose("1").at(), "problems");
}

#[test]
fn without_levels_nothing_breaks() {
    let mut sitting = Sitting::with(|root| fs::remove_dir_all(root.join("levels")).unwrap());
    assert_eq!(sitting.choose("Play").at(), "level select", "there is nothing to play");
    assert!(sitting.level_select().entries.is_empty());
    assert_eq!((sitting.labels()[0], sitting.shows("There are no levels here yet.")), ("Back", true));
    assert_eq!(sitting.click("Back").at(), "menu");
}

#[test]
fn a_card_shows_the_level_and_what_the_player_has_reached_there() {
    let mut sitting = Sitting::new();
    sitting.complete().press(Key::Escape);
    let entries = &sitting.level_select().entries;
    assert!(entries[0].best.is_some_and(|best| best < 0.1) && entries[0].medals.medal == Some(Medal::Bronze));
    assert_eq!((entries[1].best, entries[1].medals.medal), (None, None));
    let Some(Ok((_, Some(Image::Painted(painting))))) = &entries[2].level else { panic!("it is not painted") };
    let shows = |of: fn(&[u8]) -> bool| painting.bytes.chunks(4).filter(|pixel| of(pixel)).count() > 4;
    assert!(shows(|pixel| pixel[0] > 180 && pixel[1] < 110), "a death box is red");
    assert!(shows(|pixel| pixel[0] > 200 && pixel[1] > 150 && pixel[2] < 110), "the ship's goal is yellow");
}

#[test]
fn medals_are_in_the_scoring_and_on_the_card() {
    let mut sitting = Sitting::with(|root| {
        let constants = "width,800\nheight,600\noptimal_time,10\nsilver,5\ngold,0.001\nmark_hits,0\n";
        fs::write(root.join("levels/1/constants.csv"), constants).unwrap();
        fs::create_dir_all(root.join("scores")).unwrap();
        fs::write(root.join("scores/players.csv"), "player,level,time,medal,mark\nann,,\nann,1,4\n").unwrap();
    });
    let silver = Medals { medal: Some(Medal::Silver), mark: false };
    sitting.press_all(&[Key::Down, Key::Enter]);
    assert_eq!(sitting.level_select().entries[0].medals, silver, "what the old time is worth now");
    sitting.home().complete();
    let texts = sitting.texts();
    assert_eq!(texts.iter().filter(|(text, _)| text == "earned").count(), 3, "{texts:?}");
    assert!(sitting.row("within 0.001 s")[1].ends_with("s too slow"));
    assert!(sitting.scores_file("players.csv").starts_with("player,level,time,medal,mark\nann,,,,\nann,1,0.0"));
    assert!(sitting.scores_file("players.csv").contains(",silver,TRUE\n"), "{}", sitting.scores_file("players.csv"));
}

#[test]
fn typing_finds_levels_by_name_and_title() {
    let mut sitting = Sitting::with(|root| {
        (20..60).for_each(|i| level(root, &format!("lev{i}"), FAR_AWAY, ""));
        fs::write(root.join("levels/lev57/constants.csv"), "width,800\nheight,600\ntitle,The Great Mill\n").unwrap();
    });
    sitting.choose("Levels");
    let shown = |sitting: &Sitting| -> Vec<String> {
        sitting.level_select().in_view().into_iter().map(|index| sitting.level_names()[index].to_owned()).collect()
    };
    sitting.write("Great m").rest();
    assert_eq!(shown(&sitting), ["lev57"]);
    assert_eq!(sitting.press(Key::Enter).flown(), "lev57");
    sitting.press(Key::Escape).click("Level Select").write("v3").rest();
    assert_eq!(shown(&sitting).len(), 10);
    sitting.press(Key::Backspace);
    assert_eq!(shown(&sitting).len(), 15, "what has a v");
    assert_eq!(sitting.press(Key::Escape).at(), "level select", "Esc lets all be found again");
    assert_eq!(shown(&sitting)[0], "1");
    sitting.write("no such");
    assert!(shown(&sitting).is_empty());
    assert_eq!(sitting.press_all(&[Key::Escape, Key::Escape]).at(), "menu");
}

#[test]
fn an_error_is_never_stale() {
    let mut sitting = Sitting::new();
    sitting.choose("Levels").click("broken");
    assert_eq!(sitting.at(), "problems");
    sitting.press(Key::Escape);
    fs::write(sitting.folder.path().join("levels/broken/obstacles.csv"), "").unwrap();
    sitting.wait(0.7);
    assert!(sitting.level_select().entries[4].level.as_ref().unwrap().is_ok());
    fs::write(sitting.folder.path().join("levels/broken/obstacles.csv"), "1,2,wide,3\n").unwrap();
    assert_eq!(sitting.click("broken").at(), "problems");
    sitting.press(Key::Escape);
    fs::write(sitting.folder.path().join("levels/broken/obstacles.csv"), "").unwrap();
    assert_eq!(sitting.click("broken").at(), "flight");
}

#[test]
fn five_thousand_levels_are_listed_without_reading_them() {
    let mut sitting = Sitting::with(|root| (0..5000).for_each(|i| fs::create_dir(root.join(format!("levels/many{i}"))).unwrap()));
    sitting.choose("Levels").rest();
    let known = |sitting: &Sitting| sitting.level_select().entries.iter().filter(|entry| entry.level.is_some()).count();
    assert_eq!((sitting.level_select().entries.len(), known(&sitting)), (5005, 15));
    sitting.press(Key::PageDown).rest();
    assert_eq!(known(&sitting), 30);
}

#[test]
fn levels_are_made_copied_and_renamed_in_the_game() {
    let mut sitting = Sitting::new();
    let levels = sitting.folder.path().join("levels");
    sitting.choose("Editor");
    assert_eq!(sitting.at(), "levels to edit");
    sitting.click("New").write("a b").press(Key::Enter);
    assert!(sitting.shows("expected up to 40 letters"));
    sitting.press_all(&[Key::Backspace, Key::Backspace, Key::Backspace]).write("2").press(Key::Enter);
    assert!(sitting.shows("of that name already"), "2 is there");
    sitting.write("x").press(Key::Enter);
    assert_eq!((sitting.at(), sitting.editor().name()), ("editor", "2x"));
    assert_eq!(sitting.press_all(&[Key::Escape, Key::Enter]).at(), "levels to edit");
    sitting.click("Copy").click("2").press(Key::Enter);
    assert_eq!((sitting.at(), sitting.editor().name()), ("editor", "2-copy"));
    assert_eq!(fs::read(levels.join("2-copy/player.csv")).unwrap(), fs::read(levels.join("2/player.csv")).unwrap());
    sitting.press_all(&[Key::Escape, Key::Enter]);
    assert_eq!(sitting.level_names(), ["1", "2", "3", "10", "2-copy", "2x", "broken"]);
    sitting.click("Rename").click("2-copy").press(Key::End);
    (0..6).for_each(|_| _ = sitting.press(Key::Backspace));
    sitting.write("second").press(Key::Enter);
    assert_eq!(sitting.at(), "levels to edit");
    assert!(levels.join("second/player.csv").exists() && !levels.join("2-copy").exists());
    assert_eq!(sitting.level_names(), ["1", "2", "3", "10", "2x", "broken", "second"]);
}
