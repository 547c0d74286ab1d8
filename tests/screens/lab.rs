//! The lab's screen without a window: its charts, its table of stress tests, two methods side by side; by mouse and by keyboard, and
//! with damaged charts.

use resultant::draw::layout::{Area, Frame, Vec2};
use resultant::lab::charts::Charts;
use resultant::lab::kept;
use resultant::lab::side_by_side::exhibits;
use resultant::screens::{App, Attempt, Flight, Input, Key, Lab, Menu, PAGES, Page, Places, Request, SurvivalLine};
use std::fs;
use std::path::Path;

const SIZES: [(f32, f32); 5] = [(900.0, 500.0), (1280.0, 720.0), (1920.0, 1080.0), (600.0, 900.0), (2560.0, 600.0)];

/// A sitting that begins in the lab.
struct Sitting {
    app: App,
    frame: Frame,
    _folder: tempfile::TempDir,
}

impl Sitting {
    fn new() -> Self {
        Self::with(|_| {})
    }

    /// With the files of a data folder.
    fn with(prepare: impl FnOnce(&Path)) -> Self {
        let folder = tempfile::tempdir().unwrap();
        prepare(folder.path());
        let root = folder.path().to_path_buf();
        let mut app = App::new(Places { levels: root.join("levels"), scores: root.join("scores"), root });
        app.grant(Request::Lab, &mut ());
        let mut sitting = Self { app, frame: Frame::default(), _folder: folder };
        sitting.give(Input::default());
        sitting
    }

    fn give(&mut self, input: Input) -> &mut Self {
        let frame_time = if input.frame_time > 0.0 { input.frame_time } else { 1.0 / 60.0 };
        assert!(self.app.update(&Input { frame: self.frame, frame_time, ..input }, &mut ()));
        self
    }

    fn press(&mut self, key: Key) -> &mut Self {
        let keys = [key].into_iter().collect();
        self.give(Input { pressed: keys, held: keys, ..Input::default() }).give(Input::default())
    }

    fn point_at(&mut self, pointer: Vec2) -> &mut Self {
        self.give(Input { pointer, ..Input::default() })
    }

    fn click(&mut self, area: Area) -> &mut Self {
        let pointer = area.centre();
        self.give(Input { pointer, click: true, holding: true, ..Input::default() }).point_at(pointer)
    }

    fn wait(&mut self, seconds: f64) -> &mut Self {
        (0..(seconds * 60.0).round() as u32).fold(self, |sitting, _| sitting.give(Input::default()))
    }

    fn lab(&self) -> &Lab {
        self.app.screen().get().expect("in the lab")
    }

    fn has_left(&self) -> bool {
        self.app.screen().is::<Menu>()
    }

    /// The page of that tab, by key.
    fn page(&mut self, page: Page) -> &mut Self {
        while self.lab().page() != page {
            self.press(Key::Tab);
        }
        self
    }
}

#[test]
fn the_pages_are_reached_by_key_and_by_mouse_and_left_by_esc_and_back() {
    let mut sitting = Sitting::new();
    for (page, _) in PAGES.into_iter().chain([PAGES[0]]) {
        assert_eq!(sitting.lab().page(), page);
        sitting.press(Key::Tab);
    }
    for (index, (page, _)) in PAGES.into_iter().enumerate() {
        let tab = sitting.lab().tabs().areas()[index];
        assert_eq!(sitting.click(tab).lab().page(), page);
        assert!(Sitting::new().page(page).press(Key::Escape).has_left());
        let mut other = Sitting::new();
        let back = other.page(page).lab().toolbar().buttons().areas()[0];
        assert!(other.click(back).has_left());
    }
}

#[test]
fn nothing_lies_on_anything_else_in_any_window() {
    for (width, height) in SIZES {
        let mut sitting = Sitting::with(experiments);
        sitting.frame = Frame::of_window(Vec2::new(width, height));
        for (page, _) in PAGES {
            sitting.page(page).give(Input::default());
            let lab = sitting.lab();
            let mut areas: Vec<Area> = lab.tabs().areas().to_vec();
            areas.extend(lab.toolbar().buttons().areas());
            match page {
                Page::Charts => areas.push(lab.charts().plot(&sitting.frame).unwrap().panel),
                Page::Stability => areas.push(lab.stability().plane(&sitting.frame).panel),
                Page::Survival => areas.extend(lab.survival().bar().map(|bar| bar.track)),
                Page::SideBySide => areas.extend(lab.side_by_side().choices().areas()),
                Page::Experiments => {
                    areas.extend(lab.experiments().list().areas());
                    assert_eq!(lab.experiments().experiments().len(), 12);
                }
            }
            for (i, a) in areas.iter().enumerate() {
                assert!(
                    a.min.cmpge(Vec2::ZERO).all() && a.max().cmple(sitting.frame.size).all(),
                    "{page:?} {width} × {height}: {a:?}"
                );
                for b in &areas[..i] {
                    let apart = a.max().cmple(b.min).any() || b.max().cmple(a.min).any();
                    assert!(apart, "{page:?} at {width} × {height}: {a:?} {b:?}");
                }
            }
        }
    }
}

#[test]
fn the_arrows_go_through_all_scenes_and_round() {
    let mut sitting = Sitting::new();
    let scenes = sitting.lab().charts().charts().diagrams.len();
    let name = |sitting: &Sitting| sitting.lab().charts().measured().unwrap().name.clone();
    let mut names = vec![name(&sitting)];
    for _ in 1..scenes {
        names.push(name(sitting.press(Key::Right)));
    }
    let kept: Vec<String> = kept::charts().unwrap().diagrams.into_iter().map(|measured| measured.name).collect();
    assert_eq!(names, kept);
    assert_eq!(name(sitting.press(Key::Right)), kept[0]);
    assert_eq!(name(sitting.press(Key::Left)), kept[scenes - 1]);
    assert_eq!(name(sitting.press(Key::Home)), kept[0]);
    assert_eq!(name(sitting.press(Key::End)), kept[scenes - 1]);
    let next = sitting.lab().toolbar().buttons().areas()[2];
    assert_eq!(name(sitting.click(next)), kept[0]);
    assert!(sitting.lab().charts().source().contains("commit"));
    assert!(sitting.lab().charts().verdict().unwrap().starts_with("As shipped: error "));
}

#[test]
fn a_method_is_picked_out_by_key_and_by_its_line_in_the_legend() {
    let mut sitting = Sitting::new();
    let curves = sitting.lab().charts().measured().unwrap().curves.len();
    let picked = |sitting: &Sitting| sitting.lab().charts().picked();
    assert_eq!(picked(&sitting), None);
    for curve in 0..curves {
        assert_eq!(picked(sitting.press(Key::Down)), Some(curve));
    }
    assert_eq!(picked(sitting.press(Key::Down)), None, "none comes after the last");
    assert_eq!(picked(sitting.press(Key::Up)), Some(curves - 1));
    assert_eq!(picked(sitting.press(Key::Right)), None, "another scene has other methods");
    let line = |sitting: &Sitting, line| sitting.lab().charts().plot(&sitting.frame).unwrap().legend(line);
    let second = line(&sitting, 1);
    assert_eq!(picked(sitting.point_at(second.centre())), Some(1), "while the pointer is there");
    assert_eq!(picked(sitting.point_at(Vec2::ZERO)), None);
    assert_eq!(picked(sitting.click(second).point_at(Vec2::ZERO)), Some(1), "for good");
    assert_eq!(picked(sitting.click(second).point_at(Vec2::ZERO)), None);
}

#[test]
fn a_point_tells_what_it_is_when_it_is_pointed_at() {
    let mut sitting = Sitting::new();
    sitting.frame = Frame::of_window(Vec2::new(1920.0, 1080.0));
    let measured = sitting.lab().charts().measured().unwrap().clone();
    for (curve, points) in measured.curves.iter().enumerate() {
        for point in &points.points {
            let at = sitting.lab().charts().plot(&sitting.frame).unwrap().at(point);
            let (found, index) = sitting.point_at(at).lab().charts().point().unwrap();
            let other = &measured.curves[found].points[index];
            let plot = sitting.lab().charts().plot(&sitting.frame).unwrap();
            assert!(plot.at(other).distance(at) < 1e-3, "{curve}: another point in the same place");
        }
    }
    assert_eq!(sitting.point_at(Vec2::ZERO).lab().charts().point(), None);
}

#[test]
fn the_table_has_every_stress_test_and_scrolls() {
    let mut sitting = Sitting::new();
    sitting.page(Page::Survival);
    let stress = kept::charts().unwrap().stress;
    let lines = sitting.lab().survival().lines();
    let methods: Vec<_> =
        lines.iter().filter_map(|line| if let SurvivalLine::Method(row) = line { Some(row.clone()) } else { None }).collect();
    assert_eq!(methods, stress);
    let tests = lines.len() - methods.len();
    assert_eq!(tests, stress.chunk_by(|a, b| a.test == b.test).count());
    let all = lines.len();
    let range = |sitting: &Sitting| sitting.lab().survival().range();
    assert_eq!(range(&sitting).start, 0);
    assert!(range(sitting.press(Key::PageDown)).start > 5);
    assert_eq!(range(sitting.press(Key::End)).end, all);
    assert_eq!(range(sitting.press(Key::Down)).end, all, "never past the end");
    assert_eq!(range(sitting.press(Key::Home)).start, 0);
    assert_eq!(range(sitting.give(Input { wheel: -1.0, ..Input::default() })).start, 3);
    let bar = sitting.lab().survival().bar().unwrap();
    let end = Vec2::new(bar.track.centre().x, bar.track.max().y - 1.0);
    assert_eq!(range(sitting.click(Area::around(end, Vec2::ONE))).end, all);
}

#[test]
fn the_failures_in_view_are_drawn_within_a_second_and_the_one_pointed_at_is_told() {
    let mut sitting = Sitting::new();
    sitting.page(Page::Survival);
    for key in [Key::Home, Key::PageDown, Key::End] {
        sitting.press(key).wait(1.0);
        let page = sitting.lab().survival();
        for line in page.range() {
            let SurvivalLine::Method(row) = &page.lines()[line] else { continue };
            let refused = row.shipped && row.test.starts_with("nonsense");
            assert_eq!(page.picture(line).is_none(), refused, "{}, {}", row.test, row.method);
        }
    }
    sitting.press(Key::Home).point_at(Vec2::ZERO);
    assert_eq!(sitting.lab().survival().chosen(), Some(1), "the first method, below the name of its test");
    // Below it, line by line.
    let bar = sitting.lab().survival().bar().unwrap().track;
    let told: Vec<Option<usize>> = (0..200)
        .map(|i| sitting.point_at(Vec2::new(bar.min.x - 100.0, bar.min.y + 2.0 * i as f32)).lab().survival().chosen())
        .collect();
    let in_view = sitting.lab().survival().range();
    assert!((in_view.start + 1..in_view.end - 2).all(|line| told.contains(&Some(line))), "{told:?}");
}

#[test]
fn a_region_of_stability_is_picked_out_by_key_and_by_its_line() {
    let mut sitting = Sitting::new();
    sitting.page(Page::Stability).give(Input::default());
    let names: Vec<&str> = sitting.lab().stability().regions().iter().map(|region| region.name).collect();
    assert!(names.contains(&"RK4") && names.contains(&"velocity Verlet") && names.len() == 10);
    let picked = |sitting: &Sitting| sitting.lab().stability().picked();
    assert_eq!(picked(&sitting), None);
    for method in 0..names.len() {
        assert_eq!(picked(sitting.press(Key::Down)), Some(method));
    }
    assert_eq!(picked(sitting.press(Key::Down)), None, "none comes after the last");
    assert_eq!(picked(sitting.press(Key::Up)), Some(names.len() - 1));
    let third = sitting.lab().stability().plane(&sitting.frame).legend(3);
    assert_eq!(picked(sitting.point_at(third.centre())), Some(2), "while the pointer is there");
    assert_eq!(picked(sitting.click(third).point_at(Vec2::ZERO)), Some(2), "for good");
    // As many pixels for 1 to the right as upwards, and all of it in the panel.
    for (width, height) in SIZES {
        let plane = sitting.lab().stability().plane(&Frame::of_window(Vec2::new(width, height)));
        let unit = (plane.at((1.0, 1.0)) - plane.at((0.0, 0.0))).abs();
        assert!((unit.x - unit.y).abs() < 1e-3);
        assert!(plane.area.max().x < plane.legend(0).min.x && plane.legend(names.len() + 1).max().y < plane.panel.max().y);
        assert!(plane.area.min.cmpgt(plane.panel.min).all() && plane.area.max().y < plane.panel.max().y);
    }
}

#[test]
fn two_methods_run_side_by_side_and_part() {
    let mut sitting = Sitting::new();
    sitting.page(Page::SideBySide).press(Key::R).wait(30.0);
    let page = |sitting: &Sitting| {
        let page = sitting.lab().side_by_side();
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
        (Key::D, 1, (methods[1], methods[last])),
        (Key::A, 0, (methods[last], methods[last])),
        (Key::Right, 3, (methods[0], methods[0])),
        (Key::Left, 2, (methods[0], methods[last - 1])),
    ] {
        let both = |sitting: &Sitting| (page(sitting).1, page(sitting).2);
        sitting.press(Key::Down).press(Key::Up).wait(0.5);
        assert_eq!(both(sitting.press(key)), expected, "{key:?}");
        assert!(page(&sitting).5 < 0.1, "it starts again");
        sitting.press(Key::Down).press(Key::Up);
        let area = sitting.lab().side_by_side().choices().areas()[button];
        assert_eq!(both(sitting.click(area)), expected, "button {button}");
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
    let mut sitting = Sitting::new();
    sitting.page(Page::SideBySide).press(Key::Down).wait(1.0);
    let time = |sitting: &Sitting| sitting.lab().side_by_side().time();
    sitting.press(Key::Space);
    let stopped = time(&sitting);
    assert!(stopped > 0.9 && sitting.lab().side_by_side().is_paused());
    assert_eq!(time(sitting.wait(1.0)), stopped);
    assert!(time(sitting.press(Key::Space).wait(0.5)) > stopped);
    let end = sitting.lab().side_by_side().exhibit().seconds;
    sitting.wait(end);
    assert!(sitting.lab().side_by_side().is_over() && (time(&sitting) - end).abs() < 0.02);
    let [left, right] = sitting.lab().side_by_side().halves();
    assert!(left.error > 0.3 && right.error < 1e-6, "they stay where they are: {left:?} {right:?}");
    assert!(time(sitting.press(Key::R)) < 0.1 && !sitting.lab().side_by_side().is_over());
    // A hitch is no leap.
    let before = time(&sitting);
    sitting.give(Input { frame_time: 1e9, ..Input::default() });
    assert!(time(&sitting) - before < 0.2);
}

#[test]
fn it_goes_on_by_single_steps_of_any_length_and_remembers_the_way() {
    let mut sitting = Sitting::new();
    sitting.page(Page::SideBySide).press(Key::R).press(Key::Space);
    let page = |sitting: &Sitting| {
        let page = sitting.lab().side_by_side();
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
    let mut sitting = Sitting::new();
    let charts = |sitting: &Sitting| {
        let page = sitting.lab().charts();
        (page.measured().unwrap().over_time.is_some(), page.over_time().cloned(), page.verdict())
    };
    let scenes = sitting.lab().charts().charts().diagrams.len();
    let mut followed = 0;
    for _ in 0..scenes {
        let (known, shown, words) = charts(&sitting);
        assert!(shown.is_none());
        let (_, shown, told) = charts(sitting.press(Key::Space));
        assert_eq!(shown.is_some(), known);
        assert_eq!(told != words, known);
        if let Some(shown) = shown {
            followed += 1;
            assert!(shown.has_energy() && shown.courses.iter().any(|course| course.name == "shipped engine"));
            sitting.press(Key::Space);
        }
        sitting.press(Key::Right);
    }
    assert_eq!(followed, 2);
}

/// Those that come with the game.
fn experiments(root: &Path) {
    let from = Path::new(env!("CARGO_MANIFEST_DIR")).join("experiments");
    for entry in fs::read_dir(&from).unwrap().map(Result::unwrap) {
        let to = root.join("experiments").join(entry.file_name());
        if entry.path().is_dir() {
            fs::create_dir_all(&to).unwrap();
            for file in fs::read_dir(entry.path()).unwrap().map(Result::unwrap) {
                fs::copy(file.path(), to.join(file.file_name())).unwrap();
            }
        } else {
            fs::create_dir_all(root.join("experiments")).unwrap();
            fs::copy(entry.path(), to).unwrap();
        }
    }
}

#[test]
fn an_experiment_is_guessed_flown_and_of_no_account() {
    let mut sitting = Sitting::with(experiments);
    sitting.page(Page::Experiments);
    let chosen = |sitting: &Sitting| sitting.lab().experiments().chosen().unwrap().clone();
    assert_eq!(chosen(&sitting).title, "Free fall");
    assert!(!sitting.lab().experiments().answered());
    assert!(sitting.press(Key::Space).lab().experiments().answered());
    assert!(!sitting.press(Key::Down).lab().experiments().answered(), "each is guessed anew");
    assert_eq!(chosen(&sitting).folder, "terminal-velocity");
    // A click chooses, a second one flies.
    let third = sitting.lab().experiments().list().areas()[2];
    sitting.click(third);
    assert_eq!(chosen(&sitting).folder, "force-mass-acceleration");
    sitting.click(third);
    let flight = sitting.app.screen().get::<Flight>().expect("it flies");
    assert!(flight.details(), "what acts is what it is about");
    assert_eq!(flight.game().level().name, "force-mass-acceleration");
    // Nobody's attempts grow by it, and its end leads back to it.
    sitting.app.grant(Request::Experiment("lift".into()), &mut ());
    let flight = sitting.app.screen().get::<Flight>().expect("it flies");
    let (level, result) = (std::sync::Arc::new(flight.game().level().clone()), flight.game().result());
    sitting.app.grant(Request::Score(Attempt::by_hand(level), result, None), &mut ());
    assert_eq!((sitting.lab().page(), chosen(&sitting).folder.as_str()), (Page::Experiments, "lift"));
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
    let sitting = Sitting::with(|root| write(root, &charts, None));
    let page = sitting.lab().charts();
    assert_eq!(page.problem(), None);
    assert!(same(page.charts(), &charts));
    assert!(page.source().contains("a machine of my own") && !page.source().contains("Came with the game"));
    let sitting = Sitting::new();
    assert!(same(sitting.lab().charts().charts(), &kept::charts().unwrap()));
    assert!(sitting.lab().charts().source().contains("Came with the game"));
}

#[test]
fn damaged_charts_are_told_and_the_shipped_ones_shown() {
    let charts = kept::charts().unwrap();
    for (file, text, problem) in [
        (
            "fall.csv",
            Some("method,origin,step,work,error\nRK4,lab,1,fast,0\n"),
            "charts/fall.csv:2: column \"work\": found \"fast\"",
        ),
        ("fall.csv", None, "charts/fall.csv: "),
        ("scenes.csv", Some(""), "charts/scenes.csv: found nothing"),
        ("stress.csv", Some("\0\0\0"), "charts/stress.csv:1: found "),
        ("setting.csv", None, "charts/setting.csv: "),
    ] {
        let sitting = Sitting::with(|root| write(root, &charts, Some((file, text))));
        let page = sitting.lab().charts();
        assert!(page.problem().unwrap().starts_with(problem), "{:?}", page.problem());
        assert!(same(page.charts(), &charts));
    }
    // No folder of files at all.
    let sitting = Sitting::with(|root| fs::write(root.join("charts"), "").unwrap());
    assert!(sitting.lab().charts().problem().is_some() && sitting.lab().charts().measured().is_some());
    let sitting = Sitting::with(|root| {
        write(root, &charts, Some(("pi.csv", None)));
        fs::create_dir(root.join("charts/pi.csv")).unwrap();
    });
    assert!(sitting.lab().charts().problem().unwrap().starts_with("charts/pi.csv: found a folder"));
}

#[test]
fn a_scene_without_points_is_shown_all_the_same() {
    let mut charts = kept::charts().unwrap();
    charts.diagrams.truncate(1);
    charts.diagrams[0].curves.clear();
    charts.stress.clear();
    let mut sitting = Sitting::with(|root| write(root, &charts, None));
    for key in [Key::Down, Key::Up, Key::Left, Key::Right, Key::End] {
        sitting.press(key);
    }
    let page = sitting.lab().charts();
    assert_eq!((page.problem(), page.verdict(), page.picked()), (None, None, None));
    assert!(sitting.page(Page::Survival).press(Key::End).lab().survival().range().is_empty());
}
