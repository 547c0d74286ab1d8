//! The printable sheets, and what their words say beside the tables.

use super::{EXPERIMENTS, G, ropes, sheet};
use crate::support::shipped::project;
use resultant::files;
use resultant::physics::Material;
use std::collections::BTreeSet;

#[test]
fn each_language_has_every_sheet_and_a_sheet_needs_nothing_else() {
    let pages = sheets::pages(project(), true).unwrap();
    let of_an_experiment = |(name, _): (&str, _)| [format!("{name}.html"), format!("{name}-answers.html")];
    let files: Vec<String> = EXPERIMENTS.into_iter().flat_map(of_an_experiment).chain(["index.html".to_owned()]).collect();
    let wanted = ["", "de/", "fr/"].into_iter().flat_map(|language| files.iter().map(move |file| format!("{language}{file}")));
    assert_eq!(pages.iter().map(|(name, _)| name.clone()).collect::<BTreeSet<_>>(), wanted.collect());
    for (name, text) in pages {
        for outside in ["http", "src=", "<script", "<link", "@import", "url("] {
            assert!(!text.contains(outside), "{name}: {outside}");
        }
        // Links lead to other sheets, or into the game's page two folders above the English ones.
        let folder = name.matches('/').count();
        for link in text.split("href=\"").skip(1).filter_map(|rest| rest.split('"').next()) {
            let into = format!("{}index.html#play=experiments/", "../".repeat(2 + folder));
            let known = link.strip_prefix(&into).is_some_and(|name| EXPERIMENTS.iter().any(|(known, _)| *known == name));
            assert!(known || link.ends_with(".html"), "{name}: {link}");
        }
        // German and French have decimal commas in all that is no code.
        let plain = |text: &str| text.split("<code>").map(|part| part.rsplit("</code>").next().unwrap()).collect::<String>();
        let body = text.split("<body>").nth(1).unwrap();
        let marks = |mark: char| {
            let words = plain(body);
            let letters: Vec<char> = words.chars().collect();
            letters.windows(3).filter(|w| w[0].is_ascii_digit() && w[1] == mark && w[2].is_ascii_digit()).count()
        };
        let wrong = if folder == 0 { ',' } else { '.' };
        assert_eq!(marks(wrong), 0, "{name}: numbers with {wrong:?}");
    }
    let linked = |with: bool| sheets::pages(project(), with).unwrap().iter().filter(|(_, text)| text.contains("#play=")).count();
    assert_eq!((linked(true), linked(false)), (3 * (2 * EXPERIMENTS.len() + 1), 0));
}

#[test]
fn the_lessons_are_listed_by_topic_with_what_a_plan_needs() {
    let listed = std::fs::read_to_string(project().join(sheets::LESSONS)).unwrap();
    assert!(listed == sheets::lessons(project()).unwrap(), "cargo run -p sheets writes the list");
    for (name, _) in EXPERIMENTS {
        let text = sheet::text(name);
        let sheets::Plan { topic, age, minutes, needed, curricula } = sheet::lesson(&text).plan;
        assert!(listed.contains(&format!("\n## {topic}\n")) && !needed.is_empty(), "{name}");
        let (young, old) = age.split_once('–').unwrap();
        assert!((11..18).contains(&young.parse().unwrap()) && young < old, "{name}: {age}");
        assert!((15..=45).contains(&minutes.parse().unwrap()), "{name}: {minutes}");
        let marks = [&["KS3", "KS4"][..], &["Sek I"], &["cycle 4", "seconde", "terminale"]];
        for (text, marks) in curricula.iter().zip(marks) {
            assert!(marks.iter().any(|mark| text.contains(mark)), "{name}: {text}");
        }
        assert!(sheet::lesson(&text).misconceptions.len() >= 2, "{name}");
    }
}

#[test]
fn a_sheet_names_its_experiment_and_each_step_its_keys_but_no_answer() {
    let pages = sheets::pages(project(), true).unwrap();
    for (name, _) in EXPERIMENTS {
        let text = sheet::text(name);
        let lesson = sheet::lesson(&text);
        assert_eq!(lesson.title, sheet::level(name, "").title, "{name}");
        for step in &lesson.steps {
            let named = step.split('`').skip(1).step_by(2).filter(|key| sheets::is_key(key)).count();
            assert!(named > 0, "{name}: which key? {step}");
        }
        let (_, page) = pages.iter().find(|(file, _)| *file == format!("{name}.html")).unwrap();
        let asked = sheets::listed(project()).unwrap().into_iter().find(|asked| asked.folder == name).unwrap();
        let choices = asked.choices.split('|').filter(|choice| !choice.is_empty()).map(|choice| format!("☐ {choice}"));
        for words in choices.chain([asked.question.clone()]) {
            assert!(page.contains(&words), "{name}: the screen asks {words:?}");
        }
        let answers = lesson.answer.iter().chain(&lesson.teacher);
        for said in answers.flat_map(|paragraph| paragraph.split(['`', '*', '<', '&'])).filter(|part| part.len() > 20) {
            assert!(!page.contains(said), "{name}: {said}");
        }
    }
}

/// Numbers in words: digits with decimals, without those of formulas.
fn numbers(words: &str) -> Vec<String> {
    let plain: String = words.split('`').step_by(2).collect();
    let parts = plain.split(|c: char| !c.is_ascii_digit() && c != '.').map(|part| part.trim_matches('.'));
    parts.filter(|part| !part.is_empty()).map(str::to_owned).collect()
}

/// Each number in the words of a sheet is one of its level, of a figure that a test flies, or one that follows from them.
#[test]
fn every_number_in_the_words_of_a_sheet_is_one_of_its_level_or_of_its_figures() {
    for (name, figures) in EXPERIMENTS {
        let (text, figures) = (sheet::text(name), figures());
        let lesson = sheet::lesson(&text);
        let tables = std::fs::read_dir(project().join(files::EXPERIMENTS).join(name)).unwrap();
        let mut known: Vec<f64> = Vec::new();
        let mut read = |text: &str| known.extend(numbers(text).iter().filter_map(|number| number.parse::<f64>().ok()));
        tables.for_each(|table| read(&std::fs::read_to_string(table.unwrap().path()).unwrap()));
        figures.iter().for_each(|figure| read(&figure.what));
        known.extend(figures.iter().flat_map(|figure| [figure.exact, 100.0 * figure.exact]));
        let floors = [Material::STEEL, Material::WOOD, Material::ASPHALT];
        match name {
            "free-fall" => {
                known.extend(figures.iter().filter(|f| f.what == "any, speed at the floor").map(|f| f.exact * f.exact / (2.0 * G)))
            }
            "friction" | "wind-and-friction" => {
                known.extend(floors.iter().flat_map(|floor| [floor.static_friction, floor.kinetic_friction]))
            }
            // The other angle of the same sine.
            "projectile" => known.push(180.0 - 60.0),
            // By how much a swing is longer than a small one, %.
            "pendulum" => known.extend([10.0, 60.0].map(|angle| (1e4 * (ropes::longer(angle) - 1.0)).round() / 100.0)),
            // A spring without a load, and half a ball.
            "hooke" => known.push(3.0 + 0.5),
            _ => {}
        }
        let words = lesson.steps.iter().chain(&lesson.answer).chain(&lesson.teacher).chain(&lesson.misconceptions);
        let words = words.chain([&lesson.question]);
        for number in words.flat_map(|words| numbers(words)) {
            let value: f64 = number.parse().unwrap();
            assert!(known.iter().any(|known| (known.abs() - value).abs() < 1e-9), "{name}: {number} of {known:?}");
        }
    }
}
