//! Every change that a sheet suggests can be made in the window: by the fields of "What if", for the object that is followed and for the
//! level. What is flown then is the level with that change in its files.

use crate::lesson::opened;
use crate::sheet;
use crate::sitting::Sitting;
use crate::support::shipped::project;
use crate::what_if::{number, type_in};
use resultant::level::{Level, Parameter};
use resultant::screens::Key;

/// A part of a change, as in "`mass` 20 in row 2 of `objects.csv`", as numbers to type.
fn by_hand(part: &str, level: &Level) -> Vec<(Parameter, String)> {
    let (setting, place) = part.rsplit_once(" in ").unwrap();
    let (column, value) = setting.trim_start_matches('`').split_once("` ").unwrap();
    let value = value.split_once(" (").map_or(value, |(value, _)| value);
    let (row, file) = place.split_once(" of ").unwrap_or(("", place));
    let (file, metre) = (file.trim_matches('`'), level.metre);
    let rows = match row.strip_prefix("row ") {
        Some(row) => vec![row.parse::<usize>().unwrap() - 1],
        None if file == "hazards.csv" => (0..level.streams.len()).collect(),
        None => (0..level.objects.len()).collect(),
    };
    let parsed = |text: &str| text.parse::<f64>().unwrap();
    let up = |text: &str| (level.size.y - parsed(text) / metre).to_string();
    let one = |row: usize| match (file, column) {
        ("constants.csv", "gravity") => (Parameter::Gravity, value.to_owned()),
        ("constants.csv", "air_density") => (Parameter::Air, value.to_owned()),
        ("objects.csv", "mass") => (Parameter::Mass(row + 1), value.to_owned()),
        ("objects.csv", "drag") => (Parameter::Drag(row + 1), value.to_owned()),
        ("objects.csv", "restitution") => (Parameter::Restitution(row + 1), value.to_owned()),
        ("objects.csv", "vx") => (Parameter::VelocityX(row + 1), value.to_owned()),
        ("objects.csv", "vy") => (Parameter::VelocityY(row + 1), (0.0 - parsed(value)).to_string()),
        ("objects.csv", "x") => (Parameter::PlaceX(row + 1), (parsed(value) / metre).to_string()),
        ("objects.csv", "y") => (Parameter::PlaceY(row + 1), up(value)),
        ("objects.csv", "image") => {
            let width = value.split_once(':').unwrap().1.split_once('x').unwrap().0;
            (Parameter::Width(row + 1), (parsed(width) / metre).to_string())
        }
        ("hazards.csv", "force_x") => (Parameter::Stream(row), value.to_owned()),
        ("world.csv", "material") => (Parameter::Material(row), value.to_owned()),
        ("links.csv", "stiffness") => (Parameter::Stiffness(row), value.to_owned()),
        ("links.csv", "damping") => (Parameter::Damping(row), value.to_owned()),
        ("links.csv", "breaks") => (Parameter::Breaks(row), value.to_owned()),
        ("fluids.csv", "density") => (Parameter::Density(row), value.to_owned()),
        ("movers.csv", "y") => (Parameter::From(row), up(value)),
        ("movers.csv", "way_points") => (Parameter::To(row), up(value.rsplit_once(' ').unwrap().1)),
        ("movers.csv", "speed") => (Parameter::Speed(row), value.to_owned()),
        ("movers.csv", "ease") => (Parameter::Ease(row), value.to_owned()),
        other => panic!("nothing in the window makes {part}: {other:?}"),
    };
    let all = rows.into_iter().map(one);
    if file == "constants.csv" { all.take(1).collect() } else { all.collect() }
}

/// Follows the object that a number is of, and turns to its page.
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
            let level = sitting.game().level().clone();
            for (parameter, text) in suggested.change.split("; ").flat_map(|part| by_hand(part, &level)) {
                show(&mut sitting, parameter);
                type_in(&mut sitting, parameter, &text);
                let usual = sitting.flight().attempt_level();
                let changed = sitting.flight().variation().is_some_and(|variation| variation.get(parameter).is_some());
                assert!(
                    changed || parameter.of(usual) == parameter.parse(&text).ok(),
                    "{folder}, {parameter:?}: {text} is not taken"
                );
            }
            let (wanted, flown) = (sheet::level(&folder, suggested.change), sitting.game().level());
            let (wanted, flown) = (numbers(&wanted), numbers(flown));
            assert_eq!(wanted.len(), flown.len(), "{folder}, {}", suggested.change);
            for (wanted, flown) in wanted.iter().zip(&flown) {
                assert!(
                    (wanted - flown).abs() <= 1e-9 * wanted.abs().max(1.0),
                    "{folder}, {}: {flown}, not {wanted}",
                    suggested.change
                );
            }
            assert!(
                sitting.flight().before().is_some() && sitting.shows("What if: ") && sitting.shows("(was"),
                "{folder}: what changed"
            );
            made += 1;
        }
    }
    assert!(made >= 65, "{made}");
}
