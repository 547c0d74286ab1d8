//! The plot beside a flight: what it shows, where it leads, and what it writes.

use crate::lesson::{columns, experiment, free_fall, open_plot, written};
use crate::sitting::{HERE, Sitting, level};
use crate::support::shipped::{fixture, flown};
use proptest::prelude::*;
use resultant::draw::Canvas;
use resultant::draw::layout::{Frame, Vec2};
use resultant::game::{Controls, Game, History};
use resultant::instruments::fit::Fit;
use resultant::physics::BodyId;
use resultant::screens::{Input, Key, Plot, PlotPlaces, Stage};
use resultant::ui::{Memory, PassInput};
use resultant::view::focus::Focus;
use std::fs;

fn plot(sitting: &Sitting) -> &Plot {
    sitting.flight().instruments().plot()
}

fn value(sitting: &Sitting, number: usize) -> Option<f64> {
    plot(sitting).readings()[number].numbers[0].0
}

/// A fall that stands still after a second, with the plot of its first ball.
fn falling() -> Sitting {
    let mut sitting = free_fall();
    sitting.wait(1.0).press(Key::B);
    open_plot(&mut sitting);
    sitting.wait(0.1);
    sitting
}

fn names(sitting: &Sitting) -> Vec<String> {
    plot(sitting).readings().into_iter().map(|reading| reading.name).collect()
}

#[test]
fn what_is_asked_for_late_is_there_from_the_first_tick() {
    let mut sitting = falling();
    sitting.click("Curve 2: v_y").click("E_kin").click("+ Curve").click("E_mech");
    assert_eq!(names(&sitting), ["Ball 1 y", "Ball 1 E_kin", "Ball 1 E_mech"]);
    sitting.click("CSV").rest();
    let table = columns(&written(&sitting), &["tick", "Ball 1 E_kin (J)", "Ball 1 E_mech (J)"]);
    assert_eq!((table[0].len() as u64, table[0][0], table[1][0]), (sitting.ticks() + 1, 0.0, 0.0));
    assert!(table[2].iter().all(|energy| (energy - table[2][0]).abs() <= 1e-9 * energy), "it falls freely");
}

#[test]
fn a_click_in_the_plot_leads_to_its_moment_where_the_world_stands_still() {
    let mut sitting = free_fall();
    sitting.wait(0.5);
    open_plot(&mut sitting);
    let followed = sitting.flight().observer().focus().followed;
    assert_eq!(followed, Some(BodyId(1)), "objects are picked out for the plot");
    let at = |sitting: &Sitting, tick| plot(sitting).at(0, tick).unwrap();
    let place = at(&sitting, 20);
    sitting.click_at(place);
    assert!(sitting.ticks() > 60, "what runs goes on");
    sitting.press(Key::B).wait(0.1);
    let end = sitting.flight().history().ticks();
    for tick in [41, 3, end, 20] {
        let place = at(&sitting, tick);
        sitting.click_at(place);
        assert_eq!(sitting.ticks(), tick);
        let speed = sitting.game().world().body(BodyId(1)).velocity.y;
        assert_eq!(value(&sitting, 1), Some(0.0 - speed), "up counts");
    }
    assert_eq!(sitting.flight().observer().focus().followed, followed, "the clicks were the plot's");
    assert!(sitting.flight().is_assisted() && sitting.flight().history().ticks() == end);
    sitting.press(Key::B).wait(0.1).press(Key::B).wait(0.1);
    let tick = sitting.ticks();
    assert!(tick < end && sitting.flight().history().ticks() == tick);
    sitting.click("CSV").rest();
    assert_eq!(columns(&written(&sitting), &["tick"])[0].len() as u64, tick + 1);
}

/// A sideways motion is plotted along x. The area under v is the displacement, also across an impact.
#[test]
fn it_opens_along_the_motion_and_the_area_under_v_is_the_way() {
    let mut sitting = experiment("third-law");
    sitting.wait(0.1);
    open_plot(&mut sitting);
    assert_eq!(names(&sitting), ["Box 1 x", "Box 1 v_x"]);
    sitting.wait(3.5).press(Key::B).wait(0.1);
    let history = sitting.flight().history();
    let place = |game: &Game| game.world().body(BodyId(1)).position.x;
    let moved = place(sitting.game()) - place(&history.at(0));
    assert!(sitting.game().world().body(BodyId(1)).velocity.x == 0.0 && moved > 12.0, "it was stopped: {moved}");
    let area = plot(&sitting).readings()[1].numbers[2].0.unwrap();
    assert!((area - moved).abs() <= 1e-12 * moved, "{area} m for {moved} m");
    assert_eq!(plot(&sitting).readings()[0].numbers[2].0, None, "the area under a place says nothing");
}

/// Two compared objects have a column of both; a column of all is there only while no object is followed, without the idle ship.
#[test]
fn the_table_does_not_mix_pairs() {
    let mut sitting = experiment("momentum");
    sitting.wait(0.1).press(Key::I).click("Energy, work");
    let table = |sitting: &Sitting| sitting.flight().instruments().measures().table().clone();
    let momentum = |sitting: &Sitting| table(sitting).lines[0].values.clone();
    assert_eq!((table(&sitting).columns, momentum(&sitting)), (vec!["Box 1".to_owned()], vec!["12.0 N·s".to_owned()]));
    let held = [Key::Shift].into_iter().collect();
    sitting.give(Input { click: true, pointed: Some(BodyId(2)), held, pointer: Vec2::new(640.0, 700.0), ..Input::default() });
    sitting.wait(0.1);
    assert_eq!(table(&sitting).columns, ["Box 1", "Box 2", "Both"]);
    assert_eq!(momentum(&sitting), ["12.0 N·s", "0 N·s", "12.0 N·s"]);
    sitting.give(Input { click: true, pointer: Vec2::new(640.0, 700.0), ..Input::default() }).wait(0.1);
    assert_eq!((table(&sitting).columns[1].as_str(), momentum(&sitting)[1].as_str()), ("All", "36.0 N·s"));
}

#[test]
fn two_objects_are_compared_in_four_curves_and_no_more() {
    let mut sitting = free_fall();
    sitting.wait(0.3).press(Key::B);
    open_plot(&mut sitting);
    let pick = |sitting: &mut Sitting, body, shift: bool| {
        let held = if shift { [Key::Shift].into_iter().collect() } else { Default::default() };
        sitting.give(Input {
            click: true,
            pointed: Some(BodyId(body)),
            held,
            pointer: Vec2::new(640.0, 200.0),
            ..Input::default()
        });
        sitting.wait(0.1);
    };
    pick(&mut sitting, 3, true);
    assert_eq!(names(&sitting), ["Ball 1 y", "Ball 1 v_y", "Ball 3 y", "Ball 3 v_y"]);
    assert_eq!(value(&sitting, 1), value(&sitting, 3), "all fall alike");
    assert!(!sitting.labels().contains(&"+ Curve"));
    sitting.click("1st: Ball 1");
    pick(&mut sitting, 2, false);
    assert_eq!(names(&sitting)[0], "Ball 1 y");
    sitting.click("1st: Ball 1, kept").wait(0.1);
    assert_eq!(names(&sitting)[..2], ["Ball 2 y", "Ball 2 v_y"]);
    (0..4).for_each(|_| _ = sitting.click("Curve 1: ×"));
    assert!(names(&sitting).is_empty() && !sitting.labels().contains(&"Curve 1: ×"));
    sitting.click("CSV").rest();
    assert_eq!(sitting.warning().as_deref(), Some("There is no curve to be exported."));
    (0..4).for_each(|_| _ = sitting.click("+ Curve").click_at(Vec2::new(640.0, 100.0)));
    assert!(names(&sitting).len() == 4 && !sitting.labels().contains(&"+ Curve"));
}

#[test]
fn one_quantity_over_another_has_its_area_and_its_cursor() {
    let mut sitting = falling();
    sitting.click("Across: t").click("y").click("Curve 2: v_y").click("F_y");
    let [_, _, (work, unit)] = plot(&sitting).readings()[1].numbers;
    let ball = sitting.game().world().body(BodyId(1)).clone();
    let kinetic = 0.5 * ball.mass * ball.velocity.length_squared();
    // Before the first tick nothing acted yet: the trapezoid of that tick is half as high.
    assert!((work.unwrap() - kinetic).abs() <= 1e-3 * kinetic, "{work:?} {kinetic}");
    assert_eq!(unit.name(), "J");
    let place = plot(&sitting).at(1, 90).unwrap();
    sitting.click_at(place);
    assert_eq!(sitting.ticks(), 90);
}

#[test]
fn the_wheel_shows_less_of_the_flight_and_shift_marks_a_stretch() {
    let mut sitting = falling();
    let at = |sitting: &Sitting, tick| plot(sitting).at(1, tick).unwrap();
    let (from, to) = (at(&sitting, 30), at(&sitting, 90));
    let shift = [Key::Shift].into_iter().collect();
    let now = sitting.ticks();
    sitting.give(Input { pointer: from, click: true, holding: true, held: shift, ..Input::default() });
    sitting.give(Input { pointer: to, holding: true, held: shift, ..Input::default() }).rest();
    let area = plot(&sitting).readings()[1].numbers[2].0.unwrap();
    let fallen = 0.5 * 9.81 * (0.75_f64.powi(2) - 0.25_f64.powi(2));
    assert!((area + fallen).abs() <= 1e-9 * fallen && sitting.ticks() == now, "{area} {fallen}");
    assert!(!sitting.labels().contains(&"Whole flight"));
    for _ in 0..5 {
        sitting.give(Input { pointer: from, wheel: 1.0, ..Input::default() });
    }
    assert!((at(&sitting, 30) - from).length() < 1.0, "what the pointer shows stays below it");
    assert!(at(&sitting, 31).x - from.x > 2.0 * (to.x - from.x) / 60.0);
    sitting.click("Whole flight");
    assert!((at(&sitting, 90) - to).length() < 1.0 && !sitting.labels().contains(&"Whole flight"));
}

#[test]
fn where_nothing_can_be_written_that_is_said_and_nothing_is_there() {
    let mut sitting = free_fall();
    fs::write(sitting.folder.path().join("exports"), "a file").unwrap();
    open_plot(&mut sitting);
    sitting.click("CSV").rest();
    let words = sitting.warning().unwrap();
    assert!(words.contains("exports") && words.contains("cannot keep the curves"), "{words}");
    assert_eq!(fs::read_to_string(sitting.folder.path().join("exports")).unwrap(), "a file");
}

#[test]
fn a_flight_that_has_ended_stays_to_be_looked_at_while_it_is_plotted() {
    let mut sitting = Sitting::with(|root| level(root, "0", HERE, ""));
    sitting.fly("0");
    open_plot(&mut sitting);
    sitting.wait(3.0);
    assert_eq!(sitting.at(), "flight");
    sitting.press(Key::Enter);
    assert_eq!(sitting.at(), "scoring");
}

#[test]
fn a_watched_flight_is_plotted_and_gone_through() {
    let mut sitting = Sitting::with(|root| level(root, "0", "PLAYER,380,60,40,40\n", ""));
    sitting.fly("0");
    sitting.hold_until(&[Key::Space], |sitting| sitting.at() != "flight").wait(0.5).choose("Watch").press(Key::I);
    sitting.click("Plot").wait(0.3);
    assert!(sitting.labels().contains(&"Pause"));
    let place = sitting.flight().instruments().plot().at(1, 25).unwrap();
    sitting.click_at(place);
    assert!(sitting.labels().contains(&"Play") && sitting.ticks() == 25, "{}", sitting.ticks());
}

/// A flight of the fixture 1: `thrust` ticks with thrust, then without.
fn thrusting(thrust: u64, ticks: u64) -> (Game, History) {
    flown(fixture("1"), (0..ticks).map(|tick| Controls { thrust: tick < thrust, ..Controls::default() }))
}

#[test]
fn the_run_before_shares_the_axes_of_the_run() {
    let ((game, history), (_, longer)) = (thrusting(60, 200), thrusting(100, 800));
    let shorter = longer.until(400);
    let focus = Focus::default();
    let stage = |before| Stage {
        game: &game,
        history: &history,
        focus: &focus,
        varied: None,
        seekable: true,
        before,
        seen: true,
        sign: 0.0,
    };
    let (input, mut plot) = (Input { frame_time: 0.01, ..Input::default() }, Plot::default());
    let canvas = Canvas::new(input.frame);
    let settle = |plot: &mut Plot, before| {
        for _ in 0..20 {
            let pass = PassInput { input: &input, canvas: &canvas, spectator: &mut (), time: 0.0 };
            Memory::default().act(pass, |ui| plot.show(ui, &input, &stage(before)));
        }
    };
    settle(&mut plot, None);
    let alone = plot.at(0, 200).unwrap();
    settle(&mut plot, Some(&longer));
    let beside = plot.at(0, 200).unwrap();
    let left = plot.at(0, 0).unwrap().x;
    assert!(((beside.x - left) / (alone.x - left) - 0.25).abs() < 1e-3, "four times as long: {alone} {beside}");
    settle(&mut plot, Some(&shorter));
    let part = |plot: &Plot| (plot.at(0, 200).unwrap().x - left) / (alone.x - left);
    assert!((part(&plot) - 0.5).abs() < 1e-3);
    settle(&mut plot, Some(&longer));
    assert!((part(&plot) - 0.25).abs() < 1e-3);
    let mut plot = plot.of_another_flight();
    settle(&mut plot, Some(&longer));
    assert_eq!(plot.at(0, 200), Some(beside));
    settle(&mut plot, None);
    assert_eq!(plot.at(0, 200), Some(alone));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]
    #[test]
    fn the_panel_lies_in_every_window(width in 500.0..3000.0_f32, height in 400.0..2000.0_f32, text in 0.75..1.5_f32, large: bool) {
        let frame = Frame::of_window(Vec2::new(width, height)).with_text(text);
        let places = PlotPlaces::new(&frame, large);
        let inside = |min: Vec2, max: Vec2| min.cmpge(places.panel.min).all() && max.cmple(places.panel.max() + 0.01).all();
        prop_assert!(places.panel.max().cmple(frame.size + 0.01).all() && places.panel.min.y > 0.3 * frame.size.y);
        for area in places.lines.iter().chain([&places.plot, &places.foot]).chain(&places.lanes(4)) {
            prop_assert!(inside(area.min, area.max()) && area.size.min_element() > 0.0, "{area:?} {places:?}");
        }
        prop_assert!(places.lines.iter().all(|line| line.max().x < places.plot.min.x && line.max().y <= places.foot.min.y));
    }
}

/// The fit that the plot shows, after some clicks on its button.
fn fitted(sitting: &mut Sitting, before: &str, law: &str) -> Fit {
    sitting.click(&format!("Fit: {before}"));
    assert!(sitting.shows(&format!("Fit: {law}")));
    *plot(sitting).fit().unwrap()
}

#[test]
fn a_fall_fits_a_parabola_with_half_of_g_and_its_speed_a_line() {
    let mut sitting = falling();
    assert_eq!(plot(&sitting).fit(), None);
    fitted(&mut sitting, "none", "line");
    let parabola = fitted(&mut sitting, "line", "parabola");
    assert!((parabola.c[2] + 9.81 / 2.0).abs() < 1e-9 && parabola.residual < 1e-10, "{parabola:?}");
    assert!(sitting.shows("y = −4.9050 m/s²·t²"), "the foot names its figures");
    sitting.click("Curve 2").rest();
    let tick = |seconds: f64| (seconds * 120.0) as u64;
    for (click, at) in [(true, 0.2), (false, 0.6)] {
        let pointer = plot(&sitting).at(1, tick(at)).unwrap();
        let held = [Key::Shift].into_iter().collect();
        sitting.give(Input { pointer, click, holding: true, held, ..Input::default() });
    }
    sitting.rest().click("Fit: parabola").click("Fit: sine");
    let line = fitted(&mut sitting, "none", "line");
    assert!((line.c[1] + 9.81).abs() < 1e-9 && line.residual < 1e-12, "{line:?}");
    assert!((line.from - 0.2).abs() < 0.02 && (line.to - 0.6).abs() < 0.02, "{line:?}");
    sitting.click("SVG").rest();
    let picture = fs::read_to_string(written(&sitting)).unwrap();
    assert!(picture.contains("v_y = −9.8100 m/s²·t") && picture.contains("fill=\"#ffffff\"/>\n"), "{}", &picture[..600]);
}

#[test]
fn every_lane_names_two_numbers_also_where_four_share_the_height() {
    let mut sitting = falling();
    for quantity in ["a_y", "E_kin"] {
        sitting.click("+ Curve").click(quantity);
    }
    sitting.rest();
    assert_eq!(names(&sitting).len(), 4);
    let places = PlotPlaces::new(&sitting.frame, false);
    let left = places.plot.min.x;
    let texts = sitting.texts();
    for lane in places.lanes(4) {
        let here = |at: Vec2| at.x < left && at.x > left - 80.0 && (lane.min.y - 1.0..=lane.max().y + 1.0).contains(&at.y);
        let named = texts.iter().filter(|(_, at)| here(*at)).count();
        assert!(named >= 2, "{named} in {lane:?}");
    }
}
