//! The Lab's screen without a window: its charts, its table of stress tests, two methods side by side; by mouse and by keyboard, and
//! with damaged charts.

mod charts;
mod legible;
mod side_by_side;
mod stress;

use crate::languages::faults;
use crate::sitting::Sitting;
use crate::support::shipped::{copy, project};
use charts::scene;
use resultant::draw::layout::{Area, Frame, Vec2};
use resultant::draw::{Contour, Shape};
use resultant::files::EXPERIMENTS;
use resultant::lab::charts::Charts;
use resultant::lab::drawing::plane::Plane;
use resultant::lab::kept;
use resultant::lab::savings::Saving;
use resultant::lab::stability::regions;
use resultant::level;
use resultant::number::short;
use resultant::screens::{Input, Key, Lab, PAGES, Page};
use resultant::view::theme;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

const SIZES: [(f32, f32); 5] = [(900.0, 500.0), (1280.0, 720.0), (1920.0, 1080.0), (600.0, 900.0), (2560.0, 600.0)];

/// At the Lab's charts, from the menu on, with the files of a data folder.
fn lab_with(prepare: impl FnOnce(&Path)) -> Sitting {
    let mut sitting = Sitting::with(prepare);
    sitting.choose("Lab");
    assert_eq!((sitting.at(), lab(&sitting).page), ("lab", Page::Overview));
    turn_to(&mut sitting, "Charts");
    sitting
}

fn lab_at(label: &str) -> Sitting {
    let mut sitting = lab_with(|_| {});
    turn_to(&mut sitting, label);
    sitting
}

fn turn_to(sitting: &mut Sitting, label: &str) {
    let wanted = PAGES.iter().find(|(_, known)| *known == label).expect("a tab").0;
    while lab(sitting).page != wanted {
        sitting.press(Key::Tab);
    }
}

fn lab(sitting: &Sitting) -> &Lab {
    sitting.screen()
}

fn boxes(sitting: &Sitting, of: resultant::draw::Colour) -> Vec<Area> {
    let shapes = sitting.app.canvas().shapes();
    let box_of = |shape: &Shape| match shape {
        Shape::Fill { outline: Contour::Rounded(area, _), colour } if *colour == of => Some(*area),
        _ => None,
    };
    shapes.iter().filter_map(box_of).collect()
}

fn panel(sitting: &Sitting) -> Area {
    let panels = boxes(sitting, theme::panel()).into_iter();
    panels.max_by(|a, b| a.size.element_product().total_cmp(&b.size.element_product())).expect("a panel")
}

/// The index of the name whose line in the legend is picked out.
fn picked<'n>(sitting: &Sitting, mut names: impl Iterator<Item = &'n str>) -> Option<usize> {
    let y = sitting.picked()?;
    names.position(|name| sitting.area(name).centre().y == y)
}

/// Down goes through all and to none, Up to the last; the pointer picks one while it is there, and a click for good.
fn assert_picked_in_turn(sitting: &mut Sitting, names: &[String]) {
    let picked = |sitting: &Sitting| picked(sitting, names.iter().map(String::as_str));
    assert_eq!(picked(sitting.rest()), None);
    (0..names.len()).for_each(|method| assert_eq!(picked(sitting.press(Key::Down)), Some(method)));
    assert_eq!(picked(sitting.click("Method").point_at(Vec2::ZERO)), None, "none comes after the last");
    assert_eq!(picked(sitting.press(Key::Up)), Some(names.len() - 1));
    let second = sitting.area(&names[1]).centre();
    assert_eq!(picked(sitting.point_at(second)), Some(1), "while the pointer is there");
    assert_eq!(picked(sitting.click(&names[1]).point_at(Vec2::ZERO)), Some(1), "for good");
    assert_eq!(picked(sitting.click(&names[1]).point_at(Vec2::ZERO)), None);
}

#[test]
fn the_pages_are_reached_by_key_and_by_mouse_and_left_by_esc_and_back() {
    let mut sitting = lab_at(PAGES[0].1);
    for (page, _) in PAGES.into_iter().chain([PAGES[0]]) {
        assert_eq!(lab(&sitting).page, page);
        sitting.press(Key::Tab);
    }
    for (page, label) in PAGES {
        assert_eq!(lab(sitting.click(label)).page, page);
        assert_eq!(lab_at(label).press(Key::Escape).at(), "menu");
        assert_eq!(lab_at(label).click("Back").at(), "menu");
    }
}

#[test]
fn the_pictures_of_the_first_page_lead_on() {
    let mut charts = kept::charts().unwrap();
    let most = charts.savings.iter().map(Saving::times).fold(0.0, f64::max);
    let mut sitting = lab_at("Overview");
    assert_eq!(lab(sitting.click("Where methods break")).page, Page::Stability);
    for (title, name) in [("Error against computing time", "projectile"), ("Beside Box2D and Rapier", "piles")] {
        turn_to(&mut sitting, "Overview");
        assert_eq!(lab(sitting.click(title)).page, Page::Charts);
        assert_eq!(scene(&sitting).1.name, name);
    }
    turn_to(&mut sitting, "Overview");
    assert!(sitting.shows(&format!("× {}", short(most))));
    assert!(!sitting.click("What modelling less saves").shows("Where methods break"));
    assert!(sitting.press(Key::Escape).shows("Where methods break"));
    assert_eq!(sitting.press(Key::Escape).at(), "menu");
    charts.savings.clear();
    let mut sitting = lab_with(|root| write(root, &charts, None));
    turn_to(&mut sitting, "Overview");
    assert!(!sitting.shows("What modelling less saves") && sitting.shows("Where methods break"));
}

#[test]
fn nothing_lies_on_anything_else_in_any_window() {
    for (width, height) in SIZES {
        let mut sitting = lab_with(experiments);
        sitting.frame = Frame::of_window(Vec2::new(width, height));
        for (page, label) in PAGES {
            turn_to(&mut sitting, label);
            sitting.assert_whole();
            let areas = sitting.areas();
            if page == Page::Experiments {
                let listed = level::list(&project().join(EXPERIMENTS)).len();
                assert_eq!(areas.len(), PAGES.len() + 2 + listed, "{:?}", sitting.labels());
            }
            let apart = |a: &Area, b: &Area| a.max().cmple(b.min + 0.01).any() || b.max().cmple(a.min + 0.01).any();
            let inside = |a: &Area, b: &Area| a.min.cmpge(b.min).all() && a.max().cmple(b.max()).all();
            let (panels, frame) = (boxes(&sitting, theme::panel()), sitting.frame.area());
            for panel in &panels {
                assert!(inside(panel, &frame), "{page:?} {width} × {height}: {panel:?}");
                for area in &areas {
                    // Only a legend lies in its chart's panel.
                    let legend = inside(area, panel) && matches!(page, Page::Overview | Page::Charts | Page::Stability);
                    assert!(legend || apart(panel, area), "{page:?} at {width} × {height}: {panel:?} {area:?}");
                }
            }
        }
    }
}

#[test]
fn a_region_of_stability_is_picked_out_by_key_and_by_its_line() {
    let mut sitting = lab_at("Stability");
    let regions = regions();
    let names: Vec<String> = regions.iter().map(|region| region.name.to_owned()).collect();
    assert_eq!(names.len(), 14);
    assert_picked_in_turn(&mut sitting, &names);
    // As many pixels for 1 to the right as upwards, and all of it in the panel.
    for (width, height) in SIZES {
        sitting.frame = Frame::of_window(Vec2::new(width, height));
        let plane = Plane::of(panel(sitting.rest()), &sitting.frame);
        let unit = (plane.at((1.0, 1.0)) - plane.at((0.0, 0.0))).abs();
        assert!((unit.x - unit.y).abs() < 1e-3);
        assert!(plane.area.max().x < plane.legend(0).min.x && plane.legend(names.len() + 1).max().y < plane.panel.max().y);
        assert!(plane.area.min.cmpgt(plane.panel.min).all() && plane.area.max().y < plane.panel.max().y);
    }
}

fn experiments(root: &Path) {
    copy(&project().join(EXPERIMENTS), &root.join(EXPERIMENTS));
}

#[test]
fn an_experiment_is_described_flown_and_of_no_account() {
    let mut sitting = lab_with(experiments);
    turn_to(&mut sitting, "Experiments");
    assert_eq!(sitting.focused(), "Free fall");
    sitting.press(Key::Space);
    assert!(sitting.shows("The sheet stands beside the flight") && !sitting.shows("t = √(2h/g)"), "the answer comes last");
    sitting.press(Key::Down);
    assert!(sitting.shows("docs/sheets/terminal-velocity.html"));
    let (third, title) = (sitting.areas()[PAGES.len() + 2].centre(), sitting.labels()[PAGES.len() + 2].to_owned());
    sitting.give(Input { pointer: third, click: true, ..Input::default() });
    assert!(sitting.focused() == title && sitting.shows("docs/sheets/force-mass-acceleration.html"));
    sitting.click_at(third);
    assert!(sitting.scene().overlays.details, "what acts is what it is about");
    assert_eq!(sitting.game().level().name, "force-mass-acceleration");
    assert_eq!(sitting.game().ship().fuel, 0.0, "no ship plays a part");
}

/// Writes charts into the data folder, one of its files changed.
fn write(root: &Path, charts: &Charts, changed: Option<(&str, Option<&str>)>) {
    let folder = root.join("charts");
    fs::create_dir(&folder).unwrap();
    for (name, text) in charts.files() {
        match changed {
            Some((file, None)) if file == name => {}
            Some((file, Some(other))) if file == name => fs::write(folder.join(name), other).unwrap(),
            _ => fs::write(folder.join(name), text).unwrap(),
        }
    }
}

#[test]
fn no_words_of_the_lab_lie_on_others() {
    let mut found = BTreeSet::new();
    let mut note = |sitting: &Sitting, place: String| {
        let faults = faults(sitting, &BTreeSet::new()).into_iter().filter(|fault| !fault.starts_with(['c', 'w']));
        found.extend(faults.map(|fault| format!("{place}: {fault}")));
    };
    for (width, height) in [(900.0, 500.0), (1280.0, 720.0)] {
        let at = format!("at {width} × {height}");
        let mut sitting = lab_with(experiments);
        sitting.frame = Frame::of_window(Vec2::new(width, height));
        sitting.rest();
        for number in 0..lab(&sitting).charts().diagrams.len() {
            for curve in 0..=scene(&sitting).1.curves.len() {
                note(&sitting, format!("chart {number}, curve {curve} {at}"));
                sitting.press(Key::Down).rest();
            }
            if sitting.labels().contains(&"Over time") {
                note(sitting.press(Key::Space).rest(), format!("chart {number} over time {at}"));
                sitting.press(Key::Space);
            }
            sitting.press(Key::Right).rest();
        }
        for (page, label) in PAGES {
            turn_to(&mut sitting, label);
            sitting.rest();
            let turns = if page == Page::Stability || page == Page::SideBySide { 12 } else { 1 };
            for turn in 0..turns {
                note(&sitting, format!("{label} {turn} {at}"));
                sitting.press(Key::Down).wait(0.3);
            }
        }
    }
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn a_picked_method_says_its_rule_and_what_it_uses() {
    let mut sitting = lab_with(|_| {});
    assert!(sitting.shows("As shipped: error ") && sitting.shows(" m, "), "the caption's error has its unit");
    assert!(sitting.shows("Logarithmic: equal steps"));
    sitting.press(Key::Down).rest();
    assert!(sitting.shows("x′ = x + h·v, v′ = v + h·a(x, v)") && sitting.shows("gains energy"));
    turn_to(&mut sitting, "Stability");
    assert!(sitting.shows("A point is a motion taken with a step h"), "the plane is introduced");
    sitting.press(Key::Down).rest();
    assert!(sitting.shows("x′ = x + h·v, v′ = v + h·a(x, v)"));
    turn_to(&mut sitting, "Why Euler gains");
    assert!(sitting.shows("Why Euler gains energy") && sitting.shows("leaves the circle"));
}
