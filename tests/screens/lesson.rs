//! A lesson as it is played: time is stopped, a ball picked out, its velocity plotted, the curve taken along, and g read off the file.

use crate::sitting::Sitting;
use crate::support::shipped::{copy, names, project};
use resultant::files::EXPERIMENTS;
use resultant::screens::{Instrument, Key, Lab, Page};
use resultant::view::theme;
use std::fs;
use std::path::{Path, PathBuf};

/// N/kg, in all experiments.
const G: f64 = 9.81;

pub fn free_fall() -> Sitting {
    let sitting = experiment("free-fall");
    assert_eq!(sitting.game().level().title, "Free fall");
    sitting
}

/// In an experiment that has been started, its sheet closed, from the menu on.
pub fn experiment(name: &str) -> Sitting {
    let mut sitting = opened(name);
    predict(&mut sitting, "1");
    sitting.press(Key::L).press(Key::B);
    sitting
}

pub fn predict(sitting: &mut Sitting, text: &str) {
    if sitting.labels().contains(&"Your prediction") {
        sitting.click("Your prediction").write(text).press(Key::Enter);
    } else {
        let choice = sitting.labels()[2].to_owned();
        sitting.click(&choice);
    }
}

pub fn opened(name: &str) -> Sitting {
    let mut sitting = Sitting::with(|root| {
        let from = project().join(EXPERIMENTS);
        copy(&from.join(name), &root.join(EXPERIMENTS).join(name));
        let list = fs::read_to_string(from.join("experiments.csv")).unwrap();
        let row = format!("{name},");
        let wanted: Vec<&str> = list.lines().filter(|line| line.starts_with("folder") || line.starts_with(&row)).collect();
        fs::write(root.join(EXPERIMENTS).join("experiments.csv"), wanted.join("\n")).unwrap();
    });
    sitting.choose("Lab");
    while sitting.screen::<Lab>().page != Page::Experiments {
        sitting.press(Key::Tab);
    }
    sitting.press(Key::Enter);
    assert_eq!(sitting.at(), "flight");
    sitting
}

pub fn open_plot(sitting: &mut Sitting) {
    sitting.press(Key::I).click("Plot");
    assert!(sitting.flight().instruments().uses(Instrument::Plot));
}

/// The path in the plot's message on its last export.
pub fn written(sitting: &Sitting) -> PathBuf {
    let words = sitting.line("Written: ");
    assert_eq!(sitting.colour(&words), theme::good());
    PathBuf::from(words.strip_prefix("Written: ").unwrap())
}

pub fn columns(path: &Path, headings: &[&str]) -> Vec<Vec<f64>> {
    let text = fs::read_to_string(path).unwrap();
    let mut lines = text.lines();
    let head: Vec<&str> = lines.next().unwrap().split(',').collect();
    let rows: Vec<Vec<&str>> = lines.map(|line| line.split(',').collect()).collect();
    let column = |heading: &&str| {
        let at = head.iter().position(|other| other == heading).unwrap_or_else(|| panic!("no {heading:?} among {head:?}"));
        rows.iter().map(|row| row[at].parse().unwrap()).collect()
    };
    headings.iter().map(column).collect()
}

/// Least squares: the slope of y against x.
fn slope(xs: &[f64], ys: &[f64]) -> f64 {
    let n = xs.len() as f64;
    let (mx, my) = (xs.iter().sum::<f64>() / n, ys.iter().sum::<f64>() / n);
    let over = |f: &dyn Fn(f64, f64) -> f64| xs.iter().zip(ys).map(|(x, y)| f(*x, *y)).sum::<f64>();
    over(&|x, y| (x - mx) * (y - my)) / over(&|x, _| (x - mx) * (x - mx))
}

#[test]
fn an_experiment_waits_for_a_prediction_and_stands_still_again_after_a_restart() {
    let mut sitting = opened("free-fall");
    assert_eq!(sitting.line(" starts the experiment"), "Predict, then [B] starts the experiment");
    for key in [Key::B, Key::Period, Key::B] {
        sitting.press(key).wait(0.2);
        assert_eq!((sitting.ticks(), sitting.warning().as_deref()), (0, Some("Make a prediction first.")));
    }
    predict(&mut sitting, "");
    for _ in 0..2 {
        sitting.wait(1.0);
        assert_eq!(sitting.ticks(), 0);
        assert_eq!(sitting.line(" starts the experiment"), "[B] starts the experiment");
        sitting.press(Key::Escape).press(Key::Escape);
        assert_eq!(sitting.ticks(), 0, "the pause starts nothing");
        sitting.press(Key::B).wait(0.5);
        assert!(sitting.ticks() > 50 && !sitting.shows("starts the experiment"));
        sitting.press(Key::R);
    }
}

/// N passes over the ship, which plays no part.
#[test]
fn an_experiment_opens_on_what_moves_and_leads_back_to_the_list() {
    let mut sitting = free_fall();
    let followed = |sitting: &Sitting| sitting.flight().observer().focus().followed.map(|body| body.0);
    let flight = sitting.flight();
    assert!(sitting.scene().overlays.details && flight.observer().focus().fits() && !flight.game().level().ship_plays());
    let picked: Vec<Option<u32>> = (0..5)
        .map(|_| {
            let now = followed(&sitting);
            sitting.press(Key::N);
            now
        })
        .collect();
    assert_eq!(picked, [Some(1), Some(2), Some(3), None, Some(1)]);
    sitting.press(Key::R);
    assert!(sitting.scene().overlays.details && sitting.flight().observer().focus().fits(), "also from its beginning again");
    sitting.press(Key::Escape);
    assert_eq!((sitting.at(), sitting.labels()[3]), ("pause", "Back to experiments"));
    sitting.click("Back to experiments");
    let lab = sitting.screen::<Lab>();
    assert_eq!(lab.page, Page::Experiments);
    assert!(sitting.focused() == "Free fall" && sitting.shows("docs/sheets/free-fall.html"));
}

#[test]
fn a_played_lesson_ends_with_g_in_a_file() {
    let mut sitting = free_fall();
    sitting.wait(0.5).press(Key::B).press_all(&[Key::Period; 20]);
    let now = sitting.ticks();
    assert!(now > 70);
    open_plot(&mut sitting);
    // The masses of the three balls; the first one is followed from the start.
    let mut slopes = Vec::new();
    for ball in 1..=3 {
        if ball > 1 {
            sitting.press(Key::N);
        }
        sitting.wait(0.1);
        let readings = sitting.flight().instruments().plot().readings();
        let name = format!("Ball {ball}");
        let names: Vec<_> = readings.iter().map(|reading| reading.name.clone()).collect();
        assert_eq!(names, [format!("{name} y"), format!("{name} v_y")]);
        let [_, (found, unit), (area, way)] = readings[1].numbers;
        assert!((found.unwrap() + G).abs() <= 1e-9 * G, "the slope that is shown: {found:?}");
        let fallen = 0.5 * G * (now as f64 / 120.0).powi(2);
        assert!((area.unwrap() + fallen).abs() <= 1e-9 * fallen, "the area that is shown: {area:?}");
        assert_eq!((unit.name(), way.name()), ("m/s²".to_owned(), "m".to_owned()));
        sitting.click("CSV").rest();
        let path = written(&sitting);
        assert_eq!(path.parent().unwrap(), sitting.folder.path().join("exports"));
        let table = columns(&path, &["tick", "t (s)", &format!("{name} y (m)"), &format!("{name} v_y (m/s)")]);
        let [ticks, times, heights, speeds] = &table[..] else { panic!("four columns") };
        assert_eq!((ticks.len() as u64, ticks[0], times[now as usize]), (now + 1, 0.0, now as f64 / 120.0));
        let g = -slope(times, speeds);
        assert!((g - G).abs() <= 1e-9 * G, "{g}");
        for (time, height) in times.iter().zip(heights) {
            let exact = heights[0] - 0.5 * G * time * time;
            assert!((height - exact).abs() <= 1e-9, "{time}: {height} {exact}");
        }
        slopes.push(g);
        sitting.click("SVG").rest();
        let svg = fs::read_to_string(written(&sitting)).unwrap();
        assert!(svg.contains(&format!("{name} v_y")) && svg.contains("v_y (m/s)") && svg.contains("t (s)") && !svg.contains("NaN"));
    }
    assert!(slopes.iter().all(|g| (g - slopes[0]).abs() <= 1e-12 * G), "all fall alike: {slopes:?}");
    let names = names(&sitting.folder.path().join("exports"));
    let base = "free-fall-y-v_y";
    let expected = ["-2.csv", "-2.svg", "-3.csv", "-3.svg", ".csv", ".svg"].map(|ending| format!("{base}{ending}"));
    assert_eq!(names, expected);
}
