//! Level folders: which load, with which contents, and which are refused with which words.
//!
//! `tests/fixtures` is a project folder of its own. Each folder in its `levels/` is one case: with a `problems.txt` it is refused
//! with exactly these lines, otherwise it loads, with exactly the lines of `warnings.txt` as its warnings (none without that file).

mod anything;
mod certain;
mod check_and_new;
mod dialects;
mod document;
mod documentation;
mod limits;
mod loading;
#[path = "../support/spreadsheets.rs"]
mod spreadsheets;
#[path = "../support/mod.rs"]
mod support;
mod varied;
mod warnings;

use resultant::level::{self, Level, Problem};
use resultant::physics::{Aabb, DVec2};
use support::shipped::{fixtures, project as package};

fn lines(problems: &[Problem]) -> String {
    problems.iter().map(|problem| format!("{problem}\n")).collect()
}

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
