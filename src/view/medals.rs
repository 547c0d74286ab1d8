//! Medals of arrows: a ring, and in it one, two or three of them that lead up, so that colour is not the only cue; for a level's
//! own mark four that lead out.

use super::theme;
use crate::draw::layout::Vec2;
use crate::draw::{Canvas, Colour};
use crate::game::{Medal, Medals, Prize};
use crate::level::Awards;

/// Between neighbours in a row, in radii.
const APART: f32 = 2.4;

fn colour(prize: Prize) -> Colour {
    match prize {
        Prize::Medal(Medal::Bronze) => Colour::hex(0xC98A4B),
        Prize::Medal(Medal::Silver) => Colour::hex(0xBCC7D1),
        Prize::Medal(Medal::Gold) => Colour::hex(0xF4C542),
        Prize::Mark => Colour::hex(0x6FD3C1),
    }
}

/// A medal around a point; one that is not earned yet is a shadow of itself.
pub fn draw(canvas: &Canvas, prize: Prize, earned: bool, centre: Vec2, radius: f32) {
    let colour = if earned { colour(prize) } else { theme::quiet().faded(0.45) };
    if earned {
        canvas.disc(centre, radius, colour.faded(0.25));
    }
    canvas.ring(centre, radius, radius * 0.2, colour);
    let up = Vec2::new(0.0, -1.0);
    let arrow = |from: Vec2, along: Vec2, size: f32| {
        let at = |forward: f32, aside: f32| centre + (from + along * forward * size + along.perp() * aside * size) * radius;
        canvas.line(at(-0.5, 0.0), at(0.1, 0.0), radius * 0.22 * size, colour);
        canvas.convex(&[at(0.6, 0.0), at(0.0, 0.42), at(0.0, -0.42)], colour);
    };
    match prize {
        Prize::Medal(Medal::Bronze) => arrow(Vec2::ZERO, up, 1.0),
        Prize::Medal(Medal::Silver) => [-0.3, 0.3].into_iter().for_each(|x| arrow(Vec2::new(x, 0.0), up, 0.75)),
        Prize::Medal(Medal::Gold) => {
            [(-0.42, 0.2), (0.0, -0.12), (0.42, 0.2)].into_iter().for_each(|(x, y)| arrow(Vec2::new(x, y), up, 0.62));
        }
        Prize::Mark => [up, -up, up.perp(), -up.perp()].into_iter().for_each(|along| arrow(along * 0.36, along, 0.5)),
    }
}

/// The medals that a level shows beside each other: the best so far, and its mark.
pub fn offered(awards: &Awards) -> usize {
    1 + usize::from(awards.mark.is_some())
}

/// The earned medals of a level, from `first` to the right.
pub fn draw_earned(canvas: &Canvas, medals: Medals, awards: &Awards, first: Vec2, radius: f32) {
    if let Some(medal) = medals.medal {
        draw(canvas, Prize::Medal(medal), true, first, radius);
    }
    if medals.mark || awards.mark.is_some() {
        draw(canvas, Prize::Mark, medals.mark, first + Vec2::new(APART * radius, 0.0), radius);
    }
}
