//! Every change that a sheet suggests can be made in the window: by the fields of "What if", for the object that is followed and for the
//! level. What is flown then is the level with that change in its files.

use crate::lesson::opened;
use crate::sheet;
use crate::sitting::Sitting;
use crate::support::shipped::project;
use crate::what_if::{number, type_in};
use resultant::draw::layout::Vec2;
use resultant::level::{Level, Parameter};
use resultant::physics::{BodyId, DVec2, Material};
use resultant::screens::{Input, Key};

fn show(sitting: &mut Sitting, parameter: Parameter) {
    let level = sitting.game().level();
    let tied = |link: usize| level.links[link].def.body.index();
    let body = parameter.body().or(match parameter {
        Parameter::Stiffness(link) | Parameter::Damping(link) | Parameter::Breaks(link) => Some(tied(link)),
        _ => None,
    });
    while body.is_some_and(|body| sitting.flight().observer().focus().followed.map(|id| id.index()) != Some(body)) {
        sitting.press(Key::N);
    }
    if !sitting.labels().contains(&number(parameter).as_str()) {
        sitting.click(if parameter.is_of_a_body() { "Object" } else { "Level and things" });
    }
}

/// What the engine makes of a level: its numbers in their order.
fn numbers(level: &Level) -> Vec<f64> {
    let text = format!("{:?}", level.world_def());
    let parts = text.split(|c: char| !(c.is_ascii_alphanumeric() || matches!(c, '.' | '-' | '+')));
    parts.filter_map(|part| part.parse().ok()).collect()
}

#[test]
fn every_suggested_change_can_be_made_in_the_window() {
    let mut made = 0;
    for sheets::Listed { folder, .. } in sheets::listed(project()).unwrap() {
        let text = sheet::text(&folder);
        for suggested in sheet::variations(&text) {
            let mut sitting = opened(&folder);
            sitting.press(Key::I).click("What if …");
            let (what, wanted) = (format!("{folder}, {}", suggested.change), sheet::level(&folder, suggested.change));
            // The end of a way before its start: both ends in one place are refused.
            for parameter in (0..=wanted.objects.len()).flat_map(|body| Parameter::all(&wanted, body)).rev() {
                let value = parameter.of(&wanted).unwrap();
                if parameter.of(sitting.game().level()) == Some(value) {
                    continue;
                }
                show(&mut sitting, parameter);
                let material = matches!(parameter, Parameter::Material(_)).then(|| Material::ALL[value as usize].name.to_owned());
                type_in(&mut sitting, parameter, &material.unwrap_or_else(|| value.to_string()));
                let taken = sitting.flight().variation().is_some_and(|variation| variation.get(parameter).is_some());
                assert!(taken, "{what}, {parameter:?}: {value} is not taken");
            }
            let (wanted, flown) = (numbers(&wanted), numbers(sitting.game().level()));
            assert_eq!(wanted.len(), flown.len(), "{what}");
            for (wanted, flown) in wanted.iter().zip(&flown) {
                assert!((wanted - flown).abs() <= 1e-9 * wanted.abs().max(1.0), "{what}: {flown}, not {wanted}");
            }
            let told = sitting.flight().before().is_some() && sitting.shows("What if: ") && sitting.shows("(was");
            assert!(told, "{what}: what changed");
            made += 1;
        }
    }
    assert!(made >= 65, "{made}");
}

/// A drag in the level from a place by metres, each of 20 canvas units.
fn drag(sitting: &mut Sitting, from: DVec2, by: DVec2) {
    let pointer = |place: DVec2| Vec2::new(300.0, 300.0) + ((place - from) * 20.0).as_vec2();
    let to = |sitting: &mut Sitting, place: DVec2, click, holding| {
        sitting.give(Input { pointer: pointer(place), place: Some(place), click, holding, ..Input::default() });
    };
    to(sitting, from, true, true);
    for part in [0.3, 0.6, 1.0] {
        to(sitting, from + by * part, false, true);
        assert!(sitting.scene().paused, "the view stands still");
    }
    to(sitting, from + by, false, false);
}

#[test]
fn heights_and_places_are_led_by_the_pointer_and_the_panel_follows() {
    let mut sitting = opened("bounce");
    sitting.press(Key::L).press(Key::I).click("What if …");
    let before = sitting.game().level().objects[1].position;
    drag(&mut sitting, before, DVec2::new(0.52, -1.01));
    let value = |sitting: &Sitting, parameter: Parameter| parameter.of(sitting.game().level()).unwrap();
    let usual = sitting.flight().attempt().level.clone();
    for (parameter, by) in [(Parameter::PlaceX(2), 0.52), (Parameter::PlaceY(2), 1.01)] {
        let (was, now) = (parameter.of(&usual).unwrap(), value(&sitting, parameter));
        assert!((now - was - by).abs() <= 0.05 + 1e-9 && (now * 10.0 - (now * 10.0).round()).abs() < 1e-9, "{parameter:?}: {now}");
        assert!(sitting.labels().contains(&number(parameter).as_str()), "its field is shown");
    }
    assert!(sitting.shows("(was") && sitting.flight().game_before().unwrap().level().objects[1].position == before);
    let (at, kept) = (sitting.game().level().objects[1].position, value(&sitting, Parameter::PlaceX(2)));
    let other = sitting.game().level().objects[2].position;
    drag(&mut sitting, at, other - at);
    assert_ne!(sitting.game().level().objects[1].position, other);
    assert!(sitting.shows("Expected a start in free space.") && value(&sitting, Parameter::PlaceX(2)) != kept);
    let press = |click, holding| Input { pointer: Vec2::splat(300.0), place: Some(other), click, holding, ..Input::default() };
    sitting.give(Input { pointed: Some(BodyId(3)), ..press(true, true) });
    sitting.give(Input { pointed: Some(BodyId(3)), ..press(false, false) });
    assert_eq!(sitting.flight().observer().focus().followed, Some(BodyId(3)));
    // From now on only what a start does not fix can vary.
    sitting.click("From now");
    let (before, place) = (sitting.game().level().clone(), sitting.game().level().objects[0].position);
    sitting.give(Input { place: Some(place), ..press(true, true) });
    sitting.give(Input { place: Some(place - 1.0), pointer: Vec2::splat(250.0), ..press(false, true) });
    assert_eq!(*sitting.game().level(), before);
}

#[test]
fn the_stops_of_a_lift_are_led_up_and_down() {
    let mut sitting = opened("lift");
    sitting.press(Key::L).press(Key::I).click("What if …");
    let end = *sitting.game().level().movers[0].stops.last().unwrap();
    drag(&mut sitting, end, DVec2::new(3.0, 2.0));
    let (level, usual) = (sitting.game().level(), &sitting.flight().attempt().level);
    let value = |level: &Level| Parameter::To(0).of(level).unwrap();
    assert!((value(level) - value(usual) + 2.0).abs() <= 0.05 && level.movers[0].stops[1].x == end.x);
    assert!(sitting.labels().contains(&number(Parameter::To(0)).as_str()), "the page of the level is shown");
}
