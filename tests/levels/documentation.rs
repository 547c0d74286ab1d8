//! Tables of the documentation are those that the schema and the shipped levels make.

use crate::package;
use crate::support::shipped::{levels, load};
use resultant::game::words;
use resultant::level::schema::documentation;
use std::collections::BTreeMap;

/// The part of a page between these lines is as it is made. With `BLESS=1` in the environment the test writes it there.
fn assert_made(page: &str, [begin, end]: [&str; 2], made: &str) {
    let path = package().join(page);
    let text = std::fs::read_to_string(&path).unwrap();
    let (before, rest) = text.split_once(begin).expect("the tables begin somewhere");
    let (tables, after) = rest.split_once(end).expect("the tables end somewhere");
    if std::env::var_os("BLESS").is_some() {
        std::fs::write(&path, format!("{before}{begin}{made}{end}{after}")).unwrap();
        return;
    }
    assert!(tables == made, "{page} is stale: run `BLESS=1 cargo test --test levels documentation`");
}

#[test]
fn the_page_of_levels_has_the_tables_of_the_schema() {
    let lines = ["<!-- The tables begin. They are made of src/level/schema. -->\n", "<!-- The tables end. -->\n"];
    assert_made("docs/levels.md", lines, &format!("\n{}\n", documentation()));
}

#[test]
fn the_first_level_of_the_page_loads_without_a_warning() {
    let page = std::fs::read_to_string(package().join("docs/levels.md")).unwrap();
    let sample = page.split("A first level in ten lines").nth(1).unwrap().split("```").nth(1).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let mut files: BTreeMap<&str, String> = BTreeMap::new();
    for (file, line) in sample.trim().lines().map(|line| line.split_once(':').unwrap()) {
        *files.entry(file).or_default() += &format!("{}\n", line.trim());
    }
    files.iter().for_each(|(file, text)| std::fs::write(folder.path().join(file), text).unwrap());
    let loaded = resultant::level::load(folder.path(), package()).unwrap();
    assert!(sample.trim().lines().count() == 10 && loaded.warnings.is_empty(), "{:?}", loaded.warnings);
    assert_eq!((loaded.level.title.as_str(), loaded.level.world.len()), ("Over the wall", 2));
}

#[test]
fn the_page_about_playing_has_the_medals_of_the_shipped_levels() {
    let row = |name: &String| {
        let level = load(name);
        let (awards, time) = (&level.awards, |limit: Option<f64>| limit.map_or_else(String::new, |limit| format!("{limit} s")));
        let mark = awards.mark.map_or_else(String::new, words);
        format!("| {name} {} | {} | {} | {mark} |\n", level.title, time(awards.silver), time(awards.gold))
    };
    let rows: String = levels().iter().map(row).collect();
    assert_made("docs/playing.md", ["| level | silver | gold | mark |\n|---|---|---|---|\n", "\nEach of these"], &rows);
}
