//! The instruments beside a flight: the rail, the panels, and the clicks that each of them takes.

use crate::lesson::experiment;
use crate::sitting::{Sitting, says};
use crate::what_if::varying;
use resultant::draw::layout::{Area, Frame, Vec2};
use resultant::draw::{Contour, Shape};
use resultant::level::Parameter;
use resultant::physics::{BodyId, DVec2};
use resultant::screens::{Input, Instrument, Key};
use resultant::view::theme;

fn flying() -> Sitting {
    let mut sitting = Sitting::with(|_| {});
    sitting.fly("1");
    assert_eq!(sitting.at(), "flight");
    sitting
}

#[test]
fn the_rail_opens_by_key_and_its_buttons_take_their_clicks_from_the_flight() {
    let mut sitting = flying();
    assert!(!sitting.flight().instruments().is_open());
    sitting.press(Key::Tab).press(Key::N).press(Key::I);
    assert!(sitting.flight().instruments().is_open());
    let followed = sitting.flight().observer().focus().followed;
    assert!(followed.is_some());
    sitting.click("Centre of mass");
    assert!(sitting.flight().instruments().uses(Instrument::Centre));
    assert_eq!(sitting.flight().observer().focus().followed, followed, "the click was the button's");
    sitting.give(Input { pointer: Vec2::new(640.0, 200.0), click: true, ..Input::default() });
    assert_eq!(sitting.flight().observer().focus().followed, None, "the click was the flight's");
    sitting.press(Key::R);
    assert!(sitting.flight().instruments().uses(Instrument::Centre), "it stays in use when the level begins again");
    sitting.press(Key::I);
    assert!(!sitting.flight().instruments().uses(Instrument::Centre) && !sitting.flight().is_assisted());
}

/// A free fall, with these instruments in use and the world stopped.
fn measuring(tools: &[Instrument]) -> Sitting {
    let mut sitting = Sitting::with(|folder| {
        let room = "width,1500\nheight,3000\ngravity,10\nair_density,0\n";
        std::fs::write(folder.join("levels/2/constants.csv"), room).unwrap();
    });
    sitting.fly("2").press(Key::I);
    for tool in tools {
        sitting.click(tool.name());
        assert!(sitting.flight().instruments().uses(*tool));
    }
    if !sitting.flight().observer().frozen() {
        sitting.press(Key::B);
    }
    sitting
}

fn fly_for(sitting: &mut Sitting, frames: u32) {
    sitting.press(Key::B);
    (0..frames).for_each(|_| _ = sitting.rest());
    sitting.press(Key::B).rest();
}

#[test]
fn the_ruler_is_laid_taken_again_and_bound_to_bodies() {
    let mut sitting = measuring(&[Instrument::Ruler]);
    let to = |sitting: &mut Sitting, (x, y): (f64, f64), click: bool, holding: bool| {
        let pointer = Vec2::new(600.0 + 20.0 * x as f32, 20.0 * y as f32);
        sitting.give(Input { pointer, place: Some(DVec2::new(x, y)), click, holding, ..Input::default() });
    };
    let drag = |sitting: &mut Sitting, from, towards| {
        to(sitting, from, true, true);
        to(sitting, towards, false, true);
        to(sitting, towards, false, false);
    };
    let read = |sitting: &Sitting| sitting.flight().instruments().measures().ruler.reading(sitting.game().world());
    assert_eq!(read(&sitting), None);
    drag(&mut sitting, (2.0, 30.0), (5.0, 26.0));
    let reading = read(&sitting).unwrap();
    assert_eq!((reading.length, reading.parts), (5.0, DVec2::new(3.0, 4.0)));
    drag(&mut sitting, (5.1, 26.2), (2.0, 18.0));
    assert_eq!(read(&sitting).unwrap().parts, DVec2::new(0.0, 12.0), "its end was taken");
    // An end on the ship goes with the ship, at its lower edge.
    let ship = sitting.game().world().bodies()[0].clone();
    let (half, ship) = (ship.half.y, ship.position);
    drag(&mut sitting, (2.0, 18.0), (ship.x + 0.2, ship.y - 0.1));
    let before = read(&sitting).unwrap().parts;
    assert_eq!(before, DVec2::new(ship.x - 2.0, 30.0 - (ship.y + half)));
    fly_for(&mut sitting, 20);
    let fallen = sitting.game().world().bodies()[0].position.y - ship.y;
    assert!(fallen > 0.2);
    assert!((before.y - read(&sitting).unwrap().parts.y - fallen).abs() < 1e-12);
    sitting.press(Key::Tab).press(Key::N);
    assert!(sitting.flight().observer().focus().followed.is_some());
    let before = read(&sitting);
    to(&mut sitting, (10.0, 10.0), true, true);
    assert!(sitting.flight().observer().focus().followed.is_some(), "as long as it may become a ruler");
    to(&mut sitting, (10.0, 10.0), false, false);
    assert_eq!(sitting.flight().observer().focus().followed, None);
    assert_eq!(read(&sitting), before);
    let rail = sitting.area("Centre of mass").centre();
    sitting.give(Input { pointer: rail, place: Some(DVec2::ZERO), click: true, holding: true, ..Input::default() });
    sitting.give(Input { pointer: rail + 300.0, place: Some(DVec2::ONE), holding: true, ..Input::default() });
    assert_eq!(read(&sitting), before);
}

#[test]
fn the_table_obeys_the_law_of_work_and_energy_as_it_is_written() {
    let mut sitting = measuring(&[Instrument::Figures]);
    fly_for(&mut sitting, 60);
    let text = |sitting: &Sitting, name: &str| {
        let table = sitting.flight().instruments().measures().table();
        table.lines.iter().find(|line| line.name == name).unwrap_or_else(|| panic!("{name}: {table:?}")).values.clone()
    };
    let (start, ship) =
        (sitting.flight().history().start().world().bodies()[0].position, sitting.game().world().bodies()[0].clone());
    let fallen = ship.position.y - start.y;
    let told = |sitting: &Sitting, name: &str, value: f64, unit: &str| {
        let [written] = &text(sitting, name)[..] else { panic!("{name}: one column") };
        assert!(says(written, value, unit), "{name}: {written} for {value} {unit}");
        written.split_once(' ').unwrap().1.to_owned()
    };
    told(&sitting, "Weight", 1000.0 * fallen, "J");
    told(&sitting, "= kinetic gained", 1000.0 * fallen, "J");
    let units = [
        ("Kinetic energy", 1000.0 * fallen),
        ("Potential energy", 1000.0 * (100.0 - ship.position.y)),
        ("Sum of both", 1000.0 * (100.0 - start.y)),
    ]
    .map(|(name, joules)| told(&sitting, name, joules, "J"));
    assert!(units.iter().all(|unit| *unit == units[0]), "what adds up has one unit: {units:?}");
    // y counts up.
    told(&sitting, "Momentum y", -100.0 * ship.velocity.y, "N·s");
    assert_eq!(sitting.flight().instruments().measures().table().columns, ["Ship"], "alone it is all");
    sitting.click("From now");
    assert_eq!(text(&sitting, "= kinetic gained"), ["0 J"]);
    sitting.press(Key::Comma);
    let back = ship.position.y - sitting.game().world().bodies()[0].position.y;
    told(&sitting, "Weight", -1000.0 * back, "J");
    sitting.click("From start");
    told(&sitting, "Weight", 1000.0 * (fallen - back), "J");
}

#[test]
fn a_panel_is_dragged_out_of_the_way_and_stays_in_the_window() {
    let mut sitting = measuring(&[Instrument::Figures]);
    let area = |sitting: &Sitting| sitting.flight().instruments().measures().areas().next().expect("the table");
    let docked = area(&sitting);
    let drag = |sitting: &mut Sitting, by: Vec2| {
        let from = area(sitting).min + 4.0;
        sitting.give(Input { pointer: from, click: true, holding: true, ..Input::default() });
        sitting.give(Input { pointer: from + by, holding: true, ..Input::default() });
        sitting.give(Input { pointer: from + by, ..Input::default() }).rest();
    };
    drag(&mut sitting, Vec2::new(300.0, -40.0));
    assert_eq!(area(&sitting).min, docked.min + Vec2::new(300.0, -40.0));
    drag(&mut sitting, Vec2::new(5000.0, -5000.0));
    let frame = Input::default().frame;
    assert!(area(&sitting).min.y >= 0.0 && area(&sitting).max().x <= frame.size.x);
    sitting.press(Key::R).press(Key::B).rest();
    assert!(area(&sitting).min.x > docked.min.x, "it stays there when the level begins again");
}

/// A ball of 2 kg and restitution 0.9 falls 10 m: at the floor it loses 1 − e² of m·g·h.
#[test]
fn energy_bars_count_what_a_bounce_loses_and_their_zero_moves() {
    let mut sitting = experiment("bounce");
    sitting.wait(0.1).press(Key::I).click("Energy, work").wait(2.0).press(Key::B).rest();
    let bars = |sitting: &Sitting| -> Vec<(&'static str, f64)> {
        let bars = &sitting.flight().instruments().measures().table().bars;
        bars.iter().filter(|bar| bar.unit == "J").map(|bar| (bar.name, bar.values[0])).collect()
    };
    let at_first = bars(&sitting);
    assert_eq!(at_first.iter().map(|(name, _)| *name).collect::<Vec<_>>(), ["Kinetic", "Potential", "Lost"]);
    let whole = 2.0 * 9.81 * 10.0;
    let lost = (1.0 - 0.81) * whole;
    assert!((at_first[2].1 - lost).abs() < 1e-9 * whole, "{at_first:?} for {lost} J");
    let level = sitting.game().level().clone();
    let sum = at_first.iter().map(|(_, value)| value).sum::<f64>();
    let began = sitting.flight().history().start().world().bodies()[1].position.y;
    assert!((sum - 2.0 * 9.81 * (level.size.y - began)).abs() < 1e-9 * sum, "all that there was in the beginning");
    sitting.click("Zero here").rest();
    let ball = sitting.game().world().bodies()[1].clone();
    let here = bars(&sitting);
    assert!(here[1].1.abs() < 1e-9 && here[0] == at_first[0] && here[2] == at_first[2], "{here:?}");
    assert!(sitting.shows("above the bottom"));
    for (down, click, holding) in [(0.1, true, true), (2.0, false, true), (2.0, false, false)] {
        let place = Some(ball.position + DVec2::new(3.0, down));
        sitting.give(Input { pointer: Vec2::new(900.0, 300.0), place, click, holding, ..Input::default() });
    }
    sitting.rest();
    assert!((bars(&sitting)[1].1 - 2.0 * 9.81 * 2.0).abs() < 1e-9, "{:?}", bars(&sitting));
    sitting.click("From now").rest();
    assert!(bars(&sitting)[2].1.abs() < 1e-9);
}

/// The energy of a spring of 900 N/m goes to and fro; nothing of it is lost.
#[test]
fn a_swing_on_a_spring_keeps_the_sum_of_its_bars() {
    let mut sitting = Sitting::with(|folder| {
        std::fs::write(folder.join("levels/2/constants.csv"), "width,1500\nheight,3000\ngravity,10\nair_density,0\n").unwrap();
        let spring = "kind,a,b,length,stiffness,damping,strength,hook,breaks,rate,name\nspring,ship,600 900,0,900,,,,,,\n";
        std::fs::write(folder.join("levels/2/links.csv"), spring).unwrap();
    });
    sitting.fly("2").press(Key::I).click("Energy, work").wait(1.5);
    let bars = &sitting.flight().instruments().measures().table().bars;
    let values: Vec<f64> = bars.iter().filter(|bar| bar.unit == "J").map(|bar| bar.values[0]).collect();
    let sum: f64 = values.iter().sum();
    assert_eq!(bars[2].name, "Elastic");
    assert!(values[2] > 0.0 && values[3].abs() < 1e-6 * sum, "{values:?}");
}

/// 2 kg and 1 kg at 3 m/s each towards each other: 6 N·s and −3 N·s, 3 N·s before and after.
#[test]
fn momentum_is_a_bar_to_the_side_of_its_sign_from_the_middle() {
    let mut sitting = experiment("collision-lab");
    sitting.wait(0.1).press(Key::I).click("Energy, work");
    let held = [Key::Shift].into_iter().collect();
    sitting.give(Input { pointer: Vec2::new(900.0, 400.0), pointed: Some(BodyId(2)), click: true, held, ..Input::default() });
    sitting.rest();
    let momentum = |sitting: &Sitting| {
        let bars = sitting.flight().instruments().measures().table().bars.clone();
        bars.into_iter().find(|bar| bar.name == "Momentum x").expect("it has a bar").values
    };
    let close = |values: &[f64], wanted: &[f64]| values.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-9);
    assert!(close(&momentum(&sitting), &[6.0, -3.0, 3.0]), "{:?}", momentum(&sitting));
    let drawn: Vec<Area> = sitting
        .app
        .canvas()
        .shapes()
        .iter()
        .filter_map(|shape| match shape {
            Shape::Fill { outline: Contour::Rounded(area, _), colour, .. } if *colour == theme::IMPACT => Some(*area),
            _ => None,
        })
        .collect();
    let [first, second, both] = &drawn[..] else { panic!("{drawn:?}") };
    assert!((first.size.x - 2.0 * second.size.x).abs() < 0.5 && (both.size.x - second.size.x).abs() < 0.5, "{drawn:?}");
    let apart = [second.max().x - first.min.x, both.min.x - second.max().x];
    assert!((apart[0] - apart[1]).abs() < 0.5, "from the middle to the left and to the right: {drawn:?}");
    sitting.wait(2.0);
    let after = momentum(&sitting);
    assert!((after[2] - 3.0).abs() < 1e-9 && (after[0] - 6.0).abs() > 1.0, "{after:?}");
}

#[test]
fn in_a_small_window_one_large_panel_is_open_above_the_line_about_the_time() {
    let mut sitting = experiment("bounce");
    sitting.frame = Frame::of_window(Vec2::new(900.0, 500.0));
    sitting.wait(0.5).press(Key::I).click("Plot").press(Key::B).rest();
    let tools = [Instrument::Figures, Instrument::Vary];
    for tool in tools {
        sitting.click(tool.name()).rest();
        let instruments = sitting.flight().instruments();
        assert!(tools.iter().all(|other| instruments.uses(*other) == (*other == tool)), "{tool:?} alone");
        let panels: Vec<_> = instruments.measures().areas().chain(instruments.vary_area()).collect();
        let sign = sitting.place(&sitting.line("Frozen at"));
        assert_eq!(panels.len(), 1);
        assert!(panels[0].min.y >= 0.0 && panels[0].max().y < sign.y - 10.0, "{tool:?}: {:?} above {sign}", panels[0]);
    }
    sitting.frame = Frame::default();
    sitting.rest().click(Instrument::Figures.name());
    assert!(tools.iter().all(|tool| sitting.flight().instruments().uses(*tool)), "where there is room they stand together");
}

#[test]
fn the_panel_is_on_the_screen_and_its_parts_are_apart_in_every_window() {
    for (size, text) in
        [((1280.0, 720.0), 1.0), ((900.0, 500.0), 1.0), ((1280.0, 720.0), 1.5), ((900.0, 500.0), 1.5), ((1920.0, 1080.0), 1.5)]
    {
        let mut sitting = varying();
        sitting.frame = Frame::of_window(Vec2::new(size.0, size.1)).with_text(text);
        sitting.rest();
        let (panel, frame) = (sitting.flight().instruments().vary_area().expect("it is open"), sitting.frame);
        assert!(panel.min.min_element() >= 0.0 && panel.max().cmple(frame.size).all(), "{size:?} {text}: {panel:?}");
        assert!(panel.min.x > frame.size.x / 2.0 + 30.0, "{size:?} {text}: the ship, in the middle, stays in view: {panel:?}");
        let areas: Vec<_> = sitting.areas().into_iter().filter(|area| area.max().x > panel.min.x).collect();
        let lines = Parameter::all(sitting.game().level(), 0).len();
        assert!(areas.len() >= 2 * lines + 4, "sliders, numbers and buttons: {:?}", sitting.labels());
        for area in &areas {
            assert!(area.min.cmpge(panel.min).all() && area.max().cmple(panel.max()).all(), "{area:?} in {panel:?}");
        }
        sitting.assert_whole();
    }
}
