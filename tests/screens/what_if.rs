//! "What if": a level is varied while it is flown, beside the run before, and nothing of it counts.

use crate::sitting::{Sitting, level};
use resultant::draw::Shape;
use resultant::draw::layout::Vec2;
use resultant::game::{Outcome, SHIP};
use resultant::level::{self, Parameter};
use resultant::physics::DVec2;
use resultant::screens::{Attempt, Destination, Input, Instrument, Key, Request, Rival};
use resultant::ui::WidgetKind;
use resultant::view::theme;
use std::fs;
use std::sync::Arc;

/// A level that lasts: a ship in free fall, and a ball.
const BALL: &str = "x,y,image,mass,drag,circular,restitution\n600,300,ball:30x30,10,0.5,TRUE,0.5\n";

pub fn varying() -> Sitting {
    let mut sitting = Sitting::with(|root| fs::write(root.join("levels/2/objects.csv"), BALL).unwrap());
    open(sitting.fly("2"));
    sitting
}

fn open(sitting: &mut Sitting) {
    sitting.press(Key::I).click("What if …");
    assert!(sitting.flight().instruments().uses(Instrument::Vary));
    assert!(sitting.shows(" and level"));
}

pub fn number(parameter: Parameter) -> String {
    format!("{}: number", parameter.name())
}

pub fn type_in(sitting: &mut Sitting, parameter: Parameter, text: &str) {
    sitting.click(&number(parameter));
    sitting.press_all(&[Key::Backspace; 40]);
    sitting.write(text).press(Key::Enter);
}

/// The label of the open number or name, and its text.
fn entry(sitting: &Sitting) -> Option<(String, String)> {
    let widget = sitting.app.memory.widgets().iter().find(|widget| widget.kind == WidgetKind::Field)?;
    Some((widget.label.clone(), sitting.field()))
}

/// The message of the panel, which its tooltip shows in full, and whether it is bad.
pub fn message(sitting: &mut Sitting) -> Option<(String, bool)> {
    let panel = sitting.flight().instruments().vary_area()?;
    let is_message = |(text, at): &(String, Vec2)| {
        let colour = sitting.colour(text);
        panel.contains(*at) && at.y > panel.max().y - 40.0 && (colour == theme::good() || colour == theme::bad())
    };
    let (text, at) = sitting.texts().into_iter().find(is_message)?;
    let bad = sitting.colour(&text) == theme::bad();
    sitting.point_at(at);
    let shapes = sitting.app.canvas().shapes();
    let layer = shapes.rsplit(|shape| *shape == Shape::Layer).next()?;
    let lines = layer.iter().filter_map(|shape| if let Shape::Text { text, .. } = shape { Some(text.as_str()) } else { None });
    Some((lines.collect::<Vec<_>>().join(" "), bad))
}

fn ship(sitting: &Sitting) -> DVec2 {
    sitting.game().world().body(SHIP).position
}

fn attempts(sitting: &Sitting) -> usize {
    sitting.scores_file("attempts.csv").lines().count().saturating_sub(1)
}

fn value(sitting: &Sitting, parameter: Parameter) -> f64 {
    parameter.of(sitting.game().level()).unwrap()
}

#[test]
fn a_typed_number_is_flown_at_once_by_the_same_keys_beside_the_run_before() {
    let mut sitting = varying();
    sitting.hold(&[Key::Space, Key::Right], 20).press(Key::B);
    let before = sitting.game().clone();
    let tape = sitting.flight().history().tape();
    type_in(&mut sitting, Parameter::Gravity, "3.5");
    let flight = sitting.flight();
    assert_eq!((flight.game().ticks(), flight.game().level().gravity), (before.ticks(), 3.5), "the same moment");
    assert_eq!(flight.attempt().level.gravity, 15.0, "the level itself is as it was");
    let mut again = tape.fly_in(flight.game().shared_level().clone(), before.ticks()).unwrap();
    assert!(again.fly(u64::MAX));
    assert_eq!(again.done().0.hash(), flight.game().hash());
    let ghost = flight.game_before().expect("the run before stays");
    assert_eq!((ghost.hash(), flight.before().unwrap().ticks()), (before.hash(), before.ticks()));
    assert!(ship(&sitting).y < ghost.world().body(SHIP).position.y - 0.01, "it fell less");
    assert!(sitting.flight().observer().frozen() && sitting.flight().is_assisted());

    // The ghost goes along backwards, forwards, and beyond its end by the keys of the run on the screen.
    sitting.press_all(&[Key::Comma, Key::Comma]);
    assert_eq!(sitting.flight().game_before().unwrap().ticks(), before.ticks() - 2);
    sitting.press_all(&[Key::Period, Key::Period, Key::Period]);
    let (flight, ticks) = (sitting.flight(), before.ticks() + 1);
    assert_eq!([flight.game().ticks(), flight.game_before().unwrap().ticks(), flight.before().unwrap().ticks()], [ticks; 3]);
    sitting.press(Key::B).wait(0.5);
    let flight = sitting.flight();
    assert_eq!(flight.game_before().unwrap().ticks(), flight.game().ticks());
    assert_eq!(flight.game_before().unwrap().level().gravity, 15.0);
    let end = flight.game().ticks();
    sitting.press(Key::B).press_all(&[Key::Comma; 10]).press(Key::B).wait(0.05);
    assert!(sitting.flight().before().unwrap().ticks() < end);
    assert_eq!(sitting.flight().game_before().unwrap().ticks(), sitting.ticks());
}

#[test]
fn what_is_typed_flies_nothing_and_what_will_not_do_says_what_would() {
    let mut sitting = varying();
    let mass = number(Parameter::Mass(0));
    sitting.click(&mass);
    assert_eq!(entry(&sitting), Some((mass.clone(), "100".into())));
    let (fuel, angle) = (sitting.game().ship().fuel, sitting.game().ship().angle);
    sitting.press_all(&[Key::Space, Key::Left, Key::B, Key::I, Key::Tab, Key::F3]);
    sitting.hold(&[Key::Space], 1);
    let flight = sitting.flight();
    assert_eq!((flight.game().ship().fuel, flight.game().ship().angle), (fuel, angle));
    assert!(!flight.observer().frozen() && !sitting.scene().overlays.details);
    assert!(flight.instruments().is_open() && !sitting.labels().contains(&"Resume"));
    let ticks = flight.game().ticks();
    sitting.press(Key::R);
    assert!(sitting.ticks() > ticks);
    assert_eq!(sitting.press(Key::Escape).at(), "flight", "Esc gives it up");
    assert!(entry(&sitting).is_none() && sitting.flight().variation().is_none());

    for (text, told) in [
        ("0", "Expected a number above 0 kg."),
        ("1e9", "Expected a number from 0.001 to 100000 kg."),
        ("1,5,2", "Expected a number such as 12.5."),
        ("nan", "Expected a finite number."),
        ("", "Expected a number such as 12.5."),
    ] {
        type_in(&mut sitting, Parameter::Mass(0), text);
        assert_eq!(message(&mut sitting), Some((told.to_owned(), true)));
        assert_eq!(entry(&sitting), Some((mass.clone(), text.into())));
        sitting.press(Key::Escape);
        assert!(sitting.flight().variation().is_none());
    }
    type_in(&mut sitting, Parameter::Mass(0), "2,5");
    assert_eq!(value(&sitting, Parameter::Mass(0)), 2.5, "a comma is a decimal mark here");
    // Typed text replaces the number, unless the caret was moved.
    sitting.click(&mass).write("2").write("5").press(Key::Enter);
    assert_eq!(value(&sitting, Parameter::Mass(0)), 25.0);
    sitting.click(&mass).press(Key::Home).write("1").press(Key::Enter);
    assert_eq!(value(&sitting, Parameter::Mass(0)), 125.0);
    let enter = Input { pressed: [Key::Enter].into_iter().collect(), typed: "7".into(), ..Input::default() };
    sitting.click(&mass).write("1").give(enter);
    assert_eq!(value(&sitting, Parameter::Mass(0)), 17.0, "typed in the frame of Enter");
    sitting.click(&mass).press(Key::Backspace).write("100").press(Key::Enter);
    type_in(&mut sitting, Parameter::Thrust, "1e6");
    type_in(&mut sitting, Parameter::Mass(0), "1");
    let (told, bad) = message(&mut sitting).expect("it is refused");
    assert!(bad && told.contains("10000 m/s²"), "{told}");
    assert_eq!((value(&sitting, Parameter::Thrust), value(&sitting, Parameter::Mass(0))), (1e6, 100.0));
    type_in(&mut sitting, Parameter::VelocityY(0), "−2.5");
    assert_eq!(sitting.game().level().player.velocity, DVec2::new(0.0, 2.5));
}

#[test]
fn a_slider_is_dragged_against_one_run_before_and_steps_are_fine() {
    let mut sitting = varying();
    sitting.wait(0.5).press(Key::B);
    let flown = sitting.game().hash();
    let slider = sitting.area(&Parameter::Gravity.name());
    let at = |part: f32| Vec2::new(slider.min.x + slider.size.x * part, slider.centre().y);
    sitting.point_at(at(0.5)).give(Input { pointer: at(0.4), click: true, holding: true, ..Input::default() });
    for part in [0.3, 0.2, 0.1] {
        sitting.give(Input { pointer: at(part), holding: true, ..Input::default() });
        assert_eq!(sitting.flight().game_before().unwrap().hash(), flown, "one drag, one run before");
    }
    sitting.give(Input { pointer: at(-3.0), holding: true, ..Input::default() });
    assert_eq!(value(&sitting, Parameter::Gravity), 0.0);
    sitting.point_at(at(0.9));
    assert_eq!(value(&sitting, Parameter::Gravity), 0.0, "let go");
    let weightless = sitting.game().hash();

    sitting.give(Input { pointer: at(0.5), wheel: 1.0, ..Input::default() });
    assert_eq!((value(&sitting, Parameter::Gravity), sitting.flight().game_before().unwrap().hash()), (0.01, flown), "it goes on");
    let mass = Parameter::Mass(0);
    let over = sitting.area(&mass.name()).centre();
    sitting.give(Input { pointer: over, wheel: 1.0, ..Input::default() });
    assert_eq!(value(&sitting, Parameter::Mass(0)), 110.0);
    assert_ne!(sitting.flight().game_before().unwrap().hash(), flown);
    assert_ne!(sitting.flight().game_before().unwrap().hash(), weightless);
    sitting.click(&number(mass)).press_all(&[Key::Up, Key::Up, Key::Down]).press(Key::Enter);
    assert_eq!(value(&sitting, Parameter::Mass(0)), 120.0);
    sitting.click(&format!("{}: reset", mass.name()));
    assert_eq!((value(&sitting, mass), value(&sitting, Parameter::Gravity)), (100.0, 0.01));
}

#[test]
fn from_now_it_goes_on_where_it_is_and_start_velocities_wait_for_a_start() {
    let mut sitting = varying();
    sitting.wait(0.5).press(Key::B).click("From now");
    assert!(sitting.is_chosen("From now") && !sitting.is_chosen("From the start"));
    let (place, ticks) = (ship(&sitting), sitting.ticks());
    type_in(&mut sitting, Parameter::Gravity, "0");
    assert_eq!((ship(&sitting), sitting.ticks(), value(&sitting, Parameter::Gravity)), (place, ticks, 0.0));
    let falls = sitting.game().world().body(SHIP).velocity.y;
    sitting.press(Key::B).wait(0.25);
    let flight = sitting.flight();
    let now = flight.game().world().body(SHIP).velocity.y;
    assert!(now > 0.5 * falls && now <= falls, "without weight it only brakes: {falls}, {now}");
    assert!(flight.game_before().unwrap().world().body(SHIP).velocity.y > falls, "the run before falls on");
    assert_eq!(flight.game_before().unwrap().ticks(), flight.game().ticks());
    sitting.press(Key::B);
    let back = (sitting.ticks() - ticks) as usize + 5;
    sitting.press_all(&vec![Key::Comma; back]);
    assert_eq!((sitting.ticks(), value(&sitting, Parameter::Gravity)), (ticks - 5, 15.0));
    sitting.click(&number(Parameter::VelocityX(0)));
    assert!(entry(&sitting).is_none());
    sitting.click("From the start");
    type_in(&mut sitting, Parameter::Mass(0), "200");
    let flight = sitting.flight();
    assert_eq!((flight.game().level().gravity, flight.game().ticks()), (0.0, ticks - 5));
    assert_eq!(flight.history().at(0).level().gravity, 0.0);
}

#[test]
fn a_varied_run_that_ends_is_no_attempt_and_leads_back_to_the_level_as_it_is() {
    // Level 1 is completed by its first tick: only that attempt counts.
    let mut sitting = Sitting::new();
    open(sitting.fly("1"));
    assert_eq!((attempts(&sitting), sitting.game().outcome()), (1, Outcome::Completed));
    type_in(&mut sitting, Parameter::Gravity, "3");
    assert_eq!(sitting.game().outcome(), Outcome::Completed);
    sitting.wait(3.0);
    assert_eq!((sitting.at(), attempts(&sitting)), ("flight", 1), "it waits, and is no attempt");
    sitting.click(&format!("{}: reset", Parameter::Gravity.name())).wait(2.0);
    assert_eq!((value(&sitting, Parameter::Gravity), sitting.game().outcome()), (15.0, Outcome::Completed));
    assert!(sitting.flight().variation().is_some_and(|variation| variation.is_empty()));
    assert_eq!((sitting.at(), attempts(&sitting)), ("flight", 1));
    assert!(!sitting.folder.path().join("flights").exists(), "nor is it kept");
    sitting.press(Key::Escape);
    assert!(sitting.flight().variation().is_none() && !sitting.flight().is_assisted());
    sitting.wait(1.5);
    let list = sitting.scores_file("attempts.csv");
    assert_eq!((sitting.at(), attempts(&sitting)), ("scoring", 2), "{list}");
    assert!(sitting.scoring().result.score.total > 10_000 && !sitting.scoring().result.assisted);
}

#[test]
fn reset_all_is_a_fresh_attempt_and_r_begins_the_varied_level_again() {
    let mut sitting = varying();
    sitting.wait(0.3);
    type_in(&mut sitting, Parameter::Gravity, "3");
    let flown = sitting.ticks();
    sitting.press(Key::R);
    let flight = sitting.flight();
    assert!(flight.game().ticks() < 5 && flight.game().level().gravity == 3.0 && flight.variation().is_some());
    assert!(flight.before().unwrap().ticks() >= flown, "the run before stays a ghost");
    sitting.wait(0.2);
    assert_eq!(sitting.flight().game_before().unwrap().ticks(), sitting.ticks());
    sitting.click("Reset all");
    let flight = sitting.flight();
    assert!(flight.game().ticks() < 5 && flight.game().level().gravity == 15.0);
    assert!(flight.variation().is_none() && flight.before().is_none() && !flight.is_assisted());
    type_in(&mut sitting, Parameter::Gravity, "3");
    type_in(&mut sitting, Parameter::Gravity, "15");
    assert!(sitting.flight().variation().is_some_and(|variation| variation.is_empty()) && sitting.flight().is_assisted());
    sitting.press(Key::R);
    assert!(sitting.flight().variation().is_none() && !sitting.flight().is_assisted());
    type_in(&mut sitting, Parameter::Gravity, "3");
    sitting.press(Key::Escape).choose("Level Select").choose("2");
    assert!(sitting.flight().variation().is_none() && sitting.game().level().gravity == 15.0);
}

#[test]
fn neither_recordings_nor_rivals_nor_assists_make_it_count() {
    let flown = {
        let sitting = varying();
        let root = sitting.folder.path();
        Arc::new(level::load(&root.join("levels/1"), root).unwrap().level)
    };
    for recorded in [true, false] {
        let mut sitting = Sitting::new();
        let inputs = recorded.then(Arc::default);
        let rivals = vec![Rival { name: "ann".into(), inputs: Arc::default() }];
        sitting.app.grant(Request::Reset(Destination::Fly(Attempt { level: flown.clone(), inputs, rivals })), &mut ());
        sitting.rest();
        assert!(sitting.flight().race().is_some());
        open(&mut sitting);
        let counted = attempts(&sitting);
        type_in(&mut sitting, Parameter::Mass(0), "20");
        assert!(sitting.flight().race().is_none(), "those flew in the level as it is");
        sitting.wait(3.0);
        assert_eq!((sitting.at(), attempts(&sitting)), ("flight", counted));
        sitting.click("Reset all");
        assert!(sitting.flight().race().is_some());
    }
}

#[test]
fn what_is_varied_is_saved_as_a_level_of_its_own_that_can_be_chosen() {
    let mut sitting = varying();
    type_in(&mut sitting, Parameter::Gravity, "1.62");
    type_in(&mut sitting, Parameter::VelocityY(0), "3");
    let varied = sitting.game().level().clone();
    let levels = sitting.folder.path().join("levels");
    for (typed, name) in [("moon", "moon"), ("", "2-what-if"), ("", "2-what-if-2")] {
        sitting.click("Save as level");
        assert_eq!(entry(&sitting), Some(("Name of the level".into(), "its name, or Enter for any".into())));
        sitting.write(typed).press(Key::Enter);
        let told = message(&mut sitting).expect("it is said where").0;
        assert_eq!(told, format!("Saved as {}", levels.join(name).display()));
        let read = level::load(&levels.join(name), sitting.folder.path()).expect("it loads").level;
        assert_eq!((read.title.as_str(), read.name.as_str()), ("2: what if", name));
        assert_eq!(level::Level { name: varied.name.clone(), title: varied.title.clone(), ..read }, varied);
    }
    for (typed, refusal) in
        [("moon", "there is one of that name already"), ("../x", "letters, digits"), ("jumper", "scores/jumper.csv")]
    {
        sitting.click("Save as level").write(typed).press(Key::Enter);
        let (told, bad) = message(&mut sitting).unwrap();
        assert!(bad && told.contains(refusal), "{told}");
    }
    assert_eq!(fs::read_dir(&levels).unwrap().count(), 5 + 3);
    assert!(sitting.flight().variation().is_some(), "it is flown on");
    sitting.press(Key::Escape).choose("Level Select");
    let names: Vec<&str> = sitting.level_select().entries.iter().map(|entry| entry.name.as_str()).collect();
    assert!(names.contains(&"moon"), "{names:?}");
    sitting.choose("moon");
    assert_eq!((sitting.at(), sitting.game().level().gravity), ("flight", 1.62));
    assert!(sitting.flight().variation().is_none() && !sitting.flight().is_assisted(), "a level like any other");
}

/// A run that ends before the moment on the screen does not lose that moment.
#[test]
fn a_run_that_ends_early_keeps_the_moment_for_the_next_change() {
    let mut sitting = Sitting::with(|root| {
        level(root, "2", "PLAYER,10,10,20,20\n", "0,590,800,10\n");
        fs::write(root.join("levels/2/constants.csv"), "width,800\nheight,600\noptimal_time,10\ngravity,1\n").unwrap();
    });
    open(sitting.fly("2"));
    sitting.wait(1.5).press(Key::B);
    let ticks = sitting.ticks();
    type_in(&mut sitting, Parameter::Gravity, "50");
    assert_eq!(sitting.game().outcome(), Outcome::Failed);
    assert!(sitting.ticks() < ticks);
    type_in(&mut sitting, Parameter::Gravity, "2");
    assert_eq!((sitting.ticks(), sitting.game().outcome()), (ticks, Outcome::Running));
}

#[test]
fn a_long_flight_is_flown_again_over_several_frames() {
    let mut sitting = varying();
    sitting.give(Input { pressed: [Key::RightBracket].into_iter().collect(), ..Input::default() });
    sitting.press_all(&[Key::RightBracket; 3]).wait(40.0).press(Key::B);
    let ticks = sitting.ticks();
    assert!(ticks > 2000, "{ticks}");
    type_in(&mut sitting, Parameter::Gravity, "3");
    sitting.wait(0.5);
    assert_eq!((sitting.ticks(), value(&sitting, Parameter::Gravity)), (ticks, 3.0));
}
