//! Every screen in every language: no word passes by the catalogues, and neither in a small window nor where words are large is one cut,
//! out of its box or on another.

use crate::sitting::Sitting;
use resultant::draw::layout::{Area, Frame};
use resultant::draw::{Contour, Shape, Style, Typeface};
use resultant::screens::{Input, Key, Places, Stack};
use resultant::settings::Settings;
use resultant::words::{Language, rows, speak, tr};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// A line of text with its box; lines of one layer are compared.
#[derive(Clone, Debug)]
pub struct Line {
    pub text: String,
    style: Style,
    pub area: Area,
    layer: usize,
}

pub fn lines(sitting: &Sitting) -> Vec<Line> {
    let canvas = sitting.app.canvas();
    let mut layer = 0;
    let mut found = Vec::new();
    for shape in canvas.shapes().iter() {
        match shape {
            Shape::Layer => layer += 1,
            Shape::Text { text, at, style } => {
                let from = canvas.baseline(text, *at, *style);
                let height = canvas.glyph_height(style.size) * canvas.frame().pixel;
                let area = Area::new(from.x, from.y - 0.7 * height, canvas.width(text, *style), 0.85 * height);
                found.push(Line { text: text.clone(), style: *style, area, layer });
            }
            _ => {}
        }
    }
    found
}

/// The edges of panels and buttons, each with its layer.
fn boxes(sitting: &Sitting) -> Vec<(usize, Area)> {
    let mut layer = 0;
    let mut found = Vec::new();
    for shape in sitting.app.canvas().shapes().iter() {
        match shape {
            Shape::Layer => layer += 1,
            Shape::Edge { outline: Contour::Rounded(area, _), .. } => found.push((layer, *area)),
            _ => {}
        }
    }
    found
}

/// The game's own levels, experiments and charts, with scores of its own.
fn shipped(settings: &str) -> Sitting {
    let (folder, root) = (tempfile::tempdir().unwrap(), Path::new(env!("CARGO_MANIFEST_DIR")).to_path_buf());
    fs::write(folder.path().join("settings.csv"), settings).unwrap();
    let settings = folder.path().join("settings.csv");
    let app = Stack::new(Places { levels: root.join("levels"), scores: folder.path().join("scores"), settings, root });
    let mut sitting = Sitting { app, frame: Frame::default(), folder, open: true };
    sitting.rest();
    sitting
}

fn own(settings: &str) -> Sitting {
    Sitting::with(|root| fs::write(root.join("settings.csv"), settings).unwrap())
}

/// Shows every screen in a language and a window; `visit` gets each with its name.
fn tour(language: Language, frame: Frame, visit: &mut dyn FnMut(&mut Sitting, &str)) {
    let settings = format!("setting,value,player\nlanguage,{},\n", language.code());
    let begin = |sitting: &mut Sitting| {
        speak(language);
        sitting.frame = frame;
        sitting.rest();
    };
    let visit = &mut |sitting: &mut Sitting, name: &str| {
        speak(language);
        sitting.rest();
        visit(sitting, name);
    };
    let mut sitting = shipped(&settings);
    begin(&mut sitting);
    menus(&mut sitting, visit);
    lab(&mut sitting, visit);
    flight(&mut sitting, visit);
    let mut sitting = own(&settings);
    begin(&mut sitting);
    scores(&mut sitting, visit);
    editor(&mut sitting, visit);
    speak(Language::English);
}

fn menus(sitting: &mut Sitting, visit: &mut dyn FnMut(&mut Sitting, &str)) {
    visit(sitting, "menu");
    visit(sitting.choose("Levels"), "level select");
    (0..4).for_each(|_| visit(sitting.press(Key::PageDown), "level select"));
    visit(sitting.write("zzz"), "level select, nothing found");
    visit(sitting.home().choose("Editor"), "levels to edit");
    visit(sitting.choose("New"), "a new level");
    sitting.press(Key::Escape);
    visit(sitting.choose("Copy"), "a copy");
    visit(sitting.press(Key::Escape).choose("Rename"), "another name");
    visit(sitting.press_all(&[Key::Escape, Key::Escape, Key::Escape]).choose("Boards"), "leaderboards");
    visit(sitting.choose("1"), "an empty board");
    visit(sitting.press_all(&[Key::Escape, Key::Escape]).choose("Players"), "new player or players");
    visit(sitting.write("1x").press(Key::Enter), "a name that is refused");
    visit(sitting.press(Key::Escape).press(Key::Escape).choose("Settings"), "settings");
    visit(sitting.press_all(&[Key::Tab, Key::Enter]), "a key to press");
    visit(sitting.press(Key::Escape).click("All keys"), "all keys");
    visit(sitting.press_all(&[Key::Escape]).choose("Credits"), "credits");
    visit(sitting.press(Key::PageDown), "credits, further down");
    sitting.press(Key::Escape).choose("Classics");
    for label in ["Tile Run", "Jumper", "π from Collisions"] {
        visit(sitting, "classics");
        visit(sitting.choose(label).wait(0.3), label);
        if label == "Jumper" {
            visit(sitting.choose("One Player").wait(0.2), "a climb");
            visit(sitting.press(Key::Escape), "a climb that pauses");
            sitting.choose("Back");
        } else {
            sitting.press(Key::Escape);
        }
        sitting.press(Key::Down);
    }
    sitting.press(Key::Escape);
}

fn lab(sitting: &mut Sitting, visit: &mut dyn FnMut(&mut Sitting, &str)) {
    visit(sitting.choose("Lab"), "the Lab");
    sitting.click("Charts");
    for _ in 0..34 {
        visit(sitting, "charts");
        sitting.press(Key::Right);
    }
    visit(sitting.click("Stability").wait(0.1), "stability");
    sitting.click("Stress tests");
    for _ in 0..8 {
        visit(sitting.wait(0.2), "stress tests");
        sitting.press(Key::PageDown);
    }
    sitting.click("Side by side");
    for _ in 0..6 {
        visit(sitting.rest(), "side by side");
        sitting.press(Key::Down);
    }
    sitting.click("Experiments");
    for _ in 0..14 {
        visit(sitting, "experiments");
        sitting.press(Key::Down);
    }
    visit(sitting.press(Key::Enter).wait(0.3), "an experiment");
    visit(sitting.press(Key::Escape), "its pause");
    visit(sitting.choose("Back to experiments").press(Key::Up), "experiments");
    visit(sitting.press(Key::Enter).wait(0.3).click("Save"), "a sheet without a prediction");
    visit(sitting.press(Key::K), "a free-body picture");
    sitting.press(Key::Escape).click("Main Menu");
}

fn flight(sitting: &mut Sitting, visit: &mut dyn FnMut(&mut Sitting, &str)) {
    visit(sitting.fly("1").wait(0.5), "flight");
    visit(sitting.press(Key::Tab).wait(0.3), "forces");
    visit(sitting.press(Key::B).rest(), "frozen");
    sitting.press(Key::B).press(Key::I);
    for tool in ["Centre of mass", "Trails", "v and a", "Ruler", "Energy, work"] {
        sitting.click(tool);
    }
    visit(sitting.wait(0.3), "instruments");
    visit(sitting.click("What if …").wait(0.2), "what if");
    visit(sitting.click("What if …").click("Plot").wait(0.3), "a plot");
    visit(sitting.press(Key::I).press(Key::Escape), "pause");
    visit(sitting.choose("Settings"), "settings in flight");
    visit(sitting.press(Key::Escape).choose("Level Select").press(Key::PageDown), "level select");
    sitting.press(Key::Escape).choose("Levels").press(Key::Tab);
    visit(sitting.rest(), "flights");
    visit(sitting.choose("Watch").wait(0.3), "watching");
    visit(sitting.press(Key::Tab).wait(1.0), "watching, with forces");
    visit(sitting.press(Key::Escape).choose("Race").wait(0.3), "a race");
    sitting.press(Key::Escape).choose("Main Menu");
}

fn scores(sitting: &mut Sitting, visit: &mut dyn FnMut(&mut Sitting, &str)) {
    visit(sitting.complete(), "a score");
    visit(sitting.choose("Save Score"), "a name for it");
    visit(sitting.write("ann").press(Key::Enter).wait(0.6), "a score with a name");
    visit(sitting.choose("Board"), "its board");
    sitting.home();
    visit(sitting.fly("3").wait(0.1), "a loss");
    visit(sitting.press(Key::Enter).wait(0.5), "a lost attempt");
    visit(sitting.choose("Board").rest(), "a board");
    visit(sitting.choose("Flights").rest(), "flights");
    sitting.home();
    visit(sitting.choose("Players"), "players");
    visit(sitting.press(Key::Escape).choose("Levels").choose("broken"), "problems");
    sitting.press_all(&[Key::Escape, Key::Escape]);
}

fn editor(sitting: &mut Sitting, visit: &mut dyn FnMut(&mut Sitting, &str)) {
    visit(sitting.choose("Editor").choose("2").rest(), "editor");
    visit(sitting.press_all(&[Key::Control]).click("Switch").rest(), "editor");
    let ship = sitting.editor().point(resultant::physics::DVec2::new(400.0, 300.0));
    visit(sitting.click("Select").click_at(ship), "editor, the ship");
    visit(sitting.click("Delete"), "editor, the ship stays");
    visit(sitting.click("Snap").click("Fly").wait(0.2), "a test flight");
    visit(sitting.press(Key::Escape), "editor, a flight above the picture");
    visit(sitting.press(Key::Escape), "editor, to be left");
    visit(sitting.press(Key::Enter), "levels to edit");
    visit(sitting.click("Delete").click("3").rest(), "a level in the bin");
    visit(sitting.click("Share").click("2").rest(), "problems");
    visit(sitting.press(Key::Escape).click("Import"), "a file to be imported");
    sitting.press(Key::Escape);
}

/// Words that no catalogue holds: units, names, files and columns, licences.
const DATA: &str = "ann Guest Resultant broken copy csv CSV SVG zip kg km mm cm px ms ns kN mN kJ mJ Mt kt mg rad fps tick Hz Box Rapier \
    with MIT Apache Unlicense ISC Ubuntu Font Licence Bitstream Vera vx vy LEFT RIGHT JUMP WAIT \
    sin kin pot mech English Deutsch linux debug release dev worker Xeon GHz Num zzz or";

fn plain_words(text: &str) -> Vec<&str> {
    let words = text.split(|letter: char| !letter.is_ascii_alphanumeric());
    words.filter(|word| word.len() > 1 && word.chars().all(|letter| letter.is_ascii_alphabetic())).collect()
}

#[test]
fn every_word_of_every_screen_comes_from_a_catalogue() {
    let mut missing = BTreeSet::new();
    tour(Language::Wide, Frame::default(), &mut |sitting, name| {
        for line in lines(sitting) {
            let is_file = line.text.contains("ｄｏｃｓ/") || line.text.contains(".csv") || name == "problems";
            // Columns of files and their cells, the text of a licence, the machine that a chart was measured on.
            let is_data = line.style.face == Typeface::Mono && (name.starts_with("editor") || name.starts_with("credits"));
            let is_data = is_data || is_file || name == "charts" && line.style.size < 14.0;
            let words = plain_words(&line.text);
            if !is_data && words.iter().any(|word| !DATA.split(' ').any(|known| known == *word)) {
                missing.insert(format!("{name}: {}", line.text));
            }
        }
    });
    assert!(missing.is_empty(), "{} texts pass by the catalogues: {missing:#?}", missing.len());
}

/// What is wrong with the lines of a screen: cut, outside of the window, on one another or across the edge of a button.
pub fn faults(sitting: &Sitting, whole: &BTreeSet<String>) -> Vec<String> {
    let (all, boxes, frame) = (lines(sitting), boxes(sitting), sitting.frame.area());
    let texts = all.iter().map(|line| line.text.trim()).collect::<Vec<_>>().join(" ");
    let mut found = Vec::new();
    let inside = |area: &Area, of: &Area| area.min.x >= of.min.x - 1.0 && area.max().x <= of.max().x + 1.0;
    for (i, line) in all.iter().enumerate() {
        // Digits of π, and what stands in whole in a place of its own.
        let begin = line.text.trim_end_matches('…');
        let elsewhere = line.text.starts_with("π = ") || texts.matches(begin).count() > 1;
        if line.text.ends_with('…') && !elsewhere && !whole.contains(&line.text) {
            found.push(format!("cut: {}", line.text));
        }
        let visible = frame.gap(&line.area) < 0.0;
        let high = line.area.min.y < frame.min.y - 1.0 || line.area.max().y > frame.max().y + 1.0;
        if visible && (high || !inside(&line.area, &frame)) {
            found.push(format!("leaves the window: {}", line.text));
        }
        for other in all[i + 1..].iter().filter(|other| other.layer == line.layer) {
            if line.area.gap(&other.area) < -1.0 {
                found.push(format!("on one another: {} | {}", line.text, other.text));
            }
        }
        let mut around = boxes.iter().filter(|(layer, area)| *layer == line.layer && area.contains(line.area.centre()));
        if around.any(|(_, area)| {
            area.max().y + 1.0 < line.area.max().y || area.min.y - 1.0 > line.area.min.y || !inside(&line.area, area)
        }) {
            found.push(format!("out of its box: {}", line.text));
        }
    }
    let widgets = sitting.app.memory.widgets();
    for (i, widget) in widgets.iter().enumerate() {
        if !frame.contains(widget.area.min) || widget.area.max().cmpgt(frame.max() + 0.5).any() {
            found.push(format!("leaves the window: button {}", widget.label));
        }
        let within = |a: &Area, b: &Area| a.min.cmpge(b.min).all() && a.max().cmple(b.max()).all();
        let apart = |a: &Area, b: &Area| a.gap(b) > -0.5 || within(a, b) || within(b, a);
        for other in widgets[i + 1..].iter().filter(|other| !apart(&widget.area, &other.area)) {
            found.push(format!("on one another: buttons {} | {}", widget.label, other.label));
        }
    }
    found
}

/// The windows that each stop of a tour is shown in, pixels, and the interface's scale there, percent.
const SHOWN: [((f32, f32), u8); 3] = [((900.0, 500.0), 100), ((1280.0, 720.0), 190), ((900.0, 500.0), 190)];

/// All that a catalogue holds may end with an ellipsis.
pub fn whole(language: Language) -> BTreeSet<String> {
    let all = rows(Language::German).into_iter().chain(rows(language));
    all.flat_map(|(english, text)| [english, text]).collect()
}

/// What is wrong with a screen in each of those windows.
pub fn faults_in_windows(sitting: &mut Sitting, name: &str, whole: &BTreeSet<String>) -> Vec<String> {
    let (before, mut found) = (sitting.frame, Vec::new());
    for (size, scale) in SHOWN {
        let window = Frame::of_window(size.into());
        sitting.frame = sitting.app.screen().with_words(window, &Settings { scale, ..*sitting.app.settings() });
        for _ in 0..2 {
            sitting.give(Input { frame_time: 1e-6, ..Input::default() });
        }
        let small = lines(sitting).into_iter().filter(|line| scale == 190 && sitting.frame.text_height(line.style.size) < 23.0);
        let small: Vec<String> = small.map(|line| format!("small: {}", line.text)).collect();
        let all = faults(sitting, whole).into_iter().chain(small);
        found.extend(all.map(|fault| format!("{name}, {} px, {scale} %: {fault}", size.0)));
    }
    sitting.frame = before;
    sitting.rest();
    found
}

fn assert_fits(language: Language) {
    let (whole, mut found) = (whole(language), BTreeSet::new());
    tour(language, Frame::default(), &mut |sitting, name| {
        // The Lab's charts leave out what has no room.
        if sitting.at() != "lab" {
            found.extend(faults_in_windows(sitting, name, &whole));
        }
    });
    assert!(found.is_empty(), "{} faults:\n{}", found.len(), found.into_iter().collect::<Vec<_>>().join("\n"));
}

#[test]
fn english_fits_in_small_windows_and_large_words() {
    assert_fits(Language::English);
}

#[test]
fn german_fits_in_small_windows_and_large_words() {
    assert_fits(Language::German);
}

#[test]
fn french_fits_in_small_windows_and_large_words() {
    assert_fits(Language::French);
}

#[test]
fn a_language_holds_at_once_and_after_the_game_was_closed() {
    let mut sitting = Sitting::new();
    sitting.choose("Settings").press_all(&[Key::Down; 4]);
    assert!(sitting.focused() == "Language" && sitting.shows("English"));
    sitting.press(Key::Right);
    assert!(sitting.shows("Deutsch") && sitting.shows("Einstellungen"));
    assert!(sitting.reopen().shows("Spielen"));
    assert_eq!(tr("Play"), "Spielen");
    sitting.choose("Settings").click("Defaults").home();
    assert!(sitting.shows("Play"));
}
