//! The lab: its methods against known figures, its scenes against the shipped engine, and `resultant chart`.

use crate::support::program::{Ran, resultant};
use crate::support::shipped::{names, project};
use resultant::lab::charts::Charts;
use resultant::lab::kept::{PEERS, peer_rows};
use resultant::lab::methods::motion::{MotionLaw, MotionStep, PointState, follow, rise_and_fall, rk4, semi_implicit_euler, strang};
use resultant::lab::report::{PAGES, PageFigures};
use resultant::lab::scenes::flight;
use resultant::lab::stress::TESTS;
use resultant::lab::stress::picture::FailurePicture;
use resultant::lab::{LabScene, kept, scenes};
use resultant::physics::{DVec2, SOURCES};
use std::path::Path;

fn scene(name: &str) -> LabScene {
    scenes::all().into_iter().find(|scene| scene.name == name).unwrap()
}

fn error(scene: &LabScene, method: &str, step: f64) -> f64 {
    (scene.methods.iter().find(|found| found.name == method).unwrap().run)(step)
}

/// Position errors after 3 s, to the two digits known from another implementation.
#[test]
fn integrators_have_their_known_errors() {
    let law = MotionLaw { constant: DVec2::new(0.0, 9.81), drag: 0.05, wind: DVec2::new(4.0, 0.0), ..MotionLaw::default() };
    let start = PointState { x: DVec2::ZERO, v: DVec2::new(20.0, -20.0) };
    let exact = flight::drag_in_two_dimensions(&law, start, 3.0).x;
    let known: [(MotionStep, [f64; 3]); 3] =
        [(semi_implicit_euler, [2.4, 0.59, 0.15]), (strang, [1.2e-2, 7.3e-4, 4.6e-5]), (rk4, [2.3e-5, 7.9e-8, 3.0e-10])];
    for (step, errors) in known {
        for (h, known) in [1.0 / 15.0, 1.0 / 60.0, 1.0 / 240.0].into_iter().zip(errors) {
            let found = (follow(step, &law, start, 3.0, h).x - exact).length();
            assert!((found / known - 1.0).abs() < 0.03, "{found:e}, known {known:e}");
        }
    }
}

#[test]
fn the_shipped_engine_is_right_to_rounding_where_an_exact_answer_exists() {
    for (bar, names) in [
        (0.0, &["column", "heavy-on-light", "friction-tower", "pi"][..]),
        (1e-9, &["fall", "shock-absorber", "orbit", "slide", "bounce-apexes", "cradle", "pushed-row", "thin-wall"]),
        (1e-6, &["rise-with-drag", "liquid", "projectile", "gust", "bounce-perfect"]),
        (1.0 / 120.0, &["rest-time"]),
    ] {
        for scene in names.iter().map(|name| scene(name)) {
            let found = error(&scene, &scene.methods.last().unwrap().name, scene.shipped_step);
            assert!(found <= bar, "{}: {found:e}", scene.name);
        }
    }
}

#[test]
fn naive_methods_miss_the_tolerance_where_they_are_known_to() {
    for (name, method, step) in [
        ("fall", "semi-implicit Euler", 1.0 / 120.0),
        ("projectile", "exact drag (Lie)", 1.0 / 120.0),
        ("slide", "friction clamped", 1.0 / 120.0),
        ("bounce-apexes", "reflect", 1.0 / 60.0),
        ("cradle", "all contacts at once", 1.0 / 60.0),
        ("column", "impulses, 20 sweeps, warm", 1.0 / 60.0),
        ("heavy-on-light", "impulses, 20 sweeps, warm", 1.0 / 60.0),
        ("thin-wall", "overlap at tick ends", 1.0 / 60.0),
        ("pi", "time steps, N = 3", 1.0 / 60.0),
    ] {
        let scene = scene(name);
        let found = error(&scene, method, step);
        assert!(found > scene.tolerance || found.is_nan(), "{name}, {method}: {found:e}");
    }
    // A gust makes light bodies blow up in fixed explicit steps.
    let gust = scene("gust");
    for method in ["explicit Euler", "semi-implicit Euler", "velocity Verlet", "RK4"] {
        let found = error(&gust, method, 1.0 / 60.0);
        assert!(found > 1e4 || found.is_nan(), "{method}: {found:e}");
    }
}

/// The methods of today's engines, each where it holds and where it fails, at 1/60 s.
#[test]
fn contact_methods_hold_and_fail_where_their_pages_say() {
    for (name, method, least, most) in [
        ("column", "soft contacts, 4 substeps", 0.05, 0.2),
        ("column", "XPBD, 20 substeps", 0.0, 1.0 / 300.0),
        ("heavy-on-light", "soft contacts, 4 substeps", 1.0, f64::INFINITY),
        ("heavy-on-light", "XPBD, 20 substeps", 0.0, 0.2),
        ("friction-tower", "impulses, 20 sweeps, cold", 1.0, f64::INFINITY),
        ("friction-tower", "impulses, 20 sweeps, warm", 0.0, 0.01),
        ("friction-tower", "soft contacts, 4 substeps", 0.0, 0.05),
        ("friction-tower", "XPBD, 20 substeps", 1.0, f64::INFINITY),
        ("rest-time", "impulses, 20 sweeps, warm", 0.5, 5.0),
        ("rest-time", "direct", 0.0, 1.0 / 60.0),
        ("thin-wall", "speculative contacts", 0.1, 1.6),
        ("cradle", "speculative contacts", 1.0, f64::INFINITY),
        ("shock-absorber", "RK4", f64::INFINITY, f64::INFINITY),
        ("shock-absorber", "trapezoid", 0.0, 1e-5),
        ("orbit", "Yoshida 4", 0.0, 1e-5),
        ("orbit", "implicit Euler", 1.0, f64::INFINITY),
    ] {
        let scene = scene(name);
        let found = error(&scene, method, 1.0 / 60.0);
        let found = if found.is_nan() { f64::INFINITY } else { found };
        assert!((least..=most).contains(&found), "{name}, {method}: {found:e}");
    }
}

/// Whether a picture shows an error: a line that ends where nothing counts as right, or that leaves every right line by more than a
/// twentieth of the picture.
fn is_seen_to_fail(picture: &FailurePicture) -> bool {
    let (_, (least, most)) = picture.window();
    if let Some((from, to)) = picture.right {
        let end = picture.found.last().and_then(|line| line.last()).unwrap();
        return !(from..=to).contains(&end.1);
    }
    let right_at = |line: &[(f64, f64)], x: f64| {
        let pair = line.windows(2).find(|pair| x <= pair[1].0).unwrap_or(&line[line.len() - 2..]);
        let part = (x - pair[0].0) / (pair[1].0 - pair[0].0);
        if part.is_finite() { pair[0].1 + part * (pair[1].1 - pair[0].1) } else { pair[1].1 }
    };
    let is_right = |(x, y): &(f64, f64)| picture.exact.iter().any(|line| (right_at(line, *x) - y).abs() <= 0.05 * (most - least));
    picture.found.iter().flatten().any(|point| !is_right(point))
}

/// Where a thrown thing turns round, the second derivative of drag jumps. RK4 has its order where a step ends just there, and wanders below it
/// where the apex lies within a step, here at one part of it and there at another.
#[test]
fn rk4_has_no_order_at_the_apex_of_a_rise() {
    let law = MotionLaw { constant: DVec2::new(0.0, 9.81), drag: 0.05, ..MotionLaw::default() };
    let terminal = (9.81f64 / 0.05).sqrt();
    let slopes = |apex: f64| -> Vec<f64> {
        let start = PointState { x: DVec2::ZERO, v: DVec2::new(0.0, -terminal * (9.81 * apex / terminal).tan()) };
        let exact = rise_and_fall(&law, start, 2.0).x.y;
        let error = |h: f64| (follow(rk4, &law, start, 2.0, h).x.y - exact).abs();
        [16.0, 32.0, 64.0].map(|parts| (error(1.0 / parts) / error(0.5 / parts)).log2()).to_vec()
    };
    for slope in slopes(1.0) {
        assert!((slope - 4.0).abs() < 0.2, "{slope}");
    }
    let beside = slopes(1.037);
    assert!(beside.iter().any(|slope| (slope - 4.0).abs() > 0.5), "{beside:?}");
}

/// And each method survives what the table that comes with the game says.
#[test]
fn in_every_stress_test_the_shipped_engine_survives_all_that_is_tried() {
    let kept = kept::charts().unwrap().stress;
    for test in TESTS {
        let test = test();
        let rows = test.rows();
        let known: Vec<_> = kept.iter().filter(|row| row.test == test.name).collect();
        assert_eq!(known.len(), rows.len(), "{rows:#?}");
        for (known, row) in known.into_iter().zip(&rows) {
            assert!(known.method == row.method && (known.largest - row.largest).abs() <= 2e-3 * row.largest, "{known:?} {row:?}");
        }
        for row in &rows {
            let picture = test.picture(&row.method, row.largest);
            // A refused command never runs.
            assert_eq!(picture.is_none(), row.shipped && row.test.starts_with("nonsense"), "{}, {}", row.test, row.method);
            let Some(picture) = picture else { continue };
            let seen = is_seen_to_fail(&picture);
            let fails = row.largest < row.tried;
            assert!(seen == fails || !fails && !row.shipped, "{}, {}: {picture:?}", row.test, row.method);
        }
        let (naive, shipped): (Vec<_>, Vec<_>) = rows.iter().partition(|row| !row.shipped);
        assert_eq!(shipped.len(), 1);
        assert_eq!(shipped[0].largest, shipped[0].tried, "{}", shipped[0].test);
        assert!(naive.iter().any(|row| row.largest < row.tried), "{}: nobody fails", shipped[0].test);
    }
}

/// Runs `resultant chart --quick --no-peers`: exit status, standard output and standard error.
fn chart(out: &Path, more: &[&str]) -> (i32, String, String) {
    let ran = Ran::new(resultant().args(["chart", "--quick", "--no-peers", "--out"]).arg(out).args(more));
    (ran.status, ran.out, ran.err)
}

#[test]
fn chart_writes_diagrams_tables_and_a_summary() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("new/charts");
    let (status, told, progress) = chart(&out, &[]);
    assert_eq!(status, 0, "{progress}");
    let text = |name: &str| std::fs::read_to_string(out.join(name)).unwrap();
    let summary = text("summary.md");
    assert!(summary.contains("Measured on ") && summary.contains(SOURCES) && !summary.contains("another build"));
    for scene in scenes::all() {
        assert!(progress.contains(&scene.title), "no progress shown for {}", scene.name);
        assert!(summary.contains(&format!("({}.svg)", scene.name)));
        let svg = text(&format!("{}.svg", scene.name));
        assert!(svg.contains(scene.error) && svg.contains(scene.work) && svg.contains("as shipped"));
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{}", scene.name);
        let csv = text(&format!("{}.csv", scene.name));
        let rows: Vec<_> = csv::Reader::from_reader(csv.as_bytes()).into_records().map(Result::unwrap).collect();
        let lab = rows.iter().filter(|row| &row[1] != "peer").count();
        assert_eq!(lab, scene.methods.len() * scene.steps.len(), "{}", scene.name);
    }
    for name in ["stability.svg", "stability.csv", "stability-limits.csv"] {
        assert!(text(name).contains("velocity Verlet"), "{name}");
    }
    assert!(summary.contains("(stability.svg)") && summary.contains("| RK4 | 2.79 | 2.83 |"), "{summary}");
    let charts = Charts::read(|name| Ok(text(name))).unwrap();
    assert!(charts.savings.len() > 60 && charts.savings.iter().all(|row| row.same_bits), "{:?}", charts.savings);
    for (name, written) in charts.files() {
        assert_eq!(written, text(&name));
    }
    for measured in charts.diagrams.iter().filter(|measured| measured.alike) {
        let (curve, cheapest) = measured.cheapest().unwrap();
        let shipped = measured.shipped_point().unwrap();
        assert!(cheapest.error <= measured.tolerance && cheapest.work <= shipped.work, "{}", measured.name);
        let row = format!("{},{:e},{:e},{:e},", measured.name, shipped.step, shipped.error, shipped.work);
        assert!(text("shipped.csv").contains(&row), "{row}");
        assert!(summary.contains(&format!("| {} at ", curve.name)));
    }
    assert_eq!(told.lines().count(), names(&out).len());
    assert!(told.lines().all(|line| Path::new(line).is_file()));
    // What is there of this build is left as it is; what is not is named, and measured where that is asked for.
    assert_eq!(chart(&out, &["--check"]).0, 0);
    let (before, stale) = (text("fall.csv"), text("fall.csv").replace(SOURCES, "0123456789abcdef"));
    let count = scenes::all().len();
    assert!(!chart(&out, &["--resume"]).2.contains(&format!("/{count} ")));
    assert_eq!(text("fall.csv"), before);
    std::fs::write(out.join("fall.csv"), &stale).unwrap();
    assert_eq!(chart(&out, &["--check"]).1, format!("fall: measured with another build than {SOURCES}\n"));
    assert_eq!(chart(&out, &["--draw"]).0, 0);
    assert!(text("fall.csv") == stale && text("summary.md").contains("another build than this one: fall.**"));
    let (status, _, progress) = chart(&out, &["fall"]);
    assert!(status == 0 && progress.matches(&format!("/{count} ")).count() == 1 && text("fall.csv").contains(SOURCES));
    assert_eq!(chart(&out, &["fell"]).0, 2);
}

/// Obstacles are found before anything is measured, and nothing is left half written.
#[test]
fn chart_says_where_it_cannot_write() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("file");
    std::fs::write(&file, "kept").unwrap();
    let occupied = folder.path().join("occupied");
    std::fs::create_dir_all(occupied.join("pi.svg")).unwrap();
    for (out, named) in [(&file, &file), (&file.join("below"), &file.join("below")), (&occupied, &occupied.join("pi.svg"))] {
        let (status, told, problem) = chart(out, &[]);
        assert_eq!((status, told.as_str()), (2, ""));
        assert!(problem.contains(&named.display().to_string()), "{problem}");
        assert!(!problem.contains("stress"), "it was measured all the same: {problem}");
    }
    assert_eq!(std::fs::read_to_string(&file).unwrap(), "kept");
    assert_eq!(names(&occupied), ["pi.svg"]);
}

/// Whether this is the build that was measured is for the page to say, and for `tools/package` to judge.
#[test]
fn the_pages_say_what_the_charts_say() {
    let read = |path: &str| std::fs::read_to_string(project().join(path)).unwrap();
    let charts = Charts::read(|name| Ok(read(&format!("docs/charts/{name}")))).unwrap();
    let peers = peer_rows(PEERS, &read(&format!("docs/charts/{PEERS}"))).unwrap();
    let unjudged = |text: &str| {
        let mut parts = text.split(" **Measured with another build");
        let first = parts.next().unwrap().to_owned();
        parts.fold(first, |text, part| text + part.split_once(".**").unwrap().1)
    };
    for page in PAGES {
        let text = read(page);
        let filled = PageFigures { charts: &charts, peers: &peers }.fill(&text).unwrap();
        assert!(unjudged(&text) == unjudged(&filled), "{page}: run `resultant chart --draw --out docs/charts`");
        assert!(text.contains("<!-- chart:"), "{page}");
    }
    let none = PageFigures { charts: &Charts::default(), peers: &[] };
    assert_eq!(none.fill("no mark").unwrap(), "no mark");
    assert!(none.fill("<!-- chart:column --><!-- end -->").unwrap_err().contains("no such figure"));
    assert!(none.fill("<!-- chart:measured -->").unwrap_err().contains("no end of the mark"));
}
