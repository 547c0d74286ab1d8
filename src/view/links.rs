//! Links between bodies and places: a coil, a rope that hangs where it is slack, field lines.

use super::camera::Viewport;
use super::theme;
use crate::draw::Canvas;
use crate::draw::layout::Vec2;
use crate::game::Game;
use crate::physics::{BodyId, DVec2, Link, LinkEnd, LinkLaw};

/// Length of rope for a turn of a coil, m, and its least and most turns.
const TURN: f64 = 0.35;
const TURNS: (f64, f64) = (5.0, 24.0);
/// Width of a coil to either side, m.
const COIL: f64 = 0.22;
/// Straight parts of a curve.
const PARTS: usize = 24;
/// The force at which a link is drawn with its full width, N.
const FULL: f64 = 3000.0;
/// Field lines bend to the side by these parts of the distance.
const FIELD: [f64; 4] = [-0.28, -0.1, 0.1, 0.28];
/// Dashes of a field line that run along it in a second.
const RUN: f64 = 1.5;

/// Draws all links that act, and the open ends of those that wait for a touch. `centre` is where a body is drawn, m.
pub fn draw(game: &Game, centre: impl Fn(BodyId) -> DVec2, (view, canvas): (&Viewport, &Canvas), time: f64) {
    for link in game.world().links().iter().filter(|link| !link.is_broken()) {
        let place = |end: LinkEnd| match end {
            LinkEnd::Body(body) => centre(body),
            LinkEnd::Place(place) => place,
        };
        let [from, to] = [LinkEnd::Body(link.def().body), link.def().to].map(place);
        let colour = theme::force(link.law().kind());
        if link.acts() {
            draw_link(link, [from, to], (view, canvas), time);
        } else if link.def().hook {
            [from, to].into_iter().for_each(|end| canvas.ring(view.point(end), view.length(0.2), 1.5, colour.faded(0.6)));
        }
        if matches!(link.def().to, LinkEnd::Place(_)) {
            canvas.disc(view.point(to), view.length(0.14), colour.faded(if link.acts() { 1.0 } else { 0.4 }));
            canvas.ring(view.point(to), view.length(0.24), 1.5, theme::text().faded(0.7));
        }
    }
}

fn draw_link(link: &Link, [from, to]: [DVec2; 2], (view, canvas): (&Viewport, &Canvas), time: f64) {
    let (colour, across, distance) = (theme::force(link.law().kind()), (to - from).perp().normalize_or_zero(), from.distance(to));
    let line = |width: f64, points: &dyn Fn(f64) -> DVec2| {
        let corners: Vec<Vec2> = (0..=PARTS).map(|i| view.point(points(i as f64 / PARTS as f64))).collect();
        corners.windows(2).for_each(|pair| canvas.line(pair[0], pair[1], width as f32, colour));
    };
    match link.law() {
        LinkLaw::Spring(spring) => {
            let turns = (spring.length / TURN).clamp(TURNS.0, TURNS.1).round() as usize;
            let corner = |i: usize| {
                let side = if i == 0 || i == 2 * turns {
                    0.0
                } else if i.is_multiple_of(2) {
                    COIL
                } else {
                    -COIL
                };
                view.point(from.lerp(to, i as f64 / (2 * turns) as f64) + across * side)
            };
            (0..2 * turns).for_each(|i| canvas.line(corner(i), corner(i + 1), 2.0, colour));
        }
        LinkLaw::Rope(rope) => {
            // Half the depth of the triangle that a rope makes which hangs from its middle, and a bit less.
            let sag = 0.43 * (rope.length * rope.length - distance * distance).max(0.0).sqrt();
            let width =
                if sag > 0.0 { 1.5 } else { 2.0 + 2.0 * (rope.stiffness * (distance - rope.length) / FULL).clamp(0.0, 1.0) };
            line(width, &|part| from.lerp(to, part) + DVec2::new(0.0, 4.0 * sag * part * (1.0 - part)));
        }
        LinkLaw::Magnet(magnet) => {
            let pull = (magnet.strength.abs() / (distance * distance).max(magnet.nearest * magnet.nearest) / FULL).sqrt();
            let shown = colour.faded(pull.clamp(0.25, 0.9) as f32);
            for bend in FIELD {
                let along = |part: f64| from.lerp(to, part) + across * (4.0 * bend * distance * part * (1.0 - part));
                let shift = (time * RUN * magnet.strength.signum()).rem_euclid(1.0);
                for i in 0..PARTS / 2 {
                    let part = (i as f64 + shift) / (PARTS / 2) as f64;
                    let end = (part + 0.5 / (PARTS / 2) as f64).min(1.0);
                    canvas.line(view.point(along(part.min(1.0))), view.point(along(end)), 1.5, shown);
                }
            }
        }
    }
}
