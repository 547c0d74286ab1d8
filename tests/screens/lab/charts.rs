//! The page of charts: its scenes, methods and points, and charts from files.

use super::*;
use resultant::lab::charts::Charts;
use resultant::lab::curve::Measured;
use resultant::lab::drawing::places::DiagramPlaces;
use resultant::physics::SOURCES;

/// The scene on the page of the charts: its index among all, and its chart.
pub fn scene(sitting: &Sitting) -> (usize, Measured) {
    let charts = &lab(sitting).charts().diagrams;
    let numbered = |i: &usize| sitting.texts().iter().any(|(text, _)| *text == format!("{} of {}", i + 1, charts.len()));
    let index = (0..charts.len()).find(numbered).expect("a scene is shown");
    assert!(sitting.shows(&charts[index].title));
    (index, charts[index].clone())
}

fn picked_curve(sitting: &Sitting) -> Option<usize> {
    let (_, measured) = scene(sitting);
    picked(sitting, measured.curves.iter().map(|curve| curve.name.as_str()))
}

#[test]
fn the_arrows_go_through_all_scenes_and_round() {
    let mut sitting = lab_with(|_| {});
    let name = |sitting: &Sitting| scene(sitting).1.name;
    let kept: Vec<String> = kept::charts().unwrap().diagrams.into_iter().map(|measured| measured.name).collect();
    let scenes = kept.len();
    let mut names = vec![name(&sitting)];
    (1..scenes).for_each(|_| names.push(name(sitting.press(Key::Right))));
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
    let names: Vec<String> = scene(&sitting).1.curves.into_iter().map(|curve| curve.name).collect();
    assert_picked_in_turn(&mut sitting, &names);
    assert_eq!(picked_curve(sitting.press(Key::Up)), Some(names.len() - 1));
    assert_eq!(picked_curve(sitting.press(Key::Right)), None, "another scene has other methods");
}

#[test]
fn a_point_tells_what_it_is_when_it_is_pointed_at() {
    let mut sitting = lab_with(|_| {});
    sitting.frame = Frame::of_window(Vec2::new(1920.0, 1080.0));
    sitting.rest();
    let measured = scene(&sitting).1;
    let plot = DiagramPlaces::of(panel(&sitting), &measured, &sitting.frame);
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
        assert_eq!([sitting.shows(words), sitting.shows("At the end")], [measured.over_time.is_some(); 2]);
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

/// The same to the last bit; what blew up is not a number, and so not equal to itself.
fn same(one: &Charts, other: &Charts) -> bool {
    one.files() == other.files()
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
        ("scenes.csv", Some(""), "charts/scenes.csv: found nothing"),
        ("stress.csv", Some("\0\0\0"), "charts/stress.csv:1: found "),
        ("setting.csv", None, "charts/setting.csv: "),
    ] {
        let sitting = lab_with(|root| write(root, &charts, Some((file, text))));
        assert!(sitting.warning().unwrap().starts_with(problem), "{:?}", sitting.warning());
        assert!(same(lab(&sitting).charts(), &charts));
    }
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
    sitting.press_all(&[Key::Down, Key::Up, Key::Left, Key::Right, Key::End]);
    assert_eq!((sitting.warning(), picked_curve(&sitting)), (None, None));
    assert!(!sitting.shows("As shipped"));
    turn_to(&mut sitting, "Stress tests");
    assert!(sitting.press(Key::End).shows("There are no stress tests to show."));
}
