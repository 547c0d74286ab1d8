//! Each force of the media by its law.

use super::flown::{Acting, Flown, Row, assert_close, bounces, recorded, splash};
use resultant::physics::{BodyDef, DVec2, ForceKind};

/// The area that a body shows to a medium, times its speed u: w·|u_y| + h·|u_x| for boxes, d·|u| for round things.
fn area_times_speed(body: &BodyDef, u: DVec2) -> f64 {
    let (w, h) = (2.0 * body.half.x, 2.0 * body.half.y);
    if body.round { 0.5 * (w + h) * u.length() } else { w * u.y.abs() + h * u.x.abs() }
}

/// The liquids on an object by the laws of docs/accuracy.md: the part of it that is dry, buoyancy and viscous drag.
fn baths(flown: &Flown, object: usize, row: &Row) -> (f64, DVec2, DVec2) {
    let (body, gravity, u) = (flown.body(object), flown.level.gravity, row.velocity);
    let (mass, half, drag) = (body.mass, body.half, body.drag);
    let (mut dry, mut buoyancy, mut viscous) = (1.0, DVec2::ZERO, DVec2::ZERO);
    for fluid in &flown.level.fluids {
        let (top_left, bottom_right) = (row.position - half, row.position + half);
        let inside = (bottom_right.min(fluid.zone.max) - top_left.max(fluid.zone.min)).max(DVec2::ZERO);
        let (volume, fraction) = (inside.x * inside.y, inside.x * inside.y / (4.0 * half.x * half.y));
        if volume == 0.0 {
            continue;
        }
        dry -= fraction;
        buoyancy.y -= fluid.density * gravity * volume;
        let quadratic = 0.5 * fluid.density * drag * area_times_speed(body, u) * fraction;
        let stokes = 3.0 * std::f64::consts::PI * fluid.viscosity * (half.x + half.y) * fraction;
        let out = (fluid.zone.min.y - top_left.y) / (2.0 * half.y);
        let waves = if out > 0.0 {
            let displaced = fluid.density * volume / mass;
            let fades = 1.0 - (1.0 - out).powi(8);
            0.3 * drag * (fluid.density * gravity * inside.x * mass).sqrt() * (2.0 * displaced / (1.0 + displaced)) * fades
        } else {
            0.0
        };
        viscous -= u * (quadratic + stokes) + DVec2::new(0.0, u.y * waves);
    }
    (dry, buoyancy, viscous)
}

#[test]
fn every_row_obeys_the_laws_at_its_own_place_and_velocity() {
    let mut seen = std::collections::BTreeMap::new();
    for flown in [splash("120"), bounces(), recorded("1"), recorded("2"), recorded("3")] {
        let (level, air) = (&flown.level, flown.level.air_density);
        for (tick, object) in flown.all() {
            let (row, body) = (&flown.rows[tick][object], flown.body(object));
            let (mass, half, drag) = (body.mass, body.half, body.drag);
            let what = |kind: ForceKind| format!("{}, tick {tick}, object {object}, {}", level.name, kind.name());
            let u = row.velocity;
            let (dry, buoyancy, viscous) = baths(&flown, object, row);
            let feels_air = object > 0 || level.player.feels_air;
            let shown = area_times_speed(body, u);
            let resistance = if feels_air { -u * (0.5 * air * drag * shown * f64::max(dry, 0.0)) } else { DVec2::ZERO };
            for (kind, law) in [
                (ForceKind::Weight, DVec2::new(0.0, mass * level.gravity)),
                (ForceKind::AirResistance, resistance),
                (ForceKind::Buoyancy, buoyancy),
                (ForceKind::ViscousDrag, viscous),
            ] {
                assert_close(row.total(kind), law, 1e-11, || what(kind));
                *seen.entry(kind.name()).or_insert(0) += usize::from(law != DVec2::ZERO);
            }
            // Certainly in a stream, or certainly outside; at its very edge it depends on whether the object is leaving.
            for (index, stream) in level.streams.iter().enumerate() {
                let by = format!("stream {}", index + 1);
                let felt: Vec<&Acting> = flown.forces(tick, object).filter(|acting| acting.by == by).collect();
                let gap = (row.position - stream.zone.centre()).abs() - half - stream.zone.size() * 0.5;
                match gap.max_element() {
                    gap if gap < -1e-6 => assert_eq!(felt.len(), 1, "{}", what(ForceKind::Wind)),
                    gap if gap > 1e-6 => assert_eq!(felt.len(), 0, "{}", what(ForceKind::Wind)),
                    _ => {}
                }
                assert!(felt.iter().all(|acting| acting.vector == stream.force && acting.kind == "wind"));
                *seen.entry("Wind").or_insert(0) += felt.len();
            }
        }
    }
    assert!(seen.len() == 5 && seen.values().all(|rows| *rows > 500), "{seen:?}");
}
