//! The Lab's screen without a window: its charts, its table of stress tests, two methods side by side; by mouse and by keyboard, and
//! with damaged charts.

use crate::sitting::Sitting;
use crate::support::shipped::{copy, project};
use resultant::draw::layout::{Area, Frame, Vec2};
use resultant::draw::{Contour, Shape};
use resultant::game::{Outcome, SHIP};
use resultant::lab::charts::Charts;
use resultant::lab::curve::Measured;
use resultant::lab::drawing::diagram::DiagramPlaces;
use resultant::lab::drawing::plane::Plane;
use resultant::lab::kept;
use resultant::lab::savings::Saving;
use resultant::lab::side_by_side::exhibits;
use resultant::lab::stability::regions;
use resultant::lab::stress::Survival;
use resultant::level;
use resultant::number::short;
use resultant::physics::SOURCES;
use resultant::screens::{Input, Key, Lab, PAGES, Page};
use resultant::ui::scroll::BAR_WIDTH;
use resultant::view::theme;
use std::fs;
use std::ops::Range;
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

/// In the Lab, on the page of that tab, by key.
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

/// The boxes of that colour.
fn boxes(sitting: &Sitting, of: resultant::draw::Colour) -> Vec<Area> {
    let shapes = sitting.app.canvas().shapes();
    let box_of = |shape: &Shape| match shape {
        Shape::Fill { outline: Contour::Rounded(area, _), colour } if *colour == of => Some(*area),
        _ => None,
    };
    shapes.iter().filter_map(box_of).collect()
}

/// The largest panel.
fn panel(sitting: &Sitting) -> Area {
    let panels = boxes(sitting, theme::panel()).into_iter();
    panels.max_by(|a, b| a.size.element_product().total_cmp(&b.size.element_product())).expect("a panel")
}

/// The scene on the page of the charts: its index among all, and its chart.
fn scene(sitting: &Sitting) -> (usize, Measured) {
    let charts = &lab(sitting).charts().diagrams;
    let numbered = |i: &usize| sitting.texts().iter().any(|(text, _)| *text == format!("{} of {}", i + 1, charts.len()));
    let index = (0..charts.len()).find(numbered).expect("a scene is shown");
    assert!(sitting.shows(&charts[index].title));
    (index, charts[index].clone())
}

/// The index of the name whose line in the legend is picked out.
fn picked<'n>(sitting: &Sitting, mut names: impl Iterator<Item = &'n str>) -> Option<usize> {
    let y = sitting.picked()?;
    names.position(|name| sitting.area(name).centre().y == y)
}

fn picked_curve(sitting: &Sitting) -> Option<usize> {
    let (_, measured) = scene(sitting);
    picked(sitting, measured.curves.iter().map(|curve| curve.name.as_str()))
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

/// Each picture of the first page leads on; the savings are there where they were measured, and fill the page.
#[test]
fn the_pictures_of_the_first_page_lead_on() {
    let mut charts = kept::charts().unwrap();
    let most = charts.savings.iter().map(Saving::times).fold(0.0, f64::max);
    let mut sitting = lab_at("Overview");
    assert_eq!(lab(sitting.click("Where methods break")).page, Page::Stability);
    for (title, name) in [("Error against time", "projectile"), ("Beside Box2D and Rapier", "piles")] {
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
            sitting.rest();
            let areas = sitting.areas();
            if page == Page::Experiments {
                let listed = level::list(&project().join("experiments")).len();
                assert_eq!(areas.len(), PAGES.len() + 2 + listed, "{:?}", sitting.labels());
            }
            let apart = |a: &Area, b: &Area| a.max().cmple(b.min + 0.01).any() || b.max().cmple(a.min + 0.01).any();
            let inside = |a: &Area, b: &Area| a.min.cmpge(b.min).all() && a.max().cmple(b.max()).all();
            let (panels, frame) = (boxes(&sitting, theme::panel()), sitting.frame.area());
            for (i, a) in areas.iter().chain(&panels).enumerate() {
                assert!(inside(a, &frame), "{page:?} {width} × {height}: {a:?}");
                for b in areas.iter().take(i) {
                    // Only a legend lies in its chart's panel.
                    let legend =
                        i >= areas.len() && inside(b, a) && matches!(page, Page::Overview | Page::Charts | Page::Stability);
                    assert!(legend || apart(a, b), "{page:?} at {width} × {height}: {a:?} {b:?}");
                }
            }
        }
    }
}

#[test]
fn the_arrows_go_through_all_scenes_and_round() {
    let mut sitting = lab_with(|_| {});
    let name = |sitting: &Sitting| scene(sitting).1.name;
    let kept: Vec<String> = kept::charts().unwrap().diagrams.into_iter().map(|measured| measured.name).collect();
    let scenes = kept.len();
    let mut names = vec![name(&sitting)];
    for _ in 1..scenes {
        names.push(name(sitting.press(Key::Right)));
    }
    assert_eq!(names, kept);
    assert_eq!(name(sitting.press(Key::Right)), kept[0]);
    assert_eq!(name(sitting.press(Key::Left)), kept[scenes - 1]);
    assert_eq!(name(sitting.press(Key::Home)), kept[0]);
    assert_eq!(name(sitting.press(Key::End)), kept[scenes - 1]);
    assert_eq!(name(sitting.click("Next")), kept[0]);
    assert_eq!(name(sitting.click("Previous")), kept[scenes - 1]);
    assert!(sitting.press(Key::Home).line("Measured on").contains("build"));
    assert!(sitting.shows("As shipped: error "));
}

#[test]
fn a_method_is_picked_out_by_key_and_by_its_line_in_the_legend() {
    let mut sitting = lab_with(|_| {});
    let curves = scene(&sitting).1.curves.len();
    assert_eq!(picked_curve(&sitting), None);
    for curve in 0..curves {
        assert_eq!(picked_curve(sitting.press(Key::Down)), Some(curve));
    }
    assert_eq!(picked_curve(sitting.click("Method")), None, "none comes after the last");
    assert_eq!(picked_curve(sitting.press(Key::Up)), Some(curves - 1));
    assert_eq!(picked_curve(sitting.press(Key::Right)), None, "another scene has other methods");
    let second = scene(&sitting).1.curves[1].name.clone();
    let at = sitting.area(&second).centre();
    assert_eq!(picked_curve(sitting.point_at(at)), Some(1), "while the pointer is there");
    assert_eq!(picked_curve(sitting.point_at(Vec2::ZERO)), None);
    assert_eq!(picked_curve(sitting.click(&second).point_at(Vec2::ZERO)), Some(1), "for good");
    assert_eq!(picked_curve(sitting.click(&second).point_at(Vec2::ZERO)), None);
}

#[test]
fn a_point_tells_what_it_is_when_it_is_pointed_at() {
    let mut sitting = lab_with(|_| {});
    sitting.frame = Frame::of_window(Vec2::new(1920.0, 1080.0));
    sitting.rest();
    let measured = scene(&sitting).1;
    let plot = DiagramPlaces::of(panel(&sitting), &measured);
    for (curve, points) in measured.curves.iter().enumerate() {
        for point in &points.points {
            let at = plot.at(point);
            sitting.point_at(at);
            let told = measured.curves.iter().any(|curve| {
                let here = curve.points.iter().filter(|other| plot.at(other).distance(at) < 1e-3);
                here.into_iter().any(|other| {
                    ["step", "tolerance"]
                        .iter()
                        .any(|what| sitting.shows(&format!("{}, {what} {}", curve.name, curve.setting(*other))))
                })
            });
            assert!(told, "{curve}: the words are of a point in the same place");
        }
    }
    assert!(!sitting.point_at(Vec2::ZERO).shows(", step "));
}

/// The lines of the table of stress tests: a test, or a method with its test.
fn stress_lines() -> Vec<(String, Option<Survival>)> {
    let stress = kept::charts().unwrap().stress;
    let tests = stress.chunk_by(|a, b| a.test == b.test);
    let lines = tests.flat_map(|rows| {
        let methods = rows.iter().map(|row| (row.method.clone(), Some(row.clone())));
        std::iter::once((rows[0].test.clone(), None)).chain(methods)
    });
    lines.collect()
}

/// The panels of the table and of the large picture.
fn stress_panels(sitting: &Sitting) -> [Area; 2] {
    boxes(sitting, theme::panel()).try_into().expect("two panels")
}

/// The lines in view.
fn in_view(sitting: &Sitting) -> Range<usize> {
    let [table, _] = stress_panels(sitting);
    let first_column = |at: &Vec2| at.x < table.min.x + 100.0 && table.contains(*at);
    let last_column = |at: &Vec2| (at.x - table.max().x + 48.0).abs() < 1.0 && table.contains(*at);
    let texts = |column: &dyn Fn(&Vec2) -> bool| -> Vec<String> {
        sitting.texts().into_iter().filter(|(_, at)| column(at)).map(|(text, _)| text).collect()
    };
    let (names, values, lines) = (texts(&first_column), texts(&last_column), stress_lines());
    // The tests of swings have the same methods one after the other; their values differ.
    let is = |from: &usize| {
        lines[*from..].iter().zip(names.iter().zip(&values)).all(|((name, row), (shown, value))| {
            name.starts_with(shown.trim_end_matches('…')) && row.as_ref().is_none_or(|row| row.shown() == *value)
        })
    };
    let from = (0..=lines.len() - names.len()).find(is).expect("lines one after the other");
    from..from + names.len()
}

/// The line that the large picture shows.
fn large(sitting: &Sitting) -> Option<usize> {
    let [_, large] = stress_panels(sitting);
    let texts: Vec<String> = sitting.texts().into_iter().filter(|(_, at)| large.contains(*at)).map(|(text, _)| text).collect();
    let [method, test] = [0, 1].map(|i| texts.get(i).map(|text| text.trim_end_matches('…').to_owned()));
    let (method, test) = (method?, test?);
    let is = |row: &Survival| row.method.starts_with(&method) && row.test.starts_with(&test);
    stress_lines().iter().position(|(_, row)| row.as_ref().is_some_and(is))
}

#[test]
fn the_table_has_every_stress_test_and_scrolls() {
    let mut sitting = lab_at("Stress tests");
    let all = stress_lines().len();
    assert_eq!(in_view(&sitting).start, 0);
    let mut seen = in_view(&sitting).end;
    while seen < all {
        let next = in_view(sitting.press(Key::Down));
        assert_eq!(next.end, seen + 1, "line by line");
        seen = next.end;
    }
    assert_eq!(in_view(sitting.press(Key::Home)).start, 0);
    assert!(in_view(sitting.press(Key::PageDown)).start > 5);
    assert_eq!(in_view(sitting.press(Key::End)).end, all);
    assert_eq!(in_view(sitting.press(Key::Down)).end, all, "never past the end");
    assert_eq!(in_view(sitting.press(Key::Home)).start, 0);
    assert_eq!(in_view(sitting.give(Input { wheel: -1.0, ..Input::default() })).start, 3);
    let track = boxes(&sitting, theme::ground()).into_iter().find(|area| area.size.x == BAR_WIDTH).expect("a bar");
    let end = Vec2::new(track.centre().x, track.max().y - 1.0);
    assert_eq!(in_view(sitting.click_at(end)).end, all);
}

#[test]
fn the_failures_in_view_are_drawn_within_a_second_and_the_one_pointed_at_is_told() {
    let mut sitting = lab_at("Stress tests");
    let lines = stress_lines();
    for key in [Key::Home, Key::PageDown, Key::End] {
        sitting.press(key).wait(1.0);
        let ([table, _], grounds) = (stress_panels(&sitting), boxes(&sitting, theme::ground()));
        let pictures = grounds.into_iter().filter(|area| table.contains(area.centre()) && area.size.x > BAR_WIDTH);
        let pictures: Vec<f32> = pictures.map(|area| area.centre().y).collect();
        let pitch = (table.size.y - 16.0) / in_view(&sitting).len() as f32;
        for (place, line) in in_view(&sitting).enumerate() {
            let y = table.min.y + 8.0 + (place as f32 + 0.5) * pitch;
            let drawn = pictures.iter().any(|other| (other - y).abs() < 1.0);
            let refused = |row: &Survival| row.shipped && row.test.starts_with("nonsense");
            let expected = lines[line].1.as_ref().is_some_and(|row| !refused(row));
            assert_eq!(drawn, expected, "{:?}", lines[line]);
        }
    }
    sitting.press(Key::Home).point_at(Vec2::ZERO);
    assert_eq!(large(&sitting), Some(1), "the first method, below the name of its test");
    // Below it, line by line.
    let [table, _] = stress_panels(&sitting);
    let told: Vec<Option<usize>> =
        (0..200).map(|i| large(sitting.point_at(table.min + Vec2::new(table.size.x - 100.0, 8.0 + 2.0 * i as f32)))).collect();
    let in_view = in_view(&sitting);
    assert!((in_view.start + 1..in_view.end - 2).all(|line| told.contains(&Some(line))), "{told:?}");
}

#[test]
fn a_region_of_stability_is_picked_out_by_key_and_by_its_line() {
    let mut sitting = lab_at("Stability");
    let regions = regions();
    let names: Vec<&str> = regions.iter().map(|region| region.name).collect();
    assert!(names.contains(&"RK4") && names.contains(&"velocity Verlet") && names.len() == 14);
    let picked = |sitting: &Sitting| picked(sitting, names.iter().copied());
    assert_eq!(picked(sitting.rest()), None);
    for method in 0..names.len() {
        assert_eq!(picked(sitting.press(Key::Down)), Some(method));
    }
    assert_eq!(picked(sitting.click("Method").point_at(Vec2::ZERO)), None, "none comes after the last");
    assert_eq!(picked(sitting.press(Key::Up)), Some(names.len() - 1));
    let third = sitting.area(names[2]).centre();
    assert_eq!(picked(sitting.point_at(third)), Some(2), "while the pointer is there");
    assert_eq!(picked(sitting.click(names[2]).point_at(Vec2::ZERO)), Some(2), "for good");
    // As many pixels for 1 to the right as upwards, and all of it in the panel.
    for (width, height) in SIZES {
        sitting.frame = Frame::of_window(Vec2::new(width, height));
        let plane = Plane::of(panel(sitting.rest()));
        let unit = (plane.at((1.0, 1.0)) - plane.at((0.0, 0.0))).abs();
        assert!((unit.x - unit.y).abs() < 1e-3);
        assert!(plane.area.max().x < plane.legend(0).min.x && plane.legend(names.len() + 1).max().y < plane.panel.max().y);
        assert!(plane.area.min.cmpgt(plane.panel.min).all() && plane.area.max().y < plane.panel.max().y);
    }
}

#[test]
fn two_methods_run_side_by_side_and_part() {
    let mut sitting = lab_at("Side by side");
    sitting.press(Key::R).wait(30.0);
    let page = |sitting: &Sitting| {
        let page = &lab(sitting).side_by_side;
        let [left, right] = page.halves();
        (page.exhibit().title, left.method, right.method, left.error, right.error, page.time())
    };
    let (first, left, right, wrong, exact, time) = page(&sitting);
    assert_eq!((left, right), ("snap to the floor", "shipped engine"));
    assert!((time - 30.0).abs() < 0.1, "{time}");
    assert!(wrong > 0.01 && exact < 1e-6, "{wrong} m and {exact} m after {time} s");
    // Each half has its own two keys, and its own two buttons.
    let methods = exhibits()[0].methods.iter().map(|(name, _)| *name).collect::<Vec<_>>();
    let last = methods.len() - 1;
    for (key, button, expected) in [
        (Key::D, "Next method, left", (methods[1], methods[last])),
        (Key::A, "Method before, left", (methods[last], methods[last])),
        (Key::Right, "Next method, right", (methods[0], methods[0])),
        (Key::Left, "Method before, right", (methods[0], methods[last - 1])),
    ] {
        let both = |sitting: &Sitting| (page(sitting).1, page(sitting).2);
        sitting.press(Key::Down).press(Key::Up).wait(0.5);
        assert_eq!(both(sitting.press(key)), expected, "{key:?}");
        assert!(page(&sitting).5 < 0.1, "it starts again");
        sitting.press(Key::Down).press(Key::Up);
        assert_eq!(both(sitting.click(button)), expected, "{button}");
        assert!(sitting.shows(expected.0) && sitting.shows(expected.1));
    }
    let mut titles = vec![first];
    while page(sitting.press(Key::Down)).0 != first {
        titles.push(page(&sitting).0);
        assert!(titles.len() < 20);
    }
    assert_eq!(titles, exhibits().iter().map(|exhibit| exhibit.title).collect::<Vec<_>>());
    assert_eq!(page(sitting.press(Key::Up)).0, titles[titles.len() - 1]);
}

#[test]
fn it_pauses_ends_and_starts_again() {
    let mut sitting = lab_at("Side by side");
    sitting.press(Key::Down).wait(1.0);
    let time = |sitting: &Sitting| lab(sitting).side_by_side.time();
    sitting.press(Key::Space);
    let stopped = time(&sitting);
    assert!(stopped > 0.9 && lab(&sitting).side_by_side.is_paused());
    assert_eq!(time(sitting.wait(1.0)), stopped);
    assert!(time(sitting.press(Key::Space).wait(0.5)) > stopped);
    let end = lab(&sitting).side_by_side.exhibit().seconds;
    sitting.wait(end);
    assert!(lab(&sitting).side_by_side.is_over() && (time(&sitting) - end).abs() < 0.02);
    let [left, right] = lab(&sitting).side_by_side.halves();
    assert!(left.error > 0.3 && right.error < 1e-6, "they stay where they are: {left:?} {right:?}");
    assert!(time(sitting.press(Key::R)) < 0.1 && !lab(&sitting).side_by_side.is_over());
    // A hitch is no leap.
    let before = time(&sitting);
    sitting.give(Input { frame_time: 1e9, ..Input::default() });
    assert!(time(&sitting) - before < 0.2);
}

#[test]
fn it_goes_on_by_single_steps_of_any_length_and_remembers_the_way() {
    let mut sitting = lab_at("Side by side");
    sitting.press(Key::R).press(Key::Space);
    let page = |sitting: &Sitting| {
        let page = &lab(sitting).side_by_side;
        let [left, right] = page.halves();
        (page.step(), page.time(), page.is_paused(), left.trail.len(), left.errors.to_vec(), right.error)
    };
    let before = page(&sitting);
    for single in 1..=90 {
        let after = page(sitting.press(Key::Period));
        assert!((after.1 - before.1 - f64::from(single) * after.0).abs() < 1e-9 && after.2, "{} s", after.1);
    }
    let (step, time, paused, trail, errors, ours) = page(&sitting);
    assert!(paused && trail >= 90 && time >= 1.5 && ours < 1e-9);
    // One in each part of the scene that has begun, and the fall is wrong from the first step on.
    assert_eq!(errors.len(), (time / 60.0 * 400.0 - 1e-9).ceil() as usize);
    assert!(errors[0] > 0.0 && errors.iter().all(|error| error.is_finite()));
    let mut met = vec![step];
    for _ in 0..4 {
        let (step, time, _, trail, errors, _) = page(sitting.press(Key::S).press(Key::Space));
        assert!(time <= 0.1 + step && trail as f64 * step <= time + 1e-9 && errors.len() <= 2, "it starts again: {time} s");
        assert!(!met.contains(&step));
        met.push(step);
        sitting.press(Key::Space).wait(2.0);
        assert!(page(&sitting).5 < 1e-9, "the engine is right at any step");
    }
    assert_eq!(page(sitting.press(Key::S)).0, met[0]);
}

#[test]
fn error_and_energy_over_time_are_shown_of_what_was_followed() {
    let mut sitting = lab_with(|_| {});
    let scenes = lab(&sitting).charts().diagrams.len();
    let words = "Each point is the worst since the one before.";
    let (mut followed, mut energies) = (0, 0);
    for _ in 0..scenes {
        let measured = scene(&sitting).1;
        assert!(!sitting.shows(words) && !sitting.shows("At the end"));
        assert_eq!(sitting.shows("Over time"), measured.over_time.is_some());
        sitting.press(Key::Space);
        assert_eq!(
            (sitting.shows(words), sitting.shows("At the end")),
            (measured.over_time.is_some(), measured.over_time.is_some())
        );
        if let Some(shown) = measured.over_time {
            followed += 1;
            assert!(shown.courses.iter().any(|course| course.name == "shipped engine"));
            energies += usize::from(shown.has_energy());
            sitting.click("At the end");
        }
        sitting.press(Key::Right);
    }
    assert_eq!((followed, energies), (4, 3));
}

/// Those that come with the game.
fn experiments(root: &Path) {
    copy(&project().join("experiments"), &root.join("experiments"));
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
    // A click chooses, a second one flies.
    let (third, title) = (sitting.areas()[PAGES.len() + 2].centre(), sitting.labels()[PAGES.len() + 2].to_owned());
    sitting.give(Input { pointer: third, click: true, ..Input::default() });
    assert!(sitting.focused() == title && sitting.shows("docs/sheets/force-mass-acceleration.html"));
    sitting.click_at(third);
    assert!(sitting.scene().overlays.details, "what acts is what it is about");
    assert_eq!(sitting.game().level().name, "force-mass-acceleration");
    // No ship plays a part: nothing ends, and no key flies.
    let before = sitting.game().ship().clone();
    let held = [Key::Space, Key::Right].into_iter().collect();
    sitting.give(Input { pressed: held, held, ..Input::default() });
    sitting.give(Input { held, frame_time: 0.2, ..Input::default() });
    let game = sitting.game();
    assert!(game.outcome() == Outcome::Running && game.level().objectives.is_empty() && game.ship().fuel == 0.0);
    assert!(!game.level().bounds().overlaps(&game.world().body(SHIP).bounds(), 0.0) && before.burning == game.ship().burning);
}

/// The same to the last bit; what blew up is not a number, and so not equal to itself.
fn same(one: &Charts, other: &Charts) -> bool {
    one.files() == other.files()
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
fn the_last_run_of_chart_is_shown_where_there_is_one() {
    let mut charts = kept::charts().unwrap();
    charts.setting.machine = "a machine of my own".into();
    charts.diagrams.truncate(2);
    for curve in &mut charts.diagrams[0].curves {
        curve.version = SOURCES.to_owned();
    }
    charts.diagrams[1].curves[0].version = "another".to_owned();
    charts.diagrams[1].note.clear();
    let mut sitting = lab_with(|root| write(root, &charts, None));
    assert_eq!(sitting.warning(), None);
    let stale = "; measured with another build than this one.";
    assert!(!sitting.line("Measured on").contains(stale) && sitting.press(Key::Right).line("Measured on").contains(stale));
    assert!(same(lab(&sitting).charts(), &charts));
    assert!(sitting.shows("a machine of my own") && !sitting.shows("Came with the game"));
    let sitting = lab_with(|_| {});
    assert!(same(lab(&sitting).charts(), &kept::charts().unwrap()));
    assert!(sitting.shows("Came with the game"));
}

#[test]
fn damaged_charts_are_told_and_the_shipped_ones_shown() {
    let charts = kept::charts().unwrap();
    for (file, text, problem) in [
        (
            "fall.csv",
            Some("method,origin,version,step,work,spread,error\nRK4,lab,v,1,fast,0,0\n"),
            "charts/fall.csv:2: column \"work\": found \"fast\"",
        ),
        ("fall.csv", None, "charts/fall.csv: "),
        ("scenes.csv", Some(""), "charts/scenes.csv: found nothing"),
        ("stress.csv", Some("\0\0\0"), "charts/stress.csv:1: found "),
        ("setting.csv", None, "charts/setting.csv: "),
    ] {
        let sitting = lab_with(|root| write(root, &charts, Some((file, text))));
        assert!(sitting.warning().unwrap().starts_with(problem), "{:?}", sitting.warning());
        assert!(same(lab(&sitting).charts(), &charts));
    }
    // No folder of files at all.
    let sitting = lab_with(|root| fs::write(root.join("charts"), "").unwrap());
    assert!(sitting.warning().is_some() && scene(&sitting).0 == 0);
    let sitting = lab_with(|root| {
        write(root, &charts, Some(("pi.csv", None)));
        fs::create_dir(root.join("charts/pi.csv")).unwrap();
    });
    assert!(sitting.warning().unwrap().starts_with("charts/pi.csv: found a folder"));
}

#[test]
fn a_scene_without_points_is_shown_all_the_same() {
    let mut charts = kept::charts().unwrap();
    charts.diagrams.truncate(1);
    charts.diagrams[0].curves.clear();
    charts.stress.clear();
    let mut sitting = lab_with(|root| write(root, &charts, None));
    for key in [Key::Down, Key::Up, Key::Left, Key::Right, Key::End] {
        sitting.press(key);
    }
    assert_eq!((sitting.warning(), picked_curve(&sitting)), (None, None));
    assert!(!sitting.shows("As shipped"));
    turn_to(&mut sitting, "Stress tests");
    assert!(sitting.press(Key::End).shows("There are no stress tests to show."));
}

/// The texts of the last frame, each with the box of its capitals and lower lengths.
fn text_boxes(sitting: &Sitting) -> Vec<(String, Area)> {
    let canvas = sitting.app.canvas();
    let box_of = |shape: &Shape| {
        let Shape::Text { text, at, style } = shape else { return None };
        let (from, height) = (canvas.baseline(text, *at, *style), canvas.frame().text_height(style.size));
        Some((text.clone(), Area::new(from.x, from.y - 0.72 * height, canvas.width(text, *style), 0.9 * height)))
    };
    canvas.shapes().iter().filter_map(box_of).collect()
}

/// The pairs that lie on each other, and the texts that leave the window.
fn note_overlaps(sitting: &Sitting, place: &str, found: &mut Vec<String>) {
    let (texts, frame) = (text_boxes(sitting), sitting.frame.area());
    let mut note = |words: String| {
        if !found.iter().any(|known| known.ends_with(&words)) {
            found.push(format!("{place}: {words}"));
        }
    };
    for (i, (text, a)) in texts.iter().enumerate() {
        if a.min.cmplt(frame.min - 1.0).any() || a.max().cmpgt(frame.max() + 1.0).any() {
            note(format!("{text:?} leaves the window"));
        }
        for (other, b) in &texts[..i] {
            let apart = (b.min - a.max()).max(a.min - b.max()).max_element();
            if apart <= -1.0 {
                note(format!("{text:?} lies on {other:?}"));
            }
        }
    }
}

#[test]
fn no_words_of_the_lab_lie_on_others() {
    let mut found = Vec::new();
    for (width, height) in [(900.0, 500.0), (1280.0, 720.0)] {
        let at = format!("at {width} × {height}");
        let mut sitting = lab_with(experiments);
        sitting.frame = Frame::of_window(Vec2::new(width, height));
        sitting.rest();
        for number in 0..lab(&sitting).charts().diagrams.len() {
            for curve in 0..=scene(&sitting).1.curves.len() {
                note_overlaps(&sitting, &format!("chart {number}, curve {curve} {at}"), &mut found);
                sitting.press(Key::Down).rest();
            }
            if sitting.labels().contains(&"Over time") {
                sitting.press(Key::Space).rest();
                note_overlaps(&sitting, &format!("chart {number} over time {at}"), &mut found);
                sitting.press(Key::Space);
            }
            sitting.press(Key::Right).rest();
        }
        for (page, label) in PAGES {
            turn_to(&mut sitting, label);
            sitting.rest();
            let turns = if page == Page::Stability || page == Page::SideBySide { 12 } else { 1 };
            for turn in 0..turns {
                note_overlaps(&sitting, &format!("{label} {turn} {at}"), &mut found);
                sitting.press(Key::Down).wait(0.3);
            }
        }
    }
    assert!(found.is_empty(), "{} of them: {:#?}", found.len(), &found[..found.len().min(60)]);
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

/// Side by side: the spring's body leaves its circle by explicit Euler, and the shipped engine goes round with the exact one.
#[test]
fn explicit_euler_spirals_beside_the_engine() {
    let mut sitting = lab_at("Side by side");
    sitting.press(Key::Down).press(Key::Down);
    assert_eq!(lab(&sitting).side_by_side.exhibit().title, "A body on a spring goes round");
    sitting.wait(5.0);
    let [euler, ours] = lab(&sitting).side_by_side.halves();
    assert_eq!((euler.method, ours.method), ("explicit Euler", "shipped engine"));
    // From 2 m on, the radius grows by √(1 + (ω·h)²) a step.
    let radius = euler.boxes[0].centre().length();
    let steps = (lab(&sitting).side_by_side.time() * 60.0).round();
    let grown = 2.0 * (1.0_f64 + (2.0 / 60.0_f64).powi(2)).powf(0.5 * steps);
    assert!((radius - grown).abs() < 1e-9 && grown > 2.2, "{radius} for {grown}");
    assert!(ours.error < 1e-9 && sitting.shows("It uses what holds at the start"));
}
