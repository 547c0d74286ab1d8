//! The hash by which a record knows its level: levels that are flown differently differ in it, and no others.

use crate::support::rooms::{area, crate_at, objective, room};
use resultant::game::{LevelHash, level_hash};
use resultant::level::{AirStream, Fluid, Level, Look, ObjectiveKind, Solid, Text};
use resultant::physics::{DVec2, Material};

fn full() -> Level {
    let zone = area(1.0, 2.0, 3.0, 4.0);
    Level {
        world: vec![Solid::new(zone, Material::ASPHALT)],
        objects: vec![crate_at(DVec2::new(9.0, 9.0), DVec2::ZERO, None)],
        obstacles: vec![zone],
        streams: vec![AirStream { source: zone, zone, force: DVec2::X, name: None }],
        fluids: vec![Fluid { zone, density: 900.0, viscosity: 1.0, colour: [1, 2, 3] }],
        texts: vec![Text { position: DVec2::ZERO, size: 1.0, text: "Up!".into(), colour: None }],
        ..room()
    }
}

fn changed(change: impl FnOnce(&mut Level)) -> LevelHash {
    let mut level = full();
    change(&mut level);
    level_hash(&level)
}

#[test]
fn whatever_a_flight_or_its_score_depends_on_changes_the_hash() {
    let mut hashes = vec![
        level_hash(&full()),
        changed(|level| level.size.x += 1.0),
        changed(|level| level.gravity += 1.0),
        changed(|level| level.air_density += 1.0),
        changed(|level| level.optimal_time += 1.0),
        changed(|level| level.rest_speed += 1.0),
        changed(|level| level.player.position.x += 1.0),
        changed(|level| level.player.velocity.y += 1.0),
        changed(|level| level.player.angle += 1.0),
        changed(|level| level.player.mass += 1.0),
        changed(|level| level.player.fuel += 1.0),
        changed(|level| level.player.thrust = level.player.thrust.next_up()),
        changed(|level| level.player.feels_air = false),
        changed(|level| level.world.clear()),
        changed(|level| level.world[0].material = Material::ICE),
        changed(|level| level.world[0].bounds.max.x += 1.0),
        changed(|level| level.objects[0].position.x += 1.0),
        changed(|level| level.objects[0].velocity.x += 1.0),
        changed(|level| level.objects[0].size.x += 1.0),
        changed(|level| level.objects[0].mass += 1.0),
        changed(|level| level.objects[0].drag += 1.0),
        changed(|level| level.objects[0].restitution += 0.5),
        changed(|level| level.objects[0].circular = true),
        changed(|level| level.objects[0].key = Some([0; 3])),
        changed(|level| level.objects.push(level.objects[0].clone())),
        changed(|level| level.objectives[0].kind = ObjectiveKind::Physics),
        changed(|level| level.objectives[0].bounds.min.x += 0.5),
        changed(|level| level.objectives[0].hold = 1.0),
        changed(|level| level.objectives[0].order = Some(1)),
        changed(|level| level.objectives[0].colour = Some([1, 2, 3])),
        changed(|level| level.objectives.push(objective(ObjectiveKind::Player, area(0.0, 0.0, 1.0, 1.0)))),
        changed(|level| level.obstacles[0].min.y += 1.0),
        changed(|level| level.streams[0].source.min.y += 1.0),
        changed(|level| level.streams[0].zone.min.y += 1.0),
        changed(|level| level.streams[0].force.y += 1.0),
        changed(|level| level.fluids[0].zone.min.y += 1.0),
        changed(|level| level.fluids[0].density += 1.0),
        changed(|level| level.fluids[0].viscosity += 1.0),
    ];
    let count = hashes.len();
    hashes.sort_unstable();
    hashes.dedup();
    assert_eq!(hashes.len(), count, "two of these levels have the same hash");
}

#[test]
fn names_words_and_looks_do_not() {
    for hash in [
        changed(|level| level.name = "other".into()),
        changed(|level| level.title = "Other".into()),
        changed(|level| level.metre = 60.0),
        changed(|level| level.texts.clear()),
        changed(|level| level.awards.gold = Some(9.0)),
        changed(|level| level.background = Some("background.png".into())),
        changed(|level| level.objects[0].look = Look::Ball),
        changed(|level| level.fluids[0].colour = [0; 3]),
    ] {
        assert_eq!(hash, level_hash(&full()));
    }
    let colour = |colour| changed(|level| level.objects[0].key = Some(colour));
    assert_eq!(colour([0; 3]), colour([255; 3]));
}

/// The end of one list or name is not taken for the beginning of the next.
#[test]
fn no_two_levels_have_one_encoding() {
    let zone = area(1.0, 2.0, 3.0, 4.0);
    let named = |world: &[Option<&str>], obstacles: usize| {
        changed(|level| {
            level.world =
                world.iter().map(|name| Solid { name: name.map(str::to_owned), ..Solid::new(zone, Material::ASPHALT) }).collect();
            level.obstacles = vec![zone; obstacles];
        })
    };
    let hashes = [
        named(&[Some("ab"), Some("c")], 0),
        named(&[Some("a"), Some("bc")], 0),
        named(&[Some("abc"), None], 0),
        named(&[None, Some("abc")], 0),
        named(&[None, Some("name")], 0),
        named(&[Some("name"), None], 0),
        named(&[None, None], 0),
        named(&[None], 1),
        named(&[], 2),
    ];
    for (index, hash) in hashes.iter().enumerate() {
        assert!(hash.to_string().len() == 64);
        assert!(!hashes[..index].contains(hash), "{index}");
    }
}
