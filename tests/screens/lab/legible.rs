//! Every page of the Lab as a room full of people reads it: in three languages, in a small window and with large words. No word is
//! cut, lies on another, or leaves the window or its panel.

use super::*;
use crate::languages::lines;
use resultant::words::{Language, rows, speak};

/// Windows, each with the size of its words in percent.
const ROOMS: [((f32, f32), u32); 3] = [((900.0, 500.0), 100), ((900.0, 500.0), 190), ((1280.0, 720.0), 190)];

/// Words that stand in a panel and reach beyond it.
fn beyond(sitting: &Sitting) -> Vec<String> {
    let inside = |area: &Area, of: &Area| area.min.cmpge(of.min - 1.0).all() && area.max().cmple(of.max() + 1.0).all();
    let panels = boxes(sitting, theme::panel());
    let leaves = |area: &Area| panels.iter().any(|panel| panel.gap(area) < -1.0 && !inside(area, panel));
    lines(sitting).into_iter().filter(|line| leaves(&line.area)).map(|line| format!("leaves its panel: {}", line.text)).collect()
}

/// Shows every page; `visit` gets each with its name.
fn tour(sitting: &mut Sitting, visit: &mut dyn FnMut(&Sitting, &str)) {
    let mut pages = |sitting: &mut Sitting, name: &str, turns: usize, key: Key, seconds: f64| {
        for turn in 0..turns {
            visit(sitting.wait(seconds), &format!("{name} {turn}"));
            sitting.press(key);
        }
    };
    turn_to(sitting, "Overview");
    pages(sitting, "overview", 1, Key::Down, 0.0);
    sitting.click("What modelling less saves");
    pages(sitting, "savings", 1, Key::Escape, 0.0);
    turn_to(sitting, "Charts");
    let mut told = BTreeSet::new();
    let diagrams = lab(sitting).charts().diagrams.clone();
    for measured in diagrams {
        pages(sitting, &measured.name, 1, Key::Down, 0.0);
        for curve in &measured.curves {
            if told.insert(curve.name.clone()) {
                pages(sitting, &curve.name, 1, Key::Down, 0.0);
            } else {
                sitting.press(Key::Down);
            }
        }
        if measured.over_time.is_some() {
            sitting.press(Key::Space);
            pages(sitting, &format!("{} over time", measured.name), 2, Key::Down, 0.0);
            sitting.press(Key::Space);
        }
        sitting.press(Key::Right);
    }
    turn_to(sitting, "Stability");
    pages(sitting, "stability", regions().len() + 1, Key::Down, 0.0);
    turn_to(sitting, "Stress tests");
    let tests = lab(sitting).charts().stress.len();
    pages(sitting, "stress tests", tests, Key::Down, 0.05);
    turn_to(sitting, "Side by side");
    for exhibit in 0..resultant::lab::side_by_side::exhibits().len() {
        let shown = lab(sitting).side_by_side.exhibit();
        let (methods, speed, seconds) = (shown.methods.len(), shown.speed, shown.seconds);
        pages(sitting, &format!("side by side {exhibit}"), methods, Key::D, 0.1);
        // The line below the halves is longest at the end of what runs slowly.
        if speed < 1.0 {
            pages(sitting, &format!("side by side {exhibit}, the end"), 1, Key::R, seconds / speed + 0.5);
        }
        sitting.press(Key::Down);
    }
    turn_to(sitting, "Why Euler gains");
    pages(sitting, "why Euler gains", 1, Key::Up, 0.0);
    turn_to(sitting, "Experiments");
    let listed = level::list(&project().join("experiments")).len();
    pages(sitting, "experiments", listed, Key::Down, 0.0);
}

fn assert_legible(language: Language) {
    let catalogues = [Language::German, Language::French].into_iter().flat_map(rows);
    let whole: BTreeSet<String> = catalogues.flat_map(|(english, text)| [english, text]).collect();
    let mut found = BTreeSet::new();
    for ((width, height), percent) in ROOMS {
        let settings = format!("setting,value,player\nlanguage,{},\n", language.code());
        let mut sitting = lab_with(|root| {
            experiments(root);
            fs::write(root.join("settings.csv"), settings).unwrap();
        });
        speak(language);
        sitting.frame = Frame::of_window(Vec2::new(width, height)).with_legible(percent as f32 / 100.0);
        tour(sitting.rest(), &mut |sitting, name| {
            let wrong = faults(sitting, &whole).into_iter().chain(beyond(sitting));
            found.extend(wrong.map(|fault| format!("{width} × {height}, {percent} %, {name}: {fault}")));
        });
    }
    speak(Language::English);
    assert!(found.is_empty(), "{} faults:\n{}", found.len(), found.into_iter().collect::<Vec<_>>().join("\n"));
}

#[test]
fn english_is_legible() {
    assert_legible(Language::English);
}

#[test]
fn german_is_legible() {
    assert_legible(Language::German);
}

#[test]
fn french_is_legible() {
    assert_legible(Language::French);
}
